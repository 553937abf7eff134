/* What the report is made of: texts that mean harm, tables that are read back, states in few bytes. */
#include "io/report/folder.h"
#include "io/report/report.h"
#include "io/report/svg.h"
#include "tests/support/check.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/* A text of every byte but NUL, and of what ends scripts, comments and lines. */
static const char *hostile(void)
{
    static char text[1024];
    size_t n = (size_t)snprintf(text, sizeof text, "</script><!--\"'&\\ \xe2\x80\xa8 \xe2\x80\xa9 \xe2\x80\xae ");
    for (int c = 1; c < 256; c++) text[n++] = (char)c;
    snprintf(text + n, sizeof text - n, "\xed\xa0\x80 \xf4\x90\x80\x80 \xc0\xaf \xe2\x82");
    return text;
}

TEST(json_keeps_words)
{
    Text t = {0};
    text_json(&t, "say \"A\\B\"\n\xc3\xa9 \xf0\x9f\x98\x80 </script>");
    json_t *const back = json_loads(t.at, JSON_DECODE_ANY, NULL);
    assert_string_equal(json_string_value(back), "say \"A\\B\"\n\xc3\xa9 \xf0\x9f\x98\x80 </script>");
    json_decref(back);
    assert_null(strpbrk(t.at, "<>&\n"));
    text_clear(&t);
}

/* Whatever the bytes, JSON comes out that can stand in a script element. */
TEST(json_tames_any_bytes)
{
    Text t = {0};
    text_json(&t, hostile());
    json_t *const back = json_loads(t.at, JSON_DECODE_ANY, NULL);
    assert_non_null(back);
    assert_null(strpbrk(t.at, "<>&\n\r"));
    assert_null(strstr(t.at, "\xe2\x80\xa8"));
    assert_null(strstr(t.at, "\xe2\x80\xa9"));
    assert_true(strncmp(json_string_value(back), "</script><!--\"'&\\ \xe2\x80\xa8 \xe2\x80\xa9", 25) == 0);
    json_decref(back);
    text_clear(&t);
}

TEST(whole_json_stays_the_same_value)
{
    static const char text[] = "{\"a\": \"<b> & \xe2\x80\xa8</script>\", \"n\": [1.25e-3, null]}";
    Text t = {0};
    text_json_whole(&t, text, sizeof text - 1);
    json_t *const before = json_loads(text, 0, NULL), *const after = json_loads(t.at, 0, NULL);
    assert_true(json_equal(before, after));
    assert_null(strpbrk(t.at, "<>&"));
    json_decref(before);
    json_decref(after);
    text_clear(&t);
}

TEST(html_is_escaped_and_cut)
{
    Text t = {0};
    text_html(&t, "<b onclick='x'>&\"", 100);
    assert_string_equal(t.at, "&#60;b onclick=&#39;x&#39;&#62;&#38;&#34;");
    text_clear(&t);
    text_html(&t, "\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9", 3);
    assert_string_equal(t.at, "\xc3\xa9\xc3\xa9\xc3\xa9\xe2\x80\xa6");
    text_clear(&t);
    text_html(&t, hostile(), 5000);
    assert_null(strpbrk(t.at, "<>\"'\n"));
    text_clear(&t);
}

