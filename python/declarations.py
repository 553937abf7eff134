"""What cffi is told of the C interface: taken from the public headers, never copied by hand.

The headers are C of a narrow kind: comments, guards, `extern "C"`, then enums, structs, typedefs and functions. What cffi does not
read, the preprocessor's lines, is carried out or cut out here; everything else goes to it word for word. Comments become the
docstrings of the members that they stand beside.
"""
from __future__ import annotations

import hashlib
import pathlib
import re

MAIN = "hawser/hawser.h"
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](hawser/[^">]+)[">]', re.M)
FOR_CPLUSPLUS = re.compile(r"^[ \t]*#[ \t]*ifdef[ \t]+__cplusplus.*?^[ \t]*#[ \t]*endif[^\n]*$", re.M | re.S)
# A function that the headers offer under another name, with a size that the compiler knows: cffi calls it as C does.
OFFERED = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(hawser_\w+)\(([^)]*)\)(?:[ \t]|\\\n)+(hawser_\w+)\((.*)\)[ \t]*$", re.M)
NUMBER = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(HAWSER_\w+)[ \t]+-?\d+[ \t]*$", re.M)
PREPROCESSOR = re.compile(r"^[ \t]*#(?![ \t]*define HAWSER_\w+ \.\.\.$)(?:[^\n]*\\\n)*[^\n]*$", re.M)
FUNCTION = re.compile(r"\b(hawser_\w+)\s*\([^;{}()]*(?:\([^()]*\)[^;{}()]*)*\)\s*;")
STRUCT = re.compile(r"^typedef struct (\w+) \{$(.*?)^\} \1;", re.M | re.S)
MEMBER = re.compile(r"([^;/]+);[ \t]*(?:/\*(.*?)\*/)?", re.S)
NAME = re.compile(r"(\w+)(?:\[\w+\])?\s*(?:,|$)")


def unfolded(include: pathlib.Path) -> str:
    """The main header with every header that it includes in its place, each once, as the preprocessor would have it;
    comments stay."""
    seen: set[str] = set()

    def text_of(name: str) -> str:
        if name in seen:
            return ""
        seen.add(name)
        return INCLUDE.sub(lambda m: text_of(m.group(1)), (include / name).read_text(encoding="utf-8"))

    return text_of(MAIN)


def offered(text: str) -> str:
    """Prototypes of the functions that are macros: those that they stand for, without the sizes that they fill in."""
    found = ""
    for name, _, target, arguments in OFFERED.findall(text):
        prototype = re.search(rf"^([^#\n;]*?)\b{target}\s*\(([^;]*)\)\s*;", text, re.M)
        if prototype:
            kept = [parameter.strip() for parameter, argument in zip(prototype.group(2).split(","), arguments.split(", "))
                    if "sizeof" not in argument]
            found += f"{prototype.group(1)}{name}({', '.join(kept)});\n"
    return found


def declarations(include: pathlib.Path) -> str:
    """What cffi reads."""
    text = FOR_CPLUSPLUS.sub("", COMMENT.sub(" ", unfolded(include)))
    text += offered(text)
    text = NUMBER.sub(r"#define \1 ...", text)
    return re.sub(r"\s*\n\s*\n+", "\n", PREPROCESSOR.sub("", text)).strip() + "\n"


def functions(text: str) -> list[str]:
    """Names of the functions that declarations hold, in their order; pointers to functions are none."""
    return FUNCTION.findall(re.sub(r"typedef[^;{}]*\(\*[^;]*;", "", text))


def members(include: pathlib.Path) -> dict[str, dict[str, str]]:
    """{struct: {member: its comment}}; "" of those that have none."""
    found = {}
    for struct in STRUCT.finditer(unfolded(include)):
        told = found[struct.group(1)] = {}
        for declared, comment in MEMBER.findall(struct.group(2)):
            told.update(dict.fromkeys(NAME.findall(declared), re.sub(r"\s*\n\s*\*?\s*", " ", comment).strip()))
    return found


def digest(include: pathlib.Path) -> str:
    """Of the declarations: the same where nothing but comments and white space differ."""
    return hashlib.sha256(" ".join(declarations(include).split()).encode()).hexdigest()
