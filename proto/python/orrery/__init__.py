# SPDX-License-Identifier: MIT
"""Client of the Orrery service: satellite states by time tag over TCP or a Unix socket. Python 3 standard library only.

    import orrery

    with orrery.Client("tcp://127.0.0.1:15754") as client:
        print(client.caps.title, client.satellites)
        for states in client.poll("2024-02-04T12:00:00Z", step_s=0.1, count=10, satellites=["G05", "E11"]):
            for s in states.satellites:
                print(orrery.to_text(states.t), s.sat, s.pos_m if s.answer == orrery.Answer.OK else s.answer.name)

orrery.ReconnectingClient has the same methods and outlives its connection.
"""
from ._version import __version__
from .client import Client, ProtocolError, Refused
from .codec import CodecError
from .gpstime import from_datetime, from_text, time_tag, to_datetime, to_text, to_utc
from .messages import (Answer, DelayFlags, ElementsFrame, ElementsMethod, ErrorCode, NavForm, NavMessage, NavMessages,
                       NavNotes, OrbitPoint, ReceiverSource, SatId, StateFlags, TecOrigin)
from .reconnect import ReconnectingClient
from .satellite import sat_id, sat_name
from .stream import Stream

__all__ = ["Answer", "Client", "CodecError", "DelayFlags", "ElementsFrame", "ElementsMethod", "ErrorCode", "NavForm", "NavMessage",
           "NavMessages", "NavNotes", "OrbitPoint", "ProtocolError", "ReceiverSource", "ReconnectingClient", "Refused", "SatId", "StateFlags", "Stream", "TecOrigin",
           "__version__", "from_datetime", "from_text", "sat_id", "sat_name", "time_tag", "to_datetime", "to_text", "to_utc"]
