#include "sim/equipment/reel.h"

#include <stddef.h>

static Vec3 body_position(const Kinematics *kin, int i) { return v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]); }
static Vec3 body_velocity(const Kinematics *kin, int i) { return v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]); }
static Vec3 body_spin(const Kinematics *kin, int i) { return v3(kin->w[0][i], kin->w[1][i], kin->w[2][i]); }

static void winding_init(Winding *w, const ReelDef *def, const CableDef *cable)
{
    *w = (Winding){.barrel = def->barrel / 2,
                   .pitch = cable->diameter,
                   .turns = winding_turns(def->width, cable->diameter),
                   .line_mass = cable->mass,
                   .inertia = def->inertia};
}

/* Cable and rope of the whole chain up to the eye: what a reel may hold. */
static double cable_length(const SceneDef *def)
{
    double length = 0;
    for (int p = 0; p < def->n_pieces && (p == 0 || p + 1 < def->n_pieces); ++p) length += def->pieces[p].length;
    return length;
}

void reel_init(Reel *r, const SceneDef *def, Vec3 origin, Vec3 direction, Quat attitude)
{
    const ReelDef *const d = &def->reel;
    *r = (Reel){.present = 1,
                .drum = v3_axpy(origin, -d->distance, direction),
                .direction = direction,
                .attitude = attitude,
                .total = cable_length(def),
                .brake = d->brake,
                .torque = d->torque,
                .bearing = d->bearing,
                .over = d->over,
                .speed = d->speed,
                .tension = def->tail.tension,
                .rest = {.mu_s = 1, .mu_d = 1, .v_s = d->v_s, .v_d = 2 * d->v_s},
                .fixed = d->end_fixed};
    winding_init(&r->winding, d, &def->cables[def->pieces[0].cable]);
    if (!def->lead_in.carries_weight) r->downhill = v3_scale(v3_dot(def->gravity, direction), direction);
    /* a proportional brake gives its torque at the cable speed that goes with it, on the full drum */
    if (d->brake == BRAKE_PROPORTIONAL) {
        r->viscous = d->torque * winding_radius(&r->winding, r->total, NULL) / d->at_speed;
    }
}

void reel_hold(Reel *r, const Chain *whole, int first, const CableDef *cable)
{
    r->wound = 0;
    for (int i = 0; i < first; ++i) r->wound += 2 * whole->half[i];
    r->half = whole->half[first];
    r->last = first == 0;
    const double radius = winding_radius(&r->winding, r->wound, NULL);
    r->mass = winding_inertia(&r->winding, r->wound) / (radius * radius);
    const double rigidity[3] = {cable->gj, cable->ei_y, cable->ei_z};
    for (int c = 0; c < 3; ++c) {
        r->rigidity[c] = rigidity[c];
        r->damping[c] = cable->damping * cable->damping_factor[3 + c];
    }
    r->catch = cable->ea / (2 * r->half);
}

double reel_free_length(const Reel *r, const Kinematics *kin)
{
    return v3_dot(v3_sub(body_position(kin, 0), r->drum), r->direction);
}

/* Share of the drum's hold on the cable: it lets a free end go over the last segment's length (RL14). */
static double grip(const Reel *r, double l, double *slope)
{
    *slope = 0;
    if (!r->last || r->fixed) return 1;
    return step_cubic(l, r->half, 1, 3 * r->half, 0, slope);
}

/* 1 at speed, 0 at rest, odd (F3). */
static double moving(const Reel *r, double v, double *slope)
{
    double curve;
    const double over_speed = friction_over_speed(&r->rest, fabs(v), &curve);
    *slope = over_speed + curve * v * v;
    return over_speed * v;
}

