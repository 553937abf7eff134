"""Reads the tables of a results folder (docs/reference/results.md); for the scripts that draw them. Standard library only."""
import csv
import json
import math
import os


def number(text):
    """A cell as a number; an empty one is not known."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def read_table(folder, name):
    """The columns of a CSV file: {column: list}; {} if there is none. The column `name` stays text."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        return {}
    return {key: [row[key] if key == "name" else number(row[key] or "nan") for row in rows] for key in rows[0]}


def read_summary(folder):
    """summary.json, {} if there is none that can be read."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}
