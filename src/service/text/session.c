// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/session.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/text/json_line.h"
#include "src/service/text/message_text.h"
#include "src/service/text/scpi_dialects.h"

static const orr_asked *asked_of(const orr_scpi *s) { return orr_text_asked(s); }

// What a refusal is in SCPI, with its sentence.
static int refused(orr_scpi *s, uint16_t code, const orr_server_refusal *why)
{
    snprintf(s->detail, sizeof s->detail, "%s", why->sentence);
    switch (code) {
    case ORR_MSG_ERROR_CODE_NOT_PERMITTED:
        return ORR_SCPI_PROTECTED;
    case ORR_MSG_ERROR_CODE_BAD_REQUEST:
    case ORR_MSG_ERROR_CODE_LIMIT:
        return ORR_SCPI_RANGE;
    default:
        return ORR_SCPI_EXECUTION;
    }
}

// --- Parameters ---

// "2025-03-21T10:00:00" or whatever the command line takes, or a week and its seconds. Without any: now.
static int take_time(orr_scpi *s, char *const *p, size_t n, orr_time *t)
{
    char text[80];
    orr_diag diag = {0};
    if (n == 0) {
        orr_msg_time now = {.t = 0};
        if (asked_of(s)->streams != NULL) orr_streams_time(asked_of(s)->streams, &now);
        *t = now.t;
        return 0;
    }
    snprintf(text, sizeof text, n == 2 ? "%s:%s" : "%s", p[0], n == 2 ? p[1] : "");
    if (orr_time_parse(text, asked_of(s)->leap, t, &diag) == ORR_OK) return 0;
    snprintf(s->detail, sizeof s->detail, "%.200s", diag.text);
    return ORR_SCPI_RANGE;
}

static int take_sat(orr_scpi *s, const char *text, orr_msg_sat_id *sat)
{
    char *end;
    const unsigned long number = text[0] != '\0' ? strtoul(text + 1, &end, 10) : 0;
    if (number == 0 || number > 99 || *end != '\0' || !isalpha((unsigned char)text[0])) {
        snprintf(s->detail, sizeof s->detail, "'%.20s' is no satellite: G05 is one", text);
        return ORR_SCPI_ILLEGAL;
    }
    *sat = (orr_msg_sat_id){(uint8_t)toupper((unsigned char)text[0]), (uint8_t)number};
    return 0;
}

static int take_number(orr_scpi *s, const char *text, unsigned long most, uint16_t *out)
{
    char *end;
    const unsigned long v = strtoul(text, &end, 10);
    if (end == text || *end != '\0') return ORR_SCPI_ILLEGAL;
    if (v > most) {
        snprintf(s->detail, sizeof s->detail, "'%.20s' is above %lu", text, most);
        return ORR_SCPI_RANGE;
    }
    *out = (uint16_t)v;
    return 0;
}

// --- Queries ---

static int ask(orr_scpi *s, uint16_t type, const orr_msg_any *request, const orr_message_info **info,
               orr_msg_any *m)
{
    orr_server_refusal why = {""};
    const uint16_t code = orr_ask(asked_of(s), type, request, 0, info, m, &why);
    return code == 0 ? 0 : refused(s, code, &why);
}

// The values of the answer: of its first record where it has a list, of all of them with their number in front.
static int put_answer(orr_scpi *s, uint16_t type, const orr_msg_any *request, bool all, FILE *out)
{
    const orr_message_info *info;
    orr_msg_any m;
    const int wrong = ask(s, type, request, &info, &m);
    if (wrong != 0) return wrong;
    const orr_field *rows = orr_message_rows(info->record);
    if (rows == NULL) {
        orr_message_values(info->record, &m, out);
        return 0;
    }
    orr_message_room one;
    size_t n = 0;
    orr_wire_iter it = {0};
    while (rows->next(orr_message_member(rows, &m), &it, &one)) n++;
    if (n == 0 && !all) {
        snprintf(s->detail, sizeof s->detail, "outside the span that is served");
        return ORR_SCPI_RANGE;
    }
    if (all) fprintf(out, "%zu", n);
    it = (orr_wire_iter){0};
    for (size_t k = 0; k < (all ? n : 1) && rows->next(orr_message_member(rows, &m), &it, &one); k++) {
        if (all) putc(',', out);
        orr_message_values(rows->record, &one, out);
    }
    return 0;
}

