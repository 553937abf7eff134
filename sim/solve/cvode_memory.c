#include "sim/solve/cvode_memory.h"

#include <cvode/cvode.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <sundials/sundials_types.h>
#include <sundials/sundials_version.h>

/* Offsets in bytes. A build that has CVODE's sources (HAWSER_CVODE_SOURCES) takes them from its private headers; any
 * other one uses those of 64-bit machines with doubles and 64-bit indices, which a build with the sources on such a
 * machine compares. */
#ifdef HAWSER_CVODE_SOURCES
#include <cvode_impl.h>
#include <cvode_ls_impl.h>
#include <cvode_proj_impl.h>
#include <stddef.h>
#define AT(record, field, known)                                                                                       \
    ((int)offsetof(struct record, field) / (sizeof(void *) != 8 || offsetof(struct record, field) == (known)))
enum { PLACES_KNOWN = 1 };
#else
#define AT(record, field, known) (known)
enum { PLACES_KNOWN = sizeof(void *) == 8 && sizeof(long) == 8 };
#endif
#define MEM(field, known)  AT(CVodeMemRec, field, known)
#define LS(field, known)   AT(CVLsMemRec, field, known)
#define PROJ(field, known) AT(CVodeProjMemRec, field, known)

/* Bytes by which later places differ from those of 6.4 with indices of 64 bits: behind two numbers that are as wide as
 * an index, behind three pointers to where messages go, which 7 keeps elsewhere, and behind a time that 6.5 and later
 * have beside the linear solver's counts. 6.4 to 7.5 were compared with their private headers. */
enum {
    SEVEN = SUNDIALS_VERSION_MAJOR >= 7,
    NARROW = 2 * ((int)sizeof(sunindextype) - 8),
    SILENT = NARROW - 24 * SEVEN,
    TIMED = SEVEN || SUNDIALS_VERSION_MINOR >= 5 ? 8 : 0,
    FROM = SEVEN ? 0 : 4,
    TO = SEVEN ? 5 : 7
};

/* Offsets in CVODE's own structure: */
enum {
    AT_HISTORY = MEM(cv_zn, 96),    /* pointers to its 13 vectors */
    AT_ORDER = MEM(cv_q, 288),      /* int: of the next step's prediction */
    AT_TRIED = MEM(cv_qprime, 292), /* int: of the step being tried */
    AT_NEXT_ORDER = MEM(cv_next_q, 296),
    AT_LENGTH = MEM(cv_L, 304), /* int: of its coefficients, order + 1 */
    AT_NEXT_STEP = MEM(cv_next_h, 336),
    AT_TIME = MEM(cv_tn, 360),
    AT_GAMMA = MEM(cv_gamma, 648),
    AT_MOST = MEM(cv_qmax, 712), /* int: the highest order allowed */
    AT_STEPS = MEM(cv_nst, 856), /* long, as all counts */
    AT_RATES = MEM(cv_nfe, 864),
    AT_STEP_FAILS = MEM(cv_ncfn, 872),
    AT_ITERATIONS = MEM(cv_nni, 880),
    AT_NEWTON_FAILS = MEM(cv_nnf, 888),
    AT_ERROR_FAILS = MEM(cv_netf, 896),
    AT_SETUPS = MEM(cv_nsetups, 904),
    AT_LINEAR = MEM(cv_lmem, 1040 + NARROW), /* pointer to what its linear solver keeps */
    AT_LAST_ORDER = MEM(cv_qu, 1064 + NARROW),
    AT_FIRST_STEP = MEM(cv_h0u, 1080 + NARROW),
    AT_LAST_STEP = MEM(cv_hu, 1088 + NARROW),
    AT_TOO_MUCH = MEM(cv_tolsf, 1112 + NARROW),     /* factor by which the tolerance should be larger */
    AT_VECTORS = MEM(cv_qmax_alloc, 1120 + NARROW), /* int: the highest order that it has vectors for */
    AT_KEPT = MEM(cv_indx_acor, 1124 + NARROW), /* int: the vector that holds the last correction, for a higher order */
    AT_PROJECTION = MEM(proj_mem, 1528 + SILENT),     /* pointer to what its projection keeps; NULL: there is none */
    AT_PROJECTING = MEM(proj_enabled, 1536 + SILENT), /* int: whether it is to project; never without one */
    AT_PROJECTED = MEM(proj_applied, 1540 + SILENT)   /* int: whether it has */
};
/* Offsets in the memory of the linear solver and of the projection: */
enum { AT_JACOBIANS = LS(nje, 136), AT_PROJECTIONS = PROJ(nproj, 64) };

