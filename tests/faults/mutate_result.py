"""Mutations of a result file: copies in which one thing is not as it should be.

`mutations(file, path)` lists what can be done to an object of a file, as (name, function of a
file that is open for writing). The names:

  shortened, emptied, doubled   other extents than the rest of the file
  rank, type, removed           another shape, another type, nothing
  huge                          an extent that the file has no bytes for
  filter                        stored with a filter that we never write
  virtual, external             values that stand in another file
  link, soft                    a link out of the file, or elsewhere in it
  no rows                       all tables of the file empty
  reversed                      the elements from the last to the first
  one VALUE, all VALUE          the middle element, or all
  @NAME …                       of the attribute NAME: removed, another type, another value
"""

import h5py
import numpy

TEXT = h5py.string_dtype("utf-8")
BYTES = h5py.string_dtype("ascii")
INTEGERS = (-1, 0, 2**31, 2**40)
REALS = (float("nan"), float("inf"), -1.0, 0.0, 1e300)
TEXTS = {"empty": b"", "long": b"x" * 100_000, "bytes": b"\xff\xfe", "lines": b"a\nb"}


def is_text(item):
    return item.dtype.kind in "SO"


def wrapped(value, dtype):
    """An integer as a type holds it: -1 of unsigned ones is the largest."""
    return numpy.array(value, dtype=numpy.int64).astype(dtype)


def replaced(file, path, **made):
    """Puts another dataset where one is, with its attributes."""
    attributes = dict(file[path].attrs)
    del file[path]
    dataset = file.create_dataset(path, **made)
    for name, value in attributes.items():
        dataset.attrs[name] = value
    return dataset


def with_data(path, change):
    def apply(file):
        item = file[path]
        replaced(file, path, data=change(item[()]), dtype=TEXT if is_text(item) else item.dtype)
    return apply


def of_another_type(path):
    def apply(file):
        item = file[path]
        if is_text(item):
            replaced(file, path, data=numpy.zeros(item.shape, dtype="i8"))
        elif item.dtype.kind == "f":
            replaced(file, path, data=numpy.full(item.shape, "1", dtype=object), dtype=TEXT)
        else:
            replaced(file, path, data=item[()] + numpy.float64(0.5))
    return apply


def huge(path):
    def apply(file):
        item = file[path]
        if item.shape == ():
            replaced(file, path, shape=(), dtype="S2147483000" if is_text(item) else "V2147483000")
            return
        inside = tuple(max(extent, 1) for extent in item.shape[1:])
        dtype = "S8" if is_text(item) else item.dtype
        replaced(file, path, shape=(2**33,) + inside, dtype=dtype, chunks=(64,) + inside)
    return apply


def filtered(path):
    def apply(file):
        item = file[path]
        replaced(file, path, data=item[()], dtype=item.dtype, chunks=item.shape, fletcher32=True,
                 compression="lzf")
    return apply


def in_another_file(path, virtual):
    """The values in a file beside this one, so that it could be read if it were followed."""
    def apply(file):
        item = file[path]
        shape, dtype = item.shape, item.dtype
        beside = file.filename + ".beside"
        if virtual:
            with h5py.File(beside, "w") as other:
                other["x"] = item[()]
            layout = h5py.VirtualLayout(shape=shape, dtype=dtype)
            layout[...] = h5py.VirtualSource(beside, "x", shape=shape, dtype=dtype)
            del file[path]
            file.create_virtual_dataset(path, layout)
            return
        with open(beside, "wb") as other:
            other.write(item[()].tobytes())
        replaced(file, path, shape=shape, dtype=dtype, external=beside)
    return apply


def linked(path, soft):
    def apply(file):
        item = file[path]
        if soft:
            file.move(path, "elsewhere")
            file[path] = h5py.SoftLink("/elsewhere")
            return
        beside = file.filename + ".beside"
        with h5py.File(beside, "w") as other:
            file.copy(item, other, "x")
        del file[path]
        file[path] = h5py.ExternalLink(beside, "/x")
    return apply


def with_value(path, index, value):
    def apply(file):
        file[path][index] = value
    return apply


