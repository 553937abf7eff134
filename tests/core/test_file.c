/* A file at once: what is there, and what the system does not give, which is never the file's end. */
#include "core/base/file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
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

static hawser_status taken(const char *path, int which, int why, char **bytes, hawser_error *err)
{
    size_t size = 0;
    failing = which;
    number = why;
    calls = 0;
    *err = (hawser_error){0};
    const hawser_status status = file_whole(path, MOST, bytes, &size, err);
    failing = NONE;
    if (*bytes) assert_int_equal(strlen(*bytes), size);
    return status;
}

static void test_there(void **state)
{
    hawser_error err;
    char *bytes;
    (void)state;
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

static void test_not_there(void **state)
{
    hawser_error err;
    char *bytes;
    size_t size;
    (void)state;
    assert_int_equal(taken(scratch_path("no such file"), NONE, 0, &bytes, &err), HAWSER_OK);
    assert_null(bytes);
    assert_int_equal(taken(scratch_folder(), NONE, 0, &bytes, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "not a file");
    assert_int_equal(file_whole(scratch_write("text", "too much"), 7, &bytes, &size, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "too large");
    assert_null(bytes);
}

static void test_not_given(void **state)
{
    hawser_error err;
    char *bytes;
    (void)state;
    const char *const path = scratch_write("text", "eight or more");
    for (int which = 0; which < 5; which++) {
        assert_int_equal(taken(path, which, EIO, &bytes, &err), HAWSER_ERR_INPUT);
        assert_null(bytes);
        check_has(err.message, strerror(EIO));
    }
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

TEST_FILE_IN(test_file, begin, end, cmocka_unit_test(test_there), cmocka_unit_test(test_not_there),
             cmocka_unit_test(test_not_given))
