#include "def/winding.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "core/error.h"

/* One layer: its number k, its start (length of cable below it, m), its radius and the length of one turn. */
typedef struct Layer {
    int k;
    double from, radius, turn;
} Layer;

enum { LAYERS_MOST = 1000000 }; /* a larger number belongs to a failed iterate */

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

/* The layer of the cable `length` m from its inner end: (RL2) solved for k. */
static Layer layer_at(const Winding *w, double length)
{
    const double x = fmax(length, 0) / (2 * M_PI * w->turns);
    const double layers = (sqrt(w->barrel * w->barrel + 2 * w->pitch * x) - w->barrel) / w->pitch;
    const int k = (int)fmin(layers, LAYERS_MOST);
    Layer l = layer_number(w, k);
    /* rounding may shift the number by one at a layer's end */
    if (l.k > 0 && length < l.from) l = layer_number(w, k - 1);
    return l;
}

/* Completed share of the climb at u m into the layer: the first turn of every layer but the lowest rises (RL3). */
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

/* Angle of the first u m of a layer: integral of 1/radius. */
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
    const double along = fmin(u / (w->turns * top.turn), 1) - 0.5; /* every other layer runs back */
    WindingPoint p = {.radius = winding_radius(w, length, NULL), .across = top.k % 2 ? -along * span : along * span};
    p.angle = layer_angle(w, &top, u);
    for (int k = 0; k < top.k; ++k) {
        const Layer l = layer_number(w, k);
        p.angle += layer_angle(w, &l, w->turns * l.turn);
    }
    return p;
}

/* Spacing of turns and layers in diameters: the cable leaves at a right angle to the axis, the turn before it does not.
 */
static const double LAY = 1.03;

/* The lay for a drum and a cable of this diameter. */
static Lay lay_of(const DrumDef *d, double diameter)
{
    Lay lay = {.first = (d->barrel + diameter) / 2, .diameter = diameter};
    lay.pitch = d->lay > 0 ? d->lay : LAY * diameter;
    lay.turns = floor((d->width - 2 * diameter) / lay.pitch * (1 + 1e-9));
    return lay;
}

/* Number of turns that the lay holds: two layers, and the part of the third that stays away from the second's first
 * turns, which protrude where they cross the turn below. */
static double lay_capacity(const Lay *lay) { return 2 * lay->turns + 3 + fmax(0, lay->turns - 5); }

/* Computes radius and lateral place after a number of turns. Each layer above the lowest begins with a turn that climbs
 * round the last one and a turn back over that; then turns lie side by side to the other flange (CC23). */
static void lay_at(const Lay *lay, double turn, double *radius, double *across)
{
    const double edge = lay->turns * lay->pitch / 2, past = fmax(turn - lay->turns, 0);
    const double layer = floor(past / (lay->turns + 1)), in = past - layer * (lay->turns + 1);
    const double side = fmod(layer, 2) > 0.5 ? -1 : 1;
    double up = layer, over = -1; /* pitches above the lowest layer, and past the edge */
    if (turn < lay->turns) {
        /* the end protrudes straight, where higher layers would meet it: it begins a diameter off */
        *radius = lay->first;
        *across = lay->pitch * turn - edge - lay->diameter * fmax(1 - 2 * turn, 0);
        return;
    }
    if (in < 1) {
        up += sin(M_PI / 2 * in);
        over += in + cos(M_PI / 2 * in);
    } else if (in < 2) {
        const double a = M_PI / 2 * (in - 1);
        up += sin(a) + cos(a);
        over += in - 1 + cos(a) - sin(a);
    } else {
        up += 1;
        over -= in - 2;
    }
    *radius = lay->first + lay->pitch * up;
    *across = side * (edge + lay->pitch * over);
}

Vec3 lay_joint(const Lay *lay, double angle, double h)
{
    double radius, across;
    lay_at(lay, angle / (2 * M_PI), &radius, &across);
    const double out = sqrt(radius * radius + h * h / 4);
    return v3(across, out * sin(angle), out * cos(angle));
}

/* Angle of the next joint, one chord of length h farther. */
static double angle_next(const Lay *lay, double angle, double h)
{
    const Vec3 from = lay_joint(lay, angle, h);
    double radius, across, low = angle;
    lay_at(lay, angle / (2 * M_PI), &radius, &across);
    double high = angle + 2 * atan(h / radius);
    for (int it = 0; it < 60; ++it) {
        const double middle = (low + high) / 2;
        if (v3_norm(v3_sub(lay_joint(lay, middle, h), from)) < h) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

/* Checks whether turns, layers and the path to the route fit; turns: number wound. */
static hawser_status fit_check(const SceneDef *def, const Lay *lay, double turns, int wound, hawser_error *err)
{
    const DrumDef *const d = &def->drum;
    double radius = 0, across;
    lay_at(lay, turns, &radius, &across);
    if (wound < 2) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel: no cable is left for the drum: the chain ends %.4g m behind the route's start or nearer",
            d->distance);
    }
    if (lay->turns < 2) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel.width: %.4g m is too narrow: a layer has two turns at least, with room for two beside, %.4g m",
            d->width, 2 * lay->pitch + 2 * lay->diameter);
    }
    if (turns > lay_capacity(lay)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "reel.width: more cable than fits: %.4g turns of %.4g m cable, the contact model holds %.4g",
                         turns, lay->diameter, lay_capacity(lay));
    }
    if (2 * radius + lay->diameter > d->flange) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel.flange: more cable than fits: the top layer reaches a diameter of %.4g m, the flange %.4g m",
            2 * radius + lay->diameter, d->flange);
    }
    if (d->distance > d->flange / 2) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "reel.distance: %.4g m is out of range: must be above the flange's radius, %.4g m", d->distance,
                     d->flange / 2);
}

hawser_status wound_lay(const SceneDef *def, int n, const double *half, const double *joint_s, Wound *out,
                        hawser_error *err)
{
    const Lay lay = lay_of(&def->drum, def->cables[def->pieces[0].cable].diameter);
    int wound = 0; /* the first joint off the drum: the last one at or behind the place where the cable leaves */
    while (wound < n && joint_s[wound + 1] <= -def->drum.distance) ++wound;
    *out = (Wound){.lay = lay, .joints = wound, .radius = lay.first};
    double *const angle = out->angle = calloc((size_t)wound + 1, sizeof *angle);
    if (!angle) return error_memory(err);
    for (int j = 1; lay.turns >= 2 && j < wound; ++j) angle[j] = angle_next(&lay, angle[j - 1], 2 * half[j - 1]);
    if (wound > 0) {
        out->half = half[wound - 1];
        out->last = angle[wound - 1];
    }
    if (lay.turns >= 2) lay_at(&lay, out->last / (2 * M_PI), &out->radius, &out->across);
    out->last += atan(out->half / out->radius);
    return fit_check(def, &lay, out->last / (2 * M_PI), wound, err);
}
