/* Equipment around the cable, in the group "geometry" of results.h5: constant sets. */
#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "io/results/results_h5.h"

#define OF(array, n, items) .values = offsetof(Geometry, array), .count = offsetof(Geometry, n), .axis = items

const FixedSet geometry_set[] = {
    {"geometry/route/s", FIXED_NUMBER, OF(route_s, n_route, "s"), 0, "m", "arc length along the route"},
    {"geometry/route/position", FIXED_NUMBER, OF(route_position, n_route, "s"), 3, "m", "x y z of the route's line",
     "xyz"},
    {"geometry/route/curvature", FIXED_NUMBER, OF(route_curvature, n_route, "s"), 0, "1/m",
     "of the route's line; at a jump that of the piece ahead"},
    {"geometry/rollers/name", FIXED_NAME, OF(roller_name, n_rollers, "roller"), 0, "",
     "rollers and obstacles, as in roller_load"},
    {"geometry/rollers/kind", FIXED_NAME, OF(roller_kind, n_rollers, "roller"), 0, "",
     "roller, hold-down, box, bell-mouth"},
    {"geometry/rollers/s", FIXED_NUMBER, OF(roller_s, n_rollers, "roller"), 0, "m",
     "place along the route; NaN: by coordinates"},
    {"geometry/rollers/position", FIXED_NUMBER, OF(roller_position, n_rollers, "roller"), 3, "m",
     "centres, where they begin", "xyz"},
    {"geometry/rollers/axis", FIXED_NUMBER, OF(roller_axis, n_rollers, "roller"), 3, "1", "unit vectors", "xyz"},
    {"geometry/rollers/radius", FIXED_NUMBER, OF(roller_radius, n_rollers, "roller"), 0, "m",
     "at the bottom of a groove; of a box half its smallest size, of a bell-mouth that of its section"},
    {"geometry/rollers/width", FIXED_NUMBER, OF(roller_width, n_rollers, "roller"), 0, "m", "length along the axis"},
    {"geometry/rollers/groove", FIXED_NUMBER, OF(roller_groove, n_rollers, "roller"), 0, "m",
     "depth of the groove; 0: none"},
    {"geometry/rollers/rating", FIXED_NUMBER, OF(roller_rating, n_rollers, "roller"), 0, "N",
     "rated load; NaN: not given"},
    {"geometry/obstacles/roller", FIXED_COUNT, OF(obstacle_roller, n_obstacles, "obstacle"), 0, "1",
     "which of the rollers it is"},
    {"geometry/obstacles/side", FIXED_NUMBER, OF(obstacle_side, n_obstacles, "obstacle"), 3, "1",
     "unit vector across the axis", "xyz"},
    {"geometry/obstacles/size", FIXED_NUMBER, OF(obstacle_size, n_obstacles, "obstacle"), 3, "m",
     "along the axis, along side, and square to both", "direction"},
    {"geometry/obstacles/edge", FIXED_NUMBER, OF(obstacle_edge, n_obstacles, "obstacle"), 0, "m",
     "radius of its edges; of a bell-mouth that of its section"},
    {"geometry/obstacles/ring", FIXED_NUMBER, OF(obstacle_ring, n_obstacles, "obstacle"), 0, "m",
     "of a bell-mouth: from the axis to the middle of its round section; NaN: a box"},
    {"geometry/conveyors/name", FIXED_NAME, OF(conveyor_name, n_conveyors, "conveyor"), 0, "", "of every conveyor"},
    {"geometry/conveyors/from", FIXED_NUMBER, OF(conveyor_from, n_conveyors, "conveyor"), 0, "m", "along the route"},
    {"geometry/conveyors/to", FIXED_NUMBER, OF(conveyor_to, n_conveyors, "conveyor"), 0, "m", "along the route"},
    {"geometry/conveyors/points", FIXED_NUMBER, OF(conveyor_points, n_conveyors, "conveyor"), 6, "m",
     "where the cable enters and where it leaves, x y z each", "coordinate"},
    {"geometry/mesh/points", FIXED_SINGLE, OF(skin.points, skin.n_points, "point"), 3, "m",
     "corners of the triangles, single precision", "xyz"},
    {"geometry/mesh/triangles", FIXED_COUNT, OF(skin.triangle, skin.n_triangles, "triangle"), 3, "1",
     "three corners each, counter-clockwise from outside", "corner"},
    {"geometry/mesh/part", FIXED_COUNT, OF(skin.part, skin.n_triangles, "triangle"), 0, "1",
     "part of: 0 roller, 1 surface, 2 conveyor, 3 reel"},
    {"geometry/mesh/item", FIXED_COUNT, OF(skin.item, skin.n_triangles, "triangle"), 0, "1", "which of these"},
    {"environment/points", FIXED_NUMBER, OF(seen.mesh.vertex, seen.mesh.n_vertices, "point"), 3, "m",
     "corners of its triangles", "xyz"},
    {"environment/triangles", FIXED_COUNT, OF(seen.mesh.triangle, seen.mesh.n_triangles, "triangle"), 3, "1",
     "three points each; three equal ones: a point of a cloud", "corner"},
    {"environment/layer", FIXED_COUNT, OF(seen.mesh.layer, seen.mesh.n_triangles, "triangle"), 0, "1",
     "of every triangle"},
    {"environment/layer_name", FIXED_NAME, OF(seen.layer_name, seen.mesh.n_layers, "layer_number"), 0, "",
     "of every layer"},
    {"chain/length", FIXED_NUMBER, OF(length, n_segments, "segment"), 0, "m", "of every segment, unstretched"},
    {"chain/diameter", FIXED_NUMBER, OF(diameter, n_segments, "segment"), 0, "m", "of every segment"},
    {"chain/part", FIXED_COUNT, OF(part, n_segments, "segment"), 0, "1", "of every segment: 0 cable, 1 rope"},
    {"chain/piece", FIXED_COUNT, OF(piece, n_segments, "segment"), 0, "1", "which piece of the chain a segment is of"},
    {"chain/piece_name", FIXED_NAME, OF(piece_name, n_pieces, "piece_number"), 0, "", "cable or rope of every piece"},
};

