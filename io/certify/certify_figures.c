/* The figures that a run is made for. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/certify/certify.h"

/* The least coefficient that a floor reckons with: cables without friction weigh something too. */
static const double LEAST_MU = 0.01;
static const double LEAST_SHARE = 1e-3; /* of the largest figure of a kind (CE6) */
static const char ROTATION[] = "rad";   /* the unit of rotation vectors alone: x, y and z in a row */

void figures_free(Figures *f)
{
    free(f->figure);
    *f = (Figures){0};
}

/* The list grows as needed; a failure is seen at the end, by room < 0. */
static void add(Figures *f, const char *unit, double value, double floor, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

static void add(Figures *f, const char *unit, double value, double floor, const char *format, ...)
{
    if (f->room < 0) return;
    if (f->n == f->room) {
        const int room = f->room ? 2 * f->room : 16;
        Figure *const more = realloc(f->figure, (size_t)room * sizeof *more);
        f->room = more ? room : -1;
        if (!more) return;
        f->figure = more;
    }
    Figure *const figure = &f->figure[f->n++];
    va_list args;
    *figure = (Figure){.unit = unit, .value = value, .floor = floor};
    va_start(args, format);
    vsnprintf(figure->name, sizeof figure->name, format, args);
    va_end(args);
}

/* Weight of a metre of the heaviest cable, N/m, and that of a metre that is dragged, N (CE6). */
typedef struct Floors {
    double weight, drag;
} Floors;

static Floors floors_of(const SceneDef *def)
{
    double mass = 0, mu = LEAST_MU;
    for (int k = 0; k < def->n_pieces; ++k) mass = fmax(mass, def->cables[def->pieces[k].cable].mass);
    for (int r = 0; r < def->n_rollers; ++r) mu = fmax(mu, def->rollers[r].friction.mu_d);
    for (int k = 0; k < def->n_surfaces; ++k) mu = fmax(mu, def->surfaces[k].friction.mu_d);
    const double weight = mass * v3_norm(def->gravity);
    return (Floors){weight, mu * weight};
}

static void add_pull(hawser_sim *s, const hawser_summary *sum, Floors floor, Figures *f)
{
    const SceneDef *const def = &s->stage.scene.def;
    if (def->winch.present) {
        add(f, "N", sum->pull_mean_N, floor.drag, "pull, mean");
        add(f, "N", sum->pull_peak_N, floor.drag, "pull, peak");
    }
    const hawser_station *station;
    const int n = hawser_sim_stations(s, &station);
    for (int i = 0; i < n; ++i) {
        if (isnan(station[i].mean_N)) continue; /* no cable was there */
        add(f, "N", station[i].mean_N, floor.drag, "tension at %.40s, mean", station[i].name);
        add(f, "N", station[i].peak_N, floor.drag, "tension at %.40s, peak", station[i].name);
    }
}

/* The most heavily loaded roller and surface: what is judged. Which one that is may change with the settings. */
static void add_loads(hawser_sim *s, Floors floor, Figures *f)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const hawser_roller *roller;
    const hawser_surface *surface;
    const int rollers = hawser_sim_rollers(s, &roller), surfaces = hawser_sim_surfaces(s, &surface);
    double peak = -INFINITY, steady = -INFINITY, line = -INFINITY;
    for (int i = 0; i < rollers; ++i) {
        peak = fmax(peak, roller[i].peak_N);
        steady = fmax(steady, roller[i].steady_N);
    }
    for (int i = 0; i < surfaces; ++i) line = fmax(line, surface[i].line_load_N_per_m);
    if (peak > -INFINITY) add(f, "N", peak, floor.weight, "roller load, peak");
    if (steady > -INFINITY) add(f, "N", steady, floor.weight, "roller load, steady");
    if (line > -INFINITY) add(f, "N/m", line, floor.weight, "load on surfaces, peak");
    const int n = hawser_sim_limits(s, limit);
    for (int i = 0; i < n; ++i) {
        if (!isfinite(limit[i].value)) continue;
        if (limit[i].kind == HAWSER_LIMIT_SIDEWALL)
            add(f, "N/m", limit[i].value, floor.weight, "sidewall pressure, peak");
        if (limit[i].kind == HAWSER_LIMIT_PULL) add(f, "N", limit[i].value, floor.drag, "tension, largest");
    }
}

/* Largest of a kind over the probes, and what that is in the kind beside it over the rod's length: a moment M stands
 * for forces M/L, a rotation for displacements of L times it. A component need not be known better than a thousandth of
 * it. */
