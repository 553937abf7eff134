#include "io/schema/case_schema.h"

#include "io/schema/case_records.h"
#include "io/schema/case_rows.h"

/* In the order of the enumerations that they stand for. */
const char *const case_ramps[] = {"none", "step", "step5", NULL};
static const char *const analyses[] = {"dynamics", "static", "modes", NULL};
static const char *const frames[] = {"symmetric", "adams", NULL};
static const char *const weights[] = {"full", "carried", NULL};
static const char *const geometries[] = {"smooth", "cylinder", NULL};
static const char *const places[] = {"centred", "resting", NULL};
static const char *const tray_sections[] = {"flat", "v", "u", NULL};
static const char *const grips[] = {"clamp", "axial", NULL};
static const char *const afters[] = {"stay", "end", NULL};
static const char *const planar_choices[] = {"auto", "on", "off", NULL};
static const char *const reels[] = {"payout", "weight", "contact", NULL};
static const char *const ends[] = {"free", "fixed", NULL};
static const char *const brakes[] = {"constant", "proportional", "speed", NULL};
static const char *const solvers[] = {"auto", "block", "bordered", "klu", "klu-full", "band", "dense", NULL};
static const char *const profiles[] = {"flat", "v", "u", NULL};
static const char *const guides[] = {"none", "inside", "both", NULL};
static const char *const orderings[] = {"auto", "amd", "colamd", "metis", NULL};

/* The whole case: its title, and the sections below. */
static const CaseKey top_keys[] = {
    {"title", KEY_TEXT, .fallback = "", AT(TopRecord, title)},
    {"gravity", KEY_ANY, .otherwise = "9.81 m/s2", .form = "an acceleration downward, or [x, y, z]", FROM(0, 1e3),
     .dimension = DIM_ACCELERATION, AT(TopRecord, gravity)},
    {"frame", KEY_CHOICE, .fallback = "symmetric", .choices = frames, AT(TopRecord, frame)},
    {"cables", KEY_MAP, .required = 1, .form = "a name and its properties for each kind of cable",
     AT(TopRecord, cables)},
    {"chain", KEY_LIST, .required = 1, .form = "the pieces, from the tail to the winch", AT(TopRecord, chain)},
    {"route", KEY_MAP, .otherwise = "none: it is needed without a `rod`", .form = "section `route`",
     AT(TopRecord, route)},
    {"rod", KEY_MAP, .otherwise = "none", .form = "section `rod`", AT(TopRecord, rod)},
    {"lead_in", KEY_MAP, .otherwise = "none", .form = "section `lead_in`", AT(TopRecord, lead_in)},
    {"reel", KEY_MAP, .otherwise = "none", .form = "section `reel`", AT(TopRecord, reel)},
    {"rollers", KEY_MAP, .otherwise = "none", .form = "section `rollers`", AT(TopRecord, rollers)},
    {"surfaces", KEY_MAP, .otherwise = "none", .form = "section `surfaces`", AT(TopRecord, surfaces)},
    {"contact", KEY_MAP, .otherwise = "its defaults", .form = "section `contact`", AT(TopRecord, contact)},
    {"friction", KEY_MAP, .otherwise = "its defaults", .form = "section `friction`", AT(TopRecord, friction)},
    {"drive", KEY_MAP, .otherwise = "none", .form = "section `drive`", AT(TopRecord, drive)},
    {"conveyors", KEY_LIST, .otherwise = "none", .form = "conveyors one by one", AT(TopRecord, conveyors)},
    {"run", KEY_MAP, .required = 1, .form = "section `run`", AT(TopRecord, run)},
    {"solver", KEY_MAP, .otherwise = "its defaults", .form = "section `solver`", AT(TopRecord, solver)},
    {"output", KEY_MAP, .otherwise = "its defaults", .form = "section `output`", AT(TopRecord, output)},
    {"paper", KEY_MAP, .otherwise = "from the route", .form = "section `paper`", AT(TopRecord, paper)},
    {"theory", KEY_MAP, .otherwise = "its defaults", .form = "section `theory`", AT(TopRecord, theory)},
    {"limits", KEY_MAP, .otherwise = "nothing is judged", .form = "section `limits`", AT(TopRecord, limits)},
};
SECTION(case_top, "", top_keys);

/* By component, on top of the cable's damping time. */
static const CaseKey damping_factor_keys[] = {
    {"axial", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(FactorRecord, axial)},
    {"shear", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(FactorRecord, shear)},
    {"torsion", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(FactorRecord, torsion)},
    {"bending", KEY_NUMBER, .fallback = "1", FROM(0, 1e6), AT(FactorRecord, bending)},
};
SECTION(case_damping_factor, "cables.NAME.damping_factor", damping_factor_keys);

