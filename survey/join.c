#include "survey/join.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"

enum { SAMPLES = 16, LOOKED_AT = 64 };

/* Distance from an end within which gaps are searched, m: 100 tolerances, but for large tolerances no more than a metre
 * or two of them. */
static double gap_reach(double tolerance) { return fmin(100 * tolerance, fmax(1, 2 * tolerance)); }

JoinOptions join_options(void) { return (JoinOptions){.tolerance = 0.01, .layer = NULL, .name = NULL}; }

/* ------------------------------------------------------------------------------------------------- a grid of points */

/* Hash grid of points by their cell in plan. */
typedef struct Grid {
    double cell;
    unsigned mask; /* number of slots - 1; the number is a power of two */
    int *first;    /* [slots] a point of this hash, -1: none */
    int *next;     /* [n] */
    const Vec3 *at;
} Grid;

static unsigned cell_hash(int64_t x, int64_t y)
{
    uint64_t h = (uint64_t)x * 0x9E3779B97F4A7C15u ^ ((uint64_t)y + 0x7F4A7C15u) * 0xC2B2AE3D27D4EB4Fu;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9u;
    return (unsigned)(h >> 32);
}

static int64_t cell_of(const Grid *g, double x) { return (int64_t)fmin(fmax(floor(x / g->cell), -9e17), 9e17); }

static void grid_put(Grid *g, int i)
{
    int *const first = &g->first[cell_hash(cell_of(g, g->at[i].x), cell_of(g, g->at[i].y)) & g->mask];
    g->next[i] = *first;
    *first = i;
}

static int grid_alloc(int n, const Vec3 *at, double cell, Grid *g)
{
    unsigned slots = 64;
    while (slots < (unsigned)n && slots < 1u << 30) slots *= 2;
    *g = (Grid){cell, slots - 1, malloc(slots * sizeof *g->first), malloc((size_t)n * sizeof *g->next), at};
    for (unsigned i = 0; g->first && i < slots; ++i) g->first[i] = -1;
    return g->first && g->next;
}

static void grid_free(Grid *g)
{
    free(g->first);
    free(g->next);
}

/* Calls `each` for every point in the cells at and around a point, at most LOOKED_AT per cell, until it returns 1. */
static void grid_near(const Grid *g, Vec3 p, int (*each)(void *data, int i), void *data)
{
    for (int k = 0; k < 9; ++k) {
        const int64_t x = cell_of(g, p.x) + k % 3 - 1, y = cell_of(g, p.y) + k / 3 - 1;
        int looked = 0;
        for (int i = g->first[cell_hash(x, y) & g->mask]; i >= 0 && looked < LOOKED_AT; i = g->next[i]) {
            if (cell_of(g, g->at[i].x) != x || cell_of(g, g->at[i].y) != y) continue;
            ++looked;
            if (each(data, i)) return;
        }
    }
}

/* ------------------------------------------------------------------------------------------------------------- ends */

/* Vertical pieces at one knot: their heights, m. */
typedef struct Shaft {
    double low, high;
    int n;
} Shaft;

/* Pieces to be joined, with their two ends. */
typedef struct Net {
    int n;
    const Alignment **piece; /* [n] */
    double *length;          /* [n] m in plan; -1: left out */
    Vec3 *end;               /* [2 n] end 2 i is piece i's start, 2 i + 1 its end */
    int *knot;               /* [2 n] the first end at the same place; -1: not computed yet */
    int *first;              /* [2 n] of a knot: its first end, then `other` */
    int *other;              /* [2 n] the next end at the same knot, -1: no more */
    int *ends;               /* [2 n] of a knot: number of ends */
    char *used;              /* [n] */
    char *apart;             /* [2 n] ends of blocks' lines that are not joined with the lines at their knot */
    int *order;              /* [n] */
    Shaft *shaft;            /* [2 n] of a knot */
} Net;

static int is_chosen(const Alignment *a, const JoinOptions *o)
{
    if (o->layer && strcasecmp(o->layer, a->layer)) return 0;
    if (o->name && strcasecmp(o->name, a->name)) return 0;
    return a->n_plan > 0 || a->n_points > 1;
}

