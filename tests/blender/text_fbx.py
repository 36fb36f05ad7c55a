"""Runs inside Blender: an FBX in text becomes a binary one, since Blender reads no other. Its own encoder writes it."""
import re

from io_scene_fbx import encode_bin

TOKEN = re.compile(r'\s+|;[^\n]*|"([^"]*)"|([{},])|\*\d+|([A-Za-z_]\w*):|([^\s,{}"]+)')
WHOLE = re.compile(r"[-+]?\d+")
WHOLE_TYPES = {"int", "Integer", "enum", "bool", "Visibility Inheritance", "Short"}
DOUBLE_ARRAYS = {"Vertices", "Normals", "UV", "Colors", "Weights", "Transform", "TransformLink", "TransformAssociateModel", "Matrix", "FullWeights"}


def tokens(text):
    at = 0
    while at < len(text):
        found = TOKEN.match(text, at)
        at = found.end()
        quoted, mark, name, word = found.groups()
        if quoted is not None:
            yield "text", quoted
        elif mark or name:
            yield ("mark", mark) if mark else ("name", name)
        elif word:
            yield "word", word


def records(text):
    """Lists of [name, values, records within], as deep as the file has them."""
    top = []
    open_lists, values = [top], None
    for kind, token in tokens(text):
        if kind == "name":
            values = []
            open_lists[-1].append([token, values, []])
        elif kind == "mark" and token == "{":
            open_lists.append(open_lists[-1][-1][2])
        elif kind == "mark" and token == "}":
            open_lists.pop()
        elif kind != "mark":
            values.append((kind, token))
    return top


def add_array(element, name, numbers):
    if name in DOUBLE_ARRAYS or not all(WHOLE.fullmatch(n) for n in numbers):
        element.add_float64_array([float(n) for n in numbers])
    else:
        element.add_int32_array([int(n) for n in numbers])


def add_value(element, kind, token, is_id, is_double):
    if kind == "text":
        element.add_string(token.encode())
    elif token in ("T", "Y", "W", "F", "N"):
        element.add_bool(token in ("T", "Y"))
    elif is_id:
        element.add_int64(int(token))
    elif is_double or not WHOLE.fullmatch(token):
        element.add_float64(float(token))
    elif abs(int(token)) < 1 << 31:
        element.add_int32(int(token))
    else:
        element.add_int64(int(token))


def add_record(above, record, place):
    name, values, inner = record
    element = encode_bin.FBXElem(name.encode())
    above.elems.append(element)
    if len(inner) == 1 and inner[0][0] == "a":
        add_array(element, name, [token for _, token in inner[0][1]])
        return
    is_object = place == ("Objects",)
    is_double = name in ("DeformPercent", "Link_DeformAcuracy") or (name == "P" and values[1][1] not in WHOLE_TYPES)
    for i, (kind, token) in enumerate(values):
        if is_object and i == 1:
            of, _, own = token.rpartition("::")
            token, kind = f"{own}\0\1{of or name}", "text"
        add_value(element, kind, token, (is_object and i == 0) or name == "C", is_double)
    for other in inner:
        add_record(element, other, place + (name,))


def write_as_binary(source, out):
    top = encode_bin.FBXElem(b"")
    text = source.read_bytes().decode("utf-8", "replace")
    version = re.search(r"FBXVersion: (\d+)", text)
    for record in records(text):
        add_record(top, record, ())
    # The encoder writes sizes of 32 bits, which files have before 7500.
    encode_bin.write(str(out), top, min(7400, int(version.group(1))) if version else 7400)
