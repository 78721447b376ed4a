// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_faults.h"

#include <math.h>
#include <stdio.h>

#include "src/config/rows_private.h"
#include "src/config/section_channel.h"

// The keys that every fault begins with; `at` is the place of its orr_fault_when in the struct.
#define WHEN_ROWS(at)                                                                                        \
    {.name = "sats",                                                                                         \
     .kind = ORR_KEY_SATS,                                                                                   \
     .required = true,                                                                                       \
     .offset = (at) + offsetof(orr_fault_when, sats),                                                        \
     .help = "satellites that it befalls, e.g. G05,E"},                                                      \
        {.name = "from",                                                                                     \
         .kind = ORR_KEY_TIME,                                                                               \
         .required = true,                                                                                   \
         .offset = (at) + offsetof(orr_fault_when, from),                                                    \
         .help = "its begin, on a whole millisecond"},                                                       \
    {                                                                                                        \
        .name = "to", .kind = ORR_KEY_TIME, .offset = (at) + offsetof(orr_fault_when, to),                   \
        .given = (at) + offsetof(orr_fault_when, has_to),                                                    \
        .help = "its end, likewise: from then on all is as without it; default: the scenario's end"          \
    }
#define SIGNALS_ROW                                                                                          \
    {                                                                                                        \
        .name = "signals", .kind = ORR_KEY_TEXT, .list = true,                                               \
        .offset = offsetof(orr_fault_profile, signals),                                                      \
        .help = "signals that it befalls, as in `signals`; default: all"                                     \
    }
#define HOLD_ROW                                                                                             \
    {                                                                                                        \
        .name = "hold", .kind = ORR_KEY_TIME, .offset = offsetof(orr_fault_profile, hold),                   \
        .given = offsetof(orr_fault_profile, has_hold), .only = of_rate,                                     \
        .help = "when the ramp ends, on a whole millisecond; its value stays. Default: the fault's end"      \
    }
static const orr_condition of_rate[] = {{.key = "rate"}, {0}};

#define STEP_ROW(most, u, h) REAL_ROW(orr_fault_profile, "step", step, -(most), most, u, "0", NULL, h)
#define RATE_ROW(most, u, h) REAL_ROW(orr_fault_profile, "rate", rate, -(most), most, u, "0", NULL, h)

static const char *check_profile(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_fault_profile *p = map;
    if (orr_section_signals_check(&p->signals, why) != NULL) return "signals";
    if (p->step != 0 || p->rate != 0) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "has no effect without a step or a rate");
    return "";
}
#define PROFILE(rows)                                                                                        \
    {                                                                                                        \
        .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_fault_profile),                   \
        .check = check_profile                                                                               \
    }

static const orr_key range_rows[] = {
    WHEN_ROWS(0),
    SIGNALS_ROW,
    STEP_ROW(1e6, "m", "added to code and carrier at its begin"),
    RATE_ROW(1e4, "m/s", "by which it grows"),
    HOLD_ROW,
};
static const orr_key clock_rows[] = {
    WHEN_ROWS(0),
    STEP_ROW(1e-2, "s",
             "by which the satellite's clock is early from its begin: ranges are shorter by c times it"),
    RATE_ROW(1e-4, "s/s", "by which it grows"),
    HOLD_ROW,
};
static const orr_key divergence_rows[] = {
    WHEN_ROWS(0),
    SIGNALS_ROW,
    STEP_ROW(1e6, "m", "added to the code alone at its begin"),
    RATE_ROW(1e4, "m/s", "by which code and carrier diverge"),
    HOLD_ROW,
};
static const orr_key power_rows[] = {
    WHEN_ROWS(0),
    SIGNALS_ROW,
    STEP_ROW(60.0, "dB", "added to the power at its begin"),
    RATE_ROW(60.0, "dB/s", "by which it grows"),
    HOLD_ROW,
};
static const orr_schema range_table = PROFILE(range_rows), clock_table = PROFILE(clock_rows),
                        divergence_table = PROFILE(divergence_rows), power_table = PROFILE(power_rows);

static const orr_key noise_rows[] = {
    WHEN_ROWS(offsetof(orr_fault_noise, when)),
    {.name = "sigma",
     .kind = ORR_KEY_REAL,
     .list = true,
     .required = true,
     .offset = offsetof(orr_fault_noise, sigma_m),
     .min = 1e-6,
     .max = 1e4,
     .least = 1,
     .most = 2,
     .unit = "m",
     .help = "standard deviation of one or two processes, which are added to code and carrier"},
    {.name = "time",
     .kind = ORR_KEY_REAL,
     .list = true,
     .required = true,
     .offset = offsetof(orr_fault_noise, time_s),
     .min = 1,
     .max = 1e6,
     .least = 1,
     .most = 2,
     .unit = "s",
     .help = "their correlation times: exp(-t/time)"},
};
static const char *check_noise(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_fault_noise *x = map;
    if (x->sigma_m.n == x->time_s.n) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%zu correlation times for %zu standard deviations", x->time_s.n,
             x->sigma_m.n);
    return "time";
}
static const orr_schema noise_table = {.key = noise_rows,
                                       .n = sizeof noise_rows / sizeof noise_rows[0],
                                       .size = sizeof(orr_fault_noise),
                                       .check = check_noise};

