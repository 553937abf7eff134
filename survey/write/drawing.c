/* DXF of R12, and GeoJSON. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/map/map.h"
#include "survey/write/parts.h"

/* --------------------------------------------------------------------------------------------------------------- DXF
 */

/* Names of layers in R12: letters, digits, - and _, 31 of them. */
static void layer_set(const Alignment *a, char layer[32])
{
    const char *const from = *a->layer ? a->layer : *a->name ? a->name : "ROUTE";
    size_t n = 0;
    for (; from[n] && n < 31; ++n) {
        layer[n] = isalnum((unsigned char)from[n]) || from[n] == '-' || from[n] == '_' ? from[n] : '_';
    }
    layer[n] = 0;
}

static void vertex_print(FILE *to, const char *layer, int space, Vec3 at, double bulge)
{
    fprintf(to, "  0\nVERTEX\n  8\n%s\n 10\n%.6f\n 20\n%.6f\n 30\n%.6f\n", layer, at.x, at.y, at.z);
    if (bulge != 0) fprintf(to, " 42\n%.15g\n", bulge);
    if (space) fputs(" 70\n    32\n", to);
}

static void polyline_begin(FILE *to, const char *layer, int space, double z)
{
    fprintf(to, "  0\nPOLYLINE\n  8\n%s\n 66\n     1\n 10\n0.0\n 20\n0.0\n 30\n%.6f\n 70\n%6d\n", layer, space ? 0 : z,
            space ? 8 : 0);
}

/* Arcs for an element: itself, or as many as a clothoid needs for 0.02 mm: (WR1). */
static void bulges_print(FILE *to, const char *layer, const PlanElement *e, double z)
{
    const double rate = fabs(e->k1 - e->k0) / e->length, turn = e->length * fmax(fabs(e->k0), fabs(e->k1));
    const double step = rate > 0 ? cbrt(2e-5 / (0.0080 * rate)) : INFINITY;
    const int n = (int)fmin(1 + fmax(e->length / step, turn / 3), 1e6);
    for (int i = 0; i < n; ++i) {
        const PlanElement from = plan_at(e, e->length * i / n), end = plan_at(e, e->length * (i + 1) / n);
        const double angle = end.heading - from.heading;
        vertex_print(to, layer, 0, v3(from.x, from.y, z), tan(angle / 4));
    }
}

/* Level lines of elements keep their arcs. */
static int is_level(const Alignment *a)
{
    int level = a->n_plan > 0;
    for (int i = 0; i < a->n_profile; ++i) level &= a->profile[i].grade == 0 && a->profile[i].bend == 0;
    return level;
}

hawser_status print_dxf(const Alignment *a, FILE *to, hawser_error *err)
{
    char layer[32];
    Vec3 *vertex = NULL;
    int n = 0;
    layer_set(a, layer);
    fputs("  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\nENDSEC\n  "
          "0\nSECTION\n  2\n"
          "ENTITIES\n",
          to);
    hawser_status status = HAWSER_OK;
    if (is_level(a)) {
        const double z = a->n_profile ? a->profile[0].z : 0;
        polyline_begin(to, layer, 0, z);
        for (int i = 0; i < a->n_plan; ++i) bulges_print(to, layer, &a->plan[i], z);
        const PlanElement *const last = &a->plan[a->n_plan - 1];
        const PlanElement end = plan_at(last, last->length);
        vertex_print(to, layer, 0, v3(end.x, end.y, z), 0);
    } else {
        status = vertices_make(a, &n, &vertex, err);
        polyline_begin(to, layer, 1, 0);
        for (int i = 0; i < n; ++i) vertex_print(to, layer, 1, vertex[i], 0);
    }
    fprintf(to, "  0\nSEQEND\n  8\n%s\n  0\nENDSEC\n  0\nEOF\n", layer);
    free(vertex);
    return status;
}

/* ----------------------------------------------------------------------------------------------------------- GeoJSON
 */

static void text_print(FILE *to, const char *text)
{
    fputc('"', to);
    for (; *text; ++text) {
        if (*text == '"' || *text == '\\') fputc('\\', to);
        if ((unsigned char)*text < ' ')
            fprintf(to, "\\u%04x", (unsigned)(unsigned char)*text);
        else
            fputc(*text, to);
    }
    fputc('"', to);
}

hawser_status print_geojson(const Alignment *a, const char *system, FILE *to, hawser_error *err)
{
    MapOrigin origin;
    Vec3 *vertex = NULL;
    int n = 0;
    const int degrees = map_system_read(system, &origin), heights = !(a->flat && a->n_profile == 0);
    const hawser_status status = vertices_make(a, &n, &vertex, err);
    fputs("{\"type\": \"FeatureCollection\",\n", to);
    if (degrees)
        fprintf(to, " \"origin\": [%.12f, %.12f],\n", origin.longitude, origin.latitude);
    else
        fputs(" \"coordinates_in\": \"m\",\n", to);
    fputs(" \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": ", to);
    text_print(to, a->name);
    fputs(", \"layer\": ", to);
    text_print(to, a->layer);
    fputs("},\n  \"geometry\": {\"type\": \"LineString\", \"coordinates\": [\n", to);
    for (int i = 0; i < n; ++i) {
        double x = vertex[i].x, y = vertex[i].y;
        if (degrees) map_from_ground(origin, vertex[i].x, vertex[i].y, &x, &y);
        fprintf(to, degrees ? "   [%.11f, %.11f" : "   [%.6f, %.6f", x, y);
        if (heights) fprintf(to, ", %.6f", vertex[i].z);
        fputs(i + 1 < n ? "],\n" : "]]}}]}\n", to);
    }
    free(vertex);
    return status;
}
