// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/dubins.h"

#include <math.h>

#include "core/vec.h"

orr_pose orr_path_at(const orr_path_piece *p, double along_m)
{
    orr_pose q = p->from;
    double c = q.course_rad;
    if (p->turn == 0) {
        q.east_m += along_m * sin(c);
        q.north_m += along_m * cos(c);
        return q;
    }
    double k = (double)p->turn, d = k * along_m / p->radius_m;
    q.east_m += k * p->radius_m * (cos(c) - cos(c + d));
    q.north_m += k * p->radius_m * (sin(c + d) - sin(c));
    q.course_rad = c + d;
    return q;
}

static double positive(double a)
{
    double r = fmod(a, 2.0 * ORR_PI);
    if (r < 0.0) r += 2.0 * ORR_PI;
    // A full circle that is one by rounding alone is none.
    return r > 2.0 * ORR_PI - 1e-9 ? 0.0 : r;
}

typedef struct vec2 {
    double e, n;
} vec2;
static vec2 centre(orr_pose p, int turn, double R)
{
    return (vec2){p.east_m + turn * R * cos(p.course_rad), p.north_m - turn * R * sin(p.course_rad)};
}

// Course changes (all positive) and the straight's length of the word (t1, 0, t3).
static bool with_straight(orr_pose a, orr_pose b, double R, int t1, int t3, double out[3])
{
    vec2 A = centre(a, t1, R), B = centre(b, t3, R);
    double de = B.e - A.e, dn = B.n - A.n, d = hypot(de, dn), course = atan2(de, dn);
    if (t1 != t3) {
        if (d < 2.0 * R) return false;
        course += t1 * asin(2.0 * R / d);
        out[1] = sqrt(d * d - 4.0 * R * R);
    } else {
        out[1] = d;
    }
    out[0] = positive(t1 * (course - a.course_rad)) * R;
    out[2] = positive(t3 * (b.course_rad - course)) * R;
    return true;
}

// The word (t, -t, t), its middle circle on either side of the line of centres.
static bool three_turns(orr_pose a, orr_pose b, double R, int t, int side, double out[3])
{
    vec2 A = centre(a, t, R), B = centre(b, t, R);
    double de = B.e - A.e, dn = B.n - A.n, d = hypot(de, dn);
    if (d > 4.0 * R) return false;
    // The middle circle touches both.
    double line = atan2(de, dn), open = acos(d / (4.0 * R));
    double to_mid = line - side * open;           // direction A -> middle centre
    double mid_to_b = line + side * open;         // direction middle centre -> B
    double course1 = to_mid + t * 0.5 * ORR_PI;   // at the touching point of A's circle, turning t about A
    double course2 = mid_to_b - t * 0.5 * ORR_PI; // at that of B's circle, turning t about B
    out[0] = positive(t * (course1 - a.course_rad)) * R;
    out[1] = positive(-t * (course2 - course1)) * R;
    out[2] = positive(t * (b.course_rad - course2)) * R;
    return true;
}

double orr_dubins(orr_pose from, orr_pose to, double radius_m, orr_path_piece piece[3])
{
    double best = HUGE_VAL, length[3] = {0, 0, 0};
    int turn[3] = {0, 0, 0};
    for (int word = 0; word < 8; word++) {
        int t1 = word & 1 ? 1 : -1, t3 = word < 4 ? (word & 2 ? 1 : -1) : t1, side = word & 2 ? 1 : -1;
        double L[3];
        if (word < 4 ? !with_straight(from, to, radius_m, t1, t3, L)
                     : !three_turns(from, to, radius_m, t1, side, L))
            continue;
        double sum = L[0] + L[1] + L[2];
        if (sum >= best) continue;
        best = sum;
        for (int i = 0; i < 3; i++) length[i] = L[i];
        turn[0] = t1;
        turn[1] = word < 4 ? 0 : -t1;
        turn[2] = t3;
    }
    for (int i = 0; i < 3; i++) {
        piece[i] = (orr_path_piece){.from = i == 0 ? from : orr_path_at(&piece[i - 1], piece[i - 1].length_m),
                                    .length_m = length[i],
                                    .radius_m = radius_m,
                                    .turn = turn[i]};
    }
    return best;
}
