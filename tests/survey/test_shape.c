/* Shapefiles, written here by libshp: lines with names and layers, systems of coordinates, and files that are not
 * whole. */
#ifdef HAWSER_SHAPEFILE
#include <math.h>
#include <shapefil.h>

#include "tests/survey/survey_fixture.h"

#define GLOBE(axis)                                                                                                    \
    "GEOGCS[\"GCS\",DATUM[\"D\",SPHEROID[\"S\"," axis ",298.25]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\","           \
    "0.0174532925199433]]"
#define PLANE(method, unit) "PROJCS[\"grid (east)\"," GLOBE("6378137.0") ",PROJECTION[\"" method "\"]," unit "]"
static const char metres[] = PLANE("Transverse_Mercator", "UNIT[\"Meter\",1.0]"),
                  feet[] = PLANE("Lambert_Conformal_Conic", "UNIT[\"Foot_US\",0.3048006096012192]"),
                  world[] = PLANE("Mercator_Auxiliary_Sphere", "UNIT[\"Meter\",1.0]"), globe[] = GLOBE("6378137.0"),
                  bessel[] = GLOBE("6377397.155"),
                  new_words[] =
                      "PROJCRS[\"grid\",BASEGEOGCRS[\"g\",DATUM[\"d\",ELLIPSOID[\"e\",6378137,298.25]]],"
                      "CONVERSION[\"c\",METHOD[\"Transverse Mercator\"]],CS[Cartesian,2],AXIS[\"(E)\",east,"
                      "ORDER[1],LENGTHUNIT[\"foot\",0.3048]],AXIS[\"(N)\",north,LENGTHUNIT[\"foot\",0.3048]]]",
                  heights[] = "COMPD_CS[\"both\",PROJCS[\"grid\"," GLOBE("6378137.0") ",UNIT[\"metre\",1]],"
                                                                                      "VERT_CS[\"up\",UNIT[\"foot\","
                                                                                      "0.3048]]]";

static const double place[5][3] = {
    {453000, 6712000, 10}, {453100, 6712000, 20}, {453100, 6712050, 30}, {453100, 6712050, 30}, {453130, 6712090, 40}};
static const int both[2] = {0, 3}, late[2] = {0, 9};

/* Writes x.* in a folder of its own, with one record of these vertices; returns the path of a file in it. */
static char folder[] = "/tmp/hawser-shape-XXXXXX";
static const char *file_at(const char *ending)
{
    static char path[64];
    snprintf(path, sizeof path, "%s/x%s", folder, ending);
    return path;
}
static void write_shape(int kind, int parts, const int *start, int n, const double (*at)[3], const char *prj)
{
    double x[5], y[5], z[5];
    for (int i = 0; i < n; ++i) x[i] = at[i][0], y[i] = at[i][1], z[i] = at[i][2];
    memcpy(folder + strlen(folder) - 6, "XXXXXX", 6);
    assert_non_null(mkdtemp(folder));
    SHPHandle const shp = SHPCreate(file_at(".shp"), kind);
    DBFHandle const dbf = DBFCreate(file_at(".dbf"));
    SHPObject *const o = SHPCreateObject(kind, -1, parts, start, NULL, n, x, y, z, NULL);
    SHPWriteObject(shp, -1, o);
    SHPDestroyObject(o);
    SHPClose(shp);
    DBFAddField(dbf, "Layer", FTString, 8, 0);
    DBFAddField(dbf, "NAME", FTString, 12, 0);
    DBFWriteStringAttribute(dbf, 0, 0, "HV");
    DBFWriteStringAttribute(dbf, 0, 1,
                            "K\xE4"
                            "bel"); /* Latin-1 */
    DBFClose(dbf);
    FILE *const text = prj ? fopen(file_at(".prj"), "w") : NULL;
    if (text) fputs(prj, text);
    if (text) fclose(text);
}

/* The message where it is refused, else empty; the files are gone then. */
static const char *shape_of(double unit, Survey *s)
{
    static const char *const endings[] = {".shp", ".shx", ".dbf", ".prj", ".cpg"};
    static hawser_error err;
    const SurveyOptions options = {.unit = unit};
    const hawser_status status = survey_read(file_at(".shp"), &options, s, &err);
    for (int i = 0; i < 5; ++i) unlink(file_at(endings[i]));
    rmdir(folder);
    return status ? err.message : "";
}

TEST(lines_with_names)
{
    Survey s;
    write_shape(SHPT_ARC, 2, both, 5, place, metres);
    assert_string_equal(shape_of(NAN, &s), "");
    assert_int_equal(s.n, 2);
    assert_string_equal(s.alignment[0].name, "K\xC3\xA4"
                                             "bel");
    assert_string_equal(s.alignment[1].layer, "HV");
    assert_true(s.alignment[0].whole == s.alignment[1].whole && s.alignment[0].whole > 0 && s.alignment[0].flat);
    check_close(alignment_measure(&s.alignment[0]).length, 150, 1e-9);
    check_close(alignment_measure(&s.alignment[1]).length, 50, 1e-9);
    assert_string_equal(s.system, "grid (east)");
    survey_clear(&s);
    write_shape(SHPT_MULTIPOINTZ, 0, NULL, 3, place, metres);
    assert_string_equal(shape_of(NAN, &s), "");
    assert_int_equal(s.n_marks, 3);
    check_vec(s.mark[2].at, v3(453100, 6712050, 30), 1e-9);
    survey_clear(&s);
}

