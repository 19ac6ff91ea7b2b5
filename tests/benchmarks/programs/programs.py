#!/usr/bin/python3
"""Writes benchmark models with other programs and searches for each file in the index of all models.

    programs.py --bin build/release/bin --data DATA --out FOLDER [--models 40] [--only NAME…]

See README.md for the programs. Prints a line for each program and format: files, how many have the model that they were
written from as the first hit, its distance in the median and at worst, and what failed. Ends with 1 where a
file does not have its model first or further away than --most.
"""

import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

from off import read_off, write_stl

HERE = pathlib.Path(__file__).parent
VOLUMES = (".nii", ".npy", ".nrrd")
LIMIT_S = 120  # of one conversion


def place(out, writer, model, extension):
    to = out / writer
    to.mkdir(parents=True, exist_ok=True)
    return to / (model.stem + extension)


def convert(command):
    """Runs one conversion; what it says counts only where it failed."""
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, timeout=LIMIT_S)
    except subprocess.TimeoutExpired:
        return f"{command[0]}: longer than {LIMIT_S} s"
    return "" if done.returncode == 0 else f"{command[0]}: {done.stderr.decode(errors='replace').strip()[-200:]}"


def one_by_one(formats, command_for):
    """A writer that is a command a file: `formats` are (variant, extension), `command_for` gives the command."""

    def write(out, name, models):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            waiting = []
            for model in models:
                for variant, extension in formats:
                    to = place(out, f"{name}-{variant}", model, extension)
                    if not to.exists():
                        waiting.append(pool.submit(convert, command_for(out, model, variant, to)))
            return sorted({fault for work in waiting if (fault := work.result())})

    return write


def all_at_once(sentinel, command_for):
    """A writer that is one command for all models; `sentinel` is the folder that it fills last."""

    def write(out, name, models):
        missing = [model for model in models if not list((out / sentinel).glob(model.stem + ".*"))]
        if not missing:
            return []
        done = subprocess.run([str(word) for word in command_for(out, missing)], capture_output=True)
        said = done.stderr.decode(errors="replace").splitlines()
        return sorted(set(said[-3:])) if done.returncode else sorted({line for line in said if "rror" in line})[:3]

    return write


def stl_of(out, model):
    """The model as binary STL, which is what some programs read."""
    path = place(out, "source", model, ".stl")
    if not path.exists():
        write_stl(path, *read_off(model))
    return path


def openscad(out, model, variant, to):
    script = place(out, "source", model, ".scad")
    script.write_text(f'import("{model}", convexity = 10);\n', encoding="utf-8")
    kind = {"stl": ["--export-format", "binstl"], "stl-text": ["--export-format", "asciistl"]}.get(variant, [])
    return ["openscad", *kind, "-o", to, script]


def meshlab(out, model, variant, to):
    return ["xvfb-run", "-a", "meshlabserver", "-i", model, "-o", to]


def assimp(out, model, variant, to):
    kind = {"stl": "stlb", "stl-text": "stl", "ply": "plyb", "ply-text": "ply", "dae": "collada", "gltf": "gltf2",
            "glb": "glb2", "fbx": "fbx", "fbx-text": "fbxa"}  # fmt: skip
    source = model
    if variant == "3mf":  # it leaves out the meshes of a scene's root, where its OFF reader puts them
        source = place(out, "assimp-obj", model, ".obj")
        if not source.exists():
            convert(["assimp", "export", model, source, "-fobj"])
    return ["assimp", "export", source, to, "-f" + kind.get(variant, variant)]


def admesh(out, model, variant, to):
    kind = {"stl": "-b", "stl-text": "-a", "off": "--write-off="}[variant]
    target = [kind + str(to)] if kind.endswith("=") else [kind, to]
    # Without its checks it knows no neighbours, and writes OFF without end.
    return ["admesh", *([] if variant == "off" else ["--no-check"]), *target, stl_of(out, model)]


def prusa(out, model, variant, to):
    return ["prusa-slicer", "--export-" + variant, "--dont-arrange", "-o", to, stl_of(out, model)]


def same_names(*extensions):
    return [(extension, "." + extension) for extension in extensions]


