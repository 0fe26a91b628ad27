#!/usr/bin/env python3
"""Measures `check` of an assembly: a rack of bent pipes, layer across layer, each of which is pressed into every pipe of the layer below.
How long all clashes take with their depths, regions and volumes, when the first is told, and how much memory that is at the most.

usage: measure_clashes.py TOCCATA [--family shallow|mixed] [--layers 64] [--pipes 8] [--around 50] [--along 100] [--threads N]
                          [--peer ifcclash] [--peer-limit 900] [--python PYTHON] [--json] [--evidence FILE]

In `shallow` every clash is a tenth of a pipe deep; in `mixed` pipes of every fourth layer go through those of the layer below. With --peer
IfcClash (PyPI: pip install ifcclash) looks for intersections of the same parts written as IFC: of three layers, and of the most that it
will do within the limit by that, up to all; Toccata is measured beside it, and both are compared with the clashes that there are.
Processor seconds are those of all threads together, user and system. Exits with 1 where Toccata does not tell the clashes that there are, each
with brackets of its depth at the place, of its depth as a whole and of its volume; 2 for trouble.
"""
import argparse
import dataclasses
import importlib.metadata
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from evidence import what_was_run, write_evidence
from racks import MIXED, SHALLOW, UNEVEN, Rack, write_ifc, write_meshes

FAMILIES = {"shallow": SHALLOW, "mixed": MIXED}
SIZES = {"layers": 64, "pipes": 8, "around": 50, "along": 100, "threads": 0}
# What is asked of a rack of so many parts, triangles and clashes at least.
LARGE = {"parts": 500, "triangles": 5_000_000, "clashes": 4_000}
MOST_SECONDS, MOST_UNTIL_FIRST = 60, 10
PEER_PROBE_LAYERS = 3
SHARE_OF_LIMIT = 0.75  # as the peer takes a little longer for each part where there are more
DIFFERENCES_TOLD = 10


