#include "survey/step.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/error.h"

enum { NESTING_MOST = 32, VALUES_MOST = 1 << 24 };
#define SIZE_MOST ((size_t)1 << 30)

static const StepValue nothing = {0};

/* ------------------------------------------------------------------------------------------------------ characters */

/* Skips blanks and comments. */
static const char *blanks(const char *c)
{
    for (;;) {
        while (isspace((unsigned char)*c)) ++c;
        if (c[0] != '/' || c[1] != '*') return c;
        const char *const end = strstr(c + 2, "*/");
        if (!end) return c + strlen(c);
        c = end + 2;
    }
}

/* Skips a text in single quotes, in which two quotes are one; c is at the first quote. */
static const char *behind_quotes(const char *c)
{
    for (++c; *c && (*c != '\'' || c[1] == '\''); ++c) {
        if (*c == '\'') ++c;
    }
    return *c ? c + 1 : c;
}

/* Skips a statement with its semicolon; NULL: there is none. */
static const char *behind_statement(const char *c)
{
    while (*c && *c != ';') {
        if (*c == '\'')
            c = behind_quotes(c);
        else if (c[0] == '/' && c[1] == '*')
            c = blanks(c);
        else
            ++c;
    }
    return *c ? c + 1 : NULL;
}

/* Line of the file at a place. */
static long line_of(const StepFile *file, const char *at)
{
    long line = 1;
    for (const char *c = file->text; c < at; ++c) line += *c == '\n';
    return line;
}

/* --------------------------------------------------------------------------------------------------------- the file */

static hawser_status text_read(StepFile *file)
{
    SurveyInput *const in = file->in;
    struct stat state;
    if (fstat(fileno(in->file), &state)) return input_error(in, "cannot be read: %s", strerror(errno));
    if ((size_t)state.st_size > SIZE_MOST) return input_error(in, "larger than 1 GiB");
    file->text = malloc((size_t)state.st_size + 1);
    if (!file->text) return error_memory(in->err);
    file->size = fread(file->text, 1, (size_t)state.st_size, in->file);
    file->text[file->size] = 0;
    if (strlen(file->text) < file->size) {
        in->line = line_of(file, file->text + strlen(file->text));
        return input_error(in, "a character 0: this is no STEP file");
    }
    return HAWSER_OK;
}

/* Reads the name in FILE_SCHEMA (('IFC4X3')). */
static void schema_read(StepFile *file)
{
    const char *const at = strstr(file->text, "FILE_SCHEMA"), *const quote = at ? strchr(at, '\'') : NULL;
    if (quote) snprintf(file->schema, sizeof file->schema, "%.*s", (int)strcspn(quote + 1, "'"), quote + 1);
}

static int by_id(const void *a, const void *b)
{
    const StepEntry *const p = a, *const q = b;
    return (p->id > q->id) - (p->id < q->id);
}

static hawser_status entry_add(StepFile *file, long id, const char *name)
{
    if (file->n >= SURVEY_MOST) return input_error(file->in, "more than %d entities", SURVEY_MOST);
    StepEntry *const entry = survey_one_more(&file->entry, &file->n, sizeof *entry);
    if (!entry) return error_memory(file->in->err);
    *entry = (StepEntry){id, (size_t)(name - file->text)};
    return HAWSER_OK;
}

/* Finds the entries "#12 = NAME(...);" between DATA; and ENDSEC; */
static hawser_status entries_find(StepFile *file)
{
    const char *c = strstr(file->text, "DATA;");
    hawser_status status = HAWSER_OK;
    if (!c) return input_error(file->in, "no section DATA");
    for (c = blanks(c + 5); *c == '#' && !status; c = blanks(c)) {
        char *end;
        const long id = strtol(c + 1, &end, 10);
        const char *const equals = blanks(end), *const behind = behind_statement(equals);
        if (end == c + 1 || id <= 0 || *equals != '=' || !behind) {
            file->in->line = line_of(file, c);
            return input_error(file->in, "expected #number = ENTITY(...);");
        }
        status = entry_add(file, id, blanks(equals + 1));
        c = behind;
    }
    if (!status && strncmp(c, "ENDSEC", 6)) {
        file->in->line = line_of(file, c);
        return input_error(file->in, "expected an entity or ENDSEC;");
    }
    if (!status && file->n) qsort(file->entry, (size_t)file->n, sizeof *file->entry, by_id);
    return status;
}

hawser_status step_open(StepFile *file, SurveyInput *in)
{
    *file = (StepFile){.in = in};
    hawser_status status = text_read(file);
    if (!status) schema_read(file);
    return status ? status : entries_find(file);
}

