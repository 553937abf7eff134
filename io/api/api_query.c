/* A close look at a simulation, for those who ask. */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "sim/equipment/rod.h"

#include <math.h>
#include <stdlib.h>

hawser_status hawser_sim_contacts(hawser_sim *s, const hawser_contact **out, int *n, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out || !n) return error_argument(err, !s ? "s" : !out ? "out" : "n");
    const hawser_sample *const look = hawser_sim_sample(s);
    const hawser_status status = closeup_contacts(&s->closeup, &s->stage.scene, &s->stage.ws, look->t, err);
    *out = s->closeup.contact;
    *n = status ? 0 : s->closeup.n_contacts;
    return status;
}

hawser_status hawser_sim_cable(hawser_sim *s, const hawser_cable_point **out, int *n, int *first, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out || !n) return error_argument(err, !s ? "s" : !out ? "out" : "n");
    const hawser_sample *const look = hawser_sim_sample(s);
    const hawser_status status = closeup_cable(&s->closeup, &s->stage.scene, &s->stage.ws, look, err);
    *out = s->closeup.joint;
    *n = status ? 0 : s->stage.scene.chain.n + 1;
    if (first) *first = s->stage.scene.first;
    return status;
}

hawser_status hawser_sim_watch_envelope(hawser_sim *s, hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    envelope_free(&s->envelope);
    return envelope_new(&s->envelope, &s->stage.scene, err);
}

static hawser_extremes extremes_of(const Extremes *from)
{
    return (hawser_extremes){from->least, from->mean, from->largest};
}

hawser_status hawser_sim_envelope(const hawser_sim *s, int along_route, hawser_envelope *out, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    if (!s->envelope.present)
        return error_set(err, HAWSER_ERR_INPUT, "no envelope is kept: hawser_sim_watch_envelope begins one");
    const EnvelopeLine *const line = along_route ? &s->envelope.place : &s->envelope.arc;
    *out = (hawser_envelope){.n = line->n,
                             .at_m = line->s,
                             .time_s = line->time,
                             .tension_N = extremes_of(&line->tension),
                             .curvature_per_m = extremes_of(&line->curvature),
                             .sidewall_N_per_m = extremes_of(&line->sidewall)};
    return HAWSER_OK;
}

hawser_status hawser_sim_geometry(hawser_sim *s, const hawser_geometry **out, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    if (!s->around) s->around = around_new(&s->stage.scene, err);
    *out = s->around ? &s->around->shown : NULL;
    return s->around ? HAWSER_OK : HAWSER_ERR_MEMORY;
}

/* Errors: INPUT. */
static hawser_status route_there(const hawser_sim *s, const void *out, hawser_error *err)
{
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    return s->stage.scene.rod->present ? error_set(err, HAWSER_ERR_INPUT, "a rod has no route") : HAWSER_OK;
}

hawser_status hawser_sim_route_length(const hawser_sim *s, double *length_m, hawser_error *err)
{
    s = SHOWN(s);
    const hawser_status status = route_there(s, length_m, err);
    if (!status) *length_m = s->stage.scene.route.length;
    return status;
}

hawser_status hawser_sim_route_at(const hawser_sim *s, double s_m, hawser_route_place *out, hawser_error *err)
{
    s = SHOWN(s);
    const hawser_status status = route_there(s, out, err);
    if (status) return status;
    if (!isfinite(s_m)) return error_set(err, HAWSER_ERR_INPUT, "a place of %g m along the route", s_m);
    const RoutePoint at = route_at(&s->stage.scene.route, s_m);
    v3_put(out->position_m, at.position);
    v3_put(out->tangent, at.tangent);
    v3_put(out->curvature_per_m, at.curvature);
    return HAWSER_OK;
}
