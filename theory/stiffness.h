/* Length of segments: requirements of the places of a route, and the expected error of a pull with given segments.
 * docs/theory.md, "Length of segments". */
#ifndef HAWSER_THEORY_STIFFNESS_H
#define HAWSER_THEORY_STIFFNESS_H

#include "theory/supports.h"

/* A bend of the route with its supports for one piece of the chain. */
typedef struct MeshPlace {
    int piece;          /* of the chain */
    int leg;            /* of the route; -1: none */
    int surface;        /* on a surface, not on rollers */
    double at;          /* m along the route, where it begins */
    double radius;      /* m, of the bend; of a rod: its least radius of curvature, 0: straight */
    double length;      /* m, of the bend */
    double room;        /* m, from the centred cable to either side; NAN: support on one side only */
    double pitch;       /* m between rollers; 0: continuous support */
    int pairs;          /* of rollers on both sides, which hold straight segments (ME13); 0 of a smooth line */
    double reach, play; /* m, of those: a roller's radius plus the cable's; least clearance to either side */
    double wrapped;     /* round one drum or wheel, and nothing else counts: error in units of (h/R)^2; 0: no wheel */
    double turn;        /* rad, turn at one roller */
    double tension;     /* N, by the pulling theory at the bend's end */
    double tension_in;  /* N, where it begins */
    double walls[2];    /* change of walls at both ends, 0 to 2 (ME2); 0 on rollers */
    double bending_length; /* m, sqrt(EI/T) */
    double diameter;       /* m, of the cable */
    double weight;         /* N/m */
    double mu;             /* friction there */
    ImpactLaw impact;      /* of a roller; of a metre of surface */
    double rod_length;     /* m, of a rod divided by the number of its half waves; 0: no rod */
} MeshPlace;

typedef struct SegmentMesh {
    int n;
    MeshPlace *place; /* [n] owned, by pieces of the chain, then along the route */
    double wave;      /* m, half wave of buckling in a run; 0: none. mesh_find sets none */
} SegmentMesh;

/* Finds every place with a requirement, for pieces that reach it during the run. The drive of the map's definition must
 * be filled in, its segments need not be. For a rod the map is empty except definition and route. Errors: MEMORY. */
hawser_status mesh_find(const Supports *map, SegmentMesh *out, hawser_error *err);
void segment_mesh_free(SegmentMesh *mesh);
/* Expected relative increase of the tension there by segments of length h (m), (ME1)-(ME7), (ME10)-(ME13), (ME15). */
double mesh_error(const MeshPlace *place, double h);
/* Relative error by which the sag between rollers `pitch` m apart is too small (ME9); bending_length as above. */
double mesh_sag_error(double h, double pitch, double bending_length);
/* Largest segment, m, with which all places of a piece together have a relative error of at most `error`, at most
 * MESH_USUAL; and the same for one place. */
double mesh_length(const SegmentMesh *mesh, int piece, double error);
double mesh_place_length(const MeshPlace *place, double error);
/* Segment that `segment: auto` takes for this piece, m (ME8), (ME14). */
double mesh_auto(const SegmentMesh *mesh, const SceneDef *def, int piece);
/* Expected error of the definition's segments: the sum over all places relative to a pull (N; 0: to the tension at
 * each), and the place with the largest part (-1: none). */
double mesh_given(const SegmentMesh *mesh, const SceneDef *def, double pull, int *worst);
/* Describes the place as text: "bend at 31 m, R 3 m, room 2 mm". */
void mesh_describe(const MeshPlace *place, int size, char *text);
/* Relative errors of the pull: target of `segment: auto`, and bound for a trusted run. */
static const double MESH_AIM = 0.005, MESH_ALLOWED = 0.02;

/* m: largest segment of `auto`. */
static const double MESH_USUAL = 0.5;

/* Largest segment as a share of the half wave of buckling (ME14). */
static const double MESH_WAVE = 0.15;

/* Largest number of segments that `auto` gives a piece. */
enum { MESH_SEGMENTS_MAX = 20000 };

#endif
