#include "bench/peers/simbody_chain.h"

#include <cmath>

#include "bench/peers/simbody_forces.h"

using namespace SimTK;

static const double HALF = PEER_LINK / 2;
static const double WINCH_STIFFNESS = 1e8; /* N/m: gives 0.08 mm at the pull of 370 segments */

/* Frames of the joints on a segment. */
static Transform front() { return Transform(Vec3(HALF, 0, 0)); }
static Transform back() { return Transform(Vec3(-HALF, 0, 0)); }

/* Of a joint, in a bushing's order: torsion, two bendings (N m/rad), axial, two shears (N/m). A chain's links are
 * hinged. */
static Vec6 joint_stiffness(const ChainDef &def)
{
    const double I = def.problem == PEER_STRAIGHT ? peer_second_moment() : 0;
    const double bend = PEER_E * I / PEER_LINK, twist = 2 * PEER_G * I / PEER_LINK;
    const double stretch = def.stiff * PEER_E * PEER_AREA / PEER_LINK,
                 shear = def.stiff * PEER_G * PEER_AREA / PEER_LINK;
    return Vec6(twist, bend, bend, stretch, shear, shear);
}

double winch_pull(int n, double t, double x, double u)
{
    const double damper = 2 * std::sqrt(WINCH_STIFFNESS * PEER_MASS * n), now = t > 0 ? t : 0;
    return WINCH_STIFFNESS * (straight_travel(now) - x) + damper * (straight_speed(now) - u);
}

/* Where the segments lie at the start: the straight cable on the rollers, as deep as its weight presses it on each. */
void Chain::lay_out()
{
    const double load = PEER_MASS * PEER_GRAVITY * ROLLER_SPACING / PEER_LINK;
    const double depth = std::pow(load / CONTACT_K, 1 / CONTACT_EXPONENT);
    std::vector<double> joint(3 * (size_t(def.n) + 1));
    if (def.problem != PEER_STRAIGHT) chain_joints(def.n, 0, joint.data());
    for (int i = 0; i < def.n; ++i) {
        const double *const a = &joint[3 * size_t(i)];
        const bool straight = def.problem == PEER_STRAIGHT;
        slope_.push_back(straight ? 0 : std::atan2(a[5] - a[2], a[3] - a[0]));
        centre_.push_back(straight ? Vec3(straight_joint_x(i) + HALF, -depth, 0)
                                   : Vec3((a[0] + a[3]) / 2, (a[2] + a[5]) / 2, 0));
    }
}

/* The plane of the chain, turned about the line through its ends. */
static Rotation tilt(const ChainDef &def) { return Rotation(chain_angle(def.problem), XAxis); }

void Chain::add_free(Body &bar)
{
    for (int i = 0; i < def.n; ++i) {
        if (def.form == Form::free6)
            body.push_back(MobilizedBody::Free(matter.updGround(), bar).getMobilizedBodyIndex());
        else
            body.push_back(MobilizedBody::Planar(matter.updGround(), bar).getMobilizedBodyIndex());
    }
}

void Chain::add_bushings()
{
    const Vec6 k = joint_stiffness(def);
    for (size_t i = 0; i + 1 < body.size(); ++i) {
        Force::LinearBushing(forces, matter.getMobilizedBody(body[i]), front(), matter.getMobilizedBody(body[i + 1]),
                             back(), k, def.damping * k);
    }
}

/* The chain of free bodies hangs on half a joint at either end, twice as stiff as one. */
void Chain::add_supports()
{
    const Vec6 k = 2 * joint_stiffness(def);
    const Transform head(Vec3(chain_span(def.n), 0, 0));
    Force::LinearBushing(forces, matter.getGround(), Transform(), matter.getMobilizedBody(body.front()), back(), k,
                         def.damping * k);
    last_ = Force::LinearBushing(forces, matter.getGround(), head, matter.getMobilizedBody(body.back()), front(), k,
                                 def.damping * k);
}

void Chain::add_pins(Body &bar)
{
    const double k = joint_stiffness(def)[1];
    body.resize(size_t(def.n));
    body.back() = MobilizedBody::Planar(matter.updGround(), bar).getMobilizedBodyIndex();
    for (size_t i = body.size() - 1; i-- > 0;) {
        MobilizedBody::Pin pin(matter.updMobilizedBody(body[i + 1]), back(), bar, front());
        Force::MobilityLinearSpring(forces, pin, MobilizerQIndex(0), k, 0);
        Force::MobilityLinearDamper(forces, pin, MobilizerUIndex(0), def.damping * k);
        body[i] = pin.getMobilizedBodyIndex();
    }
}

