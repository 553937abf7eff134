#include "io/alignment/case_line.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* The path of a file that a section names: relative to the case's folder; malloc'ed. */
static hawser_status path_find(const CaseReader *r, const CaseNode *section, const char *file, char **path)
{
    const CaseNode *const node = case_node_key(section, "file");
    const int absolute = *file == '/';
    *path = NULL;
    if (!node) return case_key_error(r->err, section, "file", "missing: it says where the line is");
    if (!*file) return case_value_error(r->err, node, ": expected the name of a file");
    if (!r->folder)
        return case_value_error(r->err, node, ": a case that is a text has no folder to look in: load it from a file");
    const size_t size = strlen(r->folder) + strlen(file) + 2;
    *path = malloc(size);
    if (!*path) return error_memory(r->err);
    snprintf(*path, size, "%s%s%s", absolute ? "" : r->folder, absolute ? "" : "/", file);
    return HAWSER_OK;
}

enum { IGNORE_MOST = 2000 };

/* Names of columns, each on a line of its own. */
static hawser_status ignore_read(const CaseReader *r, const CaseNode *section, char names[IGNORE_MOST])
{
    const CaseNode *const given = case_node_key(section, "ignore");
    const CaseNode *item = given && given->kind == NODE_LIST ? given->first : given;
    *names = 0;
    for (size_t n = 0; item; item = item == given ? NULL : item->next) {
        if (item->kind != NODE_TEXT || !*item->text || n + strlen(item->text) + 2 > IGNORE_MOST)
            return case_value_error(r->err, item, ": expected names of columns, at most %d characters", IGNORE_MOST);
        n += (size_t)sprintf(names + n, "%s\n", item->text);
    }
    return HAWSER_OK;
}

/* Which line of which file; the texts stay the record's. */
static hawser_status pick_read(const CaseReader *r, const CaseNode *section, const LineRecord *in,
                               char ignore[IGNORE_MOST], LinePick *out, char **path)
{
    hawser_error why = {.message = ""};
    const hawser_status names = ignore_read(r, section, ignore);
    if (names) return names;
    out->sheet = *in->sheet ? in->sheet : NULL;
    out->ignore = *ignore ? ignore : NULL;
    out->name = *in->name ? in->name : NULL;
    out->layer = *in->layer ? in->layer : NULL;
    hawser_status status = path_find(r, section, in->file, path);
    out->path = *path;
    if (status || !*in->units) return status;
    status = line_unit(in->units, &out->unit, &why);
    return status ? case_key_cause(r->err, section, "units", "", &why) : HAWSER_OK;
}

/* What files have that is not in the route stands among what the case did not say: in `hawser check` and summaries. */
static hawser_status unread_say(const CaseReader *r, const CaseNode *section, int n, const SurveyIgnored *left)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; ++i) status = case_unread_add(r, section, left[i].what, left[i].times);
    return status;
}

/* What was found in a drawing and decides the pull: which way the line runs, and bends that its chords stand for. */
static hawser_status found_say(const CaseReader *r, const CaseNode *section, const Alignment *line,
                               const LineOptions *options, const UsedLine *used)
{
    if (!*line->layer) return HAWSER_OK;
    const LineWay way = line_way(line, options->reverse);
    char text[LINE_WORDS_MAX + 60];
    snprintf(text, sizeof text, "%s; 'reverse' turns it", way.text);
    hawser_status status = case_found_add(r, section, way.side, 0, text);
    if (!status && *used->bends) status = case_found_add(r, section, "bends", 1, used->bends);
    return status;
}
/* m: no cable goes around a corner that is sharper. */
static const double LEAST_BEND = 0.3;

/* Reads, chooses and uses the line of `node`'s file; *own: that file is read, and what fails is of the profile's. */
static hawser_status line_find(const CaseReader *r, const CaseNode *node, const LineOptions *options, UsedLine *used,
                               int *own, hawser_error *err)
{
    Survey s;
    const Alignment *line;
    hawser_status status = lines_read(&options->line, &s, err);
    *own = !status;
    if (status) return status;
    status = line_choose(&options->line, &s, &line, err);
    if (!status) line_notes_say(&s, line);
    if (!status) status = line_unit_check(&s, line, err);
    if (!status) status = line_use(line, options, used, err);
    if (!status) used->mapped = s.mapped;
    if (!status) status = found_say(r, node, line, options, used);
    if (!status && *used->sharp && used->sharpest < LEAST_BEND) {
        status = error_set(err, HAWSER_ERR_INPUT, "%s", used->sharp);
        line_clear(used);
    }
    if (!status && *used->sharp) status = case_unread_add(r, node, used->sharp, 1);
    if (!status) status = unread_say(r, node, s.n_ignored, s.ignored);
    survey_clear(&s);
    const int pieces = used->line.n_plan + used->line.n_points;
    if (!status && pieces > LINE_PIECES_MOST) {
        status =
            error_set(err, HAWSER_ERR_INPUT,
                      "'%.60s' has %d pieces, and a case's route at most %d: take a part of it with 'from' and 'to'",
                      used->line.name, pieces, LINE_PIECES_MOST);
        line_clear(used);
    }
    return status;
}

/* The key that an error of the file is about, where it is not the file itself. */
static const CaseNode *blamed(const CaseNode *section, const char *message)
{
    const int columns = strstr(message, ": 'ignore' ") != NULL;
    const int sheet = strstr(message, ": no sheet '") || strstr(message, ": 'sheet' ");
    return columns ? case_node_key(section, "ignore") : sheet ? case_node_key(section, "sheet") : NULL;
}

hawser_status case_line_use(const CaseReader *r, const CaseNode *node, const LineRecord *line, const CaseNode *heights,
                            const LineRecord *profile, LineOptions *options, UsedLine *used)
{
    hawser_error why = {.message = ""};
    char *path = NULL, *profile_path = NULL, ignore[IGNORE_MOST], profile_ignore[IGNORE_MOST];
    *used = (UsedLine){.fitted = 0};
    hawser_status status = pick_read(r, node, line, ignore, &options->line, &path);
    if (!status && heights) status = pick_read(r, heights, profile, profile_ignore, &options->profile, &profile_path);
    if (!status) {
        assert(path);
        int own = 0;
        status = line_find(r, node, options, used, &own, &why);
        if (!status && heights) status = unread_say(r, heights, used->n_unread, used->unread);
        if (status == HAWSER_ERR_INPUT) {
            const int named = strncmp(why.message, path, strlen(path)) == 0 ||
                              (profile_path && strncmp(why.message, profile_path, strlen(profile_path)) == 0);
            const CaseNode *const key = blamed(own && heights ? heights : node, why.message);
            status = case_key_error(r->err, key ? key : node, key ? NULL : "file", "%s%s%s", named ? "" : path,
                                    named ? "" : ": ", why.message);
        } else if (status) {
            status = error_memory(r->err);
        }
    }
    if (!status) status = file_marks_add(&r->def->files, path, r->err);
    if (!status && profile_path) status = file_marks_add(&r->def->files, profile_path, r->err);
    if (status) line_clear(used);
    free(path);
    free(profile_path);
    return status;
}
