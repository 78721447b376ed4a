// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/station.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/path.h"
#include "ingest/input/sniff.h"
#include "ingest/rinex/rinex_obs.h"
#include "ingest/tables/sinex.h"
#include "iono/fusion/ionex_bias.h"

// Of the level's a-priori sigma: where so much is left the session has told nothing.
#define UNDETERMINED 0.8

#define OBSERVATIONS (ORR_KIND_BIT(ORR_KIND_RINEX_OBS) | ORR_KIND_BIT(ORR_KIND_CRINEX))

orr_station_plan orr_station_plan_default(void)
{
    return (orr_station_plan){.phase = orr_phase_default_options(),
                              .tec = orr_tec_default_options(),
                              .fusion = orr_fusion_default_options()};
}

void orr_station_free(orr_station *s)
{
    orr_bytes_free(&s->observations);
    orr_station_shared_free(&s->own);
    orr_tec_field_free(s->field);
    orr_bias_free(&s->bias);
    orr_antex_free(&s->antex);
    orr_fusion_free(&s->fusion, &s->phase);
    orr_phase_tec_free(&s->phase);
    orr_session_free(&s->session);
    orr_inputs_free(&s->inputs);
    *s = (orr_station){0};
}

// Biases of a text, whichever kind of file it is.
static orr_status parse_biases(const char *path, const orr_bytes *text, orr_bias_set *out,
                               orr_warnings *warnings, orr_diag *diag)
{
    orr_status status = orr_bias_parse(path, text->text, text->n, NULL, out, warnings, diag);
    if (status != ORR_E_KIND) return status;
    orr_ionex maps;
    status = orr_ionex_parse(path, text->text, text->n, NULL, &maps, warnings, diag);
    if (status == ORR_E_KIND)
        return orr_diag_at(diag, ORR_E_KIND, path, 0, 0,
                           "neither Bias-SINEX, nor CODE's DCB text, nor an IONEX file with code biases");
    if (status != ORR_OK) return status;
    status = orr_bias_of_ionex(&maps, out, diag);
    orr_ionex_free(&maps);
    if (status == ORR_OK && out->n == 0)
        status = orr_diag_at(diag, ORR_E_NODATA, path, 0, 0, "this IONEX file has no code biases");
    return status;
}

static orr_status read_biases(orr_station *s, orr_warnings *warnings, orr_diag *diag)
{
    const orr_station_plan *p = s->plan;
    orr_status status = ORR_OK;
    for (size_t i = 0; i < p->n_biases && status == ORR_OK; i++) {
        orr_bytes text;
        orr_bias_set more = {0};
        status = orr_inputs_read(&s->inputs, p->biases[i],
                                 ORR_KIND_BIT(ORR_KIND_BIAS_SINEX) | ORR_KIND_BIT(ORR_KIND_DCB) |
                                     ORR_KIND_BIT(ORR_KIND_IONEX),
                                 &text, diag);
        if (status == ORR_OK) status = parse_biases(p->biases[i], &text, &more, warnings, diag);
        orr_bytes_free(&text);
        if (status == ORR_OK) status = orr_bias_join(&s->bias, &more, diag);
    }
    return status;
}

// The antenna's reference point over a marker; the marker itself where no eccentricity is valid at t.
static orr_vec3 reference_point(const orr_sinex *x, const char *code, orr_time t, orr_vec3 marker_m)
{
    const orr_sinex_eccentricity *e = orr_sinex_find_eccentricity(x, code, t);
    if (e == NULL) return marker_m;
    if (!e->local) return orr_vec3_add(marker_m, (orr_vec3){e->offset_m[0], e->offset_m[1], e->offset_m[2]});
    const orr_geodetic place = orr_earth_from_ecef(marker_m);
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad),
                   back = orr_mat3_transpose(&enu);
    const orr_vec3 offset = {e->offset_m[2], e->offset_m[1], e->offset_m[0]}; // files say Up, North, East
    return orr_vec3_add(marker_m, orr_mat3_apply(&back, offset));
}

