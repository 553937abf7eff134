#define _GNU_SOURCE /* locale_t */
#include "survey/model.h"

#include <fnmatch.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "survey/input.h"

int model_match(const ModelPatterns *patterns, const char *name)
{
    for (int i = 0; i < patterns->n; ++i)
        if (!fnmatch(patterns->pattern[i], name, FNM_NOESCAPE)) return i;
    return -1;
}

int model_layer_add(MeshBuild *build, const char *name)
{
    char own[SURVEY_NAME_MAX];
    snprintf(own, sizeof own, "%s", name);
    text_make_printable(own);
    text_make_utf8(own);
    return mesh_add_layer(build, own);
}

int model_part_add(Survey *found, const char *pattern, const char *name, const double low[3], const double high[3],
                   double heading)
{
    char full[SURVEY_NAME_MAX];
    snprintf(full, sizeof full, "part: %.100s", name);
    SurveyMark *const mark = survey_add_mark(found, full, pattern);
    if (!mark) return 0;
    mark->at = v3((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
    mark->heading = heading;
    return 1;
}

/* ---------------------------------------------------------------------------------------------------- STL */

/* Adds a vertex of an STL file in the model's own axes. -1: an error, which is set. */
static int corner_add(const SurveyInput *in, const ModelOptions *o, MeshBuild *build, const double p[3])
{
    const double u = o->unit,
                 at[3] = {u * p[0], o->up == 'y' ? -u * p[2] : u * p[1], o->up == 'y' ? u * p[1] : u * p[2]};
    for (int k = 0; k < 3; ++k)
        if (!(fabs(at[k]) < 1e9)) return input_error(in, "a vertex without a place within a million km"), -1;
    const int v = mesh_add_vertex(build, at);
    if (v < 0 && build->mesh.n_vertices >= MESH_MOST)
        input_error(in, "more than %d vertices", MESH_MOST);
    else if (v < 0)
        error_memory(in->err);
    return v;
}

static hawser_status facet_add(const SurveyInput *in, MeshBuild *build, const int v[3], int layer)
{
    if (mesh_add_triangle(build, v[0], v[1], v[2], layer) >= 0) return HAWSER_OK;
    if (build->mesh.n_triangles >= MESH_MOST) return input_error(in, "more than %d triangles", MESH_MOST);
    return error_memory(in->err);
}

/* Returns the layer of a solid's name, or -2: it is left out; -1: no memory. */
static int solid_layer(const ModelOptions *o, MeshBuild *build, const char *name)
{
    const int part = model_match(&o->equipment, name) >= 0;
    if (model_match(&o->leave, name) >= 0 || (!part && o->take.n && model_match(&o->take, name) < 0)) return -2;
    return model_layer_add(build, name);
}

/* 80 bytes, the number of triangles, and 50 bytes for each: normal, three corners, and two bytes more. */
enum { STL_HEAD = 84, STL_FACET = 50 };

static hawser_status stl_binary_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build, const char *base,
                                     uint32_t n)
{
    unsigned char facet[STL_FACET];
    const int layer = solid_layer(o, build, base);
    hawser_status status = layer == -1 ? error_memory(in->err) : HAWSER_OK;
    input_seek(in, STL_HEAD);
    for (uint32_t t = 0; t < n && !status && layer >= 0; ++t) {
        int v[3];
        if (fread(facet, 1, sizeof facet, in->file) < sizeof facet) return input_error(in, "the file ends too early");
        for (int c = 0; c < 3 && !status; ++c) {
            double p[3];
            for (int k = 0; k < 3; ++k) {
                const unsigned char *const b = facet + 12 + 12 * c + 4 * k;
                const uint32_t raw = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
                float real;
                memcpy(&real, &raw, sizeof real);
                p[k] = (double)real;
            }
            v[c] = corner_add(in, o, build, p);
            if (v[c] < 0) status = in->err->status;
        }
        if (!status) status = facet_add(in, build, v, layer);
    }
    return status;
}

/* Reads "vertex x y z" behind its word. */
static hawser_status corner_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build, const char *text, int *v)
{
    double p[3];
    for (int k = 0; k < 3; ++k) {
        char *end;
        if (!input_number(in, text, &end, &p[k])) return input_error(in, "a vertex without three numbers");
        text = end;
    }
    *v = corner_add(in, o, build, p);
    return *v < 0 ? in->err->status : HAWSER_OK;
}

