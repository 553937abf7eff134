"""The notebooks run from beginning to end; what they find is asserted in them."""
from __future__ import annotations

import os
import sys
import warnings

import pytest
from conftest import ROOT

FOLDER = ROOT / "python" / "notebooks"


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_notebook(path):
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(path, as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "outputs are not committed"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}},
                       extra_arguments=["--HistoryManager.enabled=False"]).execute()
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.execution_count for cell in code)
    shown = [data for cell in code for output in cell.outputs for data in output.get("data", {})]
    assert "image/svg+xml" in shown or "image/png" in shown
    assert "text/html" in shown


def test_the_kernel_is_this_python(tmp_path):
    """Otherwise the notebooks would be run against another hawser."""
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("import sys, hawser; print(sys.executable, hawser.__file__)")])
    NotebookClient(notebook, timeout=60, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    executable, module = notebook.cells[0].outputs[0]["text"].split()
    assert os.path.realpath(executable) == os.path.realpath(sys.executable)
    import hawser

    assert module == hawser.__file__
