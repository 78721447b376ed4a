// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_navdata.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "src/cli/service/poll_json.h"

int orr_navdata_poll_ask(const orr_cli *c, orr_navdata_poll *out)
{
    *out = (orr_navdata_poll){.asked = orr_cli_given(c, "navdata"),
                              .pages = orr_cli_given(c, "pages"),
                              .json = orr_cli_given(c, "json")};
    if (!out->asked && out->pages) return orr_cli_usage(c, "--pages goes with --navdata");
    if (out->pages && out->json) return orr_cli_usage(c, "--json holds the pages; --pages is CSV");
    return ORR_EXIT_OK;
}

// --- Numbers by name: the columns of the CSV and the keys of the JSON are the wire's own names ---

typedef struct column {
    const char *name;
    size_t offset;
} column;

#define OF(type, member)                                                                                     \
    {                                                                                                        \
#member, offsetof(type, member)                                                                      \
    }
static const column common[] = {
    OF(orr_msg_sat_navdata, accuracy_m), OF(orr_msg_sat_navdata, fit_rms_m),
    OF(orr_msg_sat_navdata, fit_max_m),  OF(orr_msg_sat_navdata, clock_rms_s),
    OF(orr_msg_sat_navdata, af0_s),      OF(orr_msg_sat_navdata, af1_sps),
    OF(orr_msg_sat_navdata, af2_sps2),
};
static const column kepler[] = {
    OF(orr_msg_lnav_set, sqrt_a_sqrtm),    OF(orr_msg_lnav_set, e),
    OF(orr_msg_lnav_set, m0_rad),          OF(orr_msg_lnav_set, i0_rad),
    OF(orr_msg_lnav_set, omega0_rad),      OF(orr_msg_lnav_set, omega_rad),
    OF(orr_msg_lnav_set, delta_n_radps),   OF(orr_msg_lnav_set, idot_radps),
    OF(orr_msg_lnav_set, omega_dot_radps), OF(orr_msg_lnav_set, cuc_rad),
    OF(orr_msg_lnav_set, cus_rad),         OF(orr_msg_lnav_set, crc_m),
    OF(orr_msg_lnav_set, crs_m),           OF(orr_msg_lnav_set, cic_rad),
    OF(orr_msg_lnav_set, cis_rad),         OF(orr_msg_lnav_set, tgd_s),
};
static const column glonass[] = {
    {"x_m", offsetof(orr_msg_glonass_set, pos_m)},
    {"y_m", offsetof(orr_msg_glonass_set, pos_m) + sizeof(double)},
    {"z_m", offsetof(orr_msg_glonass_set, pos_m) + 2 * sizeof(double)},
    {"vx_mps", offsetof(orr_msg_glonass_set, vel_mps)},
    {"vy_mps", offsetof(orr_msg_glonass_set, vel_mps) + sizeof(double)},
    {"vz_mps", offsetof(orr_msg_glonass_set, vel_mps) + 2 * sizeof(double)},
    {"ax_mps2", offsetof(orr_msg_glonass_set, acc_mps2)},
    {"ay_mps2", offsetof(orr_msg_glonass_set, acc_mps2) + sizeof(double)},
    {"az_mps2", offsetof(orr_msg_glonass_set, acc_mps2) + 2 * sizeof(double)},
    OF(orr_msg_glonass_set, delta_tau_s),
};
#define COUNT(a) (sizeof(a) / sizeof(a)[0])

static double value_of(const void *record, const column *c)
{
    double v;
    memcpy(&v, (const char *)record + c->offset, sizeof v);
    return v;
}

// --- CSV ---

static void head_of(const column *c, size_t n)
{
    for (size_t i = 0; i < n; i++) printf(",%s", c[i].name);
}

// Shortest digits that read back as the same number; a blank cell where there is none.
static void cells_of(const void *record, const column *c, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        double v = record != NULL ? value_of(record, &c[i]) : ORR_NAN;
        if (isfinite(v))
            printf(",%.17g", v);
        else
            putchar(',');
    }
}

static void time_cell(orr_time t)
{
    char text[ORR_TIME_TEXT];
    printf(",%s", t == ORR_TIME_NONE ? "" : orr_time_text(t, text));
}

