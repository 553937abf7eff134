#!/usr/bin/env python3
"""hawser against MuJoCo and Simbody on the same problems: every program's settings swept, the best ones at full size.

A program that was not built, since its package is missing, is skipped with a message. The sweep runs every setting at the
smallest size; the settings that are best there run at the larger ones, within limits of processor time.
"""
import os
import statistics
import subprocess
import sys
import tempfile

import peer_grids
from common import ROOT, arguments, heading, load_of_others, publish, slope, table
from svgplot import Panel, write_svg

PEERS = (peer_grids.MUJOCO, peer_grids.SIMBODY, peer_grids.BAND)
SIZES = (12, 37, 120, 370)
PROBLEMS = {"straight": "straight pull", "hang": "hanging chain at rest", "swing": "swinging chain"}
SAME = 0.1           # %: errors below are as good as each other
GOAL, AT = 500, 370  # times faster, on the straight pull of so many segments
ROUGH, SWINGS = 2, 20  # %, and times faster than each peer on the swinging chain where errors below that are as good as each other
LIMIT = 120          # s of processor time of a run, where its program has no other limit
REFERENCE = "stiff=100 accuracy=1e-6"  # of hawser, for the swinging chain
# Largest errors of hawser's default settings, %: a result that is wrong fails the part.
ALLOWED = {"straight": 0.1, "hang": 0.1, "swing": 1}
COLUMNS = ["program", "problem", "n", "settings", "stage", "round", "outcome", "sim_s", "setup_s", "cpu_s", "steps", "value",
           "exact", "error_pct", "window_s", "ripple", "cost"]


def read_row(line):
    """A program's row (bench/peers/run.h) as a dict; empty cells are None; cost: CPU s a simulated second."""
    names = ["program", "problem", "n", "settings", "outcome", "sim_s", "setup_s", "cpu_s", "steps", "value", "exact",
             "error_pct", "window_s", "ripple"]
    cells = line.strip().split(",")
    if len(cells) != len(names):
        raise ValueError(f"not a row: {line!r}")
    row = dict(zip(names, cells))
    for name in names[5:]:
        row[name] = float(row[name]) if row[name] else None
    row["n"], row["steps"] = int(row["n"]), int(row["steps"])
    row["cost"] = row["cpu_s"] / row["sim_s"] if row["sim_s"] else None
    return row


class Runner:
    """Runs the programs of a build, keeps all rows, and the chain's reference paths in a folder."""

    def __init__(self, build, folder):
        self.build, self.folder, self.rows = build, folder, []

    def program(self, peer):
        return os.path.join(self.build, "bench/peers/peer_" + peer.program)

    def run(self, peer, problem, n, settings, stage, number=1, limit=LIMIT, words=()):
        """One run: its row. A program that crashes has failed; one that refuses its command line ends the part."""
        reference = os.path.join(self.folder, f"path{n}")
        words = [*settings.split(), "--limit", str(limit), *words]
        if problem == "swing" and os.path.exists(reference):
            words += ["--reference", reference]
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run([self.program(peer), problem, str(n), *words], capture_output=True, text=True,
                              timeout=20 * limit + 60, env=environment)
        if done.returncode == 2:
            raise RuntimeError(done.stderr.strip())
        if done.returncode == 0:
            row = read_row(done.stdout.strip().splitlines()[-1])
        else:
            row = {**dict.fromkeys(COLUMNS), "program": peer.name, "problem": problem, "n": n, "settings": settings,
                   "outcome": "failed"}
        row.update(program=peer.name, stage=stage, round=number)
        self.rows.append(row)
        cost = "-" if row["cost"] is None else f"{row['cost']:.4g}"
        error = "-" if row["error_pct"] is None else f"{row['error_pct']:.4g}"
        print(f"peers.py: {peer.name} {problem} {n} {settings}: {row['outcome']}, {cost} s/s, error {error} %",
              file=sys.stderr)
        return row

    def reference(self, n):
        """The path of the chain's middle by hawser with tight tolerances."""
        path = os.path.join(self.folder, f"path{n}")
        self.run(peer_grids.HAWSER, "swing", n, REFERENCE, "reference", words=["--trace", path])


def rank(rows, count, same=SAME):
    """The settings that go on: the cheapest of those within `same` %, then the most accurate of the others."""
    done = [row for row in rows if row["error_pct"] is not None]
    good = sorted((row for row in done if row["error_pct"] <= same), key=lambda row: row["cost"])
    rest = sorted((row for row in done if row["error_pct"] > same), key=lambda row: row["error_pct"])
    picked = []
    for row in good + rest:
        if row["settings"] not in picked:
            picked.append(row["settings"])
    return picked[:count]


