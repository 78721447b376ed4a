// SPDX-License-Identifier: GPL-3.0-or-later
// Bernese .ION coefficients: made text as Bernese writes it, left-out lines, refusals, and the writer through
// the reader.
#include "testing.h"

#include <unistd.h>

#include "core/nan.h"
#include "ingest/maps/ion.h"
#include "read_file.h"
#include "unit/ingest/made_text.h"

READ_FILE_BY_PARSER(ion)

static void rows(made_text *t, int degree, double first)
{
    for (int n = 0; n <= degree; n++)
        for (int m = 0; m <= n; m++) {
            made_add(t, "%4d%8d%18.8f%11.4f\n", n, m, first + n + 0.01 * m, 0.0123);
            if (m > 0) made_add(t, "%4d%8d%18.8f%11.4f\n", n, -m, -first - n - 0.01 * m, 0.0456);
        }
    made_add(t, "\n");
}

static made_text two_models(void)
{
    made_text t = {0};
    for (int k = 0; k < 2; k++) {
        made_add(&t, "CODE'S GLOBAL IONOSPHERE MAPS FOR DAY 035, 2024                   08-FEB-24 21:12\n");
        made_add(&t, "--------------------------------------------------------------------------------\n");
        made_add(&t, "MODEL NUMBER / STATION NAME                    : 0350-%02d\n", k + 1);
        made_add(&t, "MODEL TYPE (1=LOCAL,2=GLOBAL,3=STATION)        :    2\n");
        made_add(&t, "MAXIMUM DEGREE OF SPHERICAL HARMONICS          :    2\n");
        made_add(&t, "MAXIMUM ORDER                                  :    2\n");
        made_add(&t, "DEVELOPMENT WITH RESPECT TO                     \n");
        made_add(&t, "  GEOGRAPHICAL (=1) OR GEOMAGNETIC (=2) FRAME  :    2\n");
        made_add(&t, "  MEAN (=1) OR TRUE (=2) POSITION OF THE SUN   :    1\n");
        made_add(&t, "MAPPING FUNCTION (0=NONE,1=COSZ,2=MSLM,3=ESM)  :    2\n");
        made_add(&t, "HEIGHT OF SINGLE LAYER AND ITS RMS ERROR (KM)  :  450.00     0.00 \n");
        made_add(&t, "COORDINATES OF EARTH-CENTERED DIPOLE AXIS       \n");
        made_add(&t, "  LATITUDE OF NORTH GEOMAGNETIC POLE (DEGREES) :   80.65\n");
        made_add(&t, "  EAST LONGITUDE (DEGREES)                     :  -72.68\n");
        made_add(&t, "PERIOD OF VALIDITY                              \n");
        made_add(&t, "  FROM EPOCH / REFERENCE EPOCH (Y,M,D,H,M,S)   : 2024 02 04 %02d 00 00\n", k);
        made_add(&t, "  TO EPOCH                                     : \n");
        made_add(&t, "LATITUDE BAND COVERED                           \n");
        made_add(&t, "  MINIMUM LATITUDE (DEGREES)                   :  -88.20\n");
        made_add(&t, "  MAXIMUM LATITUDE (DEGREES)                   :   88.11\n");
        made_add(&t, "ADDITIONAL INFORMATION                          \n");
        made_add(&t, "  NUMBER OF CONTRIBUTING STATIONS              :  239\n");
        made_add(&t, "  NUMBER OF CONTRIBUTING SATELLITES            :   80\n");
        made_add(&t, "  ELEVATION CUT-OFF ANGLE (DEGREES)            :   10\n");
        made_add(&t, "  MAXIMUM TEC AND ITS RMS ERROR (TECU)         :  113.19     0.33\n");
        made_add(&t, "COMMENT / WARNING                              :\n");
        made_add(&t, "COEFFICIENTS                                    \n");
        made_add(&t, "DEGREE  ORDER    VALUE (TECU)   RMS (TECU)      \n");
        rows(&t, 2, 20.5 + k);
    }
    return t;
}

static orr_status parse(made_text *t, orr_ion *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    orr_status s = orr_ion_parse("made", t->s, t->n, NULL, x, w, d);
    made_free(t);
    return s;
}

static void assert_refused(made_text *t, orr_status expected, int line, const char *words)
{
    orr_ion x;
    orr_diag d;
    assert_int_equal(parse(t, &x, NULL, &d), expected);
    assert_null(x.model);
    if (line > 0) assert_int_equal(d.line, line);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
}

