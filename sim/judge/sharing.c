#include <math.h>
#include <string.h>

#include "sim/equipment/winch.h"
#include "sim/judge/trust.h"

static const double LENGTH = 1e-4; /* m: nobody knows where a cable lies, and no mesh, to less */
static const double SLIPS = 0.5;   /* of the time for which a belt has cable: if it slides for more, it slips */

/* m along the route, where the chain's head is at time t: as the winch has drawn it, or the belt, where it does not
 * slip. */
static double head_of(const Scene *scene, const ConveyorDef *c, double t)
{
    return scene->def.head_at +
           (scene->winch->present ? winch_travel(scene->winch, t) : profile_integral(&c->speed, t));
}

/* m/N by which the chain is longer under load from the belt's middle up to `to`, m along the route, at
 * time t. */
static double give_up_to(const Scene *scene, const ConveyorDef *c, double to, double t)
{
    const SceneDef *const def = &scene->def;
    const double from = (c->from + c->to) / 2;
    double end = head_of(scene, c, t), give = 0;
    for (int k = def->n_pieces - 1; k >= 0 && end > from; --k) {
        const double begin = end - def->pieces[k].length;
        give += fmax(0, fmin(end, to) - fmax(begin, from)) / def->cables[def->pieces[k].cable].ea;
        end = begin;
    }
    return give;
}

/* A figure of the run's, of a conveyor; 0 if there is none. */
static double figure_of(const ConveyorDef *c, const hawser_summary *s, const char *key)
{
    for (int i = 0; i < s->n_machines; ++i) {
        if (strcmp(s->machines[i].kind, "conveyors") || strcmp(s->machines[i].name, c->name)) continue;
        return hawser_machine_figure(&s->machines[i], key);
    }
    return 0;
}

/* N that a conveyor might push more than it does: up to its limit, also from where it holds back, or from one end of
 * its grip to the other. */
static double push_left(const ConveyorDef *c, const hawser_summary *s)
{
    if (!(c->limit > 0)) return 2 * c->mu * c->clamp;
    const double mean = figure_of(c, s, "steady_mean_N") / fmax(figure_of(c, s, "gripping"), 1e-9);
    return fmax(0, c->limit - mean); /* of the time for which it has cable */
}

/* Whether lengths decide what a belt pushes with: it keeps the winch's speed, or has one of its own that is so near to
 * it, or to that of other belts, that it does not slip. One that slips pushes with all it has. The window says so, of
 * the time for which the belt has cable: before that it does not slip. */
static int by_lengths(const ConveyorDef *c, const hawser_summary *s)
{
    const double held = figure_of(c, s, "gripping");
    if (!(held > 0)) return 0;
    return (c->sync && c->factor <= 1 && c->factor >= 1) || figure_of(c, s, "slipping") < SLIPS * held;
}

/* What shares a belt's pull with it: the winch, or without one the next belt ahead that lengths decide of, too. */
typedef struct Sharer {
    double at;             /* m along the route; NAN: nothing does */
    const char *of, *name; /* in words */
    double left;           /* N, that it might push more */
} Sharer;

static Sharer sharer_of(const Scene *scene, const ConveyorDef *c, const hawser_summary *s, double t)
{
    const SceneDef *const def = &scene->def;
    Sharer out = {.at = NAN};
    if (def->winch.present)
        return (Sharer){.at = head_of(scene, c, t), .of = "the winch", .name = "", .left = INFINITY};
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const other = &def->conveyors[i];
        const double at = (other->from + other->to) / 2;
        if (other->from < c->to || at >= out.at || !by_lengths(other, s)) continue;
        out = (Sharer){at, "conveyor ", other->name, push_left(other, s)};
    }
    return out;
}

/* N, of what such shares are told: the winch's pull, or what the strongest belt pushes with. */
static double shared_pull(const SceneDef *def, const hawser_summary *s)
{
    double most = 0;
    if (def->winch.present) return fmax(fabs(s->pull_mean_N), s->pull_peak_N / 100);
    for (int i = 0; i < def->n_conveyors; ++i)
        most = fmax(most, fabs(figure_of(&def->conveyors[i], s, "steady_mean_N")));
    return most;
}

/* A belt that keeps the winch's speed shares the pull with it by the length of the cable between them, as far as its
 * grip and its limit let it. So do belts of one speed among themselves. */
int sharing_find(const Scene *scene, const hawser_summary *figures, double t, Sharing *out)
{
    const SceneDef *const def = &scene->def;
    const double pull = shared_pull(def, figures);
    *out = (Sharing){.share = -1};
    if ((def->winch.present && def->winch.mode != WINCH_SPEED) || !(pull > 0)) return 0;
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!by_lengths(c, figures)) continue;
        const Sharer other = sharer_of(scene, c, figures, t);
        const double give = isnan(other.at) ? 0 : give_up_to(scene, c, other.at, t);
        const double share = fmin(fmin(LENGTH / give, push_left(c, figures)), other.left) / pull;
        if (give > 0 && share > out->share) *out = (Sharing){share, c->name, other.of, other.name};
    }
    return out->share >= 0;
}
