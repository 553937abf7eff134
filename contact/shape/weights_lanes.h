/* How much of a point of the contact line is whose: the weights of an element's two segments, for LANES elements at
 * once, the same in space and in a plane. docs/model.md, "Contact line". */
#ifndef HAWSER_CONTACT_SHAPE_WEIGHTS_LANES_H
#define HAWSER_CONTACT_SHAPE_WEIGHTS_LANES_H

#include "core/base/lanes.h"

/* The weights of the two bodies (C2), or their derivatives by u. */
typedef struct LaneWeights {
    Lane alpha[2], beta[2];
} LaneWeights;

/* An element's coefficients: of its arc, and of what it has besides (C3). */
typedef struct LaneShares {
    Lane arc, alpha, beta[2][2];
} LaneShares;

LANE_INLINE LaneShares shares_load(const double arc[LANES], const double alpha[LANES], const double beta[2][2][LANES])
{
    LaneShares s = {.arc = lane_load(arc), .alpha = lane_load(alpha)};
    for (int b = 0; b < 2; ++b) {
        s.beta[b][0] = lane_load(beta[b][0]);
        s.beta[b][1] = lane_load(beta[b][1]);
    }
    return s;
}

/* Weights (C2), (C3) and their first derivatives. */
LANE_INLINE void weights_at(const LaneShares *s, Lane u, LaneWeights *w, LaneWeights *w1)
{
    const Lane v = 1 - u;
    w->alpha[1] = s->arc * u * u * (3 - 2 * u) + s->alpha;
    w->alpha[0] = 1 - w->alpha[1];
    w->beta[0] = s->arc * (2 * u * v * v) + s->beta[0][0] + s->beta[0][1] * u;
    w->beta[1] = s->beta[1][0] + s->beta[1][1] * u - s->arc * (2 * u * u * v);
    w1->alpha[1] = s->arc * (6 * u * v);
    w1->alpha[0] = -w1->alpha[1];
    w1->beta[0] = s->arc * (2 * v * (1 - 3 * u)) + s->beta[0][1];
    w1->beta[1] = s->arc * (2 * u * (3 * u - 2)) + s->beta[1][1];
}

/* Second derivatives of the weights: only the arc has them. */
LANE_INLINE LaneWeights weights_second(const LaneShares *s, Lane u)
{
    LaneWeights w2;
    w2.alpha[1] = s->arc * (6 - 12 * u);
    w2.alpha[0] = -w2.alpha[1];
    w2.beta[0] = s->arc * (12 * u - 8);
    w2.beta[1] = s->arc * (12 * u - 4);
    return w2;
}

#endif
