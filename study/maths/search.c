#include "study/maths/search.h"

#include <math.h>
#include <nlopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/maths/points.h"

/* A share of a search's points that the evolution has; the neighbours of the best one get the rest. */
static const double EVOLVED = 0.6;
/* Sides of the box: the first steps from a start, and from the best point of an evolution. */
static const double FIRST_STEP = 0.2, LATER_STEP = 0.05;
/* Calls of NLopt's for each point that is new: with whole numbers most are known. */
enum { CALLS = 50, RANDOM_MIN = 20, RANDOM_A_SIDE = 8, RANDOM_SIDES_MAX = 12, BROKEN_ALL = 1 };

/* A search: all points so far, in a table by their bits. */
typedef struct Search {
    const SearchBox *box;
    const SearchPlan *plan;
    SearchTry try;
    void *user;
    nlopt_opt running; /* to be stopped; NULL: none */
    int over;          /* no more points */
    int failed;        /* no memory */
    long n, bound;     /* points; those that this stage may have */
    long room;         /* of `place`, a power of 2 */
    long *place;       /* [room] number of a point, -1: none */
    double *x;         /* [evaluations * box->n] */
    double *value;     /* [evaluations] */
    double *broken;    /* [evaluations * constraints] */
    double *sum;       /* [evaluations] of (SR1) */
    long best;         /* -1: none */
    double worst;      /* value so far */
    double scale;      /* size of the first value: NLopt sees values over it */
    int *side;         /* [sides] of the box, those that NLopt moves */
    int sides;
    double *at; /* [box->n] a point; sides that NLopt does not move stay as they are */
} Search;

double search_broken(double value, const double *broken, int n)
{
    double sum = 0;
    if (isnan(value)) return INFINITY;
    for (int k = 0; k < n; k++) sum += broken[k] > 0 ? broken[k] : 0;
    return sum;
}

int search_better(double value, double broken, double than_value, double than_broken)
{
    if (broken != than_broken) return broken < than_broken;
    return value < than_value;
}

double search_points(const SearchBox *box)
{
    double n = 1;
    for (int j = 0; j < box->n; j++) {
        if (!box->whole[j] && box->from[j] < box->to[j]) return 0;
        n *= box->to[j] - box->from[j] + 1;
    }
    return n <= 1e9 ? n : 0;
}

SearchMethod search_method(const SearchBox *box, long evaluations)
{
    const double points = search_points(box);
    if (points > 0 && points <= (double)evaluations) return SEARCH_ALL;
    for (int j = 0; j < box->n; j++) {
        if (box->whole[j] && box->from[j] < box->to[j]) return SEARCH_RANDOM;
    }
    return SEARCH_LINEAR;
}

const char *search_version(char text[32])
{
    int a, b, c;
    nlopt_version(&a, &b, &c);
    snprintf(text, 32, "NLopt %d.%d.%d", a, b, c);
    return text;
}

/* ---------------------------------------------------------------------------------------------------------- points */

/* Where in the table the point is, or would be. */
static long *place_of(const Search *s, const double *x)
{
    const size_t size = (size_t)s->box->n * sizeof *x;
    uint64_t h = 14695981039346656037u; /* FNV-1a */
    for (size_t i = 0; i < size; i++) h = (h ^ ((const unsigned char *)x)[i]) * 1099511628211u;
    long k = (long)((h ^ h >> 32) & (uint64_t)(s->room - 1));
    while (s->place[k] >= 0 && memcmp(s->x + s->place[k] * s->box->n, x, size) != 0) k = (k + 1) & (s->room - 1);
    return &s->place[k];
}

/* The number of the point at x[n], which is asked for if it is new; -1: there are no more. */
static long point_at(Search *s, const double *x)
{
    const int n = s->box->n, m = s->plan->constraints;
    long *const place = place_of(s, x);
    if (*place >= 0) return *place;
    if (s->over || s->n >= s->bound) {
        s->over |= s->n >= s->plan->evaluations;
        return -1;
    }
    const long i = s->n;
    memcpy(s->x + i * n, x, (size_t)n * sizeof *x);
    for (int k = 0; k < m; k++) s->broken[i * m + k] = 0;
    if (!s->try(s->user, x, &s->value[i], s->broken + i * m)) {
        s->over = 1;
        return -1;
    }
    *place = s->n++;
    s->sum[i] = search_broken(s->value[i], s->broken + i * m, m);
    if (s->best < 0 || search_better(s->value[i], s->sum[i], s->value[s->best], s->sum[s->best])) s->best = i;
    if (isnan(s->value[i])) return i;
    if (isnan(s->worst)) s->scale = s->value[i] != 0 ? fabs(s->value[i]) : 1;
    s->worst = isnan(s->worst) ? s->value[i] : fmax(s->worst, s->value[i]);
    return i;
}

