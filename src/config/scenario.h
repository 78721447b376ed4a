// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario file: what one run of the service is made of. docs/scenario.md explains it; the table in
// scenario.c is its schema. A new section is members here and rows there.
#ifndef ORR_CONFIG_SCENARIO_H
#define ORR_CONFIG_SCENARIO_H

#include "src/config/motion.h"
#include "src/config/schema.h"

typedef struct orr_scenario_orbit {
    char *product;     // an orbit product (NetCDF)
    orr_text_list sp3; // or SP3 files, smoothed at start
    // Earth rotation parameters for the smoothing; none: a secular pole, UT1 by the leap seconds
    orr_text_list erp;
    double nodes_s; // keep only epochs that are multiples of it; 0: all
    orr_interval_list exclude;
} orr_scenario_orbit;

typedef struct orr_scenario_iono {
    char *field;   // IONEX maps, Bernese coefficients, or a navigation file (Klobuchar)
    char *session; // or a session made by 'orrery iono'
    int64_t seed;  // of the noise where the session's station saw nothing
    bool noise;
} orr_scenario_iono;

typedef enum orr_navdata_window { ORR_NAVDATA_2H, ORR_NAVDATA_4H, ORR_NAVDATA_NONE } orr_navdata_window;

typedef struct orr_scenario_navdata {
    int window; // orr_navdata_window
    char *antex, *bias;
    orr_text_list nav;
    bool zero_clocks;
} orr_scenario_navdata;

typedef struct orr_scenario {
    char *title;
    orr_scenario_orbit orbit;
    orr_scenario_navdata navdata;
    orr_scenario_iono iono;
    orr_scenario_motion motion;
    orr_real_list receiver; // geodetic latitude and longitude in degrees, ellipsoidal height in metres; or
    int64_t receiver_unit;  // the inertial unit whose point it is, where there is a trajectory
    orr_text_list listen;   // URLs of serve.listen
} orr_scenario;

const orr_schema *orr_scenario_schema(void);

// Reads and checks a scenario. Paths in it are relative to its folder. Errors: ORR_E_IO, ORR_E_FORMAT and
// ORR_E_KIND with line, column and path, ORR_E_LIMIT, ORR_E_MEMORY. Free with orr_scenario_free.
orr_status orr_scenario_read(const char *path, orr_scenario *out, orr_diag *diag);
// The same from memory; files are relative to `folder`.
orr_status orr_scenario_parse(const char *name, const char *text, size_t n, const char *folder,
                              orr_scenario *out, orr_diag *diag);
// A product alone, the rest as the table's defaults have it.
orr_status orr_scenario_of_product(const char *path, orr_scenario *out, orr_diag *diag);
void orr_scenario_free(orr_scenario *s);

#endif