/* Torque of brake and bearing on a drum with the cable at radius `radius` (RL8), and its derivatives. */
static double brake_torque(const Reel *r, double radius, double v, double t, double *by_radius, double *by_v)
{
    double slope;
    const double f = moving(r, v, &slope);
    double torque = r->bearing * f;
    *by_radius = 0;
    *by_v = r->bearing * slope;
    if (r->brake == BRAKE_CONSTANT) {
        torque += r->torque * f;
        *by_v += r->torque * slope;
    } else if (r->brake == BRAKE_PROPORTIONAL) {
        torque += r->viscous * v / radius;
        *by_v += r->viscous / radius;
        *by_radius = -r->viscous * v / (radius * radius);
    } else if (r->brake == BRAKE_SPEED) {
        torque += r->torque * step_cubic(v - profile_value(&r->speed, t), 0, 0, r->over, 1, &slope);
        *by_v += r->torque * slope;
    }
    return torque;
}

/* The fastened end of an empty drum holds, once the last segment has passed: a spring that sets in over 1 mm (RL15). */
static double catch_force(const Reel *r, double l, double v, double *by_l, double *by_v)
{
    static const double SOFT = 1e-3; /* m */
    const double u = l - 3 * r->half;
    *by_l = *by_v = 0;
    if (!r->last || !r->fixed || u <= 0) return 0;
    const double share = u / (u + SOFT), c = r->catch * r->damping[1], rate = SOFT / ((u + SOFT) * (u + SOFT));
    *by_l = r->catch * (share + u * rate) + c * v * rate;
    *by_v = c * share;
    return r->catch * u * share + c * share * v;
}

double reel_resistance(const Reel *r, double l, double v, double t, double friction, double *by_l, double *by_v)
{
    double bend, fade, by_radius, torque_by_v, catch_by_l, catch_by_v;
    const double radius = winding_radius(&r->winding, r->wound - (l - r->half), &bend);
    const double torque = brake_torque(r, radius, v, t, &by_radius, &torque_by_v);
    const double g = grip(r, l, &fade), drag = profile_value(&r->tension, t) + friction * torque / radius;
    const double caught = catch_force(r, l, v, &catch_by_l, &catch_by_v);
    /* the radius shrinks as the cable leaves: d(radius)/dl = -bend */
    const double drag_by_l = -friction * bend * (by_radius - torque / radius) / radius;
    if (by_l) *by_l = g * drag_by_l + fade * drag + catch_by_l;
    if (by_v) *by_v = g * friction * torque_by_v / radius + catch_by_v;
    return g * drag + caught;
}

/* The tail's attitude against the line, and the stretch of cable that turns with it (RL9). */
typedef struct Held {
    double s;           /* scalar part of the relative quaternion, >= 0 */
    Vec3 u;             /* its vector part, world */
    double share, by_l; /* grip over free length, 1/m, and its derivative by l */
} Held;

static Held held_of(const Reel *r, const Kinematics *kin, double l)
{
    const Quat q = {kin->q[0][0], kin->q[1][0], kin->q[2][0], kin->q[3][0]};
    const Quat rel = quat_mul(q, quat_conj(r->attitude));
    const double sign = rel.w < 0 ? -1 : 1, length = fmax(l, r->half / 2);
    double fade;
    const double g = grip(r, l, &fade);
    return (Held){.s = sign * rel.w,
                  .u = v3_scale(sign, v3(rel.x, rel.y, rel.z)),
                  .share = g / length,
                  .by_l = fade / length - (l > r->half / 2 ? g / (length * length) : 0)};
}

/* The drum's rigidities, times `factor` each, on a world vector: R diag R^T a. */
static Vec3 rigid_times(const Reel *r, const double factor[3], Vec3 a)
{
    const Vec3 b = quat_rotate(quat_conj(r->attitude), a);
    return quat_rotate(r->attitude, v3(r->rigidity[0] * factor[0] * b.x, r->rigidity[1] * factor[1] * b.y,
                                       r->rigidity[2] * factor[2] * b.z));
}

static const double PLAIN[3] = {1, 1, 1};