/* In place of time and factor, component by component. */
static const CaseKey damping_ratio_keys[] = {
    {"axial", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(RatioRecord, axial)},
    {"shear", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(RatioRecord, shear)},
    {"torsion", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(RatioRecord, torsion)},
    {"bending", KEY_NUMBER, .otherwise = "by `damping`", FROM(0, 10), AT(RatioRecord, bending)},
    {"at", KEY_NUMBER, DIM_FREQUENCY, .otherwise = "each joint's own mode", ABOVE(0, 1e6), AT(RatioRecord, at)},
};
SECTION(case_damping_ratio, "cables.NAME.damping_ratio", damping_ratio_keys);

static const CaseKey preload_keys[] = {
    {"axial", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(PreloadRecord, axial)},
    {"shear_y", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(PreloadRecord, shear_y)},
    {"shear_z", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(-STIFF, STIFF), AT(PreloadRecord, shear_z)},
    {"torsion", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(PreloadRecord, torsion)},
    {"bending_y", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(PreloadRecord, bending_y)},
    {"bending_z", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(-STIFF, STIFF), AT(PreloadRecord, bending_z)},
};
SECTION(case_preload, "cables.NAME.preload", preload_keys);

/* Rows and their order are checked in case_bending.c. */
static const CaseKey bending_keys[] = {
    {"table", KEY_LIST, .otherwise = "none: it is needed",
     .form = "2 to 8 rows [curvature, moment], bent for the first time", AT(BendingRecord, table)},
};
SECTION(case_bending, "cables.NAME.bending", bending_keys);

/* A rigidity has no default of its own: case_cables.c takes it from the shorthand, eq. 2 of the paper. */
static const CaseKey cable_keys[] = {
    {"d", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, 100), AT(CableRecord, d)},
    {"E", KEY_NUMBER, DIM_PRESSURE, .otherwise = "none", ABOVE(0, STIFF), AT(CableRecord, E)},
    {"G", KEY_NUMBER, DIM_PRESSURE, .otherwise = "none", ABOVE(0, STIFF), AT(CableRecord, G)},
    {"A", KEY_NUMBER, DIM_AREA, .otherwise = "none", ABOVE(0, 1e4), AT(CableRecord, A)},
    {"density", KEY_NUMBER, DIM_DENSITY, .otherwise = "none", ABOVE(0, 1e6), AT(CableRecord, density)},
    {"EA", KEY_NUMBER, DIM_FORCE, .otherwise = "E A", ABOVE(0, STIFF), AT(CableRecord, EA)},
    {"GA", KEY_NUMBER, DIM_FORCE, .otherwise = "G A", ABOVE(0, STIFF), AT(CableRecord, GA)},
    {"GJ", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "G pi d^4/32", ABOVE(0, STIFF), AT(CableRecord, GJ)},
    {"EI", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "E pi d^4/64", ABOVE(0, STIFF), AT(CableRecord, EI)},
    {"EI_y", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "EI", ABOVE(0, STIFF), AT(CableRecord, EI_y)},
    {"EI_z", KEY_NUMBER, DIM_RIGIDITY, .otherwise = "EI", ABOVE(0, STIFF), AT(CableRecord, EI_z)},
    {"mass", KEY_NUMBER, DIM_LINE_MASS, .otherwise = "density A", ABOVE(0, 1e6), AT(CableRecord, mass)},
    {"damping", KEY_NUMBER, DIM_TIME, .fallback = "1 ms", FROM(0, 1e3), AT(CableRecord, damping)},
    {"damping_factor", KEY_SECTION, .otherwise = "its defaults", .section = &case_damping_factor,
     AT(CableRecord, factor)},
    {"damping_ratio", KEY_SECTION, .otherwise = "none", .section = &case_damping_ratio, AT(CableRecord, ratio)},
    {"preload", KEY_SECTION, .otherwise = "its defaults", .section = &case_preload, AT(CableRecord, preload)},
    {"bending", KEY_SECTION, .otherwise = "elastic, by EI", .section = &case_bending, AT(CableRecord, bending)},
};
SECTION(case_cable, "cables.NAME", cable_keys);

/* Pieces follow each other from the tail to the winch. */
static const CaseKey chain_piece_keys[] = {
    {"cable", KEY_TEXT, .required = 1, AT(PieceRecord, cable)},
    {"length", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(PieceRecord, length)},
    {"segment", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(PieceRecord, segment)},
    {"swivel", KEY_FLAG, .fallback = "false", AT(PieceRecord, swivel)},
};
SECTION(case_chain_piece, "chain.N", chain_piece_keys);

/* Where the route begins and what it is made of. */
static const CaseKey route_keys[] = {
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-LONG, LONG), AT(RouteRecord, start)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)),
     AT(RouteRecord, heading)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-89), DEGREES(89)), AT(RouteRecord, slope)},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(RouteRecord, head_at)},
    {"pieces", KEY_LIST, .required = 1, .form = "straights and bends, end to end", AT(RouteRecord, pieces)},
};
SECTION(case_route, "route", route_keys);

