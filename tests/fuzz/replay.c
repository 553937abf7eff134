/* All fuzz targets without a fuzzer, for every build and compiler.
 * Usage: replay TARGET PATH...              tries the named files and all files of the named folders: old findings stay
 * tried replay TARGET --random N [SEED]    tries N random inputs; the one that ends the program is left in
 * broken-TARGET-SEED */
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/fuzz/fuzz.h"

typedef int Try(const uint8_t *data, size_t size);

/* The build lists the targets as TARGET(name) (CMakeLists.txt). */
#define TARGET(name) Try fuzz_##name;
#include HAWSER_FUZZ_TARGETS
#undef TARGET
#define TARGET(name) {#name, fuzz_##name},
static const struct {
    const char *name;
    Try *try_input;
} targets[] = {
#include HAWSER_FUZZ_TARGETS
};

static Try *try_input;

static int replay_file(const char *path)
{
    FILE *const file = fopen(path, "rb");
    if (!file) return 0;
    fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    rewind(file);
    uint8_t *const data = malloc(size > 0 ? (size_t)size : 1);
    FUZZ_MUST(data && fread(data, 1, (size_t)size, file) == (size_t)size);
    fclose(file);
    (void)try_input(data, (size_t)size);
    free(data);
    return 1;
}

static int replay_folder(const char *path)
{
    DIR *const folder = opendir(path);
    int n = 0;
    if (!folder) return 0;
    for (const struct dirent *entry = readdir(folder); entry; entry = readdir(folder)) {
        char name[4096];
        struct stat about;
        if (*entry->d_name == '.') continue;
        snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
        if (!stat(name, &about) && S_ISREG(about.st_mode)) n += replay_file(name);
    }
    closedir(folder);
    return n;
}

static int replay_paths(char **paths)
{
    int n = 0;
    for (; *paths; ++paths) {
        struct stat about;
        if (stat(*paths, &about)) {
            fprintf(stderr, "%s: not there\n", *paths);
            return 2;
        }
        n += S_ISDIR(about.st_mode) ? replay_folder(*paths) : replay_file(*paths);
    }
    printf("%d inputs\n", n);
    return n > 0 ? 0 : 1;
}

static uint8_t bytes[120];
static size_t size;
static char broken[80];

static void leave_input(int number)
{
    FILE *const file = fopen(broken, "wb");
    if (file) fwrite(bytes, 1, size, file), fclose(file);
    signal(number, SIG_DFL);
    raise(number);
}

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

/* Two bytes of `api` are a call: its inputs are long and begin with a case and a simulation, since little can be done
 * without. Other targets' inputs are short, so that much of each is right. */
static int try_random(const char *target, long inputs, const char *seed)
{
    static const int ends[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGALRM};
    const int calls = !strcmp(target, "api");
    const size_t most = calls ? sizeof bytes : 24;
    uint64_t state = strtoull(seed, NULL, 10);
    snprintf(broken, sizeof broken, "broken-%.30s-%.30s", target, seed);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; ++k) signal(ends[k], leave_input);
    for (long k = 0; k < inputs; ++k) {
        size = 2 + (size_t)(draw(&state) % (most - 2));
        for (size_t i = 0; i < size; ++i) bytes[i] = (uint8_t)(draw(&state) >> 24);
        if (calls) bytes[0] = 0;
        if (calls && size > 4) bytes[2] = 10;
        alarm(1800); /* what hangs */
        (void)try_input(bytes, size);
    }
    printf("%ld inputs\n", inputs);
    return inputs > 0 ? 0 : 2;
}

int main(int argc, char **argv)
{
    for (size_t k = 0; argc > 2 && k < sizeof targets / sizeof *targets; ++k) {
        if (!strcmp(argv[1], targets[k].name)) try_input = targets[k].try_input;
    }
    if (!try_input) {
        fprintf(
            stderr,
            "usage: replay TARGET PATH... | replay TARGET --random N [SEED]; targets are tests/fuzz/fuzz_TARGET.c\n");
        return 2;
    }
    if (strcmp(argv[2], "--random") != 0) return replay_paths(argv + 2);
    return try_random(argv[1], argc > 3 ? strtol(argv[3], NULL, 10) : 0, argc > 4 ? argv[4] : "1");
}
