#!/usr/bin/env python3
"""Parts of pages: maps of sweeps, specimens out of line, and what keys and screen readers find.

report_parts_test.py COMMAND DATA
"""

import json
import os
import statistics
import unittest

from web_report import DATA, HOSTILE, Report, browser


class Maps(Report):
    def sweep(self, axes, more=""):
        """Runs a sweep of the shipped cantilever. @return its page, its cases of the summary"""
        text = f"name = 'grid'\nscene = '{DATA}/scenes/cantilever.toml'\n" + "".join(
            f"[[axis]]\nfield = '{field}'\nvalues = {values}\n" for field, values in axes)
        self.write("w.toml", text + (more or "[error]\nprobe = 'tip'\nagainst = 'theory:elastica'\n"))
        self.run_command("sweep", "w.toml", "-o", "w.h5", "--json", "w.json", "--quiet", "--force")
        return self.report(self.path("w.h5")), json.loads(self.read("w.json"))["cases"]

    def cells(self):
        """Text and what a pointer is told of each cell of the first map, the top row first."""
        return browser.evaluate("[...document.querySelector('table.map tbody').rows].map((row) =>"
                                "[...row.cells].slice(1).map((cell) => [cell.innerText, cell.title]))")

    def heads(self):
        return (self.texts("table.map thead tr:first-child th"), self.texts("table.map tbody th"))

    def test_cells_have_the_errors_of_the_summary(self):
        page, cases = self.sweep((("beam.segments", "[4, 8, 16, 32]"), ("scale.loads", "[0.25, 0.5, 1]")))
        self.look_at_all(page)
        browser.open(page)
        self.show("tab=1")
        columns, rows = self.heads()
        self.assertEqual(columns, ["4", "8", "16", "32"])
        self.assertEqual(rows, ["1", "0.5", "0.25"])  # upwards
        found = self.cells()
        light = {}
        for case in cases:
            x = columns.index(f"{case['axes']['beam.segments']:g}")
            y = rows.index(f"{case['axes']['scale.loads']:g}")
            text, told = found[y][x]
            error = abs(100 * case["error"])
            self.assertAlmostEqual(float(text), error, delta=0.06 * error)
            self.assertIn(f"beam.segments {case['axes']['beam.segments']:g}, ", told)
            color = browser.evaluate(
                f"document.querySelector('table.map tbody').rows[{y}].cells[{x + 1}].style.backgroundColor")
            light[error] = sum(int(part) for part in color[4:-1].split(","))
        # The larger the error the darker its cell.
        shades = [light[error] for error in sorted(light)]
        self.assertEqual(shades, sorted(shades, reverse=True))
        self.assertGreater(len(set(shades)), 2)
        browser.evaluate("document.querySelector('table.map').closest('figure')"
                         ".querySelector('details').open = true")
        browser.settle()
        told = [row.split("\t") for row in self.texts("figure details tbody tr")]
        for row, case in zip(told, cases, strict=True):
            self.assertAlmostEqual(float(row[2]) / abs(100 * case["error"]), 1.0, delta=1e-3)
        browser.click("table.map tbody tr:last-child td")
        first = next(i for i, case in enumerate(cases) if case["axes"]["beam.segments"] == 4 and
                     case["axes"]["scale.loads"] == 0.25)
        self.assertTrue(self.texts("main h1")[0].startswith(f"Case {first + 1}:"))

    def test_words_make_maps_and_failures_are_hatched(self):
        page, cases = self.sweep((("beam.segments", "[4, 8]"), ("scale.loads", "[1, 1e9]"),
                                  ("rules.end_rule", "['half_joint', 'equal']")),
                                 "[error]\nprobe = 'tip'\n")
        failed = [case for case in cases if case["value"] is None]
        self.assertGreater(len(failed), 0)
        self.look_at_all(page)
        browser.open(page)
        self.show("tab=1")
        self.assertEqual(len(self.texts("table.map")), 2)
        hatched = browser.evaluate("[...document.querySelectorAll('table.map tbody td')].filter((cell) =>"
                                   "cell.style.background.includes('gradient')).map((cell) => cell.innerText)")
        self.assertEqual(sorted(hatched), sorted(case["status"] for case in failed))

    def test_a_wide_map_has_no_numbers_but_says_them(self):
        values = str([0.025 * i for i in range(1, 41)])
        page, cases = self.sweep((("scale.loads", values), ("beam.segments", "[4, 8, 16]")))
        self.look_at_all(page)
        browser.open(page)
        self.show("tab=1")
        found = [cell for row in self.cells() for cell in row]
        self.assertEqual(len(found), len(cases))
        self.assertEqual({text for text, _ in found}, {""})
        self.assertTrue(all("%" in told for _, told in found))
        many, _ = self.sweep((("scale.loads", "[1, 2]"), ("beam.segments", "[4, 8]"),
                              ("beam.length", str([f"{i} m" for i in range(1, 11)]))),
                             "[error]\nprobe = 'tip'\n")
        browser.open(many)
        self.show("tab=1")
        self.assertEqual(self.texts("table.map"), [])
        self.assertTrue(any("--what map" in text for text in self.texts("section.note li")))