static void notes_cell(uint32_t notes)
{
    const char *between = "";
    putchar(',');
    for (unsigned bit = 0; bit < 32; bit++)
        if ((notes >> bit & 1u) != 0 && orr_msg_nav_notes_name(bit) != NULL) {
            printf("%s%s", between, orr_msg_nav_notes_name(bit));
            between = " ";
        }
}

static void print_sets(orr_navdata_poll *p, const orr_msg_navdata *m)
{
    if (!p->headed) {
        fputs("t_gps,sat,message,set_from,set_to,toe,toc,week,iode,iodc,health,notes", stdout);
        head_of(common, COUNT(common));
        head_of(kepler, COUNT(kepler));
        head_of(glonass, COUNT(glonass));
        puts(",channel");
    }
    p->headed = true;
    orr_msg_sat_navdata s;
    for (orr_wire_iter it = {0}; orr_msg_sat_navdata_next(&m->satellites, &it, &s);) {
        char time[ORR_TIME_TEXT], name[8];
        orr_msg_lnav_set k;
        orr_msg_glonass_set g;
        bool is_kepler = orr_msg_lnav_set_at(&s.kepler, 0, &k);
        bool is_glonass = orr_msg_glonass_set_at(&s.glonass, 0, &g);
        bool ok = s.answer == ORR_MSG_ANSWER_OK;
        const char *message = ok ? orr_msg_nav_message_name(s.message) : NULL;
        printf("%s,%s,%s", orr_time_text(m->epoch.t, time), orr_poll_sat_name(s.sat, name),
               message != NULL ? message : "");
        time_cell(s.set_from);
        time_cell(s.set_to);
        time_cell(s.toe);
        time_cell(s.toc);
        if (is_kepler)
            printf(",%ld,%d,%d", (long)s.week, s.iode, s.iodc);
        else
            fputs(",,,", stdout);
        if (ok)
            printf(",%lu", (unsigned long)s.health);
        else
            putchar(',');
        notes_cell(s.notes);
        cells_of(&s, common, COUNT(common));
        cells_of(is_kepler ? &k : NULL, kepler, COUNT(kepler));
        cells_of(is_glonass ? &g : NULL, glonass, COUNT(glonass));
        if (is_glonass)
            printf(",%d\n", g.channel);
        else
            puts(",");
    }
}

static void print_hex(orr_wire_bytes data)
{
    for (uint16_t i = 0; i < data.size; i++) printf("%02x", data.data[i]);
}

static void print_pages(orr_navdata_poll *p, const orr_msg_navdata *m)
{
    if (!p->headed) puts("t_gps,sat,message,number,page,bits,hex");
    p->headed = true;
    orr_msg_sat_navdata s;
    for (orr_wire_iter it = {0}; orr_msg_sat_navdata_next(&m->satellites, &it, &s);) {
        orr_msg_nav_page page;
        for (orr_wire_iter at = {0}; orr_msg_nav_page_next(&s.pages, &at, &page);) {
            char time[ORR_TIME_TEXT], name[8];
            const char *message = orr_msg_nav_message_name(s.message);
            printf("%s,%s,%s,%u,%u,%u,", orr_time_text(page.t, time), orr_poll_sat_name(s.sat, name),
                   message != NULL ? message : "", page.number, page.page, page.bits);
            print_hex(page.data);
            putchar('\n');
        }
    }
}

// --- JSON ---

static void set_all(json_t *j, const void *record, const column *c, size_t n)
{
    for (size_t i = 0; i < n; i++)
        json_object_set_new(j, c[i].name, orr_json_number(value_of(record, &c[i])));
}

static json_t *json_of_page(const orr_msg_nav_page *page)
{
    char hex[2 * 38 + 1] = "";
    for (uint16_t i = 0; i < page->data.size && i < 38; i++)
        snprintf(hex + 2 * i, 3, "%02x", page->data.data[i]);
    json_t *j = json_object();
    json_object_set_new(j, "t", orr_json_time(page->t));
    json_object_set_new(j, "number", json_integer(page->number));
    json_object_set_new(j, "page", json_integer(page->page));
    json_object_set_new(j, "bits", json_integer(page->bits));
    json_object_set_new(j, "hex", json_string(hex));
    return j;
}

