/* Units for display. One table holds every unit that a column or a sentence may have, its counterpart and the factor
 * between them; tables, facts, figures and sentences all use it. */
#include "io/results/column.h"

#include "io/case/units.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Exact by definition; the pound of force is the pound under standard gravity. */
#define FOOT  UNIT_FOOT
#define POUND UNIT_POUND
#define FORCE (UNIT_POUND * UNIT_GRAVITY)
#define PSI   (FORCE / ((FOOT / 12) * (FOOT / 12)))
#define CMIL  (3.14159265358979323846 / 4 * (FOOT / 12e3) * (FOOT / 12e3))

typedef struct Pair {
    const char *si, *us; /* us NULL: the unit is the same in both */
    double factor;       /* number of `us` in one `si` */
} Pair;

static const Pair pairs[] = {
    {"N", "lbf", 1 / FORCE},
    {"kN", "lbf", 1e3 / FORCE},
    {"MN", "kip", 1e3 / FORCE},
    {"daN", "lbf", 10 / FORCE},
    {"m", "ft", 1 / FOOT},
    {"km", "ft", 1e3 / FOOT},
    {"cm", "in", 0.12 / FOOT},
    {"mm", "in", 0.012 / FOOT},
    {"m2", "ft2", 1 / (FOOT * FOOT)},
    {"cm2", "in2", 0.0144 / (FOOT * FOOT)},
    {"mm2", "kcmil", 1e-9 / CMIL},
    {"N/m", "lbf/ft", FOOT / FORCE},
    {"kN/m", "lbf/ft", 1e3 * FOOT / FORCE},
    {"daN/m", "lbf/ft", 10 * FOOT / FORCE},
    {"N/mm", "lbf/in", FOOT / 0.012 / FORCE},
    {"kN/mm", "lbf/in", 1e3 * FOOT / 0.012 / FORCE},
    {"Pa", "psi", 1 / PSI},
    {"kPa", "psi", 1e3 / PSI},
    {"MPa", "psi", 1e6 / PSI},
    {"N/mm2", "psi", 1e6 / PSI},
    {"GPa", "ksi", 1e6 / PSI},
    {"kg", "lb", 1 / POUND},
    {"kg/m", "lb/ft", FOOT / POUND},
    {"kg/km", "lb/kft", FOOT / POUND},
    {"kg/m3", "lb/ft3", FOOT *FOOT *FOOT / POUND},
    {"kg m2", "lb ft2", 1 / (POUND * FOOT * FOOT)},
    {"N m", "lbf ft", 1 / (FORCE * FOOT)},
    {"kN m", "lbf ft", 1e3 / (FORCE * FOOT)},
    {"N m2", "lbf ft2", 1 / (FORCE * FOOT * FOOT)},
    {"kN m2", "lbf ft2", 1e3 / (FORCE * FOOT * FOOT)},
    {"N s", "lbf s", 1 / FORCE},
    {"N s/m", "lbf s/ft", FOOT / FORCE},
    {"N m/rad", "lbf ft/rad", 1 / (FORCE * FOOT)},
    {"J", "ft lbf", 1 / (FORCE * FOOT)},
    {"kJ", "ft lbf", 1e3 / (FORCE * FOOT)},
    {"W", "ft lbf/s", 1 / (FORCE * FOOT)},
    {"kW", "ft lbf/s", 1e3 / (FORCE * FOOT)},
    {"m/s", "ft/min", 60 / FOOT},
    {"mm/s", "ft/min", 0.06 / FOOT},
    {"m/min", "ft/min", 1 / FOOT},
    {"m/s2", "ft/s2", 1 / FOOT},
    {"m-1", "ft-1", FOOT},
    {"1/m", "1/ft", FOOT},
    /* the same in both */
    {"s", NULL, 1},
    {"1/s", NULL, 1},
    {"Hz", NULL, 1},
    {"deg", NULL, 1},
    {"rad", NULL, 1},
    {"rad/s", NULL, 1},
    {"%", NULL, 1},
};
enum { PAIRS = sizeof pairs / sizeof *pairs };

