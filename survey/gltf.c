/* GLB, the single file of glTF 2.0 (Khronos, specification 2.0.1): the nodes of its scene with the triangles of their
 * meshes. The JSON is read by jansson; the numbers are read from the file where they are needed, one array at a time.
 */
#define _GNU_SOURCE /* locale_t */
#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/input.h"
#include "survey/model.h"

enum { DEPTH_MOST = 100, NODES_MOST = 2000000, NAME_MOST = 100, JSON_CHUNK = 0x4E4F534A, BIN_CHUNK = 0x004E4942 };

/* Numbers that may be read in all: a file of MODEL_SIZE_MOST has fewer, unless its meshes are used again and again. */
static const double NUMBERS_MOST = 4e8;

enum { MODE_POINTS, MODE_TRIANGLES = 4, MODE_STRIP, MODE_FAN };

enum { TYPE_BYTE = 5120, TYPE_UBYTE, TYPE_SHORT, TYPE_USHORT, TYPE_UINT = 5125, TYPE_FLOAT };

/* p = move + m p, in m. */
typedef struct Affine {
    double m[3][3], move[3];
} Affine;

/* An array's accessor and the part of the binary chunk in which it lies. */
typedef struct GltfPlace {
    json_int_t type, size, n, offset, stride; /* size: bytes of a number; offset: from the chunk's start */
    int width, normalized;
} GltfPlace;

/* An array of the file: place.n items of place.width numbers. */
typedef struct GltfArray {
    json_int_t accessor; /* its index; -1: none has been read */
    GltfPlace place;
    unsigned char *raw; /* as in the file, from place.offset on */
} GltfArray;

typedef struct Gltf {
    SurveyInput *in;
    const ModelOptions *options;
    MeshBuild *build;
    json_t *root;
    long bin, bin_size; /* the binary chunk in the file */
    long nodes;         /* visited so far */
    double numbers;     /* read so far */
    GltfArray position, index;
    int *vertex;   /* [position.place.n] vertices of the mesh, -1: not yet added */
    Affine placed; /* of the vertices there */
} Gltf;

/* A part that is being measured in place of being added: NULL for none. */
typedef struct Box {
    double low[3], high[3];
} Box;

/* What a node passes on to those below it. */
typedef struct Above {
    Affine place;
    const char *name;
    int depth, taken;
    Box *box;
} Above;

/* ---------------------------------------------------------------------------------------------------- JSON */

/* A whole number of an object; `otherwise` if there is none. */
static json_int_t whole(const json_t *object, const char *key, json_int_t otherwise)
{
    const json_t *const value = json_object_get(object, key);
    return json_is_integer(value) ? json_integer_value(value) : otherwise;
}

/* Item i of one of the lists at the top; NULL: there is none. */
static json_t *item(const Gltf *g, const char *list, json_int_t i)
{
    return i < 0 ? NULL : json_array_get(json_object_get(g->root, list), (size_t)i);
}

/* n numbers of a list. Returns 0, and leaves them, if there is no list. */
static int numbers_of(const json_t *object, const char *key, size_t n, double *value)
{
    const json_t *const list = json_object_get(object, key);
    if (json_array_size(list) != n) return 0;
    for (size_t i = 0; i < n; ++i) value[i] = json_number_value(json_array_get(list, i));
    return 1;
}

/* ---------------------------------------------------------------------------------------------------- arrays */

