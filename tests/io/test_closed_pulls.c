/* Long pulls in theory, a hoist and a mass on a rope, each against a closed form or an integration apart. */
#include "tests/io/theory_fixture.h"

static const double G = 9.81, DEG = M_PI / 180;

/* A case with the route's pieces, which it takes; the caller's. */
static char *case_of(double mass, double mu, double slope, char *pieces)
{
    static const char form[] =
        "cables: {p: {d: 60 mm, EI: 200, EA: 60 MN, GA: 20 MN, GJ: 200, mass: %g kg/m}}\nfriction: {mu: %g}\n"
        "chain: [{cable: p, length: 20 m}]\n"
        "route: {head_at: 22 m, slope: %.17g deg, pieces: [%s]}\n"
        "surfaces: {ducts: [{radius: 60 mm}]}\n";
    const size_t size = sizeof form + strlen(pieces) + 60;
    char *const text = malloc(size);
    assert_non_null(text);
    snprintf(text, size, form, mass, mu, slope, pieces);
    free(pieces);
    return text;
}

/* N, at the winch, by theory of that case, which it takes. */
static double theory_total(char *text)
{
    json_t *const all = theory_of(text, NULL);
    const double total = number_of(all, "reference_total_N");
    json_decref(all);
    free(text);
    return total;
}

/* As many times these words, with commas between. */
static char *many(int n, const char *words)
{
    const size_t length = strlen(words) + 2;
    char *const out = malloc((size_t)n * length + 1);
    assert_non_null(out);
    for (int i = 0; i < n; ++i) snprintf(out + (size_t)i * length, length + 1, "%s, ", words);
    out[(size_t)n * length - 2] = 0;
    return out;
}

/* T' = w sin a + mu |w cos a - T k| of a vertical curve, a = a0 + k s, by Runge and Kutta's four. */
static double vertical(double T, double w, double mu, double a0, double k, double length)
{
    enum { STEPS = 400 };
    const double h = length / STEPS;
    for (int i = 0; i < STEPS; ++i) {
        double slope[4], sum = 0;
        for (int j = 0; j < 4; ++j) {
            const double part = (const double[]){0, 0.5, 0.5, 1}[j], a = a0 + k * h * (i + part);
            const double at = T + (j ? part * h * slope[j - 1] : 0);
            slope[j] = w * sin(a) + mu * fabs(w * cos(a) - at * k);
            sum += (const double[]){1, 2, 2, 1}[j] / 6 * slope[j];
        }
        T += h * sum;
    }
    return T;
}

/* A hundred hills of a kilometre, 2 degrees up and down between bends of 300 m. */
TEST(hilly_100_km)
{
    const double w = 1.2 * G, mu = 0.1, R = 300, a = 2 * DEG, straight = (1000 - 4 * R * a) / 2;
    char hill[256];
    snprintf(hill, sizeof hill,
             "{bend: 2 deg, radius: 300 m, plane: up}, {straight: %.17g m}, {bend: 4 deg, radius: 300 m, plane: down}, "
             "{straight: %.17g m}, {bend: 2 deg, radius: 300 m, plane: up}",
             straight, straight);
    double T = 0;
    for (int i = 0; i < 100; ++i) {
        T = vertical(T, w, mu, 0, 1 / R, R * a);
        T += w * (sin(a) + mu * cos(a)) * straight;
        T = vertical(T, w, mu, a, -1 / R, 2 * R * a);
        T += w * (-sin(a) + mu * cos(a)) * straight;
        T = vertical(T, w, mu, -a, 1 / R, R * a);
    }
    const double theory = theory_total(case_of(1.2, 0.1, 0, many(100, hill)));
    print_message("%.8g N, integrated %.8g N\n", theory, T);
    check_share(theory, T, 1e-6);
}

/* Level: a straight takes mu w s, a bend to a side T = w R sinh(mu angle + arsinh(T0/(w R))). */
TEST(ten_thousand_pieces)
{
    const double w = 8 * G, mu = 0.15, R = 60;
    double T = 0;
    for (int i = 0; i < 5000; ++i) T = w * R * sinh(mu * 0.2 * DEG + asinh((T + mu * w * 5) / (w * R)));
    char *const pieces = many(2500, "{straight: 5 m}, {bend: 0.2 deg, radius: 60 m, plane: left}, {straight: 5 m}, "
                                    "{bend: 0.2 deg, radius: 60 m, plane: right}");
    const double theory = theory_total(case_of(8, 0.15, 0, pieces));
    print_message("%.8g N, closed form %.8g N\n", theory, T);
    check_share(theory, T, 1e-8);
}

