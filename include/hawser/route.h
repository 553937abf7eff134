/* Routes from files: drawings (DXF), models (LandXML, IFC), tables (CSV, spreadsheets), maps (GeoJSON, GPX, KML,
 * shapefiles). Part of hawser/hawser.h, which includes it. docs/formats.md describes what is read from each. Lengths in
 * m; x east, y north, z up, in the file's own system of coordinates. */
#ifndef HAWSER_ROUTE_H
#define HAWSER_ROUTE_H

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Options for reading a file; texts NULL: any, or none. They are copied. */
typedef struct hawser_route_options {
    const char *name, *layer; /* only lines of this name, on this layer of a drawing; case ignored */
    const char *units;        /* the file's unit of length, "mm" or "ft", in place of the one in the file */
    const char *profile;      /* another file, or a table of stations, with the heights */
    int reverse;              /* the route goes from the line's end to its start */
    double from_m, to_m;      /* stations of the file between which the line is used; NAN: its ends */
    double tolerance_m; /* allowed distance of the route from the file's line: elements that do not join, and lines of
                         * points, are fitted within it */
    double radius_m;    /* radius of the corners of lines of points; NAN: they are fitted instead */
    double join_m;      /* distance within which ends of a drawing's pieces are joined; at most 10 m */
    const char *sheet;  /* of a spreadsheet, by its name or its number from 1; NULL: the first */
    const char *ignore; /* names of a table's columns that are ignored, with commas between; NULL: none */
} hawser_route_options;

/* Returns the defaults: nothing chosen, 50 mm, joined within 10 mm. */
hawser_route_options hawser_route_defaults(void);

/* The lines of a file. */
typedef struct hawser_routes hawser_routes;

typedef struct hawser_route_figures {
    const char *name, *layer;      /* "" if it has none; the handle's */
    double length_m;               /* length of the file's own line */
    double horizontal_length_m;    /* the same in plan */
    double station_m;              /* the file's station at the start of the line */
    double start_m[3], end_m[3];   /* its ends */
    int pieces;                    /* straights, arcs and clothoids in plan; for points straights */
    int fitted;                    /* the pieces are fitted to the file's line */
    double least_radius_m;         /* in plan; infinite: straight */
    double deviation_max_m, rms_m; /* distances of the pieces from the file's line */
    const char *problem;           /* reason why it cannot be a route; NULL: it can */
} hawser_route_figures;

/* An arc in plan, of a line as it would be built. */
typedef struct hawser_route_bend {
    double station_m, length_m; /* station of its start in the file's numbers; length along it */
    double turn;                /* rad, to the left positive */
    double radius_m;
    double radius_sd_m; /* for a fit, one standard deviation from the scatter of the points; NAN: the file's own radius,
                         * or a corner's that is as large as the deviation allows */
} hawser_route_bend;

/* A place of a route. */
typedef struct hawser_route_place {
    double position_m[3], tangent[3]; /* tangent: unit */
    double curvature_per_m[3];        /* toward the centre */
} hawser_route_place;

/* Reads the lines that the options choose (NULL: the defaults); pieces of a drawing's layer are joined. A line that
 * cannot be a route is included, with its problem; but if a single one is chosen, and cut or given heights, that is an
 * error. Errors: INPUT with file, line and reason; MEMORY. *out is NULL then. */
hawser_status hawser_routes_read(const char *path, const hawser_route_options *options, hawser_routes **out,
                                 hawser_error *err);
void hawser_routes_free(hawser_routes *r);
/* Returns how many lines there are. */
int hawser_routes_count(const hawser_routes *r);
/* Returns the text that `hawser route` prints. *text is malloc'ed: free it with hawser_text_free. Errors: MEMORY. */
hawser_status hawser_routes_describe(const hawser_routes *r, hawser_format format, char **text, hawser_error *err);
/* Returns the figures of one line, 0 <= i < count. Errors: INPUT (no such line). */
hawser_status hawser_routes_figures(const hawser_routes *r, int i, hawser_route_figures *out, hawser_error *err);
/* Returns all arcs of a line in plan, in their order: *n of them in *bends, which is malloc'ed: free it with
 * hawser_route_bends_free. Errors: INPUT (no such line, or it cannot be a route), MEMORY. */
hawser_status hawser_routes_bends(const hawser_routes *r, int i, int *n, hawser_route_bend **bends, hawser_error *err);
void hawser_route_bends_free(hawser_route_bend *bends);
/* Return the length in space of the route built from a line, and the place s metres along it from its start; beyond its
 * ends it goes on straight. Errors: INPUT (no such line, or it cannot be a route: its problem), MEMORY. */
hawser_status hawser_routes_length(hawser_routes *r, int i, double *length_m, hawser_error *err);
hawser_status hawser_routes_at(hawser_routes *r, int i, double s_m, hawser_route_place *out, hawser_error *err);
/* Writes the line as it would be built: a table (.csv), a drawing (.dxf), a map (.geojson) or the section `route` of a
 * case (.yaml). i < 0: the line that a case would use. A page (.html) shows it in plan and profile, omitted parts in
 * grey; i < 0: every line. "-" writes the section to standard output. Errors: INPUT (several lines are possible, an
 * ending that is none of these), OUTPUT, MEMORY.
 */
hawser_status hawser_routes_write(const hawser_routes *r, int i, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
