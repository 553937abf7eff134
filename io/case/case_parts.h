/* The parts of a case, one function each; for io/case, and for code that shows its words. Each reads its section of the
 * tree (node NULL: the section is not there), checks it against what was read before it, and fills its share of r->def.
 * Errors: INPUT, MEMORY. The order of the calls is that of case_read. A section's keys are at the head of its file. */
#ifndef HAWSER_IO_CASE_CASE_PARTS_H
#define HAWSER_IO_CASE_CASE_PARTS_H

#include "io/case/drawing.h"
#include "io/case/schema.h"

enum {
    CASE_SEGMENTS_MAX = 200000,
    CASE_ROLLERS_MAX = 100000,
    CASE_STATIONS_MAX = 100000,
    CASE_SURFACES_MAX = 1000,
    CASE_OUTPUTS_MAX = 10000000,
    CASE_CONVEYORS_MAX = 10000
};

extern const CaseSection case_top, case_cable, case_bending, case_chain_piece, case_bundle, case_run, case_rod,
    case_rod_tail, case_rod_head, case_rod_load, case_rod_mass, case_route, case_route_piece, case_route_plan,
    case_route_heights, case_route_profile, case_lead_in, case_contact, case_friction, case_groove, case_spin,
    case_mount, case_rollers, case_surfaces, case_drive, case_tail, case_back_tension, case_reel, case_jam,
    case_command, case_obstacle, case_solver, case_output, case_probe, case_paper, case_theory, case_theory_friction,
    case_theory_wear, case_theory_machine, case_limits, case_medium, case_launch, case_environment;

/* Returns a copy of the tree in which other names of keys that people type (diameter of a duct) are replaced by the
 * keys' own; NULL: it has none. Errors: INPUT (both names), MEMORY. */
hawser_status case_synonyms(const CaseTree *tree, CaseTree **plain, hawser_error *err);
/* Another name of a key in the items of a list. case_synonym returns the i-th, NULL: there are no more. */
typedef struct Synonym {
    const char *section, *list, *other, *key;
    int half; /* the value is twice that of the key */
} Synonym;
const Synonym *case_synonym(int i);
/* Returns the tables below `top` as a JSON Schema, malloc'ed; NULL: there is no memory. */
char *case_schema_json(const Units *units, const CaseSection *top);
enum { CASE_FORMAT = 1 }; /* format of cases that is read and written */
/* Rewrites the text of a case with the keys' own names and its format; the rest, comments too, stays as it is. *out:
 * malloc'ed. *changes: number of places. Errors: INPUT (as case_tree_parse; a value that cannot be rewritten), MEMORY.
 */
hawser_status case_upgrade(const char *text, const char *name, char **out, int *changes, hawser_error *err);
/* Adds n items, each a map in one line, to a list of the section `theory` in the text; *out is malloc'ed. Errors: as
 * above, INPUT (nothing can be added to the section as it is written). */
hawser_status case_theory_insert(const char *text, const char *name, const char *list, int n, char *const row[],
                                 char **out, hawser_error *err);

hawser_status case_cables_read(CaseReader *r, const CaseNode *node);
/* Reads a cable's table of bending, and the rigidity that is its first slope; node: the cable's map. */
hawser_status case_bending_read(const CaseReader *r, const CaseNode *node, CableDef *cable);
/* Completes limits that the case leaves open from the chain's own cables: conductor of the first piece, strength of the
 * rope. */
hawser_status case_cables_limits(CaseReader *r, const CaseNode *node);
hawser_status case_chain_read(CaseReader *r, const CaseNode *node);
/* Reads several cables pulled together: from then on the chain is their equivalent cable. */
hawser_status case_bundle_read(CaseReader *r, const CaseNode *node);
/* Rejects everything that cannot be combined with a bundle. Called after all of it. */
hawser_status case_bundle_check(CaseReader *r, const CaseNode *node);
extern const char *const case_layouts[]; /* order of DuctLayout */
hawser_status case_run_read(CaseReader *r, const CaseNode *node);
/* Writes the needs of a run with this many segments and rollers, for the message that refuses them: "10000000 segments:
 * needs 77 GB, 2.1 h". The time is omitted where the case does not give the duration. */
void case_cost_say(const CaseReader *r, double segments, double rollers, int size, char *text);
/* Called after the route and the drive, which give the duration of a run where the case does not. */
hawser_status case_run_complete(CaseReader *r, const CaseNode *node);
/* Reads the lists of the section `theory`. */
hawser_status case_planner_read(CaseReader *r, const CaseNode *node);
/* Reads the shape of a rod, a chain without a route; r->route is then a straight of the chain's length. Called after
 * the run, whose analysis decides how loads start. */
