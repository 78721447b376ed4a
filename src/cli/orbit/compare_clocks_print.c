// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/compare_clocks_print.h"

#include <math.h>
#include <stdio.h>

void compare_clocks_print(const orr_clock_comparison *x)
{
    if (x->n_systems == 0) return;
    printf("\nClocks, less the median over the system at each epoch\n\n");
    printf("%-8s %5s %8s %9s %9s %9s %9s %12s\n", "system", "sats", "samples", "RMS ns", "95 % ns", "max ns",
           "sigma ns", "error/sigma");
    for (size_t i = 0; i < x->n_systems; i++) {
        const orr_clock_stats *s = &x->system[i];
        printf("%-8s %5zu %8zu %9.4f %9.4f %9.4f ", orr_system_name(s->system), s->satellites, s->n,
               1e9 * s->rms_s, 1e9 * s->p95_s, 1e9 * s->max_s);
        if (isfinite(s->ratio))
            printf("%9.4f %12.2f\n", 1e9 * s->sigma_rms_s, s->ratio);
        else
            printf("%9s %12s\n", "-", "-");
    }
    if (x->no_clock + x->few > 0)
        printf("\nleft out: %zu clocks where the product has none, %zu at epochs of fewer than four "
               "satellites\n",
               x->no_clock, x->few);
}

static json_t *json_stats(const orr_clock_stats *s)
{
    json_t *o = json_object();
    if (s->sat != ORR_SAT_NONE)
        json_object_set_new(o, "sat", orr_json_sat(s->sat));
    else
        json_object_set_new(o, "satellites", orr_json_count(s->satellites));
    json_object_set_new(o, "n", orr_json_count(s->n));
    json_object_set_new(o, "rms_ns", orr_json_number(1e9 * s->rms_s));
    json_object_set_new(o, "p95_ns", orr_json_number(1e9 * s->p95_s));
    json_object_set_new(o, "max_ns", orr_json_number(1e9 * s->max_s));
    json_object_set_new(o, "sigma_rms_ns", orr_json_number(1e9 * s->sigma_rms_s));
    json_object_set_new(o, "ratio", orr_json_number(s->ratio));
    return o;
}

json_t *compare_clocks_json(const orr_clock_comparison *x)
{
    json_t *j = json_object(), *systems = json_object(), *sats = json_array(), *left = json_object();
    for (size_t i = 0; i < x->n_systems; i++) {
        const char key[2] = {x->system[i].system, '\0'};
        json_object_set_new(systems, key, json_stats(&x->system[i]));
    }
    for (size_t i = 0; i < x->n_sats; i++) json_array_append_new(sats, json_stats(&x->sat[i]));
    json_object_set_new(left, "inputs", orr_json_count(x->inputs));
    json_object_set_new(left, "no_clock", orr_json_count(x->no_clock));
    json_object_set_new(left, "few", orr_json_count(x->few));
    json_object_set_new(j, "systems", systems);
    json_object_set_new(j, "satellites", sats);
    json_object_set_new(j, "left_out", left);
    return j;
}
