/* What a simulation is told while it runs, and how what has come of it is saved. docs/model.md, "Control". */
#ifndef HAWSER_SIM_COMMAND_H
#define HAWSER_SIM_COMMAND_H

#include <string.h>

#include "core/profile.h"
#include "def/command_def.h"
#include "hawser/hawser.h"

/* From the value that a profile has at t to another over the ramp (K1). */
static inline Profile command_ramp(const Profile *now, double t, double to, double ramp)
{
    return (Profile){.kind = PROFILE_STEP, .t0 = t, .v0 = profile_value(now, t), .t1 = t + ramp, .v1 = to};
}
static inline Profile profile_level(double value) { return (Profile){.kind = PROFILE_CONSTANT, .v1 = value}; }

/* Goes over what commands have changed, in a fixed order: to take it out of a scene, to put it into one that was built
 * from the same case, or, with `at` NULL, to count the bytes. Nothing of it may point anywhere. */
typedef struct ControlsVisit {
    unsigned char *at; /* where the next byte goes or comes from */
    size_t size;       /* bytes so far */
    int load;
    size_t room; /* bytes that there are to load */
    int wrong;   /* what was loaded cannot be: nothing more is */
} ControlsVisit;

static inline void controls_bytes(ControlsVisit *visit, void *bytes, size_t size)
{
    visit->size += size;
    if (visit->load && (visit->size > visit->room || visit->wrong)) visit->wrong = 1;
    if (!visit->at || visit->wrong) return;
    if (visit->load) {
        memcpy(bytes, visit->at, size);
    } else {
        memcpy(visit->at, bytes, size);
    }
    visit->at += size;
}

/* A number of 0 .. most: of something's items, or of an enumeration; what is loaded and is none of these is 0. */
static inline void controls_count(ControlsVisit *visit, int *n, int most)
{
    controls_bytes(visit, n, sizeof *n);
    if (visit->load && (*n < 0 || *n > most)) visit->wrong = 1;
    if (visit->wrong) *n = 0;
}

/* What was loaded as a profile, with the case's table if it has one. */
static inline void controls_profile_mend(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    if (!visit->load) return;
    if (!profile_is_one(profile)) visit->wrong = 1;
    if (profile->kind == PROFILE_TABLE && of_case->kind != PROFILE_TABLE) visit->wrong = 1;
    if (visit->wrong || profile->kind == PROFILE_TABLE) *profile = *of_case;
}

/* A profile whose table, if it has one, is the case's. */
static inline void controls_profile(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    controls_bytes(visit, profile, sizeof *profile);
    controls_profile_mend(visit, profile, of_case);
}

#endif
