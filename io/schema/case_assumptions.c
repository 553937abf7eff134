/* What a case did not say itself: values that came with a `type`, and rigidities that were estimated. They are gathered
 * from the tree once everything else has been read, for those who read the results. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/library/library.h"
#include "io/schema/case_schema.h"

static const char GIVEN[] = "given", CATALOGUE[] = "catalogue", ESTIMATED[] = "estimated", NOT_READ[] = "not read";

/* The list as it grows, and the entries' values that are in it already. */
typedef struct Gathering {
    const CaseReader *r;
    int room;
} Gathering;

/* One more; NULL without memory. */
static hawser_assumption *assumption_add(Gathering *g, const char *key, const char *value, const char *origin)
{
    SceneDef *const def = g->r->def;
    if (def->n_assumptions == g->room) {
        const int room = g->room ? 2 * g->room : 32;
        hawser_assumption *const all = realloc(def->assumptions, (size_t)room * sizeof *all);
        if (!all) return NULL;
        def->assumptions = all;
        g->room = room;
    }
    hawser_assumption *const a = &def->assumptions[def->n_assumptions++];
    *a = (hawser_assumption){.origin = origin};
    snprintf(a->key, sizeof a->key, "%.*s", (int)sizeof a->key - 1, key);
    snprintf(a->value, sizeof a->value, "%.*s", (int)sizeof a->value - 1, value);
    return a;
}

/* Whether the list has the same key of the same entry already, at another roller or duct. */
static int is_repeated(const Gathering *g, const char *leaf, const char *source)
{
    const SceneDef *const def = g->r->def;
    for (int i = 0; i < def->n_assumptions; i++) {
        const hawser_assumption *const a = &def->assumptions[i];
        const char *const dot = strrchr(a->key, '.');
        if (a->origin == CATALOGUE && dot && strcmp(dot + 1, leaf) == 0 && strcmp(a->source, source) == 0) return 1;
    }
    return 0;
}

/* The range of an entry's value, as it was written: " (70 mm to 75 mm)", " (+- 5 %)"; empty if there is none. */
static const char *range_text(const LibraryEntry *entry, const char *key, size_t room, char *text)
{
    const CaseNode *const range = case_node_key(case_node_key(entry->node, "range"), key);
    *text = 0;
    if (range && range->kind == NODE_TEXT) snprintf(text, room, ", +- %.40s", range->text);
    if (range && range->kind == NODE_LIST)
        snprintf(text, room, ", from %.30s to %.30s", range->first->text, range->last->text);
    return text;
}

/* One value of a part of the case, or those of a map below it. */
static hawser_status value_add(Gathering *g, const CaseNode *node, int once)
{
    char path[CASE_PATH_MAX], source[HAWSER_ASSUMPTION_SOURCE_MAX] = "", range[100];
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = node->kind == NODE_MAP ? node->first : NULL; child && !status; child = child->next) {
        status = value_add(g, child, once);
    }
    if (node->kind != NODE_TEXT) return status;
    const LibraryEntry *const entry = node->entry;
    if (entry) {
        const int named = snprintf(source, sizeof source, "%.63s (%.20s%.99s): ", entry->name, entry->mark,
                                   range_text(entry, node->key, sizeof range, range));
        snprintf(source + named, sizeof source - (size_t)named, "%s", entry->source);
        if (once && is_repeated(g, node->key, source)) return HAWSER_OK;
    }
    hawser_assumption *const a = assumption_add(g, case_path(node, NULL, path), node->text, entry ? CATALOGUE : GIVEN);
    if (!a) return error_memory(g->r->err);
    memcpy(a->source, source, sizeof a->source);
    return HAWSER_OK;
}

/* All that is said of a part that has a type, or an estimate: what was given stands beside what was not. */
static hawser_status part_add(Gathering *g, const CaseNode *part, int once)
{
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = part->first; child && !status; child = child->next) {
        if (once && !child->entry) continue; /* of rollers, ducts and frictions only what the type brought */
        if (strcmp(child->key, "type") != 0) status = value_add(g, child, once);
    }
    return status;
}

