/* Where the rollers of a row stand: all along at even steps, or in stretches of the route of one sort; and whether what
 * stands somewhere is in the cable's way. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

enum { WHERE_ALL, WHERE_BENDS, WHERE_STRAIGHTS, WHERE_SIDEWAYS, WHERE_RANGES };

/* The places found so far. */
typedef struct Places {
    const CaseReader *r;
    const CaseNode *node, *where; /* of the row */
    const RowPlaces *row;
    double *s;
    int n;
} Places;

hawser_status case_stretch_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double ends[2])
{
    const CaseKey *const keys[2] = {key, key};
    const hawser_status status = case_numbers_read(r, node, 2, keys, ends);
    if (!status && ends[1] < ends[0]) return case_value_error(r->err, node, ": expected [from, to] with to >= from");
    return status;
}

double case_sideways(const CaseReader *r, double s)
{
    return v3_dot(route_at(&r->route, s).curvature, route_left(&r->route, s));
}

/* n more places, `step` apart. */
static hawser_status places_add(Places *p, double first, double step, double n)
{
    if (n > CASE_ROLLERS_MAX - p->n) {
        char cost[160];
        case_cost_say(p->r, case_segments(p->r->def), p->n + n, sizeof cost, cost);
        return case_key_error(p->r->err, p->node, "spacing", "too many rollers: at most %d; %s", CASE_ROLLERS_MAX,
                              cost);
    }
    double *const grown = realloc(p->s, ((size_t)p->n + (size_t)n + 1) * sizeof *grown);
    if (!grown) return error_memory(p->r->err);
    p->s = grown;
    for (int i = 0; i < (int)n; i++) p->s[p->n++] = first + i * step;
    return HAWSER_OK;
}

/* The whole row at even steps, ends included. */
static hawser_status places_all(Places *p)
{
    const RowPlaces *d = p->row;
    const double length = d->to - d->from;
    const int spaced = !isnan(d->spacing);
    if (spaced == (d->count > 0)) {
        return case_key_error(p->r->err, p->node, spaced ? "spacing" : "count", "%s: give either 'count' or 'spacing'",
                              spaced ? "given beside count" : "missing");
    }
    const double n = spaced ? floor(length / d->spacing + 1e-9) + 1 : d->count;
    return places_add(p, d->from, spaced ? d->spacing : length / fmax(1, n - 1), n);
}

/* One stretch: equal parts no longer than the spacing, a roller in the middle of each, so that stretches that follow
 * each other never share a place. */
static hawser_status places_stretch(Places *p, double from, double to)
{
    from = fmax(from, p->row->from);
    to = fmin(to, p->row->to);
    if (to - from < 1e-9) return HAWSER_OK;
    const double n = ceil((to - from) / p->row->spacing - 1e-9), step = (to - from) / n;
    return places_add(p, from + step / 2, step, n);
}

static int is_wanted(const Places *p, const RoutePiece *piece, int where)
{
    const int bend = piece && piece->kind != ROUTE_STRAIGHT;
    if (where == WHERE_STRAIGHTS) return !bend;
    return bend && (where == WHERE_BENDS || fabs(case_sideways(p->r, piece->s0 + piece->length / 2)) > 1e-9);
}

/* Neighbouring pieces of the sort make one stretch; before its start and past its end the route is straight. */
static hawser_status places_pieces(Places *p, int where)
{
    const Route *const route = &p->r->route;
    hawser_status status = HAWSER_OK;
    double from = p->row->from; /* of the stretch that is open */
    int open = is_wanted(p, NULL, where);
    for (int i = 0; i <= route->n && !status; i++) {
        const RoutePiece *const piece = i < route->n ? &route->piece[i] : NULL;
        const double at = piece ? piece->s0 : route->length;
        const int wanted = is_wanted(p, piece, where);
        if (open && !wanted) status = places_stretch(p, from, at);
        if (!open && wanted) from = at;
        open = wanted;
    }
    if (open && !status) status = places_stretch(p, from, p->row->to);
    return status;
}

static hawser_status places_ranges(Places *p)
{
    hawser_status status = HAWSER_OK;
    for (const CaseNode *range = p->where->first; range && !status; range = range->next) {
        double ends[2];
        status = case_stretch_read(p->r, range, case_key_of(&case_roller_row, "where"), ends);
        if (!status) status = places_stretch(p, ends[0], ends[1]);
    }
    return status;
}

/* What `where` says; guides stand in bends to the side unless told otherwise. */
static hawser_status where_read(const Places *p, int *where)
{
    static const char *const word[] = {"all", "bends", "straights", NULL};
    const CaseNode *node = p->where;
    const int guide = p->row->guide != GUIDE_NONE;
    *where = WHERE_RANGES;
    if (node && node->kind == NODE_LIST) return HAWSER_OK;
    *where = node ? case_word_place(node, word) : WHERE_ALL;
    if (*where < 0) {
        return case_value_error(p->r->err, node, ": expected all, bends, straights, or a list such as [[4 m, 20 m]]");
    }
    if (guide && *where != WHERE_STRAIGHTS) *where = WHERE_SIDEWAYS;
    return HAWSER_OK;
}

static hawser_status places_fill(Places *p)
{
    const RowPlaces *d = p->row;
    int where;
    const hawser_status status = where_read(p, &where);
    if (status) return status;
    if (d->to < d->from)
        return case_key_error(p->r->err, p->node, "to", "out of range: must be at least 'from', %g m", d->from);
    if (where == WHERE_ALL) return places_all(p);
    if (isnan(d->spacing) || d->count > 0) {
        return case_key_error(p->r->err, p->node, d->count > 0 ? "count" : "spacing",
                              "%s: rows of guides, and rows with 'where', need 'spacing' alone",
                              d->count > 0 ? "given" : "missing");
    }
    return where == WHERE_RANGES ? places_ranges(p) : places_pieces(p, where);
}

hawser_status case_places_find(const CaseReader *r, const CaseNode *node, const RowPlaces *row, double **s, int *n)
{
    Places p = {.r = r, .node = node, .where = case_node_key(node, "where"), .row = row};
    const hawser_status status = places_fill(&p);
    if (status) {
        free(p.s);
        p = (Places){0};
    }
    *s = p.s;
    *n = p.n;
    return status;
}

/* ------------------------------------------------------------------------------------------- whether they fit */

/* How far a roller may press into the cable before it counts as a mistake, and the smallest step of the
 * search, m. */
static const double PRESS_MAX = 1e-3, STEP_MIN = 1e-5;

/* Where piece p lies along the route at the start: the rope's are ahead of the eye, the others behind it. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to)
{
    const int behind = scene_def_eye(def);
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
