/* docs/reference/columns.md, which tests/house/check_columns.py makes from the sources, has what the compiled tables
 * have: every column, key and set with its unit, and nothing else. */
#include <stdlib.h>
#include <string.h>

#include "io/results/results_file.h"
#include "sim/room.h"
#include "tests/support/check.h"

enum { PART_MAX = 1 << 16, NAME_ROOM = 200, ROW_ROOM = 4000 };

/* The document's part from a heading to the next one. */
static void part_of(const char *heading, char part[PART_MAX])
{
    static char doc[1 << 18];
    FILE *f = fopen(HAWSER_SOURCE_DIR "/docs/reference/columns.md", "r");
    assert_non_null(f);
    const size_t n = fread(doc, 1, sizeof doc - 1, f);
    fclose(f);
    doc[n] = 0;
    const char *start = strstr(doc, heading);
    assert_non_null(start);
    start += strlen(heading);
    const char *end = strstr(start, "\n#");
    snprintf(part, PART_MAX, "%.*s", end ? (int)(end - start) : (int)strlen(start), start);
}

/* The unit that a column's name ends with; "" for none. */
static const char *unit_of(const char *name)
{
    static const char *const units[][2] = {
        {"_kg_per_m", "kg/m"}, {"_N_per_m", "N/m"}, {"_m_per_s", "m/s"}, {"_rad_per_s", "rad/s"},
        {"_per_m", "1/m"},     {"_N_m2", "N m2"},   {"_N_m", "N m"},     {"_N_s", "N s"},
        {"_per_s2", "1/s2"},   {"_per_s", "1/s"},   {"_rad", "rad"},     {"_deg", "deg"},
        {"_Hz", "Hz"},         {"_pct_paper", "%"}, {"_pct", "%"},       {"_N", "N"},
        {"_J", "J"},           {"_W", "W"},         {"_m", "m"},         {"_s", "s"}};
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
static void expect_fixed(const char *prefix, int n, const FixedSet *set)
{
    static char part[PART_MAX];
    for (int k = 0; k < n; k++) {
        char heading[NAME_ROOM], path[NAME_ROOM];
        snprintf(path, sizeof path, "%s%s", prefix, set[k].set);
        char *const name = strrchr(path, '/') + 1;
        snprintf(heading, sizeof heading, "### `%.*s`", (int)(name - 1 - path), path);
        part_of(heading, part);
        expect_row(part, name, 2, set[k].unit);
    }
}

TEST(every_fixed_set)
{
    expect_fixed("", geometry_sets, geometry_set);
    expect_fixed("geometry/surfaces/K/", surface_sets, surface_set);
    expect_fixed("", envelope_sets, envelope_set);
}

/* The keys of an object below a heading, and those of the objects within it. */
static void expect_keys(const char *heading, const char *path, const Columns *columns)
{
    static char part[PART_MAX];
    part_of(heading, part);
    for (int k = 0; k < columns->n; k++) expect_row(part, columns->column[k].key, 1, unit_of(columns->column[k].key));
    assert_int_equal(names_in(part), columns->n);
    for (int k = 0; k < columns->n; k++) {
        const Column *const c = &columns->column[k];
        char inner[NAME_ROOM], below[2 * NAME_ROOM];
        snprintf(inner, sizeof inner, "%s%s%s", path, *path ? "." : "", c->key);
        snprintf(below, sizeof below, "### `%s`", inner);
        /* positions.csv has the positions; the two error bounds have the same keys */
        if (!c->of || c->kind == COLUMN_MAP || c->of == &place_columns || strstr(c->key, "peak_error")) continue;
        expect_keys(below, inner, c->of);
    }
}

TEST(every_key)
{
    static char part[PART_MAX];
    expect_keys("## summary.json", "", &summary_columns);
    for (int k = 0; ROOM_KINDS[k]; k++) { /* the lists of machines */
        const MachineKind *const kind = ROOM_KINDS[k]->machines;
        char heading[NAME_ROOM];
        if (!kind) continue;
        snprintf(heading, sizeof heading, "### `%s`", kind->key);
        part_of(heading, part);
        for (int f = 0; f < kind->n_figures; f++) expect_row(part, kind->figure[f], 1, unit_of(kind->figure[f]));
        assert_int_equal(names_in(part), kind->n_figures + 1);
    }
}