/* Bytes from .. to-1 of a structure: numbers only, no pointers. */
typedef struct Stretch {
    int from, to;
} Stretch;
static const Stretch own[] = {
    {MEM(cv_tstopset, 272), MEM(NLS, 976 + NARROW)}, /* stop time, orders, steps, times, coefficients, limits, counts */
    {MEM(convfail, 1000 + NARROW), MEM(convfail, 1000 + NARROW) + (int)sizeof(int)}, /* how the last iteration ended */
    /* when a matrix is due; what the last step was made with */
    {MEM(cv_msbp, 1048 + NARROW), MEM(cv_VabstolMallocDone, 1128 + NARROW)},
    {MEM(cv_sldeton, 1184 + SILENT), MEM(cv_gfun, 1400 + SILENT)}, /* limits of stability, where they are looked for */
    /* whether and how the projection changes the history */
    {MEM(proj_enabled, 1536 + SILENT), MEM(cv_cvals, 1648 + SILENT)}};
/* when a matrix was made, counts */
static const Stretch linear[] = {{LS(jbad, 32), LS(jbad, 32) + (int)sizeof(int)},
                                 {LS(msbj, 128), LS(pset, 208 + TIMED)}};
/* when it was done, counts */
static const Stretch projection[] = {{PROJ(first_proj, 8), PROJ(first_proj, 8) + (int)sizeof(int)},
                                     {PROJ(freq, 16), PROJ(max_fails, 32) + (int)sizeof(int)},
                                     {PROJ(nproj, 64), PROJ(npfails, 72) + (int)sizeof(long)}};
enum {
    OWN = sizeof own / sizeof *own,
    LINEAR = sizeof linear / sizeof *linear,
    PROJECTION = sizeof projection / sizeof *projection
};

static void *pointer_at(const void *memory, int at)
{
    void *p;
    memcpy(&p, (const char *)memory + at, sizeof p);
    return p;
}

static int int_is(const void *memory, int at, int value)
{
    return !memcmp((const char *)memory + at, &value, sizeof value);
}

static int long_is(const void *memory, int at, long value)
{
    return !memcmp((const char *)memory + at, &value, sizeof value);
}

static int real_is(const void *memory, int at, sunrealtype value)
{
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the comparison is for equal bits */
    return !memcmp((const char *)memory + at, &value, sizeof value);
}

/* ------------------------------------------------------------------------------------------- checks against CVODE */

static int counts_are(void *cvode)
{
    static const struct {
        int (*get)(void *, long *);
        int at;
    } count[] = {{CVodeGetNumSteps, AT_STEPS},
                 {CVodeGetNumRhsEvals, AT_RATES},
                 {CVodeGetNumStepSolveFails, AT_STEP_FAILS},
                 {CVodeGetNumNonlinSolvIters, AT_ITERATIONS},
                 {CVodeGetNumNonlinSolvConvFails, AT_NEWTON_FAILS},
                 {CVodeGetNumErrTestFails, AT_ERROR_FAILS},
                 {CVodeGetNumLinSolvSetups, AT_SETUPS}};
    int ok = 1;
    for (size_t k = 0; k < sizeof count / sizeof *count; ++k) {
        long value = -1;
        ok = ok && count[k].get(cvode, &value) == CV_SUCCESS && long_is(cvode, count[k].at, value);
    }
    return ok;
}

