/* LandXML: the real files against their own figures, all elements, what is wrong. */
#include "tests/survey/survey_fixture.h"

#define XML(units, body)                                                                                               \
    "<?xml version=\"1.0\"?>\n<LandXML version=\"1.2\">\n<Units>" units "</Units>\n" body "</LandXML>\n"
#define METRIC "<Metric linearUnit=\"meter\"/>"
#define ALIGNMENT(geometry, rest)                                                                                      \
    "<Alignments><Alignment name=\"a\" length=\"1\" staStart=\"100\"><CoordGeom>" geometry "</CoordGeom>" rest         \
    "</Alignment></Alignments>"

TEST(tramway)
{
    static const double length[] = {108.360853736, 14.566530746, 47.349749727, 14.578784415,
                                    58.981749834,  39.724959032, 9.190333403};
    Survey s = shared_file("cabling-civil3d.landxml.xml");
    assert_int_equal(s.n, 7);
    check_has(s.system, "EPSG:3944");
    for (int i = 0; i < s.n; ++i) {
        const AlignmentMeasure m = alignment_measure(&s.alignment[i]);
        check_close(m.plan_length, length[i], 1e-3);
        check_close(s.alignment[i].stated_length, length[i], 1e-8);
        check_below(m.gap, 1e-6);
    }
    const AlignmentMeasure first = alignment_measure(named(&s, "A1"));
    check_vec(first.start, v3(1892028.4500, 3126573.3474, 3.582147135511), 1e-4);
    check_vec(first.end, v3(1891982.8940, 3126671.4206, 3.838905911441), 1e-4);
    check_close(first.least_radius, 25, 1e-3);
    survey_clear(&s);
}

TEST(railway)
{
    Survey s = shared_file("stn01.landxml.xml");
    assert_int_equal(s.n, 1);
    const Alignment *const a = &s.alignment[0];
    const AlignmentMeasure m = alignment_measure(a);
    check_close(m.plan_length, 1029.3720712725, 1e-6);
    check_vec(m.start, v3(452270.18825, 4539403.94736, 5), 1e-5);
    check_vec(m.end, v3(453202.52411, 4539831.92869, 2), 1e-5);
    assert_int_equal(m.pieces, 9);
    check_below(m.gap, 1e-4);
    check_below(m.turn, 1e-6);
    check_close(m.least_radius, 1000, 1e-6);
    check_close(a->station, -153.1, 1e-12);
    /* level, arc of 5000 m, -1 %, arc, level */
    assert_int_equal(a->n_profile, 5);
    check_close(a->profile[1].station, 478.0045, 1e-3);
    check_close(a->profile[1].length, 49.9975, 1e-4);
    check_close(a->profile[2].grade, -0.01, 1e-12);
    survey_clear(&s);
}

