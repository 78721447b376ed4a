// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/sbas_bits.h"

#include "orbit/navdata/geo_fields.h"

#define MESSAGE 250 // bits
#define FIRST 13    // places of the mask in a message of fast corrections
#define MASK 210
#define MONITORED 0 // UDREI 0: below 0.75 m, 3.29 sigma
#define NOT_MONITORED 14
#define DO_NOT_USE 15
#define IODP 0 // the mask never changes
#define IODI 0
#define DAY_S 86400

// Places of the mask: PRN of the k-th satellite that is corrected, from 0 on; 0 behind the last.
static int prn_at(const orr_sbas_told *d, int k)
{
    for (int prn = 1; prn <= ORR_SBAS_CORRECTED; prn++)
        if (d->corrected[prn - 1] && k-- == 0) return prn;
    return 0;
}

static uint64_t udrei_at(const orr_sbas_told *d, int k)
{
    const int prn = prn_at(d, k);
    return prn == 0 ? NOT_MONITORED : d->healthy[prn - 1] ? MONITORED : DO_NOT_USE;
}

static int64_t seconds(orr_time t) { return orr_floor_div(t, ORR_NS_PER_S); }

// Issue of the fast corrections that were sent last: they are sent every six seconds and counted 0, 1, 2 (A.4.4.3).
static uint64_t iodf_at(int64_t s) { return (uint64_t)orr_floor_mod(orr_floor_div(s, 6), 3); }

static void mask(const orr_sbas_told *d, orr_page *p)
{
    for (int k = 0; k < MASK; k++) orr_page_put(p, 1, k < ORR_SBAS_CORRECTED && d->corrected[k]);
    orr_page_put(p, 2, IODP);
}

static void fast(const orr_sbas_told *d, int message, orr_page *p)
{
    const int first = (message - ORR_SBAS_FAST_FIRST) * FIRST;
    orr_page_put(p, 2, iodf_at(seconds(d->t)));
    orr_page_put(p, 2, IODP);
    orr_page_zeros(p, 12 * FIRST);
    for (int k = 0; k < FIRST; k++) orr_page_put(p, 4, udrei_at(d, first + k));
}

// Messages 2, 3 and 4 begin at seconds 0, 2 and 4 of six; of message 5 nothing is sent.
static void integrity(const orr_sbas_told *d, orr_page *p)
{
    const int64_t s = seconds(d->t);
    for (int j = 0; j < 3; j++) orr_page_put(p, 2, iodf_at(s - 2 * j));
    orr_page_zeros(p, 2);
    for (int k = 0; k < 51; k++) orr_page_put(p, 4, udrei_at(d, k));
}

static void fast_aging(orr_page *p)
{
    orr_page_zeros(p, 4); // system latency
    orr_page_put(p, 2, IODP);
    orr_page_zeros(p, 2 + 4 * 51);
}

static uint64_t time_of_day(orr_time t, int step_s)
{
    return (uint64_t)(orr_floor_mod(seconds(t), DAY_S) / step_s);
}

// The URA index of SBAS is GPS' (A.4.4.11).
static void ephemeris(const orr_sbas_told *d, orr_page *p)
{
    const orr_nav_eph *e = d->eph;
    const orr_nav_geo *g = &e->geo;
    const double value[3][3] = {{g->pos_m.x, g->pos_m.y, g->pos_m.z},
                                {g->vel_mps.x, g->vel_mps.y, g->vel_mps.z},
                                {g->acc_mps2.x, g->acc_mps2.y, g->acc_mps2.z}};
    orr_page_zeros(p, 8);
    orr_page_put(p, 13, time_of_day(e->toe, 16));
    orr_page_put(p, 4, e->health != 0 ? 15 : (uint64_t)orr_nav_ura_index(g->ura_m));
    for (int order = 0; order < 3; order++)
        for (int axis = 0; axis < 3; axis++)
            orr_page_value(p, &orr_geo_fields[axis][order], value[order][axis]);
    orr_page_value(p, &orr_geo_clock[0], e->af0_s);
    orr_page_value(p, &orr_geo_clock[1], e->af1_sps);
}

// Who operates a satellite, by PRN (DO-229E table A-21 names the providers, the L1 C/A PRN code assignments of the US Space Force
// their satellites); 15 for all others.
static uint64_t provider_of(int prn)
{
    enum { WAAS, EGNOS, MSAS, GAGAN, SDCM, BDSBAS, KASS, OTHER = 15 };
    static const struct {
        uint8_t prn, provider;
    } satellites[] = {{120, EGNOS}, {121, EGNOS}, {123, EGNOS},  {124, EGNOS},  {125, SDCM}, {126, EGNOS},
                      {127, GAGAN}, {128, GAGAN}, {129, MSAS},   {130, BDSBAS}, {131, WAAS}, {132, GAGAN},
                      {133, WAAS},  {134, KASS},  {135, WAAS},   {136, EGNOS},  {137, MSAS}, {138, WAAS},
                      {140, SDCM},  {141, SDCM},  {143, BDSBAS}, {144, BDSBAS}};
    for (size_t k = 0; k < sizeof satellites / sizeof *satellites; k++)
        if (satellites[k].prn == prn) return satellites[k].provider;
    return OTHER;
}

