/* IFC: the real files, by meaning and by what is drawn; units, placements, the older schema; what is wrong. */
#include "core/vec3.h"
#include "tests/survey/survey_fixture.h"

#define IFC(schema, body)                                                                                              \
    "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" schema "'));\nENDSEC;\nDATA;\n" body "ENDSEC;\nEND-ISO-10303-21;\n"

TEST(tunnel)
{
    Survey s = shared_file("tunnel-alignment.ifc");
    assert_int_equal(s.n, 1);
    const Alignment *const a = &s.alignment[0];
    const AlignmentMeasure m = alignment_measure(a);
    assert_int_equal(a->n_plan, 12);
    check_close(a->plan[0].length, 135.7701281426, 1e-9);
    check_close(a->plan[1].length, 47.6666668494, 1e-9);
    check_below(m.gap, 1e-6);
    check_below(m.turn, 1e-6);
    check_close(m.least_radius, 124.024774, 1e-6);
    assert_int_equal(a->n_profile, 5);
    check_close(alignment_measure(a).start.z, 31.2446 + 15.9278 * 0.01689175912921463, 1e-9);
    check_has(s.system, "EPSG:25832");
    survey_clear(&s);
}

/* Each of these holds one segment; the name says which. */
TEST(atoms)
{
    Survey s = shared_file("Clothoid_100.0_-300_-1000_1_Meter.ifc");
    check_close(s.alignment[0].plan[0].k0, -1.0 / 300, 1e-15);
    check_close(s.alignment[0].plan[0].k1, -1e-3, 1e-15);
    check_close(s.alignment[0].plan[0].length, 100, 0);
    survey_clear(&s);
    s = shared_file("CircularArc_100.0_10.0_0.0_0.5_1_Meter.ifc");
    const double radius = 100 / (0.5 / sqrt(1.25));
    check_close(alignment_at(&s.alignment[0], 100).at.z, 10 + radius * (1 - 1 / sqrt(1.25)), 1e-9);
    survey_clear(&s);
    s = shared_file("ParabolicArc_100.0_10.0_-0.5_0.0_1_Meter.ifc");
    check_close(alignment_at(&s.alignment[0], 100).at.z, 10 - 25, 1e-9);
    survey_clear(&s);
    s = shared_file("ConstantGradient_100.0_10.0_0.5_1.0_1_Meter.ifc");
    check_close(alignment_at(&s.alignment[0], 100).at.z, 60, 1e-9);
    survey_clear(&s);
}

/* A file's text with every `from` made `to`, of the same length. */
static char *changed(const char *name, const char *from, const char *to)
{
    char path[1024];
    const char *const folder = getenv("HAWSER_ROUTES");
    snprintf(path, sizeof path, "%s/%s", folder ? folder : HAWSER_SOURCE_DIR "/../shared/routes", name);
    FILE *const f = fopen(path, "rb");
    char *const text = calloc(1, 1 << 20);
    assert_non_null(text);
    assert_non_null(f);
    assert_true(fread(text, 1, (1 << 20) - 1, f) > 0);
    fclose(f);
    for (char *c = text; (c = strstr(c, from)); c += strlen(from)) memcpy(c, to, strlen(to));
    return text;
}

/* Without its nesting an alignment is taken from its curves: the same line. */
static void drawn(const char *name)
{
    Survey s = shared_file(name), curves;
    char *const text = changed(name, "IFCRELNESTS", "IFCRELNONE_");
    assert_string_equal(read_text(text, &curves), "");
    const Alignment *const a = &s.alignment[0], *const b = &curves.alignment[0];
    const double length = alignment_measure(a).plan_length;
    assert_int_equal(a->n_plan, b->n_plan);
    assert_int_equal(a->n_profile, b->n_profile);
    check_close(alignment_measure(b).plan_length, length, 1e-6);
    for (double at = 0; at < length; at += 1) check_vec(alignment_at(a, at).at, alignment_at(b, at).at, 1e-5);
    survey_clear(&s);
    survey_clear(&curves);
    free(text);
}

