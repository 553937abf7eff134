"""What the tests of the Python package share."""
from __future__ import annotations

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "tests" / "data"


@pytest.fixture
def pull() -> str:
    """A pull of two seconds, computed in some milliseconds."""
    return str(DATA / "cli-pull.yaml")


@pytest.fixture
def program() -> str:
    """The command `hawser` of the same build."""
    return os.environ["HAWSER_PROGRAM"]


@pytest.fixture
def by_command(program, tmp_path):
    """Runs a case by the command: its folder of results."""
    def run(case: str, *arguments: str) -> pathlib.Path:
        folder = tmp_path / "by-command"
        subprocess.run([program, "run", case, "-q", "-o", folder, *arguments], check=True)
        return folder

    return run
