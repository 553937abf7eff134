/* Cases from any bytes that are small enough to be tried thousands of times. */
#ifndef HAWSER_TESTS_FUZZ_SMALL_CASE_H
#define HAWSER_TESTS_FUZZ_SMALL_CASE_H

#include <stddef.h>
#include <stdint.h>

#include "hawser/hawser.h"

/* The case, or NULL: the bytes are none (with an error that must be good), or it is large. Free it. */
hawser_case *small_case_parse(const uint8_t *data, size_t size);

#endif
