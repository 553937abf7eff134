#include "sim/watch/error_bars.h"

#include <math.h>

#include "sim/equipment/winch.h"

/* Calibrated on the example cases and random pulls: docs/model.md, "Error bars". */
static const double BOOKS = 3;                                /* of what the books of a mean leave open (EB2) */
static const double WAVER_OF_MEAN = 0.7, WAVER_OF_PEAK = 3.5; /* of what a figure wavers while a segment passes (EB1) */
static const double STANDS = 0.1;      /* of a segment: if less passes, nothing of it is seen (EB9) */
static const double ROUGH = 0.27;      /* of second differences, before a peak of a cable that began anywhere (EB12) */
static const double EVERYWHERE = 0.25; /* of that, where only surfaces carry the cable (EB1) */
static const double PARTLY = 0.5;      /* where rollers and surfaces do */
static const double MESH = 5e-4;       /* of any figure, which no support shows */
static const double SLACK = 0.065;     /* rad, by which a segment hangs off the line at most (EB15) */
static const double SIDEWAYS = 0.1;    /* of what rollers that spin would hold (EB13) */
static const double LEVEL = 1e-3;      /* of a bend: what is less to the side is none */
static const double ENDS = 0.2;        /* of a segment, whose weight a clamp carries and no surface */
static const double JERK = 0.03;       /* of what a peak stands above the mean (EB21) */
static const double SHARPNESS = 1.0 / 8; /* of the second difference at a peak (EB4) */
static const double TOLERANCES = 3;      /* of a step, that a peak may be off by */
static const double BOWED = 0.01; /* of the pull, that a snaking or coiled cable may lie in several ways (EB34) */

/* What friction lacks at a speed, of what is there (EB5). */
static double friction_missing(const FrictionLaw *law, double speed)
{
    double slope;
    if (friction_kind(law) != FRICTION_SPEED || !(law->mu_d > 0)) return 0;
    if (speed >= law->v_d) return 0; /* the law is flat */
    const double there = friction_over_speed(law, speed, &slope) * speed;
    return there > 0 ? fabs(law->mu_d / there - 1) : 0;
}

/* What no finer mesh and no shorter step changes: friction's law over speed, and how a pushed cable lies. */
static double friction_share(const Scene *scene)
{
    double worst = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r)
        worst = fmax(worst, friction_missing(&scene->contact.roller[r].friction, scene->largest_speed));
    for (int k = 0; k < scene->def.n_surfaces; ++k)
        worst = fmax(worst, friction_missing(&scene->def.surfaces[k].friction, scene->largest_speed));
    return scene->bowed ? worst + BOWED : worst;
}

double held_sideways(const Scene *scene, int r)
{
    const RollerDef *const roller = &scene->def.rollers[r];
    const FrictionLaw *const law = &roller->friction;
    if (!(roller->spin.inertia > 0) || friction_kind(law) != FRICTION_SPEED || !(roller->s >= 0)) return 0;
    const Vec3 bends = route_at(&scene->route, roller->s).curvature, g = scene->def.gravity;
    const double across = v3_norm(v3_cross(bends, g)); /* of a bend in a slope, the part to the side */
    if (!(across > LEVEL * v3_norm(bends) * v3_norm(g))) return 0;
    double rubs = 0; /* what holds it sideways when the roller does not */
    for (int k = 0; k < scene->def.n_rollers; ++k)
        if (!(scene->def.rollers[k].spin.inertia > 0)) rubs = fmax(rubs, scene->def.rollers[k].friction.mu_d);
    return SIDEWAYS * law->mu_d * rubs;
}

/* N m/rad, the softer way. */
static double joint_bends(const Chain *chain, int j) { return fmin(chain->stiffness[4][j], chain->stiffness[5][j]); }

double slack_share(const Scene *scene, double travel, double rest)
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

