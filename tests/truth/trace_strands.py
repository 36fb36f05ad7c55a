"""Path-traces strands of hair as the truth that pictures of coif are compared with. Runs inside Blender:

    blender -b --factory-startup --python trace_strands.py -- JOB.json

JOB.json: {"strands": "X.hair", "body": "X.glb" or null, "folder": "OUT", "samples": 32, "pictures": [...]}, where each picture has
"name", "size" (pixels each way), "base_color" (linear), "camera" and "lights" as `coif render --format json` prints them: metres, Y up.

Hair is Cycles' Principled Hair BSDF (Chiang et al. 2016), lights are distant, the sky is white and even. The body casts shadows and hands
light on, but is cut out of the picture, which is linear, with the hair's coverage as alpha. For each light, the sky, and
"studio" (all lights and a faint sky), and for each of two seeds, OUT/NAME.LIGHT.SEED.exr; two seeds because the product of two independent
pictures has no noise in its mean.
"""
import json
import math
import pathlib
import struct
import sys

import numpy

for alias, own in (("bool", bool), ("object", object), ("int", int), ("float", float)):
    setattr(numpy, alias, own)  # Blender 3.4's importer asks Debian's numpy for names that it no longer has

import bpy
import mathutils

FIBER = {"Roughness": 0.3, "Radial Roughness": 0.5, "Coat": 0.0, "IOR": 1.55, "Offset": math.radians(2)}
SUN_ANGLE = 0.01  # radians: a sharp shadow, but no infinitely sharp one
SEEDS = (1, 2)
STUDIO_SKY = 0.065  # of white, in the picture of all lights


def read_hair(path):
    """Points of each strand, one list of arrays in metres with Z up, and widths of all points, of a .hair file that coif wrote."""
    data = pathlib.Path(path).read_bytes()
    strands, points, arrays = struct.unpack_from("<4xIII", data)
    thickness = struct.unpack_from("<f", data, 20)[0]
    at = 128
    segments = numpy.frombuffer(data, "<u2", strands, at)
    at += 2 * strands
    places = numpy.frombuffer(data, "<f4", 3 * points, at).reshape(-1, 3)
    at += 12 * points
    widths = numpy.frombuffer(data, "<f4", points, at) if arrays & 4 else numpy.full(points, thickness, "f4")
    return segments.astype(int) + 1, places, widths


def add_strands(path):
    counts, places, widths = read_hair(path)
    curve = bpy.data.curves.new("hair", "CURVE")
    curve.dimensions = "3D"
    begin = 0
    for count in counts:
        spline = curve.splines.new("POLY")
        spline.points.add(int(count) - 1)
        corners = numpy.ones((count, 4), "f4")
        corners[:, :3] = places[begin:begin + count]
        spline.points.foreach_set("co", corners.ravel())
        begin += count
    hair = bpy.data.objects.new("hair", curve)
    bpy.context.collection.objects.link(hair)
    bpy.context.view_layer.objects.active = hair
    hair.select_set(True)
    bpy.ops.object.convert(target="CURVES")
    hair = bpy.context.object
    radius = hair.data.attributes.get("radius") or hair.data.attributes.new("radius", "FLOAT", "POINT")
    radius.data.foreach_set("value", 0.5 * widths)
    hair.select_set(False)
    return hair


def fiber_material():
    material = bpy.data.materials.new("fiber")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    fiber = nodes.new("ShaderNodeBsdfHairPrincipled")
    fiber.parametrization = "COLOR"
    for name, value in FIBER.items():
        fiber.inputs[name].default_value = value
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(fiber.outputs[0], output.inputs[0])
    return material, fiber.inputs["Color"]


def add_body(path):
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    for item in set(bpy.data.objects) - before:
        item.is_holdout = True


def z_up(v):
    return mathutils.Vector((v[0], -v[2], v[1]))


def prepare(samples):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = samples, False, False
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = cycles.diffuse_bounces = 64
    cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    scene.render.film_transparent = True
    scene.render.image_settings.file_format = "PNG"
    scene.cycles_curves.shape = "THICK" if hasattr(scene, "cycles_curves") else "RIBBONS"
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (1, 1, 1, 1)
    scene.world.lightgroup = "sky"
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    bpy.context.collection.objects.link(camera)
    scene.camera = camera
    return scene


