/* A simulation behind the public handle: what the interface says is checked here, everything else is passed on. */
#include "core/base/error.h"
#include "io/api/api_handles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the handle must remember of the case, which may be gone soon, and the simulation itself. */
static hawser_status fill_handle(hawser_sim *s, const hawser_case *c, int threads, hawser_error *err)
{
    s->case_name = strdup(c->name);
    s->title = strdup(c->def.title[0] ? c->def.title : c->name);
    s->wants_relaxation = c->def.solver.relax;
    if (!s->case_name || !s->title) return error_memory(err);
    const hawser_status status = sim_new(&c->def, threads, &s->sim, err);
    if (status) return case_name_error(c, status, err);
    const SimRoller *table;
    s->roller = calloc((size_t)sim_rollers(s->sim, &table) + 1, sizeof *s->roller);
    const SimSurface *surface;
    s->surface = calloc((size_t)sim_surfaces(s->sim, &surface) + 1, sizeof *s->surface);
    return s->roller && s->surface ? HAWSER_OK : error_memory(err);
}

/* Options come from a program or a command line, so they are checked like a case. */
hawser_status hawser_sim_new(hawser_case *c, const hawser_options *options, hawser_sim **out, hawser_error *err)
{
    *out = NULL;
    const int threads = options ? options->threads : 0;
    if (threads < 0 || threads > 2) {
        return error_set(err, HAWSER_ERR_INPUT, "%d threads: 1 or 2 can be used (0: the case's choice)", threads);
    }
    hawser_status status = case_ensure_read(c, err);
    if (status) return status;
    hawser_sim *s = calloc(1, sizeof *s);
    if (!s) return error_memory(err);
    status = fill_handle(s, c, threads, err);
    if (status) {
        hawser_sim_free(s);
        return status;
    }
    *out = s;
    return HAWSER_OK;
}

/* Also for a handle that was never finished. */
void hawser_sim_free(hawser_sim *s)
{
    if (!s) return;
    sim_free(s->sim);
    free(s->case_name);
    free(s->title);
    free(s->roller);
    free(s->surface);
    free(s);
}

/* Keeps the outcome of a call that computes, for the summary. */
static hawser_status keep_outcome(hawser_sim *s, hawser_status status, const hawser_error *err)
{
    s->outcome = status;
    if (status) memcpy(s->message, err->message, sizeof s->message);
    return status;
}

/* The statistics and the integrator start from here; later the state is theirs. */
hawser_status hawser_sim_relax(hawser_sim *s, hawser_relaxation *out, hawser_error *err)
{
    hawser_error local;
    hawser_error *e = err ? err : &local;
    if (sim_time(s->sim) > 0) {
        return error_set(e, HAWSER_ERR_INPUT, "only a simulation that has not moved on from t = 0 can be relaxed");
    }
    s->relaxed = 1;
    return keep_outcome(s, sim_relax(s->sim, out, e), e);
}

/* The corners of the drive are never stepped over, whatever t is. */
hawser_status hawser_sim_advance(hawser_sim *s, double t, int one_step, hawser_error *err)
{
    hawser_error local;
    hawser_error *e = err ? err : &local;
    return keep_outcome(s, sim_advance(s->sim, t, one_step, e), e);
}

/* The rest of the interface passes through: the simulation keeps its own books. */
double hawser_sim_time(const hawser_sim *s) { return sim_time(s->sim); }

double hawser_sim_end_time(const hawser_sim *s) { return sim_end_time(s->sim); }

const hawser_sample *hawser_sim_sample(hawser_sim *s) { return sim_sample(s->sim); }

void hawser_sim_record(hawser_sim *s) { sim_record(s->sim); }

void hawser_sim_summary(const hawser_sim *s, hawser_summary *out) { sim_summary(s->sim, out); }

int hawser_sim_stations(const hawser_sim *s, const hawser_station **out) { return sim_stations(s->sim, out); }

int hawser_sim_machines(const hawser_sim *s, const hawser_machine **out) { return sim_machines(s->sim, out); }

int hawser_sim_positions(const hawser_sim *s, const hawser_position **out) { return sim_positions(s->sim, out); }

int hawser_sim_modes(const hawser_sim *s, const hawser_mode **out) { return sim_modes(s->sim, out); }

int hawser_sim_events(const hawser_sim *s, const hawser_event **out) { return sim_events(s->sim, out); }

/* The public table names things a little differently from the one inside. */
static hawser_roller roller_row(const SimRoller *r)
{
    return (hawser_roller){r->name, r->s, r->rating, r->initial, r->steady, r->peak, r->spin, r->shift, r->peak_shift};
}

/* Brings the table up to date. */
static int roller_rows(const hawser_sim *s)
{
    const SimRoller *table;
    const int n = sim_rollers(s->sim, &table);
    for (int i = 0; i < n; i++) s->roller[i] = roller_row(&table[i]);
    return n;
}

int hawser_sim_rollers(hawser_sim *s, const hawser_roller **out)
{
    *out = s->roller;
    return roller_rows(s);
}

hawser_surface api_surface(const SimSurface *surface)
{
    static const char *const kinds[] = {"duct", "flat", "v", "u", "plane"};
    const SurfaceDef *const def = surface->def;
    const int along = surface_along_route(def);
    return (hawser_surface){.name = surface->name,
                            .kind = kinds[def->shape.kind],
                            .from_m = along ? def->shape.from : NAN,
                            .to_m = along ? def->shape.to : NAN,
                            .clearance_m = surface->clearance,
                            .jam_ratio = surface->jam_ratio,
                            .normal_N = surface->normal,
                            .friction_N = surface->friction,
                            .line_load_N_per_m = surface->line_load,
                            .line_load_at_m = surface->at};
}

/* The same of the surfaces. */
static int surface_rows(const hawser_sim *s)
{
    const SimSurface *table;
    const int n = sim_surfaces(s->sim, &table);
    for (int i = 0; i < n; i++) s->surface[i] = api_surface(&table[i]);
    return n;
}

int hawser_sim_surfaces(hawser_sim *s, const hawser_surface **out)
{
    *out = s->surface;
    return surface_rows(s);
}

const char *hawser_sim_title(const hawser_sim *s) { return s->title; }

/* One word for the summary. */
static const char *outcome_name(const hawser_sim *s)
{
    if (s->running) return "running";
    if (s->outcome == HAWSER_STOPPED) return "stopped";
    if (s->outcome) return "failed";
    if (sim_time(s->sim) < sim_end_time(s->sim)) return "unfinished";
    return sim_tripped(s->sim) ? "tripped" : "finished";
}

int hawser_sim_limits(struct hawser_sim *s, hawser_limit *out) { return sim_limits(s->sim, out); }

/* The same text that summary.json has. */
hawser_status hawser_sim_summary_json(const hawser_sim *s, char **text, hawser_error *err)
{
    hawser_summary summary;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    Overload *overload;
    SummaryLabels labels = {.title = s->title,
                            .case_name = s->case_name,
                            .outcome = outcome_name(s),
                            .message = s->outcome ? s->message : "",
                            .n_surfaces = surface_rows(s),
                            .surface = s->surface,
                            .n_rollers = roller_rows(s),
                            .roller = s->roller,
                            .n_limits = sim_limits(s->sim, limit),
                            .limit = limit,
                            .n_overloads = sim_overload(s->sim, &overload),
                            .trip_N = sim_trip_force(s->sim)};
    if (labels.n_overloads < 0) return error_memory(err);
    labels.overload = overload;
    sim_summary(s->sim, &summary);
    const hawser_status status = summary_json(&summary, &labels, text, err);
    free(overload);
    return status;
}
