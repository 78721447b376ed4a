# SPDX-License-Identifier: MIT
# Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
# pylint: skip-file
"""Messages of Orrery, protocol 1.0."""
import dataclasses
import enum
from typing import ClassVar, Type

from .codec import Field, Record, WireEnum

MAGIC = b'ORRY'
MAJOR = 1
MINOR = 0
PORT = 15754
MAX_PAYLOAD = 4194304
MAX_CARRIERS = 4  # carriers one POLL_DELAYS may name
MAX_SATELLITES = 800  # satellites in one list (eight systems of 99 and a little)
MAX_STREAMS = 800  # messages of satellites in one list
MAX_EPOCHS = 86400  # epochs one POLL may ask for (a day at 1 Hz)
MAX_PAGES = 15  # subframes, strings or pages in one frame of a navigation message
MAX_UNITS = 64  # inertial units in one list
MAX_CHANNELS = 4096  # channels of one antenna in one list
MAX_JAMMERS = 16  # jammers of a scenario
MAX_ANTENNAS = 16  # antennas in one list
MAX_SIGNALS = 64  # signals in one list
MAX_EVENTS = 8192  # events in one list
MAX_CHANGES = 100  # mode changes in one list
MAX_REQUEST = 65536  # bytes of payload that a server reads of one request


class ErrorCode(WireEnum):
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
    NOT_PERMITTED = 14  # the client may not do that (CAPS access): serve --read-only, or the access file gives it no such permission

    @property
    def closes(self) -> bool:
        """Whether the server closes the connection with it."""
        return self.value in (1, 2, 3, 4, 10, 11, 12,)


class Answer(WireEnum):
    """Whether there are numbers, and if not, why not."""

    OK = 0  # the numbers are there
    OUTSIDE_SPAN = 1  # the instant is outside the served span
    NO_ARC = 2  # the satellite has no valid arc at the instant
    NOT_SERVED = 3  # the satellite is not among those served
    BELOW_HORIZON = 4  # the satellite is below the receiver's horizon
    NO_VALUE = 5  # the ionosphere has a hole where the ray pierces it, or the arc is too short for the method


class NavMessage(WireEnum):
    """A navigation message, by the names of RINEX 4."""

    NONE = 0  # none
    LNAV = 1  # GPS, QZSS: IS-GPS-200, subframes of 300 bits in 6 s; NavIC: IRNSS SIS ICD, subframes of 292 bits
    CNAV = 2  # GPS, QZSS on L2C and L5: messages of 300 bits
    CNV1 = 3  # BeiDou B-CNAV1 on B1C: frames of 878 bits in 18 s
    CNV2 = 4  # GPS, QZSS: CNAV-2 on L1C, frames of 883 bits in 18 s; BeiDou: B-CNAV2 on B2a, messages of 312 bits in 3 s
    CNV3 = 5  # BeiDou B-CNAV3 on B2b: messages of 514 bits in 1 s
    INAV = 6  # Galileo I/NAV on E1 and E5b: OS SIS ICD, pages of 240 bits in 2 s
    FNAV = 7  # Galileo F/NAV on E5a: pages of 244 bits in 10 s
    D1 = 8  # BeiDou D1: BDS-SIS-ICD-B1I, subframes of 300 bits in 6 s
    D2 = 9  # BeiDou D2 of geostationary satellites: frames of 1500 bits in 3 s, five subframes of 300
    FDMA = 10  # GLONASS L1 and L2: ICD edition 5.1, strings of 85 bits in 2 s
    SBAS = 11  # SBAS: RTCA DO-229, messages of 250 bits in 1 s


class NavForm(WireEnum):
    """In which form pages of navigation messages are given."""

    BITS = 0  # the message's bits with the checks that belong to it (parity, CRC) and tails
    SYMBOLS = 1  # what a modulator takes: error correction, interleaving and synchronisation are done; of GLONASS relative code, meander and time mark. Secondary codes are the generator's


class ElementsFrame(WireEnum):
    """Axes that Kepler elements refer to."""

    DATE = 0  # true equator and equinox of date
    J2000 = 1  # GCRS
    ECEF = 2  # axes of ecef, frozen at the epoch, for MEAN through its whole revolution


class ElementsMethod(WireEnum):
    """How Kepler elements are made."""

    STATE = 0  # osculating, from position and velocity
    THREE_POSITIONS = 1  # the plane through three positions 300 s apart; a is off by about 2 km
    MEAN = 2  # osculating averaged over one revolution centred on the epoch


class OrbitPoint(WireEnum):
    """The point of a satellite whose orbit is described."""

    NONE = 0  # no orbit is described
    CENTRE_OF_MASS = 1  # the centre of mass
    PHASE_CENTRE = 2  # the antenna's phase centre; the centre of mass of a satellite marked NO_ANTENNA


class ReceiverSource(WireEnum):
    """Where the receiver comes from that is used when a request names none."""

    NONE = 0  # there is none: a request has to name one
    POSITION = 1  # the scenario's receiver.position
    TRAJECTORY = 2  # a unit of the scenario's trajectory, where it is at each epoch
    STATION = 3  # the station of the ionosphere's session


class TecOrigin(WireEnum):
    """What a delay came from."""

    FIELD = 0  # the field alone: maps, coefficients or the broadcast model
    FUSED = 1  # the session's own carrier phases of the satellite, levelled
    TRANSFERRED = 2  # the field, corrected, and the session's residual of the satellite carried to another ray
    NOISE = 3  # the field, corrected, what neighbouring rays tell, and seeded noise: the station did not see the satellite


class Pacing(WireEnum):
    """When the blocks of a stream are made."""

    FREE = 0  # as fast as there is credit and they are taken
    CLOCK = 1  # each so long before the scenario clock shows its instant as `lead` says
    MOTION = 2  # as soon as a sample of live motion reaches its begin, and at the latest as with CLOCK


class Delivery(WireEnum):
    """How the blocks of a stream come."""

    FRAMES = 0  # as frames of the connection
    RING = 1  # in a ring of shared memory, whose descriptor comes with SUBSCRIBED over a Unix socket (docs/protocol.md, The ring)
    DATAGRAMS = 2  # as UDP datagrams to `port` of the client's address, numbered, and sealed where the connection has TLS (docs/protocol.md, Datagrams)


class Seal(WireEnum):
    """What proves where a datagram comes from."""

    NONE = 0  # nothing: both ends are on one machine
    HMAC_SHA256 = 1  # 32 bytes behind the frame, by keys of the TLS session


class GapReason(WireEnum):
    """Why blocks of a stream were left out."""

    CREDIT = 1  # there was no credit before the clock had passed them
    LATE = 2  # they could not be made before the clock had passed them: the machine was busy, or the clock was set forward


class EndReason(WireEnum):
    """Why a stream has ended."""

    FINISHED = 1  # all epochs that were asked for have been sent
    UNSUBSCRIBED = 2  # as the client wished
    SLOW = 3  # its blocks were not taken although there was credit; other streams and clients do not wait for it
    OUTSIDE_SPAN = 4  # what is served ends there
    FAILED = 5  # the next block could not be made; the sentence says why


class ControlAction(WireEnum):
    """What is to become of the scenario's clock."""

    LOAD = 1  # it stands at `t`, where STOP leads back to; of another scenario, which is served instead: all connections are closed, and taken again when it is ready
    ARM = 2  # ready to start at `t`, or where it stands, with the reference that is named
    WAIT_PPS = 3  # of an armed one: PPS0 is the next whole second of the reference, and `t` is the scenario's instant there
    START = 4  # goes: after WAIT_PPS at PPS0 + delay; else at the wall's instant `at` + delay, or delay from now
    PAUSE = 5  # stands where it is
    STOP = 6  # stands at its begin


class ClockReference(WireEnum):
    """What paces the scenario's clock."""

    WALL = 0  # the host's clock
    RADIO = 1  # the generator's elapsed time (RADIO_TIME)


class ClockState(WireEnum):
    """The scenario's clock."""

    STOPPED = 0  # it stands at its begin
    ARMED = 1  # a start is awaited
    WAITING = 2  # the start is fixed, or PPS0 is, and to come
    RUNNING = 3  # it runs
    PAUSED = 4  # it stands where it was stopped


class Readings(WireEnum):
    """What inertial readings are."""

    IDEAL = 0  # those of perfect sensors
    MEASURED = 1  # those of sensors with the scenario's errors (imu.errors)


class StampClock(WireEnum):
    """Which clock of the server's host a stamp was read from."""

    ARRIVAL = 0  # none: the message's arrival counts
    MONOTONIC = 1  # CLOCK_MONOTONIC
    TAI = 2  # CLOCK_TAI, which PTP may keep on several hosts
    REALTIME = 3  # CLOCK_REALTIME, Unix time


class MotionState(WireEnum):
    """Where an antenna's motion of a block comes from."""

    SCENARIO = 0  # the scenario's own trajectory or place
    SYNCHRONOUS = 1  # live: the sample of the block's begin was there
    INTERPOLATED = 2  # live: between two samples
    EXTRAPOLATED = 3  # live: beyond the last sample
    JOINING = 4  # live: on the way from what was predicted to what is known now
    SNAPPED = 5  # live: jumps here, as the sample asked


class MotionPoint(WireEnum):
    """The point whose motion is told."""

    BODY = 0  # the body's own point; antennas ride on it by their lever arms
    ANTENNA = 1  # the antennas' reference point itself: lever arms are left out


