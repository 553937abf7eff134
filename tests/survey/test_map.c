/* GPX and GeoJSON, and the projection: true on its meridian, conformal, and back. */
#include <math.h>

#include "survey/map.h"
#include "tests/survey/survey_fixture.h"

static const double AXIS = 6378137, FLAT = 1 / 298.257223563;

/* Length of the meridian between two latitudes, degrees, by Simpson's rule on its radius of curvature. */
static double meridian(double from, double to)
{
    enum { N = 2000 };
    const double square = FLAT * (2 - FLAT), h = (to - from) * acos(-1) / 180 / N;
    double sum = 0;
    for (int i = 0; i <= N; ++i) {
        const double s = sin(from * acos(-1) / 180 + i * h);
        sum += (i == 0 || i == N ? 1 : i % 2 ? 4 : 2) * AXIS * (1 - square) / pow(1 - square * s * s, 1.5);
    }
    return sum * h / 3;
}

TEST(projection)
{
    const MapOrigin origin = {7.25, 51.5};
    double x, y, longitude, latitude;
    map_to_ground(origin, 7.25, 53, &x, &y);
    check_close(x, 0, 1e-9);
    check_close(y, meridian(51.5, 53), 1e-6);
    for (int i = 0; i < 5; ++i) {
        const double at[2] = {7.25 + 0.4 * i, 51.5 - 0.7 * i}, h = 1e-4, square = FLAT * (2 - FLAT);
        double p[4][2];
        for (int k = 0; k < 4; ++k) {
            map_to_ground(origin,
                          at[0] + (k == 0   ? h
                                   : k == 1 ? -h
                                            : 0),
                          at[1] + (k == 2   ? h
                                   : k == 3 ? -h
                                            : 0),
                          &p[k][0], &p[k][1]);
        }
        const double s = sin(at[1] * acos(-1) / 180), w = 1 - square * s * s, degree = acos(-1) / 180;
        const double east = AXIS / sqrt(w) * cos(at[1] * degree) * 2 * h * degree;
        const double north = AXIS * (1 - square) / pow(w, 1.5) * 2 * h * degree;
        const double e[2] = {(p[0][0] - p[1][0]) / east, (p[0][1] - p[1][1]) / east};
        const double n[2] = {(p[2][0] - p[3][0]) / north, (p[2][1] - p[3][1]) / north};
        check_close(e[0], n[1], 1e-8);
        check_close(e[1], -n[0], 1e-8);
        map_to_ground(origin, at[0], at[1], &x, &y);
        check_close(hypot(e[0], e[1]), 1 + x * x / (2 * 6.381e6 * 6.381e6), 1e-6); /* the scale that is stated */
        map_from_ground(origin, x, y, &longitude, &latitude);
        check_close(longitude, at[0], 1e-12);
        check_close(latitude, at[1], 3e-12); /* 0.3 um */
    }
}

TEST(gpx)
{
    Survey s;
    assert_string_equal(
        read_text(
            "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\">"
            "<wpt lat=\"60\" lon=\"10\"><ele>3</ele><name>pit 1</name></wpt>"
            "<trk><name>drum to pit</name><trkseg><trkpt lat=\"60\" lon=\"10\"><ele>1</ele></trkpt>"
            "<trkpt lat=\"60.001\" lon=\"10\"><ele>2.5</ele><time>x</time></trkpt></trkseg><trkseg></trkseg></trk>"
            "<rte><name>other</name><rtept lat=\"60\" lon=\"10.001\"><name>A</name></rtept><rtept lat=\"60\" "
            "lon=\"10.002\"/>"
            "</rte></gpx>",
            &s),
        "");
    assert_int_equal(s.n, 2);
    assert_int_equal(s.n_marks, 1);
    assert_string_equal(s.mark[0].name, "pit 1");
    check_vec(s.mark[0].at, v3(0, 0, 3), 1e-9);
    const Alignment *const a = named(&s, "drum to pit"), *const b = named(&s, "other");
    check_vec(alignment_measure(a).end, v3(0, meridian(60, 60.001), 2.5), 1e-6);
    assert_true(b->flat && !a->flat);
    const double square = FLAT * (2 - FLAT), w = 1 - square * 0.75;
    check_close(alignment_measure(b).length, AXIS / sqrt(w) * 0.5 * 1e-3 * acos(-1) / 180, 1e-6);
    check_has(s.system, "longitude 10.0");
    survey_clear(&s);
}

