// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sense/temperature.h"

#include <math.h>

orr_status orr_temperature_check(const orr_temperature *p, double duration_s, orr_diag *diag)
{
    if (p->n == 0) return ORR_OK;
    if (!(p->lag_s >= 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "a thermal lag of %g s; it cannot be negative", p->lag_s);
    for (size_t k = 0; k < p->n; k++) {
        if (!isfinite(p->t_s[k]) || !isfinite(p->celsius[k]))
            return orr_diag_set(diag, ORR_E_ARG, "point %zu of the temperature profile is no number", k + 1);
        if (k > 0 && !(p->t_s[k] > p->t_s[k - 1]))
            return orr_diag_set(diag, ORR_E_ARG,
                                "times of the temperature profile have to ascend: %g s comes after %g s",
                                p->t_s[k], p->t_s[k - 1]);
    }
    if (p->t_s[0] > 1e-6 || p->t_s[p->n - 1] < duration_s - 1e-6)
        return orr_diag_set(
            diag, ORR_E_RANGE,
            "the temperature profile covers %g to %g s after the begin, and the run lasts %g s: give it "
            "points up to both ends",
            p->t_s[0], p->t_s[p->n - 1], duration_s);
    return ORR_OK;
}

static double outside(const orr_temperature *p, size_t piece, double t_s, double *slope)
{
    if (p->n == 1) {
        *slope = 0.0;
        return p->celsius[0];
    }
    *slope = (p->celsius[piece + 1] - p->celsius[piece]) / (p->t_s[piece + 1] - p->t_s[piece]);
    return p->celsius[piece] + *slope * (t_s - p->t_s[piece]);
}

orr_thermal_state orr_thermal_begin(const orr_temperature *p)
{
    orr_thermal_state s = {.profile = p, .celsius = p->reference_c};
    double slope;
    while (s.piece + 2 < p->n && p->t_s[s.piece + 1] <= 0.0) s.piece++;
    if (p->n > 0) s.celsius = outside(p, s.piece, 0.0, &slope);
    return s;
}

// T follows a ramp a + b t as a + b (t - lag), and what it lacks of that dies away.
static void within_piece(orr_thermal_state *s, double dt_s)
{
    const orr_temperature *p = s->profile;
    double slope;
    const double now = outside(p, s->piece, s->t_s, &slope), next = now + slope * dt_s;
    s->t_s += dt_s;
    s->celsius = p->lag_s > 0.0
                     ? next - slope * p->lag_s + (s->celsius - now + slope * p->lag_s) * exp(-dt_s / p->lag_s)
                     : next;
}

void orr_thermal_advance(orr_thermal_state *s, double dt_s)
{
    const orr_temperature *p = s->profile;
    if (p->n == 0) return;
    const double before = s->celsius, end = s->t_s + dt_s;
    while (s->piece + 2 < p->n && p->t_s[s->piece + 1] < end) {
        if (p->t_s[s->piece + 1] > s->t_s) within_piece(s, p->t_s[s->piece + 1] - s->t_s);
        s->piece++;
    }
    within_piece(s, end - s->t_s);
    s->rate_cps = (s->celsius - before) / dt_s;
}
