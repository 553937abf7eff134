/* DXF: entities in level and tilted systems, text and binary, marks, units; the real drawing; what is wrong. */
#include "tests/survey/survey_fixture.h"

#include <endian.h>

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

TEST(lines_and_arcs)
{
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

TEST(polylines)
{
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
TEST(splines)
{
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

#define BLOCK(name, text) "0\nBLOCK\n8\n0\n2\n" name "\n70\n0\n10\n1\n20\n0\n30\n0\n" text "0\nENDBLK\n"
#define UNIT_LINE         "0\nLINE\n8\n0\n10\n1\n20\n0\n11\n2\n21\n0\n"
#define BLOCKS(text)      "0\nSECTION\n2\nBLOCKS\n" text "0\nENDSEC\n"

/* A block's base is at (1, 0): its line runs from there by 1 along x. Lines of blocks were dropped, those of anonymous
 * ones without a note. */
TEST(insertions)
{
    static const struct {
        const char *insert;
        Vec3 start, end;
    } cases[] = {{"2\n*U1\n10\n5\n20\n6\n", {5, 6, 0}, {6, 6, 0}},
                 {"2\n*u1\n10\n5\n20\n6\n50\n90\n", {5, 6, 0}, {5, 7, 0}},
                 {"2\n*U1\n10\n5\n20\n6\n41\n3\n42\n3\n50\n180\n", {5, 6, 0}, {2, 6, 0}},
                 {"2\n*U1\n10\n5\n20\n6\n41\n-2\n42\n1\n", {5, 6, 0}, {3, 6, 0}},
                 {"2\n*U1\n10\n5\n20\n6\n30\n1\n230\n-1\n", {-5, 6, -1}, {-6, 6, -1}},
                 {"2\nOUTER\n10\n10\n20\n0\n50\n90\n", {10, 3, 0}, {8, 3, 0}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[2000];
        snprintf(text, sizeof text,
                 HEADER("6") BLOCKS(BLOCK("*U1", UNIT_LINE)
                                        BLOCK("OUTER", "0\nINSERT\n8\n0\n2\n*U1\n10\n4\n20\n0\n41\n2\n50\n90\n"))
                     ENTITIES("0\nINSERT\n8\nROUTE\n%s"),
                 cases[i].insert);
        Survey s = drawing(text);
        check_vec(alignment_measure(only(&s)).start, cases[i].start, 1e-12);
        check_vec(alignment_measure(only(&s)).end, cases[i].end, 1e-12);
        assert_string_equal(s.alignment[0].layer, "ROUTE"); /* layer 0 is the insertion's */
        assert_int_equal(s.n_marks, 1);
        survey_clear(&s);
    }
}

/* A mirrored arc turns to the other side; scaled unevenly it is part of an ellipse; rows and columns; a layer of its
 * own; an insertion that cannot be followed, an external drawing, a block within itself. */
TEST(insertions_of_other_kinds)
{
    static const char arc[] = "0\nARC\n8\nOWN\n10\n1\n20\n0\n40\n2\n50\n0\n51\n90\n";
    char text[2000];
    const char *const file = HEADER("6") BLOCKS(BLOCK("A", "%s")) ENTITIES("0\nINSERT\n8\nROUTE\n2\nA\n%s");
    snprintf(text, sizeof text, file, arc, "10\n0\n20\n0\n41\n-3\n42\n3\n");
    Survey s = drawing(text);
    check_close(only(&s)->plan[0].k0, -1 / 6.0, 1e-14);
    check_close(alignment_measure(only(&s)).length, 3 * acos(-1), 1e-12);
    check_vec(alignment_measure(only(&s)).start, v3(-6, 0, 0), 1e-12);
    check_vec(alignment_measure(only(&s)).end, v3(0, 6, 0), 1e-12);
    assert_string_equal(s.alignment[0].layer, "OWN");
    survey_clear(&s);
    snprintf(text, sizeof text, file, arc, "10\n0\n20\n0\n41\n2\n42\n1\n");
    s = drawing(text);
    assert_int_equal(s.alignment[0].bent, 1);
    for (int i = 0; i < only(&s)->n_points; ++i)
        check_close(hypot(s.alignment[0].point[i].x / 4, s.alignment[0].point[i].y / 2), 1, 1e-12);
    survey_clear(&s);
    snprintf(text, sizeof text, file, UNIT_LINE, "10\n0\n20\n0\n50\n90\n70\n2\n71\n3\n44\n5\n45\n7\n");
    s = drawing(text);
    assert_int_equal(s.n, 6);
    check_vec(alignment_measure(&s.alignment[5]).start, v3(-14, 5, 0), 1e-12);
    survey_clear(&s);
    snprintf(text, sizeof text, file, UNIT_LINE "0\nINSERT\n8\n0\n2\nA\n10\n9\n20\n0\n", "10\n0\n20\n0\n");
    s = drawing(text);
    assert_int_equal(s.n, 32);
    check_has(s.ignored[0].what, "more than 32 deep");
    survey_clear(&s);
    s = drawing("0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nX\n70\n4\n1\nsite.dwg\n0\nENDBLK\n0\nENDSEC\n" DXF(
        "6", "0\nINSERT\n8\nA\n2\nX\n10\n0\n20\n0\n0\nINSERT\n8\nA\n2\nGONE\n10\n0\n20\n0\n"));
    check_has(s.ignored[0].what, "external drawing 'site.dwg': bind it");
    check_has(s.ignored[1].what, "block 'GONE' that is not in the drawing");
    survey_clear(&s);
}

#define LINE_9 "0\nLINE\n8\nC\n10\n0\n20\n0\n11\n9\n21\n0\n"

/* What is beside the line and cannot be read does not refuse the drawing, but is noted with its place: each of these
 * did. */
TEST(bad_entities)
{
    static const struct {
        const char *text, *note;
    } cases[] = {{"0\nARC\n8\nC\n10\n0\n20\n0\n40\n0\n50\n0\n51\n90\n",
                  "layer 'C', line 16: an ARC without centre, radius above 0"},
                 {"0\nARC\n8\nD\n10\n0\n20\n0\n40\n-2\n50\n0\n51\n90\n", "layer 'D', line 16: an ARC without"},
                 {"0\nLINE\n8\nD\n10\n0\n20\n0\n11\n12,5\n21\n0\n", "group 11 of a LINE is no number"},
                 {"0\nSPLINE\n8\nD\n71\n3\n10\n0\n20\n0\n", "a SPLINE needs 4 control points"},
                 {"0\nPOLYLINE\n8\nD\n66\n1\n0\nVERTEX\n8\nD\n10\nx\n20\n0\n0\nVERTEX\n8\nD\n10\n1\n20\n0\n0\nSEQEND\n",
                  "group 10 of a POLYLINE is no number"},
                 {"0\nINSERT\n8\nD\n2\nB\n10\n0\n20\n0\n41\n0\n", "an INSERT with a scale of 0"},
                 {"0\nLINE\n8\nD\n10\n20\n0.5\n11\n1\n21\n0\n", "a line of a LINE is no group code"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[2000];
        snprintf(text, sizeof text, DXF("6", "%s" LINE_9), cases[i].text);
        Survey s = drawing(text);
        check_close(alignment_measure(only(&s)).length, 9, 1e-12);
        assert_int_equal(s.n_ignored, 1);
        check_has(s.ignored[0].what, cases[i].note);
        survey_clear(&s);
    }
}

/* Objects within texts (group 101), of which every number was read as the text's and none may be; texts with line
 * breaks, whose other lines may look like anything; a byte-order mark. */
TEST(texts)
{
    static const char embedded[] = "101\nEmbedded Object\n70\n1\n10\n1.0\n20\n0.0\n11\n5.0\n21\n5.0\n46\n0.0\n";
    static const char *const head[] = {
        "0\nMTEXT\n8\nT\n10\n5\n20\n5\n1\nJoint bay 3\n", "0\nATTDEF\n8\nT\n10\n5\n20\n5\n1\nbay\n2\nID\n",
        "0\nINSERT\n8\nT\n2\nB\n66\n1\n10\n5\n20\n5\n0\nATTRIB\n8\nT\n10\n7\n20\n7\n1\nbay\n2\nID\n"};
    static const char *const broken[] = {"with\nbreak\n",    "Pit\n3\n",     "a\n\nb\n",         "Pit\n0+050\n12\n",
                                         "1998\n12\n1998\n", "1\n2\n3\n4\n", "LINE\n0\nLINE x\n"};
    char text[2000];
    for (size_t i = 0; i < sizeof head / sizeof *head; ++i) {
        snprintf(text, sizeof text, DXF("6", "%s%s" LINE_9), head[i], embedded);
        Survey s = drawing(text);
        check_close(alignment_measure(only(&s)).length, 9, 1e-12);
        if (s.n_marks) check_vec(s.mark[0].at, v3(5, 5, 0), 0);
        if (s.n_marks) assert_string_equal(s.mark[0].name, "B: bay");
        survey_clear(&s);
    }
    for (size_t i = 0; i < sizeof broken / sizeof *broken; ++i) {
        snprintf(text, sizeof text, "\xEF\xBB\xBF" DXF("6", "0\nTEXT\n8\nT\n10\n0\n20\n0\n40\n2\n1\n%s" LINE_9),
                 broken[i]);
        Survey s = drawing(text);
        check_close(alignment_measure(named(&s, "C")).length, 9, 1e-12);
        survey_clear(&s);
    }
}

/* Half of a circle, and a quarter of an ellipse, by Ramanujan's formula for all of it; names by the code page. */
TEST(ellipses_and_pages)
{
    const double pi = acos(-1);
    Survey s = drawing(
        DXF("6", "0\nELLIPSE\n8\nE\n10\n0\n20\n0\n30\n0\n11\n3\n21\n0\n31\n0\n40\n1\n41\n0\n42\n3.141592653589793\n"));
    check_close(alignment_measure(only(&s)).length, 3 * pi, 1e-3);
    survey_clear(&s);
    s = drawing(DXF("6", "0\nELLIPSE\n8\nE\n10\n0\n20\n0\n11\n0\n21\n3\n40\n0.5\n41\n0\n42\n1.5707963267948966\n"));
    check_close(alignment_measure(only(&s)).length, pi * (13.5 - sqrt((9 + 1.5) * (3 + 4.5))) / 4, 1e-3);
    check_vec(alignment_measure(only(&s)).end, v3(-1.5, 0, 0), 1e-12);
    survey_clear(&s);
    s = drawing("0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\nANSI_1251\n0\nENDSEC\n" ENTITIES(
        "0\nLINE\n8\n\xD2\xF0\n10\n0\n20\n0\n11\n9\n21\n0\n"));
    assert_string_equal(only(&s)->layer, "\xD0\xA2\xD1\x80"); /* Tr in Cyrillic; Latin-1 before */
    survey_clear(&s);
}

/* Layers of old drawings are bytes of a code page; what blocks hold is not read, and said so. */
TEST(layers_and_blocks)
{
    Survey s = drawing(DXF("6", "0\nLINE\n8\nTRASSE_\xDC\n10\n0\n20\n0\n11\n9\n21\n0\n"));
    assert_string_equal(only(&s)->layer, "TRASSE_\xC3\x9C");
    survey_clear(&s);
    s = drawing("0\nSECTION\n2\nBLOCKS\n" BLOCK("*D1", UNIT_LINE)
                    BLOCK("AXIS", UNIT_LINE) "0\nENDSEC\n" DXF("6", "0\nPOINT\n8\nC\n10\n0\n20\n0\n"));
    assert_int_equal(s.n_ignored, 1); /* a dimension's block is no line of the drawing */
    assert_string_equal(s.ignored[0].what, "lines inside of blocks that are not inserted");
    assert_int_equal(s.ignored[0].times, 1);
    survey_clear(&s);
}

/* A sheet's frame is no line of the ground. */
TEST(paper_space)
{
    Survey s = drawing(DXF("6", "0\nLINE\n8\nC\n10\n0\n20\n0\n11\n9\n21\n0\n"
                                "0\nLINE\n8\nFRAME\n67\n1\n10\n0\n20\n0\n11\n420\n21\n0\n"));
    check_close(alignment_measure(only(&s)).length, 9, 1e-12);
    assert_int_equal(s.n_ignored, 1);
    check_has(s.ignored[0].what, "LINE in paper space");
    survey_clear(&s);
}

TEST(marks)
{
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
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits = htole64(bits);
    put_code(b, code);
    put(b, &bits, sizeof bits);
}

TEST(binary)
{
    for (int short_codes = 0; short_codes < 2; ++short_codes) {
        Bytes b = {.short_codes = short_codes};
        const uint16_t unit = htole16(4);
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
TEST(railway_sheet)
{
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
TEST(as_programs_write_them)
{
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
    assert_string_equal(s.ignored[0].what, "LINE that is invisible");
    survey_clear(&s);
}

TEST(what_is_wrong)
{
    bad("AC1032\x01\x02", "save it as DXF");
    bad("0\nSECTION\n", "no section in the drawing");
    bad("0\nSECTION\n2\nENTITIES\nx\n", "5: 'x' is no group code");
    bad("0\nSECTION\n2\nENTITIES\n0", "the file ends behind a group code");
    bad(DXF("6", "0\nLINE\n8\nA\n10\n1\n"), "a LINE without both of its ends");
    bad(DXF("6", "0\nLINE\n8\nA\n10\none\n"), "group 10 of a LINE is no number");
    bad(DXF("6", "0\nARC\n8\nA\n10\n1\n"), "an ARC without centre");
    bad(DXF("6", "0\nSPLINE\n8\nA\n71\n3\n10\n1\n"), "a SPLINE needs 4 control points");
}