/* An estimated rigidity, with what it is worth. */
static hawser_status estimate_add(Gathering *g, const CaseNode *cable, const char *key, double value, const char *unit,
                                  const char *worth, ...)
{
    char path[CASE_PATH_MAX], text[HAWSER_ASSUMPTION_VALUE_MAX];
    snprintf(text, sizeof text, "%.3g %s", value, unit);
    hawser_assumption *const a = assumption_add(g, case_path(cable, key, path), text, ESTIMATED);
    if (!a) return error_memory(g->r->err);
    va_list args;
    va_start(args, worth);
    vsnprintf(a->source, sizeof a->source, worth, args);
    va_end(args);
    return HAWSER_OK;
}

static hawser_status estimates_add(Gathering *g, const CaseNode *node, const CableDef *cable)
{
    const StiffnessEstimate e = cable_def_estimate(cable);
    const unsigned which = cable->estimated;
    const char *const from =
        cable->conductor_area > 0 ? "diameter and conductor" : "diameter and mass, the metal taken for copper";
    hawser_status status = HAWSER_OK;
    if (which & CABLE_ESTIMATED_EA) {
        status = estimate_add(g, node, "EA", cable->ea, "N",
                              "(CS2) from %s; good within a factor of %.2g, which hardly changes the pull", from,
                              e.ea_factor);
    }
    if (!status && which & CABLE_ESTIMATED_EI) {
        status =
            estimate_add(g, node, "EI", cable->ei_y, "N m2",
                         "(CS5) from %s; good within a factor of %.2g, from strands that slip to strands that hold: it "
                         "matters in bends and ducts, not for theory",
                         from, e.ei_factor);
    }
    if (!status && which & CABLE_ESTIMATED_GJ) {
        status =
            estimate_add(g, node, "GJ", cable->gj, "N m2", "(CS6) from EI; matters only where the cable is twisted");
    }
    if (!status && which & CABLE_ESTIMATED_GA) {
        status = estimate_add(g, node, "GA", cable->ga, "N", "(CS7) from EA; changes nothing in a long cable");
    }
    return status;
}

/* Rollers, ducts and frictions, wherever they are. */
static hawser_status types_add(Gathering *g, const CaseNode *node)
{
    hawser_status status = node->kind == NODE_MAP && case_node_key(node, "type") ? part_add(g, node, 1) : HAWSER_OK;
    for (const CaseNode *child = node->first; child && !status; child = child->next) {
        const int cables = !node->parent && strcmp(child->key, "cables") == 0;
        if (!cables && child->kind != NODE_TEXT) status = types_add(g, child);
    }
    return status;
}

static hawser_status file_add(const CaseReader *r, const CaseNode *node, const char *value, const char *origin,
                              const char *source)
{
    char path[CASE_PATH_MAX];
    Gathering g = {.r = r, .room = r->def->n_assumptions};
    hawser_assumption *const a = assumption_add(&g, case_path(node, "file", path), value, origin);
    if (!a) return error_memory(r->err);
    snprintf(a->source, sizeof a->source, "%s", source);
    return HAWSER_OK;
}

hawser_status case_unread_add(const CaseReader *r, const CaseNode *node, const char *what, long times)
{
    char count[HAWSER_ASSUMPTION_VALUE_MAX];
    snprintf(count, sizeof count, "%ld times", times);
    return file_add(r, node, times == 1 ? "once" : count, NOT_READ, what);
}

hawser_status case_found_add(const CaseReader *r, const CaseNode *node, const char *value, int estimated,
                             const char *source)
{
    return file_add(r, node, value, estimated ? ESTIMATED : GIVEN, source);
}

hawser_status case_assumptions_read(CaseReader *r, const CaseNode *node)
{
    Gathering g = {.r = r, .room = r->def->n_assumptions};
    hawser_status status = HAWSER_OK;
    for (const CaseNode *cable = node->first; cable && !status; cable = cable->next) {
        const CableDef *const def = &r->def->cables[cable->index];
        if (!case_node_key(cable, "type") && !def->estimated) continue;
        status = part_add(&g, cable, 0);
        if (!status) status = estimates_add(&g, cable, def);
    }
    return status ? status : types_add(&g, r->root);
}
