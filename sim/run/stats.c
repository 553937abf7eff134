#include "sim/run/stats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/vec3.h"
#include "sim/equipment/winch.h"

/* Calibrated on the example cases and random pulls: docs/theory.md, "Error bars". */
static const double BOOKS = 3; /* of the residual of the balances, in a mean (EB2) */

static const double WAVER_OF_MEAN = 0.7, WAVER_OF_PEAK = 3.5; /* of a figure's variation while a segment passes (EB1) */

static const double STANDS = 0.1; /* of a segment: if less passes, the variation is not visible (EB9) */

static const double ROUGH = 0.27; /* of second differences, before a peak of a cable that began at any place (EB12) */

static const double EVERYWHERE = 0.25; /* of that, if only surfaces bear the cable (EB1) */

static const double PARTLY = 0.5; /* if rollers and surfaces do */

static const double MESH = 5e-4; /* of any figure, independent of the supports */

static const double SLACK = 0.065; /* rad, largest angle of a segment from the line (EB15) */

static const double SIDEWAYS = 0.1; /* of the hold of rollers that spin (EB13) */

static const double LEVEL = 1e-3; /* of a bend: a smaller lateral part counts as zero */

static const double ENDS = 0.2; /* of a segment, whose weight a clamp bears instead of a surface */

static const double JERK = 0.03; /* of the excess of a peak over the mean (EB21) */

static const double SHARPNESS = 1.0 / 8; /* of the second difference at a peak (EB4) */

static const double TOLERANCES = 3; /* of a step: possible error of a peak */

static const double BOWED = 0.01; /* of the pull: a snaking or coiled cable has several possible shapes (EB34) */

/* Part of friction that is missing at a speed, over the present one (EB5). */
static double friction_missing(const FrictionLaw *law, double speed)
{
    double slope;
    if (friction_kind(law) != FRICTION_SPEED || !(law->mu_d > 0)) return 0;
    if (speed >= law->v_d) return 0; /* the law is flat */
    const double there = friction_over_speed(law, speed, &slope) * speed;
    return there > 0 ? fabs(law->mu_d / there - 1) : 0;
}

/* Part that no finer mesh and no shorter step changes: friction's law over speed, and the shape of a cable in
 * compression. */
static double friction_share(const Scene *scene)
{
    double worst = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r)
        worst = fmax(worst, friction_missing(&scene->contact.roller[r].friction, scene->largest_speed));
    for (int k = 0; k < scene_surface_laws(scene); ++k)
        worst = fmax(worst, friction_missing(&scene->surfaces.friction[k], scene->largest_speed));
    return scene->bowed ? worst + BOWED : worst;
}

/* Part of the pull, N, that a load of 1 N on the r-th roller takes from those beside the cable once it does not creep
 * across it any more (EB13). */
static double held_sideways(const Scene *scene, int r)
{
    const RollerDef *const roller = &scene->def.rollers[r];
    const FrictionLaw *const law = &roller->friction;
    if (!(roller->spin.inertia > 0) || friction_kind(law) != FRICTION_SPEED || !(roller->s >= 0)) return 0;
    const Vec3 bends = route_at(&scene->route, roller->s).curvature, g = scene->def.gravity;
    const double across = v3_norm(v3_cross(bends, g)); /* lateral part of a bend in a slope */
    if (!(across > LEVEL * v3_norm(bends) * v3_norm(g))) return 0;
    double rubs = 0; /* holds it sideways if the roller does not */
    for (int k = 0; k < scene->def.n_rollers; ++k)
        if (!(scene->def.rollers[k].spin.inertia > 0)) rubs = fmax(rubs, scene->def.rollers[k].friction.mu_d);
    return SIDEWAYS * law->mu_d * rubs;
}

/* N m/rad, in the softer direction. */
static double joint_bends(const Chain *chain, int j) { return fmin(chain->stiffness[4][j], chain->stiffness[5][j]); }

/* Part of a peak due to the length that was slack, which is known no better than by the mesh; travel: of the winch up
 * to then, m; rest: the pull at first, N (EB15). */
