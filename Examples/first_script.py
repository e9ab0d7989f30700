# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
# Run it from the root of the repository: ./camaron shell pvpython Examples/first_script.py
from paraview.simple import *

LoadDistributedPlugin("Camaron", ns=globals())
mesh = OpenDataFile("Examples/voronoi-ball.visf")
quality = ElementQuality(Input=mesh, Criteria=["Volume", "MinDihedralAngle", "EdgeLengthRatio"])
statistics = QualityStatistics(Input=quality)
SaveData("statistics.csv", statistics)
SaveData("voronoi-ball.vtu", quality)
