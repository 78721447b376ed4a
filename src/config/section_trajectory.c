// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_trajectory.h"

#include "src/config/rows_private.h"

// Conditions on the kind of the map that a row stands in, and on what goes with it.
#define OF_KIND(words_)                                                                                      \
    {                                                                                                        \
        {.key = "kind", .words = words_}, { 0 }                                                              \
    }
static const orr_condition of_survey[] = OF_KIND("survey");
static const orr_condition of_waypoints[] = OF_KIND("waypoints");
static const orr_condition of_phases[] = OF_KIND("phases");
static const orr_condition of_speeds[] = OF_KIND("waypoints|phases");
static const orr_condition of_lead[] = OF_KIND("survey|phases");
static const orr_condition of_rest[] = OF_KIND("rest|straight|taxi");
static const orr_condition of_run[] = OF_KIND("straight|taxi");
static const orr_condition of_speed[] = OF_KIND("straight|taxi|takeoff|landing");
static const orr_condition of_taxi[] = OF_KIND("taxi");
static const orr_condition of_turn[] = OF_KIND("turn");
static const orr_condition of_climb[] = OF_KIND("climb|landing");
static const orr_condition of_place[] = OF_KIND("to|survey");
static const orr_condition of_to[] = OF_KIND("to");
static const orr_condition of_lines[] = OF_KIND("survey");
static const orr_condition of_telemetry[] = OF_KIND("telemetry");
static const orr_condition of_analytic[] = OF_KIND("analytic");
static const orr_condition of_plan[] = OF_KIND("survey|waypoints|phases");
static const orr_condition of_origin[] = OF_KIND("survey|phases|analytic");
static const orr_condition of_orbit[] = OF_KIND("orbit");
static const orr_condition of_orbit_product[] = {{.key = "kind", .words = "orbit"}, {.key = "product"}, {0}};
static const orr_condition of_orbit_elements[] = {
    {.key = "kind", .words = "orbit"}, {.key = "product", .absent = true}, {0}};
static const orr_condition of_circle[] = OF_KIND("circle");
static const orr_condition of_eight[] = OF_KIND("eight");
static const orr_condition of_sine[] = OF_KIND("sine");
static const orr_condition of_vector[] = OF_KIND("straight|sine");
static const orr_condition of_periodic[] = OF_KIND("circle|eight|sine");
static const orr_condition of_turned[] = OF_KIND("circle|eight");
static const orr_condition of_phased[] = OF_KIND("eight|sine");

static const orr_choice kinds[] = {ORR_MOTION_KINDS(ORR_CHOICE_WORD){0}};
static const orr_choice sides[] = {ORR_SURVEY_SIDES(ORR_CHOICE_WORD){0}};
static const orr_choice degrees[] = {ORR_FIT_DEGREES(ORR_CHOICE_WORD){0}};
static const orr_choice phase_kinds[] = {ORR_PHASE_KINDS(ORR_CHOICE_WORD){0}};
static const orr_choice transfer_attitudes[] = {ORR_TRANSFER_ATTITUDES(ORR_CHOICE_WORD){0}};
static const orr_choice term_kinds[] = {ORR_TERM_KINDS(ORR_CHOICE_WORD){0}};

// --- survey ---
#define SURVEY_REAL(n, m, lo, hi, u, dflt, of, h) REAL_ROW(orr_scenario_survey, n, m, lo, hi, u, dflt, of, h)
static const orr_condition of_several[] = {{.key = "lines", .least = 2}, {0}};
static const orr_condition of_ties[] = {{.key = "tie_lines", .least = 1}, {0}};