class EventKind(WireEnum):
    """What an event is."""

    RISE = 1  # the antenna sees the satellite from then on
    SET = 2  # and from then on it does not
    ARC_BEGIN = 3  # first instant of an arc of the satellite's orbit
    ARC_END = 4  # and the last one
    EPHEMERIS = 5  # another set of a navigation message goes on the air; value: its issue
    HEALTH = 6  # with another health; value: the health that is sent
    LEAP_SECOND = 7  # value: GPS time minus UTC from then on, s
    ECLIPSE_BEGIN = 8  # the satellite goes over to the Earth's shadow (penumbra)
    ECLIPSE_END = 9  # and back to sunlight
    MANOEUVRE_BEGIN = 10  # the satellite's orbit is being changed
    MANOEUVRE_END = 11  # and is not any more
    MOTION_BEGIN = 12  # the scenario's body is there from then on
    MOTION_END = 13  # and is not there afterwards
    FAULT_BEGIN = 14  # a fault of the scenario begins; value: which of them, from 0 in their order there
    FAULT_END = 15  # and is over


class ModeKind(WireEnum):
    """What of the service can be in one mode or another."""

    CLOCK = 0  # the scenario's clock
    REFERENCE = 1  # what paces it
    GENERATOR = 2  # the lock to the generator's time (RADIO_TIME)
    MOTION = 3  # where the motion of the last block comes from (motion_state)


class Mode(WireEnum):
    """A mode of the service."""

    STOPPED = 0  # CLOCK: it stands at its begin
    ARMED = 1  # CLOCK: a start is awaited
    WAITING = 2  # CLOCK: the start is fixed, or PPS0 is, and to come
    RUNNING = 3  # CLOCK: it runs
    PAUSED = 4  # CLOCK: it stands where it was stopped
    WALL = 16  # REFERENCE: the wall's clock
    RADIO = 17  # REFERENCE: the generator
    SILENT = 32  # GENERATOR: no RADIO_TIME has come, or none for 2 s: its last rate holds
    LOCKED = 33  # GENERATOR: the loop follows it
    STEPPING = 34  # GENERATOR: its last RADIO_TIME was far off; when the next is so too the lock is taken up anew
    SCENARIO = 48  # MOTION: the scenario's own trajectory
    SYNCHRONOUS = 49  # MOTION: the sample of the block's begin was there
    INTERPOLATED = 50  # MOTION: between two samples
    EXTRAPOLATED = 51  # MOTION: beyond the last sample
    JOINING = 52  # MOTION: on the way from what was predicted to what is known now
    SNAPPED = 53  # MOTION: jumps here, as the sample asked


class Access(enum.IntFlag):
    """What this client may not do, and how it came."""

    NO_READING = 1  # no polls and no streams
    NO_MOTION = 2  # no MOTION
    NO_CONTROL = 4  # no CONTROL and no RADIO_TIME
    INSECURE = 8  # the address can be reached from other machines without authentication: anybody may be here


class ChannelFlags(enum.IntFlag):
    """What should be known of a channel."""

    UNHEALTHY = 1  # the scenario marks the satellite as not to be used
    ECLIPSE = 2  # the satellite is in the umbra or penumbra of the Earth
    FAST_TURN = 4  # near noon or midnight, where true satellites turn slower than the nominal attitude that is used
    NO_ANTENNA = 8  # the scenario's ANTEX file does not know the satellite: its centre of mass sends
    NO_DELAY = 16  # the scenario's biases do not tell this signal's group delay: zero is taken
    ZERO_CLOCK = 32  # the orbits have no clock of the satellite: zero is taken (channel.clock_holes)
    NOMINAL_CHANNEL = 64  # GLONASS: the frequency channel is the nominal one of the slot
    FAULT = 128  # faults of the scenario befall it


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
    JOINT = 64  # between the orbits of two input files that do not meet
    SHADOW_NOISE = 128  # the input's orbits are noisier near the Earth's shadow; sigma is less sure


class NavMessages(enum.IntFlag):
    """Several navigation messages."""

    LNAV = 2  # nav_message LNAV
    CNAV = 4  # nav_message CNAV
    CNV1 = 8  # nav_message CNV1
    CNV2 = 16  # nav_message CNV2
    CNV3 = 32  # nav_message CNV3
    INAV = 64  # nav_message INAV
    FNAV = 128  # nav_message FNAV
    D1 = 256  # nav_message D1
    D2 = 512  # nav_message D2
    FDMA = 1024  # nav_message FDMA
    SBAS = 2048  # nav_message SBAS


class NavNotes(enum.IntFlag):
    """What should be known of a broadcast set."""

    MANOEUVRE = 1  # a manoeuvre within the window, or files that do not meet: marked unhealthy
    SHIFTED = 2  # the orbit begins or ends within the window: fitted to the nearest full one
    NO_CLOCK = 4  # the product has no clock: zero is sent
    NO_ANTENNA = 8  # the scenario's ANTEX file does not know the antenna: the centre of mass is described
    NO_DELAY = 16  # the scenario's biases do not have the satellite: a group delay of zero is sent
    NOMINAL_CHANNEL = 32  # GLONASS: the frequency channel is the nominal one of the slot
    CLOCK_JUMP = 64  # the clock jumps, or is off a straight line by more than 10 ns RMS: marked unhealthy
    FAULTY = 128  # a fault of the scenario changes it, or how long it is sent


@dataclasses.dataclass(eq=False, slots=True)
class MotionSpread(Record):
    """Least, greatest, last, median and 99th percentile of a time, over the samples that were counted; 0 without any.

    min [ns]: least
    max [ns]: greatest
    last [ns]: last
    p50 [ns]: median, to 9 %
    p99 [ns]: 99th percentile, to 9 %
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("min", "scalar", scalar="i64"),
        Field("max", "scalar", scalar="i64"),
        Field("last", "scalar", scalar="i64"),
        Field("p50", "scalar", scalar="i64"),
        Field("p99", "scalar", scalar="i64"),
    )

    min: int = 0
    max: int = 0
    last: int = 0
    p50: int = 0
    p99: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class SatId(Record):
    """A satellite as IGS files name it.

    system: letter: G R E C J I S L; any other is NOT_SERVED
    number: 1 to 99; any other is NOT_SERVED
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("system", "scalar", scalar="u8"),
        Field("number", "scalar", scalar="u8"),
    )

    system: int = 0
    number: int = 0

    def __str__(self) -> str:
        return f"{chr(self.system)}{self.number:02d}"


@dataclasses.dataclass(eq=False, slots=True)
class Epochs(Record):
    """The instants of a request - t, t + step, ..., t + (count - 1) step. A request that has them is answered by count frames.

    t [ns]: first epoch
    step [ns]: from one epoch to the next; any sign, not 0 unless count is 1
    count: how many, 1 to MAX_EPOCHS
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("step", "scalar", scalar="i64"),
        Field("count", "scalar", scalar="u32"),
    )

    t: int = 0
    step: int = 0
    count: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Epoch(Record):
    """Which of the instants of a request a frame answers.

    t [ns]: the instant
    index: which epoch of the request, from 0; the frame of count - 1 ends the answer
    count: how many epochs the request asked for
    answer: whether there are numbers at this instant
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("index", "scalar", scalar="u32"),
        Field("count", "scalar", scalar="u32"),
        Field("answer", "scalar", scalar="u8", enum=Answer),
    )

    t: int = 0
    index: int = 0
    count: int = 0
    answer: Answer = Answer(0)


@dataclasses.dataclass(eq=False, slots=True)
class Span(Record):
    """A length of time with both of its ends.

    first [ns]: first instant; -2^63 where there is none
    last [ns]: last instant; likewise
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("first", "scalar", scalar="i64"),
        Field("last", "scalar", scalar="i64"),
    )

    first: int = 0
    last: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class ServedRequest(Record):
    """A request that is answered.

    request: its message type
    answer: message type of its answer
    span: instants at which there can be numbers; none of a request without epochs
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("request", "scalar", scalar="u16"),
        Field("answer", "scalar", scalar="u16"),
        Field("span", "struct", record=Span),
    )

    request: int = 0
    answer: int = 0
    span: Span = dataclasses.field(default_factory=Span)


@dataclasses.dataclass(eq=False, slots=True)
class InertialUnit(Record):
    """An inertial measurement unit of the scenario's vehicle.

    unit: its number in POLL_IMU and POLL_TRUTH; 0 is the trajectory's own point
    name: its name in the scenario
    lever_m [m]: where it is from unit 0: to the right, forward, up in the vehicle's axes
    heading_rad [rad]: how it is mounted: heading against the vehicle's axes
    pitch_rad [rad]: likewise pitch
    roll_rad [rad]: likewise roll
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("unit", "scalar", scalar="u16"),
        Field("name", "string", limit=64),
        Field("lever_m", "array", scalar="f64", length=3),
        Field("heading_rad", "scalar", scalar="f64"),
        Field("pitch_rad", "scalar", scalar="f64"),
        Field("roll_rad", "scalar", scalar="f64"),
    )

    unit: int = 0
    name: str = ""
    lever_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    heading_rad: float = 0.0
    pitch_rad: float = 0.0
    roll_rad: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class LeapSeconds(Record):
    """Leap seconds of UTC as the server knows them.

    gps_utc_s [s]: GPS time minus UTC, in force at the first instant served
    next_gps_utc_s [s]: from `next` on; the same where no later change is known
    next [ns]: first instant of the next value; -2^63 where no later change is known
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("gps_utc_s", "scalar", scalar="i16"),
        Field("next_gps_utc_s", "scalar", scalar="i16"),
        Field("next", "scalar", scalar="i64"),
    )

    gps_utc_s: int = 0
    next_gps_utc_s: int = 0
    next: int = 0


