/* Calls of the public interface in any order that its comments allow: every byte is a call. */
#include <math.h>
#include <stdlib.h>

#include "hawser/hawser.h"
#include "tests/fuzz/fuzz.h"

enum { HANDLES = 2, CALLS_MAX = 200 };

static const char *const texts[] = {
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
    "route: {head_at: 6 m, pieces: [{straight: 8 m}]}\n"
    "rollers: {along: {from: 0 m, to: 8 m, spacing: 2 m}}\n"
    "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 1 kN, ramp: none}}\n"
    "limits: {pull: 20 kN}\n"
    "solver: {max_steps: 300}\n"
    "run: {duration: 2 s}\n",
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
    "rod: {tail: {clamp: true}, loads: [{at: 6 m, force: [0, 0, -100]}]}\n"
    "run: {analysis: static}\n",
    /* in space, with all that can be told something */
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
    "route: {head_at: 6 m, pieces: [{straight: 8 m}]}\n"
    "rollers: {along: {from: 0 m, to: 8 m, spacing: 2 m, spin: {inertia: 0.1 kg m2}}}\n"
    "conveyors: [{name: c, from: 1 m, to: 4 m, clamp: 200 N}]\n"
    "surfaces: {planes: [{name: ground, point: [0, 0, -100 mm], normal: [0, 0, 1]}]}\n"
    "drive: {winch: {speed: 0.5 m/s, to: 1 s, trip: {force: 3 kN, restarts: 1}}}\n"
    "solver: {max_steps: 300}\n"
    "run: {duration: 2 s}\n",
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
    "route: {head_at: 6 m, pieces: [{straight: 8 m}]}\n"
    "rollers: {along: {from: 0 m, to: 8 m, spacing: 2 m}}\n"
    "drive: {winch: {tension: {force: 500 N, to: 300 ms, speed_limit: 0.5 m/s}}}\n"
    "solver: {max_steps: 300}\n"
    "run: {duration: 2 s, steady_from: 1 s}\n"};
enum { TEXTS = sizeof texts / sizeof *texts };

typedef struct Pair {
    hawser_case *c;
    hawser_sim *sim;
} Pair;

static void call_case(Pair *p, int what, int argument, hawser_error *err)
{
    static const char *const keys[] = {"run.duration", "chain.0.segment", "drive.winch.speed", "solver.accuracy",
                                       "bogus"};
    static const char *const values[] = {"1 s", "0.5 m", "-1", "0.05", "{}"};
    static const hawser_format formats[] = {HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV};
    char *text = NULL;
    switch (what) {
    case 0:
        hawser_case_free(p->c);
        p->c = NULL;
        (void)hawser_case_parse(texts[argument % TEXTS], "api.yaml", &p->c, err);
        return;
    case 1:
        if (p->c) (void)hawser_case_set(p->c, keys[argument % 5], values[argument / 5 % 5], err);
        return;
    case 2:
        if (p->c) (void)hawser_case_check(p->c, err);
        return;
    case 3:
        if (p->c) (void)hawser_case_describe(p->c, formats[argument % 3], &text, err);
        break;
    case 4:
        if (p->c) (void)hawser_case_theory(p->c, formats[argument % 3], &text, err);
        break;
    default:
        hawser_sim_free(p->sim);
        p->sim = NULL;
        if (p->c) (void)hawser_sim_new(p->c, argument % 2 ? NULL : &(hawser_options){.threads = 1}, &p->sim, err);
    }
    hawser_text_free(text);
}

static void call_motion(hawser_sim *sim, int what, int argument, hawser_error *err)
{
    hawser_relaxation relaxation;
    switch (what) {
    case 0:
        (void)hawser_sim_relax(sim, &relaxation, err);
        break;
    case 1:
        (void)hawser_sim_advance(sim, hawser_sim_time(sim) + 0.01 * argument, 1, err);
        break;
    case 2:
        (void)hawser_sim_advance(sim, hawser_sim_time(sim) + 0.001 * argument, 0, err);
        break;
    case 3:
        FUZZ_MUST(hawser_sim_sample(sim));
        break;
    default:
        hawser_sim_record(sim);
    }
}

/* Any command, any number: what is refused must leave a message. */
static void call_control(hawser_sim *sim, int what, int argument, hawser_error *err)
{
    static const double values[] = {0, 0.1, -0.5, 3, 2e3, 1e9, 1e300, -1e300, (double)INFINITY, (double)NAN};
    static const char *const names[] = {NULL, "", "P1", "P3", "c", "nobody"};
    static const double ramps[] = {0, 0.01, 0.3, -1, (double)NAN, 1e-9};
    const double value = values[argument % 10];
    const hawser_force force = {.force_N = {value, 10, -20}, .arm_m = {0.1, 0, 0}, .follows = argument & 1};
    hawser_status status;
    if (what < 13) {
        status =
            hawser_sim_control(sim, (hawser_control)what, names[argument % 6], value, ramps[argument / 6 % 6], err);
    } else {
        status = hawser_sim_force(sim, argument % 9 - 1, argument % 5 ? &force : NULL, ramps[argument / 6 % 6], err);
    }
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err->message));
}