void step_close(StepFile *file)
{
    free(file->text);
    free(file->entry);
    *file = (StepFile){0};
}

/* ---------------------------------------------------------------------------------------------------------- values */

/* An entity being parsed. */
typedef struct Parser {
    const StepFile *file;
    const char *c;
    StepEntity *out;
    hawser_status status;
} Parser;

static void fail(Parser *p, const char *what)
{
    if (p->status) return;
    p->file->in->line = line_of(p->file, p->c);
    p->status = input_error(p->file->in, "#%ld: %s", p->out->id, what);
}

/* Adds a value; returns its place, -1: no memory. */
static int value_add(Parser *p)
{
    StepEntity *const e = p->out;
    if (e->n == e->room) {
        const int room = e->room ? 2 * e->room : 32;
        StepValue *const wider = room <= VALUES_MOST ? realloc(e->value, (size_t)room * sizeof *wider) : NULL;
        if (!wider) {
            p->status = error_memory(p->file->in->err);
            return -1;
        }
        e->value = wider;
        e->room = room;
    }
    e->value[e->n] = nothing;
    return e->n++;
}

/* Parses a text between marks, which do not occur inside a word. */
static void text_parse(Parser *p, StepValue *v, StepKind kind)
{
    const char *const end = kind == STEP_TEXT ? behind_quotes(p->c) : strchr(p->c + 1, '.');
    if (!end || end - p->c < 2 || end - p->c > 1 << 20) {
        fail(p, "a text without an end");
        return;
    }
    *v = (StepValue){.kind = kind, .text = p->c + 1, .next = v->next};
    v->length = (int)(end - v->text) - (kind == STEP_TEXT);
    p->c = kind == STEP_TEXT ? end : end + 1;
}

static int list_parse(Parser *p, int depth);

/* Parses TYPE(value) as the value; for a number or a list the type's name is its text. */
static int typed_parse(Parser *p, int depth)
{
    const char *const name = p->c;
    while (isalnum((unsigned char)*p->c) || *p->c == '_') ++p->c;
    const int length = (int)(p->c - name);
    p->c = blanks(p->c);
    if (*p->c != '(' || depth >= NESTING_MOST || length > 1000) return fail(p, "expected TYPE(value)"), -1;
    const int list = list_parse(p, depth + 1), item = list < 0 ? 0 : p->out->value[list].first;
    if (item && (p->out->value[item].kind == STEP_NUMBER || p->out->value[item].kind == STEP_LIST)) {
        p->out->value[item].text = name;
        p->out->value[item].length = length;
    }
    return item ? item : list;
}

/* Parses the value at p->c; returns its place, or -1. */
static int value_parse(Parser *p, int depth)
{
    char *end;
    p->c = blanks(p->c);
    if (isalpha((unsigned char)*p->c)) return typed_parse(p, depth);
    if (*p->c == '(') {
        if (depth >= NESTING_MOST) return fail(p, "values nested too deep"), -1;
        return list_parse(p, depth + 1);
    }
    const int place = value_add(p);
    if (place < 0) return -1;
    StepValue *const v = &p->out->value[place];
    if (*p->c == '$' || *p->c == '*') {
        ++p->c;
    } else if (*p->c == '\'') {
        text_parse(p, v, STEP_TEXT);
    } else if (*p->c == '"') { /* binary value */
        const char *const stop = strchr(p->c + 1, '"');
        p->c = stop ? stop + 1 : p->c + strlen(p->c);
    } else if (*p->c == '#') {
        v->kind = STEP_REFERENCE;
        v->reference = strtol(p->c + 1, &end, 10);
        p->c = end;
    } else if (*p->c == '.' && isalpha((unsigned char)p->c[1])) {
        text_parse(p, v, STEP_WORD);
    } else if (input_number(p->file->in, p->c, &end, &v->number)) {
        v->kind = STEP_NUMBER;
        p->c = end;
    } else {
        fail(p, "expected a value");
    }
    return p->status ? -1 : place;
}

/* Parses a list, p->c at its bracket; returns its place, or -1. */
static int list_parse(Parser *p, int depth)
{
    const int place = value_add(p);
    int last = 0;
    if (place < 0) return -1;
    p->out->value[place].kind = STEP_LIST;
    p->c = blanks(p->c + 1);
    while (*p->c != ')') {
        const int item = value_parse(p, depth);
        if (item < 0) return -1;
        if (last)
            p->out->value[last].next = item;
        else
            p->out->value[place].first = item;
        last = item;
        p->c = blanks(p->c);
        if (*p->c == ',')
            p->c = blanks(p->c + 1);
        else if (*p->c != ')')
            return fail(p, "expected , or )"), -1;
    }
    ++p->c;
    return place;
}

