/* Models of the environment: GLB, STL and DXF files with known areas and volumes, names that are taken and left, parts
 * that are equipment, and what is refused. */
#include "core/error.h"
#include "survey/model.h"
#include "tests/survey/survey_fixture.h"

/* A cube from 0 to 1: corner 4 x + 2 y + z. */
static const int cube[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};

typedef struct Read {
    Mesh mesh;
    Survey found;
    hawser_error err;
} Read;

static void clear(Read *r)
{
    mesh_free(&r->mesh);
    survey_clear(&r->found);
}

/* Reads bytes as a file of that ending. */
static Read read_bytes(const void *bytes, size_t size, const char *ending, const ModelOptions *options)
{
    Read r = {.err = {HAWSER_OK, ""}};
    char path[64];
    snprintf(path, sizeof path, "/tmp/hawser-model-XXXXXX%s", ending);
    const int fd = mkstemps(path, (int)strlen(ending));
    assert_true(fd >= 0);
    assert_int_equal(write(fd, bytes, size), (long)size);
    close(fd);
    const hawser_status status = model_read(path, options, &r.mesh, &r.found, &r.err);
    assert_int_equal(status, r.err.status);
    unlink(path);
    return r;
}

static Read read_as(const char *text, const char *ending, const ModelOptions *options)
{
    return read_bytes(text, strlen(text), ending, options);
}

static void refused(Read r, const char *why)
{
    assert_int_equal(r.err.status, HAWSER_ERR_INPUT);
    check_has(r.err.message, why);
}

static const ModelOptions plain = {.unit = NAN}, upward = {.unit = 0.001, .up = 'z'};

static void check_mesh(const Read *r, int triangles, int vertices, double area, double volume)
{
    if (r->err.status) fail_msg("%s", r->err.message);
    assert_int_equal(r->mesh.n_triangles, triangles);
    assert_int_equal(r->mesh.n_vertices, vertices);
    check_share(mesh_area(&r->mesh), area, 1e-6);
    check_close(mesh_volume(&r->mesh), volume, 1e-6 * (1 + fabs(volume)));
}

/* Height of the mesh along an axis, m. */
static double extent(const Mesh *m, int axis)
{
    double low = INFINITY, high = -INFINITY;
    for (int v = 0; v < m->n_vertices; ++v) {
        low = fmin(low, m->vertex[v][axis]);
        high = fmax(high, m->vertex[v][axis]);
    }
    return high - low;
}

/* ---------------------------------------------------------------------------------------------------- GLB */

enum { CORNERS = 96, INDICES = 72, BIN = CORNERS + INDICES };

static size_t put_word(unsigned char *to, size_t at, unsigned long word)
{
    for (int i = 0; i < 4; ++i) to[at + (size_t)i] = (unsigned char)(word >> 8 * i);
    return at + 4;
}

/* A file with the cube's corners as floats and its indices of 16 bits in the binary chunk. Returns its size. */
static size_t glb_make(const char *json, unsigned char *to)
{
    const size_t n = strlen(json), padded = (n + 3) / 4 * 4;
    size_t at = put_word(to, 0, 0x46546C67);
    at = put_word(to, at, 2);
    at = put_word(to, at, 28 + padded + BIN);
    at = put_word(to, at, padded);
    at = put_word(to, at, 0x4E4F534A);
    memset(to + at, ' ', padded);
    memcpy(to + at, json, n);
    at = put_word(to, at + padded, BIN);
    at = put_word(to, at, 0x004E4942);
    for (int c = 0; c < 8; ++c) {
        const float p[3] = {(float)(c >> 2), (float)(c >> 1 & 1), (float)(c & 1)};
        memcpy(to + at, p, sizeof p);
        at += sizeof p;
    }
    for (int i = 0; i < 36; ++i) {
        to[at++] = (unsigned char)cube[i / 3][i % 3];
        to[at++] = 0;
    }
    return at;
}

static Read read_glb(const char *json, const ModelOptions *options)
{
    unsigned char bytes[4096];
    assert_true(strlen(json) + 300 < sizeof bytes);
    const size_t n = glb_make(json, bytes);
    return read_bytes(bytes, n, ".glb", options);
}

/* The JSON around its nodes; more: further keys at the top. */
#define VIEWS                                                                                                          \
    "\"buffers\":[{\"byteLength\":168}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":96},"                            \
    "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":72}],"
