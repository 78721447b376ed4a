#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Navigates with pyins (github.com/nmayorov/pyins; numpy, pandas, scipy, numba) on readings of `orrery export --to pyins`:

    run_pyins.py IMU.csv TRUTH.csv
"""
import sys
import time

import numpy as np
import pandas as pd
from pyins import strapdown, transform

imu = pd.read_csv(sys.argv[1], index_col="time")
truth = pd.read_csv(sys.argv[2], index_col="time")
begun = time.time()
increments = strapdown.compute_increments_from_imu(imu, "increment")
integrator = strapdown.Integrator(truth.iloc[0])
found = integrator.integrate(increments)
spent = time.time() - begun
index = np.clip(np.searchsorted(found.index.values, truth.index.values[1:] - 1e-6), 0, len(found) - 1)
place = transform.lla_to_ecef(found.iloc[index][["lat", "lon", "alt"]]) - transform.lla_to_ecef(truth.iloc[1:][["lat", "lon", "alt"]])
error = np.linalg.norm(np.asarray(place), axis=1)
down = np.abs(found.iloc[index].alt.values - truth.iloc[1:].alt.values)
across = np.sqrt(np.maximum(error**2 - down**2, 0))
print(f"pyins: {truth.index[-1] - truth.index[0]:.0f} s, position error {error.max():.4g} m at most, vertical {down.max():.4g} m, "
      f"horizontal {across.max():.4g} m, {spent:.1f} s of computing")