TEST(geojson)
{
    Survey s;
    assert_string_equal(
        read_text("{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"name\":\"a\","
                  "\"layer\":"
                  "\"L\"},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[[10,60,1],[10,60.001,2]]}},"
                  "{\"type\":\"Feature\",\"properties\":null,\"geometry\":{\"type\":\"MultiLineString\","
                  "\"coordinates\":[[[10,60],"
                  "[10,60.002]],[[10,60],[10,60.003]]]}},{\"type\":\"Feature\",\"properties\":{\"name\":\"winch\"},"
                  "\"geometry\":{"
                  "\"type\":\"Point\",\"coordinates\":[10,60.001,7]}},{\"type\":\"Polygon\",\"coordinates\":[]}]}",
                  &s),
        "");
    assert_int_equal(s.n, 3);
    assert_string_equal(s.alignment[0].layer, "L");
    check_vec(alignment_measure(&s.alignment[0]).end, v3(0, meridian(60, 60.001), 2), 1e-6);
    check_close(alignment_measure(&s.alignment[2]).length, meridian(60, 60.003), 1e-6);
    assert_int_equal(s.n_marks, 1);
    check_close(s.mark[0].at.z, 7, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    survey_clear(&s);
    assert_string_equal(read_text("\x1E{\"type\":\"LineString\",\"coordinates\":[[10,60],[10,60.001]]}\n\x1E"
                                  "{\"type\":\"LineString\",\"coordinates\":[[10,60],[10,60.002]]}\n",
                                  &s),
                        "");
    assert_int_equal(s.n, 2);
    survey_clear(&s);
    assert_string_equal(
        read_text("{\"type\":\"LineString\",\"coordinates_in\":\"m\",\"coordinates\":[[0,0],[3000,4000]]}", &s), "");
    check_close(alignment_measure(&s.alignment[0]).length, 5000, 1e-9);
    survey_clear(&s);
}

/* The `crs` of old files and of map programs: a geographic system by whatever number is degrees, and it is said how it
 * was taken; what stands in extensions is another program's. */
TEST(crs_of_other_names)
{
    Survey s;
    assert_string_equal(
        read_text(
            "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:"
            "EPSG::4258\"}},\"features\":[{\"type\":\"Feature\",\"properties\":null,\"geometry\":{\"type\":"
            "\"LineString\",\"coordinates\":[[10,60],[10,60.001]]}}]}",
            &s),
        "");
    check_close(alignment_measure(&s.alignment[0]).length, meridian(60, 60.001), 1e-6);
    check_has(s.ignored[0].what, "EPSG::4258': coordinates are taken as degrees");
    survey_clear(&s);
    assert_string_equal(read_text("{\"type\":\"LineString\",\"crs\":{\"properties\":{\"name\":\"EPSG:25832\"}},"
                                  "\"coordinates\":[[453120,6712310],[453123,6712314]]}",
                                  &s),
                        "");
    check_close(alignment_measure(&s.alignment[0]).length, 5, 1e-9);
    check_has(s.ignored[0].what, "taken as metres");
    survey_clear(&s);
    /* across the antimeridian */
    assert_string_equal(read_text("{\"type\":\"LineString\",\"coordinates\":[[179.9995,0],[-179.9995,0]]}", &s), "");
    check_close(alignment_measure(&s.alignment[0]).length, AXIS * 1e-3 * acos(-1) / 180, 1e-6);
    survey_clear(&s);
    assert_string_equal(
        read_text("<gpx><trk><name>own</name><extensions><name>alien</name></extensions><trkseg>"
                  "<trkpt lat=\"60\" lon=\"10\"><ele>5</ele><extensions><ele>9</ele></extensions></trkpt>"
                  "<trkpt lat=\"60.001\" lon=\"10\"><ele>5</ele></trkpt></trkseg></trk></gpx>",
                  &s),
        "");
    assert_string_equal(s.alignment[0].name, "own");
    check_close(alignment_measure(&s.alignment[0]).start.z, 5, 0);
    survey_clear(&s);
}

/* Elements within elements: 64 of them, and no more. */
TEST(depth)
{
    char text[1024] = "<gpx>";
    for (int k = 1; k < 64; ++k) strcat(text, "<a>");
    for (int deeper = 0; deeper < 2; ++deeper) {
        char whole[2048];
        snprintf(whole, sizeof whole, "%s%s%s", text, deeper ? "<b>" : "", deeper ? "</b>" : "");
        for (int k = 1; k < 64; ++k) strcat(whole, "</a>");
        strcat(whole, "</gpx>");
        if (deeper) bad(whole, "<b>: elements more than 64 deep");
        Survey s;
        if (!deeper) assert_null(strstr(read_text(whole, &s), "deep"));
    }
}

/* A prefix of its own, comments longer than a page and a DOCTYPE before the outermost element; a mark of the order of
 * bytes before JSON. */
TEST(what_stands_before)
{
    static const char *const track =
        "<trk><trkseg><trkpt lat=\"60\" lon=\"10\"/><trkpt lat=\"60.001\" lon=\"10\"/></trkseg></trk>";
    char text[4000], comment[2000];
    Survey s;
    memset(comment, 'x', sizeof comment);
    comment[sizeof comment - 1] = 0;
    snprintf(text, sizeof text, "<?xml version=\"1.0\"?>\n<!-- <g> %s -->\n<!DOCTYPE gpx [ <!-- > --> ]><gpx>%s</gpx>",
             comment, track);
    assert_string_equal(read_text(text, &s), "");
    assert_int_equal(s.n, 1);
    survey_clear(&s);
    snprintf(text, sizeof text, "<g:gpx xmlns:g=\"http://www.topografix.com/GPX/1/1\">%s</g:gpx>", track);
    assert_string_equal(read_text(text, &s), "");
    assert_int_equal(s.n, 1);
    survey_clear(&s);
    bad("<xgpx/>", "expected <LandXML>");
    assert_string_equal(
        read_text("\xEF\xBB\xBF{\"type\":\"LineString\",\"coordinates_in\":\"m\",\"coordinates\":[[0,0],[3,4]]}", &s),
        "");
    check_close(alignment_measure(&s.alignment[0]).length, 5, 1e-12);
    survey_clear(&s);
}

TEST(what_is_wrong)
{
    bad("{\"type\":\"LineString\",\n\"coordinates\":[[1,2],[3,", "2: no JSON");
    bad("{\"type\":\"LineString\",\"coordinates\":[[1,2]]}", "fewer than two positions");
    bad("{\"type\":\"LineString\",\"coordinates\":[[1],[2,3]]}", "no list of two or three numbers");
    bad("{\"type\":\"LineString\",\"coordinates\":[[10,60],[20,60]]}", "farther than 300 km");
    bad("{\"type\":\"LineString\",\"coordinates\":[[500000,6700000],[1,1]]}", "expected degrees");
    bad("{\"type\":\"LineString\",\"crs\":{\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::3857\"}},"
        "\"coordinates\":[[1113194,8399737],[1113294,8399737]]}",
        "crs 'urn:ogc:def:crs:EPSG::3857': metres of a map of the world are too long");
    bad("{\"type\":\"Polygon\",\"coordinates\":[]}", "no line and no point");
    bad("{}", "without a type");
    bad("<gpx><trk><trkseg><trkpt lat=\"x\" lon=\"1\"/></trkseg></trk></gpx>", "'x' is no number");
    bad("<gpx><wpt lat=\"1\"/></gpx>", "'' is no number");
    bad("<gpx>\n<trk></gpx>", "2: no XML");
    bad("<!DOCTYPE g [<!ENTITY a \"b\">]><gpx/>", "declares an entity");
}

/* Names in encodings that expat lacks, by iconv: "no XML: unknown encoding" before. One of several bytes a character
 * still is. */
TEST(encodings)
{
    static const struct {
        const char *name, *bytes, *utf8;
    } cases[] = {{"windows-1252",
                  "Stra\xDF"
                  "e \x80",
                  "Stra\xC3\x9F"
                  "e \xE2\x82\xAC"},
                 {"windows-1251", "\xD2\xF0", "\xD0\xA2\xD1\x80"},
                 {"ISO-8859-15", "\xA4", "\xE2\x82\xAC"},
                 {"ISO-8859-2", "\xB3", "\xC5\x82"}};
    char text[800];
    Survey s;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        snprintf(text, sizeof text,
                 "<?xml version=\"1.0\" encoding=\"%s\"?>\n<gpx version=\"1.1\"><trk><name>%s</name><trkseg>"
                 "<trkpt lat=\"50\" lon=\"7\"/><trkpt lat=\"50\" lon=\"7.001\"/></trkseg></trk></gpx>",
                 cases[i].name, cases[i].bytes);
        assert_string_equal(read_text(text, &s), "");
        assert_string_equal(s.alignment[0].name, cases[i].utf8);
        survey_clear(&s);
        snprintf(
            text, sizeof text,
            "<?xml version=\"1.0\" encoding=\"%s\"?>\n<LandXML><Alignments><Alignment name=\"%s\"><CoordGeom><Line>"
            "<Start>0 0</Start><End>0 9</End></Line></CoordGeom></Alignment></Alignments></LandXML>",
            cases[i].name, cases[i].bytes);
        assert_string_equal(read_text(text, &s), "");
        assert_string_equal(s.alignment[0].name, cases[i].utf8);
        survey_clear(&s);
    }
    bad("<?xml version=\"1.0\" encoding=\"GBK\"?>\n<gpx version=\"1.1\"/>", "unknown encoding");
    bad("<?xml version=\"1.0\" encoding=\"none\"?>\n<gpx version=\"1.1\"/>", "unknown encoding");
}