/* Finds the place of an accessor of `width` numbers an item. Errors: INPUT. */
static hawser_status place_of(const Gltf *g, json_int_t index, int width, GltfPlace *out)
{
    static const struct {
        json_int_t type, size;
    } sizes[] = {{TYPE_BYTE, 1}, {TYPE_UBYTE, 1}, {TYPE_SHORT, 2}, {TYPE_USHORT, 2}, {TYPE_UINT, 4}, {TYPE_FLOAT, 4}};
    const json_t *const a = item(g, "accessors", index);
    const json_t *const view = item(g, "bufferViews", whole(a, "bufferView", -1));
    const char *const type = json_string_value(json_object_get(a, "type"));
    const long long number = (long long)index;
    if (!a) return input_error(g->in, "accessor %lld is used and missing", number);
    if (json_object_get(a, "sparse"))
        return input_error(g->in, "accessor %lld is sparse, which is not read: save the model without", number);
    if (!view) return input_error(g->in, "accessor %lld has no bufferView that exists", number);
    if (json_object_get(json_object_get(view, "extensions"), "EXT_meshopt_compression"))
        return input_error(g->in, "its buffers are compressed by EXT_meshopt_compression: save the model without");
    if (whole(view, "buffer", -1) != 0)
        return input_error(g->in, "accessor %lld is in another file: save the model as one .glb", number);
    *out = (GltfPlace){.type = whole(a, "componentType", 0), .n = whole(a, "count", 0), .width = width};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i)
        if (sizes[i].type == out->type) out->size = sizes[i].size;
    const json_int_t own = out->size * width;
    const json_int_t from = whole(view, "byteOffset", 0), length = whole(view, "byteLength", 0);
    const json_int_t within = whole(a, "byteOffset", 0);
    out->stride = whole(view, "byteStride", own);
    out->offset = from + within;
    out->normalized = json_is_true(json_object_get(a, "normalized"));
    if (!out->size || !type || strcmp(type, width == 3 ? "VEC3" : "SCALAR"))
        return input_error(g->in, "accessor %lld: expected type %s of a known componentType", number,
                           width == 3 ? "VEC3" : "SCALAR");
    if (out->n < 1 || out->n > MESH_MOST)
        return input_error(g->in, "accessor %lld: a count of %lld: allowed is 1 to %d", number, (long long)out->n,
                           MESH_MOST);
    const int fits = from >= 0 && within >= 0 && out->stride >= own && out->stride <= 255 && length >= 0 &&
                     from <= g->bin_size && length <= g->bin_size - from && within <= length &&
                     out->stride * (out->n - 1) + own <= length - within;
    return fits ? HAWSER_OK
                : input_error(g->in, "accessor %lld lies outside of its bufferView or of the binary chunk", number);
}

/* A number of a buffer, the lowest byte first; integers may stand for fractions (`normalized`). */
static double number_at(const unsigned char *b, const GltfPlace *p)
{
    uint32_t raw = 0;
    float real;
    for (int i = 0; i < (int)p->size; ++i) raw |= (uint32_t)b[i] << 8 * i;
    memcpy(&real, &raw, sizeof real);
    if (p->type == TYPE_FLOAT) return (double)real;
    const double value = p->type == TYPE_BYTE ? (int8_t)raw : p->type == TYPE_SHORT ? (int16_t)raw : (double)raw;
    static const double full[] = {[TYPE_BYTE - TYPE_BYTE] = 127,
                                  [TYPE_UBYTE - TYPE_BYTE] = 255,
                                  [TYPE_SHORT - TYPE_BYTE] = 32767,
                                  [TYPE_USHORT - TYPE_BYTE] = 65535,
                                  [TYPE_UINT - TYPE_BYTE] = 1};
    return p->normalized ? fmax(value / full[p->type - TYPE_BYTE], -1) : value;
}

/* Number k of item i. */
static double array_number(const GltfArray *a, int i, int k)
{
    return number_at(a->raw + (size_t)i * (size_t)a->place.stride + (size_t)k * (size_t)a->place.size, &a->place);
}

