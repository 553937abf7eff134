/* Converts text to rows of numbers: separators, heads, units, decimal commas, and lines that are not rows of the table.
 */
#define _GNU_SOURCE /* strcasestr */
/* Heads of columns: their meaning in six languages, and their unit. */
#include "survey/table.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"

#define DEGREE 0.017453292519943295

/* Words of heads by column: letters and digits only, in lower case, ae for the German umlaut, e for e with an accent.
 * English, German, French, Spanish, Italian, Chinese. */
static const struct {
    TableColumn column;
    const char *names; /* each between blanks */
} heads[] = {
    {COLUMN_X, " x easting eastings east e startpointx startx xcoord utme utmx ostwert rechtswert ost est este "
               "\xE4\xB8\x9C \xE4\xB8\x9C\xE5\x9D\x90\xE6\xA0\x87 x\xE5\x9D\x90\xE6\xA0\x87 "},
    {COLUMN_Y, " y northing northings north n startpointy starty ycoord utmn utmy nordwert hochwert nord norte "
               "\xE5\x8C\x97 \xE5\x8C\x97\xE5\x9D\x90\xE6\xA0\x87 y\xE5\x9D\x90\xE6\xA0\x87 "},
    {COLUMN_Z, " z elevation height level startheight altitude elev alt zcoord rl reducedlevel hoehe hoehenkote kote "
               "altitude hauteur cote niveau elevacion altura altitud cota quota altezza altitudine elevazione "
               "\xE9\xAB\x98\xE7\xA8\x8B \xE6\xA0\x87\xE9\xAB\x98 \xE9\xAB\x98\xE5\xBA\xA6 z\xE5\x9D\x90\xE6\xA0\x87 "},
    {COLUMN_LENGTH, " length len l distance dist segmentlength straightlength slopedistance slopelength "
                    "laenge strecke teillaenge einzellaenge abschnittslaenge streckenlaenge schraeglaenge entfernung "
                    "longueur longitud distancia lunghezza distanza "
                    "\xE9\x95\xBF\xE5\xBA\xA6 \xE8\xB7\x9D\xE7\xA6\xBB \xE6\xAE\xB5\xE9\x95\xBF \xE9\x95\xBF "},
    {COLUMN_LENGTH, " horizontallength horizontaldistance planlength plandistance hd horizontallaenge "
                    "longueurhorizontale distancehorizontale longitudhorizontal distanciahorizontal "
                    "lunghezzaorizzontale distanzaorizzontale \xE6\xB0\xB4\xE5\xB9\xB3\xE9\x95\xBF\xE5\xBA\xA6 "
                    "\xE6\xB0\xB4\xE5\xB9\xB3\xE8\xB7\x9D\xE7\xA6\xBB \xE5\xB9\xB3\xE8\xB7\x9D "},
    {COLUMN_ANGLE, " angle bend deflection deflectionangle turnangle turningangle bendangle angleofbend curveangle "
                   "delta centralangle winkel bogenwinkel kurvenwinkel ablenkwinkel knickwinkel richtungsaenderung "
                   "anglededeviation deviation angledevirage angulo angulodegiro angulodedeflexion deflexion "
                   "angolo angolodideviazione deviazione \xE8\xA7\x92\xE5\xBA\xA6 \xE8\xBD\xAC\xE8\xA7\x92 "
                   "\xE5\xBC\xAF\xE8\xA7\x92 \xE5\x81\x8F\xE8\xA7\x92 \xE5\x9C\x86\xE5\xBF\x83\xE8\xA7\x92 "},
    {COLUMN_RADIUS,
     " radius r radiusofcurvature bendradius curveradius cornerradius bogenradius kurvenradius "
     "biegeradius halbmesser rayon rayondecourbure rayondevirage radio radiodecurvatura radiodegiro "
     "raggio raggiodicurvatura \xE5\x8D\x8A\xE5\xBE\x84 \xE5\xBC\xAF\xE6\x9B\xB2\xE5\x8D\x8A\xE5\xBE\x84 "
     "\xE8\xBD\xAC\xE5\xBC\xAF\xE5\x8D\x8A\xE5\xBE\x84 \xE6\x9B\xB2\xE7\x8E\x87\xE5\x8D\x8A\xE5\xBE\x84 "},
    {COLUMN_SLOPE, " slope inclination incline neigung steigung laengsneigung pente inclinaison declivite pendiente "
                   "inclinacion pendenza inclinazione \xE5\x9D\xA1\xE5\xBA\xA6 \xE7\xBA\xB5\xE5\x9D\xA1 "
                   "\xE5\x9D\xA1\xE6\xAF\x94 "},
    {COLUMN_RADIUS_START, " startradiusofcurvature startradius radiusstart anfangsradius rayoninitial radioinicial "
                          "raggioiniziale \xE8\xB5\xB7\xE5\xA7\x8B\xE5\x8D\x8A\xE5\xBE\x84 "},
    {COLUMN_RADIUS_END, " endradiusofcurvature endradius radiusend endradius rayonfinal radiofinal raggiofinale "
                        "\xE7\xBB\x88\xE6\xAD\xA2\xE5\x8D\x8A\xE5\xBE\x84 "},
    {COLUMN_HEADING, " startdirection direction heading richtung direccion direzione \xE6\x96\xB9\xE5\x90\x91 "},
    {COLUMN_HEADING, " bearing azimuth azimut wcb wholecirclebearing richtungswinkel peilung gisement acimut rumbo "
                     "\xE6\x96\xB9\xE4\xBD\x8D\xE8\xA7\x92 \xE6\x96\xB9\xE4\xBD\x8D "},
    {COLUMN_STATION,
     " station startdistalong chainage sta ch kp mileage cumulativelength cumulativedistance cumlength "
     "cumdistance cumdist runninglength runningdistance accumulatedlength accumulateddistance "
     "stationierung kilometrierung pk pointkilometrique distancecumulee longueurcumulee progresiva "
     "cadenamiento distanciaacumulada longitudacumulada progressiva distanzaprogressiva "
     "\xE9\x87\x8C\xE7\xA8\x8B \xE6\xA1\xA9\xE5\x8F\xB7 \xE7\xB4\xAF\xE8\xAE\xA1\xE9\x95\xBF\xE5\xBA\xA6 "
     "\xE7\xB4\xAF\xE8\xAE\xA1\xE8\xB7\x9D\xE7\xA6\xBB "},
    {COLUMN_GRADE, " startgradient grade gradient startgrade gradiente "},
    {COLUMN_GRADE_END, " endgradient endgrade "},
    {COLUMN_CURVE_LENGTH, " curvelength verticalcurve vclength "},
    {COLUMN_VERTICAL_RADIUS, " verticalradius profileradius "},
    {COLUMN_LONGITUDE, " longitude lon lng long laengengrad longitudine \xE7\xBB\x8F\xE5\xBA\xA6 "},
    {COLUMN_LATITUDE, " latitude lat breitengrad latitud latitudine \xE7\xBA\xAC\xE5\xBA\xA6 "},
    {COLUMN_TYPE, " predefinedtype type kind typ art tipo \xE7\xB1\xBB\xE5\x9E\x8B "},
    {COLUMN_TURN, " turn plane side toward turndirection leftright lr hand kurvenrichtung bogenrichtung drehrichtung "
                  "abbiegung seite sens sensdevirage sentido giro lado senso svolta lato \xE8\xBD\xAC\xE5\x90\x91 "},
    {COLUMN_NAME, " name id entity label bezeichnung nom nombre nome \xE5\x90\x8D\xE7\xA7\xB0 "},
    {COLUMN_LAYER, " layer equipment "},
    {COLUMN_CANT, " cant cantleft cantright startcantleft startcantright endcantleft endcantright superelevation "
                  "crossfall crossslope quergefaelle querneigung ueberhoehung devers peralte sopraelevazione "
                  "\xE8\xB6\x85\xE9\xAB\x98 \xE6\xA8\xAA\xE5\x9D\xA1 "},
    {COLUMN_FALL, " gefaelle laengsgefaelle fall falling descent \xE4\xB8\x8B\xE5\x9D\xA1 "},
};

