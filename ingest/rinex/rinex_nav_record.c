// SPDX-License-Identifier: GPL-3.0-or-later
// Records of navigation files into ephemerides. Field positions: RINEX 2.11 tables A4, A11, A16; RINEX 3.05
// tables A6-A18; RINEX 4.02 appendix A.
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_nav_private.h"

static int32_t week_of(orr_time t, char system)
{
    int32_t week = 0;
    int64_t ns = 0;
    orr_time_week(t - (system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0), &week, &ns);
    return system == 'C' ? week - ORR_BDT_WEEK_0 : week;
}

// Whole numbers written as reals; `missing` where blank or out of range.
static int32_t whole(double v, int32_t missing)
{
    if (!(fabs(v) < 2147483647.0)) return missing;
    return (int32_t)lround(v);
}

static uint32_t word(double v)
{
    if (!(v >= 0 && v < 4294967295.0)) return 0xffffffffu;
    return (uint32_t)llround(v);
}

static double or_zero(double v) { return isnan(v) ? 0 : v; }

static orr_time transmission_time(double sow_s, char system, orr_time toe)
{
    // 0.9999E9 means unknown; values a little outside the week belong to the reported one.
    if (!(fabs(sow_s) < 2 * 604800.0)) return ORR_TIME_NONE;
    return orr_nav_of_week(sow_s, system, toe);
}

static void no_extras(orr_nav_eph *e)
{
    double nan = ORR_NAN;
    e->transmission = ORR_TIME_NONE;
    e->week = -1;
    e->accuracy_m = e->fit_interval_h = nan;
    e->iode = e->iodc = ORR_NAV_NO_IOD;
    e->health = 0xffffffffu;
    e->data_sources = 0;
    e->l2p_flag = e->sat_type = -1;
    e->ura_ed = e->ura_ned[0] = e->ura_ned[1] = e->ura_ned[2] = -128;
    e->sisai_oe = e->sisai_ocb = e->sisai_oc1 = e->sisai_oc2 = e->sismai = e->integrity_flags = -128;
    double *d = (double *)&e->delay;
    for (size_t i = 0; i < sizeof e->delay / sizeof *d; i++) d[i] = nan;
}

static orr_nav_message message_of(char system, int number, double data_sources)
{
    switch (system) {
    case 'R':
        return ORR_NAV_FDMA;
    case 'S':
        return ORR_NAV_SBAS;
    case 'C':
        return number <= 5 || (number >= 59 && number <= 63) ? ORR_NAV_D2 : ORR_NAV_D1;
    case 'E': {
        uint32_t bits = isnan(data_sources) ? 0 : word(data_sources);
        return (bits & 2u) && !(bits & 5u) ? ORR_NAV_FNAV : ORR_NAV_INAV;
    }
    default:
        return ORR_NAV_LNAV;
    }
}

// Continuation lines that a record of a message has.
static size_t lines_of(char system, orr_nav_message m)
{
    switch (m) {
    case ORR_NAV_CNAV:
        return 8;
    case ORR_NAV_CNV1:
        return 9;
    case ORR_NAV_CNV2:
        return 9;
    case ORR_NAV_CNV3:
        return 8;
    case ORR_NAV_L1NV:
        return 8;
    case ORR_NAV_FDMA:
        return 3;
    case ORR_NAV_SBAS:
        return 3;
    default:
        return system == 'R' || system == 'S' ? 3 : 7;
    }
}

static bool message_fits(char system, orr_nav_message m)
{
    switch (m) {
    case ORR_NAV_LNAV:
        return strchr("GJI", system) != NULL;
    case ORR_NAV_CNAV:
        return strchr("GJ", system) != NULL;
    case ORR_NAV_CNV1:
    case ORR_NAV_CNV3:
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        return system == 'C';
    case ORR_NAV_CNV2:
        return strchr("GJC", system) != NULL;
    case ORR_NAV_INAV:
    case ORR_NAV_FNAV:
        return system == 'E';
    case ORR_NAV_FDMA:
        return system == 'R';
    case ORR_NAV_SBAS:
        return system == 'S';
    case ORR_NAV_L1NV:
        return system == 'I';
    default:
        return false;
    }
}

