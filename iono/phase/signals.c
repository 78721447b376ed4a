// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/signals.h"

#include <string.h>

#include "iono/field/pierce.h"

typedef struct band {
    char system, band;
    double mhz;
    const char *attributes; // best first
} band;

// RINEX 3.05, tables 4 to 11; ICDs for the frequencies.
static const band BANDS[] = {
    {'G', '1', 1575.42, "CWPXSLYM"}, {'G', '2', 1227.60, "WXLSPDCYM"}, {'G', '5', 1176.45, "QXI"},
    {'R', '1', 1602.0, "CP"},        {'R', '2', 1246.0, "CP"},         {'R', '3', 1202.025, "QXI"},
    {'R', '4', 1600.995, "ABX"},     {'R', '6', 1248.06, "ABX"},       {'E', '1', 1575.42, "CXBAZ"},
    {'E', '5', 1176.45, "QXI"},      {'E', '7', 1207.14, "QXI"},       {'E', '8', 1191.795, "QXI"},
    {'E', '6', 1278.75, "CXBAZ"},    {'C', '2', 1561.098, "IQX"},      {'C', '1', 1575.42, "PXDSLZA"},
    {'C', '5', 1176.45, "PXD"},      {'C', '7', 1207.14, "IQXDPZ"},    {'C', '8', 1191.795, "DPX"},
    {'C', '6', 1268.52, "IQXDPZA"},  {'J', '1', 1575.42, "CXSLZEB"},   {'J', '2', 1227.60, "XLS"},
    {'J', '5', 1176.45, "QXIDPZ"},   {'J', '6', 1278.75, "SLXEZ"},     {'I', '5', 1176.45, "ABCX"},
    {'I', '9', 2492.028, "ABCX"},    {'I', '1', 1575.42, "DPX"},       {'S', '1', 1575.42, "C"},
    {'S', '5', 1176.45, "IQX"},
};

static const band *find(char system, char b)
{
    for (size_t i = 0; i < sizeof BANDS / sizeof *BANDS; i++)
        if (BANDS[i].system == system && BANDS[i].band == b) return &BANDS[i];
    return NULL;
}

double orr_signal_frequency_hz(char system, const char *code, int glonass_channel, double rinex_version)
{
    const band *b = find(system, code[1]);
    if (b == NULL) return 0;
    double mhz = b->mhz;
    if (system == 'R' && b->band == '1') mhz += 0.5625 * glonass_channel;
    if (system == 'R' && b->band == '2') mhz += 0.4375 * glonass_channel;
    // 3.02 called B1I band 1; its attributes I and Q were never B1C's.
    if (system == 'C' && b->band == '1' &&
        (code[2] == 'I' || code[2] == 'Q' || (code[2] == 'X' && rinex_version < 3.025)))
        mhz = 1561.098;
    return mhz * 1e6;
}

int orr_signal_rank(char system, char band_char, char attribute)
{
    const band *b = find(system, band_char);
    if (b == NULL || attribute == '\0') return -1;
    const char *at = strchr(b->attributes, attribute);
    if (at != NULL) return (int)(at - b->attributes);
    return system == 'C' && band_char == '1' && (attribute == 'I' || attribute == 'Q') ? 0 : -1;
}

const char *orr_signal_band_pairs(char system)
{
    switch (system) {
    case 'G':
        return "1215";
    case 'R':
        return "1246";
    case 'E':
        return "15171816";
    case 'C':
        return "26271615121765";
    case 'J':
        return "1215";
    case 'I':
        return "9515";
    case 'S':
        return "15";
    default:
        return "";
    }
}

double orr_tecu_per_metre(double f1_hz, double f2_hz)
{
    return f1_hz * f1_hz * f2_hz * f2_hz / (ORR_IONO_K_M3_PER_S2 * (f1_hz * f1_hz - f2_hz * f2_hz));
}
