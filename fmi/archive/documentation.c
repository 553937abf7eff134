/* documentation/index.html, which importers show: what is simulated, how to step it, and every variable in words. */
#include <math.h>
#include <stdint.h>

#include "fmi/archive/archive.h"

static void cell(Text *t, const char *text)
{
    text_add(t, "<td>");
    text_html(t, text, SIZE_MAX);
    text_add(t, "</td>");
}

/* All variables of the roles between two, as one table. */
static void table_write(const Model *m, const char *heading, VariableRole first, VariableRole last, Text *t)
{
    int n = 0;
    for (int i = 0; i < m->variables.n; ++i) {
        const Variable *const row = &m->variables.row[i];
        if (row->role < first || row->role > last) continue;
        if (n++ == 0)
            text_print(t, "<h2>%s</h2>\n<table><tr><th>name</th><th>start</th><th>unit</th><th>meaning</th></tr>\n",
                       heading);
        text_add(t, "<tr>");
        cell(t, row->name);
        if (row->role == ROLE_OUTPUT || row->role == ROLE_TIME) {
            cell(t, "");
        } else if (row->type == VARIABLE_BOOLEAN) {
            cell(t, row->start > 0.5 ? "true" : "false");
        } else {
            text_print(t, "<td>%.10g</td>", row->start);
        }
        cell(t, row->unit ? row->unit : "");
        cell(t, row->description);
        text_add(t, "</tr>\n");
    }
    if (n > 0) text_add(t, "</table>\n");
}

void documentation_write(const Model *m, hawser_fmi version, const char *title, Text *t)
{
    text_add(t, "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>");
    text_html(t, title, SIZE_MAX);
    text_add(
        t,
        "</title><style>body{font-family:sans-serif;max-width:60em;margin:2em auto}table{border-collapse:collapse}"
        "td,th{border:1px solid #aaa;padding:.2em .5em;text-align:left;vertical-align:top}</style></head><body>\n<h1>");
    text_html(t, title, SIZE_MAX);
    text_print(t,
               "</h1>\n<p>A pull of power cable, simulated by hawser %s; FMI %s, co-simulation. All values are in SI "
               "units.</p>\n<ul>\n",
               hawser_version(), version == HAWSER_FMI_2 ? "2.0" : "3.0");
    text_add(
        t, "<li>Steps may have any length; the simulation takes as many of its own as it needs. An input acts from the "
           "next step on, over the time of inputs.ramp: no output depends on an input at the same time.</li>\n"
           "<li>A step that the winch ends before its time is the last one.</li>\n"
           "<li>The parameters below case. are fixed when the initialization ends.</li>\n"
           "<li>A number that there is none of is NaN.</li>\n"
           "<li>The case itself is resources/case.yaml; the licences of what is inside are in "
           "<a href=\"licenses/license.txt\">licenses/license.txt</a>.</li>\n</ul>\n");
    table_write(m, "Inputs", ROLE_INPUT, ROLE_INPUT, t);
    table_write(m, "Outputs", ROLE_OUTPUT, ROLE_OUTPUT, t);
    table_write(m, "Parameters", ROLE_PARAMETER, ROLE_TUNABLE, t);
    text_add(t, "</body></html>\n");
}
