#include <math.h>

#include "io/case/case_parts.h"

/* How far a roller may press into the cable before it counts as a mistake, and the smallest step of the
 * search, m. */
static const double PRESS_MAX = 1e-3, STEP_MIN = 1e-5;

/* Where piece p lies along the route at the start: the last of several is ahead of the eye, the others behind
 * it. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to)
{
    const int behind = def->n_pieces > 1 ? def->n_pieces - 1 : 1;
    *from = def->head_at;
    for (int k = behind - 1; k >= p; k--) *from -= def->pieces[k].length;
    *to = *from + def->pieces[p].length;
}

/* The first s between from and to where the route's line comes nearer to the shape than `least`; `to` if
 * none. The line's distance cannot change faster than s, so that a step of what is to spare is safe. */
static double line_meets(const Route *route, const Shape *shape, double from, double to, double least, double *distance)
{
    double s = from;
    while (s < to) {
        *distance = shape_distance(shape, route_at(route, s).position);
        if (*distance < least) return s;
        s += fmax(*distance - least, STEP_MIN);
    }
    return to;
}

/* Each piece with its own radius: a roller may be nearer to the rope than to the cable. */
hawser_status case_overlap_check(const CaseReader *r, const CaseNode *node, const RollerDef *roller)
{
    if (r->def->rod.present) return HAWSER_OK; /* it lies on no route */
    const SceneDef *def = r->def;
    const Shape shape = roller_def_shape(roller);
    for (int p = 0; p < def->n_pieces; p++) {
        const double radius = def->cables[def->pieces[p].cable].diameter / 2;
        double from, to, distance = 0;
        case_piece_place(def, p, &from, &to);
        const double s = line_meets(&r->route, &shape, from, to, radius - PRESS_MAX, &distance);
        if (s >= to) continue;
        return case_key_error(r->err, node, NULL,
                              "%s '%s' is inside the cable: %.4g m along the route its surface is %.4g m from the "
                              "line, must be at least the cable's radius, %.4g m",
                              roller->profile < SHAPE_BOX ? "roller" : "obstacle", roller->name, s, distance, radius);
    }
    return HAWSER_OK;
}