/* Index of the entry with this number; -1: none. */
static int entry_of(const StepFile *file, long id)
{
    int low = 0, high = file->n - 1;
    while (low <= high) {
        const int middle = low + (high - low) / 2;
        if (file->entry[middle].id == id) return middle;
        if (file->entry[middle].id < id)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}

/* Reads the name at a place, in capitals; returns what follows. */
static const char *name_read(const char *c, char *name, size_t size)
{
    size_t n = 0;
    for (; isalnum((unsigned char)*c) || *c == '_'; ++c) {
        if (n + 1 < size) name[n++] = (char)toupper((unsigned char)*c);
    }
    name[n] = 0;
    return blanks(c);
}

hawser_status step_entity(const StepFile *file, long id, StepEntity *out)
{
    const int entry = entry_of(file, id);
    out->id = id;
    out->n = 0;
    file->in->line = 0;
    if (entry < 0) return input_error(file->in, "#%ld is not in the file", id);
    Parser p = {.file = file, .c = file->text + file->entry[entry].at, .out = out};
    p.c = name_read(p.c, out->name, sizeof out->name);
    if (*p.c != '(' || !*out->name)
        fail(&p, "expected ENTITY(...)");
    else
        list_parse(&p, 0);
    return p.status;
}

void step_entity_free(StepEntity *e)
{
    free(e->value);
    *e = (StepEntity){0};
}

int step_next(const StepFile *file, int from, const char *name)
{
    char found[64];
    for (int i = from; i < file->n; ++i) {
        name_read(file->text + file->entry[i].at, found, sizeof found);
        if (!strcmp(found, name)) return i;
    }
    return -1;
}

const StepValue *step_item(const StepEntity *e, const StepValue *list, int i)
{
    if (list->kind != STEP_LIST || !list->first) return NULL;
    int place = list->first;
    for (; i > 0 && place; --i) place = e->value[place].next;
    return place ? &e->value[place] : NULL;
}

const StepValue *step_behind(const StepEntity *e, const StepValue *item)
{
    return item->next ? &e->value[item->next] : NULL;
}

const StepValue *step_attribute(const StepEntity *e, int i)
{
    const StepValue *const item = e->n ? step_item(e, &e->value[0], i) : NULL;
    return item ? item : &nothing;
}

double step_number(const StepEntity *e, int i)
{
    const StepValue *const v = step_attribute(e, i);
    return v->kind == STEP_NUMBER ? v->number : NAN;
}

long step_reference(const StepEntity *e, int i)
{
    const StepValue *const v = step_attribute(e, i);
    return v->kind == STEP_REFERENCE ? v->reference : 0;
}

/* Decodes one escape at c; returns its end, or NULL if there is none. */
static const char *escape_put(const char *c, const char *end, char *out, size_t *n, size_t size)
{
    const int wide = end - c > 3 && c[1] == 'X' && (c[2] == '2' || c[2] == '4') && c[3] == '\\' ? (c[2] - '0') * 2 : 0;
    if (end - c > 3 && c[1] == 'S' && c[2] == '\\')
        return *n += input_utf8(out + *n, 0x80u + (unsigned char)c[3]), c + 4;
    if (end - c > 4 && c[1] == 'X' && c[2] == '\\') return *n += input_utf8(out + *n, input_hex(c + 3, 2)), c + 5;
    if (end - c > 1 && c[1] == '\\') return out[(*n)++] = '\\', c + 2;
    if (!wide) return NULL;
    for (c += 4; end - c >= wide && *c != '\\' && *n + 5 < size; c += wide) {
        const unsigned character = input_hex(c, wide);
        *n += input_utf8(out + *n, character ? character : '?');
    }
    return end - c >= 4 && !strncmp(c, "\\X0\\", 4) ? c + 4 : end;
}

void step_text(const StepValue *value, char *out, size_t size)
{
    const char *c = value->kind == STEP_TEXT ? value->text : "", *const end = c + (*c ? value->length : 0);
    size_t n = 0;
    while (c < end && n + 5 < size) {
        const char *const behind = *c == '\\' ? escape_put(c, end, out, &n, size) : NULL;
        if (behind) {
            c = behind;
            continue;
        }
        out[n++] = *c;
        c += *c == '\'' && end - c > 1 && c[1] == '\'' ? 2 : 1;
    }
    out[n] = 0;
}

int step_is(const StepValue *value, const char *word)
{
    return value->kind != STEP_NONE && value->text && (int)strlen(word) == value->length &&
           !strncmp(value->text, word, (size_t)value->length);
}
