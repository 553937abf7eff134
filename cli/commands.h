/* The commands: each takes the arguments and returns the exit status. */
#ifndef HAWSER_CLI_COMMANDS_H
#define HAWSER_CLI_COMMANDS_H

#include "cli/arguments.h"

extern const Command command_run, command_check, command_theory, command_validate;

/* Loads the case and applies the settings of the command line. *out is NULL on failure. */
hawser_status load_case(const Arguments *args, hawser_case **out, hawser_error *err);

#endif
