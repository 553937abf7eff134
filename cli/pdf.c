/* Prints a page by an installed browser, so that nothing on the page is drawn a second time for paper. */
#define _GNU_SOURCE /* mkostemps */
#include "cli/commands.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Largest time for a page, s; the browser's virtual time in which its figures are drawn, ms. */
enum { PATIENCE = 120, DRAWING = 20000, OPTION_MAX = 8192 };

static hawser_status fail(hawser_error *err, const char *what, const char *detail)
{
    err->status = HAWSER_ERR_OUTPUT;
    snprintf(err->message, sizeof err->message, "%s%.900s", what, detail);
    return HAWSER_ERR_OUTPUT;
}

/* Returns a file as a URL, with every byte but the harmless ones as %XX; malloc'ed. NULL: it does not exist, or no
 * memory. */
static char *file_url(const char *path)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    char *const whole = realpath(path, NULL), *const url = whole ? malloc(3 * strlen(whole) + sizeof "file://") : NULL;
    char *to = url;
    if (url) to += sprintf(to, "file://");
    for (const char *c = whole; url && *c; c++) {
        if (strchr(plain, *c)) *to++ = *c;
        if (!strchr(plain, *c)) to += sprintf(to, "%%%02X", (unsigned)(unsigned char)*c);
    }
    if (url) *to = 0;
    free(whole);
    return url;
}

/* Runs the browser in the child process, silent, in a process group of its own. Tries its names one by one. */
static void browser_become(const char *url, const char *pdf, const char *profile)
{
    static const char *const names[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};
    static char print[OPTION_MAX], home[OPTION_MAX], budget[64];
    snprintf(print, sizeof print, "--print-to-pdf=%s", pdf);
    snprintf(home, sizeof home, "--user-data-dir=%s", profile);
    snprintf(budget, sizeof budget, "--virtual-time-budget=%d", DRAWING);
    char *const args[] = {"browser",
                          "--headless",
                          "--disable-gpu",
                          "--no-first-run",
                          "--disable-extensions",
                          "--enable-unsafe-swiftshader",
                          "--no-pdf-header-footer",
                          budget,
                          home,
                          print,
                          geteuid() == 0 ? "--no-sandbox" : "--disable-sync", /* the sandbox does not work for root */
                          (char *)(size_t)url,
                          NULL};
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDWR);
    for (int fd = 0; fd <= 2 && nothing >= 0; fd++) dup2(nothing, fd);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) execvp(names[k], args);
    _exit(127);
}

/* Waits for the browser; one that takes too long, or is interrupted by the user, is ended with all its helpers. Returns
 * its status, -1 if it was ended. */
static int browser_wait(pid_t child)
{
    const struct timespec nap = {0, 50 * 1000 * 1000};
    for (int k = 0; k < 20 * PATIENCE && !interrupt_wanted(); k++) {
        int status;
        const pid_t done = waitpid(child, &status, WNOHANG);
        if (done == child) return WIFEXITED(status) ? WEXITSTATUS(status) : 126;
        if (done < 0 && errno != EINTR) return 126;
        nanosleep(&nap, NULL);
    }
    kill(-child, SIGKILL);
    waitpid(child, NULL, 0);
    return -1;
}

/* Removes the profile that the browser has made for this print. */
static void profile_remove(const char *dir)
{
    const pid_t child = fork();
    if (child == 0) {
        execlp("rm", "rm", "-rf", "--", dir, (char *)NULL);
        _exit(127);
    }
    if (child > 0) waitpid(child, NULL, 0);
}

/* Copies all of a file into another open one; 0 with errno. */
static int copy(int from, int to)
{
    char bytes[1 << 15];
    ssize_t n = 1;
    int ok = 1;
    while (ok && n != 0) {
        n = read(from, bytes, sizeof bytes);
        for (ssize_t done = 0, w; ok && done < n; done += w) {
            w = write(to, bytes + done, (size_t)(n - done));
            ok = w > 0;
        }
        ok = ok && n >= 0;
    }
    return ok;
}

/* Gives the browser's output its name when it is complete, also in place of a link. */
static hawser_status printed_name(const char *printed, const char *pdf, hawser_error *err)
{
    char part[OPTION_MAX];
    struct stat info;
    const mode_t mask = umask(0);
    umask(mask);
    const int from = open(printed, O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (from < 0 || fstat(from, &info) || info.st_size == 0) {
        if (from >= 0) close(from);
        return fail(err, "the browser could not print to ", pdf);
    }
    const int fits = snprintf(part, sizeof part, "%s.XXXXXX.part", pdf) < (int)sizeof part;
    errno = ENAMETOOLONG;
    const int to = fits ? mkostemps(part, (int)sizeof ".part" - 1, O_CLOEXEC) : -1;
    const int ok = to >= 0 && copy(from, to) && !fchmod(to, 0666 & ~mask) && !fsync(to) && !rename(part, pdf);
    const int number = errno;
    if (to >= 0) close(to);
    if (to >= 0 && !ok) unlink(part);
    close(from);
    if (ok) return HAWSER_OK;
    err->status = HAWSER_ERR_OUTPUT;
    snprintf(err->message, sizeof err->message, "cannot write '%.700s': %s", pdf, strerror(number));
    return HAWSER_ERR_OUTPUT;
}

hawser_status pdf_print(const char *page, const char *pdf, hawser_error *err)
{
    char profile[4096], printed[4096 + 16];
    const char *const tmp = getenv("TMPDIR");
    char *const url = file_url(page);
    if (!url) return fail(err, "cannot print: ", strerror(errno));
    snprintf(profile, sizeof profile, "%.4000s/hawser-print-XXXXXX", tmp && *tmp ? tmp : "/tmp");
    if (!mkdtemp(profile)) {
        free(url);
        return fail(err, "cannot print: no folder for the browser: ", strerror(errno));
    }
    snprintf(printed, sizeof printed, "%s/page.pdf", profile);
    const pid_t child = fork();
    if (child == 0) browser_become(url, printed, profile);
    const int result = child > 0 ? browser_wait(child) : 126;
    const hawser_status status =
        result == 127  ? fail(err,
                              "--pdf needs a Chromium on the path (chromium, chromium-browser or google-chrome); on "
                               "Debian: apt-get install chromium",
                              "")
        : result == -1 ? fail(err, "the browser has not printed the page in time: ", pdf)
        : result       ? fail(err, "the browser could not print to ", pdf)
                       : printed_name(printed, pdf, err);
    profile_remove(profile);
    free(url);
    return status;
}