/* Sizes, in `unit`, from which a larger or smaller unit of the same system is easier to read. */
static const struct Step {
    const char *unit;
    double from, below; /* sizes from .. below */
    const char *better;
    double factor;
} steps[] = {
    {"N", 1e3, INFINITY, "kN", 1e-3}, {"N/m", 1e3, INFINITY, "kN/m", 1e-3},
    {"m", 0, 0.1, "mm", 1e3},         {"lbf", 1e5, INFINITY, "kip", 1e-3},
    {"ft", 0, 1, "in", 12},
};

const char *shown_pair(int i, const char **shown, double *factor)
{
    while (i < PAIRS && !pairs[i].us) ++i;
    if (i >= PAIRS) return NULL;
    *shown = pairs[i].us;
    *factor = pairs[i].factor;
    return pairs[i].si;
}

Scale scale_of(const char *unit, double size, hawser_units units)
{
    Scale scale = {1, unit};
    for (int i = 0; i < PAIRS && units == HAWSER_US; ++i) {
        if (!pairs[i].us || strcmp(pairs[i].si, unit) != 0) continue;
        scale = (Scale){pairs[i].factor, pairs[i].us};
        break;
    }
    for (size_t i = 0; i < sizeof steps / sizeof *steps; ++i) {
        const double shown = fabs(size) * scale.factor;
        if (strcmp(steps[i].unit, scale.unit) != 0 ||
            !(shown > 0 && shown >= steps[i].from && shown < steps[i].below)) {
            continue;
        }
        return (Scale){scale.factor * steps[i].factor, steps[i].better};
    }
    return scale;
}

/* ------------------------------------------------------------------------------------------------- keys */

/* Returns the length of a unit at the end of a key, written as in keys ("N/m" is N_per_m, "N m2" N_m2, "%" pct), behind
 * an underscore or alone; 0 if there is none. */
static size_t unit_tail(const char *key, const char *unit)
{
    char tail[32] = "_";
    size_t n = 1;
    for (const char *p = *unit == '1' ? unit + 1 : unit; *p && n < sizeof tail - 8; ++p) {
        if (*p == ' ') tail[n++] = '_';
        if (*p == '/') n += (size_t)sprintf(tail + n, n > 1 ? "_per_" : "per_");
        if (*p == '%') n += (size_t)sprintf(tail + n, "pct");
        if (!strchr(" /%", *p)) tail[n++] = *p;
    }
    tail[n] = 0;
    const size_t length = strlen(key);
    return length > n && !strcmp(key + length - n, tail) ? n : 0;
}

/* Returns the longest unit at the end of a key, and its length there. */
static const char *find_unit(const char *key, size_t *length)
{
    const char *unit = "";
    *length = 0;
    for (int i = 0; i < PAIRS; ++i) {
        const size_t n = unit_tail(key, pairs[i].si);
        if (n <= *length) continue;
        *length = n;
        unit = pairs[i].si;
    }
    return unit;
}

const char *unit_of_key(const char *key)
{
    size_t length;
    return find_unit(key, &length);
}

size_t key_length(const char *key)
{
    size_t length;
    find_unit(key, &length);
    return strlen(key) - length;
}

/* ------------------------------------------------------------------------------------------------- numbers */

const char *say_digits(double value, int digits, char *text)
{
    if (!(fabs(value) >= 1e-4 && fabs(value) < 1e15)) {
        snprintf(text, HAWSER_SHOWN_MAX, "%.*g", digits, value);
        return text;
    }
    const int before = (int)floor(log10(fabs(value))) + 1, decimals = digits > before ? digits - before : 0;
    snprintf(text, HAWSER_SHOWN_MAX, "%.*f", decimals, value);
    if (!strchr(text, '.')) return text;
    char *end = text + strlen(text);
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
    *end = 0;
    return text;
}

/* Writes a conductor's area as its gauge where it is one of the standard's sizes; wires above 4/0 are in circular mils.
 */
static int say_gauge(double kcmil, char *text)
{
    for (int number = -3; number <= 40; ++number) {
        const double size = awg_area(number) / (1e3 * CMIL);
        if (!(fabs(kcmil / size - 1) < 5e-3)) continue;
        if (number > 0) snprintf(text, HAWSER_SHOWN_MAX, "%d AWG", number);
        if (number <= 0) snprintf(text, HAWSER_SHOWN_MAX, "%d/0 AWG", 1 - number);
        return 1;
    }
    return 0;
}

