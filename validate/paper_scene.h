/* The paper's case as a definition: cases/huangjiahu.yaml in code, which a test holds to the file. */
#ifndef HAWSER_VALIDATE_PAPER_SCENE_H
#define HAWSER_VALIDATE_PAPER_SCENE_H

#include "validate/build.h"

/* What of the case may be changed; zeros: as it is. */
typedef struct PaperChoice {
    double ei;       /* N m2, of the cable */
    double segment;  /* m */
    double accuracy; /* of the integration */
    double v_s;      /* m/s, sliding speed at which friction is full, of rollers and rope drag */
    int rollers;     /* under the 58.5 m */
    double onward;   /* m past the tunnel's end over which the rollers go on, as close */
    double stiffer;  /* times the contacts' stiffness */
    int capsules;    /* the contact line of straight segments in place of the smooth one */
} PaperChoice;

/* Errors: MEMORY. */
hawser_status paper_scene(const PaperChoice *choice, SceneDef *def, hawser_error *err);

#endif
