// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_ask.h"

#include "core/earth.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_nav.h"

static int ask_delays(const orr_cli *c, orr_poll_request *out)
{
    orr_msg_poll_delays *poll = &out->m.poll_delays;
    const size_t n = orr_cli_count(c, "carrier");
    if (n > ORR_MSG_MAX_CARRIERS)
        return orr_cli_usage(c, "%zu carriers; %u are the limit", n, ORR_MSG_MAX_CARRIERS);
    for (size_t i = 0; i < n; i++) out->hz[i] = orr_cli_real_at(c, "carrier", i) * 1e6;
    poll->carriers_hz.count = (uint16_t)n;
    poll->carriers_hz.item = out->hz;
    for (int k = 0; k < 3; k++) poll->receiver_m[k] = ORR_NAN;
    orr_geodetic place;
    if (!orr_cli_place(c, "receiver", &place)) return ORR_EXIT_OK;
    const orr_vec3 r = orr_earth_to_ecef(place);
    poll->receiver_m[0] = r.x;
    poll->receiver_m[1] = r.y;
    poll->receiver_m[2] = r.z;
    return ORR_EXIT_OK;
}

static int ask_elements(const orr_cli *c, orr_poll_request *out)
{
    out->m.poll_elements.frame = (uint8_t)orr_elements_frame_of(orr_cli_text(c, "frame", "date"));
    out->m.poll_elements.method = (uint8_t)orr_elements_method_of(orr_cli_text(c, "method", "state"));
    return ORR_EXIT_OK;
}

static int ask_navdata(const orr_cli *c, orr_poll_request *out)
{
    orr_diag diag = {0};
    const char *list = orr_cli_text(c, "message", NULL);
    out->pages = orr_cli_given(c, "pages");
    out->m.poll_navdata.form = orr_cli_given(c, "symbols") ? ORR_MSG_NAV_FORM_SYMBOLS : ORR_MSG_NAV_FORM_BITS;
    if (list != NULL && orr_nav_messages_parse(list, &out->m.poll_navdata.kinds, &diag) != ORR_OK)
        return orr_cli_usage(c, "--message: %s", diag.text);
    return ORR_EXIT_OK;
}

static int ask_channels(const orr_cli *c, orr_poll_request *out)
{
    out->m.poll_channels.antenna = (uint16_t)orr_cli_int(c, "antenna", 0);
    out->m.poll_channels.terms = orr_cli_given(c, "terms");
    return ORR_EXIT_OK;
}

static int ask_nothing(const orr_cli *c, orr_poll_request *out)
{
    (void)c, (void)out;
    return ORR_EXIT_OK;
}

static int ask_imu(const orr_cli *c, orr_poll_request *out)
{
    out->m.poll_imu.unit = (uint16_t)orr_cli_int(c, "unit", 0);
    return ORR_EXIT_OK;
}

static int ask_truth(const orr_cli *c, orr_poll_request *out)
{
    out->m.poll_truth.unit = (uint16_t)orr_cli_int(c, "unit", 0);
    return ORR_EXIT_OK;
}

// What can be asked for beside states: the option, its request, and how the options that go with it are read.
static const struct {
    const char *option;
    uint16_t type;
    const char *what;
    int (*ask)(const orr_cli *c, orr_poll_request *out);
} kinds[] = {
    {"channels", ORR_MSG_TYPE_POLL_CHANNELS, "a channel", ask_channels},
    {"delays", ORR_MSG_TYPE_POLL_DELAYS, "a delay", ask_delays},
    {"elements", ORR_MSG_TYPE_POLL_ELEMENTS, "elements", ask_elements},
    {"events", ORR_MSG_TYPE_POLL_EVENTS, "an event", ask_nothing},
    {"imu", ORR_MSG_TYPE_POLL_IMU, "readings", ask_imu},
    {"navdata", ORR_MSG_TYPE_POLL_NAVDATA, "broadcast data", ask_navdata},
    {"truth", ORR_MSG_TYPE_POLL_TRUTH, "motion", ask_truth},
};
int orr_poll_ask(const orr_cli *c, orr_poll_request *out)
{
    out->info = orr_message_of(ORR_MSG_TYPE_POLL);
    out->what = "a state";
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (!orr_cli_given(c, kinds[i].option)) continue; // one at most, says the table of options
        out->info = orr_message_of(kinds[i].type);
        out->what = kinds[i].what;
        return kinds[i].ask(c, out);
    }
    return ORR_EXIT_OK;
}
