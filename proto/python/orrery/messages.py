# SPDX-License-Identifier: MIT
# Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
# pylint: skip-file
"""Messages of Orrery, protocol 1.0."""
import enum

from .codec import Field, Record

MAGIC = b'ORRY'
MAJOR = 1
MINOR = 0
PORT = 15754
MAX_PAYLOAD = 1048576
MAX_CARRIERS = 4  # carriers one POLL_DELAYS may name
MAX_SATELLITES = 800  # satellites in one list (eight systems of 99 and a little)
MAX_EPOCHS = 86400  # epochs one POLL may ask for (a day at 1 Hz)
MAX_PAGES = 15  # subframes or strings in one frame of a navigation message
MAX_UNITS = 64  # inertial units in one list
MAX_REQUEST = 65536  # bytes of payload that a server reads of one request


class ErrorCode(enum.IntEnum):
    """Why a request was refused or a connection is being closed."""

    BAD_MAGIC = 1  # the bytes are no frame of this protocol
    BAD_LENGTH = 2  # the payload length is above the limit
    BAD_CRC = 3  # the checksum does not match: bytes were lost or damaged
    BAD_VERSION = 4  # no common major version
    UNKNOWN_TYPE = 5  # no such message type in the server's version
    BAD_PAYLOAD = 6  # the payload is shorter than its fields, or a count in it is above its limit
    BAD_REQUEST = 7  # a value outside its domain, e.g. a step of zero with several epochs
    LIMIT = 8  # more epochs or satellites than one request may ask for
    NOT_SERVED = 9  # understood, but this scenario has nothing to answer it with
    BUSY = 10  # as many clients are connected as the server allows
    TIMEOUT = 11  # half a frame, or nothing, for longer than the server waits
    CLOSING = 12  # the server is shutting down
    INTERNAL = 13  # the server failed; its log says how


class Answer(enum.IntEnum):
    """Whether there are numbers, and if not, why not."""

    OK = 0  # the numbers are there
    OUTSIDE_SPAN = 1  # the instant is outside the served span
    NO_ARC = 2  # the satellite has no valid arc at the instant
    NOT_SERVED = 3  # the satellite is not among those served
    BELOW_HORIZON = 4  # the satellite is below the receiver's horizon
    NO_VALUE = 5  # the ionosphere has a hole where the ray pierces it, or the arc is too short for the method


class NavMessage(enum.IntEnum):
    """A navigation message."""

    NONE = 0  # none
    LNAV = 1  # GPS legacy navigation message: IS-GPS-200, subframes of 300 bits in 6 s
    FDMA = 2  # GLONASS L1 and L2: ICD edition 5.1, strings of 85 bits in 2 s


class ElementsFrame(enum.IntEnum):
    """Axes that Kepler elements refer to."""

    DATE = 0  # true equator and equinox of date
    J2000 = 1  # GCRS
    ECEF = 2  # axes of ecef, frozen at the epoch, for MEAN through its whole revolution


class ElementsMethod(enum.IntEnum):
    """How Kepler elements are made."""

    STATE = 0  # osculating, from position and velocity
    THREE_POSITIONS = 1  # the plane through three positions 300 s apart; a is off by about 2 km
    MEAN = 2  # osculating averaged over one revolution centred on the epoch


class OrbitPoint(enum.IntEnum):
    """The point of a satellite whose orbit is described."""

    NONE = 0  # no orbit is described
    CENTRE_OF_MASS = 1  # the centre of mass
    PHASE_CENTRE = 2  # the antenna's phase centre; the centre of mass of a satellite marked NO_ANTENNA


class ReceiverSource(enum.IntEnum):
    """Where the receiver comes from that is used when a request names none."""

    NONE = 0  # there is none: a request has to name one
    POSITION = 1  # the scenario's receiver.position
    TRAJECTORY = 2  # a unit of the scenario's trajectory, where it is at each epoch
    STATION = 3  # the station of the ionosphere's session


class TecOrigin(enum.IntEnum):
    """What a delay came from."""

    FIELD = 0  # the field alone: maps, coefficients or the broadcast model
    FUSED = 1  # the session's own carrier phases of the satellite, levelled
    TRANSFERRED = 2  # the field, corrected, and the session's residual of the satellite carried to another ray
    NOISE = 3  # the field, corrected, what neighbouring rays tell, and seeded noise: the station did not see the satellite


class DelayFlags(enum.IntFlag):
    """What holds for a delay."""

    CLIPPED = 1  # the content came out negative and is given as 0


class StateFlags(enum.IntFlag):
    """What holds for a satellite's state."""

    CLOCK_VALID = 1  # clock_s and clock_rate_sps are there (NAN otherwise)
    PREDICTED = 2  # the input was predicted, or bridged without input
    MANOEUVRE = 4  # within a manoeuvre's interval
    CLOCK_EVENT = 8  # the input flagged a clock event at a neighbouring node
    ECLIPSE = 16  # in the umbra or penumbra of the Earth
    GAP = 32  # between input nodes further apart than twice the usual


