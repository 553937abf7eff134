/* Shapefiles: PolyLine (Z, M) as lines, Point and MultiPoint as marks, by libshp; names from the table (.dbf) beside
 * them, the system of coordinates from the .prj. libshp only gets bytes in memory, whose sizes were checked. */
#define _GNU_SOURCE /* fmemopen */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/input.h"
#include "survey/map.h"

#ifndef HAWSER_SHAPEFILE
hawser_status shape_read(SurveyInput *in)
{
    return input_error(in, "a shapefile, which this build cannot read: build hawser with libshp (libshp-dev) and "
                           "HAWSER_SHAPEFILE=ON, or save the file as GeoJSON");
}
#else

#include <errno.h>
#include <shapefil.h>
#include <strings.h>
#include <unistd.h>

static const size_t FILE_MOST = (size_t)1 << 30, TEXT_MOST = 1 << 16;
enum { HEAD = 100, ROOM = 1 << 16, ROOM_TIMES = 4 }; /* memory required for a record: bytes, and times its size */

/* ------------------------------------------------------------------------------------------------------------- files
 */

/* The files of one name. libshp opens files by name: the name that it gets is the address of this struct. */
enum { FILE_SHP, FILE_SHX, FILE_DBF, FILE_PRJ, FILE_CPG, FILES };
typedef struct Files {
    char *text[FILES]; /* with a terminating 0; NULL: there is none */
    size_t size[FILES];
} Files;

static const char *const endings[FILES] = {".shp", ".shx", ".dbf", ".prj", ".cpg"};

/* libshp 1.6 also passes a pointer of the caller's, and declares what is written const. */
#ifdef SHAPELIB_AT_LEAST
#define USER_DATA , __attribute__((unused)) void *user
typedef const void Written;
#else
#define USER_DATA
typedef void Written;
#endif

static SAFile file_open(const char *name, const char *access USER_DATA)
{
    const char *const dot = strrchr(name, '.');
    void *address;
    (void)access;
    if (!dot || sscanf(name, "%p", &address) != 1) return NULL;
    const Files *const files = address;
    for (int i = 0; i < FILES; ++i) {
        if (!strcmp(dot, endings[i]) && files->size[i])
            return (SAFile)(void *)fmemopen(files->text[i], files->size[i], "rb");
    }
    return NULL;
}
static SAOffset file_read(void *to, SAOffset size, SAOffset n, SAFile file)
{
    return fread(to, size, n, (FILE *)(void *)file);
}
static SAOffset file_write(Written *from, SAOffset size, SAOffset n, SAFile file)
{
    (void)from, (void)size, (void)n, (void)file;
    return 0;
}
static SAOffset file_seek(SAFile file, SAOffset at, int from)
{
    return (SAOffset)fseek((FILE *)(void *)file, (long)at, from);
}
static SAOffset file_tell(SAFile file) { return (SAOffset)ftell((FILE *)(void *)file); }
static int file_flush(SAFile file) { return file ? 0 : EOF; }
static int file_close(SAFile file) { return fclose((FILE *)(void *)file); }
static int file_remove(const char *name USER_DATA) { return name ? EOF : 0; }
static void silent(const char *message) { (void)message; }

static SAHooks hooks(void)
{
    return (SAHooks){file_open,  file_read,  file_write,  file_seek, file_tell,
                     file_flush, file_close, file_remove, silent,    atof};
}

