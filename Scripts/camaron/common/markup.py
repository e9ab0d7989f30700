# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""HTML templates that escape every value, so no name from a file becomes an element."""

from __future__ import annotations

import re
import string
from html import escape
from typing import Any

#: Characters that HTML or XML cannot contain, not even escaped, and those that terminals interpret.
_UNFIT = re.compile("[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


class Markup(str):
    """HTML text. Only `html` creates it, from templates in the code; all other text is escaped."""


def html(template: str, *values: Any, **named: Any) -> Markup:
    r"""Fills the template as `str.format` does, and escapes every value that is not Markup.

    The parts of a list or an iterator are joined; None becomes an empty text. Values are made to `fit`.

    >>> html('<td class="{}">{:.1f}</td>', 'a"b', 2)
    '<td class="a&quot;b">2.0</td>'
    >>> html("<p>{}</p>", [html("<b>{}</b>", "<i>"), " & ", None])
    '<p><b>&lt;i&gt;</b> &amp; </p>'
    >>> html("{}", "a\x1b[1m<")
    'a?[1m&lt;'
    """
    return Markup(_FORMATTER.vformat(template, values, named))


def raw(path: Any) -> Markup:
    """The text of a style sheet or script of this package."""
    return Markup(path.read_text(encoding="utf-8"))


class _Formatter(string.Formatter):
    def format_field(self, value: Any, format_spec: str) -> str:
        return _to_markup(format(value, format_spec) if format_spec else value)

    def convert_field(self, value: Any, conversion: Any) -> Any:
        return repr(value) if conversion == "r" else super().convert_field(value, conversion)


_FORMATTER = _Formatter()


def fit(words: str) -> str:
    r"""The text with a question mark for each character that HTML or XML should not contain.

    >>> fit("a\x1b[1m\n")
    'a?[1m\n'
    """
    return _UNFIT.sub("?", words)


def _to_markup(value: Any) -> str:
    if isinstance(value, Markup):
        return value
    if value is None:
        return ""
    if hasattr(value, "__iter__") and not isinstance(value, str):
        return "".join(map(_to_markup, value))
    return escape(fit(str(value)), quote=True)
