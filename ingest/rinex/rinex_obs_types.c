// SPDX-License-Identifier: GPL-3.0-or-later
// Header lines that tell what is observed and in which units: types and scale factors. They decide how the data are read,
// so that damaged ones are refused.
#include <math.h>
#include <string.h>

#include "ingest/rinex/rinex_obs_private.h"

void orr_obs_header_warn(const obs_context *c, int column, const char *what)
{
    orr_warnings_add(c->warnings, c->name, c->line, column, "%s", what);
}

orr_status orr_obs_header_refuse(const obs_context *c, int column, const char *what)
{
    return orr_diag_at(c->diag, ORR_E_FORMAT, c->name, c->line, column, "%s", what);
}

int orr_obs_system_index(char c)
{
    const char *at = c != '\0' ? strchr(ORR_SYSTEMS, c) : NULL;
    return at == NULL || c == 'L' ? -1 : (int)(at - ORR_SYSTEMS);
}

bool orr_obs_code_text(orr_view line, int col, int width, char out[4])
{
    orr_view v = orr_view_trim(orr_view_cols(line, col, width));
    memset(out, 0, 4);
    if (v.n < 2 || v.n > 3) return false;
    for (size_t i = 0; i < v.n; i++) {
        if (v.p[i] <= ' ' || v.p[i] > '~') return false;
        out[i] = v.p[i];
    }
    return true;
}

orr_status orr_obs_types_v3(orr_rinex_obs_header *h, obs_header_state *st, orr_view line,
                            const obs_context *c)
{
    char system = orr_view_char(line, 1);
    if (system != ' ') {
        int n = 0;
        if (st->open_want > 0)
            return orr_obs_header_refuse(c, 1, "the list of types before this one is not complete");
        st->open_system = orr_obs_system_index(system);
        if (orr_field_int_in(line, 4, 3, 0, ORR_OBS_MAX_CODES, &n) != ORR_FIELD_OK)
            return orr_obs_header_refuse(c, 4, "the number of observation types is not usable (limit 128)");
        if (st->open_system < 0)
            orr_obs_header_warn(
                c, 1, "observation types of a system that is not read: its satellites are left out");
        else
            orr_obs_codes_clear(&h->codes[st->open_system]); // an event may give a new list
        st->open_want = (size_t)n;
    } else if (st->open_want == 0) {
        return orr_obs_header_refuse(c, 1,
                                     "a continuation line of observation types without a line to continue");
    }
    for (int i = 0; i < 13 && st->open_want > 0; i++) {
        char code[4];
        if (!orr_obs_code_text(line, 8 + 4 * i, 3, code))
            return orr_obs_header_refuse(c, 8 + 4 * i, "an observation type is missing or not readable");
        st->open_want--;
        if (st->open_system < 0) continue;
        orr_status s = orr_obs_codes_add(&h->codes[st->open_system], code, code, c->diag);
        if (s != ORR_OK) return s;
    }
    st->seen |= OBS_SEEN_TYPES;
    return ORR_OK;
}

orr_status orr_obs_types_v2(obs_header_state *st, orr_view line, const obs_context *c)
{
    if (!orr_view_is_blank(orr_view_cols(line, 1, 6))) {
        int n = 0;
        if (orr_field_int_in(line, 1, 6, 1, ORR_OBS_MAX_CODES, &n) != ORR_FIELD_OK)
            return orr_obs_header_refuse(c, 1, "the number of observation types is not usable (limit 128)");
        st->v2_want = (size_t)n;
        st->v2_n = 0;
    }
    for (int i = 0; i < 9 && st->v2_n < st->v2_want; i++) {
        if (!orr_obs_code_text(line, 7 + 6 * i, 6, st->v2_type[st->v2_n]))
            return orr_obs_header_refuse(c, 7 + 6 * i, "an observation type is missing or not readable");
        st->v2_n++;
    }
    st->seen |= OBS_SEEN_TYPES;
    return ORR_OK;
}

