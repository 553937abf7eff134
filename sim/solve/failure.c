#include "sim/solve/failure.h"

#include <cvode/cvode.h>
#include <math.h>
#include <stdio.h>

#include "core/error.h"
#include "sim/equipment/winch.h"

/* Text on known weaknesses of scenes whose steps become too small at segment i. Nothing holds the attitude of a limp
 * cable's head on an axial grip. A limp cable on a roller with the same curvature has no nearest point, see (C6):
 * reported where a roller may touch the cable over more than two segments. */
static const char *hint_for(const Scene *scene, int i)
{
    double largest = 0;
    const int at_head = i >= scene->chain.n - 3;
    if (at_head && scene->winch->present && scene->def.winch.axial_only)
        return " (the head of a limp cable needs drive.winch.grip: clamp)";
    if (scene->contact.geometry != GEOMETRY_SMOOTH) return "";
    for (int r = 0; r < scene->contact.n_rollers; ++r) largest = fmax(largest, scene->contact.roller[r].shape.radius);
    if (!(largest > 2 * scene->chain.half[0])) return "";
    return " (a limp cable bent around a roller over more than two segments needs contact.geometry: cylinder)";
}

static const char *advice_for(int flag)
{
    switch (flag) {
    case CV_CONV_FAILURE:
        return "Newton's iteration did not converge: try a smaller solver.max_step, a softer contact.k or a larger "
               "friction.v_s";
    case CV_ERR_FAILURE:
        return "the error test failed again and again: try a larger solver.accuracy, or a gentler drive";
    case CV_LSETUP_FAIL:
    case CV_LSOLVE_FAIL:
        return "the Newton matrix could not be factored: try --set solver.linear_solver=klu";
    case CV_TOO_CLOSE:
        return "the steps have become too small to move on: try a softer contact.k, less stiffness or a larger "
               "friction.v_s";
    case CV_REPTD_RHSFUNC_ERR:
    case CV_FIRST_RHSFUNC_ERR:
    case CV_RHSFUNC_FAIL:
        return "the forces became infinite: check stiffnesses, masses and the contact law";
    default:
        return "try a smaller solver.max_step or another solver.accuracy";
    }
}

/* Place of the largest error: index of the segment in the whole chain, and the chain among several. */
typedef struct Worst {
    const Scene *scene;
    int among, segment; /* among those simulated, in the whole chain */
    char says[64 + NAME_MAX_LENGTH];
} Worst;

static Worst worst_of(const StepFailure *f)
{
    Worst w = {.among = f->segment};
    w.scene = f->motion->ops->whose(f->motion, &w.among);
    w.segment = w.scene->first + w.among;
    const char *const chain = w.scene->def.strand.name;
    snprintf(w.says, sizeof w.says, "segment %d of %d%s%s%s", w.segment, w.scene->total, *chain ? " of chain '" : "",
             chain, *chain ? "'" : "");
    return w;
}

hawser_status failure_tell(const StepFailure *f, int flag, hawser_error *err)
{
    const Worst w = worst_of(f);
    const Vec3 p = f->motion->ops->place(f->motion, f->y, f->segment);
    error_set(err, HAWSER_ERR_RUN,
              "integration failed at t = %.6g s (step %.3g s), worst at %s near (%.3f, %.3f, %.3f) m: %s%s (%s flag "
              "%d: %s)",
              f->t, f->step, w.says, p.x, p.y, p.z, advice_for(flag), hint_for(w.scene, w.among), f->method, flag,
              f->complaint);
    error_moment(err, f->t, w.segment);
    return HAWSER_ERR_RUN;
}

hawser_status failure_steps_spent(const StepFailure *f, hawser_error *err)
{
    const Worst w = worst_of(f);
    error_set(err, HAWSER_ERR_RUN,
              "solver.max_steps = %ld is used up at t = %.6g s (step %.3g s), the hardest part is %s: raise it or "
              "solver.accuracy, or soften what is stiff there%s",
              w.scene->def.solver.max_steps, f->t, f->step, w.says, hint_for(w.scene, w.among));
    error_moment(err, f->t, w.segment);
    return HAWSER_ERR_RUN;
}