// Table A-19: position in 2600 m and 26 000 m, velocity in 10 and 60 m/s.
static void almanac(const orr_sbas_told *d, orr_page *p)
{
    static const orr_navfit_field field[] = {ORR_SIGNED("x", 2600, 15), ORR_SIGNED("y", 2600, 15),
                                             ORR_SIGNED("z", 26000, 9), ORR_SIGNED("vx", 10, 3),
                                             ORR_SIGNED("vy", 10, 3),   ORR_SIGNED("vz", 60, 4)};
    for (int k = 0; k < ORR_SBAS_ALMANACS; k++) {
        const orr_sbas_almanac *a = &d->almanac[k];
        if (a->sat == ORR_SAT_NONE) {
            orr_page_zeros(p, 67);
            continue;
        }
        const int prn = 100 + orr_sat_number(a->sat);
        const double value[] = {a->pos_m.x, a->pos_m.y, a->pos_m.z, a->vel_mps.x, a->vel_mps.y, a->vel_mps.z};
        orr_page_zeros(p, 2); // data ID
        orr_page_put(p, 8, (uint64_t)prn);
        orr_page_put(p, 4, provider_of(prn));
        orr_page_put(p, 4, a->healthy ? 0 : 7); // basic and precise corrections, ranging: off
        for (size_t j = 0; j < 6; j++) orr_page_value(p, &field[j], orr_navfit_clamped(&field[j], value[j]));
    }
    orr_page_put(p, 11, time_of_day(d->almanac_t0, 64));
}

// The band that holds the satellite's longitude: bands 0 to 8 are 40 deg wide from 180 W on (A.4.4.9).
static uint64_t band_of(const orr_sbas_told *d)
{
    const double deg = d->longitude_rad / ORR_RAD_PER_DEG;
    return (uint64_t)fmin(8, fmax(0, floor((deg + 180) / 40)));
}

static void grid_mask(const orr_sbas_told *d, orr_page *p)
{
    orr_page_put(p, 4, 1); // one band
    orr_page_put(p, 4, band_of(d));
    orr_page_put(p, 2, IODI);
    for (int k = 0; k < 201; k++) orr_page_put(p, 1, band_of(d) < 8 || k < 200); // band 8 has one point less
    orr_page_zeros(p, 1);
}

// Fifteen points: no delay (all ones), not monitored (GIVEI 15).
static void grid(const orr_sbas_told *d, orr_page *p)
{
    orr_page_put(p, 4, band_of(d));
    orr_page_put(p, 4, (uint64_t)d->part);
    for (int k = 0; k < 15; k++) orr_page_put(p, 13, 0x1fff);
    orr_page_put(p, 2, IODI);
    orr_page_zeros(p, 7);
}

// Two halves of two satellites each, without velocities: corrections of zero to the sets that GPS sends.
static void long_term(const orr_sbas_told *d, orr_page *p)
{
    for (int half = 0; half < 2; half++) {
        orr_page_zeros(p, 1); // velocity code
        for (int k = 0; k < 2; k++) {
            const int place = d->part + 2 * half + k, prn = prn_at(d, place);
            orr_page_put(p, 6, prn == 0 ? 0 : (uint64_t)place + 1);
            orr_page_put(p, 8, prn == 0 ? 0 : d->iode[prn - 1]);
            orr_page_zeros(p, 9 + 9 + 9 + 10);
        }
        orr_page_put(p, 2, IODP);
        orr_page_zeros(p, 1);
    }
}

// No regions: everywhere the UDREI holds as it is.
static void service(orr_page *p) { orr_page_zeros(p, 212); }

void orr_sbas_message_bits(const orr_sbas_told *d, orr_sbas_message message, orr_page *p)
{
    static const uint8_t preamble[] = {0x53, 0x9a, 0xc6};
    orr_page_begin(p, p->diag);
    orr_page_put(p, 8, preamble[orr_floor_mod(seconds(d->t), 3)]);
    orr_page_put(p, 6, (uint64_t)message);
    switch (message) {
    case ORR_SBAS_MASK:
        mask(d, p);
        break;
    case ORR_SBAS_INTEGRITY:
        integrity(d, p);
        break;
    case ORR_SBAS_FAST_AGING:
        fast_aging(p);
        break;
    case ORR_SBAS_EPHEMERIS:
        ephemeris(d, p);
        break;
    case ORR_SBAS_ALMANAC:
        almanac(d, p);
        break;
    case ORR_SBAS_GRID_MASK:
        grid_mask(d, p);
        break;
    case ORR_SBAS_LONG_TERM:
        long_term(d, p);
        break;
    case ORR_SBAS_GRID:
        grid(d, p);
        break;
    case ORR_SBAS_SERVICE:
        service(p);
        break;
    case ORR_SBAS_DO_NOT_USE: // as message 2, which it stands for
        fast(d, ORR_SBAS_FAST_FIRST, p);
        break;
    case ORR_SBAS_DEGRADATION: // all are zero
        break;
    default:
        fast(d, (int)message, p);
        break;
    }
    orr_page_seal(p, 0, MESSAGE);
}
