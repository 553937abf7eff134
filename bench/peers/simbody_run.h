/* Integrates a chain with one of Simbody's integrators. */
#ifndef HAWSER_BENCH_PEERS_SIMBODY_RUN_H
#define HAWSER_BENCH_PEERS_SIMBODY_RUN_H

#include <functional>
#include <string>

#include "bench/peers/simbody_chain.h"

/* How to integrate: `band` is CPodes with its band solver, called past Simbody's Integrator (simbody_band.cc), for
 * bodies that touch their neighbours alone; the others are Simbody's integrators by the short names of method_exists.
 */
struct Method {
    std::string name;
    double accuracy;            /* relative tolerance; the absolute one is a tenth, as CPodesIntegrator has it */
    double step;                /* s, fixed; for CPodes the largest; 0: chosen by the error */
    std::function<bool()> over; /* has the time limit come? */
};

/* What is told of every state. */
typedef std::function<void(const SimTK::State &)> Report;

/* How it ended. */
struct Outcome {
    double reached; /* s, less than asked for if the limit came first or the integrator failed */
    long steps;
    bool failed;
};

/* cpodes, adams, merson, rk3, rk2, verlet, semi2, semi, or band. */
bool method_exists(const std::string &name);

/* From `state`, which it changes, to `end`; reports every `every` s. */
Outcome run_chain(const Chain &chain, SimTK::State &state, const Method &method, double end, double every,
                  const Report &report);
Outcome run_band(const Chain &chain, SimTK::State &state, const Method &method, double end, double every,
                 const Report &report);

#endif
