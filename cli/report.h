/* The report at a run's end. */
#ifndef HAWSER_CLI_REPORT_H
#define HAWSER_CLI_REPORT_H

#include "hawser/hawser.h"

/* What is about to be run: the case and its counts. */
void report_scene(const hawser_sim *s);
/* Pull force, tension errors, speed, rollers, work, where the time went. `dir`: where the results are. */
void report_run(hawser_sim *s, const char *dir);

#endif
