/* The file is rewritten from its last state on with every call, in one piece: a reader, or a kill, meets a whole
 * document. */
#include "io/results/results_file.h"

#include <errno.h>

static const char head[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                           "<!-- The chain of segment centres, from the tail to the winch; SI units. -->\n"
                           "<Xdmf Version=\"3.0\">\n"
                           " <Domain>\n"
                           "  <Grid Name=\"cable\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
static const char tail[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

/* Closing tags over everything after x->end. */
static hawser_status write_tail(XdmfFile *x, hawser_error *err)
{
    hawser_status status = out_print(&x->out, err, "%s", tail);
    if (!status) status = out_flush(&x->out, err);
    return status;
}

/* An empty collection is a valid document, too. */
hawser_status xdmf_open(XdmfFile *x, const char *dir, int segments, hawser_error *err)
{
    x->segments = segments;
    hawser_status status = out_open(&x->out, dir, "results.xdmf", err);
    if (status) return status;
    /* one write a call, so that a reader (or a kill) meets a complete document */
    setvbuf(x->out.f, NULL, _IOFBF, 1 << 16);
    status = out_print(&x->out, err, "%s", head);
    x->end = (long)sizeof head - 1;
    return status ? status : write_tail(x, err);
}

/* One array of a frame: rows x 3 (a vector) or rows. */
static hawser_status write_attribute(XdmfFile *x, long frame, const char *name, const char *centre, int rows,
                                     int vector, hawser_error *err)
{
    return out_print(&x->out, err,
                     "    <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"%s\">\n"
                     "     <DataItem Dimensions=\"%d%s\" NumberType=\"Float\" Precision=\"4\" Format=\"HDF\">"
                     "results.h5:/frames/%06ld/%s</DataItem>\n    </Attribute>\n",
                     name, vector ? "Vector" : "Scalar", centre, rows, vector ? " 3" : "", frame, name);
}

/* The grid of one state: cells join neighbouring centres, so that the tension of joint 1..n-1 is theirs. */
static hawser_status write_frame(XdmfFile *x, long frame, double t, hawser_error *err)
{
    const int n = x->segments;
    hawser_status s =
        out_print(&x->out, err,
                  "   <Grid Name=\"cable\" GridType=\"Uniform\">\n"
                  "    <Time Value=\"%.12g\"/>\n"
                  "    <Topology TopologyType=\"Polyline\" NumberOfElements=\"%d\" NodesPerElement=\"2\">\n"
                  "     <DataItem Dimensions=\"%d 2\" NumberType=\"Int\" Precision=\"4\" Format=\"HDF\">"
                  "results.h5:/connectivity</DataItem>\n    </Topology>\n"
                  "    <Geometry GeometryType=\"XYZ\">\n"
                  "     <DataItem Dimensions=\"%d 3\" NumberType=\"Float\" Precision=\"4\" Format=\"HDF\">"
                  "results.h5:/frames/%06ld/position</DataItem>\n    </Geometry>\n",
                  t, n - 1, n - 1, n, frame);
    /* the position once more as data, for readers that keep the first frame's points */
    if (!s) s = write_attribute(x, frame, "position", "Node", n, 1, err);
    if (!s) s = write_attribute(x, frame, "axial_speed", "Node", n, 0, err);
    if (!s) s = write_attribute(x, frame, "tension", "Cell", n - 1, 0, err);
    return s ? s : out_print(&x->out, err, "   </Grid>\n");
}

/* The closing tags are overwritten by the new states and written again behind them. */
hawser_status xdmf_append(XdmfFile *x, int n, long first, const double *t, hawser_error *err)
{
    errno = 0;
    if (fseek(x->out.f, x->end, SEEK_SET)) return out_error(x->out.path, errno, err);
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
