"""What goes wrong, and what to do about it."""


class Error(Exception):
    """Something was not done; ``hint`` tells what to do about it."""

    hint: str | None

    def __init__(self, detail: str, *, hint: str | None = None) -> None:
        super().__init__(detail)
        self.hint = hint

    def __str__(self) -> str:
        detail = super().__str__()
        return detail if self.hint is None else f"{detail}\nhint: {self.hint}"


class Refused(Error):
    """The rules refuse it; nothing was sent to the arm."""

    kind: str
    """The kind of problem: its address in the API."""
    rule: str | None
    """The rule of the policy that it would break."""
    at_mm: tuple[float, float, float] | None
    """Where on its way the motion would break the rule: x, y, z in millimetres."""
    nearest_mm: tuple[float, float, float] | None
    """The nearest place that is allowed: x, y, z in millimetres."""

    def __init__(
        self,
        detail: str,
        *,
        hint: str | None = None,
        kind: str,
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
    """It was begun, and not done."""


class LinkLost(Error):
    """The station cannot be reached, or does not answer any more."""


class Stopped(Error):
    """The arm was stopped while this was under way."""


class Closed(Error):
    """The arm was let go of, or belongs to another process."""