#define KML(...)                                                                                                       \
    "<?xml version='1.0'?>\n<kml xmlns='http://www.opengis.net/kml/2.2' xmlns:gx='g'><Document>" __VA_ARGS__           \
    "</Document></kml>"
#define PLACEMARK(...)   "<Placemark>" __VA_ARGS__ "</Placemark>"
#define LINE_STRING(...) "<LineString>" __VA_ARGS__ "</LineString>"

/* As Google Earth writes it: a name before and one behind the line, heights of 0 on the ground, a folder's name that is
 * nobody's, coordinates over several lines and with a blank behind a comma. */
TEST(kml)
{
    Survey s;
    assert_string_equal(
        read_text(
            KML("<name>doc</name><Style id='s'><LineStyle><width>3</width></LineStyle></Style><Folder><name>F"
                "</name>" PLACEMARK("<name>drum to pit</name><LookAt><longitude>1</longitude></LookAt>" LINE_STRING(
                    "<tessellate>1</tessellate><coordinates>\n 10,60,0\n\t10, 60.001,0 \n</coordinates>"))
                    PLACEMARK(
                        LINE_STRING("<altitudeMode>absolute</altitudeMode><coordinates>10,60,1 "
                                    "10,60.002,2.5</coordinates>") "<name>second</name><ExtendedData><Data"
                                                                   " name='x'><name>no</name></Data></ExtendedData>")
                        PLACEMARK("<name>pit</name><Point><coordinates>10,60,7</coordinates></Point>") "</Folder>"),
            &s),
        "");
    assert_int_equal(s.n, 2);
    const Alignment *const a = named(&s, "drum to pit"), *const b = named(&s, "second");
    check_close(alignment_measure(a).length, meridian(60, 60.001), 1e-6);
    assert_true(a->flat && !a->partly && !b->flat);
    check_vec(alignment_measure(b).end, v3(0, meridian(60, 60.002), 2.5), 1e-6);
    assert_int_equal(s.n_marks, 1);
    assert_string_equal(s.mark[0].name, "pit");
    check_close(s.mark[0].at.z, 7, 0);
    assert_int_equal(s.n_ignored, 0);
    survey_clear(&s);
}

