// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of other instruments share.
#include <math.h>
#include <stdlib.h>

#include "src/service/text/scpi_dialects.h"

int orr_scpi_numbers(char *const *parameter, size_t n, double *v)
{
    for (size_t k = 0; k < n; k++) {
        char *end;
        v[k] = strtod(parameter[k], &end);
        if (end == parameter[k] || *end != '\0' || !isfinite(v[k])) return ORR_SCPI_ILLEGAL;
    }
    return 0;
}

int orr_scpi_motion(orr_scpi *s, const orr_msg_motion *m)
{
    orr_server_refusal why = {""};
    const orr_asked *a = orr_text_asked(s);
    const uint16_t code =
        a->streams != NULL ? orr_streams_motion(a->streams, m, &why) : ORR_MSG_ERROR_CODE_NOT_SERVED;
    snprintf(s->detail, sizeof s->detail, "%s", why.sentence);
    if (code == 0) return 0;
    return code == ORR_MSG_ERROR_CODE_BAD_REQUEST ? ORR_SCPI_RANGE : ORR_SCPI_EXECUTION;
}
