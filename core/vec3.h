/* Three-vectors, quaternions and 3x3 matrices of doubles: plain values, inline functions, no state. Quaternions are (w,
 * x, y, z), Hamilton's product, and rotate body components into world components. */
#ifndef HAWSER_CORE_VEC3_H
#define HAWSER_CORE_VEC3_H

#include <math.h>

typedef struct Vec3 {
    double x, y, z;
} Vec3;

typedef struct Quat {
    double w, x, y, z;
} Quat;

/* Row-major: m[3 * row + column]. */
typedef struct Mat3 {
    double m[9];
} Mat3;

static inline Vec3 v3(double x, double y, double z) { return (Vec3){x, y, z}; }

static inline Vec3 v3_add(Vec3 a, Vec3 b) { return v3(a.x + b.x, a.y + b.y, a.z + b.z); }

static inline Vec3 v3_sub(Vec3 a, Vec3 b) { return v3(a.x - b.x, a.y - b.y, a.z - b.z); }

static inline Vec3 v3_scale(double s, Vec3 a) { return v3(s * a.x, s * a.y, s * a.z); }

/* a + s b */
static inline Vec3 v3_axpy(Vec3 a, double s, Vec3 b) { return v3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z); }

static inline double v3_dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline double v3_norm(Vec3 a) { return sqrt(v3_dot(a, a)); }

static inline Vec3 v3_cross(Vec3 a, Vec3 b)
{
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* a / |a|; the zero vector stays zero. */
static inline Vec3 v3_unit(Vec3 a)
{
    const double n = v3_norm(a);
    return n > 0 ? v3_scale(1 / n, a) : a;
}

/* The part of a that is perpendicular to the unit vector n. */
static inline Vec3 v3_reject(Vec3 a, Vec3 n) { return v3_axpy(a, -v3_dot(a, n), n); }

/* Entry i of three arrays of components: of a chain, of a batch of lanes. */
static inline Vec3 v3_load(double *const a[3], int i) { return v3(a[0][i], a[1][i], a[2][i]); }

static inline void v3_store(double *const a[3], int i, Vec3 v)
{
    a[0][i] = v.x;
    a[1][i] = v.y;
    a[2][i] = v.z;
}

/* Adds v to that entry. */
static inline void v3_gather(double *const a[3], int i, Vec3 v)
{
    a[0][i] += v.x;
    a[1][i] += v.y;
    a[2][i] += v.z;
}

static const Vec3 V3_ZERO = {0, 0, 0};

/* World axis 0, 1 or 2. */
static inline Vec3 v3_axis(int c) { return v3(c == 0, c == 1, c == 2); }

/* Between a vector and three numbers in a row. */
static inline Vec3 v3_get(const double *p) { return v3(p[0], p[1], p[2]); }

static inline void v3_put(double *p, Vec3 v)
{
    p[0] = v.x;
    p[1] = v.y;
    p[2] = v.z;
}

static inline Vec3 m3_mul(const Mat3 *a, Vec3 v)
{
    const double *m = a->m;
    return v3(m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
              m[6] * v.x + m[7] * v.y + m[8] * v.z);
}

static inline Quat quat_mul(Quat a, Quat b)
{
    return (Quat){a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                  a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

static inline Quat quat_conj(Quat q) { return (Quat){q.w, -q.x, -q.y, -q.z}; }

static inline Quat quat_unit(Quat q)
{
    const double s = 1 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return (Quat){s * q.w, s * q.x, s * q.y, s * q.z};
}

/* The rotation by the vector r (rad). */
static inline Quat quat_exp(Vec3 r)
{
    const double angle = v3_norm(r);
    const double s = angle > 1e-8 ? sin(angle / 2) / angle : 0.5;
    return (Quat){cos(angle / 2), s * r.x, s * r.y, s * r.z};
}

/* The rotation vector of the unit quaternion q, rad, of length pi at most: the inverse of quat_exp. */
static inline Vec3 quat_log(Quat q)
{
    const double sign = q.w < 0 ? -1 : 1, size = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    const double scale = size > 1e-8 ? 2 * atan2(size, sign * q.w) / size : 2;
    return v3(sign * scale * q.x, sign * scale * q.y, sign * scale * q.z);
}

/* v rotated by the unit quaternion q. */
static inline Vec3 quat_rotate(Quat q, Vec3 v)
{
    const Vec3 u = v3(q.x, q.y, q.z);
    const Vec3 t = v3_scale(2, v3_cross(u, v));
    return v3_add(v3_axpy(v, q.w, t), v3_cross(u, t));
}

/* The smallest rotation that takes unit vector a to b, applied after q: a parallel-transported frame. */
static inline Quat quat_carry(Quat q, Vec3 a, Vec3 b)
{
    const Vec3 axis = v3_cross(a, b);
    const double c = v3_dot(a, b);
    if (c < -0.999999) return q;
    return quat_unit(quat_mul((Quat){1 + c, axis.x, axis.y, axis.z}, q));
}

/* The rotation whose x, y and z axes are the given right-handed orthonormal triple. */
static inline Quat quat_from_axes(Vec3 ex, Vec3 ey, Vec3 ez)
{
    const double t[4] = {ex.x + ey.y + ez.z, ex.x - ey.y - ez.z, ey.y - ex.x - ez.z, ez.z - ex.x - ey.y};
    Quat q;
    if (t[0] >= t[1] && t[0] >= t[2] && t[0] >= t[3]) {
        q = (Quat){1 + t[0], ey.z - ez.y, ez.x - ex.z, ex.y - ey.x};
    } else if (t[1] >= t[2] && t[1] >= t[3]) {
        q = (Quat){ey.z - ez.y, 1 + t[1], ex.y + ey.x, ez.x + ex.z};
    } else if (t[2] >= t[3]) {
        q = (Quat){ez.x - ex.z, ex.y + ey.x, 1 + t[2], ey.z + ez.y};
    } else {
        q = (Quat){ex.y - ey.x, ez.x + ex.z, ey.z + ez.y, 1 + t[3]};
    }
    return quat_unit(q);
}

/* The largest and the smallest of several values. fmax(x, NAN) is x: accumulating an error with it loses every NAN. */

/* The larger of the two; NAN if one of them is, so that a NAN is kept to the end of a loop and fails every check of a
 * bound. */
static inline double larger_of(double a, double b) { return isnan(a) || a >= b ? a : b; }

/* The smaller; NAN likewise. */
static inline double smaller_of(double a, double b) { return isnan(a) || a <= b ? a : b; }

#endif
