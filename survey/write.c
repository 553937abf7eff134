#include "survey/write.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "survey/map.h"

static const double chord_off = 5e-5; /* m */

static int stretch_add(WrittenStretches *out, Stretch item)
{
    Stretch *const added = survey_one_more(&out->item, &out->n, sizeof *added);
    if (added) *added = item;
    return added != NULL;
}

/* The profile's element from s on, extended by its first and last grade beyond its ends. */
static ProfileElement profile_from(const Alignment *a, int j, double s)
{
    if (a->n_profile == 0) return (ProfileElement){.station = s};
    const ProfileElement *const e = &a->profile[j];
    const double at = fmin(fmax(s - e->station, 0), e->length);
    ProfileElement from = profile_at(e, at);
    from.z += from.grade * (s - e->station - at);
    if (s < e->station || s >= e->station + e->length) from.bend = 0;
    from.station = s;
    return from;
}

/* Next station after s where the profile changes; j: its element there. */
static double profile_next(const Alignment *a, int *j, double s)
{
    const double near = 1e-9;
    while (*j + 1 < a->n_profile && a->profile[*j + 1].station <= s + near) ++*j;
    if (a->n_profile == 0) return INFINITY;
    const ProfileElement *const e = &a->profile[*j];
    if (e->station > s + near) return e->station;
    if (e->station + e->length > s + near)
        return *j + 1 < a->n_profile ? fmin(e->station + e->length, e[1].station) : e->station + e->length;
    return *j + 1 < a->n_profile ? e[1].station : INFINITY;
}

/* Element i in plan; for a line of points the straight to the next one. */
static PlanElement plan_element(const Alignment *a, int i)
{
    if (a->n_plan) return a->plan[i];
    const Vec3 *const p = &a->point[i];
    return (PlanElement){.x = p->x,
                         .y = p->y,
                         .heading = atan2(p[1].y - p->y, p[1].x - p->x),
                         .length = hypot(p[1].x - p->x, p[1].y - p->y)};
}

/* Cuts a line of elements, or of points with a profile. The items must be freed. Errors: MEMORY. */
static hawser_status stretches_make(const Alignment *a, WrittenStretches *out, hawser_error *err)
{
    const int n = a->n_plan ? a->n_plan : a->n_points - 1;
    double station = 0;
    int j = 0;
    *out = (WrittenStretches){0, NULL};
    for (int i = 0; i < n; ++i) {
        const PlanElement e = plan_element(a, i);
        const double end = station + e.length;
        for (double s = station; s < end - 1e-9;) {
            const double next = fmin(profile_next(a, &j, s), end);
            PlanElement from = s > station ? plan_at(&e, s - station) : e;
            from.k1 = plan_at(&e, next - station).k0;
            from.length = next - s;
            ProfileElement profile = profile_from(a, j, s);
            profile.length = next - s;
            if (!stretch_add(out, (Stretch){s, from, profile})) return error_memory(err);
            s = next;
        }
        station = end;
    }
    return HAWSER_OK;
}

/* Number of parts whose chords are off by at most chord_off. */
static int parts_of(const Stretch *s)
{
    const double steep = fmin(fabs(s->profile.grade), 10), k = fmax(fabs(s->plan.k0), fabs(s->plan.k1));
    const double bend = fabs(s->profile.bend) * (s->profile.kind == PROFILE_ARC ? pow(1 + steep * steep, 1.5) : 1);
    return (int)fmin(1 + s->plan.length * sqrt((k + bend) / (8 * chord_off)), 1e7);
}

/* Computes the corners of a line: its points, or places along its elements whose chords are at most 0.05 mm off. They
 * must be freed. Errors: MEMORY, INPUT (more than 20 million). */