static const orr_key survey_rows[] = {
    SURVEY_REAL("azimuth", azimuth_deg, -360, 360, "deg", "0", NULL,
                "direction of the first line, clockwise from North"),
    SURVEY_REAL("length", length_m, 1, 2e6, "m", "30000", NULL, "length of a line"),
    SURVEY_REAL("spacing", spacing_m, 0, 1e6, "m", "2000", of_several, "distance between lines"),
    INT_ROW(orr_scenario_survey, "lines", lines, 1, 500, "6", NULL, "number of lines"),
    CHOICE_ROW(orr_scenario_survey, "side", side, sides, "right", of_several,
               "side of the first line on which the others lie"),
    INT_ROW(orr_scenario_survey, "tie_lines", tie_lines, 0, 500, "0", NULL, "number of lines across"),
    SURVEY_REAL("tie_spacing", tie_spacing_m, 1, 1e6, "m", "10000", of_ties, "distance between tie lines"),
};
static const orr_schema survey_table = ORR_SCHEMA(survey_rows, orr_scenario_survey);

// --- phases ---
#define PHASE_REAL(n, m, lo, hi, u, dflt, of, h) REAL_ROW(orr_scenario_phase, n, m, lo, hi, u, dflt, of, h)

static const orr_key phase_rows[] = {
    NEEDED_CHOICE_ROW(orr_scenario_phase, "kind", kind, phase_kinds, NULL, "what the body does"),
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_scenario_phase, duration_ns),
     .only = of_rest,
     .help = "how long; straight and taxi: instead of the length"},
    PHASE_REAL("length", length_m, 0, 2e6, "m", "0", of_run, "how far, a change of speed included"),
    PHASE_REAL("speed", speed_mps, 0, 3000, "m/s", "0", of_speed,
               "speed to reach; 0: as before (takeoff: that of the trajectory; taxi from rest: 8)"),
    BOOL_ROW(orr_scenario_phase, "stop", stop, "no", of_taxi, "whether it ends at rest"),
    NEEDED_REAL_ROW(orr_scenario_phase, "angle", angle_deg, -3600, 3600, "deg", of_turn,
                    "how far to turn, to the right; to the left negative"),
    PHASE_REAL("radius", radius_m, 0, 1e6, "m", "0", of_turn, "of the arc; 0: from the bank"),
    NEEDED_REAL_ROW(orr_scenario_phase, "height", height_m, -10000, 1000000, "m", of_climb,
                    "height above the ellipsoid to reach, of the ground where it lands"),
    PHASE_REAL("rate", rate_mps, 0, 500, "m/s", "0", of_climb,
               "vertical speed; 0: the trajectory's steepest climb"),
    NEEDED_REAL_ROW(orr_scenario_phase, "lat", lat_deg, -90, 90, "deg", of_place,
                    "latitude of the place, of the begin of the first line"),
    NEEDED_REAL_ROW(orr_scenario_phase, "lon", lon_deg, -360, 360, "deg", of_place, "its longitude"),
    PHASE_REAL("azimuth", azimuth_deg, -360, 360, "deg", "0", of_to,
               "course at the place, clockwise from North"),
    MAP_ROW(orr_scenario_phase, "survey", survey, &survey_table, of_lines, "lines of the survey"),
};

static const char *check_phase(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_phase *p = map;
    bool run = p->kind == ORR_PHASE_WORD_STRAIGHT || p->kind == ORR_PHASE_WORD_TAXI;
    if (p->kind == ORR_PHASE_WORD_REST && p->duration_ns <= 0) {
        snprintf(why, ORR_SCHEMA_WHY, "a rest needs a duration");
        return "duration";
    }
    if (!run || (p->duration_ns > 0) != (p->length_m > 0)) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "it needs a length or a duration, one of them");
    return "length";
}

static const orr_schema phase_table = {.key = phase_rows,
                                       .n = sizeof phase_rows / sizeof phase_rows[0],
                                       .size = sizeof(orr_scenario_phase),
                                       .check = check_phase};

