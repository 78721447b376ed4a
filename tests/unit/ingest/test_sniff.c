// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "ingest/inspect/inspect.h"

static orr_sniffed sniff(const char *text) { return orr_sniff(orr_view_of(text)); }

static void test_first_lines(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        orr_kind kind;
        const char *version;
    } known[] = {
        {"#dP2024  2  4  0  0  0.00000000     289 d+D   IGS20 FIT AIUB\n", ORR_KIND_SP3, "d"},
        {"\xef\xbb\xbf#aV2015\n", ORR_KIND_SP3, "a"},
        {"     2.10           N: GPS NAV DATA                         RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_NAV, "2.10"},
        {"     2.01           GLONASS NAV DATA                        RINEX VERSION / TYPE\r\n",
         ORR_KIND_RINEX_NAV, "2.01"},
        {"     4.02           NAVIGATION DATA     M                   RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_NAV, "4.02"},
        {"     3.05           Observation         M                   RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_OBS, "3.05"},
        {"     2.12           OBSERVATION DATA    M\n", ORR_KIND_RINEX_OBS, "2.12"}, // the label is lost
        {"     2.11           METEOROLOGICAL DATA                     RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_MET, "2.11"},
        {"     3.00           C                   G                   RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_CLK, "3.00"},
        {"3.04                 CLOCK DATA           M                      RINEX VERSION / TYPE\n",
         ORR_KIND_RINEX_CLK, "3.04"},
        {"3.0                 COMPACT RINEX FORMAT                    CRINEX VERS   / TYPE\n",
         ORR_KIND_CRINEX, "3.0"},
        {"     1.0            IONOSPHERE MAPS     GNSS                IONEX VERSION / TYPE\n", ORR_KIND_IONEX,
         "1.0"},
        {"     1.4            M                                       ANTEX VERSION / SYST\n", ORR_KIND_ANTEX,
         "1.4"},
        {"%=SNX 2.02 IGN 24:053:83755\n", ORR_KIND_SINEX, "2.02"},
        {"%=BIA 1.00 COD 2024:040:29169\n", ORR_KIND_BIAS_SINEX, "1.00"},
        {"VERSION 2\nCODE FINAL\n", ORR_KIND_ERP, "2"},
        {"\n version 2\n", ORR_KIND_ERP, "2"},
        {"EOP SOLUTION\n  MJD      Xpole   Ypole  UT1-UTC    LOD\n", ORR_KIND_ERP, ""},
        {"CODE'S GLOBAL IONOSPHERE INFO\n-----\nMODEL NUMBER / STATION NAME                     : 0351-00\n",
         ORR_KIND_ION, ""},
        {"CODE'S MONTHLY GNSS P1-P2 DCB SOLUTION\n\nDIFFERENTIAL (P1-P2) CODE BIASES FOR SATELLITES\n",
         ORR_KIND_DCB, ""},
        {"%  lat    lon   p:a0    A1   B1\n  87.5    2.5 101421    21\n", ORR_KIND_GPT3, ""},
        {"! Version:            1.0\n! Data_types:         VMF3 (lat lon ah aw zhd zwd)\n",
         ORR_KIND_VMF3_GRID, ""},
        {"AGGO      61042.00  0.00126424  0.00043626  2.2940  0.1199  1005.73  22.79  16.62\n",
         ORR_KIND_VMF3_SITE, ""},
        {"ncols 3\nnrows 2\nxllcorner 17\n", ORR_KIND_ESRI_GRID, ""},
        {"$GPGGA,000000.00,5216.6,N\n$GPRMC,000000\n", ORR_KIND_NMEA, ""},
        {"t,lat,lon\n0,52.1,16.2\n1,52.2,16.3\n2,52.2,16.3\n", ORR_KIND_TABLE, ""},
        {"   7.9000000e+01   4.9640000e+03   0.0000000e+00\n", ORR_KIND_TABLE, ""},
        {"<!DOCTYPE HTML>\n", ORR_KIND_WEB_PAGE, ""},
        {"\x89HDF\r\n\x1a\n....", ORR_KIND_NETCDF, ""},
        {"CDF\x02....", ORR_KIND_NETCDF, ""},
        {"Dear reader,\nthis is a letter.\n", ORR_KIND_UNKNOWN, ""},
        {"#!/bin/sh\n", ORR_KIND_UNKNOWN, ""},
        {"", ORR_KIND_EMPTY, ""},
        {"\x01\x02\x03\x04", ORR_KIND_BINARY, ""},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        orr_sniffed s = sniff(known[i].text);
        if (s.kind != known[i].kind || strcmp(s.version, known[i].version) != 0)
            fail_msg("%s: %s, version '%s'", known[i].text, orr_kind_token(s.kind), s.version);
    }
}

static void test_report(void **state)
{
    (void)state;
    orr_inspection r;
    orr_inspection_init(&r);
    assert_int_equal(r.satellites, ORR_INSPECT_NONE);
    orr_inspect_sat_add(&r, orr_sat_make('E', 5));
    orr_inspect_sat_add(&r, orr_sat_make('G', 5));
    orr_inspect_sat_add(&r, orr_sat_make('E', 5));
    orr_inspect_sat_add(&r, ORR_SAT_NONE);
    orr_inspect_system_add(&r, 'C');
    orr_inspect_system_add(&r, '?');
    assert_int_equal(r.satellites, 2);
    assert_string_equal(r.systems, "GEC");
    const orr_time s = ORR_NS_PER_S, t[] = {0, 30 * s, 60 * s, 120 * s, 150 * s};
    orr_inspect_epochs(&r, t, 5);
    assert_int_equal(r.epochs, 5);
    assert_int_equal(r.gaps, 1);
    ASSERT_NEAR(r.interval_s, 30, 0);
    assert_true(r.from == 0 && r.to == 150 * s);
    orr_inspect_fact_add(&r, "agency", "%s", "ABCD");
    assert_string_equal(r.fact[0].text, "ABCD");
    orr_inspection_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_first_lines), cmocka_unit_test(test_report)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
