# SPDX-License-Identifier: MIT
"""Client of the Orrery service: satellite states by time tag over TCP or a Unix socket. Python 3 standard library only.

    import orrery

    with orrery.Client("tcp://127.0.0.1:15754") as client:
        print(client.caps.title, [str(s) for s in client.satellites])
        for states in client.poll("2024-02-04T12:00:00", step_s=0.1, count=10, satellites=["G05", "E11"]):
            for s in states.satellites:
                print(states.t, orrery.sat_name(s.sat), s.pos_m if s.answer == orrery.Answer.OK else "no state")
"""
from .client import Client, ProtocolError, Refused, sat_id, sat_name
from .gpstime import from_datetime, from_text, to_datetime, to_text
from .messages import Answer, ElementsFrame, ElementsMethod, ErrorCode, NavMessage, NavNotes, StateFlags

__all__ = ["Answer", "Client", "ElementsFrame", "ElementsMethod", "ErrorCode", "NavMessage", "NavNotes", "ProtocolError",
           "Refused", "StateFlags", "from_datetime", "from_text", "sat_id", "sat_name", "to_datetime", "to_text"]
