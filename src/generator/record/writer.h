// SPDX-License-Identifier: GPL-3.0-or-later
// Where a stream's bytes go: a file or standard output, by a thread of its own with two buffers, so that making and writing go on
// side by side; and, where it is asked for, at the pace of the wall's clock.
#ifndef ORR_GENERATOR_RECORD_WRITER_H
#define ORR_GENERATOR_RECORD_WRITER_H

#include <stddef.h>
#include <stdint.h>

#include "src/generator/feed/fault.h"

typedef struct orr_gen_writer orr_gen_writer;

typedef struct orr_gen_written {
    uint64_t bytes;     // that are in the file, or were taken by the pipe
    uint64_t underruns; // slices of 10 ms that were written more than 1 ms late, with pace
    double latest_s;    // and how late the latest was
} orr_gen_written;

// Opens a file anew, or standard output for "-". With pace_bytes_s > 0 bytes leave at that rate from the first on.
bool orr_gen_writer_open(const char *path, double pace_bytes_s, orr_gen_writer **writer,
                         orr_gen_fault *fault);

// Waits for a buffer of at least `size` bytes that is not being written. NULL where writing has failed or there is no memory:
// orr_gen_writer_close tells why.
uint8_t *orr_gen_writer_buffer(orr_gen_writer *writer, size_t size);
// Has the first `size` bytes of that buffer written.
void orr_gen_writer_submit(orr_gen_writer *writer, size_t size);

// What has been written up to now.
orr_gen_written orr_gen_writer_done(orr_gen_writer *writer);

// Waits until all is written, closes, frees. False with a sentence where something could not be written; *written is what is
// there in either case. `abandon`: what is not written yet is given up.
bool orr_gen_writer_close(orr_gen_writer *writer, bool abandon, orr_gen_written *written,
                          orr_gen_fault *fault);

#endif
