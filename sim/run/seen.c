/* The environment as it is shown. A file of its own, since the library in a mock-up unit shows nothing and is linked
 * without libmeshoptimizer. */
#include "sim/run/geometry.h"

#include <stdio.h>
#include <stdlib.h>

#include "contact/simplify.h"
#include "core/error.h"

hawser_status geometry_see(Geometry *g, const EnvironmentDef *def, hawser_error *err)
{
    GeometrySeen *const seen = &g->seen;
    seen->given = def->mesh.n_triangles;
    if (seen->given == 0 || (seen->given > SEEN_TRIANGLES && !mesh_can_simplify())) return HAWSER_OK;
    const hawser_status status = mesh_simplify(&def->mesh, SEEN_TRIANGLES, &seen->mesh, &seen->error, err);
    if (status) return status;
    seen->layer_name = calloc((size_t)seen->mesh.n_layers + 1, sizeof *seen->layer_name);
    if (!seen->layer_name) return error_memory(err);
    for (int i = 0; i < seen->mesh.n_layers; ++i)
        snprintf(seen->layer_name[i], sizeof *seen->layer_name, "%s", seen->mesh.layer_name[i]);
    return HAWSER_OK;
}
