/* DXF: entities in level and tilted systems, text and binary, marks, units; the real drawing; what is wrong. */
#include "tests/survey/survey_fixture.h"

#define HEADER(unit)    "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n" unit "\n  0\nENDSEC\n"
#define ENTITIES(text)  "  0\nSECTION\n  2\nENTITIES\n" text "  0\nENDSEC\n  0\nEOF\n"
#define DXF(unit, text) HEADER(unit) ENTITIES(text)

static Survey drawing(const char *text)
{
    Survey s;
    assert_string_equal(read_text(text, &s), "");
    return s;
}

static const Alignment *only(const Survey *s)
{
    assert_int_equal(s->n, 1);
    return &s->alignment[0];
}

static void lines_and_arcs(void **state)
{
    (void)state;
    Survey s = drawing(DXF("4", "0\nLINE\n8\nA\n10\n1000\n20\n2000\n11\n4000\n21\n6000\n"));
    check_close(alignment_measure(only(&s)).length, 5, 1e-12);
    assert_string_equal(only(&s)->layer, "A");
    survey_clear(&s);
    s = drawing(DXF("6", "0\nLINE\n8\nA\n10\n0\n20\n0\n30\n0\n11\n3\n21\n0\n31\n4\n"));
    check_close(alignment_measure(only(&s)).length, 5, 1e-12);
    survey_clear(&s);
    /* from 350 to 80 degrees: a quarter of a turn to the left */
    s = drawing(DXF("6", "0\nARC\n8\nA\n10\n1\n20\n2\n40\n10\n50\n350\n51\n80\n"));
    const Alignment *a = only(&s);
    check_close(alignment_measure(a).length, 10 * acos(0), 1e-12);
    check_close(a->plan[0].k0, 0.1, 1e-14);
    check_vec(alignment_measure(a).end, v3(1 + 10 * cos(1.3962634015954636), 2 + 10 * sin(1.3962634015954636), 0),
              1e-12);
    survey_clear(&s);
    /* seen from below: mirrored, to the right */
    s = drawing(DXF("6", "0\nARC\n8\nA\n10\n1\n20\n2\n40\n10\n50\n0\n51\n90\n230\n-1\n"));
    a = only(&s);
    check_close(a->plan[0].k0, -0.1, 1e-14);
    check_vec(alignment_measure(a).start, v3(-11, 2, 0), 1e-12);
    check_vec(alignment_measure(a).end, v3(-1, 12, 0), 1e-12);
    survey_clear(&s);
    /* in an upright plane, its z-axis along y: points on the circle */
    s = drawing(DXF("6", "0\nARC\n8\nA\n10\n0\n20\n0\n40\n10\n50\n0\n51\n180\n210\n0\n220\n-1\n230\n0\n"));
    a = only(&s);
    assert_true(a->n_points > 50);
    for (int i = 0; i < a->n_points; ++i) check_close(hypot(a->point[i].x, a->point[i].z), 10, 1e-9);
    check_close(alignment_measure(a).length, 10 * acos(-1), 5e-3);
    survey_clear(&s);
}

