"""Opens md.h5, continuum.h5 and compare.h5 as a user would, with h5py, and checks what the formats promise."""
import pathlib
import sys
import xml.etree.ElementTree

import h5py
import numpy

folder = pathlib.Path(sys.argv[1])

with h5py.File(folder / "md.h5") as md:
    assert tuple(md["h5md"].attrs["version"]) == (1, 1)
    assert "name" in md["h5md/author"].attrs and "name" in md["h5md/creator"].attrs
    box = md["particles/all/box"]
    assert box.attrs["dimension"] == 3
    boundary = [b.decode() if isinstance(b, bytes) else b for b in box.attrs["boundary"]]
    assert boundary == ["periodic", "periodic", "none"], boundary
    position = md["particles/all/position/value"]
    frames, particles, dimension = position.shape
    assert (frames, particles, dimension) == (20, 200, 3), position.shape
    assert md["particles/all/velocity/value"].shape == position.shape
    assert box["edges/value"].shape == (frames, 3, 3)
    for link in ("box/edges/step", "velocity/step"):  # hard links: the same object
        assert md["particles/all/position/step"] == md[f"particles/all/{link}"], link
    assert numpy.allclose(md["particles/all/phase"][()], numpy.arange(20) / 20, atol=1e-12)
    assert numpy.isfinite(position[()]).all()
    xy = position[..., :2]
    assert (xy >= 0).all() and (xy < 6.0).all()

    energy = md["observables/kinetic_energy/value"][()] + md["observables/potential_energy/value"][()]
    ledger = (md["observables/plate_work/value"][()] + md["observables/ceiling_work/value"][()]
              - md["observables/collision_loss/value"][()] - md["observables/plate_loss/value"][()]
              - md["observables/ceiling_loss/value"][()])
    # Round-off: some 1e5 additions of up to 1e5 in magnitude, each to 1e-16.
    assert numpy.abs(energy - energy[0] - (ledger - ledger[0])).max() < 1e-9 * numpy.abs(ledger).max()

    # Every particle below the lid is counted once a sample.
    sums, samples = md["profiles/sums"], md["profiles/samples"]
    assert samples[()].sum() == 4 * 100
    assert sums[..., 0].sum() <= 200 * samples[()].sum()
    for name in ("program", "git_hash", "compiler", "compiler_flags", "scene", "seed"):
        assert f"provenance/{name}" in md, name
    assert "parameters/units" in md

with h5py.File(folder / "continuum.h5") as continuum:
    cells = continuum["grid/cells"][()]
    assert tuple(cells) == (1, 1, 80), cells
    assert len(continuum["frames"]) == 20
    dz = continuum["grid/spacing"][2]
    for frame in continuum["frames"].values():
        density, temperature = frame["density"][()], frame["temperature"][()]
        assert density.shape == (80, 1, 1)
        assert (density > 0).all() and (temperature > 0).all() and (density < 0.65 * 6 / numpy.pi).all()
        # The start fills empty cells with the floor, 1e-7 of the mean density.
        assert abs(density.sum() * dz - 200 / 36) < 1.1e-7 * 200 / 36
    mass = continuum["observables/mass/value"][()]
    assert numpy.abs(mass / mass[0] - 1).max() < 1e-12

with h5py.File(folder / "compare.h5") as compare, h5py.File(folder / "md.h5") as md:
    for engine in ("md", "continuum"):
        t, t_x, t_z = (compare[f"{engine}/{name}"][()] for name in ("temperature", "temperature_x", "temperature_z"))
        assert numpy.isfinite(t).sum() > 500, engine
        # 3 T = T_x + T_y + T_z, of which temperature_x is the mean of the first two; round-off of squares of velocities of some ten.
        assert numpy.allclose(3 * t, 2 * t_x + t_z, rtol=1e-12, atol=1e-11, equal_nan=True), engine
    # From the sums of the MD, by the definition: each component's scatter about the mean, of which one degree of freedom is lost.
    mass, *momenta = numpy.moveaxis(md["profiles/sums"][()].sum(axis=0), -1, 0)
    with numpy.errstate(invalid="ignore", divide="ignore"):
        t_x, t_y, t_z = ((square - first**2 / mass) / (mass - 1) for first, square in zip(momenta[:3], momenta[3:]))
    seen = mass > 1
    for name, wanted in (("temperature_x", (t_x + t_y) / 2), ("temperature_z", t_z), ("temperature", (t_x + t_y + t_z) / 3)):
        assert numpy.allclose(compare[f"md/{name}"][()][seen], wanted[seen], rtol=1e-9, atol=1e-9), name

text = xml.etree.ElementTree.parse(folder / "continuum.xdmf")
items = [item.text for item in text.iter("DataItem") if item.get("Format") == "HDF"]
assert len(items) == 20 * 5
with h5py.File(folder / "continuum.h5") as continuum:
    assert all(item.split(":")[0] == "continuum.h5" and item.split(":")[1] in continuum for item in items)
print("md.h5, continuum.h5, compare.h5 and continuum.xdmf are what docs/formats.md says")
