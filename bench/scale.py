#!/usr/bin/env python3
"""Time per step, memory and number of steps of chains from 37 to 100 000 segments, and against the number of rollers.

Every configuration is a process of bench_scale (bench/scale_steps.c) that stays and takes a few steps when it is asked to,
so that all of them can take turns, round by round. Figures are medians over the rounds.
"""
import math
import os
import statistics
import subprocess
import sys

from common import arguments, heading, load_of_others, median, pick, publish, spread, table
from svgplot import Panel, write_svg

LENGTHS = (37, 100, 370, 1000, 3700, 10_000, 37_000, 100_000)
FIT_FROM = 370  # segments
CONFIGS = tuple((scene, way, threads) for scene, way in (("pull", "plane"), ("pull", "space"), ("chain", "space"))
                for threads in (1, 2))
NAMES = {("pull", "plane"): "pull, plane", ("pull", "space"): "pull, space", ("chain", "space"): "chain, space"}
ROLLERS, ROLLERS_AT = (0, 250, 500, 1000, 1500, 2000), 2000  # at so many segments
PHASES = {"rhs": "right-hand side", "contacts": "contacts", "jacobian": "Jacobian blocks and matrix", "factor": "factor",
          "solve": "solve", "vector": "vectors and control"}
COLUMNS = ["kind", "scene", "way", "threads", "segments", "rollers", "round", "steps", "simulated_s", "iterations",
           "jacobians", "setups", "error_fails", "newton_fails", "total_s", *(name + "_s" for name in PHASES), "build_s",
           "relax_s", "relax_iterations", "record_s", "memory_kB", "candidates", "pull_ratio", "middle_z", "GB_per_s"]
SLOPE_MOST = 1.05

# Bytes a segment that each loop moves between memory and a core when nothing stays in a cache: every array counts once for
# each time that a loop passes over it, twice where it is written without being read (the line is fetched first).
# bench/results/xeon-2core/scale.md adds them up.
BYTES = {"space": {"step": 3640, "iteration": 1560, "rhs": 1560, "solve": 2090, "setup": 5340, "jacobian": 7200},
         "plane": {"step": 1340, "iteration": 720, "rhs": 750, "solve": 630, "setup": 1300, "jacobian": 1750}}


