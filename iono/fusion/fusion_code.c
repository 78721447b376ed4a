// SPDX-License-Identifier: GPL-3.0-or-later
// What the codes say of an arc's bias. Their noise averages out over the arc; the satellite's biases come
// from files, the receiver's is one unknown for every system and pair of codes.
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/nan.h"
#include "iono/fusion/fusion_private.h"
#include "iono/phase/signals.h"

static orr_status group_of(orr_fusion *out, char system, const char range[2][4], size_t *group,
                           orr_diag *diag)
{
    for (size_t g = 0; g < out->n_groups; g++)
        if (out->group[g].system == system &&
            memcmp(out->group[g].range, range, sizeof out->group[g].range) == 0) {
            *group = g;
            return ORR_OK;
        }
    orr_code_group *more = realloc(out->group, (out->n_groups + 1) * sizeof *more);
    if (more == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for receiver biases");
    out->group = more;
    more[out->n_groups] = (orr_code_group){.system = system,
                                           .receiver_tecu = ORR_NAN,
                                           .sigma_tecu = ORR_NAN,
                                           .published_tecu = ORR_NAN,
                                           .published_sigma_tecu = ORR_NAN};
    memcpy(more[out->n_groups].range, range, sizeof more->range);
    *group = out->n_groups++;
    return ORR_OK;
}

// The station's own bias of a group, where a file has a differential bias of just these codes. (CODE's absolute
// biases of stations have no geometry-free part and tell nothing of the level.)
static void publish(const orr_phase_tec *phase, const orr_bias_set *biases, size_t n_biases,
                    double tecu_per_s, orr_code_group *g)
{
    for (size_t b = 0; b < n_biases; b++)
        for (size_t i = 0; i < biases[b].n; i++) {
            const orr_bias *x = &biases[b].bias[i];
            if (x->kind != ORR_BIAS_DSB || x->station[0] == '\0' || x->system != g->system ||
                x->sat != ORR_SAT_NONE || strncasecmp(x->station, phase->marker, 4) != 0)
                continue;
            bool same = strcmp(x->obs1, g->range[0]) == 0 && strcmp(x->obs2, g->range[1]) == 0;
            bool turned = strcmp(x->obs1, g->range[1]) == 0 && strcmp(x->obs2, g->range[0]) == 0;
            if ((!same && !turned) || (x->until != ORR_TIME_NONE && x->until <= phase->from) ||
                (x->from != ORR_TIME_NONE && x->from > phase->to))
                continue;
            // Codes minus content are K c (B2 - B1).
            g->published_tecu = (same ? -1 : 1) * tecu_per_s * x->value_s;
            g->published_sigma_tecu = tecu_per_s * (x->sdev_s > 0 ? x->sdev_s : 0.5e-9);
            return;
        }
}

orr_status fusion_level_codes(const orr_phase_tec *phase, const orr_bias_set *biases, size_t n_biases,
                              const orr_fusion_options *o, orr_fusion *out, orr_diag *diag)
{
    for (size_t a = 0; a < out->n_arcs; a++) {
        orr_fused_arc *arc = &out->arc[a];
        const orr_phase_sat *sat = &phase->sat[arc->sat_index];
        arc->code_bias_tecu = ORR_NAN;
        arc->code_used = false;
        arc->group = 0;
        if (sat->range[0][0] == '\0' || sat->range[1][0] == '\0') continue;
        orr_time mid = arc->from + (arc->to - arc->from) / 2;
        double difference_s = 0;
        bool known = false;
        for (size_t b = 0; b < n_biases && !known; b++)
            known = orr_bias_dsb(&biases[b], arc->sat, sat->range[0], sat->range[1], mid, &difference_s) ==
                    ORR_OK;
        if (!known) continue;
        // True = measured - bias, so K (P2 - P1) carries K c (B2 - B1).
        double satellite =
            orr_tecu_per_metre(sat->freq_hz[0], sat->freq_hz[1]) * ORR_LIGHT_MPS * difference_s;
        double sum = 0, weights = 0;
        size_t n = 0;
        for (size_t i = sat->arcs.arc[arc->arc].first; i <= sat->arcs.arc[arc->arc].last; i++) {
            if (sat->arcs.arc_of[i] != (int)arc->arc || isnan(sat->code_tecu[i])) continue;
            double s = sin(sat->pierce[i].el_rad), w = s * s;
            sum += w * (sat->gf_tecu[i] - (sat->code_tecu[i] + satellite));
            weights += w;
            n++;
        }
        if (n < 20) continue;
        arc->code_bias_tecu = sum / weights;
        orr_status s = group_of(out, orr_sat_system(arc->sat), sat->range, &arc->group, diag);
        if (s != ORR_OK) return s;
        if (!o->withhold_station_bias && orr_sat_system(arc->sat) != 'R') // GLONASS's differ by channel
            publish(phase, biases, n_biases,
                    orr_tecu_per_metre(sat->freq_hz[0], sat->freq_hz[1]) * ORR_LIGHT_MPS,
                    &out->group[arc->group]);
    }
    return ORR_OK;
}
