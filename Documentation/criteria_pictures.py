# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of what criteria measure, as SVG. A length of 1 is UNIT pixels; y is up."""

from __future__ import annotations

import math
from typing import Callable, Sequence

Point = tuple[float, float]

UNIT = 60.0
MARGIN = 0.45
INK, FILL, OTHER, MARK = "#334155", "#dbeafe", "#e2e8f0", "#c2410c"


class Drawing:
    """Shapes in the order in which they are drawn, and the box around them."""

    def __init__(self):
        self.items: list[str] = []
        self.low, self.high = [math.inf, math.inf], [-math.inf, -math.inf]

    def place(self, p: Point) -> str:
        """The point as SVG has it, which the picture grows to hold."""
        for axis in (0, 1):
            self.low[axis] = min(self.low[axis], p[axis])
            self.high[axis] = max(self.high[axis], p[axis])
        return f"{p[0] * UNIT:.1f},{-p[1] * UNIT:.1f}"

    def polygon(self, points: Sequence[Point], fill: str = FILL, stroke: str = INK) -> None:
        places = " ".join(map(self.place, points))
        self.items.append(
            f'<polygon points="{places}" fill="{fill}" stroke="{stroke}" stroke-linejoin="round"/>'
        )

    def line(
        self, a: Point, b: Point, color: str = INK, dashed: bool = False, arrow: bool = False
    ) -> None:
        style = ' stroke-dasharray="5 4"' * dashed + ' marker-end="url(#arrow)"' * arrow
        self.items.append(
            f'<path d="M{self.place(a)} L{self.place(b)}" fill="none" stroke="{color}"{style}/>'
        )

    def arc(
        self, center: Point, radius: float, start: float, end: float, color: str = MARK
    ) -> None:
        """Counter-clockwise from an angle to another, in degrees."""
        steps = max(2, int((end - start) / 5))
        angles = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
        points = [
            (center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in angles
        ]
        places = " L".join(map(self.place, points))
        self.items.append(f'<path d="M{places}" fill="none" stroke="{color}" stroke-width="2"/>')

    def circle(self, center: Point, radius: float, color: str = INK, dashed: bool = True) -> None:
        x, y = center
        self.place((x - radius, y - radius)), self.place((x + radius, y + radius))
        style = ' stroke-dasharray="5 4"' * dashed
        self.items.append(
            f'<circle cx="{x * UNIT:.1f}" cy="{-y * UNIT:.1f}" r="{radius * UNIT:.1f}" fill="none"'
            f' stroke="{color}"{style}/>'
        )

    def dot(
        self, p: Point, label: str = "", dx: float = 0.12, dy: float = 0.08, color: str = INK
    ) -> None:
        x, y = self.place(p).split(",")
        self.items.append(f'<circle cx="{x}" cy="{y}" r="3" fill="{color}"/>')
        if label:
            self.text((p[0] + dx, p[1] + dy), label, color)

    def text(self, p: Point, label: str, color: str = INK) -> None:
        x, y = self.place(p).split(",")
        self.place((p[0] + 0.12 * len(label), p[1] + 0.2))
        self.items.append(f'<text x="{x}" y="{y}" fill="{color}">{label}</text>')

    def svg(self) -> str:
        x, y = (self.low[0] - MARGIN) * UNIT, (-self.high[1] - MARGIN) * UNIT
        width, height = ((self.high[i] - self.low[i] + 2 * MARGIN) * UNIT for i in (0, 1))
        head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}"'
            f' viewBox="{x:.1f} {y:.1f} {width:.1f} {height:.1f}" font-family="sans-serif"'
            ' font-size="15" stroke-width="1.5">'
        )
        arrow = (
            '<marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7"'
            f' orient="auto"><path d="M0,0 L10,5 L0,10 Z" fill="{INK}"/></marker>'
        )
        paper = f'<rect x="{x:.1f}" y="{y:.1f}" width="100%" height="100%" fill="#ffffff" rx="6"/>'
        body = "\n".join(self.items).replace("<text ", '<text stroke="none" ')
        return f"{head}\n{arrow}\n{paper}\n{body}\n</svg>\n"


def _angle(a: Point, b: Point) -> float:
    return math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))


