// SPDX-License-Identifier: GPL-3.0-or-later
// The table of leap seconds, counted in days and seconds alone: instants (core/time.h) stand on it.
#ifndef ORR_CORE_LEAP_H
#define ORR_CORE_LEAP_H

#include "core/status.h"

#define ORR_S_PER_DAY 86400
#define ORR_TAI_MINUS_GPS_S 19 // GPS time stands still against TAI

// Leap seconds: from each entry's UTC day on (MJD), TAI - UTC is so many seconds. The table is data; the
// built-in one carries the IERS bulletins known when it was written and says until when it is certain.
typedef struct orr_leap_entry {
    int32_t mjd;
    int32_t tai_minus_utc_s;
} orr_leap_entry;
typedef struct orr_leap_table {
    size_t n;
    const orr_leap_entry *entry; // ascending
    int32_t expires_mjd;         // no promise from this UTC day on
} orr_leap_table;

// The table that is built in; never NULL, not to be freed.
const orr_leap_table *orr_leap_builtin(void);
// Reads IERS' leap-seconds.list (NTP seconds). Entries are allocated; free with orr_leap_free. Errors: ORR_E_IO,
// ORR_E_KIND (no such list), ORR_E_FORMAT with the line, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_leap_read(const char *path, orr_leap_table *out, orr_diag *diag);
// The table that a program converts UTC by.
//   Given:    path        a leap-seconds.list that the user names; NULL: that of the system (of tzdata) where there is one
//                         that is certain for longer than the built-in one, else the built-in one
//   Returned: out         the table, to be freed with orr_leap_free
//             diag        why the user's file cannot be read (as of orr_leap_read); the system's is passed over then
orr_status orr_leap_choose(const char *path, orr_leap_table *out, orr_diag *diag);
// Frees the entries and leaves the table empty. NULL is allowed.
void orr_leap_free(orr_leap_table *t);

// TAI seconds since MJD 0 at which entry i begins.
int64_t orr_leap_entry_start(const orr_leap_table *leap, size_t i);
// The entry in force at so many TAI seconds since MJD 0; 0 also before the first.
size_t orr_leap_index_tai(const orr_leap_table *leap, int64_t tai_s);
// TAI - UTC at the start of a UTC day; the first entry's also before it.
int orr_leap_of_day(const orr_leap_table *leap, int32_t mjd);

#endif
