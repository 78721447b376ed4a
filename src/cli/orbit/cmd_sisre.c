// SPDX-License-Identifier: GPL-3.0-or-later
// orrery sisre: broadcast ephemerides against a precise orbit.
#include <stdio.h>
#include <stdlib.h>

#include "orbit/judge/sisre.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/make/inputs.h"

static void print_number(double x, const char *after)
{
    if (isfinite(x))
        printf("%.4f%s", x, after);
    else
        printf("null%s", after);
}

// What a run came to.
typedef struct findings {
    orr_sisre_sum sums[ORR_N_SYSTEMS];
    orr_sisre_sample *samples;
    size_t n;
    bool antex;
} findings;

static const char *const class_name[] = {"MEO", "IGSO", "GEO"};

// Sums of the kinds of orbits of one system; how many kinds there are.
static int split(const findings *f, char system, orr_sisre_sum kind[ORR_ORBIT_CLASSES])
{
    int kinds = 0;
    for (int k = 0; k < ORR_ORBIT_CLASSES; k++) {
        kind[k].n = 0;
        if (orr_sisre_sum_orbit(f->samples, f->n, system, (orr_orbit_class)k, 0, &kind[k]) == ORR_OK &&
            kind[k].n > 0)
            kinds++;
    }
    return kinds;
}

static void print_json_sum(const orr_sisre_sum *s)
{
    char worst[ORR_SAT_TEXT];
    printf("\"satellites\": %zu, \"n\": %zu, \"outliers\": %zu, \"antex\": %s, \"antennas\": %zu, "
           "\"radial_m\": ",
           s->n_sats, s->n, s->n_outliers, s->n_antennas == s->n_sats ? "true" : "false", s->n_antennas);
    print_number(s->radial_m, ", \"radial_mean_m\": ");
    print_number(s->radial_mean_m, ", \"along_m\": ");
    print_number(s->along_m, ", \"cross_m\": ");
    print_number(s->cross_m, ", \"orbit_3d_m\": ");
    print_number(s->orbit_3d_m, ", \"clock_m\": ");
    print_number(s->clock_m, ", \"sisre_m\": ");
    print_number(s->sisre_m, ", \"sisre_95_m\": ");
    print_number(s->sisre_95_m, ", ");
    printf("\"worst\": \"%s\", \"worst_3d_m\": %.4f", orr_sat_text(s->worst, worst), s->worst_m);
}

static void print_json(const findings *f)
{
    const char *comma = "";
    printf("{\"systems\": {");
    for (int k = 0; k < ORR_N_SYSTEMS; k++) {
        const orr_sisre_sum *s = &f->sums[k];
        orr_sisre_sum kind[ORR_ORBIT_CLASSES];
        if (s->n + s->n_outliers == 0) continue;
        printf("%s\n  \"%c\": {", comma, s->system);
        if (s->n > 0)
            print_json_sum(s);
        else
            printf("\"satellites\": 0, \"n\": 0, \"outliers\": %zu", s->n_outliers);
        if (split(f, s->system, kind) > 1) {
            const char *before = ", \"orbits\": {";
            for (int c = 0; c < ORR_ORBIT_CLASSES; c++) {
                if (kind[c].n == 0) continue;
                printf("%s\n    \"%s\": {", before, class_name[c]);
                print_json_sum(&kind[c]);
                printf("}");
                before = ",";
            }
            printf("}");
        }
        printf("}");
        comma = ",";
    }
    printf("\n}}\n");
}

static void print_row(const char *name, const orr_sisre_sum *s, bool antex)
{
    char worst[ORR_SAT_TEXT];
    printf("%-8s %5zu %8zu %7.2f %7.2f %7.2f %7.2f %7.2f ", name, s->n_sats, s->n, s->radial_mean_m,
           s->radial_m, s->along_m, s->cross_m, s->orbit_3d_m);
    if (isfinite(s->sisre_m))
        printf("%7.2f %7.2f %7.2f", s->clock_m, s->sisre_m, s->sisre_95_m);
    else
        printf("%7s %7s %7s", "-", "-", "-");
    printf("   %s %7.2f m %6zu", orr_sat_text(s->worst, worst), s->worst_m, s->n_outliers);
    if (antex) printf("   %zu of %zu", s->n_antennas, s->n_sats);
    printf("\n");
}