#define ACCESSORS(more, count)                                                                                         \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"" more "},"                  \
    "{\"bufferView\":1,\"componentType\":5123,\"count\":" count ",\"type\":\"SCALAR\"}],"
#define MESHES(more)                                                                                                   \
    "\"meshes\":[{\"name\":\"box\",\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1" more "}]}],"
#define WHOLE(accessors, meshes, nodes)                                                                                \
    "{\"asset\":{\"version\":\"2.0\"}," VIEWS accessors meshes "\"nodes\":[" nodes "],\"scenes\":[{\"nodes\":[0]}]}"
#define NODES(nodes) WHOLE(ACCESSORS("", "36"), MESHES(""), nodes)

TEST(nodes_move_turn_scale_and_mirror)
{
    /* a group turned by 90 degrees about y with a child that is scaled, and one that is mirrored as well */
    Read r = read_glb(NODES("{\"children\":[1,2],\"translation\":[10,0,0],"
                            "\"rotation\":[0,0.7071067811865476,0,0.7071067811865476]},"
                            "{\"name\":\"a\",\"mesh\":0,\"scale\":[2,3,4]},"
                            "{\"name\":\"b\",\"mesh\":0,\"matrix\":[2,0,0,0, 0,3,0,0, 0,0,-4,0, 0,0,9,1]}"),
                      &plain);
    check_mesh(&r, 24, 16, 2 * 52, 2 * 24); /* a mirrored one that keeps its corners' order gives 24 - 24 */
    assert_int_equal(r.mesh.n_layers, 2);
    assert_string_equal(r.mesh.layer_name[1], "b");
    check_close(extent(&r.mesh, 2), 3, 1e-9); /* the file's y points upward */
    check_close(extent(&r.mesh, 1), 2, 1e-9); /* its x went to -z, which is y */
    clear(&r);
    const ModelOptions inches = {.unit = 0.0254, .up = 'z'};
    r = read_glb(NODES("{\"mesh\":0,\"scale\":[1,1,5]}"), &inches);
    check_close(extent(&r.mesh, 2), 5 * 0.0254, 1e-9);
    assert_string_equal(r.mesh.layer_name[0], "box"); /* a node without a name has its mesh's */
    clear(&r);
}

TEST(strips_fans_and_points)
{
    /* corners 0 1 3 0 3 2 of the cube's first side: as a strip 0 1 3, 3 1 0, 3 0 3, 2 3 0, of which one has no area */
    Read r = read_glb(WHOLE(ACCESSORS("", "6"), MESHES(",\"mode\":5"), "{\"mesh\":0}"), &plain);
    check_mesh(&r, 3, 4, 1.5, 0);
    assert_memory_equal(r.mesh.triangle[1], ((int[3]){2, 1, 0}),
                        sizeof *r.mesh.triangle); /* every other one is turned */
    clear(&r);
    r = read_glb(WHOLE(ACCESSORS("", "4"), MESHES(",\"mode\":6"), "{\"mesh\":0}"), &plain);
    check_mesh(&r, 1, 3, 0.5, 0);
    clear(&r);
    r = read_glb(WHOLE(ACCESSORS("", "6"), MESHES(",\"mode\":0"), "{\"mesh\":0}"), &plain);
    assert_int_equal(r.mesh.n_triangles, 6); /* 0 1 3 0 3 2 as a cloud */
    assert_int_equal(r.mesh.n_vertices, 4);
    for (int t = 0; t < 6; ++t) assert_int_equal(r.mesh.triangle[t][0], r.mesh.triangle[t][2]);
    clear(&r);
    refused(read_glb(WHOLE(ACCESSORS("", "6"), MESHES(",\"mode\":1"), "{\"mesh\":0}"), &plain), "lines of a mesh");
}

