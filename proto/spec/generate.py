#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes everything that follows from proto/spec/messages.yaml: the C codec and the client's verbs, the client as one
header and one source for firmware, the Python codec, the Wireshark dissector, the tables
of docs/protocol.md and the example frames of the tests.

    generate.py                       writes what has changed
    generate.py --check               writes nothing; exit 1 and the names of stale files if any differ
    generate.py --spec S --out DIR    only the C codec and the Python module of another specification, into DIR
                --client              and firmware's client of it, where it has HELLO and CAPS

Needs Python 3 and PyYAML."""
import argparse
import importlib.util
import pathlib
import re
import sys

import gen_c
import gen_client
import gen_docs
import gen_fields
import gen_handlers
import gen_lua
import gen_python
from model import Spec, SpecError

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = "proto/spec/messages.yaml"


def load_package(messages_text):
    """The Python client's codec with freshly generated messages: the second implementation that example frames are checked by."""
    import types
    package = types.ModuleType("orrery")
    package.__path__ = [str(ROOT / "proto/python/orrery")]
    sys.modules["orrery"] = package
    for name in ("codec", "messages", "frame"):
        spec = importlib.util.spec_from_loader(f"orrery.{name}", loader=None)
        module = importlib.util.module_from_spec(spec)
        module.__package__ = "orrery"
        sys.modules[f"orrery.{name}"] = module
        text = messages_text if name == "messages" else (ROOT / f"proto/python/orrery/{name}.py").read_text(encoding="utf-8")
        exec(compile(text, f"orrery/{name}.py", "exec"), module.__dict__)
        setattr(package, name, module)
    return package


def build(cls, values, messages):
    """An object of a generated class from the plain values of an example."""
    known = {f.name: f for f in cls.LAYOUT}
    made = {}
    for name, value in values.items():
        field = known[name]
        if field.kind == "struct":
            value = build(field.record, value, messages)
        elif field.kind == "list" and field.record:
            value = [build(field.record, v, messages) for v in value]
        made[name] = value
    return cls(**made)


def check_examples(spec, package):
    """Each example's hex is what its values make; a wrong one is shown as it should be."""
    wrong = []
    for e in spec.examples:
        cls = package.messages.MESSAGES[spec.messages[e["message"]].type_number]
        message = build(cls, e["values"], package.messages)
        made = package.frame.make(cls.TYPE, e["sequence"], message.encode())
        if made.hex() != e["hex"].replace(" ", ""):
            wrong.append(f"example {e['name']}: its values make\n{made.hex()}")
    if wrong:
        raise SpecError("\n".join(wrong))


def codec_and_client(spec):
    """path -> text of C's codec, the client's verbs, and firmware's client that is made of them."""
    c = gen_c.CWriter(spec, SOURCE, "proto/gen/messages.h")
    verbs = gen_client.Verbs(spec, SOURCE)
    made = {
        "proto/gen/messages.h": c.header(),
        "proto/gen/messages.c": c.code(),
        "proto/gen/crc32_table.h": gen_c.crc_header(),
        "proto/gen/verbs.h": verbs.header(),
        "proto/gen/verbs.c": verbs.code(),
    }
    header, source = gen_client.firmware(lambda name: made[name] if name in made else (ROOT / name).read_text(encoding="utf-8"))
    made["proto/gen/firmware/orrery_client.h"], made["proto/gen/firmware/orrery_client.c"] = header, source
    return made


def version_module():
    """The Python client's version: that of CMakeLists.txt, the one place where it stands."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"^project\(orrery VERSION (\d+\.\d+\.\d+)", text, re.MULTILINE)
    if not version:
        raise SpecError("CMakeLists.txt: no project(orrery VERSION n.n.n)")
    return ("# SPDX-License-Identifier: MIT\n# Generated from CMakeLists.txt by proto/spec/generate.py; do not edit.\n"
            f'"""The version of the client: that of the program it comes with."""\n__version__ = "{version[1]}"\n')


def outputs(spec):
    """path -> text of everything generated."""
    handlers = gen_handlers.Handlers(spec, SOURCE)
    messages_text = gen_python.module(spec, SOURCE)
    check_examples(spec, load_package(messages_text))
    page = ROOT / "docs/protocol.md"
    made = codec_and_client(spec) | {
        "proto/gen/fields.c": gen_fields.Fields(spec, SOURCE).code(),
        "proto/gen/handlers.h": handlers.header(),
        "proto/gen/handlers.c": handlers.code(),
        "proto/gen/orrery.lua": gen_lua.Lua(spec, SOURCE).module(),
        "proto/python/orrery/messages.py": messages_text,
        "proto/python/orrery/_version.py": version_module(),
        "proto/python/orrery/verbs.py": gen_python.verbs(spec, SOURCE),
        "docs/protocol.md": gen_docs.page(spec, page.read_text(encoding="utf-8")),
        "tests/golden/proto/frames.h": gen_docs.golden_header(spec, SOURCE),
    }
    return made


def write_other(path, out, client):
    spec = Spec(path)
    name = pathlib.Path(path).stem
    c = gen_c.CWriter(spec, pathlib.Path(path).name, f"{name}.h")
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    (out / f"{name}.h").write_text(c.header(), encoding="utf-8")
    (out / f"{name}.c").write_text(c.code(), encoding="utf-8")
    (out / f"{name}.py").write_text(gen_python.module(spec, pathlib.Path(path).name), encoding="utf-8")
    if client:
        for file, text in codec_and_client(spec).items():
            if file.startswith("proto/gen/firmware/"):
                (out / pathlib.Path(file).name).write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--spec")
    parser.add_argument("--out")
    parser.add_argument("--client", action="store_true")
    args = parser.parse_args()
    try:
        if args.spec:
            write_other(args.spec, args.out or ".", args.client)
            return 0
        made = outputs(Spec(ROOT / SOURCE))
    except SpecError as error:
        print(f"{args.spec or SOURCE}: {error}", file=sys.stderr)
        return 1
    stale = []
    for name, text in made.items():
        path = ROOT / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
            if not args.check:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
    if args.check:
        for name in stale:
            print(f"{name} is stale: run python3 proto/spec/generate.py", file=sys.stderr)
        return 1 if stale else 0
    print(f"{len(made)} files made from {SOURCE}, {len(stale)} changed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