static void test_reads_everything(void **state)
{
    (void)state;
    orr_ion x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = two_models();
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.n_models, 2);
    const orr_ion_model *m = &x.model[1];
    assert_string_equal(m->number, "0350-02");
    assert_int_equal(m->type, ORR_ION_GLOBAL);
    assert_int_equal(m->max_degree, 2);
    assert_int_equal(m->max_order, 2);
    assert_int_equal(m->frame, ORR_ION_GEOMAGNETIC);
    assert_int_equal(m->sun, ORR_ION_SUN_MEAN);
    assert_int_equal(m->mapping, ORR_ION_MAP_MSLM);
    ASSERT_NEAR(m->layer_height_m, 450e3, 1e-9);
    ASSERT_NEAR(m->pole_lat_deg, 80.65, 0);
    ASSERT_NEAR(m->pole_lon_deg, -72.68, 0);
    assert_int_equal(m->to, ORR_TIME_NONE);
    orr_time expected;
    assert_int_equal(
        orr_time_from_civil(&(orr_civil){2024, 2, 4, 1, 0, 0, 0}, ORR_SCALE_GPS, NULL, &expected), ORR_OK);
    assert_true(m->from == expected);
    assert_int_equal(m->n_stations, 239);
    assert_int_equal(m->n_satellites, 80);
    ASSERT_NEAR(m->elevation_cutoff_deg, 10, 0);
    ASSERT_NEAR(m->max_tec_tecu, 113.19, 0);
    assert_int_equal(m->n_coefficients, 9);
    for (int n = 0; n <= 2; n++)
        for (int o = -n; o <= n; o++) { // every harmonic where orr_ion_index says
            const orr_ion_coefficient *k = &m->coefficient[orr_ion_index(n, o)];
            assert_int_equal(k->degree, n);
            assert_int_equal(k->order, o);
            double a = 21.5 + n + 0.01 * abs(o);
            ASSERT_NEAR(k->tecu, o < 0 ? -a : a, 5e-9); // eight decimals were written
            ASSERT_NEAR(k->rms_tecu, o < 0 ? 0.0456 : 0.0123, 0);
        }
    orr_ion_free(&x);
}

static void test_optional_lines(void **state)
{
    (void)state;
    orr_ion x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = two_models();
    // Lines that files leave out, another way to write the date, a date that ends the validity, a line nobody
    // knows.
    made_replace(&t, "  NUMBER OF CONTRIBUTING STATIONS              :  239\n", "");
    made_replace(&t, "  MINIMUM LATITUDE (DEGREES)                   :  -88.20\n", "");
    made_replace(&t, ": 2024 02 04 00 00 00", ": 2024-02-04 00:00:00");
    made_replace(&t, "TO EPOCH                                     : \n",
                 "TO EPOCH                                     : 2024-02-04 24:00:00\n");
    made_replace(&t, "COMMENT / WARNING  ", "SOMETHING NEW      ");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 1);
    assert_int_equal(x.model[0].n_stations, -1);
    assert_true(isnan(x.model[0].lat_south_deg));
    assert_true(x.model[0].to - x.model[0].from == ORR_S_PER_DAY * ORR_NS_PER_S);
    orr_ion_free(&x);
    orr_warnings_free(&w);
}

static void test_sorts_by_time(void **state)
{
    (void)state;
    orr_ion x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = two_models();
    made_replace(&t, "2024 02 04 00 00 00", "2024 02 05 00 00 00");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 1);
    assert_true(x.model[0].from < x.model[1].from);
    assert_string_equal(x.model[0].number, "0350-02");
    orr_ion_free(&x);
    orr_warnings_free(&w);
}