/* Words that a head may have in addition: "segment length", "coordenada x". */
static const char idle_words[] = " segment section piece straight part leg route line point vertex coordinate coord "
                                 "koordinate coordenada coordonnee coordinata of the de del der du la le di design "
                                 "nominal bend curve abschnitt in en ";

/* Columns unrelated to the route although they may have numbers. */
static const char unrelated[] =
    " gravitycenterlineheight date datum fecha data time zeit heure hora uhrzeit gpstime timestamp sheet page blatt "
    "seite cost price kosten preis cout prix costo coste precio prezzo no nr num number index count fid oid "
    "objectid row remark remarks note notes comment comments bemerkung remarque nota temperature temp cover depth "
    "tiefe "
    "section segment element piece point pt description abschnitt punkt troncon tramo tratta tratto material diameter "
    "durchmesser pulltension status drawing revision rev zone layername color colour "
    "speed quality hdop vdop pdop accuracy sd sigma "
    "\xE5\xBA\x8F\xE5\x8F\xB7 \xE5\xA4\x87\xE6\xB3\xA8 \xE6\x97\xA5\xE6\x9C\x9F ";

static const TableUnit units[] = {{"m", 1, UNIT_LENGTH},
                                  {"mm", 1e-3, UNIT_LENGTH},
                                  {"cm", 1e-2, UNIT_LENGTH},
                                  {"km", 1e3, UNIT_LENGTH},
                                  {"ft", 0.3048, UNIT_LENGTH},
                                  {"feet", 0.3048, UNIT_LENGTH},
                                  {"foot", 0.3048, UNIT_LENGTH},
                                  {"usft", 1200 / 3937.0, UNIT_LENGTH},
                                  {"ftus", 1200 / 3937.0, UNIT_LENGTH},
                                  {"in", 0.0254, UNIT_LENGTH},
                                  {"inch", 0.0254, UNIT_LENGTH},
                                  {"inches", 0.0254, UNIT_LENGTH},
                                  {"yd", 0.9144, UNIT_LENGTH},
                                  {"meter", 1, UNIT_LENGTH},
                                  {"metre", 1, UNIT_LENGTH},
                                  {"meters", 1, UNIT_LENGTH},
                                  {"metres", 1, UNIT_LENGTH},
                                  {"\xE7\xB1\xB3", 1, UNIT_LENGTH},
                                  {"\xE6\xAF\xAB\xE7\xB1\xB3", 1e-3, UNIT_LENGTH},
                                  {"deg", DEGREE, UNIT_ANGLE},
                                  {"degree", DEGREE, UNIT_ANGLE},
                                  {"degrees", DEGREE, UNIT_ANGLE},
                                  {"\xC2\xB0", DEGREE, UNIT_ANGLE},
                                  {"\xC2\xBA", DEGREE, UNIT_ANGLE},
                                  {"\xE5\xBA\xA6", DEGREE, UNIT_ANGLE},
                                  {"rad", 1, UNIT_ANGLE},
                                  {"gon", 0.9 * DEGREE, UNIT_ANGLE},
                                  {"%", 1e-2, UNIT_RATIO},
                                  {"pct", 1e-2, UNIT_RATIO},
                                  {"percent", 1e-2, UNIT_RATIO},
                                  {"prozent", 1e-2, UNIT_RATIO},
                                  {"\xE2\x80\xB0", 1e-3, UNIT_RATIO},
                                  {"permille", 1e-3, UNIT_RATIO},
                                  {"promille", 1e-3, UNIT_RATIO},
                                  {"o/oo", 1e-3, UNIT_RATIO},
                                  {"ratio", 1, UNIT_RATIO},
                                  {"-", 1, UNIT_RATIO},
                                  {"m/m", 1, UNIT_RATIO},
                                  {"ft/ft", 1, UNIT_RATIO},
                                  {"mm/m", 1e-3, UNIT_RATIO},
                                  {"1:n", 1, UNIT_INVERSE},
                                  {"1:x", 1, UNIT_INVERSE},
                                  {"1 in n", 1, UNIT_INVERSE},
                                  {"1 in x", 1, UNIT_INVERSE},
                                  {"1 in", 1, UNIT_INVERSE},
                                  {"1:", 1, UNIT_INVERSE}};

/* Letters of the alphabet for an accented one, from its two bytes of UTF-8; NULL: none. */
static const char *latin(unsigned char lead, unsigned char next)
{
    /* C3 80 to C3 BF, capitals as small letters */
    static const char *const of[32] = {"a",  "a",  "a", "a", "ae", "a", "ae", "c", "e",  "e", "e",
                                       "e",  "i",  "i", "i", "i",  "d", "n",  "o", "o",  "o", "o",
                                       "oe", NULL, "o", "u", "u",  "u", "ue", "y", NULL, "ss"};
    return lead == 0xC3 ? of[next & 0x1F] : NULL;
}

/* Reduces a text to letters and digits in lower case, without accents. */
static void head_letters(const char *text, char letters[TABLE_HEAD_MOST])
{
    size_t n = 0;
    for (const unsigned char *c = (const unsigned char *)text; *c && n + 3 < TABLE_HEAD_MOST; ++c) {
        const char *const plain = *c >= 0x80 && c[1] ? latin(c[0], c[1]) : NULL;
        if (isalnum(*c)) {
            letters[n++] = (char)tolower(*c);
        } else if (plain) {
            for (const char *p = plain; *p; ++p) letters[n++] = *p;
            ++c;
        } else if (*c >= 0xE4) { /* of Chinese */
            letters[n++] = (char)*c;
        } else if (*c >= 0x80 && *c < 0xC0 && n > 0 && (unsigned char)letters[n - 1] >= 0x80) {
            letters[n++] = (char)*c;
        }
    }
    letters[n] = 0;
}

static int is_among(const char *list, const char *word)
{
    char wanted[TABLE_HEAD_MOST + 2];
    snprintf(wanted, sizeof wanted, " %s ", word);
    return *word && strstr(list, wanted) != NULL;
}

const TableUnit *unit_find(const char *text, size_t size)
{
    while (size && strchr(" .", text[size - 1])) --size;
    for (size_t i = 0; i < sizeof units / sizeof *units; ++i) {
        if (strlen(units[i].name) == size && !strncasecmp(text, units[i].name, size)) return &units[i];
    }
    return NULL;
}

/* Finds a unit at the end of a head without brackets, "Length m", "slope_pct", "Grade%", "L\xC3\xA4nge in m", and the
 * size of the text before it; NULL: none. */
static const TableUnit *unit_behind(const char *text, size_t *ahead)
{
    static const char *const signs[] = {"%", "\xE2\x80\xB0", "\xC2\xB0"};
    size_t size = strlen(text);
    while (size && strchr(" .", text[size - 1])) --size;
    for (size_t i = 0; i < sizeof signs / sizeof *signs; ++i) {
        const size_t n = strlen(signs[i]);
        if (size < n || strncmp(text + size - n, signs[i], n) != 0) continue;
        *ahead = size - n;
        return unit_find(signs[i], n);
    }
    size_t from = size;
    while (from && !strchr(" _-", text[from - 1])) --from;
    if (from == 0 || from == size) return NULL;
    *ahead = from - 1;
    return unit_find(text + from, size - from);
}

