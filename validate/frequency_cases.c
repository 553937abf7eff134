/* Natural frequencies, by two methods: in time, where a rod is started in one of its modes and its changes of direction
 * are timed, through all parts of a simulation including the integrator; and as eigenvalues about the equilibrium. */
#include <math.h>

#include "core/vec3.h"
#include "sim/run/modes.h"
#include "sim/run/statics.h"
#include "validate/validate.h"

enum { SEGMENTS = 50, MODES = 3 };
static const double LENGTH = 1, MASS = 1, EI = 1e3, TENSION = 1e3; /* m, kg/m, N m2, N */

typedef enum SpanKind { STRING, CANTILEVER, CLAMPED } SpanKind;

/* Roots of cosh cos = -1 (cantilever) and +1 (clamped at both ends). */
typedef struct Span {
    SpanKind kind;
    double beta[MODES];
} Span;
static const Span string = {STRING, {M_PI, 2 * M_PI, 3 * M_PI}},
                  cantilever = {CANTILEVER, {1.875104, 4.694091, 7.854757}},
                  clamped = {CLAMPED, {4.730041, 7.853205, 10.995608}};

/* rad/s. */
static double frequency_of(const Span *s, int mode)
{
    const double b = s->beta[mode] / LENGTH;
    return s->kind == STRING ? b * sqrt(TENSION / MASS) : b * b * sqrt(EI / MASS);
}

/* The mode's deflection at x from the tail, and its slope. */
static double shape_of(const Span *s, int mode, double x, double *slope)
{
    const double b = s->beta[mode], z = b * x / LENGTH;
    if (s->kind == STRING) {
        *slope = b / LENGTH * cos(z);
        return sin(z);
    }
    const double sigma =
        s->kind == CANTILEVER ? (cosh(b) + cos(b)) / (sinh(b) + sin(b)) : (cosh(b) - cos(b)) / (sinh(b) - sin(b));
    *slope = b / LENGTH * (sinh(z) + sin(z) - sigma * (cosh(z) - cos(z)));
    return cosh(z) - cos(z) - sigma * (sinh(z) - sin(z));
}

/* At rest, in n segments; the string stretched by its tension. */
static hawser_status span_start(const Span *s, int n, Stage *stage, hawser_error *err)
{
    SceneDef def;
    hawser_relaxation out = {0};
    CableDef cable = build_cable(MASS, 0.002, 1e7, s->kind == STRING ? 1e-3 : EI);
    cable.ga = 1e9; /* a thin rod without shear: no rotary inertia, no Timoshenko effect */
    hawser_status status = rod_start(&def, cable, LENGTH, n, 1, err);
    if (status) return status;
    RodEndDef *const end = def.rod.end;
    if (s->kind == STRING) {
        rod_pin(&end[ROD_TAIL]);
        end[ROD_HEAD].held[1] = end[ROD_HEAD].held[2] = end[ROD_HEAD].held[3] = 1;
        rod_add_load(&def, LENGTH, 0, rod_steady(v3(1, 0, 0), TENSION));
    } else {
        rod_clamp(&end[ROD_TAIL]);
        if (s->kind == CLAMPED) rod_clamp(&end[ROD_HEAD]);
    }
    def.analysis.kind = ANALYSIS_DYNAMICS;
    def.solver.accuracy = 1e-6;
    def.solver.atol_velocity = def.solver.atol_omega = 1e-7;
    def.solver.atol_position = def.solver.atol_rotation = 1e-10;
    status = motion_start(&def, stage, err);
    if (status) return status;
    status = statics_settle(stage, 1e-10, &out, err);
    if (status) stage_free(stage);
    return status;
}

/* Speed of the mode: the component of the speeds along it. */
static double mode_speed(const Stage *stage, const Span *s, int mode)
{
    const int n = stage->scene.chain.n;
    double sum = 0, slope;
    for (int i = 0; i < n; ++i) {
        sum += shape_of(s, mode, (i + 0.5) * LENGTH / n, &slope) * motion_get(stage, STATE_V, i).z;
    }
    return sum;
}

/* Starts the mode with up to 1 mm/s and times its speed's changes of sign, half a period apart. */
static hawser_status mode_time(Stage *stage, const Span *s, int mode, double *omega, hawser_error *err)
{
    enum { CROSSINGS = 6, SAMPLES = 40 };
    static const double SPEED = 1e-3;
    const double step = M_PI / frequency_of(s, mode) / SAMPLES;
    const int n = stage->scene.chain.n;
    for (int i = 0; i < n; ++i) {
        double slope;
        const double v = SPEED * shape_of(s, mode, (i + 0.5) * LENGTH / n, &slope);
        motion_set(stage, STATE_V, i, v3(0, 0, v));
        motion_set(stage, STATE_W, i, v3(0, -SPEED * slope, 0));
    }
    double first = NAN, last = NAN, before = mode_speed(stage, s, mode);
    int crossings = 0;
    hawser_status status = HAWSER_OK;
    for (int k = 1; k < 2 * CROSSINGS * SAMPLES && crossings < CROSSINGS && !status; ++k) {
        status = motion_advance(stage, k * step, err);
        const double now = mode_speed(stage, s, mode);
        if (before * now < 0) {
            last = (k - 1 + before / (before - now)) * step;
            if (!crossings++) first = last;
        }
        before = now;
    }
    *omega = (crossings - 1) * M_PI / (last - first);
    return status;
}