/* A law that now and then answers with nonsense or asks for an end. */
static int law(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    const int kind = *(const int *)user;
    (void)by_place, (void)by_motion;
    for (int c = 0; c < 3; ++c) wrench[c] = -20 * at->velocity_m_per_s[c];
    if (kind % 16 == 3) wrench[1] = (double)NAN;
    return kind % 16 == 5 && at->t > 0.2;
}

/* A call-back that looks, tells, and sometimes wants an end. */
static int step(void *user, hawser_sim *sim, double t)
{
    const int kind = *(const int *)user;
    hawser_error err = {0};
    FUZZ_MUST(hawser_sim_advance(sim, t + 1, 0, &err) == HAWSER_ERR_INPUT);
    if (kind % 8 == 1) (void)hawser_sim_control(sim, HAWSER_WINCH_SPEED, NULL, 0.2, 0.1, &err);
    return kind % 32 == 7;
}

static void call_close(hawser_sim *sim, int what, int *argument, hawser_error *err)
{
    const hawser_contact *contact;
    const hawser_cable_point *joint;
    const hawser_geometry *geometry;
    hawser_envelope envelope;
    hawser_route_place place;
    int n = 0, first;
    switch (what) {
    case 0:
        if (!hawser_sim_contacts(sim, &contact, &n, err)) FUZZ_MUST(n >= 0 && (n == 0 || contact[n - 1].normal_N > 0));
        break;
    case 1:
        if (!hawser_sim_cable(sim, &joint, &n, &first, err)) FUZZ_MUST(n > 1 && first >= 0);
        break;
    case 2:
        if (!hawser_sim_geometry(sim, &geometry, err)) FUZZ_MUST(geometry->segments > 0);
        break;
    case 3:
        (void)hawser_sim_route_at(sim, *argument - 100.0, &place, err);
        break;
    case 4:
        (void)(*argument & 1 ? hawser_sim_watch_envelope(sim, err) : hawser_sim_envelope(sim, 1, &envelope, err));
        break;
    case 5:
        (void)hawser_sim_set_law(sim, *argument % 7 - 1, *argument / 7 % 9, *argument % 3 ? law : NULL, 0, argument,
                                 err);
        break;
    default:
        hawser_sim_on_step(sim, *argument % 3 ? step : NULL, argument);
    }
}

static void call_looks(hawser_sim *sim, int what, hawser_error *err)
{
    const hawser_machine *machine;
    const hawser_mode *mode;
    const hawser_event *event;
    const hawser_position *position;
    const hawser_station *station;
    const hawser_roller *roller;
    const hawser_surface *surface;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_summary summary;
    char *text = NULL;
    switch (what) {
    case 0:
        FUZZ_MUST(hawser_sim_machines(sim, &machine) >= 0 && hawser_sim_modes(sim, &mode) >= 0);
        break;
    case 1:
        FUZZ_MUST(hawser_sim_events(sim, &event) >= 0 && hawser_sim_positions(sim, &position) >= 0);
        break;
    case 2:
        FUZZ_MUST(hawser_sim_stations(sim, &station) >= 0 && hawser_sim_rollers(sim, &roller) >= 0);
        break;
    case 3:
        FUZZ_MUST(hawser_sim_surfaces(sim, &surface) >= 0 && hawser_sim_limits(sim, limit) >= 0);
        break;
    case 4:
        hawser_sim_summary(sim, &summary);
        break;
    default:
        (void)hawser_sim_summary_json(sim, &text, err);
        hawser_text_free(text);
    }
}

FUZZ_TARGET(api)
{
    Pair pair[HANDLES] = {{0}};
    int arguments[CALLS_MAX]; /* those that call-backs are given live as long as the handles */
    for (size_t k = 0; k + 1 < size && k < 2 * CALLS_MAX; k += 2) {
        hawser_error err = {0};
        Pair *const p = &pair[data[k] & 1];
        const int what = data[k] >> 1 & 63, argument = arguments[k / 2] = data[k + 1];
        if (what < 8)
            call_case(p, what, argument, &err);
        else if (p->sim && what < 20)
            call_motion(p->sim, what % 5, argument, &err);
        else if (p->sim && what < 28)
            call_looks(p->sim, what % 6, &err);
        else if (p->sim && what < 50)
            call_control(p->sim, what % 16, argument, &err);
        else if (p->sim)
            call_close(p->sim, what % 7, &arguments[k / 2], &err);
    }
    for (int k = 0; k < HANDLES; ++k) {
        hawser_sim_free(pair[k].sim);
        hawser_case_free(pair[k].c);
    }
    return 0;
}
