/* Holds the pull at 3 kN by the winch's speed; a reel with a proportional brake resists. docs/guide/c.md */
#include <hawser/hawser.h>
#include <stdio.h>

static const char text[] = "cables: {power: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 14 kg/m},\n"
                           "         rope: {EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 50 N m2, d: 14 mm, mass: 0.7 kg/m}}\n"
                           "chain: [{cable: power, length: 60 m}, {cable: rope, length: 20 m}]\n"
                           "route: {head_at: 8 m, pieces: [{straight: 30 m}]}\n"
                           "rollers: {along: {spacing: 1 m}}\n"
                           "reel: {distance: 6 m, barrel: 1.2 m, flange: 2 m, width: 1 m, inertia: 800 kg m2,\n"
                           "       brake: {law: proportional, torque: 1 kN m, speed: 0.1 m/s}}\n"
                           "drive: {winch: {speed: 0.1 m/s}}\n"
                           "run: {duration: 20 s}\n";

int main(void)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    double speed = 0.1;
    hawser_status status = hawser_case_parse(text, "controller", &c, &err);
    if (!status) status = hawser_sim_new(c, NULL, &sim, &err);
    if (!status) status = hawser_sim_relax(sim, NULL, &err);
    for (int k = 1; k <= 200 && !status; k++) {
        status = hawser_sim_advance(sim, 0.1 * k, 0, &err);
        const double pull = hawser_sim_sample(sim)->winch_force;
        if (k % 50 == 0) printf("t = %2d s: %.0f N at %.3f m/s\n", k / 10, pull, speed);
        if (k < 20 || status) continue;
        speed += 2e-6 * (3000 - pull);
        status = hawser_sim_control(sim, HAWSER_WINCH_SPEED, NULL, speed, 0.1, &err);
    }
    if (status) fprintf(stderr, "%s\n", err.message);
    hawser_sim_free(sim);
    hawser_case_free(c);
    return (int)status;
}
