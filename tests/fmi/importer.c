#include "tests/fmi/importer.h"

#include <dlfcn.h>
#include <expat.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include "tests/support/check.h"

/* ------------------------------------------------------------------------------------------------------- unpacking */

/* "a/b/c" below the folder, with the folders on the way. */
static FILE *file_make(const char *folder, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    for (char *c = path + strlen(folder) + 1; *c; ++c) {
        if (*c != '/') continue;
        *c = 0;
        mkdir(path, 0700);
        *c = '/';
    }
    return fopen(path, "wb");
}

static void unpack(const char *archive, const char *folder)
{
    int code = 0;
    char bytes[65536];
    /* CMake's archive, of the controller, has sizes behind the data, which is no fault but is called one */
    const int strict = strcmp(archive, HAWSER_CONTROLLER) != 0 ? ZIP_CHECKCONS : 0;
    zip_t *const zip = zip_open(archive, ZIP_RDONLY | strict, &code);
    if (!zip) fail_msg("%s is no archive: %d", archive, code);
    for (zip_int64_t k = 0; k < zip_get_num_entries(zip, 0); ++k) {
        const char *const name = zip_get_name(zip, (zip_uint64_t)k, 0);
        if (name[strlen(name) - 1] == '/') continue;
        zip_file_t *const in = zip_fopen_index(zip, (zip_uint64_t)k, 0);
        FILE *const out = file_make(folder, name);
        assert_non_null(in);
        assert_non_null(out);
        for (zip_int64_t n; (n = zip_fread(in, bytes, sizeof bytes)) > 0;) fwrite(bytes, 1, (size_t)n, out);
        zip_fclose(in);
        fclose(out);
    }
    zip_close(zip);
}

/* --------------------------------------------------------------------------------------------------- description */

static const char *attribute(const char **list, const char *name)
{
    for (; *list; list += 2) {
        if (!strcmp(list[0], name)) return list[1];
    }
    return "";
}

static void variable_begin(Fmu *fmu, const char **list)
{
    fmu->variable = realloc(fmu->variable, (size_t)(fmu->n + 1) * sizeof *fmu->variable);
    FmuVariable *const v = &fmu->variable[fmu->n++];
    memset(v, 0, sizeof *v);
    snprintf(v->name, sizeof v->name, "%s", attribute(list, "name"));
    snprintf(v->causality, sizeof v->causality, "%s", attribute(list, "causality"));
    snprintf(v->variability, sizeof v->variability, "%s", attribute(list, "variability"));
    v->reference = (unsigned)strtoul(attribute(list, "valueReference"), NULL, 10);
}

/* In version 3 an element of its own, in version 2 one within. */
static void variable_type(Fmu *fmu, const char *type, const char **list)
{
    FmuVariable *const v = &fmu->variable[fmu->n - 1];
    snprintf(v->type, sizeof v->type, "%s", type);
    snprintf(v->unit, sizeof v->unit, "%s", attribute(list, "unit"));
    snprintf(v->start, sizeof v->start, "%s", attribute(list, "start"));
}

static void element(void *user, const char *name, const char **list)
{
    Fmu *const fmu = user;
    if (!strcmp(name, "fmiModelDescription")) {
        fmu->version = atoi(attribute(list, "fmiVersion"));
        snprintf(fmu->token, sizeof fmu->token, "%s",
                 attribute(list, fmu->version == 2 ? "guid" : "instantiationToken"));
    } else if (!strcmp(name, "CoSimulation")) {
        snprintf(fmu->identifier, sizeof fmu->identifier, "%s", attribute(list, "modelIdentifier"));
        snprintf(fmu->save, sizeof fmu->save, "%s",
                 attribute(list, fmu->version == 2 ? "canGetAndSetFMUstate" : "canGetAndSetFMUState"));
    } else if (!strcmp(name, "DefaultExperiment")) {
        fmu->stop = atof(attribute(list, "stopTime"));
        fmu->step = atof(attribute(list, "stepSize"));
    } else if (!strcmp(name, "ScalarVariable")) {
        variable_begin(fmu, list);
    } else if (fmu->version == 3 && *attribute(list, "causality")) {
        variable_begin(fmu, list);
        variable_type(fmu, name, list);
    } else if (fmu->version == 2 && fmu->n > 0 && !*fmu->variable[fmu->n - 1].type) {
        variable_type(fmu, name, list);
    }
}

