#include "tests/fuzz/base_run.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/fuzz/fuzz.h"

enum { BASES = 4 };
static char made[BASES][BASE_PATH];
static int n_made;

void base_write(const char *folder, const char *name, const void *bytes, size_t size)
{
    char path[2 * BASE_PATH];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const f = fopen(path, "wb");
    FUZZ_MUST(f && fwrite(bytes, 1, size, f) == size);
    FUZZ_MUST(!fclose(f));
}

unsigned char *base_read(const char *folder, const char *name, size_t *size)
{
    char path[2 * BASE_PATH];
    struct stat info;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const f = fopen(path, "rb");
    FUZZ_MUST(f && !stat(path, &info));
    *size = (size_t)info.st_size;
    unsigned char *const bytes = malloc(*size + 1);
    FUZZ_MUST(bytes && fread(bytes, 1, *size, f) == *size);
    bytes[*size] = 0;
    fclose(f);
    return bytes;
}

void base_empty(const char *path, int itself)
{
    DIR *const folder = opendir(path);
    for (const struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        char name[2 * BASE_PATH];
        if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, "..") ||
            snprintf(name, sizeof name, "%s/%s", path, e->d_name) >= (int)sizeof name)
            continue;
        if (unlink(name)) base_empty(name, 1);
    }
    if (folder) closedir(folder);
    if (itself) rmdir(path);
}

static void bases_remove(void)
{
    for (int k = 0; k < n_made; ++k) base_empty(made[k], 1);
}

void base_make(char base[BASE_PATH])
{
    const char *const tmp = getenv("TMPDIR");
    snprintf(base, BASE_PATH, "%.200s/hawser-fuzz-XXXXXX", tmp && *tmp ? tmp : "/tmp");
    FUZZ_MUST(n_made < BASES && mkdtemp(base));
    if (!n_made) atexit(bases_remove);
    memcpy(made[n_made++], base, BASE_PATH);
}

void base_run(const char *text, const char *dir)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    if (hawser_case_parse(text, "base.yaml", &c, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    if (hawser_sim_new(c, &(hawser_options){.threads = 1}, &s, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    if (hawser_sim_run(s, dir, NULL, NULL, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    hawser_sim_free(s);
    hawser_case_free(c);
}
