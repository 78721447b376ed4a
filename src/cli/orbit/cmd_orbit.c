// SPDX-License-Identifier: GPL-3.0-or-later
// orrery orbit: SP3 files in, an orbit product out.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/monotonic.h"
#include "core/path.h"
#include "ingest/fetch/fetch.h"
#include "orbit/force/gravity_field.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/orbit_summary.h"
#include "src/make/newest.h"
#include "src/make/orbit.h"
#include "src/make/rotation_file.h"

#define MODEL_DEGREE 60 // of a gravity model, by default
#define USUAL_BEYOND_NOW_NS (6 * 3600 * ORR_NS_PER_S)

static const orr_option options[] = {
    ORR_OPTION_OUTPUT_AS(.required = true,
                         .help = "Write the product, a NetCDF-4 file; it appears whole or not at all."),
    {.name = "nodes",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Use only epochs that are multiples of S from midnight of the first file, by the files' own "
             "time scale; all by default."},
    {.name = "exclude",
     .kind = ORR_OPT_INTERVAL,
     .value = "FROM/TO",
     .repeated = true,
     .help = "Do not use nodes from FROM on and before TO; where the two are the same, the nodes of that "
             "instant."},
    ORR_OPTION_SATS,
    ORR_OPTION_ERP(
            .repeated = true,
            .help = "File of Earth rotation parameters: of the IGS, or the IERS' finals or C04. Without one "
                    "the orbits "
                    "themselves tell the pole and the "
                    "length of day; of fewer than four satellites nothing does, and the IERS secular pole is "
                    "used, "
                    "and UT1 by the leap seconds."),
    {.writes = true,
     .name = "erp-out",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help =
         "Write the Earth rotation that the product holds, estimated or given, as a file of Earth rotation "
         "parameters (IGS version 2)."},
    ORR_OPTION_NAV(
            .repeated = true,
            .help =
                "RINEX navigation file: the a-priori orbit comes from broadcast ephemerides (variant A)."),
    {.name = "bridge",
     .applies = "nav",
     .kind = ORR_OPT_FLAG,
     .help = "Bridge hours without nodes at broadcast quality, flagged as predicted."},
    {.name = "extend-to",
     .applies = "bridge",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "Go on beyond the last node up to T, as long as there are broadcast ephemerides."},
    {.name = "clk",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .help = "RINEX clock file (30 s, 5 s, ...): its clocks come before those of the SP3 files, which fill "
             "what it does "
             "not have. Where it is of another centre it is brought to their reference clock by the median "
             "over the "
             "satellites of a system, epoch by epoch, and that is told."},
    {.name = "clock-gap",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Longest hole in a satellite's clock that is bridged, with a standard deviation that says how "
             "well; 1350 s by "
             "default, and 1.5 of the files' steps wherever that is longer. Across longer holes there is no "
             "clock."},
    {.name = "reference-clock",
     .kind = ORR_OPT_CHOICE,
     .value = "keep|remove",
     .help = "Steps and ramps that the clocks of all satellites share are the reference clock's. keep "
             "(default): clocks "
             "are as the files give them. remove: they are taken out, and clocks go on as they are after the "
             "last."},
    {.name = "predict",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Go on so long beyond the last observed position, seven days at most: orbits by a fit to the "
             "last two "
             "days, clocks, Earth rotation, flagged as predicted, with a sigma that grows. What the files "
             "themselves "
             "predict is not used. With --now, beyond the present; 6 h then by default."},
    {.name = "now",
     .kind = ORR_OPT_FLAG,
     .help = "Go on to the present instant, and for --predict beyond it."},
    {.name = "present",
     .applies = "now",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "The instant that --now takes for the present; the system's clock by default."},
    {.name = "max-gap",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Longest gap between nodes that is bridged; 8 h by default."},
    ORR_OPTION_JOBS,
    ORR_OPTION_FORMAT_AS(
        "text|json", "text",
        .help = "The summary as text on standard error (default), or as JSON on standard output."),
    {.name = "method",
     .kind = ORR_OPT_CHOICE,
     .value = "default|literal",
     .help = "The method of smoothing. literal: the smoother as the dissertation has it (two-body prior in "
             "uniformly rotating axes, "
             "constant f0). The options below change one setting of the chosen method."},
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = "gcrs|uniform",
     .help = "Axes in which the orbit is integrated."},
    {.name = "gravity",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 2190,
     .help =
         "Degree of the gravity field; 0 is the central term alone. 8 by default, 21 for low orbits, below "
         "15000 km of radius: the built-in field, EGM96, ends there. With --gravity-model the degree to "
         "which that is summed for low orbits, 60 by default; the others keep 8."},
    {.name = "gravity-model",
     .kind = ORR_OPT_TEXT,
     .value = "NAME",
     .help = "Gravity field of low orbits, in GeographicLib's format: NAME.egm and NAME.egm.cof, as egm96 or "
             "egm2008, which geographiclib-get-gravity fetches."},
    {.name = "gravity-folder",
     .applies = "gravity-model",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where the gravity model's files are; GeographicLib's own folder by default."},
    {.name = "sun-moon",
     .kind = ORR_OPT_CHOICE,
     .value = "yes|no",
     .help = "Attraction of the Sun and the Moon."},
    {.name = "srp",
     .kind = ORR_OPT_REAL,
     .value = "A",
     .min = -1e-6,
     .max = 1e-6,
     .help = "Acceleration by radiation pressure at 1 au, m/s2."},
    {.name = "f0",
     .kind = ORR_OPT_CHOICE,
     .value = "rtn|inertial|ecef",
     .help = "Axes of the empirical acceleration."},
    {.name = "qf",
     .kind = ORR_OPT_REAL,
     .value = "Q",
     .min = 0,
     .max = 1,
     .help = "Random walk of the empirical acceleration, m2/s5; 0 keeps it constant. By default it is chosen "
             "for low orbits, below 15000 km of radius, by likelihood."},
    {.name = "qv",
     .kind = ORR_OPT_REAL,
     .value = "Q",
     .min = 0,
     .max = 1,
     .help = "White noise of acceleration, m2/s3."},
    {.name = "sigma",
     .kind = ORR_OPT_REAL,
     .value = "M",
     .min = 1e-6,
     .max = 1e4,
     .help = "Standard deviation of a node's coordinate, m."},
    {.name = "passes",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 8,
     .help = "Number of linearisations; 0: until converged."},
    {.name = "detect",
     .kind = ORR_OPT_CHOICE,
     .value = "yes|no",
     .help = "Find outliers and manoeuvres by innovation. Flags of the input are always respected."},
};

static bool says(const orr_cli *c, const char *option, const char *word, bool otherwise)
{
    const char *text = orr_cli_text(c, option, NULL);
    return text != NULL ? strcmp(text, word) == 0 : otherwise;
}

static void smoother_options(const orr_cli *c, orr_smoother_options *o)
{
    const int jobs = o->jobs;
    *o = says(c, "method", "literal", false) ? orr_smoother_literal() : orr_smoother_defaults();
    if (orr_cli_given(c, "frame")) o->frame = says(c, "frame", "gcrs", true) ? ORR_SKY_GCRS : ORR_SKY_UNIFORM;
    if (!orr_cli_given(c, "gravity-model")) {
        o->gravity_degree = (int)orr_cli_int(c, "gravity", o->gravity_degree);
        o->low_gravity_degree = (int)orr_cli_int(c, "gravity", o->low_gravity_degree);
    }
    o->sun_moon = says(c, "sun-moon", "yes", o->sun_moon);
    o->srp_mps2 = orr_cli_real(c, "srp", o->srp_mps2);
    if (orr_cli_given(c, "f0"))
        o->f0_axes = says(c, "f0", "rtn", true)    ? ORR_F0_RTN
                     : says(c, "f0", "ecef", true) ? ORR_F0_ECEF
                                                   : ORR_F0_INERTIAL;
    o->qf_m2ps5 = orr_cli_real(c, "qf", o->qf_m2ps5);
    o->plain.qf_m2ps5 = orr_cli_real(c, "qf", o->plain.qf_m2ps5);
    if (orr_cli_given(c, "qf")) o->plain.choose_qf = false;
    o->plain.qv_m2ps3 = orr_cli_real(c, "qv", o->plain.qv_m2ps3);
    o->sigma_m = orr_cli_real(c, "sigma", o->sigma_m);
    o->plain.sigma_m = orr_cli_real(c, "sigma", o->plain.sigma_m);
    o->passes = (int)orr_cli_int(c, "passes", o->passes);
    o->detect = says(c, "detect", "yes", o->detect);
    o->node_step_s = (double)orr_cli_duration_ns(c, "nodes", 0) * 1e-9;
    o->max_gap_s = (double)orr_cli_duration_ns(c, "max-gap", (int64_t)(o->max_gap_s * 1e9)) * 1e-9;
    o->clock_gap_s = (double)orr_cli_duration_ns(c, "clock-gap", (int64_t)(o->clock_gap_s * 1e9)) * 1e-9;
    o->clock_remove_reference = says(c, "reference-clock", "remove", false);
    o->sats = orr_cli_sats(c, "sat");
    o->bridge = orr_cli_given(c, "bridge");
    o->extend_to = orr_cli_time(c, "extend-to", ORR_TIME_NONE);
    o->jobs = (int)orr_cli_int(c, "jobs", jobs);
}

// Everything that a plan borrows besides the command line.
typedef struct lists {
    const char **erp, **nav, **clk;
    orr_interval *exclude;
    const char *sp3[2]; // in newest
    orr_newest newest;
    char folder[4096]; // of the output
} lists;

// What --predict and --now ask for; without files to start from, those of the cache.
static orr_status plan_prediction(const orr_cli *c, lists *l, orr_orbit_plan *plan, orr_diag *diag)
{
    const bool now = orr_cli_given(c, "now");
    plan->predict = now || orr_cli_given(c, "predict");
    plan->predict_s = (double)orr_cli_duration_ns(c, "predict", USUAL_BEYOND_NOW_NS) * 1e-9;
    if (!now) return ORR_OK;
    plan->predict_after = orr_cli_given(c, "present") ? orr_cli_time(c, "present", 0) : orr_present();
    if (plan->n_sp3 > 0) return ORR_OK;
    char cache[ORR_NEWEST_PATH / 2];
    if (!orr_fetch_default_cache(cache, sizeof cache))
        return orr_diag_set(diag, ORR_E_NODATA, "there is no cache folder ($ORRERY_CACHE): name SP3 files");
    const orr_status s = orr_newest_find(cache, plan->predict_after, &l->newest, diag);
    for (size_t i = 0; i < l->newest.n; i++) l->sp3[i] = l->newest.path[i];
    plan->sp3 = l->sp3;
    plan->n_sp3 = l->newest.n;
    return s;
}

static orr_status make_plan(const orr_cli *c, lists *l, orr_orbit_plan *plan, orr_diag *diag)
{
    *plan = orr_orbit_plan_default();
    plan->leap = c->leap;
    smoother_options(c, &plan->smoother);
    plan->sp3 = (const char *const *)c->operand;
    plan->n_sp3 = (size_t)c->n_operands;
    l->erp = orr_cli_texts(c, "erp", &plan->n_erp);
    l->nav = orr_cli_texts(c, "nav", &plan->n_nav);
    l->clk = orr_cli_texts(c, "clk", &plan->n_clk);
    const size_t n = orr_cli_count(c, "exclude");
    l->exclude = calloc(n + 1, sizeof *l->exclude);
    if (l->erp == NULL || l->nav == NULL || l->clk == NULL || l->exclude == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for lists of options");
    for (size_t i = 0; i < n; i++) {
        orr_interval *x = &l->exclude[i];
        orr_cli_interval_at(c, "exclude", i, &x->from, &x->to);
        if (x->to == x->from) x->to++; // an interval holds its begin and not its end
    }
    plan->gravity_model = orr_cli_text(c, "gravity-model", NULL);
    plan->gravity_dir = orr_cli_text(c, "gravity-folder", NULL);
    plan->gravity_degree = (int)orr_cli_int(c, "gravity", MODEL_DEGREE);
    plan->folder = orr_folder_name(orr_cli_text(c, "output", ""), l->folder, sizeof l->folder);
    plan->erp = l->erp;
    plan->nav = l->nav;
    plan->clk = l->clk;
    plan->smoother.exclude = l->exclude;
    plan->smoother.n_exclude = n;
    return plan_prediction(c, l, plan, diag);
}

static int run(orr_cli *c)
{
    lists l = {0};
    orr_orbit_plan plan;
    orr_orbit_made made = {0};
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    if (c->n_operands == 0 && !orr_cli_given(c, "now")) return orr_cli_usage(c, "SP3... is needed");
    if (orr_cli_given(c, "extend-to") && (orr_cli_given(c, "now") || orr_cli_given(c, "predict")))
        return orr_cli_usage(
            c, "--extend-to goes on by broadcast ephemerides, --predict and --now by themselves: one of "
               "them");
    if (!orr_cli_given(c, "gravity-model") && orr_cli_int(c, "gravity", 0) > ORR_GRAVITY_MAX_DEGREE)
        return orr_cli_usage(c,
                             "--gravity %d: the built-in field, EGM96, ends at degree %d; --gravity-model "
                             "names one that has more",
                             (int)orr_cli_int(c, "gravity", 0), ORR_GRAVITY_MAX_DEGREE);
    orr_status s = make_plan(c, &l, &plan, &diag);
    if (s == ORR_OK) s = orr_orbit_make(&plan, c->log, NULL, &made, &warnings, &diag);
    const double made_s = orr_monotonic_s();
    if (s == ORR_OK) s = orr_ephemeris_save(made.ephemeris, orr_cli_text(c, "output", NULL), c->call, &diag);
    const char *erp_out = orr_cli_text(c, "erp-out", NULL);
    if (s == ORR_OK && erp_out != NULL) s = orr_rotation_file_write(made.ephemeris, c->leap, erp_out, &diag);
    orr_cli_warnings(c, &warnings);
    int status = ORR_EXIT_OK;
    if (s == ORR_OK) {
        const orbit_seconds seconds = {made.read_s, made.smooth_s, made.fit_s, orr_monotonic_s() - made_s};
        status = orbit_summary_print(c, &made.solution, &made.report, made.ephemeris,
                                     plan.predict ? &made.prediction : NULL, &seconds);
    } else
        status = orr_cli_fail(c, &diag);
    orr_warnings_free(&warnings);
    orr_orbit_made_free(&made);
    free(l.erp);
    free(l.nav);
    free(l.clk);
    free(l.exclude);
    return status;
}

const orr_command orr_cmd_orbit = {
    .name = "orbit",
    .group = "Orbits",
    .summary = "smooth SP3 files into an orbit product",
    .operands = "SP3...",
    .min_operands = 0, // of --now
    .max_operands = -1,
    .about =
        "Files of consecutive days are smoothed jointly, in whatever order they are named. The product holds "
        "Chebyshev "
        "segments of position, clock nodes, standard deviations, flags, events and the names and SHA-256 of "
        "its inputs; "
        "'ncdump -h' shows how to evaluate it, 'orrery states' prints from it, 'orrery compare' judges "
        "it.\n\n"
        "The report on stderr lists manoeuvres, rejected positions and gaps, up to a number that a reader "
        "can take "
        "in. --format json has all of them. Its events have sat, kind, from and to; kind is manoeuvre "
        "(change_mps), "
        "outlier, "
        "jump (size_m) or gap. Its earth_rotation has xp_mas, yp_mas, lod_ms, pole_sigma_mas and used, as "
        "estimated "
        "from the orbits. Each of its systems has satellites, nodes, left_out, residual_rms_mm, manoeuvres, "
        "gaps and "
        "eclipses; day_jumps and seconds follow. Its clock_events have kind (wrong_value, jump, flagged, "
        "reference), sat "
        "or, of the reference clock, systems, from, to and value_ns.\n\n"
        "prediction (null without --predict and --now) has from, to, "
        "orbits, "
        "clocks, left_out, and, where the orbits tell it, earth_rotation at its begin.\n\n"
        "--now without files takes the newest ultra-rapid orbits of the fetch cache, and the same centre's "
        "of a day "
        "before.",
    .example = "orrery orbit -o day.nc COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz\n"
               "orrery orbit -o three-days.nc --nodes 900 --exclude 2024-02-04T12:00/2024-02-04T13:00 "
               "day1.sp3 day2.sp3 day3.sp3\n"
               "orrery orbit -o tomorrow.nc --predict 24h yesterday.sp3 today.sp3",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
