#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

static const double PI = 3.14159265358979323846;

/* Counts only what has been read so far, so that it also serves while the chain is being read. */
int case_segments(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < def->n_pieces; p++) n += def->pieces[p].segments;
    return n;
}

double case_chain_length(const SceneDef *def)
{
    double length = 0;
    for (int p = 0; p < def->n_pieces; p++) length += def->pieces[p].length;
    return length;
}

/* The same eye as the scene's: between the last piece and those behind it. */
int case_eye(const SceneDef *def)
{
    const int n = case_segments(def);
    return def->n_pieces > 1 ? n - def->pieces[def->n_pieces - 1].segments : n;
}

/* Of the cables that are in the chain; one that is only listed does not count. */
double case_largest_diameter(const SceneDef *def)
{
    double largest = 0;
    for (int p = 0; p < def->n_pieces; p++) largest = fmax(largest, def->cables[def->pieces[p].cable].diameter);
    return largest;
}

/* One property: the first that is known of what was given directly and what the shorthand gives; `shorthand`
 * names what the latter needs. */
static hawser_status property(const CaseReader *r, const CaseNode *node, const char *key, const char *shorthand,
                              double direct, double derived, double *out)
{
    *out = isnan(direct) ? derived : direct;
    if (!isnan(*out)) return HAWSER_OK;
    return case_key_error(r->err, node, key, "missing: give it, or %s", shorthand);
}

/* Ratios that are given take the place of time and factor; a ratio of zero is a factor of zero. */
static void ratios_take(const RatioRecord *record, CableDef *cable)
{
    const double ratio[6] = {record->axial,   record->shear,   record->shear,
                             record->torsion, record->bending, record->bending};
    for (int c = 0; c < 6; c++) {
        if (isnan(ratio[c])) continue;
        cable->damping_ratio[c] = ratio[c];
        if (ratio[c] <= 0) cable->damping_factor[c] = 0;
    }
    cable->damping_ratio_at = isnan(record->at) ? 0 : record->at;
}

/* The paper's eq. 2: EA = E A, GA = G A, GJ = G pi d^4/32, EI = E pi d^4/64, each unless given directly. */
static hawser_status cable_resolve(const CaseReader *r, const CaseNode *node, const CableRecord *c, CableDef *cable)
{
    const double J = PI * pow(c->d, 4) / 32, EI = isnan(c->EI) ? c->E * J / 2 : c->EI;
    hawser_status s = property(r, node, "EA", "E and A", c->EA, c->E * c->A, &cable->ea);
    if (!s) s = property(r, node, "GA", "G and A", c->GA, c->G * c->A, &cable->ga);
    if (!s) s = property(r, node, "GJ", "G", c->GJ, c->G * J, &cable->gj);
    if (case_node_key(node, "bending")) {
        if (!s) s = case_bending_read(r, node, &c->bending, cable);
    } else {
        if (!s) s = property(r, node, "EI_y", "EI, or E", c->EI_y, EI, &cable->ei_y);
        if (!s) s = property(r, node, "EI_z", "EI, or E", c->EI_z, EI, &cable->ei_z);
    }
    if (!s) s = property(r, node, "mass", "density and A", c->mass, c->density * c->A, &cable->mass);
    cable->diameter = c->d;
    cable->damping = c->damping;
    const double factor[6] = {c->factor.axial,   c->factor.shear,   c->factor.shear,
                              c->factor.torsion, c->factor.bending, c->factor.bending};
    memcpy(cable->damping_factor, factor, sizeof factor);
    ratios_take(&c->ratio, cable);
    const double preload[6] = {c->preload.axial,   c->preload.shear_y,   c->preload.shear_z,
                               c->preload.torsion, c->preload.bending_y, c->preload.bending_z};
    memcpy(cable->preload, preload, sizeof preload);
    return s;
}

/* The names are the user's: each key of the map is a cable. */
hawser_status case_cables_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    if (node->count == 0) return case_value_error(r->err, node, " without a cable: expected one at least");
    def->cables = calloc((size_t)node->count, sizeof *def->cables);
    if (!def->cables) return error_memory(r->err);
    def->n_cables = node->count;
    for (const CaseNode *child = node->first; child; child = child->next) {
        CableDef *cable = &def->cables[child->index];
        CableRecord record = {0};
        if (strlen(child->key) >= sizeof cable->name) {
            return case_key_error(r->err, child, NULL, "the name is too long: at most %zu characters",
                                  sizeof cable->name - 1);
        }
        strcpy(cable->name, child->key);
        hawser_status status = case_section_read(r, child, &case_cable, &record);
        if (!status) status = cable_resolve(r, child, &record, cable);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* The cable that a piece names. */
static hawser_status cable_find(const CaseReader *r, const CaseNode *piece, int *cable)
{
    const CaseNode *name = case_node_key(piece, "cable");
    const CableDef *cables = r->def->cables;
    for (*cable = 0; *cable < r->def->n_cables; ++*cable) {
        if (strcmp(cables[*cable].name, name->text) == 0) return HAWSER_OK;
    }
    const char *known = cables[0].name;
    for (int c = 0; c < r->def->n_cables; c++) {
        const char *const one = cables[c].name;
        if (case_nearest(name->text, &one, 1)) known = one;
    }
    return case_value_error(r->err, name, " is not one of the %d in 'cables', such as '%s'", r->def->n_cables, known);
}

/* Segments of equal length, none longer than asked for. */
static hawser_status segments_count(const CaseReader *r, const CaseNode *piece, const PieceRecord *record,
                                    int *segments)
{
    const double n = ceil(record->length / record->segment - 1e-6);
    if (n + case_segments(r->def) > CASE_SEGMENTS_MAX) {
        return case_key_error(r->err, piece, "segment", "too short: the chain may have %d segments at most",
                              CASE_SEGMENTS_MAX);
    }
    *segments = n < 1 ? 1 : (int)n;
    return HAWSER_OK;
}

/* One piece of the chain, with its cable found and its segments counted. */
static hawser_status piece_read(const CaseReader *r, const CaseNode *node, ChainPieceDef *piece)
{
    PieceRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_chain_piece, &record);
    if (!status) status = cable_find(r, node, &piece->cable);
    if (!status) status = segments_count(r, node, &record, &piece->segments);
    if (status) return status;
    piece->length = record.length;
    piece->swivel = record.swivel;
    if (node->index == 0 && record.swivel) {
        return case_value_error(r->err, case_node_key(node, "swivel"),
                                ": the first piece has no eye behind it: expected false");
    }
    return HAWSER_OK;
}

/* n_pieces grows as they are read, which segments_count relies on. */
hawser_status case_chain_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    if (node->count == 0) return case_value_error(r->err, node, " without a piece: expected one at least");
    def->pieces = calloc((size_t)node->count, sizeof *def->pieces);
    if (!def->pieces) return error_memory(r->err);
    for (const CaseNode *child = node->first; child; child = child->next) {
        const hawser_status status = piece_read(r, child, &def->pieces[child->index]);
        if (status) return status;
        def->n_pieces++;
    }
    return HAWSER_OK;
}
