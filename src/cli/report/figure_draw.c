// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/robust.h"
#include "src/cli/frame/plot.h"
#include "src/cli/report/figure.h"

#define MOST_LINES 24
#define MOST_WORDS 200
#define LONGEST 4096
#define ENOUGH 4000 // points of a line; more are not seen

typedef struct curve {
    char name[64];
    double *x, *y;
    size_t n;
} curve;

typedef struct table {
    curve line[MOST_LINES];
    size_t n;
    orr_time first;           // of x that is an instant
    char word[MOST_WORDS][8]; // of x that is one
    size_t n_words;
} table;

// A number, an instant as hours since the first, or the place of a word among the words so far, from 1.
static double value(table *t, const char *text, bool is_x)
{
    char *end;
    const double v = strtod(text, &end);
    orr_time at;
    if (end != text && *end == '\0') return v;
    if (!is_x || text[0] == '\0') return ORR_NAN;
    if (orr_time_parse(text, NULL, &at, NULL) == ORR_OK) {
        // Hours of the day on which the table begins.
        if (t->first == ORR_TIME_NONE) t->first = at - orr_floor_mod(at, 86400 * ORR_NS_PER_S);
        return orr_time_diff_s(at, t->first) / 3600;
    }
    size_t k = 0;
    while (k < t->n_words && strcmp(t->word[k], text) != 0) k++;
    if (k == MOST_WORDS) return ORR_NAN;
    if (k == t->n_words) snprintf(t->word[t->n_words++], sizeof t->word[0], "%.7s", text);
    return (double)k + 1;
}

static bool add(table *t, const char *name, double x, double y)
{
    size_t k = 0;
    while (k < t->n && strcmp(t->line[k].name, name) != 0) k++;
    if (k == MOST_LINES) return true; // more cannot be told apart in a figure
    curve *c = &t->line[k];
    if (k == t->n) snprintf(t->line[t->n++].name, sizeof c->name, "%.63s", name);
    if (!ORR_ARRAY_GROW(c->x, c->n) || !ORR_ARRAY_GROW(c->y, c->n)) return false;
    c->x[c->n] = x;
    c->y[c->n++] = y;
    return true;
}

// One part of what is drawn: a file and a column of it.
typedef struct part {
    char name[64], file[128], column[64]; // name: of the line; empty: as the rows say
    char sign;                            // '-', '+', or 0
} part;

static double signed_value(double v, char sign) { return sign == '-' ? -v : sign == '+' ? fabs(v) : v; }

// Whether a text is one of those that '|' divides.
static bool is_one_of(const char *text, const char *list)
{
    const size_t length = strlen(text);
    for (;;) {
        const size_t n = strcspn(list, "|");
        if (n == length && strncmp(list, text, n) == 0) return true;
        if (list[n] == '\0') return false;
        list += n + 1;
    }
}

// Whether a row is one of those that "column=value|value,..." names.
static bool is_drawn(const char *where, const char *head, const char *row)
{
    char one[128], text[128];
    while (where != NULL && *where != '\0') {
        const size_t n = strcspn(where, ",");
        snprintf(one, sizeof one, "%.*s", (int)n, where);
        char *wanted = strchr(one, '=');
        if (wanted == NULL) return false;
        *wanted++ = '\0';
        const int k = figure_column(head, one);
        figure_field(row, k < 0 ? 99 : k, text, sizeof text);
        if (!is_one_of(text, wanted)) return false;
        where += n + (where[n] == ',');
    }
    return true;
}