def _mean(points: Sequence[Point]) -> Point:
    return (sum(p[0] for p in points) / len(points), sum(p[1] for p in points) / len(points))


def _centroid(points: Sequence[Point]) -> Point:
    area = x = y = 0.0
    for a, b in zip(points, [*points[1:], points[0]]):
        part = a[0] * b[1] - b[0] * a[1]
        area, x, y = area + part, x + part * (a[0] + b[0]), y + part * (a[1] + b[1])
    return (x / (3 * area), y / (3 * area))


def _crossing(a: Point, b: Point, c: Point, d: Point) -> Point:
    """Where the line through a and b meets the line through c and d."""
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    t = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / (ux * vy - uy * vx)
    return (a[0] + t * ux, a[1] + t * uy)


def _circumcircle(a: Point, b: Point, c: Point) -> tuple[Point, float]:
    ab, ac = _mean((a, b)), _mean((a, c))
    center = _crossing(
        ab,
        (ab[0] - b[1] + a[1], ab[1] + b[0] - a[0]),
        ac,
        (ac[0] - c[1] + a[1], ac[1] + c[0] - a[0]),
    )
    return center, math.dist(center, a)


def _incircle(a: Point, b: Point, c: Point) -> tuple[Point, float]:
    sides = math.dist(b, c), math.dist(c, a), math.dist(a, b)
    total = sum(sides)
    center = tuple(sum(s * p[i] for s, p in zip(sides, (a, b, c))) / total for i in (0, 1))
    area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    return center, 2 * area / total


