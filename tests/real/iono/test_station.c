// SPDX-License-Identifier: GPL-3.0-or-later
// A mid-latitude station at solar maximum, all day: both methods of fusion against the model, against codes
// that they did not use, and against arcs that they did not see.
#include <unistd.h>

#include "core/sha256.h"
#include "iono/fusion/session.h"
#include "read_file.h"
#include "station_day.h"

static void show(const orr_fusion *f, const orr_phase_tec *p)
{
    size_t slips = 0, repaired = 0, steps = 0;
    for (size_t s = 0; s < p->n_sats; s++)
        for (size_t k = 0; k < p->sat[s].arcs.n_slips; k++) {
            slips++;
            repaired += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_REPAIRED;
            steps += (p->sat[s].arcs.slip[k].causes & ORR_SLIP_STEP) != 0;
        }
    print_message(
        "%s: %zu satellites, %zu arcs (%zu slips, %zu repaired, %zu steps), %zu samples: RMS %.3f TECU, "
        "against the "
        "model %.3f; Galileo codes %s: std %.3f TECU over %zu arcs\n",
        orr_fusion_method_name(f->method), p->n_sats, f->n_arcs, slips, repaired, steps, f->n_samples,
        f->residual_tecu, f->model_residual_tecu, f->galileo_withheld ? "withheld" : "used",
        f->galileo_std_tecu, f->galileo_n);
    for (size_t b = 0; b < f->n_band; b++)
        if (f->band[b].n > 0)
            print_message("  %2.0f-%2.0f deg %6zu samples RMS %.3f TECU\n", f->band[b].from_deg,
                          f->band[b].to_deg, f->band[b].n, f->band[b].rms_tecu);
    for (size_t g = 0; g < f->n_groups; g++)
        print_message("  receiver %c %s-%s: %.2f +- %.2f TECU\n", f->group[g].system, f->group[g].range[0],
                      f->group[g].range[1], f->group[g].receiver_tecu, f->group[g].sigma_tecu);
}

static void test_thesis(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_fusion_options o = orr_fusion_default_options();
    o.method = ORR_FUSION_THESIS;
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&day->phase, day->field, &day->biases, 1, &o, &f, &d), d);
    show(&f, &day->phase);
    assert_true(f.residual_tecu <= 2.2);
    orr_fusion_free(&f, &day->phase);
}

// The joint fusion of the day, and the session of it, made once for all tests that look at them.
static orr_fusion joint;
static orr_session session;

static void fuse_the_day(station_day *day)
{
    if (joint.n_arcs > 0) return;
    orr_diag d = {0};
    char path[512];
    orr_tec_field *field;
    ASSERT_OK(orr_fuse(&day->phase, day->field, &day->biases, 1, NULL, &joint, &d), d);
    assert_true(orr_test_data(DAY_MAPS, path, sizeof path));
    ASSERT_OK(orr_tec_field_open(path, NULL, &field, NULL, &d), d);
    ASSERT_OK(orr_session_make(&day->phase, &joint, field, 300, &session, &d), d);
}

static void test_joint(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    fuse_the_day(day);
    const orr_fusion f = joint;
    show(&f, &day->phase);
    assert_true(f.residual_tecu <= 1.0);
    assert_true(f.galileo_withheld && f.galileo_n > 20);
    assert_true(f.galileo_std_tecu <= 1.5);
    // Arcs left out: 1.20 TECU.
    const orr_leave_out *l = &f.left;
    print_message("%zu arcs left out: corrected %.3f TECU, plain field %.3f TECU; dSTEC %.3f and %.3f\n",
                  l->n_arcs, l->corrected_tecu, l->plain_tecu, l->corrected_dstec_tecu, l->plain_dstec_tecu);
    assert_true(l->n_arcs > 100 && l->corrected_tecu <= 1.2 && l->corrected_dstec_tecu < l->plain_dstec_tecu);
    assert_true(fabs(f.group[0].receiver_tecu - 37.50) < 2 * f.group[0].sigma_tecu &&
                f.group[0].sigma_tecu < 1);
}

