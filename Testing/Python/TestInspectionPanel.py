# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of Mesh Inspection in the Display panel: those of ParaView do what they do for Surface, and whatever is
set together, there is a picture, no message of OpenGL, and the memory does not grow."""

import random

import camaron_testing
import gallery
from inspection_testing import difference, make_view, picture, turn
from mesh_parts import producer
from paraview import servermanager, simple

from camaron.common import pipeline

STEPS = 300
#: What else would show: nothing, or copies kept on purpose.
LEFT_OUT = ("Visibility", "ForceUseCache", "ForcedCacheKey")


def memory():
    """Bytes of this process in memory."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


def tetrahedra():
    wavelet = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    quality = simple.ElementQuality(Input=simple.Tetrahedralize(Input=wavelet))
    quality.UpdatePipeline()  # shapes are as large as what is known of it
    return quality


@camaron_testing.require_display()
class TestInspectionPanel(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.view = make_view()
        self.addCleanup(simple.ResetSession)

    def test_options_of_surface(self):
        """The same pictures as Surface without our edges, for each option alone."""
        mesh = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
        # An open surface, for its back faces.
        bowl = simple.Sphere(StartTheta=0, EndTheta=200, ThetaResolution=30, PhiResolution=30)
        color = [0.9, 0.5, 0.2]
        options = (
            (bowl, {"BackfaceRepresentation": "Surface", "BackfaceDiffuseColor": color}),
            (bowl, {"BackfaceRepresentation": "Cull Backface"}),
            (bowl, {"BackfaceRepresentation": "Cull Frontface"}),
            (bowl, {"Specular": 0.8, "SpecularPower": 20}),
            (bowl, {"Interpolation": "Flat"}),
            (bowl, {"Interpolation": "PBR", "Roughness": 0.4, "Metallic": 0.3}),
            (bowl, {"Ambient": 0.5, "Diffuse": 0.4, "AmbientColor": color, "DiffuseColor": color}),
            (bowl, {"Opacity": 0.4}),
            (bowl, {"DisableLighting": 1, "DiffuseColor": color}),
            (bowl, {"Scale": [1, 2, 1], "Orientation": [10, 20, 30], "Translation": [1, 0, 0]}),
            (mesh, {"Opacity": 0.4}),
            (mesh, {"Specular": 0.8, "SpecularPower": 20}),
            (mesh, {"Interpolation": "PBR", "Roughness": 0.2}),
            (mesh, {"BackfaceRepresentation": "Cull Frontface"}),
        )
        for source, properties in options:
            with self.subTest(properties):
                pictures = []
                for representation in ("Surface", "Mesh Inspection"):
                    simple.HideAll(self.view)
                    proxy = simple.PassArrays(Input=source, PointDataArrays=["Normals"])
                    display = simple.Show(proxy, self.view)
                    display.SetRepresentationType(representation)
                    display.DrawEdges = 0
                    for name, value in properties.items():
                        setattr(display, name, value)
                    turn(self.view)
                    pictures.append(picture(self.view))
                self.assertLess(difference(*pictures, 12), 0.004)
                self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255, 12), 0.02)

    def test_edge_opacity(self):
        """Half opaque black edges over white faces are gray."""
        cube = simple.Box()
        display = simple.Show(cube, self.view)
        display.SetRepresentationType("Mesh Inspection")
        display.EdgeColor, display.LineWidth = [0, 0, 0], 9
        display.AmbientColor = display.DiffuseColor = [1, 1, 1]
        display.DisableLighting = 1
        for opacity in (1.0, 0.5):
            display.EdgeOpacity = opacity
            turn(self.view)
            darkest = picture(self.view).min()
            self.assertAlmostEqual(darkest, 255 * (1 - opacity), delta=3)

    def test_anything_goes(self):
        """No message, and no crash, whatever is set, one property after the other."""
        meshes = (
            tetrahedra(),
            producer(gallery.polyhedra()),
            simple.GroupDatasets(Input=[producer(gallery.mixed()), simple.Sphere()]),
            simple.SelectElements(Input=tetrahedra(), Strategy="Shape", Shape="Sphere"),
            simple.Threshold(Input=tetrahedra(), Scalars=["POINTS", "RTData"], LowerThreshold=1e9),
        )
        for seed, mesh in enumerate(meshes):
            self.play(mesh, "Mesh Inspection", seed, STEPS // len(meshes))

    def test_memory(self):
        """Played again, when all shaders are there, nothing stays in memory that does not with Surface."""
        growth = []
        for representation in ("Surface", "Mesh Inspection"):
            used = [self.play(tetrahedra(), representation, 0, 25) for _ in range(3)]
            growth.append(used[2] - used[1])
        self.assertLess(growth[1] - growth[0], 20e6)

    def play(self, mesh, representation, seed, steps):
        """Sets properties at random; the memory that is used after it."""
        simple.HideAll(self.view)
        display = simple.Show(mesh, self.view)
        display.SetRepresentationType(representation)
        turn(self.view)
        panel = RandomPanel(display, seed)
        history = []
        with pipeline.Messages() as messages:
            for _ in range(steps):
                history.append(panel.turn())
                self.view.GetActiveCamera().Azimuth(7)
                picture(self.view)
        self.assertEqual(messages.errors + messages.warnings, [], history[-5:])
        simple.Delete(display)
        return memory()


class RandomPanel:
    """Values for the properties of a display, from the domains that the panel shows."""

    def __init__(self, display, seed):
        self.display = display
        self.random = random.Random(seed)
        inspection = servermanager.ProxyManager().GetPrototypeProxy(
            "representations", "MeshInspectionRepresentation"
        )
        names = [name for name in display.ListProperties() if inspection.GetProperty(name)]
        self.choices = {name: self.domain(name) for name in names if name not in LEFT_OUT}
        self.choices = {name: choose for name, choose in self.choices.items() if choose}
        arrays = [("POINTS", name) for name in display.Input.PointData.keys()]
        arrays += [("CELLS", name) for name in display.Input.CellData.keys()]
        self.arrays = arrays + [None]

    def domain(self, name):
        """A function that chooses a value; None where there is nothing to choose from."""
        prop = self.display.GetProperty(name).SMProperty
        if not prop.IsA("vtkSMVectorProperty"):
            return None
        size = prop.GetNumberOfElements()
        entries = prop.FindDomain("vtkSMEnumerationDomain")
        if entries:
            texts = [entries.GetEntryText(i) for i in range(entries.GetNumberOfEntries())]
            return (lambda: self.random.choice(texts)) if texts else None
        if prop.FindDomain("vtkSMBooleanDomain"):
            return lambda: self.random.choice((0, 1))
        for kind, number in (
            ("vtkSMDoubleRangeDomain", float),
            ("vtkSMIntRangeDomain", round),
        ):
            domain = prop.FindDomain(kind)
            if domain and size:
                low = domain.GetMinimum(0) if domain.GetMinimumExists(0) else -10
                high = domain.GetMaximum(0) if domain.GetMaximumExists(0) else 10
                one = lambda: number(self.random.uniform(low, high))
                return one if size == 1 else lambda: [one() for _ in range(size)]
        return None

    def turn(self):
        """Sets one property; what was set."""
        kind = self.random.random()
        if kind < 0.1:
            value = self.random.choice(self.arrays)
            if value or self.display.ColorArrayName[1]:
                simple.ColorBy(self.display, value)
            return "ColorBy", value
        if kind < 0.15:
            self.display.CutShape = self.random.choice(("Sphere", "Plane", "Box"))
            return "CutShape", self.display.CutShape
        if kind < 0.2 and self.display.Input.PointData.keys():
            self.display.IsolineArray = self.random.choice(self.arrays[:-1])
            return "IsolineArray", self.display.IsolineArray
        name = self.random.choice(list(self.choices))
        value = self.choices[name]()
        setattr(self.display, name, value)
        return name, value


if __name__ == "__main__":
    camaron_testing.main()
