# SPDX-License-Identifier: MIT
"""The server's side: a request is decoded once, and its handlers get the struct."""
from gen_c import HEAD


class Handlers:
    def __init__(self, spec, source):
        self.spec, self.source, self.p, self.up = spec, source, spec.prefix, spec.prefix.upper()
        self.requests = [m for m in spec.messages.values() if m.sender == "client" and m.answer != "none" and not m.built_in and not m.lane]
        self.lanes = [m for m in spec.messages.values() if m.lane]

    def header(self):
        p = self.p
        out = [line.format(source=self.source) for line in HEAD]
        out += ["// The handlers of a server, a pair for each request. Included by proto/server.h, which says what they do.",
                "#ifndef ORR_PROTO_GEN_HANDLERS_H", "#define ORR_PROTO_GEN_HANDLERS_H", "",
                f"typedef struct {p}_handlers {{"]
        for m in self.requests:
            out += [f"    // {m.name.upper()}, answered by {m.answer}. {m.doc}",
                    f"    uint16_t (*begin_{m.name})(void *user, const {p}_{m.name} *request, orr_server_refusal *why);",
                    f"    uint16_t (*{m.name})(void *user, const {p}_{m.name} *request, orr_server_part *part, orr_wire_writer *w,",
                    f"                 {' ' * len(m.name)}      orr_server_refusal *why);"]
        out += [f"}} {p}_handlers;", "", "// Number i of the requests of the table; 0 behind the last.",
                f"uint16_t {p}_request_type(size_t i);", "// The message that answers a request of the table; 0 where it has no handler.",
                f"uint16_t {p}_handled(const {p}_handlers *h, uint16_t type);",
                "// These three want a request that has a handler. Frames of its answer: one for each epoch, or one.",
                f"orr_wire_status {p}_request_decode(uint16_t type, const uint8_t *payload, size_t size, {p}_any *request);",
                f"uint32_t {p}_request_frames(uint16_t type, const {p}_any *request);",
                f"uint16_t {p}_begin(const {p}_handlers *h, void *user, uint16_t type, const {p}_any *request, orr_server_refusal *why);",
                f"uint16_t {p}_answer(const {p}_handlers *h, void *user, uint16_t type, const {p}_any *request, orr_server_part *part,",
                "                        orr_wire_writer *w, orr_server_refusal *why);",
                "// Whether a message belongs to the connection (SUBSCRIBE, ...): who owns connections answers it, not the table.",
                f"bool {p}_is_lane(uint16_t type);", "// Number i of those that are answered, and its answer in *answer; 0 behind the last.",
                f"uint16_t {p}_lane_request(size_t i, uint16_t *answer);", "", "#endif"]
        return "\n".join(out) + "\n"

    def switch(self, default, case):
        return ["    switch (type) {"] + [f"    case {self.up}_TYPE_{m.name.upper()}: {case(m)}" for m in self.requests] + \
            [f"    default: {default}", "    }", "}", ""]

    def code(self):
        p, up = self.p, self.up
        out = [line.format(source=self.source) for line in HEAD] + ['#include "proto/server.h"', ""]
        out += [f"uint16_t {p}_request_type(size_t i)", "{", "    static const uint16_t types[] = {"]
        out += [f"        {up}_TYPE_{m.name.upper()}," for m in self.requests]
        out += ["    };", "    return i < sizeof types / sizeof types[0] ? types[i] : 0;", "}", ""]
        out += [f"uint16_t {p}_handled(const {p}_handlers *h, uint16_t type)", "{"]
        out += self.switch("return 0;", lambda m: f"return h->{m.name} != NULL ? {up}_TYPE_{m.answer} : 0;")
        out += [f"orr_wire_status {p}_request_decode(uint16_t type, const uint8_t *payload, size_t size, {p}_any *request)", "{"]
        out += self.switch("return ORR_WIRE_UNEXPECTED;", lambda m: f"return {p}_{m.name}_decode(payload, size, &request->{m.name});")
        out += [f"uint32_t {p}_request_frames(uint16_t type, const {p}_any *request)", "{", "    (void)request;"]
        out += self.switch("return 1;", lambda m: f"return request->{m.name}.{m.epochs.name}.count;" if m.epochs else "return 1;")
        out += [f"uint16_t {p}_begin(const {p}_handlers *h, void *user, uint16_t type, const {p}_any *request, orr_server_refusal *why)", "{"]
        out += self.switch(f"return {up}_ERROR_CODE_INTERNAL;",
                           lambda m: f"return h->begin_{m.name} != NULL ? h->begin_{m.name}(user, &request->{m.name}, why) : 0;")
        out += [f"uint16_t {p}_answer(const {p}_handlers *h, void *user, uint16_t type, const {p}_any *request, orr_server_part *part,",
                "                        orr_wire_writer *w, orr_server_refusal *why)", "{"]
        out += self.switch(f"return {up}_ERROR_CODE_INTERNAL;", lambda m: f"return h->{m.name}(user, &request->{m.name}, part, w, why);")
        out += [f"bool {p}_is_lane(uint16_t type)", "{", "    switch (type) {"] + \
            [f"    case {up}_TYPE_{m.name.upper()}:" for m in self.lanes] + \
            (["        return true;"] if self.lanes else []) + ["    default: return false;", "    }", "}", ""]
        answered = [m for m in self.lanes if m.answer != "none"]
        out += [f"uint16_t {p}_lane_request(size_t i, uint16_t *answer)", "{", "    static const uint16_t lanes[][2] = {"]
        out += [f"        {{{up}_TYPE_{m.name.upper()}, {up}_TYPE_{m.answer}}}," for m in answered]
        out += ["    };", "    if (i >= sizeof lanes / sizeof lanes[0]) return 0;", "    *answer = lanes[i][1];", "    return lanes[i][0];", "}", ""]
        return "\n".join(out).rstrip("\n") + "\n"
