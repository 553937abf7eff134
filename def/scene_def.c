#include "def/scene_def.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

/* Sets the default contact law: Hertz contact, k = 4/3 E* sqrt(R) with R of a cylinder of 100 mm across one of 43.65 mm
 * (0.066 m) and E* = 1 GPa, a polyethylene sheath on steel; c damps half a metre of heavy cable on it at
 * about half of critical. */
static void contact_defaults(SceneDef *def)
{
    def->geometry = GEOMETRY_SMOOTH;
    def->impact = (ImpactLaw){.k = 3.4e8, .e = 1.5, .c = 1e4, .d = 1e-4};
    def->line_impact = def->impact; /* depth 0.07 mm for cable of 200 N/m, 0.6 mm in a bend with 5 kN/m */
    def->friction = (FrictionLaw){.mu_s = 0.2, .mu_d = 0.2, .v_s = 1e-3, .v_d = 2e-3};
    def->friction_known = (FrictionKnown){.source = FRICTION_UNKNOWN, .rest_assumed = 1};
    def->cable_friction = def->friction;
    def->contact_reach = 1;
    def->between_chains = 1;
}

static void drive_defaults(SceneDef *def)
{
    def->winch.speed = def->winch.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1};
    def->winch.band = 0.05;
    def->winch.trip = (TripDef){.brake = 0.5, .pause = 5, .ramp = 2};
    def->tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 1};
    def->winch.at = NAN;
    def->reel = (ReelDef){.distance = 5, .over = 0.01, .v_s = 1e-3, .speed = {.kind = PROFILE_STEP, .t1 = 1}};
    def->drag = (RopeDragDef){.v_s = 1e-3, .v_d = 2e-3, .ratio = 1};
}

static void solver_defaults(SolverDef *s)
{
    s->accuracy = 1e-3;
    s->max_order = 2;
    s->imperfection = 1e-3;
    s->relax = 1;
    s->relax_tolerance = 1e-6;
    s->relax_iterations = 200;
    s->threads = 1;
    s->linear = (LinOptions){.kind = LIN_AUTO, .ordering = ORDER_AUTO, .threads = 1};
}

void scene_def_defaults(SceneDef *def)
{
    memset(def, 0, sizeof *def);
    def->gravity = v3(0, 0, -9.81);
    def->frame = FRAME_SYMMETRIC;
    def->lead_in = (LeadInDef){.carries_weight = 1, .blend = 0.5};
    contact_defaults(def);
    drive_defaults(def);
    solver_defaults(&def->solver);
    def->theory = (TheoryDef){
        .cables = 1, .rope_mass = NAN, .rope_mu = NAN, .bears = NAN, .machine_push = NAN, .temperature = NAN};
    def->bundle.shape = (BundleShape){.cables = 1, .thickest = 1};
    limits_defaults(&def->limits);
    def->analysis = (AnalysisDef){.load_steps = 10, .tolerance = 1e-10, .modes = 6};
    def->medium = (MediumDef){.normal = 1.2, .tangential = 0.01, .buoyancy = 1};
    def->rod.stress_free = 1;
    def->strand.joined = -1;
    def->output = (OutputDef){.interval = 0.05, .state_interval = 0.5};
}

int scene_def_eye(const SceneDef *def)
{
    const int last = def->n_pieces - 1;
    for (int p = 0; p <= last; ++p)
        if (def->pieces[p].rope == ROPE_YES) return p;
    if (last < 1 || def->pieces[last].rope == ROPE_NO) return def->n_pieces;
    int first = last;
    while (first > 0 && def->pieces[first - 1].cable == def->pieces[last].cable &&
           def->pieces[first - 1].rope == ROPE_AUTO)
        --first;
    return first > 0 ? first : def->n_pieces;
}

Shape roller_def_shape(const RollerDef *roller)
{
    Shape shape = {.kind = roller->profile,
                   .centre = roller->centre,
                   .axis = v3_unit(roller->axis),
                   .radius = roller->radius,
                   .half_width = roller->width / 2,
                   .groove = roller->groove};
    if (shape.kind == SHAPE_BOX) shape.box = roller->box;
    if (shape.kind == SHAPE_BELL) shape.bell = roller->bell;
    return shape;
}

