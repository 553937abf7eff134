/* CPodes with its band solver. Simbody's Integrator around it always takes the dense one, whose finite differences need
 * as many evaluations as there are states; the class that it is built on is public and knows bands as well. */
#include "bench/peers/simbody_run.h"

using namespace SimTK;

/* y = (q, u of body 0; q, u of body 1; ...) + 1, less q at the start: neighbours touch neighbours alone, which makes a
 * band of the Jacobian. The 1 makes CPodes' increments, sqrt(eps) |y|, fit to be seen in the forces of stiff joints:
 * for a coordinate near 0 they would drown in rounding. It makes the tolerance an absolute one, in m, rad and their
 * rates. Simbody's own order is all q, all u, then the energy that each bushing has dissipated, which is left out: it
 * would be in the error test. */
class BandSystem : public CPodesSystem
{
  public:
    BandSystem(const Chain &chain, State &state, const Method &method)
        : chain_(chain), state_(state), method_(method), size_(chain.coordinates()),
          slots_(state.getNQ() / chain.def.n), q0_(state.getQ())
    {
    }
    bool over() const { return over_; }
    int width() const { return 4 * size_ - 1; } /* of half the band */
    int states() const { return 2 * size_ * chain_.def.n; }
    Vector values() const
    {
        Vector y(states());
        const Vector &simbody = state_.getY();
        for (int i = 0; i < half(); ++i) {
            y[place(i, 0)] = simbody[q_at(i)] - q0_[q_at(i)] + 1;
            y[place(i, 1)] = simbody[q0_.size() + i] + 1;
        }
        return y;
    }
    void take(double t, const Vector &y) const
    {
        Vector &simbody = state_.updY();
        for (int i = 0; i < half(); ++i) {
            simbody[q_at(i)] = y[place(i, 0)] + q0_[q_at(i)] - 1;
            simbody[q0_.size() + i] = y[place(i, 1)] - 1;
        }
        state_.setTime(t);
    }
    int explicitODE(Real t, const Vector &y, Vector &rate) const override
    {
        over_ = method_.over();
        if (over_) return CPodes::UnrecoverableError;
        take(t, y);
        try {
            chain_.system.realize(state_, Stage::Acceleration);
        } catch (const std::exception &) {
            return CPodes::RecoverableError;
        }
        const Vector &simbody = state_.getYDot();
        for (int i = 0; i < half(); ++i) {
            rate[place(i, 0)] = simbody[q_at(i)];
            rate[place(i, 1)] = simbody[q0_.size() + i];
        }
        return CPodes::Success;
    }

  private:
    const Chain &chain_;
    State &state_;
    const Method &method_;
    const int size_,
        slots_; /* coordinates of a body in use, and in the state: Euler angles leave a slot of four empty */
    const Vector q0_;
    mutable bool over_ = false;

    int half() const { return size_ * chain_.def.n; }
    int q_at(int i) const
    {
        return slots_ * (i / size_) + i % size_;
    } /* coordinate i in Simbody's q; speeds have no gaps */
    int place(int i, int speed) const { return 2 * size_ * (i / size_) + size_ * speed + i % size_; } /* in y */
};

static bool set_up(CPodes &solver, BandSystem &system, const Method &method, double t, Vector &y, Vector &rate)
{
    double absolute = 0.1 * method.accuracy;
    system.explicitODE(t, y, rate);
    if (solver.init(system, t, y, rate, CPodes::ScalarScalar, method.accuracy, &absolute) != CPodes::Success)
        return false;
    if (solver.lapackBand(y.size(), system.width(), system.width()) != CPodes::Success) return false;
    solver.setMaxNumSteps(100000000);
    if (method.step > 0) solver.setMaxStep(method.step);
    return true;
}

Outcome run_band(const Chain &chain, State &state, const Method &method, double end, double every, const Report &report)
{
    const double start = state.getTime();
    Outcome outcome = {start, 0, false};
    BandSystem system(chain, state, method);
    Vector y = system.values(), rate(system.states());
    CPodes solver(CPodes::ExplicitODE, CPodes::BDF, CPodes::Newton);
    int steps = 0;
    outcome.failed = !set_up(solver, system, method, start, y, rate);
    for (long k = 1; !outcome.failed && start + double(k) * every < end + every / 2; ++k) {
        const double at = start + double(k) * every;
        if (solver.step(at, &outcome.reached, y, rate, CPodes::Normal) < 0) {
            outcome.failed = !system.over();
            break;
        }
        system.take(at, y);
        chain.system.realize(state, Stage::Velocity);
        report(state);
    }
    solver.getNumSteps(&steps);
    outcome.steps = steps;
    return outcome;
}
