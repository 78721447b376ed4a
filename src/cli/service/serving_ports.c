// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/serving_ports.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum { LOGIN = 256, ADDRESS = ORR_URL_TEXT };

static const struct {
    const char *option;
    orr_port_format format;
    bool ntrip;
} kinds[] = {{"ntrip", ORR_PORT_RTCM, true},
             {"rtcm", ORR_PORT_RTCM, false},
             {"ubx", ORR_PORT_UBX, false},
             {"nmea", ORR_PORT_NMEA, false}};
enum { KINDS = sizeof kinds / sizeof *kinds };

// The texts of one option, which the source borrows.
typedef struct asked {
    char url[ADDRESS], mount[ADDRESS];
} asked;

static orr_status no_antenna(const orr_channels *c, const char *option, const char *text, orr_diag *diag)
{
    char list[400] = "";
    for (size_t k = 0, at = 0; k < orr_channels_antennas(c) && at + 70 < sizeof list; k++)
        at += (size_t)snprintf(list + at, sizeof list - at, "%s%s", k > 0 ? ", " : "",
                               orr_channels_antenna(c, k)->name);
    return orr_diag_set(diag, ORR_E_ARG,
                        "--%s %.200s: ANTENNA@ADDRESS is wanted, with one of the antennas %s", option, text,
                        list);
}

// ANTENNA@ of an option; without it the only antenna. *rest is what stands behind.
static orr_status find_antenna(const orr_channels *c, const char *option, const char *text, size_t *antenna,
                               const char **rest, orr_diag *diag)
{
    const char *sign = strchr(text, '@');
    *rest = sign != NULL ? sign + 1 : text;
    *antenna = 0;
    if (sign == NULL) return orr_channels_antennas(c) == 1 ? ORR_OK : no_antenna(c, option, text, diag);
    for (size_t k = 0; k < orr_channels_antennas(c); k++) {
        const char *name = orr_channels_antenna(c, k)->name;
        if (strlen(name) != (size_t)(sign - text) || strncmp(name, text, strlen(name)) != 0) continue;
        *antenna = k;
        return ORR_OK;
    }
    return no_antenna(c, option, text, diag);
}

// ADDRESS, of a caster ADDRESS/MOUNT.
static orr_status split(const char *option, const char *text, bool ntrip, asked *out, orr_diag *diag)
{
    const char *slash = ntrip ? strrchr(text, '/') : NULL;
    if (strlen(text) >= ADDRESS || (ntrip && (slash == NULL || slash == text || slash[-1] == '/')))
        return orr_diag_set(diag, ORR_E_ARG, "--%s: %.200s is no address%s", option, text,
                            ntrip ? " of a caster: tcp://HOST:PORT/MOUNT is wanted" : "");
    const size_t n = slash != NULL ? (size_t)(slash - text) : strlen(text);
    memcpy(out->url, text, n);
    out->url[n] = '\0';
    snprintf(out->mount, sizeof out->mount, "%s", slash != NULL ? slash + 1 : "");
    return ORR_OK;
}

static orr_status make_source(const serving *v, size_t kind, const char *text, asked *a, orr_port_source *out,
                              orr_diag *diag)
{
    const orr_channels *c = orr_engine_channels(v->world.engine);
    const char *rest;
    size_t antenna;
    orr_status s = find_antenna(c, kinds[kind].option, text, &antenna, &rest, diag);
    if (s == ORR_OK) s = split(kinds[kind].option, rest, kinds[kind].ntrip, a, diag);
    if (s != ORR_OK) return s;
    if (v->vehicle != NULL && orr_channels_antenna(c, antenna)->motion != NULL)
        return orr_diag_set(diag, ORR_E_ARG,
                            "--%s: antenna %s rides on live motion, which receivers' ports do not follow",
                            kinds[kind].option, orr_channels_antenna(c, antenna)->name);
    *out = (orr_port_source){.plan = {.format = kinds[kind].format,
                                      .channels = c,
                                      .antenna = antenna,
                                      .navdata = orr_engine_source_navdata(v->world.engine),
                                      .leap = v->c->leap,
                                      .msm = orr_cli_says(v->c, "msm", "4") ? 4 : 7,
                                      .station = (unsigned)(antenna + 1)},
                             .url = a->url,
                             .mount = kinds[kind].ntrip ? a->mount : NULL,
                             .step_ns = (int64_t)(1e9 / orr_cli_real(v->c, "port-rate", 1) + 0.5),
                             .noise = orr_cli_given(v->c, "noise"),
                             .seed = (uint64_t)orr_cli_int(v->c, "seed", 1)};
    return ORR_OK;
}

// The first line of the login's file: USER:PASSWORD.
static orr_status read_login(const char *path, char login[LOGIN], orr_diag *diag)
{
    FILE *f = fopen(path, "r");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    const bool any = fgets(login, LOGIN, f) != NULL;
    fclose(f);
    if (any) login[strcspn(login, "\r\n")] = '\0';
    if (!any || strchr(login, ':') == NULL || strlen(login) >= LOGIN - 2)
        return orr_diag_at(diag, ORR_E_FORMAT, path, 1, 0,
                           "USER:PASSWORD of at most %d characters is wanted here", LOGIN - 3);
    return ORR_OK;
}

orr_status serving_ports(serving *v, orr_diag *diag)
{
    orr_port_source source[ORR_PORT_SOURCES];
    asked texts[ORR_PORT_SOURCES];
    char login[LOGIN];
    size_t n = 0;
    orr_status s = ORR_OK;
    for (size_t kind = 0; kind < KINDS; kind++)
        for (size_t k = 0; s == ORR_OK && k < orr_cli_count(v->c, kinds[kind].option); k++) {
            if (orr_engine_channels(v->world.engine) == NULL)
                return orr_diag_set(diag, ORR_E_ARG,
                                    "--%s: the scenario names no signals, so that no antenna observes any",
                                    kinds[kind].option);
            if (n == ORR_PORT_SOURCES)
                return orr_diag_set(diag, ORR_E_LIMIT, "at most %d receivers' ports are served",
                                    ORR_PORT_SOURCES);
            s = make_source(v, kind, orr_cli_text_at(v->c, kinds[kind].option, k), &texts[n], &source[n],
                            diag);
            n++;
        }
    const char *path = orr_cli_text(v->c, "ntrip-login", NULL);
    if (s == ORR_OK && path != NULL) s = read_login(path, login, diag);
    if (s != ORR_OK || n == 0) return s;
    const orr_port_server_options o = {.source = source,
                                       .n = n,
                                       .login = path != NULL ? login : NULL,
                                       .streams = v->streams,
                                       .access = v->world.access,
                                       .log = &v->log};
    return orr_port_server_open(&o, &v->ports, diag);
}

size_t serving_ports_say(const serving *v, char *text, size_t size, size_t at)
{
    const char *url;
    size_t k = 0;
    for (size_t kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < orr_cli_count(v->c, kinds[kind].option); i++)
            if ((url = orr_port_server_url(v->ports, k++)) != NULL && at + strlen(url) + 40 < size)
                at += (size_t)snprintf(text + at, size - at, " with %s on %s", kinds[kind].option, url);
    return at;
}