class NavNotes(enum.IntFlag):
    """What should be known of a broadcast set."""

    MANOEUVRE = 1  # a manoeuvre within the window, or files that do not meet: marked unhealthy
    SHIFTED = 2  # the orbit begins or ends within the window: fitted to the nearest full one
    NO_CLOCK = 4  # the product has no clock: zero is sent
    NO_ANTENNA = 8  # the scenario's ANTEX file does not know the antenna: the centre of mass is described
    NO_DELAY = 16  # the scenario's biases do not have the satellite: a group delay of zero is sent
    NOMINAL_CHANNEL = 32  # GLONASS: the frequency channel is the nominal one of the slot
    CLOCK_JUMP = 64  # the clock jumps, or is off a straight line by more than 10 ns RMS: marked unhealthy


class SatId(Record):
    """A satellite as IGS files name it.

    system: letter: G R E C J I S L; any other is NOT_SERVED
    number: 1 to 99; any other is NOT_SERVED
    """

    LAYOUT = (
        Field("system", "scalar", scalar="u8"),
        Field("number", "scalar", scalar="u8"),
    )

    def __init__(self, system=0, number=0):
        self.system = system
        self.number = number


class Epochs(Record):
    """The instants of a request - t, t + step, ..., t + (count - 1) step. A request that has them is answered by count frames.

    t [ns]: first epoch
    step [ns]: from one epoch to the next; any sign, not 0 unless count is 1
    count: how many, 1 to MAX_EPOCHS
    """

    LAYOUT = (
        Field("t", "scalar", scalar="i64"),
        Field("step", "scalar", scalar="i64"),
        Field("count", "scalar", scalar="u32"),
    )

    def __init__(self, t=0, step=0, count=0):
        self.t = t
        self.step = step
        self.count = count


class Epoch(Record):
    """Which of the instants of a request a frame answers.

    t [ns]: the instant
    index: which epoch of the request, from 0; the frame of count - 1 ends the answer
    count: how many epochs the request asked for
    answer: whether there are numbers at this instant
    """

    LAYOUT = (
        Field("t", "scalar", scalar="i64"),
        Field("index", "scalar", scalar="u32"),
        Field("count", "scalar", scalar="u32"),
        Field("answer", "scalar", scalar="u8"),
    )

    def __init__(self, t=0, index=0, count=0, answer=0):
        self.t = t
        self.index = index
        self.count = count
        self.answer = answer


class Span(Record):
    """A length of time with both of its ends.

    first [ns]: first instant; -2^63 where there is none
    last [ns]: last instant; likewise
    """

    LAYOUT = (
        Field("first", "scalar", scalar="i64"),
        Field("last", "scalar", scalar="i64"),
    )

    def __init__(self, first=0, last=0):
        self.first = first
        self.last = last


class ServedRequest(Record):
    """A request that is answered.

    request: its message type
    answer: message type of its answer
    span: instants at which there can be numbers; none of a request without epochs
    """

    LAYOUT = (
        Field("request", "scalar", scalar="u16"),
        Field("answer", "scalar", scalar="u16"),
        Field("span", "struct", record=Span),
    )

    def __init__(self, request=0, answer=0, span=None):
        self.request = request
        self.answer = answer
        self.span = Span() if span is None else span


class InertialUnit(Record):
    """An inertial measurement unit of the scenario's vehicle.

    unit: its number in POLL_IMU and POLL_TRUTH; 0 is the trajectory's own point
    name: its name in the scenario
    lever_m [m]: where it is from unit 0: to the right, forward, up in the vehicle's axes
    heading_rad [rad]: how it is mounted: heading against the vehicle's axes
    pitch_rad [rad]: likewise pitch
    roll_rad [rad]: likewise roll
    """

    LAYOUT = (
        Field("unit", "scalar", scalar="u16"),
        Field("name", "string", limit=64),
        Field("lever_m", "array", scalar="f64", length=3),
        Field("heading_rad", "scalar", scalar="f64"),
        Field("pitch_rad", "scalar", scalar="f64"),
        Field("roll_rad", "scalar", scalar="f64"),
    )

    def __init__(self, unit=0, name="", lever_m=None, heading_rad=0.0, pitch_rad=0.0, roll_rad=0.0):
        self.unit = unit
        self.name = name
        self.lever_m = [0.0] * 3 if lever_m is None else lever_m
        self.heading_rad = heading_rad
        self.pitch_rad = pitch_rad
        self.roll_rad = roll_rad


class LeapSeconds(Record):
    """Leap seconds of UTC as the server knows them.

    gps_utc_s [s]: GPS time minus UTC, in force at the first instant served
    next_gps_utc_s [s]: from `next` on; the same where no later change is known
    next [ns]: first instant of the next value; -2^63 where no later change is known
    """

    LAYOUT = (
        Field("gps_utc_s", "scalar", scalar="i16"),
        Field("next_gps_utc_s", "scalar", scalar="i16"),
        Field("next", "scalar", scalar="i64"),
    )

    def __init__(self, gps_utc_s=0, next_gps_utc_s=0, next=0):
        self.gps_utc_s = gps_utc_s
        self.next_gps_utc_s = next_gps_utc_s
        self.next = next


