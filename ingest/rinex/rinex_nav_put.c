// SPDX-License-Identifier: GPL-3.0-or-later
// Ephemerides as lines of navigation files: RINEX 3.05 (tables A5-A18), and those that RINEX 4.02 adds (tables A6-A29).
#include <math.h>
#include <stdio.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_nav_private.h"

// D19.12, or blanks for NAN. Exponents of three digits would not fit, and below 1E-99 nothing is lost.
void orr_nav_put_number(FILE *f, double v)
{
    if (isnan(v))
        fprintf(f, "%19s", "");
    else
        fprintf(f, "%19.12E", fabs(v) < 1e-99 ? 0.0 : v);
}

void orr_nav_put_line(FILE *f, double a, double b, double c, double d)
{
    fputs("    ", f);
    orr_nav_put_number(f, a);
    orr_nav_put_number(f, b);
    orr_nav_put_number(f, c);
    orr_nav_put_number(f, d);
    fputc('\n', f);
}

static void put_first_line(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e, double a, double b,
                           double c)
{
    char id[ORR_SAT_TEXT];
    orr_civil t;
    orr_time_to_civil(e->toc, orr_nav_scale_of(orr_sat_system(e->sat)), leap, &t);
    fprintf(f, "%s %04d %02d %02d %02d %02d %02d", orr_sat_text(e->sat, id), t.year, t.month, t.day, t.hour,
            t.minute, t.second);
    orr_nav_put_number(f, a);
    orr_nav_put_number(f, b);
    orr_nav_put_number(f, c);
    fputc('\n', f);
}

static double number_or_blank(int32_t v) { return v < 0 ? ORR_NAN : v; }
static double word_or_blank(uint32_t v) { return v == 0xffffffffu ? ORR_NAN : v; }

// Seconds of the week that the record reports; 0.9999E9 is how the format says "not known".
static double transmission_sow(const orr_nav_eph *e, int32_t week, char system)
{
    if (e->transmission == ORR_TIME_NONE) return 0.9999e9;
    int64_t shift = system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0;
    int32_t gps_week = system == 'C' ? week + ORR_BDT_WEEK_0 : week;
    return orr_time_diff_s(e->transmission - shift, orr_time_from_week(gps_week, 0));
}

static void put_kepler(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    const orr_nav_kepler *k = &e->kepler;
    char system = orr_sat_system(e->sat);
    int32_t week = 0;
    int64_t ns = 0;
    orr_time_week(e->toe - (system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0), &week, &ns);
    if (system == 'C') week -= ORR_BDT_WEEK_0;
    double blank = ORR_NAN, tow = transmission_sow(e, week, system);
    put_first_line(f, leap, e, e->af0_s, e->af1_sps, e->af2_sps2);
    orr_nav_put_line(f, number_or_blank(e->iode), k->crs_m, k->delta_n_radps, k->m0_rad);
    orr_nav_put_line(f, k->cuc_rad, k->e, k->cus_rad, k->sqrt_a_sqrtm);
    orr_nav_put_line(f, k->toe_sow_s, k->cic_rad, k->omega0_rad, k->cis_rad);
    orr_nav_put_line(f, k->i0_rad, k->crc_m, k->omega_rad, k->omega_dot_radps);
    double health = word_or_blank(e->health);
    switch (system) {
    case 'E':
        orr_nav_put_line(f, k->idot_radps, e->data_sources, week, blank);
        orr_nav_put_line(f, isnan(e->accuracy_m) ? -1 : e->accuracy_m, health, e->delay.bgd_e5a_e1_s,
                         e->delay.bgd_e5b_e1_s);
        orr_nav_put_line(f, tow, blank, blank, blank);
        break;
    case 'C':
        orr_nav_put_line(f, k->idot_radps, blank, week, blank);
        orr_nav_put_line(f, e->accuracy_m, health, e->delay.tgd_s, e->delay.tgd2_s);
        orr_nav_put_line(f, tow, number_or_blank(e->iodc), blank, blank);
        break;
    case 'I':
        orr_nav_put_line(f, k->idot_radps, blank, week, blank);
        orr_nav_put_line(f, e->accuracy_m, health, e->delay.tgd_s, blank);
        orr_nav_put_line(f, tow, blank, blank, blank);
        break;
    default: {
        double fit = system == 'J' ? (e->fit_interval_h > 2 ? 1 : 0) : e->fit_interval_h;
        orr_nav_put_line(f, k->idot_radps, e->data_sources, week, number_or_blank(e->l2p_flag));
        orr_nav_put_line(f, e->accuracy_m, health, e->delay.tgd_s, number_or_blank(e->iodc));
        orr_nav_put_line(f, tow, fit, blank, blank);
    }
    }
}

static void put_state(FILE *f, orr_vec3 p, orr_vec3 v, orr_vec3 a, double x, double y, double z)
{
    orr_nav_put_line(f, p.x * 1e-3, v.x * 1e-3, a.x * 1e-3, x);
    orr_nav_put_line(f, p.y * 1e-3, v.y * 1e-3, a.y * 1e-3, y);
    orr_nav_put_line(f, p.z * 1e-3, v.z * 1e-3, a.z * 1e-3, z);
}

static void put_glonass(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    const orr_nav_glonass *g = &e->glonass;
    put_first_line(f, leap, e, e->af0_s, e->af1_sps, g->frame_time_s);
    put_state(f, g->pos_m, g->vel_mps, g->acc_mps2, word_or_blank(e->health), g->freq_channel, g->age_days);
    double blank = ORR_NAN;
    orr_nav_put_line(f, g->has_flags ? g->status_flags : blank,
                     isnan(g->delta_tau_s) ? 0.999999999999e9 : g->delta_tau_s, g->ura,
                     g->has_flags ? g->health_flags : blank);
}

