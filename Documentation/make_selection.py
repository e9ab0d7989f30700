# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the strategies of Select Elements into their page and into the text of the property in ParaView:

./camaron shell pvpython Documentation/make_selection.py
"""

import re
import textwrap
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from camaron.common import pipeline
from paraview import simple

PAGE = Path(__file__).with_name("selection.md")
FILTERS = PAGE.parents[1] / "Filters"
DEFINITION = FILTERS / "Select" / "SelectElements.xml"

BEGIN = "<!-- Made by Documentation/make_selection.py of Filters/Select/Strategies/StrategyTable.cxx -->\n"
END = "<!-- end of the strategies -->\n"


def strategies():
    """What the strategies select, by name, in the order of the table."""
    proxy = simple.SelectElements(Input=simple.Sphere())
    return dict(zip(*map(proxy.GetProperty, ("StrategyNames", "SelectedByStrategies"))))


def belongs_to(hint, strategy):
    """Whether a property with this hint is shown for a strategy; None if that depends on other properties."""
    if hint.tag == "Expression":
        known = {belongs_to(child, strategy) for child in hint} - {None}
        return (any if hint.get("type") == "or" else all)(known) if known else None
    if hint.get("type") == "CompositeDecorator":
        return belongs_to(hint[0], strategy)
    return hint.get("value") == strategy if hint.get("property") == "Strategy" else None


def properties(definition, strategy):
    """Names and choices of the properties that this strategy has, but not all strategies."""
    for item in definition.iter():
        hints = item.findall("Hints/PropertyWidgetDecorator") if item.get("command") else ()
        if True in {belongs_to(hint, strategy) for hint in hints}:
            yield item.get("name"), [choice.get("value") for choice in item.iter("String")]


def updated_page(page):
    """The page with the current table."""
    shared = (FILTERS / "Common" / "SharedProperties.ent").read_text("utf-8")
    text = DEFINITION.read_text("utf-8").replace("@SharedProperties@", shared)
    definition = ElementTree.fromstring(text)
    lines = ["| strategy | selects | properties |", "| --- | --- | --- |"]
    listed = set()
    for strategy, selected in strategies().items():
        texts = []
        for name, choices in properties(definition, strategy):
            is_new = choices and name not in listed
            texts.append(f"`{name}`" + (f": `{'`, `'.join(choices)}`" if is_new else ""))
            listed.add(name)
        lines.append(f"| `{strategy}` | {selected} | {'; '.join(texts)} |")
    before, rest = page.split(BEGIN)
    return before + BEGIN + "\n".join(lines) + "\n" + END + rest.split(END)[1]


def updated_definition(text):
    """The definition with the current text of the property Strategy."""
    sentences = " ".join(f"{name}: {selected}." for name, selected in strategies().items())
    lines = textwrap.wrap("How elements are found. Default: By criterion. " + sentences, 90)
    made = "".join(f"          {line}\n" for line in lines)
    return re.sub(r"( *How elements are found.*?)(?= *</Documentation>)", made, text, flags=re.S)


if __name__ == "__main__":
    pipeline.load_plugin()
    DEFINITION.write_text(updated_definition(DEFINITION.read_text("utf-8")), encoding="utf-8")
    PAGE.write_text(updated_page(PAGE.read_text("utf-8")), encoding="utf-8")
