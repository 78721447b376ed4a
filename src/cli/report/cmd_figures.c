// SPDX-License-Identifier: GPL-3.0-or-later
// orrery figures: the dissertation's figures and some of ours, with the commands that make them, as one page.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/outfile.h"
#include "core/parallel.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/report/figure.h"
#include "src/cli/report/judgement.h"

static const orr_option options[] = {
    ORR_OPTION_FOLDER(.help = "Folder of the figures, their tables and report.html; made if there is none."),
    {.name = "samples",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "The samples' folder; 'samples' by default, as in the checkout's root."},
    {.name = "data",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Folder of real files, for the figures that are made of them; without it they are left out, and "
             "said so."},
    {.name = "archive",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Archive of days (orrery batch), for the inclination over years of its own."},
    {.name = "only",
     .kind = ORR_OPT_TEXT,
     .value = "NAME",
     .repeated = true,
     .help = "Make this figure alone, e.g. fig5; all by default."},
};

#define STEP 600

typedef struct outcome {
    bool made, picture; // picture: NAME.png, by gnuplot
    orr_diag why;       // where it is not
} outcome;

static bool wanted(const orr_cli *c, const char *name)
{
    const size_t n = orr_cli_count(c, "only");
    for (size_t i = 0; i < n; i++)
        if (strcmp(orr_cli_text_at(c, "only", i), name) == 0) return true;
    return n == 0;
}

// Whether an earlier figure of this run has taken the same step.
static bool taken(const orr_cli *c, const outcome *done, size_t at, const char *step)
{
    for (size_t i = 0; i < at; i++)
        if (done[i].made && wanted(c, figures[i].name) && strstr(figures[i].steps, step) != NULL) return true;
    return false;
}

// Whether a figure is not asked for: what it is made of was not named.
static bool is_left_out(const figure *f, const figure_places *p)
{
    return (f->needs == FIGURE_NEEDS_DATA && p->data == NULL) ||
           (f->needs == FIGURE_NEEDS_ARCHIVE && p->archive == NULL);
}

static void make(const orr_cli *c, size_t at, const figure_places *p, outcome *done)
{
    const figure *f = &figures[at];
    outcome *o = &done[at];
    orr_status s = ORR_OK;
    pid_t service = 0;
    if (f->needs == FIGURE_NEEDS_DATA && p->data == NULL)
        s = orr_diag_set(&o->why, ORR_E_NODATA, "is made of real files: --data DIR");
    if (f->needs == FIGURE_NEEDS_ARCHIVE && p->archive == NULL)
        s = orr_diag_set(&o->why, ORR_E_NODATA, "is made of an archive: --archive DIR");
    for (const char *step = f->steps; s == ORR_OK && *step != '\0';) {
        char text[STEP];
        const size_t n = strcspn(step, "\n");
        snprintf(text, sizeof text, "%.*s", (int)n, step);
        if (text[0] == '&' || !taken(c, done, at, text)) s = figure_run_step(f, text, p, &service, &o->why);
        step += n + (step[n] == '\n');
    }
    figure_end_service(service);
    if (s == ORR_OK && f->plot.csv != NULL) s = figure_draw(f, p->out, &o->why);
    o->made = s == ORR_OK;
    o->picture = s == ORR_OK && figure_picture(f, p->out);
    orr_cli_say(c, "%s: %s", f->name, o->made ? f->title : o->why.text);
}

// Whether two figures have a step in common.
static bool share(const figure *a, const figure *b)
{
    for (const char *step = a->steps; *step != '\0';) {
        char text[STEP];
        const size_t n = strcspn(step, "\n");
        snprintf(text, sizeof text, "%.*s", (int)n, step);
        if (strstr(b->steps, text) != NULL) return true;
        step += n + (step[n] == '\n');
    }
    return false;
}

// Figures that have steps in common are made one after the other, by one thread; group[i] is the first of them.
typedef struct crew {
    const orr_cli *c;
    const figure_places *p;
    outcome *done;
    size_t *group;
    bool served; // those with a service that is timed come last, alone
} crew;

static void put_in_groups(size_t *group)
{
    for (size_t i = 0; i < n_figures; i++) {
        group[i] = i;
        for (size_t k = 0; k < i; k++) {
            const size_t from = group[i], to = group[k];
            if (from == to || !share(&figures[i], &figures[k])) continue;
            for (size_t m = 0; m <= i; m++)
                if (group[m] == from || group[m] == to) group[m] = from < to ? from : to;
        }
    }
}

static void make_group(void *user, size_t first)
{
    const crew *w = user;
    for (size_t i = first; i < n_figures; i++)
        if (w->group[i] == first && wanted(w->c, figures[i].name) &&
            (figures[i].steps[0] == '&') == w->served)
            make(w->c, i, w->p, w->done);
}

// Makes all that is wanted, groups side by side. ORR_E_MEMORY.
static orr_status make_all(const orr_cli *c, const figure_places *p, outcome *done, orr_diag *diag)
{
    crew w = {.c = c, .p = p, .done = done, .group = calloc(n_figures, sizeof *w.group)};
    if (w.group == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu figures", n_figures);
    put_in_groups(w.group);
    orr_parallel_each(n_figures, orr_parallel_cores(), make_group, &w);
    w.served = true;
    orr_parallel_each(n_figures, 1, make_group, &w);
    free(w.group);
    return ORR_OK;
}

// Text with what HTML takes for its own.
static void put_text(FILE *f, const char *text)
{
    for (; *text != '\0'; text++) {
        const char *s = *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : *text == '&' ? "&amp;" : NULL;
        if (s != NULL)
            fputs(s, f);
        else
            fputc(*text, f);
    }
}

static void put_file(FILE *f, const char *folder, const char *name, const char *suffix)
{
    char path[1200];
    snprintf(path, sizeof path, "%s/%s%s", folder, name, suffix);
    FILE *in = fopen(path, "r");
    for (int byte; in != NULL && (byte = fgetc(in)) != EOF;) fputc(byte, f);
    if (in != NULL) fclose(in);
}

// The file of one of several tables, "name=file:column|..."; its length into *n, and of the whole of it into *whole.
static const char *file_of(const char *csv, int *n, size_t *whole)
{
    *whole = strcspn(csv, "|");
    const size_t name = strcspn(csv, "=|");
    const char *file = name < *whole ? csv + name + 1 : csv;
    *n = (int)strcspn(file, ":|");
    return file;
}

// Links to the files of a figure's tables, each once.
static void put_tables(FILE *f, const char *csv)
{
    enum { MOST = 16 };
    const char *told[MOST];
    int length[MOST], n_told = 0;
    for (size_t whole; csv != NULL && *csv != '\0'; csv += whole + (csv[whole] == '|')) {
        int n, k = 0;
        const char *file = file_of(csv, &n, &whole);
        while (k < n_told && !(length[k] == n && strncmp(told[k], file, (size_t)n) == 0)) k++;
        if (k < n_told || n_told == MOST) continue;
        told[n_told] = file;
        length[n_told++] = n;
    }
    if (n_told > 0) fputs(n_told > 1 ? "The tables:" : "The table:", f);
    for (int k = 0; k < n_told; k++)
        fprintf(f, " <a href=\"%.*s\">%.*s</a>%s", length[k], told[k], length[k], told[k],
                k + 1 < n_told ? "," : ". ");
}

static void put_figure(FILE *f, const figure *g, const outcome *o, const char *folder)
{
    fprintf(f, "<section id=\"%s\">\n<h2>", g->name);
    put_text(f, g->title);
    fputs("</h2>\n<p>", f);
    put_text(f, g->text);
    fputs("</p>\n", f);
    if (o->made) {
        fputs("<figure>", f);
        put_file(f, folder, g->name, ".svg");
        fputs("</figure>\n<p>", f);
        put_tables(f, g->plot.csv);
        fprintf(f, "The figure: <a href=\"%s.svg\">%s.svg</a>", g->name, g->name);
        if (o->picture) fprintf(f, ", <a href=\"%s.png\">%s.png</a>", g->name, g->name);
        fputs(". Made by</p>\n<pre>", f);
        for (const char *step = g->steps; *step != '\0';) {
            char one[STEP], text[2 * STEP];
            const size_t n = strcspn(step, "\n");
            snprintf(one, sizeof one, "%.*s", (int)n, step);
            figure_step_text(one, text, sizeof text);
            put_text(f, text);
            fputc('\n', f);
            step += n + (step[n] == '\n');
        }
        fputs("</pre>\n", f);
    } else {
        fputs("<p class=\"missing\">Not made: ", f);
        put_text(f, o->why.text);
        fputs("</p>\n", f);
    }
    fputs("</section>\n", f);
}

static void put_sentences(FILE *f, const char *title, const char (*text)[320], size_t n, const char *none)
{
    fprintf(f, "<h2>%s</h2>\n<ul>\n", title);
    for (size_t i = 0; i < n; i++) {
        fputs("<li>", f);
        put_text(f, text[i]);
        fputs("</li>\n", f);
    }
    if (n == 0) fprintf(f, "<li>%s</li>\n", none);
    fputs("</ul>\n", f);
}

// What was processed, how good it is, what is suspicious: first of all.
static orr_status put_judgement(const orr_cli *c, FILE *f, const figure_places *p, const outcome *done,
                                orr_diag *diag)
{
    judgement *j = calloc(1, sizeof *j);
    orr_status s = j != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for a judgement");
    size_t made = 0, all = 0;
    for (size_t i = 0; s == ORR_OK && i < n_figures; i++) {
        if (!wanted(c, figures[i].name)) continue;
        all++;
        made += done[i].made;
        const bool left_out = is_left_out(&figures[i], p);
        if (done[i].made)
            judgement_of_figure(&figures[i], p, j);
        else if (!left_out)
            judgement_suspicious(j, "%s could not be made: %s", figures[i].name, done[i].why.text);
    }
    if (s == ORR_OK) {
        judgement_processed(j, "%zu figures of %zu, of the made data of the samples%s.", made, all,
                            p->data != NULL ? " and of real files" : "; no real files were named (--data)");
        if (p->archive != NULL) s = judgement_of_archive(p->archive, j, diag);
    }
    if (s == ORR_OK) {
        fputs("<section id=\"judgement\">\n", f);
        put_sentences(f, "What was processed", (const char(*)[320])j->processed, j->n_processed, "Nothing.");
        put_sentences(f, "How good it is", (const char(*)[320])j->good, j->n_good,
                      "Nothing here is measured against something known.");
        put_sentences(f, "What is suspicious", (const char(*)[320])j->suspicious, j->n_suspicious,
                      "Nothing.");
        fputs("</section>\n<h2>Figures</h2>\n", f);
    }
    free(j);
    return s;
}

static orr_status write_report(const orr_cli *c, const figure_places *p, const outcome *done, orr_diag *diag)
{
    char path[1200];
    orr_outfile out;
    snprintf(path, sizeof path, "%s/report.html", p->out);
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    FILE *f = out.stream;
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><meta name=\"viewport\" "
          "content=\"width=device-width\">"
          "<title>Orrery: "
          "figures</title>\n<style>body{font-family:sans-serif;line-height:1.45;max-width:60em;margin:2em "
          "auto;padding:0 1em;"
          "color:#111;background:#fff}figure{margin:0;overflow-x:auto}figure "
          "svg{max-width:100%;height:auto}pre{background:#f2f2f2;padding:.6em;"
          "overflow-x:auto}.missing{color:#8a4a00}h2{margin-top:2.2em}\n@media "
          "(prefers-color-scheme:dark){body{color:#ddd;background:#16181b}"
          "pre{background:#24272b}a{color:#8ab4f8}.missing{color:#f0b060}}\n@media "
          "print{section{break-inside:avoid}}</style></head>\n<body>\n"
          "<h1>Orrery: figures</h1>\n<p>Made by orrery " ORR_VERSION
          ". Each figure stands with the commands that make it, typed in the checkout's root (<code>D</code> "
          "is the folder of real files), and its "
          "table beside this page.</p>\n",
          f);
    s = put_judgement(c, f, p, done, diag);
    fputs("<ul>\n", f);
    for (size_t i = 0; i < n_figures; i++) {
        if (!wanted(c, figures[i].name)) continue;
        fprintf(f, "<li><a href=\"#%s\">", figures[i].name);
        put_text(f, figures[i].title);
        fprintf(f, "</a>%s</li>\n", done[i].made ? "" : " (not made)");
    }
    fputs("</ul>\n", f);
    for (size_t i = 0; i < n_figures; i++)
        if (wanted(c, figures[i].name)) put_figure(f, &figures[i], &done[i], p->out);
    fputs("</body>\n</html>\n", f);
    return orr_outfile_end(&out, s, diag);
}

// The absolute path of a folder that is there; NULL, with its sentence, where it is not.
static char *folder_of(const orr_cli *c, const char *path, const char *what)
{
    struct stat st;
    char *whole = realpath(path, NULL);
    if (whole == NULL || stat(whole, &st) != 0 || !S_ISDIR(st.st_mode)) {
        orr_cli_failf(c, "%s: %s", path, what);
        free(whole);
        return NULL;
    }
    return whole;
}

static int run(orr_cli *c)
{
    for (size_t i = 0; i < orr_cli_count(c, "only"); i++) {
        size_t k = 0;
        while (k < n_figures && strcmp(figures[k].name, orr_cli_text_at(c, "only", i)) != 0) k++;
        if (k == n_figures) return orr_cli_usage(c, "there is no figure '%s'", orr_cli_text_at(c, "only", i));
    }
    const char *out = orr_cli_text(c, "output", NULL), *data = orr_cli_text(c, "data", NULL),
               *archive = orr_cli_text(c, "archive", NULL);
    if (mkdir(out, 0777) != 0 && errno != EEXIST)
        return orr_cli_failf(c, "%s: cannot be made: %s", out, strerror(errno));
    char *folder[4] = {folder_of(c, out, "is no folder"), NULL, NULL, NULL};
    if (folder[0] != NULL)
        folder[1] = folder_of(c, orr_cli_text(c, "samples", "samples"),
                              "is no folder: --samples DIR says where the samples are");
    bool good = folder[0] != NULL && folder[1] != NULL;
    if (good && data != NULL) good = (folder[2] = folder_of(c, data, "is no folder of files")) != NULL;
    if (good && archive != NULL) good = (folder[3] = folder_of(c, archive, "is no archive")) != NULL;
    outcome *done = calloc(n_figures, sizeof *done);
    int status = ORR_EXIT_FAILED;
    if (good && done != NULL) {
        const figure_places p = {folder[0], folder[1], folder[2], folder[3]};
        orr_diag diag = {0};
        size_t failed = 0;
        orr_status s = make_all(c, &p, done, &diag);
        for (size_t i = 0; i < n_figures; i++)
            failed += wanted(c, figures[i].name) && !done[i].made && !is_left_out(&figures[i], &p);
        if (s == ORR_OK) s = write_report(c, &p, done, &diag);
        if (s != ORR_OK)
            status = orr_cli_fail(c, &diag);
        else
            status = failed > 0 ? orr_cli_failf(c, "%zu figures could not be made; %s/report.html says why",
                                                failed, out)
                                : ORR_EXIT_OK;
        if (status == ORR_EXIT_OK) orr_cli_say(c, "%s/report.html", out);
    }
    free(done);
    for (int k = 0; k < 4; k++) free(folder[k]);
    return status;
}

const orr_command orr_cmd_figures = {
    .name = "figures",
    .group = "Archive",
    .summary = "the dissertation's figures and more as SVG, tables and one page",
    .about = "Runs the commands of each figure (docs/figures.md) in the output folder, draws their tables as "
             "SVG, and writes report.html, which "
             "holds all of it and needs nothing beside it. What a command printed stands in NAME.txt. "
             "Figures that need real files or an "
             "archive are left out without --data and --archive.",
    .example = "orrery figures -o figures\n"
               "orrery figures -o figures --data ../shared/data --only fig10",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
