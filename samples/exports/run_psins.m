% SPDX-License-Identifier: GPL-3.0-or-later
% Navigates with PSINS (Yan Gongmin's toolbox) in Octave or MATLAB on readings of `orrery export --to psins`:
%     PSINS=/path/to/PSINS octave run_psins.m IMU.txt TRUTH.csv [SAMPLES]
% Two samples a step by default; its axes are right, forward, up, its yaw is counter-clockwise.
addpath(genpath(getenv('PSINS')));
names = argv();
imu = load(names{1});
truth = dlmread(names{2}, ',', 1, 0);
glvs; % its constants
nn = 2;
if numel(names) > 2, nn = str2double(names{3}); end
d = pi / 180; s = truth(1, :); ts = imu(2, 7) - imu(1, 7);
avp = [s(9) * d; s(8) * d; -s(10) * d; s(6); s(5); -s(7); s(2) * d; s(3) * d; s(4)];
ins = insinit(avp, ts);
next = 2; worst = 0; worst_v = 0;
for k = 1:nn:rows(imu) - nn + 1
    ins = insupdate(ins, imu(k:k + nn - 1, 1:6));
    t = imu(k + nn - 1, 7);
    while next <= rows(truth) && truth(next, 1) < t - ts / 2, next = next + 1; end
    if next <= rows(truth) && abs(t - truth(next, 1)) < ts / 2
        p = ins.pos; q = [truth(next, 2:3)' * d; truth(next, 4)];
        R = 6378137; dn = (p(1) - q(1)) * R; de = (p(2) - q(2)) * R * cos(q(1));
        worst = max(worst, norm([dn de p(3) - q(3)])); worst_v = max(worst_v, abs(p(3) - q(3)));
    end
end
printf('PSINS, %d samples: %.0f s, position error %.4g m at most, vertical %.4g m\n', nn, imu(end, 7) - truth(1, 1), worst, worst_v);
