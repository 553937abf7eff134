/* Gives a target the files that are named, and all files of the folders that are: what once was trouble stays tried, in
 * every build and with every compiler. Usage: replay_TARGET PATH... */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "tests/fuzz/fuzz.h"

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
    (void)LLVMFuzzerTestOneInput(data, (size_t)size);
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

int main(int argc, char **argv)
{
    int n = 0;
    for (int k = 1; k < argc; ++k) {
        struct stat about;
        if (stat(argv[k], &about)) {
            fprintf(stderr, "%s: not there\n", argv[k]);
            return 2;
        }
        n += S_ISDIR(about.st_mode) ? replay_folder(argv[k]) : replay_file(argv[k]);
    }
    printf("%d inputs\n", n);
    return n > 0 ? 0 : 1;
}
