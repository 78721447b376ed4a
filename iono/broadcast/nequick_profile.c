// SPDX-License-Identifier: GPL-3.0-or-later
// NeQuick-G over a point: modip, ionisation level, critical frequencies, peaks and thicknesses of the layers.
#include <math.h>
#include <string.h>

#include "iono/broadcast/nequick_private.h"

#define HM_E_KM 120.0
#define SUN_NIGHT_DEG 86.23292796211615 // zenith angle of the Sun between day and night

// (27): exp without overflow.
static double clipped_exp(double x) { return x > 80 ? 5.5406e34 : x < -80 ? 1.8049e-35 : exp(x); }

// (28): from f2 to f1 as x grows past 0.
static double joined(double f1, double f2, double alpha, double x)
{
    const double e = clipped_exp(alpha * x);
    return (f1 * e + f2) / (e + 1);
}

// (29): an Epstein layer of amplitude x and thickness z about y, at w.
static double epstein(double x, double y, double z, double w)
{
    const double e = clipped_exp((w - y) / z);
    return x * e / ((1 + e) * (1 + e));
}

// (128): third-order interpolation of four equidistant values between the second and the third.
static double between(const double z[4], double x)
{
    if (fabs(2 * x) < 1e-10) return z[1];
    const double d = 2 * x - 1, g1 = z[2] + z[1], g2 = z[2] - z[1], g3 = z[3] + z[0], g4 = (z[3] - z[0]) / 3;
    const double a0 = 9 * g1 - g3, a1 = 9 * g2 - g4, a2 = g3 - g1, a3 = g4 - g2;
    return (a0 + d * (a1 + d * (a2 + d * a3))) / 16;
}

double neq_modip_deg(const orr_nequick *n, double lat_deg, double lon_deg)
{
    const double lat = fmin(fmax(lat_deg, -90), 90), lon = lon_deg - 360 * floor((lon_deg + 180) / 360);
    const double p = (lat + 95) / 5, q = (lon + 190) / 10;
    int i = (int)floor(p), k = (int)floor(q);
    if (i > NEQ_MODIP - 3) i = NEQ_MODIP - 3; // the pole is the end of the last interval
    if (k > NEQ_MODIP - 3) k = NEQ_MODIP - 3;
    double column[4];
    for (int c = 0; c < 4; c++) {
        double rows[4];
        for (int r = 0; r < 4; r++) rows[r] = n->modip_deg[i - 1 + r][k - 1 + c];
        column[c] = between(rows, p - i);
    }
    return between(column, q - k);
}

double neq_ionisation(const double ai[3], double modip_deg)
{
    if (ai[0] == 0 && ai[1] == 0 && ai[2] == 0) return 63.7;
    return fmin(fmax(ai[0] + modip_deg * (ai[1] + modip_deg * ai[2]), 0), 400);
}

// (48)-(51): a row of a table at the hour, by its diurnal series.
static double diurnal(const double *row, int terms, double ut_h)
{
    const double t = (15 * ut_h - 180) * ORR_RAD_PER_DEG;
    double sum = row[0];
    for (int k = 1; 2 * k < terms; k++) sum += row[2 * k - 1] * sin(k * t) + row[2 * k] * cos(k * t);
    return sum;
}

void neq_epoch_init(const orr_nequick *n, int month, double ut_h, double az, neq_epoch *out)
{
    *out = (neq_epoch){.tables = n, .month = month, .ut_h = ut_h, .az = az};
    out->azr = sqrt(167273 + (az - 63.7) * 1123.6) - 408.99; // (19)
    // (20)-(25): the Sun's declination in the middle of the month.
    const double day = 30.5 * month - 15, t = day + (18 - ut_h) / 24;
    const double anomaly = (0.9856 * t - 3.289) * ORR_RAD_PER_DEG;
    const double sun =
        anomaly + (1.916 * sin(anomaly) + 0.020 * sin(2 * anomaly) + 282.634) * ORR_RAD_PER_DEG;
    out->sin_sun = 0.39782 * sin(sun);
    out->cos_sun = sqrt(1 - out->sin_sun * out->sin_sun);
    const neq_month *m = &n->month[month - 1];
    const double high = out->azr / 100, low = 1 - high; // (45), (46)
    for (int i = 0; i < NEQ_F2_ROWS; i++)
        out->f2[i] =
            low * diurnal(m->f2[0][i], NEQ_F2_TERMS, ut_h) + high * diurnal(m->f2[1][i], NEQ_F2_TERMS, ut_h);
    for (int i = 0; i < NEQ_M3_ROWS; i++)
        out->m3[i] =
            low * diurnal(m->m3[0][i], NEQ_M3_TERMS, ut_h) + high * diurnal(m->m3[1][i], NEQ_M3_TERMS, ut_h);
}