// --- waypoints ---
static const orr_key waypoint_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_waypoint, "lat", lat_deg, -90, 90, "deg", NULL, "latitude of the place"),
    NEEDED_REAL_ROW(orr_scenario_waypoint, "lon", lon_deg, -360, 360, "deg", NULL, "its longitude"),
    REAL_ROW(orr_scenario_waypoint, "height", height_m, -10000, 1000000, "m", "0", NULL,
             "its height above the ellipsoid"),
    REAL_ROW(orr_scenario_waypoint, "speed", speed_mps, 0, 3000, "m/s", "0", NULL,
             "speed from there on; 0: as before"),
};
static const orr_schema waypoint_table = ORR_SCHEMA(waypoint_rows, orr_scenario_waypoint);

// --- turbulence and oscillation ---
#define SPECTRUM_REAL(n, m, lo, hi, u, dflt, h)                                                              \
    REAL_ROW(orr_scenario_spectrum, n, m, lo, hi, u, dflt, NULL, h)

static const orr_key spectrum_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_spectrum, "rms", rms, 1e-9, 1000, "m/s or deg", NULL,
                    "root mean square: of the turbulent velocity in m/s (each of East, North, Up), of an "
                    "angle in deg"),
    SPECTRUM_REAL("low", low_hz, 1e-6, 100, "Hz", "0.02", "lowest frequency"),
    SPECTRUM_REAL("high", high_hz, 1e-6, 100, "Hz", "0.3", "highest frequency"),
    SPECTRUM_REAL("slope", slope, -10, 10, NULL, "-1.667",
                  "power spectral density goes as frequency to this power"),
};

static const char *check_spectrum(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_spectrum *s = map;
    if (!(s->rms > 0) || s->low_hz < s->high_hz) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "the lowest frequency, %g Hz, is not below the highest, %g Hz", s->low_hz,
             s->high_hz);
    return "";
}

static const orr_schema spectrum_table = {.key = spectrum_rows,
                                          .n = sizeof spectrum_rows / sizeof spectrum_rows[0],
                                          .size = sizeof(orr_scenario_spectrum),
                                          .check = check_spectrum};

static const orr_key oscillation_rows[] = {
    MAP_ROW(struct orr_scenario_oscillation, "heading", heading, &spectrum_table, NULL, "of the heading"),
    MAP_ROW(struct orr_scenario_oscillation, "pitch", pitch, &spectrum_table, NULL, "of the pitch"),
    MAP_ROW(struct orr_scenario_oscillation, "roll", roll, &spectrum_table, NULL, "of the roll"),
};
static const orr_schema oscillation_table = ORR_SCHEMA(oscillation_rows, struct orr_scenario_oscillation);

// --- telemetry ---
static const orr_key log_rows[] = {
    {.name = "file",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_scenario_log, file),
     .help = "log of a flight"},
    TEXT_ROW(orr_scenario_log, "columns", columns, NULL,
             "its columns, e.g. \"-,t[ms],roll,pitch,heading\", where the file does not say so itself"),
};
static const orr_schema log_table = ORR_SCHEMA(log_rows, orr_scenario_log);

static const orr_key fit_rows[] = {
    CHOICE_ROW(orr_scenario_fit, "degree", degree, degrees, "3", NULL, "degree of the smoothing splines"),
    REAL_ROW(orr_scenario_fit, "position_per_knot", position_per_knot, 0, 1000, NULL, "0", NULL,
             "samples of a place per knot; 0: for a knot a second"),
    REAL_ROW(orr_scenario_fit, "attitude_per_knot", attitude_per_knot, 0, 1000, NULL, "0", NULL,
             "samples of attitude per knot; 0: for a knot every 0.2 s"),
    {.name = "max_gap",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_scenario_fit, max_gap_ns),
     .fallback = "10",
     .help = "longer gaps split the log; the longest segment is used"},
};
static const orr_schema fit_table = ORR_SCHEMA(fit_rows, orr_scenario_fit);

// --- analytic ---
static const orr_key body_rows[] = {
    REAL_ROW(orr_scenario_body, "heading", heading_deg, -360, 360, "deg", "0", NULL,
             "heading, or what is added to the course"),
    REAL_ROW(orr_scenario_body, "pitch", pitch_deg, -90, 90, "deg", "0", NULL, "pitch of the body"),
    REAL_ROW(orr_scenario_body, "roll", roll_deg, -180, 180, "deg", "0", NULL, "roll of the body"),
    BOOL_ROW(orr_scenario_body, "follow_course", follow_course, "no", NULL,
             "whether the heading follows the course"),
};
static const orr_schema body_table = ORR_SCHEMA(body_rows, orr_scenario_body);

