"""The language of documents written by hand: short sentences, and the glossary's terms.

Usage: check_style.py ROOT [FILE...]     (FILE: only these, with their figures)
Sentences have at most 30 words, on average 18 in a document. Words of code and of tables do not count. Words that
docs/glossary.md replaces do not occur.
"""
import glob
import os
import re
import sys

import tree

DOCUMENTS = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "docs/*.md", "docs/guide/*.md", "docs/theory/*.md", "docs/reference/*.md",
             "bench/README.md")
GENERATED = {"docs/validation-tables.md", "docs/reference/case-keys.md", "docs/reference/codes.md", "docs/reference/columns.md",
             "docs/reference/commands.md", "docs/reference/study-keys.md"}
LONGEST, MEAN = 30, 18
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


def check(root, names=()):
    complaints = []
    for name in names or sorted({os.path.relpath(p, root) for pattern in DOCUMENTS for p in glob.glob(os.path.join(root, pattern))} - GENERATED):
        text = tree.read(root, name)
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


if __name__ == "__main__":
    sys.exit(tree.report("style", check(sys.argv[1], sys.argv[2:])))
