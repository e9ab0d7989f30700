# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The camera of pictures."""

from __future__ import annotations

import math
from typing import Any, Sequence

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

SIZE = (1200, 900)
BAR_SHARE = 0.16  # fraction of the width that is kept free for the color bar


class Camera:
    """Parallel projection that shows the whole mesh and leaves a strip on the right free."""

    def __init__(self, bounds: Sequence[float]):
        low, high = bounds[0::2], bounds[1::2]
        extent = [b - a for a, b in zip(low, high)]
        self.middle = self.center = [0.5 * (a + b) for a, b in zip(low, high)]
        self.diagonal = math.hypot(*extent) or 1.0
        self.towards, up = direction(extent)
        self.right = _cross(up, self.towards)
        self.up = _cross(self.towards, self.right)
        # The box fills the view; `fit` does the same for what is drawn.
        half = (
            lambda axis: 0.5 * sum(abs(e * x) for e, x in zip(extent, axis)) or 0.5 * self.diagonal
        )
        self.scale = max(half(self.up), half(self.right) * SIZE[1] / SIZE[0])

    def fit(self, view: Any) -> None:
        """Moves the camera so that the visible objects fill the view, measured on a small
        picture."""
        width, height = 400, 300
        view.ViewSize = [width, height]
        self.apply(view)
        image = view.CaptureWindow(1)
        rgb = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
        drawn = numpy.any(rgb[..., :3] < 250, axis=2)
        view.ViewSize = list(SIZE)
        columns, rows = numpy.flatnonzero(drawn.any(axis=0)), numpy.flatnonzero(drawn.any(axis=1))
        if max(len(columns), len(rows)) < 8:
            return  # (almost) nothing is visible
        pixel = 2.0 * self.scale / height
        middle = lambda found, size: pixel * (0.5 * (found[0] + found[-1] + 1) - 0.5 * size)
        half = lambda found: 0.5 * pixel * (found[-1] - found[0] + 1)
        step = middle(columns, width), middle(rows, height)
        self.center = [
            c + step[0] * r + step[1] * u for c, r, u in zip(self.center, self.right, self.up)
        ]
        aspect = SIZE[0] / SIZE[1]
        self.scale = 1.07 * max(half(rows), half(columns) / (aspect * (1.0 - BAR_SHARE)))
        shift = self.scale * aspect * BAR_SHARE
        self.center = [c + shift * r for c, r in zip(self.center, self.right)]

    def apply(self, view: Any) -> None:
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = self.center
        view.CameraPosition = [
            c + 2.0 * self.diagonal * t for c, t in zip(self.center, self.towards)
        ]
        view.CameraViewUp = self.up
        view.CameraParallelScale = self.scale


def direction(extent: Sequence[float]) -> tuple[list[float], list[float]]:
    """Direction from the mesh to the camera, and the view-up vector: isometric as in the window
    (vtkSMRenderViewProxy::ApplyIsometricView), or in front of a plane."""
    diagonal = math.hypot(*extent)
    flat = [axis for axis in range(3) if extent[axis] <= 1e-6 * diagonal]
    if len(flat) == 1:
        towards, up = {
            0: ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
            1: ([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
            2: ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        }[flat[0]]
        return towards, up
    return [3**-0.5] * 3, [0.0, 1.0, 0.0]


def _cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
    c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    length = math.hypot(*c)
    return [x / length for x in c]
