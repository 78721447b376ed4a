// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // renameat2, flock
#include "src/archive/store.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "core/array.h"
#include "core/process.h"

#define STAGING ".part-" // .part-DDD-HOST-PID, in the year's folder
#define HOST_TEXT 64
#define ENDING_MS 2000 // that processes of a killed batch may take to end

int32_t orr_archive_day_of(orr_time t)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_GPS, NULL, &mjd, &fraction);
    return mjd;
}

static void year_and_day(int32_t mjd, int *year, int *doy)
{
    int month, day;
    orr_date_from_mjd(mjd, year, &month, &day);
    *doy = orr_day_of_year(*year, month, day);
}

char *orr_archive_day_text(int32_t mjd, char buf[ORR_ARCHIVE_DAY_TEXT])
{
    int year, doy;
    year_and_day(mjd, &year, &doy);
    snprintf(buf, ORR_ARCHIVE_DAY_TEXT, "%04d-%03d", year, doy);
    return buf;
}

char *orr_archive_path(const char *archive, int32_t mjd, const char *file, char buf[ORR_ARCHIVE_PATH])
{
    int year, doy;
    year_and_day(mjd, &year, &doy);
    snprintf(buf, ORR_ARCHIVE_PATH, "%s/%04d/%03d%s%s", archive, year, doy, file != NULL ? "/" : "",
             file != NULL ? file : "");
    return buf;
}

static orr_status system_failed(const char *path, const char *what, orr_diag *diag)
{
    return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "%s: %s", what, strerror(errno));
}

static orr_status make_folder(const char *path, orr_diag *diag)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST ? ORR_OK : system_failed(path, "cannot be made", diag);
}

// A folder's entries are on disk. Some file systems have no such call for folders, and need none (EINVAL).
static orr_status sync_path(const char *path, orr_diag *diag)
{
    const int f = open(path, O_RDONLY | O_CLOEXEC);
    if (f < 0) return system_failed(path, "cannot be opened", diag);
    const bool done = fsync(f) == 0 || errno == EINVAL;
    const orr_status s = done ? ORR_OK : system_failed(path, "cannot be written to disk", diag);
    close(f);
    return s;
}

orr_status orr_archive_open(const char *archive, orr_diag *diag)
{
    orr_status s = make_folder(archive, diag);
    if (s == ORR_OK && access(archive, R_OK | W_OK | X_OK) != 0)
        s = system_failed(archive, "no archive can be kept there", diag);
    return s;
}

orr_status orr_archive_lock(const char *archive, int *lock, orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], holder[32] = "";
    snprintf(path, sizeof path, "%s/.lock", archive);
    *lock = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (*lock < 0) return system_failed(path, "cannot be opened", diag);
    bool held = flock(*lock, LOCK_EX | LOCK_NB) != 0;
    const ssize_t told = held ? pread(*lock, holder, sizeof holder - 1, 0) : 0;
    holder[told > 0 ? (size_t)told : 0] = '\0';
    // A batch that was killed leaves the lock to its days' processes, which end with it.
    for (int k = 0; held && k < ENDING_MS / 20 && told > 0 && !orr_process_lives(atol(holder)); k++) {
        nanosleep(&(struct timespec){.tv_nsec = 20 * 1000000}, NULL);
        held = flock(*lock, LOCK_EX | LOCK_NB) != 0;
    }
    if (held) {
        close(*lock);
        *lock = -1;
        return orr_diag_at(diag, ORR_E_LIMIT, archive, 0, 0,
                           "another batch (process %.*s) works on this archive: wait for it, or stop it",
                           (int)strcspn(holder, "\n"), told > 0 ? holder : "unknown");
    }
    const int n = snprintf(holder, sizeof holder, "%ld\n", (long)getpid());
    if (ftruncate(*lock, 0) != 0 || pwrite(*lock, holder, (size_t)n, 0) != n)
        return system_failed(path, "cannot be written", diag);
    return ORR_OK;
}

static void host_name(char host[HOST_TEXT])
{
    if (gethostname(host, HOST_TEXT) != 0) snprintf(host, HOST_TEXT, "host");
    host[HOST_TEXT - 1] = '\0';
    for (char *c = host; *c != '\0'; c++)
        if (*c == '-' || *c == '/') *c = '_';
}

orr_status orr_archive_stage(const char *archive, int32_t mjd, char staging[ORR_ARCHIVE_PATH], orr_diag *diag)
{
    char year_folder[ORR_ARCHIVE_PATH], host[HOST_TEXT];
    int year, doy;
    year_and_day(mjd, &year, &doy);
    host_name(host);
    snprintf(year_folder, sizeof year_folder, "%.900s/%04d", archive, year);
    snprintf(staging, ORR_ARCHIVE_PATH, "%.920s/" STAGING "%03d-%s-%ld", year_folder, doy, host,
             (long)getpid());
    orr_archive_remove(staging);
    orr_status s = make_folder(year_folder, diag);
    if (s == ORR_OK) s = make_folder(staging, diag);
    return s;
}

