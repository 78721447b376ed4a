// SPDX-License-Identifier: GPL-3.0-or-later
// A figure as a script of gnuplot: for a picture of pixels, and for who wants to change what it looks like.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/outfile.h"
#include "src/cli/frame/plot.h"

// Text between single quotes, of which there are none inside then.
static void put_quoted(FILE *f, const char *text)
{
    fputc('\'', f);
    for (; text != NULL && *text != '\0'; text++)
        if (*text == '\'')
            fputs("''", f);
        else
            fputc(*text, f);
    fputc('\'', f);
}

static void put_block(FILE *f, const orr_plot *plot, size_t i)
{
    const orr_plot_line *l = &plot->line[i];
    const bool bars = l->low != NULL && l->high != NULL;
    fprintf(f, "$line%zu << EOD\n", i);
    for (size_t k = 0; k < l->n; k++) {
        double x = l->x[k], y = l->y[k];
        const bool there = isfinite(x) && isfinite(y) && (!plot->log_x || x > 0) && (!plot->log_y || y > 0);
        if (!there || (plot->sky && y < 0)) {
            fputs(l->marks ? "" : "\n", f); // the line is interrupted
            continue;
        }
        if (plot->sky) orr_plot_sky_place(l->x[k], l->y[k], &x, &y);
        fprintf(f, "%.10g %.10g", x, y);
        if (bars) fprintf(f, " %.10g %.10g", l->low[k], l->high[k]);
        fputc('\n', f);
    }
    fputs("EOD\n", f);
}

static void put_sky(FILE *f)
{
    fputs("set size ratio -1\nset xrange [-100:100]\nset yrange [-100:100]\nunset xtics\nunset ytics\nunset "
          "border\n",
          f);
    for (int el = 0; el < 90; el += 30)
        fprintf(f,
                "set object circle at 0,0 size %d fs empty border lc rgb '#c8c8c8' back\nset label '%d' at "
                "1,%d\n",
                90 - el, el, 90 - el - 4);
    fputs("set label 'N' at 0,95 center\nset label 'E' at 96,0 center\nset label 'S' at 0,-95 center\nset "
          "label 'W' at -96,0 center\n",
          f);
}

// Each track's name beside it.
static void put_sky_names(FILE *f, const orr_plot *plot)
{
    for (size_t i = 0; i < plot->n; i++) {
        const orr_plot_line *l = &plot->line[i];
        const size_t at = orr_plot_sky_name(l);
        double x, y;
        if (at == l->n || l->label == NULL) continue;
        orr_plot_sky_place(l->x[at], l->y[at], &x, &y);
        fputs("set label ", f);
        put_quoted(f, l->label);
        fprintf(f, " at %.4g,%.4g left offset 0.4,0.4\n", x, y);
    }
}

static void put_cells(FILE *f, const orr_plot_cells *c)
{
    int rgb[3];
    fputs("$cells << EOD\n", f);
    for (size_t k = 0; k < c->n; k++)
        if (isfinite(c->value[k])) fprintf(f, "%.8g %.8g %.8g\n", c->x[k], c->y[k], c->value[k]);
    fputs("EOD\nset palette defined (", f);
    for (int k = 0; k <= 4; k++) {
        orr_plot_shade(k / 4.0, rgb);
        fprintf(f, "%s%d '#%02x%02x%02x'", k > 0 ? ", " : "", k, (unsigned)rgb[0], (unsigned)rgb[1],
                (unsigned)rgb[2]);
    }
    fprintf(f, ")\nset boxwidth\nset style fill solid noborder\nset cblabel ");
    put_quoted(f, c->label);
    fputc('\n', f);
}

static void put_plot(FILE *f, const orr_plot *plot)
{
    fputs("plot ", f);
    if (plot->cells != NULL)
        fprintf(f, "$cells using 1:2:(%.8g):(%.8g):3 with boxxyerror lc palette notitle%s",
                plot->cells->width * 0.52, plot->cells->height * 0.52, plot->n > 0 ? ", " : "");
    for (size_t i = 0; i < plot->n; i++) {
        const orr_plot_line *l = &plot->line[i];
        const char *colour = orr_plot_colour((size_t)l->colour);
        static const char *const pattern[] = {"", "dt 2", "dt 3", "dt 4"};
        static const char *const shape[] = {"pt 7", "pt 5", "pt 9", "pt 13"};
        fprintf(f, "%s$line%zu using 1:2 with %s lc rgb '%s' %s ", i > 0 ? ", \\\n  " : "", i,
                l->marks ? "points ps 0.9" : "lines lw 2.5", colour,
                (l->marks ? shape : pattern)[l->dash % 4]);
        if (l->label != NULL) {
            fputs("title ", f);
            put_quoted(f, l->label);
        } else {
            fputs("notitle", f);
        }
        if (l->low != NULL && l->high != NULL)
            fprintf(f, ", $line%zu using 1:2:3:4 with yerrorbars pt 0 lc rgb '%s' notitle", i, colour);
    }
    fputc('\n', f);
}

orr_status orr_plot_write_gnuplot(const char *path, const char *png, const orr_plot *plot, orr_diag *diag)
{
    orr_outfile out;
    const orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    FILE *f = out.stream;
    fputs("# Made by orrery; run by gnuplot\nset terminal pngcairo size 1800,1120 fontscale 1.6 "
          "noenhanced\nset output ",
          f);
    put_quoted(f, png);
    fputs("\nset title ", f);
    put_quoted(f, plot->title);
    fputs("\nset xlabel ", f);
    put_quoted(f, plot->sky ? "" : plot->x_label);
    fputs("\nset ylabel ", f);
    put_quoted(f, plot->sky ? "" : plot->y_label);
    fprintf(f, "\nset key outside right top\nset grid lt 1 lw 1 lc rgb '#d8d8d8'\n%s%s%s",
            plot->log_x ? "set logscale x\nset format x '%g'\n" : "",
            plot->log_y ? "set logscale y\nset format y '%g'\n" : "", plot->sky ? "unset grid\n" : "");
    if (plot->sky) put_sky(f);
    if (plot->sky) put_sky_names(f, plot);
    if (plot->cells != NULL) {
        fputs("set autoscale yfix\n", f); // no rim about a map
        put_cells(f, plot->cells);
    }
    if (!plot->sky) fputs("set autoscale xfix\n", f);
    if (plot->n > 0 && plot->line[0].marks) fputs("set offsets graph 0.02, graph 0.02, 0, 0\n", f);
    for (size_t i = 0; i < plot->n; i++) put_block(f, plot, i);
    put_plot(f, plot);
    return orr_outfile_commit(&out, diag);
}
