"""python -m hawser: the command line (`hawser --help`), as the program that is in the wheel or, without one there, in the path."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys

from hawser._declared import VERSION


def program() -> str:
    """Where the program is. Raises FileNotFoundError, and RuntimeError if the one of the path is of another version."""
    own = pathlib.Path(__file__).with_name("bin") / "hawser"
    if own.is_file():
        return str(own)
    found = shutil.which("hawser")
    if found is None:
        raise FileNotFoundError("there is no program 'hawser' in this package or in the path")
    said = subprocess.run([found, "--version"], capture_output=True, text=True, check=True).stdout.split()
    if VERSION not in said:
        raise RuntimeError(f"{found} is {' '.join(said)}, and this package hawser {VERSION}")
    return found


def main() -> None:
    """Becomes the program, with the same arguments."""
    try:
        path = program()
    except (OSError, RuntimeError) as missing:
        sys.exit(f"hawser: {missing}")
    os.execv(path, ["hawser", *sys.argv[1:]])


if __name__ == "__main__":
    main()
