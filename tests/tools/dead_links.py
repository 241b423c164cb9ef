"""Relative links of the pages (Markdown): each leads to a file or folder that git tracks, and one
with a #part to a heading of that page."""

import posixpath
import re

FENCED = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.M | re.S)
COMMENT = re.compile(r"<!--.*?-->", re.S)
INLINE_CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)")
OUTSIDE = re.compile(r"[a-z][a-z0-9+.-]*:", re.I)
HEADING = re.compile(r"^#{1,6}[ \t]+(.+?)[ \t]*#*$", re.M)


def blanked(text, pattern):
    """The text without what the pattern finds, and with as many lines."""
    return pattern.sub(lambda match: "\n" * match.group().count("\n"), text)


def anchors(text):
    """The #parts of a page, as GitHub makes them of its headings."""
    found, counts = set(), {}
    for heading in HEADING.findall(blanked(text, FENCED)):
        shown = re.sub(r"\]\([^)]*\)", "]", heading)
        name = re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")
        again = counts.get(name, 0)
        counts[name] = again + 1
        found.add(f"{name}-{again}" if again else name)
    return found


def links(text):
    """Line number and target of each link that stays within the repository."""
    text = blanked(blanked(blanked(text, FENCED), COMMENT), INLINE_CODE)
    for match in LINK.finditer(text):
        if not OUTSIDE.match(match.group(1)):
            yield text.count("\n", 0, match.start()) + 1, match.group(1)


def check_links(pages, files):
    """Breaches of `pages`, a dict of path → text, in a repository of `files`."""
    known = {str(path) for path in files}
    known |= {str(parent) for path in files for parent in path.parents}
    parts = {str(path): anchors(text) for path, text in pages.items()}
    for path, text in sorted(pages.items()):
        for line, target in links(text):
            name, _, part = target.partition("#")
            place = posixpath.normpath(posixpath.join(str(path.parent), name)) if name else str(path)
            if place not in known:
                yield f"{path}:{line}: the link {target} leads nowhere"
            elif part and part not in parts.get(place, ()):
                yield f"{path}:{line}: the link {target} leads to no heading of {place}"
