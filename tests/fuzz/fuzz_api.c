/* Calls of the public interface in any order that its comments allow: every byte is a call. */
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
    "run: {duration: 2 s}\n",
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 6 m, segment: 1 m}]\n"
    "rod: {tail: {clamp: true}, loads: [{at: 6 m, force: [0, 0, -100]}]}\n"
    "run: {analysis: static}\n"};

typedef struct Pair {
    hawser_case *c;
    hawser_sim *sim;
} Pair;

static void call_case(Pair *p, int what, int argument, hawser_error *err)
{
    static const char *const keys[] = {"run.duration", "chain.0.segment", "drive.winch.speed", "solver.accuracy",
                                       "bogus"};
    static const char *const values[] = {"1 s", "0.5 m", "-1", "1e-4", "{}"};
    static const hawser_format formats[] = {HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV};
    char *text = NULL;
    switch (what) {
    case 0:
        hawser_case_free(p->c);
        p->c = NULL;
        (void)hawser_case_parse(texts[argument % 2], "api.yaml", &p->c, err);
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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Pair pair[HANDLES] = {{0}};
    for (size_t k = 0; k + 1 < size && k < 2 * CALLS_MAX; k += 2) {
        hawser_error err = {0};
        Pair *const p = &pair[data[k] & 1];
        const int what = data[k] >> 1 & 31, argument = data[k + 1];
        if (what < 8)
            call_case(p, what, argument, &err);
        else if (p->sim && what < 20)
            call_motion(p->sim, what % 5, argument, &err);
        else if (p->sim)
            call_looks(p->sim, what % 6, &err);
    }
    for (int k = 0; k < HANDLES; ++k) {
        hawser_sim_free(pair[k].sim);
        hawser_case_free(pair[k].c);
    }
    return 0;
}
