/* The map of supports: what holds the cable at each place of the route, and on which sides. It is built once from the
 * definition; unsupported spans, lateral support, uplift, spacings, stretches of friction, the mesh and the rope's
 * bends are queries of it, in theory and in a run. docs/theory/60-theory.md. */
#ifndef HAWSER_THEORY_SUPPORTS_H
#define HAWSER_THEORY_SUPPORTS_H

#include "def/scene_def.h"

/* m off the route: tolerance within which theory's cable follows the route; a run whose cable leaves it by more is not
 * trusted. */
static const double SUPPORT_OFF_ROUTE = 2;
/* Least upward component of a plane's normal for a floor (or ceiling), below which it is a wall; of a roller's axis for
 * an upright roller. */
static const double SUPPORT_LEVEL = 0.7;

typedef enum SupportKind {
    SUPPORT_ROLLER,    /* carries */
    SUPPORT_GUIDE,     /* an upright roller beside the cable: its axis is nearer to the upward normal than to
                        * the level */
    SUPPORT_HOLD_DOWN, /* a roller above it */
    SUPPORT_DUCT,
    SUPPORT_TRAY, /* or anything else along the route: a flat floor with or without sides, a V */
    SUPPORT_BELT  /* of a conveyor that holds the cable on its line */
} SupportKind;

/* A roller at the cable: of a row, or one listed by coordinates that the cable reaches outside ducts and trays. */
typedef struct SupportRoller {
    double s, across; /* m along the route; its diameter, m */
    SupportKind kind;
    int item;  /* of the definition's rollers */
    int row;   /* it has its own place along the route */
    int inner; /* 1: the bend there presses the cable on it, 0: neither on it nor away from it, -1: away */
    Vec3 off;  /* unit, from the route to it */
} SupportRoller;

/* Support along a length of the route: from below, to both sides, from above. */
typedef struct SupportLength {
    double from, to; /* m along the route */
    SupportKind kind;
    int item;                    /* of the definition's surfaces, or conveyors */
    int sides, above;            /* below is always held */
    double half;                 /* m, from the middle to the bound on either side; INFINITY: none */
    const FrictionLaw *friction; /* at rest and moving; NULL: a belt's grip */
} SupportLength;

typedef struct Supports {
    const SceneDef *def; /* borrowed */
    const Route *route;  /* borrowed */
    int n_rollers;
    SupportRoller *roller; /* [n_rollers] by rising s, of one place as they are listed */
    int n_lengths;
    SupportLength *length; /* [n_lengths] by rising from */
    double *reach;         /* [n_lengths] m: the farthest `to` of those up to there */
    int n_along;
    const SurfaceDef **along; /* [n_along] surfaces along the route, by rising from */
    int n_planes;
    const SurfaceDef **plane; /* [n_planes] floors, walls and ceilings, as they are listed */
} Supports;

/* Builds the map. Rollers, surfaces and conveyors of the definition must be filled in; definition and route must stay.
 * The result must be freed with supports_free, also after an error. Errors: MEMORY. */
hawser_status supports_build(const SceneDef *def, const Route *route, Supports *out, hawser_error *err);
void supports_free(Supports *map);

/* ------------------------------------------------------------------------------------------------------- rollers */

/* The first roller at or beyond s (m along the route). */
int supports_from(const Supports *map, double s);
/* Start of the next carrying support after s, m; the route's end if there is none. */
double supports_next(const Supports *map, double s);
/* Checks whether a roller with that axis would stand upright beside the cable at s. */
int roller_guides_at(const Route *route, const RollerDef *roller, double s);
/* The same for a roller of a row. */
int roller_is_guide(const Route *route, const RollerDef *roller);
/* Side of a bend on which something at offset `off` (m, or unit) from the route stands, by the bend's curvature (1/m):
 * 1: inner side, the cable is pressed on it; -1: outer side; 0: neither. */
int bend_side(Vec3 off, Vec3 curvature);

/* ------------------------------------------------------------------------------------------- lengths and planes */

/* Number of surfaces along the route that begin at or before s. */
int supports_along(const Supports *map, double s);
/* Surface along the route at s; NULL if there is none. */
const SurfaceDef *supports_surface(const Supports *map, double s);
/* End of the uninterrupted cover of ducts, trays and belts from s on, m. */
double supports_covered(const Supports *map, double s);
/* The first length at or after s that supports the cable on both sides. The search begins at *next, which advances past
 * those that end before s; NULL: there is none before the route's end. */
const SupportLength *supports_sides(const Supports *map, double s, int *next);
/* The floor on which the cable would come to rest at a point between `least` and `most` (m) above it; NULL: there is
 * none. */
const SurfaceDef *supports_floor(const Supports *map, Vec3 at, double least, double most);
/* Checks whether a plane extends to the point, in its own directions. */
int plane_reaches(const SurfaceShape *plane, Vec3 at);

#endif
