#include "fmi/model.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"

static void variables_free(Variables *v);
static hawser_status variables_add_inputs(Variables *v, const hawser_case *c, hawser_error *err);
static hawser_status variables_add_outputs(Variables *v, const hawser_case *c, hawser_sim *s, hawser_error *err);
static hawser_status variables_add_parameters(Variables *v, hawser_case *c, hawser_error *err);

const UnitRow unit_rows[UNIT_ROWS] = {
    {"m", 0, 1, 0, 0},         {"m2", 0, 2, 0, 0},     {"s", 0, 0, 1, 0},      {"m/s", 0, 1, -1, 0},
    {"m/s2", 0, 1, -2, 0},     {"rad", 0, 0, 0, 1},    {"rad/s", 0, 0, -1, 1}, {"N", 1, 1, -2, 0},
    {"Pa", 1, -1, -2, 0},      {"N.m2", 1, 3, -2, 0},  {"N.m", 1, 2, -2, 0},   {"kg/m3", 1, -3, 0, 0},
    {"kg/m", 1, -1, 0, 0},     {"kg", 1, 0, 0, 0},     {"kg.m2", 1, 2, 0, 0},  {"N/m", 1, 0, -2, 0},
    {"N.m/rad", 1, 2, -2, -1}, {"N.s/m", 1, 0, -1, 0}, {"m-1", 0, -1, 0, 0},   {"Hz", 0, 0, -1, 0},
    {"W", 1, 2, -3, 0},        {"J", 1, 2, -2, 0},     {"m3", 0, 3, 0, 0},     {"N.s", 1, 1, -1, 0},
    {"kg/s", 1, 0, -1, 0},
};

/* Returns the name of a unit in hawser's form, "N m", or NULL for a pure number or one that is not in the list. */
static const char *unit_name(const char *written)
{
    char dotted[32];
    size_t n = 0;
    for (; written[n] && n + 1 < sizeof dotted; ++n) dotted[n] = written[n] == ' ' ? '.' : written[n];
    dotted[n] = 0;
    for (int i = 0; i < UNIT_ROWS; ++i) {
        if (strcmp(dotted, unit_rows[i].name) == 0) return unit_rows[i].name;
    }
    return NULL;
}

static const char *variable_step(const char *step, char to[VARIABLE_STEP_MAX])
{
    static const char LETTERS[] = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789",
                      QUOTED[] = "!#$&()*+,-./:;<>=?@[]^{}|~ ";
    char *at = to;
    if (*step && !strchr("0123456789", *step) && !step[strspn(step, LETTERS)]) {
        snprintf(to, VARIABLE_STEP_MAX, "%s", step);
        return to;
    }
    *at++ = '\'';
    for (const char *c = step; *c && at + 5 < to + VARIABLE_STEP_MAX; ++c) {
        if (strchr(LETTERS, *c) || strchr(QUOTED, *c))
            *at++ = *c;
        else
            at += snprintf(at, 4, "%%%02X", (unsigned char)*c);
    }
    *at++ = '\'';
    *at = 0;
    return to;
}

static int is_taken(const Variables *v, const char *name)
{
    for (int i = 0; i < v->n; ++i) {
        if (strcmp(v->row[i].name, name) == 0) return 1;
    }
    return 0;
}

static hawser_status room_make(Variables *v, hawser_error *err)
{
    if (v->n < v->room) return HAWSER_OK;
    const int room = 2 * v->room + 64;
    Variable *const row = realloc(v->row, (size_t)room * sizeof *row);
    if (!row) return error_memory(err);
    v->row = row;
    v->room = room;
    return HAWSER_OK;
}

/* Adds a copy of the row with a unique name, made from a format, and its description. Errors: MEMORY. */
static hawser_status variable_add(Variables *v, const Variable *row, const char *description, hawser_error *err,
                                  const char *name, ...)
{
    char text[512];
    va_list list;
    va_start(list, name);
    vsnprintf(text, sizeof text - 16, name, list);
    va_end(list);
    const size_t length = strlen(text);
    for (int again = 2; is_taken(v, text); ++again) snprintf(text + length, 16, "_%d", again);
    const hawser_status status = room_make(v, err);
    if (status) return status;
    Variable *const own = &v->row[v->n];
    *own = *row;
    own->name = strdup(text);
    own->description = strdup(description);
    own->what = row->what ? strdup(row->what) : NULL;
    own->key = row->key ? strdup(row->key) : NULL;
    ++v->n; /* its parts are freed with the list */
    const int whole = own->name && own->description && (own->what || !row->what) && (own->key || !row->key);
    return whole ? HAWSER_OK : error_memory(err);
}

