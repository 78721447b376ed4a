-- SPDX-License-Identifier: MIT
-- Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
-- Wireshark dissector of Orrery, protocol 1.0, TCP port 15754.
local orrery = Proto("orrery", "Orrery satellite states")
local f = orrery.fields

local crc_table = {}
for i = 0, 255 do
  local v = i
  for _ = 1, 8 do
    if v % 2 == 1 then v = bit.bxor(bit.rshift(v, 1), 0xEDB88320) else v = bit.rshift(v, 1) end
  end
  crc_table[i] = v
end
local function crc32(tvb)
  local raw, crc = tvb:raw(), 0xFFFFFFFF
  for i = 1, #raw do crc = bit.bxor(crc_table[bit.band(bit.bxor(crc, raw:byte(i)), 0xFF)], bit.rshift(crc, 8)) end
  return bit.band(bit.bnot(crc), 0xFFFFFFFF) % 4294967296
end

-- A reader over a range that stops at its end: fields that are not there are not shown.
local function reader(tvb, at, stop) return {tvb = tvb, at = at, stop = stop, ok = true} end
local function take(r, n)
  if not r.ok or r.at + n > r.stop then
    r.ok = false
    return nil
  end
  r.at = r.at + n
  return r.tvb(r.at - n, n)
end
local function add(r, tree, field, n)
  local range = take(r, n)
  if range then tree:add_le(field, range) end
  return range
end
local function add_text(r, tree, field)
  local size = take(r, 2)
  if not size then return end
  local n = size:le_uint()
  if n > 0 then
    local range = take(r, n)
    if range then tree:add(field, range) end
  else
    tree:add(field, size, "")
  end
end

local types = {
  [1] = "HELLO",
  [2] = "CAPS",
  [3] = "PING",
  [4] = "PONG",
  [5] = "ERROR",
  [6] = "POLL",
  [7] = "STATES",
  [8] = "POLL_ELEMENTS",
  [9] = "ELEMENTS",
  [10] = "POLL_NAVDATA",
  [11] = "NAVDATA",
  [12] = "POLL_DELAYS",
  [13] = "DELAYS",
  [16] = "POLL_IMU",
  [17] = "IMU",
  [18] = "POLL_TRUTH",
  [19] = "TRUTH",
}
local enum_error_code = {
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
}
local enum_answer = {
  [0] = "OK",
  [1] = "OUTSIDE_SPAN",
  [2] = "NO_ARC",
  [3] = "NOT_SERVED",
  [4] = "BELOW_HORIZON",
  [5] = "NO_VALUE",
}
local enum_nav_message = {
  [0] = "NONE",
  [1] = "LNAV",
  [2] = "FDMA",
}
local enum_elements_frame = {
  [0] = "DATE",
  [1] = "J2000",
  [2] = "ECEF",
}
local enum_elements_method = {
  [0] = "STATE",
  [1] = "THREE_POSITIONS",
  [2] = "MEAN",
}
local enum_orbit_point = {
  [0] = "NONE",
  [1] = "CENTRE_OF_MASS",
  [2] = "PHASE_CENTRE",
}
local enum_receiver_source = {
  [0] = "NONE",
  [1] = "POSITION",
  [2] = "TRAJECTORY",
  [3] = "STATION",
}
local enum_tec_origin = {
  [0] = "FIELD",
  [1] = "FUSED",
  [2] = "TRANSFERRED",
  [3] = "NOISE",
}