static double slack_share(const Scene *scene, double travel, double rest)
{
    const Chain *const chain = &scene->chain;
    double most = 0; /* m */
    if (scene->def.winch.mode != WINCH_SPEED || !(travel > 0)) return 0;
    for (int i = 0; i < chain->n; ++i) {
        const double h = 2 * chain->half[i], weight = chain->mass[i] * v3_norm(scene->def.gravity);
        const double bends = h * fmax(joint_bends(chain, i), joint_bends(chain, i + 1)); /* EI; one may be free */
        const double stiff = bends > 0 ? 8. / 3 * weight * h * h / bends : SLACK;
        const double off = fmin(fmin(SLACK, stiff), weight < SLACK * rest ? weight / rest : SLACK);
        most = fmax(most, off * off * h / 3);
    }
    return fmin(1, most / travel);
}

/* Excess of friction at rest over sliding friction, relative to the latter; and the speed at which it has fallen
 * off. */
static void friction_falls(const FrictionLaw *law, ErrorShares *shares)
{
    if (friction_kind(law) == FRICTION_NONE || !(law->mu_d > 0)) return;
    shares->falls = fmax(shares->falls, law->mu_s / law->mu_d - 1);
    shares->falls_until = fmax(shares->falls_until, law->v_d);
}

/* Largest coefficient of sliding friction of the supports. */
static double friction_most(const Scene *scene)
{
    double most = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r) most = fmax(most, scene->contact.roller[r].friction.mu_d);
    for (int k = 0; k < scene_surface_laws(scene); ++k) most = fmax(most, scene->surfaces.friction[k].mu_d);
    return most;
}

/* Weight that a winch's clamp takes off a surface before it, by the length of a segment, N (EB3). */
static double clamp_carries(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const ChainPieceDef *const head =
        &def->pieces[def->n_pieces - 1]; /* a winch's drum moves with it but has no weight */
    if (scene->surfaces.model.n_patches == 0 || !scene->winch->present || def->winch.axial_only) return 0;
    return ENDS * def->cables[head->cable].mass * head->length / head->segments * v3_norm(def->gravity);
}

/* Share of the pull: the clamp (EB3), and the segment lengths that places of the route require (ME1)-(ME7). */
static double mesh_share(const Scene *scene, const SegmentMesh *mesh, double pull)
{
    int worst;
    const double clamp = pull > 0 ? friction_most(scene) * clamp_carries(scene) / pull : 0;
    return MESH + clamp + mesh_given(mesh, &scene->def, pull, &worst);
}

/* Share of a figure's variation that is due to the mesh: rollers cause it, surfaces do not (EB1). */
static double waver_share(const Scene *scene)
{
    if (scene->contact.n_rollers == 0) return EVERYWHERE;
    return scene->surfaces.model.n_patches > 0 ? PARTLY : 1;
}

ErrorShares error_shares(const Scene *scene, const SegmentMesh *mesh, const BalanceWindow *books, double pull)
{
    const double open = books ? fabs(books->numerical) + fabs(books->residual) : 0;
    ErrorShares out = {.time = books && fabs(books->winch) > 0 ? BOOKS * open / fabs(books->winch) : 0,
                       .step = TOLERANCES * scene->def.solver.accuracy,
                       .waver = waver_share(scene),
                       .rough = scene->def.solver.relax ? 0 : ROUGH,
                       .mesh = mesh_share(scene, mesh, pull),
                       .friction = friction_share(scene)};
    for (int r = 0; r < scene->contact.n_rollers; ++r) friction_falls(&scene->contact.roller[r].friction, &out);
    for (int k = 0; k < scene_surface_laws(scene); ++k) friction_falls(&scene->surfaces.friction[k], &out);
    return out;
}

static hawser_error_bar bar(double time, double mesh, double friction)
{
    return (hawser_error_bar){time, mesh, friction, time + mesh + friction};
}

/* Variation of a figure while a segment passes; a cable that stands still does not show it. If less has passed: the
 * variation so far, extrapolated as a straight line over a segment, or the possible effect of rollers if that is more
 * (EB9). */
static double waver(const TimeMean *figure, const ErrorShares *shares)
{
    if (figure->blocks > 0) return shares->waver * mean_waver(figure);
    const double goes_on = shares->passed > 0 ? mean_waver_ahead(figure, fmin(shares->passed, 1)) : mean_waver(figure);
    const double seen = shares->waver * goes_on;
    return shares->passed < STANDS ? fmax(seen, shares->still) : seen;
}