// Calls f for every entry but "." and ".."; ORR_E_IO where the folder cannot be read.
static orr_status each_entry(const char *folder, bool (*f)(void *user, const char *path, const char *name),
                             void *user, orr_diag *diag)
{
    DIR *d = opendir(folder);
    if (d == NULL) return system_failed(folder, "cannot be read", diag);
    bool good = true;
    for (struct dirent *e; good && (e = readdir(d)) != NULL;) {
        char path[ORR_ARCHIVE_PATH];
        if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0) continue;
        snprintf(path, sizeof path, "%.760s/%.255s", folder, e->d_name);
        good = f(user, path, e->d_name);
    }
    closedir(d);
    return good ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for the files of %s", folder);
}

static bool sync_one(void *user, const char *path, const char *name)
{
    (void)name;
    orr_status *s = user;
    if (*s == ORR_OK) *s = sync_path(path, NULL);
    return true;
}

orr_status orr_archive_commit(const char *archive, int32_t mjd, const char *staging, orr_diag *diag)
{
    char place[ORR_ARCHIVE_PATH], year_folder[ORR_ARCHIVE_PATH];
    orr_status synced = ORR_OK;
    orr_archive_path(archive, mjd, NULL, place);
    snprintf(year_folder, sizeof year_folder, "%.*s", (int)(strrchr(place, '/') - place), place);
    orr_status s = each_entry(staging, sync_one, &synced, diag);
    if (s == ORR_OK && synced != ORR_OK) s = system_failed(staging, "files cannot be written to disk", diag);
    if (s == ORR_OK) s = sync_path(staging, diag);
    if (s != ORR_OK) return s;
    if (rename(staging, place) != 0) {
        if (errno != EEXIST && errno != ENOTEMPTY)
            return system_failed(place, "cannot be put in place", diag);
        if (renameat2(AT_FDCWD, staging, AT_FDCWD, place, RENAME_EXCHANGE) != 0)
            return system_failed(place, "the day that is there cannot be replaced", diag);
        orr_archive_remove(staging); // the old day
    }
    return sync_path(year_folder, diag);
}

static bool remove_one(void *user, const char *path, const char *name)
{
    (void)user;
    (void)name;
    (void)unlink(path);
    return true;
}

void orr_archive_remove(const char *folder)
{
    if (each_entry(folder, remove_one, NULL, NULL) == ORR_OK) (void)rmdir(folder);
}

// Whether a name is that of a folder in which a process of this machine that has ended was making a day.
static bool is_leftover(const char *name)
{
    char host[HOST_TEXT], its_host[HOST_TEXT];
    int doy;
    long pid;
    host_name(host);
    if (sscanf(name, STAGING "%3d-%63[^-]-%ld", &doy, its_host, &pid) != 3 || strcmp(host, its_host) != 0)
        return false;
    return !orr_process_lives(pid);
}

static bool is_number(const char *name, size_t digits)
{
    return strlen(name) == digits && strspn(name, "0123456789") == digits;
}

typedef struct walk {
    bool sweep, in_year;
    orr_archive_stray *tell;
    void *user;
    int year;
    int32_t *day;
    size_t n;
} walk;

static bool visit(void *user, const char *path, const char *name)
{
    walk *w = user;
    if (!w->in_year && is_number(name, 4)) {
        w->in_year = true;
        w->year = atoi(name);
        const bool good = each_entry(path, visit, w, NULL) != ORR_E_MEMORY;
        w->in_year = false;
        return good;
    }
    if (w->in_year && is_number(name, 3) && atoi(name) >= 1 &&
        atoi(name) <= (orr_is_leap_year(w->year) ? 366 : 365)) {
        if (w->tell != NULL || w->sweep) return true;
        if (!ORR_ARRAY_GROW(w->day, w->n)) return false;
        w->day[w->n++] = orr_mjd_from_date(w->year, 1, 1) + atoi(name) - 1;
        return true;
    }
    if (!w->in_year && (strcmp(name, ".lock") == 0 || strncmp(name, "catalogue.sqlite", 16) == 0))
        return true;
    const bool leftover = w->in_year && is_leftover(name);
    if (leftover && w->sweep) orr_archive_remove(path);
    if (w->tell != NULL) w->tell(w->user, path, leftover);
    return true;
}

orr_status orr_archive_strays(const char *archive, bool sweep, orr_archive_stray *tell, void *user,
                              orr_diag *diag)
{
    walk w = {.sweep = sweep, .tell = tell, .user = user};
    const orr_status s = each_entry(archive, visit, &w, diag);
    free(w.day);
    return s;
}

static int ascending(const void *a, const void *b)
{
    const int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

orr_status orr_archive_days(const char *archive, int32_t **day, size_t *n, orr_diag *diag)
{
    walk w = {0};
    const orr_status s = each_entry(archive, visit, &w, diag);
    if (w.n > 0) qsort(w.day, w.n, sizeof *w.day, ascending);
    *day = w.day;
    *n = w.n;
    return s;
}
