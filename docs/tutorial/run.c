#include <hawser/hawser.h>
#include <stdio.h>

static const char text[] = "title: Ten metres of cable over a row of rollers\n"
                           "cables:\n"
                           "  power: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}\n"
                           "chain:\n"
                           "  - {cable: power, length: 10 m, segment: 500 mm}\n"
                           "route:\n"
                           "  head_at: 12 m\n"
                           "  pieces: [{straight: 20 m}]\n"
                           "rollers:\n"
                           "  along: {spacing: 1 m}\n"
                           "friction: {mu: 0.2}\n"
                           "drive:\n"
                           "  winch: {speed: 6 m/min, to: 1 s}\n"
                           "run: {duration: 3 s, steady_from: 2 s}\n"
                           "output:\n"
                           "  stations: [{name: middle, at: 7 m}]\n";

/* A simulation of the text with another friction; NULL with a message if something is wrong. */
static hawser_sim *make(const char *friction)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_status status = hawser_case_parse(text, "example", &c, &err);
    if (!status) status = hawser_case_set(c, "friction.mu", friction, &err);
    if (!status) status = hawser_sim_new(c, NULL, &sim, &err);
    if (status) fprintf(stderr, "%s\n", err.message);
    hawser_case_free(c);
    return sim;
}

/* Everything in one call. */
static int run_at_once(hawser_sim *sim)
{
    hawser_error err = {0};
    hawser_summary sum;
    const hawser_station *station;
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) {
        fprintf(stderr, "%s\n", err.message);
        return 0;
    }
    hawser_sim_summary(sim, &sum);
    printf("pull %.1f N, theory %.1f N\n", sum.pull_mean_N, sum.reference_total_N);
    for (int i = 0; i < hawser_sim_stations(sim, &station); i++) {
        printf("%s: %.1f N at s = %g m\n", station[i].name, station[i].mean_N, station[i].s);
    }
    return 1;
}

/* The same by hand: look at the state ten times a second. */
static int run_by_hand(hawser_sim *sim)
{
    hawser_error err = {0};
    hawser_status status = hawser_sim_relax(sim, NULL, &err);
    for (int k = 1; k <= 30 && !status; k++) {
        status = hawser_sim_advance(sim, 0.1 * k, 0, &err);
        const hawser_sample *look = hawser_sim_sample(sim);
        if (k % 10 == 0) printf("t = %.1f s: winch pulls %.1f N\n", look->t, look->winch_force);
    }
    if (status) fprintf(stderr, "%s\n", err.message);
    return !status;
}

int main(void)
{
    hawser_sim *first = make("0.2"), *second = make("0.3");
    const int ok = first && second && run_at_once(first) && run_by_hand(second);
    hawser_sim_free(first);
    hawser_sim_free(second);
    return ok ? 0 : 1;
}