TEST(names_are_taken_left_or_equipment)
{
    static const char json[] = NODES("{\"name\":\"all\",\"children\":[1,2,3]},{\"name\":\"wall 1\",\"mesh\":0},"
                                     "{\"name\":\"services\",\"children\":[4]},"
                                     "{\"name\":\"roller 7\",\"mesh\":0,\"translation\":[5,1,-2],\"scale\":[1,2,4]},"
                                     "{\"name\":\"pipe\",\"mesh\":0}");
    const char *const take[] = {"serv*"}, *const leave[] = {"wall*"}, *const part[] = {"none", "roller*"};
    ModelOptions o = {.unit = NAN, .take = {1, (const char **)(size_t)take}};
    Read r = read_glb(json, &o);
    check_mesh(&r, 12, 8, 6, 1);
    assert_string_equal(r.mesh.layer_name[0], "pipe"); /* below the node that is taken */
    clear(&r);
    o = (ModelOptions){
        .unit = NAN, .leave = {1, (const char **)(size_t)leave}, .equipment = {2, (const char **)(size_t)part}};
    r = read_glb(json, &o);
    check_mesh(&r, 12, 8, 6, 1);
    assert_int_equal(r.found.n_marks, 1);
    const SurveyMark *const mark = &r.found.mark[0];
    assert_string_equal(mark->name, "part: roller 7");
    assert_string_equal(mark->layer, "roller*");
    check_vec(mark->at, v3(5.5, 0, 2), 1e-9); /* the box from (5, 1, -2) to (6, 3, 2), z upward */
    check_close(mark->heading, 0, 1e-12);
    clear(&r);
}

TEST(what_a_glb_file_must_not_have)
{
    refused(read_glb(WHOLE(ACCESSORS(",\"sparse\":{}", "36"), MESHES(""), "{\"mesh\":0}"), &plain), "is sparse");
    refused(read_glb(WHOLE(ACCESSORS("", "36"), MESHES(",\"extensions\":{\"KHR_draco_mesh_compression\":{}}"),
                           "{\"mesh\":0}"),
                     &plain),
            "compressed by KHR_draco_mesh_compression");
    refused(read_glb("{\"extensionsRequired\":[\"KHR_materials_unlit\",\"EXT_meshopt_compression\"]}", &plain),
            "it requires EXT_meshopt_compression");
    refused(read_glb(WHOLE(ACCESSORS("", "37"), MESHES(""), "{\"mesh\":0}"), &plain), "lies outside");
    refused(read_glb(WHOLE(ACCESSORS("", "36"), MESHES(""), "{\"mesh\":1}"), &plain), "a mesh that is missing");
    refused(read_glb(WHOLE(ACCESSORS("", "36"), MESHES(""), "{\"children\":[0]}"), &plain), "within each other");
    refused(read_glb(WHOLE(ACCESSORS("", "36"), MESHES(""), "{\"mesh\":0,\"scale\":[1e300,1,1]}"), &plain),
            "without a place");
    refused(read_glb(WHOLE(ACCESSORS("", "36"), MESHES(""), "{\"mesh\":0,\"skin\":0}"), &plain), "changed by bones");
    refused(read_glb("{", &plain), "its JSON");
    unsigned char bytes[4096];
    const size_t n = glb_make(NODES("{\"mesh\":0}"), bytes);
    for (size_t k = 1; k < n; ++k) { /* cut at every byte */
        Read r = read_bytes(bytes, k, ".glb", &plain);
        assert_int_equal(r.err.status, HAWSER_ERR_INPUT);
    }
}

/* ---------------------------------------------------------------------------------------------------- STL */

#define FACET(a, b, c)                                                                                                 \
    "facet normal 0 0 0\n outer loop\n  vertex " a "\n  vertex " b "\n  vertex " c "\n endloop\nendfacet\n"

