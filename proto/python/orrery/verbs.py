# SPDX-License-Identifier: MIT
# Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
# pylint: skip-file
"""What a client of Orrery can ask for: two methods a message with epochs."""
from __future__ import annotations

from typing import Iterable, Iterator, Optional, Union

from . import messages
from .asking import Asking, choice, step_ns, vector
from .gpstime import Time, time_tag
from .satellite import Satellite, sat_id


class Verbs(Asking):
    """Methods by message. t: a time tag, a text or a datetime (orrery.gpstime); satellites: names, empty for all."""

    def poll(self, t: Time, step_s: float = 0.0, count: int = 1,
             satellites: Iterable[Satellite] = ()) -> Iterator[messages.States]:
        """Yields the States of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for satellite states.
        The same POLL gets the same bytes, always.

        satellites: which, in the order of the answer; empty for all
        """
        return self._series(messages.Poll(messages.Epochs(time_tag(t), step_ns(step_s), 1),
                            satellites=[sat_id(s) for s in satellites]), messages.States, count)

    def states(self, t: Time, satellites: Iterable[Satellite] = ()) -> messages.States:
        """The States of one epoch; poll says more."""
        return self._single(messages.Poll(messages.Epochs(time_tag(t), 0, 1), satellites=[sat_id(s) for s in satellites]),
                            messages.States)

    def poll_elements(self, t: Time, step_s: float = 0.0, count: int = 1,
                      frame: Union[messages.ElementsFrame, str] = messages.ElementsFrame(0),
                      method: Union[messages.ElementsMethod, str] = messages.ElementsMethod(0),
                      satellites: Iterable[Satellite] = ()) -> Iterator[messages.Elements]:
        """Yields the Elements of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for Kepler elements.
        The same POLL_ELEMENTS gets the same bytes, always.

        frame: axes that the elements refer to
        method: how they are made
        satellites: which, in the order of the answer; empty for all
        """
        return self._series(messages.PollElements(messages.Epochs(time_tag(t), step_ns(step_s), 1),
                            frame=choice(messages.ElementsFrame, frame), method=choice(messages.ElementsMethod, method),
                            satellites=[sat_id(s) for s in satellites]), messages.Elements, count)

    def elements(self, t: Time, frame: Union[messages.ElementsFrame, str] = messages.ElementsFrame(0),
                 method: Union[messages.ElementsMethod, str] = messages.ElementsMethod(0),
                 satellites: Iterable[Satellite] = ()) -> messages.Elements:
        """The Elements of one epoch; poll_elements says more."""
        return self._single(messages.PollElements(messages.Epochs(time_tag(t), 0, 1), frame=choice(messages.ElementsFrame, frame),
                            method=choice(messages.ElementsMethod, method), satellites=[sat_id(s) for s in satellites]),
                            messages.Elements)

    def poll_navdata(self, t: Time, step_s: float = 0.0, count: int = 1, satellites: Iterable[Satellite] = (),
                     kinds: messages.NavMessages = messages.NavMessages(0),
                     form: Union[messages.NavForm, str] = messages.NavForm(0)) -> Iterator[messages.Navdata]:
        """Yields the Navdata of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for the broadcast data.
        Frames of LNAV, FDMA, D1 and D2 last 30 s; who asks again at frame_to has all that is sent. The same POLL_NAVDATA gets
        the same bytes, always.

        satellites: which, in the order of the answer; empty for all
        kinds: which messages; 0: of each satellite its first, LNAV, FDMA, INAV on E1, D1 or D2
        form: pages as bits or as symbols
        """
        return self._series(messages.PollNavdata(messages.Epochs(time_tag(t), step_ns(step_s), 1),
                            satellites=[sat_id(s) for s in satellites], kinds=kinds, form=choice(messages.NavForm, form)),
                            messages.Navdata, count)

    def navdata(self, t: Time, satellites: Iterable[Satellite] = (), kinds: messages.NavMessages = messages.NavMessages(0),
                form: Union[messages.NavForm, str] = messages.NavForm(0)) -> messages.Navdata:
        """The Navdata of one epoch; poll_navdata says more."""
        return self._single(messages.PollNavdata(messages.Epochs(time_tag(t), 0, 1), satellites=[sat_id(s) for s in satellites],
                            kinds=kinds, form=choice(messages.NavForm, form)), messages.Navdata)

    def poll_delays(self, t: Time, step_s: float = 0.0, count: int = 1, receiver_m: Optional[Iterable[float]] = None,
                    carriers_hz: Iterable[float] = (), satellites: Iterable[Satellite] = ()) -> Iterator[messages.Delays]:
        """Yields the Delays of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for ionospheric delays.
        The same POLL_DELAYS gets the same bytes, always.

        receiver_m [m]: receiver (ecef); three times NAN for the scenario's own, which may move from epoch to epoch
        carriers_hz [Hz]: carriers to give delays for; empty for 1575.42 MHz
        satellites: which, in the order of the answer; empty for all
        """
        return self._series(messages.PollDelays(messages.Epochs(time_tag(t), step_ns(step_s), 1), receiver_m=vector(receiver_m, 3),
                            carriers_hz=[float(x) for x in carriers_hz], satellites=[sat_id(s) for s in satellites]),
                            messages.Delays, count)

    def delays(self, t: Time, receiver_m: Optional[Iterable[float]] = None, carriers_hz: Iterable[float] = (),
               satellites: Iterable[Satellite] = ()) -> messages.Delays:
        """The Delays of one epoch; poll_delays says more."""
        return self._single(messages.PollDelays(messages.Epochs(time_tag(t), 0, 1), receiver_m=vector(receiver_m, 3),
                            carriers_hz=[float(x) for x in carriers_hz], satellites=[sat_id(s) for s in satellites]),
                            messages.Delays)

    def poll_channels(self, t: Time, step_s: float = 0.0, count: int = 1, antenna: int = 0, terms: int = 0,
                      signals: Iterable[int] = ()) -> Iterator[messages.Channels]:
        """Yields the Channels of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for the blocks of an
        antenna's channels that hold the epochs. The same POLL_CHANNELS gets the same bytes, always.

        antenna: which antenna of CAPS
        terms: 1: with what each code is the sum of; 0: without
        signals: which signals of CAPS; empty for all
        """
        return self._series(messages.PollChannels(messages.Epochs(time_tag(t), step_ns(step_s), 1), antenna=antenna, terms=terms,
                            signals=[int(x) for x in signals]), messages.Channels, count)

    def channels(self, t: Time, antenna: int = 0, terms: int = 0, signals: Iterable[int] = ()) -> messages.Channels:
        """The Channels of one epoch; poll_channels says more."""
        return self._single(messages.PollChannels(messages.Epochs(time_tag(t), 0, 1), antenna=antenna, terms=terms,
                            signals=[int(x) for x in signals]), messages.Channels)

    def poll_imu(self, t: Time, step_s: float = 0.0, count: int = 1, unit: int = 0) -> Iterator[messages.Imu]:
        """Yields the Imu of `count` epochs from t on, step_s apart (rounded to a nanosecond). t, step_s, count: begins of the
        intervals, which are step long (0 to 1 h; 0: that of CAPS imu_rate_hz). Asks for inertial increments over intervals,
        ideal ones or, where the scenario has imu.errors, what sensors with errors measure. The same POLL_IMU gets the same
        bytes, always.

        unit: which inertial unit of the scenario; 0 is the trajectory's own point
        """
        return self._series(messages.PollImu(messages.Epochs(time_tag(t), step_ns(step_s), 1), unit=unit), messages.Imu, count)

    def imu(self, t: Time, step_s: float = 0.0, unit: int = 0) -> messages.Imu:
        """The Imu of one epoch; poll_imu says more."""
        return self._single(messages.PollImu(messages.Epochs(time_tag(t), step_ns(step_s), 1), unit=unit), messages.Imu)

    def poll_truth(self, t: Time, step_s: float = 0.0, count: int = 1, unit: int = 0) -> Iterator[messages.Truth]:
        """Yields the Truth of `count` epochs from t on, step_s apart (rounded to a nanosecond). Asks for the true motion of an
        inertial unit. The same POLL_TRUTH gets the same bytes, always.

        unit: which inertial unit of the scenario; 0 is the trajectory's own point
        """
        return self._series(messages.PollTruth(messages.Epochs(time_tag(t), step_ns(step_s), 1), unit=unit), messages.Truth, count)

    def truth(self, t: Time, unit: int = 0) -> messages.Truth:
        """The Truth of one epoch; poll_truth says more."""
        return self._single(messages.PollTruth(messages.Epochs(time_tag(t), 0, 1), unit=unit), messages.Truth)

    def poll_events(self, t: Time, step_s: float = 0.0, count: int = 1) -> Iterator[messages.Events]:
        """Yields the Events of `count` epochs from t on, step_s apart (rounded to a nanosecond). t, step_s, count: begins of
        the intervals, which are step long (0 to 1 h; 0: an hour). Asks what happens in intervals. The same POLL_EVENTS gets
        the same bytes, always.

        """
        return self._series(messages.PollEvents(messages.Epochs(time_tag(t), step_ns(step_s), 1)), messages.Events, count)

    def events(self, t: Time, step_s: float = 0.0) -> messages.Events:
        """The Events of one epoch; poll_events says more."""
        return self._single(messages.PollEvents(messages.Epochs(time_tag(t), step_ns(step_s), 1)), messages.Events)
