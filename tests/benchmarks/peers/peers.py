#!/usr/bin/env python3
"""Compares stages of the skeleton engine with the fastest known libraries for the same work.

Same input, same run, one thread each side, in memory that is warm: the median of five runs in one
process after one that is not counted, each side's model by model (CGAL runs once, its times are
seconds, and no first touch of memory tells). Times are processor times: on a machine with other work
the clock on the wall would favour whoever is done within one slice of time. Writes a CSV a comparison into --out. See README.md for the packages that this needs.
"""

import argparse
import csv
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
RUNS = 5
# One model of each of the thesis' ten classes.
TEN_MODELS = (5, 25, 61, 125, 165, 185, 225, 281, 325, 393)
RESOLUTIONS = (128, 256)


def lines_of(command):
    """The JSON documents that a program prints, one a line."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", TBB_NUM_THREADS="1")
    done = subprocess.run(command, check=True, capture_output=True, text=True, env=environment)
    return [json.loads(line) for line in done.stdout.splitlines()]


def document_of(command):
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def median_ms(work):
    work()
    times = []
    for _ in range(RUNS):
        begin = time.process_time()
        result = work()
        times.append((time.process_time() - begin) * 1e3)
    return statistics.median(times), result


def write_csv(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    print(f"{path}: {len(rows)} rows")


def report_ratios(rows, key="ratio"):
    ratios = [row[key] for row in rows]
    print(f"  ratio: median {statistics.median(ratios):.1f}, least {min(ratios):.1f}, "
          f"greatest {max(ratios):.1f}")


def betti_text(betti):
    return f"{betti['components']} {betti['tunnels']} {betti['cavities']}"


def compare_thinning(programs, models, scratch, out):
    """`ossuary thin` against scikit-image's skeletonize_3d."""
    import numpy
    from skimage.morphology import skeletonize_3d

    rows = []
    for resolution in RESOLUTIONS:
        folder = scratch / f"solids-{resolution}"
        folder.mkdir(exist_ok=True)
        for solid in lines_of([programs.ours, "voxelize", str(resolution), "1", folder,
                               *models]):
            volume = numpy.load(solid["solid"])
            skimage_ms, theirs = median_ms(lambda: skeletonize_3d(volume))
            theirs_path = scratch / "theirs.npy"
            numpy.save(theirs_path, (theirs > 0).astype(numpy.uint8))
            betti_theirs = document_of(
                [programs.ossuary, "thin", theirs_path, scratch / "o.npy", "--json"])["betti_in"]
            row = {"model": solid["model"], "resolution": resolution, "voxels": solid["voxels"],
                   "skimage_ms": round(skimage_ms, 1), "skimage_betti": betti_text(betti_theirs)}
            for method in ("anchored", "parallel"):
                mine = document_of([programs.ossuary, "thin", solid["solid"], scratch / "o.npy",
                                    "--method", method, "--repeat", str(1 + RUNS), "--json"])
                took = statistics.median(mine["runs_processor_ms"][1:])
                row[f"{method}_ms"] = round(took, 2)
                row[f"{method}_ratio"] = round(skimage_ms / took, 1)
                row[f"{method}_betti"] = betti_text(mine["betti_out"])
            row["betti_of_solid"] = betti_text(mine["betti_in"])
            rows.append(row)
        for method in ("anchored", "parallel"):
            print(f"thinning at {resolution}, {method}")
            report_ratios([r for r in rows if r["resolution"] == resolution], f"{method}_ratio")
    write_csv(out / "thinning.csv", rows)


def vtk_solid(polygons, origin, spacing, extent):
    """The mesh's inside by VTK's stencil, as a function that runs it anew each time."""
    import vtk

    # A stencil samples at the grid's points; ours at the middle of voxels.
    origin = [coordinate + spacing / 2 for coordinate in origin]

    def run():
        stencil = vtk.vtkPolyDataToImageStencil()
        stencil.SetInputData(polygons)
        stencil.SetOutputOrigin(*origin)
        stencil.SetOutputSpacing(spacing, spacing, spacing)
        stencil.SetOutputWholeExtent(*extent)
        stencil.Update()
        return stencil.GetOutput()

    return run


