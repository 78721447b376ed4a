// SPDX-License-Identifier: GPL-3.0-or-later
// Every odd RINEX file has its verdict: accepted, accepted with warnings, or refused and why; and what was
// read of it.
#include "testing.h"

#include <dirent.h>

#include "ingest/inspect/inspect.h"

typedef struct verdict {
    const char *name;
    orr_status status;
    int warnings;     // exactly so many
    int epochs, sats; // observation files: epochs, different satellites; navigation files: -1 and satellites
    int records;      // ephemerides; -1 for observation files
    const char *says; // part of the first warning or of the refusal
} verdict;

static const verdict table[] = {
    // Navigation: well formed examples of versions and messages
    {"Example_Beidou_Rinex302.n.gz", ORR_OK, 0, -1, 2, 2, NULL},
    {"Example_Beidou_Rinex400.n.gz", ORR_OK, 0, -1, 3, 10, NULL},
    {"Example_GPS_CNAV_Rinex400.n.gz", ORR_OK, 1, -1, 1, 3,
     "week number 2213"}, // a date edited away from its week
    {"Example_GPS_Rinex304.n.gz", ORR_OK, 0, -1, 3, 3, NULL},
    {"Example_Galileo_Rinex302.n.gz", ORR_OK, 0, -1, 2, 6, NULL},
    {"Example_Galileo_Rinex400.n.gz", ORR_OK, 0, -1, 1, 2, NULL},
    {"Example_Glonass_Rinex400.n.gz", ORR_OK, 0, -1, 1, 2, NULL},
    {"Example_Mixed_Rinex304.n.gz", ORR_OK, 0, -1, 5, 5, NULL},
    {"Example_NavIC_Rinex303.n.gz", ORR_OK, 0, -1, 3, 3, NULL},
    {"Example_NavIC_Rinex400.n.gz", ORR_OK, 0, -1, 1, 2, NULL},
    {"Example_QZSS_Rinex302.n.gz", ORR_OK, 0, -1, 3, 3, NULL},
    {"Example_QZSS_Rinex400.n.gz", ORR_OK, 0, -1, 1, 6, NULL},
    {"Example_SBAS_Rinex304.n.gz", ORR_OK, 0, -1, 3, 3, NULL},
    {"Example_Sto_Rinex400.n.gz", ORR_OK, 0, -1, 0, 0, NULL}, // 16 time offsets, no ephemeris
    {"brdc0130.22g.gz", ORR_OK, 0, -1, 23, 1104, NULL},
    {"invalid-but-accepted.n.gz", ORR_OK, 0, -1, 2, 3,
     NULL}, // 3.05 whose GLONASS lacks the fourth line: readable
    {"missing-run-by-400.n.gz", ORR_OK, 1, -1, 0, 0,
     "no records"}, // a header without PGM / RUN BY / DATE and no records
    // Navigation: damage
    {"unknown-key-header.n.gz", ORR_OK, 1, -1, 0, 0, "header label \"UNKNOWN\""},
    {"wrong-format.n.gz", ORR_OK, 2, -1, 0, 0, "ionosphere parameter is not a number"},
    {"wrong-type-GPS.n.gz", ORR_E_FORMAT, 0, -1, 0, 0, "message \"XXXX\""},
    {"wrong-type-Glonass.n.gz", ORR_E_FORMAT, 0, -1, 0, 0, "message \"XXXX\""},
    {"wrong-type-QZSS.n.gz", ORR_E_FORMAT, 0, -1, 0, 0, "message \"XXXX\""},
    // Observations: readable
    {"aaaa0000.00o.gz", ORR_OK, 0, 2, 26, -1, NULL},
    {"aiub0000.00o.gz", ORR_OK, 0, 6, 6, -1,
     NULL}, // the format's own example: events, slips, wavelength factors
    {"bbbb0000.01o.gz", ORR_OK, 0, 1, 36, -1, NULL},
    {"bogi1210.09o.gz", ORR_OK, 0, 9, 16, -1, NULL},
    {"cccc0000.07o.gz", ORR_OK, 0, 4, 7, -1, NULL},
    {"dcbs.00o.gz", ORR_OK, 0, 2, 26, -1, NULL},
    {"embe083.06o.gz", ORR_OK, 0, 1, 5, -1, NULL},
    {"ice12720.07o.gz", ORR_OK, 0, 4, 7, -1, NULL}, // 2.20, a satellite's receiver
    {"no-ant-typeV3.06o.gz", ORR_OK, 0, 1, 5, -1, NULL},
    {"no-rec-typeV3.06o.gz", ORR_OK, 0, 1, 2, -1, NULL},
    {"unknown-rinex-frequency.00o.gz", ORR_OK, 0, 2, 26, -1,
     NULL}, // any code of three characters is kept as it is
    {"with-clock.01d.gz", ORR_OK, 0, 6, 6, -1, NULL},
    {"test_input_rinex2_obs_InvalidLineLength.06o.gz", ORR_OK, 0, 6, 9, -1, NULL}, // text past column 80
    {"test_input_rinex3_obs_RinexObsFile.15o.gz", ORR_OK, 0, 37, 4, -1, NULL},
    {"test_input_rinex3_obs_RinexObsFile_xmitStd.15o.gz", ORR_OK, 0, 37, 4, -1, NULL},
    {"test_input_rinex3_obs_SystemMixed.15o.gz", ORR_OK, 0, 37, 4, -1, NULL},
    // Observations: readable, but something is to be said
    {"inconsistent-satellite-system.00o.gz", ORR_OK, 1, 6, 6, -1, "another system"},
    {"inconsistent-satsystem.00o.gz", ORR_OK, 1, 2, 26, -1, "another system"},
    {"no-first-obsV3.06o.gz", ORR_OK, 1, 1, 5, -1, "TIME OF FIRST OBS"},
    {"no-markerNameV3.06o.gz", ORR_OK, 1, 1, 5, -1, "MARKER NAME"},
    {"number-format-error.06o.gz", ORR_OK, 1, 1, 5, -1, "not a number"}, // that value alone is left out
    {"test_input_rinex2_obs_BadEpochFlag.06o.gz", ORR_OK, 2, 5, 9, -1, "not an epoch line"},
    {"test_input_rinex2_obs_BadLineSize.06o.gz", ORR_OK, 2, 6, 9, -1, "another system"},
    {"test_input_rinex2_obs_FilterTest2.06o.gz", ORR_OK, 1, 6, 9, -1, "another system"},
    {"test_input_rinex2_obs_RinexObsFile.06o.gz", ORR_OK, 1, 6, 9, -1, "another system"},
    {"test_input_rinex2_obs_SystemGlonass.06o.gz", ORR_OK, 1, 6, 9, -1, "another system"},
    {"test_input_rinex_obs_RinexObsFile.06o.gz", ORR_OK, 1, 6, 9, -1, "another system"},
    {"test_input_rinex3_obs_BadEpochFlag.15o.gz", ORR_OK, 1, 36, 4, -1, "not an epoch line"},
    {"test_input_rinex3_obs_FilterTest1.15o.gz", ORR_OK, 1, 37, 4, -1, "another system"},
    {"test_input_rinex3_obs_IncompleteHeader.15o.gz", ORR_OK, 1, 37, 4, -1, "MARKER NAME"},
    {"test_input_rinex3_obs_InvalidTimeFormat.15o.gz", ORR_OK, 1, 32, 4, -1, "not an epoch line"},
    {"unknown-event-flag-3.00o.gz", ORR_OK, 1, 6, 6, -1,
     "not an epoch line"}, // flag 8: its lines are passed over
    {"badclkrst_U_20190320000_10M_10M_MO.crx.gz", ORR_OK, 2, 2, 12, -1, "clock offset"},
    {"truncateB_U_20190320000_15M_30S_MO.crx.gz", ORR_E_FORMAT, 0, 0, 0, -1,
     "no epoch"}, // cut in its first epoch
    // Refused
    {"custom-system.01o.gz", ORR_E_UNSUPPORTED, 0, 0, 0, -1, "'K' is no satellite system"},
    {"test_input_rinex2_obs_SystemTransit.06o.gz", ORR_E_UNSUPPORTED, 0, 0, 0, -1, "Transit"},
    {"unsupported-time-scale.06o.gz", ORR_E_UNSUPPORTED, 0, 0, 0, -1, "time system \"XYZ\""},
    {"labl9990.01d.gz", ORR_E_KIND, 0, 0, 0, -1, ""},            // a wrong label where Hatanaka's should be
    {"short-first-line.06o.gz", ORR_E_KIND, 0, 0, 0, -1, ""},    // cut within the first line
    {"unknown-first-label.06o.gz", ORR_E_KIND, 0, 0, 0, -1, ""}, // no RINEX label
    {"unknown-type.06o.gz", ORR_E_KIND, 0, 0, 0, -1, ""},        // a type that RINEX has not
    {"test_input_rinex2_obs_NotObs.06o.gz", ORR_E_KIND, 0, 0, 0, -1, ""}, // "Dbservation"
};