// The 17 numbers that all Kepler records share, and the instant they hold for.
static bool take_kepler(const nav_lines *r, const double *b, orr_nav_eph *e, char system, bool toe_is_toc,
                        nav_fault *f)
{
    orr_nav_kepler *k = &e->kepler;
    int64_t line = r->line[0].number;
    for (int i = 1; i <= 16; i++)
        if (isnan(b[i]) && !(i == 8 && toe_is_toc))
            return orr_nav_fault(f, r->line[1 + i / 4].number, 0, "an orbital element is missing");
    k->crs_m = b[1];
    k->delta_n_radps = b[2];
    k->m0_rad = b[3];
    k->cuc_rad = b[4];
    k->e = b[5];
    k->cus_rad = b[6];
    k->sqrt_a_sqrtm = b[7];
    k->cic_rad = b[9];
    k->omega0_rad = b[10];
    k->cis_rad = b[11];
    k->i0_rad = b[12];
    k->crc_m = b[13];
    k->omega_rad = b[14];
    k->omega_dot_radps = b[15];
    k->idot_radps = b[16];
    k->top_sow_s = ORR_NAN;
    if (!(k->sqrt_a_sqrtm > 1000 && k->sqrt_a_sqrtm < 10000))
        return orr_nav_fault(f, r->line[2].number, 0,
                             "the square root of the semi-major axis (%g) is no orbit's", b[7]);
    if (!(k->e >= 0 && k->e < 1))
        return orr_nav_fault(f, r->line[2].number, 0, "the eccentricity (%g) is no ellipse's", b[5]);
    if (toe_is_toc) {
        k->top_sow_s = b[8];
        k->toe_sow_s = (double)orr_nav_ns_of_week(e->toc, system) * 1e-9;
        e->toe = e->toc;
        return true;
    }
    if (!(b[8] >= 0 && b[8] <= 604800))
        return orr_nav_fault(f, line + 3, 0, "the time of ephemeris (%g s) is outside the week", b[8]);
    k->toe_sow_s = b[8];
    e->toe = orr_nav_of_week(b[8], system, e->toc);
    return true;
}

static void take_gps_lnav(const double *b, orr_nav_eph *e, char system)
{
    e->iode = whole(b[0], ORR_NAV_NO_IOD);
    e->data_sources = isnan(b[17]) ? 0 : word(b[17]);
    e->week = whole(b[18], -1);
    e->l2p_flag = whole(b[19], -1);
    e->accuracy_m = b[20];
    e->health = word(b[21]);
    e->delay.tgd_s = b[22];
    e->iodc = whole(b[23], ORR_NAV_NO_IOD);
    e->transmission = transmission_time(b[24], system, e->toe);
    double fit = or_zero(b[25]);
    e->fit_interval_h = system == 'J' ? (fit == 0 ? 2 : 4) : fit == 0 ? 4 : fit;
}

static void take_cnav(const double *b, orr_nav_eph *e, char system, bool cnv2)
{
    e->kepler.a_dot_mps = or_zero(b[0]);
    e->kepler.delta_n_dot_radps2 = or_zero(b[17]);
    e->ura_ned[0] = whole(b[18], -128);
    e->ura_ned[1] = whole(b[19], -128);
    e->ura_ed = whole(b[20], -128);
    e->health = word(b[21]);
    e->delay.tgd_s = b[22];
    e->ura_ned[2] = whole(b[23], -128);
    e->delay.isc_l1ca_s = b[24];
    e->delay.isc_l2c_s = b[25];
    e->delay.isc_l5i5_s = b[26];
    e->delay.isc_l5q5_s = b[27];
    size_t last = 28;
    if (cnv2) {
        e->delay.isc_l1cd_s = b[28];
        e->delay.isc_l1cp_s = b[29];
        last = 32;
    }
    e->transmission = transmission_time(b[last], system, e->toe);
    e->week = whole(b[last + 1], -1);
}

static void take_galileo(const double *b, orr_nav_eph *e)
{
    e->iode = e->iodc = whole(b[0], ORR_NAV_NO_IOD);
    e->data_sources = isnan(b[17]) ? 0 : word(b[17]);
    e->week = whole(b[18], -1);
    e->accuracy_m = b[20] >= 0 ? b[20] : ORR_NAN; // -1: no accuracy prediction
    e->health = word(b[21]);
    e->delay.bgd_e5a_e1_s = b[22];
    e->delay.bgd_e5b_e1_s = b[23];
    e->transmission = transmission_time(b[24], 'E', e->toe);
}

static void take_beidou_legacy(const double *b, orr_nav_eph *e)
{
    e->iode = whole(b[0], ORR_NAV_NO_IOD);
    e->week = whole(b[18], -1);
    e->accuracy_m = b[20];
    e->health = word(b[21]);
    e->delay.tgd_s = b[22];
    e->delay.tgd2_s = b[23];
    e->transmission = transmission_time(b[24], 'C', e->toe);
    e->iodc = whole(b[25], ORR_NAV_NO_IOD);
}

