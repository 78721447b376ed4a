# SPDX-License-Identifier: MIT
"""Time tags of the wire: int nanoseconds of the GPS scale since 1980-01-06T00:00:00. Texts without a suffix are GPS time, which
has no leap seconds and is ahead of UTC by 18 s since 2017; other scales have a suffix, as on the command line of orrery."""
from __future__ import annotations

import datetime
import re
from typing import Union

EPOCH = datetime.datetime(1980, 1, 6)
NS_PER_S = 10**9
NONE = -2**63  # "no instant"
Time = Union[int, str, datetime.datetime]

# TAI - UTC in seconds from a day (Modified Julian Date) on: IERS Bulletin C, as in core/leap.c; a test compares them.
LEAP_SECONDS = (
    (41317, 10), (41499, 11), (41683, 12), (42048, 13), (42413, 14), (42778, 15), (43144, 16), (43509, 17), (43874, 18), (44239, 19),
    (44786, 20), (45151, 21), (45516, 22), (46247, 23), (47161, 24), (47892, 25), (48257, 26), (48804, 27), (49169, 28), (49534, 29),
    (50083, 30), (50630, 31), (51179, 32), (53736, 33), (54832, 34), (56109, 35), (57204, 36), (57754, 37))
_EPOCH_MJD, _EPOCH_ORDINAL, _DAY, _WEEK = 44244, EPOCH.toordinal(), 86400, 604800
_TAI_GPS_S = 19
# What is added to a label of the scale to get GPS time [ns]; None: by the table of leap seconds.
_SCALES = {"": 0, "GPS": 0, "GPST": 0, "GAL": 0, "GST": 0, "QZS": 0, "QZSS": 0, "IRN": 0, "BDT": 14 * NS_PER_S, "BDS": 14 * NS_PER_S,
           "TAI": -_TAI_GPS_S * NS_PER_S, "TT": -51_184_000_000, "UTC": None, "GLO": None, "Z": None}
_FRACTION = r"(?:[.,](\d{1,9}))?"
_WEEK_TEXT = re.compile(rf"(\d{{1,5}}):(\d{{1,6}}){_FRACTION}", re.ASCII)
_TEXT = re.compile(r"(\d{4})-(?:(\d{3})(?![\d-])|(\d{1,2})-(\d{1,2}))(?:[Tt ](?:(\d\d)(?![\d:])|(\d{1,2}):(\d\d)(?::(\d\d)"
                   + _FRACTION + r")?))? *([A-Za-z]*)", re.ASCII)


def from_datetime(when: datetime.datetime) -> int:
    """Of a datetime without time zone, which holds GPS time, or of one with a time zone, which is civil time (UTC and an offset)."""
    if when.tzinfo is not None:
        return _from_utc(when.astimezone(datetime.timezone.utc).replace(tzinfo=None))
    delta = when - EPOCH
    return (delta.days * _DAY + delta.seconds) * NS_PER_S + delta.microseconds * 1000


