"""The public headers and their comments. As a program it is Doxygen's input filter, which reads /** and /**< alone: each comment becomes
one of those, a comment above several functions stands above each. Usage: header.py FILE"""
import re
import sys

FUNCTION = re.compile(r"^(?!typedef|#)([\w ]+?[ *]+)(hawser_\w+)\(([^;{}]*)\);[ \t]*(?:/\*(.*?)\*/)?", re.M | re.S)


def plain(comment):
    return re.sub(r"\s*\n\s*\*?\s*", " ", comment or "").strip()


def comment_before(text, at):
    """The comment that ends right above a declaration, or above those that stand right above it."""
    above = text[:at].rstrip("\n")
    if text[len(above):at].count("\n") > 1:
        return ""
    if above.endswith("*/"):
        return plain(above[above.rfind("/*") + 2:-2])
    earlier = [m for m in FUNCTION.finditer(text) if m.end() <= at and not text[m.end():at].strip()]
    here = FUNCTION.match(text, at)
    if earlier:  # what is said of one that fails is not said of one that gives a value
        return comment_before(text, earlier[-1].start()) if here and here[1] == earlier[-1][1] else ""
    define = re.search(r"(?:^|\n)(#define [^\n]*(?:\\\n[^\n]*)*|typedef [^;{}]*;|enum [^;]*;)$", above)
    return comment_before(text, define.start(1)) if define else ""


def repeated(text):
    """Functions right below another one, with the comment that they share."""
    for m in reversed(list(FUNCTION.finditer(text))):
        above = text[:m.start()].rstrip("\n")
        told = "" if above.endswith("*/") else comment_before(text, m.start())
        if told:
            text = f"{text[:m.start()]}/* {told} */\n{text[m.start():]}"
    return text


def for_doxygen(text):
    text = re.sub(r"^/\* -{20,}.*?\*/$", "", text, flags=re.M | re.S)  # lines between the parts of a header
    text = repeated(text).replace('extern "C" {', "")
    text = re.sub(r"^typedef (struct|enum) (\w+) \{(.*?)^\} \2;", r"\1 \2 {\3};", text, flags=re.M | re.S)  # one thing, not two of one name
    text = re.sub(r"^typedef (enum) (\w+) (\{[^{}]*\}) \2;", r"\1 \2 \3;", text, flags=re.M)
    text = re.sub(r"`([^`\n]+)`", r"<tt>\1</tt>", text)
    text = re.sub(r"\A/\* ", "/** @file\n * ", text)
    text = re.sub(r"(^[ \t]*)/\* ", r"\1/** ", text, flags=re.M)
    return re.sub(r"(?<=[;,{}\w])([ \t]+)/\* ", r"\1/**< ", text)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.write(for_doxygen(file.read()))
