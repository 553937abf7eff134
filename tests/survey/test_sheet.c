/* Spreadsheets: the figures of a sheet are those of the same table as text. Before, any archive was "no table". */
#include <zip.h>

#include "tests/survey/survey_fixture.h"

typedef struct Part {
    const char *name, *text;
} Part;

/* Packs parts, up to one without a name, and reads them; the message where they are refused, else empty. */
static const char *read_parts(const Part *part, const char *sheet, Survey *s)
{
    static hawser_error err;
    char path[] = "/tmp/hawser-sheet-XXXXXX";
    const SurveyOptions options = {.unit = NAN, .sheet = sheet};
    close(mkstemp(path));
    zip_t *const zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, NULL);
    assert_non_null(zip);
    for (; part->name; ++part) {
        zip_source_t *const source = zip_source_buffer(zip, part->text, strlen(part->text), 0);
        assert_true(zip_file_add(zip, part->name, source, 0) >= 0);
    }
    assert_int_equal(zip_close(zip), 0);
    const hawser_status status = survey_read(path, &options, s, &err);
    unlink(path);
    const char *const colon = strchr(err.message, ':');
    return status == HAWSER_OK ? "" : colon ? colon + 1 : err.message;
}

#define ROW(n, ...)                "<row r='" #n "'>" __VA_ARGS__ "</row>"
#define NUMBER(at, value)          "<c r='" at "'><v>" value "</v></c>"
#define STYLED(at, style, value)   "<c r='" at "' s='" style "'><v>" value "</v></c>"
#define SHARED(at, value)          "<c r='" at "' t='s'><v>" value "</v></c>"
#define INLINE(at, value)          "<c r='" at "' t='inlineStr'><is><r><t>" value "</t></r></is></c>"
#define SHEET(...)                 "<worksheet><sheetData>" __VA_ARGS__ "</sheetData></worksheet>"
#define RELATION(id, type, target) "<Relationship Id='" id "' Type='http://x/" type "' Target='" target "'/>"

static const char strings[] = "<sst><si><t>Length (m)</t></si><si><r><t>Radi</t></r><r><t>us</t></r></si>"
                              "<si><t>Date</t><rPh><t>hizuke</t></rPh></si><si><t>Turn</t></si></sst>",
                  styles[] = "<styleSheet><numFmts><numFmt numFmtId='164' formatCode='0.0&quot; ft&quot;'/>"
                             "<numFmt numFmtId='165' formatCode='[Red]0+000'/></numFmts><cellStyleXfs><xf "
                             "numFmtId='14'/></cellStyleXfs><cellXfs><xf numFmtId='0'/><xf numFmtId='14'/><xf "
                             "numFmtId='10'/><xf numFmtId='164'/><xf numFmtId='165'/></cellXfs></styleSheet>",
                  book[] =
                      "<workbook><sheets><sheet name='Chart' sheetId='3' r:id='r3' xmlns:r='x'/><sheet name='Route "
                      "A' sheetId='1' r:id='r1' xmlns:r='x'/><sheet name='Costs' sheetId='2' r:id='r2' "
                      "xmlns:r='x'/></sheets></workbook>",
                  relations[] = "<Relationships>" RELATION("r1", "worksheet", "worksheets/sheet1.xml")
                      RELATION("r2", "worksheet", "/xl/worksheets/sheet2.xml")
                          RELATION("r3", "chartsheet", "chartsheets/sheet1.xml")
                              RELATION("r4", "sharedStrings", "sharedStrings.xml")
                                  RELATION("r5", "styles", "styles.xml") "</Relationships>";

static const char *read_xlsx(const char *first, const char *second, const char *sheet, Survey *s)
{
    const Part parts[] = {{"xl/workbook.xml", book},
                          {"xl/_rels/workbook.xml.rels", relations},
                          {"xl/sharedStrings.xml", strings},
                          {"xl/styles.xml", styles},
                          {"xl/worksheets/sheet1.xml", first},
                          {"xl/worksheets/sheet2.xml", second},
                          {NULL, NULL}};
    return read_parts(parts, sheet, s);
}

static const double PI_ = 3.14159265358979323846;

