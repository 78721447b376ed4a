// SPDX-License-Identifier: GPL-3.0-or-later
// Completion for bash and zsh, made from the tables that the parser works by. zsh runs bash's functions.
#include <string.h>

#include "src/cli/frame/frame.h"

// An option's words: "--output -o".
static void put_names(FILE *f, const orr_option *o)
{
    fprintf(f, " --%s", o->name);
    if (o->letter != 0) fprintf(f, " -%c", o->letter);
}

// The same as a pattern of a case: "--output|-o".
static void put_pattern(FILE *f, const orr_option *o)
{
    fprintf(f, "--%s", o->name);
    if (o->letter != 0) fprintf(f, "|-%c", o->letter);
}

static void put_choices(FILE *f, const char *value)
{
    for (; *value != '\0'; value++) fputc(*value == '|' ? ' ' : *value, f);
}

static void put_command(FILE *f, const orr_command *cmd)
{
    fprintf(f, "    %s)\n        case $before in\n", cmd->name);
    for (size_t i = 0; i < cmd->n_options; i++) {
        const orr_option *o = &cmd->option[i];
        if (o->kind == ORR_OPT_FLAG) continue;
        fputs("        ", f);
        put_pattern(f, o);
        if (o->kind == ORR_OPT_CHOICE) {
            fputs(") COMPREPLY=($(compgen -W '", f);
            put_choices(f, o->value);
            fputs("' -- \"$word\")); return ;;\n", f);
        } else if (o->kind == ORR_OPT_TEXT) {
            fputs(") COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n", f);
        } else {
            fputs(") return ;;\n", f);
        }
    }
    fputs("        esac\n        options='", f);
    for (size_t i = 0; i < cmd->n_options; i++) put_names(f, &cmd->option[i]);
    for (size_t i = 0; i < orr_cli_n_common(cmd); i++) put_names(f, &orr_cli_common_options[i]);
    fputs("'\n        ;;\n", f);
}

void orr_cli_completion(FILE *f, const orr_command *const *list, bool zsh)
{
    if (zsh) fputs("#compdef orrery\nautoload -U +X bashcompinit && bashcompinit\n", f);
    fputs(
        "# Made from the program's tables; SPDX-License-Identifier: GPL-3.0-or-later\n"
        "_orrery()\n{\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options=''\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ] || { [ \"$COMP_CWORD\" -eq 2 ] && [ \"$before\" = help ]; }; then\n"
        "        COMPREPLY=($(compgen -W '",
        f);
    for (size_t i = 0; list[i] != NULL; i++) fprintf(f, "%s ", list[i]->name);
    fputs("help --help --version' -- \"$word\"))\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n", f);
    for (size_t i = 0; list[i] != NULL; i++) put_command(f, list[i]);
    fputs("    *) return ;;\n    esac\n"
          "    case $word in\n"
          "    -*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")) ;;\n"
          "    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;\n"
          "    esac\n}\n"
          "complete -o filenames -F _orrery orrery\n",
          f);
    // zsh has loaded this file because the first completion was asked for, which is still to be answered.
    if (zsh) fputs("if [[ -n ${compstate-} ]]; then _bash_complete -o filenames -F _orrery; fi\n", f);
}
