// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/scenario/replay_report.h"

#include <math.h>

static void print_row(FILE *f, const char *sat, const char *signal, const orr_replay_rms *x, double delay_m)
{
    fprintf(f, "%-4s %-7s %7zu %8.3f %8.3f %9.3f %9zu %8.4f %8.4f %8.4f %5zu %6zu\n", sat, signal, x->n_code,
            x->code_m, x->code_max_m, delay_m, x->n_carrier, x->carrier_m, x->carrier_max_m,
            x->carrier_cycles, x->n_arcs, x->n_slips);
}

static void print_estimate(FILE *f, const orr_replay *r, const orr_replay_report *x)
{
    const orr_vec3 p = x->site_m, d = x->shift_enu_m, s = x->sigma_enu_m;
    fprintf(f, "replay of %s: %zu epochs, %g s apart, %zu satellites\n", r->marker, r->n_epochs,
            r->interval_s, r->n_sats);
    fprintf(f,
            "antenna reference point %.4f %.4f %.4f m: %.4f E %.4f N %.4f U m from the %s's (sigma %.4f %.4f "
            "%.4f)\n",
            p.x, p.y, p.z, d.x, d.y, d.z, x->position_from, s.x, s.y, s.z);
    fprintf(
        f,
        "zenith wet delay %.4f m (%.4f to %.4f); receiver clock %.3f to %.3f us, %zu steps of milliseconds\n",
        x->zenith_wet_m, x->zenith_least_m, x->zenith_most_m, 1e6 * x->clock_least_s, 1e6 * x->clock_most_s,
        x->n_clock_steps);
    fprintf(f, "satellite clocks: nodes %g s apart, in between %.4f m RMS by the station's phases\n",
            x->clock_step_s, x->clock_between_m);
    fprintf(f, "fitted: %zu ionosphere-free phases of %zu arcs to %.4f m, codes to %.3f m; %zu outliers\n\n",
            x->n_used, x->n_arcs, x->phase_rms_m, x->code_rms_m, x->n_rejected);
}

void orr_replay_report_text(FILE *f, const orr_replay *r, const orr_replay_report *report)
{
    print_estimate(f, r, report);
    fputs("residuals    codes    RMS m    max m   delay m  carriers    RMS m    max m RMS cyc  arcs  slips\n",
          f);
    for (size_t k = 0; k < r->n_tracks; k++) {
        char sat[ORR_SAT_TEXT];
        const orr_replay_track *x = &r->track[k];
        const orr_replay_rms rms = orr_replay_rms_of(r, x);
        print_row(f, orr_sat_text(r->sat[x->sat].sat, sat), orr_signals(&(size_t){0})[x->signal].name, &rms,
                  x->delay_m);
    }
    const orr_replay_rms all = orr_replay_rms_all(r);
    print_row(f, "all", "", &all, 0);
}

void orr_replay_report_csv(FILE *f, const orr_replay *r)
{
    fputs("sat,signal,rinex,codes,code_rms_m,code_max_m,code_delay_m,carriers,carrier_rms_m,carrier_max_m,"
          "carrier_rms_"
          "cycles,arcs,slips\n",
          f);
    for (size_t k = 0; k < r->n_tracks; k++) {
        char sat[ORR_SAT_TEXT];
        const orr_replay_track *x = &r->track[k];
        const orr_replay_rms a = orr_replay_rms_of(r, x);
        fprintf(f, "%s,%s,%s,%zu,%.6f,%.6f,%.6f,%zu,%.6f,%.6f,%.6f,%zu,%zu\n",
                orr_sat_text(r->sat[x->sat].sat, sat), orr_signals(&(size_t){0})[x->signal].name,
                r->code[x->signal], a.n_code, a.code_m, a.code_max_m, x->delay_m, a.n_carrier, a.carrier_m,
                a.carrier_max_m, a.carrier_cycles, a.n_arcs, a.n_slips);
    }
}

// A number, or null where there is none.
static json_t *number(double x) { return isfinite(x) ? json_real(x) : json_null(); }

static json_t *vector(orr_vec3 v) { return json_pack("[o,o,o]", number(v.x), number(v.y), number(v.z)); }

json_t *orr_replay_report_json(const orr_replay *r, const orr_replay_report *x)
{
    json_t *rows = json_array();
    for (size_t k = 0; k < r->n_tracks; k++) {
        char sat[ORR_SAT_TEXT];
        const orr_replay_track *t = &r->track[k];
        const orr_replay_rms a = orr_replay_rms_of(r, t);
        json_array_append_new(
            rows, json_pack("{s:s,s:s,s:s,s:I,s:o,s:o,s:I,s:o,s:o,s:I,s:I}", "sat",
                            orr_sat_text(r->sat[t->sat].sat, sat), "signal",
                            orr_signals(&(size_t){0})[t->signal].name, "rinex", r->code[t->signal], "codes",
                            (json_int_t)a.n_code, "code_rms_m", number(a.code_m), "code_delay_m",
                            number(t->delay_m), "carriers", (json_int_t)a.n_carrier, "carrier_rms_m",
                            number(a.carrier_m), "carrier_rms_cycles", number(a.carrier_cycles), "arcs",
                            (json_int_t)a.n_arcs, "slips", (json_int_t)a.n_slips));
    }
    const orr_replay_rms all = orr_replay_rms_all(r);
    return json_pack("{s:s,s:I,s:f,s:s,s:o,s:o,s:o,s:o,s:o,s:I,s:o,s:o,s:o,s:o,s:o}", "marker", r->marker,
                     "epochs", (json_int_t)r->n_epochs, "interval_s", r->interval_s, "position_from",
                     x->position_from, "site_m", vector(x->site_m), "shift_enu_m", vector(x->shift_enu_m),
                     "sigma_enu_m", vector(x->sigma_enu_m), "zenith_wet_m", number(x->zenith_wet_m),
                     "code_rms_m", number(all.code_m), "outliers", (json_int_t)x->n_rejected, "carrier_rms_m",
                     number(all.carrier_m), "phase_fit_rms_m", number(x->phase_rms_m), "clock_step_s",
                     number(x->clock_step_s), "clock_between_m", number(x->clock_between_m), "tracks", rows);
}
