// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll: the command-line client of a service.
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "src/cli/cli.h"
#include "src/cli/poll_delays.h"
#include "src/cli/poll_motion.h"
#include "src/service/dial.h"

typedef struct poll_job {
    orr_cli *c;
    orr_dial *d;
    bool json;
    orr_time t;
    int64_t step_ns, count; // count < 0: until interrupted
    orr_msg_sat_id id[ORR_MSG_MAX_SATELLITES];
    uint16_t n_ids; // 0: all
    char frame[65];
    uint64_t numbers; // satellites that had a state
    bool outside;     // an epoch was outside the span
    bool delays;      // ask for delays instead of states
    orr_delay_poll delay;
    orr_motion_poll motion; // or inertial increments, or the true motion
} poll_job;

static const char *sat_name(orr_msg_sat_id id, char buf[8])
{
    snprintf(buf, 8, "%c%02u", id.system >= ' ' && id.system <= '~' ? id.system : '?', (unsigned)id.number);
    return buf;
}

static const char *answer_text(uint8_t answer)
{
    switch (answer) {
    case ORR_MSG_ANSWER_OK:
        return "ok";
    case ORR_MSG_ANSWER_OUTSIDE_SPAN:
        return "outside the served span";
    case ORR_MSG_ANSWER_NO_ARC:
        return "no valid arc";
    case ORR_MSG_ANSWER_NOT_SERVED:
        return "not served";
    default:
        return "unknown answer";
    }
}

// --- JSON: one object a line and epoch (docs/protocol.md) ---

static json_t *json_number(double v) { return isfinite(v) ? json_real(v) : json_null(); }

static json_t *json_vector(const double v[3])
{
    json_t *a = json_array();
    for (int k = 0; k < 3; k++) json_array_append_new(a, json_number(v[k]));
    return a;
}

static json_t *json_time(orr_time t)
{
    char text[ORR_TIME_TEXT];
    return t == ORR_TIME_NONE ? json_null() : json_string(orr_time_text(t, text));
}

static json_t *json_name(const char *name) { return name != NULL ? json_string(name) : json_null(); }

static json_t *json_sat(const orr_msg_sat_state *s)
{
    char name[8];
    json_t *j = json_object();
    json_object_set_new(j, "sat", json_string(sat_name(s->sat, name)));
    json_object_set_new(j, "answer", json_name(orr_msg_answer_name(s->answer)));
    if (s->answer != ORR_MSG_ANSWER_OK) return j;
    json_t *flags = json_array();
    for (unsigned bit = 0; bit < 32; bit++)
        if ((s->flags >> bit & 1u) != 0 && orr_msg_state_flags_name(bit) != NULL)
            json_array_append_new(flags, json_string(orr_msg_state_flags_name(bit)));
    json_object_set_new(j, "flags", flags);
    json_object_set_new(j, "pos_m", json_vector(s->pos_m));
    json_object_set_new(j, "vel_mps", json_vector(s->vel_mps));
    json_object_set_new(j, "acc_mps2", json_vector(s->acc_mps2));
    json_object_set_new(j, "clock_s", json_number(s->clock_s));
    json_object_set_new(j, "clock_rate_sps", json_number(s->clock_rate_sps));
    json_object_set_new(j, "sigma_m", json_number((double)s->sigma_m));
    json_object_set_new(j, "valid_from", json_time(s->valid_from));
    json_object_set_new(j, "valid_to", json_time(s->valid_to));
    return j;
}

static void print_json(const orr_msg_states *m)
{
    json_t *j = json_object(), *sats = json_array();
    json_object_set_new(j, "t", json_time(m->t));
    json_object_set_new(j, "answer", json_name(orr_msg_answer_name(m->answer)));
    orr_msg_sat_state s;
    orr_wire_iter it = {0};
    while (orr_msg_sat_state_next(&m->satellites, &it, &s)) json_array_append_new(sats, json_sat(&s));
    json_object_set_new(j, "satellites", sats);
    json_dumpf(j, stdout, JSON_COMPACT | JSON_REAL_PRECISION(17));
    putchar('\n');
    json_decref(j);
}

