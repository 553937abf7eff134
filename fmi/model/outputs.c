/* Outputs: what a sample shows now, and what the run so far says of the limits. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fmi/model/variables.h"
#include "io/api/api_handles.h"

/* When a row of the sample has something to say. */
typedef enum Needs { ALWAYS, A_WINCH, A_FRONT, A_REFERENCE, A_REEL } Needs;

#define OF_SAMPLE(member) offsetof(hawser_sample, member)
static const struct {
    const char *name, *unit;
    size_t at;
    Needs needs;
    const char *description;
} sample_rows[] = {
    {"winch.force", "N", OF_SAMPLE(winch_force), A_WINCH, "pull on the rope's end along the winch's direction"},
    {"winch.rope_speed", "m/s", OF_SAMPLE(winch_speed), A_WINCH, "speed with which the winch hauls now"},
    {"winch.travel", "m", OF_SAMPLE(winch_travel), A_WINCH, "rope that the winch has hauled in so far"},
    {"winch.reference", "N", OF_SAMPLE(reference), A_REFERENCE,
     "force of the winch by the reference theory; NaN where it has none"},
    {"tail.tension", "N", OF_SAMPLE(tail_tension), ALWAYS, "back tension, or tension where the cable leaves the reel"},
    {"cable.head", "m", OF_SAMPLE(head_at), A_FRONT, "place of the cable's front along the route; NaN past the winch"},
    {"cable.max_tension", "N", OF_SAMPLE(max_tension), ALWAYS, "largest tension of the chain now"},
    {"reel.speed", "rad/s", OF_SAMPLE(reel_speed), A_REEL, "angular speed of the reel"},
    {"reel.paid_out", "m", OF_SAMPLE(paid_out), A_REEL, "cable that has left the reel"},
    {"reel.wound", "m", OF_SAMPLE(wound), A_REEL, "cable that is on the reel"},
};
enum { SAMPLE_ROWS = sizeof sample_rows / sizeof *sample_rows };

/* One after the other; none after the first error. */
typedef struct Adding {
    Variables *v;
    hawser_error *err;
    hawser_status status;
} Adding;

static void add(Adding *a, const Variable *row, const char *description, const char *name)
{
    Variable output = *row;
    output.role = ROLE_OUTPUT;
    output.least = output.most = NAN;
    if (!a->status) a->status = variable_add(a->v, &output, description, a->err, "%s", name);
}

static void add_named(Adding *a, Variable row, const char *description, const char *kind, const char *of,
                      const char *figure)
{
    char name[VARIABLE_STEP_MAX + 2 * NAME_MAX_LENGTH], step[VARIABLE_STEP_MAX];
    snprintf(name, sizeof name, "%s.%s.%s", kind, variable_step(of, step), figure);
    add(a, &row, description, name);
}

static int is_there(const SceneDef *def, const hawser_sample *look, Needs needs)
{
    if (needs == A_WINCH) return def->winch.present;
    if (needs == A_FRONT) return !isnan(look->head_at);
    if (needs == A_REFERENCE) return !isnan(look->head_at) && def->winch.present;
    return needs == ALWAYS || !isnan(look->paid_out);
}

/* What the machines' figures are, by key. A figure of a new key adds its row here; the test of descriptions sees to it.
 */
