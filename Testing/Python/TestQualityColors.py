# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The color map of criteria: steps at the limits, and colors that people tell apart who see fewer of them."""

import math
import sys

import camaron_testing
import numpy
from camaron.inspection.pictures import Scene, colors_of
from paraview import servermanager, simple

#: Linear RGB as seen with protanopia, deuteranopia and tritanopia: Machado, Oliveira and Fernandes 2009, severity 1.
SIGHTS = {
    "normal": numpy.eye(3),
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}
TO_XYZ = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750]]
TO_XYZ.append([0.0193339, 0.1191920, 0.9503041])
WHITE = [0.95047, 1, 1.08883]


def to_lab(rgb, sight="normal"):
    rgb = numpy.asarray(rgb)
    linear = numpy.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    seen = numpy.clip(numpy.asarray(SIGHTS[sight]) @ linear, 0, 1)
    xyz = numpy.asarray(TO_XYZ) @ seen / WHITE
    f = numpy.where(xyz > (6 / 29) ** 3, numpy.cbrt(xyz), xyz * 841 / 108 + 4 / 29)
    return 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])


def difference(one, other):
    """CIEDE2000: Sharma, Wu and Dalal 2005."""
    (l1, a1, b1), (l2, a2, b2) = one, other
    mean = (math.hypot(a1, b1) + math.hypot(a2, b2)) / 2
    g = 1.5 - 0.5 * math.sqrt(mean**7 / (mean**7 + 25**7))
    c1, c2 = math.hypot(g * a1, b1), math.hypot(g * a2, b2)
    h1, h2 = (math.degrees(math.atan2(b, g * a)) % 360 for a, b in ((a1, b1), (a2, b2)))
    turn = 0 if c1 * c2 == 0 else (h2 - h1 + 180) % 360 - 180
    hue = h1 + h2 if c1 * c2 == 0 else (h1 + turn / 2) % 360
    l, c = (l1 + l2) / 2, (c1 + c2) / 2
    cos = lambda degrees: math.cos(math.radians(degrees))
    t = 1 - 0.17 * cos(hue - 30) + 0.24 * cos(2 * hue) + 0.32 * cos(3 * hue + 6)
    t -= 0.20 * cos(4 * hue - 63)
    sl = 1 + 0.015 * (l - 50) ** 2 / math.sqrt(20 + (l - 50) ** 2)
    sc, sh = 1 + 0.045 * c, 1 + 0.015 * c * t
    rt = -2 * math.sqrt(c**7 / (c**7 + 25**7))
    rt *= math.sin(math.radians(60 * math.exp(-(((hue - 275) / 25) ** 2))))
    dl, dc = (l2 - l1) / sl, (c2 - c1) / sc
    dh = 2 * math.sqrt(c1 * c2) * math.sin(math.radians(turn / 2)) / sh
    return math.sqrt(dl**2 + dc**2 + dh**2 + rt * dc * dh)


def criterion(low, high, acceptable, better="neither", quantiles=(), outside=(0, 0)):
    """A criterion in the summary of a mesh."""
    return {
        "min": low,
        "max": high,
        "quantiles": dict(zip(("1", "99"), quantiles)),
        "better": better,
        "out_of_range": sum(outside),
        "below": outside[0],
        "above": outside[1],
        "acceptable": acceptable,
        "judged": 1,
        "applicable": 2,
        "undefined": 1,
    }


def make(low, high, acceptable=(None, None), better="neither", quantiles=(), outside=(0, 0)):
    """Values and colors of a map, and the colors of undefined values and of cells not judged."""
    found = colors_of(criterion(low, high, acceptable, better, quantiles, outside))
    table = numpy.reshape(found["Points"], (-1, 4))
    return table[:, 0], table[:, 1:], [found["UndefinedColor"], found["NotJudgedColor"]]