/* Error bound of the mean over the steady window; of the largest value of the run. */
static hawser_error_bar error_of_mean(const TimeMean *figure, const ErrorShares *shares)
{
    const double size = fabs(mean_of(figure)), wavers = WAVER_OF_MEAN * waver(figure, shares);
    if (!(figure->time > 0)) return bar(NAN, NAN, NAN);
    return bar((shares->time + shares->drift / 2) * size + fmax(0, shares->missed - wavers),
               wavers + shares->mesh * size, shares->friction * size);
}

static hawser_error_bar error_of_peak(const TimeMean *figure, const ErrorShares *shares)
{
    const double size = fabs(figure->peak), mean = figure->time > 0 ? fabs(mean_of(figure)) : 0;
    const double loose = fmin(shares->breaks_loose * mean, fmax(0, size - mean));
    if (!figure->started) return bar(NAN, NAN, NAN);
    const double passes = fmax(WAVER_OF_PEAK * waver(figure, shares), shares->placed);
    const double hits = fmax(shares->stands_out * size, fmin(size, shares->start - size));
    const double rough = fmax(shares->rough * sqrt(figure->rough_at_peak), fmax(hits, shares->blow));
    const double stands = fmax(0, size - fmax(mean, shares->at_rest)), jerk = (shares->slack + JERK) * stands;
    const double time = fmax(SHARPNESS * figure->sharpness, shares->faded);
    return bar(time + shares->step * size, fmax(passes, rough) + shares->mesh * size + jerk,
               shares->friction * size + loose);
}

/* Clearance and jam ratio of a duct with the cables in it; the sizes were checked when the case was read. */
static void duct_fill(const SceneDef *scene, const SurfaceDef *def, hawser_surface *out)
{
    DuctLoad load;
    out->clearance_m = out->jam_ratio = NAN;
    if (def->shape.kind != SURFACE_DUCT || bundle_in(scene, def, &load, NULL)) return;
    out->clearance_m = load.clearance;
    out->jam_ratio = load.jam_ratio;
}

static hawser_surface surface_row(const SceneDef *scene, const SurfaceDef *def)
{
    static const char *const kinds[] = {"duct", "flat", "v", "u", "plane"};
    const int along = surface_along_route(def);
    hawser_surface row = {.name = def->name,
                          .kind = kinds[def->shape.kind],
                          .from_m = along ? def->shape.from : NAN,
                          .to_m = along ? def->shape.to : NAN,
                          .line_load_at_m = NAN};
    duct_fill(scene, def, &row);
    return row;
}

enum { WATCHED = 2 }; /* the pull and the largest tension come before stations and rollers */

/* Recorded value by number. */
static TimeMean *watched(Stats *stats, int k)
{
    const int station = k - WATCHED, roller = station - stats->n_stations;
    if (k < WATCHED) return k == 0 ? &stats->pull : &stats->largest;
    return roller < 0 ? &stats->station[station] : &stats->roller[roller].load;
}

static int watched_count(const Stats *stats) { return WATCHED + stats->n_stations + stats->n_rollers; }

hawser_status stats_new(Stats *stats, const Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    *stats = (Stats){.last_t = -1,
                     .steady_from = def->output.steady_from,
                     .n_stations = def->n_stations,
                     .n_rollers = def->n_rollers,
                     .n_surfaces = def->n_surfaces};
    stats->station = calloc((size_t)def->n_stations + 1, sizeof *stats->station);
    stats->station_out = calloc((size_t)def->n_stations + 1, sizeof *stats->station_out);
    stats->roller = calloc((size_t)def->n_rollers + 1, sizeof *stats->roller);
    stats->roller_out = calloc((size_t)def->n_rollers + 1, sizeof *stats->roller_out);
    stats->surface = calloc((size_t)def->n_surfaces + 1, sizeof *stats->surface);
    stats->surface_out = calloc((size_t)def->n_surfaces + 1, sizeof *stats->surface_out);
    stats->before = calloc((size_t)watched_count(stats), sizeof *stats->before);
    stats->now = calloc((size_t)watched_count(stats), sizeof *stats->now);
    stats->station_joint = calloc((size_t)def->n_stations + 1, sizeof *stats->station_joint);
    stats->station_share = calloc((size_t)def->n_stations + 1, sizeof *stats->station_share);
    if (!stats->station || !stats->station_out || !stats->roller || !stats->roller_out || !stats->surface ||
        !stats->surface_out || !stats->before || !stats->now || !stats->station_joint || !stats->station_share) {
        stats_free(stats);
        return error_memory(err);
    }
    for (int i = 0; i < def->n_stations; ++i) {
        stats->station_out[i].name = def->stations[i].name;
        stats->station_out[i].s = def->stations[i].s;
    }
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        stats->roller_out[r] = (hawser_roller){.name = roller->name,
                                               .s = roller->s,
                                               .rating_N = roller->rating,
                                               .spin_rad_per_s = NAN,
                                               .shift_m = NAN,
                                               .peak_shift_m = NAN};
    }
    for (int i = 0; i < def->n_surfaces; ++i) stats->surface_out[i] = surface_row(def, &def->surfaces[i]);
    return HAWSER_OK;
}

