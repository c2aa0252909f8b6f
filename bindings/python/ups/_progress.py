"""How far a render is, for people: a bar on a terminal or in a notebook, lines below one another elsewhere.

Called by Job.watch.
"""
from __future__ import annotations

import contextlib
import html
import os
import sys
from collections.abc import Callable, Iterator
from typing import Any

from ._ffi import Progress

_BAR_WIDTH = 30
_LINE_INTERVAL_S = 5

View = Callable[[Progress], object]


def _duration(seconds: float) -> str:
    if seconds < 9.95:
        return f"{seconds:.2g} s"
    if seconds < 99.5:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def text_of(progress: Progress) -> str:
    text = f"{progress.fraction:.0%}, {progress.iterations_done} iterations"
    if progress.worst_relative_error >= 0:
        text += f", worst error {progress.worst_relative_error:.1%}"
    if progress.median_relative_error >= 0:
        text += f", median {progress.median_relative_error:.1%}"
    return text + (f", {_duration(progress.remaining_s)} left" if progress.remaining_s >= 0 else "")


def _terminal_columns() -> int:
    """Of the error stream's terminal; 80 where it does not say."""
    try:
        return os.get_terminal_size(sys.stderr.fileno()).columns or 80
    except (AttributeError, OSError, ValueError):  # a program's own stream may be no file, as IDLE's
        return 80


@contextlib.contextmanager
def _on_terminal() -> Iterator[View]:
    """A line of the error stream that is written over."""
    last_length = 0

    def show(progress: Progress) -> None:
        nonlocal last_length
        full = round(progress.fraction * _BAR_WIDTH)
        line = f"[{'#' * full}{' ' * (_BAR_WIDTH - full)}] {text_of(progress)}"
        # One that wraps could not be written over. The last column is left free: some terminals wrap after it.
        line = line[:max(1, _terminal_columns() - 1)]
        print("\r" + line.ljust(last_length), end="", file=sys.stderr, flush=True)
        last_length = len(line)

    try:
        yield show
    finally:
        if last_length:
            print(file=sys.stderr)


@contextlib.contextmanager
def _in_notebook() -> Iterator[View]:
    """One output of the cell that is replaced."""
    from IPython.display import display  # there: the notebook runs in it
    shown: Any = None

    def show(progress: Progress) -> None:
        nonlocal shown
        text = text_of(progress)
        data = {"text/plain": text,
                "text/html": f'<progress max="1" value="{progress.fraction:.3f}"></progress> {html.escape(text)}'}
        if shown is None:
            shown = display(data, raw=True, display_id=True)
        else:
            shown.update(data, raw=True)

    yield show


@contextlib.contextmanager
def _in_file() -> Iterator[View]:
    next_line_s = float(_LINE_INTERVAL_S)

    def show(progress: Progress) -> None:
        nonlocal next_line_s
        if progress.elapsed_s >= next_line_s:
            next_line_s = progress.elapsed_s + _LINE_INTERVAL_S
            print(text_of(progress), file=sys.stderr, flush=True)

    yield show


def _is_notebook() -> bool:
    """A kernel has displays that can be replaced; the IPython of a terminal has not."""
    ipython = sys.modules.get("IPython")
    return ipython is not None and hasattr(ipython.get_ipython(), "kernel")


def view_of(progress: bool | View) -> contextlib.AbstractContextManager[View]:
    """What shows it: a function that is called with each ups.Progress."""
    if callable(progress):
        return contextlib.nullcontext(progress)
    if not progress:
        return contextlib.nullcontext(lambda _: None)
    if _is_notebook():
        return _in_notebook()
    return _on_terminal() if sys.stderr is not None and sys.stderr.isatty() else _in_file()
