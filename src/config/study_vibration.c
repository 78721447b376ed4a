// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_vibration.h"

#include "src/config/rows_private.h"

static const orr_key method_rows[] = {
    {.name = "name",
     .kind = ORR_KEY_TEXT,
     .required = true,
     .offset = offsetof(orr_study_method, name),
     .help = "its name in tables, 31 letters at most"},
    {.name = "samples",
     .kind = ORR_KEY_INT,
     .required = true,
     .offset = offsetof(orr_study_method, samples),
     .min = 1,
     .max = 8,
     .help = "increments of a group, N"},
    {.name = "coefficients",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_study_method, coefficients),
     .help =
         "N - 1 of (k1 d1 + k2 d2 + ..) x dN, or N (N - 1) / 2 of the pairs d1 x d2, d1 x d3 .. d2 x d3 .."},
};
static const orr_schema method_table = ORR_SCHEMA(method_rows, orr_study_method);

static const orr_key ratio_rows[] = {
    REAL_ROW(orr_study_ratios, "low", low, 1e-4, 1e4, NULL, "0.01", NULL, "lowest f_v / f_m"),
    REAL_ROW(orr_study_ratios, "high", high, 1e-4, 1e4, NULL, "10", NULL, "highest"),
    INT_ROW(orr_study_ratios, "points", points, 2, 10000, "200", NULL,
            "ratios between, in equal steps of logarithm"),
    REALS_ROW(orr_study_ratios, "also", also, NULL, NULL, "ratios besides"),
};
static const char *check_ratios(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_ratios *r = map;
    if (!(r->high > r->low)) {
        snprintf(why, ORR_SCHEMA_WHY, "%g is not above low, %g", r->high, r->low);
        return "high";
    }
    for (size_t k = 0; k < r->also.n; k++)
        if (!(r->also.item[k] > 0)) {
            snprintf(why, ORR_SCHEMA_WHY, "%g is no ratio of frequencies", r->also.item[k]);
            return "also";
        }
    return NULL;
}
static const orr_schema ratio_table = {.key = ratio_rows,
                                       .n = sizeof ratio_rows / sizeof ratio_rows[0],
                                       .size = sizeof(orr_study_ratios),
                                       .check = check_ratios};

static const orr_key place_rows[] = {
    NEEDED_REAL_ROW(orr_study_place, "lat", lat_deg, -90, 90, "deg", NULL, "latitude"),
    REAL_ROW(orr_study_place, "lon", lon_deg, -360, 360, "deg", "0", NULL, "longitude"),
    REAL_ROW(orr_study_place, "height", height_m, -1000, 100000, "m", "0", NULL, "above the ellipsoid"),
    REAL_ROW(orr_study_place, "heading", heading_deg, -360, 360, "deg", "0", NULL, "clockwise from North"),
    REAL_ROW(orr_study_place, "pitch", pitch_deg, -90, 90, "deg", "0", NULL, "nose up"),
    REAL_ROW(orr_study_place, "roll", roll_deg, -180, 180, "deg", "0", NULL, "right side down"),
};
static const orr_schema place_table = ORR_SCHEMA(place_rows, orr_study_place);

static const orr_key spectrum_rows[] = {
    {.name = "file",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_spectrum, file),
     .help =
         "table of frequency, Hz, and one-sided density of the rate about each of axes 1 and 2, (deg/s)2/Hz"},
    REAL_ROW(orr_study_spectrum, "coherence", coherence, -1, 1, NULL, "1", NULL,
             "part of axis 2 that follows axis 1 by a quarter of a period; 1 is a cone, which is the worst"),
    INT_ROW(orr_study_spectrum, "runs", runs, 0, 1000, "3", NULL, "runs on made vibration of this density"),
    {.name = "run",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_spectrum, run_ns),
     .unit = "s",
     .fallback = "2",
     .help = "length of such a run"},
};
static const orr_schema spectrum_table = ORR_SCHEMA(spectrum_rows, orr_study_spectrum);

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_vibration),
    REAL_ROW(orr_study_vibration, "readings", readings_hz, 0.01, 1e6, "Hz", "100", NULL,
             "rate of the gyros' readings, f_m"),
    {.name = "products",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_study_vibration, products),
     .min = 1e-12,
     .max = 10,
     .unit = "rad2/s",
     .fallback = "1e-5",
     .help = "f_v beta^2, constant through a sweep"},
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_vibration, duration_ns),
     .unit = "s",
     .fallback = "2",
     .help = "length of a run"},
    MAP_ROW(orr_study_vibration, "ratios", ratios, &ratio_table, NULL, "f_v / f_m of the sweep"),
    {.name = "methods",
     .kind = ORR_KEY_TEXT,
     .list = true,
     .offset = offsetof(orr_study_vibration, methods),
     .help = "1-step .. 5-step (coefficients made for coning), polynomial-3 .. polynomial-5, iteration-4, "
             "iteration-8, or all alone; "
             "without this and own: 1-step, 2-step and 4-step"},
    MAPS_ROW(orr_study_vibration, "own", own, &method_table, 20, NULL, "methods by their coefficients"),
    {.name = "rest",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_study_vibration, rest),
     .given = offsetof(orr_study_vibration, has_rest),
     .map = &place_table,
     .help = "rest readings with the Earth's rate and gravity at a place; without, the body vibrates in "
             "inertial axes"},
    {.name = "spectrum",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_study_vibration, spectrum),
     .given = offsetof(orr_study_vibration, has_spectrum),
     .map = &spectrum_table,
     .help = "broadband vibration besides"},
};
const orr_schema orr_study_vibration_schema = {.key = rows,
                                               .n = sizeof rows / sizeof rows[0],
                                               .size = sizeof(orr_study_vibration),
                                               .hint = "'orrery vibration --help-study' lists all"};