static const char *figure_meaning(const char *key)
{
    static const char *const rows[][2] = {
        {"force_N", "force of the machine on the cable along the pull"},
        {"slip_m_per_s", "speed of the cable less that of the machine's belt; 0 where there is no cable"},
        {"torque_N_m", "torque of the machine on its roller, positive with the pull"},
        {"speed_m_per_s", "speed of the surface of the machine's roller"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        if (!strcmp(rows[i][0], key)) return rows[i][1];
    return "";
}

/* "slip_m_per_s": the figure's name, without what is its unit. */
static const char *figure_unit(const char *key, char name[NAME_MAX_LENGTH])
{
    static const struct {
        const char *end, *unit;
    } ends[] = {{"_rad_per_s", "rad/s"}, {"_m_per_s", "m/s"}, {"_N_m", "N.m"}, {"_N", "N"}, {"_W", "W"}, {"_m", "m"}};
    snprintf(name, NAME_MAX_LENGTH, "%s", key);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
        const size_t n = strlen(name), k = strlen(ends[i].end);
        if (n <= k || strcmp(name + n - k, ends[i].end) != 0) continue;
        name[n - k] = 0;
        return ends[i].unit;
    }
    return NULL;
}

static void machines_add(Adding *a, const hawser_sample *look)
{
    char figure[NAME_MAX_LENGTH];
    int item = 0;
    for (int m = 0; m < look->machines; ++m) {
        const hawser_machine *const machine = &look->machine[m];
        for (int k = 0; k < machine->n_now; ++k, ++item) {
            const char *const unit = figure_unit(machine->now[k].key, figure);
            const Variable row = {.type = VARIABLE_REAL, .unit = unit, .from = FROM_FIGURE, .item = item};
            add_named(a, row, figure_meaning(machine->now[k].key), machine->kind, machine->name, figure);
        }
    }
}

static void things_add(Adding *a, const SceneDef *def, hawser_sim *s)
{
    const hawser_roller *roller;
    const hawser_surface *surface;
    const int n_rollers = hawser_sim_rollers(s, &roller), n_surfaces = hawser_sim_surfaces(s, &surface);
    const Variable all = {.type = VARIABLE_REAL, .unit = "N", .from = FROM_ROLLER, .item = -1};
    if (n_rollers > 0) add(a, &all, "largest contact force on a roller now", "cable.max_roller_load");
    for (int k = 0; k < def->output.n_load_rollers; ++k) {
        const int r = def->output.load_rollers[k];
        const Variable row = {.type = VARIABLE_REAL, .unit = "N", .from = FROM_ROLLER, .item = r};
        add_named(a, row, "contact force on the roller", "rollers", roller[r].name, "load");
    }
    for (int i = 0; i < n_surfaces; ++i) {
        Variable row = {.type = VARIABLE_REAL, .unit = "N", .from = FROM_NORMAL, .item = i};
        add_named(a, row, "sum of the normal forces on the surface", "surfaces", surface[i].name, "normal");
        row.from = FROM_FRICTION;
        add_named(a, row, "sum of the friction forces on the surface", "surfaces", surface[i].name, "friction");
        row.from = FROM_LINE_LOAD;
        row.unit = "N/m";
        add_named(a, row, "largest normal force per length of cable", "surfaces", surface[i].name, "line_load");
    }
}

static void probes_add(Adding *a, const hawser_sample *look)
{
    static const struct {
        const char *figure, *unit, *description;
        size_t at;
    } rows[] = {
        {"displacement", "m", "displacement from where the probe was at the start",
         offsetof(hawser_probe, displacement)},
        {"rotation", "rad", "rotation from how the probe was at the start, as a vector",
         offsetof(hawser_probe, rotation)},
        {"force", "N", "force that the part ahead puts on the part behind", offsetof(hawser_probe, force)},
        {"moment", "N.m", "moment that the part ahead puts on the part behind", offsetof(hawser_probe, moment)},
    };
    for (int p = 0; p < look->probes; ++p) {
        for (size_t k = 0; k < 3 * sizeof rows / sizeof *rows; ++k) {
            char figure[NAME_MAX_LENGTH];
            const Variable row = {.type = VARIABLE_REAL,
                                  .unit = rows[k / 3].unit,
                                  .from = FROM_PROBE,
                                  .item = p,
                                  .at = rows[k / 3].at + k % 3 * sizeof(double)};
            snprintf(figure, sizeof figure, "%s.%c", rows[k / 3].figure, "xyz"[k % 3]);
            add_named(a, row, rows[k / 3].description, "probes", look->probe[p].name, figure);
        }
    }
}

/* What is judged of the run so far. */
static void judgement_add(Adding *a, hawser_sim *s, int has_winch)
{
    static const Variable mean = {.type = VARIABLE_REAL, .unit = "N", .from = FROM_PULL_MEAN},
                          peak = {.type = VARIABLE_REAL, .unit = "N", .from = FROM_PULL_PEAK},
                          worst = {.type = VARIABLE_REAL, .from = FROM_WORST},
                          broken = {.type = VARIABLE_INTEGER, .from = FROM_BROKEN},
                          verdict = {.type = VARIABLE_VERDICT, .from = FROM_VERDICT},
                          words = {.type = VARIABLE_TEXT, .from = FROM_VERDICT_TEXT};
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const int n = hawser_sim_limits(s, limit);
    if (has_winch) add(a, &mean, "mean of the winch's force in the steady window so far", "pull.mean");
    if (has_winch) add(a, &peak, "largest force of the winch so far", "pull.peak");
    for (int i = 0; i < n; ++i) {
        char name[NAME_MAX_LENGTH];
        const Variable row = {.type = VARIABLE_REAL, .from = FROM_MARGIN, .item = i};
        snprintf(name, sizeof name, "margins.%s", limit[i].name);
        add(a, &row, "margin of the run so far; 1: far from the limit, below 0: it is broken, NaN: not judged", name);
    }
    if (n > 0) add(a, &worst, "least margin of those that are judged; NaN: none is", "margins.worst");
    if (n > 0) add(a, &broken, "how many limits are broken", "margins.broken");
    add(a, &verdict, "whether the pull is safe so far", "verdict.word");
    add(a, &words, "the verdict in words", "verdict.text");
}

hawser_status variables_add_outputs(Variables *v, const hawser_case *c, hawser_sim *s, hawser_error *err)
{
    static const Variable contacts = {.type = VARIABLE_INTEGER, .from = FROM_CONTACTS},
                          events = {.type = VARIABLE_INTEGER, .from = FROM_EVENTS},
                          last = {.type = VARIABLE_TEXT, .from = FROM_EVENT_TEXT};
    Adding a = {.v = v, .err = err};
    const hawser_sample *const look = hawser_sim_sample(s);
    for (int i = 0; i < SAMPLE_ROWS; ++i) {
        const Variable row = {
            .type = VARIABLE_REAL, .unit = sample_rows[i].unit, .from = FROM_SAMPLE, .at = sample_rows[i].at};
        if (is_there(c->def, look, sample_rows[i].needs))
            add(&a, &row, sample_rows[i].description, sample_rows[i].name);
    }
    add(&a, &contacts, "places where the cable touches something", "cable.contacts");
    things_add(&a, c->def, s);
    machines_add(&a, look);
    probes_add(&a, look);
    judgement_add(&a, s, c->def->winch.present);
    add(&a, &events, "how many events there were, commands included", "events.count");
    add(&a, &last, "the last event in words", "events.last");
    return a.status;
}
