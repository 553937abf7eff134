"""Tables that scripts write into documents, between the markers `<!-- NAME: begin -->` and `<!-- NAME: end -->`."""


def replace_between(text, name, new):
    """The text with what stands between the markers of that name replaced."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    if text.count(begin) != 1 or text.count(end) != 1 or text.index(begin) > text.index(end):
        raise ValueError(f"needs the lines {begin} and {end}, once each")
    return text[:text.index(begin) + len(begin)] + "\n\n" + new.strip("\n") + "\n\n" + text[text.index(end):]


def replace_in_file(path, tables):
    """replace_between in a file, in place; tables: {name: new}."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for name, new in tables.items():
        text = replace_between(text, name, new)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