typedef struct RodScales {
    double displacement, rotation, force, moment;
} RodScales;

static double length_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

static RodScales rod_scales(const hawser_summary *sum, double length)
{
    double d = 0, r = 0, f = 0, m = 0;
    for (int i = 0; i < sum->n_probes; ++i) {
        const hawser_probe *const p = &sum->probes[i];
        d = fmax(d, length_of(p->displacement));
        r = fmax(r, length_of(p->rotation));
        f = fmax(f, length_of(p->force));
        m = fmax(m, length_of(p->moment));
    }
    return (RodScales){fmax(d, r * length), fmax(r, d / length), fmax(f, m / length), fmax(m, f * length)};
}

static void add_vector(const double v[3], const char *unit, double scale, const char *what, const char *of, Figures *f)
{
    for (int c = 0; c < 3; ++c) add(f, unit, v[c], scale, "%s of %.40s, %c", what, of, "xyz"[c]);
}

/* A rotation vector r and (1 - 2 pi/|r|) r turn to the same place, and at half a turn rounding decides which of them a
 * run says: the one that is nearer to `own`'s, three numbers (CE8). */
static void turn_nearer(const Figure own[3], Figure other[3])
{
    const double r[3] = {other[0].value, other[1].value, other[2].value}, size = length_of(r);
    double here[3], there[3];
    if (!(size > 0)) return;
    for (int c = 0; c < 3; ++c) {
        here[c] = r[c] - own[c].value;
        there[c] = here[c] - 2 * M_PI / size * r[c];
    }
    if (!(length_of(there) < length_of(here))) return;
    for (int c = 0; c < 3; ++c) other[c].value = own[c].value + there[c];
}

void figures_follow(const Figures *own, Figures *other)
{
    for (int i = 0; i + 2 < own->n && i + 2 < other->n; ++i) {
        if (strcmp(own->figure[i].unit, ROTATION)) continue;
        turn_nearer(own->figure + i, other->figure + i);
        i += 2;
    }
}

/* A rod's places at the end, and its modes; the lowest frequency that is none of a rigid motion is the floor of all. */
static void add_rod(const hawser_summary *sum, double length, Figures *f)
{
    const RodScales scale = rod_scales(sum, length);
    double highest = 0, lowest = INFINITY;
    for (int i = 0; i < sum->n_probes; ++i) {
        const hawser_probe *const p = &sum->probes[i];
        add_vector(p->displacement, "m", scale.displacement, "displacement", p->name, f);
        add_vector(p->rotation, ROTATION, scale.rotation, "rotation", p->name, f);
        add_vector(p->force, "N", scale.force, "force", p->name, f);
        add_vector(p->moment, "N m", scale.moment, "moment", p->name, f);
    }
    for (int i = 0; i < sum->n_modes; ++i) highest = fmax(highest, sum->modes[i].frequency_Hz);
    for (int i = 0; i < sum->n_modes; ++i) {
        const double hz = sum->modes[i].frequency_Hz;
        if (hz > 1e-6 * highest) lowest = fmin(lowest, hz);
    }
    for (int i = 0; i < sum->n_modes; ++i) add(f, "Hz", sum->modes[i].frequency_Hz, lowest, "frequency %d", i + 1);
}

/* No figure need be known better than a thousandth of the largest of its unit. */
static void raise_floors(Figures *f, const char *unit)
{
    double largest = 0;
    for (int i = 0; i < f->n; ++i)
        if (!strcmp(f->figure[i].unit, unit)) largest = fmax(largest, fabs(f->figure[i].value));
    for (int i = 0; i < f->n; ++i) {
        if (!strcmp(f->figure[i].unit, unit)) f->figure[i].floor = fmax(f->figure[i].floor, LEAST_SHARE * largest);
    }
}

hawser_status figures_take(hawser_sim *s, Figures *out, hawser_error *err)
{
    hawser_summary sum;
    *out = (Figures){0};
    hawser_sim_summary(s, &sum);
    if (sum.rod) {
        const SceneDef *const def = &s->stage.scene.def;
        double length = 0;
        for (int k = 0; k < def->n_pieces; ++k) length += def->pieces[k].length;
        add_rod(&sum, length, out);
    } else {
        const Floors floor = floors_of(&s->stage.scene.def);
        add_pull(s, &sum, floor, out);
        add_loads(s, floor, out);
        raise_floors(out, "N");
        raise_floors(out, "N/m");
    }
    if (out->room >= 0) return HAWSER_OK;
    figures_free(out);
    return error_memory(err);
}