TEST(stl_of_both_kinds)
{
    unsigned char bytes[84 + 12 * 50] = {0};
    put_word(bytes, 80, 12);
    for (int t = 0; t < 12; ++t) {
        for (int c = 0; c < 3; ++c) {
            const int k = cube[t][c];
            const float p[3] = {(float)(k >> 2), (float)(k >> 1 & 1), (float)(k & 1)};
            memcpy(bytes + 84 + 50 * t + 12 + 12 * c, p, sizeof p);
        }
    }
    memcpy(bytes, "solid", 5); /* as some programs write it: the size says that it is binary */
    Read r = read_bytes(bytes, sizeof bytes, ".stl", &upward);
    check_mesh(&r, 12, 8, 6e-6, 1e-9);
    clear(&r);
    refused(read_bytes(bytes, sizeof bytes, ".stl", &plain), "does not say its unit");
    refused(read_bytes(bytes, sizeof bytes, ".stl", &(ModelOptions){.unit = 1}), "which axis points upward");
    bytes[0] = 0;
    refused(read_bytes(bytes, sizeof bytes - 1, ".stl", &upward), "of 12 triangles has 684 bytes, this one has 683");
    r = read_as("solid east\n" FACET("0 0 0", "2 0 0", "0 3e0 0") "endsolid\nsolid west\n" FACET(
                    "0 0 0", "0 3 0", "0 0 -4.0") FACET("1 1 1", "1 1 1", "2 2 2") "endsolid west\n",
                ".stl", &upward);
    check_mesh(&r, 2, 6, 9e-6, 0); /* the facet without an area is left out, its vertices are there */
    assert_string_equal(r.mesh.layer_name[1], "west");
    clear(&r);
    refused(read_as("solid a\n" FACET("0 0 0", "2 0", "0 3 0"), ".stl", &upward), "without three numbers");
    refused(read_as("solid a\nfacet\nvertex 0 0 0\nendfacet\n", ".stl", &upward), "a facet of 1 corners");
    refused(read_as("ply\n", ".ply", &plain), "convert it with `hawser convert hawser-model");
    refused(read_as("ISO-10303-21;", ".stp", &plain), "a STEP file");
    refused(read_as("", ".glb", &plain), "is empty");
}

/* ---------------------------------------------------------------------------------------------------- DXF */

#define HEADER(unit)          "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n" unit "\n  0\nENDSEC\n"
#define ENTITIES(text)        "  0\nSECTION\n  2\nENTITIES\n" text "  0\nENDSEC\n  0\nEOF\n"
#define BLOCKS(text)          "  0\nSECTION\n  2\nBLOCKS\n" text "  0\nENDSEC\n"
#define BLOCK(name, text)     "0\nBLOCK\n8\n0\n2\n" name "\n70\n0\n10\n0\n20\n0\n30\n0\n" text "0\nENDBLK\n8\n0\n"
#define VERTEX(x, y, z, more) "0\nVERTEX\n8\nA\n10\n" #x "\n20\n" #y "\n30\n" #z "\n" more
/* A tetrahedron of 6 units3/6 with right angles at the origin, outward. */
#define TETRAHEDRON                                                                                                    \
    "0\nMESH\n8\n0\n71\n2\n72\n0\n91\n0\n92\n4\n10\n0\n20\n0\n30\n0\n10\n1\n20\n0\n30\n0\n10\n0\n20\n2\n30\n0\n10\n0"  \
    "\n"                                                                                                               \
    "20\n0\n30\n3\n93\n16\n90\n3\n90\n0\n90\n2\n90\n1\n90\n3\n90\n0\n90\n1\n90\n3\n90\n3\n90\n0\n90\n3\n90\n2\n90\n3"  \
    "\n90\n1\n"                                                                                                        \
    "90\n2\n90\n3\n94\n0\n95\n0\n"
#define INSERT(name, layer, more) "0\nINSERT\n8\n" layer "\n2\n" name "\n" more
static const double slant = 3.5; /* area of the slanted face: |(-1, 2, 0) x (-1, 0, 3)|/2 */

TEST(dxf_faces_of_every_kind)
{
    Read r =
        read_as(HEADER("4") ENTITIES("0\n3DFACE\n8\nA\n10\n0\n20\n0\n30\n0\n11\n2\n21\n0\n31\n0\n12\n2\n22\n3\n32\n0\n"
                                     "13\n0\n23\n3\n33\n0\n"
                                     "0\n3DFACE\n8\nB\n10\n0\n20\n0\n30\n0\n11\n2\n21\n0\n31\n0\n12\n0\n22\n0\n32\n4\n"
                                     "13\n0\n23\n0\n33\n4\n"),
                ".dxf", &plain);
    check_mesh(&r, 3, 5, 10e-6, 0);
    assert_string_equal(r.mesh.layer_name[1], "B");
    clear(&r);
    /* faces by numbers, negative before an edge that is not drawn; a net of 2 rows and 3 columns, closed along them */
    r = read_as(
        HEADER("6") ENTITIES(
            "0\nPOLYLINE\n8\nA\n70\n64\n71\n4\n72\n2\n" VERTEX(0, 0, 0, "70\n192\n") VERTEX(2, 0, 0, "70\n192\n")
                VERTEX(2, 2, 0, "70\n192\n") VERTEX(0, 2, 0, "70\n192\n") VERTEX(
                    0, 0, 0,
                    "70\n128\n71\n1\n72\n2\n73\n3\n74\n-4\n") "0\nSEQEND\n"
                                                              "0\nPOLYLINE\n8\nB\n70\n48\n71\n2\n72\n3\n" VERTEX(
                                                                  0, 0, 0, "70\n64\n") VERTEX(3, 0, 0, "70\n64\n")
                                                                  VERTEX(0, 4, 0, "70\n64\n") VERTEX(
                                                                      0, 0, 5, "70\n64\n") VERTEX(3, 0, 5, "70\n64\n")
                                                                      VERTEX(0, 4, 5, "70\n64\n") "0\nSEQEND\n"),
        ".dxf", &plain);
    check_mesh(&r, 2 + 6, 9, 4 + 5 * (3 + 4 + 5), mesh_volume(&r.mesh));
    clear(&r);
    r = read_as(HEADER("6") ENTITIES(TETRAHEDRON), ".dxf", &plain);
    check_mesh(&r, 4, 4, 1 + 1.5 + 3 + slant, 1);
    clear(&r);
}

