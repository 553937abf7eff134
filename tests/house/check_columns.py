"""Columns, keys and sets of results are described once, in the program's tables. This check writes docs/reference/columns.md from
them, the types of the page's data (web/src/columns.ts) and Python's descriptions (python/hawser/_columns.py).

Usage: check_columns.py ROOT [--update]     (--update: writes them)
The comment above a row describes the column; without comments the heading of the column in printed tables does. A row with neither
shares the description of the row before it.
"""
import os
import re
import sys

import tree

TABLES = "io/results/tables.c"
SUMMARY = "io/results/summary_json.c"
SERIES, SETS = "io/results/results_file.c", "io/results/states_data.c"
THEORY, MACHINES = "io/api/theory_tables.c", ("sim/solve/chains.c", "sim/equipment/conveyor.c")
ANSWER, CERTIFICATE, SLOPES = "io/api/api_theory.c", "io/api/api_certify.c", "study/sensitivities.c"
TABLE = re.compile(r"^static const Column (\w+)_column\[\] = \{(.*?)^\};", re.M | re.S)
ROW = re.compile(r'(?:/\*((?:(?!\*/).)*)\*/\s*)?\{\s*(?:COLUMN|LIST|TERMS)?\(?(?:\.key = )?"([^"]*)"([^{}]*)\}', re.S)
KIND = re.compile(r"^, (NUMBER|COUNT|LONG|TEXT|CHARS|FLAG|VECTOR)\b|\.kind = COLUMN_(\w+)")
OF = re.compile(r", (\w+)_columns\)|\.of = &(\w+)_columns")
FACT = re.compile(r'(?:/\*((?:(?!\*/).)*)\*/\s*)?(?:fact\[n\+\+\] =\s*\(Fact\))?\{"(\w+)", (?:"([^"]*)"|NULL), "([^"]*)",\s*cell_', re.S)
LABEL = re.compile(r'\.label = "([^"]*)"')
UNITS = (("_v_s", ""), ("_kg_per_m", "kg/m"), ("_N_per_m", "N/m"), ("_m_per_s", "m/s"), ("_rad_per_s", "rad/s"), ("_per_m", "1/m"), ("_N_m2", "N m2"),
         ("_N_m", "N m"), ("_N_s", "N s"), ("_per_s2", "1/s2"), ("_per_s", "1/s"), ("_rad", "rad"), ("_deg", "deg"), ("_Hz", "Hz"),
         ("_pct_paper", "%"), ("_pct", "%"), ("_N", "N"), ("_J", "J"), ("_W", "W"), ("_m", "m"), ("_s", "s"))
DOCUMENT, SCRIPT, PYTHON = "docs/reference/columns.md", "web/src/columns.ts", "python/hawser/_columns.py"
FILES = {"station": "stations.csv", "roller": "rollers.csv", "input": "inputs.csv", "route": "route.csv",
         "place": "positions.csv", "shape": "modes.csv"}
HEAD = """# Columns, keys and sets

Every column, key and set of results. [Results](results.md) describes the files and how to read them.
This page is made from the program's tables by `tests/house/check_columns.py`.
"""
SETS_HEAD = """
T states, N segments, N+1 joints, R rollers; n items of a group, in the case's order.
"""
INTERFACES = {"limit": "LimitRow", "condition": "Trust", "event": "EventRow", "assumption": "Assumption",
              "bar": "ErrorBar", "pass": "Pass", "passes": "Passes"}
TYPES = {"NUMBER": "Value", "COUNT": "number", "LONG": "number", "TEXT": "string", "CHARS": "string",
         "FLAG": "boolean | null", "VECTOR": "Point"}


def one_line(text):
    return re.sub(r"\s*\n\s*\*?\s*", " ", text).strip()


def label_of(row):
    found = LABEL.search(row)
    return re.sub(r", [^ ,]+$", "", found.group(1)) if found else ""


def tables(root, path):
    """{table: [(key, kind or the table of its rows, what it is)]}, of one file."""
    found = {}
    for table in TABLE.finditer(tree.read(root, path)):
        rows = found[table.group(1)] = []
        for comment, key, rest in ROW.findall(table.group(2)):
            kind, of = KIND.search(rest), OF.search(rest)
            rows.append((key, of.group(1) or of.group(2) if of else kind.group(1) or kind.group(2) if kind else "NUMBER",
                         one_line(comment) or label_of(rest)))
    return found


