#include "survey/read.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

enum { HEAD_SIZE = 1 << 14 }; /* comments may precede the identifying text */

typedef hawser_status (*Reader)(SurveyInput *in);

static int is_step(const char *head) { return !strncmp(head, "ISO-10303-21", 12); }
/* Checks for a first group 0 SECTION, perhaps after comments (999). */
static int is_dxf(const char *head)
{
    const char *const behind = head + strspn(head, "0123456789");
    return !strncmp(head, "AutoCAD Binary DXF", 18) ||
           ((!strncmp(head, "999", 3) || !strncmp(head, "0", 1)) && (*behind == '\r' || *behind == '\n'));
}
/* Checks for AutoCAD's default format. */
static int is_dwg(const char *head) { return !strncmp(head, "AC10", 4); }
static hawser_status dwg_read(SurveyInput *in)
{
    return input_error(in, "a DWG drawing, which cannot be read: save it as DXF (SAVEAS, any version from R12 on)");
}

/* Returns the end of a declaration, a comment or a DOCTYPE with its brackets, which begins at `text`; NULL: it does not
 * end. */
static const char *prolog_end(const char *text)
{
    const int comment = !strncmp(text, "<!--", 4), declaration = text[1] == '?';
    const char *const end = comment ? strstr(text + 4, "-->") : declaration ? strstr(text, "?>") : NULL;
    if (comment || declaration) return end ? end + (comment ? 3 : 2) : NULL;
    for (int depth = 0; *text; ++text) {
        depth += (*text == '[') - (*text == ']');
        if (*text == '>' && depth == 0) return text + 1;
    }
    return NULL;
}

/* Checks for XML whose outermost element is gpx or kml, with or without a prefix. */
static int is_tracks(const char *head)
{
    while (head && *head == '<' && (head[1] == '?' || head[1] == '!')) {
        head = prolog_end(head);
        if (head) head += strspn(head, " \t\r\n");
    }
    if (!head || *head != '<') return 0;
    const size_t size = strcspn(head + 1, " \t\r\n/>");
    return (size == 3 || (size > 3 && head[size - 3] == ':')) &&
           (!strncmp(head + size - 2, "gpx", 3) || !strncmp(head + size - 2, "kml", 3));
}
static int is_archive(const char *head) { return !strncmp(head, "PK\3\4", 4); }
/* Checks for the container of .xls, and of workbooks with a password. */
static int is_old_office(const char *head) { return !strncmp(head, "\xD0\xCF\x11\xE0", 4); }
static hawser_status old_office_read(SurveyInput *in)
{
    return input_error(in, "an .xls workbook, or one with a password, which cannot be read: save it as .xlsx without");
}
/* Signature of a shapefile and of its index, which only their names distinguish. */
static const char shape_sign[] = {0, 0, 0x27, 0x0A};
static int is_shape(const char *head) { return !memcmp(head, shape_sign, sizeof shape_sign); }
/* Checks for JSON; a feature per line may follow a record separator. */
static int is_json(const char *head) { return *head == '{' || (*head == 0x1E && head[1] == '{'); }
static int is_xml(const char *head) { return *head == '<'; }
static int is_table(const char *head) { return *head != 0; }

/* The first reader whose check succeeds reads the file. */
static const struct {
    int (*is)(const char *head);
    Reader read;
} readers[] = {{is_shape, shape_read},   {is_archive, sheet_read}, {is_old_office, old_office_read},
               {is_dxf, dxf_read},       {is_dwg, dwg_read},       {is_step, ifc_read},
               {is_tracks, tracks_read}, {is_json, geojson_read},  {is_xml, landxml_read},
               {is_table, table_read}};

static int is_table_of(Reader read) { return read == table_read || read == sheet_read; }

/* Reads the file's beginning without byte-order mark and blanks, and rewinds it. *wide: it is text of two bytes per
 * character (UTF-16); the head then has every other byte. */