TEST(by_curves)
{
    drawn("tunnel-alignment.ifc");
    drawn("stn01-quadri.ifc");
}

/* Millimetres, degrees, a placement that is turned and moved, comments, a text with quotes. */
TEST(units_and_placement)
{
    Survey s;
    const char *const text = IFC(
        "IFC4X3",
        "#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);/* a comment; with a semicolon */\n"
        "#2=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);\n#3=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.017453292519943295)"
        ",#2);\n"
        "#4=IFCCONVERSIONBASEDUNIT(*,.PLANEANGLEUNIT.,'DEGREE',#3);\n#5=IFCUNITASSIGNMENT((#1,#4));\n"
        "#10=IFCALIGNMENT('a',$,'it''s (1;2)',$,$,#20,$,$);\n#11=IFCALIGNMENTHORIZONTAL('b',$,$,$,$,$,$);\n"
        "#12=IFCALIGNMENTVERTICAL('b',$,$,$,$,$,$);\n#13=IFCALIGNMENTSEGMENT('c',$,$,$,$,$,$,#14);\n"
        "#14=IFCALIGNMENTHORIZONTALSEGMENT($,$,#15,90.,0.,0.,5000.,$,.LINE.);\n#15=IFCCARTESIANPOINT((1000.,2000.));\n"
        "#16=IFCALIGNMENTVERTICALSEGMENT($,$,0.,5000.,1000.,0.1,$,$,.CONSTANTGRADIENT.);\n"
        "#17=IFCRELNESTS('d',$,$,$,#10,(#11,#12));\n#18=IFCRELNESTS('e',$,$,$,#11,(#13));\n#19=IFCRELNESTS('f',$,$,$,#"
        "12,(#16));\n"
        "#20=IFCLOCALPLACEMENT(#24,#21);\n#21=IFCAXIS2PLACEMENT3D(#22,$,#23);\n#22=IFCCARTESIANPOINT((0.,0.,500.));\n"
        "#23=IFCDIRECTION((0.,1.,0.));\n#24=IFCLOCALPLACEMENT($,#25);\n#25=IFCAXIS2PLACEMENT3D(#26,$,$);\n"
        "#26=IFCCARTESIANPOINT((10000.,0.,0.));\n");
    assert_string_equal(read_text(text, &s), "");
    const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
    check_vec(m.start, v3(8, 1, 1.5), 1e-12);
    check_vec(m.end, v3(3, 1, 2), 1e-12);
    assert_string_equal(s.alignment[0].name, "it's (1;2)");
    survey_clear(&s);
}

/* An alignment in plan alone lies at the height of its placements. */
TEST(level_at_its_placement)
{
    Survey s;
    const char *const text = IFC(
        "IFC4X3", "#1=IFCALIGNMENT('a',$,'a',$,$,#20,$,$);\n#2=IFCALIGNMENTHORIZONTAL('b',$,$,$,$,$,$);\n"
                  "#3=IFCALIGNMENTSEGMENT('c',$,$,$,$,$,$,#4);\n"
                  "#4=IFCALIGNMENTHORIZONTALSEGMENT($,$,#5,0.,0.,0.,50.,$,.LINE.);\n#5=IFCCARTESIANPOINT((1.,2.));\n"
                  "#6=IFCRELNESTS('d',$,$,$,#1,(#2));\n#7=IFCRELNESTS('e',$,$,$,#2,(#3));\n"
                  "#20=IFCLOCALPLACEMENT(#23,#21);\n#21=IFCAXIS2PLACEMENT3D(#22,$,$);\n"
                  "#22=IFCCARTESIANPOINT((0.,0.,12.5));\n#23=IFCLOCALPLACEMENT($,#24);\n"
                  "#24=IFCAXIS2PLACEMENT3D(#25,$,$);\n#25=IFCCARTESIANPOINT((0.,0.,100.));\n");
    assert_string_equal(read_text(text, &s), "");
    const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
    check_vec(m.start, v3(1, 2, 112.5), 1e-12);
    check_vec(m.end, v3(51, 2, 112.5), 1e-12);
    check_close(m.length, 50, 1e-12);
    survey_clear(&s);
}

