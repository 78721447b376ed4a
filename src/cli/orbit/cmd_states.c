// SPDX-License-Identifier: GPL-3.0-or-later
// orrery states: a table of satellite states out of an orbit product.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/states_write.h"
#include "src/make/long_name.h"

static const orr_option options[] = {
    ORR_OPTION_INSTANTS,
    ORR_OPTION_SATS,
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = "ecef|inertial",
     .fallback = "ecef",
     .applies = "format=csv|json|oem|netcdf",
     .help = "The axes. ecef (default): those of the orbits. inertial: of the GCRS (J2000), by the Earth "
             "rotation that "
             "the product holds."},
    ORR_OPTION_FORMAT_AS(
        "csv|sp3|json|clk|orbex|oem|netcdf", "csv",
        .help = "As csv (default) or json; sp3, version d with velocities; clk, RINEX clocks; orbex, "
                "attitude; oem, the Orbit Ephemeris Message of CCSDS; netcdf, with CF attributes."),
    {.name = "split",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .applies = "!at",
     .help = "A file for each stretch of that length, e.g. 1h, from midnight on: --output is a folder then, "
             "and the "
             "names are those of IGS, e.g. ORR0OPSFIN_20250801000_01H_10Z_ORB.SP3."},
    ORR_OPTION_OUTPUT,
};

// The forms, and how files of them are called.
static const struct {
    const char *name, *content, *suffix;
    orr_status (*write)(const orr_products *p, const states_request *q, states_count *count, orr_diag *diag);
} formats[] = {
    {"csv", "ORB", "CSV", NULL},
    {"json", "ORB", "JSON", NULL},
    {"sp3", "ORB", "SP3", states_write_sp3},
    {"clk", "CLK", "CLK", states_write_clk},
    {"orbex", "ATT", "OBX", states_write_orbex},
    {"oem", "ORB", "OEM", states_write_oem},
    {"netcdf", "ORB", "NC", states_write_netcdf},
};
enum { FORMATS = sizeof formats / sizeof formats[0], NAME = 1200 };

static size_t format_of(const orr_cli *c)
{
    size_t k = 0;
    while (k + 1 < FORMATS && !orr_cli_says(c, "format", formats[k].name)) k++;
    return k;
}

// The request's instants against the products' span: outside of it there is nothing to tell, and a table that
// silently stops short would be worse than none.
static bool span_holds(const orr_cli *c, const orr_products *p, const states_request *q)
{
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    if (q->to < q->from) {
        orr_cli_usage(c, "--to is before --from");
        return false;
    }
    if (q->from >= p->from && q->to <= p->to) return true;
    orr_cli_failf(c, "%s cover%s %s to %s (GPS time), not all of what was asked",
                  p->n > 1 ? "the products" : c->operand[0], p->n > 1 ? "" : "s", orr_time_text(p->from, a),
                  orr_time_text(p->to, b));
    return false;
}

static bool has_satellites(const orr_cli *c, const orr_products *p, const orr_sat_set *wanted)
{
    for (size_t i = 0; i < p->n_sats; i++)
        if (wanted == NULL || orr_sat_set_has(wanted, p->sat[i])) return true;
    orr_cli_failf(c, "%s has none of the satellites %s", c->operand[0], orr_cli_text(c, "sat", ""));
    return false;
}

static orr_status write_one(const orr_cli *c, const orr_products *p, const states_request *q,
                            states_count *count, orr_diag *diag)
{
    const size_t k = format_of(c);
    return formats[k].write != NULL
               ? formats[k].write(p, q, count, diag)
               : states_write_table(p, q, orr_cli_says(c, "format", "json"), count, diag);
}

static orr_status write_split(const orr_cli *c, const orr_products *p, const states_request *q,
                              states_count *count, orr_diag *diag)
{
    const int64_t length = orr_cli_duration_ns(c, "split", 0);
    const size_t k = format_of(c);
    char name[NAME], kind[32];
    if (mkdir(q->path, 0777) != 0 && errno != EEXIST)
        return orr_diag_at(diag, ORR_E_IO, q->path, 0, 0, "cannot be made: %s", strerror(errno));
    snprintf(kind, sizeof kind, "%s.%s", formats[k].content, formats[k].suffix);
    size_t n = 0;
    for (orr_time t = q->from; t <= q->to; n++) {
        states_request part = *q;
        const orr_time end = t - orr_floor_mod(t, length) + length;
        part.path = name;
        part.from = t;
        part.to = end - 1 < q->to ? end - 1 : q->to;
        orr_status s = orr_long_name(q->path, "OPS", t - orr_floor_mod(t, length), length, q->step_ns, kind,
                                     sizeof name, name, diag);
        if (s == ORR_OK) s = orr_cli_file_check(c, name, NULL, NULL, diag);
        if (s == ORR_OK) s = write_one(c, p, &part, count, diag);
        if (s != ORR_OK) return s;
        t += ((part.to - t) / q->step_ns + 1) * q->step_ns;
    }
    orr_cli_say(c, "%s: %zu file%s", q->path, n, n == 1 ? "" : "s");
    return ORR_OK;
}

