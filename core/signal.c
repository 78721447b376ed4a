// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

static const orr_signal SIGNALS[] = {
#define ORR_SIGNAL(...) {__VA_ARGS__},
#include "core/signal.def"
#undef ORR_SIGNAL
};
enum { N_SIGNALS = sizeof SIGNALS / sizeof *SIGNALS };
_Static_assert(N_SIGNALS <= 64, "a set of signals is 64 bits");

const orr_signal *orr_signals(size_t *n)
{
    *n = N_SIGNALS;
    return SIGNALS;
}

uint64_t orr_signals_of(char system)
{
    uint64_t set = 0;
    for (size_t k = 0; k < N_SIGNALS; k++)
        if (SIGNALS[k].system == system) set |= UINT64_C(1) << k;
    return set;
}

const orr_signal *orr_signal_find(char system, const char *name)
{
    for (size_t k = 0; k < N_SIGNALS; k++)
        if (SIGNALS[k].system == system && strcasecmp(SIGNALS[k].name, name) == 0) return &SIGNALS[k];
    return NULL;
}

static orr_status no_such(const char *text, char system, orr_diag *diag)
{
    char list[512] = "";
    size_t at = 0;
    for (size_t k = 0; k < N_SIGNALS && at < sizeof list; k++)
        if (system == 0 || SIGNALS[k].system == system)
            at += (size_t)snprintf(list + at, sizeof list - at, " %c:%s", SIGNALS[k].system, SIGNALS[k].name);
    return orr_diag_set(diag, ORR_E_ARG, "there is no signal '%s'; there are%s", text, list);
}

orr_status orr_signal_parse(const char *text, uint64_t *set, orr_diag *diag)
{
    const char *colon = strchr(text, ':');
    const bool system_alone = strlen(text) == 1 && strchr(ORR_SYSTEMS, text[0]) != NULL;
    const char system = system_alone || (colon != NULL && colon == text + 1) ? text[0] : 0;
    const char *name = system_alone ? NULL : colon != NULL ? colon + 1 : text;
    uint64_t found = 0;
    if (colon == NULL || colon == text + 1)
        for (size_t k = 0; k < N_SIGNALS; k++)
            if ((system == 0 || SIGNALS[k].system == system) &&
                (name == NULL || strcasecmp(SIGNALS[k].name, name) == 0))
                found |= UINT64_C(1) << k;
    if (found == 0)
        return no_such(text, system != 0 && strchr(ORR_SYSTEMS, system) != NULL ? system : 0, diag);
    *set |= found;
    return ORR_OK;
}

#define ORR_NOT_SENT 0.0 // no signal is as strong
static const struct {
    const char *antex, *metadata;
    char system;
    const char *name;
    double power_dbw;
} BLOCKS[] = {
#define ORR_BLOCK_SIGNAL(...) {__VA_ARGS__},
#include "core/signal_blocks.def"
#undef ORR_BLOCK_SIGNAL
};

// "BLOCK IIR" is the block of "BLOCK IIR-A" and of "BLOCK IIR", not of "BLOCK IIRX".
static bool is_block(const char *block, const char *name)
{
    const size_t n = strlen(name);
    return strncmp(block, name, n) == 0 && (block[n] == '\0' || block[n] == '-');
}

bool orr_signal_of_block(const orr_signal *s, const char *block, double *power_dbw)
{
    *power_dbw = s->power_dbw;
    for (size_t k = 0; block != NULL && k < sizeof BLOCKS / sizeof *BLOCKS; k++)
        if (BLOCKS[k].system == s->system && strcmp(BLOCKS[k].name, s->name) == 0 &&
            (is_block(block, BLOCKS[k].antex) || is_block(block, BLOCKS[k].metadata))) {
            if (!(BLOCKS[k].power_dbw < 0)) return false;
            *power_dbw = BLOCKS[k].power_dbw;
            return true;
        }
    return true;
}

double orr_signal_carrier_hz(const orr_signal *s, int channel)
{
    return s->carrier_hz + channel * s->channel_hz;
}
