#include "def/winding.h"

#include <math.h>
#include <stddef.h>

/* One layer: number k, where it begins (m of cable below it), its radius and the length of one turn. */
typedef struct Layer {
    int k;
    double from, radius, turn;
} Layer;
enum { LAYERS_MOST = 1000000 }; /* more are of a length that an iteration tries in vain */

/* Length of cable in the layers below number k (RL2). */
static double layers_below(const Winding *w, double k)
{
    return 2 * M_PI * w->turns * (k * w->barrel + k * k * w->pitch / 2);
}

static Layer layer_number(const Winding *w, int k)
{
    Layer l = {.k = k, .from = layers_below(w, k), .radius = w->barrel + (k + 0.5) * w->pitch};
    l.turn = 2 * M_PI * l.radius;
    return l;
}

/* The layer in which the cable lies `length` m from its inner end: (RL2) solved for k. */
static Layer layer_at(const Winding *w, double length)
{
    const double x = fmax(length, 0) / (2 * M_PI * w->turns);
    const double layers = (sqrt(w->barrel * w->barrel + 2 * w->pitch * x) - w->barrel) / w->pitch;
    const int k = (int)fmin(layers, LAYERS_MOST);
    Layer l = layer_number(w, k);
    /* rounding may have missed by one at a layer's very end */
    if (l.k > 0 && length < l.from) l = layer_number(w, k - 1);
    return l;
}

/* Share of the climb that is done at u m into the layer: the first turn of every layer but the lowest rises (RL3). */
static double climb_at(const Layer *l, double u) { return l->k > 0 && u < l->turn ? u / l->turn : 1; }

double winding_turns(double width, double diameter) { return floor(width / diameter * (1 + 1e-12)); }

double winding_capacity(const Winding *w, double flange)
{
    const double layers = floor((flange - w->barrel) / w->pitch * (1 + 1e-12));
    return layers > 0 ? layers_below(w, layers) : 0;
}

double winding_radius(const Winding *w, double length, double *slope)
{
    const Layer l = layer_at(w, length);
    const double climb = climb_at(&l, length - l.from);
    if (slope) *slope = climb < 1 ? w->pitch / l.turn : 0;
    return l.radius - w->pitch * (1 - climb);
}

/* Integral of the radius squared over the first u m of a layer (RL5). */
static double layer_square(const Winding *w, const Layer *l, double u)
{
    const double c = climb_at(l, u), r = l->radius, p = w->pitch;
    if (l->k == 0) return r * r * u;
    /* over the climb r - p (1 - c), then r */
    const double climbing = l->turn * (r * r * c - r * p * (2 * c - c * c) + p * p * (c - c * c + c * c * c / 3));
    return climbing + r * r * fmax(u - l->turn, 0);
}

double winding_inertia(const Winding *w, double length)
{
    const Layer top = layer_at(w, length);
    double square = layer_square(w, &top, fmax(length, 0) - top.from);
    for (int k = 0; k < top.k; ++k) {
        const Layer l = layer_number(w, k);
        square += layer_square(w, &l, w->turns * l.turn);
    }
    return w->inertia + w->line_mass * square;
}

/* Angle turned over the first u m of a layer: integral of 1/radius. */
static double layer_angle(const Winding *w, const Layer *l, double u)
{
    const double c = climb_at(l, u), low = l->radius - w->pitch;
    if (l->k == 0) return u / l->radius;
    return l->turn / w->pitch * log1p(w->pitch * c / low) + fmax(u - l->turn, 0) / l->radius;
}

WindingPoint winding_point(const Winding *w, double length)
{
    const Layer top = layer_at(w, length);
    const double u = fmax(length, 0) - top.from, span = (w->turns - 1) * w->pitch;
    const double along = fmin(u / (w->turns * top.turn), 1) - 0.5; /* every other layer goes back */
    WindingPoint p = {.radius = winding_radius(w, length, NULL), .across = top.k % 2 ? -along * span : along * span};
    p.angle = layer_angle(w, &top, u);
    for (int k = 0; k < top.k; ++k) {
        const Layer l = layer_number(w, k);
        p.angle += layer_angle(w, &l, w->turns * l.turn);
    }
    return p;
}