/* ----------------------------------------------------------------------------------------------------------- NLopt */

/* Coordinates u of the unit cube as the point s->at; of whole numbers each has an equal share of the side. */
static long point_of_unit(Search *s, const double *u)
{
    const SearchBox *const b = s->box;
    for (int k = 0; k < s->sides; k++) {
        const int j = s->side[k];
        const double width = b->to[j] - b->from[j];
        s->at[j] = b->whole[j] ? fmin(b->from[j] + floor(u[k] * (width + 1)), b->to[j])
                               : fmin(fmax(b->from[j] + u[k] * width, b->from[j]), b->to[j]);
    }
    const long i = point_at(s, s->at);
    if (i < 0) nlopt_force_stop(s->running);
    return i;
}

/* A point without a value is as bad as the worst, and breaks all constraints. */
static double value_of_unit(unsigned n, const double *u, double *gradient, void *user)
{
    Search *const s = user;
    const long i = point_of_unit(s, u);
    (void)n, (void)gradient;
    const double value = i < 0 || isnan(s->value[i]) ? s->worst : s->value[i];
    return isnan(value) ? 0 : value / s->scale;
}

static void broken_of_unit(unsigned m, double *broken, unsigned n, const double *u, double *gradient, void *user)
{
    Search *const s = user;
    const long i = point_of_unit(s, u);
    (void)n, (void)gradient;
    for (unsigned k = 0; k < m; k++) broken[k] = i < 0 || isnan(s->value[i]) ? BROKEN_ALL : s->broken[i * (long)m + k];
}

/* Runs an algorithm over the sides s->side from s->at. Whatever ends it, its points are in the table. */
static void stage_run(Search *s, nlopt_algorithm algorithm, double step, unsigned population)
{
    double u[256], tolerance[256] = {0};
    const SearchBox *const b = s->box;
    s->running = nlopt_create(algorithm, (unsigned)s->sides);
    s->failed |= !s->running;
    if (!s->running) return;
    for (int k = 0; k < s->sides; k++) {
        const int j = s->side[k];
        const double width = b->to[j] - b->from[j];
        u[k] = b->whole[j] ? (s->at[j] - b->from[j] + 0.5) / (width + 1) : (s->at[j] - b->from[j]) / width;
    }
    nlopt_set_lower_bounds1(s->running, 0);
    nlopt_set_upper_bounds1(s->running, 1);
    nlopt_set_min_objective(s->running, value_of_unit, s);
    if (s->plan->constraints > 0)
        nlopt_add_inequality_mconstraint(s->running, (unsigned)s->plan->constraints, broken_of_unit, s, tolerance);
    nlopt_set_xtol_abs1(s->running, s->plan->tolerance);
    if (step > 0) nlopt_set_initial_step1(s->running, step);
    if (population) nlopt_set_population(s->running, population);
    const double calls = (double)CALLS * (double)s->plan->evaluations;
    nlopt_set_maxeval(s->running, calls < 1e9 ? (int)calls : 1000000000);
    double least;
    if (nlopt_optimize(s->running, u, &least) == NLOPT_OUT_OF_MEMORY) s->failed = 1;
    nlopt_destroy(s->running);
    s->running = NULL;
}

/* The sides that are numbers, or all that can be moved. */
static void sides_find(Search *s, int with_whole)
{
    s->sides = 0;
    for (int j = 0; j < s->box->n; j++) {
        if (s->box->from[j] < s->box->to[j] && (with_whole || !s->box->whole[j])) s->side[s->sides++] = j;
    }
}

/* ------------------------------------------------------------------------------------------------------- neighbours */

/* Asks for the best point with some whole numbers moved; whether it is better than that. */
static int neighbour_is_better(Search *s, int j, double by, int other, double other_by)
{
    const SearchBox *const b = s->box;
    const long before = s->best;
    memcpy(s->at, s->x + before * b->n, (size_t)b->n * sizeof *s->at);
    s->at[j] += by;
    if (other >= 0) s->at[other] += other_by;
    if (s->at[j] < b->from[j] || s->at[j] > b->to[j]) return 0;
    if (other >= 0 && (s->at[other] < b->from[other] || s->at[other] > b->to[other])) return 0;
    return point_at(s, s->at) >= 0 && s->best != before;
}