/* Reads the file with this extension beside the .shp, in small or in capital letters. */
static hawser_status beside_read(const SurveyInput *in, Files *files, int kind)
{
    const char *const slash = strrchr(in->path, '/'), *const dot = strrchr(slash ? slash : in->path, '.');
    const int stem = (int)(dot ? (size_t)(dot - in->path) : strlen(in->path));
    char *const path = malloc((size_t)stem + 8);
    if (!path) return error_memory(in->err);
    sprintf(path, "%.*s%s", stem, in->path, endings[kind]);
    if (access(path, F_OK))
        for (char *c = path + stem; *c; ++c) *c = *c >= 'a' ? (char)(*c - 'a' + 'A') : *c;
    SurveyInput beside = {0};
    hawser_status status = HAWSER_OK;
    if (!access(path, F_OK)) {
        status = input_open(&beside, path, &in->options, in->out, in->err);
        if (!status)
            status =
                input_all(&beside, kind < FILE_PRJ ? FILE_MOST : TEXT_MOST, &files->text[kind], &files->size[kind]);
        const int lost = status == HAWSER_ERR_MEMORY ? 0 : input_lost(&beside);
        if (lost) status = input_error(&beside, "cannot be read: %s", strerror(lost));
        input_close(&beside);
    }
    free(path);
    return status;
}

static unsigned big(const char *at)
{
    const unsigned char *const c = (const unsigned char *)at;
    return (unsigned)c[0] << 24 | (unsigned)c[1] << 16 | (unsigned)c[2] << 8 | c[3];
}
static void big_put(char *at, unsigned value)
{
    for (int i = 0; i < 4; ++i) at[i] = (char)(value >> (24 - 8 * i));
}

/* Builds the index of a .shp without one from its records: each states its length in words of 16 bits. */
static hawser_status index_make(const SurveyInput *in, Files *files)
{
    const char *const shp = files->text[FILE_SHP];
    const size_t size = files->size[FILE_SHP];
    char *const shx = malloc(size + HEAD);
    size_t n = HEAD;
    if (!shx) return error_memory(in->err);
    memcpy(shx, shp, HEAD);
    for (size_t at = HEAD; at + 8 <= size; n += 8) {
        const size_t words = big(shp + at + 4);
        big_put(shx + n, (unsigned)(at / 2));
        big_put(shx + n + 4, (unsigned)words);
        at += 8 + 2 * words;
    }
    big_put(shx + 24, (unsigned)(n / 2));
    files->text[FILE_SHX] = shx;
    files->size[FILE_SHX] = n;
    return HAWSER_OK;
}

/* Reads all files. Errors: INPUT (a file shorter than it states, or too large), MEMORY. */
static hawser_status files_read(SurveyInput *in, Files *files)
{
    const char *const dot = strrchr(in->path, '.');
    if (dot && !strcasecmp(dot, endings[FILE_SHX]))
        return input_error(in, "the index of a shapefile: give its .shp file");
    input_seek(in, 0);
    hawser_status status = input_all(in, FILE_MOST, &files->text[FILE_SHP], &files->size[FILE_SHP]);
    for (int i = FILE_SHX; i < FILES && !status; ++i) status = beside_read(in, files, i);
    if (status) return status;
    if (files->size[FILE_SHP] < HEAD) return input_error(in, "shorter than the %d bytes a shapefile begins with", HEAD);
    if (!files->text[FILE_SHX]) status = index_make(in, files);
    for (int i = FILE_SHP; i <= FILE_SHX && !status; ++i) {
        const char *const text = files->text[i];
        if (files->size[i] < HEAD || 2 * (size_t)big(text + 24) > files->size[i])
            status = input_error(in, "its %s is shorter than its head states: the file is incomplete", endings[i]);
    }
    return status;
}

/* ------------------------------------------------------------------------------------- systems of coordinates (WKT)
 */

static const char *bracket_of(const char *node) { return node + strcspn(node, "[("); }

static int is_node(const char *node, const char *const *kinds)
{
    const char *const end = bracket_of(node);
    const size_t size = (size_t)(end - node);
    for (; *end && *kinds; ++kinds)
        if (strlen(*kinds) == size && !strncasecmp(node, *kinds, size)) return 1;
    return 0;
}

