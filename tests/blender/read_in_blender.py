"""Runs inside Blender: dumps what Blender's own importer makes of FBX, OBJ and COLLADA files.

    blender -b --factory-startup --python read_in_blender.py -- FILE OUT.json [FILE OUT.json]...

Positions are in metres, Y up, as coif has them; meshes stand where modifiers (armatures, shape keys) put them.
"""
import json
import pathlib
import sys
import tempfile

import bpy
from io_scene_fbx import import_fbx as fbx_importer

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import text_fbx


def keep_normals(read_normals):
    """Blender keeps a corner's normal as two short angles, and one for all corners whose normals are alike within 0.8 degrees."""
    def read_and_keep(fbx_mesh, mesh, transform=None):
        is_read = read_normals(fbx_mesh, mesh, transform)
        if is_read:
            mesh.attributes.new(FILE_NORMALS, "FLOAT_VECTOR", "CORNER").data.foreach_set("vector", numbers(mesh.loops, "normal", 3))
        return is_read
    return read_and_keep


FILE_NORMALS = "normals of the file"
fbx_importer.blen_read_geom_layer_normal = keep_normals(fbx_importer.blen_read_geom_layer_normal)


def import_fbx(path):
    # Colours as floats, since bytes would round them.
    bpy.ops.import_scene.fbx(filepath=str(path), use_anim=False, colors_type="LINEAR", use_image_search=False)


def import_file(path):
    suffix = path.suffix.lower()
    if suffix == ".fbx" and not path.read_bytes().startswith(b"Kaydara FBX Binary"):
        with tempfile.TemporaryDirectory() as folder:
            text_fbx.write_as_binary(path, pathlib.Path(folder) / "m.fbx")
            import_fbx(pathlib.Path(folder) / "m.fbx")
    elif suffix == ".fbx":
        import_fbx(path)
    elif suffix == ".obj":
        bpy.ops.wm.obj_import(filepath=str(path))
    else:
        bpy.ops.wm.collada_import(filepath=str(path), custom_normals=True)


def numbers(collection, attribute, width):
    out = [0.0] * (len(collection) * width)
    collection.foreach_get(attribute, out)
    return out


def placed(matrix, point):
    """In double precision, from Blender's Z up to Y up."""
    x, y, z = (sum(matrix[row][k] * point[k] for k in range(3)) + matrix[row][3] for row in range(3))
    return x, z, -y


def placed_normal(inverse, normal):
    x, y, z = (sum(inverse[k][row] * normal[k] for k in range(3)) for row in range(3))
    length = (x * x + y * y + z * z) ** 0.5 or 1.0
    return x / length, z / length, -y / length


def triples(matrix, flat, place):
    rows = [list(row) for row in matrix]
    out = []
    for i in range(0, len(flat), 3):
        out.extend(place(rows, flat[i:i + 3]))
    return out


def upstream(socket):
    """The nodes that a socket takes its value from, nearest first."""
    nodes = [link.from_node for link in socket.links]
    for node in nodes:
        for other in node.inputs:
            nodes.extend(link.from_node for link in other.links if link.from_node not in nodes)
    return nodes


def mapping_of(node):
    if node.vector_type not in ("POINT", "TEXTURE"):
        raise SystemExit(f"a mapping of type {node.vector_type}")
    return {"type": node.vector_type, **{what: list(node.inputs[what].default_value)[:3] for what in ("Location", "Rotation", "Scale")}}


def surface_of(material):
    """Where the base colour's image is looked up: the UV map, what moves it, and how it goes on outside of 0..1."""
    surface = {"name": material.name if material else "", "image": False}
    if material is None or not material.use_nodes:
        return surface
    for shader in material.node_tree.nodes:
        if shader.type != "BSDF_PRINCIPLED":
            continue
        found = upstream(shader.inputs["Base Color"])
        for node in found:
            if node.type == "TEX_IMAGE" and not surface["image"]:
                surface.update(image=True, extension=node.extension)
            if node.type == "MAPPING":
                surface["mapping"] = mapping_of(node)
            if node.type == "UVMAP":
                surface["uv_map"] = node.uv_map
    return surface


def bones_of(instance):
    armatures = [modifier.object for modifier in instance.modifiers if modifier.type == "ARMATURE" and modifier.object]
    return {bone.name for armature in armatures for bone in armature.data.bones if bone.use_deform}


def weights_of(mesh, instance):
    bones = bones_of(instance)
    if not bones:
        return None
    names = [group.name for group in instance.vertex_groups]
    return [[[names[g.group], g.weight] for g in vertex.groups if g.weight > 0 and names[g.group] in bones] for vertex in mesh.vertices]


def colors_of(mesh):
    layer = mesh.color_attributes[mesh.color_attributes.render_color_index] if len(mesh.color_attributes) else None
    if layer is None:
        return None
    return {"domain": layer.domain, "type": layer.data_type, "values": numbers(layer.data, "color", 4)}


def normals_of(mesh, matrix):
    if FILE_NORMALS in mesh.attributes:
        flat = numbers(mesh.attributes[FILE_NORMALS].data, "vector", 3)
    elif mesh.has_custom_normals:
        mesh.calc_normals_split()
        flat = numbers(mesh.loops, "normal", 3)
    else:
        return None
    return triples(matrix.inverted_safe(), flat, placed_normal)


def is_on_bone(object):
    while object is not None:
        if object.parent_type == "BONE":
            return True
        object = object.parent
    return False


def described(instance, matrix):
    mesh = instance.to_mesh()
    render = [layer.name for layer in mesh.uv_layers if layer.active_render]
    return {
        "name": instance.name,
        "held": bool(bones_of(instance)) or is_on_bone(instance),
        "mirrored": matrix.determinant() < 0,
        "positions": triples(matrix, numbers(mesh.vertices, "co", 3), placed),
        "sizes": [p.loop_total for p in mesh.polygons],
        "vertices": [loop.vertex_index for loop in mesh.loops],
        "normals": normals_of(mesh, matrix),
        "uvs": {layer.name: numbers(layer.data, "uv", 2) for layer in mesh.uv_layers},
        "uv_render": render[0] if render else None,
        "colors": colors_of(mesh),
        "weights": weights_of(mesh, instance),
        "materials": [surface_of(slot.material) for slot in instance.material_slots],
        "material": [p.material_index for p in mesh.polygons],
    }


def read(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        import_file(path)
    except RuntimeError as error:
        return {"error": " ".join(str(error).split())}
    shown = bpy.context.evaluated_depsgraph_get()
    meshes = [described(i.object, i.matrix_world.copy()) for i in shown.object_instances if i.object.type == "MESH"]
    return {"meshes": [mesh for mesh in meshes if mesh["sizes"]]}


arguments = sys.argv[sys.argv.index("--") + 1:]
for source, out in zip(arguments[::2], arguments[1::2]):
    pathlib.Path(out).write_text(json.dumps(read(pathlib.Path(source))))
