/* A text as a file of the catalogue that a case includes: an entry of each kind, by its name, in a case that is read,
 * described and looked at by theory. The text may include another. Entries that the case asks for are called `f`. */
#define _GNU_SOURCE /* memfd_create */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "tests/fuzz/fuzz.h"

/* What the text has beside it: the words that are its, where a case asks for each kind alone and for all. */
static const char plain[] = "{EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}";
static const char *const kinds[] = {
    "cables: {c: {type: f}}\n",
    "cables: {c: {type: f, d: 50 mm, mass: 4 kg/m}}\n",
    "cables: {c: %s}\nrollers: {along: {type: f, spacing: 1 m}}\n",
    "cables: {c: %s}\nsurfaces: {ducts: [{type: f}]}\n",
    "cables: {c: %s}\nfriction: {type: f}\nrollers: {along: {spacing: 1 m, friction: {type: f}}}\n",
    "cables: {c: {type: f}}\nrollers: {along: {type: f, spacing: 1 m}}\nfriction: {type: f}\n"};
enum { KINDS = sizeof kinds / sizeof *kinds, SEGMENTS = 60, ROLLERS = 300 };

static const char rest[] = "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
                           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 1 kN, ramp: none}}\n"
                           "limits: {pull: 20 kN}\n"
                           "run: {duration: 2 s}\n";

static int file_of(const char *text, size_t size)
{
    const int fd = memfd_create("fuzz", 0);
    FUZZ_MUST(fd >= 0 && write(fd, text, size) == (ssize_t)size);
    return fd;
}

static void say(hawser_case *c, hawser_format format)
{
    hawser_error err = {HAWSER_OK, ""};
    char *text = NULL;
    hawser_status status = hawser_case_describe(c, format, &text, &err);
    FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
    hawser_text_free(text);
    text = NULL;
    status = hawser_case_theory(c, format, &text, &err);
    FUZZ_MUST(status ? !text && fuzz_error_is_good((int)status, err.message) : text && *text);
    hawser_text_free(text);
}

FUZZ_TARGET(library)
{
    char text[2048], part[1024];
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    if (size == 0) return 0;
    const int fd = file_of((const char *)data + 1, size - 1);
    const char *const form = kinds[data[0] % KINDS];
    const char *const hole = strstr(form, "%s");
    snprintf(part, sizeof part, "%.*s%s%s", hole ? (int)(hole - form) : (int)strlen(form), form, hole ? plain : "",
             hole ? hole + 2 : "");
    snprintf(text, sizeof text, "include: [%d]\n%s%s", fd, part, rest);
    hawser_status status = hawser_case_parse(text, "fuzz.yaml", &c, &err);
    if (!status) status = hawser_case_folder(c, "/proc/self/fd", &err);
    if (!status) status = hawser_case_check(c, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    if (!status && case_segments(c->def) <= SEGMENTS && c->def->n_rollers <= ROLLERS)
        say(c, data[0] & 128 ? HAWSER_JSON : HAWSER_TABLE);
    hawser_case_free(c);
    close(fd);
    return 0;
}
