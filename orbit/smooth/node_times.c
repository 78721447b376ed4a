// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/node_times.h"

#include <stdlib.h>

static bool tells(const orr_node *n) { return isfinite(n->told_s) && orr_node_counts(n) && !n->foreign; }

orr_status orr_node_times_take(orr_node_table *table, size_t n_files, orr_epoch_spread *file)
{
    size_t most = 0, n = 0;
    for (size_t i = 0; i < table->n_sats; i++) most += table->list[i].n_nodes;
    orr_time_reading *reading = malloc((most + 1) * sizeof *reading);
    if (reading == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < table->n_sats; i++)
        for (size_t k = 0; k < table->list[i].n_nodes; k++) {
            const orr_node *node = &table->list[i].node[k];
            if (tells(node))
                reading[n++] = (orr_time_reading){node->t, node->source, (uint16_t)i, node->told_s};
        }
    orr_epoch_times times;
    const orr_status s = orr_epoch_times_find(reading, n, &times);
    free(reading);
    if (s != ORR_OK) return s;
    for (size_t f = 0; f < n_files; f++) file[f] = orr_epoch_times_spread(&times, (uint16_t)f);
    for (size_t i = 0; i < table->n_sats && times.n > 0; i++)
        for (size_t k = 0; k < table->list[i].n_nodes; k++) {
            orr_node *node = &table->list[i].node[k];
            if (orr_node_counts(node)) node->late_s = orr_epoch_late_s(&times, node->source, node->t);
        }
    orr_epoch_times_free(&times);
    return ORR_OK;
}
