// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of a file's bytes, for provenance and the fetch index (libcrypto).
#ifndef ORR_CORE_SHA256_H
#define ORR_CORE_SHA256_H

#include <stdio.h>

#include "core/status.h"

#define ORR_SHA256_HEX 65
// Hexadecimal digits of the SHA-256 of a file's bytes. ORR_E_IO where it cannot be read.
orr_status orr_sha256_file(const char *path, char hex[ORR_SHA256_HEX], orr_diag *diag);
// The same of an open file from its begin on; `name` is for messages. Where it stands afterwards is not told.
orr_status orr_sha256_stream(FILE *f, const char *name, char hex[ORR_SHA256_HEX], orr_diag *diag);
// The same of n bytes in memory.
orr_status orr_sha256_bytes(const void *data, size_t n, char hex[ORR_SHA256_HEX], orr_diag *diag);

#endif
