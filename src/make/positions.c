// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/positions.h"

#include <stdlib.h>
#include <string.h>

#include "orbit/broadcast/broadcast.h"

struct orr_positions {
    orr_ephemeris *product;
    orr_nav nav;
    orr_broadcast_choice choice;
};

// HDF5 (NetCDF-4) or classic NetCDF, by its first bytes.
static bool is_netcdf(const orr_bytes *raw)
{
    return raw->n >= 8 &&
           (memcmp(raw->text, "\x89HDF\r\n\x1a\n", 8) == 0 || memcmp(raw->text, "CDF", 3) == 0);
}

static orr_status parse_nav(const char *path, const orr_bytes *raw, const orr_leap_table *leap, orr_nav *out,
                            orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes text;
    orr_status s = orr_input_read_bytes(path, raw->text, raw->n, NULL, &text, diag);
    orr_nav_limits limits = orr_nav_default_limits();
    limits.leap = leap;
    if (s == ORR_OK) s = orr_nav_parse(path, text.text, text.n, &limits, out, warnings, diag);
    orr_bytes_free(&text);
    return s;
}

orr_status orr_positions_open(const char *path, uint32_t messages, orr_positions **out, orr_inputs *inputs,
                              orr_warnings *warnings, orr_diag *diag)
{
    orr_positions *p = calloc(1, sizeof *p);
    *out = NULL;
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for an orbit");
    p->choice = orr_broadcast_choice_default();
    p->choice.messages = messages;
    orr_bytes raw;
    orr_status s = orr_inputs_read_raw(
        inputs, path, ORR_KIND_BIT(ORR_KIND_NETCDF) | ORR_KIND_BIT(ORR_KIND_RINEX_NAV), &raw, diag);
    if (s == ORR_OK && is_netcdf(&raw))
        s = orr_ephemeris_load(path, &p->product, diag);
    else if (s == ORR_OK)
        s = parse_nav(path, &raw, inputs != NULL ? inputs->leap : NULL, &p->nav, warnings, diag);
    orr_bytes_free(&raw);
    if (s == ORR_E_KIND)
        s = orr_diag_at(
            diag, ORR_E_KIND, path, 0, 0,
            "neither an orbit product (`orrery orbit -o day.nc ...` makes one of SP3 files) nor a RINEX "
            "navigation file");
    if (s != ORR_OK) {
        free(p);
        return s;
    }
    *out = p;
    return ORR_OK;
}

void orr_positions_close(orr_positions *p)
{
    if (p == NULL) return;
    orr_ephemeris_free(p->product);
    orr_nav_free(&p->nav);
    free(p);
}

const orr_nav *orr_positions_nav(const orr_positions *p) { return p->product == NULL ? &p->nav : NULL; }

const orr_ephemeris *orr_positions_product(const orr_positions *p) { return p->product; }

bool orr_positions_at(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m)
{
    orr_positions *p = user;
    if (p->product != NULL) {
        orr_sat_state state;
        if (orr_ephemeris_eval(p->product, sat, t, &state) != ORR_OK) return false;
        *pos_m = state.pos_m;
        return true;
    }
    const orr_nav_eph *eph = orr_broadcast_select(&p->nav, sat, t, &p->choice);
    orr_broadcast_state state;
    if (eph == NULL || orr_broadcast_eval(eph, t, &state) != ORR_OK) return false;
    *pos_m = state.pos_m;
    return true;
}
