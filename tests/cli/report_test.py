#!/usr/bin/env python3
"""`plastica report`: pages that a browser opens without a complaint and without a network, and that
show the numbers of the result's JSON summary.

report_test.py COMMAND DATA
"""

import json
import os
import re
import sys
import unittest

from web_report import DATA, HOSTILE, Report, browser


def distance(point, line):
    """Of a point from a line of straight pieces."""
    least = float("inf")
    for (ax, ay), (bx, by) in zip(line, line[1:]):
        u, v = bx - ax, by - ay
        length = u * u + v * v
        at = ((point[0] - ax) * u + (point[1] - ay) * v) / length if length else 0.0
        at = min(1.0, max(0.0, at))
        least = min(least, ((point[0] - ax - at * u) ** 2 + (point[1] - ay - at * v) ** 2) ** 0.5)
    return least


class Fits(Report):
    def setUp(self):
        super().setUp()
        self.result = self.path("fit.h5")
        self.run_command("calibrate", os.path.join(DATA, "fits/demo.toml"), "-o", self.result,
                         "--json", self.path("fit.json"))
        with open(self.path("fit.json"), encoding="utf-8") as file:
            self.summary = json.load(file)

    def test_the_table_has_the_summary_s_numbers(self):
        page = self.report(self.result)
        self.look_at_all(page)
        browser.open(page)
        heads = self.texts("th")
        column = next(i for i, head in enumerate(heads) if head.startswith("yield_stress"))
        self.assertIn("[MPa]", heads[column])
        fits = self.summary["fits"]
        for row, fit in zip(self.texts("tbody tr"), fits, strict=True):
            cells = row.split("\t")
            self.assertEqual(cells[0], fit["name"])
            value = fit["parameters"]["yield_stress"]["value"] / 1e6
            self.assertAlmostEqual(float(cells[column]), value, delta=1e-4 * value)

    def test_sorts_and_filters(self):
        page = self.report(self.result)
        names = sorted((fit["name"] for fit in self.summary["fits"]),
                       key=lambda name: next(f for f in self.summary["fits"] if f["name"] == name)
                       ["parameters"]["yield_stress"]["value"])
        browser.open(page)
        column = next(i for i, head in enumerate(self.texts("th")) if head.startswith("yield_stress"))
        button = f"th:nth-child({column + 1}) button"
        browser.click(button)
        self.assertEqual(self.texts("tbody td:first-child"), names)
        browser.click(button)
        self.assertEqual(self.texts("tbody td:first-child"), names[::-1])

    def filtered(self, text):
        browser.evaluate("(() => { const input = document.querySelector('input');"
                         f"input.value = {json.dumps(text)};"
                         "input.dispatchEvent(new Event('input')); })()")
        return self.texts("tbody td:first-child")

    def test_filters(self):
        self.run_command("calibrate", os.path.join(DATA, "fits/demo.toml"), "-o", self.path("l.h5"),
                         "--laws", "ideal,voce", "--json", self.path("l.json"))
        with open(self.path("l.json"), encoding="utf-8") as file:
            fits = json.load(file)["fits"]
        browser.open(self.report(self.path("l.h5")))

        def names(holds):
            return sorted(fit["name"] for fit in fits if holds(fit))

        for text, holds in (
                ("law = voce", lambda fit: fit["law"] == "voce"),
                ("temperature_C > 100", lambda fit: float(fit["group"]["temperature_C"]) > 100),
                ("temperature_C = 20, s355", lambda fit: fit["name"] == "s355"),
                ("misfit < 2", lambda fit: 100 * fit["misfit_fraction"] < 2),
                ("poor", lambda fit: fit["misfit_word"] == "poor")):
            with self.subTest(text):
                found = self.filtered(text)
                self.assertEqual(sorted(found), names(holds))
                self.assertGreater(len(found), 0)
                if text != "poor":
                    self.assertLess(len(found), len(fits))
        self.assertEqual(self.filtered("mispelt > 3"), [])
        self.assertIn("no column mispelt", self.texts(".count")[0])
        self.assertEqual(self.filtered("misfit > much"), [])
        self.assertIn("no number", self.texts(".count")[0])
        kept = self.filtered("law = voce")
        browser.click("tbody a")
        first = self.texts("main h1")
        browser.press("j")
        self.assertEqual(self.texts("main h1"), [kept[1] + ":voce"])
        browser.press("k")
        self.assertEqual(self.texts("main h1"), first)
        browser.press("Escape")
        self.assertEqual(self.texts("tbody td:first-child"), kept)

    def test_intervals_have_the_confidence_of_the_fit(self):
        fit = self.write("f.toml", "[fit]\nconfidence = 0.5\n[[target]]\n"
                         f"files = '{os.path.join(DATA, 'targets/al6061-t6.csv')}'\ntest = 'tension'\n"
                         "strain = { column = 'Strain' }\nstress = { column = 'Stress' }\n")
        self.run_command("calibrate", fit, "-o", self.path("f.h5"))
        browser.open(self.report(self.path("f.h5")))
        browser.click("tbody a")
        self.assertIn("50 % from", self.texts("th"))
        self.assertTrue(any("50 % interval" in text for text in self.texts("pre")))
        self.assertFalse(any("95 %" in text for text in self.texts("pre, th")))

    def test_prints_all_in_light(self):
        browser.open(self.report(self.result), dark=True)
        browser.evaluate("location.hash = 'detail=0'")
        browser.settle()
        browser.evaluate("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(browser.evaluate("themeColor('--scheme')"), "light")
        self.assertEqual(browser.evaluate("notSeenYet.size"), 0)
        browser.evaluate("dispatchEvent(new Event('afterprint'))")
        self.assertEqual(browser.evaluate("themeColor('--scheme')"), "dark")

    def test_a_row_opens_the_specimen(self):
        page = self.report(self.result)
        browser.open(page)
        browser.click("tbody tr:nth-child(2) td:nth-child(4)")
        self.assertEqual(self.texts("main h1"), [self.summary["fits"][1]["name"]])
        self.assertEqual(browser.evaluate("document.activeElement.tagName"), "MAIN")
        drawn = self.blue("main canvas")
        browser.evaluate("(() => { const chart = Chart.getChart(document.querySelector('main canvas'));"
                         "for (const set of chart.data.datasets) set.data = []; chart.update('none'); })()")
        self.assertGreater(drawn, 3 * self.blue("main canvas") + 300)  # without its curves
        browser.press("j")
        self.assertEqual(self.texts("main h1"), [self.summary["fits"][2]["name"]])
        browser.press("Escape")
        self.assertEqual(len(self.texts("tbody tr")), len(self.summary["fits"]))

    def test_curves_are_those_of_the_file(self):
        page = self.report(self.result)
        browser.open(page)
        with open(os.path.join(DATA, "targets/al6061-t6.csv"), encoding="utf-8") as file:
            lines = [line.split(",") for line in file if re.match(r"[-\d.]", line)]
        measured = [(float(line[0]), float(line[1])) for line in lines]
        curve = browser.evaluate(
            "(() => { const panel = report.details[0].blocks.find((b) => b.kind === 'figure').panels[0];"
            "return unpack(panel.curves[0].points); })()")
        strains, stresses = zip(*measured)
        # The files' units are not looked at: what is known is the largest strain and stress.
        x_scale, y_scale = 16.47 / max(strains), 326.5 / max(stresses)
        line = list(zip(*curve))
        for strain, stress in measured:
            self.assertLess(distance((x_scale * strain / 16.47, y_scale * stress / 326.5),
                                     [(x / 16.47, y / 326.5) for x, y in line]), 0.001)

    def test_hostile_names_stay_texts(self):
        curve = self.write("c.csv", "name,strain,stress [MPa]\n" + "".join(
            '"%s",%g,%g\n' % (HOSTILE.replace('"', '""'), 0.0002 * i, min(40.0 * i, 400.0))
            for i in range(60)))
        fit = self.write("f.toml", "# </script><script>alert(2)</script>\n"
                         "[[target]]\nfiles = 'c.csv'\nsplit = 'name'\ntest = 'tension'\n"
                         "strain = { column = 'strain' }\nstress = { column = 'stress' }\n")
        self.assertTrue(os.path.exists(curve))
        self.run_command("calibrate", fit, "-o", self.path("h.h5"))
        page = self.report(self.path("h.h5"))
        self.look_at_all(page)
        browser.open(page)
        name = self.texts("tbody td:first-child")[0]
        self.assertIn("<script>", name)
        browser.click("tbody a")
        self.assertIn("<script>", self.texts("main h1")[0])
        self.assertEqual(browser.evaluate("document.querySelectorAll('main script, main b').length"), 0)
        browser.evaluate(f"location.hash = 'tab={len(self.data['tabs']) - 1}'")
        browser.settle()
        self.assertTrue(any("</script>" in text for text in self.texts("pre")))

    def test_bad_calls_have_a_line(self):
        self.write("there.html", "mine")
        said = self.run_command("report", self.result, "-o", self.path("there.html"), code=2).stderr
        self.assertIn("there.html", said)
        with open(self.path("there.html"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")
        said = self.run_command("report", self.result, "-o", self.result, "--force", code=2).stderr
        self.assertEqual(said.count("\n"), 1)
        said = self.run_command("report", os.path.join(DATA, "fits/demo.toml"), code=2).stderr
        self.assertEqual(said.count("\n"), 1)


class OtherResults(Report):
    def test_a_motion_is_played_and_turned(self):
        self.run_command("simulate", os.path.join(DATA, "scenes/crash_bumper.toml"), "-o",
                         self.path("s.h5"))
        page = self.report(self.path("s.h5"))
        self.look_at_all(page)
        browser.open(page)
        canvas = ".beam > canvas"
        self.assertGreater(self.drawn(canvas), 2000)
        end = browser.evaluate(f"document.querySelector('{canvas}').toDataURL()")
        browser.evaluate("(() => { const s = document.querySelector('.time input');"
                         "s.value = 0; s.dispatchEvent(new Event('input')); })()")
        browser.settle()
        start = browser.evaluate(f"document.querySelector('{canvas}').toDataURL()")
        self.assertNotEqual(start, end)
        self.assertEqual(self.texts(".time .count"), ["0 ms"])
        # The table behind the moments is that of the frame.
        browser.evaluate("document.querySelectorAll('.beam details').forEach((d) => { d.open = true; })")
        browser.settle()
        at_start = self.texts(".beam figure:first-child td")
        browser.evaluate("(() => { const s = document.querySelector('.time input');"
                         "s.value = 40; s.dispatchEvent(new Event('input')); })()")
        browser.settle()
        self.assertNotEqual(self.texts(".beam figure:first-child td"), at_start)
        browser.evaluate("(() => { const s = document.querySelector('.time input');"
                         "s.value = 0; s.dispatchEvent(new Event('input')); })()")
        browser.settle()
        browser.evaluate(f"document.querySelector('{canvas}').focus()")
        browser.press("ArrowUp")
        self.assertNotEqual(browser.evaluate(f"document.querySelector('{canvas}').toDataURL()"),
                            start)
        browser.click(".time button")
        browser.evaluate("new Promise((done) => setTimeout(done, 400))")
        self.assertNotEqual(self.texts(".time .count"), ["0 ms"])

    def test_paths_coupons_and_sweeps(self):
        for scene in ("bend_and_release", "bathe_bolourchi_45", "profile_limit_load"):
            with self.subTest(scene):
                self.run_command("simulate", os.path.join(DATA, f"scenes/{scene}.toml"), "-o",
                                 self.path(scene + ".h5"))
                self.look_at_all(self.report(self.path(scene + ".h5")))
        self.run_command("sweep", os.path.join(DATA, "sweeps/cantilever_deflection.toml"), "-o",
                         self.path("w.h5"))
        page = self.report(self.path("w.h5"))
        self.look_at_all(page)
        browser.open(page)
        browser.click("tbody a")
        self.assertIn("Case 1", self.texts("main h1")[0])
        sweep = self.write("words.toml", f"name = 'error of words'\nscene = '{DATA}/scenes/cantilever.toml'\n"
                           "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n"
                           "[error]\nprobe = 'tip'\n")
        self.run_command("sweep", sweep, "-o", self.path("words.h5"))
        page = self.report(self.path("words.h5"))
        self.look_at_all(page)
        self.assertIn("2 cases", self.data["lines"][0])
        browser.open(page)
        browser.evaluate("location.hash = 'tab=1'")
        browser.settle()
        self.assertEqual(browser.evaluate(
            "[...charts][0].scales.x.ticks.map((tick) => tick.label)"), ["half_joint", "equal"])

    def test_fits_through_scenes(self):
        self.run_command("calibrate", os.path.join(DATA, "fits/bend_test.toml"), "-o",
                         self.path("b.h5"))
        self.look_at_all(self.report(self.path("b.h5")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
