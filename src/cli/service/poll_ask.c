// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_ask.h"

#include <math.h>
#include <stdlib.h>

#include "core/earth.h"
#include "core/nan.h"

static int ask_delays(const orr_cli *c, orr_poll_request *out)
{
    orr_msg_poll_delays *poll = &out->m.poll_delays;
    size_t n = orr_cli_count(c, "carrier");
    if (n > ORR_MSG_MAX_CARRIERS)
        return orr_cli_usage(c, "%zu carriers; %u are the limit", n, ORR_MSG_MAX_CARRIERS);
    for (size_t i = 0; i < n; i++) {
        const char *mhz = orr_cli_text_at(c, "carrier", i);
        char *rest;
        out->hz[i] = strtod(mhz, &rest) * 1e6;
        if (rest == mhz || *rest != '\0' || !(out->hz[i] >= 1e8 && out->hz[i] <= 3e10))
            return orr_cli_usage(c, "--carrier \"%s\" is no frequency of 100 to 30000 MHz", mhz);
    }
    poll->carriers_hz.count = (uint16_t)n;
    poll->carriers_hz.item = out->hz;
    for (int k = 0; k < 3; k++) poll->receiver_m[k] = ORR_NAN;
    const char *text = orr_cli_text(c, "receiver", NULL);
    if (text == NULL) return ORR_EXIT_OK;
    double v[3];
    char *end = NULL;
    const char *at = text;
    for (int k = 0; k < 3; k++) {
        v[k] = strtod(at, &end);
        if (end == at || *end != (k < 2 ? ',' : '\0') || !isfinite(v[k]))
            return orr_cli_usage(c, "--receiver \"%s\" is no LAT,LON,H", text);
        at = end + 1;
    }
    if (fabs(v[0]) > 90 || fabs(v[1]) > 360)
        return orr_cli_usage(c, "--receiver \"%s\": no such latitude or longitude", text);
    orr_vec3 r = orr_earth_to_ecef((orr_geodetic){v[0] * ORR_RAD_PER_DEG, v[1] * ORR_RAD_PER_DEG, v[2]});
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
    out->pages = orr_cli_given(c, "pages");
    if (out->pages && orr_cli_given(c, "json"))
        return orr_cli_usage(c, "--json holds the pages; --pages is CSV");
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
    {"delays", ORR_MSG_TYPE_POLL_DELAYS, "a delay", ask_delays},
    {"elements", ORR_MSG_TYPE_POLL_ELEMENTS, "elements", ask_elements},
    {"imu", ORR_MSG_TYPE_POLL_IMU, "readings", ask_imu},
    {"navdata", ORR_MSG_TYPE_POLL_NAVDATA, "broadcast data", ask_navdata},
    {"truth", ORR_MSG_TYPE_POLL_TRUTH, "motion", ask_truth},
};
// Options that go with one kind, or with either of two.
static const struct {
    const char *option, *kind, *or_kind;
} belongs[] = {
    {"receiver", "delays", NULL}, {"carrier", "delays", NULL}, {"frame", "elements", NULL},
    {"method", "elements", NULL}, {"pages", "navdata", NULL},  {"unit", "imu", "truth"},
};

int orr_poll_ask(const orr_cli *c, orr_poll_request *out)
{
    size_t n = 0, which = 0;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (orr_cli_given(c, kinds[i].option)) {
            which = i;
            n++;
        }
    if (n > 1)
        return orr_cli_usage(c, "--delays, --elements, --navdata, --imu and --truth exclude each other");
    for (size_t i = 0; i < sizeof belongs / sizeof belongs[0]; i++) {
        bool alone = !orr_cli_given(c, belongs[i].kind) &&
                     (belongs[i].or_kind == NULL || !orr_cli_given(c, belongs[i].or_kind));
        if (orr_cli_given(c, belongs[i].option) && alone)
            return orr_cli_usage(c, "--%s goes with --%s%s%s", belongs[i].option, belongs[i].kind,
                                 belongs[i].or_kind != NULL ? " or --" : "",
                                 belongs[i].or_kind != NULL ? belongs[i].or_kind : "");
    }
    out->info = orr_message_of(n > 0 ? kinds[which].type : ORR_MSG_TYPE_POLL);
    out->what = n > 0 ? kinds[which].what : "a state";
    if (n > 0 && orr_record_field(out->info->record, "satellites") == NULL && orr_cli_given(c, "sat"))
        return orr_cli_usage(c, "--sat does not go with --%s", kinds[which].option);
    return n > 0 ? kinds[which].ask(c, out) : ORR_EXIT_OK;
}
