"""Which programs bench/peers.py compares, and the settings of each that its sweep tries.

A setting is the words KEY=VALUE of the program (the comment at the top of bench/peers/peer_NAME says what they are).
"""
import itertools


class Peer:
    """A program bench/peers/peer_NAME. sweep: {problem: settings tried at the small sizes}; quick: one or two a problem."""

    def __init__(self, name, title, package, sweep, quick):
        self.name, self.title, self.package = name, title, package
        self.sweep, self.quick = sweep, quick


def grid(**axes):
    """All combinations of the values, as settings: grid(a=[1, 2], b=["x"]) -> ['a=1 b=x', 'a=2 b=x']."""
    names = list(axes)
    return [" ".join(f"{name}={value}" for name, value in zip(names, values))
            for values in itertools.product(*axes.values())]


HAWSER = Peer("hawser", "hawser", None,
              {"straight": ["", "accuracy=1e-4", "accuracy=1e-2"],
               "hang": ["stiff=100", "stiff=100 accuracy=1e-4"],
               "swing": ["stiff=100", "stiff=100 accuracy=1e-4", "stiff=100 accuracy=1e-2"]},
              {"straight": [""], "hang": ["stiff=100"], "swing": ["stiff=100"]})
MUJOCO = Peer("mujoco", "MuJoCo", "libmujoco-dev",
              {"straight": [], "hang": [], "swing": []},
              {"straight": [], "hang": [], "swing": []})
SIMBODY = Peer("simbody", "Simbody", "libsimbody-dev",
               {"straight": [], "hang": [], "swing": []},
               {"straight": [], "hang": [], "swing": []})