// --- Table ---

static void print_flags(uint32_t flags)
{
    static const char *const word[] = {NULL, "predicted", "manoeuvre", "clock event", "eclipse", "gap"};
    const char *between = " ";
    for (unsigned bit = 1; bit < sizeof word / sizeof word[0]; bit++) {
        if ((flags >> bit & 1u) == 0) continue;
        printf("%s %s", between, word[bit]);
        between = ",";
    }
}

static void print_table(const poll_job *p, const orr_msg_states *m)
{
    char text[ORR_TIME_TEXT], name[8];
    printf("%s GPS", orr_time_text(m->t, text));
    if (m->answer != ORR_MSG_ANSWER_OK) {
        printf("  %s\n", answer_text(m->answer));
        return;
    }
    printf("  %u satellites, %s\n", (unsigned)m->satellites.count, p->frame);
    printf("%-3s %15s %15s %15s %11s %11s %11s %14s %6s\n", "sat", "x m", "y m", "z m", "vx m/s", "vy m/s",
           "vz m/s", "clock us", "mm");
    orr_msg_sat_state s;
    orr_wire_iter it = {0};
    while (orr_msg_sat_state_next(&m->satellites, &it, &s)) {
        printf("%-3s", sat_name(s.sat, name));
        if (s.answer != ORR_MSG_ANSWER_OK) {
            printf("  %s\n", answer_text(s.answer));
            continue;
        }
        printf(" %15.4f %15.4f %15.4f %11.5f %11.5f %11.5f", s.pos_m[0], s.pos_m[1], s.pos_m[2], s.vel_mps[0],
               s.vel_mps[1], s.vel_mps[2]);
        if ((s.flags & ORR_MSG_STATE_FLAGS_CLOCK_VALID) != 0)
            printf(" %14.6f", 1e6 * s.clock_s);
        else
            printf(" %14s", "-");
        printf(" %6.1f", 1e3 * (double)s.sigma_m);
        print_flags(s.flags);
        putchar('\n');
    }
}

// --- Asking ---

static orr_status receive(poll_job *p, uint32_t count, orr_diag *diag)
{
    for (uint32_t k = 0; k < count; k++) {
        orr_msg_states m;
        orr_wire_status ws = orr_client_states(&p->d->client, &m);
        if (ws == ORR_WIRE_OK && (m.index != k || m.count != count)) ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) return orr_dial_status(p->d, ws, "POLL", diag);
        p->outside = p->outside || m.answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_sat_state s;
        orr_wire_iter it = {0};
        while (orr_msg_sat_state_next(&m.satellites, &it, &s)) p->numbers += s.answer == ORR_MSG_ANSWER_OK;
        if (p->json)
            print_json(&m);
        else
            print_table(p, &m);
    }
    return ORR_OK;
}

static orr_status ask(poll_job *p, orr_time t, uint32_t count, orr_diag *diag)
{
    if (p->motion.imu || p->motion.truth) {
        orr_status s = orr_motion_poll_run(&p->motion, p->d, t, p->step_ns, count, diag);
        p->numbers = p->motion.numbers;
        p->outside = p->motion.outside;
        return s;
    }
    if (p->delays) {
        p->delay.poll.step = p->step_ns;
        p->delay.poll.satellites.count = p->n_ids;
        p->delay.poll.satellites.item = p->id;
        orr_status s = orr_delay_poll_run(&p->delay, p->d, t, count, diag);
        p->numbers = p->delay.numbers;
        p->outside = p->delay.outside;
        return s;
    }
    orr_msg_poll poll = {
        .t = t, .step = p->step_ns, .count = count, .satellites = {.count = p->n_ids, .item = p->id}};
    orr_wire_status ws = orr_client_poll(&p->d->client, &poll);
    return ws == ORR_WIRE_OK ? receive(p, count, diag) : orr_dial_status(p->d, ws, "POLL", diag);
}