/* Writes value and unit. */
static const char *say_scaled(double value, Scale scale, int digits, char *text)
{
    const double shown = value * scale.factor;
    if (!strcmp(scale.unit, "kcmil") && say_gauge(shown, text)) return text;
    say_digits(shown, digits, text);
    const size_t used = strlen(text);
    if (*scale.unit) snprintf(text + used, HAWSER_SHOWN_MAX - used, " %s", scale.unit);
    return text;
}

const char *hawser_show(double value, const char *unit, hawser_units units, char *text)
{
    if (!text || !unit) return "";
    if (isinf(value)) return strcpy(text, "none");
    if (isnan(value)) return strcpy(text, "-");
    return say_scaled(value, scale_of(strcmp(unit, "1") ? unit : "", value, units), 4, text);
}

const char *hawser_show_figure(const hawser_figure *figure, hawser_units units, char *text)
{
    char value[HAWSER_SHOWN_MAX];
    if (!figure || !text) return "";
    const int n = (int)key_length(figure->key);
    hawser_show(figure->value, unit_of_key(figure->key), units, value);
    snprintf(text, 2 * (size_t)HAWSER_SHOWN_MAX, "%.*s %s", n < HAWSER_SHOWN_MAX ? n : HAWSER_SHOWN_MAX - 1,
             figure->key, value);
    for (int i = 0; i < n && text[i]; ++i) {
        if (text[i] == '_') text[i] = ' ';
    }
    return text;
}

/* ------------------------------------------------------------------------------------------------- sentences */

/* Returns the length of a number at p; 0 if there is none, or if it belongs to a word or a key ("eq2",
 * "chain.0.segment"). */
static size_t number_at(const char *start, const char *p)
{
    const char before = p > start ? p[-1] : ' ';
    const char *const first = p;
    if (isalnum((unsigned char)before) || strchr("._-/^", before)) return 0;
    p += *p == '-' || *p == '+';
    if (!isdigit((unsigned char)*p)) return 0;
    p += strspn(p, "0123456789");
    if (*p == '.' && isdigit((unsigned char)p[1])) p += 1 + strspn(p + 1, "0123456789");
    if (*p == 'e' && (isdigit((unsigned char)p[1]) || (strchr("+-", p[1]) && p[1] && isdigit((unsigned char)p[2])))) {
        p += 2 + strspn(p + 2, "0123456789");
    }
    return (size_t)(p - first);
}

/* Returns the longest unit of the table at p, as a whole word; NULL if there is none. */
static const Pair *unit_at(const char *p)
{
    const Pair *found = NULL;
    for (int i = 0; i < PAIRS; ++i) {
        const size_t n = strlen(pairs[i].si);
        if (strncmp(p, pairs[i].si, n) != 0 || (found && strlen(found->si) >= n)) continue;
        const int ends = !isalnum((unsigned char)p[n]) && !(p[n] && strchr("/^_", p[n])) &&
                         !(p[n] == '-' && isdigit((unsigned char)p[n + 1]));
        if (ends) found = &pairs[i];
    }
    return found;
}

/* Returns the unit of the number that ends at p: behind it, or behind the next one of "0.5 to 1 kN/m". *gap gets the
 * blanks before it if it is behind this very number, -1 otherwise. */
static const Pair *unit_behind(const char *start, const char *p, int *gap)
{
    static const char *const joins[] = {" to ", " and "};
    const int blank = *p == ' ';
    const Pair *const unit = unit_at(p + blank);
    *gap = unit ? blank : -1;
    for (int k = 0; !unit && k < 2; ++k) {
        const size_t n = strlen(joins[k]), digits = strncmp(p, joins[k], n) ? 0 : number_at(start, p + n);
        if (digits > 0) return unit_at(p + n + digits + (p[n + digits] == ' '));
    }
    return unit;
}

/* Counts the significant digits of a number. */
static int digits_of(const char *number, size_t length)
{
    int digits = 0;
    for (size_t i = 0; i < length && number[i] != 'e'; ++i) {
        digits += isdigit((unsigned char)number[i]) && (digits > 0 || number[i] != '0');
    }
    return digits;
}

