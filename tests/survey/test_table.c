/* Tables: the real ones against the same line as LandXML, the planner's pieces, points, profiles, what is wrong. */
#include "tests/survey/survey_fixture.h"

/* The plan table with the profile table over it. */
static Alignment joined(const char *plan, const char *profile)
{
    Survey p = shared_file(plan), q = shared_file(profile);
    Alignment a;
    assert_true(alignment_copy(&p.alignment[0], &a));
    for (int i = 0; i < q.alignment[0].n_profile; ++i) *alignment_add_profile(&a) = q.alignment[0].profile[i];
    survey_clear(&p);
    survey_clear(&q);
    return a;
}

/* The farthest that two alignments are apart, every metre over the shorter one. */
static double apart(const Alignment *a, const Alignment *b, double behind)
{
    const double length = fmin(alignment_measure(a).plan_length - behind, alignment_measure(b).plan_length);
    double most = 0;
    for (double s = 0; s <= length; s += 1) {
        most = fmax(most, v3_norm(v3_sub(alignment_at(a, s + behind).at, alignment_at(b, s).at)));
    }
    return most;
}

TEST(railway_as_tables)
{
    Survey s = shared_file("stn01.landxml.xml");
    Alignment a = joined("stn01-horizontal.csv", "stn01-vertical.csv");
    check_close(alignment_measure(&a).plan_length, 1029.3720712725, 1e-3);
    check_below(alignment_measure(&a).gap, 1e-3);
    check_below(apart(&s.alignment[0], &a, 0), 5e-3);
    alignment_clear(&a);
    survey_clear(&s);
}

/* Their radii are negative to the left; the first begins where the railway is 153 m old. */
TEST(tables_with_other_signs)
{
    Survey s = shared_file("stn01.landxml.xml");
    Alignment one = joined("al22-alignment1-horizontal.csv", "al22-alignment1-vertical.csv");
    check_below(alignment_measure(&one).gap, 1e-3);
    check_close(one.plan[2].k0, 1e-3, 1e-12);
    const double behind = 387.72327629696491 - 234.719412;
    check_below(apart(&s.alignment[0], &one, behind), 5e-3);
    Alignment two = joined("al22-alignment2-horizontal.csv", "al22-alignment2-vertical.csv");
    check_below(alignment_measure(&two).gap, 2e-3);
    alignment_clear(&one);
    alignment_clear(&two);
    survey_clear(&s);
}

