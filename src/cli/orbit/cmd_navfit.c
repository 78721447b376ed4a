// SPDX-License-Identifier: GPL-3.0-or-later
// orrery navfit: broadcast data that agree with a precise orbit.
#include <stdlib.h>
#include <string.h>

#include "orbit/navdata/almanac_text.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/navfit_write.h"
#include "src/make/navset.h"
#include "src/make/products.h"

// Everything that a run holds.
typedef struct work {
    orr_ephemeris *product;
    orr_navset *set;
    orr_inputs inputs;
} work;

static void work_free(work *w)
{
    orr_navset_free(w->set);
    orr_ephemeris_free(w->product);
    orr_inputs_free(&w->inputs);
}

static orr_status make(const orr_cli *c, work *w, orr_warnings *warnings, orr_diag *diag)
{
    orr_navset_plan plan = orr_navset_plan_default();
    const char **nav = orr_cli_texts(c, "nav", &plan.n_nav);
    if (nav == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of files");
    plan.nav = nav;
    plan.antex = orr_cli_text(c, "antex", NULL);
    plan.bias = orr_cli_text(c, "bias", NULL);
    plan.field = orr_cli_text(c, "field", NULL);
    plan.nequick = orr_cli_text(c, "nequick", NULL);
    plan.options.leap = w->inputs.leap = c->leap;
    plan.options.jobs = (int)orr_cli_int(c, "jobs", plan.options.jobs);
    plan.options.sats = orr_cli_sats(c, "sat");
    plan.options.zero_clocks = orr_cli_given(c, "zero-clocks");
    plan.options.window_s = strcmp(orr_cli_text(c, "window", "2h"), "4h") == 0 ? 14400 : 7200;
    const char *messages = orr_cli_text(c, "message", NULL);
    orr_status s = ORR_OK;
    if (messages != NULL) s = orr_nav_messages_parse(messages, &plan.options.messages, diag);
    if (s == ORR_OK) s = orr_inputs_note(&w->inputs, c->operand[0], diag);
    if (s == ORR_OK) s = orr_product_load(c->operand[0], &w->product, diag);
    if (s == ORR_OK) s = orr_navset_make(w->product, &plan, &w->set, &w->inputs, warnings, diag);
    free(nav);
    return s;
}

// Navigation file, frames of RTCM, almanacs of the day that holds `from`.
static orr_status write_records(const orr_cli *c, const work *w, orr_time from, orr_diag *diag)
{
    static const char *const almanacs[] = {[ORR_ALMANAC_YUMA] = "yuma", [ORR_ALMANAC_SEM] = "sem"};
    const char *rinex = orr_cli_text(c, "output", NULL), *rtcm = orr_cli_text(c, "rtcm", NULL);
    const bool four = orr_cli_says(c, "rinex", "4");
    orr_status s = ORR_OK;
    size_t n = 0;
    if (rinex != NULL) s = navfit_write_rinex(w->set, &w->inputs, four ? 4.02 : 3.05, rinex, &n, diag);
    if (s == ORR_OK && n > 0)
        orr_cli_say(c, "%s: RINEX 3.05 has no records of %zu sets (CNAV and its kin); --rinex 4 writes them",
                    rinex, n);
    if (s == ORR_OK && rtcm != NULL) {
        s = navfit_write_rtcm(w->set, c->leap, rtcm, &n, diag);
        if (s == ORR_OK) orr_cli_say(c, "%s: %zu messages", rtcm, n);
    }
    for (int k = ORR_ALMANAC_YUMA; k <= ORR_ALMANAC_SEM && s == ORR_OK; k++) {
        const char *path = orr_cli_text(c, almanacs[k], NULL);
        if (path == NULL) continue;
        s = orr_almanac_write(w->set, (orr_almanac_format)k, from, path, &n, diag);
        if (s == ORR_OK) orr_cli_say(c, "%s: almanacs of %zu satellites", path, n);
    }
    return s;
}

// How many outputs go to standard output.
static int to_stdout(const orr_cli *c)
{
    static const char *const outputs[] = {"output", "bits", "symbols", "rtcm", "yuma", "sem"};
    int n = orr_cli_says(c, "format", "json");
    for (size_t k = 0; k < sizeof outputs / sizeof *outputs; k++)
        n += strcmp(orr_cli_text(c, outputs[k], ""), "-") == 0;
    return n;
}

static orr_status write_outputs(const orr_cli *c, const work *w, orr_diag *diag)
{
    const char *bits = orr_cli_text(c, "bits", NULL), *symbols = orr_cli_text(c, "symbols", NULL);
    orr_time from, to;
    orr_ephemeris_span(w->product, &from, &to);
    from = orr_cli_time(c, "from", from);
    to = orr_cli_time(c, "to", to);
    orr_status s = write_records(c, w, from, diag);
    for (int coded = 0; coded < 2 && s == ORR_OK; coded++) {
        const char *path = coded ? symbols : bits;
        size_t n = 0;
        if (path == NULL) continue;
        s = navfit_write_bits(w->set, coded != 0, from, to, path, &n, diag);
        if (s == ORR_OK) orr_cli_say(c, "%s: %zu subframes, strings and pages", path, n);
    }
    return s;
}

static int run(orr_cli *c)
{
    const bool json = orr_cli_says(c, "format", "json");
    if (to_stdout(c) > 1)
        return orr_cli_usage(
            c, "only one of --output, --bits, --symbols, --rtcm, --yuma, --sem and --format json "
               "can go to standard output");
    if (orr_cli_given(c, "from") && orr_cli_given(c, "to") &&
        orr_cli_time(c, "to", 0) <= orr_cli_time(c, "from", 0))
        return orr_cli_usage(c, "--to is not after --from");
    work w = {0};
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_status s = make(c, &w, &warnings, &diag);
    if (s == ORR_OK) s = write_outputs(c, &w, &diag);
    orr_cli_warnings(c, &warnings);
    int status = ORR_EXIT_OK;
    if (s != ORR_OK)
        status = orr_cli_fail(c, &diag);
    else if (json)
        status = navfit_print_json(c, w.set, &w.inputs);
    else
        navfit_say(c, w.set);
    orr_warnings_free(&warnings);
    work_free(&w);
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_OUTPUT_AS(.help = "Write the sets as a RINEX navigation file."),
    {.name = "rinex",
     .kind = ORR_OPT_CHOICE,
     .applies = "output",
     .value = "3|4",
     .help =
         "Its version: 3.05 (default), which has no records of CNAV and its kin, or 4.02, which has all, and "
         "records of time offsets, Earth orientation and ionosphere."},
    {.writes = true,
     .name = "rtcm",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Write the sets as messages of RTCM 3 in the order of their transmission: 1019 (GPS), 1020 "
             "(GLONASS), "
             "1041 (NavIC), 1042 (BeiDou D1 and D2), 1044 (QZSS), 1045 (F/NAV), 1046 (I/NAV)."},
    {.writes = true,
     .name = "yuma",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Write the almanacs of GPS and QZSS (PRN 193 and on) of the day that holds --from as YUMA."},
    {.writes = true,
     .name = "sem",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Write the almanacs of GPS of that day as SEM."},
    {.writes = true,
     .name = "bits",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help =
         "Write what the satellites transmit, bit by bit, as CSV: t_gps (of the first bit), sat, message, "
         "signals (that carry it), number (of the subframe, string, word, message or page type), page (of "
         "subframes 4 "
         "and 5; GLONASS: frame of the superframe; Galileo: sub-frame of the frame), length_s, bits, hex "
         "(first bit highest)."},
    {.writes = true,
     .name = "symbols",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The same as the symbols that a modulator takes: error correction, interleaving and "
             "synchronisation are done. Secondary codes are the generator's."},
    ORR_OPTION_FROM(
            .applies = "bits|symbols|yuma|sem",
            .help = "First instant of the bits, day of the almanacs; the product's beginning by default."),
    ORR_OPTION_TO(.applies = "bits|symbols", .help = "End of the bits; the product's end by default."),
    {.name = "message",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Messages to make, e.g. LNAV,INAV,CNAV2,BCNAV1; all that satellites send by default. CNAV-2 and "
             "B-CNAV2 "
             "are both CNV2, as in RINEX 4."},
    {.name = "window",
     .kind = ORR_OPT_CHOICE,
     .value = "2h|4h",
     .help = "How much of the orbit a set of GPS LNAV, I/NAV or F/NAV describes. 2h (default) fits closest; "
             "4h is "
             "how long a receiver may use one set. New sets come as often either way."},
    ORR_OPTION_SATS_AS(.help = "Satellites, e.g. G05,R,E; all by default."),
    ORR_OPTION_ANTEX(
            .help = "ANTEX file: describe the antennas' phase centres (ionosphere-free). Without it the sets "
                    "describe the centres of mass, as 'orrery states' and the service do."),
    ORR_OPTION_BIAS(.help = "Bias-SINEX or DCB file: TGD and GLONASS' delta tau. Without it they are zero."),
    ORR_OPTION_NAV(.repeated = true, .help = "RINEX navigation file with GLONASS' frequency channels and "
                                             "Klobuchar's coefficients. Without "
                                             "it the nominal channels and coefficients of zero are sent."),
    {.name = "field",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "TEC field (IONEX, .ION or a navigation file): fit the coefficients of BDGIM and of GPS' and "
             "BeiDou's "
             "Klobuchar models to it "
             "where --nav has none."},
    {.name = "nequick",
     .kind = ORR_OPT_TEXT,
     .applies = "field",
     .value = "DIR",
     .help = "NeQuick-G's tables (ccir11.asc to ccir22.asc, modip.asc): fit its coefficients to the field "
             "too. Without them "
             "they are sent as zero."},
    {.name = "zero-clocks",
     .kind = ORR_OPT_FLAG,
     .help = "Send a clock of zero for satellites whose clock the product does not know. Without it they are "
             "left out."},
    ORR_OPTION_JOBS,
    ORR_OPTION_FORMAT_AS(
        "text|json", "text",
        .help =
            "The report as text on standard error (default), or with every set as JSON on standard output."),
};

const orr_command orr_cmd_navfit = {
    .name = "navfit",
    .group = "Orbits",
    .summary = "make broadcast ephemerides and their bits from an orbit product",
    .operands = "PRODUCT",
    .min_operands = 1,
    .max_operands = 1,
    .about =
        "Fits what navigation messages send of orbits and clocks to the precise orbit, rounds it as it is "
        "transmitted, and tells how far the rounded sets are from the orbit. A generator that modulates "
        "these data sends what agrees with its ranges.\n\n"
        "LNAV sets have toe at every even hour and are sent for two hours from toe less half a window "
        "on. GLONASS sets have t_b at 15 and 45 minutes of every hour of UTC and are sent for that half "
        "hour. Galileo's have toe at half past every hour and are sent for that hour, BeiDou's at every hour "
        "of BDT, QZSS' of GPS time; NavIC's at every even hour; SBAS' every four minutes. Where the orbit "
        "begins or ends within a window the set is fitted to the nearest full one (shifted). Around a "
        "manoeuvre sets are unhealthy.",
    .example =
        "orrery navfit day.nc -o day.rnx\n"
        "orrery navfit day.nc --bits bits.csv --from 2024-02-04T12:00 --to 2024-02-04T12:12:30 --sat G05,R07",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
