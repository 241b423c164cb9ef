"""What the tests of pages share: a browser, and a case that has the command write pages and looks at
them. Arguments: COMMAND DATA
"""

import atexit
import html.parser
import json
import os
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

COMMAND, DATA = (os.path.abspath(path) for path in sys.argv[1:3])
HOSTILE = "a<script>alert(1)</script>\"'&<b>"
# Points of curves that the axes leave out.
POINTS_OUTSIDE = """(() => {
  drawAll();
  return [...charts].flatMap((chart) => {
    const { left, right, top, bottom } = chart.chartArea;
    return chart.data.datasets.flatMap((set) => set.data.filter((point) => {
      if (point.x === null || point.y === null) return false;
      const x = chart.scales.x.getPixelForValue(point.x);
      const y = chart.scales.y.getPixelForValue(point.y);
      return x < left - 1 || x > right + 1 || y < top - 1 || y > bottom + 1;
    }).map((point) => [set.label, point.x, point.y])).slice(0, 3);
  });
})()"""
# What the pattern "tabs" of the WAI-ARIA Authoring Practices asks for and the page lacks, canvases
# without a name, and heads that sort without saying so.
NOT_ACCESSIBLE = """(() => {
  const lacks = [];
  const expect = (holds, what) => { if (!holds) lacks.push(what); };
  const lists = document.querySelectorAll('[role=tablist]');
  expect(lists.length === 1 && lists[0].getAttribute('aria-label'), 'the list of tabs has no name');
  const tabs = [...lists[0].children];
  const chosen = tabs.filter((tab) => tab.getAttribute('aria-selected') === 'true');
  expect(chosen.length === 1, 'not one tab is chosen');
  for (const tab of tabs) {
    const panel = document.getElementById(tab.getAttribute('aria-controls'));
    expect(tab.getAttribute('role') === 'tab' && tab.id, 'a tab is none');
    expect(panel?.getAttribute('role') === 'tabpanel', 'a tab controls no panel');
    expect(tab.tabIndex === (tab === chosen[0] ? 0 : -1), 'a tab that is not chosen takes the focus');
    expect(['true', 'false'].includes(tab.getAttribute('aria-selected')), 'a tab says not whether');
  }
  expect(new Set(tabs.map((tab) => tab.id)).size === tabs.length, 'tabs share a name');
  const panels = document.querySelectorAll('[role=tabpanel]');
  expect(panels.length === 1 && panels[0].getAttribute('aria-labelledby') === chosen[0].id,
    'the panel is not named by its tab');
  for (const canvas of document.querySelectorAll('canvas')) {
    expect(canvas.getAttribute('role') === 'img' && canvas.getAttribute('aria-label')?.trim(),
      'a canvas has no name');
  }
  for (const head of document.querySelectorAll('.sorts th')) {
    expect(['none', 'ascending', 'descending'].includes(head.getAttribute('aria-sort')), 'a head');
  }
  return lacks;
})()"""
browser = Browser()
atexit.register(browser.close)


class Elements(html.parser.HTMLParser):
    """The elements of a page before its scripts have run, and the data that it holds."""

    def __init__(self, text):
        super().__init__()
        self.names = []
        self.addresses = []
        self.scripts = []
        self.data = None
        self.holds_data = False
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.names.append(tag)
        self.addresses += [attrs[name] for name in ("src", "href") if name in attrs]
        self.holds_data = attrs.get("id") == "data"

    def handle_data(self, data):
        if self.holds_data:
            self.data = json.loads(data)

    def handle_endtag(self, tag):
        self.holds_data = False


class Report(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        browser.complaints.clear()

    def path(self, name):
        return os.path.join(self.scratch.name, name)

    def run_command(self, *words, code=0):
        done = subprocess.run([COMMAND, *words], capture_output=True, text=True,
                              cwd=self.scratch.name)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def report(self, result, *words):
        """Writes the page. @return its path"""
        page = self.path("page.html")
        self.run_command("report", result, "-o", page, "--force", *words)
        return self.take(page)

    def take(self, page):
        """Reads the data of a page, which asks for nothing. @return its path"""
        with open(page, encoding="utf-8") as file:
            elements = Elements(file.read())
        self.assertEqual(elements.addresses, [])
        self.assertEqual(elements.names.count("script"), 3)
        self.data = elements.data
        return page

    def look_at_all(self, page):
        """Opens each tab and the first details, wide and narrow, light and dark."""
        for width, dark in ((1600, False), (400, True)):
            browser.open(page, width, 900, dark)
            hashes = [f"tab={i}" for i in range(len(self.data["tabs"]))]
            hashes += [f"detail={i}" for i in range(min(3, len(self.data["details"])))]
            for where in hashes:
                browser.evaluate(f"location.hash = '{where}'")
                browser.settle()
                wide = browser.evaluate("document.documentElement.scrollWidth")
                self.assertLessEqual(wide, width, where)  # nothing stands out at the side
                self.assertGreater(browser.evaluate("document.querySelector('main').innerText.length"),
                                   20, where)
                self.assertEqual(browser.evaluate(POINTS_OUTSIDE), [], where)
                self.assertEqual(browser.evaluate(NOT_ACCESSIBLE), [], where)
        self.assertEqual(browser.complaints, [])
        others = [url for url in browser.requests if not url.startswith(("file://", "data:"))]
        self.assertEqual(others, [])

    def texts(self, selector):
        return browser.evaluate("[...document.querySelectorAll(" + json.dumps(selector) +
                                ")].map((element) => element.innerText)")

    def show(self, where):
        browser.evaluate(f"location.hash = '{where}'")
        browser.settle()

    def drawn(self, selector):
        """How many pixels of a canvas are not empty."""
        return browser.evaluate(
            "(() => { const c = document.querySelector(" + json.dumps(selector) + ");"
            "const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            "let n = 0; for (let i = 3; i < d.length; i += 4) n += d[i] > 0; return n; })()")

    def blue(self, selector):
        """How many pixels of a canvas have the colour of the first curve."""
        return browser.evaluate(
            "(() => { const c = document.querySelector(" + json.dumps(selector) + ");"
            "const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            "let n = 0; for (let i = 0; i < d.length; i += 4) n += d[i + 3] > 128 && d[i] < 60 &&"
            "Math.abs(d[i + 1] - 114) < 40 && Math.abs(d[i + 2] - 178) < 40; return n; })()")

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def change(self, name, old, new):
        text = self.read(name)
        self.assertIn(old, text)
        self.write(name, text.replace(old, new))

    def refused(self, *words):
        """A call that is refused in one line, and leaves all files as they were. @return the line"""
        def files():
            return {name: self.read(name) for name in sorted(os.listdir(self.scratch.name))}
        before = files()
        said = self.run_command(*words, code=2).stderr
        self.assertEqual(said.count("\n"), 1)
        self.assertEqual(files(), before)
        return said

    def rows(self):
        """The cells of the first table, by the names of its heads without their units."""
        heads = [head.split(" [")[0] for head in self.texts(".sorts th")]
        return [dict(zip(heads, row.split("\t"), strict=True)) for row in self.texts(".sorts tbody tr")]
