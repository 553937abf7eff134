/* How far cables lie inside each other, by places alone (CC29): closed forms, against every pair of segments, what does
 * not count, and which of several lines are asked. */
#include "contact/self.h"
#include "tests/support/touch.h"

static SelfOverlap alone(const SelfScene *s) { return self_overlap(SELF_ALONE(&s->chain, &s->kin)); }

/* Two strands of one cable that cross at an angle, one above the other. */
TEST(strands_that_cross)
{
    const double angles[] = {0.2, 1, 1.6, 2.5}, share[] = {1, 0.7, 0.3, 0.01, -0.2};
    for (int a = 0; a < 4; ++a) {
        for (int k = 0; k < 5; ++k) {
            const double c = cos(angles[a]), e = sin(angles[a]), apart = (1 - share[k]) * 2 * SELF_RADIUS;
            SelfScene s;
            self_new(&s, 12, 0.3);
            self_strand(&s, 0, 6, v3(-0.95, 0, 0), v3(1, 0, 0));
            self_strand(&s, 6, 6, v3(0.1 + 0.85 * c, 0.85 * e, apart), v3(-c, -e, 0));
            const SelfOverlap found = alone(&s);
            check_close(found.share, share[k], 1e-12);
            assert_int_equal(found.line, 0);
            assert_int_equal(found.other, 0);
            assert_int_equal(found.segment, 3); /* the crossing is at x = 0.1, where the fourth lies */
            assert_true(found.opposite >= 6);
            self_free(&s);
        }
    }
}

/* An arc of nine tenths of a turn. What is nearest of it are its ends, or places half a turn about its own surface
 * apart; a bend no sharper than the cable is thick does not count as inside itself there. */
TEST(arcs)
{
    const double ratio[] = {0.7, 0.85, 1.2, 3, 10}, turn = 0.9 * 2 * M_PI;
    const int n = 400;
    for (int k = 0; k < 5; ++k) {
        const double radius = ratio[k] * SELF_RADIUS, step = turn / n;
        SelfScene s;
        self_new(&s, n, radius * step);
        for (int i = 0; i < n; ++i)
            self_place(&s, i, v3(radius * cos(i * step), radius * sin(i * step), 0),
                       v3(radius * cos((i + 1) * step), radius * sin((i + 1) * step), 0));
        const double nearest = 2 * radius * fmin(sin(M_PI / (2 * ratio[k])), sin(turn / 2));
        const double share = 1 - nearest / (2 * SELF_RADIUS), found = alone(&s).share;
        if (share > 0) check_close(found, share, 0.01); /* what is apart may be passed over */
        if (share < 0) check_below(found, 0.01);
        self_free(&s);
    }
}

/* Layers of a coil press into each other by what the pitch lacks, as long as turns are wide. */
TEST(coils)
{
    const double lacks[] = {0.5, 0.1, 0.01, -0.3};
    for (int k = 0; k < 4; ++k) {
        SelfScene s;
        self_new(&s, 64, 0.1);
        self_helix(&s, 0.5, 2 * SELF_RADIUS * (1 - lacks[k]));
        check_close(alone(&s).share, lacks[k], 6e-3); /* the pitch is along the axis, not across the turns */
        self_free(&s);
    }
}

/* What is passed over on the way is never what is looked for. */
static double every_pair(const SelfScene *s)
{
    double most = -INFINITY;
    for (int i = 0; i < s->chain.n; ++i) {
        double between = 0;
        for (int j = i + 2; j < s->chain.n; ++j) {
            between += 2 * s->chain.half[j - 1];
            if (between < M_PI * fmax(s->chain.radius[i], s->chain.radius[j])) continue;
            Chord chord[2];
            for (int e = 0; e < 2; ++e) {
                const int k = e ? j : i;
                const Vec3 axis = vec_load(s->kin.a, k);
                chord[e] = (Chord){v3_axpy(vec_load(s->kin.p, k), -s->chain.half[k], axis),
                                   v3_scale(2 * s->chain.half[k], axis)};
            }
            const double radii = s->chain.radius[i] + s->chain.radius[j];
            most = fmax(most, 1 - chords_apart(&chord[0], &chord[1]) / radii);
        }
    }
    return most;
}

