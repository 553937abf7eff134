/* Elements in plan: (AL1), (AL2) of docs/model/16-alignments.md. */
#include "survey/alignment.h"

#include <math.h>

/* Gauss-Legendre, eight points on [-1, 1]: exact for polynomials up to degree 15. */
static const double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

static const double TURN = 6.28318530717958647692;

enum { PARTS_MOST = 4000 }; /* of what turns 300 times; files with more than 100 are refused (survey/read) */

/* The heading s metres on, (AL1). */
static double heading_at(const PlanElement *e, double s)
{
    return e->heading + s * (e->k0 + 0.5 * s * (e->k1 - e->k0) / e->length);
}

/* The way from s to s + h, over which the heading changes by less than half a radian: error below 1e-15 h. */
static void way_add(const PlanElement *e, double s, double h, double *x, double *y)
{
    for (int i = 0; i < 8; ++i) {
        const double u = i % 2 ? node[i / 2] : -node[i / 2];
        const double angle = heading_at(e, s + 0.5 * h * (1 + u));
        *x += 0.5 * h * weight[i / 2] * cos(angle);
        *y += 0.5 * h * weight[i / 2] * sin(angle);
    }
}

PlanElement plan_at(const PlanElement *e, double s)
{
    PlanElement at = *e;
    const double rate = (e->k1 - e->k0) / e->length;
    const double rounds = trunc(s * e->k0 / TURN);
    const double way = rate == 0 && rounds != 0 ? s - rounds * TURN / e->k0 : s; /* after a circle it is where it was */
    const double turn = fabs(way) * fmax(fabs(e->k0), fabs(e->k0 + way * rate));
    const int parts = (int)fmin(PARTS_MOST, 1 + 2 * turn);
    for (int i = 0; i < parts; ++i) way_add(e, i * way / parts, way / parts, &at.x, &at.y);
    at.heading = heading_at(e, s);
    at.k0 = e->k0 + s * rate;
    return at;
}

void alignment_chain(Alignment *a)
{
    for (int i = 1; i < a->n_plan; ++i) {
        const PlanElement end = plan_at(&a->plan[i - 1], a->plan[i - 1].length);
        a->plan[i].x = end.x;
        a->plan[i].y = end.y;
        a->plan[i].heading = end.heading;
    }
}
