/* By what a study is known: a number that is another one where a row could be another. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/library/library.h"
#include "io/results/results_file.h"
#include "study/engine/engine.h"

enum { STORE_FORMAT = 3, FILES_DEPTH = LIBRARY_DEPTH_MAX };

/* ----------------------------------------------------------------------------------------------------------- hashes */

/* With its end, so that "ab", "c" is not "a", "bc". */
static Hash hash_text(Hash h, const char *text)
{
    return hash_bytes(h, text ? text : "\1", text ? strlen(text) + 1 : 2);
}
static Hash hash_number(Hash h, double x) { return hash_bytes(h, &x, sizeof x); }

static Hash hash_node(Hash h, const CaseNode *node)
{
    h = hash_number(hash_text(hash_text(h, node->key), node->text), node->kind);
    for (const CaseNode *child = node->first; child; child = child->next) h = hash_node(h, child);
    return hash_text(h, "end");
}

static Hash hash_parameter(Hash h, const Parameter *p)
{
    const double law[] = {p->law.kind, p->law.a,  p->law.b,     p->law.c, p->law.low,
                          p->law.high, p->chosen, p->n_choices, p->whole, p->start};
    h = hash_text(hash_text(h, p->name), p->unit);
    for (int k = 0; k < p->n_keys; k++) h = hash_text(h, p->key[k]);
    h = hash_bytes(h, law, sizeof law);
    for (int k = 0; k < p->n_choices; k++) {
        h = hash_text(h, p->choice[k]);
        if (p->weight) h = hash_number(h, p->weight[k]);
    }
    return h;
}

static Hash hash_aim(Hash h, const Aim *a)
{
    const double plain[] = {a->most, a->limits, a->method, a->searches, a->tolerance, (double)a->evaluations};
    h = hash_bytes(h, plain, sizeof plain);
    for (int k = 0; k < a->n_terms; k++) {
        const double one[] = {a->term[k].of.parameter, a->term[k].of.quantity, a->term[k].weight};
        h = hash_bytes(h, one, sizeof one);
    }
    for (int k = 0; k < a->n_constraints; k++) {
        const Constraint *const c = &a->constraint[k];
        const double one[] = {c->of.parameter, c->of.quantity, c->least, c->most};
        h = hash_bytes(h, one, sizeof one);
    }
    return h;
}

/* ---------------------------------------------------------------------------------------------------------- files */

static Hash hash_files(Hash h, const CaseNode *node, const char *folder, int included, int depth);

static int is_yaml(const char *name)
{
    const char *const dot = strrchr(name, '.');
    return dot && (!strcmp(dot, ".yaml") || !strcmp(dot, ".yml"));
}

/* The bytes of the file that a text names, if there is such a one in the folder, and of those that it names in turn if
 * it is a catalogue or another case. */
static Hash hash_file(Hash h, const char *name, const char *folder, int included, int depth)
{
    char path[OUT_PATH_MAX], bytes[1 << 14];
    struct stat is;
    CaseTree *tree = NULL;
    hawser_error none;
    const int absolute = *name == '/';
    const int length = snprintf(path, sizeof path, "%s%s%s", absolute ? "" : folder, absolute ? "" : "/", name);
    if (length >= (int)sizeof path || stat(path, &is) || !S_ISREG(is.st_mode)) return h;
    FILE *const f = fopen(path, "rb");
    h = hash_text(h, f ? "file" : "closed file");
    for (size_t n; f && (n = fread(bytes, 1, sizeof bytes, f)) > 0;) h = hash_bytes(h, bytes, n);
    if (f) fclose(f);
    h = hash_number(h, (double)is.st_size);
    if (depth >= FILES_DEPTH || !(included || is_yaml(name)) || case_tree_load(path, &tree, &none)) return h;
    h = hash_files(h, tree->root, tree->folder, 0, depth + 1);
    case_tree_free(tree);
    return h;
}

/* Those that any text in a tree names. What is no file's name costs a look. */
static Hash hash_files(Hash h, const CaseNode *node, const char *folder, int included, int depth)
{
    included |= node->key && !strcmp(node->key, "include");
    if (node->kind == NODE_TEXT && *node->text) return hash_file(h, node->text, folder, included, depth);
    for (const CaseNode *child = node->first; child; child = child->next)
        h = hash_files(h, child, folder, included, depth);
    return h;
}

