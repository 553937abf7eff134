/* The table of texts: its rows are whole, and all that limits, conditions and codes are called has one. */
#include <stdio.h>
#include <string.h>

#include "def/limits.h"
#include "io/results/words.h"
#include "tests/support/check.h"

/* How often "1" stands as a mark in a text; other languages have all marks in braces. */
static int marks(const char *text, char digit, const char *opening)
{
    int n = 0;
    for (const char *p = text; *p; ++p) n += strchr(opening, *p) && p[1] == digit && p[2] && strchr("}]>", p[2]);
    return n;
}

/* Every text in every language, each mark of the others once in English, and no English text twice. */
TEST(rows)
{
    assert_true(words_rows_n > 500);
    for (int k = 0; k < words_rows_n; ++k) {
        const WordsRow *const row = &words_rows[k];
        for (int l = 0; l < LANGUAGES; ++l) assert_true(row->text[l] && *row->text[l]);
        for (char digit = '1'; digit <= '9'; ++digit) {
            const int english = marks(row->text[LANGUAGE_ENGLISH], digit, "{[<");
            for (int l = LANGUAGE_ENGLISH + 1; l < LANGUAGES; ++l)
                if (english > 1 || english != marks(row->text[l], digit, "{"))
                    fail_msg("'%s': mark %c in %s", row->text[0], digit, language_tags[l]);
        }
        for (int i = 0; i < k; ++i)
            if (!strcmp(words_rows[i].text[0], row->text[0])) fail_msg("'%s' stands twice", row->text[0]);
    }
}

static void check_known(const char *english)
{
    char text[WORDS_MAX];
    for (Language l = LANGUAGE_CHINESE; l < LANGUAGES; ++l)
        if (words_in(l, english, text) != text) fail_msg("'%s' has no words in %s", english, language_tags[l]);
}

/* A new limit or a new clause of a code needs its words. */
TEST(limits_and_codes)
{
    CodeRule rule;
    char source[300];
    int codes = 0;
    for (int k = 0; k < LIMIT_KINDS; ++k) check_known(limits_name((hawser_limit_kind)k));
    for (size_t i = 0; code_row(i, &rule); ++i, ++codes) {
        allowed_say((Allowed){rule.value, rule.source, rule.code == CODE_USUAL ? CODE_TB889 : -1, rule.known}, source,
                    sizeof source);
        check_known(rule.source);
        check_known(source);
    }
    assert_true(codes > 50);
}

static void check_says(Language language, const char *english, const char *expected)
{
    char text[WORDS_MAX];
    assert_string_equal(words_in(language, english, text), expected);
}

/* Sentences are taken apart where printf has put them together; names and keys stay. */
TEST(sentences)
{
    check_says(LANGUAGE_GERMAN, "SAFE", "SICHER");
    check_says(LANGUAGE_CHINESE, "sidewall", "侧压力");
    check_says(LANGUAGE_ENGLISH, "sidewall", "sidewall");
    check_says(LANGUAGE_GERMAN, "no such text", "no such text");
    check_says(LANGUAGE_GERMAN, "limits.sidewall", "limits.sidewall");
    check_says(
        LANGUAGE_GERMAN,
        "NOT SAFE: 2 of 8 limits broken: restart by 28.3 % at 0.0 m (yard), rope by 7.77 %; 2 not judged: winch, "
        "push",
        "NICHT SICHER: 2 von 8 Grenzwerten verletzt: Anfahren um 28.3 % bei 0.0 m (yard), Seil um 7.77 %; 2 nicht "
        "beurteilt: Winde, Schub");
    check_says(LANGUAGE_CHINESE,
               "friction of at most 0.18 and at rest 0.27 where it is 0.2, elsewhere in proportion, would do; "
               "computed again: SAFE",
               "将为 0.2 处的摩擦系数降至 0.18、静摩擦系数降至 0.27，其余各处按比例即可；重新计算结论：安全");
    /* a name that is a word of the table stays a name */
    check_says(LANGUAGE_GERMAN, "end of sidewall", "Ende von sidewall");
    check_says(LANGUAGE_GERMAN,
               "fill 0.5 at \x02"
               "duct\x03; allowed 0.4: 25 % over",
               "Füllgrad 0.5 bei \x02"
               "duct\x03; zulässig 0.4: 25 % darüber");
}
