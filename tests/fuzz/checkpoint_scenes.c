#include "tests/fuzz/checkpoint_scenes.h"

#define CABLE "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
#define SOFT  "cables: {c: {EA: 1 MN, GA: 400 kN, GJ: 5 N m2, EI: 5 N m2, d: 50 mm, mass: 2 kg/m, damping: 5 ms}}\n"

const CheckpointScene checkpoint_scenes[CHECKPOINT_SCENES] = {
    {"in the plane",
     CABLE "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
           "rollers: {along: {from: 0 m, to: 6 m, spacing: 1 m}}\n"
           "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 1 kN, ramp: none}}\n"
           "run: {duration: 2 s}\n",
     12},
    {"in space: rollers that spin, a conveyor, a plane with friction that sticks",
     CABLE "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
           "rollers: {along: {from: 0 m, to: 6 m, spacing: 2 m, spin: {inertia: 0.1 kg m2}}}\n"
           "conveyors: [{name: c, from: 1 m, to: 3 m, clamp: 200 N}]\n"
           "surfaces: {planes: [{name: ground, point: [0, 0, -50 mm], normal: [0, 0, 1]}]}\n"
           "friction: {mu: 0.3, law: stick}\n"
           "drive: {winch: {speed: 0.5 m/s, to: 1 s, trip: {force: 3 kN, restarts: 1}}}\n"
           "run: {duration: 2 s}\n",
     12},
    {"a reel that pays out",
     CABLE "chain: [{cable: c, length: 12 m, segment: 1 m}]\n"
           "route: {head_at: 3 m, pieces: [{straight: 6 m}]}\n"
           "reel: {distance: 3 m, barrel: 1.2 m, flange: 2 m, width: 1 m, inertia: 800 kg m2}\n"
           "drive: {winch: {speed: 0.5 m/s}}\n"
           "run: {duration: 2 s}\n",
     12},
    {"another integrator, another solver, a force that is held",
     CABLE "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
           "rollers: {along: {from: 0 m, to: 6 m, spacing: 1 m}}\n"
           "drive: {winch: {tension: {force: 500 N, to: 300 ms, speed_limit: 0.5 m/s}}}\n"
           "solver: {method: esdirk, linear_solver: klu, planar: off}\n"
           "run: {duration: 2 s}\n",
     12},
    {"several chains",
     CABLE "chain: [{cable: c, length: 3 m, segment: 1 m}]\n"
           "chains: {one: {}, two: {}}\n"
           "lay: {pattern: flat, spacing: 80 mm}\n"
           "route: {head_at: 3 m, pieces: [{straight: 5 m}]}\n"
           "surfaces: {planes: [{name: floor, point: [0 m, 0 m, -45 mm], normal: [0, 0, 1]}]}\n"
           "drive: {winch: {speed: 0.1 m/s, to: 1 s}, tail: {tension: 100 N}}\n"
           "solver: {passes: 1, planar: off}\n"
           "run: {duration: 1 s, steady_from: 0.5 s}\n",
     12},
    {"a duct and a tray around bends, an edge, a bell-mouth; friction that sticks",
     CABLE
     "chain: [{cable: c, length: 5 m, segment: 500 mm}]\n"
     "route: {head_at: 5 m, pieces: [{straight: 2 m}, {bend: 20 deg, radius: 4 m, plane: left}, {straight: 4 m}]}\n"
     "surfaces: {ducts: [{name: tube, to: 3 m, radius: 70 mm, place: resting}], trays: [{name: v, from: 3.5 m, "
     "section: v}]}\n"
     "obstacles: [{bell: tube, radius: 600 mm, end: exit}, {edge: bar, at: 4 m, offset: [0, 0, -60 mm], length: "
     "400 mm, radius: 10 mm}]\n"
     "friction: {mu: 0.3, law: stick}\n"
     "lead_in: {weight: carried}\n"
     "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 500 N, ramp: none}}\n"
     "run: {duration: 2 s}\n",
     12},
    {"a rope across itself",
     SOFT "chain: [{cable: c, length: 9 m, segment: 250 mm}]\n"
          "route: {pieces: [{straight: 2 m}, {bend: 90 deg, radius: 1 m, plane: left}, {bend: 6 deg, radius: 1 m, "
          "plane: up}, {bend: 90 deg, radius: 1 m, plane: left, grade: plane}, {bend: 90 deg, radius: 1 m, plane: "
          "left}, {straight: 2 m}]}\n"
          "surfaces: {planes: [{point: [0, 0, -30 mm], normal: [0, 0, 1]}]}\n"
          "contact: {cable_on_cable: true, cable_friction: {mu: 0.3}}\n"
          "friction: {mu: 0.4}\n"
          "run: {duration: 1 s}\n"
          "solver: {relax: false}\n",
     80},
    {"a drum with its turns in contact",
     SOFT "chain: [{cable: c, length: 5 m, segment: 125 mm}]\n"
          "route: {head_at: 1.5 m, pieces: [{straight: 3 m}]}\n"
          "reel: {model: contact, distance: 1 m, barrel: 500 mm, flange: 1.2 m, width: 400 mm, inertia: 5 kg m2, "
          "brake: {torque: 100 N m}}\n"
          "surfaces: {trays: [{from: 0 m, to: 3 m, width: 400 mm, friction: {mu: 0.02}}]}\n"
          "contact: {geometry: cylinder, k: 1e7 N/m^1.5, c: 2 kN s/m, d: 1 mm, cable_on_cable: true}\n"
          "friction: {mu: 0.3, v_s: 5 mm/s, v_d: 10 mm/s}\n"
          "drive: {winch: {speed: 0.2 m/s, to: 1 s}}\n"
          "run: {duration: 2 s}\n"
          "solver: {relax: false}\n",
     20},
    {"positions in steady motion",
     CABLE "chain: [{cable: c, length: 6 m, segment: 500 mm}]\n"
           "route: {head_at: 6 m, pieces: [{straight: 20 m}]}\n"
           "rollers: {along: {spacing: 1 m}}\n"
           "lead_in: {weight: carried}\n"
           "drive: {winch: {speed: 0.5 m/s, to: 200 ms}, tail: {tension: 500 N, ramp: none}}\n"
           "solver: {motion: quasi-static, passes: 1}\n"
           "run: {duration: 20 s, steady_from: 5 s}\n",
     400},
    {"a winch that has tripped, a jam, what a script says",
     CABLE "chain: [{cable: c, length: 5 m, segment: 1 m}]\n"
           "route: {head_at: 5 m, pieces: [{straight: 9 m}]}\n"
           "rollers: {along: {spacing: 1 m, spin: {inertia: 0.1 kg m2}}}\n"
           "conveyors: [{name: K, from: 2 m, to: 3 m, clamp: 500 N, belt: {table: [[0, 0], [1 s, 0.3 m/s]]}}]\n"
           "jams: [{what: R3, at: 50 ms, release: 400 ms}]\n"
           "drive:\n"
           "  winch: {speed: 0.5 m/s, to: 100 ms, trip: {force: 1.2 kN, restarts: 3, brake: 100 ms, pause: 100 ms, "
           "ramp: 200 ms}}\n"
           "  tail: {tension: 1 kN, ramp: none}\n"
           "  script:\n"
           "    - {at: 10 ms, do: force, place: 2 m, force: [0, 50 N, 10 N], moment: [1, 0, 0], follows: true}\n"
           "    - {at: 20 ms, do: friction, of: R4, factor: 0.5}\n"
           "    - {at: 30 ms, do: conveyor_speed, of: K, speed: 0.1 m/s}\n"
           "    - {at: 40 ms, do: conveyor_clamp, of: K, clamp: 200 N}\n"
           "    - {at: 200 ms, do: winch_pause}\n"
           "    - {at: 900 ms, do: winch_restart}\n"
           "run: {duration: 2 s}\n",
     80},
    {"towed in water",
     "cables: {c: {d: 60 mm, EA: 40 MN, GA: 15 MN, GJ: 2 kN m2, EI: 500 N m2, mass: 9 kg/m}}\n"
     "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
     "rod: {shape: straight, slope: -70 deg, tail: {fixing: pinned, motion: [{direction: [-1, 0, 0], move: 3 m, ramp: "
     "step, from: 0 s, to: 2 s}]}}\n"
     "medium: {density: 1025 kg/m3, velocity: [0.8 m/s, 0, 0]}\n"
     "launch: {table: [[0 m, 0, 0, 0], [6 m, 0, 300 mm/s, 0]]}\n"
     "run: {duration: 2 s}\n",
     12},
    {"flies, spins, lands",
     SOFT "chain: [{cable: c, length: 3 m, segment: 500 mm}]\n"
          "rod: {start: [0, 0, 30 mm], tail: {fixing: free}, head: {fixing: free}}\n"
          "medium: {density: 1.2 kg/m3}\n"
          "launch: {velocity: [1 m/s, 0, 0], spin: [0, 0, 2 rad/s]}\n"
          "surfaces: {planes: [{point: [0, 0, 0], normal: [0, 0, 1]}]}\n"
          "solver: {relax: false}\n"
          "run: {duration: 1 s}\n",
     30},
    {"rollers with motors, and on mounts",
     CABLE
     "chain: [{cable: c, length: 5 m, segment: 500 mm}]\n"
     "route: {head_at: 5 m, pieces: [{straight: 8 m}]}\n"
     "rollers:\n"
     "  along:\n"
     "    - {name: M, spacing: 2 m, profile: v, spin: {inertia: 0.1 kg m2, motor: {torque: 6 N m, to: 200 ms, "
     "speed_limit: 0.4 m/s}}}\n"
     "    - {name: S, from: 1 m, spacing: 2 m, mount: {stiffness: [100 kN/m, 100 kN/m, 200 kN/m, 4.5 kN m/rad, 4.5 "
     "kN m/rad, 4.5 kN m/rad], mass: 25 kg, inertia: 0.5 kg m2}}\n"
     "contact: {reach: 1 m}\n"
     "drive: {winch: {speed: 0.3 m/s, to: 200 ms, grip: axial}, tail: {tension: 300 N, ramp: none}}\n"
     "run: {duration: 2 s}\n",
     20},
    {"a drum that brakes, and a rope taken in",
     "cables:\n"
     "  c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 90 mm, mass: 20 kg/m}\n"
     "  r: {d: 14 mm, EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 50 N m2, mass: 0.7 kg/m, damping: 20 ms}\n"
     "chain: [{cable: c, length: 12 m, segment: 1 m}, {cable: r, length: 4 m, segment: 500 mm, swivel: true}]\n"
     "route: {head_at: 3 m, pieces: [{straight: 7 m}]}\n"
     "reel: {distance: 3 m, barrel: 1.2 m, flange: 2 m, width: 1 m, inertia: 300 kg m2, brake: {law: speed, torque: "
     "400 "
     "N m, speed: 0.4 m/s, to: 500 ms}, back_tension: {table: [[0, 100 N], [1 s, 300 N]]}}\n"
     "rollers: {along: {spacing: 1 m}}\n"
     "drive: {winch: {speed: 0.5 m/s, to: 300 ms, take_in: true}}\n"
     "run: {duration: 6 s, steady_from: 4 s}\n",
     80},
    {"bends with hysteresis",
     "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, d: 90 mm, mass: 20 kg/m, bending: {table: [[0.03, 360], [0.1, "
     "570], "
     "[0.571, 947]]}}}\n"
     "chain: [{cable: c, length: 4 m, segment: 500 mm}]\n"
     "route: {head_at: 4 m, pieces: [{straight: 2 m}, {bend: 25 deg, radius: 3 m, plane: up}, {straight: 3 m}]}\n"
     "rollers: {along: {spacing: 500 mm}}\n"
     "drive: {winch: {speed: 0.5 m/s, to: 300 ms}, tail: {tension: 1 kN, ramp: none}}\n"
     "run: {duration: 2 s}\n",
     20},
    {"a column that buckles, step by step",
     "gravity: 0 m/s2\n"
     "cables: {c: {d: 2 mm, EA: 1e7 N, GA: 1e7 N, GJ: 100 N m2, EI: 100 N m2, mass: 1 kg/m}}\n"
     "chain: [{cable: c, length: 1 m, segment: 100 mm}]\n"
     "rod: {tail: {fixing: pinned}, head: {fixing: held, hold: [shear_y, shear_z]}, loads: [{direction: [-1, 0, 0], "
     "force: "
     "2000 N}, {at: 500 mm, direction: [0, 0, 1], force: 1 nN}]}\n"
     "run: {analysis: static, load_steps: 20}\n"
     "output: {probes: [{name: mid, at: 500 mm}]}\n",
     4}};
