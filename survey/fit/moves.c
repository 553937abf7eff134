/* From a first chain to the best one: pieces are left out, added, split and changed in kind, each time in a window of a
 * few pieces that is fitted again; what lowers (FT6) stays. */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/fit/chain.h"

enum { ASIDE = 2, WINDOW = 2 * ASIDE + 1, GROWTH = 3, FARTHER = 4 };
enum { WINDOW_MOST = WINDOW + GROWTH, WIDE_MOST = WINDOW_MOST + 2 * FARTHER };
enum { EDGE_NODES = 60, STEPS = 10, SWEEPS = 8 };

/* Squares over sigma2 a node, from which on a window fits badly. */
static const double ROUGH = 2;
static const double PI = 3.14159265358979323846;

/* Some pieces with their nodes, to try something on. */
typedef struct Window {
    int n;
    Piece piece[WIDE_MOST];
} Window;

/* What a chain's pieces cost beside their squares: each for itself, and each curvature that is an unknown. Those of
 * joints at which a clothoid goes over are one, and one with those of the arc there; a straight's is none. */
static double pieces_cost(int n, const Piece *p)
{
    const double curvature = 8, clothoid = 5;
    double sum = 0;
    int unknown = 0; /* the curvature with which the piece before ended */
    for (int i = 0; i < n; ++i) {
        const int changes = p[i].kind == PIECE_CLOTHOID && !p[i].kept, known = p[i].kind == PIECE_STRAIGHT || p[i].kept;
        const int same = i > 0 && chain_tied(&p[i - 1]);
        sum += piece_worth + (p[i].kind == PIECE_CLOTHOID ? clothoid : 0);
        if (!same) { /* a new one */
            sum += unknown ? curvature : 0;
            unknown = 1;
        }
        if (known) unknown = 0;
        if (!changes) continue;
        sum += unknown ? curvature : 0;
        unknown = 1;
    }
    return sum + (unknown ? curvature : 0);
}

/* ----------------------------------------------------------------------------------------------------- the moves */

static void window_insert(Window *w, int at, Piece p)
{
    memmove(&w->piece[at + 1], &w->piece[at], (size_t)(w->n - at) * sizeof p);
    w->piece[at] = p;
    ++w->n;
}

static void window_remove(Window *w, int at)
{
    memmove(&w->piece[at], &w->piece[at + 1], (size_t)(w->n - at - 1) * sizeof *w->piece);
    --w->n;
}

/* Two straights end to end are one. */
static void straights_merge(Window *w)
{
    for (int i = 0; i + 1 < w->n; ++i) {
        Piece *const p = &w->piece[i];
        if (p[0].kind != PIECE_STRAIGHT || p[1].kind != PIECE_STRAIGHT) continue;
        const PlanElement end = plan_at(&p[1].e, p[1].e.length);
        p->e.length = hypot(end.x - p->e.x, end.y - p->e.y);
        p->e.heading += remainder(atan2(end.y - p->e.y, end.x - p->e.x) - p->e.heading, 2 * PI);
        window_remove(w, i + 1);
        --i;
    }
}

/* Cuts `before` m off a piece's start and `behind` off its end. */
static void piece_shorten(Piece *p, double before, double behind)
{
    const PlanElement from = plan_at(&p->e, before), to = plan_at(&p->e, p->e.length - behind);
    p->e = (PlanElement){from.x, from.y, from.heading, p->e.length - before - behind, from.k0, to.k0, p->e.name, 0};
}

/* Without piece q; its neighbours share its length. */
static int leave_out(Window *w, int q)
{
    if (w->n < 2 || w->piece[q].kept) return 0;
    const double length = w->piece[q].e.length, turn = 0.5 * length * (w->piece[q].e.k0 + w->piece[q].e.k1);
    const int first = q == 0, last = q + 1 == w->n;
    Piece *const before = &w->piece[q - !first], *const behind = &w->piece[q + !last];
    if (!last) { /* it begins earlier, by going back on it */
        const double more = first ? length : 0.5 * length;
        const double bend = behind->kind == PIECE_STRAIGHT ? 0 : more * behind->e.k0;
        behind->e.x -= more * cos(behind->e.heading - 0.5 * bend);
        behind->e.y -= more * sin(behind->e.heading - 0.5 * bend);
        behind->e.heading -= bend;
        behind->e.length += more;
    }
    if (!first) before->e.length += last ? length : 0.5 * length;
    if (!first && before->kind == PIECE_ARC && !before->kept)
        before->e.k0 = before->e.k1 += 0.5 * turn / before->e.length;
    if (!last && behind->kind == PIECE_ARC && !behind->kept)
        behind->e.k0 = behind->e.k1 += 0.5 * turn / behind->e.length;
    window_remove(w, q);
    straights_merge(w);
    return 1;
}

