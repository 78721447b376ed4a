# SPDX-License-Identifier: MIT
"""Time tags of the wire: int nanoseconds of the GPS scale since 1980-01-06T00:00:00. No leap seconds anywhere: labels are GPS
time, which is ahead of UTC by 18 s since 2017."""
import datetime
import re

EPOCH = datetime.datetime(1980, 1, 6)
NS_PER_S = 10**9
NONE = -2**63  # "no instant"
_TEXT = re.compile(r"^(\d{4})-(\d\d)-(\d\d)(?:[T ](\d\d):(\d\d)(?::(\d\d)(?:\.(\d{1,9}))?)?)?$")


def from_datetime(when):
    """Of a datetime without time zone that holds GPS time."""
    if when.tzinfo is not None:
        raise ValueError("a datetime of GPS time has no time zone")
    delta = when - EPOCH
    return (delta.days * 86400 + delta.seconds) * NS_PER_S + delta.microseconds * 1000


def to_datetime(t):
    """Rounded down to microseconds."""
    return EPOCH + datetime.timedelta(microseconds=t // 1000)


def from_text(text):
    """Of "2024-02-04", "2024-02-04T12:00" or "2024-02-04T12:00:00.123456789", GPS time."""
    match = _TEXT.match(text.strip())
    if not match:
        raise ValueError(f"'{text}' is no time: 2024-02-04T12:00:00.5 (GPS time) is wanted")
    year, month, day, hour, minute, second = (int(g or 0) for g in match.groups()[:6])
    whole = datetime.datetime(year, month, day, hour, minute, second)
    return from_datetime(whole) + int((match.group(7) or "0").ljust(9, "0"))


def to_text(t):
    """ISO 8601 with as many decimals as are needed, GPS time; "-" for no instant."""
    if t == NONE:
        return "-"
    second, ns = divmod(t, NS_PER_S)
    text = (EPOCH + datetime.timedelta(seconds=second)).isoformat()
    return text + (f".{ns:09d}".rstrip("0") if ns else "")
