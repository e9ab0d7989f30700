# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Histograms as inline SVG; colors come from the classes of the page around them."""

from __future__ import annotations

import math
from typing import Any

from . import text
from .assessment import drawn_limits, undefined_count
from .markup import Markup, html

WIDTH, HEIGHT = 720, 236
LEFT, RIGHT, TOP, BOTTOM = 52, 14, 14, 48
APART_WIDTH = 46  # of a column of values outside the bins


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
    """The number of a tick with enough digits to distinguish it from its neighbors."""
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


def histogram(criterion: dict[str, Any], identifier: str) -> Markup:
    """Histogram of a criterion with its acceptable range and quantiles, and columns of values
    outside the bins."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    apart = [
        (name, amount)
        for name, amount in (
            ("under", data["underflow"]),
            ("over", data["overflow"]),
            ("inf", data["infinite"]),
            ("undefined", undefined_count(criterion)),
        )
        if amount
    ]
    right = WIDTH - RIGHT - (12 + APART_WIDTH * len(apart) if apart else 0)
    base = HEIGHT - BOTTOM
    # The bins define the scale; columns of values outside may be cut off, with their number below.
    top = max(counts or [amount for _, amount in apart], default=1)
    height = lambda amount: (base - TOP) * min(amount / top, 1.0)
    parts = [_open("Histogram of " + criterion["label"])]
    for tick in ticks(0.0, float(top), 4):
        if tick != int(tick):
            continue
        y = base - height(tick)
        parts.append(_grid_line(y, text.count(int(tick), text.THIN)))
    if counts:
        parts += _bins(criterion, _Axis(edges, LEFT, right), base, right, height, identifier)
    else:
        parts.append(_label((LEFT + right) / 2, (TOP + base) / 2, "no finite value"))
    parts.append(_axis_line(LEFT, right, base))
    for k, (label, amount) in enumerate(apart):
        x, h = right + 12 + APART_WIDTH * k, height(amount)
        middle = x + APART_WIDTH / 2
        parts += [
            html(
                '<rect class="{}" x="{:.1f}" width="{}" y="{:.1f}" height="{:.1f}">'
                "<title>{}: {}</title></rect>",
                "undefined" if label == "undefined" else "apart",
                x + 8,
                APART_WIDTH - 16,
                base - h,
                h,
                label,
                text.plural(amount, "cell"),
            ),
            _axis_line(x + 3, x + APART_WIDTH - 3, base),
            _label(middle, base + 16, label),
            _label(middle, base + 30, text.count(amount, text.THIN), "strong"),
        ]
    return html("{}</svg>", parts)


def _open(label: str) -> Markup:
    return html(
        '<svg class="histogram" viewBox="0 0 {} {}" role="img" aria-label="{}">',
        WIDTH,
        HEIGHT,
        label,
    )


def _label(x: float, y: float, words: str, kind: str = "") -> Markup:
    """A text below or within the axes."""
    template = '<text class="tick {}" x="{:.1f}" y="{:.0f}" text-anchor="middle">{}</text>'
    return html(template, kind, x, y, words)


def _axis_line(x0: float, x1: float, base: float) -> Markup:
    return html('<line class="axis" x1="{:.1f}" x2="{:.1f}" y1="{}" y2="{}"/>', x0, x1, base, base)


def _grid_line(y: float, label: str) -> Markup:
    return html(
        '<line class="grid" x1="{}" x2="{}" y1="{y:.1f}" y2="{y:.1f}"/>'
        '<text class="tick" x="{}" y="{:.1f}" text-anchor="end">{}</text>',
        LEFT,
        WIDTH - RIGHT,
        LEFT - 8,
        y + 4,
        label,
        y=y,
    )


def _limit_line(x: float, base: float) -> Markup:
    return html('<line class="limit" x1="{x:.1f}" x2="{x:.1f}" y1="{}" y2="{}"/>', TOP, base, x=x)


def _tick(x: float, base: float, label: str) -> Markup:
    return html(
        '<line class="axis" x1="{x:.1f}" x2="{x:.1f}" y1="{}" y2="{}"/>{}',
        base,
        base + 4,
        _label(x, base + 16, label),
        x=x,
    )


def _bins(criterion, axis, base, right, height, identifier) -> list[Markup]:
    """Bars, the acceptable range behind them, ticks and quantiles."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    low, high = drawn_limits(criterion)
    parts = []
    limited = low is not None or high is not None
    if limited:
        x0 = axis(low) if low is not None else axis.left
        x1 = axis(high) if high is not None else axis.right
        if x1 > x0:
            parts.append(
                html(
                    '<rect class="acceptable" x="{:.1f}" width="{:.1f}" y="{}" height="{}">'
                    "<title>acceptable: {}</title></rect>",
                    x0,
                    x1 - x0,
                    TOP,
                    base - TOP,
                    text.interval(low, high, criterion["unit"]),
                )
            )
        for limit in (low, high):
            if limit is not None and axis.low < limit < axis.high:
                parts.append(_limit_line(axis(limit), base))
        # If a limit crosses a bin, only the inner part of its bar is drawn as inside.
        parts.append(
            html(
                '<clipPath id="{}"><rect x="{:.1f}" width="{:.1f}" y="0" height="{}"/></clipPath>',
                identifier,
                x0,
                max(x1 - x0, 0),
                base,
            )
        )
    total = criterion["count"]
    integers = _are_integers(edges)
    groups: dict[str, list[Markup]] = {"outside": [], "inside": []}
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
        shape = html(
            '<rect data-low="{!r}" data-high="{!r}" x="{:.2f}" width="{:.2f}" y="{:.2f}" height="{:.2f}">'
            "<title>{}: {} ({} %)</title></rect>",
            first,
            last,
            x,
            width,
            base - h,
            h,
            span,
            text.plural(amount, "cell"),
            text.percent(amount, total),
        )
        out_low = low is not None and lower < low
        out_high = high is not None and upper > high
        if out_low or out_high:
            groups["outside"].append(shape)
        if not (out_low and upper < low) and not (out_high and lower > high):
            groups["inside"].append(shape)
    # A bin across a limit is drawn twice, with the inner part on top.
    parts.append(html('<g class="outside">{}</g>', groups["outside"]))
    clip = html(' clip-path="url(#{})"', identifier) if groups["outside"] and not integers else ""
    parts.append(html('<g class="inside"{}>{}</g>', clip, groups["inside"]))
    parts += _curves(criterion, axis, base)
    if integers:
        marks = sorted({round(tick) for tick in ticks(edges[0], edges[-1], 12)})
    else:
        marks = ticks(axis.low, axis.high, 8) if edges[-1] > edges[0] else [edges[0]]
    step = marks[1] - marks[0] if len(marks) > 1 else abs(marks[0]) * 1e-3 or 1.0
    for tick in marks:
        x = axis(tick)
        label = _axis_label(tick, step) if len(marks) > 1 else text.number(tick, 6)
        parts.append(_tick(x, base, label))
    if edges[-1] > edges[0]:
        parts += _quantile_marks(criterion["quantiles"], axis, base)
    return parts


