#include "theory/plan_head.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/search.h"

static int sign_of(int way) { return way == PLAN_BACKWARD ? -1 : 1; }

/* Whether no friction is larger at rest, so that a restart is the pull at speed (PN2). */
static int restarts_alike(const PlanDef *def)
{
    for (int i = 0; i < def->n_stretches; i++) {
        const PullStretch *const s = &def->stretch[i];
        if (s->mu_static > s->mu || s->mu_rope_static > s->mu_rope) return 0;
    }
    return 1;
}

/* One place. before[2]: what was solved for another, at speed and from rest, of which spans are taken over; it becomes
 * this place's. */
static hawser_status head_solve(const PlanDef *def, int way, double head, Pull before[2], HeadForce *out,
                                hawser_error *err)
{
    const int alike = restarts_alike(def);
    *out = (HeadForce){.head = head};
    for (int restart = 0; restart < (alike ? 1 : 2); restart++) {
        const PlanPullDef what = {
            .way = way, .restart = restart, .head = head, .forces_only = 1, .like = &before[restart]};
        Pull pull;
        const hawser_status status = plan_pull(def, &what, &pull, err);
        if (status) return status;
        const double force = pull.end_tension + plan_allowance(def, way);
        if (!restart) out->tension = pull_at(&pull, head).tension;
        if (!restart) out->force = force;
        if (restart || alike) out->restart = force;
        pull_clear(&before[restart]);
        before[restart] = pull;
    }
    return HAWSER_OK;
}

hawser_status plan_head(const PlanDef *def, int way, double head, HeadForce *out, hawser_error *err)
{
    Pull solved[2] = {{0}, {0}};
    const hawser_status status = head_solve(def, way, head, solved, out, err);
    pull_clear(&solved[0]);
    pull_clear(&solved[1]);
    return status;
}

/* --------------------------------------------------------------------------------------------- the series */

/* Places of the head, in the pull's order. */
typedef struct Places {
    int n;
    double *s; /* [n] m */
} Places;

/* Where the force has corners: ends of pieces, of stretches, machines. Ahead of a machine, as it has not begun to push
 * yet, the force is as large as anywhere near, and just behind a pit, from which the cable is pulled anew, it may be:
 * these places too, by this much of the route. */
static const double JUST_AHEAD = 1e-9;

static int corners_collect(const PlanDef *def, int way, double *s)
{
    int n = 0;
    const double before = JUST_AHEAD * def->route->length * sign_of(way);
    s[n++] = plan_last(def, way); /* the pull begins with the route */
    for (int p = 0; p < def->route->n; p++) s[n++] = def->route->piece[p].s0;
    s[n++] = def->route->length;
    for (int i = 0; i < def->n_stretches; i++) s[n++] = def->stretch[i].from;
    for (int i = 0; i < def->n_pushes + def->n_steps; i++) {
        const double at = i < def->n_pushes ? def->push[i].at : def->step[i - def->n_pushes].at;
        const int pit = i >= def->n_pushes && def->step[i - def->n_pushes].kind == STEP_ANEW;
        s[n++] = at;
        s[n++] = pit ? at + before : at - before;
    }
    return n;
}

/* Keeps what lies on the pull, fills the gaps, and turns it into the pull's order. */
static hawser_status places_find(const PlanDef *def, int way, double apart, Places *out, hawser_error *err)
{
    const double low = fmin(plan_first(def, way), plan_last(def, way));
    const double high = fmax(plan_first(def, way), plan_last(def, way));
    const int corners = 2 + def->route->n + def->n_stretches + 2 * (def->n_pushes + def->n_steps);
    const int even = apart < INFINITY ? (int)ceil((high - low) / apart) : 0;
    double *const corner = malloc((size_t)corners * sizeof *corner);
    out->n = 0;
    out->s = malloc((size_t)(corners + even + 1) * sizeof *out->s);
    if (!corner || !out->s) {
        free(corner);
        return error_memory(err);
    }
    const int n = corners_collect(def, way, corner);
    qsort(corner, (size_t)n, sizeof *corner, compare_first);
    double last = -INFINITY;
    for (int i = 0; i < n; i++) {
        if (!(corner[i] >= low && corner[i] <= high) || !(corner[i] > last)) continue;
        const int parts = last > -INFINITY && even > 0 ? (int)fmax(1, ceil((corner[i] - last) / apart - 1e-9)) : 1;
        for (int k = 1; k < parts; k++) out->s[out->n++] = last + (corner[i] - last) * k / parts;
        out->s[out->n++] = last = corner[i];
    }
    free(corner);
    for (int i = 0; way == PLAN_BACKWARD && i < out->n / 2; i++) {
        const double swap = out->s[i];
        out->s[i] = out->s[out->n - 1 - i];
        out->s[out->n - 1 - i] = swap;
    }
    return HAWSER_OK;
}

