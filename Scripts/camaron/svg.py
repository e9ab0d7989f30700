# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Histograms as inline SVG; colours come from the classes of the page around them."""

from __future__ import annotations

import math
from html import escape
from typing import Any, Optional

from . import text
from .ranking import undefined_count

WIDTH, HEIGHT = 720, 236
LEFT, RIGHT, TOP, BOTTOM = 52, 14, 14, 48
APART_WIDTH = 46  # of one column for what lies in no bin


def ticks(low: float, high: float, most: int) -> list[float]:
    """At most so many round numbers within the range.

    >>> ticks(0.0, 97.0, 6)
    [0.0, 20.0, 40.0, 60.0, 80.0]
    """
    span = high - low
    rounding = 1e-13 * max(abs(low), abs(high))
    if not span > rounding or not math.isfinite(span):
        return [low]
    power = 10.0 ** math.floor(math.log10(span / most))
    for factor in (1, 2, 5, 10):
        step = factor * power
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first + 1 <= most:
            break
    return [k * step + 0.0 for k in range(first, last + 1)]


def _axis_label(value: float, step: float) -> str:
    """The tick's number with as many digits as tell it from its neighbours."""
    if value == 0.0:
        return "0"
    if abs(value) >= 1e5 or abs(value) < 1e-4:
        digits = max(0, math.floor(math.log10(abs(value))) - math.floor(math.log10(step) + 1e-9))
        mantissa, exponent = f"{value:.{digits}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{value:.{max(0, -math.floor(math.log10(step) + 1e-9))}f}"


class _Axis:
    """Horizontal axis; histograms of one value get a little room on both sides."""

    def __init__(self, edges: list[float], left: float, right: float):
        low, high = edges[0], edges[-1]
        if not high > low:
            room = max(abs(low), 1.0) * 0.05
            low, high = low - room, high + room
        self.low, self.high, self.left, self.right = low, high, left, right

    def __call__(self, value: float) -> float:
        share = (value - self.low) / (self.high - self.low)
        return self.left + (self.right - self.left) * min(max(share, 0.0), 1.0)

    def bar(self, lower: float, upper: float) -> tuple[float, float]:
        """Left end and width of the bar of a bin."""
        if upper > lower:
            return self(lower), self(upper) - self(lower)
        return self(lower) - 0.02 * (self.right - self.left), 0.04 * (self.right - self.left)


