/* Detailed tables of a simulation between two steps; part of hawser/hawser.h, which includes it. A table is computed
 * only when it is requested. It stays the simulation's and is valid until the same one is requested again or the
 * simulation advances; a row of these tables never grows (docs/guide/c.md, "Growing"). World components, SI. */
#ifndef HAWSER_QUERY_H
#define HAWSER_QUERY_H

#include "hawser/route.h"
#include "hawser/status.h"
#include "hawser/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_sim;

typedef enum hawser_partner {
    HAWSER_ON_ROLLER = 1,
    HAWSER_ON_SURFACE = 2,
    HAWSER_ON_CABLE = 3,
    HAWSER_ON_ENVIRONMENT = 4 /* a model of the case: its index is -1 */
} hawser_partner;

/* A place where the cable is pressed. */
typedef struct hawser_contact {
    hawser_partner partner;
    int index;           /* number in hawser_sim_rollers or hawser_sim_surfaces, or the other segment */
    int segment;         /* number in the whole chain: the nearer of the two segments that carry the place */
    double point_m[3];   /* on the cable's middle line */
    double normal[3];    /* unit, toward the cable */
    double normal_N;     /* size of the normal force */
    double force_N[3];   /* on the cable, friction included */
    double slip_m_per_s; /* slip of the cable's surface over the partner's */
    double gap_m;        /* below 0 where it is compressed */
} hawser_contact;

/* Lists all contacts that carry force now: on rollers, then on surfaces (two places for each segment that lies on one),
 * then of the cable with itself. *n: how many. Errors: INPUT (NULL), MEMORY. */
hawser_status hawser_sim_contacts(struct hawser_sim *s, const hawser_contact **out, int *n, hawser_error *err);

/* The cable at one joint. Force and moment are those by which the part ahead acts on the part behind. */
typedef struct hawser_cable_point {
    double from_tail_m; /* unstretched */
    double along_m;     /* along the route; NAN: a rod */
    double position_m[3];
    double tension_N, shear_N;
    double torsion_N_m, bending_N_m; /* torsion about the cable's axis; size of the moment across it */
    double curvature_per_m;
    double sidewall_N_per_m; /* tension over the radius of the route's bend; 0 on the rope */
} hawser_cable_point;

/* Lists the joints that are simulated now, starting at the tail; *first: the number of the first in the whole chain.
 * Errors: as above. */
hawser_status hawser_sim_cable(struct hawser_sim *s, const hawser_cable_point **out, int *n, int *first,
                               hawser_error *err);

/* Least value, mean over time and largest value at a place or joint, in the unit of its name; NAN: nothing was
 * recorded. */
typedef struct hawser_extremes {
    const double *least, *mean, *largest; /* [n] */
} hawser_extremes;
typedef struct hawser_envelope {
    int n;
    const double *at_m;   /* [n] from the tail, or along the route */
    const double *time_s; /* [n] time over which the means are taken */
    hawser_extremes tension_N, curvature_per_m, sidewall_N_per_m;
} hawser_envelope;
/* Adds each row of the run (hawser_sim_record) to the envelope from now on. Errors: INPUT (NULL), MEMORY. */
hawser_status hawser_sim_watch_envelope(struct hawser_sim *s, hawser_error *err);
/* Returns the envelope by joints of the cable, or by places along the route. Errors: INPUT (hawser_sim_watch_envelope
 * was not called before the rows). */
hawser_status hawser_sim_envelope(const struct hawser_sim *s, int along_route, hawser_envelope *out, hawser_error *err);

/* The equipment around the cable, as it was built; rollers on mounts and reels have their initial place. */
typedef struct hawser_roller_shape {
    const char *name, *kind;                        /* "roller", "hold-down", "box", "bell-mouth" */
    double along_m;                                 /* NAN: placed by coordinates */
    double centre_m[3], axis[3], radius_m, width_m; /* axis: unit */
} hawser_roller_shape;
typedef struct hawser_surface_shape {
    const char *name, *kind;              /* "duct", "tray", "floor", "wall", "ceiling" */
    double from_m, to_m;                  /* along the route; NAN: a plane */
    double diameter_m, width_m, height_m; /* inner; overall; of the sides; NAN: none */
    int n;                                /* points of its middle line */
    const double *points_m, *up;          /* [3n]; unit vectors */
} hawser_surface_shape;
typedef struct hawser_conveyor_shape {
    const char *name;
    double from_m, to_m, in_m[3], out_m[3]; /* along the route; entry and exit of the cable */
} hawser_conveyor_shape;
typedef struct hawser_geometry {
    int rollers, surfaces, conveyors, segments;
    const hawser_roller_shape *roller;
    const hawser_surface_shape *surface;
    const hawser_conveyor_shape *conveyor;
    const double *length_m, *diameter_m; /* [segments] */
    int has_winch, has_reel;
    double winch_m[3], winch_direction[3];                                      /* direction: unit */
    double reel_m[3], reel_axis[3], reel_barrel_m, reel_flange_m, reel_width_m; /* radii; width between the flanges */
} hawser_geometry;
/* Returns the geometry; *out is the simulation's as long as it lives. Errors: INPUT (NULL), MEMORY. */
hawser_status hawser_sim_geometry(struct hawser_sim *s, const hawser_geometry **out, hawser_error *err);

/* Returns how many positions a run with `analysis: positions` has so far; *out lists them along the route, stays the
 * simulation's and is valid until it advances again. */
int hawser_sim_places(const struct hawser_sim *s, const struct hawser_place **out);

/* Return the length of the route, and the place at s_m from its start; it goes on straight beyond its ends. Errors:
 * INPUT (NULL, s_m is not finite, a rod has no route). */
hawser_status hawser_sim_route_length(const struct hawser_sim *s, double *length_m, hawser_error *err);
hawser_status hawser_sim_route_at(const struct hawser_sim *s, double s_m, hawser_route_place *out, hawser_error *err);

/* Returns how many chains there are; 1: a single one. The simulation of several chains that are pulled together
 * (docs/guide/several-cables.md) is that of the first, and moves all of them. */
int hawser_sim_chains(const struct hawser_sim *s);
/* Returns the simulation of chain k, from 0, which belongs to the first: it can be read and given commands, but not
 * advanced; NULL: there is none. */
struct hawser_sim *hawser_sim_chain(struct hawser_sim *s, int k);
/* Returns its name; empty where there is one chain. */
const char *hawser_sim_chain_name(const struct hawser_sim *s);

#ifdef __cplusplus
}
#endif

#endif
