// SPDX-License-Identifier: GPL-3.0-or-later
// Header lines of observation files, also those that come in events. What decides how the data are read
// (types, time system, scale factors) is refused when damaged; the rest is reported and left at "not given".
#include <math.h>
#include <string.h>

#include "ingest/rinex/rinex_obs_private.h"

static void text(orr_view line, int col, int width, char *out, size_t n)
{
    orr_view_copy(orr_view_trim(orr_view_cols(line, col, width)), out, n);
}

orr_status orr_obs_header_first(orr_rinex_obs_header *h, const orr_rinex_first *first, const obs_context *c)
{
    if (first->type != 'O')
        return orr_diag_at(c->diag, ORR_E_KIND, c->name, c->line, 21,
                           "a RINEX file of type '%c', not of observations", first->type);
    h->version = first->version;
    orr_rinex_check_version(c->name, first->version, c->warnings);
    char s = first->system == ' ' ? 'G' : first->system; // a blank is GPS in RINEX 2
    if (s == 'T')
        return orr_diag_at(c->diag, ORR_E_UNSUPPORTED, c->name, c->line, 41,
                           "Transit (NNSS) observations are not read");
    if (s == 'D')
        return orr_diag_at(c->diag, ORR_E_UNSUPPORTED, c->name, c->line, 41,
                           "DORIS observations are not read");
    if (s != 'M' && orr_obs_system_index(s) < 0)
        return orr_diag_at(c->diag, ORR_E_UNSUPPORTED, c->name, c->line, 41,
                           "'%c' is no satellite system that is read", s);
    h->system = s;
    switch (s) {
    case 'R':
        h->scale = ORR_SCALE_GLO;
        break;
    case 'E':
        h->scale = ORR_SCALE_GAL;
        break;
    case 'C':
        h->scale = ORR_SCALE_BDT;
        break;
    case 'J':
        h->scale = ORR_SCALE_QZS;
        break;
    case 'I':
        h->scale = ORR_SCALE_IRN;
        break;
    default:
        h->scale = ORR_SCALE_GPS;
        break;
    }
    return ORR_OK;
}

// Three numbers and nothing else within the first 60 columns, wherever they stand.
static bool three_words(orr_view line, double out[3])
{
    orr_view rest = orr_view_cols(line, 1, 60), word;
    for (int i = 0; i < 3; i++)
        if (!orr_view_word(&rest, &word) || orr_view_real(word, &out[i]) != ORR_FIELD_OK) return false;
    return orr_view_is_blank(rest);
}

// Three F14.4, or three numbers that stand beside their columns, as edited files have them; false with a warning where they are
// not numbers.
static bool three(orr_view line, const obs_context *c, double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = 0; // blank is zero here, as Fortran reads it
        if (orr_field_real(line, 1 + 14 * i, 14, &out[i]) == ORR_FIELD_BAD) {
            if (three_words(line, out)) return true;
            orr_obs_header_warn(c, 1 + 14 * i, "not a number: the header line is left out");
            return false;
        }
    }
    return true;
}

static void phase_shift(orr_rinex_obs_header *h, orr_view line, const obs_context *c)
{
    int system = orr_obs_system_index(orr_view_char(line, 1));
    char code[4];
    double shift = 0;
    if (system < 0 || !orr_obs_code_text(line, 3, 3, code))
        return; // continuation, or a system without known shifts
    if (orr_field_real(line, 7, 8, &shift) == ORR_FIELD_BAD) {
        orr_obs_header_warn(c, 7, "the phase shift is not a number");
        return;
    }
    int n_sats = 0;
    if (orr_field_int_in(line, 17, 2, 0, 99, &n_sats) == ORR_FIELD_OK && n_sats > 0)
        return; // of some satellites only
    orr_obs_codes *codes = &h->codes[system];
    for (size_t j = 0; j < codes->n; j++)
        if (strcmp(codes->code[j], code) == 0) codes->phase_shift_cyc[j] = shift;
}

static void glonass_slots(orr_rinex_obs_header *h, orr_view line, const obs_context *c)
{
    for (int i = 0; i < 8; i++) {
        orr_view id = orr_view_cols(line, 5 + 7 * i, 3);
        if (orr_view_is_blank(id)) continue;
        int k = 0;
        orr_sat sat = id.n == 3 ? orr_sat_parse3(id.p, 'R') : ORR_SAT_NONE;
        if (sat == ORR_SAT_NONE || orr_sat_system(sat) != 'R' ||
            orr_field_int_in(line, 9 + 7 * i, 2, -7, 13, &k) != ORR_FIELD_OK) {
            orr_obs_header_warn(c, 5 + 7 * i, "a GLONASS slot and frequency channel that are not readable");
            continue;
        }
        h->glonass_channel[orr_sat_number(sat)] = (int8_t)k;
    }
}