// One system alone: arcs left out are never worse than against the field as it is.
static void test_leave_one_out(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    for (const char *which = "GRE"; *which != '\0'; which++) {
        orr_phase_tec all = day->phase, p = all;
        p.n_sats = 0;
        p.sat = calloc(all.n_sats, sizeof *p.sat);
        for (size_t s = 0; s < all.n_sats; s++)
            if (orr_sat_system(all.sat[s].sat) == *which) p.sat[p.n_sats++] = all.sat[s];
        orr_fusion_options o = orr_fusion_default_options();
        o.step_test = false; // the arcs are borrowed
        orr_fusion f;
        orr_diag d = {0};
        ASSERT_OK(orr_fuse(&p, day->field, &day->biases, 1, &o, &f, &d), d);
        const orr_leave_out *l = &f.left;
        print_message(
            "%c: %zu arcs left out: corrected %.3f TECU, plain field %.3f TECU; dSTEC %.3f and %.3f\n",
            *which, l->n_arcs, l->corrected_tecu, l->plain_tecu, l->corrected_dstec_tecu,
            l->plain_dstec_tecu);
        assert_int_equal(f.fallback, ORR_FUSION_AS_ASKED);
        assert_true(l->corrected_tecu <= l->plain_tecu && l->corrected_dstec_tecu <= l->plain_dstec_tecu);
        assert_true(f.level_sigma_tecu < 1.5);
        orr_fusion_free(&f, &p);
        free(p.sat);
    }
}

// The receiver's bias that the fit tells from the station's own data against the one CODE gives (37.50 +- 0.28 TECU), in
// sessions of 4, 2 and 1 hours (of the whole day: test_joint): pulls are alike a normal's.
static void test_receiver_bias(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    static const int hours[] = {4, 2, 1};
    for (size_t k = 0; k < sizeof hours / sizeof *hours; k++) {
        double square = 0, n = 0;
        for (int h = 0; h < 24; h += 6) {
            char path[512];
            orr_phase_options o = orr_phase_default_options();
            orr_phase_tec p;
            orr_fusion f;
            orr_diag d = {0};
            assert_true(orr_test_data(DAY_OBS, path, sizeof path));
            o.from = orr_time_add_s(day->phase.from, 3600.0 * h);
            o.to = orr_time_add_s(o.from, 3600.0 * hours[k] - 30);
            o.position = sp3_position;
            o.user = &day->sp3;
            o.site_m = &day->phase.site.pos_m;
            ASSERT_OK(read_phases(path, &o, &p, &d), d);
            ASSERT_OK(orr_fuse(&p, day->field, &day->biases, 1, NULL, &f, &d), d);
            size_t g = 0;
            while (g < f.n_groups && isnan(f.group[g].receiver_tecu)) g++;
            assert_true(g < f.n_groups);
            double pull = (f.group[g].receiver_tecu - 37.50) / hypot(f.group[g].sigma_tecu, 0.28);
            print_message("%2d h from %02d: %.2f +- %.2f TECU, pull %.2f\n", hours[k], h,
                          f.group[g].receiver_tecu, f.group[g].sigma_tecu, pull);
            assert_true(fabs(pull) < 2 && f.group[g].sigma_tecu < 3);
            square += pull * pull;
            n++;
            orr_fusion_free(&f, &p);
            orr_phase_tec_free(&p);
        }
        assert_true(sqrt(square / n) < 2);
    }
}