static orr_status site_of_sinex(orr_station *s, orr_diag *diag)
{
    const orr_station_plan *p = s->plan;
    char code[5];
    snprintf(code, sizeof code, "%.4s", orr_base_name(p->observations));
    const char *name = p->code != NULL ? p->code : code;
    orr_bytes text;
    orr_sinex x;
    double pos[3];
    orr_status status = orr_inputs_read(&s->inputs, p->sinex, ORR_KIND_BIT(ORR_KIND_SINEX), &text, diag);
    if (status != ORR_OK) return status;
    status = orr_sinex_parse(p->sinex, text.text, text.n, NULL, &x, NULL, diag);
    orr_bytes_free(&text);
    if (status != ORR_OK) return status;
    const orr_time t = p->phase.from != ORR_TIME_NONE ? p->phase.from : x.from;
    status = orr_sinex_position(&x, name, t, pos);
    if (status == ORR_OK) s->site_m = reference_point(&x, name, t, (orr_vec3){pos[0], pos[1], pos[2]});
    orr_sinex_free(&x);
    if (status != ORR_OK)
        return orr_diag_set(diag, status, "%s has no coordinates of station %s (--station names another)",
                            p->sinex, name);
    return ORR_OK;
}

// Frequency channels that a navigation file tells; of several records of a slot the last.
static void note_channels(orr_station_shared *x, const orr_nav *nav)
{
    for (size_t i = 0; nav != NULL && i < nav->n_eph; i++)
        if (nav->eph[i].kind == ORR_NAV_GLONASS)
            x->glonass_channel[orr_sat_number(nav->eph[i].sat) % 100] =
                (int8_t)nav->eph[i].glonass.freq_channel;
}

static void channels_of_field(orr_station_shared *x, const orr_bytes *text)
{
    orr_nav nav;
    if (orr_sniff((orr_view){text->text, text->n < 65536 ? text->n : 65536}).kind != ORR_KIND_RINEX_NAV)
        return;
    if (orr_nav_parse("", text->text, text->n, NULL, &nav, NULL, NULL) != ORR_OK)
        return; // the field's reader says why
    note_channels(x, &nav);
    orr_nav_free(&nav);
}

// The field, and where it is an IONEX file its code biases, which belong to its level.
static orr_status read_field(const orr_station_plan *p, orr_station_shared *x, orr_warnings *warnings,
                             orr_diag *diag)
{
    orr_bytes text;
    orr_status status = orr_inputs_read(&x->inputs, p->field,
                                        ORR_KIND_BIT(ORR_KIND_IONEX) | ORR_KIND_BIT(ORR_KIND_ION) |
                                            ORR_KIND_BIT(ORR_KIND_RINEX_NAV),
                                        &text, diag);
    if (status == ORR_OK)
        status = orr_tec_field_parse(p->field, text.text, text.n, &p->tec, &x->field, warnings, diag);
    if (status == ORR_OK) channels_of_field(x, &text);
    orr_ionex maps;
    if (status == ORR_OK && orr_ionex_parse(p->field, text.text, text.n, NULL, &maps, NULL, NULL) == ORR_OK) {
        status = orr_bias_of_ionex(&maps, &x->bias, diag);
        orr_ionex_free(&maps);
    }
    orr_bytes_free(&text);
    return status;
}

orr_status orr_station_share(const orr_station_plan *plan, orr_station_shared *out, orr_warnings *warnings,
                             orr_diag *diag)
{
    *out = (orr_station_shared){.inputs = {.leap = plan->tec.leap}};
    memset(out->glonass_channel, ORR_OBS_NO_CHANNEL, sizeof out->glonass_channel);
    orr_status s = plan->field != NULL ? read_field(plan, out, warnings, diag) : ORR_OK;
    if (s == ORR_OK && plan->orbit != NULL)
        s = orr_positions_open(plan->orbit, plan->messages, &out->positions, &out->inputs, warnings, diag);
    if (s == ORR_OK && out->positions != NULL) note_channels(out, orr_positions_nav(out->positions));
    return s;
}

