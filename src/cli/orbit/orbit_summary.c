// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/orbit_summary.h"

#include <math.h>
#include <stdio.h>

#include "src/cli/frame/json.h"
#include "src/cli/orbit/orbit_events.h"

// What happened to one system's satellites.
typedef struct tally {
    size_t sats, used, rejected;
    orbit_event_counts events;
    double residual2;
} tally;

static tally tally_system(const orr_ephemeris *e, char system)
{
    tally t = {0};
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(e, &sat);
    for (size_t i = 0; i < n; i++) {
        const orr_orbit_node *node;
        const orr_orbit_event *event;
        if (orr_sat_system(sat[i]) != system) continue;
        t.sats++;
        const size_t n_nodes = orr_ephemeris_nodes(e, sat[i], &node),
                     n_events = orr_ephemeris_events(e, sat[i], &event);
        for (size_t k = 0; k < n_nodes; k++) {
            t.rejected += node[k].used == 0;
            if (!node[k].used) continue;
            t.used++;
            t.residual2 += orr_vec3_dot(node[k].residual_m, node[k].residual_m);
        }
        orbit_events_count(event, n_events, &t.events);
    }
    return t;
}

static double residual_mm(const tally *t)
{
    return t->used > 0 ? 1e3 * sqrt(t->residual2 / (double)t->used) : 0.0;
}

// Where files of consecutive days join, their own values differ; the product goes through between them.
typedef struct joints {
    size_t n;
    double rms_m, max_m;
    orr_sat worst;
} joints;

static joints tally_joints(const orr_ephemeris *e)
{
    joints j = {0};
    double sum = 0;
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(e, &sat);
    for (size_t i = 0; i < n; i++) {
        const orr_orbit_event *event;
        const size_t n_events = orr_ephemeris_events(e, sat[i], &event);
        for (size_t k = 0; k < n_events; k++) {
            if (event[k].kind != ORR_EVENT_DAY_JUMP) continue;
            j.n++;
            sum += event[k].value * event[k].value;
            if (event[k].value <= j.max_m) continue;
            j.max_m = event[k].value;
            j.worst = sat[i];
        }
    }
    if (j.n > 0) j.rms_m = sqrt(sum / (double)j.n);
    return j;
}

// Manoeuvres first, then what was left out, then gaps: as many as a reader will read.
static void say_events(const orr_cli *c, const orr_ephemeris *orbit)
{
    enum { SHOWN = 12 };
    static const orr_event_kind order[] = {ORR_EVENT_MANOEUVRE, ORR_EVENT_OUTLIER, ORR_EVENT_GAP};
    char text[256];
    size_t told = 0;
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(orbit, &sat);
    for (size_t k = 0; k < sizeof order / sizeof order[0]; k++)
        for (size_t i = 0; i < n; i++) {
            const orr_orbit_event *event;
            const size_t n_events = orr_ephemeris_events(orbit, sat[i], &event);
            for (size_t j = 0; j < n_events; j++) {
                if (event[j].kind != order[k] ||
                    !orbit_event_text(sat[i], &event[j], orbit, text, sizeof text))
                    continue;
                if (told++ < SHOWN) orr_cli_say(c, "%s", text);
            }
        }
    if (told > SHOWN) orr_cli_say(c, "and %zu more such events; --format json tells all", told - SHOWN);
}

static void say_table(const orr_cli *c, const orr_orbit_solution *s, const orr_smoother_report *report,
                      const orr_ephemeris *e, const orbit_seconds *seconds)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT], name[ORR_SAT_TEXT];
    double pos, vel;
    orr_ephemeris_representation(e, &pos, &vel);
    orr_cli_say(c, "%s: %s to %s (GPS time), nodes every %g s", orr_cli_text(c, "output", ""),
                orr_time_text(s->from, from), orr_time_text(s->to, to), s->node_step_s);
    orr_cli_say(c, "%-9s %5s %8s %12s %9s %10s %5s %9s", "system", "sats", "nodes", "residual mm", "left out",
                "manoeuvres", "gaps", "eclipses");
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        tally t = tally_system(e, *system);
        if (t.sats == 0) continue;
        orr_cli_say(c, "%-9s %5zu %8zu %12.3f %9zu %10zu %5zu %9zu", orr_system_name(*system), t.sats, t.used,
                    residual_mm(&t), t.rejected, t.events.manoeuvres, t.events.gaps, t.events.eclipses);
    }
    say_events(c, e);
    joints j = tally_joints(e);
    if (j.n > 0 && j.worst != ORR_SAT_NONE)
        orr_cli_say(
            c, "where files join or overlap they differ by %.1f mm RMS, %.1f mm at most (%s; %zu places)",
            1e3 * j.rms_m, 1e3 * j.max_m, orr_sat_text(j.worst, name), j.n);
    char rotation[256];
    const double mas = ORR_RAD_PER_DEG / 3.6e6;
    snprintf(rotation, sizeof rotation, "%s",
             report->eop_known        ? "as given"
             : report->eop_carried_on ? "as given, carried on beyond its ends"
                                      : "secular pole, UT1 by the leap seconds");
    if (report->eop_estimated)
        snprintf(rotation, sizeof rotation,
                 "told by the orbits themselves, pole %.3f, %.3f mas (sigma %.3f), length of day %+.4f ms",
                 report->xp_rad / mas, report->yp_rad / mas, report->pole_sigma_rad / mas,
                 1e3 * report->lod_s);
    else if (report->eop_known && report->eop_told)
        snprintf(rotation, sizeof rotation,
                 "as given; the orbits tell a pole %+.3f, %+.3f mas and a length of day %+.4f ms off it",
                 report->xp_off_rad / mas, report->yp_off_rad / mas, 1e3 * report->lod_off_s);
    orr_cli_say(c, "Earth rotation: %s; segments meet the smoothed orbit to %.4f mm and %.1e m/s", rotation,
                1e3 * pos, vel);
    size_t rough = orr_ephemeris_shortened(e);
    if (rough > 0)
        orr_cli_say(
            c,
            "%zu arcs are rough: their segments had to be made shorter, and between samples they say little",
            rough);
    orr_cli_say(c, "read %.2f s, smoothed %.2f s, fitted %.2f s, written %.2f s", seconds->read,
                seconds->smooth, seconds->fit, seconds->write);
}

