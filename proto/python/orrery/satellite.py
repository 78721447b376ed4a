# SPDX-License-Identifier: MIT
"""Satellites as people and IGS files name them."""
from __future__ import annotations

import re
from typing import Union

from . import messages

Satellite = Union[str, messages.SatId]
_NAME = re.compile(r"([A-Za-z])(\d{1,2})$")


def sat_id(sat: Satellite) -> messages.SatId:
    """The wire's satellite of "G05" (which may be one already)."""
    if isinstance(sat, messages.SatId):
        return sat
    match = _NAME.match(sat.strip())
    if match is None or int(match.group(2)) == 0:
        raise ValueError(f"'{sat}' is no satellite: G05 is wanted")
    return messages.SatId(ord(match.group(1).upper()), int(match.group(2)))


def sat_name(sat: messages.SatId) -> str:
    """"G05" of the wire's satellite."""
    return str(sat)
