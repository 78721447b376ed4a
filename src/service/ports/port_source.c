// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/ports/port_source.h"

#include <stdio.h>

#include "core/constants.h"
#include "core/earth.h"
#include "src/scenario/receiver/msm.h"

#define LIST 256                   // characters
#define LATE_NS (2 * ORR_NS_PER_S) // where the clock is farther ahead it has jumped

orr_status port_feed_open(port_feed *f, const orr_port_source *source, orr_diag *diag)
{
    *f = (port_feed){.source = *source, .seen = ORR_TIME_NONE};
    if (!orr_port_takes(source->plan.format, 0, source->step_ns))
        return orr_diag_set(diag, ORR_E_ARG,
                            "RTCM counts whole milliseconds: take a --port-rate whose step is some");
    orr_status s = orr_observer_open(source->plan.channels, source->plan.antenna, source->noise, source->seed,
                                     &f->observer, diag);
    if (s == ORR_OK) s = orr_port_open(&source->plan, &f->port, diag);
    return s;
}

void port_feed_close(port_feed *f)
{
    orr_port_close(f->port);
    orr_observer_close(f->observer);
    f->port = NULL, f->observer = NULL;
}

static orr_time step_after(const port_feed *f, orr_time t)
{
    return orr_time_add(t, orr_floor_mod(-t, f->source.step_ns));
}

// The clock jumped: arcs begin anew, on the first step from `now` on.
static orr_status begin_anew(port_feed *f, orr_time now, orr_diag *diag)
{
    const orr_port_source source = f->source;
    const orr_span span = orr_channels_antenna_span(source.plan.channels, source.plan.antenna);
    port_feed_close(f);
    const orr_status s = port_feed_open(f, &source, diag);
    f->next = step_after(f, now > span.from ? now : span.from);
    f->seen = now;
    return s;
}

bool port_feed_turn(port_feed *f, orr_time now, bool running, orr_port_bytes *out, orr_diag *diag)
{
    const orr_span span = orr_channels_antenna_span(f->source.plan.channels, f->source.plan.antenna);
    orr_status s = ORR_OK;
    if (f->seen == ORR_TIME_NONE || now < f->seen ||
        orr_time_sub_ns(now, f->next) > LATE_NS + f->source.step_ns)
        s = begin_anew(f, now, diag);
    f->seen = now;
    if (s == ORR_OK && (!running || f->ended || f->next > now)) return false;
    if (s == ORR_OK && f->next > span.to) {
        f->ended = true;
        return false;
    }
    if (s == ORR_OK) s = orr_observer_at(f->observer, f->next, &f->observed, diag);
    if (s == ORR_OK) s = orr_port_epoch(f->port, &f->observed, out, diag);
    f->next = orr_time_add(f->next, f->source.step_ns);
    f->ended = s != ORR_OK;
    return s == ORR_OK;
}

// "1077(1)": MSM of each system that is observed, with their names as source tables have them.
static size_t systems_of(const port_feed *f, char messages[LIST], char names[LIST])
{
    static const struct {
        char system;
        const char *name;
    } rows[] = {{'G', "GPS"}, {'R', "GLO"}, {'E', "GAL"}, {'S', "SBAS"},
                {'J', "QZS"}, {'C', "BDS"}, {'I', "IRN"}};
    const uint64_t sent = orr_channels_signals(f->source.plan.channels);
    size_t a = 0, b = 0, carriers = 1;
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const uint64_t own = sent & orr_signals_of(rows[k].system);
        if (own == 0) continue;
        if ((own & (own - 1)) != 0) carriers = 2;
        a += (size_t)snprintf(messages + a, LIST - a, ",%d(%g)",
                              orr_msm_number(rows[k].system, f->source.plan.msm),
                              (double)f->source.step_ns / 1e9);
        b += (size_t)snprintf(names + b, LIST - b, "%s%s", b > 0 ? "+" : "", rows[k].name);
    }
    return carriers;
}

size_t port_feed_table(const port_feed *f, bool login, char *text, size_t size)
{
    char messages[LIST] = "", names[LIST] = "";
    const orr_antenna *a = orr_channels_antenna(f->source.plan.channels, f->source.plan.antenna);
    const size_t carriers = systems_of(f, messages, names);
    orr_geodetic g = {0, 0, 0};
    if (a->motion == NULL) g = orr_earth_from_ecef(a->fixed.r_m);
    return (size_t)snprintf(
        text, size,
        "STR;%s;%s;RTCM 3.3;1005(10),1006(10),1033(10)%s;%zu;%s;none;;%.2f;%.2f;0;0;Orrery " ORR_VERSION
        ";none;%s;N;9600;simulated\r\nENDSOURCETABLE\r\n",
        f->source.mount, a->name, messages, carriers, names, g.lat_rad * ORR_DEG_PER_RAD,
        g.lon_rad * ORR_DEG_PER_RAD, login ? "B" : "N");
}
