/* The parts of an FMU's archive. */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include "core/error.h"
#include "fmi/model.h"
#include "io/api/api_handles.h"
#include "io/case/library.h"
#include "io/case/yaml.h"
#include "io/report/text.h"
#include "io/results/results_file.h"

/* A file that the case refers to. */
typedef struct ResourceFile {
    char *path; /* owned; its path */
    char *name; /* owned; its name among the resources */
} ResourceFile;

enum { RESOURCE_FILES_MAX = 3 };

typedef struct Resources {
    Text text; /* text of the case: only the used values remain of catalogue and included files */
    int n;
    ResourceFile file[RESOURCE_FILES_MAX];
} Resources;

/* modelDescription.xml. The two versions have the same content in different elements. */

/* Writes name="value", with forbidden characters escaped. */
static void attribute(Text *t, const char *name, const char *value)
{
    text_print(t, " %s=\"", name);
    text_html(t, value, SIZE_MAX);
    text_add(t, "\"");
}

static void number_attribute(Text *t, const char *name, double value)
{
    if (isfinite(value)) text_print(t, " %s=\"%.17g\"", name, value);
}

static void head_write(const Model *m, hawser_fmi version, const char *title, const char *identifier, Text *t)
{
    const int two = version == HAWSER_FMI_2;
    text_add(t, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription");
    attribute(t, "fmiVersion", two ? "2.0" : "3.0");
    attribute(t, "modelName", title);
    attribute(t, two ? "guid" : "instantiationToken", m->token);
    attribute(t, "description", "A pull of power cable, simulated by hawser");
    text_print(t, " generationTool=\"hawser %s\" variableNamingConvention=\"structured\"", hawser_version());
    text_add(t, two ? " numberOfEventIndicators=\"0\">\n" : ">\n");
    text_add(t, "  <CoSimulation");
    attribute(t, "modelIdentifier", identifier);
    text_add(t, " canHandleVariableCommunicationStepSize=\"true\"");
    if (two) text_add(t, " canNotUseMemoryManagementFunctions=\"true\"");
    attribute(t, two ? "canGetAndSetFMUstate" : "canGetAndSetFMUState", "true");
    attribute(t, two ? "canSerializeFMUstate" : "canSerializeFMUState", "true");
    text_add(t, "/>\n");
}

/* Writes the units that a variable uses. */
static void units_write(const Model *m, Text *t)
{
    text_add(t, "  <UnitDefinitions>\n");
    for (int u = 0; u < UNIT_ROWS; ++u) {
        const UnitRow *const unit = &unit_rows[u];
        const int power[] = {unit->kg, unit->m, unit->s, unit->rad};
        static const char *const base[] = {"kg", "m", "s", "rad"};
        int used = 0;
        for (int i = 0; i < m->variables.n; ++i) used |= m->variables.row[i].unit == unit->name;
        if (!used) continue;
        text_print(t, "    <Unit name=\"%s\"><BaseUnit", unit->name);
        for (int k = 0; k < 4; ++k) {
            if (power[k]) text_print(t, " %s=\"%d\"", base[k], power[k]);
        }
        text_add(t, "/></Unit>\n");
    }
    text_add(t, "  </UnitDefinitions>\n");
}

static void types_write(hawser_fmi version, Text *t)
{
    const int two = version == HAWSER_FMI_2;
    text_add(t, "  <TypeDefinitions>\n");
    text_add(t, two ? "    <SimpleType name=\"Verdict\"><Enumeration>\n" : "    <EnumerationType name=\"Verdict\">\n");
    for (int i = 0; i < HAWSER_WORDS; ++i)
        text_print(t, "      <Item name=\"%s\" value=\"%d\"/>\n", hawser_word_text((hawser_word)i), i + 1);
    text_add(t, two ? "    </Enumeration></SimpleType>\n" : "    </EnumerationType>\n");
    text_add(t, "  </TypeDefinitions>\n"
                "  <LogCategories>\n"
                "    <Category name=\"logEvents\" description=\"what is going on\"/>\n"
                "    <Category name=\"logStatusWarning\" description=\"an input that could not be followed\"/>\n"
                "    <Category name=\"logStatusError\" description=\"why a call failed\"/>\n"
                "  </LogCategories>\n");
}

static const char *causality(VariableRole role)
{
    static const char *const names[] = {[ROLE_TIME] = "independent",
                                        [ROLE_PARAMETER] = "parameter",
                                        [ROLE_TUNABLE] = "parameter",
                                        [ROLE_INPUT] = "input",
                                        [ROLE_OUTPUT] = "output"};
    return names[role];
}

static const char *variability(const Variable *row)
{
    if (row->role == ROLE_PARAMETER) return "fixed";
    if (row->role == ROLE_TUNABLE) return "tunable";
    return row->type == VARIABLE_REAL ? "continuous" : "discrete";
}

/* Writes the part of a variable that both versions share. */
static void common_write(const Variable *row, int reference, Text *t)
{
    const int parameter = row->role == ROLE_PARAMETER || row->role == ROLE_TUNABLE;
    attribute(t, "name", row->name);
    text_print(t, " valueReference=\"%d\"", reference);
    attribute(t, "description", row->description);
    attribute(t, "causality", causality(row->role));
    attribute(t, "variability", variability(row));
    if (parameter || row->role == ROLE_OUTPUT) attribute(t, "initial", parameter ? "exact" : "calculated");
}

/* Writes the part of its values. */
static void values_write(const Variable *row, Text *t)
{
    const int has_start = row->role != ROLE_OUTPUT && row->role != ROLE_TIME;
    if (row->type == VARIABLE_VERDICT) attribute(t, "declaredType", "Verdict");
    if (row->unit) attribute(t, "unit", row->unit);
    if (has_start && row->type == VARIABLE_REAL) {
        number_attribute(t, "min", row->least);
        number_attribute(t, "max", row->most);
    }
    if (has_start && row->type == VARIABLE_BOOLEAN) attribute(t, "start", row->start > 0.5 ? "true" : "false");
    if (has_start && row->type == VARIABLE_REAL) number_attribute(t, "start", row->start);
}

static void variables_write(const Model *m, hawser_fmi version, Text *t)
{
    static const char *const names2[] = {"Real", "Integer", "Boolean", "String", "Enumeration"};
    static const char *const names3[] = {"Float64", "Int32", "Boolean", "String", "Enumeration"};
    text_add(t, "  <ModelVariables>\n");
    for (int i = 0; i < m->variables.n; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (version == HAWSER_FMI_2) {
            text_add(t, "    <ScalarVariable");
            common_write(row, i, t);
            text_print(t, "><%s", names2[row->type]);
            values_write(row, t);
            text_add(t, "/></ScalarVariable>\n");
        } else {
            text_print(t, "    <%s", names3[row->type]);
            common_write(row, i, t);
            values_write(row, t);
            text_add(t, "/>\n");
        }
    }
    text_add(t, "  </ModelVariables>\n");
}

/* Writes the structure. Outputs depend on no input of the same time, for inputs act from the next step on: importers
 * find no algebraic loop. All outputs are unknown at first; their dependencies then are not given, so they may be any.
 * Version 2.0 counts the variables from 1. */
static void structure_write(const Model *m, hawser_fmi version, Text *t)
{
    static const char *const lists2[] = {"Outputs", "InitialUnknowns"}, *const items3[] = {"Output", "InitialUnknown"};
    const int two = version == HAWSER_FMI_2;
    text_add(t, "  <ModelStructure>\n");
    for (int k = 0; k < 2; ++k) {
        if (two) text_print(t, "    <%s>\n", lists2[k]);
        for (int i = 0; i < m->variables.n; ++i) {
            if (m->variables.row[i].role != ROLE_OUTPUT) continue;
            const char *const known = k == 0 ? " dependencies=\"\"" : "";
            if (two) text_print(t, "      <Unknown index=\"%d\"%s/>\n", i + 1, known);
            if (!two) text_print(t, "    <%s valueReference=\"%d\"%s/>\n", items3[k], i, known);
        }
        if (two) text_print(t, "    </%s>\n", lists2[k]);
    }
    text_add(t, "  </ModelStructure>\n</fmiModelDescription>\n");
}

/* Writes modelDescription.xml of a version. identifier: the name of the library without its ending, an identifier of C.
 */
static void description_write(const Model *m, hawser_fmi version, const char *title, const char *identifier, Text *out)
{
    head_write(m, version, title, identifier, out);
    units_write(m, out);
    types_write(version, out);
    text_print(out, "  <DefaultExperiment startTime=\"0\" stopTime=\"%.17g\"", m->duration);
    if (m->interval > 0) text_print(out, " stepSize=\"%.17g\"", m->interval);
    text_add(out, "/>\n");
    variables_write(m, version, out);
    structure_write(m, version, out);
}

/* documentation/index.html, which importers show: the simulated case, how to step it, and a description of every
 * variable. */

static void cell(Text *t, const char *text)
{
    text_add(t, "<td>");
    text_html(t, text, SIZE_MAX);
    text_add(t, "</td>");
}

/* Writes all variables of the roles between two, as one table. */
static void table_write(const Model *m, const char *heading, VariableRole first, VariableRole last, Text *t)
{
    int n = 0;
    for (int i = 0; i < m->variables.n; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (row->role < first || row->role > last) continue;
        if (n++ == 0)
            text_print(t, "<h2>%s</h2>\n<table><tr><th>name</th><th>start</th><th>unit</th><th>meaning</th></tr>\n",
                       heading);
        text_add(t, "<tr>");
        cell(t, row->name);
        if (row->role == ROLE_OUTPUT || row->role == ROLE_TIME) {
            cell(t, "");
        } else if (row->type == VARIABLE_BOOLEAN) {
            cell(t, row->start > 0.5 ? "true" : "false");
        } else {
            text_print(t, "<td>%.10g</td>", row->start);
        }
        cell(t, row->unit ? row->unit : "");
        cell(t, row->description);
        text_add(t, "</tr>\n");
    }
    if (n > 0) text_add(t, "</table>\n");
}

/* Writes documentation/index.html: the unit, and its variables as tables. */
static void documentation_write(const Model *m, hawser_fmi version, const char *title, Text *t)
{
    text_add(t, "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>");
    text_html(t, title, SIZE_MAX);
    text_add(
        t,
        "</title><style>body{font-family:sans-serif;max-width:60em;margin:2em auto}table{border-collapse:collapse}"
        "td,th{border:1px solid #aaa;padding:.2em .5em;text-align:left;vertical-align:top}</style></head><body>\n<h1>");
    text_html(t, title, SIZE_MAX);
    text_print(t,
               "</h1>\n<p>A pull of power cable, simulated by hawser %s; FMI %s, co-simulation. All values are in SI "
               "units.</p>\n<ul>\n",
               hawser_version(), version == HAWSER_FMI_2 ? "2.0" : "3.0");
    text_add(
        t, "<li>Steps may have any length; the simulation takes as many of its own as it needs. An input acts from the "
           "next step on, over the time of inputs.ramp: no output depends on an input at the same time.</li>\n"
           "<li>A step that the winch ends before its time is the last one.</li>\n"
           "<li>The parameters below case. are fixed when the initialization ends.</li>\n"
           "<li>A number that does not exist is NaN.</li>\n"
           "<li>The case itself is resources/case.yaml; the licences of what is inside are in "
           "<a href=\"licenses/license.txt\">licenses/license.txt</a>.</li>\n</ul>\n");
    table_write(m, "Inputs", ROLE_INPUT, ROLE_INPUT, t);
    table_write(m, "Outputs", ROLE_OUTPUT, ROLE_OUTPUT, t);
    table_write(m, "Parameters", ROLE_PARAMETER, ROLE_TUNABLE, t);
    text_add(t, "</body></html>\n");
}

/* Letters of a text that needs no quotes, if the first is a letter or digit and the last no blank. */
static const char PLAIN[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ._/+^-";

static void scalar_write(const char *text, Text *out)
{
    const size_t n = strlen(text);
    const int plain =
        n > 0 && strspn(text, PLAIN) == n && strspn(text, PLAIN) > 0 && !strchr(" ._/+^-", *text) && text[n - 1] != ' ';
    if (plain) text_add(out, text);
    if (plain) return;
    text_add(out, "\"");
    for (const char *c = text; *c; ++c) {
        if (*c == '"' || *c == '\\')
            text_print(out, "\\%c", *c);
        else if ((unsigned char)*c < ' ')
            text_print(out, "\\x%02x", (unsigned char)*c);
        else
            text_bytes(out, c, 1);
    }
    text_add(out, "\"");
}

/* Checks for parts that the case no longer needs: its catalogue and the user's files with catalogues. */
static int is_spent(const CaseNode *child)
{
    if (!child->key) return 0;
    if (strcmp(child->key, "include") == 0 && child->parent && !child->parent->parent) return 1;
    return strcmp(child->key, "type") == 0 && child->kind == NODE_TEXT;
}

/* Writes a node with all below it as YAML, each text unchanged: in quotes where it could be taken for something else.
 */
static void yaml_write(const CaseNode *node, int depth, Text *out)
{
    if (node->kind == NODE_TEXT || !node->first) {
        text_add(out, depth > 0 ? " " : "");
        if (node->kind == NODE_TEXT) scalar_write(node->text, out);
        text_add(out, node->kind == NODE_MAP ? "{}\n" : node->kind == NODE_LIST ? "[]\n" : "\n");
        return;
    }
    if (depth > 0) text_add(out, "\n");
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (is_spent(child)) continue;
        text_print(out, "%*s", 2 * depth, "");
        if (child->key) scalar_write(child->key, out);
        text_add(out, child->key ? ":" : "-");
        yaml_write(child, depth + 1, out);
    }
}

/* The case with all parts that it refers to: the catalogue's entries are put into it, files lie beside it. */

/* Keys of a case with files to read: docs/reference/case-keys.md. */
static const char *const file_keys[RESOURCE_FILES_MAX][3] = {
    {"route", "file", NULL}, {"route", "profile", "file"}, {"drawing", "file", NULL}};

/* Adds the file of a node to the resources under a name of its own, and puts that name into the node. */
static hawser_status file_take(const CaseTree *tree, CaseNode *node, Resources *out, hawser_error *err)
{
    const char *const slash = strrchr(node->text, '/'), *const base = slash ? slash + 1 : node->text;
    const int absolute = *node->text == '/';
    ResourceFile *const file = &out->file[out->n];
    const size_t size = strlen(node->text) + strlen(tree->folder ? tree->folder : "") + 16;
    file->path = malloc(size);
    file->name = malloc(size);
    ++out->n;
    if (!file->path || !file->name) return error_memory(err);
    snprintf(file->path, size, "%s%s%s", absolute || !tree->folder ? "" : tree->folder,
             absolute || !tree->folder ? "" : "/", node->text);
    snprintf(file->name, size, "%d-%s", out->n, base);
    char *const name = strdup(file->name);
    if (!name) return error_memory(err);
    free(node->text);
    node->text = name;
    return HAWSER_OK;
}

static hawser_status files_take(const CaseTree *tree, const CaseNode *root, Resources *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < RESOURCE_FILES_MAX && !status; ++i) {
        const CaseNode *node = root;
        for (int k = 0; k < 3 && file_keys[i][k]; ++k) node = case_node_key(node, file_keys[i][k]);
        if (node && node->kind == NODE_TEXT) status = file_take(tree, (CaseNode *)(size_t)node, out, err);
    }
    return status;
}

