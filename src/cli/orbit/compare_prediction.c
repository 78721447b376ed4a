// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/compare_prediction.h"

#include <math.h>
#include <stdio.h>

static void cell(int width, int digits, double value)
{
    if (isfinite(value))
        printf(" %*.*f", width, digits, value);
    else
        printf(" %*s", width, "-");
}

void compare_prediction_print(const orr_prediction_judgement *j)
{
    char name[ORR_SAT_TEXT];
    if (j->n == 0 && j->n_moved == 0 && j->predicted == 0) return;
    printf("\npredicted, by age since a satellite's last position: median and 95 %% over satellites; clocks "
           "with "
           "their system's median taken away\n%-8s %-8s %5s %5s %9s %9s %11s %6s %9s %9s %11s\n",
           "system", "light", "age h", "sats", "orbit cm", "95 %", "err/sigma", "clocks", "clock ns", "95 %",
           "err/sigma");
    for (size_t i = 0; i < j->n; i++) {
        const orr_prediction_row *r = &j->row[i];
        printf("%-8s %-8s %5.0f %5zu", orr_system_name(r->system), r->eclipses ? "eclipses" : "sunlit",
               r->age_h, r->orbit.satellites);
        cell(9, 1, 1e2 * r->orbit.median);
        cell(9, 1, 1e2 * r->orbit.p95);
        cell(11, 2, r->orbit.ratio);
        if (r->eclipses || r->clock.satellites == 0) { // a clock does not know of shadow
            putchar('\n');
            continue;
        }
        printf(" %6zu", r->clock.satellites);
        cell(9, 2, 1e9 * r->clock.median);
        cell(9, 2, 1e9 * r->clock.p95);
        cell(11, 2, r->clock.ratio);
        putchar('\n');
    }
    if (j->n_moved > 0) {
        printf("left out of it, manoeuvres by the truth's flag or 20 m off (no prediction knows a push):");
        for (size_t i = 0; i < j->n_moved; i++) printf(" %s", orr_sat_text(j->moved[i], name));
        putchar('\n');
    }
    if (j->predicted > 0)
        printf("left out of it: %zu positions of the truth that are predictions themselves\n", j->predicted);
}

static json_t *stats(const orr_prediction_stats *s, double scale, const char *median, const char *p95)
{
    json_t *o = json_object();
    json_object_set_new(o, "satellites", orr_json_count(s->satellites));
    json_object_set_new(o, median, orr_json_number(scale * s->median));
    json_object_set_new(o, p95, orr_json_number(scale * s->p95));
    json_object_set_new(o, "error_over_sigma", orr_json_number(s->ratio));
    return o;
}

json_t *compare_prediction_json(const orr_prediction_judgement *j)
{
    if (j->n == 0 && j->n_moved == 0 && j->predicted == 0) return json_null();
    json_t *all = json_object(), *rows = json_array(), *moved = json_array();
    for (size_t i = 0; i < j->n; i++) {
        const orr_prediction_row *r = &j->row[i];
        const char system[2] = {r->system, '\0'};
        json_t *o = json_object();
        json_object_set_new(o, "system", json_string(system));
        json_object_set_new(o, "eclipses", json_boolean(r->eclipses));
        json_object_set_new(o, "age_h", json_real(r->age_h));
        json_object_set_new(o, "orbit", stats(&r->orbit, 1e3, "median_mm", "p95_mm"));
        json_object_set_new(o, "clock", stats(&r->clock, 1e9, "median_ns", "p95_ns"));
        json_array_append_new(rows, o);
    }
    for (size_t i = 0; i < j->n_moved; i++) json_array_append_new(moved, orr_json_sat(j->moved[i]));
    json_object_set_new(all, "rows", rows);
    json_object_set_new(all, "manoeuvres", moved);
    json_object_set_new(all, "predicted_truth", orr_json_count(j->predicted));
    return all;
}
