/* What the sections of a case are read into: one plain struct each, filled by the tables of io/schema/case_schema.c.
 * SI units; NAN: not given and without a default. Pointers are values with a form of their own, NULL if not
 * given. Sections that fill parts of SceneDef directly (solver, run) have no struct here. */
#ifndef HAWSER_IO_SCHEMA_CASE_RECORDS_H
#define HAWSER_IO_SCHEMA_CASE_RECORDS_H

#include "io/yaml/yaml_node.h"
#include "sim/def/scene_def.h"

typedef struct FactorRecord {
    double axial, shear, torsion, bending;
} FactorRecord;

typedef struct PreloadRecord {
    double axial, shear_y, shear_z, torsion, bending_y, bending_z;
} PreloadRecord;

/* NAN: by the damping time. */
typedef struct RatioRecord {
    double axial, shear, torsion, bending, at;
} RatioRecord;

typedef struct BendingRecord {
    const CaseNode *table;
} BendingRecord;

typedef struct CableRecord {
    double E, G, d, A, density;              /* the paper's shorthand, eq. 2 */
    double EA, GA, GJ, EI, EI_y, EI_z, mass; /* given directly */
    double damping;
    FactorRecord factor;
    RatioRecord ratio;
    PreloadRecord preload;
    BendingRecord bending;
} CableRecord;

typedef struct PieceRecord {
    char cable[NAME_MAX_LENGTH];
    double length, segment;
    int swivel;
} PieceRecord;

typedef struct RoutePieceRecord {
    char name[ROUTE_NAME_MAX];
    double straight, bend, radius;
    const CaseNode *plane;
} RoutePieceRecord;

typedef struct RouteRecord {
    Vec3 start;
    double heading, slope, head_at;
    const CaseNode *pieces;
} RouteRecord;

typedef struct LeadInRecord {
    int weight; /* 0 full, 1 carried */
    double blend;
} LeadInRecord;

typedef struct FrictionRecord {
    double mu, mu_s, mu_d, v_s, v_d, d_s;
    const CaseNode *law;
} FrictionRecord;

/* NAN: by the profile and the cable. */
typedef struct GrooveRecord {
    double angle, radius, depth;
} GrooveRecord;

/* A roller's spin with its bearing, and its mount. */
typedef struct BearingRecord {
    double friction, journal, torque, speed;
} BearingRecord;

typedef struct SpinRecord {
    double inertia;
    BearingRecord bearing;
} SpinRecord;

typedef struct MountRecord {
    const CaseNode *stiffness;
    double damping, mass, inertia;
} MountRecord;

enum { GUIDE_NONE, GUIDE_INSIDE, GUIDE_BOTH };

typedef struct RollerRowRecord {
    char name[NAME_MAX_LENGTH / 2];
    double from, to, spacing;
    int count; /* 0: by spacing */
    double radius, width, rating;
    int profile; /* a ShapeKind */
    GrooveRecord groove;
    int guide;
    double gap; /* m, of guides */
    const CaseNode *where, *hold_down, *friction, *spin, *mount;
} RollerRowRecord;

typedef struct RollerRecord {
    char name[NAME_MAX_LENGTH];
    Vec3 centre, axis;
    double radius, width, rating;
    int profile; /* a ShapeKind */
    GrooveRecord groove;
    const CaseNode *friction, *spin, *mount;
} RollerRecord;

typedef struct RollersRecord {
    const CaseNode *along, *list;
} RollersRecord;

typedef struct SurfacesRecord {
    const CaseNode *contact, *ducts, *trays, *planes;
} SurfacesRecord;

typedef struct LineContactRecord {
    const CaseNode *k;
    double e, c, d;
} LineContactRecord;

/* A stretch of the route that a duct or tray takes up. */
typedef struct StretchRecord {
    char name[NAME_MAX_LENGTH];
    double from, to, fade;
    const CaseNode *friction;
} StretchRecord;

typedef struct DuctRecord {
    StretchRecord at;
    double radius;
    int place; /* 0 centred, 1 resting */
} DuctRecord;

typedef struct TrayRecord {
    StretchRecord at;
    int section; /* 0 flat, 1 v, 2 u */
    double width, height, angle, radius, depth;
} TrayRecord;

typedef struct PlaneRecord {
    char name[NAME_MAX_LENGTH];
    Vec3 point, normal, along;
    double length, width, fade;
    const CaseNode *friction;
} PlaneRecord;

typedef struct ContactRecord {
    int geometry;
    const CaseNode *k;
    double e, c, d, reach;
    int cable_on_cable;
    const CaseNode *cable_friction;
} ContactRecord;

/* A winch's speed or a tail's tension over time. */
typedef struct DriveRecord {
    double value, from, to;
    int ramp; /* a ProfileKind up to PROFILE_STEP5 */
    const CaseNode *table;
} DriveRecord;

typedef struct WinchRecord {
    DriveRecord drive;
    int grip; /* 0 clamp, 1 axial */
    int take_in;
    double at;
    const CaseNode *tension, *trip;
} WinchRecord;

typedef struct WinchTensionRecord {
    DriveRecord drive;
    double speed_limit, band, drum_mass;
} WinchTensionRecord;

typedef struct TripRecord {
    double force, factor, hold, brake, pause, ramp;
    int restarts, then; /* then: 0 stay, 1 end */
} TripRecord;

typedef struct ConveyorRecord {
    char name[NAME_MAX_LENGTH];
    double from, to, edge, factor, clamp, mu, limit, v_s, v_d, ratio;
    int hold;
    const CaseNode *belt;
} ConveyorRecord;

/* Pieces that belong to one model only are NAN or NULL where they are not given. */
typedef struct ReelRecord {
    DriveRecord drive; /* model weight: how the tension comes in; its value is not used */
    int model;         /* 0 payout, 1 weight */
    double length;     /* model weight */
    double distance, barrel, flange, width, inertia, bearing, v_s;
    int end; /* 0 free, 1 fixed */
    const CaseNode *brake, *back_tension;
} ReelRecord;

typedef struct BrakeRecord {
    DriveRecord drive; /* the set speed */
    int law;           /* a BrakeLaw */
    double torque, over;
} BrakeRecord;

typedef struct DragRecord {
    double force, v_s, v_d, ratio;
} DragRecord;

typedef struct DrivesRecord {
    const CaseNode *winch, *tail, *rope_drag;
} DrivesRecord;

typedef struct OutputRecord {
    double interval, states;
    const CaseNode *stations, *speeds_of, *probes, *rollers_of;
} OutputRecord;

typedef struct StationsRecord {
    double spacing;
    const CaseNode *list;
} StationsRecord;

typedef struct StationRecord {
    char name[NAME_MAX_LENGTH];
    double at;
} StationRecord;

typedef struct PaperRecord {
    double reel, rope;
    const CaseNode *terms;
} PaperRecord;

typedef struct TermRecord {
    char name[PAPER_NAME_MAX];
    double slope, length, arc, from, to;
} TermRecord;

typedef struct RunRecord {
    double duration, steady_from;
    int analysis, load_steps, modes;
    double tolerance;
} RunRecord;

typedef struct TopRecord {
    char title[256];
    const CaseNode *gravity, *cables, *chain, *route, *lead_in, *reel, *rollers, *surfaces, *contact, *friction, *drive,
        *run, *solver, *output, *paper, *conveyors, *theory, *limits, *rod;
    int frame;
} TopRecord;

#endif
