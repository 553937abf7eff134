/* What contact with a mesh costs: a straight row of 370 segments on rollers in a tunnel of 190 m of about N triangles,
 * of which nothing is near the cable, and with a tray of N triangles in which all of it lies. Prints Markdown rows.
 * Usage: bench_environment_contact [REPETITIONS]     least times of so many; default 30
 *        bench_environment_contact count N           for callgrind --toggle-collect=measured: N 0: no environment */
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/straight_scene.h"
#include "core/machine.h"
#include "sim/dynamics.h"
#include "tests/sim/room_fixture.h"

static const double LENGTH = 190, DEPTH = 1e-4; /* m; of the cable in the tray */

typedef struct Bench {
    Scene scene;
    Workspace ws;
    double *y, *ydot;
} Bench;

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_environment_contact: %s\n", what);
    exit(1);
}

/* A strip of cells around the arc from `first` to `last` (rad) of a circle about (y, z) = (0, up), over the length. */
static void arc_add(MeshBuild *m, double radius, double up, double first, double last, int rows, int columns)
{
    const int layer = mesh_add_layer(m, "all");
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            int corner[4];
            for (int k = 0; k < 4; ++k) {
                const double angle =
                    first +
                    (last - first) * ((j + k % 2) % columns + (last < 6 && j + k % 2 == columns) * columns) / columns;
                const double at[3] = {LENGTH * (i + k / 2) / rows - 2, radius * cos(angle), up + radius * sin(angle)};
                corner[k] = mesh_add_vertex(m, at);
            }
            check(mesh_add_triangle(m, corner[0], corner[2], corner[3], layer) >= 0, "no memory");
            check(mesh_add_triangle(m, corner[0], corner[3], corner[1], layer) >= 0, "no memory");
        }
    }
}

/* About n triangles with cells as long as wide. */
static void cells_add(MeshBuild *m, double radius, double up, double first, double last, int n)
{
    const double width = radius * (last - first), cell = sqrt(2 * LENGTH * width / n);
    const int columns = (int)fmax(8, width / cell), rows = n / 2 / columns;
    arc_add(m, radius, up, first, last, rows, columns);
}

static void bench_new(Bench *b, int n, int tray)
{
    SceneDef def;
    MeshBuild m = {0};
    hawser_error err = {0};
    memset(b, 0, sizeof *b);
    check(straight_scene(&def, STRAIGHT_SEGMENTS), "no memory");
    const double radius = def.cables[0].diameter / 2;
    if (n > 0 && tray) cells_add(&m, 0.2, 0.2 - radius + DEPTH, M_PI, 2 * M_PI, n);
    if (n > 0 && !tray) cells_add(&m, 1.5, 0, 0, 2 * M_PI, n);
    mesh_build_end(&m);
    def.environment.mesh = m.mesh;
    def.environment.touched = n > 0;
    def.environment.clear = calloc(1, sizeof *def.environment.clear);
    def.environment.friction = calloc(1, sizeof(double));
    def.environment.friction[0] = 0.2;
    check(environment_share(&def.environment, &err) == HAWSER_OK, err.message);
    check(scene_build(&def, &b->scene, &err) == HAWSER_OK, err.message);
    scene_def_clear(&def);
    b->y = calloc((size_t)scene_state_size(&b->scene), sizeof *b->y);
    b->ydot = calloc((size_t)scene_state_size(&b->scene), sizeof *b->ydot);
    check(b->y && b->ydot && workspace_alloc(&b->ws, &b->scene, NULL), "no memory");
    scene_initial_state(&b->scene, b->y);
    check(dynamics_refresh(&b->scene, &b->ws, 0, b->y, 1, &err) == HAWSER_OK, err.message);
}

static void bench_free(Bench *b)
{
    free(b->y);
    free(b->ydot);
    workspace_free(&b->ws);
    scene_clear(&b->scene);
}

static void refresh(Bench *b) { dynamics_refresh(&b->scene, &b->ws, 0, b->y, 1, NULL); }
static void question(Bench *b) { dynamics_refresh(&b->scene, &b->ws, 0, b->y, 0, NULL); }
static void rates(Bench *b) { dynamics_rates(&b->scene, &b->ws, 0, b->y, 1, b->ydot); }

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

static void row_print(int n, int tray, int repetitions)
{
    Bench b;
    bench_new(&b, n, tray);
    const Facets *const f = b.scene.surfaces.facets;
    double build = 0, bytes = 0, near = 0;
    if (f) {
        const size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
        const double start = clock_now();
        Facets *const again = facets_new(&b.scene.def.environment.mesh, b.scene.surfaces.law);
        build = clock_now() - start;
        bytes = (double)(mallinfo2().uordblks + mallinfo2().hblkhd - before);
        facets_free(again);
        for (int p = 0; p < PARTS; ++p) near += b.ws.contact[p].surface.near->n;
    }
    printf("| %d | %s | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f |\n", f ? f->mesh.n_triangles : 0,
           !f     ? "none"
           : tray ? "in the tray"
                  : "nothing near",
           build, bytes / 1e6, near / (2 * STRAIGHT_SEGMENTS), least(&b, refresh, repetitions),
           least(&b, question, repetitions), least(&b, rates, repetitions));
    bench_free(&b);
}

/* 200 evaluations with the check of candidates between them, and one refresh: what 0.13 m of way cost at least, 1.3 s
 * of a pull at 0.1 m/s with steps of 6.5 ms. */
__attribute__((noinline)) static void measured(Bench *b)
{
    for (int k = 0; k < 200; ++k) {
        question(b);
        rates(b);
    }
    refresh(b);
}

int main(int argc, char **argv)
{
    static const int size[] = {10000, 100000, 1000000};
    if (argc > 2) {
        Bench b;
        bench_new(&b, atoi(argv[2]), 0);
        measured(&b);
        bench_free(&b);
        return 0;
    }
    const int repetitions = argc > 1 ? atoi(argv[1]) : 30;
    check(repetitions > 0, "repetitions must be a number above 0");
    printf("| triangles | cable | build s | memory MB | listed a point | refresh us | question us | evaluation us |\n"
           "|---|---|---|---|---|---|---|---|\n");
    row_print(0, 0, repetitions);
    for (int tray = 0; tray < 2; ++tray) {
        for (size_t i = 0; i < sizeof size / sizeof *size; ++i) row_print(size[i], tray, repetitions);
    }
    return 0;
}
