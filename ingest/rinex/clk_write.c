// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX clock files, version 3.00, of satellites.
#include <math.h>
#include <string.h>

#include "core/outfile.h"
#include "ingest/rinex/clk.h"

static void line(FILE *f, const char *text, const char *label) { fprintf(f, "%-60.60s%s\n", text, label); }

static void write_header(FILE *f, const orr_clk *x)
{
    char text[120];
    snprintf(text, sizeof text, "%9.2f           C                   %c", 3.00, x->system);
    line(f, text, "RINEX VERSION / TYPE");
    snprintf(text, sizeof text, "%-20.20s%-20.20s%-20.20s", x->program, x->run_by, x->date);
    line(f, text, "PGM / RUN BY / DATE");
    snprintf(text, sizeof text, "   %s", orr_scale_name(x->scale));
    line(f, text, "TIME SYSTEM ID");
    line(f, "     1    AS", "# / TYPES OF DATA");
    snprintf(text, sizeof text, "%-3.3s  %-55.55s", "ORR", x->agency);
    line(f, text, "ANALYSIS CENTER");
    snprintf(text, sizeof text, "%6zu", x->n_sats);
    line(f, text, "# OF SOLN SATS");
    for (size_t k = 0; k < x->n_sats; k += 15) {
        size_t at = 0;
        text[0] = '\0';
        for (size_t j = k; j < x->n_sats && j < k + 15; j++)
            at += (size_t)snprintf(text + at, sizeof text - at, "%s ", x->sat[j].name);
        line(f, text, "PRN LIST");
    }
    line(f, "", "END OF HEADER");
}

orr_status orr_clk_write(const orr_clk *x, const char *path, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    write_header(out.stream, x);
    for (size_t i = 0; i < x->n_epochs; i++)
        for (size_t k = 0; k < x->n_sats; k++) {
            const orr_clk_series *c = &x->sat[k];
            orr_civil t;
            // Series may have holes: their records ascend, as the epochs do.
            size_t low = 0, high = c->n;
            while (low < high) {
                const size_t mid = low + (high - low) / 2;
                if (c->record[mid].t < x->epoch[i])
                    low = mid + 1;
                else
                    high = mid;
            }
            if (low == c->n || c->record[low].t != x->epoch[i] || !isfinite(c->record[low].bias_s)) continue;
            orr_time_to_civil(x->epoch[i], x->scale, x->leap, &t);
            const double sdev_s = c->record[low].bias_sdev_s;
            const bool told = isfinite(sdev_s) && sdev_s > 0;
            fprintf(out.stream, "AS %-4s %4d %02d %02d %02d %02d %9.6f %2d   %19.12E", c->name, t.year,
                    t.month, t.day, t.hour, t.minute, t.second + t.ns * 1e-9, told ? 2 : 1,
                    c->record[low].bias_s);
            if (told) fprintf(out.stream, " %19.12E", sdev_s);
            fputc('\n', out.stream);
        }
    return orr_outfile_commit(&out, diag);
}
