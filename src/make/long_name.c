// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/long_name.h"

#include <stdio.h>

enum { LENGTH = 16 };

static void length_text(int64_t ns, char text[LENGTH])
{
    static const struct {
        int64_t ns;
        char letter;
    } unit[] = {{86400 * ORR_NS_PER_S, 'D'},
                {3600 * ORR_NS_PER_S, 'H'},
                {60 * ORR_NS_PER_S, 'M'},
                {ORR_NS_PER_S, 'S'}};
    for (size_t k = 0; k < sizeof unit / sizeof unit[0]; k++)
        if (ns % unit[k].ns == 0 && ns / unit[k].ns < 100) {
            snprintf(text, LENGTH, "%02d%c", (int)(ns / unit[k].ns), unit[k].letter);
            return;
        }
    if (ns < ORR_NS_PER_S && ORR_NS_PER_S % ns == 0 && ORR_NS_PER_S / ns < 100)
        snprintf(text, LENGTH, "%02dZ", (int)(ORR_NS_PER_S / ns));
    else if (ns < ORR_NS_PER_S && ORR_NS_PER_S % (100 * ns) == 0 && ORR_NS_PER_S / ns < 10000)
        snprintf(text, LENGTH, "%02dC", (int)(ORR_NS_PER_S / ns / 100));
    else
        snprintf(text, LENGTH, "00U");
}

orr_status orr_long_name(const char *folder, const char *campaign, orr_time begin, int64_t length_ns,
                         int64_t step_ns, const char *kind, size_t n, char *out, orr_diag *diag)
{
    char whole[LENGTH], step[LENGTH];
    orr_civil c;
    length_text(length_ns, whole);
    length_text(step_ns, step);
    orr_time_to_civil(begin, ORR_SCALE_GPS, NULL, &c);
    const int wrote = snprintf(out, n, "%s/ORR0%sFIN_%04d%03d%02d%02d_%s_%s_%s", folder, campaign, c.year,
                               orr_day_of_year(c.year, c.month, c.day), c.hour, c.minute, whole, step, kind);
    if (wrote < 0 || (size_t)wrote >= n)
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: the name is too long", folder);
    return ORR_OK;
}