/* Reads an accessor, unless it is the one that was read last. Errors: INPUT, MEMORY. */
static hawser_status array_read(Gltf *g, json_int_t accessor, int width, GltfArray *out)
{
    GltfPlace p;
    if (out->accessor == accessor && out->raw) return HAWSER_OK;
    const hawser_status status = place_of(g, accessor, width, &p);
    if (status) return status;
    g->numbers += (double)p.n * width;
    if (g->numbers > NUMBERS_MOST) return input_error(g->in, "more than %g numbers are to be read", NUMBERS_MOST);
    const size_t bytes = (size_t)((p.n - 1) * p.stride + p.size * width);
    free(out->raw);
    *out = (GltfArray){.accessor = accessor, .place = p, .raw = malloc(bytes)};
    if (!out->raw) return error_memory(g->in->err);
    input_seek(g->in, g->bin + (long)p.offset);
    return fread(out->raw, 1, bytes, g->in->file) == bytes
               ? HAWSER_OK
               : input_error(g->in, "the file ends inside of its binary chunk");
}

/* ---------------------------------------------------------------------------------------------------- meshes */

static void moved(const Affine *a, const double p[3], double out[3])
{
    for (int i = 0; i < 3; ++i) out[i] = a->move[i] + a->m[i][0] * p[0] + a->m[i][1] * p[1] + a->m[i][2] * p[2];
}

/* The mesh's vertex for position i at that place; -1: no memory, -2: no such position, -3: no finite place. */
static int vertex_of(Gltf *g, const Affine *place, Box *box, double index)
{
    double at[3];
    if (!(index >= 0 && index < (double)g->position.place.n)) return -2;
    const int i = (int)index;
    if (!box && g->vertex[i] >= 0) return g->vertex[i];
    const double own[3] = {array_number(&g->position, i, 0), array_number(&g->position, i, 1),
                           array_number(&g->position, i, 2)};
    moved(place, own, at);
    for (int k = 0; k < 3; ++k)
        if (!(fabs(at[k]) < 1e9)) return -3;
    if (box) {
        for (int k = 0; k < 3; ++k) {
            box->low[k] = fmin(box->low[k], at[k]);
            box->high[k] = fmax(box->high[k], at[k]);
        }
        return 0;
    }
    return g->vertex[i] = mesh_add_vertex(g->build, at);
}

static hawser_status vertex_error(const Gltf *g, int vertex)
{
    if (vertex == -2) return input_error(g->in, "a triangle with a vertex that does not exist");
    if (vertex == -3) return input_error(g->in, "a vertex without a place within a million km");
    if (g->build->mesh.n_vertices >= MESH_MOST || g->build->mesh.n_triangles >= MESH_MOST)
        return input_error(g->in, "more than %d triangles or vertices", MESH_MOST);
    return error_memory(g->in->err);
}

/* Which corners the t-th triangle has: of a strip every other one is turned. */
static void corners_of(json_int_t mode, int t, int corner[3])
{
    const int odd = mode == MODE_STRIP && (t & 1);
    corner[0] = mode == MODE_TRIANGLES ? 3 * t : mode == MODE_FAN ? 0 : t + odd;
    corner[1] = mode == MODE_TRIANGLES ? 3 * t + 1 : mode == MODE_FAN ? t + 1 : t + !odd;
    corner[2] = mode == MODE_TRIANGLES ? 3 * t + 2 : t + 2;
}

/* Adds triangles or points whose positions and indices have been read. mirrored: the place turns them inside out. */
static hawser_status shapes_add(Gltf *g, const Affine *place, Box *box, json_int_t mode, int indexed, int mirrored,
                                int layer)
{
    const int n = (int)(indexed ? g->index.place.n : g->position.place.n);
    const int shapes = mode == MODE_POINTS ? n : mode == MODE_TRIANGLES ? n / 3 : n - 2;
    for (int t = 0; t < shapes; ++t) {
        int corner[3] = {t, t, t}, v[3];
        if (mode != MODE_POINTS) corners_of(mode, t, corner);
        for (int k = 0; k < 3; ++k) {
            v[k] = vertex_of(g, place, box, indexed ? array_number(&g->index, corner[k], 0) : corner[k]);
            if (v[k] < 0) return vertex_error(g, v[k]);
        }
        if (!box && mesh_add_triangle(g->build, v[0], v[1 + mirrored], v[2 - mirrored], layer) < 0)
            return vertex_error(g, -1);
    }
    return HAWSER_OK;
}

