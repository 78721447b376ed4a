// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/frame/plot.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "core/outfile.h"

// The sheet, and the field in it, in pixels.
#define WIDTH 900.0
#define HEIGHT 560.0
#define LEFT 90.0
#define TOP 46.0
#define RIGHT 660.0
#define BOTTOM 490.0

static const char *const palette[] = {"#0060a8", "#c03020", "#2a8a3a", "#8a4aa8",
                                      "#c08000", "#007a80", "#606060", "#b04080"};
enum { COLOURS = sizeof palette / sizeof palette[0] };

// An axis: values from low to high stand between the pixels `from` and `to`. Logarithmic ones hold decades.
typedef struct axis {
    bool log;
    double low, high, from, to;
} axis;

static bool shown(const axis *a, double v) { return isfinite(v) && (!a->log || v > 0.0); }
static double scaled(const axis *a, double v) { return a->log ? log10(v) : v; }
static double place(const axis *a, double v)
{
    return a->from + (scaled(a, v) - a->low) / (a->high - a->low) * (a->to - a->from);
}

static void widen(axis *a, double v)
{
    if (!shown(a, v)) return;
    a->low = fmin(a->low, scaled(a, v));
    a->high = fmax(a->high, scaled(a, v));
}

// 1, 2 or 5 times a power of ten, about a sixth of the range.
static double tick_step(const axis *a)
{
    const double rough = (a->high - a->low) / 6.0, power = pow(10.0, floor(log10(rough))), m = rough / power;
    const double step = power * (m < 1.5 ? 1.0 : m < 3.5 ? 2.0 : m < 7.5 ? 5.0 : 10.0);
    return a->log ? fmax(1.0, round(step)) : step;
}

// Limits that hold all, at whole ticks where the axis is linear, at least a tenth of a decade where it is not.
static void round_limits(axis *a)
{
    if (!(a->high > a->low)) {
        const double half = a->log ? 0.5 : fmax(fabs(a->low) * 0.1, DBL_MIN * 1e6);
        a->low -= half;
        a->high += half;
    }
    if (a->log) {
        const double margin = 0.03 * (a->high - a->low);
        a->low -= margin;
        a->high += margin;
    } else {
        const double step = tick_step(a);
        a->low = step * floor(a->low / step + 1e-9);
        a->high = step * ceil(a->high / step - 1e-9);
    }
}

static void put_text(FILE *f, const char *text)
{
    for (; text != NULL && *text != '\0'; text++)
        if (*text == '<')
            fputs("&lt;", f);
        else if (*text == '>')
            fputs("&gt;", f);
        else if (*text == '&')
            fputs("&amp;", f);
        else
            fputc(*text, f);
}

static void put_label(FILE *f, double x, double y, const char *anchor, const char *text)
{
    fprintf(f, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor);
    put_text(f, text);
    fputs("</text>\n", f);
}

static void put_grid(FILE *f, const axis *a, bool upright)
{
    const double step = tick_step(a);
    for (double k = ceil(a->low / step - 1e-9); k * step <= a->high + 1e-9 * step; k++) {
        const double v = a->log ? pow(10.0, k * step) : k * step, p = place(a, v);
        char text[32];
        snprintf(text, sizeof text, "%.6g", k == 0.0 && !a->log ? 0.0 : v);
        if (upright) {
            fprintf(f, "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/>\n", LEFT, p, RIGHT);
            put_label(f, LEFT - 8.0, p + 4.0, "end", text);
        } else {
            fprintf(f, "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/>\n", p, TOP, BOTTOM);
            put_label(f, p, BOTTOM + 18.0, "middle", text);
        }
    }
}

