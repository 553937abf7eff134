"""Instructions of whole runs by phase, counted by valgrind's callgrind: they repeat to within what a file system's names
and the clock's digits change, whatever else the machine does.

The phases are told apart by the functions through which they are entered; what a function calls counts as its own. A
program whose functions have other names has no count for that phase.
"""
import os
import re
import shutil
import subprocess
import tempfile

from common import ROOT

# Phase: functions at its door.
DOORS = {"relax": ("sim_relax",), "rhs": ("call_rates",), "jacobian": ("call_system",), "factor": ("solver_setup",),
         "solve": ("solver_solve",),
         "output": ("hawser_sim_record", "sim_record_row", "results_row", "results_state", "results_tick")}
STEP = "integrator_step"  # the integrator with its call-backs; what is left of it without them is "vector"
INSIDE = ("rhs", "jacobian", "factor", "solve")
CONTACTS = ("planar_contact_forces", "contact_forces")  # in right-hand sides and in looks at the state
PHASES = ("relax", "rhs", "jacobian", "factor", "solve", "vector", "output", "other", "all", "contacts")


def read_annotated(text):
    """{function: inclusive instructions} from callgrind_annotate --inclusive=yes; `all` is the program's total."""
    counts = {}
    for line in text.splitlines():
        found = re.match(r"\s*([\d,]+) \([ \d.]+%\)\s+(.*)$", line)
        if not found:
            continue
        number, what = int(found.group(1).replace(",", "")), found.group(2)
        if what.startswith("PROGRAM TOTALS"):
            counts["all"] = number
            continue
        name = re.match(r"[^ ]*?:([A-Za-z_][\w.]*?)(?:'\d+)?(?:\.\w+(?:\.\d+)?)?(?: \[.*)?$", what)
        if name:
            counts[name.group(1)] = max(counts.get(name.group(1), 0), number)
    return counts


def phases_of(functions):
    """{phase: instructions} from {function: inclusive instructions}; phases that were not entered are missing."""
    counts = {phase: sum(functions[name] for name in doors if name in functions)
              for phase, doors in DOORS.items() if any(name in functions for name in doors)}
    if STEP in functions:
        counts["vector"] = functions[STEP] - sum(counts.get(phase, 0) for phase in INSIDE)
    if any(name in functions for name in CONTACTS):
        counts["contacts"] = sum(functions.get(name, 0) for name in CONTACTS)
    counts["all"] = functions["all"]
    counts["other"] = counts["all"] - sum(value for phase, value in counts.items() if phase not in ("all", "contacts"))
    return counts


def count_case(program, case, settings=(), timeout=600):
    """{phase: instructions} of one run on one thread; None if valgrind is not there or cannot run it."""
    if not (shutil.which("valgrind") and shutil.which("callgrind_annotate")):
        return None
    path = case if os.path.sep in case else os.path.join(ROOT, "cases", case + ".yaml")
    words = [word for setting in settings for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "counts")
        done = subprocess.run(["valgrind", "--quiet", "--tool=callgrind", "--callgrind-out-file=" + out, program, "run", path,
                               "-q", "--threads", "1", "-o", os.path.join(folder, "results"), *words],
                              capture_output=True, text=True, timeout=timeout)
        if done.returncode != 0 or not os.path.exists(out):
            return None
        text = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--auto=no", out], check=True,
                              capture_output=True, text=True).stdout
    functions = read_annotated(text)
    return phases_of(functions) if "all" in functions else None
