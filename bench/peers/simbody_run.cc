#include "bench/peers/simbody_run.h"

#include <map>
#include <memory>

using namespace SimTK;

typedef std::unique_ptr<Integrator> (*MakeIntegrator)(const System &);

template <class T> static std::unique_ptr<Integrator> make(const System &system)
{
    return std::unique_ptr<Integrator>(new T(system));
}
static std::unique_ptr<Integrator> make_adams(const System &system)
{
    return std::unique_ptr<Integrator>(new CPodesIntegrator(system, CPodes::Adams));
}
/* This one wants a step when it is made; set_up gives it the true one. */
static std::unique_ptr<Integrator> make_semi(const System &system)
{
    return std::unique_ptr<Integrator>(new SemiExplicitEulerIntegrator(system, 1e-4));
}

static const std::map<std::string, MakeIntegrator> &integrators()
{
    static const std::map<std::string, MakeIntegrator> all = {{"cpodes", make<CPodesIntegrator>},
                                                              {"adams", make_adams},
                                                              {"merson", make<RungeKuttaMersonIntegrator>},
                                                              {"rk3", make<RungeKutta3Integrator>},
                                                              {"rk2", make<RungeKutta2Integrator>},
                                                              {"verlet", make<VerletIntegrator>},
                                                              {"semi2", make<SemiExplicitEuler2Integrator>},
                                                              {"semi", make_semi}};
    return all;
}

bool method_exists(const std::string &name) { return name == "band" || integrators().count(name) > 0; }

static void set_up(Integrator &integrator, const Method &method, double end)
{
    const bool multistep = method.name == "cpodes" || method.name == "adams";
    integrator.setAccuracy(method.accuracy);
    if (method.step > 0 && multistep)
        integrator.setMaximumStepSize(method.step);
    else if (method.step > 0)
        integrator.setFixedStepSize(method.step);
    integrator.setReturnEveryInternalStep(true);
    integrator.setFinalTime(end);
}

/* Steps until `at` is reached; false if the time limit comes before. */
static bool step_to(Integrator &integrator, double at, const Method &method)
{
    for (;;) {
        const Integrator::SuccessfulStepStatus status = integrator.stepTo(at);
        if (status == Integrator::ReachedReportTime || status == Integrator::EndOfSimulation) return true;
        if (method.over()) return false;
    }
}

static Outcome run_integrator(const Chain &chain, State &state, const Method &method, double end, double every,
                              const Report &report)
{
    const double start = state.getTime();
    Outcome outcome = {start, 0, false};
    const std::unique_ptr<Integrator> integrator = integrators().at(method.name)(chain.system);
    try {
        set_up(*integrator, method, end + every);
        integrator->initialize(state);
        for (long k = 1; start + double(k) * every < end + every / 2; ++k) {
            const bool there = step_to(*integrator, start + double(k) * every, method);
            outcome.reached = integrator->getState().getTime();
            if (!there) break;
            chain.system.realize(integrator->getState(), Stage::Velocity);
            report(integrator->getState());
        }
    } catch (const std::exception &error) {
        fprintf(stderr, "peer_simbody: %s\n", error.what());
        outcome.failed = true;
    }
    outcome.steps = integrator->getNumStepsTaken();
    state = integrator->getState();
    return outcome;
}

Outcome run_chain(const Chain &chain, State &state, const Method &method, double end, double every,
                  const Report &report)
{
    return method.name == "band" ? run_band(chain, state, method, end, every, report)
                                 : run_integrator(chain, state, method, end, every, report);
}
