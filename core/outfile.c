// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outfile.h"
#include "core/path.h"
#include "core/process.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static orr_status io_error(orr_diag *diag, const char *path, const char *verb)
{
    int e = errno;
    return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be %s: %s", verb, strerror(e));
}

// Names of temporaries, for a handler of signals: it sees the whole process, so this list is the process's.
static _Atomic(char *) unfinished[ORR_OUTFILE_UNFINISHED];

void orr_outfile_remember(char *name)
{
    for (int i = 0; i < ORR_OUTFILE_UNFINISHED; i++) {
        char *none = NULL;
        if (atomic_compare_exchange_strong(&unfinished[i], &none, name)) return;
    }
}

void orr_outfile_forget(char *name)
{
    for (int i = 0; i < ORR_OUTFILE_UNFINISHED && name != NULL; i++) {
        char *same = name;
        if (atomic_compare_exchange_strong(&unfinished[i], &same, NULL)) return;
    }
}

void orr_outfile_remove_unfinished(void)
{
    for (int i = 0; i < ORR_OUTFILE_UNFINISHED; i++) {
        const char *temp = atomic_load(&unfinished[i]);
        if (temp != NULL) unlink(temp);
    }
}

static void forget(orr_outfile *f)
{
    orr_outfile_forget(f->temp);
    free(f->path);
    free(f->temp);
    *f = (orr_outfile){0};
}

// The folder part of a path, "." if it has none. Allocated.
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    if (slash == NULL) return strdup(".");
    return strndup(path, slash == path ? 1 : (size_t)(slash - path));
}

// Whether `name` is `base` with the ending of a temporary, ".part-PID-K"; the PID then.
static bool is_temporary(const char *name, const char *base, long *pid)
{
    const size_t n = strlen(base);
    char *end;
    if (strncmp(name, base, n) != 0 || strncmp(name + n, ".part-", 6) != 0) return false;
    *pid = strtol(name + n + 6, &end, 10);
    if (*pid <= 0 || *end != '-') return false;
    const char *k = end + 1;
    return *k != '\0' && k[strspn(k, "0123456789")] == '\0';
}

// Removes what a killed process has left beside `path`: its number is nobody's here, and nobody anywhere holds its lock.
static void sweep(const char *path)
{
    char *folder = folder_of(path);
    DIR *d = folder != NULL ? opendir(folder) : NULL;
    const char *base = orr_base_name(path);
    for (const struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        long pid;
        if (!is_temporary(e->d_name, base, &pid) || orr_process_lives(pid)) continue;
        const int fd = openat(dirfd(d), e->d_name, O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
        if (fd < 0) continue;
        if (flock(fd, LOCK_EX | LOCK_NB) == 0) (void)unlinkat(dirfd(d), e->d_name, 0);
        close(fd);
    }
    if (d != NULL) closedir(d);
    free(folder);
}

// Creates a fresh file beside `path`; its descriptor, or -1 with errno. O_EXCL and the process's own umask,
// which mkstemp would not honour.
static int create_beside(const char *path, mode_t mode, char **temp)
{
    size_t size = strlen(path) + 48;
    char *name = malloc(size);
    if (name == NULL) return -1;
    int fd = -1;
    for (int k = 0; k < 1000; k++) {
        snprintf(name, size, "%s.part-%ld-%d", path, (long)getpid(), k);
        orr_outfile_remember(name); // before it is there, so that no signal falls between
        fd = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (fd >= 0) break;
        orr_outfile_forget(name);
        if (errno != EEXIST) break;
    }
    if (fd < 0) {
        int e = errno;
        free(name);
        errno = e;
        return -1;
    }
    *temp = name;
    (void)flock(fd, LOCK_EX | LOCK_NB); // as long as it is open: see sweep
    return fd;
}

// Resolves what stands at the place now. A symbolic link is followed, so that the file it names is replaced
// and not the link. *special: it exists and is no regular file (a device, a pipe), which must never be
// renamed over.
static orr_status look_at_place(orr_outfile *f, bool *special, mode_t *mode, orr_diag *diag)
{
    struct stat st;
    *special = false;
    *mode = 0666;
    if (stat(f->path, &st) != 0) return ORR_OK; // absent, or not to be seen: creation will tell
    if (S_ISDIR(st.st_mode))
        return orr_diag_at(diag, ORR_E_IO, f->path, 0, 0, "is a folder, not a file to write");
    if (!S_ISREG(st.st_mode)) {
        *special = true;
        return ORR_OK;
    }
    if (access(f->path, W_OK) != 0) return io_error(diag, f->path, "replaced");
    *mode = st.st_mode & 0777;
    char *real = realpath(f->path, NULL);
    if (real == NULL) return io_error(diag, f->path, "resolved");
    free(f->path);
    f->path = real;
    return ORR_OK;
}

static orr_status start(const char *path, bool with_stream, orr_outfile *f, orr_diag *diag)
{
    *f = (orr_outfile){0};
    if (path == NULL || *path == '\0')
        return orr_diag_set(diag, ORR_E_ARG, "the name of the file to write is empty");
    f->path = strdup(path);
    if (f->path == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory to open %s", path);
    if (strcmp(path, "-") == 0) {
        if (with_stream) {
            f->stream = stdout;
            return ORR_OK;
        }
        forget(f);
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "this kind of file cannot go to standard output; name a file");
    }
    bool special;
    mode_t mode;
    orr_status status = look_at_place(f, &special, &mode, diag);
    if (status == ORR_OK && special) {
        if (!with_stream)
            status = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "is not a regular file; this kind needs one");
        else if ((f->stream = fopen(path, "wb")) == NULL)
            status = io_error(diag, path, "opened for writing");
    } else if (status == ORR_OK) {
        sweep(f->path);
        int fd = create_beside(f->path, mode, &f->temp);
        if (fd < 0) {
            status = io_error(diag, path, "written");
        } else if (!with_stream) {
            close(fd);
        } else if ((f->stream = fdopen(fd, "wb")) == NULL) {
            status = io_error(diag, path, "opened for writing");
            close(fd);
            unlink(f->temp);
        }
    }
    if (status != ORR_OK) forget(f);
    return status;
}

