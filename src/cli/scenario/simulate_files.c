// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/scenario/simulate_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "core/sha256.h"
#include "ingest/rinex/clk.h"
#include "src/cli/frame/json.h"
#include "src/cli/orbit/states_write.h"
#include "src/cli/scenario/replay_report.h"
#include "src/make/readings.h"
#include "src/scenario/receiver/port_file.h"

orr_status simulate_path(const simulation *s, const char *name, char path[SIMULATE_PATH], orr_diag *diag)
{
    const int n = snprintf(path, SIMULATE_PATH, "%s/%s", s->folder, name);
    if (n < 0 || n >= SIMULATE_PATH) return orr_diag_set(diag, ORR_E_LIMIT, "%s: the name is too long", name);
    return orr_cli_file_check(s->c, path, orr_scenario_schema(), s->scenario, diag);
}

orr_status simulate_note(simulation *s, const char *name, const char *note, orr_diag *diag)
{
    char path[SIMULATE_PATH], hex[ORR_SHA256_HEX];
    (void)snprintf(path, sizeof path, "%s/%s", s->folder, name); // it was written there
    orr_status status = orr_sha256_file(path, hex, diag);
    if (status != ORR_OK) return status;
    json_array_append_new(s->files, json_pack("{s:s, s:s, s:s}", "name", name, "sha256", hex, "what", note));
    orr_cli_say(s->c, "%s: %s", path, note);
    return ORR_OK;
}

orr_status simulate_residuals(simulation *s, const char *antenna, orr_diag *diag)
{
    const orr_replay_report *report;
    const orr_replay *r = orr_engine_replay(s->engine, &report);
    orr_status status = ORR_OK;
    for (int json = 0; json < 2 && status == ORR_OK; json++) {
        char name[128], path[SIMULATE_PATH];
        orr_outfile out;
        snprintf(name, sizeof name, "%s-residuals.%s", antenna, json ? "json" : "csv");
        status = simulate_path(s, name, path, diag);
        if (status == ORR_OK) status = orr_outfile_open(path, &out, diag);
        if (status != ORR_OK) break;
        json_t *all = json ? orr_replay_report_json(r, report) : NULL;
        if (!json)
            orr_replay_report_csv(out.stream, r);
        else if (all == NULL || json_dumpf(all, out.stream, JSON_INDENT(2) | JSON_REAL_PRECISION(9)) != 0)
            status = orr_diag_set(diag, ORR_E_IO, "%s: could not be written", path);
        if (json) fputc('\n', out.stream);
        json_decref(all);
        status = orr_outfile_end(&out, status, diag);
        if (status == ORR_OK)
            status = simulate_note(s, name, "residuals of the replay by satellite and signal", diag);
    }
    return status;
}

// Signals that a format cannot tell are told of once, for the first antenna.
static void say_left_out(const simulation *s, const char *format, uint64_t left_out)
{
    size_t n;
    char list[256] = "";
    const orr_signal *signal = orr_signals(&n);
    for (size_t k = 0, at = 0; k < n && at < sizeof list - 16; k++)
        if ((left_out >> k & 1u) != 0)
            at += (size_t)snprintf(list + at, sizeof list - at, "%s%c:%s", at > 0 ? ", " : "",
                                   signal[k].system, signal[k].name);
    if (left_out != 0) orr_cli_say(s->c, "--%s leaves out %s, which it has no numbers for", format, list);
}

