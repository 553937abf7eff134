/* Text files of a results folder: every write is checked, and numbers are written with a decimal point
 * whatever the locale of the calling program. */
#ifndef HAWSER_IO_RESULTS_RESULTS_FILE_H
#define HAWSER_IO_RESULTS_RESULTS_FILE_H

#include "hawser/hawser.h"

#include <locale.h>
#include <stdio.h>

enum { OUT_PATH_MAX = 4096 };

/* A text file open for writing; zeroed: closed. */
typedef struct OutFile {
    FILE *f;
    locale_t c; /* the "C" locale */
    char path[OUT_PATH_MAX];
} OutFile;

/* Makes a directory and those above it that are missing; one that is there is fine. Errors: OUTPUT, with the
 * path and what the system says. */
hawser_status out_make_dir(const char *dir, hawser_error *err);
/* dir/name into path[OUT_PATH_MAX]. Errors: OUTPUT if that is too long. */
hawser_status out_join(char *path, const char *dir, const char *name, hawser_error *err);
/* Writes "cannot write 'path': reason" and returns OUTPUT; `number` is errno's value (0: no reason known). */
hawser_status out_error(const char *path, int number, hawser_error *err);

/* Creates dir/name or empties it. Errors: OUTPUT, MEMORY; the file is then closed. */
hawser_status out_open(OutFile *out, const char *dir, const char *name, hawser_error *err);
/* Appends text; errors that the system only finds later come from out_flush or out_close. */
hawser_status out_print(OutFile *out, hawser_error *err, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Hands everything to the system. Errors: OUTPUT. */
hawser_status out_flush(OutFile *out, hawser_error *err);
/* Flushes and closes; a closed file is left alone. Errors: OUTPUT (the file is closed all the same). */
hawser_status out_close(OutFile *out, hawser_error *err);

#endif
