/* docs/reference/results.md says the same as the tables that the writers go over: every column and set with its unit,
 * every key of summary.json, and in the tables of CSV columns nothing else. */
#include <stdlib.h>
#include <string.h>

#include "io/results/results_file.h"
#include "sim/room.h"
#include "tests/support/check.h"

enum { PART_MAX = 1 << 16, NAME_ROOM = 200, ROW_ROOM = 4000 };

/* The document's part under a heading. */
static void part_of(const char *heading, char part[PART_MAX])
{
    static char doc[1 << 18];
    FILE *f = fopen(HAWSER_SOURCE_DIR "/docs/reference/results.md", "r");
    assert_non_null(f);
    const size_t n = fread(doc, 1, sizeof doc - 1, f);
    fclose(f);
    doc[n] = 0;
    const char *start = strstr(doc, heading);
    assert_non_null(start);
    start += strlen(heading);
    const char *end = strstr(start, "\n## ");
    snprintf(part, PART_MAX, "%.*s", end ? (int)(end - start) : (int)strlen(start), start);
}

/* The unit that a column's name ends with; "" for none. */
static const char *unit_of(const char *name)
{
    static const char *const units[][2] = {{"_N_per_m", "N/m"}, {"_m_per_s", "m/s"}, {"_rad_per_s", "rad/s"},
                                           {"_N_m", "N m"},     {"_per_s", "1/s"},   {"_rad", "rad"},
                                           {"_Hz", "Hz"},       {"_pct", "%"},       {"_N", "N"},
                                           {"_m", "m"},         {"_s", "s"}};
    const size_t length = strlen(name);
    for (size_t k = 0; k < sizeof units / sizeof *units; k++) {
        const size_t end = strlen(units[k][0]);
        if (length > end && strcmp(name + length - end, units[k][0]) == 0) return units[k][1];
    }
    return "";
}

/* The table's row whose first cell has the name; its cell number `column` is the unit. */
static void expect_row(const char *part, const char *name, int column, const char *unit)
{
    char quoted[NAME_ROOM], row[ROW_ROOM];
    snprintf(quoted, sizeof quoted, "`%s`", name);
    for (const char *line = strstr(part, "\n| `"); line; line = strstr(line + 1, "\n| `")) {
        snprintf(row, sizeof row, "%.*s", (int)strcspn(line + 1, "\n"), line + 1);
        char *cell[4] = {NULL}, *rest = row + 1;
        for (int k = 0; k < 4 && rest; k++) {
            cell[k] = rest;
            rest = strchr(rest, '|');
            if (rest) *rest++ = 0;
        }
        if (!strstr(cell[0], quoted)) continue;
        char wanted[40];
        snprintf(wanted, sizeof wanted, *unit ? " %s " : " ", unit);
        if (strcmp(cell[column], wanted) != 0) fail_msg("%s: unit '%s', not '%s'", name, cell[column], unit);
        return;
    }
    fail_msg("no row of `%s`", name);
}

/* Names in the first cells of the part's table. */
static int names_in(const char *part)
{
    int n = 0;
    for (const char *line = strstr(part, "\n| `"); line; line = strstr(line + 1, "\n| `")) {
        const char *const end = strchr(line + 3, '|');
        for (const char *p = line; p < end; p++) n += *p == '`';
    }
    return n / 2;
}

TEST(every_table)
{
    static const struct {
        const char *heading;
        const Columns *columns;
    } tables[] = {
        {"## stations.csv", &station_columns}, {"## rollers.csv", &roller_columns}, {"## modes.csv", &shape_columns}};
    static char part[PART_MAX];
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        part_of(tables[t].heading, part);
        const Columns *const c = tables[t].columns;
        for (int k = 0; k < c->n; k++) expect_row(part, c->column[k].key, 1, unit_of(c->column[k].key));
        assert_int_equal(names_in(part), c->n);
    }
}