@dataclasses.dataclass(eq=False, slots=True)
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
    clock_sigma_s [s]: 1-sigma of clock_s; NAN where there is no clock or it is not known
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8", enum=Answer),
        Field("reserved", "scalar", scalar="u8"),
        Field("flags", "scalar", scalar="u32", enum=StateFlags),
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("clock_s", "scalar", scalar="f64"),
        Field("clock_rate_sps", "scalar", scalar="f64"),
        Field("valid_from", "scalar", scalar="i64"),
        Field("valid_to", "scalar", scalar="i64"),
        Field("sigma_m", "scalar", scalar="f32"),
        Field("clock_sigma_s", "scalar", scalar="f32"),
    )

    sat: SatId = dataclasses.field(default_factory=SatId)
    answer: Answer = Answer(0)
    reserved: int = 0
    flags: StateFlags = StateFlags(0)
    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    vel_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    acc_mps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    clock_s: float = 0.0
    clock_rate_sps: float = 0.0
    valid_from: int = 0
    valid_to: int = 0
    sigma_m: float = 0.0
    clock_sigma_s: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
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

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8", enum=Answer),
        Field("reserved", "scalar", scalar="u8"),
        Field("flags", "scalar", scalar="u32", enum=StateFlags),
        Field("a_m", "scalar", scalar="f64"),
        Field("e", "scalar", scalar="f64"),
        Field("i_rad", "scalar", scalar="f64"),
        Field("raan_rad", "scalar", scalar="f64"),
        Field("argp_rad", "scalar", scalar="f64"),
        Field("m_rad", "scalar", scalar="f64"),
        Field("u_rad", "scalar", scalar="f64"),
    )

    sat: SatId = dataclasses.field(default_factory=SatId)
    answer: Answer = Answer(0)
    reserved: int = 0
    flags: StateFlags = StateFlags(0)
    a_m: float = 0.0
    e: float = 0.0
    i_rad: float = 0.0
    raan_rad: float = 0.0
    argp_rad: float = 0.0
    m_rad: float = 0.0
    u_rad: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class NavPage(Record):
    """A subframe, string, page or message as it is sent. Its k-th bit or symbol begins at t + k length / bits.

    t [ns]: begin of its first bit
    length [ns]: from there to the end of its last; 1.7 s for GLONASS' bits, whose time mark is not among them
    number: LNAV, D1: subframe 1-5; D2: page 1-10 of subframe 1; GLONASS: string 1-15; INAV: word type; FNAV: page type; NavIC:
    subframe 1-4; CNV1, and CNV2 of GPS and QZSS: page of subframe 3; others: message type
    page: LNAV, D1: page of subframes 4 and 5, 0 otherwise; D2: page 1-120 of subframe 5; GLONASS: frame 1-5 of the superframe;
    INAV, FNAV: sub-frame 1-24, 1-12 of the frame; NavIC: message of subframes 3 and 4
    bits: how many bits or symbols
    data: the first in time is the highest bit of the first byte; what is left of the last is 0
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("length", "scalar", scalar="i64"),
        Field("number", "scalar", scalar="u8"),
        Field("page", "scalar", scalar="u8"),
        Field("bits", "scalar", scalar="u16"),
        Field("data", "bytes", limit=226),
    )

    t: int = 0
    length: int = 0
    number: int = 0
    page: int = 0
    bits: int = 0
    data: bytes = b""


@dataclasses.dataclass(eq=False, slots=True)
class KeplerSet(Record):
    """Kepler elements of a message, on its lattice (the names are those of IS-GPS-200N tables 20-III and 30-I).

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
    a_dot_mps [m/s]: rate of the semi-major axis; 0 in messages without it
    delta_n_dot_radps2 [rad/s2]: rate of the mean motion difference; 0 likewise
    tgd_s [s]: group delay of the first signal of the message's system behind its clock: TGD of LNAV and CNAV, BGD(E1,E5b) of
    INAV, BGD(E1,E5a) of FNAV, TGD1 of D1 and D2, TGD of the B1C pilot of CNV1 and CNV2, TGD of B2b of CNV3
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
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
        Field("a_dot_mps", "scalar", scalar="f64"),
        Field("delta_n_dot_radps2", "scalar", scalar="f64"),
        Field("tgd_s", "scalar", scalar="f64"),
    )

    sqrt_a_sqrtm: float = 0.0
    e: float = 0.0
    m0_rad: float = 0.0
    i0_rad: float = 0.0
    omega0_rad: float = 0.0
    omega_rad: float = 0.0
    delta_n_radps: float = 0.0
    idot_radps: float = 0.0
    omega_dot_radps: float = 0.0
    cuc_rad: float = 0.0
    cus_rad: float = 0.0
    crc_m: float = 0.0
    crs_m: float = 0.0
    cic_rad: float = 0.0
    cis_rad: float = 0.0
    a_dot_mps: float = 0.0
    delta_n_dot_radps2: float = 0.0
    tgd_s: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class GlonassSet(Record):
    """What strings 1 to 4 hold beside the clock, on the message's lattice (GLONASS ICD 5.1, table 4.5); of SBAS what message 9
    holds.

    pos_m [m]: position at toe (t_b), PZ-90; of SBAS at t0, WGS 84
    vel_mps [m/s]: velocity at toe
    acc_mps2 [m/s2]: acceleration by Sun and Moon; of SBAS all of it
    delta_tau_s [s]: L2 behind L1; of SBAS 0
    channel: frequency channel -7 to 6; of SBAS 0
    reserved: 0
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("delta_tau_s", "scalar", scalar="f64"),
        Field("channel", "scalar", scalar="i8"),
        Field("reserved", "scalar", scalar="u8"),
    )

    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    vel_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    acc_mps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    delta_tau_s: float = 0.0
    channel: int = 0
    reserved: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class SatNavdata(Record):
    """One message that a satellite sends, on signals that carry the same bits. Numbers are NAN, times no instant, issues -1
    and lists empty unless answer is OK.

    sat: which satellite
    answer: OK, NO_ARC (it sends nothing then), NOT_SERVED (no such data could be made of it), or NO_VALUE (a value does not
    fit its field)
    message: NONE where the satellite has none of those asked for
    form: of the pages, as asked
    signals: names of the signals that carry it, as in CAPS, divided by blanks: L1OF L2OF
    notes: 0 unless answer is OK
    set_from [ns]: the set is sent from then on
    set_to [ns]: and before then
    toe [ns]: reference of the orbit
    toc [ns]: reference of the clock
    week: week of toe: GPS', of BeiDou its own; -1 for GLONASS
    iode: issue of the orbit: IODE, IODnav, AODE; -1 for GLONASS
    iodc: issue of the clock: IODC, AODC; -1 where the message has none of its own
    health: 0 is good; LNAV: six bits; INAV, FNAV: the bits of RINEX 3.05; others: 1 for unfit
    accuracy_m [m]: user range or signal in space accuracy that is sent; NAN for GLONASS
    fit_rms_m [m]: 3-D RMS of the rounded set against the orbit, over its window
    fit_max_m [m]: largest of these distances
    clock_rms_s [s]: the same of the clock; NAN with NO_CLOCK
    af0_s [s]: clock at toc; GLONASS: -tau_n
    af1_sps [s/s]: its rate; GLONASS: gamma_n
    af2_sps2 [s/s2]: its second coefficient; 0 for GLONASS
    frame_from [ns]: begin of the frame of the message that holds the epoch
    frame_to [ns]: its end: the next frame's begin
    kepler: of messages with Kepler elements: one
    glonass: of FDMA and SBAS: one
    pages: all of the frame
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8", enum=Answer),
        Field("message", "scalar", scalar="u8", enum=NavMessage),
        Field("form", "scalar", scalar="u8", enum=NavForm),
        Field("signals", "string", limit=16),
        Field("notes", "scalar", scalar="u32", enum=NavNotes),
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
        Field("kepler", "list", record=KeplerSet, limit=1),
        Field("glonass", "list", record=GlonassSet, limit=1),
        Field("pages", "list", record=NavPage, limit=15),
    )

    sat: SatId = dataclasses.field(default_factory=SatId)
    answer: Answer = Answer(0)
    message: NavMessage = NavMessage(0)
    form: NavForm = NavForm(0)
    signals: str = ""
    notes: NavNotes = NavNotes(0)
    set_from: int = 0
    set_to: int = 0
    toe: int = 0
    toc: int = 0
    week: int = 0
    iode: int = 0
    iodc: int = 0
    health: int = 0
    accuracy_m: float = 0.0
    fit_rms_m: float = 0.0
    fit_max_m: float = 0.0
    clock_rms_s: float = 0.0
    af0_s: float = 0.0
    af1_sps: float = 0.0
    af2_sps2: float = 0.0
    frame_from: int = 0
    frame_to: int = 0
    kepler: list[KeplerSet] = dataclasses.field(default_factory=list)
    glonass: list[GlonassSet] = dataclasses.field(default_factory=list)
    pages: list[NavPage] = dataclasses.field(default_factory=list)


