/* From text to rows of numbers: separators, headers, units, decimal commas. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "survey/table/table.h"

enum { CELLS_MOST = 200, HEADER_MOST = 80 };

/* A slope or gradient is dz/ds; degrees of it are an angle. */
static int is_slope(TableColumn c) { return c == COLUMN_SLOPE || c == COLUMN_GRADE || c == COLUMN_GRADE_END; }

/* Which words stand over which column: letters and digits alone, in lower case. */
static const struct {
    TableColumn column;
    const char *names; /* each between blanks */
} headers[] = {
    {COLUMN_X, " x easting east startpointx startx e ostwert rechtswert "},
    {COLUMN_Y, " y northing north startpointy starty n nordwert hochwert "},
    {COLUMN_Z, " z elevation height level startheight altitude elev hoehe "},
    {COLUMN_LENGTH, " length segmentlength horizontallength planlength distance laenge "},
    {COLUMN_ANGLE, " angle bend deflection turnangle winkel "},
    {COLUMN_RADIUS, " radius r radiusofcurvature bendradius curveradius "},
    {COLUMN_SLOPE, " slope inclination neigung "},
    {COLUMN_RADIUS_START, " startradiusofcurvature startradius radiusstart "},
    {COLUMN_RADIUS_END, " endradiusofcurvature endradius radiusend "},
    {COLUMN_HEADING, " startdirection direction heading bearing azimuth "},
    {COLUMN_STATION, " station startdistalong chainage sta kp mileage stationierung "},
    {COLUMN_GRADE, " startgradient grade gradient startgrade "},
    {COLUMN_GRADE_END, " endgradient endgrade "},
    {COLUMN_CURVE_LENGTH, " curvelength verticalcurve vclength "},
    {COLUMN_VERTICAL_RADIUS, " verticalradius profileradius "},
    {COLUMN_TYPE, " predefinedtype type kind "},
    {COLUMN_TURN, " turn plane side toward "},
    {COLUMN_NAME, " name id entity label "},
    {COLUMN_LAYER, " layer equipment "},
};

/* What a unit behind a header's name multiplies by. */
static const struct {
    const char *name;
    double factor;
} factors[] = {{"m", 1},
               {"mm", 1e-3},
               {"cm", 1e-2},
               {"km", 1e3},
               {"ft", 0.3048},
               {"in", 0.0254},
               {"deg", 0.017453292519943295},
               {"rad", 1},
               {"gon", 0.015707963267948967},
               {"%", 1e-2},
               {"\xE2\x80\xB0", 1e-3}, /* per mille and degree, in UTF-8 and as code pages have them */
               {"\x89", 1e-3},
               {"\xC2\xB0", 0.017453292519943295},
               {"\xB0", 0.017453292519943295},
               {"permille", 1e-3},
               {"degrees", 0.017453292519943295},
               {"percent", 1e-2}};

typedef struct Columns {
    int n;
    TableColumn meaning[CELLS_MOST]; /* TABLE_COLUMNS: none */
    double factor[CELLS_MOST];
    char tangent[CELLS_MOST]; /* a slope that is given as an angle */
    char percent[CELLS_MOST]; /* the header has the percent sign that a cell may repeat */
    char separator;
} Columns;

/* Splits a line where the separator stands outside of quotes, in place. */
static int split(SurveyInput *in, char *text, char separator, char *cell[CELLS_MOST])
{
    int n = 0;
    char *to = text;
    for (;;) {
        if (n == CELLS_MOST) return input_error(in, "a row of more than %d cells", CELLS_MOST), -1;
        cell[n++] = to;
        for (int quoted = 0; *text && (quoted || *text != separator); ++text) {
            if (*text != '"')
                *to++ = *text;
            else if (quoted && text[1] == '"')
                *to++ = *text++;
            else
                quoted = !quoted;
        }
        const int last = *text == 0;
        *to++ = 0;
        if (last) return n;
        ++text;
        if (to > text) to = text;
    }
}

/* The unit that stands behind a header's name: in brackets, behind a comma, or as a sign of percent, per mille or
 * degrees; NULL: none. */
