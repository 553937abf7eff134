/* Details of one moment: every contact that carries force, and the cable joint by joint; also the surroundings, as the
 * public interface shows them. It is computed on request between two steps; no step or row depends on it. */
#ifndef HAWSER_SIM_RUN_CLOSEUP_H
#define HAWSER_SIM_RUN_CLOSEUP_H

#include "sim/dynamics.h"
#include "sim/run/geometry.h"

/* Results of the last call; owned. */
typedef struct Closeup {
    int n_contacts, contacts_room;
    hawser_contact *contact;   /* [n_contacts] */
    hawser_cable_point *joint; /* [chain.n + 1] */
} Closeup;

/* Finds the contacts for the kinematics in the workspace, after a dynamics_look; the workspace's loads become scratch.
 * Errors: MEMORY. */
hawser_status closeup_contacts(Closeup *c, const Scene *scene, Workspace *ws, double t, hawser_error *err);
/* sample: of the same moment, including its fields. Errors: MEMORY. */
hawser_status closeup_cable(Closeup *c, const Scene *scene, Workspace *ws, const hawser_sample *sample,
                            hawser_error *err);
void closeup_free(Closeup *c);
/* The surroundings, computed once. */
typedef struct Around {
    Geometry from; /* owns the data to which the rows point */
    hawser_geometry shown;
    hawser_roller_shape *roller;
    hawser_surface_shape *surface;
    hawser_conveyor_shape *conveyor;
} Around;

/* Returns NULL with an error: MEMORY. */
Around *around_new(const Scene *scene, hawser_error *err);
Around *around_free(Around *a);

#endif