static int net_alloc(const Survey *s, Net *net)
{
    const size_t n = (size_t)s->n + 1;
    *net = (Net){0,
                 malloc(n * sizeof *net->piece),
                 malloc(n * sizeof *net->length),
                 malloc(2 * n * sizeof *net->end),
                 malloc(2 * n * sizeof *net->knot),
                 malloc(2 * n * sizeof *net->first),
                 malloc(2 * n * sizeof *net->other),
                 calloc(2 * n, sizeof *net->ends),
                 calloc(n, 1),
                 calloc(2 * n, 1),
                 malloc(n * sizeof *net->order),
                 malloc(2 * n * sizeof *net->shaft)};
    return net->piece && net->length && net->end && net->knot && net->first && net->other && net->ends && net->used &&
           net->apart && net->order && net->shaft;
}

static void net_free(Net *net)
{
    free(net->piece);
    free(net->length);
    free(net->end);
    free(net->knot);
    free(net->first);
    free(net->other);
    free(net->ends);
    free(net->used);
    free(net->apart);
    free(net->order);
    free(net->shaft);
}

static int is_flat(const Alignment *a) { return a->n_profile == 0 && (a->flat || a->n_points == 0); }

static void net_fill(const Survey *s, const JoinOptions *o, Net *net)
{
    for (int i = 0; i < s->n; ++i) {
        if (!is_chosen(&s->alignment[i], o)) continue;
        const Alignment *const a = &s->alignment[i];
        const AlignmentMeasure m = alignment_measure(a);
        net->piece[net->n] = a;
        net->length[net->n] = m.plan_length;
        net->end[2 * net->n] = m.start;
        net->end[2 * net->n + 1] = a->n_points > 0 && !is_flat(a) ? a->point[a->n_points - 1] : m.end;
        ++net->n;
    }
}

typedef struct Search {
    const Net *net;
    int from, found;
    int gaps;             /* search for gaps: the two ends of one straight piece are none */
    double within, least; /* m in plan */
    double rank;          /* m, of the one found: of ends at the same distance the one at its height counts */
} Search;

/* Takes in an end that may be the same place: near in plan, and in height if both have heights. */
static int end_near(void *data, int i)
{
    Search *const s = data;
    const Vec3 a = s->net->end[s->from], b = s->net->end[i];
    const double away = hypot(a.x - b.x, a.y - b.y), rank = hypot(away, 1e-3 * (a.z - b.z));
    const int level = is_flat(s->net->piece[s->from / 2]) || is_flat(s->net->piece[i / 2]);
    if (i == s->from || away > s->within || rank >= s->rank) return 0;
    if (s->gaps && i / 2 == s->from / 2 && away > 0.5 * s->net->length[i / 2]) return 0;
    if (!level && !s->gaps && fabs(a.z - b.z) > s->within) return 0;
    s->rank = rank;
    s->least = away;
    s->found = i;
    return 0;
}

/* Finds knots: ends within the tolerance of an earlier one belong to its knot. */
static int knots_find(const JoinOptions *o, Net *net)
{
    Grid g;
    const int fine = grid_alloc(2 * net->n, net->end, o->tolerance, &g);
    for (int i = 0; fine && i < 2 * net->n; ++i) {
        Search s = {net, i, -1, 0, o->tolerance, INFINITY, INFINITY};
        net->first[i] = net->other[i] = -1;
        net->shaft[i] = (Shaft){INFINITY, -INFINITY, 0};
        grid_near(&g, net->end[i], end_near, &s);
        net->knot[i] = s.found < 0 ? i : net->knot[s.found];
        if (s.found < 0) grid_put(&g, i); /* the first end represents all */
    }
    grid_free(&g);
    return fine;
}

/* Checks whether two pieces between the same knots are one drawn twice: equal length and middle. */
static int is_double(const Net *net, int i, int k, double tolerance)
{
    const int same = net->knot[2 * i] == net->knot[2 * k] && net->knot[2 * i + 1] == net->knot[2 * k + 1];
    const int turned = net->knot[2 * i] == net->knot[2 * k + 1] && net->knot[2 * i + 1] == net->knot[2 * k];
    if (!(same || turned) || fabs(net->length[i] - net->length[k]) > 2 * tolerance) return 0;
    const Vec3 a = alignment_at(net->piece[i], 0.4 * net->length[i]).at;
    const Vec3 b = alignment_at(net->piece[k], (same ? 0.4 : 0.6) * net->length[k]).at;
    return hypot(a.x - b.x, a.y - b.y) <= 2 * tolerance;
}

static int goes_up(const Net *net, int i, double tolerance)
{
    return net->length[i] <= 2 * tolerance && fabs(net->end[2 * i].z - net->end[2 * i + 1].z) > tolerance;
}

