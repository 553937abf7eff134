/* How a position's chain lies beside its route, from which the next one's begins. docs/model/44-positions.md (PS8),
 * (PS10), (PS13). */
#ifndef HAWSER_SIM_STAGE_LIE_H
#define HAWSER_SIM_STAGE_LIE_H

#include "sim/newton/presumption.h"
#include "sim/stage/stage.h"

typedef struct Lie {
    int n;              /* segments; 0: nothing is known yet */
    int faces, patches; /* of the scene's equipment */
    int first, eye;     /* number of segment 0 in the whole chain; joint of the pulling eye, from there */
    double travel;      /* m, of the winch then */
    double *memory;     /* of what follows */
    double *s;          /* [n] m along the route, of segments' centres as they would be laid, rising */
    Vec3 *shift, *turn; /* [n] m, rad: from there */
    Quat *frame;        /* [n] attitudes as they would be laid */
    Pressed pressed;
} Lie;

/* m along the route, where the centre of segment i would be laid when the winch has hauled in `travel`. */
double lie_centre(const Scene *scene, int i, double travel);
/* Takes the stage's state for the chain of `travel`, m. Errors: MEMORY; lie_free may follow either way. */
hawser_status lie_keep(Lie *lie, Stage *st, double travel, hawser_error *err);
/* Moves the chain that has been laid in the stage's state for `travel` to where the last position's lay: place by
 * place, and near the front segment by segment. */
void lie_apply(const Lie *lie, Stage *st, double travel);
/* A copy of its own, in place of nothing; lie_free follows either way. Errors: MEMORY. */
hawser_status lie_copy(const Lie *lie, Lie *out, hawser_error *err);
void lie_checkpoint(Checkpoint *c, Lie *lie, const Scene *scene);
void lie_free(Lie *lie);

#endif