/* Of one line of 150 m, or of feet: by the .prj, by the caller, by a .prj with other words or heights of their own. */
TEST(units_of_projections)
{
    const struct {
        const char *prj;
        double unit, plan, height;
    } tried[] = {{metres, NAN, 1, 1},       {feet, NAN, 0.3048006096012192, 0.3048006096012192},
                 {feet, 1e-3, 1e-3, 1e-3},  {new_words, NAN, 0.3048, 0.3048},
                 {heights, NAN, 1, 0.3048}, {NULL, NAN, 1, 1}};
    for (size_t i = 0; i < sizeof tried / sizeof *tried; ++i) {
        Survey s;
        write_shape(SHPT_ARCZ, 1, both, 3, place, tried[i].prj);
        assert_string_equal(shape_of(tried[i].unit, &s), "");
        const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
        check_close(m.plan_length, 150 * tried[i].plan, 1e-6);
        check_close(m.end.z, 30 * tried[i].height, 1e-9);
        if (!tried[i].prj) check_has(s.ignored[0].what, "no .prj beside it: coordinates are taken as metres");
        survey_clear(&s);
    }
}

/* Degrees go through the projection that other maps' go through; without a .prj nobody knows what they are. */
TEST(degrees)
{
    static const double at[2][3] = {{10, 60, 0}, {10, 60.001, 0}};
    Survey s;
    write_shape(SHPT_ARC, 1, both, 2, at, globe);
    assert_string_equal(shape_of(NAN, &s), "");
    const double length = alignment_measure(&s.alignment[0]).length;
    survey_clear(&s);
    assert_string_equal(read_text("{\"type\":\"LineString\",\"coordinates\":[[10,60],[10,60.001]]}", &s), "");
    check_close(length, alignment_measure(&s.alignment[0]).length, 1e-9);
    survey_clear(&s);
    write_shape(SHPT_ARC, 1, both, 2, at, bessel);
    assert_string_equal(shape_of(NAN, &s), "");
    check_has(s.ignored[0].what, "taken for WGS 84, lengths are 0.012 % off");
    survey_clear(&s);
    write_shape(SHPT_ARC, 1, both, 2, at, NULL);
    check_has(shape_of(NAN, &s), "no .prj beside it says whether they are degrees");
    write_shape(SHPT_ARC, 1, both, 2, at, NULL);
    assert_string_equal(shape_of(1, &s), "");
    check_close(alignment_measure(&s.alignment[0]).length, 0.001, 1e-9);
    survey_clear(&s);
}

static void patch(const char *ending, long at, const char *bytes, size_t n)
{
    FILE *const file = fopen(file_at(ending), "r+b");
    assert_non_null(file);
    fseek(file, at, SEEK_SET);
    fwrite(bytes, 1, n, file);
    fclose(file);
}

TEST(shapes_that_are_refused)
{
    Survey s;
    write_shape(SHPT_ARC, 1, both, 3, place, world);
    check_has(shape_of(NAN, &s), "metres of a map of the world are too long");
    write_shape(SHPT_ARC, 1, both, 3, place, "GEOCCS[\"x\"]");
    check_has(shape_of(NAN, &s), "expected PROJCS or GEOGCS");
    write_shape(SHPT_POLYGON, 1, both, 4, place, metres);
    check_has(shape_of(NAN, &s), "no line and no point");
    write_shape(SHPT_ARC, 2, late, 5, place, metres);
    check_has(shape_of(NAN, &s), "record 1");
    write_shape(SHPT_ARC, 1, both, 3, place, metres);
    truncate(file_at(".shp"), 150);
    check_has(shape_of(NAN, &s), ".shp is shorter than its head states");
    write_shape(SHPT_ARC, 1, both, 3, place, metres);
    truncate(file_at(".shx"), 104);
    check_has(shape_of(NAN, &s), ".shx is shorter than its head states");
    write_shape(SHPT_ARC, 1, both, 3, place, metres);
    patch(".shx", 100, "\x7F\xFF\xFF\xF0", 4);
    check_has(shape_of(NAN, &s), "record 1 cannot be read");
}

/* The index is made where it is missing; a table that is no table costs the names, and is said. */
TEST(without_what_is_beside)
{
    Survey s;
    write_shape(SHPT_ARC, 1, both, 3, place, metres);
    unlink(file_at(".shx"));
    unlink(file_at(".dbf"));
    assert_string_equal(shape_of(NAN, &s), "");
    check_close(alignment_measure(named(&s, "x")).length, 150, 1e-9);
    assert_int_equal(s.n_ignored, 0);
    survey_clear(&s);
    write_shape(SHPT_ARC, 1, both, 3, place, metres);
    patch(".dbf", 10, "\x04\x00", 2); /* records of four bytes, of columns of twenty */
    assert_string_equal(shape_of(NAN, &s), "");
    check_has(s.ignored[0].what, ".dbf beside it, which is damaged");
    survey_clear(&s);
}

#else

TEST(is_said)
{
    Survey s;
    hawser_error err;
    char path[] = "/tmp/hawser-shape-XXXXXX";
    const int fd = mkstemp(path);
    assert_int_equal(write(fd, "\0\0\x27\x0A", 4), 4);
    close(fd);
    assert_int_equal(survey_read(path, &usual, &s, &err), HAWSER_ERR_INPUT);
    unlink(path);
    check_has(err.message, "HAWSER_SHAPEFILE");
}

#endif
