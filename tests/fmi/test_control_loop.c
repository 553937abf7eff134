/* A controller that holds the tension by the winch's speed: through FMI 2.0, FMI 3.0 and the library the same forces;
 * many instances, on threads, do not see each other; the other inputs do what they say. */
#include <pthread.h>

#include "tests/fmi/fixture.h"

enum { LOOKS = 60, FEW = 10 };
static const double target = 800, gain = 1e-5, belt = 0.1, interval = 0.05; /* N, m/s/N, m/s, s */

static double controller(double force) { return fmin(fmax(belt + gain * (target - force), 0), 2 * belt); }

/* Forces every 0.05 s from 2 s on. */
static void forces_of_library(int looks, double force[])
{
    hawser_sim *const s = sim_of(data_text("hold-tension"));
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = hawser_sim_advance(s, 2, 0, &err);
    for (int k = 0; k < looks && !status; ++k) {
        force[k] = hawser_sim_sample(s)->winch_force;
        status = hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, controller(force[k]), interval, &err);
        if (!status) status = hawser_sim_advance(s, 2 + interval * (k + 1), 0, &err);
    }
    if (status) fail_msg("%s", err.message);
    hawser_sim_free(s);
}

static void forces_of_instance(FmuInstance *i, int looks, double force[])
{
    assert_int_equal(instance_set(i, "inputs.ramp", interval), 0);
    assert_int_equal(instance_step(i, 0, 2), 0);
    for (int k = 0; k < looks; ++k) {
        const double t = 2 + interval * k;
        force[k] = instance_value(i, "winch.force");
        assert_int_equal(instance_set(i, "winch.speed", controller(force[k])), 0);
        assert_int_equal(instance_step(i, t, 2 + interval * (k + 1) - t), 0);
    }
}

