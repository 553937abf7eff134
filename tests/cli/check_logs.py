"""Winches' logs of four kinds against the plan: what is read of them, and wrong files refused with file and line.

Usage: check_logs.py HAWSER FOLDER
The logs in FOLDER are theory of duct.yaml with a friction of 0.24, where 0.3 was planned, and 1 % of noise: the friction that would explain
them is known.
"""
import json
import os
import subprocess
import sys
import tempfile

LOGS = ["semicolons-daN.csv", "tabs-kN.tsv", "commas-lbf.csv", "bars-kp.csv"]
WRONG = [
    ("Weg [m];Kraft [Pferde]\n0;100\n5;120\n", ":1: ", "Pferde"),
    ("Weg [m];Kraft [kN]\n0;1,2\n5;1,4;9\n", ":3: ", ""),
    ("Weg [m];Kraft\n0;100\n5;120\n", ":1: ", "has no unit"),
    ("Weg [m];Temperatur\n0;100\n5;120\n", "", "force"),
    ("Weg [m];Kraft [kN]\n" + "".join(f"{90 - 5 * k};1,{k}\n" for k in range(1, 10)), "", "runs down"),
]


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False)


def check_log(hawser, folder, name, bad):
    case, log = os.path.join(folder, "duct.yaml"), os.path.join(folder, name)
    answer = run(hawser, "compare", case, log, "--json")
    if answer.returncode:
        bad.append(f"{name}: {answer.stderr}")
        return
    found = json.loads(answer.stdout)
    if not abs(found["friction_share"] - 0.8) < 0.005:
        bad.append(f"{name}: {found['friction_share']} times the friction, 0.8 expected")
    if not abs(found["friction_planned"] - 0.3) < 1e-9:
        bad.append(f"{name}: planned friction {found['friction_planned']}")
    rows = found["planned"]
    if len(rows) != 12 or sum(r["readings"] for r in rows) != found["moving"]:
        bad.append(f"{name}: {len(rows)} parts")
    for row in rows:
        if abs(row["ratio"] * row["planned_N"] - row["pulled_N"]) > 1e-6 * row["pulled_N"] or not 0.75 < row["ratio"] < 1.02:
            bad.append(f"{name}: ratio {row['ratio']} from {row['from_m']} m")
    if not 8300 < found["pulled_peak_N"] < 9100 or not 11000 < found["planned_peak_N"] < 11600 or found["planned_peak_at"] < 209:
        bad.append(f"{name}: peaks {found['pulled_peak_N']}, {found['planned_peak_N']} N at {found['planned_peak_at']} m")


def main(hawser, folder):
    bad = []
    for name in LOGS:
        check_log(hawser, folder, name, bad)
    case = os.path.join(folder, "duct.yaml")
    with tempfile.TemporaryDirectory() as there:
        log = os.path.join(there, "log.csv")
        for text, line, words in WRONG:
            with open(log, "w", encoding="utf-8") as f:
                f.write(text)
            answer = run(hawser, "compare", case, log)
            if answer.returncode != 2 or log + (line or ":") not in answer.stderr or words not in answer.stderr:
                bad.append(f"{text!r}: {answer.returncode}: {answer.stderr}{answer.stdout[:200]}")
        with open(os.path.join(folder, LOGS[0]), encoding="utf-8") as whole, open(log, "w", encoding="utf-8") as f:
            f.write(whole.read())
        answer = run(hawser, "compare", case, log, "--report")
        page = open(os.path.join(there, "log-compare.html"), encoding="utf-8").read() if not answer.returncode else ""
        for words in ("Planned against pulled", "would explain the mean", "place of the head along the route, m"):
            if words not in page:
                bad.append(f"the page has no '{words}'")
        answer = run(hawser, "compare", case, log, "--align", "start")
        if answer.returncode != 2 or "a case has no times" not in answer.stderr:
            bad.append(f"aligned by start: {answer.stderr}")
    print("\n".join(bad) or f"{len(LOGS)} logs, {len(WRONG)} wrong ones")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
