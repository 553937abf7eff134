/* The controller of hold-tension.ipynb in C: prints time, force and speed of every look, for test_control.py. */
#include <hawser/hawser.h>
#include <stdio.h>

int main(int n, char **argument)
{
    const double target = 800, gain = 1e-5, belt = 0.1, interval = 0.05;
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_status status = hawser_case_load(n > 1 ? argument[1] : "", &c, &err);
    if (!status) status = hawser_sim_new(c, NULL, &sim, &err);
    hawser_case_free(c);
    if (!status) status = hawser_sim_relax(sim, NULL, &err);
    if (!status) status = hawser_sim_advance(sim, 2, 0, &err);
    for (int k = 0; !status; k++) {
        const double t = 2 + k * interval, end = hawser_sim_end_time(sim);
        status = hawser_sim_advance(sim, t < end ? t : end, 0, &err);
        if (status) break;
        const hawser_sample *look = hawser_sim_sample(sim);
        double speed = belt + gain * (target - look->winch_force);
        if (speed < 0) speed = 0;
        if (speed > 2 * belt) speed = 2 * belt;
        printf("%.17g %.17g %.17g\n", look->t, look->winch_force, speed);
        if (look->t >= end) break;
        if (k == 120) status = hawser_sim_control(sim, HAWSER_FRICTION, NULL, 1.5, 0.5, &err);
        if (!status) status = hawser_sim_control(sim, HAWSER_WINCH_SPEED, NULL, speed, interval, &err);
    }
    if (status) fprintf(stderr, "%s\n", err.message);
    hawser_sim_free(sim);
    return status;
}
