#include "fmi/unit.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/run/sim.h"

/* Returns the part behind "file:" and an empty host or the local one; the whole if there is no scheme; NULL: anything
 * else. */
static const char *path_of(const char *address)
{
    if (strncmp(address, "file:", 5) != 0) return strstr(address, "://") ? NULL : address;
    const char *path = address + 5;
    if (strncmp(path, "//", 2) == 0) path += 2;
    if (strncmp(path, "localhost/", 10) == 0) path += 9;
    return *path == '/' ? path : NULL;
}

/* Decodes "%20" -> ' ' in place. Returns 0 where a '%' is not followed by two hexadecimal digits, or stands for a NUL.
 */
static int escapes_take(char *path)
{
    char *to = path;
    for (const char *from = path; *from; ++from, ++to) {
        *to = *from;
        if (*from != '%') continue;
        if (!isxdigit((unsigned char)from[1]) || !isxdigit((unsigned char)from[2])) return 0;
        const char code[] = {from[1], from[2], 0};
        *to = (char)strtol(code, NULL, 16);
        if (!*to) return 0;
        from += 2;
    }
    *to = 0;
    return 1;
}

char *address_folder(const char *address)
{
    const char *const path = address ? path_of(address) : NULL;
    char *folder = path && *path ? strdup(path) : NULL;
    if (folder && path != address && !escapes_take(folder)) {
        free(folder);
        return NULL;
    }
    for (size_t n = folder ? strlen(folder) : 0; n > 1 && folder[n - 1] == '/'; --n) folder[n - 1] = 0;
    return folder;
}

/* Values of outputs: the sample is taken once a step, limits and verdict are judged only on request. */

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

/* Finds a margin by the variable's name, "margins.push": a run may judge more limits than are known before it. */
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

/* Returns the verdict in the numbers of the description's enumeration. */
static double verdict_of(const Look *look) { return 1 + hawser_verdict_word(look->broken); }

/* Returns the number of an output; the simulation exists. */
static double output_number(Unit *u, const Variable *row)
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

static const char *output_text(Unit *u, const Variable *row)
{
    const hawser_event *event;
    if (row->from == FROM_VERDICT_TEXT) return judge_now(u)->verdict;
    const int n = hawser_sim_events(u->sim, &event);
    return n > 0 ? event[n - 1].what : "";
}

Outcome unit_say(Unit *u, Outcome outcome, const char *format, ...)
{
    static const char *const categories[] = {"logEvents", "logStatusWarning", "logStatusWarning", "logStatusError",
                                             "logStatusError"};
    char text[HAWSER_MESSAGE_MAX + 128];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (outcome == FAILED) u->phase = PHASE_FAILED;
    if (u->say && (outcome != GOES_WELL || u->logging)) u->say(u->host, outcome, categories[outcome], text);
    return outcome;
}

Unit *unit_in(const void *instance, unsigned phases, const char *call)
{
    Unit *const u = instance ? ((const Instance *)instance)->unit : NULL;
    if (!u || u->phase & phases) return u;
    const char *const now = u->phase == PHASE_INSTANTIATED   ? "not initialized yet"
                            : u->phase == PHASE_INITIALIZING ? "being initialized"
                            : u->phase == PHASE_STEPPING     ? "being stepped"
                            : u->phase == PHASE_OVER         ? "terminated"
                                                             : "at an error: reset or free it";
    unit_say(u, FAILED, "%s cannot be called now: the instance is %s", call, now);
    return NULL;
}

Outcome unit_denied(const void *instance, const char *call)
{
    Unit *const u = instance ? ((const Instance *)instance)->unit : NULL;
    return u ? unit_say(u, FAILED, "%s is not provided: the unit is for co-simulation without events and clocks", call)
             : FAILED;
}

Outcome outcome_worse(Outcome a, Outcome b) { return b > a ? b : a; }

/* ---------------------------------------------------------------------------------------------------- start */

/* Sets the start values of the description. */
static void values_begin(Unit *u)
{
    for (int i = 0; i < u->model.variables.n; ++i)
        u->value[i] = u->told[i] = u->built[i] = u->model.variables.row[i].start;
}

