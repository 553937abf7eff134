#include "bench/phases_plane.h"

#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/solve/integrator.h"

static void check(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_phases: in the plane: %s\n", what);
    exit(1);
}

static Motion *motion_of(PlaneBench *b) { return &b->planar.motion; }

void flat_kinematics(PlaneBench *b) { planar_place(&b->planar, b->t, b->y); }

void flat_rates(PlaneBench *b)
{
    Motion *const m = motion_of(b);
    check(m->ops->rates(m, b->t, b->y, b->ydot) == 0, "the rates are not finite");
}

void flat_contacts(PlaneBench *b)
{
    Planar *const p = &b->planar;
    for (int half = 0; half < PARTS; ++half) {
        planar_contact_forces(&p->model[half], &p->ps.chain, &p->kin, 1, &p->ws->contact[half].pairs, &p->loads[half],
                              NULL);
    }
}

/* What every step asks: do the candidates still hold? They do. */
void flat_refresh(PlaneBench *b)
{
    Motion *const m = motion_of(b);
    check(m->ops->accept(m, b->t, b->y, NULL) == HAWSER_OK, "contacts could not be refreshed");
}

void flat_blocks(PlaneBench *b)
{
    Motion *const m = motion_of(b);
    m->ops->linearise(m, b->t, b->y, b->ydot);
}

void flat_form(PlaneBench *b, double gamma)
{
    Motion *const m = motion_of(b);
    m->ops->form(m, gamma);
}

void flat_factor(PlaneBench *b)
{
    Motion *const m = motion_of(b);
    check(m->ops->factor(m) == 0, "the Newton matrix is singular");
}

void flat_solve(PlaneBench *b)
{
    Motion *const m = motion_of(b);
    double *const x = N_VGetArrayPointer(b->vector[3]);
    memcpy(x, b->rhs, (size_t)m->size * sizeof *x);
    check(m->ops->solve(m, x) == 0, "the Newton system could not be solved");
}

void vectors_step(N_Vector vector[4], double gamma)
{
    N_Vector y = vector[0], rate = vector[1], weight = vector[2], work = vector[3];
    sunrealtype factor[3] = {1, gamma, 0.5};
    N_Vector terms[3] = {y, rate, work};
    N_VScale(1, y, work);
    N_VLinearSum(1, y, gamma, rate, work);
    N_VLinearCombination(3, factor, terms, work);
    check(isfinite(N_VWrmsNorm(work, weight)), "the norm is not finite");
}

/* Nothing is to be projected. */
void flat_vector(PlaneBench *b, double gamma) { vectors_step(b->vector, gamma); }

void flat_sample(PlaneBench *b, SampleParts parts)
{
    Motion *const m = motion_of(b);
    const int active = m->ops->look(m, b->t, b->y, parts >= SAMPLE_FIELDS);
    sample_take(&b->look, m->scene, &b->ws, b->t, active, parts);
}

static double norm_of(const void *owner, const double *x, const double *w)
{
    const Motion *const m = owner;
    return m->ops->norm(m, x, w);
}

static void vectors_new(PlaneBench *b, SUNContext context)
{
    const int size = motion_of(b)->size;
    b->y = calloc((size_t)size, sizeof *b->y);
    b->rhs = calloc((size_t)size, sizeof *b->rhs);
    check(b->y && b->rhs, "no memory");
    b->vector[0] = vector_wrap(size, b->y, norm_of, motion_of(b), NULL, context);
    for (int k = 0; k < 4; ++k) {
        if (k > 0) b->vector[k] = N_VClone(b->vector[0]);
        check(b->vector[k] != NULL, "no memory");
        N_VConst(1, b->vector[k]);
    }
    b->ydot = N_VGetArrayPointer(b->vector[1]);
    for (int k = 0; k < size; ++k) b->rhs[k] = 1e-3 * cos(0.1 * k);
}

void flat_new(PlaneBench *b, const Scene *scene, double t, const double *y, SUNContext context)
{
    Plane plane;
    char why[PLANE_WHY_MAX];
    hawser_error err = {0};
    memset(b, 0, sizeof *b);
    b->t = t;
    check(plane_find(scene, &plane, why), why);
    check(workspace_alloc(&b->ws, scene, NULL) && sample_alloc(&b->look, scene), "no memory");
    const LinOptions options = {.kind = LIN_BLOCK, .ordering = ORDER_AMD, .threads = 1};
    check(planar_new(&b->planar, scene, &plane, &b->ws, &options, &err) == HAWSER_OK, err.message);
    vectors_new(b, context);
    Motion *const m = motion_of(b);
    m->ops->pack(m, y, b->y);
    check(m->ops->renew(m, t, b->y, &err) == HAWSER_OK, err.message);
}

void flat_free(PlaneBench *b)
{
    for (int k = 0; k < 4; ++k) N_VDestroy(b->vector[k]);
    free(b->y);
    free(b->rhs);
    sample_free(&b->look);
    planar_free(&b->planar);
    workspace_free(&b->ws);
}
