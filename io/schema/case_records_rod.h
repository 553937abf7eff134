/* What the sections of a rod are read into: see io/schema/case_records.h. */
#ifndef HAWSER_IO_SCHEMA_CASE_RECORDS_ROD_H
#define HAWSER_IO_SCHEMA_CASE_RECORDS_ROD_H

#include "io/schema/case_records.h"

/* A rod in place of a route: docs/rods.md. NAN: not given. */
typedef struct RodRecord {
    int shape; /* a RodShape */
    Vec3 start;
    double heading, slope, radius, pitch, roll, roll_end;
    int stress_free;
    const CaseNode *plane, *points, *tail, *head, *loads, *masses;
} RodRecord;

enum { FIXING_FREE, FIXING_PINNED, FIXING_CLAMPED, FIXING_GUIDED, FIXING_HELD };

typedef struct RodEndRecord {
    int fixing;
    const CaseNode *hold, *motion;
} RodEndRecord;

typedef struct RodMotionRecord {
    DriveRecord drive; /* its value is not used */
    Vec3 direction;
    double move, turn;
} RodMotionRecord;

typedef struct RodLoadRecord {
    DriveRecord drive; /* likewise */
    char name[ROD_NAME_MAX];
    double at, force, moment;
    Vec3 direction;
    int frame; /* 0 dead, 1 follower */
} RodLoadRecord;

typedef struct RodMassRecord {
    double at, mass;
} RodMassRecord;

typedef struct ProbeRecord {
    char name[ROD_NAME_MAX];
    double at;
} ProbeRecord;

#endif
