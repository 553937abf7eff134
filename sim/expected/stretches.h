/* What theory reckons with along a scene's route: the friction of the case and that of its ducts and trays, and where
 * weight and turning force rest on supports of their own. docs/model.md, "Separate supports". */
#ifndef HAWSER_SIM_EXPECTED_STRETCHES_H
#define HAWSER_SIM_EXPECTED_STRETCHES_H

#include "sim/scene.h"
#include "theory/pulling.h"

typedef struct Stretches {
    int n;
    PullStretch *stretch; /* [n] owned, by rising `from`; the first one begins far behind the route */
} Stretches;

/* Of all cables together. Supports are separate where guide rollers stand in a bend to the side and in trays with
 * upright sides. Errors: MEMORY. */
hawser_status stretches_find(const Scene *scene, Stretches *out, hawser_error *err);
void stretches_free(Stretches *s);
/* Makes a stretch begin at s, m, if none does; the array must have room for one more. */
void stretches_cut(Stretches *stretches, double s);

/* Whether a roller of a row stands upright beside the cable: its axis is nearer to the route's upward normal than to
 * the level. */
int roller_is_guide(const Route *route, const RollerDef *roller);
/* The same of any roller, beside the cable at s, m along the route. */
int roller_guides_at(const Route *route, const RollerDef *roller, double s);
/* On which side of a bend something stands that lies `off` (m, or unit) the route, by the bend's curvature (1/m): 1, on
 * the inner one, where the cable is pressed on it; -1, on the outer; 0, on neither. */
int bend_side(Vec3 off, Vec3 curvature);
/* The surface along the route at s, NULL if there is none. */
const SurfaceDef *surface_at(const SceneDef *def, double s);

/* A roller that the rope may run on. */
typedef struct Turner {
    double s, across; /* m along the route; its diameter, m */
    int inner;        /* 1: the bend there presses the rope on it, 0: neither on it nor away from it, -1: away */
    int carries;      /* neither upright nor a hold-down */
    int roller;       /* of the case */
    Vec3 off;         /* unit, from the route to it */
} Turner;

/* All of them by rising s, malloc'ed, the caller's even after an error. Errors: MEMORY. */
hawser_status turners_find(const Scene *scene, const Route *route, int *n, Turner **found, hawser_error *err);

#endif