void stats_free(Stats *stats)
{
    free(stats->station);
    free(stats->roller);
    free(stats->station_out);
    free(stats->roller_out);
    free(stats->surface);
    free(stats->surface_out);
    free(stats->before);
    free(stats->now);
    free(stats->station_joint);
    free(stats->station_share);
    memset(stats, 0, sizeof *stats);
}

/* Place of the joint: the mean of the two facing ends differs from the end of the segment before it by less than the
 * gap. */
static Vec3 joint_position(const Kinematics *kin, const Chain *chain, int j)
{
    const int i = j > 0 ? j - 1 : 0;
    const double side = j > 0 ? 1 : -1;
    const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
    const Vec3 p = v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]), a = quat_rotate(q, v3(1, 0, 0));
    return v3_axpy(p, side * chain->half[i], a);
}

/* Route coordinate of the simulated joint j (0..chain.n), m; travel: of the head, m. The place without stretch is the
 * first guess. */
double along_joint(const Scene *scene, const Kinematics *kin, double travel, int j)
{
    const double guess = scene->joint_s[scene->first + j] + travel;
    return route_foot(&scene->route, joint_position(kin, &scene->chain, j), guess, NULL);
}

double along_eye(const Scene *scene, const Kinematics *kin, double travel)
{
    const int j = scene->eye - scene->first;
    return j >= 0 && j <= scene->chain.n ? along_joint(scene, kin, travel, j) : NAN;
}

/* The simulated joint before route coordinate s, and the tension there, N; -1 if no cable is there. */
static int joint_before(const Scene *scene, const Kinematics *kin, const hawser_sample *sample, double s, double *there,
                        double *share)
{
    const int n = scene->chain.n;
    const double *const joint_s = scene->joint_s + scene->first, *const tension = sample->tension + scene->first;
    int low = 0, high = n;
    while (high - low > 1) { /* by the unstretched places */
        const int mid = (low + high) / 2;
        if (joint_s[mid] + sample->winch_travel <= s) {
            low = mid;
        } else {
            high = mid;
        }
    }
    double a = along_joint(scene, kin, sample->winch_travel, low),
           b = along_joint(scene, kin, sample->winch_travel, high);
    while (s < a && low > 0) {
        high = low--;
        b = a;
        a = along_joint(scene, kin, sample->winch_travel, low);
    }
    while (s > b && high < n) {
        low = high++;
        a = b;
        b = along_joint(scene, kin, sample->winch_travel, high);
    }
    if (s < a || s > b) return -1;
    const double u = (s - a) / (b - a);
    *share = u;
    *there = (1 - u) * tension[low] + u * tension[high];
    return low;
}

double stats_tension_at(const Scene *scene, const Kinematics *kin, const hawser_sample *sample, double s)
{
    double tension, share;
    return joint_before(scene, kin, sample, s, &tension, &share) >= 0 ? tension : NAN;
}

static void stations_record(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample,
                            double dt, int steady)
{
    for (int i = 0; i < stats->n_stations; ++i) {
        hawser_station *const out = &stats->station_out[i];
        TimeMean *const mean = &stats->station[i];
        double tension = NAN;
        stats->station_joint[i] = joint_before(scene, kin, sample, out->s, &tension, &stats->station_share[i]);
        if (!isnan(tension)) mean_add(mean, tension, dt, steady);
        out->mean_N = mean->started ? mean_of(mean) : NAN;
        out->peak_N = mean->started ? mean->peak : NAN;
    }
}

