#!/usr/bin/env python3
"""Compares result files bit by bit, outside /meta; prints each difference, exits 1 if there is one.

compare_results.py [--but GROUP] REFERENCE OTHER…: GROUP, such as /inputs, is left out as /meta is.
"""

import argparse
import sys

import h5py
import numpy


def bits(value):
    """What must be equal: type, shape and bytes; of texts, which HDF5 keeps elsewhere, the texts."""
    value = numpy.asarray(value)
    content = value.tolist() if value.dtype.kind == "O" else value.tobytes()
    return str(value.dtype), value.shape, content


def contents(path, left_out):
    """Everything in a file by its path: groups, datasets, attributes."""
    found = {}

    def visit(name, item):
        name = "/" + name
        if any(name == group or name.startswith(group + "/") for group in left_out):
            return
        found[name] = bits(item[()]) if isinstance(item, h5py.Dataset) else "group"
        for key, value in item.attrs.items():
            found[f"{name}@{key}"] = bits(value)

    with h5py.File(path) as file:
        for key, value in file.attrs.items():
            found[f"/@{key}"] = bits(value)
        file.visititems(visit)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--but", action="append", default=[])
    parser.add_argument("reference")
    parser.add_argument("others", nargs="+")
    arguments = parser.parse_args()
    left_out = ["/meta", *arguments.but]
    reference = contents(arguments.reference, left_out)
    differ = False
    for other in arguments.others:
        found = contents(other, left_out)
        for name in sorted(reference.keys() | found.keys()):
            if reference.get(name) != found.get(name):
                print(f"{other}: {name} is not as in {arguments.reference}")
                differ = True
    print(f"{len(reference)} items compared")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