class SatState(Record):
    """State of one satellite in the terrestrial frame of the input orbits (ecef). Numbers are NAN unless answer is OK.

    sat: which satellite
    answer: OK, NO_ARC or NOT_SERVED
    reserved: 0
    flags: 0 unless answer is OK
    pos_m [m]: position of the centre of mass
    vel_mps [m/s]: its first derivative (ecef)
    acc_mps2 [m/s2]: its second derivative (ecef)
    clock_s [s]: clock offset, periodic relativity not included
    clock_rate_sps [s/s]: its derivative
    valid_from [ns]: start of the arc that was evaluated
    valid_to [ns]: its end
    sigma_m [m]: 1-sigma of the position, 3-D
    """

    LAYOUT = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8"),
        Field("reserved", "scalar", scalar="u8"),
        Field("flags", "scalar", scalar="u32"),
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("clock_s", "scalar", scalar="f64"),
        Field("clock_rate_sps", "scalar", scalar="f64"),
        Field("valid_from", "scalar", scalar="i64"),
        Field("valid_to", "scalar", scalar="i64"),
        Field("sigma_m", "scalar", scalar="f32"),
    )

    def __init__(self, sat=None, answer=0, reserved=0, flags=0, pos_m=None, vel_mps=None, acc_mps2=None, clock_s=0.0, clock_rate_sps=0.0, valid_from=0, valid_to=0, sigma_m=0.0):
        self.sat = SatId() if sat is None else sat
        self.answer = answer
        self.reserved = reserved
        self.flags = flags
        self.pos_m = [0.0] * 3 if pos_m is None else pos_m
        self.vel_mps = [0.0] * 3 if vel_mps is None else vel_mps
        self.acc_mps2 = [0.0] * 3 if acc_mps2 is None else acc_mps2
        self.clock_s = clock_s
        self.clock_rate_sps = clock_rate_sps
        self.valid_from = valid_from
        self.valid_to = valid_to
        self.sigma_m = sigma_m


class SatElements(Record):
    """Kepler elements of one satellite. Numbers are NAN unless answer is OK.

    sat: which satellite
    answer: OK, NO_ARC, NOT_SERVED, or NO_VALUE where the arc is too short for the method
    reserved: 0
    flags: of the state at the epoch; 0 unless answer is OK
    a_m [m]: semi-major axis
    e: eccentricity
    i_rad [rad]: inclination
    raan_rad [rad]: right ascension of the ascending node, 0 to 2 pi
    argp_rad [rad]: argument of perigee; ill-determined in near-circular orbits
    m_rad [rad]: mean anomaly; likewise
    u_rad [rad]: argument of latitude
    """

    LAYOUT = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8"),
        Field("reserved", "scalar", scalar="u8"),
        Field("flags", "scalar", scalar="u32"),
        Field("a_m", "scalar", scalar="f64"),
        Field("e", "scalar", scalar="f64"),
        Field("i_rad", "scalar", scalar="f64"),
        Field("raan_rad", "scalar", scalar="f64"),
        Field("argp_rad", "scalar", scalar="f64"),
        Field("m_rad", "scalar", scalar="f64"),
        Field("u_rad", "scalar", scalar="f64"),
    )

    def __init__(self, sat=None, answer=0, reserved=0, flags=0, a_m=0.0, e=0.0, i_rad=0.0, raan_rad=0.0, argp_rad=0.0, m_rad=0.0, u_rad=0.0):
        self.sat = SatId() if sat is None else sat
        self.answer = answer
        self.reserved = reserved
        self.flags = flags
        self.a_m = a_m
        self.e = e
        self.i_rad = i_rad
        self.raan_rad = raan_rad
        self.argp_rad = argp_rad
        self.m_rad = m_rad
        self.u_rad = u_rad


class NavPage(Record):
    """A subframe or string as it is sent, bit by bit.

    t [ns]: begin of its first bit
    number: subframe 1-5, string 1-15
    page: LNAV: page 1-25 of subframes 4 and 5, 0 otherwise; GLONASS: frame 1-5 of the superframe
    bits: 300 or 85
    data: the first bit in time is the highest of the first byte; what is left of the last is 0
    """

    LAYOUT = (
        Field("t", "scalar", scalar="i64"),
        Field("number", "scalar", scalar="u8"),
        Field("page", "scalar", scalar="u8"),
        Field("bits", "scalar", scalar="u16"),
        Field("data", "bytes", limit=38),
    )

    def __init__(self, t=0, number=0, page=0, bits=0, data=b""):
        self.t = t
        self.number = number
        self.page = page
        self.bits = bits
        self.data = data


