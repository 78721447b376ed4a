// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/elements_rows.h"

#include <string.h>

orr_elements_frame orr_elements_frame_of(const char *word)
{
    return strcmp(word, "j2000") == 0  ? ORR_ELEMENTS_J2000
           : strcmp(word, "ecef") == 0 ? ORR_ELEMENTS_ECEF
                                       : ORR_ELEMENTS_DATE;
}

orr_elements_method orr_elements_method_of(const char *word)
{
    return strcmp(word, "mean") == 0              ? ORR_ELEMENTS_MEAN
           : strcmp(word, "three-positions") == 0 ? ORR_ELEMENTS_THREE_POSITIONS
                                                  : ORR_ELEMENTS_STATE;
}

double orr_elements_degrees(double angle_rad)
{
    const double degrees = angle_rad * ORR_DEG_PER_RAD;
    return degrees < 360 - 0.5e-10 ? degrees : 0;
}

void orr_elements_csv_head(FILE *f) { fputs("t_gps,sat,a_m,e,i_deg,raan_deg,argp_deg,m_deg,u_deg", f); }

void orr_elements_csv_row(FILE *f, orr_time t, const char *sat, const orr_kepler *k)
{
    char time[ORR_TIME_TEXT];
    fprintf(f, "%s,%s,", orr_time_text(t, time), sat);
    fprintf(f, "%.4f,%.12f,%.10f,%.10f,%.10f,%.10f,%.10f", k->a_m, k->e, k->i_rad * ORR_DEG_PER_RAD,
            orr_elements_degrees(k->raan_rad), orr_elements_degrees(k->argp_rad),
            orr_elements_degrees(k->m_rad), orr_elements_degrees(k->u_rad));
}
