// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files of RINEX 3.05 (tables A5-A18).
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "ingest/rinex/rinex_nav_private.h"

static void put_header(FILE *f, const char *label, const char *fmt, ...) ORR_PRINTF(3, 4);
static void put_header(FILE *f, const char *label, const char *fmt, ...)
{
    char text[128];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    fprintf(f, "%-60.60s%-20.20s\n", text, label);
}

// D19.12, or blanks for NAN. Exponents of three digits would not fit, and below 1E-99 nothing is lost.
static void put_number(FILE *f, double v)
{
    if (isnan(v))
        fprintf(f, "%19s", "");
    else
        fprintf(f, "%19.12E", fabs(v) < 1e-99 ? 0.0 : v);
}

static void put_orbit_line(FILE *f, double a, double b, double c, double d)
{
    fputs("    ", f);
    put_number(f, a);
    put_number(f, b);
    put_number(f, c);
    put_number(f, d);
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
    put_number(f, a);
    put_number(f, b);
    put_number(f, c);
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
    put_orbit_line(f, number_or_blank(e->iode), k->crs_m, k->delta_n_radps, k->m0_rad);
    put_orbit_line(f, k->cuc_rad, k->e, k->cus_rad, k->sqrt_a_sqrtm);
    put_orbit_line(f, k->toe_sow_s, k->cic_rad, k->omega0_rad, k->cis_rad);
    put_orbit_line(f, k->i0_rad, k->crc_m, k->omega_rad, k->omega_dot_radps);
    double health = word_or_blank(e->health);
    switch (system) {
    case 'E':
        put_orbit_line(f, k->idot_radps, e->data_sources, week, blank);
        put_orbit_line(f, isnan(e->accuracy_m) ? -1 : e->accuracy_m, health, e->delay.bgd_e5a_e1_s,
                       e->delay.bgd_e5b_e1_s);
        put_orbit_line(f, tow, blank, blank, blank);
        break;
    case 'C':
        put_orbit_line(f, k->idot_radps, blank, week, blank);
        put_orbit_line(f, e->accuracy_m, health, e->delay.tgd_s, e->delay.tgd2_s);
        put_orbit_line(f, tow, number_or_blank(e->iodc), blank, blank);
        break;
    case 'I':
        put_orbit_line(f, k->idot_radps, blank, week, blank);
        put_orbit_line(f, e->accuracy_m, health, e->delay.tgd_s, blank);
        put_orbit_line(f, tow, blank, blank, blank);
        break;
    default: {
        double fit = system == 'J' ? (e->fit_interval_h > 2 ? 1 : 0) : e->fit_interval_h;
        put_orbit_line(f, k->idot_radps, e->data_sources, week, number_or_blank(e->l2p_flag));
        put_orbit_line(f, e->accuracy_m, health, e->delay.tgd_s, number_or_blank(e->iodc));
        put_orbit_line(f, tow, fit, blank, blank);
    }
    }
}

static void put_state(FILE *f, orr_vec3 p, orr_vec3 v, orr_vec3 a, double x, double y, double z)
{
    put_orbit_line(f, p.x * 1e-3, v.x * 1e-3, a.x * 1e-3, x);
    put_orbit_line(f, p.y * 1e-3, v.y * 1e-3, a.y * 1e-3, y);
    put_orbit_line(f, p.z * 1e-3, v.z * 1e-3, a.z * 1e-3, z);
}

