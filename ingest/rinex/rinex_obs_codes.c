// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of observation codes, and what the two-character types of RINEX 2 are taken for (RINEX 3.05, table 23
// and 5.2).
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_obs_private.h"

void orr_obs_codes_clear(orr_obs_codes *codes)
{
    free(codes->code);
    free(codes->original);
    free(codes->scale);
    free(codes->phase_shift_cyc);
    *codes = (orr_obs_codes){0};
}

orr_status orr_obs_codes_add(orr_obs_codes *codes, const char *code, const char *original, orr_diag *diag)
{
    if (codes->n >= ORR_OBS_MAX_CODES)
        return orr_diag_set(diag, ORR_E_LIMIT, "more than %d observation types of one system",
                            ORR_OBS_MAX_CODES);
    if (codes->code == NULL) {
        codes->code = calloc(ORR_OBS_MAX_CODES, sizeof *codes->code);
        codes->original = calloc(ORR_OBS_MAX_CODES, sizeof *codes->original);
        codes->scale = calloc(ORR_OBS_MAX_CODES, sizeof *codes->scale);
        codes->phase_shift_cyc = calloc(ORR_OBS_MAX_CODES, sizeof *codes->phase_shift_cyc);
        if (codes->code == NULL || codes->original == NULL || codes->scale == NULL ||
            codes->phase_shift_cyc == NULL) {
            orr_obs_codes_clear(codes);
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        }
    }
    size_t i = codes->n++;
    for (size_t k = 0; k < 4; k++) codes->code[i][k] = codes->original[i][k] = '\0';
    for (size_t k = 0; k < 3 && code[k] != '\0'; k++) codes->code[i][k] = code[k];
    for (size_t k = 0; k < 3 && original[k] != '\0'; k++) codes->original[i][k] = original[k];
    codes->scale[i] = 1;
    codes->phase_shift_cyc[i] = ORR_NAN;
    return ORR_OK;
}

static bool has(const char (*set)[4], size_t n, const char *type)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(set[i], type) == 0) return true;
    return false;
}

// The tracking attribute of band `band` in a system; 0 if the pair is unknown. first is 'C' (code of a civil
// signal), 'P' (precise code), or one of L, D, S, which are taken to come from the signal that the file's
// codes point to.
static char attribute(char system, char first, char band, const char (*set)[4], size_t n)
{
    bool p2 = has(set, n, "P2"), c2 = has(set, n, "C2"), la = has(set, n, "LA");
    switch (system) {
    case 'G':
        if (band == '1') return first == 'P' || (first == 'L' && la) ? 'W' : 'C';
        if (band == '2') return first == 'C' || (first != 'P' && c2 && !p2) ? 'X' : 'W';
        return band == '5' && first != 'P' ? 'X' : 0;
    case 'J':
        if (first == 'P') return 0;
        if (band == '1') return 'C';
        return band == '2' || band == '5' || band == '6' ? 'X' : 0;
    case 'R':
        if (band == '1') return first == 'P' ? 'P' : 'C';
        if (band == '2') return first == 'P' || (first != 'C' && !(c2 && !p2)) ? 'P' : 'C';
        return 0;
    case 'E':
        return first != 'P' && strchr("15678", band) != NULL ? 'X' : 0;
    case 'S':
        if (first == 'P') return 0;
        return band == '1' ? 'C' : band == '5' ? 'I' : 0;
    case 'C':
        return first != 'P' && strchr("1267", band) != NULL ? 'I' : 0;
    default:
        return 0;
    }
}

void orr_obs_code_of_v2(char system, const char *type, const char (*set)[4], size_t n, char out[4])
{
    memset(out, 0, 4);
    if (type[0] == '\0' || type[1] == '\0' || type[2] != '\0') return;
    char first = type[0], band = type[1];
    if (band == 'A' && (first == 'L' || first == 'S' || first == 'D') &&
        system == 'G') { // 2.20: from C/A code
        out[0] = first;
        out[1] = '1';
        out[2] = 'C';
        return;
    }
    if (strchr("CPLDS", first) == NULL || band < '1' || band > '9') return;
    char a = attribute(system, first, band, set, n);
    if (a == 0) return;
    out[0] = first == 'P' ? 'C' : first;
    out[1] =
        system == 'C' && band == '1' ? '2' : band; // B1I is band 2 in RINEX 3, C1/C2 in the 2.12 of the day
    out[2] = a;
}

int orr_obs_code_index(const orr_rinex_obs_header *h, char system, const char *code)
{
    const char *at = system != '\0' ? strchr(ORR_SYSTEMS, system) : NULL;
    if (at == NULL) return -1;
    const orr_obs_codes *c = &h->codes[at - ORR_SYSTEMS];
    for (size_t i = 0; i < c->n; i++)
        if (strcmp(c->code[i], code) == 0) return (int)i;
    return -1;
}

void orr_rinex_obs_header_init(orr_rinex_obs_header *h)
{
    *h = (orr_rinex_obs_header){0};
    double nan = ORR_NAN;
    h->version = 3.05;
    h->system = 'M';
    h->antenna_h_m = h->antenna_e_m = h->antenna_n_m = nan;
    h->position_m = h->antenna_xyz_m = h->centre_of_mass_m = (orr_vec3){nan, nan, nan};
    h->wavelength = (orr_obs_wavelength){1, 1};
    for (size_t i = 0; i < 100; i++) h->glonass_channel[i] = ORR_OBS_NO_CHANNEL;
    for (size_t i = 0; i < 4; i++) h->glonass_bias[i].bias_m = nan;
    h->interval_s = nan;
    h->scale = ORR_SCALE_GPS;
    h->first = h->last = ORR_TIME_NONE;
    h->declared_sats = -1;
}

orr_status orr_rinex_obs_header_add_code(orr_rinex_obs_header *h, char system, const char *code,
                                         orr_diag *diag)
{
    const char *at = system != '\0' ? strchr(ORR_SYSTEMS, system) : NULL;
    if (at == NULL) return orr_diag_set(diag, ORR_E_ARG, "'%c' is no satellite system", system);
    if (strlen(code) != 3 || strchr("CLDSIX", code[0]) == NULL)
        return orr_diag_set(diag, ORR_E_ARG, "\"%s\" is no RINEX 3 observation code", code);
    return orr_obs_codes_add(&h->codes[at - ORR_SYSTEMS], code, code, diag);
}

void orr_rinex_obs_header_free(orr_rinex_obs_header *h)
{
    for (size_t i = 0; i < ORR_N_SYSTEMS; i++) orr_obs_codes_clear(&h->codes[i]);
}
