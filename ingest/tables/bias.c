// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/tables/bias.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/input/sniff.h"
#include "ingest/input/text_records.h"
#include "ingest/tables/bias_private.h"

void orr_bias_free(orr_bias_set *x)
{
    if (x == NULL) return;
    free(x->bias);
    *x = (orr_bias_set){0};
}

orr_status orr_bias_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                          orr_bias_set *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_bias_set){.scale = ORR_SCALE_GPS, .from = ORR_TIME_NONE, .until = ORR_TIME_NONE};
    bias_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor_init(&r.c, name, text, n);
    orr_view line = {0};
    bool any = false;
    while (!any && orr_cursor_next(&r.c, &line)) any = !orr_view_is_blank(line);
    orr_status s = orr_cursor_status(&r.c, diag);
    if (s == ORR_OK) {
        if (!any)
            s = orr_cursor_error(&r.c, diag, ORR_E_KIND, 0, "the file is empty");
        else
            s = orr_view_starts(line, "%=BIA") ? bias_read_sinex(&r, line) : bias_read_dcb(&r, line);
    }
    if (s == ORR_OK && out->n == 0) {
        if (r.left_out > 0) {
            if (diag != NULL) *diag = r.first_reason;
            s = ORR_E_FORMAT;
        } else {
            s = orr_cursor_error(&r.c, diag, ORR_E_FORMAT, 0, "the file has no bias");
        }
    }
    if (s != ORR_OK) orr_bias_free(out);
    return s;
}

orr_status orr_bias_read(const char *path, const orr_read_limits *limits, orr_bias_set *out,
                         orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_bias_set){0};
    orr_bytes b;
    orr_status s = orr_records_load(path, limits,
                                    ORR_KIND_BIT(ORR_KIND_BIAS_SINEX) | ORR_KIND_BIT(ORR_KIND_DCB), &b, diag);
    if (s != ORR_OK) return s;
    s = orr_bias_parse(path, b.text, b.n, limits, out, warnings, diag);
    orr_bytes_free(&b);
    return s;
}

static bool valid_at(const orr_bias *b, orr_time t)
{
    return (b->from == ORR_TIME_NONE || t >= b->from) && (b->until == ORR_TIME_NONE || t < b->until);
}

static double value_at(const orr_bias *b, orr_time t)
{
    if (isnan(b->slope_sps) || b->from == ORR_TIME_NONE) return b->value_s;
    return b->value_s + b->slope_sps * orr_time_diff_s(t, b->from);
}

orr_status orr_bias_osb(const orr_bias_set *x, orr_sat sat, const char *obs, orr_time t, double *bias_s)
{
    for (size_t i = 0; i < x->n; i++) {
        const orr_bias *b = &x->bias[i];
        if (b->kind != ORR_BIAS_OSB || b->sat != sat || b->station[0] != '\0' || b->in_cycles ||
            !valid_at(b, t) || strcmp(b->obs1, obs) != 0)
            continue;
        *bias_s = value_at(b, t);
        return ORR_OK;
    }
    return ORR_E_NODATA;
}

// A DSB line of exactly this pair, in either direction, else two OSB lines.
static orr_status direct(const orr_bias_set *x, orr_sat sat, const char *obs1, const char *obs2, orr_time t,
                         double *out)
{
    if (strcmp(obs1, obs2) == 0) {
        *out = 0;
        return ORR_OK;
    }
    for (size_t i = 0; i < x->n; i++) {
        const orr_bias *b = &x->bias[i];
        if (b->kind != ORR_BIAS_DSB || b->sat != sat || b->station[0] != '\0' || b->in_cycles ||
            !valid_at(b, t))
            continue;
        bool same = strcmp(b->obs1, obs1) == 0 && strcmp(b->obs2, obs2) == 0;
        bool turned = strcmp(b->obs1, obs2) == 0 && strcmp(b->obs2, obs1) == 0;
        if (!same && !turned) continue;
        *out = turned ? -value_at(b, t) : value_at(b, t);
        return ORR_OK;
    }
    double a, b;
    if (orr_bias_osb(x, sat, obs1, t, &a) != ORR_OK || orr_bias_osb(x, sat, obs2, t, &b) != ORR_OK)
        return ORR_E_NODATA;
    *out = a - b;
    return ORR_OK;
}

orr_status orr_bias_dsb(const orr_bias_set *x, orr_sat sat, const char *obs1, const char *obs2, orr_time t,
                        double *bias_s)
{
    if (sat == ORR_SAT_NONE) return ORR_E_NODATA;
    if (direct(x, sat, obs1, obs2, t, bias_s) == ORR_OK) return ORR_OK;
    for (size_t i = 0; i < x->n; i++) {
        const orr_bias *b = &x->bias[i];
        if (b->kind != ORR_BIAS_DSB || b->sat != sat || b->station[0] != '\0' || b->in_cycles ||
            !valid_at(b, t))
            continue;
        const char *middle = strcmp(b->obs1, obs1) == 0   ? b->obs2
                             : strcmp(b->obs2, obs1) == 0 ? b->obs1
                                                          : NULL;
        double first, second;
        if (middle == NULL || direct(x, sat, obs1, middle, t, &first) != ORR_OK ||
            direct(x, sat, middle, obs2, t, &second) != ORR_OK)
            continue;
        *bias_s = first + second;
        return ORR_OK;
    }
    return ORR_E_NODATA;
}