/* The frequency of one mode in n segments, rad/s. */
static hawser_status span_time(const Span *s, int n, int mode, double *omega, hawser_error *err)
{
    Stage stage;
    hawser_status status = span_start(s, n, &stage, err);
    if (status) return status;
    status = mode_time(&stage, s, mode, omega, err);
    stage_free(&stage);
    return status;
}

/* The second mode from 10 to 80 segments. */
static hawser_status order_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    enum { COUNT = 4, MODE = 1 };
    double h[COUNT], error[COUNT];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < COUNT && !status; ++k) {
        double omega = NAN;
        status = span_time(setup, 10 << k, MODE, &omega, err);
        h[k] = 1.0 / (10 << k);
        error[k] = omega / frequency_of(setup, MODE) - 1;
    }
    if (!status) order_log(log, COUNT, h, error, "segment length", 2, 0.2);
    return status;
}

static hawser_status frequency_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const char *const name[MODES] = {"mode 1", "mode 2", "mode 3"};
    const Span *const s = setup;
    hawser_status status = HAWSER_OK;
    for (int mode = 0; mode < MODES && !status; ++mode) {
        double omega = NAN;
        status = span_time(s, SEGMENTS, mode, &omega, err);
        if (!status) log_share(log, name[mode], "Hz", frequency_of(s, mode) / (2 * M_PI), omega / (2 * M_PI), 0.5);
    }
    return status;
}

/* Checks for a mode normal to the rod: there are two alike, one in each direction; others lie between them. */
static int is_transverse(const hawser_mode *mode, int segments)
{
    double across = 0, along = 0;
    for (int i = 0; i < segments; ++i) {
        across = larger_of(across, hypot(mode->shape[6 * i + 1], mode->shape[6 * i + 2]));
        along = larger_of(along, fabs(mode->shape[6 * i]));
    }
    return across > 0.5 && along < 0.5;
}

/* The same frequencies as eigenvalues. */
static hawser_status modes_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const char *const name[MODES] = {"mode 1", "mode 2", "mode 3"};
    const Span *const s = setup;
    Stage stage;
    Modes modes = {0};
    hawser_status status = span_start(s, SEGMENTS, &stage, err);
    if (status) return status;
    status = modes_find(&stage, 2 * MODES + 4, 0, &modes, err);
    int found = 0;
    for (int i = 0; i < modes.n && found < 2 * MODES && !status; ++i) {
        if (!is_transverse(&modes.out[i], SEGMENTS)) continue;
        const int mode = found++ / 2;
        if (found % 2 == 0) continue;
        log_share(log, name[mode], "Hz", frequency_of(s, mode) / (2 * M_PI), modes.out[i].frequency_Hz, 0.5);
    }
    if (!status && found < 2 * MODES) log_limit(log, "modes not found", "1", 2 * MODES - found, 0);
    modes_free(&modes);
    stage_free(&stage);
    return status;
}

static const ValidationCase cases[] = {
    {"frequency-string", "a stretched string swings", "n/2L sqrt(T/m)", 1, &string, frequency_run},
    {"frequency-cantilever", "a cantilever swings", "cosh cos = -1: 1.8751, 4.6941, 7.8548", 1, &cantilever,
     frequency_run},
    {"frequency-clamped", "a rod clamped at both ends swings", "cosh cos = 1: 4.7300, 7.8532, 10.9956", 1, &clamped,
     frequency_run},
    {"modes-string", "eigenvalues of a stretched string", "n/2L sqrt(T/m)", 1, &string, modes_run},
    {"modes-cantilever", "eigenvalues of a cantilever", "cosh cos = -1: 1.8751, 4.6941, 7.8548", 1, &cantilever,
     modes_run},
    {"modes-clamped", "eigenvalues of a rod clamped at both ends", "cosh cos = 1: 4.7300, 7.8532, 10.9956", 1, &clamped,
     modes_run},
    {"convergence-frequency", "a clamped rod's second mode against segments", "second order", 1, &clamped, order_run},
};
const ValidationGroup frequency_group = VALIDATION_GROUP(cases);
