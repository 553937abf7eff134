/* Each function puts one group of keys. They return 0, or something else when memory ran out, and are or'ed together:
 * one look at the end is enough. */
#include "io/results/summary_json.h"

#include "core/base/error.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>

/* Setters that put one key into an object; JSON has no NAN, which becomes null. A key that did not fit in
 * memory shows as a non-zero sum of the returns. */
static int put_real(json_t *o, const char *key, double v)
{
    return json_object_set_new(o, key, isfinite(v) ? json_real(v) : json_null());
}

/* Counts. */
static int put_int(json_t *o, const char *key, long v) { return json_object_set_new(o, key, json_integer(v)); }

/* Text that is not UTF-8 (a name from a strange file) becomes null. */
static int put_text(json_t *o, const char *key, const char *v)
{
    json_t *text = v ? json_string(v) : NULL;
    return json_object_set_new(o, key, text ? text : json_null());
}

/* A nested object of numbers: pairs of key and value. */
typedef struct RealPair {
    const char *key;
    double value;
} RealPair;

/* Quantities that belong together share an object. */
static int put_reals(json_t *o, const char *key, int n, const RealPair *pair)
{
    json_t *inner = json_object();
    int bad = 0;
    for (int i = 0; i < n; i++) bad |= put_real(inner, pair[i].key, pair[i].value);
    return json_object_set_new(o, key, inner) | bad;
}

/* What was run, by what, and how it ended. */
static int put_labels(json_t *o, const SummaryLabels *l)
{
    return put_text(o, "title", l->title) | put_text(o, "case", l->case_name) |
           put_text(o, "version", hawser_version()) | put_text(o, "outcome", l->outcome) |
           put_text(o, "message", l->message);
}

/* Counts of the model. */
static int put_scene(json_t *o, const hawser_summary *s)
{
    return put_int(o, "segments", s->segments) | put_int(o, "bushings", s->bushings) |
           put_int(o, "rollers", s->rollers) | put_int(o, "contact_candidates", s->contact_candidates) |
           put_int(o, "contact_active_max", s->contact_active_max);
}

/* One object a duct, tray, floor or wall. */
static int put_surfaces(json_t *o, const SummaryLabels *l)
{
    json_t *list = json_array();
    int bad = !list;
    for (int i = 0; i < l->n_surfaces && !bad; i++) {
        const hawser_surface *const s = &l->surface[i];
        json_t *row = json_object();
        bad = put_text(row, "name", s->name) | put_text(row, "kind", s->kind) | put_real(row, "from_m", s->from_m) |
              put_real(row, "to_m", s->to_m) | put_real(row, "clearance_m", s->clearance_m) |
              put_real(row, "jam_ratio", s->jam_ratio) | put_real(row, "steady_normal_N", s->normal_N) |
              put_real(row, "steady_friction_N", s->friction_N) |
              put_real(row, "peak_line_load_N_per_m", s->line_load_N_per_m) |
              put_real(row, "peak_at_m", s->line_load_at_m) | json_array_append_new(list, row);
    }
    return json_object_set_new(o, "surfaces", list) | bad;
}

/* Rollers that spin or stand on mounts; the key is absent where there are none. */
static int put_moving_rollers(json_t *o, const SummaryLabels *l)
{
    json_t *list = json_array();
    int bad = !list;
    for (int i = 0; i < l->n_rollers && !bad; i++) {
        const hawser_roller *const r = &l->roller[i];
        if (isnan(r->spin_rad_per_s) && isnan(r->shift_m)) continue;
        json_t *row = json_object();
        bad = put_text(row, "name", r->name) | put_real(row, "s_m", r->s) |
              put_real(row, "steady_spin_rad_per_s", r->spin_rad_per_s) | put_real(row, "steady_shift_m", r->shift_m) |
              put_real(row, "peak_shift_m", r->peak_shift_m) | json_array_append_new(list, row);
    }
    if (json_array_size(list) > 0) return json_object_set_new(o, "moving_rollers", list) | bad;
    json_decref(list);
    return bad;
}

