#include "fmi/model/variables.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

const UnitRow unit_rows[UNIT_ROWS] = {
    {"m", 0, 1, 0, 0},         {"m2", 0, 2, 0, 0},     {"s", 0, 0, 1, 0},      {"m/s", 0, 1, -1, 0},
    {"m/s2", 0, 1, -2, 0},     {"rad", 0, 0, 0, 1},    {"rad/s", 0, 0, -1, 1}, {"N", 1, 1, -2, 0},
    {"Pa", 1, -1, -2, 0},      {"N.m2", 1, 3, -2, 0},  {"N.m", 1, 2, -2, 0},   {"kg/m3", 1, -3, 0, 0},
    {"kg/m", 1, -1, 0, 0},     {"kg", 1, 0, 0, 0},     {"kg.m2", 1, 2, 0, 0},  {"N/m", 1, 0, -2, 0},
    {"N.m/rad", 1, 2, -2, -1}, {"N.s/m", 1, 0, -1, 0}, {"m-1", 0, -1, 0, 0},   {"Hz", 0, 0, -1, 0},
    {"W", 1, 2, -3, 0},        {"J", 1, 2, -2, 0},     {"m3", 0, 3, 0, 0},     {"N.s", 1, 1, -1, 0},
    {"kg/s", 1, 0, -1, 0},
};

const char *unit_name(const char *written)
{
    char dotted[32];
    size_t n = 0;
    for (; written[n] && n + 1 < sizeof dotted; ++n) dotted[n] = written[n] == ' ' ? '.' : written[n];
    dotted[n] = 0;
    for (int i = 0; i < UNIT_ROWS; ++i) {
        if (strcmp(dotted, unit_rows[i].name) == 0) return unit_rows[i].name;
    }
    return NULL;
}

const char *variable_step(const char *step, char to[VARIABLE_STEP_MAX])
{
    static const char LETTERS[] = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789",
                      QUOTED[] = "!#$&()*+,-./:;<>=?@[]^{}|~ ";
    char *at = to;
    if (*step && !strchr("0123456789", *step) && !step[strspn(step, LETTERS)]) {
        snprintf(to, VARIABLE_STEP_MAX, "%s", step);
        return to;
    }
    *at++ = '\'';
    for (const char *c = step; *c && at + 5 < to + VARIABLE_STEP_MAX; ++c) {
        if (strchr(LETTERS, *c) || strchr(QUOTED, *c))
            *at++ = *c;
        else
            at += snprintf(at, 4, "%%%02X", (unsigned char)*c);
    }
    *at++ = '\'';
    *at = 0;
    return to;
}

static int is_taken(const Variables *v, const char *name)
{
    for (int i = 0; i < v->n; ++i) {
        if (strcmp(v->row[i].name, name) == 0) return 1;
    }
    return 0;
}

static hawser_status room_make(Variables *v, hawser_error *err)
{
    if (v->n < v->room) return HAWSER_OK;
    const int room = 2 * v->room + 64;
    Variable *const row = realloc(v->row, (size_t)room * sizeof *row);
    if (!row) return error_memory(err);
    v->row = row;
    v->room = room;
    return HAWSER_OK;
}

hawser_status variable_add(Variables *v, const Variable *row, const char *description, hawser_error *err,
                           const char *name, ...)
{
    char text[512];
    va_list list;
    va_start(list, name);
    vsnprintf(text, sizeof text - 16, name, list);
    va_end(list);
    const size_t length = strlen(text);
    for (int again = 2; is_taken(v, text); ++again) snprintf(text + length, 16, "_%d", again);
    const hawser_status status = room_make(v, err);
    if (status) return status;
    Variable *const own = &v->row[v->n];
    *own = *row;
    own->name = strdup(text);
    own->description = strdup(description);
    own->what = row->what ? strdup(row->what) : NULL;
    own->key = row->key ? strdup(row->key) : NULL;
    ++v->n; /* what there is of it is freed with the list */
    const int whole = own->name && own->description && (own->what || !row->what) && (own->key || !row->key);
    return whole ? HAWSER_OK : error_memory(err);
}

hawser_status variables_make(hawser_case *c, hawser_sim *s, Variables *out, hawser_error *err)
{
    static const Variable time = {.type = VARIABLE_REAL, .role = ROLE_TIME, .unit = "s"};
    *out = (Variables){0};
    hawser_status status = variable_add(out, &time, "time of the simulation", err, "time");
    if (!status) status = variables_add_inputs(out, c, err);
    if (!status) status = variables_add_outputs(out, c, s, err);
    if (!status) status = variables_add_parameters(out, c, err);
    if (status) variables_free(out);
    return status;
}

void variables_free(Variables *v)
{
    for (int i = 0; i < v->n; ++i) {
        free(v->row[i].name);
        free(v->row[i].description);
        free(v->row[i].what);
        free(v->row[i].key);
    }
    free(v->row);
    *v = (Variables){0};
}

/* ------------------------------------------------------------------------------------------------------- token */

/* FNV-1a, 64 bits. */
static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    for (const unsigned char *b = bytes; size-- > 0; ++b) hash = (hash ^ *b) * 0x100000001b3u;
    return hash;
}

void variables_token(const Variables *v, const char *case_text, char token[TOKEN_SIZE])
{
    uint64_t half[2] = {0xcbf29ce484222325u, 0x84222325cbf29ce4u};
    for (int k = 0; k < 2; ++k) {
        half[k] = mix(half[k], hawser_version(), strlen(hawser_version()));
        half[k] = mix(half[k], case_text, strlen(case_text));
        for (int i = 0; i < v->n; ++i) {
            const Variable *const row = &v->row[i];
            const unsigned char kind[2] = {(unsigned char)row->type, (unsigned char)row->role};
            half[k] = mix(half[k], row->name, strlen(row->name) + 1);
            half[k] = mix(half[k], kind, sizeof kind);
            half[k] = mix(half[k], &row->start, sizeof row->start);
        }
    }
    snprintf(token, TOKEN_SIZE, "%08x-%04x-%04x-%04x-%012llx", (unsigned)(half[0] >> 32),
             (unsigned)(half[0] >> 16 & 0xffff), (unsigned)(half[0] & 0xffff), (unsigned)(half[1] >> 48),
             (unsigned long long)(half[1] & 0xffffffffffffu));
}
