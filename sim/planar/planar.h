/* The chain in a plane, six numbers a segment (core/planar/planar.h), as the integrator sees it: for scenes that
 * plane_find lets through. docs/model.md, "Planar chain". */
#ifndef HAWSER_SIM_PLANAR_PLANAR_H
#define HAWSER_SIM_PLANAR_PLANAR_H

#include "sim/dynamics.h"
#include "sim/planar/planar_newton.h"
#include "sim/planar/planar_scene.h"
#include "sim/step/motion.h"

/* Centres (m) and axes of the segments at some time. */
typedef struct PlanarStand {
    double *p[2], *a[2];
} PlanarStand;

typedef struct Planar {
    Motion motion; /* first: a Motion is the Planar that it begins */
    PlanarScene ps;
    PlanarNewton newton;
    Workspace *ws;                   /* borrowed: candidates, counters, and what sampling reads */
    int middle;                      /* segments before it are the first half's */
    PlanarKinematics kin;            /* of the last evaluation */
    PlanarJointLoads joints;         /* of the last evaluation */
    PlanarLoads loads[PARTS];        /* weight, ends, first half's contacts; second half's contacts */
    PlanarContactModel model[PARTS]; /* the rollers in two halves, as ws->contact */
    PlanarStand at;                  /* at the last refresh of the candidates */
    double (*on_roller)[2];          /* [rollers] N */
    /* which of the candidates are near, by planar_accept (PL19) */
    PlanarStand near;   /* when they were chosen */
    double near_usable; /* m that points of the line may move from there */
    double near_moved;  /* m, at the last accepted step */
    int wide;           /* all candidates count as near */
} Planar;

/* Kinematics of (t, y), ghosts included. */
void planar_place(Planar *p, double t, const double *y);
/* ydot [6 stride] at (t, y); friction scales friction and drag. 0, or 1 if something is not finite. */
int planar_evaluate(Planar *p, double t, const double *y, double friction, double *ydot);
/* The blocks k and d of p->newton at (t, y). */
void planar_blocks(Planar *p, double t, const double *y, double friction);
/* New candidates if `always`, or if the kinematics of the last evaluation are too far from those of the last ones.
 * Errors: MEMORY. */
hawser_status planar_refresh(Planar *p, double t, const double *y, int always, hawser_error *err);
/* After an accepted step to (t, y): new candidates if need be, and those of them that are near (PL19). Errors: MEMORY.
 */
hawser_status planar_accept(Motion *m, double t, const double *y, hawser_error *err);
/* Takes all candidates for near until the next planar_refresh and planar_narrow; or those near (t, y). */
void planar_widen(Planar *p);
void planar_narrow(Planar *p, double t, const double *y);

/* Takes the scene apart in `plane`, which plane_find gave; scene and workspace are borrowed. *motion is the motion to
 * use. Errors: MEMORY, and what linsolver_new says; then nothing is left allocated. */
hawser_status planar_new(Planar *p, const Scene *scene, const Plane *plane, Workspace *ws, const LinOptions *options,
                         hawser_error *err);
void planar_free(Planar *p);

/* As relax_to_equilibrium, for y [6 stride]. Errors: MEMORY. */
hawser_status planar_relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err);

#endif
