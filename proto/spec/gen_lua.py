# SPDX-License-Identifier: MIT
"""The Wireshark dissector: one Lua file, no module needed. In Wireshark: Help > About > Folders > Personal Lua Plugins."""
from model import SCALARS

LUA_FIELD = {"u8": "uint8", "u16": "uint16", "u32": "uint32", "u64": "uint64", "i8": "int8", "i16": "int16", "i32": "int32",
             "i64": "int64", "f32": "float", "f64": "double"}
LUA_READ = {"u8": "le_uint", "u16": "le_uint", "u32": "le_uint", "u64": "le_uint64"}

HEAD = """-- SPDX-License-Identifier: MIT
-- Generated from {source} by proto/spec/generate.py: change that, not this.
-- Wireshark dissector of {name}, protocol {major}.{minor}, TCP port {port}.
local orrery = Proto("orrery", "{name} satellite states")
local f = orrery.fields

local crc_table = {{}}
for i = 0, 255 do
  local v = i
  for _ = 1, 8 do
    if v % 2 == 1 then v = bit.bxor(bit.rshift(v, 1), 0xEDB88320) else v = bit.rshift(v, 1) end
  end
  crc_table[i] = v
end
local function crc32(tvb)
  local raw, crc = tvb:raw(), 0xFFFFFFFF
  for i = 1, #raw do crc = bit.bxor(crc_table[bit.band(bit.bxor(crc, raw:byte(i)), 0xFF)], bit.rshift(crc, 8)) end
  return bit.band(bit.bnot(crc), 0xFFFFFFFF) % 4294967296
end

-- A reader over a range that stops at its end: fields that are not there are not shown.
local function reader(tvb, at, stop) return {{tvb = tvb, at = at, stop = stop, ok = true}} end
local function take(r, n)
  if not r.ok or r.at + n > r.stop then
    r.ok = false
    return nil
  end
  r.at = r.at + n
  return r.tvb(r.at - n, n)
end
local function add(r, tree, field, n)
  local range = take(r, n)
  if range then tree:add_le(field, range) end
  return range
end
local function add_text(r, tree, field)
  local size = take(r, 2)
  if not size then return end
  local n = size:le_uint()
  if n > 0 then
    local range = take(r, n)
    if range then tree:add(field, range) end
  else
    tree:add(field, size, "")
  end
end
"""

TAIL = """
local decode = {{
{decoders}
}}

f.major = ProtoField.uint8("orrery.major", "Major version")
f.minor = ProtoField.uint8("orrery.minor", "Minor version")
f.type = ProtoField.uint16("orrery.type", "Type", base.DEC, types)
f.sequence = ProtoField.uint32("orrery.sequence", "Sequence")
f.length = ProtoField.uint32("orrery.length", "Payload length")
f.crc = ProtoField.uint32("orrery.crc", "CRC-32", base.HEX)
local bad_crc = ProtoExpert.new("orrery.bad_crc", "checksum does not match", expert.group.CHECKSUM, expert.severity.ERROR)
orrery.experts = {{bad_crc}}

local function one_frame(tvb, pinfo, tree)
  local type, size = tvb(6, 2):le_uint(), tvb(12, 4):le_uint()
  local name = types[type] or ("type " .. type)
  local t = tree:add(orrery, tvb(0, 20 + size), "{name} " .. name .. ", sequence " .. tvb(8, 4):le_uint())
  t:add(f.major, tvb(4, 1))
  t:add(f.minor, tvb(5, 1))
  t:add_le(f.type, tvb(6, 2))
  t:add_le(f.sequence, tvb(8, 4))
  t:add_le(f.length, tvb(12, 4))
  local r = reader(tvb, 16, 16 + size)
  if decode[type] then decode[type](r, t) end
  local sum = t:add_le(f.crc, tvb(16 + size, 4))
  if crc32(tvb(0, 16 + size)) ~= tvb(16 + size, 4):le_uint() then sum:add_proto_expert_info(bad_crc) end
  pinfo.cols.protocol = "{name}"
  pinfo.cols.info:append(" " .. name)
  return 20 + size
end

function orrery.dissector(tvb, pinfo, tree)
  if tvb:len() >= 4 and tvb(0, 4):raw() ~= "{magic}" then return 0 end
  pinfo.cols.info:set("")
  dissect_tcp_pdus(tvb, tree, 16, function(t) return 20 + t(12, 4):le_uint() end, one_frame)
  return tvb:len()
end

DissectorTable.get("tcp.port"):add({port}, orrery)
"""