/* A receiver's track, and parts of one feature, which are one line where they touch. */
TEST(kml_tracks_and_parts)
{
    Survey s;
    assert_string_equal(
        read_text(KML(PLACEMARK("<name>t</name><gx:MultiTrack><altitudeMode>absolute</altitudeMode><gx:Track><when>2020"
                                "</when><gx:coord>10 60 3</gx:coord><gx:coord>10 60.001 4</gx:coord></gx:Track>"
                                "<gx:Track><gx:coord>10 60.001 4</gx:coord><gx:coord>10 60.002 5</gx:coord></gx:Track>"
                                "</gx:MultiTrack>")),
                  &s),
        "");
    assert_int_equal(s.n, 2);
    assert_true(s.alignment[0].whole == 1 && s.alignment[1].whole == 1);
    check_close(alignment_measure(&s.alignment[1]).end.z, 5, 0);
    survey_clear(&s);
    assert_string_equal(
        read_text(KML(PLACEMARK("<MultiGeometry>" LINE_STRING("<coordinates>10,60 10,61</coordinates>")
                                    LINE_STRING("<coordinates>10,61 10,62</coordinates>") "</MultiGeometry>")
                          PLACEMARK(LINE_STRING("<coordinates>10,60 10,60.5</coordinates>"))),
                  &s),
        "");
    assert_int_equal(s.n, 3);
    assert_true(s.alignment[0].whole == 1 && s.alignment[1].whole == 1 && s.alignment[2].whole == 0);
    survey_clear(&s);
}

