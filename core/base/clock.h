/* Wall time for the phase table. */
#ifndef HAWSER_CORE_BASE_CLOCK_H
#define HAWSER_CORE_BASE_CLOCK_H

/* Seconds of a clock that never goes back. */
double clock_now(void);

#endif
