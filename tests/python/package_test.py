"""The package as such: documented, typed, quick to import."""

import ast
import base64
import csv
import hashlib
import inspect
import json
import os
import pathlib
import subprocess
import sys
import tomllib
import unittest
import zipfile

import plastica
from plastica import _core
from support import ROOT, TestCase, command

sys.path.insert(0, str(ROOT / "python" / "tools"))
import wheel_backend  # noqa: E402


def public():
    return {name: getattr(plastica, name) for name in plastica.__all__ if name != "__version__"}


class Package(TestCase):
    def test_all_that_is_public_is_documented(self):
        for name, thing in public().items():
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing):
                continue
            for member, value in vars(thing).items():
                if member.startswith("_") or not (callable(value) or isinstance(value, property)):
                    continue
                if member in ("group", "probe_names"):
                    continue  # what they are, their names say
                self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")

    def test_every_field_of_the_engine_has_an_attribute(self):
        tables = {"material.hardening": plastica.Hardening, "material.rate": plastica.Rate,
                  "material": plastica.Material, "section": plastica.Section,
                  "beam": plastica.Beam, "rules": plastica.Rules, "solver": plastica.Solver,
                  "drive": plastica.Drive}
        for field in _core.fields():
            table, _, name = field["path"].rpartition(".")
            if table == "gravity":
                continue  # Scene.gravity has all three
            self.assertIn(name, tables[table]._attributes(), field["path"])

    def test_the_version_is_the_command_s(self):
        self.assertIn(plastica.__version__, command("--version"))
        text = (ROOT / "CMakeLists.txt").read_text()
        self.assertIn(f"VERSION {plastica.__version__}", text)

    def test_types_are_strict(self):
        done = subprocess.run(
            [sys.executable, "-m", "mypy", "--config-file", ROOT / "pyproject.toml", "-p", "plastica",
             "--cache-dir", self.folder], capture_output=True, text=True,
            cwd=f"{plastica.__path__[0]}/..")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_types_are_strict_in_the_notebooks_too(self):
        for path in sorted((ROOT / "python" / "notebooks").glob("*.ipynb")):
            cells = json.loads(path.read_text())["cells"]
            code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
            (self.folder / f"{path.stem}.py").write_text("\n\n".join(code) + "\n")
        done = subprocess.run(
            [sys.executable, "-m", "mypy", "--config-file", ROOT / "pyproject.toml",
             "--cache-dir", self.folder / "cache", *sorted(self.folder.glob("*.py"))],
            capture_output=True, text=True,
            env={**os.environ, "MYPYPATH": str(pathlib.Path(plastica.__path__[0]).parent)})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_stub_has_what_the_module_has(self):
        stub = ast.parse((pathlib.Path(plastica.__path__[0]) / "_core.pyi").read_text())
        classes = {each.name: each for each in stub.body if isinstance(each, ast.ClassDef)}

        def members(one):
            own = {each.name for each in one.body if isinstance(each, ast.FunctionDef)}
            for base in one.bases:
                own |= members(classes[base.id]) if base.id in classes else set()
            return {name for name in own if not name.startswith("__")}
        functions = {each.name for each in stub.body if isinstance(each, ast.FunctionDef)}
        there = {name: thing for name, thing in vars(_core).items() if not name.startswith("_")}
        self.assertEqual(functions, {name for name, thing in there.items()
                                     if not inspect.isclass(thing)})
        for name, thing in there.items():
            if inspect.isclass(thing):
                own = {member for member in vars(thing) if not member.startswith("_")}
                self.assertEqual(members(classes[name]), own, name)

    def test_import_takes_numpy_alone(self):
        text = "import sys, plastica; print([m for m in ('pandas', 'matplotlib', 'scipy') if m in sys.modules])"
        done = subprocess.run([sys.executable, "-B", "-c", text], capture_output=True, text=True)
        self.assertEqual(done.stdout, "[]\n", done.stderr)

    def test_a_wheel_holds_the_package_and_is_as_it_says(self):
        wheel_backend.build_package = lambda: pathlib.Path(plastica.__path__[0])
        name = wheel_backend.build_wheel(self.folder)
        place = self.folder / "site"
        with zipfile.ZipFile(self.folder / name) as wheel:
            wheel.extractall(place)
            info = f"plastica-{plastica.__version__}.dist-info"
            rows = list(csv.reader(wheel.read(f"{info}/RECORD").decode().splitlines()))
            self.assertEqual({row[0] for row in rows}, set(wheel.namelist()))
            for path, digest, size in rows[:-1]:
                content = wheel.read(path)
                sha = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode()
                self.assertEqual((digest, int(size)), (f"sha256={sha.rstrip('=')}", len(content)))
        text = "import plastica; print(plastica.__file__, plastica.simulate)"
        done = subprocess.run([sys.executable, "-B", "-c", text], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(place)})
        self.assertTrue(done.stdout.startswith(str(place)), done.stderr)

    def test_the_wheel_s_metadata_are_the_project_s(self):
        project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
        self.assertEqual(wheel_backend.version(), plastica.__version__)
        self.assertIn(f"Name: {project['name']}\nVersion: {plastica.__version__}\n",
                      wheel_backend.metadata())
        self.assertRegex(wheel_backend.tag(), r"^cp3\d+-cp3\d+-linux_\w+$")

    def test_errors_are_value_errors_that_can_be_pickled(self):
        import pickle
        error = plastica.InputError("a.toml", 3, "beam.length", "1", "needs a unit")
        self.assertIsInstance(error, ValueError)
        self.assertEqual(str(error), "a.toml:3: beam.length = 1: needs a unit")
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((again.line, str(again)), (3, str(error)))


if __name__ == "__main__":
    unittest.main()
