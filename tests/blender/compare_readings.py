"""Holds coif's triangles to Blender's polygons, corner by corner, in whatever order both have them."""
import itertools
import math

NEAR = 1e-5  # of the model's size: corners that are meant to be one


class Reading:
    """What is left of a comparison: the farthest of each kind, and faults."""

    def __init__(self):
        self.triangles = self.twice = self.degenerate = 0
        self.far = {}
        self.where = {}
        self.faults = []

    def add(self, what, distance, where):
        if distance != distance:
            distance = math.inf
        if distance > self.far.get(what, -1):
            self.far[what], self.where[what] = distance, where


def corner_places(positions, indices):
    return [positions[3 * v:3 * v + 3] for v in indices]


def extent(places):
    low = [min(p[k] for p in places) for k in range(3)]
    high = [max(p[k] for p in places) for k in range(3)]
    return max(h - l for l, h in zip(low, high)) or 1.0


class Polygon:
    __slots__ = ("mesh", "first", "left", "count", "material", "taken")

    def __init__(self, mesh, first, count, material):
        self.mesh, self.first, self.left, self.count = mesh, first, count - 2, count
        self.material = material
        self.taken = set()  # corners of triangles that it already is


class Places:
    """Finds corners of polygons near a place."""

    def __init__(self, near):
        self.near = near
        self.cells = {}

    def around(self, place):
        spans = [sorted({math.floor((x + d) / (4 * self.near)) for d in (-self.near, self.near)}) for x in place]
        return itertools.product(*spans)

    def add(self, place, what):
        for cell in self.around(place):
            self.cells.setdefault(cell, []).append((place, what))

    def at(self, place):
        cell = tuple(math.floor(x / (4 * self.near)) for x in place)
        for other, what in self.cells.get(cell, ()):
            if math.dist(place, other) <= self.near:
                yield what


def mapped(mapping, uv):
    if mapping is None:
        return uv
    (tx, ty), (sx, sy), turn = mapping["Location"][:2], mapping["Scale"][:2], mapping["Rotation"][2]
    u, v = uv
    if mapping["type"] == "TEXTURE":
        u, v, turn = u - tx, v - ty, -turn
        u, v = u * math.cos(turn) - v * math.sin(turn), u * math.sin(turn) + v * math.cos(turn)
        return [u / sx, v / sy]
    u, v = u * sx, v * sy
    return [u * math.cos(turn) - v * math.sin(turn) + tx, u * math.sin(turn) + v * math.cos(turn) + ty]


def linear(stored):
    return stored if stored > 1 else stored / 12.92 if stored <= 0.04045 else ((stored + 0.055) / 1.055) ** 2.4


def shares(weights):
    """Bones' names with their part of the whole, those of one name together."""
    total = sum(weight for _, weight in weights)
    out = {}
    for name, weight in weights:
        out[name] = out.get(name, 0.0) + weight / total
    return out


class Theirs:
    """Blender's reading, polygon by polygon."""

    def __init__(self, model, rules):
        self.meshes = model["meshes"]
        self.rules = rules
        self.polygons = []
        self.bones = {name for mesh in self.meshes for held in mesh["weights"] or () for name, _ in held}
        self.named = {}  # what coif calls a bone: what Blender does
        places = [mesh["positions"][i:i + 3] for mesh in self.meshes for i in range(0, len(mesh["positions"]), 3)]
        self.size = extent(places) if places else 1.0
        self.near = NEAR * self.size
        self.places = Places(self.near)
        for mesh in self.meshes:
            first = 0
            for count, material in zip(mesh["sizes"], mesh["material"]):
                polygon = Polygon(mesh, first, count, material)
                for k in range(count):
                    self.places.add(self.position(mesh, first + k), (polygon, k))
                self.polygons.append(polygon)
                first += count

    def bone(self, name):
        if name not in self.named:
            self.named[name] = self.rules.bone(name, self.bones)
        return self.named[name]

    @staticmethod
    def position(mesh, loop):
        v = mesh["vertices"][loop]
        return mesh["positions"][3 * v:3 * v + 3]

    def surface(self, polygon):
        surfaces = polygon.mesh["materials"]
        return surfaces[polygon.material] if polygon.material < len(surfaces) else {"image": False, "name": ""}

    def corner(self, polygon, k):
        mesh, loop = polygon.mesh, polygon.first + k
        surface = self.surface(polygon)
        uvs = mesh["uvs"].get(surface.get("uv_map") or mesh["uv_render"])
        colors = mesh["colors"]
        at = mesh["vertices"][loop] if colors and colors["domain"] == "POINT" else loop
        return {
            "position": self.position(mesh, loop),
            "normal": mesh["normals"] and mesh["normals"][3 * loop:3 * loop + 3],
            "uv": uvs and mapped(surface.get("mapping"), uvs[2 * loop:2 * loop + 2]),
            "color": colors and self.rules.color(colors["values"][4 * at:4 * at + 4]),
            "weights": mesh["weights"][mesh["vertices"][loop]] if mesh["weights"] else None,
        }


def corner_of(mesh, v, bone):
    part = lambda what, width: mesh[what][width * v:width * v + width] or None
    uv = part("uvs", 2)
    return {
        "position": part("positions", 3),
        "normal": part("normals", 3),
        "uv": uv and [uv[0], 1 - uv[1]],
        "color": part("colors", 4),
        "weights": [[bone(name), weight] for name, weight in mesh["influences"][v]] if mesh["influences"] else None,
    }


def position_distance(a, b):
    return max(abs(a[0] - b[0]), abs(a[1] - b[1]), abs(a[2] - b[2]))