#define TERM_REAL(n, m, lo, hi, u, dflt, of, h) REAL_ROW(orr_scenario_term, n, m, lo, hi, u, dflt, of, h)

static const orr_key term_rows[] = {
    NEEDED_CHOICE_ROW(orr_scenario_term, "kind", kind, term_kinds, NULL, "kind of motion"),
    TERM_REAL("east", east, 0, 0, "m/s or m", "0", of_vector,
              "straight: velocity East; sine: amplitude East"),
    TERM_REAL("north", north, 0, 0, "m/s or m", "0", of_vector, "the same for North"),
    TERM_REAL("up", up, 0, 0, "m/s or m", "0", of_vector, "the same for Up"),
    TERM_REAL("radius", radius_m, 0, 1e6, "m", "1000", of_circle, "radius about the origin"),
    TERM_REAL("period", period_s, 0.001, 1e6, "s", "100", of_periodic, "period"),
    TERM_REAL("azimuth", azimuth_deg, -360, 360, "deg", "0", of_turned,
              "circle: of its first place; eight: of its long axis"),
    TERM_REAL("along", along_m, 0, 1e6, "m", "1000", of_eight, "amplitude along the axis"),
    TERM_REAL("across", across_m, 0, 1e6, "m", "500", of_eight, "amplitude across it"),
    TERM_REAL("heading", heading_deg, -360, 360, "deg", "0", of_sine, "amplitude of the heading"),
    TERM_REAL("pitch", pitch_deg, -360, 360, "deg", "0", of_sine, "amplitude of the pitch"),
    TERM_REAL("roll", roll_deg, -360, 360, "deg", "0", of_sine, "amplitude of the roll"),
    TERM_REAL("phase", phase_deg, -360, 360, "deg", "0", of_phased, "phase at the start"),
    BOOL_ROW(orr_scenario_term, "counter_clockwise", counter_clockwise, "no", of_circle, "seen from above"),
};
static const orr_schema term_table = ORR_SCHEMA(term_rows, orr_scenario_term);

// --- transfer ---
static const orr_key transfer_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_transfer, "lat", lat_deg, -90, 90, "deg", NULL,
                    "latitude that the trajectory's middle comes to"),
    NEEDED_REAL_ROW(orr_scenario_transfer, "lon", lon_deg, -360, 360, "deg", NULL, "its longitude"),
    REAL_ROW(orr_scenario_transfer, "azimuth", azimuth_deg, -360, 360, "deg", "0", NULL,
             "turn about the middle, clockwise"),
    CHOICE_ROW(orr_scenario_transfer, "attitude", attitude, transfer_attitudes, "level", NULL,
               "what the attitude keeps"),
};
static const orr_schema transfer_table = ORR_SCHEMA(transfer_rows, orr_scenario_transfer);

static const orr_key wave_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_wave, "amplitude", amplitude_m, 0, 10000, "m", NULL, "of the height"),
    NEEDED_REAL_ROW(orr_scenario_wave, "wavelength", wavelength_m, 1, 1e6, "m", NULL, "from crest to crest"),
    REAL_ROW(orr_scenario_wave, "azimuth", azimuth_deg, -360, 360, "deg", "0", NULL,
             "direction across the crests, clockwise from North"),
    REAL_ROW(orr_scenario_wave, "phase", phase_deg, -360, 360, "deg", "0", NULL, "at the begin of the plan"),
};
static const orr_schema wave_table = ORR_SCHEMA(wave_rows, orr_scenario_wave);

