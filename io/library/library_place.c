/* Where the shipped files are: nothing of this is compiled in, so that a tree may be moved after it was installed. */
#define _GNU_SOURCE /* dladdr */
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "io/library/library.h"

static const char PLACE[] = "share/hawser/library";

/* 0: errno says why not. */
static int is_folder(const char *path)
{
    struct stat is;
    if (stat(path, &is)) return 0;
    errno = ENOTDIR;
    return S_ISDIR(is.st_mode);
}

/* A place beside the folder of a program or library, or up to two above it: bin, lib, lib/x86_64-linux-gnu; in a build
 * cli and tests/fuzz. Malloc'ed; NULL: not there. */
static char *beside(const char *module, const char *place)
{
    char path[2 * PATH_MAX], *real = realpath(module, NULL);
    char *slash = real ? strrchr(real, '/') : NULL, *found = NULL;
    for (int up = 0; up < 3 && slash && !found; up++) {
        *slash = 0;
        if (snprintf(path, sizeof path, "%s/%s", real, place) < (int)sizeof path) found = realpath(path, NULL);
        slash = strrchr(real, '/');
    }
    free(real);
    return found;
}

char *shipped_find(const char *place)
{
    Dl_info module = {0};
    char *const found =
        dladdr((const void *)library_kinds, &module) && module.dli_fname ? beside(module.dli_fname, place) : NULL;
    return found ? found : beside("/proc/self/exe", place);
}

char *library_folder(char *looked, size_t room)
{
    const char *const named = getenv("HAWSER_LIBRARY");
    if (named && *named) {
        snprintf(looked, room, "the environment's HAWSER_LIBRARY, '%.800s', is not a folder", named);
        return is_folder(named) ? strdup(named) : NULL;
    }
    char program[PATH_MAX] = "";
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    program[length > 0 ? length : 0] = 0;
    char *found = shipped_find(PLACE);
    if (found && !is_folder(found)) {
        snprintf(looked, room, "%.800s: %s", found, strerror(errno));
        free(found);
        return NULL;
    }
    snprintf(looked, room, "there is no %s beside %.700s: name its folder in the environment's HAWSER_LIBRARY", PLACE,
             *program ? program : "the program");
    return found;
}

static int is_yaml(const struct dirent *file)
{
    const size_t n = strlen(file->d_name);
    return n > 5 && strcmp(file->d_name + n - 5, ".yaml") == 0;
}

/* In the order of their names, so that a list of the catalogue is always the same. */
hawser_status library_ship(Library *library, hawser_error *err)
{
    char looked[1000], path[PATH_MAX + 300];
    char *const folder = library_folder(looked, sizeof looked);
    struct dirent **file = NULL;
    if (!folder) return error_set(err, HAWSER_ERR_INPUT, "the catalogue was not found: %s", looked);
    const int n = scandir(folder, &file, is_yaml, alphasort);
    hawser_status status = HAWSER_OK;
    if (n < 0 && errno == ENOMEM)
        status = error_memory(err);
    else if (n < 0)
        status = error_set(err, HAWSER_ERR_INPUT, "%s: cannot be read: %s", folder, strerror(errno));
    else if (n == 0)
        status = error_set(err, HAWSER_ERR_INPUT, "%s: no files of a catalogue (*.yaml)", folder);
    for (int i = 0; i < n; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, file[i]->d_name);
        if (!status) status = library_read(library, path, 1, NULL, err);
        free(file[i]);
    }
    free(file);
    free(folder);
    return status;
}
