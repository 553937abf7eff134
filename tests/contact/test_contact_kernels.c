/* The kernels of every instruction set that this machine has do the same. */
#include "tests/support/touch.h"

#include <math.h>

#include "contact/roller.h"

static const FrictionLaw friction = {.mu_s = 0.2, .mu_d = 0.15, .v_s = 5e-3, .v_d = 2e-2};
static const ImpactLaw impact = {.k = 2e7, .e = 1.5, .c = 2e4, .d = 1e-3};

/* LANES arcs of two segments across rollers, all touching a little. */
static void batch_random(ContactBatch *batch, uint64_t *seed)
{
    memset(batch, 0, sizeof *batch);
    batch->count = LANES;
    batch->impact = &impact;
    batch->friction_scale = 1;
    for (int l = 0; l < LANES; ++l) {
        batch->arc[l] = 1;
        batch->friction[l] = &friction;
        batch->axis[1][l] = 1;
        batch->centre[2][l] = -0.1 - 0.0435 + 1e-3;
        batch->shape_radius[l] = 0.1;
        batch->shape_half_width[l] = 0.3;
        for (int b = 0; b < 2; ++b) {
            batch->radius[b][l] = 0.0435 + 1e-4 * fixture_random(seed);
            batch->x[b][0][l] = (b - 0.5) * 0.5 + 0.1 * fixture_random(seed);
            batch->r[b][0][l] = 0.25;
            for (int c = 0; c < 3; ++c) {
                batch->x[b][c][l] += 1e-4 * fixture_random(seed);
                batch->r[b][c][l] += 1e-3 * fixture_random(seed);
                batch->v[b][c][l] = 0.02 * fixture_random(seed);
                batch->w[b][c][l] = 0.1 * fixture_random(seed);
            }
        }
    }
}

/* Largest difference of two arrays over the largest entry of the first. */
static double difference(const double *a, const double *b, size_t count)
{
    double most = 0, size = 0;
    for (size_t i = 0; i < count; ++i) {
        size = larger_of(size, fabs(a[i]));
        most = larger_of(most, fabs(a[i] - b[i]));
    }
    check_above(size, 0);
    return most / size;
}

static void batch_check(const ContactKernels *one, const ContactKernels *other, const ContactBatch *batch)
{
    static ContactPush push[2];
    static ContactMatrix k[2], d[2];
    double normal[LANES];
    one->push[VARIANT_PLAIN](batch, &push[0]);
    other->push[VARIANT_PLAIN](batch, &push[1]);
    assert_int_equal(one->columns[VARIANT_PLAIN](batch, &k[0], &d[0], normal), 1);
    assert_int_equal(other->columns[VARIANT_PLAIN](batch, &k[1], &d[1], normal), 1);
    check_below(difference(push[0].normal, push[1].normal, LANES), 1e-11);
    check_below(difference(push[0].force[0][0], push[1].force[0][0], 6 * LANES), 1e-11);
    check_below(difference(push[0].moment[0][0], push[1].moment[0][0], 6 * LANES), 1e-11);
    check_below(difference(k[0].entry[0], k[1].entry[0], 144 * LANES), 1e-10);
    check_below(difference(d[0].entry[0], d[1].entry[0], 144 * LANES), 1e-10);
}

TEST(test_instruction_sets_agree)
{
    static const ContactKernels *const table[] = ISA_TABLE(contact_kernels);
    uint64_t seed = 4;
    for (int i = 0; i < 20; ++i) {
        ContactBatch batch;
        batch_random(&batch, &seed);
        for (int isa = 1; isa <= (int)isa_best(); ++isa) batch_check(table[0], table[isa], &batch);
    }
}

/* A lane does not depend on its neighbours: the same hit alone in a batch gives the same bits. */
TEST(test_lanes_are_independent)
{
    static const ContactKernels *const table[] = ISA_TABLE(contact_kernels);
    uint64_t seed = 8;
    ContactBatch mixed, alone;
    batch_random(&mixed, &seed);
    ContactPush push[2];
    table[isa_best()]->push[VARIANT_PLAIN](&mixed, &push[0]);
    for (int l = 0; l < LANES; ++l) {
        alone = mixed;
        for (int to = 0; to < LANES; ++to) {
            for (int b = 0; b < 2; ++b) {
                alone.radius[b][to] = mixed.radius[b][l];
                for (int c = 0; c < 3; ++c) {
                    alone.x[b][c][to] = mixed.x[b][c][l];
                    alone.r[b][c][to] = mixed.r[b][c][l];
                    alone.v[b][c][to] = mixed.v[b][c][l];
                    alone.w[b][c][to] = mixed.w[b][c][l];
                }
            }
        }
        table[isa_best()]->push[VARIANT_PLAIN](&alone, &push[1]);
        check_equal(push[0].u[l], push[1].u[0]);
        check_equal(push[0].normal[l], push[1].normal[0]);
        check_equal(push[0].force[1][2][l], push[1].force[1][2][0]);
    }
}

/* Without friction and damping no force depends on a velocity: said, and d is left alone; the derivatives by places are
 * those that friction leaves at no coefficient. With damping d is written. */
TEST(test_no_speeds)
{
    static const ContactKernels *const table[] = ISA_TABLE(contact_kernels);
    static const FrictionLaw none = {.v_s = 5e-3, .v_d = 2e-2};
    static ContactMatrix k[2], d[2], untouched;
    const ImpactLaw spring = {.k = 2e7, .e = 1.5, .d = 1e-3};
    uint64_t seed = 5;
    memset(&untouched, 0x5a, sizeof untouched);
    for (int isa = 0; isa <= (int)isa_best(); ++isa) {
        ContactBatch batch;
        double normal[LANES];
        batch_random(&batch, &seed);
        assert_int_equal(table[isa]->columns[VARIANT_SMOOTH](&batch, &k[0], &d[0], normal), 1);
        batch.impact = &spring;
        for (int l = 0; l < LANES; ++l) batch.friction[l] = &none;
        d[0] = untouched;
        assert_int_equal(table[isa]->columns[VARIANT_SMOOTH](&batch, &k[0], &d[0], normal), 2);
        assert_memory_equal(&d[0], &untouched, sizeof untouched);
        assert_int_equal(table[isa]->columns[VARIANT_PLAIN](&batch, &k[1], &d[1], normal), 1);
        check_below(difference(k[0].entry[0], k[1].entry[0], 144 * LANES), 1e-14);
        for (int e = 0; e < 144; ++e) {
            for (int l = 0; l < LANES; ++l) check_equal(d[1].entry[e][l], 0);
        }
        for (int l = 0; l < LANES; ++l) batch.centre[2][l] -= 0.1; /* apart */
        assert_int_equal(table[isa]->columns[VARIANT_SMOOTH](&batch, &k[0], &d[0], normal), 0);
    }
}