def normal_distance(a, b):
    return position_distance(a, b) if a and b else 0.0  # else of one of the two it is the surface's


def uv_distance(a, b):
    if a is None and b is None:
        return 0.0
    if a is None or b is None:
        return math.inf
    return max(abs(a[0] - b[0]) / max(1.0, abs(b[0])), abs(a[1] - b[1]) / max(1.0, abs(b[1])))


def color_distance(a, b):
    if a is None and b is None:
        return 0.0
    return max(abs(x - y) for x, y in zip(a or WHITE, b or WHITE))


def weights_distance(a, b):
    if not b:  # what no bone holds follows the mesh's node
        return 0.0 if not a or len(a) == 1 else 1.0
    if not a:
        return 1.0
    a, b = shares(a), shares(b)
    return max(abs(a.get(name, 0.0) - b.get(name, 0.0)) for name in {*a, *b})


WHITE = (1.0, 1.0, 1.0, 1.0)
DISTANCES = {"position": position_distance, "normal": normal_distance, "uv": uv_distance, "color": color_distance, "weights": weights_distance}
KINDS = tuple(DISTANCES)


def candidates(theirs, corners):
    """Polygons with triangles left that have corners at all three places, with those corners in the triangle's order."""
    at = [{}, {}, {}]
    for found, corner in zip(at, corners):
        for polygon, k in theirs.places.at(corner["position"]):
            found.setdefault(polygon, []).append(k)
    for polygon in at[0].keys() & at[1].keys() & at[2].keys():
        for ks in itertools.product(*(found[polygon] for found in at)):
            turned = ks[::-1] if polygon.mesh["mirrored"] else ks
            low = turned.index(min(turned))
            a, b, c = turned[low:] + turned[:low]
            if a < b < c:  # counter-clockwise in the polygon
                yield polygon, ks


def differences(theirs, corners, polygon, ks):
    """The farthest of each of KINDS among three corners."""
    others = [theirs.corner(polygon, k) for k in ks]
    far = [max([measure(corner[what], other[what]) for corner, other in zip(corners, others)]) for what, measure in DISTANCES.items()]
    far[0] /= theirs.size
    return far


def rank_of(far):
    position, normal, uv, color, weights = far
    return max(position * 1e3, normal, uv, color, weights)


def is_degenerate(corners, near):
    return any(math.dist(a["position"], b["position"]) <= near for a, b in itertools.combinations(corners, 2))


def ranked_pairs(ours, theirs):
    """Of each triangle every polygon that may be it, the most alike first."""
    pairs, triangles = [], []
    for mesh in ours["meshes"]:
        for i in range(0, len(mesh["triangles"]), 3):
            corners = [corner_of(mesh, v, theirs.bone) for v in mesh["triangles"][i:i + 3]]
            for polygon, ks in candidates(theirs, corners):
                far = differences(theirs, corners, polygon, ks)
                pairs.append((rank_of(far), len(triangles), len(pairs), polygon, frozenset(ks), far))
            triangles.append((mesh, i // 3, corners))
    return sorted(pairs, key=lambda pair: pair[:3]), triangles


def compare(ours, theirs_model, rules):
    """`rules` knows what a format and Blender make of names and colours."""
    theirs, out = Theirs(theirs_model, rules), Reading()
    pairs, triangles = ranked_pairs(ours, theirs)
    out.triangles = len(triangles)
    matched = set()
    for _, number, _, polygon, ks, far in pairs:
        if number in matched or polygon.left == 0 or ks in polygon.taken:
            continue
        matched.add(number)
        polygon.taken.add(ks)
        polygon.left -= 1
        mesh, own_number, _ = triangles[number]
        for what, distance in zip(KINDS, far):
            kind = f"held {what}" if polygon.mesh["held"] and what in ("position", "normal") else what
            out.add(kind, distance, f"mesh '{mesh['name']}', triangle {own_number}")
        compare_wraps(mesh, theirs.surface(polygon), out)
    tell_unmatched(triangles, matched, theirs, out)
    tell_left(theirs, out)
    return out


def tell_unmatched(triangles, matched, theirs, out):
    """What Blender takes out of meshes: triangles without area, and those with the corners of another."""
    place = lambda corners: frozenset(tuple(round(x / theirs.near / 4) for x in c["position"]) for c in corners)
    places = {place(triangles[number][2]) for number in matched}
    for number, (mesh, own_number, corners) in enumerate(triangles):
        if number in matched:
            continue
        if is_degenerate(corners, theirs.near / 100):
            out.degenerate += 1
        elif place(corners) in places:
            out.twice += 1
        elif len(out.faults) < 5:
            at = [[round(x, 5) for x in corner["position"]] for corner in corners]
            out.faults.append(f"mesh '{mesh['name']}', triangle {own_number} is not in Blender: {at}")


def tell_left(theirs, out):
    left = [polygon for polygon in theirs.polygons if polygon.left > 0]
    if not left:
        return
    polygon = left[0]
    corners = [[round(x, 5) for x in theirs.position(polygon.mesh, polygon.first + k)] for k in range(polygon.count)]
    count = sum(polygon.left for polygon in left)
    out.faults.append(f"{count} triangles of Blender are not in coif, as in '{polygon.mesh['name']}': {corners}")


def compare_wraps(mesh, surface, out):
    material = mesh["material"]
    if not material or not material["texture"] or not surface["image"]:
        return
    wraps = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "clamp", "MIRROR": "mirror"}
    if material["wrap"] != [wraps[surface["extension"]]] * 2:
        fault = f"material '{material['name']}': wraps {material['wrap']}, of Blender {surface['extension']}"
        if fault not in out.faults:
            out.faults.append(fault)