static void sim_drop(Unit *u)
{
    hawser_sim_free(u->sim);
    u->sim = NULL;
    u->relaxed = 0;
    u->rows = 0;
    u->look = (Look){0};
}

Unit *unit_new(const char *folder, const char *token, int logging, Say say, void *host)
{
    hawser_error err = {HAWSER_OK, ""};
    Unit *const u = calloc(1, sizeof *u);
    if (!u) return NULL;
    u->logging = logging;
    u->say = say;
    u->host = host;
    if (model_load(folder, &u->model, &u->sim, &err)) {
        unit_say(u, FAILED, "%s", err.message);
        return unit_free(u);
    }
    if (!token || strcmp(token, u->model.token) != 0) {
        unit_say(u, FAILED, "the token is not that of the archive's case: %s was given, %s is", token ? token : "none",
                 u->model.token);
        return unit_free(u);
    }
    const size_t n = (size_t)u->model.variables.n;
    u->value = calloc(3 * n, sizeof *u->value);
    if (!u->value) {
        unit_say(u, FAILED, "out of memory");
        return unit_free(u);
    }
    u->told = u->value + n;
    u->built = u->told + n;
    values_begin(u);
    u->phase = PHASE_INSTANTIATED;
    u->stop = INFINITY;
    u->ends = u->model.duration;
    return u;
}

Unit *unit_free(Unit *u)
{
    if (!u) return NULL;
    hawser_sim_free(u->sim);
    model_clear(&u->model);
    free(u->value);
    free(u);
    return NULL;
}

/* Checks whether a parameter differs from the value that the simulation was built with. */
static int is_stale(const Unit *u)
{
    for (int i = 0; i < u->model.variables.n; ++i) {
        const int differs = u->value[i] < u->built[i] || u->value[i] > u->built[i];
        if (u->model.variables.row[i].role == ROLE_PARAMETER && differs) return 1;
    }
    return 0;
}

/* Keeps the simulation as long as it has the parameters, and if `fresh` is set only at its start; otherwise builds it
 * again. */
static Outcome unit_rebuild(Unit *u, int fresh)
{
    hawser_error err = {HAWSER_OK, ""};
    if (u->sim && !is_stale(u) && !(fresh && u->relaxed)) return GOES_WELL;
    sim_drop(u);
    if (model_build(&u->model, u->value, &u->sim, &err)) return unit_say(u, FAILED, "%s", err.message);
    memcpy(u->built, u->value, (size_t)u->model.variables.n * sizeof *u->built);
    u->ends = hawser_sim_end_time(u->sim);
    return GOES_WELL;
}

/* Does the same, at equilibrium if the case requires it, and with its statistics. */
static Outcome sim_ready(Unit *u)
{
    hawser_error err = {HAWSER_OK, ""};
    const Outcome outcome = unit_rebuild(u, 0);
    if (outcome || u->relaxed) return outcome;
    assert(u->sim);
    if (u->sim->stage.scene.def.solver.relax && hawser_sim_relax(u->sim, NULL, &err))
        return unit_say(u, FAILED, "%s", err.message);
    u->relaxed = 1;
    sim_record_row(u->sim);
    u->rows = 1;
    u->look.fresh = u->look.judged = 0;
    return GOES_WELL;
}

/* ------------------------------------------------------------------------------------------------------- phases */

double unit_time(const Unit *u) { return u->start + (u->sim ? hawser_sim_time(u->sim) : 0); }

Outcome unit_set_times(Unit *u, double start, int has_stop, double stop)
{
    if (!isfinite(start) || (has_stop && !(stop > start)))
        return unit_say(u, FAILED, "times from %g s to %g s: a finite start is needed, and a later stop", start, stop);
    u->start = start;
    u->stop = has_stop ? stop : INFINITY;
    return GOES_WELL;
}

Outcome unit_begin(Unit *u)
{
    u->phase = PHASE_INITIALIZING;
    return GOES_WELL;
}

Outcome unit_settle(Unit *u)
{
    const Outcome outcome = sim_ready(u);
    if (!outcome) u->phase = PHASE_STEPPING;
    return outcome;
}

Outcome unit_end(Unit *u)
{
    u->phase = PHASE_OVER;
    return GOES_WELL;
}

