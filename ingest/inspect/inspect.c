// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/inspect/inspect.h"

#include <string.h>

#include "ingest/input/input.h"

typedef orr_status inspector(const char *path, orr_inspection *r, orr_diag *diag);

static inspector *inspector_of(orr_kind kind)
{
    switch (kind) {
#define ORR_INSPECT(kind, name)                                                                              \
    case kind:                                                                                               \
        return orr_inspect_##name;
#include "ingest/inspect/inspect.def"
#undef ORR_INSPECT
    default:
        return NULL;
    }
}

orr_status orr_inspect(const char *path, orr_inspection *out, orr_diag *diag)
{
    orr_inspection_init(out);
    if (orr_inspect_is_zip(path)) {
        out->kind = ORR_KIND_ZIP;
        return orr_inspect_zip(path, out, diag);
    }
    orr_input *in = NULL;
    orr_status st = orr_input_open(path, NULL, &in, diag);
    if (st != ORR_OK) return st;
    orr_sniffed s = orr_sniff(orr_input_head(in));
    orr_input_close(in);
    out->kind = s.kind;
    memcpy(out->version, s.version, sizeof out->version);
    inspector *inspect = inspector_of(s.kind);
    if (inspect != NULL) return inspect(path, out, diag);
    if (s.kind <= ORR_KIND_WEB_PAGE)
        return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "this is %s, not a file that Orrery knows",
                           orr_kind_name(s.kind));
    return orr_diag_at(diag, ORR_E_UNSUPPORTED, path, 0, 0, "this is %s, which Orrery does not inspect",
                       orr_kind_name(s.kind));
}