const int geometry_sets = sizeof geometry_set / sizeof *geometry_set;

#define SURFACE(array)                                                                                                 \
    .values = offsetof(GeometrySurface, array), .count = offsetof(GeometrySurface, n), .axis = "point"

const FixedSet surface_set[] = {
    {"points", FIXED_NUMBER, SURFACE(points), 3, "m",
     "along its way: the middle of its bottom; of a duct, of its bore; of a V, where its planes meet", "xyz"},
    {"up", FIXED_NUMBER, SURFACE(up), 3, "1", "unit vectors square to the way there, upward in its section", "xyz"},
};

const int surface_sets = sizeof surface_set / sizeof *surface_set;

#define OVER(line, member) .values = offsetof(Envelope, line.member), .count = offsetof(Envelope, line.n), .axis = "s"

const FixedSet envelope_set[] = {
    {"envelope/arc/s", FIXED_NUMBER, OVER(arc, s), 0, "m", "of every joint from the tail, unstretched"},
    {"envelope/arc/time", FIXED_NUMBER, OVER(arc, time), 0, "s", "over which the means are"},
    {"envelope/arc/tension_min", FIXED_NUMBER, OVER(arc, tension.least), 0, "N", "least over time of the tension"},
    {"envelope/arc/tension_mean", FIXED_NUMBER, OVER(arc, tension.mean), 0, "N", "mean over time of the tension"},
    {"envelope/arc/tension_max", FIXED_NUMBER, OVER(arc, tension.largest), 0, "N", "largest over time of the tension"},
    {"envelope/arc/curvature_min", FIXED_NUMBER, OVER(arc, curvature.least), 0, "1/m",
     "least over time of the curvature"},
    {"envelope/arc/curvature_mean", FIXED_NUMBER, OVER(arc, curvature.mean), 0, "1/m",
     "mean over time of the curvature"},
    {"envelope/arc/curvature_max", FIXED_NUMBER, OVER(arc, curvature.largest), 0, "1/m",
     "largest over time of the curvature"},
    {"envelope/arc/sidewall_min", FIXED_NUMBER, OVER(arc, sidewall.least), 0, "N/m",
     "least over time of the sidewall pressure"},
    {"envelope/arc/sidewall_mean", FIXED_NUMBER, OVER(arc, sidewall.mean), 0, "N/m",
     "mean over time of the sidewall pressure"},
    {"envelope/arc/sidewall_max", FIXED_NUMBER, OVER(arc, sidewall.largest), 0, "N/m",
     "largest over time of the sidewall pressure"},
    {"envelope/place/s", FIXED_NUMBER, OVER(place, s), 0, "m",
     "along the route; values are of the cable that was there, NaN: none was"},
    {"envelope/place/time", FIXED_NUMBER, OVER(place, time), 0, "s", "over which the means are"},
    {"envelope/place/tension_min", FIXED_NUMBER, OVER(place, tension.least), 0, "N", "least over time of the tension"},
    {"envelope/place/tension_mean", FIXED_NUMBER, OVER(place, tension.mean), 0, "N", "mean over time of the tension"},
    {"envelope/place/tension_max", FIXED_NUMBER, OVER(place, tension.largest), 0, "N",
     "largest over time of the tension"},
    {"envelope/place/curvature_min", FIXED_NUMBER, OVER(place, curvature.least), 0, "1/m",
     "least over time of the curvature"},
    {"envelope/place/curvature_mean", FIXED_NUMBER, OVER(place, curvature.mean), 0, "1/m",
     "mean over time of the curvature"},
    {"envelope/place/curvature_max", FIXED_NUMBER, OVER(place, curvature.largest), 0, "1/m",
     "largest over time of the curvature"},
    {"envelope/place/sidewall_min", FIXED_NUMBER, OVER(place, sidewall.least), 0, "N/m",
     "least over time of the sidewall pressure"},
    {"envelope/place/sidewall_mean", FIXED_NUMBER, OVER(place, sidewall.mean), 0, "N/m",
     "mean over time of the sidewall pressure"},
    {"envelope/place/sidewall_max", FIXED_NUMBER, OVER(place, sidewall.largest), 0, "N/m",
     "largest over time of the sidewall pressure"},
};

