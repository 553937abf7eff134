"""hawser simulates how a power cable is pulled through a tunnel, a duct or over rollers, and says whether the pull is safe.

    import hawser
    result = hawser.run("case.yaml", set={"friction.mu": 0.3}, progress=True)
    print(result.verdict, result.stations, sep="\\n")

SI units throughout: m, kg, s, N, rad; the names of columns end in theirs. docs/guide/python.md has more.
"""
from hawser._declared import VERSION as __version__
from hawser._callbacks import Event, Progress, Segment
from hawser.alignment import Route, routes
from hawser.calculation import Theory
from hawser.case import Case, theory
from hawser.catalogue import library, schema
from hawser.certificate import Certificate, certify
from hawser.errors import CaseError, Error, MissingError, OutputError, RunError, Stopped
from hawser.jobs import Job, job
from hawser.looking import Geometry
from hawser.results import Figure, Result, Verdict, compare
from hawser.sample import Sample
from hawser.simulation import Relaxation, Simulation, resume, run
from hawser.studies import Study, study
from hawser.things import Conveyor, Machine, Roller, Surface, Winch

__all__ = ["Case", "CaseError", "Certificate", "Conveyor", "Error", "Event", "Figure", "Geometry", "Job", "Machine", "MissingError", "OutputError", "Progress",
           "Relaxation", "Result", "Roller", "Route", "RunError", "Sample", "Segment", "Simulation", "Stopped", "Study", "Surface", "Theory", "Verdict",
           "Winch", "__version__", "certify", "compare", "job", "library", "resume", "routes", "run", "schema", "study", "theory"]
