# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""The language of the rules of `camaron check` (Documentation/check.md); needs no ParaView."""

from __future__ import annotations

import math
import os
import re
import stat
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, Iterable, Mapping, Optional, Sequence

from ..common import text

#: Maximum size of a file of rules in bytes.
MAX_SIZE = 1 << 20
#: Cell shapes with VTK's type of the linear cell, which is their CellFamilyId.
FAMILIES = {
    "triangles": 5,
    "quadrangles": 9,
    "polygons": 7,
    "tetrahedra": 10,
    "pyramids": 14,
    "wedges": 13,
    "hexahedra": 12,
    "polyhedra": 42,
}
#: Names of several shapes.
FAMILY_SETS = {
    "2D cells": ("triangles", "quadrangles", "polygons"),
    "3D cells": ("tetrahedra", "pyramids", "wedges", "hexahedra", "polyhedra"),
}
SINGULAR = {"tetrahedron": "tetrahedra", "hexahedron": "hexahedra", "polyhedron": "polyhedra"}
LARGEST = 1.7976931348623157e308

_TOKEN = re.compile(
    r"""\s*(?: (?P<comment>\#.*) | "(?P<double>[^"]*)" | '(?P<single>[^']*)'
        | (?P<sign>>=|<=|==|>|<|=) | (?P<word>[^\s\#"'<>=]+) | (?P<open>["'].*) )""",
    re.VERBOSE,
)
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?|[+-]?inf(inity)?", re.IGNORECASE)


class RulesError(ValueError):
    """All problems of rules; the text has one line per problem."""

    def __init__(self, problems: Sequence[str]):
        super().__init__("\n".join(problems))
        self.problems = list(problems)


def _quoted(name: str) -> str:
    """The name, in quotation marks if a line requires them."""
    if re.fullmatch(r"""[^\s#"'<>=]+""", name):
        return name
    return f"'{name}'" if '"' in name else f'"{name}"'


@dataclass(frozen=True)
class Scope:
    """The cells of a rule: families, a cell type, a block, or the cells with a value of an array.

    Several families are one text, such as "tetrahedra, wedges" or "3D cells".
    """

    kind: str
    value: Any
    array: str = ""

    def __str__(self) -> str:
        if self.kind == "array":
            return f"where {_quoted(self.array)} = {self.value}"
        if self.kind == "family":
            return f"of {self.value}"
        words = {"type": "of type", "block": "in"}
        return f"{words[self.kind]} {_quoted(self.value)}"

    def families(self) -> list[str]:
        """The names of the families."""
        return [name for word in self.value.split(", ") for name in FAMILY_SETS.get(word, (word,))]


def scope_of_shapes(shapes: str) -> Optional[Scope]:
    """The scope of shapes as named in the table of criteria; None for all cells.

    >>> str(scope_of_shapes("triangles and quadrilaterals")), scope_of_shapes("polygons and polyhedra")
    ('of triangles, quadrangles', None)
    """
    names = {"quadrilaterals": "quadrangles", "polygons": "2D cells", "polyhedra": "3D cells"}
    words = [names.get(word, word) for word in re.split(", | and ", shapes)]
    if "any cell" in words or words == [""] or {*FAMILY_SETS} <= {*words}:
        return None
    return Scope("family", ", ".join(words))


@dataclass(frozen=True)
class Tolerance:
    """The cells that may fail: a percentage of the checked cells, or a number.

    >>> share = Tolerance(percent=Fraction("0.1"))
    >>> share.cells(1000), share.cells(999)
    (1, 0)
    """

    percent: Optional[Fraction] = None
    count: int = 0

    def cells(self, checked: int) -> int:
        """The number of checked cells that may fail."""
        return self.count if self.percent is None else math.floor(self.percent * checked / 100)

    def __str__(self) -> str:
        return str(self.count) if self.percent is None else f"{float(self.percent):g}%"


NONE = Tolerance()