def histogram(criterion: dict[str, Any], identifier: str) -> str:
    """Bins, acceptable range and quantiles of a criterion, and apart what lies in no bin."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    apart = [
        (name, amount)
        for name, amount in (
            ("under", data["underflow"]),
            ("over", data["overflow"]),
            ("inf", data["inf"]),
            ("null", undefined_count(criterion)),
        )
        if amount
    ]
    right = WIDTH - RIGHT - (12 + APART_WIDTH * len(apart) if apart else 0)
    base = HEIGHT - BOTTOM
    # What lies apart may be cut off at the top, its number stands below; the bins set the scale.
    top = max(counts or [amount for _, amount in apart], default=1)
    height = lambda amount: (base - TOP) * min(amount / top, 1.0)
    name = escape(criterion["label"])
    parts = [
        f'<svg class="histogram" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="Histogram of {name}">'
    ]
    for tick in ticks(0.0, float(top), 4):
        if tick != int(tick):
            continue
        y = base - height(tick)
        parts.append(
            f'<line class="grid" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
        )
        parts.append(
            f'<text class="tick" x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">'
            f"{text.count(int(tick), text.THIN)}</text>"
        )
    if counts:
        parts += _bins(criterion, _Axis(edges, LEFT, right), base, right, height, identifier)
    else:
        middle = (LEFT + right) / 2
        parts.append(
            f'<text class="tick" x="{middle:.0f}" y="{(TOP + base) / 2:.0f}" text-anchor="middle">'
            "no finite value</text>"
        )
    parts.append(f'<line class="axis" x1="{LEFT}" x2="{right:.1f}" y1="{base}" y2="{base}"/>')
    for k, (label, amount) in enumerate(apart):
        x, h = right + 12 + APART_WIDTH * k, height(amount)
        left, middle, end = x + 8, x + APART_WIDTH / 2, x + APART_WIDTH
        parts.append(
            f'<rect class="{"null" if label == "null" else "apart"}" x="{left:.1f}" '
            f'width="{APART_WIDTH - 16}" y="{base - h:.1f}" height="{h:.1f}">'
            f"<title>{label}: {text.plural(amount, 'cell')}</title></rect>"
            f'<line class="axis" x1="{x + 3:.1f}" x2="{end - 3:.1f}" y1="{base}" y2="{base}"/>'
            f'<text class="tick" x="{middle:.1f}" y="{base + 16}" text-anchor="middle">{label}</text>'
            f'<text class="tick strong" x="{middle:.1f}" y="{base + 30}" text-anchor="middle">'
            f"{text.count(amount, text.THIN)}</text>"
        )
    parts.append("</svg>")
    return "".join(parts)


def _bins(criterion, axis, base, right, height, identifier) -> list[str]:
    """Bars, the acceptable range behind them, ticks and quantiles."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    low, high = criterion["acceptable"]
    parts = []
    limited = low is not None or high is not None
    if limited:
        x0 = axis(low) if low is not None else axis.left
        x1 = axis(high) if high is not None else axis.right
        if x1 > x0:
            parts.append(
                f'<rect class="acceptable" x="{x0:.1f}" width="{x1 - x0:.1f}" y="{TOP}" '
                f'height="{base - TOP}"><title>acceptable: '
                f'{text.interval(low, high, criterion["unit"])}</title></rect>'
            )
        for limit in (low, high):
            if limit is not None and axis.low < limit < axis.high:
                x = axis(limit)
                parts.append(
                    f'<line class="limit" x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{base}"/>'
                )
        # Wherever a bin lies across a limit, only the part of its bar inside is drawn as such.
        parts.append(
            f'<clipPath id="{identifier}"><rect x="{x0:.1f}" width="{max(x1 - x0, 0):.1f}" y="0" '
            f'height="{base}"/></clipPath>'
        )
    total = criterion["count"]
    integers = _are_integers(edges)
    groups: dict[str, list[str]] = {"outside": [], "inside": []}
    for k, amount in enumerate(counts):
        if not amount:
            continue
        lower, upper = edges[k], edges[k + 1]
        x, width = axis.bar(lower, upper)
        if integers:
            lower = upper = 0.5 * (lower + upper)
            slim = min(0.8 * width, 56.0)
            x, width = x + 0.5 * (width - slim), slim
        elif width > 3.0:
            x, width = x + 0.5, width - 1.0
        h = max(height(amount), 1.0)
        span = (
            text.number(lower) if lower == upper else f"{text.number(lower)} – {text.number(upper)}"
        )
        first, last = bin_range(edges, k)
        shape = (
            f'<rect data-low="{first!r}" data-high="{last!r}" '
            f'x="{x:.2f}" width="{width:.2f}" y="{base - h:.2f}" height="{h:.2f}">'
            f"<title>{span}: {text.plural(amount, 'cell')} ({text.percent(amount, total)} %)"
            "</title></rect>"
        )
        out_low = low is not None and lower < low
        out_high = high is not None and upper > high
        if out_low or out_high:
            groups["outside"].append(shape)
        if not (out_low and upper < low) and not (out_high and lower > high):
            groups["inside"].append(shape)
    # Of a bin across a limit both are drawn, the part inside over the other.
    parts.append(f'<g class="outside">{"".join(groups["outside"])}</g>')
    clip = f' clip-path="url(#{identifier})"' if groups["outside"] and not integers else ""
    parts.append(f'<g class="inside"{clip}>{"".join(groups["inside"])}</g>')
    parts += _curves(criterion, axis, base)
    if integers:
        marks = sorted({round(tick) for tick in ticks(edges[0], edges[-1], 12)})
    else:
        marks = ticks(axis.low, axis.high, 8) if edges[-1] > edges[0] else [edges[0]]
    step = marks[1] - marks[0] if len(marks) > 1 else abs(marks[0]) * 1e-3 or 1.0
    for tick in marks:
        x = axis(tick)
        label = _axis_label(tick, step) if len(marks) > 1 else text.number(tick, 6)
        parts.append(
            f'<line class="axis" x1="{x:.1f}" x2="{x:.1f}" y1="{base}" y2="{base + 4}"/>'
            f'<text class="tick" x="{x:.1f}" y="{base + 16}" text-anchor="middle">{label}</text>'
        )
    if edges[-1] > edges[0]:
        parts += _quantile_marks(criterion["quantiles"], axis, base)
    return parts


def bin_range(edges: list[float], k: int) -> tuple[float, float]:
    """The smallest and the largest number in a bin, which does not include its upper edge unless it is the last.

    >>> bin_range([0.0, 1.0, 2.0], 0), bin_range([0.0, 1.0, 2.0], 1)
    ((0.0, 0.9999999999999999), (1.0, 2.0))
    """
    lower, upper = edges[k], edges[k + 1]
    is_last = k + 2 == len(edges)
    return lower, upper if is_last else math.nextafter(upper, -math.inf)


def _curves(criterion, axis, base) -> list[str]:
    """Cumulative curves from 0 % below to 100 % above: of the cells, and dashed of the volume."""
    curve = criterion.get("curve") or {"values": []}
    if len(curve["values"]) < 3:
        return []
    parts = []
    for key, name, what in (("percent", "curve", "cells"), ("weight_percent", "curve volume", "volume")):
        if len(curve[key]) != len(curve["values"]):
            continue
        points = [
            f"{axis(x):.1f} {base - (base - TOP) * y / 100.0:.1f}"
            for x, y in zip(curve["values"], curve[key])
        ]
        path = f"M{axis(curve['values'][0]):.1f} {base}L" + "L".join(points)
        parts.append(f'<path class="{name}" d="{path}"><title>share of the {what}</title></path>')
    return parts


