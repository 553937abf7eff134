/* The paper's case: tensions along the tunnel against the reference theory, as in the paper's table 2; and where the
 * rest of the error comes from, each cause changed by itself. */
#include <math.h>
#include <stdio.h>

#include "validate/build.h"
#include "validate/validate.h"

/* A real cable's bending stiffness, a twentieth of the solid bar's (references: 9-16 kN m2 tangent); and next to none.
 */
#define REAL_EI 16.4e3 /* N m2 */
#define LIMP_EI 1.64e3
static const double PAPER_TOTAL = 12903.21; /* N, the paper's eq. 10 */

/* What is changed, and how small the errors must be. */
typedef struct Experiment {
    PaperChoice choice;
    double largest, mean; /* %, limits of the stations' errors */
    int as_printed;       /* the paper's own total and its corners are compared too */
} Experiment;

/* The corners A to F and the paper's total. */
static void printed_log(ValidationLog *log, const Experiment *e, const Sim *sim, const hawser_summary *sum)
{
    const hawser_station *station;
    const int n = hawser_sim_stations(sim, &station);
    for (int i = 0; i < n; ++i) {
        char quantity[VALIDATION_QUANTITY_MAX];
        if (station[i].name[0] < 'A' || station[i].name[0] > 'F') continue;
        snprintf(quantity, sizeof quantity, "tension at %s", station[i].name);
        log_share(log, quantity, "N", station[i].reference_N, station[i].mean_N, e->largest);
    }
    log_share(log, "eq. 10 by hawser", "N", PAPER_TOTAL, sum->paper_total_N, 1e-4);
    log_share(log, "winch force, paper's eq. 10", "N", PAPER_TOTAL, sum->pull_mean_N, 5);
}

/* The errors over all stations, and the pull. */
static hawser_status paper_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Experiment *const e = setup;
    SceneDef def;
    Sim *sim;
    hawser_summary sum;
    hawser_status status = paper_scene(&e->choice, &def, err);
    if (!status) status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_summary(sim, &sum);
    if (e->as_printed) printed_log(log, e, sim, &sum);
    log_limit(log, "largest tension error", "%", sum.error_max_pct, e->largest);
    log_limit(log, "mean tension error", "%", sum.error_mean_pct, e->mean);
    log_share(log, "winch force", "N", sum.reference_total_N, sum.pull_mean_N, e->mean);
    sim_free(sim);
    return HAWSER_OK;
}

static const Experiment onward = {.choice = {.ei = LIMP_EI, .rollers = 118, .onward = 32}, .largest = 0.5, .mean = 0.1},
                        limp_close = {.choice = {.ei = LIMP_EI, .rollers = 118}, .largest = 1, .mean = 0.5},
                        bar = {.largest = 5, .mean = 2.75, .as_printed = 1},
                        real = {.choice = {.ei = REAL_EI}, .largest = 2, .mean = 1},
                        limp = {.choice = {.ei = LIMP_EI}, .largest = 2, .mean = 1},
                        finer = {.choice = {.segment = 0.25}, .largest = 5, .mean = 2.75},
                        finest = {.choice = {.segment = 0.125}, .largest = 5, .mean = 2.75},
                        tighter = {.choice = {.accuracy = 1e-5}, .largest = 5, .mean = 2.75},
                        sharper = {.choice = {.v_s = 1e-4}, .largest = 5, .mean = 2.75},
                        closer = {.choice = {.rollers = 118}, .largest = 5, .mean = 2.75},
                        harder = {.choice = {.stiffer = 10}, .largest = 5, .mean = 2.75},
                        capsules = {.choice = {.capsules = 1}, .largest = 6, .mean = 2.75},
                        all = {
                            .choice = {.ei = LIMP_EI, .segment = 0.25, .accuracy = 1e-5, .v_s = 1e-4, .rollers = 118},
                            .largest = 1,
                            .mean = 0.5};

static const char reference[] = "bend ODE (T5), (T6)";
static const ValidationCase cases[] = {
    {"paper", "the paper's pull, station by station", "paper eq. 10, table 2; bend ODE (T5), (T6)", 1, &bar, paper_run},
    {"paper-real-cable", "the same with a real cable's bending stiffness", reference, 1, &real, paper_run},
    {"paper-limp", "bending switched off: a 200th of the EI", reference, 0, &limp, paper_run},
    {"paper-limp-rollers", "the same on a roller every 0.5 m", reference, 0, &limp_close, paper_run},
    {"paper-onward", "and rollers all the way to the winch", reference, 0, &onward, paper_run},
    {"paper-segments-2", "discretisation: segments of 0.25 m", reference, 0, &finer, paper_run},
    {"paper-segments-4", "discretisation: segments of 0.125 m", reference, 0, &finest, paper_run},
    {"paper-accuracy", "time integration: accuracy 1e-5", reference, 0, &tighter, paper_run},
    {"paper-friction", "friction's regularisation: full at 0.1 mm/s", reference, 0, &sharper, paper_run},
    {"paper-rollers", "supports: a roller every 0.5 m", reference, 0, &closer, paper_run},
    {"paper-contacts", "contacts ten times as stiff", reference, 0, &harder, paper_run},
    {"paper-capsules", "the contact line of straight segments", reference, 0, &capsules, paper_run},
    {"paper-all", "limp, fine, tight, sharp and on many rollers at once", reference, 0, &all, paper_run},
};
const ValidationGroup paper_group = VALIDATION_GROUP(cases);
