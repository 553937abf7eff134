/* What a simulation is told while it runs, and how what has come of it is saved. docs/model.md, "Control". */
#ifndef HAWSER_SIM_COMMAND_H
#define HAWSER_SIM_COMMAND_H

#include <string.h>

#include "core/profile.h"
#include "hawser/hawser.h"
#include "sim/def/command_def.h"

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
} ControlsVisit;

static inline void controls_bytes(ControlsVisit *visit, void *bytes, size_t size)
{
    visit->size += size;
    if (!visit->at) return;
    if (visit->load) {
        memcpy(bytes, visit->at, size);
    } else {
        memcpy(visit->at, bytes, size);
    }
    visit->at += size;
}

/* A profile whose table, if it has one, is the case's. */
static inline void controls_profile(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    controls_bytes(visit, profile, sizeof *profile);
    if (visit->load && profile->kind == PROFILE_TABLE) *profile = *of_case;
}

#endif
