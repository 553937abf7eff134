/* The parts of a case, one function each; for io/case_*.c only. Each reads its section of the tree (node
 * NULL: the section is not there), checks it against what was read before it, and fills its share of r->def.
 * Errors: INPUT, MEMORY. The order of the calls is case_read's. */
#ifndef HAWSER_IO_CASE_CASE_PARTS_H
#define HAWSER_IO_CASE_CASE_PARTS_H

#include "io/schema/case_fields.h"
#include "io/schema/case_records.h"
#include "io/schema/case_records_rod.h"

enum {
    CASE_SEGMENTS_MAX = 200000,
    CASE_ROLLERS_MAX = 100000,
    CASE_STATIONS_MAX = 100000,
    CASE_SURFACES_MAX = 1000,
    CASE_OUTPUTS_MAX = 10000000,
    CASE_CONVEYORS_MAX = 10000
};

hawser_status case_gravity_read(const CaseReader *r, const CaseNode *node);
hawser_status case_cables_read(const CaseReader *r, const CaseNode *node);
/* A cable's table of bending and the rigidity that is its first slope; node: the cable's map. */
hawser_status case_bending_read(const CaseReader *r, const CaseNode *node, const BendingRecord *record,
                                CableDef *cable);
hawser_status case_chain_read(const CaseReader *r, const CaseNode *node);
/* Leaves the route built in r->route. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node);
/* Its chain without a route; r->route is then a straight of the chain's length. After the run, whose analysis says how
 * loads come in. */
hawser_status case_rod_read(CaseReader *r, const CaseNode *node);
hawser_status case_rod_ends_read(const CaseReader *r, const RodRecord *record);
hawser_status case_rod_loads_read(const CaseReader *r, const RodRecord *record);
/* What goes with a pull only, or with a rod only. */
hawser_status case_rod_check(const CaseReader *r);
/* A bend's plane: a word, or the angle of its centre about the tangent (core/route.h). */
hawser_status case_plane_read(const CaseReader *r, const CaseNode *node, double *plane);
hawser_status case_lead_in_read(const CaseReader *r, const CaseNode *node);
hawser_status case_contact_read(const CaseReader *r, const CaseNode *node);
/* Its friction of cable on cable, once the case's own is known. */
hawser_status case_cable_friction_read(const CaseReader *r, const CaseNode *contact);
/* A friction law; what is not given is the base's. */
hawser_status case_friction_read(const CaseReader *r, const CaseNode *node, const FrictionLaw *base, FrictionLaw *law);
/* Of a velocity function: v_d, or 2 v_s where it was not given, which must be above v_s. */
hawser_status case_speeds_check(const CaseReader *r, const CaseNode *node, double v_s, double *v_d);
/* A contact law's stiffness, whose unit goes with the exponent e. */
hawser_status case_stiffness_read(const CaseReader *r, const CaseNode *node, double e, double *k);
hawser_status case_surfaces_read(const CaseReader *r, const CaseNode *node);
hawser_status case_rollers_read(const CaseReader *r, const CaseNode *node);
/* Where piece p of the chain lies along the route at the start, m. */
void case_piece_place(const SceneDef *def, int p, double *from, double *to);
/* Whether roller i stays out of the cable along the route; node: where the roller was written. */
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
hawser_status case_places_find(const CaseReader *r, const CaseNode *node, const RollerRowRecord *row, double **s,
                               int *n);
/* Curvature of the route to the left at s, 1/m: the part that is a bend to the side. */
double case_sideways(const CaseReader *r, double s);
hawser_status case_drive_read(const CaseReader *r, const CaseNode *node);
/* A value over time, as `record` says it: a ramp from 0, or a table. value: the name of the section's key. The table's
 * arrays become the caller's even if there is an error. */
hawser_status case_profile_make(const CaseReader *r, const CaseNode *map, const CaseSection *section, const char *value,
                                const DriveRecord *record, Profile *profile, double **time, double **values);
/* After the drive, whose winch the belts may follow. */
hawser_status case_conveyors_read(const CaseReader *r, const CaseNode *list);
hawser_status case_reel_read(const CaseReader *r, const CaseNode *node);
hawser_status case_run_read(const CaseReader *r, const CaseNode *node);
hawser_status case_output_read(const CaseReader *r, const CaseNode *node);
/* Places of the chain that are watched. */
hawser_status case_probes_read(const CaseReader *r, const CaseNode *list);
hawser_status case_paper_read(const CaseReader *r, const CaseNode *node);
hawser_status case_theory_read(const CaseReader *r, const CaseNode *node);
hawser_status case_limits_read(const CaseReader *r, const CaseNode *node);

/* Length of the whole chain, m. */
double case_chain_length(const SceneDef *def);
/* Segments of the whole chain; the largest diameter of its cables, m. */
int case_segments(const SceneDef *def);
double case_largest_diameter(const SceneDef *def);
/* The eye: the first segment of the last piece; the number of segments if there is one piece. */
int case_eye(const SceneDef *def);

#endif
