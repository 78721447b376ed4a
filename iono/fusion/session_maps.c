// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/fusion/session_maps.h"

#include <math.h>

#include "core/constants.h"
#include "iono/field/tec_files.h"

// Adds the correction to a map's values, where there are any.
static void correct(const orr_session *s, orr_ionex *x, size_t epoch)
{
    for (size_t i = 0; i < x->n_lats; i++)
        for (size_t j = 0; j < x->n_lons; j++) {
            const double b = x->lat_deg[i] * ORR_RAD_PER_DEG, l = x->lon_deg[j] * ORR_RAD_PER_DEG;
            const orr_vec3 unit = {cos(b) * cos(l), cos(b) * sin(l), sin(b)};
            double *tec = &x->tec_tecu[orr_ionex_index(x, epoch, 0, i, j)];
            *tec += orr_correction_at(&s->correction, x->epoch[epoch], unit, *tec, 1);
            if (*tec < 0) *tec = 0;
        }
}

orr_status orr_session_maps(const orr_session *s, double step_s, orr_ionex *out, orr_diag *diag)
{
    orr_time from, to;
    *out = (orr_ionex){0};
    if (!(step_s >= 1)) return orr_diag_set(diag, ORR_E_ARG, "maps are at least a second apart");
    const int64_t step_ns = llround(step_s) * ORR_NS_PER_S;
    orr_tec_field_span(s->field, &from, &to);
    const orr_time last = s->to < to ? s->to : to;
    // From the multiple of the step before the session, or after the field's begin.
    orr_time first = s->from - orr_floor_mod(s->from, step_ns);
    if (first < from) first = from + orr_floor_mod(-from, step_ns);
    if (first > last)
        return orr_diag_set(diag, ORR_E_RANGE, "no map lies within the session's span: a shorter step");
    const size_t n = (size_t)((last - first) / step_ns) + 1;
    const orr_status status = orr_tec_field_to_ionex(s->field, first, step_s, n, out, diag);
    for (size_t k = 0; status == ORR_OK && k < n; k++) correct(s, out, k);
    return status;
}