static void put_glonass(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e)
{
    const orr_nav_glonass *g = &e->glonass;
    put_first_line(f, leap, e, e->af0_s, e->af1_sps, g->frame_time_s);
    put_state(f, g->pos_m, g->vel_mps, g->acc_mps2, word_or_blank(e->health), g->freq_channel, g->age_days);
    double blank = ORR_NAN;
    put_orbit_line(f, g->has_flags ? g->status_flags : blank,
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

static bool in_version_3(uint8_t message)
{
    return message == ORR_NAV_LNAV || message == ORR_NAV_D1 || message == ORR_NAV_D2 ||
           message == ORR_NAV_INAV || message == ORR_NAV_FNAV || message == ORR_NAV_FDMA ||
           message == ORR_NAV_SBAS;
}

// Header parameters are written all; of RINEX 4's records the first of each system stands for the file.
static bool iono_wanted(const orr_nav *nav, size_t i)
{
    const orr_nav_iono *k = &nav->iono[i];
    if (k->kind != ORR_NAV_KLOBUCHAR && k->kind != ORR_NAV_NEQUICK_G) return false;
    if (k->message == ORR_NAV_NONE) return true;
    if (k->message != ORR_NAV_LNAV && k->message != ORR_NAV_D1D2 && k->message != ORR_NAV_IFNV) return false;
    for (size_t j = 0; j < i; j++)
        if (nav->iono[j].kind == k->kind && nav->iono[j].system == k->system) return false;
    return true;
}

static void put_iono(FILE *f, const orr_nav_iono *k)
{
    static const char letters[] = "GCJI";
    static const char *const names[] = {"GPS", "BDS", "QZS", "IRN"};
    const double *v = k->coefficient;
    if (k->kind == ORR_NAV_NEQUICK_G) {
        put_header(f, "IONOSPHERIC CORR", "GAL  %12.4E%12.4E%12.4E%12.4E", v[0], v[1], v[2], 0.0);
        return;
    }
    const char *at = strchr(letters, k->system);
    if (at == NULL || k->system == '\0') return;
    char sat[4] = "";
    if (k->sat != ORR_SAT_NONE) snprintf(sat, sizeof sat, "%02d", orr_sat_number(k->sat));
    for (int part = 0; part < 2; part++, v += 4)
        put_header(f, "IONOSPHERIC CORR", "%s%c %12.4E%12.4E%12.4E%12.4E %c %s", names[at - letters],
                   "AB"[part], v[0], v[1], v[2], v[3], k -> time_mark, sat);
}

static void put_sto(FILE *f, const orr_nav *nav, size_t i)
{
    const orr_nav_sto *s = &nav->sto[i];
    for (size_t j = 0; j < i && s->message != ORR_NAV_NONE; j++)
        if (strcmp(nav->sto[j].code, s->code) == 0) return; // one of each stands for the file
    int32_t week = 0;
    int64_t ns = 0;
    bool beidou = s->code[0] == 'B';
    if (s->t_ref != ORR_TIME_NONE) {
        orr_time_week(s->t_ref - (beidou ? ORR_BDT_BEHIND_GPS_NS : 0), &week, &ns);
        if (beidou) week -= ORR_BDT_WEEK_0;
    }
    static const char *const utc[] = {"UTC(NIST)", "UTC(USNO)",       "UTC(SU)",
                                      "UTC(BIPM)", "UTC(Europe Lab)", "UTC(CRL)"};
    char id[12] = "";
    for (int k = 0; k < 6; k++)
        if (strcmp(s->utc_id, utc[k]) == 0) snprintf(id, sizeof id, "%2d", k + 1);
    put_header(f, "TIME SYSTEM CORR", "%-4.4s %17.10E%16.9E %6lld %4d %-5.5s %s", s->code, s->a0_s, s->a1_sps,
               (long long)(ns / ORR_NS_PER_S), (int)week, s->sbas_id, id);
}

// What is to come, or came last, stays blank where it is not known.
static void put_leap(FILE *f, const orr_nav *nav)
{
    char event[40] = "";
    if (nav->leap_week > 0)
        snprintf(event, sizeof event, "%6d%6d%6d", nav->leap_future_s, nav->leap_week, nav->leap_day);
    put_header(f, "LEAP SECONDS", "%6d%-18s%3s", nav->leap_s, event,
               nav->leap_scale == ORR_SCALE_BDT ? "BDS" : "GPS");
}

static void put_whole_header(FILE *f, const orr_nav *nav)
{
    char system[] = "M: Mixed";
    if (nav->system != 'M') {
        system[0] = nav->system;
        system[1] = '\0';
    }
    put_header(f, "RINEX VERSION / TYPE", "%9.2f%11s%-20s%-20s", 3.05, "", "N: GNSS NAV DATA", system);
    put_header(f, "PGM / RUN BY / DATE", "%-20.20s%-20.20s%-20.20s", nav->program, nav->run_by, nav->date);
    for (size_t i = 0; i < nav->n_comments; i++) put_header(f, "COMMENT", "%s", nav->comment[i]);
    for (size_t i = 0; i < nav->n_iono; i++)
        if (iono_wanted(nav, i)) put_iono(f, &nav->iono[i]);
    for (size_t i = 0; i < nav->n_sto; i++) put_sto(f, nav, i);
    if (nav->has_leap) put_leap(f, nav);
    put_header(f, "END OF HEADER", "%s", "");
}

orr_status orr_nav_write(const orr_nav *nav, const char *path, size_t *n_left_out, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    size_t left = 0;
    put_whole_header(out.stream, nav);
    for (size_t i = 0; i < nav->n_eph; i++) {
        const orr_nav_eph *e = &nav->eph[i];
        if (!in_version_3(e->message)) {
            left++;
            continue;
        }
        switch (e->kind) {
        case ORR_NAV_KEPLER:
            put_kepler(out.stream, nav->leap, e);
            break;
        case ORR_NAV_GLONASS:
            put_glonass(out.stream, nav->leap, e);
            break;
        default:
            put_geo(out.stream, nav->leap, e);
            break;
        }
    }
    if (n_left_out != NULL) *n_left_out = left;
    if (ferror(out.stream)) {
        orr_outfile_abort(&out);
        return orr_diag_set(diag, ORR_E_IO, "%s: the output could not be written", path);
    }
    return orr_outfile_commit(&out, diag);
}
