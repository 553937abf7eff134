"""Type hints: the package holds to them strictly, and users' programs get to see them."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

import hawser
from conftest import ROOT

HERE = pathlib.Path(__file__).parent
WRONG = """import hawser
x: int = hawser.run('case.yaml').verdict
hawser.Simulation('case.yaml').advance('1 s')
"""


def test_the_package_and_programs_of_users(tmp_path):
    """Once for all of it: mypy reads numpy's types every time. Nothing is wrong but what is meant to be."""
    wrong = tmp_path / "wrong.py"
    wrong.write_text(WRONG)
    modules = [str(path) for path in sorted((ROOT / "python" / "hawser").glob("[!_]*.py"))]
    said = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", os.environ["HAWSER_MYPY_CACHE"], *modules,
                           str(HERE / "typed_use.py"), str(wrong)],
                          cwd=ROOT / "python", env={**os.environ, "MYPYPATH": ""}, capture_output=True, text=True).stdout
    *errors, last = said.splitlines()
    assert [error.split(": error: ")[0] for error in errors] == [f"{wrong}:2", f"{wrong}:3"], said
    assert 'expression has type "Verdict"' in errors[0] and 'incompatible type "str"; expected "float"' in errors[1]
    assert last.startswith("Found 2 errors in 1 file")


def test_every_public_name_has_a_docstring():
    for name in hawser.__all__:
        thing = getattr(hawser, name)
        if name.startswith("__"):
            continue
        assert thing.__doc__, name
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property) or hasattr(value, "func")):
                plain_count = name == "Sample" and member in ("rollers", "surfaces", "max_tension_joint", "active_contacts")
                assert plain_count or value.__doc__ or getattr(value, "func", value).__doc__, f"{name}.{member}"
