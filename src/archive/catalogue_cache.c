// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/catalogue_cache.h"

#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/nan.h"
#include "src/archive/store.h"

#define VERSION 1 // of the tables; a file of another is made anew
#define PATIENCE_MS 5000

struct orr_catalogue_cache {
    sqlite3 *db;
    char path[ORR_ARCHIVE_PATH];
};

static const char TABLES[] = "CREATE TABLE IF NOT EXISTS day(day TEXT PRIMARY KEY, mjd INTEGER, state TEXT, "
                             "program TEXT, key TEXT, bytes INTEGER, "
                             "satellites INTEGER, nodes INTEGER, left_out INTEGER, manoeuvres INTEGER, gaps "
                             "INTEGER, residual_mm REAL, sigma_mm REAL, "
                             "joint_mm REAL, joint_mps REAL, notes INTEGER, suspicion TEXT);"
                             "CREATE TABLE IF NOT EXISTS joint(a TEXT, b TEXT, satellites INTEGER, median_mm "
                             "REAL, max_mm REAL, max_mps REAL, "
                             "max_sat INTEGER, PRIMARY KEY(a, b));";

static int version_of(sqlite3 *db)
{
    sqlite3_stmt *q;
    int version = -1;
    if (sqlite3_prepare_v2(db, "PRAGMA user_version", -1, &q, NULL) != SQLITE_OK) return -1;
    if (sqlite3_step(q) == SQLITE_ROW) version = sqlite3_column_int(q, 0);
    sqlite3_finalize(q);
    return version;
}

// Opens the file; false where it is no such database, or of another version.
static bool try_open(orr_catalogue_cache *c)
{
    char version[64];
    if (sqlite3_open_v2(c->path, &c->db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, NULL) != SQLITE_OK)
        return false;
    sqlite3_busy_timeout(c->db, PATIENCE_MS);
    const int found = version_of(c->db);
    if (found != 0 && found != VERSION) return false;
    snprintf(version, sizeof version, "PRAGMA user_version=%d", VERSION);
    return sqlite3_exec(c->db, "BEGIN", NULL, NULL, NULL) == SQLITE_OK &&
           sqlite3_exec(c->db, TABLES, NULL, NULL, NULL) == SQLITE_OK &&
           sqlite3_exec(c->db, version, NULL, NULL, NULL) == SQLITE_OK;
}

orr_catalogue_cache *orr_catalogue_cache_open(const char *archive, orr_warnings *warnings)
{
    orr_catalogue_cache *c = calloc(1, sizeof *c);
    if (c == NULL) return NULL;
    snprintf(c->path, sizeof c->path, "%.900s/" ORR_CATALOGUE_FILE, archive);
    if (try_open(c)) return c;
    sqlite3_close(c->db);
    c->db = NULL;
    if (access(c->path, F_OK) == 0 && unlink(c->path) == 0) {
        orr_warnings_add(warnings, c->path, 0, 0,
                         "was damaged or of another version, and is made anew from the days");
        if (try_open(c)) return c;
        sqlite3_close(c->db);
    }
    orr_warnings_add(warnings, c->path, 0, 0, "cannot be kept: joints are measured each time");
    free(c);
    return NULL;
}

void orr_catalogue_cache_close(orr_catalogue_cache *c, orr_warnings *warnings)
{
    if (c == NULL) return;
    if (sqlite3_exec(c->db, "COMMIT", NULL, NULL, NULL) != SQLITE_OK)
        orr_warnings_add(warnings, c->path, 0, 0, "was not kept: %s", sqlite3_errmsg(c->db));
    sqlite3_close(c->db);
    free(c);
}

static double real(sqlite3_stmt *q, int column)
{
    return sqlite3_column_type(q, column) == SQLITE_NULL ? ORR_NAN : sqlite3_column_double(q, column);
}

