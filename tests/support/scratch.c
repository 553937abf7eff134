#define _GNU_SOURCE /* nftw */
#include "tests/support/scratch.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tests/support/check.h"

static char folder[64];

int scratch_make(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/hawser-test-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

int scratch_remove(void **state)
{
    (void)state;
    return folder_remove(folder);
}

const char *scratch_folder(void) { return folder; }

const char *scratch_path(const char *name) { return scratch_path_in(name, NULL); }

const char *scratch_path_in(const char *in, const char *name)
{
    static char path[4][256];
    static int turn;
    char *const to = path[turn++ % 4];
    snprintf(to, sizeof path[0], "%s/%s%s%s", folder, in, name ? "/" : "", name ? name : "");
    return to;
}

static int entry_remove(const char *path, const struct stat *info, int kind, struct FTW *at)
{
    (void)info, (void)kind, (void)at;
    return remove(path);
}

int folder_remove(const char *dir) { return nftw(dir, entry_remove, 16, FTW_DEPTH | FTW_PHYS); }

char *file_text(const char *path)
{
    FILE *const f = fopen(path, "rb");
    if (!f) fail_msg("no file %s", path);
    fseek(f, 0, SEEK_END);
    const long size = ftell(f);
    rewind(f);
    char *const text = calloc((size_t)size + 1, 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)size, f), size);
    fclose(f);
    return text;
}

void file_write(const char *path, const char *text)
{
    FILE *const f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, strlen(text), f), strlen(text));
    assert_int_equal(fclose(f), 0);
}

void check_reference(const char *name, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", HAWSER_SOURCE_DIR, name);
    if (getenv("HAWSER_WRITE")) file_write(path, text);
    char *const there = file_text(path);
    const int same = !strcmp(there, text);
    free(there);
    if (!same) fail_msg("%s is not current: run this test with HAWSER_WRITE=1 in the environment", name);
}

const char *scratch_write(const char *name, const char *text)
{
    const char *const path = scratch_path(name);
    file_write(path, text);
    return path;
}
