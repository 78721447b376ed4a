// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/access.h"

#include <errno.h>
#include <grp.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// What an access file says, ready for use.
typedef struct rules {
    orr_access_file file;
    SSL_CTX *tls; // NULL: there is no certificate
} rules;

struct orr_access {
    pthread_mutex_t lock;
    char *path;
    bool insecure;
    unsigned at_most;
    rules now;
    bool in_the_open; // an address that other machines reach is listened on without TLS
    atomic_uint edition;
};

static void drop(rules *r)
{
    SSL_CTX_free(r->tls);
    orr_schema_free(orr_access_schema(), &r->file);
    *r = (rules){.tls = NULL};
}

static orr_status load(const char *path, rules *out, orr_diag *diag)
{
    *out = (rules){.tls = NULL};
    orr_status s =
        path != NULL ? orr_access_read(path, &out->file, diag) : orr_access_defaults(&out->file, diag);
    if (s != ORR_OK || out->file.certificate == NULL) return s;
    const orr_tls_files files = {out->file.certificate, out->file.key, out->file.authority};
    s = orr_tls_context(&files, true, &out->tls, diag);
    if (s != ORR_OK) drop(out);
    return s;
}

orr_status orr_access_open(const char *path, bool insecure, unsigned at_most, orr_access **out,
                           orr_diag *diag)
{
    orr_access *a = calloc(1, sizeof *a);
    if (a == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    pthread_mutex_init(&a->lock, NULL);
    a->insecure = insecure;
    atomic_init(&a->edition, 1);
    a->at_most = at_most;
    a->path = path != NULL ? strdup(path) : NULL;
    orr_status s = path != NULL && a->path == NULL ? orr_diag_set(diag, ORR_E_MEMORY, "out of memory")
                                                   : load(path, &a->now, diag);
    if (s != ORR_OK) {
        orr_access_close(a);
        return s;
    }
    *out = a;
    return ORR_OK;
}

void orr_access_close(orr_access *a)
{
    if (a == NULL) return;
    drop(&a->now);
    pthread_mutex_destroy(&a->lock);
    free(a->path);
    free(a);
}

orr_status orr_access_reload(orr_access *a, orr_diag *diag)
{
    rules fresh;
    const orr_status s = load(a->path, &fresh, diag);
    if (s != ORR_OK) return s;
    pthread_mutex_lock(&a->lock);
    if (a->now.tls != NULL && fresh.tls == NULL) { // who listens with TLS would have nothing to say
        pthread_mutex_unlock(&a->lock);
        drop(&fresh);
        return orr_diag_at(diag, ORR_E_FORMAT, a->path, 0, 0,
                           "names no certificate any more, and clients come by TLS");
    }
    if (a->in_the_open && !a->insecure && !fresh.file.insecure_listen) {
        pthread_mutex_unlock(&a->lock);
        drop(&fresh);
        return orr_diag_at(
            diag, ORR_E_FORMAT, a->path, 0, 0,
            "has no insecure_listen any more, and an address is listened on without TLS: stop the "
            "service and start it by tls://");
    }
    rules old = a->now;
    a->now = fresh;
    pthread_mutex_unlock(&a->lock);
    atomic_fetch_add(&a->edition, 1);
    drop(&old);
    return ORR_OK;
}

unsigned orr_access_edition(const orr_access *a) { return atomic_load(&a->edition); }

orr_status orr_access_listen(orr_access *a, const orr_url *bound, orr_diag *diag)
{
    char text[ORR_URL_TEXT];
    orr_url_text(bound, text);
    pthread_mutex_lock(&a->lock);
    const bool has_tls = a->now.tls != NULL, insecure = a->insecure || a->now.file.insecure_listen;
    const bool in_the_open = !bound->tls && !orr_url_is_local(bound);
    if (in_the_open && insecure) a->in_the_open = true;
    pthread_mutex_unlock(&a->lock);
    if (bound->tls && !has_tls)
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s: there is no certificate: 'orrery tls init DIR' makes them, then --access "
                            "DIR/access.yaml",
                            text);
    if (!in_the_open || insecure) return ORR_OK;
    return orr_diag_set(
        diag, ORR_E_ARG,
        "%s can be reached from other machines: listen there by tls:// ('orrery tls init DIR' "
        "makes certificates), or say insecure_listen: true (--insecure-listen), and whoever "
        "reaches it may do everything",
        text);
}

orr_status orr_access_give(orr_access *a, const orr_url *bound, orr_diag *diag)
{
    orr_status s = ORR_OK;
    pthread_mutex_lock(&a->lock);
    const char *name = a->now.file.group;
    if (bound->is_unix && name != NULL) {
        char room[4096];
        struct group g, *found = NULL;
        const int error = getgrnam_r(name, &g, room, sizeof room, &found);
        if (found == NULL)
            s = orr_diag_set(diag, ORR_E_ARG, "group: there is no group '%s'%s%s", name,
                             error != 0 ? ": " : "", error != 0 ? strerror(error) : "");
        else if (chown(bound->path, (uid_t)-1, g.gr_gid) != 0)
            s = orr_diag_set(diag, ORR_E_IO, "unix:%s cannot be given to the group '%s': %s", bound->path,
                             name, strerror(errno));
    }
    pthread_mutex_unlock(&a->lock);
    return s;
}

unsigned orr_access_plain(const orr_access *a) { return a->at_most; }

unsigned orr_access_named(orr_access *a, const char *name)
{
    unsigned may = ORR_MAY_NOTHING;
    pthread_mutex_lock(&a->lock);
    const orr_access_file *f = &a->now.file;
    for (size_t k = 0; k < f->clients.n; k++) {
        const orr_access_client *c = &f->clients.item[k];
        if (strcmp(c->name, name) != 0) continue;
        for (size_t j = 0; j < c->may.n; j++) may |= (unsigned)c->may.item[j];
    }
    pthread_mutex_unlock(&a->lock);
    return may & a->at_most;
}

SSL_CTX *orr_access_tls(orr_access *a)
{
    pthread_mutex_lock(&a->lock);
    SSL_CTX *c = a->now.tls;
    if (c != NULL && SSL_CTX_up_ref(c) != 1) c = NULL;
    pthread_mutex_unlock(&a->lock);
    return c;
}

orr_access_limits orr_access_limits_of(orr_access *a)
{
    pthread_mutex_lock(&a->lock);
    const orr_access_limits limits = a->now.file.limits;
    pthread_mutex_unlock(&a->lock);
    return limits;
}
