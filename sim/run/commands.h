/* What a simulation is told while it runs, by its caller or by the case's script, and whom it calls. docs/model.md,
 * "Control". */
#ifndef HAWSER_SIM_RUN_COMMANDS_H
#define HAWSER_SIM_RUN_COMMANDS_H

#include "sim/run/parts.h"

/* Carries out a command at the time of now, which notes it as an event. Errors: INPUT (nothing has the name, or it
 * cannot do that: nothing has changed then), MEMORY, RUN. */
hawser_status sim_command(Sim *s, const Command *c, hawser_error *err);
/* The rows of the case's script that are due, and when the next one is, s; INFINITY: none. */
hawser_status script_due(Sim *s, hawser_error *err);
double script_next(const Sim *s);

/* Notes an event at t with the winch's pull then, and tells the caller. Errors: MEMORY. */
hawser_status sim_note(Sim *s, hawser_event_code code, double t, const char *what, double pull, hawser_error *err);
/* Says a line to who wants to know. */
void sim_log(const Sim *s, hawser_log_level level, const char *text);
/* A step was accepted: who wanted to be called. Errors: STOPPED, if one of those who were called asked for it. */
hawser_status sim_call(Sim *s, hawser_error *err);
/* Whether a law of force of the caller's is being called, of this chain or of one that moves together with it. */
int sim_in_law(Sim *s);
/* Returns status; RUN with a message that names the law of force, if it has given what is no number. */
hawser_status sim_blame_law(Sim *s, hawser_status status, hawser_error *err);

/* All that commands have changed and how far the script is, in bytes; into and out of memory of that size. A
 * simulation into which it is loaded was built from the same case and stands at the time of the saving. Errors of
 * loading: INPUT (another size), and as sim_command. */
size_t controls_size(Sim *s);
void controls_save(Sim *s, void *to);
hawser_status controls_load(Sim *s, const void *from, size_t size, hawser_error *err);

#endif