static void polylines(void **state)
{
    (void)state;
    /* a straight, a half circle to the left, back; closed by an arc to the right; at 7 m */
    Survey s = drawing(
        DXF("6",
            "0\nLWPOLYLINE\n8\nB\n90\n3\n70\n1\n38\n7\n10\n0\n20\n0\n10\n10\n20\n0\n42\n1\n10\n10\n20\n4\n42\n-0.5\n"));
    const Alignment *a = only(&s);
    const double third = hypot(10, 4), radius = third * 1.25 / 2;
    assert_int_equal(a->n_plan, 3);
    check_close(a->plan[1].length, 2 * acos(-1), 1e-12);
    check_close(a->plan[1].k0, 0.5, 1e-14);
    check_close(a->plan[2].k0, -1 / radius, 1e-14);
    check_close(a->plan[2].length, 4 * atan(0.5) * radius, 1e-12);
    check_vec(alignment_measure(a).end, v3(0, 0, 7), 1e-12);
    check_below(alignment_measure(a).gap, 1e-12);
    survey_clear(&s);
    s = drawing(DXF("6", "0\nPOLYLINE\n8\nC\n66\n1\n70\n8\n0\nVERTEX\n8\nC\n10\n0\n20\n0\n30\n1\n70\n32\n0\nVERTEX\n8\n"
                         "C\n10\n2\n20\n3\n30\n7\n70\n32\n"
                         "0\nSEQEND\n8\nC\n0\nCIRCLE\n8\nC\n10\n0\n20\n0\n40\n1\n"));
    check_close(alignment_measure(only(&s)).length, 7, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    survey_clear(&s);
    s = drawing(DXF("6", "0\nPOLYLINE\n8\nC\n66\n1\n30\n2\n0\nVERTEX\n8\nC\n10\n0\n20\n0\n42\n1\n0\nVERTEX\n8\nC\n10\n2"
                         "\n20\n0\n0\nSEQEND\n"));
    check_close(alignment_measure(only(&s)).length, acos(-1), 1e-12);
    check_close(alignment_measure(only(&s)).start.z, 2, 0);
    survey_clear(&s);
}

/* A quarter of a circle as a rational spline of second degree; a cubic against its closed form. */
static void splines(void **state)
{
    (void)state;
    Survey s = drawing(DXF(
        "6", "0\nSPLINE\n8\nS\n70\n4\n71\n2\n72\n6\n73\n3\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n"
             "41\n1\n41\n0.70710678118654752\n41\n1\n10\n5\n20\n0\n30\n0\n10\n5\n20\n5\n30\n0\n10\n0\n20\n5\n30\n0\n"));
    const Alignment *const a = only(&s);
    for (int i = 0; i < a->n_points; ++i) check_close(hypot(a->point[i].x, a->point[i].y), 5, 1e-12);
    check_close(alignment_measure(a).length, 5 * acos(0), 3e-4); /* chords 0.2 mm off */
    survey_clear(&s);
    s = drawing(DXF("6", "0\nSPLINE\n8\nS\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0"
                         "\n30\n0\n10\n1\n20\n0\n30\n0\n"
                         "10\n2\n20\n0\n30\n0\n10\n3\n20\n3\n30\n6\n"));
    const int parts = only(&s)->n_points - 1;
    for (int i = 0; i <= parts; ++i) {
        const double u = (double)i / parts;
        check_vec(only(&s)->point[i], v3(3 * u, 3 * u * u * u, 6 * u * u * u), 1e-12);
    }
    survey_clear(&s);
    s = drawing(DXF("6", "0\nSPLINE\n8\nS\n71\n3\n11\n0\n21\n0\n31\n0\n11\n3\n21\n4\n31\n0\n"));
    check_close(alignment_measure(only(&s)).length, 5, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    check_has(s.ignored[0].what, "between its fit points");
    survey_clear(&s);
}

/* Layers of old drawings are bytes of a code page; what blocks hold is not read, and said so. */
static void layers_and_blocks(void **state)
{
    (void)state;
    Survey s = drawing(DXF("6", "0\nLINE\n8\nTRASSE_\xDC\n10\n0\n20\n0\n11\n9\n21\n0\n"));
    assert_string_equal(only(&s)->layer, "TRASSE_\xC3\x9C");
    survey_clear(&s);
    s = drawing("0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\n*D1\n0\nLINE\n8\n0\n0\nENDBLK\n0\nBLOCK\n2\nAXIS\n0\nLINE\n8\n0\n"
                "0\nENDBLK\n0\nENDSEC\n" DXF("6", "0\nLINE\n8\nC\n10\n0\n20\n0\n11\n9\n21\n0\n"));
    assert_int_equal(s.n_ignored, 1);
    assert_string_equal(s.ignored[0].what, "lines inside of blocks");
    assert_int_equal(s.ignored[0].times, 1);
    survey_clear(&s);
}

/* A sheet's frame is no line of the ground. */
static void paper_space(void **state)
{
    (void)state;
    Survey s = drawing(DXF("6", "0\nLINE\n8\nC\n10\n0\n20\n0\n11\n9\n21\n0\n"
                                "0\nLINE\n8\nFRAME\n67\n1\n10\n0\n20\n0\n11\n420\n21\n0\n"));
    check_close(alignment_measure(only(&s)).length, 9, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    check_has(s.ignored[0].what, "LINE in paper space");
    survey_clear(&s);
}

static void marks(void **state)
{
    (void)state;
    Survey s = drawing("999\na comment\n" DXF("2", "0\nINSERT\n8\nROLLERS\n66\n1\n2\nCORNER\n10\n10\n20\n20\n30\n5\n50"
                                                   "\n90\n0\nATTRIB\n8\n0\n10\n1\n20\n1\n1\nR12\n2\nID\n"
                                                   "0\nSEQEND\n0\nPOINT\n8\nPITS\n10\n1\n20\n2\n"));
    assert_int_equal(s.n, 0);
    assert_int_equal(s.n_marks, 2);
    assert_string_equal(s.mark[0].name, "CORNER: R12");
    assert_string_equal(s.mark[0].layer, "ROLLERS");
    check_vec(s.mark[0].at, v3(3.048, 6.096, 1.524), 1e-12);
    check_close(s.mark[0].heading, acos(0), 1e-12);
    assert_string_equal(s.mark[1].layer, "PITS");
    check_has(s.unit, "feet");
    survey_clear(&s);
}

/* ----------------------------------------------------------------------------------------------------------- binary */

typedef struct Bytes {
    char data[4096];
    size_t n;
    int short_codes;
} Bytes;

static void put(Bytes *b, const void *from, size_t n)
{
    memcpy(b->data + b->n, from, n);
    b->n += n;
}

static void put_code(Bytes *b, int code)
{
    const unsigned char low = (unsigned char)code, high = (unsigned char)(code >> 8);
    put(b, &low, 1);
    if (!b->short_codes) put(b, &high, 1);
}

static void put_text(Bytes *b, int code, const char *text)
{
    put_code(b, code);
    put(b, text, strlen(text) + 1);
}

static void put_number(Bytes *b, int code, double value)
{
    put_code(b, code);
    put(b, &value, sizeof value);
}

static void binary(void **state)
{
    (void)state;
    for (int short_codes = 0; short_codes < 2; ++short_codes) {
        Bytes b = {.short_codes = short_codes};
        const short unit = 4;
        put(&b, "AutoCAD Binary DXF\r\n\x1a", 22);
        put_text(&b, 0, "SECTION");
        put_text(&b, 2, "HEADER");
        put_text(&b, 9, "$INSUNITS");
        put_code(&b, 70);
        put(&b, &unit, 2);
        put_text(&b, 0, "ENDSEC");
        put_text(&b, 0, "SECTION");
        put_text(&b, 2, "ENTITIES");
        put_text(&b, 0, "LINE");
        put_text(&b, 8, "A");
        put_number(&b, 10, 0);
        put_number(&b, 20, 0);
        put_number(&b, 11, 3000);
        put_number(&b, 21, 4000);
        put_text(&b, 0, "ENDSEC");
        put_text(&b, 0, "EOF");
        char path[] = "/tmp/hawser-survey-XXXXXX";
        const int fd = mkstemp(path);
        assert_true(fd >= 0 && write(fd, b.data, b.n) == (long)b.n);
        close(fd);
        Survey s;
        hawser_error err;
        if (survey_read(path, &usual, &s, &err)) fail_msg("%s", err.message);
        check_close(alignment_measure(only(&s)).length, 5, 1e-12);
        survey_clear(&s);
        assert_int_equal(truncate(path, (off_t)b.n - 30), 0);
        assert_int_equal(survey_read(path, &usual, &s, &err), HAWSER_ERR_INPUT);
        check_has(err.message, "the file ends inside of group");
        unlink(path);
    }
}

/* ------------------------------------------------------------------------------------------------------------- real */

/* A sheet with a profile and a band of curvature at a tenth of the length: the straights and clothoids of the model. */
static void railway_sheet(void **state)
{
    (void)state;
    Survey s = shared_file("stn01-quadri.dxf"), ifc = shared_file("stn01-quadri.ifc");
    const Alignment *const line = &ifc.alignment[0];
    assert_int_equal(s.n, 110);
    for (int k = 0; k < 7; ++k) {
        double nearest = INFINITY;
        for (int i = 0; i < s.n; ++i) {
            const Vec3 start = alignment_measure(&s.alignment[i]).start, end = alignment_measure(&s.alignment[i]).end;
            nearest = fmin(nearest, fabs(fabs(end.x - start.x) - line->plan[k].length / 10));
        }
        check_below(nearest, 1e-4);
    }
    survey_clear(&s);
    survey_clear(&ifc);
}

/* Units beyond the usual ones, a full circle as an arc, entities that are not to be seen, names in an older drawing's
 * escapes; ezdxf reads the same of such files. */
static void as_programs_write_them(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double length;
        int ignored;
    } units[] = {{DXF("22", "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1000\n21\n0\n"), 1000 * 100 / 3937.0, 0},
                 {DXF("15", "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1000\n21\n0\n"), 1e4, 0},
                 {DXF("13", "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1e7\n21\n0\n"), 10, 0},
                 {DXF("17", "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1000\n21\n0\n"), 1000, 1}}; /* Gm: not believed, said */
    for (size_t i = 0; i < sizeof units / sizeof *units; ++i) {
        Survey s = drawing(units[i].text);
        check_close(alignment_measure(only(&s)).length, units[i].length, 1e-9);
        assert_int_equal(s.n_ignored, units[i].ignored);
        survey_clear(&s);
    }
    Survey s = drawing(DXF("6", "0\nARC\n8\nA\n10\n1\n20\n2\n40\n10\n50\n0\n51\n360\n"));
    check_close(alignment_measure(only(&s)).length, 20 * acos(-1), 1e-12);
    survey_clear(&s);
    s = drawing(DXF("6", "0\nLINE\n8\nS\\U+00FCd\\U+20AC\n10\n0\n20\n0\n11\n3\n21\n0\n"
                         "0\nLINE\n8\nA\n60\n1\n10\n3\n20\n0\n11\n9\n21\n0\n"));
    assert_string_equal(only(&s)->layer, "S\xC3\xBC"
                                         "d\xE2\x82\xAC");
    assert_string_equal(s.ignored[0].what, "LINE that is not to be seen");
    survey_clear(&s);
}

static void what_is_wrong(void **state)
{
    (void)state;
    bad("AC1032\x01\x02", "save it as DXF");
    bad("0\nSECTION\n", "no section in the drawing");
    bad("0\nSECTION\n2\nENTITIES\nx\n", "5: 'x' is no group code");
    bad("0\nSECTION\n2\nENTITIES\n0", "the file ends behind a group code");
    bad(DXF("6", "0\nLINE\n8\nA\n10\n1\n"), "a LINE without both of its ends");
    bad(DXF("6", "0\nLINE\n8\nA\n10\none\n"), "group 10 of a LINE is no number");
    bad(DXF("6", "0\nARC\n8\nA\n10\n1\n"), "an ARC without centre");
    bad(DXF("6", "0\nSPLINE\n8\nA\n71\n3\n10\n1\n"), "a SPLINE needs 4 control points");
}

TEST_FILE(test_dxf, cmocka_unit_test(lines_and_arcs), cmocka_unit_test(polylines), cmocka_unit_test(splines),
          cmocka_unit_test(paper_space), cmocka_unit_test(layers_and_blocks), cmocka_unit_test(marks),
          cmocka_unit_test(binary), cmocka_unit_test(railway_sheet), cmocka_unit_test(as_programs_write_them),
          cmocka_unit_test(what_is_wrong))
