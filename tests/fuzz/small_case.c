#include "tests/fuzz/small_case.h"

#include <stdlib.h>

#include "def/cost.h"
#include "io/api/api_handles.h"
#include "tests/fuzz/fuzz.h"

enum { SEGMENTS = 60, PIECES = 60, ROLLERS = 300, SURFACES = 40, MACHINES = 20, STATIONS = 2000 };

static int is_small(const SceneDef *def)
{
    return cost_counts(def, 0).segments <= SEGMENTS && def->n_route <= PIECES && def->n_rollers <= ROLLERS &&
           def->n_surfaces <= SURFACES && def->n_conveyors <= MACHINES && def->n_stations <= STATIONS;
}

hawser_case *small_case_parse(const uint8_t *data, size_t size)
{
    char *const text = fuzz_text(data, size);
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_status status = hawser_case_parse(text, "fuzz.yaml", &c, &err);
    free(text);
    FUZZ_MUST((status == HAWSER_OK) == (c != NULL));
    if (!status) status = hawser_case_check(c, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    if (!status && is_small(c->def)) return c;
    hawser_case_free(c);
    return NULL;
}
