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
                   (uint32_t)ORR_NAVSET_CLOCK_JUMP == ORR_MSG_NAV_NOTES_CLOCK_JUMP &&
                   (uint32_t)ORR_NAVSET_FAULTY == ORR_MSG_NAV_NOTES_FAULTY,
               "the navset's notes are the wire's");
_Static_assert(ORR_MSG_MAX_PAGES == ORR_NAVFRAME_PIECES, "one list holds a frame");
#define SAME(name) (int)ORR_MSG_NAV_MESSAGE_##name == (int)ORR_NAV_##name
_Static_assert(SAME(LNAV) && SAME(CNAV) && SAME(CNV1) && SAME(CNV2) && SAME(CNV3) && SAME(INAV) &&
                   SAME(FNAV) && SAME(D1) && SAME(D2) && SAME(FDMA) && SAME(SBAS),
               "the messages are numbered as those of navigation files");

// The streams of a satellite that are asked for; one record is given of a satellite without any.
static size_t records_of(const orr_answers *a, orr_sat sat, uint32_t messages,
                         const orr_nav_stream *list[ORR_NAVSET_STREAMS])
{
    const size_t n = orr_engine_navdata_streams(a->engine, sat, messages, list);
    if (n == 0) list[0] = NULL;
    return n > 0 ? n : 1;
}

static size_t count_records(const orr_answers *a, const orr_sat *sats, uint16_t n, uint32_t messages)
{
    const orr_nav_stream *list[ORR_NAVSET_STREAMS];
    size_t sum = 0;
    for (uint16_t i = 0; i < n; i++) sum += records_of(a, sats[i], messages, list);
    return sum;
}

uint16_t orr_answers_begin_navdata(void *user, const orr_msg_poll_navdata *poll, orr_server_refusal *why)
{
    orr_answers *a = user;
    uint16_t n, code = orr_answers_check_epochs("POLL_NAVDATA", &poll->epochs, why);
    if (code != 0) return code;
    const char *none = orr_engine_no_navdata(a->engine);
    if (none != NULL) {
        snprintf(why->sentence, sizeof why->sentence, "POLL_NAVDATA: %.220s", none);
        return ORR_MSG_ERROR_CODE_NOT_SERVED;
    }
    if (poll->form > ORR_MSG_NAV_FORM_SYMBOLS)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_NAVDATA: a form is BITS or SYMBOLS");
    const orr_sat *sats = orr_answers_asked(a, &poll->satellites, &n);
    const size_t records = count_records(a, sats, n, poll->kinds);
    if (records <= ORR_MSG_MAX_STREAMS) return 0;
    snprintf(why->sentence, sizeof why->sentence,
             "POLL_NAVDATA: %zu messages of satellites, at most %u may be asked for at once", records,
             ORR_MSG_MAX_STREAMS);
    return ORR_MSG_ERROR_CODE_LIMIT;
}

// The delay of the first signal behind the message's clock.
static double first_delay(const orr_nav_eph *eph)
{
    const orr_nav_delays *d = &eph->delay;
    switch (eph->message) {
    case ORR_NAV_INAV:
        return d->bgd_e5b_e1_s;
    case ORR_NAV_FNAV:
        return d->bgd_e5a_e1_s;
    case ORR_NAV_CNV1:
        return d->tgd_b1cp_s;
    case ORR_NAV_CNV2:
        return orr_sat_system(eph->sat) == 'C' ? d->tgd_b1cp_s : d->tgd_s;
    default:
        return d->tgd_s;
    }
}

static void fill_kepler(const orr_nav_eph *eph, orr_msg_kepler_set *m)
{
    const orr_nav_kepler *k = &eph->kepler;
    *m = (orr_msg_kepler_set){.sqrt_a_sqrtm = k->sqrt_a_sqrtm,
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
                              .a_dot_mps = k->a_dot_mps,
                              .delta_n_dot_radps2 = k->delta_n_dot_radps2,
                              .tgd_s = first_delay(eph)};
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
                                  .length = p->length,
                                  .number = p->number,
                                  .page = p->page,
                                  .bits = p->bits,
                                  .data = {p->data, (uint16_t)((p->bits + 7) / 8)}};
    }
}

