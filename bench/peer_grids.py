"""Which programs bench/peers.py compares, and the settings of each that its sweep tries.

A setting is the words KEY=VALUE of the program (the comment at the top of bench/peers/peer_NAME says what they are).
"""
import itertools


class Peer:
    """A program bench/peers/peer_NAME.

    sweep: {problem: settings, all tried at the smallest size}; quick: one or two a problem;
    keep: {size: how many of the best settings at the size before go on to it}; limit: {size: s of processor time a run};
    aside: {problem: settings that run at every size without being chosen}: fast ones whose error is not held;
    program: the NAME of another peer whose program this one is, with settings of another kind."""

    def __init__(self, name, title, package, sweep, quick, keep=None, limit=None, program=None, aside=None):
        self.program, self.aside = program or name, aside or {}
        self.name, self.title, self.package = name, title, package
        self.sweep, self.quick, self.keep, self.limit = sweep, quick, keep or {}, limit or {}


def grid(**axes):
    """All combinations of the values, as settings: grid(a=[1, 2], b=["x"]) -> ['a=1 b=x', 'a=2 b=x']."""
    names = list(axes)
    return [" ".join(f"{name}={value}" for name, value in zip(names, values))
            for values in itertools.product(*axes.values())]


HAWSER = Peer("hawser", "hawser", None,
              {"straight": ["", "accuracy=1e-4", "accuracy=1e-2", "accuracy=1e-2 interval=1", "method=esdirk accuracy=1e-2 interval=1"],
               "hang": ["stiff=100", "stiff=100 accuracy=1e-4"],
               "swing": ["stiff=100", "stiff=100 accuracy=1e-4", "stiff=100 accuracy=1e-2",
                         *grid(stiff=[100], method=["esdirk"], accuracy=["1e-1", "1e-2", "1e-3"])]},
              {"straight": [""], "hang": ["stiff=100"], "swing": ["stiff=100"]})
# The pull: single bodies allow the longest steps, since nothing in them is explicit; longer trees have explicit bending
# springs. Springs in place of constraints are the plain explicit method.
MUJOCO = Peer("mujoco", "MuJoCo", "libmujoco-dev",
              {"straight": [
                  *grid(piece=[1], dt=["1e-2"], solver=["CG"], impedance=["0.99", "0.999"],
                        contact_time=["0.02", "0.1"]),
                  *grid(piece=[1], dt=["5e-3"], solver=["CG"], impedance=["0.99", "0.999"], contact_time=["0.02", "0.1"]),
                  *grid(piece=[1], dt=["2e-3"], solver=["CG"], contact_time=["5e-3", "0.05"]),
                  *grid(piece=[1], dt=["1e-2", "4e-3"], solver=["Newton"], impedance=["0.99", "0.999"],
                        contact_time=["0.02", "0.1"]),
                  *grid(piece=[1], dt=["6e-3", "5e-3"], solver=["Newton"], impedance=["0.999"],
                        contact_time=["0.012", "0.02"]),
                  *grid(piece=[20, 60], dt=["1e-3", "5e-4"], solver=["Newton", "PGS", "CG"]),
                  "piece=1 dt=5e-3 solver=CG impedance=0.999 contact_time=0.1 cone=pyramidal",
                  "piece=1 dt=5e-3 solver=CG impedance=0.999 contact_time=0.1 tolerance=1e-6",
                  "piece=1 dt=5e-3 solver=CG impedance=0.999 contact_time=0.1 integrator=RK4",
                  "piece=1 dt=5e-3 solver=PGS impedance=0.999 contact_time=0.1",
                  "as=springs dt=4e-5 damping=5e-6 solver=PGS",
                  *grid(**{"as": ["springs"]}, dt=["2e-4", "3e-4"], damping=["1e-4"], stiff=["0.01"], solver=["PGS"])],
               "hang": [*grid(piece=[1, 10, 60], dt=["5e-3", "2e-3", "1e-3"], impedance=["0.99", "0.9999"])],
               "swing": [*grid(piece=[1], dt=["2e-3", "5e-4"], solver=["Newton", "CG"]),
                         *grid(piece=[10], dt=["5e-3", "2e-3", "1e-3", "5e-4"], solver=["PGS", "Newton"]),
                         *grid(piece=[30, 60], dt=["5e-3", "2e-3", "1e-3"]),
                         "piece=30 dt=1e-3 joints=ball", "piece=30 dt=2e-3 integrator=RK4",
                         "piece=30 dt=1e-3 impedance=0.9999",
                         "as=springs dt=1e-4 damping=1e-5 stiff=0.1"]},
              {"straight": ["piece=1 dt=1e-2 solver=CG", "piece=60 dt=1e-3"],
               "hang": ["piece=10", "as=springs dt=2e-5 damping=1e-5"],
               "swing": ["piece=10", "piece=1 joints=ball"]},
              keep={37: 10, 120: 6, 370: 3}, limit={12: 5, 37: 8, 120: 10, 370: 25},
              aside={"straight": ["piece=1 dt=1e-2 solver=CG impedance=0.999 contact_time=0.1",
                                  "piece=1 dt=1e-2 solver=CG impedance=0.999 contact_time=0.05"]})