/* What the integrator and the linear solver did. */
static int put_work(json_t *o, const hawser_summary *s)
{
    return put_real(o, "sim_time_s", s->sim_time_s) | put_real(o, "wall_time_s", s->wall_time_s) |
           put_real(o, "real_time_factor", s->real_time_factor) | put_int(o, "steps", s->steps) |
           put_real(o, "steps_per_second", s->steps_per_second) | put_int(o, "rhs_evals", s->rhs_evals) |
           put_int(o, "newton_iters", s->newton_iters) | put_int(o, "jac_evals", s->jac_evals) |
           put_int(o, "lin_setups", s->lin_setups) | put_int(o, "error_test_fails", s->error_test_fails) |
           put_int(o, "newton_fails", s->newton_fails) | put_int(o, "contact_refreshes", s->contact_refreshes) |
           put_text(o, "linear_solver", s->linear_solver) | put_text(o, "linear_solver_why", s->linear_solver_why) |
           put_text(o, "ordering", s->ordering) | put_int(o, "threads", s->threads) |
           json_object_set_new(o, "planar", json_boolean(s->planar)) | put_text(o, "planar_why", s->planar_why);
}

/* The results proper: pull, theory, errors, speed, and the window over which they were taken. */
static int put_figures(json_t *o, const hawser_summary *s)
{
    const RealPair pull[] = {
        {"steady_mean_N", s->pull_mean_N}, {"peak_N", s->pull_peak_N}, {"steady_ripple_rms_N", s->pull_ripple_N}};
    const RealPair theory[] = {{"paper_total_N", s->paper_total_N}, {"reference_total_N", s->reference_total_N}};
    const RealPair error[] = {{"max_pct", s->error_max_pct},
                              {"mean_pct", s->error_mean_pct},
                              {"max_pct_paper", s->error_max_paper_pct},
                              {"mean_pct_paper", s->error_mean_paper_pct}};
    const RealPair speed[] = {{"steady_m_per_s", s->steady_speed_m_per_s}, {"settle_time_s", s->settle_time_s}};
    const RealPair window[] = {{"from_s", s->steady_from_s}, {"to_s", s->steady_to_s}};
    return put_reals(o, "pull_force", 3, pull) | put_reals(o, "theory", 2, theory) |
           put_reals(o, "tension_error", 4, error) | put_reals(o, "speed", 2, speed) |
           put_reals(o, "steady_window", 2, window);
}

/* How the initial equilibrium went. */
static int put_relaxation(json_t *o, const hawser_relaxation *r)
{
    json_t *inner = json_object();
    const int bad = json_object_set_new(inner, "reached", json_boolean(r->reached)) |
                    put_int(inner, "iterations", r->iterations) | put_real(inner, "residual_N", r->residual_N) |
                    put_real(inner, "tolerance_N", r->tolerance_N) | put_int(inner, "segment", r->segment) |
                    put_real(inner, "moved_m", r->moved_m);
    return json_object_set_new(o, "relaxation", inner) | bad;
}

/* A vector as a list. */
static int put_vector(json_t *o, const char *key, const double v[3])
{
    json_t *list = json_array();
    int bad = !list;
    for (int c = 0; c < 3 && !bad; c++)
        bad = json_array_append_new(list, isfinite(v[c]) ? json_real(v[c]) : json_null());
    return json_object_set_new(o, key, list) | bad;
}

/* The terms of one kind, by name. */
static int put_terms(json_t *o, const char *key, const hawser_balance *b, hawser_balance_kind kind)
{
    json_t *inner = json_object();
    int bad = !inner;
    for (int i = 0; i < b->n_terms; i++) {
        const hawser_balance_term *const term = &b->term[i];
        if (term->kind != kind) continue;
        bad |= kind == HAWSER_BALANCE_IMPULSE ? put_vector(inner, term->name, term->N_s)
                                              : put_real(inner, term->name, term->J);
    }
    return json_object_set_new(o, key, inner) | bad;
}

