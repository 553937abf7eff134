/* What the steps in time take out of a motion that nothing damps: the books have it as a term of its own, which is the
 * closed form of the method; the run is not trusted; and what the condition says to do helps. */
#include "tests/io/case_fixture.h"

typedef struct Swing {
    hawser_balance books;
    hawser_condition damping;
    double motion_and_springs; /* J, more than at t = 0 */
} Swing;

static Swing swing(const char *const *settings)
{
    hawser_summary sum;
    Swing out = {.damping = {.value = NAN}};
    hawser_sim *const s = run_of(data_text("undamped-span"), settings);
    hawser_sim_summary(s, &sum);
    out.books = *sum.balance;
    out.motion_and_springs = sum.balance->stored_J;
    for (int i = 0; i < sum.n_conditions; i++) {
        if (!strcmp(sum.conditions[i].name, "numerical_damping")) out.damping = sum.conditions[i];
    }
    hawser_sim_free(s);
    return out;
}

static const char *const bdf[] = {"solver.method", "bdf", NULL}, *const esdirk[] = {"solver.method", "esdirk", NULL};

/* It kept a third of its energy, and energy closed to some parts in a million of its prestress. */
TEST(nothing_damps_it)
{
    const double plucked = 0.8 * 0.8 * 10 / (8 * 2000); /* J: F^2 L / 8 T */
    const Swing s = swing(bdf);
    print_message("lost %.4g J of %.4g J, the steps took %.4g J, %.2g open\n", -s.motion_and_springs, plucked,
                  s.books.numerical_J, s.books.residual_share);
    check_share(s.books.numerical_J, -s.motion_and_springs, 1e-3); /* not by subtraction: (BA11) knows no springs */
    check_below(s.books.residual_share, 1e-3);
    check_above(s.books.numerical_J, 0.2 * plucked);
    check_between(s.books.turnover_J, 0.8 * plucked, plucked); /* of what moves: prestress is 20 J */
    assert_string_equal(s.books.turnover_of, "motion");
    assert_false(s.damping.holds);
    check_has(s.damping.remedy, "set solver.accuracy to");
}

/* A one-step method keeps nine tenths of it, and (BA11) tells what it takes. */
TEST(one_step_takes_less)
{
    const double plucked = 0.8 * 0.8 * 10 / (8 * 2000);
    const Swing s = swing(esdirk), otherwise = swing(NULL);
    print_message("lost %.4g J of %.4g J, the steps took %.4g J, %.2g open\n", -s.motion_and_springs, plucked,
                  s.books.numerical_J, s.books.residual_share);
    check_share(s.books.numerical_J, -s.motion_and_springs, 5e-3);
    check_below(s.books.residual_share, 1e-3);
    check_below(s.books.numerical_J, 0.1 * plucked);
    check_share(otherwise.books.numerical_J, s.books.numerical_J, 0); /* auto: nothing damps the span */
}

/* The same span as a shaft, twisted in the middle and let go: moments and turns. The moment leaves over a millisecond,
 * within which the steps' trapezoids err. */
TEST(a_twist)
{
    const char *const shaft[] = {"solver.method",
                                 "bdf",
                                 "cables.c.GJ",
                                 "1 kN m2",
                                 "cables.c.d",
                                 "100 mm",
                                 "rod.tail.fixing",
                                 "clamped",
                                 "rod.head.fixing",
                                 "clamped",
                                 "rod.head.motion",
                                 "[]",
                                 "rod.loads.0",
                                 "{at: 5 m, direction: [1, 0, 0], "
                                 "moment: 8 N m, table: [[0 s, 1], [1 ms, 0], [1000 s, 0]]}",
                                 "run.duration",
                                 "2 s",
                                 NULL};
    const Swing s = swing(shaft);
    print_message("lost %.4g J, the steps took %.4g J\n", -s.motion_and_springs, s.books.numerical_J);
    check_share(s.books.numerical_J, -s.motion_and_springs, 0.03);
    check_above(s.books.numerical_J, 0.01);
}

TEST(the_remedy_helps)
{
    for (int k = 0; k < 2; ++k) {
        const Swing before = swing(k ? esdirk : bdf);
        char accuracy[16] = "";
        assert_int_equal(sscanf(strstr(before.damping.remedy, "accuracy to "), "accuracy to %15[^,]", accuracy), 1);
        const char *const followed[] = {"solver.method", k ? "esdirk" : "bdf", "solver.accuracy", accuracy, NULL};
        const Swing after = swing(followed);
        print_message("at %s: %.3g of the motion\n", accuracy, after.damping.value);
        assert_true(after.damping.holds);
    }
}

/* Steps of one length over the odd modes of a span plucked in the middle, of which mode k has 8 / (pi k)^2 of the
 * energy: order one keeps 1 / (1 + (omega h)^2) of it a step, order two what (BA13) says. */
TEST(closed_form)
{
    const double plucked = 0.8 * 0.8 * 10 / (8 * 2000), pi = 3.14159265358979323846;
    const double omega = pi / 10 * sqrt(2000. / 10);
    static const struct {
        const char *order, *accuracy, *step;
        double h;
    } run[] = {{"1", "0.01", "5 ms", 5e-3},
               {"1", "0.01", "10 ms", 10e-3},
               {"2", "1e-4", "5 ms", 5e-3},
               {"2", "1e-4", "10 ms", 10e-3}};
    for (size_t i = 0; i < sizeof run / sizeof *run; i++) {
        const char *const even[] = {"solver.method",
                                    "bdf",
                                    "solver.max_step",
                                    run[i].step,
                                    "solver.accuracy",
                                    run[i].accuracy,
                                    "solver.max_order",
                                    run[i].order,
                                    NULL};
        double kept = 0;
        for (int k = 1; k < 20; k += 2) {
            const double turn = k * omega * run[i].h;
            const double a_step = run[i].order[0] == '1' ? log1p(turn * turn) : pow(turn, 4) / 2;
            kept += 8 / (pi * k * pi * k) * exp(-20 / run[i].h * a_step);
        }
        const Swing s = swing(even);
        print_message("order %s, steps of %s: kept %.4f, closed form %.4f\n", run[i].order, run[i].step,
                      1 - s.books.numerical_J / plucked, kept);
        check_close(1 - s.books.numerical_J / plucked, kept, 0.01);
    }
}
