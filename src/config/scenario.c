// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/scenario.h"

#include <stdlib.h>
#include <string.h>

#include "src/config/rows_private.h"

static const orr_key serve_rows[] = {
    {.name = "listen",
     .kind = ORR_KEY_TEXT,
     .list = true,
     .offset = offsetof(orr_scenario_serve, listen),
     .help = "where to listen: tcp://HOST:PORT or tls://HOST:PORT (host *: every address; port 0: any free "
             "one) or "
             "unix:PATH. 'orrery serve --listen' overrules it"},
    FILE_ROW(orr_scenario_serve, "access", access, NULL,
             "who may come in from other machines: certificates, permissions, limits (docs/security.md); "
             "'orrery serve --access' overrules it"),
    BOOL_ROW(
        orr_scenario_serve, "insecure_listen", insecure_listen, "false", NULL,
        "listen at addresses that other machines reach without TLS: whoever reaches them may do everything"),
};
static const orr_schema serve_table = ORR_SCHEMA(serve_rows, orr_scenario_serve);

static const orr_condition of_orbit[] = {{.key = "orbit", .why = "there are no satellites"}, {0}};
static const orr_condition of_ionosphere[] = {
    {.key = "orbit", .why = "there are no satellites"},
    {.key = "ionosphere|signals", .why = "nothing else asks where it is"},
    {0}};
static const orr_condition of_signals[] = {{.key = "signals|replay", .why = "no signals are sent"}, {0}};
static const orr_condition of_replay[] = {
    {.key = "orbit", .why = "there are no satellites"},
    {.key = "ionosphere", .why = "the content's level comes from a field (ionosphere.field)"},
    {.key = "antennas", .absent = true, .why = "a replay has its station's antenna"},
    {.key = "receiver", .absent = true, .why = "a replay has its station's place"},
    {.key = "spoofers", .absent = true, .why = "they would send what was recorded"},
    {0}};
static const orr_condition of_trajectory[] = {{.key = "trajectory", .why = "nothing moves"}, {0}};

