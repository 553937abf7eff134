/* SPLINE: a B-spline, rational or not, as points along it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/dxf/dxf.h"

enum { DEGREE_MOST = 15, PARTS = 8, PARTS_MOST = 1024, CONTROLS_MOST = 1 << 20 };
/* m, how far a chord may be beside the spline: the length is then within a millionth. */
static const double OFF = 2e-4;

/* A point with its weight: x w, y w, z w, w. */
typedef struct Weighted {
    double v[4];
} Weighted;

typedef struct Spline {
    int degree, n_knots, n_controls, n_fits;
    double *knot;      /* [n_knots] */
    Weighted *control; /* [n_controls] */
    Vec3 *fit;         /* [n_fits] */
} Spline;

/* How often a code is there. */
static int count(const DxfEntity *e, int code)
{
    int n = 0;
    for (int i = 0; i < e->n; ++i) n += e->number[i].code == code;
    return n;
}

/* The groups one by one; coordinates belong to the control or fit point that was begun last. */
static void fill(Spline *s, const DxfEntity *e)
{
    int knots = 0, controls = 0, fits = 0, weights = 0;
    for (int i = 0; i < e->n; ++i) {
        const double v = e->number[i].value;
        switch (e->number[i].code) {
        case 40:
            s->knot[knots++] = v;
            break;
        case 41:
            if (weights < s->n_controls) s->control[weights++].v[3] = v;
            break;
        case 10:
            s->control[controls++].v[0] = v;
            break;
        case 20:
        case 30:
            if (controls) s->control[controls - 1].v[e->number[i].code / 10 - 1] = v;
            break;
        case 11:
            s->fit[fits++].x = v;
            break;
        case 21:
            if (fits) s->fit[fits - 1].y = v;
            break;
        case 31:
            if (fits) s->fit[fits - 1].z = v;
            break;
        default:
            break;
        }
    }
    for (int i = 0; i < s->n_controls; ++i) {
        double *const c = s->control[i].v;
        if (i >= weights || !(c[3] > 0)) c[3] = 1;
        for (int k = 0; k < 3; ++k) c[k] *= c[3];
    }
}

/* De Boor's algorithm in the span that ends at knot `span + 1`. */
static Vec3 spline_at(const Spline *s, int span, double u)
{
    Weighted d[DEGREE_MOST + 1];
    const int p = s->degree;
    for (int j = 0; j <= p; ++j) d[j] = s->control[span - p + j];
    for (int r = 1; r <= p; ++r) {
        for (int j = p; j >= r; --j) {
            const double low = s->knot[span - p + j], high = s->knot[span + 1 + j - r];
            const double part = high > low ? (u - low) / (high - low) : 0;
            for (int k = 0; k < 4; ++k) d[j].v[k] = (1 - part) * d[j - 1].v[k] + part * d[j].v[k];
        }
    }
    return v3_scale(1 / d[p].v[3], v3(d[p].v[0], d[p].v[1], d[p].v[2]));
}

/* How many chords of a span stay within OFF of it: by the places half-way along them, each time twice as many. */
static int chords_needed(const Spline *s, int span, double unit)
{
    const double from = s->knot[span], step = s->knot[span + 1] - from;
    for (int n = PARTS;; n *= 2) {
        double worst = 0;
        for (int k = 0; k < n; ++k) {
            const Vec3 a = spline_at(s, span, from + step * k / n), b = spline_at(s, span, from + step * (k + 1) / n);
            const Vec3 middle = spline_at(s, span, from + step * (k + 0.5) / n);
            worst = fmax(worst, v3_norm(v3_sub(middle, v3_scale(0.5, v3_add(a, b)))));
        }
        if (n >= PARTS_MOST || !(worst * unit > OFF)) return n;
    }
}

static hawser_status corners_add(const SurveyInput *in, const DxfEntity *e, const Spline *s)
{
    const int p = s->degree;
    DxfCorner *corner = NULL;
    int n = 0;
    hawser_status status = HAWSER_OK;
    for (int i = p; i < s->n_controls && !status; ++i) {
        const double from = s->knot[i], to = s->knot[i + 1];
        if (!(to > from)) continue;
        const int parts = chords_needed(s, i, in->unit);
        DxfCorner *const wider = realloc(corner, (size_t)(n + parts + 1) * sizeof *wider);
        if (!wider) {
            status = error_memory(in->err);
            continue;
        }
        corner = wider;
        memset(corner + n, 0, (size_t)(parts + 1) * sizeof *corner);
        for (int k = n ? 1 : 0; k <= parts; ++k) corner[n++].at = spline_at(s, i, from + (to - from) * k / parts);
    }
    const int before = in->out->n;
    if (!status) status = dxf_add_corners(in, e, n, corner, 0, 1);
    if (!status && in->out->n > before) in->out->alignment[before].bent = s->degree > 1;
    free(corner);
    return status;
}

/* Without control points the fit points are places along the line. */
static hawser_status fits_add(const SurveyInput *in, const DxfEntity *e, const Spline *s)
{
    DxfCorner *const corner = calloc((size_t)s->n_fits + 1, sizeof *corner);
    if (!corner) return error_memory(in->err);
    survey_ignore(in->out, "SPLINE: what is between its fit points, for it has no control points");
    const int before = in->out->n;
    for (int i = 0; i < s->n_fits; ++i) corner[i].at = s->fit[i];
    const hawser_status status = dxf_add_corners(in, e, s->n_fits, corner, 0, 1);
    if (!status && in->out->n > before) {
        in->out->alignment[before].drawn = 0;
        in->out->alignment[before].bent = 1;
    }
    free(corner);
    return status;
}

static int is_rising(const Spline *s)
{
    for (int i = 1; i < s->n_knots; ++i) {
        if (!(s->knot[i] >= s->knot[i - 1])) return 0;
    }
    return 1;
}

hawser_status dxf_add_spline(const SurveyInput *in, const DxfEntity *e)
{
    Spline s = {.degree = (int)fmin(fmax(dxf_number(e, 71, 3), 0), DEGREE_MOST + 1),
                .n_knots = count(e, 40),
                .n_controls = count(e, 10),
                .n_fits = count(e, 11)};
    hawser_status status = HAWSER_OK;
    const int usable = s.degree >= 1 && s.degree <= DEGREE_MOST && s.n_controls > s.degree &&
                       s.n_controls < CONTROLS_MOST && s.n_knots == s.n_controls + s.degree + 1;
    s.knot = calloc((size_t)s.n_knots + 1, sizeof *s.knot);
    s.control = calloc((size_t)s.n_controls + 1, sizeof *s.control);
    s.fit = calloc((size_t)s.n_fits + 1, sizeof *s.fit);
    const int memory = s.knot && s.control && s.fit;
    if (!memory)
        status = error_memory(in->err);
    else
        fill(&s, e);
    if (!status && !(usable && is_rising(&s)) && s.n_fits < 2) {
        status =
            input_error(in, "a SPLINE needs %d control points and knots to its degree, or fit points", s.degree + 1);
    } else if (!status) {
        status = usable && is_rising(&s) ? corners_add(in, e, &s) : fits_add(in, e, &s);
    }
    free(s.knot);
    free(s.control);
    free(s.fit);
    return status;
}
