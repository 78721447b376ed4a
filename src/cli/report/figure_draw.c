// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "src/cli/frame/plot.h"
#include "src/cli/report/figure.h"

#define MOST_LINES 24
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
    int column[3];  // x, y, name of the line; -1: none
    orr_time first; // of x that is an instant
} table;

// The k-th field of a line of CSV, from 0; empty where there are not so many.
static void field(const char *text, int k, char *out, size_t n)
{
    for (; k > 0 && *text != '\0'; text++) k -= *text == ',';
    snprintf(out, n, "%.*s", (int)strcspn(text, ",\r\n"), text);
}

static int column_of(const char *head, const char *name)
{
    char text[128];
    for (int k = 0; name != NULL && k < 64; k++) {
        field(head, k, text, sizeof text);
        if (strcmp(text, name) == 0) return k;
    }
    return -1;
}

// A number, or an instant as hours since the first.
static double value(table *t, const char *text, bool is_x)
{
    char *end;
    const double v = strtod(text, &end);
    orr_time at;
    if (end != text && *end == '\0') return v;
    if (!is_x || orr_time_parse(text, NULL, &at, NULL) != ORR_OK) return ORR_NAN;
    if (t->first == ORR_TIME_NONE) t->first = at;
    return orr_time_diff_s(at, t->first) / 3600;
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

static orr_status read_table(const figure_plot *p, const char *path, table *t, orr_diag *diag)
{
    char line[LONGEST], text[3][128];
    FILE *f = fopen(path, "r");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    const char *head = fgets(line, sizeof line, f);
    const char *wanted[3] = {p->x, p->y, p->line};
    orr_status s = ORR_OK;
    for (int k = 0; k < 3 && s == ORR_OK; k++) {
        t->column[k] = head != NULL ? column_of(head, wanted[k]) : -1;
        if (t->column[k] < 0 && wanted[k] != NULL)
            s = orr_diag_at(diag, ORR_E_FORMAT, path, 1, 0, "has no column %s", wanted[k]);
    }
    while (s == ORR_OK && fgets(line, sizeof line, f) != NULL) {
        for (int k = 0; k < 3; k++)
            field(line, t->column[k] < 0 ? 99 : t->column[k], text[k], sizeof text[k]);
        const double x = value(t, text[0], true), y = value(t, text[1], false) * p->factor;
        if ((p->from != 0 || p->to != 0) && !(x >= p->from && x <= p->to)) continue;
        if (!add(t, text[2], x, y)) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the table %s", path);
    }
    fclose(f);
    return s;
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

orr_status figure_draw(const figure *f, const char *folder, orr_diag *diag)
{
    char path[1200];
    table t = {.first = ORR_TIME_NONE};
    orr_plot_line line[MOST_LINES] = {{0}};
    snprintf(path, sizeof path, "%s/%s", folder, f->plot.csv);
    orr_status s = read_table(&f->plot, path, &t, diag);
    for (size_t k = 0; k < t.n; k++) {
        thin_out(&t.line[k]);
        line[k] = (orr_plot_line){.label = t.line[k].name[0] != '\0' ? t.line[k].name : NULL,
                                  .x = t.line[k].x,
                                  .y = t.line[k].y,
                                  .n = t.line[k].n,
                                  .colour = (int)k,
                                  .dashed = k >= 8};
    }
    const orr_plot plot = {.title = f->title,
                           .x_label = f->plot.x_label,
                           .y_label = f->plot.y_label,
                           .log_x = f->plot.log_x,
                           .log_y = f->plot.log_y,
                           .line = line,
                           .n = t.n};
    snprintf(path, sizeof path, "%s/%s.svg", folder, f->name);
    if (s == ORR_OK) s = orr_plot_write(path, &plot, diag);
    for (size_t k = 0; k < t.n; k++) {
        free(t.line[k].x);
        free(t.line[k].y);
    }
    return s;
}
