// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_channel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/signal.h"
#include "src/config/rows_private.h"

// --- signals ---
const char *orr_section_signals_check(const orr_text_list *signals, char why[ORR_SCHEMA_WHY])
{
    for (size_t k = 0; k < signals->n; k++) {
        uint64_t set = 0;
        orr_diag d = {0};
        if (orr_signal_parse(signals->item[k], &set, &d) == ORR_OK) continue;
        snprintf(why, ORR_SCHEMA_WHY, "%.*s", ORR_SCHEMA_WHY - 1, d.text);
        return "signals";
    }
    return NULL;
}

// --- troposphere ---
static const orr_choice models[] = {ORR_TROPOSPHERES(ORR_CHOICE_WORD){0}};
static const orr_choice mappings[] = {ORR_TROPO_MAPPINGS(ORR_CHOICE_WORD){0}};
static const orr_choice gradients[] = {ORR_TROPO_GRADIENTS(ORR_CHOICE_WORD){0}};
static const orr_condition of_weather[] = {{.key = "model", .words = "saastamoinen"}, {0}};
static const orr_condition of_some[] = {{.key = "model", .words = "saastamoinen|do229|stanag4294|gpt3|vmf3"},
                                        {0}};
static const orr_condition of_given[] = {{.key = "gradients", .words = "given"}, {0}};
static const orr_condition of_files[] = {{.key = "files"}, {0}};

#define GRADIENT_ROW(n, m, h)                                                                                \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .list = true, .offset = offsetof(orr_scenario_troposphere, m),      \
        .min = -50, .max = 50, .least = 2, .most = 2, .unit = "mm", .only = of_given, .help = h              \
    }
static const orr_key turbulence_rows[] = {
    REAL_ROW(orr_scenario_turbulence, "strength", strength, 1e-9, 1e-5, "m^(-1/3)", "2.4e-7", NULL,
             "C of the structure function C^2 r^(2/3) of refractivity; 2.4e-7 is Treuhaft and Lanyi's mean "
             "of middle latitudes"),
    REAL_ROW(orr_scenario_turbulence, "height", height_m, 100, 5000, "m", "2000", NULL,
             "thickness of the layer on the ground"),
    REAL_ROW(orr_scenario_turbulence, "speed", speed_mps, 0, 60, "m/s", "8", NULL,
             "of the wind that carries it"),
    REAL_ROW(orr_scenario_turbulence, "azimuth", azimuth_deg, 0, 360, "deg", "90", NULL,
             "where the wind goes"),
    INT_ROW(orr_scenario_turbulence, "seed", seed, 0, 9e15, "1", NULL, "of the random field"),
};
static const orr_schema turbulence_table = ORR_SCHEMA(turbulence_rows, orr_scenario_turbulence);
static const orr_key troposphere_rows[] = {
    CHOICE_ROW(orr_scenario_troposphere, "model", model, models, "saastamoinen", NULL, "zenith delays"),
    CHOICE_ROW(orr_scenario_troposphere, "mapping", mapping, mappings, "niell", of_some,
               "how they grow towards the horizon"),
    REAL_ROW(orr_scenario_troposphere, "humidity", humidity, 0, 1, NULL, "0.7", of_weather,
             "relative humidity of the standard atmosphere"),
    FILE_ROW(orr_scenario_troposphere, "grid", grid, of_some,
             "grid of GPT3: gpt3_5.grd or gpt3_1.grd of TU Wien"),
    FILES_ROW(orr_scenario_troposphere, "files", files, of_some,
              "files of VMF3 around the scenario's time: grids (VMF3_YYYYMMDD.Hhh, V3GR_YYYYMMDD.Hhh), or "
              "files of stations "
              "(*.vmf3_g, *.v3gr_g and likewise _r and _d) that know every antenna by its name"),
    FILE_ROW(orr_scenario_troposphere, "orography", orography, of_files,
             "heights of the points of files that are grids: orography_ell_5x5 or orography_ell_1x1"),
    CHOICE_ROW(orr_scenario_troposphere, "gradients", gradients, gradients, "none", of_some,
               "horizontal gradients"),
    GRADIENT_ROW("gradient_hydrostatic", gradient_hydrostatic_mm,
                 "hydrostatic gradient to the North and to the East"),
    GRADIENT_ROW("gradient_wet", gradient_wet_mm, "wet gradient to the North and to the East"),
    {.name = "turbulence",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario_troposphere, turbulence),
     .given = offsetof(orr_scenario_troposphere, has_turbulence),
     .map = &turbulence_table,
     .only = of_some,
     .help = "turbulence of water vapour: a random field of wet delay that the wind carries"},
};