Outcome unit_reset(Unit *u)
{
    sim_drop(u);
    values_begin(u);
    u->phase = PHASE_INSTANTIATED;
    u->start = 0;
    u->stop = INFINITY;
    return GOES_WELL;
}

/* -------------------------------------------------------------------------------------------------------- steps */

/* Gives the command of one input whose value differs from the last command. A failure is reported; the step continues.
 */
static Outcome input_tell(Unit *u, int i, double ramp)
{
    const Variable *const row = &u->model.variables.row[i];
    const int on = u->value[i] > 0.5;
    hawser_control command = row->command;
    hawser_error err = {HAWSER_OK, ""};
    if (row->to == TO_BRAKE) command = on ? HAWSER_WINCH_BRAKE : HAWSER_WINCH_RESTART;
    if (row->to == TO_PAUSE) command = on ? HAWSER_WINCH_PAUSE : HAWSER_WINCH_RESTART;
    if (row->to == TO_JAM) command = on ? HAWSER_JAM : HAWSER_RELEASE;
    u->told[i] = u->value[i];
    u->look.fresh = u->look.judged = 0;
    if (!hawser_sim_control(u->sim, command, row->what, u->value[i], ramp, &err)) return GOES_WELL;
    return unit_say(u, GOES_WITH_A_WORD, "%s: %s", row->name, err.message);
}

static Outcome inputs_tell(Unit *u)
{
    const Variables *const v = &u->model.variables;
    double ramp = COMMAND_RAMP_USUAL;
    Outcome worst = GOES_WELL;
    for (int i = 0; i < v->n; ++i) {
        if (v->row[i].role == ROLE_TUNABLE) ramp = u->value[i];
    }
    for (int i = 0; i < v->n; ++i) {
        const int differs = u->value[i] < u->told[i] || u->value[i] > u->told[i];
        if (v->row[i].role == ROLE_INPUT && differs && input_tell(u, i, ramp)) worst = GOES_WITH_A_WORD;
    }
    return worst;
}

/* Records samples of the statistics at whole multiples of the case's interval, in the first step that ends there or
 * later, as hawser_sim_run does. */
static void row_record(Unit *u)
{
    const double t = hawser_sim_time(u->sim), interval = u->model.interval, next = interval * (double)u->rows;
    if (!(interval > 0) || t < next - 1e-9 * fmax(1, next)) return;
    u->rows = (long)floor(t / interval + 1e-9) + 1;
    sim_record_row(u->sim);
}

Outcome unit_step(Unit *u, double now, double step, int *over)
{
    const double at = unit_time(u), next = now + step, slack = 1e-9 * fmax(1, fabs(next));
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = HAWSER_OK;
    *over = 0;
    if (!(step > 0) || !isfinite(next)) return unit_say(u, FAILED, "a step of %g s", step);
    if (!(fabs(now - at) <= slack))
        return unit_say(u, FAILED, "a step from t = %.17g s, but the instance is at t = %.17g s", now, at);
    if (next > u->stop + slack)
        return unit_say(u, FAILED, "a step to t = %.17g s, beyond the stop at %.17g s", next, u->stop);
    const Outcome outcome = inputs_tell(u);
    u->look.fresh = u->look.judged = 0;
    while (!status && hawser_sim_time(u->sim) < next - u->start) {
        const double end = hawser_sim_end_time(u->sim); /* before the case's own end: the winch has ended the run */
        if (end < u->ends && hawser_sim_time(u->sim) >= end) break;
        status = hawser_sim_advance(u->sim, next - u->start, 1, &err);
        if (!status) row_record(u);
    }
    if (status) return unit_say(u, FAILED, "%s", err.message);
    *over = hawser_sim_time(u->sim) < next - u->start;
    return outcome;
}

/* ------------------------------------------------------------------------------------------------------- values */

static const Variable *variable_of(Unit *u, size_t reference, VariableType type)
{
    if (reference >= (size_t)u->model.variables.n) {
        unit_say(u, FAILED, "there is no variable with the reference %zu", reference);
        return NULL;
    }
    const Variable *const row = &u->model.variables.row[reference];
    if (row->type == type) return row;
    unit_say(u, FAILED, "'%s' has another type than requested", row->name);
    return NULL;
}