static hawser_status vertices_make(const Alignment *a, int *n, Vec3 **vertex, hawser_error *err)
{
    WrittenStretches s = {0, NULL};
    const int points = a->n_plan == 0 && a->n_profile == 0;
    hawser_status status = points ? HAWSER_OK : stretches_make(a, &s, err);
    double all = points ? a->n_points : 1;
    for (int i = 0; i < s.n; ++i) all += parts_of(&s.item[i]);
    *n = 0;
    *vertex = NULL;
    if (!status && all > SURVEY_MOST)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.60s' has too many corners", a->name);
    if (!status && !(*vertex = malloc((size_t)(all + 1) * sizeof **vertex))) status = error_memory(err);
    for (int i = 0; points && i < a->n_points && !status; ++i) (*vertex)[(*n)++] = a->point[i];
    for (int i = 0; i < s.n && !status; ++i) {
        const int parts = parts_of(&s.item[i]), last = i + 1 == s.n;
        for (int k = 0; k < parts + last; ++k) {
            const double along = s.item[i].plan.length * k / parts;
            const PlanElement p = plan_at(&s.item[i].plan, along);
            (*vertex)[(*n)++] = v3(p.x, p.y, profile_at(&s.item[i].profile, along).z);
        }
    }
    free(s.item);
    if (status) free(*vertex), *vertex = NULL;
    return status;
}

/* Section `route` of a case: plan and corners of the profile (docs/reference/case-keys.md). */

/* Radius beyond which a clothoid's end counts as straight, m. */
static const double straight_radius = 1e6;

static void radius_print(FILE *to, const char *key, double curvature)
{
    if (curvature != 0) fprintf(to, ", %s: %.12g m", key, 1 / fabs(curvature));
}

/* Writes a name in YAML quotes. */
static void name_print(const char *name, FILE *to)
{
    if (*name) fputs(", name: \"", to);
    for (const char *c = name; *c; ++c) fprintf(to, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
    fputs(*name ? "\"}\n" : "}\n", to);
}

static void element_print(const PlanElement *from, const char *name, FILE *to)
{
    PlanElement straightened = *from;
    const PlanElement *const e = &straightened;
    if (fabs(e->k0) * straight_radius <= 1) straightened.k0 = 0;
    if (fabs(e->k1) * straight_radius <= 1) straightened.k1 = 0;
    const char *const turn = e->k0 + e->k1 > 0 ? "left" : "right";
    if (e->k0 == 0 && e->k1 == 0) {
        fprintf(to, "    - {line: %.9f m", e->length);
    } else if (e->k0 == e->k1) {
        fprintf(to, "    - {arc: %.9f m, radius: %.12g m, turn: %s", e->length, 1 / fabs(e->k0), turn);
    } else if (e->k0 * e->k1 < 0) { /* in two where its curvature changes sign */
        PlanElement first = *e, second = *e;
        first.length = e->length * e->k0 / (e->k0 - e->k1);
        second.length = e->length - first.length;
        first.k1 = second.k0 = 0;
        element_print(&first, name, to);
        element_print(&second, name, to);
        return;
    } else {
        fprintf(to, "    - {clothoid: %.9f m", e->length);
        radius_print(to, "start_radius", e->k0);
        radius_print(to, "end_radius", e->k1);
        fprintf(to, ", turn: %s", turn);
    }
    name_print(name, to);
}

/* Writes a curve by its corner, where the grades at its ends meet. */
static void curve_print(const ProfileElement *e, FILE *to)
{
    if (e->kind == PROFILE_PARABOLA) {
        fprintf(to, "    - {station: %.9f m, height: %.9f m, parabola: %.9f m}\n", e->station + e->length / 2,
                e->z + e->grade * e->length / 2, e->length);
        return;
    }
    const double slope = atan(e->grade), turn = atan(profile_at(e, e->length).grade) - slope;
    const double tangent = fabs(tan(turn / 2) / e->bend); /* (AL5) */
    fprintf(to, "    - {station: %.9f m, height: %.9f m, radius: %.12g m}\n", e->station + tangent * cos(slope),
            e->z + tangent * sin(slope), fabs(1 / e->bend));
}

/* Writes the corners: the first and last point, every curve, and meeting points of grades without one. */
static void profile_print(const Alignment *a, double length, FILE *to)
{
    const ProfileElement *const first = &a->profile[0], *const last = &a->profile[a->n_profile - 1];
    const ProfileElement end = profile_at(last, last->length);
    const double start = fmin(0, first->station), over = fmax(0, length - end.station);
    fputs("  profile:\n", to);
    fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", start, first->z + first->grade * (start - first->station));
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i];
        const double before = i ? profile_at(e - 1, e[-1].length).grade : e->grade;
        if (fabs(e->grade - before) > 1e-9) {
            fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", e->station, e->z);
        }
        if (e->bend != 0) curve_print(e, to);
    }
    fprintf(to, "    - {station: %.9f m, height: %.9f m}\n", end.station + over, end.z + over * end.grade);
}