/* Makes the list. `s` is a simulation of the case as it is. Errors: MEMORY. */
static hawser_status variables_make(hawser_case *c, hawser_sim *s, Variables *out, hawser_error *err)
{
    static const Variable time = {.type = VARIABLE_REAL, .role = ROLE_TIME, .unit = "s"};
    *out = (Variables){0};
    hawser_status status = variable_add(out, &time, "time of the simulation", err, "time");
    if (!status) status = variables_add_inputs(out, c, err);
    if (!status) status = variables_add_outputs(out, c, s, err);
    if (!status) status = variables_add_parameters(out, c, err);
    if (status) variables_free(out);
    return status;
}

static void variables_free(Variables *v)
{
    for (int i = 0; i < v->n; ++i) {
        free(v->row[i].name);
        free(v->row[i].description);
        free(v->row[i].what);
        free(v->row[i].key);
    }
    free(v->row);
    *v = (Variables){0};
}

/* ------------------------------------------------------------------------------------------------------- token */

/* FNV-1a, 64 bits. */
static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    for (const unsigned char *b = bytes; size-- > 0; ++b) hash = (hash ^ *b) * 0x100000001b3u;
    return hash;
}

static void variables_token(const Variables *v, const char *case_text, char token[TOKEN_SIZE])
{
    uint64_t half[2] = {0xcbf29ce484222325u, 0x84222325cbf29ce4u};
    for (int k = 0; k < 2; ++k) {
        half[k] = mix(half[k], hawser_version(), strlen(hawser_version()));
        half[k] = mix(half[k], case_text, strlen(case_text));
        for (int i = 0; i < v->n; ++i) {
            const Variable *const row = &v->row[i];
            const unsigned char kind[2] = {(unsigned char)row->type, (unsigned char)row->role};
            half[k] = mix(half[k], row->name, strlen(row->name) + 1);
            half[k] = mix(half[k], kind, sizeof kind);
            half[k] = mix(half[k], &row->start, sizeof row->start);
        }
    }
    snprintf(token, TOKEN_SIZE, "%08x-%04x-%04x-%04x-%012llx", (unsigned)(half[0] >> 32),
             (unsigned)(half[0] >> 16 & 0xffff), (unsigned)(half[0] & 0xffff), (unsigned)(half[1] >> 48),
             (unsigned long long)(half[1] & 0xffffffffffffu));
}

/* Makes a case of the text, and sets the parameters that differ from their start values. value NULL: none. */
static hawser_status case_make(const Model *m, const double *value, hawser_case **out, hawser_error *err)
{
    char text[80];
    hawser_status status = hawser_case_parse(m->text, MODEL_CASE, out, err);
    if (!status) status = hawser_case_folder(*out, m->folder, err);
    for (int i = 0; value && i < m->variables.n && !status; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (row->role != ROLE_PARAMETER || !(value[i] < row->start || value[i] > row->start)) continue;
        snprintf(text, sizeof text, "%.17g %s", value[i], row->written);
        status = hawser_case_set(*out, row->key, text, err);
    }
    if (!status) status = case_ensure_read(*out, err);
    if (!status) status = case_alone(*out, "a mock-up unit", err);
    return status;
}

hawser_status model_build(const Model *m, const double *value, hawser_sim **sim, hawser_error *err)
{
    hawser_case *c = NULL;
    *sim = NULL;
    hawser_status status = case_make(m, value, &c, err);
    if (!status) status = hawser_sim_new(c, NULL, sim, err);
    hawser_case_free(c);
    return status;
}

