/* The parts of a case, one function each; for io/case, and who shows its words. Each reads its section of the tree
 * (node NULL: the section is not there), checks it against what was read before it, and fills its share of r->def.
 * Errors: INPUT, MEMORY. The order of the calls is case_read's. A section's keys stand at the head of its file. */
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
    case_theory_wear, case_theory_machine, case_limits, case_medium, case_launch;

/* A copy of the tree with the keys' own names where it has others that people type (diameter of a duct); NULL: it has
 * none. Errors: INPUT (both names), MEMORY. */
hawser_status case_synonyms(const CaseTree *tree, CaseTree **plain, hawser_error *err);
/* Another name of a key in the items of a list; the i-th, NULL: there are no more. */
typedef struct Synonym {
    const char *section, *list, *other, *key;
    int half; /* the value is twice that of the key */
} Synonym;
const Synonym *case_synonym(int i);
/* The tables below `top` as a JSON Schema, malloc'ed; NULL: there is no memory. */
char *case_schema_json(const Units *units, const CaseSection *top);
enum { CASE_FORMAT = 1 }; /* of cases, that is read and written */
/* The text of a case with keys by their own names and its format; the rest, comments too, as it is. *out: malloc'ed.
 * *changes: in how many places. Errors: INPUT (as case_tree_parse; a value that cannot be rewritten), MEMORY. */
hawser_status case_upgrade(const char *text, const char *name, char **out, int *changes, hawser_error *err);
/* The text with n more items, each a map in one line, in a list of the section `theory`; *out is malloc'ed. Errors: as
 * above, INPUT (the section stands there as something that nothing can be added to). */
hawser_status case_theory_insert(const char *text, const char *name, const char *list, int n, char *const row[],
                                 char **out, hawser_error *err);

hawser_status case_cables_read(CaseReader *r, const CaseNode *node);
/* A cable's table of bending and the rigidity that is its first slope; node: the cable's map. */
hawser_status case_bending_read(const CaseReader *r, const CaseNode *node, CableDef *cable);
/* Limits that the case leaves open and the chain's own cables answer: conductor of the first piece, strength of the
 * rope.
 */
hawser_status case_cables_limits(CaseReader *r, const CaseNode *node);
hawser_status case_chain_read(CaseReader *r, const CaseNode *node);
/* Several cables pulled together: from then on the chain is the cable that stands for them. */
hawser_status case_bundle_read(CaseReader *r, const CaseNode *node);
/* What a bundle cannot be beside. After all that could be. */
hawser_status case_bundle_check(CaseReader *r, const CaseNode *node);
extern const char *const case_layouts[]; /* in the order of DuctLayout */
hawser_status case_run_read(CaseReader *r, const CaseNode *node);
/* What a run of so many segments and rollers would need, for the message that refuses them: "10000000 segments: needs
 * 77 GB, 2.1 h". The time is left out where the case does not say how long it runs. */
void case_cost_say(const CaseReader *r, double segments, double rollers, int size, char *text);
/* After the route and the drive, which say how long a run takes whose case does not. */
hawser_status case_run_complete(CaseReader *r, const CaseNode *node);
/* The lists of the section `theory`. */
hawser_status case_planner_read(CaseReader *r, const CaseNode *node);
/* Its chain without a route; r->route is then a straight of the chain's length. After the run, whose analysis says how
 * loads come in. */
hawser_status case_rod_read(CaseReader *r, const CaseNode *node);
hawser_status case_rod_ends_read(const CaseReader *r, const CaseNode *node);
hawser_status case_rod_loads_read(const CaseReader *r, const CaseNode *node);
/* Leaves the route built in r->route, unless there is a rod. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node);
/* What goes with a pull only, or with a rod only. */
hawser_status case_rod_check(CaseReader *r, const CaseNode *node);
/* Whether loads come in by steps in place of time. */
static inline int case_load_steps(const SceneDef *def)
{
    return def->analysis.kind == ANALYSIS_STATIC || def->analysis.kind == ANALYSIS_MODES;
}
/* A bend's plane: a word, or the angle of its centre about the tangent (core/route.h). */
hawser_status case_plane_read(const CaseReader *r, const CaseNode *node, double *plane);
hawser_status case_lead_in_read(CaseReader *r, const CaseNode *node);
hawser_status case_contact_read(CaseReader *r, const CaseNode *node);
/* The case's own friction law, and then that of cable on cable. */
hawser_status case_frictions_read(CaseReader *r, const CaseNode *node);
hawser_status case_frictions_settle(CaseReader *r, const CaseNode *node);
/* A friction law; what is not given is the base's. */
/* Where the coefficient in motion of a section `friction` is from; `base`: of what it leaves out. */
FrictionKnown case_friction_known(const CaseReader *r, const CaseNode *node, const FrictionKnown *base);
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law);
/* Of a velocity function: v_d, or 2 v_s where it was not given, which must be above v_s. */
hawser_status case_speeds_check(const CaseReader *r, const CaseNode *node, double v_s, double *v_d);
/* A contact law's stiffness, whose unit goes with the exponent e. */
hawser_status case_stiffness_read(const CaseReader *r, const CaseNode *node, double e, double *k);
hawser_status case_surfaces_read(CaseReader *r, const CaseNode *node);

