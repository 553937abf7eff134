/* The catalogue as a list: what `hawser library` prints. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "io/library/library.h"

enum { FIGURES_MAX = 240 };

/* An entry in words. */
typedef struct EntryRow {
    const char *kind, *name, *mark, *note, *source;
    char figures[FIGURES_MAX], ranges[FIGURES_MAX], estimated[FIGURES_MAX];
} EntryRow;

static const Column entry_column[] = {
    {COLUMN("kind", TEXT, EntryRow, kind), .label = "kind"},
    {COLUMN("name", TEXT, EntryRow, name), .label = "name"},
    {COLUMN("figures", CHARS, EntryRow, figures), .label = "figures"},
    {COLUMN("ranges", CHARS, EntryRow, ranges), .label = "range"},
    {COLUMN("estimated", CHARS, EntryRow, estimated), .label = "estimated from these"},
    {COLUMN("mark", TEXT, EntryRow, mark), .label = "mark"},
    {COLUMN("note", TEXT, EntryRow, note), .label = "note"},
    {COLUMN("source", TEXT, EntryRow, source), .label = "source"},
};

/* Appends a part behind a comma; what does not fit is cut. */
static void say(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void say(char *text, const char *format, ...)
{
    va_list args;
    size_t used = strlen(text);
    if (used) used += (size_t)snprintf(text + used, FIGURES_MAX - used, ", ");
    if (used >= FIGURES_MAX) return;
    va_start(args, format);
    vsnprintf(text + used, FIGURES_MAX - used, format, args);
    va_end(args);
}

/* An entry's own values, those of maps within it too. */
static void figures_say(const CaseNode *map, char *text)
{
    for (const CaseNode *child = map->first; child; child = child->next) {
        if (library_about(child->key)) continue;
        if (child->kind == NODE_TEXT) say(text, "%s %s", child->key, child->text);
        if (child->kind == NODE_MAP) figures_say(child, text);
    }
}

static void ranges_say(const CaseNode *ranges, char *text)
{
    for (const CaseNode *r = ranges ? ranges->first : NULL; r; r = r->next) {
        if (r->kind == NODE_TEXT) say(text, "%s +- %s", r->key, r->text);
        if (r->kind == NODE_LIST) say(text, "%s %s to %s", r->key, r->first->text, r->last->text);
    }
}

/* A number of an entry; 0 if it is not there or no such number. */
static double number_of(const Units *units, const CaseNode *node, Dimension dimension)
{
    char why[UNITS_WHY_MAX];
    double value = 0;
    const int read = node && node->kind == NODE_TEXT && units_read(units, node->text, dimension, &value, why);
    return read ? value : 0;
}

/* The rigidities that a case would get from a cable's or a rope's entry. */
static void estimates_say(const Units *units, const CaseNode *entry, char *text)
{
    static const char *const metals[] = {"copper", "aluminium", NULL};
    const CaseNode *const conductor = case_node_key(entry, "conductor"), *const metal =
                                                                             case_node_key(conductor, "material");
    const double cores = number_of(units, case_node_key(conductor, "cores"), DIM_NONE);
    const CableDef cable = {.diameter = number_of(units, case_node_key(entry, "d"), DIM_LENGTH),
                            .mass = number_of(units, case_node_key(entry, "mass"), DIM_LINE_MASS),
                            .conductor_area = number_of(units, case_node_key(conductor, "area"), DIM_AREA),
                            .conductor_metal = metal && case_word_place(metal, metals) > 0,
                            .conductor_cores = cores > 0 ? (int)cores : 1};
    if (!(cable.diameter > 0) || !(cable.mass > 0)) return;
    const StiffnessEstimate e = cable_def_estimate(&cable);
    if (!case_node_key(entry, "EA")) say(text, "EA %.3g MN (factor %.2g)", e.ea / 1e6, e.ea_factor);
    if (!case_node_key(entry, "EI")) say(text, "EI %.4g N m2 (factor %.2g)", e.ei, e.ei_factor);
    if (!case_node_key(entry, "GJ")) say(text, "GJ %.4g N m2", e.gj);
}

static EntryRow row_of(const Units *units, const LibraryEntry *e)
{
    EntryRow row = {library_kinds[e->kind], e->name, e->mark, e->note, e->source, "", "", ""};
    figures_say(e->node, row.figures);
    ranges_say(case_node_key(e->node, "range"), row.ranges);
    if (e->kind == LIBRARY_CABLES || e->kind == LIBRARY_ROPES) estimates_say(units, e->node, row.estimated);
    return row;
}

/* The kinds that are asked for, a bit each; 0: there is no such kind. */
static unsigned kinds_asked(const char *kind)
{
    unsigned kinds = 0;
    for (int k = 0; k < LIBRARY_KINDS; k++) {
        if (!kind || !*kind || strcmp(kind, library_kinds[k]) == 0) kinds |= 1u << k;
    }
    return kinds;
}

/* Kind by kind, each in the order of its files. */
static hawser_status list_write(const Library *library, const Units *units, unsigned kinds, const char *pattern,
                                hawser_format format, char **text, hawser_error *err)
{
    EntryRow *const row = calloc((size_t)library->n_entries + 1, sizeof *row);
    int n = 0;
    if (!row) return error_memory(err);
    for (int k = 0; k < LIBRARY_KINDS; k++) {
        for (int i = 0; i < library->n_entries; i++) {
            const LibraryEntry *const e = &library->entry[i];
            if ((int)e->kind != k || !(kinds >> k & 1) || (pattern && !strstr(e->name, pattern))) continue;
            row[n++] = row_of(units, e);
        }
    }
    const Table table = {"entries", "Typical and estimated figures: a maker's data sheet is better (docs/library.md)",
                         COLUMNS(EntryRow, entry_column), n, row};
    const Fact count = {"entries_found", "entries", "", cell_number(n)};
    const Document doc = {
        .title = "Catalogue", .n_facts = 1, .n_tables = 1, .fact = &count, .table = &table, .csv = &table};
    hawser_status status = HAWSER_OK;
    if (n == 0) {
        char near[FIGURES_MAX];
        library_near(library, kinds, pattern ? pattern : "", sizeof near, near);
        status = error_set(err, HAWSER_ERR_INPUT, "no entry of the catalogue has '%.80s' in its name; near are %s",
                           pattern ? pattern : "", near);
    }
    if (!status) status = document_write(&doc, format, text, err);
    free(row);
    return status;
}

hawser_status hawser_library(const char *kind, const char *pattern, hawser_format format, char **text,
                             hawser_error *err)
{
    const unsigned kinds = kinds_asked(kind);
    if (!text) return error_argument(err, "text");
    *text = NULL;
    if (!kinds) return library_kind_error(kind, err);
    Library *const library = library_new();
    Units *const units = units_new();
    hawser_status status = library && units ? library_ship(library, err) : error_memory(err);
    if (!status) status = list_write(library, units, kinds, pattern, format, text, err);
    units_free(units);
    library_free(library);
    return status;
}
