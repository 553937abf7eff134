#include "theory/paper.h"

#include <math.h>

/* Integral of W g (mu cos phi + sin phi) ds along an arc of radius R from slope a to slope b, (T3). With a =
 * -theta1, b = 0 it is the paper's eq. 5. */
static double arc_force(double Wg, double mu, double R, double a, double b)
{
    const double sign = b >= a ? 1 : -1;
    return sign * Wg * R * (mu * (sin(b) - sin(a)) - (cos(b) - cos(a)));
}

double paper_term_path(const PaperTermDef *term)
{
    switch (term->kind) {
    case PAPER_SLOPE:
        return term->length;
    case PAPER_ARC:
        return term->radius * fabs(term->slope_end - term->slope);
    case PAPER_REEL:
    case PAPER_ROPE:
        break;
    }
    return 0;
}

/* The force of the first x metres of a slope or arc, N. (T2), (T3) */
static double path_force(const PaperTermDef *term, double Wg, double mu, double x)
{
    if (term->kind == PAPER_SLOPE) return Wg * x * (mu * cos(term->slope) + sin(term->slope));
    const double turn = copysign(x / term->radius, term->slope_end - term->slope);
    return arc_force(Wg, mu, term->radius, term->slope, term->slope + turn);
}

double paper_term_force(const PaperTermDef *term, double W, double mu, double g)
{
    switch (term->kind) {
    case PAPER_SLOPE:
        return path_force(term, W * g, mu, term->length);
    case PAPER_ARC:
        return arc_force(W * g, mu, term->radius, term->slope, term->slope_end);
    case PAPER_REEL:
    case PAPER_ROPE:
        break;
    }
    return W * g * term->length; /* (T1) */
}

double paper_total(int n, const PaperTermDef *term, double W, double mu, double g)
{
    double sum = 0;
    for (int i = 0; i < n; i++) sum += paper_term_force(&term[i], W, mu, g);
    return sum;
}

double paper_tension(int n, const PaperTermDef *term, double W, double mu, double g, double s)
{
    double tension = 0, left = s > 0 ? s : 0; /* path still to walk */
    for (int i = 0; i < n; i++) {
        const double path = paper_term_path(&term[i]);
        if (term[i].kind == PAPER_REEL || (path > 0 && left >= path)) {
            tension += paper_term_force(&term[i], W, mu, g);
        } else if (path > 0) {
            tension += path_force(&term[i], W * g, mu, left);
        }
        left = left > path ? left - path : 0;
    }
    return tension;
}
