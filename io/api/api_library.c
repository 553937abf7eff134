/* Adds an entry from a data sheet to the user's own catalogue, for `hawser library add`. The file changes only in the
 * entry's lines, which the readers of catalogues and of cases have both accepted before anything is written. */
#define _GNU_SOURCE /* open_memstream */
/* The catalogue as a list, printed by `hawser library`. */
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "io/case/case_read.h"
#include "io/case/library.h"
#include "io/results/results_file.h"

enum { FIGURES_MAX = 240 };

/* An entry as text. */
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

/* Appends a part behind a comma; text that does not fit is cut. */
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

/* Writes an entry's own values, including those of maps within it. */
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

/* Reads a number of an entry; 0 if it is missing or not such a number. */
static double number_of(const Units *units, const CaseNode *node, Dimension dimension)
{
    char why[UNITS_WHY_MAX];
    double value = 0;
    const int read = node && node->kind == NODE_TEXT && units_read(units, node->text, dimension, &value, why);
    return read ? value : 0;
}

/* Writes the rigidities that a case would get from a cable's or a rope's entry. */
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

/* Returns the requested kinds, a bit each; 0: there is no such kind. */
static unsigned kinds_asked(const char *kind)
{
    unsigned kinds = 0;
    for (int k = 0; k < LIBRARY_KINDS; k++) {
        if (!kind || !*kind || strcmp(kind, library_kinds[k]) == 0) kinds |= 1u << k;
    }
    return kinds;
}

