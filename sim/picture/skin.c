#include "sim/picture/skin.h"

#include <stdlib.h>
#include <string.h>

/* Corners of a circle. */
enum { SKIN_SIDES = 16 };

void skin_begin(Skin *m, SkinPart part, int item)
{
    m->now_part = part;
    m->now_item = item;
}

/* Makes room for so many more; 0 without memory. */
static int room_make(Skin *m, int points, int triangles)
{
    if (m->n_points + points > m->room_points) {
        const int room = 2 * (m->n_points + points);
        double *const more = realloc(m->points, 3 * sizeof *more * (size_t)room);
        if (!more) return 0;
        m->points = more;
        m->room_points = room;
    }
    if (m->n_triangles + triangles > m->room_triangles) {
        const int room = 2 * (m->n_triangles + triangles);
        int **const array[3] = {&m->triangle, &m->part, &m->item};
        for (int k = 0; k < 3; ++k) {
            int *const more = realloc(*array[k], (k ? 1 : 3) * sizeof *more * (size_t)room);
            if (!more) return 0;
            *array[k] = more;
        }
        m->room_triangles = room;
    }
    return 1;
}

static void point_add(Skin *m, Vec3 p) { v3_put(m->points + 3 * m->n_points++, p); }

/* Those with two corners in one place are nothing to be seen. */
static void triangle_add(Skin *m, int a, int b, int c)
{
    const int corner[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
        const double *const p = m->points + 3 * corner[k], *const q = m->points + 3 * corner[(k + 1) % 3];
        if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) return;
    }
    memcpy(m->triangle + 3 * m->n_triangles, corner, sizeof corner);
    m->part[m->n_triangles] = (int)m->now_part;
    m->item[m->n_triangles++] = m->now_item;
}

/* Triangles over the last n rows of `count` points. */
static void rows_join(Skin *m, int n, int count, int closed)
{
    const int first = m->n_points - n * count;
    for (int i = 0; i + 1 < n; ++i) {
        for (int k = 0; k < count - !closed; ++k) {
            const int next = (k + 1) % count, a = first + i * count, b = a + count;
            triangle_add(m, a + k, a + next, b + k);
            triangle_add(m, b + k, a + next, b + next);
        }
    }
}

void skin_sweep(Skin *m, int n, const SkinPlace *place, int count, const double (*section)[2], int closed)
{
    m->failed = m->failed || !room_make(m, n * count, 2 * n * count);
    if (m->failed) return;
    for (int i = 0; i < n; ++i) {
        const SkinPlace *const at = &place[i];
        for (int k = 0; k < count; ++k) {
            const Vec3 aside = v3_axpy(at->middle, at->scale * section[k][0], at->y);
            point_add(m, v3_axpy(aside, at->scale * section[k][1], at->z));
        }
    }
    rows_join(m, n, count, closed);
}

void skin_turn(Skin *m, Vec3 centre, Vec3 axis, int n, const double (*profile)[2])
{
    enum { PROFILE_MAX = 32 };
    SkinPlace place[PROFILE_MAX];
    double circle[SKIN_SIDES][2];
    const Vec3 other = fabs(axis.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 y = v3_unit(v3_cross(other, axis)), z = v3_cross(axis, y);
    for (int k = 0; k < SKIN_SIDES; ++k) {
        circle[k][0] = cos(2 * M_PI * k / SKIN_SIDES);
        circle[k][1] = sin(2 * M_PI * k / SKIN_SIDES);
    }
    for (int i = 0; i < n && i < PROFILE_MAX; ++i)
        place[i] = (SkinPlace){v3_axpy(centre, profile[i][0], axis), y, z, profile[i][1]};
    skin_sweep(m, n < PROFILE_MAX ? n : PROFILE_MAX, place, SKIN_SIDES, circle, 1);
}

void skin_box(Skin *m, Vec3 centre, const Vec3 axis[3], const double half[3])
{
    const double section[4][2] = {{-half[1], -half[2]}, {half[1], -half[2]}, {half[1], half[2]}, {-half[1], half[2]}};
    const Vec3 from = v3_axpy(centre, -half[0], axis[0]), to = v3_axpy(centre, half[0], axis[0]);
    /* a lid is a section of no size */
    const SkinPlace place[4] = {
        {from, axis[1], axis[2], 0}, {from, axis[1], axis[2], 1}, {to, axis[1], axis[2], 1}, {to, axis[1], axis[2], 0}};
    skin_sweep(m, 4, place, 4, section, 1);
}

void skin_free(Skin *m)
{
    free(m->points);
    free(m->triangle);
    free(m->part);
    free(m->item);
    *m = (Skin){0};
}
