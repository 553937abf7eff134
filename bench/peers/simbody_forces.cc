/* Simbody's own collision detection knows no cylinders, and looks for pairs of shapes in every evaluation: one loop
 * along the cable finds the segment over each roller instead. The laws of contact are hawser's, by its own functions.
 */
#include "bench/peers/simbody_forces.h"

#include <algorithm>
#include <cmath>

extern "C" {
#include "contact/law.h"
}

using namespace SimTK;

static const double HALF = PEER_LINK / 2;

/* A segment as the elements see it: position and velocity in the plane. */
struct PlanePose {
    double x, y, ax, ay; /* centre and axis */
    double u, v, w;      /* velocity and angular velocity */
};

static PlanePose plane_pose(const Chain &chain, const State &state, MobilizedBodyIndex index)
{
    const MobilizedBody &body = chain.matter.getMobilizedBody(index);
    const Transform &X = body.getBodyTransform(state);
    const SpatialVec &V = body.getBodyVelocity(state);
    return {X.p()[0], X.p()[1], X.R().x()[0], X.R().x()[1], V[1][0], V[1][1], V[0][2]};
}

/* Adds the force (fx, fy) that acts at (x, y) to what acts on a body. */
static void add_force(SpatialVec &on, const PlanePose &p, double x, double y, double fx, double fy)
{
    on[0][2] += (x - p.x) * fy - (y - p.y) * fx;
    on[1][0] += fx;
    on[1][1] += fy;
}

/* All rollers against all segments: one contact a roller, with the line of the axes, whose ends are round. */
class Rollers : public Force::Custom::Implementation
{
  public:
    explicit Rollers(const Chain &chain) : chain_(chain), count_(straight_rollers(chain.def.n)) {}
    void calcForce(const State &state, Vector_<SpatialVec> &bodies, Vector_<Vec3> &, Vector &) const override
    {
        size_t i = 0;
        for (int k = 0; k < count_; ++k) {
            const double x = straight_roller_x(k);
            while (i + 1 < chain_.body.size() && end_x(state, i) <= x) ++i;
            touch(bodies[chain_.body[i]], plane_pose(chain_, state, chain_.body[i]), x);
        }
    }
    Real calcPotentialEnergy(const State &) const override { return 0; }

  private:
    const Chain &chain_;
    const int count_;
    const ImpactLaw impact_ = {CONTACT_K, CONTACT_EXPONENT, CONTACT_C, 1e-4};
    const FrictionLaw friction_ = {PEER_MU, PEER_MU, PEER_SLIP_SPEED, 2 * PEER_SLIP_SPEED, 0};

    double end_x(const State &state, size_t i) const
    {
        const Transform &X = chain_.matter.getMobilizedBody(chain_.body[i]).getBodyTransform(state);
        return X.p()[0] + HALF * X.R().x()[0];
    }
    /* n from the roller at x to the cable, sliding along (ny, -nx): (C12) and (C14) of docs/theory.md. */
    void touch(SpatialVec &on, const PlanePose &p, double x) const
    {
        const double radius = PEER_DIAMETER / 2, y = straight_roller_z();
        const double along = std::clamp((x - p.x) * p.ax + (y - p.y) * p.ay, -HALF, HALF);
        const double px = p.x + along * p.ax, py = p.y + along * p.ay, far = std::hypot(px - x, py - y);
        const double gap = far - radius - ROLLER_RADIUS;
        if (gap >= 0) return;
        const double nx = (px - x) / far, ny = (py - y) / far;
        const double sx = px - radius * nx, sy = py - radius * ny;
        const double vx = p.u - p.w * (sy - p.y), vy = p.v + p.w * (sx - p.x);
        const double rate = vx * nx + vy * ny, slip = vx * ny - vy * nx;
        double slopes[2];
        const double N = impact_force(&impact_, gap, rate, &slopes[0], &slopes[1]);
        const double T = -N * friction_over_speed(&friction_, std::fabs(slip), &slopes[0]) * slip;
        add_force(on, p, sx, sy, N * nx + T * ny, N * ny - T * nx);
    }
};

class Winch : public Force::Custom::Implementation
{
  public:
    explicit Winch(const Chain &chain) : chain_(chain) {}
    void calcForce(const State &state, Vector_<SpatialVec> &bodies, Vector_<Vec3> &, Vector &) const override
    {
        const PlanePose p = plane_pose(chain_, state, chain_.body.back());
        add_force(bodies[chain_.body.back()], p, p.x + HALF * p.ax, p.y + HALF * p.ay, chain_.force(state), 0);
    }
    Real calcPotentialEnergy(const State &) const override { return 0; }

  private:
    const Chain &chain_;
};

/* The springs and dampers between neighbours, in the axes half-way between theirs: (PL5) to (PL7) of docs/theory.md.
 * They act on the planar mobilizers' coordinates (angle, x, y), so that no body's pose is needed. */
class PlaneJoints : public Force::Custom::Implementation
{
  public:
    PlaneJoints(const Chain &chain, const Vec3 &stiffness) : chain_(chain), k_(stiffness) {}
    void calcForce(const State &state, Vector_<SpatialVec> &, Vector_<Vec3> &, Vector &mobilities) const override
    {
        const Vector &q = chain_.matter.getQ(state), &u = chain_.matter.getU(state);
        for (int i = 0; i + 1 < chain_.def.n; ++i) join(&q[3 * i], &u[3 * i], &mobilities[3 * i]);
    }
    Real calcPotentialEnergy(const State &) const override { return 0; }

  private:
    const Chain &chain_;
    const Vec3 k_;

    /* q, u, f: of both segments. (cx, cy) is the axis half-way, D the gap, E its rate seen from there. */
    void join(const Real *q, const Real *u, Real *f) const
    {
        const double ax = HALF * std::cos(q[0]), ay = HALF * std::sin(q[0]);
        const double bx = HALF * std::cos(q[3]), by = HALF * std::sin(q[3]);
        const double cx = std::cos((q[0] + q[3]) / 2), cy = std::sin((q[0] + q[3]) / 2), w = (u[0] + u[3]) / 2;
        const double Dx = q[4] - q[1] - ax - bx, Dy = q[5] - q[2] - ay - by;
        const double Ex = u[4] - u[1] + u[0] * ay + u[3] * by + w * Dy;
        const double Ey = u[5] - u[2] - u[0] * ax - u[3] * bx - w * Dx;
        const double b = chain_.def.damping;
        const double along = k_[0] * (cx * Dx + cy * Dy + b * (cx * Ex + cy * Ey));
        const double across = k_[1] * (cx * Dy - cy * Dx + b * (cx * Ey - cy * Ex));
        const double fx = cx * along - cy * across, fy = cy * along + cx * across;
        const double moment = k_[2] * (q[3] - q[0] + b * (u[3] - u[0])), gap = (Dx * fy - Dy * fx) / 2;
        f[0] += ax * fy - ay * fx + gap + moment, f[1] += fx, f[2] += fy;
        f[3] += bx * fy - by * fx + gap - moment, f[4] -= fx, f[5] -= fy;
    }
};

Force::Custom::Implementation *new_rollers(const Chain &chain) { return new Rollers(chain); }
Force::Custom::Implementation *new_winch(const Chain &chain) { return new Winch(chain); }
Force::Custom::Implementation *new_plane_joints(const Chain &chain, const Vec3 &stiffness)
{
    return new PlaneJoints(chain, stiffness);
}