/* A title, an empty row, shared and inline texts, a date, a per cent, a formula's kept value, and a number in feet. */
TEST(xlsx_as_excel_writes)
{
    static const char sheet[] =
        SHEET(ROW(1, INLINE("A1", "Feeder 3")) ROW(3, SHARED("A3", "0") INLINE("B3", "Angle") SHARED("C3", "1")
                                                          SHARED("D3", "3") INLINE("E3", "Slope") SHARED("F3", "2"))
                  ROW(4, "<c r='A4'><f>50*2</f><v>100</v></c>" STYLED("E4", "2", "0.05") STYLED("F4", "1", "45413"))
                      ROW(5, NUMBER("B5", "90") STYLED("C5", "3", "32.808398950131235") INLINE("D5", "left")));
    Survey s;
    assert_string_equal(read_xlsx(sheet, SHEET(ROW(1, INLINE("A1", "EUR"))), NULL, &s), "");
    assert_int_equal(s.n, 1);
    check_close(alignment_measure(&s.alignment[0]).length, 100 + 5 * PI_ * sqrt(1.0025), 1e-6);
    check_close(s.alignment[0].profile[0].grade, 0.05, 1e-9); /* 5 % by its style, 0.05 in the file */
    int costs = 0;
    for (int i = 0; i < s.n_ignored; ++i) costs += !strcmp(s.ignored[i].what, "the sheet 'Costs'");
    assert_int_equal(costs, 1);
    survey_clear(&s);
}

/* A head of two rows: one cell over both, and one over two columns. */
TEST(xlsx_merged_heads)
{
    static const char sheet[] = "<worksheet><sheetData>" ROW(1, INLINE("A1", "z (m)") INLINE("B1", "Coordinates")) ROW(
        2, INLINE("B2", "x (m)") INLINE("C2", "y (m)")) ROW(3, NUMBER("A3", "5") NUMBER("B3", "0") NUMBER("C3", "0"))
        ROW(4, NUMBER("A4", "5") NUMBER("B4", "30") NUMBER("C4", "40")) "</sheetData><mergeCells><mergeCell "
                                                                        "ref='A1:A2'/><mergeCell "
                                                                        "ref='B1:C1'/></mergeCells></worksheet>";
    Survey s;
    assert_string_equal(read_xlsx(sheet, SHEET(""), "route a", &s), "");
    const AlignmentMeasure m = alignment_measure(&s.alignment[0]);
    check_close(m.length, 50, 1e-9);
    check_close(m.end.z, 5, 1e-9);
    survey_clear(&s);
}

TEST(xlsx_refused)
{
    static const char good[] = SHEET(ROW(1, INLINE("A1", "Length (m)")) ROW(2, NUMBER("A2", "100"))),
                      no_value[] = SHEET(ROW(1, INLINE("A1", "Length (m)")) ROW(2, NUMBER("A2", "100"))
                                             ROW(7, "<c r='A7'><f>B9</f></c>"));
    Survey s;
    check_has(read_xlsx(good, good, "Feeder", &s), "no sheet 'Feeder'; there are 'Route A', 'Costs'");
    check_has(read_xlsx(good, good, "3", &s), "no sheet '3'");
    check_has(read_xlsx(no_value, good, NULL, &s), "7: a formula without its value");
    check_has(read_xlsx(SHEET(""), good, NULL, &s), "the sheet 'Route A' is empty");
    check_has(read_xlsx(SHEET(ROW(1, SHARED("A1", "9"))), good, NULL, &s), "a cell of text 9, and there are 4");
    check_has(read_xlsx("<!DOCTYPE a><a/>", good, NULL, &s), "a DOCTYPE");
    check_has(read_xlsx("<worksheet>", good, NULL, &s), "is no XML");
    const Part other[] = {{"word/document.xml", "<a/>"}, {NULL, NULL}};
    check_has(read_parts(other, NULL, &s), "no spreadsheet");
    bad("\xD0\xCF\x11\xE0 and so on", "save it as .xlsx without");
    assert_string_equal(read_xlsx(good, good, "2", &s), "");
    survey_clear(&s);
}

#define ODS(...)                                                                                                       \
    "<office:document-content xmlns:office='o' xmlns:table='t' xmlns:text='x'><office:body><office:spreadsheet>"       \
    "<table:table table:name='Lines'>" __VA_ARGS__                                                                     \
    "</table:table><table:table table:name='Notes'/></office:spreadsheet></office:body></office:document-content>"
