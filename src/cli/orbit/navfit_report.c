// SPDX-License-Identifier: GPL-3.0-or-later
// How well the sets stand for the orbit.
#include <math.h>
#include <stdio.h>

#include "core/nan.h"
#include "src/cli/frame/json.h"
#include "src/cli/orbit/navfit_write.h"

// One system's sets.
typedef struct tally {
    size_t sats, sets, shifted, unhealthy, clocks, nominal, no_antenna, no_delay;
    double sum_m2, fit_m2, clock_s2, worst_m, step_m;
    orr_sat worst;
} tally;

// A set, and by how much position and clock step where it takes the place of the one before; NAN where it takes none's.
typedef struct update {
    double step_m, clock_step_s;
} update;

static update update_of(const orr_navset_item *item, size_t k)
{
    update u = {ORR_NAN, ORR_NAN};
    if (k > 0) orr_navset_step(&item[k - 1], &item[k], &u.step_m, &u.clock_step_s);
    return u;
}

static void add(tally *t, orr_sat sat, const orr_navset_item *item, update u)
{
    if (u.step_m > t->step_m) t->step_m = u.step_m;
    t->sets++;
    t->sum_m2 += item->report.rms_m * item->report.rms_m;
    t->fit_m2 += item->report.fit_rms_m * item->report.fit_rms_m;
    t->shifted += (item->notes & ORR_NAVSET_SHIFTED) != 0;
    t->unhealthy += item->eph.health != 0;
    t->nominal += (item->notes & ORR_NAVSET_NOMINAL_CHANNEL) != 0;
    t->no_antenna += (item->notes & ORR_NAVSET_NO_ANTENNA) != 0;
    t->no_delay += (item->notes & ORR_NAVSET_NO_DELAY) != 0;
    if (isfinite(item->clock_rms_s) && item->eph.health == 0) { // what is sent as unhealthy is not to be used
        t->clocks++;
        t->clock_s2 += item->clock_rms_s * item->clock_rms_s;
    }
    if (!(item->report.max_m > t->worst_m)) return;
    t->worst_m = item->report.max_m;
    t->worst = sat;
}

static tally tally_message(const orr_navset *set, char system, orr_nav_message message)
{
    tally t = {0};
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat);
    for (size_t i = 0; i < n; i++) {
        const orr_navset_item *item;
        if (orr_sat_system(sat[i]) != system) continue;
        size_t sets = orr_navset_items(set, sat[i], message, &item);
        t.sats += sets > 0;
        for (size_t k = 0; k < sets; k++) add(&t, sat[i], &item[k], update_of(item, k));
    }
    return t;
}

// The next message of a system after *k streams; NONE behind the last.
static orr_nav_message next_message(char system, size_t *k)
{
    size_t n;
    const orr_nav_stream *stream = orr_nav_streams(&n);
    for (; *k < n; ++*k) {
        if (stream[*k].system != system) continue;
        if (*k > 0 && stream[*k - 1].system == system && stream[*k - 1].message == stream[*k].message)
            continue;
        return stream[(*k)++].message;
    }
    return ORR_NAV_NONE;
}

static double root_mean(double sum, size_t n) { return n > 0 ? sqrt(sum / (double)n) : ORR_NAN; }

static void say_message(const orr_cli *c, char system, orr_nav_message message, const tally *t)
{
    char worst[ORR_SAT_TEXT], clock[16] = "-"; // of clocks of zero there is nothing to tell
    if (t->clocks > 0) snprintf(clock, sizeof clock, "%.2f", 1e9 * root_mean(t->clock_s2, t->clocks));
    orr_cli_say(c, "%-8s %-7s %5zu %6zu %8.3f %16.3f %12.3f (%s) %8.3f %9s %8zu %10zu",
                orr_system_name(system), orr_nav_message_name(message), t->sats, t->sets,
                root_mean(t->sum_m2, t->sets), root_mean(t->fit_m2, t->sets), t->worst_m,
                orr_sat_text(t->worst, worst), t->step_m, clock, t->shifted, t->unhealthy);
}

void navfit_say(const orr_cli *c, const orr_navset *set)
{
    size_t nominal = 0, no_antenna = 0, no_delay = 0;
    orr_cli_say(c, "%-8s %-7s %5s %6s %8s %16s %18s %8s %9s %8s %10s", "system", "message", "sats", "sets",
                "RMS m", "before rounding", "worst m", "step m", "clock ns", "shifted", "unhealthy");
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        orr_nav_message message;
        for (size_t k = 0; (message = next_message(*system, &k)) != ORR_NAV_NONE;) {
            const tally t = tally_message(set, *system, message);
            if (t.sats == 0) continue;
            say_message(c, *system, message, &t);
            nominal += t.nominal;
            no_antenna += t.no_antenna;
            no_delay += t.no_delay;
        }
    }
    if (nominal > 0)
        orr_cli_say(c, "%zu GLONASS sets have the nominal channel of their slot; --nav tells the true ones",
                    nominal);
    if (no_antenna > 0)
        orr_cli_say(c, "%zu sets are of the centre of mass: ANTEX does not have the antenna", no_antenna);
    if (no_delay > 0)
        orr_cli_say(c, "%zu sets have no group delay: the biases do not have it, or not within its field",
                    no_delay);
}

