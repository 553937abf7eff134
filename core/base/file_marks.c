#include "core/base/file_marks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/base/error.h"

/* The one that a path leads to; NULL: none of them. */
static const FileMark *mark_find(const FileMarks *files, const struct stat *is)
{
    for (int k = 0; k < files->n; k++)
        if (files->mark[k].inode == is->st_ino && files->mark[k].device == is->st_dev) return &files->mark[k];
    return NULL;
}

static hawser_status mark_add(FileMarks *files, const FileMark *mark, hawser_error *err)
{
    FileMark *const more = realloc(files->mark, ((size_t)files->n + 1) * sizeof *more);
    if (!more) return error_memory(err);
    files->mark = more;
    more[files->n++] = *mark;
    return HAWSER_OK;
}

hawser_status file_marks_add(FileMarks *files, const char *path, hawser_error *err)
{
    struct stat is;
    if (stat(path, &is) || !S_ISREG(is.st_mode) || mark_find(files, &is)) return HAWSER_OK;
    FileMark mark = {.device = is.st_dev, .inode = is.st_ino};
    const size_t n = strlen(path);
    snprintf(mark.name, sizeof mark.name, "%s", n < sizeof mark.name ? path : path + n + 1 - sizeof mark.name);
    return mark_add(files, &mark, err);
}

hawser_status file_marks_join(FileMarks *files, const FileMarks *more, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < more->n && !status; k++) status = mark_add(files, &more->mark[k], err);
    return status;
}

void file_marks_free(FileMarks *files)
{
    free(files->mark);
    *files = (FileMarks){.n = 0};
}

hawser_status file_marks_spare(const FileMarks *files, const char *path, hawser_error *err)
{
    struct stat is;
    const FileMark *const mark = files->n > 0 && !stat(path, &is) ? mark_find(files, &is) : NULL;
    if (mark)
        return error_set(err, HAWSER_ERR_INPUT, "cannot write '%.400s': that is the file '%s', which is read", path,
                         mark->name);
    return HAWSER_OK;
}
