// SPDX-License-Identifier: GPL-3.0-or-later
// The file that says who may reach the service from other machines: certificates, names and what each may do, limits
// (docs/security.md). `orrery tls init` writes one.
#ifndef ORR_CONFIG_ACCESS_H
#define ORR_CONFIG_ACCESS_H

#include "src/config/schema.h"

// What a client may do; a set of bits.
typedef enum orr_may {
    ORR_MAY_NOTHING = 0,
    ORR_MAY_READ = 1,    // poll and subscribe
    ORR_MAY_MOTION = 2,  // send live motion
    ORR_MAY_CONTROL = 4, // the scenario's clock
    ORR_MAY_ALL = 7,
} orr_may;

typedef struct orr_access_client {
    char *name; // the common name of its certificate
    struct {
        size_t n;
        int *item; // orr_may
    } may;
} orr_access_client;

// What one client and one address may take of the service. Rates of 0 are without limit.
typedef struct orr_access_limits {
    int64_t clients, clients_per_address, handshakes;
    double handshake_s, connections_per_s;
    double requests_per_s, requests_per_s_per_address;
    double idle_s, first_s;
    bool local; // those that count addresses and rates hold for clients of this machine too
} orr_access_limits;

typedef struct orr_access_file {
    char *certificate, *key, *authority;
    bool insecure_listen;
    char *group; // of Unix sockets
    struct {
        size_t n;
        orr_access_client *item;
    } clients;
    orr_access_limits limits;
} orr_access_file;

// The root table of the file; free what was read with orr_schema_free.
const orr_schema *orr_access_schema(void);
// Reads and checks such a file; paths in it are relative to its folder. Errors: ORR_E_IO, ORR_E_FORMAT and ORR_E_KIND with line
// and column, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_access_read(const char *path, orr_access_file *out, orr_diag *diag);
// The table's defaults, as of an empty file.
orr_status orr_access_defaults(orr_access_file *out, orr_diag *diag);

#endif