static void head_of(SurveyInput *in, char head[HEAD_SIZE], int *wide)
{
    char text[HEAD_SIZE] = "";
    size_t n = fread(text, 1, HEAD_SIZE - 1, in->file);
    *wide = n > 2 && (!memcmp(text, "\xFF\xFE", 2) || !memcmp(text, "\xFE\xFF", 2));
    const size_t odd = *text == '\xFE';
    for (size_t i = 0; *wide && i + 3 < n; i += 2) text[i / 2] = text[i + 2 + odd];
    if (*wide) n = n / 2 - 1;
    text[n] = 0;
    const char *from = text + (strncmp(text, "\xEF\xBB\xBF", 3) ? 0 : 3);
    from += strspn(from, " \t\r\n");
    memcpy(head, from, (size_t)(text + n - from) + 1);
    input_seek(in, 0);
}

/* Decodes text of two bytes per character to UTF-8, which is read in its place. */
static hawser_status wide_decode(SurveyInput *in)
{
    const size_t most = (size_t)200 << 20;
    char *wide = NULL, *text = NULL;
    size_t size = 0, n = 0;
    hawser_status status = input_all(in, most, &wide, &size);
    if (!status && !(text = malloc(3 * size / 2 + 4))) status = error_memory(in->err);
    const int big = !status && *wide == '\xFE';
    unsigned first = 0; /* of a surrogate pair */
    for (size_t i = 2; !status && i + 1 < size; i += 2) {
        const unsigned char *const c = (const unsigned char *)wide + i;
        const unsigned u = big ? (unsigned)c[0] << 8 | c[1] : (unsigned)c[1] << 8 | c[0];
        if (u >= 0xD800 && u < 0xDC00) {
            first = u;
            continue;
        }
        n += input_utf8(text + n, first && u >= 0xDC00 && u < 0xE000 ? 0x10000 + ((first - 0xD800) << 10) + (u - 0xDC00)
                                  : u >= 0xD800 && u < 0xE000        ? '?'
                                                                     : u);
        first = 0;
    }
    free(wide);
    if (!status && n == 0) status = input_error(in, "the file is empty");
    if (!status) return input_hold(in, text, n);
    free(text);
    return status;
}

/* Names unnamed alignments after the file, without folder and extension. */
static void names_fill(const char *path, Survey *s)
{
    const char *const slash = strrchr(path, '/'), *const base = slash ? slash + 1 : path;
    const char *const dot = strrchr(base, '.');
    for (int i = 0; i < s->n; ++i) {
        if (*s->alignment[i].name) continue;
        snprintf(s->alignment[i].name, SURVEY_NAME_MAX, "%.*s", (int)(dot ? dot - base : (long)strlen(base)), base);
    }
}

enum { TURNS_MOST = 100 };
static const double FAR = 1e9;

static int is_near(double x) { return fabs(x) <= FAR; } /* false for NAN */

/* Fault of a line that cannot be on Earth, by wrong units, signs or columns; NULL: none. A line that turns endlessly
 * would take too long to measure. */
static const char *nonsense(const Alignment *a)
{
    int near = 1, wound = 0;
    for (int i = 0; i < a->n_points; ++i) {
        near &= is_near(a->point[i].x) & is_near(a->point[i].y) & is_near(a->point[i].z);
    }
    for (int i = 0; i < a->n_plan; ++i) {
        const PlanElement *const e = &a->plan[i];
        near &= is_near(e->x) & is_near(e->y) & is_near(e->length);
        wound |= !(0.5 * e->length * fmax(fabs(e->k0), fabs(e->k1)) <= TURNS_MOST * 2 * acos(-1));
    }
    for (int i = 0; i < a->n_profile; ++i) near &= is_near(a->profile[i].z) & is_near(a->profile[i].length);
    return !near   ? "lines with a place or a length beyond a million km"
           : wound ? "lines with an element that turns more than 100 times"
                   : NULL;
}

