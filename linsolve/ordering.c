#include "linsolve/backend.h"

#include <metis.h>
#include <stdlib.h>

/* The graph of the groups: METIS wants it symmetric, without loops. */
typedef struct Graph {
    idx_t groups;
    idx_t *start, *neighbour, *weight; /* [groups+2], [edges], [groups] */
    int *group_of;                     /* [n] */
    int *seen;                         /* [groups]: last vertex that met this one */
} Graph;

/* First unknown of group g. */
static int group_first(const LinMatrix *a, int g) { return a->group_at ? a->group_at[g] : g; }

static void graph_free(Graph *g)
{
    free(g->start);
    free(g->neighbour);
    free(g->weight);
    free(g->group_of);
    free(g->seen);
}

static int graph_alloc(Graph *g, const LinMatrix *a)
{
    const size_t groups = (size_t)a->groups, entries = (size_t)a->sparse->p[a->sparse->n];
    *g = (Graph){.groups = a->groups,
                 .start = calloc(groups + 2, sizeof(idx_t)),
                 .neighbour = malloc((2 * entries + 1) * sizeof(idx_t)),
                 .weight = malloc((groups + 1) * sizeof(idx_t)),
                 .group_of = malloc(((size_t)a->sparse->n + 1) * sizeof(int)),
                 .seen = malloc((groups + 1) * sizeof(int))};
    return g->start && g->neighbour && g->weight && g->group_of && g->seen;
}

/* Visits every coupled pair of groups once from its column's side; counts (neighbour == NULL) or appends both ways. */
static void graph_visit(Graph *g, const LinMatrix *a, idx_t *next, idx_t *neighbour)
{
    const SparseMatrix *const s = a->sparse;
    for (int v = 0; v < a->groups; ++v) g->seen[v] = -1;
    for (int v = 0; v < a->groups; ++v) {
        for (int k = s->p[group_first(a, v)]; k < s->p[group_first(a, v + 1)]; ++k) {
            const int u = g->group_of[s->i[k]];
            if (u == v || g->seen[u] == v) continue;
            g->seen[u] = v;
            if (neighbour) neighbour[next[v]] = u, neighbour[next[u]] = v;
            ++next[v];
            ++next[u];
        }
    }
}

/* A pair coupled both ways was appended twice: keeps the first of each. */
static void graph_compact(Graph *g)
{
    idx_t to = 0, from = 0;
    for (idx_t v = 0; v < g->groups; ++v) g->seen[v] = -1;
    for (idx_t v = 0; v < g->groups; ++v) {
        const idx_t end = g->start[v + 1];
        for (; from < end; ++from) {
            const idx_t u = g->neighbour[from];
            if (g->seen[u] == v) continue;
            g->seen[u] = (int)v;
            g->neighbour[to++] = u;
        }
        g->start[v + 1] = to;
    }
}

static void graph_fill(Graph *g, const LinMatrix *a)
{
    for (int v = 0; v < a->groups; ++v) {
        g->weight[v] = group_first(a, v + 1) - group_first(a, v);
        for (int i = group_first(a, v); i < group_first(a, v + 1); ++i) g->group_of[i] = v;
    }
    graph_visit(g, a, g->start + 2, NULL);
    for (int v = 0; v < a->groups; ++v) g->start[v + 2] += g->start[v + 1];
    graph_visit(g, a, g->start + 1, g->neighbour);
    graph_compact(g);
}

/* perm over unknowns from the order of the groups. */
static void spell_out(const LinMatrix *a, const idx_t *order, int *perm)
{
    int at = 0;
    for (int k = 0; k < a->groups; ++k) {
        const int g = order ? (int)order[k] : k;
        for (int i = group_first(a, g); i < group_first(a, g + 1); ++i) perm[at++] = i;
    }
}

/* Runs METIS; tiny graphs and graphs without edges stay as they are (METIS 5.1 does not take them). */
static int dissect(Graph *g, const LinMatrix *a, int *perm)
{
    if (g->groups < 3 || g->start[g->groups] == 0) {
        spell_out(a, NULL, perm);
        return 0;
    }
    idx_t *const order = malloc(2 * (size_t)g->groups * sizeof *order);
    if (!order) return -1;
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;
    options[METIS_OPTION_SEED] = 1;
    const int status = METIS_NodeND(&g->groups, g->start, g->neighbour, g->weight, options, order, order + g->groups);
    if (status == METIS_OK) spell_out(a, order, perm);
    free(order);
    return status == METIS_OK ? 0 : status == METIS_ERROR_MEMORY ? -1 : 1;
}

int ordering_metis(const LinMatrix *a, int *perm)
{
    Graph g;
    int status = -1;
    if (graph_alloc(&g, a)) {
        graph_fill(&g, a);
        status = dissect(&g, a, perm);
    }
    graph_free(&g);
    return status;
}