def unit_of(key):
    return next((unit for end, unit in UNITS if key.endswith(end)), "")


def document(rows, first="column"):
    """A table of the document, of (key, unit, meaning); rows that share a unit and a meaning share a line."""
    lines = []
    for key, unit, meaning in rows:
        if not meaning and lines and lines[-1][1] == unit:
            lines[-1][0].append(key)
        else:
            lines.append(([key], unit, meaning or lines[-1][2]))
    text = f"| {first} | unit | meaning |\n|---|---|---|\n"
    for keys, unit, meaning in lines:
        text += f"| {', '.join(f'`{key}`' for key in keys)} | {unit + ' ' if unit else ''}| {meaning} |\n"
    return text


def columns(rows, first="column"):
    return document([(key, unit_of(key), meaning) for key, _, meaning in rows], first)


def facts(root, path):
    """What a document has besides its tables: the comment above a fact describes it, or else its label."""
    return document([(key, unit, one_line(comment) or label) for comment, key, label, unit in FACT.findall(tree.read(root, path))], "fact")


def machines(root):
    """[(list, columns of series.csv, figures)], both as columns."""
    kinds = []
    for path in MACHINES:
        for kind in re.findall(r"MachineKind \w+ = \{(.*?)^    \.figures", tree.read(root, path), re.M | re.S):
            now, figure = (re.search(rf"\.{name} = \{{(.*?)\}}", kind, re.S).group(1) for name in ("now", "figure"))
            rows = [[(key, "NUMBER", one_line(text)) for text, key in re.findall(r'/\*(.*?)\*/\s*"(\w+)"', part, re.S)] for part in (now, figure)]
            kinds.append((re.search(r'\.key = "(\w+)"', kind).group(1), *rows))
    return kinds


def samples(root):
    """Rows of the samples: (name in series.csv, meaning there, set, unit, meaning, per, width, single), as texts; "" where there is none."""
    body = re.search(r"SampleColumn sample_column\[\] = \{(.*?)^\};", tree.read(root, SERIES), re.M | re.S).group(1)
    for comment, name, rest in re.findall(r'(?:/\*((?:(?!\*/).)*)\*/\s*)?\{("[^"]*"|NULL), (.*?)\},?\n', body, re.S):
        def get(pattern):
            found = re.search(pattern, rest, re.S)
            return re.sub(r'"\s*"', "", found.group(1)) if found else ""
        yield (name.strip('"') if name != "NULL" else "", one_line(comment), get(r'\.set = "(\w+)"'), get(r'\.unit = "([^"]*)"'),
               get(r'\.about = "((?:[^"]|"\s*")*)"'), get(r"\.per = PER_(\w+)"), get(r"\.width = (\d)"), get(r"\.single = (1)"),
               "K" if "OF_SEGMENT" in rest else "NAME")


def series(root):
    rows = []
    for name, meaning, *_, item in samples(root):
        if name == "*":
            rows += [(f"NAME_{key}", unit_of(key), text) for _, now, _ in machines(root) for key, _, text in now]
        elif name:
            axes = "xyz" if "@" in name else " "
            rows += [(key, unit_of(key), meaning if k == 0 else "")
                     for k, key in enumerate(name.replace("*", item).replace("@", axis) for axis in axes)]
    return document(rows)


def sets(root):
    items = {"": "T", "SEGMENT": "T x N", "JOINT": "T x (N+1)", "ROLLER": "T x R"}
    rows = [(f"`{name}`", items[per] + (f" x {width}" if width else ""), unit, about + ("; single precision" if single else ""))
            for _, _, name, unit, about, per, width, single, _ in samples(root) if name]
    groups, source = {"": rows}, tree.read(root, SETS)
    for table, body in re.findall(r"^const FixedSet (\w+)\[\] = \{(.*?)^\};", source, re.M | re.S):
        for path, kind, width, unit, about in re.findall(
                r'\{"([^"]+)", FIXED_(\w+), \w+\([^()]*\), (\d), "([^"]*)",\s*"((?:[^"]|"\s*")*)"(?:,\s*"\w+")?\}', body):
            group, name = ("/" + path if table != "surface_set" else "/geometry/surfaces/K/" + path).rsplit("/", 1)
            shape = "n" + (" x 64" if kind == "NAME" else f" x {width}" if width != "0" else "")
            groups.setdefault(group[1:], []).append((f"`{name}`", shape, unit, re.sub(r'"\s*"', "", about)))
    text = SETS_HEAD
    for group, rows in groups.items():
        text += (f"\n### `{group}`\n" if group else "") + "\n| set | shape | unit | meaning |\n|---|---|---|---|\n"
        text += "".join(f"| {name} | {shape} | {unit + ' ' if unit else ''}| {about} |\n" for name, shape, unit, about in rows)
    return text