class LnavSet(Record):
    """What subframes 1 to 3 hold beside clock and issue, on the message's lattice (IS-GPS-200N tables 20-I and 20-III).

    sqrt_a_sqrtm [sqrt(m)]: root of the semi-major axis
    e: eccentricity
    m0_rad [rad]: mean anomaly at toe
    i0_rad [rad]: inclination at toe
    omega0_rad [rad]: longitude of the node at the week's begin
    omega_rad [rad]: argument of perigee
    delta_n_radps [rad/s]: mean motion difference
    idot_radps [rad/s]: rate of the inclination
    omega_dot_radps [rad/s]: rate of the node
    cuc_rad [rad]: cosine term of the argument of latitude
    cus_rad [rad]: its sine term
    crc_m [m]: cosine term of the radius
    crs_m [m]: its sine term
    cic_rad [rad]: cosine term of the inclination
    cis_rad [rad]: its sine term
    tgd_s [s]: group delay differential
    """

    LAYOUT = (
        Field("sqrt_a_sqrtm", "scalar", scalar="f64"),
        Field("e", "scalar", scalar="f64"),
        Field("m0_rad", "scalar", scalar="f64"),
        Field("i0_rad", "scalar", scalar="f64"),
        Field("omega0_rad", "scalar", scalar="f64"),
        Field("omega_rad", "scalar", scalar="f64"),
        Field("delta_n_radps", "scalar", scalar="f64"),
        Field("idot_radps", "scalar", scalar="f64"),
        Field("omega_dot_radps", "scalar", scalar="f64"),
        Field("cuc_rad", "scalar", scalar="f64"),
        Field("cus_rad", "scalar", scalar="f64"),
        Field("crc_m", "scalar", scalar="f64"),
        Field("crs_m", "scalar", scalar="f64"),
        Field("cic_rad", "scalar", scalar="f64"),
        Field("cis_rad", "scalar", scalar="f64"),
        Field("tgd_s", "scalar", scalar="f64"),
    )

    def __init__(self, sqrt_a_sqrtm=0.0, e=0.0, m0_rad=0.0, i0_rad=0.0, omega0_rad=0.0, omega_rad=0.0, delta_n_radps=0.0, idot_radps=0.0, omega_dot_radps=0.0, cuc_rad=0.0, cus_rad=0.0, crc_m=0.0, crs_m=0.0, cic_rad=0.0, cis_rad=0.0, tgd_s=0.0):
        self.sqrt_a_sqrtm = sqrt_a_sqrtm
        self.e = e
        self.m0_rad = m0_rad
        self.i0_rad = i0_rad
        self.omega0_rad = omega0_rad
        self.omega_rad = omega_rad
        self.delta_n_radps = delta_n_radps
        self.idot_radps = idot_radps
        self.omega_dot_radps = omega_dot_radps
        self.cuc_rad = cuc_rad
        self.cus_rad = cus_rad
        self.crc_m = crc_m
        self.crs_m = crs_m
        self.cic_rad = cic_rad
        self.cis_rad = cis_rad
        self.tgd_s = tgd_s


class GlonassSet(Record):
    """What strings 1 to 4 hold beside the clock, on the message's lattice (GLONASS ICD 5.1, table 4.5).

    pos_m [m]: position at toe (t_b), PZ-90
    vel_mps [m/s]: velocity at toe
    acc_mps2 [m/s2]: acceleration by Sun and Moon
    delta_tau_s [s]: L2 behind L1
    channel: frequency channel -7 to 6
    reserved: 0
    """

    LAYOUT = (
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("delta_tau_s", "scalar", scalar="f64"),
        Field("channel", "scalar", scalar="i8"),
        Field("reserved", "scalar", scalar="u8"),
    )

    def __init__(self, pos_m=None, vel_mps=None, acc_mps2=None, delta_tau_s=0.0, channel=0, reserved=0):
        self.pos_m = [0.0] * 3 if pos_m is None else pos_m
        self.vel_mps = [0.0] * 3 if vel_mps is None else vel_mps
        self.acc_mps2 = [0.0] * 3 if acc_mps2 is None else acc_mps2
        self.delta_tau_s = delta_tau_s
        self.channel = channel
        self.reserved = reserved


