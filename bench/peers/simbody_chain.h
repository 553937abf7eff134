/* The cable of problem.h built from Simbody's parts: bodies, mobilizers, force elements. The world's x is that of
 * problem.h, its y is up (problem.h's z), its z is problem.h's -y: Simbody's planar mobilizers move in x and y. */
#ifndef HAWSER_BENCH_PEERS_SIMBODY_CHAIN_H
#define HAWSER_BENCH_PEERS_SIMBODY_CHAIN_H

#include <Simbody.h>

#include <vector>

#include "bench/peers/problem.h"

/* How the segments are held together. Frames sit at the segments' centres, x along them. */
enum class Form {
    free6, /* bodies free in space (Euler angles), a LinearBushing at every joint */
    free3, /* bodies free in the plane, a LinearBushing at every joint */
    plane, /* bodies free in the plane, all joints in one force element of our own */
    pins,  /* straight pull: a tree of pins with springs and dampers, rooted at the head; no stretch, no shear */
    links  /* chain: a tree of universal joints; a ball constraint holds its far end */
};

/* What is to be built; SI units. */
struct ChainDef {
    PeerProblem problem;
    int n;
    Form form;
    double stiff;   /* stiffness against stretch and shear over table 1's */
    double damping; /* s: damping over stiffness */
};

/* The system, and where its parts are. Bodies are numbered from the tail to the head. */
class Chain
{
  public:
    explicit Chain(const ChainDef &chain_def);
    Chain(const Chain &) = delete;
    Chain &operator=(const Chain &) = delete;

    /* At rest where the problem says, at time `t`. */
    SimTK::State initial_state(double t);
    SimTK::Transform pose(const SimTK::State &state, int i) const;
    /* Force (N) by which the problem is judged: the winch's, or the horizontal one on the support at the head. */
    double force(const SimTK::State &state) const;
    /* The middle of the chain. */
    SimTK::Vec3 middle(const SimTK::State &state) const;
    /* Coordinates of a body if all bodies have as many and touch their neighbours alone, else 0. */
    int coordinates() const;

    const ChainDef def;
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter;
    SimTK::GeneralForceSubsystem forces;
    std::vector<SimTK::MobilizedBodyIndex> body;

  private:
    SimTK::Force::LinearBushing last_;
    SimTK::Constraint::Ball ball_;
    std::vector<double> slope_;       /* of the segments at the start, in their plane */
    std::vector<SimTK::Vec3> centre_; /* at the start */
    void lay_out();
    void add_free(SimTK::Body &bar);
    void add_pins(SimTK::Body &bar);
    void add_links(SimTK::Body &bar);
    void add_bushings();
    void add_supports();
    void add_forces();
};

/* The winch's pull on the head's end, which has moved x (m) since the start and has the speed u along x, by a spring of
 * WINCH_STIFFNESS that is damped critically against the whole cable's mass. */
double winch_pull(int n, double t, double x, double u);

#endif
