"""No silent default makes a pull safe: of each case with limits every scalar that the case may leave out is left out in turn, outside
`limits` and of lists and the number of cables (without it the pull is another one); theory's verdict must not become "safe" where it was not.

Usage: check_flips.py HAWSER FOLDER...     (of *.yaml)
"""
import copy
import json
import pathlib
import subprocess
import sys

import yaml


def code(hawser, case, folder):
    """The code of the verdict pulled forward; None: the case is refused."""
    run = subprocess.run([hawser, "theory", "--format", "json", "/dev/stdin"], input=yaml.safe_dump(case), cwd=folder, capture_output=True, text=True)
    if run.returncode:
        return None
    return json.loads(run.stdout).get("verdict_code")


def scalars(node, path=()):
    """Paths of the scalars of maps, not of lists."""
    for key, value in node.items():
        if isinstance(value, dict):
            yield from scalars(value, (*path, key))
        elif not isinstance(value, list):
            yield (*path, key)


def without(case, path):
    """The case without one key, and without maps that are empty then."""
    left = copy.deepcopy(case)
    node, above = left, []
    for key in path[:-1]:
        above.append((node, key))
        node = node[key]
    del node[path[-1]]
    for upper, key in reversed(above):
        if not upper[key]:
            del upper[key]
    return left


def main(hawser, folders):
    tried = bad = cases = 0
    for path in sorted(p for folder in folders for p in pathlib.Path(folder).rglob("*.yaml")):
        try:
            case = yaml.safe_load(path.read_text())
        except (yaml.YAMLError, UnicodeDecodeError):
            continue
        if not isinstance(case, dict) or not isinstance(case.get("limits"), dict):
            continue
        was = code(hawser, case, path.parent)
        if was in (None, "safe"):
            continue
        cases += 1
        for key in scalars(case):
            if key[0] == "limits" or key[-1] == "cables":
                continue
            tried += 1
            if code(hawser, without(case, key), path.parent) == "safe":
                bad += 1
                print(f"{path.name}: {was}, without {'.'.join(map(str, key))} safe")
    print(f"{cases} cases that are not safe, {tried} keys left out, {bad} of them make one safe")
    return bad > 0 or cases == 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
