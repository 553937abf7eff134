/* docs/case-format.md says the same as the tables that the reader works from: every section, every key with
 * value, default and range, every unit, and nothing else. With HAWSER_PRINT in the environment it prints the tables
 * as they should be. */
#include "tests/io/case_fixture.h"

#include "io/case/case_parts.h"

enum { CELL_MAX = 400, ROW_MAX = 2000 };

static void value_cell(const CaseKey *key, char *cell)
{
    switch (key->kind) {
    case KEY_NUMBER:
        snprintf(cell, CELL_MAX, "%s", dimension_name(key->dimension));
        break;
    case KEY_INTEGER:
        snprintf(cell, CELL_MAX, "a whole number");
        break;
    case KEY_FLAG:
        snprintf(cell, CELL_MAX, "`true` or `false`");
        break;
    case KEY_CHOICE:
        snprintf(cell, CELL_MAX, "a word");
        break;
    case KEY_TEXT:
        snprintf(cell, CELL_MAX, "a text");
        break;
    case KEY_POINT:
        snprintf(cell, CELL_MAX, "[x, y, z], each %s", dimension_name(key->dimension));
        break;
    case KEY_SECTION:
    case KEY_MAP:
        snprintf(cell, CELL_MAX, "a map");
        break;
    case KEY_LIST:
        snprintf(cell, CELL_MAX, "a list");
        break;
    case KEY_ANY:
        snprintf(cell, CELL_MAX, "%s", key->form);
        break;
    }
}

static void default_cell(const CaseKey *key, char *cell)
{
    if (key->required) {
        snprintf(cell, CELL_MAX, "required");
    } else if (!key->fallback) {
        snprintf(cell, CELL_MAX, "%s", key->otherwise);
    } else if (*key->fallback) {
        snprintf(cell, CELL_MAX, "`%s`", key->fallback);
    } else {
        snprintf(cell, CELL_MAX, "empty");
    }
}

static void allowed_cell(const CaseKey *key, char *cell)
{
    char range[CASE_RANGE_MAX], form[CASE_FORM_MAX];
    strcpy(cell, "-");
    if (key->min < key->max) snprintf(cell, CELL_MAX, "%s", case_range_text(key, range));
    if (key->kind == KEY_TEXT) snprintf(cell, CELL_MAX, "at most %zu characters", key->size - 1);
    if (key->kind == KEY_LIST || key->kind == KEY_MAP || key->kind == KEY_SECTION) {
        snprintf(cell, CELL_MAX, "%s", case_form_text(key, form));
    }
    if (key->kind != KEY_CHOICE) return;
    size_t n = 0;
    for (int k = 0; key->choices[k]; k++) {
        n += (size_t)snprintf(cell + n, CELL_MAX - n, "%s`%s`", k ? ", " : "", key->choices[k]);
    }
}

/* The beginning of a key's row, up to where its meaning follows. */
static void row_begin(const CaseKey *key, char *row)
{
    char value[CELL_MAX], otherwise[CELL_MAX], allowed[CELL_MAX];
    value_cell(key, value);
    default_cell(key, otherwise);
    allowed_cell(key, allowed);
    snprintf(row, ROW_MAX, "| `%s` | %s | %s | %s |", key->name, value, otherwise, allowed);
}

static void heading(const CaseSection *section, char *line)
{
    snprintf(line, CELL_MAX, "### %s%s%s", *section->path ? "`" : "", *section->path ? section->path : "The whole case",
             *section->path ? "`" : "");
}

static int print(void)
{
    char text[ROW_MAX];
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&case_top, all, 0);
    for (const CaseSection **s = all; s < all + n; s++) {
        heading(*s, text);
        printf("%s\n\n| key | value | default | allowed | meaning |\n|---|---|---|---|---|\n", text);
        for (int k = 0; k < (*s)->n; k++) {
            row_begin(&(*s)->key[k], text);
            printf("%s\n", text);
        }
        printf("\n");
    }
    return 0;
}

