// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/frame/plot.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/constants.h"
#include "core/nan.h"
#include "core/outfile.h"

// The sheet, and the field in it, in pixels.
#define WIDTH 900.0
#define HEIGHT 560.0
#define LEFT 90.0
#define TOP 46.0
#define RIGHT 660.0
#define BOTTOM 490.0

// After Okabe and Ito, darkened where white paper needs it.
static const char *const palette[] = {"#0072b2", "#d55e00", "#007a58", "#a5467e",
                                      "#b08400", "#4b4fa3", "#5b5b5b", "#8a3b12"};
enum { COLOURS = sizeof palette / sizeof palette[0] };

const char *orr_plot_colour(size_t k) { return palette[k % COLOURS]; }

void orr_plot_sky_place(double az_deg, double el_deg, double *x, double *y)
{
    const double r = 90 - el_deg, az = az_deg * ORR_RAD_PER_DEG;
    *x = r * sin(az);
    *y = r * cos(az);
}

size_t orr_plot_sky_name(const orr_plot_line *l)
{
    size_t best = l->n, longest = 0;
    for (size_t k = 0, begin = 0; k <= l->n; k++) {
        if (k < l->n && isfinite(l->x[k]) && l->y[k] >= 0) continue;
        if (k - begin > longest) longest = k - begin, best = (begin + k) / 2;
        begin = k + 1;
    }
    return best;
}

