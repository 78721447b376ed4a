#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles the firmware client (proto/gen/firmware) for Cortex-M and tells how much code and stack it takes.

    measure.py                   prints the table of docs/protocol.md
    measure.py --limit CODE STACK   exit 1 if the whole client has more bytes of code, or one of its functions, with all
                                    that it calls, more bytes of stack

The stack of the caller's own read and write, and of libc's memcpy and its like, comes on top. Needs arm-none-eabi-gcc (Debian gcc-arm-none-eabi,
libnewlib-arm-none-eabi)."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

CLIENT = pathlib.Path(__file__).resolve().parents[1] / "gen/firmware"
CPUS = ("cortex-m0plus", "cortex-m4", "cortex-m7")
FLAGS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror", "-Os", "-mthumb", "-ffunction-sections",
         "-fdata-sections", "-DORR_CRC32_SMALL"]
# A client that asks for states alone: what the linker keeps of the whole.
STATES = r"""
#include "orrery_client.h"
orr_client c;
uint8_t buffer[9400];
ptrdiff_t take(void *user, uint8_t *data, size_t n);
ptrdiff_t give(void *user, const uint8_t *data, size_t n);
void use(const orr_msg_sat_state *s);
void start(void);
ptrdiff_t take(void *user, uint8_t *data, size_t n) { (void)user; (void)data; return (ptrdiff_t)n; }
ptrdiff_t give(void *user, const uint8_t *data, size_t n) { (void)user; (void)data; return (ptrdiff_t)n; }
__attribute__((noinline)) void use(const orr_msg_sat_state *s) { __asm volatile("" : : "r"(s) : "memory"); }
void start(void)
{
    orr_client_init(&c, (orr_client_io){NULL, take, give}, buffer, sizeof buffer);
    orr_msg_poll poll = {.epochs = {0, 0, 1}};
    orr_msg_states m;
    orr_msg_sat_state s;
    if (orr_client_poll(&c, &poll) != ORR_WIRE_OK || orr_client_states(&c, &m) != ORR_WIRE_OK) return;
    for (orr_wire_iter it = {0, 0}; orr_msg_sat_state_next(&m.satellites, &it, &s);) use(&s);
}
"""


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(c) for c in command)}\n{done.stderr}")
    return done.stdout


def code_size(path):
    """Bytes of code and constants. There is no writable data: that is said where it is not so."""
    text, data, bss = map(int, run("arm-none-eabi-size", path).splitlines()[1].split()[:3])
    return text + data, data + bss


def stacks(callgraph):
    """Stack of each function with all that it calls, from the compiler's own account (-fcallgraph-info=su)."""
    own, calls = {}, {}
    for title, label in re.findall(r'node: \{ title: "([^"]*)" label: "([^"]*)"', callgraph):
        found = re.search(r"(\d+) bytes \((\w[\w, ]*)\)", label)
        own[title] = int(found.group(1)) if found else 0
        if found and found.group(2) != "static":
            sys.exit(f"{title}: stack that depends on the data")
    for source, target in re.findall(r'edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', callgraph):
        calls.setdefault(source, set()).add(target)
    known = {}

    def depth(name, above=()):
        if name in above:
            sys.exit(f"{name} calls itself")
        if name not in known:
            known[name] = own.get(name, 0) + max((depth(c, (*above, name)) for c in calls.get(name, ())), default=0)
        return known[name]
    return {name.split(":")[-1]: depth(name) for name in own}


def measure(cpu, folder):
    client = folder / f"{cpu}.o"
    run("arm-none-eabi-gcc", f"-mcpu={cpu}", *FLAGS, "-fcallgraph-info=su", "-c", CLIENT / "orrery_client.c", "-o", client)
    code, writable = code_size(client)
    if writable != 0:
        sys.exit(f"{cpu}: {writable} bytes of writable data")
    (folder / "states.c").write_text(STATES, encoding="utf-8")
    whole = folder / f"{cpu}.elf"
    run("arm-none-eabi-gcc", f"-mcpu={cpu}", *FLAGS, "-I", CLIENT, folder / "states.c", client, "-nostartfiles", "-Wl,--gc-sections",
        "-Wl,-e,start", "-o", whole)
    depths = stacks((folder / f"{cpu}.ci").read_text(encoding="utf-8"))
    return code, code_size(whole)[0], depths


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", nargs=2, type=int, metavar=("CODE", "STACK"))
    args = parser.parse_args()
    over = False
    print(run("arm-none-eabi-gcc", "--version").splitlines()[0] + "\n")
    print("| processor | whole client, bytes of code | POLL alone, linked | stack: `orr_client_poll` | `orr_client_states` | deepest |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for cpu in CPUS:
            code, states, depth = measure(cpu, pathlib.Path(folder))
            worst = max(depth, key=depth.get)
            print(f"| {cpu} | {code} | {states} | {depth['orr_client_poll']} | {depth['orr_client_states']} | {depth[worst]} (`{worst}`) |")
            over = over or (args.limit is not None and (code > args.limit[0] or depth[worst] > args.limit[1]))
    if over:
        print(f"more than {args.limit[0]} bytes of code or {args.limit[1]} of stack", file=sys.stderr)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