f.sat_id_system = ProtoField.char("orrery.sat_id.system", "system")
f.sat_id_number = ProtoField.uint8("orrery.sat_id.number", "number")
f.epochs_t = ProtoField.int64("orrery.epochs.t", "t [ns]")
f.epochs_step = ProtoField.int64("orrery.epochs.step", "step [ns]")
f.epochs_count = ProtoField.uint32("orrery.epochs.count", "count")
f.epoch_t = ProtoField.int64("orrery.epoch.t", "t [ns]")
f.epoch_index = ProtoField.uint32("orrery.epoch.index", "index")
f.epoch_count = ProtoField.uint32("orrery.epoch.count", "count")
f.epoch_answer = ProtoField.uint8("orrery.epoch.answer", "answer", base.DEC, enum_answer)
f.span_first = ProtoField.int64("orrery.span.first", "first [ns]")
f.span_last = ProtoField.int64("orrery.span.last", "last [ns]")
f.served_request_request = ProtoField.uint16("orrery.served_request.request", "request")
f.served_request_answer = ProtoField.uint16("orrery.served_request.answer", "answer")
f.inertial_unit_unit = ProtoField.uint16("orrery.inertial_unit.unit", "unit")
f.inertial_unit_name = ProtoField.string("orrery.inertial_unit.name", "name")
f.inertial_unit_lever_m = ProtoField.double("orrery.inertial_unit.lever_m", "lever_m")
f.inertial_unit_heading_rad = ProtoField.double("orrery.inertial_unit.heading_rad", "heading_rad")
f.inertial_unit_pitch_rad = ProtoField.double("orrery.inertial_unit.pitch_rad", "pitch_rad")
f.inertial_unit_roll_rad = ProtoField.double("orrery.inertial_unit.roll_rad", "roll_rad")
f.leap_seconds_gps_utc_s = ProtoField.int16("orrery.leap_seconds.gps_utc_s", "gps_utc_s")
f.leap_seconds_next_gps_utc_s = ProtoField.int16("orrery.leap_seconds.next_gps_utc_s", "next_gps_utc_s")
f.leap_seconds_next = ProtoField.int64("orrery.leap_seconds.next", "next [ns]")
f.sat_state_answer = ProtoField.uint8("orrery.sat_state.answer", "answer", base.DEC, enum_answer)
f.sat_state_reserved = ProtoField.uint8("orrery.sat_state.reserved", "reserved")
f.sat_state_flags = ProtoField.uint32("orrery.sat_state.flags", "flags", base.HEX)
f.sat_state_pos_m = ProtoField.double("orrery.sat_state.pos_m", "pos_m")
f.sat_state_vel_mps = ProtoField.double("orrery.sat_state.vel_mps", "vel_mps [m/s]")
f.sat_state_acc_mps2 = ProtoField.double("orrery.sat_state.acc_mps2", "acc_mps2 [m/s2]")
f.sat_state_clock_s = ProtoField.double("orrery.sat_state.clock_s", "clock_s")
f.sat_state_clock_rate_sps = ProtoField.double("orrery.sat_state.clock_rate_sps", "clock_rate_sps [s/s]")
f.sat_state_valid_from = ProtoField.int64("orrery.sat_state.valid_from", "valid_from [ns]")
f.sat_state_valid_to = ProtoField.int64("orrery.sat_state.valid_to", "valid_to [ns]")
f.sat_state_sigma_m = ProtoField.float("orrery.sat_state.sigma_m", "sigma_m")
f.sat_elements_answer = ProtoField.uint8("orrery.sat_elements.answer", "answer", base.DEC, enum_answer)
f.sat_elements_reserved = ProtoField.uint8("orrery.sat_elements.reserved", "reserved")
f.sat_elements_flags = ProtoField.uint32("orrery.sat_elements.flags", "flags", base.HEX)
f.sat_elements_a_m = ProtoField.double("orrery.sat_elements.a_m", "a_m")
f.sat_elements_e = ProtoField.double("orrery.sat_elements.e", "e")
f.sat_elements_i_rad = ProtoField.double("orrery.sat_elements.i_rad", "i_rad")
f.sat_elements_raan_rad = ProtoField.double("orrery.sat_elements.raan_rad", "raan_rad")
f.sat_elements_argp_rad = ProtoField.double("orrery.sat_elements.argp_rad", "argp_rad")
f.sat_elements_m_rad = ProtoField.double("orrery.sat_elements.m_rad", "m_rad")
f.sat_elements_u_rad = ProtoField.double("orrery.sat_elements.u_rad", "u_rad")
f.nav_page_t = ProtoField.int64("orrery.nav_page.t", "t [ns]")
f.nav_page_number = ProtoField.uint8("orrery.nav_page.number", "number")
f.nav_page_page = ProtoField.uint8("orrery.nav_page.page", "page")
f.nav_page_bits = ProtoField.uint16("orrery.nav_page.bits", "bits")
f.nav_page_data = ProtoField.bytes("orrery.nav_page.data", "data")
f.lnav_set_sqrt_a_sqrtm = ProtoField.double("orrery.lnav_set.sqrt_a_sqrtm", "sqrt_a_sqrtm [sqrt(m)]")
f.lnav_set_e = ProtoField.double("orrery.lnav_set.e", "e")
f.lnav_set_m0_rad = ProtoField.double("orrery.lnav_set.m0_rad", "m0_rad")
f.lnav_set_i0_rad = ProtoField.double("orrery.lnav_set.i0_rad", "i0_rad")
f.lnav_set_omega0_rad = ProtoField.double("orrery.lnav_set.omega0_rad", "omega0_rad")
f.lnav_set_omega_rad = ProtoField.double("orrery.lnav_set.omega_rad", "omega_rad")
f.lnav_set_delta_n_radps = ProtoField.double("orrery.lnav_set.delta_n_radps", "delta_n_radps [rad/s]")
f.lnav_set_idot_radps = ProtoField.double("orrery.lnav_set.idot_radps", "idot_radps [rad/s]")
f.lnav_set_omega_dot_radps = ProtoField.double("orrery.lnav_set.omega_dot_radps", "omega_dot_radps [rad/s]")
f.lnav_set_cuc_rad = ProtoField.double("orrery.lnav_set.cuc_rad", "cuc_rad")
f.lnav_set_cus_rad = ProtoField.double("orrery.lnav_set.cus_rad", "cus_rad")
f.lnav_set_crc_m = ProtoField.double("orrery.lnav_set.crc_m", "crc_m")
f.lnav_set_crs_m = ProtoField.double("orrery.lnav_set.crs_m", "crs_m")
f.lnav_set_cic_rad = ProtoField.double("orrery.lnav_set.cic_rad", "cic_rad")
f.lnav_set_cis_rad = ProtoField.double("orrery.lnav_set.cis_rad", "cis_rad")
f.lnav_set_tgd_s = ProtoField.double("orrery.lnav_set.tgd_s", "tgd_s")
f.glonass_set_pos_m = ProtoField.double("orrery.glonass_set.pos_m", "pos_m")
f.glonass_set_vel_mps = ProtoField.double("orrery.glonass_set.vel_mps", "vel_mps [m/s]")
f.glonass_set_acc_mps2 = ProtoField.double("orrery.glonass_set.acc_mps2", "acc_mps2 [m/s2]")
f.glonass_set_delta_tau_s = ProtoField.double("orrery.glonass_set.delta_tau_s", "delta_tau_s")
f.glonass_set_channel = ProtoField.int8("orrery.glonass_set.channel", "channel")
f.glonass_set_reserved = ProtoField.uint8("orrery.glonass_set.reserved", "reserved")
f.sat_navdata_answer = ProtoField.uint8("orrery.sat_navdata.answer", "answer", base.DEC, enum_answer)
f.sat_navdata_message = ProtoField.uint8("orrery.sat_navdata.message", "message", base.DEC, enum_nav_message)
f.sat_navdata_notes = ProtoField.uint32("orrery.sat_navdata.notes", "notes", base.HEX)
f.sat_navdata_set_from = ProtoField.int64("orrery.sat_navdata.set_from", "set_from [ns]")
f.sat_navdata_set_to = ProtoField.int64("orrery.sat_navdata.set_to", "set_to [ns]")
f.sat_navdata_toe = ProtoField.int64("orrery.sat_navdata.toe", "toe [ns]")
f.sat_navdata_toc = ProtoField.int64("orrery.sat_navdata.toc", "toc [ns]")
f.sat_navdata_week = ProtoField.int32("orrery.sat_navdata.week", "week")
f.sat_navdata_iode = ProtoField.int16("orrery.sat_navdata.iode", "iode")
f.sat_navdata_iodc = ProtoField.int16("orrery.sat_navdata.iodc", "iodc")
f.sat_navdata_health = ProtoField.uint32("orrery.sat_navdata.health", "health")
f.sat_navdata_accuracy_m = ProtoField.double("orrery.sat_navdata.accuracy_m", "accuracy_m")
f.sat_navdata_fit_rms_m = ProtoField.double("orrery.sat_navdata.fit_rms_m", "fit_rms_m")
f.sat_navdata_fit_max_m = ProtoField.double("orrery.sat_navdata.fit_max_m", "fit_max_m")
f.sat_navdata_clock_rms_s = ProtoField.double("orrery.sat_navdata.clock_rms_s", "clock_rms_s")
f.sat_navdata_af0_s = ProtoField.double("orrery.sat_navdata.af0_s", "af0_s")
f.sat_navdata_af1_sps = ProtoField.double("orrery.sat_navdata.af1_sps", "af1_sps [s/s]")
f.sat_navdata_af2_sps2 = ProtoField.double("orrery.sat_navdata.af2_sps2", "af2_sps2 [s/s2]")
f.sat_navdata_frame_from = ProtoField.int64("orrery.sat_navdata.frame_from", "frame_from [ns]")
f.sat_navdata_frame_to = ProtoField.int64("orrery.sat_navdata.frame_to", "frame_to [ns]")
f.sat_delay_answer = ProtoField.uint8("orrery.sat_delay.answer", "answer", base.DEC, enum_answer)
f.sat_delay_origin = ProtoField.uint8("orrery.sat_delay.origin", "origin", base.DEC, enum_tec_origin)
f.sat_delay_flags = ProtoField.uint8("orrery.sat_delay.flags", "flags", base.HEX)
f.sat_delay_reserved = ProtoField.uint8("orrery.sat_delay.reserved", "reserved")
f.sat_delay_az_rad = ProtoField.double("orrery.sat_delay.az_rad", "az_rad")
f.sat_delay_el_rad = ProtoField.double("orrery.sat_delay.el_rad", "el_rad")
f.sat_delay_pierce_lat_rad = ProtoField.double("orrery.sat_delay.pierce_lat_rad", "pierce_lat_rad")
f.sat_delay_pierce_lon_rad = ProtoField.double("orrery.sat_delay.pierce_lon_rad", "pierce_lon_rad")
f.sat_delay_mapping = ProtoField.double("orrery.sat_delay.mapping", "mapping")
f.sat_delay_stec_tecu = ProtoField.double("orrery.sat_delay.stec_tecu", "stec_tecu [TECU]")
f.sat_delay_model_stec_tecu = ProtoField.double("orrery.sat_delay.model_stec_tecu", "model_stec_tecu [TECU]")
f.sat_delay_delay_m = ProtoField.double("orrery.sat_delay.delay_m", "delay_m")
f.sat_delay_sigma_tecu = ProtoField.float("orrery.sat_delay.sigma_tecu", "sigma_tecu [TECU]")
f.hello_major_min = ProtoField.uint8("orrery.hello.major_min", "major_min")
f.hello_major_max = ProtoField.uint8("orrery.hello.major_max", "major_max")
f.hello_name = ProtoField.string("orrery.hello.name", "name")
f.hello_version = ProtoField.string("orrery.hello.version", "version")
f.caps_major = ProtoField.uint8("orrery.caps.major", "major")
f.caps_minor = ProtoField.uint8("orrery.caps.minor", "minor")
f.caps_max_request = ProtoField.uint32("orrery.caps.max_request", "max_request")
f.caps_max_epochs = ProtoField.uint32("orrery.caps.max_epochs", "max_epochs")
f.caps_name = ProtoField.string("orrery.caps.name", "name")
f.caps_version = ProtoField.string("orrery.caps.version", "version")
f.caps_title = ProtoField.string("orrery.caps.title", "title")
f.caps_frame = ProtoField.string("orrery.caps.frame", "frame")
f.caps_navdata_point = ProtoField.uint8("orrery.caps.navdata_point", "navdata_point", base.DEC, enum_orbit_point)
f.caps_receiver_source = ProtoField.uint8("orrery.caps.receiver_source", "receiver_source", base.DEC, enum_receiver_source)
f.caps_receiver_unit = ProtoField.uint16("orrery.caps.receiver_unit", "receiver_unit")
f.caps_receiver_m = ProtoField.double("orrery.caps.receiver_m", "receiver_m")
f.caps_imu_rate_hz = ProtoField.double("orrery.caps.imu_rate_hz", "imu_rate_hz [Hz]")
f.ping_token = ProtoField.uint64("orrery.ping.token", "token", base.HEX)
f.pong_token = ProtoField.uint64("orrery.pong.token", "token", base.HEX)
f.error_code = ProtoField.uint16("orrery.error.code", "code", base.DEC, enum_error_code)
f.error_request = ProtoField.uint16("orrery.error.request", "request")
f.error_sentence = ProtoField.string("orrery.error.sentence", "sentence")
f.poll_elements_frame = ProtoField.uint8("orrery.poll_elements.frame", "frame", base.DEC, enum_elements_frame)
f.poll_elements_method = ProtoField.uint8("orrery.poll_elements.method", "method", base.DEC, enum_elements_method)
f.elements_frame = ProtoField.uint8("orrery.elements.frame", "frame", base.DEC, enum_elements_frame)
f.elements_method = ProtoField.uint8("orrery.elements.method", "method", base.DEC, enum_elements_method)
f.poll_delays_receiver_m = ProtoField.double("orrery.poll_delays.receiver_m", "receiver_m")
f.poll_delays_carriers_hz = ProtoField.double("orrery.poll_delays.carriers_hz", "carriers_hz [Hz]")
f.delays_receiver_m = ProtoField.double("orrery.delays.receiver_m", "receiver_m")
f.delays_carriers_hz = ProtoField.double("orrery.delays.carriers_hz", "carriers_hz [Hz]")
f.poll_imu_unit = ProtoField.uint16("orrery.poll_imu.unit", "unit")
f.imu_t1 = ProtoField.int64("orrery.imu.t1", "t1 [ns]")
f.imu_unit = ProtoField.uint16("orrery.imu.unit", "unit")
f.imu_dtheta_rad = ProtoField.double("orrery.imu.dtheta_rad", "dtheta_rad")
f.imu_dv_mps = ProtoField.double("orrery.imu.dv_mps", "dv_mps [m/s]")
f.poll_truth_unit = ProtoField.uint16("orrery.poll_truth.unit", "unit")
f.truth_unit = ProtoField.uint16("orrery.truth.unit", "unit")
f.truth_pos_m = ProtoField.double("orrery.truth.pos_m", "pos_m")
f.truth_vel_mps = ProtoField.double("orrery.truth.vel_mps", "vel_mps [m/s]")
f.truth_acc_mps2 = ProtoField.double("orrery.truth.acc_mps2", "acc_mps2 [m/s2]")
f.truth_attitude = ProtoField.double("orrery.truth.attitude", "attitude")
f.truth_heading_rad = ProtoField.double("orrery.truth.heading_rad", "heading_rad")
f.truth_pitch_rad = ProtoField.double("orrery.truth.pitch_rad", "pitch_rad")
f.truth_roll_rad = ProtoField.double("orrery.truth.roll_rad", "roll_rad")
f.truth_rate_radps = ProtoField.double("orrery.truth.rate_radps", "rate_radps [rad/s]")
f.truth_force_mps2 = ProtoField.double("orrery.truth.force_mps2", "force_mps2 [m/s2]")
f.truth_disturbance_mgal = ProtoField.double("orrery.truth.disturbance_mgal", "disturbance_mgal [mGal]")
f.truth_eotvos_mgal = ProtoField.double("orrery.truth.eotvos_mgal", "eotvos_mgal [mGal]")
f.truth_vertical_mps2 = ProtoField.double("orrery.truth.vertical_mps2", "vertical_mps2 [m/s2]")

