"""hawser simulates how a power cable is pulled through a tunnel, a duct or over rollers, and says whether the pull is safe.

    import hawser
    result = hawser.run("case.yaml", set={"friction.mu": 0.3}, progress=True)
    print(result.verdict, result.stations, sep="\\n")

SI units throughout: m, kg, s, N, rad; the names of columns end in theirs. docs/python.md has more.
"""
from hawser._declared import VERSION as __version__
from hawser.case import Case, theory
from hawser.errors import CaseError, Error, OutputError, RunError, Stopped
from hawser.results import Figure, Result, Verdict, compare
from hawser.simulation import Progress, Relaxation, Sample, Simulation, run
from hawser.calculation import Theory

__all__ = ["Case", "CaseError", "Error", "Figure", "OutputError", "Progress", "Relaxation", "Result", "RunError", "Sample",
           "Simulation", "Stopped", "Theory", "Verdict", "__version__", "compare", "run", "theory"]
