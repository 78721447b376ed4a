// SPDX-License-Identifier: GPL-3.0-or-later
// Requests as JSON that cannot be: each is refused in one line that names its member and says what is wanted, and none changes what the next is
// answered.
#include "testing.h"

#include "src/service/text/message_text.h"
#include "src/service/text/session.h"
#include "unit/proto/fake.h"

static void host(void *user, orr_host *h)
{
    (void)user;
    *h = (orr_host){1000, 1000, INT64_C(1700000000000000000), INT64_C(1700000037000000000)};
}

// What a line is answered; to be freed.
static char *told(const char *line)
{
    static uint8_t room[ORR_MSG_LARGEST];
    fake f = {.n_sats = 3};
    const orr_server server = fake_server(&f);
    const orr_streams_options o = {.maker = &server, .host = host, .processor = -1};
    orr_streams *streams;
    assert_int_equal(orr_streams_open(&o, &streams, NULL), ORR_OK);
    const orr_asked who = {.server = &server, .streams = streams, .may = ORR_MAY_ALL, .room = room};
    orr_text_session t;
    char *answer = NULL;
    size_t n = 0;
    FILE *out = open_memstream(&answer, &n);
    assert_non_null(out);
    assert_true(orr_text_session_open(&t, &who));
    orr_text_session_take(&t, line, strlen(line), out);
    orr_text_session_take(&t, "\n", 1, out);
    orr_text_session_close(&t);
    fclose(out);
    orr_streams_close(streams);
    return answer;
}

static void bad_requests(void **state)
{
    (void)state;
    static const struct {
        const char *line, *code, *words;
    } all[] = {
        {"{", "BAD_PAYLOAD", ""},
        {"{} {}", "BAD_PAYLOAD", "end of file expected"},
        {"{\"request\": \"POLL\", \"request\": \"POLL\"}", "BAD_PAYLOAD", "duplicate"},
        {"{\"request\": 5}", "UNKNOWN_TYPE", "names no message"},
        {"{\"request\": \"STATES\"}", "UNKNOWN_TYPE", "names no message"},
        {"{\"request\": \"POLL\", \"who\": 1}", "BAD_PAYLOAD", "does not have"},
        {"{\"request\": \"POLL\", \"t\": \"tomorrow\"}", "BAD_PAYLOAD", "t: "},
        {"{\"request\": \"POLL\", \"t\": 1.5}", "BAD_PAYLOAD", "t: is no whole number"},
        {"{\"request\": \"POLL\", \"t\": 1e300}", "BAD_PAYLOAD", "t: is no whole number"},
        {"{\"request\": \"POLL\", \"t\": [1]}", "BAD_PAYLOAD", "t: is neither a number nor a text"},
        {"{\"request\": \"POLL\", \"t\": null}", "BAD_PAYLOAD", "t: is neither"},
        {"{\"request\": \"POLL\", \"count\": -1}", "BAD_PAYLOAD", "count: out of range"},
        {"{\"request\": \"POLL\", \"count\": 4294967296}", "BAD_PAYLOAD", "count: out of range"},
        {"{\"request\": \"POLL\", \"count\": 4000000000}", "LIMIT", "epochs in one line"},
        {"{\"request\": \"POLL\", \"satellites\": \"G01\"}", "BAD_PAYLOAD", "satellites: is no list"},
        {"{\"request\": \"POLL\", \"satellites\": [5]}", "BAD_PAYLOAD",
         "satellites: holds what is no satellite"},
        {"{\"request\": \"POLL\", \"satellites\": [\"G0500\"]}", "BAD_PAYLOAD", "no satellite"},
        {"{\"request\": \"POLL\", \"satellites\": [\"G5x\"]}", "BAD_PAYLOAD", "no satellite"},
        {"{\"request\": \"POLL\", \"satellites\": [\"G\"]}", "BAD_PAYLOAD", "no satellite"},
        {"{\"request\": \"POLL\", \"satellites\": [\"\"]}", "BAD_PAYLOAD", "no satellite"},
        {"{\"request\": \"POLL_DELAYS\", \"receiver_m\": [1, 2]}", "BAD_PAYLOAD",
         "receiver_m: is no list of that many"},
        {"{\"request\": \"POLL_DELAYS\", \"receiver_m\": [1, \"2\", 3]}", "BAD_PAYLOAD",
         "receiver_m: is no list of that many"},
        {"{\"request\": \"POLL_DELAYS\", \"carriers_hz\": [\"L1\"]}", "BAD_PAYLOAD",
         "carriers_hz: holds what is no number"},
        {"{\"request\": \"POLL_DELAYS\", \"carriers_hz\": [1, 2, 3, 4, 5]}", "BAD_PAYLOAD",
         "carriers_hz: has too many"},
        {"{\"request\": \"POLL_CHANNELS\", \"signals\": [65536]}", "BAD_PAYLOAD",
         "signals: holds what is no whole number"},
        {"{\"request\": \"POLL_CHANNELS\", \"signals\": [\"L1CA\"]}", "BAD_PAYLOAD",
         "signals: holds what is no whole number"},
        {"{\"request\": \"POLL_IMU\", \"unit\": 65536}", "BAD_PAYLOAD", "unit: out of range"},
        {"{\"request\": \"POLL_IMU\", \"unit\": -1}", "BAD_PAYLOAD", "unit: out of range"},
        {"{\"request\": \"POLL_ELEMENTS\", \"frame\": \"upside down\"}", "BAD_PAYLOAD",
         "frame: there is no such word"},
        {"{\"request\": \"POLL_ELEMENTS\", \"frame\": 256}", "BAD_PAYLOAD", "frame: out of range"},
    };
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        char *answer = told(all[k].line);
        const char *end = strchr(answer, '\n');
        if (end == NULL || end[1] != '\0') fail_msg("%s: '%s' is not one line", all[k].line, answer);
        if (strstr(answer, all[k].code) == NULL || strstr(answer, all[k].words) == NULL)
            fail_msg("%s: '%s', wanted %s and '%s'", all[k].line, answer, all[k].code, all[k].words);
        free(answer);
    }
}

static void good_requests(void **state)
{
    (void)state;
    static const char *const all[] = {
        "{\"request\": \"POLL\", \"t\": 1000, \"count\": 1, \"satellites\": [\"G01\", \"R7\"]}",
        "{\"request\": \"POLL\", \"t\": 1e3, \"count\": 1.0}",
        "{\"request\": \"GET_TIME\"}",
    };
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        char *answer = told(all[k]);
        if (strstr(answer, "BAD_PAYLOAD") != NULL) fail_msg("%s: %s", all[k], answer);
        free(answer);
    }
}

// A list's record has room where lists are printed.
static void look_for_room(const orr_record *r)
{
    for (size_t i = 0; i < r->n; i++) {
        const orr_record *inner = r->field[i].record;
        if (inner == NULL) continue;
        assert_true(inner->size <= sizeof(orr_message_room));
        look_for_room(inner);
    }
}

static void records_have_room(void **state)
{
    (void)state;
    size_t messages = 0;
    for (unsigned type = 0; type <= UINT16_MAX; type++) {
        const orr_message_info *info = orr_message_of((uint16_t)type);
        if (info != NULL) look_for_room(info->record), messages++;
    }
    assert_true(messages > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(records_have_room),
        cmocka_unit_test(bad_requests),
        cmocka_unit_test(good_requests),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