// A key that needs another, which is not there.
static const char *lacks(bool wants, bool has, const char *key, const char *what, const char *other,
                         char why[ORR_SCHEMA_WHY])
{
    if (!wants || has) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%s needs %s", what, other);
    return key;
}
static const char *check_troposphere(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_troposphere *s = map;
    const bool grid = s->grid != NULL, files = s->files.n > 0;
    const bool of_data = s->model == ORR_TROPOSPHERE_GPT3 || s->model == ORR_TROPOSPHERE_VMF3;
    const bool vmf3 =
        s->mapping == ORR_TROPO_MAPPING_VMF3 || (of_data && s->mapping == ORR_TROPO_MAPPING_OWN);
    const char *bad = lacks(s->model == ORR_TROPOSPHERE_GPT3, grid, "model", "gpt3", "troposphere.grid", why);
    if (bad == NULL)
        bad = lacks(s->model == ORR_TROPOSPHERE_VMF3, files, "model", "vmf3", "troposphere.files", why);
    if (bad == NULL)
        bad = lacks(vmf3, grid || files, "mapping", "VMF3", "troposphere.grid or troposphere.files", why);
    if (bad == NULL)
        bad = lacks(s->gradients == ORR_GRADIENTS_GRID, grid, "gradients", "grid", "troposphere.grid", why);
    if (bad == NULL)
        bad =
            lacks(s->gradients == ORR_GRADIENTS_FILES, files, "gradients", "files", "troposphere.files", why);
    if (bad != NULL) return bad;
    if (files && s->model != ORR_TROPOSPHERE_VMF3 && !vmf3 && s->gradients != ORR_GRADIENTS_FILES) {
        snprintf(why, ORR_SCHEMA_WHY, "model, mapping or gradients have to take something of them");
        return "files";
    }
    if (grid && s->model != ORR_TROPOSPHERE_GPT3 && !(vmf3 && !files) && s->gradients != ORR_GRADIENTS_GRID) {
        snprintf(why, ORR_SCHEMA_WHY, "model, mapping or gradients have to take something of it");
        return "grid";
    }
    return NULL;
}
const orr_schema orr_section_troposphere = {.key = troposphere_rows,
                                            .n = sizeof troposphere_rows / sizeof troposphere_rows[0],
                                            .size = sizeof(orr_scenario_troposphere),
                                            .check = check_troposphere};

// --- antennas ---
static const orr_condition fixed[] = {{.key = "position"}, {0}};
static const orr_condition moving[] = {{.key = "position", .absent = true}, {.key = "../trajectory"}, {0}};

#define ANTENNA_REAL(n, m, of, h) REAL_ROW(orr_scenario_antenna, n, m, -1000, 1000, "m", "0", of, h)
static const orr_key antenna_rows[] = {
    TEXT_ROW(orr_scenario_antenna, "name", name, NULL,
             "what the antenna is called; names of files begin with it"),
    TEXT_ROW(orr_scenario_antenna, "type", type, NULL,
             "antenna and radome as ANTEX files write them, e.g. \"TRM59800.00     NONE\": offsets and "
             "variations of its "
             "phase centres. Without it the phase centre is the reference point"),
    {.name = "position",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_antenna, position),
     .min = -500000,
     .max = 500000,
     .least = 3,
     .most = 3,
     .help =
         "of a fixed antenna: latitude and longitude of its marker in degrees (geodetic), height above the "
         "ellipsoid in metres. Without it the antenna is on the trajectory's body"},
    ANTENNA_REAL("height", height_m, fixed, "height of the antenna reference point above the marker"),
    ANTENNA_REAL("east", east_m, fixed, "its offset to the East"),
    ANTENNA_REAL("north", north_m, fixed, "its offset to the North"),
    {.name = "unit",
     .kind = ORR_KEY_INT,
     .offset = offsetof(orr_scenario_antenna, unit),
     .given = offsetof(orr_scenario_antenna, has_unit),
     .min = 0,
     .max = 15,
     .fallback = "0",
     .only = moving,
     .help = "the inertial unit that the lever arm begins at; 0 is the trajectory's own point"},
    ANTENNA_REAL("right", right_m, moving, "lever arm to the antenna reference point, to the right"),
    ANTENNA_REAL("forward", forward_m, moving, "lever arm, forward"),
    ANTENNA_REAL("up", up_m, moving, "lever arm, up"),
};

