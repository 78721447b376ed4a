// SPDX-License-Identifier: GPL-3.0-or-later
// Files that end at 23:45 and the next ones, joined, against each alone within six hours of midnight: the curve's velocity is
// nowhere further from the file's own orbit than it may be, and sigma holds what its position is off it. The smaller sets of
// satellites by default, all with ORRERY_ALL_SATELLITES=1.
#include "testing.h"

#include "core/robust.h"
#include "real_orbit.h"

#define HOURS_S (6 * 3600)
#define MOST_MPS 2e-5
#define MOST_JUMP_M 0.10

typedef struct apart {
    size_t sats, n;
    double most_mps, most_m; // of jumps up to MOST_JUMP_M
    orr_sat worst;
    double beyond_mps; // of larger ones
    double *speed, *ratio;
} apart;

static void smooth(const real_files *f, size_t first, size_t n, const orr_sat_set *sats,
                   orr_orbit_solution *s)
{
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    o.sats = sats;
    o.jobs = 2;
    ASSERT_OK(orr_smoother_run(&f->input[first], n, &o, NULL, NULL, s, NULL, NULL, &d), d);
}

static const orr_orbit_sat *find(const orr_orbit_solution *s, orr_sat sat)
{
    for (size_t i = 0; i < s->n_sats; i++)
        if (s->sat[i].sat == sat) return &s->sat[i];
    return NULL;
}

static double jump_of(const orr_orbit_sat *sat)
{
    double jump = 0;
    for (size_t k = 0; k < sat->n_events; k++)
        if (sat->event[k].kind == ORR_EVENT_DAY_JUMP) jump = fmax(jump, sat->event[k].value);
    return jump;
}

static void compare(const orr_orbit_sat *both, const orr_orbit_sat *alone, orr_time midnight, bool before,
                    apart *x)
{
    const double jump = jump_of(both);
    for (size_t a = 0; a < both->n_arcs; a++)
        for (size_t k = 0; k < both->arc[a].n; k++) {
            const orr_time t = orr_time_add_s(both->arc[a].t0, (double)k * both->arc[a].step_s);
            const double from_s = orr_time_diff_s(t, midnight);
            if (fabs(from_s) > HOURS_S || (from_s < 0) != before) continue;
            const orr_orbit_sample *p = &both->arc[a].sample[k], *q = real_sample_at(alone, t);
            if (q == NULL) continue;
            const double v = orr_vec3_norm(orr_vec3_sub(p->vel_mps, q->vel_mps)),
                         r = orr_vec3_norm(orr_vec3_sub(p->pos_m, q->pos_m));
            if (jump > MOST_JUMP_M) {
                x->beyond_mps = fmax(x->beyond_mps, v);
                continue;
            }
            x->most_m = fmax(x->most_m, r);
            if (v > x->most_mps) {
                x->most_mps = v;
                x->worst = both->sat;
            }
            if (p->flags & ORR_EPH_JOINT) {
                x->speed[x->n] = v;
                x->ratio[x->n++] = r / (double)p->sigma_m;
            }
        }
}

static void joint(const char *const *names, const char *few)
{
    real_files f;
    orr_orbit_solution both, alone[2];
    orr_sat_set set;
    orr_diag d = {0};
    if (!real_open(names, 2, &f)) SKIP_NO_DATA(names[0]);
    const bool all = few == NULL || getenv("ORRERY_ALL_SATELLITES") != NULL;
    if (!all) ASSERT_OK(orr_sat_set_parse(few, &set, &d), d);
    const orr_sat_set *sats = all ? NULL : &set;
    smooth(&f, 0, 2, sats, &both);
    smooth(&f, 0, 1, sats, &alone[0]);
    smooth(&f, 1, 1, sats, &alone[1]);
    const size_t room = both.n_sats * (4 * HOURS_S / 100);
    apart x = {.speed = malloc(room * sizeof(double)), .ratio = malloc(room * sizeof(double))};
    assert_true(x.speed != NULL && x.ratio != NULL);
    for (size_t i = 0; i < both.n_sats; i++) {
        const orr_orbit_sat *one[2] = {find(&alone[0], both.sat[i].sat), find(&alone[1], both.sat[i].sat)};
        if (one[0] == NULL || one[1] == NULL) continue;
        x.sats++;
        for (int k = 0; k < 2; k++) compare(&both.sat[i], one[k], f.sp3[1].epoch[0], k == 0, &x);
    }
    char name[ORR_SAT_TEXT];
    assert_true(x.n > 0);
    const double speed = orr_median(x.speed, x.n), ratio = orr_median(x.ratio, x.n);
    print_message("%s and the next: %zu satellites, velocity off either file's %.3g m/s in the median, %.3g "
                  "at most (%s; %.3g where they "
                  "jump by more than 0.1 m), position %.1f mm at most, %.2f sigma in the median\n",
                  names[0], x.sats, speed, x.most_mps, orr_sat_text(x.worst, name), x.beyond_mps,
                  1e3 * x.most_m, ratio);
    assert_true(x.most_mps < MOST_MPS);
    assert_true(speed > 1e-7 && ratio > 0.3 && ratio < 1.6);
    free(x.speed);
    free(x.ratio);
    orr_orbit_solution_free(&both);
    orr_orbit_solution_free(&alone[0]);
    orr_orbit_solution_free(&alone[1]);
    real_close(&f);
}

static void igs_2010(void **state)
{
    (void)state;
    joint((const char *const[]){"2010-182/igs15904.sp3.gz", "2010-182/igs15905.sp3.gz"}, "G01-G12");
}

static void igs_2009(void **state)
{
    (void)state;
    joint((const char *const[]){"2009-265/igs15502.sp3.gz", "2009-265/igs15503.sp3.gz"}, "G01-G12");
    joint((const char *const[]){"2009-265/igs15503.sp3.gz", "2009-265/igs15504.sp3.gz"}, "G01-G12");
}

static void grg_2020(void **state)
{
    (void)state;
    joint((const char *const[]){"2020-177/GRG0MGXFIN_20201760000_01D_15M_ORB.SP3.gz",
                                "2020-177/GRG0MGXFIN_20201770000_01D_15M_ORB.SP3.gz"},
          "G01-G10");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(igs_2010),
        cmocka_unit_test(igs_2009),
        cmocka_unit_test(grg_2020),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