def keys(root, found, table, path, done):
    """The keys of an object of summary.json, then those of the objects within it."""
    rows = found[table]
    text = (f"\n### `{path}`\n" if path else "") + "\n" + columns(rows, "key")
    for key, kind, _ in rows:
        if kind in found and kind not in done:
            done.add(kind)
            text += keys(root, found, kind, f"{path + '.' if path else ''}{key}", done)
    return text


def page(root, found, summary):
    text = HEAD + "\n## series.csv\n\n" + series(root)
    for table, name in FILES.items():
        text += f"\n## {name}\n\n" + columns(found[table])
    text += "\n## summary.json\n" + keys(root, {**summary, "piece_line": found["piece"]}, "summary", "", set())
    for name, _, figures in machines(root):
        text += f"\n### `{name}`\n\n" + columns([("name", "TEXT", "its own"), *figures], "key")
    text += "\n## results.h5\n" + sets(root) + "\n## Tables of hawser theory\n\n### Facts\n\n" + facts(root, ANSWER)
    theory, source = tables(root, THEORY), tree.read(root, THEORY)
    for name, heading, table in re.findall(r'table_add\(\s*t, "(\w+)", "([^"]*)",\s*(\w+)_columns', source):
        text += f"\n### Table `{name}`\n\n{heading}.\n\n" + columns(theory[table] if table in theory else summary[table])
    certificate = tables(root, CERTIFICATE)
    text += "\n## certificate.json\n\n" + facts(root, CERTIFICATE)
    text += "".join(f"\n### Table `{name}s`\n\n{columns(certificate[name])}" for name in ("figure", "run"))
    return text + "\n## sensitivities.json\n\n" + columns(tables(root, SLOPES)["slope"])


def script(summary):
    text = ("// Rows of summary.json: made by tests/house/check_columns.py from the tables of io/results/summary_json.c.\n\n"
            "import type { Point, Value } from './data';\n")
    for table, name in INTERFACES.items():
        text += f"\nexport interface {name} {{\n"
        for key, kind, _ in summary[table]:
            optional, kind = ("?", f"{INTERFACES[kind]}[]") if kind in INTERFACES else ("", TYPES[kind])
            text += f"  {key}{optional}: {kind};\n"
        text += "}\n"
    return text if "Point;" in text else text.replace("Point, ", "")


def python(found):
    text = ('"""What the columns of results are: made by tests/house/check_columns.py from the tables of io/results/tables.c."""\n'
            "from __future__ import annotations\n\nCOLUMNS: dict[str, dict[str, str]] = {\n")
    for table, name in FILES.items():
        text += f"    {name!r}: {{\n".replace("'", '"')
        meaning = ""
        for key, _, own in found[table]:
            meaning = own or meaning
            text += f'        "{key}": "{meaning}",\n'
        text += "    },\n"
    return text + "}\n"


def expected(root):
    """{path: its text as it should be}, and complaints."""
    found, summary = tables(root, TABLES), tables(root, SUMMARY)
    complaints = [f"{path}: {table}: {rows[0][0]} has no description" for path, all_of in ((TABLES, found), (SUMMARY, summary))
                  for table, rows in all_of.items() if not rows[0][2] and rows[0][0]]
    return {DOCUMENT: page(root, found, summary), SCRIPT: script(summary), PYTHON: python(found)}, complaints


def read(root, path):
    return tree.read(root, path) if os.path.exists(os.path.join(root, path)) else ""


def check(root):
    texts, complaints = expected(root)
    return complaints + [f"{path}: is not what the tables of results say: check_columns.py ROOT --update"
                         for path, text in texts.items() if read(root, path) != text]


def update(root):
    for path, text in expected(root)[0].items():
        with open(os.path.join(root, path), "w", encoding="utf-8") as file:
            file.write(text)


def main():
    root = sys.argv[1]
    if "--update" in sys.argv:
        update(root)
    return tree.report("columns", check(root))


if __name__ == "__main__":
    sys.exit(main())
