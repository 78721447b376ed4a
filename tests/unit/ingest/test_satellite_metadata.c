// SPDX-License-Identifier: GPL-3.0-or-later
// The IGS satellite metadata file, made as its specification has it: vehicles, their PRNs over time, powers, channels.
#include "testing.h"

#include "ingest/tables/satellite_metadata.h"

static const char FILE_TEXT[] =
    "%=SNX 2.02 XXX 24:001:00000 XXX 00:000:00000 00:000:00000 P 00000 0\n"
    "+FILE/COMMENT\n made\n-FILE/COMMENT\n"
    "+SATELLITE/IDENTIFIER\n*SVN_ COSPAR ID SatCat Block__________ Comment\n"
    " G063 2011-036A  37753 GPS-IIF         made\n R730 2009-070A  36111 GLO-M           "
    "made\n-SATELLITE/IDENTIFIER\n"
    "+SATELLITE/PRN\n*SVN_ Valid_From____ Valid_To______ PRN Comment\n"
    " G035 1993:243:00000 2011:196:00000 G01\n G063 2011:197:00000 0000:000:00000 G01 made\n"
    " R730 2009:348:00000 0000:000:00000 R01\n nonsense\n-SATELLITE/PRN\n"
    "+SATELLITE/FREQUENCY_CHANNEL\n R730 2009:348:00000 0000:000:00000   1\n-SATELLITE/FREQUENCY_CHANNEL\n"
    "+SATELLITE/TX_POWER\n*SVN_ Valid_From____ Valid_To______ P[W] Comment\n"
    " G063 2011:197:00000 0000:000:00000  240 made\n-SATELLITE/TX_POWER\n%ENDSNX\n";

static void blocks(void **state)
{
    (void)state;
    orr_satellite_metadata m;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_satellite_metadata_parse("made", FILE_TEXT, sizeof FILE_TEXT - 1, NULL, &m, &w, &d), d);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "too few words"));
    orr_time before, after;
    ASSERT_OK(orr_time_parse("2010-01-01", NULL, &before, &d), d);
    ASSERT_OK(orr_time_parse("2024-01-01", NULL, &after, &d), d);
    const orr_sat g01 = orr_sat_parse("G01");
    assert_string_equal(orr_satellite_metadata_svn(&m, g01, before), "G035");
    assert_string_equal(orr_satellite_metadata_svn(&m, g01, after), "G063");
    assert_null(orr_satellite_metadata_svn(&m, orr_sat_parse("G02"), after));
    ASSERT_NEAR(orr_satellite_metadata_at(&m, ORR_METADATA_POWER, "G063", after)->value, 240, 0);
    assert_null(orr_satellite_metadata_at(&m, ORR_METADATA_POWER, "G063", before));
    assert_string_equal(orr_satellite_metadata_at(&m, ORR_METADATA_IDENTIFIER, "G063", before)->block,
                        "GPS-IIF");
    ASSERT_NEAR(orr_satellite_metadata_at(&m, ORR_METADATA_CHANNEL, "R730", after)->value, 1, 0);
    orr_satellite_metadata_free(&m);
    orr_warnings_free(&w);
}

// Cut anywhere it is read as far as it goes, or refused with a sentence.
static void cut_anywhere(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof FILE_TEXT - 1; n++) {
        orr_satellite_metadata m;
        orr_diag d = {0};
        if (orr_satellite_metadata_parse("cut", FILE_TEXT, n, NULL, &m, NULL, &d) == ORR_OK)
            orr_satellite_metadata_free(&m);
        else
            assert_true(d.text[0] != '\0');
    }
    orr_satellite_metadata m;
    orr_diag d = {0};
    const char other[] = "%=SNX 2.02\n+SITE/ID\n-SITE/ID\n";
    assert_int_equal(orr_satellite_metadata_parse("other", other, sizeof other - 1, NULL, &m, NULL, &d),
                     ORR_E_KIND);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(blocks), cmocka_unit_test(cut_anywhere)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