static double force_of(const HeadForce *f, int restart) { return restart ? f->restart : f->force; }

/* Whichever is larger; the one found first where they are equal. */
static void peak_take(const HeadForce *f, int restart, HeadForce *peak)
{
    if (force_of(f, restart) > force_of(peak, restart)) *peak = *f;
}

/* A peak that is looked for closer. */
typedef struct Refine {
    const PlanDef *def;
    int way, restart;
    Pull *before; /* [2], as head_solve's */
    HeadForce *peak;
    hawser_status status;
    hawser_error *err;
} Refine;

static double peak_look(void *what, double head)
{
    Refine *const r = what;
    HeadForce here = {0};
    if (r->status) return 0;
    r->status = head_solve(r->def, r->way, head, r->before, &here, r->err);
    if (!r->status) peak_take(&here, r->restart, r->peak);
    return force_of(&here, r->restart);
}

/* The largest between two places on both sides of a row that is larger than they are. */
static hawser_status peak_refine(const PlanDef *def, int way, int restart, double a, double b, Pull before[2],
                                 HeadForce *peak, hawser_error *err)
{
    Refine r = {def, way, restart, before, peak, HAWSER_OK, err};
    search_top(peak_look, &r, a, b, 24);
    return r.status;
}

/* Both peaks: of the rows, and beside those that stand above their neighbours. */
static hawser_status peaks_find(const PlanDef *def, int way, Pull before[2], HeadSeries *s, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int restart = 0; restart < 2 && !status; restart++) {
        HeadForce *const peak = restart ? &s->restart_peak : &s->peak;
        int top = 0;
        if (restart && restarts_alike(def)) {
            *peak = s->peak;
            continue;
        }
        for (int i = 1; i < s->n; i++) {
            if (force_of(&s->row[i], restart) > force_of(&s->row[top], restart)) top = i;
        }
        *peak = s->row[top];
        if (top == 0 || top == s->n - 1) continue;
        status = peak_refine(def, way, restart, s->row[top - 1].head, s->row[top + 1].head, before, peak, err);
    }
    return status;
}

/* ------------------------------------------------------------------------------------------- the peaks alone */

/* Whether friction behind the head depends on where the head is. */
static int wears_by_head(const PlanDef *def) { return def->n_wear > 0 && def->wear_by == WEAR_PLACE; }

/* The cable's tension where its head is at s; `span`, the one that s lies in, moves on with it. */
static double cable_tension(const Pull *pull, int *span, double s)
{
    while (*span < pull->n && pull->span[*span].law.direction * (s - pull->span[*span].s1) >= 0) ++*span;
    if (*span == pull->n) return pull->end_tension;
    const PullSpan *const at = &pull->span[*span];
    return s == at->s0 ? at->t0 : span_integrate(&at->law, at->s0, at->t0, s, NULL);
}

/* The rope's tension at `to`, from `from` on, without a corner between them. */
static double rope_onward(const PlanDef *def, int way, int restart, double from, double to, double tension)
{
    const double middle = from + (to - from) / 2;
    const PullStretch *const s = stretch_at(def->n_stretches, def->stretch, middle);
    const SpanLaw law = {.law = def->law,
                         .direction = sign_of(way),
                         .weight = def->rope_weight,
                         .mu = restart ? fmax(s->mu_rope, s->mu_rope_static) : s->mu_rope,
                         .separate = s->separate,
                         .line = span_line(def->route, middle)};
    return span_integrate(&law, from, tension, to, NULL);
}