static void glonass_bias(orr_rinex_obs_header *h, orr_view line, const obs_context *c)
{
    h->has_glonass_bias = true;
    for (int i = 0; i < 4; i++) {
        if (!orr_obs_code_text(line, 2 + 13 * i, 3, h->glonass_bias[i].code)) continue;
        if (orr_field_real(line, 6 + 13 * i, 8, &h->glonass_bias[i].bias_m) == ORR_FIELD_BAD)
            orr_obs_header_warn(c, 6 + 13 * i, "the GLONASS bias is not a number");
    }
}

static void wavelength(orr_rinex_obs_header *h, orr_view line, const obs_context *c)
{
    int l1 = 1, l2 = 1, n = 0;
    if (orr_field_int_in(line, 1, 6, 0, 2, &l1) == ORR_FIELD_BAD ||
        orr_field_int_in(line, 7, 6, 0, 2, &l2) == ORR_FIELD_BAD ||
        orr_field_int_in(line, 13, 6, 0, 99, &n) == ORR_FIELD_BAD) {
        orr_obs_header_warn(c, 1, "the wavelength factors are not readable");
        return;
    }
    if (n == 0) {
        h->wavelength = (orr_obs_wavelength){l1, l2};
        return;
    }
    for (int i = 0; i < n && i < 7; i++) {
        orr_view id = orr_view_cols(line, 22 + 6 * i, 3);
        orr_sat sat = id.n == 3 ? orr_sat_parse3(id.p, h->system == 'M' ? 'G' : h->system) : ORR_SAT_NONE;
        if (sat == ORR_SAT_NONE) {
            orr_obs_header_warn(c, 22 + 6 * i, "a satellite of the wavelength factors is not readable");
            continue;
        }
        h->sat_wavelength[orr_sat_system_index(sat)][orr_sat_number(sat)] = (orr_obs_wavelength){l1, l2};
    }
}

// TIME OF FIRST (LAST) OBS; is_first decides the file's time system.
static orr_status header_time(orr_rinex_obs_header *h, orr_view line, bool is_first, const obs_context *c)
{
    // A3 in column 49; in edited files it stands beside it, and the seconds reach into what is blank otherwise.
    orr_view rest = orr_view_cols(line, 44, 17), word, name = {"", 0};
    while (orr_view_word(&rest, &word))
        if (word.p[0] < '0' || word.p[0] > '9') name = word;
    if (name.n > 0) {
        orr_scale scale;
        if (orr_scale_parse(name.p, name.n, &scale) != ORR_OK)
            return orr_diag_at(c->diag, ORR_E_UNSUPPORTED, c->name, c->line, 49,
                               "the time system \"%.*s\" is not known", (int)name.n, name.p);
        if (is_first) h->scale = scale;
    }
    orr_rinex_date d = {0};
    int *field[5] = {&d.year, &d.month, &d.day, &d.hour, &d.minute};
    orr_time t = ORR_TIME_NONE;
    bool good = orr_rinex_seconds(line, 31, 13, &d.second_ps);
    for (int i = 0; i < 5; i++)
        good = good && orr_field_int_in(line, 1 + 6 * i, 6, 0, 9999, field[i]) == ORR_FIELD_OK;
    if (good) good = orr_rinex_time(&d, h->scale, c->leap, &t) == ORR_OK;
    if (!good) orr_obs_header_warn(c, 1, "the time is not readable: the header line is left out");
    *(is_first ? &h->first : &h->last) = good ? t : ORR_TIME_NONE;
    if (is_first) h->first = good ? t : ORR_TIME_NONE;
    return ORR_OK;
}

typedef enum label_id {
    L_TYPES2,
    L_TYPES3,
    L_FIRST,
    L_LAST,
    L_SCALE,
    L_SCALE2,
    L_SHIFT,
    L_SLOTS,
    L_BIAS,
    L_WAVELENGTH,
    L_MARKER,
    L_NUMBER,
    L_TYPE,
    L_OBSERVER,
    L_RECEIVER,
    L_ANTENNA,
    L_POSITION,
    L_HEN,
    L_XYZ,
    L_MASS,
    L_INTERVAL,
    L_CLOCK,
    L_LEAP,
    L_SATS,
    L_UNIT,
    L_PGM,
    L_END,
    L_IGNORED
} label_id;

