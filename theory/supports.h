/* The map of supports: what holds the cable at each place of the route, and to which sides. Built once from the
 * definition; unsupported spans, lateral support, uplift, spacings, stretches of friction, the mesh and the rope's
 * bends are queries of it, in theory and in a run. docs/model/31-theory.md. */
#ifndef HAWSER_THEORY_SUPPORTS_H
#define HAWSER_THEORY_SUPPORTS_H

#include "def/scene_def.h"

/* m off the route: so far theory's cable lies where it is drawn, and a run whose cable leaves it by more is not
 * trusted. */
static const double SUPPORT_OFF_ROUTE = 2;
/* Of a normal or an axis, upward: a plane is a floor (or a ceiling) above it and a wall below, a roller stands upright.
 */
static const double SUPPORT_LEVEL = 0.7;

typedef enum SupportKind {
    SUPPORT_ROLLER,    /* carries */
    SUPPORT_GUIDE,     /* a roller that stands upright beside the cable: its axis is nearer to the upward normal than to
                        * the level */
    SUPPORT_HOLD_DOWN, /* a roller above it */
    SUPPORT_DUCT,
    SUPPORT_TRAY, /* or anything else that runs along the route: a flat floor with or without sides, a V */
    SUPPORT_BELT  /* of a conveyor that holds the cable on its line */
} SupportKind;

/* A roller at the cable: of a row, or one listed by coordinates that the cable comes to and that no duct or tray has.
 */
typedef struct SupportRoller {
    double s, across; /* m along the route; its diameter, m */
    SupportKind kind;
    int item;  /* of the definition's rollers */
    int row;   /* it has a place along the route by itself */
    int inner; /* 1: the bend there presses the cable on it, 0: neither on it nor away from it, -1: away */
    Vec3 off;  /* unit, from the route to it */
} SupportRoller;

/* What holds the cable along a length of the route: at each of its places from below, to both sides, from above. */
typedef struct SupportLength {
    double from, to; /* m along the route */
    SupportKind kind;
    int item;                    /* of the definition's surfaces, or conveyors */
    int sides, above;            /* below is always held */
    double half;                 /* m, from the middle to what is at either side; INFINITY: nothing is */
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

/* Rollers, surfaces and conveyors of the definition must be filled in; both stay. Errors: MEMORY. Give it back with
 * supports_free, also after an error. */
hawser_status supports_build(const SceneDef *def, const Route *route, Supports *out, hawser_error *err);
void supports_free(Supports *map);

/* ------------------------------------------------------------------------------------------------------- rollers */

/* The first roller that stands at s (m along the route) or beyond. */
int supports_from(const Supports *map, double s);
/* Where the next thing begins that carries, after s, m; the route's end if nothing does. */
double supports_next(const Supports *map, double s);
/* Whether a roller of that axis stands upright beside the cable at s. */
int roller_guides_at(const Route *route, const RollerDef *roller, double s);
/* The same of one of a row. */
int roller_is_guide(const Route *route, const RollerDef *roller);
/* On which side of a bend something stands that lies `off` (m, or unit) the route, by the bend's curvature (1/m): 1, on
 * the inner one, where the cable is pressed on it; -1, on the outer; 0, on neither. */
int bend_side(Vec3 off, Vec3 curvature);

/* ------------------------------------------------------------------------------------------- lengths and planes */

/* How many surfaces along the route begin at s or before. */
int supports_along(const Supports *map, double s);
/* The surface along the route at s, NULL if there is none. */
const SurfaceDef *supports_surface(const Supports *map, double s);
/* From s on (m), the end of what is held without a gap by ducts, trays and belts. */
double supports_covered(const Supports *map, double s);
/* The first length at or after s along which the cable is held on its line, to both sides, from *next on, which moves
 * on behind those that end before s; NULL: there is none before the route's end. */
const SupportLength *supports_sides(const Supports *map, double s, int *next);
/* The floor on which the cable comes to lie at a point that is higher above it than `least` (m) and less than `most`;
 * NULL: there is none. */
const SurfaceDef *supports_floor(const Supports *map, Vec3 at, double least, double most);
/* Whether a plane reaches as far as the point, in its own directions. */
int plane_reaches(const SurfaceShape *plane, Vec3 at);

#endif
