/* Files read and written completely: an interruption does not end the operation, and an error is not taken for the end
 * of the file. Otherwise a reader would get less than there is, and report a file as empty, truncated or foreign. stdio
 * and jansson have this fault; after they have read, the stream's error is checked (survey/input.h), or the file is
 * read here first. */
#ifndef HAWSER_CORE_FILE_H
#define HAWSER_CORE_FILE_H

#include <stddef.h>
#include <sys/types.h>

#include "hawser/hawser.h"

/* ---- Within a folder that is open as `at`. The folder's creator may have put anything into it, so these are the only
 * calls by which files of results are opened, renamed and deleted (tests/house/check_doors.py). `name` is one level. No
 * symbolic link is followed; only regular files are opened, and a FIFO or a device does not block; a file with a second
 * name (a hard link) is not opened for writing, which would change the other one, too. */

enum { FILE_PART_MAX = 320 };

/* Opens a file; flags: O_RDONLY, O_WRONLY, O_RDWR, with O_APPEND. -1 with errno: ELOOP (a link), ENOTBLK (not a regular
 * file), EMLINK (a second name) and the system's. */
int file_open_in(int at, const char *name, int flags);
/* Creates an empty file under an unpredictable name, "NAME.xxxxxxxxxxxxxxxx.part"; open for reading and writing.
 * file_name_in gives it its final name. -1 with errno. */
int file_new_in(int at, const char *name, char part[FILE_PART_MAX]);
/* Replaces the entry `name`, a link itself and not its target; a device, a FIFO or a folder stays. 0 with errno. */
int file_name_in(int at, const char *part, int to, const char *name);
/* Checks whether `entry` is a name that file_new_in has made for `name`. */
int file_is_part(const char *entry, const char *name);
/* Deletes a name; a missing one is no error. 0 with errno. */
int file_remove_in(int at, const char *name);
/* Opens a folder within the folder, not through a link; -1 with errno. */
int folder_open_in(int at, const char *name);
/* Makes one if it does not exist; 0 with errno. The second deletes an empty one. */
int folder_make_in(int at, const char *name);
void folder_remove_in(int at, const char *name);
/* All of a file with a NUL behind it, malloc'ed: *bytes [size + 1]. A missing file gives NULL with HAWSER_OK; one of
 * more than `most` bytes is refused. path: for messages. Errors: INPUT, MEMORY. */
hawser_status file_whole_in(int at, const char *name, const char *path, size_t most, char **bytes, size_t *size,
                            hawser_error *err);
/* ---- By a path given by the user, which may be a link. */

/* Opens a regular file for reading; -1 with errno (ENOTBLK: not a regular file). */
int file_open_named(const char *path);
/* Text for an errno of these functions. */
const char *file_reason(int number);
/* "cannot read 'path': why", INPUT. */
hawser_status file_unread(const char *path, const char *why, hawser_error *err);
/* ---- On an open file. */

/* Reads so many bytes of an open file, from its position or, whole_pread, from the byte `at`. Returns the number read,
 * fewer only at the file's end; < 0 with errno. */
ssize_t whole_read(int fd, void *to, size_t size);
ssize_t whole_pread(int fd, void *to, size_t size, off_t at);
/* Writes so many bytes, whole_pwrite from the byte `at` on, in as many calls as it takes; returns 0 with errno on
 * failure (0: the system gave no reason). */
int whole_write(int fd, const void *from, size_t size);
int whole_pwrite(int fd, const void *from, size_t size, off_t at);
/* The files from which something was read, by identity: nothing may be written over them, under any name. */

enum { FILE_MARK_NAME = 256 };

typedef struct FileMark {
    dev_t device;
    ino_t inode;
    char name[FILE_MARK_NAME]; /* for messages: the path by which it was read, or its last part */
} FileMark;

/* Zeroed: none. */
typedef struct FileMarks {
    int n;
    FileMark *mark; /* [n], owned */
} FileMarks;

/* Adds a file; one that is not regular, does not exist, or is there already is skipped. Errors: MEMORY. */
hawser_status file_marks_add(FileMarks *files, const char *path, hawser_error *err);
/* Adds all of another list. Errors: MEMORY. */
hawser_status file_marks_join(FileMarks *files, const FileMarks *more, hawser_error *err);
void file_marks_free(FileMarks *files);
/* Checks whether a file may be written: `path` leads to none of them. Errors: INPUT that names both. */
hawser_status file_marks_spare(const FileMarks *files, const char *path, hawser_error *err);

#endif