local function record_sat_id(r, tree)
  add(r, tree, f.sat_id_system, 1)
  add(r, tree, f.sat_id_number, 1)
end

local function record_epochs(r, tree)
  add(r, tree, f.epochs_t, 8)
  add(r, tree, f.epochs_step, 8)
  add(r, tree, f.epochs_count, 4)
end

local function record_epoch(r, tree)
  add(r, tree, f.epoch_t, 8)
  add(r, tree, f.epoch_index, 4)
  add(r, tree, f.epoch_count, 4)
  add(r, tree, f.epoch_answer, 1)
end

local function record_span(r, tree)
  add(r, tree, f.span_first, 8)
  add(r, tree, f.span_last, 8)
end

local function record_served_request(r, tree)
  add(r, tree, f.served_request_request, 2)
  add(r, tree, f.served_request_answer, 2)
  record_span(r, tree)
end

local function record_inertial_unit(r, tree)
  add(r, tree, f.inertial_unit_unit, 2)
  add_text(r, tree, f.inertial_unit_name)
  for _ = 1, 3 do add(r, tree, f.inertial_unit_lever_m, 8) end
  add(r, tree, f.inertial_unit_heading_rad, 8)
  add(r, tree, f.inertial_unit_pitch_rad, 8)
  add(r, tree, f.inertial_unit_roll_rad, 8)
