"""The wheel: what is in it, and that it works where there is nothing of the build."""
from __future__ import annotations

import json
import os
import pathlib
import re
import subprocess
import sys
import zipfile

import hawser
import pytest
from conftest import DATA, ROOT


@pytest.fixture(scope="module")
def wheel() -> pathlib.Path:
    (found,) = pathlib.Path(os.environ["HAWSER_WHEELS"]).glob("*.whl")
    return found


def test_one_wheel_for_every_python(wheel):
    assert re.fullmatch(rf"hawser-{re.escape(hawser.__version__)}-cp39-abi3-linux_\w+\.whl", wheel.name)


def test_what_is_in_it(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    modules = {f"hawser/{path.name}" for path in (ROOT / "python" / "hawser").glob("*.py*")}
    catalogue = {f"hawser/share/hawser/library/{path.name}" for path in (ROOT / "library").glob("*.yaml")}
    assert modules | catalogue | {"hawser/py.typed", "hawser/_native.abi3.so", "hawser/_declared.py"} <= names
    assert all(name.startswith(("hawser/", "hawser-")) for name in names)
    assert sum(name.endswith("/hawser/fmu.so") for name in names) == 1
    (texts,) = (name for name in names if name.endswith("/licences.txt"))  # there were none
    said = zipfile.ZipFile(wheel).read(texts).decode()
    assert "Redistribution and use in source and binary forms" in said and "KLU" in said
    # there were none: LICENSE, what is inside of the program (NOTICE), and of the library for mock-up units, which has KLU (LGPL) in it
    licences = {name.split("/")[1] for name in names if name.startswith(f"hawser-{hawser.__version__}.dist-info/")}
    assert {"LICENSE", "NOTICE"} <= licences
    for library in ("libsundials", "libsuitesparse", "libexpat1", "libyaml", "zlib1g"):
        assert f"LICENSE.{library}" in licences or not pathlib.Path(f"/usr/share/doc/{library}-dev/copyright").exists()


def test_it_works_elsewhere(wheel, tmp_path):
    """Installed into a folder, run from another, without the build in any path; with a cable of the catalogue."""
    subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--no-index", "--no-deps", "--no-compile", "--target",
                    tmp_path / "site", wheel], check=True, env={**os.environ, "PIP_NO_CACHE_DIR": "1"})
    text = ("import hawser; assert hawser.__file__.startswith(%r), hawser.__file__\n"
            "print(len(hawser.library('ropes')), hawser.run(%r).verdict.word); hawser.Case(%r).fmu('pull.fmu')")
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("HAWSER", "PYTHONPATH"))}
    said = subprocess.run([sys.executable, "-c", text % (str(tmp_path), *2 * [str(DATA / "full-library.yaml")])], cwd=tmp_path, text=True,
                          env={**clean, "PYTHONPATH": str(tmp_path / "site")}, capture_output=True, check=True).stdout.split()
    assert int(said[0]) == len(hawser.library("ropes")) and said[1] in ("SAFE", "NOT")
    assert zipfile.is_zipfile(tmp_path / "pull.fmu")
    # the command line, which was not there: "No module named hawser.__main__; 'hawser' is a package and cannot be directly executed"
    found = subprocess.run([sys.executable, "-m", "hawser", "library", "ropes", "--format", "json"], cwd=tmp_path, check=True, capture_output=True,
                           env={**clean, "PYTHONPATH": str(tmp_path / "site")}).stdout
    assert len(json.loads(found)["entries"]) == int(said[0])
    linked = subprocess.run(["ldd", tmp_path / "site" / "hawser" / "_native.abi3.so"], capture_output=True, text=True).stdout
    assert "libhawser" not in linked and "not found" not in linked
