// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages, made from the tables that the parser works by: orrery.1 and one a command.
#include <ctype.h>
#include <string.h>

#include "src/cli/frame/frame.h"

// Text with what roff would take for its own protected: backslashes, hyphens of options, a dot or quote that begins a line.
static void put_text(FILE *f, const char *text, int len)
{
    for (int i = 0; i < len; i++) {
        const char c = text[i];
        if (i == 0 && (c == '.' || c == '\'')) fputs("\\&", f);
        if (c == '\\')
            fputs("\\e", f);
        else if (c == '-')
            fputs("\\-", f);
        else if (c == '\'')
            fputs("\\(aq", f);
        else if (c == '`')
            fputs("\\(ga", f);
        else if (c == '^')
            fputs("\\(ha", f);
        else if (c == '~')
            fputs("\\(ti", f);
        else
            fputc(c == '\n' ? ' ' : c, f);
    }
}

static void put_line(FILE *f, const char *text)
{
    put_text(f, text, (int)strlen(text));
    fputc('\n', f);
}

static void put_paragraphs(FILE *f, const char *text)
{
    const char *end;
    for (; (end = strstr(text, "\n\n")) != NULL; text = end + 2) {
        put_text(f, text, (int)(end - text));
        fputs("\n.PP\n", f);
    }
    put_line(f, text);
}

static void put_upper(FILE *f, const char *text)
{
    for (; *text != '\0'; text++) fputc(toupper((unsigned char)*text), f);
}

static void put_head(FILE *f, const char *command, const char *summary)
{
    fputs(".\\\" Made from the program's tables; SPDX-License-Identifier: GPL-3.0-or-later\n.TH ORRERY", f);
    if (command != NULL) {
        fputc('-', f);
        put_upper(f, command);
    }
    fputs(" 1 \"\" \"Orrery " ORR_VERSION "\" \"Orrery\"\n.SH NAME\norrery", f);
    if (command != NULL) fprintf(f, "\\-%s", command);
    fputs(" \\- ", f);
    put_line(f, summary);
}

static void put_option(FILE *f, const orr_option *o)
{
    fputs(".TP\n", f);
    if (o->letter != 0) fprintf(f, "\\fB\\-%c\\fR, ", o->letter);
    fputs("\\fB\\-\\-", f);
    put_text(f, o->name, (int)strlen(o->name));
    fputs("\\fR", f);
    if (o->value != NULL) {
        fputs(" \\fI", f);
        put_text(f, o->value, (int)strlen(o->value));
        fputs("\\fR", f);
    }
    fputc('\n', f);
    put_text(f, o->help, (int)strlen(o->help));
    fprintf(f, "%s%s", o->required ? " (required)" : "", o->repeated ? " (may be repeated)" : "");
    if (o->applies != NULL) {
        char words[320];
        orr_cli_applies_words(o->applies, words, sizeof words);
        fputs(" (", f);
        put_text(f, words, (int)strlen(words));
        fputc(')', f);
    }
    fputc('\n', f);
}

static void put_example(FILE *f, const char *example)
{
    fputs(".SH EXAMPLES\n.nf\n", f);
    while (*example != '\0') {
        const int len = (int)strcspn(example, "\n");
        put_text(f, example, len);
        fputc('\n', f);
        example += len + (example[len] == '\n');
    }
    fputs(".fi\n", f);
}

static void put_status(FILE *f)
{
    fputs(".SH EXIT STATUS\n", f);
    put_line(f, ORR_CLI_STATUS_TEXT);
}

void orr_cli_man_command(FILE *f, const orr_command *cmd)
{
    put_head(f, cmd->name, cmd->summary);
    fprintf(f, ".SH SYNOPSIS\n\\fBorrery %s\\fR", cmd->name);
    for (size_t i = 0; i < cmd->n_options; i++)
        if (cmd->option[i].required) {
            fputs(" \\fB\\-\\-", f);
            put_text(f, cmd->option[i].name, (int)strlen(cmd->option[i].name));
            fprintf(f, "\\fR \\fI%s\\fR", cmd->option[i].value);
        }
    if (cmd->operands != NULL) {
        fputs(" \\fI", f);
        put_text(f, cmd->operands, (int)strlen(cmd->operands));
        fputs("\\fR", f);
    }
    fputs(" [\\fIoptions\\fR]\n", f);
    if (cmd->about != NULL) {
        fputs(".SH DESCRIPTION\n", f);
        put_paragraphs(f, cmd->about);
    }
    fputs(".SH OPTIONS\n", f);
    bool times = false;
    for (size_t i = 0; i < cmd->n_options; i++) {
        put_option(f, &cmd->option[i]);
        times |= cmd->option[i].kind == ORR_OPT_TIME || cmd->option[i].kind == ORR_OPT_INTERVAL;
    }
    for (size_t i = 0; i < orr_cli_n_common(cmd); i++) put_option(f, &orr_cli_common_options[i]);
    if (times) {
        fputs(".SH TIMES\n", f);
        put_line(f, ORR_CLI_TIMES_TEXT);
    }
    put_status(f);
    if (cmd->example != NULL) put_example(f, cmd->example);
    fputs(".SH SEE ALSO\n.BR orrery (1)\n", f);
}

void orr_cli_man_program(FILE *f, const orr_command *const *list)
{
    put_head(f, NULL, "the back end of a GNSS signal generator");
    fputs(".SH SYNOPSIS\n\\fBorrery\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n.SH DESCRIPTION\n", f);
    put_line(f, ORR_CLI_ABOUT_TEXT);
    fputs(".PP\nData go to standard output, messages to standard error.\n.SH COMMANDS\n", f);
    for (size_t i = 0; list[i] != NULL; i++) {
        if (i == 0 || strcmp(list[i]->group, list[i - 1]->group) != 0) {
            fputs(".SS ", f);
            put_line(f, list[i]->group);
        }
        fprintf(f, ".TP\n\\fBorrery\\-%s\\fR(1)\n", list[i]->name);
        put_line(f, list[i]->summary);
    }
    put_status(f);
    fputs(".SH SEE ALSO\n", f);
    for (size_t i = 0; list[i] != NULL; i++)
        fprintf(f, ".BR orrery\\-%s (1)%s\n", list[i]->name, list[i + 1] != NULL ? "," : "");
}