end

local function record_leap_seconds(r, tree)
  add(r, tree, f.leap_seconds_gps_utc_s, 2)
  add(r, tree, f.leap_seconds_next_gps_utc_s, 2)
  add(r, tree, f.leap_seconds_next, 8)
end

local function record_sat_state(r, tree)
  record_sat_id(r, tree)
  add(r, tree, f.sat_state_answer, 1)
  add(r, tree, f.sat_state_reserved, 1)
  add(r, tree, f.sat_state_flags, 4)
  for _ = 1, 3 do add(r, tree, f.sat_state_pos_m, 8) end
  for _ = 1, 3 do add(r, tree, f.sat_state_vel_mps, 8) end
  for _ = 1, 3 do add(r, tree, f.sat_state_acc_mps2, 8) end
  add(r, tree, f.sat_state_clock_s, 8)
  add(r, tree, f.sat_state_clock_rate_sps, 8)
  add(r, tree, f.sat_state_valid_from, 8)
  add(r, tree, f.sat_state_valid_to, 8)
  add(r, tree, f.sat_state_sigma_m, 4)
end

local function record_sat_elements(r, tree)
  record_sat_id(r, tree)
  add(r, tree, f.sat_elements_answer, 1)
  add(r, tree, f.sat_elements_reserved, 1)
  add(r, tree, f.sat_elements_flags, 4)
  add(r, tree, f.sat_elements_a_m, 8)
  add(r, tree, f.sat_elements_e, 8)
  add(r, tree, f.sat_elements_i_rad, 8)
  add(r, tree, f.sat_elements_raan_rad, 8)
  add(r, tree, f.sat_elements_argp_rad, 8)
  add(r, tree, f.sat_elements_m_rad, 8)
  add(r, tree, f.sat_elements_u_rad, 8)
