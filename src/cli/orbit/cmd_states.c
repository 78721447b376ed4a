// SPDX-License-Identifier: GPL-3.0-or-later
// orrery states: a table of satellite states out of an orbit product.
#include <stdlib.h>
#include <string.h>

#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/states_write.h"

static const orr_option options[] = {
    ORR_OPTION_INSTANTS,
    ORR_OPTION_SATS,
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = "ecef|inertial",
     .fallback = "ecef",
     .applies = "format=csv|json",
     .help = "The axes. ecef (default): those of the orbits. inertial: of the GCRS (J2000), by the Earth "
             "rotation that "
             "the product holds."},
    ORR_OPTION_FORMAT("csv|sp3|json", "csv"),
    ORR_OPTION_OUTPUT,
};

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

static int write_states(orr_cli *c, const orr_products *p, const states_request *q)
{
    const bool json = orr_cli_says(c, "format", "json"), sp3 = orr_cli_says(c, "format", "sp3");
    states_count count = {0};
    orr_diag diag = {0};
    orr_status s =
        sp3 ? states_write_sp3(p, q, &count, &diag) : states_write_table(p, q, json, &count, &diag);
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
    .about = "Positions, velocities and clocks at evenly spaced instants; of several products, named in any "
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
               "orrery states day.nc --step 300 --format sp3 -o day.sp3",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
