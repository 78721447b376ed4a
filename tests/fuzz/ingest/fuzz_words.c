// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in options, addresses and small tables: instants, durations, satellites, signals, messages, addresses of services, a station of
// a BLQ file, a table of archives. What is told again is read again as the same.
#define _GNU_SOURCE // memfd_create
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/sat.h"
#include "core/signal.h"
#include "core/time.h"
#include "ingest/fetch/archives.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/tables/blq.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

static void must(bool holds)
{
    if (!holds) abort();
}

static void see_words(const char *text)
{
    orr_diag diag = {0};
    orr_time t, again;
    char told[ORR_TIME_TEXT];
    if (orr_time_parse(text, NULL, &t, &diag) == ORR_OK) {
        must(orr_time_parse(orr_time_text(t, told), NULL, &again, &diag) == ORR_OK && again == t);
    } else {
        must(diag.text[0] != '\0');
    }
    int64_t ns;
    (void)orr_duration_parse(text, &ns, NULL);
    const orr_sat sat = orr_sat_parse(text);
    char name[ORR_SAT_TEXT];
    if (sat != ORR_SAT_NONE) must(orr_sat_parse(orr_sat_text(sat, name)) == sat);
    orr_sat_set set = {0};
    uint64_t signals;
    uint32_t messages;
    (void)orr_sat_set_parse(text, &set, NULL);
    (void)orr_signal_parse(text, &signals, NULL);
    (void)orr_nav_messages_parse(text, &messages, NULL);
}

static void see_archives(const char *text, size_t n)
{
    orr_archives *a = NULL;
    orr_diag diag = {0};
    if (orr_archives_parse("fuzz", text, n, &a, &diag) != ORR_OK) {
        must(a == NULL && diag.text[0] != '\0');
        return;
    }
    for (int p = 0; p < ORR_PRODUCT_N; p++) {
        const orr_wanted w = {.product = (orr_product)p, .mjd = 60755, .station = "BOR1"};
        orr_candidate *c = NULL;
        size_t k = 0;
        if (orr_archives_candidates(a, &w, &c, &k, NULL) != ORR_OK) continue;
        for (size_t i = 0; i < k; i++) must(c[i].name[0] != '\0' && c[i].url[0] != '\0');
        free(c);
    }
    orr_archives_free(a);
}

static void see_blq(const uint8_t *data, size_t n)
{
    char path[40];
    orr_blq b;
    orr_diag diag = {0};
    const int fd = memfd_create("fuzz", 0);
    if (fd < 0) return;
    if (write(fd, data, n) == (ssize_t)n) {
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
        if (orr_blq_read(path, "onsala", &b, &diag) != ORR_OK) must(diag.text[0] != '\0');
    }
    close(fd);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n == 0 || n > 65536) return 0;
    const char what = (char)data[0];
    char *text = malloc(n);
    if (text == NULL) return 0;
    memcpy(text, data + 1, n - 1);
    text[n - 1] = '\0';
    if (what == 'a')
        see_archives(text, n - 1);
    else if (what == 'b')
        see_blq(data + 1, n - 1);
    else
        see_words(text);
    free(text);
    return 0;
}