static json_t *json_message(const tally *t)
{
    char worst[ORR_SAT_TEXT];
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:s, s:o, s:o, s:o, s:o}", "satellites",
                     orr_json_count(t->sats), "sets", orr_json_count(t->sets), "rms_m",
                     orr_json_number(root_mean(t->sum_m2, t->sets)), "rms_before_rounding_m",
                     orr_json_number(root_mean(t->fit_m2, t->sets)), "worst_m", orr_json_number(t->worst_m),
                     "worst", orr_sat_text(t->worst, worst), "worst_step_m", orr_json_number(t->step_m),
                     "clock_rms_ns", orr_json_number(1e9 * root_mean(t->clock_s2, t->clocks)), "shifted",
                     orr_json_count(t->shifted), "unhealthy", orr_json_count(t->unhealthy));
}

static json_t *json_notes(uint32_t notes)
{
    static const struct {
        uint32_t bit;
        const char *word;
    } word[] = {{ORR_NAVSET_MANOEUVRE, "manoeuvre"},  {ORR_NAVSET_SHIFTED, "shifted"},
                {ORR_NAVSET_NO_CLOCK, "no clock"},    {ORR_NAVSET_NO_ANTENNA, "no antenna"},
                {ORR_NAVSET_NO_DELAY, "no delay"},    {ORR_NAVSET_NOMINAL_CHANNEL, "nominal channel"},
                {ORR_NAVSET_CLOCK_JUMP, "clock jump"}};
    json_t *list = json_array();
    for (size_t k = 0; k < sizeof word / sizeof word[0]; k++)
        if (notes & word[k].bit) json_array_append_new(list, json_string(word[k].word));
    return list;
}

static json_t *json_set(orr_sat sat, const orr_navset_item *item, update u)
{
    const char *message = orr_nav_message_name((orr_nav_message)item->eph.message);
    char name[ORR_SAT_TEXT], toe[ORR_TIME_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    json_t *o = json_pack("{s:s, s:s, s:s, s:s, s:s, s:f, s:f, s:o, s:i, s:o}", "sat",
                          orr_sat_text(sat, name), "message", message, "toe",
                          orr_time_text(item->eph.toe, toe), "from", orr_time_text(item->from, from), "to",
                          orr_time_text(item->to, to), "rms_m", item->report.rms_m, "max_m",
                          item->report.max_m, "clock_rms_ns", orr_json_number(1e9 * item->clock_rms_s),
                          "health", (int)item->eph.health, "notes", json_notes(item->notes));
    json_object_set_new(o, "step_m", orr_json_number(u.step_m));
    json_object_set_new(o, "clock_step_ns", orr_json_number(1e9 * u.clock_step_s));
    if (item->eph.iodc >= 0) json_object_set_new(o, "iodc", json_integer(item->eph.iodc));
    if (item->eph.iode >= 0) json_object_set_new(o, "iode", json_integer(item->eph.iode));
    return o;
}

int navfit_print_json(const orr_cli *c, const orr_navset *set, const orr_inputs *inputs)
{
    json_t *root = json_object(), *systems = json_object(), *sets = json_array();
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        const char key[2] = {*system, '\0'};
        json_t *messages = json_object();
        orr_nav_message message;
        for (size_t k = 0; (message = next_message(*system, &k)) != ORR_NAV_NONE;) {
            const tally t = tally_message(set, *system, message);
            if (t.sats > 0) json_object_set_new(messages, orr_nav_message_name(message), json_message(&t));
        }
        if (json_object_size(messages) > 0)
            json_object_set_new(systems, key, messages);
        else
            json_decref(messages);
    }
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat);
    for (size_t i = 0; i < n; i++) {
        orr_nav_message message;
        for (size_t k = 0; (message = next_message(orr_sat_system(sat[i]), &k)) != ORR_NAV_NONE;) {
            const orr_navset_item *item;
            const size_t m = orr_navset_items(set, sat[i], message, &item);
            for (size_t j = 0; j < m; j++)
                json_array_append_new(sets, json_set(sat[i], &item[j], update_of(item, j)));
        }
    }
    json_object_set_new(root, "systems", systems);
    json_object_set_new(root, "sets", sets);
    json_t *files = json_array();
    for (size_t i = 0; i < inputs->n; i++)
        json_array_append_new(files, json_pack("{s:o, s:s}", "file", orr_json_text(inputs->item[i].name),
                                               "sha256", inputs->item[i].sha256));
    json_object_set_new(root, "inputs", files);
    int status = orr_json_print(c, root, JSON_INDENT(1) | JSON_REAL_PRECISION(9));
    return status == ORR_EXIT_OK ? orr_cli_flush(c) : status;
}
