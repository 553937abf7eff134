"""The source archive of the package: the same bits each time, and a wheel is made from what it has, without the tree."""
from __future__ import annotations

import hashlib
import os
import pathlib
import subprocess
import sys
import tarfile
import zipfile

import hawser
import pytest
from conftest import DATA, ROOT

sys.path.insert(0, str(ROOT / "python"))
import backend  # noqa: E402


@pytest.fixture(scope="module")
def archive(tmp_path_factory) -> pathlib.Path:
    if not (ROOT / ".git").exists():
        pytest.skip("no clone: there is no last commit")
    folder = tmp_path_factory.mktemp("sdist")
    return folder / backend.build_sdist(str(folder))


def test_the_same_bits(archive, tmp_path):
    again = tmp_path / backend.build_sdist(str(tmp_path))
    assert again.name == archive.name == f"hawser-{hawser.__version__}.tar.gz"
    assert hashlib.sha256(again.read_bytes()).digest() == hashlib.sha256(archive.read_bytes()).digest()


def test_a_wheel_from_the_archive_alone(archive, tmp_path):
    """By pip, as users do; it is the wheel of the build, and works. (There was no source archive for pip.)"""
    with tarfile.open(archive) as packed:
        packed.extractall(tmp_path)
    (tree,) = tmp_path.iterdir()
    assert (tree / "PKG-INFO").read_text().startswith("Metadata-Version: 2.1\nName: hawser\n") and not (tree / "tests").exists()
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("HAWSER", "PYTHONPATH"))}
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    done = subprocess.run([*pip, "wheel", "--no-index", "--no-deps", "--no-build-isolation", "-w", tmp_path / "dist", tree], cwd=tmp_path, env=clean,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    (wheel,) = (tmp_path / "dist").glob("*.whl")
    (of_build,) = pathlib.Path(os.environ["HAWSER_WHEELS"]).glob("*.whl")
    assert wheel.name == of_build.name
    assert sorted(zipfile.ZipFile(wheel).namelist()) == sorted(zipfile.ZipFile(of_build).namelist())
    subprocess.run([*pip, "install", "-q", "--no-index", "--no-deps", "--target", tmp_path / "site", wheel], check=True, env={**clean, "PIP_NO_CACHE_DIR": "1"})
    said = subprocess.run([sys.executable, "-c", f"import hawser; print(hawser.__file__, hawser.run({str(DATA / 'cli-pull.yaml')!r}).outcome)"], cwd=tmp_path,
                          env={**clean, "PYTHONPATH": str(tmp_path / "site")}, capture_output=True, text=True, check=True).stdout
    assert said.startswith(str(tmp_path)) and said.endswith(" finished\n")
