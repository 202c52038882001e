# SPDX-License-Identifier: MIT
"""What the rows of planted faults say, by folder: scripts/mutate --score."""
import faults as listed
import mutation

TITLES = ("faults", "by its folder", "by others", "timed out", "explained", "survived", "no build", "no row", "older")


def count(faults, known, today):
    """One number for each of TITLES. Explained ones survived too; older: rows of another program or another edit."""
    found = [(fault, known[fault.name]) for fault in faults if fault.name in known]
    ended = {end: [(fault, row) for fault, row in found if row["ended"] == end] for end in (mutation.CAUGHT, mutation.TIMED_OUT, mutation.SURVIVED, mutation.NO_BUILD)}
    own = sum(row["suite"] == "folder" for _, row in ended[mutation.CAUGHT])
    explained = sum(bool(fault.survives) for fault, _ in ended[mutation.SURVIVED])
    return (len(faults), own, len(ended[mutation.CAUGHT]) - own, len(ended[mutation.TIMED_OUT]), explained, len(ended[mutation.SURVIVED]) - explained,
            len(ended[mutation.NO_BUILD]), len(faults) - len(found), len(mutation.lacking([fault for fault, _ in found], known, today)))


def table(faults, known, today):
    groups = [(folder, [fault for fault in faults if fault.folder == folder]) for folder in listed.FOLDERS]
    groups += [("drawn", [fault for fault in faults if fault.drawn]), ("chosen", [fault for fault in faults if not fault.drawn]), ("all", faults)]
    lines = ["program " + (", ".join(sorted({row["program"] for row in known.values()})) or "none") + f"; today's {today}",
             "| folder | " + " | ".join(TITLES) + " |", "|---|" + "--:|" * len(TITLES)]
    lines += [f"| {name} | " + " | ".join(map(str, count(group, known, today))) + " |" for name, group in groups if group]
    survivors = [fault for fault in faults if known.get(fault.name, {}).get("ended") == mutation.SURVIVED]
    lines += [f"survived: {fault.name}, {fault.file}: {fault.survives or fault.breaks}" for fault in survivors]
    return "\n".join(lines)
