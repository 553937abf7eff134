/* A document's tables as a workbook for spreadsheet programs. */
#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "core/error.h"
#include "hawser/job.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "io/case/schema.h"
#include "io/report/calculation.h"
#include "io/results/column.h"
#include "io/results/results_file.h"

/* Tables as a workbook (.xlsx): Office Open XML (ECMA-376, part 1, section 18) with a sheet for each table, its
 * columns' labels in a fixed first row, numbers as numbers in SI units, texts as texts, so that no cell is a formula.
 */

/* Memory of libzip and its random numbers, bytes: they do not survive a failed allocation. */
enum { ZIP_ROOM = 4 << 20 };

#define MAIN "http://schemas.openxmlformats.org/"

static const char xml[] = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";

static void plain_add(Growing *g, const char *text) { growing_add(g, text, strlen(text)); }

/* Adds a text in XML 1.0, which has no control characters. */
static void words_add(Growing *g, const char *words)
{
    for (const char *at = words; *at; ++at) {
        const char *const by = *at == '<'   ? "&lt;"
                               : *at == '>' ? "&gt;"
                               : *at == '&' ? "&amp;"
                               : *at == '"' ? "&quot;"
                                            : NULL;
        if (by) plain_add(g, by);
        if (!by) growing_add(g, (unsigned char)*at < ' ' || *at == 0x7F ? "?" : at, 1);
    }
}

static void number_add(Growing *g, const char *before, double value, const char *behind)
{
    char text[40];
    snprintf(text, sizeof text, "%.10g", value);
    plain_add(g, before);
    plain_add(g, text);
    plain_add(g, behind);
}

/* Adds a cell; style 1: bold. */
static void cell_add(Growing *g, Cell cell, int style)
{
    if (!cell.text && !isfinite(cell.value)) {
        plain_add(g, "<c/>");
    } else if (!cell.text) {
        number_add(g, "<c><v>", cell.value, "</v></c>");
    } else {
        plain_add(g, style ? "<c t=\"inlineStr\" s=\"1\"><is><t xml:space=\"preserve\">"
                           : "<c t=\"inlineStr\"><is><t xml:space=\"preserve\">");
        words_add(g, cell.text);
        plain_add(g, "</t></is></c>");
    }
}

static void sheet_make(Growing *g, const Table *t)
{
    plain_add(g, xml);
    plain_add(g,
              "<worksheet xmlns=\"" MAIN "spreadsheetml/2006/main\"><sheetViews><sheetView workbookViewId=\"0\"><pane "
              "ySplit=\"1\" topLeftCell=\"A2\" activePane=\"bottomLeft\" state=\"frozen\"/></sheetView></sheetViews>");
    number_add(g, "<cols><col min=\"1\" max=\"", t->columns.n,
               "\" width=\"16\" customWidth=\"1\"/></cols><sheetData><row>");
    for (int c = 0; c < t->columns.n; ++c) {
        const Column *const column = &t->columns.column[c];
        cell_add(g, cell_text(column->label ? column->label : column->key), 1);
    }
    plain_add(g, "</row>");
    for (int r = 0; r < t->n; ++r) {
        const char *const row = (const char *)t->rows + (size_t)r * t->columns.size;
        plain_add(g, "<row>");
        for (int c = 0; c < t->columns.n; ++c) cell_add(g, column_cell(&t->columns.column[c], row), 0);
        plain_add(g, "</row>");
    }
    plain_add(g, "</sheetData></worksheet>\n");
}

/* Makes the parts around the sheets: the content of the package, and the list of its sheets. */
static void parts_make(const Document *doc, Growing *types, Growing *book, Growing *links)
{
    char line[512];
    plain_add(types, xml);
    plain_add(
        types,
        "<Types xmlns=\"" MAIN "package/2006/content-types\"><Default Extension=\"rels\" ContentType=\"application/"
        "vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"xml\" ContentType=\"application/"
        "vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/><Override PartName=\"/xl/workbook.xml\" "
        "ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/><Override "
        "PartName=\"/xl/styles.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml."
        "styles+xml\"/></Types>\n");
    plain_add(book, xml);
    plain_add(book, "<workbook xmlns=\"" MAIN "spreadsheetml/2006/main\" xmlns:r=\"" MAIN
                    "officeDocument/2006/relationships\"><sheets>");
    plain_add(links, xml);
    plain_add(links, "<Relationships xmlns=\"" MAIN "package/2006/relationships\">");
    for (int k = 0; k < doc->n_tables; ++k) {
        snprintf(line, sizeof line, "<sheet name=\"%.30s\" sheetId=\"%d\" r:id=\"rId%d\"/>", doc->table[k].key, k + 1,
                 k + 1);
        plain_add(book, line);
        snprintf(line, sizeof line,
                 "<Relationship Id=\"rId%d\" Type=\"" MAIN
                 "officeDocument/2006/relationships/worksheet\" Target=\"worksheets/sheet%d.xml\"/>",
                 k + 1, k + 1);
        plain_add(links, line);
    }
    plain_add(book, "</sheets></workbook>\n");
    snprintf(line, sizeof line,
             "<Relationship Id=\"rId%d\" Type=\"" MAIN
             "officeDocument/2006/relationships/styles\" Target=\"styles.xml\"/></Relationships>\n",
             doc->n_tables + 1);
    plain_add(links, line);
}

