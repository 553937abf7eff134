#include "fmi/unit/unit.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* What stands behind "file:" and an empty host or the own one; the whole if there is no scheme; NULL: anything else. */
static const char *path_of(const char *address)
{
    if (strncmp(address, "file:", 5) != 0) return strstr(address, "://") ? NULL : address;
    const char *path = address + 5;
    if (strncmp(path, "//", 2) == 0) path += 2;
    if (strncmp(path, "localhost/", 10) == 0) path += 9;
    return *path == '/' ? path : NULL;
}

/* "%20" -> ' ' in place. Returns 0 where a '%' is not followed by two hexadecimal digits, or stands for a NUL. */
static int escapes_take(char *path)
{
    char *to = path;
    for (const char *from = path; *from; ++from, ++to) {
        *to = *from;
        if (*from != '%') continue;
        if (!isxdigit((unsigned char)from[1]) || !isxdigit((unsigned char)from[2])) return 0;
        const char code[] = {from[1], from[2], 0};
        *to = (char)strtol(code, NULL, 16);
        if (!*to) return 0;
        from += 2;
    }
    *to = 0;
    return 1;
}

char *address_folder(const char *address)
{
    const char *const path = address ? path_of(address) : NULL;
    char *folder = path && *path ? strdup(path) : NULL;
    if (folder && path != address && !escapes_take(folder)) {
        free(folder);
        return NULL;
    }
    for (size_t n = folder ? strlen(folder) : 0; n > 1 && folder[n - 1] == '/'; --n) folder[n - 1] = 0;
    return folder;
}
