#include "io/yaml/yaml_tree.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"

/* A file's name may be of any length: it is cut so that the line still shows. */
const char *case_place(const char *origin, int line, char *place)
{
    if (line > 0) {
        snprintf(place, CASE_PLACE_MAX, "%.*s:%d", CASE_PLACE_MAX - 16, origin, line);
    } else {
        snprintf(place, CASE_PLACE_MAX, "%s", origin);
    }
    return place;
}

/* Control characters become blanks, so that a message stays one line whatever the user wrote. */
const char *case_shown(const char *text, char *shown)
{
    const size_t room = CASE_SHOWN_MAX - 8;
    size_t n = 0;
    shown[n++] = '\'';
    for (; *text && n < room; text++) shown[n++] = (unsigned char)*text < 0x20 || *text == 0x7f ? ' ' : *text;
    if (*text) {
        /* Not in the middle of a character of several bytes. */
        while (n > 1 && ((unsigned char)shown[n - 1] & 0x80)) n--;
        n += (size_t)snprintf(shown + n, 4, "...");
    }
    shown[n++] = '\'';
    shown[n] = 0;
    return shown;
}

/* From the root down: the parents' path first, then the node's own key or number, then the child's. */
const char *case_path(const CaseNode *node, const char *key, char *path)
{
    char before[CASE_PATH_MAX] = "", own[CASE_SHOWN_MAX] = "";
    path[0] = 0;
    if (node && node->parent) case_path(node->parent, NULL, before);
    if (node && node->key) snprintf(own, sizeof own, "%s", node->key);
    if (node && node->parent && !node->key) snprintf(own, sizeof own, "%d", node->index);
    const char *const part[3] = {before, own, key ? key : ""};
    size_t n = 0;
    for (int k = 0; k < 3; k++) {
        if (!*part[k] || n >= CASE_PATH_MAX) continue;
        n += (size_t)snprintf(path + n, CASE_PATH_MAX - n, "%s%s", n ? "." : "", part[k]);
    }
    return path;
}

hawser_status case_text_error(hawser_error *err, const char *origin, int line, const char *what, const char *detail)
{
    char place[CASE_PLACE_MAX], shown[CASE_SHOWN_MAX];
    error_set(err, HAWSER_ERR_INPUT, "%s: %s%s", case_place(origin, line, place), what,
              detail ? case_shown(detail, shown) : "");
    error_place(err, origin, line);
    return HAWSER_ERR_INPUT;
}

/* "PLACE: key 'PATH': ABOUT VALUE WHAT": what all messages about a key have in common. The line is the node's, also
 * where the child is missing. */
static hawser_status key_error(hawser_error *err, const CaseNode *node, const char *key, const char *about,
                               const char *value, const char *what, va_list args)
{
    char place[CASE_PLACE_MAX], path[CASE_PATH_MAX], text[HAWSER_MESSAGE_MAX / 2];
    vsnprintf(text, sizeof text, what, args);
    error_set(err, HAWSER_ERR_INPUT, "%s: key '%s': %s%s%s", case_place(node->origin, node->line, place),
              case_path(node, key, path), about, value, text);
    error_place(err, node->origin, node->line);
    return HAWSER_ERR_INPUT;
}

/* A map or list is not shown, only named: it may be long. */
hawser_status case_value_error(hawser_error *err, const CaseNode *node, const char *what, ...)
{
    char shown[CASE_SHOWN_MAX];
    const int text = node->kind == NODE_TEXT;
    const char *const value = text ? case_shown(node->text, shown) : node->kind == NODE_MAP ? "map" : "list";
    va_list args;
    va_start(args, what);
    const hawser_status status = key_error(err, node, NULL, text ? "value " : "the value is a ", value, what, args);
    va_end(args);
    return status;
}

hawser_status case_key_error(hawser_error *err, const CaseNode *node, const char *key, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    const hawser_status status = key_error(err, node, key, "", "", what, args);
    va_end(args);
    return status;
}

hawser_status case_key_cause(hawser_error *err, const CaseNode *node, const char *key, const char *before,
                             const hawser_error *why)
{
    if (why->status == HAWSER_ERR_MEMORY) return error_memory(err);
    return case_key_error(err, node, key, "%s%s%s", before, *before ? ": " : "", why->message);
}

static int least(int a, int b) { return a < b ? a : b; }

/* Optimal string alignment; words of up to 63 letters. */
int case_distance(const char *a, const char *b)
{
    enum { LETTERS = 63 };
    int d[LETTERS + 1][LETTERS + 1];
    const int n = (int)strlen(a), m = (int)strlen(b);
    if (n > LETTERS || m > LETTERS) return LETTERS;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            d[i][j] = i + j;
            if (!i || !j) continue;
            d[i][j] = least(d[i - 1][j], d[i][j - 1]) + 1;
            d[i][j] = least(d[i][j], d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[n][m];
}

/* Up to a third of the letters may be wrong; a word that differs in capitals alone is always near. */
const char *case_nearest(const char *word, const char *const *name, int n)
{
    const char *best = NULL;
    int best_distance = least(3, 1 + (int)strlen(word) / 3);
    for (int k = 0; k < n; k++) {
        if (strcasecmp(word, name[k]) == 0) return name[k];
        const int distance = case_distance(word, name[k]);
        if (distance >= best_distance) continue;
        best = name[k];
        best_distance = distance;
    }
    return best;
}
