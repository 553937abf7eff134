/* How long segments may be: what the places of a route ask for, and how far off a pull with given segments is expected
 * to be. docs/model.md, "Length of segments". */
#ifndef HAWSER_THEORY_STIFFNESS_H
#define HAWSER_THEORY_STIFFNESS_H

#include "theory/supports.h"

/* A bend of the route with what holds one piece of the chain in it. */
typedef struct MeshPlace {
    int piece;             /* of the chain */
    int leg;               /* of the route; -1: none */
    int surface;           /* held by a surface, not by rollers */
    double at;             /* m along the route, where it begins */
    double radius;         /* m, of the bend; of a rod: its least radius of curvature, 0: straight */
    double length;         /* m, of the bend */
    double room;           /* m, from the cable in the middle to either side; NAN: it is held on one side alone */
    double pitch;          /* m between rollers; 0: it is held everywhere */
    int pairs;             /* of rollers on both sides, which hold straight segments (ME13); 0 of a smooth line */
    double reach, play;    /* m, of those: a roller's radius and the cable's; room to either side, the least */
    double wrapped;        /* round one drum or wheel, and nothing else counts: share in (h/R)^2; 0: not so */
    double turn;           /* rad, by which it turns at one roller */
    double tension;        /* N, by the pulling theory at the bend's end */
    double tension_in;     /* N, where it begins */
    double walls[2];       /* by how much the cable changes walls there and there, 0 to 2 (ME2); 0 on rollers */
    double bending_length; /* m, sqrt(EI/T) */
    double diameter;       /* m, of the cable */
    double weight;         /* N/m */
    double mu;             /* friction there */
    ImpactLaw impact;      /* of a roller; of a metre of surface */
    double rod_length;     /* m, of a rod over the half waves that it is to show; 0: no rod */
} MeshPlace;

typedef struct Mesh {
    int n;
    MeshPlace *place; /* [n] owned, by pieces of the chain, then along the route */
    double wave;      /* m, half wave in which a run's cable that is pushed gives way; 0: none. mesh_find has none */
} Mesh;

/* Every place that asks for something, of pieces that come there during the run; the drive of the map's definition must
 * be filled in, its segments need not be. Of a rod the map is empty but for definition and route. Errors: MEMORY. */
hawser_status mesh_find(const Supports *map, Mesh *out, hawser_error *err);
void mesh_free(Mesh *mesh);
/* Share of the tension there by which segments of length h (m) are expected to raise it (ME1)-(ME7), (ME10)-(ME13),
 * (ME15). */
double mesh_error(const MeshPlace *place, double h);
/* Share by which the sag between rollers `pitch` m apart comes out too small (ME9); bending_length as above. */
double mesh_sag_error(double h, double pitch, double bending_length);
/* The longest segment, m, with which all places of a piece together are off by no more than a share `error`, at most
 * MESH_USUAL; and the same for one place. */
double mesh_length(const Mesh *mesh, int piece, double error);
double mesh_place_length(const MeshPlace *place, double error);
/* What `segment: auto` takes for a piece of this length, m (ME8), (ME14). */
double mesh_auto(const Mesh *mesh, const SceneDef *def, int piece);
/* What the segments of the definition are expected to cost: the sum over all places, a share of a pull (N; 0: of the
 * tension at each), and the place with most of it (-1: none). */
double mesh_given(const Mesh *mesh, const SceneDef *def, double pull, int *worst);
/* The place in words: "bend at 31 m, R 3 m, room 2 mm". */
void mesh_describe(const MeshPlace *place, int size, char *text);
/* Errors of the pull: what `segment: auto` aims at, and what a run may have to be trusted. */
static const double MESH_AIM = 0.005, MESH_ALLOWED = 0.02;

/* m: the longest segments of `auto`. */
static const double MESH_USUAL = 0.5;

/* Of a half wave of a cable that is pushed: the longest segment that shows it (ME14). */
static const double MESH_WAVE = 0.15;

/* Segments that `auto` gives a piece at most. */
enum { MESH_SEGMENTS_MAX = 20000 };

#endif
