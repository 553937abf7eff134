/* Two parameters that set the same key, of which the later one would win. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "study/plan/study_keys.h"

enum { KEY_ROOM = 512 };

/* A step of a key in a list: the item that it numbers or names. NULL: there is none. */
static const CaseNode *item_of(const CaseNode *list, const char *step)
{
    char *end;
    const long index = isdigit((unsigned char)*step) ? strtol(step, &end, 10) : -1;
    if (index >= 0 && !*end && index < list->count) return case_node_item(list, (int)index);
    for (const CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = case_node_key(item, "name");
        if (own && own->kind == NODE_TEXT && strcmp(own->text, step) == 0) return item;
    }
    return NULL;
}

/* A key with items of lists by number alone, and a dot behind each step: "route.pieces.0.straight.". */
static void key_plain(const CaseNode *at, const char *key, char plain[KEY_ROOM])
{
    int n = 0;
    for (plain[0] = 0; *key && n < KEY_ROOM - 1;) {
        char step[KEY_ROOM];
        const size_t length = strcspn(key, ".");
        snprintf(step, sizeof step, "%.*s", (int)(length < KEY_ROOM ? length : 0), key);
        const int list = at && at->kind == NODE_LIST;
        at = !at ? NULL : list ? item_of(at, step) : case_node_key(at, step);
        if (list && at) snprintf(step, sizeof step, "%d", at->index);
        n += snprintf(plain + n, (size_t)(KEY_ROOM - n), "%s.", step);
        key += length + (key[length] == '.');
    }
}

/* Parameters are set in their order, so that a whole may come before a part of it, and is lost the other way round. */
static hawser_status pair_check(const CaseReader *r, const Study *s, const CaseNode *way, int i, int j)
{
    const Parameter *const p = &s->parameter[i], *const q = &s->parameter[j];
    for (int a = 0; a < p->n_keys; a++) {
        char first[KEY_ROOM], later[KEY_ROOM];
        key_plain(s->base->tree->root, p->key[a], first);
        for (int b = 0; b < q->n_keys; b++) {
            key_plain(s->base->tree->root, q->key[b], later);
            if (strncmp(first, later, strlen(later)) != 0) continue;
            return case_key_error(
                r->err, q->node ? q->node : way, NULL,
                "'%.100s' sets '%.100s', and so does '%.100s' with '%.100s', which would be lost: one "
                "parameter for each key",
                q->name, q->key[b], p->name, p->key[a]);
        }
    }
    return HAWSER_OK;
}

hawser_status twice_check(const CaseReader *r, const Study *s, const CaseNode *way)
{
    hawser_status status = HAWSER_OK;
    for (int j = 1; j < s->n_parameters; j++) {
        for (int i = 0; i < j && !status; i++) status = pair_check(r, s, way, i, j);
    }
    return status;
}
