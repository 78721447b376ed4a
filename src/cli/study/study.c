// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/study/study.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/outfile.h"

int orr_cli_study_open(orr_cli *c, const orr_schema *schema, void *base, orr_inputs *inputs, bool *go)
{
    *go = false;
    if (orr_cli_given(c, "help-study")) {
        orr_schema_describe(schema, stdout);
        return ORR_EXIT_OK;
    }
    if (c->n_operands != 1) return orr_cli_usage(c, "a study's file is wanted");
    if (orr_study_to_stdout(c) && orr_cli_says(c, "format", "json"))
        return orr_cli_usage(c, "only one of --output - and --format json can go to standard output");
    orr_diag diag = {0};
    inputs->leap = c->leap;
    orr_status s = orr_study_open(inputs, c->operand[0], schema, base, &diag);
    if (s == ORR_OK) {
        s = orr_cli_tree_check(c, schema, base, &diag);
        if (s != ORR_OK) orr_schema_free(schema, base);
    }
    if (s != ORR_OK) {
        orr_inputs_free(inputs);
        return orr_cli_fail(c, &diag);
    }
    *go = true;
    return ORR_EXIT_OK;
}

bool orr_study_to_stdout(const orr_cli *c) { return strcmp(orr_cli_text(c, "output", ""), "-") == 0; }

static void put_cell(FILE *f, const orr_study_column *col, double v)
{
    if (col->word != NULL)
        fputs(col->word[(size_t)v], f);
    else if (isfinite(v))
        fprintf(f, "%.15g", v);
}

static orr_status write_csv(const char *path, const orr_study_table *t, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i < t->n_columns; i++)
        fprintf(out.stream, "%s%s", i == 0 ? "" : ",", t->column[i].name);
    fputc('\n', out.stream);
    for (size_t k = 0; k < t->n; k++)
        for (size_t i = 0; i < t->n_columns; i++) {
            if (i > 0) fputc(',', out.stream);
            put_cell(out.stream, &t->column[i], t->value[k * t->n_columns + i]);
            if (i + 1 == t->n_columns) fputc('\n', out.stream);
        }
    return orr_outfile_commit(&out, diag);
}

#define MOST_WORDS 64

// "2-sample 4-sample": CF's flag_meanings, and the numbers that stand for them.
static void put_meanings(orr_nc_writer *w, const char *var, const char *const *word, orr_diag *diag)
{
    char text[1024];
    size_t at = 0;
    int64_t value[MOST_WORDS];
    size_t n = 0;
    for (size_t k = 0; k < MOST_WORDS && word[k] != NULL && at + 2 < sizeof text; k++) {
        value[n++] = (int64_t)k;
        at += (size_t)snprintf(text + at, sizeof text - at, "%s%s", k == 0 ? "" : " ", word[k]);
    }
    (void)orr_nc_put_att_int64(w, var, "flag_values", value, n, diag);
    orr_nc_put_att_text(w, var, "flag_meanings", text, diag);
}

// A unit as UDUNITS reads it: "deg/h" is "degree/h".
static const char *udunit(const char *unit, char buf[32])
{
    if (unit == NULL || strncmp(unit, "deg", 3) != 0 || isalpha((unsigned char)unit[3])) return unit;
    snprintf(buf, 32, "degree%.20s", unit + 3);
    return buf;
}

static orr_status put_table(orr_nc_writer *w, const orr_study_table *t, bool prefixed, orr_diag *diag)
{
    double *v = malloc((t->n + 1) * sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows", t->n);
    const char *const dims[] = {t->name};
    orr_status s = orr_nc_put_dim(w, t->name, t->n, diag);
    for (size_t i = 0; i < t->n_columns && s == ORR_OK; i++) {
        const orr_study_column *col = &t->column[i];
        char name[128], unit[32];
        snprintf(name, sizeof name, "%s%s%s", prefixed ? t->name : "", prefixed ? "_" : "", col->name);
        for (size_t k = 0; k < t->n; k++) v[k] = t->value[k * t->n_columns + i];
        s = orr_nc_put_var(w, name, ORR_NC_DOUBLE, 1, dims, v, udunit(col->unit, unit), col->help, diag);
        if (s == ORR_OK && col->word != NULL) put_meanings(w, name, col->word, diag);
    }
    free(v);
    return s;
}

static orr_status write_netcdf(const orr_cli *c, const char *path, const char *title,
                               const orr_inputs *inputs, const orr_study_table *table, size_t n_tables,
                               orr_diag *diag)
{
    orr_nc_input *from = orr_inputs_provenance(inputs);
    if (from == NULL && inputs->n > 0) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_nc_writer w;
    orr_status s = orr_nc_create(path, &w, diag);
    if (s == ORR_OK) s = orr_nc_put_provenance(&w, title, c->call, from, inputs->n, diag);
    for (size_t k = 0; k < n_tables && s == ORR_OK; k++)
        if (table[k].n > 0) s = put_table(&w, &table[k], k > 0, diag);
    free(from);
    if (s == ORR_OK) return orr_nc_commit(&w, diag);
    orr_nc_abort(&w);
    return s;
}

orr_status orr_study_write(const orr_cli *c, const char *title, const orr_inputs *inputs,
                           const orr_study_table *table, size_t n_tables, orr_diag *diag)
{
    const char *path = orr_cli_text(c, "output", NULL);
    if (path == NULL) return ORR_OK;
    const size_t n = strlen(path);
    if (orr_study_to_stdout(c) || (n > 4 && strcasecmp(path + n - 4, ".csv") == 0))
        return write_csv(path, table, diag);
    return write_netcdf(c, path, title, inputs, table, n_tables, diag);
}

orr_status orr_study_write_series(const orr_cli *c, const orr_study_table *table, orr_diag *diag)
{
    const char *path = orr_cli_text(c, "csv", NULL);
    return path == NULL ? ORR_OK : write_csv(path, table, diag);
}

orr_status orr_study_plot(const orr_cli *c, const orr_plot *plot, orr_diag *diag)
{
    const char *path = orr_cli_text(c, "plot", NULL);
    if (path == NULL) return ORR_OK;
    const char *name = strrchr(path, '/') != NULL ? strrchr(path, '/') + 1 : path;
    const size_t n = strlen(name);
    char png[300];
    if (n < 4 || n > 250 || strcmp(name + n - 3, ".gp") != 0) return orr_plot_write(path, plot, diag);
    snprintf(png, sizeof png, "%.*s.png", (int)n - 3, name);
    return orr_plot_write_gnuplot(path, png, plot, diag);
}
