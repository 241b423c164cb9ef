"""How long work says how far it is."""

from __future__ import annotations

import sys
import time
from typing import Callable, Union

Progress = Union[bool, None, Callable[[float, float], object]]
"""True: a line on the standard error; or what is called with the part done and the whole."""


class _Line:
    """A line that is written over, in terminals and notebooks."""

    def __init__(self, label: str, whole: float) -> None:
        self._label, self._whole = label, whole
        self._begin = time.monotonic()
        self._shown = 0.0

    def __call__(self, done: float) -> None:
        now = time.monotonic()
        ended = done < 0.0
        if not ended and now - self._shown < 0.1:
            return
        self._shown = now
        done = self._whole if ended else done
        left = (now - self._begin) * (self._whole / done - 1.0) if done > 0.0 else 0.0
        said = f"{self._label}: {done:g} of {self._whole:g}"
        said += f", {now - self._begin:.0f} s" if ended else f", {left:.0f} s left"
        print(f"\r{said:<58}", end="\n" if ended else "", file=sys.stderr, flush=True)


def reporter(progress: Progress, label: str, whole: float) -> Callable[[float], object] | None:
    """What the engine calls with what is done, and with -1 at the end; None: nothing to be said."""
    if progress is None or progress is False or not whole > 0.0:
        return None
    if progress is True:
        return _Line(label, whole)
    told = progress

    def tell(done: float) -> None:
        told(whole if done < 0.0 else done, whole)

    return tell