// (53)-(74): a spatial series; count[n] powers of sin modip in the harmonics of order n.
static double spatial(const double *c, const int *count, int orders, double modip_deg, double lat_deg,
                      double lon_deg)
{
    const double s = sin(modip_deg * ORR_RAD_PER_DEG), b = cos(lat_deg * ORR_RAD_PER_DEG);
    double sum = 0, power = 1, cos_power = 1;
    for (int k = 0; k < count[0]; k++, power *= s) sum += *c++ * power;
    for (int n = 1; n < orders; n++) {
        cos_power *= b;
        const double l = n * lon_deg * ORR_RAD_PER_DEG, cl = cos(l) * cos_power, sl = sin(l) * cos_power;
        power = 1;
        for (int k = 0; k < count[n]; k++, power *= s, c += 2) sum += (c[0] * cl + c[1] * sl) * power;
    }
    return sum;
}

// (30)-(37): the critical frequency of the E layer, MHz.
static double critical_e(const neq_epoch *e, double lat_deg, double lon_deg)
{
    const double lat = lat_deg * ORR_RAD_PER_DEG, hour = (12 - e->ut_h - lon_deg / 15) * ORR_PI / 12;
    const double c = sin(lat) * e->sin_sun + cos(lat) * e->cos_sun * cos(hour);
    const double zenith = atan2(sqrt(fmax(1 - c * c, 0)), c) * ORR_DEG_PER_RAD;
    const double effective =
        joined(90 - 0.24 * clipped_exp(20 - 0.20 * zenith), zenith, 12, zenith - SUN_NIGHT_DEG);
    const int season = e->month <= 2 || e->month >= 11 ? -1 : e->month >= 5 && e->month <= 8 ? 1 : 0;
    const double x = clipped_exp(0.3 * lat_deg), seasonal = season * (x - 1) / (x + 1),
                 f = 1.112 - 0.019 * seasonal;
    return sqrt(f * f * sqrt(e->az) * pow(cos(effective * ORR_RAD_PER_DEG), 0.6) + 0.49);
}

// (83)-(86): the peak's height from M(3000)F2.
static double height_f2(double m, double f2, double e)
{
    double delta = -0.012;
    if (e >= 1e-30) {
        const double ratio = f2 / e, r = joined(ratio, 1.75, 20, ratio - 1.75);
        delta += 0.253 / (r - 1.215);
    }
    const double m2 = m * m;
    return 1490 * m * sqrt((0.0196 * m2 + 1) / (1.2967 * m2 - 1)) / (m + delta) - 176;
}

// (90)-(98): the amplitudes that give each layer its density where the others are too.
static void amplitudes(neq_profile *p, double f1, double nm_f1, double nm_e)
{
    double *a = p->amplitude;
    a[0] = 4 * p->nm_f2;
    const double f2_at_e = epstein(a[0], p->hm_f2, p->b2_bottom, HM_E_KM);
    a[1] = 0;
    a[2] = 4 * (nm_e - f2_at_e);
    if (f1 >= 0.5) {
        const double f2_at_f1 = epstein(a[0], p->hm_f2, p->b2_bottom, p->hm_f1);
        a[2] = 4 * nm_e;
        for (int i = 0; i < 5; i++) {
            a[1] = 4 * (nm_f1 - f2_at_f1 - epstein(a[2], HM_E_KM, p->be_top, p->hm_f1));
            a[1] = joined(a[1], 0.8 * nm_f1, 1, a[1] - 0.8 * nm_f1);
            a[2] = 4 * (nm_e - epstein(a[1], p->hm_f1, p->b1_bottom, HM_E_KM) - f2_at_e);
        }
    }
    a[2] = joined(a[2], 0.05, 60, a[2] - 0.005);
}

