#include "def/limits.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void limits_defaults(LimitsDef *def)
{
    *def = (LimitsDef){.cores = 1,
                       .K = 1,
                       .stress = NAN,
                       .grips = 1,
                       .attachment_rating = NAN,
                       .swivel_rating = NAN,
                       .bend_factor = NAN,
                       .roller_factor = 1.6,
                       .rope_strength = NAN,
                       .rope_factor = 5,
                       .rope_diameter = NAN,
                       .sheave = NAN,
                       .jam_from = NAN,
                       .jam_to = NAN};
    for (int k = 0; k < LIMIT_KINDS; k++) def->own[k] = NAN;
    def->own[HAWSER_LIMIT_ALPHA] = 1.5;
}

static const struct {
    const char *name, *unit;
    int traits;
} kinds[LIMIT_KINDS] = {
#define LIMIT(kind, ...) [HAWSER_LIMIT_##kind] = {__VA_ARGS__},
#include "def/limit_kinds.h"
};

const char *limits_name(hawser_limit_kind kind) { return kinds[kind].name; }
int limits_is(hawser_limit_kind kind, int traits) { return (int)kind < LIMIT_KINDS && (kinds[kind].traits & traits); }

hawser_limit_kind limits_kind(const char *name)
{
    int k = 0;
    while (k < LIMIT_KINDS && !(name && strcmp(name, kinds[k].name) == 0)) k++;
    return (hawser_limit_kind)k;
}

/* Of nothing everything is missing, and so of next to nothing: a thousand times as much as there is, at most. */
static double margin_at_least(double value, double limit)
{
    static const double MOST = 1000;
    return value * (1 + MOST) > limit ? 1 - limit / value : limit > 0 ? -MOST : 1;
}

static const double ROUNDING = 1e-12; /* of a margin: exactly what is allowed holds */

/* A limit that holds at speed, and that a start from rest may break. */
static void leave_open(hawser_limit *out, double start)
{
    out->judged = out->ok = 0;
    out->at_speed = 1;
    out->margin = NAN;
    snprintf(out->source, sizeof out->source,
             "holds at speed, but a start from rest may need up to %.3g times as much, which positions do not have: "
             "'run.analysis: dynamics' has it",
             start);
}

/* (LI4). A value that is not known is not judged, and neither is one whose limit is not. */
static void judge(const LimitsDef *def, hawser_limit_kind kind, double diameter, int cables, const Finding *f,
                  hawser_limit *out)
{
    *out = (hawser_limit){.kind = kind,
                          .name = kinds[kind].name,
                          .unit = kinds[kind].unit,
                          .value = f->value,
                          .margin = NAN,
                          .error = f->error,
                          .worst = f->value,
                          .friction_most = NAN,
                          .friction_least = NAN,
                          .rest_most = NAN,
                          .back_most = NAN,
                          .slope_radius_least = NAN};
    memcpy(out->where, f->where, sizeof out->where);
    out->limit = limits_allowed(def, kind, diameter, cables, f, out->source);
    if (isnan(out->limit)) return;
    if (isnan(f->value)) {
        snprintf(out->source, sizeof out->source, "%s", f->why);
        return;
    }
    out->judged = 1;
    out->margin = limits_at_least(def, kind, f) ? margin_at_least(out->value, out->limit) : 1 - out->value / out->limit;
    if (kind == HAWSER_LIMIT_RUN_AWAY)
        out->margin = f->value > 0 ? -f->value / fmax(f->value, f->rating) : 1; /* (LI12) */
    if (fabs(out->margin) < ROUNDING) out->margin = 0;
    out->ok = out->margin >= 0;
    if (out->ok && out->value * f->start > out->limit) leave_open(out, f->start); /* (LI16) */
}

/* How far a load's jam ratio is from the band in which cables jam, 1; below 0 within it. */
static double jam_distance(const LimitsDef *def, double ratio, int triangle)
{
    const JamBand band = limits_jam_band(def, triangle);
    return fmax(band.from - ratio, ratio - band.to);
}

int limits_jams(const LimitsDef *def, const DuctLoad *load)
{
    const int three = load->jam_risk != JAM_NONE;
    return three && jam_distance(def, load->jam_ratio, load->layout == DUCT_TRIANGLE) < 0;
}

/* A duct that is worse takes the place of the one before. */
static void duct_worse(int worse, double value, int cables, int triangle, const char *name, Finding *f)
{
    if (!f->absent && !worse) return;
    *f = (Finding){.value = value, .cables = cables, .triangle = triangle};
    snprintf(f->where, sizeof f->where, "%.75s", name);
}

void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load, Finding finding[LIMIT_KINDS])
{
    Finding *const jam = &finding[HAWSER_LIMIT_JAM_RATIO], *const room = &finding[HAWSER_LIMIT_CLEARANCE],
                   *const fill = &finding[HAWSER_LIMIT_FILL], *const weight = &finding[HAWSER_LIMIT_WEIGHT_CORRECTION];
    if (!name) {
        jam->absent = room->absent = fill->absent = weight->absent = 1;
        return;
    }
    const int triangle = load->layout == DUCT_TRIANGLE;
    if (load->jam_risk != JAM_NONE) {
        const int nearer = jam_distance(def, load->jam_ratio, triangle) < jam_distance(def, jam->value, jam->triangle);
        duct_worse(nearer, load->jam_ratio, cables, triangle, name, jam);
    }
    duct_worse(load->clearance < room->value, load->clearance, cables, triangle, name, room);
    duct_worse(load->fill > fill->value, load->fill, cables, triangle, name, fill);
    if (cables > 1)
        duct_worse(load->weight_factor > weight->value, load->weight_factor, cables, triangle, name, weight);
}

double limits_reach(const hawser_limit *l)
{
    if (!(l->limit > 0)) return 0;
    const int least = l->ok == (l->value > l->limit);
    return least ? l->limit / (l->value - l->error) : (l->value + l->error) / l->limit;
}

/* Whether a broken limit might hold, within the error bar of its figure. */
static int might_hold(const hawser_limit *l)
{
    return l->error > 0 && l->limit > 0 && fabs(l->value - l->limit) <= l->error;
}

const hawser_limit *limits_undecided(int n, const hawser_limit *limit)
{
    const hawser_limit *worst = NULL;
    double most = 1;
    for (int i = 0; i < n; i++) {
        const hawser_limit *const l = &limit[i];
        if (l->judged && !l->ok && !might_hold(l)) return NULL;
        const double reach = l->judged ? limits_reach(l) : 0;
        if (!(l->error > 0 && reach > most)) continue;
        worst = l;
        most = reach;
    }
    return worst;
}

int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out)
{
    int n = 0;
    if (!def->present) return 0;
    for (int k = 0; k < LIMIT_KINDS; k++) {
        if (finding[k].absent || (kinds[k].traits & LIMIT_OPTIONAL && isnan(def->own[k]))) continue;
        judge(def, (hawser_limit_kind)k, diameter, cables, &finding[k], &out[n++]);
    }
    return n;
}