/* Half the distance between the neighbours along the route; the whole distance to a single neighbour. */
double roller_def_span(const SceneDef *def, int r)
{
    const double before = r > 0 ? def->rollers[r].s - def->rollers[r - 1].s : INFINITY;
    const double after = r + 1 < def->n_rollers ? def->rollers[r + 1].s - def->rollers[r].s : INFINITY;
    if (!(before > 0 && after > 0)) return fmax(fmax(before, after), 0);
    return isfinite(before + after) ? (before + after) / 2 : fmin(before, after);
}

int surface_along_route(const SurfaceDef *surface) { return surface->shape.kind != SURFACE_PLANE; }

/* (DU15), (BU7). */
double surface_theory_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend)
{
    const double mu = surface->friction.mu_d * bundle_theory_friction(def, surface, in_bend);
    return surface->shape.kind == SURFACE_V ? mu / sin(surface->shape.angle / 2) : mu;
}

double surface_flank(const SurfaceDef *surface)
{
    const SurfaceShape *const s = &surface->shape;
    if (s->kind == SURFACE_V) return 1 / tan(s->angle / 2);
    return s->kind == SURFACE_PLANE || (s->kind == SURFACE_FLAT && !(s->height > 0)) ? 0 : INFINITY;
}

StiffnessEstimate cable_def_estimate(const CableDef *cable)
{
    const CableMake make = {cable->diameter, cable->mass, cable->conductor_area, cable->conductor_metal,
                            cable->conductor_cores};
    return stiffness_estimate(&make);
}

int scene_def_segments(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < def->n_pieces; ++p) n += def->pieces[p].segments;
    return n;
}

/* Length of a rod's last segment at either end, where the others have h: h^2/2L if a point mass lies beyond its centre,
 * so that this mass lies at a centre (RD4). */
static double end_length(const SceneDef *def, int end, double h)
{
    double length = 0, own = h;
    for (int p = 0; p < def->n_pieces; ++p) length += def->pieces[p].length;
    for (int m = 0; m < def->rod.n_masses; ++m) {
        const double at = def->rod.masses[m].at, away = end == ROD_TAIL ? at : length - at;
        if (away < h / 2) own = fmin(h, h * h / (2 * length));
    }
    return own;
}

/* Computes the lengths of the segments of piece p, all equal except at the ends of a rod: out [segments]. */
static void piece_cut(const SceneDef *def, int p, double *out)
{
    const ChainPieceDef *const piece = &def->pieces[p];
    const int n = piece->segments;
    const double h = piece->length / n;
    double tail = h, head = h;
    if (def->rod.present && n > 2) {
        if (p == 0) tail = end_length(def, ROD_TAIL, h);
        if (p == def->n_pieces - 1) head = end_length(def, ROD_HEAD, h);
    }
    for (int k = 0; k < n; ++k) out[k] = tail < h || head < h ? (piece->length - tail - head) / (n - 2) : h;
    if (tail < h || head < h) {
        out[0] = tail;
        out[n - 1] = head;
    }
}

void scene_def_cut(const SceneDef *def, double *length)
{
    for (int p = 0; p < def->n_pieces; ++p) {
        piece_cut(def, p, length);
        length += def->pieces[p].segments;
    }
}

double winch_def_largest_speed(const WinchDef *winch, double until)
{
    if (winch->mode == WINCH_TENSION) return winch->speed_limit > 0 ? winch->speed_limit : 0;
    return profile_largest_until(&winch->speed, until);
}

/* Copying and clearing a definition: both visit everything it owns. */

/* An array owned by the definition: offsets of its pointer and count, and the size of an item. */
typedef struct OwnedArray {
    size_t pointer, count, size;
} OwnedArray;

#define OWNED(array, n) {offsetof(SceneDef, array), offsetof(SceneDef, n), sizeof *((SceneDef *)NULL)->array},

static const OwnedArray owned[] = {SCENE_OWNED(OWNED)};

enum { OWNED_ARRAYS = sizeof owned / sizeof *owned };

int scene_def_sticks(const SceneDef *def)
{
    int sticks = 0;
    for (int r = 0; r < def->n_rollers; ++r) sticks |= def->rollers[r].friction.d_s > 0;
    for (int k = 0; k < def->n_surfaces; ++k) sticks |= def->surfaces[k].friction.d_s > 0;
    return sticks;
}

