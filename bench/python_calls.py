#!/usr/bin/env python3
"""What Python adds to C: the overhead of a call of a step loop, and huangjiahu from Python beside the command.

Usage: PYTHONPATH=build/release/python/package /usr/bin/python3 bench/python_calls.py build/release/cli/hawser [ROUNDS]
Prints medians in microseconds, and the ratio of the two runs' times in one run, each the least of ROUNDS (default 15) taken in turns.
"""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import hawser

ROOT = pathlib.Path(__file__).resolve().parents[1]
HUANGJIAHU = str(ROOT / "cases" / "huangjiahu.yaml")


def median_us(call, n=5000):
    """Of n calls, one by one; the clock's own cost taken off."""
    def one(what):
        start = time.perf_counter()
        what()
        return time.perf_counter() - start

    nothing = statistics.median(one(lambda: None) for _ in range(n))
    return 1e6 * (statistics.median(one(call) for _ in range(n)) - nothing)


def calls():
    """{call: microseconds}. C has nothing to do in the first two: what is left is the call itself."""
    simulation = hawser.Simulation(str(ROOT / "tests" / "data" / "cli-pull.yaml"))
    simulation.advance(1.0)
    found = {"advance to where it is": median_us(lambda: simulation.advance(1.0)),
             "step to where it is": median_us(lambda: simulation.step(1.0)), "time": median_us(lambda: simulation.time),
             "sample, with C's work for 20 segments": median_us(simulation.sample)}
    look = simulation.sample()
    return {**found, "a number of a sample": median_us(lambda: look.winch_force),
            "an array of a sample": median_us(lambda: look.position)}


def timed(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def huangjiahu(program, rounds):
    """The command's whole process beside a run in a Python that is there already; both write their results."""
    def by_command(folder):
        subprocess.run([program, "run", HUANGJIAHU, "-q", "-o", folder], check=True)

    command, python = [], []
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as scratch:
            command.append(timed(lambda: by_command(f"{scratch}/command")))
            python.append(timed(lambda: hawser.run(HUANGJIAHU, out=f"{scratch}/python")))
    return min(command), min(python)


def main(program, rounds="15"):
    for name, us in calls().items():
        print(f"{name:40} {us:8.2f} us")
    command, python = huangjiahu(program, int(rounds))
    print(f"huangjiahu, the command                  {1e3 * command:8.1f} ms")
    print(f"huangjiahu, hawser.run                   {1e3 * python:8.1f} ms   ratio {python / command:.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