// No ground lies as low: the shore of the Dead Sea is 410 m below the ellipsoid, the geoid 107 m at most.
#define LOWEST_GROUND_M (-500.0)

static const char *check_antenna(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_antenna *a = map;
    const orr_real_list *p = &a->position;
    if (a->name != NULL) { // files are called by it
        const size_t n = strlen(a->name);
        if (n == 0 || n > ORR_ANTENNA_NAME || a->name[0] == '.' ||
            strcspn(a->name, "/\\\"*?<>| ,\t\n") != n) {
            snprintf(why, ORR_SCHEMA_WHY,
                     "'%s' is no name for files: 1 to %d characters, none of / \\ \" * ? < > | , or space, "
                     "no dot in "
                     "front",
                     a->name, ORR_ANTENNA_NAME);
            return "name";
        }
    }
    if (p->n == 0) return NULL;
    if (!(fabs(p->item[0]) <= 90 && fabs(p->item[1]) <= 360)) {
        snprintf(why, ORR_SCHEMA_WHY, "latitude %g, longitude %g is no place", p->item[0], p->item[1]);
        return "position";
    }
    if (p->item[2] + a->height_m >= LOWEST_GROUND_M) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "a height of %g m above the ellipsoid is below ground",
             p->item[2] + a->height_m);
    return "position";
}
const orr_schema orr_section_antenna = {.key = antenna_rows,
                                        .n = sizeof antenna_rows / sizeof antenna_rows[0],
                                        .size = sizeof(orr_scenario_antenna),
                                        .check = check_antenna};

// --- satellites ---
#define SATS_ROW(n, m, given_, h)                                                                            \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_SATS, .offset = offsetof(orr_scenario_satellites, m), .given = given_,    \
        .help = h                                                                                            \
    }
static const orr_key power_rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .required = true,
     .offset = offsetof(orr_scenario_power, sats),
     .help = "satellites, e.g. G05,E"},
    NEEDED_REAL_ROW(orr_scenario_power, "db", db, -60, 30, "dB", NULL,
                    "added to the power of all their signals"),
};
static const orr_schema power_table = ORR_SCHEMA(power_rows, orr_scenario_power);
static const orr_key satellite_rows[] = {
    SATS_ROW("use", use, offsetof(orr_scenario_satellites, has_use),
             "satellites that send; all of the orbits by default"),
    SATS_ROW("exclude", exclude, 0, "satellites that are switched off"),
    SATS_ROW("unhealthy", unhealthy, 0,
             "satellites that send and are marked as not to be used: in their channels, and by the health of "
             "their broadcast data and almanacs"),
    FILE_ROW(
        orr_scenario_satellites, "metadata", metadata, NULL,
        "IGS satellite metadata (igs_satellite_metadata.snx): transmit power against the mean of the block, "
        "space "
        "vehicles and blocks where ANTEX lacks them, GLONASS' channels where no navigation file tells them"),
    MAPS_ROW(orr_scenario_satellites, "power", power, &power_table, 100, NULL,
             "more or less power than nominal"),
};
const orr_schema orr_section_satellites = ORR_SCHEMA(satellite_rows, orr_scenario_satellites);

// --- mask ---
static const orr_key obstacle_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_obstacle, "azimuth", azimuth_deg, 0, 360, "deg", NULL,
                    "azimuth, clockwise from North"),
    NEEDED_REAL_ROW(orr_scenario_obstacle, "elevation", elevation_deg, -90, 90, "deg", NULL,
                    "nothing is seen below this elevation there"),
};
static const orr_schema obstacle_table = ORR_SCHEMA(obstacle_rows, orr_scenario_obstacle);
static const orr_condition on_body[] = {{.key = "../trajectory", .why = "nothing moves"}, {0}};
static const orr_key mask_rows[] = {
    REAL_ROW(orr_scenario_mask, "elevation", elevation_deg, -90, 90, "deg", "5", NULL,
             "satellites below this elevation have no channel; -90: what the Earth does not hide, from space "
             "its air counted in (100 km)"),
    MAPS_ROW(orr_scenario_mask, "horizon", horizon, &obstacle_table, 720, NULL,
             "obstacles by ascending azimuth, linear between, closed over North"),
    {.name = "body",
     .kind = ORR_KEY_REAL,
     .offset = offsetof(orr_scenario_mask, body_deg),
     .given = offsetof(orr_scenario_mask, has_body),
     .min = -90,
     .max = 90,
     .unit = "deg",
     .only = on_body,
     .help = "least angle above the plane of an antenna on the body; default: the body hides nothing"},
};
static const char *check_mask(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_mask *m = map;
    for (size_t k = 1; k < m->horizon.n; k++)
        if (!(m->horizon.item[k].azimuth_deg > m->horizon.item[k - 1].azimuth_deg)) {
            snprintf(why, ORR_SCHEMA_WHY, "azimuth %g does not come after %g", m->horizon.item[k].azimuth_deg,
                     m->horizon.item[k - 1].azimuth_deg);
            return "horizon";
        }
    return NULL;
}
const orr_schema orr_section_mask = {.key = mask_rows,
                                     .n = sizeof mask_rows / sizeof mask_rows[0],
                                     .size = sizeof(orr_scenario_mask),
                                     .check = check_mask};

