"""What pip and build call for the whole tree (pyproject.toml above): a wheel by CMake, and the source archive that it is made from.

Both need what building hawser needs (README.md), and no network.
"""
from __future__ import annotations

import gzip
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from typing import Any

TREE = pathlib.Path(__file__).resolve().parents[1]
# What a wheel is not made from.
LEFT_OUT = ("tests/", "bench/", "docs/", "cases/", "web/src/", "web/engine/", "packaging/", "scripts/", ".ci/", "python/notebooks/")
INFO = "Metadata-Version: 2.1\nName: hawser\nVersion: {version}\nSummary: Simulates how a power cable is pulled\nLicense: BSD-3-Clause\nRequires-Python: >=3.9\n"


def version() -> str:
    found = re.search(r"^project\(hawser VERSION ([0-9.]+)", (TREE / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    assert found
    return found.group(1)


def files() -> tuple[list[str], int]:
    """Of the tree, those that a wheel is made from, and the time that they get: that of the last commit, so that the archive is the same
    whenever it is made. A tree without git (an archive that was unpacked) has nothing else."""
    git = subprocess.run(["git", "-C", TREE, "ls-files", "-z"], capture_output=True, text=True) if (TREE / ".git").exists() else None
    if git and git.returncode == 0:
        names = [name for name in git.stdout.split("\0") if (TREE / name).is_file()]
        time = int(subprocess.run(["git", "-C", TREE, "log", "-1", "--format=%ct"], check=True, capture_output=True, text=True).stdout)
    else:
        names = [str(path.relative_to(TREE)) for path in TREE.rglob("*") if path.is_file() and "__pycache__" not in path.parts]
        time = int(os.environ.get("SOURCE_DATE_EPOCH", 0))
    return sorted(name for name in names if not name.startswith(LEFT_OUT) and name != "PKG-INFO"), time


def build_sdist(folder: str, config_settings: Any = None) -> str:
    """Writes hawser-VERSION.tar.gz; returns its name."""
    root, (names, time) = f"hawser-{version()}", files()
    memory = io.BytesIO()
    with tarfile.open(fileobj=memory, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in ["PKG-INFO", *names]:
            content = INFO.format(version=version()).encode() if name == "PKG-INFO" else (TREE / name).read_bytes()
            entry = tarfile.TarInfo(f"{root}/{name}")
            entry.size, entry.mtime = len(content), time
            entry.mode = 0o755 if name != "PKG-INFO" and os.access(TREE / name, os.X_OK) else 0o644
            archive.addfile(entry, io.BytesIO(content))
    with open(os.path.join(folder, f"{root}.tar.gz"), "wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=0) as packed:
        packed.write(memory.getvalue())
    return f"{root}.tar.gz"


def build_wheel(folder: str, config_settings: Any = None, metadata_directory: Any = None) -> str:
    """Builds hawser in a folder of its own and its package for this Python; returns the wheel's name."""
    with tempfile.TemporaryDirectory(prefix="hawser-") as work:
        configure = ["cmake", "-S", TREE, "-B", work, "-DCMAKE_BUILD_TYPE=Release", "-DHAWSER_TESTS=OFF", "-DHAWSER_PYTHON=ON",
                     f"-DHAWSER_PYTHON_PROGRAM={sys.executable}"]
        subprocess.run([*configure, "-GNinja"] if shutil.which("ninja") else configure, check=True)
        subprocess.run(["cmake", "--build", work, "--target", "hawser_python", "--parallel", str(os.cpu_count() or 1)], check=True)
        (wheel,) = (pathlib.Path(work) / "python" / "dist").glob("*.whl")
        shutil.copy(wheel, folder)
        return wheel.name