static hawser_status primitive_add(Gltf *g, const json_t *primitive, const Affine *place, Box *box, int layer)
{
    const json_int_t mode = whole(primitive, "mode", MODE_TRIANGLES), indices = whole(primitive, "indices", -1);
    const json_int_t position = whole(json_object_get(primitive, "attributes"), "POSITION", -1);
    if (json_object_get(json_object_get(primitive, "extensions"), "KHR_draco_mesh_compression"))
        return input_error(g->in, "its meshes are compressed by KHR_draco_mesh_compression: save the model without");
    if (mode != MODE_POINTS && (mode < MODE_TRIANGLES || mode > MODE_FAN)) {
        survey_ignore(g->in->out, "lines of a mesh");
        return HAWSER_OK;
    }
    if (position < 0) {
        survey_ignore(g->in->out, "parts of a mesh without positions");
        return HAWSER_OK;
    }
    const int again = g->position.accessor == position && g->vertex && !memcmp(&g->placed, place, sizeof *place);
    hawser_status status = array_read(g, position, 3, &g->position);
    if (!status && indices >= 0) status = array_read(g, indices, 1, &g->index);
    if (status) return status;
    if (!again) {
        int *const vertex = realloc(g->vertex, (size_t)g->position.place.n * sizeof *vertex);
        if (!vertex) return error_memory(g->in->err);
        g->vertex = vertex;
        g->placed = *place;
        memset(vertex, 0xFF, (size_t)g->position.place.n * sizeof *vertex); /* -1 */
    }
    const double(*const m)[3] = place->m;
    const double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return shapes_add(g, place, box, mode, indices >= 0, det < 0, layer);
}

/* ---------------------------------------------------------------------------------------------------- nodes */

static Affine composed(const Affine *a, const Affine *b)
{
    Affine c;
    moved(a, b->move, c.move);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j];
    return c;
}

/* The node's own place: a matrix by columns, or a move, a rotation (x, y, z, w) and a scale by axis. */
static Affine place_of_node(const json_t *node)
{
    double t[3] = {0, 0, 0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1}, given[16];
    Affine a;
    if (numbers_of(node, "matrix", 16, given)) {
        for (int i = 0; i < 3; ++i) {
            a.move[i] = given[12 + i];
            for (int j = 0; j < 3; ++j) a.m[i][j] = given[4 * j + i];
        }
        return a;
    }
    numbers_of(node, "translation", 3, t);
    numbers_of(node, "rotation", 4, q);
    numbers_of(node, "scale", 3, s);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int i = 0; i < 3; ++i) {
        a.move[i] = t[i];
        for (int j = 0; j < 3; ++j) a.m[i][j] = r[i][j] * s[j];
    }
    return a;
}

/* Adds the node's own mesh. A shape that its own weights or bones change is not the one that is drawn. */
static hawser_status node_mesh_add(Gltf *g, const json_t *node, const Above *own)
{
    const json_t *const mesh = item(g, "meshes", whole(node, "mesh", -1));
    const json_t *const primitives = json_object_get(mesh, "primitives");
    const json_t *weights = json_object_get(node, "weights");
    const char *const name = json_string_value(json_object_get(mesh, "name"));
    int changed = json_object_get(node, "skin") != NULL, layer = 0;
    hawser_status status = HAWSER_OK;
    if (!json_object_get(node, "mesh")) return HAWSER_OK;
    if (!mesh) return input_error(g->in, "node '%.60s' uses a mesh that is missing", own->name);
    if (!weights) weights = json_object_get(mesh, "weights");
    for (size_t i = 0; i < json_array_size(weights); ++i) changed |= json_number_value(json_array_get(weights, i)) != 0;
    if (changed) {
        survey_ignore(g->in->out, "nodes whose shape is changed by bones or targets");
        return HAWSER_OK;
    }
    if (!own->box) layer = model_layer_add(g->build, *own->name ? own->name : name ? name : "");
    if (layer < 0) return vertex_error(g, -1);
    for (size_t i = 0; i < json_array_size(primitives) && !status; ++i)
        status = primitive_add(g, json_array_get(primitives, i), &own->place, own->box, layer);
    return status;
}

