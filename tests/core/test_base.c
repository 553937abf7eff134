/* Vectors, rotations and messages at their edges: no direction, half a turn and more, no error to write to, names that
 * are cut off, what is not a number. */
#include <string.h>

#include "core/error.h"
#include "core/vec3.h"
#include "tests/support/check.h"

TEST(test_vectors)
{
    check_vec(v3_unit(V3_ZERO), V3_ZERO, 0);
    check_vec(v3_unit(v3(0, -3, 4)), v3(0, -0.6, 0.8), 2e-16);
    const double row[3] = {1, 2, 3};
    double back[3];
    v3_put(back, v3_get(row));
    assert_memory_equal(back, row, sizeof row);
    for (int c = 0; c < 3; ++c) check_equal(v3_dot(v3_axis(c), v3_get(row)), row[c]);
}

/* A quaternion and its negative are one rotation, whose vector is never longer than half a turn. */
TEST(test_log)
{
    const Vec3 axis = v3_unit(v3(1, -2, 0.5));
    for (double angle = 0; angle < 3.2; angle += 0.1) {
        const Vec3 r = v3_scale(fmin(angle, M_PI), axis);
        const Quat q = quat_exp(r), turned = {-q.w, -q.x, -q.y, -q.z};
        if (angle < M_PI) check_vec(quat_log(q), r, 1e-14);
        if (angle < M_PI) check_vec(quat_log(turned), r, 1e-14);
        if (angle > 0) check_vec(quat_log(quat_exp(v3_scale(-1, r))), v3_scale(-1, quat_log(q)), 1e-14);
    }
    const Vec3 tiny = v3_scale(1e-12, axis);
    check_vec(quat_log(quat_exp(tiny)), tiny, 1e-27);
    check_vec(quat_log(quat_exp(v3_scale(M_PI + 0.5, axis))), v3_scale(0.5 - M_PI, axis), 1e-14);
}

/* A frame is carried along without twist; where a tangent turns right round there is no such way, and it stays. */
TEST(test_carry)
{
    const Quat q = quat_exp(v3(0.2, 0.1, -0.4));
    const Vec3 a = quat_rotate(q, v3(1, 0, 0)), b = v3_unit(v3(0.3, -1, 2));
    const Quat carried = quat_carry(q, a, b);
    check_vec(quat_rotate(carried, v3(1, 0, 0)), b, 1e-15);
    check_close(v3_dot(quat_log(quat_mul(carried, quat_conj(q))), a), 0, 1e-15);
    const Quat kept = quat_carry(q, a, v3_scale(-1, a));
    assert_memory_equal(&kept, &q, sizeof q);
}

TEST(test_worst)
{
    check_equal(larger_of(1, 2), 2);
    check_equal(larger_of(2, 1), 2);
    check_equal(smaller_of(1, 2), 1);
    check_equal(smaller_of(2, 1), 1);
    check_nan(larger_of(NAN, 1));
    check_nan(larger_of(1, NAN));
    check_nan(smaller_of(NAN, 1));
    check_nan(smaller_of(1, NAN));
}

TEST(test_messages)
{
    hawser_error err = {0};
    assert_int_equal(error_set(NULL, HAWSER_ERR_INPUT, "dropped"), HAWSER_ERR_INPUT);
    error_place(NULL, "file", 3);
    error_moment(NULL, 1, 2);
    assert_int_equal(error_argument(NULL, "out"), HAWSER_ERR_INPUT);
    assert_int_equal(error_memory(NULL), HAWSER_ERR_MEMORY);

    assert_int_equal(error_set(&err, HAWSER_ERR_INPUT, "key 'drive.winch' is wrong"), HAWSER_ERR_INPUT);
    assert_string_equal(err.key, "drive.winch");
    assert_int_equal(err.segment, -1);
    error_place(&err, "case.yaml", 12);
    error_moment(&err, 1.5, 7);
    assert_string_equal(err.file, "case.yaml");
    assert_int_equal(err.line, 12);
    check_equal(err.t_s, 1.5);
    assert_int_equal(err.segment, 7);
    error_set(&err, HAWSER_ERR_RUN, "%s, and 'more'", err.message); /* the old one among the arguments */
    assert_string_equal(err.message, "key 'drive.winch' is wrong, and 'more'");
    assert_string_equal(err.file, "");
    error_set(&err, HAWSER_ERR_INPUT, "key 'that has no end");
    assert_string_equal(err.key, "");
    assert_int_equal(error_argument(&err, "out"), HAWSER_ERR_INPUT);
    assert_string_equal(err.key, "out");
}

/* Controls of one byte and of two become question marks; letters of two bytes, and a lone first byte at the end, stay.
 */
TEST(test_printable)
{
    char text[] = "a\x1b[31m\x7f\xc2\x9b\xc2\xa0\xc3\xa4\xc2";
    assert_int_equal(text_make_printable(text), 3);
    assert_string_equal(text, "a?[31m???\xc2\xa0\xc3\xa4\xc2");
    char edge[] = "\xc2\x7f\xc2\x80\xc2z";
    assert_int_equal(text_make_printable(edge), 2);
    assert_string_equal(edge, "\xc2???\xc2z");
    char turned[] = "a\xe2\x80\xae"
                    "b\xe2\x81\xa9\xef\xbb\xbf\xd8\x9c"
                    "c\xe2\x80\x94\xe2\x80";
    assert_int_equal(text_make_printable(turned), 4);
    assert_string_equal(turned, "a???b????????c\xe2\x80\x94\xe2\x80");
    char fine[] = "hawser";
    assert_int_equal(text_make_printable(fine), 0);
    assert_string_equal(fine, "hawser");
}

TEST(test_room) { assert_true(memory_room(1000)); /* and where there is none: test_core_lack.c */ }
