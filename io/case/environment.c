#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/case_parts.h"
#include "survey/model.h"

enum { FILE_MAX = 1000 };

static const char *const ups[] = {"y", "z", NULL};

/* A model of the list. */
typedef struct ModelRecord {
    char file[FILE_MAX];
    double unit, along, turn, friction;
    int up, contact, clearance;
    Vec3 at, from;
    MarksRule rule;
} ModelRecord;

typedef struct PairRecord {
    Vec3 model, world;
} PairRecord;

static const CaseKey pair_keys[] = {
    {"model", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-1e8, 1e8), AT(PairRecord, model)},
    {"world", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-1e8, 1e8), AT(PairRecord, world)},
};

static SECTION(pair, "environment.N.points.N", pair_keys);

static const CaseKey model_keys[] = {
    {"file", KEY_TEXT, .required = 1, AT(ModelRecord, file)},
    {"unit", KEY_NUMBER, DIM_LENGTH, .otherwise = "as the file says; needed where it does not", ABOVE(0, 1e4),
     AT(ModelRecord, unit)},
    {"up", KEY_CHOICE, .otherwise = "as the file says; needed where it does not", .choices = ups, AT(ModelRecord, up)},
    {"at", KEY_POINT, DIM_LENGTH, .otherwise = "its own coordinates are those of the route", FROM(-1e8, 1e8),
     AT(ModelRecord, at)},
    {"from", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-1e8, 1e8), AT(ModelRecord, from)},
    {"along", KEY_NUMBER, DIM_LENGTH, .otherwise = "none", FROM(0, LONG), AT(ModelRecord, along)},
    {"turn", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(ModelRecord, turn)},
    {"points", KEY_LIST, .otherwise = "none", .form = "two points, each in the model and in the world",
     .section = &pair},
    {"layers", KEY_LIST, .otherwise = "all", .form = "patterns of names, such as wall*"},
    {"leave", KEY_LIST, .otherwise = "none", .form = "patterns of names, such as wall*"},
    {"friction", KEY_NUMBER, .otherwise = "the case's", FROM(0, 10), AT(ModelRecord, friction)},
    {"contact", KEY_FLAG, .fallback = "true", AT(ModelRecord, contact)},
    {"clearance", KEY_FLAG, .fallback = "true", AT(ModelRecord, clearance)},
    {"equipment", KEY_MAP, .otherwise = "none", .form = "what the parts of each pattern of names are",
     .section = &case_drawn_layer},
    MARKS_KEYS(ModelRecord, rule),
};

SECTION(case_environment, "environment.N", model_keys);

/* (EN3): p = to + Rz(angle) (q - from), q in the model, m with z upward; p relative to the route's origin. */
typedef struct ModelPlace {
    Vec3 from, to;
    double c, s; /* cosine and sine of the angle */
} ModelPlace;

static Vec3 placed(const ModelPlace *p, Vec3 q)
{
    const Vec3 d = v3_sub(q, p->from);
    return v3_add(p->to, v3(p->c * d.x - p->s * d.y, p->s * d.x + p->c * d.y, d.z));
}

/* Distances of two points in the model and in the world may differ by this much, m and 1: they are measured. */
static const double PAIR_OFF = 0.02, PAIR_SHARE = 1e-3;

/* Finds the place from two points: their middles fall together, and the line between them points the same way in plan,
 * (EN3). */
static hawser_status pairs_place(const CaseReader *r, const CaseNode *list, ModelPlace *out, double *angle)
{
    PairRecord p[2];
    if (list->count != 2) return case_value_error(r->err, list, ": expected two points");
    for (int i = 0; i < 2; ++i) {
        p[i] = (PairRecord){.model = V3_ZERO};
        const hawser_status status = case_section_read(r, case_node_item(list, i), &pair, &p[i]);
        if (status) return status;
    }
    const Vec3 a = v3_sub(p[1].model, p[0].model), b = v3_sub(p[1].world, p[0].world);
    const double in_model = v3_norm(a), in_world = v3_norm(b), flat = fmin(hypot(a.x, a.y), hypot(b.x, b.y));
    const double allowed = PAIR_OFF + PAIR_SHARE * in_world;
    if (!(flat > allowed))
        return case_value_error(r->err, list, ": the points must be apart in plan, by more than %.3g m", allowed);
    if (fabs(in_model - in_world) > allowed || fabs(a.z - b.z) > allowed)
        return case_value_error(r->err, list,
                                ": the points are %.6g m apart in the model, %.6g m of it upward, and %.6g m in the "
                                "world, %.6g m of it upward: allowed is a difference of %.3g m (unit, up)",
                                in_model, a.z, in_world, b.z, allowed);
    *angle = atan2(b.y, b.x) - atan2(a.y, a.x);
    out->from = v3_scale(0.5, v3_add(p[0].model, p[1].model));
    out->to = v3_sub(v3_scale(0.5, v3_add(p[0].world, p[1].world)), r->def->route_origin);
    return HAWSER_OK;
}

