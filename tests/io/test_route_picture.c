/* The page of a route: what is drawn is where the route is, what is left out is grey, and figures are the route's. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"

/* A corner of two lines on a layer, walls on another, and a circle. */
static const char drawing[] = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nCENTRE\n10\n0\n20\n0\n11\n60\n21\n0\n0\nLINE\n8\nCE"
                              "NTRE\n10\n60\n20\n0\n11\n60\n"
                              "21\n40\n0\nLINE\n8\nWALL\n10\n-5\n20\n-5\n11\n65\n21\n-"
                              "5\n0\nCIRCLE\n8\nX\n10\n0\n20\n0\n40\n5\n0\nENDSEC\n0\nEOF\n";

static char folder[] = "/tmp/hawser-picture-XXXXXX", drawn[64], page[64];

/* Writes the page of the drawing; its text, to be freed. */
static char *page_of(const hawser_route_options *options, int line)
{
    hawser_error err;
    hawser_routes *r = NULL;
    char *text = calloc(1, 1 << 20);
    if (hawser_routes_read(drawn, options, &r, &err)) fail_msg("%s", err.message);
    if (hawser_routes_write(r, line, page, &err)) fail_msg("%s", err.message);
    hawser_routes_free(r);
    FILE *const file = fopen(page, "r");
    assert_non_null(file);
    assert_in_range(fread(text, 1, (1 << 20) - 1, file), 1000, (1 << 20) - 2);
    fclose(file);
    return text;
}

/* The place in pixels of the n-th circle of a style, from 0. */
static void circle_at(const char *text, const char *style, int n, double at[2])
{
    char sign[40];
    snprintf(sign, sizeof sign, "<circle class=\"dot %s\"", style);
    for (int i = 0; i <= n; ++i) {
        text = strstr(text, sign);
        assert_non_null(text);
        ++text;
    }
    assert_int_equal(sscanf(strstr(text, "cx="), "cx=\"%lf\" cy=\"%lf\"", &at[0], &at[1]), 2);
}

static int begin(void **state)
{
    (void)state;
    memcpy(folder + strlen(folder) - 6, "XXXXXX", 6);
    if (!mkdtemp(folder)) return 1;
    snprintf(drawn, sizeof drawn, "%s/x.dxf", folder);
    snprintf(page, sizeof page, "%s/x.html", folder);
    FILE *const file = fopen(drawn, "w");
    if (!file) return 1;
    fputs(drawing, file);
    return fclose(file);
}

static int end(void **state)
{
    (void)state;
    unlink(drawn);
    unlink(page);
    return rmdir(folder);
}

TEST_WITH(plan_with_what_is_left_out, begin, end)
{
    hawser_route_options options = hawser_route_defaults();
    options.layer = "CENTRE";
    options.radius_m = 8;
    options.from_m = 10;
    char *const text = page_of(&options, -1);
    double start[2], end[2], bend[2], wall[2];
    circle_at(text, "a", 0, start);
    circle_at(text, "a", 1, end);
    circle_at(text, "b", 0, bend);
    const double metre = (end[0] - start[0]) / 50; /* pixels of one: from (10, 0) to (60, 40) */
    check_close((start[1] - end[1]) / metre, 40, 0.05);
    check_close((bend[0] - start[0]) / metre, 60 - 8 + 8 * sqrt(0.5) - 10, 0.05);
    check_close((start[1] - bend[1]) / metre, 8 - 8 * sqrt(0.5), 0.05);
    static const char sign[] = "<path class=\"line grey\" d=\"";
    const char *const left = strstr(strstr(text, sign) + 1, sign); /* behind that of the legend */
    assert_non_null(left);
    int found = 0;
    for (const char *at = left + strlen(sign); *at && *at != '"'; ++at) {
        if (*at != 'M' || sscanf(at, "M%lf %lf", &wall[0], &wall[1]) != 2) continue;
        found += fabs((wall[0] - start[0]) / metre + 15) < 0.05 && fabs((start[1] - wall[1]) / metre + 5) < 0.05;
    }
    assert_int_equal(found, 1);
    check_has(text, ">start</text>");
    check_has(text, ">R 8 m, 90.0\xC2\xB0</text>");
    check_has(text, "left to right, as it is drawn");
    check_has(text, "<td>52.00<td>12.57<td>90.0<td>8.00");
    check_has(text, "Profile (level)");
    check_has(text, "<li>CIRCLE</li>");
    free(text);
}

/* Of a file of several lines all are drawn, or one; a drawing is not written over. */
TEST_WITH(all_or_one, begin, end)
{
    hawser_error err;
    hawser_routes *r = NULL;
    char *text = page_of(NULL, -1);
    check_has(text, "class=\"line b\"");
    check_has(text, "<b>WALL</b>");
    free(text);
    text = page_of(NULL, 1);
    assert_null(strstr(text, "<b>CENTRE</b>"));
    free(text);
    assert_int_equal(hawser_routes_read(drawn, NULL, &r, &err), HAWSER_OK);
    assert_int_equal(hawser_routes_write(r, 9, page, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_routes_write(r, -1, "/tmp/none/x.html", &err), HAWSER_ERR_OUTPUT);
    hawser_routes_free(r);
}
