/* Loads the library of an unpacked unit and holds the tension by the winch's speed. docs/guide/fmi.md */
#include <dlfcn.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef void *Instance;
typedef void (*Log)(void *, int status, const char *category, const char *message);
typedef Instance (*Instantiate)(const char *, const char *, const char *, bool, bool, bool, bool, const uint32_t *, size_t,
                                void *, Log, void *);
typedef int (*Begin)(Instance, bool, double, double, bool, double);
typedef int (*Call)(Instance);
typedef void (*Free)(Instance);
typedef int (*Get)(Instance, const uint32_t *, size_t, double *, size_t);
typedef int (*Set)(Instance, const uint32_t *, size_t, const double *, size_t);
typedef int (*Step)(Instance, double, double, bool, bool *, bool *, bool *, double *);

static void say(void *user, int status, const char *category, const char *message)
{
    (void)user;
    fprintf(stderr, "%d %s: %s\n", status, category, message);
}

/* Arguments: library, token, folder of the resources; references of winch.force, winch.speed, inputs.ramp. */
int main(int n, char **argument)
{
    void *const library = n == 7 ? dlopen(argument[1], RTLD_NOW) : NULL;
    if (!library) return 2;
    const Instantiate instantiate = (Instantiate)dlsym(library, "fmi3InstantiateCoSimulation");
    const Begin begin = (Begin)dlsym(library, "fmi3EnterInitializationMode");
    const Call settle = (Call)dlsym(library, "fmi3ExitInitializationMode"), end = (Call)dlsym(library, "fmi3Terminate");
    const Get get = (Get)dlsym(library, "fmi3GetFloat64");
    const Set set = (Set)dlsym(library, "fmi3SetFloat64");
    const Step step = (Step)dlsym(library, "fmi3DoStep");
    const uint32_t force_at = (uint32_t)atoi(argument[4]), speed_at = (uint32_t)atoi(argument[5]),
                   ramp_at = (uint32_t)atoi(argument[6]);
    const double target = 800, gain = 1e-5, belt = 0.1, interval = 0.05; /* N, m/s/N, m/s, s */
    bool event, over = false, early;
    double reached = 0, force = 0;
    const Instance pull =
        instantiate("pull", argument[2], argument[3], false, false, false, false, NULL, 0, NULL, say, NULL);
    int status = pull ? begin(pull, false, 0, 0, false, 0) : 3;
    if (!status) status = set(pull, &ramp_at, 1, &interval, 1);
    if (!status) status = settle(pull);
    if (!status) status = step(pull, 0, 2, true, &event, &over, &early, &reached); /* the winch comes up to speed */
    for (int k = 0; k < 60 && !status && !over; k++) {
        status = get(pull, &force_at, 1, &force, 1);
        double speed = belt + gain * (target - force);
        if (speed < 0) speed = 0;
        if (speed > 2 * belt) speed = 2 * belt;
        if (k % 20 == 0) printf("t = %.1f s: %.1f N\n", reached, force);
        if (!status) status = set(pull, &speed_at, 1, &speed, 1);
        if (!status) status = step(pull, reached, interval, true, &event, &over, &early, &reached);
    }
    if (!status) status = get(pull, &force_at, 1, &force, 1);
    printf("t = %.1f s: %.1f N\n", reached, force);
    if (!status) status = end(pull);
    if (pull) ((Free)dlsym(library, "fmi3FreeInstance"))(pull);
    return status;
}
