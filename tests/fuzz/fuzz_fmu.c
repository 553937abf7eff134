/* Calls of FMI 2 and 3 on the library that goes into mock-up units, in any order: three instances, four states, a
 * serialised state whose bytes are changed. Every byte pair is a call. What is refused must say so; what goes well has
 * numbers. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fmi/fmi2.h"
#include "fmi/fmi3.h"
#include "fmi/model.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

static const char *const texts[] = {
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
    "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
    "rollers: {along: {from: 0 m, to: 6 m, spacing: 1 m}}\n"
    "drive: {winch: {speed: 0.5 m/s, to: 1 s, trip: {force: 3 kN, restarts: 1}}, tail: {tension: 1 kN, ramp: none}}\n"
    "limits: {pull: 20 kN}\n"
    "output: {interval: 50 ms}\n"
    "solver: {max_steps: 200}\n"
    "run: {duration: 2 s, steady_from: 0.5 s}\n",
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
    "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
    "rollers: {along: {from: 0 m, to: 6 m, spacing: 2 m, spin: {inertia: 0.1 kg m2}}}\n"
    "conveyors: [{name: c, from: 1 m, to: 3 m, clamp: 200 N, belt: {speed: 0.3 m/s}}]\n"
    "surfaces: {planes: [{name: ground, point: [0, 0, -50 mm], normal: [0, 0, 1]}]}\n"
    "drive: {winch: {tension: {force: 500 N, to: 300 ms, speed_limit: 0.5 m/s}}}\n"
    "solver: {max_steps: 200}\n"
    "run: {duration: 2 s}\n"};
enum { MODELS = sizeof texts / sizeof *texts, INSTANCES = 3, STATES = 4, CALLS_MAX = 60, STEPS_MAX = 12, PATH = 256 };

/* The cases as folders of resources, made once. */
static char base[PATH], folder[MODELS][PATH], address[MODELS][PATH + 16];
static Model model[MODELS];

static void base_remove(void)
{
    for (int m = 0; m < MODELS; ++m) {
        char path[2 * PATH];
        snprintf(path, sizeof path, "%.250s/%s", folder[m], MODEL_CASE);
        unlink(path);
        rmdir(folder[m]);
        model_clear(&model[m]);
    }
    rmdir(base);
}