static void rollers_record(Stats *stats, const hawser_sample *sample, double dt, int steady)
{
    for (int r = 0; r < stats->n_rollers; ++r) {
        hawser_roller *const out = &stats->roller_out[r];
        RollerMeans *const means = &stats->roller[r];
        mean_add(&means->load, sample->roller_load[r], dt, steady);
        if (stats->last_t < 0) out->initial_N = sample->roller_load[r];
        out->steady_N = mean_of(&means->load);
        out->peak_N = means->load.peak;
        if (!sample->roller_spin) continue;
        mean_add(&means->spin, sample->roller_spin[r], dt, steady);
        mean_add(&means->shift, sample->roller_shift[r], dt, steady);
        out->spin_rad_per_s = mean_of(&means->spin);
        out->shift_m = mean_of(&means->shift);
        out->peak_shift_m = means->shift.peak;
    }
}

static void line_load_record(hawser_surface *out, const hawser_sample *sample, int i)
{
    if (!(sample->surface_line_load[i] > out->line_load_N_per_m)) return;
    out->line_load_N_per_m = sample->surface_line_load[i];
    out->line_load_at_m = sample->surface_at[i];
}

static void surfaces_record(Stats *stats, const hawser_sample *sample, double dt, int steady)
{
    for (int i = 0; i < stats->n_surfaces; ++i) {
        hawser_surface *const out = &stats->surface_out[i];
        SurfaceMeans *const means = &stats->surface[i];
        mean_add(&means->normal, sample->surface_normal[i], dt, steady);
        mean_add(&means->friction, sample->surface_friction[i], dt, steady);
        out->normal_N = mean_of(&means->normal);
        out->friction_N = mean_of(&means->friction);
        line_load_record(out, sample, i);
    }
}

/* Force along the cable, N, by which the places of joints over rollers may push it on or hold it back with the present
 * loads: with all joints in step (EB9), and *here: at their places (EB11). */
static double standing_force(const Scene *scene, const Kinematics *kin, const hawser_sample *sample, double *here)
{
    const Chain *const chain = &scene->chain;
    double sum = 0, tension, passed;
    *here = 0;
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const double load = sample->roller_load[r];
        const int j = load > 0 ? joint_before(scene, kin, sample, scene->def.rollers[r].s, &tension, &passed) : -1;
        if (j < 0 || !(tension > 0)) continue;
        const double h = 2 * chain->half[j < chain->n ? j : j - 1], span = roller_def_span(&scene->def, r);
        const int held = j > 0 ? j : 1; /* the tail's joint may be a free end; its neighbour bends as the cable does */
        const double bends = fmin(chain->stiffness[4][held], chain->stiffness[5][held]); /* in the softer direction */
        const double stiff = tension + (span > 0 ? M_PI * M_PI * bends * h / (span * span) : 0);
        const double force = load / 2 * fmin(load / sqrt(stiff * (stiff + 4 * bends / h)), 1);
        sum += force;
        *here += force * (1 - 2 * passed);
    }
    return sum;
}

/* Speed of the slowest segment, m/s. */
static double slowest(const Scene *scene, const hawser_sample *sample)
{
    double least = INFINITY;
    for (int i = 0; i < scene->chain.n; ++i) least = fmin(least, sample->axial_speed[sample->first + i]);
    return least;
}

static const double EVENLY = 0.1; /* of the winch's speed: largest change while a pull rises (EB26) */

/* Checks whether the winch is as fast at b as at a, s: a rise in between is not due to the start (EB26). */
static int is_drawn_evenly(const Scene *scene, double a, double b)
{
    const Profile *const speed = &scene->def.winch.speed;
    if (scene->def.winch.mode != WINCH_SPEED || !(a > 0)) return 0;
    const double from = profile_value(speed, a), to = profile_value(speed, b);
    return to > 0 && fabs(to - from) <= EVENLY * to;
}

