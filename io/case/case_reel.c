/* The reel: its keys by model, and whether its cable fits on it and reaches the route. */
#include <math.h>
#include <string.h>

#include "io/case/case_parts.h"
#include "sim/equipment/reel.h"

/* A reel of some model; NAN: not given. */
typedef struct ReelRecord {
    ReelDef reel;
    int model;
    double length; /* model weight, and how its tension comes in */
    Profile back;
} ReelRecord;

static const char *const weights[] = {"full", "carried", NULL};

/* The section's being there is what makes a lead-in. */
static const CaseKey lead_in_keys[] = {
    {"weight", KEY_CHOICE, .fallback = "carried", .choices = weights, AT(LeadInDef, carries_weight)},
    {"blend", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(LeadInDef, blend)},
};
SECTION(case_lead_in, "lead_in", lead_in_keys);

enum { MODEL_PAYOUT, MODEL_WEIGHT, MODEL_CONTACT };
static const char *const models[] = {"payout", "weight", "contact", NULL};
static const char *const ends[] = {"free", "fixed", NULL};
static const char *const brakes[] = {"constant", "proportional", "speed", NULL};

/* A speed is needed by two of the three. */
static const CaseKey brake_keys[] = {
    {"law", KEY_CHOICE, .fallback = "constant", .choices = brakes, AT(ReelDef, brake)},
    {"torque", KEY_NUMBER, DIM_MOMENT, .required = 1, FROM(0, STRONG), AT(ReelDef, torque)},
    {"speed", KEY_NUMBER, DIM_SPEED, .otherwise = "none: `proportional` and `speed` need it", ABOVE(0, 1e4),
     AT(ReelDef, speed.v1)},
    RAMP_KEYS(offsetof(ReelDef, speed), "step"),
    {"over", KEY_NUMBER, DIM_SPEED, .fallback = "10 mm/s", ABOVE(0, 1e3), AT(ReelDef, over)},
};
static SECTION(reel_brake, "reel.brake", brake_keys);

/* Which keys belong to which model the tables below say. */
static const CaseKey reel_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"model", KEY_CHOICE, .fallback = "payout", .choices = models, AT(ReelRecord, model)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `weight` needs it", FROM(0, LONG), AT(ReelRecord, length)},
    RAMP_KEYS(offsetof(ReelRecord, back), "step"),
    {"distance", KEY_NUMBER, DIM_LENGTH, .fallback = "5 m", ABOVE(0, LONG), AT(ReelRecord, reel.distance)},
    {"barrel", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3),
     AT(ReelRecord, reel.barrel)},
    {"flange", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3),
     AT(ReelRecord, reel.flange)},
    {"width", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: a drum needs it", ABOVE(0, 1e3), AT(ReelRecord, reel.width)},
    {"inertia", KEY_NUMBER, DIM_INERTIA, .otherwise = "none: a drum needs it", ABOVE(0, STRONG),
     AT(ReelRecord, reel.inertia)},
    {"bearing", KEY_NUMBER, DIM_MOMENT, .fallback = "0 N m", FROM(0, STRONG), AT(ReelRecord, reel.bearing)},
    {"v_s", KEY_NUMBER, DIM_SPEED, .fallback = "1 mm/s", ABOVE(0, 1e3), AT(ReelRecord, reel.v_s)},
    {"end", KEY_CHOICE, .fallback = "free", .choices = ends, AT(ReelRecord, reel.end_fixed)},
    {"brake", KEY_MAP, .otherwise = "none", .section = &reel_brake},
    {"back_tension", KEY_MAP, .otherwise = "none", .section = &case_back_tension},
};
SECTION(case_reel, "reel", reel_keys);

/* In the order of the models: keys that a model has not, and those of its own that have no default. */
static const char *const wrong_keys[][12] = {
    {"length", "ramp", "from", "to"},
    {"distance", "barrel", "flange", "width", "inertia", "bearing", "v_s", "end", "brake", "back_tension"},
    {"length", "ramp", "from", "to", "v_s", "end", "back_tension"}};
static const char *const needed_keys[][5] = {
    {"barrel", "flange", "width", "inertia"}, {"length"}, {"barrel", "flange", "width", "inertia"}};

