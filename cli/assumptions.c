/* What a run was computed with that its case did not say, in a few lines: `hawser check` has the list. */
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

/* Whether a dotted key ends in this name. */
static int is_key(const char *key, const char *name)
{
    const char *const dot = strrchr(key, '.');
    return dot && strcmp(dot + 1, name) == 0;
}

/* Of what is not in the route. */
enum { SAID_MOST = 3 };

/* Of the estimates only EI changes a run, so that it is said what it is worth. */
void report_assumptions(const hawser_sim *s, hawser_units units)
{
    const hawser_assumption *list;
    const int n = hawser_sim_assumptions(s, &list);
    char line[1024], shown[1024];
    int taken = 0, estimated = 0, left = 0;
    for (int i = 0; i < n; i++) {
        taken += strcmp(list[i].origin, "catalogue") == 0;
        estimated += strcmp(list[i].origin, "estimated") == 0;
        left += strcmp(list[i].origin, "not read") == 0;
    }
    if (left) printf("\nNot in the route, of its file%s:\n", left > SAID_MOST ? " (hawser check lists all)" : "");
    for (int i = 0, said = 0; i < n && said < SAID_MOST; i++) {
        if (strcmp(list[i].origin, "not read") != 0) continue;
        printf("  %s\n", list[i].source);
        ++said;
    }
    if (taken + estimated == 0) return;
    printf("\nAssumed: %d values from the catalogue, %d estimated (hawser check lists them)\n", taken, estimated);
    for (int i = 0; i < n; i++) {
        if (strcmp(list[i].origin, "estimated") != 0 || !is_key(list[i].key, "EI")) continue;
        snprintf(line, sizeof line, "  %s = %s %s\n", list[i].key, list[i].value, list[i].source);
        fputs(hawser_show_text(line, units, shown, sizeof shown), stdout);
    }
}