// Reads the rows of a file into lines; of a map their value goes into the line's name's place.
static orr_status read_part(const figure_plot *p, const part *q, const char *folder, table *t, orr_diag *diag)
{
    char path[1200], first[LONGEST], line[LONGEST], text[3][128];
    snprintf(path, sizeof path, "%s/%s", folder, q->file);
    FILE *f = fopen(path, "r");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    const char *head = fgets(first, sizeof first, f);
    char by[64] = "";
    if (p->line != NULL) snprintf(by, sizeof by, "%.63s", p->line);
    const bool by_letter = by[0] != '\0' && by[strlen(by) - 1] == '.';
    if (by_letter) by[strlen(by) - 1] = '\0';
    const char *wanted[3] = {p->x, q->column, p->line != NULL ? by : NULL};
    int column[3];
    orr_status s = ORR_OK;
    for (int k = 0; k < 3 && s == ORR_OK; k++) {
        column[k] = head != NULL ? figure_column(head, wanted[k]) : -1;
        if (column[k] < 0 && wanted[k] != NULL)
            s = orr_diag_at(diag, ORR_E_FORMAT, path, 1, 0, "has no column %s", wanted[k]);
    }
    while (s == ORR_OK && fgets(line, sizeof line, f) != NULL) {
        if (!is_drawn(p->where, head, line)) continue;
        for (int k = 0; k < 3; k++)
            figure_field(line, column[k] < 0 ? 99 : column[k], text[k], sizeof text[k]);
        const double x = value(t, text[0], true),
                     y = signed_value(value(t, text[1], false) * p->factor, q->sign);
        if ((p->from != 0 || p->to != 0) && !(x >= p->from && x <= p->to)) continue;
        if (by_letter) text[2][1] = '\0';
        const char *name = q->name[0] != '\0' ? q->name : text[2];
        const bool kept = p->kind == FIGURE_MAP
                              ? add(t, "", x, y) && add(t, "value", x, value(t, text[2], false))
                              : add(t, name, x, y);
        if (!kept) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the table %s", path);
    }
    fclose(f);
    return s;
}

// The next of several that '|' divides; false at the end.
static bool next_of(const char **list, char *out, size_t n)
{
    if (**list == '\0') return false;
    const size_t length = strcspn(*list, "|");
    snprintf(out, n, "%.*s", (int)length, *list);
    *list += length + ((*list)[length] == '|');
    return true;
}

// Takes "name=" off the front, where it is there.
static void take_name(const char **text, char *name, size_t n)
{
    const size_t length = strcspn(*text, "=");
    if ((*text)[length] != '=') return;
    snprintf(name, n, "%.*s", (int)length, *text);
    *text += length + 1;
}

// Every file of a figure, and every column of it.
static orr_status read_table(const figure_plot *p, const char *folder, table *t, orr_diag *diag)
{
    char one[256];
    orr_status s = ORR_OK;
    for (const char *files = p->csv; s == ORR_OK && next_of(&files, one, sizeof one);) {
        part q = {.sign = 0};
        const char *rest = one;
        take_name(&rest, q.name, sizeof q.name);
        const size_t n = strcspn(rest, ":");
        snprintf(q.file, sizeof q.file, "%.*s", (int)n, rest);
        char column[128];
        const char *columns = rest[n] == ':' ? rest + n + 1 : p->y;
        while (s == ORR_OK && next_of(&columns, column, sizeof column)) {
            rest = column;
            take_name(&rest, q.name, sizeof q.name);
            q.sign = *rest == '-' || *rest == '+' ? *rest++ : '\0';
            snprintf(q.column, sizeof q.column, "%.63s", rest);
            s = read_part(p, &q, folder, t, diag);
        }
    }
    return s;
}

// A way across the date line is two.
static void cut_longitudes(curve *c)
{
    for (size_t k = 1; k < c->n; k++)
        if (fabs(c->x[k] - c->x[k - 1]) > 180) c->y[k] = ORR_NAN;
}

// A track that sets and rises again is two.
static void cut_tracks(curve *c)
{
    static const double FAR_DEG = 15;
    for (size_t k = 1; k < c->n; k++) {
        double x0, y0, x1, y1;
        orr_plot_sky_place(c->x[k - 1], c->y[k - 1], &x0, &y0);
        orr_plot_sky_place(c->x[k], c->y[k], &x1, &y1);
        if (hypot(x1 - x0, y1 - y0) > FAR_DEG) c->y[k] = ORR_NAN;
    }
}

