/* The chain in a plane, six numbers a segment (core/planar/planar.h), as the integrator sees it: for scenes that
 * plane_find lets through. docs/model.md, "Planar chain". */
#ifndef HAWSER_SIM_PLANAR_PLANAR_H
#define HAWSER_SIM_PLANAR_PLANAR_H

#include "sim/planar/planar_dynamics.h"

/* Takes the scene apart in `plane`, which plane_find gave; scene and workspace are borrowed. *motion is the motion to
 * use. Errors: MEMORY, and what linsolver_new says; then nothing is left allocated. */
hawser_status planar_new(Planar *p, const Scene *scene, const Plane *plane, Workspace *ws, const LinOptions *options,
                         hawser_error *err);
void planar_free(Planar *p);

#endif