/* Writes corners in space that are rounded with one radius. */
static hawser_status print_corners(const Alignment *a, const char *system, FILE *to)
{
    fprintf(to, "# %s\n", *a->name ? a->name : "route");
    if (*system) fprintf(to, "# coordinates: %s\n", system);
    fprintf(to, "route:\n  radius: %.12g m\n  points:\n", a->corner);
    for (int i = 0; i < a->n_points; ++i)
        fprintf(to, "    - [%.6f m, %.6f m, %.6f m]\n", a->point[i].x, a->point[i].y, a->point[i].z);
    return HAWSER_OK;
}

hawser_status print_case(const Alignment *a, const char *system, FILE *to, hawser_error *err)
{
    if (a->n_plan == 0 && a->corner > 0) return print_corners(a, system, to);
    if (a->n_plan == 0) {
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a line of points: fit it first", a->name);
    }
    const AlignmentMeasure m = alignment_measure(a);
    fprintf(to, "# %s: %.3f m in plan, %.3f m in space\n", *a->name ? a->name : "route", m.plan_length, m.length);
    if (*system) fprintf(to, "# coordinates: %s\n", system);
    if (m.gap > 1e-4)
        fprintf(to, "# elements of the source miss each other by up to %.4f m; here they are chained\n", m.gap);
    fprintf(to, "route:\n  start: [%.6f m, %.6f m, %.6f m]\n  heading: %.12f deg\n  plan:\n", m.start.x, m.start.y,
            m.start.z, remainder(a->plan[0].heading, 2 * acos(-1)) * 180 / acos(-1));
    for (int i = 0; i < a->n_plan; ++i) element_print(&a->plan[i], piece_names_get(&a->names, a->plan[i].name), to);
    if (a->n_profile) profile_print(a, m.plan_length, to);
    return HAWSER_OK;
}

/* DXF of R12, and GeoJSON. */

/* --------------------------------------------------------------------------------------------------------------- DXF
 */

/* Sets a layer's name for R12: letters, digits, - and _, 31 of them. */
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

/* Writes arcs for an element: itself, or as many as a clothoid needs for 0.02 mm: (WR1). */
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

/* Checks for a level line of elements, which keeps its arcs. */
static int is_level(const Alignment *a)
{
    int level = a->n_plan > 0;
    for (int i = 0; i < a->n_profile; ++i) level &= a->profile[i].grade == 0 && a->profile[i].bend == 0;
    return level;
}

static hawser_status print_dxf(const Alignment *a, FILE *to, hawser_error *err)
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

static hawser_status print_geojson(const Alignment *a, const char *system, FILE *to, hawser_error *err)
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

/* CSV: elements with their starts, and the planner's pieces. */

/* Writes a number with that many decimals; nothing if it is not finite. */
static void cell(FILE *to, int digits, double value)
{
    fputc(',', to);
    if (isfinite(value)) fprintf(to, "%.*f", digits, value);
}

/* Writes a radius with twelve digits. */
static void radius_cell(FILE *to, double curvature)
{
    fputc(',', to);
    if (curvature != 0) fprintf(to, "%.12g", 1 / curvature);
}

