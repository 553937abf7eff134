/* Tables as people have them: nothing with numbers is dropped, traverses, corners, totals, titles, languages. Beside
 * each value stands what was read before. */
#include "tests/survey/survey_fixture.h"

/* Reads a text; fails where it is refused. */
static Survey good(const char *text)
{
    Survey s;
    const char *const why = read_text(text, &s);
    if (*why) fail_msg("refused: %s\n%s", why, text);
    return s;
}

static AlignmentMeasure measured(const char *text)
{
    Survey s = good(text);
    assert_int_equal(s.n, 1);
    const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
    survey_clear(&s);
    return m;
}

/* The same with names of columns to ignore. */
static const char *ignoring(const char *text, const char *ignore, Survey *s)
{
    static hawser_error err;
    char path[] = "/tmp/hawser-kinds-XXXXXX";
    const SurveyOptions options = {.unit = NAN, .ignore = ignore};
    const int fd = mkstemp(path);
    assert_int_equal(write(fd, text, strlen(text)), (long)strlen(text));
    close(fd);
    const hawser_status status = survey_read(path, &options, s, &err);
    unlink(path);
    return status ? err.message : "";
}

static const double PI_ = 3.14159265358979323846;

/* A straight of 100 m on a slope under heads of six languages, and a bend of 90 deg and 10 m to the left. */
TEST(heads_in_six_languages)
{
    static const char *const texts[] = {
        "Length (m),Angle (deg),Radius (m),Turn,Slope %\n100,,,,3\n,90,10,left,\n",
        "Section length,Bend angle,Bend radius,Turn direction,Grade %\n100 m,,,,3\n,90,10 m,L,\n",
        "L\xC3\xA4nge [m];Winkel [Grad];Bogenradius [m];Richtung;Steigung %\n100,0;;;;3,0\n;90;10;links;\n",
        "L\xE4nge;Winkel;Radius;Seite;Neigung (%)\n100;;;;3\n;90;10;links;\n",
        "Longueur (m);Angle (\xC2\xB0);Rayon (m);Sens;Pente (%)\n100;;;;3\n;90;10;gauche;\n",
        "Longitud (m);\xC3\x81ngulo;Radio;Sentido;Pendiente %\n100;;;;3\n;90\xC2\xB0;10;izquierda;\n",
        "Lunghezza m,Angolo,Raggio m,Senso,Pendenza (\xE2\x80\xB0)\n100,,,,30\n,90,10,sinistra,\n",
        "\xE9\x95\xBF\xE5\xBA\xA6\xEF\xBC\x88m\xEF\xBC\x89,\xE8\xA7\x92\xE5\xBA\xA6,\xE5\x8D\x8A\xE5\xBE\x84,"
        "\xE8\xBD\xAC\xE5\x90\x91,\xE5\x9D\xA1\xE5\xBA\xA6(%)\n100,,,,3\n,90,10,\xE5\xB7\xA6,\n",
        "length\tangle\tradius\tturn\tgradient (1:n)\n100\t\t\t\t33.333333333333333\n\t90\t10\tleft\t\n",
        "length,angle,radius,turn,slope\n100,,,,1:33.333333333333333\n,90,10,left,\n",
        "length,angle,radius,turn,slope (deg)\n100,,,,1.7183580016554572\n,90,10,left,\n",
        "length,angle,radius,turn,incline\nm,deg,m,-,%\n100,,,,3\n,90,10,left,\n",
        "length_ft,angle_deg,radius_ft,turn,slope_pct\n328.08398950131233,,,,3\n,90,32.808398950131235,left,\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        Survey s = good(texts[i]);
        const Alignment *const a = &s.alignment[0];
        check_close(a->profile[0].grade, 0.03, 1e-9);
        check_close(alignment_measure(a).length, 100 + 5 * PI_ * sqrt(1.0009), 1e-6);
        check_close(a->plan[1].k0, 0.1, 1e-9);
        assert_int_equal(s.n_ignored, 0);
        survey_clear(&s);
    }
}

