// SPDX-License-Identifier: GPL-3.0-or-later
// One arc of the reference fit: a first state from two nodes, the integrated orbit with its partial
// derivatives, and normal equations in which nodes that disagree have no weight. Room-internal.
#ifndef ORR_ORBIT_DYNAMICS_REFERENCE_ARC_H
#define ORR_ORBIT_DYNAMICS_REFERENCE_ARC_H

#include "orbit/dynamics/reference_fit.h"
#include "orbit/dynamics/rotation_knots.h"

enum {
    ORR_ARC_STATE = 6 + ORR_ECOM_TERMS,                // position, velocity, ECOM
    ORR_ARC_UNKNOWNS = ORR_ARC_STATE + ORR_KNOT_LOCAL, // and the rotation's knots that it touches
};

// Of unknowns of which each node's coordinate is worth ORR_ARC_SIGMA_M: A'A, A'l (priors of ECOM included)
// and l'l.
typedef struct orr_arc_equations {
    double N[ORR_ARC_UNKNOWNS][ORR_ARC_UNKNOWNS], r[ORR_ARC_UNKNOWNS], ll;
    size_t n; // nodes used
} orr_arc_equations;

#define ORR_ARC_SIGMA_M 0.02

// What a worker has for itself.
typedef struct orr_arc_room {
    orr_force force; // with the arc's ECOM
    orr_integrator *integrator;
    const orr_sky *sky;
    const orr_rotation_knots *knots;
    size_t most_nodes;
    double now_s, forget_s; // a node before now_s weighs less by e for every forget_s; 0: all weigh the same
    double (*row)[3][ORR_ARC_UNKNOWNS + 1]; // per node; the last is what was measured less what was computed
    double *length, *weight, *sort, *square;
} orr_arc_room;

// Allocates what a worker needs.
// Given:
//   sky         positions of Sun and Moon, turn of the Earth; borrowed
//   knots       corrections of the Earth's rotation; borrowed
//   earth       gravity field
//   most_nodes  of an arc
// Returned:
//   room        free with orr_arc_room_free
// Errors: ORR_E_MEMORY.
orr_status orr_arc_room_init(const orr_sky *sky, const orr_rotation_knots *knots,
                             const orr_gravity_field *earth, size_t most_nodes, orr_arc_room *room,
                             orr_diag *diag);
// Frees what orr_arc_room_init allocated.
void orr_arc_room_free(orr_arc_room *room);

// A state at the arc's first node that passes through two nodes and near those after them; false if there is
// none.
bool orr_arc_start(orr_arc_room *room, orr_reference_arc *arc);
// Integrates the arc and fills the equations; ORR_E_NUMERIC if the orbit leaves sense.
orr_status orr_arc_equations_make(orr_arc_room *room, orr_reference_arc *arc, orr_arc_equations *out);

#endif