#define ODS_ROW(...)   "<table:table-row>" __VA_ARGS__ "</table:table-row>"
#define ODS_TEXT(text) "<table:table-cell office:value-type='string'><text:p>" text "</text:p></table:table-cell>"
#define ODS_NUMBER(value, text)                                                                                        \
    "<table:table-cell office:value-type='float' office:value='" value "'><text:p>" text "</text:p></"                 \
    "table:table-cell>"

/* Cells and rows that are repeated, decimal commas and units of what is shown, notes on cells, per cent. */
TEST(ods_as_libreoffice_writes)
{
    static const char content[] = ODS(ODS_ROW("<table:table-cell table:number-columns-repeated='1024'/>") ODS_ROW(
        ODS_TEXT("Length (m)<text:span/>") ODS_TEXT("Slope") ODS_TEXT(
            "Date")) "<table:table-row table:number-rows-repeated='3'>" ODS_NUMBER("32.808398950131235",
                                                                                   "32,8 ft") "<table:table-cell "
                                                                                              "office:value-type='"
                                                                                              "percentage' "
                                                                                              "office:value='0.03'><"
                                                                                              "office:annotation><text:"
                                                                                              "p>9"
                                                                                              "</text:p></"
                                                                                              "office:annotation><text:"
                                                                                              "p>3 "
                                                                                              "%</text:p></"
                                                                                              "table:table-cell><table:"
                                                                                              "table-cell "
                                                                                              "office:value-type='date'"
                                                                                              " office:date-value='"
                                                                                              "2026-05-01'><text:p>1.5."
                                                                                              "26</text:p></"
                                                                                              "table:table-cell>"
                                                                                              "</"
                                                                                              "table:table-row><table:"
                                                                                              "table-row "
                                                                                              "table:number-rows-"
                                                                                              "repeated='1048000'><"
                                                                                              "table:table-cell/>"
                                                                                              "</table:table-row>");
    const Part parts[] = {{"content.xml", content}, {NULL, NULL}};
    Survey s;
    assert_string_equal(read_parts(parts, NULL, &s), "");
    check_close(alignment_measure(&s.alignment[0]).length, 30, 1e-9);
    check_close(s.alignment[0].profile[0].grade, 0.03, 1e-9);
    survey_clear(&s);
    check_has(read_parts(parts, "Line", &s), "there are 'Lines', 'Notes'");
    check_has(read_parts(parts, "Notes", &s), "the sheet 'Notes' is empty");
}

/* A small file that unpacks to very many cells is refused, within bounds. */
TEST(bombs_are_refused)
{
    static const char content[] = ODS("<table:table-row table:number-rows-repeated='9999999'>" ODS_NUMBER("1", "1")
                                          ODS_NUMBER("2", "2") "</table:table-row>");
    const Part parts[] = {{"content.xml", content}, {NULL, NULL}};
    Survey s;
    check_has(read_parts(parts, NULL, &s), "a sheet of more than");
}

/* A KMZ as Google Earth writes it: doc.kml beside its pictures; of further KML it is said that it is not read. */
TEST(kmz)
{
    static const char map[] = "<kml><Placemark><name>feeder</name><LineString><coordinates>10,60,0 10,60.001,0"
                              "</coordinates></LineString></Placemark></kml>";
    const Part parts[] = {{"files/more.kml", "<kml/>"}, {"doc.kml", map}, {"files/icon.png", "x"}, {NULL, NULL}};
    const Part empty[] = {{"doc.kml", ""}, {NULL, NULL}}, broken[] = {{"doc.kml", "<kml>\n<Placemark>"}, {NULL, NULL}};
    Survey s;
    assert_string_equal(read_parts(parts, NULL, &s), "");
    assert_int_equal(s.n, 1);
    assert_string_equal(s.alignment[0].name, "feeder");
    check_close(alignment_measure(&s.alignment[0]).length, 111.4, 0.1);
    assert_int_equal(s.n_ignored, 1);
    survey_clear(&s);
    check_has(read_parts(parts, "Route A", &s), "which a KMZ is not");
    check_has(read_parts(empty, NULL, &s), "cannot be unpacked");
    check_has(read_parts(broken, NULL, &s), "2: no XML");
}
