// SPDX-License-Identifier: GPL-3.0-or-later
// What inspect tells of a zip archive: how many files are in it. Readers take the files inside, unpacked; the
// directory at the archive's end is enough to say what there is (APPNOTE 6.3, 4.3.16).
#include <stdio.h>
#include <string.h>

#include "ingest/inspect/inspect.h"

#define DIRECTORY_END 22u // bytes of the end-of-central-directory record without its comment
#define MOST_COMMENT 65535u

bool orr_inspect_is_zip(const char *path)
{
    uint8_t head[4];
    FILE *f = fopen(path, "rb");
    if (f == NULL) return false;
    bool zip = fread(head, 1, sizeof head, f) == sizeof head &&
               (memcmp(head, "PK\x03\x04", 4) == 0 || memcmp(head, "PK\x05\x06", 4) == 0);
    fclose(f);
    return zip;
}

static uint32_t little(const uint8_t *p, int n)
{
    uint32_t v = 0;
    for (int k = n - 1; k >= 0; k--) v = v << 8 | p[k];
    return v;
}

orr_status orr_inspect_zip(const char *path, orr_inspection *r, orr_diag *diag)
{
    static const char broken[] = "a zip archive without its directory: it is cut (a broken download?)";
    uint8_t tail[DIRECTORY_END + MOST_COMMENT];
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened");
    size_t n = 0;
    if (fseek(f, -(long)sizeof tail, SEEK_END) == 0 || fseek(f, 0, SEEK_SET) == 0)
        n = fread(tail, 1, sizeof tail, f);
    fclose(f);
    for (size_t at = n >= DIRECTORY_END ? n - DIRECTORY_END + 1 : 0; at-- > 0;) {
        if (memcmp(tail + at, "PK\x05\x06", 4) != 0 || at + DIRECTORY_END + little(tail + at + 20, 2) != n)
            continue;
        r->records = little(tail + at + 10, 2);
        orr_inspect_fact_add(r, "to read it", "unpack it and give the files inside");
        return ORR_OK;
    }
    return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "%s", broken);
}