/* A universal joint turns about its frame's x, then y, and not about z, which is put along the link. */
void Chain::add_links(Body &bar)
{
    const Rotation along(Pi / 2, YAxis);
    const Transform far(along, Vec3(HALF, 0, 0)), near(along, Vec3(-HALF, 0, 0));
    MobilizedBody *parent = &matter.updGround();
    for (int i = 0; i < def.n; ++i) {
        const MobilizedBody::Universal link(*parent, i ? far : Transform(tilt(def) * along, Vec3(0)), bar, near);
        body.push_back(link.getMobilizedBodyIndex());
        parent = &matter.updMobilizedBody(body.back());
    }
    ball_ = Constraint::Ball(matter.updGround(), Vec3(chain_span(def.n), 0, 0), *parent, Vec3(HALF, 0, 0));
}

void Chain::add_forces()
{
    const Vec6 k = joint_stiffness(def);
    Force::UniformGravity(forces, matter, Vec3(0, -PEER_GRAVITY, 0));
    if (def.form == Form::plane) Force::Custom(forces, new_plane_joints(*this, Vec3(k[3], k[4], k[1])));
    if (def.form == Form::free3 || def.form == Form::free6) {
        add_bushings();
        if (def.problem != PEER_STRAIGHT) add_supports();
    }
    if (def.problem != PEER_STRAIGHT) return;
    Force::Custom(forces, new_rollers(*this));
    Force::Custom(forces, new_winch(*this));
}

Chain::Chain(const ChainDef &chain_def) : def(chain_def), matter(system), forces(system)
{
    const double across = peer_inertia_across();
    Body::Rigid bar(MassProperties(PEER_MASS, Vec3(0), Inertia(peer_inertia_along(), across, across)));
    forces.setNumberOfThreads(1);
    lay_out();
    if (def.form == Form::pins)
        add_pins(bar);
    else if (def.form == Form::links)
        add_links(bar);
    else
        add_free(bar);
    add_forces();
    system.realizeTopology();
}

State Chain::initial_state(double t)
{
    State state = system.getDefaultState();
    matter.setUseEulerAngles(state, true);
    system.realizeModel(state);
    state.setTime(t);
    for (size_t i = 0; i < body.size(); ++i) {
        const MobilizedBody &mobod = matter.getMobilizedBody(body[i]);
        const bool inner = def.form == Form::links || (def.form == Form::pins && i + 1 < body.size());
        if (!inner)
            mobod.setQToFitTransform(state, Transform(tilt(def) * Rotation(slope_[i], ZAxis), tilt(def) * centre_[i]));
        else if (def.form == Form::links)
            mobod.setOneQ(state, 0, (i ? slope_[i - 1] : 0) - slope_[i]);
    }
    return state;
}

int Chain::coordinates() const
{
    return def.form == Form::free6 ? 6 : def.form == Form::free3 || def.form == Form::plane ? 3 : 0;
}

Transform Chain::pose(const State &state, int i) const
{
    return matter.getMobilizedBody(body[size_t(i)]).getBodyTransform(state);
}

double Chain::force(const State &state) const
{
    if (def.problem != PEER_STRAIGHT && def.form == Form::links) {
        system.realize(state, Stage::Acceleration);
        return ball_.getBallReactionForceOnBody1(state)[0];
    }
    if (def.problem != PEER_STRAIGHT) return -last_.getF_GF(state)[1][0];
    const Transform X = pose(state, def.n - 1);
    const SpatialVec &V = matter.getMobilizedBody(body.back()).getBodyVelocity(state);
    const double x = X.p()[0] + HALF * X.R().x()[0] - straight_joint_x(def.n);
    return winch_pull(def.n, state.getTime(), x, V[1][0] - HALF * X.R().x()[1] * V[0][2]);
}

Vec3 Chain::middle(const State &state) const
{
    return pose(state, chain_middle_segment(def.n)) * Vec3(chain_middle_arm(def.n), 0, 0);
}
