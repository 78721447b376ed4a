// SPDX-License-Identifier: GPL-3.0-or-later
// orrery make-days: days of orbits from nothing, as SP3 files.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/parallel.h"
#include "src/archive/store.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/make/made_days.h"

static const orr_option options[] = {
    ORR_OPTION_FOLDER(.fills = true, .help = "Folder of the files, one a day; made if there is none."),
    ORR_OPTION_FROM(.required = true, .help = "First day, in GPS time; the orbits begin at its midnight."),
    ORR_OPTION_TO(.help = "Last day; the first one by default."),
    ORR_OPTION_SATS_AS(.help = "Satellites of G01-G27, R01-R27 and E01-E26, e.g. G05,R; all 80 by default."),
    ORR_OPTION_STEP(.help = "Time from one position to the next, whole seconds of which a day is a multiple; "
                            "15min by default."),
    {.name = "push",
     .kind = ORR_OPT_TEXT,
     .value = "SAT,T,MPS",
     .repeated = true,
     .help = "A manoeuvre: the satellite's speed changes by so many m/s at that instant, e.g. "
             "G05,2024-07-01T12:00:00,0.1."},
    ORR_OPTION_JOBS,
};

enum { MOST_PUSHES = 100 };

static int by_time(const void *a, const void *b)
{
    return orr_time_order(&((const orr_made_push *)a)->t, &((const orr_made_push *)b)->t);
}

// One value of --push.
static int read_push(const orr_cli *c, const char *text, orr_made_push *out)
{
    char word[64];
    double mps;
    const char *first = strchr(text, ','), *last = strrchr(text, ',');
    const bool parted = first != NULL && last > first && (size_t)(last - text) < sizeof word;
    if (parted) {
        snprintf(word, sizeof word, "%.*s", (int)(first - text), text);
        out->sat = orr_sat_parse(word);
        snprintf(word, sizeof word, "%.*s", (int)(last - first - 1), first + 1);
    }
    if (!parted || out->sat == ORR_SAT_NONE || orr_time_parse(word, c->leap, &out->t, NULL) != ORR_OK ||
        orr_cli_numbers(last + 1, &mps, 1) != 1)
        return orr_cli_usage(c, "--push \"%s\" is no SAT,T,MPS, e.g. G05,2024-07-01T12:00:00,0.1", text);
    out->along_mps = mps;
    return ORR_EXIT_OK;
}

typedef struct talk {
    const orr_cli *c;
    size_t days;
} talk;

static void tell(void *user, size_t n_done)
{
    const talk *t = user;
    orr_cli_progress(t->c, "days", n_done, t->days);
}

// The days of the call; no file of somebody else is in their way. An exit status.
static int read_plan(const orr_cli *c, orr_made_plan *p, orr_diag *diag)
{
    const int32_t first = orr_archive_day_of(orr_cli_time(c, "from", 0)),
                  last = orr_archive_day_of(orr_cli_time(c, "to", orr_cli_time(c, "from", 0)));
    if (last < first) return orr_cli_usage(c, "--to is before --from");
    if (last - first >= ORR_MADE_MOST_DAYS)
        return orr_cli_usage(c, "at most %d days are made", ORR_MADE_MOST_DAYS);
    p->from = orr_archive_day_begin(first);
    p->days = (size_t)(last - first) + 1;
    p->step_ns = orr_cli_duration_ns(c, "step", 900 * ORR_NS_PER_S);
    p->only = orr_cli_sats(c, "sat");
    p->jobs = (int)orr_cli_int(c, "jobs", orr_parallel_cores());
    p->folder = orr_cli_text(c, "output", NULL);
    orr_status s = orr_made_check(p, diag);
    if (s != ORR_OK) return orr_cli_usage(c, "%s", diag->text);
    for (size_t k = 0; k < p->days && s == ORR_OK; k++) {
        char path[ORR_MADE_PATH];
        s = orr_made_path(p, k, path, diag);
        if (s == ORR_OK) s = orr_cli_file_check(c, path, NULL, NULL, diag);
    }
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, diag);
}

static int run(orr_cli *c)
{
    orr_made_push push[MOST_PUSHES];
    orr_diag diag = {0};
    talk t = {.c = c};
    orr_made_plan p = {.push = push, .n_push = orr_cli_count(c, "push"), .done = tell, .user = &t};
    if (p.n_push > MOST_PUSHES) return orr_cli_usage(c, "at most %d manoeuvres are made", MOST_PUSHES);
    for (size_t k = 0; k < p.n_push; k++) {
        const int status = read_push(c, orr_cli_text_at(c, "push", k), &push[k]);
        if (status != ORR_EXIT_OK) return status;
    }
    qsort(push, p.n_push, sizeof push[0], by_time);
    const int status = read_plan(c, &p, &diag);
    if (status != ORR_EXIT_OK) return status;
    if (mkdir(p.folder, 0777) != 0 && errno != EEXIST)
        return orr_cli_failf(c, "%s: cannot be made: %s", p.folder, strerror(errno));
    t.days = p.days;
    if (orr_made_days(&p, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c, "%s: %zu day%s of made orbits", p.folder, p.days, p.days == 1 ? "" : "s");
    return ORR_EXIT_OK;
}

const orr_command orr_cmd_make_days = {
    .name = "make-days",
    .group = "Archive",
    .summary = "make days of SP3 files from nothing, for archives without real data",
    .about =
        "Satellites on circular orbits of the heights and inclinations of GPS, GLONASS and Galileo at the "
        "first "
        "midnight are "
        "integrated in inertial axes: the Earth's gravitation (EGM96 to degree 8), Sun and Moon, a constant "
        "radiation pressure of 1e-7 "
        "m/s2 with the Earth's shadow. The files are SP3-d, a day each, with the names of the IGS, and say "
        "that "
        "they are made. "
        "Two calls with the same first day make the same orbits, whatever else is asked; so a second folder "
        "with a shorter step "
        "is the truth between the positions of the first.\n\n"
        "They are good for what depends on dynamics and on many days: resonance, the Moon's and the Sun's "
        "periods in the elements, "
        "archives and batches of any length, tests and exercises. They say nothing of real satellites: no "
        "real "
        "positions or clocks, a plain radiation pressure, circular orbits to begin with, no noise but that "
        "of SP3's last "
        "millimetre, clocks that run evenly. "
        "How well real orbits are smoothed is to be seen on real files.",
    .example = "orrery make-days -o year --from 2024-01-01 --to 2024-12-31 --sat G05,R07\n"
               "orrery make-days -o truth --from 2024-01-01 --step 30s --push G05,2024-01-01T12:00:00,0.1\n"
               "orrery batch --archive archive --inputs year",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
