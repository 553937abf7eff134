"""What the parts of the benchmark suite share: the machine's name, runs of the program, statistics, tables, documents.

A part is a script bench/NAME.py with the options of `arguments`. It writes DIR/NAME.csv, one row a measurement, its pictures,
and its tables between the markers `<!-- NAME: begin -->` and `<!-- NAME: end -->` of DIR/NAME.md, and fails (status 1) if a condition is missed that does not depend on time: results that are wrong or differ. Conditions on
times and ratios of times are judged in the tables alone.
"""
import argparse
import csv
import json
import math
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "scripts"))  # document, svgplot
from document import replace_between  # noqa: E402


def processor():
    """The processor's name as lscpu gives it."""
    text = subprocess.run(["lscpu"], capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    found = re.search(r"^Model name:\s*(.*)$", text, re.M)
    return found.group(1).strip() if found else "unknown"


def machine_name(model, cores):
    """'AMD EPYC' and 2 -> 'epyc-2core': a name for a folder, without what every processor is called."""
    text = re.sub(r"\(.*?\)|@.*|\b(amd|intel|cpu|processor|\d+-core)\b", " ", model.lower())
    words = re.findall(r"[a-z0-9]+", text)
    return "-".join(words or ["unknown"]) + f"-{cores}core"


def arguments(description):
    """The options that every part has; a part may add its own before it parses."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--build", required=True, help="a build with the benchmarks, such as build/bench")
    parser.add_argument("--results", help="folder for rows, pictures and tables (default: tables are printed, no more)")
    parser.add_argument("--quick", action="store_true", help="does everything work? About twenty seconds, no true figures")
    return parser


class RunFailed(Exception):
    """hawser ended with a status that is not 0; `status` and `message` say which and why."""

    def __init__(self, status, message):
        super().__init__(f"status {status}: {message}")
        self.status, self.message = status, message


def run_case(build, case, settings=(), options=(), timeout=None, keep=None):
    """One run of the program in a process of its own. case: a name in cases/ or a file; settings: KEY=VALUE.

    Returns summary.json with `process_s`, `cpu_s` and `peak_kB` (largest memory of any run so far) added. The results stay in
    the folder `keep` if one is given. Raises RunFailed, and subprocess.TimeoutExpired.
    """
    path = case if os.path.sep in case else os.path.join(ROOT, "cases", case + ".yaml")
    words = [word for setting in settings for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as folder:
        folder = keep or folder
        command = [os.path.join(build, "cli/hawser"), "run", path, "-q", "-o", folder, *options, *words]
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout)
        process, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            raise RunFailed(done.returncode, done.stderr.strip())
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {**summary, "process_s": round(process, 6), "cpu_s": round(cpu, 6), "peak_kB": after.ru_maxrss}


def read_series(path):
    """A CSV file of the program as {column: [values]}; empty cells are None."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = zip(*rows[1:])
    return {name: [float(cell) if cell else None for cell in column] for name, column in zip(rows[0], columns)}


def pick(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def median(rows, key):
    return statistics.median(row[key] for row in rows)


def spread(rows, key):
    """Half the distance of the quartiles in % of the median."""
    values = [row[key] for row in rows]
    if len(values) < 2:
        return 0.0
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return 50 * (high - low) / middle


def ratio(rows, above, below, key="wall_time_s"):
    """Median over the rounds of one configuration's figure over another's in the same round."""
    over = {row["round"]: row[key] for row in pick(rows, **above)}
    return statistics.median(over[row["round"]] / row[key] for row in pick(rows, **below))


def slope(x, y):
    """Exponent p of the power law y ~ x^p: the least-squares line through the logarithms."""
    fit = statistics.linear_regression([math.log(v) for v in x], [math.log(v) for v in y])
    return fit.slope


def table(head, body):
    """Markdown; the first column is text, the others are numbers."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(cells) + " |" for cells in body])


def commit():
    """The tree's commit, with a + when what is measured has changes: not the results themselves, nor documents."""
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True).stdout.strip()
    changed = git("status", "--porcelain", "-uno", "--", ":!docs", ":!bench/results")
    return (git("rev-parse", "--short", "HEAD") or "unknown") + ("+" if changed else "")


def processor_times():
    """Seconds since boot that all cores together were busy (with this machine's work, or with another guest's), and all."""
    with open("/proc/stat", encoding="ascii") as file:
        ticks = [int(word) for word in file.readline().split()[1:9]]
    idle = ticks[3] + ticks[4]  # waiting for a disk is idle
    return (sum(ticks) - idle) / os.sysconf("SC_CLK_TCK"), sum(ticks) / os.sysconf("SC_CLK_TCK")


def load_of_others(seconds=3):
    """How many cores are busy while this process does nothing: the load average would tell of the part before."""
    before = processor_times()
    time.sleep(seconds)
    used, passed = (now - then for now, then in zip(processor_times(), before))
    return os.cpu_count() * used / passed if passed > 0 else 0.0


def busy(load):
    """Whether a load means that others used the machine too."""
    return load > 0.1 * os.cpu_count()


def heading(load, note=""):
    """Machine, commit, day, and whether something else was running: `load` is load_of_others() at the start."""
    cores = os.cpu_count()
    text = (f"Machine `{machine_name(processor(), cores)}` ({processor()}, {cores} cores, Linux "
            f"{os.uname().release.split('-')[0]}), commit {commit()}, {time.strftime('%Y-%m-%d')}"
            f"{', ' + note if note else ''}; other work at the start: {load:.2f} cores.")
    if busy(load):
        text += " **The machine was busy: read ratios, not times.**"
    return text


def write_document(path, name, new):
    """replace_between in a file, in place. On a machine that has no such file yet it is a new one."""
    text = f"# {name.capitalize()}\n\nHow it is measured: `bench/README.md`.\n\n<!-- {name}: begin -->\n<!-- {name}: end -->\n"
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            text = file.read()
    with open(path, "w", encoding="utf-8") as file:
        file.write(replace_between(text, name, new))


def write_rows(path, rows, columns=None):
    """Rows (dicts) as CSV; columns: names in order (default: the first row's)."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns or list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def publish(args, name, rows, text, columns=None):
    """What a part ends with: its rows, its tables, and the tables on the terminal."""
    if args.results:
        write_rows(os.path.join(args.results, name + ".csv"), rows, columns)
        write_document(os.path.join(args.results, name + ".md"), name, text)
    print(text)
