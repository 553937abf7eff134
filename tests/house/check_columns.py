"""A column is said once, in the tables of io/results: from these are the tables of docs/reference/results.md, the types of the page's
data (web/src/columns.ts) and what Python says of the columns of results (python/hawser/_columns.py).

Usage: check_columns.py ROOT [--update]     (--update: writes them)
The comment above a row says what the column is; a row without one shares that of the row before it.
"""
import os
import re
import sys

import tree

TABLES = "io/results/tables.c"
SUMMARY = "io/results/summary_json.c"
TABLE = re.compile(r"^static const Column (\w+)_column\[\] = \{(.*?)^\};", re.M | re.S)
ROW = re.compile(r'(?:/\*((?:(?!\*/).)*)\*/\s*)?\{\s*(?:COLUMN|LIST|TERMS)?\(?(?:\.key = )?"([^"]*)"([^{}]*)\}', re.S)
KIND = re.compile(r"^, (NUMBER|COUNT|LONG|TEXT|CHARS|FLAG|VECTOR)\b|\.kind = COLUMN_(\w+)")
OF = re.compile(r", (\w+)_columns\)")
UNITS = (("_N_per_m", "N/m"), ("_m_per_s", "m/s"), ("_rad_per_s", "rad/s"), ("_per_m", "1/m"), ("_N_m", "N m"), ("_per_s", "1/s"),
         ("_rad", "rad"), ("_Hz", "Hz"), ("_pct", "%"), ("_N", "N"), ("_m", "m"), ("_s", "s"))
DOCUMENT, SCRIPT, PYTHON = "docs/reference/results.md", "web/src/columns.ts", "python/hawser/_columns.py"
PART = re.compile(r"(<!-- columns of (\w+) -->\n)(.*?)(<!-- end -->)", re.S)
FILES = {"station": "stations.csv", "roller": "rollers.csv", "input": "inputs.csv", "route": "route.csv",
         "place": "positions.csv", "shape": "modes.csv"}
INTERFACES = {"limit": "LimitRow", "condition": "Trust", "event": "EventRow", "assumption": "Assumption",
              "bar": "ErrorBar", "pass": "Pass", "passes": "Passes"}
TYPES = {"NUMBER": "Value", "COUNT": "number", "LONG": "number", "TEXT": "string", "CHARS": "string",
         "FLAG": "boolean | null", "VECTOR": "Point"}


def tables(root, path):
    """{table: [(key, kind or the table of its rows, what it is)]}, of one file."""
    found = {}
    for table in TABLE.finditer(tree.read(root, path)):
        rows = found[table.group(1)] = []
        for comment, key, rest in ROW.findall(table.group(2)):
            kind, of = KIND.search(rest), OF.search(rest)
            rows.append((key, of.group(1) if of else kind.group(1) or kind.group(2) if kind else "NUMBER",
                         re.sub(r"\s*\n\s*\*?\s*", " ", comment).strip()))
    return found


def unit_of(key):
    return next((unit for end, unit in UNITS if key.endswith(end)), "")


def document(rows):
    """A table of the document; columns that share a unit and a meaning share a line."""
    lines = []
    for key, _, meaning in rows:
        unit = unit_of(key)
        if not meaning and lines and lines[-1][1] == unit:
            lines[-1][0].append(key)
        else:
            lines.append(([key], unit, meaning))
    text = "| column | unit | meaning |\n|---|---|---|\n"
    for keys, unit, meaning in lines:
        text += f"| {', '.join(f'`{key}`' for key in keys)} | {unit + ' ' if unit else ''}| {meaning} |\n"
    return text


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
    found, complaints = tables(root, TABLES), []
    text = tree.read(root, DOCUMENT)
    named = [m.group(2) for m in PART.finditer(text)]
    complaints += [f"{DOCUMENT}: has no columns of {table}" for table in FILES if table not in named]
    complaints += [f"{TABLES}: {table}: {rows[0][0]}: nothing says what it is" for table, rows in found.items() if not rows[0][2]]
    return {DOCUMENT: PART.sub(lambda m: m.group(1) + document(found[m.group(2)]) + m.group(4), text),
            SCRIPT: script(tables(root, SUMMARY)), PYTHON: python(found)}, complaints


def read(root, path):
    return tree.read(root, path) if os.path.exists(os.path.join(root, path)) else ""


def check(root):
    texts, complaints = expected(root)
    return complaints + [f"{path}: is not what the tables of io/results say: check_columns.py ROOT --update"
                         for path, text in texts.items() if read(root, path) != text]


def update(root):
    for path, text in expected(root)[0].items():
        with open(os.path.join(root, path), "w", encoding="utf-8") as file:
            file.write(text)


def main():
    root = sys.argv[1]
    if "--update" in sys.argv:
        update(root)
    complaints = check(root)
    for complaint in complaints:
        print(complaint)
    print(f"columns: {len(complaints)} complaint(s)" if complaints else "columns: fine")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
