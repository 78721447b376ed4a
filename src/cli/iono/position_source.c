// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/iono/position_source.h"

#include <stdlib.h>

#include "orbit/broadcast/broadcast.h"
#include "orbit/ephemeris/ephemeris.h"

struct orr_position_source {
    orr_ephemeris *product;
    orr_nav nav;
    orr_broadcast_choice choice;
};

orr_status orr_position_source_open(const char *path, orr_position_source **out, orr_warnings *warnings,
                                    orr_diag *diag)
{
    orr_position_source *p = calloc(1, sizeof *p);
    *out = NULL;
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for an orbit");
    p->choice = orr_broadcast_choice_default();
    orr_status s = orr_ephemeris_load(path, &p->product, diag);
    if (s == ORR_E_KIND) s = orr_nav_read(path, NULL, &p->nav, warnings, diag);
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

void orr_position_source_close(orr_position_source *p)
{
    if (p == NULL) return;
    orr_ephemeris_free(p->product);
    orr_nav_free(&p->nav);
    free(p);
}

bool orr_position_source_at(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m)
{
    orr_position_source *p = user;
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
