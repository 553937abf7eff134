/* The simulation behind the desk: what it will take, and a run in the folder /run, whose report's page becomes
 * /report.html. The page's program and style are files that the desk has put into /web. */
#include <emscripten.h>
#include <jansson.h>
#include <math.h>
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
EM_JS(void, run_keeps, (void), { Module.onKeep(); });
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

typedef struct Shown {
    hawser_sim *sim;
    int pass;       /* that has been shown, 0: none */
    double rest_ms; /* time before which the folder is not handed over again */
} Shown;

/* Share of the time that handing over the folder may take. */
static const double keep_share = 0.1;

/* Hands the folder as it is to the page, which has the report of it if the run is ended from outside. The folder has a
 * summary of the present moment; in a finer pass it has that of the first. */
static void keep(Shown *shown)
{
    const double begun = emscripten_get_now();
    char *text = NULL;
    hawser_error err;
    FILE *f = NULL;
    if (shown->pass == 1 && !hawser_sim_summary_json(shown->sim, &text, &err)) f = fopen("/run/summary.json", "w");
    if (f) {
        fputs(text, f);
        fclose(f);
    }
    hawser_text_free(text);
    fflush(NULL);
    run_keeps();
    const double now = emscripten_get_now();
    shown->rest_ms = now + fmax(500, (now - begun) / keep_share);
}

static int progress(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    Shown *const shown = user;
    if (shown->pass == 0 && sample->t >= 0) begin_show();
    shown->pass = sample->pass;
    if (sample->t > 0 && emscripten_get_now() >= shown->rest_ms) keep(shown);
    run_shows(sample->t, end_s, wall_s, sample->pass, sample->winch_force, sample->max_tension, sample->reference,
              sample->head_at, sample->segments, sample->position, sample->tension, sample->held_up);
    return 0;
}

/* Writes the report's page of the folder /run, which the page has filled. */
char *desk_report(void)
{
    static const char *const folder = RUN;
    hawser_error err = {0};
    const hawser_status status = hawser_report_write(&folder, 1, REPORT, &err);
    return desk_answered(status, strdup(""), &err);
}

/* summary.json of the run. A run that fails has a report, too, of what was computed until then. */
char *desk_run(const char *text)
{
    static const hawser_options options = {.threads = 1};
    static const char *const folder = RUN;
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    char *summary = NULL;
    Shown shown = {0};
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = hawser_sim_new(c, &options, &s, &err);
    shown.sim = s;
    if (!status) {
        hawser_error unwritten = {0};
        status = hawser_sim_run(s, RUN, progress, &shown, &err);
        const hawser_status written = hawser_report_write(&folder, 1, REPORT, status ? &unwritten : &err);
        if (!status) status = written;
    }
    if (!status) status = hawser_sim_summary_json(s, &summary, &err);
    hawser_sim_free(s);
    hawser_case_free(c);
    return desk_answered(status, summary, &err);
}
