"""The tables, as text and for the pages."""

import re

UNITS = [(1.0, "s"), (1e-3, "ms"), (1e-6, "us"), (1e-9, "ns")]


def quantity(value, unit):
    if value is None:
        return "-"
    if unit != "s":
        return f"{value:.4g} {unit}".strip()
    for size, name in UNITS:
        if value >= size or name == "ns":
            return f"{value / size:.3g} {name}"
    return ""


def ratio(value):
    return "-" if value is None else f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def cells(row):
    return [row["what"], quantity(row["figure"], row["unit"]), row["against"],
            quantity(row["other"], row["unit"]), ratio(row["ratio"]), row["want"]]


HEAD = ["", "ours", "against", "theirs", "ratio", "goal"]


def groups(rows):
    order = list(dict.fromkeys(row["group"] for row in rows))
    return [(group, [row for row in rows if row["group"] == group]) for group in order]


def facts(kept):
    return ", ".join(kept["circumstances"][key] for key in ("machine", "compiler", "date")) \
        + f", commit {kept['circumstances']['commit']}"


def text(kept):
    table = [HEAD] + [cells(row) for row in kept["rows"]]
    widths = [max(len(row[i]) for row in table) for i in range(len(HEAD))]
    lines = []
    for group, rows in groups(kept["rows"]):
        lines.append(group)
        for row in [HEAD] + [cells(row) for row in rows]:
            shown = [cell.ljust(width) for cell, width in zip(row, widths)]
            lines.append(("  " + "  ".join(shown)).rstrip())
        lines.append("")
    lines += [f"left out: {line}" for line in kept["missing"]]
    lines += [facts(kept), kept["circumstances"]["command"]]
    return "\n".join(lines)


def markdown(kept):
    lines = [f"Measured with `{kept['circumstances']['command']}`: {facts(kept)}.", ""]
    lines += ["| " + " | ".join(HEAD) + " |", "|---|---|---|---|---|---|"]
    for group, rows in groups(kept["rows"]):
        lines.append(f"| **{group}** | | | | | |")
        lines += ["| " + " | ".join(cells(row)) + " |" for row in rows]
    if kept["missing"]:
        lines += ["", *(f"Left out: {line}.  " for line in kept["missing"])]
    return "\n".join(lines) + "\n"


def write_block(path, name, block):
    """Puts a block between `<!-- NAME -->` and `<!-- /NAME -->` of a page."""
    page = path.read_text()
    marked = re.compile(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", re.DOTALL)
    if not marked.search(page):
        raise SystemExit(f"{path} has no <!-- {name} --> … <!-- /{name} -->")
    path.write_text(marked.sub(lambda match: match.group(1) + block + match.group(2), page))