TEST(dxf_blocks_are_nested_turned_and_mirrored)
{
    static const char text[] = HEADER("6")
        BLOCKS(BLOCK("inner", TETRAHEDRON) BLOCK("outer", INSERT("inner", "0", "10\n0\n20\n0\n41\n2\n42\n2\n43\n2\n")))
            ENTITIES(INSERT("outer", "EAST", "10\n7\n20\n0\n30\n1\n50\n90\n70\n3\n44\n10\n")
                         INSERT("outer", "WEST", "10\n0\n20\n0\n41\n-1\n"));
    Read r = read_as(text, ".dxf", &plain);
    check_mesh(&r, 4 * 4, 16, 4 * 4 * (5.5 + slant), 4 * 8); /* a mirrored one must not count -8 */
    assert_string_equal(r.mesh.layer_name[0], "EAST");       /* layer 0 in a block is that of the insertion */
    double highest = 0, farthest = 0;
    for (int v = 0; v < r.mesh.n_vertices; ++v) {
        highest = fmax(highest, r.mesh.vertex[v][2]);
        farthest = fmax(farthest, r.mesh.vertex[v][1]);
    }
    check_close(highest, 7, 1e-12);   /* 1 + 2 3 */
    check_close(farthest, 22, 1e-12); /* columns along the turned x-axis: 2 10 + 2 1 */
    clear(&r);
    const char *const west[] = {"W*"}, *const out[] = {"out*"}, *const inner[] = {"inner"};
    ModelOptions o = {.unit = NAN, .take = {1, (const char **)(size_t)west}};
    r = read_as(text, ".dxf", &o);
    check_mesh(&r, 4, 4, 4 * (5.5 + slant), 8);
    clear(&r);
    o = (ModelOptions){.unit = NAN, .leave = {1, (const char **)(size_t)inner}};
    refused(read_as(text, ".dxf", &o), "no triangles");
    o = (ModelOptions){.unit = NAN, .equipment = {1, (const char **)(size_t)out}};
    r = read_as(text, ".dxf", &o);
    assert_int_equal(r.mesh.n_triangles, 0);
    assert_int_equal(r.found.n_marks, 2);
    check_vec(r.found.mark[0].at, v3(7, 0, 1), 1e-12);
    check_close(r.found.mark[0].heading, acos(0), 1e-12);
    clear(&r);
}

TEST(dxf_that_cannot_be_used)
{
    static const char face[] = "0\n3DFACE\n8\nA\n10\n0\n20\n0\n11\n2\n21\n0\n12\n2\n22\n3\n";
    char text[400];
    snprintf(text, sizeof text, ENTITIES("%s"), face);
    refused(read_as(text, ".dxf", &plain), "does not say its unit of length ($INSUNITS)");
    Read r = read_as(text, ".dxf", &upward);
    check_mesh(&r, 1, 3, 3e-6, 0);
    clear(&r);
    refused(read_as(HEADER("6") ENTITIES("0\n3DSOLID\n8\nA\n"), ".dxf", &plain),
            "no triangles are taken from it; left out: 3DSOLID");
    refused(read_as(HEADER("6") ENTITIES("0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1\n21\n1\n"), ".dxf", &plain),
            "no triangles");
}
