// SPDX-License-Identifier: GPL-3.0-or-later
// The table of archives.txt, put into the program by the build.
#include "ingest/fetch/archives.h"

extern const char orr_archives_text[]; // made by cmake/OrrEmbed.cmake
extern const size_t orr_archives_text_n;

const char *orr_archives_builtin(size_t *n)
{
    *n = orr_archives_text_n;
    return orr_archives_text;
}
