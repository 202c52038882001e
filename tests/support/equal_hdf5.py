"""Do two HDF5 files hold the same datasets with the same bits? Attributes are left out: they hold wall-clock time."""
import sys

import h5py
import numpy

names = [[], []]
with h5py.File(sys.argv[1]) as one, h5py.File(sys.argv[2]) as other:
    one.visititems(lambda name, item: names[0].append(name) if isinstance(item, h5py.Dataset) else None)
    other.visititems(lambda name, item: names[1].append(name) if isinstance(item, h5py.Dataset) else None)
    different = sorted(set(names[0]) ^ set(names[1]))
    for name in sorted(set(names[0]) & set(names[1])):
        if name == "provenance/parent":  # a resumed run names its checkpoint
            continue
        a, b = numpy.asarray(one[name][()]), numpy.asarray(other[name][()])
        if a.shape != b.shape or a.tobytes() != b.tobytes():
            different.append(name)
print("\n".join(different) if different else f"{len(names[0])} datasets are equal")
sys.exit(1 if different else 0)
