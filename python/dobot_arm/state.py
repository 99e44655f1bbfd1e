"""What a station knows about its arm."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Literal

from .status import Status


@dataclass(frozen=True)
class LinkState:
    """The link to the arm."""

    address: str | None
    """The address of the arm; None if there is none yet."""
    phase: Literal["searching", "listening", "up", "lost"]
    """``up`` if statuses arrive, ``listening`` before the first one."""
    problem: str | None
    """What is wrong, if anything."""
    remedy: str | None
    """What to do about it."""
    statuses_per_s: float
    """Statuses per second; nominally 12.5, or 18.75 over Bluetooth."""


@dataclass(frozen=True)
class ControlState:
    """Who has control of the arm."""

    client: int
    """The number of the client."""
    name: str
    """Its name."""
    mine: bool
    """Whether it is this connection."""
    since_s: float
    """When it got control, in seconds since the station started."""
    requests: dict[int, str]
    """The clients that ask for control: their numbers, for ``grant_control``, and names."""


@dataclass(frozen=True)
class StopState:
    """A stop that holds the arm."""

    by: str
    """Who stopped it."""
    reason: str | None
    """The reason."""
    at_s: float
    """When it was set, in seconds since the station started."""
    at_rest: bool
    """Whether the arm has been seen at rest since."""
    delivered: bool
    """Whether the stop has left the computer; if not, switch the arm off by hand."""


@dataclass(frozen=True)
class LaserState:
    """The interlock of the laser."""

    armed_for_s: float
    """How long it may still be switched on, in seconds; 0 if it is disarmed."""
    on: bool
    """Whether it may be on."""


@dataclass(frozen=True)
class JobState:
    """A drawing or program in the queue of the station."""

    job: int
    """Its number."""
    title: str
    """Its title."""
    kind: Literal["drawing", "program"]
    """Its kind."""
    phase: str
    """Its phase: ``queued``, ``running``, ``paused``, ``done``, ``cancelled`` or ``failed``."""
    reason: str | None
    """Why it is paused or failed."""
    waits_for_person: bool
    """Whether a person has to do something before it is resumed."""
    completed: int
    """The number of completed commands."""
    commands: int
    """The number of commands."""
    left_s: float | None
    """The remaining time in seconds, if known."""


@dataclass(frozen=True)
class State:
    """What a station knows, at one moment."""

    at_s: float
    """The time since the station started, in seconds."""
    status: Status | None
    """The last status of the arm; None before the first."""
    link: LinkState
    """The link to the arm."""
    dialect: str | None
    """The protocol dialect of the arm, if it is known: ``specification`` or ``firmware-1.1``."""
    trusted: bool
    """Whether the reported position can be trusted; otherwise a person confirms it."""
    trust_reason: str | None
    """Why it cannot be trusted."""
    control: ControlState | None
    """Who has control; None if it is free."""
    stop: StopState | None
    """The stop that holds the arm, if any."""
    locked: str | None
    """Why administrators have locked the arm; None if they have not."""
    laser: LaserState
    """The interlock of the laser."""
    jobs: tuple[JobState, ...]
    """All jobs, the oldest first."""
    policy: dict[str, Any]
    """The safety policy, with the names of its file."""
    clients: int
    """The number of connected clients."""

    @property
    def job(self) -> JobState | None:
        """The running or paused job, if any."""
        return next((job for job in self.jobs if job.phase in ("running", "paused")), None)

    @classmethod
    def _of(cls, text: str) -> State:
        known = json.loads(text)
        state = known["state"]
        lease, lock, arm = state["lease"], state.get("lock"), state["arm"]
        return cls(
            at_s=state["at_s"],
            status=None if arm is None else _picked(Status, {**arm, "at_s": state["at_s"]}),
            link=_picked(LinkState, state["link"]),
            dialect=state["dialect"],
            trusted=state["trust"]["trusted"],
            trust_reason=state["trust"]["reason"],
            control=None if lease is None else ControlState(
                client=lease["client"],
                name=lease["name"],
                mine=lease["client"] == known["client"],
                since_s=lease["since_s"],
                requests={asks["client"]: asks["name"] for asks in lease["asked_by"]},
            ),
            stop=None if state["stop"] is None else _picked(StopState, state["stop"]),
            locked=None if lock is None else lock["message"] or f"locked by {lock['by']}",
            laser=_picked(LaserState, state["laser"]),
            jobs=tuple(_picked(JobState, job) for job in known["jobs"]),
            policy=known["policy"],
            clients=state["clients"],
        )


def _picked(kind: type[Any], fields: dict[str, Any]) -> Any:
    """Creates an object from those of the fields that it has."""
    return kind(**{name: fields.get(name) for name in kind.__annotations__})