static void fill_geo(const orr_nav_geo *g, orr_msg_glonass_set *m)
{
    *m = (orr_msg_glonass_set){0};
    orr_answers_put(m->pos_m, g->pos_m);
    orr_answers_put(m->vel_mps, g->vel_mps);
    orr_answers_put(m->acc_mps2, g->acc_mps2);
}

// What the lists of one satellite's record point at.
typedef struct room {
    orr_msg_kepler_set kepler;
    orr_msg_glonass_set glonass;
    orr_msg_nav_page page[ORR_MSG_MAX_PAGES];
} room;

// The lists of *m point into *r.
static void fill(orr_msg_sat_id sat, const orr_nav_stream *stream, uint8_t form, orr_answer answer,
                 const orr_navset_item *set, const orr_navframe *frame, room *r, orr_msg_sat_navdata *m)
{
    *m = (orr_msg_sat_navdata){.sat = sat, .answer = (uint8_t)answer, .form = form};
    m->set_from = m->set_to = m->toe = m->toc = m->frame_from = m->frame_to = ORR_TIME_NONE;
    m->week = m->iode = m->iodc = -1;
    m->accuracy_m = m->fit_rms_m = m->fit_max_m = m->clock_rms_s = (double)NAN;
    m->af0_s = m->af1_sps = m->af2_sps2 = (double)NAN;
    if (stream != NULL) {
        m->message = stream->message;
        m->signals = orr_wire_text(stream->signals);
    }
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
        fill_kepler(eph, &r->kepler);
        m->kepler.count = 1;
        m->kepler.item = &r->kepler;
    } else {
        if (eph->kind == ORR_NAV_GEO)
            fill_geo(&eph->geo, &r->glonass);
        else
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
    const uint32_t records = (uint32_t)count_records(a, sats, n, poll->kinds);
    orr_msg_navdata m = {.epoch = orr_answers_epoch(&poll->epochs, part->index),
                         .satellites = {(uint16_t)records, NULL, orr_answers_promise(0)}};
    orr_span span;
    bool another = true;
    if (part->done == 0) { // the message without its records, then one a piece
        const bool within =
            orr_engine_part_span(a->engine, ORR_PART_NAVDATA, &span) && orr_span_holds(span, m.epoch.t);
        m.epoch.answer = within ? ORR_MSG_ANSWER_OK : ORR_MSG_ANSWER_OUTSIDE_SPAN;
        if (!within) m.satellites = (orr_msg_sat_navdata_list){0};
        orr_msg_navdata_encode(&m, w);
        if (!within) return 0;
        another = orr_server_next_piece(part, 1 + records);
    }
    uint32_t first = 0; // record of the satellite's first stream
    for (uint16_t i = 0; i < n && another; i++) {
        const orr_nav_stream *list[ORR_NAVSET_STREAMS];
        const uint32_t own = (uint32_t)records_of(a, sats[i], poll->kinds, list);
        while (another && part->done - 1 - first < own) {
            const orr_nav_stream *stream = list[part->done - 1 - first];
            const orr_navset_item *set;
            orr_navframe frame;
            room r;
            orr_msg_sat_navdata one;
            const orr_answer answer = orr_engine_navdata(
                a->engine, m.epoch.t, sats[i], stream, poll->form == ORR_MSG_NAV_FORM_SYMBOLS, &set, &frame);
            fill(a->asked[i], stream, poll->form, answer, set, &frame, &r, &one);
            orr_msg_sat_navdata_records_encode(&(orr_msg_sat_navdata_list){.count = 1, .item = &one}, w);
            another = orr_server_next_piece(part, 1 + records);
        }
        first += own;
    }
    return 0;
}
