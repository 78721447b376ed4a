// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of what an antenna receives: `signals`, `troposphere`, `antennas`, `satellites`, `mask` and `channel`.
#ifndef ORR_CONFIG_SECTION_CHANNEL_H
#define ORR_CONFIG_SECTION_CHANNEL_H

#include "src/config/schema.h"

#define ORR_TROPOSPHERES(X)                                                                                  \
    X(ORR_TROPOSPHERE_SAASTAMOINEN, "saastamoinen",                                                          \
      "Saastamoinen (1972) on a standard atmosphere, as RTKLIB and most receivers have it")                  \
    X(ORR_TROPOSPHERE_DO229, "do229",                                                                        \
      "RTCA DO-229E, A.4.2.4: by latitude and season; SBAS receivers use it")                                \
    X(ORR_TROPOSPHERE_STANAG4294, "stanag4294", "STANAG 4294: three exponential layers")                     \
    X(ORR_TROPOSPHERE_GPT3, "gpt3",                                                                          \
      "GPT3 (Landskron and Boehm 2018): pressure and water vapour of its grid by place, height and day of "  \
      "year; Saastamoinen's hydrostatic delay, Askne and Nordius' wet one")                                  \
    X(ORR_TROPOSPHERE_VMF3, "vmf3", "zenith delays of VMF3's files, of a grid or of stations")               \
    X(ORR_TROPOSPHERE_NONE, "none", "no troposphere")
typedef enum orr_troposphere_model { ORR_TROPOSPHERES(ORR_CHOICE_VALUE) } orr_troposphere_model;

#define ORR_TROPO_MAPPINGS(X)                                                                                \
    X(ORR_TROPO_MAPPING_NIELL, "niell", "Niell (1996), apart for the hydrostatic and the wet delay")         \
    X(ORR_TROPO_MAPPING_GMF, "gmf",                                                                          \
      "Global Mapping Function (Boehm et al. 2006), by place and season, as the IERS Conventions have it")   \
    X(ORR_TROPO_MAPPING_VMF3, "vmf3",                                                                        \
      "Vienna Mapping Functions 3 (Landskron and Boehm 2018), their first coefficients by "                  \
      "troposphere.files "                                                                                   \
      "or, without these, by the grid of GPT3")                                                              \
    X(ORR_TROPO_MAPPING_OWN, "own",                                                                          \
      "what receivers use with the model: 1/sin(elevation) with saastamoinen, Black and Eisner with do229, " \
      "Chao with stanag4294, VMF3 with gpt3 and vmf3")
typedef enum orr_tropo_mapping { ORR_TROPO_MAPPINGS(ORR_CHOICE_VALUE) } orr_tropo_mapping;

#define ORR_TROPO_GRADIENTS(X)                                                                               \
    X(ORR_GRADIENTS_NONE, "none", "none: the same delay all around")                                         \
    X(ORR_GRADIENTS_GIVEN, "given", "constants")                                                             \
    X(ORR_GRADIENTS_GRID, "grid", "those of GPT3's grid")                                                    \
    X(ORR_GRADIENTS_FILES, "files", "those of troposphere.files (V3GR)")
typedef enum orr_tropo_gradients { ORR_TROPO_GRADIENTS(ORR_CHOICE_VALUE) } orr_tropo_gradients;

// Turbulence of water vapour.
typedef struct orr_scenario_turbulence {
    double strength;               // C of refractivity's structure function C^2 r^(2/3), m^(-1/3)
    double height_m;               // of the layer
    double speed_mps, azimuth_deg; // of the wind: where it goes
    int64_t seed;
} orr_scenario_turbulence;

typedef struct orr_scenario_troposphere {
    int model, mapping; // orr_troposphere_model, orr_tropo_mapping
    double humidity;    // relative, 0 to 1; of saastamoinen
    char *grid;         // GPT3's
    orr_text_list files;
    char *orography;                                        // heights of the points of files that are grids
    int gradients;                                          // orr_tropo_gradients
    orr_real_list gradient_hydrostatic_mm, gradient_wet_mm; // north and east
    orr_scenario_turbulence turbulence;
    bool has_turbulence;
} orr_scenario_troposphere;

#define ORR_MAX_ANTENNAS 16
#define ORR_ANTENNA_NAME 59 // characters of a name at most: RINEX has 60 for a marker
typedef struct orr_scenario_antenna {
    char *name, *type; // type and radome as ANTEX files have them; NULL: phase centre at the reference point
    orr_real_list
        position; // fixed: latitude and longitude in degrees, ellipsoidal height in metres, of the marker
    double north_m, east_m, height_m; // fixed: antenna reference point from the marker
    bool has_unit;
    int64_t unit; // on the body: from the point of this unit, along the body's axes
    double right_m, forward_m, up_m;
} orr_scenario_antenna;
typedef struct orr_scenario_antennas {
    size_t n;
    orr_scenario_antenna *item;
} orr_scenario_antennas;

typedef struct orr_scenario_power {
    orr_sat_set sats;
    double db;
} orr_scenario_power;
typedef struct orr_scenario_satellites {
    orr_sat_set use, exclude, unhealthy;
    bool has_use;
    char *metadata; // IGS satellite metadata file
    struct {
        size_t n;
        orr_scenario_power *item;
    } power;
} orr_scenario_satellites;

typedef struct orr_scenario_obstacle {
    double azimuth_deg, elevation_deg;
} orr_scenario_obstacle;
typedef struct orr_scenario_mask {
    double elevation_deg;
    struct {
        size_t n;
        orr_scenario_obstacle *item;
    } horizon; // elevations by azimuth, ascending, linear between, closed over North
    bool has_body;
    double body_deg; // least angle above the antenna's own plane
} orr_scenario_mask;

#define ORR_CLOCK_HOLES(X)                                                                                   \
    X(ORR_CLOCK_HOLE_DROP, "drop", "no channel where the product has no clock")                              \
    X(ORR_CLOCK_HOLE_ZERO, "zero", "a clock of zero there, flagged: for orbits without clocks")
typedef enum orr_clock_hole { ORR_CLOCK_HOLES(ORR_CHOICE_VALUE) } orr_clock_hole;

typedef struct orr_scenario_lobe {
    double nadir_deg, gain_db;
} orr_scenario_lobe;
typedef struct
    orr_scenario_lobes { // beyond the Earth's limb: dB above the gain at it, by ascending angle from nadir
    size_t n;
    orr_scenario_lobe *item;
} orr_scenario_lobes;

typedef struct orr_scenario_channel {
    double error_m;
    orr_scenario_lobes side_lobes;
    bool shapiro, relativity, windup, second_order;
    char *magnetic;     // GeographicLib's model of the magnetic field for the second order; NULL: a dipole
    char *antex, *bias; // NULL: those of navdata
    int clock_holes;    // orr_clock_hole
} orr_scenario_channel;

extern const orr_schema orr_section_troposphere, orr_section_antenna, orr_section_satellites,
    orr_section_mask, orr_section_channel;

// Why a list of signals' texts cannot be (as ORR_SCHEMA_WHY), NULL where it can.
const char *orr_section_signals_check(const orr_text_list *signals, char why[ORR_SCHEMA_WHY]);

#endif
