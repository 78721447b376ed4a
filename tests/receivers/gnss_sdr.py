# SPDX-License-Identifier: GPL-3.0-or-later
"""GNSS-SDR as a judge: its configuration for a recording, a run, and what it found out, from files that it wrote."""
import math
import re
import shutil
import struct
import subprocess
import unittest

PROGRAM = shutil.which("gnss-sdr")

# One signal each: how it is acquired and tracked. Values where GNSS-SDR 0.0.17 keeps lock at 45 dB-Hz and more. The outer correlators of E1
# stay 0.6 chips wide: nearer ones (0.25) do not see that a loop holds the peak of BOC(1,1) half a chip beside the right one.
SIGNALS = {
    "1C": """
Acquisition_1C.implementation=GPS_L1_CA_PCPS_Acquisition
Acquisition_1C.coherent_integration_time_ms=1
Acquisition_1C.pfa=0.00001
Acquisition_1C.doppler_max=6000
Acquisition_1C.doppler_step=250
Tracking_1C.implementation=GPS_L1_CA_DLL_PLL_Tracking
Tracking_1C.pll_bw_hz=25.0
Tracking_1C.dll_bw_hz=1.0
Tracking_1C.early_late_space_chips=0.5
TelemetryDecoder_1C.implementation=GPS_L1_CA_Telemetry_Decoder
""",
    "1B": """
Acquisition_1B.implementation=Galileo_E1_PCPS_Ambiguous_Acquisition
Acquisition_1B.coherent_integration_time_ms=4
Acquisition_1B.acquire_pilot=true
Acquisition_1B.bit_transition_flag=true
Acquisition_1B.pfa=0.000001
Acquisition_1B.doppler_max=5000
Acquisition_1B.doppler_step=60
Acquisition_1B.cboc=false
Tracking_1B.implementation=Galileo_E1_DLL_PLL_VEML_Tracking
Tracking_1B.track_pilot=true
Tracking_1B.pll_bw_hz=20.0
Tracking_1B.dll_bw_hz=1.0
Tracking_1B.pll_bw_narrow_hz=5.0
Tracking_1B.dll_bw_narrow_hz=0.2
Tracking_1B.enable_fll_pull_in=true
Tracking_1B.fll_bw_hz=10
Tracking_1B.extend_correlation_symbols=4
Tracking_1B.early_late_space_chips=0.15
Tracking_1B.very_early_late_space_chips=0.6
Tracking_1B.early_late_space_narrow_chips=0.06
Tracking_1B.very_early_late_space_narrow_chips=0.6
TelemetryDecoder_1B.implementation=Galileo_E1B_Telemetry_Decoder
""",
    "1G": """
Acquisition_1G.implementation=GLONASS_L1_CA_PCPS_Acquisition
Acquisition_1G.pfa=0.00001
Acquisition_1G.coherent_integration_time_ms=1
Acquisition_1G.doppler_max=6000
Acquisition_1G.doppler_step=100
Tracking_1G.implementation=GLONASS_L1_CA_DLL_PLL_Tracking
Tracking_1G.early_late_space_chips=0.5
Tracking_1G.pll_bw_hz=40.0
Tracking_1G.dll_bw_hz=1.0
TelemetryDecoder_1G.implementation=GLONASS_L1_CA_Telemetry_Decoder
""",
    "B1": """
Acquisition_B1.implementation=BEIDOU_B1I_PCPS_Acquisition
Acquisition_B1.coherent_integration_time_ms=1
Acquisition_B1.pfa=0.00001
Acquisition_B1.doppler_max=6000
Acquisition_B1.doppler_step=100
Tracking_B1.implementation=BEIDOU_B1I_DLL_PLL_Tracking
Tracking_B1.pll_bw_hz=25.0
Tracking_B1.dll_bw_hz=2.5
TelemetryDecoder_B1.implementation=BEIDOU_B1I_Telemetry_Decoder
""",
    "L5": """
Acquisition_L5.implementation=GPS_L5i_PCPS_Acquisition
Acquisition_L5.bit_transition_flag=true
Acquisition_L5.pfa=0.0001
Acquisition_L5.doppler_max=5000
Acquisition_L5.doppler_step=125
Tracking_L5.implementation=GPS_L5_DLL_PLL_Tracking
Tracking_L5.track_pilot=false
Tracking_L5.pll_bw_hz=25.0
Tracking_L5.dll_bw_hz=2.0
Tracking_L5.early_late_space_chips=0.5
TelemetryDecoder_L5.implementation=GPS_L5_Telemetry_Decoder
""",
}