orr_status simulate_ports(simulation *s, size_t k, const orr_observe_plan *plan, orr_diag *diag)
{
    static const struct {
        const char *option, *ending, *what;
        orr_port_format format;
    } rows[ORR_PORT_FILES] = {{"rtcm", "rtcm3", "RTCM 3: station, ephemerides, MSM", ORR_PORT_RTCM},
                              {"ubx", "ubx", "UBX: NAV-PVT, RXM-RAWX, RXM-SFRBX", ORR_PORT_UBX},
                              {"nmea", "nmea", "NMEA 0183 of the true position", ORR_PORT_NMEA}};
    const orr_channels *channels = orr_engine_channels(s->engine);
    orr_port_file file[ORR_PORT_FILES];
    char path[ORR_PORT_FILES][SIMULATE_PATH], name[ORR_PORT_FILES][80];
    size_t n = 0, row[ORR_PORT_FILES];
    orr_status status = ORR_OK;
    for (size_t j = 0; status == ORR_OK && j < ORR_PORT_FILES; j++) {
        if (!orr_cli_given(s->c, rows[j].option)) continue;
        if (k == 0) say_left_out(s, rows[j].option, orr_port_left_out(rows[j].format, channels));
        snprintf(name[n], sizeof name[n], "%s.%s", orr_channels_antenna(channels, k)->name, rows[j].ending);
        status = simulate_path(s, name[n], path[n], diag);
        file[n] = (orr_port_file){.plan = {.format = rows[j].format,
                                           .channels = channels,
                                           .antenna = k,
                                           .navdata = orr_engine_source_navdata(s->engine),
                                           .leap = s->c->leap,
                                           .msm = orr_cli_says(s->c, "msm", "4") ? 4 : 7,
                                           .station = (unsigned)(k + 1)},
                                  .path = path[n]};
        row[n++] = j;
    }
    if (status != ORR_OK || n == 0) return status;
    status = orr_port_files(plan, file, n, diag);
    for (size_t j = 0; status == ORR_OK && j < n; j++)
        status = simulate_note(s, name[j], rows[row[j]].what, diag);
    return status;
}

// Where the simulated time begins, in headers: the same scenario makes the same bytes.
static void header_date(orr_time t, const orr_leap_table *leap, char *date, size_t n)
{
    orr_civil c;
    orr_time_to_civil(t, ORR_SCALE_UTC, leap, &c);
    snprintf(date, n, "%04d%02d%02d %02d%02d%02d UTC", c.year, c.month, c.day, c.hour, c.minute, c.second);
}

orr_status simulate_broadcast(simulation *s, orr_diag *diag)
{
    const orr_navset *set = orr_engine_navset(s->engine);
    char path[SIMULATE_PATH];
    orr_nav nav;
    orr_span span;
    if (set == NULL) return ORR_OK;
    orr_status status = simulate_path(s, "broadcast.rnx", path, diag);
    if (status == ORR_OK) status = orr_navset_records(set, &nav, diag);
    if (status != ORR_OK) return status;
    snprintf(nav.program, sizeof nav.program, "orrery %s", ORR_VERSION);
    if (orr_engine_part_span(s->engine, ORR_PART_NAVDATA, &span))
        header_date(span.from, s->c->leap, nav.date, sizeof nav.date);
    status = orr_nav_write(&nav, path, NULL, diag);
    orr_nav_free(&nav);
    return status == ORR_OK ? simulate_note(s, "broadcast.rnx", "broadcast data, RINEX 3.05", diag) : status;
}

static void clocks_free(orr_clk *x)
{
    for (size_t k = 0; x->sat != NULL && k < x->n_sats; k++) free(x->sat[k].record);
    free(x->sat);
    free(x->epoch);
}

static orr_status make_clocks(const orr_ephemeris *e, orr_span span, int64_t step_ns, orr_clk *out,
                              orr_diag *diag)
{
    const orr_sat *list;
    *out = (orr_clk){.system = 'M', .scale = ORR_SCALE_GPS};
    out->n_sats = orr_ephemeris_satellites(e, &list);
    out->n_epochs = (size_t)((span.to - span.from) / step_ns) + 1;
    out->sat = calloc(out->n_sats + 1, sizeof *out->sat);
    out->epoch = calloc(out->n_epochs, sizeof *out->epoch);
    if (out->sat == NULL || out->epoch == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t i = 0; i < out->n_epochs; i++) out->epoch[i] = orr_time_add(span.from, (int64_t)i * step_ns);
    for (size_t k = 0; k < out->n_sats; k++) {
        orr_clk_series *c = &out->sat[k];
        c->sat = list[k];
        orr_sat_text(list[k], c->name);
        c->record = calloc(out->n_epochs, sizeof *c->record);
        if (c->record == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t i = 0; i < out->n_epochs; i++) {
            orr_sat_state x;
            if (orr_ephemeris_eval(e, list[k], out->epoch[i], &x) != ORR_OK ||
                (x.flags & ORR_EPH_CLOCK_VALID) == 0)
                continue;
            c->record[c->n++] = (orr_clk_record){.t = out->epoch[i], .bias_s = x.clock_s};
        }
    }
    return ORR_OK;
}

