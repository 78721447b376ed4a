// SPDX-License-Identifier: GPL-3.0-or-later
// orrery watch: what a service is at, in a table that is drawn again and again.
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "core/constants.h"
#include "core/vec.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/service/net/dial.h"
#include "src/service/text/message_text.h"

// Thermal noise of a receiver at 290 K, dBW/Hz: what received power is set against for C/N0.
static const double NOISE_DBW_HZ = -204;

typedef struct watch_job {
    orr_cli *c;
    orr_dial *d;
    uint16_t antenna;
    bool has_channels, has_events, motion;
    char name[64][9]; // of signals
} watch_job;

static const char *state_name(uint8_t state)
{
    static const char *const name[] = {"stopped", "armed", "waiting", "running", "paused"};
    return state < 5 ? name[state] : "?";
}

static const char *motion_name(uint8_t state)
{
    static const char *const name[] = {"scenario",     "synchronous", "interpolated",
                                       "extrapolated", "joining",     "snapped"};
    return state < 6 ? name[state] : "?";
}

static orr_wire_status show_clock(watch_job *j, orr_msg_time *t)
{
    const orr_msg_get_time ask = {0};
    char text[ORR_TIME_TEXT];
    const orr_wire_status s = orr_client_get_time(&j->d->client, &ask, t);
    if (s != ORR_WIRE_OK) return s;
    printf("%s GPS  week %d %.3f s  %s by %s", orr_time_text(t->t, text), (int)t->week, (double)t->tow / 1e9,
           state_name(t->state),
           t->reference == ORR_MSG_CLOCK_REFERENCE_RADIO ? "the generator" : "the wall");
    if (t->samples > 0)
        printf("  rate %+.3f ppm, wander %.1f us, %u steps", t->rate * 1e6, t->wander_ns / 1e3,
               (unsigned)t->steps);
    putchar('\n');
    return ORR_WIRE_OK;
}

static orr_wire_status show_motion(watch_job *j)
{
    const orr_msg_get_motion_stats ask = {0};
    orr_msg_motion_stats m;
    const orr_wire_status s = orr_client_get_motion_stats(&j->d->client, &ask, &m);
    if (s == ORR_WIRE_REFUSED) { // it takes none
        j->motion = false;
        return ORR_WIRE_OK;
    }
    if (s != ORR_WIRE_OK) return s;
    printf("motion: %llu received, %llu used, %llu late, %llu dropped; %llu blocks, %llu extrapolated, %llu "
           "joined, %llu snapped\n",
           (unsigned long long)m.received, (unsigned long long)m.used, (unsigned long long)m.late,
           (unsigned long long)m.dropped, (unsigned long long)m.blocks, (unsigned long long)m.extrapolated,
           (unsigned long long)m.joined, (unsigned long long)m.snapped);
    printf("        lateness %.1f / %.1f ms, margin %.1f / %.1f ms (median / 99 %%), worst %s\n",
           (double)m.lateness.p50 / 1e6, (double)m.lateness.p99 / 1e6, (double)m.margin.p50 / 1e6,
           (double)m.margin.p99 / 1e6, motion_name(m.worst));
    return ORR_WIRE_OK;
}

