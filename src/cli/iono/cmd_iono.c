// SPDX-License-Identifier: GPL-3.0-or-later
// orrery iono: a station's carrier phases and a TEC field fused into a session of delays; two stations side
// by side.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "ingest/tables/sinex.h"
#include "iono/field/tec_files.h"
#include "iono/fusion/session.h"
#include "src/cli/frame/cli.h"
#include "src/cli/iono/iono_report.h"
#include "src/cli/iono/position_source.h"
#include "src/cli/iono/tec_options.h"

#define MAX_BIAS_FILES 16

// What a run holds, so that one place frees it.
typedef struct work {
    orr_position_source *orbit;
    orr_tec_field *field;
    orr_bias_set bias[MAX_BIAS_FILES];
    size_t n_biases;
    orr_phase_tec phase, other;
    orr_fusion fusion;
    orr_session session;
    orr_curves comparison;
    orr_warnings warnings;
} work;

static void work_free(work *w)
{
    orr_position_source_close(w->orbit);
    orr_tec_field_free(w->field);
    for (size_t i = 0; i < w->n_biases; i++) orr_bias_free(&w->bias[i]);
    orr_fusion_free(&w->fusion, &w->phase);
    orr_phase_tec_free(&w->phase);
    orr_phase_tec_free(&w->other);
    orr_session_free(&w->session);
    orr_curves_free(&w->comparison);
    orr_warnings_free(&w->warnings);
}

// --receiver PLACE or --sinex FILE (the station by the first four characters of the file's name in the
// observations).
static orr_status ask_position(const orr_cli *c, bool *given, orr_vec3 *out, orr_diag *diag)
{
    orr_geodetic place;
    *given = orr_cli_place(c, "receiver", &place);
    if (*given) {
        *out = orr_earth_to_ecef(place);
        return ORR_OK;
    }
    if (!orr_cli_given(c, "sinex")) return ORR_OK;
    const char *slash = strrchr(c->operand[0], '/'), *name = slash != NULL ? slash + 1 : c->operand[0];
    char code[5] = "";
    snprintf(code, sizeof code, "%.4s", name);
    const char *station = orr_cli_text(c, "station", code);
    orr_sinex x;
    orr_status s = orr_sinex_read(orr_cli_text(c, "sinex", ""), NULL, &x, NULL, diag);
    if (s != ORR_OK) return s;
    double pos[3];
    s = orr_sinex_position(&x, station, orr_cli_time(c, "from", x.from), pos);
    orr_sinex_free(&x);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "%s has no coordinates of station %s (--station names another)",
                            orr_cli_text(c, "sinex", ""), station);
    *out = (orr_vec3){pos[0], pos[1], pos[2]};
    *given = true;
    return ORR_OK;
}

static orr_status read_phases(const orr_cli *c, work *w, const char *path, const orr_vec3 *site,
                              orr_phase_tec *out, orr_diag *diag)
{
    orr_phase_options o = orr_phase_default_options();
    o.sats = orr_cli_sats(c, "sat");
    o.from = orr_cli_time(c, "from", ORR_TIME_NONE);
    o.to = orr_cli_time(c, "to", ORR_TIME_NONE);
    o.step_s = (double)orr_cli_duration_ns(c, "step", 0) * 1e-9;
    o.mask_rad = orr_cli_real(c, "mask", 10) * ORR_RAD_PER_DEG;
    o.site_m = site;
    o.windup = !orr_cli_given(c, "no-windup");
    if (w->orbit != NULL) {
        o.position = orr_position_source_at;
        o.user = w->orbit;
    }
    if (w->field != NULL) o.shell_radius_m = orr_tec_field_shell_radius_m(w->field);
    // Gaps are measured in the data's own interval: what a pair of missing epochs is at 30 s is much at 1 s
    // and nothing at 5 min.
    orr_status s = orr_phase_tec_read(path, &o, out, &w->warnings, diag);
    if (s == ORR_OK && out->interval_s * 4 > o.arcs.max_gap_s) {
        o.arcs.max_gap_s = 4 * out->interval_s;
        o.arcs.min_samples = 10;
        orr_phase_tec_free(out);
        s = orr_phase_tec_read(path, &o, out, NULL, diag);
    }
    return s;
}