end

local function record_nav_page(r, tree)
  add(r, tree, f.nav_page_t, 8)
  add(r, tree, f.nav_page_number, 1)
  add(r, tree, f.nav_page_page, 1)
  add(r, tree, f.nav_page_bits, 2)
  add_text(r, tree, f.nav_page_data)
end

local function record_lnav_set(r, tree)
  add(r, tree, f.lnav_set_sqrt_a_sqrtm, 8)
  add(r, tree, f.lnav_set_e, 8)
  add(r, tree, f.lnav_set_m0_rad, 8)
  add(r, tree, f.lnav_set_i0_rad, 8)
  add(r, tree, f.lnav_set_omega0_rad, 8)
  add(r, tree, f.lnav_set_omega_rad, 8)
  add(r, tree, f.lnav_set_delta_n_radps, 8)
  add(r, tree, f.lnav_set_idot_radps, 8)
  add(r, tree, f.lnav_set_omega_dot_radps, 8)
  add(r, tree, f.lnav_set_cuc_rad, 8)
  add(r, tree, f.lnav_set_cus_rad, 8)
  add(r, tree, f.lnav_set_crc_m, 8)
  add(r, tree, f.lnav_set_crs_m, 8)
  add(r, tree, f.lnav_set_cic_rad, 8)
  add(r, tree, f.lnav_set_cis_rad, 8)
  add(r, tree, f.lnav_set_tgd_s, 8)
