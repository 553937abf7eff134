#include "sim/watch/trust.h"

#include <stdarg.h>
#include <stdio.h>

#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/watch/events.h"
#include "sim/watch/stats.h"

/* What is allowed: figures of docs/limits.md, "Trust". */
static const double ENERGY = 0.01, MOMENTUM = 0.01; /* shares of what goes through, of the largest impulse */
static const double OFF_ROUTE = 2;                  /* m: more than any sag between supports */
static const double SAGITTA = 2.2;                  /* of the room in a duct: a chord's height over it */
static const double SLOWEST = 1;                    /* speed of full friction over that of the pull */
static const double DRIFT = 0.05;                   /* of the mean pull, from the window's first half to its second */
static const double SPIKE = 0.2;                    /* of the largest pull, above the rows beside it */
enum { LOOKS = 16 };                                /* at the cable's place in a run */

void stray_record(Stray *stray, const Scene *scene, const Kinematics *kin, double travel, double t)
{
    if (scene->rod->present || (t < stray->due && t < scene->def.duration)) return;
    stray->due = t + scene->def.duration / LOOKS;
    for (int i = 0; i < scene->chain.n; ++i) {
        const Vec3 p = v3_axpy(v3_load(kin->p, i), -scene->chain.half[i], v3_load(kin->a, i)); /* joint i */
        const double s = along_joint(scene, kin, travel, i);
        if (s < 0 || s > scene->route.length) continue;
        const double away = v3_norm(v3_sub(p, route_at(&scene->route, s).position));
        if (away <= stray->farthest) continue;
        stray->farthest = away;
        stray->at = s;
    }
}

/* ------------------------------------------------------------------------------------------------- conditions */

typedef struct List {
    hawser_condition *out;
    int n;
} List;

static void add(List *list, const char *name, const char *unit, double value, double allowed, const char *format, ...)
    __attribute__((format(printf, 6, 7)));

/* A condition that holds where value <= allowed; what to say and to do otherwise. */
static void add(List *list, const char *name, const char *unit, double value, double allowed, const char *format, ...)
{
    hawser_condition *const c = &list->out[list->n++];
    va_list args;
    *c = (hawser_condition){.name = name, .unit = unit, .value = value, .allowed = allowed, .holds = value <= allowed};
    va_start(args, format);
    vsnprintf(c->remedy, sizeof c->remedy, format, args);
    va_end(args);
}

/* The chord of a segment in a bend of a duct is higher than the duct has room: the cable jams by its mesh alone. */
static void add_duct_mesh(List *list, const Scene *scene)
{
    double worst = 0, tight = 0, enough = 0, longest = 0; /* 1; m, m: the room there, and what would fit it; m */
    for (int i = 0; i < scene->eye - scene->first && i < scene->chain.n; ++i)
        longest = fmax(longest, 2 * scene->chain.half[i]);
    for (int k = 0; k < scene->def.n_surfaces; ++k) {
        const SurfaceShape *const duct = &scene->def.surfaces[k].shape;
        if (duct->kind != SURFACE_DUCT) continue;
        for (int b = 0; b < scene->route.n; ++b) {
            const RoutePiece *const piece = &scene->route.piece[b];
            const int inside = piece->s0 < duct->to && piece->s0 + piece->length > duct->from;
            if (piece->kind != ROUTE_BEND || !inside) continue;
            const double room = duct->radius - duct->cable_radius;
            const double sagitta = longest * longest / (8 * piece->radius);
            if (!(sagitta > worst * room)) continue;
            worst = sagitta / room;
            tight = room;
            enough = sqrt(SAGITTA * room * 8 * piece->radius);
        }
    }
    if (worst > 0) {
        add(list, "mesh_in_ducts", "1", worst, SAGITTA,
            "segments are too long for bends in ducts with %.3g mm of room: set chain.segment to %.3g mm or less",
            1e3 * tight, 1e3 * enough);
    }
}