/* Attaches a piece to its knots. Where two directly drawn lines meet, lines of a block (a symbol) end beside them. */
static void piece_hang(Net *net, int i)
{
    for (int e = 2 * i; e <= 2 * i + 1; ++e) {
        const int knot = net->knot[e];
        if (net->piece[i]->inserted && net->ends[knot] == 2) {
            const int one = net->first[knot] / 2, two = net->other[net->first[knot]] / 2;
            net->apart[e] = !net->piece[one]->inserted && !net->piece[two]->inserted;
            if (net->apart[e]) continue;
        }
        net->other[e] = net->first[knot];
        net->first[knot] = e;
        net->ends[knot]++;
    }
    net->used[i] = 0;
}

/* Attaches a vertical piece. It is a shaft of the line if one piece ends at its foot and one at its head; at one knot,
 * also of pieces without heights, it may join them. Others stand beside the line. */
static void shaft_hang(Net *net, int i, Joined *joined)
{
    const int a = net->knot[2 * i], b = net->knot[2 * i + 1];
    if (a != b && net->ends[a] == 1 && net->ends[b] == 1) {
        piece_hang(net, i);
        return;
    }
    const double z[] = {net->end[2 * i].z, net->end[2 * i + 1].z};
    Shaft *const at = &net->shaft[a];
    joined->upright++;
    if (a != b) return;
    at->low = fmin(at->low, fmin(z[0], z[1]));
    at->high = fmax(at->high, fmax(z[0], z[1]));
    at->n++;
}

/* Attaches the ends to their knots; pieces drawn twice, and those shorter than the tolerance, are left out. */
static void ends_hang(const JoinOptions *o, Net *net, Joined *joined)
{
    for (int k = 0; k < 2 * net->n; ++k) { /* directly drawn lines first, then those of blocks */
        const int i = k % net->n;
        if ((net->piece[i]->inserted > 0) != (k >= net->n)) continue;
        const int a = net->knot[2 * i], b = net->knot[2 * i + 1], up = goes_up(net, i, o->tolerance);
        int twice = a == b && net->length[i] <= 2 * o->tolerance, looked = 0;
        net->used[i] = 1;
        if (up) continue;
        for (int e = net->first[a]; e >= 0 && !twice && looked < LOOKED_AT; e = net->other[e], ++looked) {
            twice = is_double(net, e / 2, i, o->tolerance);
        }
        joined->doubles += twice;
        if (!twice) piece_hang(net, i);
    }
    for (int i = 0; i < net->n; ++i)
        if (goes_up(net, i, o->tolerance)) shaft_hang(net, i, joined);
}

/* -------------------------------------------------------------------------------------------------------------
 * doubtful ends */

static void doubt_add(Joined *j, JoinDoubt d)
{
    enum { MOST = sizeof j->doubt / sizeof *j->doubt };
    *(d.kind == JOIN_FORK ? &j->n_forks : &j->n_gaps) += 1;
    if (j->n_doubts < MOST) j->doubt[j->n_doubts++] = d;
}

/* Difference of the heights of two ends, m; 0: one has none. */
static double rise_between(const Net *net, int i, int k)
{
    const int level = is_flat(net->piece[i / 2]) || is_flat(net->piece[k / 2]);
    return level ? 0 : fabs(net->end[i].z - net->end[k].z);
}

static int doubts_find(const JoinOptions *o, const Net *net, Joined *joined)
{
    Grid g;
    const int fine = grid_alloc(2 * net->n, net->end, gap_reach(o->tolerance), &g);
    for (int i = 0; fine && i < 2 * net->n; ++i) {
        if (net->knot[i] == i && net->ends[i] > 2)
            doubt_add(joined, (JoinDoubt){JOIN_FORK, net->end[i], net->ends[i], 0, 0});
        if (net->knot[i] != i || net->ends[i] == 0) continue;
        Search s = {net, i, -1, 1, gap_reach(o->tolerance), INFINITY, INFINITY};
        if (net->ends[i] == 1) grid_near(&g, net->end[i], end_near, &s);
        if (s.found >= 0)
            doubt_add(joined, (JoinDoubt){JOIN_GAP, net->end[i], 1, s.least, rise_between(net, i, s.found)});
        if (net->ends[i] == 1) grid_put(&g, i); /* each pair once */
    }
    grid_free(&g);
    return fine;
}

/* ---------------------------------------------------------------------------------------------------------- lines */

