"""bench/common.py, steps.py and linsolve.py: names, statistics, tables, and a whole benchmark of a made-up program.

Usage: test_steps.py ROOT
"""
import csv
import io
import os
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import common  # noqa: E402
import linsolve  # noqa: E402
import machine  # noqa: E402

# Answers `hawser run CASE ... -o DIR --linear-solver S --threads N` with a summary; logs the order of the calls. The time
# of the first call of a configuration is wild, as of a program that is not in memory yet.
PROGRAM = '''#!/usr/bin/env -S python3 -S -E
import json, os, sys
words = dict(zip(sys.argv[1:], sys.argv[2:]))
sets = dict(word.split("=", 1) for flag, word in zip(sys.argv, sys.argv[1:]) if flag == "--set")
here = os.path.dirname(os.path.abspath(__file__))
case, threads = os.path.basename(sys.argv[2])[:-5], int(words["--threads"])
solver = words.get("--linear-solver", "auto")
name = " ".join([case, sets["solver.planar"], solver, str(threads), *(sets.get(key, "-") for key in
                 ("run.duration", "chain.0.length"))])
with open(os.path.join(here, "log"), "a") as log:
    log.write(name + "\\n")
with open(os.path.join(here, "log")) as log:
    count = log.read().splitlines().count(name)
wall = 100.0 if count == 1 else (1 + 0.1 * count) / threads
pull = 8000.0 + (threads if os.path.exists(os.path.join(here, "differ")) else 0)
if solver == "klu" and os.path.exists(os.path.join(here, "astray")):
    pull += 1
summary = {"linear_solver": "block" if solver == "auto" else solver, "wall_time_s": wall, "real_time_factor": 30 / wall,
           "steps_per_second": 1000 / wall, "steps": 1000, "rhs_evals": 1100, "newton_iters": 1090, "jac_evals": 40,
           "lin_setups": 100, "error_test_fails": 2, "newton_fails": 3,
           "pull_force": {"steady_mean_N": pull, "steady_mean_error": {"total_N": 0.5}},
           "contact_candidates": 1760, "contact_active_max": 93,
           "phases_s": {name: wall / 9 for name in ("relax", "rhs", "contacts", "jacobian", "factor", "solve", "vector",
                                                    "output", "other")}}
with open(os.path.join(words["-o"], "summary.json"), "w") as file:
    json.dump(summary, file)
'''
# Stand in for valgrind: 900 instructions in all, 300 of them in right-hand sides.
VALGRIND = '''#!/bin/sh
for word; do
    case $word in --callgrind-out-file=*) echo counts >"${word#*=}" ;; esac
done
'''
ANNOTATE = '''#!/bin/sh
echo "900,000 (100.0%)  PROGRAM TOTALS"
echo "300,000 (33.33%)  ???:call_rates [/x/hawser]"
'''
PHASES = '''#!/bin/sh
echo "target gcc99-test"
echo "rhs $2 12.5"
echo "solve $2 3.5"
echo "plane-rhs $2 2.5"
'''


def rows_of(walls):
    """Rows of one configuration with these times."""
    return [{"case": "straight", "solver": "auto", "threads": 1, "round": i, "wall_time_s": wall}
            for i, wall in enumerate(walls)]


class Names(unittest.TestCase):
    def test_machine(self):
        name = common.machine_name
        self.assertEqual(name("AMD EPYC", 2), "epyc-2core")
        self.assertEqual(name("Intel(R) Xeon(R) Platinum 8375C CPU @ 2.90GHz", 4), "xeon-platinum-8375c-4core")
        self.assertEqual(name("AMD Ryzen 7 5800X 8-Core Processor", 16), "ryzen-7-5800x-16core")
        self.assertEqual(name("", 1), "unknown-1core")


class Statistics(unittest.TestCase):
    def test_spread(self):
        self.assertAlmostEqual(common.spread(rows_of([1, 2, 3, 4, 5]), "wall_time_s"), 100 / 3)
        self.assertEqual(common.spread(rows_of([7]), "wall_time_s"), 0)

    def test_ratio_is_taken_within_rounds(self):
        # a slow second round slows both alike: the ratio does not see it
        one, two = rows_of([2, 20, 2.2]), [{**row, "threads": 2} for row in rows_of([1, 10, 1.1])]
        self.assertAlmostEqual(common.ratio(one + two, {"threads": 2}, {"threads": 1}), 0.5)

    def test_table(self):
        self.assertEqual(common.table(["a", "b"], [["x", "1"]]), "| a | b |\n|---|---:|\n| x | 1 |")