static const orr_key sine_rows[] = {
    WHEN_ROWS(offsetof(orr_fault_sine, when)),
    NEEDED_REAL_ROW(orr_fault_sine, "amplitude", amplitude_m, 1e-6, 1e4, "m", NULL,
                    "of a sine that is added to code and carrier"),
    NEEDED_REAL_ROW(orr_fault_sine, "period", period_s, 1, 1e6, "s", NULL, "its period"),
    REAL_ROW(orr_fault_sine, "phase", phase_deg, -360, 360, "deg", "0", NULL,
             "its phase at the fault's begin"),
};
static const orr_schema sine_table = ORR_SCHEMA(sine_rows, orr_fault_sine);

static const orr_choice wrong[] = {ORR_FAULT_ORBITS(ORR_CHOICE_WORD){0}};
#define AXIS_ROW(n, m, h) REAL_ROW(orr_fault_orbit, n, m, -1e6, 1e6, "m", "0", NULL, h)
static const orr_key orbit_rows[] = {
    WHEN_ROWS(offsetof(orr_fault_orbit, when)),
    NEEDED_CHOICE_ROW(orr_fault_orbit, "wrong", wrong, wrong, NULL, "what is displaced"),
    AXIS_ROW("radial", radial_m, "displacement away from the Earth's centre"),
    AXIS_ROW("along", along_m, "displacement across the radius, in the orbit's plane, forward"),
    AXIS_ROW("cross", cross_m, "displacement along the orbit's normal"),
};
static const char *check_orbit(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_fault_orbit *o = map;
    if (o->radial_m != 0 || o->along_m != 0 || o->cross_m != 0) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "has no effect without radial, along or cross");
    return "";
}
static const orr_schema orbit_table = {.key = orbit_rows,
                                       .n = sizeof orbit_rows / sizeof orbit_rows[0],
                                       .size = sizeof(orr_fault_orbit),
                                       .check = check_orbit};

static const orr_key when_rows[] = {WHEN_ROWS(0)};
static const orr_schema when_table = ORR_SCHEMA(when_rows, orr_fault_when);

static const orr_key bits_rows[] = {
    WHEN_ROWS(offsetof(orr_fault_bits, when)),
    TEXT_ROW(orr_fault_bits, "message", message, NULL,
             "of this message alone: LNAV, CNAV, INAV, FNAV, D1, FDMA"),
    {.name = "piece",
     .kind = ORR_KEY_INT,
     .offset = offsetof(orr_fault_bits, piece),
     .given = offsetof(orr_fault_bits, has_piece),
     .min = 0,
     .max = 63,
     .help = "of these alone: number of the subframe (LNAV, D1) or string (FDMA), type of the word, page or "
             "message"},
    {.name = "bit",
     .kind = ORR_KEY_REAL,
     .list = true,
     .required = true,
     .offset = offsetof(orr_fault_bits, bit),
     .min = 1,
     .max = 1800,
     .least = 1,
     .most = 2,
     .help = "the first and the last that are inverted, from 1 in the order of sending; one alone is both"},
};
static const char *check_bits(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_fault_bits *o = map;
    const double first = o->bit.item[0], last = o->bit.item[o->bit.n - 1];
    if (first <= last && !(floor(first) < first) && !(floor(last) < last)) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "whole numbers, the first not after the last");
    return "bit";
}
static const orr_schema bits_table = {.key = bits_rows,
                                      .n = sizeof bits_rows / sizeof bits_rows[0],
                                      .size = sizeof(orr_fault_bits),
                                      .check = check_bits};

#define FAULTS_ROW(n, m, table, h) MAPS_ROW(orr_scenario_faults, n, m, table, 1000, NULL, h)
static const orr_key rows[] = {
    INT_ROW(orr_scenario_faults, "seed", seed, 0, 9e15, "1", NULL, "seed of noise"),
    FAULTS_ROW("range", range, &range_table, "steps and ramps of code and carrier"),
    FAULTS_ROW("clock", clock, &clock_table,
               "steps and ramps of satellites' clocks that messages do not know"),
    FAULTS_ROW("divergence", divergence, &divergence_table,
               "steps and ramps of the code against the carrier"),
    FAULTS_ROW("power", power, &power_table, "steps and ramps of received power"),
    FAULTS_ROW("noise", noise, &noise_table, "Gauss-Markov noise of the range"),
    FAULTS_ROW("sine", sine, &sine_table, "sines of the range"),
    FAULTS_ROW("orbit", orbit, &orbit_table, "displaced orbits"),
    FAULTS_ROW("off", off, &when_table, "satellites that send nothing, whatever word was being sent"),
    FAULTS_ROW("unhealthy", unhealthy, &when_table,
               "satellites that are marked as not to be used, in channels and, from their next frame on, in "
               "their messages"),
    FAULTS_ROW("stale", stale, &when_table,
               "satellites that go on with the broadcast data of the fault's begin"),
    FAULTS_ROW("bits", bits, &bits_table, "bits and words of messages that are sent inverted"),
};
const orr_schema orr_section_faults = ORR_SCHEMA(rows, orr_scenario_faults);
