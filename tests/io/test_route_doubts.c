/* What a file leaves open is refused or said: no line is made up where the file has none. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "hawser/route.h"
#include "tests/support/check.h"

/* Why the first line of a file of this text cannot be a route: "" if it can; else as the file's refusal. */
static const char *trouble(const char *text, const hawser_route_options *options, hawser_route_figures *figures)
{
    static char why[1024];
    char path[] = "/tmp/hawser-doubt-XXXXXX";
    hawser_error err = {.message = ""};
    hawser_routes *r = NULL;
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), (long)strlen(text));
    close(fd);
    hawser_status status = hawser_routes_read(path, options, &r, &err);
    unlink(path);
    if (!status) status = hawser_routes_figures(r, 0, figures, &err);
    snprintf(why, sizeof why, "%s", status ? err.message : figures->problem ? figures->problem : "");
    figures->problem = figures->name = figures->layer = NULL;
    hawser_routes_free(r);
    return why;
}

/* What `check` says of a case whose route is a file of this name and text, as JSON; else why not. */
static const char *said(const char *name, const char *text, const char *keys)
{
    static char all[1 << 16];
    char folder[] = "/tmp/hawser-doubt-XXXXXX", path[80], case_path[80], *check = NULL;
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/%s", folder, name);
    snprintf(case_path, sizeof case_path, "%s/case.yaml", folder);
    FILE *f = fopen(path, "w");
    fputs(text, f);
    fclose(f);
    f = fopen(case_path, "w");
    fprintf(f,
            "cables: {c: {d: 90 mm, mass: 20 kg/m}}\nroute: {file: %s%s}\nrollers: {along: [{spacing: 2 m}]}\n"
            "friction: {mu: 0.2}\nlimits: {pull: 30 kN}\n",
            name, keys);
    fclose(f);
    hawser_case *c = NULL;
    hawser_error err;
    hawser_status status = hawser_case_load(case_path, &c, &err);
    if (!status) status = hawser_case_describe(c, HAWSER_JSON, &check, &err);
    snprintf(all, sizeof all, "%s", status ? err.message : check);
    hawser_text_free(check);
    hawser_case_free(c);
    unlink(path);
    unlink(case_path);
    rmdir(folder);
    return all;
}

#define LANDXML(geometry, profile)                                                                                     \
    "<LandXML><Units><Metric linearUnit=\"meter\"/></Units><Alignments><Alignment name=\"a\"><CoordGeom>" geometry     \
    "</CoordGeom>" profile "</Alignment></Alignments></LandXML>"
#define LINE(from, to) "<Line><Start>" from "</Start><End>" to "</End></Line>"

/* Elements that do not meet: what is missing between them is not built. Within the tolerance it is bridged. */
TEST(gaps_between_elements)
{
    hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    check_has(trouble(LANDXML(LINE("0 0", "0 50") LINE("0 60", "0 100"), ""), &options, &f),
              "gap of 10 m at 50.000, 0.000, where element 1 ends: the next one begins at 60.000, 0.000, and at most "
              "0.05 m");
    check_has(trouble("x,y,direction,length,radius\n0,0,0,50,\n52,0,0,30,\n", &options, &f),
              "gap of 2 m at 50.000, 0.000");
    assert_string_equal(trouble(LANDXML(LINE("0 0", "0 50") LINE("0 50.04", "0 100"), ""), &options, &f), "");
    options.to_m = 40; /* a part beside it has no gap */
    assert_string_equal(trouble(LANDXML(LINE("0 0", "0 50") LINE("0 60", "0 100"), ""), &options, &f), "");
    options.to_m = 70;
    check_has(trouble(LANDXML(LINE("0 0", "0 50") LINE("0 60", "0 100"), ""), &options, &f), "gap of 10 m");
    options.to_m = NAN;
    options.radius_m = 1; /* nor is it where corners are rounded */
    check_has(trouble(LANDXML(LINE("0 0", "0 50") LINE("9 60", "0 100"), ""), &options, &f), "gap of 13.45 m");
}

