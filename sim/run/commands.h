/* Commands to a running simulation, by its caller or by the case's script, and its call-backs. docs/theory.md,
 * "Control". */
#ifndef HAWSER_SIM_RUN_COMMANDS_H
#define HAWSER_SIM_RUN_COMMANDS_H

#include "sim/run/parts.h"

/* Carries out a command at the present time and records it as an event. Errors: INPUT (nothing has the name, or it does
 * not support the command: nothing has changed then), MEMORY, RUN. */
hawser_status sim_command(Sim *s, const Command *c, hawser_error *err);
/* Carries out the rows of the case's script that are due; the second returns the time of the next one, s; INFINITY:
 * none. */
hawser_status script_due(Sim *s, hawser_error *err);
double script_next(const Sim *s);

/* Records an event at t with the winch's pull at that time, and calls the caller's call-back. Errors: MEMORY. */
hawser_status sim_note(Sim *s, hawser_event_code code, double t, const char *what, double pull, hawser_error *err);
/* Passes a line to the caller's log. */
void sim_log(const Sim *s, hawser_log_level level, const char *text);
/* Calls the caller's call-back after an accepted step. Errors: STOPPED, if a call-back requested it. */
hawser_status sim_call(Sim *s, hawser_error *err);
/* Checks whether the caller's force law is being called, for this chain or for one that moves together with it. */
int sim_in_law(Sim *s);
/* Returns status; if the force law has returned NAN or infinity, RUN with a message that names it. */
hawser_status sim_blame_law(Sim *s, hawser_status status, hawser_error *err);

/* Size in bytes of everything that commands have changed and of the script's position; saving into and loading from
 * memory of that size. The simulation that loads was built from the same case and is at the time of the saving. Errors
 * of loading: INPUT (another size), and as sim_command. */
size_t controls_size(Sim *s);
void controls_save(Sim *s, void *to);
hawser_status controls_load(Sim *s, const void *from, size_t size, hawser_error *err);

#endif
