"""What the library promises: the headers that lib/plastica/README.md lists.

Installed are these, what they include, and what the installed headers of calibrate and sweeps
include; a header that is nobody's business is not. The project of tests/consumer, built against the
installed library, includes what is promised and nothing else.
"""

import re

LIST = "lib/plastica/README.md"
LISTED = re.compile(r"^\| `(plastica/[\w/*]+\.hpp)`", re.M)
OURS = re.compile(r'^#include "([^"]+)"', re.M)
OTHERS = re.compile(r"^#include <([^>]+/[^>]+|\w+\.h(?:pp)?|Eigen\w*)>", re.M)
PROMISED = re.compile(r"^#include <(plastica/[^>]+)>", re.M)
SETS = re.compile(r"PUBLIC FILE_SET HEADERS(?: BASE_DIRS \S+)?(?: FILES)?([^)]*?)(?:PRIVATE|\))")


def include_path(root, name):
    """The path of an included file in the repository; None for one that is not ours."""
    for base in ("lib", ""):
        if (root / base / name).is_file():
            return f"{base}/{name}".lstrip("/")
    return None


def closure(root, starts):
    seen, left = set(), list(starts)
    while left:
        path = left.pop()
        if path in seen:
            continue
        seen.add(path)
        names = OURS.findall((root / path).read_text(encoding="utf-8"))
        left += [found for found in (include_path(root, name) for name in names) if found]
    return seen


def installed(root, folder):
    headers = set()
    for path in sorted((root / folder).rglob("CMakeLists.txt")):
        for block in SETS.findall(path.read_text(encoding="utf-8")):
            here = path.parent.relative_to(root)
            headers |= {f"{here}/{name}" for name in re.findall(r"[\w/]+\.hpp", block)}
    return headers


def check_public_headers(root):
    if not (root / LIST).is_file():
        return
    promised = set()
    for pattern in LISTED.findall((root / LIST).read_text(encoding="utf-8")):
        paths = {str(path.relative_to(root)) for path in (root / "lib").glob(pattern)}
        if not paths:
            yield f"{LIST}: {pattern} is not there"
        promised |= paths
    theirs = closure(root, installed(root, "calibrate") | installed(root, "sweeps"))
    needed = closure(root, promised) | {path for path in theirs if path.startswith("lib/")}
    ours = installed(root, "lib")
    for path in sorted(ours - needed):
        yield f"{path}: is installed, and no header that {LIST} promises needs it"
    for path in sorted(needed - ours):
        yield f"{path}: is not installed, and a header that {LIST} promises needs it"
    for path in sorted(needed):
        for name in OTHERS.findall((root / path).read_text(encoding="utf-8")):
            yield f"{path}: <{name}> would be needed by every user of the library"
    used = set()
    for path in sorted((root / "tests/consumer").glob("*.cpp")):
        names = PROMISED.findall(path.read_text(encoding="utf-8"))
        used |= {f"lib/{name}" for name in names}
        for name in names:
            if f"lib/{name}" not in promised:
                yield f"{path.relative_to(root)}: <{name}> is not promised by {LIST}"
    for path in sorted(promised - used):
        yield f"{path}: is promised by {LIST}, and no project of tests/consumer includes it"
