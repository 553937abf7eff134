/* docs/reference/case-keys.md is made here from the tables that the reader works from and from io/case/key_words.c;
 * so are its units. */
#include <stdarg.h>

#include "tests/io/case_fixture.h"

#include "io/case/case_parts.h"
#include "tests/support/scratch.h"

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

/* Text that grows at the end of `room` bytes. */
typedef struct Page {
    char *text;
    size_t n, room;
} Page;

static void page_add(Page *page, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const int n = vsnprintf(page->text + page->n, page->room - page->n, format, list);
    va_end(list);
    page->n += (size_t)n;
    check_below(page->n, page->room);
}

/* The meaning with vertical bars that do not end the cell. */
static void meaning_cell(const char *meaning, char *cell)
{
    for (; *meaning; *cell++ = *meaning++)
        if (*meaning == '|') *cell++ = '\\';
    *cell = 0;
}

/* Kinds of value, units and prefixes, as the reader of quantities knows them. */
static void units_add(Page *page)
{
    page_add(page, "\n## Units\n\n| kind | SI unit | example |\n|---|---|---|\n");
    for (int d = 0; d < DIM_COUNT; d++)
        page_add(page, "| %s | `%s` | `%s` |\n", dimension_name((Dimension)d), dimension_unit((Dimension)d),
                 dimension_example((Dimension)d));
    page_add(page, "\nUnits:");
    for (int i = 0; i < units_count(); i++) page_add(page, "%s `%s`", i ? "," : "", units_name(i));
    page_add(page, ".\n\nPrefixes:");
    for (const char *const *p = units_prefixes(); *p; p++)
        page_add(page, "%s `%s`", p > units_prefixes() ? "," : "", *p);
    page_add(page,
             ". American units take `k` alone, since M is a thousand in `MCM` and `Mft`. A blank, `*`, `.` or `·` "
             "makes a product, `/` a quotient. Powers are `mm2`, `mm²`, `mm^2` or `s-1`.\n");
}

TEST(the_reference_of_keys_is_current)
{
    char row[ROW_MAX], cell[ROW_MAX];
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&case_top, all, 0);
    Page page = {.text = malloc(1 << 18), .room = 1 << 18};
    assert_non_null(page.text);
    page_add(&page, "# Keys of a case\n\n"
                    "Every section of a case with its keys; [case files](../case-format.md) explains values and "
                    "settings, [units](#units) are below. "
                    "In the\nheadings NAME stands for a name that you choose and N for an item's number in its list. "
                    "\"Default\" is the meaning of\nan absent key; \"allowed\" is checked. This page is made from the "
                    "program's tables.\n");
    for (const CaseSection **s = all; s < all + n; s++) {
        heading(*s, row);
        page_add(&page, "\n#%s\n\n", row + 2);
        if (*case_section_note(*s)) page_add(&page, "%s\n\n", case_section_note(*s));
        page_add(&page, "| key | value | default | allowed | meaning |\n|---|---|---|---|---|\n");
        for (int k = 0; k < (*s)->n; k++) {
            const char *const meaning = case_key_meaning(*s, &(*s)->key[k], LANGUAGE_ENGLISH);
            if (strlen(meaning) < 8)
                fail_msg("io/case/key_words.c: '%s.%s' has no meaning", (*s)->path, (*s)->key[k].name);
            row_begin(&(*s)->key[k], row);
            meaning_cell(meaning, cell);
            page_add(&page, "%s %s |\n", row, cell);
        }
    }
    units_add(&page);
    check_reference("docs/reference/case-keys.md", page.text);
    free(page.text);
}

/* Chinese is beyond ASCII; German is no English and no Chinese. */
TEST(every_key_has_its_meaning_in_all_languages)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&case_top, all, 0);
    for (const CaseSection **s = all; s < all + n; s++)
        for (int k = 0; k < (*s)->n; k++) {
            const CaseKey *const key = &(*s)->key[k];
            const char *const english = case_key_meaning(*s, key, LANGUAGE_ENGLISH);
            const char *const chinese = case_key_meaning(*s, key, LANGUAGE_CHINESE);
            const char *const german = case_key_meaning(*s, key, LANGUAGE_GERMAN);
            int beyond = 0, chinese_in_german = 0;
            for (const char *c = chinese; *c; ++c) beyond += (unsigned char)*c >= 0xe4;
            for (const char *c = german; *c; ++c) chinese_in_german += (unsigned char)*c >= 0xe3;
            if (!beyond || !*german || chinese_in_german || (!strcmp(english, german) && strlen(english) > 9))
                fail_msg("io/case/key_words.c: '%s.%s' lacks a language", (*s)->path, key->name);
        }
}
