"""The page of the calculation in Chinese and German: nothing of the program's English is left on it.

Usage: check_languages.py HAWSER CASE...
What may be left in Latin letters on a Chinese page are names of the case, keys, units, codes and the names of companies and people. A German
page has no word that the table's English texts have and its German ones do not.
"""
import html
import json
import os
import re
import subprocess
import sys
import tempfile

# Units, signs of formulas, codes and who is quoted for them.
PLAIN = set("""kN mm kg kNm lbf cmil psi cos sin cosh sinh sqrt EI pi deg min hawser check guide inside chain step run factor jams conveyors
medium rollers.list obstacles force speed_limit drive.script NEC TB GB ICEA AEIC CG TES VDE Nexans Southwire Anixter General Cable Fujikura Euler
Dawson Paslay PVC PE XLPE VPE IEC dT ds limits""".split())
KEY = re.compile(r"\b[a-z_]+(?:\.[A-Za-z0-9_]+)+\b|\b[a-z]+_[a-z_]+\b")
# What pieces and rows are called that the case gives no name: as a whole text, on the plan, at a place, in quotes.
AUTO = r"(?:straight|bend|arc|clothoid|point|row|duct|change of slope|before the route|beyond the route|machine|pit|feed)(?: \d+)?"


def english_words(source):
    rows = re.findall(r'^\s+\{\{"((?:[^"\\]|\\.)*)", "(?:[^"\\]|\\.)*", "((?:[^"\\]|\\.)*)"\}\}', open(source, encoding="utf-8").read(), re.M)
    words = [set(re.findall(r"[A-Za-z]{2,}", KEY.sub(" ", " ".join(r[k] for r in rows)))) for k in (0, 1)]
    return words[0] - words[1] - PLAIN


def names_of(hawser, path):
    """Names of the case's pieces, ducts, stations, machines, rollers, cables; no words of the program's in other columns."""
    run = subprocess.run([hawser, "theory", path, "--format", "json"], capture_output=True, text=True, check=False)
    document = json.loads(run.stdout) if not run.returncode else {}
    names = [row["name"] for table in ("pieces", "ducts", "stations", "pushes", "chains", "terms") for row in document.get(table, [])]
    names += [n for n in names for n in re.split(r"^(?:start|end) of ", n) if n]
    names += [row["ends_at"] for row in document.get("sections", []) if row.get("ends_at") not in (None, "end")]
    for row in document.get("limits", []):
        names += re.findall(r" m \(([^)]+)\)$", row["where"]) or [re.sub(r"^[\d.]+ m(?: on)? ?", "", row["where"])]
    text = open(path, encoding="utf-8").read()
    names += re.findall(r"(?:name|client|project|drawing|author|checker|date|winch|K|roller): *[\"']?([^,}\"'\n]+)", text)
    names += re.findall(r"type: *([^,}\n]+)", text) + re.findall(r"^  ([\w-]+): *(?:\{|$)", text, re.M) + re.findall(r"[{,] *([\w-]+): *\{", text)
    return sorted({n.strip() for n in names if re.search("[A-Za-z]{2}", n)}, key=len, reverse=True)


def texts_of(page):
    page = re.sub(r"<style>.*?</style>|<title>.*?</title>|<h1>.*?</h1>|<sup>.*?</sup>", "", page, flags=re.S)
    return [html.unescape(t).strip() for t in re.findall(r">([^<]+)<", page)]


def pattern_of(names):
    """What may be Latin in any language: a name as the whole text, on the plan, at a place, in brackets or quotes."""
    edge = r"(?<![A-Za-z])(?:" + "|".join([re.escape(n) for n in names] + [AUTO]) + r")(?![A-Za-z])"
    return re.compile(rf"^{edge}$|{edge}(?= R \d|:)|(?<=[（(“„'\[]){edge}|(?<=[在于bei] ){edge}|(?<=von ){edge}|^{edge}(?= 起点| 终点| 的)|(?<=（){edge}")


def left(text, names):
    return KEY.sub(" ", re.sub(r"\S+\.(?:yaml|csv|dxf)", " ", names.sub(" ", text)))


def main(hawser, cases):
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "io", "results", "words.c")
    english, bad, seen = english_words(source), [], 0
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            for language in ("zh", "de"):
                out = os.path.join(folder, "page.html")
                run = subprocess.run([hawser, "theory", case, "--set", f"job.language={language}", "--report", "-o", out], capture_output=True,
                                     text=True, check=False)
                if run.returncode:
                    continue
                page = open(out, encoding="utf-8").read()
                seen += 1
                if f'<html lang="{language}">' not in page:
                    bad.append(f"{case}: not in {language}")
                names = pattern_of(names_of(hawser, case))
                for text in sorted(t for t in set(texts_of(page)) if re.search("[A-Za-z]{2}", t)):
                    words = set(re.findall(r"[A-Za-z]{2,}" if language == "de" else r"[A-Za-z]{3,}", left(text, names)))
                    found = words & english if language == "de" else words - PLAIN
                    if found:
                        bad.append(f"{case}, {language}: {' '.join(sorted(found))}: {text[:160]}")
    print("\n".join(bad[:60]) or f"{seen} pages have no English left")
    return bool(bad) or not seen


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
