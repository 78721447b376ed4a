// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are there whole or not at all: written beside their place, flushed to disk, renamed on commit.
#ifndef ORR_CORE_OUTFILE_H
#define ORR_CORE_OUTFILE_H

#include <stdio.h>

#include "core/status.h"

typedef struct orr_outfile {
    char *path;   // where it shall be
    char *temp;   // where it is being made, in the same folder
    FILE *stream; // NULL for files another library writes (ORR_OUTFILE_NAME_ONLY)
} orr_outfile;

// Opens for writing, and removes what killed processes have left of the same output. For "-" the stream is stdout and commit only flushes.
orr_status orr_outfile_open(const char *path, orr_outfile *f, orr_diag *diag);
// The same without opening: f->temp is a fresh name for a library (NetCDF) to create.
orr_status orr_outfile_reserve(const char *path, orr_outfile *f, orr_diag *diag);
// Whether the temporary can be made longer by a block; false with errno. For a library's file that is to be given up.
bool orr_outfile_takes_more(const orr_outfile *f);
// fsync and rename; on failure the temporary is gone and the old file untouched. Ends f.
orr_status orr_outfile_commit(orr_outfile *f, orr_diag *diag);
// The end of a file that was written with `status`: committed where that is ORR_OK, removed otherwise. Returns `status`, or why the
// commit failed. Ends f.
orr_status orr_outfile_end(orr_outfile *f, orr_status status, orr_diag *diag);
// Removes the temporary. Ends f; harmless after commit.
void orr_outfile_abort(orr_outfile *f);
#define ORR_OUTFILE_UNFINISHED 32
// Removes the temporaries of all files of the process that are neither committed nor aborted, for a handler
// of signals that ends the process next: it is async-signal-safe. At most ORR_OUTFILE_UNFINISHED files are
// remembered for it.
void orr_outfile_remove_unfinished(void);
// Another file that is of no use without the process (a socket's): removed with those, until it is forgotten.
// The name stays where it is meanwhile.
void orr_outfile_remember(char *name);
// Forgets a name that orr_outfile_remember was given (the same pointer); nothing happens for one it does not know,
// or NULL.
void orr_outfile_forget(char *name);

#endif