/* Makes the resources. Errors: INPUT (a name of the catalogue or an included file is wrong), MEMORY. resources_clear
 * must follow. */
static hawser_status resources_make(const CaseTree *tree, Resources *out, hawser_error *err)
{
    CaseNode *root = NULL;
    Library *library = NULL;
    *out = (Resources){.n = 0};
    hawser_status status = library_expand(tree, &root, &library, err);
    if (!status && !root && !(root = node_clone(tree->root, NULL))) status = error_memory(err);
    if (!status) status = files_take(tree, root, out, err);
    if (!status) yaml_write(root, 0, &out->text);
    if (!status && out->text.failed) status = error_memory(err);
    node_free(root);
    library_free(library);
    return status;
}

static void resources_clear(Resources *r)
{
    for (int i = 0; i < r->n; ++i) {
        free(r->file[i].path);
        free(r->file[i].name);
    }
    text_clear(&r->text);
    *r = (Resources){.n = 0};
}

/* An FMU as a file: a zip archive with the description, the library and the resources. The resources are written to a
 * folder first and the case is read from there, so that the packed files are known to work. */

enum { PATH_ROOM = 4096, IDENTIFIER_ROOM = 64 };

/* Memory of libzip and its random numbers, bytes: they do not survive a failed allocation. */
enum { ZIP_ROOM = 4 << 20, ZLIB_NO_MEMORY = -4 };

