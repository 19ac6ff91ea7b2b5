"""Writes OFF models with VTK: surfaces, and what is inside them as volumes (with numpy, nibabel and teem as well).

    in_vtk.py FOLDER MODEL.off…
"""

import pathlib
import shutil
import subprocess
import sys

import numpy
import vtk
from off import read_off
from vtk.util import numpy_support

VOXELS = 200  # along the longest side


def surface_of(model):
    vertices, faces = read_off(model)
    points = vtk.vtkPoints()
    for vertex in vertices:
        points.InsertNextPoint(vertex)
    cells = vtk.vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def write_surfaces(surface, place):
    writers = {
        ("stl", ".stl"): vtk.vtkSTLWriter(),
        ("stl-text", ".stl"): vtk.vtkSTLWriter(),
        ("ply", ".ply"): vtk.vtkPLYWriter(),
        ("ply-text", ".ply"): vtk.vtkPLYWriter(),
        ("obj", ".obj"): vtk.vtkOBJWriter(),
    }
    for (variant, extension), writer in writers.items():
        if variant in ("stl", "ply"):
            writer.SetFileTypeToBinary()
        elif variant != "obj":
            writer.SetFileTypeToASCII()
        writer.SetInputData(surface)
        writer.SetFileName(place(variant, extension))
        writer.Write()


def write_scenes(surface, place):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.AddRenderer(renderer)
    gltf = vtk.vtkGLTFExporter()
    gltf.InlineDataOn()
    gltf.SetFileName(place("gltf", ".gltf"))
    x3d = vtk.vtkX3DExporter()
    x3d.SetFileName(place("x3d", ".x3d"))
    for exporter in (gltf, x3d):
        exporter.SetRenderWindow(window)
        exporter.SetActiveRenderer(renderer)
        exporter.Write()


def solid_of(surface):
    """Bytes of 0 and 1 at the centres of voxels, with one voxel of outside around."""
    box = surface.GetBounds()
    sides = [box[1] - box[0], box[3] - box[2], box[5] - box[4]]
    spacing = max(sides) / VOXELS
    counts = [int(side / spacing) + 3 for side in sides]
    image = vtk.vtkImageData()
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(*(box[2 * axis] - spacing for axis in range(3)))
    image.SetDimensions(*counts)
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(1)
    stencil = vtk.vtkPolyDataToImageStencil()
    stencil.SetInputData(surface)
    stencil.SetOutputOrigin(image.GetOrigin())
    stencil.SetOutputSpacing(image.GetSpacing())
    stencil.SetOutputWholeExtent(image.GetExtent())
    cut = vtk.vtkImageStencil()
    cut.SetInputData(image)
    cut.SetStencilConnection(stencil.GetOutputPort())
    cut.SetBackgroundValue(0)
    cut.Update()
    return cut.GetOutput()


def write_volumes(surface, place):
    solid = solid_of(surface)
    writer = vtk.vtkNIFTIImageWriter()
    writer.SetInputData(solid)
    writer.SetFileName(place("nii", ".nii"))
    writer.Write()
    values = numpy_support.vtk_to_numpy(solid.GetPointData().GetScalars())
    values = values.reshape(solid.GetDimensions(), order="F")
    numpy.save(place("npy", ".npy", "numpy"), values)
    try:
        import nibabel
    except ImportError:
        print("nibabel: not installed", file=sys.stderr)
    else:
        affine = numpy.diag([*solid.GetSpacing(), 1.0])
        affine[:3, 3] = solid.GetOrigin()
        nibabel.save(nibabel.Nifti1Image(values, affine), place("nii", ".nii.gz", "nibabel"))
    if not shutil.which("teem-unu"):
        print("teem: not installed", file=sys.stderr)
        return
    for variant, encoding in (("nrrd", "raw"), ("nrrd-gzip", "gzip"), ("nrrd-text", "ascii")):
        sizes = [str(count) for count in solid.GetDimensions()]
        spacings = [repr(spacing) for spacing in solid.GetSpacing()]
        command = ["teem-unu", "make", "-i", "-", "-t", "uchar", "-s", *sizes, "-sp", *spacings, "-e", "raw"]
        made = subprocess.run(command, input=values.tobytes(order="F"), stdout=subprocess.PIPE, check=True).stdout
        to = place(variant, ".nrrd", "teem")
        subprocess.run(["teem-unu", "save", "-f", "nrrd", "-e", encoding, "-i", "-", "-o", to], input=made, check=True)


def main(folder, models):
    for model in models:

        def place(variant, extension, program="vtk", model=model):
            to = folder / f"{program}-{variant}"
            to.mkdir(parents=True, exist_ok=True)
            return str(to / (model.stem + extension))

        surface = surface_of(model)
        write_surfaces(surface, place)
        write_scenes(surface, place)
        write_volumes(surface, place)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), [pathlib.Path(argument) for argument in sys.argv[2:]])