/* Feet, points by name, a curve without its centre on either side and both ways, a spiral, a list of points. */
TEST(all_elements)
{
    Survey s;
    const char *const text = XML(
        "<Imperial linearUnit=\"foot\"/>",
        "<CgPoints><CgPoint name=\"p\">0 0</CgPoint><CgPoint name=\"q\">0 100 7</CgPoint></CgPoints>" ALIGNMENT(
            "<Line><Start pntRef=\"p\"/><End pntRef=\"q\"/></Line>"
            "<Curve rot=\"ccw\" radius=\"50\" length=\"78.5398163397\"><Start>0 100</Start><End>50 150</End></Curve>"
            "<Curve rot=\"cw\" radius=\"50\" length=\"235.619449\"><Start>50 150</Start><End>0 200</End></Curve>"
            "<Spiral spiType=\"bloss\" length=\"40\" rot=\"ccw\" radiusStart=\"INF\" radiusEnd=\"200\">"
            "<Start>0 0</Start><PI>0 1</PI><End>1.3323828 39.9600308</End></Spiral>"
            "<IrregularLine><Start>0 0</Start><End>30 0</End><PntList2D>0 0 10 0 20 5</PntList2D></IrregularLine>",
            "<Profile><ProfAlign name=\"d\"><PVI>100 0</PVI><UnsymParaCurve lengthIn=\"10\" lengthOut=\"20\">150 5"
            "</UnsymParaCurve><PVI>200 0</PVI></ProfAlign><ProfAlign name=\"e\"><PVI>0 0</PVI></ProfAlign>"
            "<ProfSurf name=\"ground\"/></Profile>"));
    assert_string_equal(read_text(text, &s), "");
    const Alignment *const a = &s.alignment[0];
    const double ft = 0.3048;
    assert_int_equal(a->n_plan, 7);
    check_close(a->plan[0].length, 100 * ft, 1e-12);
    check_close(a->plan[0].heading, 0, 1e-15);
    check_close(a->plan[1].k0, 1 / (50 * ft), 1e-12);
    check_close(a->plan[1].heading, 0, 1e-12);
    check_close(a->plan[1].length, acos(0) * 50 * ft, 1e-9);
    check_close(a->plan[2].k0, -1 / (50 * ft), 1e-12); /* three quarters of a turn to the right */
    check_close(a->plan[2].length, 3 * acos(0) * 50 * ft, 1e-9);
    check_close(a->plan[3].heading, 0, 1e-7);
    check_close(a->plan[3].k1, 1 / (200 * ft), 1e-12);
    check_close(a->plan[4].length, 10 * ft, 1e-12);
    check_close(a->plan[6].length, hypot(10, 5) * ft, 1e-12);
    assert_int_equal(a->n_profile, 4);
    check_close(a->profile[1].station, 40 * ft, 1e-12);
    check_close(a->profile[3].grade, -0.1, 1e-12);
    /* q's height, bloss, a second profile, the ground; the alignment's length is not its line's, which goes on behind
     * the profile */
    assert_int_equal(s.n_ignored, 6);
    check_has(s.ignored[4].what, "according to the file, but its line is");
    check_has(s.ignored[5].what, "its grade continues");
    check_has(s.unit, "foot");
    survey_clear(&s);
}

/* Heights without a profile are said, and a curve that goes nowhere; one whose length is a full turn goes around. */
TEST(what_is_left_out)
{
    Survey s;
    const char *const text =
        XML(METRIC, ALIGNMENT("<Line><Start>0 0 5</Start><End>0 10 6</End></Line>"
                              "<Curve rot=\"ccw\" radius=\"9\" length=\"0\"><Start>0 10</Start><End>0 10</End>"
                              "<Center>9 10</Center></Curve>"
                              "<Curve rot=\"ccw\" radius=\"9\" length=\"56.55\"><Start>0 10</Start><End>0 10</End>"
                              "<Center>9 10</Center></Curve>",
                              ""));
    assert_string_equal(read_text(text, &s), "");
    assert_int_equal(s.alignment[0].n_plan, 2);
    check_close(s.alignment[0].plan[1].length, 9 * 4 * acos(0), 1e-9);
    assert_int_equal(s.n_ignored, 3); /* the alignment's length too */
    check_has(s.ignored[0].what, "heights of Start, End");
    assert_int_equal(s.ignored[0].times, 1);
    check_has(s.ignored[1].what, "a Curve of no length");
    assert_int_equal(s.ignored[1].times, 1);
    survey_clear(&s);
}

/* A Curve that its length tells to turn to the other side than rot; a Spiral that does not end where it is said to;
 * heights in another unit; units behind the lines, which would have been taken for metres. */
TEST(what_contradicts_itself)
{
    Survey s;
    assert_string_equal(
        read_text(XML("<Metric linearUnit=\"meter\" elevationUnit=\"feet\"/>",
                      ALIGNMENT("<Curve rot=\"cw\" length=\"0.04\"><Start>0 0</Start><Center>10 0</Center>"
                                "<End>0.00008 0.04</End></Curve>"
                                "<Spiral rot=\"ccw\" length=\"200\" radiusStart=\"INF\" radiusEnd=\"50\">"
                                "<Start>0 0</Start><PI>0 9</PI><End>1 20</End></Spiral>",
                                "")),
                  &s),
        "");
    check_close(s.alignment[0].plan[0].length, 0.04, 1e-6);
    check_close(s.alignment[0].plan[0].k0, 0.1, 1e-12);
    check_below(hypot(alignment_at(&s.alignment[0], 0.04).at.x - 0.04, alignment_at(&s.alignment[0], 0.04).at.y - 8e-5),
                1e-6);
    check_has(s.ignored[0].what, "elevationUnit");
    check_has(s.ignored[1].what, "rot of a Curve");
    check_has(s.ignored[2].what, "Ends of Spirals");
    survey_clear(&s);
    bad("<LandXML><Alignments><Alignment name=\"a\"><CoordGeom><Line><Start>0 0</Start><End>0 "
        "9</End></Line></CoordGeom>"
        "</Alignment></Alignments><Units><Imperial linearUnit=\"foot\"/></Units></LandXML>",
        "Units after the values that they apply to");
}