static const char *unit_of(const char *text)
{
    static const char *const signs[] = {"%", "\xE2\x80\xB0", "\xC2\xB0", "\xB0", "\x89"};
    const char *const bracket = strpbrk(text, "([,"), *sign = NULL;
    for (size_t i = 0; i < sizeof signs / sizeof *signs && !sign; ++i) sign = strstr(text, signs[i]);
    return bracket ? bracket + 1 + strspn(bracket + 1, " ") : sign;
}

/* German letters with two of the alphabet, in UTF-8 or Latin-1: Laenge, Hoehe. NULL: another. */
static const char *umlaut(const unsigned char *c)
{
    static const struct {
        unsigned char latin, utf;
        const char *letters;
    } umlauts[] = {{0xE4, 0xA4, "ae"}, {0xF6, 0xB6, "oe"}, {0xFC, 0xBC, "ue"}, {0xC4, 0x84, "ae"},
                   {0xD6, 0x96, "oe"}, {0xDC, 0x9C, "ue"}, {0xDF, 0x9F, "ss"}};
    for (size_t i = 0; i < sizeof umlauts / sizeof *umlauts; ++i) {
        if (*c == umlauts[i].latin || (c[0] == 0xC3 && c[1] == umlauts[i].utf)) return umlauts[i].letters;
    }
    return NULL;
}

/* "Start Radius (ft)" into its letters, and the unit's factor; NAN: no such unit. */
static double header_parse(const char *text, char letters[HEADER_MOST])
{
    const char *const unit = unit_of(text), *const bracket = strpbrk(text, "([,");
    const char *end = bracket ? bracket : text + strlen(text);
    size_t n = 0;
    for (const char *c = text; c < end && n + 2 < HEADER_MOST; ++c) {
        const char *const two = umlaut((const unsigned char *)c);
        if (isalnum((unsigned char)*c)) letters[n++] = (char)tolower((unsigned char)*c);
        for (int i = 0; two && i < 2; ++i) letters[n++] = two[i];
    }
    letters[n] = 0;
    if (!unit) return 1;
    const size_t size = strcspn(unit, " )]");
    for (size_t i = 0; i < sizeof factors / sizeof *factors; ++i) {
        if (strlen(factors[i].name) == size && !strncasecmp(unit, factors[i].name, size)) return factors[i].factor;
    }
    return NAN;
}

static TableColumn column_of(const char *letters)
{
    char wanted[HEADER_MOST + 2] = " ";
    strcat(strcat(wanted, letters), " ");
    for (size_t i = 0; *letters && i < sizeof headers / sizeof *headers; ++i) {
        if (strstr(headers[i].names, wanted)) return headers[i].column;
    }
    return TABLE_COLUMNS;
}

/* Whether a header's unit is one of angles. */
static int is_angle(const char *text)
{
    const char *const unit = unit_of(text);
    return unit && (*unit == '\xC2' || *unit == '\xB0' || !strncasecmp(unit, "deg", 3) ||
                    !strncasecmp(unit, "rad", 3) || !strncasecmp(unit, "gon", 3));
}

static int is_length(TableColumn c)
{
    return c <= COLUMN_LENGTH || c == COLUMN_RADIUS || c == COLUMN_RADIUS_START || c == COLUMN_RADIUS_END ||
           c == COLUMN_STATION || c == COLUMN_CURVE_LENGTH || c == COLUMN_VERTICAL_RADIUS;
}

/* The factor where the header names no unit: the file's lengths, angles in degrees; headings are judged later. */
static double usual_factor(const SurveyInput *in, TableColumn c)
{
    if (is_length(c)) return in->unit;
    return c == COLUMN_ANGLE ? 0.017453292519943295 : 1;
}