class TestQualityColors(camaron_testing.TestCase):
    def test_few_beyond(self):
        """The map reaches beyond a limit if any cell does, though others span less than a fifth of all values."""
        values, colors, _ = make(-200, 90, (10, None), "bigger", (25, 60), (3, 0))
        self.assertEqual((values[0], values[-1]), (-2.5, 60))
        self.assertGreater(colors[0][0], 2 * colors[0][2], "red")
        values, _, _ = make(-200, 90, (10, None), "bigger", (25, 60))
        self.assertEqual((values[0], values[-1]), (25, 60))
        values, colors, _ = make(-200, 90, (None, 80), "smaller", (25, 60), (0, 1))
        self.assertEqual((values[0], values[-1]), (25, 90))
        self.assertGreater(colors[-1][0], 2 * colors[-1][2], "red")

    def test_formula(self):
        """Pairs 1, 7 and 25 of the data of Sharma, Wu and Dalal."""
        for one, other, expected in (
            ((50, 2.6772, -79.7751), (50, 0, -82.7485), 2.0425),
            ((50, 0, 0), (50, -1, 2), 2.3669),
            ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
        ):
            self.assertAlmostEqual(difference(one, other), expected, places=4)

    @camaron_testing.require_display()
    def test_light(self):
        """Reports have the light, edges and background that are part of the colors, as the window."""
        look, scene = servermanager.misc.QualityColors(), Scene()
        self.addCleanup(scene.close)
        display = scene.show(simple.Sphere())
        for name in ("Ambient", "Diffuse", "EdgeColor", "EdgeOpacity"):
            self.assertEqual(getattr(display, name), getattr(look, name), name)
        self.assertEqual(scene.view.Background, look.Background)
        self.assertGreater(look.Ambient, 0)

    def test_mesh_color(self):
        """A mesh without a criterion stands out from the default backgrounds of ParaView 5.13 and 6.1, and from white, for
        everybody, wherever its faces are turned to."""
        look = servermanager.misc.QualityColors()
        backgrounds = ([0.329, 0.349, 0.427], [0.384, 0.365, 0.353], [1, 1, 1])
        for sight in SIGHTS:
            for light in (look.Ambient, look.Ambient + look.Diffuse):
                color = to_lab(numpy.clip(light * numpy.array(look.MeshColor), 0, 1), sight)
                for background in backgrounds:
                    with self.subTest(sight=sight, light=light, background=background):
                        self.assertGreater(difference(color, to_lab(background, sight)), 9)

    def test_labels(self):
        """The limits are labeled in any case, then the ends and round numbers where there is room, with as many digits as
        tell them apart."""
        for low, high, acceptable, labels, texts in (
            (0.00373378, 68.8, (20, None), [0.00373378, 10, 20, 30, 40, 50, 60, 68.8], None),
            (
                1.4836,
                84.4,
                (20, None),
                [1.4836, 20, 40, 60, 84.4],
                ["1.48", "20", "40", "60", "84.4"],
            ),
            (0, 4.1, (None, 4), [0, 1, 2, 3, 4], None),
            (1, 80, (18.6, 71.3), [1, 18.6, 40, 60, 71.3, 80], None),
            (30, 60, (20, 70), [30, 35, 40, 45, 50, 55, 60], None),
            (101325, 101326, (None, None), None, ["101325", "101325.2", "101325.4"]),
            (4, 123456, (None, 5e4), None, ["4", "20000", "50000"]),
        ):
            found = colors_of(criterion(low, high, acceptable))
            with self.subTest(low=low, high=high, found=found["Labels"]):
                digits = found["LabelDigits"][0]
                if labels:
                    self.assertTrue(numpy.allclose(found["Labels"], labels), labels)
                if texts:
                    shown = [f"{label:.{digits}g}" for label in found["Labels"]]
                    self.assertEqual(shown[: len(texts)], texts)

    def test_steps(self):
        """At the limits, which are acceptable themselves; no warm color where all is acceptable."""
        is_warm = lambda color: color[0] > color[2] + 0.2
        for low, high, acceptable, bad in (
            (1, 80, (20, None), [(1, 20)]),
            (1, 80, (None, 70), [(70, 80)]),
            (1, 80, (20, 70), [(1, 20), (70, 80)]),
            (30, 60, (20, 70), []),
            (1, 10, (20, 70), [(1, 10)]),
            (75, 80, (20, 70), [(75, 80)]),
            (10, 10, (20, None), [(10, 10.1)]),
            (75, 75, (20, 70), [(75, 75.75)]),
            (50, 50, (None, 70), []),
        ):
            with self.subTest(low=low, high=high, acceptable=acceptable):
                values, colors, _ = make(low, high, acceptable)
                self.assertEqual(values[0], low)
                self.assertAlmostEqual(values[-1], high if high > low else 1.01 * low)
                self.assertEqual(sorted(values), list(values))
                for value, color in zip(values, colors):
                    inside = [a <= value <= b for a, b in bad]
                    at_limit = value in acceptable
                    self.assertEqual(is_warm(color), any(inside) and not at_limit, (value, color))
                for limit in set(acceptable) & {20, 70}:
                    if low < limit < high:
                        self.assertIn(limit, values)

    def test_constant(self):
        """Values that only rounding tells apart have the color of the good end unless they are bad."""
        for acceptable, better, value in (
            ((20, None), "bigger", 90),
            ((None, None), "bigger", 90),
            ((None, None), "smaller", 90),
            ((None, 100), "smaller", 90),
        ):
            with self.subTest(acceptable=acceptable, better=better):
                values, colors, _ = make(value, value * (1 + 1e-9), acceptable, better)
                nearest = colors[abs(values - value).argmin()]
                self.assertGreater(min(nearest), 0.9)

    def test_zero(self):
        """An end that rounding tells from zero is zero, unless it is on the other side of it, or zero is bad."""
        for low, high, ends in (
            (2e-6, 167, (0, 167)),
            (2e-3, 167, (2e-3, 167)),
            (-1e-9, 1, (-1e-9, 1)),
            (-5, -1e-9, (-5, 0)),
        ):
            values, _, _ = make(low, high, (0, None))
            self.assertEqual((values[0], values[-1]), ends)
        for low, high, acceptable in (
            (0, 1, (1, None)),
            (0, 1, (None, 0)),
        ):  # of Valid, the limit has its color, too
            values, colors, _ = make(low, high, acceptable)
            self.assertAlmostEqual(values[-1] - values[0], 1.1)
            limit = colors[list(values).index(high if acceptable[0] else low)]
            self.assertLess(limit[0], limit[2])
        values, colors, _ = make(1e-12, 1e-3, (sys.float_info.min, None), "bigger")
        self.assertEqual(values[0], 1e-12)
        self.assertLess(colors[0][0], colors[0][2], "no red")

    def test_sights(self):
        """Good and bad colors differ by 15 for everybody, those of undefined values and of cells not judged from all
        others by 10, neighbors in a legend by 3."""
        maps = [make(0, 100, (50, None)), make(0, 100, (None, 50)), make(0, 100, (30, 70))]
        maps += [make(0, 1, better=better) for better in ("bigger", "smaller", "neither")]
        for sight in SIGHTS:
            for values, colors, others in maps:
                with self.subTest(sight=sight, values=values):
                    labs = [to_lab(color, sight) for color in colors]
                    self.assertGreater(difference(*(to_lab(o, sight) for o in others)), 10)
                    warm = [color[0] > color[2] + 0.2 for color in colors]
                    for i, lab in enumerate(labs):
                        if i:
                            self.assertGreater(difference(labs[i - 1], lab), 3)
                        for other in others:
                            self.assertGreater(difference(to_lab(other, sight), lab), 10)
                        for k in range(i):
                            if warm[i] != warm[k]:
                                self.assertGreater(difference(labs[k], lab), 15, (k, i))


if __name__ == "__main__":
    camaron_testing.main()
