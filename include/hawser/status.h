/* What every call says of how it went; versions. Part of hawser/hawser.h, which includes it. */
#ifndef HAWSER_STATUS_H
#define HAWSER_STATUS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum hawser_status {
    HAWSER_OK = 0,
    HAWSER_ERR_INPUT = 2,  /* a case, a setting or an argument is wrong; nothing was written */
    HAWSER_ERR_RUN = 3,    /* the integration failed; what was computed before is kept */
    HAWSER_ERR_OUTPUT = 4, /* a result could not be written */
    HAWSER_ERR_MEMORY = 5,
    HAWSER_STOPPED = 130 /* stopped because the caller asked for it */
} hawser_status;

enum { HAWSER_MESSAGE_MAX = 1024 };
typedef struct hawser_error {
    hawser_status status;
    char message[HAWSER_MESSAGE_MAX];
} hawser_error;

const char *hawser_version(void);

/* Text for people, in SI or in US units (hawser/shown.h); for programs, in SI always. */
typedef enum hawser_format { HAWSER_TABLE, HAWSER_JSON, HAWSER_CSV, HAWSER_TABLE_US } hawser_format;

#ifdef __cplusplus
}
#endif

#endif
