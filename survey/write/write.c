#include "survey/write/write.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "survey/write/parts.h"

/* rad: what turns more is no route, and would be written as millions of arcs. */
static const double turn_most = 200;

int write_format(const char *path)
{
    static const struct {
        const char *ending;
        WriteFormat format;
    } endings[] = {{".csv", WRITE_ELEMENTS}, {".dxf", WRITE_DXF},   {".geojson", WRITE_GEOJSON},
                   {".json", WRITE_GEOJSON}, {".yaml", WRITE_CASE}, {".yml", WRITE_CASE}};
    const size_t n = strlen(path);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; ++i) {
        const size_t size = strlen(endings[i].ending);
        if (n > size && !strcasecmp(path + n - size, endings[i].ending)) return (int)endings[i].format;
    }
    return -1;
}

hawser_status alignment_print(const Alignment *a, const char *system, WriteFormat format, FILE *to, hawser_error *err)
{
    if (a->n_plan == 0 && a->n_points < 2) {
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a profile without a plan: nothing to write", a->name);
    }
    if (format != WRITE_CASE && a->n_plan == 0 && a->corner > 0) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' has corners in space with a radius, which only a case's route (.yaml) can say",
                         a->name);
    }
    for (int i = 0; i < a->n_plan; ++i) {
        const PlanElement *const e = &a->plan[i];
        if (fmax(fabs(e->k0), fabs(e->k1)) * e->length <= turn_most) continue;
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s' has an element that turns around %.0f times: no route",
                         a->name, fmax(fabs(e->k0), fabs(e->k1)) * e->length / (2 * acos(-1)));
    }
    switch (format) {
    case WRITE_ELEMENTS:
        return print_elements(a, to, err);
    case WRITE_PIECES:
        return print_pieces(a, to, err);
    case WRITE_DXF:
        return print_dxf(a, to, err);
    case WRITE_GEOJSON:
        return print_geojson(a, system, to, err);
    case WRITE_CASE:
        break;
    }
    return print_case(a, system, to, err);
}

hawser_status alignment_write(const Alignment *a, const char *system, WriteFormat format, const char *path,
                              hawser_error *err)
{
    FILE *const to = fopen(path, "wbe");
    if (!to && errno == ENOMEM) return error_memory(err);
    if (!to) return error_set(err, HAWSER_ERR_OUTPUT, "%.200s: cannot be written: %s", path, strerror(errno));
    hawser_status status = alignment_print(a, system, format, to, err);
    errno = 0;
    const int failed = ferror(to) | fclose(to);
    if (failed && !status)
        status = error_set(err, HAWSER_ERR_OUTPUT, "%.200s: cannot be written: %s", path,
                           errno ? strerror(errno) : "the write failed");
    if (status) remove(path);
    return status;
}
