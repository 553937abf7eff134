"""Writes the example tunnel of 60 m as a GLB or IFC file: walls, brackets, a tray, rollers, and a pipe in the way.

Usage: tunnel_model.py OUT.glb|OUT.ifc [--check]

With --check nothing is written: the file must be what would be written.

The cable's axis is the route of cases/environment/tunnel.yaml: from the origin 25 m along x, a bend of 20 degrees to the
left with a radius of 30 m, and a straight to 60 m, all level. Lengths are in m with z upward; GLB has y upward. The file
is the same at every run. `model` is for writers of other formats.
"""
import json
import math
import struct
import sys

LENGTH, STRAIGHT, RADIUS, ANGLE = 60.0, 25.0, 30.0, math.radians(20)


def heading(s):
    return min(max((s - STRAIGHT) / RADIUS, 0.0), ANGLE)


def line(s, left=0.0, up=0.0):
    """The point beside the route at s: (x, y, z)."""
    turn, rest = heading(s), max(s - STRAIGHT - RADIUS * ANGLE, 0.0)
    x = min(s, STRAIGHT) + RADIUS * math.sin(turn) + rest * math.cos(turn)
    y = RADIUS * (1 - math.cos(turn)) + rest * math.sin(turn)
    return x - left * math.sin(turn), y + left * math.cos(turn), up


def swept(loops, caps, start, end):
    """A solid along the route: closed lines of its section [(left, up)], and the triangles that close its ends. Each degree
    of the bend has its station."""
    inside = [STRAIGHT + RADIUS * math.radians(k) for k in range(21)]
    places = [start] + [s for s in inside if start < s < end] + [end]
    n = sum(len(loop) for loop in loops)
    points = [line(s, a, b) for s in places for loop in loops for a, b in loop]
    faces, first = [], 0
    for loop in loops:
        for k in range(len(loop)):
            p, q = first + k, first + (k + 1) % len(loop)
            for here in range(0, n * (len(places) - 1), n):
                faces += [(here + p, here + q, here + n + q), (here + p, here + n + q, here + n + p)]
        first += len(loop)
    last = n * (len(places) - 1)
    return points, faces + [(a, c, b) for a, b, c in caps] + [(last + a, last + b, last + c) for a, b, c in caps]


def walls():
    """The lining, 0.25 m thick: a rectangle under an arch; the cable is on its left half."""
    def ring(more):
        arch = [((1.2 + more) * math.cos(math.radians(a)) - 0.4, (1.2 + more) * math.sin(math.radians(a)) + 1.3)
                for a in range(0, 181, 15)]
        return [(-1.6 - more, -0.9 - more), (0.8 + more, -0.9 - more)] + arch
    outer, inner = ring(0.25), ring(0)[::-1]
    n = len(outer)
    caps = []
    for k in range(n):
        a, b = k, (k + 1) % n
        c, d = 2 * n - 1 - b, 2 * n - 1 - a  # the inner corners beside b and a
        caps += [(a, b, c), (a, c, d)]
    return swept([outer, inner], caps, 0, LENGTH)


def tray():
    """A channel of sheet, 3 mm thick and 0.5 m wide, 0.25 m below the cable's axis, up to 52 m."""
    w, h, t, z = 0.25, 0.1, 0.003, -0.25
    section = [(-w, z), (w, z), (w, z + h), (w - t, z + h), (w - t, z + t), (t - w, z + t), (t - w, z + h), (-w, z + h)]
    return swept([section], [(0, 1, 4), (0, 4, 5), (1, 2, 3), (1, 3, 4), (0, 5, 6), (0, 6, 7)], 0, 52)