static int leave_two_out(Window *w, int q)
{
    return q + 1 < w->n && w->n > 2 && leave_out(w, q + 1) && q < w->n && leave_out(w, q);
}

static int change_kind(Window *w, int q, PieceKind kind)
{
    Piece *const p = &w->piece[q];
    if (p->kind == kind || p->kept) return 0;
    if (kind != PIECE_CLOTHOID) p->e.k0 = p->e.k1 = kind == PIECE_ARC ? 0.5 * (p->e.k0 + p->e.k1) : 0;
    p->kind = kind;
    p->loose = 0;
    if (kind == PIECE_CLOTHOID && q + 1 < w->n) p[1].loose = 0;
    straights_merge(w);
    return 1;
}
static int make_straight(Window *w, int q) { return change_kind(w, q, PIECE_STRAIGHT); }
static int make_arc(Window *w, int q) { return change_kind(w, q, PIECE_ARC); }

/* Between longer neighbours it reaches into both: an arc that stands for a transition is about half as long as that. */
static int make_clothoid(Window *w, int q)
{
    const double half = 0.4 * w->piece[q].e.length;
    if (!change_kind(w, q, PIECE_CLOTHOID)) return 0;
    if (q == 0 || q + 1 == w->n) return 1;
    Piece *const p = &w->piece[q];
    if (fmin(p[-1].e.length, p[1].e.length) < 3 * half) return 1;
    piece_shorten(&p[-1], 0, half);
    piece_shorten(&p[1], half, 0);
    const PlanElement end = plan_at(&p[-1].e, p[-1].e.length);
    p->e = (PlanElement){end.x, end.y, end.heading, p->e.length + 2 * half, end.k0, p[1].e.k0, 0, 0};
    return 1;
}

/* On either side of piece q. */
static int make_two_clothoids(Window *w, int q)
{
    return q > 0 && q + 1 < w->n && make_clothoid(w, q + 1) && make_clothoid(w, q - 1);
}

/* A piece between q and the next, which give up part of their lengths. */
static int put_between(Window *w, int q, PieceKind kind, double part)
{
    if (q + 1 >= w->n || w->piece[q].kind == kind || w->piece[q + 1].kind == kind || w->n >= WINDOW_MOST) return 0;
    Piece *const before = &w->piece[q], *const behind = &w->piece[q + 1];
    const double half = part * fmin(before->e.length, behind->e.length);
    piece_shorten(before, 0, half);
    piece_shorten(behind, half, 0);
    const PlanElement end = plan_at(&before->e, before->e.length);
    Piece p = {.kind = kind, .e = {end.x, end.y, end.heading, 2 * half, end.k0, behind->e.k0, 0, 0}};
    if (kind == PIECE_STRAIGHT) p.e.k0 = p.e.k1 = 0;
    if (kind == PIECE_ARC) p.e.k0 = p.e.k1 = 0.5 * (p.e.k0 + p.e.k1);
    behind->loose = 0;
    window_insert(w, q + 1, p);
    return 1;
}
static int put_clothoid(Window *w, int q) { return put_between(w, q, PIECE_CLOTHOID, 0.3); }
static int put_short_clothoid(Window *w, int q) { return put_between(w, q, PIECE_CLOTHOID, 0.1); }
static int put_straight(Window *w, int q) { return put_between(w, q, PIECE_STRAIGHT, 0.3); }
static int put_arc(Window *w, int q) { return put_between(w, q, PIECE_ARC, 0.3); }
/* A clothoid on either side of piece q. */
static int put_two_clothoids(Window *w, int q) { return q > 0 && put_clothoid(w, q) && put_clothoid(w, q - 1); }