/* Moment on the tail for a share of 1/m (RL9). */
static Vec3 held_moment(const Reel *r, const Held *h, Vec3 spin)
{
    return v3_scale(-1, v3_add(rigid_times(r, PLAIN, v3_scale(2, h->u)), rigid_times(r, r->damping, spin)));
}

/* Force and moment on segment 0; the drum rests on its stand. */
static void tail_wrench(const Reel *r, const Kinematics *kin, double t, double friction, Vec3 *f, Vec3 *m)
{
    const double l = reel_free_length(r, kin), v = v3_dot(body_velocity(kin, 0), r->direction);
    const Held h = held_of(r, kin, l);
    const double resistance = reel_resistance(r, l, v, t, friction, NULL, NULL);
    *f = v3_axpy(v3_scale(-resistance, r->direction), -r->mass, r->downhill);
    *m = v3_scale(h.share, held_moment(r, &h, body_spin(kin, 0)));
}

Push reel_push(const Reel *r, const Kinematics *kin, double t)
{
    Vec3 f, m;
    tail_wrench(r, kin, t, 1, &f, &m);
    return (Push){v3_dot(f, body_velocity(kin, 0)) + v3_dot(m, body_spin(kin, 0)), f};
}

void reel_loads(const Reel *r, const Kinematics *kin, double t, double friction, Loads *loads)
{
    Vec3 f, m;
    tail_wrench(r, kin, t, friction, &f, &m);
    const double force[3] = {f.x, f.y, f.z}, moment[3] = {m.x, m.y, m.z};
    for (int c = 0; c < 3; ++c) {
        loads->f[c][0] += force[c];
        loads->m[c][0] += moment[c];
    }
}

/* Adds `value` to rows row..row+2 of a column of a 6x6 block. */
static void column_add(double *block, int column, int row, Vec3 value)
{
    double *const at = block + 6 * column + row;
    at[0] += value.x;
    at[1] += value.y;
    at[2] += value.z;
}

void reel_blocks(const Reel *r, const Kinematics *kin, double t, double friction, BlockChain *k, BlockChain *d)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double l = reel_free_length(r, kin), v = v3_dot(body_velocity(kin, 0), r->direction);
    const Held h = held_of(r, kin, l);
    const Vec3 moment = held_moment(r, &h, body_spin(kin, 0));
    double by_l, by_v;
    reel_resistance(r, l, v, t, friction, &by_l, &by_v);
    for (int c = 0; c < 3; ++c) {
        const double along = v3_dot(unit[c], r->direction);
        column_add(k->diag, c, 0, v3_scale(-by_l * along, r->direction));
        column_add(k->diag, c, 3, v3_scale(h.by_l * along, moment));
        column_add(d->diag, c, 0, v3_scale(-by_v * along, r->direction));
        /* theta = 2 u turns by s phi + phi x u */
        const Vec3 turned = v3_axpy(v3_cross(unit[c], h.u), h.s, unit[c]);
        column_add(k->diag, 3 + c, 3, v3_scale(-h.share, rigid_times(r, PLAIN, turned)));
        column_add(d->diag, 3 + c, 3, v3_scale(-h.share, rigid_times(r, r->damping, unit[c])));
    }
}

ReelLook reel_look(const Reel *r, const Chain *chain, const Kinematics *kin, const JointLoads *joints, double t)
{
    const double l = reel_free_length(r, kin), v = v3_dot(body_velocity(kin, 0), r->direction);
    const double resistance = reel_resistance(r, l, v, t, 1, NULL, NULL), mass = chain->mass[0];
    const double wound = fmax(r->wound - (l - r->half), 0), radius = winding_radius(&r->winding, wound, NULL);
    const Vec3 ahead = v3(joints->force[0][1], joints->force[1][1], joints->force[2][1]);
    const double pull = v3_dot(v3_axpy(ahead, mass - r->mass, r->downhill), r->direction);
    return (ReelLook){.speed = v / radius,
                      .paid_out = r->total - wound,
                      .wound = wound,
                      .tension = resistance + r->mass / mass * (pull - resistance)}; /* (RL11) */
}
