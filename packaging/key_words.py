"""What each key of a case means, as C: io/case/key_words.c from the tables of docs/case-format.md, of which a test knows
that they have every key. Mock-up units, the schema and whoever reads them show the same words as the documentation.

Usage: key_words.py SOURCE_DIR [--check]
"""
import pathlib
import re
import sys

HEAD = """/* Made by packaging/key_words.py of docs/case-format.md; not to be edited. */
#include <stdio.h>
#include <string.h>

#include "io/case/schema.h"

/* By section and name, in the order of strcmp. */
static const struct {
    const char *key, *meaning;
} rows[] = {
"""
TAIL = """};

const char *case_key_meaning(const CaseSection *section, const CaseKey *key)
{
    char path[CASE_FORM_MAX];
    size_t first = 0, end = sizeof rows / sizeof *rows;
    snprintf(path, sizeof path, "%s.%s", section->path, key->name);
    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        const int order = strcmp(path, rows[middle].key);
        if (order == 0) return rows[middle].meaning;
        if (order < 0) end = middle;
        if (order > 0) first = middle + 1;
    }
    return "";
}
"""


def plain(text):
    """Markdown without its marks: links by their words, code without back ticks."""
    text = re.sub(r"\s*\(\[[^\]]*\.md\]\([^)]*\)\)", "", text)  # "(see [x.md](x.md))" says nothing without the file
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return text.replace("`", "").replace("\\|", "|").strip()


def rows(text):
    section = None
    for line in text[text.index("\n## Keys\n"):].split("\n"):
        if line.startswith("### "):
            section = line[4:].strip("`").replace("The whole case", "")
        row = re.match(r"\| `([^`]+)` \|.*\| (.*) \|$", line)
        if row and section is not None:
            yield f"{section}.{row.group(1)}", plain(row.group(2))


def main(source, check=None):
    source = pathlib.Path(source)
    table = sorted(set(rows((source / "docs/case-format.md").read_text(encoding="utf-8"))), key=lambda r: r[0].encode())
    lines = []
    for key, meaning in table:
        quoted = meaning.replace("\\", "\\\\").replace('"', '\\"')
        lines.append(f'    {{"{key}", "{quoted}"}},\n')
    text = HEAD + "    /* clang-format off */\n" + "".join(lines) + "    /* clang-format on */\n" + TAIL
    path = source / "io/case/key_words.c"
    if check is None:
        path.write_text(text, encoding="utf-8")
        return 0
    if path.exists() and path.read_text(encoding="utf-8") == text:
        print("key_words: fine")
        return 0
    print("io/case/key_words.c does not follow docs/case-format.md: python3 packaging/key_words.py .")
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
