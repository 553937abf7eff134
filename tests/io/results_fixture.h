/* A made-up chain on a made-up pull, and a scratch folder for what is written about it. */
#ifndef HAWSER_TESTS_RESULTS_FIXTURE_H
#define HAWSER_TESTS_RESULTS_FIXTURE_H

#include "io/results/results.h"
#include "tests/support/scratch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { N = 5, R = 2 };

static const hawser_roller fixture_rollers[R] = {{"entry, left", 0.5, 160e3, 100, 200, 320, NAN, NAN, NAN, 2, 5},
                                                 {"P2", NAN, 0, 0, 0, 10, 1.5, NAN, NAN, 0, 1}};
static const hawser_station fixture_stations[3] = {{"A", 0, 1000, 1010, 1020, 1500, 1, 15},
                                                   {"say \"B\"", 2, 2000, 2020, 1980, 2500, 2, 25},
                                                   {"C", 4, 0, 0, NAN, NAN, NAN, NAN}};
static const int fixture_watched[2] = {0, 4};

static const int fixture_loads[2] = {1, 0};

static const ResultsDef fixture_def = {.title = "A title",
                                       .segments = N,
                                       .rollers = R,
                                       .roller = fixture_rollers,
                                       .n_watched = 2,
                                       .watched = fixture_watched,
                                       .states = 1,
                                       .n_loads = 2,
                                       .loads = fixture_loads};

typedef struct Fixture {
    char dir[64];
    double position[3 * N], quaternion[4 * N], velocity[3 * N], omega[3 * N], tension[N + 1], axial_speed[N], load[R];
    double curvature[N + 1], sidewall[N + 1], contact[N], force[3 * R];
    hawser_sample sample;
} Fixture;

/* Numbers that tell state, array and index apart, so that a mix-up shows. */
static void fixture_sample(Fixture *f, int k)
{
    for (int i = 0; i < 3 * N; i++) {
        f->position[i] = 1000 * k + i + 0.25;
        f->velocity[i] = -1000 * k - i;
        f->omega[i] = 1e-3 * (100 * k + i);
    }
    for (int i = 0; i < 4 * N; i++) f->quaternion[i] = k + 0.01 * i;
    for (int i = 0; i <= N; i++) f->tension[i] = 100 * k + i + 0.5;
    for (int i = 0; i < N; i++) f->axial_speed[i] = k + 0.125 * i;
    for (int i = 0; i < R; i++) f->load[i] = 10 * k + i;
    for (int i = 0; i <= N; i++) f->curvature[i] = 0.25 * k + 0.125 * i; /* single precision holds these */
    for (int i = 0; i <= N; i++) f->sidewall[i] = 8 * k + i;
    for (int i = 0; i < N; i++) f->contact[i] = 16 * k + 2 * i;
    for (int i = 0; i < 3 * R; i++) f->force[i] = 100 * k - i;
    f->sample.head_at = 40 + k;
    f->sample.t = 0.1 * k;
    f->sample.winch_force = 7000 + k;
    f->sample.tail_tension = 50 + k;
    f->sample.max_tension = 9000 + k;
}

static int fixture_new(void **state)
{
    Fixture *f = calloc(1, sizeof *f);
    strcpy(f->dir, "/tmp/hawser_results_XXXXXX");
    if (!mkdtemp(f->dir)) return -1;
    f->sample = (hawser_sample){.segments = N,
                                .joints = N + 1,
                                .rollers = R,
                                .winch_speed = 0.1,
                                .winch_travel = 0.75,
                                .max_tension_joint = 3,
                                .active_contacts = 17,
                                .step_size = 0.0125,
                                .position = f->position,
                                .quaternion = f->quaternion,
                                .velocity = f->velocity,
                                .omega = f->omega,
                                .tension = f->tension,
                                .axial_speed = f->axial_speed,
                                .roller_load = f->load,
                                .field = {f->curvature, f->sidewall, f->contact, f->force}};
    fixture_sample(f, 0);
    *state = f;
    return 0;
}

static int fixture_free(void **state)
{
    Fixture *f = *state;
    folder_remove(f->dir);
    free(f);
    return 0;
}

/* Path of a file in the scratch folder; overwritten by the next call. */
static inline const char *fixture_path(const Fixture *f, const char *name)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", f->dir, name);
    return path;
}

/* Everything in a file as text; the caller frees it. */
static inline char *read_text(const char *path)
{
    FILE *f = fopen(path, "r");
    if (!f) return NULL;
    char *text = calloc(1, 1 << 20);
    const size_t n = fread(text, 1, (1 << 20) - 1, f);
    text[n] = 0;
    fclose(f);
    return text;
}

/* Finishes with the fixture's tables. */
static inline hawser_status fixture_finish(Results *r, hawser_error *err)
{
    const ResultsTables tables = {3, fixture_stations, R, fixture_rollers, 0, N, NULL, NULL, 0, NULL, NULL};
    const hawser_status status = results_finish(r, &tables, err);
    const hawser_status told = results_summary(r, "{\"outcome\": \"finished\"}\n", !status, status ? NULL : err);
    return status ? status : told;
}

#endif
