// SPDX-License-Identifier: GPL-3.0-or-later
// orrery check: reads a scenario with all that it names, and says what it will do.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/cli/frame/cli.h"
#include "src/cli/scenario/replay_report.h"
#include "src/scenario/engine/engine.h"

static void print_span(const char *what, orr_span span)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    printf("%-14s %s to %s GPS\n", what, orr_time_text(span.from, from), orr_time_text(span.to, to));
}

static void print_parts(const orr_engine *e)
{
    static const char *const names[] = {"orbits", "broadcast data", "ionosphere", "motion", "channels"};
    static const char *const none[] = {"none: nothing is sent", NULL, "none: no ionospheric delays",
                                       "none: nothing moves", "none: no signals are named (signals)"};
    for (int part = ORR_PART_ORBITS; part <= ORR_PART_CHANNELS; part++) {
        orr_span span;
        if (orr_engine_part_span(e, (orr_engine_part)part, &span))
            print_span(names[part], span);
        else
            printf("%-14s %s\n", names[part],
                   part == ORR_PART_NAVDATA ? orr_engine_no_navdata(e) : none[part]);
    }
}

static void print_signals(const orr_channels *c)
{
    size_t n;
    const orr_signal *s = orr_signals(&n);
    printf("\nsignal   carrier MHz  chips/s    modulation        components  RINEX\n");
    for (size_t k = 0; k < n; k++) {
        char name[16];
        if ((orr_channels_signals(c) >> k & 1) == 0) continue;
        snprintf(name, sizeof name, "%c:%s", s[k].system, s[k].name);
        printf("%-8s %11.3f%s %-10.4g %-17s %-11s %s\n", name, s[k].carrier_hz / 1e6,
               s[k].channel_hz > 0 ? "+" : " ", s[k].chips_per_s, s[k].modulation, s[k].components,
               s[k].observation);
    }
}

// Satellites that an antenna sees at an instant, and of how many something is missing.
typedef struct view {
    size_t sats[ORR_N_SYSTEMS], all, channels;
    uint32_t flags;
} view;

static orr_answer look(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                       orr_channel *list, view *v)
{
    size_t n;
    orr_sat last = ORR_SAT_NONE;
    *v = (view){.all = 0};
    const orr_answer answer = orr_channels_at(c, antenna, work, t, UINT64_MAX, list, &n);
    for (size_t k = 0; k < n; k++) {
        v->flags |= list[k].flags;
        v->channels++;
        if (list[k].sat == last) continue;
        last = list[k].sat;
        v->sats[orr_sat_system_index(last)]++;
        v->all++;
    }
    return answer;
}

static void print_flags(uint32_t flags)
{
    static const struct {
        uint32_t flag;
        const char *words;
    } rows[] = {
        {ORR_CHANNEL_NO_ANTENNA,
         "ANTEX does not know the antenna of some satellites: their centre of mass sends"},
        {ORR_CHANNEL_NO_DELAY, "the bias file does not tell the group delay of some signals: zero is taken"},
        {ORR_CHANNEL_ZERO_CLOCK,
         "the orbits have no clock for some satellites: zero is taken (channel.clock_holes)"},
        {ORR_CHANNEL_NOMINAL_FREQUENCY, "frequency channels of some GLONASS satellites are the nominal ones "
                                        "of their slots (navdata.nav tells the true ones)"},
        {ORR_CHANNEL_FAST_TURN,
         "some satellites turn faster than the nominal attitude for a while (flagged)"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        if ((flags & rows[k].flag) != 0) printf("note: %s\n", rows[k].words);
}

// Thirteen instants over the span.
static int print_views(orr_cli *cli, const orr_channels *c, const orr_marks *marks)
{
    orr_channel *list = calloc(orr_channels_max(c), sizeof *list);
    uint32_t flags = 0;
    bool nothing = true;
    orr_channel_work *work = NULL;
    orr_diag diag = {0};
    if (list == NULL || orr_channel_work_open(c, &work, &diag) != ORR_OK) {
        free(list);
        return orr_cli_failf(cli, "out of memory");
    }
    for (size_t a = 0; a < orr_channels_antennas(c); a++) {
        const orr_antenna *antenna = orr_channels_antenna(c, a);
        const orr_span span = orr_channels_antenna_span(c, a);
        printf("\nantenna %zu, %s%s%s, %s: satellites in view\n%-25s", a, antenna->name,
               antenna->type[0] != '\0' ? ", " : "", antenna->type,
               antenna->motion != NULL ? "on the body" : "fixed", "time (GPS)");
        for (const char *s = ORR_SYSTEMS; *s != '\0'; s++) printf(" %3c", *s);
        printf("  all channels\n");
        for (int k = 0; k <= 12; k++) {
            view v;
            char text[ORR_TIME_TEXT];
            const orr_time t = orr_time_add(span.from, (span.to - span.from) / 12 * k);
            const orr_answer answer = look(c, a, work, t, list, &v);
            printf("%-25s", orr_time_format(t, ORR_SCALE_GPS, 0, NULL, text));
            if (answer != ORR_ANSWER_OK) {
                printf("  the antenna is not there then\n");
                continue;
            }
            for (int i = 0; i < ORR_N_SYSTEMS; i++) printf(" %3zu", v.sats[i]);
            printf(" %4zu %8zu\n", v.all, v.channels);
            flags |= v.flags;
            nothing = nothing && v.all == 0;
        }
    }
    free(list);
    orr_channel_work_close(work);
    print_flags(flags);
    if (!nothing) return ORR_EXIT_OK;
    (void)orr_marks_blame(marks, ORR_E_NODATA, "mask",
                          "no antenna ever sees a satellite (mask, satellites, the antennas' places)", &diag);
    return orr_cli_fail(cli, &diag);
}

static int run(orr_cli *c)
{
    orr_scenario s;
    orr_engine *e = NULL;
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    const char *path = c->operand[0];
    orr_status status = orr_scenario_read(path, c->leap, &s, &diag);
    if (status != ORR_OK) return orr_cli_fail(c, &diag);
    status = orr_engine_open(&s, c->log, NULL, &warnings, &e, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    if (status != ORR_OK) {
        orr_scenario_free(&s);
        return orr_cli_fail(c, &diag);
    }
    printf("%s: %s\n", path, orr_engine_title(e)[0] != '\0' ? orr_engine_title(e) : "no title");
    print_parts(e);
    int code = ORR_EXIT_OK;
    const orr_channels *channels = orr_engine_channels(e);
    const orr_replay_report *report;
    const orr_replay *replay = orr_engine_replay(e, &report);
    if (replay != NULL) {
        putchar('\n');
        orr_replay_report_text(stdout, replay, report);
    }
    if (channels != NULL) {
        print_signals(channels);
        code = print_views(c, channels, &s.marks);
    }
    orr_engine_close(e);
    orr_scenario_free(&s);
    return code;
}

const orr_command orr_cmd_check = {
    .name = "check",
    .group = "Scenarios",
    .summary = "read a scenario with all files that it names, and say what it will do",
    .operands = "SCENARIO",
    .min_operands = 1,
    .max_operands = 1,
    .about = "What the scenario has and when, the signals that are sent, how many satellites each antenna "
             "sees over time, and "
             "what is missing. Exit status 1, with line and path of the file, where something is wrong.",
    .example = "orrery check samples/gravimetry-flight.yaml",
    .run = run,
};