static const orr_key rows[] = {
    TEXT_ROW(orr_scenario, "title", title, NULL, "what this scenario is, in a line; clients are told"),
    INT_ROW(orr_scenario, "schema", schema, 1, 1000, "1", NULL,
            "which keys the file was written for; a program that knows them not refuses it"),
    MAP_ROW(orr_scenario, "orbit", orbit, &orr_section_orbit, NULL, "where the satellites are"),
    MAP_ROW(orr_scenario, "navdata", navdata, &orr_section_navdata, of_orbit,
            "broadcast data that are fitted to the orbits"),
    MAP_ROW(orr_scenario, "ionosphere", iono, &orr_section_ionosphere, of_orbit,
            "ionospheric delays to the satellites"),
    MAP_ROW(orr_scenario, "receiver", receiver, &orr_section_receiver, of_ionosphere,
            "where the satellites are received; their delays depend on it"),
    MAP_ROW(orr_scenario, "trajectory", motion.trajectory, &orr_section_trajectory, NULL,
            "where the body with the inertial units goes"),
    MAPS_ROW(orr_scenario, "units", motion.units, &orr_section_unit, ORR_MOTION_MAX_UNITS - 1, of_trajectory,
             "further inertial units on the body; unit 0 is the trajectory's own point"),
    MAP_ROW(orr_scenario, "gravity", motion.gravity, &orr_section_gravity, of_trajectory,
            "the field that the readings are made in"),
    MAP_ROW(orr_scenario, "imu", motion.imu, &orr_section_imu, of_trajectory, "the inertial readings"),
    {.name = "signals",
     .kind = ORR_KEY_TEXT,
     .list = true,
     .offset = offsetof(orr_scenario, signals),
     .only = of_orbit,
     .help = "signals that are sent: SYSTEM:NAME (G:L1CA), a name for all systems that have it (L1CA), or a "
             "system's letter for "
             "all of its signals; 'orrery check' lists them"},
    {.name = "troposphere",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario, troposphere),
     .given = offsetof(orr_scenario, has_troposphere),
     .map = &orr_section_troposphere,
     .only = of_signals,
     .help = "delay of the neutral atmosphere; without this section there is none"},
    MAPS_ROW(orr_scenario, "antennas", antennas, &orr_section_antenna, ORR_MAX_ANTENNAS, of_signals,
             "antennas that receive the signals; without this section one where the receiver is"),
    MAP_ROW(orr_scenario, "satellites", satellites, &orr_section_satellites, of_signals,
            "which satellites send, and how"),
    MAP_ROW(orr_scenario, "mask", mask, &orr_section_mask, of_signals, "what the antennas see of the sky"),
    MAP_ROW(orr_scenario, "channel", channel, &orr_section_channel, of_signals, "what a channel consists of"),
    {.name = "replay",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario, replay),
     .given = offsetof(orr_scenario, has_replay),
     .map = &orr_section_replay,
     .only = of_replay,
     .help = "a station's recorded observations, which the channels reproduce; signals are those of the "
             "record, or of these "
             "the ones that `signals` names"},
    MAP_ROW(orr_scenario, "site", site, &orr_section_site, of_signals,
            "how the ground moves below fixed antennas"),
    MAP_ROW(orr_scenario, "obstacles", obstacles, &orr_section_obstacles, of_signals, "walls and tunnels"),
    MAPS_ROW(orr_scenario, "land_mobile", land_mobile, &orr_section_land_mobile, 100, of_signals,
             "a road on which satellites are in view and in shadow by turns"),
    MAPS_ROW(orr_scenario, "spoofers", spoofers, &orr_section_spoofer, ORR_MAX_SPOOFERS, of_signals,
             "false sets of signals, sent from a place of their own: for conducted tests"),
    MAPS_ROW(orr_scenario, "jammers", jammers, &orr_section_jammer, ORR_MAX_JAMMERS, of_signals,
             "transmitters that disturb, as geometry and power: for conducted tests"),
    MAP_ROW(orr_scenario, "clocks", clocks, &orr_section_clocks, of_signals, "noise of clocks"),
    MAPS_ROW(orr_scenario, "scintillation", scintillation, &orr_section_scintillation, 100, of_signals,
             "amplitudes and phases that irregularities of the ionosphere disturb"),
    MAP_ROW(orr_scenario, "disturbance", disturbance, &orr_section_disturbance, of_signals,
            "travelling disturbances and storm fronts of the ionosphere"),
    MAP_ROW(orr_scenario, "multipath", multipath, &orr_section_multipath, of_signals,
            "echoes of the signals, each a channel of its own"),
    MAP_ROW(orr_scenario, "faults", faults, &orr_section_faults, of_signals,
            "what goes wrong at given times"),
    MAP_ROW(orr_scenario, "serve", serve, &serve_table, NULL, "the service"),
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario *s = map;
    const size_t units = s->motion.units.n;
    if (s->schema > ORR_SCENARIO_SCHEMA) {
        snprintf(why, ORR_SCHEMA_WHY,
                 "the file is written for schema %lld and this program reads up to %d: take a newer Orrery",
                 (long long)s->schema, ORR_SCENARIO_SCHEMA);
        return "schema";
    }
    // A flight alone is a scenario too: inertial readings without satellites.
    if (s->orbit.product == NULL && s->orbit.sp3.n == 0 && s->orbit.nav.n == 0 &&
        s->motion.trajectory.kind == ORR_MOTION_NONE) {
        snprintf(why, ORR_SCHEMA_WHY,
                 "no orbits and no trajectory: name an orbit.product, orbit.sp3 or orbit.nav, or a "
                 "trajectory.kind");
        return "";
    }
    if (s->receiver.unit > (int64_t)units) {
        snprintf(why, ORR_SCHEMA_WHY, "there is no unit %lld, the scenario has 0 to %zu",
                 (long long)s->receiver.unit, units);
        return "receiver";
    }
    if (s->has_replay && s->iono.field == NULL) {
        snprintf(why, ORR_SCHEMA_WHY,
                 "its content is levelled to a field: name an ionosphere.field, not a session");
        return "replay";
    }
    const char *blame = orr_section_signals_check(&s->signals, why);
    for (size_t k = 0; blame == NULL && k < s->antennas.n; k++) {
        const orr_scenario_antenna *a = &s->antennas.item[k];
        if (a->position.n == 0 && s->motion.trajectory.kind == ORR_MOTION_NONE) {
            snprintf(why, ORR_SCHEMA_WHY,
                     "antenna %zu has no position, and there is no trajectory whose body it could be on",
                     k + 1);
            blame = "antennas";
        } else if (a->unit > (int64_t)units) {
            snprintf(why, ORR_SCHEMA_WHY, "antenna %zu: there is no unit %lld, the scenario has 0 to %zu",
                     k + 1, (long long)a->unit, units);
            blame = "antennas";
        }
        for (size_t j = 0; blame == NULL && j < k; j++)
            if (a->name != NULL && s->antennas.item[j].name != NULL &&
                strcmp(a->name, s->antennas.item[j].name) == 0) {
                snprintf(why, ORR_SCHEMA_WHY, "antennas %zu and %zu are both called '%s'", j + 1, k + 1,
                         a->name);
                blame = "antennas";
            }
    }
    return blame;
}

static const orr_schema schema = {.key = rows,
                                  .n = sizeof rows / sizeof rows[0],
                                  .size = sizeof(orr_scenario),
                                  .check = check,
                                  .hint = "orrery serve --help-scenario lists all"};

const orr_schema *orr_scenario_schema(void) { return &schema; }

// A tree as a scenario of a run.
static orr_status of_tree(const orr_schema *table, const orr_yaml *y, const char *folder,
                          const orr_leap_table *leap, orr_scenario *out, orr_diag *diag)
{
    orr_status s = orr_schema_read(table, y, folder, leap, out, diag);
    out->leap = leap;
    if (s != ORR_OK || y->root == NULL) return s;
    s = orr_marks_of(y, &out->marks, diag);
    if (s != ORR_OK) orr_scenario_free(out);
    return s;
}