static void base_make(void)
{
    const char *const tmp = getenv("TMPDIR");
    hawser_error err = {HAWSER_OK, ""};
    snprintf(base, sizeof base, "%.100s/hawser-fuzz-XXXXXX", tmp && *tmp ? tmp : "/tmp");
    FUZZ_MUST(mkdtemp(base));
    for (int m = 0; m < MODELS; ++m) {
        char path[2 * PATH];
        snprintf(folder[m], PATH, "%.200s/%d", base, m);
        snprintf(address[m], sizeof address[m], "file://%.250s", folder[m]);
        snprintf(path, sizeof path, "%.250s/%s", folder[m], MODEL_CASE);
        FUZZ_MUST(!mkdir(folder[m], 0777));
        FILE *const f = fopen(path, "w");
        FUZZ_MUST(f && fputs(texts[m], f) >= 0 && !fclose(f));
        if (model_load(folder[m], &model[m], NULL, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    }
    atexit(base_remove);
}

/* --------------------------------------------------------------------------------------------------- an instance */

typedef struct Held {
    void *c;
    int version, model, said; /* messages so far */
    int steps;
} Held;

typedef struct World {
    Draws d;
    Held held[INSTANCES];
    void *state[STATES];
    unsigned char *bytes; /* a state, serialised */
    size_t size;
} World;

static void hear(Held *h, const char *message)
{
    FUZZ_MUST(fuzz_error_is_good(1, message));
    ++h->said;
}
static void hear2(void *host, const char *name, fmi2Status status, const char *category, const char *format, ...)
{
    char text[2048];
    va_list list;
    (void)name, (void)status, (void)category;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    hear(host, text);
}
static void hear3(void *host, fmi3Status status, const char *category, const char *message)
{
    (void)status, (void)category;
    hear(host, message);
}

/* A call that both versions have alike. */
#define BOTH(h, NAME, ...)                                                                                             \
    ((h)->version == 2 ? (int)fmi2##NAME((h)->c __VA_OPT__(, ) __VA_ARGS__)                                            \
                       : (int)fmi3##NAME((h)->c __VA_OPT__(, ) __VA_ARGS__))

static void held_free(Held *h)
{
    if (h->c && h->version == 2) fmi2FreeInstance(h->c);
    if (h->c && h->version == 3) fmi3FreeInstance(h->c);
    h->c = NULL;
}

static void held_new(World *w, Held *h)
{
    const uint32_t how = draws_take(&w->d, 1);
    const int m = (int)(how >> 1) % MODELS;
    const char *const token = how % 32 == 31 ? "another" : model[m].token, *const name = how % 32 == 30 ? "" : "unit";
    const char *const at = how % 32 == 29 ? "http://there/else" : address[m];
    held_free(h);
    *h = (Held){.version = how & 1 ? 3 : 2, .model = m};
    const fmi2CallbackFunctions calls = {.logger = hear2, .componentEnvironment = h};
    h->c = h->version == 2
               ? fmi2Instantiate(name, fmi2CoSimulation, token, at, &calls, fmi2False, how >> 7 ? fmi2True : fmi2False)
               : fmi3InstantiateCoSimulation(name, token, how & 64 ? folder[m] : at, false, how >> 7, false, false,
                                             NULL, 0, h, hear3, NULL);
    FUZZ_MUST(h->c || h->said > 0);
}

/* What a call has answered: what went wrong has been said, or the call is one of those that only answer. */
static void judge(const Held *h, int said_before, int status)
{
    FUZZ_MUST(status >= fmi2OK && status <= fmi2Error);
    if (status == fmi2Error || status == fmi2Discard) FUZZ_MUST(h->said > said_before);
}

/* --------------------------------------------------------------------------------------------------------- calls */

static const double numbers[] = {0,         1,           -1,  0.5, 0.1,   1e-9, 1e9,  1e300,  -1e300, INFINITY,
                                 -INFINITY, (double)NAN, 1e5, 2,   0.001, 100,  20e3, 1e-300, 5,      0.25};
static double number(World *w)
{
    const uint32_t k = draws_take(&w->d, 1);
    return k < 200 ? numbers[k % (sizeof numbers / sizeof *numbers)] : (double)(int32_t)draws_take(&w->d, 4) * 1e-6;
}

static void call_life(World *w, Held *h, int what)
{
    const int before = h->said;
    const double start = what == 0 ? number(w) : 0, stop = what == 0 ? number(w) : 0;
    const int has_stop = what == 0 && draws_take(&w->d, 1) & 1;
    int status = fmi2OK;
    if (what <= 1 && h->version == 2) status = (int)fmi2SetupExperiment(h->c, fmi2True, 1e-3, start, has_stop, stop);
    if (what <= 1 && status == fmi2OK)
        status = h->version == 2 ? (int)fmi2EnterInitializationMode(h->c)
                                 : (int)fmi3EnterInitializationMode(h->c, true, 1e-3, start, has_stop, stop);
    if (what == 1 && status == fmi2OK) status = BOTH(h, ExitInitializationMode);
    if (what == 2) status = BOTH(h, ExitInitializationMode);
    if (what == 3) status = BOTH(h, Terminate);
    if (what == 4) status = BOTH(h, Reset);
    judge(h, before, status);
}

/* Where the instance is, on by a little; or from anywhere, by anything. */
static void call_step(World *w, Held *h)
{
    const int before = h->said;
    const uint32_t how = draws_take(&w->d, 1);
    const unsigned at = 0;
    double now = 0, step = 0.01 * (1 + how % 32), reached;
    bool event, over, early;
    if (h->steps++ > STEPS_MAX) return;
    const int there =
        h->version == 2 ? (int)fmi2GetReal(h->c, &at, 1, &now) : (int)fmi3GetFloat64(h->c, &at, 1, &now, 1);
    if (there == fmi2OK) FUZZ_MUST(isfinite(now));
    if (how >= 224) now = number(w), step = number(w);
    if (!(step <= 2)) step = how & 1 ? step : 0.1; /* the case's max_steps bounds what is longer */
    const int status = h->version == 2 ? (int)fmi2DoStep(h->c, now, step, fmi2True)
                                       : (int)fmi3DoStep(h->c, now, step, true, &event, &over, &early, &reached);
    FUZZ_MUST(status <= fmi2Error);
    if (status == fmi2Error) FUZZ_MUST(h->said > before);
    if (h->version == 3 && status == fmi3OK) FUZZ_MUST(isfinite(reached) && !event && !early);
}

/* Margins and the mean of what was not judged or has not begun are NaN, and some outputs say when they are; the others
 * of what is now are numbers. */
static int must_be_a_number(const Variable *row)
{
    const int now = row->from == FROM_SAMPLE || row->from == FROM_ROLLER || row->from == FROM_NORMAL ||
                    row->from == FROM_FRICTION || row->from == FROM_LINE_LOAD;
    return row->role != ROLE_OUTPUT || (now && !strstr(row->description, "NaN"));
}

static void call_get(Held *h, unsigned reference)
{
    const int n = model[h->model].variables.n, before = h->said;
    const Variable *const row = reference < (unsigned)n ? &model[h->model].variables.row[reference] : NULL;
    const VariableType type = row ? row->type : VARIABLE_REAL;
    double real = 0;
    int whole = 0;
    int64_t choice = 0;
    bool on = false;
    const char *text = NULL;
    int status;
    if (type == VARIABLE_REAL)
        status = h->version == 2 ? (int)fmi2GetReal(h->c, &reference, 1, &real)
                                 : (int)fmi3GetFloat64(h->c, &reference, 1, &real, 1);
    else if (type == VARIABLE_VERDICT && h->version == 3)
        status = (int)fmi3GetInt64(h->c, &reference, 1, &choice, 1);
    else if (type == VARIABLE_BOOLEAN)
        status = h->version == 2 ? (int)fmi2GetBoolean(h->c, &reference, 1, &whole)
                                 : (int)fmi3GetBoolean(h->c, &reference, 1, &on, 1);
    else if (type == VARIABLE_TEXT)
        status = h->version == 2 ? (int)fmi2GetString(h->c, &reference, 1, &text)
                                 : (int)fmi3GetString(h->c, &reference, 1, &text, 1);
    else
        status = h->version == 2 ? (int)fmi2GetInteger(h->c, &reference, 1, &whole)
                                 : (int)fmi3GetInt32(h->c, &reference, 1, &whole, 1);
    judge(h, before, status);
    if (status == fmi2OK) FUZZ_MUST(row && (type != VARIABLE_TEXT || text));
    if (status == fmi2OK && type == VARIABLE_REAL && must_be_a_number(row) && !isfinite(real))
        fuzz_failed(row->name, __FILE__, __LINE__);
}

/* A parameter is another simulation, of which a chain of a million segments takes long. */
static int may_be_set(const Variable *row)
{
    return row->role != ROLE_PARAMETER || !(strstr(row->name, "segment") || strstr(row->name, "length") ||
                                            strstr(row->name, "spacing") || strstr(row->name, "straight"));
}

static void call_set(World *w, Held *h, unsigned reference)
{
    const int n = model[h->model].variables.n, before = h->said;
    const Variable *const row = reference < (unsigned)n ? &model[h->model].variables.row[reference] : NULL;
    const double value = number(w);
    const int whole = value > 0;
    const bool on = value > 0;
    int status;
    if (row && !may_be_set(row)) return;
    if (row && row->type == VARIABLE_BOOLEAN)
        status = h->version == 2 ? (int)fmi2SetBoolean(h->c, &reference, 1, &whole)
                                 : (int)fmi3SetBoolean(h->c, &reference, 1, &on, 1);
    else
        status = h->version == 2 ? (int)fmi2SetReal(h->c, &reference, 1, &value)
                                 : (int)fmi3SetFloat64(h->c, &reference, 1, &value, 1);
    judge(h, before, status);
    if (status == fmi2OK && row->type == VARIABLE_REAL) FUZZ_MUST(isfinite(value));
}

/* All that there is to read. */
static void call_look(Held *h)
{
    fmi2Status last;
    double t;
    for (unsigned r = 0; r < (unsigned)model[h->model].variables.n; ++r) call_get(h, r);
    if (h->version == 2 && fmi2GetStatus(h->c, fmi2DoStepStatus, &last) == fmi2OK) FUZZ_MUST(last <= fmi2Error);
    if (h->version == 2 && fmi2GetRealStatus(h->c, fmi2LastSuccessfulTime, &t) == fmi2OK) FUZZ_MUST(isfinite(t));
}

/* -------------------------------------------------------------------------------------------------------- states */

static void call_bytes(World *w, Held *h, void **state)
{
    size_t size = 0;
    if (h->version == 2) FUZZ_MUST(fmi2SerializedFMUstateSize(h->c, *state, &size) == fmi2OK);
    if (h->version == 3) FUZZ_MUST(fmi3SerializedFMUStateSize(h->c, *state, &size) == fmi3OK);
    FUZZ_MUST(size > 0);
    free(w->bytes);
    w->bytes = malloc(size);
    w->size = size;
    FUZZ_MUST(w->bytes);
    if (h->version == 2) FUZZ_MUST(fmi2SerializeFMUstate(h->c, *state, (fmi2Byte *)w->bytes, size) == fmi2OK);
    if (h->version == 3) FUZZ_MUST(fmi3SerializeFMUState(h->c, *state, w->bytes, size) == fmi3OK);
}

static void call_change(World *w)
{
    for (uint32_t n = 1 + draws_take(&w->d, 1) % 3; n > 0 && w->bytes; --n) {
        const uint32_t how = draws_take(&w->d, 1), at = draws_take(&w->d, 2);
        if (how % 16 == 15)
            w->size = at % (w->size + 1); /* cut off */
        else if (w->size > 0)             /* most of them before the checkpoint, which has a sum */
            patch_number(&w->d, w->bytes, w->size, how % 2 ? 40 + at % 48 : at % (how % 4 ? 700 : w->size) % w->size);
        if (w->size == 0) w->size = 1;
    }
}

static void call_state(World *w, Held *h, int what)
{
    const int k = (int)(draws_take(&w->d, 1) % STATES), before = h->said;
    void **const state = &w->state[k];
    int status = fmi2OK;
    switch (what) {
    case 0:
        status = h->version == 2 ? (int)fmi2GetFMUstate(h->c, state) : (int)fmi3GetFMUState(h->c, state);
        break;
    case 1: /* perhaps another instance's */
        if (*state) status = h->version == 2 ? (int)fmi2SetFMUstate(h->c, *state) : (int)fmi3SetFMUState(h->c, *state);
        break;
    case 2:
        status = h->version == 2 ? (int)fmi2FreeFMUstate(h->c, state) : (int)fmi3FreeFMUState(h->c, state);
        FUZZ_MUST(status == fmi2OK && !*state);
        break;
    case 3:
        if (*state) call_bytes(w, h, state);
        break;
    case 4:
        call_change(w);
        break;
    default:
        if (!w->bytes) return;
        status = h->version == 2 ? (int)fmi2DeSerializeFMUstate(h->c, (const fmi2Byte *)w->bytes, w->size, state)
                                 : (int)fmi3DeserializeFMUState(h->c, w->bytes, w->size, state);
        if (status == fmi2OK)
            status = h->version == 2 ? (int)fmi2SetFMUstate(h->c, *state) : (int)fmi3SetFMUState(h->c, *state);
    }
    judge(h, before, status);
}

/* ---------------------------------------------------------------------------------------------------------- order */

static void call(World *w)
{
    const uint32_t what = draws_take(&w->d, 1);
    Held *const h = &w->held[what % INSTANCES];
    const uint32_t kind = what / INSTANCES % 21;
    if (!h->c) {
        held_new(w, h);
    } else if (kind < 5) {
        call_life(w, h, (int)kind);
    } else if (kind < 9) {
        call_step(w, h);
    } else if (kind < 12) {
        call_set(w, h, draws_take(&w->d, 1));
    } else if (kind == 12) {
        call_get(h, draws_take(&w->d, 2));
    } else if (kind == 13) {
        call_look(h);
    } else if (kind < 20) {
        call_state(w, h, (int)kind - 14);
    } else {
        held_new(w, h);
    }
}

FUZZ_TARGET(fmu)
{
    World w = {.d = {data, size}};
    if (!*base) base_make();
    for (int k = 0; k < CALLS_MAX && w.d.left > 0; ++k) call(&w);
    for (int k = 0; k < STATES; ++k) free(w.state[k]); /* as bytes without an instance: the unit has nothing of them */
    for (int k = 0; k < INSTANCES; ++k) held_free(&w.held[k]);
    free(w.bytes);
    return 0;
}