/* Heights above a ground that is not in the file are none; those of a line on the ground are taken, and both are said.
 * What is no line is named. */
TEST(kml_that_leaves_open)
{
    Survey s;
    assert_string_equal(
        read_text(
            KML(PLACEMARK("<name>r</name>" LINE_STRING("<altitudeMode>relativeToGround</altitudeMode><coordinates>"
                                                       "10,60,2 10,60.001,3</coordinates>"))
                    PLACEMARK("<name>g</name>" LINE_STRING("<coordinates>10,60,2 10,60.001,3</coordinates>"))
                        PLACEMARK("<Polygon><outerBoundaryIs><LinearRing><coordinates>1,1 2,2 1,2</coordinates>"
                                  "</LinearRing></outerBoundaryIs></Polygon>") "<NetworkLink/>"),
            &s),
        "");
    assert_int_equal(s.n, 2);
    assert_true(named(&s, "r")->flat && named(&s, "r")->partly && !named(&s, "g")->flat);
    assert_int_equal(s.n_ignored, 4);
    check_has(s.ignored[0].what, "heights above the ground");
    check_has(s.ignored[1].what, "clamped to the ground: its heights are taken");
    check_has(s.ignored[3].what, "NetworkLink");
    survey_clear(&s);
    bad(KML(PLACEMARK(LINE_STRING("<coordinates>\n10,60\n10;61\n</coordinates>"))), "4: '10;61' is no place");
    bad(KML(PLACEMARK(LINE_STRING("<coordinates>10,60 10</coordinates>"))), "'10' is no place");
    bad(KML(PLACEMARK(LINE_STRING("<coordinates>10,60,1,2</coordinates>"))), "is no place");
    bad(KML(PLACEMARK(LINE_STRING("<coordinates>60,100 60,101</coordinates>"))), "expected degrees, within 180 and 89");
    bad(KML(PLACEMARK("<gx:Track><gx:coord>10</gx:coord></gx:Track>")), "'10' is no place");
    bad(KML(PLACEMARK("<gx:Track><gx:coord/></gx:Track>")), "is no place");
}
