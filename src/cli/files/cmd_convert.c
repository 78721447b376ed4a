// SPDX-License-Identifier: GPL-3.0-or-later
// orrery convert: Hatanaka-compressed observations to plain RINEX.
#include <stdio.h>
#include <string.h>

#include "core/outfile.h"
#include "ingest/rinex/crinex.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"

typedef struct sink {
    FILE *stream;
    uint64_t lines;
} sink;

static bool put(void *user, const char *line, size_t n)
{
    sink *s = user;
    s->lines++;
    return fwrite(line, 1, n, s->stream) == n && putc('\n', s->stream) != EOF;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_input *in = NULL;
    orr_outfile out;
    orr_status s = orr_input_open(c->operand[0], NULL, &in, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const char *path = orr_cli_text(c, "output", "-");
    s = orr_outfile_open(path, &out, &diag);
    if (s == ORR_OK) {
        sink k = {.stream = out.stream};
        s = orr_crinex_expand(in, put, &k, &warnings, &diag);
        s = orr_outfile_end(&out, s, &diag);
        if (s == ORR_OK && strcmp(path, "-") != 0)
            orr_cli_say(c, "%s: %llu lines of RINEX", path, (unsigned long long)k.lines);
    }
    orr_input_close(in);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_OUTPUT,
};

const orr_command orr_cmd_convert = {
    .name = "convert",
    .group = "Files",
    .summary = "expand Hatanaka-compressed observations to plain RINEX",
    .operands = "FILE",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Reads Compact RINEX 1.0 and 3.0, plain or inside gzip or .Z, and writes the RINEX text that it "
             "stands for. "
             "All other commands read compressed files as they are; this one is for other programs.\n\n"
             "Epochs that are damaged are left out and told of.",
    .example = "orrery convert BOR100POL_R_20240350000_01D_30S_MO.crx.gz -o BOR1.rnx",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
