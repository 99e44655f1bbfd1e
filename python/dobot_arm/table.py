"""Tables: columns of numpy arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd

    from ._core import Columns


class Table(Mapping[str, "np.ndarray[Any, Any]"]):
    """Rows and columns: ``table["x_mm"]`` is a read-only numpy array, which shares the memory of the table.

    The columns need numpy, :meth:`to_pandas` needs pandas.
    """

    def __init__(self, columns: Columns) -> None:
        self._columns = columns

    def __getitem__(self, name: str) -> np.ndarray[Any, Any]:
        dtype, values = self._columns[name]
        import numpy as np

        if isinstance(values, bytes):
            return np.frombuffer(values, dtype=dtype)
        return np.array(values, dtype=dtype)

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """How many columns there are."""
        return len(self._columns)

    @property
    def rows(self) -> int:
        """The number of rows."""
        return next((len(self[name]) for name in self), 0)

    def to_pandas(self) -> pd.DataFrame:
        """Returns the table as a pandas DataFrame."""
        import pandas as pd

        return pd.DataFrame({name: self[name] for name in self})

    def __repr__(self) -> str:
        return f"<Table: {', '.join(self)}>"
