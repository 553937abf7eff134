/* Two layers on a drum of two turns: once the slack between the layers is out, the pull lies between those of the two
 * layers' radii. */
#include "tests/support/rig.h"

TEST(test_two_layers)
{
    const double found = payout_pull(80, 2, 2.6, 4), least = wound_pull_at(0.25 + 1.56 * WOUND_DIAMETER),
                 most = wound_pull_at(0.25 + WOUND_DIAMETER / 2);
    print_message("mean pull %.2f N, between %.2f and %.2f N\n", found, least, most);
    check_between(found, least, most);
}