/* Meaning of letters; TABLE_COLUMNS: none. *which: index in the list. */
static TableColumn meaning_of(const char *letters, size_t *which)
{
    for (size_t i = 0; i < sizeof heads / sizeof *heads; ++i) {
        *which = i;
        if (is_among(heads[i].names, letters)) return heads[i].column;
    }
    return TABLE_COLUMNS;
}

/* Meaning of the words that are not additional ones. */
static TableColumn meaning_of_words(const char *text, size_t *which)
{
    char kept[TABLE_HEAD_MOST] = "", word[TABLE_HEAD_MOST], letters[TABLE_HEAD_MOST];
    while (*text) {
        text += strspn(text, " _-./:");
        const size_t size = strcspn(text, " _-./:");
        snprintf(word, sizeof word, "%.*s", (int)size, text);
        head_letters(word, letters);
        if (!is_among(idle_words, letters) && strlen(kept) + strlen(letters) + 1 < sizeof kept) strcat(kept, letters);
        text += size;
    }
    return meaning_of(kept, which);
}

TableHead head_read(const char *text)
{
    char name[TABLE_HEAD_MOST], letters[TABLE_HEAD_MOST];
    TableHead head = {.meaning = TABLE_COLUMNS};
    const char *const bracket = strpbrk(text, "([,");
    const char *const wide = strstr(text, "\xEF\xBC\x88"); /* a Chinese bracket */
    const char *const opens = wide && (!bracket || wide < bracket) ? wide : bracket;
    size_t ahead = opens ? (size_t)(opens - text) : strlen(text), which = 0;
    if (opens) {
        const char *const from = opens + (opens == wide ? 3 : 1) + strspn(opens + (opens == wide ? 3 : 1), " ");
        const char *const end = strstr(from, "\xEF\xBC\x89");
        head.unit = unit_find(from, end ? (size_t)(end - from) : strcspn(from, ")]"));
        head.strange = !head.unit;
    }
    snprintf(name, sizeof name, "%.*s", (int)ahead, text);
    head_letters(name, letters);
    head.meaning = meaning_of(letters, &which);
    const TableUnit *const behind = opens ? NULL : unit_behind(text, &ahead);
    if (behind) {
        head.unit = behind;
        snprintf(name, sizeof name, "%.*s", (int)ahead, text);
        head_letters(name, letters);
        head.meaning = meaning_of(letters, &which);
    }
    if (head.meaning == TABLE_COLUMNS) head.meaning = meaning_of_words(name, &which);
    /* a German Grad is a degree, a French grade a gon: only German words decide */
    if (head.strange && (!strncasecmp(opens + 1, "grad)", 5) || !strncasecmp(opens + 1, "grad]", 5)) &&
        (strstr(letters, "winkel") || strstr(letters, "neigung") || strstr(letters, "steigung") ||
         strstr(letters, "richtung"))) {
        head.unit = unit_find("deg", 3);
        head.strange = 0;
    }
    head.plan = head.meaning == COLUMN_LENGTH && strstr(heads[which].names, "horizontal") != NULL;
    head.north = head.meaning == COLUMN_HEADING && strstr(heads[which].names, "bearing") != NULL;
    head_letters(text, letters);
    if (head.meaning == TABLE_COLUMNS && is_among(unrelated, letters)) head.unrelated = 1;
    return head;
}

static const char totals[] =
    " total totals totallength grandtotal subtotal sum summe gesamt gesamtlaenge gesamtsumme zwischensumme somme "
    "longueurtotale totaux suma sumatotal longitudtotal totales totale somma lunghezzatotale "
    "\xE5\x90\x88\xE8\xAE\xA1 \xE6\x80\xBB\xE8\xAE\xA1 \xE6\x80\xBB\xE9\x95\xBF \xE5\xB0\x8F\xE8\xAE\xA1 ";

/* Checks whether a cell marks its row as a sum. */
static int head_is_total(const char *text)
{
    char letters[TABLE_HEAD_MOST];
    head_letters(text, letters);
    return is_among(totals, letters) || !strcmp(text, "\xCE\xA3");
}

TableTurn head_turn(const char *text)
{
    static const char *const words[] = {
        NULL, " left l links gauche g izquierda izquierdo izq i sinistra sx \xE5\xB7\xA6 \xE5\xB7\xA6\xE8\xBD\xAC ",
        " right r rechts droite derecha derecho der destra dx \xE5\x8F\xB3 \xE5\x8F\xB3\xE8\xBD\xAC ",
        " up u auf hoch oben haut arriba su \xE4\xB8\x8A ", " down d ab unten bas abajo giu \xE4\xB8\x8B "};
    char letters[TABLE_HEAD_MOST];
    head_letters(text, letters);
    for (int i = TURN_LEFT; i <= TURN_DOWN; ++i) {
        if (is_among(words[i], letters)) return (TableTurn)i;
    }
    return TURN_NONE;
}

enum { CELLS_MOST = 200, HEADS_WITHIN = 60, QUOTED_LINES_MOST = 10 };

static const double ROW_DEGREE = 0.017453292519943295;

/* ------------------------------------------------------------------------------------------------------------ lines */

/* Lines of the file, one after the other, each with its 0. Cells are split on use. */
typedef struct Lines {
    char *text;
    size_t size, room;
    int n;
    struct {
        size_t at;
        long line;
    } * row;
    int sheet; /* rows of a spreadsheet: cells have a special separator */
} Lines;

static int is_utf8(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c;) {
        const int more = *c < 0x80 ? 0 : *c >= 0xF0 ? 3 : *c >= 0xE0 ? 2 : *c >= 0xC2 ? 1 : -1;
        if (more < 0) return 0;
        for (int i = 1; i <= more; ++i) {
            if ((c[i] & 0xC0) != 0x80) return 0;
        }
        c += more + 1;
    }
    return 1;
}

/* Decodes Windows-1252 where it differs from Latin-1: a table only uses its per mille sign and dashes. */
static unsigned code_page(unsigned char c) { return c == 0x89 ? 0x2030 : c == 0x96 || c == 0x97 ? '-' : c; }

/* Adds a line as UTF-8; `more`: to the one before, whose quoted cell continues. Returns 0 without memory. */
static int line_keep(Lines *lines, const char *text, long line, int more)
{
    const int whole = is_utf8(text);
    const size_t need = lines->size + 3 * strlen(text) + 2;
    if (need > lines->room) {
        const size_t room = 2 * need;
        char *const grown = realloc(lines->text, room);
        if (!grown) return 0;
        lines->text = grown;
        lines->room = room;
    }
    if (more)
        lines->text[lines->size - 1] = ' ';
    else {
        const size_t at = lines->size;
        if (lines->n >= SURVEY_MOST || !survey_one_more(&lines->row, &lines->n, sizeof *lines->row)) return 0;
        lines->row[lines->n - 1].at = at;
        lines->row[lines->n - 1].line = line;
    }
    for (const char *c = text; *c; ++c) {
        const unsigned char byte = (unsigned char)*c;
        if (whole || byte < 0x80)
            lines->text[lines->size++] = *c;
        else
            lines->size += input_utf8(lines->text + lines->size, code_page(byte));
    }
    lines->text[lines->size++] = 0;
    return 1;
}

/* Checks whether a quote at the beginning of a cell is still open at the end. */
static int is_open(const char *text)
{
    int quoted = 0;
    for (const char *c = text; *c; ++c) {
        if (*c != '"') continue;
        if (quoted || c == text || strchr(",;\t", c[-1])) quoted = !quoted;
    }
    return quoted;
}

