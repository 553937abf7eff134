/* How far cables lie inside each other, by where their segments are and nothing else: what no contact law has prevented
 * shows here, whether there is none, has lost its force or was too weak. */
#ifndef HAWSER_CONTACT_SELF_SELF_OVERLAP_H
#define HAWSER_CONTACT_SELF_SELF_OVERLAP_H

#include "contact/self/self_contact.h"

/* A straight stretch between two points. */
typedef struct Chord {
    Vec3 from, along; /* m: where it begins, and from there to its end */
} Chord;

static inline double chord_share(double x) { return fmin(1, fmax(0, x)); }

/* m, least distance of two chords: where both perpendiculars meet, or at an end of one of them. */
static inline double chords_apart(const Chord *p, const Chord *q)
{
    const Vec3 between = v3_sub(p->from, q->from);
    const double a = v3_dot(p->along, p->along), b = v3_dot(p->along, q->along), c = v3_dot(q->along, q->along);
    const double d = v3_dot(p->along, between), e = v3_dot(q->along, between), area = a * c - b * b;
    double s = area > 1e-12 * a * c ? chord_share((b * e - c * d) / area) : 0;
    const double t = chord_share((b * s + e) / c);
    s = chord_share((b * t - d) / a);
    const Vec3 apart = v3_sub(v3_axpy(between, s, p->along), v3_scale(t, q->along));
    return v3_norm(apart);
}

typedef struct SelfOverlap {
    double share;        /* (CC29): 1 where centre lines cross; negative: apart */
    int line, segment;   /* of the two lines, */
    int other, opposite; /* segments of them; line -1: nothing is near */
    Vec3 at;             /* m, the middle of the first */
} SelfOverlap;

/* The deepest overlap of two segments, as chords, of the lines given or (lines->within) of one line. Left out: segments
 * of one line that so little lies between that no cable could come back to itself there, and heads that one eye holds
 * (SC9). O(n log n) of lines that are drawn out, O(n^2) of coils. */
SelfOverlap self_overlap(const SelfLines *lines);

#endif
