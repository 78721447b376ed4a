// SPDX-License-Identifier: GPL-3.0-or-later
// orrery tls: a laboratory's own certificates.
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/outfile.h"
#include "src/cli/frame/cli.h"
#include "src/service/net/certificates.h"

enum { MOST_NAMES = 64 };

// Names that clients on this machine and in its network connect to, where none were given.
static size_t own_names(const char *names[MOST_NAMES], char host[256])
{
    size_t n = 0;
    host[255] = '\0';
    if (gethostname(host, 255) == 0 && host[0] != '\0' && strcmp(host, "localhost") != 0) names[n++] = host;
    names[n++] = "localhost";
    names[n++] = "127.0.0.1";
    names[n++] = "::1";
    return n;
}

static orr_status make_server(const orr_cli *c, const char *dir, orr_diag *diag)
{
    const char *names[MOST_NAMES];
    char host[256];
    size_t n = orr_cli_count(c, "host");
    if (n > MOST_NAMES) return orr_diag_set(diag, ORR_E_LIMIT, "at most %d names of the service", MOST_NAMES);
    for (size_t k = 0; k < n; k++) names[k] = orr_cli_text_at(c, "host", k);
    if (n == 0) n = own_names(names, host);
    return orr_certificates_server(dir, names, n, (int)orr_cli_int(c, "days", ORR_CERTIFICATE_DAYS), diag);
}

static orr_status make_client(const orr_cli *c, const char *dir, const char *name, orr_diag *diag)
{
    return orr_certificates_client(dir, name, (int)orr_cli_int(c, "days", ORR_CERTIFICATE_DAYS), diag);
}

// The access file that goes with them; one that is there stays.
static orr_status write_access(const char *dir, char *const *name, int n, orr_diag *diag)
{
    char path[4096];
    orr_outfile out;
    if (snprintf(path, sizeof path, "%s/access.yaml", dir) >= (int)sizeof path)
        return orr_diag_set(diag, ORR_E_ARG, "%.100s...: the name is too long", dir);
    if (access(path, F_OK) == 0) return ORR_OK;
    const orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    fputs("# Who may reach the service from other machines, and what each may do (docs/security.md):\n"
          "# read (poll, subscribe), motion (send live motion), control (the scenario's clock).\n"
          "certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients:\n",
          out.stream);
    for (int k = 0; k < n; k++)
        fprintf(out.stream, "  - {name: %s, may: [read, motion, control]}\n", name[k]);
    return orr_outfile_commit(&out, diag);
}

static int run(orr_cli *c)
{
    static char fallback[] = "client";
    static char *const alone[] = {fallback};
    const char *task = c->operand[0], *dir = c->operand[1];
    char *const *name = c->n_operands > 2 ? c->operand + 2 : alone;
    const int n = c->n_operands > 2 ? c->n_operands - 2 : 1;
    const bool init = strcmp(task, "init") == 0, server = strcmp(task, "server") == 0,
               client = strcmp(task, "client") == 0;
    if (!init && !server && !client) return orr_cli_usage(c, "'%s' is none of init, server and client", task);
    if (client && orr_cli_given(c, "host")) return orr_cli_usage(c, "--host is of a server's certificate");
    if (server && c->n_operands > 2)
        return orr_cli_usage(c, "names of a server's certificate are given by --host");
    if (client && c->n_operands == 2) return orr_cli_usage(c, "which client? orrery tls client DIR NAME");
    orr_diag diag = {0};
    orr_status s = ORR_OK;
    if (init) s = orr_certificates_authority(dir, ORR_AUTHORITY_DAYS, &diag);
    if (s == ORR_OK && !client) s = make_server(c, dir, &diag);
    for (int k = 0; s == ORR_OK && !server && k < n; k++) s = make_client(c, dir, name[k], &diag);
    if (s == ORR_OK && init) s = write_access(dir, name, n, &diag);
    if (s == ORR_E_ARG) return orr_cli_usage(c, "%s", diag.text);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (init)
        orr_cli_say(
            c,
            "%s: an authority, a server's certificate, and %d of clients; ca.key stays here, a client gets "
            "its NAME.pem and ca.pem",
            dir, n);
    else if (client)
        orr_cli_say(c, "%s: name %s under clients in access.yaml, and send SIGHUP to the service", dir,
                    n == 1 ? "it" : "them");
    else
        orr_cli_say(c, "%s: a new server's certificate; SIGHUP makes the service take it", dir);
    return ORR_EXIT_OK;
}

static const orr_option options[] = {
    {.name = "host",
     .kind = ORR_OPT_TEXT,
     .value = "NAME",
     .repeated = true,
     .help = "Name or address that clients connect to; by default this machine's name, localhost, 127.0.0.1 "
             "and ::1."},
    {.name = "days",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 3650,
     .help =
         "How long server's and clients' certificates are valid; 825 by default. The authority is valid for "
         "ten years."},
};

const orr_command orr_cmd_tls = {
    .name = "tls",
    .group = "Service",
    .summary = "make a laboratory's certificates, for tls:// from other machines",
    .operands = "init|server|client DIR [NAME...]",
    .min_operands = 2,
    .max_operands = 66,
    .about =
        "init makes, in DIR: a private authority (ca.pem, ca.key), the service's certificate (server.pem, "
        "server.key), one for each client NAME (NAME.pem, certificate and key; 'client' where no name is "
        "given), "
        "and access.yaml, which says what each may do. client makes more of them, server a new one of the "
        "service's.\n\n"
        "A client machine gets its NAME.pem and ca.pem, and nothing else: whoever has ca.key can make "
        "certificates for anybody. Keys are on the curve P-256 and have mode 0600.",
    .example = "orrery tls init lab generator cockpit --host simulator.lab --host 10.0.0.5\n"
               "orrery serve day.nc --listen 'tls://*:15754' --access lab/access.yaml\n"
               "orrery poll tls://simulator.lab:15754 --identity lab/generator.pem",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