static const struct {
    const char *label;
    label_id id;
} labels[] = {
    {"COMMENT", L_IGNORED},
    {"# / TYPES OF OBSERV", L_TYPES2},
    {"SYS / # / OBS TYPES", L_TYPES3},
    {"TIME OF FIRST OBS", L_FIRST},
    {"TIME OF LAST OBS", L_LAST},
    {"SYS / SCALE FACTOR", L_SCALE},
    {"OBS SCALE FACTOR", L_SCALE2},
    {"SYS / PHASE SHIFT", L_SHIFT},
    {"SYS / PHASE SHIFTS", L_SHIFT}, // 3.01
    {"GLONASS SLOT / FRQ #", L_SLOTS},
    {"GLONASS COD/PHS/BIS", L_BIAS},
    {"GLONASS COD/PHS/BIS#", L_BIAS}, // some encoders
    {"WAVELENGTH FACT L1/2", L_WAVELENGTH},
    {"MARKER NAME", L_MARKER},
    {"MARKER NUMBER", L_NUMBER},
    {"MARKER TYPE", L_TYPE},
    {"OBSERVER / AGENCY", L_OBSERVER},
    {"REC # / TYPE / VERS", L_RECEIVER},
    {"ANT # / TYPE", L_ANTENNA},
    {"APPROX POSITION XYZ", L_POSITION},
    {"ANTENNA: DELTA H/E/N", L_HEN},
    {"ANTENNA: DELTA X/Y/Z", L_XYZ},
    {"CENTER OF MASS: XYZ", L_MASS},
    {"INTERVAL", L_INTERVAL},
    {"RCV CLOCK OFFS APPL", L_CLOCK},
    {"LEAP SECONDS", L_LEAP},
    {"# OF SATELLITES", L_SATS},
    {"SIGNAL STRENGTH UNIT", L_UNIT},
    {"PGM / RUN BY / DATE", L_PGM},
    {"END OF HEADER", L_END},
    {"PRN / # OF OBS", L_IGNORED}, // the data say it themselves
    {"SYS / DCBS APPLIED", L_IGNORED},
    {"SYS / PCVS APPLIED", L_IGNORED},
    {"ANTENNA: PHASECENTER", L_IGNORED},
    {"ANTENNA: B.SIGHT XYZ", L_IGNORED},
    {"ANTENNA: ZERODIR AZI", L_IGNORED},
    {"ANTENNA: ZERODIR XYZ", L_IGNORED},
    {"STATION INFORMATION", L_IGNORED},
    {"LICENSE OF USE", L_IGNORED},
    {"DOI", L_IGNORED},
    {"MERGED FILE", L_IGNORED},
    {"CRINEX PROG / DATE", L_IGNORED},
};

static void numbers(orr_rinex_obs_header *h, label_id id, orr_view line, const obs_context *c)
{
    double v[3];
    int64_t n = 0;
    switch (id) {
    case L_POSITION:
        h->has_position = three(line, c, v);
        if (h->has_position) h->position_m = (orr_vec3){v[0], v[1], v[2]};
        break;
    case L_HEN:
        if (!three(line, c, v)) break;
        h->antenna_h_m = v[0];
        h->antenna_e_m = v[1];
        h->antenna_n_m = v[2];
        break;
    case L_XYZ:
        if (three(line, c, v)) h->antenna_xyz_m = (orr_vec3){v[0], v[1], v[2]};
        break;
    case L_MASS:
        if (three(line, c, v)) h->centre_of_mass_m = (orr_vec3){v[0], v[1], v[2]};
        break;
    case L_INTERVAL:
        if (orr_field_real(line, 1, 10, &h->interval_s) == ORR_FIELD_BAD)
            orr_obs_header_warn(c, 1, "the interval is not a number");
        break;
    case L_CLOCK:
        if (orr_field_int(line, 1, 6, &n) == ORR_FIELD_BAD) orr_obs_header_warn(c, 1, "not a number");
        h->clock_applied = n == 1;
        break;
    case L_LEAP:
        h->has_leap = orr_field_int_in(line, 1, 6, -99, 999, &h->leap_s) == ORR_FIELD_OK;
        if (!h->has_leap) orr_obs_header_warn(c, 1, "the leap seconds are not a number");
        break;
    default:
        if (orr_field_int_in(line, 1, 6, 0, 9999, &h->declared_sats) == ORR_FIELD_BAD)
            orr_obs_header_warn(c, 1, "not a number");
        break;
    }
}

