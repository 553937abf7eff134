/* Translates a text by the row whose pattern it fits: the parts that printf has inserted are separated again, and
 * translated in turn. Theory, limits and codes therefore write English alone. */
#include "io/results/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "io/results/column.h"

const char *const language_tags[LANGUAGES] = {"en", "zh", "de"};

enum { PARTS = 10, DEPTH_MOST = 7, TRIES_MOST = 20000 };

/* Text in place of a mark of a pattern. */
typedef struct Part {
    const char *at;
    size_t n;
    int raw;
} Part;

/* A text that is being fitted to a row. */
typedef struct Fit {
    Language language;
    const WordsRow *row;
    Part part[PARTS];
    char *out;  /* [WORDS_MAX] */
    int depth;  /* depth of texts within texts */
    int *tries; /* remaining tries, of all of them together */
} Fit;

static int put(Language language, const char *text, size_t n, char *out, int depth, int *tries);

static int is_mark(const char *p)
{
    return (*p == '{' || *p == '[' || *p == '<') && isdigit((unsigned char)p[1]) && strchr("}]>", p[2]);
}

/* Units that are not in capitals alone. */
static const char units[] =
    " kN kN/m N/m m mm m/s m/min km kg kg/m kg/m3 mm2 N/mm2 lbf lbf/ft lbf/cmil ft in psi kip lb "
    "lb/ft lb/ft3 lbf/in kcmil ksi ft/min min h deg s D/d d pi2 l2 l w/r % <= >= = - +- ";

/* Checks whether a word needs no translation: a number, a unit, a key of a case, a code. */
static int is_plain_word(const char *word, size_t n)
{
    char framed[80];
    while (n > 0 && strchr("(),;:", word[n - 1])) --n;
    while (n > 0 && *word == '(') ++word, --n;
    if (n == 0 || n > sizeof framed - 3) return n == 0;
    snprintf(framed, sizeof framed, " %.*s ", (int)n, word);
    if (strstr(units, framed)) return 1;
    int capitals = 1;
    for (size_t i = 0; i < n; ++i) {
        if (isdigit((unsigned char)word[i]) || word[i] == '_') return 1;
        if (word[i] == '.' && i + 1 < n && isalpha((unsigned char)word[i + 1])) return 1;
        capitals &= isupper((unsigned char)word[i]) || word[i] == '-' || word[i] == '/';
    }
    return capitals;
}

/* Checks for a name between its marks, or plain words. */
static int is_plain(const char *text, size_t n)
{
    if (n >= 2 && text[0] == NAME_BEGINS && memchr(text, NAME_ENDS, n) == text + n - 1) return 1;
    for (size_t from = 0; from < n;) {
        size_t size = 0;
        while (from + size < n && text[from + size] != ' ') ++size;
        if (!is_plain_word(text + from, size)) return 0;
        from += size + 1;
    }
    return 1;
}

/* Writes the row's text with its parts translated; 0: one of them has no translation. */
static int render(Fit *f)
{
    char word[WORDS_MAX];
    size_t n = 0;
    for (const char *p = f->row->text[f->language]; *p;) {
        const char *from = p;
        size_t size = 1;
        if (is_mark(p)) {
            const Part *const part = &f->part[p[1] - '0'];
            from = part->at;
            size = part->n;
            if (!part->raw) {
                if (!put(f->language, part->at, part->n, word, f->depth + 1, f->tries)) return 0;
                from = word;
                size = strlen(word);
            }
            p += 3;
        } else {
            ++p;
        }
        if (n + size >= WORDS_MAX) return 0;
        memcpy(f->out + n, from, size);
        n += size;
    }
    f->out[n] = 0;
    return 1;
}

/* Fits the rest of a pattern to the rest of a text [n]; a mark takes as little as possible. */
static int follow(Fit *f, const char *pattern, const char *text, size_t n)
{
    for (; *pattern && !is_mark(pattern); ++pattern, ++text, --n)
        if (n == 0 || *pattern != *text) return 0;
    if (!*pattern) return n == 0 && render(f);
    Part *const part = &f->part[pattern[1] - '0'];
    const char *const next = pattern + 3;
    for (size_t size = *next ? 1 : n; size > 0 && size <= n; ++size) {
        if (*next && (size == n || text[size] != *next)) continue;
        if (--*f->tries < 0) return 0;
        *part = (Part){text, size, *pattern == '['};
        if (*pattern == '<' && !is_plain(text, size)) continue;
        if (follow(f, next, text + size, n - size)) return 1;
    }
    return 0;
}

/* Checks quickly whether the text between a pattern's marks is in a text [n] at all, in its order: for most rows it is
 * not. */
static int may_fit(const char *pattern, const char *text, size_t n)
{
    if (!is_mark(pattern) && *pattern != *text) return 0;
    while (*pattern) {
        size_t size = 0, from = 0;
        while (pattern[size] && !is_mark(pattern + size)) ++size;
        while (from + size <= n && memcmp(text + from, pattern, size) != 0) ++from;
        if (from + size > n) return 0;
        text += from + size;
        n -= from + size;
        pattern += size + (pattern[size] ? 3 : 0);
    }
    return 1;
}

static int put(Language language, const char *text, size_t n, char *out, int depth, int *tries)
{
    if (n >= WORDS_MAX || depth > DEPTH_MOST) return 0;
    for (int k = 0; k < words_rows_n; ++k) {
        const char *const english = words_rows[k].text[LANGUAGE_ENGLISH];
        if (strncmp(english, text, n) != 0 || english[n]) continue;
        strcpy(out, words_rows[k].text[language]);
        return 1;
    }
    if (is_plain(text, n)) {
        snprintf(out, WORDS_MAX, "%.*s", (int)n, text);
        return 1;
    }
    for (int k = 0; k < words_rows_n; ++k) {
        const char *const english = words_rows[k].text[LANGUAGE_ENGLISH];
        Fit f = {.language = language, .row = &words_rows[k], .out = out, .depth = depth, .tries = tries};
        if (strpbrk(english, "{[<") && may_fit(english, text, n) && follow(&f, english, text, n)) return 1;
    }
    return 0;
}

const char *words_in(Language language, const char *english, char *text)
{
    int tries = TRIES_MOST;
    if (language == LANGUAGE_ENGLISH || !*english) return english;
    return put(language, english, strlen(english), text, 0, &tries) ? text : english;
}

/* All texts of a calculation's page, in the order in which they are tried: io/results/words.h. A row with a sentence is
 * before the rows of its words. */

