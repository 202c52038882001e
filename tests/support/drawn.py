"""What a figure shows, from its artists: tests look at this, not at the size of a file."""
import contextlib
import unittest.mock

import matplotlib

matplotlib.use("Agg")
import matplotlib.figure
import numpy as np


@contextlib.contextmanager
def figures():
    """The figures that are saved meanwhile. Their texts are set; no layout is sought and no picture written, which take most of the time."""
    seen = []

    def set_texts(figure, path, **_):
        if figure not in seen:
            figure.set_layout_engine("none")
            figure.draw_without_rendering()
            seen.append(figure)

    with unittest.mock.patch.object(matplotlib.figure.Figure, "savefig", set_texts):
        yield seen


def lines(figure):
    """(x, y) of every line and of the markers of every set of points, as arrays."""
    return [tuple(np.asarray(c, float) for c in line.get_data(orig=True)) for axis in figure.axes for line in axis.lines]


def shows(figure, x, y):
    """Whether some line or set of points has just these values, gaps included."""
    return any(len(a) == len(x) and np.array_equal(a, x, equal_nan=True) and np.array_equal(b, y, equal_nan=True) for a, b in lines(figure))


def bars(figure):
    """(lower, upper) ends of all error bars, each (x, y); those without length too."""
    return [tuple(map(tuple, segment)) for axis in figure.axes for container in axis.containers if hasattr(container, "has_yerr")
            for part in container[2] for segment in part.get_segments() if len(segment)]


def numbers(figure):
    """Every coordinate of lines, points and outlines, and every value of a map, sorted."""
    found = [np.ravel(c) for line in lines(figure) for c in line]
    for axis in figure.axes:
        for artist in (*axis.collections, *axis.images):
            values = artist.get_array()
            if values is not None:
                found.append(np.ma.filled(np.ma.asarray(values, float), np.nan).ravel())
            else:
                found += [path.vertices.ravel() for path in artist.get_paths()]
            if hasattr(artist, "get_offsets"):
                found.append(np.ma.filled(artist.get_offsets(), np.nan).ravel())
    found = np.concatenate(found)
    return np.sort(found[np.isfinite(found)])


def share_drawn(known, values, within=1e-9):
    """Part of the values that stand among a figure's numbers; within: half the last digit of its CSV."""
    values = np.asarray(values, float)
    values = values[np.isfinite(values)]
    nearest = known[np.clip(np.searchsorted(known, values)[:, None] + [-1, 0], 0, len(known) - 1)]
    return float(np.mean(np.abs(nearest - values[:, None]).min(axis=1) <= within * np.maximum(1, np.abs(values))))