void orr_plot_shade(double part, int rgb[3])
{
    // Stops of a scale from dark blue over green to yellow, whose lightness rises evenly.
    static const double stop[][3] = {
        {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
    enum { STOPS = sizeof stop / sizeof stop[0] };
    const double at = fmin(fmax(part, 0), 1) * (STOPS - 1);
    const size_t k = at < STOPS - 1 ? (size_t)at : STOPS - 2;
    for (int i = 0; i < 3; i++)
        rgb[i] = (int)(stop[k][i] + (at - (double)k) * (stop[k + 1][i] - stop[k][i]) + 0.5);
}

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

enum { DASHES = 4 };

// A mark about a place: a disc, a square, a triangle or a lozenge, all of about one size.
static void put_mark(FILE *f, const orr_plot_line *l, double x, double y)
{
    const char *colour = orr_plot_colour((size_t)l->colour);
    static const char *const shape[DASHES] = {"", "m-2.2 -2.2h4.4v4.4h-4.4z", "m0 -3l2.8 4.8h-5.6z",
                                              "m0 -3.2l2.6 3.2l-2.6 3.2l-2.6 -3.2z"};
    if (l->dash % DASHES == 0)
        fprintf(f, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"2.5\" fill=\"%s\"/>\n", x, y, colour);
    else
        fprintf(f, "<path fill=\"%s\" d=\"M%.2f %.2f%s\"/>\n", colour, x, y, shape[l->dash % DASHES]);
}

static const char *dash_of(const orr_plot_line *l)
{
    static const char *const pattern[DASHES] = {"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 3\"",
                                                " stroke-dasharray=\"9 3 2 3\""};
    return pattern[l->dash % DASHES];
}

static void put_line(FILE *f, const orr_plot_line *l, const axis *x, const axis *y)
{
    const char *colour = orr_plot_colour((size_t)l->colour);
    if (l->marks) {
        for (size_t k = 0; k < l->n; k++)
            if (shown(x, l->x[k]) && shown(y, l->y[k])) put_mark(f, l, place(x, l->x[k]), place(y, l->y[k]));
    } else {
        bool down = false;
        fprintf(f, "<path class=\"line\" stroke=\"%s\"%s d=\"", colour, dash_of(l));
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
            put_mark(f, l, RIGHT + 24.0, y);
        else
            fprintf(f, "<path class=\"line\" stroke=\"%s\"%s d=\"M%.1f %.1fH%.1f\"/>\n",
                    orr_plot_colour((size_t)l->colour), dash_of(l), RIGHT + 12.0, y, RIGHT + 36.0);
        put_label(f, RIGHT + 42.0, y + 4.0, "start", l->label);
        y += 18.0;
    }
}

// Rings of 0, 30 and 60 degrees and what is North.
static void put_sky(FILE *f, const axis *x, const axis *y)
{
    static const char *const names[] = {"N", "E", "S", "W"};
    const double cx = place(x, 0), cy = place(y, 0), per_deg = (place(x, 90) - cx) / 90;
    char text[16];
    for (int el = 0; el < 90; el += 30) {
        const double r = (90 - el) * per_deg;
        fprintf(f, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" class=\"grid\"/>\n", cx, cy, r);
        snprintf(text, sizeof text, "%d\xc2\xb0", el);
        put_label(f, cx + 3, cy - r + 13, "start", text);
    }
    for (int k = 0; k < 4; k++) {
        double e, n;
        orr_plot_sky_place(90.0 * k, -6, &e, &n);
        put_label(f, cx + e * per_deg, cy - n * per_deg + 4, "middle", names[k]);
        orr_plot_sky_place(90.0 * k, 0, &e, &n);
        fprintf(f, "<path class=\"grid\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", cx, cy, cx + e * per_deg,
                cy - n * per_deg);
    }
}

static void shade_limits(const orr_plot_cells *c, double *low, double *high)
{
    *low = DBL_MAX;
    *high = -DBL_MAX;
    for (size_t k = 0; k < c->n; k++)
        if (isfinite(c->value[k])) {
            *low = fmin(*low, c->value[k]);
            *high = fmax(*high, c->value[k]);
        }
    if (!(*high > *low)) *high = *low + 1;
}

static void put_cells(FILE *f, const orr_plot_cells *c, const axis *x, const axis *y)
{
    double low, high;
    int rgb[3];
    shade_limits(c, &low, &high);
    for (size_t k = 0; k < c->n; k++) {
        if (!isfinite(c->value[k])) continue;
        const double a = place(x, fmax(c->x[k] - c->width / 2, x->low)),
                     b = place(x, fmin(c->x[k] + c->width / 2, x->high));
        const double top = place(y, fmin(c->y[k] + c->height / 2, y->high)),
                     end = place(y, fmax(c->y[k] - c->height / 2, y->low));
        orr_plot_shade((c->value[k] - low) / (high - low), rgb);
        fprintf(f, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"#%02x%02x%02x\"/>\n", a,
                top, b - a + 0.3, end - top + 0.3, (unsigned)rgb[0], (unsigned)rgb[1], (unsigned)rgb[2]);
    }
    for (int k = 0; k < 64; k++) { // the scale
        const double h = (BOTTOM - TOP) / 64;
        orr_plot_shade((k + 0.5) / 64, rgb);
        fprintf(f, "<rect x=\"%.1f\" y=\"%.2f\" width=\"18\" height=\"%.2f\" fill=\"#%02x%02x%02x\"/>\n",
                RIGHT + 14, BOTTOM - (k + 1) * h, h + 0.3, (unsigned)rgb[0], (unsigned)rgb[1],
                (unsigned)rgb[2]);
    }
    axis scale = {.low = low, .high = high, .from = BOTTOM, .to = TOP};
    const double step = tick_step(&scale);
    for (double v = step * ceil(low / step - 1e-9); v <= high + 1e-9 * step; v += step) {
        char text[32];
        snprintf(text, sizeof text, "%.6g", fabs(v) < 1e-9 * step ? 0.0 : v);
        put_label(f, RIGHT + 38, place(&scale, v) + 4, "start", text);
    }
    put_label(f, RIGHT + 14, TOP - 8, "start", c->label);
}

// What the axes have to hold.
static void find_limits(const orr_plot *plot, axis *x, axis *y)
{
    for (size_t i = 0; i < plot->n; i++)
        for (size_t k = 0; k < plot->line[i].n; k++) {
            const orr_plot_line *l = &plot->line[i];
            if (!shown(x, l->x[k]) || !shown(y, l->y[k])) continue;
            widen(x, l->x[k]);
            widen(y, l->y[k]);
            if (l->low != NULL && l->high != NULL) {
                widen(y, l->low[k]);
                widen(y, l->high[k]);
            }
        }
    for (size_t k = 0; plot->cells != NULL && k < plot->cells->n; k++) {
        widen(x, plot->cells->x[k]);
        widen(y, plot->cells->y[k]);
    }
}

static orr_status write_sky_lines(FILE *f, const orr_plot *plot, const axis *x, const axis *y, orr_diag *diag)
{
    put_sky(f, x, y);
    for (size_t i = 0; i < plot->n; i++) {
        const orr_plot_line *l = &plot->line[i];
        double *turned = calloc(2 * l->n + 1, sizeof *turned);
        if (turned == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t k = 0; k < l->n; k++)
            orr_plot_sky_place(l->x[k], l->y[k] >= 0 ? l->y[k] : ORR_NAN, &turned[k], &turned[l->n + k]);
        orr_plot_line mine = *l;
        mine.x = turned;
        mine.y = turned + l->n;
        put_line(f, &mine, x, y);
        const size_t at = orr_plot_sky_name(l);
        if (at < l->n && l->label != NULL)
            put_label(f, place(x, mine.x[at]) + 5, place(y, mine.y[at]) - 4, "start", l->label);
        free(turned);
    }
    return ORR_OK;
}

orr_status orr_plot_write(const char *path, const orr_plot *plot, orr_diag *diag)
{
    axis x = {plot->log_x, DBL_MAX, -DBL_MAX, LEFT, RIGHT}, y = {plot->log_y, DBL_MAX, -DBL_MAX, BOTTOM, TOP};
    find_limits(plot, &x, &y);
    if (x.low > x.high)
        return orr_diag_set(diag, ORR_E_NODATA, "%s: no point of '%s' can be shown", path, plot->title);
    const double side = BOTTOM - TOP;
    if (plot->sky) { // a square in the sheet's middle
        x = (axis){false, -100, 100, 0.5 * (LEFT + RIGHT - side), 0.5 * (LEFT + RIGHT + side)};
        y = (axis){false, -100, 100, BOTTOM, TOP};
    } else if (plot->cells != NULL) { // to the cells' outer edges
        x.low -= plot->cells->width / 2, x.high += plot->cells->width / 2;
        y.low -= plot->cells->height / 2, y.high += plot->cells->height / 2;
    } else {
        round_limits(&x);
        round_limits(&y);
    }
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    FILE *f = out.stream;
    fprintf(
        f,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
        "font-family=\"sans-serif\" "
        "font-size=\"12\">\n<!-- made by orrery "
        "-->\n<style>.grid{stroke:#ddd}.line{fill:none;stroke-width:1.4}</style>\n"
        "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
        WIDTH, HEIGHT, WIDTH, HEIGHT);
    if (plot->sky) {
        s = write_sky_lines(f, plot, &x, &y, diag);
    } else {
        if (plot->cells != NULL) put_cells(f, plot->cells, &x, &y);
        put_grid(f, &x, false);
        put_grid(f, &y, true);
        fprintf(
            f,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" stroke=\"black\"/>\n",
            LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP);
        for (size_t k = 0; k < plot->n; k++) put_line(f, &plot->line[k], &x, &y);
        put_label(f, 0.5 * (LEFT + RIGHT), BOTTOM + 42.0, "middle", plot->x_label);
        fprintf(f, "<g transform=\"rotate(-90 20 %.1f)\">", 0.5 * (TOP + BOTTOM));
        put_label(f, 20.0, 0.5 * (TOP + BOTTOM), "middle", plot->y_label);
        fputs("</g>\n", f);
    }
    put_legend(f, plot);
    put_label(f, 0.5 * (LEFT + RIGHT), TOP - 18.0, "middle", plot->title);
    fputs("</svg>\n", f);
    return orr_outfile_end(&out, s, diag);
}
