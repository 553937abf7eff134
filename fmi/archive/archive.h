/* The parts of an FMU's archive. */
#ifndef HAWSER_FMI_ARCHIVE_ARCHIVE_H
#define HAWSER_FMI_ARCHIVE_ARCHIVE_H

#include "fmi/model/model.h"
#include "io/report/text.h"
#include "io/yaml/yaml_tree.h"

/* modelDescription.xml of a version. identifier: the name of the library without its ending, a name of C's. */
void description_write(const Model *m, hawser_fmi version, const char *title, const char *identifier, Text *out);

/* documentation/index.html: what the unit is, its variables as tables. */
void documentation_write(const Model *m, hawser_fmi version, const char *title, Text *out);

/* A file that the case refers to. */
typedef struct ResourceFile {
    char *path; /* owned; where it is */
    char *name; /* owned; among the resources */
} ResourceFile;

enum { RESOURCE_FILES_MAX = 3 };
typedef struct Resources {
    Text text; /* of the case: nothing is left of catalogue and included files but what they have brought */
    int n;
    ResourceFile file[RESOURCE_FILES_MAX];
} Resources;

/* Errors: INPUT (a name of the catalogue or an included file is wrong), MEMORY. resources_clear must follow. */
hawser_status resources_make(const CaseTree *tree, Resources *out, hawser_error *err);
void resources_clear(Resources *r);

/* A node with all below it as YAML, each text as it was: in quotes where it could be taken for something else. */
void yaml_write(const CaseNode *node, int depth, Text *out);

#endif
