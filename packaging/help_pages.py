"""The manual page, the shells' completions and docs/reference/commands.md, from the program's --help.

Usage: help_pages.py PROGRAM FOLDER [--check]
  writes hawser.1, hawser.bash and _hawser into FOLDER, and ../docs/reference/commands.md beside it; with --check compares
  instead and exits with 1 if one is old.
"""
import argparse
import pathlib
import re
import subprocess
import sys

OPTION = re.compile(r"^ {2,6}(?:(-\w), )?(--[\w-]+)(?: ([A-Z]+))?  +(\S.*)$")
COMMAND = re.compile(r"^  ([a-z]+) +(\S.*)$")
# What may follow an option, by the name that its help gives to the value; beside them words, "files" or "folders".
VALUES = {"FILE": "files", "DIR": "folders", "FORMAT": "table json csv", "UNITS": "si us", "N": "1 2",
          "KIND": "auto block bordered klu", "UNIT": "mm m ft", "AXIS": "y z", "MB": "", "S": "", "LENGTH": "", "STATION": "",
          "SHARE": "1% 0.5% 2%", "P": "5% 10% 20%", "WAY": "length start", "X": "", "VERSION": "2 3", "KEY": "", "KEYS": "", "NAME": "", "NAMES": "all facts pieces limits heads sections", "LAYER": "", "TEXT": ""}
# What a command is about, by the first word of its usage.
SUBJECTS = {"CASE": "*.yaml", "STUDY": "*.yaml", "JOB": "*.yaml", "[CASE]": "*.yaml", "FILE": "*", "RESULTS": "/", "RESULTS|CASE": "*", "[KIND": "cables ropes rollers ducts friction reels", "[WHAT]": "case study job summary",
            "[options]": ""}


class Option:
    def __init__(self, short, name, value, text):
        self.short, self.name, self.value, self.text = short, name, value, [text]

    def words(self):
        """What may follow it."""
        own = {"--fmi": "2 3", "--effort": "6 20 60"}
        return own[self.name] if self.name in own else VALUES.get(self.value, "")


class Help:
    """A command's help taken apart: usage, paragraphs before the options, the options, paragraphs after them."""

    def __init__(self, name, text):
        self.name, self.usage, self.before, self.options, self.after = name, "", [], [], []
        paragraphs = text.replace("--set KEY=VALUE", "--set KEY").rstrip("\n").split("\n\n")
        self.usage = paragraphs[0].removeprefix("Usage: ")
        for paragraph in paragraphs[1:]:
            lines = paragraph.split("\n")
            if OPTION.match(lines[0]):
                self.take_options(lines)
            else:
                (self.after if self.options else self.before).append(" ".join(line.strip() for line in lines))

    def take_options(self, lines):
        for line in lines:
            begun = OPTION.match(line)
            if begun:
                self.options.append(Option(*begun.groups()))
            else:
                self.options[-1].text.append(line.strip())

    def subject(self):
        words = self.usage.split()
        return SUBJECTS[words[2]]