# Simbody by its own Integrator classes: their CPodes has a dense matrix, the others are explicit.
SIMBODY = Peer("simbody", "Simbody, its integrators", "libsimbody-dev",
               {"straight": [
                   *grid(form=["pins"], integrator=["cpodes"], accuracy=["1e-1", "1e-2", "1e-3"]),
                   *grid(form=["free3", "free6", "plane"], integrator=["cpodes"], accuracy=["1e-1", "1e-2"]),
                   *grid(form=["pins"], integrator=["semi"], step=["1e-4", "1.5e-4"]),
                   *grid(form=["pins"], integrator=["rk2", "verlet"], step=["2e-4"]),
                   *grid(form=["pins"], integrator=["rk3"], step=["2e-4", "3e-4"]),
                   *grid(form=["pins"], integrator=["merson", "semi2"], accuracy=["1e-1", "1e-2"]),
                   "form=pins integrator=adams accuracy=1e-2", "form=plane integrator=semi step=1e-5"],
                "hang": [*grid(form=["links"], integrator=["cpodes", "merson"], accuracy=["1e-2", "1e-3"]),
                         "form=free6 integrator=cpodes accuracy=1e-2"],
                "swing": [*grid(form=["links"], integrator=["cpodes", "merson", "rk3", "semi2"],
                                accuracy=["1e-2", "1e-3", "1e-4"]),
                          *grid(form=["links"], integrator=["verlet", "semi"], step=["2e-3", "5e-4"]),
                          "form=free6 integrator=cpodes accuracy=1e-2"]},
               {"straight": ["form=pins integrator=cpodes", "form=pins integrator=semi step=1e-4 settle=0.05"],
                "hang": ["form=links integrator=cpodes"], "swing": ["form=links integrator=merson"]},
               keep={37: 6, 120: 4, 370: 2}, limit={12: 4, 37: 8, 120: 20, 370: 60})
# The same models with CPodes called past those classes, with a band matrix.
BAND = Peer("simbody-band", "Simbody, CPodes with a band", "libsimbody-dev",
            {"straight": [*grid(form=["plane", "free3", "free6"], accuracy=["3e-3", "1e-3", "3e-4", "1e-4", "1e-5"]),
                          *grid(form=["plane", "free3"], accuracy=["1e-3"], step=["0.02"])],
             "hang": [*grid(form=["free6"], accuracy=["1e-2", "1e-3", "1e-4"], stiff=["100"], settle=["0", "0.1"]),
                      "form=free6 accuracy=1e-3 stiff=1"],
             "swing": [*grid(form=["free6"], accuracy=["1e-3", "1e-4", "1e-5"], stiff=["1", "100"])]},
            {"straight": ["form=plane", "form=free3", "form=free6"], "hang": [""], "swing": [""]},
            keep={37: 6, 120: 5, 370: 4}, limit={12: 4, 37: 6, 120: 12, 370: 25}, program="simbody")