/* A profile whose elements are not at one height where they meet, in a table and in a model. */
TEST(jumps_of_the_profile)
{
    static const char *const head = "x,y,direction,length,z,start gradient\n";
    hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    char text[4000];
    snprintf(text, sizeof text, "%s0,0,0,50,10,0.02\n50,0,0,50,11.08,0.02\n", head);
    check_has(trouble(text, &options, &f), "the profile jumps by 0.08 m at station 50 m, from 11.0000 m to 11.0800 m");
    options.to_m = 40;
    assert_string_equal(trouble(text, &options, &f), "");
    options.to_m = NAN;
    options.tolerance_m = 0.09;
    assert_string_equal(trouble(text, &options, &f), "");
    snprintf(text, sizeof text, "%s",
             "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4X3'));\nENDSEC;\nDATA;\n"
             "#8=IFCALIGNMENT('1',$,'al',$,$,$,$,$);\n"
             "#9=IFCALIGNMENTHORIZONTAL('2',$,$,$,$,$,$);\n"
             "#10=IFCALIGNMENTVERTICAL('3',$,$,$,$,$,$);\n"
             "#12=IFCRELNESTS('4',$,$,$,#8,(#9,#10));\n"
             "#100=IFCCARTESIANPOINT((0.,0.));\n"
             "#101=IFCALIGNMENTHORIZONTALSEGMENT($,$,#100,0.,0.,0.,100.,$,.LINE.);\n"
             "#20=IFCRELNESTS('5',$,$,$,#9,(#101));\n"
             "#103=IFCALIGNMENTVERTICALSEGMENT($,$,0.,50.,10.,0.02,0.02,$,.CONSTANTGRADIENT.);\n"
             "#105=IFCALIGNMENTVERTICALSEGMENT($,$,50.,50.,14.,-.02,-.02,$,.CONSTANTGRADIENT.);\n"
             "#21=IFCRELNESTS('6',$,$,$,#10,(#103,#105));\nENDSEC;\nEND-ISO-10303-21;\n");
    check_has(trouble(text, &options, &f), "the profile jumps by 3 m at station 50 m, from 11.0000 m to 14.0000 m");
}

#define DXF(entities)                                                                                                  \
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" entities "0\nENDSEC\n0\nEOF\n"
#define DXF_LINE(x1, y1, z1, x2, y2, z2)                                                                               \
    "0\nLINE\n8\nL\n10\n" #x1 "\n20\n" #y1 "\n30\n" #z1 "\n11\n" #x2 "\n21\n" #y2 "\n31\n" #z2 "\n"
#define DXF_ARC(x, y, z, radius, from, to, more)                                                                       \
    "0\nARC\n8\nL\n10\n" #x "\n20\n" #y "\n30\n" #z "\n40\n" #radius "\n50\n" #from "\n51\n" #to "\n" more

/* A drawing's straights stay straight with a corner between them, at whatever height an arc among them lies. */
TEST(straights_beside_arcs)
{
    static const char *const drawing[] = {
        DXF(DXF_LINE(0, 0, 0, 100, 0, 0) DXF_LINE(100, 0, 0, 190, 40, 0) DXF_LINE(190, 40, 0, 190, 140, 0)
                DXF_ARC(150, 140, 0, 40, 0, 90, "")),
        DXF(DXF_LINE(0, 0, 5, 100, 0, 5) DXF_LINE(100, 0, 5, 190, 40, 5) DXF_LINE(190, 40, 5, 190, 140, 5)
                DXF_ARC(150, 140, 5, 40, 0, 90, "")),
        DXF(DXF_LINE(0, 0, 0, 100, 0, 5) DXF_LINE(100, 0, 5, 190, 40, 5) DXF_LINE(190, 40, 5, 190, 140, 5)
                DXF_ARC(150, 140, 5, 40, 0, 90, ""))};
    const hawser_route_options options = hawser_route_defaults();
    double radius = 0;
    for (int i = 0; i < 3; ++i) {
        hawser_route_figures f;
        assert_string_equal(trouble(drawing[i], &options, &f), "");
        if (i == 0) radius = f.least_radius_m;
        check_share(f.least_radius_m, radius, i < 2 ? 1e-6 : 0.02);
        check_close(f.horizontal_length_m, 200 + hypot(90, 40) + 20 * acos(-1), i < 2 ? 1e-9 : 1e-3);
    }
}

/* A radius is for corners: what is an arc or a spline in the file has its own. */
TEST(radius_beside_curves)
{
    static const char *const drawing[] = {
        DXF(DXF_LINE(0, 0, 5, 50, 0, 5) DXF_ARC(50, 20, 5, 20, 270, 360, "")),
        DXF(DXF_LINE(0, 0, 4, 50, 0, 5) DXF_ARC(50, 20, 5, 20, 270, 360, "")),
        DXF(DXF_ARC(50, 20, 5, 20, 270, 360, "210\n0\n220\n0.6\n230\n0.8\n")),
        DXF("0\nSPLINE\n8\nL\n70\n8\n71\n3\n72\n8\n73\n4\n74\n0\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n"
            "1\n40\n1\n10\n0\n20\n0\n30\n0\n10\n20\n20\n0\n30\n0\n10\n40\n20\n20\n30\n0\n10\n40\n20\n40\n30\n"
            "0\n")};
    hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    options.radius_m = 5;
    for (size_t i = 0; i < sizeof drawing / sizeof *drawing; ++i)
        check_has(trouble(drawing[i], &options, &f), "has bends of its own: a 'radius' rounds the corners");
    assert_string_equal(trouble(DXF(DXF_LINE(0, 0, 5, 50, 0, 5) DXF_LINE(50, 0, 5, 50, 50, 5)), &options, &f), "");
}

