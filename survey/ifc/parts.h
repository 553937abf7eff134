/* What the parts of the IFC reader share: a file with its units and its nesting, small entities. */
#ifndef HAWSER_SURVEY_IFC_PARTS_H
#define HAWSER_SURVEY_IFC_PARTS_H

#include "survey/ifc/step.h"

/* Part number `order` of a whole. */
typedef struct IfcNest {
    long whole, part;
    int order;
} IfcNest;

typedef struct IfcFile {
    StepFile step;
    double angle; /* rad in the file's unit of angle */
    long cant;    /* the IfcAlignmentCant of the alignment that is read; 0: none */
    int n_nests;
    IfcNest *nest; /* [n_nests], by whole and order */
} IfcFile;

/* The first of a whole's parts in file->nest; *n of them, 0: none. */
const IfcNest *ifc_parts(const IfcFile *file, long whole, int *n);

/* A point or direction's coordinates, in the file's numbers; missing ones are 0; *given: how many it has, NULL: not
 * asked for. Errors: as step_entity, and INPUT if it has fewer than two. */
hawser_status ifc_triple(const IfcFile *file, long id, Vec3 *out, int *given);
/* A placement in a plane: where its origin lies and which way its x-axis points; of one in space the plan, z of the
 * origin kept. *tilted is set if its z-axis is not upright. */
hawser_status ifc_axes(const IfcFile *file, long id, Vec3 *origin, Vec3 *x_axis, int *tilted);

/* Segments of 4.3's business logic and of 4x1's curves: adds one to the alignment. e: the entity of the segment. */
hawser_status ifc_horizontal_segment(const IfcFile *file, const StepEntity *e, Alignment *a);
hawser_status ifc_vertical_segment(const IfcFile *file, const StepEntity *e, Alignment *a);
/* 4x1: from the axis of an alignment, an IfcAlignmentCurve. */
hawser_status ifc_axis(const IfcFile *file, long id, Alignment *a);
/* From the curves that it is drawn with: an IfcProductDefinitionShape. Nothing is added if there are none that are
 * known. */
hawser_status ifc_shape(const IfcFile *file, long id, Alignment *a);

/* Curvature of a transition as a function of the length u on its parent, m: a polynomial, a cosine and a sine (AL9).
 * The segment begins at u = from and runs to from + side length. */
enum { IFC_LAW_TERMS = 8 };
typedef struct IfcLaw {
    double term[IFC_LAW_TERMS]; /* of u^i, 1/m^(i+1) */
    double cosine, sine;        /* 1/m, of pi u/period and of 2 pi u/period */
    double period;              /* m */
    double from, side, length;  /* m; 1 or -1; m, >= 0 */
} IfcLaw;
/* The segment from the place and heading of `start` on, as clothoids 0.01 mm off at most. */
hawser_status ifc_add_law(const IfcFile *file, Alignment *a, PlanElement start, const IfcLaw *w);
/* A transition by its type, from e's place with curvature k0 to k1 over its length. sway, m: of a Viennese bend the
 * height of the centre of gravity times the change of the cant's angle. 0: no such type; then nothing is added. */
int ifc_add_transition(const IfcFile *file, Alignment *a, const StepValue *type, double sway, PlanElement e,
                       hawser_status *status);

/* An element with its length checked: shorter than 1e-9 m is left out. */
hawser_status ifc_add_plan(const IfcFile *file, Alignment *a, PlanElement e);
hawser_status ifc_add_profile(const IfcFile *file, Alignment *a, ProfileElement e);

#endif