static void put_geo(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    const orr_nav_geo *g = &e->geo;
    int32_t week = 0;
    int64_t ns = 0;
    orr_time_week(e->toe, &week, &ns);
    put_first_line(f, leap, e, e->af0_s, e->af1_sps, transmission_sow(e, week, 'S'));
    put_state(f, g->pos_m, g->vel_mps, g->acc_mps2, word_or_blank(e->health), g->ura_m,
              number_or_blank(g->iodn));
}

static double index_or_blank(int32_t v) { return v <= -128 ? ORR_NAN : v; }

// CNAV and CNAV-2 of GPS and QZSS: toe is toc, the epoch.
static void put_modern_gps(FILE *f, const orr_nav_eph *e, double tow, double week)
{
    const orr_nav_delays *d = &e->delay;
    const double blank = ORR_NAN;
    orr_nav_put_line(f, e->kepler.idot_radps, e->kepler.delta_n_dot_radps2, index_or_blank(e->ura_ned[0]),
                     index_or_blank(e->ura_ned[1]));
    orr_nav_put_line(f, index_or_blank(e->ura_ed), word_or_blank(e->health), d->tgd_s,
                     index_or_blank(e->ura_ned[2]));
    orr_nav_put_line(f, d->isc_l1ca_s, d->isc_l2c_s, d->isc_l5i5_s, d->isc_l5q5_s);
    if (e->message == ORR_NAV_CNV2) orr_nav_put_line(f, d->isc_l1cd_s, d->isc_l1cp_s, blank, blank);
    orr_nav_put_line(f, tow, week, blank, blank);
}

// B-CNAV1, 2 and 3.
static void put_modern_beidou(FILE *f, const orr_nav_eph *e, double tow)
{
    const orr_nav_delays *d = &e->delay;
    const double blank = ORR_NAN, sismai = index_or_blank(e->sismai), health = word_or_blank(e->health),
                 flags = index_or_blank(e->integrity_flags);
    orr_nav_put_line(f, e->kepler.idot_radps, e->kepler.delta_n_dot_radps2, number_or_blank(e->sat_type),
                     e->kepler.top_sow_s);
    orr_nav_put_line(f, index_or_blank(e->sisai_oe), index_or_blank(e->sisai_ocb),
                     index_or_blank(e->sisai_oc1), index_or_blank(e->sisai_oc2));
    if (e->message == ORR_NAV_CNV3) {
        orr_nav_put_line(f, sismai, health, flags, d->tgd_s);
        orr_nav_put_line(f, tow, blank, blank, blank);
        return;
    }
    orr_nav_put_line(f, e->message == ORR_NAV_CNV1 ? d->isc_b1cd_s : blank,
                     e->message == ORR_NAV_CNV2 ? d->isc_b2ad_s : blank, d->tgd_b1cp_s, d->tgd_b2ap_s);
    orr_nav_put_line(f, sismai, health, flags, number_or_blank(e->iodc));
    orr_nav_put_line(f, tow, blank, blank, number_or_blank(e->iode));
}

static void put_navic_l1(FILE *f, const orr_nav_eph *e, double tow, double week)
{
    const orr_nav_delays *d = &e->delay;
    const double blank = ORR_NAN;
    orr_nav_put_line(f, e->kepler.idot_radps, e->kepler.delta_n_dot_radps2, blank, blank);
    orr_nav_put_line(f, e->accuracy_m, word_or_blank(e->health), d->tgd_s, d->tgd2_s);
    orr_nav_put_line(f, d->isc_s_l1p_s, d->isc_l1d_l1p_s, d->isc_l1p_s_s, d->isc_l1d_s_s);
    orr_nav_put_line(f, tow, week, blank, blank);
}

// The first five lines of all messages with rates of a and delta n, then their own.
static void put_modern(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    const orr_nav_kepler *k = &e->kepler;
    const char system = orr_sat_system(e->sat);
    const bool gps = system == 'G' || system == 'J', beidou = system == 'C';
    int32_t week = 0;
    int64_t ns = 0;
    orr_time_week(e->toe - (beidou ? ORR_BDT_BEHIND_GPS_NS : 0), &week, &ns);
    if (beidou) week -= ORR_BDT_WEEK_0;
    const double tow = transmission_sow(e, week, system);
    put_first_line(f, leap, e, e->af0_s, e->af1_sps, e->af2_sps2);
    orr_nav_put_line(f, k->a_dot_mps, k->crs_m, k->delta_n_radps, k->m0_rad);
    orr_nav_put_line(f, k->cuc_rad, k->e, k->cus_rad, k->sqrt_a_sqrtm);
    orr_nav_put_line(f, gps ? k->top_sow_s : k->toe_sow_s, k->cic_rad, k->omega0_rad, k->cis_rad);
    orr_nav_put_line(f, k->i0_rad, k->crc_m, k->omega_rad, k->omega_dot_radps);
    if (gps)
        put_modern_gps(f, e, tow, week);
    else if (beidou)
        put_modern_beidou(f, e, tow);
    else
        put_navic_l1(f, e, tow, week);
}

void orr_nav_put_eph(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    if (e->kind == ORR_NAV_GLONASS)
        put_glonass(f, leap, e);
    else if (e->kind == ORR_NAV_GEO)
        put_geo(f, leap, e);
    else if (orr_nav_in_version_3(e->message))
        put_kepler(f, leap, e);
    else
        put_modern(f, leap, e);
}

bool orr_nav_in_version_3(uint8_t message)
{
    return message == ORR_NAV_LNAV || message == ORR_NAV_D1 || message == ORR_NAV_D2 ||
           message == ORR_NAV_INAV || message == ORR_NAV_FNAV || message == ORR_NAV_FDMA ||
           message == ORR_NAV_SBAS;
}