class SatNavdata(Record):
    """What one satellite sends. Numbers are NAN, times no instant, issues -1 and lists empty unless answer is OK.

    sat: which satellite
    answer: OK, NO_ARC (it sends nothing then), NOT_SERVED (no such data could be made of it), or NO_VALUE (a value does not fit its field)
    message: LNAV or FDMA; NONE unless answer is OK
    notes: 0 unless answer is OK
    set_from [ns]: the set is sent from then on
    set_to [ns]: and before then
    toe [ns]: reference of the orbit
    toc [ns]: reference of the clock
    week: GPS week of toe; -1 for GLONASS
    iode: issue of the orbit; -1 for GLONASS
    iodc: issue of the clock; -1 for GLONASS
    health: LNAV: six bits, 0 is good; GLONASS: 1 for unfit
    accuracy_m [m]: LNAV: user range accuracy that is sent; NAN for GLONASS
    fit_rms_m [m]: 3-D RMS of the rounded set against the orbit, over its window
    fit_max_m [m]: largest of these distances
    clock_rms_s [s]: the same of the clock; NAN with NO_CLOCK
    af0_s [s]: clock at toc; GLONASS: -tau_n
    af1_sps [s/s]: its rate; GLONASS: gamma_n
    af2_sps2 [s/s2]: its second coefficient; 0 for GLONASS
    frame_from [ns]: begin of the frame of the message that holds the epoch
    frame_to [ns]: its end: the next frame's begin
    kepler: of LNAV: one
    glonass: of FDMA: one
    pages: all of the frame: five subframes, or fifteen strings
    """

    LAYOUT = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8"),
        Field("message", "scalar", scalar="u8"),
        Field("notes", "scalar", scalar="u32"),
        Field("set_from", "scalar", scalar="i64"),
        Field("set_to", "scalar", scalar="i64"),
        Field("toe", "scalar", scalar="i64"),
        Field("toc", "scalar", scalar="i64"),
        Field("week", "scalar", scalar="i32"),
        Field("iode", "scalar", scalar="i16"),
        Field("iodc", "scalar", scalar="i16"),
        Field("health", "scalar", scalar="u32"),
        Field("accuracy_m", "scalar", scalar="f64"),
        Field("fit_rms_m", "scalar", scalar="f64"),
        Field("fit_max_m", "scalar", scalar="f64"),
        Field("clock_rms_s", "scalar", scalar="f64"),
        Field("af0_s", "scalar", scalar="f64"),
        Field("af1_sps", "scalar", scalar="f64"),
        Field("af2_sps2", "scalar", scalar="f64"),
        Field("frame_from", "scalar", scalar="i64"),
        Field("frame_to", "scalar", scalar="i64"),
        Field("kepler", "list", record=LnavSet, limit=1),
        Field("glonass", "list", record=GlonassSet, limit=1),
        Field("pages", "list", record=NavPage, limit=15),
    )

    def __init__(self, sat=None, answer=0, message=0, notes=0, set_from=0, set_to=0, toe=0, toc=0, week=0, iode=0, iodc=0, health=0, accuracy_m=0.0, fit_rms_m=0.0, fit_max_m=0.0, clock_rms_s=0.0, af0_s=0.0, af1_sps=0.0, af2_sps2=0.0, frame_from=0, frame_to=0, kepler=None, glonass=None, pages=None):
        self.sat = SatId() if sat is None else sat
        self.answer = answer
        self.message = message
        self.notes = notes
        self.set_from = set_from
        self.set_to = set_to
        self.toe = toe
        self.toc = toc
        self.week = week
        self.iode = iode
        self.iodc = iodc
        self.health = health
        self.accuracy_m = accuracy_m
        self.fit_rms_m = fit_rms_m
        self.fit_max_m = fit_max_m
        self.clock_rms_s = clock_rms_s
        self.af0_s = af0_s
        self.af1_sps = af1_sps
        self.af2_sps2 = af2_sps2
        self.frame_from = frame_from
        self.frame_to = frame_to
        self.kepler = [] if kepler is None else kepler
        self.glonass = [] if glonass is None else glonass
        self.pages = [] if pages is None else pages


class SatDelay(Record):
    """The ionosphere between a receiver and one satellite. Numbers are NAN unless answer is OK.

    sat: which satellite
    answer: OK, NO_ARC, NOT_SERVED, BELOW_HORIZON or NO_VALUE
    origin: what it came from
    flags: 0 unless answer is OK
    reserved: 0
    az_rad [rad]: azimuth, clockwise from North
    el_rad [rad]: elevation above the ellipsoidal horizon
    pierce_lat_rad [rad]: geocentric latitude of the pierce point
    pierce_lon_rad [rad]: its longitude, East
    mapping: slant over vertical
    stec_tecu [TECU]: slant total electron content
    model_stec_tecu [TECU]: the part of the field as it is
    delay_m [m]: delay of a code on each carrier asked for, NAN beyond them; a carrier phase is early by it
    sigma_tecu [TECU]: 1-sigma of stec_tecu, NAN where unknown
    """

    LAYOUT = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8"),
        Field("origin", "scalar", scalar="u8"),
        Field("flags", "scalar", scalar="u8"),
        Field("reserved", "scalar", scalar="u8"),
        Field("az_rad", "scalar", scalar="f64"),
        Field("el_rad", "scalar", scalar="f64"),
        Field("pierce_lat_rad", "scalar", scalar="f64"),
        Field("pierce_lon_rad", "scalar", scalar="f64"),
        Field("mapping", "scalar", scalar="f64"),
        Field("stec_tecu", "scalar", scalar="f64"),
        Field("model_stec_tecu", "scalar", scalar="f64"),
        Field("delay_m", "array", scalar="f64", length=4),
        Field("sigma_tecu", "scalar", scalar="f32"),
    )

    def __init__(self, sat=None, answer=0, origin=0, flags=0, reserved=0, az_rad=0.0, el_rad=0.0, pierce_lat_rad=0.0, pierce_lon_rad=0.0, mapping=0.0, stec_tecu=0.0, model_stec_tecu=0.0, delay_m=None, sigma_tecu=0.0):
        self.sat = SatId() if sat is None else sat
        self.answer = answer
        self.origin = origin
        self.flags = flags
        self.reserved = reserved
        self.az_rad = az_rad
        self.el_rad = el_rad
        self.pierce_lat_rad = pierce_lat_rad
        self.pierce_lon_rad = pierce_lon_rad
        self.mapping = mapping
        self.stec_tecu = stec_tecu
        self.model_stec_tecu = model_stec_tecu
        self.delay_m = [0.0] * 4 if delay_m is None else delay_m
        self.sigma_tecu = sigma_tecu