/* -------------------------------------------------------------------------------------------------- its folder */

static hawser_status file_write(const char *path, const char *bytes, size_t size, hawser_error *err)
{
    errno = 0;
    FILE *const f = fopen(path, "wb");
    int ok = f && fwrite(bytes, 1, size, f) == size;
    if (f && fclose(f)) ok = 0;
    return ok ? HAWSER_OK : out_error(path, errno, err);
}

static hawser_status file_copy(const char *from, const char *to, hawser_error *err)
{
    char *bytes = NULL;
    size_t size;
    hawser_status status = case_file_read(from, &bytes, &size, err);
    if (!status) status = file_write(to, bytes, size, err);
    free(bytes);
    return status;
}

/* Writes a name below a folder; both are short enough. */
static const char *path_below(const char *folder, const char *name, char path[PATH_ROOM])
{
    snprintf(path, PATH_ROOM, "%.2040s/%.2040s", folder, name);
    return path;
}

/* Writes case and files below `folder`, which has space for names behind it. */
static hawser_status resources_lay_out(const Resources *r, const char *folder, hawser_error *err)
{
    char path[PATH_ROOM];
    hawser_status status = file_write(path_below(folder, MODEL_CASE, path), r->text.at, r->text.size, err);
    for (int i = 0; i < r->n && !status; ++i) {
        status = file_copy(r->file[i].path, path_below(folder, r->file[i].name, path), err);
    }
    return status;
}