class OutOfLine(Report):
    YIELDS = [300.0, 302.0, 298.0, 301.0, 299.0, 303.0, 360.0]

    def fit(self, yields):
        """Fits curves of bars of one group that yield at so many MPa. @return the command's text"""
        rows = "".join(f"{HOSTILE.replace(chr(34), '')}{k},{0.0002 * i:g},{min(40.0 * i, stress):g}\n"
                       for k, stress in enumerate(yields) for i in range(60))
        self.write("c.csv", "name,strain,stress [MPa]\n" + rows)
        self.write("f.toml", "[[target]]\nfiles = 'c.csv'\nsplit = 'name'\ntest = 'tension'\n"
                   "strain = { column = 'strain' }\nstress = { column = 'stress' }\n")
        return self.run_command("calibrate", "f.toml", "-o", "f.h5", "--json", "f.json", "--force").stdout

    def test_names_them_and_opens_them(self):
        text = self.fit(self.YIELDS)
        fits = json.loads(self.read("f.json"))["fits"]
        page = self.report(self.path("f.h5"))
        self.look_at_all(page)
        browser.open(page)
        self.show("tab=1")
        browser.evaluate("document.querySelectorAll('section')[1].id = 'here'")
        self.assertEqual(self.texts("#here h2"), ["Specimens out of line"])
        heads = self.texts("#here th")
        found = [dict(zip(heads, row.split("\t"), strict=True)) for row in self.texts("#here tbody tr")]
        fitted = [row for row in found if row["quantity"] == "yield_stress"]
        self.assertEqual([row["specimen"] for row in fitted], [fits[6]["name"]])
        values = [fit["parameters"]["yield_stress"]["value"] / 1e6 for fit in fits]
        median = statistics.median(values)
        deviation = statistics.median(abs(value - median) for value in values)
        score = 0.6745 * (values[6] - median) / deviation
        self.assertGreater(score, 3.5)
        self.assertAlmostEqual(float(fitted[0]["value"]), values[6], delta=0.02)
        self.assertAlmostEqual(float(fitted[0]["median"]), median, delta=0.02)
        self.assertAlmostEqual(float(fitted[0]["score"]) / score, 1.0, delta=5e-3)
        self.assertIn(f"out of line: {fits[6]['name']}, yield_stress", " ".join(text.split()))
        group, = json.loads(self.read("f.json"))["groups"]
        stored, = group["parameters"]["yield_stress"]["out_of_line"]
        self.assertEqual(stored["target"], fits[6]["name"])
        self.assertAlmostEqual(stored["score"] / score, 1.0, delta=1e-9)
        browser.click("#here tbody td:nth-child(3)")
        self.assertEqual(self.texts("main h1"), [fits[6]["name"]])
        # Beside it in that table is no other specimen; back in the first table all are.
        browser.press("j")
        self.assertEqual(self.texts("main h1"), [fits[6]["name"]])
        self.show("tab=0")
        browser.click("tbody tr:nth-child(2) td:nth-child(3)")
        browser.press("j")
        self.assertEqual(self.texts("main h1"), [fits[2]["name"]])

    def test_says_nothing_of_specimens_alike_and_of_few(self):
        for yields in (self.YIELDS[:6], self.YIELDS[-4:], 6 * [300.0] + [360.0]):
            with self.subTest(yields):
                self.assertNotIn("out of line", self.fit(yields))
                self.report(self.path("f.h5"))
                blocks = self.data["tabs"][1]["blocks"]
                self.assertNotIn("Specimens out of line", [block["title"] for block in blocks])


class Tabs(Report):
    def setUp(self):
        super().setUp()
        self.run_command("simulate", os.path.join(DATA, "scenes/crash_bumper.toml"), "-o", "s.h5",
                         "--quiet")

    def test_keys_go_through_the_tabs(self):
        browser.open(self.report(self.path("s.h5")))
        names = [tab["name"] for tab in self.data["tabs"]]
        self.assertGreater(len(names), 3)
        browser.evaluate("document.querySelector('[role=tab]').focus()")
        for key, at in (("End", -1), ("ArrowRight", 0), ("ArrowLeft", -1), ("Home", 0),
                        ("ArrowRight", 1), ("x", 1)):
            browser.press(key)
            self.assertEqual(self.texts("[aria-selected=true]"), [names[at]], key)
            self.assertEqual(browser.evaluate("document.activeElement.innerText"), names[at])
            self.assertEqual(browser.evaluate(
                "document.getElementById(panel.getAttribute('aria-labelledby')).innerText"), names[at])

    def test_heads_say_how_they_sort(self):
        self.run_command("init", "check")
        self.run_command("check", "check.toml", "--report", "page.html", "--quiet")
        browser.open(self.take(self.path("page.html")))
        sorts = "[...document.querySelectorAll('.sorts th')].map((head) => head.getAttribute('aria-sort'))"
        self.assertEqual(set(browser.evaluate(sorts)), {"none"})
        for word in ("ascending", "descending"):
            browser.click("th:nth-child(1) button")
            self.assertEqual(browser.evaluate(sorts)[0], word)
            self.assertEqual(set(browser.evaluate(sorts)[1:]), {"none"})
            names = self.texts("tbody td:first-child")
            self.assertEqual(names, sorted(names, reverse=word == "descending"))


if __name__ == "__main__":
    unittest.main(argv=["report_parts_test.py"])
