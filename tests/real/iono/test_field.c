// SPDX-License-Identifier: GPL-3.0-or-later
// Published maps: how well harmonics meet them, what a .ION file made of the fit keeps, and what each way
// between epochs makes of a map that was withheld.
#include <unistd.h>

#include "iono/field/tec_files.h"
#include "read_file.h"
#include "testing.h"

READ_FILE_BY_PARSER(ion)
READ_FILE_BY_PARSER(ionex)

#define MAPS "2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz"

static bool read_maps(const char *name, orr_ionex *x)
{
    char path[512];
    orr_diag d = {0};
    if (!orr_test_data(name, path, sizeof path)) return false;
    ASSERT_OK(read_ionex(path, NULL, x, NULL, &d), d);
    return true;
}

static orr_vec3 unit(double lat_deg, double lon_deg)
{
    double b = lat_deg * ORR_RAD_PER_DEG, l = lon_deg * ORR_RAD_PER_DEG;
    return (orr_vec3){cos(b) * cos(l), cos(b) * sin(l), sin(b)};
}

typedef struct spread {
    double sum, max, n;
} spread;

static void add(spread *s, double d)
{
    s->sum += d * d;
    s->max = fmax(s->max, fabs(d));
    s->n++;
}

static double rms(const spread *s) { return sqrt(s->sum / s->n); }

// Field minus map k over its cells; cells of 0 are left out where asked.
static spread against(const orr_tec_field *f, const orr_ionex *x, size_t k, bool with_zeros)
{
    orr_tec_instant *at = malloc(sizeof *at);
    orr_diag d = {0};
    spread s = {0};
    ASSERT_OK(orr_tec_field_at(f, x->epoch[k], at, &d), d);
    for (size_t i = 0; i < x->n_lats; i++)
        for (size_t j = 0; j + 1 < x->n_lons; j++) {
            double y = x->tec_tecu[orr_ionex_index(x, k, 0, i, j)];
            orr_tec_value v;
            if (isnan(y) || (y == 0 && !with_zeros)) continue;
            ASSERT_OK(orr_tec_vertical(at, unit(x->lat_deg[i], x->lon_deg[j]), &v, &d), d);
            add(&s, v.vtec_tecu - y);
        }
    free(at);
    return s;
}

// CODE says its maps are an expansion of degree 15 in the solar-geomagnetic frame. Printed to 0.1 TECU, that
// leaves 0.1/sqrt(12) = 0.0289 TECU RMS and 0.05 (and little more, by what the fit moves) at most.
static void test_refit(void **state)
{
    (void)state;
    orr_ionex x;
    if (!read_maps(MAPS, &x)) SKIP_NO_DATA(MAPS);
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_ionex(&x, "maps", NULL, &f, &d), d);
    const orr_tec_fit *fit = orr_tec_field_fit(f);
    print_message("refit of %zu maps: %zu cells, %zu clipped (%zu held), RMS %.4f TECU, max %.4f TECU\n",
                  x.n_epochs, fit->n_cells, fit->n_clipped, fit->n_held, fit->rms_tecu, fit->max_tecu);
    assert_int_equal(x.n_epochs, 25);
    assert_true(fit->rms_tecu <= 0.030);
    assert_true(fit->max_tecu <= 0.08);
    // The evaluator says what the fit says.
    spread all = {0};
    for (size_t k = 0; k < x.n_epochs; k += 6) {
        spread s = against(f, &x, k, false);
        all.sum += s.sum;
        all.n += s.n;
        all.max = fmax(all.max, s.max);
    }
    assert_true(rms(&all) <= 0.030 && all.max <= 0.08);

    // Written as .ION, read back, evaluated on the grid: coefficients have eight decimals, 256 of them of
    // weight up to sqrt(31): 0.5e-8 sqrt(256) 31 at the very most, 1e-7 in practice; the fits' own rounding
    // besides.
    char path[] = "/tmp/orrery-ion-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    orr_ion out, in;
    ASSERT_OK(orr_tec_field_to_ion(f, &out, &d), d);
    ASSERT_OK(orr_ion_write(&out, path, &d), d);
    orr_warnings w = {0};
    ASSERT_OK(read_ion(path, NULL, &in, &w, &d), d);
    assert_int_equal(w.count, 0);
    orr_tec_field *g;
    ASSERT_OK(orr_tec_field_from_ion(&in, "written", NULL, &g, &d), d);
    spread back = {0};
    orr_tec_instant *p = malloc(sizeof *p), *q = malloc(sizeof *q);
    for (size_t k = 0; k < x.n_epochs; k++) {
        orr_time t = k + 1 < x.n_epochs ? orr_time_add_s(x.epoch[k], 600) : x.epoch[k];
        ASSERT_OK(orr_tec_field_at(f, t, p, &d), d);
        ASSERT_OK(orr_tec_field_at(g, t, q, &d), d);
        for (size_t i = 0; i < x.n_lats; i += 3)
            for (size_t j = 0; j < x.n_lons; j += 3) {
                orr_tec_value a, b;
                ASSERT_OK(orr_tec_vertical(p, unit(x.lat_deg[i], x.lon_deg[j]), &a, &d), d);
                ASSERT_OK(orr_tec_vertical(q, unit(x.lat_deg[i], x.lon_deg[j]), &b, &d), d);
                add(&back, a.vtec_tecu - b.vtec_tecu);
            }
    }
    print_message(".ION and back: RMS %.2e TECU, max %.2e TECU\n", rms(&back), back.max);
    assert_true(back.max < 1e-6);
    unlink(path);
    free(p);
    free(q);
    orr_ion_free(&out);
    orr_ion_free(&in);
    orr_warnings_free(&w);
    orr_tec_field_free(f);
    orr_tec_field_free(g);
    orr_ionex_free(&x);
}

