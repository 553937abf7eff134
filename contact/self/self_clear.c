/* What need not be looked at: stretches of two lines that were some gap apart, and have not come nearer by as much.
 * docs/model.md, "Cable on cable", (CC27), (CC28). */
#include <string.h>

#include "contact/self/self_contact.h"

enum { CONTROLS = 4 };

static int ranges_from(const SelfPairs *pairs, int part) { return part == 0 ? 0 : pairs->half; }
static int ranges_to(const SelfPairs *pairs, int part) { return part == 0 ? pairs->half : pairs->n_ranges; }

/* The corners of a hull that holds element e: those of its cubic's Bezier form, or the ends of an end half. */
static int controls_of(const SelfLine *line, int e, Vec3 at[CONTROLS])
{
    const Chain *const chain = line->chain;
    int count = 0;
    const double share = e > 0 && e < chain->n ? 2.0 / 3 : 1;
    for (int b = 0; b < 2; ++b) {
        const int i = e - 1 + b;
        if (i < 0 || i >= chain->n) continue;
        const Vec3 centre = v3_load(line->kin->p, i);
        at[count++] = centre;
        at[count++] = v3_axpy(centre, (b ? -share : share) * chain->half[i], v3_load(line->kin->a, i));
    }
    return count;
}

/* How far the elements of a range are beyond the plane across n from the range's own element, m. */
static double apart_along(const SelfLine *mine, const SelfLine *other, const SelfRange *range, Vec3 n)
{
    Vec3 at[CONTROLS];
    double front = -INFINITY, back = INFINITY;
    for (int c = controls_of(mine, range->element, at) - 1; c >= 0; --c) front = fmax(front, v3_dot(n, at[c]));
    for (int f = range->first; f < range->first + range->count; ++f)
        for (int c = controls_of(other, f, at) - 1; c >= 0; --c) back = fmin(back, v3_dot(n, at[c]));
    return back - front;
}

/* At least the gap between the surfaces of a range's two sides (CC27): along what joins the middle of its own element
 * to the nearest point on the other side's centres. */
static double gap_of(const SelfLine *mine, const SelfLine *other, const SelfRange *range)
{
    Vec3 at[CONTROLS];
    const int count = controls_of(mine, range->element, at);
    const Vec3 middle = v3_scale(0.5, v3_add(at[0], at[count / 2]));
    Vec3 to = V3_ZERO;
    double nearest = INFINITY;
    for (int f = range->first; f < range->first + range->count; ++f) {
        const int corners = controls_of(other, f, at);
        const Vec3 along = v3_sub(at[corners / 2], at[0]), from = v3_sub(middle, at[0]);
        const double share = fmin(1, fmax(0, v3_dot(from, along) / v3_dot(along, along)));
        const Vec3 off = v3_sub(v3_scale(share, along), from);
        if (!(v3_dot(off, off) < nearest)) continue;
        nearest = v3_dot(off, off);
        to = off;
    }
    if (!(nearest > 0)) return 0;
    const double radii = self_radius_most(mine->chain, range->element - 1, range->element) +
                         self_radius_most(other->chain, range->first - 1, range->first + range->count);
    return apart_along(mine, other, range, v3_scale(1 / sqrt(nearest), to)) - radii;
}

/* The largest |x - x_0 - base|^2 and |r - r_0|^2 of segments from..to of a line, as far as they exist. */
static void moves_of(const SelfLine *line, const double *at, int from, int to, const double base[3], double *shift,
                     double *turn)
{
    const Kinematics *const kin = line->kin;
    for (int i = from < 0 ? 0 : from; i <= to && i < line->chain->n; ++i) {
        const double *const was = at + 6 * (line->row + i), half = line->chain->half[i];
        const double x = kin->p[0][i] - was[0] - base[0], y = kin->p[1][i] - was[1] - base[1];
        const double z = kin->p[2][i] - was[2] - base[2], a = half * kin->a[0][i] - was[3];
        const double b = half * kin->a[1][i] - was[4], c = half * kin->a[2][i] - was[5];
        const double moved = x * x + y * y + z * z, turned = a * a + b * b + c * c;
        *shift = *shift > moved ? *shift : moved;
        *turn = *turn > turned ? *turn : turned;
    }
}

int self_clear_apart(const SelfLines *lines, int part, const SelfPairs *pairs, int r)
{
    const SelfClear *const clear = &pairs->clear[part];
    const double gap = clear->gap[r - ranges_from(pairs, part)];
    if (!(gap > 0)) return 0;
    const SelfRange *const range = &pairs->range[r];
    const SelfLine *const mine = &lines->line[range->line], *const other = &lines->line[range->other];
    const int first = range->element > 0 ? range->element - 1 : 0;
    const double *const was = clear->at + 6 * (mine->row + first);
    double base[3], shift[2] = {0, 0}, turn[2] = {0, 0};
    for (int c = 0; c < 3; ++c) base[c] = mine->kin->p[c][first] - was[c];
    moves_of(mine, clear->at, range->element - 1, range->element, base, &shift[0], &turn[0]);
    moves_of(other, clear->at, range->first - 1, range->first + range->count - 1, base, &shift[1], &turn[1]);
    return gap > sqrt(shift[0]) + sqrt(shift[1]) + sqrt(turn[0]) + sqrt(turn[1]); /* (CC28); not for a NaN */
}

void self_clear_look(const SelfLines *lines, int part, SelfPairs *pairs)
{
    SelfClear *const clear = &pairs->clear[part];
    const int from = ranges_from(pairs, part), to = ranges_to(pairs, part);
    if (clear->known && clear->vain <= to - from) return;
    for (int l = 0; l < lines->n; ++l) {
        const SelfLine *const line = &lines->line[l];
        for (int i = 0; i < line->chain->n; ++i) {
            double *const at = clear->at + 6 * (line->row + i);
            v3_put(at, v3_load(line->kin->p, i));
            v3_put(at + 3, v3_scale(line->chain->half[i], v3_load(line->kin->a, i)));
        }
    }
    for (int r = from; r < to; ++r) {
        const SelfRange *const range = &pairs->range[r];
        clear->gap[r - from] = gap_of(&lines->line[range->line], &lines->line[range->other], range);
    }
    clear->known = 1;
    clear->vain = 0;
}
