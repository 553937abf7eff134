/* Writing: what is read back is the same line within 0.1 mm, in every format that can be read. */
#include <math.h>

#include "survey/map.h"
#include "survey/write.h"
#include "tests/survey/survey_fixture.h"

/* Writes, reads, and how far the lines are apart along their whole length. */
static double there_and_back(const Alignment *a, const char *system, WriteFormat format, Survey *back)
{
    char path[] = "/tmp/hawser-write-XXXXXX";
    hawser_error err = {.message = ""};
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    if (alignment_write(a, system, format, path, &err)) fail_msg("%s", err.message);
    if (survey_read(path, &usual, back, &err)) fail_msg("%s", err.message);
    unlink(path);
    assert_int_equal(back->n, 1);
    const Alignment *const b = &back->alignment[0];
    const double length = alignment_measure(a).plan_length;
    double most = fabs(alignment_measure(b).plan_length - length);
    for (double s = 0; s <= length; s += 0.37) {
        most = fmax(most, v3_norm(v3_sub(alignment_at(a, s).at, alignment_at(b, s).at)));
    }
    return most;
}

TEST(within_a_tenth_of_a_millimetre)
{
    for (int rise = 0; rise < 2; ++rise) {
        Alignment a = winding_line(rise, 1, 20);
        static const WriteFormat formats[] = {WRITE_ELEMENTS, WRITE_DXF, WRITE_GEOJSON};
        for (int k = 0; k < 3; ++k) {
            Survey back;
            check_below(there_and_back(&a, "", formats[k], &back), formats[k] == WRITE_ELEMENTS ? 3e-6 : 1e-4);
            const Alignment *const b = &back.alignment[0];
            if (k == 0) assert_true(b->n_plan >= a.n_plan);
            if (k == 0) assert_string_equal(piece_names_get(&b->names, b->plan[0].name), "shaft \"2\", out\\");
            if (k == 1 && !rise) assert_true(back.alignment[0].n_plan > 0); /* arcs, no chords */
            survey_clear(&back);
        }
        alignment_clear(&a);
    }
}

/* From degrees to metres and back, about an origin away from the line. */
TEST(by_the_projection)
{
    Alignment a = winding_line(1, 1, 20);
    char system[SURVEY_NAME_MAX];
    map_system_write((MapOrigin){10.123456789, 59.987654321}, system);
    for (int i = 0; i < a.n_plan; ++i) {
        a.plan[i].x -= 671000;
        a.plan[i].y -= 6712000;
    }
    Survey back;
    check_below(there_and_back(&a, system, WRITE_GEOJSON, &back), 1e-4);
    assert_string_equal(back.system, system);
    assert_string_equal(back.alignment[0].name, "west \"2\"");
    survey_clear(&back);
    alignment_clear(&a);
}

/* Pieces begin at 0, 0, 0 along x: the same shape. */
TEST(planners_pieces)
{
    Alignment a = winding_line(0, 0, 20);
    a.plan[0].x = a.plan[0].y = a.plan[0].heading = 0;
    alignment_chain(&a);
    *alignment_add_profile(&a) = (ProfileElement){.length = 40, .grade = 0.05};
    *alignment_add_profile(&a) = (ProfileElement){.station = 40, .length = 130, .z = 2, .grade = 0.05};
    Survey back;
    check_below(there_and_back(&a, "", WRITE_PIECES, &back), 1e-5);
    survey_clear(&back);
    check_below(there_and_back(&a, "", WRITE_DXF, &back), 1e-4); /* as a level line it would lie 8.5 m too low */
    survey_clear(&back);
    alignment_clear(&a);
    hawser_error err = {.message = ""};
    a = winding_line(0, 1, 20);
    assert_int_equal(alignment_write(&a, "", WRITE_PIECES, "/tmp/hawser-write-none", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "40.000 m from its start");
    alignment_clear(&a);
}

TEST(points)
{
    Alignment a = {.stated_length = NAN};
    *alignment_add_point(&a) = v3(671234.5678, 6712345.6789, 1);
    *alignment_add_point(&a) = v3(671244.5678, 6712345.6789, 2);
    *alignment_add_point(&a) = v3(671244.5678, 6712365.6789, 2.5);
    for (int k = 0; k < 3; ++k) {
        static const WriteFormat formats[] = {WRITE_ELEMENTS, WRITE_DXF, WRITE_GEOJSON};
        Survey back;
        check_below(there_and_back(&a, "", formats[k], &back), 2e-6);
        survey_clear(&back);
    }
    hawser_error err;
    assert_int_equal(alignment_write(&a, "", WRITE_CASE, "/tmp/hawser-write-none", &err), HAWSER_ERR_INPUT);
    alignment_clear(&a);
}

/* The section as a case has it; that it is the same route is a test of cases. */
TEST(as_a_case)
{
    Alignment a = winding_line(1, 1, 20);
    char *text = NULL;
    size_t size;
    FILE *const to = open_memstream(&text, &size);
    hawser_error err;
    assert_int_equal(alignment_print(&a, "EPSG:25832", WRITE_CASE, to, &err), HAWSER_OK);
    fclose(to);
    check_has(text, "start: [671234.567800 m, 6712345.678900 m, 12.000000 m]");
    check_has(text, "- {line: 40.000000000 m, name: \"shaft \\\"2\\\", out\\\\\"}");
    check_has(text, "- {clothoid: 20.000000000 m, end_radius: 30 m, turn: left}");
    check_has(text, "- {arc: 25.000000000 m, radius: 30 m, turn: left}");
    check_has(text, "- {clothoid: 21.875000000 m, start_radius: 30 m, turn: left}");
    check_has(text, "- {clothoid: 13.125000000 m, end_radius: 50 m, turn: right}");
    check_has(text, "- {station: 50.000000000 m, height: 10.000000000 m, radius: 300 m}");
    check_has(text, "# coordinates: EPSG:25832");
    free(text);
    alignment_clear(&a);
}

TEST(endings)
{
    assert_int_equal(write_format("a/b.DXF"), WRITE_DXF);
    assert_int_equal(write_format("b.yaml"), WRITE_CASE);
    assert_int_equal(write_format("b.dwg"), -1);
    hawser_error err;
    Alignment a = winding_line(0, 1, 20);
    assert_int_equal(alignment_write(&a, "", WRITE_DXF, "/nowhere/a.dxf", &err), HAWSER_ERR_OUTPUT);
    alignment_clear(&a);
}