/* Those that a parameter's choices name, which are YAML as a case has it. */
static Hash hash_choices(Hash h, const Parameter *p, const char *folder)
{
    hawser_error none;
    for (int k = 0; k < p->n_choices; k++) {
        CaseNode *node;
        const char *const text = p->choice[k];
        if (text && !strpbrk(text, "[{\"'")) h = hash_file(h, text, folder, 0, 0);
        if (!text || !strpbrk(text, "[{\"'") || yaml_read(text, strlen(text), p->name, 0, &node, &none)) continue;
        for (int i = 0; i < p->n_keys; i++) h = hash_files(h, node, folder, !strcmp(p->key[i], "include"), 0);
        node_free(node);
    }
    return h;
}

/* Whether a case takes something by its `type`, from a catalogue. */
static int has_type(const CaseNode *node)
{
    int found = node->key && !strcmp(node->key, "type");
    for (const CaseNode *child = node->first; child && !found; child = child->next) found = has_type(child);
    return found;
}

static int may_have_type(const Study *s)
{
    int found = has_type(s->base->tree->root);
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        for (int k = 0; k < p->n_keys; k++) found |= strstr(p->key[k], "type") != NULL;
        for (int k = 0; k < p->n_choices; k++) found |= p->choice[k] && strstr(p->choice[k], "type");
    }
    return found;
}

/* The shipped catalogue, in whatever order; where it is not there, no sample finds it either. */
static hawser_status hash_shipped(const Study *s, Hash *h, hawser_error *err)
{
    hawser_error none;
    if (!may_have_type(s)) return HAWSER_OK;
    Library *const library = library_new();
    if (!library) return error_memory(err);
    Hash all = 0;
    const int there = library_ship(library, &none) == HAWSER_OK;
    for (int k = 0; there && k < library->n_files; k++) all += hash_node(HASH_BEGIN, library->file[k]->root);
    library_free(library);
    *h = hash_bytes(*h, &all, sizeof all);
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------------------- study */

/* All that a row depends on: the program, the base case as it is built, every file that the base or a variant names,
 * and the catalogue; what is varied and looked at. The number of samples only where the points depend on it, so that a
 * study may be made longer. */
hawser_status study_identity(const Study *s, const char *also, uint64_t *out, hawser_error *err)
{
    char *built = NULL;
    const hawser_status status = hawser_case_describe(s->base, HAWSER_JSON, &built, NULL);
    if (status == HAWSER_ERR_MEMORY) return error_memory(err);
    Hash h = hash_text(hash_text(HASH_BEGIN, hawser_version()), built); /* a base that is no case by itself: nothing */
    hawser_text_free(built);
    h = hash_node(h, s->base->tree->root);
    const char *const folder = s->base->tree->folder;
    h = hash_files(h, s->base->tree->root, folder, 0, 0);
    for (int j = 0; j < s->n_parameters; j++) h = hash_choices(h, &s->parameter[j], folder);
    if (hash_shipped(s, &h, err)) return HAWSER_ERR_MEMORY;
    char version[32];
    const int whole = s->kind != STUDY_MONTE_CARLO || s->points == POINTS_LATIN;
    const double plain[] = {s->kind,          s->fidelity,     s->pilot ? 0 : s->close[0],
                            (double)s->pilot, (double)s->seed, s->kind == STUDY_MONTE_CARLO ? s->points : 0,
                            STORE_FORMAT,     sizeof(Row),     whole ? (double)s->samples : 0};
    h = hash_bytes(h, plain, sizeof plain);
    for (int j = 0; j < s->n_parameters; j++) h = hash_parameter(h, &s->parameter[j]);
    const size_t d = (size_t)s->n_parameters;
    if (s->factor) h = hash_bytes(h, s->factor, d * d * sizeof *s->factor);
    for (int q = 0; q < s->n_quantities; q++) h = hash_number(hash_text(h, s->quantity[q].path), s->quantity[q].of);
    for (int k = 0; k < s->measured.n; k++) {
        const LogPoint *const p = &s->measured.point[k];
        const double one[] = {p->at, p->force, p->restart, s->measured.weight[k]};
        h = hash_bytes(h, one, sizeof one);
    }
    if (study_searches(s)) h = hash_text(hash_aim(h, &s->aim), search_version(version));
    *out = also ? hash_text(h, also) : h;
    return HAWSER_OK;
}