/* RFC 4648, section 10. */
TEST(base64_is_the_standards)
{
    static const char *const pair[][2] = {
        {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
    for (size_t k = 0; k < sizeof pair / sizeof *pair; k++) {
        Text t = {0};
        text_base64(&t, (const unsigned char *)pair[k][0], strlen(pair[k][0]));
        assert_string_equal(t.at ? t.at : "", pair[k][1]);
        text_clear(&t);
    }
}

/* ---------------------------------------------------------------------------------------------------- packing */

static unsigned char *base64_back(const char *text, size_t *size)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned char *const bytes = malloc(strlen(text) + 3);
    uint32_t bits = 0;
    int held = 0;
    *size = 0;
    for (; *text && *text != '='; text++) {
        bits = bits << 6 | (uint32_t)(strchr(digit, *text) - digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes[(*size)++] = (unsigned char)(bits >> held);
    }
    return bytes;
}

/* The other way round as docs/formats.md describes it, written from there. */
static void unpack(int frames, int items, int components, const char *text, int32_t *q)
{
    const size_t row = (size_t)items * (size_t)components, n = (size_t)frames * row;
    size_t size;
    unsigned char *const stream = base64_back(text, &size), *const planes = malloc(4 * n + 1);
    uLongf got = 4 * n;
    assert_int_equal(uncompress(planes, &got, stream, size), Z_OK);
    assert_int_equal(got, 4 * n);
    for (int f = 0; f < frames; f++) {
        for (int i = 0; i < items; i++) {
            for (int c = 0; c < components; c++) {
                const size_t k = (size_t)f * row + (size_t)(i * components + c);
                uint32_t z = 0;
                for (int b = 3; b >= 0; b--) z = z << 8 | planes[(size_t)b * n + k];
                const uint32_t d = z >> 1 ^ (0U - (z & 1));
                const uint32_t behind = i ? (uint32_t)q[k - (size_t)components] : 0,
                               before = f ? (uint32_t)q[k - row] : 0;
                const uint32_t both = i && f ? (uint32_t)q[k - row - (size_t)components] : 0;
                q[k] = (int32_t)(d + behind + before - both);
            }
        }
    }
    free(stream);
    free(planes);
}

enum { F = 7, I = 11, C = 3, VALUES = F * I * C };

static void pack_and_compare(const float *value, double step)
{
    int32_t q[VALUES], back[VALUES];
    hawser_error err;
    Text t = {0};
    pack_quantize(F, I, C, step, value, q);
    assert_int_equal(pack_field(F, I, C, step, value, &t, &err), HAWSER_OK);
    unpack(F, I, C, t.at, back);
    for (int k = 0; k < VALUES; k++) assert_int_equal(back[k], q[k]);
    text_clear(&t);
}

TEST(packing_goes_both_ways)
{
    float value[VALUES];
    double worst = 0;
    int32_t q[VALUES];
    for (int k = 0; k < VALUES; k++) value[k] = (float)(12.5 * sin(0.37 * k) + 0.01 * k * k);
    pack_and_compare(value, 1e-3);
    pack_quantize(F, I, C, 1e-3, value, q);
    for (int k = 0; k < VALUES; k++) worst = larger_of(worst, fabs(1e-3 * q[k] - (double)value[k]));
    check_at_most(worst, 0.5e-3 + 1e-9);
}

/* Differences of the largest numbers leave 32 bits, and come back. */
TEST(packing_wraps_around)
{
    float value[VALUES];
    for (int k = 0; k < VALUES; k++) value[k] = (float)((k * 7919) % 3 - 1) * 3e9F;
    value[5] = NAN;
    value[6] = INFINITY;
    int32_t q[VALUES];
    pack_quantize(F, I, C, 1, value, q);
    assert_int_equal(q[5], 0);
    assert_int_equal(q[6], 0);
    assert_int_equal(q[0], -INT32_MAX);
    pack_and_compare(value, 1);
}

/* The order of the bytes, by hand: two frames of two items. */
TEST(planes_are_as_documented)
{
    const int32_t q[4] = {1, 3, 2, 260};
    unsigned char planes[16];
    pack_planes(2, 2, 1, q, planes);
    /* d: 1, 2, 1, 256; zigzag 2, 4, 2, 512 */
    static const unsigned char expected[16] = {2, 4, 2, 0, 0, 0, 0, 2};
    assert_memory_equal(planes, expected, 16);
}

/* ----------------------------------------------------------------------------------------------------- tables */

static Sheet sheet_of(const char *text)
{
    Sheet sheet;
    hawser_error err = {0};
    if (sheet_parse(strdup(text), "test.csv", &sheet, &err)) fail_msg("%s", err.message);
    return sheet;
}

TEST(tables_are_cut)
{
    Sheet s = sheet_of("name,\"x, m\",v\r\n\"say \"\"B\"\"\",1.5,\n'-5,'=1+1,x\nshort\n1,2,3,4,5\n\"two\nlines\",0,1");
    assert_int_equal(s.columns, 3);
    assert_int_equal(s.rows, 5);
    assert_string_equal(s.name[1], "x, m");
    assert_string_equal(sheet_cell(&s, 0, 0), "say \"B\"");
    assert_string_equal(sheet_cell(&s, 0, 2), "");
    assert_string_equal(sheet_cell(&s, 1, 0), "-5");
    assert_string_equal(sheet_cell(&s, 1, 1), "=1+1");
    assert_string_equal(sheet_cell(&s, 2, 1), "");
    assert_string_equal(sheet_cell(&s, 3, 2), "3");
    assert_string_equal(sheet_cell(&s, 4, 0), "two\nlines");
    check_close(sheet_number(&s, 0, 1), 1.5, 0);
    check_nan(sheet_number(&s, 1, 1));
    assert_int_equal(sheet_column(&s, "v"), 2);
    assert_int_equal(sheet_column(&s, "w"), -1);
    sheet_clear(&s);
    s = sheet_of("");
    assert_int_equal(s.columns, 0);
    sheet_clear(&s);
    hawser_error err;
    assert_int_equal(sheet_parse(strdup("a,b\n\"open,1\n"), "test.csv", &s, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "test.csv: a quote is not closed");
}

TEST(numbers_are_jsons)
{
    static const char *const good[] = {"0", "-0", "12.5", "1e5", "1.25E-07", "-3e+2"};
    static const char *const bad[] = {"",    "-",   ".5",    "5.",    "01", "+1", "1e",
                                      "nan", "inf", "1e999", "0x1p3", "1 ", "1,5"};
    for (size_t k = 0; k < sizeof good / sizeof *good; k++) assert_true(is_json_number(good[k]));
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) assert_false(is_json_number(bad[k]));
}

TEST(tables_become_json)
{
    Sheet s = sheet_of("name,x\n12,1.5\n</script>,\n");
    Text t = {0};
    sheet_json(&s, 0, NULL, &t);
    assert_string_equal(t.at, "{\"name\":[\"12\",\"\\u003c/script\\u003e\"],\"x\":[1.5,null]}");
    text_clear(&t);
    sheet_clear(&s);
}

/* A spike of one row among a hundred thousand stays. */
TEST(thinning_keeps_extremes)
{
    enum { ROWS = 20000, MOST = 300 };
    Text t = {0};
    int row[MOST + 3], spike = 0, hole = 0;
    text_add(&t, "t,v\n");
    for (int i = 0; i < ROWS; i++) text_print(&t, "%d,%d\n", i, i == 12345 ? 900 : i == 777 ? -900 : i % 10);
    Sheet s = sheet_of(t.at);
    text_clear(&t);
    const int n = sheet_thin(&s, 1, MOST, row);
    assert_in_range(n, MOST / 2, MOST + 1);
    for (int k = 0; k < n; k++) {
        spike |= row[k] == 12345;
        hole |= row[k] == 777;
        if (k) assert_true(row[k] > row[k - 1]);
    }
    assert_true(spike && hole);
    assert_int_equal(row[0], 0);
    assert_int_equal(row[n - 1], ROWS - 1);
    assert_int_equal(sheet_thin(&s, 1, ROWS, (int[ROWS + 3]){0}), ROWS);
    sheet_clear(&s);
}

/* ---------------------------------------------------------------------------------------------------- figures */

static int count(const char *text, const char *part)
{
    int n = 0;
    for (; (text = strstr(text, part)); text++) n++;
    return n;
}

/* An axis has a handful of round numbers, whatever its range. */
TEST(axes_are_round)
{
    static const double ranges[][2] = {{0, 58.5}, {-3, 12e6}, {0, 1e-4}, {5, 5}, {NAN, NAN}, {-1e9, 1e9}};
    for (size_t k = 0; k < sizeof ranges / sizeof *ranges; k++) {
        Svg svg;
        Axis x = {0, 10, 50, 500, "x"}, y = {.at = 300, .length = -250, .label = "<y>"};
        axis_fit(&y, ranges[k][0], ranges[k][1]);
        svg_begin(&svg, 600, 350, "a <title>");
        svg_frame(&svg, &x, &y);
        svg_end(&svg);
        assert_in_range(count(svg.out.at, "<path class=\"grid\""), 3 + 6, 8 + 9);
        assert_null(strstr(svg.out.at, "<y>"));
        assert_null(strstr(svg.out.at, "nan"));
        text_clear(&svg.out);
    }
}

TEST(lines_break_and_thin)
{
    enum { POINTS = 100000 };
    static double xs[POINTS], ys[POINTS];
    for (int i = 0; i < POINTS; i++) {
        xs[i] = i;
        ys[i] = i == 54321 ? 7 : i == 10 ? NAN : 0;
    }
    const Axis x = {0, POINTS, 0, 400, ""}, y = {0, 10, 100, -100, ""};
    Svg svg;
    svg_begin(&svg, 400, 100, "");
    svg_line(&svg, &x, &y, POINTS, xs, ys, SVG_FIRST);
    svg_end(&svg);
    const char *const path = strstr(svg.out.at, "d=\"");
    assert_int_equal(count(path, "M"), 2); /* the gap */
    assert_in_range(count(path, "L"), 400, 1700);
    assert_int_equal(count(path, " 30.0"), 1); /* the spike: 100 - 70 */
    text_clear(&svg.out);
}
