"""Run by Blender: writes OFF models in each of its formats.

    blender --background --factory-startup --python in_blender.py -- FOLDER MODEL.off…
"""

import contextlib
import pathlib
import sys

import addon_utils
import bpy

sys.path.append(str(pathlib.Path(__file__).parent))
from off import read_off  # noqa: E402: Blender does not look beside its script


WRITERS = {
    "stl": (".stl", lambda to: bpy.ops.export_mesh.stl(filepath=to)),
    "stl-text": (".stl", lambda to: bpy.ops.export_mesh.stl(filepath=to, ascii=True)),
    "ply": (".ply", lambda to: bpy.ops.export_mesh.ply(filepath=to)),
    "ply-text": (".ply", lambda to: bpy.ops.export_mesh.ply(filepath=to, use_ascii=True)),
    "obj": (".obj", lambda to: bpy.ops.wm.obj_export(filepath=to)),
    "obj-old": (".obj", lambda to: bpy.ops.export_scene.obj(filepath=to)),
    "dae": (".dae", lambda to: bpy.ops.wm.collada_export(filepath=to)),
    "fbx": (".fbx", lambda to: bpy.ops.export_scene.fbx(filepath=to)),
    "x3d": (".x3d", lambda to: bpy.ops.export_scene.x3d(filepath=to)),
    "glb": (".glb", lambda to: bpy.ops.export_scene.gltf(filepath=to, export_format="GLB")),
    "gltf": (".gltf", lambda to: bpy.ops.export_scene.gltf(filepath=to, export_format="GLTF_EMBEDDED")),
    "gltf-bin": (".gltf", lambda to: bpy.ops.export_scene.gltf(filepath=to, export_format="GLTF_SEPARATE")),
}


def main(folder, models):
    for module in ("io_mesh_stl", "io_mesh_ply", "io_scene_obj", "io_scene_fbx", "io_scene_x3d", "io_scene_gltf2"):
        addon_utils.enable(module)
    for model in models:
        bpy.ops.wm.read_homefile(use_empty=True)
        mesh = bpy.data.meshes.new(model.stem)
        vertices, faces = read_off(model)
        mesh.from_pydata(vertices, [], faces)
        thing = bpy.data.objects.new(model.stem, mesh)
        bpy.context.collection.objects.link(thing)
        thing.select_set(True)
        bpy.context.view_layer.objects.active = thing
        for variant, (extension, write) in WRITERS.items():
            to = folder / f"blender-{variant}"
            to.mkdir(parents=True, exist_ok=True)
            try:
                with contextlib.redirect_stdout(None):
                    write(str(to / (model.stem + extension)))
            except Exception as error:  # an exporter's own fault is reported, the others go on
                print(f"{variant}: {error}".splitlines()[0], file=sys.stderr)


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    main(pathlib.Path(arguments[0]), [pathlib.Path(argument) for argument in arguments[1:]])
