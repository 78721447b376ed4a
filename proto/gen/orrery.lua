-- SPDX-License-Identifier: MIT
-- Generated from proto/spec/messages.yaml and proto/spec/dissector.lua by proto/spec/generate.py: change those, not this.
-- Wireshark dissector of Orrery, protocol 1.0, TCP port 15754.
local PROTOCOL, MAGIC, MAJOR, PORT, MAX_PAYLOAD = "Orrery", "ORRY", 1, 15754, 4194304
local orrery = Proto("orrery", "Orrery satellite states")

local enums, bitsets, records = {}, {}, {}
enums.error_code = {
  [1] = "BAD_MAGIC",
  [2] = "BAD_LENGTH",
  [3] = "BAD_CRC",
  [4] = "BAD_VERSION",
  [5] = "UNKNOWN_TYPE",
  [6] = "BAD_PAYLOAD",
  [7] = "BAD_REQUEST",
  [8] = "LIMIT",
  [9] = "NOT_SERVED",
  [10] = "BUSY",
  [11] = "TIMEOUT",
  [12] = "CLOSING",
  [13] = "INTERNAL",
  [14] = "NOT_PERMITTED",
}
enums.answer = {
  [0] = "OK",
  [1] = "OUTSIDE_SPAN",
  [2] = "NO_ARC",
  [3] = "NOT_SERVED",
  [4] = "BELOW_HORIZON",
  [5] = "NO_VALUE",
}
enums.nav_message = {
  [0] = "NONE",
  [1] = "LNAV",
  [2] = "CNAV",
  [3] = "CNV1",
  [4] = "CNV2",
  [5] = "CNV3",
  [6] = "INAV",
  [7] = "FNAV",
  [8] = "D1",
  [9] = "D2",
  [10] = "FDMA",
  [11] = "SBAS",
}
enums.nav_form = {
  [0] = "BITS",
  [1] = "SYMBOLS",
}
enums.elements_frame = {
  [0] = "DATE",
  [1] = "J2000",
  [2] = "ECEF",
}
enums.elements_method = {
  [0] = "STATE",
  [1] = "THREE_POSITIONS",
  [2] = "MEAN",
}
enums.orbit_point = {
  [0] = "NONE",
  [1] = "CENTRE_OF_MASS",
  [2] = "PHASE_CENTRE",
}
enums.receiver_source = {
  [0] = "NONE",
  [1] = "POSITION",
  [2] = "TRAJECTORY",
  [3] = "STATION",
}
enums.tec_origin = {
  [0] = "FIELD",
  [1] = "FUSED",
  [2] = "TRANSFERRED",
  [3] = "NOISE",
}
enums.pacing = {
  [0] = "FREE",
  [1] = "CLOCK",
  [2] = "MOTION",
}
enums.delivery = {
  [0] = "FRAMES",
  [1] = "RING",
  [2] = "DATAGRAMS",
}
enums.seal = {
  [0] = "NONE",
  [1] = "HMAC_SHA256",
}
enums.gap_reason = {
  [1] = "CREDIT",
  [2] = "LATE",
}
enums.end_reason = {
  [1] = "FINISHED",
  [2] = "UNSUBSCRIBED",
  [3] = "SLOW",
  [4] = "OUTSIDE_SPAN",
  [5] = "FAILED",
}
enums.control_action = {
  [1] = "LOAD",
  [2] = "ARM",
  [3] = "WAIT_PPS",
  [4] = "START",
  [5] = "PAUSE",
  [6] = "STOP",
}
enums.clock_reference = {
  [0] = "WALL",
  [1] = "RADIO",
}
enums.clock_state = {
  [0] = "STOPPED",
  [1] = "ARMED",
  [2] = "WAITING",
  [3] = "RUNNING",
  [4] = "PAUSED",
}
enums.readings = {
  [0] = "IDEAL",
  [1] = "MEASURED",
}
enums.stamp_clock = {
  [0] = "ARRIVAL",
  [1] = "MONOTONIC",
  [2] = "TAI",
  [3] = "REALTIME",
}
enums.motion_state = {
  [0] = "SCENARIO",
  [1] = "SYNCHRONOUS",
  [2] = "INTERPOLATED",
  [3] = "EXTRAPOLATED",
  [4] = "JOINING",
  [5] = "SNAPPED",
}
enums.motion_point = {
  [0] = "BODY",
  [1] = "ANTENNA",
}
enums.event_kind = {
  [1] = "RISE",
  [2] = "SET",
  [3] = "ARC_BEGIN",
  [4] = "ARC_END",
  [5] = "EPHEMERIS",
  [6] = "HEALTH",
  [7] = "LEAP_SECOND",
  [8] = "ECLIPSE_BEGIN",
  [9] = "ECLIPSE_END",
  [10] = "MANOEUVRE_BEGIN",
  [11] = "MANOEUVRE_END",
  [12] = "MOTION_BEGIN",
  [13] = "MOTION_END",
  [14] = "FAULT_BEGIN",
  [15] = "FAULT_END",
}
enums.mode_kind = {
  [0] = "CLOCK",
  [1] = "REFERENCE",
  [2] = "GENERATOR",
  [3] = "MOTION",
}
enums.mode = {
  [0] = "STOPPED",
  [1] = "ARMED",
  [2] = "WAITING",
  [3] = "RUNNING",
  [4] = "PAUSED",
  [16] = "WALL",
  [17] = "RADIO",
  [32] = "SILENT",
  [33] = "LOCKED",
  [34] = "STEPPING",
  [48] = "SCENARIO",
  [49] = "SYNCHRONOUS",
  [50] = "INTERPOLATED",
  [51] = "EXTRAPOLATED",
  [52] = "JOINING",
  [53] = "SNAPPED",
}
bitsets.access = {
  {name = "NO_READING", bit = 0},
  {name = "NO_MOTION", bit = 1},
  {name = "NO_CONTROL", bit = 2},
  {name = "INSECURE", bit = 3},
}
bitsets.channel_flags = {
  {name = "UNHEALTHY", bit = 0},
  {name = "ECLIPSE", bit = 1},
  {name = "FAST_TURN", bit = 2},
  {name = "NO_ANTENNA", bit = 3},
  {name = "NO_DELAY", bit = 4},
  {name = "ZERO_CLOCK", bit = 5},
  {name = "NOMINAL_CHANNEL", bit = 6},
  {name = "FAULT", bit = 7},
}
bitsets.delay_flags = {
  {name = "CLIPPED", bit = 0},
}
bitsets.state_flags = {
  {name = "CLOCK_VALID", bit = 0},
  {name = "PREDICTED", bit = 1},
  {name = "MANOEUVRE", bit = 2},
  {name = "CLOCK_EVENT", bit = 3},
  {name = "ECLIPSE", bit = 4},
  {name = "GAP", bit = 5},
  {name = "JOINT", bit = 6},
  {name = "SHADOW_NOISE", bit = 7},
}
bitsets.nav_messages = {
  {name = "LNAV", bit = 1},
  {name = "CNAV", bit = 2},
  {name = "CNV1", bit = 3},
  {name = "CNV2", bit = 4},
  {name = "CNV3", bit = 5},
  {name = "INAV", bit = 6},
  {name = "FNAV", bit = 7},
  {name = "D1", bit = 8},
  {name = "D2", bit = 9},
  {name = "FDMA", bit = 10},
  {name = "SBAS", bit = 11},
}
bitsets.nav_notes = {
  {name = "MANOEUVRE", bit = 0},
  {name = "SHIFTED", bit = 1},
  {name = "NO_CLOCK", bit = 2},
  {name = "NO_ANTENNA", bit = 3},
  {name = "NO_DELAY", bit = 4},
  {name = "NOMINAL_CHANNEL", bit = 5},
  {name = "CLOCK_JUMP", bit = 6},
  {name = "FAULTY", bit = 7},
}
records.motion_spread = {size = 40, smallest = 40, fields = {
    {name = "min", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "max", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "last", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "p50", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "p99", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
}}
records.sat_id = {size = 2, smallest = 2, satellite = true, fields = {
    {name = "system", kind = "scalar", scalar = "u8", show = "char"},
    {name = "number", kind = "scalar", scalar = "u8"},
}}
records.epochs = {size = 20, smallest = 20, spread = true, fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "step", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "count", kind = "scalar", scalar = "u32"},
}}
records.epoch = {size = 17, smallest = 17, spread = true, fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "index", kind = "scalar", scalar = "u32"},
    {name = "count", kind = "scalar", scalar = "u32"},
    {name = "answer", kind = "scalar", scalar = "u8", enum = "answer"},
}}
records.span = {size = 16, smallest = 16, fields = {
    {name = "first", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "last", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
}}
records.served_request = {size = 20, smallest = 20, fields = {
    {name = "request", kind = "scalar", scalar = "u16", show = "message"},
    {name = "answer", kind = "scalar", scalar = "u16", show = "message"},
    {name = "span", kind = "struct", record = "span"},
}}
records.inertial_unit = {fields = {
    {name = "unit", kind = "scalar", scalar = "u16"},
    {name = "name", kind = "string", limit = 64},
    {name = "lever_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "heading_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "pitch_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "roll_rad", kind = "scalar", scalar = "f64", unit = "rad"},
}}
records.leap_seconds = {size = 12, smallest = 12, fields = {
    {name = "gps_utc_s", kind = "scalar", scalar = "i16", unit = "s"},
    {name = "next_gps_utc_s", kind = "scalar", scalar = "i16", unit = "s"},
    {name = "next", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
}}
records.sat_state = {size = 120, smallest = 120, fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "answer", kind = "scalar", scalar = "u8", enum = "answer"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
    {name = "flags", kind = "scalar", scalar = "u32", bits = "state_flags"},
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "vel_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
    {name = "acc_mps2", kind = "array", scalar = "f64", length = 3, unit = "m/s2"},
    {name = "clock_s", kind = "scalar", scalar = "f64", unit = "s"},
    {name = "clock_rate_sps", kind = "scalar", scalar = "f64", unit = "s/s"},
    {name = "valid_from", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "valid_to", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "sigma_m", kind = "scalar", scalar = "f32", unit = "m"},
    {name = "clock_sigma_s", kind = "scalar", scalar = "f32", unit = "s"},
}}
records.sat_elements = {size = 64, smallest = 64, fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "answer", kind = "scalar", scalar = "u8", enum = "answer"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
    {name = "flags", kind = "scalar", scalar = "u32", bits = "state_flags"},
    {name = "a_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "e", kind = "scalar", scalar = "f64"},
    {name = "i_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "raan_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "argp_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "m_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "u_rad", kind = "scalar", scalar = "f64", unit = "rad"},
}}
records.nav_page = {fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "length", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "number", kind = "scalar", scalar = "u8"},
    {name = "page", kind = "scalar", scalar = "u8"},
    {name = "bits", kind = "scalar", scalar = "u16"},
    {name = "data", kind = "bytes", limit = 226},
}}
records.kepler_set = {size = 144, smallest = 144, fields = {
    {name = "sqrt_a_sqrtm", kind = "scalar", scalar = "f64", unit = "sqrt(m)"},
    {name = "e", kind = "scalar", scalar = "f64"},
    {name = "m0_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "i0_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "omega0_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "omega_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "delta_n_radps", kind = "scalar", scalar = "f64", unit = "rad/s"},
    {name = "idot_radps", kind = "scalar", scalar = "f64", unit = "rad/s"},
    {name = "omega_dot_radps", kind = "scalar", scalar = "f64", unit = "rad/s"},
    {name = "cuc_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "cus_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "crc_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "crs_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "cic_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "cis_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "a_dot_mps", kind = "scalar", scalar = "f64", unit = "m/s"},
    {name = "delta_n_dot_radps2", kind = "scalar", scalar = "f64", unit = "rad/s2"},
    {name = "tgd_s", kind = "scalar", scalar = "f64", unit = "s"},
}}
records.glonass_set = {size = 82, smallest = 82, fields = {
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "vel_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
    {name = "acc_mps2", kind = "array", scalar = "f64", length = 3, unit = "m/s2"},
    {name = "delta_tau_s", kind = "scalar", scalar = "f64", unit = "s"},
    {name = "channel", kind = "scalar", scalar = "i8"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
}}
records.sat_navdata = {fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "answer", kind = "scalar", scalar = "u8", enum = "answer"},
    {name = "message", kind = "scalar", scalar = "u8", enum = "nav_message"},
    {name = "form", kind = "scalar", scalar = "u8", enum = "nav_form"},
    {name = "signals", kind = "string", limit = 16},
    {name = "notes", kind = "scalar", scalar = "u32", bits = "nav_notes"},
    {name = "set_from", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "set_to", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "toe", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "toc", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "week", kind = "scalar", scalar = "i32"},
    {name = "iode", kind = "scalar", scalar = "i16"},
    {name = "iodc", kind = "scalar", scalar = "i16"},
    {name = "health", kind = "scalar", scalar = "u32"},
    {name = "accuracy_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fit_rms_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fit_max_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "clock_rms_s", kind = "scalar", scalar = "f64", unit = "s"},
    {name = "af0_s", kind = "scalar", scalar = "f64", unit = "s"},
    {name = "af1_sps", kind = "scalar", scalar = "f64", unit = "s/s"},
    {name = "af2_sps2", kind = "scalar", scalar = "f64", unit = "s/s2"},
    {name = "frame_from", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "frame_to", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "kepler", kind = "list", record = "kepler_set", limit = 1},
    {name = "glonass", kind = "list", record = "glonass_set", limit = 1},
    {name = "pages", kind = "list", record = "nav_page", limit = 15},
}}
records.sat_delay = {size = 98, smallest = 98, fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "answer", kind = "scalar", scalar = "u8", enum = "answer"},
    {name = "origin", kind = "scalar", scalar = "u8", enum = "tec_origin"},
    {name = "flags", kind = "scalar", scalar = "u8", bits = "delay_flags"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
    {name = "az_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "el_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "pierce_lat_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "pierce_lon_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "mapping", kind = "scalar", scalar = "f64"},
    {name = "stec_tecu", kind = "scalar", scalar = "f64", unit = "TECU"},
    {name = "model_stec_tecu", kind = "scalar", scalar = "f64", unit = "TECU"},
    {name = "delay_m", kind = "array", scalar = "f64", length = 4, unit = "m"},
    {name = "sigma_tecu", kind = "scalar", scalar = "f32", unit = "TECU"},
}}
records.antenna = {fields = {
    {name = "antenna", kind = "scalar", scalar = "u16"},
    {name = "name", kind = "string", limit = 64},
    {name = "kind", kind = "string", limit = 20},
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
}}
records.signal = {fields = {
    {name = "signal", kind = "scalar", scalar = "u16"},
    {name = "system", kind = "scalar", scalar = "u8", show = "char"},
    {name = "name", kind = "string", limit = 16},
    {name = "observation", kind = "string", limit = 8},
    {name = "modulation", kind = "string", limit = 32},
    {name = "components", kind = "string", limit = 16},
    {name = "carrier_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "channel_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "chips_per_s", kind = "scalar", scalar = "f64", unit = "chip/s"},
    {name = "chips", kind = "scalar", scalar = "u64"},
}}
records.transmitter = {fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "frequency_channel", kind = "scalar", scalar = "i8"},
    {name = "unhealthy", kind = "scalar", scalar = "u8"},
    {name = "svn", kind = "string", limit = 10},
    {name = "block", kind = "string", limit = 20},
}}
records.sat_channel = {size = 126, smallest = 126, fields = {
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "signal", kind = "scalar", scalar = "u16"},
    {name = "flags", kind = "scalar", scalar = "u32", bits = "channel_flags"},
    {name = "az_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "el_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "carrier_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "code", kind = "array", scalar = "f64", length = 4, show = "polynomial", unit = "m/s^k"},
    {name = "carrier_cycles", kind = "scalar", scalar = "i64", unit = "cycle"},
    {name = "carrier", kind = "array", scalar = "f64", length = 4, show = "polynomial", unit = "cycle/s^k"},
    {name = "transmit", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "transmit_fraction_ns", kind = "scalar", scalar = "f64", unit = "ns"},
    {name = "power_dbw", kind = "scalar", scalar = "f32", unit = "dBW"},
    {name = "echo", kind = "scalar", scalar = "u16"},
}}
records.jammer = {fields = {
    {name = "number", kind = "scalar", scalar = "u16"},
    {name = "waveform", kind = "string", limit = 32},
    {name = "az_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "el_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "range_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "range_rate_mps", kind = "scalar", scalar = "f64", unit = "m/s"},
    {name = "carrier_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "doppler_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "power_dbw", kind = "scalar", scalar = "f32", unit = "dBW"},
}}
records.channel_terms = {size = 280, smallest = 280, fields = {
    {name = "distance_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "sagnac_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "shapiro_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "satellite_clock_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "clock_noise_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "relativity_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "group_delay_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "satellite_antenna_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "receiver_antenna_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "solid_tide_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "pole_tide_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "ocean_loading_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "troposphere_hydrostatic_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "troposphere_wet_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "turbulence_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "ionosphere_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "emission_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "emission_ionosphere_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "wind_up_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "phase_bias_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "ionosphere_second_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "receiver_delay_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "residual_code_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "residual_carrier_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "disturbance_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "scintillation_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "land_mobile_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "echo_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "echo_phase_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "spoofer_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fault_range_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fault_noise_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fault_clock_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fault_divergence_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "fault_orbit_m", kind = "scalar", scalar = "f64", unit = "m"},
}}
records.event = {size = 22, smallest = 22, fields = {
    {name = "at", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "kind", kind = "scalar", scalar = "u8", enum = "event_kind"},
    {name = "sat", kind = "struct", record = "sat_id"},
    {name = "message", kind = "scalar", scalar = "u8", enum = "nav_message"},
    {name = "antenna", kind = "scalar", scalar = "u16"},
    {name = "value", kind = "scalar", scalar = "i64"},
}}
records.mode_change = {size = 28, smallest = 28, fields = {
    {name = "number", kind = "scalar", scalar = "u64"},
    {name = "at", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "kind", kind = "scalar", scalar = "u8", enum = "mode_kind"},
    {name = "before", kind = "scalar", scalar = "u8", enum = "mode"},
    {name = "mode", kind = "scalar", scalar = "u8", enum = "mode"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
    {name = "wall", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
}}
records.hello = {fields = {
    {name = "major_min", kind = "scalar", scalar = "u8"},
    {name = "major_max", kind = "scalar", scalar = "u8"},
    {name = "name", kind = "string", limit = 64},
    {name = "version", kind = "string", limit = 32},
}}
records.caps = {fields = {
    {name = "major", kind = "scalar", scalar = "u8"},
    {name = "minor", kind = "scalar", scalar = "u8"},
    {name = "max_request", kind = "scalar", scalar = "u32"},
    {name = "max_epochs", kind = "scalar", scalar = "u32"},
    {name = "span", kind = "struct", record = "span"},
    {name = "name", kind = "string", limit = 64},
    {name = "version", kind = "string", limit = 32},
    {name = "title", kind = "string", limit = 128},
    {name = "frame", kind = "string", limit = 64},
    {name = "leap", kind = "struct", record = "leap_seconds"},
    {name = "navdata_point", kind = "scalar", scalar = "u8", enum = "orbit_point"},
    {name = "receiver_source", kind = "scalar", scalar = "u8", enum = "receiver_source"},
    {name = "receiver_unit", kind = "scalar", scalar = "u16"},
    {name = "receiver_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "imu_rate_hz", kind = "scalar", scalar = "f64", unit = "Hz"},
    {name = "units", kind = "list", record = "inertial_unit", limit = 64},
    {name = "antennas", kind = "list", record = "antenna", limit = 16},
    {name = "signals", kind = "list", record = "signal", limit = 64},
    {name = "transmitters", kind = "list", record = "transmitter", limit = 800},
    {name = "requests", kind = "list", record = "served_request", limit = 64},
    {name = "satellites", kind = "list", record = "sat_id", limit = 800},
    {name = "access", kind = "scalar", scalar = "u16", bits = "access"},
}}
records.ping = {size = 8, smallest = 8, fields = {
    {name = "token", kind = "scalar", scalar = "u64", show = "hex"},
}}
records.pong = {size = 8, smallest = 8, fields = {
    {name = "token", kind = "scalar", scalar = "u64", show = "hex"},
}}
records.error = {fields = {
    {name = "code", kind = "scalar", scalar = "u16", enum = "error_code"},
    {name = "request", kind = "scalar", scalar = "u16", show = "message"},
    {name = "sentence", kind = "string", limit = 512},
}}
records.poll = {fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "satellites", kind = "list", record = "sat_id", limit = 800},
}}
records.states = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "satellites", kind = "list", record = "sat_state", limit = 800},
}}
records.poll_elements = {fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "frame", kind = "scalar", scalar = "u8", enum = "elements_frame"},
    {name = "method", kind = "scalar", scalar = "u8", enum = "elements_method"},
    {name = "satellites", kind = "list", record = "sat_id", limit = 800},
}}
records.elements = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "frame", kind = "scalar", scalar = "u8", enum = "elements_frame"},
    {name = "method", kind = "scalar", scalar = "u8", enum = "elements_method"},
    {name = "satellites", kind = "list", record = "sat_elements", limit = 800},
}}
records.poll_navdata = {fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "satellites", kind = "list", record = "sat_id", limit = 800},
    {name = "kinds", kind = "scalar", scalar = "u32", bits = "nav_messages"},
    {name = "form", kind = "scalar", scalar = "u8", enum = "nav_form"},
}}
records.navdata = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "satellites", kind = "list", record = "sat_navdata", limit = 800},
}}
records.poll_delays = {fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "receiver_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "carriers_hz", kind = "list", scalar = "f64", limit = 4, unit = "Hz"},
    {name = "satellites", kind = "list", record = "sat_id", limit = 800},
}}
records.delays = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "receiver_m", kind = "array", scalar = "f64", length = 3, show = "place", unit = "m"},
    {name = "carriers_hz", kind = "list", scalar = "f64", limit = 4, unit = "Hz"},
    {name = "satellites", kind = "list", record = "sat_delay", limit = 800},
}}
records.poll_channels = {fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "antenna", kind = "scalar", scalar = "u16"},
    {name = "terms", kind = "scalar", scalar = "u16"},
    {name = "signals", kind = "list", scalar = "u16", limit = 64},
}}
records.channels = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "antenna", kind = "scalar", scalar = "u16"},
    {name = "block", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "length", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "error_m", kind = "scalar", scalar = "f64", unit = "m"},
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, show = "place", unit = "m"},
    {name = "vel_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
    {name = "motion", kind = "scalar", scalar = "u8", enum = "motion_state"},
    {name = "motion_age", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "channels", kind = "list", record = "sat_channel", limit = 4096},
    {name = "terms", kind = "list", record = "channel_terms", limit = 4096},
    {name = "jammers", kind = "list", record = "jammer", limit = 16},
}}
records.poll_imu = {size = 22, smallest = 22, fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "unit", kind = "scalar", scalar = "u16"},
}}
records.imu = {size = 76, smallest = 76, fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "t1", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "unit", kind = "scalar", scalar = "u16"},
    {name = "readings", kind = "scalar", scalar = "u8", enum = "readings"},
    {name = "dtheta_rad", kind = "array", scalar = "f64", length = 3, unit = "rad"},
    {name = "dv_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
}}
records.poll_truth = {size = 22, smallest = 22, fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
    {name = "unit", kind = "scalar", scalar = "u16"},
}}
records.truth = {size = 219, smallest = 219, fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "unit", kind = "scalar", scalar = "u16"},
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "vel_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
    {name = "acc_mps2", kind = "array", scalar = "f64", length = 3, unit = "m/s2"},
    {name = "attitude", kind = "array", scalar = "f64", length = 4},
    {name = "heading_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "pitch_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "roll_rad", kind = "scalar", scalar = "f64", unit = "rad"},
    {name = "rate_radps", kind = "array", scalar = "f64", length = 3, unit = "rad/s"},
    {name = "force_mps2", kind = "array", scalar = "f64", length = 3, unit = "m/s2"},
    {name = "disturbance_mgal", kind = "scalar", scalar = "f64", unit = "mGal"},
    {name = "eotvos_mgal", kind = "scalar", scalar = "f64", unit = "mGal"},
    {name = "vertical_mps2", kind = "scalar", scalar = "f64", unit = "m/s2"},
}}
records.subscribe = {fields = {
    {name = "request", kind = "scalar", scalar = "u16", show = "message"},
    {name = "pacing", kind = "scalar", scalar = "u8", enum = "pacing"},
    {name = "delivery", kind = "scalar", scalar = "u8", enum = "delivery"},
    {name = "credit", kind = "scalar", scalar = "u32"},
    {name = "lead", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "poll", kind = "bytes", limit = 16384},
    {name = "port", kind = "scalar", scalar = "u16"},
}}
records.subscribed = {size = 20, smallest = 20, fields = {
    {name = "first", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "step", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "channel", kind = "scalar", scalar = "u32"},
}}
records.unsubscribe = {size = 4, smallest = 4, fields = {
    {name = "stream", kind = "scalar", scalar = "u32"},
}}
records.credit = {size = 8, smallest = 8, fields = {
    {name = "stream", kind = "scalar", scalar = "u32"},
    {name = "blocks", kind = "scalar", scalar = "u32"},
}}
records.gap = {size = 21, smallest = 21, fields = {
    {name = "first", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "last", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "blocks", kind = "scalar", scalar = "u32"},
    {name = "reason", kind = "scalar", scalar = "u8", enum = "gap_reason"},
}}
records.stream_end = {fields = {
    {name = "next", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "reason", kind = "scalar", scalar = "u8", enum = "end_reason"},
    {name = "sentence", kind = "string", limit = 200},
}}
records.control = {fields = {
    {name = "action", kind = "scalar", scalar = "u8", enum = "control_action"},
    {name = "reference", kind = "scalar", scalar = "u8", enum = "clock_reference"},
    {name = "reserved", kind = "scalar", scalar = "u16"},
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "at", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "delay", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "scenario", kind = "string", limit = 64},
}}
records.get_time = {size = 4, smallest = 4, fields = {
    {name = "reserved", kind = "scalar", scalar = "u32"},
}}
records.time = {size = 118, smallest = 118, fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "state", kind = "scalar", scalar = "u8", enum = "clock_state"},
    {name = "reference", kind = "scalar", scalar = "u8", enum = "clock_reference"},
    {name = "week", kind = "scalar", scalar = "i32"},
    {name = "tow", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "leap", kind = "struct", record = "leap_seconds"},
    {name = "utc_mjd", kind = "scalar", scalar = "i32", unit = "d"},
    {name = "n4", kind = "scalar", scalar = "u16"},
    {name = "nt", kind = "scalar", scalar = "u16"},
    {name = "utc_su", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "pps0", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "host", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "wall", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "error_ns", kind = "scalar", scalar = "f64", unit = "ns"},
    {name = "rate", kind = "scalar", scalar = "f64"},
    {name = "wander_ns", kind = "scalar", scalar = "f64", unit = "ns"},
    {name = "samples", kind = "scalar", scalar = "u64"},
    {name = "steps", kind = "scalar", scalar = "u32"},
    {name = "suspends", kind = "scalar", scalar = "u32"},
    {name = "sets", kind = "scalar", scalar = "u32"},
}}
records.radio_time = {size = 17, smallest = 17, fields = {
    {name = "elapsed", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "stamp", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
    {name = "clock", kind = "scalar", scalar = "u8", enum = "stamp_clock"},
}}
records.pace = {size = 48, smallest = 48, fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "error_ns", kind = "scalar", scalar = "f64", unit = "ns"},
    {name = "rate", kind = "scalar", scalar = "f64"},
    {name = "wander_ns", kind = "scalar", scalar = "f64", unit = "ns"},
    {name = "made", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "until_air", kind = "scalar", scalar = "i64", show = "duration", unit = "ns"},
}}
records.motion = {size = 212, smallest = 212, fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "order", kind = "scalar", scalar = "u8"},
    {name = "angular_order", kind = "scalar", scalar = "u8"},
    {name = "point", kind = "scalar", scalar = "u8", enum = "motion_point"},
    {name = "snap", kind = "scalar", scalar = "u8"},
    {name = "pos_m", kind = "array", scalar = "f64", length = 3, unit = "m"},
    {name = "vel_mps", kind = "array", scalar = "f64", length = 3, unit = "m/s"},
    {name = "acc_mps2", kind = "array", scalar = "f64", length = 3, unit = "m/s2"},
    {name = "jerk_mps3", kind = "array", scalar = "f64", length = 3, unit = "m/s3"},
    {name = "attitude", kind = "array", scalar = "f64", length = 4},
    {name = "rate_radps", kind = "array", scalar = "f64", length = 3, unit = "rad/s"},
    {name = "rate2_radps2", kind = "array", scalar = "f64", length = 3, unit = "rad/s2"},
    {name = "rate3_radps3", kind = "array", scalar = "f64", length = 3, unit = "rad/s3"},
}}
records.get_motion_stats = {size = 1, smallest = 1, fields = {
    {name = "reset", kind = "scalar", scalar = "u8"},
}}
records.motion_stats = {size = 163, smallest = 163, fields = {
    {name = "received", kind = "scalar", scalar = "u64"},
    {name = "used", kind = "scalar", scalar = "u64"},
    {name = "late", kind = "scalar", scalar = "u64"},
    {name = "early", kind = "scalar", scalar = "u64"},
    {name = "dropped", kind = "scalar", scalar = "u64"},
    {name = "overtaken", kind = "scalar", scalar = "u64"},
    {name = "blocks", kind = "scalar", scalar = "u64"},
    {name = "extrapolated", kind = "scalar", scalar = "u64"},
    {name = "joined", kind = "scalar", scalar = "u64"},
    {name = "snapped", kind = "scalar", scalar = "u64"},
    {name = "lateness", kind = "struct", record = "motion_spread"},
    {name = "margin", kind = "struct", record = "motion_spread"},
    {name = "buffered", kind = "scalar", scalar = "u16"},
    {name = "worst", kind = "scalar", scalar = "u8", enum = "motion_state"},
}}
records.poll_events = {size = 20, smallest = 20, fields = {
    {name = "epochs", kind = "struct", record = "epochs"},
}}
records.events = {fields = {
    {name = "epoch", kind = "struct", record = "epoch"},
    {name = "t1", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "events", kind = "list", record = "event", limit = 8192},
}}
records.open_datagrams = {size = 4, smallest = 4, fields = {
    {name = "reserved", kind = "scalar", scalar = "u32"},
}}
records.datagrams = {fields = {
    {name = "channel", kind = "scalar", scalar = "u32"},
    {name = "port", kind = "scalar", scalar = "u16"},
    {name = "seal", kind = "scalar", scalar = "u8", enum = "seal"},
    {name = "reserved", kind = "scalar", scalar = "u8"},
    {name = "taken", kind = "scalar", scalar = "u64"},
    {name = "replayed", kind = "scalar", scalar = "u64"},
    {name = "refused", kind = "scalar", scalar = "u64"},
    {name = "keys", kind = "bytes", limit = 64},
}}
records.open_motion_ring = {size = 4, smallest = 4, fields = {
    {name = "reserved", kind = "scalar", scalar = "u32"},
}}
records.motion_ring = {size = 24, smallest = 24, fields = {
    {name = "slots", kind = "scalar", scalar = "u32"},
    {name = "stride", kind = "scalar", scalar = "u32"},
    {name = "taken", kind = "scalar", scalar = "u64"},
    {name = "lost", kind = "scalar", scalar = "u64"},
}}
records.get_modes = {size = 8, smallest = 8, fields = {
    {name = "after", kind = "scalar", scalar = "u64"},
}}
records.modes = {fields = {
    {name = "t", kind = "scalar", scalar = "i64", show = "time", unit = "ns"},
    {name = "last", kind = "scalar", scalar = "u64"},
    {name = "lost", kind = "scalar", scalar = "u64"},
    {name = "more", kind = "scalar", scalar = "u8"},
    {name = "changes", kind = "list", record = "mode_change", limit = 100},
}}
local messages = {
  [1] = {name = "HELLO", record = "hello", from = "client", answer = "CAPS"},
  [2] = {name = "CAPS", record = "caps", from = "server"},
  [3] = {name = "PING", record = "ping", from = "client", answer = "PONG"},
  [4] = {name = "PONG", record = "pong", from = "server"},
  [5] = {name = "ERROR", record = "error", from = "server"},
  [6] = {name = "POLL", record = "poll", from = "client", answer = "STATES"},
  [7] = {name = "STATES", record = "states", from = "server"},
  [8] = {name = "POLL_ELEMENTS", record = "poll_elements", from = "client", answer = "ELEMENTS"},
  [9] = {name = "ELEMENTS", record = "elements", from = "server"},
  [10] = {name = "POLL_NAVDATA", record = "poll_navdata", from = "client", answer = "NAVDATA"},
  [11] = {name = "NAVDATA", record = "navdata", from = "server"},
  [12] = {name = "POLL_DELAYS", record = "poll_delays", from = "client", answer = "DELAYS"},
  [13] = {name = "DELAYS", record = "delays", from = "server"},
  [14] = {name = "POLL_CHANNELS", record = "poll_channels", from = "client", answer = "CHANNELS"},
  [15] = {name = "CHANNELS", record = "channels", from = "server"},
  [16] = {name = "POLL_IMU", record = "poll_imu", from = "client", answer = "IMU"},
  [17] = {name = "IMU", record = "imu", from = "server"},
  [18] = {name = "POLL_TRUTH", record = "poll_truth", from = "client", answer = "TRUTH"},
  [19] = {name = "TRUTH", record = "truth", from = "server"},
  [20] = {name = "SUBSCRIBE", record = "subscribe", from = "client", answer = "SUBSCRIBED"},
  [21] = {name = "SUBSCRIBED", record = "subscribed", from = "server"},
  [22] = {name = "UNSUBSCRIBE", record = "unsubscribe", from = "client"},
  [23] = {name = "CREDIT", record = "credit", from = "client"},
  [24] = {name = "GAP", record = "gap", from = "server"},
  [25] = {name = "STREAM_END", record = "stream_end", from = "server"},
  [26] = {name = "CONTROL", record = "control", from = "client", answer = "TIME"},
  [27] = {name = "GET_TIME", record = "get_time", from = "client", answer = "TIME"},
  [28] = {name = "TIME", record = "time", from = "server"},
  [29] = {name = "RADIO_TIME", record = "radio_time", from = "client", answer = "PACE"},
  [30] = {name = "PACE", record = "pace", from = "server"},
  [31] = {name = "MOTION", record = "motion", from = "client"},
  [32] = {name = "GET_MOTION_STATS", record = "get_motion_stats", from = "client", answer = "MOTION_STATS"},
  [33] = {name = "MOTION_STATS", record = "motion_stats", from = "server"},
  [34] = {name = "POLL_EVENTS", record = "poll_events", from = "client", answer = "EVENTS"},
  [35] = {name = "EVENTS", record = "events", from = "server"},
  [36] = {name = "OPEN_DATAGRAMS", record = "open_datagrams", from = "client", answer = "DATAGRAMS"},
  [37] = {name = "DATAGRAMS", record = "datagrams", from = "server"},
  [38] = {name = "OPEN_MOTION_RING", record = "open_motion_ring", from = "client", answer = "MOTION_RING"},
  [39] = {name = "MOTION_RING", record = "motion_ring", from = "server"},
  [40] = {name = "GET_MODES", record = "get_modes", from = "client", answer = "MODES"},
  [41] = {name = "MODES", record = "modes", from = "server"},
}
local message_names = {}
for number, message in pairs(messages) do message_names[number] = message.name end

