#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The firmware library leans on nothing but five routines of string.h: no allocation, no stdio, no errno, no writable data."""
import subprocess
import sys

ALLOWED = {"memcpy", "memmove", "memset", "memcmp", "strlen", "_GLOBAL_OFFSET_TABLE_"}


def main():
    library, nm = sys.argv[1:3]
    lines = subprocess.run([nm, "-P", library], check=True, capture_output=True, text=True).stdout.splitlines()
    symbols = [line.split()[:2] for line in lines if len(line.split()) >= 2]
    defined = {name for name, kind in symbols if kind not in "Uw"}
    needed = {name for name, kind in symbols if kind in "Uw"} - defined
    writable = {name for name, kind in symbols if kind in "BbDdCc"}
    if "orr_client_poll" not in defined or "orr_msg_states_decode" not in defined:
        print(f"{library} is not what it should be", file=sys.stderr)
        return 1
    for name in sorted(needed - ALLOWED):
        print(f"the firmware client needs {name}", file=sys.stderr)
    for name in sorted(writable):
        print(f"the firmware client holds writable data: {name}", file=sys.stderr)
    return 1 if needed - ALLOWED or writable else 0


if __name__ == "__main__":
    sys.exit(main())
