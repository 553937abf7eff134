#include "theory/plan.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "theory/closed_form.h"
#include "theory/search.h"

static int way_sign(int way) { return way == PLAN_BACKWARD ? -1 : 1; }

double plan_first(const PlanDef *def, int way) { return way == PLAN_BACKWARD ? def->route->length : 0; }

double plan_last(const PlanDef *def, int way)
{
    return way == PLAN_BACKWARD ? 0 - def->beyond : def->route->length + def->beyond;
}

double plan_allowance(const PlanDef *def, int way)
{
    /* weight of the stretch where the pull starts, which the reel pays out */
    const double weight = stretch_at(def->n_stretches, def->stretch, plan_first(def, way))->weight;
    return weight * def->rope_length + def->rope_force + def->drawn[way];
}

/* --------------------------------------------------------------------------------------------- sections */

/* The next pit after s along the pull and before its end; -1: none. */
static int next_pit(const PlanDef *def, int way, double s)
{
    const int sign = way_sign(way);
    int next = -1;
    for (int i = 0; i < def->n_steps; i++) {
        const double at = def->step[i].at;
        if (def->step[i].kind != STEP_ANEW || sign * (at - s) <= 0 || sign * (plan_last(def, way) - at) <= 0) continue;
        if (next < 0 || sign * (at - def->step[next].at) < 0) next = i;
    }
    return next;
}

/* Weight that counts on a straight whose pieces of cable differ and have unknown positions: the heaviest where weight
 * holds back (`metre`, share of the weight that does, >= 0), the lightest where it runs ahead; for the least tension
 * the reverse (T28). */
static double weight_of(const PlanDef *def, const PullStretch *s, double metre)
{
    const int light = def->lightest > 0 && def->slack == (metre >= 0);
    return light ? fmin(def->lightest, s->weight) : s->weight;
}

/* Share of its weight with which a metre holds back on a straight that rises by `rise` per metre. */
static double share_held(double rise, double mu) { return rise + mu * sqrt(fmax(0, 1 - rise * rise)); }

/* Tension from the cable that still lies behind the start, pulled forward (T27): the most or the least of the whole
 * pull, N. */
static double behind_tension(const PlanDef *def, int way, int restart)
{
    if (way == PLAN_BACKWARD) return 0;
    const PullStretch *const s = stretch_at(def->n_stretches, def->stretch, 0);
    const double rise = route_at(def->route, 0).tangent.z, mu = restart ? fmax(s->mu, s->mu_static) : s->mu;
    const double share = share_held(rise, def->behind_slides ? mu : 0), metre = share * weight_of(def, s, share);
    const double first = metre * def->behind, last = metre * def->behind_least;
    return def->slack ? fmin(first, last) : fmax(first, last);
}

/* The pit at the start of the pull; -1: none. */
static int first_pit(const PlanDef *def, int way)
{
    int i = def->n_steps - 1;
    while (i >= 0 && !(def->step[i].kind == STEP_ANEW && def->step[i].at == plan_first(def, way))) i--;
    return i;
}

/* Tension (T24) less the push, N, with the weight of the stretch where the pull begins, which the reel pays out; at a
 * pit the pit's own (PN3). */
static double start_tension(const PlanDef *def, int way)
{
    const int pit = first_pit(def, way);
    if (pit >= 0) return def->step[pit].force;
    const PullStretch *const s = stretch_at(def->n_stretches, def->stretch, plan_first(def, way));
    return weight_of(def, s, 1) * def->reel_length + def->back_tension + behind_tension(def, way, 0) - def->feed;
}

static PlanSection first_section(const PlanDef *def, int way)
{
    const double first = plan_first(def, way);
    const int pit = next_pit(def, way, first);
    return (PlanSection){first, pit < 0 ? plan_last(def, way) : def->step[pit].at, start_tension(def, way), -1, pit};
}

static PlanSection section_after(const PlanDef *def, int way, const PlanSection *before)
{
    const int pit = next_pit(def, way, before->to);
    return (PlanSection){before->to, pit < 0 ? plan_last(def, way) : def->step[pit].at, def->step[before->ends].force,
                         before->ends, pit};
}

int plan_sections(const PlanDef *def, int way)
{
    int n = 1;
    for (PlanSection s = first_section(def, way); s.ends >= 0; s = section_after(def, way, &s)) n++;
    return n;
}

PlanSection plan_section(const PlanDef *def, int way, int i)
{
    PlanSection s = first_section(def, way);
    for (; i > 0 && s.ends >= 0; i--) s = section_after(def, way, &s);
    return s;
}

PlanSection plan_section_at(const PlanDef *def, int way, double head)
{
    PlanSection s = first_section(def, way);
    while (s.ends >= 0 && way_sign(way) * (head - s.to) > 0) s = section_after(def, way, &s);
    return s;
}

/* ------------------------------------------------------------------------------ stretches of the route */

/* The stretches of one pull, by rising place. */
typedef struct Course {
    int n;
    PullStretch *stretch; /* [n] */
} Course;

/* Friction factor at a length: that of the last row that begins before it; 1 before the first. */
static double wear_at(const PlanDef *def, double length)
{
    double factor = 1;
    for (int k = 0; k < def->n_wear && def->wear[k].from <= length; k++) factor = def->wear[k].factor;
    return factor;
}

/* Length that determines the wear at s, with the head at `head`, and its inverse: (PN4). */
static double wear_length(const PlanDef *def, int way, double head, double s)
{
    return way_sign(way) * (def->wear_by == WEAR_CABLE ? s - plan_first(def, way) : head - s);
}

