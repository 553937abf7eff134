/* Prints the words of a case as a fuzzer's dictionary: every key, choice and unit that the schema knows. */
#include <stdio.h>

#include "io/case/case_parts.h"

static void print_word(const char *before, const char *word, const char *after)
{
    putchar('"');
    printf("%s", before);
    for (const char *c = word; *c; ++c) {
        const unsigned char byte = (unsigned char)*c;
        if (byte < ' ' || byte > '~' || byte == '"' || byte == '\\')
            printf("\\x%02X", (unsigned)byte);
        else
            putchar(byte);
    }
    printf("%s\"\n", after);
}

int main(void)
{
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int sections = case_sections(&case_top, all, 0);
    for (int s = 0; s < sections; ++s) {
        for (int k = 0; k < all[s]->n; ++k) {
            const CaseKey *const key = &all[s]->key[k];
            print_word("", key->name, ": ");
            for (const char *const *c = key->choices; c && *c; ++c) print_word("", *c, "");
            if (key->fallback && *key->fallback) print_word("", key->fallback, "");
        }
    }
    for (int u = 0; u < units_count(); ++u) print_word(" ", units_name(u), "");
    return 0;
}
