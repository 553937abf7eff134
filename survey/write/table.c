/* CSV: elements with their starts, and the planner's pieces. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "survey/write/parts.h"

/* A number with so many digits behind the point; nothing where there is none. */
static void cell(FILE *to, int digits, double value)
{
    fputc(',', to);
    if (isfinite(value)) fprintf(to, "%.*f", digits, value);
}

/* The same with twelve figures. */
static void radius_cell(FILE *to, double curvature)
{
    fputc(',', to);
    if (curvature != 0) fprintf(to, "%.12g", 1 / curvature);
}

/* In quotes, which are doubled within. */
static void name_cell(FILE *to, const char *name)
{
    fputs(",\"", to);
    for (; *name; ++name) fprintf(to, *name == '"' ? "\"\"" : "%c", *name);
    fputc('"', to);
}

hawser_status print_elements(const Alignment *a, FILE *to, hawser_error *err)
{
    if (a->n_plan == 0 && a->n_profile == 0) {
        fputs("x (m),y (m),z (m)\n", to);
        for (int i = 0; i < a->n_points; ++i) {
            fprintf(to, "%.6f,%.6f,%.6f\n", a->point[i].x, a->point[i].y, a->point[i].z);
        }
        return HAWSER_OK;
    }
    Stretches s;
    const hawser_status status = stretches_make(a, &s, err);
    fputs("station (m),x (m),y (m),direction (rad),length (m),start radius (m),end radius (m)", to);
    if (a->n_profile) fputs(",z (m),start gradient,end gradient,vertical radius (m)", to);
    fputs(a->names.used ? ",name\n" : "\n", to);
    for (int i = 0; i < s.n; ++i) {
        const PlanElement *const e = &s.item[i].plan;
        const ProfileElement *const p = &s.item[i].profile;
        fprintf(to, "%.6f,%.6f,%.6f,%.14f,%.9f", a->station + s.item[i].station, e->x, e->y, e->heading, e->length);
        radius_cell(to, e->k0);
        radius_cell(to, e->k1);
        if (a->n_profile) {
            cell(to, 6, p->z);
            cell(to, 14, p->grade);
            cell(to, 14, profile_at(p, p->length).grade);
            radius_cell(to, p->kind == PROFILE_ARC ? p->bend : 0);
        }
        if (a->names.used) name_cell(to, piece_names_get(&a->names, e->name));
        fputc('\n', to);
    }
    free(s.item);
    return status;
}

/* One row; 0: a piece that the table has no words for. */
static int piece_print(const Stretch *s, FILE *to)
{
    const PlanElement *const e = &s->plan;
    const ProfileElement *const p = &s->profile;
    const double degree = 180 / acos(-1), turn = e->k0 * e->length, slope = p->grade;
    if (e->k0 != e->k1 || (e->k0 != 0 && p->bend != 0) || (p->bend != 0 && p->kind != PROFILE_ARC)) return 0;
    if (e->k0 != 0) {
        fprintf(to, ",%.10f,%.9f,%s,%.14f\n", fabs(turn) * degree, fabs(1 / e->k0), turn > 0 ? "left" : "right", slope);
    } else if (p->bend != 0) {
        const double rise = atan(profile_at(p, p->length).grade) - atan(slope);
        fprintf(to, ",%.10f,%.9f,%s,%.14f\n", fabs(rise) * degree, fabs(1 / p->bend), rise > 0 ? "up" : "down", slope);
    } else {
        fprintf(to, "%.9f,,,,%.14f\n", e->length * sqrt(1 + slope * slope), slope);
    }
    return 1;
}

hawser_status print_pieces(const Alignment *a, FILE *to, hawser_error *err)
{
    Stretches s = {0, NULL};
    hawser_status status = HAWSER_OK;
    if (a->n_plan == 0)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a line of points, not of pieces: fit it first", a->name);
    if (!status) status = stretches_make(a, &s, err);
    fputs("length (m),angle (deg),radius (m),turn,slope\n", to);
    for (int i = 0; i < s.n && !status; ++i) {
        if (piece_print(&s.item[i], to)) continue;
        status = error_set(err, HAWSER_ERR_INPUT,
                           "'%.60s' has a clothoid, a parabola or a bend on a vertical curve %.3f m from its start: a "
                           "table of pieces has no word for it; write elements",
                           a->name, s.item[i].station);
    }
    free(s.item);
    return status;
}
