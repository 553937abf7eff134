/* What something does to the motion of the chain. */
#ifndef HAWSER_CORE_PUSH_H
#define HAWSER_CORE_PUSH_H

#include "core/base/vec3.h"

typedef struct Push {
    double power; /* W */
    Vec3 force;   /* N */
} Push;

static inline Push push_sum(Push a, Push b) { return (Push){a.power + b.power, v3_add(a.force, b.force)}; }

#endif