// What a second changes, beyond what it changes of the field itself, at the station or some way off, over all satellites
// of the orbit from t to t + 1 s.
static double change(const orr_session *s, const station_day *day, orr_time t, orr_vec3 site)
{
    static orr_realisation r[2][200], f[2][200];
    size_t n[2], nf[2];
    double worst = 0;
    for (int k = 0; k < 2; k++) {
        orr_sat sat[200];
        orr_vec3 pos[200];
        size_t m = 0;
        orr_diag d = {0};
        for (size_t i = 0; i < day->sp3.n_sats && m < 200; i++)
            if (sp3_position((void *)&day->sp3, day->sp3.sat[i], t + k * ORR_NS_PER_S, &pos[m]))
                sat[m++] = day->sp3.sat[i];
        ASSERT_OK(orr_session_realise(s, t + k * ORR_NS_PER_S, site, sat, pos, m, NULL, r[k], &n[k], &d), d);
        ASSERT_OK(orr_field_realise(s->field, t + k * ORR_NS_PER_S, site, sat, pos, m, f[k], &nf[k], &d), d);
        assert_int_equal(n[k], nf[k]);
    }
    for (size_t i = 0, j = 0; i < n[0] && j < n[1];) {
        if (r[0][i].sat != r[1][j].sat) { // one rises or sets
            if (r[0][i].sat < r[1][j].sat)
                i++;
            else
                j++;
            continue;
        }
        worst = fmax(worst, fabs(r[1][j].stec_tecu - r[0][i].stec_tecu) -
                                fabs(f[1][j].stec_tecu - f[0][i].stec_tecu));
        i++;
        j++;
    }
    return worst;
}

// A generator's channel is continuous: 0.05 TECU a second above the field's own change at most, at the station and a
// kilometre off. Looked for where it could break (both ends of every arc, a ramp's ends) and every ten minutes; all
// seconds of the day with ORRERY_EVERY_SECOND set (some minutes).
static void test_continuous(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    fuse_the_day(day);
    const orr_session s = session;
    double worst[2] = {0};
    size_t n = 0, above = 0;
    for (int away = 0; away < 2; away++) {
        orr_vec3 site = orr_vec3_axpy(away * 1000.0, s.site.north, s.site.pos_m);
        orr_time last = orr_time_add_s(s.to, 20); // the orbit's and the maps' day
        bool all = getenv("ORRERY_EVERY_SECOND") != NULL;
        for (orr_time t = s.from; t < last; t = orr_time_add_s(t, all ? 1 : 600)) {
            double c = change(&s, day, t, site);
            worst[away] = fmax(worst[away], c);
            above += c > 0.05;
            n++;
        }
        for (size_t a = 0; !all && a < s.n_arcs; a++)
            for (int end = 0; end < 2; end++) {
                orr_time t = s.sample[s.arc[a].first + (end ? s.arc[a].n - 1 : 0)].t;
                for (int k = -1; k < 1; k++) {
                    orr_time at = orr_time_add_s(t, k);
                    if (at < s.from || at >= last) continue;
                    double c = change(&s, day, at, site);
                    worst[away] = fmax(worst[away], c);
                    above += c > 0.05;
                    n++;
                }
            }
    }
    print_message("%zu seconds: %zu above 0.05 TECU; worst at home %.4f TECU, 1 km away %.4f TECU\n", n,
                  above, worst[0], worst[1]);
    assert_true(worst[0] <= 0.05 && worst[1] <= 0.05);
}

