/* Files read and written to the end: an interruption is no end, and what the system does not give is none either. Who
 * takes such an error for an end reads less than there is, and says that a file is empty, cut off or another's. stdio
 * and jansson do so; what they have read is asked for its error afterwards (survey/input.h), or read here first.
 */
#ifndef HAWSER_CORE_BASE_FILE_H
#define HAWSER_CORE_BASE_FILE_H

#include <stddef.h>
#include <sys/types.h>

#include "hawser/hawser.h"

/* ---- By name. */

/* All of a regular file with a NUL behind it, malloc'ed: *bytes [size + 1]. One that is not there is NULL with
 * HAWSER_OK; one of more than `most` bytes is refused. A FIFO or a device holds nobody up. Errors: INPUT, MEMORY. */
hawser_status file_whole(const char *path, size_t most, char **bytes, size_t *size, hawser_error *err);
/* The same of a name within an open folder. */
hawser_status file_whole_at(int at, const char *path, size_t most, char **bytes, size_t *size, hawser_error *err);
/* "cannot read 'path': why", INPUT. */
hawser_status file_unread(const char *path, const char *why, hawser_error *err);

/* ---- Of an open file. */

/* Reads so many bytes of an open file, from where it is or, whole_pread, from the byte `at`. Returns how many there
 * were, fewer only at the file's end; < 0 with errno. */
ssize_t whole_read(int fd, void *to, size_t size);
ssize_t whole_pread(int fd, void *to, size_t size, off_t at);

/* Writes so many bytes, whole_pwrite from the byte `at` on: all of them, however many the system takes at once; or
 * returns 0 with errno (0: it took none, and said no reason). */
int whole_write(int fd, const void *from, size_t size);
int whole_pwrite(int fd, const void *from, size_t size, off_t at);

#endif