hawser_status model_make(char *text, const char *folder, Model *out, hawser_sim **sim, hawser_error *err)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    *out = (Model){.text = text, .folder = strdup(folder)};
    hawser_status status = out->folder ? case_make(out, NULL, &c, err) : error_memory(err);
    if (!status) status = hawser_sim_new(c, NULL, &s, err);
    if (!status) status = variables_make(c, s, &out->variables, err);
    if (!status) {
        variables_token(&out->variables, text, out->token);
        out->interval = c->def->output.interval;
        out->duration = hawser_sim_end_time(s);
    }
    if (sim) *sim = s;
    if (!sim || status) hawser_sim_free(s);
    if (sim && status) *sim = NULL;
    hawser_case_free(c);
    if (status) model_clear(out);
    return status;
}

hawser_status model_load(const char *folder, Model *out, hawser_sim **sim, hawser_error *err)
{
    char path[4096], *text = NULL;
    size_t size;
    *out = (Model){0};
    if (sim) *sim = NULL;
    if (snprintf(path, sizeof path, "%s/%s", folder, MODEL_CASE) >= (int)sizeof path)
        return error_set(err, HAWSER_ERR_INPUT, "the folder of the resources has too long a name");
    const hawser_status status = case_file_read(path, &text, &size, err);
    return status ? status : model_make(text, folder, out, sim, err);
}

void model_clear(Model *m)
{
    variables_free(&m->variables);
    free(m->text);
    free(m->folder);
    *m = (Model){0};
}

/* Inputs: the commands of a running simulation (hawser/control.h), as values that last. An input at its start value
 * leaves the case's own drive unchanged. */

static hawser_status command_add(Variables *v, hawser_control command, const char *what, double start,
                                 const char *description, const char *name, hawser_error *err)
{
    const CommandKind *const kind = command_kind((int)command);
    const Variable row = {.type = VARIABLE_REAL,
                          .role = ROLE_INPUT,
                          .unit = unit_name(kind->unit),
                          .start = start,
                          .least = kind->least,
                          .most = kind->most,
                          .to = TO_COMMAND,
                          .command = command,
                          .what = (char *)(size_t)what};
    return variable_add(v, &row, description, err, "%s", name);
}

static hawser_status switch_add(Variables *v, InputTo to, const char *what, const char *description, const char *name,
                                hawser_error *err)
{
    const Variable row = {.type = VARIABLE_BOOLEAN,
                          .role = ROLE_INPUT,
                          .least = NAN,
                          .most = NAN,
                          .to = to,
                          .what = (char *)(size_t)what};
    return variable_add(v, &row, description, err, "%s", name);
}

/* Returns the final value of a drive. */
static double profile_end(const Profile *p) { return p->kind == PROFILE_TABLE ? p->value[p->n - 1] : p->v1; }

static hawser_status winch_add(Variables *v, const WinchDef *w, hawser_error *err)
{
    const int by_speed = w->mode == WINCH_SPEED;
    hawser_status status = by_speed ? command_add(v, HAWSER_WINCH_SPEED, NULL, profile_end(&w->speed),
                                                  "speed that the winch is set to", "winch.speed", err)
                                    : command_add(v, HAWSER_WINCH_TENSION, NULL, profile_end(&w->tension),
                                                  "tension that the winch is set to", "winch.tension", err);
    if (!status)
        status =
            switch_add(v, TO_BRAKE, NULL, "the winch is braked and held; false again: it goes on", "winch.brake", err);
    if (!status)
        status = switch_add(v, TO_PAUSE, NULL,
                            by_speed ? "the winch stands; false again: it goes on"
                                     : "the winch pulls with nothing; false again: it goes on",
                            "winch.pause", err);
    return status;
}