static void texts(orr_rinex_obs_header *h, label_id id, orr_view line)
{
    switch (id) {
    case L_MARKER:
        text(line, 1, 60, h->marker_name, sizeof h->marker_name);
        break;
    case L_NUMBER:
        text(line, 1, 20, h->marker_number, sizeof h->marker_number);
        break;
    case L_TYPE:
        text(line, 1, 20, h->marker_type, sizeof h->marker_type);
        break;
    case L_OBSERVER:
        text(line, 1, 20, h->observer, sizeof h->observer);
        text(line, 21, 40, h->agency, sizeof h->agency);
        break;
    case L_RECEIVER:
        text(line, 1, 20, h->receiver_number, sizeof h->receiver_number);
        text(line, 21, 20, h->receiver_type, sizeof h->receiver_type);
        text(line, 41, 20, h->receiver_version, sizeof h->receiver_version);
        break;
    case L_ANTENNA:
        text(line, 1, 20, h->antenna_number, sizeof h->antenna_number);
        text(line, 21, 20, h->antenna_type, sizeof h->antenna_type);
        break;
    case L_UNIT:
        text(line, 1, 20, h->signal_unit, sizeof h->signal_unit);
        break;
    default:
        text(line, 1, 20, h->program, sizeof h->program);
        text(line, 21, 20, h->run_by, sizeof h->run_by);
        text(line, 41, 20, h->date, sizeof h->date);
        break;
    }
}

orr_status orr_obs_header_line(orr_rinex_obs_header *h, obs_header_state *st, orr_view line,
                               const obs_context *c)
{
    orr_view label = orr_rinex_label(line);
    orr_rinex_check_width(c->name, c->line, line, &st->wide, c->warnings);
    size_t i = 0, n = sizeof labels / sizeof labels[0];
    while (i < n && !orr_view_equals(label, labels[i].label)) i++;
    if (i == n) {
        if (!orr_view_is_blank(line))
            orr_warnings_add(c->warnings, c->name, c->line, 61,
                             "the header label \"%.*s\" is not known: the line is ignored",
                             (int)(label.n < 20 ? label.n : 20), label.p);
        return ORR_OK;
    }
    label_id id = labels[i].id;
    switch (id) {
    case L_IGNORED:
        return ORR_OK;
    case L_END:
        st->ended = true;
        return ORR_OK;
    case L_TYPES2:
        if (h->version >= 3)
            return orr_obs_header_refuse(c, 61, "observation types of RINEX 2 in a file of RINEX 3 or 4");
        return orr_obs_types_v2(st, line, c);
    case L_TYPES3:
        if (h->version < 3)
            return orr_obs_header_refuse(c, 61, "observation types of RINEX 3 in a file of RINEX 2");
        return orr_obs_types_v3(h, st, line, c);
    case L_FIRST:
        st->seen |= OBS_SEEN_FIRST;
        return header_time(h, line, true, c);
    case L_LAST:
        return header_time(h, line, false, c);
    case L_SCALE:
        return orr_obs_scale_factor(h, line, c);
    case L_SCALE2:
        if (h->version >= 3)
            return orr_obs_header_refuse(c, 61, "scale factors of RINEX 2 in a file of RINEX 3 or 4");
        return orr_obs_scale_factor_v2(st, line, c);
    case L_SHIFT:
        phase_shift(h, line, c);
        return ORR_OK;
    case L_SLOTS:
        glonass_slots(h, line, c);
        return ORR_OK;
    case L_BIAS:
        glonass_bias(h, line, c);
        return ORR_OK;
    case L_WAVELENGTH:
        wavelength(h, line, c);
        return ORR_OK;
    case L_MARKER:
        st->seen |= OBS_SEEN_MARKER;
        texts(h, id, line);
        return ORR_OK;
    case L_NUMBER:
    case L_TYPE:
    case L_OBSERVER:
    case L_RECEIVER:
    case L_ANTENNA:
    case L_UNIT:
    case L_PGM:
        texts(h, id, line);
        return ORR_OK;
    default:
        numbers(h, id, line, c);
        return ORR_OK;
    }
}

orr_status orr_obs_header_check(orr_rinex_obs_header *h, obs_header_state *st, const obs_context *c)
{
    if (st->open_want > 0 || st->v2_n < st->v2_want)
        return orr_obs_header_refuse(c, 0, "the header names fewer observation types than it announces");
    if (!(st->seen & OBS_SEEN_TYPES))
        return orr_obs_header_refuse(c, 0, "the header names no observation types");
    if (h->version >= 3) return ORR_OK;
    double scale[ORR_OBS_MAX_CODES];
    orr_status status = orr_obs_scales_of_v2(st, scale, c);
    if (status != ORR_OK) return status;
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++) {
        char system = ORR_SYSTEMS[s];
        orr_obs_codes_clear(&h->codes[s]);
        if (system == 'L') continue; // the one list holds for whatever satellites come
        for (size_t i = 0; i < st->v2_n; i++) {
            char code[4];
            orr_obs_code_of_v2(system, st->v2_type[i], (const char(*)[4])st->v2_type, st->v2_n, code);
            orr_status r = orr_obs_codes_add(&h->codes[s], code, st->v2_type[i], c->diag);
            if (r != ORR_OK) return r;
            h->codes[s].scale[i] = scale[i];
        }
    }
    return ORR_OK;
}