# Where codes of GPS stand beside Galileo's in one recording of 5 Msps: correlators twice as near and a loop half as wide, since
# GNSS-SDR weighs all ranges alike and those of C/A would decide how good the place is.
NARROW = {"1C": SIGNALS["1C"].replace("dll_bw_hz=1.0", "dll_bw_hz=0.5").replace("early_late_space_chips=0.5", "early_late_space_chips=0.2")}

# What the receiver is given to do, in samples times channels a second: an antenna's rate where that is less, slower where it is more. At
# 15 ns each that is three quarters of a core. (Where a file is read as fast as it goes, the thread that hands satellites to
# channels falls behind, and who is heard depends on what else the machine does.)
WORK = 50e6

# Satellites of GPS whose L5 I code GNSS-SDR makes right for two thirds and more: it goes on with XB, 8191 chips long, as if it were 10230 (`% 10230` in
# make_l5i), so that only the first 10230 - a chips are right, a the satellite's advance of XB (IS-GPS-705J table 3-Ia: 3471 of PRN 14, 7187 of PRN 32,
# which it hears by 10.7 dB less). The Neuman-Hofman code turns signs within a code period: without `bit_transition_flag` it takes the lobes 500 to
# 1000 Hz beside the carrier for it.
L5_HEARD = range(1, 15)

# No models of delays: the scenarios have none. Cold: nothing is known of time, place or satellites.
COMMON = """[GNSS-SDR]
GNSS-SDR.internal_fs_sps={rate}
SignalSource.implementation=File_Signal_Source
SignalSource.filename={samples}
SignalSource.item_type=ibyte
SignalSource.sampling_frequency={bytes_s}
SignalSource.samples={count}
SignalSource.repeat=false
SignalSource.enable_throttle_control={paced}
SignalConditioner.implementation=Signal_Conditioner
DataTypeAdapter.implementation=Ibyte_To_Complex
InputFilter.implementation=Pass_Through
InputFilter.item_type=gr_complex
Resampler.implementation=Pass_Through
Resampler.item_type=gr_complex
Channels.in_acquisition={at_once}
Observables.implementation=Hybrid_Observables
Observables.dump=true
Observables.dump_mat=false
Observables.dump_filename={folder}/observables.dat
PVT.implementation=RTKLIB_PVT
PVT.positioning_mode=Single
PVT.iono_model=OFF
PVT.trop_model=OFF
PVT.output_rate_ms=100
PVT.display_rate_ms=1000
PVT.elevation_mask=0
PVT.output_path={folder}
PVT.rinex_output_enabled=false
PVT.xml_output_enabled=true
PVT.nmea_output_file_enabled=false
PVT.geojson_output_enabled=false
PVT.gpx_output_enabled=false
PVT.kml_output_enabled=false
PVT.rtcm_output_file_enabled=false
PVT.dump=true
PVT.dump_filename={folder}/pvt
PVT.enable_rx_clock_correction=false
"""


def configuration(folder, samples, rate, channels, pinned=(), at_once=2, tracked=(), seconds=0, loops=False, work=WORK):
    """channels: {"1C": how many}; pinned: (signal, satellite) of each channel in turn, where the search is not free; tracked: signals whose
    settings are others than usual, as NARROW; seconds: as much of the recording, 0 all of it; loops: whether each channel's loops are
    written out, for `loops`; work: samples times channels that come in a second, at most as many as from an antenna;
    None: as fast as the file is read."""
    settings = {**SIGNALS, **dict(tracked)}
    pace = min(1, work / (rate * sum(channels.values()))) if work else 1
    # The source's own frequency is that of its items, of which a sample has two, and serves its pace alone.
    text = COMMON.format(rate=rate, samples=samples, folder=folder, at_once=at_once, count=2 * seconds * rate,
                         bytes_s=round(2 * rate * pace), paced=str(work is not None).lower())
    for signal, count in channels.items():
        text += f"Channels_{signal}.count={count}\n" + settings[signal]
        text += f"Acquisition_{signal}.item_type=gr_complex\nTracking_{signal}.item_type=gr_complex\n"
        if loops:
            text += f"Tracking_{signal}.dump=true\nTracking_{signal}.dump_filename={folder}/loops_\n"
    if len(channels) == 1:
        text += f"Channel.signal={next(iter(channels))}\n"
    for k, (signal, satellite) in enumerate(pinned):
        text += f"Channel{k}.signal={signal}\nChannel{k}.satellite={satellite}\n"
    return text


