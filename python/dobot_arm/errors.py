"""Exceptions."""

from __future__ import annotations

from typing import Any, Literal

Kind = Literal[
    "all-arms-given", "arm-busy", "arm-not-started", "bad-answer", "bad-button", "bad-drawing", "bad-fault",
    "bad-job", "bad-policy", "bad-program", "bad-scene", "bad-slots", "bad-touches", "button-file",
    "button-taken", "cannot-resume", "command", "detecting", "dialect-not-found", "drawing-phase", "ending",
    "file-changed", "file-exists", "file-name", "files-full", "files-unusable", "forbidden-host",
    "forbidden-origin", "gives-no-arms", "internal", "invalid", "job-phase", "job-running", "journal",
    "key-reused", "laser-disarmed", "lease-gone", "let-go", "locked", "malformed", "media-type", "member-away",
    "member-refused", "method", "name-taken", "needs-a-person", "no-fleet", "no-job-runs", "no-lease",
    "no-link", "no-listener", "no-question", "no-such-arm", "no-such-button", "no-such-drawing", "no-such-file", "no-such-job",
    "no-such-member", "no-such-recording", "no-such-token", "no-such-work", "no-vectors", "not-asking",
    "not-built",
    "not-delivered", "not-reached", "not-recorded", "not-virtual", "out-of-range", "policy", "policy-file", "recording",
    "role", "slot", "still-moving", "stopped", "timeout", "token-file", "token-name", "token-taken",
    "too-large", "too-many", "too-many-clients", "too-many-requests", "unauthorised", "unguarded",
    "unknown-path", "upgrade", "work-file", "work-phase", "work-refused",
]
"""The kind of a refusal: a problem type of the API."""


def kinds() -> dict[Kind, str]:
    """Returns what each kind of refusal means, and the remedy."""
    from ._core import problem_kinds

    return {name: explanation for name, _, explanation in problem_kinds()}


class Error(Exception):
    """An operation failed; ``hint`` describes the remedy."""

    hint: str | None

    def __init__(self, detail: str, *, hint: str | None = None) -> None:
        super().__init__(detail)
        self.hint = hint

    def __reduce__(self) -> tuple[Any, ...]:
        # The constructors of subclasses have keywords, which the default does not pass.
        return _restored, (type(self), self.args, self.__dict__)

    def __str__(self) -> str:
        detail = super().__str__()
        return detail if self.hint is None else f"{detail}\nhint: {self.hint}"


def _restored(cls: type[Error], args: tuple[Any, ...], fields: dict[str, Any]) -> Error:
    error = cls.__new__(cls, *args)
    error.__dict__.update(fields)
    return error


class Refused(Error):
    """The rules refuse the operation; nothing was sent to the arm."""

    kind: Kind
    """The kind: ``policy``, ``stopped``, ``no-lease``. :func:`kinds` describes each of them."""
    rule: str | None
    """The rule of the policy that would be violated."""
    at_mm: tuple[float, float, float] | None
    """The position on the path where the rule would be violated: x, y, z in millimetres."""
    nearest_mm: tuple[float, float, float] | None
    """The nearest allowed position: x, y, z in millimetres."""

    def __init__(
        self,
        detail: str,
        *,
        hint: str | None = None,
        kind: Kind,
        rule: str | None = None,
        at_mm: tuple[float, float, float] | None = None,
        nearest_mm: tuple[float, float, float] | None = None,
    ) -> None:
        super().__init__(detail, hint=hint)
        self.kind = kind
        self.rule = rule
        self.at_mm = at_mm
        self.nearest_mm = nearest_mm


class Failed(Error):
    """The operation was started, but did not finish."""


class Paused(Failed):
    """A job is paused: a step of a program waits for a person, a drawing for another pen, or somebody paused
    it.

    ``arm.resume()`` resumes it, ``arm.cancel()`` cancels it.
    """

    job: int
    """The number of the job."""

    def __init__(self, detail: str, *, hint: str | None = None, job: int) -> None:
        super().__init__(detail, hint=hint)
        self.job = job


class LinkLost(Error):
    """The station cannot be reached, or does not respond any more."""


class Stopped(Error):
    """The arm was stopped during the operation."""


class Closed(Error):
    """The arm was disconnected, or belongs to another process."""
