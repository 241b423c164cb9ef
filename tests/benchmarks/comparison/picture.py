"""The picture of docs/speed.md: a falling cantilever within 0.5 %, in ours, in others, and as the
machine could do it."""

import html
import math

from . import report
from .rows import LIMIT_STEPS

OURS, LIMIT, OTHERS = "#0072B2", "#333333", "#E69F00"
LEFT, WIDTH, RIGHT = 260, 470, 80
BAR, GAP, TOP, BOTTOM = 17, 7, 34, 46
DECADES = (-4, 1)  # of seconds


def _limit(rows, against):
    """Seconds of the limit program for one scenario."""
    per_step = next(row["other"] for row in rows if row["against"] == against)
    return None if per_step is None else LIMIT_STEPS * per_step


def bars(rows):
    """(heading, [(label, seconds, color)]) of the plane and of space; what was not measured has no
    bar."""
    one, batch = ([row for row in rows if row["group"].startswith(begin)]
                  for begin in ("falling cantilever, one", "falling cantilever, a batch"))
    panels = []
    for level in ("planar", "spatial"):
        of_level = [row for row in one if row["what"] == level]
        together = next(row for row in batch if row["what"] == f"{level}, one model")
        panel = [("Plastica, eight at a time", together["figure"], OURS),
                 ("Plastica", of_level[0]["figure"], OURS)]
        if level == "planar":
            panel[:0] = [("limit, eight at a time", _limit(rows, "limit_step, 8 lanes"), LIMIT)]
            panel.insert(2, ("limit", _limit(rows, "limit_step, order 2"), LIMIT))
        panel += [(row["against"], row["other"], OTHERS) for row in of_level]
        panels.append((f"{level}: seconds a scenario, one core",
                       sorted((bar for bar in panel if bar[1] is not None),
                              key=lambda bar: bar[1])))
    return panels


def _across(seconds):
    begin, end = DECADES
    return LEFT + WIDTH * (math.log10(seconds) - begin) / (end - begin)


def svg(kept):
    parts = []
    y = 0

    def text(x, at, words, anchor="start", weight="normal"):
        parts.append(f'<text x="{x:.1f}" y="{at:.1f}" text-anchor="{anchor}" '
                     f'font-weight="{weight}">{html.escape(words)}</text>')

    for heading, panel in bars(kept["rows"]):
        text(12, y + 22, heading, weight="bold")
        bottom = y + TOP + len(panel) * (BAR + GAP)
        for decade in range(DECADES[0], DECADES[1] + 1):
            x = _across(10.0**decade)
            parts.append(f'<line x1="{x:.1f}" y1="{y + TOP - 4}" x2="{x:.1f}" y2="{bottom}" '
                         'stroke="#cccccc"/>')
            text(x, bottom + 16, report.quantity(10.0**decade, "s"), "middle")
        for i, (label, seconds, color) in enumerate(panel):
            at = y + TOP + i * (BAR + GAP)
            end = _across(seconds)
            text(LEFT - 8, at + BAR - 4, label, "end")
            parts.append(f'<rect x="{LEFT}" y="{at}" width="{end - LEFT:.1f}" height="{BAR}" '
                         f'fill="{color}"/>')
            text(end + 6, at + BAR - 4, report.quantity(seconds, "s"))
        y = bottom + BOTTOM
    width, height = LEFT + WIDTH + RIGHT, y - 18
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")