def box(low, high):
    points = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    return points, [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6),
                    (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def cylinder(radius, half, n=24):
    """About the y-axis, from -half to half."""
    ring = [(radius * math.sin(2 * math.pi * k / n), radius * math.cos(2 * math.pi * k / n)) for k in range(n)]
    points = [(x, y, z) for y in (-half, half) for x, z in ring]
    faces = []
    for k in range(n):
        j = (k + 1) % n
        faces += [(k, n + k, n + j), (k, n + j, j)]
    for k in range(1, n - 1):
        faces += [(0, k, k + 1), (n, n + k + 1, n + k)]
    return points, faces


def measures(shape):
    """Area, and the volume inside: below 0 if the faces are clockwise from outside."""
    points, faces = shape
    area = volume = 0.0
    for p, q, r in ([points[i] for i in face] for face in faces):
        u, v = [q[i] - p[i] for i in range(3)], [r[i] - p[i] for i in range(3)]
        n = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        area += math.sqrt(sum(x * x for x in n)) / 2
        volume += sum(a * b for a, b in zip(p, n)) / 6
    return area, volume


def model():
    """Meshes {name: (points, faces)} in their own axes, closed and anticlockwise from outside, and nodes
    [(name, mesh, place along the route or None, height)], each turned with the route."""
    shapes = {
        "walls": walls(),
        "tray": tray(),
        "tray end": box((0, -0.25, -0.25), (0.003, 0.25, -0.06)),  # its top is 16.35 mm below the cable
        "bracket": box((-0.02, -0.3, -0.29), (0.02, 0.8, -0.255)),
        "roller": cylinder(0.06, 0.2),
        "pipe": cylinder(0.05, 0.7, 48),
    }
    for name, (points, faces) in shapes.items():
        if measures(shapes[name])[1] < 0:
            shapes[name] = points, [(a, c, b) for a, b, c in faces]
    nodes = [("walls", "walls", None, 0), ("tray", "tray", None, 0), ("tray end", "tray end", 52.0, 0)]
    nodes += [(f"bracket {k + 1}", "bracket", 0.75 + 1.5 * k, 0) for k in range(35)]
    nodes += [(f"roller {k + 1}", "roller", 1.0 + 2.0 * k, -0.10365) for k in range(30)]
    nodes += [("pipe", "pipe", 40.0, 0.06)]  # its underside is 33.65 mm below the cable's top
    return shapes, nodes


def glb(shapes, nodes):
    """The file: positions as floats in m with y upward, indices of 16 bits."""
    buffer, views, accessors, meshes = b"", [], [], []
    for name, (points, faces) in shapes.items():
        data = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in points)
        index = b"".join(struct.pack("<3H", *f) for f in faces)
        index += b"\0" * (-len(index) % 4)
        for chunk in (data, index):
            views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(chunk)})
            buffer += chunk
        single = list(struct.iter_unpack("<3f", data))
        accessors.append({"bufferView": len(views) - 2, "componentType": 5126, "count": len(points), "type": "VEC3",
                          "min": [min(p[i] for p in single) for i in range(3)],
                          "max": [max(p[i] for p in single) for i in range(3)]})
        accessors.append({"bufferView": len(views) - 1, "componentType": 5123, "count": 3 * len(faces),
                          "type": "SCALAR"})
        meshes.append({"name": name, "primitives": [{"attributes": {"POSITION": len(accessors) - 2},
                                                     "indices": len(accessors) - 1}]})
    out = []
    for name, mesh, s, up in nodes:
        out.append({"name": name, "mesh": list(shapes).index(mesh)})
        if s is not None:
            (x, y, z), half = line(s, 0, up), heading(s) / 2
            out[-1]["translation"] = [round(x, 9), round(z, 9), round(-y, 9)]
            out[-1]["rotation"] = [0, round(math.sin(half), 12), 0, round(math.cos(half), 12)]
    text = json.dumps({"asset": {"version": "2.0", "generator": "hawser, scripts/tunnel_model.py"}, "scene": 0,
                       "scenes": [{"name": "tunnel", "nodes": list(range(len(out)))}], "nodes": out, "meshes": meshes,
                       "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(buffer)}]},
                      separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<2I", len(text), 0x4E4F534A) + text + struct.pack("<2I", len(buffer), 0x004E4942) + buffer
    return struct.pack("<3I", 0x46546C67, 2, 12 + len(body)) + body


CLASSES = {"walls": "IFCWALL", "tray": "IFCCABLECARRIERSEGMENT", "tray end": "IFCDISCRETEACCESSORY",
           "bracket": "IFCDISCRETEACCESSORY", "roller": "IFCBUILDINGELEMENTPROXY", "pipe": "IFCPIPESEGMENT"}


def ifc(shapes, nodes):
    """The same as IFC4, in mm: a triangulated face set a shape, and a product a node, whose class is that of CLASSES."""
    lines = []

    def add(text):
        lines.append(f"#{len(lines) + 1}={text};")
        return f"#{len(lines)}"

    def real(*values):
        return ",".join(repr(float(round(v, 9) + 0.0)) for v in values)

    def guid():
        return f"'{len(lines):022d}'"

    def placement(x, y, z, turn):
        point, up = add(f"IFCCARTESIANPOINT(({real(1000 * x, 1000 * y, 1000 * z)}))"), add("IFCDIRECTION((0.,0.,1.))")
        ahead = add(f"IFCDIRECTION(({real(math.cos(turn), math.sin(turn))},0.))")
        return add(f"IFCAXIS2PLACEMENT3D({point},{up},{ahead})")

    origin = placement(0, 0, 0, 0)
    context = add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,{origin},$)")
    unit = add("IFCUNITASSIGNMENT((%s))" % add("IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)"))
    project = add(f"IFCPROJECT({guid()},$,'tunnel',$,$,$,$,({context}),{unit})")
    maps, products = {}, []
    for name, (points, faces) in shapes.items():
        corners = add("IFCCARTESIANPOINTLIST3D((%s))" % ",".join(f"({real(*(1000 * v for v in p))})" for p in points))
        index = ",".join("(%d,%d,%d)" % tuple(i + 1 for i in face) for face in faces)
        solid = add(f"IFCTRIANGULATEDFACESET({corners},$,.T.,({index}),$)")
        body = add(f"IFCSHAPEREPRESENTATION({context},'Body','Tessellation',({solid}))")
        maps[name] = add(f"IFCREPRESENTATIONMAP({origin},{body})")
    zero = add("IFCCARTESIANPOINT((0.,0.,0.))")
    operator = add(f"IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,{zero},$,$)")
    for name, mesh, s, up in nodes:
        item = add(f"IFCMAPPEDITEM({maps[mesh]},{operator})")
        body = add(f"IFCSHAPEREPRESENTATION({context},'Body','MappedRepresentation',({item}))")
        shape = add(f"IFCPRODUCTDEFINITIONSHAPE($,$,({body}))")
        x, y, z = (0, 0, 0) if s is None else line(s, 0, up)
        place = add(f"IFCLOCALPLACEMENT($,{placement(x, y, z, 0 if s is None else heading(s))})")
        products.append(add(f"{CLASSES[mesh]}({guid()},$,'{name}',$,$,{place},{shape},$,$)"))
    site = add(f"IFCSITE({guid()},$,'site',$,$,$,$,$,$,$,$,$,$,$)")
    add(f"IFCRELAGGREGATES({guid()},$,$,$,{project},({site}))")
    add(f"IFCRELCONTAINEDINSPATIALSTRUCTURE({guid()},$,$,$,({','.join(products)}),{site})")
    head = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('tunnel.ifc','',(''),(''),'','','');\n"
    return (head + "FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n").encode()


def main():
    shapes, nodes = model()
    data = (ifc if sys.argv[1].endswith(".ifc") else glb)(shapes, nodes)
    if "--check" in sys.argv:
        with open(sys.argv[1], "rb") as file:
            sys.exit(file.read() != data and f"{sys.argv[1]} differs from what its script writes")
    with open(sys.argv[1], "wb") as file:
        file.write(data)
    for name, shape in shapes.items():
        n = sum(mesh == name for _, mesh, _, _ in nodes)
        print("%s: %d of %d triangles, %.9g m2, %.9g m3 each" % (name, n, len(shape[1]), *measures(shape)))


if __name__ == "__main__":
    main()