/* 4x1's curves: an arc to the right, a transition, a crest. And a polyline in space. */
TEST(older_schema_and_polyline)
{
    Survey s;
    const char *const text =
        IFC("IFC4X1",
            "#1=IFCALIGNMENT('a',$,'old',$,$,$,$,#2,$);\n#2=IFCALIGNMENTCURVE(#3,#4,$);\n#3=IFCALIGNMENT2DHORIZONTAL(0."
            ",(#5,#6));\n"
            "#4=IFCALIGNMENT2DVERTICAL((#7,#8));\n#5=IFCALIGNMENT2DHORIZONTALSEGMENT(.T.,$,$,#9);\n"
            "#6=IFCALIGNMENT2DHORIZONTALSEGMENT(.T.,$,$,#10);\n#7=IFCALIGNMENT2DVERSEGLINE(.T.,$,$,0.,10.,2.,0.1);\n"
            "#8=IFCALIGNMENT2DVERSEGPARABOLICARC(.T.,$,$,10.,20.,3.,0.1,200.,.T.);\n#9=IFCCIRCULARARCSEGMENT2D(#11,0.,"
            "10.,50.,.F.);\n"
            "#10=IFCTRANSITIONCURVESEGMENT2D(#12,-0.2,20.,50.,$,.F.,.F.,.CLOTHOIDCURVE.);\n#11=IFCCARTESIANPOINT((0.,0."
            "));\n"
            "#12=IFCCARTESIANPOINT((9.93346653975,-0.99667110794));\n"
            "#20=IFCALIGNMENT('b',$,'line',$,$,$,#21,$,$);\n#21=IFCPRODUCTDEFINITIONSHAPE($,$,(#22));\n"
            "#22=IFCSHAPEREPRESENTATION($,'Axis','Curve3D',(#23));\n#23=IFCPOLYLINE((#24,#25,#26));\n#24="
            "IFCCARTESIANPOINT((0.,0.,0.));\n"
            "#25=IFCCARTESIANPOINT((3.,0.,4.));\n#26=IFCCARTESIANPOINT((3.,12.,9.));\n"
            "#30=IFCALIGNMENT('c',$,'indexed',$,$,$,#31,$,$);\n#31=IFCPRODUCTDEFINITIONSHAPE($,$,(#32));\n"
            "#32=IFCSHAPEREPRESENTATION($,'Axis','Curve3D',(#33));\n#33=IFCINDEXEDPOLYCURVE(#34,(IFCLINEINDEX((1,2)),"
            "IFCLINEINDEX((2,3))),$);\n"
            "#34=IFCCARTESIANPOINTLIST3D(((0.,0.,0.),(1.,0.,0.),(1.,2.,2.)));\n");
    assert_string_equal(read_text(text, &s), "");
    const Alignment *const old = named(&s, "old");
    check_close(old->plan[0].k0, -0.02, 1e-15);
    check_close(old->plan[1].k1, 0, 0);
    check_below(alignment_measure(old).gap, 1e-9);
    check_close(old->profile[1].bend, -0.005, 1e-15);
    check_close(alignment_measure(named(&s, "line")).length, 18, 1e-12);
    check_close(alignment_measure(named(&s, "indexed")).length, 1 + sqrt(8), 1e-12);
    survey_clear(&s);
}

#define DRAWN(body)                                                                                                    \
    "#1=IFCALIGNMENT('a',$,'S\\X2\\00FC\\X0\\d \\X\\E9\\S\\i',$,$,$,#2,$);\n#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));\n" \
    "#3=IFCSHAPEREPRESENTATION($,'Axis','Curve3D',(#4));\n" body

/* Arcs by three points, level and in space; corners in another order than the list's; lengths as parameters; a clothoid
 * that is run through against its parent; cant over a curve; units of units; names with escapes. */
