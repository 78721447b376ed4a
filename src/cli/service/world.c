// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/world.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "src/make/products.h"

// NetCDF by its first bytes: HDF5 (NetCDF-4) or classic. A scenario is text.
static orr_status is_product(const char *path, bool *yes, orr_diag *diag)
{
    char head[8] = {0};
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    size_t n = fread(head, 1, sizeof head, f);
    bool bad = ferror(f) != 0;
    fclose(f);
    if (bad) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(errno));
    *yes = n == sizeof head && (memcmp(head, "\x89HDF\r\n\x1a\n", 8) == 0 || memcmp(head, "CDF", 3) == 0);
    return ORR_OK;
}

// A data file instead of a scenario: what to do with it.
static orr_status check_kind(const char *path, orr_diag *diag)
{
    const orr_kind kind = orr_product_kind(path);
    if (kind == ORR_KIND_SP3)
        return orr_diag_at(
            diag, ORR_E_KIND, path, 0, 0,
            "is an SP3 file: `orrery orbit -o day.nc %s` makes a product of it, which can be served; or name "
            "it in a scenario under orbit.sp3",
            path);
    if (kind == ORR_KIND_UNKNOWN || kind == ORR_KIND_EMPTY || kind == ORR_KIND_TABLE)
        return ORR_OK; // may be YAML
    return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "is neither a scenario nor an orbit product but %s",
                       orr_kind_name(kind));
}

// FNV-1a of which file it is, how long, and when it was written.
static bool mark_file(void *user, const char *path)
{
    uint64_t *mark = user;
    struct stat st = {0};
    (void)stat(path, &st); // of one that is not there: zeroes
    const uint64_t of[] = {(uint64_t)st.st_dev, (uint64_t)st.st_ino, (uint64_t)st.st_size,
                           (uint64_t)st.st_mtim.tv_sec, (uint64_t)st.st_mtim.tv_nsec};
    for (size_t k = 0; k < sizeof of / sizeof of[0]; k++) *mark = (*mark ^ of[k]) * UINT64_C(0x100000001b3);
    return true;
}

orr_status serving_world_read(const orr_cli *c, const char *path, serving_world *w, orr_diag *diag)
{
    *w = (serving_world){.mark = UINT64_C(0xcbf29ce484222325)};
    (void)mark_file(&w->mark, path);
    bool product = false;
    orr_status s = is_product(path, &product, diag);
    if (s == ORR_OK && !product) s = check_kind(path, diag);
    if (s != ORR_OK) return s;
    s = product ? orr_scenario_of_product(path, c->leap, &w->scenario, diag)
                : orr_scenario_read(path, c->leap, &w->scenario, diag);
    if (s != ORR_OK) return s;
    (void)orr_schema_files(orr_scenario_schema(), &w->scenario, mark_file, &w->mark);
    const orr_scenario_serve *serve = &w->scenario.serve;
    return orr_access_open(orr_cli_text(c, "access", serve->access),
                           serve->insecure_listen || orr_cli_given(c, "insecure-listen"),
                           orr_cli_given(c, "read-only") ? ORR_MAY_READ : ORR_MAY_ALL, &w->access, diag);
}

orr_status serving_world_make(serving_world *w, const orr_log *log, const volatile int *cancel,
                              orr_warnings *warnings, orr_diag *diag)
{
    return orr_engine_open(&w->scenario, log, cancel, warnings, &w->engine, diag);
}

void serving_world_close(serving_world *w)
{
    orr_access_close(w->access);
    orr_engine_close(w->engine);
    orr_scenario_free(&w->scenario);
    *w = (serving_world){0};
}

static void *remake(void *user)
{
    serving_remake *r = user;
    r->status = serving_world_read(r->c, r->path, &r->world, &r->diag);
    r->same = r->status == ORR_OK && r->world.mark == r->mark;
    if (r->status == ORR_OK && !r->same) {
        orr_warnings warnings = {0};
        char text[1024];
        r->status = serving_world_make(&r->world, r->log, &r->cancel, &warnings, &r->diag);
        for (size_t i = 0; i < warnings.kept; i++)
            ORR_LOG(r->log, ORR_LOG_WARN, "%s", orr_diag_format(&warnings.item[i], text, sizeof text));
        orr_warnings_free(&warnings);
    }
    if (r->status != ORR_OK || r->same) serving_world_close(&r->world);
    atomic_store(&r->ended, true);
    return NULL;
}

orr_status serving_remake_begin(serving_remake *r, orr_diag *diag)
{
    r->cancel = 0;
    r->diag = (orr_diag){0};
    atomic_store(&r->ended, false);
    r->running = true; // from here on the thread's alone until it has ended
    if (pthread_create(&r->thread, NULL, remake, r) == 0) return ORR_OK;
    r->running = false;
    return orr_diag_set(diag, ORR_E_MEMORY, "no thread can be started");
}

bool serving_remake_ended(serving_remake *r)
{
    if (!r->running || !atomic_load(&r->ended)) return false;
    pthread_join(r->thread, NULL);
    r->running = false;
    return true;
}

void serving_remake_cancel(serving_remake *r)
{
    if (!r->running) return;
    r->cancel = 1;
    pthread_join(r->thread, NULL);
    r->running = false;
    serving_world_close(&r->world);
}