def to_datetime(t: int) -> datetime.datetime:
    """GPS time without time zone, rounded down to microseconds."""
    return EPOCH + datetime.timedelta(microseconds=t // 1000)


def to_utc(t: int) -> datetime.datetime:
    """UTC, rounded down to microseconds. A leap second, which a datetime cannot hold, is given as the second before it."""
    day, second, ns = _utc(t)
    return datetime.datetime.combine(datetime.date.fromordinal(_EPOCH_ORDINAL + day - _EPOCH_MJD), datetime.time(),
                                     datetime.timezone.utc) + datetime.timedelta(seconds=min(second, _DAY - 1), microseconds=ns // 1000)


def from_text(text: str) -> int:
    """Of what the program's command line accepts: "2024-02-04", "2024-02-04T12:00", "2024-02-04T12:00:00.123456789", "2024-035T12:00",
    with an optional scale behind it (Z or UTC, GPS, TAI, TT, GLO, GAL, BDT, QZS, IRN); "2300:900.5", GPS week and seconds. Without a
    scale it is GPS time."""
    match = _WEEK_TEXT.fullmatch(text.strip())
    if match is not None:
        week, second = int(match.group(1)), int(match.group(2))
        if second >= _WEEK:
            raise ValueError(f"'{text}' is no time: a week has {_WEEK} seconds, counted from 0")
        if week > 14091:
            raise ValueError(f"'{text}' is no time: the years 1900 to 2250 are understood")
        return (week * _WEEK + second) * NS_PER_S + _nanoseconds(match.group(3))
    match = _TEXT.fullmatch(text.strip())
    if match is None or match.group(10).upper() not in _SCALES:
        raise ValueError(f"'{text}' is no time: use 2024-02-04T00:15:00 (GPS time; with Z or UTC, TAI, TT, GLO, GAL, BDT for another "
                         "scale), 2024-035T00:15 or week:seconds as in 2300:900")
    year, of_year, month, day, hour_alone, hour, minute, second = (int(g or 0) for g in match.groups()[:8])
    if not 1900 <= year <= 2250:
        raise ValueError(f"'{text}' is no time: the years 1900 to 2250 are understood")
    hour = hour_alone or hour
    try:
        ordinal = datetime.date(year, 1, 1).toordinal() + of_year - 1 if match.group(2) else datetime.date(year, month, day).toordinal()
    except ValueError:
        raise ValueError(f"'{text}' is no time: there is no such date") from None
    if match.group(2) and datetime.date.fromordinal(max(1, ordinal)).year != year:
        raise ValueError(f"'{text}' is no time: the year has no such day")
    mjd, ns = ordinal - _EPOCH_ORDINAL + _EPOCH_MJD, _nanoseconds(match.group(9))
    offset = _SCALES[match.group(10).upper()]
    if offset is None and mjd < LEAP_SECONDS[0][0]:
        raise ValueError(f"'{text}' is no time: UTC and GLO have whole leap seconds since 1972-01-01 only; use GPS or TAI")
    length = _DAY + (_tai_utc(mjd + 1) - _tai_utc(mjd) if offset is None else 0)
    of_day = hour * 3600 + minute * 60 + second
    if hour == 24 and (minute, second, ns) == (0, 0, 0):
        mjd, of_day = mjd + 1, 0
    elif hour > 23 or minute > 59 or second > 60 or of_day >= length or (second == 60 and (hour, minute) != (23, 59)):
        raise ValueError(f"'{text}' is no time: there is no such time of day")
    if offset is None:
        offset = (_tai_utc(mjd) - _TAI_GPS_S) * NS_PER_S
    return ((mjd - _EPOCH_MJD) * _DAY + of_day) * NS_PER_S + ns + offset


def to_text(t: int, scale: str = "GPS") -> str:
    """ISO 8601 with as many decimals as are needed; "-" for no instant. scale: GPS, which has no suffix, or UTC, which has Z."""
    if t == NONE:
        return "-"
    if scale not in ("GPS", "UTC"):
        raise ValueError(f"'{scale}' is no scale that times are written in: GPS or UTC")
    if scale == "UTC":
        day, second, ns = _utc(t)
    else:
        whole, ns = divmod(t, NS_PER_S)
        day, second = divmod(whole, _DAY)
        day += _EPOCH_MJD
    date = datetime.date.fromordinal(_EPOCH_ORDINAL + day - _EPOCH_MJD).isoformat()
    extra = max(0, second - (_DAY - 1))  # 23:59:60
    second -= extra
    clock = f"{second // 3600:02d}:{second // 60 % 60:02d}:{second % 60 + extra:02d}"
    return f"{date}T{clock}" + (f".{ns:09d}".rstrip("0") if ns else "") + ("Z" if scale == "UTC" else "")


def time_tag(when: Time) -> int:
    """The time tag of a tag, a text or a datetime."""
    if isinstance(when, str):
        return from_text(when)
    return from_datetime(when) if isinstance(when, datetime.datetime) else when


def _nanoseconds(digits: Union[str, None]) -> int:
    return int((digits or "0").ljust(9, "0"))


def _tai_utc(mjd: int) -> int:
    """TAI - UTC of a day; before 1972 the first entry holds."""
    return next((s for first, s in reversed(LEAP_SECONDS) if mjd >= first), LEAP_SECONDS[0][1])


def _from_utc(when: datetime.datetime) -> int:
    mjd = when.toordinal() - _EPOCH_ORDINAL + _EPOCH_MJD
    if mjd < LEAP_SECONDS[0][0]:
        raise ValueError("UTC has whole leap seconds since 1972-01-01 only")
    return from_datetime(when) + (_tai_utc(mjd) - _TAI_GPS_S) * NS_PER_S


def _utc(t: int) -> tuple[int, int, int]:
    """Day (MJD), second of the day (86400 in a leap second) and nanoseconds."""
    whole, ns = divmod(t, NS_PER_S)
    tai = whole + _EPOCH_MJD * _DAY + _TAI_GPS_S
    for k in range(len(LEAP_SECONDS) - 1, -1, -1):
        first, offset = LEAP_SECONDS[k]
        if tai >= first * _DAY + offset or k == 0:
            day, second = divmod(tai - offset, _DAY)
            if k + 1 < len(LEAP_SECONDS) and day == LEAP_SECONDS[k + 1][0]:
                day, second = day - 1, second + _DAY
            return day, second, ns
    raise AssertionError("the table of leap seconds is empty")