class Lua:
    def __init__(self, spec, source):
        self.spec, self.source = spec, source

    def field_name(self, struct, field):
        return f"{struct.name}_{field.name}"

    def declare(self, struct, field):
        t = field.type
        name, path = self.field_name(struct, field), f"orrery.{struct.name}.{field.name}"
        label = field.name + (f" [{field.unit}]" if field.unit and field.unit not in field.name else "")
        if t.kind == "struct" or (t.kind == "list" and t.struct):
            return None
        if t.kind == "string":
            return f'f.{name} = ProtoField.string("{path}", "{label}")'
        if t.kind == "bytes":
            return f'f.{name} = ProtoField.bytes("{path}", "{label}")'
        kind = LUA_FIELD[t.scalar]
        if t.named in self.spec.enums:
            return f'f.{name} = ProtoField.{kind}("{path}", "{label}", base.DEC, enum_{t.named})'
        if t.named in self.spec.bits or field.show == "hex":
            return f'f.{name} = ProtoField.{kind}("{path}", "{label}", base.HEX)'
        if field.show == "char":
            return f'f.{name} = ProtoField.char("{path}", "{label}")'
        return f'f.{name} = ProtoField.{kind}("{path}", "{label}")'

    def read(self, struct, field):
        t, name = field.type, f"f.{self.field_name(struct, field)}"
        if t.kind == "scalar":
            needed = any(g.when_field == field.name for g in struct.fields)
            line = f"add(r, tree, {name}, {SCALARS[t.scalar]})"
            return [f"  local {field.name} = {line}" if needed else f"  {line}"]
        if t.kind == "array":
            return [f"  for _ = 1, {t.length} do add(r, tree, {name}, {SCALARS[t.scalar]}) end"]
        if t.kind == "struct":
            return [f"  record_{t.struct.name}(r, tree)"]
        if t.kind in ("string", "bytes"):
            return [f"  add_text(r, tree, {name})"]
        body = [f'  local count, stride = take(r, 2), {"take(r, 2)" if t.record else "nil"}',
                f"  for k = 1, {'(count and stride)' if t.record else 'count'} and count:le_uint() or 0 do"]
        if not t.record:
            body.append("    local stride = take(r, 2)")
            body.append("    if not stride then break end")
        body += ["    local n = stride:le_uint()", "    local range = n > 0 and take(r, n)", "    if not range then break end",
                 "    local one = reader(r.tvb, r.at - n, r.at)"]
        if t.scalar:
            body.append(f"    add(one, tree, {name}, {SCALARS[t.scalar]})")
        else:
            body.append(f'    record_{t.struct.name}(one, tree:add(orrery, range, "{field.name} " .. k))')
        return ["  do"] + ["  " + line for line in body + ["  end"]] + ["  end"]

    def function(self, struct):
        out = [f"local function record_{struct.name}(r, tree)"]
        for f in struct.fields:
            lines = self.read(struct, f)
            if f.when:
                lines = [f"  if {f.when_field} and bit.band({f.when_field}:le_uint(), {f.when_mask}) ~= 0 then"] + \
                        ["  " + line for line in lines] + ["  end"]
            out += lines
        return out + ["end", ""]

    def module(self):
        s = self.spec
        out = [HEAD.format(source=self.source, name=s.name, major=s.major, minor=s.minor, port=s.port)]
        out += ["local types = {"] + [f'  [{m.type_number}] = "{n}",' for n, m in s.messages.items()] + ["}"]
        for name, e in s.enums.items():
            out += [f"local enum_{name} = {{"] + [f'  [{v["value"]}] = "{n}",' for n, v in e["values"].items()] + ["}"]
        out.append("")
        both = list(s.structs.values()) + list(s.messages.values())
        for struct in both:
            out += [line for line in (self.declare(struct, f) for f in struct.fields) if line]
        out.append("")
        for struct in both:
            out += self.function(struct)
        decoders = "\n".join(f"  [{m.type_number}] = record_{m.name}," for m in s.messages.values())
        out.append(TAIL.format(decoders=decoders, name=s.name, magic=s.magic.decode(), port=s.port))
        return "\n".join(out)