def ask(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


def read_program(program):
    """(what it says of itself, version, {command: summary}, [Help])"""
    top = ask(program, "--help")
    about = top.split("\n\n")[1].removesuffix("\nCommands:")
    commands = dict(m.groups() for m in map(COMMAND.match, top.split("\n")) if m)
    return about, ask(program, "--version").split()[1], commands, [Help(c, ask(program, c, "--help")) for c in commands]


# ---------------------------------------------------------------------------------------------- the manual page


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in ".'" else text


def roff_option(option):
    names = ", ".join("\\fB%s\\fR" % roff(n) for n in (option.short, option.name) if n)
    value = " \\fI%s\\fR" % ("KEY=VALUE" if option.value == "KEY" else option.value) if option.value else ""
    return f".TP\n{names}{value}\n{roff(' '.join(option.text))}\n"


def manual(about, version, commands, helps):
    page = [f'.TH HAWSER 1 "" "hawser {version}" "User Commands"\n.SH NAME\n'
            "hawser \\- simulates how a power cable is pulled\n.SH SYNOPSIS\n"]
    for h in helps:
        page.append(f".B {roff(' '.join(h.usage.split()[:2]))}\n{roff(' '.join(h.usage.split()[2:]))}\n.br\n")
    page.append(f".SH DESCRIPTION\n{roff(about)}\n.SH COMMANDS\n")
    for h in helps:
        page.append(f".SS {h.name}\n{roff(commands[h.name][:1].upper() + commands[h.name][1:])}.\n")
        page.extend(f".PP\n{roff(p)}\n" for p in h.before)
        page.extend(roff_option(o) for o in h.options if o.name not in ("--help", "--version"))
        page.extend(f".PP\n{roff(p)}\n" for p in h.after)
    page.append(".SH OPTIONS OF EVERY COMMAND\n")
    page.extend(roff_option(o) for o in helps[0].options if o.name in ("--help", "--version"))
    page.append(".SH ENVIRONMENT\n.TP\n.B HAWSER_LIBRARY\nthe folder with the catalogue of cables, ropes, rollers, ducts "
                "friction and reels\n.TP\n.B HAWSER_ISA\nthe instruction set of the kernels: generic, avx2 or avx512\n"
                ".TP\n.B SOURCE_DATE_EPOCH\na report carries this time, in s since 1970, in place of that of its making\n"
                ".SH SEE ALSO\nThe documents are in share/doc/hawser/docs: the format of cases in case\\-format.md, a first "
                "pull in guide/first\\-pull.md; example cases in share/doc/hawser/cases.\n")
    return "".join(page)


def cell(text):
    return text.replace("|", "\\|")


def reference(commands, helps):
    """Every command with its options as tables, in Markdown."""
    page = ["# Commands\n\nThis page is made from `hawser COMMAND --help`. `hawser --version` prints the version.\n"]
    for h in helps:
        page.append(f"\n## {h.name}\n\n{commands[h.name][:1].upper() + commands[h.name][1:]}.\n\n```\n{h.usage}\n```\n")
        page.extend(f"\n{paragraph}\n" for paragraph in h.before)
        page.append("\n| option | meaning |\n|---|---|\n")
        for o in h.options:
            value = " KEY=VALUE" if o.value == "KEY" else f" {o.value}" if o.value else ""
            names = ", ".join(f"`{name}{value}`" for name in (o.short, o.name) if name)
            page.append(f"| {names} | {cell(' '.join(o.text))} |\n")
        page.extend(f"\n{paragraph}\n" for paragraph in h.after)
    return "".join(page)


# ---------------------------------------------------------------------------------------------- completions


def bash(commands, helps):
    cases = []
    for h in helps:
        words = " ".join(o.name for o in h.options)
        values = {}
        for o in h.options:
            if o.value:
                values.setdefault(o.words(), []).extend(n for n in (o.short, o.name) if n)
        arms = "".join(f"        {'|'.join(names)}) _hawser_offer '{what}' ;;\n" for what, names in values.items())
        cases.append(f"""    {h.name})
        case $previous in
{arms}        *) _hawser_word '{words}' '{h.subject()}' ;;
        esac
        ;;
""")
    return f"""# Completion of hawser's command line for bash. Written by packaging/help_pages.py: do not edit.

# _hawser_offer WHAT: files, folders, or one of the words.
_hawser_offer() {{
    case $1 in
    files) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    folders | /) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    *.yaml) mapfile -t COMPREPLY < <(compgen -f -X '!*.yaml' -- "$current"; compgen -d -- "$current") ;;
    '*') mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current") ;;
    esac
    [[ $1 != files && $1 != folders && $1 != / && $1 != *'*'* ]] || compopt -o filenames 2>/dev/null
}}

# _hawser_word OPTIONS SUBJECT: an option where one is begun, else what the command is about.
_hawser_word() {{
    if [[ $current == -* ]]; then _hawser_offer "$1"; else _hawser_offer "$2"; fi
}}

_hawser() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
    COMPREPLY=()
    if [[ $COMP_CWORD -eq 1 ]]; then
        _hawser_offer '{' '.join(commands)} help --help --version'
        return
    fi
    case ${{COMP_WORDS[1]}} in
    help) _hawser_offer '{' '.join(commands)}' ;;
{''.join(cases)}    esac
}}
complete -F _hawser hawser
"""


def zsh_quote(text):
    return text.replace("'", "'\\''").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def zsh_action(what):
    if what in ("folders", "/"):
        return "_files -/"
    if what in ("files", "*"):
        return "_files"
    return '_files -g "*.yaml"' if what == "*.yaml" else f"({what})" if what else " "


def zsh(commands, helps):
    list_of = "\n".join(f"        '{c}:{zsh_quote(text)}'" for c, text in commands.items())
    cases = []
    for h in helps:
        lines = []
        for o in h.options:
            value = f":{o.value.lower()}:{zsh_action(o.words())}" if o.value else ""
            lines.extend(f"        '{n}[{zsh_quote(o.text[0])}]{value}'" for n in (o.short, o.name) if n)
        lines.append(f"        '*:{h.usage.split()[2].strip('[').lower()}:{zsh_action(h.subject())}'")
        cases.append(f"    {h.name})\n        _arguments \\\n" + " \\\n".join(lines) + "\n        ;;\n")
    return f"""#compdef hawser
# Completion of hawser's command line for zsh. Written by packaging/help_pages.py: do not edit.

local -a commands
commands=(
{list_of}
)
if (( CURRENT == 2 )); then
    _describe command commands
    return
fi
local command=$words[2]
shift words
(( CURRENT-- ))
case $command in
{''.join(cases)}esac
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    args = parser.parse_args()
    about, version, commands, helps = read_program(args.program)
    pages = {"hawser.1": manual(about, version, commands, helps), "hawser.bash": bash(commands, helps),
             "_hawser": zsh(commands, helps), "../docs/reference/commands.md": reference(commands, helps)}
    old = [n for n, text in pages.items() if not (args.folder / n).exists() or (args.folder / n).read_text() != text]
    if args.check:
        for name in old:
            print(f"{args.folder / name} is not what --help says: write it with packaging/help_pages.py")
        return 1 if old else 0
    for name in old:
        (args.folder / name).write_text(pages[name])
    return 0


if __name__ == "__main__":
    sys.exit(main())
