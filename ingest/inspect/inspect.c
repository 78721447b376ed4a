// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/inspect/inspect.h"

#include <string.h>
#include <sys/stat.h>

#include "ingest/input/input.h"

typedef orr_status inspector(const char *path, orr_inspection *r, orr_diag *diag);

static inspector *inspector_of(orr_kind kind)
{
    switch (kind) {
#define ORR_INSPECT(kind, name)                                                                              \
    case kind:                                                                                               \
        return orr_inspect_##name;
#include "ingest/input/sniff.h"
#include "ingest/inspect/inspect.def"
#undef ORR_INSPECT
    default:
        return NULL;
    }
}

// Whether it can be read but once: standard input, a pipe.
static bool read_once(const char *path)
{
    struct stat st;
    return strcmp(path, "-") == 0 || (stat(path, &st) == 0 && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode));
}

static orr_status sniff(const char *path, orr_inspection *out, orr_diag *diag)
{
    orr_input *in = NULL;
    orr_status st = out->raw != NULL
                        ? orr_input_open_bytes(path, out->raw->text, out->raw->n, NULL, &in, diag)
                        : orr_input_open(path, NULL, &in, diag);
    if (st != ORR_OK) return st;
    const orr_sniffed s = orr_sniff(orr_input_head(in));
    orr_input_close(in);
    out->kind = s.kind;
    memcpy(out->version, s.version, sizeof out->version);
    return ORR_OK;
}

static orr_status inspect(const char *path, orr_inspection *out, orr_diag *diag)
{
    if (out->raw == NULL && orr_inspect_is_zip(path)) {
        out->kind = ORR_KIND_ZIP;
        return orr_inspect_zip(path, out, diag);
    }
    const orr_status st = sniff(path, out, diag);
    if (st != ORR_OK) return st;
    inspector *const inspect_kind = inspector_of(out->kind);
    if (inspect_kind != NULL) return inspect_kind(path, out, diag);
    if (out->kind <= ORR_KIND_WEB_PAGE)
        return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "this is %s, not a file that Orrery knows",
                           orr_kind_name(out->kind));
    return orr_diag_at(diag, ORR_E_UNSUPPORTED, path, 0, 0, "this is %s, which Orrery does not inspect%s",
                       orr_kind_name(out->kind), out->raw != NULL ? " in a pipe" : "");
}

orr_status orr_inspect(const char *path, const orr_leap_table *leap, orr_inspection *out, orr_diag *diag)
{
    orr_bytes raw = {0};
    orr_inspection_init(out);
    out->leap = leap;
    if (read_once(path)) {
        orr_input_limits limits = orr_input_default_limits();
        limits.kinds = ORR_KINDS_KNOWN;
        const orr_status s = orr_input_read_raw(path, &limits, &raw, diag);
        if (s != ORR_OK) return s;
        out->raw = &raw;
    }
    orr_status s = inspect(path, out, diag);
    if (s == ORR_OK && out->incomplete) s = orr_diag_set(diag, ORR_E_MEMORY, "%s: out of memory", path);
    out->raw = NULL;
    orr_bytes_free(&raw);
    return s;
}
