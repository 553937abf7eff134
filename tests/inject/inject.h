/* Preloaded into the program under test: the k-th call of a kind fails. Calls are counted from 1 over all threads. What
 * fails, and when, comes through the environment:
 *
 *   INJECT_KIND   memory: malloc, calloc, realloc, strdup and their like return NULL; not those of HDF5 and libzip, nor
 * those within SUNContext_Create, dlopen and json_load: docs/reliability.md says why heap: the same where more than
 * INJECT_AT KiB would be in use; counted is the most KiB in use disk: opening for writing, write, pwrite, ftruncate,
 * fsync, rename, mkdir, unlink and what writes into a stream of stdio: EIO or ENOSPC full: the same where more than
 * INJECT_AT bytes would have been written; counted are the bytes read: opening for reading, read, pread, and what reads
 * from a stream of stdio: EIO eintr: read, write, pread, pwrite fail with EINTR once short: read, write, pread, pwrite
 * do the half of what was asked hdf5: a function of HDF5 that the program calls resident: nothing; counted is the most
 * KiB of memory that the program has had INJECT_AT     k; 0: nothing fails INJECT_ALL set: and all after it INJECT_KILL
 * set: the program is killed instead, before the call INJECT_STOP   set: a debugger stops at the call that fails
 * INJECT_COUNT  path of a file into which the number of calls is written at the end INJECT_SITES  path of a file that
 * gets where each call came from: a sum of 8 bytes of its call stack INJECT_LEFT   path of a file that gets the
 * callers, within the program, of the blocks that were not given back INJECT_LOG    path of a file that gets what is
 * done to files, a line each
 */
#ifndef HAWSER_TESTS_INJECT_H
#define HAWSER_TESTS_INJECT_H

#include <dlfcn.h>
#include <stdint.h>
#include <sys/types.h>
#include <unistd.h>

typedef enum Kind { NOTHING, MEMORY, HEAP, DISK, FULL, READ, EINTR_ONCE, SHORT, HDF5, RESIDENT } Kind;
extern Kind inject_kind;
extern long inject_at;

/* The library's own function behind ours. */
#define REAL(name, type) ((type)inject_real(#name))
void *inject_real(const char *name);

/* Whether this call of a kind is the one. */
int inject_fails(Kind k);

/* sites.c: where a call comes from. Modules are looked up first, and again when an address is in none of them. */
void sites_begin(const char *path);
void site_note(long call);
void sites_end(void);
/* Whether an address is the program's own, HDF5's, or that of a library whose allocations do not fail. */
int site_is_program(const void *address);
int site_is_spared(const void *address);
int site_is_hdf5(const void *address);
uintptr_t site_in_program(const void *address);

/* left.c: blocks of the program that have not been given back. */
void left_begin(const char *path);
void left_add(const void *block, const void *caller);
void left_remove(const void *block);
void left_end(void);

/* memory.c */
long memory_most(void);

/* files.c */
void files_begin(const char *log);
long files_written(void);

#endif
