/* What the search for contact candidates costs, and what the candidates save: a straight row of N segments over R
 * rollers, evenly spread. Prints a Markdown table: candidates, contacts, and the time of a refresh, of the question
 * whether one is due, and of the contact forces with the case's reach and with one that makes every pair a candidate.
 * Usage: bench_candidates [REPETITIONS]     (least times of so many; default 30) */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/straight_scene.h"
#include "core/machine.h"
#include "sim/dynamics.h"
#include "tests/sim/room_fixture.h"

static const double REACH = 1, EVERYTHING = 1e9; /* m */

typedef struct Bench {
    Scene scene;
    Workspace ws;
    double *y;
} Bench;

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_candidates: %s\n", what);
    exit(1);
}

/* Keeps `rollers` of the scene's rollers, evenly spread; where there are fewer, doubles stand beside each other. */
static void rollers_keep(SceneDef *def, int rollers)
{
    RollerDef *const kept = malloc(((size_t)rollers + 1) * sizeof *kept);
    check(kept != NULL, "no memory");
    for (int r = 0; r < rollers; ++r) {
        kept[r] = def->rollers[(long)r * def->n_rollers / rollers];
        kept[r].centre.y += 1e-3 * (r % 7);
    }
    free(def->rollers);
    def->rollers = kept;
    def->n_rollers = rollers;
}

static void bench_new(Bench *b, int segments, int rollers, double reach)
{
    SceneDef def;
    hawser_error err = {0};
    memset(b, 0, sizeof *b);
    check(straight_scene(&def, segments), "no memory");
    rollers_keep(&def, rollers);
    def.contact_reach = reach;
    check(scene_build(&def, &b->scene, &err) == HAWSER_OK, err.message);
    scene_def_clear(&def);
    b->y = calloc((size_t)scene_state_size(&b->scene), sizeof *b->y);
    check(b->y && workspace_alloc(&b->ws, &b->scene, NULL), "no memory");
    scene_initial_state(&b->scene, b->y);
    for (int i = 0; i < segments; ++i) b->y[2 * segments + i] -= 1e-4; /* so that every roller within reach pushes */
    check(dynamics_refresh(&b->scene, &b->ws, 0, b->y, 1, &err) == HAWSER_OK, err.message);
}

static void bench_free(Bench *b)
{
    free(b->y);
    workspace_free(&b->ws);
    scene_clear(&b->scene);
}

static void refresh(Bench *b) { dynamics_refresh(&b->scene, &b->ws, 0, b->y, 1, NULL); }
static void question(Bench *b) { dynamics_refresh(&b->scene, &b->ws, 0, b->y, 0, NULL); }
static void forces(Bench *b) { room_look(&ROLLERS_ROOM, &b->scene, &b->ws); }

/* Least time of a call, us. */
static double least(Bench *b, void (*call)(Bench *b), int repetitions)
{
    double best = 1e9;
    for (int k = 0; k < repetitions; ++k) {
        const double start = clock_now();
        call(b);
        best = fmin(best, clock_now() - start);
    }
    return 1e6 * best;
}

static void row_print(int segments, int rollers, int repetitions)
{
    Bench b;
    bench_new(&b, segments, rollers, REACH);
    const double search = least(&b, refresh, repetitions), ask = least(&b, question, repetitions);
    const double push = least(&b, forces, repetitions);
    const int candidates = dynamics_candidates(&b.ws), active = room_look(&ROLLERS_ROOM, &b.scene, &b.ws);
    bench_free(&b);
    bench_new(&b, segments, rollers, EVERYTHING);
    const double all = least(&b, forces, repetitions < 3 ? repetitions : 3);
    check(room_look(&ROLLERS_ROOM, &b.scene, &b.ws) == active, "the reach has changed the contacts");
    printf("| %d | %d | %d | %d | %.1f | %.1f | %.1f | %d | %.1f |\n", segments, rollers, candidates, active, search,
           ask, push, dynamics_candidates(&b.ws), all);
    bench_free(&b);
}

int main(int argc, char **argv)
{
    const int segments[] = {370, 1000, 2000, 5000, 20000}, rollers[] = {0, 98, 500, 2000};
    const int repetitions = argc > 1 ? atoi(argv[1]) : 30;
    check(repetitions > 0, "repetitions must be a number above 0");
    printf("| N | rollers | candidates | contacts | refresh us | question us | forces us | all pairs | forces us |\n"
           "|---|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof segments / sizeof *segments; ++i) {
        for (size_t k = 0; k < sizeof rollers / sizeof *rollers; ++k) row_print(segments[i], rollers[k], repetitions);
    }
    return 0;
}
