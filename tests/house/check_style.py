"""The language of documents written by hand: short sentences, and the glossary's terms.

Usage: check_style.py ROOT [FILE...]     (FILE: only these, with their figures)
       check_style.py ROOT --words       (prints the words of the whole and of each page, the largest first)
Sentences have at most 30 words, on average 18 in a document. Words of code and of tables do not count. Words that
docs/glossary.md replaces do not occur. README and docs/ have at most 70 000 words in all, tables and code included. Pages that a
script makes, as their first lines say, do not count, nor what scripts write between markers, nor the glossary and the examples.
"""
import glob
import os
import re
import sys

import tree

DOCUMENTS = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "docs/*.md", "docs/guide/*.md", "docs/theory/*.md", "docs/reference/*.md",
             "bench/README.md")
GENERATED = "This page is made"  # within a page's first paragraphs
MARKED = re.compile(r"<!-- (.*?): begin -->.*?<!-- \1: end -->", re.S)
APART = {"docs/glossary.md", "docs/examples.md"}
LONGEST, MEAN, WORDS = 30, 18, 70000
# What grew in the house, and the term for it: only what is nothing else in ordinary English.
TERMS = {r"\bbunch(es)?\b": "chains", r"\bborne\b": "carried, supported", r"\bturners?\b": "bend", r"\bleaf bod(y|ies)\b": "condensed bodies",
         r"\b(is|are) (told|asked|wanted|looked at)\b": "given, required, requested, inspected", r"\bon the site\b": "at the works",
         r"\bprogram (says|asks|wants|tells)\b": "prints, requires", r"\b(it|which) (says|asks|wants|tells)\b": "prints, requires"}


def sentences(text):
    """[(line, words)] of the running text."""
    def blank(m):
        return "\n" * m.group(0).count("\n")
    text = re.sub(r"^```.*?^```|<!--.*?-->", blank, text, flags=re.M | re.S)
    text = re.sub(r"^(\|| {4}|#).*$", "", text, flags=re.M)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`", "x", text)
    found = []
    for m in re.finditer(r"(?:[^\n]|\n(?!\s*\n|\s*[-*] |\s*\d+\. ))+", text):
        at = m.start()
        for part in re.split(r"(?<=[.!?:;])\s+(?=[A-Z\"*(x])", m.group(0)):
            words = re.findall(r"[A-Za-z][\w'-]*", part)
            if len(words) > 1:
                found.append((text.count("\n", 0, at) + 1, words, part))
            at += len(part) + 1
    return found


def pages(root):
    """{path: text} of the documents that people write."""
    names = sorted({os.path.relpath(p, root) for pattern in DOCUMENTS for p in glob.glob(os.path.join(root, pattern))})
    texts = {name: tree.read(root, name) for name in names}
    return {name: text for name, text in texts.items() if GENERATED not in text.split("\n## ")[0]}


def counted(texts):
    """[(words, path)] of those that count, the largest first."""
    return sorted(((len(MARKED.sub("", text).split()), name) for name, text in texts.items()
                   if name == "README.md" or name.startswith("docs/") and name not in APART), reverse=True)


def check(root, names=()):
    complaints, texts = [], {name: tree.read(root, name) for name in names} or pages(root)
    for name, text in texts.items():
        all_of = sentences(text)
        complaints += [f"{name}:{line}: a sentence of {len(words)} words: {' '.join(words[:8])} ..." for line, words, _ in all_of if len(words) > LONGEST]
        mean = sum(len(words) for _, words, _ in all_of) / max(1, len(all_of))
        if mean > MEAN:
            complaints.append(f"{name}: sentences have {mean:.1f} words on average")
        if names:
            print(f"{name}: {len(text.split())} words, {len(all_of)} sentences, {mean:.1f} words each")
        for line, _, part in all_of:
            complaints += [f"{name}:{line}: '{m.group(0)}': write {term}" for pattern, term in TERMS.items() for m in [re.search(pattern, part)] if m]
    return complaints


def check_words(found):
    total = sum(n for n, _ in found)
    return [f"documents: {total} words, of at most {WORDS}: shorten as much as you add"] if total > WORDS else []


def main():
    root, names = sys.argv[1], sys.argv[2:]
    if names == ["--words"]:
        found = counted(pages(root))
        print("\n".join(f"{n:6} {name}" for n, name in [(sum(n for n, _ in found), "all"), *found]))
        return 0
    return tree.report("style", check(root, names) + ([] if names else check_words(counted(pages(root)))))


if __name__ == "__main__":
    sys.exit(main())