static int write_states(orr_cli *c, const orr_products *p, const states_request *q)
{
    states_count count = {0};
    orr_diag diag = {0};
    const bool split = orr_cli_given(c, "split"), file = strcmp(q->path, "-") != 0;
    if (split && !file) return orr_cli_usage(c, "--split fills a folder: --output DIR");
    if (orr_cli_says(c, "format", "netcdf") && !file)
        return orr_cli_usage(c, "NetCDF is not written to standard output: --output FILE");
    const orr_status s = split ? write_split(c, p, q, &count, &diag) : write_one(c, p, q, &count, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (count.missing > 0)
        orr_cli_say(c, "%zu states; %zu times a satellite had no orbit at an instant and is left out",
                    count.written, count.missing);
    return ORR_EXIT_OK;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_products p;
    orr_status s =
        orr_products_open((const char *const *)c->operand, (size_t)c->n_operands, &p, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    int status = ORR_EXIT_FAILED;
    if (s == ORR_OK) {
        states_request q = {.product = c->operand[0],
                            .path = orr_cli_text(c, "output", "-"),
                            .from = orr_cli_time(c, "at", orr_cli_time(c, "from", p.from)),
                            .to = orr_cli_time(c, "at", orr_cli_time(c, "to", p.to)),
                            .step_ns = orr_cli_duration_ns(c, "step", 900 * ORR_NS_PER_S),
                            .sats = orr_cli_sats(c, "sat"),
                            .inertial = orr_cli_says(c, "frame", "inertial")};
        if (q.to < q.from) status = ORR_EXIT_USAGE;
        if (span_holds(c, &p, &q) && has_satellites(c, &p, q.sats)) status = write_states(c, &p, &q);
    } else
        orr_cli_fail(c, &diag);
    orr_products_free(&p);
    return status;
}

const orr_command orr_cmd_states = {
    .name = "states",
    .group = "Orbits",
    .summary = "print satellite states from an orbit product",
    .operands = "PRODUCT...",
    .min_operands = 1,
    .max_operands = -1,
    .about = "Positions, velocities and clocks at evenly spaced instants, or the satellites' attitude; of "
             "several products, named in any "
             "order, as of one. The CSV columns are t_gps, "
             "sat, x_m, y_m, "
             "z_m, vx_mps, vy_mps, vz_mps, clock_s, flags, sigma_m (of the position, 3-D), clock_sigma_s, "
             "sigma_radial_m, sigma_along_m, sigma_cross_m, sigma_mps; "
             "JSON has "
             "the same names, SP3 is version d with "
             "velocities. A "
             "satellite without an orbit at an instant has no row there, a clock that is not known is an "
             "empty field (null "
             "in JSON). clock_s is as SP3 has it: periodic relativity is not included. sigma_m (3-D) and "
             "clock_sigma_s are standard deviations against the orbit and the clock that the product's own "
             "input would give "
             "at that instant, whose own errors they do not hold; sigma_radial_m, sigma_along_m and "
             "sigma_cross_m are its parts, sigma_mps is that of the velocity; empty where none is known.\n\n"
             "flags is a sum of: 1 clock is known, 2 predicted, 4 manoeuvre, 8 clock event, 16 eclipse, 32 "
             "gap between "
             "input nodes, 64 between the orbits of two files that do not meet, 128 orbits of a file that "
             "are noisier near the Earth's shadow.",
    .example = "orrery states day.nc --from 2024-02-04T12:00 --to 2024-02-04T12:01 --step 0.1 --sat G05,E\n"
               "orrery states day.nc --step 300 --format sp3 -o day.sp3\n"
               "orrery states day.nc --step 0.1 --format sp3 --split 1h -o hours",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