static hawser_status keys_check(const CaseReader *r, const CaseNode *node, int model)
{
    for (int k = 0; wrong_keys[model][k]; ++k) {
        const CaseNode *const other = case_node_key(node, wrong_keys[model][k]);
        if (other) return case_key_error(r->err, other, NULL, "not allowed with 'model: %s'", models[model]);
    }
    for (int k = 0; needed_keys[model][k]; ++k) {
        if (case_node_key(node, needed_keys[model][k])) continue;
        return case_key_error(r->err, node, needed_keys[model][k], "missing: 'model: %s' needs it", models[model]);
    }
    return HAWSER_OK;
}

/* The tail has one tension: whoever sets it. */
static hawser_status tail_check(const CaseReader *r, const CaseNode *node)
{
    if (!case_node_key(case_node_key(r->root, "drive"), "tail")) return HAWSER_OK;
    return case_key_error(r->err, node, NULL, "not allowed beside 'drive.tail': both set the tension at the tail");
}

/* The paper's reel: the weight of a length of cable as tension at the tail (its eq. 3), of what is at the tail. */
static hawser_status weight_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    SceneDef *const def = r->def;
    const hawser_status status = tail_check(r, node);
    if (status) return status;
    def->tail.tension = record->back;
    def->tail.tension.v1 = record->length * def->cables[def->pieces[0].cable].mass * v3_norm(def->gravity);
    return case_profile_read(r, node, &case_reel, "length", &def->tail.tension);
}

static hawser_status brake_read(const CaseReader *r, const CaseNode *node)
{
    ReelDef *const reel = &r->def->reel;
    const CaseNode *const speed = case_node_key(node, "speed");
    const hawser_status status = case_section_read(r, node, &reel_brake, reel);
    if (status) return status;
    if (reel->brake == BRAKE_CONSTANT) {
        reel->speed.v1 = 0; /* none */
        return speed ? case_key_error(r->err, speed, NULL, "not allowed with 'law: constant'") : HAWSER_OK;
    }
    if (!speed) return case_key_error(r->err, node, "speed", "missing: this law of the brake needs it");
    reel->at_speed = reel->speed.v1;
    return case_profile_read(r, node, &reel_brake, "speed", &reel->speed);
}

/* Cable and rope up to the eye: what the reel may hold, and what of it is wound at the start, m. */
static double wound_at_start(const SceneDef *def)
{
    double length = -def->head_at - def->reel.distance;
    for (int p = 0; p < scene_def_eye(def); ++p) length += def->pieces[p].length;
    return length;
}

/* The cable lies on the drum in layers of one pitch. */
static hawser_status one_kind_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    double left = wound_at_start(def);
    for (int p = 0; p < def->n_pieces && left > 0; ++p) {
        if (def->pieces[p].cable != def->pieces[0].cable) {
            return case_key_error(
                r->err, node, NULL,
                "the reel would hold two kinds of cable, '%s' and '%s', at the start: it can hold one",
                def->cables[def->pieces[0].cable].name, def->cables[def->pieces[p].cable].name);
        }
        left -= def->pieces[p].length;
    }
    return HAWSER_OK;
}

/* The drum holds the cable: turns between the flanges, layers below their edge. */
static hawser_status fit_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const ReelDef *const reel = &def->reel;
    const CableDef *const cable = &def->cables[def->pieces[0].cable];
    const Winding winding = {
        .barrel = reel->barrel / 2, .pitch = cable->diameter, .turns = winding_turns(reel->width, cable->diameter)};
    if (reel->flange <= reel->barrel) {
        return case_value_error(r->err, case_node_key(node, "flange"), " is out of range: must be above 'barrel', %g m",
                                reel->barrel);
    }
    if (winding.turns < 1) {
        return case_value_error(r->err, case_node_key(node, "width"),
                                " is out of range: must be the cable's diameter at least, %g m", cable->diameter);
    }
    const double room = winding_capacity(&winding, reel->flange / 2), wound = wound_at_start(def);
    if (wound <= room) return HAWSER_OK;
    return case_key_error(
        r->err, node, NULL,
        "more cable than fits: %.6g m are wound at the start, the reel holds %.6g m (%.0f turns a layer "
        "of %.4g m cable, whole layers below the flange)",
        wound, room, winding.turns, cable->diameter);
}

