// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's rotation as orbits alone tell it, against what the centre that made them published.
#include "testing.h"

#include "ingest/sp3/sp3.h"
#include "ingest/tables/erp.h"
#include "orbit/dynamics/reference_fit.h"
#include "read_file.h"

#define MAS (ORR_RAD_PER_DEG / 3.6e6)

typedef struct days { // SP3 files, one a window
    size_t n, n_arcs;
    orr_sp3 sp3[3];
    double border_s[4];
    orr_reference_arc *arc;
    orr_reference_node *node;
} days;

// Every step_s; 24:00 of a day is the next one's.
static bool open_days(const char *const *names, size_t n, double step_s, days *d)
{
    *d = (days){0};
    size_t n_arcs = 0, n_nodes = 0;
    for (size_t i = 0; i < n; i++) {
        char path[512];
        orr_diag diag = {0};
        if (!orr_test_data(names[i], path, sizeof path)) return false;
        ASSERT_OK(orr_sp3_read(path, NULL, &d->sp3[i], NULL, &diag), diag);
        d->n++;
        d->border_s[i] = 86400.0 * (double)i;
        d->border_s[i + 1] = 86400.0 * (double)(i + 1);
        n_arcs += d->sp3[i].n_sats;
        n_nodes += d->sp3[i].n_sats * d->sp3[i].n_epochs;
    }
    d->arc = calloc(n_arcs, sizeof *d->arc);
    d->node = calloc(n_nodes, sizeof *d->node);
    assert_true(d->arc && d->node);
    orr_reference_node *next = d->node;
    for (size_t s = 0; s < d->sp3[0].n_sats; s++)
        for (size_t i = 0; i < n; i++) {
            const orr_sp3 *f = &d->sp3[i];
            size_t k = 0;
            while (k < f->n_sats && f->sat[k] != d->sp3[0].sat[s]) k++;
            if (k == f->n_sats) continue;
            orr_reference_arc *a = &d->arc[d->n_arcs++];
            *a = (orr_reference_arc){.sat = s, .window = i, .node = next};
            for (size_t e = 0; e < f->n_epochs; e++) {
                const double t_s = orr_time_diff_s(f->epoch[e], d->sp3[0].epoch[0]);
                const double *p = f->record[e * f->n_sats + k].pos_m;
                if (fmod(t_s, step_s) > 1e-6 || t_s >= d->border_s[i + 1] || !isfinite(p[0])) continue;
                *next++ = (orr_reference_node){t_s, {p[0], p[1], p[2]}};
                a->n++;
            }
        }
    return true;
}

static void close_days(days *d)
{
    for (size_t i = 0; i < d->n; i++) orr_sp3_free(&d->sp3[i]);
    free(d->arc);
    free(d->node);
}

static orr_reference_fit fit(const days *d, const orr_eop_series *eop, bool hold, int jobs)
{
    const orr_time from = d->sp3[0].epoch[0];
    const orr_reference_problem p = {.from = from,
                                     .to = orr_time_add_s(from, d->border_s[d->n]),
                                     .n_windows = d->n,
                                     .border_s = d->border_s,
                                     .n_arcs = d->n_arcs,
                                     .arc = d->arc,
                                     .eop = eop,
                                     .hold = hold,
                                     .gravity_degree = 8,
                                     .jobs = jobs};
    orr_reference_fit f;
    orr_diag diag = {0};
    ASSERT_OK(orr_reference_fit_run(&p, &f, &diag), diag);
    print_message("%zu of %zu orbits fitted in %d passes, %.2f mm, pole sigma %.4f mas, LOD %.4f ms\n",
                  f.fitted, d->n_arcs, f.passes, 1e3 * f.rms_m, f.pole_sigma_rad / MAS, 1e3 * f.lod_sigma_s);
    return f;
}

