/* Scenes set up to move: states in disorder, a scene with its workspace, Newton matrix and integrator, cables that
 * touch themselves, rods at their equilibria, and a pull that is run and recorded. */
#ifndef HAWSER_TESTS_SUPPORT_RIG_H
#define HAWSER_TESTS_SUPPORT_RIG_H

#include "sim/run/sim.h"
#include "sim/run/statics.h"
#include "sim/solve/integrator.h"
#include "sim/solve/newton.h"
#include "sim/solve/scales.h"
#include "tests/support/scene.h"

typedef struct Rig {
    Scene scene;
    Workspace ws;
    Newton newton;
    Spatial spatial;
    Integrator *integrator; /* made by the first rig_advance */
    int n, size;            /* segments; entries of the state, equipment included */
    double t, *y, *rate;    /* s; [size] */
    uint64_t seed;          /* of the test's random numbers */
} Rig;

/* Takes the definition; the chain lies on its route at rest. options: NULL for the definition's. */
Rig *rig_make(SceneDef *def, const LinOptions *options);
Rig *rig_free(Rig *r);

/* Searches the contact candidates of the state anew. */
void rig_refresh(Rig *r);
Motion *rig_motion(Rig *r);

/* Rates and Newton's blocks at (t, y) of the rig. */
void rig_linearise(Rig *r);

/* Largest |x - gamma J x - b| of each kind of entry over the size of the terms that cancel in it: those of x, b and
 * gamma J z with z the numbers of x in disorder. b is drawn, x is newton_solve's, J x the central difference of fourth
 * order of the rates along x, with steps that move no coordinate by more than 2 step. */
double rig_solve_error(Rig *r, double gamma, double step);

/* Integrates until time `to` (s). */
hawser_status rig_run(Rig *r, double to, hawser_error *err);
void rig_advance(Rig *r, double to);

static const double SELF_DIAMETER = 0.08; /* m */

/* n segments of h, free at both ends, with gravity g (m/s2, downward); soft: laws for finite differences. `more` (NULL:
 * nothing) has the last word on the definition. */
void self_rig_new(Rig *r, int n, double h, double g, int soft, Team *team, LinKind kind, void (*more)(SceneDef *));
void self_rig_free(Rig *r);

/* Segment i from a to b, at rest. */
void self_rig_place(Rig *r, int i, Vec3 a, Vec3 b);

/* Segments first .. first + count - 1 straight on from `start`. */
void self_rig_strand(Rig *r, int first, int count, Vec3 start, Vec3 direction);

/* All on a helix about z. */
void self_rig_helix(Rig *r, double radius, double pitch);

/* No joint between segments j-1 and j any more. */
void self_rig_cut(Rig *r, int j);
void self_rig_refresh(Rig *r);

/* Kinetic energy, J. */
double self_rig_kinetic(Rig *r);

/* The stage of a definition, which is taken apart. */
void rod_stage(SceneDef *def, Stage *stage);

/* The equilibria up to t = 1 s. */
void rod_solve(Stage *stage);

/* Front end of segment i. */
Vec3 rod_front(const Stage *stage, int i);

/* The mean pull from `from` to `until` (s) of a cable of n segments that is pulled off at 0.2 m/s. */
double payout_pull(int n, int turns, double from, double until);

/* Relaxes, pulls for `duration` (s) and records every 50 ms; the definition is taken apart. */
void pull_record(SceneDef *def, double duration, hawser_summary *out);

#endif