def _kernel(points: Sequence[Point]) -> list[Point]:
    """What is left of a counter-clockwise polygon on the inner side of all of its edges."""
    rest = list(points)
    for a, b in zip(points, [*points[1:], points[0]]):
        side = lambda p: (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        kept = []
        for p, q in zip(rest, [*rest[1:], rest[0]]):
            if side(p) >= 0:
                kept.append(p)
            if side(p) * side(q) < 0:
                kept.append(_crossing(p, q, a, b))
        rest = kept
    return rest


def interior_angle() -> Drawing:
    drawing = Drawing()
    points = [(0, 0), (2.4, 0), (2.9, 1.9), (1.4, 1.0), (0.3, 2.0)]
    drawing.polygon(points)
    for i, label in ((0, "θ"), (3, "θ &gt; 180°")):
        start, end = _angle(points[i], points[(i + 1) % 5]), _angle(points[i], points[i - 1])
        end += 360 * (end < start)
        drawing.arc(points[i], 0.35, start, end)
        middle = math.radians((start + end) / 2)
        away = 0.45 if i == 0 else 0.6
        x, y = points[i][0] + away * math.cos(middle), points[i][1] + away * math.sin(middle)
        drawing.text((x - (0.35 if i else 0), y - 0.1), label, MARK)
    return drawing


def dihedral_angle() -> Drawing:
    """Two faces at an edge that comes towards the eye, seen a little from the side."""
    drawing = Drawing()
    back = (0.7, 0.5)
    fold, left, right = (0.0, 0.0), (2.3, 0.0), (1.3, 1.9)
    behind = lambda p: (p[0] + back[0], p[1] + back[1])
    drawing.polygon([fold, right, behind(right), behind(fold)])
    drawing.polygon([fold, left, behind(left), behind(fold)], OTHER)
    drawing.line(fold, behind(fold), MARK)
    drawing.arc(fold, 0.6, 0, _angle(fold, right))
    drawing.text((0.68, 0.28), "θ", MARK)
    for face, direction in (((1.4, 0.0), (0, -1)), ((0.75, 1.1), (-1.9, 1.3))):
        length = math.hypot(*direction)
        end = (face[0] + 0.75 * direction[0] / length, face[1] + 0.75 * direction[1] / length)
        drawing.line(face, end, arrow=True)
    drawing.text((1.5, -0.75), "n₁")
    drawing.text((-0.05, 1.75), "n₂")
    drawing.text((0.5, 0.62), "e", MARK)
    return drawing


def solid_angle() -> Drawing:
    """A corner of a tetrahedron and the triangle that it cuts out of a sphere."""
    drawing = Drawing()
    v, ends = (0.0, 0.0), [(2.6, 0.2), (1.5, 2.1), (2.3, 1.25)]
    drawing.polygon([v, ends[0], ends[1]])
    drawing.line(ends[0], ends[2]), drawing.line(ends[2], ends[1]), drawing.line(v, ends[2])
    on = [(p[0] / math.hypot(*p), p[1] / math.hypot(*p)) for p in ends]
    bulge = lambda a, b, f: ((a[0] + b[0]) / 2 * f, (a[1] + b[1]) / 2 * f)
    a, b, c = on[0], on[1], (on[2][0] * 0.8, on[2][1] * 0.8)
    curve = [(a, b, 1.2), (b, c, 1.08), (c, a, 1.08)]
    path = f"M{drawing.place(a)}" + "".join(
        f" Q{drawing.place(bulge(p, q, f))} {drawing.place(q)}" for p, q, f in curve
    )
    drawing.items.append(f'<path d="{path} Z" fill="{MARK}" fill-opacity="0.35" stroke="{MARK}"/>')
    drawing.dot(v, "v", -0.25, -0.1)
    drawing.text((0.5, 0.95), "Ω", MARK)
    return drawing


def equiangle() -> Drawing:
    drawing = Drawing()
    drawing.polygon([(0, 0), (1.8, 0), (1.8, 1.8), (0, 1.8)], OTHER)
    drawing.arc((0, 0), 0.4, 0, 90, INK)
    drawing.text((0.42, 0.38), "θₑ = 90°")
    points = [(2.8, 0), (4.6, 0), (5.5, 1.8), (3.7, 1.8)]
    drawing.polygon(points)
    drawing.arc(points[0], 0.4, 0, _angle(points[0], points[3]))
    drawing.arc(points[1], 0.3, _angle(points[1], points[2]), 180)
    drawing.text((3.25, 0.22), "θmin", MARK)
    drawing.text((4.15, 0.4), "θmax", MARK)
    return drawing


def radius_edge() -> Drawing:
    drawing = Drawing()
    a, b, c = (0, 0), (2.6, 0.3), (2.1, 1.2)
    center, radius = _circumcircle(a, b, c)
    drawing.circle(center, radius)
    drawing.polygon([a, b, c])
    drawing.line(b, c, MARK)
    drawing.line(center, a, dashed=True)
    drawing.dot(center)
    x, y = _mean((center, a))
    drawing.text((x - 0.1, y - 0.32), "R")
    drawing.text((2.5, 0.75), "min l", MARK)
    return drawing


def radius_ratio() -> Drawing:
    drawing = Drawing()
    a, b, c = (0, 0), (2.8, 0), (1.9, 1.7)
    outer, inner = _circumcircle(a, b, c), _incircle(a, b, c)
    drawing.circle(*outer)
    drawing.polygon([a, b, c])
    drawing.circle(*inner, MARK, False)
    drawing.line(outer[0], a, dashed=True)
    drawing.line(inner[0], (inner[0][0], 0), MARK)
    drawing.dot(outer[0]), drawing.dot(inner[0], color=MARK)
    drawing.text((0.55, 0.3), "R")
    drawing.text((inner[0][0] + 0.08, inner[1] / 2 - 0.1), "r", MARK)
    return drawing


def warpage() -> Drawing:
    """A quadrilateral whose corners lie above and below its mean plane, dashed."""
    drawing = Drawing()
    plane = [(0, 0), (2.4, 0), (3.4, 1.3), (1.0, 1.3)]
    lift = [0.35, -0.35, 0.35, -0.35]
    corners = [(x, y + z) for (x, y), z in zip(plane, lift)]
    drawing.polygon(corners)
    for p, q in zip(plane, [*plane[1:], plane[0]]):
        drawing.line(p, q, dashed=True)
    for p, q in zip(plane, corners):
        drawing.line(p, q, MARK)
    center = _mean(plane)
    drawing.line(center, (center[0], center[1] + 1.3), arrow=True)
    drawing.dot(center, "c", 0.1, -0.2)
    drawing.text((center[0] + 0.1, center[1] + 1.15), "n")
    return drawing


def decomposition() -> Drawing:
    drawing = Drawing()
    points = [(0, 0), (1.7, -0.3), (2.9, 0.7), (2.2, 2.0), (0.5, 1.8)]
    center = _centroid(points)
    drawing.polygon(points)
    drawing.polygon([points[1], points[2], center], "#fed7aa")
    for p in points:
        drawing.line(center, p, dashed=True)
    drawing.dot(center, "C", -0.05, 0.15)
    return drawing


def _neighbors(left: Sequence[Point], right: Sequence[Point], face: tuple[Point, Point]) -> tuple:
    """Two cells with the points P and N, and the normal S of the face between them."""
    drawing = Drawing()
    drawing.polygon(left), drawing.polygon(right, OTHER)
    drawing.line(*face, MARK)
    p, n, middle = _centroid(left), _centroid(right), _mean(face)
    drawing.line(p, n, arrow=True)
    drawing.dot(p, "P", -0.3, -0.05), drawing.dot(n, "N", 0.12, -0.05)
    normal = (face[1][1] - face[0][1], face[0][0] - face[1][0])
    return drawing, p, n, middle, normal


def non_orthogonality() -> Drawing:
    face = ((2.0, 0.0), (2.0, 1.6))
    left = [(0, -0.2), face[0], face[1], (0.2, 1.4)]
    right = [face[0], (3.6, 1.5), (3.8, 3.1), face[1]]
    drawing, p, n, middle, normal = _neighbors(left, right, face)
    at = _crossing(p, n, *face)
    length = math.hypot(*normal)
    end = (at[0] + 1.1 * normal[0] / length, at[1] + 1.1 * normal[1] / length)
    drawing.line(at, end, arrow=True)
    drawing.arc(at, 0.6, _angle(at, end), _angle(at, n))
    drawing.text((at[0] + 0.4, at[1] - 0.3), "S")
    drawing.text((at[0] + 0.66, at[1] + 0.07), "θ", MARK)
    drawing.text((1.35, 0.95), "d")
    return drawing


def skewness() -> Drawing:
    face = ((2.0, -0.9), (2.0, 1.5))
    left = [(0.2, -0.9), face[0], face[1], (0.6, 0.1)]
    right = [face[0], (3.8, -0.9), (3.4, 0.1), face[1]]
    drawing, p, n, middle, _ = _neighbors(left, right, face)
    at = _crossing(p, n, *face)
    drawing.line(at, middle, MARK)
    drawing.items[-1] = drawing.items[-1].replace("/>", ' stroke-width="4"/>')
    drawing.dot(middle, "c", 0.12, 0.05, MARK)
    drawing.dot(at)
    drawing.text((1.78, (at[1] + middle[1]) / 2 - 0.02), "s", MARK)
    drawing.text((2.5, at[1] - 0.3), "d")
    return drawing


def orthogonal_quality() -> Drawing:
    face = ((2.0, 0.0), (2.0, 1.6))
    left = [(0, -0.2), face[0], face[1], (0.2, 1.4)]
    right = [face[0], (3.8, 0.9), (4.0, 2.5), face[1]]
    drawing, p, n, middle, normal = _neighbors(left, right, face)
    drawing.line(p, middle, MARK)
    length = math.hypot(*normal)
    drawing.line(
        middle, (middle[0] + normal[0] / length, middle[1] + normal[1] / length), arrow=True
    )
    drawing.dot(middle, "c", 0.1, -0.3, MARK)
    drawing.text((1.4, 0.5), "w", MARK)
    drawing.text((1.3, 1.15), "d")
    drawing.text((2.75, 0.52), "n")
    return drawing


def kernel() -> Drawing:
    drawing = Drawing()
    points = [(0, 0), (3.0, 0), (3.2, 1.1), (1.4, 0.9), (1.2, 2.4), (0, 2.2)]
    drawing.polygon(points)
    drawing.polygon(_kernel(points), "#fed7aa", MARK)
    drawing.polygon(points, "none")
    return drawing


PICTURES: dict[str, Callable[[], Drawing]] = {
    make.__name__.replace("_", "-"): make
    for make in (
        interior_angle,
        dihedral_angle,
        solid_angle,
        equiangle,
        radius_edge,
        radius_ratio,
        warpage,
        decomposition,
        non_orthogonality,
        skewness,
        orthogonal_quality,
        kernel,
    )
}