static hawser_status conveyor_add(Variables *v, const SceneDef *def, const ConveyorDef *c, hawser_error *err)
{
    char name[VARIABLE_STEP_MAX + 32], step[VARIABLE_STEP_MAX];
    const double alone = def->winch.present && def->winch.mode == WINCH_SPEED ? profile_end(&def->winch.speed) : 0;
    snprintf(name, sizeof name, "conveyors.%s.speed", variable_step(c->name, step));
    hawser_status status = command_add(
        v, HAWSER_CONVEYOR_SPEED, c->name, c->sync ? c->factor * alone : profile_end(&c->speed),
        c->sync ? "speed of the belt; where it begins it follows the winch" : "speed of the belt", name, err);
    snprintf(name, sizeof name, "conveyors.%s.clamp", step);
    if (!status)
        status = command_add(v, HAWSER_CONVEYOR_CLAMP, c->name, c->clamp,
                             "force by which each belt is pressed on the cable", name, err);
    snprintf(name, sizeof name, "conveyors.%s.jam", step);
    return status
               ? status
               : switch_add(v, TO_JAM, c->name, "true: the conveyor has stopped; false again: it goes on", name, err);
}

static hawser_status variables_add_inputs(Variables *v, const hawser_case *c, hawser_error *err)
{
    const SceneDef *const def = c->def;
    hawser_status status = HAWSER_OK;
    if (def->analysis.kind != ANALYSIS_DYNAMICS) return HAWSER_OK; /* no commands are possible there */
    if (def->winch.present) status = winch_add(v, &def->winch, err);
    for (int i = 0; i < def->n_conveyors && !status; ++i) status = conveyor_add(v, def, &def->conveyors[i], err);
    if (!status && def->reel.model == REEL_PAYOUT && def->reel.torque > 0)
        status =
            command_add(v, HAWSER_REEL_BRAKE, NULL, def->reel.torque, "torque of the reel's brake", "reel.brake", err);
    if (!status && (def->n_rollers > 0 || def->n_surfaces > 0))
        status = command_add(v, HAWSER_FRICTION, NULL, 1, "all friction, as so many times the case's",
                             "friction.factor", err);
    return status;
}

/* Outputs: the present figures of a sample, and the limits of the run so far. */

/* Requirement of a row of the sample. */
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

/* Adds one after the other; nothing after the first error. */
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

/* Returns the meaning of a machine's figure, by key. A figure with a new key needs a row here; the test of descriptions
 * checks that. */
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

/* Splits "slip_m_per_s" into the figure's name and its unit, which is returned. */
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

/* Adds the verdict and limits of the run so far. */
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

static hawser_status variables_add_outputs(Variables *v, const hawser_case *c, hawser_sim *s, hawser_error *err)
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

/* Parameters: every number that the case gives, under "case." by its own key; items of lists by their names, as in
 * inputs and outputs, or by their place from 1 where they have none. A default becomes a parameter when the case gives
 * it. Keys about results are left out, as are long lists, for example of rollers or marks. */

enum { LIST_MAX = 40 };

typedef struct Walk {
    Variables *v;
    const CaseReader *r;
    hawser_error *err;
} Walk;

/* Returns the length of a text to show: the sentences that end within 200 bytes, the first in any case. */
static int sentences_length(const char *text)
{
    const size_t all = strlen(text);
    size_t n = 0;
    for (const char *end = text; (end = strstr(end, ". ")) && (n == 0 || end - text <= 200); ++end)
        n = (size_t)(end - text);
    if (n == 0 || all <= 200) n = all;
    if (n > 1000) n = 1000;
    return (int)(n > 0 && text[n - 1] == '.' ? n - 1 : n);
}

/* Adds a number of the case: its value in SI is the parameter's start. One that cannot be read by its dimension alone
 * (a stiffness per power of a length) is left out. */
static hawser_status number_add(const Walk *w, const CaseNode *node, const CaseSection *section, const CaseKey *key,
                                const char *name)
{
    const char *const unit = dimension_unit(key->dimension), *const meaning =
                                                                 case_key_meaning(section, key, LANGUAGE_ENGLISH);
    char description[1400], example[112] = "", path[CASE_PATH_MAX];
    double value;
    if (key->dimension == DIM_STIFFNESS || case_number_read(w->r, node, key, &value)) return HAWSER_OK;
    if (strlen(node->text) < 80) snprintf(example, sizeof example, ", %.80s", node->text);
    snprintf(description, sizeof description, "%.*s (%s%s)", sentences_length(meaning), meaning,
             case_path(node, NULL, path), example);
    const Variable row = {.type = VARIABLE_REAL,
                          .role = ROLE_PARAMETER,
                          .key = path,
                          .unit = unit_name(unit),
                          .written = key->dimension == DIM_NONE ? "" : unit,
                          .start = value,
                          .least = key->min,
                          .most = key->max};
    return variable_add(w->v, &row, description, w->err, "%s", name);
}

