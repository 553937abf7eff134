/* Section `route` of a case: plan and corners of the profile (docs/case-format.md). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/write/parts.h"

/* Radii beyond which a clothoid's end is straight, m. */
static const double straight_radius = 1e6;

static void radius_print(FILE *to, const char *key, double curvature)
{
    if (curvature != 0) fprintf(to, ", %s: %.12g m", key, 1 / fabs(curvature));
}

/* In quotes of YAML. */
static void name_print(const char *name, FILE *to)
{
    if (*name) fputs(", name: \"", to);
    for (const char *c = name; *c; ++c) fprintf(to, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
    fputs(*name ? "\"}\n" : "}\n", to);
}

static void element_print(const PlanElement *from, const char *name, FILE *to)
{
    PlanElement straightened = *from;
    const PlanElement *const e = &straightened;
    if (fabs(e->k0) * straight_radius <= 1) straightened.k0 = 0;
    if (fabs(e->k1) * straight_radius <= 1) straightened.k1 = 0;
    const char *const turn = e->k0 + e->k1 > 0 ? "left" : "right";
    if (e->k0 == 0 && e->k1 == 0) {
        fprintf(to, "    - {line: %.9f m", e->length);
    } else if (e->k0 == e->k1) {
        fprintf(to, "    - {arc: %.9f m, radius: %.12g m, turn: %s", e->length, 1 / fabs(e->k0), turn);
    } else if (e->k0 * e->k1 < 0) { /* in two where it changes its side */
        PlanElement first = *e, second = *e;
        first.length = e->length * e->k0 / (e->k0 - e->k1);
        second.length = e->length - first.length;
        first.k1 = second.k0 = 0;
        element_print(&first, name, to);
        element_print(&second, name, to);
        return;
    } else {
        fprintf(to, "    - {clothoid: %.9f m", e->length);
        radius_print(to, "start_radius", e->k0);
        radius_print(to, "end_radius", e->k1);
        fprintf(to, ", turn: %s", turn);
    }
    name_print(name, to);
}

/* The corner of a curve is where the grades at its ends meet. */
static void curve_print(const ProfileElement *e, FILE *to)
{
    if (e->kind == PROFILE_PARABOLA) {
        fprintf(to, "    - {station: %.9f m, height: %.9f m, parabola: %.9f m}\n", e->station + e->length / 2,
                e->z + e->grade * e->length / 2, e->length);
        return;
    }
    const double slope = atan(e->grade), turn = atan(profile_at(e, e->length).grade) - slope;
    const double tangent = fabs(tan(turn / 2) / e->bend); /* (AL5) */
    fprintf(to, "    - {station: %.9f m, height: %.9f m, radius: %.12g m}\n", e->station + tangent * cos(slope),
            e->z + tangent * sin(slope), fabs(1 / e->bend));
}

/* Corners: the first and last point, every curve, and where grades meet without one. */
static void profile_print(const Alignment *a, double length, FILE *to)
{
    const ProfileElement *const first = &a->profile[0], *const last = &a->profile[a->n_profile - 1];
    const ProfileElement end = profile_at(last, last->length);
    const double start = fmin(0, first->station), over = fmax(0, length - end.station);
    fputs("  profile:\n", to);
    fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", start, first->z + first->grade * (start - first->station));
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i];
        const double before = i ? profile_at(e - 1, e[-1].length).grade : e->grade;
        if (fabs(e->grade - before) > 1e-9) {
            fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", e->station, e->z);
        }
        if (e->bend != 0) curve_print(e, to);
    }
    fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", end.station + over, end.z + over * end.grade);
}

/* Corners in space that are built with one radius. */
static hawser_status print_corners(const Alignment *a, const char *system, FILE *to)
{
    fprintf(to, "# %s\n", *a->name ? a->name : "route");
    if (*system) fprintf(to, "# coordinates: %s\n", system);
    fprintf(to, "route:\n  radius: %.12g m\n  points:\n", a->corner);
    for (int i = 0; i < a->n_points; ++i)
        fprintf(to, "    - [%.6f m, %.6f m, %.6f m]\n", a->point[i].x, a->point[i].y, a->point[i].z);
    return HAWSER_OK;
}

hawser_status print_case(const Alignment *a, const char *system, FILE *to, hawser_error *err)
{
    if (a->n_plan == 0 && a->corner > 0) return print_corners(a, system, to);
    if (a->n_plan == 0) {
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a line of points: fit it first", a->name);
    }
    const AlignmentMeasure m = alignment_measure(a);
    fprintf(to, "# %s: %.3f m in plan, %.3f m in space\n", *a->name ? a->name : "route", m.plan_length, m.length);
    if (*system) fprintf(to, "# coordinates: %s\n", system);
    if (m.gap > 1e-4)
        fprintf(to, "# elements of the source miss each other by up to %.4f m; here they are chained\n", m.gap);
    fprintf(to, "route:\n  start: [%.6f m, %.6f m, %.6f m]\n  heading: %.12f deg\n  plan:\n", m.start.x, m.start.y,
            m.start.z, remainder(a->plan[0].heading, 2 * acos(-1)) * 180 / acos(-1));
    for (int i = 0; i < a->n_plan; ++i) element_print(&a->plan[i], piece_names_get(&a->names, a->plan[i].name), to);
    if (a->n_profile) profile_print(a, m.plan_length, to);
    return HAWSER_OK;
}