/* 18.86 kN and NOT SAFE where a column 'Grade %' was left out and the route taken for level. */
TEST(slopes_are_not_dropped)
{
    check_close(measured("Length,Grade %\n300,20\n100,0\n").end.z, 300 * 0.2 / sqrt(1.04), 1e-9); /* was 0 */
    check_close(measured("Length,Gradient (1 in n)\n300,5\n100,0\n").end.z, 300 * 0.2 / sqrt(1.04), 1e-9);
    check_close(measured("Horizontal length,Slope %\n300,20\n100,0\n").end.z, 60, 1e-9); /* 300 m along it */
    bad("Length,Slope\n300,1.5\n100,-1\n", "2: '1.5' of column 'Slope' has no unit");    /* 56 deg */
    bad("Length,Slope\n300,-1\n100,0\n", "'-1' of column 'Slope' has no unit");
    bad("Length,Gef\xC3\xA4lle %\n300,2\n", "positive down or up");
    bad("Station,Quergef\xC3\xA4lle %\n0,2\n100,2\n", "cant does not define a line");
    bad("StartDistAlong,HorizontalLength,StartCantLeft,EndCantLeft\n0,100,0,0.1\n", "cant does not define");
    bad("length,my gradient x\n300,20\n100,0\n", "head is not known: 2 'my gradient x'; expected");
    bad("length,climb angle %\n300,20\n", "not known: 2 'climb angle %'");
    bad("length,angle,radius,turn,bearing\n300,,,,90\n,90,10,left,\n", "a column 'direction' in a table of pieces");
    bad("x,y,Hoogte\n0,0,1.5\n100,0,12.25\n200,0,3.5\n", "not known: 3 'Hoogte'"); /* heights without a known head */
    bad("x,y,run\n0,0,0\n100,0,100\n200,0,200\n", "not known: 3 'run'");
    bad("length,\n300,20\n100,0\n", "not known: 2 ''");
    /* a property of the pieces was left out: the theory took the duct's friction, and said nothing */
    bad("length,angle,radius,friction,voltage\n100,,,0.3,110\n,45,6,0.25,110\n",
        "columns with numbers whose head is not known: 4 'friction', 5 'voltage'; expected length");
}

/* What is no part of a route is said to be unused, and can be silenced. */
TEST(other_columns_are_said)
{
    Survey s = good("length,cost,sheet,date,notes\n300,1200,4,2026-01-02,wet\n100,800,5,2026-01-03,\n");
    assert_int_equal(s.n_ignored, 4);
    assert_string_equal(s.ignored[0].what, "column 'cost'");
    survey_clear(&s);
    /* dates and names that begin with a digit are no numbers */
    s = good("length;laid;built;manhole\n300;2024-05-01;1.5.2024;12A\n100;2024-05-03;;7-8\n");
    assert_int_equal(s.n_ignored, 3);
    survey_clear(&s);
    bad("length;a;b;c;d;f\n300;12 mm;0+050;1:50;1,5;45 L\n", "not known: 2 'a', 3 'b', 4 'c', 5 'd', 6 'f';");
    assert_string_equal(ignoring("length,cost,Grade %\n300,1200,20\n", "Cost\ngrade", &s), "");
    assert_int_equal(s.n_ignored, 0);
    check_close(alignment_measure(&s.alignment[0]).end.z, 0, 0);
    survey_clear(&s);
    check_has(ignoring("length,cost\n300,1200\n", "price", &s), "'ignore' names a column 'price'");
}

/* A row that is the sum of those above was a piece: 831.4 m in place of 415.7 m. */
TEST(totals_are_no_pieces)
{
    static const char *const totals[] = {
        "name,length,angle,radius,turn\nA,300,,,\nB,,90,10,left\nC,100,,,\nTotal,415.7,,,\n",
        "length,angle,radius,turn,remark\n300,,,,\n,90,10,left,\n100,,,,\n415.7,,,,Summe\n",
        "length;angle;radius;turn\n300;;;\n;90;10;left\n100;;;\n\xE5\x90\x88\xE8\xAE\xA1;;;\n"};
    for (size_t i = 0; i < sizeof totals / sizeof *totals; ++i)
        check_close(measured(totals[i]).length, 400 + 5 * PI_, 1e-9);
    bad("length,angle,radius,turn\n300,,,\n,90,10,left\n100,,,\n415.7,,,\n", "5: the last row is as long as all above");
    bad("length,angle,radius,turn\n300,,,\n,90,10,left\n100,,,\n400,,,\n", "5: the last row is as long as all above");
    bad("name,length\nA,300\nB,100\nTotal,500\n", "4: the total is 500 m, and the pieces above are 400 m long");
    check_close(measured("name,length\nA,300\nB,100\nback again,400\n").length, 800, 1e-9);
    check_close(measured("length,angle,radius,turn\n50,,,\n,90,10,left\n50,,,\n").length, 100 + 5 * PI_, 1e-9);
}

