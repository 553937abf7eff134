/* Files read and written to the end: an interruption is no end, and what the system does not give is none either. Who
 * takes such an error for an end reads less than there is, and says that a file is empty, cut off or another's. stdio
 * and jansson do so; what they have read is asked for its error afterwards (survey/input.h), or read here first.
 */
#ifndef HAWSER_CORE_FILE_H
#define HAWSER_CORE_FILE_H

#include <stddef.h>
#include <sys/types.h>

#include "hawser/hawser.h"

/* ---- Within a folder that is open as `at`. Whoever made the folder may have put anything into it, so that these are
 * the only calls by which files of results are opened, renamed and deleted (tests/house/check_doors.py). `name` is one
 * level. No symbolic link is followed; what is no regular file is not opened, and a FIFO or a device holds nobody up;
 * a file with a second name (a hard link) is not opened for writing, which would change the other one, too. */

enum { FILE_PART_MAX = 320 };

/* A descriptor; flags: O_RDONLY, O_WRONLY, O_RDWR, with O_APPEND. -1 with errno: ELOOP (a link), ENOTBLK (no regular
 * file), EMLINK (a second name) and the system's. */
int file_open_in(int at, const char *name, int flags);
/* A new, empty file under a name that nobody can know before, "NAME.xxxxxxxxxxxxxxxx.part"; open for reading and
 * writing. It gets its name by file_name_in. -1 with errno. */
int file_new_in(int at, const char *name, char part[FILE_PART_MAX]);
/* Replaces what is called `name`, a link itself and not what it leads to; a device, a FIFO or a folder stays. 0 with
 * errno. */
int file_name_in(int at, const char *part, int to, const char *name);
/* Whether `entry` is a name that file_new_in has made for `name`. */
int file_is_part(const char *entry, const char *name);
/* Deletes a name; one that is not there is fine. 0 with errno. */
int file_remove_in(int at, const char *name);
/* A folder within the folder, which is no link; -1 with errno. */
int folder_open_in(int at, const char *name);
/* Makes one, if it is not there; 0 with errno. Deletes one that is empty. */
int folder_make_in(int at, const char *name);
void folder_remove_in(int at, const char *name);
/* All of a file with a NUL behind it, malloc'ed: *bytes [size + 1]. One that is not there is NULL with HAWSER_OK; one
 * of more than `most` bytes is refused. path: for messages. Errors: INPUT, MEMORY. */
hawser_status file_whole_in(int at, const char *name, const char *path, size_t most, char **bytes, size_t *size,
                            hawser_error *err);
/* ---- By a path that the user has named, which may be a link. */

/* A regular file to be read; -1 with errno (ENOTBLK: no regular file). */
int file_open_named(const char *path);
/* What an errno of these functions means. */
const char *file_reason(int number);
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
/* Which files something was read from, by what they are: nothing may be written over them, whatever they are called. */

enum { FILE_MARK_NAME = 256 };

typedef struct FileMark {
    dev_t device;
    ino_t inode;
    char name[FILE_MARK_NAME]; /* for messages: the path by which it was read, or its end */
} FileMark;

/* Zeroed: none. */
typedef struct FileMarks {
    int n;
    FileMark *mark; /* [n], owned */
} FileMarks;

/* Adds a file; what is none, or not there, or there already is passed over. Errors: MEMORY. */
hawser_status file_marks_add(FileMarks *files, const char *path, hawser_error *err);
/* Adds all of another list. Errors: MEMORY. */
hawser_status file_marks_join(FileMarks *files, const FileMarks *more, hawser_error *err);
void file_marks_free(FileMarks *files);
/* Whether a file may be written: `path` leads to none of them. Errors: INPUT that names both. */
hawser_status file_marks_spare(const FileMarks *files, const char *path, hawser_error *err);

#endif