@dataclasses.dataclass(eq=False, slots=True)
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

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("answer", "scalar", scalar="u8", enum=Answer),
        Field("origin", "scalar", scalar="u8", enum=TecOrigin),
        Field("flags", "scalar", scalar="u8", enum=DelayFlags),
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

    sat: SatId = dataclasses.field(default_factory=SatId)
    answer: Answer = Answer(0)
    origin: TecOrigin = TecOrigin(0)
    flags: DelayFlags = DelayFlags(0)
    reserved: int = 0
    az_rad: float = 0.0
    el_rad: float = 0.0
    pierce_lat_rad: float = 0.0
    pierce_lon_rad: float = 0.0
    mapping: float = 0.0
    stec_tecu: float = 0.0
    model_stec_tecu: float = 0.0
    delay_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 4)
    sigma_tecu: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class Antenna(Record):
    """An antenna that receives the scenario's signals.

    antenna: its number in POLL_CHANNELS
    name: its name in the scenario
    kind: antenna and radome as ANTEX files write them; empty where the phase centre is the reference point
    pos_m [m]: reference point of a fixed antenna (ecef); NAN where it moves
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("antenna", "scalar", scalar="u16"),
        Field("name", "string", limit=64),
        Field("kind", "string", limit=20),
        Field("pos_m", "array", scalar="f64", length=3),
    )

    antenna: int = 0
    name: str = ""
    kind: str = ""
    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)


@dataclasses.dataclass(eq=False, slots=True)
class Signal(Record):
    """A signal that the scenario's satellites send - one carrier with all its components.

    signal: its number in POLL_CHANNELS and CHANNELS
    system: letter of the system
    name: its name, e.g. L1CA
    observation: RINEX 3 band and attribute, e.g. 1C
    modulation: e.g. BPSK(1)
    components: divided by blanks, e.g. I Q
    carrier_hz [Hz]: carrier; of GLONASS' FDMA signals that of channel 0
    channel_hz [Hz]: step of a GLONASS frequency channel; 0 for others
    chips_per_s [chip/s]: rate of the ranging code
    chips: length of one period of the primary code
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("signal", "scalar", scalar="u16"),
        Field("system", "scalar", scalar="u8"),
        Field("name", "string", limit=16),
        Field("observation", "string", limit=8),
        Field("modulation", "string", limit=32),
        Field("components", "string", limit=16),
        Field("carrier_hz", "scalar", scalar="f64"),
        Field("channel_hz", "scalar", scalar="f64"),
        Field("chips_per_s", "scalar", scalar="f64"),
        Field("chips", "scalar", scalar="u64"),
    )

    signal: int = 0
    system: int = 0
    name: str = ""
    observation: str = ""
    modulation: str = ""
    components: str = ""
    carrier_hz: float = 0.0
    channel_hz: float = 0.0
    chips_per_s: float = 0.0
    chips: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Transmitter(Record):
    """A satellite that sends.

    sat: which satellite
    frequency_channel: GLONASS: -7 to 6; 0 for others
    unhealthy: 1 where the scenario marks it as not to be used, else 0
    svn: space vehicle as ANTEX names it, e.g. G063; empty without ANTEX
    block: type of the satellite as ANTEX names it, e.g. BLOCK IIF; empty without ANTEX
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("frequency_channel", "scalar", scalar="i8"),
        Field("unhealthy", "scalar", scalar="u8"),
        Field("svn", "string", limit=10),
        Field("block", "string", limit=20),
    )

    sat: SatId = dataclasses.field(default_factory=SatId)
    frequency_channel: int = 0
    unhealthy: int = 0
    svn: str = ""
    block: str = ""


@dataclasses.dataclass(eq=False, slots=True)
class SatChannel(Record):
    """One channel over the block of its message; with s the seconds since the block's begin, code and carrier are the cubics
    c[0] + c[1] s + c[2] s^2 + c[3] s^3. The receiver's clock is perfect.

    sat: which satellite
    signal: which signal, its number in CAPS
    flags: what should be known of it
    az_rad [rad]: azimuth of the satellite at the block's begin, clockwise from North
    el_rad [rad]: its elevation above the ellipsoidal horizon
    carrier_hz [Hz]: carrier
    code [m/s^k]: cubic of the pseudorange
    carrier_cycles [cycle]: whole cycles of the carrier's phase range at the block's begin; an integer that stays while the
    satellite is in view is part of it
    carrier [cycle/s^k]: cubic of the phase range, less carrier_cycles; the Doppler frequency is -carrier[1] at the begin,
    positive while approaching
    transmit [ns]: reading of the satellite's clock when the code at the block's begin was sent: whole nanoseconds, the scale's
    whole seconds against GPS not taken off
    transmit_fraction_ns [ns]: and the rest, 0 to 1
    power_dbw [dBW]: received by an antenna of 0 dBi; of an echo what makes it as much weaker than its signal as the antenna
    receives it
    echo: 0: the signal itself; from 1 on an echo of it, which sends the same: the ground, then the reflectors of the scenario;
    256 times 1 and so on: a false signal of the first spoofer and so on
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("sat", "struct", record=SatId),
        Field("signal", "scalar", scalar="u16"),
        Field("flags", "scalar", scalar="u32", enum=ChannelFlags),
        Field("az_rad", "scalar", scalar="f64"),
        Field("el_rad", "scalar", scalar="f64"),
        Field("carrier_hz", "scalar", scalar="f64"),
        Field("code", "array", scalar="f64", length=4),
        Field("carrier_cycles", "scalar", scalar="i64"),
        Field("carrier", "array", scalar="f64", length=4),
        Field("transmit", "scalar", scalar="i64"),
        Field("transmit_fraction_ns", "scalar", scalar="f64"),
        Field("power_dbw", "scalar", scalar="f32"),
        Field("echo", "scalar", scalar="u16"),
    )

    sat: SatId = dataclasses.field(default_factory=SatId)
    signal: int = 0
    flags: ChannelFlags = ChannelFlags(0)
    az_rad: float = 0.0
    el_rad: float = 0.0
    carrier_hz: float = 0.0
    code: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 4)
    carrier_cycles: int = 0
    carrier: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 4)
    transmit: int = 0
    transmit_fraction_ns: float = 0.0
    power_dbw: float = 0.0
    echo: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Jammer(Record):
    """A transmitter that disturbs, as an antenna receives it at the block's begin; what it sends is the generator's to make.

    number: its place in the scenario's list
    waveform: the scenario's name of what it sends
    az_rad [rad]: azimuth, clockwise from North
    el_rad [rad]: elevation above the ellipsoidal horizon
    range_m [m]: distance
    range_rate_mps [m/s]: its rate
    carrier_hz [Hz]: carrier as it is sent
    doppler_hz [Hz]: by which it arrives higher
    power_dbw [dBW]: received by an antenna of 0 dBi, free space between
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("number", "scalar", scalar="u16"),
        Field("waveform", "string", limit=32),
        Field("az_rad", "scalar", scalar="f64"),
        Field("el_rad", "scalar", scalar="f64"),
        Field("range_m", "scalar", scalar="f64"),
        Field("range_rate_mps", "scalar", scalar="f64"),
        Field("carrier_hz", "scalar", scalar="f64"),
        Field("doppler_hz", "scalar", scalar="f64"),
        Field("power_dbw", "scalar", scalar="f32"),
    )

    number: int = 0
    waveform: str = ""
    az_rad: float = 0.0
    el_rad: float = 0.0
    range_m: float = 0.0
    range_rate_mps: float = 0.0
    carrier_hz: float = 0.0
    doppler_hz: float = 0.0
    power_dbw: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class ChannelTerms(Record):
    """What a code at the block's begin is the sum of, in metres; of the carrier the ionosphere (and its emission part, and
    disturbance) has the other sign, its second order the other sign and half the size, wind_up and phase_bias join,
    scintillation, land_mobile and echo_phase join, residual_carrier too; group_delay, receiver_delay, residual_code and
    fault_divergence do not.

    distance_m [m]: antenna to centre of mass, in the Earth's axes of emission and of reception, not turned
    sagnac_m [m]: rotation of the Earth during the flight
    shapiro_m [m]: relativistic delay in the Earth's field
    satellite_clock_m [m]: minus c times the satellite's clock offset
    clock_noise_m [m]: minus c times the noise of that clock between the nodes of its product
    relativity_m [m]: minus c times the periodic relativity of that clock
    group_delay_m [m]: c times the signal's group delay against the clock's pair
    satellite_antenna_m [m]: phase centre of the satellite's antenna: offset and variation
    receiver_antenna_m [m]: likewise of the receiver's
    solid_tide_m [m]: tide of the solid Earth below a fixed antenna
    pole_tide_m [m]: tide of the pole's wandering, likewise
    ocean_loading_m [m]: weight of the ocean's tides, likewise
    troposphere_hydrostatic_m [m]: hydrostatic delay
    troposphere_wet_m [m]: wet delay
    turbulence_m [m]: turbulence of water vapour: wet delay beside that
    ionosphere_m [m]: first order, of the code
    emission_m [m]: the satellite's motion while the signal is delayed, without the ionosphere's part
    emission_ionosphere_m [m]: the ionosphere's part
    wind_up_m [m]: turns of satellite and antenna, times the wavelength: of the carrier alone
    phase_bias_m [m]: the carrier's bias against the clock's pair of signals: of the carrier alone
    ionosphere_second_m [m]: second order of the ionosphere, of the code; 0 unless the scenario asks for it
    receiver_delay_m [m]: replay: delay of the recorded receiver's code, the same all day
    residual_code_m [m]: replay: what noise, multipath and the models' errors left of the recorded code
    residual_carrier_m [m]: replay: likewise of the carrier; it is in the carrier alone
    disturbance_m [m]: travelling disturbances and fronts of the ionosphere, of the code
    scintillation_m [m]: what irregularities of the ionosphere do to the phase: of the carrier alone
    land_mobile_m [m]: what scattered rays of a road do to the phase: of the carrier alone
    echo_m [m]: of an echo: how much longer its way is
    echo_phase_m [m]: of an echo: what the reflection retards the carrier by, times the wavelength: of the carrier alone
    spoofer_m [m]: of a false signal: the way from its transmitter, and the delay with which it sends
    fault_range_m [m]: faults.range: steps and ramps
    fault_noise_m [m]: faults.noise and faults.sine
    fault_clock_m [m]: faults.clock: minus c times the clock's error
    fault_divergence_m [m]: faults.divergence: of the code alone
    fault_orbit_m [m]: faults.orbit: what the displaced satellite adds to the range
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("distance_m", "scalar", scalar="f64"),
        Field("sagnac_m", "scalar", scalar="f64"),
        Field("shapiro_m", "scalar", scalar="f64"),
        Field("satellite_clock_m", "scalar", scalar="f64"),
        Field("clock_noise_m", "scalar", scalar="f64"),
        Field("relativity_m", "scalar", scalar="f64"),
        Field("group_delay_m", "scalar", scalar="f64"),
        Field("satellite_antenna_m", "scalar", scalar="f64"),
        Field("receiver_antenna_m", "scalar", scalar="f64"),
        Field("solid_tide_m", "scalar", scalar="f64"),
        Field("pole_tide_m", "scalar", scalar="f64"),
        Field("ocean_loading_m", "scalar", scalar="f64"),
        Field("troposphere_hydrostatic_m", "scalar", scalar="f64"),
        Field("troposphere_wet_m", "scalar", scalar="f64"),
        Field("turbulence_m", "scalar", scalar="f64"),
        Field("ionosphere_m", "scalar", scalar="f64"),
        Field("emission_m", "scalar", scalar="f64"),
        Field("emission_ionosphere_m", "scalar", scalar="f64"),
        Field("wind_up_m", "scalar", scalar="f64"),
        Field("phase_bias_m", "scalar", scalar="f64"),
        Field("ionosphere_second_m", "scalar", scalar="f64"),
        Field("receiver_delay_m", "scalar", scalar="f64"),
        Field("residual_code_m", "scalar", scalar="f64"),
        Field("residual_carrier_m", "scalar", scalar="f64"),
        Field("disturbance_m", "scalar", scalar="f64"),
        Field("scintillation_m", "scalar", scalar="f64"),
        Field("land_mobile_m", "scalar", scalar="f64"),
        Field("echo_m", "scalar", scalar="f64"),
        Field("echo_phase_m", "scalar", scalar="f64"),
        Field("spoofer_m", "scalar", scalar="f64"),
        Field("fault_range_m", "scalar", scalar="f64"),
        Field("fault_noise_m", "scalar", scalar="f64"),
        Field("fault_clock_m", "scalar", scalar="f64"),
        Field("fault_divergence_m", "scalar", scalar="f64"),
        Field("fault_orbit_m", "scalar", scalar="f64"),
    )

    distance_m: float = 0.0
    sagnac_m: float = 0.0
    shapiro_m: float = 0.0
    satellite_clock_m: float = 0.0
    clock_noise_m: float = 0.0
    relativity_m: float = 0.0
    group_delay_m: float = 0.0
    satellite_antenna_m: float = 0.0
    receiver_antenna_m: float = 0.0
    solid_tide_m: float = 0.0
    pole_tide_m: float = 0.0
    ocean_loading_m: float = 0.0
    troposphere_hydrostatic_m: float = 0.0
    troposphere_wet_m: float = 0.0
    turbulence_m: float = 0.0
    ionosphere_m: float = 0.0
    emission_m: float = 0.0
    emission_ionosphere_m: float = 0.0
    wind_up_m: float = 0.0
    phase_bias_m: float = 0.0
    ionosphere_second_m: float = 0.0
    receiver_delay_m: float = 0.0
    residual_code_m: float = 0.0
    residual_carrier_m: float = 0.0
    disturbance_m: float = 0.0
    scintillation_m: float = 0.0
    land_mobile_m: float = 0.0
    echo_m: float = 0.0
    echo_phase_m: float = 0.0
    spoofer_m: float = 0.0
    fault_range_m: float = 0.0
    fault_noise_m: float = 0.0
    fault_clock_m: float = 0.0
    fault_divergence_m: float = 0.0
    fault_orbit_m: float = 0.0