bool orr_catalogue_cache_joint(orr_catalogue_cache *c, const char *a, const char *b, orr_catalogue_joint *out)
{
    sqlite3_stmt *q;
    if (c == NULL ||
        sqlite3_prepare_v2(
            c->db, "SELECT satellites, median_mm, max_mm, max_mps, max_sat FROM joint WHERE a=? AND b=?", -1,
            &q, NULL) != SQLITE_OK)
        return false;
    sqlite3_bind_text(q, 1, a, -1, SQLITE_STATIC);
    sqlite3_bind_text(q, 2, b, -1, SQLITE_STATIC);
    const bool known = sqlite3_step(q) == SQLITE_ROW;
    if (known)
        *out = (orr_catalogue_joint){.satellites = (size_t)sqlite3_column_int64(q, 0),
                                     .median_mm = real(q, 1),
                                     .max_mm = real(q, 2),
                                     .max_mps = real(q, 3),
                                     .max_sat = (orr_sat)sqlite3_column_int(q, 4)};
    sqlite3_finalize(q);
    return known;
}

// Inserts one row; a failure leaves the row out, and it is measured again next time.
static void insert(sqlite3_stmt *q)
{
    (void)sqlite3_step(q);
    sqlite3_finalize(q);
}

static void bind_real(sqlite3_stmt *q, int at, double v)
{
    if (isfinite(v)) sqlite3_bind_double(q, at, v); // unbound is NULL
}

void orr_catalogue_cache_keep(orr_catalogue_cache *c, const char *a, const char *b,
                              const orr_catalogue_joint *joint)
{
    sqlite3_stmt *q;
    if (c == NULL || sqlite3_prepare_v2(c->db, "INSERT OR REPLACE INTO joint VALUES(?,?,?,?,?,?,?)", -1, &q,
                                        NULL) != SQLITE_OK)
        return;
    sqlite3_bind_text(q, 1, a, -1, SQLITE_STATIC);
    sqlite3_bind_text(q, 2, b, -1, SQLITE_STATIC);
    sqlite3_bind_int64(q, 3, (sqlite3_int64)joint->satellites);
    bind_real(q, 4, joint->median_mm);
    bind_real(q, 5, joint->max_mm);
    bind_real(q, 6, joint->max_mps);
    sqlite3_bind_int(q, 7, joint->max_sat);
    insert(q);
}

void orr_catalogue_cache_days(orr_catalogue_cache *c, const orr_catalogue *days)
{
    if (c == NULL || sqlite3_exec(c->db, "DELETE FROM day", NULL, NULL, NULL) != SQLITE_OK) return;
    for (size_t i = 0; i < days->n; i++) {
        const orr_catalogue_day *d = &days->day[i];
        char name[ORR_ARCHIVE_DAY_TEXT];
        sqlite3_stmt *q;
        if (sqlite3_prepare_v2(c->db, "INSERT INTO day VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)", -1, &q,
                               NULL) != SQLITE_OK)
            return;
        sqlite3_bind_text(q, 1, orr_archive_day_text(d->mjd, name), -1, SQLITE_TRANSIENT);
        sqlite3_bind_int(q, 2, d->mjd);
        sqlite3_bind_text(q, 3, orr_catalogue_state(d), -1, SQLITE_STATIC);
        sqlite3_bind_text(q, 4, d->program, -1, SQLITE_STATIC);
        sqlite3_bind_text(q, 5, d->key, -1, SQLITE_STATIC);
        const sqlite3_int64 count[] = {d->bytes,
                                       (sqlite3_int64)d->all.satellites,
                                       (sqlite3_int64)d->all.nodes,
                                       (sqlite3_int64)d->all.left_out,
                                       (sqlite3_int64)d->all.manoeuvres,
                                       (sqlite3_int64)d->all.gaps};
        for (int k = 0; k < 6; k++) sqlite3_bind_int64(q, 6 + k, count[k]);
        const double value[] = {d->all.residual_mm, d->all.sigma_mm, d->joint.max_mm, d->joint.max_mps};
        for (int k = 0; k < 4; k++) bind_real(q, 12 + k, value[k]);
        sqlite3_bind_int64(q, 16, (sqlite3_int64)d->n_notes);
        sqlite3_bind_text(q, 17, d->suspicion, -1, SQLITE_STATIC);
        insert(q);
    }
}
