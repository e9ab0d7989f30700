# ranks: 1 2 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.convert on several ranks writes the files that one rank writes."""

import camaron_testing
from camaron import convert


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


if __name__ == "__main__":
    camaron_testing.main()
