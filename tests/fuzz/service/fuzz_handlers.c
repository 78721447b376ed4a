// SPDX-License-Identifier: GPL-3.0-or-later
// The real table of handlers, over an engine of everything: made satellites with broadcast data, a made
// ionosphere, a flight with two units. The input is a conversation, requests as [type, length, payload]... in
// frames that are well made; it is answered once at one go and once in turns of one piece with a small output,
// and both must be the same bytes.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "src/scenario/engine/engine.h"
#include "src/service/answers/answers.h"
#include "unit/orbit/made_orbit.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

#define MUST(condition)                                                                                      \
    do {                                                                                                     \
        if (!(condition)) abort();                                                                           \
    } while (0)

enum { MOST_OUT = 1 << 14, SMALL_OUT = 4096 }; // a frame of the slowest kind is 0.5 ms for 400 bytes

static char folder[256];

static void file(char path[300], const char *name) { snprintf(path, 300, "%s/%s", folder, name); }

static void remove_files(void)
{
    static const char *const made[] = {"day.nc", "ionosphere.ION"};
    for (size_t i = 0; i < sizeof made / sizeof made[0]; i++) {
        char path[300];
        file(path, made[i]);
        unlink(path);
    }
    rmdir(folder);
}

static void make_product(void)
{
    orr_diag diag = {0};
    char path[300];
    orr_orbit_solution s = made_solution(6, 12, 900, 6);
    orr_ephemeris *e;
    MUST(orr_ephemeris_build(&s, &e, &diag) == ORR_OK);
    file(path, "day.nc");
    MUST(orr_ephemeris_save(e, path, "made for a fuzz target", &diag) == ORR_OK);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

// The sample's coefficients around the made day.
static void make_ionosphere(void)
{
    char path[300], line[200];
    file(path, "ionosphere.ION");
    FILE *in = fopen(ORR_SOURCE_DIR "/samples/ionosphere.ION", "r"), *out = fopen(path, "w");
    MUST(in != NULL && out != NULL);
    while (fgets(line, sizeof line, in) != NULL) {
        char *first = strstr(line, "2025 03 20"), *last = strstr(line, "2025 03 23");
        if (first != NULL) memcpy(first, "2024 02 03", 10);
        if (last != NULL) memcpy(last, "2024 02 06", 10);
        fputs(line, out);
    }
    fclose(in);
    MUST(fclose(out) == 0);
}

static const orr_server *server(void)
{
    static const orr_server *made;
    if (made != NULL) return made;
    const char *temp = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/fuzz_handlers-XXXXXX", temp != NULL ? temp : "/tmp");
    MUST(mkdtemp(folder) != NULL);
    atexit(remove_files);
    make_product();
    make_ionosphere();
    static const char text[] =
        "orbit: {product: day.nc}\n"
        "ionosphere: {field: ionosphere.ION}\n"
        "trajectory: {kind: survey, start: 2024-02-04T01:00:00, duration: 600, lat: 56, lon: 40, height: "
        "1500,\n"
        "  survey: {azimuth: 0, length: 10000, spacing: 2000, lines: 2, tie_lines: 0}, speed: 65, bank: 20}\n"
        "units: [{name: tail, forward: -3, heading: 90}]\n"
        "imu: {rate: 100}\n";
    orr_scenario scenario;
    orr_engine *engine;
    orr_answers *answers;
    orr_diag diag = {0};
    if (orr_scenario_parse("fuzz", text, strlen(text), folder, NULL, &scenario, &diag) != ORR_OK ||
        orr_engine_open(&scenario, NULL, NULL, NULL, &engine, &diag) != ORR_OK ||
        orr_answers_open(engine, &answers, &diag) != ORR_OK) {
        fprintf(stderr, "fuzz_handlers: %s\n", diag.text);
        abort();
    }
    orr_scenario_free(&scenario);
    return made = orr_answers_server(answers);
}

static bool at_once(void *owner)
{
    (void)owner;
    return true;
}

// Answers `in` until it is done with, or there is as much output as is looked at; the output's size.
static size_t converse(const orr_server *s, const uint8_t *in, size_t n, bool in_pieces, uint8_t *out)
{
    static uint8_t room[ORR_SERVER_OUT];
    orr_server_conn c = {.can_grow = true, .over = in_pieces ? at_once : NULL};
    size_t from = 0, got = 0;
    orr_wire_writer w = {room, 0, in_pieces ? SMALL_OUT : MOST_OUT, ORR_WIRE_OK};
    while (got < MOST_OUT) {
        orr_server_step step;
        orr_server_run(s, &c, in + from, n - from, &w, &step);
        MUST(step.consumed <= n - from && w.size + c.unfinished <= w.capacity && w.status == ORR_WIRE_OK);
        for (size_t at = 0, used; at < w.size; at += used) {
            orr_frame f;
            MUST(orr_frame_parse(room + at, w.size - at, ORR_MSG_MAX_PAYLOAD, &f, &used) == ORR_WIRE_OK);
        }
        from += step.consumed;
        size_t keep = w.size < MOST_OUT - got ? w.size : MOST_OUT - got;
        memcpy(out + got, room, keep);
        got += keep;
        memmove(room, room + w.size, c.unfinished);
        w.size = 0;
        if (step.room > w.capacity) w.capacity = step.room;
        MUST(w.capacity <= sizeof room);
        if (!step.busy || step.closing != 0) break;
    }
    return got;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    static uint8_t framed[1 << 16], one[MOST_OUT], two[MOST_OUT];
    orr_wire_writer w = {framed, 0, sizeof framed, ORR_WIRE_OK};
    for (uint32_t k = 0; n >= 3 && k < 8 && w.size + 4000 < sizeof framed; k++) {
        size_t size = data[1] | (size_t)data[2] << 8, start;
        if (size > n - 3) size = n - 3;
        if (size > 3900) size = 3900;
        orr_frame_begin(&w, data[0], k, &start);
        orr_wire_put_raw(&w, data + 3, size);
        orr_frame_end(&w, start);
        data += 3 + size;
        n -= 3 + size;
    }
    MUST(w.status == ORR_WIRE_OK);
    const orr_server *s = server();
    size_t whole = converse(s, framed, w.size, false, one), pieces = converse(s, framed, w.size, true, two);
    MUST(whole == pieces && memcmp(one, two, whole) == 0);
    return 0;
}