/* Checks whether exactly one other piece continues at an end. */
static int goes_on(const Net *net, int end) { return net->ends[net->knot[end]] == 2 && !net->apart[end]; }

/* Walks from an end of a piece over knots of two ends, as far as possible: stores its pieces in order, reversed ones as
 * -1 - i. */
static int walk(Net *net, int from)
{
    int n = 0;
    for (int e = from; e >= 0;) {
        const int i = e / 2, far = e ^ 1, knot = net->knot[far];
        net->used[i] = 1;
        net->order[n++] = e % 2 ? -1 - i : i;
        e = -1;
        for (int k = net->first[knot]; goes_on(net, far) && k >= 0; k = net->other[k]) {
            if (k != far && !net->used[k / 2]) e = k;
        }
    }
    return n;
}

/* Directs the n pieces of net->order as most of their length is drawn; if that is half, as the first piece in the file.
 * Returns the length drawn in the opposite direction, m. */
static double order_turn(Net *net, int n)
{
    double along = 0, against = 0;
    int first = 0;
    for (int k = 0; k < n; ++k) {
        const int i = net->order[k] < 0 ? -1 - net->order[k] : net->order[k];
        const int best = net->order[first] < 0 ? -1 - net->order[first] : net->order[first];
        *(net->order[k] < 0 ? &against : &along) += net->length[i];
        if (i < best) first = k;
    }
    const double rounding = 1e-9 * (along + against);
    const int turned = fabs(along - against) > rounding ? against > along : net->order[first] < 0;
    for (int i = 0, j = n - 1; turned && i <= j; ++i, --j) {
        const int kept = net->order[i];
        net->order[i] = -1 - net->order[j];
        net->order[j] = -1 - kept;
    }
    return turned ? along : against;
}

static int point_add(Alignment *a, Vec3 p)
{
    if (a->n_points && v3_norm(v3_sub(a->point[a->n_points - 1], p)) < 1e-9) return 1;
    Vec3 *const to = alignment_add_point(a);
    if (to) *to = p;
    return to != NULL;
}

/* Common properties of pieces that become one line. */
typedef struct Common {
    int heights, elements; /* some have them */
    int partly;            /* the file has heights of some, which are not kept */
    int drawn;             /* all are straights, or curves of the file */
    int bent;              /* some are curves of the file */
    int level;             /* all have heights, equal to z */
    double z;
} Common;

/* Checks whether a whole piece is at the height of its start. */
static int is_level(const Alignment *a)
{
    int level = 1;
    for (int i = 0; i < a->n_profile; ++i)
        level &= a->profile[i].grade == 0 && a->profile[i].bend == 0 && a->profile[i].z == a->profile[0].z;
    for (int i = 0; i < a->n_points && a->n_profile == 0; ++i) level &= a->point[i].z == a->point[0].z;
    return level;
}

static Common common_of(const Net *net, int n)
{
    Common c = {.drawn = 1, .level = n > 1, .z = NAN};
    for (int k = 0; k < n; ++k) {
        const Alignment *const a = net->piece[net->order[k] < 0 ? -1 - net->order[k] : net->order[k]];
        const double z = alignment_at(a, 0).at.z;
        c.heights |= !is_flat(a) && n > 1;
        c.elements |= a->n_plan > 0;
        c.partly |= a->partly;
        c.drawn &= a->n_plan > 0 || a->drawn;
        c.bent |= a->bent;
        for (int i = 0; i < a->n_plan; ++i) c.bent |= a->plan[i].k0 != 0 || a->plan[i].k1 != 0;
        c.level &= !is_flat(a) && is_level(a) && (k == 0 || fabs(z - c.z) < 1e-6);
        c.z = k == 0 ? z : c.z;
    }
    return c;
}

/* Number of chords for an element: they are at most 0.2 mm off, so that adjacent ones stay straights. */
static int chords_of(const Alignment *a, const PlanElement *e)
{
    enum { CHORDS_MOST = 10000 };
    const double off = 2e-4, k = fmax(fabs(e->k0), fabs(e->k1)), step = sqrt(8 * off / fmax(k, 1e-12));
    const int parts = (int)fmin(CHORDS_MOST, k == 0 ? 1 : 1 + e->length / step);
    return a->n_profile > 1 && parts < SAMPLES ? SAMPLES : parts;
}