static hawser_status node_visit(Gltf *g, json_int_t index, const Above *above);

static hawser_status children_visit(Gltf *g, const json_t *node, const Above *own)
{
    const json_t *const children = json_object_get(node, "children");
    hawser_status status = own->taken || own->box ? node_mesh_add(g, node, own) : HAWSER_OK;
    for (size_t i = 0; i < json_array_size(children) && !status; ++i) {
        const json_t *const child = json_array_get(children, i);
        status = node_visit(g, json_is_integer(child) ? json_integer_value(child) : -1, own);
    }
    return status;
}

/* Measures a node that is equipment, and adds it as a part. */
static hawser_status part_visit(Gltf *g, const json_t *node, const Above *own, int pattern)
{
    Box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    Above below = *own;
    below.box = &box;
    const hawser_status status = children_visit(g, node, &below);
    if (status) return status;
    if (!(box.low[0] <= box.high[0])) memcpy(box.low, own->place.move, sizeof box.low);
    if (!(box.low[0] <= box.high[0])) memcpy(box.high, own->place.move, sizeof box.high);
    const double x = own->place.m[0][0], y = own->place.m[1][0], z = own->place.m[2][0];
    const double heading = hypot(x, y) > 1e-6 * fabs(z) ? atan2(y, x) : NAN;
    return model_part_add(g->in->out, g->options->equipment.pattern[pattern], own->name, box.low, box.high, heading)
               ? HAWSER_OK
               : error_memory(g->in->err);
}

/* Adds a node with all below it. */
static hawser_status node_visit(Gltf *g, json_int_t index, const Above *above)
{
    const json_t *const node = item(g, "nodes", index);
    if (!node) return input_error(g->in, "node %lld is used and missing", (long long)index);
    if (above->depth >= DEPTH_MOST) return input_error(g->in, "nodes within each other, more than %d deep", DEPTH_MOST);
    if (++g->nodes > NODES_MOST) return input_error(g->in, "more than %d nodes", NODES_MOST);
    const char *const name = json_string_value(json_object_get(node, "name"));
    const Affine place = place_of_node(node);
    Above own = {composed(&above->place, &place), name && *name ? name : above->name, above->depth + 1, above->taken,
                 above->box};
    if (json_object_get(json_object_get(node, "extensions"), "EXT_mesh_gpu_instancing"))
        return input_error(g->in, "node '%.60s' has instances by EXT_mesh_gpu_instancing: save the model without",
                           own.name);
    if (above->box || !name) return children_visit(g, node, &own);
    if (model_match(&g->options->leave, name) >= 0) return HAWSER_OK;
    const int part = model_match(&g->options->equipment, name);
    own.taken |= model_match(&g->options->take, name) >= 0;
    return part >= 0 ? part_visit(g, node, &own, part) : children_visit(g, node, &own);
}

/* Adds the roots of the scene: those it lists, or without a scene all nodes that are nobody's child. */
static hawser_status scene_visit(Gltf *g, const Above *top)
{
    const json_t *const scene = item(g, "scenes", whole(g->root, "scene", 0));
    const json_t *const nodes = json_object_get(g->root, "nodes"), *const roots = json_object_get(scene, "nodes");
    const size_t n = json_array_size(nodes);
    hawser_status status = HAWSER_OK;
    for (size_t i = 0; i < json_array_size(roots) && !status; ++i) {
        const json_t *const root = json_array_get(roots, i);
        status = node_visit(g, json_is_integer(root) ? json_integer_value(root) : -1, top);
    }
    if (scene) return status;
    char *const child = calloc(n + 1, 1);
    if (!child) return error_memory(g->in->err);
    for (size_t i = 0; i < n; ++i) {
        const json_t *const children = json_object_get(json_array_get(nodes, i), "children");
        for (size_t k = 0; k < json_array_size(children); ++k) {
            const json_int_t c = json_integer_value(json_array_get(children, k));
            if (c >= 0 && c < (json_int_t)n) child[c] = 1;
        }
    }
    for (size_t i = 0; i < n && !status; ++i)
        if (!child[i]) status = node_visit(g, (json_int_t)i, top);
    free(child);
    return status;
}

