// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_elements.h"

#include "src/cli/service/poll_json.h"

int orr_element_poll_ask(const orr_cli *c, orr_element_poll *out)
{
    *out = (orr_element_poll){.asked = orr_cli_given(c, "elements"), .json = orr_cli_given(c, "json")};
    if (!out->asked && (orr_cli_given(c, "frame") || orr_cli_given(c, "method")))
        return orr_cli_usage(c, "--frame and --method go with --elements");
    out->poll.frame = (uint8_t)orr_elements_frame_of(orr_cli_text(c, "frame", "date"));
    out->poll.method = (uint8_t)orr_elements_method_of(orr_cli_text(c, "method", "state"));
    return ORR_EXIT_OK;
}

static json_t *json_of(const orr_msg_sat_elements *s)
{
    json_t *j = json_object();
    json_object_set_new(j, "sat", orr_poll_json_sat(s->sat));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(s->answer)));
    if (s->answer != ORR_MSG_ANSWER_OK) return j;
    json_object_set_new(j, "flags", orr_poll_json_bits(s->flags, orr_msg_state_flags_name));
    json_object_set_new(j, "a_m", orr_json_number(s->a_m));
    json_object_set_new(j, "e", orr_json_number(s->e));
    json_object_set_new(j, "i_deg", orr_json_number(s->i_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "raan_deg", orr_json_number(s->raan_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "argp_deg", orr_json_number(s->argp_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "m_deg", orr_json_number(s->m_rad * ORR_DEG_PER_RAD));
    json_object_set_new(j, "u_deg", orr_json_number(s->u_rad * ORR_DEG_PER_RAD));
    return j;
}

static void print_json(const orr_msg_elements *m)
{
    json_t *j = json_object(), *sats = json_array();
    json_object_set_new(j, "t", orr_json_time(m->epoch.t));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(m->epoch.answer)));
    json_object_set_new(j, "frame", orr_json_text(orr_msg_elements_frame_name(m->frame)));
    json_object_set_new(j, "method", orr_json_text(orr_msg_elements_method_name(m->method)));
    orr_msg_sat_elements s;
    for (orr_wire_iter it = {0}; orr_msg_sat_elements_next(&m->satellites, &it, &s);)
        json_array_append_new(sats, json_of(&s));
    json_object_set_new(j, "satellites", sats);
    orr_poll_json_print(j);
}

static void print_csv(orr_element_poll *p, const orr_msg_elements *m)
{
    if (!p->headed) orr_elements_csv_head(stdout);
    p->headed = true;
    orr_msg_sat_elements s;
    for (orr_wire_iter it = {0}; orr_msg_sat_elements_next(&m->satellites, &it, &s);) {
        const orr_kepler k = {.a_m = s.a_m,
                              .e = s.e,
                              .i_rad = s.i_rad,
                              .raan_rad = s.raan_rad,
                              .argp_rad = s.argp_rad,
                              .m_rad = s.m_rad,
                              .u_rad = s.u_rad};
        char name[8];
        orr_elements_csv_row(stdout, m->epoch.t, orr_poll_sat_name(s.sat, name),
                             s.answer == ORR_MSG_ANSWER_OK ? &k : NULL);
    }
}

orr_status orr_element_poll_run(orr_element_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag)
{
    p->poll.epochs.t = t;
    p->poll.epochs.count = count;
    orr_wire_status ws = orr_client_poll_elements(&d->client, &p->poll);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK; k++) {
        orr_msg_elements m;
        ws = orr_client_elements(&d->client, &m);
        if (ws == ORR_WIRE_OK && (m.epoch.index != k || m.epoch.count != count)) ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) break;
        p->outside = p->outside || m.epoch.answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_sat_elements s;
        for (orr_wire_iter it = {0}; orr_msg_sat_elements_next(&m.satellites, &it, &s);)
            p->numbers += s.answer == ORR_MSG_ANSWER_OK;
        if (p->json)
            print_json(&m);
        else
            print_csv(p, &m);
    }
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(d, ws, "POLL_ELEMENTS", diag);
}
