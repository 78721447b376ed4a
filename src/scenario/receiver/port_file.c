// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/receiver/port_file.h"

#include <errno.h>

#include "core/outfile.h"

typedef struct writer {
    const orr_observe_plan *plan;
    orr_port_file *file;
    size_t n;
    orr_observer *observer;
    orr_port *port[ORR_PORT_FILES];
    orr_outfile out[ORR_PORT_FILES];
    orr_port_bytes bytes;
} writer;

static orr_status write_epoch(writer *w, orr_time t, orr_diag *diag)
{
    orr_observed o;
    orr_status s = orr_observer_at(w->observer, t, &o, diag);
    for (size_t k = 0; s == ORR_OK && k < w->n; k++) {
        w->bytes.n = 0;
        s = orr_port_epoch(w->port[k], &o, &w->bytes, diag);
        if (s != ORR_OK) break;
        w->file[k].bytes += w->bytes.n;
        if (fwrite(w->bytes.data, 1, w->bytes.n, w->out[k].stream) != w->bytes.n)
            s = orr_diag_at(diag, ORR_E_IO, w->file[k].path, 0, 0, "cannot be written: %s", strerror(errno));
    }
    return s;
}

static orr_status open_all(writer *w, orr_diag *diag)
{
    const orr_observe_plan *p = w->plan;
    const orr_port_plan *first = &w->file[0].plan;
    orr_status s = orr_observer_open(first->channels, first->antenna, p->noise, p->seed, &w->observer, diag);
    for (size_t k = 0; s == ORR_OK && k < w->n; k++) {
        w->file[k].bytes = 0;
        if (!orr_port_takes(w->file[k].plan.format, p->from, p->step_ns))
            return orr_diag_set(
                diag, ORR_E_ARG,
                "RTCM counts whole milliseconds: take --from and --step (or --rate) that lie on them");
        s = orr_port_open(&w->file[k].plan, &w->port[k], diag);
        if (s == ORR_OK) s = orr_outfile_open(w->file[k].path, &w->out[k], diag);
    }
    return s;
}

orr_status orr_port_files(const orr_observe_plan *plan, orr_port_file *file, size_t n, orr_diag *diag)
{
    writer w = {.plan = plan, .file = file, .n = n};
    orr_status s = open_all(&w, diag);
    const size_t total = (size_t)((plan->to - plan->from) / plan->step_ns) + 1;
    for (size_t k = 0; s == ORR_OK && k < total; k++) {
        if (plan->cancel != NULL && *plan->cancel) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        if (s == ORR_OK) s = write_epoch(&w, orr_time_add(plan->from, (int64_t)k * plan->step_ns), diag);
        if (plan->progress != NULL) plan->progress(plan->user, k + 1, total);
    }
    for (size_t k = 0; k < n; k++) {
        if (s == ORR_OK) s = orr_outfile_commit(&w.out[k], diag);
        orr_outfile_abort(&w.out[k]); // harmless after commit
        orr_port_close(w.port[k]);
    }
    orr_observer_close(w.observer);
    free(w.bytes.data);
    return s;
}
