"""The checks catch what they are for: each test writes a small tree with one fault and looks for the complaint."""
import os
import sys
import tempfile
import unittest

import check_causes
import check_documents
import check_equations
import check_handles
import check_includes
import check_reference
import check_sizes
import check_style

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
import architecture  # noqa: E402


class Tree:
    """A temporary tree from {path: text}."""

    def __init__(self, files):
        self.folder = tempfile.TemporaryDirectory()
        for path, text in files.items():
            full = os.path.join(self.folder.name, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)

    def complaints(self, check):
        with self.folder:
            return check(self.folder.name)


class Reference(unittest.TestCase):
    def check(self, text):
        return Tree({"include/hawser/a.h": text}).complaints(check_reference.check)

    def test_what_says_all_is_fine(self):
        self.assertEqual([], self.check("/* Reads it. Errors: INPUT. */\nhawser_status hawser_a_read(const char *path, double at_m, hawser_error *err);\n"
                                        "hawser_status hawser_a_again(const char *path, hawser_error *err);\n"
                                        "/* Where it is, s. */\ndouble hawser_a_time(const hawser_a *a);\nvoid hawser_a_free(hawser_a *a);\n"))
        self.assertEqual([], self.check("typedef struct hawser_b {\n    double t;  /* s */\n    double force_N, pull[3]; /* N */\n"
                                        "    const double *x; /* [n], m */\n} hawser_b;\n"))
        self.assertEqual([], self.check("typedef struct hawser_b {\n    const char *unit;\n    double value; /* the worst */\n} hawser_b;\n"))

    def test_what_is_missing_is_caught(self):
        for text, what in (("/* Reads it. */\nhawser_status hawser_a_read(const char *path);\n", "no 'Errors:'"),
                           ("\nhawser_status hawser_a_read(const char *path);\n", "no comment"),
                           ("/* How long it is. */\n\nint hawser_a_count(const hawser_a *a);\n", "no comment"),
                           ("/* The length. */\ndouble hawser_a_length(const hawser_a *a);\n", "no unit of what it returns"),
                           ("/* Errors: INPUT. */\nhawser_status hawser_a_go(hawser_a *a, double far);\n", "no unit of far"),
                           ("typedef struct hawser_b {\n    double pull; /* the largest */\n} hawser_b;\n", "hawser_b.pull: no unit"),
                           ("typedef struct hawser_b {\n    const double *x; /* m */\n} hawser_b;\n", "hawser_b.x: no shape")):
            self.assertIn(what, " ".join(self.check(text)), text)


class PythonReference(unittest.TestCase):
    def check(self, text):
        return Tree({"python/hawser/__init__.py": '__all__ = ["at"]\n', "python/hawser/a.py": text}).complaints(check_reference.check)

    def test_what_says_all_is_fine(self):
        self.assertEqual([], self.check('def at(s: float) -> dict[str, Array]:\n    """The place s (m): [..., 3]. ValueError: off."""\n    raise ValueError("off")\n'))
        self.assertEqual([], self.check("def _own(s: float) -> float:\n    return s\n"))

    def test_what_is_missing_is_caught(self):
        for text, what in (("def at():\n    pass\n", "no docstring"),
                           ('def at() -> float:\n    """How long it is."""\n', "no unit of what it returns"),
                           ('def at(far: float):\n    """Goes there."""\n', "no unit of far"),
                           ('def at() -> Array:\n    """All places, m."""\n', "no shape"),
                           ('def at():\n    """Goes on."""\n    raise ValueError("no")\n', "ValueError is not named"),
                           ('def at():\n    """Goes on."""\n    check(lib.x(), error)\n', "no error is named"),
                           ("class at:\n    def size(self):\n        pass\n", "at.size: no docstring")):
            self.assertIn(what, " ".join(self.check(text)), text)


