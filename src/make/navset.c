// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/navset.h"

#include "core/parallel.h"
#include "iono/field/tec_files.h"
#include "src/make/broadcast_iono.h"
#include "src/make/frames.h"

enum { MAX_FILES = 400 };

orr_navset_plan orr_navset_plan_default(void)
{
    orr_navset_plan p = {.options = orr_navset_defaults()};
    p.options.jobs = orr_parallel_cores();
    return p;
}

bool orr_navset_plan_of(const orr_scenario *s, orr_navset_plan *out)
{
    const orr_scenario_navdata *n = &s->navdata;
    *out = orr_navset_plan_default();
    out->antex = n->antex;
    out->bias = n->bias;
    out->nav = (const char *const *)n->nav.item;
    out->n_nav = n->nav.n;
    out->field = s->iono.field;
    out->nequick = s->iono.nequick;
    out->options.leap = s->leap;
    out->options.unhealthy = &s->satellites.unhealthy;
    out->options.window_s = n->window == ORR_NAVDATA_4H ? 14400 : 7200;
    out->options.zero_clocks = n->zero_clocks;
    return n->window != ORR_NAVDATA_NONE;
}

// What the files say, and what the navset is shown of it.
typedef struct files {
    orr_antex antex;
    orr_bias_set bias;
    orr_nav named, field;
    orr_nav_iono fitted[ORR_BROADCAST_IONO_MODELS];
    orr_nav shown; // borrows from these
} files;

static void files_free(files *f)
{
    orr_nav_free(&f->named);
    orr_nav_free(&f->field);
    orr_bias_free(&f->bias);
    orr_antex_free(&f->antex);
}

static bool has_klobuchar(const orr_nav *nav)
{
    for (size_t i = 0; i < nav->n_iono; i++)
        if (nav->iono[i].kind == ORR_NAV_KLOBUCHAR && nav->iono[i].system == 'G') return true;
    return false;
}

// A field of another kind (maps, coefficients) is no navigation file and no fault. Its warnings are told by who reads it
// for the ionosphere.
static orr_status read_field(const char *path, orr_inputs *inputs, orr_nav *out, bool *is_nav, orr_diag *diag)
{
    orr_bytes text;
    orr_diag other = {0};
    *is_nav = false;
    if (path == NULL) return ORR_OK;
    orr_inputs own = {.leap = inputs->leap};
    orr_nav_limits limits = orr_nav_default_limits();
    limits.leap = inputs->leap;
    orr_status s = orr_inputs_read(&own, path,
                                   ORR_KIND_BIT(ORR_KIND_IONEX) | ORR_KIND_BIT(ORR_KIND_ION) |
                                       ORR_KIND_BIT(ORR_KIND_RINEX_NAV),
                                   &text, &other);
    if (s == ORR_OK) s = orr_nav_parse(path, text.text, text.n, &limits, out, NULL, &other);
    orr_bytes_free(&text);
    *is_nav = s == ORR_OK;
    if (s == ORR_OK) s = orr_inputs_join(inputs, &own, &other);
    orr_inputs_free(&own);
    if (s == ORR_E_KIND) return ORR_OK;
    if (s != ORR_OK && diag != NULL) *diag = other;
    return s;
}

// What satellites say of a field of TEC.
static orr_status fit_field(const orr_navset_plan *plan, const orr_ephemeris *e, files *f, orr_diag *diag)
{
    orr_tec_options options = orr_tec_default_options();
    orr_tec_field *field = NULL;
    orr_nequick *tables = NULL;
    orr_time from, to;
    size_t n = 0;
    options.leap = plan->options.leap;
    orr_ephemeris_span(e, &from, &to);
    orr_status s = orr_tec_field_open(plan->field, &options, &field, NULL, diag);
    if (s == ORR_OK && plan->nequick != NULL) s = orr_nequick_load(plan->nequick, &tables, diag);
    if (s == ORR_OK) {
        orr_diag none = {0};
        s = orr_broadcast_iono_fit(field, from, to, tables, options.leap, f->fitted, &n, &none);
        if (s == ORR_E_NODATA) s = ORR_OK; // another day's field: nothing is said of it
        if (s != ORR_OK && diag != NULL) *diag = none;
    }
    orr_nequick_free(tables);
    orr_tec_field_free(field);
    if (n > 0) f->shown.iono = f->fitted, f->shown.n_iono = n;
    return s;
}

