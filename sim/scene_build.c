#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/joints.h"
#include "sim/scene.h"

static const CableDef *cable_of(const SceneDef *def, int piece) { return &def->cables[def->pieces[piece].cable]; }

/* m, of the rollers along the route: largest radius at which the axis of the chain's thickest cable runs; 0: there are
 * none. Rollers listed by coordinates are left out: the cable may not reach them. */
static double farthest_line(const Scene *scene)
{
    double thickest = 0, farthest = 0;
    for (int i = 0; i < scene->chain.n; ++i) thickest = fmax(thickest, scene->chain.radius[i]);
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double sine = roller->profile == SHAPE_V_GROOVE ? roller->groove.sine : 1;
        if (!isnan(roller->s)) farthest = fmax(farthest, (roller->radius + thickest) / sine);
    }
    return farthest;
}

/* Reduces the contact radius at the end of a thick cable by so little per arc that the nearest place on a roller
 * remains unique (C6); the rest of the reduction extends over the following arcs, on the thinner cable. (C6a) */
static void radii_taper(Scene *scene)
{
    Chain *const c = &scene->chain;
    const double farthest = scene->def.geometry == GEOMETRY_SMOOTH ? farthest_line(scene) : 0;
    for (int side = 1; side >= -1 && farthest > 0; side -= 2) {
        for (int k = 1; k < c->n; ++k) {
            const int i = side > 0 ? k : c->n - 1 - k;
            const double arc = c->half[i] + c->half[i - side];
            c->radius[i] = fmax(c->radius[i], c->radius[i - side] - arc * arc / (6 * farthest));
        }
    }
}

/* Mass, inertia by the cross-section's radius of gyration (of a full circle if none is given), contact radius (S5). */
static void segments_fill(Scene *scene)
{
    Chain *const c = &scene->chain;
    int i = 0;
    scene_def_cut(&scene->def, c->half);
    for (int p = 0; p < scene->def.n_pieces; ++p) {
        const ChainPieceDef *const piece = &scene->def.pieces[p];
        const CableDef *const cable = cable_of(&scene->def, p);
        const double r = cable->diameter / 2, gyration = cable->gyration > 0 ? cable->gyration : r / 2;
        for (int k = 0; k < piece->segments; ++k, ++i) {
            const double h = c->half[i], m = cable->mass * h;
            scene->piece[i] = p;
            c->half[i] = h / 2;
            c->mass[i] = m;
            c->inertia[0][i] = 2 * m * gyration * gyration;
            c->inertia[1][i] = c->inertia[2][i] = m * (h * h / 12 + gyration * gyration);
            c->radius[i] = r;
        }
    }
    radii_taper(scene);
}

static void weight_fill(Scene *scene)
{
    const RoutePoint start = route_at(&scene->route, 0);
    const LeadInDef *const lead = &scene->def.lead_in;
    const Vec3 g = scene->def.gravity;
    scene->weight = (Weight){.gravity = g,
                             .lead_in = lead->present || scene->def.reel.model == REEL_PAYOUT,
                             .origin = scene_line_at(scene, 0),
                             .direction = start.tangent,
                             .blend = lead->blend};
    /* The lead-in gives way by 1 mm under the cable's weight, half critically damped. */
    scene->weight.hold = scene->def.strand.lay > 0 ? 0 : v3_norm(g) / 1e-3; /* cables that are laid up wind round that
                                                                             * line */
    scene->weight.hold_damping = sqrt(scene->weight.hold);
    if (!lead->carries_weight) {
        scene->weight.behind = v3_scale(v3_dot(g, start.tangent), start.tangent);
    }
}

static hawser_status rooms_build(Scene *scene, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; ROOM_KINDS[k]; ++k) {
        assert(k < ROOMS_MAX);
        scene->room[k] = (Room){.kind = ROOM_KINDS[k], .number = k};
        scene->n_rooms = k + 1;
        if (!status && ROOM_KINDS[k]->prepare) status = ROOM_KINDS[k]->prepare(&scene->room[k], scene, err);
    }
    for (int r = 0; !status && r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        status = room->kind->build(room, scene, err);
    }
    return status;
}

