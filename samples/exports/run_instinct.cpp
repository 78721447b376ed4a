// SPDX-License-Identifier: GPL-3.0-or-later
// Navigates with the strapdown equations of INSTINCT (github.com/UniStuttgart-INS/INSTINCT), without its window, on readings of
// `orrery export --to instinct`: the local level frame, the Runge-Kutta method of fourth order on readings joined by lines, a free vertical channel.
//
//     g++ -std=c++20 -O2 -I INSTINCT/src -I GCEM/include -I /usr/include/eigen3 -o run_instinct run_instinct.cpp
//         INSTINCT/src/Navigation/Gravity/internal/AssociatedLegendre.cpp -lfmt -lspdlog
//     ./run_instinct IMU.csv TRUTH.csv [somigliana|wgs84]
//
// GCEM is github.com/kthohr/gcem; Eigen, fmt, spdlog and nlohmann's json are packages of every distribution. The truth has a row for each reading.
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "Navigation/INS/LocalNavFrame/Mechanization.hpp"

// What INSTINCT defines beside its window: a model's name, and the coefficients of EGM96, which are not used here.
const char *NAV::to_string(NAV::GravitationModel) { return "gravitation"; }
std::array<std::array<double, 6>, 65338> NAV::internal::egm96Coeffs;

namespace
{
using State = Eigen::Vector<double, 10>;
using Reading = Eigen::Vector<double, 6>;
constexpr double degree = M_PI / 180;

// Rows of numbers of a CSV file, its header left out.
std::vector<std::vector<double>> rows_of(const char *path)
{
    std::ifstream file(path);
    std::string line, cell;
    if (!std::getline(file, line)) throw std::runtime_error(std::string(path) + ": no header");
    std::vector<std::vector<double>> rows;
    while (std::getline(file, line)) {
        std::stringstream cells(line);
        auto &row = rows.emplace_back();
        while (std::getline(cells, cell, ',')) row.push_back(std::stod(cell));
    }
    if (rows.size() < 2) throw std::runtime_error(std::string(path) + ": fewer than two rows");
    return rows;
}

// A row of the truth: time, lat, lon, alt, VN, VE, VD, roll, pitch, heading.
State state_of(const std::vector<double> &row)
{
    const Eigen::Quaterniond q = Eigen::AngleAxisd(row[9] * degree, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(row[8] * degree, Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(row[7] * degree, Eigen::Vector3d::UnitX());
    State y;
    y << q.w(), q.x(), q.y(), q.z(), row[4], row[5], row[6], row[1] * degree, row[2] * degree, row[3];
    return y;
}

Eigen::Vector3d place(const Eigen::Vector3d &geodetic) { return NAV::trafo::lla2ecef_WGS84(geodetic); }

Reading reading_of(const std::vector<double> &row)
{
    Reading z;
    for (int k = 0; k < 6; k++) z(k) = row.at(5 + k);
    return z;
}
} // namespace

int main(int argc, char **argv)
{
    if (argc < 3) return std::fprintf(stderr, "run_instinct IMU.csv TRUTH.csv [somigliana|wgs84]\n"), 2;
    const auto readings = rows_of(argv[1]), truth = rows_of(argv[2]);
    NAV::PosVelAttDerivativeConstants<double> constants;
    const std::string model = argc > 3 ? argv[3] : "somigliana";
    if (model != "somigliana" && model != "wgs84")
        return std::fprintf(stderr, "no model of gravity %s\n", model.c_str()), 2;
    // Both closed forms are of gravity, so the centrifugal acceleration is in them already.
    constants.centrifgalAccelerationCompensationEnabled = false;
    constants.gravitationModel =
        model == "wgs84" ? NAV::GravitationModel::WGS84 : NAV::GravitationModel::Somigliana;
    // A reading is the mean over its step: the first stands for the begin too, and each later pair for the time between two middles.
    State y = state_of(truth[0]);
    double time = truth[0][0], begun = time, position = 0, vertical = 0;
    Reading last = reading_of(readings[0]);
    size_t next = 1;
    for (const auto &row : readings) {
        const Reading now = reading_of(row);
        const Reading middle = 0.5 * (last + now);
        const double step = row[0] - time;
        y = NAV::RungeKutta4(y, std::array<Reading, 4>{last, middle, middle, now}, step,
                             NAV::n_calcPosVelAttDerivative<double>, constants);
        y.head<4>().normalize();
        time = row[0], last = now;
        while (next < truth.size() && truth[next][0] < time - 1e-6) next++;
        if (next >= truth.size()) break;
        const State a = state_of(truth[next - 1]), b = state_of(truth[next]);
        const double share = (time - truth[next - 1][0]) / (truth[next][0] - truth[next - 1][0]);
        const Eigen::Vector3d true_place = a.tail<3>() + share * (b.tail<3>() - a.tail<3>());
        position = std::max(position, (place(y.tail<3>()) - place(true_place)).norm());
        vertical = std::max(vertical, std::abs(y(9) - true_place(2)));
    }
    std::printf("INSTINCT: %.0f s, position error %.4g m at most, vertical %.4g m\n", time - begun, position,
                vertical);
}