class Document(unittest.TestCase):
    BEGIN, END = "<!-- steps: begin -->", "<!-- steps: end -->"
    text = f"before\n{BEGIN}\n\nold\n\n{END}\nafter\n"

    def test_only_what_is_between_changes(self):
        new = common.replace_between(self.text, "steps", "new")
        self.assertEqual(new, self.text.replace("old", "new"))
        self.assertEqual(common.replace_between(new, "steps", "new"), new)

    def test_markers_must_be_there(self):
        for text in ("", self.BEGIN, self.text + self.text, f"{self.END} {self.BEGIN}"):
            with self.assertRaises(ValueError):
                common.replace_between(text, "steps", "new")

    def test_the_contents_name_every_part(self):
        with open(os.path.join(ROOT, "scripts/bench.sh"), encoding="utf-8") as file:
            parts = re.search(r'^parts="(.*)"$', file.read(), re.M).group(1).split()
        with open(os.path.join(ROOT, "bench/README.md"), encoding="utf-8") as file:
            named = re.findall(r"^\| `(\w+)` \| .*\?", file.read(), re.M)
        self.assertTrue(set(parts) <= set(named) and len(parts) > 1, f"{parts}, but the contents have {named}")

    def test_the_document_has_them(self):
        with open(os.path.join(ROOT, "bench/results/xeon-2core/steps.md"), encoding="utf-8") as file:
            common.replace_between(file.read(), "steps", "new")


class Linsolve(unittest.TestCase):
    HEAD = "group,solver,b,n,threads,isa,factor_us,solve_us,peak_gf\n"

    def rows(self, factors):
        """Rounds in which klu_refactor takes ten times as long as block, whatever else disturbs the round."""
        text = ["kinds,klu_refactor,6,370,1,avx2,{0},10,0\nkinds,block,6,370,1,avx2,{1},2,0\nrates,block,6,370,1,avx2,{1},2,20\n"
                .format(factor, factor / 10) for factor in factors]
        return [row for number, one in enumerate(text) for row in linsolve.read_round(self.HEAD + one, number)]

    def test_ratios_are_taken_within_rounds(self):
        text = linsolve.kinds_table(self.rows([100, 5000, 110]))
        self.assertIn("| klu_refactor | 6 | 110.00 |", text)
        self.assertRegex(text, r"\| block \| 6 \| 11.00 .* \| 0.100 \| 0.200 \|")

    def test_rates(self):
        # 370 rows of 1296 operations in 479.52 us are 1 GF/s
        self.assertIn("| avx2 | 479.52 | 2.00 | 1.0 | 20.0 | 0.05 |", linsolve.rates_table(self.rows([4795.2])))