static void tell_poor(const days *d)
{
    for (size_t i = 0; i < d->n_arcs; i++) {
        char name[ORR_SAT_TEXT];
        const orr_reference_arc *a = &d->arc[i];
        if (!a->fitted || a->rms_m > 0.05 || a->rejected > 0)
            print_message("  %s window %zu: %s, %.4f m, %zu of %zu rejected, D0 %.1f\n",
                          orr_sat_text(d->sp3[0].sat[a->sat], name), a->window,
                          a->fitted ? "fitted" : "not fitted", a->rms_m, a->rejected, a->n, a->ecom_nmps2[0]);
    }
}

// CODE, three days of 2008 with the ERP file of their week: 0.1 mas is the bar, 2.5 mm at the Earth's
// surface.
static void pole_of_2008(void **state)
{
    (void)state;
    static const char *const names[] = {"2008-279/COD14996.EPH.Z", "2008-279/COD15000.EPH.Z",
                                        "2008-279/COD15001.EPH.Z"};
    char path[512];
    if (!orr_test_data("2008-279/COD15007.ERP.Z", path, sizeof path)) SKIP_NO_DATA("2008-279");
    orr_erp erp;
    orr_diag diag = {0};
    ASSERT_OK(read_erp(path, &erp, NULL, &diag), diag);
    for (int alone = 0; alone < 2; alone++) {
        days d;
        if (!open_days(alone ? &names[1] : names, alone ? 1 : 3, 900, &d)) SKIP_NO_DATA(names[0]);
        orr_reference_fit f = fit(&d, NULL, false, 2);
        tell_poor(&d);
        assert_true(f.estimated);
        const orr_time noon = orr_time_add_s(d.sp3[0].epoch[0], alone ? 43200 : 129600);
        const orr_eop mine = orr_eop_at(&f.rotation, noon, NULL, NULL),
                      theirs = orr_eop_at(&erp.series, noon, NULL, NULL);
        print_message("%s: x %.3f (%.3f), y %.3f (%.3f) mas, LOD %.4f (%.4f) ms\n",
                      alone ? "one day" : "three days", mine.xp_rad / MAS, theirs.xp_rad / MAS,
                      mine.yp_rad / MAS, theirs.yp_rad / MAS, 1e3 * mine.lod_s, 1e3 * theirs.lod_s);
        ASSERT_NEAR(mine.xp_rad / MAS, theirs.xp_rad / MAS, 0.1);
        ASSERT_NEAR(mine.yp_rad / MAS, theirs.yp_rad / MAS, 0.1);
        ASSERT_NEAR(1e3 * mine.lod_s, 1e3 * theirs.lod_s, 0.1);
        orr_reference_fit_free(&f);
        close_days(&d);
    }
    orr_erp_free(&erp);
}

static void day_of_2024(void **state)
{
    (void)state;
    static const char *const name[] = {"2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"};
    double xp[2] = {0}, yp[2] = {0};
    for (int sparse = 0; sparse < 2; sparse++) {
        days d;
        if (!open_days(name, 1, sparse ? 7200 : 900, &d)) SKIP_NO_DATA(name[0]);
        orr_reference_fit f = fit(&d, NULL, false, 1);
        tell_poor(&d);
        const orr_eop e = orr_eop_at(&f.rotation, orr_time_add_s(d.sp3[0].epoch[0], 43200), NULL, NULL);
        xp[sparse] = e.xp_rad / MAS, yp[sparse] = e.yp_rad / MAS;
        print_message("x %.3f, y %.3f mas, LOD %.4f ms\n", xp[sparse], yp[sparse], 1e3 * e.lod_s);
        orr_reference_fit_free(&f);
        close_days(&d);
    }
    // Nodes of 15 minutes and of two hours tell the same pole.
    ASSERT_NEAR(xp[0], xp[1], 0.05);
    ASSERT_NEAR(yp[0], yp[1], 0.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pole_of_2008), cmocka_unit_test(day_of_2024)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