/* Lists kind by kind, each in the order of its files. */
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
    const Table table = {"entries",
                         "Typical and estimated figures: a maker's data sheet is better (docs/guide/equipment.md)",
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

/* The new entry, and its file. */
typedef struct Addition {
    const char *file, *name;
    LibraryKind kind;
    int n;
    const char *const *value; /* [n] "KEY=VALUE" */
    hawser_error *err;
} Addition;

static int is_about(const char *value)
{
    char key[16];
    snprintf(key, sizeof key, "%.*s", (int)strcspn(value, "="), value);
    return library_about(key);
}

static int has_key(const Addition *a, const char *key)
{
    const size_t n = strlen(key);
    for (int i = 0; i < a->n; ++i) {
        if (strncmp(a->value[i], key, n) == 0 && a->value[i][n] == '=') return 1;
    }
    return 0;
}

/* Writes the values, a line each; without `all` not those about the entry itself. Texts are quoted, the rest is YAML.
 */
static void values_write(const Addition *a, int all, int indent, FILE *to)
{
    for (int i = 0; i < a->n; ++i) {
        const char *const value = a->value[i], *const equal = strchr(value, '=');
        const int words = strncmp(value, "source=", 7) == 0 || strncmp(value, "note=", 5) == 0;
        if (!all && is_about(value)) continue;
        fprintf(to, "%*s%.*s: ", indent, "", (int)(equal - value), value);
        if (words) putc('"', to);
        for (const char *c = equal + 1; *c; ++c) {
            if (words && (*c == '"' || *c == '\\')) putc('\\', to);
            putc(*c, to);
        }
        fputs(words ? "\"\n" : "\n", to);
    }
}

/* Checks that names and keys need no quotes in YAML, and that values have one line. */
static hawser_status words_check(const Addition *a)
{
    static const char also[] = "-_./+";
    const char *c = a->name;
    while (isalnum((unsigned char)*c) || (c > a->name && *c && strchr(also, *c))) ++c;
    if (*c || c == a->name || c - a->name > 63)
        return error_set(a->err, HAWSER_ERR_INPUT, "'%.80s' is no name: letters, digits and %s, 63 at most", a->name,
                         also);
    for (int i = 0; i < a->n; ++i) {
        const char *const value = a->value[i];
        size_t key = 0;
        while (isalnum((unsigned char)value[key]) || value[key] == '_') ++key;
        int plain = key > 0 && value[key] == '=' && value[key + 1];
        for (c = value; *c; ++c) plain &= (unsigned char)*c >= ' ';
        if (!plain)
            return error_set(a->err, HAWSER_ERR_INPUT,
                             "'%.80s' is no KEY=VALUE, as in d=91.5mm or conductor='{material: "
                             "copper, area: 800 mm2}'",
                             value);
    }
    return HAWSER_OK;
}

/* Reads the smallest case with the values, to check the keys, the units and the ranges. */
static hawser_status values_check(const Addition *a)
{
    static const char thin[] = "cables: {c: {d: 1 mm, mass: 1 g/m}}\n";
    static const struct {
        int thin;
        const char *above;
        int indent;
    } form[] = {[LIBRARY_CABLES] = {0, "cables:\n  c:\n", 4},
                [LIBRARY_ROPES] = {0, "cables:\n  c:\n", 4},
                [LIBRARY_ROLLERS] = {1, "rollers:\n  along:\n    spacing: 2 m\n", 4},
                [LIBRARY_DUCTS] = {1, "surfaces:\n  ducts:\n   -\n    name: duct\n", 4},
                [LIBRARY_FRICTION] = {1, "friction:\n", 2},
                [LIBRARY_REELS] = {1, "reel:\n", 2}};
    char *text = NULL;
    size_t size = 0;
    CaseTree *tree = NULL;
    SceneDef def;
    FILE *const to = open_memstream(&text, &size);
    if (!to) return error_memory(a->err);
    fprintf(to,
            "chain: [{cable: c, length: 10 m}]\nroute: {head_at: 2 m, pieces: [{straight: 20 m}]}\nrun: {duration: 1 "
            "s}\n%s%s",
            form[a->kind].thin ? thin : "", form[a->kind].above);
    if (a->kind == LIBRARY_REELS && !has_key(a, "inertia")) fputs("  inertia: 1 kg m2\n", to);
    values_write(a, 0, form[a->kind].indent, to);
    if (fclose(to)) return error_memory(a->err);
    hawser_status status = case_tree_parse(text, "the entry", &tree, a->err);
    if (!status) case_tree_unline(tree);
    if (!status) status = case_read(tree, &def, a->err);
    if (!status) scene_def_clear(&def);
    case_tree_free(tree);
    free(text);
    return status;
}

/* Returns the end of the section of a kind, and its entries' indentation, -1 if it stands in brackets; NULL: there is
 * none. */
static const char *section_end(const char *text, const char *kind, int *indent)
{
    const size_t n = strlen(kind);
    const char *end = NULL;
    for (const char *line = text, *next; *line; line = next) {
        next = line + strcspn(line, "\n");
        next += *next == '\n';
        const int blanks = (int)strspn(line, " ");
        const int blank = !line[blanks] || strchr("\r\n#", line[blanks]);
        if (!end) {
            if (strncmp(line, kind, n) != 0 || line[n] != ':') continue;
            const char *const behind = line + n + 1;
            if (!strchr("\r\n#", behind[strspn(behind, " ")])) *indent = -1;
            end = next;
        } else if (!blank && blanks == 0) {
            break;
        } else if (!blank) {
            if (!*indent) *indent = blanks;
            end = next;
        }
    }
    return end;
}

/* Makes the file's text with the entry in it. */
static hawser_status text_with(const Addition *a, const char *old, char **text)
{
    size_t size = 0;
    int indent = 0;
    const char *const kind = library_kinds[a->kind], *const end = section_end(old, kind, &indent);
    const char *const at = end ? end : old + strlen(old);
    if (indent < 0)
        return error_set(a->err, HAWSER_ERR_INPUT,
                         "%.300s: '%s' stands in brackets: write it in lines, and the entry fits in", a->file, kind);
    FILE *const to = open_memstream(text, &size);
    if (!to) return error_memory(a->err);
    if (!indent) indent = 2;
    fwrite(old, 1, (size_t)(at - old), to);
    if (at > old && at[-1] != '\n') putc('\n', to);
    if (!end) fprintf(to, "%s:\n", kind);
    fprintf(to, "%*s%s:\n", indent, "", a->name);
    values_write(a, 1, 2 * indent, to);
    fputs(at, to);
    return fclose(to) ? error_memory(a->err) : HAWSER_OK;
}

/* Counts the entries of the text as a file; `taken`: also checks whether the name is among those of its kind. */
static hawser_status entries_count(const Addition *a, const char *text, int *n, int taken)
{
    const unsigned lines = 1u << LIBRARY_CABLES | 1u << LIBRARY_ROPES, own = 1u << a->kind;
    CaseTree *tree = NULL;
    Library *const library = library_new();
    hawser_status status = library ? case_tree_parse(text, a->file, &tree, a->err) : error_memory(a->err);
    if (!status) status = library_take(library, tree, 0, a->err);
    const LibraryEntry *const same =
        !status && taken ? library_find(library, own & lines ? lines : own, a->name) : NULL;
    if (same) status = case_key_error(a->err, same->node, NULL, "is there already, and nothing is written over");
    if (!status) *n = library->n_entries;
    library_free(library);
    return status;
}

/* Reads the present file; empty if there is none. */
static hawser_status file_old(const Addition *a, char **old)
{
    size_t size = 0;
    if (access(a->file, F_OK) && errno == ENOENT) {
        *old = strdup("");
        return *old ? HAWSER_OK : error_memory(a->err);
    }
    hawser_status status = case_file_read(a->file, old, &size, a->err);
    if (!status && strlen(*old) != size)
        status = error_set(a->err, HAWSER_ERR_INPUT, "%.300s: no text: it has a NUL character", a->file);
    return status;
}

hawser_status hawser_library_add(const char *file, const char *kind, const char *name, int n, const char *const *values,
                                 hawser_error *err)
{
    Addition a = {.file = file, .name = name, .n = n, .value = values, .err = err};
    char *old = NULL, *text = NULL;
    int before = 0, after = 0, k = 0;
    if (!file || !kind || !name) return error_argument(err, !file ? "file" : !kind ? "kind" : "name");
    if (n < 1 || !values) return error_argument(err, n < 1 ? "n" : "values");
    while (k < LIBRARY_KINDS && strcmp(kind, library_kinds[k]) != 0) ++k;
    if (k == LIBRARY_KINDS) return library_kind_error(kind, err);
    a.kind = (LibraryKind)k;
    hawser_status status = words_check(&a);
    if (!status) status = values_check(&a);
    if (!status) status = file_old(&a, &old);
    if (!status && old[strspn(old, " \n")]) status = entries_count(&a, old, &before, 1);
    if (!status) status = text_with(&a, old, &text);
    if (!status) status = entries_count(&a, text, &after, 0);
    if (!status && after != before + 1)
        status = error_set(err, HAWSER_ERR_INPUT, "%.300s: the entry does not fit into this file", file);
    if (!status) status = out_file(file, text, strlen(text), err);
    free(old);
    free(text);
    return status;
}
