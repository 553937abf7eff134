/* A case as an FMU has it: its text with everything that it refers to, its variables and a simulation of it. */
#ifndef HAWSER_FMI_MODEL_MODEL_H
#define HAWSER_FMI_MODEL_MODEL_H

#include <stdlib.h>

#include "core/base/error.h"
#include "fmi/model/variables.h"

/* The name of the case among an FMU's resources. */
#define MODEL_CASE "case.yaml"

typedef struct Model {
    char *text;   /* owned; of the case */
    char *folder; /* owned; where the files are that it refers to */
    Variables variables;
    char token[TOKEN_SIZE];
    double interval, duration; /* s: between samples of the statistics; of the run */
} Model;

/* Takes the text over (also if it fails) and copies the folder. *sim (may be NULL) gets the simulation that was built
 * for it, not relaxed. Errors: INPUT, MEMORY; *out is cleared then. */
hawser_status model_make(char *text, const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
/* The same from the file MODEL_CASE of a folder. */
hawser_status model_load(const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
void model_clear(Model *m);

/* A simulation of the case with other parameters: value[n of variables]. Errors: INPUT (says which value cannot be),
 * MEMORY. */
hawser_status model_build(const Model *m, const double *value, hawser_sim **sim, hawser_error *err);

#endif