TEST(curves_of_other_kinds)
{
    Survey s;
    const double pi = acos(-1);
    assert_string_equal(
        read_text(
            IFC("IFC4X3", DRAWN("#4=IFCINDEXEDPOLYCURVE(#5,(IFCLINEINDEX((4,1)),IFCARCINDEX((1,2,3))),$);\n"
                                "#5=IFCCARTESIANPOINTLIST3D(((10.,0.,5.),(13.,1.,5.),(15.,5.,5.),(0.,0.,5.)));\n")),
            &s),
        "");
    assert_string_equal(s.alignment[0].name, "S\xC3\xBC"
                                             "d \xC3\xA9\xC3\xA9");
    assert_int_equal(s.alignment[0].n_plan, 2);
    check_close(alignment_measure(&s.alignment[0]).length, 10 + 2.5 * pi, 1e-9);
    check_close(s.alignment[0].plan[1].k0, 0.2, 1e-12);
    check_vec(alignment_measure(&s.alignment[0]).end, v3(15, 5, 5), 1e-9);
    survey_clear(&s);
    /* three quarters of an upright circle, clockwise in plan's words: chords */
    assert_string_equal(
        read_text(IFC("IFC4X3", DRAWN("#4=IFCINDEXEDPOLYCURVE(#5,(IFCARCINDEX((1,2,3))),$);\n"
                                      "#5=IFCCARTESIANPOINTLIST3D(((10.,0.,0.),(-10.,0.,0.),(0.,0.,-10.)));\n")),
                  &s),
        "");
    check_close(alignment_measure(&s.alignment[0]).length, 15 * pi, 5e-3);
    check_vec(alignment_measure(&s.alignment[0]).end, v3(0, 0, -10), 1e-9);
    survey_clear(&s);
    assert_string_equal(
        read_text(IFC("IFC4X3",
                      "#90=IFCUNITASSIGNMENT((#91));\n#91=IFCCONVERSIONBASEDUNIT(*,.LENGTHUNIT.,'FOOT',#92);\n"
                      "#92=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(12.),#93);\n"
                      "#93=IFCCONVERSIONBASEDUNIT(*,.LENGTHUNIT.,'INCH',#94);\n"
                      "#94=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(2.54),#95);\n"
                      "#95=IFCSIUNIT(*,.LENGTHUNIT.,.CENTI.,.METRE.);\n" DRAWN(
                          "#4=IFCSEGMENTEDREFERENCECURVE((),.F.,#6,$);\n#6=IFCCOMPOSITECURVE((#10,#20),.F.);\n"
                          "#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,IFCPARAMETERVALUE(0.),IFCPARAMETERVALUE(4.),#13);\n"
                          "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n#13=IFCLINE(#12,#14);\n"
                          "#14=IFCVECTOR(#15,25.);\n#15=IFCDIRECTION((1.,0.));\n"
                          "#20=IFCCURVESEGMENT(.CONTINUOUS.,#21,IFCLENGTHMEASURE(80.),IFCLENGTHMEASURE(-80.),#23);\n"
                          "#21=IFCAXIS2PLACEMENT2D(#22,#15);\n#22=IFCCARTESIANPOINT((100.,0.));\n"
                          "#23=IFCCLOTHOID(#21,200.);\n")),
                  &s),
        "");
    const Alignment *const a = &s.alignment[0];
    check_close(a->plan[0].length, 100 * 0.3048, 1e-12);
    check_close(a->plan[1].length, 80 * 0.3048, 1e-12);
    check_close(a->plan[1].k0, -80 / (200.0 * 200) / 0.3048, 1e-15); /* backward: to the right, straightening */
    check_close(a->plan[1].k1, 0, 1e-15);
    check_below(alignment_measure(a).gap, 1e-9);
    check_has(s.ignored[0].what, "cant");
    survey_clear(&s);
    /* the project's units count, not the first in the file */
    assert_string_equal(
        read_text(IFC("IFC4X3", "#80=IFCUNITASSIGNMENT((#81));\n#81=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n"
                                "#82=IFCPROJECT('p',$,$,$,$,$,$,$,#83);\n#83=IFCUNITASSIGNMENT((#84));\n"
                                "#84=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);\n" DRAWN(
                                    "#4=IFCPOLYLINE((#5,#6));\n#5=IFCCARTESIANPOINT((0.,0.));\n"
                                    "#6=IFCCARTESIANPOINT((3000.,4000.));\n")),
                  &s),
        "");
    check_close(alignment_measure(&s.alignment[0]).length, 5, 1e-12);
    assert_true(s.alignment[0].flat); /* its points have no heights: a case may give one */
    survey_clear(&s);
    bad(IFC("IFC4X3", DRAWN("#4=IFCINDEXEDPOLYCURVE(#5,(IFCARCINDEX((1,2,9))),$);\n"
                            "#5=IFCCARTESIANPOINTLIST2D(((1.,0.),(2.,0.),(3.,3.)));\n")),
        "a point that is not in its list");
    bad(IFC("IFC4X3",
            DRAWN(
                "#4=IFCCOMPOSITECURVE((#10),.F.);\n#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,$,$,#13);\n"
                "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n#13=IFCBSPLINECURVE(#11,1.,$);\n")),
        "on an IFCBSPLINECURVE, which is not read");
    bad(IFC("IFC4X3",
            DRAWN(
                "#4=IFCCOMPOSITECURVE((#10),.F.);\n#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,$,$,#13);\n"
                "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n#13=IFCCOSINESPIRAL(#11,1.,$);\n")),
        "a transition without start, length or radius");
}