void orr_station_shared_free(orr_station_shared *x)
{
    orr_tec_field_free(x->field);
    orr_bias_free(&x->bias);
    orr_positions_close(x->positions);
    orr_inputs_free(&x->inputs);
    *x = (orr_station_shared){0};
}

static orr_status copy_biases(const orr_bias_set *from, orr_bias_set *out, orr_diag *diag)
{
    *out = *from;
    if (from->n == 0) {
        out->bias = NULL;
        return ORR_OK;
    }
    out->bias = malloc(from->n * sizeof *out->bias);
    if (out->bias == NULL) {
        out->n = 0;
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for code biases");
    }
    memcpy(out->bias, from->bias, from->n * sizeof *out->bias);
    return ORR_OK;
}

// Takes field and positions over from what was opened, each station with biases of its own.
static orr_status take_shared(orr_station *s, const orr_station_shared *from, orr_bias_set *biases,
                              orr_diag *diag)
{
    s->field = orr_tec_field_share(from->field);
    s->positions = from->positions;
    memcpy(s->glonass_channel, from->glonass_channel, sizeof s->glonass_channel);
    const orr_status status = copy_biases(&from->bias, biases, diag);
    return status == ORR_OK ? orr_inputs_join(&s->inputs, &from->inputs, diag) : status;
}

static orr_status read_antennas(orr_station *s, orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes text;
    orr_status status =
        orr_inputs_read(&s->inputs, s->plan->antex, ORR_KIND_BIT(ORR_KIND_ANTEX), &text, diag);
    if (status == ORR_OK)
        status = orr_antex_parse(s->plan->antex, text.text, text.n, NULL, &s->antex, warnings, diag);
    orr_bytes_free(&text);
    return status;
}

static orr_status read_inputs(orr_station *s, orr_warnings *warnings, orr_diag *diag)
{
    const orr_station_plan *p = s->plan;
    s->inputs.leap = p->tec.leap;
    orr_status status =
        orr_inputs_read_raw(&s->inputs, p->observations, OBSERVATIONS, &s->observations, diag);
    orr_bias_set of_field = {0};
    if (status == ORR_OK && p->shared == NULL) status = orr_station_share(p, &s->own, warnings, diag);
    if (status == ORR_OK) status = take_shared(s, p->shared != NULL ? p->shared : &s->own, &of_field, diag);
    if (status == ORR_OK && p->antex != NULL) status = read_antennas(s, warnings, diag);
    if (status == ORR_OK) status = read_biases(s, warnings, diag);
    if (status == ORR_OK) status = orr_bias_join(&s->bias, &of_field, diag);
    orr_bias_free(&of_field);
    if (status == ORR_OK && !p->has_site && p->sinex != NULL) status = site_of_sinex(s, diag);
    return status;
}

static orr_status read_phases(const char *name, const orr_bytes *raw, const orr_phase_options *options,
                              orr_phase_tec *out, orr_warnings *warnings, orr_diag *diag)
{
    orr_phase_options o = *options;
    orr_status s = orr_phase_tec_make(name, raw->text, raw->n, &o, out, warnings, diag);
    // Gaps are measured in the data's own interval: what a pair of missing epochs is at 30 s is much at 1 s and nothing
    // at 5 min.
    if (s == ORR_OK && out->interval_s * 4 > o.arcs.max_gap_s) {
        o.arcs.max_gap_s = 4 * out->interval_s;
        o.arcs.min_samples = 10;
        orr_phase_tec_free(out);
        s = orr_phase_tec_make(name, raw->text, raw->n, &o, out, NULL, diag);
    }
    return s;
}