static hawser_status header_read(SurveyInput *in, char *text, Columns *columns, Table *table)
{
    char *cell[CELLS_MOST], letters[HEADER_MOST];
    columns->separator = strchr(text, '\t') ? '\t' : strchr(text, ';') ? ';' : ',';
    columns->n = split(in, text, columns->separator, cell);
    for (int i = 0; i < columns->n; ++i) {
        const double factor = header_parse(cell[i], letters);
        const TableColumn c = column_of(letters);
        columns->meaning[i] = c;
        if (c == TABLE_COLUMNS) {
            char what[HEADER_MOST + 16];
            snprintf(what, sizeof what, "column '%.60s'", cell[i]);
            for (char *p = what; *p; ++p) *p = (unsigned char)*p < 128 ? *p : '?'; /* of whatever code page */
            survey_ignore(in->out, what);
            continue;
        }
        if (isnan(factor))
            return input_error(
                in, "column '%.60s' has a unit that is not known: expected m, mm, ft, in, deg, rad, gon or %%",
                cell[i]);
        if (table->has[c] && c < COLUMN_TYPE)
            return input_error(in, "column '%.60s' means the same as one before it", cell[i]);
        table->has[c] = 1;
        columns->factor[i] = unit_of(cell[i]) ? factor : usual_factor(in, c);
        columns->percent[i] = unit_of(cell[i]) && *unit_of(cell[i]) == '%';
        columns->tangent[i] = (char)(is_slope(c) && is_angle(cell[i]));
    }
    return columns->n < 0 ? HAWSER_ERR_INPUT : HAWSER_OK;
}

/* One number; a decimal comma where commas do not separate. Behind it nothing, or of a slope a percent sign, which
 * counts once if the header has it too. */
static int cell_number(const SurveyInput *in, const Columns *columns, int i, char *text, double *value)
{
    char *end;
    for (char *c = text; columns->separator != ',' && *c; ++c) {
        if (*c == ',') *c = '.';
    }
    if (!input_number(in, text, &end, value)) return 0;
    end += strspn(end, " ");
    if (*end == '%' && is_slope(columns->meaning[i]) && !columns->tangent[i])
        *value /= columns->percent[i] ? 1 : 100 * columns->factor[i], ++end;
    return end[strspn(end, " ")] == 0;
}

static TableTurn turn_of(const char *text)
{
    static const char *const words[] = {"left", "right", "up", "down"};
    text += strspn(text, " ");
    for (int i = 0; i < 4; ++i) {
        if (!strncasecmp(text, words[i], strlen(words[i])) ||
            (strlen(text) == 1 && tolower((unsigned char)*text) == *words[i])) {
            return (TableTurn)(TURN_LEFT + i);
        }
    }
    return TURN_NONE;
}

/* The word that stands for a straight where a radius is asked for. */
static int is_infinite(const char *text)
{
    static const char *const words[] = {"inf", "infinity", "infinite", "\xE2\x88\x9E"};
    text += *text == '+' || *text == '-';
    size_t size = strlen(text);
    while (size && strchr(" \r", text[size - 1])) --size;
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i) {
        if (strlen(words[i]) == size && !strncasecmp(text, words[i], size)) return 1;
    }
    return 0;
}

static hawser_status cell_read(SurveyInput *in, const Columns *columns, int i, char *text, TableRow *row)
{
    const TableColumn c = columns->meaning[i];
    text += strspn(text, " ");
    if (c == COLUMN_TYPE) row->straight = !strncasecmp(text, "LINE", 4) || !strncasecmp(text, "straight", 8);
    if (c == COLUMN_TURN) row->turn = turn_of(text);
    if (c == COLUMN_TURN && *text && *text != '-' && row->turn == TURN_NONE)
        return input_error(in, "turn '%.40s': expected left, right, up or down", text);
    if (c >= COLUMN_TYPE || !*text || !strcmp(text, "-") || !strcmp(text, "$")) return HAWSER_OK;
    const int radius = c == COLUMN_RADIUS || c == COLUMN_RADIUS_START || c == COLUMN_RADIUS_END;
    if ((radius || c == COLUMN_VERTICAL_RADIUS) && is_infinite(text)) {
        row->value[c] = 0; /* straight */
        return HAWSER_OK;
    }
    if (!cell_number(in, columns, i, text, &row->value[c])) return input_error(in, "'%.40s' is no number", text);
    row->value[c] *= columns->factor[i];
    if (columns->tangent[i] && !(fabs(row->value[c]) < 1.57)) return input_error(in, "'%.40s' is too steep", text);
    if (columns->tangent[i]) row->value[c] = tan(row->value[c]);
    return HAWSER_OK;
}

/* The text of a column's cell without blanks around it; "" if the row has none. */
static const char *cell_text_of(const Columns *columns, TableColumn c, int n, char *cell[CELLS_MOST])
{
    for (int i = 0; i < n && i < columns->n; ++i) {
        if (columns->meaning[i] != c) continue;
        char *const text = cell[i] + strspn(cell[i], " ");
        for (size_t end = strlen(text); end > 0 && strchr(" \r", text[end - 1]); --end) text[end - 1] = 0;
        return text;
    }
    return "";
}

