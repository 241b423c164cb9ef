#!/usr/bin/env python3
"""The pages that `check` and `stability` write by `--report`: the numbers are those that the commands
print, and write into other files.

report_option_test.py COMMAND DATA
"""

import csv
import json
import os
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

from web_report import COMMAND, DATA, HOSTILE, Report, browser


class WrittenByCommands(Report):
    def refuses_bad_pages(self, command, source, option, other):
        """The rules that `--report` shares with the other output of a command."""
        self.write("there.html", "mine")
        for words, rule in (
                ((command, source, "--report", "there.html"), "there.html: exists already"),
                ((command, source, "--report", source, "--force"), "is a file that this run reads"),
                ((command, source, "--report", "page.txt"), "must end in .html: it is a page"),
                ((command, source, "--report", "none/page.html"), "none"),
                ((command, source, option, other, "--report", other, "--force"),
                 "is the output, too" if other.endswith(".html") else "must end in .html")):
            with self.subTest(words):
                self.assertIn(rule, self.refused(*words))


class Claims(WrittenByCommands):
    def setUp(self):
        super().setUp()
        self.run_command("init", "check")

    def test_the_table_has_what_the_command_prints(self):
        self.change("check.toml", '"0.05 %" }', '"0.01 %" }')
        self.change("check.toml", '"no case takes more than 3 000 segment-iterations"',
                    json.dumps(HOSTILE))
        self.change("check.toml", "# Claims", "# </script><script>alert(2)</script> Claims")
        printed = self.run_command("check", "check.toml", "--junit", "out.xml", "--report",
                                   "page.html", code=1)
        self.assertIn("wrote page.html\n", printed.stderr)
        page = self.take(self.path("page.html"))
        self.look_at_all(page)
        browser.open(page)
        self.assertEqual(self.data["lines"], [printed.stdout.splitlines()[-1]])
        cases = ElementTree.parse(self.path("out.xml")).findall(".//testcase")
        lines = printed.stdout.splitlines()[1:-1]
        found = self.rows()
        for row, case, line in zip(found, cases, lines, strict=True):
            fails = case.find("failure") is not None
            self.assertEqual(row["claim"], case.get("name"))
            self.assertEqual(row["verdict"], "does not hold" if fails else "holds")
            self.assertTrue(line.startswith("  FAIL  " if fails else "  PASS  "))
            kind = row["what"].split(" of ")[0]
            self.assertIn(f"{kind} {row['seen']}", line)
            self.assertTrue(line.split(";")[1 if fails else 0].endswith(row["limit"]), line)
            self.assertEqual(row["file"], "check.toml")
            self.assertEqual(row["about"], "sweep sweep.toml")
            self.assertAlmostEqual(float(row["time"]), float(case.get("time")), delta=6e-4)
        self.assertEqual([row["verdict"] for row in found], ["holds", "does not hold", "holds"])
        self.assertIn("tip, end -0.735525 m", found[1]["remark"])
        self.assertEqual(browser.evaluate("document.querySelectorAll('main script, main b').length"), 0)
        self.show(f"tab={len(self.data['tabs']) - 1}")
        self.assertEqual([text for text in self.texts("pre")][0].strip(),
                         self.read("check.toml").strip())
        self.assertIn(self.read("sweep.toml").strip(), [text.strip() for text in self.texts("pre")])
        self.assertIn("plastica check check.toml" if COMMAND == "plastica" else "check check.toml",
                      self.texts("dd")[0])

    def test_a_claim_opens_with_the_worst_of_its_numbers(self):
        self.run_command("check", "check.toml", "--report", "page.html")
        self.run_command("sweep", "sweep.toml", "-o", "s.h5", "--json", "s.json", "--quiet")
        cases = json.loads(self.read("s.json"))["cases"]
        half = [case for case in cases if case["axes"]["rules.end_rule"] == "half_joint"]
        page = self.take(self.path("page.html"))
        browser.open(page)
        browser.click("tbody tr:nth-child(2) td:nth-child(3)")
        self.assertEqual(self.texts("main h1"), ["forty segments are within 0.05 %"])
        errors = sorted((abs(100 * case["error"]) for case in half
                         if case["axes"]["beam.segments"] >= 40), reverse=True)
        self.assertEqual([float(row["seen"].split()[0]) for row in self.rows()],
                         [float(f"{error:.4g}") for error in errors])
        self.assertTrue(any(text.startswith("  PASS  forty") for text in self.texts("pre")))
        # The order's errors, over the number of segments.
        self.show("detail=0")
        points = browser.evaluate("unpack(report.details[0].blocks.find((b) => b.kind === 'figure')"
                                  ".panels[0].curves[0].points)")
        for segments, error, case in zip(*points, half, strict=True):
            self.assertAlmostEqual(segments / case["axes"]["beam.segments"], 1.0, delta=1e-3)
            self.assertAlmostEqual(error / abs(100 * case["error"]), 1.0, delta=1e-3)

    def test_failures_of_scenes_and_fits_have_their_rows(self):
        self.write("check.toml", "[[claim]]\nname = 'no fit'\n"
                   f"fit = '{DATA}/fits/demo.toml'\nmisfit = {{ at_most = '2 %' }}\n"
                   "[[claim]]\nname = 'the tip'\nscene = 'cantilever.toml'\nprobe = 'tip'\n"
                   "value = { at_least = '-1 m' }\n")
        self.run_command("check", "check.toml", "--report", "page.html", "--quiet", code=1)
        self.run_command("calibrate", f"{DATA}/fits/demo.toml", "-o", "f.h5", "--json", "f.json",
                         "--quiet")
        fits = sorted(json.loads(self.read("f.json"))["fits"], key=lambda fit: -fit["misfit_fraction"])
        page = self.take(self.path("page.html"))
        self.look_at_all(page)
        browser.open(page)
        self.show("detail=0")
        found = self.rows()
        self.assertEqual([row["of"] for row in found], [fit["name"] for fit in fits])
        for row, fit in zip(found, fits):
            self.assertEqual(row["seen"], f"{100 * fit['misfit_fraction']:.4g} %")

    def test_bad_pages_are_refused_before_anything_runs(self):
        self.refuses_bad_pages("check", "check.toml", "--junit", "out.html")
        self.assertIn("reads", self.refused("check", "check.toml", "--report", "sweep.toml", "--force"))
        self.run_command("check", "check.toml", "--report", "new.html", "--dry-run")
        self.assertFalse(os.path.exists(self.path("new.html")))

    def test_what_was_judged_before_an_interruption_is_on_the_page(self):
        run = subprocess.Popen([COMMAND, "check", "check.toml", f"{DATA}/checks/motion.toml",
                                "--report", "page.html"], cwd=self.scratch.name, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for _ in range(4):
            run.stdout.readline()
        run.send_signal(signal.SIGINT)
        run.stdout.read()
        run.stdout.close()
        self.assertEqual(run.wait(), 130)
        page = self.take(self.path("page.html"))
        self.assertEqual(self.data["lines"][1], "interrupted: 1 of 2 files were judged")
        browser.open(page)
        self.assertEqual(len(self.rows()), 3)


class Scans(WrittenByCommands):
    VARIED = ("--vary", "beam.segments,scale.loads", "--reach", "10")

    def setUp(self):
        super().setUp()
        self.run_command("init", "sweep")

    def scan(self, *words, code=0):
        done = self.run_command("stability", "cantilever.toml", *words, "--report", "page.html",
                                code=code)
        self.assertIn("wrote page.html\n", done.stderr)
        return done.stdout, self.take(self.path("page.html"))

    def test_tables_have_what_the_command_prints_and_writes(self):
        self.change("cantilever.toml", "[beam]", f"name = {json.dumps(HOSTILE)}\n[beam]")
        printed, page = self.scan(*self.VARIED, "--within", "1 %", "-o", "points.csv")
        self.look_at_all(page)
        browser.open(page)
        self.assertEqual(self.texts("header h1"), [HOSTILE])
        lines = printed.splitlines()
        for row in self.rows():
            at = next(i for i, line in enumerate(lines) if line.split()[:1] == [row["field"]])
            self.assertEqual(lines[at].split()[-3:], [row["from"], row["value"], row["to"]])
            below = " ".join(lines[at + 1:at + 5])
            for why in (row["below that"], row["above that"]):
                self.assertIn(why.split(":")[0], below)
        self.assertEqual([row["field"] for row in self.rows()], ["beam.segments", "scale.loads"])
        with open(self.path("points.csv"), encoding="utf-8", newline="") as file:
            points = list(csv.DictReader(file))
        browser.open(page)
        self.show("tab=2")
        self.assertEqual(browser.evaluate("document.querySelectorAll('main script, main b').length"), 0)
        for row, point in zip(self.rows(), points, strict=True):
            self.assertEqual(row["point"], point["id"])
            self.assertEqual(row["field"], point["axis"])
            for name in ("verdict", "reason", "status", "level", "analysis"):
                self.assertEqual(row[name], point[name])
            if point["value"]:
                self.assertAlmostEqual(float(row["value"]) / float(point["value"]), 1.0, delta=1e-4)
        self.assertIn("inaccurate", {point["verdict"] for point in points})

    def test_pictures_tell_verdicts_apart_by_their_symbols(self):
        _, page = self.scan(*self.VARIED, "--within", "1 %", "-o", "points.csv", "--map", "m.gp")
        self.look_at_all(page)
        with open(self.path("points.csv"), encoding="utf-8", newline="") as file:
            points = list(csv.DictReader(file))
        pairs = [point for point in points if point["axis_2"]]
        self.assertGreater(len(pairs), 20)
        browser.open(page)
        self.show("tab=1")
        browser.evaluate("drawAll()")
        sets = browser.evaluate(
            "[...document.querySelectorAll('figure canvas')].map((canvas) => Chart.getChart(canvas).data"
            ".datasets.map((set) => [set.label, set.data.length, set.pointStyle, set.showLine]))")
        self.assertEqual(len(sets), 3)
        for number, panel in enumerate(sets):
            shown = {label: count for label, count, _, line in panel if line is False}
            styles = [style for _, _, style, line in panel if line is False]
            self.assertEqual(len(set(styles)), len(styles))
            field = (None, "beam.segments", "scale.loads")[number]
            for word in ("valid", "inaccurate"):
                expected = [point for point in (pairs if field is None else points)
                            if point["verdict"] == word and
                            (field is None or point["axis"] in ("", field) and not point["axis_2"])]
                self.assertEqual(shown.get(word, 0), len(expected), (number, word))
            self.assertEqual(shown.get("the scene's own"), 1 if field is None else None)
        values = browser.evaluate(
            "report.tabs[1].blocks[0].panels[0].curves.slice(1).flatMap((curve) =>"
            "{ const [x, y] = unpack(curve.points); return x.map((v, i) => [v, y[i]]); })")
        told = sorted((float(point["value"]), float(point["value_2"])) for point in pairs)
        for (x, y), (a, b) in zip(sorted(values), told, strict=True):
            self.assertAlmostEqual(x / a, 1.0, delta=2e-3)

    def test_an_interrupted_scan_has_its_points_and_says_so(self):
        for delay in (1.0, 4.0, 16.0):  # one machine takes longer than another for the first point
            run = subprocess.Popen([COMMAND, "stability", "cantilever.toml", "--max-work", "1e6",
                                    "--report", "page.html", "--force"], cwd=self.scratch.name,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            time.sleep(delay)
            run.send_signal(signal.SIGINT)
            said = run.communicate()[1]
            self.assertEqual(run.returncode, 130, said)
            if os.path.exists(self.path("page.html")):
                break
        page = self.take(self.path("page.html"))
        self.look_at_all(page)
        self.assertEqual(self.data["lines"][2], "interrupted: fields were not followed to their ends")
        self.assertEqual([tab["name"] for tab in self.data["tabs"]], ["Fields", "Points", "Provenance"])
        self.assertIn(f"interrupted after {len(self.data['tabs'][1]['blocks'][0]['rows'])} point", said)
        self.assertNotIn("lost", said)

    def test_a_scene_that_is_not_valid_has_a_page(self):
        self.change("cantilever.toml", "segments = 32", "segments = 2")
        printed, page = self.scan(*self.VARIED, code=1)
        self.look_at_all(page)
        self.assertIn("own values inaccurate: ", self.data["lines"][0])
        self.assertIn("own values  inaccurate: ", printed)

    def test_bad_pages_are_refused_before_anything_runs(self):
        self.refuses_bad_pages("stability", "cantilever.toml", "-o", "out.csv")


if __name__ == "__main__":
    unittest.main(argv=["report_option_test.py"])