TEST(every_pair_counts)
{
    uint64_t seed = 5;
    int inside = 0;
    for (int k = 0; k < 200; ++k) {
        const int n = 40;
        SelfScene s;
        self_new(&s, n, 0.05 + 0.002 * (k % 50));
        for (int i = 0; i < n; ++i) {
            s.chain.half[i] *= 1 + 0.5 * (i % 4);
            s.chain.radius[i] *= 1 + 0.3 * ((i + k) % 3);
            vec_store(s.kin.p, i, fixture_vector(&seed, 0.3 + 0.003 * k));
            vec_store(s.kin.a, i, v3_unit(fixture_vector(&seed, 1)));
        }
        const double most = every_pair(&s), found = alone(&s).share;
        if (most > 0) check_equal(found, most); /* what is apart may be passed over */
        if (most <= 0) check_at_most(found, most);
        inside += most > 0 && most < 1;
        self_free(&s);
    }
    check_above(inside, 100);
}

/* Of several lines: with each other, with themselves if asked, not where one eye holds them. */
TEST(several_lines)
{
    SelfScene s[2];
    for (int l = 0; l < 2; ++l) {
        self_new(&s[l], 12, 0.3);
        self_strand(&s[l], 0, 12, v3(0, 0.09 * l, 0), v3(1, 0.001 * l, 0));
    }
    SelfLine line[2] = {{&s[0].chain, &s[0].kin, 0, 0}, {&s[1].chain, &s[1].kin, 12, 0}};
    const SelfLines both = {2, line, 0}, within = {2, line, 1}, none = {1, line, 0};
    const double side = 1 - 0.09 / (2 * SELF_RADIUS);
    const SelfOverlap found = self_overlap(&both);
    check_close(found.share, side, 1e-5);
    assert_int_equal(found.line, 0);
    assert_int_equal(found.other, 1);
    assert_int_equal(self_overlap(&none).line, -1);
    assert_true(isinf(self_overlap(&none).share));

    self_strand(&s[1], 0, 6, v3(0, 0.5, 0), v3(1, 0, 0)); /* the second comes back beside itself */
    self_strand(&s[1], 6, 6, v3(1.7, 0.5 + SELF_RADIUS, 0), v3(-1, 0, 0));
    assert_int_equal(self_overlap(&both).line, -1);
    const SelfOverlap own = self_overlap(&within);
    check_close(own.share, 0.5, 1e-9);
    assert_int_equal(own.line, 1);
    assert_int_equal(own.other, 1);

    for (int l = 0; l < 2; ++l) { /* heads that meet */
        self_strand(&s[l], 0, 12, v3(0, l, 0), v3(1, 0, 0));
        self_place(&s[l], 11, v3(9, 2.0 * SELF_RADIUS * l, 0), v3(9.3, 0, 0));
        line[l].eye = 1;
    }
    check_below(self_overlap(&both).share, 0);
    line[1].eye = 2;
    check_above(self_overlap(&both).share, 0.98); /* they are a little shorter than that way */
    for (int l = 0; l < 2; ++l) self_free(&s[l]);
}

/* A segment that is longer or thicker than all others, at any place of the other line: met near its end, or beside it,
 * it is as deep inside as it is. */
TEST(odd_segments)
{
    enum { SEGMENTS = 5 };
    for (int f = 0; f < SEGMENTS; ++f) {
        for (int thick = 0; thick < 2; ++thick) {
            const double small = 0.05, large = 1, fat = 5 * SELF_RADIUS;
            SelfScene s[2];
            for (int l = 0; l < 2; ++l) self_new(&s[l], SEGMENTS, 2 * small);
            if (thick) s[1].chain.radius[f] = fat;
            if (!thick) s[1].chain.half[f] = large;
            self_strand(&s[1], 0, SEGMENTS, V3_ZERO, v3(0, 1, 0));
            const Vec3 middle = vec_load(s[1].kin.p, f);
            const double radii = SELF_RADIUS + s[1].chain.radius[f], apart = 0.8 * radii;
            /* across, its own middle above a place of segment f */
            const Vec3 at = v3_add(middle, v3(0, thick ? 0 : 0.9 * large, apart));
            self_strand(&s[0], 0, SEGMENTS, v3_sub(at, v3(SEGMENTS * small, 0, 0)), v3(1, 0, 0));
            const SelfLine line[2] = {{&s[0].chain, &s[0].kin, 0, 0}, {&s[1].chain, &s[1].kin, SEGMENTS, 0}};
            const SelfOverlap found = self_overlap(&(SelfLines){2, line, 0});
            check_close(found.share, 0.2, 1e-12);
            assert_int_equal(found.line, 0);
            assert_int_equal(found.other, 1);
            assert_int_equal(found.opposite, f);
            for (int l = 0; l < 2; ++l) self_free(&s[l]);
        }
    }
}