@dataclasses.dataclass(eq=False, slots=True)
class Event(Record):
    """Something that happens at an instant.

    at [ns]: when
    kind: what
    sat: of which satellite; both numbers 0: of none
    message: of EPHEMERIS and HEALTH: of which message
    antenna: of RISE and SET: for which antenna of CAPS; 65535 otherwise
    value: see kind; 0 where it has none
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("at", "scalar", scalar="i64"),
        Field("kind", "scalar", scalar="u8", enum=EventKind),
        Field("sat", "struct", record=SatId),
        Field("message", "scalar", scalar="u8", enum=NavMessage),
        Field("antenna", "scalar", scalar="u16"),
        Field("value", "scalar", scalar="i64"),
    )

    at: int = 0
    kind: EventKind = EventKind(0)
    sat: SatId = dataclasses.field(default_factory=SatId)
    message: NavMessage = NavMessage(0)
    antenna: int = 0
    value: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class ModeChange(Record):
    """The service went over from one mode to another.

    number: 1, 2, ... since the scenario was loaded
    at [ns]: the scenario's instant then; of MOTION the begin of the block
    kind: of what
    before: which it was
    mode: which it is from then on
    reserved: 0
    wall [ns]: the wall's instant at which that was noted
    """

    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("number", "scalar", scalar="u64"),
        Field("at", "scalar", scalar="i64"),
        Field("kind", "scalar", scalar="u8", enum=ModeKind),
        Field("before", "scalar", scalar="u8", enum=Mode),
        Field("mode", "scalar", scalar="u8", enum=Mode),
        Field("reserved", "scalar", scalar="u8"),
        Field("wall", "scalar", scalar="i64"),
    )

    number: int = 0
    at: int = 0
    kind: ModeKind = ModeKind(0)
    before: Mode = Mode(0)
    mode: Mode = Mode(0)
    reserved: int = 0
    wall: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Hello(Record):
    """Opens a conversation. Optional, but a client that sends it learns what is served.

    major_min: lowest major version the client speaks
    major_max: highest
    name: name of the client, for the server's log
    version: its version
    """

    TYPE: ClassVar[int] = 1
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("major_min", "scalar", scalar="u8"),
        Field("major_max", "scalar", scalar="u8"),
        Field("name", "string", limit=64),
        Field("version", "string", limit=32),
    )

    major_min: int = 0
    major_max: int = 0
    name: str = ""
    version: str = ""


@dataclasses.dataclass(eq=False, slots=True)
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
    antennas: antennas that receive; none where no signals are sent
    signals: signals that are sent
    transmitters: satellites that send them
    requests: what is answered; anything else is refused with NOT_SERVED or UNKNOWN_TYPE
    satellites: served satellites, in the order in which STATES lists them
    access: what this client may not do, and how it came
    """

    TYPE: ClassVar[int] = 2
    LAYOUT: ClassVar[tuple[Field, ...]] = (
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
        Field("navdata_point", "scalar", scalar="u8", enum=OrbitPoint),
        Field("receiver_source", "scalar", scalar="u8", enum=ReceiverSource),
        Field("receiver_unit", "scalar", scalar="u16"),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("imu_rate_hz", "scalar", scalar="f64"),
        Field("units", "list", record=InertialUnit, limit=64),
        Field("antennas", "list", record=Antenna, limit=16),
        Field("signals", "list", record=Signal, limit=64),
        Field("transmitters", "list", record=Transmitter, limit=800),
        Field("requests", "list", record=ServedRequest, limit=64),
        Field("satellites", "list", record=SatId, limit=800),
        Field("access", "scalar", scalar="u16", enum=Access),
    )

    major: int = 0
    minor: int = 0
    max_request: int = 0
    max_epochs: int = 0
    span: Span = dataclasses.field(default_factory=Span)
    name: str = ""
    version: str = ""
    title: str = ""
    frame: str = ""
    leap: LeapSeconds = dataclasses.field(default_factory=LeapSeconds)
    navdata_point: OrbitPoint = OrbitPoint(0)
    receiver_source: ReceiverSource = ReceiverSource(0)
    receiver_unit: int = 0
    receiver_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    imu_rate_hz: float = 0.0
    units: list[InertialUnit] = dataclasses.field(default_factory=list)
    antennas: list[Antenna] = dataclasses.field(default_factory=list)
    signals: list[Signal] = dataclasses.field(default_factory=list)
    transmitters: list[Transmitter] = dataclasses.field(default_factory=list)
    requests: list[ServedRequest] = dataclasses.field(default_factory=list)
    satellites: list[SatId] = dataclasses.field(default_factory=list)
    access: Access = Access(0)


@dataclasses.dataclass(eq=False, slots=True)
class Ping(Record):
    """Asks whether the server is alive; also keeps an idle connection open.

    token: anything
    """

    TYPE: ClassVar[int] = 3
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("token", "scalar", scalar="u64"),
    )

    token: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Pong(Record):
    """The answer to a PING.

    token: that of the PING
    """

    TYPE: ClassVar[int] = 4
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("token", "scalar", scalar="u64"),
    )

    token: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Error(Record):
    """A refusal. Answers the request whose sequence number it bears; 0 where no request could be read.

    code: class of failure, for programs
    request: message type of the refused request, 0 if none
    sentence: what was wrong, for people
    """

    TYPE: ClassVar[int] = 5
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("code", "scalar", scalar="u16", enum=ErrorCode),
        Field("request", "scalar", scalar="u16"),
        Field("sentence", "string", limit=512),
    )

    code: ErrorCode = ErrorCode(0)
    request: int = 0
    sentence: str = ""