def best(rows, same=SAME):
    """What stands for a program: the setting that is first by rank; else the cheapest that got somewhere."""
    first = rank(rows, 1, same)
    if first:
        mine = [row for row in rows if row["settings"] == first[0] and row["error_pct"] is not None]
        return {**mine[0], "cost": statistics.median(row["cost"] for row in mine)}
    moved = [row for row in rows if row["outcome"] == "limit" and row["cost"] is not None]
    return min(moved, key=lambda row: row["cost"]) if moved else None


def match(rows, error, same=SAME):
    """hawser's row for a peer's error (%, None: unknown): the cheapest whose error is not larger, or is within `same`."""
    needed = max(same, error or 0)
    groups = {}
    for row in rows:
        if row["error_pct"] is not None and row["error_pct"] <= needed:
            groups.setdefault(row["settings"], []).append(row)
    found = [{**group[0], "cost": statistics.median(row["cost"] for row in group)} for group in groups.values()]
    return min(found, key=lambda row: row["cost"]) if found else None


def sweep(runner, peer, problem, quick):
    """Every setting at the smallest size, the best of those at the larger ones, as many as the program's plan says; of the
    swinging chain two more that are cheapest within ROUGH.

    A setting that does not come to its end at one size is not tried at the next one, unless no other did.
    """
    rough = []
    going = (peer.quick if quick else peer.sweep)[problem]
    for n in SIZES[:1] if quick else SIZES:
        rows = [runner.run(peer, problem, n, settings, "sweep", limit=peer.limit.get(n, LIMIT))
                for settings in going[:peer.keep.get(n)] + [more for more in rough if more not in going[:peer.keep.get(n)]]]
        moved = sorted((row for row in rows if row["outcome"] == "limit" and row["cost"]), key=lambda row: row["cost"])
        going = rank(rows, None) or [row["settings"] for row in moved[:1]]
        rough = rank(rows, 2, ROUGH) if problem == "swing" else []


def measure_hawser(runner, sizes, problem, rounds, quick):
    """All of hawser's settings in turn, round by round; the first round is not counted."""
    own = peer_grids.HAWSER
    for number in range(rounds + 1):
        for n in sizes:
            for settings in (own.quick if quick else own.sweep)[problem]:
                runner.run(own, problem, n, settings, "hawser", number)
    runner.rows = [row for row in runner.rows if row["stage"] != "hawser" or row["round"] > 0 or not rounds]


def of(rows, program, problem, n):
    return [row for row in rows if (row["program"], row["problem"], row["n"]) == (program, problem, n)
            and row["stage"] in ("sweep", "hawser")]


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def pairs(rows, peer, problem, same=SAME):
    """[(n, the peer's best row, hawser's row for its error)] of the sizes that the peer ran at."""
    found = []
    for n in SIZES:
        theirs = best(of(rows, peer.name, problem, n), same)
        ours = match(of(rows, "hawser", problem, n), theirs["error_pct"], same) if theirs else None
        if theirs and ours:
            found.append((n, theirs, ours))
    return found


def comparison_table(rows, peers, problem, same=SAME):
    title = PROBLEMS[problem] + ("" if same == SAME else f", errors below {same} % as good as each other")
    head = [title, "segments", "best settings", "outcome", "error %", "ripple N", "CPU s per s",
            "steps per s", "hawser: settings", "error %", "ripple N", "CPU s per s", "times"]
    body = []
    for peer in peers:
        for n, theirs, ours in pairs(rows, peer, problem, same):
            body.append([peer.title, str(n), f"`{theirs['settings'] or 'default'}`", theirs["outcome"],
                         number(theirs["error_pct"]), number(theirs["ripple"]), number(theirs["cost"]),
                         f"{theirs['steps'] / theirs['sim_s']:.0f}", f"`{ours['settings'] or 'default'}`",
                         number(ours["error_pct"]), number(ours["ripple"]), number(ours["cost"]),
                         f"{theirs['cost'] / ours['cost']:.3g}"])
    return table(head, body)


def growth_table(rows, peers):
    """Exponents of cost against N over the sizes from 37 on."""
    body = []
    for problem, title in PROBLEMS.items():
        for peer in peers:
            found = [entry for entry in pairs(rows, peer, problem) if entry[0] >= 37]
            if len(found) < 2:
                continue
            sizes = [n for n, *_ in found]
            body.append([f"{title}, {peer.title}", f"{sizes[0]} to {sizes[-1]}",
                         f"{slope(sizes, [theirs['cost'] for _, theirs, _ in found]):.2f}",
                         f"{slope(sizes, [ours['cost'] for *_, ours in found]):.2f}"])
    return table(["cost grows as N to the power", "segments", "peer", "hawser"], body)


