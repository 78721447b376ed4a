// SPDX-License-Identifier: GPL-3.0-or-later
// A station's observations, a TEC field, positions of satellites and options to a fused session of delays: what
// `orrery iono` writes. Each input is read once.
#ifndef ORR_MAKE_STATION_H
#define ORR_MAKE_STATION_H

#include "iono/field/tec_files.h"
#include "iono/fusion/session.h"
#include "src/make/positions.h"

// The field and the satellites' positions, which the stations of a day have in common: opened once for all of them.
typedef struct orr_station_shared {
    orr_tec_field *field;        // NULL: none
    orr_bias_set bias;           // of the field's file, where it is IONEX
    orr_positions *positions;    // NULL: none
    int8_t glonass_channel[100]; // as the navigation files among them tell
    orr_inputs inputs;           // provenance
} orr_station_shared;

typedef struct orr_station_plan {
    const char *observations;
    const char *field; // NULL: none (phases alone)
    const char *orbit; // an orbit product or a navigation file; NULL: none (phases alone)
    const orr_station_shared *
        shared; // both, opened before, and `field` and `orbit` are not read; NULL: they are read. Outlives the station
    orr_position_fn
        position;      // positions that the caller has, before those of `orbit` and `shared`; NULL: none
    void *user;        // of position
    uint32_t messages; // of that file to insist on (orr_broadcast_choice.messages); 0: the usual ones
    const char *const *biases; // files of code biases; those of an IONEX field are used besides
    size_t n_biases;
    const char *antex; // phase centres of the satellites' antennas; NULL: none
    bool has_site;     // the station's position (ecef); else by `sinex`, else the header's
    orr_vec3 site_m;
    const char *sinex; // NULL: none
    const char *code;  // the station's name there; NULL: the first four characters of the observations' name
    orr_phase_options phase; // site_m, position, user and shell_radius_m are set by orr_station_open
    orr_tec_options tec;
    orr_fusion_options fusion;
} orr_station_plan;
// Defaults of all options, no files.
orr_station_plan orr_station_plan_default(void);

typedef struct orr_station {
    const orr_station_plan *plan; // borrowed
    orr_phase_options options;    // of phases, completed
    orr_vec3 site_m;
    int8_t glonass_channel[100]; // as the navigation files tell them
    orr_bytes observations;      // as they were read
    orr_station_shared own;      // field and positions where plan->shared has none
    orr_positions *positions;    // borrowed from them
    orr_tec_field *field;        // of them; NULL once the session has it
    orr_bias_set bias;           // of all files, joined
    orr_antex antex;
    orr_phase_tec phase;
    orr_fusion fusion;
    orr_session session;
    orr_inputs inputs; // provenance
} orr_station;

// Opens what plan->field and plan->orbit name, with plan->tec and plan->messages.
// Given:
//   plan      files and options
// Returned:
//   out       field and positions; free with orr_station_shared_free whatever this returned
//   warnings  of the readers; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of the readers.
orr_status orr_station_share(const orr_station_plan *plan, orr_station_shared *out, orr_warnings *warnings,
                             orr_diag *diag);
// Frees all of it; it is zero then.
void orr_station_shared_free(orr_station_shared *x);

// Reads everything, then the phases. Errors: those of the readers and of orr_phase_tec_make; ORR_E_NODATA (no such station in `sinex`). Free with orr_station_free whatever it returned.
orr_status orr_station_open(const orr_station_plan *plan, orr_station *out, orr_warnings *warnings,
                            orr_diag *diag);
// Frees all that a station holds; it is zero then.
void orr_station_free(orr_station *s);

// Phases of another station's file, at the position of its header, with the same options.
// Given:
//   s         an open station
//   path      observations of the other
// Returned:
//   out       its phases; free with orr_phase_tec_free
//   warnings  of the reader; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of orr_phase_tec_make.
orr_status orr_station_other(const orr_station *s, const char *path, orr_phase_tec *out,
                             orr_warnings *warnings, orr_diag *diag);

// Fuses phases and field into s->fusion. Errors: those of orr_fuse.
orr_status orr_station_fuse(orr_station *s, orr_warnings *warnings, orr_diag *diag);
// Makes a session of phases and fusion, which takes the field over, in s->session. Errors: those of orr_session_make.
orr_status orr_station_session(orr_station *s, orr_diag *diag);
// Writes the session with its provenance.
orr_status orr_station_save(const orr_station *s, const char *path, const char *history, orr_diag *diag);

#endif