def run(folder, *args, **kwargs):
    """Runs the receiver over a recording; its log."""
    if PROGRAM is None:
        raise unittest.SkipTest("gnss-sdr is not here (./check --receivers installs it)")
    folder.mkdir(parents=True, exist_ok=True)
    conf = folder / "receiver.conf"
    conf.write_text(configuration(folder, *args, **kwargs))
    done = subprocess.run(["nice", PROGRAM, f"--config_file={conf}", f"--log_dir={folder}"], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=900, check=False)
    (folder / "receiver.log").write_text(done.stdout)
    return done.stdout


def fixes(folder):
    """(time of week s, position ecef m, velocity m/s, satellites) of each fix: the records of GNSS-SDR's dump."""
    record = struct.Struct("<IIdd3d3d6d3dBBBff4d")
    path = folder / "pvt.dat"
    bytes_ = path.read_bytes() if path.exists() else b""
    out = []
    for at in range(0, len(bytes_) - record.size + 1, record.size):
        f = record.unpack_from(bytes_, at)
        out.append((f[2], f[4:7], f[7:10], f[19]))
    return out


def ranges(folder, channels):
    """{satellite: {time of its clock, s of week: pseudorange m}} as the receiver observes them, fix or none; channels: how many it has."""
    record = struct.Struct("<7d")  # time, time of week sent, Doppler, carrier, pseudorange, satellite, whether it is valid
    bytes_ = (folder / "observables.dat").read_bytes()
    out = {}
    for at in range(0, len(bytes_) - record.size * channels + 1, record.size * channels):
        for k in range(channels):
            t, _, _, _, pseudorange, satellite, valid = record.unpack_from(bytes_, at + k * record.size)
            if valid:
                out.setdefault(int(satellite), {})[round(t, 3)] = pseudorange
    return out


LOOP = struct.Struct("<7fQ12fdI")  # correlators, prompt I and Q, sample, ..., C/N0 (the 18th), ..., satellite


def loops(folder):
    """{satellite: [(sample of the recording, power of the prompt correlator, C/N0 dB-Hz)]} of each of the periods that are tracked."""
    out = {}
    for path in sorted(folder.glob("loops_*.dat")):
        for r in LOOP.iter_unpack(path.read_bytes()[:path.stat().st_size // LOOP.size * LOOP.size]):
            out.setdefault(r[-1], []).append((r[7], r[5] ** 2 + r[6] ** 2, r[17]))
    return out


def clock_readings(log):
    """Date and time of day, s, that it says of each of its fixes at whole seconds: UTC as it takes it to be."""
    found = re.findall(r"Position at (\d{4}-\w{3}-\d\d) (\d\d):(\d\d):(\d\d)\.0+ UTC", log)
    return [(day, 3600 * int(h) + 60 * int(m) + int(s)) for day, h, m, s in found]


def ephemerides(folder, name):
    """{satellite: {field: value}} of an XML file of ephemerides."""
    path = folder / name
    if not path.exists():
        return {}
    out = {}
    for item in re.split(r"<item[ >]", path.read_text())[1:]:
        fields = {k: float(v) for k, v in re.findall(r"<(\w+)>(-?[\d.]+(?:e[+-]\d+)?)</\1>", item)}
        if "PRN" in fields:
            out[int(fields["PRN"])] = fields
    return out


def errors(found, truth, after_s=0.0):
    """3-D RMS and largest distance of fixes from truth(time of week), from `after_s` after the first on; and how many."""
    d = [math.dist(p, truth(t)) for t, p, _, _ in found if (t - found[0][0]) % 604800 >= after_s]
    return (math.sqrt(sum(x * x for x in d) / len(d)), max(d), len(d)) if d else (math.nan, math.nan, 0)
