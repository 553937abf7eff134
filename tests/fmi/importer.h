/* An importer of FMUs for tests: unpacks the archive, reads its description, loads its library. It knows the standard,
 * and nothing of hawser. */
#ifndef HAWSER_TESTS_FMI_IMPORTER_H
#define HAWSER_TESTS_FMI_IMPORTER_H

#include <stddef.h>

#include "fmi/fmi2.h"
#include "fmi/fmi3.h"

typedef struct FmuVariable {
    char name[128], causality[32], variability[32], type[32], unit[16], start[64];
    unsigned reference;
} FmuVariable;

typedef struct Fmu {
    int version; /* 2 or 3 */
    char folder[64], resources[128];
    char identifier[80], token[64], save[8];
    double stop, step; /* s, of the default experiment */
    int n;
    FmuVariable *variable; /* [n] */
    void *library;
} Fmu;

/* Unpacks and loads; the test fails if that cannot be done. */
void fmu_open(Fmu *fmu, const char *archive);
void fmu_close(Fmu *fmu);
/* The reference of a variable; the test fails if there is none of the name. */
unsigned fmu_find(const Fmu *fmu, const char *name);
void *fmu_symbol(const Fmu *fmu, const char *name);
/* A function of the standard, with its type: FMU_CALL(fmu, fmi2DoStep)(c, t, h, fmi2True). */
#define FMU_CALL(fmu, function) ((__typeof__(&function))(size_t)fmu_symbol(fmu, #function))

/* An instance of either version, for tests that are about neither. All return the status. */
typedef struct FmuInstance {
    const Fmu *fmu;
    void *c;
    char said[1024]; /* the last message */
    int over;        /* the last step was to be the last */
} FmuInstance;

void instance_new(FmuInstance *i, const Fmu *fmu, const char *token, const char *resources);
void instance_free(FmuInstance *i);
/* Begins at `start`; between: parameters may be set. */
int instance_begin(FmuInstance *i, double start);
int instance_settle(FmuInstance *i);
int instance_step(FmuInstance *i, double t, double h);
int instance_reset(FmuInstance *i);
int instance_end(FmuInstance *i);
int instance_set(FmuInstance *i, const char *name, double value);
int instance_switch(FmuInstance *i, const char *name, int on);
int instance_real(FmuInstance *i, const char *name, double *value);
/* The test fails unless there is a value. */
double instance_value(FmuInstance *i, const char *name);
long instance_count(FmuInstance *i, const char *name); /* integers and choices */
const char *instance_text(FmuInstance *i, const char *name);

#endif
