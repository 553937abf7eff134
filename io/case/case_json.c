/* The tables of a case's keys as a JSON Schema: draft 2020-12, so that editors complete and check a case. A section is
 * a definition by its path. What a schema has no word for stands behind "x-": the quantity, the unit of a plain number,
 * what an absent key means. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/case/case_parts.h"
#include "io/schema/case_schema.h"

/* The document being made; failed: there was no memory for a part. */
typedef struct Writer {
    const Units *units;
    int failed;
} Writer;

static void put(Writer *w, json_t *o, const char *key, json_t *value)
{
    w->failed |= json_object_set_new(o, key, value) < 0;
}

static void put_all(Writer *w, json_t *o, json_t *more) { w->failed |= json_object_update_new(o, more) < 0; }

static json_t *ref_to(const CaseSection *section)
{
    return json_pack("{s:o}", "$ref", json_sprintf("#/$defs/%s", section->path));
}

static void put_text(Writer *w, json_t *o, const char *key, const char *text)
{
    if (text && *text) put(w, o, key, json_string(text));
}

/* Whether a number may stand without a unit: then it is in SI. */
static int is_plain(const Units *units, Dimension dimension)
{
    char why[UNITS_WHY_MAX];
    double value;
    return units_read(units, "1", dimension, &value, why);
}

static void number_set(Writer *w, json_t *o, const CaseKey *key)
{
    char range[CASE_RANGE_MAX];
    const int plain = is_plain(w->units, key->dimension); /* without a unit 0 alone may stand elsewhere */
    put(w, o, "type", json_pack("[s,s]", "number", "string"));
    put(w, o, "pattern", json_string("[0-9]"));
    put(w, o, key->above ? "exclusiveMinimum" : "minimum", json_real(plain ? key->min : fmax(key->min, 0)));
    put(w, o, "maximum", json_real(plain ? key->max : 0));
    if (plain) put_text(w, o, "x-unit", dimension_unit(key->dimension));
    if (key->dimension != DIM_NONE) put_text(w, o, "x-quantity", dimension_name(key->dimension));
    put_text(w, o, "description", case_range_text(key, range));
}

/* A choice that is a number or a truth stands as one, too. */
static void choices_set(Writer *w, json_t *o, const CaseKey *key)
{
    json_t *const all = json_array();
    for (int k = 0; key->choices[k]; ++k) {
        const char *const word = key->choices[k];
        const int yes = !strcmp(word, "true") || !strcmp(word, "on");
        const int truth = yes || !strcmp(word, "false") || !strcmp(word, "off");
        json_t *const same = truth                               ? json_boolean(yes)
                             : !word[strspn(word, "0123456789")] ? json_integer(strtol(word, NULL, 10))
                                                                 : NULL;
        w->failed |= json_array_append_new(all, json_string(word)) < 0;
        if (same) w->failed |= json_array_append_new(all, same) < 0;
    }
    put(w, o, "enum", all);
}

static int is_by_name(const CaseSection *section)
{
    const char *const last = strrchr(section->path, '.');
    return last && !strcmp(last, ".NAME");
}

/* A map of one's own keys, or of keys that the user chooses. */
static void map_set(Writer *w, json_t *o, const CaseKey *key)
{
    put(w, o, "type", json_string("object"));
    if (!key->section) return;
    if (is_by_name(key->section))
        put(w, o, "additionalProperties", ref_to(key->section));
    else
        put_all(w, o, ref_to(key->section));
}

/* One of a section, a list of them (or of what its key `list` holds), or what is said in words. */
static void any_set(Writer *w, json_t *o, const CaseKey *key)
{
    if (!key->section) return;
    const CaseKey *const list = case_key_of(key->section, "list");
    const CaseSection *const item = list && list->section ? list->section : key->section;
    put(w, o, "anyOf",
        json_pack("[o,{s:s,s:{s:[o,{s:[s,s,s]}]}},{s:[s,s,s]}]", ref_to(key->section), "type", "array", "items",
                  "anyOf", ref_to(item), "type", "string", "number", "array", "type", "string", "number", "boolean"));
}

