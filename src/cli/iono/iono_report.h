// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery iono` tells of a fusion, in words and as JSON.
#ifndef ORR_CLI_IONO_IONO_REPORT_H
#define ORR_CLI_IONO_IONO_REPORT_H

#include <stdio.h>

#include "iono/fusion/session.h"

// The summary: what arcs left out say comes first. explain: with every arc and slip.
void orr_iono_report_text(FILE *f, const orr_phase_tec *p, const orr_fusion *k, bool explain);
// The same as one JSON object.
void orr_iono_report_json(FILE *f, const orr_phase_tec *p, const orr_fusion *k, bool explain);
// Two stations side by side, as one JSON object.
void orr_iono_report_comparison_json(FILE *f, const orr_phase_tec *a, const orr_phase_tec *b,
                                     const orr_curves *k);
// t_gps,sat,arc,az_deg,el_deg,stec_tecu,vtec_tecu,model_stec_tecu,sigma_tecu,delay1_m
void orr_iono_report_session_csv(FILE *f, const orr_session *s);

#endif