static json_t *json_of(const orr_msg_sat_navdata *s)
{
    json_t *j = json_object(), *pages = json_array(), *orbit = json_object();
    json_object_set_new(j, "sat", orr_poll_json_sat(s->sat));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(s->answer)));
    if (s->answer != ORR_MSG_ANSWER_OK) {
        json_decref(pages);
        json_decref(orbit);
        return j;
    }
    json_object_set_new(j, "message", orr_json_text(orr_msg_nav_message_name(s->message)));
    json_object_set_new(j, "notes", orr_poll_json_bits(s->notes, orr_msg_nav_notes_name));
    json_object_set_new(j, "set_from", orr_json_time(s->set_from));
    json_object_set_new(j, "set_to", orr_json_time(s->set_to));
    json_object_set_new(j, "toe", orr_json_time(s->toe));
    json_object_set_new(j, "toc", orr_json_time(s->toc));
    json_object_set_new(j, "health", json_integer(s->health));
    set_all(j, s, common, COUNT(common));
    orr_msg_lnav_set k;
    orr_msg_glonass_set g;
    if (orr_msg_lnav_set_at(&s->kepler, 0, &k)) {
        json_object_set_new(j, "week", json_integer(s->week));
        json_object_set_new(j, "iode", json_integer(s->iode));
        json_object_set_new(j, "iodc", json_integer(s->iodc));
        set_all(orbit, &k, kepler, COUNT(kepler));
        json_object_set(j, "kepler", orbit);
    } else if (orr_msg_glonass_set_at(&s->glonass, 0, &g)) {
        json_object_set_new(orbit, "pos_m", orr_poll_json_vector(g.pos_m, 3));
        json_object_set_new(orbit, "vel_mps", orr_poll_json_vector(g.vel_mps, 3));
        json_object_set_new(orbit, "acc_mps2", orr_poll_json_vector(g.acc_mps2, 3));
        json_object_set_new(orbit, "delta_tau_s", orr_json_number(g.delta_tau_s));
        json_object_set_new(orbit, "channel", json_integer(g.channel));
        json_object_set(j, "glonass", orbit);
    }
    json_decref(orbit);
    json_object_set_new(j, "frame_from", orr_json_time(s->frame_from));
    json_object_set_new(j, "frame_to", orr_json_time(s->frame_to));
    orr_msg_nav_page page;
    for (orr_wire_iter it = {0}; orr_msg_nav_page_next(&s->pages, &it, &page);)
        json_array_append_new(pages, json_of_page(&page));
    json_object_set_new(j, "pages", pages);
    return j;
}

static void print_json(const orr_msg_navdata *m)
{
    json_t *j = json_object(), *sats = json_array();
    json_object_set_new(j, "t", orr_json_time(m->epoch.t));
    json_object_set_new(j, "answer", orr_json_text(orr_msg_answer_name(m->epoch.answer)));
    orr_msg_sat_navdata s;
    for (orr_wire_iter it = {0}; orr_msg_sat_navdata_next(&m->satellites, &it, &s);)
        json_array_append_new(sats, json_of(&s));
    json_object_set_new(j, "satellites", sats);
    orr_poll_json_print(j);
}

orr_status orr_navdata_poll_run(orr_navdata_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag)
{
    p->poll.epochs.t = t;
    p->poll.epochs.count = count;
    orr_wire_status ws = orr_client_poll_navdata(&d->client, &p->poll);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK; k++) {
        orr_msg_navdata m;
        ws = orr_client_navdata(&d->client, &m);
        if (ws == ORR_WIRE_OK && (m.epoch.index != k || m.epoch.count != count)) ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) break;
        p->outside = p->outside || m.epoch.answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_sat_navdata s;
        for (orr_wire_iter it = {0}; orr_msg_sat_navdata_next(&m.satellites, &it, &s);)
            p->numbers += s.answer == ORR_MSG_ANSWER_OK;
        if (p->json)
            print_json(&m);
        else if (p->pages)
            print_pages(p, &m);
        else
            print_sets(p, &m);
    }
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(d, ws, "POLL_NAVDATA", diag);
}