static orr_wire_status show_channels(watch_job *j, orr_time t)
{
    const orr_msg_poll_channels ask = {.epochs = {t, 0, 1}, .antenna = j->antenna, .terms = 1};
    orr_msg_channels m;
    orr_msg_sat_channel c;
    orr_msg_channel_terms x;
    orr_wire_status s = orr_client_poll_channels(&j->d->client, &ask);
    if (s == ORR_WIRE_OK) s = orr_client_channels(&j->d->client, &m);
    if (s != ORR_WIRE_OK) return s;
    if (m.epoch.answer != ORR_MSG_ANSWER_OK) {
        printf("antenna %u: outside the served span\n", (unsigned)j->antenna);
        return ORR_WIRE_OK;
    }
    printf("antenna %u: %u channels, blocks of %.0f ms\n", (unsigned)j->antenna, (unsigned)m.channels.count,
           (double)m.length / 1e6);
    printf("%-4s %-6s %6s %6s %8s %15s %12s %8s %8s\n", "sat", "signal", "az", "el", "C/N0", "code",
           "Doppler", "iono", "tropo");
    printf("%-4s %-6s %6s %6s %8s %15s %12s %8s %8s\n", "", "", "deg", "deg", "dB-Hz", "m", "Hz", "m", "m");
    for (orr_wire_iter i = {0}, k = {0};
         orr_msg_sat_channel_next(&m.channels, &i, &c) && orr_msg_channel_terms_next(&m.terms, &k, &x);)
        printf("%c%02u  %-6s %6.1f %6.1f %8.1f %15.3f %12.2f %8.2f %8.2f\n", c.sat.system,
               (unsigned)c.sat.number, c.signal < 64 ? j->name[c.signal] : "", c.az_rad * ORR_DEG_PER_RAD,
               c.el_rad * ORR_DEG_PER_RAD, (double)c.power_dbw - NOISE_DBW_HZ, c.code[0], -c.carrier[1],
               x.ionosphere_m, x.troposphere_hydrostatic_m + x.troposphere_wet_m + x.turbulence_m);
    return ORR_WIRE_OK;
}

// What happens next.
static orr_wire_status show_events(watch_job *j, orr_time t)
{
    enum { SHOWN = 4 };
    const orr_msg_poll_events ask = {.epochs = {t, 600 * ORR_NS_PER_S, 1}};
    const orr_field *kind =
        orr_record_field(orr_message_rows(orr_message_of(ORR_MSG_TYPE_EVENTS)->record)->record, "kind");
    orr_msg_events m;
    orr_msg_event v;
    char text[ORR_TIME_TEXT], what[ORR_MESSAGE_CELL];
    orr_wire_status s = orr_client_poll_events(&j->d->client, &ask);
    if (s == ORR_WIRE_OK) s = orr_client_events(&j->d->client, &m);
    if (s != ORR_WIRE_OK || m.epoch.answer != ORR_MSG_ANSWER_OK) return s;
    printf("%u events in the next 10 min%s\n", (unsigned)m.events.count, m.events.count > 0 ? ":" : "");
    orr_wire_iter it = {0};
    for (int k = 0; k < SHOWN && orr_msg_event_next(&m.events, &it, &v); k++) {
        printf("  %s ", orr_time_text(v.at, text));
        if (v.sat.number > 0) printf(" %c%02u", v.sat.system, (unsigned)v.sat.number);
        printf(" %s", orr_message_text(kind, &v.kind, true, what));
        if (v.antenna != UINT16_MAX) printf(" (antenna %u)", (unsigned)v.antenna);
        putchar('\n');
    }
    return ORR_WIRE_OK;
}

// The last modes that the service changed over to.
static orr_wire_status show_modes(watch_job *j)
{
    enum { SHOWN = 4 };
    const orr_record *r = orr_message_rows(orr_message_of(ORR_MSG_TYPE_MODES)->record)->record;
    orr_msg_get_modes ask = {.after = UINT64_MAX};
    orr_msg_modes m;
    orr_msg_mode_change x;
    char text[ORR_TIME_TEXT], kind[ORR_MESSAGE_CELL], before[ORR_MESSAGE_CELL], mode[ORR_MESSAGE_CELL];
    orr_wire_status s = orr_client_get_modes(&j->d->client, &ask, &m); // how many there have been
    if (s != ORR_WIRE_OK || m.last == 0) return s;
    ask.after = m.last > SHOWN ? m.last - SHOWN : 0;
    s = orr_client_get_modes(&j->d->client, &ask, &m);
    if (s != ORR_WIRE_OK) return s;
    printf("%llu changes of mode, the last:\n", (unsigned long long)m.last);
    for (orr_wire_iter it = {0}; orr_msg_mode_change_next(&m.changes, &it, &x);)
        printf("  %s  %s: %s, before %s\n", orr_time_text(x.at, text),
               orr_message_text(orr_record_field(r, "kind"), &x.kind, true, kind),
               orr_message_text(orr_record_field(r, "mode"), &x.mode, true, mode),
               orr_message_text(orr_record_field(r, "before"), &x.before, true, before));
    return ORR_WIRE_OK;
}