static hawser_status lines_read(SurveyInput *in, Lines *lines)
{
    InputLine line = {0};
    int more, open = 0;
    long last = 0;
    size_t mark = 0;
    hawser_status status = HAWSER_OK;
    while (!status && (more = input_line(in, &line)) > 0) {
        char *text = line.text;
        if (in->line == 1 && !strncmp(text, "\xEF\xBB\xBF", 3)) text += 3;
        if (in->line == 1 && *text == '\x1F') lines->sheet = 1;
        if (!open && (text[strspn(text, " \t;,|\x1F")] == 0 || *text == '#')) continue;
        if (!line_keep(lines, text, in->line, open)) status = error_memory(in->err);
        if (!open) last = in->line, mark = lines->n ? lines->row[lines->n - 1].at : 0;
        if (!status) open = !lines->sheet && in->line - last < QUOTED_LINES_MOST && is_open(lines->text + mark);
    }
    if (!status && more < 0) status = in->err->status;
    free(line.text);
    return status;
}

/* Splits a copy of a line in place at separators outside quotes, and removes blanks around cells; -1: too many cells.
 */
static int split(char *text, char separator, char *cell[CELLS_MOST])
{
    int n = 0;
    char *to = text;
    for (;;) {
        if (n == CELLS_MOST) return -1;
        char *const begin = to;
        for (int quoted = 0; *text && (quoted || *text != separator); ++text) {
            if (*text != '"' || separator == '\x1F')
                *to++ = *text;
            else if (quoted && text[1] == '"')
                *to++ = *text++;
            else
                quoted = !quoted;
        }
        const int last = *text == 0;
        char *end = to;
        while (end > begin && strchr(" \t\r", end[-1])) --end;
        cell[n] = begin + strspn(begin, " \t");
        if (cell[n] > end) cell[n] = end;
        *to++ = 0;
        *end = 0;
        ++n;
        if (last) return n;
        ++text;
    }
}

/* ------------------------------------------------------------------------------------------------------------ heads */

/* A column of the file. */
typedef struct Column {
    TableHead head;
    const char *name;  /* as written */
    double factor;     /* for a cell without its own unit */
    int ignored;       /* the user excludes it */
    int romance;       /* for turns: g, i, d are left, left, right */
    int numbers, rows; /* without a meaning: number of cells that are numbers, and that are not empty */
} Column;

typedef struct Columns {
    int n;
    char separator;
    int points, commas; /* cells have decimal points, commas: line of the first; 0: none */
    char *text;         /* of the heads */
    Column column[CELLS_MOST];
    char *work; /* a line being split */
    size_t room;
} Columns;

static int is_slope(TableColumn c) { return c == COLUMN_SLOPE || c == COLUMN_GRADE || c == COLUMN_GRADE_END; }

static int is_angle(TableColumn c) { return c == COLUMN_ANGLE || c == COLUMN_HEADING; }

static int is_radius(TableColumn c)
{
    return c == COLUMN_RADIUS || c == COLUMN_RADIUS_START || c == COLUMN_RADIUS_END || c == COLUMN_VERTICAL_RADIUS;
}

static int is_degrees(TableColumn c) { return c == COLUMN_LONGITUDE || c == COLUMN_LATITUDE; }

static int is_length(TableColumn c) { return c < COLUMN_TYPE && !is_slope(c) && !is_angle(c) && !is_degrees(c); }

/* Splits a copy of row i of the lines; returns the number of cells, -1 on error with the reason. */
static int row_split(SurveyInput *in, const Lines *lines, int i, char separator, Columns *columns,
                     char *cell[CELLS_MOST])
{
    const char *const text = lines->text + lines->row[i].at;
    const size_t need = strlen(text) + 1;
    in->line = lines->row[i].line;
    if (need > columns->room) {
        char *const grown = realloc(columns->work, need);
        if (!grown) return error_memory(in->err), -1;
        columns->work = grown;
        columns->room = need;
    }
    memcpy(columns->work, text, need);
    const int n = split(columns->work, separator, cell);
    if (n < 0) input_error(in, "a row of more than %d cells", CELLS_MOST);
    return n;
}

/* Checks whether a cell begins with a number. */
static int begins_number(const char *cell)
{
    cell += *cell == '-' || *cell == '+';
    return isdigit((unsigned char)*cell) || ((*cell == '.' || *cell == ',') && isdigit((unsigned char)cell[1]));
}

/* Number of a row's cells that are heads of a route; 0 if one is a number. */
static int heads_count(const SurveyInput *in, int n, char *cell[CELLS_MOST])
{
    int known = 0, numbers = 0;
    for (int i = 0; i < n; ++i) {
        const TableColumn c = head_read(cell[i]).meaning;
        numbers += begins_number(cell[i]);
        known += c < COLUMN_TYPE || c == COLUMN_TURN || c == COLUMN_FALL || c == COLUMN_CANT ||
                 (in->options.marks && c < TABLE_COLUMNS);
    }
    return numbers ? 0 : known;
}

/* Finds the row of heads: the first with two of a route, or else with one. Returns its index, and sets the separator
 * with most of them; 0 heads: none. Returns -1 on error with the reason. */
static int heads_find(SurveyInput *in, const Lines *lines, Columns *columns)
{
    static const char separators[] = {'\x1F', '\t', ';', ',', '|'};
    char *cell[CELLS_MOST];
    int single = -1;
    char single_separator = ',';
    for (int i = 0; i < lines->n && i < HEADS_WITHIN; ++i) {
        const char *const bare = lines->text + lines->row[i].at;
        int most = 0;
        if (single >= 0 && strpbrk(bare, "0123456789") &&
            !strpbrk(bare, "abcdfghijklmnopqrstuvwxyzABCDFGHIJKLMNOPQRSTUVWXYZ"))
            break; /* numbers below it: a table with one known column */
        char best = ',';
        for (size_t k = 0; k < sizeof separators; ++k) {
            const char *const text = lines->text + lines->row[i].at;
            if ((lines->sheet != 0) != (k == 0) || (separators[k] != ',' && !strchr(text, separators[k]))) continue;
            const int n = row_split(in, lines, i, separators[k], columns, cell);
            if (n < 0) return -1;
            const int known = heads_count(in, n, cell);
            if (known <= most) continue;
            most = known;
            best = separators[k];
        }
        if (most >= 2) return columns->separator = best, i;
        if (most == 1 && single < 0) single = i, single_separator = best;
    }
    columns->separator = single_separator;
    return single >= 0 ? single : lines->n;
}

/* Checks whether the user excludes this column. */
static int is_ignored(const SurveyInput *in, const char *name)
{
    char own[TABLE_HEAD_MOST], other[TABLE_HEAD_MOST], word[TABLE_HEAD_MOST];
    head_letters(name, own);
    for (const char *at = in->options.ignore; at && *at;) {
        const size_t size = strcspn(at, "\n");
        snprintf(word, sizeof word, "%.*s", (int)size, at);
        head_letters(word, other);
        if (!strcasecmp(word, name) || (*own && !strcmp(own, other))) return 1;
        at += size + (at[size] != 0);
    }
    return 0;
}

/* Checks whether a column of this meaning can have that unit. */
static int is_fit(TableColumn c, const TableUnit *unit)
{
    if (is_slope(c)) return unit->kind != UNIT_LENGTH || !strcmp(unit->name, "m");
    if (is_angle(c)) return unit->kind == UNIT_ANGLE;
    if (is_degrees(c) || c == COLUMN_X || c == COLUMN_Y)
        return unit->kind == UNIT_ANGLE || (unit->kind == UNIT_LENGTH && !is_degrees(c));
    return c >= COLUMN_TYPE || unit->kind == UNIT_LENGTH;
}