# Name, the program that must be there, and what writes.
WRITERS = [
    ("blender", "blender",
     all_at_once("blender-gltf-bin", lambda out, models: ["blender", "--background", "--factory-startup", "--python",
                                                          HERE / "in_blender.py", "--", out, *models])),
    ("meshlab", "meshlabserver",
     one_by_one(same_names("stl", "ply", "obj", "off", "dae", "x3d"), meshlab)),
    ("openscad", "openscad",
     one_by_one([*same_names("stl", "off", "amf", "3mf"), ("stl-text", ".stl")], openscad)),
    ("assimp", "assimp",
     one_by_one([*same_names("stl", "ply", "obj", "dae", "x3d", "gltf", "glb", "fbx", "3mf"), ("stl-text", ".stl"),
                 ("ply-text", ".ply"), ("fbx-text", ".fbx")], assimp)),
    ("admesh", "admesh", one_by_one([*same_names("stl", "off"), ("stl-text", ".stl")], admesh)),
    ("openctm", "ctmconv",
     one_by_one(same_names("stl", "ply", "obj", "off", "dae"),
                lambda out, model, variant, to: ["ctmconv", model, to])),
    ("prusa", "prusa-slicer", one_by_one(same_names("stl", "obj", "amf", "3mf"), prusa)),
    ("vtk", sys.executable, all_at_once("vtk-nii", lambda out, models: [sys.executable, HERE / "in_vtk.py", out, *models])),
    ("libraries", "ossuary_written_by_libraries",
     all_at_once("openmesh-ply-text", lambda out, models: ["ossuary_written_by_libraries", out, *models])),
]  # fmt: skip


def search(bin_folder, index, path, name):
    """Rank of the model among the hits (one as near as the first counts as first) and its distance."""
    done = subprocess.run(
        [str(bin_folder / "ossuary"), "search", "--index", str(index), "--limit", "0", "--json", "--jobs", "1", str(path)],
        capture_output=True,
    )
    if done.returncode != 0:
        return {"fault": done.stderr.decode(errors="replace").strip().splitlines()[-1][:300]}
    hits = json.loads(done.stdout)["hits"]
    own = next(hit for hit in hits if pathlib.Path(hit["name"]).stem == name)
    before = sum(hit["distance"] < own["distance"] for hit in hits)
    return {"before": before, "distance": own["distance"], "first": hits[0]["name"]}


def build_index(bin_folder, collection, index):
    if index.exists():
        return
    subprocess.run([str(bin_folder / "ossuary"), "index", "--index", str(index), "--classes",
                    str(collection / "segmentation-all.cla"), str(collection / "off")], check=True)  # fmt: skip


def report(rows, most):
    """Prints the table; whether all is as it should be."""
    fine = True
    print(f"{'writer':<24}{'files':>6}{'first':>6}{'median':>9}{'worst':>9}")
    for writer in sorted({row["writer"] for row in rows}):
        of_writer = [row for row in rows if row["writer"] == writer]
        found = [row for row in of_writer if "distance" in row]
        first = sum(row["before"] == 0 for row in found)
        distances = [row["distance"] for row in found]
        median, worst = (statistics.median(distances), max(distances)) if distances else (float("nan"),) * 2
        print(f"{writer:<24}{len(of_writer):>6}{first:>6}{median:>9.4f}{worst:>9.4f}")
        fine = fine and first == len(of_writer) and worst <= most
    for row in rows:
        if "fault" in row:
            print(f"{row['writer']}/{row['file']}: {row['fault']}")
        elif row["before"] > 0 or row["distance"] > most:
            print(f"{row['writer']}/{row['file']}: {row['before']} before it, distance {row['distance']:.4f}")
    return fine


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--models", type=int, default=40)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--most", type=float, default=0.02, help="how far a model may be from itself")
    options = parser.parse_args()
    out, bin_folder = options.out.resolve(), options.bin.resolve()
    os.environ["PATH"] += os.pathsep + str(bin_folder)
    out.mkdir(parents=True, exist_ok=True)
    collection = options.data.resolve() / "princeton-segmentation"
    every = sorted((collection / "off").glob("*.off"), key=lambda path: int(path.stem))
    models = [every[i * len(every) // options.models] for i in range(options.models)]
    build_index(bin_folder, collection, out / "models.ossuary")
    for name, program, write in WRITERS:
        if options.only and name not in options.only:
            continue
        if not shutil.which(program):
            print(f"{name}: {program} is not installed", file=sys.stderr)
            continue
        for fault in write(out, name, models):
            print(f"{name}: {fault}", file=sys.stderr)
    names = {model.stem for model in models}
    extensions = (".off", ".stl", ".obj", ".ply", ".3mf", ".gltf", ".glb", ".dae", ".x3d", ".amf", ".fbx", *VOLUMES)
    files = [
        path
        for path in sorted(out.glob("*-*/*"))
        if (not options.only or path.parent.name.split("-")[0] in options.only)
        and path.name.split(".")[0] in names
        and path.name.removesuffix(".gz").endswith(extensions)
    ]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = pool.map(
            lambda path: search(bin_folder, out / "models.ossuary", path, path.name.split(".")[0]), files
        )
        rows = [{"writer": path.parent.name, "file": path.name, **row} for path, row in zip(files, found)]
    with open(out / "found.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, ["writer", "file", "before", "distance", "first", "fault"])
        table.writeheader()
        table.writerows(rows)
    sys.exit(0 if report(rows, options.most) else 1)


if __name__ == "__main__":
    main()
