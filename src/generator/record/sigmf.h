// SPDX-License-Identifier: GPL-3.0-or-later
// Metadata of a recording as SigMF 1.2 has it: rate, format and centre, when its first sample was, which satellites are in it.
#ifndef ORR_GENERATOR_RECORD_SIGMF_H
#define ORR_GENERATOR_RECORD_SIGMF_H

#include "src/generator/play/stream.h"

typedef struct orr_gen_recording {
    const orr_gen_service *service;
    const orr_gen_stream *stream;
    const char *antenna, *data_name; // data_name: of the file of samples, without folders
    int64_t first;                   // number of its first sample
    uint64_t samples;                // that are in the file
    bool complete;                   // whether these are all that was asked for
    uint64_t clipped, underruns;
} orr_gen_recording;

// Writes PATH anew: beside it and renamed, so that there is a whole one at any time. errno says why it failed.
bool orr_gen_sigmf_write(const char *path, const orr_gen_recording *recording, orr_gen_fault *fault);

#endif
