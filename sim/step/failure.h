/* What to say of a step that failed. */
#ifndef HAWSER_SIM_STEP_FAILURE_H
#define HAWSER_SIM_STEP_FAILURE_H

#include "sim/scene.h"

/* What is known of scenes whose steps become too small at segment i. The head of a limp cable does not keep its
 * direction on an axial grip: the pull follows it. A limp cable on a roller as bent as itself has no point that is
 * nearest, see (C6): said where a roller may take the cable over more than two segments. */
const char *failure_hint(const Scene *scene, int i);
/* What to try after this flag of CVODE's. */
const char *failure_advice(int flag);

#endif
