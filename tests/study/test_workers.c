/* Worker processes, whatever their number: the same bytes. Apart from test_engine.c, so that the sanitizers of the
 * default tier see what workers share. */
#include "tests/study/study_fixture.h"

TEST(workers_alike)
{
    const char *const lines[] = {drawn, runs};
    for (int k = 0; k < 2; k++) {
        char one[20], two[20], four[20];
        snprintf(one, sizeof one, "one%d", k);
        snprintf(two, sizeof two, "two%d", k);
        snprintf(four, sizeof four, "four%d", k);
        study_compute(lines[k], one, 1);
        study_compute(lines[k], two, 2);
        study_compute(lines[k], four, 4);
        expect_alike(one, two);
        expect_alike(one, four);
    }
}

TEST_GROUP(scratch_make, scratch_remove)
