"""The coordinates of a mesh file and all its other bytes, apart. Knows just enough of each format, and shares no
code with what it tests."""
import json
import re
import struct

FLOATS = {"float": "f", "float32": "f", "double": "d", "float64": "d"}
SIZES = {"char": 1, "int8": 1, "uchar": 1, "uint8": 1, "short": 2, "int16": 2, "ushort": 2, "uint16": 2, "int": 4,
         "int32": 4, "uint": 4, "uint32": 4, "float": 4, "float32": 4, "double": 8, "float64": 8}


def split(name, data):
    """(positions as tuples in file order, everything else) of the bytes of a file."""
    return {"obj": split_obj, "ply": split_ply, "stl": split_stl, "glb": split_glb}[name.rsplit(".", 1)[1]](data)


def split_obj(data):
    positions, rest = [], []
    for line in data.splitlines(keepends=True):
        words = line.split()
        if words and words[0] == b"v":
            positions.append(tuple(float(word) for word in words[1:4]))
            rest.append((b"v", tuple(words[4:]), line[len(line.rstrip(b"\r\n")):]))
        else:
            rest.append(line)
    return positions, rest


def split_ply(data):
    end = re.search(rb"end_header\r?\n", data).end()
    header = data[:end].decode("ascii")
    elements = re.findall(r"element (\w+) (\d+)((?:\s+property [^\n]*)*)", header)
    name, count, properties = elements[0]
    assert name == "vertex", "this reader wants the vertices first"
    properties = [line.split()[1:] for line in properties.strip().splitlines()]
    names = [words[-1] for words in properties]
    columns = [names.index(axis) for axis in "xyz"]
    if "format ascii" in header:
        return split_ply_text(header, data[end:], int(count), columns)
    order = "<" if "little" in header else ">"
    offsets = [sum(SIZES[words[0]] for words in properties[:i]) for i in range(len(properties) + 1)]
    positions, rest = [], [header]
    for i in range(int(count)):
        record = bytearray(data[end + i * offsets[-1]:end + (i + 1) * offsets[-1]])
        point = []
        for column in columns:
            code = FLOATS[properties[column][0]]
            point.append(struct.unpack_from(order + code, record, offsets[column])[0])
            struct.pack_into(order + code, record, offsets[column], 0)
        positions.append(tuple(point))
        rest.append(bytes(record))
    return positions, rest + [data[end + int(count) * offsets[-1]:]]


def split_ply_text(header, body, count, columns):
    lines = body.splitlines(keepends=True)
    positions, rest = [], [header]
    for line in lines[:count]:
        words = line.split()
        positions.append(tuple(float(words[column]) for column in columns))
        rest.append([word for i, word in enumerate(words) if i not in columns])
    return positions, rest + lines[count:]


def split_stl(data):
    assert len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0], "this reader wants binary STL"
    positions, rest = [], [data[:84]]
    for at in range(84, len(data), 50):
        values = struct.unpack_from("<12f", data, at)
        positions += [values[3:6], values[6:9], values[9:12]]
        rest.append((values[:3], data[at + 48:at + 50]))
    return positions, rest


def split_glb(data):
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    binary = bytearray(data[20 + length + 8:])
    positions = []
    used = sorted({primitive["attributes"]["POSITION"] for mesh in document["meshes"] for primitive in mesh["primitives"]})
    for index in used:
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        for i in range(accessor["count"]):
            at = start + i * view.get("byteStride", 12)
            positions.append(struct.unpack_from("<3f", binary, at))
            struct.pack_into("<3f", binary, at, 0, 0, 0)
        accessor.pop("min", None)
        accessor.pop("max", None)
    return positions, [json.dumps(document, sort_keys=True), bytes(binary)]