static void description_read(Fmu *fmu)
{
    char path[128];
    snprintf(path, sizeof path, "%s/modelDescription.xml", fmu->folder);
    FILE *const f = fopen(path, "rb");
    assert_non_null(f);
    XML_Parser parser = XML_ParserCreate(NULL);
    XML_SetUserData(parser, fmu);
    XML_SetStartElementHandler(parser, element);
    for (int last = 0; !last;) {
        char *const room = XML_GetBuffer(parser, 65536);
        const size_t n = fread(room, 1, 65536, f);
        last = n == 0;
        if (!XML_ParseBuffer(parser, (int)n, last)) fail_msg("%s", XML_ErrorString(XML_GetErrorCode(parser)));
    }
    XML_ParserFree(parser);
    fclose(f);
}

void fmu_open(Fmu *fmu, const char *archive)
{
    char path[256];
    memset(fmu, 0, sizeof *fmu);
    snprintf(fmu->folder, sizeof fmu->folder, "/tmp/hawser fmu XXXXXX"); /* a blank, which addresses must escape */
    assert_non_null(mkdtemp(fmu->folder));
    unpack(archive, fmu->folder);
    description_read(fmu);
    if (fmu->version == 2)
        snprintf(fmu->resources, sizeof fmu->resources, "file:///tmp/hawser%%20fmu%%20%s/resources",
                 fmu->folder + strlen("/tmp/hawser fmu "));
    else
        snprintf(fmu->resources, sizeof fmu->resources, "%s/resources/", fmu->folder);
    snprintf(path, sizeof path, "%s/binaries/%s/%s.so", fmu->folder, fmu->version == 2 ? "linux64" : "x86_64-linux",
             fmu->identifier);
    fmu->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!fmu->library) fail_msg("%s", dlerror());
}

void fmu_close(Fmu *fmu)
{
    char command[128];
    dlclose(fmu->library);
    free(fmu->variable);
    snprintf(command, sizeof command, "rm -rf '%s'", fmu->folder);
    assert_int_equal(system(command), 0);
}

unsigned fmu_find(const Fmu *fmu, const char *name)
{
    for (int i = 0; i < fmu->n; ++i) {
        if (!strcmp(fmu->variable[i].name, name)) return fmu->variable[i].reference;
    }
    fail_msg("no variable '%s'", name);
    return 0;
}

void *fmu_symbol(const Fmu *fmu, const char *name)
{
    void *const at = dlsym(fmu->library, name);
    if (!at) fail_msg("the library has no %s", name);
    return at;
}

/* ----------------------------------------------------------------------------------------------------- instances */

static void keep2(void *host, const char *name, fmi2Status status, const char *category, const char *message, ...)
{
    FmuInstance *const i = host;
    va_list list;
    (void)name, (void)status, (void)category;
    va_start(list, message);
    vsnprintf(i->said, sizeof i->said, message, list);
    va_end(list);
}

static void keep3(void *host, fmi3Status status, const char *category, const char *message)
{
    FmuInstance *const i = host;
    (void)status, (void)category;
    snprintf(i->said, sizeof i->said, "%s", message);
}

void instance_new(FmuInstance *i, const Fmu *fmu, const char *token, const char *resources)
{
    memset(i, 0, sizeof *i);
    i->fmu = fmu;
    if (fmu->version == 2) {
        const fmi2CallbackFunctions calls = {.logger = keep2, .componentEnvironment = i};
        i->c = FMU_CALL(fmu, fmi2Instantiate)("pull", fmi2CoSimulation, token, resources, &calls, fmi2False, fmi2False);
    } else {
        i->c = FMU_CALL(fmu, fmi3InstantiateCoSimulation)("pull", token, resources, false, false, false, false, NULL, 0,
                                                          i, keep3, NULL);
    }
}