// Ephemerides (GLONASS' channels) of the files that are named for it, or else of the ionosphere's; likewise GPS'
// Klobuchar.
static orr_status read_navs(const orr_ephemeris *e, const orr_navset_plan *plan, files *f,
                            orr_navset_options *o, orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag)
{
    if (plan->n_nav > MAX_FILES)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu navigation files; at most %d are read", plan->n_nav,
                            MAX_FILES);
    bool has_field = false;
    orr_status s = plan->nav_read != NULL
                       ? ORR_OK
                       : orr_inputs_read_navs(inputs, plan->nav, plan->n_nav, &f->named, warnings, diag);
    if (s == ORR_OK) s = read_field(plan->field, inputs, &f->field, &has_field, diag);
    if (s != ORR_OK) return s;
    f->shown = plan->nav_read != NULL ? *plan->nav_read : plan->n_nav > 0 ? f->named : f->field;
    if (has_field && !has_klobuchar(&f->shown)) {
        f->shown.iono = f->field.iono;
        f->shown.n_iono = f->field.n_iono;
    }
    if (plan->field != NULL && !has_field && !has_klobuchar(&f->shown)) s = fit_field(plan, e, f, diag);
    if (plan->n_nav > 0 || has_field || f->shown.n_iono > 0) o->nav = &f->shown;
    return s;
}

static orr_status read_all(const orr_ephemeris *e, const orr_navset_plan *plan, files *f,
                           orr_navset_options *o, orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes text;
    orr_status s = ORR_OK;
    if (plan->antex_read != NULL) {
        o->antex = plan->antex_read;
    } else if (plan->antex != NULL) {
        s = orr_inputs_read(inputs, plan->antex, ORR_KIND_BIT(ORR_KIND_ANTEX), &text, diag);
        if (s == ORR_OK) s = orr_antex_parse(plan->antex, text.text, text.n, NULL, &f->antex, warnings, diag);
        orr_bytes_free(&text);
        o->antex = &f->antex;
    }
    if (s == ORR_OK && o->antex != NULL)
        orr_frames_check_antex(o->antex, plan->antex, orr_ephemeris_frame(e), warnings);
    if (plan->bias_read != NULL) {
        o->bias = plan->bias_read;
    } else if (s == ORR_OK && plan->bias != NULL) {
        s = orr_inputs_read(inputs, plan->bias,
                            ORR_KIND_BIT(ORR_KIND_BIAS_SINEX) | ORR_KIND_BIT(ORR_KIND_DCB), &text, diag);
        if (s == ORR_OK) s = orr_bias_parse(plan->bias, text.text, text.n, NULL, &f->bias, warnings, diag);
        orr_bytes_free(&text);
        o->bias = &f->bias;
    }
    return s == ORR_OK ? read_navs(e, plan, f, o, inputs, warnings, diag) : s;
}

orr_status orr_navset_make(const orr_ephemeris *e, const orr_navset_plan *plan, orr_navset **out,
                           orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag)
{
    *out = NULL;
    files f = {0};
    orr_navset_options o = plan->options;
    orr_inputs own = {.leap = o.leap};
    orr_status s = read_all(e, plan, &f, &o, inputs != NULL ? inputs : &own, warnings, diag);
    if (s == ORR_OK) s = orr_navset_build(e, &o, out, warnings, diag);
    files_free(&f);
    orr_inputs_free(&own);
    return s;
}