def values_of(item):
    """(name, value) that an element may be set to."""
    if is_text(item):
        return list(TEXTS.items())
    if item.dtype.kind == "f":
        return [(str(value), value) for value in REALS]
    return [(str(value), wrapped(value, item.dtype)) for value in INTEGERS]


def of_values(path, item):
    if item.size == 0:
        return
    middle = tuple(extent // 2 for extent in item.shape)
    for name, value in values_of(item):
        yield f"one {name}", with_value(path, middle, value)
        if item.size > 1 and name != "long":
            yield f"all {name}", with_value(path, (), value)


def of_extents(path, item):
    if item.shape == ():
        yield "rank", with_data(path, lambda data: numpy.array([data]))
        return
    yield "rank", with_data(path, lambda data: data[..., None])
    if len(item.shape) > 1:
        yield "rank flat", with_data(path, lambda data: data.reshape(-1))
    yield "doubled", with_data(path, lambda data: numpy.concatenate([data, data, data[:1]]))
    if item.shape[0] > 0:
        yield "shortened", with_data(path, lambda data: data[:-1])
        yield "emptied", with_data(path, lambda data: data[:0])
    if len(item.shape) > 1 and item.shape[-1] > 0:
        yield "shortened inside", with_data(path, lambda data: data[..., :-1])
    if item.shape[0] > 1:
        yield "reversed", with_data(path, lambda data: data[::-1])


def of_dataset(path, item):
    yield "removed", lambda file: file.__delitem__(path)
    yield "type", of_another_type(path)
    yield "huge", huge(path)
    yield "link", linked(path, soft=False)
    yield "soft", linked(path, soft=True)
    if not is_text(item) and item.shape != () and item.size > 0:
        yield "filter", filtered(path)
    if not is_text(item) and item.size > 0:
        yield "virtual", in_another_file(path, virtual=True)
        yield "external", in_another_file(path, virtual=False)
    yield from of_extents(path, item)
    yield from of_values(path, item)


def set_attribute(path, name, value, dtype=None):
    def apply(file):
        attributes = file[path].attrs
        del attributes[name]
        attributes.create(name, value, dtype=dtype)
    return apply


def of_attributes(path, item):
    for name, value in item.attrs.items():
        if name == "units":  # for other readers: ours do not look
            continue
        yield f"@{name} removed", lambda file, name=name: file[path].attrs.__delitem__(name)
        others = {"list": [value, value], "empty": numpy.zeros(0), "real": 0.5}
        if isinstance(value, str):
            others |= {"integer": 1}
            for kind, text in TEXTS.items():
                if len(text) < 60_000:  # what an attribute can hold
                    yield f"@{name} {kind}", set_attribute(path, name, text, BYTES)
            yield f"@{name} huge", set_attribute(path, name, numpy.bytes_(b"x" * 60_000))
        else:
            others |= {str(number): number for number in INTEGERS + REALS} | {"text": "1"}
        for kind, other in others.items():
            yield f"@{name} {kind}", set_attribute(path, name, other)


def of_group(path):
    def as_dataset(file):
        del file[path]
        file[path] = 1.0

    yield "removed", lambda file: file.__delitem__(path)
    yield "type", as_dataset
    yield "link", linked(path, soft=False)
    yield "soft", linked(path, soft=True)


def without_rows(file):
    """All tables empty, in agreement with each other."""
    for path in paths(file):
        item = file[path]
        if not isinstance(item, h5py.Dataset) or item.shape == () or path.startswith("options/"):
            continue
        rows = 1 if path.endswith("offsets") and path.count("/") else 0
        with_data(path, lambda data, rows=rows: data[:rows])(file)


def mutations(file, path):
    """What can be done to the object at a path of an open file, as (name, function)."""
    item = file[path]
    if isinstance(item, h5py.Dataset):
        made = of_dataset(path, item)
    else:
        made = of_group(path) if path != "/" else [("no rows", without_rows)]
    return [*made, *of_attributes(path, item)]


def paths(file):
    found = ["/"]
    file.visit(found.append)
    return found


def plain_copy(source, target):
    """Writes a result as a plain HDF5 file: what stands in front of the HDF5 part is left out."""
    with h5py.File(source) as old, h5py.File(target, "w", track_order=True) as new:
        for name, value in old.attrs.items():
            new.attrs[name] = value
        for name in old:
            old.copy(name, new)