/* Rise of the tension over the segment that the winch's clamp holds, N, if rollers press on it (EB31). */
static double behind_the_clamp(const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const int n = scene->chain.n;
    if (!(scene->winch && scene->winch->present) || scene->def.winch.axial_only) return 0;
    const double a = along_joint(scene, kin, sample->winch_travel, n - 1),
                 b = along_joint(scene, kin, sample->winch_travel, n);
    int pressed = 0;
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const double s = scene->def.rollers[r].s;
        pressed |= s > a && s < b && sample->roller_load[r] > 0;
    }
    return pressed ? fmax(0, sample->winch_force - sample->tension[scene->first + n - 1]) : 0;
}

/* Records the data of a peak besides its size. */
static void peak_record(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    double here;
    standing_force(scene, kin, sample, &here);
    stats->placed = fabs(here);
    stats->peak_speed = slowest(scene, sample);
    stats->peak_travel = sample->winch_travel;
    stats->clamped = behind_the_clamp(scene, kin, sample);
    stats->faded = stats->swings.fades;
    stats->rise = swings_rise(&stats->swings);
    stats->steepest = stats->swings.steepest;
    stats->risen_from = stats->swings.bottom;
    stats->met = sample->t > stats->steady_from || is_drawn_evenly(scene, stats->swings.risen_at, sample->t);
}

/* A block ends when the mesh has moved on by a segment, as long as the last one (EB1). Until the first has ended its
 * result is estimated. */
enum { BLOCK_LEAST = 4 }; /* least number of samples for a deviation */

static void blocks_end(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const double way = fabs(sample->winch_travel - stats->passed_at), length = 2 * scene->chain.half[0];
    if (stats->pull.blocks <= 0) {
        stats->passed = way / length;
        double here;
        stats->still = standing_force(scene, kin, sample, &here);
    }
    if (++stats->passing < BLOCK_LEAST || way < length) return;
    stats->passing = 0;
    stats->passed_at = sample->winch_travel;
    stats->block = 1;
    mean_block(&stats->pull);
    for (int i = 0; i < stats->n_stations; ++i) mean_block(&stats->station[i]);
    for (int r = 0; r < stats->n_rollers; ++r) mean_block(&stats->roller[r].load);
}

void stats_record(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const double dt = stats->last_t >= 0 ? sample->t - stats->last_t : 0;
    const int steady = stats->last_t >= stats->steady_from - 1e-9;
    stats->fresh = !(stats->last_t >= 0 && dt <= 0);
    if (!stats->fresh) return;
    stats->dt = dt;
    stats->steady = steady;
    stats->block = 0;
    mean_add(&stats->pull, sample->winch_force, dt, steady);
    if (stats->last_t < 0) stats->at_rest = sample->winch_force;
    if (stats->pull.at_peak) peak_record(stats, scene, kin, sample);
    mean_add(&stats->largest, fmax(sample->max_tension, sample->winch_force), dt, steady);
    mean_add(&stats->speed, sample->axial_speed[sample->first], dt, steady);
    if (fabs(sample->axial_speed[sample->first] - scene->largest_speed) > 0.02 * scene->largest_speed)
        stats->settled_at = sample->t;
    stations_record(stats, scene, kin, sample, dt, steady);
    rollers_record(stats, sample, dt, steady);
    surfaces_record(stats, sample, dt, steady);
    if (steady) {
        blocks_end(stats, scene, kin, sample);
    } else {
        stats->passed_at = sample->winch_travel;
    }
    stats->last_t = sample->t;
}

/* ------------------------------------------------------------------------------------------ peaks between samples */

/* Excess over the largest value so far above which another look is made: shares of that, and of the largest of its
 * kind. */
static const double NEW_PULL = 1e-3, NEW_OTHER = 1e-2, NEW_OF_ALL = 1e-3;

/* Values of the last step; NAN where there is none. */
static void step_values(const Stats *stats, const Scene *scene, double pull, const double *tension,
                        const Vec3 *on_roller, double *value)
{
    double largest = -INFINITY;
    for (int j = 0; j <= scene->chain.n; ++j) largest = fmax(largest, tension[j]);
    *value++ = pull;
    *value++ = fmax(largest, pull);
    for (int i = 0; i < stats->n_stations; ++i) {
        const int j = stats->station_joint[i];
        const double u = stats->station_share[i];
        *value++ = j >= 0 && j < scene->chain.n ? (1 - u) * tension[j] + u * tension[j + 1] : NAN;
    }
    for (int r = 0; r < stats->n_rollers; ++r) *value++ = v3_norm(on_roller[r]);
}

