// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/iono/iono_report.h"

#include <math.h>
#include <string.h>

// A number, or null where there is none; and a text with its quotes.
static void put(FILE *f, double v, int decimals)
{
    if (isnan(v))
        fputs("null", f);
    else
        fprintf(f, "%.*f", decimals, v);
}

static void put_text(FILE *f, const char *text)
{
    fputc('"', f);
    for (const unsigned char *p = (const unsigned char *)text; *p != '\0'; p++) {
        if (*p == '"' || *p == '\\')
            fprintf(f, "\\%c", *p);
        else if (*p < 0x20 || *p > 0x7e) // headers may hold any byte
            fprintf(f, "\\u%04x", *p);
        else
            fputc(*p, f);
    }
    fputc('"', f);
}

typedef struct slips {
    size_t found, repaired, broken, none, outliers, dropped;
} slips;

static slips count_slips(const orr_phase_tec *p)
{
    slips n = {0};
    for (size_t s = 0; s < p->n_sats; s++) {
        n.dropped += p->sat[s].arcs.n_dropped;
        for (size_t k = 0; k < p->sat[s].arcs.n_slips; k++) {
            n.found++;
            n.repaired += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_REPAIRED;
            n.broken += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_BREAK;
            n.none += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_NONE;
            n.outliers += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_OUTLIER;
        }
    }
    return n;
}

static void text_arcs(FILE *f, const orr_phase_tec *p, const orr_fusion *k)
{
    char id[ORR_SAT_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT], causes[40];
    fputs("\narcs\nsat  signals    from                to                  samples  max el  bias TECU   "
          "sigma  residual  code bias\n",
          f);
    for (size_t a = 0; a < k->n_arcs; a++) {
        const orr_fused_arc *x = &k->arc[a];
        const orr_phase_sat *s = &p->sat[x->sat_index];
        fprintf(f, "%-4s %s-%s    %s %s %7zu %7.1f %10.3f %7.3f %9.3f ", orr_sat_text(x->sat, id),
                s->phase[0], s->phase[1], orr_time_format(x->from, ORR_SCALE_GPS, 0, NULL, from),
                orr_time_format(x->to, ORR_SCALE_GPS, 0, NULL, to), x->n, x->max_el_rad * ORR_DEG_PER_RAD,
                x->bias_tecu, x->sigma_tecu, x->residual_tecu);
        if (isnan(x->code_bias_tecu))
            fputs("         -\n", f);
        else
            fprintf(f, "%10.3f%s\n", x->code_bias_tecu, x->code_used ? " used" : "");
    }
    fputs(
        "\nslips (steps of the geometry-free phase in TECU, of the wide lane in cycles)\n"
        "sat  before              raised by     gap s   phase step           wide-lane step       verdict\n",
        f);
    for (size_t s = 0; s < p->n_sats; s++)
        for (size_t i = 0; i < p->sat[s].arcs.n_slips; i++) {
            const orr_slip *x = &p->sat[s].arcs.slip[i];
            fprintf(f, "%-4s %s %-12s %6.0f ", orr_sat_text(p->sat[s].sat, id),
                    orr_time_format(p->sat[s].t[x->at], ORR_SCALE_GPS, 0, NULL, from),
                    orr_slip_cause_text(x->causes, causes), x->gap_s);
            if (isnan(x->gf_tecu))
                fputs("                   - ", f);
            else
                fprintf(f, "%10.3f +- %6.3f ", x->gf_tecu, x->gf_sigma_tecu);
            if (isnan(x->mw_cyc))
                fputs("                   - ", f);
            else
                fprintf(f, "%10.2f +- %6.2f ", x->mw_cyc, x->mw_sigma_cyc);
            fputs(orr_slip_verdict_name(x->verdict), f);
            if (x->verdict == ORR_SLIP_REPAIRED) fprintf(f, ": %d and %d cycles", x->n1, x->n2);
            fputc('\n', f);
        }
}