const int envelope_sets = sizeof envelope_set / sizeof *envelope_set;

/* Writes a number if it is known. */
static int number_write(hid_t object, const char *name, double value)
{
    return isnan(value) || h5_numbers(object, name, 1, &value);
}

static int surface_write(hid_t file, int i, const GeometrySurface *s)
{
    char prefix[64];
    snprintf(prefix, sizeof prefix, "geometry/surfaces/%d/", i);
    if (!h5_fixed(file, prefix, surface_sets, surface_set, s)) return 0;
    prefix[strlen(prefix) - 1] = 0;
    const hid_t group = h5_group(file, prefix);
    const int ok = group >= 0 && h5_text(group, "name", s->name) && h5_text(group, "kind", s->kind) &&
                   h5_text(group, "section", s->section) && number_write(group, "from", s->from) &&
                   number_write(group, "to", s->to) && number_write(group, "diameter", s->diameter) &&
                   number_write(group, "width", s->width) && number_write(group, "height", s->height) &&
                   number_write(group, "endless", s->endless) && h5_numbers(group, "normal", 3, s->normal);
    if (group >= 0) h5_leave(group);
    return ok;
}

static int reel_write(hid_t file, const GeometryReel *r)
{
    if (!r->present) return 1;
    const hid_t group = h5_group(file, "geometry/reel");
    const int ok = group >= 0 && h5_numbers(group, "centre", 3, r->centre) && h5_numbers(group, "axis", 3, r->axis) &&
                   number_write(group, "barrel_radius", r->barrel) && number_write(group, "flange_radius", r->flange) &&
                   number_write(group, "width", r->width);
    if (group >= 0) h5_leave(group);
    return ok;
}

static int winch_write(hid_t file, const GeometryWinch *w)
{
    if (!w->present) return 1;
    const hid_t group = h5_group(file, "geometry/winch");
    const int ok =
        group >= 0 && h5_numbers(group, "position", 3, w->position) && h5_numbers(group, "direction", 3, w->direction);
    if (group >= 0) h5_leave(group);
    return ok;
}

static int seen_write(hid_t file, const GeometrySeen *s)
{
    if (s->given == 0) return 1;
    const double given = s->given;
    const hid_t group = h5_group(file, "environment");
    const int ok = group >= 0 && h5_numbers(group, "given", 1, &given) && h5_numbers(group, "error", 1, &s->error);
    if (group >= 0) h5_leave(group);
    return ok;
}