TEST(what_is_wrong)
{
    bad("<LandXML><Units>", "no XML");
    bad("<svg/>", "expected <LandXML>");
    bad(XML("<Metric linearUnit=\"cubit\"/>", ""), "3: linearUnit is 'cubit'");
    bad("<!DOCTYPE x [<!ENTITY a \"b\">]><LandXML/>", "declares an entity");
    bad(XML(METRIC, ALIGNMENT("<Line><Start>1 2</Start></Line>", "")), "without Start or End");
    bad(XML(METRIC, ALIGNMENT("<Line><Start>1 two</Start><End>1 2</End></Line>", "")), "'two' is no list of numbers");
    bad(XML(METRIC, ALIGNMENT("<Line><Start>1</Start><End>1 2</End></Line>", "")), "no northing and easting");
    bad(XML(METRIC, ALIGNMENT("<Line><Start pntRef=\"z\"/><End>1 2</End></Line>", "")), "refers to point 'z'");
    bad(XML(METRIC, ALIGNMENT("<Curve rot=\"cw\"><Start>0 0</Start><End>1 2</End></Curve>", "")),
        "neither Center nor radius");
    bad(XML(METRIC, ALIGNMENT("<Curve radius=\"9\"><Start>0 0</Start><End>1 2</End></Curve>", "")),
        "a Curve without rot, cw or ccw, the direction of its turn");
    bad(XML(METRIC, ALIGNMENT("<Curve rot=\"cw\" radius=\"x\"><Start>0 0</Start><End>1 2</End></Curve>", "")),
        "expected a number");
    bad(XML(METRIC, ALIGNMENT("<Spiral length=\"9\"><Start>0 0</Start><End>1 2</End></Spiral>", "")), "a Spiral needs");
    bad(XML(METRIC, ALIGNMENT("", "<Profile><ProfAlign><PVI>1</PVI></ProfAlign></Profile>")),
        "needs station and height");
    bad(XML(METRIC, ALIGNMENT("", "<Profile><ProfAlign><PVI>5 1</PVI><PVI>4 1</PVI></ProfAlign></Profile>")),
        "do not rise");
}

/* Which way a Spiral turns is said, in any case of letters. */
TEST(spirals_turn)
{
    static const char *const form =
        "<LandXML><Units><Metric linearUnit=\"meter\"/></Units><Alignments><Alignment name=\"A\"><CoordGeom>"
        "<Spiral %s length=\"40\" radiusStart=\"INF\" radiusEnd=\"100\"><Start>0 50</Start><End>-2.65 89.84</End>"
        "</Spiral></CoordGeom></Alignment></Alignments></LandXML>";
    char text[600];
    Survey s;
    snprintf(text, sizeof text, form, "rot=\"CW\"");
    assert_string_equal(read_text(text, &s), "");
    check_close(s.alignment[0].plan[0].k1, -0.01, 1e-12);
    survey_clear(&s);
    snprintf(text, sizeof text, form, "");
    bad(text, "a Spiral without rot, cw or ccw");
}

/* Two points whose names differ behind the 63rd letter are not taken for one another; those that nobody asks for are
 * read over. */
