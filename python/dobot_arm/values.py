"""Values of Python as JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping


def json_object(values: Mapping[str, object]) -> str:
    """Returns a JSON object; numbers and arrays of numpy are allowed.

    Raises :class:`ValueError` with the place of a number that is not finite, :class:`TypeError` for other objects.
    """
    try:
        return json.dumps(values, allow_nan=False, default=_plain)
    except ValueError:
        raise ValueError(_infinite("", values) or "a value contains itself") from None


def _plain(value: object) -> object:
    """Returns a number or an array of numpy as a number or lists."""
    tolist = getattr(value, "tolist", None)
    if tolist is not None:
        return tolist()
    raise TypeError(f"{value!r} is a {type(value).__name__}; allowed are numbers, texts, True, False, lists and dictionaries")


def _infinite(place: str, value: object) -> str | None:
    """Returns the error for a number that is not finite: its place, such as ``steps[2].go.z``."""
    if isinstance(value, float) and not math.isfinite(value):
        return f"{place} is {value}; allowed is a finite number"
    if isinstance(value, Mapping):
        parts = ((f"{place}.{key}" if place else str(key), part) for key, part in value.items())
    elif isinstance(value, (list, tuple)):
        parts = ((f"{place}[{at}]", part) for at, part in enumerate(value))
    else:
        return _infinite(place, _plain(value)) if hasattr(value, "tolist") else None
    return next(filter(None, (_infinite(*part) for part in parts)), None)