int geometry_write(hid_t file, const Geometry *g, int *error)
{
    const hid_t group = h5_group(file, "geometry");
    int ok = group >= 0 && h5_text(group, "description", "equipment around the cable, at its initial places") &&
             h5_fixed(file, "", geometry_sets, geometry_set, g) &&
             h5_line(file, "geometry/route", "line", g->n_route, error);
    if (group >= 0) h5_leave(group);
    for (int i = 0; i < g->n_surfaces && ok; i++) ok = surface_write(file, i, &g->surface[i]);
    ok = ok && seen_write(file, &g->seen) && reel_write(file, &g->reel) && winch_write(file, &g->winch);
    const hid_t chain = ok ? h5_group(file, "chain") : -1;
    ok = chain >= 0 && h5_text(chain, "part_names", "cable, rope");
    if (chain >= 0) h5_leave(chain);
    return ok;
}

/* Check that the files of a folder belong to one run. Readers of CSV would not ignore a run's identity in a table, so
 * that the summary has the hashes of all tables; results.h5 has the run's identity and the hash of the series. */

/* Memory that HDF5 may take to open a file and read two attributes, bytes. */
enum { HDF5_ROOM = 4 << 20 };

/* Returns the summary's entry of a file; NULL: there is none. */
static const json_t *said_of(const json_t *files, const char *name)
{
    size_t k;
    json_t *file;
    json_array_foreach(files, k, file)
    {
        const char *const said = json_string_value(json_object_get(file, "file"));
        if (said && !strcmp(said, name)) return file;
    }
    return NULL;
}

/* Checks that an existing table is the one that the run has written. */
static hawser_status table_check(const OutDir *dir, const json_t *files, const char *name, hawser_error *err)
{
    FileSum sum;
    const hawser_status status = file_sum(dir, name, &sum, err);
    if (status || sum.bytes < 0) return status;
    const json_t *const said = said_of(files, name);
    const char *const wanted = json_string_value(json_object_get(said, "sum"));
    if (wanted && !strcmp(wanted, sum.sum)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "'%.500s/%s' does not belong to the summary beside it: %s", dir->path, name,
                     said ? "it is of another run, or was changed after this one"
                          : "this run has written no such file");
}

int states_belong(hid_t file, const char *run, const char *series)
{
    char has_run[DOOR_TEXT_MAX], has_series[DOOR_TEXT_MAX];
    door_text(file, "run", has_run);
    door_text(file, "series", has_series);
    return (!run || !*run || !strcmp(run, has_run)) && (!series || !strcmp(series, has_series));
}

/* Identity of the states' run and series. */
typedef struct Belonging {
    const OutDir *dir;
    const char *run, *series;
} Belonging;

/* Prints a word if they are of another one. A file that cannot be opened is accepted: its reader reports it. */
static hawser_status belonging_read(void *user, FILE *out, hawser_error *err)
{
    const Belonging *const b = user;
    StatesFile states;
    (void)err;
    states_open(&states, b->dir);
    if (states.file >= 0 && !states_belong(states.file, b->run, b->series)) fputs("another", out);
    states_close(&states);
    return HAWSER_OK;
}

/* Checks that the states are those of the run; those of a finished run must fit its series, too. */
static hawser_status states_check(const OutDir *dir, const char *run, const char *series, hawser_error *err)
{
    static const char *const name = STATES_FILE;
    Belonging b = {dir, run, series};
    int broken = 0, died;
    char *said;
    size_t size;
    hawser_status status = file_broken(dir, name, &broken, err);
    if (status) return status;
    if (broken)
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.600s/%s' is damaged: its bytes are not those that the run has written", dir->path, name);
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd < 0) return HAWSER_OK; /* nothing to check */
    close(fd);
    if (!memory_room(HDF5_ROOM)) return error_memory(err);
    status = apart_do(belonging_read, &b, &said, &size, &died, err);
    free(said);
    if (died && !status)
        return error_set(err, HAWSER_ERR_INPUT, "'%.600s/%s' is damaged: HDF5 does not survive to read it", dir->path,
                         name);
    if (status || size == 0) return status;
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.600s/%s' does not belong to the summary beside it: it is of another run", dir->path, name);
}

/* Reads a file of JSON; *json NULL: it does not exist. Without memory jansson reports a wrong syntax error, so that
 * memory is checked before, and reading is tried twice. Errors: INPUT, MEMORY. */
