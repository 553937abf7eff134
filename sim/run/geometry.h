/* A surface of triangles that grows piece by piece: rows of points that are joined to nets, and boxes. */
#ifndef HAWSER_SIM_RUN_GEOMETRY_H
#define HAWSER_SIM_RUN_GEOMETRY_H

#include "core/vec3.h"
#include "sim/scene.h"

/* What a triangle is of. */
typedef enum SkinPart { SKIN_ROLLER, SKIN_SURFACE, SKIN_CONVEYOR, SKIN_REEL } SkinPart;

typedef struct Skin {
    int n_points, n_triangles;
    double *points; /* [3 n_points] m */
    int *triangle;  /* [3 n_triangles] points, counter-clockwise seen from outside */
    int *part;      /* [n_triangles] a SkinPart */
    int *item;      /* [n_triangles] which roller, surface, ... */
    int room_points, room_triangles;
    int failed; /* no memory: nothing more is added */
    SkinPart now_part;
    int now_item;
} Skin;

/* A cross-section (y, z) of m points, closed or not, carried along n places with their own axes y and z. */
typedef struct SkinPlace {
    Vec3 middle, y, z;
    double scale; /* of the section here */
} SkinPlace;

/* What stands around the cable, as plain data for those who draw it: the route, rollers, obstacles, ducts and trays,
 * conveyors, the reel and the winch, and the chain's own sizes. Lengths in m, all coordinates those of the results;
 * what moves stands where it begins. docs/reference/results.md, "results.h5", lists it set by set. */

/* A line through these points leaves the route by at most the first; never more points than the second. */
#define GEOMETRY_SAGITTA 0.01
enum { GEOMETRY_POINTS_MAX = 20000 };

typedef char GeometryText[NAME_MAX_LENGTH];

/* A duct, tray or plane: the middle of its bottom (duct: of its bore) along its way. */
typedef struct GeometrySurface {
    GeometryText name, kind, section; /* kind: duct, tray, floor, wall, ceiling; section: as surfaces[].kind */
    double from, to;                  /* m along the route; NAN: a plane */
    double diameter;                  /* m inside, of duct and U; NAN: none */
    double width, height;             /* m over all, and of its sides; NAN: none */
    double normal[3];                 /* unit, toward the cable, at the first point */
    int endless;                      /* a plane that was cut off for the picture */
    int n;
    double *points, *up; /* [3n] m; unit, upward in its section */
} GeometrySurface;

typedef struct GeometryReel {
    int present;
    double centre[3], axis[3];    /* m; unit */
    double barrel, flange, width; /* m, radii; between the flanges */
} GeometryReel;

typedef struct GeometryWinch {
    int present;
    double position[3], direction[3]; /* m; unit, of the pull */
} GeometryWinch;

typedef struct Geometry {
    int n_route;                                           /* 0: a rod */
    double *route_s, *route_position, *route_curvature;    /* [n], [3n], [n] 1/m */
    int n_rollers;                                         /* obstacles too, as in the results' tables */
    GeometryText *roller_name, *roller_kind;               /* roller, hold-down, box, bell-mouth */
    double *roller_s;                                      /* NAN: by coordinates */
    double *roller_position, *roller_axis;                 /* [3n] m, unit */
    double *roller_radius, *roller_width, *roller_groove;  /* m; groove: its depth */
    double *roller_rating;                                 /* N; NAN: none */
    int n_obstacles;                                       /* boxes and bell-mouths among the rollers */
    int *obstacle_roller;                                  /* which */
    double *obstacle_side, *obstacle_size, *obstacle_edge; /* [3n] unit; [3n] m along axis, side and both; m */
    double *obstacle_ring;                                 /* m, of a bell-mouth; NAN: a box */
    int n_surfaces;
    GeometrySurface *surface;
    int n_conveyors;
    GeometryText *conveyor_name;
    double *conveyor_from, *conveyor_to, *conveyor_points; /* m along the route; [6n] both ends */
    GeometryReel reel;
    GeometryWinch winch;
    int n_segments;
    double *length, *diameter; /* [n] m */
    int *part, *piece;         /* [n] 0 cable, 1 rope; which piece of the chain */
    int n_pieces;
    GeometryText *piece_name; /* of its cable or rope */
    Skin skin;                /* all of it as triangles */
    int n_owned;
    void **owned; /* [n_owned] all arrays but the mesh's */
} Geometry;

/* Errors: MEMORY. */
hawser_status geometry_make(const Scene *scene, Geometry *out, hawser_error *err);
void geometry_free(Geometry *g);
/* Of a segment of the whole chain, m, unstretched. */
double geometry_length(const Scene *scene, int segment);

#endif
