#include "sim/step/failure.h"

#include <cvode/cvode.h>
#include <math.h>

#include "sim/equipment/winch.h"

const char *failure_hint(const Scene *scene, int i)
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

const char *failure_advice(int flag)
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
