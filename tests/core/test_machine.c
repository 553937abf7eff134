/* What the program finds out of the machine that it runs on: its instruction sets, against what the system says of
 * them, the environment's word for another one, and the clock. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/machine.h"
#include "tests/support/check.h"

/* The set is chosen before main(): a process of this program that is to print it does so before its tests. */
static int print_isa_if_required(void **state)
{
    (void)state;
    if (!getenv("HAWSER_TEST_PRINTS_ISA")) return 0;
    printf("%s %s\n", isa_name(isa_best()), isa_complaint() ? isa_complaint() : "");
    exit(0);
}

/* Such a process with HAWSER_ISA set to `wish`, or without it (NULL): the name of the set, then the complaint, if any;
 * its last line. */
static void chosen_with(const char *wish, char *said, int room)
{
    char command[1024], self[512] = "";
    assert_true(readlink("/proc/self/exe", self, sizeof self - 1) > 0);
    snprintf(command, sizeof command, "env %s'%s' HAWSER_TEST_PRINTS_ISA=1 '%s' test_machine",
             wish ? "HAWSER_ISA=" : "-u HAWSER_ISA ", wish ? wish : "_=", self);
    FILE *const from = popen(command, "r");
    assert_non_null(from);
    said[0] = 0;
    while (fgets(said, room, from)) continue;
    assert_int_equal(pclose(from), 0);
}

static const char *const names[] = {"generic", "avx2", "avx512"};

/* Whether the system lists a processor's flag. */
static int has_flag(const char *flags, const char *flag)
{
    char word[32];
    snprintf(word, sizeof word, " %s ", flag);
    return strstr(flags, word) != NULL;
}

/* The best set by the system's list of flags, of those that the build has; -1: there is no list. */
static int best_listed(void)
{
#ifndef HAWSER_X86
    return ISA_GENERIC;
#endif
    static char line[1 << 14];
    FILE *const from = fopen("/proc/cpuinfo", "r");
    int best = -1;
    while (from && best < 0 && fgets(line, sizeof line, from)) {
        if (strncmp(line, "flags", 5) != 0) continue;
        line[strcspn(line, "\n")] = ' ';
        best = has_flag(line, "avx2") && has_flag(line, "fma") ? ISA_AVX2 : ISA_GENERIC;
        if (best == ISA_AVX2 && has_flag(line, "avx512f") && has_flag(line, "avx512dq") && has_flag(line, "avx512vl"))
            best = ISA_AVX512;
    }
    if (from) fclose(from);
    return best;
}

/* Without a word in the environment, or with an empty one, the best there is. */
TEST(best_of_the_machine)
{
    const int best = best_listed();
    if (best < 0) skip();
    char said[200], expected[200];
    snprintf(expected, sizeof expected, "%s \n", names[best]);
    chosen_with(NULL, said, sizeof said);
    assert_string_equal(said, expected);
    chosen_with("", said, sizeof said);
    assert_string_equal(said, expected);
}

/* Every set up to the best can be asked for; one above it, or a word that names none, is not followed, and that is
 * said. */
TEST(wishes)
{
    char said[200], best[200];
    chosen_with(NULL, best, sizeof best);
    int top = 0;
    while (strncmp(best, names[top], strlen(names[top])) != 0 || best[strlen(names[top])] != ' ')
        assert_true(++top < 3);
    for (int isa = 0; isa < 3; ++isa) {
        char expected[200];
        chosen_with(names[isa], said, sizeof said);
        snprintf(expected, sizeof expected, "%s %s\n", names[isa <= top ? isa : top],
                 isa <= top ? "" : "HAWSER_ISA names an instruction set that this machine or this build does not have");
        assert_string_equal(said, expected);
        assert_string_equal(isa_name((Isa)isa), names[isa]);
    }
    best[strlen(best) - 1] = 0;
    static const char *const unknown[] = {"sse9", "AVX2", "avx5"};
    for (int k = 0; k < 3; ++k) {
        chosen_with(unknown[k], said, sizeof said);
        check_has(said, best);
        check_has(said, "HAWSER_ISA in the environment is none of generic, avx2, avx512");
    }
}

/* A clock that counts seconds: it moves on by what the system's moves on in the same time, and never back. */
TEST(the_clock_counts_seconds)
{
    struct timespec before, after, rest = {.tv_nsec = 30000000};
    clock_gettime(CLOCK_BOOTTIME, &before);
    const double first = clock_now();
    nanosleep(&rest, NULL);
    const double last = clock_now();
    clock_gettime(CLOCK_BOOTTIME, &after);
    check_at_least(last - first, 0.03);
    check_at_most(last - first,
                  (double)(after.tv_sec - before.tv_sec) + 1e-9 * (double)(after.tv_nsec - before.tv_nsec) + 1e-6);
    for (int i = 0; i < 200000; ++i) { /* across ends of whole seconds, or not */
        const double a = clock_now(), b = clock_now();
        check_at_least(b - a, 0);
    }
}

TEST_GROUP(print_isa_if_required, NULL)
