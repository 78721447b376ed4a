// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/report/judgement.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/robust.h"
#include "src/archive/catalogue.h"
#include "src/archive/store.h"

#define LONGEST 4096
#define UNUSUAL 6.0 // robust standard deviations of a group from the median of all, as of the archive's days

// --- Sentences ---

#define SENTENCE(which)                                                                                      \
    va_list rest;                                                                                            \
    va_start(rest, words);                                                                                   \
    if (j->n_##which < JUDGEMENT_MOST) vsnprintf(j->which[j->n_##which++], sizeof j->which[0], words, rest); \
    va_end(rest)

void judgement_processed(judgement *j, const char *words, ...) { SENTENCE(processed); }

void judgement_good(judgement *j, const char *words, ...) { SENTENCE(good); }

void judgement_suspicious(judgement *j, const char *words, ...) { SENTENCE(suspicious); }

// --- Tables ---

// Values of a table's column, or the difference of two, each with the group that its row belongs to.
typedef struct series {
    size_t n, n_groups;
    double *value;
    char (*group)[16]; // [n]
} series;

static void series_free(series *s)
{
    free(s->value);
    free(s->group);
    *s = (series){0};
}

typedef struct measure {
    const char *figure, *file;
    const char *column, *less; // the value is column less `less`, where there is one
    const char *group;         // column by which rows belong together; NULL: all do
    enum { MEASURE_RMS, MEASURE_MOST, MEASURE_WITHIN } kind;
    double factor;
    const char *unit, *words; // "Words: 0.58 mm (RMS of 7680 values)"
    double low, high;         // what it ought to be
    const char *reason;       // why
    double rounding; // last digit of what is compared with, whose error adds to the standard deviation
} measure;

// What the reports' own figures are judged by.
static const measure MEASURES[] = {
    {"fig1", "fig1.csv", "dxi1_m", NULL, NULL, MEASURE_MOST, 1e-3, "km",
     "Position along xi1 by projection at the begin of a step", 1, 200, "the source has tens of kilometres",
     0},
    {"fig2", "fig2.csv", "dxi1_m", NULL, NULL, MEASURE_MOST, 1e2, "cm",
     "Position along xi1 by projection at mid-step", 0, 100, "the source has centimetres", 0},
    {"fig10", "fig10.csv", "difference_tecu", NULL, "sat", MEASURE_RMS, 1, "TECU",
     "Two made receivers close to each other differ in slant TEC by", 0, 0.15,
     "phases are good to a hundredth, and 22 km of a smooth ionosphere change little", 0},
    {"fig10-pair", "fig10-pair.csv", "difference_tecu", NULL, "sat", MEASURE_RMS, 1, "TECU",
     "Two real receivers close to each other differ in slant TEC by", 0, 0.15,
     "phases are good to a hundredth, and 3.7 km change little", 0},
    {"fig12-flight", "flight-start.csv", "dxi1_m", NULL, NULL, MEASURE_MOST, 1, "m",
     "Position along xi1 of a real flight of 45 minutes, by projection at the begin of a step", 10, 20000,
     "its attitude moves all the time, for a third of the made flight's time", 0},
    {"fig12-flight", "flight-mid.csv", "dxi1_m", NULL, NULL, MEASURE_MOST, 1e2, "cm",
     "Position along xi1 of a real flight, by projection at mid-step", 0, 100, "the source has centimetres",
     0},
    {"satellites", "satellites.csv", "radial_m", NULL, "sat", MEASURE_RMS, 1e3, "mm",
     "Orbits differ from epochs that were not input, radially, by", 0, 1, "the files' last digit is 1 mm", 0},
    {"sigma", "gap.csv", "radial_m", "gap-states.csv:sigma_radial_m", NULL, MEASURE_WITHIN, 100, "%",
     "Of radial errors lie within the standard deviation, the truth's last digit of 1 mm reckoned with", 55,
     85, "68 % of normal errors do", 1e-3},
    {"fusion", "fusion.csv", "stec_tecu", "model_stec_tecu", NULL, MEASURE_RMS, 1, "TECU",
     "Maps alone differ from a made station's levelled phases by", 1, 4,
     "a wave of 2 TECU in the vertical is not in them", 0},
    {"fusion-station", "fusion-station.csv", "stec_tecu", "model_stec_tecu", NULL, MEASURE_RMS, 1, "TECU",
     "Maps alone differ from the station's levelled phases by", 0, 15,
     "maps are good to some TECU in the vertical", 0},
    {"gravimetry", "gravimetry.csv", "recovered_filtered_mgal", "true_filtered_mgal", NULL, MEASURE_RMS, 1e3,
     "uGal", "Gravity recovered from ideal readings differs from the truth by", 0, 1,
     "ideal readings lose nothing but rounding", 0},
};

static bool keep(series *s, double value, const char *group)
{
    size_t n = s->n;
    if (!ORR_ARRAY_GROW(s->value, s->n) || !ORR_ARRAY_GROW(s->group, n)) return false;
    s->value[s->n] = value;
    snprintf(s->group[s->n], sizeof s->group[0], "%s", group);
    s->n++;
    return true;
}

static double number_of(const char *row, int column)
{
    char text[64], *end;
    figure_field(row, column, text, sizeof text);
    const double v = strtod(text, &end);
    return column >= 0 && end != text && *end == '\0' ? v : ORR_NAN;
}

static FILE *open_table(const char *folder, const char *name, char head[LONGEST])
{
    char path[1200];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "r");
    if (f != NULL && fgets(head, LONGEST, f) == NULL) {
        fclose(f);
        return NULL;
    }
    return f;
}