@dataclass(frozen=True)
class Rule:
    """A criterion with its acceptable range, its cells, and its tolerance."""

    criterion: str
    low: Optional[float] = None
    high: Optional[float] = None
    #: Whether the limits themselves are acceptable.
    closed: tuple[bool, bool] = (True, True)
    scope: Optional[Scope] = None
    tolerance: Tolerance = NONE
    null_fails: bool = True
    #: The rule is a hint of a preset; a violation is a warning.
    hint: bool = False
    #: Origin: its line in the file, and its preset, if any.
    line: Optional[int] = None
    preset: Optional[str] = None

    def limits(self) -> tuple[float, float]:
        """The smallest and the largest acceptable number; infinite values are never acceptable."""
        low = -LARGEST if self.low is None else self.low
        high = LARGEST if self.high is None else self.high
        return (
            low if self.closed[0] else math.nextafter(low, math.inf),
            high if self.closed[1] else math.nextafter(high, -math.inf),
        )

    def range_text(self) -> str:
        """
        >>> Rule("Volume", low=0.0, closed=(False, True)).range_text()
        '> 0'
        >>> Rule("EdgeLengthRatio", 0.2, 1.0).range_text()
        '0.2 to 1'
        """
        low, high = (None if x is None else text.number(x, 6) for x in (self.low, self.high))
        signs = [">=" if self.closed[0] else ">", "<=" if self.closed[1] else "<"]
        if self.low is not None and 0.0 < self.low < text.SMALLEST:
            low, signs[0] = "0", ">"
        if low is not None and self.low == self.high and all(self.closed):
            return f"= {low}"
        if low is not None and high is not None and signs == [">=", "<="]:
            return f"{low} to {high}"
        parts = [f"{sign} {x}" for sign, x in zip(signs, (low, high)) if x is not None]
        return " ".join(parts)

    def __str__(self) -> str:
        """
        >>> str(Rule("FaceCount", high=12.0, scope=Scope("family", "polyhedra")))
        'FaceCount <= 12 of polyhedra'
        """
        return " ".join(filter(None, (self.criterion, self.range_text(), str(self.scope or ""))))


class _Wrong(Exception):
    """The problem of a line."""


class _Line:
    """The tokens of a line."""

    def __init__(self, line: str):
        self.tokens: list[tuple[str, str]] = []
        place = 0
        while match := _TOKEN.match(line, place):
            place = match.end()
            kind = match.lastgroup
            if kind == "open":
                raise _Wrong(f"expected a closing {match[kind][0]}, found end of line")
            if kind != "comment":
                name = "quoted" if kind in ("double", "single") else kind
                self.tokens.append((name, match[kind]))

    def peek(self) -> tuple[str, str]:
        """Kind and text of the next token; the kind is "end" after the last one."""
        return self.tokens[0] if self.tokens else ("end", "")

    def found(self) -> str:
        kind, word = self.peek()
        return "end of line" if kind == "end" else f"'{word}'"

    def wrong(self, expected: str, known: Iterable[str] = ()) -> _Wrong:
        """The error for a token other than `expected`, with the closest of the `known` names."""
        similar = text.similar(self.peek()[1], list(known))
        hint = f"; did you mean {similar}?" if similar else ""
        return _Wrong(f"expected {expected}, found {self.found()}{hint}")

    def take(self, expected: str, kinds: Sequence[str] = ("word", "quoted")) -> str:
        if self.peek()[0] not in kinds:
            raise self.wrong(expected)
        return self.tokens.pop(0)[1]

    def take_number(self, expected: str) -> float:
        kind, word = self.peek()
        if kind != "word" or not _NUMBER.fullmatch(word):
            raise self.wrong(expected)
        self.tokens.pop(0)
        return float(word.lower().replace("d", "e"))

    def take_if(self, word: str) -> bool:
        if self.peek() == ("word", word):
            self.tokens.pop(0)
            return True
        return False


def _readable(message: str) -> str:
    """The message with long words truncated and unprintable characters escaped.

    >>> _readable("found 'a" + chr(0) + "b'")
    "found 'a\\\\x00b'"
    """
    message = re.sub(r"\S{80,}", lambda word: word[0][:60] + "...", message)
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in message)


