/* The page's program builds all that is seen from the data; this is the frame around both. Where no program may run, a
 * table says the verdict and the main figures. The policy forbids every request, and every program but the one that is
 * built in. */
#include "io/report/report.h"

#include "core/base/error.h"

#include <math.h>

enum { TITLE_MOST = 200, WORDS_MOST = 2000 };

/* "'sha256-...'", by which the policy knows the script. */
static void policy_add(Text *out)
{
    unsigned char sum[32];
    bundle_script_sum(sum);
    text_add(out, "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-");
    text_base64(out, sum, sizeof sum);
    text_add(out, "'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n");
}

/* What a run is called, kept apart from the text around it whatever direction it is written in. */
static void title_add(Text *out, const Folder *folder)
{
    text_add(out, "<bdi>");
    text_html(out, folder_title(folder), TITLE_MOST);
    text_add(out, "</bdi>");
}

static void figure_add(Text *out, const Folder *folder, const char *words, const char *path, const char *unit)
{
    const double value = folder_figure(folder, path);
    if (isfinite(value)) text_print(out, "<tr><th>%s</th><td>%.6g %s</td></tr>\n", words, value, unit);
}

static void words_add(Text *out, const char *words, const char *text)
{
    if (!*text) return;
    text_print(out, "<tr><th>%s</th><td><bdi>", words);
    text_html(out, text, WORDS_MOST);
    text_add(out, "</bdi></td></tr>\n");
}

/* What one run comes to, for a browser without scripts. */
static void plain_add(Text *out, const Folder *folder)
{
    text_add(out, "<h2>");
    title_add(out, folder);
    text_add(out, "</h2>\n<table>\n");
    words_add(out, "verdict", folder_text(folder, "verdict"));
    words_add(out, "ended", folder_text(folder, "outcome"));
    words_add(out, "because", folder_text(folder, "message"));
    figure_add(out, folder, "pull, mean", "pull_force.steady_mean_N", "N");
    figure_add(out, folder, "pull, peak", "pull_force.peak_N", "N");
    figure_add(out, folder, "reference theory", "theory.reference_total_N", "N");
    figure_add(out, folder, "speed", "speed.steady_m_per_s", "m/s");
    figure_add(out, folder, "simulated", "sim_time_s", "s");
    words_add(out, "case", folder_text(folder, "case"));
    words_add(out, "hawser", folder_text(folder, "version"));
    text_add(out, "</table>\n");
    for (int i = 0; i < folder->n_notes; i++) {
        text_add(out, "<p>");
        text_html(out, folder->note[i], FOLDER_NOTE_MAX);
        text_add(out, "</p>\n");
    }
}

hawser_status page_write(size_t n, const Folder *folder, const Text *data, Text *out, hawser_error *err)
{
    const Bundle script = bundle_script(), style = bundle_style();
    text_add(out, "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    policy_add(out);
    text_add(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    text_print(out, "<meta name=\"generator\" content=\"hawser %s\">\n<title>", hawser_version());
    text_html(out, folder_title(&folder[0]), TITLE_MOST);
    if (n > 1) text_print(out, " and %zu more", n - 1);
    text_add(out, "</title>\n<style>\n");
    text_bytes(out, style.at, style.size);
    text_add(out, "</style>\n</head>\n<body>\n<main id=\"hawser\"></main>\n<noscript>\n"
                  "<p>This page draws its figures with a script, which is switched off here. The main figures:</p>\n");
    for (size_t i = 0; i < n; i++) plain_add(out, &folder[i]);
    text_add(out, "</noscript>\n<script type=\"application/json\" id=\"hawser-data\">");
    if (data->at) text_bytes(out, data->at, data->size);
    text_add(out, "</script>\n<script>");
    text_bytes(out, script.at, script.size); /* its sum is that of the element's text: not a byte more */
    text_add(out, "</script>\n</body>\n</html>\n");
    return out->failed ? error_memory(err) : HAWSER_OK;
}