/* Reads "solid NAME", "facet", "vertex x y z" and "endfacet", a line each. */
static hawser_status stl_text_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build, const char *base)
{
    InputLine line = {0};
    int layer = -2, n = 0, v[3] = {0}, more;
    hawser_status status = HAWSER_OK;
    while (!status && (more = input_line(in, &line)) > 0) {
        const char *const word = line.text + strspn(line.text, " \t");
        if (!strncmp(word, "solid", 5)) {
            const char *const name = word + 5 + strspn(word + 5, " \t");
            layer = solid_layer(o, build, *name ? name : base);
            if (layer == -1) status = error_memory(in->err);
        } else if (!strncmp(word, "facet", 5)) {
            n = 0;
        } else if (!strncmp(word, "vertex", 6) && layer >= 0) {
            if (n < 3) status = corner_read(in, o, build, word + 6, &v[n]);
            ++n;
        } else if (!strncmp(word, "endfacet", 8) && layer >= 0) {
            status = n == 3 ? facet_add(in, build, v, layer) : input_error(in, "a facet of %d corners: expected 3", n);
        }
    }
    if (!status && more < 0) status = in->err->status;
    free(line.text);
    return status;
}

/* Makes parts of the solids that are equipment, in place of their triangles. Returns 0 without memory. */
static int solids_take(const ModelPatterns *equipment, Mesh *m, Survey *found)
{
    int fine = 1;
    for (int k = 0; k < m->n_layers && fine; ++k) {
        double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
        const int part = model_match(equipment, m->layer_name[k]), before = m->n_triangles;
        if (part < 0) continue;
        m->n_triangles = 0;
        for (int t = 0; t < before; ++t) {
            const int own = m->layer[t] == k;
            for (int c = 0; c < 9 && own; ++c) {
                const double at = m->vertex[m->triangle[t][c / 3]][c % 3];
                low[c % 3] = fmin(low[c % 3], at);
                high[c % 3] = fmax(high[c % 3], at);
            }
            if (own) continue;
            memcpy(m->triangle[m->n_triangles], m->triangle[t], sizeof *m->triangle);
            m->layer[m->n_triangles++] = m->layer[t];
        }
        if (low[0] <= high[0]) fine = model_part_add(found, equipment->pattern[part], m->layer_name[k], low, high, NAN);
    }
    return fine;
}

/* The size that a binary file with this head has. */
static long stl_size(const unsigned char head[STL_HEAD], uint32_t *n)
{
    *n = head[80] | (uint32_t)head[81] << 8 | (uint32_t)head[82] << 16 | (uint32_t)head[83] << 24;
    return STL_HEAD + (long)*n * STL_FACET;
}

/* A file of text may begin like a binary one, and the other way round; the size decides. */
static hawser_status stl_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build, const char *base, long size)
{
    unsigned char head[STL_HEAD] = {0};
    uint32_t n;
    const size_t got = fread(head, 1, sizeof head, in->file);
    const long whole = stl_size(head, &n);
    const int text = !strncmp((const char *)head, "solid", 5);
    if (isnan(o->unit))
        return input_error(in, "an STL file does not say its unit of length: give 'unit', such as 1 mm");
    if (!o->up) return input_error(in, "an STL file does not say which axis points upward: give 'up', y or z");
    hawser_status status = HAWSER_OK;
    input_seek(in, 0);
    if (got == sizeof head && size == whole)
        status = stl_binary_read(in, o, build, base, n);
    else if (text)
        status = stl_text_read(in, o, build, base);
    else
        status = input_error(in, "an STL file of %u triangles has %ld bytes, this one has %ld", n, whole, size);
    if (!status && !solids_take(&o->equipment, &build->mesh, in->out)) status = error_memory(in->err);
    return status;
}

/* ---------------------------------------------------------------------------------------------------- any file */

/* Faces of a drawing, whose lines count for nothing here. */
static hawser_status drawing_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build)
{
    hawser_status status = dxf_read(in);
    if (status) return status;
    if (isnan(in->options.unit) && !in->unit_known)
        return input_error(in, "the drawing does not say its unit of length ($INSUNITS): give 'unit', such as 1 mm");
    *build = in->out->faces;
    in->out->faces = (MeshBuild){0};
    for (int v = 0; o->up == 'y' && v < build->mesh.n_vertices; ++v) {
        double *const at = build->mesh.vertex[v], y = at[1];
        at[1] = -at[2];
        at[2] = y;
    }
    for (int i = 0; o->up == 'y' && i < in->out->n_marks; ++i) {
        Vec3 *const at = &in->out->mark[i].at;
        *at = v3(at->x, -at->z, at->y);
    }
    return HAWSER_OK;
}