static orr_status read_inputs(const orr_cli *c, work *w, orr_diag *diag)
{
    orr_status s = ORR_OK;
    if (orr_cli_given(c, "orbit"))
        s = orr_position_source_open(orr_cli_text(c, "orbit", ""), &w->orbit, &w->warnings, diag);
    for (size_t i = 0; s == ORR_OK && i < orr_cli_count(c, "biases"); i++) {
        if (i == MAX_BIAS_FILES)
            return orr_diag_set(diag, ORR_E_LIMIT, "more than %d files of biases", MAX_BIAS_FILES);
        s = orr_bias_read(orr_cli_text_at(c, "biases", i), NULL, &w->bias[i], &w->warnings, diag);
        if (s == ORR_OK) w->n_biases = i + 1;
    }
    return s;
}

static orr_status open_field(const orr_cli *c, const orr_tec_options *o, work *w, orr_diag *diag)
{
    orr_status s = orr_tec_field_open(orr_cli_text(c, "field", ""), o, &w->field, &w->warnings, diag);
    if (s == ORR_OK) orr_tec_fit_say(c, w->field);
    return s;
}

static orr_status print_to(const orr_cli *c, const work *w,
                           void (*print)(FILE *, const orr_cli *, const work *), orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(orr_cli_text(c, "csv", "-"), &out, diag);
    if (s != ORR_OK) return s;
    print(out.stream, c, w);
    return orr_outfile_commit(&out, diag);
}

static void print_comparison(FILE *f, const orr_cli *c, const work *w)
{
    (void)c;
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    fputs("t_gps,sat,curve,a_tecu,b_tecu,difference_tecu\n", f);
    for (size_t i = 0; i < w->comparison.n_curves; i++) {
        const orr_curve *k = &w->comparison.curve[i];
        for (size_t j = k->first; j < k->first + k->n; j++) {
            const orr_curve_point *p = &w->comparison.point[j];
            fprintf(f, "%s,%s,%zu,%.4f,%.4f,%.4f\n", orr_time_text(p->t, time), orr_sat_text(k->sat, sat),
                    i + 1, p->a_tecu, p->b_tecu, p->a_tecu - p->b_tecu);
        }
    }
}