// Accuracy by arcs that the correction was not fitted to, and the statistics that were chosen for it.
static void text_judgement(FILE *f, const orr_fusion *k)
{
    const orr_leave_out *left = &k->left;
    const orr_fusion_model *m = &k->model;
    if (left->n_samples == 0)
        fputs("accuracy: no arc is long enough to be left out\n", f);
    else {
        fprintf(f,
                "accuracy by %zu arcs left out in turn: corrected field %.3f TECU, field as it is %.3f TECU "
                "(slant, "
                "about the arc's mean)\n",
                left->n_arcs, left->corrected_tecu, left->plain_tecu);
        fprintf(f, "  dSTEC (about the arc's highest point): corrected %.3f, as it is %.3f TECU\n",
                left->corrected_dstec_tecu, left->plain_dstec_tecu);
    }
    for (size_t b = 0; b < ORR_FUSION_BANDS; b++) {
        if (left->band[b].n == 0) continue;
        fprintf(f,
                "  %2.0f-%2.0f deg %7zu samples  corrected %.3f, as it is %.3f, what was fitted %.3f TECU\n",
                left->band[b].from_deg, left->band[b].to_deg, left->band[b].n, left->band[b].corrected_tecu,
                left->band[b].plain_tecu, k->band[b].rms_tecu);
    }
    if (k->fallback == ORR_FUSION_NO_GAIN)
        fputs("correction: none, because it does not help arcs that were left out\n", f);
    else
        fprintf(f,
                "correction: level %.2f TECU over %.0f h (known to %.2f; the field's own RMS is %.2f%s); "
                "structure that "
                "it leaves %.2f TECU over %.0f min; effective height of the shell free by %.0f km, "
                "plasmasphere by %.1f TECU\n",
                m->level_tecu, m->level_s / 3600, k->level_sigma_tecu, k->field_rms_tecu,
                k->field_rms_assumed ? ", assumed" : "", m->residual_tecu, m->residual_s / 60, m->height_km,
                m->plasmasphere_tecu);
}

static void text_receiver(FILE *f, const orr_code_group *g)
{
    if (isnan(g->receiver_tecu)) return;
    fprintf(f, "receiver's bias %c %s-%s: %.2f +- %.2f TECU", g->system, g->range[0], g->range[1],
            g->receiver_tecu, g->sigma_tecu);
    if (!isnan(g->published_tecu))
        fprintf(f, " (published: %.2f +- %.2f)", g->published_tecu, g->published_sigma_tecu);
    fputc('\n', f);
}

void orr_iono_report_text(FILE *f, const orr_phase_tec *p, const orr_fusion *k, bool explain)
{
    slips n = count_slips(p);
    fprintf(f, "%s, %s method: %zu satellites, %zu arcs, %zu samples every %g s\n", p->marker,
            orr_fusion_method_name(k->method), p->n_sats, k->n_arcs, k->n_samples, p->interval_s);
    fprintf(f,
            "slips and gaps: %zu (%zu repaired, %zu without a jump, %zu broken), %zu outliers, %zu samples "
            "in arcs too short\n",
            n.repaired + n.none + n.broken, n.repaired, n.none, n.broken, n.outliers, n.dropped);
    if (p->n_clock_steps > 0)
        fprintf(f, "steps of the receiver's clock by whole milliseconds, taken out of its ranges: %zu\n",
                p->n_clock_steps);
    if (k->method == ORR_FUSION_JOINT) text_judgement(f, k);
    fprintf(f, "levelled phase minus %s (what was fitted): RMS %.3f TECU\n",
            k->method == ORR_FUSION_JOINT ? "corrected field" : "field", k->residual_tecu);
    if (k->method == ORR_FUSION_JOINT)
        fprintf(f, "levelled phase minus the field as it is: RMS %.3f TECU\n", k->model_residual_tecu);
    for (size_t g = 0; g < k->n_groups; g++) text_receiver(f, &k->group[g]);
    if (!isnan(k->galileo_std_tecu))
        fprintf(f, "biases against Galileo's codes (%s), arcs over 2 h: std %.3f TECU over %zu arcs\n",
                k->galileo_withheld ? "not used in the fit" : "used in the fit", k->galileo_std_tecu,
                k->galileo_n);
    if (explain) text_arcs(f, p, k);
}

