// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of a made constellation, for tests of channels and of what befalls them: one engine at a time.
#ifndef ORR_TESTS_MADE_CHANNELS_H
#define ORR_TESTS_MADE_CHANNELS_H

#include "src/scenario/channel/channel.h"
#include "src/scenario/engine/engine.h"

// Each test program has files of its own.
#define MADE_PRODUCT ORR_BINARY_DIR "/" ORR_TEST_NAME "_channels.nc"
#define MADE_IONOSPHERE ORR_BINARY_DIR "/" ORR_TEST_NAME "_channels.ION"
enum { ROOM = 600 };

extern orr_engine *engine;
extern orr_channel_work *work;

// Makes the files: a group's set-up.
int set_up(void **state);
// Closes the engine: a test's tear-down.
int tear_down(void **state);
// Opens an engine of the made orbits and of `rest`, YAML; without broadcast data unless `rest` has navdata.
void open_with(const char *rest);
// Fails unless that is refused with a sentence that holds `words`.
void refused_with(const char *rest, const char *words);
// So many seconds after the made day's midnight.
orr_time at(double t_s);
// All channels of an antenna at t; their number.
size_t all_at(orr_time t, size_t antenna, orr_channel out[ROOM]);
// The channel of a satellite's signal ("L1CA") at t; fails where there is none.
orr_channel one_at(orr_time t, const char *sat, const char *signal);

#endif