def bin_range(edges: list[float], k: int) -> tuple[float, float]:
    """The smallest and the largest number in a bin; only the last bin includes its upper edge.

    >>> bin_range([0.0, 1.0, 2.0], 0), bin_range([0.0, 1.0, 2.0], 1)
    ((0.0, 0.9999999999999999), (1.0, 2.0))
    """
    lower, upper = edges[k], edges[k + 1]
    is_last = k + 2 == len(edges)
    return lower, upper if is_last else math.nextafter(upper, -math.inf)


def _curves(criterion, axis, base) -> list[Markup]:
    """Cumulative curves from 0 % at the bottom to 100 % at the top: of the cells, and dashed of the
    volume."""
    curve = criterion.get("curve") or {"values": []}
    if len(curve["values"]) < 3:
        return []
    parts = []
    for key, name, what in (
        ("percent", "curve", "cells"),
        ("weight_percent", "curve volume", "volume"),
    ):
        if len(curve[key]) != len(curve["values"]):
            continue
        points = [
            f"{axis(x):.1f} {base - (base - TOP) * y / 100.0:.1f}"
            for x, y in zip(curve["values"], curve[key])
        ]
        path = f"M{axis(curve['values'][0]):.1f} {base}L" + "L".join(points)
        template = '<path class="{}" d="{}"><title>percentage of the {}</title></path>'
        parts.append(html(template, name, path, what))
    return parts