// Every second map is withheld, so that the maps at either side are two hours apart.
static void test_withheld_map(void **state)
{
    (void)state;
    orr_ionex x;
    if (!read_maps(MAPS, &x)) SKIP_NO_DATA(MAPS);
    size_t cells = x.n_lats * x.n_lons, kept = 0;
    orr_time *t = malloc(x.n_epochs * sizeof *t);
    double *tec = malloc(x.n_epochs * cells * sizeof *tec);
    for (size_t k = 0; k < x.n_epochs; k += 2) {
        t[kept] = x.epoch[k];
        memcpy(tec + kept++ * cells, x.tec_tecu + k * cells, cells * sizeof *tec);
    }
    orr_tec_maps maps = {kept,
                         x.n_lats,
                         x.n_lons,
                         x.lat_deg[0],
                         x.lat_deg[1] - x.lat_deg[0],
                         x.lon_deg[0],
                         x.lon_deg[1] - x.lon_deg[0],
                         x.base_radius_m + x.height_m[0],
                         0.1,
                         t,
                         tec,
                         NULL,
                         "every second map"};
    static const struct {
        const char *name;
        orr_tec_spatial spatial;
        orr_tec_temporal temporal;
        double rotation;
    } modes[] = {{"bilinear, nearest", ORR_TEC_BILINEAR, ORR_TEC_NEAREST, 0},
                 {"bilinear, linear", ORR_TEC_BILINEAR, ORR_TEC_LINEAR, 0},
                 {"bilinear, linear with rotation", ORR_TEC_BILINEAR, ORR_TEC_ROTATED, 1},
                 {"harmonics, nearest", ORR_TEC_HARMONIC, ORR_TEC_NEAREST, 0},
                 {"harmonics, linear", ORR_TEC_HARMONIC, ORR_TEC_LINEAR, 0},
                 {"harmonics, rotation 0.5", ORR_TEC_HARMONIC, ORR_TEC_ROTATED, 0.5},
                 {"harmonics, rotation 0.8", ORR_TEC_HARMONIC, ORR_TEC_ROTATED, 0.8},
                 {"harmonics, rotation 1 (default)", ORR_TEC_HARMONIC, ORR_TEC_ROTATED, 1}};
    double rotated_bilinear = 0, standard = 0;
    print_message("%-34s %9s %9s\n", "withheld maps, 2 h gap", "RMS TECU", "max TECU");
    for (size_t m = 0; m < sizeof modes / sizeof *modes; m++) {
        orr_tec_options o = orr_tec_default_options();
        o.spatial = modes[m].spatial;
        o.temporal = modes[m].temporal;
        o.rotation = modes[m].rotation;
        orr_tec_field *f;
        orr_diag d = {0};
        ASSERT_OK(orr_tec_field_from_maps(&maps, &o, &f, &d), d);
        spread all = {0};
        for (size_t k = 1; k < x.n_epochs; k += 2) {
            spread s = against(f, &x, k, true);
            all.sum += s.sum;
            all.n += s.n;
            all.max = fmax(all.max, s.max);
        }
        print_message("%-34s %9.3f %9.2f\n", modes[m].name, rms(&all), all.max);
        if (m == 2) rotated_bilinear = rms(&all);
        standard = rms(&all); // the default is the last
        orr_tec_field_free(f);
    }
    assert_true(standard <= rotated_bilinear);
    free(t);
    free(tec);
    orr_ionex_free(&x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_refit), cmocka_unit_test(test_withheld_map)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