/* Curves of a higher degree than what they would be read as are refused; those of a lower one are what they are. */
TEST(polynomials)
{
    static const char *const plan =
        "#4=IFCCOMPOSITECURVE((#10),.F.);\n"
        "#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,IFCLENGTHMEASURE(0.),IFCLENGTHMEASURE(20.),#13);\n"
        "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n"
        "#13=IFCPOLYNOMIALCURVE(#11,(0.,1.),%s,$);\n";
    static const char *const profile =
        "#4=IFCGRADIENTCURVE((#10),.F.,#20,$);\n#20=IFCPOLYLINE((#12,#21));\n#21=IFCCARTESIANPOINT((20.,0.));\n"
        "#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,IFCLENGTHMEASURE(0.),IFCLENGTHMEASURE(20.),#13);\n"
        "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n#13=IFCPOLYNOMIALCURVE(#11,(0.,2.),%s,$);\n";
    static const struct {
        const char *y;
        int in_profile;
        const char *why;
    } cases[] = {{"(0.,0.)", 0, ""},
                 {"(0.,0.,0.,0.001)", 0, "#10: a segment on an IFCPOLYNOMIALCURVE of degree 3, which is not read"},
                 {"(0.,0.,0.01)", 0, "of degree 2, which is not read: expected straights, circles"},
                 {"(0.,0.,0.04,0.)", 1, ""},
                 {"(0.,0.,0.04,0.001)", 1, "of degree 3, which is not read: expected y of degree 2 at most over x"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[2000], body[1000];
        Survey s;
        snprintf(body, sizeof body, cases[i].in_profile ? profile : plan, cases[i].y);
        snprintf(text, sizeof text, IFC("IFC4X3", DRAWN("%s")), body);
        const char *const why = read_text(text, &s);
        if (*cases[i].why) check_has(why, cases[i].why);
        if (*cases[i].why) continue;
        assert_string_equal(why, "");
        if (cases[i].in_profile) check_close(alignment_at(&s.alignment[0], 10).at.z, 1, 1e-12);
        survey_clear(&s);
    }
}

/* The share of the change of curvature that a transition has made at x of its length. */
static double share(int kind, double x)
{
    const double pi = acos(-1);
    switch (kind) {
    case 0:
        return 3 * x * x - 2 * x * x * x;
    case 1:
        return (1 - cos(pi * x)) / 2;
    case 2:
        return x - sin(2 * pi * x) / (2 * pi);
    case 3:
        return x < 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x);
    default:
        return x * x * x * x * (35 + x * (-84 + x * (70 - 20 * x)));
    }
}

