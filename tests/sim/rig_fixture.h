/* A scene with everything that moves it in space: what the tests of the motion, its Newton matrix and its integrator
 * stand on. */
#ifndef HAWSER_TESTS_SIM_RIG_FIXTURE_H
#define HAWSER_TESTS_SIM_RIG_FIXTURE_H

#include "sim/step/integrator.h"
#include "sim/step/spatial.h"
#include "tests/sim/scene_fixture.h"

typedef struct Rig {
    Scene scene;
    Workspace ws;
    Newton newton;
    Spatial spatial;
    Integrator *integrator; /* made by the first rig_advance */
    int n, size;            /* segments; entries of the state, equipment included */
    double t, *y, *rate;    /* s; [size] */
    uint64_t seed;          /* of the test's random numbers */
} Rig;

/* Takes the definition; the chain lies on its route at rest. options: NULL for the definition's. */
static inline Rig *rig_make(SceneDef *def, const LinOptions *options)
{
    Rig *const r = fixture_array(1, sizeof *r);
    hawser_error err = {0};
    fixture_build(def, &r->scene);
    assert_true(workspace_alloc(&r->ws, &r->scene, NULL));
    if (newton_new(&r->newton, &r->scene, options ? options : &r->scene.def.solver.linear, &err)) {
        fail_msg("%s", err.message);
    }
    r->n = r->scene.chain.n;
    r->size = scene_state_size(&r->scene);
    r->y = fixture_array(r->size, sizeof(double));
    r->rate = fixture_array(r->size, sizeof(double));
    scene_initial_state(&r->scene, r->y);
    return r;
}

static inline Rig *rig_free(Rig *r)
{
    integrator_free(r->integrator);
    newton_free(&r->newton);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r->y);
    free(r->rate);
    free(r);
    return NULL;
}

/* Searches the contact candidates of the state anew. */
static inline void rig_refresh(Rig *r)
{
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, r->t, r->y, 1, NULL), HAWSER_OK);
}

static inline Motion *rig_motion(Rig *r) { return spatial_init(&r->spatial, &r->scene, &r->ws, &r->newton); }

/* Integrates until time `to` (s). */
static inline hawser_status rig_run(Rig *r, double to, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (!r->integrator) status = integrator_new(rig_motion(r), r->t, r->y, &r->integrator, err);
    while (!status && r->t < to) status = integrator_step(r->integrator, to, &r->t, err);
    return status;
}

static inline void rig_advance(Rig *r, double to)
{
    hawser_error err = {0};
    if (rig_run(r, to, &err)) fail_msg("%s", err.message);
}

#endif
