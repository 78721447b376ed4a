// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/navframe.h"

#include <string.h>

#include "orbit/navdata/navframe_private.h"

static navframe_make *maker_of(char system, uint8_t message)
{
    switch (message) {
    case ORR_NAV_LNAV:
        return system == 'I' ? navframe_navic : navframe_lnav;
    case ORR_NAV_FDMA:
        return navframe_glonass;
    case ORR_NAV_INAV:
        return navframe_inav;
    case ORR_NAV_FNAV:
        return navframe_fnav;
    case ORR_NAV_D1:
        return navframe_d1;
    case ORR_NAV_D2:
        return navframe_d2;
    case ORR_NAV_SBAS:
        return navframe_sbas;
    case ORR_NAV_CNAV:
        return navframe_cnav;
    case ORR_NAV_CNV1:
        return navframe_bcnav1;
    case ORR_NAV_CNV2:
        return system == 'C' ? navframe_bcnav2 : navframe_cnav2;
    case ORR_NAV_CNV3:
        return navframe_bcnav3;
    default:
        return NULL;
    }
}

orr_status orr_navframe_at(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                           bool coded, orr_navframe *out, orr_diag *diag)
{
    orr_diag why = {0};
    char name[ORR_SAT_TEXT];
    const orr_nav_stream *list[ORR_NAVSET_STREAMS];
    if (stream == NULL && orr_navset_streams(set, sat, list) > 0) stream = list[0];
    navframe_make *make = stream != NULL ? maker_of(stream->system, stream->message) : NULL;
    memset(out, 0, sizeof *out);
    out->sat = sat, out->coded = coded, out->stream = stream;
    const orr_status s = make != NULL ? make(set, sat, stream, t, coded, out, &why) : ORR_E_NODATA;
    if (s == ORR_OK) return s;
    return orr_diag_set(diag, s, "%s: %.400s", orr_sat_text(sat, name),
                        s == ORR_E_NODATA ? "it sends nothing at that instant" : why.text);
}
