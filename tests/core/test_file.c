/* A file at once: what is there, and what the system does not give, which is never the file's end. */
#include "core/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/support/check.h"
#include "tests/support/scratch.h"

enum { MOST = 1 << 16, NONE = -1 };

/* The call of read that fails, from 0, and with what; each gives three bytes at most. */
static int failing = NONE, number, calls;
static int replaced; /* during the tests of this file */

ssize_t read(int fd, void *to, size_t size)
{
    if (!replaced) return syscall(SYS_read, fd, to, size);
    if (calls++ == failing) {
        errno = number;
        return -1;
    }
    return syscall(SYS_read, fd, to, size < 3 ? size : 3);
}

/* A file of the scratch folder, or the folder itself by its name in the one above. */
static hawser_status whole(const char *path, size_t most, char **bytes, size_t *size, hawser_error *err)
{
    char folder[4096];
    const char *const slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", (int)(slash - path), path);
    const int at = open(folder, O_RDONLY | O_DIRECTORY);
    assert_true(at >= 0);
    const hawser_status status = file_whole_in(at, slash + 1, path, most, bytes, size, err);
    close(at);
    return status;
}

static hawser_status taken(const char *path, int which, int why, char **bytes, hawser_error *err)
{
    size_t size = 0;
    failing = which;
    number = why;
    calls = 0;
    *err = (hawser_error){0};
    const hawser_status status = whole(path, MOST, bytes, &size, err);
    failing = NONE;
    if (*bytes) assert_int_equal(strlen(*bytes), size);
    return status;
}

TEST(test_there)
{
    hawser_error err;
    char *bytes;
    const char *const path = scratch_write("text", "eight or more");
    for (int interrupted = NONE; interrupted < 6; interrupted++) {
        assert_int_equal(taken(path, interrupted, EINTR, &bytes, &err), HAWSER_OK);
        assert_string_equal(bytes, "eight or more");
        free(bytes);
    }
    assert_int_equal(taken(scratch_write("empty", ""), NONE, 0, &bytes, &err), HAWSER_OK);
    assert_string_equal(bytes, "");
    free(bytes);
}

TEST(test_not_there)
{
    hawser_error err;
    char *bytes;
    size_t size;
    assert_int_equal(taken(scratch_path("no such file"), NONE, 0, &bytes, &err), HAWSER_OK);
    assert_null(bytes);
    assert_int_equal(taken(scratch_folder(), NONE, 0, &bytes, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "not a file");
    assert_int_equal(whole(scratch_write("text", "too much"), 7, &bytes, &size, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "too large");
    assert_null(bytes);
}

TEST(test_not_given)
{
    hawser_error err;
    char *bytes;
    const char *const path = scratch_write("text", "eight or more");
    for (int which = 0; which < 5; which++) {
        assert_int_equal(taken(path, which, EIO, &bytes, &err), HAWSER_ERR_INPUT);
        assert_null(bytes);
        check_has(err.message, strerror(EIO));
    }
}

/* What a folder from somebody else may have in place of a file: each was followed, or held the program up. */
TEST(test_strange)
{
    char part[FILE_PART_MAX], again[FILE_PART_MAX];
    hawser_error err;
    char *bytes;
    const int at = open(scratch_folder(), O_RDONLY | O_DIRECTORY);
    scratch_write("victim", "precious");
    assert_int_equal(symlink("victim", scratch_path("link")), 0);
    assert_int_equal(symlink(".", scratch_path("round")), 0);
    assert_int_equal(mkfifo(scratch_path("fifo"), 0666), 0);
    assert_int_equal(link(scratch_path("victim"), scratch_path("second")), 0);
    static const int modes[] = {O_RDONLY, O_WRONLY, O_RDWR | O_APPEND};
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(file_open_in(at, "link", modes[k]), -1);
        assert_int_equal(errno, ELOOP);
        assert_int_equal(file_open_in(at, "fifo", modes[k]), -1);
        assert_int_equal(errno, ENOTBLK);
    }
    assert_int_equal(file_open_in(at, "second", O_WRONLY), -1);
    assert_int_equal(errno, EMLINK);
    assert_int_equal(folder_open_in(at, "round"), -1);
    assert_int_equal(taken(scratch_path("link"), NONE, 0, &bytes, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "symbolic link");
    /* a new file takes a link's place, and not that of what it leads to */
    int fd = file_new_in(at, "link", part);
    assert_true(fd >= 0 && file_is_part(part, "link") && !file_is_part(part, "lin"));
    close(fd);
    fd = file_new_in(at, "link", again);
    assert_true(fd >= 0 && strcmp(part, again) != 0);
    close(fd);
    assert_true(file_name_in(at, part, at, "link") && file_remove_in(at, again) && file_remove_in(at, again));
    assert_int_equal(taken(scratch_path("link"), NONE, 0, &bytes, &err), HAWSER_OK);
    assert_string_equal(bytes, "");
    free(bytes);
    assert_int_equal(taken(scratch_path("victim"), NONE, 0, &bytes, &err), HAWSER_OK);
    assert_string_equal(bytes, "precious");
    free(bytes);
    close(at);
}

static int begin(void **state)
{
    replaced = 1;
    return scratch_make(state);
}

static int end(void **state)
{
    replaced = 0;
    return scratch_remove(state);
}

TEST_GROUP(begin, end)