// The column of another table at the instant of each row here; rows of both ascend in time.
typedef struct other_table {
    FILE *file;
    int t, column;
    char row[LONGEST];
} other_table;

static double other_at(other_table *o, const char *t)
{
    char text[40];
    for (;;) {
        figure_field(o->row, o->t, text, sizeof text);
        if (strcmp(text, t) >= 0 && o->row[0] != '\0') break;
        if (fgets(o->row, sizeof o->row, o->file) == NULL) return ORR_NAN;
    }
    return strcmp(text, t) == 0 ? number_of(o->row, o->column) : ORR_NAN;
}

static bool open_other(const measure *m, const char *folder, other_table *o)
{
    char name[64], head[LONGEST];
    const char *colon = m->less != NULL ? strchr(m->less, ':') : NULL;
    *o = (other_table){.file = NULL};
    if (colon == NULL) return true;
    snprintf(name, sizeof name, "%.*s", (int)(colon - m->less), m->less);
    o->file = open_table(folder, name, head);
    if (o->file == NULL) return false;
    o->t = figure_column(head, "t_gps");
    o->column = figure_column(head, colon + 1);
    return true;
}

// Reads what is measured; of MEASURE_WITHIN 1 where the size is below the other column, 0 where it is not.
static bool read_series(const measure *m, const char *folder, series *out)
{
    char head[LONGEST], row[LONGEST], text[40], group[16] = "";
    other_table other;
    *out = (series){0};
    FILE *f = open_table(folder, m->file, head);
    bool good = f != NULL && open_other(m, folder, &other);
    const int column = good ? figure_column(head, m->column) : -1,
              less = good ? figure_column(head, m->less) : -1, by = good ? figure_column(head, m->group) : -1,
              t = good ? figure_column(head, "t_gps") : -1;
    while (good && fgets(row, sizeof row, f) != NULL) {
        double v = number_of(row, column);
        if (by >= 0) figure_field(row, by, group, sizeof group);
        if (less >= 0) v -= number_of(row, less);
        if (m->kind == MEASURE_WITHIN) {
            figure_field(row, t, text, sizeof text);
            const double limit = other_at(&other, text);
            const double sigma = hypot(limit, m->rounding / sqrt(12)); // a rounded figure's error is uniform
            v = isfinite(v) && isfinite(limit) ? (fabs(v) <= sigma) : ORR_NAN;
        }
        if (isfinite(v)) good = keep(out, v, group);
    }
    if (f != NULL && other.file != NULL) fclose(other.file);
    if (f != NULL) fclose(f);
    return good && out->n > 0;
}

// The measure of rows of one group; of all where group is NULL.
static double value_of(const measure *m, const series *s, const char *group, size_t *n)
{
    double sum = 0, most = 0;
    *n = 0;
    for (size_t i = 0; i < s->n; i++) {
        if (group != NULL && strcmp(s->group[i], group) != 0) continue;
        const double v = s->value[i];
        sum += m->kind == MEASURE_WITHIN ? v : v * v;
        most = fmax(most, fabs(v));
        ++*n;
    }
    const double mean = sum / (double)*n;
    return m->factor * (m->kind == MEASURE_MOST ? most : m->kind == MEASURE_WITHIN ? mean : sqrt(mean));
}

