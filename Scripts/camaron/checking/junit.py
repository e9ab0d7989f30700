# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the verdicts of `camaron check` as JUnit XML, which CI servers display.

The file follows the schema of Apache Ant's JUnit task, which other programs extend: one suite per
mesh and one case per rule.
"""

from __future__ import annotations

import os
import platform
from datetime import datetime
from pathlib import Path
from typing import Any, Sequence
from xml.etree import ElementTree as xml

from ..common import markup
from ..common.files import Staging
from ..common.inputs import Inputs
from . import verdict_table


def write(
    path: os.PathLike | str,
    results: Sequence[dict[str, Any]],
    started: datetime,
    inputs: Inputs,
) -> None:
    """Writes the file completely or not at all, and replaces no input; `started` is the time when
    the checks began."""
    path = Path(path)
    suites = xml.Element("testsuites")
    for number, result in enumerate(results):
        suites.append(_suite(result, number, started))
    xml.indent(suites)
    with Staging(path.parent, inputs) as staging:
        xml.ElementTree(suites).write(
            staging.path / path.name, encoding="utf-8", xml_declaration=True
        )
        staging.publish()


def _suite(result: dict[str, Any], number: int, started: datetime) -> xml.Element:
    checks = result["checks"]
    count = lambda verdict: str(sum(entry["verdict"] == verdict for entry in checks))
    broken = result["verdict"] == "error"
    suite = _element(
        "testsuite",
        name=result["mesh"],
        package="camaron.check",
        id=number,
        tests=max(len(checks), 1) if broken else len(checks),
        failures=count("fail"),
        errors=int(broken),
        skipped=count("empty"),
        time=result["seconds"],
        timestamp=started.replace(tzinfo=None).isoformat(timespec="seconds"),
        hostname=platform.node() or "localhost",
    )
    suite.append(xml.Element("properties"))
    if broken:
        case = _case("mesh", result)
        case.append(_element("error", message=result["error"], type="error"))
        suite.append(case)
    for entry in checks:
        suite.append(_check(entry, result))
    out = _element("system-out")
    out.text = markup.fit("" if broken else verdict_table.describe(result))
    suite.append(out)
    err = _element("system-err")
    err.text = markup.fit(result.get("error", ""))
    suite.append(err)
    return suite


def _check(entry: dict[str, Any], result: dict[str, Any]) -> xml.Element:
    case = _case(entry["rule"], result)
    if entry["verdict"] == "fail":
        words = verdict_table.sentence(entry)
        worst = "; ".join(_place(cell, verdict_table.noun(entry)) for cell in entry["worst"])
        failure = _element("failure", message=f"{words}: {worst}", type="outside")
        failure.text = markup.fit("\n".join([words, *verdict_table.offenders(entry)]))
        case.append(failure)
    elif entry["verdict"] == "empty":
        case.append(_element("skipped", message="There are no cells to check."))
    return case


def _place(cell: dict[str, Any], noun: str) -> str:
    value = "undefined" if cell["value"] is None else f"{cell['value']:.6g}"
    block = f" of {cell['block']}" if cell["block"] else ""
    return f"{noun} {cell['id']}{block} {value}"


def _case(name: str, result: dict[str, Any]) -> xml.Element:
    """A test case; only the suite has a time, because all rules are checked together."""
    # Build servers take what is before the last dot for a package.
    classname = result["mesh"].replace(".", "_")
    return _element("testcase", name=name, classname=classname, time=0)


def _element(tag: str, **attributes: Any) -> xml.Element:
    return xml.Element(tag, {name: markup.fit(str(value)) for name, value in attributes.items()})