/* To 1e-9 of the tension that is held; and it is held. */
TEST(test_controller)
{
    double library[LOOKS];
    forces_of_library(LOOKS, library);
    check_below(library[0], 600);
    check_close(library[LOOKS - 1], target, 0.01 * target);
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        double force[LOOKS], error = 0;
        fmu_of(&fmu, data_text("hold-tension"), version);
        FmuInstance *const i = instance_of(&fmu);
        forces_of_instance(i, LOOKS, force);
        for (int k = 0; k < LOOKS; ++k) error = larger_of(error, fabs(force[k] - library[k]));
        check_at_most(error, 1e-9 * target);
        assert_int_equal(instance_count(i, "events.count"), LOOKS);
        check_has(instance_text(i, "events.last"), "command: winch_speed");
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* The controller as a unit of somebody else's: the two exchange force and speed at each step, and the forces are the
 * same to the last bit as with the controller in this program. */
TEST(test_two_units)
{
    double one[LOOKS];
    Fmu pull_fmu, other_fmu;
    fmu_of(&pull_fmu, data_text("hold-tension"), 3);
    fmu_open(&other_fmu, HAWSER_CONTROLLER);
    FmuInstance *const alone = instance_of(&pull_fmu), *const pull = instance_of(&pull_fmu),
                       *const other = instance_of(&other_fmu);
    forces_of_instance(alone, LOOKS, one);
    assert_int_equal(instance_set(pull, "inputs.ramp", interval), 0);
    assert_int_equal(instance_step(pull, 0, 2), 0);
    for (int k = 0; k < LOOKS; ++k) {
        const double t = 2 + interval * k, step = 2 + interval * (k + 1) - t;
        check_equal(instance_value(pull, "winch.force"), one[k]);
        assert_int_equal(instance_set(other, "force", instance_value(pull, "winch.force")), 0);
        assert_int_equal(instance_step(other, t, step), 0);
        assert_int_equal(instance_set(pull, "winch.speed", instance_value(other, "speed")), 0);
        assert_int_equal(instance_step(pull, t, step), 0);
    }
    check_close(instance_value(pull, "winch.force"), target, 0.01 * target);
    instance_drop(alone);
    instance_drop(pull);
    instance_drop(other);
    fmu_close(&pull_fmu);
    fmu_close(&other_fmu);
}

/* Its own time may begin anywhere; the motion is the same up to the rounding of times. */
TEST(test_start)
{
    Fmu fmu;
    fmu_of(&fmu, data_text("hold-tension"), 3);
    FmuInstance later, *const now = instance_of(&fmu);
    instance_new(&later, &fmu, fmu.token, fmu.resources);
    assert_int_equal(instance_begin(&later, 64), 0);
    assert_int_equal(instance_settle(&later), 0);
    check_equal(instance_value(&later, "time"), 64);
    assert_int_equal(instance_step(&later, 64, 1), 0);
    assert_int_equal(instance_step(now, 0, 1), 0);
    check_equal(instance_value(&later, "winch.force"), instance_value(now, "winch.force"));
    check_equal(instance_value(&later, "time"), 65);
    instance_free(&later);
    instance_drop(now);
    fmu_close(&fmu);
}

typedef struct Job {
    FmuInstance *i;
    double force[FEW];
} Job;

static void *job_run(void *job)
{
    Job *const j = job;
    forces_of_instance(j->i, FEW, j->force);
    return NULL;
}

/* Four of two archives, each on a thread of its own, do what one does alone. */
TEST(test_threads)
{
    enum { JOBS = 4 };
    Fmu fmu[2];
    Job job[JOBS];
    pthread_t thread[JOBS];
    double library[FEW];
    forces_of_library(FEW, library);
    for (int v = 0; v < 2; ++v) fmu_of(&fmu[v], data_text("hold-tension"), 2 + v);
    for (int k = 0; k < JOBS; ++k) job[k].i = instance_of(&fmu[k % 2]);
    for (int k = 0; k < JOBS; ++k) assert_int_equal(pthread_create(&thread[k], NULL, job_run, &job[k]), 0);
    for (int k = 0; k < JOBS; ++k) pthread_join(thread[k], NULL);
    for (int k = 0; k < JOBS; ++k) {
        double error = 0;
        for (int n = 0; n < FEW; ++n) error = larger_of(error, fabs(job[k].force[n] - library[n]));
        check_at_most(error, 1e-9 * target);
        instance_drop(job[k].i);
    }
    fmu_close(&fmu[0]);
    fmu_close(&fmu[1]);
}

/* Brake and pause hold the winch until they are let go. */
TEST(test_brakes)
{
    static const char *const held[] = {"winch.brake", "winch.pause"};
    Fmu fmu;
    fmu_of(&fmu, data_text("short-pull"), 2);
    FmuInstance *const i = instance_of(&fmu);
    step_to(i, 1);
    check_close(instance_value(i, "winch.rope_speed"), 0.1, 1e-12);
    for (int k = 0; k < 2; ++k) {
        assert_int_equal(instance_switch(i, held[k], 1), 0);
        step_to(i, 1.4 + k);
        check_close(instance_value(i, "winch.rope_speed"), 0, 1e-12);
        assert_int_equal(instance_switch(i, held[k], 0), 0);
        step_to(i, 1.8 + k);
        check_close(instance_value(i, "winch.rope_speed"), 0.1, 1e-12);
    }
    instance_drop(i);
    fmu_close(&fmu);
}

/* A conveyor that is slower than the winch brakes with its grip; with less clamp it grips less; it jams and is free. */
TEST(test_inputs)
{
    Fmu fmu;
    fmu_of(&fmu, data_text("hold-tension"), 3);
    FmuInstance *const i = instance_of(&fmu);
    step_to(i, 1.5);
    assert_int_equal(instance_set(i, "conveyors.K.speed", 0.05), 0);
    step_to(i, 2.2);
    check_close(instance_value(i, "conveyors.K.force"), -2 * 0.4 * 4000, 1e-3 * 3200);
    assert_int_equal(instance_set(i, "conveyors.K.clamp", 100), 0);
    step_to(i, 2.6);
    check_at_most(fabs(instance_value(i, "conveyors.K.force")), 2 * 0.4 * 100);
    assert_int_equal(instance_switch(i, "conveyors.K.jam", 1), 0);
    step_to(i, 2.7);
    check_has(instance_text(i, "events.last"), "jam");
    assert_int_equal(instance_switch(i, "conveyors.K.jam", 0), 0);
    assert_int_equal(instance_set(i, "friction.factor", 2), 0);
    step_to(i, 2.8);
    check_has(instance_text(i, "events.last"), "friction 2");
    instance_drop(i);
    fmu_close(&fmu);
}
