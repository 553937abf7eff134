/* Models of the environment: triangles, layers and named parts from GLB, STL and DXF files. docs/guide/environment.md.
 */
#ifndef HAWSER_SURVEY_MODEL_H
#define HAWSER_SURVEY_MODEL_H

#include "core/mesh.h"
#include "survey/alignment.h"

/* Patterns have * and ?, as in the shell. A node of a GLB file is matched by its own name or that of one above it, a
 * triangle of a DXF drawing by its layer or a block around it, one of an STL file by its solid's name. */
typedef struct ModelPatterns {
    int n;
    const char **pattern; /* [n] */
} ModelPatterns;

typedef struct ModelOptions {
    double unit;             /* m in the file's unit of length; NAN: as the file says */
    char up;                 /* its axis upward, 'y' or 'z'; 0: as the file says */
    ModelPatterns take;      /* none: all */
    ModelPatterns leave;     /* these are left out */
    ModelPatterns equipment; /* these are marks in place of triangles */
} ModelOptions;

enum { MODEL_SIZE_MOST = 1 << 30, MODEL_JSON_MOST = 64 << 20 }; /* bytes of a file; of the JSON in a GLB file */

/* Reads a file by its content. The mesh is in m with z upward, in the model's own coordinates; equal vertices are one.
 * found: the parts that match `equipment` as marks, with the pattern as layer, "part: NAME" as name, the middle of the
 * box around them and the heading of their own x-axis; and what was left out. Both are the caller's to free. Errors:
 * INPUT ("path: reason"), MEMORY; then nothing is left allocated. */
hawser_status model_read(const char *path, const ModelOptions *options, Mesh *mesh, Survey *found, hawser_error *err);

/* For the readers. Index of the first pattern that the name matches; -1: none. */
int model_match(const ModelPatterns *patterns, const char *name);
/* mesh_add_layer of a file's name: cut, and without characters that cannot be printed. */
int model_layer_add(MeshBuild *build, const char *name);
/* Adds a part: its box from low to high, m. Returns 0 without memory. */
int model_part_add(Survey *found, const char *pattern, const char *name, const double low[3], const double high[3],
                   double heading);

#endif
