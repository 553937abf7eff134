/* The parts of a surface's way. docs/model.md, "Surfaces". Used by surface_patch.c. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_WAY_H
#define HAWSER_CONTACT_SURFACE_SURFACE_WAY_H

#include "contact/surface/surface_patch.h"

/* m: how far the arcs of a duct or tray may lie beside a curve of the route. */
#define SURFACE_WAY_OFF 5e-5

enum { SURFACE_WAY_MAX = 2 };

/* The part of the way that begins at *s and ends at `last` or before: patches without a section, each of whose ends is,
 * to the last bit, where the next one starts. Moves *s to the part's end. rolls: the section has a top, and needs the
 * roll that keeps it level. Returns how many patches: two arcs for a part of a curve, else one. */
int surface_way(const Route *route, double *s, double last, int rolls, SurfacePatch way[SURFACE_WAY_MAX]);

#endif