const char *scene_def_can_jam(const SceneDef *def, int i)
{
    if (i < def->n_rollers) return def->rollers[i].name;
    return i - def->n_rollers < def->n_conveyors ? def->conveyors[i - def->n_rollers].name : NULL;
}

/* Returns the pointer of an array, of any type. */
static void *array_of(const SceneDef *def, const OwnedArray *a)
{
    void *array;
    memcpy(&array, (const char *)def + a->pointer, sizeof array);
    return array;
}

static void array_put(SceneDef *def, const OwnedArray *a, void *array)
{
    memcpy((char *)def + a->pointer, &array, sizeof array);
}

/* Copies `count` items of `size`; a count of 0 yields an allocation too. *ok becomes 0 if there is no memory. */
static void *copy_of(const void *from, int count, size_t size, int *ok)
{
    void *to = calloc((size_t)count + 1, size);
    if (!to) {
        *ok = 0;
    } else if (count > 0) {
        memcpy(to, from, (size_t)count * size);
    }
    return to;
}

/* Operation on a profile that owns its table; returns 0 without memory. */
typedef int ProfileVisit(Profile *profile);

static int visit_free(Profile *profile)
{
    profile_free(profile);
    return 1;
}

/* Visits all profiles that may be tables, of the definition itself and of the items of its arrays; all are visited
 * whatever one returns. */
static int profiles_visit(SceneDef *def, ProfileVisit *visit)
{
    int ok = visit(&def->winch.speed);
    ok &= visit(&def->winch.tension);
    ok &= visit(&def->tail.tension);
    for (int i = 0; def->conveyors && i < def->n_conveyors; ++i) ok &= visit(&def->conveyors[i].speed);
    for (int l = 0; def->rod.loads && l < def->rod.n_loads; ++l) ok &= visit(&def->rod.loads[l].by.size);
    for (int e = 0; e < 2; ++e) {
        const RodEndDef *const end = &def->rod.end[e];
        for (int m = 0; end->motions && m < end->n_motions; ++m) ok &= visit(&end->motions[m].by.size);
    }
    return ok;
}

void scene_def_clear(SceneDef *def)
{
    for (int k = 0; k < def->n_beside; ++k) scene_def_clear(&def->beside[k]);
    free(def->beside);
    profiles_visit(def, visit_free);
    environment_clear(&def->environment);
    for (int i = 0; i < OWNED_ARRAYS; ++i) free(array_of(def, &owned[i]));
    memset(def, 0, sizeof *def);
}

/* Copies the other chains' definitions; after a failure the copied ones stay until the definition is cleared. */
static void beside_copy(const SceneDef *def, SceneDef *out, int *ok)
{
    out->n_beside = 0;
    out->beside = def->n_beside > 0 ? calloc((size_t)def->n_beside, sizeof *out->beside) : NULL;
    *ok = *ok && (out->beside || def->n_beside == 0);
    for (int k = 0; *ok && k < def->n_beside; ++k) {
        *ok = !scene_def_copy(&def->beside[k], &out->beside[k], NULL);
        out->n_beside += *ok;
    }
}

hawser_status scene_def_copy(const SceneDef *def, SceneDef *out, hawser_error *err)
{
    int ok = 1;
    *out = *def;
    beside_copy(def, out, &ok);
    for (int i = 0; i < OWNED_ARRAYS; ++i) {
        int count;
        memcpy(&count, (const char *)def + owned[i].count, sizeof count);
        array_put(out, &owned[i], copy_of(array_of(def, &owned[i]), count, owned[i].size, &ok));
    }
    out->environment = environment_copy(&def->environment);
    ok &= profiles_visit(out, profile_own);
    if (ok) return HAWSER_OK;
    scene_def_clear(out);
    return error_memory(err);
}

/* The same scene with finer numerical settings; the physical model stays. docs/theory.md, "Certificates" (CE1). */

/* One level of time halves its error (CE1): accuracy by four, the longest step by the root of two, v_s by two. One
 * level of length does so too: segments by two. */
static const double RATIO[HAWSER_SOURCES] = {[HAWSER_TIME] = 4, [HAWSER_LENGTH] = 2};

static const double STEPS = 1.4142135623730951, SLOWER = 2;

static const double SAMPLES = 8; /* factor on the number of samples, between which peaks are missed: they cost little,
                                    and files are not written */