/* Titles above, units and repeated heads below, notes, blank lines, encodings and commas of numbers. */
TEST(tables_with_much_around)
{
    static const char *const texts[] = {
        "Cable route, section 4\nPlot no. 12,,\n\nx,y,z\nm,m,m\n0,0,0\n\n100,0,0\nx,y,z\n200,0,0\nchecked by N.N.,,\n",
        "\xEF\xBB\xBFTrasse;;\nRechtswert;Hochwert;H\xC3\xB6he\n0,0;0,0;0,0\n100,0;0,0;0,0\n200,0;0,0;0,0\n",
        "x,y\n\"0,0\",\"0,0\"\n\"100,0\",\"0,0\"\n\"200,0\",\"0,0\"\n",
        "x;y\n0;0\n1.100,0;0\n1.200,0;0\n", /* thousands */
        "x\ty\n1\xC2\xA0"
        "000,0\t0\n1 100,0\t0\n1 200,0\t0\n",
        "\"x\n(m)\",\"y\n(m)\"\n0,0\n100,0\n200,0\n",
        "x|y\n0|0\n100|0\n200|0\n",
        "x (ft),y (ft)\n0,0\n328.0839895,0\n656.167979,0\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        const AlignmentMeasure m = measured(texts[i]);
        check_close(m.end.x - (i == 4 ? 1000 : 0), i == 3 ? 1200 : 200, 1e-6);
        check_close(m.end.y, 0, 0);
    }
    bad("x,y\n\"1,250\",0\n\"2,250\",0\n", "may be a thousand or have a decimal comma");
    bad("x;y\n1.5;0\n2,5;0\n", "decimal points and commas in one file");
    bad("All lengths in feet\nlength,angle,radius,turn\n300,,,\n", "1: the title says 'feet'");
    bad("length\n300\n100\n\nx,y\n0,0\n", "a second row of heads");
    bad("x,y\n1.250.000,0\n2,0\n", "is no number");
}

/* UTF-16 of both orders; it was refused. */
TEST(as_unicode_text)
{
    const char *const text = "L\xE4nge;Steigung %\r\n300;20\r\n100;0\r\n";
    for (int big = 0; big < 2; ++big) {
        char path[] = "/tmp/hawser-kinds-XXXXXX", wide[200];
        size_t n = 0;
        hawser_error err;
        Survey s;
        wide[n++] = (char)(big ? 0xFE : 0xFF);
        wide[n++] = (char)(big ? 0xFF : 0xFE);
        for (const char *c = text; *c; ++c) {
            wide[n + (size_t)big] = *c;
            wide[n + (size_t)!big] = 0;
            n += 2;
        }
        const int fd = mkstemp(path);
        assert_int_equal(write(fd, wide, n), (long)n);
        close(fd);
        if (survey_read(path, &usual, &s, &err)) fail_msg("%s", err.message);
        unlink(path);
        check_close(alignment_measure(&s.alignment[0]).end.z, 300 * 0.2 / sqrt(1.04), 1e-9);
        survey_clear(&s);
    }
}

/* Distance and bearing was one straight of 400 m; degrees, gons, quadrants, minutes. */
TEST(traverses)
{
    static const char *const legs[] = {"Distance,Bearing\n300,90\n100,0\n",
                                       "Distance,Azimuth (gon)\n300,100\n100,0\n",
                                       "Distance,Bearing\n300,N90E\n100,N 0\xC2\xB0"
                                       "00'00\" E\n",
                                       "Distance,Bearing\n300,90\xC2\xB0\n100,0\xC2\xB0\n",
                                       "Distance (m);Richtungswinkel [gon];Punkt\n300,0;100,0;A\n100,0;0,0;B\n",
                                       "Distance,Gisement (gon)\n300,100\n100,400\n"};
    for (size_t i = 0; i < sizeof legs / sizeof *legs; ++i) {
        Survey s = good(legs[i]);
        const Alignment *const a = &s.alignment[0];
        assert_int_equal(a->n_points, 3);
        assert_true(a->drawn);
        check_close(a->point[1].x, 300, 1e-9);
        check_close(a->point[2].y, 100, 1e-9);
        survey_clear(&s);
    }
    Survey s = good("Distance,Bearing,Radius,Slope %\n300,90,10,0\n100,0,,10\n");
    check_close(s.alignment[0].plan[1].k0, 0.1, 1e-12);
    check_close(s.alignment[0].plan[1].length, 5 * PI_, 1e-9);
    check_close(alignment_measure(&s.alignment[0]).end.y, 100 / sqrt(1.01), 1e-9);
    check_close(alignment_measure(&s.alignment[0]).end.z, 10 / sqrt(1.01), 1e-6);
    survey_clear(&s);
    s = good("Distance,Bearing,Radius\n300,S 45-30-30 E,\n100,N45E,20\n");
    check_close(s.alignment[0].plan[0].heading, -(45 + 30.0 / 60 - 1) * PI_ / 180, 0.02);
    survey_clear(&s);
    bad("Distance,Direction\n300,90\n100,0\n", "a column 'bearing' counts clockwise from north");
    bad("Distance,Bearing\n300,390\n100,0\n", "a bearing of 390 deg");
    bad("Distance,Bearing,Radius\n300,90,10\n100,0,20\n50,90,5\n", "radii at the start or at the end of legs");
}

