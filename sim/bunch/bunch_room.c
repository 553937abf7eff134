/* Several chains beside each other, in the scene of the first: the figures that each has among the others. What they do
 * to each other is in sim/bunch. docs/model.md, "Several chains". */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

typedef struct Chains {
    int n;
    const ChainsLook *look;            /* the scene's */
    const char *name[STRANDS_MAX + 1]; /* the definition's; then all together */
} Chains;

static hawser_status chains_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Chains *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    room->present = def->n_beside > 0;
    all->look = &scene->chains;
    if (!room->present) return HAWSER_OK;
    all->name[all->n++] = def->strand.name;
    for (int k = 0; k < def->n_beside; ++k) all->name[all->n++] = def->beside[k].strand.name;
    all->name[all->n++] = CHAINS_ALL;
    return HAWSER_OK;
}

static int chains_count(const Room *room) { return ((const Chains *)room->self)->n; }
static const char *chains_name(const Room *room, int i) { return ((const Chains *)room->self)->name[i]; }

enum { PULL, SHARE, BETWEEN, WALLS, CROSSINGS, TWIST, WEIGHT, REFERENCE };

static void chains_keep(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX])
{
    const Chains *const all = room->self;
    (void)m;
    const ChainLook look = i < all->look->n ? all->look->chain[i] : all->look->all;
    value[PULL] = look.pull;
    value[SHARE] = look.share;
    value[BETWEEN] = look.between;
    value[WALLS] = look.walls;
    value[CROSSINGS] = look.crossings;
    value[TWIST] = look.twist;
    value[WEIGHT] = look.weight;
    value[REFERENCE] = look.reference;
}

static void chains_figures(const Room *room, int i, const TimeMean *kept, double expected,
                           double value[MACHINE_FIGURES_MAX])
{
    const Chains *const all = room->self;
    (void)expected;
    const ChainLook *const look = i < all->look->n ? &all->look->chain[i] : &all->look->all;
    const double figure[] = {mean_of(&kept[PULL]),
                             kept[PULL].peak,
                             mean_of(&kept[SHARE]),
                             mean_of(&kept[BETWEEN]),
                             kept[BETWEEN].peak,
                             mean_of(&kept[WALLS]),
                             mean_of(&kept[WEIGHT]),
                             mean_of(&kept[WALLS]) / mean_of(&kept[WEIGHT]),
                             look->factor,
                             mean_of(&kept[REFERENCE]),
                             mean_of(&kept[CROSSINGS]),
                             mean_of(&kept[TWIST])};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; ++k) value[k] = figure[k];
}

static const MachineKind CHAINS = {.key = "chains",
                                   .count = chains_count,
                                   .name = chains_name,
                                   .n_now = 6,
                                   .n_kept = 8,
                                   .now = {"pull_N", "share", "between_N_per_m", "walls_N", "crossings", "twist_rad"},
                                   .keep = chains_keep,
                                   .n_figures = 12,
                                   .figure = {"pull_mean_N", "pull_peak_N", "share", "between_mean_N_per_m",
                                              "between_peak_N_per_m", "walls_mean_N", "weight_N", "weight_correction",
                                              "weight_factor", "reference_N", "crossings", "twist_rad"},
                                   .figures = chains_figures};

const RoomKind CHAINS_ROOM = {.name = "several chains",
                              .build = chains_build,
                              .machines = &CHAINS,
                              .in_space = "several chains are pulled together"};
