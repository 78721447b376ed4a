// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/make/gravity.h"

void orr_sample_gravity_init(orr_sample_gravity *g, int degree)
{
    *g = (orr_sample_gravity){.degree = degree};
    g->c[0][0] = 1;
    for (int i = 0; i < ORR_SAMPLE_N_COEFFICIENTS; i++) {
        const orr_sample_coefficient *k = &ORR_SAMPLE_EGM96[i];
        if (k->n > degree) continue;
        g->c[k->n][k->m] = k->c;
        g->s[k->n][k->m] = k->s;
    }
    for (int n = 0; n <= degree; n++) {
        for (int m = 0; m <= n; m++) {
            double down = (double)(n - m) * (n + m);
            if (n > m) g->a[n][m] = sqrt((2.0 * n - 1) * (2.0 * n + 1) / down);
            if (n > m + 1)
                g->b[n][m] = sqrt((2.0 * n + 1) * (n + m - 1.0) * (n - m - 1.0) / (down * (2.0 * n - 3)));
            g->d[n][m] = sqrt((n - m) * (n + m + 1.0) * (m == 0 ? 0.5 : 1.0));
        }
    }
}

// Fully normalised P(n, m) of the sine of latitude (Heiskanen and Moritz 1967, 1-11; Holmes and Featherstone
// 2002, (11)).
static void legendre(const orr_sample_gravity *g, double sine, double cosine,
                     double p[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 2])
{
    for (int m = 0; m <= g->degree; m++) {
        if (m == 0)
            p[0][0] = 1;
        else
            p[m][m] = cosine * p[m - 1][m - 1] * (m == 1 ? sqrt(3.0) : sqrt((2.0 * m + 1) / (2.0 * m)));
        p[m][m + 1] = 0;
        for (int n = m + 1; n <= g->degree; n++)
            p[n][m] = g->a[n][m] * sine * p[n - 1][m] - (n > m + 1 ? g->b[n][m] * p[n - 2][m] : 0);
    }
}

orr_vec3 orr_sample_gravitation(const orr_sample_gravity *g, orr_vec3 r)
{
    double rho2 = r.x * r.x + r.y * r.y, rho = sqrt(rho2), n2 = rho2 + r.z * r.z, norm = sqrt(n2);
    double sine = r.z / norm, cosine = rho / norm, tangent = sine / cosine, cl = r.x / rho, sl = r.y / rho;
    double p[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 2];
    legendre(g, sine, cosine, p);
    double by_r = 0, by_lat = 0, by_lon = 0, q = 1; // derivatives of the potential over GM/r
    double cm[ORR_SAMPLE_DEGREE + 1] = {1}, sm[ORR_SAMPLE_DEGREE + 1] = {0};
    for (int m = 1; m <= g->degree; m++) {
        cm[m] = cm[m - 1] * cl - sm[m - 1] * sl;
        sm[m] = sm[m - 1] * cl + cm[m - 1] * sl;
    }
    for (int n = 0; n <= g->degree; n++, q *= ORR_EGM96_RADIUS_M / norm) {
        double u = 0, v = 0, w = 0;
        for (int m = 0; m <= n; m++) {
            double even = g->c[n][m] * cm[m] + g->s[n][m] * sm[m],
                   odd = g->s[n][m] * cm[m] - g->c[n][m] * sm[m];
            u += even * p[n][m];
            v += even * (g->d[n][m] * p[n][m + 1] - m * tangent * p[n][m]);
            w += odd * m * p[n][m];
        }
        by_r -= (n + 1) * q * u;
        by_lat += q * v;
        by_lon += q * w;
    }
    double scale = ORR_EGM96_GM / n2;
    double radial = scale * by_r, north = scale * by_lat, east = scale * by_lon / cosine;
    return (orr_vec3){radial * cosine * cl - north * sine * cl - east * sl,
                      radial * cosine * sl - north * sine * sl + east * cl, radial * sine + north * cosine};
}