/* Feet, decimal commas, a slope in per cent, a bend upward, one to the side on the grade. */
TEST(planners_pieces)
{
    Survey s;
    assert_string_equal(
        read_text("# a duct\nname;length [ft];angle;radius (ft);turn;slope;remark\n"
                  "a;\"100,5\";;;;0;x\nb;;30,0;\"20,0\";up;;\nc;50;;;;;\n\nd;;90;10;left;;\ne;7,0;-;;;-10%;\n",
                  &s),
        "");
    const Alignment *const a = &s.alignment[0];
    const double ft = 0.3048;
    assert_int_equal(a->n_plan, 5);
    check_close(a->plan[0].length, 100.5 * ft, 1e-12);
    check_close(a->plan[1].length, 20 * ft * 0.5, 1e-12);
    check_close(a->plan[2].length, 50 * ft * sqrt(0.75), 1e-12);
    check_close(a->plan[3].k0, 0.1 / ft, 1e-12);
    check_close(a->profile[2].grade, tan(acos(-1) / 6), 1e-12);
    check_close(a->profile[3].grade, tan(acos(-1) / 6), 1e-12); /* the bend keeps it */
    check_close(a->profile[4].grade, -0.1, 1e-12);
    const double rise =
        20 * ft * (1 - sqrt(0.75)) + 25 * ft + 5 * acos(-1) * ft * tan(acos(-1) / 6) - 0.7 * ft / sqrt(1.01);
    check_close(alignment_measure(a).end.z, rise, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    assert_string_equal(piece_names_get(&a->names, a->plan[0].name), "a");
    assert_string_equal(piece_names_get(&a->names, a->plan[4].name), "e");
    alignment_reverse(&s.alignment[0]);
    assert_string_equal(piece_names_get(&a->names, a->plan[4].name), "a");
    survey_clear(&s);
}

/* Of several columns that may be names the last one with letters counts; numbers are none. */
TEST(rows_have_names)
{
    Survey s;
    Alignment copy;
    assert_string_equal(read_text("Entity,ID,Name,x,y,length\nSegment,1, out of the shaft,0,0,5\n-,2,,5,0,5\n", &s),
                        "");
    assert_true(alignment_copy(&s.alignment[0], &copy));
    survey_clear(&s);
    assert_string_equal(piece_names_get(&copy.names, copy.plan[0].name), "out of the shaft");
    assert_string_equal(piece_names_get(&copy.names, copy.plan[1].name), "");
    alignment_clear(&copy);
}

TEST(points_and_corners)
{
    Survey s;
    assert_string_equal(read_text("\xEF\xBB\xBF"
                                  "Easting\tNorthing\tElevation\r\n1,5\t2\t3\r\n4,5\t6\t3\r\n",
                                  &s),
                        "");
    assert_int_equal(s.alignment[0].n_points, 2);
    check_close(alignment_measure(&s.alignment[0]).length, 5, 1e-12);
    survey_clear(&s);
    assert_string_equal(read_text("station,elevation,curve length\n0,1,\n50,6,20\n100,1,\n", &s), "");
    assert_int_equal(s.alignment[0].n_profile, 3);
    check_close(s.alignment[0].profile[1].bend, -0.01, 1e-15);
    survey_clear(&s);
    /* no headings: by the chords */
    assert_string_equal(read_text("x,y,length,radius\n0,0,10,\n10,0,15.707963267949,10\n20,10,5,\n", &s), "");
    check_close(s.alignment[0].plan[1].heading, 0, 1e-12);
    check_close(s.alignment[0].plan[2].heading, acos(0), 1e-12);
    survey_clear(&s);
}

/* What a German spreadsheet hands over: its own first line, a byte-order mark, umlauts in either code page, decimal
 * commas; a slope under a bare percent sign or in degrees. */
TEST(as_spreadsheets_write_them)
{
    static const char *const rising[] = {
        "\xEF\xBB\xBFRechtswert;Hochwert;H\xC3\xB6he [m]\r\n453120,25;6712310,5;12,0\r\n453123,25;6712310,5;16,0\r\n",
        "Rechtswert;Hochwert;H\xF6he\n453120,25;6712310,5;12\n453123,25;6712310,5;16\n",
        "sep=;\nx;y;z\n0;0;0\n3;0;4\n",
        "length (m),slope %\n5,133.333333333333\n",
        "length (m),slope (deg)\n5,53.13010235415598\n",
        "L\xC3\xA4nge [m];Neigung [gon]\n5,0;59,033447060173\n",
    };
    for (size_t i = 0; i < sizeof rising / sizeof *rising; ++i) {
        Survey s;
        assert_string_equal(read_text(rising[i], &s), "");
        const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
        check_close(m.length, 5, 1e-9);
        check_close(m.plan_length, 3, 1e-9);
        check_close(m.end.z - m.start.z, 4, 1e-9);
        assert_int_equal(s.n_ignored, 0);
        survey_clear(&s);
    }
    Survey s; /* what is not known is said in UTF-8 */
    assert_string_equal(read_text("x,y,\xDC\n0,0,a\n3,4,b\n", &s), "");
    assert_string_equal(s.ignored[0].what, "column '\xC3\x9C'");
    survey_clear(&s);
    /* what would have been passed over: a bend without its angle, one whose length is another, columns without use */
    bad("length,radius\n10,\n7.854,5\n", "3: a piece with a radius is a bend");
    /* the length was left out, with a note: 300 m of a straight before the bend */
    bad("length,angle,radius,turn\n10,,,\n5,30,5,left\n",
        "3: a bend of 2.618 m by its radius and angle, and its length");
    /* radii of corners were left out, with a note */
    assert_string_equal(read_text("x,y,radius\n0,0,\n10,0,5\n10,10,\n", &s), "");
    check_close(s.alignment[0].plan[1].k0, 1 / 5.0, 1e-12);
    survey_clear(&s);
    bad("length,slope (deg)\n5,90\n", "2: '90' is too steep");
    bad("length,slope (deg)\n5,100\n", "too steep");
}

TEST(what_is_wrong)
{
    bad("", "the file is empty");
    bad("length,angle\n", "no rows");
    bad("length (cubits)\n1\n", "a unit that is not known");
    bad("length,Length\n1,2\n", "means the same");
    bad("length\n1\n-3\n", "3: a straight needs a length above 0");
    bad("length\n1e999\n", "2: '1e999' is no number");
    bad("length\n0x10\n", "is no number");
    bad("length,angle,radius,turn\n,45,R20,left\n", "2: 'R20' is no number"); /* L45 and R45 are angles */
    bad("angle,radius\n10,5\n", "a bend needs a turn");
    bad("angle,turn\n10,left\n", "a radius above 0");
    bad("angle,turn,radius\n10,sideways,5\n", "turn 'sideways'");
    bad("angle,turn,radius\n89,up,5\n", "no shafts");
    bad("station,elevation\n0,1\n", "two rows at least");
    bad("station,elevation\n5,1\n4,1\n", "do not rise");
    bad("station,elevation,gradient,length\n5,1,,3\n", "needs station, height, gradient");
    bad("x,y,z\n0,0,\n10,0,3\n20,0,\n", "3: a height in some rows and none in others");
    bad("\xFF\xFEx", "the file is empty");
    bad("x,y\n1,\n", "a point needs x and y");
    bad("x,y,length\n1,1,\n", "an element needs x, y and a length");
    bad("x,y,direction,length,radius\n0,0,0,1e9,1\n", "only lines with an element that turns more than 100 times");
    bad("x,y\n0,0\n1e300,1\n", "only lines with a place or a length beyond a million km");
    bad("colour,size\nred,3\n", "the columns are none of these");
}

/* Exponents as Fortran writes them. */
TEST(exponents)
{
    Survey s;
    assert_string_equal(read_text("length\n1.5D1\n1d1\n", &s), "");
    check_close(alignment_measure(&s.alignment[0]).plan_length, 25, 1e-12);
    survey_clear(&s);
}

/* What a table says is built or refused: no column of numbers, no cell and no sign is left out without a word. */
TEST(nothing_is_dropped)
{
    bad("length,slope\n100,5,2\n", "2: '2' is cell 3 of a row, and there are 2 columns");
    bad("length,angle,radius,turn\n,90%,20,left\n", "2: '90%' is no number");
    bad("length,angle,radius,turn\n,-90,20,left\n", "2: a negative angle is to the right or down");
    bad("x,y,length,direction,z\n0,0,100,0,0\n100,0,100,0,10\n", "3: an element in plan that rises needs the columns");
    bad("x,y,length,direction,slope %\n0,0,100,0,5\n", "2: an element in plan that rises needs the columns");
    bad("x,y,length,radius,turn\n0,0,100,50,up\n", "2: an element in plan turns left or right");
    bad("x,y,z,distance\n0,0,0,50\n50,0,0,120\n120,0,0,200\n",
        "3: an element of 120 m, and the next one begins 70 m away");
    bad("x,y,length,direction,z,start gradient,end gradient,vertical radius\n0,0,99.503719,0,10,0.1,-0.1,500\n",
        "2: a vertical radius of 500 m, and gradients from 0.1 to -0.1");
    bad("station,z,grade (ratio)\n0,0,5\n100,5,0\n200,5,0\n", "3: the element before ends at a height of 500.000 m");
    bad("station,x,y\n0,0,0\n100,100,0\n50,200,0\n", "4: station 50 m is -50 m on from the one before");
    bad("station,x,y\n0,0,0\n100,100,0\n50000,200,0\n", "4: station 50000 m is 49900 m on");
    /* the second bend of 7.85 m ends at 57.85 m */
    bad("station,length,angle,radius,turn,slope\n0,50,,,,0\n50,,45,10,left,\n100,30,,,,0.05\n130,,30,12,right,\n",
        "4: station 100 m is 50 m from the one before, and the pieces between them are 7.853981634 m long");
    bad("station;z;curve length;radius\n0;0;0;0\n50;5;10;200\n100;0;;\n", "3: a corner has a curve length or a radius");
    Survey s;
    assert_string_equal(read_text("station,length,angle,radius,turn,slope\n1000,50,,,,0.5\n,,45,10,left,\n"
                                  "1053.5,30,,,,\n1080.4,5,,,,\n",
                                  &s),
                        ""); /* in plan: 44.72 + 7.85, 26.83 */
    survey_clear(&s);
}

/* Slopes of a straight of 100 m, in every way that a header and a cell can have them. */
TEST(slopes_have_signs)
{
    static const struct {
        const char *text;
        double grade;
    } slopes[] = {{"length;slope %\n100;3\n", 0.03},
                  {"length;slope %\n100;3%\n", 0.03},
                  {"length;slope\n100;3 %\n", 0.03},
                  {"length;slope \xE2\x80\xB0\n100;3\n", 0.003},
                  {"length;slope \xC2\xB0\n100;45\n", 1},
                  {"length;slope \xB0\n100;45\n", 1},
                  {"station,z,slope %,length\n0,0,5,100\n100,5,5,100\n", 0.05}};
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; ++i) {
        Survey s;
        assert_string_equal(read_text(slopes[i].text, &s), "");
        check_close(s.alignment[0].profile[0].grade, slopes[i].grade, 1e-12);
        survey_clear(&s);
    }
}