// --- orbit ---
static const orr_key element_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_elements, "semimajor_axis", semimajor_axis_m, 6.5e6, 5e8, "m", NULL,
                    "semi-major axis"),
    REAL_ROW(orr_scenario_elements, "eccentricity", eccentricity, 0, 0.95, NULL, "0", NULL, "eccentricity"),
    NEEDED_REAL_ROW(orr_scenario_elements, "inclination", inclination_deg, 0, 180, "deg", NULL,
                    "inclination to the true equator of date"),
    REAL_ROW(orr_scenario_elements, "node", node_deg, -360, 360, "deg", "0", NULL,
             "right ascension of the ascending node from the true equinox of date"),
    REAL_ROW(orr_scenario_elements, "perigee", perigee_deg, -360, 360, "deg", "0", NULL,
             "argument of the perigee"),
    REAL_ROW(orr_scenario_elements, "mean_anomaly", mean_anomaly_deg, -360, 360, "deg", "0", NULL,
             "mean anomaly at the start"),
};

static const char *check_elements(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_elements *e = map;
    const double perigee_m = e->semimajor_axis_m * (1 - e->eccentricity);
    if (e->semimajor_axis_m == 0 || perigee_m > 6.5e6) return NULL;
    snprintf(why, ORR_SCHEMA_WHY,
             "the perigee is %.0f km from the Earth's centre; an orbit has at least 6500 km",
             perigee_m / 1e3);
    return "eccentricity";
}

static const orr_schema elements_table = {.key = element_rows,
                                          .n = sizeof element_rows / sizeof element_rows[0],
                                          .size = sizeof(orr_scenario_elements),
                                          .check = check_elements};

// --- the section ---
#define ROW_REAL(n, m, lo, hi, u, dflt, of, h) REAL_ROW(orr_scenario_trajectory, n, m, lo, hi, u, dflt, of, h)
static const orr_condition of_random[] = {
    {.key = "kind", .words = "survey|waypoints|phases"}, {.key = "turbulence|oscillation"}, {0}};

