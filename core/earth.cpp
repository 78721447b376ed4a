// SPDX-License-Identifier: GPL-3.0-or-later
// The one C++ file: GeographicLib behind core/earth_shim.h. Nothing is thrown past it.
#include "core/earth_shim.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <new>
#include <string>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Geoid.hpp>
#include <GeographicLib/GravityModel.hpp>
#include <GeographicLib/MagneticModel.hpp>
#include <GeographicLib/NormalGravity.hpp>

namespace
{
const double nothing = std::numeric_limits<double>::quiet_NaN();

void clear(double v[3]) { v[0] = v[1] = v[2] = nothing; }

// What `make` makes; nullptr, with the reason in text[n], where it throws.
template <typename Make>
void *made(Make make, const char *without_memory, char *text, size_t n, int *no_memory)
{
    *no_memory = 0;
    try {
        return make();
    } catch (const std::bad_alloc &) {
        *no_memory = 1;
        std::snprintf(text, n, "%s", without_memory);
    } catch (const std::exception &e) {
        std::snprintf(text, n, "%s", e.what());
    } catch (...) {
        std::snprintf(text, n, "GeographicLib gave no reason");
    }
    return nullptr;
}
} // namespace

extern "C" void orr_shim_forward(double lat_deg, double lon_deg, double height_m, double r_m[3])
{
    try {
        GeographicLib::Geocentric::WGS84().Forward(lat_deg, lon_deg, height_m, r_m[0], r_m[1], r_m[2]);
    } catch (...) {
        clear(r_m);
    }
}

extern "C" void orr_shim_reverse(const double r_m[3], double *lat_deg, double *lon_deg, double *height_m)
{
    try {
        GeographicLib::Geocentric::WGS84().Reverse(r_m[0], r_m[1], r_m[2], *lat_deg, *lon_deg, *height_m);
    } catch (...) {
        *lat_deg = *lon_deg = *height_m = nothing;
    }
}

extern "C" void orr_shim_normal_gravitation(const double r_m[3], double g_mps2[3])
{
    try {
        GeographicLib::NormalGravity::WGS84().V0(r_m[0], r_m[1], r_m[2], g_mps2[0], g_mps2[1], g_mps2[2]);
    } catch (...) {
        clear(g_mps2);
    }
}

extern "C" void orr_shim_geodesic_direct(double lat1_deg, double lon1_deg, double az1_deg, double dist_m,
                                         double *lat2_deg, double *lon2_deg, double *az2_deg)
{
    try {
        GeographicLib::Geodesic::WGS84().Direct(lat1_deg, lon1_deg, az1_deg, dist_m, *lat2_deg, *lon2_deg,
                                                *az2_deg);
    } catch (...) {
        *lat2_deg = *lon2_deg = *az2_deg = nothing;
    }
}

extern "C" void *orr_shim_gravity_open(const char *name, const char *dir, int degree, char *text, size_t n,
                                       int *no_memory)
{
    return made([=] { return new GeographicLib::GravityModel(name, dir, degree, degree); },
                "no memory for its coefficients", text, n, no_memory);
}

extern "C" void orr_shim_gravity(const void *model, const double r_m[3], double g_mps2[3])
{
    try {
        static_cast<const GeographicLib::GravityModel *>(model)->V(r_m[0], r_m[1], r_m[2], g_mps2[0],
                                                                   g_mps2[1], g_mps2[2]);
    } catch (...) {
        clear(g_mps2);
    }
}

extern "C" int orr_shim_gravity_degree(const void *model)
{
    return static_cast<const GeographicLib::GravityModel *>(model)->Degree();
}

extern "C" void orr_shim_gravity_file(const void *model, char *path, size_t n)
{
    try {
        std::snprintf(path, n, "%s",
                      static_cast<const GeographicLib::GravityModel *>(model)->GravityFile().c_str());
    } catch (...) {
        path[0] = '\0';
    }
}

extern "C" void orr_shim_gravity_free(void *model)
{
    delete static_cast<GeographicLib::GravityModel *>(model);
}

extern "C" void *orr_shim_geoid_open(const char *name, const char *dir, char *text, size_t n, int *no_memory)
{
    return made([=] { return new GeographicLib::Geoid(name, dir); }, "no memory for it", text, n, no_memory);
}

extern "C" double orr_shim_geoid_height(const void *geoid, double lat_deg, double lon_deg)
{
    try {
        return (*static_cast<const GeographicLib::Geoid *>(geoid))(lat_deg, lon_deg);
    } catch (...) {
        return nothing;
    }
}

extern "C" void orr_shim_geoid_free(void *geoid) { delete static_cast<GeographicLib::Geoid *>(geoid); }

extern "C" void *orr_shim_magnetic_open(const char *name, const char *dir, char *text, size_t n,
                                        int *no_memory)
{
    return made([=] { return new GeographicLib::MagneticModel(name, dir); }, "no memory for it", text, n,
                no_memory);
}

extern "C" void orr_shim_magnetic_field(const void *model, double year, double lat_deg, double lon_deg,
                                        double height_m, double enu_nt[3])
{
    try {
        (*static_cast<const GeographicLib::MagneticModel *>(model))(year, lat_deg, lon_deg, height_m,
                                                                    enu_nt[0], enu_nt[1], enu_nt[2]);
    } catch (...) {
        clear(enu_nt);
    }
}

extern "C" void orr_shim_magnetic_free(void *model)
{
    delete static_cast<GeographicLib::MagneticModel *>(model);
}