// Where a line goes back in time, as of one satellite after another, it is another.
static void cut_returns(curve *c)
{
    for (size_t k = 0; k + 1 < c->n; k++)
        if (c->x[k + 1] < c->x[k]) c->y[k] = ORR_NAN;
}

// Makes of values at the middles of steps their stairs: each reaches halfway to its neighbours, on a logarithmic axis by ratio.
static bool make_stairs(curve *c, bool log_x)
{
    double *x = c->n > 1 ? malloc(2 * c->n * sizeof *x) : NULL,
           *y = c->n > 1 ? malloc(2 * c->n * sizeof *y) : NULL;
    if (x == NULL || y == NULL) {
        free(x);
        free(y);
        return c->n <= 1;
    }
    for (size_t k = 0; k < c->n; k++) {
        const size_t next = k + 1 < c->n ? k : k - 1; // the last step is as wide as that before it
        const double half = log_x ? sqrt(c->x[next + 1] / c->x[next]) : (c->x[next + 1] - c->x[next]) / 2;
        x[2 * k] = log_x ? c->x[k] / half : c->x[k] - half;
        x[2 * k + 1] = log_x ? c->x[k] * half : c->x[k] + half;
        y[2 * k] = y[2 * k + 1] = c->y[k];
    }
    free(c->x);
    free(c->y);
    c->x = x, c->y = y;
    c->n *= 2;
    return true;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const curve *)a)->name, ((const curve *)b)->name);
}

// A line of instants is interrupted where more than that many of its usual steps are missing.
#define MOST_STEPS 2.5

// Interrupts a line where rows are missing: its last point before that is left out.
static void cut_gaps(curve *c)
{
    double *step = c->n > 2 ? malloc(c->n * sizeof *step) : NULL;
    if (step == NULL) return;
    for (size_t k = 1; k < c->n; k++) step[k - 1] = c->x[k] - c->x[k - 1];
    const double usual = orr_median(step, c->n - 1);
    free(step);
    for (size_t k = 0; k + 1 < c->n; k++)
        if (c->x[k + 1] - c->x[k] > MOST_STEPS * usual) c->y[k] = ORR_NAN;
}

static void centre(curve *c)
{
    double sum = 0;
    size_t n = 0;
    for (size_t k = 0; k < c->n; k++)
        if (isfinite(c->y[k])) sum += c->y[k], n++;
    for (size_t k = 0; k < c->n; k++) c->y[k] -= sum / (double)n;
}

// Upright lines "name=x|name=x" over the height of the others; those beyond them are left out.
static bool add_marks(table *t, const char *marks)
{
    char one[64];
    double from = HUGE_VAL, to = -HUGE_VAL, low = HUGE_VAL, high = 0;
    for (size_t k = 0; k < t->n; k++)
        for (size_t i = 0; i < t->line[k].n; i++) {
            from = fmin(from, t->line[k].x[i]);
            to = fmax(to, t->line[k].x[i]);
            low = fmin(low, t->line[k].y[i]);
            high = fmax(high, t->line[k].y[i]);
        }
    while (marks != NULL && next_of(&marks, one, sizeof one)) {
        char *sign = strchr(one, '=');
        const double x = sign != NULL ? strtod(sign + 1, NULL) : ORR_NAN;
        if (!(x >= from && x <= to)) continue;
        *sign = '\0';
        if (!add(t, one, x, low) || !add(t, one, x, high)) return false;
    }
    return true;
}

// Every k-th point where there are more than a figure shows.
static void thin_out(curve *c)
{
    const size_t step = c->n / ENOUGH + 1;
    size_t kept = 0;
    for (size_t i = 0; i < c->n; i += step, kept++) {
        c->x[kept] = c->x[i];
        c->y[kept] = c->y[i];
    }
    c->n = kept;
}

