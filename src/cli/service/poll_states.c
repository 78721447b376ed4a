// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_states.h"

#include <stdio.h>

#include "src/cli/service/poll_json.h"

static json_t *json_sat(const orr_msg_sat_state *s)
{
    json_t *j = json_object();
    json_object_set_new(j, "sat", orr_poll_json_sat(s->sat));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(s->answer)));
    if (s->answer != ORR_MSG_ANSWER_OK) return j;
    json_object_set_new(j, "flags", orr_poll_json_bits(s->flags, orr_msg_state_flags_name));
    json_object_set_new(j, "pos_m", orr_poll_json_vector(s->pos_m, 3));
    json_object_set_new(j, "vel_mps", orr_poll_json_vector(s->vel_mps, 3));
    json_object_set_new(j, "acc_mps2", orr_poll_json_vector(s->acc_mps2, 3));
    json_object_set_new(j, "clock_s", orr_json_number(s->clock_s));
    json_object_set_new(j, "clock_rate_sps", orr_json_number(s->clock_rate_sps));
    json_object_set_new(j, "sigma_m", orr_json_number((double)s->sigma_m));
    json_object_set_new(j, "valid_from", orr_json_time(s->valid_from));
    json_object_set_new(j, "valid_to", orr_json_time(s->valid_to));
    return j;
}

static void print_json(const orr_msg_states *m)
{
    json_t *j = json_object(), *sats = json_array();
    json_object_set_new(j, "t", orr_json_time(m->epoch.t));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(m->epoch.answer)));
    orr_msg_sat_state s;
    orr_wire_iter it = {0};
    while (orr_msg_sat_state_next(&m->satellites, &it, &s)) json_array_append_new(sats, json_sat(&s));
    json_object_set_new(j, "satellites", sats);
    orr_poll_json_print(j);
}

static void print_flags(uint32_t flags)
{
    static const char *const word[] = {NULL, "predicted", "manoeuvre", "clock event", "eclipse", "gap"};
    const char *between = " ";
    for (unsigned bit = 1; bit < sizeof word / sizeof word[0]; bit++) {
        if ((flags >> bit & 1u) == 0) continue;
        printf("%s %s", between, word[bit]);
        between = ",";
    }
}

static void print_table(const orr_state_poll *p, const orr_msg_states *m)
{
    char text[ORR_TIME_TEXT], name[8];
    printf("%s GPS", orr_time_text(m->epoch.t, text));
    if (m->epoch.answer != ORR_MSG_ANSWER_OK) {
        printf("  %s\n", orr_poll_answer_words(m->epoch.answer));
        return;
    }
    printf("  %u satellites, %s\n", (unsigned)m->satellites.count, p->frame);
    printf("%-3s %15s %15s %15s %11s %11s %11s %14s %6s\n", "sat", "x m", "y m", "z m", "vx m/s", "vy m/s",
           "vz m/s", "clock us", "mm");
    orr_msg_sat_state s;
    orr_wire_iter it = {0};
    while (orr_msg_sat_state_next(&m->satellites, &it, &s)) {
        printf("%-3s", orr_poll_sat_name(s.sat, name));
        if (s.answer != ORR_MSG_ANSWER_OK) {
            printf("  %s\n", orr_poll_answer_words(s.answer));
            continue;
        }
        printf(" %15.4f %15.4f %15.4f %11.5f %11.5f %11.5f", s.pos_m[0], s.pos_m[1], s.pos_m[2], s.vel_mps[0],
               s.vel_mps[1], s.vel_mps[2]);
        if ((s.flags & ORR_MSG_STATE_FLAGS_CLOCK_VALID) != 0)
            printf(" %14.6f", 1e6 * s.clock_s);
        else
            printf(" %14s", "-");
        printf(" %6.1f", 1e3 * (double)s.sigma_m);
        print_flags(s.flags);
        putchar('\n');
    }
}

orr_status orr_state_poll_run(orr_state_poll *p, orr_dial *d, const orr_msg_poll *poll, orr_diag *diag)
{
    orr_wire_status ws = orr_client_poll(&d->client, poll);
    for (uint32_t k = 0; k < poll->epochs.count && ws == ORR_WIRE_OK; k++) {
        orr_msg_states m;
        ws = orr_client_states(&d->client, &m);
        if (ws == ORR_WIRE_OK && (m.epoch.index != k || m.epoch.count != poll->epochs.count))
            ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) break;
        p->outside = p->outside || m.epoch.answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_sat_state s;
        orr_wire_iter it = {0};
        while (orr_msg_sat_state_next(&m.satellites, &it, &s)) p->numbers += s.answer == ORR_MSG_ANSWER_OK;
        if (p->json)
            print_json(&m);
        else
            print_table(p, &m);
    }
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(d, ws, "POLL", diag);
}