/* The springs: between segments, then at the ends; sliders where bending has hysteresis. */
static hawser_status springs_build(Scene *scene, hawser_error *err)
{
    joints_springs(scene);
    for (int r = 0; r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (room->present && room->kind->join) room->kind->join(room, scene);
    }
    chain_find_lacks(&scene->chain);
    const hawser_status status = joints_sliders(scene, err);
    const int laid = scene->def.strand.lay > 0; /* cables that are laid up have taken that shape at rest (SC3) */
    return status || !laid ? status : joints_rest(scene, scene->chain.n, err);
}

/* (BK10). */
static hawser_status bow_build(Scene *scene, hawser_error *err)
{
    const double wave = scene->pushed.wave;
    scene->bowed = buckling_bends(&scene->def, &scene->pushed);
    if (!scene->bowed) return HAWSER_OK;
    const double q = M_PI / wave, bow = scene->def.solver.imperfection * wave;
    return joints_bow(scene, bow * q * q, q, err);
}

static hawser_status scene_fill(Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    segments_fill(scene);
    scene->eye = 0;
    for (int p = 0; p < scene_def_eye(def); ++p) scene->eye += def->pieces[p].segments;
    scene->largest_speed = 0.1;
    scene->grip_speed = scene->beside_way = INFINITY;
    double *const length = malloc(((size_t)scene->chain.n + 1) * sizeof *length);
    if (!length) return error_memory(err);
    scene_def_cut(def, length);
    setup_joints(def, &scene->route, scene->chain.n, length, scene->joint_s);
    free(length);
    weight_fill(scene);
    hawser_status status = rooms_build(scene, err);
    if (!status) status = setup_build(def, &scene->route, scene->joint_s, &scene->setup, err);
    if (!status) status = buckling_of_run(&scene->setup, &scene->pushed, err);
    if (!status) status = springs_build(scene, err);
    if (!status) status = bow_build(scene, err);
    for (int r = 0; !status && r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (room->present && room->kind->finish) status = room->kind->finish(room, scene, err);
    }
    return status;
}

/* s, C/K of the joints. Below this, damping along the cable is so light that one-step methods reach any relevant error
 * for less than a BDF does (docs/theory.md, "One-step integration"). */
static const double LIGHTLY_DAMPED = 0.5e-3;

/* Resolves `auto` once for the whole chain, by the time in which the slowest joint gives way along the cable. Only a
 * BDF can integrate friction that sticks. max_order belongs to the BDF and is no reason to choose it: above 2 it is
 * unstable where waves last. */
static void method_choose(SolverDef *solver, const Chain *chain, int sticks)
{
    double slowest = 0;
    for (int j = 1; j < chain->n; ++j) slowest = fmax(slowest, chain->damping[0][j] / chain->stiffness[0][j]);
    const int one_step = slowest < LIGHTLY_DAMPED && !sticks;
    if (solver->method == METHOD_AUTO) solver->method = one_step ? METHOD_ESDIRK : METHOD_BDF;
}

hawser_status scene_build(const SceneDef *def, Scene *scene, hawser_error *err)
{
    memset(scene, 0, sizeof *scene);
    hawser_status status = scene_def_copy(def, &scene->def, err);
    if (status) return status;
    const int n = scene->total = scene_def_segments(def);
    scene->piece = calloc((size_t)n + 1, sizeof *scene->piece);
    scene->joint_s = calloc((size_t)n + 1, sizeof *scene->joint_s);
    if (!chain_alloc(&scene->chain, n) || !scene->piece || !scene->joint_s) {
        status = error_memory(err);
    } else {
        scene->chain.frame = def->frame;
        status = route_build(&scene->route, def->n_route, def->route, def->route_start, def->route_heading,
                             def->route_slope, err);
    }
    if (!status) status = scene_fill(scene, err);
    if (!status) method_choose(&scene->def.solver, &scene->chain, scene_def_sticks(&scene->def));
    if (status) scene_clear(scene);
    return status;
}

void scene_clear(Scene *scene)
{
    for (int r = 0; r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (room->kind->clear) room->kind->clear(room);
        free(room->self);
    }
    chain_free(&scene->chain);
    free(scene->piece);
    free(scene->joint_s);
    setup_free(&scene->setup);
    route_clear(&scene->route);
    scene_def_clear(&scene->def);
    memset(scene, 0, sizeof *scene);
}
