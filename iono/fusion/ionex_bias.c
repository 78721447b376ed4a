// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/fusion/ionex_bias.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"

#define DAY_NS ((orr_time)86400 * ORR_NS_PER_S)

// The pair of codes after the colon of a comment that names `who`.
static bool named(const orr_ionex *x, const char *who, char obs1[4], char obs2[4])
{
    const char *head = "Reference observables for ";
    for (size_t i = 0; i < x->n_comments; i++) {
        const char *at = strstr(x->comment[i], head), *colon = strrchr(x->comment[i], ':');
        if (at == NULL || colon == NULL || strncmp(at + strlen(head), who, strlen(who)) != 0) continue;
        return sscanf(colon + 1, " %3[A-Z0-9]-%3[A-Z0-9]", obs1, obs2) == 2;
    }
    return false;
}

static bool codes_of(const orr_ionex *x, const orr_ionex_dcb *d, char obs1[4], char obs2[4])
{
    static const char *const names[] = {"GPS", "GLONASS", "GALILEO", "BEIDOU", "QZSS"};
    static const char letters[] = "GRECJ";
    char who[48];
    if (d->sat == ORR_SAT_NONE)
        snprintf(who, sizeof who, "%s (%c)", d->station, d->system);
    else {
        const char *at = strchr(letters, d->system);
        snprintf(who, sizeof who, "%s", at != NULL && *at != '\0' ? names[at - letters] : "?");
    }
    if (named(x, who, obs1, obs2)) return true;
    if (d->system != 'G' && d->system != 'R') return false;
    strcpy(obs1, d->system == 'G' ? "C1W" : "C1P");
    strcpy(obs2, d->system == 'G' ? "C2W" : "C2P");
    return true;
}

orr_status orr_bias_of_ionex(const orr_ionex *x, orr_bias_set *out, orr_diag *diag)
{
    *out = (orr_bias_set){.format = "IONEX", .scale = ORR_SCALE_GPS};
    if (x->n_dcbs == 0 || x->n_epochs == 0) return ORR_OK;
    out->from = x->epoch[0] - DAY_NS; // constants of the day; a file's maps may begin after the data
    out->until = x->epoch[x->n_epochs - 1] + DAY_NS;
    out->bias = calloc(x->n_dcbs, sizeof *out->bias);
    if (out->bias == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for code biases");
    for (size_t i = 0; i < x->n_dcbs; i++) {
        const orr_ionex_dcb *d = &x->dcb[i];
        orr_bias b = {.kind = ORR_BIAS_DSB,
                      .sat = d->sat,
                      .system = d->system,
                      .from = out->from,
                      .until = out->until,
                      .value_s = d->bias_s,
                      .sdev_s = d->rms_s,
                      .slope_sps = ORR_NAN,
                      .slope_sdev_sps = ORR_NAN};
        if (d->sat == ORR_SAT_NONE) snprintf(b.station, sizeof b.station, "%.16s", d->station);
        if (isfinite(d->bias_s) && codes_of(x, d, b.obs1, b.obs2)) out->bias[out->n++] = b;
    }
    return ORR_OK;
}

// Mean over satellites of what `all` says minus what a line of `more` says, for one system and pair of codes.
static double datum(const orr_bias_set *all, const orr_bias_set *more, const orr_bias *station)
{
    double sum = 0, n = 0, known;
    for (size_t i = 0; i < more->n; i++) {
        const orr_bias *b = &more->bias[i];
        if (b->kind != ORR_BIAS_DSB || b->sat == ORR_SAT_NONE || b->system != station->system) continue;
        orr_time mid = b->from == ORR_TIME_NONE || b->until == ORR_TIME_NONE
                           ? all->from
                           : b->from + (b->until - b->from) / 2;
        if (orr_bias_dsb(all, b->sat, b->obs1, b->obs2, mid, &known) != ORR_OK) continue;
        sum += known - b->value_s;
        n++;
    }
    return n >= 4 ? sum / n : 0;
}

orr_status orr_bias_join(orr_bias_set *all, orr_bias_set *more, orr_diag *diag)
{
    if (more->n == 0) {
        orr_bias_free(more);
        return ORR_OK;
    }
    if (all->n == 0) {
        orr_bias_free(all);
        *all = *more;
        *more = (orr_bias_set){0};
        return ORR_OK;
    }
    for (size_t i = 0; i < more->n; i++)
        if (more->bias[i].sat == ORR_SAT_NONE && more->bias[i].kind == ORR_BIAS_DSB)
            more->bias[i].value_s -= datum(all, more, &more->bias[i]);
    orr_bias *bias = realloc(all->bias, (all->n + more->n) * sizeof *bias);
    if (bias == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for code biases");
    memcpy(bias + all->n, more->bias, more->n * sizeof *bias);
    all->bias = bias;
    all->n += more->n;
    orr_bias_free(more);
    return ORR_OK;
}