/* x, y and a radius for each corner, in plan and with heights; a corner without one is said with what it may be. */
TEST(corner_lists)
{
    Survey s = good("x,y,radius\n0,0,\n300,0,10\n300,100,5\n400,100,\n");
    const Alignment *const a = &s.alignment[0];
    assert_int_equal(a->n_plan, 5);
    check_close(a->plan[1].length, 5 * PI_, 1e-9);
    check_close(a->plan[3].k0, -0.2, 1e-12);
    check_close(alignment_measure(a).length, 500 - 20 + 5 * PI_ - 10 + 2.5 * PI_, 1e-9);
    check_below(alignment_measure(a).gap, 1e-9);
    survey_clear(&s);
    s = good("Easting;Northing;Elevation;Rayon\n0;0;0;\n300;0;30;10\n300;100;30;\n");
    check_close(alignment_measure(&s.alignment[0]).end.z, 30, 1e-9);
    check_close(s.alignment[0].profile[0].grade, 30 / (290 + 2.5 * PI_), 1e-9);
    survey_clear(&s);
    bad("x,y,radius\n0,0,\n300,0,10\n300,100,\n400,100,\n",
        "4: the corner at 300.000, 100.000 turns by 90.0 deg and has no radius: give it one, or one 'radius' for all");
    bad("x,y,radius\n0,0,\n300,0,60\n300,100,60\n400,100,\n", "has no room for a radius of 60 m");
    bad("x,y,radius\n0,0,\n0,0,10\n300,100,\n", "at one place in plan");
}

/* Degrees in x and y were a route of 2 mm; a profile alone a level route of 150 m. */
TEST(maps_and_profiles)
{
    bad("x,y\n8.0000,50.0000\n8.0010,50.0000\n8.0020,50.0000\n",
        "degrees? Then name the columns 'longitude' and 'latitude'");
    static const char *const texts[] = {"lon,lat\n8.0000,50.0000\n8.0010,50.0000\n8.0020,50.0000\n",
                                        "Latitude;L\xC3\xA4ngengrad\n50,0;8,0\n50,0;8,001\n50,0;8,002\n",
                                        "x (deg),y (deg)\n8.0000,50.0000\n8.0010,50.0000\n8.0020,50.0000\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) check_close(measured(texts[i]).length, 143.392, 1e-3);
    check_close(measured("x (m),y (m)\n8.0000,50.0000\n8.0010,50.0000\n8.0020,50.0000\n").length, 0.002, 1e-9);
    Survey s = good("Distance,Elevation\n25,10\n50,12\n75,11\n");
    assert_int_equal(s.alignment[0].n_plan, 0);
    assert_int_equal(s.alignment[0].n_profile, 2);
    survey_clear(&s);
    bad("Distance,Elevation\n25,10\n20,12\n75,11\n", "a profile has rising stations");
}

/* Stations as road people write them. */
TEST(stations_with_a_plus)
{
    static const char *const texts[] = {"station,x,y\n0+000,0,0\n0+100,100,0\n1+000,1000,0\n",
                                        "Chainage;x;y\nK0+000;0;0\nK0+100,0;100;0\nK1+000;1000;0\n",
                                        "PK,x,y\nPK 2+000,0,0\nPK 2+100.0,100,0\nPK 3+000,1000,0\n",
                                        "sta (ft),x (ft),y (ft)\n0+00,0,0\n1+00,100,0\n10+00.0,1000,0\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        Survey s = good(texts[i]);
        check_close(s.alignment[0].station, i == 2 ? 2000 : 0, 1e-9);
        survey_clear(&s);
    }
    bad("length,angle,radius,turn\n0+050,,,\n", "is no number");
    bad("station,angle,radius,turn\n300,90,10,left\n", "bends at stations, and no lengths");
}