static json_t *json_systems(const orr_ephemeris *e)
{
    json_t *systems = json_object();
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        tally t = tally_system(e, *system);
        if (t.sats == 0) continue;
        const char key[2] = {*system, '\0'};
        json_t *o = json_object();
        json_object_set_new(o, "satellites", orr_json_count(t.sats));
        json_object_set_new(o, "nodes", orr_json_count(t.used));
        json_object_set_new(o, "left_out", orr_json_count(t.rejected));
        json_object_set_new(o, "residual_rms_mm", orr_json_number(residual_mm(&t)));
        json_object_set_new(o, "manoeuvres", orr_json_count(t.events.manoeuvres));
        json_object_set_new(o, "gaps", orr_json_count(t.events.gaps));
        json_object_set_new(o, "eclipses", orr_json_count(t.events.eclipses));
        json_object_set_new(systems, key, o);
    }
    return systems;
}

// All but eclipses, which are many and follow from the orbit.
static json_t *json_events(const orr_ephemeris *orbit)
{
    json_t *all = json_array();
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(orbit, &sat);
    for (size_t i = 0; i < n; i++) {
        const orr_orbit_event *event;
        const size_t n_events = orr_ephemeris_events(orbit, sat[i], &event);
        for (size_t k = 0; k < n_events; k++) {
            const orr_orbit_event *e = &event[k];
            if (e->kind == ORR_EVENT_UMBRA || e->kind == ORR_EVENT_PENUMBRA) continue;
            json_t *o = json_object();
            json_object_set_new(o, "sat", orr_json_sat(sat[i]));
            json_object_set_new(o, "kind", json_string(orbit_event_name(e->kind)));
            json_object_set_new(o, "from", orr_json_time(e->t0));
            json_object_set_new(o, "to", orr_json_time(e->t1));
            if (e->kind == ORR_EVENT_MANOEUVRE)
                json_object_set_new(o, "change_mps", orr_json_number(e->value));
            else if (e->kind != ORR_EVENT_GAP && e->value > 0)
                json_object_set_new(o, "size_m", orr_json_number(e->value));
            json_array_append_new(all, o);
        }
    }
    return all;
}

static json_t *json_clock_events(const orr_clock_events *events)
{
    static const char *const name[] = {"", "wrong_value", "jump", "flagged", "reference"};
    json_t *all = json_array();
    for (size_t i = 0; i < events->n; i++) {
        const orr_clock_event *e = &events->item[i];
        json_t *o = json_object();
        json_object_set_new(o, "kind", json_string(name[e->kind]));
        if (e->kind == ORR_CLOCK_EVENT_REFERENCE)
            json_object_set_new(o, "systems", json_string(e->systems));
        else
            json_object_set_new(o, "sat", orr_json_sat(e->sat));
        json_object_set_new(o, "from", orr_json_time(e->t0));
        json_object_set_new(o, "to", orr_json_time(e->t1));
        if (e->kind != ORR_CLOCK_EVENT_FLAG) json_object_set_new(o, "value_ns", json_real(1e9 * e->value_s));
        json_array_append_new(all, o);
    }
    return all;
}

