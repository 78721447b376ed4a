// SPDX-License-Identifier: GPL-3.0-or-later
// orrery iono: a station's carrier phases and a TEC field fused into a session of delays; two stations side
// by side.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/outfile.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/iono/iono_report.h"
#include "src/cli/iono/tec_options.h"
#include "src/make/station.h"

// What a run holds, so that one place frees it.
typedef struct work {
    orr_station_plan plan;
    const char **biases;
    orr_station station;
    orr_phase_tec other;
    orr_curves comparison;
    orr_warnings warnings;
} work;

static void work_free(work *w)
{
    orr_station_free(&w->station);
    orr_phase_tec_free(&w->other);
    orr_curves_free(&w->comparison);
    orr_warnings_free(&w->warnings);
    free(w->biases);
}

// The options; an exit status.
static int make_plan(const orr_cli *c, work *w)
{
    orr_station_plan *p = &w->plan;
    *p = orr_station_plan_default();
    p->tec.leap = p->phase.leap = c->leap; // of --compare too, which has no field
    p->observations = c->operand[0];
    p->orbit = orr_cli_text(c, "orbit", NULL);
    orr_diag diag;
    if (orr_cli_given(c, "message") &&
        orr_nav_messages_parse(orr_cli_text(c, "message", ""), &p->messages, &diag) != ORR_OK)
        return orr_cli_usage(c, "--message: %s", diag.text);
    w->biases = orr_cli_texts(c, "biases", &p->n_biases);
    if (w->biases == NULL) return orr_cli_failf(c, "out of memory");
    p->biases = w->biases;
    p->antex = orr_cli_text(c, "antex", NULL);
    orr_geodetic place;
    p->has_site = orr_cli_place(c, "receiver", &place);
    if (p->has_site) p->site_m = orr_earth_to_ecef(place);
    p->sinex = orr_cli_text(c, "sinex", NULL);
    p->code = orr_cli_text(c, "station", NULL);
    p->phase.sats = orr_cli_sats(c, "sat");
    p->phase.from = orr_cli_time(c, "from", ORR_TIME_NONE);
    p->phase.to = orr_cli_time(c, "to", ORR_TIME_NONE);
    p->phase.step_s = (double)orr_cli_duration_ns(c, "step", 0) * 1e-9;
    p->phase.mask_rad = orr_cli_real(c, "mask", 10) * ORR_RAD_PER_DEG;
    p->phase.windup = !orr_cli_given(c, "no-windup");
    if (orr_cli_given(c, "compare")) return ORR_EXIT_OK;
    p->field = orr_cli_text(c, "field", NULL);
    if (p->field == NULL) return orr_cli_usage(c, "a fusion needs a field: --field FILE");
    if (p->orbit == NULL) return orr_cli_usage(c, "a fusion needs the satellites' positions: --orbit FILE");
    orr_fusion_options *f = &p->fusion;
    f->method =
        strcmp(orr_cli_text(c, "method", "joint"), "thesis") == 0 ? ORR_FUSION_THESIS : ORR_FUSION_JOINT;
    f->withhold_station_bias = orr_cli_given(c, "withhold-station-bias");
    const char *systems = orr_cli_text(c, "code", f->code_systems);
    if (strcmp(systems, "none") == 0) systems = "";
    if (strlen(systems) >= sizeof f->code_systems || strspn(systems, ORR_SYSTEMS) != strlen(systems))
        return orr_cli_usage(c, "--code \"%s\" is no row of system letters (%s), nor none", systems,
                             ORR_SYSTEMS);
    memmove(f->code_systems, systems, strlen(systems) + 1);
    return orr_tec_options_ask(c, &p->tec);
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
    const orr_phase_tec *phase = &w->station.phase;
    orr_status s = orr_station_open(&w->plan, &w->station, &w->warnings, &diag);
    if (s == ORR_OK)
        s = orr_station_other(&w->station, orr_cli_text(c, "compare", ""), &w->other, &w->warnings, &diag);
    if (s == ORR_OK)
        s = orr_phase_compare(phase, &w->other, orr_cli_real(c, "match", 0.1), 20, &w->comparison, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const orr_curves *k = &w->comparison;
    if (orr_cli_says(c, "format", "json")) orr_iono_report_comparison_json(stdout, phase, &w->other, k);
    if (orr_cli_given(c, "csv") || !orr_cli_says(c, "format", "json"))
        s = print_to(c, w, print_comparison, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c,
                "%s and %s, %.0f m apart: %zu curves, %zu epochs, RMS difference %.4f TECU (%.2f cm on L1)",
                phase->marker, w->other.marker, k->baseline_m, k->n_curves, k->n_points, k->rms_tecu,
                100 * orr_iono_delay_m(k->rms_tecu, ORR_L1_HZ, ORR_MEASURES_CODE));
    return ORR_EXIT_OK;
}

static void print_session(FILE *f, const orr_cli *c, const work *w)
{
    (void)c;
    orr_iono_report_session_csv(f, &w->station.session);
}

// Whether standard output is the series of --csv; the report then goes to standard error.
static bool to_stdout(const orr_cli *c) { return strcmp(orr_cli_text(c, "csv", ""), "-") == 0; }

static void report(const orr_cli *c, const orr_station *st)
{
    const bool explain = orr_cli_given(c, "explain");
    if (orr_cli_says(c, "format", "json"))
        orr_iono_report_json(stdout, &st->phase, &st->fusion, explain);
    else
        orr_iono_report_text(to_stdout(c) ? stderr : stdout, &st->phase, &st->fusion, explain);
}

static int fuse(const orr_cli *c, work *w)
{
    if (to_stdout(c) && orr_cli_says(c, "format", "json"))
        return orr_cli_usage(c, "only one of --csv - and --format json can go to standard output");
    orr_diag diag = {0};
    orr_station *st = &w->station;
    const char *output = orr_cli_text(c, "output", NULL);
    const bool csv = orr_cli_given(c, "csv");
    orr_status s = orr_station_open(&w->plan, st, &w->warnings, &diag);
    if (st->field != NULL) orr_tec_fit_say(c, st->field);
    if (s == ORR_OK) s = orr_station_fuse(st, &w->warnings, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    report(c, st);
    if (output == NULL && !csv) return ORR_EXIT_OK;
    s = orr_station_session(st, &diag);
    if (s == ORR_OK && csv) s = print_to(c, w, print_session, &diag);
    if (s == ORR_OK && output != NULL) s = orr_station_save(st, output, c->call, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const orr_session *session = &st->session;
    orr_cli_say(c, "small-scale structure: %.2f TECU, fading over %.0f km and %.0f min",
                session->small.sigma_tecu, session->small.length_m / 1e3, session->small.time_s / 60);
    if (output != NULL)
        orr_cli_say(c, "%s: %zu arcs, %zu samples", output, session->n_arcs, session->n_samples);
    return ORR_EXIT_OK;
}

static int run(orr_cli *c)
{
    work *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_cli_failf(c, "out of memory");
    int e = make_plan(c, w);
    if (e == ORR_EXIT_OK) e = orr_cli_given(c, "compare") ? compare(c, w) : fuse(c, w);
    orr_cli_warnings(c, &w->warnings);
    work_free(w);
    free(w);
    return e;
}

static const orr_option options[] = {
    {.name = "field",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The TEC field: IONEX, Bernese .ION, or a navigation file (a broadcast model)."},
    {.name = "orbit",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help =
         "Positions of satellites: a product of `orrery orbit`, or a RINEX navigation file, which also tells "
         "GLONASS channels that the observations' header does not."},
    {.name = "message",
     .applies = "orbit",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Messages of a navigation file to use in the systems that have them, e.g. CNAV,FNAV. By default "
             "LNAV, I/NAV, "
             "D1/D2 and FDMA, and of a satellite that has none of these records what there is."},
    {.name = "method",
     .applies = "!compare",
     .kind = ORR_OPT_CHOICE,
     .value = "thesis|joint",
     .help = "How arcs are levelled. joint (default): all arcs' biases and an hourly cubic correction of the "
             "field in one least-squares adjustment, as strong as the session's likelihood allows. thesis: "
             "the mean of phase minus model over each arc "
             "(Bogdanov 2015)."},
    {.name = "biases",
     .applies = "!compare",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .help = "Code biases (Bias-SINEX, CODE's DCB files, IONEX): codes then help to level arcs. Those of an "
             "IONEX "
             "field are used besides."},
    {.name = "antex",
     .applies = "orbit",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Phase centres of the satellites' antennas (ANTEX): those of some satellites stand so far apart "
             "for the two "
             "carriers that codes are off by several TECU."},
    {.name = "code",
     .applies = "!compare",
     .kind = ORR_OPT_TEXT,
     .value = "SYSTEMS",
     .help = "Systems whose codes help to level arcs, e.g. GE, or none. G by default; Galileo codes are then "
             "an independent check."},
    ORR_OPTION_OUTPUT_AS(.applies = "!compare", .help = "The session, a NetCDF-4 file."),
    {.writes = true,
     .name = "csv",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The fused curves (or, with --compare, both stations') as CSV; - is standard output."},
    ORR_OPTION_REPORT,
    {.name = "explain",
     .applies = "!compare",
     .kind = ORR_OPT_FLAG,
     .help = "List every arc and every slip, with what was decided and why."},
    {.name = "withhold-station-bias",
     .applies = "!compare",
     .kind = ORR_OPT_FLAG,
     .help = "Do not use the station's own code bias where a file has it: to judge the level against it."},
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
    ORR_OPTION_SATS,
    ORR_OPTION_FROM(.help = "First epoch."),
    ORR_OPTION_TO(.help = "Last epoch."),
    ORR_OPTION_STEP(.help = "Take epochs this far apart; all by default."),
    {.name = "mask",
     .kind = ORR_OPT_REAL,
     .value = "DEG",
     .min = 0,
     .max = 80,
     .help = "Elevation mask; 10 by default."},
    ORR_OPTION_RECEIVER(
            .help =
                "The station, in degrees (geodetic) and metres; where the file's header puts it by default."),
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
               "orrery iono BOR1.crx.gz --field maps.INX --orbit day.nc --method thesis --format json\n"
               "orrery iono A.05o --compare B.05o --csv curves.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
