// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/sisre.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/spacecraft/signal_delay.h"

#define OUTLIER_M 50.0
#define LEAST_CLOCKS 4 // of a system at an epoch: the median of fewer is mostly what is to be judged

// Weights of radial (with clock) and of along and cross-track errors in a range seen from the ground, of
// medium orbits, and the carriers whose phase centre the message's orbit is that of.
typedef struct system_facts {
    double w_radial, w_across;
    const char *code1, *code2;
    double f1_hz, f2_hz;
} system_facts;

static const system_facts *facts_of(char system)
{
    static const system_facts gps = {0.98, 1 / 7.0, "G01", "G02", 1575.42e6, 1227.60e6};
    static const system_facts glonass = {0.98, 1 / 6.7, "R01", "R02", 1602.0e6, 1246.0e6};
    static const system_facts galileo = {0.98, 1 / 7.8, "E01", "E05", 1575.42e6, 1176.45e6};
    static const system_facts beidou = {0.98, 1 / 7.3, "C06", NULL, 1268.52e6, 0};
    static const system_facts qzss = {0.99, 1 / 11.2, "J01", "J02", 1575.42e6, 1227.60e6};
    static const system_facts navic = {0.99, 1 / 11.2, "I05", NULL, 1176.45e6, 0};
    switch (system) {
    case 'G':
        return &gps;
    case 'R':
        return &glonass;
    case 'E':
        return &galileo;
    case 'C':
        return &beidou;
    case 'J':
        return &qzss;
    case 'I':
        return &navic;
    default:
        return NULL;
    }
}

// From 36000 km the Earth is smaller.
static void weights(const system_facts *f, orr_orbit_class orbit, double *radial, double *across)
{
    *radial = orbit == ORR_ORBIT_MEO ? f->w_radial : 0.99;
    *across = orbit == ORR_ORBIT_MEO ? f->w_across : 1 / 11.2;
}

// Broadcast clocks belong to the pair of signals of their message, precise ones to the pair that the analysis
// centres use. Where the message does not tell the way from one to the other, as GLONASS before RINEX 3.05
// and where delta tau was not received, the difference stays in the clock errors.
static double to_precise_pair_s(const orr_nav_eph *eph)
{
    double shift;
    return orr_signal_broadcast_to_product(eph, &shift) == ORR_OK ? shift : 0;
}

// One satellite at one epoch; the clock is still without its system's offset. false if there is no allowed
// record.
static bool sample_at(const orr_nav *nav, const orr_sp3_record *truth, orr_sat sat, orr_time t, orr_vec3 sun,
                      const orr_sisre_options *o, const system_facts *f, orr_sisre_sample *out)
{
    const orr_nav_eph *eph = orr_broadcast_select(nav, sat, t, &o->choice);
    orr_broadcast_state s;
    if (eph == NULL || orr_broadcast_eval(eph, t, &s) != ORR_OK) return false;
    if (orr_sat_system(sat) == 'R') s.pos_m = orr_broadcast_pz90_to_itrf(s.pos_m, t);
    const orr_vec3 v = orr_velocity_inertial(s.pos_m, s.vel_mps);
    const orr_vec3 precise = {truth->pos_m[0], truth->pos_m[1], truth->pos_m[2]};

    const orr_antex_antenna *antenna = o->antex != NULL ? orr_antex_find_sat(o->antex, sat, t) : NULL;
    orr_attitude attitude;
    orr_vec3 offset = {0, 0, 0};
    bool known =
        antenna != NULL && orr_attitude_nominal(precise, v, sun, &attitude) == ORR_OK &&
        orr_antenna_offset(antenna, &attitude, f->code1, f->f1_hz, f->code2, f->f2_hz, &offset) == ORR_OK;
    const orr_vec3 e = orr_vec3_sub(orr_vec3_sub(s.pos_m, offset), precise);
    const orr_vec3 radial = orr_vec3_unit(precise), cross = orr_vec3_unit(orr_vec3_cross(precise, v));
    *out = (orr_sisre_sample){.sat = sat,
                              .t = t,
                              .radial_m = orr_vec3_dot(e, radial),
                              .along_m = orr_vec3_dot(e, orr_vec3_cross(cross, radial)),
                              .cross_m = orr_vec3_dot(e, cross),
                              .clock_m = (double)NAN,
                              .sisre_m = (double)NAN,
                              .age_s = orr_time_diff_s(t, eph->toe),
                              .orbit = orr_orbit_class_of(s.pos_m, v),
                              .antenna = known};
    if (isfinite(truth->clock_s)) {
        double clock = s.clock_s + to_precise_pair_s(eph);
        if (orr_sat_system(sat) == 'R') // its parameters hold the periodic relativity, IGS clocks do not
            clock -= orr_periodic_relativity_s(s.pos_m, v);
        out->clock_m = ORR_LIGHT_MPS * (clock - truth->clock_s);
    }
    return true;
}

