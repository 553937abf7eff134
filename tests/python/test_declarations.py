"""The package speaks of the headers as they are: nothing is declared by hand, nothing new goes unnoticed."""
from __future__ import annotations

import pathlib
import re
import shutil
import sys

import hawser
import pytest
from conftest import ROOT
from hawser import _declared
from hawser._native import ffi, lib
from hawser.sample import SHAPES, Sample

sys.path.insert(0, str(ROOT / "python"))
import declarations  # noqa: E402

# Functions that the package does not call, and why.
NOT_WRAPPED = {
    "hawser_model_convert": "a file is converted by the command",
    "hawser_nearest": "difflib has it for Python",
    "hawser_desk_write": "a page for people without Python, by the command",
    "hawser_case_upgrade": "a file is rewritten by the command",
    "hawser_library_add": "a file is extended by the command",
    "hawser_limits_verdict": "hawser_verdict says the same, with the conditions",
    "hawser_verdict_word": "the text of a verdict begins with its word",
    "hawser_case_theory_shown": "what chooses tables for a terminal; Theory has them all",
    "hawser_version": "the extension is linked with this version's library, whose number _declared.VERSION has",
    "hawser_version_number": "the same, as a number",
    "hawser_machine_figure": "a dict has the figures",
    "hawser_show_figure": "the command's tables need it",
    "hawser_show_text": "texts are in SI",
    "hawser_validate": "a check of hawser itself, by the command",
    "hawser_case_spares": "for who writes files of his own beside the library's, which look themselves",
    "hawser_certificate_write": "Certificate.data is the same JSON",
    "hawser_sensitivities_write": "Theory.data is the same JSON",
    "hawser_routes_describe": "Route has the figures",
    "hawser_ranks_open": "a cluster starts the command: mpirun hawser study --mpi",
    "hawser_ranks_close": "likewise",
    "hawser_study_run_on": "likewise; hawser study --slurm",
    "hawser_study_task": "the array's tasks are the command's",
    "hawser_sim_chains": "results of each chain are in a folder of its own name, which Result reads",
    "hawser_sim_chain": "the same",
    "hawser_sim_chain_name": "the same",
}
# Members of a sample that Python has under another name.
ELSEWHERE = {"machines", "machine", "figures", "figure", "probes", "probe", "field", "pass", "held_up"}


def used() -> str:
    return "\n".join(path.read_text() for path in (ROOT / "python").rglob("*.py"))


def unwrapped(functions: list[str]) -> list[str]:
    text = used()
    return [name for name in functions if not re.search(rf"\b{name.removesuffix('_sized')}\b", text) and name not in NOT_WRAPPED]


def unshown(members: dict[str, dict[str, str]]) -> list[str]:
    """Members of a sample that nobody gets to see."""
    told = set(members["hawser_sample"]) | set(members["hawser_fields"])
    return sorted(told - ELSEWHERE - set(Sample.__annotations__))


def test_the_extension_was_made_from_these_headers():
    assert _declared.DIGEST == declarations.digest(ROOT / "include")
    assert _declared.VERSION == hawser.__version__ == ffi.string(lib.hawser_version()).decode()


def test_every_function_of_the_headers_is_declared():
    """Counted in another way: by what the headers show a reader, not by what cffi reads."""
    headers = (ROOT / "include" / "hawser").glob("*.h")
    text = "".join(path.read_text() for path in headers)
    plain = re.sub(r"/\*.*?\*/|^\s*#(?:[^\n]*\\\n)*[^\n]*$|^typedef \w+ \(\*.*?;", "", text, flags=re.S | re.M)
    shown = set(re.findall(r"\b(hawser_\w+)\(", plain))
    offered = set(re.findall(r"^#define (hawser_\w+)\(", text, re.M))
    assert set(_declared.FUNCTIONS) == shown | offered
    assert all(callable(getattr(lib, name)) for name in shown | offered)


def test_every_function_is_wrapped_or_said_not_to_be():
    assert unwrapped(_declared.FUNCTIONS) == []
    assert set(NOT_WRAPPED) <= set(_declared.FUNCTIONS)


def test_a_sample_shows_all_that_c_has():
    assert unshown(_declared.MEMBERS) == []
    assert set(SHAPES) <= set(Sample.__annotations__)
    for name in Sample.__annotations__:
        c = ffi.typeof("hawser_fields" if name in _declared.MEMBERS["hawser_fields"] else "hawser_sample")
        assert (dict(c.fields)[name].type.kind == "pointer") == (name in SHAPES), name


def test_members_bring_their_comments():
    assert "winch's direction" in (Sample.winch_force.__doc__ or "")
    assert (Sample.position.__doc__ or "").startswith("[3*segments]")


@pytest.fixture
def headers(tmp_path) -> pathlib.Path:
    return pathlib.Path(shutil.copytree(ROOT / "include", tmp_path / "include"))


def change(headers: pathlib.Path, old: str, new: str) -> None:
    """In the one header that has it, once."""
    (path,) = (path for path in (headers / "hawser").glob("*.h") if path.read_text().count(old) == 1)
    path.write_text(path.read_text().replace(old, new))


@pytest.mark.parametrize("old, new", [
    ("double winch_speed;", "float winch_speed;"),
    ("int reached;", "int reached, twice;"),
    ("HAWSER_ERR_OUTPUT = 4", "HAWSER_ERR_OUTPUT = 6"),
    ("double hawser_sim_time(const hawser_sim *s);", "float hawser_sim_time(const hawser_sim *s);"),
    ("void hawser_sim_record(hawser_sim *s);", "void hawser_sim_record(hawser_sim *s); void hawser_sim_new_thing(void);"),
])
def test_a_changed_header_is_noticed(headers, old, new):
    change(headers, old, new)
    assert declarations.digest(headers) != _declared.DIGEST


def test_a_new_function_and_a_new_member_are_noticed(headers):
    change(headers, "void hawser_sim_record(hawser_sim *s);", "void hawser_sim_record(hawser_sim *s); int hawser_sim_extra(hawser_sim *s);")
    change(headers, "double winch_speed;", "double winch_speed, winch_power;")
    assert unwrapped(declarations.functions(declarations.declarations(headers))) == ["hawser_sim_extra"]
    assert unshown(declarations.members(headers)) == ["winch_power"]


def test_a_comment_changes_nothing(headers):
    change(headers, "/* Sets one value", "/* (really) Sets one value")
    assert declarations.digest(headers) == _declared.DIGEST


def test_a_function_that_is_a_macro_is_called_like_any_other(headers):
    """As soon as a struct may grow, its size is handed over by a macro."""
    change(headers, "double hawser_sim_time(const hawser_sim *s);",
           "double hawser_sim_look_sized(const hawser_sim *s, hawser_sample *out, size_t size, double t);\n"
           "#define hawser_sim_look(s, out, t) \\\n    hawser_sim_look_sized(s, out, sizeof(hawser_sample), t)\n")
    text = declarations.declarations(headers)
    assert "double hawser_sim_look(const hawser_sim *s, hawser_sample *out, double t);" in text
    assert {"hawser_sim_look", "hawser_sim_look_sized"} <= set(declarations.functions(text))
    assert "define hawser" not in text
