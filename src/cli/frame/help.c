// SPDX-License-Identifier: GPL-3.0-or-later
// Help, made from the tables that the parser works by.
#include <string.h>

#include "src/cli/frame/frame.h"

enum { WIDTH = 96, HELP_COLUMN = 30 };

// Words of text, wrapped; the cursor stands in `column` and further lines start at `indent`. A blank line in
// the text divides paragraphs. Ends with a newline.
static void wrap(FILE *f, const char *text, int column, int indent)
{
    bool first = true;
    while (*text != '\0') {
        if (text[0] == '\n' && text[1] == '\n') {
            fprintf(f, "\n\n%*s", indent, "");
            column = indent;
            first = true;
        }
        size_t blanks = strspn(text, " \n");
        text += blanks;
        int len = (int)strcspn(text, " \n");
        if (len == 0) break;
        if (!first && column + 1 + len > WIDTH) {
            fprintf(f, "\n%*s", indent, "");
            column = indent;
        } else if (!first) {
            fputc(' ', f);
            column++;
        }
        fprintf(f, "%.*s", len, text);
        column += len;
        text += len;
        first = false;
    }
    fputc('\n', f);
}

static void help_option(FILE *f, const orr_option *o)
{
    char left[96];
    int n = snprintf(left, sizeof left, "  %c%c%c --%s%s%s", o->letter != 0 ? '-' : ' ',
                     o->letter != 0 ? o->letter : ' ', o->letter != 0 ? ',' : ' ', o->name,
                     o->value != NULL ? " " : "", o->value != NULL ? o->value : "");
    fputs(left, f);
    if (n >= HELP_COLUMN - 1) {
        fprintf(f, "\n%*s", HELP_COLUMN, "");
    } else {
        fprintf(f, "%*s", HELP_COLUMN - n, "");
    }
    char help[1024], applies[320] = "";
    if (o->applies != NULL) orr_cli_applies_words(o->applies, applies, sizeof applies);
    snprintf(help, sizeof help, "%s%s%s%s%s%s", o->help, o->required ? " (required)" : "",
             o->repeated ? " (may be repeated)" : "", applies[0] != '\0' ? " (" : "", applies,
             applies[0] != '\0' ? ")" : "");
    wrap(f, help, HELP_COLUMN, HELP_COLUMN);
}

void orr_cli_help_command(FILE *f, const orr_command *cmd)
{
    fprintf(f, "orrery %s: %s\n\nUsage: orrery %s", cmd->name, cmd->summary, cmd->name);
    for (size_t i = 0; i < cmd->n_options; i++) {
        const orr_option *o = &cmd->option[i];
        if (!o->required) continue;
        if (o->letter != 0)
            fprintf(f, " -%c %s", o->letter, o->value);
        else
            fprintf(f, " --%s %s", o->name, o->value);
    }
    fprintf(f, "%s%s [options]\n", cmd->operands != NULL ? " " : "",
            cmd->operands != NULL ? cmd->operands : "");
    if (cmd->about != NULL) {
        fputc('\n', f);
        wrap(f, cmd->about, 0, 0);
    }
    fputs("\nOptions:\n", f);
    for (size_t i = 0; i < cmd->n_options; i++) help_option(f, &cmd->option[i]);
    for (size_t i = 0; i < orr_cli_n_common(cmd); i++) help_option(f, &orr_cli_common_options[i]);
    bool times = false;
    for (size_t i = 0; i < cmd->n_options; i++)
        times |= cmd->option[i].kind == ORR_OPT_TIME || cmd->option[i].kind == ORR_OPT_INTERVAL;
    if (times) {
        fputs("\nTimes: ", f);
        wrap(f, ORR_CLI_TIMES_TEXT, 7, 0);
    }
    if (cmd->example != NULL) {
        fputs("\nExample:\n", f);
        for (const char *p = cmd->example; *p != '\0';) {
            int len = (int)strcspn(p, "\n");
            fprintf(f, "  %.*s\n", len, p);
            p += len;
            if (*p == '\n') p++;
        }
    }
}

void orr_cli_help_program(FILE *f, const orr_command *const *list)
{
    wrap(f, ORR_CLI_ABOUT_TEXT, 0, 0);
    fputs("\nUsage: orrery COMMAND [options]\n", f);
    for (size_t i = 0; list[i] != NULL; i++) {
        if (i == 0 || strcmp(list[i]->group, list[i - 1]->group) != 0) fprintf(f, "\n%s\n", list[i]->group);
        fprintf(f, "  %-12s %s\n", list[i]->name, list[i]->summary);
    }
    fputs("\n'orrery help COMMAND' or 'orrery COMMAND --help' shows the options of a command, with an "
          "example.\n"
          "'orrery --version' prints the version, with --verbose also the commit, the compiler and the "
          "libraries.\n"
          "Data go to standard output, messages to standard error.\n\nExit status: ",
          f);
    wrap(f, ORR_CLI_STATUS_TEXT, 13, 0);
}