/* Factor if the head names no unit: the file's lengths, angles in degrees; headings are judged later. */
static double usual_factor(const SurveyInput *in, TableColumn c)
{
    return is_length(c) ? in->unit : c == COLUMN_ANGLE ? ROW_DEGREE : 1;
}

static hawser_status head_take(SurveyInput *in, Column *column, const char *name, Table *table)
{
    TableHead head = head_read(name);
    column->name = name;
    column->ignored = is_ignored(in, name);
    if (column->ignored) head.meaning = TABLE_COLUMNS, head.unrelated = 1;
    const TableColumn c = head.meaning;
    column->head = head;
    column->factor = head.unit ? head.unit->factor : usual_factor(in, c);
    if (c == TABLE_COLUMNS) return HAWSER_OK;
    if (head.strange || (head.unit && !is_fit(c, head.unit))) {
        if (c >= COLUMN_TYPE) return HAWSER_OK;
        return input_error(
            in, "column '%.60s' has a unit that is not known: expected m, mm, ft, in, deg, rad, gon or %%", name);
    }
    if (table->has[c] && c < COLUMN_TYPE)
        return input_error(in, "column '%.60s' means the same as one before it: name one of them in 'ignore'", name);
    table->has[c] = 1;
    if (c == COLUMN_LENGTH) table->plan = head.plan;
    if (c == COLUMN_X && head.unit && head.unit->kind == UNIT_LENGTH) table->metres = 1;
    if (c == COLUMN_HEADING) table->north |= head.north, table->angles |= head.unit != NULL;
    if ((c == COLUMN_X || c == COLUMN_Y) && head.unit && head.unit->kind == UNIT_ANGLE) {
        column->factor = 1;
        table->degrees = 1;
    }
    return HAWSER_OK;
}

/* Checks for a row of units only below the heads, "m", "deg". */
static int is_unit_row(int n, char *cell[CELLS_MOST])
{
    int found = 0;
    for (int i = 0; i < n; ++i) {
        const char *const from = cell[i] + strspn(cell[i], "([ ");
        if (!*from) continue;
        if (!strcmp(from, "-") || unit_find(from, strcspn(from, ")]")))
            ++found;
        else
            return 0;
    }
    return found > 0;
}

/* Refuses a title above the heads that mentions a unit, if the heads have none: the unit would be a guess. */
static hawser_status title_check(SurveyInput *in, const Lines *lines, int head, const Columns *columns)
{
    int bare = isnan(in->options.unit);
    for (int i = 0; i < columns->n; ++i) {
        const Column *const c = &columns->column[i];
        if (is_length(c->head.meaning) && c->head.unit) bare = 0;
    }
    for (int i = 0; i < head && bare; ++i) {
        static const char *const words[] = {"feet",        "ft",         "foot", "inches", "mm",   "millimetres",
                                            "millimeters", "millimeter", "cm",   "pieds",  "pies", "piedi"};
        const char *const title = lines->text + lines->row[i].at;
        for (const char *at = title; *at;) {
            at += strcspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
            const size_t size = strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
            for (size_t k = 0; k < sizeof words / sizeof *words; ++k) {
                if (strlen(words[k]) != size || strncasecmp(at, words[k], size) != 0) continue;
                in->line = lines->row[i].line;
                return input_error(in,
                                   "the title says '%s', and the heads below it have no unit: write it behind them, "
                                   "'length (%s)', or choose the file's unit by 'units'",
                                   words[k], words[k]);
            }
            at += size;
        }
    }
    return HAWSER_OK;
}

/* Reads the heads, with a row of units below; *next: the first row after them. */
static hawser_status heads_read(SurveyInput *in, const Lines *lines, Columns *columns, Table *table, int *next)
{
    char *cell[CELLS_MOST], *unit[CELLS_MOST], joined[TABLE_HEAD_MOST];
    const int at = heads_find(in, lines, columns);
    if (at < 0) return in->err->status;
    *next = at + 1;
    if (lines->n == 0) return HAWSER_OK;
    const int first = at < lines->n ? at : 0, n = row_split(in, lines, first, columns->separator, columns, cell);
    if (n < 0) return in->err->status;
    if (at == lines->n) {
        char all[300] = "";
        for (int i = 0; i < n && strlen(all) < 200; ++i)
            snprintf(all + strlen(all), sizeof all - strlen(all), "%s'%.30s'", i ? ", " : "", cell[i]);
        return input_error(in,
                           "the columns are none of these: length, angle, radius, turn, slope; x, y, z; x, y, "
                           "direction, length, radius; station, height and gradient or curve length; distance, "
                           "bearing: no head of a route in %s",
                           all);
    }
    columns->text = columns->work; /* the heads' names are kept */
    columns->work = NULL;
    columns->room = 0;
    columns->n = n;
    const int below = at + 1 < lines->n ? row_split(in, lines, at + 1, columns->separator, columns, unit) : 0;
    const int has_units = below > 0 && is_unit_row(below, unit);
    if (below < 0) return in->err->status;
    in->line = lines->row[at].line;
    *next += has_units;
    for (int i = 0; i < n; ++i) {
        hawser_status status = head_take(in, &columns->column[i], cell[i], table);
        if (!status && has_units && i < below && *unit[i] && !columns->column[i].head.unit) {
            const char *const from = unit[i] + strspn(unit[i], "([ ");
            snprintf(joined, sizeof joined, "%.60s (%.20s)", cell[i], from);
            if (columns->column[i].head.meaning < TABLE_COLUMNS) table->has[columns->column[i].head.meaning] = 0;
            status = strcmp(from, "-") ? head_take(in, &columns->column[i], joined, table) : HAWSER_OK;
            if (columns->column[i].head.meaning < TABLE_COLUMNS) table->has[columns->column[i].head.meaning] = 1;
            columns->column[i].name = cell[i];
        }
        if (status) return status;
    }
    if (at > 0) {
        char what[SURVEY_NAME_MAX];
        snprintf(what, sizeof what, "%d line%s above the row of column names, '%.60s'", at, at > 1 ? "s" : "",
                 lines->text + lines->row[0].at);
        for (char *c = what; *c; ++c) *c = *c == '\x1F' || *c == '\t' ? ' ' : *c;
        survey_ignore(in->out, what);
    }
    return title_check(in, lines, at, columns);
}

/* ------------------------------------------------------------------------------------------------------------ cells */

/* Converts digits in groups of three, "1,250.5", "1.250,5", "1 250,5", "1'250.5", to plain ones with a point; returns 0
 * for a comma in a file of commas that may be either. */