-- Everything above this line is generated from the message specification; everything below it is proto/spec/dissector.lua, which
-- shows frames by those tables.
local f = {}          -- fields of the frame, by name
local shown = {}      -- fields of records: shown[record][field]
local SIZE = {u8 = 1, u16 = 2, u32 = 4, u64 = 8, i8 = 1, i16 = 2, i32 = 4, i64 = 8, f32 = 4, f64 = 8}
local MAKE = {u8 = "uint8", u16 = "uint16", u32 = "uint32", u64 = "uint64", i8 = "int8", i16 = "int16", i32 = "int32",
              i64 = "int64", f32 = "float", f64 = "double"}
local HEADER, OVERHEAD = 16, 20

-- ---- bits: the library of Lua 5.2, that of Wireshark, or the operators of Lua 5.3 and later
local band, bxor, rshift
if bit32 or bit then
  local library = bit32 or bit
  band, bxor, rshift = library.band, library.bxor, library.rshift
else
  band = load("return function(a, b) return a & b end")()
  bxor = load("return function(a, b) return a ~ b end")()
  rshift = load("return function(a, n) return a >> n end")()
end
local function has(value, b) return math.floor(value / 2 ^ b) % 2 == 1 end

local crc_table = {}
for i = 0, 255 do
  local v = i
  for _ = 1, 8 do
    if v % 2 == 1 then v = bxor(rshift(v, 1), 0xEDB88320) else v = rshift(v, 1) end
  end
  crc_table[i] = v
