#!/usr/bin/env python3
"""What `hawser schema` prints: all cases are allowed by it, and what the program refuses by its tables is not.

Usage: check_schema.py HAWSER FOLDER...  (all cases below the folders)
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(missing)
    sys.exit(77)


class Loader(yaml.SafeLoader):
    """YAML 1.2, as editors read it: "on" is a text."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
    ("bool", r"^(true|false)$", "tf"),
    ("int", r"^[-+]?[0-9]+$", "-+0123456789"),
    ("float", r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$", "-+0123456789."),
):
    Loader.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), list(first))

CASE = """
cables: {c: {d: 100 mm, mass: 20 kg/m}}
route: {pieces: [{straight: 50 m}, {bend: 90 deg, radius: 5 m, plane: left}]}
surfaces: {ducts: [{radius: 80 mm, friction: {mu: 0.3}}]}
limits: {pull: 20 kN, code: iec}
"""
# What is wrong, and the place of the error.
WRONG = (
    ("mass:", "weight:", "cables/c"),
    ("d: 100 mm", "d: thick", "cables/c/d"),
    ("d: 100 mm", "d: 5000", "cables/c/d"),
    ("d: 100 mm", "d: -1", "cables/c/d"),
    ("[{straight: 50 m}, {bend: 90 deg, radius: 5 m, plane: left}]", "50 m", "route/pieces"),
    ("90 deg", "90", "route/pieces/1/bend"),
    ("mu: 0.3", "mu: 30", "surfaces/ducts/0/friction/mu"),
    ("{mu: 0.3}", "0.3", "surfaces/ducts/0/friction"),
    ("code: iec", "code: eic", "limits/code"),
    ("limits:", "limit:", ""),
    ("cables:", "cable:", ""),
)


def refused(hawser, text):
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write(text)
        file.flush()
        return subprocess.run([hawser, "check", file.name], capture_output=True, text=True, check=False).returncode == 2


def main(hawser, *folders):
    schema = json.loads(subprocess.run([hawser, "schema"], capture_output=True, text=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    failed = cases = 0
    for path in sorted(p for folder in folders for p in pathlib.Path(folder).rglob("*.yaml")):
        case = yaml.load(path.read_text("utf-8-sig"), Loader)
        if not isinstance(case, dict) or "study" in case or not {"cables", "include"} & set(case):
            continue
        cases += 1
        for error in validator.iter_errors(case):
            failed += 1
            print(f"{path}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")
    assert cases > 100, cases
    # What an editor shows: the meaning of a key, behind it the range of a number or the form of another value.
    for key, begins, ends in (("cables.NAME/mass", "Mass per length.", "(above 0 kg/m, at most 1e6 kg/m)"),
                              ("/gravity", "One number acts straight down", "(an acceleration downward, or [x, y, z])"),
                              ("/reel", "What the cable comes from.", "(section `reel`)")):
        section, name = key.split("/")
        text = (schema["$defs"][section] if section else schema)["properties"][name]["description"]
        assert text.startswith(begins) and text.endswith(ends), text
    assert validator.is_valid(yaml.load(CASE, Loader)) and not refused(hawser, CASE)
    for right, wrong, place in WRONG:
        text = CASE.replace(right, wrong)
        assert text != CASE, wrong
        assert refused(hawser, text), wrong
        places = ["/".join(map(str, e.absolute_path)) for e in validator.iter_errors(yaml.load(text, Loader))]
        if place not in places:
            failed += 1
            print(f"{wrong}: expected an error at '{place}', found {places}")
    print(f"{cases} cases and {len(WRONG)} mistakes, {failed} of them wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