class Hello(Record):
    """Opens a conversation. Optional, but a client that sends it learns what is served.

    major_min: lowest major version the client speaks
    major_max: highest
    name: name of the client, for the server's log
    version: its version
    """

    TYPE = 1
    LAYOUT = (
        Field("major_min", "scalar", scalar="u8"),
        Field("major_max", "scalar", scalar="u8"),
        Field("name", "string", limit=64),
        Field("version", "string", limit=32),
    )

    def __init__(self, major_min=0, major_max=0, name="", version=""):
        self.major_min = major_min
        self.major_max = major_max
        self.name = name
        self.version = version


class Caps(Record):
    """What the server is and what it serves.

    major: version chosen for the conversation
    minor: minor version of the server
    max_request: bytes of payload it reads of one request
    max_epochs: epochs one POLL may ask for
    span: first and last instant at which anything is served
    name: name of the server
    version: its version
    title: title of the scenario
    frame: terrestrial frame of positions, e.g. IGS20
    leap: leap second in force, and the next
    navdata_point: the point of a satellite whose orbit NAVDATA describes; STATES gives the centre of mass
    receiver_source: receiver that is used when a POLL_DELAYS names none
    receiver_unit: with TRAJECTORY: the unit whose point it is
    receiver_m [m]: where it is (ecef); NAN with NONE and TRAJECTORY
    imu_rate_hz [Hz]: readings a second where POLL_IMU has step 0; NAN where POLL_IMU is not answered
    units: inertial units; none without a trajectory
    requests: what is answered; anything else is refused with NOT_SERVED or UNKNOWN_TYPE
    satellites: served satellites, in the order in which STATES lists them
    """

    TYPE = 2
    LAYOUT = (
        Field("major", "scalar", scalar="u8"),
        Field("minor", "scalar", scalar="u8"),
        Field("max_request", "scalar", scalar="u32"),
        Field("max_epochs", "scalar", scalar="u32"),
        Field("span", "struct", record=Span),
        Field("name", "string", limit=64),
        Field("version", "string", limit=32),
        Field("title", "string", limit=128),
        Field("frame", "string", limit=64),
        Field("leap", "struct", record=LeapSeconds),
        Field("navdata_point", "scalar", scalar="u8"),
        Field("receiver_source", "scalar", scalar="u8"),
        Field("receiver_unit", "scalar", scalar="u16"),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("imu_rate_hz", "scalar", scalar="f64"),
        Field("units", "list", record=InertialUnit, limit=64),
        Field("requests", "list", record=ServedRequest, limit=64),
        Field("satellites", "list", record=SatId, limit=800),
    )

    def __init__(self, major=0, minor=0, max_request=0, max_epochs=0, span=None, name="", version="", title="", frame="", leap=None, navdata_point=0, receiver_source=0, receiver_unit=0, receiver_m=None, imu_rate_hz=0.0, units=None, requests=None, satellites=None):
        self.major = major
        self.minor = minor
        self.max_request = max_request
        self.max_epochs = max_epochs
        self.span = Span() if span is None else span
        self.name = name
        self.version = version
        self.title = title
        self.frame = frame
        self.leap = LeapSeconds() if leap is None else leap
        self.navdata_point = navdata_point
        self.receiver_source = receiver_source
        self.receiver_unit = receiver_unit
        self.receiver_m = [0.0] * 3 if receiver_m is None else receiver_m
        self.imu_rate_hz = imu_rate_hz
        self.units = [] if units is None else units
        self.requests = [] if requests is None else requests
        self.satellites = [] if satellites is None else satellites


class Ping(Record):
    """Asks whether the server is alive; also keeps an idle connection open.

    token: anything
    """

    TYPE = 3
    LAYOUT = (
        Field("token", "scalar", scalar="u64"),
    )

    def __init__(self, token=0):
        self.token = token


class Pong(Record):
    """The answer to a PING.

    token: that of the PING
    """

    TYPE = 4
    LAYOUT = (
        Field("token", "scalar", scalar="u64"),
    )

    def __init__(self, token=0):
        self.token = token