/* Where the rollers of a row stand. */
enum { GUIDE_NONE, GUIDE_INSIDE, GUIDE_BOTH, GUIDE_LEFT, GUIDE_RIGHT };
typedef struct RowPlaces {
    double from, to, spacing; /* m; NAN: the route's end, by count */
    int count;                /* 0: by spacing */
    int guide;
} RowPlaces;
/* NAN: by the profile and the cable. */
typedef struct GrooveRecord {
    double angle, radius, depth;
} GrooveRecord;

hawser_status case_rollers_read(CaseReader *r, const CaseNode *node);
/* Where piece p of the chain lies along the route at the start, m. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to);
/* Whether a roller stays out of the cable along the route; node: where the roller was written. */
hawser_status case_overlap_check(const CaseReader *r, const CaseNode *node, const RollerDef *roller);
/* How a roller of this radius (m) spins and what it stands on; NULL: it does not, it is fixed. */
hawser_status case_spin_read(const CaseReader *r, const CaseNode *node, double radius, SpinDef *spin);
hawser_status case_mount_read(const CaseReader *r, const CaseNode *node, MountDef *mount);
/* The groove of a roller of this profile and width (m), checked against the thickest cable; node: the row or roller. */
hawser_status case_groove_make(const CaseReader *r, const CaseNode *node, int profile, const GrooveRecord *record,
                               double width, Groove *groove);
/* [from, to] with to >= from, both of the key. */
hawser_status case_stretch_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double ends[2]);
/* Where along the route the rollers of a row stand: s[n], malloc'ed, rising within each stretch. */
hawser_status case_places_find(const CaseReader *r, const CaseNode *node, const RowPlaces *row, double **s, int *n);
/* Curvature of the route to the left at s, 1/m: the part that is a bend to the side. */
double case_sideways(const CaseReader *r, double s);

/* After rollers and surfaces, whose list they join and whose ducts they flare. */
hawser_status case_obstacles_read(CaseReader *r, const CaseNode *list);

hawser_status case_drive_read(CaseReader *r, const CaseNode *node);
/* A value over time whose ramp and end value v1 a section's keys have filled: checks them, or reads the map's `table`.
 * value: the name of the section's key for v1. The profile owns what is read of the
 * table, even if there is an error. */
hawser_status case_profile_read(const CaseReader *r, const CaseNode *map, const CaseSection *section, const char *value,
                                Profile *profile);
hawser_status case_tail_read(const CaseReader *r, const CaseNode *node, const CaseSection *section);
/* After the drive, whose speed the belts may follow. */
hawser_status case_conveyors_read(CaseReader *r, const CaseNode *list);
/* After all that the cable runs through: the segments of pieces that leave their length to the geometry. */
hawser_status case_mesh_read(CaseReader *r, const CaseNode *node);
/* After all that can jam. */
hawser_status case_jams_read(CaseReader *r, const CaseNode *list);
/* After all that can be told something; node: the drive. */
hawser_status case_script_read(CaseReader *r, const CaseNode *node);
hawser_status case_reel_read(CaseReader *r, const CaseNode *node);
/* After the reel, which neither goes with. */
hawser_status case_medium_read(CaseReader *r, const CaseNode *node);
hawser_status case_launch_read(CaseReader *r, const CaseNode *node);
hawser_status case_output_read(CaseReader *r, const CaseNode *node);
/* Places of the chain that are watched. */
hawser_status case_probes_read(const CaseReader *r, const CaseNode *list);
hawser_status case_paper_read(CaseReader *r, const CaseNode *node);
hawser_status case_theory_read(CaseReader *r, const CaseNode *node);
hawser_status case_limits_read(CaseReader *r, const CaseNode *node);

/* Length of the whole chain, m. */
double case_chain_length(const SceneDef *def);
/* Segments of the whole chain; the largest diameter of its cables, m. */
int case_segments(const SceneDef *def);
/* The longest segment, m; of pieces that leave it to the geometry what that gives at most, of a rod nothing. */
double case_longest_segment(const SceneDef *def);
double case_largest_diameter(const SceneDef *def);
/* The eye: the first segment of the last piece; the number of segments if there is one piece. */
int case_eye(const SceneDef *def);

#endif