// As many epochs a request as the server allows.
static orr_status ask_all(poll_job *p, uint32_t most, orr_diag *diag)
{
    orr_time t = p->t;
    for (int64_t left = p->count; left > 0;) {
        uint32_t n = left > (int64_t)most ? most : (uint32_t)left;
        orr_status s = ask(p, t, n, diag);
        if (s != ORR_OK) return s;
        left -= n;
        t += p->step_ns * (int64_t)n;
    }
    return ORR_OK;
}

// One epoch a step of the clock on the wall, as a signal generator does. Late polls are not dropped.
static orr_status ask_in_real_time(poll_job *p, orr_diag *diag)
{
    struct timespec next;
    clock_gettime(CLOCK_MONOTONIC, &next);
    for (int64_t k = 0; p->count < 0 || k < p->count; k++) {
        orr_status s = ask(p, p->t + k * p->step_ns, 1, diag);
        if (s != ORR_OK) return s;
        if (p->outside && p->count < 0) return ORR_OK;
        fflush(stdout);
        int64_t ns = next.tv_nsec + p->step_ns % ORR_NS_PER_S;
        next.tv_sec += (time_t)(p->step_ns / ORR_NS_PER_S + ns / ORR_NS_PER_S);
        next.tv_nsec = (long)(ns % ORR_NS_PER_S);
        if (p->count < 0 || k + 1 < p->count) clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, NULL);
    }
    return ORR_OK;
}

// A user's list as the wire's: of a whole system those served; satellites named one by one as they are, so
// that the server says of each what it lacks.
static int choose_sats(poll_job *p, const orr_msg_caps *caps)
{
    const orr_sat_set *set = orr_cli_sats(p->c, "sat");
    if (set == NULL) return ORR_EXIT_OK;
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        int asked = 0;
        for (int n = 1; n <= 99; n++) asked += orr_sat_set_has(set, orr_sat_make(*system, n));
        if (asked == 99) {
            orr_msg_sat_id id;
            orr_wire_iter it = {0};
            while (orr_msg_sat_id_next(&caps->satellites, &it, &id))
                if (id.system == (uint8_t)*system && p->n_ids < ORR_MSG_MAX_SATELLITES)
                    p->id[p->n_ids++] = id;
            continue;
        }
        for (int n = 1; n <= 99 && p->n_ids < ORR_MSG_MAX_SATELLITES; n++)
            if (orr_sat_set_has(set, orr_sat_make(*system, n)))
                p->id[p->n_ids++] = (orr_msg_sat_id){(uint8_t)*system, (uint8_t)n};
    }
    return p->n_ids > 0 ? ORR_EXIT_OK : orr_cli_failf(p->c, "%s serves none of these satellites", p->d->url);
}

