#!/usr/bin/env python3
"""What `hawser schema` prints: all cases, studies, jobs and summaries are allowed by it, and mistakes are not.

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


# Of a study and a job: what is wrong, and the place of the error.
STUDY = """
case: tunnel.yaml
parameters: {friction.mu: {uniform: {from: 0.1, to: 0.2}}, step: {key: surfaces.ducts.0.radius, steps: {from: 80 mm, to: 90 mm, count: 3}}}
monte-carlo: {samples: 100}
"""
STUDY_WRONG = (
    ("case:", "base:", ""),
    ("samples: 100", "samples: many", "monte-carlo/samples"),
    ("uniform:", "unifrom:", "parameters/friction.mu"),
    ("count: 3", "count: 1", "parameters/step/steps/count"),
)
JOB = "pulls: [{name: a, case: a.yaml, direction: forward}]\nreels: [{name: r, length: 500 m}]\n"
JOB_WRONG = (
    ("pulls:", "pull:", ""),
    ("forward", "foreward", "pulls/0/direction"),
    ("length: 500 m", "tare: 1 t", "reels/0"),
    ("500 m", "-5", "reels/0/length"),
)
# Runs whose summaries hold most of the tables: a pull with machines, a rod, ducts, passes, a bundle.
RUNS = ("cases/capstan.yaml", "cases/rod-cantilever.yaml", "cases/reel.yaml", "tests/data/passing-guides.yaml", "tests/data/trust-slack.yaml")


def validator_of(hawser, of):
    schema = json.loads(subprocess.run([hawser, "schema", of, "--json"], capture_output=True, text=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def check_mistakes(validator, text, wrongs):
    """How many of the mistakes the schema does not find at their places."""
    failed = 0
    assert validator.is_valid(yaml.load(text, Loader)), list(validator.iter_errors(yaml.load(text, Loader)))
    for right, wrong, place in wrongs:
        other = text.replace(right, wrong)
        assert other != text, wrong
        places = ["/".join(map(str, e.absolute_path)) for e in validator.iter_errors(yaml.load(other, Loader))]
        if place not in places:
            failed += 1
            print(f"{wrong}: expected an error at '{place}', found {places}")
    return failed


def check_others(hawser, folders):
    """Studies, jobs and summaries: all of the project's are allowed, mistakes are not."""
    failed = check_mistakes(validator_of(hawser, "study"), STUDY, STUDY_WRONG)
    failed += check_mistakes(validator_of(hawser, "job"), JOB, JOB_WRONG)
    found = {"study": 0, "job": 0, "summary": 0}

    def check(of, path, value):
        errors = list(validator_of(hawser, of).iter_errors(value))
        found[of] += 1
        for error in errors[:5]:
            print(f"{path}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")
        return len(errors)

    for path in sorted(p for folder in folders for p in pathlib.Path(folder).rglob("*.yaml")):
        value = yaml.load(path.read_text("utf-8-sig"), Loader)
        if isinstance(value, dict) and "pulls" in value:
            failed += check("job", path, value)
        elif isinstance(value, dict) and "case" in value:
            failed += check("study", path, value)
    source = pathlib.Path(folders[0]).parent
    with tempfile.TemporaryDirectory() as folder:
        for case in RUNS:
            text = subprocess.run([hawser, "run", source / case, "-o", folder, "--format", "json"], capture_output=True, text=True, check=True).stdout
            failed += check("summary", case, json.loads(text))
    wrong = json.loads(text)
    wrong["segments"] = "many"
    del wrong["verdict"]
    assert len(list(validator_of(hawser, "summary").iter_errors(wrong))) == 2
    assert found["study"] >= 5 and found["job"] >= 1, found
    print(f"{found}, {failed} errors")
    return failed


def below(schema, node, part):
    """The schemas of a key or item below one; {}: anything may be there."""
    if "$ref" in node:
        yield from below(schema, schema["$defs"][node["$ref"].split("/")[-1]], part)
    for other in node.get("anyOf", ()):
        yield from below(schema, other, part)
    of = node.get("properties", {})
    if part in of:
        yield of[part]
    elif isinstance(node.get("additionalProperties"), dict):
        yield node["additionalProperties"]
    elif node.get("type") == "object" and not of and "$ref" not in node:
        yield {}
    if "items" in node:
        yield node["items"]  # by number or name
    elif "list" in of:
        yield from below(schema, of["list"], part)


def check_documents(schema, docs):
    """Dotted keys in the documents exist; `output.loads_of` was named, and refused."""
    failed = 0
    assert not list(below(schema, schema["properties"]["output"], "loads_of"))
    for path in sorted(docs.rglob("*.md")):
        for word in sorted(set(re.findall(r"`([a-z_]+(?:\.[A-Za-z_0-9-]+)+)`", path.read_text("utf-8")))):
            parts = word.split(".")
            other = path.name in ("fmi.md", "results.md", "columns.md") or parts[-1] in ("yaml", "h5", "csv", "json", "h", "margin")
            if other or parts[0] not in schema["properties"]:
                continue  # a variable of a unit, a path into an answer, a file
            nodes = [schema]
            for part in parts:
                nodes = [found for node in nodes for found in below(schema, node, part)]
            if not nodes:
                failed += 1
                print(f"{path}: no key {word}")
    return failed


def main(hawser, *folders):
    validator = validator_of(hawser, "case")
    schema = validator.schema
    failed = check_others(hawser, folders) + check_documents(schema, pathlib.Path(folders[0]).parent / "docs")
    cases = 0
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
