/* Values of outputs: the sample is taken once a step, limits and verdict are judged only when they are asked for. */
#include <math.h>
#include <string.h>

#include "fmi/unit/unit.h"

static const hawser_sample *look_now(Unit *u)
{
    if (!u->look.fresh) u->look.sample = hawser_sim_sample(u->sim);
    u->look.fresh = 1;
    return u->look.sample;
}

static const Look *judge_now(Unit *u)
{
    Look *const look = &u->look;
    hawser_summary sum;
    if (look->judged) return look;
    hawser_sim_summary(u->sim, &sum);
    look->limits = hawser_sim_limits(u->sim, look->limit);
    look->broken = hawser_verdict(sum.n_conditions, sum.conditions, look->limits, look->limit, look->verdict,
                                  sizeof look->verdict);
    look->mean = sum.pull_mean_N;
    look->peak = sum.pull_peak_N;
    look->judged = 1;
    return look;
}

static double margin_of(const hawser_limit *limit) { return limit->judged ? limit->margin : NAN; }

/* By the variable's name, "margins.push": a run may judge more limits than are known before it. */
static double margin_named(const Look *look, const char *name)
{
    const char *const limit = strrchr(name, '.') ? strrchr(name, '.') + 1 : name;
    for (int i = 0; i < look->limits; ++i)
        if (!strcmp(look->limit[i].name, limit)) return margin_of(&look->limit[i]);
    return NAN;
}

static double worst_margin(const Look *look)
{
    double worst = NAN;
    for (int i = 0; i < look->limits; ++i) worst = fmin(worst, margin_of(&look->limit[i])); /* fmin(NAN, x) is x */
    return worst;
}

static int broken_count(const Look *look)
{
    int n = 0;
    for (int i = 0; i < look->limits; ++i) n += look->limit[i].judged && !look->limit[i].ok;
    return n;
}

static double roller_load(const hawser_sample *now, int item)
{
    double most = 0;
    for (int r = 0; item < 0 && r < now->rollers; ++r) most = fmax(most, now->roller_load[r]);
    return item < 0 ? most : now->roller_load[item];
}

/* As the enumeration of the description counts. */
static double verdict_of(const Look *look) { return 1 + hawser_verdict_word(look->broken); }

double output_number(Unit *u, const Variable *row)
{
    const hawser_event *event;
    const int i = row->item;
    switch (row->from) {
    case FROM_SAMPLE:
        return *(const double *)(const void *)((const char *)look_now(u) + row->at);
    case FROM_CONTACTS:
        return look_now(u)->active_contacts;
    case FROM_ROLLER:
        return roller_load(look_now(u), i);
    case FROM_NORMAL:
        return look_now(u)->surface_normal[i];
    case FROM_FRICTION:
        return look_now(u)->surface_friction[i];
    case FROM_LINE_LOAD:
        return look_now(u)->surface_line_load[i];
    case FROM_FIGURE:
        return look_now(u)->figure[i].value;
    case FROM_PROBE:
        return *(const double *)(const void *)((const char *)&look_now(u)->probe[i] + row->at);
    case FROM_PULL_MEAN:
        return judge_now(u)->mean;
    case FROM_PULL_PEAK:
        return judge_now(u)->peak;
    case FROM_MARGIN:
        return margin_named(judge_now(u), row->name);
    case FROM_WORST:
        return worst_margin(judge_now(u));
    case FROM_BROKEN:
        return broken_count(judge_now(u));
    case FROM_EVENTS:
        return hawser_sim_events(u->sim, &event);
    case FROM_VERDICT:
        return verdict_of(judge_now(u));
    case FROM_EVENT_TEXT:
    case FROM_VERDICT_TEXT:
        break;
    }
    return NAN;
}

const char *output_text(Unit *u, const Variable *row)
{
    const hawser_event *event;
    if (row->from == FROM_VERDICT_TEXT) return judge_now(u)->verdict;
    const int n = hawser_sim_events(u->sim, &event);
    return n > 0 ? event[n - 1].what : "";
}