static int reals_are(void *cvode)
{
    static const struct {
        int (*get)(void *, sunrealtype *);
        int at;
    } real[] = {{CVodeGetCurrentTime, AT_TIME},   {CVodeGetCurrentStep, AT_NEXT_STEP},
                {CVodeGetLastStep, AT_LAST_STEP}, {CVodeGetActualInitStep, AT_FIRST_STEP},
                {CVodeGetCurrentGamma, AT_GAMMA}, {CVodeGetTolScaleFactor, AT_TOO_MUCH}};
    int ok = 1;
    for (size_t k = 0; k < sizeof real / sizeof *real; ++k) {
        sunrealtype value = -1;
        ok = ok && real[k].get(cvode, &value) == CV_SUCCESS && real_is(cvode, real[k].at, value);
    }
    return ok;
}

static int orders_are(void *cvode)
{
    int last = -1, next = -1;
    return CVodeGetLastOrder(cvode, &last) == CV_SUCCESS && CVodeGetCurrentOrder(cvode, &next) == CV_SUCCESS &&
           int_is(cvode, AT_LAST_ORDER, last) && int_is(cvode, AT_NEXT_ORDER, next);
}

/* CVODE does not report the highest order: the check sets it to the lowest one, and back. */
static int most_is(void *cvode)
{
    int most;
    memcpy(&most, (const char *)cvode + AT_MOST, sizeof most);
    const int set = CVodeSetMaxOrd(cvode, 1) == CV_SUCCESS && int_is(cvode, AT_MOST, 1);
    const int back = CVodeSetMaxOrd(cvode, most) == CV_SUCCESS && int_is(cvode, AT_MOST, most);
    return set && back;
}

/* The state and the rates of the history. */
static int history_is(void *cvode)
{
    sunrealtype t, gamma, rl1;
    N_Vector predicted = NULL, now, rates, first = NULL;
    void *user;
    const int flag = CVodeGetNonlinearSystemData(cvode, &t, &predicted, &now, &rates, &gamma, &rl1, &first, &user);
    return flag == CV_SUCCESS && predicted && pointer_at(cvode, AT_HISTORY) == (void *)predicted &&
           pointer_at(cvode, AT_HISTORY + (int)sizeof(void *)) == (void *)first;
}

static int parts_are(void *cvode)
{
    long jacobians = -1, projections = -1;
    const void *const solver = pointer_at(cvode, AT_LINEAR), *const projects = pointer_at(cvode, AT_PROJECTION);
    const int ok =
        solver && CVodeGetNumJacEvals(cvode, &jacobians) == CV_SUCCESS && long_is(solver, AT_JACOBIANS, jacobians);
    if (!ok || !projects) return ok;
    return CVodeGetNumProjEvals(cvode, &projections) == CV_SUCCESS && long_is(projects, AT_PROJECTIONS, projections);
}

static int version_is(void)
{
    int major = 0, minor = 0, patch = 0;
    char label[32];
    return SUNDIALSGetVersionNumber(&major, &minor, &patch, label, sizeof label) == 0 &&
           major == SUNDIALS_VERSION_MAJOR && minor == SUNDIALS_VERSION_MINOR && minor >= FROM && minor <= TO &&
           PLACES_KNOWN && sizeof(sunrealtype) == 8;
}

int cvode_memory_known(void *cvode, const char **why)
{
    const char *unused, **const out = why ? why : &unused;
    *out = "this version of SUNDIALS keeps its integrator's state in another way: 6.4 to 7.5 are known";
    if (!version_is()) return 0;
    *out = "SUNDIALS does not keep its integrator's state where this program looks for it";
    return history_is(cvode) && counts_are(cvode) && reals_are(cvode) && orders_are(cvode) && most_is(cvode) &&
           parts_are(cvode);
}

/* ---------------------------------------------------------------------------------------------- saving, loading */

static void stretches(Checkpoint *c, const char *name, void *memory, int n, const Stretch *stretch)
{
    for (int k = 0; k < n; ++k)
        checkpoint_put(c, name, (char *)memory + stretch[k].from, (size_t)(stretch[k].to - stretch[k].from));
}

static int int_at(const void *memory, int at)
{
    int value;
    memcpy(&value, (const char *)memory + at, sizeof value);
    return value;
}

/* Checks orders and indices by which CVODE finds vectors and coefficients: it has vectors up to order `most`, also when
 * it frees them. Before the first step the tried order is 0. */
