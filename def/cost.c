/* Every figure here was measured: maximum resident memory of runs with 20 to 25 000 segments and 5 to 5000 rollers, and
 * processor time of their steps on one core of a Xeon. */
#include "def/cost.h"

#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/error.h"

/* Bytes of the program itself; of a roller with its contacts; of HDF5, and of HDF5 per segment. */
static const double PROGRAM = 13.8e6, ROLLER = 2200, STATES = 7.3e6, STATES_SEGMENT = 260;
/* Bytes of an off-diagonal block in the matrix of several chains, with derivatives and factors, for chains in contact
 * all along (three cables in a triangle, segments of 3 to 200 mm); of the states file of a further chain. */
static const double COUPLED = 2000, STATES_BESIDE = 1.6e6;
/* Bytes per segment, in space and in the plane, and per segment for other solvers beyond the block LU's. */
static const double SEGMENT[2] = {7700, 3850};
static const double KLU[2] = {4900, 1400};
/* Bytes of a row of series.csv; of a segment in a state, in double and in single precision. */
static const double ROW = 200, STATE_SEGMENT = 170;
/* s: mean step of a sliding pull; time of a step, and per segment and roller in it. */
static const double STEP = 0.04, STEP_TIME = 2e-5, SEGMENT_TIME[2] = {0.9e-6, 0.35e-6}, ROLLER_TIME = 1e-6;
/* s, of the program itself; of each segment until it is at rest; number of passes (typically two of one to three);
 * factor for the contact search of a drum's turns. 63 of 66 cases and traps take between a tenth and ten times the
 * estimate: 40 mm segments in bends, with steps of a millisecond, take 21 times as much, layers that slip 10.0 times,
 * and a chain at rest for an hour 1/400. */
static const double BEGIN = 0.02, SETTLE = 6e-5, PASSES = 2, TURNS = 10;

/* Chain k of a definition. */
static const SceneDef *chain_def(const SceneDef *def, int k) { return k > 0 ? &def->beside[k - 1] : def; }

/* Properties of a chain that determine its couplings with another. */
typedef struct Side {
    double length, segments, radius; /* m; how many; m, of the thickest piece */
} Side;

static Side side_of(const SceneDef *def)
{
    Side side = {0};
    for (int i = 0; i < def->n_pieces; ++i) {
        side.length += def->pieces[i].length;
        side.segments += def->pieces[i].segments;
        side.radius = fmax(side.radius, def->cables[def->pieces[i].cable].diameter / 2);
    }
    return side;
}

/* Number of blocks that couple two parallel chains, in both triangles: an element may meet elements of the other as far
 * away as its surface, the reach of candidates (CC20) and a piece (CC2) allow. */
static double coupled(const Side *a, const Side *b, double reach)
{
    const double along = fmin(a->length, b->length), radii = a->radius + b->radius;
    const double mine = a->length / a->segments, other = b->length / b->segments;
    const double near = radii + reach + 1.25 * fmin(mine, 2 * a->radius);
    const double window = sqrt(near * near - radii * radii);
    return 2 * along / mine * (1 + 2 * window / other);
}

/* The same for all chains that are pulled in parallel; ropes run ahead of them. */
static double coupled_blocks(const SceneDef *def)
{
    double blocks = 0, reach = def->contact_reach;
    Side side[STRANDS_MAX];
    int n = 0;
    for (int k = 0; def->between_chains && k <= def->n_beside; ++k) {
        const SceneDef *const chain = chain_def(def, k);
        const Side all = side_of(chain);
        reach = fmin(reach, all.radius);
        if (!chain->strand.rope && all.segments > 0) side[n++] = all;
    }
    for (int a = 0; a < n; ++a)
        for (int b = a + 1; b < n; ++b) blocks += coupled(&side[a], &side[b], reach);
    return blocks;
}

CostCounts cost_counts(const SceneDef *def, int planar)
{
    const OutputDef *const out = &def->output;
    CostCounts c = {.rollers = def->n_rollers,
                    .beside = def->n_beside,
                    .duration = def->duration,
                    .planar = planar,
                    .turns = def->drum.present};
    for (int k = 0; k <= def->n_beside; ++k) c.segments += side_of(chain_def(def, k)).segments;
    c.blocks = coupled_blocks(def);
    c.solver = def->solver.linear.kind;
    c.step = def->solver.max_step > 0 ? def->solver.max_step : out->interval;
    c.rows = out->interval > 0 ? (1 + c.beside) * def->duration / out->interval : 0;
    c.states = out->state_interval > 0 ? 1 + def->duration / out->state_interval : 0;
    return c;
}

Cost cost_of(const CostCounts *c)
{
    const int p = c->planar != 0;
    const double longest = c->step > 0 ? fmin(c->step, STEP) : STEP;
    double each = STEP_TIME + SEGMENT_TIME[p] * c->segments + ROLLER_TIME * c->rollers;
    Cost cost = {.memory = PROGRAM + SEGMENT[p] * c->segments + ROLLER * c->rollers,
                 .disk = ROW * c->rows + STATE_SEGMENT * c->segments * c->states};
    if (c->solver == LIN_KLU) cost.memory += KLU[p] * c->segments;
    cost.memory += COUPLED * c->blocks;
    if (c->states > 0) cost.memory += STATES + STATES_BESIDE * c->beside + STATES_SEGMENT * c->segments;
    if (c->turns) each *= TURNS;
    cost.time = c->blocks > 0 ? NAN
                              : BEGIN + SETTLE * c->segments +
                                    PASSES * c->duration / longest *
                                        each; /* the contact of several chains costs more than these counts show */
    return cost;
}

/* Writes a number with the largest unit of which it is more than one; the units rise, and end with NULL. */
typedef struct Unit {
    const char *name;
    double size;
} Unit;

static void say_amount(double x, const Unit *unit, int size, char *text)
{
    while (unit[1].name && x >= unit[1].size) ++unit;
    const double n = x / unit->size;
    snprintf(text, (size_t)size, n < 10 ? "%.1f %s" : n < 1e4 ? "%.0f %s" : "%.1e %s", n, unit->name);
}

void cost_say(const Cost *cost, int size, char *text)
{
    static const Unit bytes[] = {{"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}, {NULL, 0}};
    static const Unit times[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"days", 86400}, {"years", 3.156e7}, {NULL, 0}};
    char memory[32], time[32];
    say_amount(cost->memory, bytes, sizeof memory, memory);
    say_amount(cost->time, times, sizeof time, time);
    snprintf(text, (size_t)size, cost->time >= 0 ? "needs %s, %s" : "needs %s", memory, time);
}

/* Available memory in bytes; INFINITY: unknown. */
static double memory_there(void)
{
    struct rlimit limit;
    const double pages = (double)sysconf(_SC_PHYS_PAGES), page = (double)sysconf(_SC_PAGESIZE);
    const double machine = pages > 0 && page > 0 ? pages * page : INFINITY;
    const int limited = !getrlimit(RLIMIT_AS, &limit) && limit.rlim_cur != RLIM_INFINITY;
    return limited ? fmin(machine, (double)limit.rlim_cur) : machine;
}

hawser_status cost_check(const SceneDef *def, hawser_error *err)
{
    const CostCounts counts = cost_counts(def, def->solver.planar != PLANAR_OFF);
    const Cost cost = cost_of(&counts);
    const double there = memory_there();
    char text[80];
    if (cost.memory <= there) return HAWSER_OK;
    cost_say(&cost, sizeof text, text);
    return error_set(err, HAWSER_ERR_MEMORY,
                     "out of memory: the run %s, and there are %.3g GB: longer segments need less", text, there / 1e9);
}