Outcome unit_get(Unit *u, size_t reference, VariableType type, double *value, const char **text)
{
    const Variable *const row = variable_of(u, reference, type);
    if (!row) return FAILED;
    if (row->role == ROLE_TIME) *value = unit_time(u);
    if (row->role == ROLE_TIME) return GOES_WELL;
    if (row->role != ROLE_OUTPUT) *value = u->value[reference];
    if (row->role != ROLE_OUTPUT) return GOES_WELL;
    const Outcome outcome = u->phase == PHASE_INSTANTIATED
                                ? unit_say(u, FAILED, "'%s' has no value before the initialization", row->name)
                                : sim_ready(u);
    if (outcome) return outcome;
    if (type == VARIABLE_TEXT) {
        *text = output_text(u, row);
    } else {
        *value = output_number(u, row);
    }
    return GOES_WELL;
}

/* Checks whether a variable can have a value: a number in its range, or its start value. */
static int unit_can_be(const Variable *row, double value)
{
    if (!(value < row->start || value > row->start)) return isfinite(value);
    return isfinite(value) && !(value < row->least || value > row->most);
}

/* Rejects an impossible value; the value before stays. */
Outcome unit_set(Unit *u, size_t reference, VariableType type, double value)
{
    const Variable *const row = variable_of(u, reference, type);
    if (!row) return FAILED;
    const int early = u->phase == PHASE_INSTANTIATED || u->phase == PHASE_INITIALIZING;
    if (row->role == ROLE_TIME || row->role == ROLE_OUTPUT) return unit_say(u, FAILED, "'%s' cannot be set", row->name);
    if (row->role == ROLE_PARAMETER && !early)
        return unit_say(u, FAILED, "'%s' is fixed after the initialization", row->name);
    if (!unit_can_be(row, value))
        return unit_say(u, REFUSED, "'%s' cannot be %g: expected %g to %g", row->name, value, row->least, row->most);
    u->value[reference] = value;
    return GOES_WELL;
}

/* An instance's state as bytes: its phase, its values, and the simulation's checkpoint. */

/* Head before values and checkpoint; all of it is written, padding included. */
typedef struct StateHead {
    char token[TOKEN_SIZE + 3]; /* FMU of the state */
    int phase, variables;
    long rows;
    double start, stop;
    size_t checkpoint; /* its size in bytes; 0: the simulation is at its start, or does not exist */
} StateHead;

typedef struct UnitState {
    size_t size;
    unsigned char byte[]; /* [size] */
} UnitState;

static size_t values_size(const Unit *u) { return 2 * (size_t)u->model.variables.n * sizeof(double); }

static Outcome save(Unit *u, UnitState **state)
{
    hawser_error err = {HAWSER_OK, ""};
    void *checkpoint = NULL;
    StateHead head;
    memset(&head, 0, sizeof head);
    memcpy(head.token, u->model.token, TOKEN_SIZE);
    head.phase = (int)u->phase;
    head.variables = u->model.variables.n;
    head.rows = u->rows;
    head.start = u->start;
    head.stop = u->stop;
    if (u->phase & (PHASE_STEPPING | PHASE_OVER) && hawser_sim_save_memory(u->sim, &checkpoint, &head.checkpoint, &err))
        return unit_say(u, REFUSED, "%s", err.message);
    const size_t size = sizeof head + values_size(u) + head.checkpoint;
    UnitState *const made = malloc(sizeof *made + size);
    if (made) {
        made->size = size;
        memcpy(made->byte, &head, sizeof head);
        memcpy(made->byte + sizeof head, u->value, values_size(u)); /* the commands are behind them */
        if (checkpoint) memcpy(made->byte + sizeof head + values_size(u), checkpoint, head.checkpoint);
    }
    hawser_bytes_free(checkpoint);
    *state = made;
    return made ? GOES_WELL : unit_say(u, FAILED, "out of memory");
}

/* Checks that the bytes are of this FMU, and as many as the head states; *head is filled then. */
static int head_read(const Unit *u, const void *bytes, size_t size, StateHead *head)
{
    if (size < sizeof *head) return 0;
    memcpy(head, bytes, sizeof *head);
    return memcmp(head->token, u->model.token, TOKEN_SIZE) == 0 && head->variables == u->model.variables.n &&
           size - sizeof *head >= values_size(u) && size - sizeof *head - values_size(u) == head->checkpoint;
}

