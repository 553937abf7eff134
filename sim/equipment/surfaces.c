/* The ducts, trays, floors and walls of a scene, and its environment: docs/theory.md, "Surfaces", "Environment". */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/team.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

/* (DU17): length of cable whose line contact has the stiffness of a roller contact, at the depth at which damping is
 * full. */
static double tip_length(const ImpactLaw *point, const ImpactLaw *line)
{
    return point->k / line->k * pow(line->d, point->e - line->e);
}

/* Sets a law for each surface, adjusted for the layout of several cables, and behind these one for each in bends
 * (BU7). */
static void frictions_set(const SceneDef *def, int patches, Surfaces *s)
{
    for (int i = 0; i < 2 * def->n_surfaces; ++i) {
        const SurfaceDef *const surface = &def->surfaces[i % def->n_surfaces];
        const double factor = bundle_friction(def, surface, i >= def->n_surfaces);
        s->friction[i] = surface->friction;
        s->friction[i].mu_s *= factor;
        s->friction[i].mu_d *= factor;
    }
    for (int p = 0; p < patches; ++p) {
        if (s->patch[p].bend > 0) s->patch[p].law += def->n_surfaces;
    }
}

static int environment_touched(const SceneDef *def)
{
    return def->environment.touched && def->environment.mesh.n_triangles > 0;
}

/* Gives layers of equal friction one law, behind those of the surfaces; returns their number. */
static int layers_law(const SceneDef *def, FrictionLaw *friction, int *law)
{
    const EnvironmentDef *const e = &def->environment;
    int laws = 0;
    for (int k = 0; k < e->mesh.n_layers; ++k) {
        law[k] = -1;
        for (int j = 0; j < k && law[k] < 0; ++j) {
            if (e->friction[j] >= e->friction[k] && e->friction[j] <= e->friction[k]) law[k] = law[j];
        }
        if (law[k] >= 0 || isnan(e->friction[k])) continue;
        law[k] = 2 * def->n_surfaces + laws;
        friction[laws] = def->friction; /* its speeds */
        friction[laws].mu_s = friction[laws].mu_d = e->friction[k];
        friction[laws++].d_s = 0;
    }
    return laws;
}

static const double SKIN_MIN = 0.01; /* m (EN26) */

static double cable_thickest(const Scene *scene)
{
    double radius = 0;
    for (int i = 0; i < scene->chain.n; ++i) radius = fmax(radius, scene->chain.radius[i]);
    return radius;
}

static hawser_status surfaces_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const Route *const route = &scene->route;
    Surfaces *const s = &scene->surfaces;
    const int touched = environment_touched(def), layers = touched ? def->environment.mesh.n_layers : 0;
    room->present = def->n_surfaces > 0 || touched;
    if (!room->present) return HAWSER_OK;
    int patches = SURFACE_FACES_MAX * layers;
    for (int i = 0; i < def->n_surfaces; ++i) patches += surface_patch_count(&def->surfaces[i].shape, route);
    SurfacePatch *next = s->patch = calloc((size_t)patches + 1, sizeof *s->patch);
    s->friction = calloc(2 * (size_t)def->n_surfaces + (size_t)layers, sizeof *s->friction);
    s->law = calloc((size_t)layers + 1, sizeof *s->law);
    s->points.tip = tip_length(&def->impact, &def->line_impact);
    room->self = s; /* a member of the scene, set here so that it is freed */
    s->factor = calloc((size_t)(def->n_surfaces + layers), sizeof *s->factor);
    for (int i = 0; s->factor && i < def->n_surfaces + layers; ++i) s->factor[i] = profile_level(1);
    if (!s->patch || !s->friction || !s->law || !s->factor ||
        !surface_points_alloc(&s->points, def->geometry, &scene->chain)) {
        return error_memory(err);
    }
    for (int i = 0; i < def->n_surfaces; ++i) {
        surface_patches(&def->surfaces[i].shape, route, i, next);
        next += surface_patch_count(&def->surfaces[i].shape, route);
    }
    frictions_set(def, (int)(next - s->patch), s);
    const int laws = touched ? layers_law(def, s->friction + 2 * def->n_surfaces, s->law) : 0;
    for (int i = 0; i < laws; ++i, next += SURFACE_FACES_MAX)
        surface_mesh_patches(def->n_surfaces + i, 2 * def->n_surfaces + i, next);
    if (laws > 0) s->facets = facets_new(&def->environment.mesh, s->law);
    if (laws > 0 && !s->facets) return error_memory(err);
    s->model = (SurfaceModel){.impact = def->line_impact,
                              .reach = def->contact_reach,
                              .n_surfaces = def->n_surfaces,
                              .n_patches = (int)(next - s->patch),
                              .facets = s->facets,
                              .n_laws = laws,
                              .skin = fmax(SKIN_MIN, cable_thickest(scene)),
                              .friction = s->friction,
                              .patch = s->patch,
                              .points = &s->points};
    return HAWSER_OK;
}