// (99)-(108): the thickness of the top side.
static double topside(const neq_epoch *e, const neq_profile *p)
{
    const double ratio = p->hm_f2 / p->b2_bottom;
    double k = e->month >= 4 && e->month <= 9 ? 6.705 - 0.014 * e->azr - 0.008 * p->hm_f2
                                              : -7.77 + 0.097 * ratio * ratio + 0.153 * p->nm_f2;
    k = joined(k, 2, 1, k - 2);
    k = joined(8, k, 1, k - 8);
    const double h = k * p->b2_bottom, x = (h - 150) / 100;
    return h / ((0.041163 * x - 0.183981) * x + 1.424472);
}

void neq_profile_at(const neq_epoch *e, double lat_deg, double lon_deg, neq_profile *p)
{
    static const int f2_count[9] = {12, 12, 9, 5, 2, 1, 1, 1, 1}, m3_count[7] = {7, 8, 6, 3, 2, 1, 1};
    const double modip = neq_modip_deg(e->tables, lat_deg, lon_deg);
    const double f2 = spatial(e->f2, f2_count, 9, modip, lat_deg, lon_deg),
                 m = spatial(e->m3, m3_count, 7, modip, lat_deg, lon_deg),
                 fe = critical_e(e, lat_deg, lon_deg);
    // (38)-(41): the F1 layer is there by day.
    double f1 = joined(1.4 * fe, 0, 1000, fe - 2);
    f1 = joined(0, f1, 1000, fe - f1);
    f1 = joined(f1, 0.85 * f1, 60, 0.85 * f2 - f1);
    if (f1 < 1e-6) f1 = 0;
    const double nm_e = 0.124 * fe * fe;
    const double nm_f1 = f1 <= 0 && fe > 2 ? 0.124 * (fe + 0.5) * (fe + 0.5) : 0.124 * f1 * f1;
    p->nm_f2 = 0.124 * f2 * f2;
    p->hm_f2 = height_f2(m, f2, fe);
    p->hm_f1 = (p->hm_f2 + HM_E_KM) / 2;
    p->b2_bottom = 0.385 * p->nm_f2 / (0.01 * exp(-3.467 + 0.857 * log(f2 * f2) + 2.02 * log(m)));
    p->b1_top = 0.3 * (p->hm_f2 - p->hm_f1);
    p->b1_bottom = 0.5 * (p->hm_f1 - HM_E_KM);
    p->be_top = fmax(p->b1_bottom, 7);
    amplitudes(p, f1, nm_f1, nm_e);
    p->h0 = topside(e, p);
}

// (109)-(123): below the peak, and below 100 km a Chapman layer that goes on from there.
static double bottomside(const neq_profile *p, double height_km)
{
    const double h = fmax(height_km, 100), spread = clipped_exp(10 / (1 + fabs(h - p->hm_f2)));
    const double thickness[3] = {p->b2_bottom, h > p->hm_f1 ? p->b1_top : p->b1_bottom,
                                 h > HM_E_KM ? p->be_top : 5};
    const double alpha[3] = {(h - p->hm_f2) / thickness[0], (h - p->hm_f1) / thickness[1] * spread,
                             (h - HM_E_KM) / thickness[2] * spread};
    double sum = 0, slope = 0;
    for (int i = 0; i < 3; i++) {
        if (fabs(alpha[i]) > 25) continue;
        const double x = clipped_exp(alpha[i]), s = p->amplitude[i] * x / ((1 + x) * (1 + x));
        sum += s;
        slope += s * (1 - x) / (thickness[i] * (1 + x));
    }
    if (height_km >= 100 || sum == 0) return sum;
    const double c = 1 - 10 * slope / sum, z = (height_km - 100) / 10;
    return sum * clipped_exp(1 - c * z - clipped_exp(-z));
}

double neq_density(const neq_profile *p, double height_km)
{
    if (height_km <= p->hm_f2) return bottomside(p, height_km);
    const double g = 0.125, r = 100, dh = height_km - p->hm_f2; // (124)-(127)
    const double x = clipped_exp(dh / (p->h0 * (1 + r * g * dh / (r * p->h0 + g * dh))));
    return x > 1e11 ? 4 * p->nm_f2 / x : 4 * p->nm_f2 * x / ((1 + x) * (1 + x));
}