/* Adds a piece as points: its own, or places along its elements. */
static int points_take(const Alignment *from, Alignment *to)
{
    int fine = 1;
    double s = 0;
    for (int i = 0; i < from->n_points && fine; ++i) {
        if (i > 0) s += hypot(from->point[i].x - from->point[i - 1].x, from->point[i].y - from->point[i - 1].y);
        fine = point_add(to, from->n_profile ? alignment_at(from, s).at : from->point[i]);
    }
    for (int i = 0; i < from->n_plan && fine; s += from->plan[i++].length) {
        const int parts = chords_of(from, &from->plan[i]);
        for (int k = 0; k <= parts && fine; ++k)
            fine = point_add(to, alignment_at(from, s + from->plan[i].length * k / parts).at);
    }
    return fine;
}

/* Adds a piece as elements in plan. */
static int elements_take(const Alignment *from, Alignment *to)
{
    for (int i = 0; i < from->n_plan; ++i) {
        PlanElement *const e = alignment_add_plan(to);
        if (!e) return 0;
        *e = from->plan[i];
        e->name = 0; /* belongs to another line */
    }
    for (int i = 0; i + 1 < from->n_points; ++i) {
        const Vec3 *const p = &from->point[i];
        const double length = hypot(p[1].x - p->x, p[1].y - p->y);
        if (!(length > 1e-9)) continue;
        PlanElement *const e = alignment_add_plan(to);
        if (!e) return 0;
        *e = (PlanElement){p->x, p->y, atan2(p[1].y - p->y, p[1].x - p->x), length, 0, 0, 0, 0};
    }
    return 1;
}

/* Adds a level profile to a line of elements. Returns 0 without memory. */
static int level_add(Alignment *a, double z)
{
    const double length = alignment_measure(a).plan_length;
    ProfileElement *const e = alignment_add_profile(a);
    if (e) *e = (ProfileElement){.length = length, .z = z};
    return e != NULL;
}

/* Checks whether the height of a line jumps at z, where its next piece begins. A shaft drawn there becomes part of the
 * line. */
static int jumps(Net *net, int piece, double z, const Alignment *line, double tolerance, Joined *joined)
{
    Shaft *const shaft = &net->shaft[net->knot[piece < 0 ? 2 * (-1 - piece) + 1 : 2 * piece]];
    const double before = line->point[line->n_points - 1].z, within = 2 * tolerance;
    if (fabs(z - before) <= within) return 0;
    if (!(shaft->low <= fmin(before, z) + within && shaft->high >= fmax(before, z) - within)) return 1;
    joined->upright -= shaft->n;
    shaft->n = 0;
    return 0;
}

/* Makes n pieces of net->order one line: of elements if none has heights, or there are curves and all are at one
 * height; of points if there are only points, or heights differ. Heights that jump between pieces are a shaft drawn
 * there, or come from pieces without heights: then the line has none. */
static int line_make(Net *net, int n, double tolerance, Joined *joined, Survey *to)
{
    const Common all = common_of(net, n);
    const int elements = all.elements && (!all.heights || (all.level && all.bent));
    int jump = 0;
    Alignment *const line = survey_add(to, "");
    int fine = line != NULL;
    for (int k = 0; k < n && fine; ++k) {
        const int turned = net->order[k] < 0;
        Alignment piece;
        fine = alignment_copy(net->piece[turned ? -1 - net->order[k] : net->order[k]], &piece);
        if (!fine) break;
        if (turned) alignment_reverse(&piece);
        if (k == 0) {
            memcpy(line->name, piece.name, sizeof line->name);
            memcpy(line->layer, piece.layer, sizeof line->layer);
            line->flat = !all.heights;
            line->drawn = all.drawn;
            line->bent = all.bent;
            line->partly = all.partly;
        }
        if (n == 1) { /* unchanged */
            *line = piece;
            return 1;
        }
        const double z = alignment_measure(&piece).start.z;
        if (all.heights && line->n_points) jump |= jumps(net, net->order[k], z, line, tolerance, joined);
        fine = elements ? elements_take(&piece, line) : points_take(&piece, line);
        alignment_clear(&piece);
    }
    if (fine && elements && all.level) fine = level_add(line, all.z);
    if (fine && jump) { /* pieces without heights among others */
        for (int i = 0; i < line->n_points; ++i) line->point[i].z = 0;
        line->flat = line->partly = 1;
        joined->lost_heights++;
    }
    return fine;
}

/* A line with its length in plan. */
typedef struct Long {
    double length;
    int line;
} Long;