static char *document(void)
{
    FILE *f = fopen(HAWSER_SOURCE_DIR "/docs/case-format.md", "r");
    assert_non_null(f);
    char *text = calloc(1, 1 << 18);
    assert_non_null(text);
    const size_t n = fread(text, 1, (1 << 18) - 1, f);
    assert_in_range(n, 1000, (1 << 18) - 2);
    fclose(f);
    return text;
}

/* The part of the document under a section's heading, in `part`. */
static void part_of(const char *doc, const CaseSection *section, char *part, size_t room)
{
    char line[CELL_MAX];
    heading(section, line);
    strcat(line, "\n");
    const char *start = strstr(doc, line);
    if (!start) fail_msg("no heading '%s'", line);
    start += strlen(line);
    const char *end = strstr(start, "\n#");
    const size_t n = end ? (size_t)(end - start) + 1 : strlen(start);
    check_below(n, room);
    memcpy(part, start, n);
    part[n] = 0;
}

static int rows_in(const char *part)
{
    int rows = 0;
    for (const char *p = strstr(part, "\n| `"); p; p = strstr(p + 1, "\n| `")) rows++;
    return rows;
}

TEST(every_key_is_documented)
{
    static char part[1 << 15];
    char *doc = document(), row[ROW_MAX];
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&case_top, all, 0);
    for (const CaseSection **s = all; s < all + n; s++) {
        part_of(doc, *s, part, sizeof part);
        for (int k = 0; k < (*s)->n; k++) {
            row_begin(&(*s)->key[k], row);
            const char *found = strstr(part, row);
            if (!found) fail_msg("section '%s': no row that begins '%s'", (*s)->path, row);
            const size_t meaning = strcspn(found + strlen(row), "|\n");
            if (meaning < 8) fail_msg("section '%s': '%s' has no meaning", (*s)->path, row);
        }
        assert_int_equal(rows_in(part), (*s)->n);
    }
    free(doc);
}

TEST(every_section_is_known)
{
    char *doc = document(), line[CELL_MAX];
    int headings = 0, sections = 0;
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&case_top, all, 0);
    for (const CaseSection **s = all; s < all + n; s++) {
        heading(*s, line);
        check_has(doc, line);
        sections++;
    }
    for (const char *p = strstr(doc, "\n### "); p; p = strstr(p + 1, "\n### ")) headings++;
    assert_int_equal(headings, sections);
    free(doc);
}

TEST(every_unit_is_documented)
{
    char *doc = document(), name[40];
    const char *start = strstr(doc, "## Units"), *end = strstr(start, "\n## ");
    assert_non_null(start);
    assert_non_null(end);
    doc[end - doc] = 0;
    for (int i = 0; i < units_count(); i++) {
        snprintf(name, sizeof name, "`%s`", units_name(i));
        if (!strstr(start, name)) fail_msg("unit %s is not documented", name);
    }
    for (const char *const *p = units_prefixes(); *p; p++) {
        snprintf(name, sizeof name, "`%s`", *p);
        if (!strstr(start, name)) fail_msg("prefix %s is not documented", name);
    }
    free(doc);
}

/* The examples in the documentation's dimension table are read as what they stand for. */
TEST(every_dimension_is_documented)
{
    char *doc = document(), row[200];
    for (int d = 0; d < DIM_COUNT; d++) {
        snprintf(row, sizeof row, "| %s | `%s` | `%s` |", dimension_name((Dimension)d), dimension_unit((Dimension)d),
                 dimension_example((Dimension)d));
        if (!strstr(doc, row)) fail_msg("no row '%s'", row);
    }
    free(doc);
}

static int print_if_required(void **state)
{
    (void)state;
    return getenv("HAWSER_PRINT") ? print() : 0;
}

TEST_GROUP(print_if_required, NULL)