// Time scales of two clock products differ by what is common to a system at an epoch: its median goes.
static void remove_system_offset(orr_sisre_sample *s, size_t n, double *room)
{
    for (int k = 0; k < ORR_N_SYSTEMS; k++) {
        size_t m = 0;
        for (size_t i = 0; i < n; i++)
            if (orr_sat_system_index(s[i].sat) == k && isfinite(s[i].clock_m)) room[m++] = s[i].clock_m;
        if (m < LEAST_CLOCKS) {
            for (size_t i = 0; i < n && m > 0; i++)
                if (orr_sat_system_index(s[i].sat) == k) s[i].clock_m = (double)NAN;
            continue;
        }
        const double median = orr_median(room, m);
        for (size_t i = 0; i < n; i++) {
            if (orr_sat_system_index(s[i].sat) != k) continue;
            const system_facts *f = facts_of(ORR_SYSTEMS[k]);
            double w_radial, w_across;
            weights(f, s[i].orbit, &w_radial, &w_across);
            s[i].clock_m -= median;
            const double range = w_radial * s[i].radial_m - s[i].clock_m;
            const double across2 = s[i].along_m * s[i].along_m + s[i].cross_m * s[i].cross_m;
            s[i].sisre_m = sqrt(range * range + w_across * w_across * across2);
        }
    }
}

static double size_3d(const orr_sisre_sample *s)
{
    return sqrt(s->radial_m * s->radial_m + s->along_m * s->along_m + s->cross_m * s->cross_m);
}

static void sum_up(const orr_sisre_sample *s, size_t n, double outlier_m, double *room, orr_sisre_sum *sum)
{
    double per_sat[256] = {0};
    size_t count[256] = {0}, m = 0;
    bool unknown[256] = {0};
    double r1 = 0, r2 = 0, a2 = 0, c2 = 0, t2 = 0, u2 = 0;
    for (size_t i = 0; i < n; i++) {
        if (orr_sat_system(s[i].sat) != sum->system) continue;
        if (sum->orbit != ORR_ORBIT_CLASSES && s[i].orbit != sum->orbit) continue;
        double d = size_3d(&s[i]);
        if (d > outlier_m) {
            sum->n_outliers++;
            continue;
        }
        sum->n++;
        r1 += s[i].radial_m;
        r2 += s[i].radial_m * s[i].radial_m;
        a2 += s[i].along_m * s[i].along_m;
        c2 += s[i].cross_m * s[i].cross_m;
        per_sat[orr_sat_number(s[i].sat)] += d * d;
        count[orr_sat_number(s[i].sat)]++;
        if (!s[i].antenna) unknown[orr_sat_number(s[i].sat)] = true;
        if (!isfinite(s[i].clock_m)) continue;
        t2 += s[i].clock_m * s[i].clock_m;
        u2 += s[i].sisre_m * s[i].sisre_m;
        room[m++] = s[i].sisre_m;
    }
    if (sum->n == 0) return;
    double N = (double)sum->n;
    sum->radial_m = sqrt(r2 / N), sum->along_m = sqrt(a2 / N), sum->cross_m = sqrt(c2 / N);
    sum->orbit_3d_m = sqrt((r2 + a2 + c2) / N);
    sum->radial_mean_m = r1 / N;
    sum->n_clock = m;
    sum->clock_m = sum->sisre_m = sum->sisre_95_m = (double)NAN;
    if (m > 0) {
        sum->clock_m = sqrt(t2 / (double)m), sum->sisre_m = sqrt(u2 / (double)m);
        sum->sisre_95_m = orr_order_statistic(room, m, (size_t)(0.95 * (double)(m - 1)));
    }
    for (int k = 0; k < 256; k++) {
        if (count[k] == 0) continue;
        sum->n_sats++;
        if (!unknown[k]) sum->n_antennas++;
        double rms = sqrt(per_sat[k] / (double)count[k]);
        if (rms > sum->worst_m) {
            sum->worst_m = rms;
            sum->worst = orr_sat_make(sum->system, k);
        }
    }
}

