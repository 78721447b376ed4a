// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdlib.h>

#include "src/scenario/receiver/msm.h"
#include "src/scenario/receiver/port_private.h"

#define MS INT64_C(1000000)

orr_status orr_port_open(const orr_port_plan *plan, orr_port **out, orr_diag *diag)
{
    size_t n;
    const size_t max = orr_channels_max(plan->channels);
    orr_port *p = calloc(1, sizeof *p);
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    p->plan = *plan;
    p->navset = plan->navdata != NULL ? orr_source_navdata_set(plan->navdata) : NULL;
    p->signal = orr_signals(&n);
    p->antenna = orr_channels_antenna(plan->channels, plan->antenna);
    p->before = ORR_TIME_NONE;
    p->track = calloc(max, sizeof *p->track);
    p->previous = calloc(max, sizeof *p->previous);
    p->cell = calloc(max, sizeof(orr_msm_cell));
    if (p->track == NULL || p->previous == NULL || p->cell == NULL) {
        orr_port_close(p);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    *out = p;
    return ORR_OK;
}

void orr_port_close(orr_port *p)
{
    if (p == NULL) return;
    free(p->track);
    free(p->previous);
    free(p->cell);
    free(p->frame);
    free(p);
}

orr_status orr_port_epoch(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    orr_status s = ORR_OK;
    switch (p->plan.format) {
    case ORR_PORT_RTCM:
        s = port_rtcm(p, o, out, diag);
        break;
    case ORR_PORT_UBX:
        s = port_ubx(p, o, out, diag);
        break;
    case ORR_PORT_NMEA:
        s = port_nmea(p, o, out, diag);
        break;
    }
    p->before = o->t;
    return s == ORR_OK ? orr_port_bytes_status(out, diag) : s;
}

orr_status orr_port_greeting(const orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    if (p->plan.format != ORR_PORT_RTCM) return ORR_OK;
    const orr_status s = port_rtcm_greeting(p, o, out, diag);
    return s == ORR_OK ? orr_port_bytes_status(out, diag) : s;
}

bool orr_port_takes(orr_port_format format, orr_time from, int64_t step_ns)
{
    return format != ORR_PORT_RTCM || (from % MS == 0 && step_ns % MS == 0);
}

uint64_t orr_port_left_out(orr_port_format format, const orr_channels *c)
{
    size_t n;
    uint64_t out = 0;
    const orr_signal *s = orr_signals(&n);
    for (size_t k = 0; k < n; k++) {
        const bool told = format == ORR_PORT_RTCM  ? orr_msm_signal(&s[k]) != 0
                          : format == ORR_PORT_UBX ? port_ubx_signal(&s[k], ORR_SAT_NONE) >= 0
                                                   : true;
        if (!told) out |= UINT64_C(1) << k;
    }
    return out & orr_channels_signals(c);
}