def compare_voxelization(programs, models, scratch, out):
    """Solid voxelization against VTK's vtkPolyDataToImageStencil, on the same grid.

    `sampled` is the work that VTK does, `whole` also keeps thin parts, fills cavities, joins
    components and closes tunnels.
    """
    import numpy
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    vtk.vtkSMPTools.Initialize(1)
    rows = []
    for resolution in RESOLUTIONS:
        folder = scratch / f"solids-{resolution}"
        folder.mkdir(exist_ok=True)
        for path in models:
            solid = lines_of([programs.ours, "voxelize", str(resolution), str(RUNS), folder,
                              path])[0]
            ours = numpy.load(solid["solid"]) > 0
            extent = [0, ours.shape[0] - 1, 0, ours.shape[1] - 1, 0, ours.shape[2] - 1]
            work = vtk_solid(polygons_of(path), solid["origin"], solid["voxel_size"], extent)
            vtk_ms, stencil = median_ms(work)
            image = vtk.vtkImageStencilToImage()
            image.SetInputData(stencil)
            image.SetInsideValue(1)
            image.SetOutsideValue(0)
            image.Update()
            theirs = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
            theirs = theirs.reshape(ours.shape[::-1]).transpose(2, 1, 0) > 0
            row = {"model": solid["model"], "resolution": resolution,
                   "voxels": solid["voxels"], "method": solid["method"],
                   "vtk_ms": round(vtk_ms, 2)}
            for name, run in (("sampled", solid["sampled"]), ("whole", solid)):
                took = statistics.median(run["runs_processor_ms"])
                row[f"{name}_ms"] = round(took, 2)
                row[f"{name}_ratio"] = round(vtk_ms / took, 1)
                row[f"{name}_differing"] = int(((numpy.load(run["solid"]) > 0) != theirs).sum())
            rows.append(row)
        for name in ("sampled", "whole"):
            print(f"voxelization at {resolution}, {name}")
            report_ratios([r for r in rows if r["resolution"] == resolution], f"{name}_ratio")
    write_csv(out / "voxelization.csv", rows)


def polygons_of(path):
    """An OFF file of triangles as vtkPolyData."""
    import vtk

    with open(path, encoding="ascii") as text:
        words = text.read().split()
    points_count, faces_count = int(words[1]), int(words[2])
    points, polygons = vtk.vtkPoints(), vtk.vtkCellArray()
    at = 4
    for _ in range(points_count):
        points.InsertNextPoint(*(float(w) for w in words[at:at + 3]))
        at += 3
    for _ in range(faces_count):
        corners = int(words[at])
        polygons.InsertNextCell(corners)
        for corner in words[at + 1:at + 1 + corners]:
            polygons.InsertCellPoint(int(corner))
        at += 1 + corners
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(polygons)
    return data


def compare_skeletons(programs, models, scratch, out):
    """Mesh to refined skeleton against CGAL's mean curvature flow skeletonization."""
    peer = scratch / "cgal_skeleton"
    subprocess.run(["g++", "-std=c++17", "-O3", "-DNDEBUG", "-isystem", "/usr/include/eigen3",
                    "-DCGAL_EIGEN3_ENABLED", HERE / "cgal_skeleton.cpp", "-o", peer,
                    "-lgmp", "-lmpfr"], check=True)
    rows = []
    for model in models:
        line = lines_of([peer, model])[0]
        if "refused" in line:
            continue
        mine = lines_of([programs.ours, "skeletonize", str(RUNS), model])[0]
        ours_ms = statistics.median(mine["runs_processor_ms"])
        rows.append({"model": line["model"], "faces": mine["faces"],
                     "cgal_ms": round(line["ms"], 1), "ours_ms": round(ours_ms, 2),
                     "ratio": round(line["ms"] / ours_ms, 1)})
    print(f"skeletons of {len(rows)} closed models of {len(models)}")
    cgal_mean = statistics.mean(row["cgal_ms"] for row in rows)
    ours_mean = statistics.mean(row["ours_ms"] for row in rows)
    print(f"  means {cgal_mean:.0f} and {ours_mean:.1f} ms: {cgal_mean / ours_mean:.0f} times")
    report_ratios(rows)
    write_csv(out / "skeletons.csv", rows)