/* The first child of these kinds in a node, KIND[..., KIND[...]]; NULL: none. */
static const char *child(const char *node, const char *const *kinds)
{
    int depth = 0, quoted = 0;
    for (const char *c = node ? bracket_of(node) : ""; *c; ++c) {
        quoted ^= *c == '"';
        if (quoted) continue;
        depth += (*c == '[' || *c == '(') - (*c == ']' || *c == ')');
        if (depth < 1) return NULL;
        if (depth > 1 || (*c != '[' && *c != '(' && *c != ',')) continue;
        const char *const next = c + 1 + strspn(c + 1, " \t\r\n");
        if (is_node(next, kinds)) return next;
    }
    return NULL;
}

/* Name of a node, cut to 60 characters. */
static const char *name_of(const char *node, char name[64])
{
    const char *const from = node ? strchr(bracket_of(node), '"') : NULL;
    snprintf(name, 64, "%.*s", from ? (int)strcspn(from + 1, "\"") : 0, from ? from + 1 : "");
    return name;
}

/* Reads the number after a node's name. Returns 0 if there is none. */
static int number_of(const SurveyInput *in, const char *node, double *value)
{
    const char *const from = node ? strchr(bracket_of(node), '"') : NULL, *const to =
                                                                              from ? strchr(from + 1, '"') : NULL;
    char *end;
    return to && to[1] == ',' && input_number(in, to + 2 + strspn(to + 2, " "), &end, value);
}

static const char *unit_of(const char *system)
{
    static const char *const units[] = {"UNIT", "LENGTHUNIT", "ANGLEUNIT", NULL}, *const axes[] = {"AXIS", NULL};
    const char *const own = child(system, units);
    return own ? own : child(child(system, axes), units);
}

/* Sets a system in degrees. Errors: INPUT (an unknown angular unit). */
static hawser_status geographic_set(MapPlaces *p, const char *system, double *meridian)
{
    static const char *const datums[] = {"DATUM", "ENSEMBLE", NULL}, *const shapes[] = {"SPHEROID", "ELLIPSOID", NULL},
                             *const meridians[] = {"PRIMEM", NULL};
    const double degree = acos(-1) / 180, axis = 6378137;
    double unit = degree, a = axis;
    char name[64], what[SURVEY_NAME_MAX];
    number_of(p->in, unit_of(system), &unit);
    if (!(fabs(unit / degree - 1) < 1e-6))
        return input_error(p->in, "its .prj has angles in '%s': expected degrees, or metres of a projection",
                           name_of(unit_of(system), name));
    number_of(p->in, child(system, meridians), meridian);
    number_of(p->in, child(child(system, datums), shapes), &a);
    if (fabs(a - axis) > 1) {
        snprintf(what, sizeof what, "datum of '%.60s': taken for WGS 84, lengths are %.2g %% off",
                 name_of(system, name), 100 * fabs(axis / a - 1));
        survey_ignore(p->in->out, what);
    }
    return map_unit(p);
}

/* Checks for the projection of a map of the world, which makes lengths too long or too short. */
static int is_world_map(const char *projection)
{
    return (strcasestr(projection, "mercator") && !strcasestr(projection, "transverse") &&
            !strcasestr(projection, "oblique")) ||
           strcasestr(projection, "plate") || strcasestr(projection, "cylindrical_eq") ||
           strcasestr(projection, "equidistant_cyl");
}

/* Reads the .prj; *height: metres per unit of the heights, *meridian: longitude of the zero meridian, degrees. Errors:
 * INPUT (coordinates that are not lengths). */