/* 100 m from a straight to 300 m of radius: by what a segment means (AL9), against the midpoint rule, and against the
 * ends that buildingSMART's programs have. As clothoids they ended 0.4 to 0.8 m off. */
TEST(transitions)
{
    static const char *const type[] = {"BLOSSCURVE", "COSINECURVE", "SINECURVE", "HELMERTCURVE", "VIENNESEBEND"};
    static const double known[][2] = {{99.7468064174602, 4.98981104238495},
                                      {99.7484553576535, 4.94582068772138},
                                      {99.7569805099502, 4.70132070046201},
                                      {99.7517634462449, 4.8510605228736}};
    const double length = 100, k = 1 / 300.0;
    enum { STEPS = 20000 };
    for (int kind = 0; kind < 5; ++kind) {
        char text[2000];
        Survey s;
        snprintf(text, sizeof text,
                 IFC("IFC4X3", "#1=IFCALIGNMENT('1',$,'al',$,$,$,$,$);\n#2=IFCALIGNMENTHORIZONTAL('2',$,$,$,$,$,$);\n"
                               "#3=IFCRELNESTS($,$,$,$,#1,(#2));\n#4=IFCRELNESTS($,$,$,$,#2,(#5));\n"
                               "#5=IFCALIGNMENTHORIZONTALSEGMENT($,$,#6,0.,0.,300.,100.,$,.%s.);\n"
                               "#6=IFCCARTESIANPOINT((0.,0.));\n"),
                 type[kind]);
        assert_string_equal(read_text(text, &s), "");
        assert_int_equal(s.n_ignored, 0);
        double x = 0, y = 0, heading = 0, most = 0;
        for (int i = 0; i < STEPS; ++i) {
            const double h = length / STEPS, half = heading + 0.5 * h * k * share(kind, (i + 0.25) / STEPS);
            x += h * cos(half);
            y += h * sin(half);
            heading += h * k * share(kind, (i + 0.5) / STEPS);
            if (i % 100 != 99) continue;
            const AlignmentPlace at = alignment_at(&s.alignment[0], (i + 1) * h);
            most = larger_of(most, hypot(at.at.x - x, at.at.y - y));
        }
        check_below(most, 1.2e-5);
        check_close(alignment_measure(&s.alignment[0]).length, length, 1e-9);
        check_close(s.alignment[0].plan[s.alignment[0].n_plan - 1].k1, k, 0.02 * k);
        if (kind < 4) check_below(hypot(x - known[kind][0], y - known[kind][1]), 1e-7); /* else without cant */
        survey_clear(&s);
    }
}

/* A spiral's terms and where on it the segment lies; a parabola whose length is a parameter, which is no length along
 * it: it was 93.9 m long in plan, and is 100 m. */
