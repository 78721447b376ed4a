// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/iono_source.h"

#include <stdlib.h>

#include "iono/field/tec_files.h"

struct orr_iono_source {
    bool has_session;
    orr_session session;
    orr_tec_field *field;
    orr_transfer_options transfer;
};

orr_status orr_iono_source_open(const orr_scenario *s, orr_iono_source **out, orr_warnings *warnings,
                                orr_diag *diag)
{
    const orr_scenario_iono *o = &s->iono;
    *out = NULL;
    if (o->field == NULL && o->session == NULL) return ORR_OK;
    orr_iono_source *i = calloc(1, sizeof *i);
    if (i == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    i->transfer = (orr_transfer_options){.seed = (uint64_t)o->seed, .noise = o->noise};
    orr_status status;
    if (o->session != NULL) {
        status = orr_session_load(o->session, &i->session, diag);
        i->has_session = status == ORR_OK;
    } else
        status = orr_tec_field_open(o->field, NULL, &i->field, warnings, diag);
    if (status != ORR_OK) {
        orr_iono_source_close(i);
        return status;
    }
    *out = i;
    return ORR_OK;
}

void orr_iono_source_close(orr_iono_source *i)
{
    if (i == NULL) return;
    orr_session_free(&i->session);
    orr_tec_field_free(i->field);
    free(i);
}

bool orr_iono_source_station(const orr_iono_source *i, orr_vec3 *out)
{
    if (i->has_session) *out = i->session.site.pos_m;
    return i->has_session;
}

orr_status orr_iono_source_realise(const orr_iono_source *i, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                                   const orr_vec3 *sat_m, size_t n, orr_realisation *out, size_t *n_out,
                                   orr_diag *diag)
{
    return i->has_session
               ? orr_session_realise(&i->session, t, site_m, sat, sat_m, n, &i->transfer, out, n_out, diag)
               : orr_field_realise(i->field, t, site_m, sat, sat_m, n, out, n_out, diag);
}
