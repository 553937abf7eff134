"""Runs one file of tests by pytest; with status 77, which CTest takes for skipped, and a sentence where a package is missing.

Usage: run.py FILE [PACKAGE...]     (packages beside those that hawser itself needs; scripts/setup.sh has their Debian names)
"""
import importlib.util
import sys

needed = ["cffi", "numpy", "pandas", "pytest", *sys.argv[2:]]
missing = [name for name in needed if importlib.util.find_spec(name) is None]
if missing:
    names = " ".join(name if name == "mypy" else f"python3-{name}" for name in missing)
    print(f"Without {names}: skipped (sh scripts/setup.sh --python installs it)")
    sys.exit(77)

import pytest  # noqa: E402

if __name__ == "__main__":  # not in a process that a test starts
    sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", sys.argv[1]]))