/* The places of a pull's head, and what is found there. */
typedef struct Course {
    const Places *places;
    int i;           /* the section that is looked at begins with that place */
    double *tension; /* [places->n] N, of the tightest rope there; NULL: not wanted */
} Course;

/* The place of the head, of those of the section that begins with place i, at which the winch needs most, and that
 * force. Of two ropes the one that is tighter at a place is so at the section's end: only the tightest is followed. i
 * becomes the next section's. */
static hawser_status section_top(const PlanDef *def, int way, int restart, Course *course, int *top, double *most,
                                 hawser_error *err)
{
    const Places *const places = course->places;
    const int first = course->i;
    const PlanSection section = plan_section_at(def, way, places->s[first]);
    const PlanPullDef what = {.way = way, .restart = restart, .head = section.to, .forces_only = 1};
    Pull cable;
    hawser_status status = plan_pull(def, &what, &cable, err);
    if (status) return status;
    double tightest = -INFINITY;
    int span = 0, i = first;
    for (; i < places->n && sign_of(way) * (places->s[i] - section.to) <= 0; ++i) {
        const double s = places->s[i];
        if (i > first) tightest = rope_onward(def, way, restart, places->s[i - 1], s, tightest);
        const double own = cable_tension(&cable, &span, s);
        if (own > tightest) *top = i;
        tightest = fmax(own, tightest);
        if (course->tension) course->tension[i] = tightest;
    }
    pull_clear(&cable);
    course->i = i;
    *most = tightest;
    if (isfinite(tightest)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "the tension grows past all bounds: too much friction and turn");
}

/* One of both peaks: the place by all sections, then beside it. */
static hawser_status peak_find(const PlanDef *def, int way, int restart, const Places *places, Pull before[2],
                               HeadForce *peak, hawser_error *err)
{
    int top = 0;
    double most = -INFINITY;
    assert(places->n > 0); /* the ends of the route */
    Course course = {.places = places};
    do {
        int here = course.i;
        double force;
        const hawser_status status = section_top(def, way, restart, &course, &here, &force, err);
        if (status) return status;
        if (force > most) top = here;
        most = fmax(force, most);
    } while (course.i < places->n);
    const hawser_status status = head_solve(def, way, places->s[top], before, peak, err);
    if (status || top == 0 || top == places->n - 1) return status;
    return peak_refine(def, way, restart, places->s[top - 1], places->s[top + 1], before, peak, err);
}

static hawser_status peaks_by_sections(const PlanDef *def, int way, const Places *places, HeadSeries *s,
                                       hawser_error *err)
{
    Pull before[2] = {{0}, {0}};
    hawser_status status = peak_find(def, way, 0, places, before, &s->peak, err);
    s->restart_peak = s->peak;
    if (!status && !restarts_alike(def)) status = peak_find(def, way, 1, places, before, &s->restart_peak, err);
    pull_clear(&before[0]);
    pull_clear(&before[1]);
    return status;
}

hawser_status plan_peaks(const PlanDef *def, int way, HeadSeries *out, hawser_error *err)
{
    Places places;
    if (wears_by_head(def)) return plan_heads(def, way, INFINITY, out, err);
    *out = (HeadSeries){0};
    hawser_status status = places_find(def, way, INFINITY, &places, err);
    if (!status) status = peaks_by_sections(def, way, &places, out, err);
    free(places.s);
    return status;
}

/* -------------------------------------------------------------------------------------------------- the rope */

/* Those that the head does not come to, which begins at `from`, are none. */
static void places_begin(Places *places, int way, double from)
{
    int before = 0;
    while (before < places->n && sign_of(way) * (places->s[before] - from) < 0) ++before;
    places->n -= before;
    memmove(places->s, places->s + before, (size_t)places->n * sizeof *places->s);
}