static hawser_status json_read(const OutDir *dir, const char *name, json_t **json, hawser_error *err)
{
    enum { MORE = 1 << 16, TIMES = 24, MOST = 1 << 28 };
    json_error_t where;
    OutSpot spot;
    char *text = NULL;
    size_t size;
    *json = NULL;
    hawser_status status = out_spot(&spot, dir, name, err);
    if (!status) status = file_whole_in(dir->at, name, spot.path, MOST, &text, &size, err);
    if (!text) return status;
    const int room = memory_room(MORE + TIMES * size);
    for (int twice = 0; twice < 2 && room && !*json; twice++)
        *json = json_loadb(text, size, JSON_REJECT_DUPLICATES, &where);
    if (!room)
        status = error_memory(err);
    else if (!*json)
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read '%.600s': %.200s", spot.path, where.text);
    free(text);
    return status;
}

/* Checks the run's identity in a derived file. */
static hawser_status companion_check(const OutDir *dir, const char *run, const char *name, hawser_error *err)
{
    json_t *json = NULL;
    hawser_status status = json_read(dir, name, &json, err);
    const char *const said = json_string_value(json_object_get(json, "run"));
    if (json && (!said || strcmp(said, run) != 0))
        status = error_set(err, HAWSER_ERR_INPUT, "'%.600s/%s' does not belong to the summary beside it: %s", dir->path,
                           name, said ? "it is of another run" : "it names no run");
    json_decref(json);
    return status;
}

/* Checks before a run continues: its checkpoint may have come from elsewhere. A missing summary is accepted. */
hawser_status summary_is_of(const OutDir *dir, const char *run, hawser_error *err)
{
    json_t *summary = NULL;
    hawser_status status = out_own(json_read(dir, "summary.json", &summary, err), err);
    const char *const there = json_string_value(json_object_get(summary, "run"));
    if (!status && run && *run && there && strcmp(run, there) != 0)
        status = error_set(err, HAWSER_ERR_OUTPUT,
                           "cannot go on in '%.600s': its results are of another run than its checkpoint", dir->path);
    json_decref(summary);
    return status;
}

/* Checks first that no other run has taken the folder since the figures were computed. */
hawser_status companion_write(const char *dir, const char *name, const char *text, hawser_error *err)
{
    OutDir folder = {.at = -1};
    json_t *summary = NULL, *const own = json_loads(text, 0, NULL);
    const char *const run = json_string_value(json_object_get(own, "run"));
    hawser_status status = out_make_dir(dir, err);
    if (!status) status = out_enter(&folder, dir, err);
    if (!status) status = json_read(&folder, "summary.json", &summary, err);
    if (status == HAWSER_ERR_INPUT) status = HAWSER_OK; /* nothing to check */
    const char *const there = json_string_value(json_object_get(summary, "run"));
    if (!status && run && *run && there && strcmp(run, there) != 0)
        status = error_set(err, HAWSER_ERR_OUTPUT,
                           "cannot write '%.500s/%s': the results in this folder are of another run", dir, name);
    if (!status) status = out_whole_in(&folder, name, text, err);
    out_leave(&folder);
    json_decref(summary);
    json_decref(own);
    return status;
}

int is_running(const json_t *summary)
{
    const char *const outcome = json_string_value(json_object_get(summary, "outcome"));
    return outcome && !strcmp(outcome, "running");
}

hawser_status belong_check(const OutDir *dir, const json_t *summary, hawser_error *err)
{
    const json_t *const files = json_object_get(summary, "files");
    const char *const run = json_string_value(json_object_get(summary, "run"));
    const int listed = json_is_array(files) && !is_running(summary); /* its tables grow until the end */
    hawser_status status = HAWSER_OK;
    if (!run) return HAWSER_OK; /* from a hawser that did not store it yet */
    for (int k = 0; k < FILE_SUMS_MAX && !status && listed; k++) status = table_check(dir, files, sum_files[k], err);
    if (!status) status = companion_check(dir, run, "certificate.json", err);
    if (!status) status = companion_check(dir, run, "sensitivities.json", err);
    if (status) return status;
    return states_check(dir, run, json_string_value(json_object_get(said_of(files, "series.csv"), "sum")), err);
}
