/* docs/reference/study-keys.md says the same as the tables that the reader works from: every section, and every key
 * with its default and what is allowed. */
#include "tests/study/study_fixture.h"

enum { CELL_MAX = 300 };

static void default_cell(const CaseKey *key, char *cell)
{
    if (key->required) {
        snprintf(cell, CELL_MAX, "required");
    } else if (!key->fallback) {
        snprintf(cell, CELL_MAX, "%s", key->otherwise);
    } else {
        snprintf(cell, CELL_MAX, *key->fallback ? "`%s`" : "empty", key->fallback);
    }
}

static void allowed_cell(const CaseKey *key, char *cell)
{
    char text[CASE_RANGE_MAX + CASE_FORM_MAX];
    size_t n = 0;
    if (key->min < key->max) snprintf(cell, CELL_MAX, "%s", case_range_text(key, text));
    if (key->kind == KEY_FLAG) snprintf(cell, CELL_MAX, "`true` or `false`");
    if (key->kind == KEY_TEXT) snprintf(cell, CELL_MAX, "at most %zu characters", key->size - 1);
    if (key->section) snprintf(cell, CELL_MAX, "section `%s`", key->section->path);
    if (!key->section && key->form) snprintf(cell, CELL_MAX, "%s", key->form);
    for (int k = 0; key->choices && key->choices[k]; k++) {
        n += (size_t)snprintf(cell + n, CELL_MAX - n, "%s`%s`", k ? ", " : "", key->choices[k]);
    }
}

TEST(documented)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(&study_top, all, 0);
    size_t size;
    char *text;
    hawser_error err;
    assert_int_equal(case_file_read(HAWSER_SOURCE_DIR "/docs/reference/study-keys.md", &text, &size, &err), HAWSER_OK);
    check_at_least(n, 12);
    for (int i = 0; i < n; i++) {
        char heading[CELL_MAX];
        snprintf(heading, sizeof heading, *all[i]->path ? "### `%s`\n" : "### The whole file\n%s", all[i]->path);
        char *const from = strstr(text, heading);
        if (!from) {
            fail_msg("docs/reference/study-keys.md has no section %s", heading);
            break;
        }
        char *const next = strstr(from + 4, "\n#"), *const end = next ? next : strchr(from, 0);
        const char kept = *end;
        *end = 0;
        int rows = 0;
        for (const char *row = strstr(from, "\n| `"); row; row = strstr(row + 1, "\n| `")) rows++;
        assert_int_equal(rows, all[i]->n);
        for (int k = 0; k < all[i]->n; k++) {
            const CaseKey *const key = &all[i]->key[k];
            char usual[CELL_MAX], allowed[CELL_MAX] = "", row[3 * CELL_MAX];
            default_cell(key, usual);
            allowed_cell(key, allowed);
            snprintf(row, sizeof row, "\n| `%s` | %s | %s | ", key->name, usual, allowed);
            if (!strstr(from, row)) fail_msg("docs/reference/study-keys.md lacks in '%s':%s", all[i]->path, row);
        }
        *end = kept;
    }
    free(text);
}