class Parser:
    """Parses rules with the names of criteria, presets (`tables.known_presets`) and VTK's cell
    types."""

    def __init__(
        self,
        criteria: Iterable[str],
        presets: Mapping[str, Mapping[str, Any]],
        cell_types: Iterable[str],
        tolerance: Tolerance = NONE,
    ):
        self.criteria, self.presets = list(criteria), dict(presets)
        self.cell_types, self.tolerance = list(cell_types), tolerance

    def read(self, path: os.PathLike | str) -> list[Rule]:
        """The rules of a file; RulesError lists all of its problems, or why it cannot be read."""
        path = Path(path)
        try:
            mode = path.stat().st_mode
            if not stat.S_ISREG(mode) and not stat.S_ISDIR(
                mode
            ):  # opening a folder fails with its own error
                raise RulesError([f"{path}: expected a file of rules, found a pipe or a device"])
            with open(path, "rb") as file:
                data = file.read(MAX_SIZE + 1)
        except OSError as error:
            raise RulesError([f"{path}: {error.strerror}"]) from None
        if len(data) > MAX_SIZE:
            raise RulesError([f"{path}: too large for a file of rules"])
        try:
            content = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            raise RulesError([f"{path}: expected text in UTF-8, found other bytes"]) from None
        if "\0" in content:
            raise RulesError([f"{path}: expected text, found a zero byte"])
        return self.parse(re.split(r"\r\n|\r|\n", content), str(path))

    def parse(self, lines: Iterable[str], name: str = "rules") -> list[Rule]:
        """The rules of lines of text; `name` is the name of their file in messages."""
        # By keys that must be unique.
        written: dict[tuple, Rule] = {}
        of_presets: dict[tuple, Rule] = {}
        problems = []
        for number, line in enumerate(lines, 1):
            try:
                if not isinstance(line, str):
                    raise _Wrong(f"expected a line of text, found {line!r}")
                for rule in self._parse_line(_Line(line), number):
                    if rule.preset is None:
                        key = (rule.criterion, rule.scope, rule.limits())
                        if (other := written.setdefault(key, rule)) is not rule:
                            where = f"that of line {other.line}"
                            raise _Wrong(f"expected a rule other than {where}, found {rule} again")
                    else:
                        of_presets[rule.criterion, self._named_scope(rule)] = rule
            except _Wrong as wrong:
                problems.append(f"{name}:{number}: {_readable(str(wrong))}")
        if problems:
            raise RulesError(problems)
        for rule in written.values():
            of_presets.pop((rule.criterion, rule.scope), None)
        rules = [rule for rule in (*of_presets.values(), *written.values()) if rule.range_text()]
        if not rules:
            raise RulesError([f"{name}: expected at least one criterion with a range, found none"])
        return rules

    def preset(self, name: str, line: Optional[int] = None) -> list[Rule]:
        """The rules of a preset, whose name may be in any case; raises ValueError if it is
        unknown."""
        name = text.lookup(name, list(self.presets), "preset")
        hints, shapes = self.presets[name]["hints"], self.presets[name]["shapes"]
        common = {"tolerance": self.tolerance, "line": line, "preset": name}
        return [
            Rule(
                criterion,
                low,
                high,
                scope=scope_of_shapes(shapes.get(criterion, "")),
                hint=criterion in hints,
                **common,
            )
            for criterion, (low, high) in self.presets[name]["rules"].items()
            if (low, high) != (None, None)
        ]

    def _named_scope(self, rule: Rule) -> Optional[Scope]:
        """The scope that a line gives to a rule of a preset; None for the shapes that the preset
        covers."""
        shapes = self.presets[rule.preset]["shapes"].get(rule.criterion, "")
        return None if rule.scope == scope_of_shapes(shapes) else rule.scope

    def _parse_line(self, line: _Line, number: int) -> list[Rule]:
        if line.peek()[0] == "end":
            return []
        if line.take_if("preset"):
            name = line.take("the name of a preset")
            try:
                rules = self.preset(name, number)
            except ValueError:
                line.tokens.insert(0, ("word", name))
                raise line.wrong("the name of a preset", self.presets) from None
        else:
            if line.peek()[1] not in self.criteria:
                raise line.wrong("the name of a criterion", self.criteria)
            rules = [self._parse_range(line, Rule(line.take("a name"), line=number))]
        changes = {"tolerance": self.tolerance, **self._parse_clauses(line)}
        return [replace(rule, **changes) for rule in rules]

    def _parse_range(self, line: _Line, rule: Rule) -> Rule:
        if line.peek()[0] == "sign":
            rule = _parse_comparisons(line, rule)
        else:
            if line.peek()[0] == "end":
                raise line.wrong("a range: >= 10, or a lower and an upper limit")
            low = _parse_limit(line, "the lower limit: a number, or * for none", -math.inf)
            high = _parse_limit(line, "the upper limit: a number, or * for none", math.inf)
            if low == math.inf or high == -math.inf:
                raise _Wrong(f"expected a range with values, found none of {rule.criterion}")
            rule = replace(
                rule,
                low=None if low == -math.inf else low,
                high=None if high == math.inf else high,
            )
        low, high = rule.limits()
        if low > high:
            raise _Wrong(
                "expected a lower limit that is not above the upper limit, "
                f"found {rule.criterion} {rule.range_text()}"
            )
        return rule

    def _parse_clauses(self, line: _Line) -> dict[str, Any]:
        """Parses the clauses after the range, as members of a Rule."""
        readers = {
            "of": ("scope", self._parse_shape),
            "in": ("scope", lambda line: Scope("block", line.take("the name of a block"))),
            "where": ("scope", _parse_value),
            "tolerate": ("tolerance", _parse_tolerance),
            "null": ("null_fails", _parse_null),
        }
        members: dict[str, Any] = {}
        while line.peek()[0] != "end":
            kind, word = line.peek()
            if kind != "word" or word not in readers:
                raise line.wrong("of, in, where, tolerate, null or end of line", readers)
            member, reader = readers[word]
            if member in members:
                what = {"scope": "one of the words of, in and where", "tolerance": "one tolerate"}
                raise _Wrong(f"expected {what.get(member, 'one null')}, found another: '{word}'")
            line.tokens.pop(0)
            members[member] = reader(line)
        return members

    def _parse_shape(self, line: _Line) -> Scope:
        if line.take_if("type"):
            if line.peek()[1] not in self.cell_types:
                raise line.wrong("VTK's name of a cell type, such as Tetra", self.cell_types)
            return Scope("type", line.take("a name"))
        families = []
        while not families or word.endswith(","):
            word = line.peek()[1].lower()
            name = word.rstrip(",")
            family = SINGULAR.get(name, name if name in FAMILIES else name + "s")
            family = {"2d": "2D cells", "3d": "3D cells"}.get(name, family)
            if family not in FAMILIES and family not in FAMILY_SETS:
                known = [*FAMILIES, *FAMILY_SETS]
                raise line.wrong(f"type, or a shape: {', '.join(known)}", FAMILIES)
            line.take("a shape")
            if family in FAMILY_SETS:
                line.take_if("cells")
            families.append(family)
        return Scope("family", ", ".join(families))