/* Words for the side, beside radii and angles with and without signs. */
TEST(turns_have_sides)
{
    Survey s;
    assert_string_equal(read_text("x,y,direction,length,radius,turn\n0,0,0,50,,\n50,0,0,31.415926536,20,right\n"
                                  "70,-20,270,50,,\n70,-70,270,31.415926536,-20,left\n",
                                  &s),
                        "");
    check_close(s.alignment[0].plan[1].k0, -0.05, 1e-12);
    check_close(s.alignment[0].plan[3].k1, 0.05, 1e-12);
    survey_clear(&s);
    assert_string_equal(read_text("length,angle,radius,turn\n50,,,\n,-20,30,down\n50,,,\n", &s), "");
    check_close(s.alignment[0].profile[2].grade, -tan(20 * acos(-1) / 180), 1e-9);
    survey_clear(&s);
}

/* Stations beside points, elements and pieces are the way along them, or the table is refused: a part of the line would
 * be another. Along a slope they may be longer, and that is said. */
TEST(stations_are_the_way)
{
    Survey s;
    bad("station,x,y,z\n0,0,0,10\n150,100,0,10\n300,200,0,10\n",
        "3: station 150 m is 150 m from the first one, and the "
        "distance along the route is 100 m: expected equal ones");
    bad("station,x,y,direction,length\n0,0,0,0,100\n100,100,0,0,100\n1000,200,0,0,100\n",
        "4: station 1000 m is 1000 m from the first one, and the distance along the route is 200 m");
    assert_string_equal(read_text("station,x,y\n1000,0,0\n1100.9,100,0\n1201.5,200,0\n", &s), "");
    assert_int_equal(s.n_ignored, 0);
    survey_clear(&s);
    assert_string_equal(read_text("station,x,y,z\n0,0,0,0\n111.8,100,0,50\n", &s), "");
    check_has(s.ignored[0].what, "stations along the slope");
    survey_clear(&s);
    assert_string_equal(read_text("station,length,slope\n0,100,0.5\n100,100,0.5\n", &s), "");
    check_has(s.ignored[0].what, "stations along the slope");
    survey_clear(&s);
}