/* What the row calls itself: the last of the cells that may be a name, if it is more than a number. */
static const char *name_of(const Columns *columns, int n, char *cell[CELLS_MOST])
{
    const char *name = "";
    for (int i = 0; i < n && i < columns->n; ++i) {
        int letters = 0;
        for (const char *c = cell[i]; *c; ++c) letters += isalpha((unsigned char)*c) || (unsigned char)*c > 127;
        if (columns->meaning[i] == COLUMN_NAME && letters) name = cell[i] + strspn(cell[i], " ");
    }
    return name;
}

/* A row as a mark on the layer that it names, by x and y, its station, or both. */
static hawser_status mark_add(SurveyInput *in, const Columns *columns, const Table *table, int n,
                              char *cell[CELLS_MOST], const TableRow *row)
{
    const double *const value = row->value;
    const int placed = !isnan(value[COLUMN_X]) && !isnan(value[COLUMN_Y]);
    const char *const layer = cell_text_of(columns, table->has[COLUMN_LAYER] ? COLUMN_LAYER : COLUMN_TYPE, n, cell);
    if (!*layer)
        return input_error(
            in, "a row without a layer: expected a column 'layer' or 'kind' that says which equipment it is");
    if (!placed && isnan(value[COLUMN_STATION])) return input_error(in, "a row without x and y, or a station");
    SurveyMark *const mark = survey_add_mark(in->out, cell_text_of(columns, COLUMN_NAME, n, cell), layer);
    if (!mark) return error_memory(in->err);
    const double z = table->has[COLUMN_Z] && !isnan(value[COLUMN_Z]) ? value[COLUMN_Z] : 0;
    mark->at = placed ? v3(value[COLUMN_X], value[COLUMN_Y], z) : v3(NAN, NAN, NAN);
    mark->station = value[COLUMN_STATION];
    mark->line = in->line;
    return HAWSER_OK;
}

static hawser_status row_read(SurveyInput *in, const Columns *columns, char *text, Table *table)
{
    char *cell[CELLS_MOST];
    const int n = split(in, text, columns->separator, cell);
    if (n < 0) return HAWSER_ERR_INPUT;
    for (int i = columns->n; i < n; ++i) {
        if (cell[i][strspn(cell[i], " \r")])
            return input_error(
                in, "'%.40s' is cell %d of a row, and there are %d columns: are decimal commas among commas?", cell[i],
                i + 1, columns->n);
    }
    if (table->n >= SURVEY_MOST) return input_error(in, "more than %d rows", SURVEY_MOST);
    TableRow *const row = survey_one_more(&table->row, &table->n, sizeof *row);
    if (!row) return error_memory(in->err);
    *row = (TableRow){.line = in->line};
    for (int c = 0; c < COLUMN_TYPE; ++c) row->value[c] = NAN;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && i < columns->n && !status; ++i) {
        if (columns->meaning[i] != TABLE_COLUMNS) status = cell_read(in, columns, i, cell[i], row);
    }
    if (!status && table->has[COLUMN_NAME] && !in->options.marks)
        row->name = piece_names_add(&table->names, name_of(columns, n, cell));
    if (!status && in->options.marks) status = mark_add(in, columns, table, n, cell, row);
    return status;
}

hawser_status table_rows(SurveyInput *in, Table *table)
{
    InputLine line = {0};
    Columns *const columns = calloc(1, sizeof *columns);
    hawser_status status = columns ? HAWSER_OK : error_memory(in->err);
    int more = 1;
    while (!status && (more = input_line(in, &line)) > 0) {
        char *text = line.text;
        if (in->line == 1 && !strncmp(text, "\xEF\xBB\xBF", 3)) text += 3;
        if (text[strspn(text, " \t;,")] == 0 || *text == '#') continue;
        if (columns->n == 0 && !strncmp(text, "sep=", 4)) continue; /* a spreadsheet's word to itself */
        status = columns->n ? row_read(in, columns, text, table) : header_read(in, text, columns, table);
    }
    if (!status && more < 0) status = in->err->status;
    if (!status && table->n == 0)
        status = input_error(in, "no rows: expected a line of column names and rows below it");
    free(columns);
    free(line.text);
    return status;
}