class Error(Record):
    """A refusal. Answers the request whose sequence number it bears; 0 where no request could be read.

    code: class of failure, for programs
    request: message type of the refused request, 0 if none
    sentence: what was wrong, for people
    """

    TYPE = 5
    LAYOUT = (
        Field("code", "scalar", scalar="u16"),
        Field("request", "scalar", scalar="u16"),
        Field("sentence", "string", limit=512),
    )

    def __init__(self, code=0, request=0, sentence=""):
        self.code = code
        self.request = request
        self.sentence = sentence


class Poll(Record):
    """Asks for satellite states. The same POLL gets the same bytes, always.

    epochs: when
    satellites: which, in the order of the answer; empty for all
    """

    TYPE = 6
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("satellites", "list", record=SatId, limit=800),
    )

    def __init__(self, epochs=None, satellites=None):
        self.epochs = Epochs() if epochs is None else epochs
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class States(Record):
    """Satellite states at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE = 7
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("satellites", "list", record=SatState, limit=800),
    )

    def __init__(self, epoch=None, satellites=None):
        self.epoch = Epoch() if epoch is None else epoch
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


class PollElements(Record):
    """Asks for Kepler elements. The same POLL_ELEMENTS gets the same bytes, always.

    epochs: when
    frame: axes that the elements refer to
    method: how they are made
    satellites: which, in the order of the answer; empty for all
    """

    TYPE = 8
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("frame", "scalar", scalar="u8"),
        Field("method", "scalar", scalar="u8"),
        Field("satellites", "list", record=SatId, limit=800),
    )

    def __init__(self, epochs=None, frame=0, method=0, satellites=None):
        self.epochs = Epochs() if epochs is None else epochs
        self.frame = frame
        self.method = method
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class Elements(Record):
    """Kepler elements at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    frame: as asked
    method: as asked
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE = 9
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("frame", "scalar", scalar="u8"),
        Field("method", "scalar", scalar="u8"),
        Field("satellites", "list", record=SatElements, limit=800),
    )

    def __init__(self, epoch=None, frame=0, method=0, satellites=None):
        self.epoch = Epoch() if epoch is None else epoch
        self.frame = frame
        self.method = method
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


class PollNavdata(Record):
    """Asks for the broadcast data; every 30 s are all bits that are sent. The same POLL_NAVDATA gets the same bytes, always.

    epochs: when
    satellites: which, in the order of the answer; empty for all
    """

    TYPE = 10
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("satellites", "list", record=SatId, limit=800),
    )

    def __init__(self, epochs=None, satellites=None):
        self.epochs = Epochs() if epochs is None else epochs
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class Navdata(Record):
    """Broadcast data at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE = 11
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("satellites", "list", record=SatNavdata, limit=800),
    )

    def __init__(self, epoch=None, satellites=None):
        self.epoch = Epoch() if epoch is None else epoch
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


class PollDelays(Record):
    """Asks for ionospheric delays. The same POLL_DELAYS gets the same bytes, always.

    epochs: when
    receiver_m [m]: receiver (ecef); three times NAN for the scenario's own, which may move from epoch to epoch
    carriers_hz [Hz]: carriers to give delays for; empty for 1575.42 MHz
    satellites: which, in the order of the answer; empty for all
    """

    TYPE = 12
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("carriers_hz", "list", scalar="f64", limit=4),
        Field("satellites", "list", record=SatId, limit=800),
    )

    def __init__(self, epochs=None, receiver_m=None, carriers_hz=None, satellites=None):
        self.epochs = Epochs() if epochs is None else epochs
        self.receiver_m = [0.0] * 3 if receiver_m is None else receiver_m
        self.carriers_hz = [] if carriers_hz is None else carriers_hz
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class Delays(Record):
    """Ionospheric delays at one epoch.

    epoch: OK, or OUTSIDE_SPAN of orbits, ionosphere or trajectory, with no satellites
    receiver_m [m]: the receiver that was taken (ecef); NAN outside the span of the scenario's trajectory
    carriers_hz [Hz]: the carriers of delay_m
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE = 13
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("carriers_hz", "list", scalar="f64", limit=4),
        Field("satellites", "list", record=SatDelay, limit=800),
    )

    def __init__(self, epoch=None, receiver_m=None, carriers_hz=None, satellites=None):
        self.epoch = Epoch() if epoch is None else epoch
        self.receiver_m = [0.0] * 3 if receiver_m is None else receiver_m
        self.carriers_hz = [] if carriers_hz is None else carriers_hz
        self.satellites = [] if satellites is None else satellites

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