// What becomes of a session in a file, and what it says at the station itself: the phase's curve and one
// constant an arc.
static void test_session(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_diag d = {0};
    fuse_the_day(day);
    const orr_fusion f = joint;
    const orr_session made = session;
    orr_session s;
    char path[512];
    assert_true(orr_test_data(DAY_MAPS, path, sizeof path));
    char file[] = "/tmp/orrery-session-XXXXXX";
    int fd = mkstemp(file);
    assert_true(fd >= 0);
    close(fd);
    char hash[ORR_SHA256_HEX];
    ASSERT_OK(orr_sha256_file(path, hash, &d), d);
    const orr_nc_input inputs[] = {{.path = path, .sha256 = hash}};
    ASSERT_OK(orr_session_save(&made, file, "a test", inputs, 1, &d), d);
    ASSERT_OK(orr_session_load(file, NULL, &s, &d), d);
    unlink(file);
    print_message("small scale: sigma %.3f TECU, length %.0f km, time %.0f s; %zu arcs, %zu samples\n",
                  s.small.sigma_tecu, s.small.length_m / 1e3, s.small.time_s, s.n_arcs, s.n_samples);
    assert_int_equal(s.n_samples, made.n_samples);
    assert_memory_equal(s.sample, made.sample, s.n_samples * sizeof *s.sample);
    assert_int_equal(s.n_arcs, f.n_arcs);

    // Every arc, sample by sample, against the phases; where an arc is joined to the next one its end is bent.
    size_t compared = 0, bent = 0;
    for (size_t a = 0; a < s.n_arcs; a++) {
        const orr_session_arc *arc = &s.arc[a];
        const orr_session_sample *x = s.sample + arc->first, *end = x + arc->n - 1;
        double low = 1e9, high = -1e9;
        bool before = a > 0 && arc[-1].sat == arc->sat &&
                      orr_time_diff_s(x->t, s.sample[arc->first - 1].t) <= 1800,
             after = a + 1 < s.n_arcs && arc[1].sat == arc->sat && orr_time_diff_s(end[1].t, end->t) <= 1800;
        for (size_t i = 0; i < arc->n; i += 5) {
            orr_vec3 pos;
            orr_realisation r;
            size_t n;
            if ((before && orr_time_diff_s(x[i].t, x->t) <= 450) ||
                (after && orr_time_diff_s(end->t, x[i].t) <= 450)) {
                bent++;
                continue;
            }
            assert_true(sp3_position(&day->sp3, arc->sat, x[i].t, &pos));
            ASSERT_OK(orr_session_realise(&s, x[i].t, s.site.pos_m, &arc->sat, &pos, 1, NULL, &r, &n, &d), d);
            assert_int_equal(n, 1);
            assert_int_equal(r.origin, ORR_ORIGIN_FUSED);
            double constant = r.stec_tecu - (x[i].stec_tecu + arc->bias_tecu);
            low = fmin(low, constant);
            high = fmax(high, constant);
            compared++;
        }
        assert_true(high - low < 1e-6 || high < low);
    }
    print_message(
        "%zu realisations: fused minus phase is one constant an arc to 1e-6 TECU; %zu near joints\n",
        compared, bent);
    assert_true(compared > 9000 && bent < compared / 5);

    // Between samples the curve goes on without a corner to speak of; a place 20 km away is alike but not the
    // same, and the same seed gives the same bytes.
    const orr_session_arc *arc = &s.arc[0];
    orr_time t = s.sample[arc->first + arc->n / 2].t + 7 * ORR_NS_PER_S;
    orr_vec3 pos, away = orr_vec3_axpy(20e3, s.site.east, s.site.pos_m);
    assert_true(sp3_position(&day->sp3, arc->sat, t, &pos));
    orr_realisation home, near, again, other;
    size_t n;
    orr_transfer_options o = {.seed = 5, .noise = true};
    ASSERT_OK(orr_session_realise(&s, t, s.site.pos_m, &arc->sat, &pos, 1, &o, &home, &n, &d), d);
    ASSERT_OK(orr_session_realise(&s, t, away, &arc->sat, &pos, 1, &o, &near, &n, &d), d);
    ASSERT_OK(orr_session_realise(&s, t, away, &arc->sat, &pos, 1, &o, &again, &n, &d), d);
    o.seed = 6;
    ASSERT_OK(orr_session_realise(&s, t, away, &arc->sat, &pos, 1, &o, &other, &n, &d), d);
    assert_int_equal(near.origin, ORR_ORIGIN_TRANSFERRED);
    assert_memory_equal(&near.stec_tecu, &again.stec_tecu, sizeof(double)); // (structs have padding)
    assert_memory_equal(&near.sigma_tecu, &again.sigma_tecu, sizeof(double));
    assert_true(near.stec_tecu != other.stec_tecu);
    assert_true(fabs(near.stec_tecu - home.stec_tecu) < 3 && near.stec_tecu != home.stec_tecu);
    orr_session_free(&s);
}

