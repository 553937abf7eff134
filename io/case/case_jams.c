#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/case/case_parts.h"

/* What stops in mid-run, when, and when it runs again. */
static const CaseKey jam_keys[] = {
    {"what", KEY_TEXT, .required = 1, AT(JamDef, what)},
    {"at", KEY_NUMBER, DIM_TIME, .otherwise = "by `head_at`", FROM(0, LATE), AT(JamDef, at)},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "by `at`", FROM(0, LONG), AT(JamDef, head_at)},
    {"release", KEY_NUMBER, DIM_TIME, .otherwise = "never", FROM(0, LATE), AT(JamDef, release)},
    {"release_head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "never", FROM(0, LONG), AT(JamDef, release_head_at)},
    {"ramp", KEY_NUMBER, DIM_TIME, .fallback = "100 ms", ABOVE(0, LATE), AT(JamDef, ramp)},
    {"friction", KEY_NUMBER, .otherwise = "0.4; its own if it spins", FROM(0, 10), AT(JamDef, friction)},
};
SECTION(case_jam, "jams.N", jam_keys);

enum { NAMES_SHOWN = 8, NAMES_ROOM = NAMES_SHOWN * (NAME_MAX_LENGTH + 4) };

/* The first of the names that there are, for messages. */
static const char *names_of(const SceneDef *def, char text[NAMES_ROOM])
{
    const char *name = scene_def_can_jam(def, 0);
    if (!name) return "there is nothing that can jam";
    size_t n = (size_t)snprintf(text, NAMES_ROOM, "there is ");
    for (int i = 0; i < NAMES_SHOWN && (name = scene_def_can_jam(def, i)) != NULL; i++)
        n += (size_t)snprintf(text + n, NAMES_ROOM - n, "%s'%s'", i ? ", " : "", name);
    if (scene_def_can_jam(def, NAMES_SHOWN)) snprintf(text + n, NAMES_ROOM - n, ", ...");
    return text;
}

/* One thing has the name, and nothing else; only a roller drags when it stands. */
static hawser_status what_check(const CaseReader *r, const CaseNode *node, const JamDef *jam)
{
    const CaseNode *const what = case_node_key(node, "what"), *const friction = case_node_key(node, "friction");
    const char *name;
    char names[NAMES_ROOM];
    int found = 0, roller = 0;
    for (int i = 0; (name = scene_def_can_jam(r->def, i)) != NULL; i++) {
        if (strcmp(name, jam->what) != 0) continue;
        roller = i < r->def->n_rollers;
        ++found;
    }
    if (found == 0) {
        return case_value_error(r->err, what, " is not the name of anything that can jam: %s", names_of(r->def, names));
    }
    if (found > 1) return case_value_error(r->err, what, " is the name of %d things that can jam: rename them", found);
    if (friction && !roller) return case_key_error(r->err, friction, NULL, "not allowed: it is a roller's");
    for (const JamDef *before = r->def->jams; before < jam; before++) {
        if (strcmp(before->what, jam->what) != 0) continue;
        return case_value_error(r->err, what, " jams already: a thing can jam once in a run");
    }
    return HAWSER_OK;
}

/* One of a time and a place of the front. */
static hawser_status either_check(const CaseReader *r, const CaseNode *node, const char *time, const char *place)
{
    const CaseNode *const both = case_node_key(node, place);
    if (!case_node_key(node, time) || !both) return HAWSER_OK;
    return case_key_error(r->err, both, NULL, "not allowed beside '%s'", time);
}

/* The front is not yet where the jam begins, and a release comes after the jam. */
static hawser_status order_check(const CaseReader *r, const CaseNode *node, const JamDef *jam)
{
    if (isnan(jam->at) && isnan(jam->head_at)) {
        return case_key_error(r->err, node, "at", "missing: give it, or 'head_at'");
    }
    if (jam->head_at <= r->def->head_at) {
        return case_value_error(r->err, case_node_key(node, "head_at"),
                                " is out of range: must be above 'route.head_at', %g m", r->def->head_at);
    }
    if (jam->release < jam->at + jam->ramp) {
        return case_value_error(r->err, case_node_key(node, "release"),
                                " is out of range: must be at least 'at' and the ramp, %g s", jam->at + jam->ramp);
    }
    const double front = isnan(jam->head_at) ? r->def->head_at : jam->head_at;
    if (jam->release_head_at <= front) {
        return case_value_error(r->err, case_node_key(node, "release_head_at"),
                                " is out of range: must be above %g m, where the front is before", front);
    }
    return HAWSER_OK;
}

static hawser_status jam_read(const CaseReader *r, const CaseNode *node, void *item)
{
    JamDef *const jam = item;
    hawser_status status = case_section_read(r, node, &case_jam, jam);
    if (!status) status = what_check(r, node, jam);
    if (!status) status = either_check(r, node, "at", "head_at");
    if (!status) status = either_check(r, node, "release", "release_head_at");
    return status ? status : order_check(r, node, jam);
}

hawser_status case_jams_read(CaseReader *r, const CaseNode *list)
{
    return case_list_read(r, list, sizeof *r->def->jams, jam_read, &r->def->jams, &r->def->n_jams);
}
