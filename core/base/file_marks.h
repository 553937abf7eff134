/* Which files something was read from, by what they are: nothing may be written over them, whatever they are called. */
#ifndef HAWSER_CORE_BASE_FILE_MARKS_H
#define HAWSER_CORE_BASE_FILE_MARKS_H

#include <sys/types.h>

#include "hawser/hawser.h"

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