static hawser_status system_read(MapPlaces *p, const char *text, double *height, double *meridian)
{
    static const char *const whole[] = {"COMPD_CS", "COMPOUNDCRS", NULL}, *const plans[] = {"PROJCS",       "PROJCRS",
                                                                                            "PROJECTEDCRS", "LOCAL_CS",
                                                                                            "ENGCRS",       NULL},
                             *const globes[] = {"GEOGCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS", NULL},
                             *const conversions[] = {"CONVERSION", NULL},
                             *const methods[] = {"PROJECTION", "METHOD", NULL};
    char name[64], method[64];
    text += strspn(text, "\xEF\xBB\xBF \t\r\n");
    const char *system = text;
    if (is_node(text, whole) && !(system = child(text, plans))) system = child(text, globes);
    const char *up = strstr(text, "VERT");
    while (up && strncmp(up, "VERTCS[", 7) != 0 && strncmp(up, "VERT_CS[", 8) != 0 && strncmp(up, "VERTCRS[", 8) != 0)
        up = strstr(up + 4, "VERT");
    p->plain = system && is_node(system, plans);
    if (!p->plain && !(system && is_node(system, globes)))
        return input_error(p->in, "its .prj begins with '%.30s': expected PROJCS or GEOGCS", text);
    double unit = 1;
    const int known = number_of(p->in, unit_of(system), &unit);
    *height = p->plain && known ? unit : 1;
    number_of(p->in, unit_of(up), height);
    if (!p->plain) return geographic_set(p, system, meridian);
    const char *const conversion = child(system, conversions);
    name_of(child(conversion ? conversion : system, methods), method);
    if (is_world_map(method))
        return input_error(p->in,
                           "its .prj has the projection '%s': metres of a map of the world are too long away from the "
                           "equator: expected longitude and latitude (WGS 84), or a projection that is true to scale",
                           method);
    if (!(unit > 0 && *height > 0)) return input_error(p->in, "its .prj has a unit of %g m", unit);
    snprintf(p->in->out->system, SURVEY_NAME_MAX, "%s", name_of(system, name));
    input_unit(p->in, unit, name_of(unit_of(system), name));
    if (!isnan(p->in->options.unit)) *height = p->in->unit;
    return HAWSER_OK;
}

/* Refuses small numbers without a .prj, which may be degrees. */
static hawser_status unknown_check(const SurveyInput *in)
{
    int degrees = 1;
    for (int i = 0; i < in->out->n; ++i) {
        const Alignment *const a = &in->out->alignment[i];
        for (int k = 0; k < a->n_points; ++k) degrees &= fabs(a->point[k].x) <= 180 && fabs(a->point[k].y) <= 90;
    }
    for (int i = 0; i < in->out->n_marks; ++i)
        degrees &= fabs(in->out->mark[i].at.x) <= 180 && fabs(in->out->mark[i].at.y) <= 90;
    if (!degrees) return HAWSER_OK;
    return input_error(in,
                       "x and y are within 180 and 90, and no .prj beside it says whether they are degrees: put the "
                       ".prj there, or give its unit of length, such as 'units: m'");
}

/* ------------------------------------------------------------------------------------------------------------ shapes
 */

typedef struct Shapes {
    MapPlaces places;
    SHPHandle shp;
    DBFHandle dbf;           /* NULL: none */
    int name, layer;         /* columns of the table; -1: none */
    iconv_t page;            /* of the table's texts */
    double height, meridian; /* as in system_read */
} Shapes;

/* Finds a column of the table by its name. */
static int column_find(DBFHandle dbf, const char *name)
{
    for (int i = 0; dbf && i < DBFGetFieldCount(dbf); ++i) {
        char own[XBASE_FLDNAME_LEN_READ + 1];
        DBFGetFieldInfo(dbf, i, own, NULL, NULL);
        if (!strcasecmp(own, name)) return i;
    }
    return -1;
}

/* Opens the table, if there is one that is as long as its head states. Its columns must lie within a record, which
 * libshp does not check. */
