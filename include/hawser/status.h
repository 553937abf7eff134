/* Status of a call; versions. Part of hawser/hawser.h, which includes it. */
#ifndef HAWSER_STATUS_H
#define HAWSER_STATUS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A case and a simulation of it (hawser/hawser.h); their contents are the library's. */
typedef struct hawser_case hawser_case;
typedef struct hawser_sim hawser_sim;
/* Receives the progress of a run (hawser_sim_run). */
struct hawser_sample;
typedef int (*hawser_progress)(void *user, const struct hawser_sample *sample, double wall_s, double end_s);

typedef enum hawser_status {
    HAWSER_OK = 0,
    HAWSER_ERR_INPUT = 2,  /* a case, a setting or an argument is wrong; nothing was written */
    HAWSER_ERR_RUN = 3,    /* the integration failed; what was computed before is kept */
    HAWSER_ERR_OUTPUT = 4, /* a result could not be written */
    HAWSER_ERR_MEMORY = 5,
    HAWSER_STOPPED = 130 /* stopped because the caller requested it */
} hawser_status;

/* Cause of an error, for programs. Set it to {0} and pass it on: the fields hold what the message states in one line.
 * An unknown one stays "", 0 or, for a segment, -1. */
enum { HAWSER_MESSAGE_MAX = 1024, HAWSER_KEY_MAX = 192, HAWSER_FILE_MAX = 256 };
typedef struct hawser_error {
    hawser_status status;
    char message[HAWSER_MESSAGE_MAX];
    char key[HAWSER_KEY_MAX];   /* dotted key of the case: "drive.winch.speed"; or the name of an argument */
    char file[HAWSER_FILE_MAX]; /* file of the case */
    int line;                   /* from 1 */
    int segment;                /* number in the whole chain where the integration failed */
    double t_s;                 /* simulated time of the failure */
    double reserved[16];
} hawser_error;

/* Versions, of this header and of the library that runs: they may differ within a SONAME (docs/guide/c.md, "Growing").
 */
#define HAWSER_VERSION_MAJOR  0
#define HAWSER_VERSION_MINOR  2
#define HAWSER_VERSION_PATCH  0
#define HAWSER_VERSION_NUMBER (10000 * HAWSER_VERSION_MAJOR + 100 * HAWSER_VERSION_MINOR + HAWSER_VERSION_PATCH)
const char *hawser_version(void);
/* Returns HAWSER_VERSION_NUMBER of the library. */
int hawser_version_number(void);

/* Formats: text for readers, in SI or in US units (hawser/shown.h); for programs, always in SI. */
typedef enum hawser_format { HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV, HAWSER_TABLE_US } hawser_format;

#ifdef __cplusplus
}
#endif

#endif
