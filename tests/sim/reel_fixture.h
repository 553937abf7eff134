/* A pull from a reel, made in code: a level row of rollers, the cable behind its start on a drum, a rope along the
 * whole row to the winch. */
#ifndef HAWSER_TESTS_SIM_REEL_FIXTURE_H
#define HAWSER_TESTS_SIM_REEL_FIXTURE_H

#include "tests/sim/scene_fixture.h"

/* Zeros: the whole cable lies there from the start, the rope runs on. */
typedef struct ReelChoice {
    int payout, take_in;
    double cable, rope; /* m; 0: 20 and 10 */
    double head_at;     /* m; 0: 6 */
    double inertia;     /* kg m2; 0: 40 */
    BrakeLaw brake;
    double torque, at_speed; /* N m, m/s */
    double bearing;          /* N m */
    double tension;          /* N, back tension, through STEP over the first second */
    double speed;            /* m/s of the winch; 0: 0.2 */
    double accuracy;         /* 0: the default */
    double mu;               /* < 0: none; 0: 0.2 */
    int segments_per_metre;  /* 0: 2 */
    int fixed;
} ReelChoice;

static inline double reel_or(double value, double otherwise) { return value > 0 ? value : otherwise; }

static inline void reel_rollers(SceneDef *def, double length)
{
    const int count = (int)length + 1;
    def->rollers = fixture_array(count, sizeof *def->rollers);
    for (int k = 0; k < count; ++k) {
        def->rollers[def->n_rollers++] = fixture_roller(def, v3(k + 0.25, 0, 0), v3(0, 0, -1), v3(0, 1, 0));
    }
}

static inline void reel_drum(SceneDef *def, const ReelChoice *c)
{
    ReelDef *const r = &def->reel;
    r->distance = 4;
    r->barrel = 1.2;
    r->flange = 3;
    r->width = 0.5;
    r->inertia = reel_or(c->inertia, 40);
    r->brake = c->brake;
    r->torque = c->torque;
    r->at_speed = reel_or(c->at_speed, 0.2);
    r->speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = reel_or(c->at_speed, 0.2)};
    r->bearing = c->bearing;
    r->end_fixed = c->fixed;
    r->model = c->payout ? REEL_PAYOUT : REEL_NONE;
}

static inline void reel_pull(SceneDef *def, const ReelChoice *c)
{
    const double cable = reel_or(c->cable, 20), rope = reel_or(c->rope, 10), head = reel_or(c->head_at, 6);
    const int per_metre = c->segments_per_metre ? c->segments_per_metre : 2;
    scene_def_defaults(def);
    def->n_cables = def->n_pieces = 2;
    def->cables = fixture_array(2, sizeof *def->cables);
    def->pieces = fixture_array(2, sizeof *def->pieces);
    def->cables[0] = fixture_cable(0.5, 12, 0.08);
    def->cables[1] = fixture_cable(0.3, 1.5, 0.03);
    def->cables[1].damping = 0.02;
    def->pieces[0] = (ChainPieceDef){.cable = 0, .length = cable, .segments = (int)(per_metre * cable)};
    def->pieces[1] = (ChainPieceDef){.cable = 1, .length = rope, .segments = (int)(per_metre * rope), .swivel = 1};
    def->n_route = 1;
    def->route = fixture_array(1, sizeof *def->route);
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = head + rope};
    def->head_at = head;
    def->lead_in = (LeadInDef){.present = 1, .carries_weight = 1, .blend = 0.5};
    def->winch = (WinchDef){.present = 1,
                            .axial_only = 1,
                            .take_in = c->take_in,
                            .at = NAN,
                            .speed = {.kind = PROFILE_STEP, .t1 = 3, .v1 = reel_or(c->speed, 0.2)}};
    def->tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = c->tension};
    if (!(c->mu > 0) && c->mu < 0) def->friction.mu_s = def->friction.mu_d = 0;
    if (c->mu > 0) def->friction.mu_s = def->friction.mu_d = c->mu;
    reel_drum(def, c);
    reel_rollers(def, head + rope);
    if (c->accuracy > 0) def->solver.accuracy = c->accuracy;
    def->duration = 10;
    def->output.steady_from = 5;
}

#endif
