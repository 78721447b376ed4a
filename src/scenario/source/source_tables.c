// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/source_tables.h"

#include "src/make/inputs.h"

orr_status orr_source_tables_open(const orr_scenario *s, orr_warnings *warnings, orr_source_tables *out,
                                  orr_diag *diag)
{
    const bool sends = s->signals.n > 0;
    const char *antex = s->navdata.antex != NULL ? s->navdata.antex : sends ? s->channel.antex : NULL;
    const char *bias = s->navdata.bias != NULL ? s->navdata.bias : sends ? s->channel.bias : NULL;
    orr_status status = ORR_OK;
    *out = (orr_source_tables){.has_antex = false};
    if (antex != NULL) {
        status = orr_antex_read(antex, NULL, &out->antex, warnings, diag);
        out->has_antex = status == ORR_OK;
    }
    if (status == ORR_OK && bias != NULL) {
        status = orr_bias_read(bias, NULL, &out->bias, warnings, diag);
        out->has_bias = status == ORR_OK;
    }
    if (status == ORR_OK) {
        orr_inputs own = {.leap = s->leap};
        status = orr_inputs_read_navs(&own, (const char *const *)s->navdata.nav.item, s->navdata.nav.n,
                                      &out->nav, warnings, diag);
        orr_inputs_free(&own);
    }
    return status;
}

void orr_source_tables_close(orr_source_tables *t)
{
    if (t->has_antex) orr_antex_free(&t->antex);
    if (t->has_bias) orr_bias_free(&t->bias);
    orr_nav_free(&t->nav);
    *t = (orr_source_tables){.has_antex = false};
}