static void put_line(FILE *f, const orr_plot_line *l, const axis *x, const axis *y)
{
    const char *colour = palette[(size_t)l->colour % COLOURS];
    if (l->marks) {
        for (size_t k = 0; k < l->n; k++)
            if (shown(x, l->x[k]) && shown(y, l->y[k]))
                fprintf(f, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"2.5\" fill=\"%s\"/>\n", place(x, l->x[k]),
                        place(y, l->y[k]), colour);
    } else {
        bool down = false;
        fprintf(f, "<path class=\"line\" stroke=\"%s\"%s d=\"", colour,
                l->dashed ? " stroke-dasharray=\"6 4\"" : "");
        for (size_t k = 0; k < l->n; k++) {
            const bool here = shown(x, l->x[k]) && shown(y, l->y[k]);
            if (here) fprintf(f, "%c%.2f %.2f", down ? 'L' : 'M', place(x, l->x[k]), place(y, l->y[k]));
            down = here;
        }
        fputs("\"/>\n", f);
    }
    for (size_t k = 0; l->low != NULL && l->high != NULL && k < l->n; k++)
        if (shown(x, l->x[k]) && shown(y, l->low[k]) && shown(y, l->high[k]))
            fprintf(f, "<path class=\"line\" stroke=\"%s\" d=\"M%.2f %.2fV%.2f\"/>\n", colour,
                    place(x, l->x[k]), place(y, l->low[k]), place(y, l->high[k]));
}

static void put_legend(FILE *f, const orr_plot *p)
{
    double y = TOP + 10.0;
    for (size_t k = 0; k < p->n; k++) {
        const orr_plot_line *l = &p->line[k];
        if (l->label == NULL) continue;
        if (l->marks)
            fprintf(f, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", RIGHT + 24.0, y,
                    palette[(size_t)l->colour % COLOURS]);
        else
            fprintf(f, "<path class=\"line\" stroke=\"%s\"%s d=\"M%.1f %.1fH%.1f\"/>\n",
                    palette[(size_t)l->colour % COLOURS], l->dashed ? " stroke-dasharray=\"6 4\"" : "",
                    RIGHT + 12.0, y, RIGHT + 36.0);
        put_label(f, RIGHT + 42.0, y + 4.0, "start", l->label);
        y += 18.0;
    }
}

orr_status orr_plot_write(const char *path, const orr_plot *plot, orr_diag *diag)
{
    axis x = {plot->log_x, DBL_MAX, -DBL_MAX, LEFT, RIGHT}, y = {plot->log_y, DBL_MAX, -DBL_MAX, BOTTOM, TOP};
    for (size_t i = 0; i < plot->n; i++)
        for (size_t k = 0; k < plot->line[i].n; k++) {
            const orr_plot_line *l = &plot->line[i];
            if (!shown(&x, l->x[k]) || !shown(&y, l->y[k])) continue;
            widen(&x, l->x[k]);
            widen(&y, l->y[k]);
            if (l->low != NULL && l->high != NULL) {
                widen(&y, l->low[k]);
                widen(&y, l->high[k]);
            }
        }
    if (x.low > x.high)
        return orr_diag_set(diag, ORR_E_NODATA, "%s: no point of '%s' can be shown", path, plot->title);
    round_limits(&x);
    round_limits(&y);
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    FILE *f = out.stream;
    fprintf(
        f,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" font-family=\"sans-serif\" "
        "font-size=\"12\">\n<style>.grid{stroke:#ddd}.line{fill:none;stroke-width:1.4}</style>\n"
        "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
        WIDTH, HEIGHT);
    put_grid(f, &x, false);
    put_grid(f, &y, true);
    fprintf(f,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" stroke=\"black\"/>\n",
            LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP);
    for (size_t k = 0; k < plot->n; k++) put_line(f, &plot->line[k], &x, &y);
    put_legend(f, plot);
    put_label(f, 0.5 * (LEFT + RIGHT), TOP - 18.0, "middle", plot->title);
    put_label(f, 0.5 * (LEFT + RIGHT), BOTTOM + 42.0, "middle", plot->x_label);
    fprintf(f, "<g transform=\"rotate(-90 20 %.1f)\">", 0.5 * (TOP + BOTTOM));
    put_label(f, 20.0, 0.5 * (TOP + BOTTOM), "middle", plot->y_label);
    fputs("</g>\n</svg>\n", f);
    return orr_outfile_commit(&out, diag);
}
