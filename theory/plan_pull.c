#include "theory/plan_pull.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/search.h"

static int sign_of(int way) { return way == PLAN_BACKWARD ? -1 : 1; }

double plan_first(const PlanDef *def, int way) { return way == PLAN_BACKWARD ? def->route->length : 0; }

double plan_last(const PlanDef *def, int way)
{
    return way == PLAN_BACKWARD ? 0 - def->beyond : def->route->length + def->beyond;
}

double plan_allowance(const PlanDef *def, int way)
{
    /* of what lies where the pull starts: it is what the reel pays out */
    const double weight = stretch_at(def->n_stretches, def->stretch, plan_first(def, way))->weight;
    return weight * def->rope_length + def->rope_force + def->drawn[way];
}

/* --------------------------------------------------------------------------------------------- sections */

/* The pit that comes next behind s along the pull and before its end; -1: none. */
static int next_pit(const PlanDef *def, int way, double s)
{
    const int sign = sign_of(way);
    int next = -1;
    for (int i = 0; i < def->n_steps; i++) {
        const double at = def->step[i].at;
        if (def->step[i].kind != STEP_ANEW || sign * (at - s) <= 0 || sign * (plan_last(def, way) - at) <= 0) continue;
        if (next < 0 || sign * (at - def->step[next].at) < 0) next = i;
    }
    return next;
}

/* The weight that counts on a straight of unlike pieces, of which lies where nobody says: the heaviest where weight
 * holds (`metre`: its share that does, >= 0) and the lightest where it runs ahead; for the least tension the other one
 * (T28). */
static double weight_of(const PlanDef *def, const PullStretch *s, double metre)
{
    const int light = def->lightest > 0 && def->slack == (metre >= 0);
    return light ? fmin(def->lightest, s->weight) : s->weight;
}

/* What a metre holds back with, as a share of its weight, on a straight that rises by so much per metre. */
static double share_held(double rise, double mu) { return rise + mu * sqrt(fmax(0, 1 - rise * rise)); }

/* Of what still lies behind the start, pulled forward (T27): the most or the least of the whole pull, N. */
static double behind_tension(const PlanDef *def, int way, int restart)
{
    if (way == PLAN_BACKWARD) return 0;
    const PullStretch *const s = stretch_at(def->n_stretches, def->stretch, 0);
    const double rise = route_at(def->route, 0).tangent.z, mu = restart ? fmax(s->mu, s->mu_static) : s->mu;
    const double share = share_held(rise, def->behind_slides ? mu : 0), metre = share * weight_of(def, s, share);
    const double first = metre * def->behind, last = metre * def->behind_least;
    return def->slack ? fmin(first, last) : fmax(first, last);
}

/* The pit that stands where the pull begins; -1: none. */
static int first_pit(const PlanDef *def, int way)
{
    int i = def->n_steps - 1;
    while (i >= 0 && !(def->step[i].kind == STEP_ANEW && def->step[i].at == plan_first(def, way))) i--;
    return i;
}

/* (T24) less the push: of what lies where the pull begins, which is what the reel pays out; that of a pit that is there
 * (PN3). */
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
    while (s.ends >= 0 && sign_of(way) * (head - s.to) > 0) s = section_after(def, way, &s);
    return s;
}

/* ------------------------------------------------------------------------------ what lies on the route */

/* The stretches of one pull, by rising place. */
typedef struct Course {
    int n;
    PullStretch *stretch; /* [n] */
} Course;

/* The factor of friction at a length, that of the last row that begins before it; 1 ahead of the first. */
static double wear_at(const PlanDef *def, double length)
{
    double factor = 1;
    for (int k = 0; k < def->n_wear && def->wear[k].from <= length; k++) factor = def->wear[k].factor;
    return factor;
}

/* The length that wear goes by at s, and its inverse, with the head at `head`: (PN4). */
static double wear_length(const PlanDef *def, int way, double head, double s)
{
    return sign_of(way) * (def->wear_by == WEAR_CABLE ? s - plan_first(def, way) : head - s);
}

static double wear_place(const PlanDef *def, int way, double head, double length)
{
    return def->wear_by == WEAR_CABLE ? plan_first(def, way) + sign_of(way) * length : head - sign_of(way) * length;
}

double plan_friction_factor(const PlanDef *def, int way, double head, double s)
{
    return wear_at(def, wear_length(def, way, head, s));
}

/* Cable up to the head and rope beyond it, friction by wear, the duct's correction on the cable. */
static PullStretch stretch_make(const PlanDef *def, int way, double head, double begin, double middle)
{
    PullStretch s = *stretch_at(def->n_stretches, def->stretch, middle);
    s.from = begin;
    if (sign_of(way) * (middle - head) > 0) {
        s.weight = def->rope_weight;
        s.mu = s.mu_rope;
        s.mu_static = s.mu_rope_static;
        s.share = 1;
        s.room = 0; /* nobody pushes a rope */
        return s;
    }
    const double factor = plan_friction_factor(def, way, head, middle);
    s.mu *= factor;
    s.mu_static *= factor;
    s.lightest = fmin(def->lightest, s.weight);
    return s;
}

/* Every place at which something changes, then what lies between. */
static hawser_status course_make(const PlanDef *def, int way, double head, Course *out, hawser_error *err)
{
    out->stretch = malloc((size_t)(def->n_stretches + def->n_wear + 1) * sizeof *out->stretch);
    if (!out->stretch) return error_memory(err);
    PullStretch *const s = out->stretch;
    int n = 0;
    for (int i = 0; i < def->n_stretches; i++) s[n++].from = def->stretch[i].from;
    for (int k = 0; k < def->n_wear; k++) s[n++].from = wear_place(def, way, head, def->wear[k].from);
    s[n++].from = head;
    qsort(s, (size_t)n, sizeof *s, compare_first);
    out->n = 0;
    for (int i = 0; i < n; i++) {
        const double begin = s[i].from, end = i + 1 < n ? s[i + 1].from : begin + 2;
        if (end > begin) s[out->n++] = stretch_make(def, way, head, begin, begin + (end - begin) / 2);
    }
    return HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------- the pull */

/* Pushes and machines that the cable has reached, in `step` [n_pushes + n_steps]: the rope runs through them. A pit at
 * which a section begins or ends is its start or its end. Returns how many. */
static int steps_collect(const PlanDef *def, const PlanPullDef *what, double head, PullStep *step)
{
    const int sign = sign_of(what->way);
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

/* By how much a section's tension at its start is more from rest, N. */
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