end
local function crc32(range)
  local raw, crc = range:raw(), 0xFFFFFFFF
  for i = 1, #raw do crc = bxor(crc_table[band(bxor(crc, raw:byte(i)), 0xFF)], rshift(crc, 8)) end
  return bxor(crc, 0xFFFFFFFF) % 4294967296
end

-- ---- fields and marks
local function declare(record, field)
  local path = "orrery." .. record .. "." .. field.name
  local label = field.unit and not field.name:find(field.unit, 1, true) and (field.name .. " [" .. field.unit .. "]") or field.name
  if field.show == "time" then label = field.name .. " [ns of GPS time]" end
  local made = {}
  if field.kind == "string" or field.kind == "bytes" then
    made.field = ProtoField[field.kind](path, label)
  elseif field.scalar then
    local make = ProtoField[MAKE[field.scalar]]
    local names = field.enum and enums[field.enum] or field.show == "message" and message_names or nil
    if names then
      made.field = make(path, label, base.DEC, names)
    elseif field.bits then
      made.field, made.bits = make(path, label, base.HEX), {}
      for _, b in ipairs(bitsets[field.bits]) do
        made.bits[#made.bits + 1] = ProtoField.bool(path .. "." .. b.name:lower(), b.name, 8 * SIZE[field.scalar], nil, 2 ^ b.bit)
      end
    elseif field.show == "hex" then
      made.field = make(path, label, base.HEX)
    else
      made.field = make(path, label)
    end
  end
  if field.kind == "list" then made.count = ProtoField.uint16(path .. ".count", field.name .. " (count)") end
  return made
end

f.major = ProtoField.uint8("orrery.major", "Major version")
f.minor = ProtoField.uint8("orrery.minor", "Minor version")
f.type = ProtoField.uint16("orrery.type", "Type", base.DEC, message_names)
f.sequence = ProtoField.uint32("orrery.sequence", "Sequence")
f.length = ProtoField.uint32("orrery.length", "Payload length")
f.payload = ProtoField.bytes("orrery.payload", "Payload")
f.crc = ProtoField.uint32("orrery.crc", "CRC-32", base.HEX)
f.trailing = ProtoField.bytes("orrery.trailing", "Bytes after the last known field")
f.no_frame = ProtoField.bytes("orrery.no_frame", "Bytes that are no frame")
f.sat = ProtoField.string("orrery.sat", "Satellite")
f.time = ProtoField.string("orrery.time", "Time (GPS)")
f.request_in = ProtoField.framenum("orrery.request_in", "Request in", base.NONE, frametype.REQUEST)
f.response_in = ProtoField.framenum("orrery.response_in", "Answer in", base.NONE, frametype.RESPONSE)
f.last_response_in = ProtoField.framenum("orrery.last_response_in", "Last answer in", base.NONE, frametype.RESPONSE)
f.responses = ProtoField.uint32("orrery.responses", "Frames of the answer")
f.response_time = ProtoField.relative_time("orrery.response_time", "Time since the request")

local registered = {}
for _, field in pairs(f) do registered[#registered + 1] = field end
for name, record in pairs(records) do
  shown[name] = {}
  for _, field in ipairs(record.fields) do
    local made = declare(name, field)
    shown[name][field.name] = made
    if made.field then registered[#registered + 1] = made.field end
    if made.count then registered[#registered + 1] = made.count end
    for _, b in ipairs(made.bits or {}) do registered[#registered + 1] = b end
  end
end
orrery.fields = registered

local function mark(name, text, group, severity)
  return ProtoExpert.new("orrery.expert." .. name, text, expert.group[group], expert.severity[severity])
end
local e = {
  crc = mark("crc", "checksum does not match", "CHECKSUM", "ERROR"),
  magic = mark("magic", "bytes that are no frame of this protocol", "MALFORMED", "ERROR"),
  length = mark("length", "payload length above the limit", "MALFORMED", "ERROR"),
  major = mark("major", "a major version that this dissector does not know", "PROTOCOL", "ERROR"),
  cut = mark("cut", "cut", "MALFORMED", "ERROR"),
  count = mark("count", "impossible count", "MALFORMED", "ERROR"),
  trailing = mark("trailing", "bytes after the last known field", "UNDECODED", "NOTE"),
  type = mark("type", "unknown message type", "UNDECODED", "WARN"),
  value = mark("value", "a value that this version does not know", "UNDECODED", "NOTE"),
  satellite = mark("satellite", "no satellite", "PROTOCOL", "WARN"),
  refused = mark("refused", "the request was refused", "RESPONSE_CODE", "WARN"),
  unasked = mark("unasked", "its request is not in this capture", "SEQUENCE", "NOTE"),
  unanswered = mark("unanswered", "its answer is not in this capture", "SEQUENCE", "NOTE"),
  mismatch = mark("mismatch", "it does not answer the request of this sequence number", "SEQUENCE", "WARN"),
}
local marks = {}
for _, one in pairs(e) do marks[#marks + 1] = one end
orrery.experts = marks

-- ---- values as text
local NS = Int64.new(1000000000)
-- Whole seconds (rounded down) and nanoseconds of an Int64.
local function split(value)
  local s, ns = (value / NS):tonumber(), (value % NS):tonumber()
  if ns < 0 then s, ns = s - 1, ns + 1000000000 end
  return s, ns
end
local function decimals(ns) return ns == 0 and "" or (string.format(".%09d", ns):gsub("0+$", "")) end

-- Date and time of day of an instant, GPS scale; nil for "no instant".
local function time_text(value)
  if tostring(value) == "-9223372036854775808" then return nil end
  local s, ns = split(value)
  local days = math.floor(s / 86400)
  local rest = s - 86400 * days
  -- Gregorian calendar from days since 0000-03-01: years begin in March, so that a leap day is a year's last.
  local z = days + 723125
  local era = math.floor(z / 146097)
  local day_of_era = z - era * 146097
  local year_of_era = math.floor((day_of_era - math.floor(day_of_era / 1460) + math.floor(day_of_era / 36524) -
                                  math.floor(day_of_era / 146096)) / 365)
  local day_of_year = day_of_era - (365 * year_of_era + math.floor(year_of_era / 4) - math.floor(year_of_era / 100))
  local march = math.floor((5 * day_of_year + 2) / 153)
  local day = day_of_year - math.floor((153 * march + 2) / 5) + 1
  local month = march < 10 and march + 3 or march - 9
  local year = year_of_era + era * 400 + (month <= 2 and 1 or 0)
  return string.format("%04d-%02d-%02dT%02d:%02d:%02d%s", year, month, day, math.floor(rest / 3600), math.floor(rest / 60) % 60,
                       rest % 60, decimals(ns))
end

local function duration_text(value)
  local s, ns = split(value)
  if s >= 0 then return string.format("%d%s s", s, decimals(ns)) end
  if ns > 0 then s, ns = s + 1, 1000000000 - ns end
  return string.format("-%d%s s", -s, decimals(ns))
end

-- ---- a reader over a range that stops at its end
local function reader(tvb, at, stop) return {tvb = tvb, at = at, stop = stop} end
local function left(r) return r.stop - r.at end
local function cut(r, tree, what, wanted)
  tree:add_proto_expert_info(e.cut, string.format("%s is cut: %d bytes wanted, %d there", what, wanted, left(r)))
  return false
end
local function take(r, n)
  r.at = r.at + n
  return r.tvb(r.at - n, n)
end

local function read_integer(range, scalar)
  if scalar == "i64" then return range:le_int64() end
  if scalar == "u64" then return range:le_uint64() end
  return scalar:sub(1, 1) == "i" and range:le_int() or range:le_uint()
end

-- One number; returns true and its value if it is an integer of at most 32 bits.
local function show_scalar(r, tree, record, field, info)
  local n = SIZE[field.scalar]
  if left(r) < n then return cut(r, tree, field.name, n) end
  local range, own = take(r, n), shown[record][field.name]
  local item = tree:add_le(own.field, range)
  if field.scalar:sub(1, 1) == "f" then return true end
  local value = read_integer(range, field.scalar)
  if field.show == "time" then
    local text = time_text(value)
    item:set_text(field.name .. ": " .. (text and text .. " GPS" or "no instant") .. " (" .. tostring(value) .. " ns)")
    if info and text and not info.time then
      info.time = text .. " GPS"
      tree:add(f.time, range, text):set_generated()
    end
  elseif field.show == "duration" then
    item:set_text(field.name .. ": " .. duration_text(value) .. " (" .. tostring(value) .. " ns)")
    if info then info.step = duration_text(value) end
  elseif field.show == "char" then
    item:append_text(value >= 32 and value < 127 and " ('" .. string.char(value) .. "')" or "")
  elseif field.bits then
    local names, known = {}, 0
    for k, b in ipairs(bitsets[field.bits]) do
      item:add_le(own.bits[k], range)
      known = known + 2 ^ b.bit
      if has(value, b.bit) then names[#names + 1] = b.name end
    end
    if #names > 0 then item:append_text(" (" .. table.concat(names, ", ") .. ")") end
    for b = 0, 8 * n - 1 do
      if has(value, b) and not has(known, b) then item:add_proto_expert_info(e.value, "bit " .. b .. " is not known") end
    end
  elseif field.enum and not enums[field.enum][value] then
    item:add_proto_expert_info(e.value, field.name .. " " .. value .. " is not known")
  end
  if info and type(value) == "number" then
    info[field.name] = value
    if field.enum == "error_code" then info.error = enums.error_code[value] or "error " .. value end
  end
  return true, value
end

local function show_text(r, tree, record, field, info)
  if left(r) < 2 then return cut(r, tree, field.name, 2) end
  local own, size = shown[record][field.name].field, take(r, 2)
  local n = size:le_uint()
  if n > field.limit then
    tree:add_proto_expert_info(e.count, string.format("%s: %d bytes, at most %d are allowed", field.name, n, field.limit))
    return false
  end
  if left(r) < n then return cut(r, tree, field.name, n) end
  if n == 0 then
    tree:add(own, size, "")
  elseif field.kind == "bytes" then
    tree:add(own, take(r, n))
  else
    local range = take(r, n)
    tree:add_packet_field(own, range, ENC_UTF_8)
    if info then info[field.name] = range:string(ENC_UTF_8) end
  end
  return true
end

local function show_satellite(r, tree, label)
  if left(r) < 2 then return cut(r, tree, label, 2) end
  local range = take(r, 2)
  local letter, number = range(0, 1):uint(), range(1, 1):uint()
  local good = letter >= 65 and letter <= 90 and number >= 1 and number <= 99
  local name = good and string.format("%c%02d", letter, number) or string.format("0x%02x, %d", letter, number)
  local item = tree:add(f.sat, range, name)
  item:set_text(label .. ": " .. name)
  if not good then item:add_proto_expert_info(e.satellite, label .. ": a letter and a number of 1 to 99 are wanted") end
  return true, name
end

local show_record

local function show_list(r, tree, record, field, info)
  local element = field.record and records[field.record]
  local fixed = field.scalar and SIZE[field.scalar] or element.size
  local head = fixed and 4 or 2
  if left(r) < head then return cut(r, tree, field.name, head) end
  local range = take(r, head)
  local count, stride = range(0, 2):le_uint(), fixed and range(2, 2):le_uint()
  local list = tree:add_le(shown[record][field.name].count, range(0, 2))
  list:set_text(field.name .. ": " .. count)
  if info then info.lists[#info.lists + 1] = {field.name, count} end
  local wrong
  if count > field.limit then
    wrong = string.format("%s: %d of them, at most %d are allowed", field.name, count, field.limit)
  elseif count * (stride or 2) > left(r) then
    wrong = string.format("%s: %d of %d bytes, but %d bytes are left", field.name, count, stride or 2, left(r))
  elseif fixed and count > 0 and stride < (element and element.smallest or fixed) then
    wrong = string.format("%s: records of %d bytes, %d are wanted", field.name, stride, element and element.smallest or fixed)
  end
  if wrong then
    list:add_proto_expert_info(e.count, wrong)
    return false
  end
  for k = 1, count do
    local n, label = stride, field.name .. " " .. k
    if not n then
      if left(r) < 2 then return cut(r, list, label, 2) end
      n = take(r, 2):le_uint()
      if left(r) < n then return cut(r, list, label, n) end
    end
    local from = r.at
    r.at = r.at + n
    local one = reader(r.tvb, from, r.at)
    if field.scalar then
      show_scalar(one, list, record, field)
    elseif element.satellite then
      show_satellite(one, list, label)
    else
      local branch = list:add(r.tvb(from, n), label)
      show_record(one, branch, field.record, nil, branch)
    end
  end
  return true
end

-- The fields of a record or message, in order. heading: the item that is to tell the satellite and its answer, if there is one.
-- Returns false where the rest could not be read.
function show_record(r, tree, name, info, heading, inner)
  local values = {}
  for _, field in ipairs(records[name].fields) do
    if not field.when or has(values[field.when[1]] or 0, field.when[2]) then
      if field.since and left(r) == 0 then break end -- the sender is of an older minor version
      local good, value = true, nil
      if field.kind == "scalar" then
        good, value = show_scalar(r, tree, name, field, info)
      elseif field.kind == "array" then
        for _ = 1, field.length do good = good and show_scalar(r, tree, name, field) end
      elseif field.kind == "struct" then
        local element = records[field.record]
        if element.satellite then
          good, value = show_satellite(r, tree, field.name)
          if good and heading then heading:append_text(": " .. value) end
        elseif element.spread then
          good = show_record(r, tree, field.record, info, nil, true)
        else
          good = show_record(r, tree:add(r.tvb(r.at, math.min(left(r), element.size or 0)), field.name), field.record, nil, nil, true)
        end
      elseif field.kind == "list" then
        good = show_list(r, tree, name, field, info)
      else
        good = show_text(r, tree, name, field, info)
      end
      if not good then return false end
      if field.kind == "scalar" then values[field.name] = value end
      if heading and field.enum == "answer" and value ~= 0 then
        heading:append_text(", " .. (enums.answer[value] or "answer " .. value))
      end
    end
  end
  if not inner and left(r) > 0 then
    local range = take(r, left(r))
    tree:add(f.trailing, range):add_proto_expert_info(e.trailing, range:len() .. " bytes after the last known field of " .. name)
  end
  return true
end

-- ---- requests and their answers
local streams, links = {}, {} -- by both ends and sequence number; by the place of a frame
function orrery.init() streams, links = {}, {} end

-- On the first pass: the transaction that a frame belongs to, or nil. (Not by tcp.stream: in tshark's first pass of two there is
-- no tree to read it from.)
local function link(pinfo, type, sequence)
  local message = messages[type]
  local from_client = message.from == "client"
  local source, sink = tostring(pinfo.src) .. "/" .. pinfo.src_port, tostring(pinfo.dst) .. "/" .. pinfo.dst_port
  local id = from_client and source .. ">" .. sink or sink .. ">" .. source
  streams[id] = streams[id] or {}
  if from_client then
    if message.answer then
      streams[id][sequence] = {request = pinfo.number, at = pinfo.rel_ts, answer = message.answer, count = 0}
    end
    return streams[id][sequence]
  end
  local found = streams[id][sequence]
  if found then
    found.count = found.count + 1
    found.first = found.first or pinfo.number
    found.last = pinfo.number
  end
  return found
end

local function show_links(tvb, pinfo, tree, type, sequence)
  local key = table.concat({pinfo.number, tvb:offset(), type, sequence}, "/")
  if not pinfo.visited then links[key] = link(pinfo, type, sequence) end
  local found = links[key]
  if messages[type].from == "client" then
    if found and found.first then
      tree:add(f.response_in, found.first):set_generated()
      if found.count > 1 then
        tree:add(f.last_response_in, found.last):set_generated()
        tree:add(f.responses, found.count):set_generated()
      end
    elseif found and pinfo.visited then
      tree:add_proto_expert_info(e.unanswered)
    end
  elseif found then
    tree:add(f.request_in, found.request):set_generated()
    local passed = math.max(0, pinfo.rel_ts - found.at)
    local s = math.floor(passed)
    tree:add(f.response_time, NSTime.new(s, math.floor((passed - s) * 1e9 + 0.5))):set_generated()
    if messages[type].name ~= found.answer and messages[type].name ~= "ERROR" then
      tree:add_proto_expert_info(e.mismatch, "a request that " .. found.answer .. " answers has this sequence number")
    end
  elseif sequence ~= 0 then
    tree:add_proto_expert_info(e.unasked)
  end
end

-- ---- frames
local function info_text(name, sequence, info)
  local words = {name .. " seq=" .. sequence}
  if info.time then words[#words + 1] = info.time end
  if info.count and info.index then
    words[#words + 1] = (info.index + 1) .. " of " .. info.count
  elseif info.count then
    words[#words + 1] = info.count .. (info.count == 1 and " epoch" or " epochs")
    if info.step and info.count > 1 then words[#words + 1] = "step " .. info.step end
  end
  if info.answer and info.answer ~= 0 then words[#words + 1] = enums.answer[info.answer] or "answer " .. info.answer end
  for _, list in ipairs(info.lists) do
    if list[2] > 0 then words[#words + 1] = list[2] .. " " .. list[1] end
  end
  if info.error then
    words[#words + 1] = info.error .. (info.sentence and ": " .. info.sentence or "")
  end
  for _, word in ipairs(info.marks) do words[#words + 1] = "[" .. word .. "]" end
  return table.concat(words, ", ")
end

local function tell(pinfo, text)
  pinfo.cols.protocol = PROTOCOL
  if pinfo.private.orrery_frames then
    pinfo.cols.info:append(" | " .. text)
  else
    pinfo.cols.info:set(text)
    pinfo.private.orrery_frames = "1"
  end
end

local function no_frame(tvb, pinfo, tree)
  local branch = tree:add(orrery, tvb(), PROTOCOL .. " (no frame)")
  branch:add(f.no_frame, tvb()):add_proto_expert_info(e.magic)
  tell(pinfo, "[" .. tvb:len() .. " bytes that are no frame]")
end

-- A frame, of which bytes may be missing at the end. tvb holds nothing but it.
local function one_frame(tvb, pinfo, tree)
  local there = tvb:len()
  local number, sequence, size = tvb(6, 2):le_uint(), tvb(8, 4):le_uint(), tvb(12, 4):le_uint()
  local message = messages[number]
  local name, info = message and message.name or "type " .. number, {lists = {}, marks = {}}
  local branch = tree:add(orrery, tvb(), PROTOCOL .. " " .. name .. ", sequence " .. sequence)
  local major = branch:add(f.major, tvb(4, 1))
  branch:add(f.minor, tvb(5, 1))
  local kind = branch:add_le(f.type, tvb(6, 2))
  branch:add_le(f.sequence, tvb(8, 4))
  local length = branch:add_le(f.length, tvb(12, 4))
  local stop, whole = math.min(HEADER + size, there), there >= OVERHEAD + size
  local sound = whole and crc32(tvb(0, HEADER + size)) == tvb(HEADER + size, 4):le_uint()

  if size > MAX_PAYLOAD then
    length:add_proto_expert_info(e.length, "a payload of " .. size .. " bytes, at most " .. MAX_PAYLOAD .. " are allowed")
    info.marks[1] = "length " .. size .. " above the limit"
  elseif tvb(4, 1):uint() ~= MAJOR then
    major:add_proto_expert_info(e.major, "major version " .. tvb(4, 1):uint() .. ": this dissector knows " .. MAJOR)
    info.marks[1] = "major version " .. tvb(4, 1):uint()
    if stop > HEADER then branch:add(f.payload, tvb(HEADER, stop - HEADER)) end
  elseif not message then
    kind:add_proto_expert_info(e.type)
    info.marks[1] = "unknown message type"
    if stop > HEADER then branch:add(f.payload, tvb(HEADER, stop - HEADER)) end
  else
    if sound then show_links(tvb, pinfo, branch, number, sequence) end
    if not show_record(reader(tvb, HEADER, stop), branch, message.record, info) then info.marks[1] = "malformed" end
    if info.error then branch:add_proto_expert_info(e.refused, info.error .. ": " .. (info.sentence or "")) end
  end
  if size <= MAX_PAYLOAD and not whole then
    branch:add_proto_expert_info(e.cut, "the frame is cut: " .. (OVERHEAD + size) .. " bytes wanted, " .. there .. " there")
    info.marks[#info.marks + 1] = "cut"
  elseif whole then
    local sum = branch:add_le(f.crc, tvb(HEADER + size, 4))
    if not sound then
      sum:add_proto_expert_info(e.crc)
      info.marks[#info.marks + 1] = "checksum"
    end
  end
  tell(pinfo, info_text(name, sequence, info))
end

-- Where the next frame may begin: the next magic, whole or cut off by the end.
local function next_magic(raw, from)
  local at = raw:find(MAGIC, from, true)
  if at then return at end
  for n = math.min(#MAGIC - 1, #raw - from + 1), 1, -1 do
    if raw:sub(-n) == MAGIC:sub(1, n) then return #raw - n + 1 end
  end
  return #raw + 1
end

local function dissect(tvb, pinfo, tree)
  local total, at, raw = tvb:len(), 0, nil
  local whole = tvb:reported_len() == total
  local function wait(n) -- asks for n more bytes; false where there will be none
    if not (whole and pinfo.can_desegment > 0) then return false end
    pinfo.desegment_offset, pinfo.desegment_len = at, n
    return true
  end
  while at < total do
    local there = math.min(#MAGIC, total - at)
    if tvb(at, there):raw() ~= MAGIC:sub(1, there) then
      raw = raw or tvb:raw()
      local stop = next_magic(raw, at + 2) - 1
      no_frame(tvb(at, stop - at):tvb(), pinfo, tree)
      at = stop
    elseif total - at < HEADER then
      if wait(DESEGMENT_ONE_MORE_SEGMENT) then return total end
      no_frame(tvb(at, total - at):tvb(), pinfo, tree)
      at = total
    else
      local size = tvb(at + 12, 4):le_uint()
      local wanted = size > MAX_PAYLOAD and HEADER or OVERHEAD + size
      if total - at < wanted and wait(wanted - (total - at)) then return total end
      wanted = math.min(wanted, total - at)
      one_frame(tvb(at, wanted):tvb(), pinfo, tree)
      at = at + wanted
    end
  end
  return total
end

function orrery.dissector(tvb, pinfo, tree) return dissect(tvb, pinfo, tree) end
DissectorTable.get("tcp.port"):add(PORT, orrery)
-- On any other port: a conversation that begins with the magic and a version is this protocol.
orrery:register_heuristic("tcp", function(tvb, pinfo, tree)
  if tvb:len() < HEADER or tvb(0, #MAGIC):raw() ~= MAGIC or tvb(4, 1):uint() ~= MAJOR then return false end
  pinfo.conversation = orrery
  dissect(tvb, pinfo, tree)
  return true
end)