int stats_step(Stats *stats, const Scene *scene, double t, double pull, const double *tension, const Vec3 *on_roller)
{
    double *const before = stats->now, *const now = stats->before, load = 0;
    const int n = watched_count(stats), first_roller = n - stats->n_rollers;
    int due = 0;
    const int shared = scene->def.strand.present && !scene->winch->present; /* heads on one rope collide */
    if (!shared) swings_step(&stats->swings, scene, t, pull);
    mean_add(&stats->stepped, pull, t - stats->step_t, stats->step_t >= stats->steady_from - 1e-9);
    stats->step_t = t;
    step_values(stats, scene, pull, tension, on_roller, now);
    stats->before = before;
    stats->now = now;
    for (int r = 0; r < stats->n_rollers; ++r) load = fmax(load, stats->roller[r].load.peak);
    for (int k = 0; k < n; ++k) {
        const TimeMean *const m = watched(stats, k);
        const double of_all = k < first_roller ? stats->largest.peak : load;
        const double more = k == 0 ? NEW_PULL * m->peak : NEW_OTHER * m->peak + NEW_OF_ALL * of_all;
        due |= m->started && now[k] <= before[k] && now[k] > m->peak + more;
    }
    return due;
}

/* Raises all at once, each to the lower of its two steps' values. */
double stats_peak(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample)
{
    const double pull = stats->pull.peak;
    double *const now = stats->now;
    now[0] = sample->winch_force;
    now[1] = fmax(sample->max_tension, sample->winch_force);
    for (int i = 0; i < stats->n_stations; ++i)
        now[WATCHED + i] = stats_tension_at(scene, kin, sample, stats->station_out[i].s);
    for (int r = 0; r < stats->n_rollers; ++r) now[WATCHED + stats->n_stations + r] = sample->roller_load[r];
    for (int k = 0; k < watched_count(stats); ++k) {
        if (!isnan(now[k]) && !isnan(stats->before[k])) mean_held(watched(stats, k), stats->before[k], now[k]);
    }
    if (stats->pull.peak > pull) peak_record(stats, scene, kin, sample);
    for (int i = 0; i < stats->n_stations; ++i)
        if (stats->station[i].started) stats->station_out[i].peak_N = stats->station[i].peak;
    for (int r = 0; r < stats->n_rollers; ++r) stats->roller_out[r].peak_N = stats->roller[r].load.peak;
    for (int i = 0; i < stats->n_surfaces; ++i) line_load_record(&stats->surface_out[i], sample, i);
    return fmin(now[0], stats->before[0]);
}

void stats_raise(Stats *stats, const hawser_sample *sample)
{
    for (int r = 0; r < stats->n_rollers; ++r) {
        mean_raise(&stats->roller[r].load, sample->roller_load[r], 0);
        stats->roller_out[r].peak_N = stats->roller[r].load.peak;
    }
}

static const double NO_TENSION = 1e-6; /* N: a tension of theory below this is rounding, and its error is not
                                        * reported */

/* Largest and mean error of the stations relative to one of the two theories, %. */
static void errors_of(const Stats *stats, int paper, double *largest, double *mean)
{
    int count = 0;
    *largest = *mean = 0;
    for (int i = 0; i < stats->n_stations; ++i) {
        const hawser_station *const s = &stats->station_out[i];
        const double theory = paper ? s->paper_N : s->reference_N;
        if (!stats->station[i].started || !(fabs(theory) > NO_TENSION)) continue;
        const double error = 100 * fabs(s->mean_N / theory - 1);
        *largest = larger_of(*largest, error);
        *mean += error;
        ++count;
    }
    if (count > 0) *mean /= count;
}

void stats_summary(const Stats *stats, hawser_summary *out)
{
    out->pull_mean_N = mean_of(&stats->pull);
    out->pull_peak_N = stats->pull.peak;
    out->pull_ripple_N = mean_ripple(&stats->pull);
    out->steady_speed_m_per_s = mean_of(&stats->speed);
    out->settle_time_s = stats->settled_at < stats->last_t ? stats->settled_at : NAN; /* it still varies */
    out->steady_from_s = stats->steady_from;
    out->steady_to_s = stats->last_t > stats->steady_from ? stats->last_t : NAN; /* the window was not reached */
    errors_of(stats, 0, &out->error_max_pct, &out->error_mean_pct);
    errors_of(stats, 1, &out->error_max_paper_pct, &out->error_mean_paper_pct);
}

