// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/receiver/msm.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "orbit/navdata/glonass_time.h"

#define CELLS 64
#define MS_M (ORR_LIGHT_MPS * 1e-3) // a light-millisecond
#define NO_RANGE 255                // DF397: not valid
#define P2(n) ((double)(INT64_C(1) << (n)))

// Systems: their first message but one hundred each, and numbers of satellites from `first` on.
typedef struct system_row {
    char system;
    int number;        // of MSM4, less 4
    int first, n_sats; // numbers of orr_sat: `first` is DF394's 1
} system_row;

static const system_row rows[] = {{'G', 1070, 1, 63},  {'R', 1080, 1, 24}, {'E', 1090, 1, 50},
                                  {'S', 1100, 20, 39}, {'J', 1110, 1, 10}, {'C', 1120, 1, 63},
                                  {'I', 1130, 1, 14}};

// DF395 of the signals that there are (RTCM 10403.3, tables 3.5-91, -96, -99, -102, -105 and -108 with amendments 1 and 2).
static const struct {
    char name[4]; // system and RINEX 3 code
    uint8_t number;
} signals[] = {{"G1C", 2}, {"G1W", 4},  {"G2W", 10}, {"G2X", 17}, {"G5X", 24}, {"G1X", 32},
               {"R1C", 2}, {"R2C", 8},  {"E1X", 5},  {"E6X", 11}, {"E7X", 16}, {"E5X", 24},
               {"S1C", 2}, {"S5I", 22}, {"J1C", 2},  {"J2X", 17}, {"J5X", 24}, {"J1X", 32},
               {"C2I", 2}, {"C6I", 8},  {"C5X", 24}, {"C7D", 25}, {"C1X", 32}, {"I5A", 22}};

static const system_row *row_of(char system)
{
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        if (rows[k].system == system) return &rows[k];
    return NULL;
}

int orr_msm_satellite(orr_sat sat)
{
    const system_row *r = row_of(orr_sat_system(sat));
    if (r == NULL) return 0;
    const int number = orr_sat_number(sat) - r->first + 1;
    return number >= 1 && number <= r->n_sats ? number : 0;
}

int orr_msm_signal(const orr_signal *s)
{
    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++)
        if (signals[k].name[0] == s->system && strcmp(signals[k].name + 1, s->observation) == 0)
            return signals[k].number;
    return 0;
}

int orr_msm_number(char system, int msm)
{
    const system_row *r = row_of(system);
    return r == NULL ? 0 : r->number + msm;
}

uint32_t orr_msm_epoch(char system, orr_time t, const orr_leap_table *leap)
{
    int32_t week;
    int64_t ns;
    if (system == 'R') {
        orr_civil c;
        const int32_t mjd = orr_glonass_clock(t, leap, &c);
        const int day = (int)orr_floor_mod(mjd + 3, 7); // MJD 0 is a Wednesday; Sunday is 0
        const int ms = ((c.hour * 60 + c.minute) * 60 + c.second) * 1000 + c.ns / 1000000;
        return (uint32_t)day << 27 | (uint32_t)ms;
    }
    orr_time_week(system == 'C' ? orr_time_add(t, -ORR_BDT_BEHIND_GPS_NS) : t, &week, &ns);
    return (uint32_t)(ns / 1000000);
}

static int log2_of(int64_t v) // rounded down; v > 0
{
    int k = 0;
    while (v >> (k + 1) != 0) k++;
    return k;
}

unsigned orr_msm_lock4(int64_t lock_ms)
{
    if (lock_ms < 32) return 0;
    const int k = log2_of(lock_ms) - 4;
    return k > 15 ? 15 : (unsigned)k;
}

// Steps of 2^k ms, 32 of them each (table 3.5-75).
unsigned orr_msm_lock7(int64_t lock_ms)
{
    if (lock_ms < 64) return lock_ms < 0 ? 0 : (unsigned)lock_ms;
    if (lock_ms >= INT64_C(1) << 26) return 704;
    const int k = log2_of(lock_ms) - 5;
    return (unsigned)(lock_ms >> k) + 32u * (unsigned)k;
}

// A satellite's part of the message: where its cells are, and what they share.
typedef struct satellite {
    size_t from, n;
    int64_t rough;    // of 2^-10 ms; -1: not valid
    int64_t rate_mps; // whole
} satellite;

static satellite satellite_at(const orr_msm_cell *cell, size_t n, size_t from)
{
    satellite s = {.from = from};
    double least = cell[from].code_m, most = least, rate = 0;
    for (; from + s.n < n && cell[from + s.n].sat == cell[from].sat; s.n++) {
        const orr_msm_cell *x = &cell[from + s.n];
        least = fmin(least, x->code_m), most = fmax(most, x->code_m);
        rate += x->rate_mps;
    }
    const double rough = round((least + most) / 2 / MS_M * P2(10));
    s.rough = rough >= 0 && rough < NO_RANGE * P2(10) ? (int64_t)rough : -1;
    rate = round(rate / (double)s.n);
    s.rate_mps = fabs(rate) < P2(13) ? (int64_t)rate : -(INT64_C(1) << 13);
    return s;
}

static uint64_t mask_of(const orr_msm_cell *cell, const satellite *s)
{
    uint64_t mask = 0;
    for (size_t k = 0; k < s->n; k++) mask |= UINT64_C(1) << (32 - cell[s->from + k].signal);
    return mask;
}

static int ones(uint64_t v)
{
    int n = 0;
    for (; v != 0; v &= v - 1) n++;
    return n;
}

