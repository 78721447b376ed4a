// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of both kinds of bias files do with a line: keep its bias, or say why not.
#include "ingest/input/text_records.h"
#include "ingest/tables/bias_private.h"

orr_status bias_add(bias_reader *r, const orr_bias *b)
{
    orr_bias_set *x = r->out;
    orr_status s =
        orr_records_grow(&x->bias, x->n, sizeof *x->bias, r->limits.max_records, "biases", &r->c, r->diag);
    if (s == ORR_OK) x->bias[x->n++] = *b;
    return s;
}

orr_status bias_leave_out(bias_reader *r, int column, const char *why)
{
    if (r->left_out++ == 0) orr_cursor_error(&r->c, &r->first_reason, ORR_E_FORMAT, column, "%s", why);
    orr_cursor_warn(&r->c, r->warnings, column, "%s; the line is left out", why);
    return ORR_OK;
}