static void surfaces_clear(Room *room)
{
    Surfaces *const s = room->self;
    if (!s) return;
    free(s->patch);
    free(s->friction);
    free(s->factor);
    free(s->law);
    facets_free(s->facets);
    surface_points_free(&s->points);
    room->self = NULL;
}

/* Surfaces and laws of the environment: each has a tally and a factor. */
static int all_surfaces(const SurfaceModel *model) { return model->n_surfaces + model->n_laws; }

/* Each part has half of the elements; the element before segment `middle` belongs to the second half. */
static int surfaces_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    const int elements = scene->surfaces.points.elements, middle = elements > 0 ? ws->middle : 0;
    const size_t laws = (size_t)(scene->surfaces.model.n_surfaces + all_surfaces(&scene->surfaces.model));
    FrictionLaw *const own = ws->room[room->number] = calloc(laws + 1, sizeof *own);
    ws->surfaces = scene->surfaces.model;
    if (own && laws > 0) memcpy(own, scene->surfaces.friction, laws * sizeof *own);
    ws->surfaces.friction = own;
    surface_pairs_init(&ws->contact[0].surface, 0, middle);
    surface_pairs_init(&ws->contact[1].surface, middle, elements);
    ws->on_surface = calloc((size_t)all_surfaces(&scene->surfaces.model) + 1, sizeof *ws->on_surface);
    int ok = ws->on_surface && own;
    for (int p = 0; ok && surface_sticks(&ws->surfaces) && p < PARTS; ++p) {
        ok &= surface_pairs_sticks(&ws->contact[p].surface, &ws->surfaces, scene->chain.n);
    }
    return ok;
}

static void surfaces_work_free(const Room *room, Workspace *ws)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) surface_pairs_free(&ws->contact[p].surface);
    free(ws->on_surface);
}

/* Copies the leans of friction that sticks: elements may have changed their half. */
static void surfaces_carry(const Room *room, Workspace *from, Workspace *to, int joined)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        for (int q = 0; q < PARTS && to->contact[p].surface.stick.n_beds > 0; ++q)
            surface_carry(&from->contact[q].surface, &to->contact[p].surface, joined);
    }
}

/* Writes the friction laws of time t into the workspace (K6). */
static void surfaces_pose(const Room *room, const Moment *m, const double *own)
{
    (void)own;
    const Surfaces *const s = room->self;
    FrictionLaw *const law = m->ws->room[room->number];
    const int n = s->model.n_surfaces;
    for (int i = 0; s->told && i < n + all_surfaces(&s->model); ++i)
        law[i] = friction_scaled(s->friction[i], profile_value(&s->factor[i < n ? i : i - n], m->t));
}

/* The lean of friction that sticks grows by the slip since the last accepted step (GR11). */
static void surfaces_begin(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        if (m->ws->contact[p].surface.stick.n_beds > 0) surface_clock(&m->ws->contact[p].surface, m->t);
    }
}

static void surfaces_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    surface_forces(&m->ws->surfaces, &m->scene->chain, &m->ws->kin, m->friction, &m->ws->contact[part].surface,
                   &m->ws->loads[part], NULL);
}

/* Derivatives, shared by two threads. */
typedef struct SurfaceJob {
    const Moment *m;
    BlockChain *k, *d;
} SurfaceJob;

/* Blocks of one half, without the element at the middle, which involves segments of both halves. */
static void blocks_job(void *arg, int rank)
{
    const SurfaceJob *const job = arg;
    Workspace *const ws = job->m->ws;
    const Chain *const chain = &job->m->scene->chain;
    const int from = rank == 0 ? 0 : ws->middle + 1, to = rank == 0 ? ws->middle : chain->n + 1;
    surface_blocks(&ws->surfaces, chain, &ws->kin, job->m->friction, &ws->contact[rank].surface, from, to, job->k,
                   job->d);
}

static void surfaces_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    (void)room;
    Workspace *const ws = m->ws;
    SurfaceJob job = {m, k, d};
    halves_run(ws->team, 1, blocks_job, &job);
    surface_blocks(&ws->surfaces, &m->scene->chain, &ws->kin, m->friction, &ws->contact[1].surface, ws->middle,
                   ws->middle + 1, k, d);
}