// One satellite is withheld in turn and its vertical residual predicted from the others by distance; the
// error by the distance of the nearest ray. And the made structure has the variance of the station's.
static void test_transfer(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_diag d = {0};
    fuse_the_day(day);
    orr_session s = session; // arcs are hidden in turn
    enum { BINS = 8 };
    static const double edge[BINS + 1] = {0, 50, 100, 150, 200, 300, 400, 600, 2000};
    double predicted[BINS] = {0}, plain[BINS] = {0}, made[BINS] = {0}, count[BINS] = {0},
           radius = ORR_SHELL_RADIUS_M / 1e3;
    double all_made = 0, all_seen = 0, n_all = 0;
    for (size_t a = 0; a < s.n_arcs; a++)
        for (size_t i = 40; i + 40 < s.arc[a].n; i += 40) { // every 20 minutes, ends left out
            const orr_session_sample *x = &s.sample[s.arc[a].first + i];
            if (x->el_rad < 20 * ORR_RAD_PER_DEG) continue;
            orr_vec3 pos;
            assert_true(sp3_position(&day->sp3, s.arc[a].sat, x->t, &pos));
            double nearest = 1e9;
            for (size_t b = 0; b < s.n_arcs; b++) {
                const orr_session_sample *first = &s.sample[s.arc[b].first], *last = first + s.arc[b].n - 1;
                if (s.arc[b].sat == s.arc[a].sat || x->t < first->t || x->t > last->t) continue;
                for (const orr_session_sample *y = first; y <= last; y++)
                    if (y->t == x->t)
                        nearest = fmin(nearest, radius * orr_vec3_norm(orr_vec3_sub(x->pierce, y->pierce)));
            }
            // The satellite under a name that the station never saw: it must be predicted from the others
            // alone.
            size_t kept_n = s.arc[a].n;
            orr_sat stranger = orr_sat_make('L', 99);
            s.arc[a].n = 0;
            orr_realisation r, m;
            size_t n;
            orr_transfer_options o = {.seed = 11, .noise = false};
            ASSERT_OK(orr_session_realise(&s, x->t, s.site.pos_m, &stranger, &pos, 1, &o, &r, &n, &d), d);
            o.noise = true;
            o.seed = 1000 * a + i;
            ASSERT_OK(orr_session_realise(&s, x->t, s.site.pos_m, &stranger, &pos, 1, &o, &m, &n, &d), d);
            s.arc[a].n = kept_n;
            assert_int_equal(r.origin, ORR_ORIGIN_NOISE);
            double v = x->stec_tecu / x->mapping, smooth = v - x->residual_tecu;
            int bin = 0;
            while (bin < BINS - 1 && nearest >= edge[bin + 1]) bin++;
            predicted[bin] += (r.vtec_tecu - v) * (r.vtec_tecu - v);
            plain[bin] += x->residual_tecu * x->residual_tecu;
            made[bin] += (m.vtec_tecu - smooth) * (m.vtec_tecu - smooth);
            count[bin]++;
            all_made += (m.vtec_tecu - smooth) * (m.vtec_tecu - smooth);
            all_seen += x->residual_tecu * x->residual_tecu;
            n_all++;
        }
    print_message(
        "nearest ray, km      n  predicted  corrected field  made structure (TECU, vertical, RMS)\n");
    for (int b = 0; b < BINS; b++)
        if (count[b] > 0)
            print_message("%6.0f-%-6.0f %8.0f %10.3f %16.3f %15.3f\n", edge[b], edge[b + 1], count[b],
                          sqrt(predicted[b] / count[b]), sqrt(plain[b] / count[b]), sqrt(made[b] / count[b]));
    print_message("structure made %.3f TECU, seen %.3f TECU\n", sqrt(all_made / n_all),
                  sqrt(all_seen / n_all));
    assert_true(sqrt(predicted[0] / count[0]) < sqrt(plain[0] / count[0])); // near rays tell something
    // Alike within 25 %: residuals above 20 degrees are smaller than all day's average, samples are
    // correlated.
    assert_true(fabs(sqrt(all_made / all_seen) - 1) < 0.25);
}

static int setup(void **state)
{
    static station_day day;
    *state = station_day_read(&day) ? &day : NULL;
    return 0;
}

static int teardown(void **state)
{
    if (*state == NULL) return 0;
    orr_session_free(&session);
    orr_fusion_free(&joint, &((station_day *)*state)->phase);
    station_day_free(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_thesis),        cmocka_unit_test(test_joint),
        cmocka_unit_test(test_leave_one_out), cmocka_unit_test(test_receiver_bias),
        cmocka_unit_test(test_continuous),    cmocka_unit_test(test_session),
        cmocka_unit_test(test_transfer)};
    return cmocka_run_group_tests(tests, setup, teardown);
}
