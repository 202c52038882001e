"""What a figure shows, from its artists: tests look at this, not at the size of a file."""
import contextlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


@contextlib.contextmanager
def figures():
    """The figures that are closed meanwhile, as they were drawn."""
    seen, close = [], plt.close
    plt.close = lambda figure=None: (seen.append(figure), close(figure))
    try:
        yield seen
    finally:
        plt.close = close


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
    """Every coordinate and every coloured value that is drawn, sorted."""
    found = [np.ravel(c) for line in lines(figure) for c in line]
    for axis in figure.axes:
        for artist in (*axis.collections, *axis.images):
            for values in (artist.get_array(), *(np.asarray(p.vertices).T for p in getattr(artist, "get_paths", list)()), *(
                    np.asarray(artist.get_offsets()).T if hasattr(artist, "get_offsets") else ())):
                if values is not None:
                    found.append(np.ma.filled(np.ma.asarray(values, float), np.nan).ravel())
        found += [np.array([patch.get_x(), patch.get_height()]) for patch in axis.patches if hasattr(patch, "get_height")]
    found = np.concatenate(found)
    return np.sort(found[np.isfinite(found)])


def share_drawn(figure, values):
    """Part of the values that stand among the figure's numbers, to the digits of a CSV."""
    known, values = numbers(figure), np.asarray(values, float)
    values = values[np.isfinite(values)]
    nearest = known[np.clip(np.searchsorted(known, values)[:, None] + [-1, 0], 0, len(known) - 1)]
    return float(np.mean(np.abs(nearest - values[:, None]).min(axis=1) <= 1e-9 * np.maximum(1, np.abs(values)))) if len(values) else 1.0
