/* The file is rewritten from its last state on with every call, in one piece: a reader, or a kill, meets a whole
 * document. The geometry is a tree, which readers of time series pass over. */
#include "io/results/results_file.h"

#include <errno.h>

static const char head[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                           "<!-- The chain of segment centres, from the tail to the winch; SI units. -->\n"
                           "<Xdmf Version=\"3.0\">\n"
                           " <Domain>\n";
static const char states[] = "  <Grid Name=\"cable\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
static const char tail[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

/* Closing tags over everything after x->end. */
static hawser_status write_tail(XdmfFile *x, hawser_error *err)
{
    hawser_status status = out_print(&x->out, err, "%s", tail);
    if (!status) status = out_flush(&x->out, err);
    return status;
}

/* An array of results.h5: rows of `width` numbers (0: one, without a dimension of its own), floats or ints of so many
 * bytes. */
static hawser_status write_item(XdmfFile *x, int rows, int width, int floats, int bytes, const char *group,
                                const char *set, hawser_error *err)
{
    char columns[16] = "";
    if (width > 0) snprintf(columns, sizeof columns, " %d", width);
    return out_print(&x->out, err,
                     "     <DataItem Dimensions=\"%d%s\" NumberType=\"%s\" Precision=\"%d\" Format=\"HDF\">"
                     "results.h5:/%s%s</DataItem>\n",
                     rows, columns, floats ? "Float" : "Int", bytes, group, set);
}

/* The beginning of a grid of `cells` cells, whose points are in `connectivity`, [cells][corners]. */
static hawser_status begin_grid(XdmfFile *x, const char *name, const char *type, int cells, int corners,
                                const char *connectivity, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err,
                                "   <Grid Name=\"%s\" GridType=\"Uniform\">\n"
                                "    <Topology TopologyType=\"%s\" NumberOfElements=\"%d\" NodesPerElement=\"%d\">\n",
                                name, type, cells, corners);
    if (!s) s = write_item(x, cells, corners, 0, 4, "", connectivity, err);
    return s ? s : out_print(&x->out, err, "    </Topology>\n");
}

/* The points of a grid, [points][3]. */
static hawser_status write_points(XdmfFile *x, int points, int bytes, const char *group, const char *set,
                                  hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "    <Geometry GeometryType=\"XYZ\">\n");
    if (!s) s = write_item(x, points, 3, 1, bytes, group, set, err);
    return s ? s : out_print(&x->out, err, "    </Geometry>\n");
}

/* A field on points or on cells. */
static hawser_status write_field(XdmfFile *x, const char *name, int on_cells, int rows, int width, int floats,
                                 int bytes, const char *group, const char *set, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "    <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"%s\">\n", name,
                                width ? "Vector" : "Scalar", on_cells ? "Cell" : "Node");
    if (!s) s = write_item(x, rows, width, floats, bytes, group, set, err);
    return s ? s : out_print(&x->out, err, "    </Attribute>\n");
}