class PollImu(Record):
    """Asks for ideal inertial increments over intervals. The same POLL_IMU gets the same bytes, always.

    epochs: begins of the intervals, which are step long (0 to 1 h; 0: that of CAPS imu_rate_hz)
    unit: which inertial unit of the scenario; 0 is the trajectory's own point
    """

    TYPE = 16
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("unit", "scalar", scalar="u16"),
    )

    def __init__(self, epochs=None, unit=0):
        self.epochs = Epochs() if epochs is None else epochs
        self.unit = unit

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class Imu(Record):
    """Integrals of absolute angular rate and specific force over one interval, in the unit's axes (right, forward, up).

    epoch: begin of the interval; OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN
    t1 [ns]: end of the interval
    unit: the unit asked for
    dtheta_rad [rad]: integral of the absolute angular rate
    dv_mps [m/s]: integral of the specific force; at rest +g upward
    """

    TYPE = 17
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("t1", "scalar", scalar="i64"),
        Field("unit", "scalar", scalar="u16"),
        Field("dtheta_rad", "array", scalar="f64", length=3),
        Field("dv_mps", "array", scalar="f64", length=3),
    )

    def __init__(self, epoch=None, t1=0, unit=0, dtheta_rad=None, dv_mps=None):
        self.epoch = Epoch() if epoch is None else epoch
        self.t1 = t1
        self.unit = unit
        self.dtheta_rad = [0.0] * 3 if dtheta_rad is None else dtheta_rad
        self.dv_mps = [0.0] * 3 if dv_mps is None else dv_mps

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


class PollTruth(Record):
    """Asks for the true motion of an inertial unit. The same POLL_TRUTH gets the same bytes, always.

    epochs: when
    unit: which inertial unit of the scenario; 0 is the trajectory's own point
    """

    TYPE = 18
    LAYOUT = (
        Field("epochs", "struct", record=Epochs),
        Field("unit", "scalar", scalar="u16"),
    )

    def __init__(self, epochs=None, unit=0):
        self.epochs = Epochs() if epochs is None else epochs
        self.unit = unit

    @property
    def t(self):
        """first epoch"""
        return self.epochs.t

    @property
    def step(self):
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self):
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


class Truth(Record):
    """True motion and gravity at one epoch.

    epoch: OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN
    unit: the unit asked for
    pos_m [m]: position (ecef)
    vel_mps [m/s]: velocity relative to the Earth (ecef)
    acc_mps2 [m/s2]: second derivative of the position (ecef)
    attitude: quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q
    heading_rad [rad]: clockwise from true North, 0 to 2 pi
    pitch_rad [rad]: nose up
    roll_rad [rad]: right wing down
    rate_radps [rad/s]: absolute angular rate, body axes
    force_mps2 [m/s2]: specific force, body axes
    disturbance_mgal [mGal]: gravity disturbance, stronger gravity positive
    eotvos_mgal [mGal]: Eotvoes term: what the motion takes off the weight
    vertical_mps2 [m/s2]: rate of the vertical velocity over the ellipsoid
    """

    TYPE = 19
    LAYOUT = (
        Field("epoch", "struct", record=Epoch),
        Field("unit", "scalar", scalar="u16"),
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("attitude", "array", scalar="f64", length=4),
        Field("heading_rad", "scalar", scalar="f64"),
        Field("pitch_rad", "scalar", scalar="f64"),
        Field("roll_rad", "scalar", scalar="f64"),
        Field("rate_radps", "array", scalar="f64", length=3),
        Field("force_mps2", "array", scalar="f64", length=3),
        Field("disturbance_mgal", "scalar", scalar="f64"),
        Field("eotvos_mgal", "scalar", scalar="f64"),
        Field("vertical_mps2", "scalar", scalar="f64"),
    )

    def __init__(self, epoch=None, unit=0, pos_m=None, vel_mps=None, acc_mps2=None, attitude=None, heading_rad=0.0, pitch_rad=0.0, roll_rad=0.0, rate_radps=None, force_mps2=None, disturbance_mgal=0.0, eotvos_mgal=0.0, vertical_mps2=0.0):
        self.epoch = Epoch() if epoch is None else epoch
        self.unit = unit
        self.pos_m = [0.0] * 3 if pos_m is None else pos_m
        self.vel_mps = [0.0] * 3 if vel_mps is None else vel_mps
        self.acc_mps2 = [0.0] * 3 if acc_mps2 is None else acc_mps2
        self.attitude = [0.0] * 4 if attitude is None else attitude
        self.heading_rad = heading_rad
        self.pitch_rad = pitch_rad
        self.roll_rad = roll_rad
        self.rate_radps = [0.0] * 3 if rate_radps is None else rate_radps
        self.force_mps2 = [0.0] * 3 if force_mps2 is None else force_mps2
        self.disturbance_mgal = disturbance_mgal
        self.eotvos_mgal = eotvos_mgal
        self.vertical_mps2 = vertical_mps2

    @property
    def t(self):
        """the instant"""
        return self.epoch.t

    @property
    def index(self):
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self):
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self):
        """whether there are numbers at this instant"""
        return self.epoch.answer


MESSAGES = {cls.TYPE: cls for cls in (
    Hello,
    Caps,
    Ping,
    Pong,
    Error,
    Poll,
    States,
    PollElements,
    Elements,
    PollNavdata,
    Navdata,
    PollDelays,
    Delays,
    PollImu,
    Imu,
    PollTruth,
    Truth,
)}