/* Energy and momentum since t = 0; absent where nothing moves. */
static int put_balance(json_t *o, const hawser_balance *b)
{
    if (!b) return 0;
    json_t *inner = json_object();
    const int bad =
        put_terms(inner, "work_J", b, HAWSER_BALANCE_WORK) | put_terms(inner, "lost_J", b, HAWSER_BALANCE_LOSS) |
        put_terms(inner, "stored_J", b, HAWSER_BALANCE_STORED) | put_real(inner, "carried_J", b->carried_J) |
        put_real(inner, "residual_J", b->residual_J) | put_real(inner, "turnover_J", b->turnover_J) |
        put_text(inner, "turnover_of", b->turnover_of) | put_real(inner, "residual_share", b->residual_share) |
        put_terms(inner, "impulse_N_s", b, HAWSER_BALANCE_IMPULSE) |
        put_vector(inner, "momentum_N_s", b->momentum_N_s) | put_vector(inner, "carried_N_s", b->carried_N_s) |
        put_vector(inner, "residual_N_s", b->residual_N_s) |
        put_real(inner, "impulse_residual_share", b->impulse_residual_share);
    return json_object_set_new(o, "balance", inner) | bad;
}

/* One row a conveyor. */
static int put_conveyors(json_t *o, const hawser_summary *s)
{
    json_t *list = json_array();
    int bad = 0;
    for (int i = 0; i < s->n_conveyors; i++) {
        const hawser_conveyor *c = &s->conveyors[i];
        const RealPair pair[] = {{"from_m", c->from},
                                 {"to_m", c->to},
                                 {"grip_N", c->grip_N},
                                 {"reference_N", c->reference_N},
                                 {"steady_mean_N", c->mean_N},
                                 {"peak_N", c->peak_N},
                                 {"belt_m_per_s", c->belt_m_per_s},
                                 {"slip_m_per_s", c->slip_m_per_s},
                                 {"slipping", c->slipping}};
        json_t *row = json_object();
        bad |= put_text(row, "name", c->name);
        for (int k = 0; k < 9; k++) bad |= put_real(row, pair[k].key, pair[k].value);
        bad |= json_array_append_new(list, row);
    }
    return json_object_set_new(o, "conveyors", list) | bad;
}

/* The winch's force by the place of the cable's front. */
static int put_positions(json_t *o, const hawser_summary *s)
{
    json_t *list = json_array();
    int bad = 0;
    for (int i = 0; i < s->n_positions; i++) {
        const hawser_position *p = &s->positions[i];
        json_t *row = json_object();
        bad |= put_real(row, "head_m", p->head_m) | put_real(row, "pull_N", p->pull_N) |
               put_real(row, "reference_N", p->reference_N) | put_real(row, "error_pct", p->error_pct) |
               json_array_append_new(list, row);
    }
    return json_object_set_new(o, "pull_by_position", list) | bad;
}

/* Frequencies; the shapes are in modes.csv. */
static int put_modes(json_t *o, const hawser_summary *s)
{
    json_t *list = json_array();
    int bad = !list;
    for (int i = 0; i < s->n_modes; i++) {
        const hawser_mode *m = &s->modes[i];
        json_t *row = json_object();
        bad |= put_real(row, "frequency_Hz", m->frequency_Hz) | put_real(row, "growth_per_s", m->growth_per_s) |
               put_real(row, "omega_squared_per_s2", m->omega_squared) | json_array_append_new(list, row);
    }
    return json_object_set_new(o, "modes", list) | bad;
}

/* One row a probe, as the run ended. */
static int put_probes(json_t *o, const hawser_summary *s)
{
    json_t *list = json_array();
    int bad = put_text(o, "analysis", s->analysis);
    for (int i = 0; i < s->n_probes; i++) {
        const hawser_probe *p = &s->probes[i];
        json_t *row = json_object();
        bad |= put_text(row, "name", p->name) | put_real(row, "at_m", p->at) |
               put_vector(row, "position_m", p->position) | put_vector(row, "displacement_m", p->displacement) |
               put_vector(row, "rotation_rad", p->rotation) | put_vector(row, "force_N", p->force) |
               put_vector(row, "moment_N_m", p->moment) | json_array_append_new(list, row);
    }
    return json_object_set_new(o, "probes", list) | bad;
}