def _parse_limit(line: _Line, expected: str, open_end: float) -> float:
    if line.take_if("*") or line.take_if("-"):
        return open_end
    return line.take_number(expected)


def _parse_comparisons(line: _Line, rule: Rule) -> Rule:
    """One or two of `>= x`, `> x`, `<= x`, `< x`, or `= x`."""
    while line.peek()[0] == "sign":
        sign = line.peek()[1]
        sides = {">": ("low",), "<": ("high",), "=": ("low", "high")}[sign[0]]
        if any(getattr(rule, side) is not None for side in sides):
            raise _Wrong(f"expected one lower and one upper limit, found another: '{sign}'")
        line.tokens.pop(0)
        limit = line.take_number("a number")
        if math.isinf(limit):
            raise _Wrong(f"expected a finite number after {sign}, found {limit}")
        rule = replace(rule, **dict.fromkeys(sides, limit))
        if sign in "<>":
            rule = replace(
                rule, closed=(rule.closed[0] and sign == "<", rule.closed[1] and sign == ">")
            )
    return rule


def _parse_value(line: _Line) -> Scope:
    array = line.take("the name of a cell array")
    if line.peek() not in (("sign", "="), ("sign", "==")):
        raise line.wrong(f"= after {array}")
    line.tokens.pop(0)
    word = line.peek()[1]
    value = line.take_number("an integer")
    if 2**53 <= abs(value) < 2**65:
        value = Fraction(word.lower().replace("d", "e"))  # with all digits
    if not -(2**63) <= value < 2**64 or value != int(value):
        raise _Wrong(f"expected a 64-bit integer, found '{word}'")
    return Scope("array", int(value), array)


def _parse_tolerance(line: _Line) -> Tolerance:
    expected = "a percentage such as 0.1%, or a number of cells"
    word = line.take(expected, ("word",))
    percent = word.endswith("%") or line.take_if("%")
    if not percent and not line.take_if("cells"):
        line.take_if("cell")
    number = word.rstrip("%")
    if not re.fullmatch(r"\+?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?", number):
        raise _Wrong(f"expected {expected}, found '{word}'")
    share = Fraction(number)
    if percent and share <= 100:
        return Tolerance(percent=share)
    if percent:
        raise _Wrong(f"expected a percentage of at most 100%, found '{word}'")
    if share.denominator != 1:
        raise _Wrong(f"expected {expected}, found '{word}'; did you mean {word}%?")
    return Tolerance(count=int(share))


def _parse_null(line: _Line) -> bool:
    words = {"fails": True, "passes": False}
    if line.peek()[1] not in words:
        raise line.wrong("fails or passes after null", words)
    return words[line.take("a word")]


def tolerance(words: str) -> Tolerance:
    """Parses the tolerance of a command line; ValueError describes what was expected.

    >>> tolerance("0.1%").percent, tolerance("5").count
    (Fraction(1, 10), 5)
    """
    try:
        line = _Line(words)
        parsed = _parse_tolerance(line)
        if line.peek()[0] != "end":
            raise line.wrong("end of text")
        return parsed
    except _Wrong as wrong:
        raise ValueError(f"--tolerate: {wrong}") from None
