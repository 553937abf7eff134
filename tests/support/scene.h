/* The scenes of the tests, made in code over SceneDef: a pull over a slope, a crest and a bend (and the same in a
 * plane), a free chain, rollers that move, a pull from a reel, a rod, a rope wound on a drum, a row of rollers. A test
 * changes what it is about in the definition that it gets; fixture_build takes the definition apart.
 * And states in disorder. */
#ifndef HAWSER_TESTS_SUPPORT_SCENE_H
#define HAWSER_TESTS_SUPPORT_SCENE_H

#include "sim/scene.h"
#include "tests/support/chain.h"

enum { FIXTURE_CABLE = 24, FIXTURE_ROPE = 8, FIXTURE_SEGMENTS = FIXTURE_CABLE + FIXTURE_ROPE };

/* Where the scene stands, and which of the choices it makes. Zeros: at the origin, smooth, symmetric, real stiffness.
 */
typedef struct FixtureChoice {
    ContactGeometry geometry;
    BushingFrame frame;
    int soft; /* stiffness and friction speeds for which finite differences see every term */
    Vec3 start;
    double heading;
    double accuracy; /* 0: the default */
    double ahead;    /* m, by which the chain lies further along the route */
} FixtureChoice;

/* An array of count zeroed items that scene_def_clear will free. */
void *fixture_array(int count, size_t size);

/* A cable whose rigidities are `scale` times those of EI = 10 kN m2. */
CableDef fixture_cable(double scale, double mass, double diameter);

/* A roller that touches the cable at route coordinate s from direction `from` (unit, across the route). */
RollerDef fixture_roller(const SceneDef *def, Vec3 place, Vec3 from, Vec3 axis);

/* Stiffness of order 1e4, gentle laws: every term of a derivative stands out of rounding. */
void fixture_soften(SceneDef *def);

/* 24 segments of cable with the eye at 9 m, so that 3 m lie behind the start; 8 of rope up to 13 m, with a swivel. */
void fixture_pull(SceneDef *def, const FixtureChoice *choice);

/* n segments of 0.5 m that nothing holds or touches, undamped, weightless. */
void fixture_free_chain(SceneDef *def, int n);

/* Builds the scene and takes the definition apart. */
void fixture_build(SceneDef *def, Scene *scene);

/* fixture_pull, but the route's bend to the left becomes a sag, and all rollers lie below the route, some off centre.
 */
void fixture_planar(SceneDef *def, const FixtureChoice *choice);
void roller_spin(RollerDef *roller);
void roller_mount(RollerDef *roller);

/* Rollers in turn: fixed, spinning, mounted, both. Nothing if neither is wanted. */
void fixture_moving_rollers(SceneDef *def, int spins, int mounts);

/* A roller of 20 m below the cable between the others: capsules touch it side by side. */
void fixture_sheave(SceneDef *def, double depth);

/* Zeros: the whole cable lies there from the start, the rope runs on. */
typedef struct ReelChoice {
    int payout, take_in;
    double cable, rope; /* m; 0: 20 and 10 */
    double head_at;     /* m; 0: 6 */
    double inertia;     /* kg m2; 0: 40 */
    BrakeLaw brake;
    double torque, at_speed; /* N m, m/s */
    double bearing;          /* N m */
    double tension;          /* N, back tension, through STEP over the first second */
    double speed;            /* m/s of the winch; 0: 0.2 */
    double accuracy;         /* 0: the default */
    double mu;               /* < 0: none; 0: 0.2 */
    int segments_per_metre;  /* 0: 2 */
    int fixed;
} ReelChoice;
void reel_pull(SceneDef *def, const ReelChoice *c);

/* Zeros: weightless, EA = GA = 1 MN, GJ = EI = 1 kN m2, straight along x, clamped at the tail. */
typedef struct RodFixture {
    int n;
    double length;
    RodDef rod; /* shape, ends; its arrays become the definition's */
    double ea, ga, gj, ei_y, ei_z, mass;
    Vec3 gravity;
    int steps;
} RodFixture;
void rod_define(SceneDef *def, const RodFixture *f);

/* Holds an end: "clamped" or "pinned". */
void rod_hold(RodEndDef *end, int pinned);

/* A load that grows from nothing at t = 0 to `size` at t = 1 s. The rod must have room for it. */
void rod_load(RodDef *rod, double at, int moment, int follower, Vec3 direction, double size);

/* The rope that is wound, and the torque of its drum: m, m, N m, N m2. */
static const double WOUND_DIAMETER = 0.05, WOUND_SEGMENT = 0.125, WOUND_TORQUE = 100, WOUND_RIGIDITY = 5;

/* A rope, most of it on a drum of half a metre, `turns` a layer. */
void wound_case(SceneDef *def, int n, double turns, double pulled);

/* The pull that the drum asks for at this radius (CC25): the brake's torque per length of cable that a turn of the drum
 * gives, and the work of straightening the joints, which rest as they lay. */
double wound_pull_at(double radius);

typedef struct RowChoice {
    int segments; /* of 0.5 m */
    double slope; /* rad */
    double pitch; /* m between rollers */
    double mu;
    ContactGeometry geometry;
} RowChoice;

static const double ROW_MASS = 46.67, ROW_G = 9.81; /* kg/m, m/s2 */

/* Weight of the whole cable, N. */
double row_weight(const RowChoice *c);

/* The paper's heavy cable with EI = 300 kN m2; rollers from before its tail to 6 m past its head. */
void row_scene(SceneDef *def, const RowChoice *c);

/* Attitude of segment i in a state of n. */
Quat state_quat(const double *y, int n, int i);
void state_set_quat(double *y, int n, int i, Quat q);

/* Three entries of array group `at` (STATE_P, STATE_V or STATE_W) of segment i. */
Vec3 state_vec(const double *y, int n, int at, int i);
void state_set_vec(double *y, int n, int at, int i, Vec3 v);

/* Moves every segment by up to `shift` (m), turns it by up to `turn` (rad) and gives it velocities of up to `speed`
 * (m/s) and `spin` (rad/s); x, y, z each. */
void state_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed);

/* Moves one coordinate of segment i by e: c = 0..2 shifts it (m), 3..5 turns it about a world axis (rad), 6..8 changes
 * its velocity (m/s), 9..11 its angular velocity (rad/s). */
void state_nudge(double *y, int n, int i, int c, double e);

/* Shakes a planar state, as state_shake does one in space. */
void planar_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed);

/* The equipment in disorder, as state_shake does it to segments. */
void equipment_shake(const Scene *scene, double *y, double shift, double turn, double speed, double spin,
                     uint64_t *seed);

/* A simulation of the definition, which is taken apart; sim_at_rest: after the relaxation. */
hawser_sim *sim_made(SceneDef *def, int threads);
hawser_sim *sim_at_rest(SceneDef *def, int threads);

#endif