static void print_table(const findings *f)
{
    bool all_known = f->antex;
    printf("Broadcast minus precise, RMS in metres%s\n\n", f->antex ? " (phase centres by ANTEX)" : "");
    printf("                          radial\n");
    printf("system    sats  samples    mean     RMS   along   cross     3-D   clock   SISRE    95 %%   worst "
           "    "
           "    outliers%s\n",
           f->antex ? "   antennas" : "");
    for (int k = 0; k < ORR_N_SYSTEMS; k++) {
        const orr_sisre_sum *s = &f->sums[k];
        orr_sisre_sum kind[ORR_ORBIT_CLASSES];
        if (s->n == 0 && s->n_outliers > 0)
            printf("%-8s not one of %zu samples is near the precise orbit: are the names the same "
                   "satellites'?\n",
                   orr_system_name(s->system), s->n_outliers);
        if (s->n == 0) continue;
        print_row(orr_system_name(s->system), s, f->antex);
        all_known = all_known && s->n_antennas == s->n_sats;
        if (split(f, s->system, kind) < 2) continue;
        for (int c = 0; c < ORR_ORBIT_CLASSES; c++) {
            char name[16];
            snprintf(name, sizeof name, "  %s", class_name[c]);
            if (kind[c].n > 0) print_row(name, &kind[c], f->antex);
        }
    }
    if (!all_known)
        printf("\n%s the radial error holds the distance of the antenna from the centre of mass (0.5 to 3 m, "
               "with a minus sign).\n",
               f->antex ? "Where ANTEX knows no antenna" : "Without --antex");
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_nav nav = {0};
    orr_sp3 truth = {0};
    orr_antex antex = {0};
    orr_sisre_options o = {.choice = orr_broadcast_choice_default()};
    findings f = {0};
    const char *antex_path = orr_cli_text(c, "antex", NULL);
    o.choice.max_age_s = (double)orr_cli_duration_ns(c, "max-age", 0) * 1e-9;
    o.choice.causal = orr_cli_given(c, "causal");
    if (orr_cli_given(c, "message") &&
        orr_nav_messages_parse(orr_cli_text(c, "message", ""), &o.choice.messages, &diag) != ORR_OK)
        return orr_cli_usage(c, "--message: %s", diag.text);
    f.antex = antex_path != NULL;
    orr_nav_limits nav_limits = orr_nav_default_limits();
    orr_sp3_limits sp3_limits = orr_sp3_default_limits();
    nav_limits.leap = sp3_limits.leap = c->leap;
    orr_status s = orr_nav_read(c->operand[0], &nav_limits, &nav, &warnings, &diag);
    if (s == ORR_OK) s = orr_sp3_read(c->operand[1], &sp3_limits, &truth, &warnings, &diag);
    if (s == ORR_OK && antex_path != NULL) {
        s = orr_antex_read(antex_path, NULL, &antex, &warnings, &diag);
        o.antex = &antex;
    }
    if (s == ORR_OK) s = orr_sisre_run(&nav, &truth, &o, &f.samples, &f.n, f.sums, &diag);
    orr_cli_warnings(c, &warnings);
    if (s == ORR_OK && orr_cli_says(c, "format", "json")) print_json(&f);
    if (s == ORR_OK && !orr_cli_says(c, "format", "json")) print_table(&f);
    free(f.samples);
    orr_nav_free(&nav);
    orr_sp3_free(&truth);
    orr_antex_free(&antex);
    orr_warnings_free(&warnings);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_ANTEX(
            .help = "ANTEX file: brings the broadcast phase centre to the centre of mass that SP3 gives."),
    ORR_OPTION_MESSAGE(.applies = NULL),
    {.name = "causal",
     .kind = ORR_OPT_FLAG,
     .help = "Use only records transmitted by the instant, as a receiver has them."},
    {.name = "max-age",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help =
         "Longest |t - toe| of a record; by default what the systems' documents give (GPS 2 h, Galileo from "
         "half an hour before toe to 4 h after, BeiDou 1 h, GLONASS 18 min ...)."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_sisre = {
    .name = "sisre",
    .group = "Orbits",
    .summary = "judge broadcast ephemerides by a precise orbit",
    .operands = "NAV SP3",
    .min_operands = 2,
    .max_operands = 2,
    .about =
        "Evaluates the navigation file's best record for every satellite and epoch of the SP3 file and "
        "tells the errors "
        "along the radius, the track and across it, of the clock, and what of them a range sees (SISRE, "
        "Montenbruck et "
        "al. 2015).\n\n"
        "Clocks are compared after the system's median at each epoch is taken away. GLONASS is brought "
        "from the "
        "realisation of PZ-90 in force to ITRF. Systems with several kinds of orbits are told apart: medium "
        "(MEO), inclined geosynchronous (IGSO) and geostationary (GEO).",
    .example = "orrery sisre BRDC00IGS_R_20201770000_01D_MN.rnx.gz GRG0MGXFIN_20201770000_01D_15M_ORB.SP3.gz "
               "--antex igs20.atx",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