orr_status simulate_orbits(simulation *s, orr_diag *diag)
{
    const orr_ephemeris *e = orr_engine_ephemeris(s->engine);
    char path[SIMULATE_PATH];
    orr_span span;
    states_count count = {0};
    if (e == NULL || !orr_engine_part_span(s->engine, ORR_PART_ORBITS, &span)) return ORR_OK;
    orr_status status = simulate_path(s, "truth.sp3", path, diag);
    const states_request q = {.product = orr_engine_title(s->engine),
                              .path = path,
                              .from = span.from,
                              .to = span.to,
                              .step_ns = 300 * ORR_NS_PER_S};
    orr_products products = {0};
    if (status == ORR_OK) status = orr_products_of(e, &products, diag);
    if (status == ORR_OK) status = states_write_sp3(&products, &q, &count, diag);
    orr_products_free(&products);
    if (status == ORR_OK)
        status = simulate_note(s, "truth.sp3", "true orbits and clocks every 5 min, SP3-d", diag);
    orr_clk clk = {.n_sats = 0};
    if (status == ORR_OK) status = simulate_path(s, "truth.clk", path, diag);
    if (status == ORR_OK) status = make_clocks(e, span, 30 * ORR_NS_PER_S, &clk, diag);
    if (status == ORR_OK) {
        snprintf(clk.program, sizeof clk.program, "orrery %s", ORR_VERSION);
        snprintf(clk.agency, sizeof clk.agency, "true clocks of a simulation");
        header_date(span.from, s->c->leap, clk.date, sizeof clk.date);
        status = orr_clk_write(&clk, path, diag);
    }
    clocks_free(&clk);
    return status == ORR_OK ? simulate_note(s, "truth.clk", "true clocks every 30 s, RINEX 3.00", diag)
                            : status;
}

orr_status simulate_readings(simulation *s, orr_diag *diag)
{
    const orr_moving *moving = orr_engine_moving(s->engine);
    orr_status status = ORR_OK;
    for (size_t unit = 0; moving != NULL && status == ORR_OK && unit < moving->n_units; unit++) {
        char name[32], path[SIMULATE_PATH], note[80];
        orr_readings r = {.truth_every = 0};
        orr_readings_plan p = orr_readings_plan_of(moving);
        p.unit = unit;
        snprintf(name, sizeof name, "imu-%zu.nc", unit);
        snprintf(note, sizeof note, "ideal inertial readings of unit %zu at %g Hz", unit, p.rate_hz);
        status = simulate_path(s, name, path, diag);
        if (status == ORR_OK) status = orr_readings_make(&p, &r, diag);
        if (status == ORR_OK)
            status = orr_readings_save(&r, &p, s->scenario, &s->inputs, path, "orrery simulate", diag);
        orr_readings_free(&r);
        if (status == ORR_OK) status = simulate_note(s, name, note, diag);
    }
    return status;
}

orr_status simulate_manifest(simulation *s, json_t *options, orr_diag *diag)
{
    char path[SIMULATE_PATH];
    json_t *inputs = json_array();
    for (size_t k = 0; k < s->inputs.n; k++)
        json_array_append_new(inputs, json_pack("{s:s, s:s}", "name", s->inputs.item[k].name, "sha256",
                                                s->inputs.item[k].sha256));
    json_t *all =
        json_pack("{s:s, s:s, s:o, s:o, s:O}", "program", "orrery " ORR_VERSION, "title",
                  orr_engine_title(s->engine), "options", options, "inputs", inputs, "files", s->files);
    if (all == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_outfile out;
    orr_status status = simulate_path(s, "manifest.json", path, diag);
    if (status == ORR_OK) status = orr_outfile_open(path, &out, diag);
    if (status == ORR_OK) {
        if (json_dumpf(all, out.stream, JSON_INDENT(2) | JSON_REAL_PRECISION(12)) != 0)
            status = orr_diag_set(diag, ORR_E_IO, "%s: could not be written", path);
        fputc('\n', out.stream);
        status = orr_outfile_end(&out, status, diag);
    }
    json_decref(all);
    return status;
}