static void json_arcs(FILE *f, const orr_phase_tec *p, const orr_fusion *k)
{
    char id[ORR_SAT_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT], causes[40];
    fputs(",\n \"arc_list\": [", f);
    for (size_t a = 0; a < k->n_arcs; a++) {
        const orr_fused_arc *x = &k->arc[a];
        const orr_phase_sat *s = &p->sat[x->sat_index];
        fprintf(f,
                "%s\n  {\"sat\": \"%s\", \"signals\": [\"%s\", \"%s\"], \"from\": \"%s\", \"to\": \"%s\", "
                "\"samples\": %zu, "
                "\"max_el_deg\": %.2f, \"bias_tecu\": ",
                a > 0 ? "," : "", orr_sat_text(x->sat, id), s->phase[0], s->phase[1],
                orr_time_text(x->from, from), orr_time_text(x->to, to), x->n,
                x->max_el_rad * ORR_DEG_PER_RAD);
        put(f, x->bias_tecu, 4);
        fputs(", \"sigma_tecu\": ", f);
        put(f, x->sigma_tecu, 4);
        fputs(", \"residual_tecu\": ", f);
        put(f, x->residual_tecu, 4);
        fputs(", \"code_bias_tecu\": ", f);
        put(f, x->code_bias_tecu, 4);
        fprintf(f, ", \"code_used\": %s}", x->code_used ? "true" : "false");
    }
    fputs("\n ],\n \"slip_list\": [", f);
    bool first = true;
    for (size_t s = 0; s < p->n_sats; s++)
        for (size_t i = 0; i < p->sat[s].arcs.n_slips; i++) {
            const orr_slip *x = &p->sat[s].arcs.slip[i];
            fprintf(f,
                    "%s\n  {\"sat\": \"%s\", \"t_gps\": \"%s\", \"causes\": \"%s\", \"verdict\": \"%s\", "
                    "\"gap_s\": %.3f, "
                    "\"phase_step_tecu\": ",
                    first ? "" : ",", orr_sat_text(p->sat[s].sat, id),
                    orr_time_text(p->sat[s].t[x->at], from), orr_slip_cause_text(x->causes, causes),
                    orr_slip_verdict_name(x->verdict), x->gap_s);
            put(f, x->gf_tecu, 4);
            fputs(", \"phase_step_sigma_tecu\": ", f);
            put(f, x->gf_sigma_tecu, 4);
            fputs(", \"wide_lane_step_cyc\": ", f);
            put(f, x->mw_cyc, 3);
            fputs(", \"wide_lane_step_sigma_cyc\": ", f);
            put(f, x->mw_sigma_cyc, 3);
            fprintf(f, ", \"n1\": %d, \"n2\": %d}", x->n1, x->n2);
            first = false;
        }
    fputs("\n ]", f);
}

static void json_judgement(FILE *f, const orr_fusion *k)
{
    static const char *const fallback[] = {"none", "too few arcs", "no gain"};
    const orr_leave_out *left = &k->left;
    const orr_fusion_model *m = &k->model;
    fprintf(f, ",\n \"leave_one_out\": {\"arcs\": %zu, \"corrected_rms_tecu\": ", left->n_arcs);
    put(f, left->corrected_tecu, 4);
    fputs(", \"plain_rms_tecu\": ", f);
    put(f, left->plain_tecu, 4);
    fputs(", \"corrected_dstec_tecu\": ", f);
    put(f, left->corrected_dstec_tecu, 4);
    fputs(", \"plain_dstec_tecu\": ", f);
    put(f, left->plain_dstec_tecu, 4);
    fputs(", \"by_elevation\": [", f);
    bool first = true;
    for (int b = 0; b < ORR_FUSION_BANDS; b++) {
        if (left->band[b].n == 0) continue;
        fprintf(f,
                "%s\n   {\"from_deg\": %.0f, \"to_deg\": %.0f, \"n\": %zu, \"corrected_rms_tecu\": %.4f, "
                "\"plain_rms_tecu\": %.4f}",
                first ? "" : ",", left->band[b].from_deg, left->band[b].to_deg, left->band[b].n,
                left->band[b].corrected_tecu, left->band[b].plain_tecu);
        first = false;
    }
    fprintf(f,
            "]},\n \"correction\": {\"fallback\": \"%s\", \"level_tecu\": %.4f, \"level_s\": %.0f, "
            "\"per_degree\": %.4f, \"time_per_degree\": %.4f, \"residual_tecu\": %.4f, \"residual_s\": %.0f, "
            "\"height_km\": %.1f, \"plasmasphere_tecu\": %.2f, "
            "\"level_sigma_tecu\": %.4f, \"field_rms_tecu\": %.4f, \"field_rms_assumed\": %s}",
            fallback[k->fallback], m->level_tecu, m->level_s, m->per_degree, m->time_per_degree,
            m->residual_tecu, m->residual_s, m->height_km, m->plasmasphere_tecu, k->level_sigma_tecu,
            k->field_rms_tecu, k->field_rms_assumed ? "true" : "false");
}

