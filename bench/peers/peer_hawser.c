/* hawser's side of the comparison: the problems of problem.h through the library, one thread, nothing written.
 * Settings: accuracy=A and interval=S (the case keys solver.accuracy, output.interval, which bounds the step),
 * method=bdf|esdirk|auto (solver.method), planar=off (the straight pull in space), stiff=F (chain: the links' rigidity
 * over table 1's). Usage and row: run.h.
 */
#include <stdlib.h>

#include "bench/peers/run.h"
#include "bench/straight_scene.h"
#include "sim/run/sim.h"

/* The straight scene is that of cases/straight.yaml; only the window differs. */
static int define_straight(SceneDef *def, int n)
{
    if (!straight_scene(def, n)) return 0;
    def->duration = WINDOW_TO;
    def->output.steady_from = WINDOW_FROM;
    return 1;
}

/* A link is rigid: table 1's cable, so much stiffer, without bending, torsion and rotary differences to a solid bar. */
static CableDef chain_cable(double stiff)
{
    CableDef cable = straight_cable();
    cable.ea *= stiff;
    cable.ga *= stiff;
    cable.gj = cable.ei_y = cable.ei_z = 1e-3; /* N m2: none to speak of */
    return cable;
}

/* Both ends are pinned; the shape is the polyline of the joints. */
static int define_chain(SceneDef *def, int n, double angle, double stiff)
{
    scene_def_defaults(def);
    def->cables = malloc(sizeof *def->cables);
    def->pieces = malloc(sizeof *def->pieces);
    def->route = calloc(1, sizeof *def->route);
    def->output.probes = calloc(1, sizeof *def->output.probes);
    def->rod.points = calloc((size_t)n + 1, sizeof *def->rod.points);
    double *const joint = malloc(3 * ((size_t)n + 1) * sizeof *joint);
    if (!def->cables || !def->pieces || !def->route || !def->rod.points || !def->output.probes || !joint) return 0;
    def->n_cables = def->n_pieces = def->n_route = def->output.n_probes = 1;
    def->cables[0] = chain_cable(stiff);
    def->pieces[0] = (ChainPieceDef){.length = PEER_LINK * n, .segments = n};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "chain", .length = PEER_LINK * n};
    def->head_at = PEER_LINK * n;
    def->output.probes[0] =
        (ProbeDef){.name = "middle", .at = PEER_LINK * (chain_middle_segment(n) + 0.5) + chain_middle_arm(n)};
    chain_joints(n, angle, joint);
    for (int i = 0; i <= n; ++i) def->rod.points[i] = v3(joint[3 * i], joint[3 * i + 1], joint[3 * i + 2]);
    free(joint);
    def->rod.present = def->rod.stress_free = 1;
    def->rod.shape = ROD_POLYLINE;
    def->rod.n_points = n + 1;
    for (int e = 0; e < 2; ++e) {
        def->rod.end[e].pivot = 1;
        for (int c = 0; c < 3; ++c) def->rod.end[e].held[c] = 1;
    }
    return 1;
}

/* The run's word for solver.method; the default's without one. Ends the program at another word. */
static MethodChoice method_of(PeerRun *run, MethodChoice usual)
{
    const char *const word = peer_word(run, "method", "");
    if (!*word) return usual;
    if (strcmp(word, "bdf") == 0) return METHOD_BDF;
    if (strcmp(word, "esdirk") == 0) return METHOD_ESDIRK;
    if (strcmp(word, "auto") != 0) peer_stop(run, "has no method", word);
    return METHOD_AUTO;
}

/* The definition of the run's problem; 0 without memory. Solver and tolerances are the defaults but for what a setting
 * says. */
static int define(SceneDef *def, PeerRun *run)
{
    const double stiff = peer_number(run, "stiff", 1);
    const int made = run->problem == PEER_STRAIGHT ? define_straight(def, run->n)
                                                   : define_chain(def, run->n, chain_angle(run->problem), stiff);
    def->output.interval = peer_number(run, "interval", def->output.interval);
    def->solver.accuracy = peer_number(run, "accuracy", def->solver.accuracy);
    def->solver.method = method_of(run, def->solver.method);
    if (strcmp(peer_word(run, "planar", "auto"), "off") == 0) def->solver.planar = PLANAR_OFF;
    if (run->problem != PEER_STRAIGHT) def->duration = peer_end(run->problem);
    return made;
}

/* The chain's middle moves with its segment. */
static void look_at_middle(PeerRun *run, const hawser_sample *sample)
{
    const int at = 3 * chain_middle_segment(run->n);
    const double *const place = sample->probe[0].position, *const omega = sample->omega + at;
    double arm[3];
    for (int c = 0; c < 3; ++c) arm[c] = place[c] - sample->position[at + c];
    const double speed[2] = {sample->velocity[at + 1] + omega[2] * arm[0] - omega[0] * arm[2],
                             sample->velocity[at + 2] + omega[0] * arm[1] - omega[1] * arm[0]};
    peer_place_moving(run, sample->t, place + 1, speed);
}

/* Takes what the problem is judged by out of the state of now; of the pull not before it has its speed. */
static void look(PeerRun *run, Sim *sim)
{
    if (run->problem == PEER_STRAIGHT && hawser_sim_time(sim) < STRAIGHT_RAMP) return;
    const hawser_sample *const sample = hawser_sim_sample(sim);
    if (run->problem == PEER_STRAIGHT) peer_force(run, sample->t, sample->winch_force);
    if (run->problem == PEER_HANG) peer_force(run, sample->t, sample->probe[0].force[0]);
    if (run->problem == PEER_SWING) look_at_middle(run, sample);
}

/* Steps of the integrator's own. A pull and the chain at rest begin in equilibrium, of their own stiffness. */
static hawser_status integrate(PeerRun *run, Sim *sim, hawser_error *err)
{
    hawser_relaxation relaxation;
    hawser_status status = run->problem != PEER_SWING ? sim_relax(sim, &relaxation, err) : HAWSER_OK;
    look(run, sim);
    while (!status && hawser_sim_time(sim) < run->until - 1e-12 && !peer_over_limit(run)) {
        status = sim_advance(sim, run->until, 1, err);
        look(run, sim);
    }
    return status;
}

int main(int argc, char **argv)
{
    static PeerRun run;
    SceneDef def;
    Sim *sim = NULL;
    hawser_error err;
    hawser_summary summary;
    peer_start(&run, "hawser", argc, argv);
    hawser_status status = define(&def, &run) ? sim_new(&def, 1, &sim, &err) : HAWSER_ERR_MEMORY;
    scene_def_clear(&def);
    if (status) peer_stop(&run, "cannot build the scene:", status == HAWSER_ERR_MEMORY ? "no memory" : err.message);
    peer_loop(&run);
    status = integrate(&run, sim, &err);
    if (status) fprintf(stderr, "hawser: %s\n", err.message);
    hawser_sim_summary(sim, &summary);
    peer_finish(&run, hawser_sim_time(sim), summary.steps, status != HAWSER_OK);
    sim_free(sim);
    return 0;
}