static hawser_status place_find(const CaseReader *r, const CaseNode *node, const ModelRecord *in, ModelPlace *out)
{
    static const char *const ways[] = {"at", "along", "points"};
    const CaseNode *given = NULL;
    double angle = in->turn;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < 3; ++i) {
        const CaseNode *const way = case_node_key(node, ways[i]);
        if (way && given) return case_key_error(r->err, way, NULL, "beside '%s': give one of them", given->key);
        if (way) given = way;
    }
    *out = (ModelPlace){.from = in->from, .to = v3_sub(in->at, r->def->route_origin)};
    if (given && !strcmp(given->key, "along")) {
        if (in->along > r->route.length)
            return case_value_error(r->err, given, " is out of range: must be on the route, at most %.10g m",
                                    r->route.length);
        const RoutePoint at = route_at(&r->route, in->along);
        out->to = at.position;
        angle += atan2(at.tangent.y, at.tangent.x);
    } else if (given && !strcmp(given->key, "points")) {
        static const char *const others[] = {"from", "turn"};
        for (int i = 0; i < 2; ++i)
            if (case_node_key(node, others[i]))
                return case_key_error(r->err, node, others[i], "not beside 'points', which give the place");
        status = pairs_place(r, given, out, &angle);
    }
    out->c = cos(angle);
    out->s = sin(angle);
    return status;
}

/* ------------------------------------------------------------------------------------------------- reading */

/* Reads a list of patterns; the texts stay in the tree. */
static hawser_status patterns_read(const CaseReader *r, const CaseNode *list, ModelPatterns *out)
{
    out->pattern = calloc((size_t)(list ? list->count : 0) + 1, sizeof *out->pattern);
    if (!out->pattern) return error_memory(r->err);
    for (const CaseNode *item = list ? list->first : NULL; item; item = item->next) {
        if (list->kind == NODE_LIST && item->kind != NODE_TEXT)
            return case_value_error(r->err, item, ": expected a pattern of names, such as wall*");
        out->pattern[out->n++] = list->kind == NODE_MAP ? item->key : item->text;
    }
    return HAWSER_OK;
}

/* Adds a placed model to those of the case. 0: no memory, or too many triangles. */
static int mesh_add(const Mesh *from, Mesh *to)
{
    MeshBuild build = {.mesh = *to};
    const int before = to->n_layers;
    int *const vertex = malloc(((size_t)from->n_vertices + 1) * sizeof *vertex);
    int fine = vertex != NULL;
    for (int v = 0; v < from->n_vertices && fine; ++v) {
        vertex[v] = mesh_add_vertex(&build, from->vertex[v]);
        fine = vertex[v] >= 0;
    }
    for (int k = 0; k < from->n_layers && fine; ++k) fine = mesh_append_layer(&build.mesh, from->layer_name[k]);
    for (int t = 0; t < from->n_triangles && fine; ++t)
        fine = mesh_add_triangle(&build, vertex[from->triangle[t][0]], vertex[from->triangle[t][1]],
                                 vertex[from->triangle[t][2]], before + from->layer[t]) >= 0;
    mesh_build_end(&build);
    free(vertex);
    *to = build.mesh;
    return fine;
}

