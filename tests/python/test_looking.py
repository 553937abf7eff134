"""A close look between two steps: contacts, the cable, envelopes, what stands around, the route."""
from __future__ import annotations

import hawser
import numpy as np
import pytest
from conftest import DATA


@pytest.fixture(scope="module")
def running() -> hawser.Simulation:
    simulation = hawser.Simulation(DATA / "picture.yaml")
    simulation.watch_envelope()
    simulation.run_quietly()
    return simulation


def test_contacts_are_in_balance_with_what_they_carry(pull):
    simulation = hawser.Simulation(pull)
    simulation.relax()
    simulation.advance(2.0)
    contacts = simulation.contacts
    assert set(contacts["partner"]) == {"roller"} and (contacts["gap_m"] < 0).all()
    assert contacts["force_z_N"].sum() == pytest.approx(200 * 9.81, rel=0.02)  # the cable's weight
    by_roller = contacts.groupby("index")["force_z_N"].sum()
    assert by_roller.to_numpy() == pytest.approx(-simulation.sample().roller_force[by_roller.index, 2], rel=1e-9)
    normal = contacts[["normal_x", "normal_y", "normal_z"]].to_numpy()
    assert np.linalg.norm(normal, axis=1) == pytest.approx(np.ones(len(normal)))
    assert contacts["slip_m_per_s"].to_numpy() == pytest.approx(np.full(len(normal), 0.1), rel=0.05)


def test_contacts_of_other_kinds(running):
    assert {"roller", "surface"} <= set(running.contacts["partner"])


def test_the_cable_joint_by_joint(running):
    look, cable = running.sample(), running.cable
    assert cable.index.name == "joint" and len(cable) == look.active + 1
    assert cable["tension_N"].to_numpy()[1:-1] == pytest.approx(look.tension[1:-1], rel=1e-6, abs=1e-6)
    assert cable["curvature_per_m"].to_numpy()[1:-1] == pytest.approx(look.curvature[1:-1], rel=1e-9)
    assert cable["from_tail_m"].is_monotonic_increasing and cable["from_tail_m"].iloc[-1] == pytest.approx(13.5)
    middle = cable[["position_x_m", "position_y_m"]].to_numpy()
    assert np.linalg.norm(np.diff(middle, axis=0), axis=1) == pytest.approx(np.diff(cable["from_tail_m"]), rel=0.02)


def test_the_envelope(running):
    for table in (running.envelope(), running.envelope(along_route=False)):
        known = table.dropna()
        assert len(known) > 20
        for name in ("tension_{}_N", "curvature_{}_per_m", "sidewall_{}_N_per_m"):
            least, mean, largest = (known[name.format(kind)] for kind in ("least", "mean", "largest"))
            assert (least <= mean + 1e-9).all() and (mean <= largest + 1e-9).all()
    with pytest.raises(hawser.CaseError):
        hawser.Simulation(DATA / "picture.yaml").envelope()


def test_what_stands_around(running):
    around = running.geometry
    assert list(around.surfaces["name"]) == ["duct", "ground"] and around.surfaces["diameter_m"][0] == pytest.approx(0.064)
    assert {"roller", "box"} <= set(around.rollers["kind"]) and list(around.conveyors["name"]) == ["pusher"]
    assert around.length_m.sum() == pytest.approx(13.5) and around.diameter_m[0] == pytest.approx(0.06)
    assert around.winch is not None and around.reel is None
    assert np.linalg.norm(around.winch["direction"]) == pytest.approx(1)
    assert around.lines[0].shape[1] == 3 and not around.lines[0].flags.writeable


def test_the_route(running):
    assert running.route_length == pytest.approx(6 + 1.5 * np.pi + 5)
    bend = running.route_at(np.linspace(6.5, 10, 8))
    assert np.linalg.norm(bend["curvature"], axis=1) == pytest.approx(np.full(8, 1 / 3))
    assert bend["position"].shape == (8, 3)
    assert (bend["tangent"] * bend["curvature"]).sum(axis=1) == pytest.approx(np.zeros(8), abs=1e-12)
    assert running.route_at(1.0)["tangent"] == pytest.approx([1, 0, 0])
    with pytest.raises(hawser.CaseError):
        running.route_at(float("nan"))