/* The star is NAME, or K where it is a number. */
TEST(series)
{
    static char part[PART_MAX];
    int n = 0;
    part_of("## series.csv", part);
    for (int k = 0; k < sample_columns; k++) {
        const SampleColumn *const c = &sample_column[k];
        if (c->of == OF_FIGURE) continue; /* below */
        const int axes = !c->name ? 0 : strchr(c->name, '@') ? 3 : 1;
        for (int axis = 0; axis < axes; axis++, n++) {
            char name[NAME_ROOM] = "";
            for (const char *p = c->name; *p; p++) {
                const char one[2] = {*p == '@' ? "xyz"[axis] : *p, 0};
                strcat(name, *p != '*' ? one : c->of == OF_SEGMENT ? "K" : "NAME");
            }
            expect_row(part, name, 1, unit_of(name));
        }
    }
    for (int k = 0; ROOM_KINDS[k]; k++) {
        const MachineKind *const kind = ROOM_KINDS[k]->machines;
        for (int f = 0; kind && f < kind->n_now; f++, n++) {
            char name[NAME_ROOM];
            snprintf(name, sizeof name, "NAME_%s", kind->now[f]);
            expect_row(part, name, 1, unit_of(name));
        }
    }
    assert_int_equal(names_in(part), n);
}

TEST(every_set)
{
    static char part[PART_MAX];
    part_of("## results.h5", part);
    for (int k = 0; k < sample_columns; k++) {
        if (sample_column[k].set) expect_row(part, sample_column[k].set, 2, sample_column[k].unit);
    }
}

/* Sets that do not grow stand in tables of their group, each below its own name: `s` of `geometry/route`. */
static void expect_fixed(const char *part, const char *prefix, int n, const FixedSet *set)
{
    static char table[PART_MAX];
    for (int k = 0; k < n; k++) {
        char group[NAME_ROOM], path[NAME_ROOM];
        snprintf(path, sizeof path, "%s%s", prefix, set[k].set);
        char *const name = strrchr(path, '/') + 1;
        snprintf(group, sizeof group, "\n`%.*s`", (int)(name - 1 - path), path);
        const char *const start = strstr(part, group);
        if (!start) fail_msg("no table of %s", group + 1);
        if (!start) return;
        const char *const rows = strstr(start, "\n| `"), *const end = rows ? strstr(rows, "\n\n") : NULL;
        assert_non_null(end);
        snprintf(table, sizeof table, "%.*s", end ? (int)(end - start) : 0, start);
        expect_row(table, name, 2, set[k].unit);
    }
}

TEST(every_fixed_set)
{
    static char part[PART_MAX];
    part_of("## results.h5", part);
    expect_fixed(part, "", geometry_sets, geometry_set);
    expect_fixed(part, "geometry/surfaces/K/", surface_sets, surface_set);
    expect_fixed(part, "", envelope_sets, envelope_set);
}

/* Each key by itself, or as `.b` behind another of the same object, or in words of its list's row. */
static void expect_keys(const char *part, const Columns *columns)
{
    for (int k = 0; k < columns->n; k++) {
        const Column *const c = &columns->column[k];
        const char *const dot = strrchr(c->key, '.');
        char whole[NAME_ROOM], last[NAME_ROOM], item[NAME_ROOM];
        snprintf(whole, sizeof whole, "`%s`", c->key);
        snprintf(last, sizeof last, "`.%s`", dot ? dot + 1 : c->key);
        snprintf(item, sizeof item, ".%s`", c->key);
        if (!strstr(part, whole) && !strstr(part, last) && !strstr(part, item)) fail_msg("no key %s", whole);
        if (c->of && c->kind != COLUMN_MAP) expect_keys(part, c->of);
    }
}

TEST(every_key)
{
    static char part[PART_MAX];
    part_of("## summary.json", part);
    expect_keys(part, &summary_columns);
    for (int k = 0; ROOM_KINDS[k]; k++) { /* the machines' lists, a row each */
        const MachineKind *const kind = ROOM_KINDS[k]->machines;
        char list[NAME_ROOM];
        if (!kind) continue;
        snprintf(list, sizeof list, "\n| `%s` ", kind->key);
        const char *const row = strstr(part, list);
        if (!row) fail_msg("no row of the machines' list `%s`", kind->key);
        for (int f = 0; f < kind->n_figures; f++) {
            char figure[NAME_ROOM];
            snprintf(figure, sizeof figure, "`%s`", kind->figure[f]);
            const char *const at = strstr(row, figure);
            if (!at || at > row + strcspn(row + 1, "\n")) fail_msg("no %s in the row of `%s`", figure, kind->key);
        }
    }
}
