/* What codes allow, and what a planner is told where that is not kept: the right figure of each beside the one that was
 * printed before. */
#include "tests/io/theory_fixture.h"

static const json_t *limit_row(const json_t *answer, const char *name)
{
    json_t *limit;
    size_t i;
    json_array_foreach(json_object_get(answer, "limits"), i, limit)
    {
        if (!strcmp(json_string_value(json_object_get(limit, "name")), name)) return limit;
    }
    fail_msg("no limit %s", name);
    return NULL;
}

static const char *text_of(const json_t *row, const char *key) { return json_string_value(json_object_get(row, key)); }

static const char bundled[] = "cables: {power: {type: xlpe-132kv-1000-cu}}\n"
                              "bundle: {cables: 3}\n"
                              "route: {pieces: [{straight: 100 m}, {bend: 90 deg, radius: 6 m, plane: left}]}\n"
                              "surfaces: {ducts: [{radius: 160 mm}]}\n"
                              "friction: {mu: 0.25}\n"
                              "limits: {code: iec}\n";

/* Three cables of the catalogue were NOT JUDGED, "needs limits.conductor.area", where one alone was: two thirds of
 * 3 x 50 N/mm2 x 1000 mm2. */
static void a_bundle_has_its_cables_conductor(void **state)
{
    (void)state;
    json_t *const answer = theory_of(bundled, NULL);
    check_share(number_of(limit_row(answer, "pull"), "limit"), 100e3, 1e-12);
    verdict_has(answer, "SAFE");
    json_decref(answer);
}

/* Of several kinds the thickest is pulled at, whatever the thin one is made of; kinds as thick that are unlike have
 * none in common. */
static void kinds_of_a_bundle(void **state)
{
    (void)state;
    static const char text[] = "cables:\n"
                               "  a: {d: 50 mm, mass: 6 kg/m, conductor: {material: copper, area: 300 mm2}}\n"
                               "  b: {d: %s, mass: 2 kg/m, conductor: {material: aluminium, area: 95 mm2}}\n"
                               "chain: [{cable: a, length: 100 m}]\n"
                               "bundle: {members: [{cable: a, count: 3}, {cable: b, count: 1}]}\n"
                               "route: {pieces: [{straight: 100 m}]}\n"
                               "surfaces: {ducts: [{radius: 100 mm}]}\n"
                               "friction: {mu: 0.25}\n"
                               "limits: {code: paper}\n";
    for (int thick = 0; thick < 2; ++thick) {
        char all[1000];
        snprintf(all, sizeof all, text, thick ? "49 mm" : "20 mm");
        json_t *const answer = theory_of(all, NULL);
        const json_t *const pull = limit_row(answer, "pull");
        if (thick) check_has(text_of(pull, "source"), "needs limits.conductor.area");
        if (!thick) check_share(number_of(pull, "limit"), 3 * 300 * 70, 1e-12);
        json_decref(answer);
    }
}

TEST_FILE(test_codes, cmocka_unit_test(a_bundle_has_its_cables_conductor), cmocka_unit_test(kinds_of_a_bundle))
