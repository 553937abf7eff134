/* modelDescription.xml. The two versions say the same in different elements. */
#include <math.h>
#include <stdint.h>

#include "fmi/archive/archive.h"

/* name="value", with what may not stand there escaped. */
static void attribute(Text *t, const char *name, const char *value)
{
    text_print(t, " %s=\"", name);
    text_html(t, value, SIZE_MAX);
    text_add(t, "\"");
}

static void number_attribute(Text *t, const char *name, double value)
{
    if (isfinite(value)) text_print(t, " %s=\"%.17g\"", name, value);
}

static void head_write(const Model *m, hawser_fmi version, const char *title, const char *identifier, Text *t)
{
    const int two = version == HAWSER_FMI_2;
    text_add(t, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription");
    attribute(t, "fmiVersion", two ? "2.0" : "3.0");
    attribute(t, "modelName", title);
    attribute(t, two ? "guid" : "instantiationToken", m->token);
    attribute(t, "description", "A pull of power cable, simulated by hawser");
    text_print(t, " generationTool=\"hawser %s\" variableNamingConvention=\"structured\"", hawser_version());
    text_add(t, two ? " numberOfEventIndicators=\"0\">\n" : ">\n");
    text_add(t, "  <CoSimulation");
    attribute(t, "modelIdentifier", identifier);
    text_add(t, " canHandleVariableCommunicationStepSize=\"true\"");
    if (two) text_add(t, " canNotUseMemoryManagementFunctions=\"true\"");
    attribute(t, two ? "canGetAndSetFMUstate" : "canGetAndSetFMUState", "true");
    attribute(t, two ? "canSerializeFMUstate" : "canSerializeFMUState", "true");
    text_add(t, "/>\n");
}

/* Those that a variable has. */
static void units_write(const Model *m, Text *t)
{
    text_add(t, "  <UnitDefinitions>\n");
    for (int u = 0; u < UNIT_ROWS; ++u) {
        const UnitRow *const unit = &unit_rows[u];
        const int power[] = {unit->kg, unit->m, unit->s, unit->rad};
        static const char *const base[] = {"kg", "m", "s", "rad"};
        int used = 0;
        for (int i = 0; i < m->variables.n; ++i) used |= m->variables.row[i].unit == unit->name;
        if (!used) continue;
        text_print(t, "    <Unit name=\"%s\"><BaseUnit", unit->name);
        for (int k = 0; k < 4; ++k) {
            if (power[k]) text_print(t, " %s=\"%d\"", base[k], power[k]);
        }
        text_add(t, "/></Unit>\n");
    }
    text_add(t, "  </UnitDefinitions>\n");
}

static void types_write(hawser_fmi version, Text *t)
{
    const int two = version == HAWSER_FMI_2;
    text_add(t, "  <TypeDefinitions>\n");
    text_add(t, two ? "    <SimpleType name=\"Verdict\"><Enumeration>\n" : "    <EnumerationType name=\"Verdict\">\n");
    for (int i = 0; i < HAWSER_WORDS; ++i)
        text_print(t, "      <Item name=\"%s\" value=\"%d\"/>\n", hawser_word_text((hawser_word)i), i + 1);
    text_add(t, two ? "    </Enumeration></SimpleType>\n" : "    </EnumerationType>\n");
    text_add(t, "  </TypeDefinitions>\n"
                "  <LogCategories>\n"
                "    <Category name=\"logEvents\" description=\"what is going on\"/>\n"
                "    <Category name=\"logStatusWarning\" description=\"an input that could not be followed\"/>\n"
                "    <Category name=\"logStatusError\" description=\"why a call failed\"/>\n"
                "  </LogCategories>\n");
}

static const char *causality(VariableRole role)
{
    static const char *const names[] = {[ROLE_TIME] = "independent",
                                        [ROLE_PARAMETER] = "parameter",
                                        [ROLE_TUNABLE] = "parameter",
                                        [ROLE_INPUT] = "input",
                                        [ROLE_OUTPUT] = "output"};
    return names[role];
}

static const char *variability(const Variable *row)
{
    if (row->role == ROLE_PARAMETER) return "fixed";
    if (row->role == ROLE_TUNABLE) return "tunable";
    return row->type == VARIABLE_REAL ? "continuous" : "discrete";
}

/* What both versions say of a variable as such. */
static void common_write(const Variable *row, int reference, Text *t)
{
    const int parameter = row->role == ROLE_PARAMETER || row->role == ROLE_TUNABLE;
    attribute(t, "name", row->name);
    text_print(t, " valueReference=\"%d\"", reference);
    attribute(t, "description", row->description);
    attribute(t, "causality", causality(row->role));
    attribute(t, "variability", variability(row));
    if (parameter || row->role == ROLE_OUTPUT) attribute(t, "initial", parameter ? "exact" : "calculated");
}

/* And of its values. */
static void values_write(const Variable *row, Text *t)
{
    const int has_start = row->role != ROLE_OUTPUT && row->role != ROLE_TIME;
    if (row->type == VARIABLE_VERDICT) attribute(t, "declaredType", "Verdict");
    if (row->unit) attribute(t, "unit", row->unit);
    if (has_start && row->type == VARIABLE_REAL) {
        number_attribute(t, "min", row->least);
        number_attribute(t, "max", row->most);
    }
    if (has_start && row->type == VARIABLE_BOOLEAN) attribute(t, "start", row->start > 0.5 ? "true" : "false");
    if (has_start && row->type == VARIABLE_REAL) number_attribute(t, "start", row->start);
}

static void variables_write(const Model *m, hawser_fmi version, Text *t)
{
    static const char *const names2[] = {"Real", "Integer", "Boolean", "String", "Enumeration"};
    static const char *const names3[] = {"Float64", "Int32", "Boolean", "String", "Enumeration"};
    text_add(t, "  <ModelVariables>\n");
    for (int i = 0; i < m->variables.n; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (version == HAWSER_FMI_2) {
            text_add(t, "    <ScalarVariable");
            common_write(row, i, t);
            text_print(t, "><%s", names2[row->type]);
            values_write(row, t);
            text_add(t, "/></ScalarVariable>\n");
        } else {
            text_print(t, "    <%s", names3[row->type]);
            common_write(row, i, t);
            values_write(row, t);
            text_add(t, "/>\n");
        }
    }
    text_add(t, "  </ModelVariables>\n");
}

/* Outputs depend on no input of the same time, for inputs act from the next step on: importers find no algebraic loop.
 * All outputs are unknown at first; what they depend on then is not said, so it may be anything. Version 2.0 counts the
 * variables from 1. */
static void structure_write(const Model *m, hawser_fmi version, Text *t)
{
    static const char *const lists2[] = {"Outputs", "InitialUnknowns"}, *const items3[] = {"Output", "InitialUnknown"};
    const int two = version == HAWSER_FMI_2;
    text_add(t, "  <ModelStructure>\n");
    for (int k = 0; k < 2; ++k) {
        if (two) text_print(t, "    <%s>\n", lists2[k]);
        for (int i = 0; i < m->variables.n; ++i) {
            if (m->variables.row[i].role != ROLE_OUTPUT) continue;
            const char *const known = k == 0 ? " dependencies=\"\"" : "";
            if (two) text_print(t, "      <Unknown index=\"%d\"%s/>\n", i + 1, known);
            if (!two) text_print(t, "    <%s valueReference=\"%d\"%s/>\n", items3[k], i, known);
        }
        if (two) text_print(t, "    </%s>\n", lists2[k]);
    }
    text_add(t, "  </ModelStructure>\n</fmiModelDescription>\n");
}

void description_write(const Model *m, hawser_fmi version, const char *title, const char *identifier, Text *out)
{
    head_write(m, version, title, identifier, out);
    units_write(m, out);
    types_write(version, out);
    text_print(out, "  <DefaultExperiment startTime=\"0\" stopTime=\"%.17g\"", m->duration);
    if (m->interval > 0) text_print(out, " stepSize=\"%.17g\"", m->interval);
    text_add(out, "/>\n");
    variables_write(m, version, out);
    structure_write(m, version, out);
}