static int sat_query(orr_scpi *s, uint16_t type, orr_msg_any *request, orr_msg_sat_id_list *list,
                     char *const *p, size_t n, FILE *out)
{
    orr_msg_sat_id sat;
    orr_msg_epochs *e = orr_ask_epochs(type, request);
    int wrong = take_sat(s, p[0], &sat);
    if (wrong == 0) wrong = take_time(s, p + 1, n - 1, &e->t);
    if (wrong != 0) return wrong;
    e->count = 1;
    *list = (orr_msg_sat_id_list){.count = 1, .item = &sat};
    return put_answer(s, type, request, false, out);
}

static int sat_state(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll = {.epochs = {0}}};
    return sat_query(s, ORR_MSG_TYPE_POLL, &m, &m.poll.satellites, p, n, out);
}

static int sat_elements(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll_elements = {.epochs = {0}}};
    return sat_query(s, ORR_MSG_TYPE_POLL_ELEMENTS, &m, &m.poll_elements.satellites, p, n, out);
}

static int sat_navdata(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll_navdata = {.epochs = {0}}};
    return sat_query(s, ORR_MSG_TYPE_POLL_NAVDATA, &m, &m.poll_navdata.satellites, p, n, out);
}

static int sat_list(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    orr_msg_caps caps = {.major = 0};
    orr_msg_sat_id sat;
    orr_wire_iter it = {0};
    const orr_server *server = asked_of(s)->server;
    if (server->caps != NULL) server->caps(server->user, &caps);
    for (size_t k = 0; k < caps.satellites.count; k++) {
        if (!orr_msg_sat_id_next(&caps.satellites, &it, &sat)) break;
        fprintf(out, "%s%c%02u", k > 0 ? "," : "", sat.system, sat.number);
    }
    return 0;
}

static int channels(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll_channels = {.epochs = {0, 0, 1}}};
    int wrong = n > 0 ? take_number(s, p[0], 65535, &m.poll_channels.antenna) : 0;
    if (wrong == 0) wrong = take_time(s, p + 1, n > 0 ? n - 1 : 0, &m.poll_channels.epochs.t);
    return wrong != 0 ? wrong : put_answer(s, ORR_MSG_TYPE_POLL_CHANNELS, &m, true, out);
}

static int truth(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll_truth = {.epochs = {0, 0, 1}}};
    int wrong = n > 0 ? take_number(s, p[0], 65535, &m.poll_truth.unit) : 0;
    if (wrong == 0) wrong = take_time(s, p + 1, n > 0 ? n - 1 : 0, &m.poll_truth.epochs.t);
    return wrong != 0 ? wrong : put_answer(s, ORR_MSG_TYPE_POLL_TRUTH, &m, false, out);
}

static int events(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.poll_events = {.epochs = {0, 0, 1}}};
    const int wrong = take_time(s, p, n, &m.poll_events.epochs.t);
    return wrong != 0 ? wrong : put_answer(s, ORR_MSG_TYPE_POLL_EVENTS, &m, true, out);
}

static int time_query(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    const orr_msg_any m = {.get_time = {0}};
    return put_answer(s, ORR_MSG_TYPE_GET_TIME, &m, false, out);
}

static int modes(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    orr_msg_any m = {.get_modes = {0}};
    uint16_t after = 0;
    const int wrong = n > 0 ? take_number(s, p[0], 65535, &after) : 0;
    m.get_modes.after = after;
    return wrong != 0 ? wrong : put_answer(s, ORR_MSG_TYPE_GET_MODES, &m, true, out);
}

static int stats(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    const orr_msg_any m = {.get_motion_stats = {0}};
    return put_answer(s, ORR_MSG_TYPE_GET_MOTION_STATS, &m, false, out);
}

static int reset_stats(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    const orr_msg_any m = {.get_motion_stats = {1}};
    const orr_message_info *info;
    orr_msg_any told;
    return ask(s, ORR_MSG_TYPE_GET_MOTION_STATS, &m, &info, &told);
}

// --- Control ---

static int control(orr_scpi *s, uint8_t action, char *const *p, size_t n, bool at)
{
    orr_msg_any m = {.control = {.action = action, .t = ORR_TIME_NONE, .at = ORR_TIME_NONE}}, told;
    const orr_message_info *info;
    if (n > 0) {
        const int wrong = take_time(s, p, n, at ? &m.control.at : &m.control.t);
        if (wrong != 0) return wrong;
    }
    const int wrong = ask(s, ORR_MSG_TYPE_CONTROL, &m, &info, &told);
    return wrong == ORR_SCPI_RANGE ? ORR_SCPI_CONFLICT : wrong;
}

static int load(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_LOAD, p, n, false);
}
// Another scenario of the server's folder, by its name.
static int open_other(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    const orr_msg_any m = {.control = {.action = ORR_MSG_CONTROL_ACTION_LOAD,
                                       .t = ORR_TIME_NONE,
                                       .at = ORR_TIME_NONE,
                                       .scenario = orr_wire_text(p[0])}};
    const orr_message_info *info;
    orr_msg_any told;
    return ask(s, ORR_MSG_TYPE_CONTROL, &m, &info, &told);
}