@dataclasses.dataclass(eq=False, slots=True)
class Poll(Record):
    """Asks for satellite states. The same POLL gets the same bytes, always.

    epochs: when
    satellites: which, in the order of the answer; empty for all
    """

    TYPE: ClassVar[int] = 6
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("satellites", "list", record=SatId, limit=800),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    satellites: list[SatId] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class States(Record):
    """Satellite states at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE: ClassVar[int] = 7
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("satellites", "list", record=SatState, limit=800),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    satellites: list[SatState] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollElements(Record):
    """Asks for Kepler elements. The same POLL_ELEMENTS gets the same bytes, always.

    epochs: when
    frame: axes that the elements refer to
    method: how they are made
    satellites: which, in the order of the answer; empty for all
    """

    TYPE: ClassVar[int] = 8
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("frame", "scalar", scalar="u8", enum=ElementsFrame),
        Field("method", "scalar", scalar="u8", enum=ElementsMethod),
        Field("satellites", "list", record=SatId, limit=800),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    frame: ElementsFrame = ElementsFrame(0)
    method: ElementsMethod = ElementsMethod(0)
    satellites: list[SatId] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Elements(Record):
    """Kepler elements at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    frame: as asked
    method: as asked
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE: ClassVar[int] = 9
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("frame", "scalar", scalar="u8", enum=ElementsFrame),
        Field("method", "scalar", scalar="u8", enum=ElementsMethod),
        Field("satellites", "list", record=SatElements, limit=800),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    frame: ElementsFrame = ElementsFrame(0)
    method: ElementsMethod = ElementsMethod(0)
    satellites: list[SatElements] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollNavdata(Record):
    """Asks for the broadcast data. Frames of LNAV, FDMA, D1 and D2 last 30 s; who asks again at frame_to has all that is sent.
    The same POLL_NAVDATA gets the same bytes, always.

    epochs: when
    satellites: which, in the order of the answer; empty for all
    kinds: which messages; 0: of each satellite its first, LNAV, FDMA, INAV on E1, D1 or D2
    form: pages as bits or as symbols
    """

    TYPE: ClassVar[int] = 10
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("satellites", "list", record=SatId, limit=800),
        Field("kinds", "scalar", scalar="u32", enum=NavMessages),
        Field("form", "scalar", scalar="u8", enum=NavForm),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    satellites: list[SatId] = dataclasses.field(default_factory=list)
    kinds: NavMessages = NavMessages(0)
    form: NavForm = NavForm(0)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Navdata(Record):
    """Broadcast data at one epoch.

    epoch: OK, or OUTSIDE_SPAN with no satellites
    satellites: those asked for, in that order, each with its messages; for all, those of CAPS
    """

    TYPE: ClassVar[int] = 11
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("satellites", "list", record=SatNavdata, limit=800),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    satellites: list[SatNavdata] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollDelays(Record):
    """Asks for ionospheric delays. The same POLL_DELAYS gets the same bytes, always.

    epochs: when
    receiver_m [m]: receiver (ecef); three times NAN for the scenario's own, which may move from epoch to epoch
    carriers_hz [Hz]: carriers to give delays for; empty for 1575.42 MHz
    satellites: which, in the order of the answer; empty for all
    """

    TYPE: ClassVar[int] = 12
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("carriers_hz", "list", scalar="f64", limit=4),
        Field("satellites", "list", record=SatId, limit=800),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    receiver_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    carriers_hz: list[float] = dataclasses.field(default_factory=list)
    satellites: list[SatId] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Delays(Record):
    """Ionospheric delays at one epoch.

    epoch: OK, or OUTSIDE_SPAN of orbits, ionosphere or trajectory, with no satellites
    receiver_m [m]: the receiver that was taken (ecef); NAN outside the span of the scenario's trajectory
    carriers_hz [Hz]: the carriers of delay_m
    satellites: those asked for, in that order; for all, those of CAPS
    """

    TYPE: ClassVar[int] = 13
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("receiver_m", "array", scalar="f64", length=3),
        Field("carriers_hz", "list", scalar="f64", limit=4),
        Field("satellites", "list", record=SatDelay, limit=800),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    receiver_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    carriers_hz: list[float] = dataclasses.field(default_factory=list)
    satellites: list[SatDelay] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollChannels(Record):
    """Asks for the blocks of an antenna's channels that hold the epochs. The same POLL_CHANNELS gets the same bytes, always.

    epochs: when
    antenna: which antenna of CAPS
    terms: 1: with what each code is the sum of; 0: without
    signals: which signals of CAPS; empty for all
    """

    TYPE: ClassVar[int] = 14
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("antenna", "scalar", scalar="u16"),
        Field("terms", "scalar", scalar="u16"),
        Field("signals", "list", scalar="u16", limit=64),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    antenna: int = 0
    terms: int = 0
    signals: list[int] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Channels(Record):
    """The block of an antenna's channels that holds one epoch. Neighbouring blocks join in value and rate.

    epoch: OK, or OUTSIDE_SPAN with no channels
    antenna: the antenna asked for
    block [ns]: begin of the block, a multiple of its length; -2^63 unless OK
    length [ns]: its length, at least 1 ms and at most 1 s
    error_m [m]: greatest error of cubics against the antenna's motion that was found in these 10 s; above channel.error_m
    where even 1 ms does not hold it
    pos_m [m]: antenna reference point at the block's begin (ecef)
    vel_mps [m/s]: its velocity (ecef)
    motion: where this motion comes from
    motion_age [ns]: live: the block's begin less the tag of the sample that it rests on; 0 otherwise
    channels: those that the antenna sees at the block's begin, by satellite, signal and echo; behind them the false ones
    terms: of each channel, in the same order; empty unless asked for
    jammers: those that send then
    """

    TYPE: ClassVar[int] = 15
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("antenna", "scalar", scalar="u16"),
        Field("block", "scalar", scalar="i64"),
        Field("length", "scalar", scalar="i64"),
        Field("error_m", "scalar", scalar="f64"),
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("motion", "scalar", scalar="u8", enum=MotionState),
        Field("motion_age", "scalar", scalar="i64"),
        Field("channels", "list", record=SatChannel, limit=4096),
        Field("terms", "list", record=ChannelTerms, limit=4096),
        Field("jammers", "list", record=Jammer, limit=16),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    antenna: int = 0
    block: int = 0
    length: int = 0
    error_m: float = 0.0
    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    vel_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    motion: MotionState = MotionState(0)
    motion_age: int = 0
    channels: list[SatChannel] = dataclasses.field(default_factory=list)
    terms: list[ChannelTerms] = dataclasses.field(default_factory=list)
    jammers: list[Jammer] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollImu(Record):
    """Asks for inertial increments over intervals, ideal ones or, where the scenario has imu.errors, what sensors with errors
    measure. The same POLL_IMU gets the same bytes, always.

    epochs: begins of the intervals, which are step long (0 to 1 h; 0: that of CAPS imu_rate_hz)
    unit: which inertial unit of the scenario; 0 is the trajectory's own point
    """

    TYPE: ClassVar[int] = 16
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("unit", "scalar", scalar="u16"),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    unit: int = 0

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Imu(Record):
    """Integrals of absolute angular rate and specific force over one interval, in the unit's axes (right, forward, up).

    epoch: begin of the interval; OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN
    t1 [ns]: end of the interval
    unit: the unit asked for
    readings: of perfect sensors, or of those with the scenario's errors
    dtheta_rad [rad]: integral of the absolute angular rate
    dv_mps [m/s]: integral of the specific force; at rest +g upward
    """

    TYPE: ClassVar[int] = 17
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("t1", "scalar", scalar="i64"),
        Field("unit", "scalar", scalar="u16"),
        Field("readings", "scalar", scalar="u8", enum=Readings),
        Field("dtheta_rad", "array", scalar="f64", length=3),
        Field("dv_mps", "array", scalar="f64", length=3),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    t1: int = 0
    unit: int = 0
    readings: Readings = Readings(0)
    dtheta_rad: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    dv_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class PollTruth(Record):
    """Asks for the true motion of an inertial unit. The same POLL_TRUTH gets the same bytes, always.

    epochs: when
    unit: which inertial unit of the scenario; 0 is the trajectory's own point
    """

    TYPE: ClassVar[int] = 18
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
        Field("unit", "scalar", scalar="u16"),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)
    unit: int = 0

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
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

    TYPE: ClassVar[int] = 19
    LAYOUT: ClassVar[tuple[Field, ...]] = (
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

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    unit: int = 0
    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    vel_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    acc_mps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    attitude: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 4)
    heading_rad: float = 0.0
    pitch_rad: float = 0.0
    roll_rad: float = 0.0
    rate_radps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    force_mps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    disturbance_mgal: float = 0.0
    eotvos_mgal: float = 0.0
    vertical_mps2: float = 0.0

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class Subscribe(Record):
    """Asks for a stream. Its blocks are frames of the kind that answers the named request, and each is, byte for byte, the
    answer to that request for its instant alone. All frames of the stream bear the sequence number of the SUBSCRIBE, which is
    the stream's number.

    request: POLL, POLL_NAVDATA, POLL_CHANNELS, POLL_IMU, POLL_TRUTH, POLL_EVENTS or GET_MODES
    pacing: when blocks are made
    delivery: how they come
    credit: how many blocks may be sent before there is more credit (CREDIT)
    lead [ns]: with CLOCK and MOTION: how long before its instant a block is made, 0 to 60 s
    poll: payload of that request. t: the first instant, -2^63 for the next one; step: from block to block, 1 ms to 60 s
    (POLL_IMU: 1 s), of POLL_CHANNELS also 0: every block once, of POLL_NAVDATA 0: every frame once; count: how many, 0 for no
    end. GET_MODES has none of these: its blocks come when modes change
    port: with DATAGRAMS: the UDP port, of the address that the connection comes from
    """

    TYPE: ClassVar[int] = 20
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("request", "scalar", scalar="u16"),
        Field("pacing", "scalar", scalar="u8", enum=Pacing),
        Field("delivery", "scalar", scalar="u8", enum=Delivery),
        Field("credit", "scalar", scalar="u32"),
        Field("lead", "scalar", scalar="i64"),
        Field("poll", "bytes", limit=16384),
        Field("port", "scalar", scalar="u16"),
    )

    request: int = 0
    pacing: Pacing = Pacing(0)
    delivery: Delivery = Delivery(0)
    credit: int = 0
    lead: int = 0
    poll: bytes = b""
    port: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Subscribed(Record):
    """The stream is there; its blocks follow.

    first [ns]: instant of its first block
    step [ns]: from block to block; 0: as long as they or their frames are
    channel: with DATAGRAMS: the channel that its datagrams name; 0 otherwise
    """

    TYPE: ClassVar[int] = 21
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("first", "scalar", scalar="i64"),
        Field("step", "scalar", scalar="i64"),
        Field("channel", "scalar", scalar="u32"),
    )

    first: int = 0
    step: int = 0
    channel: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Unsubscribe(Record):
    """Ends a stream; its last frame is a STREAM_END. Of a stream that has ended already it is passed over.

    stream: sequence number of its SUBSCRIBE
    """

    TYPE: ClassVar[int] = 22
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("stream", "scalar", scalar="u32"),
    )

    stream: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Credit(Record):
    """Lets a stream send so many blocks more. Of a stream that has ended already it is passed over.

    stream: sequence number of its SUBSCRIBE
    blocks: how many more
    """

    TYPE: ClassVar[int] = 23
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("stream", "scalar", scalar="u32"),
        Field("blocks", "scalar", scalar="u32"),
    )

    stream: int = 0
    blocks: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Gap(Record):
    """Blocks of a stream that will not come. The next block is the first after them.

    first [ns]: instant of the first that was left out
    last [ns]: instant of the last
    blocks: how many; of channels by their blocks 0, for their lengths were not looked at
    reason: why
    """

    TYPE: ClassVar[int] = 24
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("first", "scalar", scalar="i64"),
        Field("last", "scalar", scalar="i64"),
        Field("blocks", "scalar", scalar="u32"),
        Field("reason", "scalar", scalar="u8", enum=GapReason),
    )

    first: int = 0
    last: int = 0
    blocks: int = 0
    reason: GapReason = GapReason(0)