class Worker:
    """A process of bench_scale that waits for amounts to do."""

    def __init__(self, build, scene, segments, rollers, way, threads, warm):
        words = [scene, segments, rollers, way, threads, warm]
        self.key = {"scene": scene, "way": way, "threads": threads, "segments": segments, "rollers": rollers}
        self.process = subprocess.Popen([os.path.join(build, "bench/bench_scale"), *map(str, words)], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.begun = self.line()

    def line(self):
        """The next line of figures."""
        text = self.process.stdout.readline()
        if not text:
            self.close()
            raise RuntimeError(f"bench_scale ended with status {self.process.wait()}: {self.key}")
        return {name: float(value) for name, value in (word.split("=") for word in text.split())}

    def ask(self, amount):
        """Has it done, in steps or 'SECONDSs'; what it took."""
        self.process.stdin.write(f"{amount}\n")
        self.process.stdin.flush()
        return self.line()

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()

    def end(self):
        """How it ended."""
        self.process.stdin.close()
        result = self.line()
        self.close()
        if self.process.wait() != 0:
            raise RuntimeError(f"bench_scale ended with status {self.process.returncode}: {self.key}")
        return result


def in_turn(workers, rounds, amount_of, kind):
    """Every worker in turn, round by round; the first round is thrown away. The rows, the last ones with how each ended."""
    rows = []
    for number in range(rounds + 1):
        for worker in workers:
            rows.append({"kind": kind, **worker.key, "round": number, **worker.ask(amount_of(worker.key["segments"]))})
        print(f"scale.py: {kind}, round {number} of {rounds}", file=sys.stderr)
    ends = [{"kind": kind + " end", **worker.key, **worker.end()} for worker in workers]
    return [row for row in rows if row["round"] > 0] + ends


def steps_of_round(segments):
    """Enough steps to be timed, few of long chains, and not so many that the head comes to the end of the row."""
    return max(10, min(60, 20_000 // segments))


def time_lengths(build, lengths, rounds):
    workers = []
    for scene, way, threads in CONFIGS:
        for segments in lengths:
            warm = "0.5s" if scene == "pull" else "40"
            workers.append(Worker(build, scene, segments, -1, way, threads, warm))
        print(f"scale.py: {scene}, {way}, {threads} threads: ready", file=sys.stderr)
    return in_turn(workers, rounds, steps_of_round, "steps")


def time_rollers(build, rollers, rounds):
    workers = [Worker(build, "pull", ROLLERS_AT, count, way, 1, 100) for way in ("plane", "space") for count in rollers]
    return in_turn(workers, rounds, lambda segments: 30, "rollers")


def measure_setup(build, lengths, rounds):
    """Building, relaxation and memory, as the program does it; three steps, so that the integrator is there too."""
    rows = []
    for number in range(1, rounds + 1):
        for way in ("plane", "space"):
            for segments in lengths:
                worker = Worker(build, "rest", segments, -1, way, 1, 0)
                rows.append({"kind": "setup", **worker.key, "round": number, **worker.begun, **worker.ask(3),
                             **worker.end()})
        print(f"scale.py: set-up, round {number} of {rounds}", file=sys.stderr)
    return rows


def count_steps(build, lengths, simulated):
    """Steps of the same simulated times: of a pull from rest, and of one that slides from the start, its first half second
    and what follows."""
    rows = []
    for segments in lengths:
        for scene, kind, amounts in (("rest", "from rest", (simulated,)), ("pull", "sliding", (0.5, simulated))):
            worker = Worker(build, scene, segments, -1, "plane", 1, 0)
            for number, amount in enumerate(amounts):
                rows.append({"kind": kind, **worker.key, "round": number, **worker.ask(f"{amount}s")})
            rows[-1].update(worker.end())
        print(f"scale.py: steps of {segments} segments counted", file=sys.stderr)
    return rows


def measure_bandwidth(build, megabytes, rounds):
    """What memory gives to one core and to two."""
    rows = []
    for number in range(1, rounds + 1):
        for threads in (1, 2):
            out = subprocess.run([os.path.join(build, "bench/bench_scale"), "bandwidth", str(megabytes), str(threads)],
                                 capture_output=True, text=True, check=True).stdout
            rate = float(out.split()[0].split("=")[1])
            rows.append({"kind": "bandwidth", "threads": threads, "round": number, "GB_per_s": rate})
    return rows


# ------------------------------------------------------------------------------------------------ what follows from it

def fit(x, y):
    """Exponent of the power law y ~ x^p and its standard error, by least squares through the logarithms."""
    u, v = [math.log(value) for value in x], [math.log(value) for value in y]
    line = statistics.linear_regression(u, v)
    centre = statistics.fmean(u)
    wide = sum((value - centre) ** 2 for value in u)
    left = sum((b - line.intercept - line.slope * a) ** 2 for a, b in zip(u, v))
    return line.slope, math.sqrt(left / max(1, len(u) - 2) / wide)


def per_step(rows, name="total", unit="steps"):
    """Median over the rounds of the seconds a step (or an iteration) that a phase took."""
    return statistics.median(row[name + "_s"] / row[unit] for row in rows)


def phase_time(rows, name):
    """per_step; the right-hand side without its contacts."""
    value = per_step(rows, name)
    return value - per_step(rows, "contacts") if name == "rhs" else value


def moved(way, row):
    """Bytes a segment that the steps of a row move, contacts left out; averaged over its steps."""
    cost = BYTES[way]
    iterations = row["iterations"] * (cost["rhs"] + cost["solve"] + cost["iteration"])
    matrices = row["setups"] * cost["setup"] + row["jacobians"] * cost["jacobian"]
    return cost["step"] + (iterations + matrices) / row["steps"]


def of_length(rows, config, segments, kind="steps"):
    scene, way, threads = config
    return pick(rows, kind=kind, scene=scene, way=way, threads=threads, segments=segments)


def lengths_of(rows):
    return sorted({row["segments"] for row in pick(rows, kind="steps")})


def slopes(rows, unit="steps"):
    """{configuration: (exponent, standard error)} of the lengths from FIT_FROM on."""
    lengths = [n for n in lengths_of(rows) if n >= FIT_FROM]
    return {config: fit(lengths, [per_step(of_length(rows, config, n), unit=unit) for n in lengths]) for config in CONFIGS}


def config_name(config):
    scene, way, threads = config
    return f"{NAMES[scene, way]}, {threads} thr."


def verdicts_table(rows):
    body = []
    steps, iterations = slopes(rows), slopes(rows, "iterations")
    for config in CONFIGS:
        value, error = steps[config]
        body.append([config_name(config), f"{value:.3f}", f"{error:.3f}", f"{iterations[config][0]:.3f}",
                     "yes" if value <= SLOPE_MOST else "no"])
    return table([f"slope of log time per step against log N, N >= {FIT_FROM}; goal: at most {SLOPE_MOST}", "measured",
                  "standard error", "per iteration", "reached"], body)


def lengths_table(rows):
    head = ["N", *(f"{config_name(config)}, ns" for config in CONFIGS), "iterations a step, pull", "chain",
            "spread, pull space"]
    body = []
    for n in lengths_of(rows):
        mine = [of_length(rows, config, n) for config in CONFIGS]
        cells = [f"{1e9 * per_step(some) / n:.0f}" for some in mine]
        turns = [statistics.median(row["iterations"] / row["steps"] for row in some) for some in (mine[2], mine[4])]
        body.append([str(n), *cells, *(f"{turn:.2f}" for turn in turns), f"{spread(mine[2], 'total_s'):.0f} %"])
    return table(head, body)


def phases_table(rows, config):
    """Nanoseconds a segment and step, phase by phase."""
    body = []
    lengths = [n for n in lengths_of(rows) if n >= FIT_FROM]
    for name, text in PHASES.items():
        times = [1e9 * phase_time(of_length(rows, config, n), name) / n for n in lengths]
        body.append([text, *(f"{value:.1f}" for value in times), f"{times[-1] / times[0]:.2f}" if times[0] > 0 else "-"])
    return table([f"{config_name(config)}; N ="] + [str(n) for n in lengths] + ["last / first"], body)


def roofline_table(rows):
    """What the longest chain's steps move, what memory gives, and what was measured."""
    body, n = [], lengths_of(rows)[-1]
    for config in CONFIGS:
        mine = of_length(rows, config, n)
        total = statistics.median(moved(config[1], row) for row in mine)
        rate = median(pick(rows, kind="bandwidth", threads=config[2]), "GB_per_s")
        least, measured = total / rate, 1e9 * (per_step(mine) - per_step(mine, "contacts")) / n
        body.append([config_name(config), f"{total / 1000:.1f}", f"{rate:.1f}", f"{least:.0f}", f"{measured:.0f}",
                     f"{total / measured:.1f}"])
    return table([f"N = {n}, without contacts", "kB a segment and step", "memory, GB/s", "ns at that rate", "ns measured",
                  "GB/s reached"], body)


def setup_table(rows):
    body = []
    for way in ("plane", "space"):
        some = pick(rows, kind="setup", way=way)
        lengths = sorted({row["segments"] for row in some})
        empty = median(pick(some, segments=lengths[0]), "memory_kB")
        for n in lengths:
            mine = pick(some, segments=n)
            memory = (median(mine, "memory_kB") - empty) / (n - lengths[0]) if n > lengths[0] else math.nan
            body.append([f"{way}, {n}", f"{1e6 * median(mine, 'build_s') / n:.2f}",
                         f"{1e6 * median(mine, 'relax_s') / n:.2f}", f"{median(mine, 'relax_iterations'):.0f}",
                         "-" if math.isnan(memory) else f"{memory:.2f}",
                         f"{median(mine, 'memory_kB') / 1024:.0f}"])
    return table(["way, N", "building, us a segment", "relaxation, us a segment", "its iterations", "memory, kB a segment",
                  "memory, MB"], body)


def counts_of(rows, n):
    """Steps from rest, of the first sliding half second, and of the time after it."""
    return (pick(rows, kind="from rest", segments=n)[0], *sorted(pick(rows, kind="sliding", segments=n),
                                                                 key=lambda row: row["round"]))


def counts_table(rows):
    body = []
    for n in sorted({row["segments"] for row in pick(rows, kind="sliding")}):
        rest, first, later = counts_of(rows, n)
        body.append([str(n), f"{rest['steps'] / rest['simulated_s']:.0f}", f"{first['steps']:.0f}",
                     f"{later['steps'] / later['simulated_s']:.1f}", f"{later['iterations'] / later['steps']:.2f}",
                     f"{later['pull_ratio']:.5f}"])
    rest = pick(rows, kind="from rest")[0]["simulated_s"]
    return table(["N", f"from rest, first {rest:.3g} s: steps a second", "sliding, first 0.5 s: steps",
                  "then: steps a second", "iterations a step", "pull over friction"], body)


def rollers_table(rows):
    body = []
    for way in ("plane", "space"):
        some = pick(rows, kind="rollers", way=way)
        for count in sorted({row["rollers"] for row in some}):
            mine, end = pick(some, rollers=count), pick(rows, kind="rollers end", way=way, rollers=count)[0]
            body.append([f"{way}, {count}", f"{end['candidates']:.0f}", f"{1e6 * per_step(mine):.1f}",
                         f"{1e6 * per_step(mine, 'contacts'):.1f}", f"{1e6 * per_step(mine, 'jacobian'):.1f}",
                         f"{1e6 * per_step(mine, unit='iterations'):.1f}"])
    return table([f"N = {ROLLERS_AT}: way, rollers", "candidates", "us a step", "contacts, us", "Jacobian, us",
                  "us an iteration"], body)


def faults(rows):
    """Conditions that do not depend on time and are not met, in words."""
    found = []
    ends = [row for row in rows if row.get("pull_ratio") is not None and row["segments"] >= FIT_FROM]
    for row in ends:
        if not abs(row["pull_ratio"] - 1) <= 0.01:
            found.append(f"{row['kind']}, {row['way']}, N = {row['segments']}: the pull is {row['pull_ratio']:.4f} "
                         "of friction")
    for row in pick(rows, kind="steps end", threads=2):
        one = of_length(rows, (row["scene"], row["way"], 1), row["segments"], "steps end")[0]
        if row["middle_z"] != one["middle_z"] or row["pull_ratio"] != one["pull_ratio"]:
            found.append(f"{row['scene']}, {row['way']}, N = {row['segments']}: two threads do not give the bits of one")
    for way in ("plane", "space"):
        turns = [row["relax_iterations"] for row in pick(rows, kind="setup", way=way) if row["segments"] >= FIT_FROM]
        if turns and max(turns) > 2 * min(turns):
            found.append(f"{way}: relaxation takes {min(turns):.0f} to {max(turns):.0f} iterations")
    lengths = [n for n in sorted({row["segments"] for row in pick(rows, kind="sliding")}) if n >= FIT_FROM]
    rates = [counts_of(rows, n)[2]["steps"] for n in lengths]
    if rates and max(rates) > 4 * min(rates):
        found.append(f"a sliding pull takes {min(rates):.0f} to {max(rates):.0f} steps, by its length")
    return found


def draw(folder, rows):
    """Time against N, with a straight line of slope 1; the same by the segment."""
    lengths = lengths_of(rows)
    times = Panel("segments", "us a step", log="xy", height=300)
    each = Panel("segments", "ns a segment and step", log="x", height=200, bottom=0)
    for config in CONFIGS:
        values = [per_step(of_length(rows, config, n)) for n in lengths]
        times.add(config_name(config), lengths, [1e6 * value for value in values])
        each.add(config_name(config), lengths, [1e9 * value / n for n, value in zip(lengths, values)])
    base = per_step(of_length(rows, CONFIGS[2], FIT_FROM if FIT_FROM in lengths else lengths[0]))
    start = FIT_FROM if FIT_FROM in lengths else lengths[0]
    times.add("slope 1", [start, lengths[-1]], [1e6 * base, 1e6 * base * lengths[-1] / start], "#888888", dash="6 3")
    write_svg(os.path.join(folder, "scale.svg"), "Time per step against the number of segments", [times, each])
    loads = Panel("rollers", "us a step", height=200, bottom=0)
    for way in ("plane", "space"):
        some = pick(rows, kind="rollers", way=way)
        counts = sorted({row["rollers"] for row in some})
        loads.add(way, counts, [1e6 * per_step(pick(some, rollers=count)) for count in counts])
    write_svg(os.path.join(folder, "scale-rollers.svg"), f"Time per step of {ROLLERS_AT} segments against rollers", [loads])


def measure(args):
    """All rows; a few of few configurations when it has to be quick."""
    if args.quick:
        lengths = (37, 370, 1000)
        return (time_lengths(args.build, lengths, 2) + time_rollers(args.build, (0, 500), 2) +
                measure_setup(args.build, (37, 1000), 1) + count_steps(args.build, (370, 1000), 0.5) +
                measure_bandwidth(args.build, 120, 1))
    return (time_lengths(args.build, LENGTHS, 12) + time_rollers(args.build, ROLLERS, 12) +
            measure_setup(args.build, LENGTHS, 2) + count_steps(args.build, LENGTHS, 1.5) +
            measure_bandwidth(args.build, 1200, 3))


def main():
    args = arguments(__doc__).parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    rows = measure(args)
    wrong = faults(rows)
    text = "\n\n".join([heading(load, "medians of the rounds"), verdicts_table(rows), lengths_table(rows),
                        phases_table(rows, ("pull", "space", 1)), phases_table(rows, ("pull", "plane", 1)),
                        roofline_table(rows), setup_table(rows), counts_table(rows), rollers_table(rows),
                        "\n".join(f"**Wrong: {fault}.**" for fault in wrong) or
                        f"From N = {FIT_FROM} on pulls are within 1 % of friction, two threads give the bits of one, "
                        "relaxation takes as many iterations whatever the length, and a sliding pull as many steps within "
                        "a factor of 4: yes."])
    if args.results:
        os.makedirs(args.results, exist_ok=True)
        draw(args.results, rows)
    publish(args, "scale", rows, text, COLUMNS)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