/* Below the speed at which friction is fully there the pull is too small. */
static void add_friction_speed(List *list, const Scene *scene)
{
    double slowest = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r) {
        const FrictionLaw *const law = &scene->contact.roller[r].friction;
        if (friction_kind(law) == FRICTION_SPEED) slowest = fmax(slowest, law->v_s);
    }
    for (int k = 0; k < scene->def.n_surfaces; ++k) {
        const FrictionLaw *const law = &scene->def.surfaces[k].friction;
        if (friction_kind(law) == FRICTION_SPEED) slowest = fmax(slowest, law->v_s);
    }
    if (slowest > 0 && scene->def.winch.present) {
        add(list, "friction_speed", "1", slowest / scene->largest_speed, SLOWEST,
            "the pull is slower than friction needs to come in: set friction.v_s below %.3g m/s",
            scene->largest_speed / 5);
    }
}

/* Means of a window in which the pull still changes, and a peak that is none of the pull's, are figures of nothing. A
 * chain that begins at rest and is set in motion gently has no jolt. */
static void add_steadiness(List *list, const TrustFacts *f)
{
    const Steadiness *const s = f->steadiness;
    const int jumps = s->speed > 0, rests = f->scene->def.solver.relax && f->relaxation->reached;
    const double drift = steadiness_drift(s);
    add(list, "steady", "1", drift, DRIFT,
        "the pull changes by %.2g %% within the steady window: set run.steady_from to where it has settled, or "
        "run.duration to more",
        100 * drift);
    if (!rests || jumps) {
        add(list, "start_jolt", "1", fmax(s->jolt, 0) / fmax(s->later, 1e-6), 1,
            "the largest pull is the jolt of the start, at %.3g s: %s", s->jolt_at,
            jumps ? "give the winch a ramp (drive.winch.ramp)" : "let the cable come to rest first (solver.relax)");
    }
    double at;
    const double spike = steadiness_spike(s, &at);
    add(list, "peak", "1", spike, SPIKE,
        "the largest pull is a spike, %.2g %% above the rows beside it, at %.4g s: set output.interval to less, or "
        "start "
        "more gently",
        100 * spike, at);
}

int trust_judge(const TrustFacts *f, hawser_condition *out)
{
    const Scene *const scene = f->scene;
    const int dynamic = scene->def.analysis.kind == ANALYSIS_DYNAMICS;
    List list = {out, 0};
    add(&list, "finished", "s", fmax(0, f->end - f->t), 1e-9 * f->end,
        "the run ended at %.4g s of %.4g s: its figures are of no steady pull", f->t, f->end);
    if (dynamic && !scene->rod->present) {
        add(&list, "steady_window", "s", scene->def.output.steady_from, f->t,
            "the steady window was never reached: it begins at %.4g s (run.steady_from)",
            scene->def.output.steady_from);
    }
    if (dynamic && scene->def.winch.present) add_steadiness(&list, f);
    if (scene->def.solver.relax && f->relaxation->tolerance_N > 0) {
        add(&list, "equilibrium", "N", f->relaxation->residual_N, f->relaxation->tolerance_N,
            "no equilibrium was found before t = 0 (segment %d is the worst): see that everything is supported",
            f->relaxation->segment);
    }
    if (f->balance) {
        add(&list, "energy", "1", f->balance->residual_share, ENERGY,
            "energy does not add up by %.2g %% of what goes through '%s': try a smaller solver.accuracy",
            100 * f->balance->residual_share, f->balance->turnover_of);
        add(&list, "momentum", "1", f->balance->impulse_residual_share, MOMENTUM,
            "momentum does not add up by %.2g %%: try a smaller solver.accuracy",
            100 * f->balance->impulse_residual_share);
    }
    if (dynamic && !scene->rod->present) {
        add(&list, "on_route", "m", f->stray.farthest, OFF_ROUTE,
            "the cable was %.3g m off its route near %.4g m: it has fallen, or nothing guides it there",
            f->stray.farthest, f->stray.at);
    }
    add(&list, "orientation", "1", f->turned, 0, "%s",
        f->turned & TURNED_HEAD ? "the head has turned away from the pull: use drive.winch.grip: clamp"
                                : "joints have turned too far for the chain to follow: use shorter segments");
    if (scene->def.theory.cables > 1) {
        add(&list, "bundle", "1", scene->def.theory.cables, 1,
            "theory.cables is %d, but the run pulls one cable: give it the bundle's mass, stiffness and friction, or "
            "judge "
            "by `hawser theory`",
            scene->def.theory.cables);
    }
    add_duct_mesh(&list, scene);
    add_friction_speed(&list, scene);
    return list.n;
}
