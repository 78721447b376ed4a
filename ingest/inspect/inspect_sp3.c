// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery inspect` tells of an SP3 file.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ingest/inspect/inspect.h"
#include "ingest/sp3/sp3.h"

// A list of satellites as text, cut with a count when it gets long.
typedef struct sat_list {
    char text[400];
    size_t n, length;
} sat_list;

static void sat_list_add(sat_list *l, orr_sat sat, const char *detail)
{
    char name[ORR_SAT_TEXT];
    if (l->length + 64 < sizeof l->text)
        l->length += (size_t)snprintf(l->text + l->length, sizeof l->text - l->length, "%s%s%s",
                                      l->n > 0 ? ", " : "", orr_sat_text(sat, name), detail);
    else if (l->text[l->length - 1] != '.')
        l->length += (size_t)snprintf(l->text + l->length, sizeof l->text - l->length, " ...");
    l->n++;
}

static void tell_records(const orr_sp3 *o, orr_inspection *r)
{
    size_t cells = 0, positions = 0, clocks = 0, velocities = 0, predicted = 0, events = 0;
    orr_time first_predicted = ORR_TIME_NONE;
    sat_list absent = {0}, partial = {0}, moved = {0};
    for (size_t s = 0; s < o->n_sats; s++) {
        size_t here = 0, manoeuvres = 0;
        orr_time first_manoeuvre = ORR_TIME_NONE;
        for (size_t e = 0; e < o->n_epochs; e++) {
            const orr_sp3_record *x = &o->record[e * o->n_sats + s];
            cells++;
            here += isnan(x->pos_m[0]) ? 0 : 1;
            clocks += isnan(x->clock_s) ? 0 : 1;
            velocities += isnan(x->vel_mps[0]) ? 0 : 1;
            events += (x->flags & ORR_SP3_CLOCK_EVENT) != 0;
            if ((x->flags & ORR_SP3_ORBIT_PREDICTED) != 0) {
                predicted++;
                if (first_predicted == ORR_TIME_NONE || o->epoch[e] < first_predicted)
                    first_predicted = o->epoch[e];
            }
            if ((x->flags & ORR_SP3_MANOEUVRE) != 0 && manoeuvres++ == 0) first_manoeuvre = o->epoch[e];
        }
        positions += here;
        char detail[32 + ORR_TIME_TEXT], t[ORR_TIME_TEXT];
        snprintf(detail, sizeof detail, " (%zu of %zu)", here, o->n_epochs);
        if (o->n_records[s] == 0)
            sat_list_add(&absent, o->sat[s], "");
        else if (here < o->n_epochs)
            sat_list_add(&partial, o->sat[s], detail);
        snprintf(detail, sizeof detail, " from %s",
                 orr_time_text(first_manoeuvre != ORR_TIME_NONE ? first_manoeuvre : 0, t));
        if (manoeuvres > 0) sat_list_add(&moved, o->sat[s], detail);
    }
    orr_inspect_fact_add(r, "positions", "%zu of %zu", positions, cells);
    orr_inspect_fact_add(r, "clocks", "%zu of %zu", clocks, cells);
    if (o->has_velocity) orr_inspect_fact_add(r, "velocities", "%zu of %zu", velocities, cells);
    char t[ORR_TIME_TEXT];
    if (predicted > 0)
        orr_inspect_fact_add(r, "predicted", "%zu records, the first at %s", predicted,
                             orr_time_text(first_predicted, t));
    if (events > 0) orr_inspect_fact_add(r, "clock events", "%zu records", events);
    if (moved.n > 0) orr_inspect_fact_add(r, "manoeuvres", "%s", moved.text);
    if (partial.n > 0) orr_inspect_fact_add(r, "incomplete", "%s", partial.text);
    if (absent.n > 0) orr_inspect_fact_add(r, "never seen", "%s", absent.text);
    if (o->correlation != NULL) orr_inspect_fact_add(r, "correlations", "EP/EV records");
}

orr_status orr_inspect_sp3(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_sp3 o;
    orr_sp3_limits limits = orr_sp3_default_limits();
    limits.leap = r->leap;
    orr_bytes text;
    orr_status st = orr_inspect_text(r, path, &text, diag);
    if (st != ORR_OK) return st;
    st = orr_sp3_parse(path, text.text, text.n, &limits, &o, &r->warnings, diag);
    orr_bytes_free(&text);
    if (st != ORR_OK) return st;
    snprintf(r->version, sizeof r->version, "%c", o.version);
    for (size_t s = 0; s < o.n_sats; s++)
        if (o.n_records[s] > 0) orr_inspect_sat_add(r, o.sat[s]);
    if (o.n_epochs == 1 && o.interval_s > 0) r->interval_s = o.interval_s; // else the epochs say it
    orr_inspect_epochs(r, o.epoch, o.n_epochs);
    orr_inspect_fact_add(r, "agency", "%s", o.agency);
    orr_inspect_fact_add(r, "frame", "%s", o.coordinates);
    orr_inspect_fact_add(r, "orbit", "%s, from %s", o.orbit_type, o.data_used);
    orr_inspect_fact_add(r, "time system", "%s", orr_scale_name(o.scale));
    tell_records(&o, r);
    for (size_t i = 0, shown = 0; i < o.n_comments && shown < 4; i++) {
        bool filler =
            strspn(o.comment[i], "C ") == strlen(o.comment[i]); // the standard's own placeholder, or blank
        if (!filler) orr_inspect_fact_add(r, shown++ == 0 ? "comments" : "", "%s", o.comment[i]);
    }
    orr_sp3_free(&o);
    return ORR_OK;
}