TEST(long_names_of_points)
{
#define LONG "PPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPPP"
#define POINTS                                                                                                         \
    "<CgPoints><CgPoint name=\"A\">0 0</CgPoint><CgPoint name=\"" LONG "2\">0 100</CgPoint><CgPoint name=\"" LONG      \
    "3\">0 300</CgPoint><CgPoint name=\"B\">0 50</CgPoint></CgPoints>"
#define TO(name) ALIGNMENT("<Line><Start pntRef=\"A\"/><End pntRef=\"" name "\"/></Line>", "")
    Survey s;
    bad(XML(METRIC, POINTS TO(LONG "2")), "<End> refers to a point whose name is longer than 62 bytes, 'PPP");
    assert_string_equal(read_text(XML(METRIC, POINTS TO("B")), &s), "");
    check_close(alignment_measure(&s.alignment[0]).length, 50, 1e-12);
    survey_clear(&s);
}

/* Curves of a profile without their lengths are no corners. */
TEST(curves_need_lengths)
{
    bad(XML(METRIC, ALIGNMENT("<Line><Start>0 0</Start><End>0 100</End></Line>",
                              "<Profile><ProfAlign><PVI>0 10</PVI><UnsymParaCurve lengthIn=\"0\" lengthOut=\"40\">50 15"
                              "</UnsymParaCurve><PVI>100 10</PVI></ProfAlign></Profile>")),
        "<UnsymParaCurve> needs lengthIn and lengthOut above 0");
    bad(XML(METRIC, ALIGNMENT("<Line><Start>0 0</Start><End>0 100</End></Line>",
                              "<Profile><ProfAlign><PVI>0 10</PVI><ParaCurve>50 15</ParaCurve><PVI>100 10</PVI>"
                              "</ProfAlign></Profile>")),
        "<ParaCurve> needs a length");
}

/* A Curve of more than half a turn that neither a Center nor a length tells: its delta does, in the unit that the file
 * says, or in the one that goes with chord and radius. */
TEST(delta_of_a_curve)
{
    static const char *const unit[] = {"",
                                       "angularUnit=\"decimal degrees\"",
                                       "angularUnit=\"radians\"",
                                       "angularUnit=\"grads\"",
                                       "angularUnit=\"decimal dd.mm.ss\"",
                                       "angularUnit=\"radians\""};
    static const char *const delta[] = {"270", "270", "4.712388980", "300", "270.0000", "270"};
    char text[1000];
    Survey s;
    for (size_t i = 0; i < sizeof unit / sizeof *unit; ++i) {
        snprintf(text, sizeof text,
                 "<LandXML><Units><Metric linearUnit=\"meter\" %s/></Units><Alignments><Alignment><CoordGeom>"
                 "<Curve rot=\"ccw\" radius=\"10\" delta=\"%s\"><Start>0 20</Start><End>10 10</End></Curve>"
                 "</CoordGeom></Alignment></Alignments></LandXML>",
                 unit[i], delta[i]);
        assert_string_equal(read_text(text, &s), "");
        check_close(s.alignment[0].plan[0].length, 15 * acos(-1), 1e-6);
        survey_clear(&s);
    }
    bad(XML(METRIC,
            ALIGNMENT("<Curve rot=\"cw\" radius=\"10\" delta=\"20\"><Start>0 20</Start><End>10 10</End></Curve>", "")),
        "a Curve's delta is 20, and its chord of 14.14213562 m and radius of 10 m are 90 or 270 deg");
    assert_string_equal(
        read_text(
            XML(METRIC, ALIGNMENT("<Curve rot=\"cw\" radius=\"10\"><Start>0 20</Start><End>10 10</End></Curve>", "")),
            &s),
        "");
    check_has(s.ignored[0].what, "taken the short way");
    survey_clear(&s);
    /* an angle in words is of no use, unless nobody needs it */
    bad(XML(METRIC,
            ALIGNMENT("<Curve rot=\"cw\" radius=\"10\" delta=\"90-00-00\"><Start>0 20</Start><End>10 10</End></Curve>",
                      "")),
        "attribute 'delta' is '90-00-00': expected a number");
    assert_string_equal(
        read_text(XML(METRIC, ALIGNMENT("<Curve rot=\"ccw\" radius=\"10\" delta=\"90-00-00\"><Start>0 20</Start>"
                                        "<Center>0 10</Center><End>10 10</End></Curve>",
                                        "")),
                  &s),
        "");
    survey_clear(&s);
}