static int arm(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_ARM, p, n, false);
}
static int wait_pps(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_WAIT_PPS, p, n, false);
}
static int start(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_START, p, n, true);
}
static int pause_it(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_PAUSE, p, n, false);
}
static int stop(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    return control(s, ORR_MSG_CONTROL_ACTION_STOP, p, n, false);
}

static const orr_scpi_command commands[] = {
    {"*RST", 0, 0, stop, true},
    {"SATellite:LIST?", 0, 0, sat_list, false},
    {"SATellite:STATe?", 1, 3, sat_state, false},
    {"SATellite:ELEMents?", 1, 3, sat_elements, false},
    {"SATellite:NAVData?", 1, 3, sat_navdata, false},
    {"CHANnel?", 0, 3, channels, false},
    {"TRUTh?", 0, 3, truth, false},
    {"EVENt?", 0, 2, events, false},
    {"TIME?", 0, 0, time_query, false},
    {"MODE?", 0, 1, modes, false},
    {"MOTion:STATistics?", 0, 0, stats, false},
    {"MOTion:STATistics:RESet", 0, 0, reset_stats, true},
    {"SCENario:LOAD", 0, 2, load, true},
    {"SCENario:OPEN", 1, 1, open_other, true},
    {"SCENario:ARM", 0, 2, arm, true},
    {"SCENario:WPPS", 0, 2, wait_pps, true},
    {"SCENario:STARt", 0, 2, start, true},
    {"SCENario:PAUSe", 0, 0, pause_it, true},
    {"SCENario:STOP", 0, 0, stop, true},
};

// --- The session ---

bool orr_text_session_open(orr_text_session *s, const orr_asked *asked)
{
    *s = (orr_text_session){.asked = asked,
                            .scpi = {.table = {{commands, sizeof commands / sizeof commands[0]},
                                               {orr_scpi_gsg, orr_scpi_n_gsg},
                                               {orr_scpi_rs, orr_scpi_n_rs}},
                                     .identity = "Orrery,GNSS simulator,0," ORR_VERSION}};
    s->line = malloc(ORR_TEXT_LINE + 1);
    return s->line != NULL;
}

void orr_text_session_close(orr_text_session *s) { free(s->line); }

// Bits of the operation register: waiting for a start, and the designer's: running, paused. Of the questionable one: time.
static void look_at_status(orr_text_session *s)
{
    enum { WAITING = 1 << 5, RUNNING = 1 << 8, PAUSED = 1 << 9, TIME = 1 << 2 };
    orr_msg_time t;
    if (s->asked->streams == NULL) return;
    orr_streams_time(s->asked->streams, &t);
    uint16_t c = 0;
    if (t.state == ORR_MSG_CLOCK_STATE_ARMED || t.state == ORR_MSG_CLOCK_STATE_WAITING) c = WAITING;
    if (t.state == ORR_MSG_CLOCK_STATE_RUNNING) c = RUNNING;
    if (t.state == ORR_MSG_CLOCK_STATE_PAUSED) c = PAUSED;
    orr_scpi_condition(&s->scpi.operation, c);
    orr_scpi_condition(&s->scpi.questionable, t.steps > 0 || t.wander_ns > 1e6 ? TIME : 0);
}

static void take_line(orr_text_session *s, FILE *out)
{
    s->line[s->n] = '\0';
    const char *c = s->line;
    while (isspace((unsigned char)*c)) c++;
    if (*c == '{') {
        orr_json_line(s->asked, c, out);
        return;
    }
    look_at_status(s);
    s->scpi.read_only = (s->asked->may & ORR_MAY_CONTROL) == 0; // rules may have been read again
    s->common.asked = s->asked;
    s->scpi.user = &s->common; // the session may have been moved since it was opened
    orr_scpi_line(&s->scpi, s->line, out);
}

void orr_text_session_take(orr_text_session *s, const char *data, size_t n, FILE *out)
{
    for (size_t k = 0; k < n; k++) {
        if (data[k] == '\n') {
            if (!s->overrun) take_line(s, out);
            s->overrun = false;
            s->n = 0;
        } else if (s->n == ORR_TEXT_LINE) {
            if (!s->overrun) orr_scpi_fail(&s->scpi, ORR_SCPI_OVERRUN, "a line of more than 65536 bytes");
            s->overrun = true;
        } else {
            s->line[s->n++] = data[k] != '\0' ? data[k] : ' ';
        }
    }
}