/* ---------------------------------------------------------------------------------------------------- the file */

/* Extensions without which the shape is right; others that a file requires are refused by name. */
static hawser_status required_check(const Gltf *g)
{
    static const char *const harmless[] = {"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_",
                                           "KHR_lights_"};
    const json_t *const required = json_object_get(g->root, "extensionsRequired");
    for (size_t i = 0; i < json_array_size(required); ++i) {
        const char *const name = json_string_value(json_array_get(required, i));
        int fine = !name;
        for (size_t k = 0; k < sizeof harmless / sizeof *harmless && !fine; ++k)
            fine = !strncmp(name, harmless[k], strlen(harmless[k]));
        if (!fine) return input_error(g->in, "it requires %.60s, which is not read: save the model without", name);
    }
    return HAWSER_OK;
}

static uint32_t word_at(const unsigned char *b)
{
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* Reads the header, the chunk of JSON, and the place of the binary one. */
static hawser_status chunks_read(Gltf *g)
{
    SurveyInput *const in = g->in;
    unsigned char head[20], next[8];
    json_error_t why;
    const size_t got = fread(head, 1, sizeof head, in->file);
    if (got < sizeof head || word_at(head + 4) != 2)
        return input_error(in, "expected a GLB file of version 2, got version %u", got < 8 ? 0 : word_at(head + 4));
    const uint32_t size = word_at(head + 12);
    if (word_at(head + 16) != JSON_CHUNK) return input_error(in, "its first chunk is not JSON");
    if (size > MODEL_JSON_MOST) return input_error(in, "%u bytes of JSON: allowed are %d", size, MODEL_JSON_MOST);
    char *const text = malloc((size_t)size + 1);
    if (!text) return error_memory(in->err);
    const size_t read = fread(text, 1, size, in->file);
    if (read == size) g->root = json_loadb(text, size, 0, &why);
    free(text);
    if (read < size) return input_error(in, "the file ends inside of its JSON");
    if (!g->root) return input_error(in, "its JSON: %.100s", why.text);
    if (fread(next, 1, sizeof next, in->file) == sizeof next && word_at(next + 4) == BIN_CHUNK) {
        g->bin = 20 + (long)size + 8;
        g->bin_size = (long)word_at(next);
    }
    if (fseek(in->file, 0, SEEK_END) || ftell(in->file) < g->bin + g->bin_size)
        return input_error(in, "the file ends inside of its binary chunk");
    return required_check(g);
}

hawser_status gltf_read(SurveyInput *in, const ModelOptions *options, MeshBuild *build)
{
    Gltf g = {.in = in, .options = options, .build = build, .position.accessor = -1, .index.accessor = -1};
    const double u = isnan(options->unit) ? 1 : options->unit; /* the format's unit is m, its y points upward */
    const Above top = {.place = options->up == 'z' ? (Affine){{{u, 0, 0}, {0, u, 0}, {0, 0, u}}, {0}}
                                                   : (Affine){{{u, 0, 0}, {0, 0, -u}, {0, u, 0}}, {0}},
                       .name = "",
                       .taken = options->take.n == 0};
    hawser_status status = chunks_read(&g);
    if (!status) status = scene_visit(&g, &top);
    json_decref(g.root);
    free(g.position.raw);
    free(g.index.raw);
    free(g.vertex);
    return status;
}