@dataclasses.dataclass(eq=False, slots=True)
class StreamEnd(Record):
    """The last frame of a stream.

    next [ns]: instant of the block that would have come next: where another SUBSCRIBE goes on
    reason: why
    sentence: the same, for people
    """

    TYPE: ClassVar[int] = 25
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("next", "scalar", scalar="i64"),
        Field("reason", "scalar", scalar="u8", enum=EndReason),
        Field("sentence", "string", limit=200),
    )

    next: int = 0
    reason: EndReason = EndReason(0)
    sentence: str = ""


@dataclasses.dataclass(eq=False, slots=True)
class Control(Record):
    """Controls the scenario's clock; answered by what it is then.

    action: what to do
    reference: with ARM, and with START of one that was not armed: what paces it
    reserved: 0
    t [ns]: instant of the scenario; -2^63: where it stands
    at [ns]: with START: the wall's instant (GPS scale) at which it goes; -2^63: at once
    delay [ns]: with START: so much later, 0 to an hour
    scenario: with LOAD: name of another scenario of the server's folder (serve --scenarios), without its ending; empty: this
    one
    """

    TYPE: ClassVar[int] = 26
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("action", "scalar", scalar="u8", enum=ControlAction),
        Field("reference", "scalar", scalar="u8", enum=ClockReference),
        Field("reserved", "scalar", scalar="u16"),
        Field("t", "scalar", scalar="i64"),
        Field("at", "scalar", scalar="i64"),
        Field("delay", "scalar", scalar="i64"),
        Field("scenario", "string", limit=64),
    )

    action: ControlAction = ControlAction(0)
    reference: ClockReference = ClockReference(0)
    reserved: int = 0
    t: int = 0
    at: int = 0
    delay: int = 0
    scenario: str = ""


@dataclasses.dataclass(eq=False, slots=True)
class GetTime(Record):
    """Asks what the scenario's clock shows.

    reserved: 0
    """

    TYPE: ClassVar[int] = 27
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("reserved", "scalar", scalar="u32"),
    )

    reserved: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Time(Record):
    """The scenario's clock at the moment of the answer.

    t [ns]: the scenario's instant; before a start that is fixed it counts down
    state: whether it runs
    reference: what paces it
    week: GPS week, unwrapped
    tow [ns]: time of that week
    leap: leap seconds in force, and the next change
    utc_mjd [d]: modified Julian day of UTC
    n4: GLONASS: four-year interval of the day in Moscow; 0 where it has no number
    nt: and the day in it
    utc_su [ns]: time of the day in Moscow, UTC(SU) + 3 h
    pps0 [ns]: the scenario's instant at PPS0; -2^63: none was fixed
    host [ns]: the server's CLOCK_MONOTONIC at this moment
    wall [ns]: the wall's instant at this moment
    error_ns [ns]: last RADIO_TIME against what the loop expected
    rate: generator seconds a second of the host, less 1
    wander_ns [ns]: root mean square of those errors, of late
    samples: RADIO_TIMEs since the loop took up its lock
    steps: how often the generator's time stepped, so that the lock was taken up anew
    suspends: how often the host was suspended
    sets: how often the host's wall clock was set
    """

    TYPE: ClassVar[int] = 28
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("state", "scalar", scalar="u8", enum=ClockState),
        Field("reference", "scalar", scalar="u8", enum=ClockReference),
        Field("week", "scalar", scalar="i32"),
        Field("tow", "scalar", scalar="i64"),
        Field("leap", "struct", record=LeapSeconds),
        Field("utc_mjd", "scalar", scalar="i32"),
        Field("n4", "scalar", scalar="u16"),
        Field("nt", "scalar", scalar="u16"),
        Field("utc_su", "scalar", scalar="i64"),
        Field("pps0", "scalar", scalar="i64"),
        Field("host", "scalar", scalar="i64"),
        Field("wall", "scalar", scalar="i64"),
        Field("error_ns", "scalar", scalar="f64"),
        Field("rate", "scalar", scalar="f64"),
        Field("wander_ns", "scalar", scalar="f64"),
        Field("samples", "scalar", scalar="u64"),
        Field("steps", "scalar", scalar="u32"),
        Field("suspends", "scalar", scalar="u32"),
        Field("sets", "scalar", scalar="u32"),
    )

    t: int = 0
    state: ClockState = ClockState(0)
    reference: ClockReference = ClockReference(0)
    week: int = 0
    tow: int = 0
    leap: LeapSeconds = dataclasses.field(default_factory=LeapSeconds)
    utc_mjd: int = 0
    n4: int = 0
    nt: int = 0
    utc_su: int = 0
    pps0: int = 0
    host: int = 0
    wall: int = 0
    error_ns: float = 0.0
    rate: float = 0.0
    wander_ns: float = 0.0
    samples: int = 0
    steps: int = 0
    suspends: int = 0
    sets: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class RadioTime(Record):
    """A generator tells its elapsed time, 1 to 1000 times a second; the scenario's clock follows it.

    elapsed [ns]: its time since its own begin, whose whole seconds are its 1PPS
    stamp [ns]: what a clock of the server's host showed then
    clock: which clock
    """

    TYPE: ClassVar[int] = 29
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("elapsed", "scalar", scalar="i64"),
        Field("stamp", "scalar", scalar="i64"),
        Field("clock", "scalar", scalar="u8", enum=StampClock),
    )

    elapsed: int = 0
    stamp: int = 0
    clock: StampClock = StampClock(0)


@dataclasses.dataclass(eq=False, slots=True)
class Pace(Record):
    """Where the scenario and its blocks are.

    t [ns]: the scenario's instant now
    error_ns [ns]: this RADIO_TIME against what the loop expected
    rate: generator seconds a second of the host, less 1
    wander_ns [ns]: root mean square of the errors, of late
    made [ns]: instant of the block that was made last for this connection; -2^63: none
    until_air [ns]: how long from now until it is on air; -2^63: the clock does not run, or there is none
    """

    TYPE: ClassVar[int] = 30
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("error_ns", "scalar", scalar="f64"),
        Field("rate", "scalar", scalar="f64"),
        Field("wander_ns", "scalar", scalar="f64"),
        Field("made", "scalar", scalar="i64"),
        Field("until_air", "scalar", scalar="i64"),
    )

    t: int = 0
    error_ns: float = 0.0
    rate: float = 0.0
    wander_ns: float = 0.0
    made: int = 0
    until_air: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Motion(Record):
    """A sample of the live motion of the body that antennas ride on. Wants a clock that is armed or runs, and a server that
    takes motion (serve --motion); answered by an ERROR where it cannot be used.

    t [ns]: tag: instant of the scenario at which it holds; later than that of the sample before
    order: highest derivative of the position that is given: 0 position, 1 velocity, 2 acceleration, 3 jerk
    angular_order: likewise: 0 no attitude (the body stands level, its front to North), 1 attitude, 2 rate, 3 acceleration, 4
    jerk
    point: of which point
    snap: 1: jump there at the next block instead of joining
    pos_m [m]: position (ecef)
    vel_mps [m/s]: velocity relative to the Earth (ecef)
    acc_mps2 [m/s2]: second derivative of the position (ecef)
    jerk_mps3 [m/s3]: third
    attitude: quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q; body is right, forward, up
    rate_radps [rad/s]: rate of the body relative to ecef, body axes
    rate2_radps2 [rad/s2]: its derivative
    rate3_radps3 [rad/s3]: and that one's
    """

    TYPE: ClassVar[int] = 31
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("order", "scalar", scalar="u8"),
        Field("angular_order", "scalar", scalar="u8"),
        Field("point", "scalar", scalar="u8", enum=MotionPoint),
        Field("snap", "scalar", scalar="u8"),
        Field("pos_m", "array", scalar="f64", length=3),
        Field("vel_mps", "array", scalar="f64", length=3),
        Field("acc_mps2", "array", scalar="f64", length=3),
        Field("jerk_mps3", "array", scalar="f64", length=3),
        Field("attitude", "array", scalar="f64", length=4),
        Field("rate_radps", "array", scalar="f64", length=3),
        Field("rate2_radps2", "array", scalar="f64", length=3),
        Field("rate3_radps3", "array", scalar="f64", length=3),
    )

    t: int = 0
    order: int = 0
    angular_order: int = 0
    point: MotionPoint = MotionPoint(0)
    snap: int = 0
    pos_m: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    vel_mps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    acc_mps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    jerk_mps3: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    attitude: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 4)
    rate_radps: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    rate2_radps2: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)
    rate3_radps3: list[float] = dataclasses.field(default_factory=lambda: [0.0] * 3)