static const char root_links[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<Relationships xmlns=\"" MAIN
    "package/2006/relationships\"><Relationship Id=\"rId1\" Type=\"" MAIN
    "officeDocument/2006/relationships/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>\n";

static const char styles[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<styleSheet xmlns=\"" MAIN
    "spreadsheetml/2006/main\"><fonts count=\"2\"><font><sz val=\"11\"/><name val=\"Calibri\"/></font><font><b/><sz "
    "val=\"11\"/><name val=\"Calibri\"/></font></fonts><fills count=\"1\"><fill><patternFill "
    "patternType=\"none\"/></fill>"
    "</fills><borders count=\"1\"><border/></borders><cellStyleXfs count=\"1\"><xf/></cellStyleXfs><cellXfs "
    "count=\"2\"><xf "
    "fontId=\"0\"/><xf fontId=\"1\" applyFont=\"1\"/></cellXfs></styleSheet>\n";

/* Adds a part, whose bytes must stay until the archive is closed; every archive has the same date. Returns 0 if it
 * fails. */
static int part_add(zip_t *zip, const char *name, const char *bytes, size_t size)
{
    static const time_t date = 631152000; /* 1990-01-01 */
    zip_source_t *const source = bytes ? zip_source_buffer(zip, bytes, size, 0) : NULL;
    const zip_int64_t at = source ? zip_file_add(zip, name, source, ZIP_FL_ENC_UTF_8) : -1;
    if (at < 0) zip_source_free(source);
    return at >= 0 && !zip_file_set_mtime(zip, (zip_uint64_t)at, date, 0);
}

/* Returns the archive's bytes, malloc'ed; NULL: no memory. */
static char *archive_bytes(zip_source_t *source, size_t *size)
{
    char *bytes = NULL;
    if (zip_source_open(source)) return NULL;
    const int sought = zip_source_seek(source, 0, SEEK_END);
    const zip_int64_t n = sought ? -1 : zip_source_tell(source);
    if (n > 0 && !zip_source_seek(source, 0, SEEK_SET)) bytes = malloc((size_t)n);
    if (bytes && zip_source_read(source, bytes, (zip_uint64_t)n) != n) {
        free(bytes);
        bytes = NULL;
    }
    zip_source_close(source);
    *size = (size_t)n;
    return bytes;
}

/* Puts [n_tables + 3] parts into an archive. */
static char *archive_make(const Document *doc, const Growing *part, size_t *size)
{
    char name[64];
    zip_source_t *const source = zip_source_buffer_create(NULL, 0, 0, NULL);
    zip_t *zip = source ? zip_open_from_source(source, ZIP_TRUNCATE, NULL) : NULL;
    if (!zip) {
        zip_source_free(source);
        return NULL;
    }
    zip_source_keep(source);
    const Growing *const types = &part[doc->n_tables], *const book = types + 1, *const links = types + 2;
    int ok = part_add(zip, "[Content_Types].xml", types->text, types->size) &&
             part_add(zip, "_rels/.rels", root_links, sizeof root_links - 1) &&
             part_add(zip, "xl/workbook.xml", book->text, book->size) &&
             part_add(zip, "xl/_rels/workbook.xml.rels", links->text, links->size) &&
             part_add(zip, "xl/styles.xml", styles, sizeof styles - 1);
    for (int k = 0; ok && k < doc->n_tables; ++k) {
        snprintf(name, sizeof name, "xl/worksheets/sheet%d.xml", k + 1);
        ok = part_add(zip, name, part[k].text, part[k].size);
    }
    if (!ok || zip_close(zip)) {
        zip_discard(zip);
        zip_source_free(source);
        return NULL;
    }
    char *const bytes = archive_bytes(source, size);
    zip_source_free(source);
    return bytes;
}

/* Makes the bytes of the .xlsx file, malloc'ed. The keys of the tables are the names of the sheets. Errors: MEMORY. */
static hawser_status workbook_make(const Document *doc, char **bytes, size_t *size, hawser_error *err)
{
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    const int n = doc->n_tables + 3;
    Growing *const part = calloc((size_t)n, sizeof *part);
    int bad = !part || !plain || !memory_room(ZIP_ROOM);
    *bytes = NULL;
    if (!bad) {
        const locale_t before = uselocale(plain);
        for (int k = 0; k < doc->n_tables; ++k) sheet_make(&part[k], &doc->table[k]);
        parts_make(doc, &part[n - 3], &part[n - 2], &part[n - 1]);
        uselocale(before);
    }
    for (int k = 0; part && k < n; ++k) bad |= part[k].bad;
    if (!bad) *bytes = archive_make(doc, part, size);
    for (int k = 0; part && k < n; ++k) free(part[k].text);
    free(part);
    if (plain) freelocale(plain);
    return *bytes ? HAWSER_OK : error_memory(err);
}

/* A job: many pulls, each a case of its own or keys over common ones; calculated by theory in both directions, with the
 * reels that carry their cables and the joint bays between them. docs/guide/jobs-and-sheets.md. */

enum { PULLS_MAX = 10000, REELS_MAX = 10000, SAID_MAX = 320, PATH_MOST = 1024 };

/* One length of cable that a pull needs: a single cable, each of several, or several that are twisted together. */
typedef struct Length {
    const char *kind;      /* the case's name */
    double mass, diameter; /* kg/m, m */
    int count;
} Length;

/* A stretch that a winch pulls without a break, up to a pit or the end. */
typedef struct Section {
    char ends_at[NAME_MAX_LENGTH]; /* "": the end */
    double force, rest;            /* N */
} Section;

enum { SECTIONS_MAX = 64 };

/* One pull: its entry in the file, its case, and theory in the chosen direction. */
typedef struct JobPull {
    char name[NAME_MAX_LENGTH], from[NAME_MAX_LENGTH], to[NAME_MAX_LENGTH], on[NAME_MAX_LENGTH];
    char path[PATH_MOST]; /* file of its case; "": none */
    int wanted;           /* 0: the better direction; otherwise the way + 1 */
    hawser_case *c;       /* owned */
    int way;
    hawser_word word;
    double length, cable, mass, cables;      /* m, m of each length with the allowance, kg/m of all, 1 */
    double force, rest, other, margin, trip; /* N, N, N the other way, 1, N */
    char limit[32], at[96], by[96]; /* the limit with the least margin and its place; source of the trip force */
    char kind[NAME_MAX_LENGTH], verdict[24]; /* the cable; the word, as it is printed */
    char winch[NAME_MAX_LENGTH];             /* the joint bay of the winch */
    char only_if[SAID_MAX];                  /* condition of SAFE ONLY IF; "" */
    char *reel;                              /* the reels, owned; NULL: none */
    int without;                             /* number of lengths that fit no reel */
    int n_sections;
    Section section[SECTIONS_MAX];
    int n_lengths;
    Length need[BUNDLE_KINDS_MAX];
} JobPull;

/* A reel, and the lengths that are taken from it. */
typedef struct JobReel {
    char name[NAME_MAX_LENGTH];
    double length, tare;           /* m of cable on it when delivered, kg without cable */
    Length of;                     /* cable on it; kind NULL: nothing yet */
    char *pulls;                   /* owned; NULL: none */
    double used, left, mass, lift; /* m, m, kg of cable when delivered, N with it */
} JobReel;

/* A joint bay, where sections meet. */
typedef struct JobBay {
    char name[2 * NAME_MAX_LENGTH + 4];
    char *reels, *pulls; /* owned; NULL: none */
    double force, trip;  /* N: largest of the winches that stand there */
} JobBay;

struct hawser_job {
    CaseTree *tree; /* the cases' nodes point into it */
    char title[256];
    double allowance; /* m of cable for each pull beyond its route */
    int n_pulls, n_reels, n_bays;
    JobPull *pull;
    JobReel *reel;
    JobBay *bay;
};

/* --------------------------------------------------------------------------------------------------------- the file */

static const char *const directions[] = {"better", "forward", "backward", NULL};

static const CaseKey pull_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(JobPull, name), .meaning = "No two pulls have the same."},
    {"case", KEY_TEXT, .fallback = "", AT(JobPull, path),
     .meaning = "File of a case to start from, relative to the job's folder."},
    {"from", KEY_TEXT, .fallback = "", AT(JobPull, from), .meaning = "Joint bay at the route's start."},
    {"to", KEY_TEXT, .fallback = "", AT(JobPull, to), .meaning = "Joint bay at the route's end."},
    {"on", KEY_TEXT, .fallback = "", AT(JobPull, on), .meaning = "Reel of the cable; empty: any that fits."},
    {"direction", KEY_CHOICE, .fallback = "better", .choices = directions, AT(JobPull, wanted),
     .meaning = "`forward` pulls from the route's start to its end, with the reel at `from`."},
};

