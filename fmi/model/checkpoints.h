/* Whether simulations can be saved to memory and read back (hawser/checkpoint.h); a tree without that says no. */
#ifndef HAWSER_FMI_MODEL_CHECKPOINTS_H
#define HAWSER_FMI_MODEL_CHECKPOINTS_H

#include <stdlib.h>

#include "core/base/error.h"

#if __has_include("include/hawser/checkpoint.h")
enum { HAS_CHECKPOINTS = 1 };
#else
enum { HAS_CHECKPOINTS = 0 };
static inline hawser_status hawser_sim_save_memory(hawser_sim *s, void **bytes, size_t *size, hawser_error *err)
{
    (void)s, (void)bytes, (void)size;
    return error_set(err, HAWSER_ERR_INPUT, "states cannot be saved");
}
static inline hawser_status hawser_sim_load_memory(hawser_sim *s, const void *bytes, size_t size, hawser_error *err)
{
    (void)s, (void)bytes, (void)size;
    return error_set(err, HAWSER_ERR_INPUT, "states cannot be read");
}
static inline void hawser_bytes_free(void *bytes) { free(bytes); }
#endif

#endif
