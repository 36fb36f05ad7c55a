"""Runs inside Blender: small scenes, exported in every format and way. The text FBX files are written by hand, with what Blender never writes.

    blender -b --factory-startup --python make_files.py -- FOLDER
"""
import math
import pathlib
import sys

import bpy


def strip(name, columns=3, rows=7):
    """A card that narrows and bends, with two UV maps, vertex colours and normals of its own."""
    vertices = [((c - 1) * (0.03 - 0.003 * r), 0.01 * r * r * 0.1, 1.7 - 0.05 * r) for r in range(rows) for c in range(columns)]
    faces = [(r * columns + c, (r + 1) * columns + c, (r + 1) * columns + c + 1, r * columns + c + 1) for r in range(rows - 1) for c in range(columns - 1)]
    faces[-1:] = [faces[-1][:3], (faces[-1][0], faces[-1][2], faces[-1][3])]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    for layer, turn in ((mesh.uv_layers.new(name="HairUV"), 0.0), (mesh.uv_layers.new(name="Other"), 0.5)):
        for loop in mesh.loops:
            r, c = divmod(loop.vertex_index, columns)
            layer.data[loop.index].uv = (c / 2 + turn, 1 - r / 6 * 1.5)
    colors = mesh.color_attributes.new("Col", "FLOAT_COLOR", "CORNER")
    for loop in mesh.loops:
        colors.data[loop.index].color = (loop.vertex_index / 21, 0.5, 1 - loop.vertex_index / 21, 1)
    mesh.use_auto_smooth = True
    mesh.normals_split_custom_set([(math.sin(i), -2, math.cos(i)) for i in range(len(mesh.loops))])
    mesh.materials.append(bpy.data.materials["Hair"])
    object = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(object)
    return object


def hair_material(folder):
    image = bpy.data.images.new("hair", 4, 4)
    image.filepath_raw, image.file_format = str(folder / "hair.png"), "PNG"
    image.save()
    material = bpy.data.materials.new("Hair")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    texture = nodes.new("ShaderNodeTexImage")
    texture.image, texture.extension = image, "EXTEND"
    links.new(texture.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])


def placed_scene():
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.location, parent.rotation_euler, parent.scale = (0.1, 0.2, 0.3), (0.3, -0.2, 0.5), (1.2, 1.2, 1.2)
    child = strip("turned")
    child.parent, child.location, child.rotation_euler = parent, (0, 0.1, 0), (0, 0.4, 0)
    strip("mirrored").scale = (-1, 1, 1)
    twin = bpy.data.objects.new("twin", child.data)
    bpy.context.scene.collection.objects.link(twin)
    twin.location = (0.5, 0, 0)


def skinned_scene():
    armature = bpy.data.objects.new("rig", bpy.data.armatures.new("rig"))
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    above = None
    for i in range(3):
        bone = armature.data.edit_bones.new(f"hair{i}")
        bone.head, bone.tail, bone.parent = (0, 0, 1.7 - 0.1 * i), (0, 0.01, 1.6 - 0.1 * i), above
        above = bone
    bpy.ops.object.mode_set(mode="OBJECT")
    object = strip("skinned")
    object.parent = armature
    object.modifiers.new("rig", "ARMATURE").object = armature
    groups = [object.vertex_groups.new(name=f"hair{i}") for i in range(3)]
    for vertex in object.data.vertices:
        place = (1.7 - vertex.co.z) / 0.15
        for i, group in enumerate(groups):
            group.add([vertex.index], max(0.0, 1 - abs(place - i)) if place < 2 else float(i == 2), "REPLACE")


def keyed_scene():
    object = strip("keyed")
    object.shape_key_add(name="Basis")
    key = object.shape_key_add(name="Long")
    for point in key.data:
        point.co.z -= 0.3 * (1.7 - point.co.z)
    key.value = 0.5


def export(folder, name):
    fbx = lambda way, **options: bpy.ops.export_scene.fbx(filepath=str(folder / f"{name}_{way}.fbx"), add_leaf_bones=False, **options)
    fbx("default")
    fbx("units", apply_scale_options="FBX_SCALE_ALL")
    fbx("z_up", axis_forward="X", axis_up="Z")
    if name != "skinned":
        fbx("baked", bake_space_transform=True)
    bpy.ops.wm.obj_export(filepath=str(folder / f"{name}.obj"), export_colors=True)
    if name != "keyed":
        bpy.ops.wm.collada_export(filepath=str(folder / f"{name}.dae"))


MODEL = """  Model: {id}, "Model::{name}", "{kind}" {{
    Version: 232
    Properties70:  {{
{properties}    }}
  }}
"""