/* Two of its kind; a straight gets a bend in its middle. */
static int split(Window *w, int q)
{
    Piece *const p = &w->piece[q];
    if (w->n + 2 > WINDOW_MOST || p->kept) return 0;
    Piece second = *p;
    const int straight = p->kind == PIECE_STRAIGHT;
    const double half = (straight ? 0.4 : 0.5) * p->e.length, middle = p->e.length - 2 * half;
    piece_shorten(&second, half + middle, 0);
    second.loose = 0;
    Piece between = *p;
    piece_shorten(p, 0, half + middle);
    window_insert(w, q + 1, second);
    if (!straight) return 1;
    piece_shorten(&between, half, half);
    between.kind = PIECE_ARC;
    window_insert(w, q + 1, between);
    return 1;
}

/* An arc turns in one of its ends alone, and is straight beyond: what stood for a bend and the straight beside it. */
static int bend_in_end(Window *w, int q, int last)
{
    const double part = 0.1;
    Piece *const p = &w->piece[q];
    if (p->kind != PIECE_ARC || p->kept || w->n >= WINDOW_MOST) return 0;
    const double L = p->e.length, turn = L * p->e.k0, bend = part * L;
    const PlanElement from = p->e;
    Piece arc = *p, straight = *p;
    straight.kind = PIECE_STRAIGHT;
    straight.loose = 0;
    arc.e.length = bend;
    arc.e.k0 = arc.e.k1 = turn / bend;
    straight.e.length = L - bend;
    straight.e.k0 = straight.e.k1 = 0;
    if (!last) { /* the straight begins where the arc ends */
        const PlanElement end = plan_at(&arc.e, bend);
        straight.e.x = end.x, straight.e.y = end.y, straight.e.heading = end.heading;
    } else {
        const PlanElement end = plan_at(&straight.e, L - bend);
        arc.e.x = end.x, arc.e.y = end.y, arc.e.heading = from.heading;
    }
    *p = last ? straight : arc;
    window_insert(w, q + 1, last ? arc : straight);
    straights_merge(w);
    return 1;
}
/* Only worth its time where the window fits badly: both stand first among the moves. */
enum { ROUGH_MOVES = 2 };
static int bend_first(Window *w, int q) { return bend_in_end(w, q, 0); }
static int bend_last(Window *w, int q) { return bend_in_end(w, q, 1); }

static int loosen(Window *w, int q)
{
    if (q == 0 || (w->piece[q].kind != PIECE_CLOTHOID && w->piece[q - 1].kind != PIECE_CLOTHOID)) return 0;
    w->piece[q].loose = !w->piece[q].loose;
    return 1;
}

/* Each changes a window about its piece q; 0: that cannot be done. */
static int (*const moves[])(Window *w, int q) = {bend_first,         bend_last,    leave_out,    leave_two_out,
                                                 make_straight,      make_arc,     put_clothoid, put_short_clothoid,
                                                 put_two_clothoids,  put_straight, put_arc,      make_clothoid,
                                                 make_two_clothoids, split,        loosen};

/* ------------------------------------------------------------------------------------------------------- windows */

typedef struct Search {
    Piece **piece;
    int *n;
    const Node *node;
    Foot *foot, *trial; /* [m] of the chain; of a window */
    int m;
    double sigma2;
    int clothoids;
    hawser_error *err;
} Search;