/* Kinds of files that `hawser convert` makes a GLB file of, by the ends of their names. */
static int is_convertible(const char *path)
{
    static const char *const ends[] = {".ifc", ".obj", ".ply", ".dae", ".fbx", ".3ds", ".3mf", ".gltf", ".xyz"};
    const char *const dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof ends / sizeof *ends; ++i)
        if (!strcasecmp(dot, ends[i])) return 1;
    return 0;
}

/* Reads the file by its beginning. */
static hawser_status kind_read(SurveyInput *in, const ModelOptions *o, MeshBuild *build)
{
    char head[STL_HEAD + 1] = "", base[SURVEY_NAME_MAX];
    const char *const slash = strrchr(in->path, '/'), *const name = slash ? slash + 1 : in->path;
    const char *const dot = strrchr(name, '.'), *const end = dot ? dot : name + strlen(name);
    snprintf(base, sizeof base, "%.*s", (int)(end - name), name);
    fseek(in->file, 0, SEEK_END);
    const long size = ftell(in->file);
    input_seek(in, 0);
    const size_t n = fread(head, 1, sizeof head - 1, in->file);
    const char *const from = head + strspn(head, " \t\r\n");
    uint32_t facets;
    input_seek(in, 0);
    if (n == 0) return input_error(in, "the file is empty");
    if (size > MODEL_SIZE_MOST) return input_error(in, "%ld MB: allowed are %d", size >> 20, MODEL_SIZE_MOST >> 20);
    if (!memcmp(head, "glTF", 4)) return gltf_read(in, o, build);
    if (!strncmp(head, "AutoCAD Binary DXF", 18) ||
        ((*from == '0' || !strncmp(from, "999", 3)) && strpbrk(from, "\r\n") == from + strspn(from, "09")))
        return drawing_read(in, o, build);
    if (!strncmp(head, "AC10", 4)) return input_error(in, "a DWG drawing, which cannot be read: save it as DXF");
    if (strstr(head, "ISO-10303-21") && dot && (!strcasecmp(dot, ".stp") || !strcasecmp(dot, ".step")))
        return input_error(in, "a STEP file, which cannot be read: save it as STL or GLB by a CAD program");
    if (is_convertible(in->path))
        return input_error(in,
                           "only GLB, STL and DXF files are read: convert it with `hawser convert %.60s -o "
                           "%.60s.glb`",
                           name, base);
    if (n == STL_HEAD && stl_size((const unsigned char *)head, &facets) == size)
        return stl_read(in, o, build, base, size);
    if ((dot && !strcasecmp(dot, ".stl")) || !strncmp(head, "solid", 5)) return stl_read(in, o, build, base, size);
    return input_error(in, "neither a GLB, an STL nor a DXF file");
}

hawser_status model_read(const char *path, const ModelOptions *options, Mesh *mesh, Survey *found, hawser_error *err)
{
    SurveyInput in;
    hawser_error why;
    MeshBuild build = {0};
    const SurveyOptions plain = {.unit = options->unit, .marks = 1, .model = options};
    *mesh = (Mesh){0};
    *found = (Survey){0};
    hawser_status status = input_open(&in, path, &plain, found, err ? err : &why);
    if (!status) status = kind_read(&in, options, &build);
    const int lost = status == HAWSER_ERR_MEMORY ? 0 : input_lost(&in);
    in.line = 0;
    if (lost) status = input_error(&in, "cannot be read: %s", strerror(lost));
    if (!status && build.mesh.n_triangles == 0 && found->n_marks == 0) {
        const char *const some = found->n_ignored ? found->ignored[0].what : "";
        status = input_error(&in, "no triangles are taken from it%s%.100s", *some ? "; left out: " : "", some);
    }
    input_close(&in);
    mesh_build_end(&build);
    if (status) {
        mesh_free(&build.mesh);
        survey_clear(found);
    }
    *mesh = build.mesh;
    return status;
}
