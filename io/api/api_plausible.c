/* What a case says that is hardly ever so: a slip of a unit, as a rule. Notes of `hawser check`, no errors. */
#include "io/api/api_handles.h"

#include <math.h>
#include <stdio.h>

/* Between which values a figure lies wherever cables are pulled; docs/case-format.md, "Figures that are hardly so", has
 * the sources. */
typedef enum PlausibleKind {
    PLAUSIBLE_DIAMETER,
    PLAUSIBLE_DENSITY,
    PLAUSIBLE_FRICTION,
    PLAUSIBLE_RADIUS,
    PLAUSIBLE_LENGTH,
    PLAUSIBLE_SPEED,
    PLAUSIBLE_TENSION,
    PLAUSIBLE_ROOM,
    PLAUSIBLE_CONDUCTOR,
    PLAUSIBLE_WIDTH
} PlausibleKind;

static const struct {
    const char *what, *unit;
    double least, most;
} ranges[] = {
    [PLAUSIBLE_DIAMETER] = {"diameter", "mm", 3, 400},
    [PLAUSIBLE_DENSITY] = {"mass over cross-section", "kg/m3", 500, 12000},
    [PLAUSIBLE_FRICTION] = {"friction coefficient", "", 0, 1.5},
    [PLAUSIBLE_RADIUS] = {"radius of a bend", "m", 0.05, 100000},
    [PLAUSIBLE_LENGTH] = {"length of the route", "m", 0.1, 100000},
    [PLAUSIBLE_SPEED] = {"speed of the winch", "m/s", 0, 5},
    [PLAUSIBLE_TENSION] = {"tension", "kN", 0, 1000},
    [PLAUSIBLE_ROOM] = {"inside diameter over the cable's", "", 1.02, 3},
    [PLAUSIBLE_CONDUCTOR] = {"conductors over the cable's cross-section", "", 0.01, 0.85},
    [PLAUSIBLE_WIDTH] = {"width less 30 mm over the cable's diameter", "", 1.5, 1000},
};

/* The rows as they are found. */
typedef struct Notes {
    PlausibleRow *row;
    int n, room;
} Notes;

/* A row if the value is outside; what is not known is not. */
static void look(Notes *notes, PlausibleKind kind, const char *of, double value)
{
    if (!isfinite(value) || (value >= ranges[kind].least && value <= ranges[kind].most) || notes->n == notes->room)
        return;
    PlausibleRow *const row = &notes->row[notes->n++];
    *row = (PlausibleRow){.what = ranges[kind].what,
                          .unit = ranges[kind].unit,
                          .value = value,
                          .least = ranges[kind].least,
                          .most = ranges[kind].most};
    snprintf(row->of, sizeof row->of, "%s", of);
}

/* The thickest cable of the chain, m. */
static double thickest(const SceneDef *def)
{
    double diameter = 0;
    for (int k = 0; k < scene_def_eye(def); ++k) diameter = fmax(diameter, def->cables[def->pieces[k].cable].diameter);
    return diameter;
}

/* The narrowest flat roller that carries the cable along the route: by the catalogue's rule 1.5 diameters and 30 mm. */
static void look_at_rollers(Notes *notes, const SceneDef *def)
{
    const RollerDef *narrow = NULL;
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        const int carries = isfinite(r->s) && !r->hold_down && r->profile == SHAPE_CYLINDER && fabs(r->axis.z) < 0.5;
        if (carries && (!narrow || r->width < narrow->width)) narrow = r;
    }
    if (narrow) look(notes, PLAUSIBLE_WIDTH, narrow->name, (narrow->width - 30e-3) / thickest(def));
}

/* Ducts of one power cable; thin ones lie in whatever duct there is. */
static void look_at_ducts(Notes *notes, const SceneDef *def)
{
    static const double POWER = 30e-3; /* m, diameter */
    const double diameter = thickest(def);
    if (diameter > 0)
        look(notes, PLAUSIBLE_CONDUCTOR, "limits",
             def->limits.area > 0 ? def->limits.area * def->limits.cores / (M_PI / 4 * diameter * diameter) : NAN);
    if (!(diameter >= POWER) || bundle_tails(&def->bundle) > 1 || def->theory.cables > 1 || def->n_beside > 0) return;
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const s = &def->surfaces[i];
        const double radius = s->bore > 0 ? s->bore : s->shape.radius;
        if (s->shape.kind == SURFACE_DUCT) look(notes, PLAUSIBLE_ROOM, s->name, 2 * radius / diameter);
    }
}

/* Of a cable by its section; the radius of gyration of a rod under test is nobody's affair. */
static void look_at_cables(Notes *notes, const SceneDef *def)
{
    for (int i = 0; i < def->n_cables; ++i) {
        const CableDef *const c = &def->cables[i];
        look(notes, PLAUSIBLE_DIAMETER, c->name, 1e3 * c->diameter);
        look(notes, PLAUSIBLE_DENSITY, c->name, c->mass / (M_PI / 4 * c->diameter * c->diameter));
    }
}

int plausible_find(const SceneDef *def, const Route *route, PlausibleRow row[PLAUSIBLE_ROWS])
{
    Notes notes = {.row = row, .room = PLAUSIBLE_ROWS};
    if (def->rod.present) return 0;
    look_at_cables(&notes, def);
    look_at_ducts(&notes, def);
    look_at_rollers(&notes, def);
    look(&notes, PLAUSIBLE_FRICTION, "friction", fmax(def->friction.mu_s, def->friction.mu_d));
    for (int i = 0; i < def->n_surfaces; ++i) {
        const FrictionLaw *const law = &def->surfaces[i].friction;
        look(&notes, PLAUSIBLE_FRICTION, def->surfaces[i].name, fmax(law->mu_s, law->mu_d));
    }
    look(&notes, PLAUSIBLE_LENGTH, "route", route->length);
    for (int p = 0; p < route->n; ++p) {
        if (route->piece[p].kind == ROUTE_BEND)
            look(&notes, PLAUSIBLE_RADIUS, route->piece[p].name, route->piece[p].radius);
    }
    const double end = def->duration;
    const int turns = def->winch.present && def->winch.mode == WINCH_SPEED;
    const int pulls = def->winch.present && def->winch.mode == WINCH_TENSION;
    if (turns) look(&notes, PLAUSIBLE_SPEED, "winch", fabs(profile_value(&def->winch.speed, end)));
    if (pulls) look(&notes, PLAUSIBLE_TENSION, "winch", fabs(profile_value(&def->winch.tension, end)) / 1e3);
    look(&notes, PLAUSIBLE_TENSION, "tail", fabs(profile_value(&def->tail.tension, end)) / 1e3);
    return notes.n;
}
