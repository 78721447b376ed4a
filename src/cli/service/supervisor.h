// SPDX-License-Identifier: GPL-3.0-or-later
// What a supervisor (systemd) and the service tell each other: that it is ready, reads its files again, stops, is alive; and sockets that it
// was handed. Its own few lines, after sd_notify(3) and sd_listen_fds(3); without a supervisor nothing happens.
#ifndef ORR_CLI_SERVICE_SUPERVISOR_H
#define ORR_CLI_SERVICE_SUPERVISOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { ORR_SUPERVISOR_SOCKETS = 16 };

// A socket that the supervisor listens on and hands over.
typedef struct orr_handed_socket {
    int fd;
    bool tls; // its FileDescriptorName is "tls"
} orr_handed_socket;

typedef struct orr_supervisor {
    int64_t every_ns; // how often it wants to hear that the service is alive; 0: never
    int64_t told_ns;
} orr_supervisor;

// Reads from the environment what is asked of this process.
void orr_supervisor_find(orr_supervisor *s);
// Sends a message ("READY=1", several by newlines). False: there is nobody, or nobody takes it.
bool orr_supervisor_say(const char *message);
// Says "WATCHDOG=1" when a third of the time is over.
void orr_supervisor_alive(orr_supervisor *s, int64_t now_ns);
// Sockets that were handed over to this process: how many, at most ORR_SUPERVISOR_SOCKETS. They are not inherited any further.
size_t orr_supervisor_sockets(orr_handed_socket out[ORR_SUPERVISOR_SOCKETS]);

#endif
