// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study.h"

#include <stdlib.h>
#include <string.h>

orr_status orr_study_parse(const orr_schema *schema, const char *name, const char *text, size_t n,
                           const orr_leap_table *leap, void *base, orr_diag *diag)
{
    memset(base, 0, schema->size);
    char *folder = orr_yaml_folder(name);
    if (folder == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_yaml y;
    orr_status s = orr_yaml_parse(name, text, n, &y, diag);
    if (s == ORR_OK) {
        s = orr_schema_read(schema, &y, folder, leap, base, diag);
        orr_yaml_free(&y);
    }
    free(folder);
    return s;
}
