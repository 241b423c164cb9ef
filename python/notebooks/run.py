#!/usr/bin/env python3
"""Runs the notebooks of this folder, as a test: each cell must run, and its assertions hold.

    run.py [--write] [NOTEBOOK …]

The kernel is the Python that runs this script, with its environment: PYTHONPATH says where plastica
is. A line for each notebook; exit status 1 and the traceback of the failing cell if one fails.
--write stores the outputs in the notebook, without execution counts, times or names of machines; what
warns is not stored.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
import tempfile
import time
from pathlib import Path

import nbformat
from jupyter_client.kernelspec import KernelSpec
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

FOLDER = Path(__file__).resolve().parent
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


class OwnKernel(AsyncKernelManager):
    """A kernel of this very Python, whatever a kernelspec "python3" of the user names."""

    @property
    def kernel_spec(self) -> KernelSpec:
        return KernelSpec(
            argv=[sys.executable, "-Xfrozen_modules=off",  # or its debugger warns
                  "-m", "ipykernel_launcher", "-f", "{connection_file}"],
            display_name="Python 3", language="python")


def run(notebook: nbformat.NotebookNode) -> list[str]:
    """Runs a notebook; its outputs are then in it. Returns what was written to stderr."""
    client = NotebookClient(notebook, kernel_manager_class=OwnKernel, kernel_name="python3",
                            timeout=300, resources={"metadata": {"path": str(FOLDER)}},
                            record_timing=False)
    client.execute()
    return [output["text"].strip() for cell in notebook.cells for output in cell.get("outputs", ())
            if output["output_type"] == "stream" and output["name"] == "stderr"]


def strip(notebook: nbformat.NotebookNode) -> None:
    """Takes out all that differs from run to run."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        cell.metadata = nbformat.from_dict({})
        if cell.cell_type != "code":
            continue
        cell.execution_count = None
        for output in cell.outputs:
            if "execution_count" in output:
                output.execution_count = None
            if "metadata" in output:
                output.metadata = nbformat.from_dict({})


def main() -> int:
    parser = argparse.ArgumentParser(description="Run the notebooks of this folder, as a test.")
    parser.add_argument("notebooks", nargs="*", metavar="NOTEBOOK", help="default: all")
    parser.add_argument("--write", action="store_true", help="store the outputs in the notebooks")
    asked = parser.parse_args()
    paths = [Path(name) if Path(name).is_file() else FOLDER / name
             for name in asked.notebooks] or sorted(FOLDER.glob("*.ipynb"))
    missing = [str(path) for path in paths if not path.is_file()]
    if missing or not paths:
        print(f"run.py: no notebook: {', '.join(missing) or FOLDER}", file=sys.stderr)
        return 1
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        os.environ["IPYTHONDIR"] = folder  # startup files and history of the user are not ours
        os.environ.pop("MPLBACKEND", None)  # figures go into the notebook
        for path in paths:
            notebook = nbformat.read(path, as_version=4)
            begin = time.perf_counter()
            try:
                warned = run(notebook)
                reason = ""
            except CellExecutionError as error:
                warned, reason = [], re.sub(r"\x1b\[[0-9;]*m", "", str(error))  # colours
            except Exception as error:  # the kernel died, or took too long
                warned, reason = [], f"{type(error).__name__}: {error}"
            if not reason and warned and asked.write:
                reason = "not written, since it warns:\n" + "\n".join(warned)
            seconds = time.perf_counter() - begin
            print(f"{path.name}: {'failed' if reason else 'passed'}, {seconds:.1f} s", flush=True)
            if reason:
                failed += 1
                print(reason, file=sys.stderr, flush=True)
                continue
            for text in warned:
                print(f"  warns: {text}", flush=True)
            if asked.write:
                strip(notebook)
                nbformat.validate(notebook)
                nbformat.write(notebook, path)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