static double wear_place(const PlanDef *def, int way, double head, double length)
{
    return def->wear_by == WEAR_CABLE ? plan_first(def, way) + way_sign(way) * length : head - way_sign(way) * length;
}

/* Friction factor at s by wear (PN4), with the cable's head at `head`. */
static double plan_friction_factor(const PlanDef *def, int way, double head, double s)
{
    return wear_at(def, wear_length(def, way, head, s));
}

/* Builds a stretch: cable up to the head and rope beyond it, friction by wear, the duct's correction on the cable. */
static PullStretch stretch_make(const PlanDef *def, int way, double head, double begin, double middle)
{
    PullStretch s = *stretch_at(def->n_stretches, def->stretch, middle);
    s.from = begin;
    if (way_sign(way) * (middle - head) > 0) {
        s.weight = def->rope_weight;
        s.mu = s.mu_rope;
        s.mu_static = s.mu_rope_static;
        s.share = 1;
        s.room = 0; /* a rope is never in compression */
        return s;
    }
    const double factor = plan_friction_factor(def, way, head, middle);
    s.mu *= factor;
    s.mu_static *= factor;
    s.lightest = fmin(def->lightest, s.weight);
    return s;
}

/* Collects every place where something changes, then the stretches between them. */
static hawser_status course_make(const PlanDef *def, int way, double head, Course *out, hawser_error *err)
{
    out->stretch = malloc((size_t)(def->n_stretches + def->n_wear + 1) * sizeof *out->stretch);
    if (!out->stretch) return error_memory(err);
    PullStretch *const s = out->stretch;
    int n = 0;
    for (int i = 0; i < def->n_stretches; i++) s[n++].from = def->stretch[i].from;
    for (int k = -1; k < def->n_wear; k++, n++) {
        const double at = k < 0 ? head : wear_place(def, way, head, def->wear[k].from);
        int i = n;
        for (; i > 0 && s[i - 1].from > at; i--) s[i].from = s[i - 1].from;
        s[i].from = at;
    }
    out->n = 0;
    for (int i = 0; i < n; i++) {
        const double begin = s[i].from, end = i + 1 < n ? s[i + 1].from : begin + 2;
        if (end > begin) s[out->n++] = stretch_make(def, way, head, begin, begin + (end - begin) / 2);
    }
    return HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------- the pull */

/* Collects pushes and machines that the cable has reached in `step` [n_pushes + n_steps]; the rope passes them freely.
 * Pits at the ends of a section are not steps. Returns the number. */
static int steps_collect(const PlanDef *def, const PlanPullDef *what, double head, PullStep *step)
{
    const int sign = way_sign(what->way);
    const PullStep *const push = what->way == PLAN_BACKWARD && def->push_back ? def->push_back : def->push;
    int n = 0;
    for (int i = 0; i < def->n_pushes; i++) {
        if (sign * (head - push[i].at) < 0) continue;
        const PullStep law = {.at = push[i].at, .kind = STEP_PUSH, .item = i};
        step[n++] = def->pushes ? law : (PullStep){.at = push[i].at, .force = -push[i].force};
    }
    for (int i = 0; i < def->n_steps; i++) {
        const PullStep *const s = &def->step[i];
        const int pit = s->kind == STEP_ANEW, at_end = s->at == plan_last(def, what->way);
        if (sign * (head - s->at) >= 0 && !(pit && (!what->whole || at_end))) step[n++] = *s;
    }
    return n;
}

/* Increase of a section's start tension from rest, N. */
static double start_rest(const PlanDef *def, const PlanPullDef *what, const PlanSection *section)
{
    if (!what->restart || section->begins >= 0 || first_pit(def, what->way) >= 0) return 0;
    return behind_tension(def, what->way, 1) - behind_tension(def, what->way, 0);
}

PlanDef plan_slack(const PlanDef *def)
{
    PlanDef slack = *def;
    slack.back_tension -= def->back_fall;
    slack.slack = 1;
    return slack;
}

int plan_slackens(const PlanDef *def)
{
    return def->back_fall > 0 || def->behind > def->behind_least || def->lightest > 0;
}

hawser_status plan_pull(const PlanDef *def, const PlanPullDef *what, Pull *out, hawser_error *err)
{
    PlanSection section = plan_section_at(def, what->way, what->whole ? plan_first(def, what->way) : what->head);
    if (what->whole) section.to = plan_last(def, what->way);
    const double head = what->whole ? section.to : what->head;
    Course course = {0};
    *out = (Pull){0};
    PullStep *const step = malloc((size_t)(def->n_pushes + def->n_steps + 1) * sizeof *step);
    hawser_status status = step ? course_make(def, what->way, head, &course, err) : error_memory(err);
    if (!status) {
        const PullDef pull = {.route = def->route,
                              .law = def->law,
                              .from = section.from,
                              .to = section.to,
                              .start_tension = section.start + start_rest(def, what, &section),
                              .restart = what->restart,
                              .least = def->slack,
                              .enough = def->enough,
                              .forces_only = what->forces_only,
                              .like = what->like,
                              .n_stretches = course.n,
                              .stretch = course.stretch,
                              .n_steps = steps_collect(def, what, head, step),
                              .step = step,
                              .pushes = def->pushes};
        status = pull_solve(&pull, out, err);
    }
    free(course.stretch);
    free(step);
    return status;
}

/* Checks that no static friction is larger, so that a restart equals the moving pull (PN2). */
static int restarts_alike(const PlanDef *def)
{
    for (int i = 0; i < def->n_stretches; i++) {
        const PullStretch *const s = &def->stretch[i];
        if (s->mu_static > s->mu || s->mu_rope_static > s->mu_rope) return 0;
    }
    return 1;
}

/* Solves one place of the head, moving or from rest. before: a solution of another place, whose spans are reused;
 * replaced by this place's. */
static hawser_status force_solve(const PlanDef *def, int way, int restart, double head, Pull *before, HeadForce *out,
                                 hawser_error *err)
{
    const PlanPullDef what = {.way = way, .restart = restart, .head = head, .forces_only = 1, .like = before};
    Pull pull;
    const hawser_status status = plan_pull(def, &what, &pull, err);
    if (status) return status;
    out->head = head;
    *(restart ? &out->restart : &out->force) = pull.end_tension + plan_allowance(def, way);
    if (!restart) out->tension = pull_at(&pull, head).tension;
    pull_clear(before);
    *before = pull;
    return HAWSER_OK;
}

/* The same moving and from rest; before[2] as above. */
static hawser_status head_solve(const PlanDef *def, int way, double head, Pull before[2], HeadForce *out,
                                hawser_error *err)
{
    *out = (HeadForce){0};
    const hawser_status status = force_solve(def, way, 0, head, &before[0], out, err);
    out->restart = out->force;
    return status || restarts_alike(def) ? status : force_solve(def, way, 1, head, &before[1], out, err);
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

/* Places where the force has corners: ends of pieces and stretches, machines. Just before a machine, which does not
 * push yet, and just behind a pit, where a new section begins, the force may be largest: these places count too, at
 * this share of the route's length. */
static const double JUST_AHEAD = 1e-9;

static int corners_collect(const PlanDef *def, int way, double *s)
{
    int n = 0;
    const double before = JUST_AHEAD * def->route->length * way_sign(way);
    s[n++] = plan_last(def, way); /* the pull ends with the route */
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

/* Keeps the places on the pull, fills the gaps, and sorts them in the pull's order. */
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

/* Keeps the larger one; the first of equals. */
static void peak_take(const HeadForce *f, int restart, HeadForce *peak)
{
    if (force_of(f, restart) > force_of(peak, restart)) *peak = *f;
}

/* State of the refinement of a peak. */
typedef struct Refine {
    const PlanDef *def;
    int way, restart;
    Pull *before; /* of that kind, as in force_solve */
    HeadForce peak;
    hawser_status status;
    hawser_error *err;
} Refine;

static double peak_look(void *what, double head)
{
    Refine *const r = what;
    HeadForce here = {0};
    if (r->status) return 0;
    r->status = force_solve(r->def, r->way, r->restart, head, r->before, &here, r->err);
    if (!r->status) peak_take(&here, r->restart, &r->peak);
    return force_of(&here, r->restart);
}

/* Refines a maximum between the two neighbours of the largest row. */
static hawser_status peak_refine(const PlanDef *def, int way, int restart, double a, double b, Pull before[2],
                                 HeadForce *peak, hawser_error *err)
{
    Refine r = {def, way, restart, &before[restart], *peak, HAWSER_OK, err};
    search_top(peak_look, &r, a, b, 24);
    if (r.status || r.peak.head == peak->head) return r.status;
    return head_solve(def, way, r.peak.head, before, peak, err);
}

/* Finds both peaks: of the rows, then refined beside local maxima. */
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

/* Checks whether friction behind the head depends on the place of the head. */
static int wears_by_head(const PlanDef *def) { return def->n_wear > 0 && def->wear_by == WEAR_PLACE; }

/* Tension of the cable with its head at s; `span` advances to the one that contains s. */
static double cable_tension(const Pull *pull, int *span, double s)
{
    while (*span < pull->n && pull->span[*span].law.direction * (s - pull->span[*span].s1) >= 0) ++*span;
    if (*span == pull->n) return pull->end_tension;
    const PullSpan *const at = &pull->span[*span];
    return s == at->s0 ? at->t0 : span_integrate(&at->law, at->s0, at->t0, s, NULL);
}

/* Tension of the rope at `to`, N, continued from `from` without a corner between. */
static double rope_onward(const PlanDef *def, int way, int restart, double from, double to, double tension)
{
    const double middle = from + (to - from) / 2;
    const PullStretch *const s = stretch_at(def->n_stretches, def->stretch, middle);
    const SpanLaw law = {.law = def->law,
                         .direction = way_sign(way),
                         .weight = def->rope_weight,
                         .mu = restart ? fmax(s->mu_rope, s->mu_rope_static) : s->mu_rope,
                         .separate = s->separate,
                         .line = span_line(def->route, middle)};
    return span_integrate(&law, from, tension, to, NULL);
}

/* Places of a pull's head, and the results there. */
typedef struct HeadCourse {
    const Places *places;
    const Pull *like; /* a pull of the whole route, whose spans are reused; NULL: none */
    int i;            /* the present section begins with that place */
    double *tension;  /* [places->n] N, of the tightest rope there; NULL: not needed */
} HeadCourse;

/* Finds the place of the head with the largest winch force in the section that begins with place i, and that force. Of
 * two ropes the tighter one at a place stays tighter to the section's end, so only the tightest is followed. Advances i
 * to the next section. */
static hawser_status section_top(const PlanDef *def, int way, int restart, HeadCourse *course, int *top, double *most,
                                 hawser_error *err)
{
    const Places *const places = course->places;
    const int first = course->i;
    const PlanSection section = plan_section_at(def, way, places->s[first]);
    const PlanPullDef what = {
        .way = way, .restart = restart, .head = section.to, .forces_only = 1, .like = course->like};
    Pull cable;
    hawser_status status = plan_pull(def, &what, &cable, err);
    if (status) return status;
    double tightest = -INFINITY;
    int span = 0, i = first;
    for (; i < places->n && way_sign(way) * (places->s[i] - section.to) <= 0; ++i) {
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

/* Finds one of both peaks: the place among all sections, then refined beside it. */
static hawser_status peak_find(const PlanDef *def, int way, int restart, const Places *places, const Pull *like,
                               Pull before[2], HeadForce *peak, hawser_error *err)
{
    int top = 0;
    double most = -INFINITY;
    assert(places->n > 0); /* the ends of the route */
    HeadCourse course = {.places = places, .like = like};
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

static hawser_status peaks_by_sections(const PlanDef *def, int way, const Places *places, const Pull *const like[2],
                                       HeadSeries *s, hawser_error *err)
{
    Pull before[2] = {{0}, {0}};
    hawser_status status = peak_find(def, way, 0, places, like ? like[0] : NULL, before, &s->peak, err);
    s->restart_peak = s->peak;
    if (!status && !restarts_alike(def))
        status = peak_find(def, way, 1, places, like ? like[1] : NULL, before, &s->restart_peak, err);
    pull_clear(&before[0]);
    pull_clear(&before[1]);
    return status;
}

hawser_status plan_peaks(const PlanDef *def, int way, const Pull *const like[2], HeadSeries *out, hawser_error *err)
{
    Places places;
    if (wears_by_head(def)) return plan_heads(def, way, INFINITY, out, err);
    *out = (HeadSeries){0};
    hawser_status status = places_find(def, way, INFINITY, &places, err);
    if (!status) status = peaks_by_sections(def, way, &places, like, out, err);
    free(places.s);
    return status;
}

/* -------------------------------------------------------------------------------------------------- the rope */

/* Removes places before `from`, where the head begins. */
static void places_begin(Places *places, int way, double from)
{
    int before = 0;
    while (before < places->n && way_sign(way) * (places->s[before] - from) < 0) ++before;
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
    HeadCourse course = {.places = &places, .tension = calloc((size_t)places.n + 1, sizeof *course.tension)};
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
    const int sign = way_sign(rope->way);
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
    int low = 0, high = rope->n - 1; /* s lies in between */
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

/* Limits the number of rows, since each costs time proportional to the corners: above a thousand corners the product of
 * both stays below a million. */
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
        status = plan_peaks(def, way, NULL, &peaks, err);
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

/* Computes the relief by rope along a whole section, held by its weight and the friction of that; bends would add
 * friction. */
hawser_status plan_relief(const PlanDef *def, int way, double *relief, hawser_error *err)
{
    PlanDef rope = *def;
    rope.law = PULL_NO_CAPSTAN;
    rope.n_pushes = 0;
    rope.enough = 0;
    *relief = 0;
    for (int i = 0; i < plan_sections(def, way) && def->rope_weight > 0; i++) {
        const double ahead = way_sign(way) * JUST_AHEAD * def->route->length;
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

/* A trial of a brake. */
typedef struct BrakeTrial {
    PlanDef def;
    int way;
    double before, enough; /* N, back tension without it; compression within rounding */
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

/* Computes the winch force with the brake, over all places of the head. */
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
    status = plan_peaks(def, way, (const Pull *const[2]){&pull, NULL}, &heads, err);
    pull_clear(&pull);
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
        /* the compression is an upper bound, except for a pit behind which the cable runs away by itself */
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

/* Checks the definition. Places may lie beyond the route; the reader of the case has checked the rest. */
static hawser_status check_def(const PlanDef *def, hawser_error *err)
{
    assert(def->route && def->n_stretches >= 1 && def->reel_length >= 0 && def->rope_length >= 0);
    assert(def->back_tension >= 0 && def->rope_weight >= 0 && def->feed >= 0);
    assert(def->route->length + def->beyond > 0);
    for (int i = 0; i < def->n_pushes; i++) {
        const PullStep *c = &def->push[i];
        if (!isfinite(c->force) || (def->push_back && !isfinite(def->push_back[i].force)))
            return error_set(err, HAWSER_ERR_INPUT, "push %d is not a number", i);
        if (!(c->at >= 0 && c->at <= def->route->length))
            return error_set(err, HAWSER_ERR_INPUT, "push %d at %g m is off the route of %g m", i, c->at,
                             def->route->length);
    }
    return HAWSER_OK;
}

/* Computes one span's result by the closed form, if the piece is a single span. */
static void piece_closed(const Route *route, const PullSpan *span, PlanPiece *piece)
{
    const RoutePiece *p = &route->piece[span->piece];
    hawser_error why = {.message = ""};
    if (fabs(fabs(span->s1 - span->s0) - p->length) > 1e-9 * p->length) {
        snprintf(piece->reason, sizeof piece->reason, "friction, weight or a push changes on the piece");
        return;
    }
    if (span_straight(&span->law, span->s0, span->t0) < span_normal(&span->law, span->s0, span->t0) ||
        span_straight(&span->law, span->s1, span->t1) < span_normal(&span->law, span->s1, span->t1)) {
        snprintf(piece->reason, sizeof piece->reason, "the cable is pushed, and snakes or coils on the piece");
        return;
    }
    double T2 = 0;
    if (piece_tension(p, span->law.direction, span->t0, span->law.weight, span->law.mu, span->law.separate, &T2,
                      &why)) {
        snprintf(piece->reason, sizeof piece->reason, "%.*s", PLAN_REASON_MAX - 1, why.message);
    } else {
        piece->closed = T2;
    }
}

/* Accumulated turn of the route up to s, rad; turned[k]: up to piece k. */
static double turned_at(const Route *route, const double *turned, double s)
{
    const int begun = items_before(route->n, &route->piece->s0, sizeof *route->piece, s, 1),
              k = begun > 0 ? begun - 1 : 0;
    const RoutePiece *const p = &route->piece[k];
    return turned[k] + p->angle * fmin(fmax((s - p->s0) / p->length, 0), 1);
}

/* Computes the maxima of the piece that begins with span i; spans of one piece are adjacent. A support bears at most
 * what turns the cable between its neighbours, and the weight between them (T18). */
static void piece_loads(const PlanDef *def, const double *turned, PlanWay *way, int i)
{
    const int p = way->pull.span[i].piece;
    const RoutePiece *const on = &def->route->piece[p];
    PlanPiece *const piece = &way->piece[p];
    const PieceExtremes most = pull_extremes_from(&way->pull, i);
    const double spacing = def->spacing ? def->spacing[p] : def->roller_spacing;
    const double beside = def->guides ? def->guides[p] : spacing;
    piece->max_tension = most.tension;
    piece->sidewall = most.sidewall;
    piece->guided = most.aside > 0 ? most.aside * fmin(beside, piece->turn) : 0;
    if (!(spacing > 0)) return; /* no separate supports */
    const double turn =
        turned_at(def->route, turned, on->s0 + on->length + spacing) - turned_at(def->route, turned, on->s0 - spacing);
    const double all = most.either * turn + way->pull.span[i].law.weight * spacing;
    piece->carried = fmin(most.down * spacing, all);
}

/* Sets the length of the bend that each piece belongs to. */
static void fill_turns(const Route *route, PlanPiece *piece)
{
    for (int p = 0, last; p < route->n; p = last + 1) {
        last = route_turn_end(route, p);
        const double length = route->piece[last].s0 + route->piece[last].length - route->piece[p].s0;
        const double turn = route->piece[p].kind == ROUTE_STRAIGHT ? INFINITY : length;
        for (int k = p; k <= last; k++) piece[k].turn = turn;
    }
}

/* Sets the rollers' loads in a bend to the largest of its parts. */
static void share_loads(const Route *route, PlanPiece *piece)
{
    for (int p = 0, last; p < route->n; p = last + 1) {
        double carried = 0, guided = 0;
        last = route_turn_end(route, p);
        for (int k = p; k <= last; k++) {
            carried = fmax(carried, piece[k].carried);
            guided = fmax(guided, piece[k].guided);
        }
        for (int k = p; k <= last; k++) {
            piece[k].carried = carried;
            piece[k].guided = guided;
            piece[k].roller_load = fmax(carried, guided);
        }
    }
}

static hawser_status fill_pieces(const PlanDef *def, PlanWay *way, hawser_error *err)
{
    double *const turned = calloc((size_t)def->route->n + 1, sizeof *turned);
    if (!turned) return error_memory(err);
    for (int p = 0; p < def->route->n; p++) turned[p + 1] = turned[p] + def->route->piece[p].angle;
    for (int i = 0; i < def->route->n; i++) way->piece[i] = (PlanPiece){.t_in = NAN, .t_out = NAN, .closed = NAN};
    fill_turns(def->route, way->piece);
    for (int i = 0; i < way->pull.n; i++) {
        const PullSpan *span = &way->pull.span[i];
        if (i == 0 || span->piece != span[-1].piece) piece_loads(def, turned, way, i);
        PlanPiece *piece = &way->piece[span->piece];
        assert(span->piece < def->route->n);
        if (isnan(piece->t_in)) {
            piece->t_in = span->t0;
            piece_closed(def->route, span, piece);
        }
        piece->t_out = span->t1;
    }
    share_loads(def->route, way->piece);
    free(turned);
    return HAWSER_OK;
}

/* Takes the least tensions of another pull, whose spans are parts of this one's, where they are smaller. */
static void spans_take(const Pull *low, Pull *pull)
{
    for (int k = 0, i = 0; k < low->n; k++) {
        const PullSpan *const part = &low->span[k];
        const double middle = part->s0 + (part->s1 - part->s0) / 2, sign = part->law.direction;
        while (i < pull->n - 1 && sign * (middle - pull->span[i].s1) > 0) i++;
        if (part->least >= pull->span[i].least) continue;
        pull->span[i].least = part->least;
        pull->span[i].least_at = part->least_at;
    }
}

/* Replaces the least tension by that with the least back tension. */
static hawser_status least_take(const PlanDef *def, const PlanPullDef *what, Pull *pull, hawser_error *err)
{
    const PlanDef slack = plan_slack(def);
    Pull low;
    if (!plan_slackens(def)) return HAWSER_OK;
    const hawser_status status = plan_pull(&slack, what, &low, err);
    if (status) return status;
    if (low.min_tension < pull->min_tension) {
        pull->min_tension = low.min_tension;
        pull->min_at = low.min_at;
        pull->min_piece = low.min_piece;
    }
    spans_take(&low, pull);
    pull_clear(&low);
    return HAWSER_OK;
}

/* Solves one direction: reel, pull, rope; then from rest. */
static hawser_status solve_way(const PlanDef *def, int k, PlanWay *way, hawser_error *err)
{
    PlanPullDef what = {.way = k, .whole = 1, .restart = 1};
    way->start = plan_section(def, k, 0).start;
    way->rope = plan_allowance(def, k);
    hawser_status status = plan_pull(def, &what, &way->rest, err);
    if (status) return status;
    way->restart_force = way->rest.end_tension + way->rope;
    what.restart = 0;
    status = plan_pull(def, &what, &way->pull, err);
    if (!status) status = least_take(def, &what, &way->pull, err);
    if (status) return status;
    way->force = way->pull.end_tension + way->rope;
    way->piece = calloc((size_t)def->route->n, sizeof *way->piece);
    if (!way->piece) return error_memory(err);
    return fill_pieces(def, way, err);
}

hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err)
{
    *out = (Plan){0};
    hawser_status status = check_def(def, err);
    for (int k = 0; k < PLAN_WAYS && !status; k++) {
        if (!def->skip[k]) status = solve_way(def, k, &out->way[k], err);
    }
    if (status) {
        plan_clear(out);
        return status;
    }
    out->n = def->route->n;
    out->better = exceeds(out->way[PLAN_FORWARD].force, out->way[PLAN_BACKWARD].force) ? PLAN_BACKWARD : PLAN_FORWARD;
    return HAWSER_OK;
}

void plan_clear(Plan *plan)
{
    for (int k = 0; k < PLAN_WAYS; k++) {
        pull_clear(&plan->way[k].pull);
        pull_clear(&plan->way[k].rest);
        free(plan->way[k].piece);
    }
    *plan = (Plan){0};
}

/* ----------------------------------------------------------------------------------------------------- along a span */

/* Integrated values: the tension, and its derivative by each cause (SN4). */
enum { OF_TENSION, BY_TENSION, BY_FRICTION, BY_WEIGHT, VALUES };

/* Allowed error of a step as a share of each value; share of a support's force below which it counts as unloaded. */
static const double STEP_TOLERANCE = 1e-12, ZERO_FORCE = 1e-11;

static double sign_number(double x) { return (x > 0) - (x < 0); }

/* Slopes for a cable in compression that snakes or forms a helix, (SN2a). */
static SpanSlopes coiled_slopes(const SpanLaw *p, double straight, SpanSlopes by, double tension)
{
    const double helix = p->room * tension * tension / (4 * p->ei), grows = p->room * tension / (2 * p->ei);
    double slope;
    if (!(helix > straight)) return by;
    const double times = straight > 0 ? span_coils(helix / straight, &slope) : INFINITY;
    if (!(times < INFINITY)) return (SpanSlopes){grows, 0};
    const double rest = times - helix / straight * slope;
    return (SpanSlopes){rest * by.by_tension + slope * grows, rest * by.by_weight};
}

/* (SN2). For an unloaded support, those of the first load to come: the weight, or a beginning tension. */
static SpanSlopes resultant_slopes(const SpanLaw *p, SpanFrame f, double tension)
{
    const double kappa = p->law == PULL_REFERENCE ? f.curvature : 0, pull = tension * kappa;
    const double g = pull - p->weight * f.nz, side = p->weight * f.bz, n = hypot(g, side), c = hypot(f.nz, f.bz);
    if (pull == 0) return (SpanSlopes){n > 0 ? kappa * g / n : kappa, c};
    if (!(n > ZERO_FORCE * (fabs(pull) + p->weight))) return (SpanSlopes){0, 0};
    return (SpanSlopes){kappa * g / n, (f.bz * side - f.nz * g) / n};
}

/* (SN3). */
static SpanSlopes separate_slopes(const SpanLaw *p, SpanFrame f, double tension)
{
    const double kappa = p->law == PULL_REFERENCE ? f.curvature : 0, c = hypot(f.nz, f.bz);
    if (!(c > 0)) return (SpanSlopes){kappa * (tension < 0 ? -1 : 1), 0};
    const double down = p->weight * c - tension * kappa * f.nz / c, aside = tension * kappa * f.bz / c;
    const double lies = down == 0 ? 1 : sign_number(down), holds = aside == 0 ? sign_number(f.bz) : sign_number(aside);
    return (SpanSlopes){kappa * (holds * f.bz - lies * f.nz) / c, lies * c};
}

SpanSlopes span_slopes(const SpanLaw *p, double s, double tension)
{
    const SpanFrame f = span_frame(&p->line, s);
    const SpanSlopes by = (p->separate ? separate_slopes : resultant_slopes)(p, f, tension);
    const int may_coil = tension < 0 && p->room > 0 && p->law == PULL_REFERENCE && !p->separate;
    return may_coil ? coiled_slopes(p, span_straight(p, s, tension), by, tension) : by;
}

/* (T5), (SN4); with unlike weights by the one that counts, which is an extremum there, so that its own change has no
 * effect. */
static void rates(const SpanLaw *unlike, double s, const double x[VALUES], double rate[VALUES])
{
    const SpanLaw one = span_weighed(unlike, s, x[OF_TENSION]), *const p = &one;
    const SpanSlopes by = span_slopes(p, s, x[OF_TENSION]);
    const double a = p->mu * by.by_tension, sine = p->direction * span_frame(&p->line, s).tz;
    rate[OF_TENSION] = span_rate(p, s, x[OF_TENSION]);
    rate[BY_TENSION] = a * x[BY_TENSION];
    rate[BY_FRICTION] = a * x[BY_FRICTION] + span_normal(p, s, x[OF_TENSION]);
    rate[BY_WEIGHT] = a * x[BY_WEIGHT] + p->mu * by.by_weight + sine;
}

/* Takes one step h along the pull with Fehlberg's 4(5) pair, fifth order: returns the largest error as a share of the
 * allowed one. */
static double gain_step(const SpanLaw *p, double s, const double x[VALUES], double h, double end[VALUES])
{
    enum { STAGES = 6 };
    static const double C[STAGES] = {0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1, 1.0 / 2};
    static const double A[STAGES][STAGES - 1] = {
        {0},
        {1.0 / 4},
        {3.0 / 32, 9.0 / 32},
        {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
        {439.0 / 216, -8, 3680.0 / 513, -845.0 / 4104},
        {-8.0 / 27, 2, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40},
    };
    static const double B[STAGES] = {16.0 / 135, 0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55};
    static const double E[STAGES] = {1.0 / 360, 0, -128.0 / 4275, -2197.0 / 75240, 1.0 / 50, 2.0 / 55};
    double k[STAGES][VALUES], worst = 0;
    for (int i = 0; i < STAGES; i++) {
        double at[VALUES];
        for (int v = 0; v < VALUES; v++) {
            at[v] = x[v];
            for (int j = 0; j < i; j++) at[v] += h * A[i][j] * k[j][v];
        }
        rates(p, s + p->direction * C[i] * h, at, k[i]);
    }
    for (int v = 0; v < VALUES; v++) {
        double sum = 0, error = 0, size = 0;
        for (int i = 0; i < STAGES; i++) {
            sum += B[i] * k[i][v];
            error += E[i] * k[i][v];
            size = fmax(size, fabs(k[i][v]));
        }
        end[v] = x[v] + h * sum;
        const double allowed = STEP_TOLERANCE * (fabs(x[v]) + h * size);
        if (allowed > 0) worst = fmax(worst, h * fabs(error) / allowed);
    }
    return worst;
}

/* Code of the loaded side of each support, or of the weight that counts; it changes at a corner of the law. Within
 * rounding of a corner it is that of no side. */
static int sides(const SpanLaw *p, double s, double tension)
{
    if (p->lightest > 0) return span_weighed(p, s, tension).weight < p->weight ? 2 : 1;
    if (tension < 0 && p->room > 0 && p->law == PULL_REFERENCE) { /* straight, snaking, close to a helix, helix */
        const double square = p->room * tension * tension / (4 * p->ei * span_straight(p, s, tension));
        if (square > 1) return 10 + (square > 2) + (square > 3.3431457505076194);
    }
    const SpanFrame f = span_frame(&p->line, s);
    const double pull = p->law == PULL_REFERENCE ? tension * f.curvature : 0, c = hypot(f.nz, f.bz);
    const double bare = ZERO_FORCE * (fabs(pull) + p->weight);
    if (!p->separate && fabs(f.bz) > ZERO_FORCE) return 0;
    const double g = p->separate && c > 0 ? p->weight * c - pull * f.nz / c : pull - p->weight * f.nz;
    const int tight = tension == 0 || !p->separate ? 0 : (tension > 0 ? 3 : -3);
    return (fabs(g) > bare ? (int)sign_number(g) : 0) + tight;
}

/* Halves the step until both ends are on the same side of the corner: it then ends before the corner, within 1e-13 of
 * the span, and the next step begins behind it. */
SpanGain span_gain(const SpanLaw *p, double s0, double tension, double s1)
{
    const double length = p->direction * (s1 - s0), least = 1e-13 * length;
    double x[VALUES] = {tension, 1, 0, 0}, end[VALUES], at = 0, h = length;
    while (at < length) {
        const double s = s0 + p->direction * at;
        if (h > length - at) h = length - at;
        const double worst = gain_step(p, s, x, h, end);
        const double grow = worst > 0 ? fmin(5, fmax(0.2, 0.9 * pow(worst, -0.2))) : 5;
        const int before = sides(p, s, x[OF_TENSION]), after = sides(p, s + p->direction * h, end[OF_TENSION]);
        const int corner = before != 0 && after != 0 && before != after;
        if ((worst > 1 || corner) && h > least) {
            h *= worst > 1 && !corner ? grow : 0.5;
            continue;
        }
        at = h >= length - at ? length : at + h;
        for (int v = 0; v < VALUES; v++) x[v] = end[v];
        h *= corner ? 1e6 : grow;
    }
    return (SpanGain){x[BY_TENSION], x[BY_FRICTION], x[BY_WEIGHT]};
}

/* ----------------------------------------------------------------------------------------------------- along a pull */

/* Deviation from a machine's corner, as a share of the force it takes, within which a tension counts as being at the
 * corner. */
static const double CORNER = 1e-9;

/* A machine with spare force starts to take when tension arrives, and stops taking more when the tension exceeds its
 * force. */
static int at_corner(double tension, double takes)
{
    return takes > 0 && fmin(fabs(tension), fabs(tension - takes)) <= CORNER * takes;
}

/* Derivative of a span's friction (PN4) and of its weight by cause k. */
static double friction_by(const PlanDef *def, int way, const PullSpan *span, int k)
{
    const double middle = (span->s0 + span->s1) / 2;
    const PullStretch *const on = stretch_at(def->n_stretches, def->stretch, middle);
    const int own =
        k >= CHANGE_OTHERS && k < CHANGE_OTHERS + def->n_stretches && on == &def->stretch[k - CHANGE_OTHERS];
    return k == CHANGE_FRICTION || own ? plan_friction_factor(def, way, plan_last(def, way), middle) : 0;
}

/* Applies the steps at s to the derivatives of the tension (SN5), in the pull's order: pushes, then machines, then
 * pits. before: the tension there. Returns the factor on the incoming tension. */
static double steps_change(const PlanDef *def, int way, double s, double before, double *d, PlanChange *c)
{
    const PullStep *const push = way == PLAN_BACKWARD && def->push_back ? def->push_back : def->push;
    double tension = before, factor = 1;
    for (int i = 0; i < def->n_pushes; i++) {
        if (push[i].at != s) continue;
        tension -= push[i].force;
        if (d) d[CHANGE_OTHERS + def->n_stretches + i] -= 1;
    }
    for (int i = 0; i < def->n_steps; i++) {
        const PullStep *const step = &def->step[i];
        const int anew = step->kind == STEP_ANEW && s != plan_last(def, way), all = tension <= step->force;
        if (step->at != s || step->kind == STEP_ADD || (step->kind == STEP_ANEW && !anew)) continue;
        if (step->kind == STEP_TAKE && factor > 0 && at_corner(tension, step->force)) c->one_sided = 1;
        if (anew || (all && tension > 0)) factor = 0;
        if (step->kind == STEP_TAKE) tension -= fmin(fmax(tension, 0), step->force);
    }
    for (int k = 0; d && factor == 0 && k < c->n; k++) d[k] = 0;
    return factor;
}

/* Goes from start to end: (SN4) span by span, (SN5) between. */
static void go_forward(const PlanDef *def, int way, PlanChange *c)
{
    const Pull *const pull = c->pull;
    const size_t n = (size_t)c->n;
    double *const d = c->force, tension = pull->start_tension;
    memset(d, 0, n * sizeof *d);
    d[CHANGE_START] = 1;
    d[CHANGE_WEIGHT] = def->reel_length; /* (T24) */
    c->weight[CHANGE_WEIGHT] = 1;
    for (int i = 0; i < pull->n; i++) {
        const PullSpan *const span = &pull->span[i];
        steps_change(def, way, span->s0, tension, d, c);
        const SpanGain gain = span_gain(&span->law, span->s0, span->t0, span->s1);
        c->reach[i] = gain.tension;
        for (int k = 0; k < c->n; k++) {
            const double mu = friction_by(def, way, span, k);
            c->start[(size_t)i * n + (size_t)k] = d[k];
            c->inside[(size_t)i * n + (size_t)k] = mu;
            d[k] = gain.tension * d[k] + gain.friction * mu + gain.weight * c->weight[k];
        }
        tension = span->t1;
    }
    steps_change(def, way, plan_last(def, way), tension, d, c);
    d[CHANGE_WEIGHT] += def->rope_length; /* (T25) */
}

/* Goes from end to start, multiplying the gains of the spans (SN8). */
static void go_back(const PlanDef *def, int way, PlanChange *c)
{
    const Pull *const pull = c->pull;
    double reach = steps_change(def, way, plan_last(def, way), pull->span[pull->n - 1].t1, NULL, c);
    for (int i = pull->n - 1; i >= 0; i--) {
        reach = c->reach[i] *= reach;
        const double before = i > 0 ? pull->span[i - 1].t1 : pull->start_tension;
        reach *= steps_change(def, way, pull->span[i].s0, before, NULL, c);
    }
}

hawser_status plan_change(const PlanDef *def, const Plan *plan, int way, PlanChange *out, hawser_error *err)
{
    const Pull *const pull = &plan->way[way].pull;
    *out = (PlanChange){.n = CHANGE_OTHERS + def->n_stretches + def->n_pushes, .pull = pull};
    const size_t n = (size_t)out->n, spans = (size_t)pull->n;
    out->start = calloc(spans * n, sizeof *out->start);
    out->inside = calloc(spans * n, sizeof *out->inside);
    out->weight = calloc(n, sizeof *out->weight);
    out->reach = calloc(spans, sizeof *out->reach);
    out->force = calloc(n, sizeof *out->force);
    if (!out->start || !out->inside || !out->weight || !out->reach || !out->force) return error_memory(err);
    go_forward(def, way, out);
    go_back(def, way, out);
    return HAWSER_OK;
}

void plan_change_free(PlanChange *c)
{
    free(c->start);
    free(c->inside);
    free(c->weight);
    free(c->reach);
    free(c->force);
    *c = (PlanChange){0};
}

void plan_change_at(const PlanChange *c, double s, double *tension, double *support, double *reach)
{
    const Pull *const pull = c->pull;
    int i = 0;
    while (i + 1 < pull->n && pull->span[i].law.direction * (pull->span[i].s1 - s) < 0) i++;
    const PullSpan *const span = &pull->span[i];
    const double *const start = &c->start[(size_t)i * (size_t)c->n], *const inside =
                                                                         &c->inside[(size_t)i * (size_t)c->n];
    const SpanGain gain = span_gain(&span->law, span->s0, span->t0, s);
    const double now = pull_at(pull, s).tension;
    const SpanLaw pressing = span_pressing(&span->law, s, now);
    const SpanSlopes by = span_slopes(&pressing, s, now);
    *reach = c->reach[i] / gain.tension;
    for (int k = 0; k < c->n; k++) {
        tension[k] = gain.tension * start[k] + gain.friction * inside[k] + gain.weight * c->weight[k];
        support[k] = by.by_tension * tension[k] + by.by_weight * c->weight[k];
    }
}
