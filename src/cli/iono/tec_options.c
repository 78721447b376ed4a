// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/iono/tec_options.h"

#include <string.h>

int orr_tec_options_ask(const orr_cli *c, orr_tec_options *out)
{
    *out = orr_tec_default_options();
    out->leap = c->leap;
    if (orr_cli_given(c, "bilinear")) out->spatial = ORR_TEC_BILINEAR;
    out->degree = (int)orr_cli_int(c, "degree", out->degree);
    const char *between = orr_cli_text(c, "between", "rotated");
    if (orr_cli_given(c, "between") || orr_cli_given(c, "rotation"))
        out->temporal = strcmp(between, "nearest") == 0  ? ORR_TEC_NEAREST
                        : strcmp(between, "linear") == 0 ? ORR_TEC_LINEAR
                                                         : ORR_TEC_ROTATED;
    out->rotation = orr_cli_real(c, "rotation", 1);
    static const char *const model[] = {
        [ORR_TEC_AUTO] = "auto",      [ORR_TEC_GPS] = "gps",       [ORR_TEC_QZSS] = "qzss",
        [ORR_TEC_NAVIC] = "navic",    [ORR_TEC_BEIDOU] = "beidou", [ORR_TEC_BDGIM] = "bdgim",
        [ORR_TEC_NEQUICK] = "nequick"};
    const char *asked = orr_cli_text(c, "model", "auto");
    for (size_t i = 0; i < sizeof model / sizeof *model; i++)
        if (strcmp(asked, model[i]) == 0) out->algorithm = (orr_tec_algorithm)i;
    out->nequick = orr_cli_text(c, "nequick", NULL);
    orr_diag diag = {0};
    if (orr_mapping_parse(orr_cli_text(c, "mapping", "mslm"), &out->mapping, &diag) != ORR_OK)
        return orr_cli_fail(c, &diag);
    return ORR_EXIT_OK;
}

void orr_tec_fit_say(const orr_cli *c, const orr_tec_field *f)
{
    const orr_tec_fit *fit = orr_tec_field_fit(f);
    if (fit == NULL) return;
    orr_cli_say(
        c, "%s: degree %d meets %zu cells to %.4f TECU RMS, %.3f TECU at most (%zu cells of 0 left out)%s",
        orr_tec_field_source(f), fit->degree, fit->n_cells, fit->rms_tecu, fit->max_tecu, fit->n_clipped,
        fit->rms_tecu > 0.1
            ? "; these maps are no expansion of that degree: --bilinear takes them as they are"
            : "");
}