static int by_length(const void *a, const void *b)
{
    const Long *const x = a, *const y = b;
    return x->length != y->length ? (x->length < y->length) - (x->length > y->length) : x->line - y->line;
}

/* Sorts the lines from `from` on, the longest first: each cycle of places is followed once, so that no second copy of a
 * million lines is needed. Returns 0 without memory. */
static int lines_sort(Survey *s, int from)
{
    const int n = s->n - from;
    if (n < 2) return 1;
    Alignment *const line = s->alignment + from;
    Long *const list = malloc((size_t)n * sizeof *list);
    if (!list) return 0;
    for (int i = 0; i < n; ++i) list[i] = (Long){alignment_measure(&line[i]).plan_length, i};
    qsort(list, (size_t)n, sizeof *list, by_length);
    for (int i = 0; i < n; ++i) {
        if (list[i].line == i) continue;
        const Alignment first = line[i];
        int to = i;
        for (int of = list[to].line; of != i; of = list[to].line) {
            line[to] = line[of];
            list[to].line = to;
            to = of;
        }
        line[to] = first;
        list[to].line = to;
    }
    free(list);
    return 1;
}

hawser_status join_lines(const Survey *from, const JoinOptions *options, Survey *to, Joined *joined, hawser_error *err)
{
    Net net = {0};
    const int before = to->n;
    *joined = (Joined){0};
    if (!(options->tolerance > 0)) return error_set(err, HAWSER_ERR_INPUT, "the tolerance of joining must be above 0");
    int fine = net_alloc(from, &net);
    if (fine) net_fill(from, options, &net);
    joined->pieces = net.n;
    if (fine && net.n > 0) fine = knots_find(options, &net);
    if (fine && net.n > 0) ends_hang(options, &net, joined);
    if (fine && net.n > 0) fine = doubts_find(options, &net, joined);
    for (int pass = 0; pass < 2 && fine; ++pass) { /* from ends and forks first; the rest are closed lines */
        for (int e = 0; e < 2 * net.n && fine; ++e) {
            if (net.used[e / 2] || (pass == 0 && goes_on(&net, e))) continue;
            const int pieces = walk(&net, e), at = to->n;
            const double against = order_turn(&net, pieces);
            fine = line_make(&net, pieces, options->tolerance, joined, to);
            if (fine && pieces > 1) to->alignment[at].against = against;
        }
    }
    if (fine) fine = lines_sort(to, before);
    const int n = net.n;
    net_free(&net);
    if (!fine) return error_memory(err);
    if (n > 0) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "no line%s%.60s%s%.60s", options->layer ? " on layer " : "",
                     options->layer ? options->layer : "", options->name ? " of the name " : "",
                     options->name ? options->name : "");
}

/* ---------------------------------------------------------------------------------------------------------- choosing
 */

/* Distance of a point from a straight between two others. */
static double straight_away(Vec3 a, Vec3 b, double x, double y)
{
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double part = square > 0 ? fmin(fmax(((x - a.x) * dx + (y - a.y) * dy) / square, 0), 1) : 0;
    return hypot(x - a.x - part * dx, y - a.y - part * dy);
}

double line_away(const Alignment *a, double x, double y)
{
    double least = INFINITY;
    for (int i = 0; i + 1 < a->n_points; ++i) least = fmin(least, straight_away(a->point[i], a->point[i + 1], x, y));
    for (int i = 0; i < a->n_plan; ++i) {
        const PlanElement *const e = &a->plan[i];
        const int parts = e->k0 == 0 && e->k1 == 0 ? 1 : SAMPLES;
        Vec3 from = v3(e->x, e->y, 0);
        for (int k = 1; k <= parts; ++k) {
            const PlanElement at = plan_at(e, e->length * k / parts);
            least = fmin(least, straight_away(from, v3(at.x, at.y, 0), x, y));
            from = v3(at.x, at.y, 0);
        }
    }
    return least;
}

int choose_line(const Survey *s, const ChooseOptions *options)
{
    int best = -1;
    double most = -INFINITY;
    for (int i = 0; i < s->n; ++i) {
        const Alignment *const a = &s->alignment[i];
        if (options->name && strcasecmp(options->name, a->name)) continue;
        if (options->layer && strcasecmp(options->layer, a->layer)) continue;
        const double worth =
            options->near_given ? -line_away(a, options->near_x, options->near_y) : alignment_measure(a).plan_length;
        if (worth > most) {
            most = worth;
            best = i;
        }
    }
    return best;
}