/* A call that both versions have alike. */
#define BOTH(i, NAME, ...)                                                                                             \
    ((i)->fmu->version == 2 ? (int)FMU_CALL((i)->fmu, fmi2##NAME)((i)->c __VA_OPT__(, ) __VA_ARGS__)                   \
                            : (int)FMU_CALL((i)->fmu, fmi3##NAME)((i)->c __VA_OPT__(, ) __VA_ARGS__))

void instance_free(FmuInstance *i)
{
    if (i->fmu->version == 2) FMU_CALL(i->fmu, fmi2FreeInstance)(i->c);
    if (i->fmu->version == 3) FMU_CALL(i->fmu, fmi3FreeInstance)(i->c);
    i->c = NULL;
}

int instance_begin(FmuInstance *i, double start)
{
    if (i->fmu->version == 3)
        return (int)FMU_CALL(i->fmu, fmi3EnterInitializationMode)(i->c, false, 0, start, false, 0);
    const int status = (int)FMU_CALL(i->fmu, fmi2SetupExperiment)(i->c, fmi2False, 0, start, fmi2False, 0);
    return status ? status : (int)FMU_CALL(i->fmu, fmi2EnterInitializationMode)(i->c);
}

int instance_settle(FmuInstance *i) { return BOTH(i, ExitInitializationMode); }
int instance_reset(FmuInstance *i) { return BOTH(i, Reset); }
int instance_end(FmuInstance *i) { return BOTH(i, Terminate); }

int instance_step(FmuInstance *i, double t, double h)
{
    i->over = 0;
    if (i->fmu->version == 2) {
        const int status = (int)FMU_CALL(i->fmu, fmi2DoStep)(i->c, t, h, fmi2True);
        fmi2Boolean over = fmi2False;
        if (status == fmi2Discard) FMU_CALL(i->fmu, fmi2GetBooleanStatus)(i->c, fmi2Terminated, &over);
        i->over = over;
        return over ? 0 : status;
    }
    bool event = true, over = false, early = true;
    double reached;
    const int status = (int)FMU_CALL(i->fmu, fmi3DoStep)(i->c, t, h, true, &event, &over, &early, &reached);
    i->over = over;
    assert_false(event || early);
    return status;
}

int instance_set(FmuInstance *i, const char *name, double value)
{
    const unsigned at = fmu_find(i->fmu, name);
    return i->fmu->version == 2 ? (int)FMU_CALL(i->fmu, fmi2SetReal)(i->c, &at, 1, &value)
                                : (int)FMU_CALL(i->fmu, fmi3SetFloat64)(i->c, &at, 1, &value, 1);
}

int instance_switch(FmuInstance *i, const char *name, int on)
{
    const unsigned at = fmu_find(i->fmu, name);
    const bool value = on;
    return i->fmu->version == 2 ? (int)FMU_CALL(i->fmu, fmi2SetBoolean)(i->c, &at, 1, &on)
                                : (int)FMU_CALL(i->fmu, fmi3SetBoolean)(i->c, &at, 1, &value, 1);
}

int instance_real(FmuInstance *i, const char *name, double *value)
{
    const unsigned at = fmu_find(i->fmu, name);
    return i->fmu->version == 2 ? (int)FMU_CALL(i->fmu, fmi2GetReal)(i->c, &at, 1, value)
                                : (int)FMU_CALL(i->fmu, fmi3GetFloat64)(i->c, &at, 1, value, 1);
}

double instance_value(FmuInstance *i, const char *name)
{
    double value = 0;
    if (instance_real(i, name, &value)) fail_msg("%s: %s", name, i->said);
    return value;
}

long instance_count(FmuInstance *i, const char *name)
{
    const unsigned at = fmu_find(i->fmu, name);
    int small = 0;
    int64_t large = 0;
    if (i->fmu->version == 2) {
        assert_int_equal(FMU_CALL(i->fmu, fmi2GetInteger)(i->c, &at, 1, &small), fmi2OK);
        return small;
    }
    if (!strcmp(i->fmu->variable[at].type, "Enumeration")) {
        assert_int_equal(FMU_CALL(i->fmu, fmi3GetInt64)(i->c, &at, 1, &large, 1), fmi3OK);
        return (long)large;
    }
    assert_int_equal(FMU_CALL(i->fmu, fmi3GetInt32)(i->c, &at, 1, &small, 1), fmi3OK);
    return small;
}

const char *instance_text(FmuInstance *i, const char *name)
{
    const unsigned at = fmu_find(i->fmu, name);
    const char *text = NULL;
    const int status = i->fmu->version == 2 ? (int)FMU_CALL(i->fmu, fmi2GetString)(i->c, &at, 1, &text)
                                            : (int)FMU_CALL(i->fmu, fmi3GetString)(i->c, &at, 1, &text, 1);
    assert_int_equal(status, 0);
    return text;
}
