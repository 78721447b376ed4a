// SPDX-License-Identifier: GPL-3.0-or-later
// An archive by anyone: the record of a day (day.json), and the catalogue's file (catalogue.sqlite), which is made anew where it is wrong. The
// first byte chooses. A record that is read writes what is read as the same.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "src/archive/catalogue.h"
#include "src/archive/record.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

static char root[64], day[96], other[96];

static void leave(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", root);
    if (system(command) != 0) fprintf(stderr, "%s is left behind\n", root);
}

static void must(bool holds)
{
    if (!holds) abort();
}

// An archive of one day, in memory where the machine has a folder there.
static void make_room(void)
{
    char year[80];
    snprintf(root, sizeof root, "%s/orrery-fuzz-XXXXXX", access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp");
    must(mkdtemp(root) != NULL);
    snprintf(year, sizeof year, "%s/2025", root);
    snprintf(day, sizeof day, "%s/080", year);
    snprintf(other, sizeof other, "%s/other", root);
    must(mkdir(year, 0777) == 0 && mkdir(day, 0777) == 0 && mkdir(other, 0777) == 0);
    atexit(leave);
}

static void put(const char *folder, const char *name, const uint8_t *data, size_t n)
{
    char path[160];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    must(f != NULL && fwrite(data, 1, n, f) == n && fclose(f) == 0);
}

static size_t get(const char *folder, char *text, size_t n)
{
    char path[160];
    snprintf(path, sizeof path, "%s/%s", folder, ORR_ARCHIVE_RECORD);
    FILE *f = fopen(path, "rb");
    must(f != NULL);
    const size_t size = fread(text, 1, n, f);
    fclose(f);
    return size;
}

static void see_record(const uint8_t *data, size_t n)
{
    static char one[1 << 20], two[1 << 20];
    static orr_archive_record r;
    orr_diag diag = {0};
    put(day, ORR_ARCHIVE_RECORD, data, n);
    if (orr_archive_record_read(day, &r, &diag) != ORR_OK) {
        must(diag.text[0] != '\0');
        return;
    }
    must(orr_archive_record_write(&r, other, &diag) == ORR_OK);
    const size_t size = get(other, one, sizeof one);
    must(orr_archive_record_read(other, &r, &diag) == ORR_OK);
    must(orr_archive_record_write(&r, other, &diag) == ORR_OK);
    must(get(other, two, sizeof two) == size && memcmp(one, two, size) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n == 0 || n > 65536) return 0;
    if (root[0] == '\0') make_room();
    if (data[0] != 'c') {
        see_record(data + 1, n - 1);
        return 0;
    }
    orr_catalogue c = {0};
    orr_diag diag = {0};
    put(root, "catalogue.sqlite", data + 1, n - 1);
    const orr_status s = orr_catalogue_make(root, true, &c, NULL, &diag);
    if (s != ORR_OK) must(diag.text[0] != '\0');
    orr_catalogue_free(&c);
    return 0;
}
