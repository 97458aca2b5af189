# SPDX-License-Identifier: MIT
"""jq_text - JSON, numbers and HTML as jq 1.6 writes them.

Results of campaigns are kept for months, and each holds a checksum of its own JSON text. The text
must therefore stay as it was when jq wrote it: numbers are doubles, printed with the fewest digits
that give the same double, and keys stay in the order in which they were set.
"""
from __future__ import annotations

import html as html_module
import json
import re
from typing import Any, Iterable, Iterator, List, Union

Number = Union[int, float]
LARGEST_DOUBLE = 1.7976931348623157e308
EXACT = 15  # an integer of so many digits is a double

ESCAPES = {'"': '\\"', "\\": "\\\\", "\b": "\\b", "\f": "\\f", "\n": "\\n", "\r": "\\r",
           "\t": "\\t"}
ESCAPED = re.compile(r'["\\\x00-\x1f\x7f]')


def integer(text: str) -> Number:
    """The value of an integer literal; a double if it has more digits than a double keeps."""
    return int(text) if len(text) <= EXACT and text != "-0" else float(text)


def no_constant(text: str) -> None:
    """Refuses NaN and Infinity, which Python's reader takes and JSON does not have."""
    raise ValueError(f"{text} is not JSON")


DECODER = json.JSONDecoder(parse_int=integer, parse_constant=no_constant)


def load_all(text: str) -> List[Any]:
    """The JSON values of a text, one after the other. Raises ValueError."""
    values, at = [], 0
    while True:
        while at < len(text) and text[at] in " \t\r\n":
            at += 1
        if at == len(text):
            return values
        value, at = DECODER.raw_decode(text, at)
        values.append(value)


def load(text: str) -> Any:
    """The only JSON value of a text. Raises ValueError."""
    values = load_all(text)
    if len(values) != 1:
        raise ValueError(f"{len(values)} JSON values, not one")
    return values[0]


def number(value: Number) -> str:
    """A double in the form of jq 1.6: 5, 0.1, 1e-05, 1.5e+300."""
    value = float(value)
    if value != value:
        return "null"
    value = max(-LARGEST_DOUBLE, min(LARGEST_DOUBLE, value))
    sign, digits, exponent = re.fullmatch(
        r"(-?)([0-9.]+)(?:e([+-][0-9]+))?", repr(value)).groups()
    whole, _, fraction = digits.partition(".")
    stripped = (whole + fraction).lstrip("0")
    point = len(whole) + int(exponent or 0) - (len(whole + fraction) - len(stripped))
    stripped = stripped.rstrip("0")
    if not stripped:
        return sign + "0"
    # The value is 0.DIGITS * 10^point.
    if point <= -4 or point > len(stripped) + 15:
        mantissa = stripped[0] + ("." + stripped[1:] if len(stripped) > 1 else "")
        return f"{sign}{mantissa}e{point - 1:+03d}"
    if point <= 0:
        return f"{sign}0.{'0' * -point}{stripped}"
    if point >= len(stripped):
        return sign + stripped + "0" * (point - len(stripped))
    return f"{sign}{stripped[:point]}.{stripped[point:]}"


def string(value: str) -> str:
    """A JSON string; characters beyond ASCII stay as they are."""
    return '"' + ESCAPED.sub(lambda m: ESCAPES.get(m[0]) or f"\\u{ord(m[0]):04x}", value) + '"'


def dump(value: Any, indent: int = 0, level: int = 0) -> str:
    """JSON: in one line, or with an indent of so many blanks."""
    if isinstance(value, (dict, list)):
        if not value:
            return "{}" if isinstance(value, dict) else "[]"
        ends = "{}" if isinstance(value, dict) else "[]"
        margin = "\n" + " " * indent * (level + 1) if indent else ""
        last = "\n" + " " * indent * level if indent else ""
        return ends[0] + ",".join(
            margin + item for item in items(value, indent, level + 1)) + last + ends[1]
    if isinstance(value, str):
        return string(value)
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    return number(value)


def items(value: Union[dict, list], indent: int, level: int) -> Iterator[str]:
    """The JSON of what an object or a list holds."""
    if isinstance(value, list):
        for item in value:
            yield dump(item, indent, level)
        return
    gap = ": " if indent else ":"
    for key, item in value.items():
        yield string(key) + gap + dump(item, indent, level)


def text(value: Any) -> str:
    """A string as it is, any other value as JSON."""
    return value if isinstance(value, str) else dump(value)


def grouped(value: Any) -> str:
    """The value as text; a natural number with commas between thousands: 12,000."""
    said = text(value)
    return f"{int(said):,}" if not isinstance(value, str) and said.isdigit() else said


def html(value: str) -> str:
    """The text with the characters escaped that HTML gives a meaning."""
    return html_module.escape(value).replace("&#x27;", "&apos;")


def rounded(value: Number) -> int:
    """The nearest integer; a half goes away from zero, as C's round() does."""
    whole = int(value)
    if abs(value - whole) >= 0.5:
        whole += 1 if value > 0 else -1
    return whole


def add(values: Iterable[Number]) -> Number:
    """The sum in the order given. Python's sum() rounds otherwise from version 3.12 on."""
    total: Number = 0
    for value in values:
        total += value
    return total
