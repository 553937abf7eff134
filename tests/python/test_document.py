"""The examples of docs/guide/python.md run as they stand there, one after the other, and print what stands under them."""
from __future__ import annotations

import contextlib
import io
import re

import pytest
from conftest import ROOT

BLOCK = re.compile(r"^```(python|text)\n(.*?)^```$", re.M | re.S)


NUMBER = re.compile(r"-?\d+\.?\d*")


def alike(said: str, written: str) -> bool:
    """The same words, and numbers within 5 %: the last digits of a run may change with the solver."""
    numbers = [[float(n) for n in NUMBER.findall(text)] for text in (said, written)]
    words = [NUMBER.sub("0", text).split() for text in (said, written)]
    return words[0] == words[1] and numbers[0] == pytest.approx(numbers[1], rel=0.05, abs=0.05)


def test_the_examples(monkeypatch):
    monkeypatch.chdir(ROOT)
    text = (ROOT / "docs" / "guide" / "python.md").read_text()
    scope: dict[str, object] = {"__name__": "document"}
    said, compared = None, 0
    for block in BLOCK.finditer(text):
        kind, content = block.groups()
        line = text.count("\n", 0, block.start()) + 1
        if kind == "python":
            assert not said, f"what the example before line {line} prints does not stand there: {said}"
            with contextlib.redirect_stdout(io.StringIO()) as out:
                exec(compile("\n" * line + content, "docs/guide/python.md", "exec"), scope)
            said = out.getvalue()
        else:
            assert said and alike(said, content), f"docs/guide/python.md:{line}: prints\n{said}"
            said, compared = None, compared + 1
    assert compared >= 6


def test_what_the_document_names_is_there():
    import hawser

    text = (ROOT / "docs" / "guide" / "python.md").read_text()
    for name in set(re.findall(r"\bhawser\.(\w+)", text)) - {"yaml"}:
        assert hasattr(hawser, name), name
    things = {**vars(hawser.Simulation), **vars(hawser.Simulation.__mro__[1]), **vars(hawser.Result), **vars(hawser.Verdict), **vars(hawser.Certificate),
              **vars(hawser.Study), **vars(hawser.Theory), **vars(hawser.Job)}
    for name in set(re.findall(r"`\.(\w+)", text)):
        assert name in things or name in ("facts", "certified", "result", "t", "segment"), name


if __name__ == "__main__":
    pytest.main([__file__])