# A quad, a triangle twice and a triangle without area.
GEOMETRY = """  Geometry: {id}, "Geometry::{name}", "Mesh" {{
    Vertices: *18 {{
      a: 0,0,0,10,0,0,10,5,1,0,5,0,5,9,0,5,9,0
    }}
    PolygonVertexIndex: *13 {{
      a: 0,1,2,-4,3,2,-5,2,4,-4,3,4,-6
    }}
    GeometryVersion: 124
    LayerElementUV: 0 {{
      Version: 101
      Name: "UVMap"
      MappingInformationType: "ByPolygonVertex"
      ReferenceInformationType: "Direct"
      UV: *26 {{
        a: 0,0,1,0,1,0.5,0,0.5,0,0.5,1,0.5,0.5,1,1,0.5,0.5,1,0,0.5,0,0.5,0.5,1,0.5,1
      }}
    }}
    LayerElementMaterial: 0 {{
      Version: 101
      Name: ""
      MappingInformationType: "AllSame"
      ReferenceInformationType: "IndexToDirect"
      Materials: *1 {{
        a: 0
      }}
    }}
    Layer: 0 {{
      Version: 100
      LayerElement:  {{
        Type: "LayerElementMaterial"
        TypedIndex: 0
      }}
      LayerElement:  {{
        Type: "LayerElementUV"
        TypedIndex: 0
      }}
    }}
  }}
"""

FILE = """; FBX 7.4.0 project file
FBXHeaderExtension:  {{
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}}
GlobalSettings:  {{
  Version: 1000
  Properties70:  {{
    P: "UpAxis", "int", "Integer", "",{up}
    P: "UpAxisSign", "int", "Integer", "",1
    P: "FrontAxis", "int", "Integer", "",{front}
    P: "FrontAxisSign", "int", "Integer", "",{front_sign}
    P: "CoordAxis", "int", "Integer", "",0
    P: "CoordAxisSign", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",{unit}
  }}
}}
Objects:  {{
{objects}  Material: 50, "Material::Hair", "" {{
    Version: 102
    ShadingModel: "phong"
  }}
  Texture: 60, "Texture::hair", "" {{
    Type: "TextureVideoClip"
    FileName: "hair.png"
    RelativeFilename: "hair.png"
    Properties70:  {{
      P: "WrapModeU", "enum", "", "",{wrap}
      P: "WrapModeV", "enum", "", "",{wrap}
    }}
  }}
}}
Connections:  {{
{connections}  C: "OP",60,50, "DiffuseColor"
}}
"""


def vector(name, x, y, z):
    return f'      P: "{name}", "Vector3D", "Vector", "",{x},{y},{z}\n'


HIDDEN = '      P: "Visibility", "Visibility", "", "A",0\n'
MOVED = vector("Lcl Translation", 3, 100, -7)
TURNED = MOVED + vector("Lcl Rotation", 20, -35, 50)
ACTIVE = '      P: "RotationActive", "bool", "", "",1\n'

# Lines of each model's properties; each stands below the one before.
TEXTS = {
    "plain": [TURNED],
    "geometric": [TURNED + vector("GeometricTranslation", 1, 2, 3) + vector("GeometricRotation", 10, 20, 30) + vector("GeometricScaling", 1, 2, 1.5)],
    "geometric_below": [MOVED, TURNED + vector("GeometricTranslation", 1, 2, 3)],
    "geometric_above": [TURNED + vector("GeometricTranslation", 1, 20, 3), MOVED],
    "rotation_pivot": [TURNED + vector("RotationPivot", 1, 2, 3) + vector("RotationOffset", 4, 5, 6), MOVED],
    "scaling_pivot": [TURNED + vector("Lcl Scaling", 1, 2, 3) + vector("ScalingPivot", 1, 2, 3) + vector("ScalingOffset", 4, 5, 6), MOVED],
    "pre_rotation": [TURNED + ACTIVE + vector("PreRotation", 40, 10, -20), MOVED],
    "post_rotation": [TURNED + ACTIVE + vector("PostRotation", 40, 10, -20), MOVED],
    "rotation_order": [TURNED + ACTIVE + '      P: "RotationOrder", "enum", "", "",4\n', MOVED],
    "mirrored": [TURNED + vector("Lcl Scaling", -1, 1, 1), TURNED + vector("Lcl Scaling", 1, -2, 1)],
    "hidden": [TURNED, MOVED + HIDDEN],
}


def text_fbx(models, up=1, front=2, front_sign=1, unit=1, wrap=0):
    objects = connections = ""
    for i, properties in enumerate(models):
        model, geometry = 20 + i, 30 + i
        objects += GEOMETRY.format(id=geometry, name=f"hair{i}") + MODEL.format(id=model, name=f"hair{i}", kind="Mesh", properties=properties)
        connections += f'  C: "OO",{model},{model - 1 if i else 0}\n  C: "OO",{geometry},{model}\n  C: "OO",50,{model}\n'
    return FILE.format(objects=objects, connections=connections, up=up, front=front, front_sign=front_sign, unit=unit, wrap=wrap)


folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
for make in (placed_scene, skinned_scene, keyed_scene):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hair_material(folder)
    make()
    export(folder, make.__name__.removesuffix("_scene"))
for name, models in TEXTS.items():
    (folder / f"text_{name}.fbx").write_text(text_fbx(models))
(folder / "text_inches.fbx").write_text(text_fbx([TURNED], unit=2.54))
(folder / "text_z_up.fbx").write_text(text_fbx([TURNED], up=2, front=1, front_sign=-1))
(folder / "text_clamped.fbx").write_text(text_fbx([TURNED], wrap=1))