class Includes(unittest.TestCase):
    def check(self, files):
        return Tree(files).complaints(check_includes.check)

    def test_downward_is_fine(self):
        self.assertEqual([], self.check({"core/a.h": "#include <math.h>\n", "contact/b.c": '#include "core/a.h"\n',
                                         "include/hawser/hawser.h": "", "cli/main.c": "#include <hawser/hawser.h>\n",
                                         "linsolve/l.c": "#include <klu.h>\n", "sim/solve/s.c": "#include <cvode/cvode.h>\n",
                                         "core/e.h": '#include "hawser/hawser.h"\n'}))

    def test_upward(self):
        found = self.check({"core/a.c": '#include "sim/run/sim.h"\n', "sim/run/sim.h": ""})
        self.assertEqual(1, len(found))
        self.assertIn("core/a.c:1", found[0])

    def test_upward_within_a_level(self):
        self.assertTrue(self.check({"theory/a.c": '#include "sim/run/sim.h"\n', "sim/run/sim.h": ""}))
        self.assertTrue(self.check({"sim/a.c": '#include "io/api/io.h"\n', "io/api/io.h": ""}))

    def test_sideways(self):
        self.assertTrue(self.check({"contact/a.c": '#include "linsolve/l.h"\n', "linsolve/l.h": ""}))
        self.assertTrue(self.check({"linsolve/a.c": '#include "contact/c.h"\n', "contact/c.h": ""}))

    def test_downward_within_a_folder(self):
        self.assertEqual([], self.check({"sim/equipment/a.c": '#include "sim/b.h"\n', "sim/b.h": "",
                                         "sim/run/c.c": '#include "sim/a.h"\n', "sim/a.h": '#include "sim/e.h"\n',
                                         "sim/e.h": "", "io/api/d.c": '#include "io/case/y.h"\n', "io/case/y.h": ""}))

    def test_upward_within_a_folder(self):
        found = self.check({"sim/b.c": '#include "sim/equipment/a.h"\n', "sim/equipment/a.h": '#include "sim/solve/s.h"\n',
                            "sim/solve/s.h": ""})
        self.assertEqual(["sim/b.c:1", "sim/equipment/a.h:1"], [c.split(": ")[0] for c in found])

    def test_a_folder_that_is_not_in_the_list(self):
        found = self.check({"sim/odd/a.c": ""})
        self.assertEqual(["sim/odd/a.c: its folder is not in the list of docs/architecture.md"], found)

    def test_cli_sees_the_public_header_only(self):
        self.assertTrue(self.check({"cli/main.c": '#include "core/a.h"\n', "core/a.h": ""}))
        self.assertTrue(self.check({"cli/main.c": "#include <jansson.h>\n"}))

    def test_circle(self):
        found = self.check({"core/a.h": '#include "core/b.h"\n', "core/b.h": '#include "core/c.h"\n',
                            "core/c.h": '#include "core/a.h"\n'})
        self.assertEqual(["circle: core/a -> core/b -> core/c -> core/a"], found)

    def test_circle_of_a_source_and_its_header(self):
        found = self.check({"core/a.h": "", "core/a.c": '#include "core/b.h"\n', "core/b.h": '#include "core/a.h"\n'})
        self.assertEqual(["circle: core/a -> core/b -> core/a"], found)

    def test_path_not_from_the_root(self):
        self.assertTrue(self.check({"core/a.c": '#include "b.h"\n', "core/b.h": ""}))

    def test_libraries_out_of_place(self):
        for path, name in [("core/a.c", "cvode/cvode.h"), ("linsolve/klu.c", "sundials/sundials_types.h"),
                           ("sim/a.c", "klu.h"), ("sim/a.c", "metis.h"), ("contact/law/a.c", "lapacke.h"),
                           ("sim/a.c", "yaml.h"), ("theory/a.c", "nvector/nvector_serial.h"),
                           ("sim/run/a.c", "cvode/cvode.h")]:
            self.assertEqual(1, len(self.check({path: f"#include <{name}>\n"})), (path, name))