/* Writes a name in quotes, which are doubled within. */
static void name_cell(FILE *to, const char *name)
{
    fputs(",\"", to);
    for (; *name; ++name) fprintf(to, *name == '"' ? "\"\"" : "%c", *name);
    fputc('"', to);
}

static hawser_status print_elements(const Alignment *a, FILE *to, hawser_error *err)
{
    if (a->n_plan == 0 && a->n_profile == 0) {
        fputs("x (m),y (m),z (m)\n", to);
        for (int i = 0; i < a->n_points; ++i) {
            fprintf(to, "%.6f,%.6f,%.6f\n", a->point[i].x, a->point[i].y, a->point[i].z);
        }
        return HAWSER_OK;
    }
    WrittenStretches s;
    const hawser_status status = stretches_make(a, &s, err);
    fputs("station (m),x (m),y (m),direction (rad),length (m),start radius (m),end radius (m)", to);
    if (a->n_profile) fputs(",z (m),start gradient,end gradient,vertical radius (m)", to);
    fputs(a->names.used ? ",name\n" : "\n", to);
    for (int i = 0; i < s.n; ++i) {
        const PlanElement *const e = &s.item[i].plan;
        const ProfileElement *const p = &s.item[i].profile;
        fprintf(to, "%.6f,%.6f,%.6f,%.14f,%.9f", a->station + s.item[i].station, e->x, e->y, e->heading, e->length);
        radius_cell(to, e->k0);
        radius_cell(to, e->k1);
        if (a->n_profile) {
            cell(to, 6, p->z);
            cell(to, 14, p->grade);
            cell(to, 14, profile_at(p, p->length).grade);
            radius_cell(to, p->kind == PROFILE_ARC ? p->bend : 0);
        }
        if (a->names.used) name_cell(to, piece_names_get(&a->names, e->name));
        fputc('\n', to);
    }
    free(s.item);
    return status;
}

/* Writes one row; returns 0 for a piece that the table cannot express. */
static int piece_print(const Stretch *s, FILE *to)
{
    const PlanElement *const e = &s->plan;
    const ProfileElement *const p = &s->profile;
    const double degree = 180 / acos(-1), turn = e->k0 * e->length, slope = p->grade;
    if (e->k0 != e->k1 || (e->k0 != 0 && p->bend != 0) || (p->bend != 0 && p->kind != PROFILE_ARC)) return 0;
    if (e->k0 != 0) {
        fprintf(to, ",%.10f,%.9f,%s,%.14f\n", fabs(turn) * degree, fabs(1 / e->k0), turn > 0 ? "left" : "right", slope);
    } else if (p->bend != 0) {
        const double rise = atan(profile_at(p, p->length).grade) - atan(slope);
        fprintf(to, ",%.10f,%.9f,%s,%.14f\n", fabs(rise) * degree, fabs(1 / p->bend), rise > 0 ? "up" : "down", slope);
    } else {
        fprintf(to, "%.9f,,,,%.14f\n", e->length * sqrt(1 + slope * slope), slope);
    }
    return 1;
}

static hawser_status print_pieces(const Alignment *a, FILE *to, hawser_error *err)
{
    WrittenStretches s = {0, NULL};
    hawser_status status = HAWSER_OK;
    if (a->n_plan == 0)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a line of points, not of pieces: fit it first", a->name);
    if (!status) status = stretches_make(a, &s, err);
    fputs("length (m),angle (deg),radius (m),turn,slope\n", to);
    for (int i = 0; i < s.n && !status; ++i) {
        if (piece_print(&s.item[i], to)) continue;
        status = error_set(err, HAWSER_ERR_INPUT,
                           "'%.60s' has a clothoid, a parabola or a bend on a vertical curve %.3f m from its start: a "
                           "table of pieces cannot express it; write elements",
                           a->name, s.item[i].station);
    }
    free(s.item);
    return status;
}

/* rad: a larger turn is no route, and would be written as millions of arcs. */
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
                         "'%.60s' has corners in space with a radius, which only a case's route (.yaml) can express",
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
