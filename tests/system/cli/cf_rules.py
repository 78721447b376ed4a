#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of the CF conventions that a file's structure can show, each by its section (CF-1.9), run on NetCDF files by a Python that
has netCDF4 and xarray. Prints one line a breach; with --plant a breach of each rule is made in a copy first, which has to be found."""
import re
import shutil
import subprocess
import sys

import netCDF4
import numpy
import xarray

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
WORD = re.compile(r"[A-Za-z0-9_.+@-]+\Z")
SINCE = re.compile(r"(days|hours|minutes|seconds|nanoseconds) since \d{4}-\d\d?-\d\d? \d\d?:\d\d?:\d\d?(\.\d+)?\Z")
CALENDARS = ("standard", "gregorian", "proleptic_gregorian", "noleap", "365_day", "360_day", "julian", "all_leap", "366_day", "none")
known = {}


def unit_is_known(text):
    """By UDUNITS' own program, which CF names (section 3.1). Its scanner takes the "nan" of "nanoseconds", which its database has, for a number."""
    if text not in known:
        text = text.replace("nanosecond", "microsecond")
        known[text] = subprocess.run(["udunits2", "-H", text, "-W", text], input="", capture_output=True, text=True, check=False).returncode == 0
    return known[text]


def breaches(path):
    with netCDF4.Dataset(path) as d:
        d.set_auto_mask(False)
        if not re.search(r"\bCF-1\.\d+\b", str(getattr(d, "Conventions", ""))):
            yield "2.6.1: no Conventions"
        for name in list(d.variables) + list(d.dimensions) + d.ncattrs():
            if not NAME.match(name):
                yield f"2.3: {name} is no name"
        folded = [n.lower() for n in d.variables]
        if len(set(folded)) != len(folded):
            yield "2.3: names differ by case alone"
        for name, v in d.variables.items():
            yield from (f"{name}: {b}" for b in of_variable(d, name, v))
    with xarray.open_dataset(path) as x:
        x.load()  # it has to be read as others read it


def of_variable(d, name, v):
    unsigned_or_long = v.dtype.kind == "u" or v.dtype == numpy.int64
    version = re.search(r"CF-1\.(\d+)", getattr(d, "Conventions", ""))
    if unsigned_or_long and version is not None and int(version.group(1)) < 9:
        yield "2.2: a type that came with CF-1.9"
    if len(set(v.dimensions)) != len(v.dimensions):
        yield "2.4: a dimension twice"
    fill = getattr(v, "_FillValue", None)
    if fill is not None and numpy.asarray(fill).dtype != v.dtype:
        yield "2.5.1: _FillValue of another type"
    units = getattr(v, "units", None)
    if units is not None and v.dtype.kind == "S":
        yield "3.1: units of a text"
    if units is not None and " since " in units:
        if not SINCE.match(units):
            yield f"4.4: {units}"
        if getattr(v, "calendar", "standard") not in CALENDARS:
            yield "4.4.1: the calendar"
    elif units is not None and not unit_is_known(units):
        yield f"3.1: UDUNITS does not know {units}"
    if getattr(v, "standard_name", "time") != "time":
        yield "3.3: a standard name that this test does not know"
    meanings, masks, values = (getattr(v, a, None) for a in ("flag_meanings", "flag_masks", "flag_values"))
    if meanings is not None:
        words = meanings.split()
        if masks is None and values is None:
            yield "3.5: meanings without values"
        for what in (masks, values):
            if what is None:
                continue
            if numpy.asarray(what).dtype != v.dtype:
                yield "3.5: flags of another type than the variable"
            if numpy.size(what) != len(words):
                yield "3.5: as many flags as meanings"
        if not all(WORD.match(w) for w in words):
            yield "3.5: a word with other letters"
        if masks is not None and numpy.any(numpy.asarray(masks) == 0):
            yield "3.5: a mask of nothing"
    if v.dimensions == (name,):  # a coordinate variable
        x = v[:]
        if x.dtype.kind != "S" and len(x) > 1:
            step = numpy.diff(x.astype("f8"))
            if not (numpy.all(step > 0) or numpy.all(step < 0)):
                yield "5: a coordinate that does not ascend"
    for attribute in ("coordinates", "ancillary_variables", "bounds"):
        for other in str(getattr(v, attribute, "")).split():
            if other not in d.variables:
                yield f"5: {attribute} names {other}, which is not there"
    sample = getattr(v, "sample_dimension", None)
    if sample is not None:  # 9.3.3: a contiguous ragged array's counts add up to it
        if sample not in d.dimensions:
            yield f"9.3.3: sample_dimension names {sample}, which is not there"
        elif int(numpy.sum(v[:].astype("i8"))) != len(d.dimensions[sample]):
            yield f"9.3.3: counts do not add up to {sample}"
    if getattr(v, "long_name", getattr(v, "standard_name", None)) is None and name in PLAIN:
        yield "3.2: neither long_name nor standard_name"


PLAIN = ("position", "velocity", "clock", "sigma")


def plant(path, rule):
    with netCDF4.Dataset(path, "a") as d:
        if rule == "2.6.1":
            d.Conventions = "none"
        elif rule == "2.2":
            d.Conventions = "CF-1.8"
        elif rule == "2.3":
            d.setncattr("no name", 1)
        elif rule == "3.1":
            d.variables["position_coefficient"].units = "TECU"
        elif rule == "4.4":
            d.variables["clock_time"].units = "nanoseconds since the begin"
        elif rule == "3.5":
            d.variables["sample_flags"].setncattr("flag_masks", numpy.array([2, 4, 8, 16, 32, 64, 128], "i8"))
        elif rule == "5":
            d.variables["clock_bias"].coordinates = "nothing"
        elif rule == "9.3.3":
            d.variables["clock_count"].sample_dimension = "satellite"


if __name__ == "__main__":
    if sys.argv[1] == "--plant":
        for wanted in ("2.6.1", "2.2", "2.3", "3.1", "4.4", "3.5", "5", "9.3.3"):
            copy = sys.argv[2] + ".planted.nc"
            shutil.copy(sys.argv[2], copy)
            plant(copy, wanted)
            try:
                found = list(breaches(copy))
            except ValueError as e:  # what xarray cannot make a time of
                found = [f"4.4: {e}"]
            print(wanted, "found" if any(re.search(rf"(^|: ){re.escape(wanted)}[.:]", b) for b in found) else f"missed: {found}")
    else:
        for file in sys.argv[1:]:
            for breach in breaches(file):
                print(f"{file}: {breach}")