/* Which keys belong to straights and which to bends is checked in case_route.c. */
static const CaseKey route_piece_keys[] = {
    {"straight", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a bend", ABOVE(0, LONG), AT(RoutePieceRecord, straight)},
    {"bend", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is a straight", ABOVE(0, DEGREES(360)),
     AT(RoutePieceRecord, bend)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: bends need it", ABOVE(0, LONG),
     AT(RoutePieceRecord, radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "none: bends need it",
     .form = "`up`, `down`, `left`, `right` or an angle", FROM(DEGREES(-360), DEGREES(360)),
     AT(RoutePieceRecord, plane)},
    {"name", KEY_TEXT, .fallback = "", AT(RoutePieceRecord, name)},
};
SECTION(case_route_piece, "route.pieces.N", route_piece_keys);

/* The section's being there is what makes a lead-in. */
static const CaseKey lead_in_keys[] = {
    {"weight", KEY_CHOICE, .fallback = "carried", .choices = weights, AT(LeadInRecord, weight)},
    {"blend", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(LeadInRecord, blend)},
};
SECTION(case_lead_in, "lead_in", lead_in_keys);

/* Rows along the route, and single ones. */
static const CaseKey rollers_keys[] = {
    {"along", KEY_ANY, .otherwise = "none", .form = "a row of rollers, or a list of rows", AT(RollersRecord, along)},
    {"list", KEY_LIST, .otherwise = "none", .form = "rollers one by one", AT(RollersRecord, list)},
};
SECTION(case_rollers, "rollers", rollers_keys);

/* Which belongs to which profile, and how they go with the cable, is checked in case_groove.c. */
static const CaseKey groove_keys[] = {
    {"angle", KEY_NUMBER, DIM_ANGLE, .otherwise = "90 deg", FROM(DEGREES(20), DEGREES(170)), AT(GrooveRecord, angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "1.25 times the thickest cable's", ABOVE(0, 1e3),
     AT(GrooveRecord, radius)},
    {"depth", KEY_NUMBER, DIM_LENGTH, .otherwise = "`v`: the thickest cable's diameter, `u`: the groove's radius",
     ABOVE(0, 1e3), AT(GrooveRecord, depth)},
};
SECTION(case_groove, "rollers.along.groove", groove_keys);

/* A plain bush on a steel pin, greased; sim/equipment/moving_rollers.h. */
static const CaseKey bearing_keys[] = {
    {"friction", KEY_NUMBER, .fallback = "0.1", FROM(0, 10), AT(BearingRecord, friction)},
    {"journal", KEY_NUMBER, DIM_LENGTH, .fallback = "10 mm", ABOVE(0, 1e3), AT(BearingRecord, journal)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, 1e9), AT(BearingRecord, torque)},
    {"speed", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0.01 rad/s", ABOVE(0, 1e6), AT(BearingRecord, speed)},
};
SECTION(case_bearing, "rollers.along.spin.bearing", bearing_keys);

static const CaseKey spin_keys[] = {
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(SpinRecord, inertia)},
    {"bearing", KEY_SECTION, .otherwise = "its defaults", .section = &case_bearing, AT(SpinRecord, bearing)},
};
SECTION(case_spin, "rollers.along.spin", spin_keys);

/* The stiffnesses' dimensions and range are in case_mount.c. */
static const CaseKey mount_keys[] = {
    {"stiffness", KEY_LIST, .required = 1, .form = "six: along the axis, along the route, up, about each of these",
     AT(MountRecord, stiffness)},
    {"damping", KEY_NUMBER, DIM_TIME, .fallback = "1 ms", FROM(0, 1e3), AT(MountRecord, damping)},
    {"mass", KEY_NUMBER, DIM_MASS, .required = 1, ABOVE(0, 1e9), AT(MountRecord, mass)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .required = 1, ABOVE(0, 1e9), AT(MountRecord, inertia)},
};
SECTION(case_mount, "rollers.along.mount", mount_keys);

/* A count of 0 means that the spacing decides. */
static const CaseKey roller_row_keys[] = {
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(RollerRowRecord, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(-LONG, LONG), AT(RollerRowRecord, to)},
    {"count", KEY_INTEGER, .fallback = "0", FROM(0, 100000), AT(RollerRowRecord, count)},
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "from `count`", ABOVE(0, LONG), AT(RollerRowRecord, spacing)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 1e3), AT(RollerRowRecord, radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(RollerRowRecord, width)},
    {"where", KEY_ANY, DIM_LENGTH, .otherwise = "`all`", .form = "`all`, `bends`, `straights` or a list of [from, to]",
     FROM(-LONG, LONG), AT(RollerRowRecord, where)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(RollerRowRecord, profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(RollerRowRecord, groove)},
    {"guide", KEY_CHOICE, .fallback = "none", .choices = guides, AT(RollerRowRecord, guide)},
    {"gap", KEY_NUMBER, DIM_LENGTH, .fallback = "0 mm", FROM(0, 1e3), AT(RollerRowRecord, gap)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(RollerRowRecord, rating)},
    {"hold_down", KEY_ANY, DIM_LENGTH, .otherwise = "`none`", .form = "`none`, `sag` or a list of [from, to]",
     FROM(-LONG, LONG), AT(RollerRowRecord, hold_down)},
    {"friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`", AT(RollerRowRecord, friction)},
    {"spin", KEY_MAP, .otherwise = "does not spin", .form = "section `rollers.along.spin`", AT(RollerRowRecord, spin)},
    {"mount", KEY_MAP, .otherwise = "fixed", .form = "section `rollers.along.mount`", AT(RollerRowRecord, mount)},
    {"name", KEY_TEXT, .fallback = "R", AT(RollerRowRecord, name)},
};
SECTION(case_roller_row, "rollers.along", roller_row_keys);

/* By coordinates: nothing is known of the route. */
static const CaseKey roller_keys[] = {
    {"centre", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-LONG, LONG), AT(RollerRecord, centre)},
    {"axis", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(RollerRecord, axis)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 1e3), AT(RollerRecord, radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(RollerRecord, width)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(RollerRecord, profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(RollerRecord, groove)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(RollerRecord, rating)},
    {"friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`", AT(RollerRecord, friction)},
    {"spin", KEY_MAP, .otherwise = "does not spin", .form = "section `rollers.along.spin`", AT(RollerRecord, spin)},
    {"mount", KEY_MAP, .otherwise = "fixed", .form = "section `rollers.along.mount`", AT(RollerRecord, mount)},
    {"name", KEY_TEXT, .fallback = "", AT(RollerRecord, name)},
};
SECTION(case_roller, "rollers.list.N", roller_keys);

/* What the cable lies on along a length. */
static const CaseKey surfaces_keys[] = {
    {"ducts", KEY_LIST, .otherwise = "none", .form = "ducts one by one", AT(SurfacesRecord, ducts)},
    {"trays", KEY_LIST, .otherwise = "none", .form = "trays, troughs and floors one by one", AT(SurfacesRecord, trays)},
    {"planes", KEY_LIST, .otherwise = "none", .form = "floors and walls one by one", AT(SurfacesRecord, planes)},
    {"contact", KEY_MAP, .otherwise = "as section `contact`", .form = "section `surfaces.contact`",
     AT(SurfacesRecord, contact)},
};
SECTION(case_surfaces, "surfaces", surfaces_keys);

/* No fallbacks: what is absent is the rollers' number. */
static const CaseKey line_contact_keys[] = {
    {"k", KEY_ANY, DIM_STIFFNESS, .otherwise = "the rollers'", .form = "a force per length to the power e",
     ABOVE(0, 1e18), AT(LineContactRecord, k)},
    {"e", KEY_NUMBER, .otherwise = "the rollers'", FROM(1, 5), AT(LineContactRecord, e)},
    {"c", KEY_NUMBER, DIM_DASHPOT, .otherwise = "the rollers'", FROM(0, 1e12), AT(LineContactRecord, c)},
    {"d", KEY_NUMBER, DIM_LENGTH, .otherwise = "the rollers'", ABOVE(0, 1), AT(LineContactRecord, d)},
};
SECTION(case_line_contact, "surfaces.contact", line_contact_keys);

/* Stretches: off the route is an error, which case_surfaces.c finds. */
static const CaseKey duct_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(DuctRecord, at.name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(DuctRecord, at.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(DuctRecord, at.to)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, 1e3), AT(DuctRecord, radius)},
    {"place", KEY_CHOICE, .fallback = "centred", .choices = places, AT(DuctRecord, place)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(DuctRecord, at.fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`", AT(DuctRecord, at.friction)},
};
SECTION(case_duct, "surfaces.ducts.N", duct_keys);

/* Which keys belong to which section is checked in case_surfaces.c. */
static const CaseKey tray_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TrayRecord, at.name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TrayRecord, at.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(TrayRecord, at.to)},
    {"section", KEY_CHOICE, .fallback = "flat", .choices = tray_sections, AT(TrayRecord, section)},
    {"width", KEY_NUMBER, DIM_LENGTH, .otherwise = "400 mm", ABOVE(0, 1e3), AT(TrayRecord, width)},
    {"height", KEY_NUMBER, DIM_LENGTH, .otherwise = "`flat` 0 m, `v` two cable diameters, `u` the radius", FROM(0, 1e3),
     AT(TrayRecord, height)},
    {"angle", KEY_NUMBER, DIM_ANGLE, .otherwise = "90 deg", FROM(DEGREES(10), DEGREES(160)), AT(TrayRecord, angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `u` needs it", ABOVE(0, 1e3), AT(TrayRecord, radius)},
    {"depth", KEY_NUMBER, DIM_LENGTH, .otherwise = "the largest cable's radius", ABOVE(0, 1e3), AT(TrayRecord, depth)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(TrayRecord, at.fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`", AT(TrayRecord, at.friction)},
};
SECTION(case_tray, "surfaces.trays.N", tray_keys);

/* By coordinates. A length or width of 0 has no end. */
static const CaseKey plane_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(PlaneRecord, name)},
    {"point", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-LONG, LONG), AT(PlaneRecord, point)},
    {"normal", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(PlaneRecord, normal)},
    {"along", KEY_POINT, .fallback = "[0, 0, 0]", FROM(-1e6, 1e6), AT(PlaneRecord, along)},
    {"length", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PlaneRecord, length)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PlaneRecord, width)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, LONG), AT(PlaneRecord, fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`", AT(PlaneRecord, friction)},
};
SECTION(case_plane, "surfaces.planes.N", plane_keys);

/* ADAMS' IMPACT; the defaults' reasons are in sim/def/scene_def.c. */
static const CaseKey contact_keys[] = {
    {"geometry", KEY_CHOICE, .fallback = "smooth", .choices = geometries, AT(ContactRecord, geometry)},
    {"k", KEY_ANY, DIM_STIFFNESS, .otherwise = "3.4e8 N/m^1.5", .form = "a force per length to the power e",
     ABOVE(0, 1e18), AT(ContactRecord, k)},
    {"e", KEY_NUMBER, .fallback = "1.5", FROM(1, 5), AT(ContactRecord, e)},
    {"c", KEY_NUMBER, DIM_DASHPOT, .fallback = "10 kN s/m", FROM(0, 1e12), AT(ContactRecord, c)},
    {"d", KEY_NUMBER, DIM_LENGTH, .fallback = "0.1 mm", ABOVE(0, 1), AT(ContactRecord, d)},
    {"reach", KEY_NUMBER, DIM_LENGTH, .fallback = "1 m", ABOVE(0, 1e4), AT(ContactRecord, reach)},
    {"cable_on_cable", KEY_FLAG, .fallback = "false", AT(ContactRecord, cable_on_cable)},
    {"cable_friction", KEY_MAP, .otherwise = "the case's", .form = "section `friction`",
     AT(ContactRecord, cable_friction)},
};
SECTION(case_contact, "contact", contact_keys);

/* No fallbacks: what is absent is the case's own law for a roller, and the default law for the case. */
static const CaseKey friction_keys[] = {
    {"mu", KEY_NUMBER, .otherwise = "0.2", FROM(0, 10), AT(FrictionRecord, mu)},
    {"mu_s", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_s)},
    {"mu_d", KEY_NUMBER, .otherwise = "mu", FROM(0, 10), AT(FrictionRecord, mu_d)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .otherwise = "1 mm/s", ABOVE(0, 1e3), AT(FrictionRecord, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(FrictionRecord, v_d)},
    {"law", KEY_ANY, .otherwise = "`adams`", .form = "`adams` or `stick`", AT(FrictionRecord, law)},
    {"d_s", KEY_NUMBER, DIM_LENGTH, .otherwise = "0.1 mm", ABOVE(0, 1), AT(FrictionRecord, d_s)},
};
SECTION(case_friction, "friction", friction_keys);

/* Each may be absent. */
static const CaseKey drive_keys[] = {
    {"winch", KEY_MAP, .otherwise = "none", .form = "section `drive.winch`", AT(DrivesRecord, winch)},
    {"tail", KEY_MAP, .otherwise = "none", .form = "section `drive.tail`", AT(DrivesRecord, tail)},
    {"rope_drag", KEY_MAP, .otherwise = "none", .form = "section `drive.rope_drag`", AT(DrivesRecord, rope_drag)},
};
SECTION(case_drive, "drive", drive_keys);

static const CaseKey winch_keys[] = {
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "from `table`", FROM(0, 1e4), AT(DriveRecord, value)},
    RAMP_KEYS,
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, speed], times rising", AT(DriveRecord, table)},
    {"grip", KEY_CHOICE, .fallback = "clamp", .choices = grips, AT(WinchRecord, grip)},
    {"take_in", KEY_FLAG, .fallback = "false", AT(WinchRecord, take_in)},
    {"at", KEY_NUMBER, DIM_LENGTH, .otherwise = "where the head lies at the start", FROM(0, LONG), AT(WinchRecord, at)},
    {"tension", KEY_MAP, .otherwise = "none", .form = "section `drive.winch.tension`", AT(WinchRecord, tension)},
    {"trip", KEY_MAP, .otherwise = "none", .form = "section `drive.winch.trip`", AT(WinchRecord, trip)},
};
SECTION(case_winch, "drive.winch", winch_keys);

/* In place of a speed. */
static const CaseKey winch_tension_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "from `table`", FROM(0, STRONG), AT(DriveRecord, value)},
    RAMP_KEYS,
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, force], times rising", AT(DriveRecord, table)},
    {"speed_limit", KEY_NUMBER, DIM_SPEED, .otherwise = "none", ABOVE(0, 1e4), AT(WinchTensionRecord, speed_limit)},
    {"band", KEY_NUMBER, .fallback = "0.05", ABOVE(0, 1), AT(WinchTensionRecord, band)},
    {"drum_mass", KEY_NUMBER, DIM_MASS, .fallback = "0 kg", FROM(0, STRONG), AT(WinchTensionRecord, drum_mass)},
};
SECTION(case_winch_tension, "drive.winch.tension", winch_tension_keys);

/* Either a force or a factor. */
static const CaseKey trip_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .otherwise = "from `factor`", ABOVE(0, STRONG), AT(TripRecord, force)},
    {"factor", KEY_NUMBER, .otherwise = "none", ABOVE(0, 1e3), AT(TripRecord, factor)},
    {"hold", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(TripRecord, hold)},
    {"brake", KEY_NUMBER, DIM_TIME, .fallback = "500 ms", ABOVE(0, LATE), AT(TripRecord, brake)},
    {"restarts", KEY_INTEGER, .fallback = "0", FROM(0, 1000), AT(TripRecord, restarts)},
    {"pause", KEY_NUMBER, DIM_TIME, .fallback = "5 s", FROM(0, LATE), AT(TripRecord, pause)},
    {"ramp", KEY_NUMBER, DIM_TIME, .fallback = "2 s", ABOVE(0, LATE), AT(TripRecord, ramp)},
    {"then", KEY_CHOICE, .fallback = "stay", .choices = afters, AT(TripRecord, then)},
};
SECTION(case_trip, "drive.winch.trip", trip_keys);

static const CaseKey tail_keys[] = {
    {"tension", KEY_NUMBER, DIM_FORCE, .otherwise = "from `table`", FROM(0, STRONG), AT(DriveRecord, value)},
    RAMP_KEYS,
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, tension], times rising", AT(DriveRecord, table)},
};
SECTION(case_tail, "drive.tail", tail_keys);

/* Which keys belong to which model is checked in case_reel.c. */
static const CaseKey reel_keys[] = {
    {"model", KEY_CHOICE, .fallback = "payout", .choices = reels, AT(ReelRecord, model)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `weight` needs it", FROM(0, LONG), AT(ReelRecord, length)},
    RAMP_KEYS,
    {"distance", KEY_NUMBER, DIM_LENGTH, .otherwise = "5 m", ABOVE(0, LONG), AT(ReelRecord, distance)},
    {"barrel", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3), AT(ReelRecord, barrel)},
    {"flange", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3), AT(ReelRecord, flange)},
    {"width", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3), AT(ReelRecord, width)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .otherwise = "none: a drum needs it", ABOVE(0, STRONG),
     AT(ReelRecord, inertia)},
    {"bearing", KEY_NUMBER, DIM_MOMENT, .otherwise = "0 N m", FROM(0, STRONG), AT(ReelRecord, bearing)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .otherwise = "1 mm/s", ABOVE(0, 1e3), AT(ReelRecord, v_s)},
    {"end", KEY_CHOICE, .fallback = "free", .choices = ends, AT(ReelRecord, end)},
    {"brake", KEY_MAP, .otherwise = "none", .form = "section `reel.brake`", AT(ReelRecord, brake)},
    {"back_tension", KEY_MAP, .otherwise = "none", .form = "section `reel.back_tension`", AT(ReelRecord, back_tension)},
};
SECTION(case_reel, "reel", reel_keys);

/* A speed is needed by two of the three. */
static const CaseKey brake_keys[] = {
    {"law", KEY_CHOICE, .fallback = "constant", .choices = brakes, AT(BrakeRecord, law)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .required = 1, FROM(0, STRONG), AT(BrakeRecord, torque)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "none: `proportional` and `speed` need it", ABOVE(0, 1e4),
     AT(DriveRecord, value)},
    RAMP_KEYS,
    {"over", KEY_NUMBER, DIM_SPEED, .fallback = "10 mm/s", ABOVE(0, 1e3), AT(BrakeRecord, over)},
};
SECTION(case_brake, "reel.brake", brake_keys);
SECTION(case_back_tension, "reel.back_tension", tail_keys);

/* The force alone is needed; the rest is the friction law's shape. */
static const CaseKey rope_drag_keys[] = {
    {"force", KEY_NUMBER, DIM_FORCE, .required = 1, FROM(0, STRONG), AT(DragRecord, force)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "1 mm/s", ABOVE(0, 1e3), AT(DragRecord, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(DragRecord, v_d)},
    {"ratio", KEY_NUMBER, .fallback = "1", FROM(0, 1), AT(DragRecord, ratio)},
};
SECTION(case_rope_drag, "drive.rope_drag", rope_drag_keys);

/* Straight machines along the route. */
static const CaseKey conveyor_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(ConveyorRecord, name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ConveyorRecord, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(ConveyorRecord, to)},
    {"clamp", KEY_NUMBER, DIM_FORCE, .required = 1, FROM(0, STRONG), AT(ConveyorRecord, clamp)},
    {"mu", KEY_NUMBER, .fallback = "0.3", FROM(0, 10), AT(ConveyorRecord, mu)},
    {"limit", KEY_NUMBER, DIM_FORCE, .otherwise = "none", ABOVE(0, STRONG), AT(ConveyorRecord, limit)},
    {"belt", KEY_MAP, .otherwise = "the winch's speed times `factor`", .form = "section `conveyors.N.belt`",
     AT(ConveyorRecord, belt)},
    {"factor", KEY_NUMBER, .fallback = "1", ABOVE(0, 100), AT(ConveyorRecord, factor)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "0.1 mm/s", ABOVE(0, 1e3), AT(ConveyorRecord, v_s)},
    {"v_d", KEY_NUMBER, DIM_SPEED, .otherwise = "2 v_s", ABOVE(0, 1e3), AT(ConveyorRecord, v_d)},
    {"ratio", KEY_NUMBER, .fallback = "1", FROM(0, 1), AT(ConveyorRecord, ratio)},
    {"edge", KEY_NUMBER, DIM_LENGTH, .fallback = "200 mm", ABOVE(0, 1e3), AT(ConveyorRecord, edge)},
    {"hold", KEY_FLAG, .fallback = "true", AT(ConveyorRecord, hold)},
};
SECTION(case_conveyor, "conveyors.N", conveyor_keys);

static const CaseKey belt_keys[] = {
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "from `table`", FROM(0, 1e4), AT(DriveRecord, value)},
    RAMP_KEYS,
    {"table", KEY_LIST, .otherwise = "none", .form = "[time, speed], times rising", AT(DriveRecord, table)},
};
SECTION(case_belt, "conveyors.N.belt", belt_keys);

/* What belongs to which analysis is checked in case_run.c. */
static const CaseKey run_keys[] = {
    {"analysis", KEY_CHOICE, .fallback = "dynamics", .choices = analyses, AT(RunRecord, analysis)},
    {"duration", KEY_NUMBER, DIM_TIME, .otherwise = "`dynamics` needs it; others 1 s", ABOVE(0, LATE),
     AT(RunRecord, duration)},
    {"load_steps", KEY_INTEGER, .fallback = "10", FROM(1, 100000), AT(RunRecord, load_steps)},
    {"tolerance", KEY_NUMBER, .fallback = "1e-10", ABOVE(0, 0.1), AT(RunRecord, tolerance)},
    {"modes", KEY_INTEGER, .fallback = "6", FROM(1, 200), AT(RunRecord, modes)},
    {"steady_from", KEY_NUMBER, DIM_TIME, .otherwise = "half the duration", FROM(0, LATE), AT(RunRecord, steady_from)},
};
SECTION(case_run, "run", run_keys);

/* 0 leaves a tolerance to the accuracy and the scene's scales. */
static const CaseKey tolerances_keys[] = {
    {"position", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, 1), AT(SolverDef, atol_position)},
    {"rotation", KEY_NUMBER, DIM_ANGLE, .fallback = "0 rad", FROM(0, DEGREES(60)), AT(SolverDef, atol_rotation)},
    {"velocity", KEY_NUMBER, DIM_SPEED, .fallback = "0 m/s", FROM(0, 1e3), AT(SolverDef, atol_velocity)},
    {"omega", KEY_NUMBER, DIM_ANGULAR_SPEED, .fallback = "0 rad/s", FROM(0, 1e3), AT(SolverDef, atol_omega)},
};
SECTION(case_tolerances, "solver.tolerances", tolerances_keys);

/* Straight into SolverDef. */
static const CaseKey solver_keys[] = {
    {"accuracy", KEY_NUMBER, .fallback = "1e-3", FROM(1e-12, 0.1), AT(SolverDef, accuracy)},
    {"tolerances", KEY_SECTION, .otherwise = "from `accuracy`", .section = &case_tolerances, .size = sizeof(SolverDef)},
    {"max_order", KEY_INTEGER, .fallback = "2", FROM(1, 5), AT(SolverDef, max_order)},
    {"max_step", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(SolverDef, max_step)},
    {"first_step", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), AT(SolverDef, first_step)},
    {"max_steps", KEY_INTEGER, .fallback = "0", FROM(0, 1e12), AT(SolverDef, max_steps)},
    {"linear_solver", KEY_CHOICE, .fallback = "auto", .choices = solvers, AT(SolverDef, linear.kind)},
    {"ordering", KEY_CHOICE, .fallback = "auto", .choices = orderings, AT(SolverDef, linear.ordering)},
    {"threads", KEY_INTEGER, .fallback = "1", FROM(1, 2), AT(SolverDef, threads)},
    {"planar", KEY_CHOICE, .fallback = "auto", .choices = planar_choices, AT(SolverDef, planar)},
    {"relax", KEY_FLAG, .fallback = "true", AT(SolverDef, relax)},
    {"relax_tolerance", KEY_NUMBER, .fallback = "1e-6", ABOVE(0, 1), AT(SolverDef, relax_tolerance)},
    {"relax_iterations", KEY_INTEGER, .fallback = "200", FROM(0, 1e6), AT(SolverDef, relax_iterations)},
};
SECTION(case_solver, "solver", solver_keys);

/* Straight into OutputDef, but for stations, segments and rollers. */
static const CaseKey output_keys[] = {
    {"interval", KEY_NUMBER, DIM_TIME, .fallback = "50 ms", ABOVE(0, LATE), AT(OutputRecord, interval)},
    {"states", KEY_NUMBER, DIM_TIME, .fallback = "500 ms", FROM(0, LATE), AT(OutputRecord, states)},
    {"stations", KEY_ANY, .otherwise = "every 2 m", .form = "section `output.stations`, or its list alone",
     AT(OutputRecord, stations)},
    {"speeds_of", KEY_LIST, .otherwise = "the first segment, the one behind the eye, the last",
     .form = "numbers of segments, from 0 at the tail", AT(OutputRecord, speeds_of)},
    {"probes", KEY_LIST, .otherwise = "none", .form = "places one by one", AT(OutputRecord, probes)},
    {"rollers_of", KEY_LIST, .otherwise = "none", .form = "names of rollers, as in `rollers.csv`",
     AT(OutputRecord, rollers_of)},
};
SECTION(case_output, "output", output_keys);

/* Both at once are allowed. */
static const CaseKey stations_keys[] = {
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "those of the list alone", ABOVE(0, LONG),
     AT(StationsRecord, spacing)},
    {"list", KEY_LIST, .otherwise = "none", .form = "stations one by one", AT(StationsRecord, list)},
};
SECTION(case_stations, "output.stations", stations_keys);

/* Both keys are needed. */
static const CaseKey station_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(StationRecord, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(StationRecord, at)},
};
SECTION(case_station, "output.stations.list.N", station_keys);

/* The allowances are lengths of cable, as the paper gives them. */
static const CaseKey paper_keys[] = {
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, rope)},
    {"terms", KEY_LIST, .required = 1, .form = "the path's slopes and arcs, end to end", AT(PaperRecord, terms)},
};
SECTION(case_paper, "paper", paper_keys);

/* Which keys belong to slopes and which to arcs is checked in case_output.c. */
static const CaseKey paper_term_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TermRecord, name)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is an arc", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, slope)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: slopes need it", ABOVE(0, LONG), AT(TermRecord, length)},
    {"arc", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a slope", ABOVE(0, LONG), AT(TermRecord, arc)},
    {"from", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, from)},
    {"to", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, to)},
};
SECTION(case_paper_term, "paper.terms.N", paper_term_keys);

/* The order of docs/case-format.md. */
const CaseSection *const *case_sections(void)
{
    static const CaseSection *const all[] = {
        &case_top,          &case_cable,       &case_damping_factor, &case_damping_ratio, &case_preload,
        &case_bending,      &case_chain_piece, &case_route,          &case_route_piece,   &case_rod,
        &case_rod_tail,     &case_rod_head,    &case_rod_motion,     &case_rod_load,      &case_rod_mass,
        &case_lead_in,      &case_rollers,     &case_roller_row,     &case_groove,        &case_spin,
        &case_bearing,      &case_mount,       &case_roller,         &case_surfaces,      &case_duct,
        &case_tray,         &case_plane,       &case_line_contact,   &case_contact,       &case_friction,
        &case_drive,        &case_winch,       &case_winch_tension,  &case_trip,          &case_tail,
        &case_rope_drag,    &case_conveyor,    &case_belt,           &case_reel,          &case_brake,
        &case_back_tension, &case_run,         &case_solver,         &case_tolerances,    &case_output,
        &case_stations,     &case_station,     &case_probe,          &case_paper,         &case_paper_term,
        &case_theory,       &case_limits,      &case_conductor,      &case_sheath,        NULL};
    return all;
}
