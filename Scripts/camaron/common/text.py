# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Formats numbers and tables as text."""

from __future__ import annotations

import difflib
import math
import re
import shlex
import unicodedata
from typing import Any, Iterable, Optional, Sequence

#: Unicode categories of characters that terminals interpret instead of printing them.
OBEYED = ("Cc", "Cf", "Cs", "Zl", "Zp")
#: Smaller limits mean "above zero".
SMALLEST = 1e-300
#: Space between groups of three digits.
THIN = "\u202f"
UNIT_SYMBOLS = {"deg": "°", "rad": "rad", "sr": "sr"}


#: Singular and plural of cell types whose names differ from these.
CELL_TYPES = {
    "Vertex": ("vertex", "vertices"),
    "PolyVertex": ("poly-vertex", "poly-vertices"),
    "Quad": ("quadrangle", "quadrangles"),
    "Tetra": ("tetrahedron", "tetrahedra"),
    "Hexahedron": ("hexahedron", "hexahedra"),
    "Polyhedron": ("polyhedron", "polyhedra"),
}


def no_formula(value: Any) -> Any:
    """A value of a CSV table. Names from a file that spreadsheets would run as a formula begin with an apostrophe.

    >>> no_formula("=HYPERLINK(1)"), no_formula("rotor"), no_formula(-1.0)
    ("'=HYPERLINK(1)", 'rotor', -1.0)
    """
    return f"'{value}" if isinstance(value, str) and value[:1] in tuple("=+-@\t\r\n") else value


def number(value: Optional[float], digits: int = 4) -> str:
    """The value with the given number of significant digits; an empty text for None and NaN.

    >>> number(0.12345678), number(1234567.0), number(-3.0), number(float("inf"))
    ('0.1235', '1.235e+06', '-3', 'inf')
    """
    if value is None or math.isnan(value):
        return ""
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.{digits}g}"


def with_unit(name: str, unit: str) -> str:
    """A name with the symbol of its unit.

    >>> with_unit("Angle", "deg"), with_unit("Ratio", "")
    ('Angle (°)', 'Ratio')
    """
    return f"{name} ({UNIT_SYMBOLS.get(unit, unit)})" if unit else name


def printable(words: str) -> str:
    r"""The text on one line, with ? for characters that terminals interpret, such as control
    characters.

    >>> printable("a\x1b[31mb\nc")
    'a?[31mb?c'
    """
    return "".join("?" if unicodedata.category(c) in OBEYED else c for c in words)


def shell_word(words: str) -> str:
    r"""The text as a word of a shell command; bash's $'' if it is not printable.

    >>> shell_word("a b.visf"), shell_word("a\x1b'.visf")
    ("'a b.visf'", "$'a\\x1b\\'.visf'")
    """
    if printable(words) == words:
        return shlex.quote(words)
    coded = "".join(
        (
            "".join(f"\\x{byte:02x}" for byte in c.encode(errors="surrogateescape"))
            if unicodedata.category(c) in OBEYED
            else c
        )
        for c in words.replace("\\", "\\\\").replace("'", "\\'")
    )
    return f"$'{coded}'"


def all_printable(found: Any) -> Any:
    """Makes all texts in lists and dictionaries printable."""
    if isinstance(found, str):
        return printable(found)
    if isinstance(found, dict):
        return {key: all_printable(value) for key, value in found.items()}
    if isinstance(found, (list, tuple)):
        return type(found)(map(all_printable, found))
    return found


def count(value: Optional[int], separator: str = "") -> str:
    """An integer with a separator between groups of three digits.

    >>> count(1234567, " ")
    '1 234 567'
    """
    return "" if value is None else f"{value:,}".replace(",", separator)


def percent(part: float, whole: float) -> str:
    """The percentage, rounded to 0 or 100 only if it is exactly 0 or 100.

    >>> percent(0, 5), percent(1, 3), percent(1, 10**6), percent(999999, 10**6)
    ('0', '33.3', '<0.01', '>99.9')
    """
    if not whole or not part:
        return "0"
    if part == whole:
        return "100"
    share = 100.0 * part / whole
    if share < 0.01:
        return "<0.01"
    if share > 99.9:
        return ">99.9"
    return f"{share:.3g}"