class Machine(unittest.TestCase):
    STEPS = ("# Steps\n\n| goal, auto | measured | reached |\n|---|---:|---:|\n| fast: at least 9 | 11 | yes |\n"
             "| straight, space: at least 8 | 6 | no |\n\n| case | GB/s reached |\n|---|---:|\n| a | no |\n")

    def test_machine_times_of_parts_and_verdicts_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            document = os.path.join(folder, "performance.md")
            results = os.path.join(folder, "results")
            os.mkdir(results)
            other = os.path.join(folder, "other.md")  # about another machine
            marks = "<!-- verdicts: begin -->\n<!-- verdicts: end -->\n"
            for path, text in ((document, "a results/README.md\n" + marks), (other, "a\n" + marks),
                               (os.path.join(results, "steps.md"), self.STEPS),
                               (os.path.join(results, "long.md"), "| goal | reached |\n|---|---|\n| holds | yes |\n"),
                               (os.path.join(results, "seconds.csv"), "part,seconds\nsteps,90\nscale,150\n")):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            for page in (document, other):
                subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/machine.py"), results, page], check=True,
                               stdout=subprocess.DEVNULL)
            with open(os.path.join(results, "README.md"), encoding="utf-8") as file:
                machine = file.read()
            with open(document, encoding="utf-8") as file:
                verdicts = file.read()
            with open(other, encoding="utf-8") as file:
                self.assertEqual(file.read(), "a\n" + marks)
        self.assertIn(f"`{common.machine_name(common.processor(), os.cpu_count())}`", machine)
        self.assertIn("`steps` 90 s, `scale` 150 s; together 4 min.", machine)
        self.assertRegex(verdicts, r"\| \[long\]\(.*/long.md\) \| 1 of 1 \| - \|\n")
        self.assertRegex(verdicts, r"\| \[steps\]\(.*\) \| 1 of 2 \| straight, space: at least 8 \(measured 6\) \|\n")

    def test_the_page_says_what_the_tables_say(self):
        with open(os.path.join(ROOT, "docs/performance.md"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn(machine.verdicts_text(os.path.join(ROOT, "bench/results/xeon-2core")), page)


class Commit(unittest.TestCase):
    """What common.commit calls a change."""
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.git("init", "-q")
        for name in ("docs/a.md", "bench/results/b.csv", "core/c.c"):
            self.write(name, "old")
        self.git("add", "-A")
        self.git("-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "-q", "-m", "a")
        self.addCleanup(setattr, common, "ROOT", common.ROOT)
        common.ROOT = self.folder.name

    def git(self, *words):
        subprocess.run(["git", "-C", self.folder.name, *words], check=True)

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def test_results_and_documents_are_no_changes_but_code_is(self):
        self.write("docs/a.md", "new")
        self.write("bench/results/b.csv", "new")
        self.assertNotIn("+", common.commit())
        self.write("core/c.c", "new")
        self.assertTrue(common.commit().endswith("+"))


class Whole(unittest.TestCase):
    EVERYDAY = 2 * 2 * 4 * 2  # cases, geometries, solvers, threads

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for path, text in (("cli/hawser", PROGRAM), ("bench/bench_phases", PHASES), ("bin/valgrind", VALGRIND),
                           ("bin/callgrind_annotate", ANNOTATE)):
            self.place(path, text)
            os.chmod(self.path(path), 0o755)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def place(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def bench(self, *words):
        path = self.path("bin") + os.pathsep + os.environ["PATH"]
        return subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/steps.py"), "--build", self.folder.name,
                               "--results", self.path("results"), "--load", "0", *words],
                              capture_output=True, text=True, env={**os.environ, "PATH": path})

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_rounds_are_interleaved_and_the_first_is_not_counted(self):
        done = self.bench("--rounds", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        log, count = self.read("cli/log").splitlines(), self.EVERYDAY
        self.assertEqual(len(set(log[:count])), count)
        self.assertEqual(log[:count], log[count:2 * count])
        rows = list(csv.DictReader(io.StringIO(self.read("results/steps.csv"))))
        mine = [row for row in rows if (row["case"], row["geometry"], row["solver"], row["threads"], row["window"]) ==
                ("straight", "plane", "auto", "2", "whole")]
        self.assertAlmostEqual(statistics.median(float(row["wall_time_s"]) for row in mine), 0.6)
        self.assertEqual({row["solver"] for row in rows}, {"auto", "block", "bordered", "klu"})
        self.check_tables(self.read("results/steps.md"))

    def check_tables(self, text):
        self.assertIn("| straight, plane | 2 | 600.0 |", text)
        self.assertIn("| plane, auto (block) | 1200.0 | 0.0 % | 600.0 | 0.0 % | 1000 | 1.00 |", text)
        self.assertIn("| straight, plane (default): at least 8000 steps a second | 1667 | no |", text)
        self.assertIn("| 2000 | 1200.0 | 600.0 | 0.500 | 1200.0 | 600.0 | 0.500 |", text)
        self.assertIn("| rhs | 2.50 | 12.50 |", text)
        self.assertIn("| right-hand side, with its contacts | 300 | 300 | 300 | 300 |", text)
        self.assertIn("`gcc99-test`", text)

    def history(self):
        return list(csv.DictReader(io.StringIO(self.read("results/history.csv"))))

    def test_the_history_has_the_commit(self):
        self.place("results/history.csv", "date,commit,target,rounds,load,straight.steps_per_s\nthen,old,t,1,0,7\n")
        self.assertEqual(self.bench("--quick").returncode, 0)
        for _ in range(2):  # the second time its row is replaced
            rows = self.history()
            self.assertEqual([row["commit"] for row in rows], ["old", common.commit()])
            self.assertEqual(rows[0]["straight.steps_per_s"], "7")
            self.assertEqual(rows[1]["straight.instructions_rhs"], "300")
            self.assertEqual(self.bench("--quick", "--load", "99").returncode, 0)
        self.assertEqual([row["straight.steps_per_s"] for row in self.history()], ["7", ""])  # busy: counts alone
        self.assertIn("<svg", self.read("results/steps-history.svg"))

    def test_results_that_depend_on_threads_or_solver_are_a_failure(self):
        self.place("cli/differ", "")
        self.place("cli/astray", "")
        done = self.bench("--quick")
        self.assertEqual(done.returncode, 1)
        self.assertIn("results differ between runs of huangjiahu (370, plane) with auto", done.stderr)
        self.assertIn("straight (space) with klu: 8002.0 N, not 8001.0 N", done.stderr)

    def test_a_program_that_fails_ends_it(self):
        self.place("cli/hawser", "#!/bin/sh\nexit 3\n")
        self.assertNotEqual(self.bench("--quick").returncode, 0)
        self.assertFalse(os.path.exists(self.path("results/steps.csv")))


if __name__ == "__main__":
    unittest.main()