static orr_wire_status learn(watch_job *j)
{
    orr_msg_caps caps;
    orr_msg_signal g;
    orr_msg_served_request r;
    const orr_wire_status s = orr_client_open(&j->d->client, "orrery watch", ORR_VERSION, &caps);
    if (s != ORR_WIRE_OK) return s;
    for (orr_wire_iter it = {0}; orr_msg_signal_next(&caps.signals, &it, &g);)
        if (g.signal < 64) orr_wire_text_copy(g.name, j->name[g.signal], sizeof j->name[0]);
    for (orr_wire_iter it = {0}; orr_msg_served_request_next(&caps.requests, &it, &r);) {
        j->has_channels = j->has_channels || r.request == ORR_MSG_TYPE_POLL_CHANNELS;
        j->has_events = j->has_events || r.request == ORR_MSG_TYPE_POLL_EVENTS;
    }
    return ORR_WIRE_OK;
}

static int run(orr_cli *c)
{
    watch_job j = {.c = c, .antenna = (uint16_t)orr_cli_int(c, "antenna", 0), .motion = true};
    const int64_t count = orr_cli_int(c, "count", -1), step_ns = orr_cli_duration_ns(c, "step", ORR_NS_PER_S);
    orr_diag diag = {0};
    orr_status status = orr_dial_open(c->operand[0], orr_cli_text(c, "identity", NULL), 10, &j.d, &diag);
    if (status == ORR_E_ARG) return orr_cli_usage(c, "%s", diag.text);
    if (status != ORR_OK) return orr_cli_fail(c, &diag);
    orr_wire_status s = learn(&j);
    for (int64_t k = 0; s == ORR_WIRE_OK && (count < 0 || k < count); k++) {
        orr_msg_time t;
        if (count != 1) fputs("\033[H\033[2J", stdout); // the terminal is cleared
        s = show_clock(&j, &t);
        if (s == ORR_WIRE_OK && j.motion) s = show_motion(&j);
        if (s == ORR_WIRE_OK) s = show_modes(&j);
        if (s == ORR_WIRE_OK && j.has_events) s = show_events(&j, t.t);
        if (s == ORR_WIRE_OK && j.has_channels) s = show_channels(&j, t.t);
        fflush(stdout);
        const struct timespec nap = {step_ns / ORR_NS_PER_S, step_ns % ORR_NS_PER_S};
        if (count < 0 || k + 1 < count) nanosleep(&nap, NULL);
    }
    if (s != ORR_WIRE_OK) (void)orr_dial_status(j.d, s, "what is watched", &diag);
    orr_dial_close(j.d);
    return s == ORR_WIRE_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_IDENTITY(),
    {.name = "antenna",
     .kind = ORR_OPT_INT,
     .value = "K",
     .min = 0,
     .max = 65535,
     .help = "Which antenna's channels; 0 by default."},
    ORR_OPTION_STEP(.help = "How often the table is drawn; every second by default."),
    {.name = "count",
     .letter = 'n',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 1e9,
     .help = "How often; until interrupted by default. Once does not clear the terminal."},
};

const orr_command orr_cmd_watch = {
    .name = "watch",
    .group = "Service",
    .summary = "a live table of a service: clock, motion, channels",
    .operands = "URL",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Shows the scenario's clock and what paces it, what became of the samples of live motion, which "
             "modes the service changed over to last, what happens next, and "
             "the channels of an antenna at "
             "this instant as a poll gives them: azimuth, elevation, C/N0 against the noise of 290 K (-204 "
             "dBW/Hz), code, Doppler, delays.",
    .example = "orrery watch tcp://127.0.0.1:15754",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
