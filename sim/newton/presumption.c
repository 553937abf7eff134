#include "sim/newton/presumption.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* Faces before those of a part's rollers. */
static int faces_before(const Workspace *ws, int part) { return 2 * ws->contact[part].first; }

static int has_rollers(const Workspace *ws, int part) { return ws->contact[part].model.n_rollers > 0; }

void pressed_find(const Scene *scene, Workspace *ws, const Pressed *out)
{
    static const Presume how = {.from = PRESUME_GAPS};
    memset(out->patch, 0, (size_t)ws->surfaces.n_patches * sizeof *out->patch);
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const c = &ws->contact[p];
        if (has_rollers(ws, p))
            contact_presume(&c->model, &scene->chain, &ws->kin, &c->pairs, &how, NULL, out->face + faces_before(ws, p));
        if (ws->surfaces.n_patches > 0)
            surface_pressed(&ws->surfaces, &scene->chain, &ws->kin, &c->surface, out->patch);
    }
}

/* before: as contact_presume has it, of all rollers; patch: as surface_presume does. */
static hawser_status presume_all(Presumption *p, const Scene *scene, Workspace *ws, const Presume *how,
                                 const double *before, const double *patch, hawser_error *err)
{
    for (int part = 0; part < PARTS; ++part) {
        ContactPart *const c = &ws->contact[part];
        const int from = faces_before(ws, part);
        if (has_rollers(ws, part))
            contact_presume(&c->model, &scene->chain, &ws->kin, &c->pairs, how, before ? before + from : NULL,
                            p->next + from);
        if (ws->surfaces.n_patches > 0 &&
            !surface_presume(&ws->surfaces, &scene->chain, &ws->kin, &c->surface, how, patch, &p->surface[part]))
            return error_memory(err);
    }
    double *const now = p->next;
    p->next = p->face;
    p->face = now;
    return HAWSER_OK;
}

hawser_status presumption_begin(Presumption *p, const Scene *scene, Workspace *ws, const Pressed *last,
                                hawser_error *err)
{
    const size_t faces = 2 * (size_t)scene->contact.n_rollers + 1;
    const Presume how = {.from = last ? PRESUME_LAST : PRESUME_GAPS, .gravity = v3_norm(scene->weight.gravity)};
    *p = (Presumption){.face = calloc(faces, sizeof(double)), .next = calloc(faces, sizeof(double))};
    if (!p->face || !p->next) return error_memory(err);
    return presume_all(p, scene, ws, &how, last ? last->face : NULL, last ? last->patch : NULL, err);
}

hawser_status presumption_go_on(Presumption *p, const Scene *scene, Workspace *ws, double keep, hawser_error *err)
{
    const Presume how = {.from = PRESUME_LINE, .gravity = v3_norm(scene->weight.gravity), .keep = keep};
    return presume_all(p, scene, ws, &how, p->face, NULL, err);
}

void presumption_use(const Presumption *p, Workspace *ws, int on)
{
    for (int part = 0; part < PARTS; ++part) {
        ContactPart *const c = &ws->contact[part];
        c->pairs.presumed = on ? p->face + faces_before(ws, part) : NULL;
        c->surface.presumed = on && p->surface[part].bed ? &p->surface[part] : NULL;
    }
}

void presumption_free(Presumption *p)
{
    free(p->face);
    free(p->next);
    for (int part = 0; part < PARTS; ++part) surface_presumed_free(&p->surface[part]);
    *p = (Presumption){0};
}