void orr_iono_report_json(FILE *f, const orr_phase_tec *p, const orr_fusion *k, bool explain)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    slips n = count_slips(p);
    fputs("{\"station\": ", f);
    put_text(f, p->marker);
    fprintf(f, ", \"method\": \"%s\", \"from\": \"%s\", \"to\": \"%s\", \"interval_s\": %g,\n",
            orr_fusion_method_name(k->method), orr_time_text(p->from, from), orr_time_text(p->to, to),
            p->interval_s);
    fprintf(f, " \"satellites\": %zu, \"arcs\": %zu, \"samples\": %zu,\n", p->n_sats, k->n_arcs,
            k->n_samples);
    fprintf(f,
            " \"slips\": {\"repaired\": %zu, \"none\": %zu, \"broken\": %zu, \"outliers\": %zu, "
            "\"dropped_samples\": %zu, \"clock_steps\": %zu},\n",
            n.repaired, n.none, n.broken, n.outliers, n.dropped, p->n_clock_steps);
    fputs(" \"residual\": {\"rms_tecu\": ", f);
    put(f, k->residual_tecu, 4);
    fputs(", \"model_rms_tecu\": ", f);
    put(f, k->model_residual_tecu, 4);
    fputs(",\n  \"by_elevation\": [", f);
    bool first = true;
    for (size_t b = 0; b < k->n_band; b++) {
        if (k->band[b].n == 0) continue;
        fprintf(f, "%s\n   {\"from_deg\": %.0f, \"to_deg\": %.0f, \"n\": %zu, \"rms_tecu\": %.4f}",
                first ? "" : ",", k->band[b].from_deg, k->band[b].to_deg, k->band[b].n, k->band[b].rms_tecu);
        first = false;
    }
    fputs("]},\n \"receiver_biases\": [", f);
    first = true;
    for (size_t g = 0; g < k->n_groups; g++) {
        if (isnan(k->group[g].receiver_tecu)) continue;
        fprintf(
            f,
            "%s{\"system\": \"%c\", \"codes\": [\"%s\", \"%s\"], \"bias_tecu\": %.3f, \"sigma_tecu\": %.3f, "
            "\"published_tecu\": ",
            first ? "" : ", ", k->group[g].system, k->group[g].range[0], k->group[g].range[1],
            k->group[g].receiver_tecu, k->group[g].sigma_tecu);
        put(f, k->group[g].published_tecu, 3);
        fputs("}", f);
        first = false;
    }
    fprintf(f, "],\n \"galileo_code\": {\"withheld\": %s, \"arcs\": %zu, \"std_tecu\": ",
            k->galileo_withheld ? "true" : "false", k->galileo_n);
    put(f, k->galileo_std_tecu, 4);
    fputs("}", f);
    if (k->method == ORR_FUSION_JOINT) json_judgement(f, k);
    if (explain) json_arcs(f, p, k);
    fputs("}\n", f);
}

void orr_iono_report_comparison_json(FILE *f, const orr_phase_tec *a, const orr_phase_tec *b,
                                     const orr_curves *k)
{
    char id[ORR_SAT_TEXT];
    fputs("{\"a\": ", f);
    put_text(f, a->marker);
    fputs(", \"b\": ", f);
    put_text(f, b->marker);
    fprintf(f, ", \"baseline_m\": %.3f, \"epochs\": %zu, \"rms_tecu\": %.5f,\n \"curves\": [", k->baseline_m,
            k->n_points, k->rms_tecu);
    for (size_t i = 0; i < k->n_curves; i++)
        fprintf(f, "%s\n  {\"sat\": \"%s\", \"epochs\": %zu, \"rms_tecu\": %.5f}", i > 0 ? "," : "",
                orr_sat_text(k->curve[i].sat, id), k->curve[i].n, k->curve[i].rms_tecu);
    fputs("\n ]}\n", f);
}

void orr_iono_report_session_csv(FILE *f, const orr_session *s)
{
    char id[ORR_SAT_TEXT], time[ORR_TIME_TEXT];
    fputs("t_gps,sat,arc,az_deg,el_deg,stec_tecu,vtec_tecu,model_stec_tecu,sigma_tecu,delay1_m\n", f);
    for (size_t a = 0; a < s->n_arcs; a++)
        for (size_t i = s->arc[a].first; i < s->arc[a].first + s->arc[a].n; i++) {
            const orr_session_sample *x = &s->sample[i];
            fprintf(f, "%s,%s,%zu,%.4f,%.4f,%.6f,%.6f,%.6f,%.4f,%.6f\n", orr_time_text(x->t, time),
                    orr_sat_text(s->arc[a].sat, id), a + 1, x->az_rad * ORR_DEG_PER_RAD,
                    x->el_rad * ORR_DEG_PER_RAD, x->stec_tecu, x->stec_tecu / x->mapping, x->model_stec_tecu,
                    s->arc[a].sigma_tecu,
                    orr_iono_delay_m(x->stec_tecu, s->arc[a].freq1_hz, ORR_MEASURES_CODE));
        }
}