static void every_file_gets_its_verdict(void **state)
{
    (void)state;
    char path[1024];
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const verdict *v = &table[i];
        char name[256];
        snprintf(name, sizeof name, "odd/rinex/%s", v->name);
        if (!orr_test_data(name, path, sizeof path)) SKIP_NO_DATA(name);
        orr_inspection r;
        orr_diag diag = {0};
        orr_status s = orr_inspect(path, NULL, &r, &diag);
        const char *text = s != ORR_OK ? diag.text : r.warnings.kept > 0 ? r.warnings.item[0].text : "";
        if (s != v->status)
            fail_msg("%s: %s instead of %s: %s", v->name, orr_status_name(s), orr_status_name(v->status),
                     text);
        if (s == ORR_OK) {
            if ((int)r.warnings.count != v->warnings)
                fail_msg("%s: %zu warnings instead of %d, first: %s", v->name, r.warnings.count, v->warnings,
                         text);
            if (r.epochs != v->epochs || r.satellites != v->sats || r.records != v->records)
                fail_msg("%s: %lld epochs, %lld satellites, %lld records instead of %d, %d, %d", v->name,
                         (long long)r.epochs, (long long)r.satellites, (long long)r.records, v->epochs,
                         v->sats, v->records);
        } else {
            assert_true(strlen(diag.text) > 20); // a sentence
        }
        if (v->says != NULL && strstr(text, v->says) == NULL)
            fail_msg("%s: \"%s\" does not say \"%s\"", v->name, text, v->says);
        orr_inspection_free(&r);
    }
}

static void no_file_is_forgotten(void **state)
{
    (void)state;
    char path[1024];
    if (!orr_test_data("odd/rinex/aaaa0000.00o.gz", path, sizeof path)) SKIP_NO_DATA("odd/rinex");
    *strrchr(path, '/') = '\0';
    DIR *d = opendir(path);
    assert_non_null(d);
    size_t n = 0;
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        if (e->d_name[0] == '.') continue;
        size_t i = 0;
        while (i < sizeof table / sizeof table[0] && strcmp(table[i].name, e->d_name) != 0) i++;
        if (i == sizeof table / sizeof table[0]) fail_msg("%s has no verdict", e->d_name);
        n++;
    }
    closedir(d);
    assert_int_equal(n, sizeof table / sizeof table[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_file_gets_its_verdict),
                                       cmocka_unit_test(no_file_is_forgotten)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
