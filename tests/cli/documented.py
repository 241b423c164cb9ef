"""What data/README.md says of the datasets of a result."""

import pathlib
import re

import h5py

# Their names are those of fields and versions, which are listed elsewhere.
BY_THEIR_OWN_NAMES = ("options/setup/", "meta/versions/", "regions/material/", "regions/section/",
                      "cases/axes/")


class Undocumented:
    """Datasets of a file whose names the README does not say."""

    def __init__(self, readme):
        self.names = []
        self.seen = 0
        self.documented = set(re.findall(r"`([a-z0-9_/]+)`", pathlib.Path(readme).read_text()))
        self.documented |= {name.split("/")[-1] for name in self.documented}

    def visit(self, name, item):
        if isinstance(item, h5py.Dataset) and not name.startswith(BY_THEIR_OWN_NAMES):
            self.seen += 1
            if name.split("/")[-1] not in self.documented:
                self.names.append(name)


def undocumented(file, readme):
    found = Undocumented(readme)
    file.visititems(found.visit)
    return found