/* Parts of one feature that touch are one line; what of a file is not the route is said, however short. */
TEST(lines_beside_the_route)
{
    static const char *const map = "{\"type\":\"Feature\",\"coordinates_in\":\"m\",\"properties\":{\"name\":\"r\"},"
                                   "\"geometry\":{\"type\":\"MultiLineString\",\"coordinates\":[[[0,0],[100,0]],"
                                   "[[109,0],[100,0]],[[109,%d],[112,0]]]}}";
    const hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    char text[400];
    snprintf(text, sizeof text, map, 0);
    assert_string_equal(trouble(text, &options, &f), "");
    check_close(f.length_m, 112, 1e-9);
    assert_null(strstr(said("map.geojson", text, ""), "other line"));
    snprintf(text, sizeof text, map, 9);
    assert_string_equal(trouble(text, &options, &f), "");
    check_close(f.length_m, 109, 1e-9);
    check_has(said("map.geojson", text, ""), "1 other line, 9.487 m, is not in the route");
    check_has(said("gap.dxf",
                   DXF(DXF_LINE(0, 0, 0, 500, 0, 0) DXF_LINE(502, 0, 0, 540, 0, 0) DXF_LINE(545, 0, 0, 550, 0, 0)), ""),
              "2 other lines, together 43 m, are not in the route");
}

/* A shaft between two lines is part of the route, with a radius for its corners: 120 m less what two quarter arcs of 2
 * m cut off, 2 (4 - pi) m. It was left out, and the route level. Without a radius there is no such profile. */
TEST(a_shaft_in_a_drawing)
{
    static const char shaft[] =
        DXF(DXF_LINE(0, 0, 0, 50, 0, 0) DXF_LINE(50, 0, 0, 50, 0, 20) DXF_LINE(50, 0, 20, 100, 0, 20));
    check_has(said("shaft.dxf", shaft, ", radius: 2 m"), "\"route_length_m\": 118.2831853");
    assert_null(strstr(said("shaft.dxf", shaft, ", radius: 2 m"), "straight up"));
    check_has(said("shaft.dxf", shaft, ""), "is 20 m above or below a point that lies no farther along the line");
    static const char beside[] =
        DXF(DXF_LINE(0, 0, 5, 50, 0, 5) DXF_LINE(50, 0, 5, 50, 0, 25) DXF_LINE(50, 0, 5, 100, 0, 5));
    check_has(said("manhole.dxf", beside, ""), "pieces straight up or down, layer");
}

/* Heights of a part of the route were left out with those that are there, and the route was level at 0 m. */
TEST(heights_of_a_part)
{
    static const struct {
        const char *name, *text;
    } file[] = {
        {"map.geojson", "{\"type\":\"Feature\",\"coordinates_in\":\"m\",\"properties\":{},\"geometry\":{\"type\":"
                        "\"LineString\",\"coordinates\":[[0,0,5],[100,0,9],[200,0]]}}"},
        {"track.gpx", "<gpx version=\"1.1\"><trk><trkseg><trkpt lat=\"50\" lon=\"7\"><ele>5</ele></trkpt><trkpt "
                      "lat=\"50\" lon=\"7.001\"/><trkpt lat=\"50\" lon=\"7.002\"><ele>9</ele></trkpt></trkseg>"
                      "</trk></gpx>"},
        {"plan.dxf", DXF(DXF_LINE(0, 0, 30, 50, 0, 31) DXF_LINE(50, 0, 0, 100, 0, 0))}};
    for (size_t k = 0; k < sizeof file / sizeof *file; ++k) {
        check_has(said(file[k].name, file[k].text, ""), "give it one 'height', or a 'profile'");
        check_has(said(file[k].name, file[k].text, ", height: 12 m"), "route_length_m");
    }
    static const char profile[] = "<Profile><ProfAlign name=\"p\"><PVI>0 5</PVI><PVI>50 9</PVI></ProfAlign></Profile>";
    char whole[800];
    snprintf(whole, sizeof whole, LANDXML(LINE("0 0 5", "0 50 9"), "%s"), profile);
    check_has(said("route.xml", whole, ""), "route_length_m");
}