// --- channel ---
static const orr_condition no_antex[] = {
    {.key = "../navdata.antex", .absent = true, .why = "channels take the same file"}, {0}};
static const orr_condition no_bias[] = {
    {.key = "../navdata.bias", .absent = true, .why = "channels take the same file"}, {0}};
static const orr_choice holes[] = {ORR_CLOCK_HOLES(ORR_CHOICE_WORD){0}};
static const orr_condition with_ionosphere[] = {{.key = "../ionosphere", .why = "there is no ionosphere"},
                                                {0}};
static const orr_condition of_second_order[] = {{.key = "second_order", .words = "yes"}, {0}};
static const orr_key lobe_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_lobe, "nadir", nadir_deg, 5, 180, "deg", NULL,
                    "angle from the satellite's nadir"),
    NEEDED_REAL_ROW(orr_scenario_lobe, "gain", gain_db, -100, 20, "dB", NULL,
                    "gain there above that at the Earth's limb"),
};
static const orr_schema lobe_table = ORR_SCHEMA(lobe_rows, orr_scenario_lobe);

static const char *check_channel(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_lobes *l = &((const orr_scenario_channel *)map)->side_lobes;
    for (size_t k = 1; k < l->n; k++)
        if (!(l->item[k].nadir_deg > l->item[k - 1].nadir_deg)) {
            snprintf(why, ORR_SCHEMA_WHY, "the angle %g does not come after %g", l->item[k].nadir_deg,
                     l->item[k - 1].nadir_deg);
            return "side_lobes";
        }
    return NULL;
}

static const orr_key channel_rows[] = {
    REAL_ROW(orr_scenario_channel, "error_m", error_m, 1e-9, 1, "m", "1e-5", NULL,
             "greatest error of a block's cubics against the motion; blocks are as long as it allows"),
    BOOL_ROW(orr_scenario_channel, "shapiro", shapiro, "yes", NULL,
             "relativistic delay of the signal in the Earth's field"),
    BOOL_ROW(orr_scenario_channel, "relativity", relativity, "yes", NULL,
             "periodic relativity of the satellites' clocks, -2 r.v/c^2"),
    BOOL_ROW(orr_scenario_channel, "windup", windup, "yes", NULL, "phase wind-up of the carrier"),
    BOOL_ROW(orr_scenario_channel, "second_order", second_order, "no", with_ionosphere,
             "second order of the ionosphere's delay, by the Earth's magnetic field: centimetres of a code, "
             "half of it, early, of "
             "a carrier"),
    TEXT_ROW(orr_scenario_channel, "magnetic", magnetic, of_second_order,
             "GeographicLib's model of that field, e.g. igrf14 or wmm2025 (geographiclib-get-magnetic "
             "installs them); default: the "
             "dipole of IGRF-13"),
    FILE_ROW(orr_scenario_channel, "antex", antex, no_antex,
             "ANTEX file of satellites' and receivers' antennas; default: navdata.antex"),
    FILE_ROW(orr_scenario_channel, "bias", bias, no_bias,
             "Bias-SINEX or DCB file of satellites' group delays; default: navdata.bias; without either they "
             "are zero"),
    CHOICE_ROW(orr_scenario_channel, "clock_holes", clock_holes, holes, "drop", NULL,
               "what a satellite sends where the orbits have no clock for it"),
    MAPS_ROW(orr_scenario_channel, "side_lobes", side_lobes, &lobe_table, 90, NULL,
             "gain of the satellites' antennas beyond the Earth's limb, for receivers in space: by ascending "
             "angle from nadir, "
             "linear between, from 0 dB at the limb on, the last one held; default: 3 dB less a degree, to "
             "20 dB less"),
};
const orr_schema orr_section_channel = {.key = channel_rows,
                                        .n = sizeof channel_rows / sizeof channel_rows[0],
                                        .size = sizeof(orr_scenario_channel),
                                        .check = check_channel};
