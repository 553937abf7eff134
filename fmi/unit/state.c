/* An instance's state as bytes: where it is in its life, its values, and the simulation's checkpoint. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fmi/unit/unit.h"

/* What stands before values and checkpoint; all of it is written, padding included. */
typedef struct StateHead {
    char token[TOKEN_SIZE + 3]; /* whose state it is */
    int phase, variables;
    long rows;
    double start, stop;
    size_t checkpoint; /* bytes of it; 0: the simulation stands at the start, or is not there */
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
        memcpy(made->byte + sizeof head, u->value, values_size(u)); /* what was told stands behind them */
        if (checkpoint) memcpy(made->byte + sizeof head + values_size(u), checkpoint, head.checkpoint);
    }
    hawser_bytes_free(checkpoint);
    *state = made;
    return made ? GOES_WELL : unit_say(u, FAILED, "out of memory");
}

/* Whether the bytes are of this FMU, and as many as they say; *head is filled then. */
static int head_read(const Unit *u, const void *bytes, size_t size, StateHead *head)
{
    if (size < sizeof *head) return 0;
    memcpy(head, bytes, sizeof *head);
    return memcmp(head->token, u->model.token, TOKEN_SIZE) == 0 && head->variables == u->model.variables.n &&
           size - sizeof *head >= values_size(u) && size - sizeof *head - values_size(u) == head->checkpoint;
}

/* Whether an instance can be there: a simulation goes with steps, times are numbers, samples have been counted. */
static int head_can_be(const StateHead *head)
{
    const int early = head->phase == PHASE_INSTANTIATED || head->phase == PHASE_INITIALIZING;
    const int late = head->phase == PHASE_STEPPING || head->phase == PHASE_OVER;
    return (early || late) && late == (head->checkpoint > 0) && head->rows >= 0 && isfinite(head->start) &&
           head->stop > head->start;
}

/* Whether all values behind the head, those set and those told, are such as unit_set takes. */
static int values_can_be(const Unit *u, const unsigned char *bytes)
{
    for (int i = 0; i < 2 * u->model.variables.n; ++i) {
        double value;
        memcpy(&value, bytes + (size_t)i * sizeof value, sizeof value);
        if (!unit_can_be(&u->model.variables.row[i % u->model.variables.n], value)) return 0;
    }
    return 1;
}

/* All of this of a state; *head is filled then. */
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

/* *state, which may be there already, becomes what was made. */
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
