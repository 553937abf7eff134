#!/usr/bin/env python3
"""`hawser job`: its table, CSV, JSON and workbook say the same; statuses; where LibreOffice is there, it opens the workbook.

Usage: check_job.py HAWSER ROOT
"""
import csv
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile

MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"


def job(*arguments, status=0):
    done = subprocess.run([sys.argv[1], "job", *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == status, (arguments, done.returncode, done.stderr)
    return done.stdout if status in (0, 1, 6) else done.stderr


def cells(book, sheet):
    """Rows of a sheet: texts and numbers."""
    root = xml.fromstring(book.read(f"xl/worksheets/sheet{sheet}.xml"))
    return [[c.findtext(f"{MAIN}is/{MAIN}t") if c.get("t") else None if (v := c.findtext(f"{MAIN}v")) is None else float(v)
             for c in row] for row in root.iter(f"{MAIN}row")]


def main():
    path = pathlib.Path(sys.argv[2]) / "cases" / "jobs" / "ducts.yaml"
    data = json.loads(job(path, "--format", "json"))
    rows = list(csv.DictReader(io.StringIO(job(path, "--format", "csv"))))
    assert [row["name"] for row in rows] == ["S1", "S2", "S3", "S4", "S5", "S6"]
    for row, pull in zip(rows, data["pulls"], strict=True):
        for key, value in pull.items():
            assert row[key] == value if isinstance(value, str) else value is None or abs(float(row[key]) - value) < 1e-9 * abs(value) + 1e-9
    assert "5 SAFE, 1 NOT SAFE" in job(path)
    job(path, "--strict", status=1)
    assert "-o is of --report" in job(path, "-o", "x.html", status=2)
    assert " lbf" in job(path, "--units", "us") and " lbf" not in job(path)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "job.xlsx"
        assert not job(path, "--xlsx", file, "-q")
        first = file.read_bytes()
        job(path, "--xlsx", file, "-q")
        assert file.read_bytes() == first, "two workbooks of one job differ"
        with zipfile.ZipFile(file) as book:
            assert book.testzip() is None
            for name in book.namelist():
                xml.fromstring(book.read(name))
            for sheet, key in enumerate(("pulls", "reels", "bays"), 1):
                head, *lines = cells(book, sheet)
                assert len(lines) == len(data[key]) and head[0] in ("pull", "reel", "bay")
                for line, row in zip(lines, data[key], strict=True):
                    assert line == list(row.values())[: len(line)], (line, row)
        crew = pathlib.Path(folder) / "crew.html"
        job(path, "--crew", crew, "-q")
        sheets = crew.read_text(encoding="utf-8")
        assert sheets.count("<section") == len(data["pulls"]) == sheets.count("Where somebody stands")
        for pull in data["pulls"]:  # each in the direction that is taken
            part = sheets[sheets.index(f"<h1>{pull['name']}</h1>") :]
            assert ("back, from" if pull["direction"] == "backward" else "forward, from") in part[: part.index("</section>")]
        if shutil.which("soffice"):
            subprocess.run(["soffice", f"-env:UserInstallation=file://{folder}/profile", "--headless", "--convert-to",
                            "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,true,false,false,false,-1", "--outdir", folder, file],
                           capture_output=True, check=True, timeout=600)
            opened = list(csv.reader((pathlib.Path(folder) / "job-pulls.csv").open(encoding="utf-8")))
            assert [line[0] for line in opened[1:]] == [row["name"] for row in rows]
            assert abs(float(opened[3][4]) - data["pulls"][2]["force_N"]) < 1e-3
        else:
            print("without LibreOffice: the workbook was read by zipfile alone")
        assert "cannot write" in job(path, "--xlsx", pathlib.Path(folder) / "none" / "job.xlsx", status=4)


main()