/* The name of a variable, up to a step. */
typedef struct Place {
    char name[512];
} Place;

static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const Place *place);

/* Checks whether a map's keys are names that the user chooses, each with the section's keys below it. */
static int is_named(const CaseSection *section)
{
    const char *const last = strrchr(section->path, '.');
    return last && strcmp(last, ".NAME") == 0;
}

/* Adds a step that `--set` accepts: a name with a dot in it would be split. */
static int step_add(Place *to, const Place *from, const char *step)
{
    char quoted[VARIABLE_STEP_MAX];
    const int size = (int)sizeof to->name;
    return !strchr(step, '.') &&
           snprintf(to->name, sizeof to->name, "%s.%s", from->name, variable_step(step, quoted)) < size;
}

/* Checks that no other item of the list has the name. */
static int is_sole(const CaseNode *list, const char *name)
{
    int n = 0;
    for (const CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = item->kind == NODE_MAP ? case_node_key(item, "name") : NULL;
        n += own && own->kind == NODE_TEXT && !strcmp(own->text, name);
    }
    return n <= 1;
}

/* Adds an item of a list: by its name if it is unique, otherwise by its place. */
static int item_add(Place *to, const Place *from, const CaseNode *list, const CaseNode *item)
{
    char quoted[VARIABLE_STEP_MAX];
    const CaseNode *const own = case_node_key(item, "name");
    const int size = (int)sizeof to->name;
    if (own && own->kind == NODE_TEXT && *own->text && is_sole(list, own->text))
        return snprintf(to->name, sizeof to->name, "%s.%s", from->name, variable_step(own->text, quoted)) < size;
    return snprintf(to->name, sizeof to->name, "%s[%d]", from->name, item->index + 1) < size;
}

static hawser_status items_walk(const Walk *w, const CaseNode *node, const CaseSection *section, const Place *place)
{
    Place inner;
    hawser_status status = HAWSER_OK;
    if (node->count > LIST_MAX) return status;
    for (const CaseNode *item = node->first; item && !status; item = item->next) {
        if (item->kind != NODE_MAP) continue;
        if (item->key ? step_add(&inner, place, item->key) : item_add(&inner, place, node, item))
            status = map_walk(w, item, section, &inner);
    }
    return status;
}

static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const Place *place)
{
    Place inner;
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = map->first; child && !status; child = child->next) {
        const CaseKey *const key = case_key_of(section, child->key);
        if (!key || key->section == &case_output || !step_add(&inner, place, child->key)) continue;
        if (key->kind == KEY_NUMBER && child->kind == NODE_TEXT)
            status = number_add(w, child, section, key, inner.name);
        if (!key->section || child->kind == NODE_TEXT) continue;
        const int items = child->kind == NODE_LIST || is_named(key->section);
        status = items ? items_walk(w, child, key->section, &inner) : map_walk(w, child, key->section, &inner);
    }
    return status;
}

/* Adds the parameters below a node. */
static hawser_status variables_add_parameters(Variables *v, hawser_case *c, hawser_error *err)
{
    hawser_error unread; /* a value that is no number is no parameter */
    const CaseReader r = {.units = units_new(), .def = c->def, .root = c->tree->root, .err = &unread};
    const Walk w = {v, &r, err};
    if (!r.units) return error_memory(err);
    const Variable ramp = {.type = VARIABLE_REAL,
                           .role = ROLE_TUNABLE,
                           .unit = "s",
                           .start = COMMAND_RAMP_USUAL,
                           .least = COMMAND_RAMP_LEAST,
                           .most = COMMAND_RAMP_MOST};
    hawser_status status = variable_add(v, &ramp, "time over which a changed input comes in", err, "inputs.ramp");
    if (!status) status = map_walk(&w, r.root, &case_top, &(Place){"case"});
    units_free(r.units);
    return status;
}