TEST(curves_by_parameter)
{
    Survey s;
    assert_string_equal(
        read_text(
            IFC("IFC4X3",
                DRAWN("#4=IFCGRADIENTCURVE((#20),.F.,#5,$);\n#5=IFCCOMPOSITECURVE((#10,#15),.F.);\n"
                      "#10=IFCCURVESEGMENT(.CONTINUOUS.,#11,IFCPARAMETERVALUE(0.),IFCLENGTHMEASURE(50.),#13);\n"
                      "#11=IFCAXIS2PLACEMENT2D(#12,$);\n#12=IFCCARTESIANPOINT((0.,0.));\n"
                      "#13=IFCSECONDORDERPOLYNOMIALSPIRAL($,128.92319893893,$,1000.);\n"
                      "#15=IFCCURVESEGMENT(.CONTINUOUS.,#16,IFCPARAMETERVALUE(50.),IFCLENGTHMEASURE(50.),#18);\n"
                      "#16=IFCAXIS2PLACEMENT2D(#17,#19);\n#17=IFCCARTESIANPOINT((49.9681012468824,1.49252747074135));\n"
                      "#18=IFCSECONDORDERPOLYNOMIALSPIRAL($,-128.92319893893,103.509833901353,-750.);\n"
                      "#19=IFCDIRECTION((0.9975896963,0.0693886305));\n"
                      "#20=IFCCURVESEGMENT(.CONTINUOUS.,#21,IFCPARAMETERVALUE(0.),IFCPARAMETERVALUE(100.),#23);\n"
                      "#21=IFCAXIS2PLACEMENT2D(#22,#24);\n#22=IFCCARTESIANPOINT((0.,10.));\n"
                      "#23=IFCPOLYNOMIALCURVE($,(0.,1.),(10.,-0.5,0.0025),$);\n#24=IFCDIRECTION((1.,-0.5));\n")),
            &s),
        "");
    check_vec(alignment_at(&s.alignment[0], 50 - 1e-9).at, v3(49.9681012468824, 1.49252747074135, -8.75), 1e-6);
    check_vec(alignment_measure(&s.alignment[0]).end, v3(99.4454089089293, 8.37378888968841, -15), 2e-5);
    check_close(s.alignment[0].profile[0].length, 100, 1e-9);
    survey_clear(&s);
}

/* The kind of a segment is its own word, not what comes behind it; an arc has one radius. */
TEST(kinds_of_segments)
{
    static const char *const file =
        IFC("IFC4X3", "#1=IFCALIGNMENT('1',$,'al',$,$,$,$,$);\n#2=IFCALIGNMENTHORIZONTAL('2',$,$,$,$,$,$);\n"
                      "#3=IFCRELNESTS($,$,$,$,#1,(#2));\n#4=IFCRELNESTS($,$,$,$,#2,(#5));\n"
                      "#5=IFCALIGNMENTHORIZONTALSEGMENT('CLOTHOID','CLOTHOID',#6,0.,%s,30.,20.,$,.%s.,'CLOTHOID');\n"
                      "#6=IFCCARTESIANPOINT((0.,0.));\n");
    char text[2000];
    Survey s;
    snprintf(text, sizeof text, file, "0.", "CUBIC");
    assert_string_equal(read_text(text, &s), "");
    assert_int_equal(s.n_ignored, 1);
    check_has(s.ignored[0].what, "transition of type CUBIC: taken as a clothoid, some 0.04 m beside it");
    survey_clear(&s);
    snprintf(text, sizeof text, file, "0.", "CLOTHOID");
    assert_string_equal(read_text(text, &s), "");
    assert_int_equal(s.n_ignored, 0);
    survey_clear(&s);
    snprintf(text, sizeof text, file, "0.", "CIRCULARARC");
    bad(text, "alignment 'al', #5: a CIRCULARARC with radii of 0 and 30: expected the same at both ends");
}

#define PARENT(placement)                                                                                              \
    "#8=IFCALIGNMENT('1',$,'al',$,$," placement ",$,$);\n#9=IFCALIGNMENTHORIZONTAL('2',$,$,$,$,$,$);\n"                \
    "#10=IFCALIGNMENTVERTICAL('3',$,$,$,$,$,$);\n#12=IFCRELNESTS('4',$,$,$,#8,(#9));\n"                                \
    "#13=IFCALIGNMENT('c1',$,'child',$,$,$,$,$);\n#14=IFCRELAGGREGATES('a1',$,$,$,#8,(#13));\n"                        \
    "#100=IFCCARTESIANPOINT((0.,0.));\n"                                                                               \
    "#101=IFCALIGNMENTHORIZONTALSEGMENT($,$,#100,0.,0.,0.,100.,$,.LINE.);\n"                                           \
    "#20=IFCRELNESTS('5',$,$,$,#9,(#101));\n"                                                                          \
    "#103=IFCALIGNMENTVERTICALSEGMENT($,$,0.,100.,10.,0.2,0.2,$,.CONSTANTGRADIENT.);\n"                                \
    "#21=IFCRELNESTS('6',$,$,$,#10,(#103));\n"