static void test_refusals(void **state)
{
    (void)state;
    made_text t = {0};
    made_add(&t, "     1.0            IONOSPHERE MAPS     GNSS                IONEX VERSION / TYPE\n   x\n");
    assert_refused(&t, ORR_E_KIND, 2, "not a Bernese .ION");
    made_add(&t, "\n\n");
    assert_refused(&t, ORR_E_KIND, 0, "no model");
    t = two_models();
    made_replace(&t, "HARMONICS          :    2", "HARMONICS          :    x");
    assert_refused(&t, ORR_E_FORMAT, 5, "MAXIMUM DEGREE");
    t = two_models();
    made_replace(&t, "2024 02 04 00", "2024 02 31 00");
    assert_refused(&t, ORR_E_FORMAT, 16, "FROM EPOCH");
    t = two_models();
    made_replace(&t, "  FROM EPOCH / REFERENCE EPOCH (Y,M,D,H,M,S)   : 2024 02 04 00 00 00\n", "");
    assert_refused(&t, ORR_E_FORMAT, 0, "no epoch");
    t = two_models();
    made_replace(&t, "   2      -2 ", "   2       2 ");
    assert_refused(&t, ORR_E_FORMAT, 0, "stands twice");
    t = two_models();
    made_replace(&t, "   2      -2 ", "   2      -3 ");
    assert_refused(&t, ORR_E_FORMAT, 37, "no harmonic");
    t = two_models();
    made_replace(&t, "   2      -2 ", "   3      -2 ");
    assert_refused(&t, ORR_E_FORMAT, 37, "own maximum");
    t = two_models();
    made_replace(&t, "21.50000000", "*********** ");
    assert_refused(&t, ORR_E_FORMAT, 30, "value");
    t = two_models();
    made_replace(&t, "TO EPOCH                                     : \n",
                 "TO EPOCH                                     : 2024 02 03 00 00 00\n");
    assert_refused(&t, ORR_E_FORMAT, 0, "ends before it starts");
    t = two_models();
    made_replace(&t, "RMS (TECU)  ", "RMS (TECU**2)");
    assert_refused(&t, ORR_E_UNSUPPORTED, 28, "stochastic");
    t = two_models();
    t.n = (size_t)(strstr(t.s, "PERIOD") - t.s);
    assert_refused(&t, ORR_E_FORMAT, 0, "cut short");
    t = two_models();
    t.n -= 30; // inside the last row
    assert_refused(&t, ORR_E_FORMAT, 0, "cut short");
    t = two_models();
    t.n -= 15; // the value has lost its last digits
    assert_refused(&t, ORR_E_FORMAT, 0, "cut short");
    t = two_models();
    t.n -= 43; // before it
    assert_refused(&t, ORR_E_FORMAT, 0, "cut short");
}

static void test_write_reads_back(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_ion a = {.n_models = 3, .model = calloc(3, sizeof *a.model)}, b;
    for (int k = 0; k < 3; k++) {
        orr_ion_model *m = &a.model[k];
        ASSERT_OK(orr_ion_model_alloc(15, 15, m, &d), d);
        assert_int_equal(m->n_coefficients, 256);
        if (k < 2) snprintf(m->title, sizeof m->title, "Synthetic model %d", k);
        snprintf(m->number, sizeof m->number, "0350-%02d", k + 1);
        m->frame = ORR_ION_GEOMAGNETIC;
        m->mapping = ORR_ION_MAP_MSLM;
        m->layer_height_m = 450e3;
        m->pole_lat_deg = 80.65;
        m->pole_lon_deg = -72.68;
        m->from = (orr_time)k * 3600 * ORR_NS_PER_S;
        for (size_t i = 0; i < m->n_coefficients; i++) {
            m->coefficient[i].tecu =
                (double)((i * 7919 + (size_t)k) % 10007) * 1e-3 - 5; // exact to eight decimals
            m->coefficient[i].rms_tecu = i % 5 == 0 ? ORR_NAN : 0.5;
        }
        assert_int_equal(m->coefficient[orr_ion_index(15, -15)].order, -15);
        assert_int_equal(m->coefficient[orr_ion_index(9, 4)].degree, 9);
    }
    char path[] = "ion-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    ASSERT_OK(orr_ion_write(&a, path, &d), d);
    orr_warnings w = {0};
    ASSERT_OK(read_ion(path, NULL, &b, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(b.n_models, 3);
    for (int k = 0; k < 3; k++) {
        const orr_ion_model *p = &a.model[k], *q = &b.model[k];
        assert_string_equal(p->title, q->title);
        assert_string_equal(p->number, q->number);
        assert_true(p->from == q->from && q->to == ORR_TIME_NONE);
        assert_int_equal(q->n_stations, -1);
        assert_int_equal(q->mapping, p->mapping);
        assert_int_equal(q->n_coefficients, 256);
        for (size_t i = 0; i < 256; i++) {
            assert_int_equal(p->coefficient[i].order, q->coefficient[i].order);
            ASSERT_NEAR(p->coefficient[i].tecu, q->coefficient[i].tecu, 1e-12);
            assert_int_equal(isnan(p->coefficient[i].rms_tecu), isnan(q->coefficient[i].rms_tecu));
        }
    }
    orr_ion_free(&b);
    a.model[1].coefficient[3].tecu = ORR_NAN;
    assert_int_equal(orr_ion_write(&a, path, &d), ORR_E_RANGE);
    orr_ion_free(&a);
    unlink(path);
}

static void test_truncated_order(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_ion_model m;
    ASSERT_OK(orr_ion_model_alloc(8, 3, &m, &d), d);
    assert_int_equal(m.n_coefficients, 1 + 3 + 5 + 6 * 7); // orders up to 3 for degrees 3 to 8
    free(m.coefficient);
    assert_int_equal(orr_ion_model_alloc(-1, 0, &m, &d), ORR_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reads_everything), cmocka_unit_test(test_optional_lines),
        cmocka_unit_test(test_sorts_by_time),    cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_write_reads_back), cmocka_unit_test(test_truncated_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
