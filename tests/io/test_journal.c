/* The journal of results.h5: what it says is done again, and where that cannot be it stays for the next time. */
#include <errno.h>

#include "tests/support/lack.h"

#include <fcntl.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/checkpoint.h"
#include "io/results/results_h5.h"
#include "tests/support/check.h"
#include "tests/support/scratch.h"

enum { PAGE = 4096, SIZE = 2 * PAGE };

/* As io/results/hdf5.c writes it: a head, then numbers of pages and their bytes. */
typedef struct Journal {
    uint64_t pages, size, hash, number;
    char bytes[PAGE];
} Journal;

static int unreadable;

ssize_t read(int fd, void *to, size_t size)
{
    if (!unreadable) return syscall(SYS_read, fd, to, size);
    errno = EIO;
    return -1;
}

static void bytes_write(const char *name, const void *bytes, size_t size)
{
    FILE *const f = fopen(scratch_path(name), "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

/* A file of two pages, and a journal that has another second one. */
static void files_write(void)
{
    char file[SIZE];
    Journal j = {.pages = 1, .size = SIZE, .number = 1};
    memset(file, 'a', sizeof file);
    memset(j.bytes, 'b', sizeof j.bytes);
    j.hash = checkpoint_hash(&j.number, sizeof j.number + sizeof j.bytes);
    bytes_write("results.h5", file, sizeof file);
    bytes_write("results.h5.journal", &j, sizeof j);
}

/* As disk_recover of the folder's file. */
static hawser_status recover(hawser_error *err)
{
    OutDir dir;
    assert_int_equal(out_enter(&dir, scratch_folder(), NULL), HAWSER_OK);
    const int fd = file_open_in(dir.at, "results.h5", O_RDWR);
    assert_true(fd >= 0);
    const hawser_status status = disk_recover(&(DiskPlace){fd, dir.at}, err);
    close(fd);
    out_leave(&dir);
    return status;
}

static int journal_is_there(void) { return access(scratch_path("results.h5.journal"), F_OK) == 0; }

/* What the second page begins with. */
static int second_page(void)
{
    FILE *const f = fopen(scratch_path("results.h5"), "rb");
    assert_non_null(f);
    assert_int_equal(fseek(f, PAGE, SEEK_SET), 0);
    const int c = fgetc(f);
    fclose(f);
    return c;
}

TEST(test_followed)
{
    hawser_error err = {0};
    files_write();
    assert_int_equal(recover(&err), HAWSER_OK);
    assert_int_equal(second_page(), 'b');
    assert_false(journal_is_there());
    assert_int_equal(recover(&err), HAWSER_OK); /* there is none */
}

TEST(test_cut_off)
{
    hawser_error err = {0};
    files_write();
    assert_int_equal(truncate(scratch_path("results.h5.journal"), PAGE), 0);
    assert_int_equal(recover(&err), HAWSER_OK);
    assert_int_equal(second_page(), 'a');
    assert_false(journal_is_there());
}

TEST(test_unreadable)
{
    hawser_error err = {0};
    files_write();
    unreadable = 1;
    const hawser_status status = recover(&err);
    unreadable = 0;
    assert_int_equal(status, HAWSER_ERR_OUTPUT);
    assert_int_equal(err.status, HAWSER_ERR_OUTPUT);
    check_has(err.message, strerror(EIO));
    assert_true(journal_is_there());
}

/* Through a link the file of somebody else was changed, whatever the journal said. */
TEST(test_link)
{
    files_write();
    assert_int_equal(rename(scratch_path("results.h5"), scratch_path("victim")), 0);
    assert_int_equal(symlink("victim", scratch_path("results.h5")), 0);
    OutDir dir;
    assert_int_equal(out_enter(&dir, scratch_folder(), NULL), HAWSER_OK);
    assert_int_equal(file_open_in(dir.at, "results.h5", O_RDWR), -1);
    assert_int_equal(errno, ELOOP);
    out_leave(&dir);
    assert_int_equal(unlink(scratch_path("results.h5")), 0);
}

TEST(test_no_memory)
{
    hawser_error err = {0};
    if (!lack_works()) skip();
    files_write();
    lack_after(0);
    const hawser_status status = recover(&err);
    assert_true(lack_end());
    assert_int_equal(status, HAWSER_ERR_MEMORY);
    assert_true(journal_is_there());
}

TEST_GROUP(scratch_make, scratch_remove)