class Handles(unittest.TestCase):
    HEADER = {"include/hawser/hawser.h": "typedef struct hawser_sim hawser_sim;\nint hawser_sim_count(const hawser_sim *s, int *n);\n"}

    def check(self, source):
        return Tree({**self.HEADER, "io/a.c": source}).complaints(check_handles.check)

    def test_one_that_asks_is_fine(self):
        self.assertEqual([], self.check("int hawser_sim_count(const hawser_sim *s, int *n)\n{\n    s = SHOWN(s);\n    return *n;\n}\n"))
        self.assertEqual([], self.check("int hawser_sim_count(const Sim *s, int *n) { return s ? SHOWN(s)->n : 0; }\n"))

    def test_one_that_does_not_is_caught(self):
        said = self.check("int hawser_sim_count(const hawser_sim *handle, int *n)\n{\n    return handle->n; /* SHOWN(handle) */\n}\n")
        self.assertIn("without SHOWN(handle)", said[0])
        self.assertIn("not found", self.check("int other(void) { return 1; }\n")[0])


class Equations(unittest.TestCase):
    MODEL = "# Bushing\n```\nd = x - y        (B1)\n```\nIt follows (B1) that\n- (C2) f = 0\n"
    INDEX = "# The model\n| [bushing](theory/20-bushing.md) | B, C |\n"

    def check(self, code, model=MODEL, index=INDEX):
        return Tree({"docs/theory.md": index, "docs/theory/20-bushing.md": model, "core/a.c": code}).complaints(
            check_equations.check)

    def test_cited_and_given(self):
        self.assertEqual([], self.check('/* docs/theory.md, "Bushing", (B1) and (C2) */ int f(void);\n'))

    def test_cited_but_not_given(self):
        self.assertEqual(["core/a.c:2: (B2) is not in docs/theory.md"], self.check("\n/* by (B2) */\n"))

    def test_code_is_no_citation(self):
        self.assertEqual([], self.check("int x = (B2);\n"))

    def test_given_twice(self):
        self.assertTrue(self.check("", self.MODEL + "z = 1    (B1)\n"))

    def test_missing_section(self):
        self.assertTrue(self.check('/* docs/theory.md, "Cable" */\n'))

    def test_the_index_names_chapters_and_letters(self):
        self.assertEqual(["docs/theory.md: wants a row for docs/theory/20-bushing.md with the letters: B, C"],
                         self.check("", index="# The model\n| [bushing](theory/20-bushing.md) | B |\n"))
        self.assertEqual(1, len(self.check("", index="# The model\n")))
        self.assertEqual(1, len(self.check("", index=self.INDEX + "| [cable](theory/30-cable.md) | C |\n")))


class Documents(unittest.TestCase):
    def check(self, text):
        return Tree({"README.md": "", "docs/a.md": text, "docs/b.md": "", "core/a.c": "", "core/a.h": "",
                     "cases/one.yaml": ""}).complaints(check_documents.check)

    def test_what_is_there(self):
        self.assertEqual([], self.check("# A `part`, twice\n## Two\n## Two\n"
                                        "[b](b.md) ![top](../README.md) [far](https://a.b/c.md#x) [here](#a-part-twice) [again](a.md#two-1)\n"
                                        "`core/` `core/a.c` `core/a.{c,h}` `cases/NAME.yaml` `core/*.h` `sim` `a/b.c`\n"))

    def test_what_is_not(self):
        self.assertEqual(["docs/a.md:2: links to c.md, which is not there"], self.check("\n[c](c.md)\n"))
        self.assertEqual(["docs/a.md:1: names core/b.c, which is not there"], self.check("`core/b.c`"))
        self.assertEqual(1, len(self.check("`core/a.{c,cc}`")))

    def test_headings_that_are_not(self):
        self.assertEqual(["docs/a.md:3: links to #two, which is not there", "docs/a.md:4: links to b.md#one, which is not there"],
                         self.check("# One\n\n[c](#two)\n[d](b.md#one)\n```\n# Two\n```\n"))


    def test_sections_that_comments_cite(self):
        found = Tree({"docs/a.md": "# One `x`\n## Two (and more)\n", "core/a.c": '/* docs/a.md, "Two"; docs/a.md,\n * "One x". */\n',
                      "core/b.c": '/* docs/a.md, "Three". */\n'}).complaints(check_documents.check)
        self.assertEqual(['core/b.c:1: cites docs/a.md, "Three", which is not there'], found)


