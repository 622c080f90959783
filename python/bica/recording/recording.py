"""A recording as tables."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import pandas as pd

from bica.parameters import Setting
from bica.program import Program
from bica.recording.file import RecordingError, RecordingFile
from bica.recording.frames import flattened, frame, types
from bica.recording.image import Image, image_of
from bica.recording.postcard import decoder

LEVELS = {1: "debug", 2: "information", 3: "warning", 4: "error"}
WITHOUT_STATES = 255


class Recording:
    """A recording. The tables are read when they are first used; their index is the time in seconds.

    `table.attrs["units"]` has the units of the columns.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Open a file; raises RecordingError if it is no complete recording."""
        self.file = RecordingFile(path)
        self.header = self.file.header
        #: What the program needs to set up the same run again, by name.
        self.set_up: dict[str, Any] = dict(self.header["set_up"])
        #: Name and seed of the simulated world; None for a real robot.
        self.world: str | None = self.set_up.get("world")
        self.seed: int | None = self.set_up.get("seed")
        #: Result of the run as text; empty if the file was not closed.
        self.result = str(self.file.ending.get("result", ""))
        #: Numbers of the result, as the world reports them: name, value and unit of each.
        self.figures: list[dict[str, Any]] = self.file.ending.get("figures", [])
        self._components: list[dict[str, Any]] = self.header["tree"]["components"]
        self._names = [component["name"] for component in self._components]

    def __repr__(self) -> str:
        return f"Recording({str(self.file.path)!r}: {self.header['tree']['name']}, {self.file.ending.get('cycles')} cycles)"

    @property
    def settings(self) -> dict[str, Setting]:
        """Parameters that were not the defaults at the start: `bica.play(seed=…, world=…, set=…)` plays the game again."""
        table = self.parameters
        changed = table[(table["value"] != table["default"]) & table["value"].notna()]
        return {str(name): value for name, value in changed["value"].items()}

    @cached_property
    def parameters(self) -> pd.DataFrame:
        """Parameters at the start, a row for each `Component.name`, with default, unit, range and doc."""
        columns = ("value", "default", "unit", "kind", "min", "max", "step", "doc")
        named = ((f"{component['name']}.{param['name']}", param) for component in self._components for param in component["params"])
        rows = {name: {column: param.get(column) for column in columns} for name, param in named}
        return pd.DataFrame.from_dict(rows, orient="index").rename_axis("parameter")

    @cached_property
    def cycles(self) -> pd.DataFrame:
        """Number, instant (ticks) and digests of each cycle."""
        return self._table("tick")

    @cached_property
    def events(self) -> pd.DataFrame:
        """Events of the run, such as a goal, with details."""
        return self._table("events").drop(columns="at_ns", errors="ignore")

    @cached_property
    def log(self) -> pd.DataFrame:
        """Lines of text with their level."""
        table = self._table("log")
        return table.assign(level=table["level"].map(LEVELS)) if len(table) else table

    @cached_property
    def requests(self) -> pd.DataFrame:
        """Requests of operators."""
        return frame((time, {"request": request}) for time, request in self._values("requests"))

    @cached_property
    def states(self) -> pd.DataFrame:
        """State of each component whenever any changes: its name, "active" without states, missing while latent.

        The last row is the end of the last cycle, with the last states: a state lasts until the next row.
        """

        def states_of(record: dict[str, Any]) -> dict[str, str | None]:
            is_active = [bool(byte >> bit & 1) for byte in record["active"] for bit in range(8)]
            return {self._names[i]: self._state(i, state) if is_active[i] else None for i, state in enumerate(record["states"])}

        rows = [(time, states_of(record)) for time, record in self._values("tree")]
        if rows and len(self.cycles):
            rows.append((self.cycles.index[-1] + 1 / self.header["tree"]["cycle_hz"], rows[-1][1]))
        return frame(rows, dict.fromkeys(self._names, "string"))

    def _state(self, component: int, state: int) -> str:
        return "active" if state == WITHOUT_STATES else str(self._components[component]["states"][state]["name"])

    @cached_property
    def costs(self) -> pd.DataFrame:
        """Runs and time of each component since the last row, `Component.runs` and `Component.us` (µs)."""

        def row(costs: list[dict[str, int]]) -> dict[str, float]:
            named = zip(self._names, costs, strict=True)
            parts = ((name, {"runs": cost["runs"], "us": cost["ns"] * 1e-3}) for name, cost in named)
            return {f"{name}.{part}": value for name, values in parts for part, value in values.items()}

        rows = ((time, row(record["components"])) for time, record in self._values("costs"))
        kinds = {f"{name}.{part}": kind for name in self._names for part, kind in (("runs", "UInt32"), ("us", "float64"))}
        return frame(rows, kinds, lambda name: "µs" if name.endswith(".us") else None)

    @cached_property
    def sensors(self) -> pd.DataFrame:
        """Sensor values of each cycle, bit for bit; large data is its number of bytes. Empty without `--images all`."""
        return self._table("sensors", large_apart=True)

    @cached_property
    def command(self) -> pd.DataFrame:
        """Command of each cycle, bit for bit."""
        return self._table("command")

    @cached_property
    def outputs(self) -> pd.DataFrame:
        """Outputs, `Component.name` and parts of it, in every tenth cycle; missing while the component is latent."""
        outputs = _Outputs(self.header)
        records = self._values("information")
        return frame(((time, outputs.row(record)) for time, record in records), outputs.types, outputs.unit)

    def images(self, frame: str | None = None) -> Iterator[Image]:
        """Return images and other large data, one after the other; of one coordinate `frame` if given."""
        for time, record in self._values("blobs"):
            if frame is None or record["frame"] == frame:
                yield image_of(record, time)

    def topic(self, name: str) -> pd.DataFrame:
        """Return a topic of ROS 2, such as `/rosout`, as a table."""
        if name not in self.file.topics:
            raise RecordingError(f"there is no topic `{name}`\n  help: there are {', '.join(sorted(self.file.topics))}")
        return frame((time, dict(flattened("", value))) for time, value in self.file.standard(name))

    def replay(self, program: Program | str | os.PathLike[str], *arguments: str) -> dict[str, Any]:
        """Run the program's code again on the recording; see `player replay --json` in docs/json.md."""
        program = program if isinstance(program, Program) else Program(program)
        result: dict[str, Any] = program.call(["replay", os.fspath(self.file.path), *arguments])
        return result

    def _table(self, topic: str, large_apart: bool = False) -> pd.DataFrame:
        known = dict(types("", schema["ty"])) if (schema := self.file.schema(topic)) else {}
        if large_apart:
            # Large data is its number of bytes, so that a text may be a number.
            known = {name: "object" if kind == "string" else kind for name, kind in known.items()}
        return frame(((time, dict(flattened("", value))) for time, value in self._values(topic, large_apart)), known)

    def _values(self, topic: str, large_apart: bool = False) -> Iterator[tuple[float, Any]]:
        """Return times and values of a topic, which a file may not have."""
        if schema := self.file.schema(topic):
            decode = decoder(schema, large_apart)
            for time, content in self.file.contents(topic):
                yield time * 1e-9, decode(content)


class _Outputs:
    """Names, units and schemas of the outputs of a tree."""

    def __init__(self, header: dict[str, Any]) -> None:
        self._units: dict[str, str | None] = {}
        #: Columns by the schemas.
        self.types: dict[str, str] = {}
        self._known: list[list[tuple[str, Any]]] = []
        for component in header["tree"]["components"]:
            outputs = {f"{component['name']}.{output['name']}": output for output in component["info"]}
            self._units |= {name: output.get("unit") for name, output in outputs.items()}
            schemas = [(name, output.get("schema")) for name, output in outputs.items()]
            self.types |= {column: kind for name, of in schemas if of for column, kind in types(name, of["ty"])}
            self._known.append([(name, schema and decoder(schema)) for name, schema in schemas])

    def row(self, record: dict[str, Any]) -> dict[str, Any]:
        """Return the values of a record; a value that was too large to be recorded is missing."""
        row: dict[str, Any] = {}
        for value in record["values"]:
            name, decode = self._known[value["component"]][value["index"]]
            if decode is not None and value["value"]:
                row.update(flattened(name, decode(value["value"])))
        return row

    def unit(self, column: str) -> str | None:
        """Return the unit of a column."""
        return self._units.get(".".join(column.split(".")[:2]).split("[")[0])