def add_lights(names):
    groups = bpy.context.view_layer.lightgroups
    suns = {}
    for name in [*names, "sky"]:
        groups.add(name=name)
        if name == "sky":
            continue
        lamp = bpy.data.lights.new(name, "SUN")
        lamp.angle = SUN_ANGLE
        suns[name] = bpy.data.objects.new(name, lamp)
        suns[name].lightgroup = name
        bpy.context.collection.objects.link(suns[name])
    return suns


def aim(scene, suns, picture):
    camera = picture["camera"]
    axes = mathutils.Matrix([z_up(camera[key]) for key in ("right", "up", "back")]).transposed()
    scene.camera.matrix_world = mathutils.Matrix.Translation(z_up(camera["eye"])) @ axes.to_4x4()
    scene.camera.data.sensor_fit = "AUTO"
    scene.camera.data.angle = math.radians(camera["fov_degrees"])
    scene.camera.data.clip_start, scene.camera.data.clip_end = 0.01, 100
    for light in picture["lights"]:
        sun = suns[light["name"]]
        sun.rotation_euler = (-z_up(light["towards"])).to_track_quat("-Z", "Y").to_euler()
        sun.data.color = light["color"]
        sun.data.energy = math.pi  # a white matte surface that faces the light shows its colour


def mixed(tree, way, first, second):
    node = tree.nodes.new("CompositorNodeMixRGB")
    node.blend_type = way
    tree.links.new(first, node.inputs[1])
    if isinstance(second, tuple):
        node.inputs[2].default_value = second
    else:
        tree.links.new(second, node.inputs[2])
    return node.outputs[0]


def write_slot(tree, writer, light, layers, name):
    covered = tree.nodes.new("CompositorNodeSetAlpha")
    covered.mode = "REPLACE_ALPHA"
    tree.links.new(light, covered.inputs["Image"])
    tree.links.new(layers.outputs["Alpha"], covered.inputs["Alpha"])
    writer.file_slots.new(name)
    tree.links.new(covered.outputs[0], writer.inputs[-1])


def write_passes(scene, folder, name, seed):
    """A compositor that writes each light's picture with the hair's coverage."""
    scene.use_nodes = True
    tree = scene.node_tree
    tree.nodes.clear()
    layers = tree.nodes.new("CompositorNodeRLayers")
    writer = tree.nodes.new("CompositorNodeOutputFile")
    writer.base_path = str(folder)
    writer.format.file_format, writer.format.color_depth, writer.format.color_mode = "OPEN_EXR", "32", "RGBA"
    writer.format.exr_codec = "ZIP"
    writer.file_slots.clear()
    studio = None
    for group in bpy.context.view_layer.lightgroups:
        light = layers.outputs["Combined_" + group.name]
        write_slot(tree, writer, light, layers, f"{name}.{group.name}.{seed}.")
        share = mixed(tree, "MULTIPLY", light, (STUDIO_SKY,) * 3 + (1,)) if group.name == "sky" else light
        studio = share if studio is None else mixed(tree, "ADD", studio, share)
    write_slot(tree, writer, studio, layers, f"{name}.studio.{seed}.")
    tree.links.new(layers.outputs["Image"], tree.nodes.new("CompositorNodeComposite").inputs[0])


def main():
    job = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    folder = pathlib.Path(job["folder"]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hair = add_strands(job["strands"])
    material, color = fiber_material()
    hair.data.materials.append(material)
    if job.get("body"):
        add_body(job["body"])
    scene = prepare(job["samples"])
    suns = add_lights([light["name"] for light in job["pictures"][0]["lights"]])
    for picture in job["pictures"]:
        scene.render.resolution_x, scene.render.resolution_y = picture["size"]
        color.default_value = (*picture["base_color"], 1)
        aim(scene, suns, picture)
        for seed in SEEDS:
            scene.cycles.seed = seed
            write_passes(scene, folder, picture["name"], seed)
            bpy.ops.render.render()
            for path in folder.glob(f"{picture['name']}.*.{seed}.0*.exr"):  # the compositor adds the frame's number
                path.replace(path.with_name(path.name[:-len("0001.exr")].rstrip(".") + ".exr"))


main()