/* Drops and reports such lines. Errors: INPUT if no line remains. */
static hawser_status nonsense_drop(SurveyInput *in)
{
    Survey *const s = in->out;
    const int before = s->n;
    const char *last = NULL;
    s->n = 0;
    for (int i = 0; i < before; ++i) {
        const char *const wrong = nonsense(&s->alignment[i]);
        if (!wrong) {
            s->alignment[s->n++] = s->alignment[i];
            continue;
        }
        survey_ignore(s, last = wrong);
        alignment_clear(&s->alignment[i]);
    }
    in->line = 0;
    if (!last || s->n > 0 || s->n_marks > 0) return HAWSER_OK;
    return input_error(in, "there are only %s", last);
}

/* Reports a stated length that differs from that of the line; 0 counts as not stated. */
static void lengths_compare(Survey *s)
{
    const double least = 1e-3, part = 1e-6; /* rounding */
    for (int i = 0; i < s->n; ++i) {
        const double stated = s->alignment[i].stated_length, is = alignment_measure(&s->alignment[i]).plan_length;
        char what[SURVEY_NAME_MAX];
        if (!(stated > 0) || fabs(stated - is) < least + part * is) continue;
        snprintf(what, sizeof what, "'%.40s' is %.10g m long according to the file, but its line is %.10g m",
                 s->alignment[i].name, stated, is);
        survey_ignore(s, what);
    }
}

/* Reports a profile shorter than its line: it continues with its last grade. */
static void profiles_compare(Survey *s)
{
    const double least = 0.01, part = 1e-5; /* m; of the length, rounding of stations */
    for (int i = 0; i < s->n; ++i) {
        const Alignment *const a = &s->alignment[i];
        const double is = alignment_measure(a).plan_length;
        char what[SURVEY_NAME_MAX];
        if (a->n_profile == 0 || !(is > 0)) continue;
        const double from = a->profile[0].station,
                     to = a->profile[a->n_profile - 1].station + a->profile[a->n_profile - 1].length;
        if (from < least + part * is && to > is - least - part * is) continue;
        snprintf(what, sizeof what, "heights of '%.40s' only from %.3f to %.3f m of %.3f: its grade continues", a->name,
                 from, to, is);
        survey_ignore(s, what);
    }
}

hawser_status survey_read(const char *path, const SurveyOptions *options, Survey *out, hawser_error *err)
{
    SurveyInput in;
    hawser_error why;
    char head[HEAD_SIZE] = "";
    *out = (Survey){0};
    int wide = 0;
    hawser_status status = input_open(&in, path, options, out, err ? err : &why);
    if (!status) head_of(&in, head, &wide);
    if (!status && wide && !is_xml(head)) status = wide_decode(&in);
    if (!status && !*head && !is_shape(head)) status = input_error(&in, "the file is empty");
    for (size_t i = 0; !status && i < sizeof readers / sizeof *readers; ++i) {
        if (!readers[i].is(head)) continue;
        if (options->sheet && !is_archive(head))
            status = input_error(&in, "'sheet' chooses one of a spreadsheet (.xlsx, .ods), which this is not");
        else if (options->ignore && !is_table_of(readers[i].read))
            status = input_error(&in, "'ignore' names columns of a table, which this is not");
        else
            status = readers[i].read(&in);
        break;
    }
    /* a disk error looks like the file's end, and would be reported as the file's fault */
    const int lost = status == HAWSER_ERR_MEMORY ? 0 : input_lost(&in);
    in.line = lost ? 0 : in.line;
    if (lost) status = input_error(&in, "cannot be read: %s", strerror(lost));
    if (!status) status = nonsense_drop(&in);
    input_close(&in);
    if (!status) names_fill(path, out);
    if (!status) lengths_compare(out);
    if (!status) profiles_compare(out);
    if (status) survey_clear(out);
    return status;
}