/* Off the drum the cable reaches the head's place, and what leaves it has become cable before the weight comes in. */
static hawser_status reach_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const double least = 2 * case_longest_segment(def) + def->lead_in.blend / 2, wound = wound_at_start(def);
    if (def->reel.distance <= least) {
        const CaseNode *const value = case_node_key(node, "distance");
        return case_key_error(r->err, value ? value : node, value ? NULL : "distance",
                              "%g m is out of range: must be above %g m, two segments and half of 'lead_in.blend'",
                              def->reel.distance, least);
    }
    if (wound >= -1e-9) return HAWSER_OK;
    return case_key_error(
        r->err, node, NULL,
        "the cable does not reach the reel: from there to its front at 'route.head_at' it takes %.6g m "
        "more",
        -wound);
}

static hawser_status payout_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    r->def->reel = record->reel;
    r->def->reel.model = REEL_PAYOUT;
    r->def->lead_in.present = 1; /* the cable leaves the drum on it */
    const CaseNode *const brake = case_node_key(node, "brake"), *const back = case_node_key(node, "back_tension");
    hawser_status status = brake ? brake_read(r, brake) : HAWSER_OK;
    if (!status) status = tail_check(r, node);
    if (!status && back) status = case_tail_read(r, back, &case_back_tension);
    if (!status) status = fit_check(r, node);
    if (!status) status = one_kind_check(r, node);
    return status ? status : reach_check(r, node);
}

/* Every turn touches the drum, and its neighbours: the capsules' geometry has a contact a segment, the smooth line one
 * a passage only. */
static hawser_status drum_contact_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const CaseNode *const contact = case_node_key(r->root, "contact");
    if (!def->cable_on_cable) {
        return case_key_error(r->err, contact ? contact : node, contact ? "cable_on_cable" : NULL,
                              "a reel with 'model: contact' needs 'contact.cable_on_cable: true'");
    }
    if (def->geometry != GEOMETRY_CYLINDER) {
        return case_key_error(r->err, contact, "geometry",
                              "a reel with 'model: contact' needs 'contact.geometry: cylinder'");
    }
    return HAWSER_OK;
}

/* A drum that is touched; whether the cable fits is said when it is laid (sim/equipment/drum.c). */
static hawser_status contact_read(const CaseReader *r, const CaseNode *node, const ReelRecord *record)
{
    SceneDef *const def = r->def;
    const CaseNode *const brake = case_node_key(node, "brake");
    hawser_status status = brake ? brake_read(r, brake) : HAWSER_OK;
    if (!status && brake && def->reel.brake != BRAKE_CONSTANT) {
        status = case_key_error(r->err, case_node_key(brake, "law"), NULL,
                                "a reel with 'model: contact' has a brake with 'law: constant' only");
    }
    const CaseNode *const solver = case_node_key(r->root, "solver"), *const relax = case_node_key(solver, "relax");
    if (!status && !(relax && relax->kind == NODE_TEXT && strcmp(relax->text, "false") == 0)) {
        status = case_key_error(r->err, solver ? solver : node, solver ? "relax" : NULL,
                                "a reel with 'model: contact' needs 'solver.relax: false': without friction the cable "
                                "would slip off");
    }
    if (!status) status = tail_check(r, node);
    if (!status) status = drum_contact_check(r, node);
    if (!status && case_node_key(r->root, "lead_in")) {
        status = case_key_error(r->err, case_node_key(r->root, "lead_in"), NULL,
                                "not allowed beside a reel with 'model: contact'");
    }
    const ReelDef *const reel = &record->reel;
    def->drum = (DrumDef){.present = 1,
                          .distance = reel->distance,
                          .barrel = reel->barrel,
                          .flange = reel->flange,
                          .width = reel->width,
                          .inertia = reel->inertia,
                          .torque = reel->bearing + def->reel.torque};
    def->reel.torque = 0;
    return status;
}

/* A case without a reel has a bare tail. */
hawser_status case_reel_read(CaseReader *r, const CaseNode *node)
{
    ReelRecord record = {.reel = r->def->reel};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_reel, &record);
    if (!status) status = keys_check(r, node, record.model);
    if (status) return status;
    if (record.model == MODEL_CONTACT) return contact_read(r, node, &record);
    return record.model == MODEL_WEIGHT ? weight_read(r, node, &record) : payout_read(r, node, &record);
}

/* Its defaults are read even where there is none, so that the definition is complete. */
hawser_status case_lead_in_read(CaseReader *r, const CaseNode *node)
{
    r->def->lead_in.present = node != NULL;
    return case_section_read(r, node, &case_lead_in, &r->def->lead_in);
}
