/* A close look at the moment: every contact that carries force, and the cable joint by joint; and what stands around
 * it, as the public interface shows it. For who asks between two steps; nothing of a step or a row does. */
#ifndef HAWSER_SIM_RUN_CLOSEUP_H
#define HAWSER_SIM_RUN_CLOSEUP_H

#include "sim/dynamics.h"
#include "sim/run/geometry.h"

/* What was found last; owned. */
typedef struct Closeup {
    int n_contacts, contacts_room;
    hawser_contact *contact;   /* [n_contacts] */
    hawser_cable_point *joint; /* [chain.n + 1] */
} Closeup;

/* For the kinematics in the workspace, which a look has just put there, and whose loads become scratch. Errors: MEMORY.
 */
hawser_status closeup_contacts(Closeup *c, const Scene *scene, Workspace *ws, double t, hawser_error *err);
/* sample: of the same moment, with its fields. Errors: MEMORY. */
hawser_status closeup_cable(Closeup *c, const Scene *scene, Workspace *ws, const hawser_sample *sample,
                            hawser_error *err);
void closeup_free(Closeup *c);
/* Made once. */
typedef struct Around {
    Geometry from; /* owns what the rows point to */
    hawser_geometry shown;
    hawser_roller_shape *roller;
    hawser_surface_shape *surface;
    hawser_conveyor_shape *conveyor;
} Around;

/* NULL with an error: MEMORY. */
Around *around_new(const Scene *scene, hawser_error *err);
Around *around_free(Around *a);

#endif
