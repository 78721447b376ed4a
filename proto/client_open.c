// SPDX-License-Identifier: MIT
// What stands above the generated verbs: the begin of a conversation, and a look whether the peer is alive.
#include "proto/client.h"

orr_wire_status orr_client_open(orr_client *c, const char *name, const char *version, orr_msg_caps *caps)
{
    orr_msg_hello hello = {ORR_MSG_MAJOR, ORR_MSG_MAJOR, orr_wire_text(name), orr_wire_text(version)};
    return orr_client_hello(c, &hello, caps);
}

orr_wire_status orr_client_check(orr_client *c, uint64_t token)
{
    orr_msg_ping ping = {token};
    orr_msg_pong pong;
    orr_wire_status s = orr_client_ping(c, &ping, &pong);
    return s == ORR_WIRE_OK && pong.token != token ? ORR_WIRE_UNEXPECTED : s;
}