static int poll_service(poll_job *p)
{
    orr_cli *c = p->c;
    orr_diag diag = {0};
    orr_msg_caps caps;
    orr_wire_status ws = orr_client_hello(&p->d->client, "orrery poll", ORR_VERSION, &caps);
    if (ws != ORR_WIRE_OK) {
        (void)orr_dial_status(p->d, ws, "HELLO", &diag);
        return orr_cli_fail(c, &diag);
    }
    orr_wire_text_copy(caps.frame, p->frame, sizeof p->frame);
    p->t = orr_cli_time(c, "at", caps.span_from);
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_time_text(caps.span_from, from);
    orr_time_text(caps.span_to, to);
    uint32_t most = caps.max_epochs > 0 ? caps.max_epochs : 1;
    int status = choose_sats(p, &caps); // the caps are the buffer's until the next request
    if (status != ORR_EXIT_OK) return status;
    orr_status s = orr_cli_given(c, "realtime") ? ask_in_real_time(p, &diag) : ask_all(p, most, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (p->numbers > 0) return ORR_EXIT_OK;
    if (p->motion.imu || p->motion.truth) return orr_cli_failf(c, "the trajectory does not reach there");
    if (p->outside) return orr_cli_failf(c, "nothing there: %s serves %s to %s", p->d->url, from, to);
    return orr_cli_failf(c, p->delays ? "no satellite has a delay there" : "no satellite has a state there");
}

static int run(orr_cli *c)
{
    bool realtime = orr_cli_given(c, "realtime");
    poll_job p = {.c = c,
                  .json = orr_cli_given(c, "json"),
                  .step_ns = orr_cli_duration_ns(c, "step", ORR_NS_PER_S),
                  .count = orr_cli_int(c, "count", realtime ? -1 : 1)};
    if (p.count > 1 && !orr_cli_given(c, "step") && !orr_cli_given(c, "imu"))
        return orr_cli_usage(c, "--count %lld needs a --step", (long long)p.count);
    p.delays = orr_cli_given(c, "delays");
    p.delay.json = p.json;
    int asked = orr_delay_poll_ask(c, &p.delay);
    if (asked == ORR_EXIT_OK) asked = orr_motion_poll_ask(c, &p.motion);
    if (asked != ORR_EXIT_OK) return asked;
    orr_diag diag = {0};
    orr_status s = orr_dial_open(
        c->operand[0], (double)orr_cli_duration_ns(c, "timeout", 10 * ORR_NS_PER_S) * 1e-9, &p.d, &diag);
    if (s == ORR_E_ARG) return orr_cli_usage(c, "%s", diag.text);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    int status = poll_service(&p);
    orr_dial_close(p.d);
    return status;
}

static const orr_option options[] = {
    {.name = "at",
     .letter = 't',
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "first epoch, GPS time unless marked otherwise. Default: the start of the served span"},
    {.name = "step",
     .letter = 's',
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "from one epoch to the next. Default 1 s"},
    {.name = "count",
     .letter = 'n',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 1e9,
     .help = "epochs. Default 1; with --realtime until interrupted or past the span"},
    {.name = "sat",
     .kind = ORR_OPT_SATS,
     .value = "LIST",
     .help = "satellites: G05,R,E01-E09. Default: all that are served"},
    ORR_POLL_DELAY_OPTIONS,
    ORR_POLL_MOTION_OPTIONS,
    {.name = "realtime",
     .kind = ORR_OPT_FLAG,
     .help = "ask for one epoch a step of real time, as a signal generator does"},
    {.name = "timeout",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "give up when the server is silent for so long. Default 10 s"},
    {.name = "json",
     .kind = ORR_OPT_FLAG,
     .help = "one JSON object an epoch and line (docs/protocol.md lists the keys)"},
};

const orr_command orr_cmd_poll = {
    .name = "poll",
    .group = "Service",
    .summary = "ask a service for satellite states",
    .operands = "URL",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Prints position and velocity in the terrestrial frame of the orbits, clock offset (periodic "
             "relativity not "
             "included) and 1-sigma of the position. Where a satellite has no valid arc, or the time is "
             "outside the served "
             "span, it says so instead of a number; exit status 1 if there was no number at all.\n\n"
             "With --delays: azimuth, elevation, pierce point, slant electron content and the delay of a "
             "code on each carrier "
             "(a carrier phase is early by as much), and what it came from.",
    .example = "orrery poll tcp://127.0.0.1:15754 --at 2024-02-04T12:00:00 --sat G05,E\n"
               "orrery poll unix:/tmp/orrery.sock --step 0.1 --count 100 --json\n"
               "orrery poll tcp://127.0.0.1:15754 --step 0.1 --realtime --sat G\n"
               "orrery poll tcp://127.0.0.1:15754 --delays --receiver 52.28,17.07,124 --carrier 1575.42 "
               "--carrier 1176.45",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