// "   100     2    C1    P1": factor and types that it was multiplied into (RINEX 2.20); no types: all. A line without a
// factor goes on with the types of the one before.
orr_status orr_obs_scale_factor_v2(obs_header_state *st, orr_view line, const obs_context *c)
{
    int n = 0;
    if (!orr_view_is_blank(orr_view_cols(line, 1, 6))) {
        if (orr_field_int_in(line, 1, 6, 1, 999999, &st->v2_scale_now) != ORR_FIELD_OK)
            return orr_obs_header_refuse(c, 1, "the scale factor is not a number");
        if (orr_field_int_in(line, 7, 6, 0, ORR_OBS_MAX_CODES, &n) == ORR_FIELD_BAD)
            return orr_obs_header_refuse(c, 7, "the number of scaled types is not a number");
        st->v2_scale_want = (size_t)n;
        if (n == 0) st->v2_scale_all = st->v2_scale_now;
    }
    for (int i = 0; i < 8 && st->v2_scale_want > 0; i++, st->v2_scale_want--) {
        char type[4];
        if (i > 0 && orr_view_is_blank(orr_view_cols(line, 13 + 6 * i, 48 - 6 * i)))
            break; // the rest on the next line
        if (st->v2_n_scaled == ORR_OBS_MAX_CODES || !orr_obs_code_text(line, 13 + 6 * i, 6, type))
            return orr_obs_header_refuse(c, 13 + 6 * i,
                                         "a scaled observation type is missing or not readable");
        memcpy(st->v2_scale[st->v2_n_scaled].type, type, sizeof type);
        st->v2_scale[st->v2_n_scaled].factor = st->v2_scale_now;
        st->v2_scale[st->v2_n_scaled].column = 13 + 6 * i;
        st->v2_scale[st->v2_n_scaled++].line = c->line;
    }
    return ORR_OK;
}

// The factors of the file's types, when all lines are read.
orr_status orr_obs_scales_of_v2(const obs_header_state *st, double scale[ORR_OBS_MAX_CODES],
                                const obs_context *c)
{
    for (size_t i = 0; i < st->v2_n; i++) scale[i] = st->v2_scale_all > 0 ? st->v2_scale_all : 1;
    for (size_t k = 0; k < st->v2_n_scaled; k++) {
        bool found = false;
        for (size_t i = 0; i < st->v2_n; i++)
            if (strcmp(st->v2_type[i], st->v2_scale[k].type) == 0)
                scale[i] = st->v2_scale[k].factor, found = true;
        if (!found && st->v2_scale[k].factor != 1)
            return orr_diag_at(c->diag, ORR_E_FORMAT, c->name, st->v2_scale[k].line, st->v2_scale[k].column,
                               "a scaled observation type that the file does not have");
    }
    return ORR_OK;
}

orr_status orr_obs_scale_factor(orr_rinex_obs_header *h, orr_view line, const obs_context *c)
{
    int system = orr_obs_system_index(orr_view_char(line, 1)), factor = 1, n = 0;
    if (system < 0) return orr_obs_header_warn(c, 1, "a scale factor of a system that is not read"), ORR_OK;
    if (orr_field_int_in(line, 3, 4, 1, 9999, &factor) != ORR_FIELD_OK)
        return orr_obs_header_refuse(c, 3, "the scale factor is not a number");
    if (orr_field_int_in(line, 9, 2, 0, 99, &n) == ORR_FIELD_BAD)
        return orr_obs_header_refuse(c, 9, "the number of scaled types is not a number");
    orr_obs_codes *codes = &h->codes[system];
    if (n == 0)
        for (size_t j = 0; j < codes->n; j++) codes->scale[j] = factor;
    for (int i = 0; i < n && i < 12; i++) {
        char code[4];
        size_t found = 0;
        bool readable = orr_obs_code_text(line, 12 + 4 * i, 3, code);
        for (size_t j = 0; readable && j < codes->n; j++) {
            if (strcmp(codes->code[j], code) != 0) continue;
            codes->scale[j] = factor;
            found++;
        }
        if (found > 0 || (readable && factor == 1)) continue; // whatever was multiplied by one is as it was
        return orr_obs_header_refuse(c, 12 + 4 * i,
                                     "a scaled observation type that the system does not have");
    }
    if (n > 12) orr_obs_header_warn(c, 9, "only the first 12 types of a scale factor line are read");
    return ORR_OK;
}