def processor_seconds():
    """Of all processes that were started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def peak_megabytes(process):
    """The most memory that a process has had until now; none where the system does not tell it."""
    try:
        lines = pathlib.Path(f"/proc/{process}/status").read_text(encoding="ascii", errors="replace").splitlines()
    except OSError:
        return None
    return next((round(int(line.split()[1]) / 1e3) for line in lines if line.startswith("VmHWM:")), None)


def has_right_brackets(pair, depth):
    """That of the depth as a whole holds what it is by construction; one of each region, and one of the volume, are there."""
    whole, volume, regions = pair["penetration"], pair["volume"], pair["regions"]
    is_right = whole is not None and whole["lower"] <= depth + UNEVEN and (whole["upper"] is None or whole["upper"] >= depth - UNEVEN)
    is_local = bool(regions) and all(region["depth"] is not None and region["depth_upper"] is not None and region["depth"] <= region["depth_upper"] for region in regions)
    return is_right and is_local and volume is not None and 0 < volume["lower"] <= volume["upper"]


def compared(found, expected):
    """What a set of pairs lacks and has besides."""
    missing, invented = sorted(expected - found), sorted(found - expected)
    return {"pairs": len(found), "missing": len(missing), "invented": len(invented), "differences": (missing + invented)[:DIFFERENCES_TOLD]}


def rounded(figures):
    return {name: number and round(number, 4) for name, number in figures.items()}


def measured_check(command, folder, threads, depths):
    words = [command, "check", str(folder), "--penetration", "--volume", "--stream", *(["--threads", str(threads)] if threads else [])]
    before, started, first, memory, pairs = processor_seconds(), time.monotonic(), None, None, {}
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        for line in process.stdout:
            memory = peak_megabytes(process.pid) or memory
            told = json.loads(line)
            if "relation" not in told:
                continue
            first = first or time.monotonic() - started
            pairs[told["a"], told["b"]] = told
    seconds = time.monotonic() - started
    if process.returncode not in (0, 1):
        raise RuntimeError(f"check ended with {process.returncode}")
    wrong = sum(not has_right_brackets(pairs[pair], depth) for pair, depth in depths.items() if pair in pairs)
    widths = [pair["penetration"]["upper"] / pair["penetration"]["lower"] - 1 for pair in pairs.values() if pair["penetration"] and pair["penetration"]["lower"] > 0 and pair["penetration"]["upper"] is not None]
    return {**rounded({"seconds": seconds, "first_result_s": first, "processor_s": processor_seconds() - before}), "peak_mb": memory,
            **compared(set(pairs), set(depths)), "wrong_brackets": wrong, **rounded({"widest_depth_bracket": max(widths, default=None)})}


def ifc_clash(file):
    """In a process of its own: what IfcClash finds in the file."""
    import logging

    from ifcclash import ifcclash

    settings = ifcclash.ClashSettings()
    settings.logger = logging.getLogger("ifcclash")
    clasher = ifcclash.Clasher(settings)
    clasher.clash_sets = [{"name": "rack", "a": [{"file": file}], "mode": "intersection", "tolerance": 0.0, "check_all": False}]
    clasher.clash()
    pairs = sorted({tuple(sorted((clash["a_name"], clash["b_name"]))) for clash in clasher.clash_sets[0]["clashes"].values()})
    versions = {name: importlib.metadata.version(name) for name in ("ifcclash", "ifcopenshell")}
    print(json.dumps({"pairs": pairs, "peak_mb": peak_megabytes("self"), "versions": versions}))


def measured_ifc_clash(python, file, limit, depths):
    """Only the reason where it does not end well, within so many seconds."""
    before, started = processor_seconds(), time.monotonic()
    try:
        run = subprocess.run([python, __file__, "--ifc-clash", str(file)], capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return {"ended": f"not within {limit:g} s"}
    if run.returncode != 0:
        return {"ended": f"{run.returncode}: " + (run.stderr.strip().splitlines() or ["it says nothing"])[-1]}
    told = json.loads(run.stdout.splitlines()[-1])
    return {**rounded({"seconds": time.monotonic() - started, "processor_s": processor_seconds() - before}), "peak_mb": told["peak_mb"],
            **compared({tuple(pair) for pair in told["pairs"]}, set(depths)), "versions": told["versions"]}


def scene_of(rack):
    return {"parts": rack.parts(), "triangles": rack.triangles(), "clashes": len(rack.depths())}


def measured_rack(options, rack):
    with tempfile.TemporaryDirectory() as folder:
        write_meshes(pathlib.Path(folder), rack)
        measured = {**scene_of(rack), "toccata": measured_check(options.command, folder, options.threads, rack.depths())}
    if all(measured[what] >= least for what, least in LARGE.items()):
        ours = measured["toccata"]
        measured[f"at most {MOST_SECONDS} s, the first after at most {MOST_UNTIL_FIRST}"] = ours["seconds"] <= MOST_SECONDS and ours["first_result_s"] is not None and ours["first_result_s"] <= MOST_UNTIL_FIRST
    return measured


def beside_peer(options, rack):
    """One rack, taken by both."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "rack.ifc"
        write_ifc(file, rack)
        theirs = measured_ifc_clash(options.python, file, options.peer_limit, rack.depths())
    measured = {**measured_rack(options, rack), "ifcclash": theirs}
    if "ended" not in theirs:
        measured["processor time of IfcClash to Toccata's"] = round(theirs["processor_s"] / measured["toccata"]["processor_s"], 1)
    return measured


def all_beside_peer(options, rack):
    """Of a few layers, and of the most that the peer will do within its limit by that; of half as many where it does not."""
    layers = min(PEER_PROBE_LAYERS, rack.layers)
    runs = [beside_peer(options, dataclasses.replace(rack, layers=layers))]
    if "ended" in runs[0]["ifcclash"]:
        raise RuntimeError("IfcClash ended " + runs[0]["ifcclash"]["ended"])
    most = min(rack.layers, int(layers * SHARE_OF_LIMIT * options.peer_limit / runs[0]["ifcclash"]["seconds"]))
    while most > layers:
        runs.append(beside_peer(options, dataclasses.replace(rack, layers=most)))
        if "ended" not in runs[-1]["ifcclash"]:
            break
        most //= 2
    return runs