static const orr_key rows[] = {
    NEEDED_CHOICE_ROW(orr_scenario_trajectory, "kind", kind, kinds, NULL, "where the motion comes from"),
    {.name = "start",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_trajectory, start),
     .given = offsetof(orr_scenario_trajectory, has_start),
     .help = "instant of the trajectory's begin. Default: that of the log's clock; else the begin of the "
             "orbits; else 2024-02-04"},
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_scenario_trajectory, duration_ns),
     .help =
         "length of time. Default: the whole plan, log or orbit; an analytic motion and elements need it"},
    NEEDED_REAL_ROW(orr_scenario_trajectory, "lat", lat_deg, -90, 90, "deg", of_origin,
                    "latitude of the begin of the first line or phase, or of the origin"),
    NEEDED_REAL_ROW(orr_scenario_trajectory, "lon", lon_deg, -360, 360, "deg", of_origin, "its longitude"),
    ROW_REAL("height", height_m, -10000, 1000000, "m", "0", of_origin, "its height above the ellipsoid"),
    MAP_ROW(orr_scenario_trajectory, "survey", survey, &survey_table, of_survey, "lines of the survey"),
    {.name = "waypoints",
     .kind = ORR_KEY_MAP,
     .list = true,
     .required = true,
     .offset = offsetof(orr_scenario_trajectory, waypoints),
     .least = 2,
     .most = ORR_TRAJECTORY_MAX_WAYPOINTS,
     .map = &waypoint_table,
     .only = of_waypoints,
     .help = "the places, in their order"},
    {.name = "phases",
     .kind = ORR_KEY_MAP,
     .list = true,
     .required = true,
     .offset = offsetof(orr_scenario_trajectory, phases),
     .least = 1,
     .most = ORR_TRAJECTORY_MAX_PHASES,
     .map = &phase_table,
     .only = of_phases,
     .help = "what the body does, in order; it begins on the ground if the first is a rest, taxi or takeoff, "
             "else in the "
             "air at the speed below"},
    ROW_REAL("azimuth", azimuth_deg, -360, 360, "deg", "0", of_phases,
             "course at the begin, clockwise from North"),
    ROW_REAL("speed", speed_mps, 0.01, 3000, "m/s", "60", of_plan, "speed over the ground"),
    ROW_REAL("bank", bank_deg, 0.1, 80, "deg", "20", of_plan,
             "bank of turns, which sets their radius; the steepest bank where turn_radius is given"),
    ROW_REAL("turn_radius", turn_radius_m, 0, 1e6, "m", "0", of_plan, "radius of turns; 0: from the bank"),
    ROW_REAL("climb", climb_mps, 0.01, 500, "m/s", "5", of_speeds, "steepest climb and descent"),
    ROW_REAL("acceleration", acceleration_mps2, 0.01, 100, "m/s2", "2", of_speeds,
             "greatest acceleration along the way, where speeds change"),
    ROW_REAL("lead", lead_m, 0, 1e5, "m", "1000", of_lead, "straight flight before and after each line"),
    ROW_REAL("smoothing", smoothing_s, 0, 60, "s", "2.5", of_plan, "time in which turns and climbs set in"),
    ROW_REAL("pitch", pitch_deg, -45, 45, "deg", "0", of_plan, "pitch of level flight"),
    ROW_REAL("knots", knots_s, 0.001, 10, "s", "0.5", of_plan, "knot step of the spline through the plan"),
    MAP_ROW(orr_scenario_trajectory, "turbulence", turbulence, &spectrum_table, of_plan,
            "random velocity of the air"),
    MAP_ROW(orr_scenario_trajectory, "oscillation", oscillation, &oscillation_table, of_plan,
            "random oscillation of the attitude"),
    MAPS_ROW(orr_scenario_trajectory, "drape", drape, &wave_table, 16, of_plan,
             "waves of the terrain, which heights and pitch of the plan follow"),
    INT_ROW(orr_scenario_trajectory, "seed", seed, 0, 9e15, "1", of_random, "of turbulence and oscillation"),
    {.name = "telemetry",
     .kind = ORR_KEY_MAP,
     .list = true,
     .required = true,
     .offset = offsetof(orr_scenario_trajectory, logs),
     .least = 1,
     .most = ORR_TRAJECTORY_MAX_LOGS,
     .map = &log_table,
     .only = of_telemetry,
     .help = "logs on one clock: one with everything, or places in one and angles in the other"},
    MAP_ROW(orr_scenario_trajectory, "fit", fit, &fit_table, of_telemetry,
            "how splines are laid through the log"),
    MAP_ROW(orr_scenario_trajectory, "body", body, &body_table, of_analytic, "attitude of the body"),
    MAPS_ROW(orr_scenario_trajectory, "motions", terms, &term_table, ORR_TRAJECTORY_MAX_TERMS, of_analytic,
             "motions that are summed; none is rest"),
    FILE_ROW(orr_scenario_trajectory, "product", product, of_orbit,
             "orbit product made by 'orrery orbit' that has the satellite; without it, elements"),
    {.name = "sat",
     .kind = ORR_KEY_TEXT,
     .required = true,
     .offset = offsetof(orr_scenario_trajectory, sat),
     .only = of_orbit_product,
     .help = "the satellite of the product that the receiver is on, e.g. L51"},
    {.name = "elements",
     .kind = ORR_KEY_MAP,
     .required = true,
     .offset = offsetof(orr_scenario_trajectory, elements),
     .given = offsetof(orr_scenario_trajectory, has_elements),
     .map = &elements_table,
     .only = of_orbit_elements,
     .help = "Kepler elements at the start, carried on by gravitation of Earth, Sun and Moon"},
    {.name = "transfer",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario_trajectory, transfer),
     .given = offsetof(orr_scenario_trajectory, has_transfer),
     .map = &transfer_table,
     .help = "carries the whole trajectory to another place, over a pole for instance; a made gravity "
             "disturbance goes with it"},
};

const orr_schema orr_section_trajectory = ORR_SCHEMA(rows, orr_scenario_trajectory);
