# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the example meshes beside this script; needs numpy only.

    python3 Examples/make_examples.py [FOLDER]

The same files come out on every machine: random numbers are those of Python's own generator, whose
sequence is guaranteed, and coordinates are rounded to float32.
"""

import itertools
import random
import struct
import sys
from pathlib import Path

import numpy as np


def write_visf(path, points, faces, cells=None, binary=False):
    """Writes a mesh as Visf 0.3: faces as lists of point ids, cells as lists of face ids."""
    kind = 1 if cells is None else 2
    points = np.asarray(points, dtype="<f4")
    groups = [faces] if cells is None else [faces, cells]
    if binary:
        data = bytearray(b"1" + struct.pack("<i", kind))
        data += struct.pack("<i", len(points)) + points.tobytes()
        for number, group in enumerate(groups):
            data += struct.pack("<i", len(group))
            for ids in group:
                data += struct.pack(f"<{len(ids) + 1}i", len(ids), *ids)
            if number == 0:
                data += struct.pack("<i", 0)  # no lists of neighbors
        path.write_bytes(data)
        return
    lines = [f"2 {kind}", str(len(points))]
    lines += [" ".join(f"{x:.9g}" for x in point) for point in points]
    for number, group in enumerate(groups):
        lines.append(str(len(group)))
        lines += [" ".join(map(str, (len(ids), *ids))) for ids in group]
        if number == 0:
            lines.append("0")
    path.write_text("\n".join(lines) + "\n")


class FaceList:
    """Unique faces of a mesh whose cells come as loops of point ids."""

    def __init__(self):
        self.faces = []
        self._ids = {}

    def add(self, loop):
        """Id of the face with these points."""
        key = tuple(sorted(loop))
        if key not in self._ids:
            self._ids[key] = len(self.faces)
            self.faces.append(list(loop))
        return self._ids[key]


# --------------------------------------------------------------------------------------------------
# Voronoi cells in a ball


def clip(loops, corners, plane, normal, offset):
    """Cuts a convex cell with normal . x <= offset.

    `loops` maps the plane of each face to its corners in order, `corners` maps a corner (the set of
    the three planes that meet there) to its place. Returns whether something was cut off.
    """
    height = {corner: normal @ place - offset for corner, place in corners.items()}
    if all(h <= 0.0 for h in height.values()):
        return False
    edges = {}
    for face, loop in list(loops.items()):
        kept, cut = [], []
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if height[a] <= 0.0:
                kept.append(a)
            if (height[a] <= 0.0) != (height[b] <= 0.0):
                corner = (a & b) | {plane}
                if corner not in corners:
                    t = height[a] / (height[a] - height[b])
                    corners[corner] = corners[a] + t * (corners[b] - corners[a])
                kept.append(corner)
                cut.append((corner, height[a] <= 0.0))
        if kept:
            loops[face] = kept
        else:
            del loops[face]
        if cut:
            (first, leaves), (second, _) = cut
            # The new face runs against the direction in which its neighbors run.
            leaving, entering = (first, second) if leaves else (second, first)
            edges[entering] = leaving
    for corner, h in height.items():
        if h > 0.0:
            del corners[corner]
    start = next(iter(edges))
    loop = [start]
    while edges[loop[-1]] != start:
        loop.append(edges[loop[-1]])
    loops[plane] = loop
    return True


def bounding_box(size):
    """The cell before anything is cut off; its planes are -1 to -6."""
    loops, corners = {}, {}
    planes = [(-1, -2), (-3, -4), (-5, -6)]
    for signs in itertools.product((0, 1), repeat=3):
        corner = frozenset(planes[axis][sign] for axis, sign in enumerate(signs))
        corners[corner] = np.array([size if sign else -size for sign in signs], dtype=float)
    for axis in range(3):
        for sign in (0, 1):
            other = planes[(axis + 1) % 3], planes[(axis + 2) % 3]
            loop = [
                frozenset((planes[axis][sign], other[0][i], other[1][j]))
                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
            ]
            loops[planes[axis][sign]] = loop if sign else loop[::-1]
    return loops, corners


def ball_seeds(count, spacing, generator):
    """Random points of the unit ball that keep their distance from each other."""
    seeds = np.empty((0, 3))
    while len(seeds) < count:
        point = np.array([2.0 * generator.random() - 1.0 for _ in range(3)])
        if point @ point > (1.0 - 0.5 * spacing) ** 2:
            continue
        if len(seeds) and np.min(np.sum((seeds - point) ** 2, axis=1)) < spacing**2:
            continue
        seeds = np.vstack([seeds, point])
    return seeds


def voronoi_ball(count=800, spacing=0.137, seed=3):
    """Voronoi cells of random points in the unit ball.

    Every point also has a mirror image behind the sphere, so a cell at the boundary ends in the
    plane that touches the sphere above its point. A corner is known by the four points whose cells
    meet there, hence neighbors agree on it without comparing coordinates.
    """
    seeds = ball_seeds(count, spacing, random.Random(seed))
    radius = np.linalg.norm(seeds, axis=1, keepdims=True)
    generators = np.vstack([seeds, seeds * (2.0 - radius) / radius])

    points, point_ids = [], {}
    faces, cells = FaceList(), []
    for i, origin in enumerate(seeds):
        loops, corners = bounding_box(2.0)
        offsets = generators - origin
        distance = np.linalg.norm(offsets, axis=1)
        for j in np.argsort(distance, kind="stable")[1:]:
            if 0.5 * distance[j] > max(np.linalg.norm(place) for place in corners.values()):
                break
            clip(loops, corners, int(j), offsets[j] / distance[j], 0.5 * distance[j])
        cell = []
        for loop in loops.values():
            ids = []
            for corner in loop:
                key = frozenset(corner | {i})
                if key not in point_ids:
                    point_ids[key] = len(points)
                    points.append(origin + corners[corner])
                ids.append(point_ids[key])
            cell.append(faces.add(ids))
        cells.append(cell)
    return points, faces.faces, cells


# --------------------------------------------------------------------------------------------------
# A flange of hexahedra, wedges, pyramids and tetrahedra


class Flange:
    """A pipe flange on a grid of (radius, angle, height), whose boxes become different cells.

    Disc: hexahedra, wedges at the rim, bolt holes. Neck: a layer of pyramids and tetrahedra above
    the hexahedra of the disc, then tetrahedra only.
    """

    Radii = [0.5, 0.6, 0.7, 0.8, 0.95, 1.1, 1.25, 1.4]
    # The thin boxes below the neck are one of the things to find.
    Heights = [0.0, 0.12, 0.24, 0.25, 0.38, 0.51, 0.64]
    Angles = 32
    DiscHeight, NeckWidth, RimWidth = 3, 3, 1

    def __init__(self):
        self.points, self.faces, self.cells = [], FaceList(), []
        self._grid = {}
        self._centers = {}
        boxes = itertools.product(
            range(len(self.Radii) - 1), range(self.Angles), range(len(self.Heights) - 1)
        )
        self._boxes = [box for box in boxes if self.kind(*box)]
        for box in self._boxes:
            getattr(self, "add_" + self.kind(*box))(*box)
        self.spoil()

    def kind(self, i, j, k):
        """What the box (i, j, k) becomes, or None outside the part."""
        j %= self.Angles
        if not (0 <= i < len(self.Radii) - 1 and 0 <= k < len(self.Heights) - 1):
            return None
        if k < self.DiscHeight:
            if i == 4 and j % 4 < 2:
                return None  # bolt hole
            return "wedges" if i >= len(self.Radii) - 1 - self.RimWidth else "hexahedron"
        return "tetrahedra" if i < self.NeckWidth else None

    def point(self, i, j, k):
        key = (i, j % self.Angles, k)
        if key not in self._grid:
            angle = 2.0 * np.pi * key[1] / self.Angles
            radius = self.Radii[i]
            if k > self.DiscHeight:  # the neck gets narrower
                radius = 0.5 + (radius - 0.5) * (1.0 - 0.15 * (k - self.DiscHeight))
            self._grid[key] = len(self.points)
            self.points.append([radius * np.cos(angle), radius * np.sin(angle), self.Heights[k]])
        return self._grid[key]

    def corners(self, i, j, k):
        """The eight corners of a box in the order of a VTK hexahedron."""
        steps = [(0, 0), (1, 0), (1, 1), (0, 1)]
        return [self.point(i + a, j + b, k + c) for c in (0, 1) for a, b in steps]

    def add(self, *loops):
        self.cells.append([self.faces.add(loop) for loop in loops])

    @staticmethod
    def halves(quad):
        """The two triangles of a quadrangle, cut through its smallest id: neighbors agree."""
        first = quad.index(min(quad))
        a, b, c, d = quad[first:] + quad[:first]
        return [[a, b, c], [a, c, d]]

    @staticmethod
    def sides(c):
        """The quadrangles of a hexahedron: bottom, top, then the four around, seen from outside."""
        return [
            [c[0], c[3], c[2], c[1]],
            [c[4], c[5], c[6], c[7]],
            [c[0], c[1], c[5], c[4]],
            [c[1], c[2], c[6], c[5]],
            [c[2], c[3], c[7], c[6]],
            [c[3], c[0], c[4], c[7]],
        ]

    def add_hexahedron(self, i, j, k):
        self.add(*self.sides(self.corners(i, j, k)))

    def add_wedges(self, i, j, k):
        c = self.corners(i, j, k)
        for a, b, d in ((0, 1, 2), (0, 2, 3)):
            bottom, top = [c[a], c[b], c[d]], [c[a + 4], c[b + 4], c[d + 4]]
            around = [[bottom[e], bottom[(e + 1) % 3], top[(e + 1) % 3], top[e]] for e in range(3)]
            self.add(bottom[::-1], top, *around)

    def add_tetrahedra(self, i, j, k):
        """Pyramids on sides towards hexahedra, two tetrahedra on every other, around the center."""
        c = self.corners(i, j, k)
        center = len(self.points)
        self.points.append(np.mean([self.points[p] for p in c], axis=0))
        self._centers[i, j, k] = center
        for number, side in enumerate(self.sides(c)):
            below = number == 0 and self.kind(i, j, k - 1) == "hexahedron"
            for base in [side] if below else self.halves(side):
                apex = [[b, a, center] for a, b in zip(base, base[1:] + base[:1])]
                self.add(base, *apex)

    def spoil(self):
        """Moves a few points so that the elements around them turn bad."""
        move = lambda point, step: np.add(self.points[point], step)
        for j, lift in ((3, 0.055), (14, 0.0635), (25, -0.062)):  # slivers at a box's top or bottom
            center = self._centers[1, j, 5]
            self.points[center] = move(center, [0.0, 0.0, lift])
        center = self._centers[1, 20, 4]  # a box folded over: its center lies below its bottom
        self.points[center] = move(center, [0.0, 0.0, -0.085])
        # Warped hexahedra and sheared wedges on the disc.
        dent = self.point(5, 9, self.DiscHeight)
        self.points[dent] = move(dent, [0.0, 0.0, -0.2])
        rim = self.point(7, 22, self.DiscHeight)
        self.points[rim] = move(rim, [-0.1, 0.12, 0.0])


# --------------------------------------------------------------------------------------------------
# Polygons on a wavy ring


def polygon_ring(around=72, across=22, flips=420, seed=11):
    """The dual of a triangulated ring: mostly hexagons, with five- and seven-sided polygons."""
    generator = random.Random(seed)
    vertex = lambda u, v: (u % around) * across + v % across
    # Triangles of a grid whose rows are shifted by half a step; `around` is even, so it closes.
    triangles = []
    for u, v in itertools.product(range(around), range(across)):
        shift = u % 2
        a, b = vertex(u, v), vertex(u, v + 1)
        c, d = vertex(u + 1, v + shift), vertex(u + 1, v + 1 + shift)
        triangles += [[a, c, b], [b, c, d]]
    neighbors = {}
    for t, triangle in enumerate(triangles):
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            neighbors[a, b] = t
    degree = [6] * (around * across)
    edges = sorted(edge for edge in neighbors if edge[0] < edge[1])
    generator.shuffle(edges)
    done = 0
    for a, b in edges:
        if done == flips:
            break
        if (a, b) not in neighbors:
            continue
        t, s = neighbors[a, b], neighbors[b, a]
        c = next(p for p in triangles[t] if p not in (a, b))
        d = next(p for p in triangles[s] if p not in (a, b))
        if min(degree[a], degree[b]) <= 5 or max(degree[c], degree[d]) >= 7 or (c, d) in neighbors:
            continue
        triangles[t], triangles[s] = [c, a, d], [d, b, c]
        del neighbors[a, b], neighbors[b, a]
        for number in (t, s):
            triangle = triangles[number]
            for p, q in zip(triangle, triangle[1:] + triangle[:1]):
                neighbors[p, q] = number
        for p, step in ((a, -1), (b, -1), (c, 1), (d, 1)):
            degree[p] += step
        done += 1

    jitter = [(0.3 * (generator.random() - 0.5), 0.3 * (generator.random() - 0.5)) for _ in degree]
    angles = np.array(
        [
            (
                (u + jitter[vertex(u, v)][0]) / around,
                (v + 0.5 * (u % 2) + jitter[vertex(u, v)][1]) / across,
            )
            for u, v in itertools.product(range(around), range(across))
        ]
    )
    corners = np.array(triangles)
    # Mean of the corners' angles, which are cyclic: relative to the first corner.
    relative = angles[corners] - angles[corners[:, :1]]
    middle = angles[corners[:, 0]] + np.mean(relative - np.round(relative), axis=1)
    u, v = 2.0 * np.pi * middle.T
    tube = 0.32 + 0.07 * np.cos(5.0 * u)
    points = np.column_stack(
        [
            (1.0 + tube * np.cos(v)) * np.cos(u),
            (1.0 + tube * np.cos(v)) * np.sin(u),
            tube * np.sin(v),
        ]
    )
    after = {}  # around each vertex: from a triangle to the next
    for t, triangle in enumerate(triangles):
        for k in range(3):
            after.setdefault(triangle[k], {})[t] = neighbors[triangle[k], triangle[(k + 2) % 3]]
    faces = []
    for center in range(len(degree)):
        ring = after[center]
        start = min(ring)
        loop = [start]
        while ring[loop[-1]] != start:
            loop.append(ring[loop[-1]])
        faces.append(loop)
    return points, faces


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    write_visf(folder / "voronoi-ball.visf", *voronoi_ball(), binary=True)
    flange = Flange()
    write_visf(folder / "flange.visf", flange.points, flange.faces.faces, flange.cells)
    write_visf(folder / "polygon-ring.visf", *polygon_ring())


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