end

local function record_glonass_set(r, tree)
  for _ = 1, 3 do add(r, tree, f.glonass_set_pos_m, 8) end
  for _ = 1, 3 do add(r, tree, f.glonass_set_vel_mps, 8) end
  for _ = 1, 3 do add(r, tree, f.glonass_set_acc_mps2, 8) end
  add(r, tree, f.glonass_set_delta_tau_s, 8)
  add(r, tree, f.glonass_set_channel, 1)
  add(r, tree, f.glonass_set_reserved, 1)
end

local function record_sat_navdata(r, tree)
  record_sat_id(r, tree)
  add(r, tree, f.sat_navdata_answer, 1)
  add(r, tree, f.sat_navdata_message, 1)
  add(r, tree, f.sat_navdata_notes, 4)
  add(r, tree, f.sat_navdata_set_from, 8)
  add(r, tree, f.sat_navdata_set_to, 8)
  add(r, tree, f.sat_navdata_toe, 8)
  add(r, tree, f.sat_navdata_toc, 8)
  add(r, tree, f.sat_navdata_week, 4)
  add(r, tree, f.sat_navdata_iode, 2)
  add(r, tree, f.sat_navdata_iodc, 2)
  add(r, tree, f.sat_navdata_health, 4)
  add(r, tree, f.sat_navdata_accuracy_m, 8)
  add(r, tree, f.sat_navdata_fit_rms_m, 8)
  add(r, tree, f.sat_navdata_fit_max_m, 8)
  add(r, tree, f.sat_navdata_clock_rms_s, 8)
  add(r, tree, f.sat_navdata_af0_s, 8)
  add(r, tree, f.sat_navdata_af1_sps, 8)
  add(r, tree, f.sat_navdata_af2_sps2, 8)
  add(r, tree, f.sat_navdata_frame_from, 8)
  add(r, tree, f.sat_navdata_frame_to, 8)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_lnav_set(one, tree:add(orrery, range, "kepler " .. k))
    end
  end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_glonass_set(one, tree:add(orrery, range, "glonass " .. k))
    end
  end
  do
    local count, stride = take(r, 2), nil
    for k = 1, count and count:le_uint() or 0 do
      local stride = take(r, 2)
      if not stride then break end
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_nav_page(one, tree:add(orrery, range, "pages " .. k))
    end
  end