static int number_plain(char separator, const char *text, char *out, size_t size)
{
    size_t n = 0, digits = 0;
    const char *last_point = NULL, *last_comma = NULL;
    int points = 0, commas = 0;
    const char *c = text;
    /* the number's own signs */
    for (; *c; ++c) {
        if (*c == '.')
            last_point = c, ++points;
        else if (*c == ',')
            last_comma = c, ++commas;
        else if (isdigit((unsigned char)*c))
            ++digits;
        else if ((*c == '+' || *c == '-') && c == text)
            continue;
        else if ((*c == 'e' || *c == 'E') && digits && (isdigit((unsigned char)c[1]) || c[1] == '-' || c[1] == '+')) {
            ++c;
            while (isdigit((unsigned char)c[1])) ++c;
            ++c;
            break;
        } else if ((*c == ' ' || *c == '\'') && digits && isdigit((unsigned char)c[1]) &&
                   isdigit((unsigned char)c[2]) && isdigit((unsigned char)c[3]) && !isdigit((unsigned char)c[4]) &&
                   !points && !commas)
            continue;
        else if (!strncmp(c, "\xC2\xA0", 2) && isdigit((unsigned char)c[2]) && !points && !commas)
            ++c;
        else if (!strncmp(c, "\xE2\x80\xAF", 3) && isdigit((unsigned char)c[3]) && !points && !commas)
            c += 2;
        else
            break;
    }
    const char *const end = c;
    char decimal = '.';
    if (commas && points) {
        decimal = last_comma > last_point ? ',' : '.';
        if ((decimal == ',' ? commas : points) > 1) return snprintf(out, size, "%s", text), 1;
    } else if (commas) {
        const char *behind = last_comma + 1;
        size_t three = 0;
        while (isdigit((unsigned char)behind[three])) ++three;
        decimal = commas > 1 ? '.' : ',';
        if (commas == 1 && separator == ',' && three == 3 && behind + three == end) return 0;
    } else if (points > 1) {
        return snprintf(out, size, "%s", text), 1; /* not a number, or thousands: "1.250.000" is refused */
    }
    for (c = text; c < end && n + 1 < size; ++c) {
        if (*c == decimal)
            out[n++] = '.';
        else if (isalnum((unsigned char)*c) || *c == '+' || *c == '-')
            out[n++] = *c;
    }
    snprintf(out + n, size - n, "%s", end);
    return 1;
}

/* Reads "0+050", "K12+340.5", "12+34" in hundreds of feet: a station; returns 0 without a plus. */
static int station_read(const SurveyInput *in, const char *text, double *value)
{
    char *end, *end2;
    double ahead, behind;
    char copy[40];
    while (isalpha((unsigned char)*text) || *text == ' ' || *text == '.') ++text;
    snprintf(copy, sizeof copy, "%s", text);
    for (char *c = copy; *c; ++c) *c = *c == ',' ? '.' : *c;
    text = copy;
    if (!input_number(in, text, &end, &ahead) || *end != '+' || !isdigit((unsigned char)end[1])) return 0;
    const size_t digits = strspn(end + 1, "0123456789");
    if (!input_number(in, end + 1, &end2, &behind) || end2[strspn(end2, " m")] || (digits != 2 && digits != 3))
        return 0;
    const double part = digits == 3 ? 1000 : 100;
    *value = part * ahead + (ahead < 0 || *text == '-' ? -behind : behind);
    return 1;
}

/* Reads degrees with minutes and seconds after a degree sign or dashes: 45\xC2\xB030'15". *end follows them. Returns 0
 * if there are none. */
static int degrees_read(const SurveyInput *in, const char *text, char **end, double *degrees)
{
    static const char *const minute[] = {"'", "\xE2\x80\xB2", "\xE2\x80\x99", "m"};
    static const char *const second[] = {"\"", "''", "\xE2\x80\xB3", "\xE2\x80\x9D", "s"};
    double part;
    char *at;
    if (!input_number(in, text, &at, degrees)) return 0;
    const double sign = *degrees < 0 || *text == '-' ? -1 : 1;
    const int dashes = *at == '-' && isdigit((unsigned char)at[1]);
    if (strncmp(at, "\xC2\xB0", 2) != 0 && !dashes) return *end = at, 1;
    at += dashes ? 1 : 2;
    for (int k = 0; k < 2; ++k) {
        char *behind;
        at += strspn(at, " ");
        if (!isdigit((unsigned char)*at) || !input_number(in, at, &behind, &part)) break;
        *degrees += sign * part / (k ? 3600 : 60);
        at = behind;
        const char *const *const marks = k ? second : minute;
        for (size_t i = 0; i < (k ? 5u : 4u); ++i) {
            if (strncmp(at, marks[i], strlen(marks[i])) != 0) continue;
            at += strlen(marks[i]);
            break;
        }
        if (dashes && *at == '-') ++at;
    }
    return *end = at, 1;
}

/* Reads "N 45 30' E", "S45W": degrees clockwise from north; returns 0 if it is not a quadrant. */
static int quadrant_read(const SurveyInput *in, const char *text, double *bearing)
{
    char *end;
    const int south = toupper((unsigned char)*text) == 'S';
    if (!south && toupper((unsigned char)*text) != 'N') return 0;
    text += 1 + strspn(text + 1, " ");
    double angle;
    if (!degrees_read(in, text, &end, &angle) || angle < 0 || angle > 90) return 0;
    end += strspn(end, " ");
    const char side = (char)toupper((unsigned char)*end);
    if ((side != 'E' && side != 'W') || end[1]) return 0;
    const double from = side == 'E' ? angle : -angle;
    *bearing = south ? 180 - from : from;
    return 1;
}

/* Checks for a word for a straight in place of a radius. */
static int is_infinite(const char *text)
{
    static const char *const words[] = {"inf", "infinity", "infinite", "\xE2\x88\x9E"};
    text += *text == '+' || *text == '-';
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i) {
        if (!strcasecmp(text, words[i])) return 1;
    }
    return 0;
}

/* Reads "1:50", "1 in 50", "1/50" for a slope; returns 0 if there is none. */
static int ratio_read(const SurveyInput *in, const char *text, double *value)
{
    char *end;
    double rise, run;
    if (!input_number(in, text, &end, &rise)) return 0;
    end += strspn(end, " ");
    const size_t word = *end == ':' || *end == '/' ? 1 : !strncasecmp(end, "in ", 3) ? 3 : 0;
    if (!word || !input_number_whole(in, end + word, &run) || !(run > 0)) return 0;
    *value = rise / run;
    return 1;
}

/* Converts a slope of a column to dz/ds. */
static hawser_status slope_take(SurveyInput *in, const Column *column, const TableUnit *unit, const char *text,
                                double number, double *value)
{
    const double given = number * (unit ? unit->factor : 1);
    *value = given;
    if (unit && unit->kind == UNIT_INVERSE) *value = number == 0 ? 0 : 1 / number;
    if (unit && unit->kind == UNIT_ANGLE) {
        if (!(fabs(given) < 1.57)) return input_error(in, "'%.40s' is too steep", text);
        *value = tan(given);
    }
    if (unit || fabs(number) < 1) return HAWSER_OK;
    return input_error(
        in,
        "'%.40s' of column '%.40s' has no unit, and as a ratio it is a slope of %.3g deg: per cent? name "
        "the column '%.40s %%', or deg, or ratio",
        text, column->name, atan(number) / ROW_DEGREE, column->name);
}