def interval(low: Optional[float], high: Optional[float], unit: str = "") -> str:
    """A range as text; None is an open end.

    >>> interval(40, None, "deg"), interval(0.2, 1.0), interval(None, None)
    ('≥ 40°', '0.2 – 1', '')
    """
    symbol = UNIT_SYMBOLS.get(unit, unit)
    suffix = symbol if symbol in ("", "°") else " " + symbol
    if low is None and high is None:
        return ""
    if low is not None and 0.0 < low < SMALLEST:
        return f"> 0{suffix}" if high is None else f"> 0{suffix}, ≤ {number(high)}{suffix}"
    if high is None:
        return f"≥ {number(low)}{suffix}"
    if low is None:
        return f"≤ {number(high)}{suffix}"
    return f"{number(low)} – {number(high)}{suffix}"


def in_ascii(sentence: str) -> str:
    """The sentence for terminals of any encoding.

    >>> in_ascii("≥ 40°")
    '>= 40 deg'
    """
    for symbol, plain in (("≥", ">="), ("≤", "<="), ("–", "-"), ("°", " deg"), (THIN, "")):
        sentence = sentence.replace(symbol, plain)
    return sentence


def memory(size: Optional[int]) -> str:
    """
    >>> memory(512), memory(12_582_912)
    ('512 B', '12.6 MB')
    """
    if size is None:
        return ""
    for unit, scale in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if size >= scale:
            return f"{size / scale:.3g} {unit}"
    return f"{size} B"


def duration(seconds: float) -> str:
    """A time of which the first digit or two are known.

    >>> duration(0.2), duration(41.7), duration(200), duration(9000)
    ('1 s', '42 s', '3 min', '2.5 h')
    """
    if seconds < 100:
        return f"{max(1, round(seconds))} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.2g} h"


def plural(amount: int, noun: str, separator: str = "") -> str:
    """
    >>> plural(1, "cell"), plural(1200, "cell", ",")
    ('1 cell', '1,200 cells')
    """
    return f"{count(amount, separator)} {noun if amount == 1 else noun + 's'}"


def cell_type(label: str, amount: int = 2) -> str:
    """The singular or plural of a cell type, from its label in the tables of statistics.

    >>> cell_type("Tetra"), cell_type("Wedge"), cell_type("QuadraticTetra"), cell_type("Tetra", 1)
    ('tetrahedra', 'wedges', 'quadratic tetrahedra', 'tetrahedron')
    """
    if label in CELL_TYPES:
        return CELL_TYPES[label][amount != 1]
    *first, last = re.findall(r"[A-Z][a-z0-9]*", label) or [label]
    names = CELL_TYPES.get(last, (last.lower(), last.lower() + "s"))
    return " ".join([*(word.lower() for word in first), names[amount != 1]])


def table(header: Sequence[str], rows: Iterable[Sequence[str]], left: int = 1) -> list[str]:
    """Lines of a table whose first `left` columns are left-aligned and the others right-aligned."""
    rows = [list(header), *map(list, rows)]
    widths = [max(len(row[c]) for row in rows) for c in range(len(header))]
    lines = []
    for row in rows:
        cells = [
            text.ljust(width) if c < left else text.rjust(width)
            for c, (text, width) in enumerate(zip(row, widths))
        ]
        lines.append("  ".join(cells).rstrip())
    return lines


def similar(name: str, known: Sequence[str]) -> Optional[str]:
    """The closest known name, regardless of case, or None if none is close."""
    by_lower = {k.lower(): k for k in known}
    close = difflib.get_close_matches(name.lower(), list(by_lower), 1)
    return by_lower[close[0]] if close else None


def lookup(name: str, known: Sequence[str], kind: str, lists_all: bool = False) -> str:
    """The known name in its usual spelling; raises ValueError with a suggestion for an unknown name, or with all
    names if none is similar or `lists_all`."""
    by_lower = {k.lower(): k for k in known}
    if name.lower() in by_lower:
        return by_lower[name.lower()]
    close = similar(name, known)
    hint = f"did you mean {close}?" if close else f"expected one of {', '.join(known)}"
    if close and lists_all:
        hint += f" There are {', '.join(known)}."
    raise ValueError(f"unknown {kind} {name}: {hint}")