/* What happened, by time. */
static int put_events(json_t *o, const hawser_summary *s)
{
    json_t *list = json_array();
    int bad = 0;
    for (int i = 0; i < s->n_events; i++) {
        const hawser_event *e = &s->events[i];
        json_t *row = json_object();
        bad |= put_real(row, "time_s", e->t) | put_text(row, "what", e->what) | put_real(row, "pull_N", e->pull_N) |
               json_array_append_new(list, row);
    }
    return json_object_set_new(o, "events", list) | bad;
}

/* One object a limit, and the verdict on all of them. */
static int put_limits(json_t *o, const SummaryLabels *l)
{
    char verdict[HAWSER_VERDICT_MAX];
    json_t *list = json_array();
    int bad = !list;
    for (int i = 0; i < l->n_limits && !bad; i++) {
        const hawser_limit *k = &l->limit[i];
        json_t *row = json_object();
        bad = put_text(row, "name", k->name) | put_real(row, "value", k->value) | put_real(row, "limit", k->limit) |
              put_text(row, "unit", k->unit) | put_real(row, "margin", k->margin) |
              json_object_set_new(row, "ok", k->judged ? json_boolean(k->ok) : json_null()) |
              put_text(row, "where", k->where) | put_text(row, "source", k->source) | json_array_append_new(list, row);
    }
    hawser_limits_verdict(l->n_limits, l->limit, verdict, sizeof verdict);
    return json_object_set_new(o, "limits", list) | put_text(o, "verdict", verdict) | bad;
}

/* Eq. 12 roller by roller. */
static int put_overload(json_t *o, const SummaryLabels *l)
{
    json_t *inner = json_object(), *list = json_array();
    int bad = !inner || !list;
    for (int i = 0; i < l->n_overloads && !bad; i++) {
        const Overload *v = &l->overload[i];
        json_t *row = json_object();
        bad = put_text(row, "roller", v->name) | put_real(row, "s_m", v->s) | put_real(row, "peak_N", v->peak) |
              put_real(row, "reference_N", v->reference) | put_real(row, "alpha", v->alpha) |
              json_array_append_new(list, row);
    }
    bad |= put_real(inner, "trip_N", l->trip_N) | json_object_set_new(inner, "rollers", list);
    return json_object_set_new(o, "overload", inner) | bad;
}

/* Where the wall time went. */
static int put_phases(json_t *o, const hawser_phases *p)
{
    const RealPair pair[] = {{"relax", p->relax},       {"rhs", p->rhs},       {"contacts", p->contacts},
                             {"jacobian", p->jacobian}, {"factor", p->factor}, {"solve", p->solve},
                             {"vector", p->vector},     {"output", p->output}, {"other", p->other}};
    return put_reals(o, "phases_s", 9, pair);
}

/* Keys keep the order in which they are put. Ten digits: enough to compare runs, short enough to read. */
hawser_status summary_json(const hawser_summary *s, const SummaryLabels *labels, char **text, hawser_error *err)
{
    json_t *o = json_object();
    int bad = !o;
    if (o) {
        bad = put_labels(o, labels) | put_scene(o, s) | put_work(o, s) | put_figures(o, s) | put_conveyors(o, s) |
              put_balance(o, s->balance) | put_probes(o, s) | put_modes(o, s) | put_events(o, s) | put_positions(o, s) |
              put_surfaces(o, labels) | put_moving_rollers(o, labels) | put_limits(o, labels) |
              put_overload(o, labels) | put_relaxation(o, &s->relaxation) | put_phases(o, &s->phases);
    }
    char *body = bad ? NULL : json_dumps(o, JSON_INDENT(2) | JSON_REAL_PRECISION(10));
    json_decref(o);
    *text = body;
    return body ? HAWSER_OK : error_memory(err);
}
