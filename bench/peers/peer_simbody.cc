/* Simbody's side of the comparison. Usage and row: run.h. Settings and what they are without being given:
 *
 *   form=plane         how the segments are held together (simbody_chain.h): free6, free3, plane or pins for the
 * straight pull; free6 or links for the chain integrator=band    one of simbody_run.h accuracy=1e-3      the
 * integrator's step=0             s: fixed step, or CPodes' largest; 0: chosen by the error settle=0.3         s before
 * the pull begins, for the cable to come to rest on the rollers damping=1e-3       s: damping over stiffness of all
 * joints stiff=1            stiffness against stretch and shear over table 1's */
#include "bench/peers/run.h"

#include "bench/peers/simbody_run.h"

static const std::vector<std::pair<const char *, Form>> FORMS = {{"free6", Form::free6},
                                                                 {"free3", Form::free3},
                                                                 {"plane", Form::plane},
                                                                 {"pins", Form::pins},
                                                                 {"links", Form::links}};

/* The setting `form`; ends the program if it does not fit the problem. */
static Form form_of(PeerRun *run)
{
    const bool straight = run->problem == PEER_STRAIGHT;
    const char *const word = peer_word(run, "form", straight ? "plane" : "free6");
    for (const auto &form : FORMS) {
        const bool fits = form.second == Form::free6 || (form.second == Form::links) != straight;
        if (strcmp(form.first, word) == 0 && fits) return form.second;
    }
    peer_stop(run, "has for this problem no form", word);
    return Form::free6;
}

static Method method_of(PeerRun *run)
{
    Method method;
    method.name = peer_word(run, "integrator", "band");
    method.accuracy = peer_number(run, "accuracy", 1e-3);
    method.step = peer_number(run, "step", 0);
    method.over = [run] { return peer_over_limit(run) != 0; };
    if (!method_exists(method.name)) peer_stop(run, "has no integrator", method.name.c_str());
    return method;
}

/* What the problem is judged by, of the state of now. */
static void look(PeerRun *run, const Chain &chain, const SimTK::State &state)
{
    if (run->problem == PEER_SWING) {
        const SimTK::Vec3 at = chain.middle(state);
        peer_place(run, state.getTime(), -at[2], at[1]);
    } else if (state.getTime() >= -1e-9)
        peer_force(run, state.getTime(), chain.force(state));
}

int main(int argc, char **argv)
{
    static PeerRun run;
    peer_start(&run, "simbody", argc, argv);
    const Form form = form_of(&run);
    const Method method = method_of(&run);
    const double settle = peer_number(&run, "settle", run.problem == PEER_STRAIGHT ? 0.3 : 0);
    const double damping = peer_number(&run, "damping", 1e-3), stiff = peer_number(&run, "stiff", 1);
    if (method.name == "band" && (form == Form::pins || form == Form::links))
        peer_stop(&run, "has the band solver for free bodies only, not", "pins or links");
    Chain chain({run.problem, run.n, form, stiff, damping});
    SimTK::State state = chain.initial_state(-settle);
    peer_loop(&run);
    /* Chains of springs ring; a tree's support asks for accelerations. */
    const double force_every = run.problem == PEER_HANG && form != Form::links ? 1e-3 : 0.01;
    const double every = run.problem == PEER_SWING ? TRACE_EVERY : force_every;
    const Report report = [&](const SimTK::State &now) { look(&run, chain, now); };
    Outcome outcome = {0, 0, false};
    if (settle > 0) {
        Method rough = method;
        rough.accuracy = std::max(method.accuracy, 1e-3);
        outcome = run_chain(chain, state, rough, 0, settle, [](const SimTK::State &) {});
        state.setTime(0);
    }
    chain.system.realize(state, SimTK::Stage::Velocity);
    if (run.problem != PEER_HANG) report(state); /* joints that are springs carry nothing yet */
    if (!outcome.failed && !method.over()) {
        const long before = outcome.steps;
        outcome = run_chain(chain, state, method, run.until, every, report);
        outcome.steps += before;
    }
    peer_finish(&run, std::max(0., outcome.reached), outcome.steps, outcome.failed);
    return 0;
}