/* One whole number by 1 or 2 either way, then one up while another goes down: the first that is better. */
static int neighbours_step(Search *s)
{
    static const double moves[] = {-1, 1, -2, 2};
    const SearchBox *const b = s->box;
    for (int j = 0; j < b->n; j++) {
        for (int k = 0; k < 4 && b->whole[j]; k++) {
            if (neighbour_is_better(s, j, moves[k], -1, 0)) return 1;
        }
    }
    for (int j = 0; j < b->n; j++) {
        for (int i = 0; i < b->n; i++) {
            if (i != j && b->whole[i] && b->whole[j] && neighbour_is_better(s, j, 1, i, -1)) return 1;
        }
    }
    return 0;
}

/* From the best point: its whole neighbours, then its numbers by linear models, until neither finds a better one. */
static void neighbours_search(Search *s)
{
    s->bound = s->plan->evaluations;
    for (int better = 1; better && s->best >= 0 && !s->over && !s->failed;) {
        better = 0;
        while (!s->over && neighbours_step(s)) better = 1;
        const long before = s->best;
        sides_find(s, 0);
        memcpy(s->at, s->x + before * s->box->n, (size_t)s->box->n * sizeof *s->at);
        if (s->sides > 0 && !s->over) stage_run(s, NLOPT_LN_COBYLA, LATER_STEP, 0);
        better |= s->best != before;
    }
}

/* ---------------------------------------------------------------------------------------------------------- methods */

/* The first search begins where the user says, others at Sobol points. */
static void start_find(Search *s)
{
    const SearchBox *const b = s->box;
    memcpy(s->at, b->start, (size_t)b->n * sizeof *s->at);
    for (int j = 0; j < b->n && s->plan->number > 0; j++) {
        const double u = points_at(POINTS_SOBOL, s->plan->seed, (uint64_t)s->plan->number, 0, j % SOBOL_DIMENSIONS),
                     width = b->to[j] - b->from[j];
        s->at[j] = b->from[j] + (b->whole[j] ? floor(u * (width + 1)) : u * width);
    }
}

static void linear_search(Search *s)
{
    sides_find(s, 0);
    if (point_at(s, s->at) >= 0 && s->sides > 0) stage_run(s, NLOPT_LN_COBYLA, FIRST_STEP, 0);
}

static void random_search(Search *s)
{
    sides_find(s, 1);
    const int sides = s->sides < RANDOM_SIDES_MAX ? s->sides : RANDOM_SIDES_MAX;
    s->bound = (long)ceil(EVOLVED * (double)s->plan->evaluations);
    nlopt_srand((unsigned long)(s->plan->seed * 1000003 + (uint64_t)s->plan->number));
    if (point_at(s, s->at) < 0) return;
    if (s->sides > 0) stage_run(s, NLOPT_GN_ISRES, 0, (unsigned)(RANDOM_MIN + RANDOM_A_SIDE * sides));
    neighbours_search(s);
}

/* Every point whose number is that of this search over the number of searches; the last side changes fastest. */
static void all_search(Search *s)
{
    const SearchBox *const b = s->box;
    const double points = search_points(b);
    for (double i = s->plan->number; i < points; i += s->plan->of) {
        double rest = i;
        for (int j = b->n - 1; j >= 0; j--) {
            const double values = b->to[j] - b->from[j] + 1;
            s->at[j] = b->from[j] + fmod(rest, values);
            rest = floor(rest / values);
        }
        if (point_at(s, s->at) < 0) return;
    }
}

int search_run(const SearchBox *box, const SearchPlan *plan, SearchTry try, void *user)
{
    const size_t most = (size_t)plan->evaluations, n = (size_t)box->n, m = (size_t)plan->constraints;
    Search s = {.box = box,
                .plan = plan,
                .try = try,
                .user = user,
                .bound = plan->evaluations,
                .room = 16,
                .best = -1,
                .worst = NAN,
                .scale = 1};
    while (s.room < 2 * plan->evaluations) s.room *= 2;
    s.place = malloc((size_t)s.room * sizeof *s.place);
    s.side = malloc((n + 1) * sizeof *s.side);
    s.x = malloc((most * (n + m + 2) + n + 1) * sizeof *s.x);
    int ok = s.place && s.side && s.x;
    if (ok) {
        s.value = s.x + most * n;
        s.sum = s.value + most;
        s.broken = s.sum + most;
        s.at = s.broken + most * m;
        for (long k = 0; k < s.room; k++) s.place[k] = -1;
        start_find(&s);
        if (plan->method == SEARCH_LINEAR) linear_search(&s);
        if (plan->method == SEARCH_RANDOM) random_search(&s);
        if (plan->method == SEARCH_ALL) all_search(&s);
        ok = !s.failed;
    }
    free(s.place);
    free(s.side);
    free(s.x);
    return ok;
}