static json_t *key_json(Writer *w, const CaseKey *key)
{
    json_t *const o = json_object();
    char form[CASE_FORM_MAX];
    switch (key->kind) {
    case KEY_NUMBER:
        number_set(w, o, key);
        break;
    case KEY_INTEGER:
        put_all(w, o, json_pack("{s:s,s:f,s:f}", "type", "integer", "minimum", key->min, "maximum", key->max));
        break;
    case KEY_FLAG:
        put(w, o, "enum", json_pack("[b,b,s,s,s,s]", 1, 0, "yes", "no", "on", "off"));
        break;
    case KEY_CHOICE:
        choices_set(w, o, key);
        break;
    case KEY_TEXT:
        put_all(w, o, json_pack("{s:[s,s],s:i}", "type", "string", "number", "maxLength", (int)key->size - 1));
        break;
    case KEY_POINT:
        put_all(w, o, json_pack("{s:s,s:i,s:i}", "type", "array", "minItems", 3, "maxItems", 3));
        break;
    case KEY_SECTION:
    case KEY_MAP:
        map_set(w, o, key);
        break;
    case KEY_LIST:
        put(w, o, "type", json_string("array"));
        if (key->section) put(w, o, "items", ref_to(key->section));
        break;
    case KEY_ANY:
        any_set(w, o, key);
        break;
    }
    if (key->form || (key->kind == KEY_MAP && key->section)) put_text(w, o, "description", case_form_text(key, form));
    put_text(w, o, "default", key->fallback);
    put_text(w, o, "x-absent", key->otherwise);
    return o;
}

/* Whether a synonym is of a section's items: "surfaces", "ducts" of "surfaces.ducts.N". */
static int is_synonym_of(const Synonym *s, const CaseSection *section)
{
    char path[64];
    snprintf(path, sizeof path, "%s.%s.N", s->section, s->list);
    return !strcmp(path, section->path);
}

/* Other names that people type are there, but not offered. */
static void synonyms_add(Writer *w, const CaseSection *section, json_t *keys, const CaseKey *key, int *required)
{
    const Synonym *s;
    for (int i = 0; (s = case_synonym(i)); ++i) {
        if (!is_synonym_of(s, section) || strcmp(s->key, key->name) != 0) continue;
        put(w, keys, s->other,
            json_pack("{s:b,s:o}", "deprecated", 1, "description",
                      json_sprintf(s->half ? "twice `%s`" : "another name of `%s`", s->key)));
        *required = 0;
    }
}

/* How many keys have that section. */
static int places_of(const CaseSection *const all[], int n, const CaseSection *section)
{
    int places = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < all[i]->n; ++k) places += all[i]->key[k].section == section;
    return places;
}

/* What the catalogue may give (`type`), or a drawing where a section stands in several places, need not stand in the
 * case. */
static json_t *section_json(Writer *w, const CaseSection *section, int alone)
{
    json_t *const keys = json_object(), *const required = json_array();
    const int all_here = alone && !case_key_of(section, "type");
    for (int k = 0; k < section->n; ++k) {
        const CaseKey *const key = &section->key[k];
        int needed = key->required && all_here;
        put(w, keys, key->name, key_json(w, key));
        synonyms_add(w, section, keys, key, &needed);
        if (needed) w->failed |= json_array_append_new(required, json_string(key->name)) < 0;
    }
    json_t *const o = json_pack("{s:s,s:o,s:b}", "type", "object", "properties", keys, "additionalProperties", 0);
    if (json_array_size(required) > 0) put(w, o, "required", json_incref(required));
    json_decref(required);
    return o;
}

char *case_schema_json(const Units *units, const CaseSection *top)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    Writer w = {units, 0};
    const int n = case_sections(top, all, 0);
    json_t *const o = json_pack("{s:s,s:s,s:s}", "$schema", "https://json-schema.org/draft/2020-12/schema", "$id",
                                "urn:hawser:case:1", "title", "A case of hawser");
    json_t *const defs = json_object();
    for (int i = 1; i < n; ++i) put(&w, defs, all[i]->path, section_json(&w, all[i], places_of(all, n, all[i]) == 1));
    put_all(&w, o, section_json(&w, top, 1));
    put(&w, o, "$defs", defs);
    char *const text = w.failed ? NULL : json_dumps(o, JSON_INDENT(2));
    json_decref(o);
    return text;
}
