// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/epoch.h"

#include <math.h>

int64_t orr_epoch_label_ns(orr_time t, orr_scale scale)
{
    orr_civil c;
    orr_time_to_civil(t, scale, NULL, &c);
    int64_t s = c.hour * INT64_C(3600) + c.minute * INT64_C(60) + c.second;
    orr_time day = orr_time_from_mjd(orr_mjd_from_date(c.year, c.month, c.day), 0.0, ORR_SCALE_GPS, NULL);
    return orr_time_add(day, s * ORR_NS_PER_S + c.ns);
}

bool orr_epoch_wanted(orr_time t, orr_scale scale, int64_t midnight, const orr_smoother_options *o)
{
    const int64_t step_ns = (int64_t)llround(o->node_step_s * 1e9);
    if (step_ns > 0 && orr_time_sub_ns(orr_epoch_label_ns(t, scale), midnight) % step_ns != 0) return false;
    for (size_t i = 0; i < o->n_exclude; i++)
        if (orr_interval_holds(o->exclude[i], t)) return false;
    return true;
}
