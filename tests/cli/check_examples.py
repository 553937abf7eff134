"""Published worked examples of pulling calculations against the program: tests/data/examples/, docs/examples.md.

Usage: check_examples.py HAWSER SOURCE [--update]
tests/data/examples/figures.csv has a row for every figure: the number of its source in the document, the case, what the figure is, where
`hawser theory --format json` has it, its unit, what the source says (a number, or a range "15..20"), and why the program differs. A reason is
asked for where the two are more than 1 % apart, or outside the range, and allowed nowhere else. The document's table is made from all this:
--update writes it anew, without it the table that is there is compared.
"""
import csv
import json
import os
import subprocess
import sys

NEAR = 0.01
OF_ALL = " of all"
LBF, FOOT = 4.4482216152605, 0.3048
UNITS = {"1": 1, "N": 1, "kN": 1e3, "lbf": LBF, "kgf": 9.80665, "N/m": 1, "kN/m": 1e3, "lbf/ft": LBF / FOOT, "mm": 1e-3}
HEAD = "| source | case | figure | published | ours | difference | why |\n|---|---|---|---:|---:|---:|---|\n"
BEGIN, END = "<!-- figures -->\n", "<!-- end -->\n"


def calculate(hawser, path):
    run = subprocess.run([hawser, "theory", "--format", "json", path], capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{path}: hawser theory ends with {run.returncode}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def value_at(document, where):
    """'pieces/BC/forward_end_N': the column of the row that has this name or direction; 'limits/forward pull/limit': or both."""
    table, row, column = where.split("/")
    for r in document[table]:
        names = {r.get("name"), r.get("direction"), f"{r.get('direction')} {r.get('name')}"}
        if row in names:
            return float(r[column])
    raise KeyError(where)


def in_unit(document, value, unit):
    if unit == "% of weight":  # of the cable that fills the route
        return 100 * value / (document["weight_N_per_m"] * sum(p["length_m"] for p in document["pieces"]))
    if unit.endswith(OF_ALL):  # sidewall pressure of all cables, where the program has the worst loaded one's
        return in_unit(document, value, unit[: -len(OF_ALL)]) / document["ducts"][0]["sidewall_factor"]
    return value / UNITS[unit]


def like(text, value):
    """The value with the digits of the published figure, and one more."""
    digits = len(text.split(".")[1]) if "." in text else 0
    return f"{value:.{digits + 1}f}"


def row_of(row, document, complaints):
    """A line of the table; complains about a difference without a reason and a reason without a difference."""
    ours = in_unit(document, value_at(document, row["where"]), row["unit"])
    unit = "" if row["unit"] == "1" else " " + row["unit"].removesuffix(OF_ALL)
    if ".." in row["published"]:
        low, high = row["published"].split("..")
        far, shown = not float(low) <= round(ours, 1) <= float(high), f"{low} to {high}"
        difference = "outside" if far else "inside"
        ours_shown = like("0", ours)
    else:
        apart = ours / float(row["published"]) - 1
        far, shown, difference = abs(apart) > NEAR, row["published"], f"{100 * apart:+.2f} %"
        ours_shown = like(row["published"], ours)
    name = f"{row['case']}, {row['figure']}"
    if far and not row["why"]:
        complaints.append(f"{name}: {row['published']}, ours {ours:.6g}: no reason is given")
    if row["why"] and not far:
        complaints.append(f"{name}: {row['published']}, ours {ours:.6g}: agrees, and yet a reason is given")
    return (f"| {row['source']} | `{row['case']}` | {row['figure']} | {shown}{unit} | {ours_shown}{unit} | {difference} | {row['why']} |\n")


def main(hawser, source, update):
    folder, path = os.path.join(source, "tests/data/examples"), os.path.join(source, "docs/examples.md")
    with open(os.path.join(folder, "figures.csv"), newline="", encoding="utf-8") as f:
        rows = list(csv.DictReader(f))
    documents = {case: calculate(hawser, os.path.join(folder, case + ".yaml")) for case in {r["case"] for r in rows}}
    complaints = []
    for name in os.listdir(folder):
        if name.endswith(".yaml") and name[:-5] not in documents:
            complaints.append(f"{name}: no figure is compared")
    table = HEAD + "".join(row_of(r, documents[r["case"]], complaints) for r in rows)
    with open(path, encoding="utf-8") as f:
        text = f.read()
    before, rest = text.split(BEGIN)
    there, after = rest.split(END)
    if update:
        with open(path, "w", encoding="utf-8") as f:
            f.write(before + BEGIN + table + END + after)
    elif there != table:
        old, new = there.splitlines(), table.splitlines()
        complaints += [f"docs/examples.md: {line}" for line in old if line not in new]
        complaints += [f"        should be: {line}" for line in new if line not in old]
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], "--update" in sys.argv[3:]))
