/* What stands around the cable, as the public interface shows it: made once, when somebody asks. */
#ifndef HAWSER_SIM_PICTURE_AROUND_H
#define HAWSER_SIM_PICTURE_AROUND_H

#include "sim/picture/geometry.h"

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
