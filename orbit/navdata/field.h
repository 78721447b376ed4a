// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of navigation messages: how a value is sent as a whole number of LSBs. Fits end on them, encoders write them.
// Private to the room.
#ifndef ORR_ORBIT_NAVDATA_FIELD_H
#define ORR_ORBIT_NAVDATA_FIELD_H

#include <math.h>

#include "core/constants.h"
#include "core/status.h"

#define P2(n) (1.0 / (double)(UINT64_C(1) << (n))) // 2^-n, the LSBs of interface documents
#define SEMICIRCLE ORR_PI

// So many LSBs. Zero has no sign: the -0 that a rounded -0.3 is would be shown as "-0".
static inline double orr_navfit_lsbs(double whole, double lsb) { return whole * lsb + 0.0; }

// A field as the interface documents define it: what is sent stands for base + whole * lsb.
typedef struct orr_navfit_field {
    const char *name;
    double lsb;
    int bits;
    // Two's complement, none, two's complement of what may turn over, sign and magnitude (GLONASS).
    enum { ORR_FIELD_SIGNED, ORR_FIELD_UNSIGNED, ORR_FIELD_ANGLE, ORR_FIELD_MAGNITUDE } kind;
    double base;
} orr_navfit_field;
// Fields without a base.
#define ORR_SIGNED(name, lsb, bits)                                                                          \
    {                                                                                                        \
        name, lsb, bits, ORR_FIELD_SIGNED, 0                                                                 \
    }
#define ORR_UNSIGNED(name, lsb, bits)                                                                        \
    {                                                                                                        \
        name, lsb, bits, ORR_FIELD_UNSIGNED, 0                                                               \
    }
#define ORR_ANGLE(name, power, bits)                                                                         \
    {                                                                                                        \
        name, SEMICIRCLE *P2(power), bits, ORR_FIELD_ANGLE, 0                                                \
    }
#define ORR_MAGNITUDE(name, lsb, bits)                                                                       \
    {                                                                                                        \
        name, lsb, bits, ORR_FIELD_MAGNITUDE, 0                                                              \
    }

// The whole number of LSBs nearest to a value.
static inline double orr_navfit_whole(const orr_navfit_field *f, double value)
{
    return round((value - f->base) / f->lsb);
}
// The value that `whole` LSBs (a whole number) stand for; ORR_E_RANGE with the name where the field cannot hold them.
orr_status orr_navfit_to_field(const orr_navfit_field *f, double whole, double *value, orr_diag *diag);
// The nearest value that a field can hold, its ends included.
double orr_navfit_clamped(const orr_navfit_field *f, double value);

// Klobuchar's coefficients alpha0..3 and beta0..3 (IS-GPS-200N table 20-X).
extern const orr_navfit_field orr_nav_klobuchar_fields[8];

// The index of an accuracy in metres, as GPS, QZSS, BeiDou and NavIC send it, 0 (2.4 m and below) to 15 (above 6144 m, or not
// known). (IS-GPS-200N 20.3.3.3.1.3; BDS-SIS-ICD-B1I 3.0, 5.2.4.5; IRNSS SIS ICD 1.1, 6.2.1.4.)
int orr_nav_ura_index(double accuracy_m);
// Galileo's: 0 to 125 in steps of 1, 2, 4 and 16 cm; 255 where none is predicted (OS SIS ICD 2.1, table 89).
int orr_nav_sisa_index(double accuracy_m);

#endif
