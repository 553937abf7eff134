/* Settings: every line "KEY=VALUE" of the input is set in a case that is good, which is then read. */
#include <stdlib.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/fuzz/fuzz.h"

static const char good[] = "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
                           "chain: [{cable: c, length: 10 m}]\n"
                           "route: {head_at: 10 m, pieces: [{straight: 12 m}]}\n"
                           "rollers: {along: {from: 0 m, to: 12 m, spacing: 2 m}}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 1 kN, ramp: none}}\n"
                           "run: {duration: 2 s}\n";

FUZZ_TARGET(set)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    FUZZ_MUST(hawser_case_parse(good, "good.yaml", &c, &err) == HAWSER_OK);
    char *const text = fuzz_text(data, size);
    char *place = NULL;
    for (char *line = strtok_r(text, "\n", &place); line; line = strtok_r(NULL, "\n", &place)) {
        char *const equals = strchr(line, '=');
        if (!equals) continue;
        *equals = 0;
        err = (hawser_error){0};
        const hawser_status status = hawser_case_set(c, line, equals + 1, &err);
        if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    }
    err = (hawser_error){0};
    const hawser_status status = hawser_case_check(c, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    free(text);
    hawser_case_free(c);
    return 0;
}