def scores_of(programs, collection, scratch, *more):
    """What `evaluate-segmentation` finds, by the number of the model."""
    subprocess.run([programs.ossuary, "evaluate-segmentation", "--jobs", "1",
                    "--models", collection / "off", "--truth", collection / "seg",
                    "--classes", collection / "segmentation-all.cla", "--out", scratch, *more],
                   check=True, stdout=subprocess.DEVNULL)
    with open(scratch / "scores.csv", encoding="utf-8") as file:
        return {row["model"]: row for row in csv.DictReader(file)}


def compare_segmentation(programs, collection, scratch, out):
    """Parts by CGAL's shape diameters with its defaults, and ours: processor time and Rand index
    error of every model of the segmentation benchmark. Some 25 minutes."""
    cut = subprocess.run([programs.cgal, collection / "off", scratch / "cgal"], check=True,
                         capture_output=True, text=True)
    cgal = scores_of(programs, collection, scratch / "cgal-scores",
                     "--segmentations", scratch / "cgal")
    ours = scores_of(programs, collection, scratch / "ours-scores")
    rows = [{"model": row["model"], "class": ours[row["model"]]["class"], "faces": row["faces"],
             "ours_ms": row["ours_ms"], "cgal_ms": row["cgal_ms"],
             "ratio": round(float(row["cgal_ms"]) / float(row["ours_ms"]), 1),
             "ours_rand_index_error": round(float(ours[row["model"]]["rand_index_error"]), 4),
             "cgal_rand_index_error": round(float(cgal[row["model"]]["rand_index_error"]), 4)}
            for row in csv.DictReader(cut.stdout.splitlines())]
    write_csv(out / "segmentation.csv", rows)
    report_ratios(rows)


def models_of_benchmark(collection, numbers):
    return [collection / "off" / f"{number}.off" for number in numbers]


def five_of_each_class():
    """Numbers 1 to 400 in classes of twenty, without the one class that is not distributed."""
    return [first + step for first in range(1, 400, 20) if first != 261
            for step in (0, 4, 8, 12, 16)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("work", nargs="+", choices=("thinning", "voxelization", "skeletons", "segmentation"))
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--data", type=pathlib.Path,
                        default=os.environ.get("OSSUARY_DATA", "/tmp/ossuary-data"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."))
    programs = parser.parse_args()
    programs.ossuary = programs.build / "ossuary"
    programs.ours = programs.build / "ossuary_peer_ours"
    programs.cgal = programs.build / "ossuary_peer_cgal"
    collection = programs.data / "princeton-segmentation"
    if not collection.is_dir():
        sys.exit(f"{collection}: not found; name the benchmark's folder with --data")
    programs.out.mkdir(parents=True, exist_ok=True)
    ten = models_of_benchmark(collection, TEN_MODELS)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        if "thinning" in programs.work:
            compare_thinning(programs, ten, scratch, programs.out)
        if "voxelization" in programs.work:
            compare_voxelization(programs, ten, scratch, programs.out)
        if "skeletons" in programs.work:
            compare_skeletons(programs, models_of_benchmark(collection, five_of_each_class()),
                              scratch, programs.out)
        if "segmentation" in programs.work:
            compare_segmentation(programs, collection, scratch, programs.out)


if __name__ == "__main__":
    main()
