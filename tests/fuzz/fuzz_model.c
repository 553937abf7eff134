/* Models of the environment: any bytes as a GLB, STL or DXF file. What is read can be measured. */
#define _GNU_SOURCE /* memfd_create */
#include <math.h>
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

#include "survey/model.h"
#include "tests/fuzz/fuzz.h"

FUZZ_TARGET(model)
{
    static const char *part[] = {"roller*"}, *left[] = {"pipe"};
    const ModelOptions options = {.unit = 1, .up = 'z', .leave = {1, left}, .equipment = {1, part}};
    char path[64];
    Mesh mesh;
    Survey found;
    hawser_error err;
    const int fd = memfd_create("model", 0);
    FUZZ_MUST(fd >= 0 && write(fd, data, size) == (ssize_t)size);
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    const hawser_status status = model_read(path, &options, &mesh, &found, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    for (int t = 0; !status && t < mesh.n_triangles; ++t) {
        FUZZ_MUST(mesh.layer[t] >= 0 && mesh.layer[t] < mesh.n_layers);
        for (int k = 0; k < 3; ++k) FUZZ_MUST(mesh.triangle[t][k] >= 0 && mesh.triangle[t][k] < mesh.n_vertices);
    }
    if (!status) FUZZ_MUST(mesh_area(&mesh) >= 0 && !isnan(mesh_volume(&mesh)));
    if (!status) mesh_free(&mesh);
    if (!status) survey_clear(&found);
    close(fd);
    return 0;
}