static void take_beidou_cnav(const double *b, orr_nav_eph *e, orr_nav_message m)
{
    e->kepler.a_dot_mps = or_zero(b[0]);
    e->kepler.delta_n_dot_radps2 = or_zero(b[17]);
    e->sat_type = whole(b[18], -1);
    e->kepler.top_sow_s = b[19];
    e->sisai_oe = whole(b[20], -128);
    e->sisai_ocb = whole(b[21], -128);
    e->sisai_oc1 = whole(b[22], -128);
    e->sisai_oc2 = whole(b[23], -128);
    if (m == ORR_NAV_CNV3) {
        e->sismai = whole(b[24], -128);
        e->health = word(b[25]);
        e->integrity_flags = whole(b[26], -128);
        e->delay.tgd_s = b[27];
        e->transmission = transmission_time(b[28], 'C', e->toe);
        return;
    }
    e->delay.isc_b1cd_s = m == ORR_NAV_CNV1 ? b[24] : ORR_NAN;
    e->delay.isc_b2ad_s = m == ORR_NAV_CNV2 ? b[25] : ORR_NAN;
    e->delay.tgd_b1cp_s = b[26];
    e->delay.tgd_b2ap_s = b[27];
    e->sismai = whole(b[28], -128);
    e->health = word(b[29]);
    e->integrity_flags = whole(b[30], -128);
    e->iodc = whole(b[31], ORR_NAV_NO_IOD);
    e->transmission = transmission_time(b[32], 'C', e->toe);
    e->iode = whole(b[35], ORR_NAV_NO_IOD);
}

static void take_navic(const double *b, orr_nav_eph *e, bool l1nv)
{
    if (!l1nv) {
        e->iode = e->iodc = whole(b[0], ORR_NAV_NO_IOD);
        e->week = whole(b[18], -1);
        e->accuracy_m = b[20];
        e->health = word(b[21]);
        e->delay.tgd_s = b[22];
        e->transmission = transmission_time(b[24], 'I', e->toe);
        return;
    }
    e->kepler.a_dot_mps = or_zero(b[0]);
    e->kepler.delta_n_dot_radps2 = or_zero(b[17]);
    e->accuracy_m = b[20];
    e->health = word(b[21]);
    e->delay.tgd_s = b[22];
    e->delay.tgd2_s = b[23];
    e->delay.isc_s_l1p_s = b[24];
    e->delay.isc_l1d_l1p_s = b[25];
    e->delay.isc_l1p_s_s = b[26];
    e->delay.isc_l1d_s_s = b[27];
    e->transmission = transmission_time(b[28], 'I', e->toe);
    e->week = whole(b[29], -1);
}

// Three lines of position, velocity, acceleration in km, and one more number each.
static bool take_state(const nav_lines *r, const double *b, orr_vec3 *pos, orr_vec3 *vel, orr_vec3 *acc,
                       nav_fault *f)
{
    for (int i = 0; i < 12; i++)
        if (isnan(b[i]) && i % 4 != 3)
            return orr_nav_fault(f, r->line[1 + i / 4].number, 0,
                                 "a coordinate, velocity or acceleration is missing");
    *pos = (orr_vec3){b[0] * 1e3, b[4] * 1e3, b[8] * 1e3};
    *vel = (orr_vec3){b[1] * 1e3, b[5] * 1e3, b[9] * 1e3};
    *acc = (orr_vec3){b[2] * 1e3, b[6] * 1e3, b[10] * 1e3};
    double radius = orr_vec3_norm(*pos);
    if (!(radius > 1e6 && radius < 1e8))
        return orr_nav_fault(f, r->line[1].number, 0,
                             "the position (%.0f km from the centre) is no satellite's", radius * 1e-3);
    return true;
}