static json_t *json_prediction(const orr_predict_report *p, const orr_ephemeris *e)
{
    if (p == NULL) return json_null();
    const double mas = ORR_RAD_PER_DEG / 3.6e6;
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    json_t *o = json_object();
    json_object_set_new(o, "from", orr_json_time(p->from));
    json_object_set_new(o, "to", orr_json_time(to));
    json_object_set_new(o, "orbits", orr_json_count(p->orbits));
    json_object_set_new(o, "clocks", orr_json_count(p->clocks));
    json_object_set_new(o, "left_out", orr_json_count(p->left_out));
    if (p->eop_estimated) {
        json_t *r = json_object();
        json_object_set_new(r, "xp_mas", json_real(p->xp_rad / mas));
        json_object_set_new(r, "yp_mas", json_real(p->yp_rad / mas));
        json_object_set_new(r, "lod_ms", json_real(1e3 * p->lod_s));
        json_object_set_new(r, "pole_sigma_mas", json_real(p->pole_sigma_rad / mas));
        json_object_set_new(o, "earth_rotation", r);
    }
    return o;
}

static int print_json(const orr_cli *c, const orr_orbit_solution *s, const orr_smoother_report *report,
                      const orr_ephemeris *e, const orr_predict_report *prediction,
                      const orbit_seconds *seconds)
{
    double pos, vel;
    joints joint = tally_joints(e);
    orr_ephemeris_representation(e, &pos, &vel);
    json_t *j = json_object(), *o = json_object(), *jumps = json_object();
    json_object_set_new(j, "from", orr_json_time(s->from));
    json_object_set_new(j, "to", orr_json_time(s->to));
    json_object_set_new(j, "node_step_s", orr_json_number(s->node_step_s));
    json_object_set_new(j, "systems", json_systems(e));
    json_object_set_new(jumps, "n", orr_json_count(joint.n));
    json_object_set_new(jumps, "rms_mm", orr_json_number(1e3 * joint.rms_m));
    json_object_set_new(jumps, "max_mm", orr_json_number(1e3 * joint.max_m));
    json_object_set_new(j, "day_jumps", jumps);
    json_object_set_new(j, "events", json_events(e));
    json_object_set_new(j, "clock_events", json_clock_events(&s->clock_events));
    json_object_set_new(j, "earth_rotation_given", json_boolean(report->eop_known));
    if (report->eop_told) {
        const double mas = ORR_RAD_PER_DEG / 3.6e6;
        json_t *r = json_object();
        json_object_set_new(r, "used", json_boolean(report->eop_estimated));
        json_object_set_new(r, "xp_mas", json_real(report->xp_rad / mas));
        json_object_set_new(r, "yp_mas", json_real(report->yp_rad / mas));
        json_object_set_new(r, "lod_ms", json_real(1e3 * report->lod_s));
        json_object_set_new(r, "pole_sigma_mas", json_real(report->pole_sigma_rad / mas));
        if (report->eop_known) {
            json_object_set_new(r, "xp_off_mas", json_real(report->xp_off_rad / mas));
            json_object_set_new(r, "yp_off_mas", json_real(report->yp_off_rad / mas));
            json_object_set_new(r, "lod_off_ms", json_real(1e3 * report->lod_off_s));
        }
        json_object_set_new(j, "earth_rotation", r);
    }
    json_object_set_new(j, "prediction", json_prediction(prediction, e));
    json_object_set_new(j, "segment_error_mm", orr_json_number(1e3 * pos));
    json_object_set_new(j, "segment_error_mps", orr_json_number(vel));
    json_object_set_new(j, "rough_arcs", orr_json_count(orr_ephemeris_shortened(e)));
    json_object_set_new(o, "read", orr_json_number(seconds->read));
    json_object_set_new(o, "smooth", orr_json_number(seconds->smooth));
    json_object_set_new(o, "fit", orr_json_number(seconds->fit));
    json_object_set_new(o, "write", orr_json_number(seconds->write));
    json_object_set_new(j, "seconds", o);
    return orr_json_print(c, j, JSON_INDENT(2));
}

static void say_prediction(const orr_cli *c, const orr_predict_report *p, const orr_ephemeris *e)
{
    char when[2][ORR_TIME_TEXT];
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    orr_cli_say(c, "predicted from %s to %s: %zu orbits, %zu clocks; %s", orr_time_text(p->from, when[0]),
                orr_time_text(to, when[1]), p->orbits, p->clocks,
                p->eop_known ? "Earth rotation as given"
                : p->eop_estimated
                    ? "Earth rotation carried on as the orbits tell it"
                    : "of the Earth's rotation too few satellites tell, and the product keeps none");
}

int orbit_summary_print(const orr_cli *c, const orr_orbit_solution *s, const orr_smoother_report *report,
                        const orr_ephemeris *e, const orr_predict_report *prediction,
                        const orbit_seconds *seconds)
{
    if (orr_cli_says(c, "format", "json")) return print_json(c, s, report, e, prediction, seconds);
    say_table(c, s, report, e, seconds);
    if (prediction != NULL) say_prediction(c, prediction, e);
    return ORR_EXIT_OK;
}
