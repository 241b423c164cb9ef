"""What docs/hdf5.md says of the datasets of a result, and of the keys of its summary."""

import pathlib
import re

import h5py

# Their names are those of fields and versions, which are listed elsewhere.
BY_THEIR_OWN_NAMES = ("options/setup/", "meta/versions/", "regions/material/", "regions/section/",
                      "cases/axes/")


class Undocumented:
    """Datasets of a file whose names the page does not say."""

    def __init__(self, page):
        self.names = []
        self.seen = 0
        self.documented = set(re.findall(r"`([a-z0-9_/]+)`", pathlib.Path(page).read_text()))
        self.documented |= {name.split("/")[-1] for name in self.documented}

    def visit(self, name, item):
        if isinstance(item, h5py.Dataset) and not name.startswith(BY_THEIR_OWN_NAMES):
            self.seen += 1
            if name.split("/")[-1] not in self.documented:
                self.names.append(name)


def undocumented(file, page):
    found = Undocumented(page)
    file.visititems(found.visit)
    return found


# Their keys are the names of a scene's probes.
BY_PROBES = ("probes", "frequencies")


def keys_of(value):
    """All keys of a JSON value, but for names of probes."""
    if isinstance(value, list):
        return {key for item in value for key in keys_of(item)}
    if not isinstance(value, dict):
        return set()
    keys = set(value)
    for key, item in value.items():
        for inner in item.values() if key in BY_PROBES else [item]:
            keys |= keys_of(inner)
    return keys


def undocumented_keys(summary, page):
    """Keys of a scene's summary that the summary's own section does not say."""
    text = pathlib.Path(page).read_text().split("(JSON)\n")[1].split("\n## ")[0]
    return sorted(keys_of(summary) - set(re.findall(r"`([a-z_]+)`", text)))