static int compare(const orr_cli *c, work *w)
{
    orr_diag diag = {0};
    orr_vec3 site = {0};
    bool given = false;
    orr_status s = read_inputs(c, w, &diag);
    if (s == ORR_OK) s = ask_position(c, &given, &site, &diag);
    if (s == ORR_OK) s = read_phases(c, w, c->operand[0], given ? &site : NULL, &w->phase, &diag);
    if (s == ORR_OK) s = read_phases(c, w, orr_cli_text(c, "compare", ""), NULL, &w->other, &diag);
    if (s == ORR_OK)
        s = orr_phase_compare(&w->phase, &w->other, orr_cli_real(c, "match", 0.1), 20, &w->comparison, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const orr_curves *k = &w->comparison;
    if (orr_cli_given(c, "json")) orr_iono_report_comparison_json(stdout, &w->phase, &w->other, k);
    if (orr_cli_given(c, "csv") || !orr_cli_given(c, "json")) s = print_to(c, w, print_comparison, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c,
                "%s and %s, %.0f m apart: %zu curves, %zu epochs, RMS difference %.4f TECU (%.2f cm on L1)",
                w->phase.marker, w->other.marker, k->baseline_m, k->n_curves, k->n_points, k->rms_tecu,
                100 * orr_iono_delay_m(k->rms_tecu, 1575.42e6, ORR_MEASURES_CODE));
    return ORR_EXIT_OK;
}

static void print_session(FILE *f, const orr_cli *c, const work *w)
{
    (void)c;
    orr_iono_report_session_csv(f, &w->session);
}

static orr_status save(orr_cli *c, work *w, orr_diag *diag)
{
    const char *input[MAX_BIAS_FILES + 3];
    size_t n = 0;
    input[n++] = c->operand[0];
    input[n++] = orr_cli_text(c, "field", "");
    input[n++] = orr_cli_text(c, "orbit", "");
    for (size_t i = 0; i < w->n_biases; i++) input[n++] = orr_cli_text_at(c, "biases", i);
    orr_status s = orr_session_save(&w->session, orr_cli_text(c, "output", ""), c->call, input, n, diag);
    return s;
}

static int fuse(orr_cli *c, work *w)
{
    orr_diag diag = {0};
    orr_tec_options o;
    int e = orr_tec_options_ask(c, &o);
    if (e != ORR_EXIT_OK) return e;
    if (!orr_cli_given(c, "field")) return orr_cli_usage(c, "a fusion needs a field: --field FILE");
    if (!orr_cli_given(c, "orbit"))
        return orr_cli_usage(c, "a fusion needs the satellites' positions: --orbit FILE");
    orr_fusion_options f = orr_fusion_default_options();
    f.method =
        strcmp(orr_cli_text(c, "method", "joint"), "thesis") == 0 ? ORR_FUSION_THESIS : ORR_FUSION_JOINT;
    const char *systems = orr_cli_text(c, "code", f.code_systems);
    if (strcmp(systems, "none") == 0) systems = "";
    if (strlen(systems) >= sizeof f.code_systems || strspn(systems, ORR_SYSTEMS) != strlen(systems))
        return orr_cli_usage(c, "--code \"%s\" is no row of system letters (%s), nor none", systems,
                             ORR_SYSTEMS);
    memcpy(f.code_systems, systems, strlen(systems) + 1);
    orr_status s = open_field(c, &o, w, &diag);
    if (s == ORR_OK) s = read_inputs(c, w, &diag);
    orr_vec3 site = {0};
    bool given = false;
    if (s == ORR_OK) s = ask_position(c, &given, &site, &diag);
    if (s == ORR_OK) s = read_phases(c, w, c->operand[0], given ? &site : NULL, &w->phase, &diag);
    orr_leave_out left = {0};
    if (s == ORR_OK && orr_cli_given(c, "leave-one-out"))
        s = orr_fusion_leave_one_out(&w->phase, w->field, w->bias, w->n_biases, &f, 3600, &left, &diag);
    if (s == ORR_OK) s = orr_fuse(&w->phase, w->field, w->bias, w->n_biases, &f, &w->fusion, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (w->fusion.n_no_model > 0)
        orr_warnings_add(&w->warnings, orr_tec_field_source(w->field), 0, 0,
                         "%zu samples pierce holes of the maps and are left out", w->fusion.n_no_model);
    bool explain = orr_cli_given(c, "explain"), json = orr_cli_given(c, "json");
    if (json)
        orr_iono_report_json(stdout, &w->phase, &w->fusion, orr_cli_given(c, "leave-one-out") ? &left : NULL,
                             explain);
    else
        orr_iono_report_text(stdout, &w->phase, &w->fusion, orr_cli_given(c, "leave-one-out") ? &left : NULL,
                             explain);
    if (!orr_cli_given(c, "output") && !orr_cli_given(c, "csv")) return ORR_EXIT_OK;
    double gap = fmax(300, 4 * w->phase.interval_s);
    orr_tec_field *field = w->field;
    w->field = NULL; // the session owns it now
    s = orr_session_make(&w->phase, &w->fusion, field, gap, &w->session, &diag);
    if (s == ORR_OK && orr_cli_given(c, "csv")) s = print_to(c, w, print_session, &diag);
    if (s == ORR_OK && orr_cli_given(c, "output")) s = save(c, w, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c, "small-scale structure: %.2f TECU, fading over %.0f km and %.0f min",
                w->session.small.sigma_tecu, w->session.small.length_m / 1e3, w->session.small.time_s / 60);
    if (orr_cli_given(c, "output"))
        orr_cli_say(c, "%s: %zu arcs, %zu samples", orr_cli_text(c, "output", ""), w->session.n_arcs,
                    w->session.n_samples);
    return ORR_EXIT_OK;
}

static int run(orr_cli *c)
{
    work *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_cli_failf(c, "out of memory");
    int e = orr_cli_given(c, "compare") ? compare(c, w) : fuse(c, w);
    orr_cli_warnings(c, &w->warnings);
    work_free(w);
    free(w);
    return e;
}

static const orr_option options[] = {
    {.name = "field",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The TEC field: IONEX, Bernese .ION, or a navigation file (Klobuchar)."},
    {.name = "orbit",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Positions of satellites: a product of `orrery orbit`, or a RINEX navigation file."},
    {.name = "method",
     .applies = "!compare",
     .kind = ORR_OPT_CHOICE,
     .value = "thesis|joint",
     .help = "How arcs are levelled. joint (default): all arcs' biases and an hourly quadratic correction of "
             "the field in one least-squares adjustment. thesis: the mean of phase minus model over each arc "
             "(Bogdanov 2015)."},
    {.name = "biases",
     .applies = "!compare",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .help = "Code biases of satellites (Bias-SINEX or CODE's DCB files): codes then help to level arcs."},
    {.name = "code",
     .applies = "!compare",
     .kind = ORR_OPT_TEXT,
     .value = "SYSTEMS",
     .help = "Systems whose codes help to level arcs, e.g. GE, or none. G by default; Galileo codes are then "
             "an independent check."},
    {.name = "output",
     .applies = "!compare",
     .letter = 'o',
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The session, a NetCDF-4 file."},
    {.name = "csv",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The fused curves (or, with --compare, both stations') as CSV; - is standard output."},
    {.name = "json", .kind = ORR_OPT_FLAG, .help = "The report as JSON."},
    {.name = "explain",
     .applies = "!compare",
     .kind = ORR_OPT_FLAG,
     .help = "List every arc and every slip, with what was decided and why."},
    {.name = "leave-one-out",
     .applies = "!compare",
     .kind = ORR_OPT_FLAG,
     .help = "Predict each arc of an hour and more from the others, and tell how well."},
    {.name = "compare",
     .kind = ORR_OPT_TEXT,
     .value = "OBS",
     .help =
         "Another station: the same satellites' curves side by side, centred; needs no field, and no orbit."},
    {.name = "match",
     .applies = "compare",
     .kind = ORR_OPT_REAL,
     .value = "S",
     .min = 0,
     .max = 60,
     .help = "With --compare: epochs count as one within this; 0.1 s by default."},
    {.name = "sat",
     .kind = ORR_OPT_SATS,
     .value = "LIST",
     .help = "Satellites, e.g. G,E01-E09; all by default."},
    {.name = "from", .kind = ORR_OPT_TIME, .value = "T", .help = "First epoch."},
    {.name = "to", .kind = ORR_OPT_TIME, .value = "T", .help = "Last epoch."},
    {.name = "step",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Take epochs this far apart; all by default."},
    {.name = "mask",
     .kind = ORR_OPT_REAL,
     .value = "DEG",
     .min = 0,
     .max = 80,
     .help = "Elevation mask; 10 by default."},
    {.name = "receiver",
     .kind = ORR_OPT_PLACE,
     .value = "LAT,LON,H|ecef:X,Y,Z",
     .help = "The station, in degrees (geodetic) and metres; where the file's header puts it by default."},
    {.name = "sinex",
     .applies = "!receiver",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Take the station's position from a SINEX file."},
    {.name = "station",
     .applies = "sinex",
     .kind = ORR_OPT_TEXT,
     .value = "CODE",
     .help = "Its name there; the first four characters of OBS by default."},
    {.name = "no-windup", .kind = ORR_OPT_FLAG, .help = "Do not correct phase wind-up, to see its effect."},
    ORR_TEC_OPTIONS,
};

const orr_command orr_cmd_iono = {
    .name = "iono",
    .group = "Ionosphere",
    .summary = "fuse a station's phases with a TEC field; compare two stations",
    .operands = "OBS",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Dual-frequency carrier phases tell how the slant electron content changes, to hundredths of a "
             "TECU, but not how much "
             "it is; maps tell how much, to some TECU. OBS (RINEX 2 to 4, Hatanaka or plain) is cut into "
             "unbroken arcs of GPS, "
             "GLONASS, Galileo and BeiDou; cycle slips are found, repaired where their cycles are known, and "
             "explained with "
             "--explain. The fused curve is the phase minus one constant an arc.\n\n"
             "The session (-o) holds the curves, the field, the correction of the field over the station and "
             "what structure "
             "it leaves. A scenario can name it, and then delays are served for the station's antenna and "
             "for others near it.",
    .example = "orrery iono BOR1.crx.gz --field maps.INX --orbit day.nc --biases day.BIA -o session.nc\n"
               "orrery iono BOR1.crx.gz --field maps.INX --orbit day.nc --method thesis --json\n"
               "orrery iono A.05o --compare B.05o --csv curves.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