def goal_rows(rows, peers):
    """The goal for each peer at the largest size that it managed with at most SAME % error."""
    body = []
    for peer in peers:
        managed = [entry for entry in pairs(rows, peer, "straight")
                   if entry[1]["error_pct"] is not None and entry[1]["error_pct"] <= SAME]
        text = f"{GOAL} times faster than {peer.title} on the straight pull, error at most {SAME} %"
        if not managed:
            body.append([text, "-", "-", "no setting reached the error"])
            continue
        n, theirs, ours = managed[-1]
        ratio = theirs["cost"] / ours["cost"]
        at = str(n) if n == AT else f"{n} (largest managed)"
        body.append([text, at, f"{ratio:.0f}", "yes" if ratio >= GOAL else "no"])
    for peer in peers:
        text = f"{SWINGS} times faster than {peer.title} on the swinging chain, errors below {ROUGH} % as good as each other"
        for n, theirs, ours in pairs(rows, peer, "swing", ROUGH):
            ratio = theirs["cost"] / ours["cost"]
            body.append([text, str(n), f"{ratio:.1f}", "yes" if ratio >= SWINGS else "no"])
    return body


def aside_table(rows, peers):
    """Settings that were not to be chosen, against hawser at the same error."""
    body = []
    for peer in peers:
        for row in rows:
            if (row["program"], row["stage"]) == (peer.name, "aside"):
                ours = match(of(rows, "hawser", row["problem"], row["n"]), row["error_pct"])
                body.append([f"{peer.title}, {PROBLEMS[row['problem']]}", str(row["n"]), f"`{row['settings']}`",
                             row["outcome"], number(row["error_pct"]), number(row["ripple"]), number(row["cost"]),
                             f"{row['cost'] / ours['cost']:.3g}" if ours and row["cost"] else "-"])
    return table(["fast, but the error is not held", "segments", "settings", "outcome", "error %", "ripple N", "CPU s per s",
                  "times"], body)


def cost_plot(path, rows, peers):
    panels = []
    for problem in ("straight", "swing"):
        panel = Panel("segments", f"CPU s per s, {PROBLEMS[problem]}", log="xy")
        hawser = [(n, best(of(rows, "hawser", problem, n))) for n in SIZES]
        lines = [("hawser", [(n, row["cost"]) for n, row in hawser if row])]
        lines += [(peer.title, [(n, theirs["cost"]) for n, theirs, _ in pairs(rows, peer, problem)]) for peer in peers]
        for title, points in lines:
            panel.add(title, [n for n, _ in points], [cost for _, cost in points])
        panels.append(panel)
    write_svg(path, "Cost of a simulated second at each program's best settings", panels)


def wrong(rows):
    """hawser's runs that failed or whose error is larger than allowed."""
    return [f"{row['problem']} {row['n']} {row['settings']}: {row['outcome']}, error {row['error_pct']} %"
            for row in rows if row["stage"] == "hawser" and "accuracy=1e-2" not in row["settings"]
            and not (row["error_pct"] is not None and row["error_pct"] <= ALLOWED[row["problem"]])]


def run_all(args, runner, peers):
    sizes = SIZES[:1] if args.quick else SIZES
    for n in sizes:
        runner.reference(n)
    for problem in PROBLEMS:
        measure_hawser(runner, sizes, problem, 1 if args.quick else args.repetitions, args.quick)
        for peer in peers:
            sweep(runner, peer, problem, args.quick)
            for n in sizes:
                for settings in peer.aside.get(problem, ()):
                    runner.run(peer, problem, n, settings, "aside", limit=peer.limit.get(n, LIMIT))


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--repetitions", type=int, default=5, help="of hawser's runs, which are short")
    args = parser.parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(args.build, folder)
        peers = [peer for peer in PEERS if os.path.exists(runner.program(peer))]
        run_all(args, runner, peers)
    rows = runner.rows
    notes = [f"{peer.title}: skipped: package {peer.package} is missing." for peer in PEERS if peer not in peers]
    goals = [] if args.quick else [table(["goal", "segments", "times", "reached"], goal_rows(rows, peers))]
    text = [heading(load), *notes, *goals, *(comparison_table(rows, peers, problem) for problem in PROBLEMS)]
    text += [] if args.quick else [comparison_table(rows, peers, "swing", ROUGH)]
    text += [] if args.quick else [growth_table(rows, peers), aside_table(rows, peers)]
    if args.results:
        os.makedirs(args.results, exist_ok=True)
        cost_plot(os.path.join(args.results, "peers.svg"), rows, peers)
    publish(args, "peers", rows, "\n\n".join(text), COLUMNS)
    bad = wrong(rows)
    for line in bad:
        print(f"peers.py: hawser is wrong: {line}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
