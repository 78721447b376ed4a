// SPDX-License-Identifier: GPL-3.0-or-later
// The truth behind observations, as tables: channels with all their terms, and the antenna's motion.
#include <stdlib.h>

#include "core/outfile.h"
#include "src/scenario/observables/composite.h"
#include "src/scenario/observables/observe.h"

static void head(FILE *f)
{
    fputs("t_gps,sat,signal,carrier_hz,flags,az_deg,el_deg,code_m,code_rate_mps,carrier_cycles,carrier_"
          "fraction,"
          "carrier_rate_hz,transmit_gps_ns,transmit_fraction_ns,power_dbw,echo,multipath_code_m,multipath_"
          "carrier_cycles,multipath_db",
          f);
    for (int k = 0; k < ORR_N_TERMS; k++) fprintf(f, ",%s_m", orr_term_rows[k].name);
    fputc('\n', f);
}

static void row(FILE *f, const char *t, const orr_channel *x, const orr_composite *m, const orr_signal *s)
{
    char sat[ORR_SAT_TEXT];
    fprintf(f, "%s,%s,%s,%.0f,%u,%.6f,%.6f,%.9f,%.9f,%lld,%.12f,%.9f,%lld,%.9f,%.3f", t,
            orr_sat_text(x->sat, sat), s->name, x->carrier_hz, x->flags, x->az_rad * ORR_DEG_PER_RAD,
            x->el_rad * ORR_DEG_PER_RAD, x->code_m, x->code_rate_mps, (long long)x->carrier_cycles,
            x->carrier_fraction, x->carrier_rate_hz, (long long)x->transmit_ns, x->transmit_fraction_ns,
            x->power_dbw);
    fprintf(f, ",%u,%.9f,%.9f,%.3f", x->echo, m->code_m, m->phase_cycles, m->power_db);
    for (int k = 0; k < ORR_N_TERMS; k++) fprintf(f, ",%.9f", x->term_m[k]);
    fputc('\n', f);
}

static orr_status rows(FILE *f, const orr_channels *c, size_t antenna, const orr_observe_plan *p,
                       orr_channel_work *work, orr_channel *list, orr_observe_count *count, orr_diag *diag)
{
    size_t n_signals, n;
    const orr_signal *signal = orr_signals(&n_signals);
    head(f);
    for (orr_time t = p->from; t <= p->to; t = orr_time_add(t, p->step_ns)) {
        char text[ORR_TIME_TEXT];
        if (p->cancel != NULL && *p->cancel) return orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        if (orr_channels_at(c, antenna, work, t, UINT64_MAX, list, &n) != ORR_ANSWER_OK)
            return orr_diag_set(diag, ORR_E_RANGE, "the channels do not reach to %s", orr_time_text(t, text));
        orr_time_text(t, text);
        for (size_t k = 0; k < n; k++) {
            orr_composite multipath = {.code_m = 0};
            if (list[k].echo == 0) (void)orr_composite_of(c, list, n, k, &multipath);
            row(f, text, &list[k], &multipath, &signal[list[k].signal]);
        }
        count->epochs++;
        count->observations += n;
    }
    return ORR_OK;
}

orr_status orr_observe_truth(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_observe_count *count, orr_diag *diag)
{
    orr_outfile out;
    *count = (orr_observe_count){0};
    orr_channel *list = calloc(orr_channels_max(c), sizeof *list);
    if (list == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_channel_work *work = NULL;
    orr_status s = orr_channel_work_open(c, &work, diag);
    if (s == ORR_OK) s = orr_outfile_open(path, &out, diag);
    if (s == ORR_OK) {
        s = rows(out.stream, c, antenna, plan, work, list, count, diag);
        s = orr_outfile_end(&out, s, diag);
    }
    orr_channel_work_close(work);
    free(list);
    return s;
}

orr_status orr_observe_track(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    fputs("t_gps,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,lat_deg,lon_deg,height_m\n", out.stream);
    for (orr_time t = plan->from; s == ORR_OK && t <= plan->to; t = orr_time_add(t, plan->step_ns)) {
        orr_antenna_state a;
        char text[ORR_TIME_TEXT];
        if (orr_antenna_at(orr_channels_antenna(c, antenna), t, &a) != ORR_ANSWER_OK) {
            s = orr_diag_set(diag, ORR_E_RANGE, "the trajectory does not reach to %s",
                             orr_time_text(t, text));
            break;
        }
        const orr_geodetic place = orr_earth_from_ecef(a.r_m);
        fprintf(out.stream, "%s,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.10f,%.10f,%.6f\n", orr_time_text(t, text),
                a.r_m.x, a.r_m.y, a.r_m.z, a.v_mps.x, a.v_mps.y, a.v_mps.z, place.lat_rad * ORR_DEG_PER_RAD,
                place.lon_rad * ORR_DEG_PER_RAD, place.height_m);
    }
    return orr_outfile_end(&out, s, diag);
}