/* Reads a number with its suffix: its unit, or the side of an angle. */
static hawser_status number_take(SurveyInput *in, const Columns *columns, const Column *column, const char *text,
                                 Table *table, TableRow *row)
{
    char plain[80], *end;
    const TableColumn c = column->head.meaning;
    double *const value = &row->value[c], number;
    if (!number_plain(columns->separator, text, plain, sizeof plain))
        return input_error(in,
                           "'%.40s' may be a thousand or have a decimal comma, in a file with commas between cells: "
                           "write it without the comma, or with a point",
                           text);
    if (is_slope(c) && ratio_read(in, text, value)) return HAWSER_OK;
    if (!(is_angle(c) || is_degrees(c) ? degrees_read(in, plain, &end, &number)
                                       : input_number(in, plain, &end, &number)))
        return input_error(in, "'%.40s' is no number", text);
    const int degrees = end > plain && is_angle(c) && strstr(plain, "\xC2\xB0") && strncmp(end, "\xC2\xB0", 2) != 0;
    end += strspn(end, " ");
    const TableUnit *unit = *end ? unit_find(end, strlen(end)) : degrees ? unit_find("deg", 3) : NULL;
    const TableTurn side = c == COLUMN_ANGLE && *end && !unit ? head_turn(end) : TURN_NONE;
    if ((*end && !unit && side == TURN_NONE) || (unit && *end && !is_fit(c, unit)))
        return input_error(in, "'%.40s' is no number", text);
    if (side != TURN_NONE) row->turn = side;
    if (c == COLUMN_HEADING && unit && !column->head.unit) { /* from the first row on, else they are mixed */
        if (table->n > 1 && !table->angles) return input_error(in, "'%.40s': an angle with a unit among others", text);
        table->angles = 1;
    }
    if (c == COLUMN_HEADING && !unit && !column->head.unit && table->angles) unit = unit_find("deg", 3);
    if (!unit) unit = column->head.unit;
    if (is_slope(c)) return slope_take(in, column, unit, text, number, value);
    *value = number * (unit && !is_degrees(c) ? unit->factor : column->factor);
    if ((c == COLUMN_X || c == COLUMN_Y) && unit && unit->kind == UNIT_ANGLE) *value = number;
    return HAWSER_OK;
}

static hawser_status cell_read(SurveyInput *in, const Columns *columns, const Column *column, const char *text,
                               Table *table, TableRow *row)
{
    const TableColumn c = column->head.meaning;
    double bearing;
    if (c == COLUMN_TYPE) row->straight = !strncasecmp(text, "LINE", 4) || !strncasecmp(text, "straight", 8);
    if (c == COLUMN_TURN && *text && *text != '-') {
        row->turn = head_turn(text);
        if (column->romance && row->turn == TURN_DOWN && !text[1]) row->turn = TURN_RIGHT;
        if (row->turn == TURN_NONE) return input_error(in, "turn '%.40s': expected left, right, up or down", text);
    }
    if (c >= COLUMN_TYPE || !*text || !strcmp(text, "-") || !strcmp(text, "$") || !strcmp(text, "\xE2\x80\x93"))
        return HAWSER_OK;
    if (is_radius(c) && is_infinite(text)) {
        row->value[c] = 0; /* straight */
        return HAWSER_OK;
    }
    if (c == COLUMN_HEADING && quadrant_read(in, text, &bearing)) {
        if (table->n > 1 && !table->angles && !table->north)
            return input_error(in, "'%.40s': a quadrant among plain angles", text);
        row->value[c] = bearing * ROW_DEGREE;
        table->north = table->angles = 1;
        return HAWSER_OK;
    }
    if (c == COLUMN_STATION && station_read(in, text, &row->value[c])) {
        row->value[c] *= column->head.unit && column->head.unit->factor < 1000 ? column->factor : in->unit;
        return HAWSER_OK;
    }
    if (c == COLUMN_ANGLE && *text && head_turn(text) == TURN_NONE && strchr("LRlr", *text)) { /* L45 */
        const char word[2] = {*text, 0};
        row->turn = head_turn(word);
        text += 1 + strspn(text + 1, " ");
    }
    return number_take(in, columns, column, text, table, row);
}

/* ------------------------------------------------------------------------------------------------------------- rows */

/* Text of a column's cell; "" if the row has none. */
static const char *cell_text_of(const Columns *columns, TableColumn c, int n, char *cell[CELLS_MOST])
{
    for (int i = 0; i < n && i < columns->n; ++i) {
        if (columns->column[i].head.meaning == c) return cell[i];
    }
    return "";
}

/* Name of a row: the last of the cells that may be a name, if it is not only a number. */
static const char *name_of(const Columns *columns, int n, char *cell[CELLS_MOST])
{
    const char *name = "";
    for (int i = 0; i < n && i < columns->n; ++i) {
        int letters = 0;
        for (const char *c = cell[i]; *c; ++c) letters += isalpha((unsigned char)*c) || (unsigned char)*c > 127;
        if (columns->column[i].head.meaning == COLUMN_NAME && letters) name = cell[i];
    }
    return name;
}

/* Adds a row as a mark on its layer, by x and y, its station, or both. */
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

/* Kind of a row. */
typedef enum RowKind { ROW_TABLE, ROW_NOTE, ROW_HEADS, ROW_TOTAL } RowKind;

/* Finds the kind. A row of the table has a number, or a side, in a column of the route's; one that repeats the heads is
 * none, and one marked as a total is a sum. */
static RowKind row_kind(const SurveyInput *in, const Columns *columns, int n, char *cell[CELLS_MOST])
{
    int numbers = 0, same = 0, texts = 0, total = 0, known = 0;
    for (int i = 0; i < n && i < columns->n; ++i) {
        const TableColumn c = columns->column[i].head.meaning;
        if (!*cell[i]) continue;
        const int number = begins_number(cell[i]);
        total |= !number && head_is_total(cell[i]);
        same += !strcasecmp(cell[i], columns->column[i].name);
        texts += !number;
        numbers += c < COLUMN_TYPE && (number || is_infinite(cell[i]) || quadrant_read(in, cell[i], &(double){0}) ||
                                       (c == COLUMN_STATION && station_read(in, cell[i], &(double){0})) ||
                                       (c == COLUMN_ANGLE && strpbrk(cell[i], "0123456789")));
    }
    if (total) return ROW_TOTAL;
    if (numbers) return ROW_TABLE;
    if (same > 1 && same == texts) return ROW_HEADS;
    for (int i = 0; i < n; ++i) known += head_read(cell[i]).meaning < COLUMN_TYPE;
    return known > 1 ? ROW_HEADS : ROW_NOTE;
}

/* Takes the number of a row of totals in the column of lengths. */
static void total_take(SurveyInput *in, const Columns *columns, int n, char *cell[CELLS_MOST], Table *table)
{
    TableRow row = {.line = in->line};
    hawser_error *const kept = in->err, none = {0};
    hawser_error mine = none;
    in->err = &mine;
    for (int i = 0; i < n && i < columns->n; ++i) {
        const Column *const c = &columns->column[i];
        if (c->head.meaning != COLUMN_LENGTH || !begins_number(cell[i])) continue;
        if (number_take(in, columns, c, cell[i], table, &row)) continue;
        table->total = row.value[COLUMN_LENGTH];
        table->total_line = in->line;
    }
    in->err = kept;
}

static void note_say(SurveyInput *in, const char *what, int n, char *cell[CELLS_MOST])
{
    char text[SURVEY_NAME_MAX];
    const char *first = "";
    for (int i = 0; i < n && !*first; ++i) first = cell[i];
    snprintf(text, sizeof text, "line %ld, %s: '%.60s'", in->line, what, first);
    survey_ignore(in->out, text);
}

/* Refuses a file with both points and commas as decimals: one of them must separate thousands. */
static hawser_status decimals_check(SurveyInput *in, Columns *columns, const char *text)
{
    const char *const comma = strchr(text, ','), *const point = strchr(text, '.');
    if (columns->separator == ',' || columns->separator == '\x1F' || (!comma) == (!point)) return HAWSER_OK;
    *(comma ? &columns->commas : &columns->points) = 1;
    if (!columns->commas || !columns->points) return HAWSER_OK;
    return input_error(in, "'%.40s': decimal points and commas in one file: are some of them thousands?", text);
}

