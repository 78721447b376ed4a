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
    ORR_OPTION_FORMAT("csv|sp3|json", "csv"),
    ORR_OPTION_OUTPUT,
};

// The request's instants against the product's span: outside of it there is nothing to tell, and a table that
// silently stops short would be worse than none.
static bool span_holds(const orr_cli *c, const orr_ephemeris *e, const states_request *q)
{
    orr_time from, to;
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    orr_ephemeris_span(e, &from, &to);
    if (q->to < q->from) {
        orr_cli_usage(c, "--to is before --from");
        return false;
    }
    if (q->from >= from && q->to <= to) return true;
    orr_cli_failf(c, "%s covers %s to %s (GPS time), not all of what was asked", c->operand[0],
                  orr_time_text(from, a), orr_time_text(to, b));
    return false;
}

static bool has_satellites(const orr_cli *c, const orr_ephemeris *e, const orr_sat_set *wanted)
{
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list);
    for (size_t i = 0; i < n; i++)
        if (wanted == NULL || orr_sat_set_has(wanted, list[i])) return true;
    orr_cli_failf(c, "%s has none of the satellites %s", c->operand[0], orr_cli_text(c, "sat", ""));
    return false;
}

static int write_states(orr_cli *c, const orr_ephemeris *e, const states_request *q)
{
    const char *format = orr_cli_text(c, "format", "csv");
    states_count count = {0};
    orr_diag diag = {0};
    orr_status s = format[0] == 's' ? states_write_sp3(e, q, &count, &diag)
                                    : states_write_table(e, q, format[0] == 'j', &count, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (count.missing > 0)
        orr_cli_say(c, "%zu states; %zu times a satellite had no orbit at an instant and is left out",
                    count.written, count.missing);
    return ORR_EXIT_OK;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    if (orr_ephemeris_load(c->operand[0], &e, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    states_request q = {.product = c->operand[0], .path = orr_cli_text(c, "output", "-")};
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    q.from = orr_cli_time(c, "at", orr_cli_time(c, "from", from));
    q.to = orr_cli_time(c, "at", orr_cli_time(c, "to", to));
    q.step_ns = orr_cli_duration_ns(c, "step", 900 * ORR_NS_PER_S);
    q.sats = orr_cli_sats(c, "sat");
    int status = q.to < q.from ? ORR_EXIT_USAGE : ORR_EXIT_FAILED;
    if (span_holds(c, e, &q) && has_satellites(c, e, q.sats)) status = write_states(c, e, &q);
    orr_ephemeris_free(e);
    return status;
}

const orr_command orr_cmd_states = {
    .name = "states",
    .group = "Orbits",
    .summary = "print satellite states from an orbit product",
    .operands = "PRODUCT",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Positions, velocities (ecef) and clocks at evenly spaced instants. The CSV columns are t_gps, "
             "sat, x_m, y_m, "
             "z_m, vx_mps, vy_mps, vz_mps, clock_s, flags, sigma_m, clock_sigma_s; JSON has the same names, "
             "SP3 is version d with "
             "velocities. A "
             "satellite without an orbit at an instant has no row there, a clock that is not known is an "
             "empty field (null "
             "in JSON). clock_s is as SP3 has it: periodic relativity is not included. sigma_m (3-D) and "
             "clock_sigma_s are standard deviations against the orbit and the clock that the product's own "
             "input would give "
             "at that instant; empty where none is known.\n\n"
             "flags is a sum of: 1 clock is known, 2 predicted, 4 manoeuvre, 8 clock event, 16 eclipse, 32 "
             "gap between "
             "input nodes.",
    .example = "orrery states day.nc --from 2024-02-04T12:00 --to 2024-02-04T12:01 --step 0.1 --sat G05,E\n"
               "orrery states day.nc --step 300 --format sp3 -o day.sp3",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
