// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/json_value.h"

#include <math.h>

json_t *orr_json_number(double v) { return isfinite(v) ? json_real(v) : json_null(); }
json_t *orr_json_count(size_t n) { return json_integer((json_int_t)n); }

json_t *orr_json_text(const char *text)
{
    json_t *j = text != NULL ? json_string(text) : json_null();
    if (j != NULL) return j;
    char ascii[1024]; // bytes of anyone's file or name
    size_t n = 0;
    for (; text[n] != '\0' && n + 1 < sizeof ascii; n++)
        ascii[n] = (unsigned char)text[n] < 0x80 ? text[n] : '?';
    ascii[n] = '\0';
    return json_string(ascii);
}

json_t *orr_json_time(orr_time t)
{
    char text[ORR_TIME_TEXT];
    return t == ORR_TIME_NONE ? json_null() : json_string(orr_time_text(t, text));
}

json_t *orr_json_sat(orr_sat sat)
{
    char text[ORR_SAT_TEXT];
    return json_string(orr_sat_text(sat, text));
}
