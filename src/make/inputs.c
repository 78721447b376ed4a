// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/inputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/path.h"
#include "core/sha256.h"

void orr_inputs_free(orr_inputs *list)
{
    free(list->item);
    *list = (orr_inputs){.leap = list->leap};
}

orr_nc_input *orr_inputs_provenance(const orr_inputs *list)
{
    orr_nc_input *input = calloc(list->n + 1, sizeof *input);
    for (size_t i = 0; input != NULL && i < list->n; i++)
        input[i] = (orr_nc_input){.path = list->item[i].name, .sha256 = list->item[i].sha256};
    return input;
}

orr_status orr_inputs_join(orr_inputs *list, const orr_inputs *more, orr_diag *diag)
{
    if (more->n == 0) return ORR_OK;
    orr_orbit_source *item = realloc(list->item, (list->n + more->n) * sizeof *item);
    if (item == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of inputs");
    memcpy(item + list->n, more->item, more->n * sizeof *item);
    list->item = item;
    list->n += more->n;
    return ORR_OK;
}

// A new item at the end, with its name; NULL without memory.
static orr_orbit_source *append(orr_inputs *list, const char *path)
{
    orr_orbit_source *item = realloc(list->item, (list->n + 1) * sizeof *item);
    if (item == NULL) return NULL;
    list->item = item;
    item += list->n++;
    *item = (orr_orbit_source){0};
    snprintf(item->name, sizeof item->name, "%s", orr_base_name(path));
    return item;
}

orr_status orr_inputs_read_raw(orr_inputs *list, const char *path, uint64_t kinds, orr_bytes *bytes,
                               orr_diag *diag)
{
    orr_input_limits limits = orr_input_default_limits();
    limits.kinds = kinds;
    orr_status s = orr_input_read_raw(path, &limits, bytes, diag);
    if (s != ORR_OK || list == NULL) return s;
    orr_orbit_source *item = append(list, path);
    s = item != NULL ? orr_sha256_bytes(bytes->text, bytes->n, item->sha256, diag)
                     : orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of inputs");
    if (s != ORR_OK) orr_bytes_free(bytes);
    return s;
}

orr_status orr_inputs_read(orr_inputs *list, const char *path, uint64_t kinds, orr_bytes *text,
                           orr_diag *diag)
{
    orr_bytes raw;
    *text = (orr_bytes){0};
    orr_status s = orr_inputs_read_raw(list, path, kinds, &raw, diag);
    if (s != ORR_OK) return s;
    s = orr_input_read_bytes(path, raw.text, raw.n, NULL, text, diag);
    orr_bytes_free(&raw);
    return s;
}

orr_status orr_inputs_note(orr_inputs *list, const char *path, orr_diag *diag)
{
    orr_orbit_source *item = append(list, path);
    if (item == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of inputs");
    return orr_sha256_file(path, item->sha256, diag);
}

orr_status orr_inputs_read_navs(orr_inputs *list, const char *const *path, size_t n, orr_nav *out,
                                orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_nav){0};
    orr_nav *file = calloc(n + 1, sizeof *file);
    if (file == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", n);
    orr_status s = ORR_OK;
    orr_nav_limits limits = orr_nav_default_limits();
    limits.leap = list != NULL ? list->leap : NULL;
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        orr_bytes text;
        s = orr_inputs_read(list, path[i], ORR_KIND_BIT(ORR_KIND_RINEX_NAV), &text, diag);
        if (s == ORR_OK) s = orr_nav_parse(path[i], text.text, text.n, &limits, &file[i], warnings, diag);
        orr_bytes_free(&text);
    }
    if (s == ORR_OK) s = orr_nav_merge(file, n, out, n > 1 ? warnings : NULL, diag);
    for (size_t i = 0; i < n; i++) orr_nav_free(&file[i]);
    free(file);
    return s;
}
