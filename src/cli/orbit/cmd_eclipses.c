// SPDX-License-Identifier: GPL-3.0-or-later
// orrery eclipses: when satellites pass through the Earth's shadow.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "orbit/spacecraft/eclipses.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/make/products.h"

typedef struct list {
    orr_eclipse *item;
    size_t n;
} list;

// A passage that one product ends within and the next begins within is one.
static const int64_t longest_joint_ns = 1800 * ORR_NS_PER_S;
static bool goes_on(const orr_eclipse *a, const orr_eclipse *b)
{
    return a->sat == b->sat && a->penumbra_to == ORR_TIME_NONE && b->penumbra_from == ORR_TIME_NONE &&
           b->from - a->to <= longest_joint_ns;
}

static void join(orr_eclipse *a, const orr_eclipse *b)
{
    if (a->umbra_from == ORR_TIME_NONE) a->umbra_from = b->umbra_from;
    if (b->umbra_to != ORR_TIME_NONE) a->umbra_to = b->umbra_to;
    a->penumbra_to = b->penumbra_to;
    a->to = b->to;
    a->umbra = a->umbra || b->umbra;
    a->umbra_known = a->umbra || (a->umbra_known && b->umbra_known);
}

// The passages of one satellite in one product, behind those that are there.
static orr_status collect_from(const orr_ephemeris *e, orr_sat sat, list *out)
{
    const size_t n = orr_eclipses_of(e, sat, NULL, 0);
    if (n == 0) return ORR_OK;
    orr_eclipse *item = realloc(out->item, (out->n + n) * sizeof *item);
    if (item == NULL) return ORR_E_MEMORY;
    out->item = item;
    orr_eclipses_of(e, sat, item + out->n, n);
    for (size_t k = out->n, end = out->n + n; k < end; k++) {
        if (out->n > 0 && goes_on(&item[out->n - 1], &item[k]))
            join(&item[out->n - 1], &item[k]);
        else
            item[out->n++] = item[k];
    }
    return ORR_OK;
}

static orr_status collect(const orr_cli *c, const orr_products *p, list *out)
{
    const orr_sat_set *wanted = orr_cli_sats(c, "sat");
    const orr_time from = orr_cli_time(c, "from", p->from), to = orr_cli_time(c, "to", p->to);
    for (size_t i = 0; i < p->n_sats; i++) {
        const size_t first = out->n;
        if (wanted != NULL && !orr_sat_set_has(wanted, p->sat[i])) continue;
        for (size_t k = 0; k < p->n; k++)
            if (collect_from(p->item[k], p->sat[i], out) != ORR_OK) return ORR_E_MEMORY;
        const size_t end = out->n;
        out->n = first;
        for (size_t k = first; k < end; k++)
            if (out->item[k].to >= from && out->item[k].from <= to) out->item[out->n++] = out->item[k];
    }
    return ORR_OK;
}

static const char *instant(orr_time t, char text[ORR_TIME_TEXT])
{
    text[0] = '\0';
    return t == ORR_TIME_NONE ? text : orr_time_format(t, ORR_SCALE_GPS, 1, NULL, text);
}

static void print(FILE *f, const list *l, char format)
{
    char sat[ORR_SAT_TEXT], text[4][ORR_TIME_TEXT];
    if (format == 'c') fputs("sat,penumbra_entry,umbra_entry,umbra_exit,penumbra_exit,shadow_s,umbra\n", f);
    if (format == 't')
        fputs("sat  penumbra (GPS time)     umbra                   umbra ends              penumbra ends    "
              "      "
              " min\n",
              f);
    if (format == 'j') fputs("[", f);
    for (size_t i = 0; i < l->n; i++) {
        const orr_eclipse *x = &l->item[i];
        const orr_time t[4] = {x->penumbra_from, x->umbra_from, x->umbra_to, x->penumbra_to};
        const double length = orr_time_diff_s(x->to, x->from);
        for (int k = 0; k < 4; k++) instant(t[k], text[k]);
        orr_sat_text(x->sat, sat);
        if (format == 'c')
            fprintf(f, "%s,%s,%s,%s,%s,%.1f,%s\n", sat, text[0], text[1], text[2], text[3], length,
                    !x->umbra_known ? ""
                    : x->umbra      ? "1"
                                    : "0");
        if (format == 't')
            fprintf(f, "%s  %-23s %-23s %-23s %-23s %5.1f\n", sat, text[0][0] ? text[0] : "before",
                    text[1][0]       ? text[1]
                    : x->umbra       ? "before"
                    : x->umbra_known ? "-"
                                     : "?",
                    text[2][0]       ? text[2]
                    : x->umbra       ? "after"
                    : x->umbra_known ? "-"
                                     : "?",
                    text[3][0] ? text[3] : "after", length / 60);
        if (format != 'j') continue;
        static const char *const key[4] = {"penumbra_entry", "umbra_entry", "umbra_exit", "penumbra_exit"};
        fprintf(f, "%s\n {\"sat\": \"%s\"", i > 0 ? "," : "", sat);
        for (int k = 0; k < 4; k++)
            if (text[k][0] != '\0')
                fprintf(f, ", \"%s\": \"%s\"", key[k], text[k]);
            else
                fprintf(f, ", \"%s\": null", key[k]);
        fprintf(f, ", \"shadow_s\": %.1f, \"umbra\": %s}", length,
                !x->umbra_known ? "null"
                : x->umbra      ? "true"
                                : "false");
    }
    if (format == 'j') fputs("\n]\n", f);
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_products p;
    list l = {0};
    orr_outfile out;
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    orr_status s =
        orr_products_open((const char *const *)c->operand, (size_t)c->n_operands, &p, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    if (s == ORR_OK && collect(c, &p, &l) != ORR_OK)
        s = orr_diag_set(&diag, ORR_E_MEMORY, "out of memory for the eclipses");
    if (s == ORR_OK) s = orr_outfile_open(orr_cli_text(c, "output", "-"), &out, &diag);
    if (s == ORR_OK) {
        print(out.stream, &l, orr_cli_text(c, "format", "table")[0]);
        s = orr_outfile_commit(&out, &diag);
    }
    free(l.item);
    orr_products_free(&p);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_SATS,
    ORR_OPTION_FROM(.help = "Eclipses that end at T or later; all of the product by default."),
    ORR_OPTION_TO(.help = "Eclipses that begin at T or before."),
    ORR_OPTION_FORMAT("table|csv|json", "table"),
    ORR_OPTION_OUTPUT,
};

const orr_command orr_cmd_eclipses = {
    .name = "eclipses",
    .group = "Orbits",
    .summary = "when satellites pass through the Earth's shadow",
    .operands = "PRODUCT...",
    .min_operands = 1,
    .max_operands = -1,
    .about =
        "One row a passage: entries into penumbra and umbra and exits from them, GPS time. The shadow is the "
        "cone of a spherical Earth (6378.1366 km) without atmosphere. An instant before the orbit begins or "
        "after it ends is not known: blank in CSV, null in JSON. A passage without umbra has none of its "
        "instants, and umbra is 0; umbra is not known either where the orbit begins or ends in the penumbra. "
        "shadow_s counts what the orbit holds of it. Of several products a passage over midnight is one row.",
    .example = "orrery eclipses day.nc\norrery eclipses week.nc --sat G05,E --format csv -o eclipses.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
