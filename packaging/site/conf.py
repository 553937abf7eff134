"""Sphinx's settings for the site (scripts/site.sh): documents by MyST, Python's reference by autodoc, C's by Doxygen and breathe."""
import os
import re

project = "hawser"
author = "the hawser authors"
release = version = os.environ["HAWSER_SITE_VERSION"]
root_doc = "README"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.viewcode", "breathe"]
myst_heading_anchors = 6  # by the names by which links of Markdown find headings
smartquotes = False
default_role = "code"  # what stands in single backticks
highlight_language = "none"
suppress_warnings = ["myst.header"]  # pages that begin with their picture
autodoc_typehints = "signature"
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "inherited-members": "NamedTuple, tuple, str, Exception, ValueError, OSError, RuntimeError", "show-inheritance": True}
python_use_unqualified_type_names = True
breathe_projects = {"hawser": os.environ["HAWSER_SITE_XML"]}
breathe_default_project = "hawser"
breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False
html_theme = "alabaster"
html_title = "hawser"
html_short_title = "hawser"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_extra_path = [os.environ["HAWSER_SITE_EXTRA"]]
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_theme_options = {"description": "Simulates how a power cable is pulled", "fixed_sidebar": False, "page_width": "76rem", "sidebar_width": "15rem",
                      "font_family": "system-ui, sans-serif", "head_font_family": "system-ui, sans-serif", "sidebar_collapse": True}

FIELD = re.compile(r"^(\w+(?:, \w+)*):\s+(\S.*)$")


def fields(app, what, name, thing, options, lines):
    """Docstrings list arguments as "name:  text", with what follows indented: as a list of fields."""
    open_list, done = False, []
    for line in lines:
        match = FIELD.match(line)
        if match and (open_list or not done or not done[-1].strip()):
            open_list = True
            done.append(f":param {match[1].replace(', ', '/')}: {match[2]}")
        elif open_list and line.strip() and line.startswith(" "):
            done.append("    " + line.strip())
        else:
            if open_list and line.strip():
                done.append("")
            open_list = False
            done.append(line)
    lines[:] = done


def setup(app):
    app.connect("autodoc-process-docstring", fields)
