/* A surface of triangles that is built piece by piece: nets of point rows, and boxes. */
#ifndef HAWSER_SIM_RUN_GEOMETRY_H
#define HAWSER_SIM_RUN_GEOMETRY_H

#include "core/vec3.h"
#include "sim/scene.h"

/* Body to which a triangle belongs. */
typedef enum SkinPart { SKIN_ROLLER, SKIN_SURFACE, SKIN_CONVEYOR, SKIN_REEL } SkinPart;

typedef struct Skin {
    int n_points, n_triangles;
    double *points; /* [3 n_points] m */
    int *triangle;  /* [3 n_triangles] indices of points, counter-clockwise seen from outside */
    int *part;      /* [n_triangles] a SkinPart */
    int *item;      /* [n_triangles] index of the roller, surface, ... */
    int room_points, room_triangles;
    int failed; /* 1: out of memory; nothing more is added */
    SkinPart now_part;
    int now_item;
} Skin;

/* A cross-section (y, z) of m points, closed or not, carried along n places with their own axes y and z. */
typedef struct SkinPlace {
    Vec3 middle, y, z;
    double scale; /* of the section at this place */
} SkinPlace;

/* Surroundings of the cable as plain data for drawing: the route, rollers, obstacles, ducts and trays, conveyors, the
 * reel and the winch, and the chain's own sizes. Lengths in m, all coordinates as in the results; what moves is at its
 * initial place. docs/reference/columns.md, "results.h5", lists every data set. */

/* Largest distance of a line through the points from the route, m; largest number of points. */
#define GEOMETRY_SAGITTA 0.01
enum { GEOMETRY_POINTS_MAX = 20000 };

typedef char GeometryText[NAME_MAX_LENGTH];

/* A duct, tray or plane: the line along the middle of its bottom (duct: of its bore). */
typedef struct GeometrySurface {
    GeometryText name, kind, section; /* kind: duct, tray, floor, wall, ceiling; section: as surfaces[].kind */
    double from, to;                  /* m along the route; NAN: a plane */
    double diameter;                  /* m, inner, of duct and U; NAN: none */
    double width, height;             /* m, overall, and of its sides; NAN: none */
    double normal[3];                 /* unit, toward the cable, at the first point */
    int endless;                      /* 1: an infinite plane that was cut off for display */
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

/* The environment as it is shown: a mesh of at most about SEEN_TRIANGLES triangles and points. */
enum { SEEN_TRIANGLES = 200000 };

typedef struct GeometrySeen {
    Mesh mesh;
    GeometryText *layer_name; /* [mesh.n_layers], owned */
    int given;                /* triangles and points of the case; 0: it has no environment */
    double error;             /* m, (EN60) */
} GeometrySeen;

typedef struct Geometry {
    int n_route;                                           /* 0: a rod */
    double *route_s, *route_position, *route_curvature;    /* [n], [3n], [n] 1/m */
    int n_rollers;                                         /* including obstacles, as in the results' tables */
    GeometryText *roller_name, *roller_kind;               /* roller, hold-down, box, bell-mouth */
    double *roller_s;                                      /* NAN: by coordinates */
    double *roller_position, *roller_axis;                 /* [3n] m, unit */
    double *roller_radius, *roller_width, *roller_groove;  /* m; groove: its depth */
    double *roller_rating;                                 /* N; NAN: none */
    int n_obstacles;                                       /* boxes and bell-mouths among the rollers */
    int *obstacle_roller;                                  /* their index among the rollers */
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
    int *part, *piece;         /* [n] 0 cable, 1 rope; index of the chain's piece */
    int n_pieces;
    GeometryText *piece_name; /* name of its cable or rope */
    Skin skin;                /* everything but the environment as triangles */
    GeometrySeen seen;
    int n_owned;
    void **owned; /* [n_owned] all arrays but the meshes' */
} Geometry;

/* Errors: MEMORY. */
hawser_status geometry_make(const Scene *scene, Geometry *out, hawser_error *err);
/* Adds the environment to it, simplified. A build that cannot, and a large model: it is not shown, and `given` tells.
 * geometry_free follows. Errors: MEMORY. */
hawser_status geometry_see(Geometry *g, const EnvironmentDef *def, hawser_error *err);
void geometry_free(Geometry *g);
/* Length of a segment of the whole chain, m, unstretched. */
double geometry_length(const Scene *scene, int segment);

#endif