static int orders_fit(void *cvode, int most)
{
    const int fresh = long_is(cvode, AT_STEPS, 0);
    const struct {
        int at, least, more; /* may exceed the highest order by this */
    } number[] = {{AT_MOST, 1, 0},       {AT_ORDER, 1, 0},  {AT_TRIED, !fresh, 0}, {AT_NEXT_ORDER, 0, 0},
                  {AT_LAST_ORDER, 0, 0}, {AT_LENGTH, 2, 1}, {AT_KEPT, 0, 0}};
    int ok = int_at(cvode, AT_VECTORS) == most && (long)int_at(cvode, AT_LENGTH) == int_at(cvode, AT_ORDER) + 1L;
    memcpy((char *)cvode + AT_VECTORS, &most, sizeof most);
    for (size_t k = 0; k < sizeof number / sizeof *number; ++k) {
        const int n = int_at(cvode, number[k].at);
        ok = ok && n >= number[k].least && n <= most + number[k].more;
    }
    return ok;
}

static int projection_fits(const void *cvode, int projects)
{
    const int asked = int_at(cvode, AT_PROJECTING), done = int_at(cvode, AT_PROJECTED);
    return asked >= 0 && asked <= projects && done >= 0 && done <= projects;
}

static int steps_fit(const void *cvode)
{
    const int at[] = {AT_TIME, AT_NEXT_STEP, AT_LAST_STEP, AT_GAMMA};
    int ok = 1;
    for (size_t k = 0; k < sizeof at / sizeof *at; ++k) {
        sunrealtype value;
        memcpy(&value, (const char *)cvode + at[k], sizeof value);
        ok = ok && isfinite(value);
    }
    return ok;
}

void cvode_counts(void *cvode, IntegratorStats *stats)
{
    CVodeGetNumSteps(cvode, &stats->steps);
    CVodeGetNumRhsEvals(cvode, &stats->rhs_evals);
    CVodeGetNumNonlinSolvIters(cvode, &stats->newton_iters);
    CVodeGetNumLinSolvSetups(cvode, &stats->lin_setups);
    CVodeGetNumErrTestFails(cvode, &stats->error_fails);
    CVodeGetNumNonlinSolvConvFails(cvode, &stats->newton_fails);
}

void counts_check(Checkpoint *c, const IntegratorStats *s)
{
    checkpoint_longs(c, 8,
                     (const long[]){s->steps, s->rhs_evals, s->newton_iters, s->jac_evals, s->lin_setups,
                                    s->error_fails, s->newton_fails, s->strides});
}

void cvode_memory_checkpoint(Checkpoint *c, void *cvode)
{
    int projects = pointer_at(cvode, AT_PROJECTION) != NULL;
    const int had = projects, vectors = int_at(cvode, AT_VECTORS);
    CHECKPOINT(c, projects);
    if (!checkpoint_check(c, projects == had, "it was integrated with other constraints")) return;
    stretches(c, "cvode", cvode, OWN, own);
    stretches(c, "cvode's linear solver", pointer_at(cvode, AT_LINEAR), LINEAR, linear);
    if (projects) stretches(c, "cvode's projection", pointer_at(cvode, AT_PROJECTION), PROJECTION, projection);
    IntegratorStats now = {0};
    cvode_counts(cvode, &now);
    counts_check(c, &now);
    const int fits = orders_fit(cvode, vectors);
    if (!c->status) checkpoint_check(c, fits, "its order of integration is impossible");
    if (!c->status) checkpoint_check(c, projection_fits(cvode, projects), "it was integrated with other constraints");
    if (!c->status) checkpoint_check(c, steps_fit(cvode), "its steps are impossible");
}

int cvode_memory_history(void *cvode, N_Vector history[CVODE_HISTORY_MAX])
{
    int order, kept, n = 0;
    memcpy(&order, (char *)cvode + AT_ORDER, sizeof order);
    memcpy(&kept, (char *)cvode + AT_KEPT, sizeof kept);
    for (int k = 0; k < CVODE_HISTORY_MAX; ++k) {
        N_Vector v = pointer_at(cvode, AT_HISTORY + k * (int)sizeof(void *));
        if (v && (k <= order || k == kept)) history[n++] = v;
    }
    return n;
}