static void folder_remove(const Resources *r, const char *folder)
{
    char path[PATH_ROOM];
    unlink(path_below(folder, MODEL_CASE, path));
    for (int i = 0; i < r->n; ++i) unlink(path_below(folder, r->file[i].name, path));
    rmdir(folder);
}

/* ------------------------------------------------------------------------------------------------------ the archive */

/* Content of the archive; the bytes or files stay until it is closed. */
typedef struct Packing {
    zip_t *zip;
    hawser_error *err;
    hawser_status status;
} Packing;

/* Reports why a part could not be packed. */
static hawser_status zip_fault(zip_error_t *why, const char *what, const char *name, hawser_error *err)
{
    const int code = zip_error_code_zip(why); /* an archive that was never made has no code */
    const int kind = zip_error_system_type(why), below = zip_error_code_system(why);
    const int lacks = (kind == ZIP_ET_SYS && below == ENOMEM) || (kind == ZIP_ET_ZLIB && below == ZLIB_NO_MEMORY);
    if (lacks || code == ZIP_ER_MEMORY || code == ZIP_ER_OK) return error_memory(err);
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot %s '%.600s': %s", what, name, zip_error_strerror(why));
}

/* Adds a source under a name; all have the same date, so that two archives of the same case are equal. libzip
 * compresses as far as possible by default: a sixth of the time makes them 7 % larger. */
