/* Small scenes for the tests of contact: a chain with rollers, with itself, or with surfaces along a route, and
 * everything that a call needs. */
#ifndef HAWSER_TESTS_SUPPORT_TOUCH_H
#define HAWSER_TESTS_SUPPORT_TOUCH_H

#include "contact/roller.h"
#include "contact/self.h"
#include "contact/surface.h"
#include "tests/support/chain.h"

/* Point of the line at u, m (C1), term by term: missing bodies have no weight. */
Vec3 element_point(const Element *element, const Chain *chain, const Kinematics *kin, double u);

enum { SCENE_ROLLERS_MAX = 4, SCENE_HITS_MAX = 64 };

typedef struct TestScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    ContactPairs pairs;
    ContactModel model;
    ContactRoller roller[SCENE_ROLLERS_MAX];
    Vec3 on_roller[SCENE_ROLLERS_MAX];
} TestScene;

/* A cable of n segments of length h and radius 43.65 mm along x from the origin, at rest; no rollers yet. */
void scene_new(TestScene *s, ContactGeometry geometry, int n, double h);
void scene_free(TestScene *s);

/* One more roller; returns it. */
ContactRoller *scene_roller(TestScene *s, Vec3 centre, Vec3 axis, double radius, double half_width);

/* Candidates for where the chain is now. */
void scene_refresh(TestScene *s);

/* Loads and forces on the rollers. */
void scene_forces(TestScene *s, double friction);

/* The segments' centres joined end to end from `start`, for the axes that are there. */
void scene_join(TestScene *s, Vec3 start);

static const double SELF_RADIUS = 0.04; /* m, of the cable */

typedef struct SelfScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    SelfPairs pairs;
    SelfModel model;
} SelfScene;
void self_new(SelfScene *s, int n, double h);
void self_free(SelfScene *s);
void self_fresh(SelfScene *s);
void self_load(SelfScene *s, double friction);

/* Segment i from a to b. */
void self_place(SelfScene *s, int i, Vec3 a, Vec3 b);

/* Segments first .. first + count - 1 along a straight line from `start`. */
void self_strand(SelfScene *s, int first, int count, Vec3 start, Vec3 direction);

/* A helix about z: radius and pitch in m. */
void self_helix(SelfScene *s, double radius, double pitch);

/* Every segment moved, turned and set in motion at random. */
void self_shake(SelfScene *s, double shift, double speed, uint64_t *seed);

/* Force on segments first .. first + count - 1. */
Vec3 self_force_on(const SelfScene *s, int first, int count);

enum { SURFACES_MAX = 4, PATCHES_MAX = 64 };

static const double CABLE_RADIUS = 0.04;

typedef struct SurfaceScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    Route route;
    SurfacePoints points;
    SurfacePairs pairs;
    SurfaceModel model;
    FrictionLaw friction[SURFACES_MAX];
    SurfacePatch patch[PATCHES_MAX];
    SurfaceTally tally[SURFACES_MAX];
} SurfaceScene;

/* A cable of n segments of length h along x from the origin, at rest, 40 mm thick from axis to skin; no surface yet. */
void surfaces_new(SurfaceScene *s, int n, double h);

/* The points, for the sizes that the chain has now. */
void surfaces_points(SurfaceScene *s, ContactGeometry geometry);
void surfaces_free(SurfaceScene *s);
void surfaces_route(SurfaceScene *s, int n, const RoutePieceDef *piece, double slope);

/* A shape of a kind with every number set, for a cable of 40 mm: it bears the cable's centre on the route, but for the
 * duct, whose centre is there. */
SurfaceShape surfaces_shape(SurfaceKind kind, double from, double to);

/* One more surface; friction 0.25, 0.2. */
void surfaces_add(SurfaceScene *s, const SurfaceShape *shape);
void surfaces_refresh(SurfaceScene *s);

/* Loads, and what every surface feels. */
void surfaces_forces(SurfaceScene *s, double friction);

/* Lays the chain along the route from s0 on, moved by `off` across it (y left, z up); centres and axes only. */
void surfaces_lay(SurfaceScene *s, double s0, double left, double up);

#endif