/* A drawing without units is in metres, and a case says that it was taken so, unless it gives them. */
TEST(units_that_are_not_said)
{
    static const char *const drawing[] = {
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n0\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" DXF_LINE(
            0, 0, 0, 50, 0, 0) "0\nENDSEC\n0\nEOF\n",
        "0\nSECTION\n2\nENTITIES\n" DXF_LINE(0, 0, 0, 50, 0, 0) "0\nENDSEC\n0\nEOF\n"};
    for (int i = 0; i < 2; ++i) {
        check_has(said("plan.dxf", drawing[i], ""), "unit of length: not given in the file, metres are assumed");
        assert_null(strstr(said("plan.dxf", drawing[i], ", units: m"), "unit of length"));
    }
    assert_null(strstr(said("plan.dxf", DXF(DXF_LINE(0, 0, 0, 50, 0, 0)), ""), "unit of length"));
}

#define MM_DRAWING(entities)                                                                                           \
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" entities "0\nENDSEC\n0\nEOF\n"

/* A drawing that says mm with the figures of metres: its route was 0.132 m long. Which way a line runs stands in the
 * case's assumptions. */
TEST(units_by_size)
{
    static const char *const doubtful[] = {MM_DRAWING(DXF_LINE(0, 0, 0, 132, 0, 0)),
                                           MM_DRAWING(DXF_LINE(453120, 6712310, 0, 455320, 6712310, 0)),
                                           DXF(DXF_LINE(0, 0, 0, 132000, 0, 0))};
    for (int i = 0; i < 3; ++i) {
        check_has(said("plan.dxf", doubtful[i], ""), "is that the unit? Give 'units'");
        check_has(said("plan.dxf", doubtful[i], i == 2 ? ", units: mm" : ", units: m"), "route_length_m");
    }
    const char *const sound = said("plan.dxf", MM_DRAWING(DXF_LINE(132000, 0, 0, 0, 0, 0)), "");
    check_has(sound, "route_length_m\": 132");
    check_has(sound, "from (132.000, 0.000) to (0.000, 0.000), right to left, as it is drawn; 'reverse' turns it");
    check_has(said("plan.dxf", MM_DRAWING(DXF_LINE(0, 0, 0, 4, 0, 0)), ""), "smaller 'join' (--join)");
    check_has(said("plan.dxf", DXF(DXF_LINE(0, 0, 0, 60, 0, 0) DXF_LINE(100, 0, 0, 60, 0, 0)), ", reverse: true"),
              "right to left, against the way 60 % of its length is drawn");
}

/* Corners without a radius: how wide the tolerance lets a bend be is no radius that anybody meant. A route of 0.06 m
 * bends was pulled along before; now `radius` is proposed, the least room for it is said, and with it the bends are
 * listed, of half the tangent that fits: legs of 20 m, corners of 90 deg, 10 m at most. */
TEST(corners_without_a_radius)
{
    static const char corners[] = "x (m),y (m)\n0,0\n20,0\n20,20\n40,20\n";
    hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    check_has(said("route.csv", corners, ""), "2 corners without a radius, a bend of 0.06 m by the tolerance: give "
                                              "'radius', such as 10 m (room for 10 m)");
    check_has(said("route.csv", corners, ", radius: 3 m"), "route_length_m");
    check_has(said("route.csv", corners, ", radius: 12 m"), "has no room for a radius of 12 m: the leg of 20 m is 4 m");
    assert_string_equal(trouble(corners, &options, &f), "");
    options.radius_m = 3;
    assert_string_equal(trouble(corners, &options, &f), "");
    check_close(f.least_radius_m, 3, 1e-12);
    assert_int_equal(f.pieces, 5);
    assert_int_equal(f.fitted, 0);
}

/* A column that looks like a part of the route stops the reading until it is ignored; a name that no column has, and
 * columns of what is no table, are refused. */
TEST(columns_that_are_ignored)
{
    static const char table[] = "x (m),y (m),depth of cover\n0,0,1.2\n20,0,1.5\n40,0,1.9\n";
    check_has(said("route.csv", table, ", ignore: [depth of cover]"), "route_length_m");
    assert_null(strstr(said("route.csv", table, ", ignore: [depth of cover]"), "column 'depth"));
    check_has(said("route.csv", table, ", ignore: cover"), "'ignore' names a column 'cover', and there is none");
    check_has(said("plan.dxf", DXF(DXF_LINE(0, 0, 0, 50, 0, 0)), ", ignore: z"),
              "columns of a table, which this is not");
    check_has(said("plan.dxf", DXF(DXF_LINE(0, 0, 0, 50, 0, 0)), ", sheet: A"), "which this is not");
}