static void source_add(Packing *p, const char *name, zip_source_t *source)
{
    static const time_t date = 631152000; /* 1990-01-01 */
    static const zip_uint32_t effort = 3; /* of 9 */
    if (p->status) {
        zip_source_free(source);
        return;
    }
    const zip_int64_t at = source ? zip_file_add(p->zip, name, source, ZIP_FL_ENC_UTF_8) : -1;
    const zip_uint64_t entry = (zip_uint64_t)at;
    if (at >= 0 && !zip_file_set_mtime(p->zip, entry, date, 0) &&
        !zip_set_file_compression(p->zip, entry, ZIP_CM_DEFLATE, effort))
        return;
    if (at < 0) zip_source_free(source);
    p->status = zip_fault(zip_get_error(p->zip), "pack", name, p->err);
}

static void text_pack(Packing *p, const char *name, const Text *text)
{
    source_add(p, name, zip_source_buffer(p->zip, text->at, text->size, 0));
}

static void file_pack(Packing *p, const char *name, const char *path)
{
    source_add(p, name, zip_source_file(p->zip, path, 0, -1));
}

/* Packs all parts of an archive whose model has been made from the resources in `folder`. */
static hawser_status parts_pack(const char *path, hawser_fmi version, const char *identifier, const char *library,
                                const Resources *r, const char *folder, const Text *description, const Text *page,
                                hawser_error *err)
{
    char name[PATH_ROOM], from[PATH_ROOM];
    const char *const slash = strrchr(library, '/');
    int code = 0;
    if (!memory_room(ZIP_ROOM)) return error_memory(err);
    Packing p = {.zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, &code), .err = err};
    if (!p.zip) {
        zip_error_t why;
        zip_error_init_with_code(&why, code);
        const hawser_status status = zip_fault(&why, "write", path, err);
        zip_error_fini(&why);
        return status;
    }
    text_pack(&p, "modelDescription.xml", description);
    snprintf(name, sizeof name, "binaries/%s/%s.so", version == HAWSER_FMI_2 ? "linux64" : "x86_64-linux", identifier);
    file_pack(&p, name, library);
    text_pack(&p, "documentation/index.html", page);
    snprintf(from, sizeof from, "%.*slicences.txt", slash ? (int)(slash + 1 - library) : 0, library);
    file_pack(&p, "documentation/licenses/license.txt", from);
    text_pack(&p, "resources/" MODEL_CASE, &r->text);
    for (int i = 0; i < r->n; ++i) {
        file_pack(&p, path_below("resources", r->file[i].name, name), path_below(folder, r->file[i].name, from));
    }
    if (!p.status && zip_close(p.zip) == 0) return HAWSER_OK;
    if (!p.status) p.status = zip_fault(zip_get_error(p.zip), "write", path, err);
    zip_discard(p.zip);
    return p.status;
}

