// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_navdata.h"

#include <math.h>
#include <stdio.h>

#include "src/service/answers/answers_private.h"

_Static_assert((uint32_t)ORR_NAVSET_MANOEUVRE == ORR_MSG_NAV_NOTES_MANOEUVRE &&
                   (uint32_t)ORR_NAVSET_SHIFTED == ORR_MSG_NAV_NOTES_SHIFTED &&
                   (uint32_t)ORR_NAVSET_NO_CLOCK == ORR_MSG_NAV_NOTES_NO_CLOCK &&
                   (uint32_t)ORR_NAVSET_NO_ANTENNA == ORR_MSG_NAV_NOTES_NO_ANTENNA &&
                   (uint32_t)ORR_NAVSET_NO_DELAY == ORR_MSG_NAV_NOTES_NO_DELAY &&
                   (uint32_t)ORR_NAVSET_NOMINAL_CHANNEL == ORR_MSG_NAV_NOTES_NOMINAL_CHANNEL &&
                   (uint32_t)ORR_NAVSET_CLOCK_JUMP == ORR_MSG_NAV_NOTES_CLOCK_JUMP,
               "the navset's notes are the wire's");
_Static_assert(ORR_MSG_MAX_PAGES == ORR_NAVFRAME_PIECES, "one list holds a frame");

uint16_t orr_answers_begin_navdata(void *user, const orr_msg_poll_navdata *poll, orr_server_refusal *why)
{
    const orr_answers *a = user;
    uint16_t code = orr_answers_check_epochs("POLL_NAVDATA", &poll->epochs, why);
    if (code != 0) return code;
    const char *none = orr_engine_no_navdata(a->engine);
    if (none != NULL) {
        snprintf(why->sentence, sizeof why->sentence, "POLL_NAVDATA: %.220s", none);
        return ORR_MSG_ERROR_CODE_NOT_SERVED;
    }
    return 0;
}

static void fill_lnav(const orr_nav_eph *eph, orr_msg_lnav_set *m)
{
    const orr_nav_kepler *k = &eph->kepler;
    *m = (orr_msg_lnav_set){.sqrt_a_sqrtm = k->sqrt_a_sqrtm,
                            .e = k->e,
                            .m0_rad = k->m0_rad,
                            .i0_rad = k->i0_rad,
                            .omega0_rad = k->omega0_rad,
                            .omega_rad = k->omega_rad,
                            .delta_n_radps = k->delta_n_radps,
                            .idot_radps = k->idot_radps,
                            .omega_dot_radps = k->omega_dot_radps,
                            .cuc_rad = k->cuc_rad,
                            .cus_rad = k->cus_rad,
                            .crc_m = k->crc_m,
                            .crs_m = k->crs_m,
                            .cic_rad = k->cic_rad,
                            .cis_rad = k->cis_rad,
                            .tgd_s = eph->delay.tgd_s};
}

static void fill_glonass(const orr_nav_glonass *g, orr_msg_glonass_set *m)
{
    *m = (orr_msg_glonass_set){.delta_tau_s = g->delta_tau_s, .channel = (int8_t)g->freq_channel};
    orr_answers_put(m->pos_m, g->pos_m);
    orr_answers_put(m->vel_mps, g->vel_mps);
    orr_answers_put(m->acc_mps2, g->acc_mps2);
}

static void fill_pages(const orr_navframe *f, orr_msg_nav_page *m)
{
    for (uint8_t k = 0; k < f->n; k++) {
        const orr_navframe_piece *p = &f->piece[k];
        m[k] = (orr_msg_nav_page){.t = p->t,
                                  .number = p->number,
                                  .page = p->page,
                                  .bits = p->bits,
                                  .data = {p->data, (uint16_t)((p->bits + 7) / 8)}};
    }
}

// What the lists of one satellite's record point at.
typedef struct room {
    orr_msg_lnav_set lnav;
    orr_msg_glonass_set glonass;
    orr_msg_nav_page page[ORR_MSG_MAX_PAGES];
} room;