def rows_of(family, measured):
    """What a person reads."""
    yield "{}: {parts} parts, {triangles:,} triangles, {clashes:,} clashes".format(family, **measured)
    for library in ("toccata", "ifcclash"):
        row = measured.get(library)
        if row is None:
            continue
        if "ended" in row:
            yield f"  {library:<9} ended: {row['ended']}"
            continue
        first = f", the first after {row['first_result_s']:.2f} s" if row.get("first_result_s") else ""
        brackets = f", {row['wrong_brackets']} without right brackets" if "wrong_brackets" in row else ""
        yield (f"  {library:<9} {row['seconds']:8.2f} s{first}, processor {row['processor_s']:.2f} s, at most {row['peak_mb']} MB; "
               f"{row['pairs']:,} pairs, {row['missing']} missing, {row['invented']} invented{brackets}")


def is_right(measured):
    ours = measured["toccata"]
    return ours["missing"] + ours["invented"] + ours["wrong_brackets"] == 0


def words_of(options):
    sizes = [word for name in SIZES for word in (f"--{name}", str(getattr(options, name)))]
    family = ["--family", options.family] if options.family else []
    peer = ["--peer", options.peer, "--peer-limit", f"{options.peer_limit:g}"] if options.peer else []
    return ["bench", "clashes", *sizes, *family, *peer]


def parsed():
    parser = argparse.ArgumentParser(prog="toccata bench clashes", description="How long check takes for a large assembly with many clashes.")
    parser.add_argument("command", help=argparse.SUPPRESS)
    parser.add_argument("--family", choices=list(FAMILIES), help="this one alone")
    for name, standard in SIZES.items():
        parser.add_argument(f"--{name}", type=int, default=standard, help=f"({standard})" if standard else "(as many as there are processors)")
    parser.add_argument("--peer", choices=["ifcclash"], help="measure it beside Toccata, of as many layers as it does within its limit")
    parser.add_argument("--peer-limit", type=float, default=900, metavar="SECONDS", help="(%(default)s)")
    parser.add_argument("--python", default=sys.executable, help="in which the peer is installed (the one that runs this)")
    parser.add_argument("--json", action="store_true", help="write JSON")
    parser.add_argument("--evidence", type=pathlib.Path, metavar="FILE", help="write the JSON there, too")
    options = parser.parse_args()
    if not 2 <= options.layers <= 100 or options.pipes < 1 or options.around < 8 or options.along < 8:
        parser.error("a rack has 2 to 100 layers, and a pipe 8 sides and rings or more")
    options.command = str(pathlib.Path(options.command).resolve())
    return options


def main():
    if sys.argv[1:2] == ["--ifc-clash"]:
        return ifc_clash(sys.argv[2])
    options = parsed()
    report = {**what_was_run(words_of(options), options.command), "families": {}}
    runs = []
    for family in [options.family] if options.family else FAMILIES:
        rack = Rack(options.layers, options.pipes, options.around, options.along, FAMILIES[family])
        report["families"][family] = {**measured_rack(options, rack), **({"beside IfcClash": all_beside_peer(options, rack)} if options.peer else {})}
        measured = [report["families"][family], *report["families"][family].get("beside IfcClash", [])]
        runs += measured
        if not options.json:
            print("\n".join(row for one in measured for row in rows_of(family, one)), flush=True)
    if options.json:
        print(json.dumps(report, indent=1))
    if options.evidence:
        write_evidence(options.evidence, report)
    return 0 if all(map(is_right, runs)) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError) as trouble:
        print(f"bench clashes: {trouble}", file=sys.stderr)
        sys.exit(2)