// The distance of neighbouring values of a lattice: the least that is not nothing.
static double spacing(const double *v, size_t n)
{
    double least = 0;
    for (size_t k = 1; k < n; k++) {
        const double d = fabs(v[k] - v[k - 1]);
        if (d > 0 && (least == 0 || d < least)) least = d;
    }
    return least > 0 ? least : 1;
}

// Whether a line is the negative of the one before it: sigma and -sigma are drawn alike.
static bool is_other_side(const curve *before, const curve *c)
{
    return before != NULL && c->name[0] == '-' && strcmp(c->name + 1, before->name) == 0;
}

orr_status figure_draw(const figure *f, const char *folder, orr_diag *diag)
{
    char path[1200], png[80];
    table *t = calloc(1, sizeof *t);
    orr_plot_line line[MOST_LINES] = {{0}};
    orr_plot_cells cells = {0};
    if (t == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    t->first = ORR_TIME_NONE;
    const bool is_map = f->plot.kind == FIGURE_MAP;
    orr_status s = read_table(&f->plot, folder, t, diag);
    const size_t n_drawn = t->n;
    if (f->plot.kind == FIGURE_SKY) qsort(t->line, t->n, sizeof t->line[0], by_name);
    if (s == ORR_OK && !add_marks(t, f->plot.more.marks))
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < t->n && !is_map; k++) {
        const bool instants = strcmp(f->plot.x, "t_gps") == 0 && f->plot.kind == FIGURE_LINES;
        for (size_t i = 0; f->plot.more.days && i < t->line[k].n; i++) t->line[k].x[i] /= 24;
        if (instants) cut_returns(&t->line[k]);
        if (instants) cut_gaps(&t->line[k]);
        if (f->plot.more.stairs && !make_stairs(&t->line[k], f->plot.log_x))
            s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        if (f->plot.more.centred) centre(&t->line[k]);
        thin_out(&t->line[k]);
        if (f->plot.kind == FIGURE_SKY) cut_tracks(&t->line[k]);
        if (strcmp(f->plot.x, "lon_deg") == 0) cut_longitudes(&t->line[k]);
        const size_t look = is_other_side(k > 0 ? &t->line[k - 1] : NULL, &t->line[k]) ? k - 1 : k;
        line[k] = (orr_plot_line){.label = t->line[k].name[0] != '\0' ? t->line[k].name : NULL,
                                  .x = t->line[k].x,
                                  .y = t->line[k].y,
                                  .n = t->line[k].n,
                                  .marks = f->plot.kind == FIGURE_MARKS,
                                  .colour = (int)look,
                                  .dash = k >= n_drawn ? 1 : (int)(look + look / 8)};
    }
    if (is_map && t->n == 2)
        cells = (orr_plot_cells){.x = t->line[0].x,
                                 .y = t->line[0].y,
                                 .value = t->line[1].y,
                                 .n = t->line[0].n,
                                 .width = spacing(t->line[0].x, t->line[0].n),
                                 .height = spacing(t->line[0].y, t->line[0].n),
                                 .label = "TECU"};
    const orr_plot plot = {.title = f->title,
                           .x_label = f->plot.x_label,
                           .y_label = f->plot.y_label,
                           .log_x = f->plot.log_x,
                           .log_y = f->plot.log_y,
                           .sky = f->plot.kind == FIGURE_SKY,
                           .line = line,
                           .n = is_map ? 0 : t->n,
                           .cells = is_map ? &cells : NULL};
    snprintf(path, sizeof path, "%s/%s.svg", folder, f->name);
    if (s == ORR_OK) s = orr_plot_write(path, &plot, diag);
    snprintf(path, sizeof path, "%s/%s.gp", folder, f->name);
    snprintf(png, sizeof png, "%s.png", f->name);
    if (s == ORR_OK) s = orr_plot_write_gnuplot(path, png, &plot, diag);
    for (size_t k = 0; k < t->n; k++) {
        free(t->line[k].x);
        free(t->line[k].y);
    }
    free(t);
    return s;
}