orr_status orr_scenario_parse(const char *name, const char *text, size_t n, const char *folder,
                              const orr_leap_table *leap, orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_parse(name, text, n, &y, diag);
    if (s != ORR_OK) return s;
    s = of_tree(&schema, &y, folder, leap, out, diag);
    orr_yaml_free(&y);
    return s;
}

orr_status orr_scenario_read(const char *path, const orr_leap_table *leap, orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_read(path, &y, diag);
    if (s != ORR_OK) return s;
    char *folder = orr_yaml_folder(path);
    if (folder == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    else
        s = of_tree(&schema, &y, folder, leap, out, diag);
    free(folder);
    orr_yaml_free(&y);
    return s;
}

// The tables' defaults; what has to be in a file is left to the caller.
static orr_status defaults(const orr_leap_table *leap, orr_scenario *out, orr_diag *diag)
{
    orr_schema bare = schema; // without the check for orbits or a trajectory
    bare.check = NULL;
    const orr_yaml empty = {0};
    return of_tree(&bare, &empty, NULL, leap, out, diag);
}

static orr_status out_of_memory(orr_scenario *out, orr_diag *diag)
{
    orr_scenario_free(out);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

orr_status orr_scenario_of_product(const char *path, const orr_leap_table *leap, orr_scenario *out,
                                   orr_diag *diag)
{
    orr_status s = defaults(leap, out, diag);
    if (s != ORR_OK) return s;
    out->orbit.product = strdup(path);
    return out->orbit.product != NULL ? ORR_OK : out_of_memory(out, diag);
}

static bool keep_text(const char *text, char **out)
{
    if (text == NULL) return true;
    *out = strdup(text);
    return *out != NULL;
}

static bool keep_texts(const char *const *text, size_t n, orr_text_list *out)
{
    if (n == 0) return true;
    out->item = calloc(n, sizeof *out->item);
    for (out->n = 0; out->item != NULL && out->n < n; out->n++)
        if ((out->item[out->n] = strdup(text[out->n])) == NULL) return false;
    return out->item != NULL;
}

orr_status orr_scenario_of_replay(const orr_scenario_replay_files *f, const orr_leap_table *leap,
                                  orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    const orr_status s = defaults(leap, out, diag);
    if (s != ORR_OK) return s;
    out->has_replay = true;
    out->replay.estimate_position = true;
    out->replay.residuals = !f->no_residuals;
    out->replay.has_from = f->from != ORR_TIME_NONE;
    out->replay.from = f->from;
    out->replay.has_to = f->to != ORR_TIME_NONE;
    out->replay.to = f->to;
    return keep_text(f->observations, &out->replay.observations) && keep_text(f->sinex, &out->replay.sinex) &&
                   keep_text(f->station, &out->replay.station) && keep_text(f->field, &out->iono.field) &&
                   keep_text(f->antex, &out->channel.antex) && keep_text(f->bias, &out->channel.bias) &&
                   keep_text(f->product, &out->orbit.product) &&
                   keep_texts(f->sp3, f->n_sp3, &out->orbit.sp3) &&
                   keep_texts(f->clk, f->n_clk, &out->orbit.clk) &&
                   keep_texts(f->erp, f->n_erp, &out->orbit.erp) &&
                   keep_texts(f->nav, f->n_nav, &out->orbit.nav)
               ? ORR_OK
               : out_of_memory(out, diag);
}

orr_status orr_scenario_of_telemetry(const char *const *file, const char *const *columns, size_t n,
                                     const orr_leap_table *leap, orr_scenario *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (n < 1 || n > ORR_TRAJECTORY_MAX_LOGS)
        return orr_diag_set(diag, ORR_E_ARG,
                            "telemetry comes in one file or two (places and angles), not in %zu", n);
    orr_status s = defaults(leap, out, diag);
    if (s != ORR_OK) return s;
    orr_scenario_trajectory *t = &out->motion.trajectory;
    t->kind = ORR_MOTION_TELEMETRY;
    t->logs.item = calloc(n, sizeof *t->logs.item);
    if (t->logs.item == NULL) return out_of_memory(out, diag);
    for (t->logs.n = 0; t->logs.n < n;) {
        const size_t k = t->logs.n++;
        t->logs.item[k].file = strdup(file[k]);
        t->logs.item[k].columns = columns[k] != NULL ? strdup(columns[k]) : NULL;
        if (t->logs.item[k].file == NULL || (columns[k] != NULL && t->logs.item[k].columns == NULL))
            return out_of_memory(out, diag);
    }
    return ORR_OK;
}

void orr_scenario_free(orr_scenario *s)
{
    orr_marks_free(&s->marks);
    orr_schema_free(&schema, s);
}
