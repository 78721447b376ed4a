// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/elements_periods.h"

#include <math.h>
#include <stdlib.h>

#include "core/outfile.h"
#include "orbit/elements/lines.h"

#define PERIODS 400    // from three steps to two thirds of the span, in equal ratios
#define LEAST_ROWS 24  // of a satellite
#define SPAN_SHARE 1.5 // longer periods are not to be told from a trend
#define MOST_TOLD 2    // peaks of a satellite
#define MOST_ROWS ((size_t)20 * 1000 * 1000)

orr_status elements_periods_take(void *user, const orr_elements_row *row, orr_diag *diag)
{
    elements_periods *x = user;
    if (!x->keeps) return x->next(x->user, row, diag);
    if (x->n == MOST_ROWS)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "more than %zu rows are too many for --periods: a longer --step", x->n);
    if (x->n == x->room) {
        const size_t room = x->room > 0 ? 2 * x->room : 1024;
        orr_elements_row *more = realloc(x->row, room * sizeof *more);
        if (more == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu rows", room);
        x->row = more;
        x->room = room;
    }
    x->row[x->n++] = *row;
    return x->next(x->user, row, diag);
}

void elements_periods_free(elements_periods *x) { free(x->row); }

static int by_satellite(const void *a, const void *b)
{
    const orr_elements_row *x = a, *y = b;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    return (x->t > y->t) - (x->t < y->t);
}

static double element(const orr_kepler *k, int which)
{
    return which == 0 ? k->a_m : which == 1 ? k->e : k->i_rad * ORR_DEG_PER_RAD;
}

static bool is_peak(const double *a, size_t k) { return a[k] > a[k - 1] && a[k] >= a[k + 1]; }

// Says the strongest periods: peaks of the windowed estimate, since those of the plain one may be what a strong line leaks into its
// neighbourhood; beyond a third of the span, where the window leaves too little beside the trend and a cubic stands for much of a
// wave, those of what a period explains.
static void say_peaks(const orr_cli *c, const char *sat, const double *period_d, const double *plain,
                      const double *windowed, const double *explained)
{
    const double longest = period_d[PERIODS - 1] * SPAN_SHARE / 3;
    double amplitude[PERIODS], limit = HUGE_VAL;
    for (size_t k = 0; k < PERIODS; k++) {
        const bool is_long = period_d[k] > longest;
        const bool peak = k > 0 && k + 1 < PERIODS && is_peak(is_long ? explained : windowed, k);
        amplitude[k] = !peak ? 0 : is_long ? plain[k] : windowed[k];
    }
    for (int told = 0; told < MOST_TOLD; told++) {
        size_t best = 0;
        for (size_t k = 1; k + 1 < PERIODS; k++) {
            if (amplitude[k] > 0 && amplitude[k] < limit && (best == 0 || amplitude[k] > amplitude[best]))
                best = k;
        }
        if (best == 0) return;
        limit = amplitude[best];
        orr_cli_say(c, "%s: inclination swings by %.3g deg in %.4g days", sat, amplitude[best],
                    period_d[best]);
    }
}

// The spectra of one satellite's rows; how many rows of the table were written.
static size_t write_satellite(const orr_cli *c, FILE *f, const orr_elements_row *row, size_t n, double step_d,
                              double *t_d, double *y)
{
    static const char *const NAME[] = {"a_m", "e", "i_deg"};
    double period_d[PERIODS], amplitude[PERIODS], windowed[PERIODS], explained[PERIODS];
    char sat[ORR_SAT_TEXT];
    orr_sat_text(row->sat, sat);
    for (size_t i = 0; i < n; i++) t_d[i] = orr_time_diff_s(row[i].t, row[0].t) / ORR_S_PER_DAY;
    const double least = 3 * step_d, most = t_d[n - 1] / SPAN_SHARE;
    size_t written = 0;
    if (n < LEAST_ROWS || !(most > least)) return 0;
    for (int which = 0; which < 3; which++) {
        for (size_t i = 0; i < n; i++) y[i] = element(&row[i].k, which);
        for (size_t k = 0; k < PERIODS; k++) {
            period_d[k] = least * pow(most / least, (double)k / (PERIODS - 1));
            amplitude[k] = windowed[k] = explained[k] = 0;
            if (orr_line_amplitude(t_d, y, n, period_d[k], false, &amplitude[k], &explained[k], NULL) !=
                    ORR_OK ||
                orr_line_amplitude(t_d, y, n, period_d[k], true, &windowed[k], NULL, NULL) != ORR_OK)
                continue;
            fprintf(f, "%s,%s,%.8g,%.6g,%.6g,%.6g\n", sat, NAME[which], period_d[k], amplitude[k],
                    windowed[k], explained[k]);
            written++;
        }
    }
    say_peaks(c, sat, period_d, amplitude, windowed, explained); // of the last, the inclination
    return written;
}

orr_status elements_periods_write(const orr_cli *c, elements_periods *x, double step_d, const char *path,
                                  orr_diag *diag)
{
    orr_outfile out;
    double *t_d = calloc(x->n + 1, sizeof *t_d), *y = calloc(x->n + 1, sizeof *y);
    orr_status s = t_d != NULL && y != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK) s = orr_outfile_open(path, &out, diag);
    if (s == ORR_OK) {
        size_t written = 0;
        qsort(x->row, x->n, sizeof *x->row, by_satellite);
        fputs("sat,element,period_d,amplitude,windowed,explained\n", out.stream);
        for (size_t i = 0, end; i < x->n; i = end) {
            for (end = i; end < x->n && x->row[end].sat == x->row[i].sat;) end++;
            written += write_satellite(c, out.stream, &x->row[i], end - i, step_d, t_d, y);
        }
        if (written == 0)
            s = orr_diag_set(diag, ORR_E_NODATA,
                             "no satellite has the %d rows over three steps and more that --periods needs",
                             LEAST_ROWS);
        s = orr_outfile_end(&out, s, diag);
    }
    free(t_d);
    free(y);
    return s;
}