static bool take_glonass(const nav_lines *r, const double *a, const double *b, bool flags_line, bool v2,
                         orr_nav_eph *e, nav_fault *f)
{
    orr_nav_glonass *g = &e->glonass;
    e->kind = ORR_NAV_GLONASS;
    e->af2_sps2 = 0;
    e->toe = e->toc;
    if (!take_state(r, b, &g->pos_m, &g->vel_mps, &g->acc_mps2, f)) return false;
    int32_t k = whole(b[7], -128);
    if (k > 128) k -= 256; // some encoders write the signed byte unsigned
    if (k < -7 || k > 24)
        return orr_nav_fault(f, r->line[2].number, 0, "the frequency channel (%g) is none", b[7]);
    g->freq_channel = k;
    g->age_days = b[11];
    e->health = word(b[3]);
    g->frame_time_s = a[2];
    int64_t day = INT64_C(86400) * ORR_NS_PER_S;
    if (a[2] >= 0 && a[2] <= 604800) { // of a UTC day or week: the day is that of toe, or its neighbour
        orr_civil c;
        orr_time_to_civil(e->toc, ORR_SCALE_UTC, r->leap, &c);
        int64_t of_day = ((int64_t)c.hour * 3600 + c.minute * 60 + c.second) * ORR_NS_PER_S + c.ns;
        int64_t d = ((int64_t)llround(a[2] * 1e9) - of_day) % day;
        if (d > day / 2) d -= day;
        if (d < -day / 2) d += day;
        e->transmission = e->toc + d;
    }
    (void)v2;
    g->delta_tau_s = g->ura = ORR_NAN;
    g->status_flags = g->health_flags = 0;
    g->has_flags = flags_line;
    if (flags_line) {
        g->status_flags = isnan(b[12]) ? 0 : word(b[12]);
        g->delta_tau_s = fabs(b[13]) < 1 ? b[13] : ORR_NAN; // .999999999999E+09: not known
        g->ura = b[14];
        g->health_flags = isnan(b[15]) ? 0 : word(b[15]);
    }
    return true;
}

static bool take_geo(const nav_lines *r, const double *a, const double *b, orr_nav_eph *e, nav_fault *f)
{
    orr_nav_geo *g = &e->geo;
    e->kind = ORR_NAV_GEO;
    e->af2_sps2 = 0;
    e->toe = e->toc;
    if (!take_state(r, b, &g->pos_m, &g->vel_mps, &g->acc_mps2, f)) return false;
    e->transmission = transmission_time(a[2], 'S', e->toe);
    e->health = word(b[3]);
    g->ura_m = b[7];
    g->iodn = whole(b[11], ORR_NAV_NO_IOD);
    e->accuracy_m = b[7];
    return true;
}

// The satellite of a record's first line.
static orr_sat sat_of(const nav_lines *r, bool v2, char system)
{
    orr_view line = r->line[0].text;
    if (!v2) return line.n >= 3 ? orr_sat_parse3(line.p, 0) : ORR_SAT_NONE;
    int number = 0;
    if (orr_field_int_in(line, 1, 2, 1, 99, &number) != ORR_FIELD_OK) return ORR_SAT_NONE;
    return orr_sat_make(system, number);
}

// Bit i: field i of the continuation lines is read into the ephemeris. What stands in the spare ones does not matter.
static uint64_t used_fields(char system, orr_nav_message m)
{
#define FIELDS(from, to) ((UINT64_C(2) << (to)) - (UINT64_C(1) << (from)))
    switch (m) {
    case ORR_NAV_FDMA:
        return FIELDS(0, 15);
    case ORR_NAV_SBAS:
        return FIELDS(0, 11);
    case ORR_NAV_INAV:
    case ORR_NAV_FNAV:
        return FIELDS(0, 18) | FIELDS(20, 24);
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        return FIELDS(0, 16) | FIELDS(18, 18) | FIELDS(20, 25);
    case ORR_NAV_CNAV:
        return FIELDS(0, 29);
    case ORR_NAV_CNV1:
        return FIELDS(0, 24) | FIELDS(26, 32) | FIELDS(35, 35);
    case ORR_NAV_CNV2:
        return system == 'C' ? FIELDS(0, 23) | FIELDS(25, 32) | FIELDS(35, 35)
                             : FIELDS(0, 29) | FIELDS(32, 33);
    case ORR_NAV_CNV3:
        return FIELDS(0, 28);
    case ORR_NAV_L1NV:
        return FIELDS(0, 17) | FIELDS(20, 29);
    default:
        return system == 'I' ? FIELDS(0, 16) | FIELDS(18, 18) | FIELDS(20, 22) | FIELDS(24, 24)
                             : FIELDS(0, 25);
    }
#undef FIELDS
}

