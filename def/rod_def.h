/* A rod: a chain with its own shape, ends that are held or moved, loads anywhere, and no route. A part of SceneDef
 * (def/scene_def.h). SI; places along the rod are m from its tail; directions are unit vectors. */
#ifndef HAWSER_DEF_ROD_DEF_H
#define HAWSER_DEF_ROD_DEF_H

#include "core/profile.h"
#include "core/vec3.h"

enum { ROD_NAME_MAX = 64 };

typedef enum RodShape { ROD_STRAIGHT, ROD_ARC, ROD_HELIX, ROD_POLYLINE } RodShape;

/* A value over time along or about a direction of the world; the table's arrays are owned. */
typedef struct RodProfile {
    Vec3 direction;
    Profile size;
} RodProfile;

/* A part of an end's motion: along (m) or about (rad) the profile's direction, or as a rate (m/s, rad/s). */
typedef struct RodMotionDef {
    int turns, rates;
    RodProfile by;
} RodMotionDef;

/* Support of an end by the ground: its half-springs in these components, axial first (core/chain.h). */
typedef struct RodEndDef {
    int held[6];
    int pivot; /* equal stiffness in all three translations, so that the end may rotate freely */
    int n_motions;
    RodMotionDef *motions; /* [n_motions], owned */
} RodEndDef;

/* A force (N) or moment (N m) on one cross-section. */
typedef struct RodLoadDef {
    char name[ROD_NAME_MAX];
    double at;
    int moment, follower; /* follower: its direction rotates with the segment */
    RodProfile by;
} RodLoadDef;

typedef struct RodMassDef {
    double at, mass; /* m, kg */
} RodMassDef;

enum { ROD_TAIL, ROD_HEAD };

typedef struct RodDef {
    int present;
    RodShape shape;
    double radius, pitch, plane; /* arc: radius and plane (core/route.h); helix: pitch (m a turn) too */
    int n_points;
    Vec3 *points; /* [n_points], owned; polyline */
    double roll,
        roll_rate;   /* rad, rad/m: rotation of the cross-section about the axis, relative to twist-free transport */
    int stress_free; /* its shape is free of stress; otherwise it is bent into it from straight */
    RodEndDef end[2];
    int n_loads, n_masses;
    RodLoadDef *loads;  /* owned */
    RodMassDef *masses; /* owned */
} RodDef;

/* ---- The line of a rod at t = 0: straight, arc, helix or polyline. docs/theory.md, "Rods" (RD1), (RD2). */

/* The line, ready to be evaluated; borrows the definition. */
typedef struct RodLine {
    const RodDef *def;
    Vec3 start, forward, left, up; /* m; unit axes at the start: the heading's direction, level to its left, up */
} RodLine;

typedef struct RodPlace {
    Vec3 position, tangent; /* m, unit */
} RodPlace;

/* Builds the line; heading and slope in rad as for routes; a polyline has its own. */
RodLine rod_line(const RodDef *def, Vec3 start, double heading, double slope);
/* The line at arc length s (m); it continues straight before a polyline's first point and past its last. */
RodPlace rod_line_at(const RodLine *line, double s);
/* Length of a polyline, m. */
double rod_points_length(int n, const Vec3 *point);
/* First s beyond `from` at a distance of `chord` (m > 0) from the line at `from`. */
double rod_line_chord(const RodLine *line, double from, double chord);

#endif
