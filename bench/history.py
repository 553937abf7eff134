"""The history of the tracked scenes: a CSV file a machine with a row for every commit that was measured, and its picture."""
import csv
import os

import common
import svgplot

# Scene: case, solver.planar.
TRACKED = {"straight": ("straight", "on"), "straight-space": ("straight", "off"), "huangjiahu": ("huangjiahu", "on"),
           "huangjiahu-space": ("huangjiahu", "off")}
KEYS = ["date", "commit", "target", "rounds", "load"]


def read_history(path):
    """Rows (dicts of text) in the order of the file; none if there is no file."""
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def with_row(rows, row):
    """The rows with `row` in the place of the one of the same commit, or at the end. No other changes."""
    row = {key: str(value) for key, value in row.items()}
    if any(old["commit"] == row["commit"] for old in rows):
        return [row if old["commit"] == row["commit"] else old for old in rows]
    return rows + [row]


def columns_of(rows):
    """All columns: the keys, then the figures in the order in which they came up. Old rows lack what is new."""
    return KEYS + [key for key in dict.fromkeys(key for row in rows for key in row) if key not in KEYS]


def record(path, row):
    """Appends the row of a commit, or replaces it; returns all rows. The file is never left half written."""
    rows = with_row(read_history(path), row)
    common.write_rows(path + ".new", rows, columns_of(rows))
    os.replace(path + ".new", path)
    return rows


def history_row(target, rounds, load, scenes):
    """scenes: {name: {figure: number}} -> one row; figures are named SCENE.FIGURE."""
    import time
    row = {"date": time.strftime("%Y-%m-%d %H:%M"), "commit": common.commit(), "target": target, "rounds": rounds,
           "load": f"{load:.2f}"}
    row.update({f"{scene}.{figure}": value for scene, figures in scenes.items() for figure, value in figures.items()})
    return row


def numbers(rows, column):
    """The column's numbers; NaN where a row has none."""
    return [float(row[column]) if row.get(column) else float("nan") for row in rows]


def draw(path, rows):
    """Steps a second, time a step and instructions a step over the commits, oldest left."""
    at = list(range(1, len(rows) + 1))
    speed = svgplot.Panel("", "steps/s (integration)", bottom=0)
    whole = svgplot.Panel("", "us a step (whole run)", bottom=0)
    counts = svgplot.Panel("commits measured, oldest first", "instructions a step", bottom=0)
    for panel, figure in ((speed, "steps_per_s"), (whole, "us_per_step"), (counts, "instructions_all")):
        for number, scene in enumerate(TRACKED):
            values = numbers(rows, f"{scene}.{figure}")
            colour = svgplot.COLOURS[number]
            panel.add(scene, at, values, colour)
            panel.add("", at, values, colour, marks=True)
    svgplot.write_svg(path, "Tracked scenes by commit, one thread", [speed, whole, counts])


def table_of(rows, last=8):
    """The last commits: steps a second and instructions a step of every tracked scene."""
    body = []
    for row in rows[-last:]:
        cells = [f"`{row['commit']}` {row['date'][:10]}", row["load"]]
        for scene in TRACKED:
            speed, count = (numbers([row], f"{scene}.{figure}")[0] for figure in ("steps_per_s", "instructions_all"))
            cells += ["-" if speed != speed else f"{speed:.0f}", "-" if count != count else f"{count:.0f}"]
        body.append(cells)
    head = ["commit", "load"] + [f"{scene}, {unit}" for scene in TRACKED for unit in ("steps/s", "instructions a step")]
    return common.table(head, body)
