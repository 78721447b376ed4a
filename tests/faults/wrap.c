// SPDX-License-Identifier: GPL-3.0-or-later
// Every wrapped function counts one call and does what the real one does, or fails with the errno of a full disk, a lack of memory, a lost
// connection. Streams that the program opens are made of a descriptor, whose reads and writes count too.
#define _GNU_SOURCE
#include "wrap.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

extern int __real_open(const char *path, int flags, ...);
static faults *shared;

faults *faults_share(const char *file)
{
    const int fd = file != NULL ? __real_open(file, O_RDWR) : -1;
    void *m =
        mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | (fd < 0 ? MAP_ANONYMOUS : 0), fd, 0);
    if (m == MAP_FAILED || (file != NULL && fd < 0)) abort();
    shared = m;
    return shared;
}

static bool due(const char *name, void *from)
{
    if (shared == NULL) return false;
    const long long k = atomic_fetch_add(&shared->calls, 1) + 1;
    if (k != atomic_load(&shared->fail)) return false;
    strncpy(shared->name, name, sizeof shared->name - 1);
    shared->from = (uintptr_t)from;
    atomic_fetch_add(&shared->hits, 1);
    return true;
}

// A function of the same face as the real one.
#define WRAP(type, name, parameters, arguments, failed, error)                                               \
    extern type __real_##name parameters;                                                                    \
    type __wrap_##name parameters;                                                                           \
    type __wrap_##name parameters                                                                            \
    {                                                                                                        \
        if (!due(#name, __builtin_return_address(0))) return __real_##name arguments;                        \
        errno = error;                                                                                       \
        return failed;                                                                                       \
    }

// --- Memory ---
WRAP(void *, malloc, (size_t n), (n), NULL, ENOMEM)
WRAP(void *, calloc, (size_t k, size_t n), (k, n), NULL, ENOMEM)
WRAP(void *, realloc, (void *p, size_t n), (p, n), NULL, ENOMEM)
WRAP(void *, aligned_alloc, (size_t a, size_t n), (a, n), NULL, ENOMEM)
WRAP(char *, strdup, (const char *s), (s), NULL, ENOMEM)
WRAP(char *, strndup, (const char *s, size_t n), (s, n), NULL, ENOMEM)
WRAP(FILE *, open_memstream, (char **p, size_t *n), (p, n), NULL, ENOMEM)

// --- Files ---
WRAP(ssize_t, read, (int fd, void *p, size_t n), (fd, p, n), -1, EIO)
WRAP(ssize_t, write, (int fd, const void *p, size_t n), (fd, p, n), -1, ENOSPC)
WRAP(ssize_t, pread, (int fd, void *p, size_t n, off_t at), (fd, p, n, at), -1, EIO)
WRAP(ssize_t, pwrite, (int fd, const void *p, size_t n, off_t at), (fd, p, n, at), -1, ENOSPC)
WRAP(int, fsync, (int fd), (fd), -1, EIO)
WRAP(int, rename, (const char *a, const char *b), (a, b), -1, ENOSPC)
WRAP(int, mkdir, (const char *p, mode_t m), (p, m), -1, ENOSPC)
WRAP(DIR *, opendir, (const char *p), (p), NULL, EMFILE)
WRAP(int, ftruncate, (int fd, off_t n), (fd, n), -1, EIO)
WRAP(int, dup, (int fd), (fd), -1, EMFILE)

int __wrap_open(const char *path, int flags, ...);
int __wrap_open(const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? (mode_t)va_arg(args, unsigned) : 0;
    va_end(args);
    if (!due("open", __builtin_return_address(0))) return __real_open(path, flags, mode);
    errno = EMFILE;
    return -1;
}

// --- Streams ---
static ssize_t stream_read(void *cookie, char *data, size_t n)
{
    if (!due("fread", NULL)) return __real_read((int)(intptr_t)cookie, data, n);
    errno = EIO;
    return -1;
}

static ssize_t stream_write(void *cookie, const char *data, size_t n)
{
    if (!due("fwrite", NULL)) return __real_write((int)(intptr_t)cookie, data, n);
    errno = ENOSPC;
    return 0; // as a stream tells a failure
}

static int stream_seek(void *cookie, off64_t *at, int whence)
{
    const off_t to = lseek((int)(intptr_t)cookie, *at, whence);
    if (to < 0) return -1;
    *at = to;
    return 0;
}

enum { STREAMS = 256 };
static struct {
    FILE *stream;
    int fd;
} opened[STREAMS];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static int remember(FILE *stream, int fd, bool forget)
{
    int found = -1;
    pthread_mutex_lock(&lock);
    for (int k = 0; k < STREAMS && found < 0; k++)
        if (opened[k].stream == (fd >= 0 ? NULL : stream)) {
            if (fd >= 0) {
                opened[k].stream = stream;
                opened[k].fd = fd;
            }
            found = opened[k].fd;
            if (forget) opened[k].stream = NULL;
        }
    pthread_mutex_unlock(&lock);
    return found;
}

static int stream_close(void *cookie) { return close((int)(intptr_t)cookie); }

static FILE *stream_of(int fd, const char *mode)
{
    FILE *f = fopencookie((void *)(intptr_t)fd, mode,
                          (cookie_io_functions_t){stream_read, stream_write, stream_seek, stream_close});
    if (f != NULL) remember(f, fd, false);
    return f;
}

FILE *__wrap_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode)
{
    const bool plus = strchr(mode, '+') != NULL;
    const int how = mode[0] == 'r'   ? (plus ? O_RDWR : O_RDONLY)
                    : mode[0] == 'w' ? (plus ? O_RDWR : O_WRONLY) | O_CREAT | O_TRUNC
                                     : (plus ? O_RDWR : O_WRONLY) | O_CREAT | O_APPEND;
    if (due("fopen", __builtin_return_address(0))) {
        errno = EMFILE;
        return NULL;
    }
    const int fd = __real_open(path, how | O_CLOEXEC, 0666);
    FILE *f = fd >= 0 ? stream_of(fd, mode) : NULL;
    if (fd >= 0 && f == NULL) close(fd);
    return f;
}

FILE *__wrap_fdopen(int fd, const char *mode);
FILE *__wrap_fdopen(int fd, const char *mode)
{
    if (!due("fdopen", __builtin_return_address(0))) return stream_of(fd, mode);
    errno = ENOMEM;
    return NULL;
}

extern int __real_fileno(FILE *f);
int __wrap_fileno(FILE *f);
int __wrap_fileno(FILE *f)
{
    const int fd = remember(f, -1, false);
    return fd >= 0 ? fd : __real_fileno(f);
}

extern int __real_fclose(FILE *f);
int __wrap_fclose(FILE *f);
int __wrap_fclose(FILE *f)
{
    remember(f, -1, true);
    return __real_fclose(f);
}

// Standard output counts its writes as other streams do.
void faults_count_stdout(void);
void faults_count_stdout(void)
{
    FILE *f = stream_of(STDOUT_FILENO, "w");
    if (f != NULL) stdout = f;
}

// --- Sockets ---
WRAP(int, socket, (int d, int t, int p), (d, t, p), -1, EMFILE)
WRAP(int, bind, (int fd, const struct sockaddr *a, socklen_t n), (fd, a, n), -1, EADDRNOTAVAIL)
WRAP(int, listen, (int fd, int n), (fd, n), -1, EADDRINUSE)
WRAP(int, connect, (int fd, const struct sockaddr *a, socklen_t n), (fd, a, n), -1, ECONNREFUSED)
WRAP(int, accept, (int fd, struct sockaddr *a, socklen_t *n), (fd, a, n), -1, EMFILE)
WRAP(int, accept4, (int fd, struct sockaddr *a, socklen_t *n, int f), (fd, a, n, f), -1, EMFILE)
WRAP(ssize_t, send, (int fd, const void *p, size_t n, int f), (fd, p, n, f), -1, ECONNRESET)
WRAP(ssize_t, recv, (int fd, void *p, size_t n, int f), (fd, p, n, f), -1, ECONNRESET)
WRAP(int, setsockopt, (int fd, int l, int o, const void *p, socklen_t n), (fd, l, o, p, n), -1, ENOBUFS)
WRAP(int, pipe, (int fd[2]), (fd), -1, EMFILE)
WRAP(int, pipe2, (int fd[2], int f), (fd, f), -1, EMFILE)
WRAP(int, eventfd, (unsigned n, int f), (n, f), -1, EMFILE)

// --- Libraries: what makes or takes something of theirs ---
struct event_base;
struct event;
struct evbuffer;
struct timeval;
typedef struct ssl_st SSL;
typedef struct ssl_ctx_st SSL_CTX;
typedef struct evp_md_ctx_st EVP_MD_CTX;
WRAP(struct event_base *, event_base_new, (void), (), NULL, ENOMEM)
WRAP(struct event *, event_new,
     (struct event_base * b, int fd, short what, void (*f)(int, short, void *), void *user),
     (b, fd, what, f, user), NULL, ENOMEM)
WRAP(int, event_add, (struct event * e, const struct timeval *t), (e, t), -1, ENOMEM)
WRAP(struct evbuffer *, evbuffer_new, (void), (), NULL, ENOMEM)
WRAP(SSL *, SSL_new, (SSL_CTX * c), (c), NULL, ENOMEM)
WRAP(EVP_MD_CTX *, EVP_MD_CTX_new, (void), (), NULL, ENOMEM)
WRAP(int, pthread_create, (pthread_t * t, const pthread_attr_t *a, void *(*f)(void *), void *user),
     (t, a, f, user), EAGAIN, EAGAIN)
WRAP(void *, gsl_vector_alloc, (size_t n), (n), NULL, ENOMEM)
WRAP(void *, gsl_vector_calloc, (size_t n), (n), NULL, ENOMEM)
WRAP(void *, gsl_matrix_calloc, (size_t n, size_t m), (n, m), NULL, ENOMEM)
WRAP(void *, gsl_matrix_alloc, (size_t n, size_t m), (n, m), NULL, ENOMEM)
WRAP(void *, json_object, (void), (), NULL, ENOMEM)
WRAP(void *, json_array, (void), (), NULL, ENOMEM)
WRAP(void *, json_string, (const char *s), (s), NULL, ENOMEM)
WRAP(void *, json_real, (double x), (x), NULL, ENOMEM)
WRAP(void *, json_integer, (long long x), (x), NULL, ENOMEM)
// NetCDF's own number of EIO is the negative errno.
WRAP(int, nc_create, (const char *p, int m, int *id), (p, m, id), EMFILE, EMFILE)
WRAP(int, nc_open, (const char *p, int m, int *id), (p, m, id), EMFILE, EMFILE)
WRAP(int, nc_put_var, (int id, int v, const void *p), (id, v, p), -101 /* NC_EHDFERR */, EIO)
WRAP(int, nc_get_var_double, (int id, int v, double *p), (id, v, p), -101, EIO)

// A file that could not be closed well is closed all the same.
extern int __real_nc_close(int id);
int __wrap_nc_close(int id);
int __wrap_nc_close(int id)
{
    const int closed = __real_nc_close(id);
    return due("nc_close", __builtin_return_address(0)) ? -101 : closed;
}