// The usual reason is files of different days.
static orr_status nothing_in_common(const orr_nav *nav, const orr_sp3 *truth, orr_diag *diag)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT], first[ORR_TIME_TEXT], last[ORR_TIME_TEXT];
    if (nav->n_eph == 0 || truth->n_epochs == 0)
        return orr_diag_set(diag, ORR_E_NODATA, "no %s to compare",
                            nav->n_eph == 0 ? "broadcast record" : "epoch");
    orr_time a = nav->eph[0].toe, b = a;
    for (size_t i = 1; i < nav->n_eph; i++) {
        if (nav->eph[i].toe < a) a = nav->eph[i].toe;
        if (nav->eph[i].toe > b) b = nav->eph[i].toe;
    }
    return orr_diag_set(
        diag, ORR_E_NODATA,
        "no satellite has both a precise position and a usable broadcast record at one epoch: the "
        "positions are of %s to %s, the records of %s to %s",
        orr_time_text(truth->epoch[0], from), orr_time_text(truth->epoch[truth->n_epochs - 1], to),
        orr_time_text(a, first), orr_time_text(b, last));
}

orr_status orr_sisre_run(const orr_nav *nav, const orr_sp3 *truth, const orr_sisre_options *o,
                         orr_sisre_sample **samples, size_t *n, orr_sisre_sum sums[ORR_N_SYSTEMS],
                         orr_diag *diag)
{
    *samples = NULL;
    *n = 0;
    const size_t room_n = truth->n_epochs * truth->n_sats;
    orr_sisre_sample *s = malloc((room_n + 1) * sizeof *s);
    double *room = malloc((room_n + 1) * sizeof *room);
    if (s == NULL || room == NULL) {
        free(s);
        free(room);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu comparisons", room_n);
    }
    for (int k = 0; k < ORR_N_SYSTEMS; k++)
        sums[k] = (orr_sisre_sum){.system = ORR_SYSTEMS[k], .orbit = ORR_ORBIT_CLASSES};
    for (size_t e = 0; e < truth->n_epochs; e++) {
        // By the secular pole: 3e-5 rad of attitude are 0.1 mm of an antenna.
        const orr_vec3 sun = orr_attitude_sun(truth->epoch[e], NULL);
        size_t first = *n;
        for (size_t i = 0; i < truth->n_sats; i++) {
            const orr_sp3_record *r = &truth->record[e * truth->n_sats + i];
            const system_facts *f = facts_of(orr_sat_system(truth->sat[i]));
            if (f == NULL || !isfinite(r->pos_m[0])) continue;
            if (sample_at(nav, r, truth->sat[i], truth->epoch[e], sun, o, f, &s[*n])) ++*n;
        }
        remove_system_offset(s + first, *n - first, room);
    }
    for (int k = 0; k < ORR_N_SYSTEMS; k++)
        sum_up(s, *n, o->outlier_m > 0 ? o->outlier_m : OUTLIER_M, room, &sums[k]);
    free(room);
    if (*n == 0) {
        free(s);
        return nothing_in_common(nav, truth, diag);
    }
    *samples = s;
    return ORR_OK;
}

orr_status orr_sisre_sum_orbit(const orr_sisre_sample *samples, size_t n, char system, orr_orbit_class orbit,
                               double outlier_m, orr_sisre_sum *out)
{
    double *room = malloc((n + 1) * sizeof *room);
    if (room == NULL) return ORR_E_MEMORY;
    *out = (orr_sisre_sum){.system = system, .orbit = orbit};
    sum_up(samples, n, outlier_m > 0 ? outlier_m : OUTLIER_M, room, out);
    free(room);
    return ORR_OK;
}
