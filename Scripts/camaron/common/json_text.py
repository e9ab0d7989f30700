# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as JSON that any parser can read."""

from __future__ import annotations

import json
import math
from typing import Any


def to_json(result: Any) -> str:
    """The result as JSON; infinite numbers become "Infinity" and "-Infinity", NaN null."""

    def plain(value):
        if isinstance(value, dict):
            return {key: plain(item) for key, item in value.items()}
        if isinstance(value, (list, tuple)):
            return [plain(item) for item in value]
        if isinstance(value, float) and math.isinf(value):
            return "Infinity" if value > 0 else "-Infinity"
        if isinstance(value, float) and math.isnan(value):
            return None
        return value

    return json.dumps(plain(result), indent=1, ensure_ascii=False, allow_nan=False)