hawser_status plan_rope(const PlanDef *def, int way, int restart, double from, double apart, RopeSeries *out,
                        hawser_error *err)
{
    Places places;
    *out = (RopeSeries){0};
    hawser_status status = places_find(def, way, apart, &places, err);
    if (status) {
        free(places.s);
        return status;
    }
    places_begin(&places, way, from);
    Course course = {.places = &places, .tension = calloc((size_t)places.n + 1, sizeof *course.tension)};
    *out = (RopeSeries){way, restart, places.n, places.s, course.tension};
    if (!course.tension) status = error_memory(err);
    while (!status && course.i < places.n) {
        int here;
        double force;
        status = section_top(def, way, restart, &course, &here, &force, err);
    }
    if (status) plan_rope_free(out);
    return status;
}

void plan_rope_free(RopeSeries *rope)
{
    free(rope->s);
    free(rope->tension);
    *rope = (RopeSeries){0};
}

void plan_rope_ahead(const PlanDef *def, const RopeSeries *rope, double head, double until, double *tension)
{
    const int sign = sign_of(rope->way);
    const double ends = plan_section_at(def, rope->way, head).to;
    double s = head, there = drawn_at(&(Drawn){.rope = rope}, head);
    for (int i = 0; i < rope->n && sign * (rope->s[i] - until) <= 0 && sign * (rope->s[i] - ends) <= 0; ++i) {
        if (sign * (rope->s[i] - head) <= 0) continue;
        there = rope_onward(def, rope->way, rope->restart, s, rope->s[i], there);
        s = rope->s[i];
        tension[i] = there;
    }
}

double drawn_at(const Drawn *drawn, double s)
{
    const RopeSeries *const rope = drawn->rope;
    if (!rope) return pull_at(drawn->pull, s).tension;
    int low = 0, high = rope->n - 1; /* s lies between them */
    const int sign = high > 0 && rope->s[high] < rope->s[0] ? -1 : 1;
    if (high < 0 || sign * (s - rope->s[0]) < 0) return 0;
    if (sign * (s - rope->s[high]) >= 0) return rope->tension[high];
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (sign * (s - rope->s[middle]) < 0) high = middle;
        if (sign * (s - rope->s[middle]) >= 0) low = middle;
    }
    const double part = (s - rope->s[low]) / (rope->s[high] - rope->s[low]);
    return rope->tension[low] + part * (rope->tension[high] - rope->tension[low]);
}

/* ------------------------------------------------------------------------------------------------- the rows */

/* Each row costs as much as there are corners: of a route with more than a thousand only so many rows that both
 * together stay below a million. */
static void places_thin(Places *places)
{
    enum { CORNERS = 1000, FEWEST = 100, WORK = 1000000 };
    const int all = places->n, rows = WORK / all > FEWEST ? WORK / all : FEWEST;
    if (all <= CORNERS) return;
    const int every = (all + rows - 1) / rows;
    places->n = 0;
    for (int i = 0; i < all; i++) {
        if (i % every == 0 || i == all - 1) places->s[places->n++] = places->s[i];
    }
}

hawser_status plan_heads(const PlanDef *def, int way, double apart, HeadSeries *out, hawser_error *err)
{
    Places places;
    Pull before[2] = {{0}, {0}};
    *out = (HeadSeries){0};
    hawser_status status = places_find(def, way, apart, &places, err);
    const int all = status ? 0 : places.n;
    if (!status) {
        assert(places.n > 0); /* both ends of the way are places */
        places_thin(&places);
        out->row = malloc((size_t)places.n * sizeof *out->row);
        if (!out->row) status = error_memory(err);
    }
    for (; !status && out->n < places.n; out->n++) {
        status = head_solve(def, way, places.s[out->n], before, &out->row[out->n], err);
    }
    const int thinned = places.n < all && !wears_by_head(def);
    free(places.s);
    if (!status && !thinned) status = peaks_find(def, way, before, out, err);
    pull_clear(&before[0]);
    pull_clear(&before[1]);
    if (!status && thinned) {
        HeadSeries peaks;
        status = plan_peaks(def, way, &peaks, err);
        out->peak = peaks.peak;
        out->restart_peak = peaks.restart_peak;
    }
    if (status) plan_heads_free(out);
    return status;
}