def _are_integers(edges: list[float]) -> bool:
    """Whether every bin is that of one integer."""
    return (
        len(edges) > 1
        and all(edge - 0.5 == int(edge - 0.5) for edge in edges)
        and edges[1] - edges[0] == 1.0
    )


def _quantile_marks(quantiles, axis, base) -> list[str]:
    """Triangles below the axis; a label gives way where the median's is too close."""
    parts = []
    places: list[float] = []
    for quantile, label in (("50", "median"), ("1", "p1"), ("99", "p99")):
        value = quantiles.get(quantile)
        if value is None:
            continue
        x = axis(value)
        meaning = "median" if quantile == "50" else f"{quantile} % of the cells lie below"
        parts.append(
            f'<path class="quantile" d="M{x:.1f} {base + 22}l4 7h-8z">'
            f"<title>{meaning}: {text.number(value)}</title></path>"
        )
        if all(abs(x - place) > 32.0 for place in places):
            parts.append(
                f'<text class="tick faint" x="{x:.1f}" y="{base + 40}" text-anchor="middle">'
                f"{label}</text>"
            )
            places.append(x)
    return parts


def comparison(criterion: dict[str, Any]) -> str:
    """Shares of two meshes in the same bins: B as bars, A as a line over them."""
    data = criterion["histogram"]
    edges, name = data["edges"], escape(criterion["label"])
    if not data["a"]:
        return '<p class="description">No finite value.</p>'
    axis, base = _Axis(edges, LEFT, WIDTH - RIGHT), HEIGHT - BOTTOM
    top = max([*data["a"], *data["b"]]) or 1.0
    height = lambda share: (base - TOP) * share / top
    parts = [
        f'<svg class="histogram" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="Histograms of {name}">'
    ]
    for tick in ticks(0.0, 100.0 * top, 4):
        y = base - height(tick / 100.0)
        parts.append(
            f'<line class="grid" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
            f'<text class="tick" x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">'
            f"{text.number(tick)}{text.THIN}%</text>"
        )
    line = [f"M{axis.bar(edges[0], edges[1])[0]:.2f} {base}"]
    for lower, upper, a, b in zip(edges, edges[1:], data["a"], data["b"]):
        x, width = axis.bar(lower, upper)
        span = f"{text.number(lower)} – {text.number(upper)}"
        shares = f"A {text.number(100 * a, 3)} %, B {text.number(100 * b, 3)} %"
        parts.append(
            f'<rect class="inside" x="{x:.2f}" width="{max(width - 1.0, 0.6):.2f}" '
            f'y="{base - height(b):.2f}" height="{height(b):.2f}"/>'
            f'<rect class="hover" x="{x:.2f}" width="{width:.2f}" y="{TOP}" height="{base - TOP}">'
            f"<title>{span}: {shares}</title></rect>"
        )
        line.append(f"V{base - height(a):.2f}H{x + width:.2f}")
    parts.append(f'<path class="before" d="{"".join(line)}V{base}"/>')
    for limit in criterion["acceptable"]:
        if limit is not None and axis.low < limit < axis.high:
            x = axis(limit)
            parts.append(f'<line class="limit" x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{base}"/>')
    marks = ticks(axis.low, axis.high, 8) if edges[-1] > edges[0] else [edges[0]]
    step = marks[1] - marks[0] if len(marks) > 1 else abs(marks[0]) * 1e-3 or 1.0
    for tick in marks:
        x = axis(tick)
        parts.append(
            f'<line class="axis" x1="{x:.1f}" x2="{x:.1f}" y1="{base}" y2="{base + 4}"/>'
            f'<text class="tick" x="{x:.1f}" y="{base + 16}" text-anchor="middle">'
            f"{_axis_label(tick, step)}</text>"
        )
    parts.append(f'<line class="axis" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{base}" y2="{base}"/></svg>')
    return "".join(parts)


def sparkline(criterion: dict[str, Any], width: int = 120, height: int = 26) -> str:
    """The histogram's outline in a line of a table."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    if not counts:
        return ""
    axis = _Axis(edges, 0.0, float(width))
    top = max([*counts, 1])
    low, high = criterion["acceptable"]
    integers = _are_integers(edges)
    parts = [f'<svg class="spark" viewBox="0 0 {width} {height}" aria-hidden="true">']
    for k, amount in enumerate(counts):
        if not amount:
            continue
        x, w = axis.bar(edges[k], edges[k + 1])
        if integers and w > 8.0:
            x, w = x + 0.5 * (w - 8.0), 8.0
        h = max((height - 1) * amount / top, 1.0)
        middle = 0.5 * (edges[k] + edges[k + 1])
        out = (low is not None and middle < low) or (high is not None and middle > high)
        parts.append(
            f'<rect class="{"outside" if out else "inside"}" x="{x:.1f}" '
            f'width="{max(w - 0.4, 0.8):.1f}" y="{height - h:.1f}" height="{h:.1f}"/>'
        )
    parts.append("</svg>")
    return "".join(parts)