// All fields of the continuation lines; bit i of the result: field i is there and no number (it is NAN then).
static uint64_t read_fields(const nav_lines *r, size_t lines, int column, double b[NAV_MAX_FIELDS])
{
    uint64_t bad = 0;
    nav_fault unsaid;
    for (size_t i = 0; i < NAV_MAX_FIELDS; i++) b[i] = ORR_NAN;
    for (size_t i = 0; i + 1 < lines; i++)
        for (int k = 0; k < 4; k++) {
            size_t at = 4 * i + (size_t)k;
            if (orr_nav_field(r, 1 + i, column + 19 * k, &b[at], &unsaid)) continue;
            b[at] = ORR_NAN;
            bad |= UINT64_C(1) << at;
        }
    return bad;
}

bool orr_nav_take_eph(const nav_lines *r, bool v2, char system, orr_nav_message message, orr_nav_eph *e,
                      nav_fault *f)
{
    const nav_line *first = &r->line[0];
    memset(e, 0, sizeof *e);
    no_extras(e);
    e->line = r->tag.text.p != NULL ? r->tag.number : first->number;
    e->sat = sat_of(r, v2, system);
    if (e->sat == ORR_SAT_NONE) return orr_nav_fault(f, first->number, 1, "a satellite that is not readable");
    system = orr_sat_system(e->sat);
    int column = v2 ? 4 : 5, clock_column = v2 ? 23 : 24;
    bool glonass = system == 'R', geo = system == 'S';
    if (system == 'L') return orr_nav_fault(f, first->number, 1, "a satellite of no navigation system");
    if (message != ORR_NAV_NONE && !message_fits(system, message))
        return orr_nav_fault(f, e->line, 11, "%s is no message of %s", orr_nav_message_name(message),
                             orr_system_name(system));

    size_t want = 1 + lines_of(system, message == ORR_NAV_NONE ? ORR_NAV_LNAV : message), got = r->n;
    bool flags_line = glonass && got == want + 1; // 3.05 and later; some files of 3.05 lack it
    if (flags_line || (geo && got == want + 1 && v2 == false && orr_view_is_blank(r->line[want].text)))
        want = got;
    if (got != want)
        return orr_nav_fault(f, first->number, 0, "a record of %zu lines instead of %zu", got, want);
    if (!orr_nav_epoch(r, 0, v2, orr_nav_scale_of(system), &e->toc, f)) return false;
    double a[3], b[NAV_MAX_FIELDS];
    for (int i = 0; i < 3; i++)
        if (!orr_nav_field(r, 0, clock_column + 19 * i, &a[i], f)) return false;
    uint64_t bad = read_fields(r, want, column, b);
    if (isnan(a[0])) return orr_nav_fault(f, first->number, clock_column, "the satellite clock is missing");
    e->af0_s = a[0];
    e->af1_sps = or_zero(a[1]);
    e->af2_sps2 = or_zero(a[2]);
    if (message == ORR_NAV_NONE) message = message_of(system, orr_sat_number(e->sat), b[17]);
    e->message = (uint8_t)message;
    for (size_t i = 0; i < NAV_MAX_FIELDS; i++) // the first bad one that is used says what is wrong
        if ((bad & used_fields(system, message)) >> i & 1)
            return orr_nav_field(r, 1 + i / 4, column + 19 * (int)(i % 4), &b[i], f);
    if (glonass) return take_glonass(r, a, b, flags_line, v2, e, f);
    if (geo) return take_geo(r, a, b, e, f);

    e->kind = ORR_NAV_KEPLER;
    bool gps_cnav = system != 'C' && (message == ORR_NAV_CNAV || message == ORR_NAV_CNV2);
    if (!take_kepler(r, b, e, system, gps_cnav, f)) return false;
    switch (message) {
    case ORR_NAV_LNAV:
        if (system == 'I')
            take_navic(b, e, false);
        else
            take_gps_lnav(b, e, system);
        break;
    case ORR_NAV_L1NV:
        take_navic(b, e, true);
        break;
    case ORR_NAV_CNAV:
        take_cnav(b, e, system, false);
        break;
    case ORR_NAV_INAV:
    case ORR_NAV_FNAV:
        take_galileo(b, e);
        break;
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        take_beidou_legacy(b, e);
        break;
    case ORR_NAV_CNV2:
        if (system == 'C')
            take_beidou_cnav(b, e, message);
        else
            take_cnav(b, e, system, true);
        break;
    default:
        take_beidou_cnav(b, e, message);
        break;
    }
    bool week_of_toe = e->week >= 0 && !gps_cnav && message != ORR_NAV_L1NV;
    if (week_of_toe && e->week != week_of(e->toe, system))
        orr_nav_fault(f, first->number, 0,
                      "the week number %d is not that of the time of ephemeris (%d): the dates are kept",
                      (int)e->week, (int)week_of(e->toe, system));
    return true;
}
