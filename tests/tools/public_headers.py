"""What the libraries promise: the headers that lib/plastica/README.md and calibrate/README.md list.

Installed are these, what they include, and what the installed headers of sweeps include; a header
that is nobody's business is not. The project of tests/consumer, built against the
installed library, includes what is promised and nothing else.
"""

import re

# Where each library is, what lists its headers, and where their paths begin.
LIBRARIES = [("lib", "lib/plastica/README.md", "lib"), ("calibrate", "calibrate/README.md", "")]
LISTED = re.compile(r"^\| `((?:plastica|calibrate)/[\w/*]+\.hpp)`", re.M)
OURS = re.compile(r'^#include "([^"]+)"', re.M)
OTHERS = re.compile(r"^#include <([^>]+/[^>]+|\w+\.h(?:pp)?|Eigen\w*)>", re.M)
PROMISED = re.compile(r"^#include <((?:plastica|calibrate)/[^>]+)>", re.M)
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


def promised_by(root, listing, base):
    """The headers that a page lists, and those of its patterns that match none."""
    promised, missing = set(), []
    for pattern in LISTED.findall((root / listing).read_text(encoding="utf-8")):
        paths = {str(path.relative_to(root)) for path in (root / base).glob(pattern)}
        promised |= paths
        if not paths:
            missing.append(f"{listing}: {pattern} is not there")
    return promised, missing


def used_by_consumers(root):
    """What the project of tests/consumer includes of ours, by the file that does."""
    for path in sorted((root / "tests/consumer").glob("*.cpp")):
        for name in PROMISED.findall(path.read_text(encoding="utf-8")):
            yield path.relative_to(root), name, include_path(root, name)


def check_public_headers(root):
    libraries = [library for library in LIBRARIES if (root / library[1]).is_file()]
    promises = {listing: promised_by(root, listing, base) for _, listing, base in libraries}
    used = list(used_by_consumers(root))
    for user, name, path in used if promises else []:
        if not any(path in promised for promised, _ in promises.values()):
            yield f"{user}: <{name}> is not promised by {' or '.join(promises)}"
    for folder, listing, _ in libraries:
        promised, missing = promises[listing]
        yield from missing
        others = {path for other in ("calibrate", "sweeps") if other != folder
                  for path in installed(root, other)}
        theirs = closure(root, others)
        needed = closure(root, promised) | theirs
        needed = {path for path in needed if path.startswith(folder + "/")}
        ours = installed(root, folder)
        for path in sorted(ours - needed):
            yield f"{path}: is installed, and no header that {listing} promises needs it"
        for path in sorted(needed - ours):
            yield f"{path}: is not installed, and a header that {listing} promises needs it"
        for path in sorted(needed):
            for name in OTHERS.findall((root / path).read_text(encoding="utf-8")):
                yield f"{path}: <{name}> would be needed by every user of the library"
        for path in sorted(promised - {path for _, _, path in used}):
            yield f"{path}: is promised by {listing}, and no project of tests/consumer includes it"
