/* The data of a scene (sim/scene.h), shared by those who build it. */
#ifndef HAWSER_SIM_SCENE_DATA_H
#define HAWSER_SIM_SCENE_DATA_H

#include "contact/roller/contact.h"
#include "contact/self/self_contact.h"
#include "core/body.h"
#include "sim/equipment/conveyor.h"
#include "sim/equipment/drum.h"
#include "sim/equipment/moving_rollers.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/surfaces.h"
#include "sim/equipment/take_in.h"

/* Gravity along the chain: the whole weight from the route's start on; behind it what the lead-in leaves, and the
 * lead-in's hold on the cable across its line (F1). */
typedef struct Weight {
    Vec3 gravity;        /* m/s2 */
    int lead_in;         /* 0: full gravity everywhere */
    Vec3 behind;         /* gravity that acts behind the start, m/s2: none, or its part along the lead-in */
    Vec3 origin;         /* the route's start, m */
    Vec3 direction;      /* the route's first tangent */
    double blend;        /* m, over which the weight comes in */
    double hold;         /* 1/s2: the lead-in\'s stiffness across its line over the mass it holds */
    double hold_damping; /* 1/s: its damping over mass */
} Weight;

typedef struct Drag {
    int segment;     /* of those simulated; -1: none */
    double force;    /* N */
    FrictionLaw law; /* mu_s = 1 */
} Drag;

/* Numbers: segments and joints of the whole chain are 0..total from the tail. What is simulated may be a part of it
 * (sim/run/stage.h): chain holds segments first..first+chain.n-1 and counts its own from 0. */
typedef struct Scene {
    Chain chain;
    int first, total;     /* 0 and chain.n if nothing is on a reel or past the winch */
    int *piece;           /* [total] the chain piece of each segment */
    double *joint_s;      /* [total+1] route coordinate of each joint at t = 0, if all the chain lay there, m */
    int eye;              /* joint of the pulling eye: first joint of the last piece, total if there is one piece */
    double cable_weight;  /* N/m, of the piece before the eye */
    double largest_speed; /* m/s, of the winch; 0.1 if it never moves or has no limit */
    Route route;
    Weight weight;
    Winch winch;
    Profile tail; /* N; nothing where a reel brings the back tension */
    Reel reel;
    TakeIn take_in;
    Drag drag;
    int n_conveyors;
    Conveyor *conveyor;     /* owned, [n_conveyors] */
    ContactRoller *rollers; /* owned; the contact model borrows them */
    ContactModel contact;
    Surfaces surfaces;
    SelfModel self;      /* cable on cable */
    Drum drum;           /* with the cable wound on it */
    Equipment equipment; /* rollers that move */
    Rod rod;             /* a chain without a route */
    SceneDef def;        /* a deep copy of what this was built from */
} Scene;

#endif