static SECTION(job_pull, "pulls.N", pull_keys);

static const CaseKey reel_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(JobReel, name), .meaning = "No two reels have the same."},
    {"length", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, LONG), AT(JobReel, length),
     .meaning = "Length of its cable."},
    {"tare", KEY_NUMBER, DIM_MASS, .fallback = "0 kg", FROM(0, STRONG), AT(JobReel, tare),
     .meaning = "Mass of the empty reel."},
};

static SECTION(job_reel, "reels.N", reel_keys);

static const CaseKey top_keys[] = {
    {"title", KEY_TEXT, .fallback = "", AT(hawser_job, title),
     .meaning = "Heading of the tables; empty: the file's name."},
    {"allowance", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(hawser_job, allowance),
     .meaning = "Cable that each pull needs beyond its route, for joints or ends."},
    {"common", KEY_MAP, .otherwise = "nothing", .form = "keys of a case",
     .meaning = "What every pull has unless it has the key itself."},
    {"pulls", KEY_LIST, .required = 1, .section = &job_pull, .meaning = "The pulls, up to 10 000."},
    {"reels", KEY_LIST, .otherwise = "none", .section = &job_reel, .meaning = "Delivered reels."},
};

SECTION(job_top, "", top_keys);

static CaseNode *child_of(CaseNode *map, const char *key)
{
    CaseNode *child = map->first;
    while (child && strcmp(child->key, key) != 0) child = child->next;
    return child;
}

/* Adds the keys of `from` that `map` lacks: whole sections, and the keys of sections that both have; nothing is mixed
 * deeper down. depth: 0 here. Returns 0 without memory. */
static int missing_add(CaseNode *map, const CaseNode *from, int depth)
{
    for (const CaseNode *child = from->first; child; child = child->next) {
        CaseNode *const own = child_of(map, child->key);
        if (own && depth == 0 && own->kind == NODE_MAP && child->kind == NODE_MAP) {
            if (!missing_add(own, child, 1)) return 0;
        } else if (!own) {
            CaseNode *const copy = node_clone(child, NULL);
            if (copy) copy->key = strdup(child->key);
            if (!copy || !copy->key) {
                node_free(copy);
                return 0;
            }
            node_append(map, copy);
        }
    }
    return 1;
}

static int is_pull_key(const char *key)
{
    int known = 0;
    for (int k = 0; k < job_pull.n; ++k) known |= strcmp(key, pull_keys[k].name) == 0;
    return known;
}

/* Splits a pull's map in two: the keys of the job, whose messages name the place in the list, and those of the case. */
static int pull_split(const CaseNode *node, CaseNode **own, CaseNode **rest)
{
    CaseNode *const part[] = { *own = node_new(NODE_MAP, node->origin, node->line),
                               *rest = node_new(NODE_MAP, node->origin, node->line)};
    int ok = part[0] && part[1];
    for (const CaseNode *child = node->first; ok && child; child = child->next) {
        CaseNode *const copy = node_clone(child, NULL);
        if (copy) copy->key = strdup(child->key);
        ok = copy && copy->key;
        if (ok) node_append(part[!is_pull_key(child->key)], copy);
        if (!ok) node_free(copy);
    }
    if (!ok) return 0;
    part[0]->parent = node->parent;
    part[0]->index = node->index;
    return 1;
}

/* Makes the case: the pull's own keys override those of its case file, and both the common ones. Takes `keys`. */
static hawser_status case_make(const hawser_job *job, const CaseNode *common, CaseNode *keys, JobPull *pull,
                               hawser_error *err)
{
    char path[2 * OUT_PATH_MAX];
    CaseTree *tree = calloc(1, sizeof *tree), *file = NULL;
    hawser_status status = tree ? HAWSER_OK : error_memory(err);
    snprintf(path, sizeof path, "%s%s%s", *pull->path == '/' ? "" : job->tree->folder, *pull->path == '/' ? "" : "/",
             pull->path);
    if (tree) tree->root = keys;
    if (!tree) node_free(keys);
    if (!status && *pull->path) status = case_tree_load(path, &file, err);
    if (!status) {
        const CaseTree *const at = file ? file : job->tree;
        tree->folder = strdup(at->folder);
        tree->path = strdup(at->path);
        int ok = tree->folder && tree->path && (!file || missing_add(tree->root, file->root, 0));
        if (file) { /* the names that its nodes point at move with them */
            tree->origins = file->origins;
            file->origins = NULL;
        }
        ok = ok && (!common || missing_add(tree->root, common, 0));
        if (!ok) status = error_memory(err);
    }
    case_tree_free(file);
    if (status) {
        case_tree_free(tree);
        return status;
    }
    return case_wrap(tree, *pull->path ? path : job->tree->path, &pull->c, err);
}