def _are_integers(edges: list[float]) -> bool:
    """Whether every bin contains one integer."""
    return (
        len(edges) > 1
        and all(edge - 0.5 == int(edge - 0.5) for edge in edges)
        and edges[1] - edges[0] == 1.0
    )


def _quantile_marks(quantiles, axis, base) -> list[Markup]:
    """Triangles below the axis; labels too close to that of the median are omitted."""
    parts = []
    places: list[float] = []
    for quantile, label in (("50", "median"), ("1", "p1"), ("99", "p99")):
        value = quantiles.get(quantile)
        if value is None:
            continue
        x = axis(value)
        meaning = "median" if quantile == "50" else f"{quantile} % of the cells are below"
        parts.append(
            html(
                '<path class="quantile" d="M{:.1f} {}l4 7h-8z"><title>{}: {}</title></path>',
                x,
                base + 22,
                meaning,
                text.number(value),
            )
        )
        if all(abs(x - place) > 32.0 for place in places):
            parts.append(_label(x, base + 40, label, "faint"))
            places.append(x)
    return parts


def comparison(criterion: dict[str, Any]) -> Markup:
    """Percentages of two meshes in the same bins: B as bars, A as a line."""
    data = criterion["histogram"]
    edges = data["edges"]
    if not data["a"]:
        return html('<p class="description">No finite value.</p>')
    axis, base = _Axis(edges, LEFT, WIDTH - RIGHT), HEIGHT - BOTTOM
    top = max([*data["a"], *data["b"]]) or 1.0
    height = lambda share: (base - TOP) * share / top
    parts = [_open("Histograms of " + criterion["label"])]
    for tick in ticks(0.0, 100.0 * top, 4):
        y = base - height(tick / 100.0)
        parts.append(_grid_line(y, f"{text.number(tick)}{text.THIN}%"))
    line = [f"M{axis.bar(edges[0], edges[1])[0]:.2f} {base}"]
    for lower, upper, a, b in zip(edges, edges[1:], data["a"], data["b"]):
        x, width = axis.bar(lower, upper)
        span = f"{text.number(lower)} – {text.number(upper)}"
        shares = f"A {text.number(100 * a, 3)} %, B {text.number(100 * b, 3)} %"
        parts.append(
            html(
                '<rect class="inside" x="{:.2f}" width="{:.2f}" y="{:.2f}" height="{:.2f}"/>'
                '<rect class="hover" x="{:.2f}" width="{:.2f}" y="{}" height="{}">'
                "<title>{}: {}</title></rect>",
                x,
                max(width - 1.0, 0.6),
                base - height(b),
                height(b),
                x,
                width,
                TOP,
                base - TOP,
                span,
                shares,
            )
        )
        line.append(f"V{base - height(a):.2f}H{x + width:.2f}")
    parts.append(html('<path class="before" d="{}V{}"/>', line, base))
    limited = any(criterion[mesh]["out_of_range_percent"] is not None for mesh in "ab")
    for limit in criterion["acceptable"] if limited else ():
        if limit is not None and axis.low < limit < axis.high:
            parts.append(_limit_line(axis(limit), base))
    marks = ticks(axis.low, axis.high, 8) if edges[-1] > edges[0] else [edges[0]]
    step = marks[1] - marks[0] if len(marks) > 1 else abs(marks[0]) * 1e-3 or 1.0
    for tick in marks:
        parts.append(_tick(axis(tick), base, _axis_label(tick, step)))
    return html("{}{}</svg>", parts, _axis_line(LEFT, WIDTH - RIGHT, base))


def sparkline(criterion: dict[str, Any], width: int = 120, height: int = 26) -> Markup:
    """The histogram's outline in a line of a table."""
    data = criterion["histogram"]
    edges, counts = data["edges"], data["counts"]
    if not counts:
        return html("")
    axis = _Axis(edges, 0.0, float(width))
    top = max([*counts, 1])
    low, high = drawn_limits(criterion)
    integers = _are_integers(edges)
    parts = []
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
            html(
                '<rect class="{}" x="{:.1f}" width="{:.1f}" y="{:.1f}" height="{:.1f}"/>',
                "outside" if out else "inside",
                x,
                max(w - 0.4, 0.8),
                height - h,
                h,
            )
        )
    return html(
        '<svg class="spark" viewBox="0 0 {} {}" aria-hidden="true">{}</svg>', width, height, parts
    )