orr_status orr_outfile_open(const char *path, orr_outfile *f, orr_diag *diag)
{
    return start(path, true, f, diag);
}

orr_status orr_outfile_reserve(const char *path, orr_outfile *f, orr_diag *diag)
{
    return start(path, false, f, diag);
}

bool orr_outfile_takes_more(const orr_outfile *f)
{
    static const char block[8192];
    const int fd = open(f->temp, O_WRONLY | O_APPEND | O_CLOEXEC);
    if (fd < 0) return false;
    ssize_t n = 0;
    size_t done = 0;
    while (done < sizeof block && (n = write(fd, block + done, sizeof block - done)) > 0) done += (size_t)n;
    const int e = errno;
    close(fd);
    errno = e;
    return done == sizeof block;
}

// Flushes what a library or our stream wrote down to the disk and closes it.
static orr_status finish_bytes(orr_outfile *f, orr_diag *diag)
{
    if (f->stream != NULL) {
        bool bad = ferror(f->stream) != 0;
        // errno of the write that failed is gone by now; one more tells it again.
        if (bad && write(fileno(f->stream), "\n", 1) >= 0) errno = EIO;
        bad = bad || fflush(f->stream) != 0;
        // what stands at the end of a pipe or a terminal cannot be synchronised, and need not be
        if (!bad && f->temp != NULL) bad = fsync(fileno(f->stream)) != 0;
        orr_status status = bad ? io_error(diag, f->path, "written") : ORR_OK;
        if (f->stream != stdout && fclose(f->stream) != 0 && status == ORR_OK)
            status = io_error(diag, f->path, "written");
        f->stream = NULL;
        return status;
    }
    int fd = open(f->temp, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return io_error(diag, f->path, "written");
    orr_status status = fsync(fd) != 0 ? io_error(diag, f->path, "written") : ORR_OK;
    close(fd);
    return status;
}

// Makes the renaming itself durable. Not every file system allows it; the bytes are safe by then, so no
// error.
static void sync_folder(const char *path)
{
    char *folder = folder_of(path);
    if (folder == NULL) return;
    int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
    free(folder);
}

orr_status orr_outfile_commit(orr_outfile *f, orr_diag *diag)
{
    if (f->path == NULL) return orr_diag_set(diag, ORR_E_ARG, "no file is being written");
    orr_status status = finish_bytes(f, diag);
    if (status == ORR_OK && f->temp != NULL) {
        if (rename(f->temp, f->path) != 0)
            status = io_error(diag, f->path, "put in place");
        else
            sync_folder(f->path);
    }
    if (status != ORR_OK && f->temp != NULL) unlink(f->temp);
    forget(f);
    return status;
}

orr_status orr_outfile_end(orr_outfile *f, orr_status status, orr_diag *diag)
{
    if (status == ORR_OK) return orr_outfile_commit(f, diag);
    orr_outfile_abort(f);
    return status;
}

void orr_outfile_abort(orr_outfile *f)
{
    if (f->stream != NULL && f->stream != stdout) fclose(f->stream);
    if (f->temp != NULL) unlink(f->temp);
    forget(f);
}
