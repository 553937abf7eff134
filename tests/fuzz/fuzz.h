/* A part of the program behind one function that takes any bytes: for fuzzers (libFuzzer, AFL++), and for the replay
 * of inputs that once were trouble. docs/reliability.md. */
#ifndef HAWSER_TESTS_FUZZ_FUZZ_H
#define HAWSER_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

/* Heads the function of a target, tests/fuzz/fuzz_NAME.c: it tries one input and returns 0. What is wrong ends the
 * program: a sanitizer's finding, or FUZZ_MUST. A fuzzer links one target and calls it by the name that it knows; the
 * replay program links all of them (replay.c). */
#ifdef HAWSER_FUZZER
#define FUZZ_TARGET(name) int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
FUZZ_TARGET();
#else
#define FUZZ_TARGET(name)                                                                                              \
    int fuzz_##name(const uint8_t *data, size_t size);                                                                 \
    int fuzz_##name(const uint8_t *data, size_t size)
#endif

/* What must hold for any input, in every build. */
#define FUZZ_MUST(condition) ((condition) ? (void)0 : fuzz_failed(#condition, __FILE__, __LINE__))
_Noreturn void fuzz_failed(const char *condition, const char *file, int line);

/* The bytes as a text with a NUL behind them; free it. */
char *fuzz_text(const uint8_t *data, size_t size);

/* 1 if an error says what it should: a status, one line, no bytes that a terminal would obey. */
int fuzz_error_is_good(int status, const char *message);

#endif