/* By how much friction at rest stands above that of sliding, of what slides; and the speed where it has fallen. */
static void friction_falls(const FrictionLaw *law, ErrorShares *shares)
{
    if (friction_kind(law) == FRICTION_NONE || !(law->mu_d > 0)) return;
    shares->falls = fmax(shares->falls, law->mu_s / law->mu_d - 1);
    shares->falls_until = fmax(shares->falls_until, law->v_d);
}

/* Largest coefficient of sliding friction on what carries the cable. */
static double friction_most(const Scene *scene)
{
    double most = 0;
    for (int r = 0; r < scene->contact.n_rollers; ++r) most = fmax(most, scene->contact.roller[r].friction.mu_d);
    for (int k = 0; k < 2 * scene->def.n_surfaces; ++k) most = fmax(most, scene->surfaces.friction[k].mu_d);
    return most;
}

/* Weight that a winch's clamp takes off a surface before it, by the length of a segment, N (EB3). */
static double clamp_carries(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const ChainPieceDef *const head =
        &def->pieces[def->n_pieces - 1]; /* a winch's drum moves with it, and is no weight */
    if (def->n_surfaces == 0 || !scene->winch->present || def->winch.axial_only) return 0;
    return ENDS * def->cables[head->cable].mass * head->length / head->segments * v3_norm(def->gravity);
}

/* Of the pull: the clamp (EB3), and what the places of the route ask of segments (ME1)-(ME7). */
static double mesh_share(const Scene *scene, const Mesh *mesh, double pull)
{
    int worst;
    const double clamp = pull > 0 ? friction_most(scene) * clamp_carries(scene) / pull : 0;
    return MESH + clamp + mesh_given(mesh, &scene->def, pull, &worst);
}

/* What of a figure's wavering is the mesh's: rollers make it so, surfaces do not (EB1). */
static double waver_share(const Scene *scene)
{
    if (scene->contact.n_rollers == 0) return EVERYWHERE;
    return scene->def.n_surfaces > 0 ? PARTLY : 1;
}

ErrorShares error_shares(const Scene *scene, const Mesh *mesh, const BalanceWindow *books, double pull)
{
    const double open = books ? fabs(books->numerical) + fabs(books->residual) : 0;
    ErrorShares out = {.time = books && fabs(books->winch) > 0 ? BOOKS * open / fabs(books->winch) : 0,
                       .step = TOLERANCES * scene->def.solver.accuracy,
                       .waver = waver_share(scene),
                       .rough = scene->def.solver.relax ? 0 : ROUGH,
                       .mesh = mesh_share(scene, mesh, pull),
                       .friction = friction_share(scene)};
    for (int r = 0; r < scene->contact.n_rollers; ++r) friction_falls(&scene->contact.roller[r].friction, &out);
    for (int k = 0; k < scene->def.n_surfaces; ++k) friction_falls(&scene->def.surfaces[k].friction, &out);
    return out;
}

static hawser_error_bar bar(double time, double mesh, double friction)
{
    return (hawser_error_bar){time, mesh, friction, time + mesh + friction};
}

/* What a figure wavers by while a segment passes; a cable that stands still shows nothing of it. If less has passed
 * than that: what was seen of it, in a straight line over a segment, or what rollers may do, if that is more (EB9). */
static double waver(const TimeMean *figure, const ErrorShares *shares)
{
    if (figure->blocks > 0) return shares->waver * mean_waver(figure);
    const double goes_on = shares->passed > 0 ? mean_waver_ahead(figure, fmin(shares->passed, 1)) : mean_waver(figure);
    const double seen = shares->waver * goes_on;
    return shares->passed < STANDS ? fmax(seen, shares->still) : seen;
}

hawser_error_bar error_of_mean(const TimeMean *figure, const ErrorShares *shares)
{
    const double size = fabs(mean_of(figure)), wavers = WAVER_OF_MEAN * waver(figure, shares);
    if (!(figure->time > 0)) return bar(NAN, NAN, NAN);
    return bar((shares->time + shares->drift / 2) * size + fmax(0, shares->missed - wavers),
               wavers + shares->mesh * size, shares->friction * size);
}

hawser_error_bar error_of_peak(const TimeMean *figure, const ErrorShares *shares)
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
