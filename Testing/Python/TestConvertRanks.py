# ranks: 1 2 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert on several ranks writes the files that one rank writes."""

import camaron_testing
from camaron import convert, pipeline
from paraview import simple


class TestConvertRanks(camaron_testing.TestCase):
    def test_same_files(self):
        """Each rank reads its share; what is written has every point and cell once, in order."""
        for name, target, options in (
            ("voronoi-ball", "m.visf", {}),
            ("flange", "m.tri", {"unsupported-cells": "convert"}),
            ("polygon-ring", "m.tri", {"unsupported-cells": "convert"}),
        ):
            source = camaron_testing.EXAMPLES / f"{name}.visf"
            together, alone = self.folder / f"{name}-{target}", self.folder / f"{name}-1-{target}"
            convert(source, together, **options)
            words = [word for key, value in options.items() for word in (f"--{key}", value)]
            run = camaron_testing.run_command("convert", source, alone, *words)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(together.read_bytes(), alone.read_bytes(), name)

    def test_pieces_without_ids(self):
        """Pieces that share points but have no global ids are one mesh again in the file."""
        image = simple.Wavelet(WholeExtent=[0, 6, 0, 6, 0, 6])
        path = self.folder / "image.off"
        with pipeline.Messages() as messages:
            simple.SaveData(str(path), image, FacesOfVolumes="Every")
        self.assertEqual(messages.errors, [])
        lines = [line for line in path.read_text().splitlines() if line]
        points, faces, _ = (int(word) for word in lines[1].split())
        self.assertEqual((points, faces), (7**3, 3 * 7 * 6**2))
        self.assertEqual(len({tuple(line.split()) for line in lines[2 : 2 + points]}), points)


if __name__ == "__main__":
    camaron_testing.main()