/* A vertical layout in a child of the alignment that has the plan: the child is a line with both, where its parent is
 * placed; one with a plan of its own is a line beside its parent. */
TEST(child_alignments)
{
    Survey s;
    static const char placed[] =
        IFC("IFC4X3", PARENT("#30") "#15=IFCRELNESTS('n1',$,$,$,#13,(#10));\n#30=IFCLOCALPLACEMENT($,#31);\n"
                                    "#31=IFCAXIS2PLACEMENT3D(#32,$,$);\n#32=IFCCARTESIANPOINT((1000.,2000.,50.));\n");
    assert_string_equal(read_text(IFC("IFC4X3", PARENT("$") "#15=IFCRELNESTS('n1',$,$,$,#13,(#10));\n"), &s), "");
    assert_int_equal(s.n, 1);
    assert_string_equal(s.alignment[0].name, "child");
    check_vec(alignment_measure(&s.alignment[0]).end, v3(100, 0, 30), 1e-9);
    assert_int_equal(s.n_ignored, 1);
    check_has(s.ignored[0].what, "an alignment without heights");
    survey_clear(&s);
    assert_string_equal(read_text(placed, &s), "");
    check_vec(alignment_measure(&s.alignment[0]).end, v3(1100, 2000, 80), 1e-9);
    survey_clear(&s);
    static const char branch[] = IFC(
        "IFC4X3", PARENT("$") "#15=IFCRELNESTS('n1',$,$,$,#13,(#10,#16));\n"
                              "#16=IFCALIGNMENTHORIZONTAL('h2',$,$,$,$,$,$);\n#22=IFCRELNESTS('7',$,$,$,#16,(#104));\n"
                              "#104=IFCALIGNMENTHORIZONTALSEGMENT($,$,#100,0.5,0.,0.,60.,$,.LINE.);\n");
    assert_string_equal(read_text(branch, &s), "");
    assert_int_equal(s.n, 2);
    survey_clear(&s);
}

TEST(what_is_wrong)
{
    bad("ISO-10303-21;\nHEADER;", "no section DATA");
    bad(IFC("AP242", ""), "expected IFC");
    bad(IFC("IFC4X3", ""), "no IfcAlignment");
    bad(IFC("IFC4X3", "#1=IFCALIGNMENT('a'"), "7: expected an entity or ENDSEC;");
    bad(IFC("IFC4X3", "#1=IFCALIGNMENT('a',$,'x',$,$,#9,$,$);\n"), "#9 is not in the file");
    bad(IFC("IFC4X3", "#1=IFCALIGNMENT((((1,2;\n"), "#1: expected , or )");
    bad(IFC("IFC4X3",
            "#1=IFCALIGNMENT($,$,$,$,$,#2,$,$);\n#2=IFCLOCALPLACEMENT(#2,#3);\n#3=IFCAXIS2PLACEMENT3D(#4,$,$);\n"
            "#4=IFCCARTESIANPOINT((0.,0.,0.));\n"),
        "an endless chain of placements");
    bad(IFC("IFC4X3", "#1=IFCALIGNMENT($,$,$,$,$,$,#2,$);\n#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));\n"
                      "#3=IFCSHAPEREPRESENTATION($,$,$,(#4));\n#4=IFCGRADIENTCURVE((),.F.,#4,$);\n"),
        "an endless chain of base curves");
    bad(IFC("IFC4X3", "#1=IFCALIGNMENT($,$,$,$,$,$,$,$);\n#2=IFCALIGNMENTHORIZONTAL($,$,$,$,$,$,$);\n#3=IFCRELNESTS($,$"
                      ",$,$,#1,(#2));\n"
                      "#4=IFCALIGNMENTHORIZONTALSEGMENT($,$,#5,$,0.,0.,5.,$,.LINE.);\n#5=IFCCARTESIANPOINT((0.,0.));\n#"
                      "6=IFCRELNESTS($,$,$,$,#2,(#4));\n"),
        "without point, direction");
}