/* clang-format off */
const WordsRow words_rows[] = {
    /* Headings and labels of the page */
    {{"Pulling calculation", "电缆牵引计算书", "Zugkraftberechnung"}},
    {{"Client", "委托单位", "Auftraggeber"}},
    {{"Project", "工程名称", "Projekt"}},
    {{"Drawing", "图号", "Zeichnung"}},
    {{"Author", "计算", "Bearbeiter"}},
    {{"Checked by", "校核", "Geprüft von"}},
    {{"Revision", "版次", "Revision"}},
    {{"Date", "日期", "Datum"}},
    {{"Case", "计算文件", "Rechenfall"}},
    {{"Calculated by", "计算软件", "Berechnet mit"}},
    {{"Plan, to scale", "平面图（按比例）", "Lageplan, maßstäblich"}},
    {{"Profile", "纵断面图", "Längsschnitt"}},
    {{"start", "起点", "Anfang"}},
    {{"end", "终点", "Ende"}},
    {{"N", "北", "N"}},
    {{"along the route", "沿线路里程", "entlang der Trasse"}},
    {{"height", "高程", "Höhe"}},
    {{"tension", "拉力", "Zugkraft"}},
    {{"pulled forward", "正向牵引", "vorwärts gezogen"}},
    {{"pulled back", "反向牵引", "rückwärts gezogen"}},
    {{"allowed", "允许值", "zulässig"}},
    {{"Tension of the cable at speed, the route full of cable", "匀速牵引时的电缆拉力（全线敷满电缆）", "Zugkraft im Kabel bei Fahrt, Trasse voll belegt"}},
    {{"Sidewall pressure T/R at speed", "匀速牵引时的侧压力 T/R", "Seitendruck T/R bei Fahrt"}},
    {{"Ducts", "管道", "Rohre"}},
    {{"cross-section", "横断面", "Querschnitt"}},
    {{"inside {1}, {2} × {3}, fill {4} %, clearance {5}, beside {6} × {7}", "内径 {1}，{2} × {3}，占积率 {4} %，净空 {5}，旁有 {6} × {7}", "innen {1}, {2} × {3}, Füllgrad {4} %, Freiraum {5}, neben {6} × {7}"}},
    {{"inside {1}, {2} × {3}, fill {4} %, clearance {5}", "内径 {1}，{2} × {3}，占积率 {4} %，净空 {5}", "innen {1}, {2} × {3}, Füllgrad {4} %, Freiraum {5}"}},
    {{"inside {1}, {2} × {3}, fill {4} %, clearance {5}, jam ratio {6}", "内径 {1}，{2} × {3}，占积率 {4} %，净空 {5}，卡阻比 {6}", "innen {1}, {2} × {3}, Füllgrad {4} %, Freiraum {5}, Klemmverhältnis {6}"}},
    {{"and {1} more", "另有 {1} 处", "und {1} weitere"}},
    {{"All values", "全部数值", "Alle Werte"}},
    {{"To be followed by hand", "手算校核", "Zum Nachrechnen von Hand"}},
    {{"Pulled forward at speed, of all cables together; the weight of a bundle is in w, its weight correction in μ.", "正向匀速牵引，全部电缆合计；w 为成束电缆的总重量，μ 已计入重量校正系数。", "Vorwärts bei Fahrt, alle Kabel zusammen; w enthält das Gewicht des ganzen Bündels, μ dessen Gewichtskorrektur."}},
    {{"from {1} m on", "自 {1} m 起", "ab {1} m"}},
    {{"the table of pieces has {1} N", "分段表中为 {1} N", "in der Tabelle der Abschnitte steht {1} N"}},
    {{"of all cables together", "全部电缆合计", "aller Kabel zusammen"}},
    {{"weight and turning force on supports of their own", "重量与转向力由不同支承分别承受", "Gewicht und Umlenkkraft auf getrennten Auflagern"}},
    {{"over the crest", "凸起弯段", "über die Kuppe"}},
    {{"in the sag, on the inner side", "下凹弯段，贴内侧", "in der Wanne, an der Innenseite"}},
    {{"in the sag, on the bottom", "下凹弯段，贴底面", "in der Wanne, am Boden"}},
    {{"What comes out of a piece goes into the next one, unless a machine takes off or a pit begins anew between them.", "各段的出口拉力即为下一段的入口拉力，除非两段之间有机械输送或在工作井处重新起牵。", "Die Kraft am Ende eines Abschnitts ist die am Anfang des nächsten, außer wo eine Maschine abnimmt oder an einer Grube neu begonnen wird."}},
    {{"Total: {1} N at the start, {2} N out of the last piece, {3} N of drag on the rope: {4} N at the winch", "合计：起点 {1} N，末段出口 {2} N，牵引绳阻力 {3} N，卷扬机处 {4} N", "Summe: {1} N am Anfang, {2} N am Ende des letzten Abschnitts, {3} N Seilreibung: {4} N an der Winde"}},
    /* Tables */
    {{"The route piece by piece, full of cable (friction with the weight correction of ducts)", "线路分段计算（全线敷满电缆，摩擦系数已计入管内重量校正）", "Die Trasse Abschnitt für Abschnitt, voll belegt (Reibungszahl mit Gewichtskorrektur der Rohre)"}},
    {{"The route piece by piece, full of cable, pulled forward and back", "线路分段计算（全线敷满电缆，正向与反向牵引）", "Die Trasse Abschnitt für Abschnitt, voll belegt, vorwärts und rückwärts gezogen"}},
    {{"piece", "区段", "Abschnitt"}},
    {{"from", "起", "von"}},
    {{"to", "止", "bis"}},
    {{"angle", "转角", "Winkel"}},
    {{"turns", "转向", "Richtung"}},
    {{"slope", "坡度", "Neigung"}},
    {{"friction", "摩擦系数", "Reibungszahl"}},
    {{"at rest", "静止", "Haftung"}},
    {{"forward: in", "正向：入口", "vorwärts: ein"}},
    {{"back: in", "反向：入口", "rückwärts: ein"}},
    {{"out", "出口", "aus"}},
    {{"out from rest", "起动时出口", "aus, beim Anfahren"}},
    {{"left", "左", "links"}},
    {{"right", "右", "rechts"}},
    {{"up", "上", "aufwärts"}},
    {{"down", "下", "abwärts"}},
    {{"left, up", "左上", "links aufwärts"}},
    {{"left, down", "左下", "links abwärts"}},
    {{"right, up", "右上", "rechts aufwärts"}},
    {{"right, down", "右下", "rechts abwärts"}},
    {{"length", "长度", "Länge"}},
    {{"friction on", "摩擦计算", "Reibung auf"}},
    {{"forward: end", "正向：末端", "vorwärts: Ende"}},
    {{"back: end", "反向：末端", "rückwärts: Ende"}},
    {{"sidewall", "侧压力", "Seitendruck"}},
    {{"roller", "滚轮", "Rolle"}},
    {{"margin", "裕度", "Reserve"}},
    {{"closed form", "解析式", "geschlossene Formel"}},
    {{"resultant", "合力", "Resultierende"}},
    {{"separate", "分别", "getrennt"}},
    {{"both", "两种", "beides"}},
    {{"Both directions", "两个方向", "Beide Richtungen"}},
    {{"direction", "方向", "Richtung"}},
    {{"forward", "正向", "vorwärts"}},
    {{"backward", "反向", "rückwärts"}},
    {{"rope", "牵引绳", "Seil"}},
    {{"at end", "末端", "am Ende"}},
    {{"restart", "再起动", "Anfahren"}},
    {{"largest", "最大值", "größte"}},
    {{"with the head at", "端头位置", "Kabelspitze bei"}},
    {{"trip at", "停机整定值", "Abschaltung bei"}},
    {{"by", "取决于", "durch"}},
    {{"largest tension", "最大拉力", "größte Zugkraft"}},
    {{"at", "位置", "bei"}},
    {{"least", "最小值", "kleinste"}},
    {{"largest sidewall", "最大侧压力", "größter Seitendruck"}},
    {{"because", "原因", "weil"}},
    {{"Pieces without a valid closed form: the integrated law alone applies", "解析式不适用：仅采用积分结果", "Geschlossene Formeln gelten nicht: nur die Integration zählt"}},
    {{"duct", "管道", "Rohr"}},
    {{"cables", "电缆数", "Kabel"}},
    {{"lie as", "排列形式", "Lage"}},
    {{"weight factor", "重量系数", "Gewichtsfaktor"}},
    {{"sidewall factor", "侧压力系数", "Seitendruckfaktor"}},
    {{"jam ratio", "卡阻比", "Klemmverhältnis"}},
    {{"risk of jamming", "卡阻风险", "Klemmgefahr"}},
    {{"clearance", "净空", "Freiraum"}},
    {{"fill", "占积率", "Füllgrad"}},
    {{"layer", "图层", "Layer"}},
    {{"clearance, m", "净距，m", "Abstand, m"}},
    {{"Clearance from the environment", "与环境的净距", "Abstand zur Umgebung"}},
    {{"single cable", "单根", "Einzelkabel"}},
    {{"pair", "双根并列", "Paar"}},
    {{"triangle", "三角形", "Dreieck"}},
    {{"cradle", "摇篮形", "Mulde"}},
    {{"diamond", "菱形", "Raute"}},
    {{"beside lying", "旁有已敷电缆", "neben liegenden"}},
    {{"none", "无", "keine"}},
    {{"very small", "很小", "sehr gering"}},
    {{"small", "小", "gering"}},
    {{"moderate", "中等", "mäßig"}},
    {{"significant", "显著", "erheblich"}},
    {{"Pushes", "推力", "Schübe"}},
    {{"pushed by", "推送设备", "geschoben durch"}},
    {{"pushes forward", "正向推力", "schiebt vorwärts"}},
    {{"back", "反向", "rückwärts"}},
    {{"Where the cable is pushed", "电缆受推区段", "Wo das Kabel geschoben wird"}},
    {{"pushed from", "受推起点", "geschoben von"}},
    {{"push", "推力", "Schub"}},
    {{"kept straight by", "约束方式", "gerade gehalten durch"}},
    {{"up to", "至", "bis zu"}},
    {{"coils from", "螺旋屈曲起始", "Wendel ab"}},
    {{"half wave", "半波长", "Halbwelle"}},
    {{"no push goes farther than", "推力传递极限长度", "kein Schub reicht weiter als"}},
    {{"carriers", "支承", "Auflager"}},
    {{"Limits", "限值校核", "Grenzwerte"}},
    {{"limit", "限值项目", "Grenzwert"}},
    {{"found", "计算值", "ermittelt"}},
    {{"unit", "单位", "Einheit"}},
    {{"where", "位置", "wo"}},
    {{"holds", "满足", "eingehalten"}},
    {{"at worst", "最不利值", "ungünstigst"}},
    {{"friction to", "摩擦系数上限", "Reibungszahl bis"}},
    {{"at rest to", "静摩擦系数上限", "Haftreibungszahl bis"}},
    {{"back tension to", "后端张力上限", "Rückhaltekraft bis"}},
    {{"slopes from", "变坡半径下限", "Neigungswechsel ab"}},
    {{"allowed by", "依据", "zulässig nach"}},
    {{"yes", "是", "ja"}},
    {{"NO", "否", "NEIN"}},
    {{"not judged", "未判定", "nicht beurteilt"}},
    {{"Whether it is worth judging", "计算适用条件", "Ob das Ergebnis belastbar ist"}},
    {{"condition", "条件", "Bedingung"}},
    {{"what is wrong", "存在问题", "was nicht stimmt"}},
    {{"Sections, each pulled on its own", "各牵引区段", "Teilstrecken, jede für sich gezogen"}},
    {{"winch at", "卷扬机位置", "Winde bei"}},
    {{"winch", "卷扬机", "Winde"}},
    {{"Brake against running away", "防自行下滑的制动力", "Bremse gegen Selbstlauf"}},
    {{"brake at the start", "起点制动力", "Bremse am Anfang"}},
    {{"pushed most at", "最大受推位置", "größter Schub bei"}},
    {{"which is", "说明", "das ist"}},
    {{"winch then", "此时卷扬机拉力", "Winde dann"}},
    {{"braked from the start", "自起点制动", "von Anfang an gebremst"}},
    {{"question", "问题", "Frage"}},
    {{"now", "当前值", "jetzt"}},
    {{"answer", "结果", "Antwort"}},
    {{"then binds", "控制项目", "dann maßgebend"}},
    {{"What would still keep all limits", "满足全部限值的极限参数", "Was alle Grenzwerte gerade noch einhält"}},
    {{"none: it would not help", "无：无效", "keiner: hilft nicht"}},
    {{"none: they would not help", "无：无效", "keine: helfen nicht"}},
    {{"the sheet '[1]'", "工作表“{1}”", "Tabellenblatt „{1}“"}},
    {{"any: nothing binds within {1} times", "任意：{1} 倍以内均不受控", "beliebig: bis zum {1}-fachen maßgebend nichts"}},
    {{"any: nothing binds within {1} times, at least {2}", "任意：{1} 倍以内均不受控，至少 {2}", "beliebig: bis zum {1}-fachen maßgebend nichts, mindestens {2}"}},
    {{"{1} times the case's", "当前值的 {1} 倍", "{1}-mal der Wert des Falls"}},
    {{"{1} times the case's, at least {2}", "当前值的 {1} 倍，至少 {2}", "{1}-mal der Wert des Falls, mindestens {2}"}},
    {{"{1} stay", "{1} 仍不满足", "{1} bleiben verletzt"}},
    {{"{1} stays", "{1} 仍不满足", "{1} bleibt verletzt"}},
    {{"largest friction coefficient", "最大摩擦系数", "größte Reibungszahl"}},
    {{"smallest bend radius", "最小弯曲半径", "kleinster Bogenradius"}},
    {{"smallest radius of the critical bend", "控制弯段最小半径", "kleinster Radius des maßgebenden Bogens"}},
    {{"smallest radius of the critical bend: '[1]'", "控制弯段“{1}”的最小半径", "kleinster Radius des maßgebenden Bogens „{1}“"}},
    {{"longest length", "最大长度", "größte Länge"}},
    {{"least number of more machines of {1}", "需增设的 {1} 输送机最少台数", "kleinste Zahl weiterer Maschinen mit {1}"}},
    {{"all holds without", "无需增设即满足", "ohne sie ist alles eingehalten"}},
    {{"with one fewer it breaks", "少一台即不满足", "mit einer weniger verletzt"}},
    {{"Places of these machines", "增设机械的位置", "Wo so viele Maschinen stehen"}},
    {{"machine at", "机械位置", "Maschine bei"}},
    {{"takes off", "减小拉力", "nimmt ab"}},
    {{"Not given, and assumed", "未给定而采用的假定值", "Nicht angegeben und angenommen"}},
    {{"assumed", "假定", "angenommen"}},
    {{"taken", "采用值", "gewählt"}},
    {{"usually from", "通常自", "üblich von"}},
    {{"give", "应给定", "anzugeben"}},
    {{"range of", "取值依据", "Bereich nach"}},
    {{"What would do, computed again with all limits", "可行的改进措施（已重新校核全部限值）", "Was genügen würde, mit allen Grenzwerten nachgerechnet"}},
    {{"remedy", "措施", "Abhilfe"}},
    {{"of", "对象", "von"}},
    {{"key", "参数键", "Schlüssel"}},
    {{"needed", "需要值", "nötig"}},
    {{"all limits hold", "满足全部限值", "alle Grenzwerte eingehalten"}},
    {{"then", "结论", "dann"}},
    {{"still broken", "仍不满足", "noch verletzt"}},
    {{"duct radius", "管道半径", "Rohrradius"}},
    {{"radius", "弯曲半径", "Radius"}},
    {{"Notes", "备注", "Hinweise"}},
    {{"note", "备注", "Hinweis"}},
    {{"place", "位置", "Stelle"}},
    {{"paper", "论文", "Aufsatz"}},
    {{"reference", "基准", "Referenz"}},
    {{"support", "支承力", "Auflagerkraft"}},
    {{"Tension along the route, full of cable, pulled forward", "沿线拉力（全线敷满电缆，正向牵引）", "Zugkraft entlang der Trasse, voll belegt, vorwärts gezogen"}},
    {{"Winch by the place of the cable's head", "卷扬机拉力与电缆端头位置的关系", "Windenkraft nach Lage der Kabelspitze"}},
    {{"head at", "端头位置", "Spitze bei"}},
    {{"tension there", "该处拉力", "Zugkraft dort"}},
    {{"term", "分项", "Anteil"}},
    {{"Piece formulas (eq. {1}), term by term", "分段公式（式 {1}）逐项结果", "Formeln der Abschnitte (Gl. {1}), Anteil für Anteil"}},
    {{"What a run of this case is compared with", "仿真对比基准", "Womit ein Lauf dieses Falls verglichen wird"}},
    {{"counted from", "统计起点", "gezählt ab"}},
    {{"winch, paper", "卷扬机（论文公式）", "Winde, Aufsatz"}},
    {{"winch, reference", "卷扬机（基准）", "Winde, Referenz"}},
    {{"winch, trip", "卷扬机停机值", "Winde, Abschaltung"}},
    {{"start of ", "起点", "Anfang"}},
    {{"end of ", "终点", "Ende"}},
    {{"start of [1]", "{1} 起点", "Anfang von {1}"}},
    {{"end of [1]", "{1} 终点", "Ende von {1}"}},
    /* Facts */
    {{"weight of the cable", "电缆单位长度重量", "Gewicht des Kabels"}},
    {{"friction coefficient", "摩擦系数", "Reibungszahl"}},
    {{"friction coefficient, largest", "摩擦系数（最大）", "Reibungszahl, größte"}},
    {{"length of the route", "线路长度", "Länge der Trasse"}},
    {{"tension at the start", "起点张力", "Zugkraft am Anfang"}},
    {{"drag on the rope", "牵引绳阻力", "Reibung am Seil"}},
    {{"winch force, piece formulas", "卷扬机拉力（分段公式）", "Windenkraft nach Abschnittsformeln"}},
    {{"winch force at end, forward", "终点卷扬机拉力（正向）", "Windenkraft am Ende, vorwärts"}},
    {{"winch force at end, backward", "终点卷扬机拉力（反向）", "Windenkraft am Ende, rückwärts"}},
    {{"largest winch force, forward", "最大卷扬机拉力（正向）", "größte Windenkraft, vorwärts"}},
    {{"largest winch force, backward", "最大卷扬机拉力（反向）", "größte Windenkraft, rückwärts"}},
    {{"largest from rest, forward", "起动最大拉力（正向）", "größte beim Anfahren, vorwärts"}},
    {{"largest from rest, backward", "起动最大拉力（反向）", "größte beim Anfahren, rückwärts"}},
    {{"largest sidewall pressure", "最大侧压力", "größter Seitendruck"}},
    {{"bending stiffness, left out", "未计入的弯曲刚度影响", "Biegesteifigkeit, nicht enthalten"}},
    {{"cables pulled together", "同时牵引电缆数", "gemeinsam gezogene Kabel"}},
    {{"less force when pulled", "拉力较小的方向", "weniger Kraft, wenn gezogen"}},
    {{"better by its limits", "按限值较优的方向", "nach Grenzwerten besser"}},
    {{"equal", "相同", "gleich"}},
    /* Limits and conditions by name */
    {{"pull", "牵引力", "Zugkraft"}},
    {{"attachment", "牵引头（网套）受力", "Zugbefestigung"}},
    {{"contact_pressure", "接触压力", "Flächenpressung"}},
    {{"bend_radius", "弯曲半径", "Biegeradius"}},
    {{"rope_bend", "牵引绳弯曲", "Seilbiegung"}},
    {{"roller_steady", "滚轮稳态载荷", "Rollenlast, stetig"}},
    {{"roller_peak", "滚轮峰值载荷", "Rollenlast, Spitze"}},
    {{"buckling", "屈曲", "Knicken"}},
    {{"squeeze", "夹紧压力", "Klemmdruck"}},
    {{"run_away", "自行下滑", "Selbstlauf"}},
    {{"alpha", "过载系数", "Überlastfaktor"}},
    {{"trip", "停机整定值", "Abschaltkraft"}},
    {{"speed", "速度", "Geschwindigkeit"}},
    {{"jam_ratio", "卡阻比", "Klemmverhältnis"}},
    {{"clearance_environment", "与环境净距", "Abstand zur Umgebung"}},
    {{"weight_correction", "重量校正系数", "Gewichtskorrektur"}},
    {{"supported", "支承", "Auflage"}},
    {{"medium", "介质", "Medium"}},
    {{"drive", "驱动", "Antrieb"}},
    {{"pulled", "受拉", "auf Zug"}},
    {{"stiffness", "弯曲刚度", "Biegesteifigkeit"}},
    {{"overlap", "交叉", "Überschneidung"}},
    /* Verdicts */
    {{"SAFE", "安全", "SICHER"}},
    {{"NOT SAFE", "不安全", "NICHT SICHER"}},
    {{"NOT JUDGED", "未判定", "NICHT BEURTEILT"}},
    {{"NOT TRUSTED", "结果不可信", "NICHT BELASTBAR"}},
    {{"SAFE ONLY IF", "有条件安全", "NUR SICHER, WENN"}},
    {{"safe", "安全", "sicher"}},
    {{"safe_if", "有条件安全", "bedingt sicher"}},
    {{"not_safe", "不安全", "nicht sicher"}},
    {{"not_judged", "未判定", "nicht beurteilt"}},
    {{"not_trusted", "结果不可信", "nicht belastbar"}},
    {{"SAFE: {1}", "安全：{1}", "SICHER: {1}"}},
    {{"SAFE ONLY IF {1}: {2}", "仅当 {1} 时安全：{2}", "NUR SICHER, WENN {1}: {2}"}},
    {{"SAFE ONLY IF {1}", "仅当 {1} 时安全", "NUR SICHER, WENN {1}"}},
    {{"NOT SAFE: {1}", "不安全：{1}", "NICHT SICHER: {1}"}},
    {{"NOT JUDGED: {1}; the {2} limits that could be judged hold; {3}", "未判定：{1}；能够判定的 {2} 项限值均满足；{3}", "NICHT BEURTEILT: {1}; die {2} beurteilbaren Grenzwerte sind eingehalten; {3}"}},
    {{"NOT JUDGED: {1}; the {2} limits that could be judged hold", "未判定：{1}；能够判定的 {2} 项限值均满足", "NICHT BEURTEILT: {1}; die {2} beurteilbaren Grenzwerte sind eingehalten"}},
    {{"NOT JUDGED: {1}; the {2} limit that could be judged holds; {3}", "未判定：{1}；能够判定的 {2} 项限值满足；{3}", "NICHT BEURTEILT: {1}; der {2} beurteilbare Grenzwert ist eingehalten; {3}"}},
    {{"NOT JUDGED: {1}; the {2} limit that could be judged holds", "未判定：{1}；能够判定的 {2} 项限值满足", "NICHT BEURTEILT: {1}; der {2} beurteilbare Grenzwert ist eingehalten"}},
    {{"NOT JUDGED: {1}: {2}", "未判定：{1}：{2}", "NICHT BEURTEILT: {1}: {2}"}},
    {{"NOT JUDGED: {1}", "未判定：{1}", "NICHT BEURTEILT: {1}"}},
    {{"NOT TRUSTED: {1}; and {2} more reason; besides, {3} of the limits would be broken", "结果不可信：{1}；另有 {2} 个原因；此外有 {3} 项限值不满足", "NICHT BELASTBAR: {1}; und {2} weiterer Grund; außerdem wären {3} der Grenzwerte verletzt"}},
    {{"NOT TRUSTED: {1}; and {2} more reasons; besides, {3} of the limits would be broken", "结果不可信：{1}；另有 {2} 个原因；此外有 {3} 项限值不满足", "NICHT BELASTBAR: {1}; und {2} weitere Gründe; außerdem wären {3} der Grenzwerte verletzt"}},
    {{"NOT TRUSTED: {1}; and {2} more reason", "结果不可信：{1}；另有 {2} 个原因", "NICHT BELASTBAR: {1}; und {2} weiterer Grund"}},
    {{"NOT TRUSTED: {1}; and {2} more reasons", "结果不可信：{1}；另有 {2} 个原因", "NICHT BELASTBAR: {1}; und {2} weitere Gründe"}},
    {{"NOT TRUSTED: {1}; besides, {2} of the limits would be broken", "结果不可信：{1}；此外有 {2} 项限值不满足", "NICHT BELASTBAR: {1}; außerdem wären {2} der Grenzwerte verletzt"}},
    {{"NOT TRUSTED: {1}", "结果不可信：{1}", "NICHT BELASTBAR: {1}"}},
    {{"the case has no section 'limits'", "计算文件中没有 limits 部分", "der Fall hat keinen Abschnitt limits"}},
    {{"no limit could be judged", "没有可判定的限值", "kein Grenzwert war beurteilbar"}},
    {{"{1} of {2} limits broken: {3}; {4} not judged: {5}", "{2} 项限值中 {1} 项不满足：{3}；{4} 项未判定：{5}", "{1} von {2} Grenzwerten verletzt: {3}; {4} nicht beurteilt: {5}"}},
    {{"{1} of {2} limits broken: {3}", "{2} 项限值中 {1} 项不满足：{3}", "{1} von {2} Grenzwerten verletzt: {3}"}},
    {{"{1} of {2} limits broken", "{2} 项限值中 {1} 项不满足", "{1} von {2} Grenzwerten verletzt"}},
    {{"all {1} limits hold, smallest margin {2} % ({3})", "全部 {1} 项限值均满足，最小裕度 {2} %（{3}）", "alle {1} Grenzwerte eingehalten, kleinste Reserve {2} % ({3})"}},
    {{"all {1} limits hold with what is assumed, smallest margin {2} % ({3})", "在假定条件下全部 {1} 项限值均满足，最小裕度 {2} %（{3}）", "mit den Annahmen alle {1} Grenzwerte eingehalten, kleinste Reserve {2} % ({3})"}},
    {{"{1} not judged: {2}", "{1} 项未判定：{2}", "{1} nicht beurteilt: {2}"}},
    {{"friction <= {1} ({2})", "摩擦系数 ≤ {1}（{2}）", "Reibungszahl ≤ {1} ({2})"}},
    {{"friction >= {1} ({2})", "摩擦系数 ≥ {1}（{2}）", "Reibungszahl ≥ {1} ({2})"}},
    {{"friction at rest <= {1} ({2})", "静摩擦系数 ≤ {1}（{2}）", "Haftreibungszahl ≤ {1} ({2})"}},
    {{"back tension <= {1} ({2})", "后端张力 ≤ {1}（{2}）", "Rückhaltekraft ≤ {1} ({2})"}},
    {{"radius at changes of slope >= {1} ({2})", "变坡处半径 ≥ {1}（{2}）", "Radius an Neigungswechseln ≥ {1} ({2})"}},
    /* The answer's lines */
    {{"unusual", "异常值", "ungewöhnlich"}},
    {{"worst", "最不利", "maßgebend"}},
    {{"broken", "不满足", "verletzt"}},
    {{"all at once", "同时取上限", "alles zugleich"}},
    {{"friction at rest", "静摩擦系数", "Haftreibungszahl"}},
    {{"back tension", "后端张力", "Rückhaltekraft"}},
    {{"radius at changes of slope", "变坡处半径", "Radius an Neigungswechseln"}},
    {{"{1} <2>: not given ({3})", "{1} {2}：未给定（{3}）", "{1} {2}: nicht angegeben ({3})"}},
    {{"{1} <2>, usually <3> to <4> ({5})", "{1} {2}，通常 {3} 至 {4}（{5}）", "{1} {2}, üblich {3} bis {4} ({5})"}},
    {{"{1} and {2} more", "{1} 等另 {2} 项", "{1} und {2} weitere"}},
    {{"{1} of {2}: {3}, usually {4} to {5}: is the unit right?", "{2} 的{1}：{3}，通常 {4} 至 {5}：单位是否正确？", "{1} von {2}: {3}, üblich {4} bis {5}: stimmt die Einheit?"}},
    {{"diameter", "直径", "Durchmesser"}},
    {{"mass over cross-section", "质量与截面之比", "Masse je Querschnitt"}},
    {{"radius of a bend", "弯段半径", "Radius eines Bogens"}},
    {{"speed of the winch", "卷扬机速度", "Geschwindigkeit der Winde"}},
    {{"inside diameter over the cable's", "管内径与电缆外径之比", "Innendurchmesser zu Kabeldurchmesser"}},
    {{"width less 30 mm over the cable's diameter", "宽度减 30 mm 与电缆外径之比", "Breite weniger 30 mm zu Kabeldurchmesser"}},
    {{"conductors over the cable's cross-section", "导体截面与电缆截面之比", "Leiter- zu Kabelquerschnitt"}},
    {{"a rope as far as the winch, without which nothing runs: {1}", "牵引绳延伸至卷扬机（否则无法牵引）：{1}", "ein Seil bis zur Winde, ohne das nichts läuft: {1}"}},
    {{"{1} at the winch, {2} from rest", "卷扬机处 {1}，起动时 {2}", "{1} an der Winde, {2} beim Anfahren"}},
    {{"{1} at the winch ({3}), {2} from rest", "卷扬机处 {1}（{3}），起动时 {2}", "{1} an der Winde ({3}), {2} beim Anfahren"}},
    {{"{1} at the winch, {2} from rest ({3})", "卷扬机处 {1}，起动时 {2}（{3}）", "{1} an der Winde, {2} beim Anfahren ({3})"}},
    {{"{1} at the winch ({3}), {2} from rest ({4})", "卷扬机处 {1}（{3}），起动时 {2}（{4}）", "{1} an der Winde ({3}), {2} beim Anfahren ({4})"}},
    {{"{1} at the winch with the brake that is missing, {2}", "加上所缺制动力 {2} 后，卷扬机处 {1}", "{1} an der Winde mit der fehlenden Bremse, {2}"}},
    {{"the head at {1}", "端头位于 {1}", "Kabelspitze bei {1}"}},
    {{"the end, the head at {1}", "终点，端头位于 {1}", "Ende, Kabelspitze bei {1}"}},
    {{"[1], the head at {2}", "{1}，端头位于 {2}", "{1}, Kabelspitze bei {2}"}},
    {{"allowed {1}: {2} % left", "允许 {1}：余 {2} %", "zulässig {1}: {2} % frei"}},
    {{"allowed {1}: {2} % over", "允许 {1}：超出 {2} %", "zulässig {1}: {2} % darüber"}},
    {{"allowed {1}: {2} % short", "允许 {1}：不足 {2} %", "zulässig {1}: {2} % zu wenig"}},
    {{"allowed {1}: {2} times as much", "允许 {1}：为其 {2} 倍", "zulässig {1}: das {2}-fache"}},
    {{"allowed {1}", "允许 {1}", "zulässig {1}"}},
    {{"from rest {1}", "起动时{1}", "beim Anfahren {1}"}},
    {{"in the cable {1}, {2}", "电缆中 {1}，{2}", "im Kabel {1}, {2}"}},
    {{"{1}, too (--tables limits)", "{1} 也不满足（见限值表）", "auch {1} (siehe Grenzwerte)"}},
    {{"{1} (--tables limits)", "{1}（见限值表）", "{1} (siehe Grenzwerte)"}},
    {{"give the allowed values in the case's section 'limits'", "在计算文件的 limits 部分给出允许值", "im Abschnitt limits des Falls angeben, was zulässig ist"}},
    {{"all assumed at upper ends: pull {1}; broken: {2}", "全部假定值取上限：牵引力 {1}；不满足：{2}", "alle Annahmen am oberen Ende: Zugkraft {1}; verletzt: {2}"}},
    {{"all assumed at upper ends: pull {1}", "全部假定值取上限：牵引力 {1}", "alle Annahmen am oberen Ende: Zugkraft {1}"}},
    {{"pulled from the other end: {1}", "改由另一端牵引：{1}", "vom anderen Ende gezogen: {1}"}},
    {{"friction of at least {1}, now {2}, would keep all limits", "摩擦系数不小于 {1}（现为 {2}）即满足全部限值", "eine Reibungszahl von mindestens {1}, jetzt {2}, hielte alle Grenzwerte ein"}},
    {{"friction of {1} to {2}, now {3}, would keep all limits", "摩擦系数 {1} 至 {2}（现为 {3}）即满足全部限值", "eine Reibungszahl von {1} bis {2}, jetzt {3}, hielte alle Grenzwerte ein"}},
    {{"a pull of at most {1}, now {2}, would keep all limits", "牵引长度不超过 {1}（现为 {2}）即满足全部限值", "eine Zuglänge von höchstens {1}, jetzt {2}, hielte alle Grenzwerte ein"}},
    {{"{1} machine of {2}, the first at {3}, would keep all limits", "{1} 台 {2} 输送机（首台位于 {3}）即满足全部限值", "{1} Maschine mit {2}, die erste bei {3}, hielte alle Grenzwerte ein"}},
    {{"{1} machines of {2}, the first at {3}, would keep all limits", "{1} 台 {2} 输送机（首台位于 {3}）即满足全部限值", "{1} Maschinen mit {2}, die erste bei {3}, hielten alle Grenzwerte ein"}},
    {{"{1} would keep all limits with what is assumed but {2}", "{1}，在假定条件下即满足除 {2} 外的全部限值", "{1} hielte mit den Annahmen alle Grenzwerte ein außer {2}"}},
    {{"{1} would keep all limits with what is assumed", "{1}，在假定条件下即满足全部限值", "{1} hielte mit den Annahmen alle Grenzwerte ein"}},
    {{"{1} would keep all limits that can be judged but {2}", "{1}，即满足除 {2} 外全部可判定的限值", "{1} hielte alle beurteilbaren Grenzwerte ein außer {2}"}},
    {{"{1} would keep all limits that can be judged", "{1}，即满足全部可判定的限值", "{1} hielte alle beurteilbaren Grenzwerte ein"}},
    {{"{1} would keep all limits but {2}", "{1}，即满足除 {2} 外的全部限值", "{1} hielte alle Grenzwerte ein außer {2}"}},
    {{"{1} would keep all limits", "{1}，即满足全部限值", "{1} hielte alle Grenzwerte ein"}},
    {{"{1} machine of {2}, the first at {3},", "{1} 台 {2} 输送机（首台位于 {3}）", "{1} Maschine mit {2}, die erste bei {3},"}},
    {{"{1} machines of {2}, the first at {3},", "{1} 台 {2} 输送机（首台位于 {3}）", "{1} Maschinen mit {2}, die erste bei {3},"}},
    {{"friction of at least {1}, now {2},", "摩擦系数不小于 {1}（现为 {2}）", "eine Reibungszahl von mindestens {1}, jetzt {2},"}},
    {{"friction of {1} to {2}, now {3},", "摩擦系数 {1} 至 {2}（现为 {3}）", "eine Reibungszahl von {1} bis {2}, jetzt {3},"}},
    {{"a pull of at most {1}, now {2},", "牵引长度不超过 {1}（现为 {2}）", "eine Zuglänge von höchstens {1}, jetzt {2},"}},
    {{"{1} would do; computed again: {2}", "{1}即可；重新计算结论：{2}", "{1} würde genügen; nachgerechnet: {2}"}},
    {{"{1} would do for all limits but those above; computed again: {2}", "除上述各项外，{1}即可；重新计算结论：{2}", "{1} würde für alles außer dem oben Genannten genügen; nachgerechnet: {2}"}},
    {{"{1} would help, but then is still broken: {2}", "{1}有所改善，但仍不满足：{2}", "{1} würde helfen, verletzt bliebe: {2}"}},
    {{"no duct, radius or lower friction makes this safe: still broken is {1}", "改变管道、半径或减小摩擦均不能使其安全：仍不满足 {1}", "kein Rohr, Radius oder geringere Reibung macht dies sicher: verletzt bleibt {1}"}},
    {{"{1} and {2} more (--tables remedies)", "{1} 等另 {2} 项（见措施表）", "{1} und {2} weitere (siehe Abhilfen)"}},
    {{"a radius of {1} in '[2]' would keep this limit ({3}, now {4}), or {5} % less tension there", "“{2}”处半径取 {1}（{3}，现为 {4}）即满足该限值，或该处拉力减小 {5} %", "ein Radius von {1} in „{2}“ hielte diesen Grenzwert ein ({3}, jetzt {4}), oder {5} % weniger Zugkraft dort"}},
    {{"a radius of {1} in '[2]' would keep this limit (now {4}), or {5} % less tension there", "“{2}”处半径取 {1}（现为 {4}）即满足该限值，或该处拉力减小 {5} %", "ein Radius von {1} in „{2}“ hielte diesen Grenzwert ein (jetzt {4}), oder {5} % weniger Zugkraft dort"}},
    {{"a radius of {1} there would keep this limit ({3}, now {4}), or {5} % less tension there", "该处半径取 {1}（{3}，现为 {4}）即满足该限值，或该处拉力减小 {5} %", "ein Radius von {1} dort hielte diesen Grenzwert ein ({3}, jetzt {4}), oder {5} % weniger Zugkraft dort"}},
    {{"a radius of {1} there would keep this limit (now {4}), or {5} % less tension there", "该处半径取 {1}（现为 {4}）即满足该限值，或该处拉力减小 {5} %", "ein Radius von {1} dort hielte diesen Grenzwert ein (jetzt {4}), oder {5} % weniger Zugkraft dort"}},
    {{"{1} % less tension there, or what presses less", "该处拉力减小 {1} %，或减小压力", "{1} % weniger Zugkraft dort, oder was weniger drückt"}},
    {{"{1} less pull: conveyors, a pit, or a lubricant", "牵引力减小 {1}：采用输送机、工作井或润滑剂", "{1} weniger Zugkraft: Schubgeräte, eine Grube oder Gleitmittel"}},
    {{"{1} less push ({2}), a narrower duct, or guides and carriers closer together", "推力减小 {1}（{2}），或采用较小管径，或加密导向与支承", "{1} weniger Schub ({2}), ein engeres Rohr oder engere Führungen und Auflager"}},
    {{"a rope that breaks at {1} ({2}), or less pull", "采用破断力 {1} 的牵引绳（{2}），或减小牵引力", "ein Seil mit {1} Bruchkraft ({2}), oder weniger Zugkraft"}},
    {{"an inside diameter of at least {1} and at most {2} in '[3]' would keep its limits (now {4}, twice {5})", "“{3}”内径取 {1} 至 {2} 即满足其限值（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von mindestens {1} und höchstens {2} in „{3}“ hielte dessen Grenzwerte ein (jetzt {4}, zweimal {5})"}},
    {{"an inside diameter of at least {1} in '[3]' would keep its limits (now {4}, twice {5})", "“{3}”内径不小于 {1} 即满足其限值（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von mindestens {1} in „{3}“ hielte dessen Grenzwerte ein (jetzt {4}, zweimal {5})"}},
    {{"an inside diameter of at most {1} and at least {2} in '[3]' would keep its limits (now {4}, twice {5})", "“{3}”内径取 {2} 至 {1} 即满足其限值（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von höchstens {1} und mindestens {2} in „{3}“ hielte dessen Grenzwerte ein (jetzt {4}, zweimal {5})"}},
    {{"an inside diameter of at least {1} and at most {2} in '[3]' (now {4}, twice {5})", "“{3}”内径取 {1} 至 {2}（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von mindestens {1} und höchstens {2} in „{3}“ (jetzt {4}, zweimal {5})"}},
    {{"an inside diameter of at least {1} in '[3]' (now {4}, twice {5})", "“{3}”内径不小于 {1}（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von mindestens {1} in „{3}“ (jetzt {4}, zweimal {5})"}},
    {{"an inside diameter of at most {1} and at least {2} in '[3]' (now {4}, twice {5})", "“{3}”内径取 {2} 至 {1}（现为 {4}，为 {5} 的两倍）", "ein Innendurchmesser von höchstens {1} und mindestens {2} in „{3}“ (jetzt {4}, zweimal {5})"}},
    {{"a radius of {1} in '[2]' ({3}, now {4})", "“{2}”处半径取 {1}（{3}，现为 {4}）", "ein Radius von {1} in „{2}“ ({3}, jetzt {4})"}},
    {{"a radius of {1} in '[2]' (now {4})", "“{2}”处半径取 {1}（现为 {4}）", "ein Radius von {1} in „{2}“ (jetzt {4})"}},
    {{"a radius of {1} there ({3}, now {4})", "该处半径取 {1}（{3}，现为 {4}）", "ein Radius von {1} dort ({3}, jetzt {4})"}},
    {{"a radius of {1} there (now {4})", "该处半径取 {1}（现为 {4}）", "ein Radius von {1} dort (jetzt {4})"}},
    {{"a radius of {1} at changes of slope ({2}, now {3})", "变坡处半径取 {1}（{2}，现为 {3}）", "ein Radius von {1} an Neigungswechseln ({2}, jetzt {3})"}},
    {{"friction of at most {1} and at rest {2} ({3}, now {4})", "摩擦系数不大于 {1}、静摩擦系数不大于 {2}（{3}，现为 {4}）", "eine Reibungszahl von höchstens {1}, Haftung {2} ({3}, jetzt {4})"}},
    {{"friction of at most {1} ({3}, now {4})", "摩擦系数不大于 {1}（{3}，现为 {4}）", "eine Reibungszahl von höchstens {1} ({3}, jetzt {4})"}},
    {{"friction of at most {1} and at rest {2} where it is {3}, elsewhere in proportion,", "将为 {3} 处的摩擦系数降至 {1}、静摩擦系数降至 {2}，其余各处按比例", "eine Reibungszahl von höchstens {1}, Haftung {2}, wo sie {3} ist, sonst im Verhältnis,"}},
    {{"friction of at most {1} where it is {3}, elsewhere in proportion,", "将为 {3} 处的摩擦系数降至 {1}，其余各处按比例", "eine Reibungszahl von höchstens {1}, wo sie {3} ist, sonst im Verhältnis,"}},
    {{"rollers there at {1} of their spacing, or rated {2} times as high, or a softer start ({3})", "该处滚轮间距减至 {1} 倍，或额定载荷提高至 {2} 倍，或更平缓起动（{3}）", "Rollen dort mit dem {1}-fachen Abstand, oder {2}-mal so tragfähig, oder ein sanfteres Anfahren ({3})"}},
    {{"rollers there at {1} of their spacing, or rated {2} times as high", "该处滚轮间距减至 {1} 倍，或额定载荷提高至 {2} 倍", "Rollen dort mit dem {1}-fachen Abstand, oder {2}-mal so tragfähig"}},
    {{"a brake of {1} more where the pull begins ({2}), or less feed ({3})", "在牵引起点增加制动力 {1}（{2}），或减小送入推力（{3}）", "{1} mehr Bremskraft am Beginn des Zugs ({2}), oder weniger Zuschub ({3})"}},
    {{"a brake of {1} more where the pull begins ({2}, of each cable)", "在牵引起点增加制动力 {1}（{2}，每根电缆）", "{1} mehr Bremskraft am Beginn des Zugs ({2}, je Kabel)"}},
    {{"a brake of {1} more where the pull begins ({2})", "在牵引起点增加制动力 {1}（{2}）", "{1} mehr Bremskraft am Beginn des Zugs ({2})"}},
    {{"a radius of at least {1} there", "该处半径不小于 {1}", "ein Radius von mindestens {1} dort"}},
    {{"sheaves and bends of at least {1} times the rope's diameter", "滑轮和弯段直径不小于牵引绳直径的 {1} 倍", "Seilrollen und Bögen von mindestens dem {1}-fachen Seildurchmesser"}},
    {{"more conveyors or machines, each with at most {1}", "增加输送机或机械，每台不超过 {1}", "mehr Schubgeräte oder Maschinen, jede mit höchstens {1}"}},
    {{"longer conveyors or more of them, pressing with at most {1}", "加长或增加输送机，夹紧压力不超过 {1}", "längere oder mehr Schubgeräte mit höchstens {1} Klemmdruck"}},
    {{"a winch that stops at {1} ({2})", "卷扬机停机值设为 {1}（{2}）", "eine Winde, die bei {1} abschaltet ({2})"}},
    {{"a winch that pulls with at most {1} ({2})", "卷扬机速度不超过 {1}（{2}）", "eine Winde mit höchstens {1} ({2})"}},
    {{"less feed ({1}): at most {2}", "减小送入推力（{1}）：不超过 {2}", "weniger Zuschub ({1}): höchstens {2}"}},
    {{"a softer start: a longer {1}, ramp step5", "更平缓起动：加长 {1}，采用 step5 曲线", "ein sanfteres Anfahren: längeres {1}, Rampe step5"}},
    /* Sources of limits */
    {{"needs {1}", "需给定 {1}", "braucht {1}"}},
    {{"limits.attachment_rating of the pulling head", "limits.attachment_rating（牵引头）", "limits.attachment_rating des Ziehkopfs"}},
    {{"limits.attachment_rating of the compression eye", "limits.attachment_rating（压接牵引端）", "limits.attachment_rating der Pressöse"}},
    {{"limits.attachment_rating of the stocking", "limits.attachment_rating（牵引网套）", "limits.attachment_rating des Ziehstrumpfs"}},
    {{"limits.attachment_rating of the basket", "limits.attachment_rating（吊笼网套）", "limits.attachment_rating des Korbs"}},
    {{"needs {1} or {2}", "需给定 {1} 或 {2}", "braucht {1} oder {2}"}},
    {{"needs {1}, or a rope in chain", "需给定 {1}，或在 chain 中给出牵引绳", "braucht {1}, oder ein Seil in chain"}},
    {{"needs limits.conductor or limits.pull; {1} are needed anyway", "需给定 limits.conductor 或 limits.pull；无论如何需要 {1}", "braucht limits.conductor oder limits.pull; {1} sind jedenfalls nötig"}},
    {{"needs drive.winch.trip: set it to {1}", "需给定 drive.winch.trip：取 {1}", "braucht drive.winch.trip: auf {1} setzen"}},
    {{"no roller has a rating: needs {1}", "滚轮无额定载荷：需给定 {1}", "keine Rolle hat eine Traglast: braucht {1}"}},
    {{"no code has a bound: needs {1}", "各标准均无限值：需给定 {1}", "keine Norm hat einen Wert: braucht {1}"}},
    {{"code [1] has no stress for this conductor: needs limits.stress or limits.pull", "标准 {1} 无该导体的允许应力：需给定 limits.stress 或 limits.pull", "Norm {1} hat keine Spannung für diesen Leiter: braucht limits.stress oder limits.pull"}},
    {{"code [1] has no stress for this sheath: needs limits.stress or limits.pull", "标准 {1} 无该护套的允许应力：需给定 limits.stress 或 limits.pull", "Norm {1} hat keine Spannung für diesen Mantel: braucht limits.stress oder limits.pull"}},
    {{"eq. 11, K = {1}, S = {2} mm2; {3}", "式 11，K = {1}，S = {2} mm2；{3}", "Gl. 11, K = {1}, S = {2} mm2; {3}"}},
    {{"eq. 12: 1.2 to 1.5 are usual", "式 12：通常取 1.2 至 1.5", "Gl. 12: 1.2 bis 1.5 sind üblich"}},
    {{"{1}, {2} of them", "{1}，共 {2} 个", "{1}, {2} Stück"}},
    {{"{1} D, D = {2} mm ({3})", "{1} D，D = {2} mm（{3}）", "{1} D, D = {2} mm ({3})"}},
    {{"strength {1} over a safety factor of {2}", "破断力 {1} 除以安全系数 {2}", "Bruchkraft {1} durch Sicherheit {2}"}},
    {{"what the cable may be pulled with", "电缆允许牵引力", "was das Kabel aushält"}},
    {{"what the eye or net bears", "牵引头或网套承载力", "was Ziehkopf oder Ziehstrumpf aushält"}},
    {{"what the rope may be pulled with", "牵引绳允许拉力", "was das Seil aushält"}},
    {{"what the winch can pull", "卷扬机能力", "was die Winde ziehen kann"}},
    {{"no allowed value is known", "未知何者首先达到极限", "nicht bekannt, was zuerst nachgibt"}},
    {{"alpha times the largest force", "最大拉力乘过载系数", "Überlastfaktor mal größte Kraft"}},
    {{"the winch's force is not known before the cable is held back: see run_away", "电缆未制动前卷扬机拉力未知：见“自行下滑”", "die Windenkraft ist unbekannt, bevor das Kabel gehalten wird: siehe Selbstlauf"}},
    {{"not known before the cable is held back", "电缆未制动前未知", "unbekannt, bevor das Kabel gehalten wird"}},
    {{"no trip is possible: {1} are needed, {2} allowed", "无合适停机值：需要 {1}，允许 {2}", "keine Abschaltkraft passt: {1} nötig, {2} zulässig"}},
    {{"from {1}, needed, to {2}, allowed; advised {3}", "自需要值 {1} 至允许值 {2}；建议 {3}", "von {1}, nötig, bis {2}, zulässig; empfohlen {3}"}},
    {{"rated {1}, {2} times the steady load", "额定 {1}，为稳态载荷的 {2} 倍", "Traglast {1}, das {2}-fache der stetigen Last"}},
    {{"rated {1}", "额定 {1}", "Traglast {1}"}},
    {{"not between {1} and {2} ({3})", "不应在 {1} 与 {2} 之间（{3}）", "nicht zwischen {1} und {2} ({3})"}},
    {{"below {1} ({2})", "小于 {1}（{2}）", "unter {1} ({2})"}},
    {{"a cable cannot be pushed", "电缆不能受推", "ein Kabel lässt sich nicht schieben"}},
    {{"friction is not given (friction.mu): up to {1} would do", "未给定摩擦系数（friction.mu）：不超过 {1} 即可", "Reibungszahl nicht angegeben (friction.mu): bis {1} würde genügen"}},
    {{"friction is not given (friction.mu)", "未给定摩擦系数（friction.mu）", "Reibungszahl nicht angegeben (friction.mu)"}},
    {{"theory has no answer", "理论无解", "die Theorie hat keine Antwort"}},
    {{"{1} has none; usual: {2}", "{1} 无规定；通常：{2}", "{1} hat keinen Wert; üblich: {2}"}},
    {{"aeic", "AEIC", "AEIC"}},
    {{"iec", "IEC", "IEC"}},
    {{"tes", "TES", "TES"}},
    {{"fujikura", "Fujikura", "Fujikura"}},
    {{"rollers", "滚轮经验值", "Rollen"}},
    {{"{1} (not verified)", "{1}（未核实）", "{1} (nicht geprüft)"}},
    {{"it runs away, pushed with {1}, and no brake where the pull begins holds it", "自行下滑，推力 {1}，起点制动无法阻止", "es läuft von selbst, mit {1} geschoben, und keine Bremse am Beginn hält es"}},
    {{"it runs away, pushed with {1}: a brake of {2} more is needed where the pull begins, then a winch of {3}", "自行下滑，推力 {1}：起点需增加制动力 {2}，卷扬机需 {3}", "es läuft von selbst, mit {1} geschoben: {2} mehr Bremskraft am Beginn nötig, dann eine Winde mit {3}"}},
    {{"snaking in the duct, 2 sqrt(EI w/r) (Dawson, Paslay 1984); coils from {1}", "管内蛇形屈曲，2 sqrt(EI w/r)（Dawson、Paslay 1984）；自 {1} 起螺旋屈曲", "Schlängeln im Rohr, 2 sqrt(EI w/r) (Dawson, Paslay 1984); Wendel ab {1}"}},
    {{"Euler, pi2 EI/l2: nothing holds it straight for l = {1}", "欧拉公式 pi2 EI/l2：l = {1} 范围内无约束", "Euler, pi2 EI/l2: auf l = {1} hält es nichts gerade"}},
    {{"no push is larger than the weight of a metre of cable", "所受推力不超过一米电缆重量", "nichts schiebt es stärker als ein Meter davon wiegt"}},
    {{"'[1]' pushes it with {2}, over {3}; {4} keep it straight", "“{1}”推力 {2}，长度 {3}；保持平直限值 {4}", "„{1}“ schiebt mit {2}, auf {3}; bis {4} bleibt es gerade"}},
    {{"theory computes no load for rollers.list and obstacles: a run does", "理论不计 rollers.list 与 obstacles 的载荷：需仿真", "Lasten von rollers.list und obstacles kennt nur ein Lauf"}},
    {{"theory computes no load for hold-downs under uplift: a run does", "理论不计压线轮载荷：需仿真", "Lasten von Niederhaltern kennt nur ein Lauf"}},
    {{"a winch of set tension without a speed_limit: only a run gives it", "恒张力卷扬机未设 speed_limit：需仿真", "eine Winde mit fester Zugkraft ohne speed_limit: das sagt ein Lauf"}},
    {{"cables on rollers", "滚轮上的电缆", "Kabel auf Rollen"}},
    {{"20 diameters, or limits.bend_radius", "20 倍直径，或 limits.bend_radius", "20 Durchmesser, oder limits.bend_radius"}},
    {{"not given", "未给定", "nicht angegeben"}},
    {{"1 to 1.5 times that in motion", "动摩擦系数的 1 至 1.5 倍", "das 1- bis 1.5-fache der Gleitreibungszahl"}},
    {{"a reel that turns freely to one that holds back 15 m of cable", "自由转动的电缆盘至可制动 15 m 电缆的电缆盘", "freilaufende Trommel bis zu einer, die 15 m Kabel hält"}},
    {{"the head", "端头", "Kabelspitze"}},
    {{"the eye", "牵引环", "Ziehöse"}},
    {{"the end", "终点", "Ende"}},
    {{"the smallest sheave", "最小滑轮", "kleinste Seilrolle"}},
    /* Clauses of codes (def/limits.c) */
    {{"paper, table 4: copper {1}", "论文表 4：铜 {1}", "Aufsatz, Tabelle 4: Kupfer {1}"}},
    {{"paper, table 4: aluminium {1}", "论文表 4：铝 {1}", "Aufsatz, Tabelle 4: Aluminium {1}"}},
    {{"paper, table 4: PE sheath {1}", "论文表 4：PE 护套 {1}", "Aufsatz, Tabelle 4: PE-Mantel {1}"}},
    {{"paper, table 4: XLPE sheath {1}", "论文表 4：XLPE 护套 {1}", "Aufsatz, Tabelle 4: VPE-Mantel {1}"}},
    {{"TB 889, 4.5.2, single core: copper {1}", "TB 889 第 4.5.2 条，单芯：铜 {1}", "TB 889, 4.5.2, einadrig: Kupfer {1}"}},
    {{"TB 889, 4.5.2, three core or triangular formation: copper {1}", "TB 889 第 4.5.2 条，三芯或三角形排列：铜 {1}", "TB 889, 4.5.2, dreiadrig oder Dreieck: Kupfer {1}"}},
    {{"TB 889, 4.5.2: aluminium {1}", "TB 889 第 4.5.2 条：铝 {1}", "TB 889, 4.5.2: Aluminium {1}"}},
    {{"ICEA: copper {1}, {2}", "ICEA：铜 {1}，{2}", "ICEA: Kupfer {1}, {2}"}},
    {{"ICEA: aluminium {1}, {2}", "ICEA：铝 {1}，{2}", "ICEA: Aluminium {1}, {2}"}},
    {{"VDE, Nexans: copper {1}", "VDE、Nexans：铜 {1}", "VDE, Nexans: Kupfer {1}"}},
    {{"VDE, Nexans: aluminium {1}", "VDE、Nexans：铝 {1}", "VDE, Nexans: Aluminium {1}"}},
    {{"GB 50217, {1}: copper {2}", "GB 50217 第 {1} 条：铜 {2}", "GB 50217, {1}: Kupfer {2}"}},
    {{"GB 50217, {1}: aluminium {2}", "GB 50217 第 {1} 条：铝 {2}", "GB 50217, {1}: Aluminium {2}"}},
    {{"ICEA: lead sheath {1}, {2}", "ICEA：铅护套 {1}，{2}", "ICEA: Bleimantel {1}, {2}"}},
    {{"TES-P-104.05, 4.2.2 a: lead sheath {1}", "TES-P-104.05 第 4.2.2 a 条：铅护套 {1}", "TES-P-104.05, 4.2.2 a: Bleimantel {1}"}},
    {{"ICEA, under a grip too: copper {1}, {2}", "ICEA，网套牵引亦同：铜 {1}，{2}", "ICEA, auch unter einem Ziehstrumpf: Kupfer {1}, {2}"}},
    {{"ICEA, under a grip too: aluminium {1}, {2}", "ICEA，网套牵引亦同：铝 {1}，{2}", "ICEA, auch unter einem Ziehstrumpf: Aluminium {1}, {2}"}},
    {{"VDE, Nexans, stocking, no armour: copper {1}", "VDE、Nexans，网套、无铠装：铜 {1}", "VDE, Nexans, Ziehstrumpf, ohne Bewehrung: Kupfer {1}"}},
    {{"VDE, Nexans, stocking, no armour: aluminium {1}", "VDE、Nexans，网套、无铠装：铝 {1}", "VDE, Nexans, Ziehstrumpf, ohne Bewehrung: Aluminium {1}"}},
    {{"Southwire: no device above 10 000 lbf", "Southwire：任何连接件不超过 10 000 lbf", "Southwire: kein Teil über 10 000 lbf"}},
    {{"ICEA: {1} a grip", "ICEA：每个网套 {1}", "ICEA: {1} je Ziehstrumpf"}},
    {{"TES-P-104.05, 4.2.2 b: {1} a grip", "TES-P-104.05 第 4.2.2 b 条：每个网套 {1}", "TES-P-104.05, 4.2.2 b: {1} je Ziehstrumpf"}},
    {{"more than 3 conductors: {1} %", "导体多于 3 根：{1} %", "mehr als 3 Leiter: {1} %"}},
    {{"{1} single cables count as {2}", "{1} 根单芯电缆按 {2} 根计", "{1} Einzelkabel zählen als {2}"}},
    {{"GB 50217, {1}: {2}, separately sheathed three-core cables", "GB 50217 第 {1} 条：{2}，分相护套三芯电缆", "GB 50217, {1}: {2}, Dreileiterkabel mit getrennten Mänteln"}},
    {{"GB 50217, {1}: {2}, if the cores are separately sheathed (limits.cable_type says otherwise)", "GB 50217 第 {1} 条：{2}，按分相护套计（可由 limits.cable_type 改变）", "GB 50217, {1}: {2}, falls die Adern einzeln ummantelt sind (sonst limits.cable_type)"}},
    {{"GB 50217, {1}: {2}", "GB 50217 第 {1} 条：{2}", "GB 50217, {1}: {2}"}},
    {{"Fujikura: {1}", "Fujikura：{1}", "Fujikura: {1}"}},
    {{"on rollers: {1}, the least of the usual {2} to {3}", "滚轮上：{1}，通常 {2} 至 {3} 的最小值", "auf Rollen: {1}, der kleinste der üblichen {2} bis {3}"}},
    {{"General Cable: control cables {1}", "General Cable：控制电缆 {1}", "General Cable: Steuerkabel {1}"}},
    {{"General Cable: unshielded power cables {1}", "General Cable：无屏蔽电力电缆 {1}", "General Cable: ungeschirmte Starkstromkabel {1}"}},
    {{"General Cable: 5 to 35 kV shielded {1}", "General Cable：5 至 35 kV 屏蔽电缆 {1}", "General Cable: 5 bis 35 kV geschirmt {1}"}},
    {{"AEIC CG5, General Cable: {1} ({2}), the least of the cable types", "AEIC CG5、General Cable：{1}（{2}），各类电缆的最小值", "AEIC CG5, General Cable: {1} ({2}), der kleinste der Kabelarten"}},
    {{"Fujikura: 8 to 12 D, the larger", "Fujikura：8 至 12 D，取大值", "Fujikura: 8 bis 12 D, der größere"}},
    {{"ICEA: shielded cables {1}", "ICEA：屏蔽电缆 {1}", "ICEA: geschirmte Kabel {1}"}},
    {{"ICEA: unshielded cables {1}", "ICEA：无屏蔽电缆 {1}", "ICEA: ungeschirmte Kabel {1}"}},
    {{"20 D at 110 kV", "110 kV 取 20 D", "20 D bei 110 kV"}},
    {{"Southwire, General Cable: 1.05 D/d", "Southwire、General Cable：1.05 D/d", "Southwire, General Cable: 1.05 D/d"}},
    {{"{1}, {2}: D/d of 2.8 to 3 avoided", "{1} 第 {2} 条：避免 D/d 为 2.8 至 3", "{1}, {2}: D/d von 2.8 bis 3 vermeiden"}},
    {{"three cables wedge from 2.6 (Southwire) to 3.2", "三根电缆在 2.6（Southwire）至 3.2 之间卡阻", "drei Kabel klemmen von 2.6 (Southwire) bis 3.2"}},
    {{"TB 889, 4.5.5: trefoil below D/d of 2.8", "TB 889 第 4.5.5 条：D/d 小于 2.8 时品字形排列", "TB 889, 4.5.5: Dreieck unter D/d von 2.8"}},
    {{"TB 889, 4.5.5: 13 mm, with bends", "TB 889 第 4.5.5 条：有弯段时 13 mm", "TB 889, 4.5.5: 13 mm, mit Bögen"}},
    {{"TES-P-104.05, 5.4: 6 to 25 mm, the least", "TES-P-104.05 第 5.4 条：6 至 25 mm，取最小值", "TES-P-104.05, 5.4: 6 bis 25 mm, der kleinste"}},
    {{"1/4 in over the uppermost cable (Anixter)", "最上层电缆上方 1/4 in（Anixter）", "1/4 in über dem obersten Kabel (Anixter)"}},
    {{"{1}, {2}: a duct of at least 1.5 d, {3} %", "{1} 第 {2} 条：管径不小于 1.5 d，{3} %", "{1}, {2}: ein Rohr von mindestens 1.5 d, {3} %"}},
    {{"Nexans Germany: a duct of at least 1.5 d, {1} %", "Nexans 德国：管径不小于 1.5 d，{1} %", "Nexans Deutschland: ein Rohr von mindestens 1.5 d, {1} %"}},
    {{"{1}, {2}: a duct of at least 1.5 times the circle round both, {3} %", "{1} 第 {2} 条：管径不小于两缆包络圆的 1.5 倍，{3} %", "{1}, {2}: ein Rohr von mindestens dem 1.5-fachen des Kreises um beide, {3} %"}},
    {{"{1}, {2}: a duct of at least 1.5 times the circle round three, {3} %", "{1} 第 {2} 条：管径不小于三缆包络圆的 1.5 倍，{3} %", "{1}, {2}: ein Rohr von mindestens dem 1.5-fachen des Kreises um drei, {3} %"}},
    {{"{1}, {2}: a duct of at least 1.5 times the circle round four, {3} %", "{1} 第 {2} 条：管径不小于四缆包络圆的 1.5 倍，{3} %", "{1}, {2}: ein Rohr von mindestens dem 1.5-fachen des Kreises um vier, {3} %"}},
    {{"NEC, chapter 9, table 1: {1} % with {2} cable", "NEC 第 9 章表 1：{2} 根电缆 {1} %", "NEC, Kapitel 9, Tabelle 1: {1} % mit {2} Kabel"}},
    {{"NEC, chapter 9, table 1: {1} % with {2} cables", "NEC 第 9 章表 1：{2} 根电缆 {1} %", "NEC, Kapitel 9, Tabelle 1: {1} % mit {2} Kabeln"}},
    {{"NEC, chapter 9, table 1: {1} % from {2} cables on", "NEC 第 9 章表 1：{2} 根及以上电缆 {1} %", "NEC, Kapitel 9, Tabelle 1: {1} % ab {2} Kabeln"}},
    {{"riggers' rule: steel wire at least {1}", "起重经验：钢丝绳不小于 {1}", "Faustregel: Stahlseil mindestens {1}"}},
    {{"riggers' rule: fibre 6 to 8 d, the larger", "起重经验：纤维绳 6 至 8 d，取大值", "Faustregel: Faserseil 6 bis 8 d, der größere"}},
    {{"TB 889: 3 to 15 m/min", "TB 889：3 至 15 m/min", "TB 889: 3 bis 15 m/min"}},
    /* Why a closed form does not hold */
    {{"friction, weight or a push changes on the piece", "该段内摩擦、重量或推力有变化", "Reibung, Gewicht oder Schub ändert sich im Abschnitt"}},
    {{"the cable is pushed, and snakes or coils on the piece", "该段电缆受推而蛇形或螺旋屈曲", "das Kabel wird geschoben und schlängelt oder wendelt sich"}},
    {{"a curve: no closed form", "曲线：无解析式", "eine Kurve: keine geschlossene Formel"}},
    {{"a clothoid: no closed form", "缓和曲线：无解析式", "eine Klothoide: keine geschlossene Formel"}},
    {{"a parabola: no closed form", "抛物线：无解析式", "eine Parabel: keine geschlossene Formel"}},
    {{"a helix: no closed form", "螺旋线：无解析式", "eine Wendel: keine geschlossene Formel"}},
    {{"a straight: no closed form", "直线：无解析式", "eine Gerade: keine geschlossene Formel"}},
    {{"a bend: no closed form", "弯段：无解析式", "ein Bogen: keine geschlossene Formel"}},
    {{"the bend is neither level nor in a vertical plane: no closed form", "弯段既非水平又不在竖直面内：无解析式", "der Bogen liegt weder waagerecht noch in einer senkrechten Ebene: keine geschlossene Formel"}},
    {{"the bend goes past the vertical, from {1} to {2}", "弯段超过竖直，自 {1} 至 {2}", "der Bogen geht über die Senkrechte, von {1} bis {2}"}},
    {{"the tension before the bend is {1}: a cable does not push", "弯段前拉力为 {1}：电缆不能受推", "die Zugkraft vor dem Bogen ist {1}: ein Kabel schiebt nicht"}},
    {{"the tension after the bend is {1}: a cable does not push", "弯段后拉力为 {1}：电缆不能受推", "die Zugkraft nach dem Bogen ist {1}: ein Kabel schiebt nicht"}},
    /* Conditions */
    {{"nothing carries the cable (no rollers, ducts, trays or floor), and no friction is given: the pull is computed with an assumed friction of {1}; give supports, or friction.mu", "电缆无任何支承（无滚轮、管道、支架或地面），且未给定摩擦系数：牵引力按猜测值 {1} 计算；应给定支承或 friction.mu", "nichts trägt das Kabel (keine Rollen, Rohre, Wannen oder Boden), und keine Reibungszahl ist angegeben: die Zugkraft gilt für geratene {1}; angeben, was es trägt, oder friction.mu"}},
    {{"nothing carries the cable (no rollers, ducts, trays or floor), and the case says how it is run: it would fall; give supports", "电缆无任何支承（无滚轮、管道、支架或地面），而计算文件规定了运行方式：电缆将下坠；应给定支承", "nichts trägt das Kabel (keine Rollen, Rohre, Wannen oder Boden), und der Fall soll laufen: es fiele; angeben, was es trägt"}},
    {{"nothing carries the cable between {1} and {2}, where it would be {3} off the route, or fall: give supports there", "{1} 至 {2} 间电缆无支承，将偏离线路 {3} 或下坠：应给定支承", "nichts trägt das Kabel zwischen {1} und {2}, wo es {3} neben der Trasse läge oder fiele: angeben, was es trägt"}},
    {{"'[1]' has a friction of its own, {2}, and the calculation takes {3}, {4}: give the larger one there, or theory.stretches", "“{1}”自有摩擦系数 {2}，而计算采用 {3} = {4}：应改用前者，或给定 theory.stretches", "„{1}“ hat eine eigene Reibungszahl, {2}, und die Berechnung nimmt {3}, {4}: jene angeben, oder theory.stretches"}},
    {{"'[1]' has a friction of its own by its bearing, {2}, and the calculation takes {3}, {4}: give the larger one there, or theory.stretches", "“{1}”轴承摩擦系数为 {2}，而计算采用 {3} = {4}：应改用前者，或给定 theory.stretches", "„{1}“ hat durch sein Lager eine eigene Reibungszahl, {2}, und die Berechnung nimmt {3}, {4}: jene angeben, oder theory.stretches"}},
    {{"'[1]' has a friction of its own from rest, {2}, and the calculation takes {3}, {4}: give the larger one there, or theory.stretches", "“{1}”自有静摩擦系数 {2}，而计算采用 {3} = {4}：应改用前者，或给定 theory.stretches", "„{1}“ hat eine eigene Haftreibungszahl, {2}, und die Berechnung nimmt {3}, {4}: jene angeben, oder theory.stretches"}},
    {{"'[1]' has a friction of its own by its bearing from rest, {2}, and the calculation takes {3}, {4}: give the larger one there, or theory.stretches", "“{1}”轴承静摩擦系数为 {2}，而计算采用 {3} = {4}：应改用前者，或给定 theory.stretches", "„{1}“ hat durch sein Lager eine eigene Haftreibungszahl, {2}, und die Berechnung nimmt {3}, {4}: jene angeben, oder theory.stretches"}},
    {{"drive.script makes friction {1} times the case's, and the calculation takes the case's (friction.mu: {2}): give the largest there, and factors of at most 1", "drive.script 将摩擦改为 {1} 倍，而计算采用原值（friction.mu: {2}）：应在该处给定最大值，系数不大于 1", "drive.script macht die Reibung {1}-mal so groß, und die Berechnung nimmt die des Falls (friction.mu: {2}): dort die größte angeben, und Faktoren von höchstens 1"}},
    {{"the fluid of section medium lifts or moves the cable by {1} % of its weight, and the calculation does not include it: a run does", "medium 中流体使电缆受力达其重量的 {1} %，计算未计入：需仿真", "das Fluid in medium hebt oder bewegt das Kabel mit {1} % seines Gewichts, was die Berechnung nicht kennt: ein Lauf schon"}},
    {{"{1} changes the speed of conveyor '[2]', and the calculation takes it unchanged: give its worst state in section conveyors", "{1} 改变输送机“{2}”的速度，而计算按原状态：应在 conveyors 中按最不利状态给定", "{1} ändert die Geschwindigkeit von Schubgerät „{2}“, und die Berechnung nimmt die vorige: in conveyors den ungünstigsten Stand angeben"}},
    {{"{1} opens conveyor '[2]', and the calculation takes it unchanged: give its worst state in section conveyors", "{1} 松开输送机“{2}”，而计算按原状态：应在 conveyors 中按最不利状态给定", "{1} öffnet Schubgerät „{2}“, und die Berechnung nimmt den vorigen Stand: in conveyors den ungünstigsten Stand angeben"}},
    {{"{1} clamps conveyor '[2]', and the calculation takes it unchanged: give its worst state in section conveyors", "{1} 夹紧输送机“{2}”，而计算按原状态：应在 conveyors 中按最不利状态给定", "{1} klemmt Schubgerät „{2}“, und die Berechnung nimmt den vorigen Stand: in conveyors den ungünstigsten Stand angeben"}},
    {{"{1} stops conveyor '[2]', and the calculation takes it unchanged: give its worst state in section conveyors", "{1} 停止输送机“{2}”，而计算按原状态：应在 conveyors 中按最不利状态给定", "{1} hält Schubgerät „{2}“ an, und die Berechnung nimmt den vorigen Stand: in conveyors den ungünstigsten Stand angeben"}},
    {{"{1} outruns conveyor '[2]', and the calculation takes it unchanged: give its worst state in section conveyors", "{1} 使卷扬机快于输送机“{2}”，而计算按原状态：应在 conveyors 中按最不利状态给定", "{1} überholt Schubgerät „{2}“, und die Berechnung nimmt den vorigen Stand: in conveyors den ungünstigsten Stand angeben"}},
    {{"jams stops conveyor '[1]', and the calculation takes it unchanged: give its worst state in section conveyors", "jams 停止输送机“{1}”，而计算按原状态：应在 conveyors 中按最不利状态给定", "jams hält Schubgerät „{1}“ an, und die Berechnung nimmt den vorigen Stand: in conveyors den ungünstigsten Stand angeben"}},
    {{"jams stops roller '[1]', which the calculation does not include: a run does", "jams 停止滚轮“{1}”，计算未计入：需仿真", "jams hält Rolle „{1}“ an, was die Berechnung nicht kennt: ein Lauf schon"}},
    {{"{1} stops roller '[2]', which the calculation does not include: a run does", "{1} 停止滚轮“{2}”，计算未计入：需仿真", "{1} hält Rolle „{2}“ an, was die Berechnung nicht kennt: ein Lauf schon"}},
    {{"{1} presses on the cable by 'force', which the calculation does not include: a run does", "{1} 以 force 压迫电缆，计算未计入：需仿真", "{1} drückt mit force auf das Kabel, was die Berechnung nicht kennt: ein Lauf schon"}},
    {{"rollers have a motor that starts late, '[1]', which the calculation does not include: a run does", "滚轮“{1}”的电机延迟投入，计算未计入：需仿真", "Rolle „{1}“ hat einen Motor, der spät einsetzt, was die Berechnung nicht kennt: ein Lauf schon"}},
    {{"the winch pulls with {1}, where {2} are needed with the front at {3}: without drive.winch.tension.speed_limit that is the pull, and the cable gathers speed", "电缆前端位于 {3} 时卷扬机拉力 {1}，而需要 {2}：未设 drive.winch.tension.speed_limit 时电缆将加速", "die Winde zieht mit {1}, wo mit der Spitze bei {3} {2} nötig sind: ohne drive.winch.tension.speed_limit ist das die Zugkraft, und das Kabel wird schneller"}},
    {{"'[1]' runs with the winch, so that it is not known which of them pulls: without it {2} more are needed, and '{3}' has {4} left; give it a 'factor' of 1.02", "“{1}”与卷扬机同步，由长度决定受力分配：没有它另需 {2}，而“{3}”余 {4}；应取 factor 1.02", "„{1}“ läuft mit der Winde, so dass Längen entscheiden, wer zieht: ohne es sind {2} mehr nötig, und „{3}“ hat {4} frei; factor 1.02 geben"}},
    {{"the winch pulls with at most {1} (drive.winch.tension), and {2} are needed: it stops on the way", "卷扬机拉力最大 {1}（drive.winch.tension），而需要 {2}：中途停住", "die Winde zieht mit höchstens {1} (drive.winch.tension), und {2} sind nötig: sie bleibt unterwegs stehen"}},
    {{"the cable would run away or slacken: pushed with {1} at [2]; it needs a brake of {3} at the start, then a winch of {4}", "电缆将自行下滑或松弛：在 {2} 处受推 {1}；起点需制动力 {3}，卷扬机需 {4}", "das Kabel liefe von selbst oder würde schlaff: mit {1} geschoben bei {2}; es braucht {3} Bremskraft am Anfang, dann eine Winde mit {4}"}},
    {{"the cable would run away or slacken: pushed with {1}, and no brake at the start holds it", "电缆将自行下滑或松弛：受推 {1}，起点制动无法阻止", "das Kabel liefe von selbst oder würde schlaff: mit {1} geschoben, und keine Bremse am Anfang hält es"}},
    {{"drive.script: with {1} of friction the cable runs away: pushed with {2} at [3]; it needs a brake of {4} at the start, then a winch of {5}", "drive.script：摩擦降至 {1} 时自行下滑：在 {3} 处受推 {2}；起点需制动力 {4}，卷扬机需 {5}", "drive.script: mit {1} der Reibung läuft es von selbst: mit {2} geschoben bei {3}; es braucht {4} Bremskraft am Anfang, dann eine Winde mit {5}"}},
    {{"drive.script: with {1} of friction the cable runs away: pushed with {2}, and no brake at the start holds it", "drive.script：摩擦降至 {1} 时自行下滑：受推 {2}，起点制动无法阻止", "drive.script: mit {1} der Reibung läuft es von selbst: mit {2} geschoben, und keine Bremse am Anfang hält es"}},
    {{"the pushers give more than is needed, and the cable pushes the winch with {1}: reduce their push", "推送力超过需要，电缆以 {1} 推向卷扬机：应减小推力", "was schiebt, gibt mehr als nötig, und das Kabel schiebt die Winde mit {1}: weniger schieben lassen"}},
    {{"it would run ahead of the cables it pulls, pushed with {1} at [2]: increase their back tension (drive.tail.tension)", "电缆将超前于所牵引者，在 {2} 处受推 {1}：应加大后端张力（drive.tail.tension）", "es liefe dem voraus, was es zieht, mit {1} geschoben bei {2}: das stärker halten (drive.tail.tension)"}},
    {{"without any push the cable would run away as well, pushed with {1} at [2]: hold it back where the pull begins", "即使无推送，电缆亦将自行下滑，在 {2} 处受推 {1}：应在起点制动", "auch ohne Schub liefe das Kabel von selbst, mit {1} geschoben bei {2}: am Beginn halten"}},
    {{"before the back tension has risen, at {1}, the cable would run away, pushed with {2} at [3]: give it from the start", "后端张力在 {1} 才投入，此前电缆将自行下滑，在 {3} 处受推 {2}：应自起点施加", "bevor die Rückhaltekraft bei {1} einsetzt, liefe das Kabel von selbst, mit {2} geschoben bei {3}: sie von Anfang an geben"}},
    {{"at the start '[1]' pushes only as the cable ahead moves: {2}, with waves up to a fifth more, are needed, and '{3}' allows {4}; start it first", "起动时“{1}”仅随前方电缆移动而推送：需 {2}（波动时最多再加五分之一），而“{3}”允许 {4}；应先起动它", "beim Anfahren schiebt „{1}“ nur, wie das Kabel davor nachgibt: {2}, durch Wellen bis ein Fünftel mehr, sind nötig, und „{3}“ erlaubt {4}; es zuerst starten"}},
    {{"the cable's bending stiffness, which theory leaves out, takes about {1} more, most of it in the bend at {2}, and '{3}' has {4} left: run the case", "理论未计入的电缆弯曲刚度约增加 {1}，主要在 {2} 处弯段，而“{3}”仅余 {4}：需仿真", "die Biegesteifigkeit, die die Theorie nicht enthält, nimmt etwa {1} mehr, das meiste im Bogen bei {2}, und „{3}“ hat {4} frei: den Fall laufen lassen"}},
    {{"taut, the cable lifts off its supports by {1} at {2}: give hold-downs or a duct there, or leave out 'run' and 'drive'", "电缆拉紧后在 {2} 处离开支承 {1}：应设压线轮或管道，或去掉 run 与 drive", "straff hebt das Kabel bei {2} um {1} vom Auflager ab: dort Niederhalter oder ein Rohr, oder run und drive weglassen"}},
    {{"taut, the rope lifts off its supports by {1} at {2}: give hold-downs or a duct there, or leave out 'run' and 'drive'", "牵引绳拉紧后在 {2} 处离开支承 {1}：应设压线轮或管道，或去掉 run 与 drive", "straff hebt das Seil bei {2} um {1} vom Auflager ab: dort Niederhalter oder ein Rohr, oder run und drive weglassen"}},
    {{"the route crosses itself at one level, at {1} and at {2}, where the cable would lie inside itself: lead one part over the other, by {3} at least", "线路在 {1} 与 {2} 处同一高程自相交叉，电缆将与自身重叠：应至少错开 {3}", "die Trasse kreuzt sich auf einer Höhe, bei {1} und bei {2}, wo das Kabel in sich selbst läge: einen Weg um mindestens {3} über den anderen führen"}},
    {{"what carries the cable from {1} to {2} slopes to the side by {3} degrees, and nothing holds it there: moving, it slides off; give guides, or lay it level", "{1} 至 {2} 间支承面侧倾 {3} 度且无侧向约束：电缆移动时将滑落；应设导向或放平", "was das Kabel von {1} bis {2} trägt, fällt um {3} Grad zur Seite, und nichts hält es dort: in Bewegung rutscht es ab; Führungen geben oder waagerecht legen"}},
    {{"taut, the cable presses to the side with {1} at {2}, and the inclined or grooved support there bears {3}: give 'guide: inside' there", "电缆拉紧后在 {2} 处侧向压力 {1}，该处斜面或槽形支承仅能承受 {3}：应给定 guide: inside", "straff drückt das Kabel bei {2} mit {1} zur Seite, und was dort schräg oder gerillt ist, trägt {3}: dort guide: inside geben"}},
    {{"taut, the rope presses to the side with {1} at {2}, and the inclined or grooved support there bears {3}: give 'guide: inside' there", "牵引绳拉紧后在 {2} 处侧向压力 {1}，该处斜面或槽形支承仅能承受 {3}：应给定 guide: inside", "straff drückt das Seil bei {2} mit {1} zur Seite, und was dort schräg oder gerillt ist, trägt {3}: dort guide: inside geben"}},
    {{"nothing holds the cable to the side at {1} (guide, groove, wall or duct): taut, it runs off its rollers; give 'guide: inside' there", "{1} 处电缆无侧向约束（导轮、槽、壁或管道）：拉紧后脱离滚轮；应给定 guide: inside", "bei {1} hält nichts das Kabel seitlich (Führung, Rille, Wand oder Rohr): straff läuft es von den Rollen; dort guide: inside geben"}},
    {{"nothing holds the rope to the side at {1} (guide, groove, wall or duct): taut, it runs off its rollers; give 'guide: inside' there", "{1} 处牵引绳无侧向约束（导轮、槽、壁或管道）：拉紧后脱离滚轮；应给定 guide: inside", "bei {1} hält nichts das Seil seitlich (Führung, Rille, Wand oder Rohr): straff läuft es von den Rollen; dort guide: inside geben"}},
    {{"the cable's head is at {1} and has no rope, and the route turns by {2} degrees ahead of it: the winch would pull along the route's end, through the wall; give 'chain' a rope, or put the head at {3} or beyond", "电缆端头位于 {1} 且无牵引绳，而前方线路转角 {2} 度：卷扬机将沿线路终点方向穿墙牵引；应在 chain 中给定牵引绳，或将端头置于 {3} 之后", "die Kabelspitze ist bei {1} und hat kein Seil, und die Trasse biegt davor um {2} Grad ab: die Winde zöge in Richtung des Trassenendes durch die Wand; chain ein Seil geben oder die Spitze auf {3} oder weiter setzen"}},
    {{"the rope ends at {1}, and the route turns by {2} degrees ahead of it: the winch would pull along the route's end, through the wall; make the rope {3} longer or more", "牵引绳止于 {1}，而前方线路转角 {2} 度：卷扬机将沿线路终点方向穿墙牵引；牵引绳至少加长 {3}", "das Seil endet bei {1}, und die Trasse biegt davor um {2} Grad ab: die Winde zöge in Richtung des Trassenendes durch die Wand; das Seil um {3} oder mehr verlängern"}},
    /* Notes */
    {{"friction changes with the length that a place of the cable has been pulled", "摩擦系数随电缆各处已牵引长度变化", "die Reibungszahl ändert sich mit der Länge, die eine Stelle des Kabels gezogen wurde"}},
    {{"friction changes with the length of cable that has passed a place", "摩擦系数随已通过该处的电缆长度变化", "die Reibungszahl ändert sich mit der Länge des Kabels, die eine Stelle passiert hat"}},
    {{"the cable is pushed with up to {1}; the force that its layers bear is not known ('theory.bears') and not judged (buckling is, by its limit)", "电缆受推最大 {1}；各层承受能力未知（theory.bears），不作判定（屈曲按其限值判定）", "das Kabel wird mit bis zu {1} geschoben; was seine Lagen aushalten, ist nicht bekannt (theory.bears) und nicht beurteilt (Knicken schon, durch seinen Grenzwert)"}},
    {{"{1} C: below -10 C PVC jackets stiffen and may crack; makers allow PE farther down. Keep to the maker's lowest temperature, warm the drums through, bend wider, pull slower. Friction and stiffness are those of the case: this calculation does not change them", "{1} ℃：低于 -10 ℃ 时 PVC 外护套变硬并可能开裂；制造厂允许 PE 在更低温度敷设。应遵守制造厂最低敷设温度，电缆盘充分加温，加大弯曲半径，降低牵引速度。摩擦系数与刚度取自计算文件，本计算不作修正", "{1} °C: unter -10 °C werden PVC-Mäntel steif und können reißen; für PE erlauben Hersteller tiefere Werte. Die tiefste Temperatur des Herstellers einhalten, Trommeln durchwärmen, weiter biegen, langsamer ziehen. Reibungszahl und Steifigkeit sind die des Falls: diese Berechnung ändert sie nicht"}},
    {{"{1} C: some makers allow no laying below 0 C; PVC jackets stiffen below -10 C. Drums that stood in the cold stay cold inside. Friction and stiffness are those of the case", "{1} ℃：部分制造厂不允许低于 0 ℃ 敷设；低于 -10 ℃ 时 PVC 外护套变硬。低温存放的电缆盘内部仍冷。摩擦系数与刚度取自计算文件", "{1} °C: manche Hersteller erlauben kein Verlegen unter 0 °C; PVC-Mäntel werden unter -10 °C steif. Trommeln aus der Kälte bleiben innen kalt. Reibungszahl und Steifigkeit sind die des Falls"}},
    {{"not in the route, of its file: {1}, and more (hawser check lists it)", "线路文件中未采用：{1} 等（见 hawser check）", "nicht in der Trasse, aus ihrer Datei: {1} und mehr (hawser check zählt es auf)"}},
    {{"not in the route, of its file: {1}", "线路文件中未采用：{1}", "nicht in der Trasse, aus ihrer Datei: {1}"}},
    {{"not in the route, of its file: [1], and more (hawser check lists it)", "线路文件中未采用：{1} 等（见 hawser check）", "nicht in der Trasse, aus ihrer Datei: {1} und mehr (hawser check zählt es auf)"}},
    {{"not in the route, of its file: [1]", "线路文件中未采用：{1}", "nicht in der Trasse, aus ihrer Datei: {1}"}},
    /* Combined texts; the last resort */
    {{"{1}; {2}", "{1}；{2}", "{1}; {2}"}},
    {{"{1}, {2}", "{1}，{2}", "{1}, {2}"}},
    {{"{1} and {2}", "{1}和{2}", "{1} und {2}"}},
    {{"{1} by <2> % at [3]", "{1} 超限 {2} %（位于 {3}）", "{1} um {2} % bei {3}"}},
    {{"{1} by <2> %", "{1} 超限 {2} %", "{1} um {2} %"}},
    {{"{1} <2> times too large at [3]", "{1} 为允许值的 {2} 倍（位于 {3}）", "{1} {2}-mal zu groß bei {3}"}},
    {{"{1} <2> times too large", "{1} 为允许值的 {2} 倍", "{1} {2}-mal zu groß"}},
    {{"{1} <2> at {3}", "{1} {2}，位于 {3}", "{1} {2} bei {3}"}},
    {{"{1} <2> at [3]", "{1} {2}，位于 {3}", "{1} {2} bei {3}"}},
    {{"{1} at {2}", "{1}，位于 {2}", "{1} bei {2}"}},
    {{"{1} at [2]", "{1}，位于 {2}", "{1} bei {2}"}},
    {{"{1} m ([2])", "{1} m（{2}）", "{1} m ({2})"}},
    {{"{1} on [2]", "{1}（{2}）", "{1} auf {2}"}},
    {{"{1} <2>", "{1} {2}", "{1} {2}"}},
};

/* clang-format on */
const int words_rows_n = sizeof words_rows / sizeof *words_rows;
