/* The text of a case, wherever it comes from: whatever a path leads to, this ends soon and within bounds. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "io/yaml/yaml_tree.h"

/* Bytes; ms that a pipe may keep silent. */
enum { FILE_MAX = 32 << 20, SILENCE_MAX = 5000 };

/* Opened so that a FIFO nobody writes into does not hold us up. A file, or a pipe as in a shell's <(...); a device has
 * no end. Returns 0, or what is wrong with it. */
static const char *text_open(const char *path, int *fd)
{
    struct stat state;
    *fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (*fd < 0 || fstat(*fd, &state)) return strerror(errno);
    if (S_ISDIR(state.st_mode)) return strerror(EISDIR);
    if (!S_ISREG(state.st_mode) && !S_ISFIFO(state.st_mode)) return "not a file";
    return S_ISREG(state.st_mode) && state.st_size > FILE_MAX ? strerror(EFBIG) : NULL;
}

/* As read(2), but waits for a pipe's writer; a writer that keeps silent is ETIMEDOUT. */
static ssize_t text_read(int fd, char *to, size_t room)
{
    struct pollfd ready = {.fd = fd, .events = POLLIN};
    for (;;) {
        const int n = poll(&ready, 1, SILENCE_MAX);
        if (n == 0) errno = ETIMEDOUT;
        const ssize_t got = n > 0 ? read(fd, to, room) : -1;
        if (got >= 0 || (errno != EINTR && errno != EAGAIN)) return got;
    }
}

/* All that is to be read, malloc'ed, with a NUL behind it; NULL with errno, EFBIG if it is larger than a case can be.
 */
static char *text_take(int fd, size_t *size)
{
    size_t room = 1 << 16;
    char *text = malloc(room + 1);
    *size = 0;
    while (text) {
        const ssize_t n = text_read(fd, text + *size, room - *size);
        if (n < 0) break;
        if (n == 0) {
            text[*size] = 0;
            return text;
        }
        *size += (size_t)n;
        if (*size < room) continue;
        room *= 2;
        errno = EFBIG;
        char *const more = room <= FILE_MAX ? realloc(text, room + 1) : NULL;
        if (!more) break;
        text = more;
    }
    const int reason = text ? errno : ENOMEM;
    free(text);
    errno = reason;
    return NULL;
}

hawser_status case_file_read(const char *path, char **text, size_t *size, hawser_error *err)
{
    int fd;
    const char *const wrong = text_open(path, &fd);
    *text = NULL;
    if (wrong) {
        if (fd >= 0) close(fd);
        error_set(err, HAWSER_ERR_INPUT, "%s: cannot be %s: %s", path, fd < 0 ? "opened" : "read", wrong);
        error_place(err, path, 0);
        return HAWSER_ERR_INPUT;
    }
    *text = text_take(fd, size);
    const int reason = errno;
    close(fd);
    if (*text) return HAWSER_OK;
    if (reason == ENOMEM) return error_memory(err);
    return error_set(err, HAWSER_ERR_INPUT, "%s: cannot be read: %s", path,
                     reason == ETIMEDOUT ? "nobody has written into it for 5 s" : strerror(reason));
}
