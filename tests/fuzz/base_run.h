/* Results of a small run in a folder of the fuzzer's own, which goes when it ends, and files of it. */
#ifndef HAWSER_TESTS_FUZZ_BASE_RUN_H
#define HAWSER_TESTS_FUZZ_BASE_RUN_H

#include <stddef.h>

enum { BASE_PATH = 256 };

/* Makes a new folder below TMPDIR, once a program, and has it deleted at the end; its path has at most 230 characters.
 */
void base_make(char base[BASE_PATH]);
/* Writes the results of a case into a folder. */
void base_run(const char *text, const char *dir);
/* All bytes of a file and a NUL behind them, malloc'ed. */
unsigned char *base_read(const char *folder, const char *name, size_t *size);
void base_write(const char *folder, const char *name, const void *bytes, size_t size);
/* Deletes what is in a folder, and with `itself` the folder; no link is followed. */
void base_empty(const char *path, int itself);

#endif