static void table_open(Shapes *s, const Files *files, const char *address)
{
    const char *const cpg = files->text[FILE_CPG];
    SAHooks own = hooks();
    char page[40];
    snprintf(page, sizeof page, "%s%.*s", cpg && strspn(cpg, "0123456789") ? "CP" : "",
             cpg ? (int)strcspn(cpg, " \t\r\n") : 0, cpg ? cpg : "");
    s->page = *page ? iconv_open("UTF-8", page) : (iconv_t)-1;
    if (s->page == (iconv_t)-1) s->page = iconv_open("UTF-8", "ISO-8859-1");
    if (files->size[FILE_DBF] && memory_room(ROOM + ROOM_TIMES * (size_t)ROOM)) s->dbf = DBFOpenLL(address, "rb", &own);
    int width = 1;
    for (int i = 0; s->dbf && i < s->dbf->nFields; ++i) width += s->dbf->panFieldSize[i];
    if (s->dbf && width > s->dbf->nRecordLength) {
        DBFClose(s->dbf);
        s->dbf = NULL;
    }
    if (files->text[FILE_DBF] && !s->dbf) survey_ignore(s->places.in->out, "the .dbf beside it, which is damaged");
    s->name = column_find(s->dbf, "name");
    if (s->name < 0) s->name = column_find(s->dbf, "id");
    s->layer = column_find(s->dbf, "layer");
}

/* Reads a cell of the table as UTF-8; "" if there is none. */
static const char *cell_of(const Shapes *s, int record, int column, char text[SURVEY_NAME_MAX])
{
    const char *const own =
        s->dbf && column >= 0 && record < s->dbf->nRecords ? DBFReadStringAttribute(s->dbf, record, column) : NULL;
    if (!own || encoding_is_utf8(own) || !encoding_convert(s->page, text, SURVEY_NAME_MAX, own))
        snprintf(text, SURVEY_NAME_MAX, "%s", own ? own : "");
    return text;
}

/* Reads vertices `from` to before `to` as a line. */
static hawser_status part_read(Shapes *s, const SHPObject *o, int from, int to, const Alignment *like)
{
    Survey *const out = s->places.in->out;
    if (to - from < 2) return survey_ignore(out, "a part of fewer than two points"), HAWSER_OK;
    Alignment *const a = survey_add(out, like->name);
    if (!a) return error_memory(s->places.in->err);
    memcpy(a->layer, like->layer, sizeof a->layer);
    a->whole = like->whole;
    int heights = 0;
    for (int i = from; i < to; ++i) {
        Vec3 *const point = alignment_add_point(a);
        if (!point) return error_memory(s->places.in->err);
        const int has = o->nSHPType == SHPT_ARCZ && o->padfZ[i] > -1e38;
        const double z = has ? o->padfZ[i] * s->height / (s->places.plain ? s->places.in->unit : 1) : NAN;
        const hawser_status status = map_place(&s->places, o->padfX[i] + s->meridian, o->padfY[i], z, point);
        if (status) return status;
        heights += has;
    }
    a->flat = heights < to - from;
    a->partly = a->flat && heights > 0;
    if (a->partly) survey_ignore(out, "heights of a line in which some points have none");
    for (int i = 0; i < a->n_points && a->flat; ++i) a->point[i].z = 0;
    return HAWSER_OK;
}

static hawser_status line_read(Shapes *s, const SHPObject *o, Alignment *like)
{
    hawser_status status = HAWSER_OK;
    if (o->nParts > 1) like->whole = s->places.in->out->n + 1;
    for (int i = 0; i < o->nParts && !status; ++i) {
        const int from = o->panPartStart[i], to = i + 1 < o->nParts ? o->panPartStart[i + 1] : o->nVertices;
        if (from < 0 || to < from || to > o->nVertices)
            return input_error(s->places.in, "record %d: its parts do not follow each other", o->nShapeId + 1);
        status = part_read(s, o, from, to, like);
    }
    for (int i = 0; i < o->nVertices && o->bMeasureIsUsed; ++i) {
        if (!(fabs(o->padfM[i]) > 0 && o->padfM[i] > -1e38)) continue;
        survey_ignore(s->places.in->out, "measures (M)");
        break;
    }
    return status;
}

