/* What the desk's page calls of the library. Each function takes texts and returns a text that the page frees: '=' and
 * what was asked for, or '!' and the error as a JSON object with status, message, key, file and line. A case's own
 * files are in the folder /case, where the page puts what the user has opened. */
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

#include "web/engine/desk.h"

/* Which emscripten's library declares and does not have. */
ssize_t getrandom(void *to, size_t size, unsigned flags)
{
    (void)flags;
    return size <= 256 && !getentropy(to, size) ? (ssize_t)size : -1;
}

static const char FOLDER[] = "/case", PAGE[] = "/page.html", SECTION[] = "/route.yaml";

char *desk_answered(hawser_status status, char *text, const hawser_error *err)
{
    char *out = NULL;
    if (!status && text && (out = malloc(strlen(text) + 2))) {
        *out = '=';
        strcpy(out + 1, text);
    }
    hawser_text_free(text);
    if (out) return out;
    json_t *const o = json_pack("{s:i, s:s%, s:s, s:s, s:i}", "status", (int)status, "message", err->message,
                                strlen(err->message), "key", err->key, "file", err->file, "line", err->line);
    char *const json = o ? json_dumps(o, 0) : NULL;
    json_decref(o);
    if (!json) return NULL;
    if ((out = malloc(strlen(json) + 2))) {
        *out = '!';
        strcpy(out + 1, json);
    }
    free(json);
    return out;
}

char *file_text(const char *path, size_t *size)
{
    FILE *const f = fopen(path, "rb");
    char *text = NULL;
    long n = -1;
    if (f && !fseek(f, 0, SEEK_END)) n = ftell(f);
    if (n >= 0 && !fseek(f, 0, SEEK_SET) && (text = malloc((size_t)n + 1))) {
        if (fread(text, 1, (size_t)n, f) != (size_t)n) n = 0;
        text[n] = 0;
        *size = (size_t)n;
    }
    if (f) fclose(f);
    return text;
}

/* The text of a file that the library has written, which is taken away. */
static char *file_taken(const char *path)
{
    size_t size;
    char *const text = file_text(path, &size);
    remove(path);
    return text;
}

hawser_status desk_case(const char *text, hawser_case **c, hawser_error *err)
{
    hawser_status status = hawser_case_parse(text, "case.yaml", c, err);
    return status ? status : hawser_case_folder(*c, FOLDER, err);
}

/* The calculation as JSON; `tables`: which, with commas between. */
char *desk_theory(const char *text, const char *tables)
{
    const hawser_theory_options options = {.tables = tables};
    hawser_error err = {0};
    hawser_case *c = NULL;
    char *said = NULL;
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = hawser_case_theory_shown(c, HAWSER_JSON, &options, &said, NULL, &err);
    hawser_case_free(c);
    return desk_answered(status, said, &err);
}

/* The answer in words. us: not 0, in units of the United States. */
char *desk_answer(const char *text, int us)
{
    const hawser_theory_options options = {.width = 100};
    hawser_error err = {0};
    hawser_case *c = NULL;
    char *said = NULL;
    hawser_status status = desk_case(text, &c, &err);
    if (!status) status = hawser_case_theory_shown(c, us ? HAWSER_TABLE_US : HAWSER_TABLE, &options, &said, NULL, &err);
    hawser_case_free(c);
    return desk_answered(status, said, &err);
}

/* The page of the calculation; `language`: of a case that has none of its own, "" for none. */
char *desk_page(const char *text, int us, const char *language)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_status status = desk_case(text, &c, &err);
    if (!status && *language) status = hawser_case_set(c, "job.language", language, &err);
    if (!status) status = hawser_case_calculation(c, us ? HAWSER_US : HAWSER_SI, PAGE, NULL, &err);
    hawser_case_free(c);
    return desk_answered(status, status ? NULL : file_taken(PAGE), &err);
}

char *desk_schema(void)
{
    hawser_error err = {0};
    char *text = NULL;
    const hawser_status status = hawser_case_schema(&text, &err);
    return desk_answered(status, text, &err);
}

/* The section `route` of a case for the line of a file in the folder; name, layer: which, "" for any. */
char *desk_section(const char *file, const char *name, const char *layer)
{
    char path[300];
    hawser_error err = {0};
    hawser_routes *routes = NULL;
    hawser_route_options options = hawser_route_defaults();
    if (*name) options.name = name;
    if (*layer) options.layer = layer;
    snprintf(path, sizeof path, "%s/%s", FOLDER, file);
    hawser_status status = hawser_routes_read(path, &options, &routes, &err);
    if (!status) status = hawser_routes_write(routes, -1, SECTION, &err);
    hawser_routes_free(routes);
    return desk_answered(status, status ? NULL : file_taken(SECTION), &err);
}

/* Lines of a drawing that lie under the plan, and places along each of them. */
enum { LINES = 300, LINE_PLACES = 121 };

/* One line's places in plan, x and y, m, as the file has them, behind what is in `list`. */
static hawser_status line_places(hawser_routes *routes, int i, json_t *list, hawser_error *err)
{
    double length;
    hawser_route_figures figures;
    hawser_route_place first, at;
    hawser_status status = hawser_routes_length(routes, i, &length, err);
    if (!status) status = hawser_routes_figures(routes, i, &figures, err);
    if (!status) status = hawser_routes_at(routes, i, 0, &first, err);
    if (status) return status;
    json_t *const places = json_array();
    for (int k = 0; k < LINE_PLACES && !status; ++k) {
        status = hawser_routes_at(routes, i, length * k / (LINE_PLACES - 1), &at, err);
        for (int axis = 0; axis < 2; ++axis) {
            const double value = figures.start_m[axis] + (at.position_m[axis] - first.position_m[axis]);
            json_array_append_new(places, json_real(value));
        }
    }
    json_array_append_new(list, places);
    return status;
}

/* The lines of a file in the folder in plan: a JSON list of lists x, y, x, y ... in m. Lines that cannot be routes are
 * left out. */
char *desk_lines(const char *name, const char *units)
{
    char path[300];
    hawser_error err = {0};
    hawser_routes *routes = NULL;
    hawser_route_options options = hawser_route_defaults();
    if (*units) options.units = units;
    snprintf(path, sizeof path, "%s/%s", FOLDER, name);
    hawser_status status = hawser_routes_read(path, &options, &routes, &err);
    json_t *const list = json_array();
    const int n = status ? 0 : hawser_routes_count(routes);
    for (int i = 0; i < n && i < LINES && status != HAWSER_ERR_MEMORY; ++i) status = line_places(routes, i, list, &err);
    if (n > 0 && status != HAWSER_ERR_MEMORY) status = HAWSER_OK;
    char *const text = json_dumps(list, JSON_COMPACT | JSON_REAL_PRECISION(12));
    json_decref(list);
    hawser_routes_free(routes);
    return desk_answered(status, text, &err);
}

/* The lines of a file in the folder, as JSON. */
char *desk_route(const char *name)
{
    char path[300];
    hawser_error err = {0};
    hawser_routes *routes = NULL;
    char *text = NULL;
    snprintf(path, sizeof path, "%s/%s", FOLDER, name);
    hawser_status status = hawser_routes_read(path, NULL, &routes, &err);
    if (!status) status = hawser_routes_describe(routes, HAWSER_JSON, &text, &err);
    hawser_routes_free(routes);
    return desk_answered(status, text, &err);
}
