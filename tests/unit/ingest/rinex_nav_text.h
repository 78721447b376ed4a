// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation records made field by field, for the tests of their reader.
#ifndef ORR_TESTS_RINEX_NAV_TEXT_H
#define ORR_TESTS_RINEX_NAV_TEXT_H

#include "ingest/rinex/rinex_nav.h"
#include "rinex_text.h"
#include "testing.h"

#define B TEXT_BLANK

static inline orr_nav parse(const text *t, orr_warnings *w)
{
    orr_nav nav;
    orr_diag diag = {0};
    ASSERT_OK(orr_nav_parse("made.nav", t->p, t->n, NULL, &nav, w, &diag), diag);
    return nav;
}

static inline orr_time at(int y, int mo, int d, int h, int mi, int s, orr_scale scale)
{
    orr_civil c = {y, mo, d, h, mi, s, 0};
    orr_time t = 0;
    assert_int_equal(orr_time_from_civil(&c, scale, NULL, &t), ORR_OK);
    return t;
}

static const char *const exponents = "DdEe"; // all are read

// A Kepler record whose k-th number after the clock is 1000 + k where nothing else is asked for.
static inline void kepler(text *t, const char *first, int indent, int lines, const double *set, char letter)
{
    double clock[3] = {-1.25e-4, 3.5e-12, 0};
    text_add(t, "%s", first);
    text_fields(t, 0, letter, 3, clock);
    for (int i = 0; i < lines; i++) text_fields(t, indent, letter, 4, set + 4 * i);
}

static const double orbit[36] = {45,   -88.5, 4.5e-9, 1.25, 2e-6,   0.0123, 7e-6,  5153.7, 7200,
                                 1e-7, -2.5,  -3e-8,  0.97, 250.25, 0.7,    -8e-9, 2e-10,  1,
                                 2300, 0,     2.5,    0,    4.6e-9, 45,     6900,  4,      B,
                                 B,    31,    32,     33,   34,     35,     36,    37,     38};

static inline void assert_orbit(const orr_nav_eph *e)
{
    const orr_nav_kepler *k = &e->kepler;
    ASSERT_NEAR(e->af0_s, -1.25e-4, 0);
    ASSERT_NEAR(e->af1_sps, 3.5e-12, 0);
    ASSERT_NEAR(k->crs_m, -88.5, 0);
    ASSERT_NEAR(k->delta_n_radps, 4.5e-9, 0);
    ASSERT_NEAR(k->m0_rad, 1.25, 0);
    ASSERT_NEAR(k->cuc_rad, 2e-6, 0);
    ASSERT_NEAR(k->e, 0.0123, 0);
    ASSERT_NEAR(k->cus_rad, 7e-6, 0);
    ASSERT_NEAR(k->sqrt_a_sqrtm, 5153.7, 0);
    ASSERT_NEAR(k->cic_rad, 1e-7, 0);
    ASSERT_NEAR(k->omega0_rad, -2.5, 0);
    ASSERT_NEAR(k->cis_rad, -3e-8, 0);
    ASSERT_NEAR(k->i0_rad, 0.97, 0);
    ASSERT_NEAR(k->crc_m, 250.25, 0);
    ASSERT_NEAR(k->omega_rad, 0.7, 0);
    ASSERT_NEAR(k->omega_dot_radps, -8e-9, 0);
    ASSERT_NEAR(k->idot_radps, 2e-10, 0);
}

static inline void header_v3(text *t, const char *version)
{
    char first[64];
    snprintf(first, sizeof first, "%9s           N: GNSS NAV DATA    M: MIXED", version);
    text_header(t, first, "RINEX VERSION / TYPE");
    text_header(t, "", "END OF HEADER");
}

#endif
