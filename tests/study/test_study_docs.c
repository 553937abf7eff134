/* docs/reference/study-keys.md and job-keys.md are made here from the tables that the readers work from: every section,
 * and every key with its default, what is allowed, and its meaning. HAWSER_WRITE=1 writes them. */
#include "io/api/api_handles.h"
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

/* Compares the page with the file, or writes it. */
static void check_keys(const CaseSection *top, const char *intro, const char *path)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int n = case_sections(top, all, 0);
    char *page = NULL;
    size_t size;
    FILE *const f = open_memstream(&page, &size);
    assert_non_null(f);
    fprintf(f, "%s This page is made from the program's tables.\n", intro);
    for (int i = 0; i < n; i++) {
        fprintf(f, *all[i]->path ? "\n## `%s`\n" : "\n## The whole file\n%s", all[i]->path);
        fputs("\n| key | default | allowed | meaning |\n|---|---|---|---|\n", f);
        for (int k = 0; k < all[i]->n; k++) {
            const CaseKey *const key = &all[i]->key[k];
            char usual[CELL_MAX], allowed[CELL_MAX] = "";
            default_cell(key, usual);
            allowed_cell(key, allowed);
            if (!key->meaning) fail_msg("'%s.%s' has no meaning", all[i]->path, key->name);
            fprintf(f, "| `%s` | %s | %s | %s |\n", key->name, usual, allowed, key->meaning);
        }
    }
    fclose(f);
    check_reference(path, page);
    free(page);
}

TEST(the_reference_of_study_keys_is_current)
{
    check_keys(
        &study_top,
        "# Keys of a study\n\nEvery section of a study's file with its keys; "
        "[studies](../guide/studies-and-measured-pulls.md) explains them.\nNAME stands for a name that you choose "
        "and N for an item's number in its list. \"Default\" is the meaning of an\nabsent key; \"allowed\" is "
        "checked. A parameter has one of the keys beside `key`: a law; in a grid `values` or\n`steps`; in a search "
        "`range`, `whole`, `values` or `steps`; with a `list` none.",
        "docs/reference/study-keys.md");
}

TEST(the_reference_of_job_keys_is_current)
{
    check_keys(
        &job_top,
        "# Keys of a job\n\nEvery section of a job's file with its keys; [jobs](../guide/jobs-and-sheets.md) "
        "explains them. N stands for an item's number\nin its list. \"Default\" is the meaning of an absent key; "
        "\"allowed\" is checked. Further keys of a pull are keys of a case.",
        "docs/reference/job-keys.md");
}