/* ------------------------------------------------------------------------------------------------------- one answer */

static double number_at(const json_t *object, const char *key)
{
    const json_t *const value = json_object_get(object, key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

static const char *text_at(const json_t *object, const char *key)
{
    const char *const text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

static hawser_word word_at(const json_t *answer, int way)
{
    const char *const code = text_at(answer, way == PLAN_FORWARD ? "verdict_code" : "verdict_code_backward");
    int word = 0;
    while (word < HAWSER_WORDS && strcmp(code, hawser_word_code((hawser_word)word)) != 0) ++word;
    return (hawser_word)word;
}

/* Returns the rank from the best to the worst. */
static int rank_of(hawser_word word)
{
    static const hawser_word order[] = {HAWSER_SAFE, HAWSER_SAFE_ONLY_IF, HAWSER_NOT_JUDGED, HAWSER_NOT_TRUSTED,
                                        HAWSER_NOT_SAFE};
    int rank = 0;
    while (rank < 4 && order[rank] != word) ++rank;
    return rank;
}

static double force_at(const json_t *answer, int way)
{
    return number_at(answer, way == PLAN_FORWARD ? "largest_force_N" : "backward_largest_force_N");
}

/* Returns the way with the better verdict, and among equals with less force. */
static int better_way(const json_t *answer)
{
    const int by = rank_of(word_at(answer, PLAN_FORWARD)) - rank_of(word_at(answer, PLAN_BACKWARD));
    if (by) return by < 0 ? PLAN_FORWARD : PLAN_BACKWARD;
    return force_at(answer, PLAN_BACKWARD) < force_at(answer, PLAN_FORWARD) ? PLAN_BACKWARD : PLAN_FORWARD;
}

/* Takes the limit with the least margin in the chosen direction. */
static void least_take(const json_t *limits, JobPull *pull)
{
    size_t i;
    json_t *limit;
    pull->margin = NAN;
    json_array_foreach((json_t *)(size_t)limits, i, limit)
    {
        const double margin = number_at(limit, "margin");
        const char *const way = text_at(limit, "direction");
        if ((*way && strcmp(way, theory_ways[pull->way]) != 0) || isnan(margin) || margin >= pull->margin) continue;
        pull->margin = margin;
        snprintf(pull->limit, sizeof pull->limit, "%s", text_at(limit, "name"));
        snprintf(pull->at, sizeof pull->at, "%s", text_at(limit, "where"));
    }
}

/* Takes the stretches of the chosen direction; without pits the whole is one. */
static void sections_take(const json_t *sections, JobPull *pull)
{
    size_t i;
    json_t *row;
    json_array_foreach((json_t *)(size_t)sections, i, row)
    {
        if (strcmp(text_at(row, "direction"), theory_ways[pull->way]) != 0 || pull->n_sections == SECTIONS_MAX)
            continue;
        Section *const one = &pull->section[pull->n_sections++];
        one->force = number_at(row, "force_N");
        one->rest = number_at(row, "restart_N");
        snprintf(one->ends_at, sizeof one->ends_at, "%s", text_at(row, "ends_at"));
    }
    if (pull->n_sections == 0) pull->section[pull->n_sections++] = (Section){.force = pull->force, .rest = pull->rest};
    *pull->section[pull->n_sections - 1].ends_at = 0;
}

/* Takes the lengths: twisted cables are one; others have a length each. */
static void lengths_take(const SceneDef *def, JobPull *pull)
{
    const BundleDef *const b = &def->bundle;
    const CableDef *const whole = &def->cables[def->pieces[0].cable];
    snprintf(pull->kind, sizeof pull->kind, "%s", whole->name);
    if (bundle_tails(b) == 1) pull->need[pull->n_lengths++] = (Length){whole->name, whole->mass, whole->diameter, 1};
    for (int k = 0; bundle_tails(b) > 1 && k < b->set.kinds; ++k) {
        const CableDef *const one = &def->cables[b->member[k]];
        pull->need[pull->n_lengths++] = (Length){one->name, one->mass, one->diameter, b->set.count[k]};
    }
}

static void answer_take(const hawser_job *job, const json_t *answer, JobPull *pull)
{
    const SceneDef *const def = pull->c->def;
    pull->way = pull->wanted ? pull->wanted - 1 : better_way(answer);
    const int other = !pull->way;
    const json_t *const way = json_array_get(json_object_get(answer, "directions"), (size_t)pull->way);
    pull->word = word_at(answer, pull->way);
    snprintf(pull->verdict, sizeof pull->verdict, "%s", hawser_word_text(pull->word));
    pull->cables = number_at(answer, "cables");
    pull->length = number_at(answer, "length_m");
    pull->cable = pull->length + job->allowance;
    pull->mass = number_at(answer, "weight_N_per_m") / v3_norm(def->gravity);
    pull->force = force_at(answer, pull->way);
    pull->other = force_at(answer, other);
    pull->rest = number_at(answer, pull->way == PLAN_FORWARD ? "largest_restart_N" : "backward_largest_restart_N");
    pull->trip = number_at(way, "trip_N");
    snprintf(pull->by, sizeof pull->by, "%s", text_at(way, "trip_by"));
    snprintf(pull->winch, sizeof pull->winch, "%s", pull->way == PLAN_FORWARD ? pull->to : pull->from);
    least_take(json_object_get(answer, "limits"), pull);
    sections_take(json_object_get(answer, "sections"), pull);
    lengths_take(def, pull);
}

/* Takes the bounds of a SAFE ONLY IF from the verdict's text: computed only for the pulls that need it. */
static hawser_status bounds_take(JobPull *pull, hawser_error *err)
{
    static const char *const tables[] = {"limits", NULL};
    const TheoryWish wish = {.table = tables};
    json_t *answer = NULL;
    const hawser_status status = case_theory_values(pull->c, &wish, &answer, err);
    if (!status) {
        const char *const all = text_at(answer, pull->way == PLAN_FORWARD ? "verdict_forward" : "verdict_backward");
        const char *const at = all + strlen(hawser_word_text(HAWSER_SAFE_ONLY_IF));
        if (hawser_word_of(all) == HAWSER_SAFE_ONLY_IF)
            snprintf(pull->only_if, sizeof pull->only_if, "%.*s", (int)strcspn(at + 1, ":"), at + 1);
    }
    json_decref(answer);
    return status;
}

static hawser_status pull_calculate(const hawser_job *job, JobPull *pull, hawser_error *err)
{
    static const char *const tables[] = {"directions", "sections", "limits", NULL};
    const TheoryWish wish = {.table = tables, .no_inverse = 1};
    json_t *answer = NULL;
    hawser_status status = case_ensure_read(pull->c, err);
    if (!status) status = case_alone(pull->c, "a job's pull", err);
    if (!status) status = case_theory_values(pull->c, &wish, &answer, err);
    if (!status) answer_take(job, answer, pull);
    json_decref(answer);
    return !status && pull->word == HAWSER_SAFE_ONLY_IF ? bounds_take(pull, err) : status;
}

/* Reads a pull; errors name it with its place, and the place in its case. */
static hawser_status pull_read(const CaseReader *r, const CaseNode *node, hawser_job *job, JobPull *pull)
{
    CaseNode *own = NULL, *keys = NULL;
    hawser_error found = {HAWSER_OK, ""};
    if (node->kind != NODE_MAP) return case_value_error(r->err, node, ": expected the keys of a pull");
    if (!pull_split(node, &own, &keys)) {
        node_free(own);
        node_free(keys);
        return error_memory(r->err);
    }
    hawser_status status = case_section_read(r, own, &job_pull, pull);
    own->parent = NULL;
    node_free(own);
    for (const JobPull *before = job->pull; !status && before < pull; ++before)
        if (!strcmp(before->name, pull->name))
            status = case_value_error(r->err, case_node_key(node, "name"), ": another pull has this name");
    if (status) {
        node_free(keys);
        return status;
    }
    status = case_make(job, case_node_key(r->root, "common"), keys, pull, &found);
    if (!status) status = pull_calculate(job, pull, &found);
    char before[NAME_MAX_LENGTH + 16];
    snprintf(before, sizeof before, "pull '%s'", pull->name);
    return status ? case_key_cause(r->err, node, NULL, before, &found) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------------- reels
 */

/* Adds a name to a list of names, once. Returns 0 without memory. */
static int list_add(char **list, const char *name)
{
    const size_t used = *list ? strlen(*list) : 0, n = strlen(name);
    if (used >= n && !strcmp(*list + used - n, name) && (used == n || (*list)[used - n - 1] == ' ')) return 1;
    char *const more = realloc(*list, used + n + 3);
    if (!more) return 0;
    sprintf(more + used, "%s%s", used ? ", " : "", name);
    *list = more;
    return 1;
}

static int reel_has_room(const JobReel *reel, const JobPull *pull, const Length *need)
{
    const Length *const of = &reel->of;
    const int same = of->kind && !strcmp(of->kind, need->kind) && fabs(of->mass - need->mass) <= 1e-9 * need->mass &&
                     fabs(of->diameter - need->diameter) <= 1e-9 * need->diameter;
    return (!of->kind || same) && reel->left >= pull->cable * (1 - 1e-12);
}

static int reel_take(JobReel *reel, JobPull *pull, const Length *need)
{
    reel->of = *need;
    reel->used += pull->cable;
    reel->left = reel->length - reel->used;
    reel->mass = reel->length * need->mass;
    return list_add(&reel->pulls, pull->name) && list_add(&pull->reel, reel->name);
}

/* Returns the reel that a pull names, or else the one with the least cable left afterwards; NULL: no reel has enough.
 */
static JobReel *reel_for(hawser_job *job, const JobPull *pull, const Length *need)
{
    JobReel *best = NULL;
    for (JobReel *reel = job->reel; reel < job->reel + job->n_reels; ++reel) {
        if (*pull->on ? strcmp(reel->name, pull->on) != 0 : !reel_has_room(reel, pull, need)) continue;
        if (!best || reel->left < best->left) best = reel;
    }
    return best && reel_has_room(best, pull, need) ? best : NULL;
}

/* Assigns a reel to each length of a pull. Returns 0 without memory. */
static int lengths_place(hawser_job *job, JobPull *pull)
{
    int ok = 1;
    for (const Length *need = pull->need; need < pull->need + pull->n_lengths; ++need) {
        for (int k = 0; k < need->count && ok; ++k) {
            JobReel *const reel = reel_for(job, pull, need);
            ok = reel ? reel_take(reel, pull, need) : list_add(&pull->reel, "none fits");
            pull->without += !reel;
        }
    }
    return ok;
}

static int longer_first(const void *a, const void *b)
{
    const JobPull *const first = *(JobPull *const *)a, *const second = *(JobPull *const *)b;
    if (!*first->on != !*second->on) return *first->on ? -1 : 1; /* pulls that name theirs */
    if (first->cable > second->cable) return -1;
    return first->cable < second->cable ? 1 : first > second ? 1 : -1;
}

static hawser_status named_check(const CaseReader *r, const hawser_job *job, int p)
{
    const JobPull *const pull = &job->pull[p];
    int known = !*pull->on;
    for (int k = 0; k < job->n_reels; ++k) known |= !strcmp(job->reel[k].name, pull->on);
    if (known) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(case_node_item(case_node_key(r->root, "pulls"), p), "on"),
                            ": no reel of 'reels' has this name");
}

/* Assigns the longest lengths first, each to the reel with the least cable left afterwards (best fit decreasing): with
 * several cables in one pull each has a length of its own. */
static hawser_status reels_fill(const CaseReader *r, hawser_job *job)
{
    JobPull **const order = calloc((size_t)job->n_pulls, sizeof *order);
    hawser_status status = order ? HAWSER_OK : error_memory(r->err);
    for (int p = 0; !status && p < job->n_pulls; ++p) {
        order[p] = &job->pull[p];
        status = named_check(r, job, p);
    }
    for (int k = 0; k < job->n_reels; ++k) job->reel[k].left = job->reel[k].length;
    if (!status) qsort(order, (size_t)job->n_pulls, sizeof(JobPull *), longer_first);
    for (int p = 0; !status && job->n_reels > 0 && p < job->n_pulls; ++p)
        if (!lengths_place(job, order[p])) status = error_memory(r->err);
    for (int k = 0; !status && k < job->n_reels; ++k) {
        JobReel *const reel = &job->reel[k];
        reel->lift = (reel->mass + reel->tare) * UNIT_GRAVITY;
        if (!reel->of.kind) reel->mass = reel->lift = NAN;
    }
    free(order);
    return status;
}

/* -------------------------------------------------------------------------------------------------------------- bays
 */

static JobBay *bay_of(hawser_job *job, const char *name)
{
    for (JobBay *bay = job->bay; bay < job->bay + job->n_bays; ++bay)
        if (!strcmp(bay->name, name)) return bay;
    JobBay *const bay = &job->bay[job->n_bays++];
    *bay = (JobBay){.force = NAN, .trip = NAN};
    snprintf(bay->name, sizeof bay->name, "%s", name);
    return bay;
}

/* Adds the winch of one stretch of a pull: at the pull's end, or in a pit on its way. Returns 0 without memory. */
static int winch_stand(hawser_job *job, const JobPull *pull, int k)
{
    const Section *const one = &pull->section[k];
    char name[2 * NAME_MAX_LENGTH + 4];
    if (*one->ends_at)
        snprintf(name, sizeof name, "%s (%s)", one->ends_at, pull->name);
    else
        snprintf(name, sizeof name, "%s", pull->winch);
    if (!*name) return 1;
    JobBay *const bay = bay_of(job, name);
    bay->force = fmax(bay->force, fmax(one->force, one->rest));
    if (pull->n_sections == 1) bay->trip = fmax(bay->trip, pull->trip);
    return list_add(&bay->pulls, pull->name);
}

/* Fills the places where a winch or a reel must stand. */
static hawser_status bays_fill(hawser_job *job, hawser_error *err)
{
    size_t most = 0;
    int ok = 1;
    for (int p = 0; p < job->n_pulls; ++p) most += 2 + (size_t)job->pull[p].n_sections;
    job->bay = calloc(most, sizeof *job->bay);
    if (!job->bay) return error_memory(err);
    for (const JobPull *pull = job->pull; pull < job->pull + job->n_pulls && ok; ++pull) {
        const char *const start = pull->way == PLAN_FORWARD ? pull->from : pull->to;
        const char *const ends[] = {pull->from, pull->to};
        for (int k = 0; k < 2; ++k)
            if (*ends[k]) bay_of(job, ends[k]);
        if (*start) ok = list_add(&bay_of(job, start)->reels, pull->reel ? pull->reel : pull->name);
        for (int k = 0; k < pull->n_sections && ok; ++k) ok = winch_stand(job, pull, k);
    }
    return ok ? HAWSER_OK : error_memory(err);
}

/* ----------------------------------------------------------------------------------------------------------- reading
 */

static hawser_status reel_read(const CaseReader *r, const CaseNode *node, void *item)
{
    return case_section_read(r, node, &job_reel, item);
}

static hawser_status job_fill(const CaseReader *r, hawser_job *job)
{
    const CaseNode *const pulls = case_node_key(r->root, "pulls"), *const reels = case_node_key(r->root, "reels");
    hawser_status status = case_section_read(r, r->root, &job_top, job);
    if (status) return status;
    if (pulls->count < 1 || pulls->count > PULLS_MAX)
        return case_value_error(r->err, pulls, " of %d: a job has 1 to %d pulls", pulls->count, PULLS_MAX);
    if (reels && reels->count > REELS_MAX) return case_value_error(r->err, reels, ": more than %d reels", REELS_MAX);
    job->pull = calloc((size_t)pulls->count, sizeof *job->pull);
    if (!job->pull) return error_memory(r->err);
    for (const CaseNode *node = pulls->first; node && !status; node = node->next)
        status = pull_read(r, node, job, &job->pull[job->n_pulls++]);
    if (!status) status = case_list_read(r, reels, sizeof *job->reel, reel_read, &job->reel, &job->n_reels);
    for (int k = 0; k < job->n_reels && !status; ++k)
        for (int before = 0; before < k && !status; ++before)
            if (!strcmp(job->reel[before].name, job->reel[k].name))
                status = case_value_error(r->err, case_node_key(case_node_item(reels, k), "name"),
                                          ": another reel has this name");
    if (!status) status = reels_fill(r, job);
    return status ? status : bays_fill(job, r->err);
}

hawser_status hawser_job_schema(char **text, hawser_error *err)
{
    return text ? case_schema(&job_top, "job", &job_pull, text, err) : error_argument(err, "text");
}

hawser_status hawser_job_load(const char *path, hawser_job **out, hawser_error *err)
{
    hawser_error local;
    hawser_error *const why = err ? err : &local;
    if (!path || !out) return error_argument(err, path ? "out" : "path");
    *out = NULL;
    hawser_job *const job = calloc(1, sizeof *job);
    Units *const units = units_new();
    hawser_status status = job && units ? HAWSER_OK : error_memory(why);
    if (!status) status = case_tree_load(path, &job->tree, why);
    if (!status) {
        const CaseReader r = {.units = units, .root = job->tree->root, .folder = job->tree->folder, .err = why};
        status = job_fill(&r, job);
    }
    units_free(units);
    if (status) hawser_job_free(job);
    if (!status) *out = job;
    return status;
}

void hawser_job_free(hawser_job *job)
{
    if (!job) return;
    for (int p = 0; p < job->n_pulls; ++p) {
        hawser_case_free(job->pull[p].c);
        free(job->pull[p].reel);
    }
    for (int k = 0; k < job->n_reels; ++k) free(job->reel[k].pulls);
    for (int k = 0; k < job->n_bays; ++k) {
        free(job->bay[k].reels);
        free(job->bay[k].pulls);
    }
    free(job->pull);
    free(job->reel);
    free(job->bay);
    case_tree_free(job->tree);
    free(job);
}

/* ----------------------------------------------------------------------------------------------------------- answers
 */

static const char *direction_text(const void *row) { return theory_ways[((const JobPull *)row)->way]; }

static double margin_pct(const void *row) { return 100 * ((const JobPull *)row)->margin; }

static const char *code_text(const void *row) { return hawser_word_code(((const JobPull *)row)->word); }

static const char *words(const char *list) { return list ? list : ""; }

static const char *pull_reels(const void *row) { return words(((const JobPull *)row)->reel); }

static const char *reel_kind(const void *row) { return words(((const JobReel *)row)->of.kind); }

static const char *reel_pulls(const void *row) { return words(((const JobReel *)row)->pulls); }

static const char *bay_reels(const void *row) { return words(((const JobBay *)row)->reels); }

static const char *bay_pulls(const void *row) { return words(((const JobBay *)row)->pulls); }

static const Column pull_column[] = {
    {COLUMN("name", CHARS, JobPull, name), .label = "pull"},
    {COLUMN("verdict", CHARS, JobPull, verdict), .label = "verdict"},
    {COLUMN("length_m", NUMBER, JobPull, length), .label = "route, m", .decimals = 1},
    {.key = "direction", .kind = COLUMN_TEXT, .text = direction_text, .label = "direction"},
    {COLUMN("force_N", NUMBER, JobPull, force), .label = "winch, N", .decimals = 0},
    {COLUMN("restart_N", NUMBER, JobPull, rest), .label = "from rest, N", .decimals = 0},
    {COLUMN("other_way_N", NUMBER, JobPull, other), .label = "other way, N", .decimals = 0},
    {.key = "margin_pct", .kind = COLUMN_NUMBER, .number = margin_pct, .label = "least margin, %", .decimals = 1},
    {COLUMN("limit", CHARS, JobPull, limit), .label = "of limit"},
    {COLUMN("where", CHARS, JobPull, at), .label = "at"},
    {COLUMN("winch_at", CHARS, JobPull, winch), .label = "winch at", .group = 1},
    {COLUMN("trip_N", NUMBER, JobPull, trip), .label = "trip, N", .decimals = 0},
    {COLUMN("cable_m", NUMBER, JobPull, cable), .label = "cable, m", .decimals = 1},
    {.key = "reel", .kind = COLUMN_TEXT, .text = pull_reels, .label = "reel"},
};

/* Further columns for programs; the first of them also for readers where a pull has a value. */
static const Column pull_more[] = {
    {COLUMN("only_if", CHARS, JobPull, only_if), .label = "safe only if", .group = 1},
    {.key = "verdict_code", .kind = COLUMN_TEXT, .text = code_text},
    {COLUMN("from", CHARS, JobPull, from)},
    {COLUMN("to", CHARS, JobPull, to)},
    {COLUMN("cable", CHARS, JobPull, kind)},
    {COLUMN("cables", NUMBER, JobPull, cables)},
    {COLUMN("mass_kg_per_m", NUMBER, JobPull, mass)},
    {COLUMN("trip_by", CHARS, JobPull, by)},
};

enum { SHOWN = sizeof pull_column / sizeof *pull_column, MORE = sizeof pull_more / sizeof *pull_more };

static const Column reel_column[] = {
    {COLUMN("name", CHARS, JobReel, name), .label = "reel"},
    {.key = "cable", .kind = COLUMN_TEXT, .text = reel_kind, .label = "cable"},
    {COLUMN("length_m", NUMBER, JobReel, length), .label = "length, m", .decimals = 1},
    {.key = "pulls", .kind = COLUMN_TEXT, .text = reel_pulls, .label = "for pulls"},
    {COLUMN("used_m", NUMBER, JobReel, used), .label = "used, m", .decimals = 1},
    {COLUMN("left_m", NUMBER, JobReel, left), .label = "left, m", .decimals = 1},
    {COLUMN("cable_kg", NUMBER, JobReel, mass), .label = "cable, kg", .decimals = 0},
    {COLUMN("tare_kg", NUMBER, JobReel, tare), .label = "reel, kg", .decimals = 0},
    {COLUMN("lift_N", NUMBER, JobReel, lift), .label = "to be lifted, N", .decimals = 0},
};

static const Column bay_column[] = {
    {COLUMN("name", CHARS, JobBay, name), .label = "bay"},
    {.key = "reels", .kind = COLUMN_TEXT, .text = bay_reels, .label = "reels here"},
    {.key = "pulls", .kind = COLUMN_TEXT, .text = bay_pulls, .label = "winch here for"},
    {COLUMN("force_N", NUMBER, JobBay, force), .label = "winch, from rest, N", .decimals = 0},
    {COLUMN("trip_N", NUMBER, JobBay, trip), .label = "trip, largest, N", .decimals = 0},
};

/* The job's tables; shown: for readers, without those for programs alone. */
typedef struct JobDocument {
    Document doc;
    Fact fact[8];
    Table table[3];
    Column all[SHOWN + MORE];
    char answer[SAID_MAX];
} JobDocument;

static hawser_word worst_word(const hawser_job *job)
{
    hawser_word worst = job->pull->word;
    for (int p = 1; p < job->n_pulls; ++p)
        if (rank_of(job->pull[p].word) > rank_of(worst)) worst = job->pull[p].word;
    return worst;
}

/* Writes "12 pulls: 10 SAFE, 2 NOT SAFE". */
static void answer_make(const hawser_job *job, char text[SAID_MAX])
{
    int used = snprintf(text, SAID_MAX, "%d %s:", job->n_pulls, job->n_pulls == 1 ? "pull" : "pulls"), before = 0;
    for (int word = 0; word < HAWSER_WORDS; ++word) {
        int n = 0;
        for (int p = 0; p < job->n_pulls; ++p) n += (int)job->pull[p].word == word;
        if (n > 0)
            used += snprintf(text + used, SAID_MAX - (size_t)used, "%s %d %s", before++ ? "," : "", n,
                             hawser_word_text((hawser_word)word));
    }
    int without = 0;
    for (int p = 0; p < job->n_pulls; ++p) without += job->pull[p].without;
    if (without > 0)
        used += snprintf(text + used, SAID_MAX - (size_t)used, "; %d %s no reel", without,
                         without == 1 ? "length fits" : "lengths fit");
    snprintf(text + used, SAID_MAX - (size_t)used, "\n");
}

static void document_make(const hawser_job *job, int shown, JobDocument *d)
{
    int n = 0, bounded = 0;
    double route = 0, cable = 0;
    const JobPull *most = job->pull;
    for (const JobPull *p = job->pull; p < job->pull + job->n_pulls; ++p) {
        route += p->length;
        bounded |= *p->only_if != 0;
        for (int k = 0; k < p->n_lengths; ++k) cable += p->cable * p->need[k].count;
        if (fmax(p->force, p->rest) > fmax(most->force, most->rest)) most = p;
    }
    answer_make(job, d->answer);
    memcpy(d->all, pull_column, sizeof pull_column);
    memcpy(d->all + SHOWN, pull_more, sizeof pull_more);
    d->table[n++] = (Table){"pulls",
                            "Pulls, each in the direction that is taken",
                            {d->all, SHOWN + (shown ? bounded : MORE), sizeof(JobPull)},
                            job->n_pulls,
                            job->pull};
    if (job->n_reels > 0 || !shown)
        d->table[n++] = (Table){"reels", "Reels", COLUMNS(JobReel, reel_column), job->n_reels, job->reel};
    if (job->n_bays > 0 || !shown)
        d->table[n++] = (Table){"bays", "Joint bays and pits", COLUMNS(JobBay, bay_column), job->n_bays, job->bay};
    d->fact[0] = (Fact){"route_m", "routes together", "m", cell_number(route)};
    d->fact[1] = (Fact){"cable_m", "cable together, with the allowances", "m", cell_number(cable)};
    d->fact[2] = (Fact){"largest_force_N", "largest force of a winch, from rest", "N",
                        cell_number(fmax(most->force, most->rest))};
    d->fact[3] = (Fact){"largest_force_pull", "in the pull", "", cell_text(most->name)};
    d->doc = (Document){.title = *job->title ? job->title : job->tree->path,
                        .n_facts = 4,
                        .n_tables = n,
                        .fact = d->fact,
                        .table = d->table,
                        .csv = d->table,
                        .answer = d->answer};
}

hawser_status hawser_job_answer(const hawser_job *job, hawser_format format, char **text, hawser_word *word,
                                hawser_error *err)
{
    JobDocument d;
    if (!job || !text) return error_argument(err, job ? "text" : "job");
    if (word) *word = worst_word(job);
    document_make(job, format == HAWSER_TABLE || format == HAWSER_TABLE_US, &d);
    return document_write(&d.doc, format, text, err);
}

/* Checks that no file that the job is read from is overwritten. */
static hawser_status path_check(const hawser_job *job, const char *path, hawser_error *err)
{
    FileMarks own = {0};
    hawser_status status = file_marks_add(&own, job->tree->path, err);
    if (!status) status = file_marks_spare(&own, path, err);
    file_marks_free(&own);
    for (int p = 0; p < job->n_pulls && !status; ++p) status = hawser_case_spares(job->pull[p].c, path, err);
    return status;
}

static hawser_status calculations_write(const hawser_job *job, hawser_units units, Text *out, hawser_error *err)
{
    JobDocument d;
    char *tables = NULL;
    document_make(job, 1, &d);
    hawser_status status = document_html(&d.doc, units, &tables, err);
    if (status) return status;
    calculation_head(&job->pull->c->def->job, LANGUAGE_ENGLISH, "Pulling calculation", d.doc.title, job->tree->path,
                     out);
    text_print(out, "<p class=\"verdict %s\">", hawser_word_code(worst_word(job)));
    text_words(out, "", d.answer, "</p>\n");
    text_add(out, tables);
    free(tables);
    text_add(out, "<p>Calculations:");
    for (int p = 0; p < job->n_pulls; ++p) {
        text_print(out, " <a href=\"#pull-%d\">", p + 1);
        text_words(out, "", job->pull[p].name, "</a>");
    }
    text_add(out, "</p>\n");
    for (int p = 0; p < job->n_pulls && !status; ++p) {
        const JobPull *const pull = &job->pull[p];
        text_print(out, "<section id=\"pull-%d\" style=\"break-before:page\">\n", p + 1);
        text_words(out, "<h1>", pull->name, "</h1>\n");
        if (pull->way == PLAN_BACKWARD)
            text_add(out,
                     "<p>The job pulls it <b>backward</b>, and the verdict is that way's; the answer below begins with "
                     "the way forward.</p>\n");
        status = case_calculation_body(pull->c, pull->way, units, out, NULL, err);
        text_add(out, "</section>\n");
    }
    return status;
}

static hawser_status crews_write(const hawser_job *job, hawser_units units, Text *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    calculation_head(&job->pull->c->def->job, LANGUAGE_ENGLISH, "Crew's sheets",
                     *job->title ? job->title : job->tree->path, job->tree->path, out);
    for (int p = 0; p < job->n_pulls && !status; ++p) {
        const JobPull *const pull = &job->pull[p];
        text_print(out, "<section%s>\n", p ? " style=\"break-before:page\"" : "");
        text_words(out, "<h1>", pull->name, "</h1>\n");
        status = case_crew_body(pull->c, pull->way, units, out, NULL, err);
        text_add(out, "</section>\n");
    }
    return status;
}

typedef hawser_status (*PagesWrite)(const hawser_job *job, hawser_units units, Text *out, hawser_error *err);

static hawser_status page_write(const hawser_job *job, PagesWrite write, hawser_units units, const char *path,
                                hawser_error *err)
{
    Text out = {0};
    if (!job || !path) return error_argument(err, job ? "path" : "job");
    hawser_status status = path_check(job, path, err);
    if (!status) status = write(job, units, &out, err);
    calculation_end(&out);
    if (!status && out.failed) status = error_memory(err);
    if (!status) status = out_file(path, out.at, out.size, err);
    text_clear(&out);
    return status;
}

hawser_status hawser_job_page(const hawser_job *job, hawser_units units, const char *path, hawser_error *err)
{
    return page_write(job, calculations_write, units, path, err);
}

hawser_status hawser_job_crew_sheets(const hawser_job *job, hawser_units units, const char *path, hawser_error *err)
{
    return page_write(job, crews_write, units, path, err);
}

hawser_status hawser_job_workbook(const hawser_job *job, const char *path, hawser_error *err)
{
    JobDocument d;
    char *bytes = NULL;
    size_t size = 0;
    if (!job || !path) return error_argument(err, job ? "path" : "job");
    hawser_status status = path_check(job, path, err);
    document_make(job, 1, &d);
    if (!status) status = workbook_make(&d.doc, &bytes, &size, err);
    if (!status) status = out_file(path, bytes, size, err);
    free(bytes);
    return status;
}
