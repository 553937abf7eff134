#!/usr/bin/env python3
"""Results of an older format are read as those of today; the page of formats names the numbers that the program writes.

tests/data/format-1.tar.gz is a run of cases/capstan.yaml with 22 segments, as format 1 has it: roller names as texts of one
length, no dimension scales, `unit`, no `format` in summary.json. It was converted from a folder of format 2, whose page had
the same data to the byte. format-2.tar.gz is the same run by the last program of format 2.

Usage: check_formats.py HAWSER SOURCE
"""
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile


def page_data(hawser, folder):
    subprocess.run([hawser, "report", folder, "-q"], check=True)
    page = (folder / "report.html").read_text("utf-8")
    return json.loads(re.search(r'id="hawser-data">(.*?)</script>', page, re.S).group(1))["runs"][0]


def check_old_results(hawser, source, work, name):
    with tarfile.open(source / f"tests/data/{name}.tar.gz") as archive:
        archive.extractall(work)
    data = page_data(hawser, work / name)
    assert data["notes"] == [], data["notes"]
    assert [r["name"] for r in data["geometry"]["rollers"]] == ["drum"]
    assert data["chain"]["segments"] == 22 and data["chain"]["piece_names"] == ["rope"]
    assert data["states"]["frames"] == data["roller_force"]["frames"] == 3
    peak = max(t for t in data["envelope"]["arc"]["tension_max_N"] if t is not None)
    assert abs(peak - 1864.317) < 1e-3, peak


def number(source, file, name):
    return int(re.search(rf"\b{name} = (\d+)", (source / file).read_text("utf-8")).group(1))


def check_page(source):
    text = (source / "docs/reference/results.md").read_text("utf-8")
    table = text.split("### Formats", 1)[1]
    newest, file = {}, ""
    for row in re.findall(r"^\|([^|]*)\|([^|]*)\|", table.split("\n#", 1)[0], re.M):
        file = row[0].split(",")[0].strip().strip("`") or file
        if row[1].strip().isdigit():
            newest[file] = int(row[1])
    written = {"summary.json": number(source, "io/results/column.h", "RESULTS_FORMAT"),
               "results.h5": number(source, "io/results/results_file.h", "STATES_FORMAT"),
               "a case": number(source, "io/case/case_parts.h", "CASE_FORMAT")}
    assert {k: newest.get(k) for k in written} == written, (newest, written)


def main(hawser, source):
    source = pathlib.Path(source)
    with tempfile.TemporaryDirectory() as work:
        for name in ("format-1", "format-2"):
            check_old_results(hawser, source, pathlib.Path(work), name)
    check_page(source)


if __name__ == "__main__":
    main(*sys.argv[1:])