// Names the groups (satellites) that are far from the others.
static void judge_groups(const measure *m, const series *s, judgement *out)
{
    enum { MOST_GROUPS = 400 };
    const char *name[MOST_GROUPS];
    double value[MOST_GROUPS], apart[MOST_GROUPS];
    size_t n = 0, rows;
    for (size_t i = 0; i < s->n && n < MOST_GROUPS; i++) {
        size_t k = 0;
        while (k < n && strcmp(name[k], s->group[i]) != 0) k++;
        if (k < n) continue;
        name[n] = s->group[i];
        value[n++] = value_of(m, s, s->group[i], &rows);
    }
    if (n < 5) return; // nothing to compare with
    memcpy(apart, value, n * sizeof *apart);
    const double median = orr_median(apart, n);
    for (size_t k = 0; k < n; k++) apart[k] = fabs(value[k] - median);
    const double limit = fmax(UNUSUAL * ORR_SIGMA_PER_MAD * orr_median(apart, n), 0.5 * median);
    for (size_t k = 0; k < n; k++)
        if (value[k] - median > limit)
            judgement_suspicious(out, "%s: %s %.3g %s, where %.3g %s is usual.", name[k], m->words, value[k],
                                 m->unit, median, m->unit);
}

void judgement_of_figure(const figure *f, const figure_places *p, judgement *out)
{
    static const char *const KIND[] = {"RMS of", "the largest of", "of"};
    for (size_t k = 0; k < sizeof MEASURES / sizeof *MEASURES; k++) {
        const measure *m = &MEASURES[k];
        series s;
        if (strcmp(m->figure, f->name) != 0) continue;
        if (!read_series(m, p->out, &s)) {
            judgement_suspicious(out, "%s: %s cannot be judged: it has no values.", f->name, m->file);
        } else {
            size_t n;
            const double v = value_of(m, &s, NULL, &n);
            judgement_good(out, "%s: %.3g %s (%s %zu values; expected: %g to %g %s, %s).", m->words, v,
                           m->unit, KIND[m->kind], n, m->low, m->high, m->unit, m->reason);
            if (!(v >= m->low && v <= m->high))
                judgement_suspicious(out, "%s: %.3g %s, which is not within %g to %g %s: %s.", m->words, v,
                                     m->unit, m->low, m->high, m->unit, m->reason);
            if (m->group != NULL) judge_groups(m, &s, out);
        }
        series_free(&s);
    }
}

// --- Archives ---

typedef double figure_of_day(const orr_catalogue_day *d);
static double residual(const orr_catalogue_day *d) { return d->all.residual_mm; }
static double sigma(const orr_catalogue_day *d) { return d->all.sigma_mm; }

static double median_of(const orr_catalogue *k, figure_of_day *of)
{
    double *v = calloc(k->n + 1, sizeof *v);
    size_t n = 0;
    for (size_t i = 0; v != NULL && i < k->n; i++)
        if (k->day[i].state == ORR_OK && isfinite(of(&k->day[i]))) v[n++] = of(&k->day[i]);
    const double median = n > 0 ? orr_median(v, n) : ORR_NAN;
    free(v);
    return median;
}

orr_status judgement_of_archive(const char *archive, judgement *out, orr_diag *diag)
{
    orr_catalogue k = {0};
    char from[ORR_ARCHIVE_DAY_TEXT], to[ORR_ARCHIVE_DAY_TEXT], day[ORR_ARCHIVE_DAY_TEXT];
    const orr_status s = orr_catalogue_make(archive, true, &k, NULL, diag);
    if (s != ORR_OK || k.n == 0) {
        if (s == ORR_OK) judgement_suspicious(out, "The archive has no days.");
        orr_catalogue_free(&k);
        return s;
    }
    const size_t missing = (size_t)(k.day[k.n - 1].mjd - k.day[0].mjd + 1) - k.n;
    double worst = 0;
    size_t joints = 0;
    judgement_processed(out, "An archive of %zu days, %s to %s; %zu are missing between.", k.n,
                        orr_archive_day_text(k.day[0].mjd, from),
                        orr_archive_day_text(k.day[k.n - 1].mjd, to), missing);
    for (size_t i = 0; i < k.n; i++) {
        const orr_catalogue_day *d = &k.day[i];
        orr_archive_day_text(d->mjd, day);
        joints += d->joint.satellites > 0;
        if (d->joint.satellites > 0) worst = fmax(worst, d->joint.max_mm);
        if (d->state != ORR_OK)
            judgement_suspicious(out, "%s: its record cannot be read (%s).", day, orr_catalogue_state(d));
        if (d->suspicion[0] != '\0') judgement_suspicious(out, "%s: %s.", day, d->suspicion);
    }
    judgement_good(out,
                   "Days of the archive: residuals of nodes %.2f mm, sigma %.2f mm, medians of the days.",
                   median_of(&k, residual), median_of(&k, sigma));
    if (joints > 0)
        judgement_good(out, "Days join within %.3f mm at %zu midnights (wanted: 0.1 mm).", worst, joints);
    if (worst > 0.1)
        judgement_suspicious(out, "A joint of days is %.3f mm wide, and not within 0.1 mm.", worst);
    if (missing > 0) judgement_suspicious(out, "%zu days are missing within the archive.", missing);
    orr_catalogue_free(&k);
    return ORR_OK;
}