/* Returns the number's value; the decimal sign is a point in any locale. */
static double value_of(const char *number, size_t length)
{
    double value = 0;
    long power = 0;
    int behind = 0;
    for (size_t i = 0; i < length; ++i) {
        if (number[i] == 'e') {
            power += strtol(number + i + 1, NULL, 10);
            break;
        }
        behind |= number[i] == '.';
        if (!isdigit((unsigned char)number[i])) continue;
        value = 10 * value + (number[i] - '0');
        power -= behind;
    }
    return (*number == '-' ? -1 : 1) * value * pow(10, (double)power);
}

/* Returns the end of the brackets at p, behind the last one; NULL: they do not close. */
static const char *bracket_end(const char *p)
{
    int open = 0;
    for (; *p; ++p) {
        open += (*p == '(') - (*p == ')');
        if (open == 0) return p + 1;
    }
    return NULL;
}

/* Returns the length of the user's own words at p, which stay as they are: in quotes, between marks, or in brackets
 * behind a length, as the name of a place is ("17.3 m (out)"). 0: none. behind: end of the last length. */
static size_t name_at(const char *start, const char *p, const char *behind)
{
    const char *end = NULL;
    if (*p == NAME_BEGINS) end = strchr(p, NAME_ENDS);
    if (*p == NAME_BEGINS) return end ? (size_t)(end + 1 - p) : 0;
    if (*p == '(' && behind && p == behind + 1) end = bracket_end(p);
    if (*p == '\'' && (p == start || !isalnum((unsigned char)p[-1]))) {
        end = strchr(p + 1, '\'');
        while (end && isalnum((unsigned char)end[1])) end = strchr(end + 1, '\'');
        if (end) ++end;
    }
    return end ? (size_t)(end - p) : 0;
}

/* Adds n bytes without marks, as far as they fit. */
static size_t plain_add(const char *from, size_t n, char *text, size_t used, size_t size)
{
    for (size_t i = 0; i < n && used + 1 < size; ++i) {
        if (from[i] != NAME_BEGINS && from[i] != NAME_ENDS) text[used++] = from[i];
    }
    return used;
}

const char *place_mark(const char *place, char *text, size_t size)
{
    static const char on[] = " m on ";
    const size_t digits = number_at(place, place);
    const int bare = digits > 0 && !strncmp(place + digits, " m", 2) &&
                     (!place[digits + 2] || !strncmp(place + digits + 2, " (", 2));
    const size_t before = digits > 0 && !strncmp(place + digits, on, sizeof on - 1) ? digits + sizeof on - 1 : 0;
    if (bare || !*place) snprintf(text, size, "%s", place);
    if (!bare && *place) snprintf(text, size, "%.*s%c%s%c", (int)before, place, NAME_BEGINS, place + before, NAME_ENDS);
    return text;
}

const char *hawser_show_text(const char *sentence, hawser_units units, char *text, size_t size)
{
    const char *p = sentence, *behind = NULL; /* end of the last length */
    size_t used = 0;
    if (!sentence || !text || size == 0) return "";
    if (units == HAWSER_SI) used = plain_add(sentence, strlen(sentence), text, 0, size);
    while (units != HAWSER_SI && *p && used + HAWSER_SHOWN_MAX < size) {
        const size_t own = name_at(sentence, p, behind), length = number_at(sentence, p);
        if (own > 0) {
            used = plain_add(p, own, text, used, size);
            p += own;
            continue;
        }
        int gap = -1;
        const Pair *const unit = length > 0 ? unit_behind(sentence, p + length, &gap) : NULL;
        if (!unit || !unit->us) {
            const size_t n = length > 0 ? length : 1;
            memcpy(text + used, p, n);
            used += n;
            p += n;
            continue;
        }
        char shown[HAWSER_SHOWN_MAX];
        const int digits = digits_of(p, length);
        say_scaled(value_of(p, length), (Scale){unit->factor, gap < 0 ? "" : unit->us}, digits > 3 ? digits : 3, shown);
        used += (size_t)snprintf(text + used, size - used, "%s", shown);
        p += length;
        if (gap >= 0) p += (size_t)gap + strlen(unit->si);
        if (gap >= 0 && !strcmp(unit->si, "m")) behind = p;
    }
    text[used] = 0;
    return text;
}