// A signed field of so many bits, whose lowest value says that there is none.
static void put_signed(orr_rtcm_frame *f, int bits, double value)
{
    const double end = P2(bits - 1);
    orr_rtcm_put(f, bits, (uint64_t)(int64_t)(fabs(value) < end ? value : -end));
}

// What is left of a range in metres beside the rough one, in units of 2^-power ms.
static void put_fine(orr_rtcm_frame *f, int bits, int power, const satellite *s, double range_m)
{
    const double ms = range_m / MS_M - (double)s->rough / P2(10);
    put_signed(f, bits, s->rough < 0 || isnan(range_m) ? (double)INFINITY : round(ms * P2(power)));
}

static void put_head(const orr_msm_head *h, const orr_msm_cell *cell, bool more, orr_rtcm_frame *f)
{
    orr_rtcm_put(f, 12, (uint64_t)orr_msm_number(orr_sat_system(cell->sat), h->msm));
    orr_rtcm_put(f, 12, h->station);
    orr_rtcm_put(f, 30, h->epoch);
    orr_rtcm_put(f, 1, more);
    orr_rtcm_put(f, 3, 0); // issue of the station's data
    orr_rtcm_put(f, 7, 0);
    orr_rtcm_put(f, 2, 0); // clock steering: none
    orr_rtcm_put(f, 2, 0); // external clock: internal
    orr_rtcm_put(f, 1, 0); // smoothing: none
    orr_rtcm_put(f, 3, 0);
}

static void put_satellites(const orr_msm_head *h, const orr_msm_cell *cell, const satellite *s, size_t n,
                           orr_rtcm_frame *f)
{
    for (size_t k = 0; k < n; k++) orr_rtcm_put(f, 8, s[k].rough < 0 ? NO_RANGE : (uint64_t)s[k].rough >> 10);
    for (size_t k = 0; h->msm == 7 && k < n; k++) {
        const orr_msm_cell *x = &cell[s[k].from];
        orr_rtcm_put(f, 4, orr_sat_system(x->sat) == 'R' ? (uint64_t)(x->channel + 7) : 0);
    }
    for (size_t k = 0; k < n; k++) orr_rtcm_put(f, 10, s[k].rough < 0 ? 0 : (uint64_t)s[k].rough & 0x3ffu);
    for (size_t k = 0; h->msm == 7 && k < n; k++) orr_rtcm_put(f, 14, (uint64_t)s[k].rate_mps);
}

// DF400 to DF403 and DF420.
static void put_cells4(const orr_msm_cell *cell, const satellite *s, size_t n, orr_rtcm_frame *f)
{
    for (int field = 0; field < 5; field++)
        for (size_t i = 0; i < n; i++)
            for (size_t k = s[i].from; k < s[i].from + s[i].n; k++) {
                if (field == 0) put_fine(f, 15, 24, &s[i], cell[k].code_m);
                if (field == 1) put_fine(f, 22, 29, &s[i], cell[k].phase_m);
                if (field == 2) orr_rtcm_put(f, 4, orr_msm_lock4(cell[k].lock_ms));
                if (field == 3) orr_rtcm_put(f, 1, 0); // whole cycles
                if (field == 4) orr_rtcm_put(f, 6, (uint64_t)fmin(fmax(round(cell[k].cn0_dbhz), 1), 63));
            }
}

// DF404 to DF408 and DF420.
static void put_cells7(const orr_msm_cell *cell, const satellite *s, size_t n, orr_rtcm_frame *f)
{
    for (int field = 0; field < 6; field++)
        for (size_t i = 0; i < n; i++)
            for (size_t k = s[i].from; k < s[i].from + s[i].n; k++) {
                if (field == 0) put_fine(f, 20, 29, &s[i], cell[k].code_m);
                if (field == 1) put_fine(f, 24, 31, &s[i], cell[k].phase_m);
                if (field == 2) orr_rtcm_put(f, 10, orr_msm_lock7(cell[k].lock_ms));
                if (field == 3) orr_rtcm_put(f, 1, 0);
                if (field == 4)
                    orr_rtcm_put(f, 10, (uint64_t)fmin(fmax(round(cell[k].cn0_dbhz * 16), 1), 1023));
                if (field == 5) put_signed(f, 15, round((cell[k].rate_mps - (double)s[i].rate_mps) * 1e4));
            }
}

size_t orr_msm_encode(const orr_msm_head *h, const orr_msm_cell *cell, size_t n, orr_rtcm_frame *frame)
{
    satellite s[CELLS];
    size_t sats = 0, used = 0;
    uint64_t mask = 0, sent = 0;
    while (used < n) {
        s[sats] = satellite_at(cell, n, used);
        const uint64_t all = mask | mask_of(cell, &s[sats]);
        if (((int)sats + 1) * ones(all) > CELLS) break;
        mask = all;
        sent |= UINT64_C(1) << (64 - cell[used].satellite);
        used += s[sats].n;
        sats++;
    }
    orr_rtcm_begin(frame);
    put_head(h, cell, h->more || used < n, frame);
    orr_rtcm_put(frame, 64, sent);
    orr_rtcm_put(frame, 32, mask);
    for (size_t i = 0; i < sats; i++) {
        const uint64_t own = mask_of(cell, &s[i]);
        for (int k = 31; k >= 0; k--)
            if (mask >> k & 1u) orr_rtcm_put(frame, 1, own >> k & 1u);
    }
    put_satellites(h, cell, s, sats, frame);
    if (h->msm == 7)
        put_cells7(cell, s, sats, frame);
    else
        put_cells4(cell, s, sats, frame);
    (void)orr_rtcm_end(frame); // 64 cells take 957 bytes
    return used;
}