/* Takes a model's mesh over into the case, at its place, with its layers' friction. */
static hawser_status mesh_join(const CaseReader *r, Mesh *from, const ModelPlace *place, const ModelRecord *in,
                               const char *file)
{
    EnvironmentDef *const to = &r->def->environment;
    const int before = to->mesh.n_layers;
    int fine = 1;
    for (int v = 0; v < from->n_vertices; ++v) v3_put(from->vertex[v], placed(place, v3_get(from->vertex[v])));
    if (before > 0) {
        fine = mesh_add(from, &to->mesh);
    } else {
        mesh_free(&to->mesh);
        to->mesh = *from; /* the first one needs no copy */
        *from = (Mesh){0};
    }
    const size_t n = (size_t)to->mesh.n_layers + 1;
    double *const friction = realloc(to->friction, n * sizeof *friction);
    if (friction) to->friction = friction;
    bool *const clear = realloc(to->clear, n * sizeof *clear);
    if (clear) to->clear = clear;
    for (int k = before; k < to->mesh.n_layers && friction && clear; ++k) {
        friction[k] = in->contact ? in->friction : -1;
        clear[k] = in->clearance;
    }
    to->touched = to->touched || in->contact;
    if (fine && friction && clear) return HAWSER_OK;
    if (to->mesh.n_triangles < MESH_MOST && to->mesh.n_vertices < MESH_MOST) return error_memory(r->err);
    return error_set(r->err, HAWSER_ERR_INPUT, "%.200s: more than %d triangles in all", file, MESH_MOST);
}

/* Reads the file of a model, and puts its triangles and its equipment into the case. */
static hawser_status model_take(CaseReader *r, const CaseNode *node, const ModelRecord *in, const char *path,
                                const ModelOptions *options)
{
    const CaseNode *const equipment = case_node_key(node, "equipment");
    hawser_error why = {HAWSER_OK, ""};
    ModelPlace place = {.c = 1};
    Mesh mesh = {0};
    Survey found = {0};
    hawser_status status = place_find(r, node, in, &place);
    if (status) return status;
    status = model_read(path, options, &mesh, &found, &why);
    if (status) return case_key_cause(r->err, node, "file", "", &why);
    const double angle = atan2(place.s, place.c);
    for (int i = 0; i < found.n_marks; ++i) { /* in the case's coordinates, as a drawing's */
        found.mark[i].at = v3_add(placed(&place, found.mark[i].at), r->def->route_origin);
        found.mark[i].heading += angle;
    }
    status = file_marks_add(&r->def->files, path, r->err);
    if (!status) status = mesh_join(r, &mesh, &place, in, path);
    if (!status && equipment) status = case_marks_place(r, node, equipment, path, &in->rule, &found);
    for (int i = 0; i < found.n_ignored && !status; ++i)
        status = case_unread_add(r, node, found.ignored[i].what, found.ignored[i].times);
    mesh_free(&mesh);
    survey_clear(&found);
    return status;
}

static hawser_status model_item(CaseReader *r, const CaseNode *node)
{
    ModelRecord in = {.at = V3_ZERO, .up = -1};
    ModelOptions options = {0};
    char *path = NULL;
    hawser_status status = case_section_read(r, node, &case_environment, &in);
    if (!status) status = case_file_path(r, node, in.file, &path);
    if (!status) status = patterns_read(r, case_node_key(node, "layers"), &options.take);
    if (!status) status = patterns_read(r, case_node_key(node, "leave"), &options.leave);
    if (!status) status = patterns_read(r, case_node_key(node, "equipment"), &options.equipment);
    options.unit = in.unit;
    options.up = case_node_key(node, "up") ? *ups[in.up] : 0;
    if (!status) status = model_take(r, node, &in, path, &options);
    free(options.take.pattern);
    free(options.leave.pattern);
    free(options.equipment.pattern);
    free(path);
    return status;
}

hawser_status case_environment_read(CaseReader *r, const CaseNode *list)
{
    hawser_status status = HAWSER_OK;
    if (list && r->def->rod.present) return case_key_error(r->err, list, NULL, "needs a route: not with 'rod'");
    for (const CaseNode *item = list ? list->first : NULL; item && !status; item = item->next)
        status = model_item(r, item);
    return status;
}

/* Layers without a friction of their own have the case's; those that are not touched have none. */
hawser_status case_environment_settle(CaseReader *r, const CaseNode *list)
{
    EnvironmentDef *const e = &r->def->environment;
    for (int k = 0; list && k < e->mesh.n_layers; ++k) {
        if (isnan(e->friction[k]))
            e->friction[k] = r->def->friction.mu_d;
        else if (e->friction[k] < 0)
            e->friction[k] = NAN;
    }
    return environment_share(e, r->err);
}
