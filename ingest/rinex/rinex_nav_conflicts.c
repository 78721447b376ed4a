// SPDX-License-Identifier: GPL-3.0-or-later
// Records of navigation files that say the same, and those of one issue that do not.
#include <math.h>

#include "ingest/rinex/rinex_nav_private.h"

// The same number, written by two programs with twelve digits.
static bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b)) || fabs(a - b) <= 1e-11 * fmax(fabs(a), fabs(b));
}

static bool same_vector(orr_vec3 a, orr_vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

bool orr_nav_same_orbit(const orr_nav_eph *a, const orr_nav_eph *b)
{
    if (!same(a->af0_s, b->af0_s) || !same(a->af1_sps, b->af1_sps) || !same(a->af2_sps2, b->af2_sps2))
        return false;
    if (a->kind == ORR_NAV_GLONASS)
        return same_vector(a->glonass.pos_m, b->glonass.pos_m) &&
               same_vector(a->glonass.vel_mps, b->glonass.vel_mps) &&
               same_vector(a->glonass.acc_mps2, b->glonass.acc_mps2);
    if (a->kind == ORR_NAV_GEO)
        return same_vector(a->geo.pos_m, b->geo.pos_m) && same_vector(a->geo.vel_mps, b->geo.vel_mps) &&
               same_vector(a->geo.acc_mps2, b->geo.acc_mps2);
    const orr_nav_kepler *p = &a->kepler, *q = &b->kepler;
    const double x[] = {
        p->sqrt_a_sqrtm,  p->e,          p->m0_rad,          p->i0_rad,    p->omega0_rad,        p->omega_rad,
        p->delta_n_radps, p->idot_radps, p->omega_dot_radps, p->cuc_rad,   p->cus_rad,           p->crc_m,
        p->crs_m,         p->cic_rad,    p->cis_rad,         p->a_dot_mps, p->delta_n_dot_radps2};
    const double y[] = {
        q->sqrt_a_sqrtm,  q->e,          q->m0_rad,          q->i0_rad,    q->omega0_rad,        q->omega_rad,
        q->delta_n_radps, q->idot_radps, q->omega_dot_radps, q->cuc_rad,   q->cus_rad,           q->crc_m,
        q->crs_m,         q->cic_rad,    q->cis_rad,         q->a_dot_mps, q->delta_n_dot_radps2};
    for (size_t i = 0; i < sizeof x / sizeof *x; i++)
        if (!same(x[i], y[i])) return false;
    return true;
}

bool orr_nav_same_rest(const orr_nav_eph *a, const orr_nav_eph *b)
{
    const double *x = (const double *)&a->delay, *y = (const double *)&b->delay;
    for (size_t i = 0; i < sizeof a->delay / sizeof *x; i++)
        if (!same(x[i], y[i])) return false;
    return a->health == b->health && a->iode == b->iode && a->iodc == b->iodc &&
           same(a->accuracy_m, b->accuracy_m) &&
           (a->kind != ORR_NAV_GLONASS || (a->glonass.freq_channel == b->glonass.freq_channel &&
                                           same(a->glonass.delta_tau_s, b->glonass.delta_tau_s)));
}

static bool same_issue(const orr_nav_eph *a, const orr_nav_eph *b)
{
    return a->sat == b->sat && a->message == b->message && a->toe == b->toe && a->toc == b->toc &&
           a->iode == b->iode; // -1 in messages that have no issue of data
}

void orr_nav_tell_conflicts(const orr_nav_eph *eph, size_t n, const char *name, orr_warnings *w)
{
    size_t conflicts = 0;
    const orr_nav_eph *first = NULL, *other = NULL;
    for (size_t i = 0; i < n; i++)
        for (size_t k = i + 1; k < n && eph[k].sat == eph[i].sat && eph[k].toe == eph[i].toe; k++) {
            if (!same_issue(&eph[i], &eph[k]) || orr_nav_same_orbit(&eph[i], &eph[k])) continue;
            if (conflicts++ == 0) first = &eph[i], other = &eph[k];
            break; // each record once
        }
    if (conflicts == 0) return;
    char sat[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
    orr_warnings_add(
        w, name, name != NULL ? other->line : 0, 0,
        "%zu records contradict another of their issue, first %s of %s (lines %lld and %lld): the one "
        "transmitted last is used",
        conflicts, orr_sat_text(first->sat, sat), orr_time_text(first->toe, when), (long long)first->line,
        (long long)other->line);
}