/* "inf" is a straight where a radius is asked for, as a whole word; what only begins so is no number. */
TEST(infinite_radii)
{
    static const char *const words[] = {"inf", "INF", "-Infinity ", "infinite", "\xE2\x88\x9E"};
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i) {
        char text[200];
        Survey s;
        snprintf(text, sizeof text, "x,y,direction,length,start radius,end radius\n0,0,0,50,%s,%s\n", words[i],
                 words[i]);
        assert_string_equal(read_text(text, &s), "");
        check_close(s.alignment[0].plan[0].k0, 0, 0);
        survey_clear(&s);
    }
    bad("x,y,length,radius\n0,0,50,inferred 30\n", "2: 'inferred 30' is no number");
    bad("x,y,z\n0,0,inf\n10,0,5\n", "2: 'inf' is no number");
    bad("x,y,z\n0,0,inferred\n10,0,5\n", "2: 'inferred' is no number");
}

/* A radius without an end gradient ends with the next row's gradient; a column of radii at one end alone does not say
 * what is at the other. */
TEST(radii_have_two_ends)
{
    Survey s;
    assert_string_equal(read_text("station,z,start gradient,length,radius\n0,10,-0.01,48,\n48,9.52,-0.01,4,200\n"
                                  "52,9.52,0.01,48,\n",
                                  &s),
                        "");
    check_close(s.alignment[0].profile[1].bend, 1.0 / 200, 1e-12);
    assert_int_equal(s.alignment[0].profile[1].kind, PROFILE_ARC);
    survey_clear(&s);
    bad("station,z,start gradient,length,radius\n0,10,-0.01,48,\n48,9.52,-0.01,4,200\n",
        "3: a radius of 200 m, and no gradient at its end that differs from -0.01");
    bad("x,y,azimuth (deg),length,radius\n0,0,$,999999,\n", "2: a single element needs its direction");
    bad("x,y,length,start radius\n0,0,50,\n50,0,31.4159265,20\n",
        "a column of start radii, and none of end: elements need both");
    bad("x,y,length,end radius\n0,0,50,\n50,0,31.4159265,20\n",
        "a column of end radii, and none of start: elements need both");
}
