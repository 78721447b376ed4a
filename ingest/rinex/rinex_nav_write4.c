// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation records of RINEX 4.02: ephemerides under lines of their own, time offsets, Earth orientation, ionosphere (chapters 5.4
// and A.31 ff.). What a record of an older file leaves open (who sent it, when, in which message) is taken from the ephemerides of its
// system, so that headers of RINEX 3 become records; records of RINEX 4 stay as they are.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_nav_private.h"

#define ARCSEC_PER_RAD (648000.0 / ORR_PI)

// The message that a system's older records come from.
static uint8_t legacy_of(char system)
{
    switch (system) {
    case 'E':
        return ORR_NAV_IFNV;
    case 'C':
        return ORR_NAV_D1D2;
    case 'R':
        return ORR_NAV_FDMA;
    case 'S':
        return ORR_NAV_SBAS;
    default:
        return ORR_NAV_LNAV;
    }
}

// The first satellite of a system that has ephemerides; NULL: none.
static const orr_nav_eph *first_of(const orr_nav *nav, char system)
{
    for (size_t i = 0; i < nav->n_eph; i++)
        if (orr_sat_system(nav->eph[i].sat) == system) return &nav->eph[i];
    return NULL;
}

static void put_tag(FILE *f, const char *kind, const orr_nav *nav, char system, orr_sat sat, uint8_t message)
{
    char id[ORR_SAT_TEXT] = {system, '\0'};
    const orr_nav_eph *e = sat == ORR_SAT_NONE && message == ORR_NAV_NONE ? first_of(nav, system) : NULL;
    if (e != NULL) sat = e->sat;
    if (sat != ORR_SAT_NONE) orr_sat_text(sat, id);
    fprintf(f, "> %s %-3s %s\n", kind, id,
            orr_nav_message_name((orr_nav_message)(message != ORR_NAV_NONE ? message : legacy_of(system))));
}

static void put_epoch(FILE *f, const orr_nav *nav, char system, orr_time t)
{
    orr_civil c;
    orr_time_to_civil(t, orr_nav_scale_of(system), nav->leap, &c);
    fprintf(f, "    %04d %02d %02d %02d %02d %02d", c.year, c.month, c.day, c.hour, c.minute, c.second);
}

// An instant where the record has none: when the system's first ephemeris was sent.
static orr_time or_first(const orr_nav *nav, char system, orr_time t)
{
    if (t != ORR_TIME_NONE) return t;
    const orr_nav_eph *e = first_of(nav, system);
    if (e == NULL) return 0;
    return e->transmission != ORR_TIME_NONE ? e->transmission : e->toc;
}

static double sow_of(orr_time t, char system)
{
    return t == ORR_TIME_NONE ? 0.9999e9 : (double)orr_nav_ns_of_week(t, system) * 1e-9;
}

// The system that a four-letter code of a time offset begins with.
static char system_of_code(const char *code)
{
    static const struct {
        char code[3], system;
    } all[] = {{"GP", 'G'}, {"GL", 'R'}, {"GA", 'E'}, {"BD", 'C'}, {"QZ", 'J'}, {"IR", 'I'}, {"SB", 'S'}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (strncmp(code, all[k].code, 2) == 0) return all[k].system;
    return 'G';
}

static void put_sto(FILE *f, const orr_nav *nav, const orr_nav_sto *s)
{
    const char system = s->sat != ORR_SAT_NONE ? orr_sat_system(s->sat) : system_of_code(s->code);
    put_tag(f, "STO", nav, system, s->sat, s->message);
    put_epoch(f, nav, system, or_first(nav, system, s->t_ref));
    fprintf(f, " %-18s %-18s %s\n", s->code, s->sbas_id, s->utc_id);
    const bool of_header = s->message == ORR_NAV_NONE;
    const orr_time sent = of_header ? or_first(nav, system, s->transmission) : s->transmission;
    orr_nav_put_line(f, sow_of(sent, system), s->a0_s, s->a1_sps, s->a2_sps2);
}

static void put_eop(FILE *f, const orr_nav *nav, const orr_nav_eop *e)
{
    const char system = orr_sat_system(e->sat);
    const double day = ORR_S_PER_DAY, blank = ORR_NAN;
    put_tag(f, "EOP", nav, system, e->sat, e->message);
    put_epoch(f, nav, system, e->t_ref);
    orr_nav_put_number(f, e->xp_rad * ARCSEC_PER_RAD);
    orr_nav_put_number(f, e->xp_rate_radps * ARCSEC_PER_RAD * day);
    orr_nav_put_number(f, e->xp_accel_radps2 * ARCSEC_PER_RAD * day * day);
    fputc('\n', f);
    orr_nav_put_line(f, blank, e->yp_rad * ARCSEC_PER_RAD, e->yp_rate_radps * ARCSEC_PER_RAD * day,
                     e->yp_accel_radps2 * ARCSEC_PER_RAD * day * day);
    orr_nav_put_line(f, sow_of(e->transmission, system), e->dut1_s, e->dut1_rate_sps * day,
                     e->dut1_accel_sps2 * day * day);
}

// Coefficients, three beside the epoch and four a line, then one more number of the kind.
static void put_iono(FILE *f, const orr_nav *nav, const orr_nav_iono *k)
{
    static const uint8_t counts[] = {
        [ORR_NAV_KLOBUCHAR] = 8, [ORR_NAV_NEQUICK_G] = 3, [ORR_NAV_BDGIM] = 9, [ORR_NAV_GLONASS_CDMA] = 3};
    double v[16];
    size_t n = counts[k->kind];
    memcpy(v, k->coefficient, n * sizeof *v);
    if (k->kind == ORR_NAV_KLOBUCHAR || k->kind == ORR_NAV_NEQUICK_G) v[n++] = k->flags;
    while (n % 4 != 3) v[n++] = ORR_NAN;
    const uint8_t message = k->kind == ORR_NAV_BDGIM ? ORR_NAV_CNVX : k->message;
    put_tag(f, "ION", nav, k->system, k->sat, message);
    put_epoch(f, nav, k->system, or_first(nav, k->system, k->t));
    for (size_t i = 0; i < 3; i++) orr_nav_put_number(f, v[i]);
    fputc('\n', f);
    for (size_t i = 3; i < n; i += 4) orr_nav_put_line(f, v[i], v[i + 1], v[i + 2], v[i + 3]);
}

// NavIC's L1 records have places of their own for regions and issues: they are passed on in no file.
static bool iono_known(const orr_nav_iono *k)
{
    return k->kind != ORR_NAV_NEQUICK_N && k->message != ORR_NAV_L1NV;
}

size_t orr_nav_put_records4(FILE *f, const orr_nav *nav)
{
    size_t left = 0;
    for (size_t i = 0; i < nav->n_sto; i++) put_sto(f, nav, &nav->sto[i]);
    for (size_t i = 0; i < nav->n_eop; i++) put_eop(f, nav, &nav->eop[i]);
    for (size_t i = 0; i < nav->n_iono; i++) {
        if (iono_known(&nav->iono[i]))
            put_iono(f, nav, &nav->iono[i]);
        else
            left++;
    }
    for (size_t i = 0; i < nav->n_eph; i++) {
        const orr_nav_eph *e = &nav->eph[i];
        put_tag(f, "EPH", nav, orr_sat_system(e->sat), e->sat, e->message);
        orr_nav_put_eph(f, nav->leap, e);
    }
    return left;
}
