"""Plain OFF files as lists of numbers, and as binary STL for programs that do not read OFF."""

import pathlib
import struct


def read_off(path):
    """Vertices and faces; the benchmark's files have neither comments nor colours."""
    words = pathlib.Path(path).read_text(encoding="ascii").split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = [float(word) for word in words[4 : 4 + 3 * vertices]]
    at = 4 + 3 * vertices
    corners = []
    for _ in range(faces):
        count = int(words[at])
        corners.append([int(word) for word in words[at + 1 : at + 1 + count]])
        at += 1 + count
    return list(zip(numbers[0::3], numbers[1::3], numbers[2::3])), corners


def write_stl(path, vertices, triangles):
    """Without normals, which no reader needs."""
    with open(path, "wb") as file:
        file.write(b"\0" * 80 + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            corners = [coordinate for corner in triangle for coordinate in vertices[corner]]
            file.write(struct.pack("<12fH", 0, 0, 0, *corners, 0))