orr_status orr_station_open(const orr_station_plan *plan, orr_station *out, orr_warnings *warnings,
                            orr_diag *diag)
{
    *out = (orr_station){.plan = plan, .options = plan->phase, .site_m = plan->site_m};
    orr_status s = read_inputs(out, warnings, diag);
    if (s != ORR_OK) return s;
    orr_phase_options *o = &out->options;
    o->glonass_channel = out->glonass_channel;
    if (out->positions != NULL) {
        o->position = orr_positions_at;
        o->user = out->positions;
    }
    if (plan->position != NULL) {
        o->position = plan->position;
        o->user = plan->user;
    }
    if (plan->antex != NULL) o->antex = &out->antex;
    if (out->field != NULL) o->shell_radius_m = orr_tec_field_shell_radius_m(out->field);
    orr_phase_options own = *o;
    own.site_m = plan->has_site || plan->sinex != NULL ? &out->site_m : NULL;
    s = read_phases(plan->observations, &out->observations, &own, &out->phase, warnings, diag);
    if (s == ORR_OK && out->phase.n_without_antenna > 0)
        orr_warnings_add(
            warnings, plan->antex, 0, 0,
            "%zu satellites have no antenna with both carriers there; their phase centres are taken as one",
            out->phase.n_without_antenna);
    orr_bytes_free(&out->observations);
    return s;
}

orr_status orr_station_other(const orr_station *s, const char *path, orr_phase_tec *out,
                             orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes raw;
    *out = (orr_phase_tec){0};
    orr_status status = orr_inputs_read_raw(NULL, path, OBSERVATIONS, &raw, diag);
    if (status == ORR_OK) status = read_phases(path, &raw, &s->options, out, warnings, diag);
    orr_bytes_free(&raw);
    return status;
}

orr_status orr_station_fuse(orr_station *s, orr_warnings *warnings, orr_diag *diag)
{
    orr_status status =
        orr_fuse(&s->phase, s->field, &s->bias, s->bias.n > 0 ? 1 : 0, &s->plan->fusion, &s->fusion, diag);
    if (status == ORR_OK && s->fusion.n_no_model > 0)
        orr_warnings_add(warnings, orr_tec_field_source(s->field), 0, 0,
                         "%zu samples pierce holes of the maps and are left out", s->fusion.n_no_model);
    if (status != ORR_OK) return status;
    const orr_fusion *f = &s->fusion;
    const char *name = s->phase.marker[0] != '\0' ? s->phase.marker : s->plan->observations;
    if (f->fallback == ORR_FUSION_TOO_FEW_ARCS)
        orr_warnings_add(
            warnings, name, 0, 0,
            "one arc cannot tell the field's error from its own bias: it is levelled to the field as it is "
            "(--method thesis), which is known to %.1f TECU",
            f->field_rms_tecu);
    else if (f->fallback == ORR_FUSION_NO_GAIN)
        orr_warnings_add(
            warnings, name, 0, 0,
            "a correction of the field does not help arcs that it was not fitted to; the field is used as "
            "it is");
    else if (f->method == ORR_FUSION_JOINT &&
             f->level_sigma_tecu > UNDETERMINED * hypot(f->model.level_tecu, f->model.rms_tecu))
        orr_warnings_add(
            warnings, name, 0, 0,
            "this session does not determine the level of the content: it is the field's own, good to "
            "%.1f TECU vertical; more satellites, a longer session or the station's code bias would",
            f->level_sigma_tecu);
    return status;
}

orr_status orr_station_session(orr_station *s, orr_diag *diag)
{
    orr_tec_field *field = s->field;
    s->field = NULL; // the session owns it now
    return orr_session_make(&s->phase, &s->fusion, field, fmax(300, 4 * s->phase.interval_s), &s->session,
                            diag);
}

orr_status orr_station_save(const orr_station *s, const char *path, const char *history, orr_diag *diag)
{
    orr_nc_input *input = orr_inputs_provenance(&s->inputs);
    if (input == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of inputs");
    orr_status status = orr_session_save(&s->session, path, history, input, s->inputs.n, diag);
    free(input);
    return status;
}