// The lists of *m point into *r.
static void fill(orr_msg_sat_id sat, orr_answer answer, const orr_navset_item *set, const orr_navframe *frame,
                 room *r, orr_msg_sat_navdata *m)
{
    *m = (orr_msg_sat_navdata){.sat = sat, .answer = (uint8_t)answer};
    m->set_from = m->set_to = m->toe = m->toc = m->frame_from = m->frame_to = ORR_TIME_NONE;
    m->week = m->iode = m->iodc = -1;
    m->accuracy_m = m->fit_rms_m = m->fit_max_m = m->clock_rms_s = (double)NAN;
    m->af0_s = m->af1_sps = m->af2_sps2 = (double)NAN;
    if (answer != ORR_ANSWER_OK) return; // never a number where there is none
    const orr_nav_eph *eph = &set->eph;
    m->notes = set->notes;
    m->set_from = set->from;
    m->set_to = set->to;
    m->toe = eph->toe;
    m->toc = eph->toc;
    m->week = eph->week;
    m->iode = (int16_t)eph->iode;
    m->iodc = (int16_t)eph->iodc;
    m->health = eph->health;
    m->accuracy_m = eph->accuracy_m;
    m->fit_rms_m = set->report.rms_m;
    m->fit_max_m = set->report.max_m;
    m->clock_rms_s = set->clock_rms_s;
    m->af0_s = eph->af0_s;
    m->af1_sps = eph->af1_sps;
    m->af2_sps2 = eph->af2_sps2;
    m->frame_from = frame->from;
    m->frame_to = frame->to;
    if (eph->kind == ORR_NAV_KEPLER) {
        m->message = ORR_MSG_NAV_MESSAGE_LNAV;
        fill_lnav(eph, &r->lnav);
        m->kepler.count = 1;
        m->kepler.item = &r->lnav;
    } else {
        m->message = ORR_MSG_NAV_MESSAGE_FDMA;
        fill_glonass(&eph->glonass, &r->glonass);
        m->glonass.count = 1;
        m->glonass.item = &r->glonass;
    }
    fill_pages(frame, r->page);
    m->pages.count = frame->n;
    m->pages.item = r->page;
}

uint16_t orr_answers_navdata(void *user, const orr_msg_poll_navdata *poll, orr_server_part *part,
                             orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    orr_answers *a = user;
    uint16_t n;
    const orr_sat *sats = orr_answers_asked(a, &poll->satellites, &n);
    orr_msg_navdata m = {.epoch = orr_answers_epoch(&poll->epochs, part->index),
                         .satellites = {n, NULL, orr_answers_promise(0)}};
    bool another = true;
    if (part->done == 0) { // the message without its records, then one a piece
        orr_answer answer = orr_engine_navdata(a->engine, m.epoch.t, sats, 0, NULL, NULL, NULL);
        m.epoch.answer = (uint8_t)answer;
        if (answer != ORR_ANSWER_OK) m.satellites = (orr_msg_sat_navdata_list){0};
        orr_msg_navdata_encode(&m, w);
        if (answer != ORR_ANSWER_OK) return 0;
        another = orr_server_next_piece(part, 1 + (uint32_t)n);
    }
    for (; another; another = orr_server_next_piece(part, 1 + (uint32_t)n)) {
        uint32_t i = part->done - 1;
        const orr_navset_item *set;
        orr_navframe frame;
        orr_answer answer;
        room r;
        orr_msg_sat_navdata one;
        orr_engine_navdata(a->engine, m.epoch.t, &sats[i], 1, &set, &frame, &answer);
        fill(a->asked[i], answer, set, &frame, &r, &one);
        orr_msg_sat_navdata_records_encode(&(orr_msg_sat_navdata_list){.count = 1, .item = &one}, w);
    }
    return 0;
}
