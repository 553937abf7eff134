/* The simulation behind the desk: what it will take, and a run in the folder /run, whose report's page becomes
 * /report.html. The page's program and style are files that the desk has put into /web. */
#include <emscripten.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/report/report.h"
#include "web/engine/desk.h"

/* ------------------------------------------------------------------------------------------------- the report's page
 */

/* A file as it is in memory, read once. */
static Bundle bundle_of(const char *path)
{
    Bundle bundle = {"", 0};
    size_t size = 0;
    char *const text = file_text(path, &size);
    if (text) bundle = (Bundle){text, size};
    return bundle;
}

Bundle bundle_script(void)
{
    static Bundle script;
    if (!script.at) script = bundle_of("/web/report.js");
    return script;
}

Bundle bundle_style(void)
{
    static Bundle style;
    if (!style.at) style = bundle_of("/web/report.css");
    return style;
}

void bundle_script_sum(unsigned char sum[32])
{
    const Bundle text = bundle_of("/web/report.sum"); /* 32 bytes */
    memset(sum, 0, 32);
    if (text.size == 32) memcpy(sum, text.at, 32);
}

/* -------------------------------------------------------------------------------------------------------------- runs
 */

/* What would be built and what it takes, as JSON. */
char *desk_cost(const char *text)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    char *said = NULL;
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = hawser_case_check(c, &err);
    if (!status) status = hawser_case_describe(c, HAWSER_JSON, &said, &err);
    hawser_case_free(c);
    return desk_answered(status, said, &err);
}

/* clang-format off */
EM_JS(void, run_shows, (double t, double end, double wall, int pass, double force, double most, double reference,
                        double head, int segments, const double *position, const double *tension, const char *held), {
    Module.onRun({
        time: t, end: end, wall: wall, pass: pass, force: force, most: most, reference: reference, head: head,
        position: Float32Array.from(HEAPF64.subarray(position >> 3, (position >> 3) + 3 * segments)),
        tension: Float32Array.from(HEAPF64.subarray((tension >> 3) + 1, (tension >> 3) + 1 + segments)),
        heldUp: held ? UTF8ToString(held) : ""
    });
});
EM_JS(void, run_begins, (const char *data), { Module.onRun({data: UTF8ToString(data)}); });
/* clang-format on */

static const char RUN[] = "/run", REPORT[] = "/report.html";

/* The report's data of what there is by now: route, equipment, chain, the first state. */
static void begin_show(void)
{
    Folder folder;
    Text data = {0};
    hawser_error err;
    if (!folder_read(RUN, &folder, &err) && !data_write(1, &folder, &data, &err) && !data.failed) run_begins(data.at);
    text_clear(&data);
    folder_clear(&folder);
}

/* user: the pass that has been shown. */
static int progress(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    int *const shown = user;
    if (*shown == 0 && sample->t >= 0) begin_show();
    *shown = sample->pass;
    run_shows(sample->t, end_s, wall_s, sample->pass, sample->winch_force, sample->max_tension, sample->reference,
              sample->head_at, sample->segments, sample->position, sample->tension, sample->held_up);
    return 0;
}

/* summary.json of the run. */
char *desk_run(const char *text)
{
    static const hawser_options options = {.threads = 1};
    static const char *const folder = RUN;
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    char *summary = NULL;
    int shown = 0;
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = hawser_sim_new(c, &options, &s, &err);
    if (!status) status = hawser_sim_run(s, RUN, progress, &shown, &err);
    if (!status) status = hawser_report_write(&folder, 1, REPORT, &err);
    if (!status) status = hawser_sim_summary_json(s, &summary, &err);
    hawser_sim_free(s);
    hawser_case_free(c);
    return desk_answered(status, summary, &err);
}
