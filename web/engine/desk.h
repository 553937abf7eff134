/* What the files of the desk's engine share. */
#ifndef HAWSER_WEB_ENGINE_DESK_H
#define HAWSER_WEB_ENGINE_DESK_H

#include <stddef.h>

#include "hawser/hawser.h"

/* A case of a text, whose files are in /case. */
hawser_status desk_case(const char *text, hawser_case **c, hawser_error *err);
/* What a call returns: '=' and `text`, which may be NULL and is taken, or '!' and the error. */
char *desk_answered(hawser_status status, char *text, const hawser_error *err);
/* All of a file, with a NUL behind it, malloc'ed; NULL: it cannot be read. */
char *file_text(const char *path, size_t *size);

#endif