class Style(unittest.TestCase):
    def check(self, path, text):
        return Tree({path: text}).complaints(check_style.check)

    def test_pages_by_hand(self):
        long = "Word " * 31 + "end.\n"
        self.assertEqual([], self.check("docs/theory/a.md", "A short sentence.\n"))
        self.assertIn("a sentence of 32 words", self.check("docs/theory/a.md", long)[0])
        self.assertEqual([], self.check("docs/reference/columns.md", f"# Columns\n\nThis page is made from tables.\n\n## A\n\n{long}"))

    def test_words_that_count(self):
        texts = {"README.md": "one two\n<!-- t: begin -->\n\n| 3 |\n\n<!-- t: end -->\n", "docs/a.md": "1 2 3", "docs/glossary.md": "4", "SECURITY.md": "5"}
        self.assertEqual([(3, "docs/a.md"), (2, "README.md")], check_style.counted(texts))
        self.assertEqual([], check_style.check_words([(check_style.WORDS, "docs/a.md")]))
        self.assertEqual(1, len(check_style.check_words([(check_style.WORDS, "docs/a.md"), (1, "README.md")])))

    def test_terms(self):
        self.assertIn("write given", self.check("bench/README.md", "The program is told a length.\n")[0])


class Causes(unittest.TestCase):
    def check(self, rows):
        return Tree({"tests/io/test_trust.c": f"/* Was wrong:\n{rows} */\nTEST(it_falls) {{ it_stands(); }}\n",
                     "tests/cli/test_a.sh": ""}).complaints(check_causes.complaints)

    def test_what_is_run(self):
        self.assertEqual([], self.check(f" *   {'a fall':47} here, it_falls; cli/test_a.sh: always\n"))

    def test_what_is_not(self):
        self.assertEqual(["tests/io/test_trust.c: 'a fall': tests/io/test_trust.c runs no test it_stands"],
                         self.check(f" *   {'a fall':47} here, it_falls, it_stands\n"))
        self.assertEqual(["tests/io/test_trust.c: 'a fall': there is no tests/io/test_b.c"], self.check(f" *   {'a fall':47} io/test_b, it_falls\n"))
        self.assertEqual(1, len(self.check("")))


class Architecture(unittest.TestCase):
    TABLE = "| `sim/` | scene |\n| `sim/belt/` | belts |\n| `core/` | chain |\n"

    def tree(self, table=TABLE, belt='#include "core/a.h"\n'):
        return Tree({"docs/architecture.md": table, "docs/img/architecture.svg": "", "core/a.h": "",
                     "sim/s.c": '#include "sim/belt/b.h"\n', "sim/belt/b.h": belt})

    def test_a_picture_is_drawn_and_then_held(self):
        tree = self.tree()
        self.assertEqual(1, len(architecture.check(tree.folder.name, False)))
        self.assertEqual([], architecture.check(tree.folder.name, True))
        self.assertEqual([], architecture.check(tree.folder.name, False))
        with open(os.path.join(tree.folder.name, "docs/img/architecture.svg"), encoding="utf-8") as file:
            picture = file.read()
        self.assertEqual((3, 1), (picture.count('class="box"'), picture.count('class="arrow"')))
        tree.folder.cleanup()

    def test_the_table_is_the_trees(self):
        self.assertEqual(["docs/architecture.md: sim/belt/ is missing from the table"],
                         self.tree("| `sim/` | scene |\n| `core/` | chain |\n").complaints(lambda r: architecture.check(r, False)))
        self.assertEqual(["docs/architecture.md: sim/drum/ is not a folder with sources"],
                         self.tree(self.TABLE + "| `sim/drum/` | drums |\n").complaints(lambda r: architecture.check(r, False)))

    def test_includes_go_down_the_table(self):
        self.assertEqual(["docs/architecture.md: sim/belt/ includes sim/, which the table has above it"],
                         self.tree(belt='#include "sim/s.h"\n').complaints(lambda r: architecture.check(r, False)))


class Sizes(unittest.TestCase):
    def check(self, text, path="core/a.c"):
        return Tree({path: text}).complaints(check_sizes.check)

    def test_long_function(self):
        def body(lines):
            return "static int f(int a)\n{\n" + "    a++;\n" * (lines - 2) + "}\n"
        self.assertEqual([], self.check(body(120)))
        self.assertEqual(1, len(self.check(body(121))))


if __name__ == "__main__":
    unittest.main()
