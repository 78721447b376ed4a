// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/access.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/config/rows_private.h"

static const orr_choice permissions[] = {
    {"read", ORR_MAY_READ, "poll and subscribe"},
    {"motion", ORR_MAY_MOTION, "send live motion"},
    {"control", ORR_MAY_CONTROL, "control the scenario's clock"},
    {0},
};

static const orr_key client_rows[] = {
    {.name = "name",
     .kind = ORR_KEY_TEXT,
     .required = true,
     .offset = offsetof(orr_access_client, name),
     .help = "the common name (CN) of its certificate"},
    {.name = "may",
     .kind = ORR_KEY_CHOICE,
     .list = true,
     .required = true,
     .offset = offsetof(orr_access_client, may),
     .choice = permissions,
     .help = "what it may do"},
};
static const orr_schema client_table = ORR_SCHEMA(client_rows, orr_access_client);

#define LIMIT_INT(n, m, lo, hi, dflt, h) INT_ROW(orr_access_limits, n, m, lo, hi, dflt, NULL, h)
#define LIMIT_REAL(n, m, lo, hi, u, dflt, h) REAL_ROW(orr_access_limits, n, m, lo, hi, u, dflt, NULL, h)

static const orr_key limit_rows[] = {
    LIMIT_INT("clients", clients, 1, 10000, "256", "clients at once"),
    LIMIT_INT("clients_per_address", clients_per_address, 1, 10000, "64",
              "of them from one address (IPv6: from one network of 64 bits)"),
    LIMIT_INT("handshakes", handshakes, 1, 1000, "32", "TLS handshakes under way at once"),
    LIMIT_REAL("handshake_s", handshake_s, 0.1, 600, "s", "10", "how long a TLS handshake may take"),
    LIMIT_REAL("connections_per_s", connections_per_s, 0, 1e6, "1/s", "20",
               "new connections from one address, twice as many at once; 0: any number"),
    LIMIT_REAL("requests_per_s", requests_per_s, 0, 1e9, "1/s", "10000",
               "requests of one client; beyond that it waits. 0: any number"),
    LIMIT_REAL("requests_per_s_per_address", requests_per_s_per_address, 0, 1e9, "1/s", "40000",
               "requests from one address, likewise"),
    LIMIT_REAL("idle_s", idle_s, 1, 1e6, "s", "600", "a client that has asked nothing for so long is closed"),
    LIMIT_REAL("first_s", first_s, 0.1, 1e6, "s", "30", "the same of one that has not yet asked anything"),
    BOOL_ROW(orr_access_limits, "local", local, "false", NULL,
             "those of addresses and rates hold for clients on this machine too"),
};
static const orr_schema limits_table = ORR_SCHEMA(limit_rows, orr_access_limits);

static const orr_condition with_certificate[] = {
    {.key = "certificate", .why = "nothing is encrypted without a certificate"}, {0}};

static const orr_key rows[] = {
    FILE_ROW(orr_access_file, "certificate", certificate, NULL,
             "the service's certificate, with those that lead to its authority (PEM)"),
    FILE_ROW(orr_access_file, "key", key, with_certificate, "its private key (PEM)"),
    FILE_ROW(orr_access_file, "authority", authority, with_certificate,
             "certificates of the authorities that clients' certificates must come from (PEM)"),
    MAPS_ROW(orr_access_file, "clients", clients, &client_table, 10000, with_certificate,
             "clients on other machines; who is not named may do nothing"),
    BOOL_ROW(orr_access_file, "insecure_listen", insecure_listen, "false", NULL,
             "listen at addresses that other machines reach without TLS: whoever can reach them may do "
             "everything"),
    TEXT_ROW(orr_access_file, "group", group, NULL,
             "group of Unix sockets (mode 0660); that of the process by default"),
    MAP_ROW(orr_access_file, "limits", limits, &limits_table, NULL, "what clients may take"),
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_access_file *f = map;
    if (f->certificate != NULL && (f->key == NULL || f->authority == NULL)) {
        snprintf(why, ORR_SCHEMA_WHY, "with a certificate, key and authority are wanted too");
        return "certificate";
    }
    for (size_t k = 0; k < f->clients.n; k++)
        for (size_t j = 0; j < k; j++)
            if (strcmp(f->clients.item[j].name, f->clients.item[k].name) == 0) {
                snprintf(why, ORR_SCHEMA_WHY, "'%.100s' is named twice", f->clients.item[k].name);
                return "clients";
            }
    return NULL;
}

static const orr_schema schema = {.key = rows,
                                  .n = sizeof rows / sizeof rows[0],
                                  .size = sizeof(orr_access_file),
                                  .check = check,
                                  .hint = "orrery serve --help-access lists all"};

const orr_schema *orr_access_schema(void) { return &schema; }

orr_status orr_access_read(const char *path, orr_access_file *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_read(path, &y, diag);
    if (s != ORR_OK) return s;
    char *folder = orr_yaml_folder(path);
    s = folder != NULL ? orr_schema_read(&schema, &y, folder, NULL, out, diag)
                       : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    free(folder);
    orr_yaml_free(&y);
    return s;
}

orr_status orr_access_defaults(orr_access_file *out, orr_diag *diag)
{
    const orr_yaml empty = {0};
    return orr_schema_read(&schema, &empty, NULL, NULL, out, diag);
}
