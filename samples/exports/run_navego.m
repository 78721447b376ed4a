% SPDX-License-Identifier: GPL-3.0-or-later
% Navigates with NaveGo (github.com/rodralez/NaveGo) in Octave or MATLAB on readings of `orrery export --to navego`:
%     NAVEGO=/path/to/NaveGo octave run_navego.m IMU.csv TRUTH.csv
% The steps are those of its ins.m without updates.
addpath(genpath([getenv('NAVEGO') '/ins']), genpath([getenv('NAVEGO') '/conversions']));
names = argv();
imu = dlmread(names{1}, ',');
truth = dlmread(names{2}, ',', 1, 0);
t = imu(:, 1); fb = imu(:, 2:4); wb = imu(:, 5:7);
start = truth(1, :); d = pi / 180;
lat = start(2) * d; lon = start(3) * d; h = start(4); vel = start(5:7);
euler = start(8:10) * d;
C = euler2dcm(euler)'; q = euler2qua(euler);
ie = earth_rate(lat); en = transport_rate(lat, vel(1), vel(2), h); g = gravity(lat, h);
dt = t(2) - t(1); next = 2; worst = 0; worst_v = 0;
for i = 1:numel(t)
    vel = vel_update(C * fb(i, :)', vel, ie, en, g', dt);
    pos = pos_update([lat lon h], vel, dt);
    lat = pos(1); lon = pos(2); h = pos(3);
    ie = earth_rate(lat); en = transport_rate(lat, vel(1), vel(2), h); g = gravity(lat, h);
    [q, C, euler] = att_update(wb(i, :)', C, q, ie, en, dt, 'quaternion');
    if next <= rows(truth) && abs(t(i) - truth(next, 1)) < dt / 2
        r = llh2ecef([lat lon h]) - llh2ecef([truth(next, 2:3) * d truth(next, 4)]);
        worst = max(worst, norm(r)); worst_v = max(worst_v, abs(h - truth(next, 4)));
        next = next + 1;
    end
end
printf('NaveGo: %.0f s, position error %.4g m at most, vertical %.4g m\n', t(end) - truth(1, 1), worst, worst_v);
