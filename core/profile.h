/* Time profiles: constants, ADAMS' STEP and STEP5 ramps, tables. docs/theory.md, "Profiles". */
#ifndef HAWSER_CORE_PROFILE_H
#define HAWSER_CORE_PROFILE_H

#include "core/checkpoint.h"

typedef enum ProfileKind { PROFILE_CONSTANT, PROFILE_STEP, PROFILE_STEP5, PROFILE_TABLE } ProfileKind;

/* A value as a function of time. CONSTANT: v1 always. STEP, STEP5: v0 up to t0, v1 from t1 on, the cubic or quintic in
 * between (references: ADAMS STEP). TABLE: n points (time[i], value[i]), times rising strictly, linear in between,
 * constant beyond the ends. The profile of a definition owns its table (one piece of memory, by `time`); a profile that
 * is assigned from it borrows it. */
typedef struct Profile {
    ProfileKind kind;
    double t0, v0; /* s, unit of the value */
    double t1, v1;
    int n;
    double *time;  /* [n], s */
    double *value; /* [n] */
} Profile;

/* STEP(x, x0, h0, x1, h1) of ADAMS: h0 + (h1 - h0) D^2 (3 - 2D); x0 < x1. *slope (may be NULL) gets d/dx. */
double step_cubic(double x, double x0, double h0, double x1, double h1, double *slope);
/* STEP5: h0 + (h1 - h0) D^3 (10 - 15 D + 6 D^2). */
double step_quintic(double x, double x0, double h0, double x1, double h1, double *slope);

/* Makes it a table of n points, all zero, which it owns. Returns 0 if there is no memory; it is then the constant 0. */
int profile_table(Profile *p, int n);
/* Gives a profile that borrows its table a copy of its own. Returns 0 if there is no memory; it then has no table. */
int profile_own(Profile *p);
/* Frees the table that it owns, if it is one. */
void profile_free(Profile *p);

double profile_value(const Profile *p, double t);
/* The largest value at any time; the second: the smallest after the rise from its first value. */
double profile_largest(const Profile *p);
double profile_least_risen(const Profile *p);
/* The smallest value from one time to another, both included; from <= to. */
double profile_least_between(const Profile *p, double from, double to);
/* s, time at which it has risen from its first value; -INFINITY: it never does. */
double profile_risen_at(const Profile *p);
/* The largest size of the given values for times up to `until`. */
double profile_largest_until(const Profile *p, double until);
/* d(value)/dt; at a table's corner, the slope to the right. */
double profile_rate(const Profile *p, double t);
/* Integral of the value from 0 to t (t >= 0), exact for every kind. */
double profile_integral(const Profile *p, double t);
/* Writes the next time after t at which the profile is not smooth (a ramp's end, a table's corner); returns 0 if
 * none. */
int profile_next_corner(const Profile *p, double t, double *corner);
/* The first corner after t, or `next` if that comes first, s. */
double profile_corner_before(const Profile *p, double t, double next);

/* Checks whether loaded data can be a profile: an existing kind, and a step with a duration. */
int profile_is_one(const Profile *p);
/* Saves or loads a profile that changes in a run; if it is a table, its arrays are those of `table`. */
void profile_checkpoint(Checkpoint *c, Profile *p, const Profile *table);

#endif
