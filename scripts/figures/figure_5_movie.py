# SPDX-License-Identifier: MIT
"""A movie (mp4, by ffmpeg) of MD and continuum in step over two cycles of the plate, one above the other; its picture is one frame."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from matplotlib.collections import EllipseCollection

import run_folder
from run_folder import RunError
from slice_figures import both, panel
from style import PLATE, plt, save

NAME = "figure_5_movie"
CAPTION = (
    "Movie: MD (particles within six diameters along the line of sight, along the stripes, coloured by their horizontal velocity) and continuum (volume fraction) in step over two cycles, MD at Gamma = 2.2, the continuum at 3.6, where it has stripes, "
    "f* = 0.4174. The picture is the frame at ft = 0.75; the movie lies beside it as figure_5_movie.mp4 and shows the two cycles four times."
)
DEEP, TOP, SHOWN, RATE, ROUNDS = 6.0, 21.0, 0.75, 16, 4
FASTEST = 0.8  # of the colours, sqrt(g sigma)


def frame(time, md, continuum):
    """The figure at ft = `time`."""
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7.2, 7.6), sharex=True)
    x, along, z, u, *_ = md.particles(time, last=True)
    near = along < DEEP
    order = np.argsort(along[near])[::-1]
    x, z, u = (values[near][order] for values in (x, z, u))
    grains = EllipseCollection(np.ones_like(x), np.ones_like(x), np.zeros_like(x), units="xy", offsets=np.column_stack([x, z]),
                               offset_transform=upper.transData, edgecolor="black", lw=0.2, cmap="RdBu_r", clim=(-FASTEST, FASTEST))
    grains.set_array(u)
    upper.add_collection(grains)
    upper.axhline(md.plate(time), color=PLATE, lw=3)
    figure.colorbar(grains, ax=upper, label=r"$u_x/\sqrt{g\sigma}$", extend="both", aspect=15)
    image = panel(lower, continuum.at(time), "nu")
    figure.colorbar(image, ax=lower, label=r"$\nu$", aspect=15)
    for axis, words, stripes in ((upper, "MD", md), (lower, "continuum", continuum)):
        axis.set_xlim(0, md.width)
        axis.set_ylim(-0.5, TOP)
        axis.set_aspect("equal")
        axis.set_ylabel(r"$z/\sigma$")
        axis.set_title(rf"{words}, $\Gamma$ = {stripes.gamma:g}, $ft$ = {time:.3f}", loc="left", fontsize=10)
    lower.set_xlabel(r"$x/\sigma$")
    return figure


def heights_of_wave(stripes, time):
    """Amplitude of the pattern's wave in the height of the centre of mass, above 0 where a peak stands at half a wavelength."""
    piece = stripes.at(time)
    z = (piece.z[1:] + piece.z[:-1])[:, None] / 2
    nu = np.nan_to_num(piece.fields["nu"])
    height = (nu * z).sum(axis=0) / nu.sum(axis=0)
    wave = round(stripes.width / stripes.wavelength)
    return -2 * np.real(np.fft.rfft(height)[wave]) / len(height)


def draw(study):
    if not shutil.which("ffmpeg"):
        raise RunError("ffmpeg is not there; install Debian's package ffmpeg (scripts/setup scripts/packages_studies.txt)")
    (_, md), (_, continuum) = both(study)
    times = [time for time in sorted(md.times) if time in continuum.times]
    columns = {"ft": times, "plate/sigma": [md.plate(t) for t in times], "wave of MD/sigma": [heights_of_wave(md, t) for t in times],
               "wave of continuum/sigma": [heights_of_wave(continuum, t) for t in times]}
    study.figures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for number, time in enumerate(times):
            figure = frame(time, md, continuum)
            # Even numbers of pixels, as H.264 asks, hence no tight box.
            with plt.rc_context({"savefig.bbox": "standard"}):
                figure.savefig(Path(folder) / f"{number:04d}.png", dpi=100)
            plt.close(figure)
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-stream_loop", str(ROUNDS - 1), "-framerate", str(RATE), "-i", f"{folder}/%04d.png",
                        "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "24", "-movflags", "+faststart", "-fflags", "+bitexact",
                        str(study.figures / f"{NAME}.mp4")], check=True)
    shown = min(times, key=lambda time: abs(time - SHOWN))
    return save(frame(shown, md, continuum), study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