static hawser_status surfaces_refresh(const Room *room, const Moment *m, hawser_error *err)
{
    (void)room;
    Workspace *const ws = m->ws;
    hawser_status status = HAWSER_OK;
    for (int p = 0; p < PARTS && !status; ++p) {
        status = surface_refresh(&ws->surfaces, &m->scene->chain, &ws->kin, &ws->contact[p].surface, err);
    }
    return status;
}

static int surfaces_stale(const Room *room, const Moment *m)
{
    (void)room;
    int stale = 0;
    for (int p = 0; p < PARTS; ++p)
        stale |= surface_near_stale(&m->scene->chain, &m->ws->kin, &m->ws->contact[p].surface);
    return stale;
}

static int surfaces_candidates(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].surface.candidates + ws->contact[1].surface.candidates;
}

static int surfaces_remember(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].surface.stick.n_beds + ws->contact[1].surface.stick.n_beds > 0;
}

static void surfaces_accept(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        SurfacePairs *const pairs = &m->ws->contact[p].surface;
        if (pairs->stick.n_beds > 0) surface_accept(&m->ws->surfaces, &m->scene->chain, &m->ws->kin, m->t, pairs);
    }
}

static void surfaces_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p)
        surface_pairs_checkpoint(c, &scene->surfaces.model, &ws->contact[p].surface, scene->chain.n);
}

static double surfaces_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Surfaces *const s = room->self;
    double next = INFINITY;
    for (int i = 0; s->told && i < all_surfaces(&s->model); ++i) next = profile_corner_before(&s->factor[i], t, next);
    return next;
}

/* (K6) */
static int surfaces_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    (void)err;
    Surfaces *const s = room->self;
    int taken = 0;
    if (c->kind != HAWSER_FRICTION) return 0;
    for (int i = 0; i < all_surfaces(&s->model); ++i) {
        const char *const name = i < s->model.n_surfaces ? scene->def.surfaces[i].name : "environment";
        if (*c->what && strcmp(name, c->what) != 0) continue;
        s->factor[i] = command_ramp(&s->factor[i], t, c->value, c->ramp);
        taken = 1;
    }
    s->told |= taken;
    return taken;
}

static void surfaces_controls(Room *room, ControlsVisit *visit)
{
    Surfaces *const s = room->self;
    controls_bytes(visit, &s->told, sizeof s->told);
    controls_bytes(visit, s->factor, (size_t)all_surfaces(&s->model) * sizeof *s->factor);
}

static void surfaces_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        const ContactTally *const tally = &m->ws->contact[p].surface.work;
        balance_contact(out, LOST_SURFACES, PUSH_SURFACES, tally);
        out->work[BY_EDGES] += tally->edges;
    }
}

static void surfaces_stock(const Room *room, const Moment *m, const double *own, BalanceStock *out)
{
    (void)room;
    (void)own;
    for (int p = 0; p < PARTS; ++p) out->energy[IN_SURFACES] += m->ws->contact[p].surface.work.energy;
}

static int surfaces_look(const Room *room, const Moment *m)
{
    (void)room;
    Workspace *const ws = m->ws;
    int active = 0;
    for (int i = 0; i < all_surfaces(&ws->surfaces); ++i) ws->on_surface[i] = surface_tally_new();
    for (int p = 0; p < PARTS && ws->surfaces.n_patches > 0; ++p) {
        SurfacePairs *const pairs = &ws->contact[p].surface;
        surface_forces(&ws->surfaces, &m->scene->chain, &ws->kin, 1.0, pairs, &ws->loads[p], ws->on_surface);
        active += pairs->active;
    }
    return active;
}

const RoomKind SURFACES_ROOM = {.name = "surfaces",
                                .build = surfaces_build,
                                .clear = surfaces_clear,
                                .work_alloc = surfaces_work_alloc,
                                .work_free = surfaces_work_free,
                                .carry = surfaces_carry,
                                .pose = surfaces_pose,
                                .begin = surfaces_begin,
                                .loads = surfaces_loads,
                                .blocks = surfaces_blocks,
                                .touches = 1,
                                .heavy = 1,
                                .stale = surfaces_stale,
                                .refresh = surfaces_refresh,
                                .candidates = surfaces_candidates,
                                .remembers = surfaces_remember,
                                .accept = surfaces_accept,
                                .checkpoint = surfaces_checkpoint,
                                .next_stop = surfaces_next_stop,
                                .command = surfaces_command,
                                .controls = surfaces_controls,
                                .work = surfaces_work,
                                .stock = surfaces_stock,
                                .look = surfaces_look,
                                .in_space = "the cable lies in ducts or trays, on planes or in an environment"};