/* A joint moves load from one roller to the next: loads have wider bounds than tensions (EB7). */
static const double STEADY_LOADS = 3, PEAK_LOADS = 2;

/* A force at the end of a bend acts on one element, whatever its length: half of that is twice the load per metre
 * (EB8). */
static const double LINE_LOADS = 1;

/* Part of the pull, N, that spinning rollers take off those beside the cable if friction develops at once (EB13). */
static double sideways(const Stats *stats, const Scene *scene)
{
    double sum = 0;
    for (int r = 0; r < stats->n_rollers; ++r) sum += held_sideways(scene, r) * fabs(mean_of(&stats->roller[r].load));
    return sum;
}

/* Part of the largest pull, N: its rise while a wave runs through a segment and back, for the longest such time in the
 * chain: a wave along the cable, or, where the winch is even and the cable meets something that pushes it to the side,
 * one across it (EB26). */
static double blow_of(const Stats *stats, const SceneDef *def)
{
    double longest = 0; /* s */
    for (int k = 0; k < def->n_pieces; ++k) {
        const ChainPieceDef *const p = &def->pieces[k];
        const CableDef *const cable = &def->cables[p->cable];
        const double holds = stats->met ? fmin(cable->ea, fmax(stats->risen_from, 0)) : cable->ea;
        longest = fmax(longest, p->length / p->segments * sqrt(cable->mass / holds));
    }
    return stats->rise > 0 ? fmin(stats->rise, 2 * longest * stats->steepest) : 0;
}

static const double STEPPED = 0.99; /* of the window: steps must cover it to show what rows miss */

/* Difference of the mean pull of the rows from that of the steps between them, N (EB33). */
static double rows_miss(const Stats *stats)
{
    const int known = stats->stepped.time > STEPPED * stats->pull.time && stats->pull.time > 0;
    return known ? fabs(mean_of(&stats->pull) - mean_of(&stats->stepped)) : 0;
}

void stats_errors(const Stats *stats, const Scene *scene, ErrorShares *shares, hawser_summary *out)
{
    shares->passed = stats->passed;
    shares->still = stats->still;
    shares->breaks_loose = stats->peak_speed < shares->falls_until ? shares->falls : 0;
    shares->placed = stats->placed;
    shares->slack = slack_share(scene, stats->peak_travel, stats->at_rest);
    shares->at_rest = stats->at_rest;
    shares->missed = rows_miss(stats);
    shares->faded = stats->faded;
    shares->blow = fmax(blow_of(stats, &scene->def), stats->clamped);
    if (stats->pull.time > 0 && out->pull_mean_N > 0) shares->friction += sideways(stats, scene) / out->pull_mean_N;
    out->pull_mean_error = error_of_mean(&stats->pull, shares);
    out->pull_peak_error = error_of_peak(&stats->pull, shares);
    shares->missed = shares->placed = shares->slack = shares->drift = shares->stands_out = shares->start =
        shares->faded = shares->blow = 0;         /* for the pull alone */
    for (int i = 0; i < stats->n_surfaces; ++i) { /* sidewall pressure is proportional to the tension there */
        hawser_surface *const row = &stats->surface_out[i];
        const double tension = out->pull_peak_error.total / fabs(stats->pull.peak);
        row->line_load_error = row->line_load_N_per_m * (LINE_LOADS + tension);
    }
    for (int i = 0; i < stats->n_stations; ++i) {
        hawser_station *const s = &stats->station_out[i];
        s->mean_error_N = error_of_mean(&stats->station[i], shares).total;
        s->peak_error_N = error_of_peak(&stats->station[i], shares).total;
    }
    shares->still = shares->breaks_loose = 0; /* these act on the cable, not on a roller */
    for (int r = 0; r < stats->n_rollers; ++r) {
        hawser_roller *const row = &stats->roller_out[r];
        row->steady_error_N = STEADY_LOADS * error_of_mean(&stats->roller[r].load, shares).total;
        row->peak_error_N = PEAK_LOADS * error_of_peak(&stats->roller[r].load, shares).total;
    }
}
