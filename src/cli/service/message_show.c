// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/message_show.h"

#include "src/service/text/message_text.h"

bool orr_message_show(const orr_message_info *info, const void *m, orr_show_format format, const char *frame,
                      bool *headed)
{
    if (format == ORR_AS_JSON) return orr_message_json(info->record, m, stdout);
    if (format != ORR_AS_CSV) return orr_message_table(info->record, m, frame);
    orr_message_csv(info->record, m, headed, stdout);
    return true;
}