/* Four turns up a ramp of 12 degrees: along the slope T' = w sin b + mu hypot(w cos b, T k), k = cos^2 b/R. */
TEST(a_spiral_ramp)
{
    enum { STEPS = 20000 };
    const double w = 8 * G, mu = 0.15, R = 15, b = 12 * DEG, rise = w * sin(b), lies = w * cos(b),
                 k = cos(b) * cos(b) / R, h = 8 * M_PI * R / cos(b) / STEPS;
    double T = (rise + mu * lies) * 25;
    for (int i = 0; i < STEPS; ++i) {
        double slope = rise + mu * hypot(lies, k * T), sum = slope;
        for (int j = 1; j < 4; ++j) {
            slope = rise + mu * hypot(lies, k * (T + h * slope * (j < 3 ? 0.5 : 1)));
            sum += (j < 3 ? 2 : 1) * slope;
        }
        T += h / 6 * sum;
    }
    T += (rise + mu * lies) * 10;
    char pieces[400];
    char *const turns = many(4, "{bend: 360 deg, radius: 15 m, plane: left}");
    snprintf(pieces, sizeof pieces, "{straight: 25 m}, %s, {straight: 10 m}", turns);
    free(turns);
    const double theory = theory_total(case_of(8, 0.15, 12, strdup(pieces)));
    print_message("%.8g N, integrated %.8g N\n", theory, T);
    check_share(theory, T, 1e-8);
}

/* 30 m of 21 kg/m hang in a shaft: the winch bears what has not passed it yet. */
TEST(a_hoist)
{
    static const char text[] = "cables: {p: {d: 60 mm, mass: 21 kg/m, EI: 200, EA: 60 MN, GA: 20 MN, GJ: 200}}\n"
                               "chain: [{cable: p, length: 30 m}]\n"
                               "route: {head_at: 38 m, slope: 90 deg, pieces: [{straight: 40 m}]}\n"
                               "surfaces: {ducts: [{radius: 60 mm}]}\nfriction: {mu: 0.2}\n"
                               "drive: {winch: {speed: 0.1 m/s, to: 1 s}}\nrun: {duration: 8 s, steady_from: 4 s}\n";
    hawser_summary sum;
    hawser_sim *const sim = run_of(text, NULL);
    hawser_sim_summary(sim, &sum);
    print_message("%.8g N\n", sum.pull_mean_N);
    check_share(sum.pull_mean_N, 30 * 21 * G, 1e-4); /* the head comes to 38.75 m: nothing has passed */
    for (int i = 0; i < sum.n_conditions; ++i) assert_true(sum.conditions[i].holds);
    hawser_sim_free(sim);
}

/* 100 kg on 10 m of rope, EA 400 kN, of 0.1 kg: x tan x = 1/1000, period 2 pi/(x sqrt(k/m)) = 0.314212 s. */
TEST(a_mass_on_a_rope)
{
    static const char text[] =
        "cables: {r: {d: 10 mm, mass: 0.01 kg/m, EI: 1 MN m2, EA: 400 kN, GA: 10 MN, GJ: 1000, damping: 0 s}, "
        "b: {d: 10 mm, mass: 10000 kg/m, EI: 1000 MN m2, EA: 1 GN, GA: 1 GN, GJ: 100 MN m2, damping: 0 s}}\n"
        "gravity: 0 m/s2\nchain: [{cable: r, length: 10 m, segment: 250 mm}, "
        "{cable: b, rope: false, length: 10 mm, segment: 10 mm}]\n"
        "rod: {tail: {fixing: clamped}}\nrun: {analysis: modes, load_steps: 1, modes: 4}\n";
    const double ratio = 0.1 / 100;
    double x = sqrt(ratio);
    for (int i = 0; i < 20; ++i) x -= (x * tan(x) - ratio) / (tan(x) + x / (cos(x) * cos(x)));
    const double period = 2 * M_PI / (x * sqrt(400e3 / 10 / 0.1));
    hawser_sim *const sim = run_of(text, NULL);
    const hawser_mode *mode;
    double nearest = INFINITY;
    const int n = hawser_sim_modes(sim, &mode);
    for (int i = 0; i < n; ++i) nearest = fmin(nearest, fabs(1 / mode[i].frequency_Hz / period - 1));
    check_close(period, 0.31421, 5e-6);
    check_below(nearest, 5e-5);
    hawser_sim_free(sim);
}