static hawser_status write_route(XdmfFile *x, int n, hawser_error *err)
{
    if (n < 2) return HAWSER_OK;
    hawser_status s = begin_grid(x, "route", "Polyline", n - 1, 2, "geometry/route/line", err);
    if (!s) s = write_points(x, n, 8, "geometry/route/", "position", err);
    if (!s) s = write_field(x, "s", 0, n, 0, 1, 8, "geometry/route/", "s", err);
    if (!s) s = write_field(x, "curvature", 0, n, 0, 1, 8, "geometry/route/", "curvature", err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

static hawser_status write_skin(XdmfFile *x, const Skin *skin, hawser_error *err)
{
    const int n = skin->n_triangles;
    if (n == 0) return HAWSER_OK;
    hawser_status s = begin_grid(x, "equipment", "Triangle", n, 3, "geometry/mesh/triangles", err);
    if (!s) s = write_points(x, skin->n_points, 4, "geometry/mesh/", "points", err);
    if (!s) s = write_field(x, "part", 1, n, 0, 0, 4, "geometry/mesh/", "part", err);
    if (!s) s = write_field(x, "item", 1, n, 0, 0, 4, "geometry/mesh/", "item", err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

/* What stands around the cable at all times. */
static hawser_status write_geometry(XdmfFile *x, const Geometry *g, hawser_error *err)
{
    hawser_status s = out_print(&x->out, err, "  <Grid Name=\"geometry\" GridType=\"Tree\">\n");
    if (!s) s = write_route(x, g->n_route, err);
    if (!s) s = write_skin(x, &g->skin, err);
    return s ? s : out_print(&x->out, err, "  </Grid>\n");
}

/* An empty collection is a valid document, too. */
hawser_status xdmf_open(XdmfFile *x, const OutDir *dir, const ResultsDef *def, hawser_error *err)
{
    const Geometry *const g = def->geometry;
    x->segments = def->segments;
    x->sizes = g != NULL;
    hawser_status status = out_open_in(&x->out, dir, "results.xdmf", err);
    if (status) return status;
    /* one write a call, so that a reader (or a kill) meets a complete document */
    setvbuf(x->out.f, NULL, _IOFBF, 1 << 16);
    status = out_print(&x->out, err, "%s", head);
    if (!status && g && (g->n_route > 1 || g->skin.n_triangles > 0)) status = write_geometry(x, g, err);
    if (!status) status = out_print(&x->out, err, "%s", states);
    if (status) return status;
    x->end = ftell(x->out.f);
    return write_tail(x, err);
}

hawser_status xdmf_can_resume(const OutDir *dir, long end, hawser_error *err)
{
    return out_can_resume(dir, "results.xdmf", end, ">\n", err);
}

hawser_status xdmf_resume(XdmfFile *x, const OutDir *dir, const ResultsDef *def, long end, hawser_error *err)
{
    x->segments = def->segments;
    x->sizes = def->geometry != NULL;
    const hawser_status status = out_resume(&x->out, dir, "results.xdmf", end, err);
    if (status) return status;
    setvbuf(x->out.f, NULL, _IOFBF, 1 << 16);
    x->end = end;
    return write_tail(x, err);
}

/* The grid of one state: cells join neighbouring centres, so that what joint 1..n-1 has is theirs. The position is
 * there once more as data, for readers that keep the first frame's points. */
static hawser_status write_frame(XdmfFile *x, long frame, double t, hawser_error *err)
{
    const int n = x->segments;
    char group[32];
    snprintf(group, sizeof group, "frames/%06ld/", frame);
    hawser_status s = begin_grid(x, "cable", "Polyline", n - 1, 2, "connectivity", err);
    if (!s) s = out_print(&x->out, err, "    <Time Value=\"%.12g\"/>\n", t);
    if (!s) s = write_points(x, n, 4, group, "position", err);
    for (int k = 0; k < sample_columns && !s; k++) {
        const SampleColumn *const c = &sample_column[k];
        const int cells = c->per == PER_JOINT;
        if (c->frame) s = write_field(x, c->frame, cells, n - cells, c->width, 1, 4, group, c->frame, err);
    }
    if (!s && x->sizes) s = write_field(x, "diameter", 0, n, 0, 1, 8, "chain/", "diameter", err);
    if (!s && x->sizes) s = write_field(x, "part", 0, n, 0, 0, 4, "chain/", "part", err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

/* The closing tags are overwritten by the new states and written again behind them. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err)
{
    errno = 0;
    if (fseek(x->out.f, x->end, SEEK_SET)) return out_error(x->out.spot.path, errno, err);
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; i++) status = write_frame(x, first + i, t[i], err);
    if (status) return status;
    const long end = ftell(x->out.f);
    status = write_tail(x, err);
    /* a state that did not get out in full is written over by the next */
    if (!status) x->end = end;
    return status;
}

/* Nothing is missing at the end, since every call left a whole document. */
hawser_status xdmf_close(XdmfFile *x, hawser_error *err) { return out_close(&x->out, err); }