/* The first node on piece q or behind it. */
static int node_of(const Search *s, int q)
{
    int low = 0, high = s->m;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (s->foot[middle].piece < q)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Of long outermost pieces a and b (-1: it stays whole) only what is near counts: nodes from..to - 1, and what is cut
 * off the pieces' far ends, m. */
static void ends_cut(const Search *s, int a, int b, int *from, int *to, double cut[2])
{
    const int inner = a < 0 ? *from : node_of(s, a + 1), outer = b < 0 ? *to : node_of(s, b);
    cut[0] = cut[1] = 0;
    if (inner - *from > EDGE_NODES) {
        *from = inner - EDGE_NODES;
        cut[0] = s->foot[*from].s;
    }
    if (*to - outer > EDGE_NODES) {
        *to = outer + EDGE_NODES;
        cut[1] = fmax(0, (*s->piece)[b].e.length - s->foot[*to - 1].s);
    }
}

static void window_shorten(Window *w, const double cut[2])
{
    if (cut[0] > 0) piece_shorten(&w->piece[0], cut[0], 0);
    if (cut[1] > 0) piece_shorten(&w->piece[w->n - 1], 0, cut[1]);
}

/* Pieces a..b with their nodes from..to - 1; of the outermost ones only what is near. */
static Window window_of(const Search *s, int a, int b, int *from, int *to)
{
    Window w = {.n = b - a + 1};
    double cut[2];
    memcpy(w.piece, &(*s->piece)[a], (size_t)w.n * sizeof *w.piece);
    *from = node_of(s, a);
    *to = node_of(s, b + 1);
    ends_cut(s, b > a ? a : -1, b > a ? b : -1, from, to, cut);
    window_shorten(&w, cut);
    return w;
}

/* What the window costs when it is fitted, as far as that takes to see that it is not below `least`; pieces that vanish
 * or turn by more than a full circle are none. */
static hawser_status window_cost(const Search *s, Window *w, int from, int to, double least, double *cost)
{
    const double fixed = pieces_cost(w->n, w->piece);
    *cost = INFINITY;
    if (!(fixed < least)) return HAWSER_OK;
    const hawser_status status = chain_refine(w->n, w->piece, to - from, s->node + from, STEPS,
                                              (least - fixed) * s->sigma2, s->trial, s->err);
    *cost = chain_squares(to - from, s->node + from, s->trial) / s->sigma2 + fixed;
    for (int i = 0; i < w->n; ++i) {
        const PlanElement *const e = &w->piece[i].e;
        if (e->length < 1e-2 || fmax(fabs(e->k0), fabs(e->k1)) * e->length > 2 * PI) *cost = INFINITY;
        if (i + 1 < w->n) { /* a chain that did not come together */
            const PlanElement end = plan_at(e, e->length);
            if (!(hypot(end.x - e[0].x, end.y - e[0].y) < 1e12)) *cost = INFINITY;
            if (hypot(end.x - w->piece[i + 1].e.x, end.y - w->piece[i + 1].e.y) > 1e-2) *cost = INFINITY;
        }
    }
    if (!isfinite(*cost)) *cost = INFINITY;
    return status;
}

/* Pieces a..b give way to the window's. */
static hawser_status window_put(Search *s, int a, int b, const Window *w, int whole_first, int whole_last)
{
    const int n = *s->n, more = w->n - (b - a + 1);
    Piece *const wider = more > 0 ? realloc(*s->piece, (size_t)(n + more) * sizeof *wider) : *s->piece;
    if (!wider) return error_memory(s->err);
    *s->piece = wider;
    const Piece first = wider[a], last = wider[b];
    memmove(&wider[b + 1 + more], &wider[b + 1], (size_t)(n - b - 1) * sizeof *wider);
    memcpy(&wider[a], w->piece, (size_t)w->n * sizeof *wider);
    *s->n = n + more;
    if (!whole_first) { /* what the window did not see of it */
        const double seen = wider[a].e.length;
        const PlanElement *const was = &first.e;
        wider[a].e.length = hypot(wider[a].e.x - was->x, wider[a].e.y - was->y) + seen;
        wider[a].e.x = was->x;
        wider[a].e.y = was->y;
        wider[a].e.heading = was->heading;
    }
    if (!whole_last) {
        const PlanElement end = plan_at(&last.e, last.e.length), *const now = &wider[a + w->n - 1].e;
        const PlanElement seen = plan_at(now, now->length);
        wider[a + w->n - 1].e.length += hypot(end.x - seen.x, end.y - seen.y);
    }
    return HAWSER_OK;
}

/* The best move about piece q, in the window w of pieces *a..*b with what it costs; *found: one is better than none. */
static hawser_status move_find(const Search *s, int q, int *a, int *b, Window *best, int *found)
{
    int from, to;
    *a = q > ASIDE ? q - ASIDE : 0;
    *b = q + ASIDE < *s->n ? q + ASIDE : *s->n - 1;
    const Window now = window_of(s, *a, *b, &from, &to);
    double least, cost;
    *best = now;
    *found = 0;
    if (to - from < 3) return HAWSER_OK;
    hawser_status status = window_cost(s, best, from, to, INFINITY, &least);
    const int rough = !(least - pieces_cost(best->n, best->piece) < ROUGH * (to - from));
    for (size_t k = rough ? 0 : ROUGH_MOVES; k < sizeof moves / sizeof *moves && !status; ++k) {
        Window w = now;
        if (!moves[k](&w, q - *a)) continue;
        int allowed = 1;
        for (int i = 0; i < w.n && !s->clothoids; ++i) allowed &= w.piece[i].kind != PIECE_CLOTHOID;
        if (!allowed || w.n == 0) continue;
        status = window_cost(s, &w, from, to, least - 1, &cost);
        if (!(cost < least - 1)) continue;
        *best = w;
        least = cost;
        *found = 1;
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------------- the search */

double chain_cost(int n, const Piece *piece, int m, const Node *node, double sigma, const Foot *foot)
{
    return chain_squares(m, node, foot) / (sigma * sigma) + pieces_cost(n, piece);
}

static hawser_status refine(Search *s, int steps)
{
    return chain_refine(*s->n, *s->piece, s->m, s->node, steps, INFINITY, s->foot, s->err);
}

static double whole_cost(const Search *s)
{
    return chain_cost(*s->n, *s->piece, s->m, s->node, sqrt(s->sigma2), s->foot);
}

/* A chain to come back to. */
typedef struct Kept {
    int n;
    Piece *piece;
    double cost;
} Kept;

static hawser_status keep(const Search *s, double cost, Kept *k)
{
    Piece *const room = realloc(k->piece, (size_t)*s->n * sizeof *room);
    if (!room) return error_memory(s->err);
    memcpy(room, *s->piece, (size_t)*s->n * sizeof *room);
    *k = (Kept){*s->n, room, cost};
    return HAWSER_OK;
}

/* Numbers of pieces, and feet on them, after pieces a..b have become n: those of the nodes between are found anew. */
static hawser_status feet_renew(Search *s, int a, int n, int from, int to, int more)
{
    for (int i = to; i < s->m; ++i) s->foot[i].piece += more;
    const hawser_status status =
        to - from < 2 ? HAWSER_OK
                      : chain_refine(n, *s->piece + a, to - from, s->node + from, 0, INFINITY, s->foot + from, s->err);
    for (int i = from; i < to; ++i) s->foot[i].piece += a;
    return status;
}

/* What a narrow window, of pieces a..b, says is better must be so in a wide one; *better: it was, and the chain has it.
 * Farther away it changes next to nothing, so that a long line costs no more by the metre than a short one. */
static hawser_status settle(Search *s, int a, int b, const Window *w, int *better)
{
    const int first = a > FARTHER ? a - FARTHER : 0, last = b + FARTHER < *s->n ? b + FARTHER : *s->n - 1;
    const int more = w->n - (b - a + 1), all_from = node_of(s, first), all_to = node_of(s, last + 1);
    int narrow_from, narrow_to;
    double before = INFINITY, after = INFINITY, cut[2];
    window_of(s, a, b, &narrow_from, &narrow_to);
    const int whole[2] = {narrow_from == node_of(s, a), narrow_to == node_of(s, b + 1)};
    Window old = {.n = last - first + 1}, was, is = {.n = last - first + 1 + more};
    memcpy(old.piece, &(*s->piece)[first], (size_t)old.n * sizeof *old.piece);
    int from = all_from, to = all_to;
    ends_cut(s, first < a ? first : -1, last > b ? last : -1, &from, &to, cut);
    was = old;
    window_shorten(&was, cut);
    hawser_status status = window_cost(s, &was, from, to, INFINITY, &before);
    if (!status) status = window_put(s, a, b, w, whole[0], whole[1]);
    if (status) return status;
    memcpy(is.piece, &(*s->piece)[first], (size_t)is.n * sizeof *is.piece);
    window_shorten(&is, cut);
    status = window_cost(s, &is, from, to, INFINITY, &after);
    *better = !status && after < before - 0.5;
    if (!status)
        status =
            window_put(s, first, last + more, *better ? &is : &old, !*better || cut[0] == 0, !*better || cut[1] == 0);
    if (!status && *better) status = feet_renew(s, first, is.n, all_from, all_to, more);
    return status;
}

/* Every piece once about which something may have become better; *better: something was. */
static hawser_status sweep(Search *s, int *better)
{
    hawser_status status = HAWSER_OK;
    *better = 0;
    for (int q = 0; q < *s->n && !status; ++q) {
        int a, b, found, good = 0;
        Window w;
        if ((*s->piece)[q].settled) continue;
        status = move_find(s, q, &a, &b, &w, &found);
        if (!status && found) status = settle(s, a, b, &w, &good);
        if (status) break;
        for (int i = a - WINDOW; good && i <= b + WINDOW + GROWTH; ++i) {
            if (i >= 0 && i < *s->n) (*s->piece)[i].settled = 0;
        }
        if (!good) (*s->piece)[q].settled = 1;
        *better |= good;
    }
    return status;
}

/* The chain as it is now is refined as a whole; where that is no better than the best one so far, that one comes back.
 */
static hawser_status whole_settle(Search *s, Kept *best, int *better)
{
    hawser_status status = refine(s, STEPS);
    const double cost = whole_cost(s);
    if (status) return status;
    if (cost < best->cost) return keep(s, cost, best);
    *better = 0;
    Piece *const room = realloc(*s->piece, (size_t)best->n * sizeof *room);
    if (!room) return error_memory(s->err);
    *s->piece = room;
    *s->n = best->n;
    memcpy(room, best->piece, (size_t)best->n * sizeof *room);
    return refine(s, 0);
}

hawser_status chain_improve(Piece **piece, int *n, int m, const Node *node, double sigma, int clothoids, Foot *foot,
                            hawser_error *err)
{
    Search s = {piece, n, node, foot, malloc((size_t)m * sizeof *foot), m, sigma * sigma, clothoids, err};
    Kept best = {0, NULL, INFINITY};
    int better = 1;
    hawser_status status = s.trial ? refine(&s, 3 * STEPS) : error_memory(err);
    if (!status) status = keep(&s, whole_cost(&s), &best);
    for (int i = 0; i < SWEEPS && better && !status; ++i) {
        status = sweep(&s, &better);
        if (!status && better) status = whole_settle(&s, &best, &better);
    }
    free(s.trial);
    free(best.piece);
    return status;
}

/* The sharpest arc that stays within half the deviation of a corner, as far as its neighbours have room. */
hawser_status corners_round(Piece **piece, int *n, double deviation, hawser_error *err)
{
    for (int i = 0; i + 1 < *n; ++i) {
        Piece *p = &(*piece)[i];
        const double end = p->e.heading + 0.5 * p->e.length * (p->e.k0 + p->e.k1);
        const double turn = remainder(p[1].e.heading - end, 2 * PI), half = 0.5 * fabs(turn);
        const int straights = p[0].kind == PIECE_STRAIGHT && p[1].kind == PIECE_STRAIGHT;
        const double shorter =
            fmin(p[0].e.length, p[1].e.length); /* a small turn between others they settle themselves */
        if (fabs(turn) < (straights ? 1e-9 : fmin(0.15, 4 * deviation / shorter))) continue;
        Piece *const wider = realloc(*piece, (size_t)(*n + 1) * sizeof *wider);
        if (!wider) return error_memory(err);
        *piece = wider;
        p = &wider[i];
        const double room = 0.3 * shorter, outside = 1 / fmax(cos(half), 0.05) - 1;
        const double tangent = fmin(room, 0.5 * deviation / outside * tan(fmin(half, 1.5)));
        const double radius = tangent / tan(fmin(half, 1.5));
        piece_shorten(&p[0], 0, tangent);
        piece_shorten(&p[1], tangent, 0);
        const PlanElement from = plan_at(&p->e, p->e.length);
        const double k = (turn > 0 ? 1 : -1) / radius;
        memmove(&p[2], &p[1], (size_t)(*n - i - 1) * sizeof *p);
        p[1] = (Piece){.kind = PIECE_ARC,
                       .kept = straights && fabs(turn) > 0.15,
                       .e = {from.x, from.y, from.heading, radius * 2 * half, k, k, 0, 0}};
        ++*n;
        ++i;
    }
    return HAWSER_OK;
}