hawser_status case_rod_read(CaseReader *r, const CaseNode *node);
hawser_status case_rod_ends_read(const CaseReader *r, const CaseNode *node);
hawser_status case_rod_loads_read(const CaseReader *r, const CaseNode *node);
/* Builds the route in r->route, unless there is a rod. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node);
/* Checks for keys that belong to a pull only, or to a rod only. */
hawser_status case_rod_check(CaseReader *r, const CaseNode *node);
/* Checks whether loads grow in steps in place of time. */
static inline int case_load_steps(const SceneDef *def)
{
    return def->analysis.kind == ANALYSIS_STATIC || def->analysis.kind == ANALYSIS_MODES;
}
/* Reads a bend's plane: a word, or the angle of its centre about the tangent (core/route.h). */
hawser_status case_plane_read(const CaseReader *r, const CaseNode *node, double *plane);
hawser_status case_lead_in_read(CaseReader *r, const CaseNode *node);
hawser_status case_contact_read(CaseReader *r, const CaseNode *node);
/* Read the case's own friction law, and then that of cable on cable. */
hawser_status case_frictions_read(CaseReader *r, const CaseNode *node);
hawser_status case_frictions_settle(CaseReader *r, const CaseNode *node);
/* Reads a friction law; values that are not given are the base's. */
/* Returns the source of the moving coefficient of a section `friction`; `base`: source of values that are not given. */
FrictionKnown case_friction_known(const CaseReader *r, const CaseNode *node, const FrictionKnown *base);
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law);
/* Completes v_d of a velocity function, 2 v_s where it was not given, and checks that it is above v_s. */
hawser_status case_speeds_check(const CaseReader *r, const CaseNode *node, double v_s, double *v_d);
/* Reads a contact law's stiffness, whose unit depends on the exponent e. */
hawser_status case_stiffness_read(const CaseReader *r, const CaseNode *node, double e, double *k);
hawser_status case_surfaces_read(CaseReader *r, const CaseNode *node);

/* Reads the models of the environment, and writes their equipment into the tree as a drawing's (EN3). */
hawser_status case_environment_read(CaseReader *r, const CaseNode *list);
/* Called after the friction: that of the layers. */
hawser_status case_environment_settle(CaseReader *r, const CaseNode *list);

/* Places of the rollers of a row. */
enum { GUIDE_NONE, GUIDE_INSIDE, GUIDE_BOTH, GUIDE_LEFT, GUIDE_RIGHT };
typedef struct RowPlaces {
    double from, to, spacing; /* m; NAN: the route's end, by count */
    int count;                /* 0: by spacing */
    int guide;
} RowPlaces;
/* NAN: from the profile and the cable. */
typedef struct GrooveRecord {
    double angle, radius, depth;
} GrooveRecord;

hawser_status case_rollers_read(CaseReader *r, const CaseNode *node);
/* Returns the ends of piece p of the chain along the route at the start, m. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to);
/* Checks that a roller does not overlap the cable along the route; node: where the roller was written. */
hawser_status case_overlap_check(const CaseReader *r, const CaseNode *node, const RollerDef *roller);
/* Reads the spin and the mount of a roller of this radius (m); NULL: it does not spin, it is fixed. */
hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin);
hawser_status case_mount_read(const CaseReader *r, const CaseNode *node, MountDef *mount);
/* Makes the groove of a roller of this profile and width (m), checked against the thickest cable; node: the row or
 * roller. */
hawser_status case_groove_make(const CaseReader *r, const CaseNode *node, int profile, const GrooveRecord *record,
                               double width, Groove *groove);
/* Reads [from, to] with to >= from, both of the key. */
hawser_status case_stretch_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double ends[2]);
/* Finds the places of a row's rollers along the route: s[n], malloc'ed, rising within each stretch. */
hawser_status case_places_find(const CaseReader *r, const CaseNode *node, const RowPlaces *row, double **s, int *n);
/* Returns the curvature of the route to the left at s, 1/m: the lateral part of a bend. */
double case_sideways(const CaseReader *r, double s);

/* Called after rollers and surfaces: obstacles join the rollers' list and flare the ducts. */
hawser_status case_obstacles_read(CaseReader *r, const CaseNode *list);

hawser_status case_drive_read(CaseReader *r, const CaseNode *node);
/* Reads a value over time whose ramp and end value v1 a section's keys have filled: checks them, or reads the map's
 * `table`. value: the name of the section's key for v1. The profile owns what is read of the table, even if there is an
 * error. */
hawser_status case_profile_read(const CaseReader *r, const CaseNode *map, const CaseSection *section, const char *value,
                                Profile *profile);
hawser_status case_tail_read(const CaseReader *r, const CaseNode *node, const CaseSection *section);
/* Called after the drive, whose speed the belts may follow. */
hawser_status case_conveyors_read(CaseReader *r, const CaseNode *list);
/* Counts the segments of pieces whose length depends on the geometry. Called after everything that the cable runs
 * through. */
hawser_status case_mesh_read(CaseReader *r, const CaseNode *node);
/* Called after everything that can jam. */
hawser_status case_jams_read(CaseReader *r, const CaseNode *list);
/* Called after everything that takes commands; node: the drive. */
hawser_status case_script_read(CaseReader *r, const CaseNode *node);
hawser_status case_reel_read(CaseReader *r, const CaseNode *node);
/* Called after the reel, which excludes both. */
hawser_status case_medium_read(CaseReader *r, const CaseNode *node);
hawser_status case_launch_read(CaseReader *r, const CaseNode *node);
hawser_status case_output_read(CaseReader *r, const CaseNode *node);
/* Reads the places of the chain that are recorded. */
hawser_status case_probes_read(const CaseReader *r, const CaseNode *list);
hawser_status case_paper_read(CaseReader *r, const CaseNode *node);
hawser_status case_theory_read(CaseReader *r, const CaseNode *node);
hawser_status case_limits_read(CaseReader *r, const CaseNode *node);

/* Returns the length of the whole chain, m. */
double case_chain_length(const SceneDef *def);
/* Return the number of segments of the whole chain, and the largest diameter of its cables, m. */
int case_segments(const SceneDef *def);
/* Returns the longest segment, m; for pieces that leave it to the geometry the largest possible one, for a rod nothing.
 */
double case_longest_segment(const SceneDef *def);
double case_largest_diameter(const SceneDef *def);
/* Returns the eye: the first segment of the last piece; the number of segments if there is one piece. */
int case_eye(const SceneDef *def);

#endif