static hawser_status row_read(SurveyInput *in, Columns *columns, int n, char *cell[CELLS_MOST], Table *table)
{
    for (int i = columns->n; i < n; ++i) {
        if (*cell[i])
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
        const Column *const column = &columns->column[i];
        if (column->head.meaning == TABLE_COLUMNS) continue;
        if (column->head.meaning < COLUMN_TYPE) status = decimals_check(in, columns, cell[i]);
        if (!status) status = cell_read(in, columns, column, cell[i], table, row);
    }
    if (!status && table->has[COLUMN_NAME] && !in->options.marks)
        row->name = piece_names_add(&table->names, name_of(columns, n, cell));
    if (!status && in->options.marks) status = mark_add(in, columns, table, n, cell, row);
    return status;
}

/* ---------------------------------------------------------------------------------------------- unused columns */

/* Checks for a quantity: a number, with or without a unit or a side, a station or a ratio; a date and "12A" are none.
 */
static int is_quantity(const SurveyInput *in, char separator, const char *text)
{
    char plain[80], *end;
    double value;
    if (!begins_number(text)) return 0;
    if (station_read(in, text, &value) || ratio_read(in, text, &value)) return 1;
    if (!number_plain(separator, text, plain, sizeof plain) || !input_number(in, plain, &end, &value)) return 1;
    end += strspn(end, " ");
    return !*end || unit_find(end, strlen(end)) || head_turn(end) != TURN_NONE;
}

/* Handles columns without a meaning: refuses those with numbers, which may be a part of the route or a property of its
 * pieces, and reports the others as unused. */
static hawser_status unknown_say(SurveyInput *in, const Lines *lines, Columns *columns, int from, const char *is_row)
{
    char *cell[CELLS_MOST], what[SURVEY_NAME_MAX], all[300] = "";
    for (int i = from; i < lines->n; ++i) {
        const int n = is_row[i] ? row_split(in, lines, i, columns->separator, columns, cell) : 0;
        for (int c = 0; c < n && c < columns->n; ++c) {
            columns->column[c].rows += *cell[c] != 0;
            columns->column[c].numbers += is_quantity(in, columns->separator, cell[c]);
        }
    }
    for (int c = 0; c < columns->n; ++c) {
        const Column *const column = &columns->column[c];
        if (column->head.meaning != TABLE_COLUMNS || column->ignored || (!*column->name && column->rows == 0)) continue;
        if (column->numbers && !column->head.unrelated && !in->options.marks) {
            if (strlen(all) < 200)
                snprintf(all + strlen(all), sizeof all - strlen(all), "%s%d '%.40s'", *all ? ", " : "", c + 1,
                         column->name);
            continue;
        }
        snprintf(what, sizeof what, "column '%.60s'", column->name);
        survey_ignore(in->out, what);
    }
    in->line = 0;
    if (!*all) return HAWSER_OK;
    return input_error(
        in,
        "columns with numbers whose head is not known: %s; expected length, angle, radius, turn, slope, x, "
        "y, z, station, direction or bearing; what is not part of the route is named in 'ignore'",
        all);
}

/* Checks that names to ignore are names of columns. */
static hawser_status ignore_check(SurveyInput *in, const Columns *columns)
{
    char word[TABLE_HEAD_MOST], own[TABLE_HEAD_MOST], other[TABLE_HEAD_MOST];
    for (const char *at = in->options.ignore; at && *at;) {
        const size_t size = strcspn(at, "\n");
        int found = 0;
        snprintf(word, sizeof word, "%.*s", (int)size, at);
        head_letters(word, own);
        for (int i = 0; i < columns->n; ++i) {
            head_letters(columns->column[i].name, other);
            found |= !strcasecmp(word, columns->column[i].name) || (*own && !strcmp(own, other));
        }
        in->line = 0;
        if (!found) return input_error(in, "'ignore' names a column '%.60s', and there is none", word);
        at += size + (at[size] != 0);
    }
    return HAWSER_OK;
}

/* Settles heads whose cells decide their meaning: a direction given by words is a turn; single letters of Romance
 * languages are left and right. */
static hawser_status words_settle(SurveyInput *in, const Lines *lines, Columns *columns, Table *table, int from)
{
    char *cell[CELLS_MOST];
    int words[CELLS_MOST] = {0}, others[CELLS_MOST] = {0};
    for (int i = from; i < lines->n && i < from + 1000; ++i) {
        const int n = row_split(in, lines, i, columns->separator, columns, cell);
        if (n < 0) return in->err->status;
        for (int c = 0; c < n && c < columns->n; ++c) {
            if (!*cell[c]) continue;
            const int turn = head_turn(cell[c]) != TURN_NONE;
            words[c] += turn;
            others[c] += !turn && strcmp(cell[c], "-") != 0;
            if (strlen(cell[c]) == 1 && strchr("gGiI", *cell[c])) columns->column[c].romance = 1;
        }
    }
    for (int c = 0; c < columns->n; ++c) {
        TableHead *const head = &columns->column[c].head;
        if ((head->meaning != COLUMN_HEADING && head->meaning != COLUMN_Z) || !words[c] || others[c]) continue;
        table->has[head->meaning] = 0;
        table->has[head->meaning = COLUMN_TURN] = 1;
    }
    return HAWSER_OK;
}

static hawser_status rows_take(SurveyInput *in, const Lines *lines, Columns *columns, Table *table, int from,
                               char *is_row)
{
    char *cell[CELLS_MOST];
    for (int i = from; i < lines->n; ++i) {
        const int n = row_split(in, lines, i, columns->separator, columns, cell);
        if (n < 0) return in->err->status;
        const RowKind kind = in->options.marks ? ROW_TABLE : row_kind(in, columns, n, cell);
        hawser_status status = HAWSER_OK;
        if (kind == ROW_HEADS) {
            int same = 0, filled = 0;
            for (int c = 0; c < n && c < columns->n; ++c)
                filled += *cell[c] != 0, same += *cell[c] && !strcasecmp(cell[c], columns->column[c].name);
            if (same != filled || n > columns->n)
                return input_error(in, "a second row of heads, '%.40s': one table a file, or a sheet", cell[0]);
        }
        if (kind == ROW_TOTAL) {
            total_take(in, columns, n, cell, table);
            note_say(in, "a sum, is no piece", n, cell);
        }
        if (kind == ROW_NOTE) note_say(in, "has no numbers", n, cell);
        if (kind == ROW_TABLE) status = row_read(in, columns, n, cell, table);
        if (status) return status;
        is_row[i] = kind == ROW_TABLE;
    }
    return HAWSER_OK;
}

hawser_status table_rows(SurveyInput *in, Table *table)
{
    Lines lines = {0};
    Columns *const columns = calloc(1, sizeof *columns);
    int from = 0;
    char *is_row = NULL;
    hawser_status status = columns ? lines_read(in, &lines) : error_memory(in->err);
    table->total = NAN;
    if (!status && lines.n && !lines.sheet &&
        !strncmp(lines.text, "sep=", 4)) { /* the separator line of a spreadsheet program */
        memmove(lines.row, lines.row + 1, (size_t)--lines.n * sizeof *lines.row);
    }
    if (!status) status = heads_read(in, &lines, columns, table, &from);
    if (!status) status = ignore_check(in, columns);
    if (!status && !(is_row = calloc((size_t)lines.n + 1, 1))) status = error_memory(in->err);
    if (!status) status = words_settle(in, &lines, columns, table, from);
    if (!status) status = rows_take(in, &lines, columns, table, from, is_row);
    if (!status && table->n == 0)
        status = input_error(in, "no rows: expected a line of column names and rows below it");
    if (!status) status = unknown_say(in, &lines, columns, from, is_row);
    if (columns) free(columns->text), free(columns->work);
    free(columns);
    free(is_row);
    free(lines.text);
    free(lines.row);
    return status;
}
