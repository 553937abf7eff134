/* What stands over a column: its meaning in six languages, its unit, and whether an unknown head resembles one of them.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "survey/table/table.h"

#define DEGREE 0.017453292519943295

/* Which words stand over which column: letters and digits alone, in lower case, ae for the German umlaut, e for e with
 * an accent. English, German, French, Spanish, Italian, Chinese. */
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

/* What a head may have beside its word: "segment length", "coordenada x". */
static const char idle_words[] = " segment section piece straight part leg route line point vertex coordinate coord "
                                 "koordinate coordenada coordonnee coordinata of the de del der du la le di design "
                                 "nominal bend curve abschnitt in en ";

/* Columns of other things, although their heads have letters of a route's, or numbers that may go along it. */
static const char unrelated[] =
    " gravitycenterlineheight date datum fecha data time zeit heure hora uhrzeit gpstime timestamp sheet page blatt "
    "seite cost price kosten preis cout prix costo coste precio prezzo no nr num number index count fid oid "
    "objectid row remark remarks note notes comment comments bemerkung remarque nota temperature temp cover depth "
    "tiefe "
    "section segment element piece point pt description abschnitt punkt troncon tramo tratta tratto material diameter "
    "durchmesser pulltension status drawing revision rev zone layername color colour "
    "speed quality hdop vdop pdop accuracy sd sigma "
    "\xE5\xBA\x8F\xE5\x8F\xB7 \xE5\xA4\x87\xE6\xB3\xA8 \xE6\x97\xA5\xE6\x9C\x9F ";

/* Parts of words by which a head resembles one of a route. */
static const char *const stems[] = {"length",
                                    "laenge",
                                    "longueur",
                                    "lunghez",
                                    "longitud",
                                    "distan",
                                    "entfern",
                                    "chainage",
                                    "station",
                                    "slope",
                                    "grade",
                                    "gradi",
                                    "gefaell",
                                    "steigung",
                                    "neigung",
                                    "inclin",
                                    "pente",
                                    "pendi",
                                    "penden",
                                    "bearing",
                                    "azimu",
                                    "acimu",
                                    "direction",
                                    "direcci",
                                    "direzion",
                                    "richtung",
                                    "heading",
                                    "gisement",
                                    "rumbo",
                                    "radius",
                                    "radii",
                                    "raggio",
                                    "rayon",
                                    "angle",
                                    "angul",
                                    "angol",
                                    "winkel",
                                    "deflec",
                                    "easting",
                                    "northing",
                                    "rechtsw",
                                    "hochw",
                                    "elevat",
                                    "altit",
                                    "height",
                                    "hoehe",
                                    "haute",
                                    "latit",
                                    "longit",
                                    "curvat",
                                    "coord",
                                    "koord",
                                    "\xE9\x95\xBF",
                                    "\xE8\xA7\x92",
                                    "\xE5\x8D\x8A\xE5\xBE\x84",
                                    "\xE5\x9D\xA1",
                                    "\xE9\xAB\x98\xE7\xA8\x8B",
                                    "\xE6\x96\xB9\xE4\xBD\x8D",
                                    "\xE6\xA1\xA9\xE5\x8F\xB7",
                                    "\xE9\x87\x8C\xE7\xA8\x8B",
                                    "\xE5\x9D\x90\xE6\xA0\x87"};

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

/* A letter with an accent as letters of the alphabet, from its two bytes of UTF-8; NULL: none. */
static const char *latin(unsigned char lead, unsigned char next)
{
    /* C3 80 to C3 BF, capitals as small ones */
    static const char *const of[32] = {"a",  "a",  "a", "a", "ae", "a", "ae", "c", "e",  "e", "e",
                                       "e",  "i",  "i", "i", "i",  "d", "n",  "o", "o",  "o", "o",
                                       "oe", NULL, "o", "u", "u",  "u", "ue", "y", NULL, "ss"};
    return lead == 0xC3 ? of[next & 0x1F] : NULL;
}

void head_letters(const char *text, char letters[TABLE_HEAD_MOST])
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

/* Where a unit stands at the end of a head without brackets, "Length m", "slope_pct", "Grade%", "L\xC3\xA4nge in m",
 * and what is ahead of it; NULL: none. */
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

/* The meaning of letters; TABLE_COLUMNS: none. *which: the row of the list. */
static TableColumn meaning_of(const char *letters, size_t *which)
{
    for (size_t i = 0; i < sizeof heads / sizeof *heads; ++i) {
        *which = i;
        if (is_among(heads[i].names, letters)) return heads[i].column;
    }
    return TABLE_COLUMNS;
}

/* The same of the words that are not idle. */
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
    /* a German Grad is a degree, a French grade a gon: only German words make it one of them */
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
    for (size_t i = 0; i < sizeof stems / sizeof *stems && head.meaning == TABLE_COLUMNS && !head.unrelated; ++i)
        head.resembles |= strstr(letters, stems[i]) != NULL;
    return head;
}

static const char totals[] =
    " total totals totallength grandtotal subtotal sum summe gesamt gesamtlaenge gesamtsumme zwischensumme somme "
    "longueurtotale totaux suma sumatotal longitudtotal totales totale somma lunghezzatotale "
    "\xE5\x90\x88\xE8\xAE\xA1 \xE6\x80\xBB\xE8\xAE\xA1 \xE6\x80\xBB\xE9\x95\xBF \xE5\xB0\x8F\xE8\xAE\xA1 ";

int head_is_total(const char *text)
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