/* Checks that an instance can exist: steps need a simulation, times are numbers, samples have been counted. */
static int head_can_be(const StateHead *head)
{
    const int early = head->phase == PHASE_INSTANTIATED || head->phase == PHASE_INITIALIZING;
    const int late = head->phase == PHASE_STEPPING || head->phase == PHASE_OVER;
    return (early || late) && late == (head->checkpoint > 0) && head->rows >= 0 && isfinite(head->start) &&
           head->stop > head->start;
}

/* Checks that unit_set would accept all values behind the head, those set and those of commands. */
static int values_can_be(const Unit *u, const unsigned char *bytes)
{
    for (int i = 0; i < 2 * u->model.variables.n; ++i) {
        double value;
        memcpy(&value, bytes + (size_t)i * sizeof value, sizeof value);
        if (!unit_can_be(&u->model.variables.row[i % u->model.variables.n], value)) return 0;
    }
    return 1;
}

/* Checks all of a state; *head is filled then. */
static int state_read(const Unit *u, const void *bytes, size_t size, StateHead *head)
{
    return head_read(u, bytes, size, head) && head_can_be(head) &&
           values_can_be(u, (const unsigned char *)bytes + sizeof *head);
}

static Outcome load(Unit *u, const UnitState *state)
{
    hawser_error err = {HAWSER_OK, ""};
    StateHead head;
    if (!state_read(u, state->byte, state->size, &head)) return unit_say(u, FAILED, "this is no state of this FMU");
    memcpy(u->value, state->byte + sizeof head, values_size(u));
    Outcome outcome = unit_rebuild(u, head.checkpoint == 0);
    if (outcome) return outcome;
    if (head.checkpoint &&
        hawser_sim_load_memory(u->sim, state->byte + sizeof head + values_size(u), head.checkpoint, &err))
        return unit_say(u, FAILED, "%s", err.message);
    u->relaxed = head.checkpoint > 0;
    u->phase = (Phase)head.phase;
    u->rows = head.rows;
    u->start = head.start;
    u->stop = head.stop;
    u->look = (Look){0};
    return GOES_WELL;
}

/* Replaces *state, which may exist already, by the new one. */
static Outcome hand_over(Outcome outcome, UnitState *made, void **state)
{
    if (outcome) return outcome;
    free(*state);
    *state = made;
    return GOES_WELL;
}

Outcome state_get(const void *instance, void **state, const char *call)
{
    Unit *const u = unit_in(instance, PHASES_EARLY | PHASES_LATE, call);
    UnitState *made = NULL;
    if (!u || !state) return FAILED;
    const Outcome outcome = save(u, &made);
    return hand_over(outcome, made, state);
}

Outcome state_set(const void *instance, const void *state, const char *call)
{
    Unit *const u = unit_in(instance, PHASES_ALL, call);
    return u && state ? load(u, state) : FAILED;
}

Outcome state_free(const void *instance, void **state)
{
    if (!instance) return FAILED;
    if (state) free(*state);
    if (state) *state = NULL;
    return GOES_WELL;
}

Outcome state_size(const void *instance, const void *state, size_t *size)
{
    const UnitState *const s = state;
    if (!instance || !s || !size) return FAILED;
    *size = s->size;
    return GOES_WELL;
}

Outcome state_bytes(const void *instance, const void *state, void *to, size_t size)
{
    const UnitState *const s = state;
    if (!instance || !s || !to || size < s->size) return FAILED;
    memcpy(to, s->byte, s->size);
    return GOES_WELL;
}

Outcome state_of_bytes(const void *instance, const void *from, size_t size, void **state, const char *call)
{
    Unit *const u = unit_in(instance, PHASES_EARLY | PHASES_LATE, call);
    StateHead head;
    if (!u || !from || !state) return FAILED;
    if (!state_read(u, from, size, &head)) return unit_say(u, REFUSED, "these bytes are no state of this FMU");
    UnitState *const made = malloc(sizeof *made + size);
    if (!made) return unit_say(u, FAILED, "out of memory");
    made->size = size;
    memcpy(made->byte, from, size);
    return hand_over(GOES_WELL, made, state);
}
