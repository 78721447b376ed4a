// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_delays.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/earth.h"
#include "core/nan.h"
#include "src/cli/service/poll_json.h"

int orr_delay_poll_ask(const orr_cli *c, orr_delay_poll *out)
{
    size_t n = orr_cli_count(c, "carrier");
    out->asked = orr_cli_given(c, "delays");
    if (!out->asked) {
        if (n > 0 || orr_cli_given(c, "receiver"))
            return orr_cli_usage(c, "--receiver and --carrier go with --delays");
        return ORR_EXIT_OK;
    }
    if (n > ORR_MSG_MAX_CARRIERS)
        return orr_cli_usage(c, "%zu carriers; %u are the limit", n, ORR_MSG_MAX_CARRIERS);
    for (size_t i = 0; i < n; i++) {
        const char *mhz = orr_cli_text_at(c, "carrier", i);
        char *rest;
        out->hz[i] = strtod(mhz, &rest) * 1e6;
        if (rest == mhz || *rest != '\0' || !(out->hz[i] >= 1e8 && out->hz[i] <= 3e10))
            return orr_cli_usage(c, "--carrier \"%s\" is no frequency of 100 to 30000 MHz", mhz);
    }
    out->poll.carriers_hz.count = (uint16_t)n;
    out->poll.carriers_hz.item = out->hz;
    for (int k = 0; k < 3; k++) out->poll.receiver_m[k] = ORR_NAN;
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
    out->poll.receiver_m[0] = r.x;
    out->poll.receiver_m[1] = r.y;
    out->poll.receiver_m[2] = r.z;
    return ORR_EXIT_OK;
}

static json_t *json_of(const orr_msg_sat_delay *s, uint16_t n_hz)
{
    json_t *j = json_object();
    json_object_set_new(j, "sat", orr_poll_json_sat(s->sat));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(s->answer)));
    if (s->answer != ORR_MSG_ANSWER_OK) return j;
    json_object_set_new(j, "origin", orr_json_text(orr_msg_tec_origin_name(s->origin)));
    json_object_set_new(j, "flags", orr_poll_json_bits(s->flags, orr_msg_delay_flags_name));
    json_object_set_new(j, "az_deg", orr_json_number(s->az_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "el_deg", orr_json_number(s->el_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "pierce_lat_deg", orr_json_number(s->pierce_lat_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "pierce_lon_deg", orr_json_number(s->pierce_lon_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "mapping", orr_json_number(s->mapping));
    json_object_set_new(j, "stec_tecu", orr_json_number(s->stec_tecu));
    json_object_set_new(j, "model_stec_tecu", orr_json_number(s->model_stec_tecu));
    json_object_set_new(j, "sigma_tecu", orr_json_number((double)s->sigma_tecu));
    json_object_set_new(j, "delay_m", orr_poll_json_vector(s->delay_m, n_hz < 4 ? n_hz : 4));
    return j;
}

static void print_json(const orr_msg_delays *m)
{
    json_t *j = json_object(), *sats = json_array(), *carriers = json_array();
    json_object_set_new(j, "t", orr_json_time(m->epoch.t));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(m->epoch.answer)));
    double hz;
    for (orr_wire_iter it = {0}; orr_msg_f64_next(&m->carriers_hz, &it, &hz);)
        json_array_append_new(carriers, orr_json_number(hz));
    json_object_set_new(j, "receiver_m", orr_poll_json_vector(m->receiver_m, 3));
    json_object_set_new(j, "carriers_hz", carriers);
    orr_msg_sat_delay s;
    for (orr_wire_iter it = {0}; orr_msg_sat_delay_next(&m->satellites, &it, &s);)
        json_array_append_new(sats, json_of(&s, m->carriers_hz.count));
    json_object_set_new(j, "satellites", sats);
    orr_poll_json_print(j);
}

static const char *answer_words(uint8_t answer)
{
    return answer == ORR_MSG_ANSWER_NO_VALUE ? "a hole in the ionosphere's maps"
                                             : orr_poll_answer_words(answer);
}

static void print_table(const orr_msg_delays *m)
{
    static const char *const from[] = {"field", "fused", "transferred", "noise"};
    char text[ORR_TIME_TEXT];
    printf("%s GPS  ", orr_time_text(m->epoch.t, text));
    if (m->epoch.answer != ORR_MSG_ANSWER_OK) {
        puts(answer_words(m->epoch.answer));
        return;
    }
    orr_geodetic g = orr_earth_from_ecef((orr_vec3){m->receiver_m[0], m->receiver_m[1], m->receiver_m[2]});
    printf("receiver at %.6f, %.6f, %.1f m\n%-3s %8s %8s %9s %9s %10s %8s", g.lat_rad * ORR_DEG_PER_RAD,
           g.lon_rad * ORR_DEG_PER_RAD, g.height_m, "sat", "az deg", "el deg", "lat deg", "lon deg", "TECU",
           "+-");
    double hz;
    for (orr_wire_iter it = {0}; orr_msg_f64_next(&m->carriers_hz, &it, &hz);) printf(" m@%-8.2f", hz / 1e6);
    puts("  from");
    unsigned below = 0;
    orr_msg_sat_delay s;
    for (orr_wire_iter it = {0}; orr_msg_sat_delay_next(&m->satellites, &it, &s);) {
        if (s.answer == ORR_MSG_ANSWER_BELOW_HORIZON) {
            below++;
            continue;
        }
        printf("%c%02u", s.sat.system, (unsigned)s.sat.number);
        if (s.answer != ORR_MSG_ANSWER_OK) {
            printf("  %s\n", answer_words(s.answer));
            continue;
        }
        printf(" %8.2f %8.2f %9.3f %9.3f %10.3f", s.az_rad * ORR_DEG_PER_RAD, s.el_rad * ORR_DEG_PER_RAD,
               s.pierce_lat_rad * ORR_DEG_PER_RAD, s.pierce_lon_rad * ORR_DEG_PER_RAD, s.stec_tecu);
        if (isnan(s.sigma_tecu))
            printf(" %8s", "-");
        else
            printf(" %8.3f", (double)s.sigma_tecu);
        for (uint16_t k = 0; k < m->carriers_hz.count && k < 4; k++) printf(" %10.4f", s.delay_m[k]);
        printf("  %s%s\n", s.origin < 4 ? from[s.origin] : "?",
               (s.flags & ORR_MSG_DELAY_FLAGS_CLIPPED) != 0 ? ", clipped at 0" : "");
    }
    if (below > 0) printf("%u more below the horizon\n", below);
}

orr_status orr_delay_poll_run(orr_delay_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag)
{
    p->poll.epochs.t = t;
    p->poll.epochs.count = count;
    orr_wire_status ws = orr_client_poll_delays(&d->client, &p->poll);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK; k++) {
        orr_msg_delays m;
        ws = orr_client_delays(&d->client, &m);
        if (ws == ORR_WIRE_OK && (m.epoch.index != k || m.epoch.count != count)) ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) break;
        p->outside = p->outside || m.epoch.answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_sat_delay s;
        for (orr_wire_iter it = {0}; orr_msg_sat_delay_next(&m.satellites, &it, &s);)
            p->numbers += s.answer == ORR_MSG_ANSWER_OK;
        if (p->json)
            print_json(&m);
        else
            print_table(&m);
    }
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(d, ws, "POLL_DELAYS", diag);
}