/* Least tolerance of static equilibria, which are found to rounding already. */
static const double STATIC_TOLERANCE = 1e-10;

double refinement_ratio(hawser_source source) { return RATIO[source]; }

static void refine_time(SceneDef *def, int level)
{
    const double gain = pow(RATIO[HAWSER_TIME], level), steps = pow(STEPS, level);
    SolverDef *const solver = &def->solver;
    solver->accuracy /= gain;
    solver->atol_position /= gain;
    solver->atol_rotation /= gain;
    solver->atol_velocity /= gain;
    solver->atol_omega /= gain;
    if (!(solver->max_step > 0)) solver->max_step = def->output.interval; /* the step's bound in that case */
    solver->imperfection /= pow(2, level);
    solver->max_step /= steps;
    solver->first_step /= steps;
    def->output.interval /= pow(SAMPLES, level);
    def->analysis.load_steps = (int)ceil(def->analysis.load_steps * steps - 1e-9);
    if (def->analysis.tolerance > STATIC_TOLERANCE)
        def->analysis.tolerance = fmax(def->analysis.tolerance / gain, STATIC_TOLERANCE);
}

/* Refines segments. Segments that were given by number no longer exist: they are removed. */
static void refine_length(SceneDef *def, int level)
{
    const double gain = pow(RATIO[HAWSER_LENGTH], level);
    for (int k = 0; k < def->n_pieces; ++k) def->pieces[k].segments = (int)ceil(def->pieces[k].segments * gain - 1e-9);
    if (level != 0) def->output.n_speed_segments = 0;
}

/* Refines a friction law. v_d, where the coefficient has fallen to mu_d, is physical; v_s regularises rest. Bristles of
 * sticking friction keep their ratio v_s/d_s. */
static void refine_law(FrictionLaw *law, double gain)
{
    law->v_s /= gain;
    law->d_s /= gain;
}

static void refine_friction(SceneDef *def, int level)
{
    const double gain = pow(SLOWER, level);
    refine_law(&def->friction, gain);
    refine_law(&def->cable_friction, gain);
    for (int r = 0; r < def->n_rollers; ++r) refine_law(&def->rollers[r].friction, gain);
    for (int k = 0; k < def->n_surfaces; ++k) refine_law(&def->surfaces[k].friction, gain);
    for (int k = 0; k < def->n_conveyors; ++k) def->conveyors[k].v_s /= gain;
    def->drag.v_s /= gain;
    def->reel.v_s /= gain;
}

void scene_def_refine(SceneDef *def, const int level[HAWSER_SOURCES])
{
    refine_time(def, level[HAWSER_TIME]);
    refine_friction(def, level[HAWSER_TIME]);
    refine_length(def, level[HAWSER_LENGTH]);
    def->solver.max_steps = 0; /* a bound for the unrefined case */
}

/* Refines a run for its next pass. Rows keep their interval; a segment given by number becomes the first of its two
 * parts. */
void scene_def_finer_pass(SceneDef *def, int slower)
{
    const double interval = def->output.interval;
    const int watched = def->output.n_speed_segments;
    refine_time(def, 1);
    refine_length(def, 1);
    if (slower) refine_friction(def, 1);
    def->output.interval = interval;
    def->output.n_speed_segments = watched;
    for (int i = 0; i < watched; ++i) def->output.speed_segments[i] *= (int)RATIO[HAWSER_LENGTH];
}

/* Checks for any friction, belt, drag or brake that decays toward rest. */
static int friction_fades(const SceneDef *def)
{
    int fades = def->n_conveyors > 0 || def->drag.force > 0 || def->reel.model == REEL_PAYOUT;
    fades |= def->cable_on_cable && friction_kind(&def->cable_friction) != FRICTION_NONE;
    for (int r = 0; r < def->n_rollers; ++r) fades |= friction_kind(&def->rollers[r].friction) != FRICTION_NONE;
    for (int k = 0; k < def->n_surfaces; ++k) fades |= friction_kind(&def->surfaces[k].friction) != FRICTION_NONE;
    for (int k = 0; k < def->environment.mesh.n_layers; ++k) fades |= def->environment.friction[k] > 0;
    return fades;
}

double refinement_slower(const SceneDef *def, int level) { return friction_fades(def) ? pow(SLOWER, -level) : 1; }