end

local function record_sat_delay(r, tree)
  record_sat_id(r, tree)
  add(r, tree, f.sat_delay_answer, 1)
  add(r, tree, f.sat_delay_origin, 1)
  add(r, tree, f.sat_delay_flags, 1)
  add(r, tree, f.sat_delay_reserved, 1)
  add(r, tree, f.sat_delay_az_rad, 8)
  add(r, tree, f.sat_delay_el_rad, 8)
  add(r, tree, f.sat_delay_pierce_lat_rad, 8)
  add(r, tree, f.sat_delay_pierce_lon_rad, 8)
  add(r, tree, f.sat_delay_mapping, 8)
  add(r, tree, f.sat_delay_stec_tecu, 8)
  add(r, tree, f.sat_delay_model_stec_tecu, 8)
  for _ = 1, 4 do add(r, tree, f.sat_delay_delay_m, 8) end
  add(r, tree, f.sat_delay_sigma_tecu, 4)
end

local function record_hello(r, tree)
  add(r, tree, f.hello_major_min, 1)
  add(r, tree, f.hello_major_max, 1)
  add_text(r, tree, f.hello_name)
  add_text(r, tree, f.hello_version)
end

local function record_caps(r, tree)
  add(r, tree, f.caps_major, 1)
  add(r, tree, f.caps_minor, 1)
  add(r, tree, f.caps_max_request, 4)
  add(r, tree, f.caps_max_epochs, 4)
  record_span(r, tree)
  add_text(r, tree, f.caps_name)
  add_text(r, tree, f.caps_version)
  add_text(r, tree, f.caps_title)
  add_text(r, tree, f.caps_frame)
  record_leap_seconds(r, tree)
  add(r, tree, f.caps_navdata_point, 1)
  add(r, tree, f.caps_receiver_source, 1)
  add(r, tree, f.caps_receiver_unit, 2)
  for _ = 1, 3 do add(r, tree, f.caps_receiver_m, 8) end
  add(r, tree, f.caps_imu_rate_hz, 8)
  do
    local count, stride = take(r, 2), nil
    for k = 1, count and count:le_uint() or 0 do
      local stride = take(r, 2)
      if not stride then break end
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_inertial_unit(one, tree:add(orrery, range, "units " .. k))
    end
  end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_served_request(one, tree:add(orrery, range, "requests " .. k))
    end
  end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_id(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_ping(r, tree)
  add(r, tree, f.ping_token, 8)
end

local function record_pong(r, tree)
  add(r, tree, f.pong_token, 8)
end

local function record_error(r, tree)
  add(r, tree, f.error_code, 2)
  add(r, tree, f.error_request, 2)
  add_text(r, tree, f.error_sentence)
end

local function record_poll(r, tree)
  record_epochs(r, tree)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_id(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_states(r, tree)
  record_epoch(r, tree)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_state(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_poll_elements(r, tree)
  record_epochs(r, tree)
  add(r, tree, f.poll_elements_frame, 1)
  add(r, tree, f.poll_elements_method, 1)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_id(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_elements(r, tree)
  record_epoch(r, tree)
  add(r, tree, f.elements_frame, 1)
  add(r, tree, f.elements_method, 1)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_elements(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_poll_navdata(r, tree)
  record_epochs(r, tree)
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_id(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_navdata(r, tree)
  record_epoch(r, tree)
  do
    local count, stride = take(r, 2), nil
    for k = 1, count and count:le_uint() or 0 do
      local stride = take(r, 2)
      if not stride then break end
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_navdata(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_poll_delays(r, tree)
  record_epochs(r, tree)
  for _ = 1, 3 do add(r, tree, f.poll_delays_receiver_m, 8) end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      add(one, tree, f.poll_delays_carriers_hz, 8)
    end
  end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_id(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_delays(r, tree)
  record_epoch(r, tree)
  for _ = 1, 3 do add(r, tree, f.delays_receiver_m, 8) end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      add(one, tree, f.delays_carriers_hz, 8)
    end
  end
  do
    local count, stride = take(r, 2), take(r, 2)
    for k = 1, (count and stride) and count:le_uint() or 0 do
      local n = stride:le_uint()
      local range = n > 0 and take(r, n)
      if not range then break end
      local one = reader(r.tvb, r.at - n, r.at)
      record_sat_delay(one, tree:add(orrery, range, "satellites " .. k))
    end
  end
end

local function record_poll_imu(r, tree)
  record_epochs(r, tree)
  add(r, tree, f.poll_imu_unit, 2)
end

local function record_imu(r, tree)
  record_epoch(r, tree)
  add(r, tree, f.imu_t1, 8)
  add(r, tree, f.imu_unit, 2)
  for _ = 1, 3 do add(r, tree, f.imu_dtheta_rad, 8) end
  for _ = 1, 3 do add(r, tree, f.imu_dv_mps, 8) end
end

local function record_poll_truth(r, tree)
  record_epochs(r, tree)
  add(r, tree, f.poll_truth_unit, 2)
end

local function record_truth(r, tree)
  record_epoch(r, tree)
  add(r, tree, f.truth_unit, 2)
  for _ = 1, 3 do add(r, tree, f.truth_pos_m, 8) end
  for _ = 1, 3 do add(r, tree, f.truth_vel_mps, 8) end
  for _ = 1, 3 do add(r, tree, f.truth_acc_mps2, 8) end
  for _ = 1, 4 do add(r, tree, f.truth_attitude, 8) end
  add(r, tree, f.truth_heading_rad, 8)
  add(r, tree, f.truth_pitch_rad, 8)
  add(r, tree, f.truth_roll_rad, 8)
  for _ = 1, 3 do add(r, tree, f.truth_rate_radps, 8) end
  for _ = 1, 3 do add(r, tree, f.truth_force_mps2, 8) end
  add(r, tree, f.truth_disturbance_mgal, 8)
  add(r, tree, f.truth_eotvos_mgal, 8)
  add(r, tree, f.truth_vertical_mps2, 8)
end


local decode = {
  [1] = record_hello,
  [2] = record_caps,
  [3] = record_ping,
  [4] = record_pong,
  [5] = record_error,
  [6] = record_poll,
  [7] = record_states,
  [8] = record_poll_elements,
  [9] = record_elements,
  [10] = record_poll_navdata,
  [11] = record_navdata,
  [12] = record_poll_delays,
  [13] = record_delays,
  [16] = record_poll_imu,
  [17] = record_imu,
  [18] = record_poll_truth,
  [19] = record_truth,
}

f.major = ProtoField.uint8("orrery.major", "Major version")
f.minor = ProtoField.uint8("orrery.minor", "Minor version")
f.type = ProtoField.uint16("orrery.type", "Type", base.DEC, types)
f.sequence = ProtoField.uint32("orrery.sequence", "Sequence")
f.length = ProtoField.uint32("orrery.length", "Payload length")
f.crc = ProtoField.uint32("orrery.crc", "CRC-32", base.HEX)
local bad_crc = ProtoExpert.new("orrery.bad_crc", "checksum does not match", expert.group.CHECKSUM, expert.severity.ERROR)
orrery.experts = {bad_crc}

local function one_frame(tvb, pinfo, tree)
  local type, size = tvb(6, 2):le_uint(), tvb(12, 4):le_uint()
  local name = types[type] or ("type " .. type)
  local t = tree:add(orrery, tvb(0, 20 + size), "Orrery " .. name .. ", sequence " .. tvb(8, 4):le_uint())
  t:add(f.major, tvb(4, 1))
  t:add(f.minor, tvb(5, 1))
  t:add_le(f.type, tvb(6, 2))
  t:add_le(f.sequence, tvb(8, 4))
  t:add_le(f.length, tvb(12, 4))
  local r = reader(tvb, 16, 16 + size)
  if decode[type] then decode[type](r, t) end
  local sum = t:add_le(f.crc, tvb(16 + size, 4))
  if crc32(tvb(0, 16 + size)) ~= tvb(16 + size, 4):le_uint() then sum:add_proto_expert_info(bad_crc) end
  pinfo.cols.protocol = "Orrery"
  pinfo.cols.info:append(" " .. name)
  return 20 + size
end

function orrery.dissector(tvb, pinfo, tree)
  if tvb:len() >= 4 and tvb(0, 4):raw() ~= "ORRY" then return 0 end
  pinfo.cols.info:set("")
  dissect_tcp_pdus(tvb, tree, 16, function(t) return 20 + t(12, 4):le_uint() end, one_frame)
  return tvb:len()
end

DissectorTable.get("tcp.port"):add(15754, orrery)