void plan_heads_free(HeadSeries *s)
{
    free(s->row);
    *s = (HeadSeries){0};
}

/* Rope all along a section, held by its weight and the friction of that: in bends there is more. */
hawser_status plan_relief(const PlanDef *def, int way, double *relief, hawser_error *err)
{
    PlanDef rope = *def;
    rope.law = PULL_NO_CAPSTAN;
    rope.n_pushes = 0;
    rope.enough = 0;
    *relief = 0;
    for (int i = 0; i < plan_sections(def, way) && def->rope_weight > 0; i++) {
        const double ahead = sign_of(way) * JUST_AHEAD * def->route->length;
        const PlanPullDef what = {.way = way, .head = plan_section(def, way, i).from + ahead};
        Pull pull;
        const hawser_status status = plan_pull(&rope, &what, &pull, err);
        if (status) return status;
        *relief = fmax(*relief, pull.max_tension - pull.end_tension);
        pull_clear(&pull);
    }
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------- the brake */

/* A brake that is tried. */
typedef struct BrakeTrial {
    PlanDef def;
    int way;
    double before, enough; /* N, back tension without it; compression that is rounding only */
    hawser_status status;
    hawser_error *err;
} BrakeTrial;

static int brake_holds(void *what, double brake)
{
    BrakeTrial *const t = what;
    const PlanPullDef whole = {.way = t->way, .whole = 1};
    Pull pull;
    if (t->status) return 0;
    t->def.back_tension = t->before + brake;
    t->status = plan_pull(&t->def, &whole, &pull, t->err);
    if (t->status) return 0;
    const int held = pull.min_tension >= -t->enough;
    pull_clear(&pull);
    return held;
}

/* The winch's force with the brake, over all places of the head. */
static hawser_status brake_force(const PlanDef *def, int way, Brake *out, hawser_error *err)
{
    const PlanPullDef whole = {.way = way, .whole = 1};
    Pull pull;
    HeadSeries heads;
    hawser_status status = plan_pull(def, &whole, &pull, err);
    if (status) return status;
    out->max_tension = pull.max_tension;
    out->force = pull.end_tension + plan_allowance(def, way);
    if (fabs(out->force) < 1e-9 * pull.max_tension) out->force = 0; /* rounding */
    pull_clear(&pull);
    status = plan_peaks(def, way, &heads, err);
    if (status) return status;
    out->peak = heads.peak.force;
    plan_heads_free(&heads);
    return HAWSER_OK;
}

hawser_status plan_brake(const PlanDef *def, int way, Brake *out, hawser_error *err)
{
    const PlanPullDef whole = {.way = way, .whole = 1};
    const PlanDef slack = plan_slack(def);
    Pull pull;
    *out = (Brake){0};
    hawser_status status = plan_pull(&slack, &whole, &pull, err);
    if (status) return status;
    const double pushed = -pull.min_tension;
    BrakeTrial t = {slack, way, slack.back_tension, 1e-9 * fmax(1, pull.max_tension), HAWSER_OK, err};
    out->where = pull.min_at;
    out->piece = pull.min_piece;
    pull_clear(&pull);
    if (pushed > t.enough) {
        /* no more than the compression is ever needed, but for a pit behind which the cable runs away by itself */
        const SearchDef search = {brake_holds, &t, 2 * pushed, 1e-9 * pushed};
        const SearchBound least = search_bound(&search);
        if (t.status) return t.status;
        out->brake = least.end == SEARCH_NOWHERE ? NAN : least.value;
        t.def.back_tension = t.before + (least.end == SEARCH_NOWHERE ? 0 : least.value);
    }
    t.def.back_tension += def->back_fall;
    t.def.slack = 0;
    return brake_force(&t.def, way, out, err);
}