static hawser_status marks_read(Shapes *s, const SHPObject *o, const Alignment *like)
{
    const int solid = o->nSHPType == SHPT_POINTZ || o->nSHPType == SHPT_MULTIPOINTZ;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < o->nVertices && !status; ++i) {
        SurveyMark *const mark = survey_add_mark(s->places.in->out, *like->name ? like->name : "Point", like->layer);
        if (!mark) return error_memory(s->places.in->err);
        const double z = solid ? o->padfZ[i] * s->height / (s->places.plain ? s->places.in->unit : 1) : NAN;
        status = map_place(&s->places, o->padfX[i] + s->meridian, o->padfY[i], z, &mark->at);
    }
    return status;
}

static hawser_status record_read(Shapes *s, int i)
{
    Survey *const out = s->places.in->out;
    Alignment like = {0}; /* properties shared by all lines of the record */
    if (s->dbf && i < s->dbf->nRecords && DBFIsRecordDeleted(s->dbf, i))
        return survey_ignore(out, "records that the .dbf has deleted"), HAWSER_OK;
    if (!memory_room(ROOM + ROOM_TIMES * (size_t)s->shp->panRecSize[i])) return error_memory(s->places.in->err);
    SHPObject *const o = SHPReadObject(s->shp, i);
    if (!o) return input_error(s->places.in, "record %d cannot be read: the file is damaged", i + 1);
    cell_of(s, i, s->name, like.name);
    cell_of(s, i, s->layer, like.layer);
    hawser_status status = HAWSER_OK;
    switch (o->nSHPType) {
    case SHPT_ARC:
    case SHPT_ARCZ:
    case SHPT_ARCM:
        status = line_read(s, o, &like);
        break;
    case SHPT_POINT:
    case SHPT_POINTZ:
    case SHPT_POINTM:
    case SHPT_MULTIPOINT:
    case SHPT_MULTIPOINTZ:
    case SHPT_MULTIPOINTM:
        status = marks_read(s, o, &like);
        break;
    case SHPT_NULL:
        survey_ignore(out, "records without a shape");
        break;
    default:
        survey_ignore(out, o->nSHPType == SHPT_MULTIPATCH ? "MultiPatch" : "Polygon");
        break;
    }
    SHPDestroyObject(o);
    return status;
}

hawser_status shape_read(SurveyInput *in)
{
    Files files = {0};
    Shapes s = {.places = {.in = in}, .page = (iconv_t)-1, .height = 1};
    SAHooks own = hooks();
    char address[40];
    snprintf(address, sizeof address, "%p", (void *)&files);
    hawser_status status = files_read(in, &files);
    const char *const prj = files.text[FILE_PRJ];
    if (!status && prj) status = system_read(&s.places, prj, &s.height, &s.meridian);
    if (!status && !prj) {
        s.places.plain = 1;
        input_unit(in, 1, "");
        if (isnan(in->options.unit)) survey_ignore(in->out, "no .prj beside it: coordinates are taken as metres");
    }
    if (!status && !memory_room(ROOM + ROOM_TIMES * files.size[FILE_SHX])) status = error_memory(in->err);
    if (!status && !(s.shp = SHPOpenLL(address, "rb", &own)))
        status = input_error(in, "a shapefile whose head or index is damaged");
    if (!status) table_open(&s, &files, address);
    for (int i = 0; !status && i < s.shp->nRecords; ++i) status = record_read(&s, i);
    if (!status && in->out->n == 0 && in->out->n_marks == 0) status = input_error(in, "no line and no point in it");
    if (!status && !prj && isnan(in->options.unit)) status = unknown_check(in);
    if (s.dbf) DBFClose(s.dbf);
    if (s.shp) SHPClose(s.shp);
    if (s.page != (iconv_t)-1) iconv_close(s.page);
    for (int i = 0; i < FILES; ++i) free(files.text[i]);
    return status;
}
#endif