/* ------------------------------------------------------------------------------------------------------ the request */

/* Makes an identifier of C: "cases/3 ducts.yaml" -> "case_3_ducts". */
static void identifier_make(const char *case_name, char identifier[IDENTIFIER_ROOM])
{
    const char *const slash = strrchr(case_name, '/'), *const base = slash ? slash + 1 : case_name;
    const char *const dot = strrchr(base, '.');
    const int length = (int)(dot && dot > base ? dot - base : (long)strlen(base));
    snprintf(identifier, IDENTIFIER_ROOM, "%s%.*s", isalpha((unsigned char)*base) ? "" : "case_", length, base);
    for (char *c = identifier; *c; ++c) {
        if (!isalnum((unsigned char)*c)) *c = '_';
    }
}

/* Writes the archive, with the resources in a folder. */
static hawser_status archive_write(const hawser_case *c, const Resources *r, const char *folder, hawser_fmi version,
                                   const char *path, hawser_error *err)
{
    char identifier[IDENTIFIER_ROOM];
    Model model = {0};
    Text description = {0}, page = {0};
    char *const library = shipped_find(HAWSER_FMU_PLACE);
    hawser_status status = HAWSER_OK;
    if (!library)
        status = error_set(err, HAWSER_ERR_INPUT, "the library for archives, %s, is not beside the program",
                           HAWSER_FMU_PLACE);
    if (!status) status = resources_lay_out(r, folder, err);
    if (!status) status = model_load(folder, &model, NULL, err);
    identifier_make(c->name, identifier);
    const char *const title = *c->def->title ? c->def->title : identifier;
    if (!status) description_write(&model, version, title, identifier, &description);
    if (!status) documentation_write(&model, version, title, &page);
    if (!status && (description.failed || page.failed)) status = error_memory(err);
    if (!status) status = parts_pack(path, version, identifier, library, r, folder, &description, &page, err);
    text_clear(&page);
    text_clear(&description);
    model_clear(&model);
    free(library);
    return status;
}

hawser_status hawser_fmu_write(hawser_case *c, hawser_fmi version, const char *path, hawser_error *err)
{
    char folder[PATH_ROOM];
    const char *const temporary = getenv("TMPDIR");
    Resources r = {.n = 0};
    if (!c) return error_argument(err, "c");
    if (!path || !*path) return error_argument(err, "path");
    if (version != HAWSER_FMI_2 && version != HAWSER_FMI_3)
        return error_set(err, HAWSER_ERR_INPUT, "version %d of FMI: 2 or 3 can be written", (int)version);
    hawser_status status = case_ensure_read(c, err); /* reports errors with the user's own files */
    if (!status) status = file_marks_spare(&c->def->files, path, err);
    if (!status) status = resources_make(c->tree, &r, err);
    snprintf(folder, sizeof folder, "%.2000s/hawser-XXXXXX", temporary && *temporary ? temporary : "/tmp");
    if (!status && !mkdtemp(folder))
        status = error_set(err, HAWSER_ERR_OUTPUT, "cannot make a folder like '%.800s': %s", folder, strerror(errno));
    if (!status) {
        status = archive_write(c, &r, folder, version, path, err);
        folder_remove(&r, folder);
    }
    resources_clear(&r);
    return status;
}