@dataclasses.dataclass(eq=False, slots=True)
class GetMotionStats(Record):
    """Asks what became of the samples of motion, and lays down the worst state.

    reset: 1: counts begin anew afterwards
    """

    TYPE: ClassVar[int] = 32
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("reset", "scalar", scalar="u8"),
    )

    reset: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class MotionStats(Record):
    """What became of the samples of motion since the counts began.

    received: samples that came
    used: of them on which a block rests
    late: that came after a block for their instant was made
    early: that came before any block needed them
    dropped: that could not be used: tags that go back or lie far ahead, numbers that are none, jumps that were not asked for
    overtaken: on which no block came to rest before the next
    blocks: blocks made along live motion
    extrapolated: of them beyond the last sample
    joined: on the way back
    snapped: with a jump
    lateness: scenario's instant at arrival less the tag
    margin: tag less the end of what had been made at arrival
    buffered: samples that wait for their instant
    worst: worst state of a block since this was asked last
    """

    TYPE: ClassVar[int] = 33
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("received", "scalar", scalar="u64"),
        Field("used", "scalar", scalar="u64"),
        Field("late", "scalar", scalar="u64"),
        Field("early", "scalar", scalar="u64"),
        Field("dropped", "scalar", scalar="u64"),
        Field("overtaken", "scalar", scalar="u64"),
        Field("blocks", "scalar", scalar="u64"),
        Field("extrapolated", "scalar", scalar="u64"),
        Field("joined", "scalar", scalar="u64"),
        Field("snapped", "scalar", scalar="u64"),
        Field("lateness", "struct", record=MotionSpread),
        Field("margin", "struct", record=MotionSpread),
        Field("buffered", "scalar", scalar="u16"),
        Field("worst", "scalar", scalar="u8", enum=MotionState),
    )

    received: int = 0
    used: int = 0
    late: int = 0
    early: int = 0
    dropped: int = 0
    overtaken: int = 0
    blocks: int = 0
    extrapolated: int = 0
    joined: int = 0
    snapped: int = 0
    lateness: MotionSpread = dataclasses.field(default_factory=MotionSpread)
    margin: MotionSpread = dataclasses.field(default_factory=MotionSpread)
    buffered: int = 0
    worst: MotionState = MotionState(0)


@dataclasses.dataclass(eq=False, slots=True)
class PollEvents(Record):
    """Asks what happens in intervals. The same POLL_EVENTS gets the same bytes, always.

    epochs: begins of the intervals, which are step long (0 to 1 h; 0: an hour)
    """

    TYPE: ClassVar[int] = 34
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epochs", "struct", record=Epochs),
    )

    epochs: Epochs = dataclasses.field(default_factory=Epochs)

    @property
    def t(self) -> int:
        """first epoch"""
        return self.epochs.t

    @property
    def step(self) -> int:
        """from one epoch to the next; any sign, not 0 unless count is 1"""
        return self.epochs.step

    @property
    def count(self) -> int:
        """how many, 1 to MAX_EPOCHS"""
        return self.epochs.count


@dataclasses.dataclass(eq=False, slots=True)
class Events(Record):
    """What happens in one interval, its end not in it.

    epoch: begin of the interval; OK, or OUTSIDE_SPAN with no events
    t1 [ns]: end of the interval
    events: ascending in time; of one instant by kind, satellite and antenna
    """

    TYPE: ClassVar[int] = 35
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("epoch", "struct", record=Epoch),
        Field("t1", "scalar", scalar="i64"),
        Field("events", "list", record=Event, limit=8192),
    )

    epoch: Epoch = dataclasses.field(default_factory=Epoch)
    t1: int = 0
    events: list[Event] = dataclasses.field(default_factory=list)

    @property
    def t(self) -> int:
        """the instant"""
        return self.epoch.t

    @property
    def index(self) -> int:
        """which epoch of the request, from 0; the frame of count - 1 ends the answer"""
        return self.epoch.index

    @property
    def count(self) -> int:
        """how many epochs the request asked for"""
        return self.epoch.count

    @property
    def answer(self) -> Answer:
        """whether there are numbers at this instant"""
        return self.epoch.answer


@dataclasses.dataclass(eq=False, slots=True)
class OpenDatagrams(Record):
    """Asks for the connection's channel of datagrams, by which it may send MOTION, and for the keys of its datagrams in both
    directions. Asked again it tells the same channel and what has become of it.

    reserved: 0
    """

    TYPE: ClassVar[int] = 36
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("reserved", "scalar", scalar="u32"),
    )

    reserved: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Datagrams(Record):
    """The channel of a connection, which ends with it.

    channel: its number, which datagrams to the server name
    port: UDP port where the server takes motion; 0: none (serve --motion-udp)
    seal: what stands behind each frame, in both directions
    reserved: 0
    taken: datagrams of the channel that were new and whole
    replayed: that had come before, or lie more than 1024 numbers back
    refused: that named it and had another seal, came from elsewhere, or held no MOTION
    keys: with HMAC_SHA256: the key of what the client sends, then that of what the server sends, 32 bytes each; what the
    exporter of the TLS session gives (RFC 8446, 7.5) for the label EXPORTER-orrery-datagrams and an empty context
    """

    TYPE: ClassVar[int] = 37
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("channel", "scalar", scalar="u32"),
        Field("port", "scalar", scalar="u16"),
        Field("seal", "scalar", scalar="u8", enum=Seal),
        Field("reserved", "scalar", scalar="u8"),
        Field("taken", "scalar", scalar="u64"),
        Field("replayed", "scalar", scalar="u64"),
        Field("refused", "scalar", scalar="u64"),
        Field("keys", "bytes", limit=64),
    )

    channel: int = 0
    port: int = 0
    seal: Seal = Seal(0)
    reserved: int = 0
    taken: int = 0
    replayed: int = 0
    refused: int = 0
    keys: bytes = b""


@dataclasses.dataclass(eq=False, slots=True)
class OpenMotionRing(Record):
    """Asks for a ring of shared memory into which a client on the server's host writes MOTION, over a Unix socket
    (docs/protocol.md, The ring). Asked again it tells what has become of it.

    reserved: 0
    """

    TYPE: ClassVar[int] = 38
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("reserved", "scalar", scalar="u32"),
    )

    reserved: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class MotionRing(Record):
    """The ring. With the first answer come two descriptors, of the memory and of an eventfd that wakes the server; the ring
    ends with the connection.

    slots: messages that the ring holds
    stride: bytes of a slot
    taken: messages that the server has read
    lost: that had been written over before it came to them
    """

    TYPE: ClassVar[int] = 39
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("slots", "scalar", scalar="u32"),
        Field("stride", "scalar", scalar="u32"),
        Field("taken", "scalar", scalar="u64"),
        Field("lost", "scalar", scalar="u64"),
    )

    slots: int = 0
    stride: int = 0
    taken: int = 0
    lost: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class GetModes(Record):
    """Asks which modes the service has changed over to. May be subscribed to as well.

    after: number of the last change that is known; 0: all that are kept; 2^64 - 1: those from now on
    """

    TYPE: ClassVar[int] = 40
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("after", "scalar", scalar="u64"),
    )

    after: int = 0


@dataclasses.dataclass(eq=False, slots=True)
class Modes(Record):
    """Mode changes of the service, the oldest first.

    t [ns]: what the scenario's clock shows
    last: number of the last change listed, to ask on from; without any that of the last there was
    lost: changes after `after` that are not kept any more (1024 are)
    more: 1: there are more behind the last one listed
    changes: what changed
    """

    TYPE: ClassVar[int] = 41
    LAYOUT: ClassVar[tuple[Field, ...]] = (
        Field("t", "scalar", scalar="i64"),
        Field("last", "scalar", scalar="u64"),
        Field("lost", "scalar", scalar="u64"),
        Field("more", "scalar", scalar="u8"),
        Field("changes", "list", record=ModeChange, limit=100),
    )

    t: int = 0
    last: int = 0
    lost: int = 0
    more: int = 0
    changes: list[ModeChange] = dataclasses.field(default_factory=list)


MESSAGES: dict[int, Type[Record]] = {
    1: Hello,
    2: Caps,
    3: Ping,
    4: Pong,
    5: Error,
    6: Poll,
    7: States,
    8: PollElements,
    9: Elements,
    10: PollNavdata,
    11: Navdata,
    12: PollDelays,
    13: Delays,
    14: PollChannels,
    15: Channels,
    16: PollImu,
    17: Imu,
    18: PollTruth,
    19: Truth,
    20: Subscribe,
    21: Subscribed,
    22: Unsubscribe,
    23: Credit,
    24: Gap,
    25: StreamEnd,
    26: Control,
    27: GetTime,
    28: Time,
    29: RadioTime,
    30: Pace,
    31: Motion,
    32: GetMotionStats,
    33: MotionStats,
    34: PollEvents,
    35: Events,
    36: OpenDatagrams,
    37: Datagrams,
    38: OpenMotionRing,
    39: MotionRing,
    40: GetModes,
    41: Modes,
}
