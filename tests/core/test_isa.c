/* HAWSER_ISA: what it names is taken where the machine has it, what it must not name is said and not followed. The
 * choice is made before main(), so that each word is tried in a process of its own. */
#include "core/base/isa.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/check.h"

static const char *program;

enum { FINE = 0, NONE_SUCH = 10, NOT_HERE = 20 };

/* What a process with this word in its environment says: its set, and what it complains of. */
static int with_word(const char *word)
{
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        if (word) setenv("HAWSER_ISA", word, 1);
        if (!word) unsetenv("HAWSER_ISA");
        execl(program, program, "--say", (char *)NULL);
        _exit(99);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static int say(void)
{
    const char *const complaint = isa_complaint();
    if (!complaint) return FINE + (int)isa_best();
    return (strstr(complaint, "none of generic, avx2, avx512") ? NONE_SUCH : NOT_HERE) + (int)isa_best();
}

static void test_words(void **state)
{
    (void)state;
    const int best = with_word(NULL);
    check_between(best, -1, ISA_AVX512 + 1);
    assert_int_equal(with_word(""), best);
    assert_int_equal(with_word("generic"), FINE + ISA_GENERIC);
    for (Isa isa = ISA_GENERIC; isa <= ISA_AVX512; ++isa) {
        assert_int_equal(with_word(isa_name(isa)), (int)isa <= best ? FINE + (int)isa : NOT_HERE + best);
    }
    assert_int_equal(with_word("AVX2"), NONE_SUCH + best);
    assert_int_equal(with_word("avx5"), NONE_SUCH + best);
}

int main(int argc, char **argv)
{
    program = argv[0];
    if (argc > 1) return say();
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
