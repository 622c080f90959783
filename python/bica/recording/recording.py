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
from bica.recording.frames import flattened, frame
from bica.recording.image import Image, image_of
from bica.recording.postcard import decoder

__all__ = ["Recording", "RecordingError"]

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
        self._components: list[dict[str, Any]] = self.header["tree"]["components"]
        self._names = [component["name"] for component in self._components]

    def __repr__(self) -> str:
        return f"Recording({str(self.file.path)!r}: {self.header['tree']['name']}, {self.file.ending.get('cycles')} cycles)"

    @property
    def set_up(self) -> dict[str, Any]:
        """What the program needs to set up the same run again, by name."""
        return dict(self.header["set_up"])

    @property
    def world(self) -> str | None:
        """Name of the simulated world; None for a real robot."""
        return self.set_up.get("world")

    @property
    def seed(self) -> int | None:
        """Seed of the simulated world."""
        return self.set_up.get("seed")

    @property
    def result(self) -> str:
        """Result of the run as text; empty if the file was not closed."""
        return str(self.file.ending.get("result", ""))

    @property
    def settings(self) -> dict[str, Setting]:
        """Parameters that were not the defaults at the start: `bica.play(seed=…, world=…, set=…)` plays the game again."""
        table = self.parameters
        changed = table[(table["value"] != table["default"]) & table["value"].notna()]
        return {str(name): value for name, value in changed["value"].items()}

    @cached_property
    def parameters(self) -> pd.DataFrame:
        """Parameters at the start, a row for each `Component.name`, with default, unit, range and doc."""
        rows = {}
        for component in self._components:
            for param in component["params"]:
                rows[f"{component['name']}.{param['name']}"] = {
                    key: param.get(key) for key in ("value", "default", "unit", "kind", "min", "max", "step", "doc")
                }
        return pd.DataFrame.from_dict(rows, orient="index").rename_axis("parameter")

    @cached_property
    def cycles(self) -> pd.DataFrame:
        """Number, instant (ticks) and digests of each cycle."""
        return self._table("tick", "bica.Tick")

    @cached_property
    def events(self) -> pd.DataFrame:
        """Events of the run, such as a goal, with details."""
        return self._table("events", "bica.RunEvent").drop(columns="at_ns", errors="ignore")

    @cached_property
    def log(self) -> pd.DataFrame:
        """Lines of text with their level."""
        table = self._table("log", "bica.LogLine")
        return table.assign(level=table["level"].map(LEVELS)) if len(table) else table

    @cached_property
    def requests(self) -> pd.DataFrame:
        """Requests of operators."""
        decode, rows, times = decoder(self.file.schema("bica.RequestRecord")), [], []
        for _, _, message in self.file.messages("requests"):
            times.append(message.log_time * 1e-9)
            rows.append({"request": decode(message.data)})
        return frame(times, rows, lambda name: None)

    @cached_property
    def states(self) -> pd.DataFrame:
        """State of each component whenever any changes: its name, "active" without states, None while latent."""
        decode, rows, times = decoder(self.file.schema("bica.TreeRecord")), [], []
        for _, _, message in self.file.messages("tree"):
            record = decode(message.data)
            active = record["active"]
            states = enumerate(record["states"])
            is_active = [bool(active[index // 8] >> index % 8 & 1) for index in range(len(self._names))]
            rows.append({self._names[i]: self._state(i, state) if is_active[i] else None for i, state in states})
            times.append(message.log_time * 1e-9)
        return frame(times, rows, lambda name: None)

    def _state(self, component: int, state: int) -> str:
        return "active" if state == WITHOUT_STATES else str(self._components[component]["states"][state]["name"])

    @cached_property
    def costs(self) -> pd.DataFrame:
        """Runs and time of each component since the last row, `Component.runs` and `Component.us` (µs)."""
        decode, rows, times = decoder(self.file.schema("bica.Costs")), [], []
        for _, _, message in self.file.messages("costs"):
            row = {}
            for name, cost in zip(self._names, decode(message.data)["components"], strict=True):
                row[f"{name}.runs"], row[f"{name}.us"] = cost["runs"], cost["ns"] * 1e-3
            rows.append(row)
            times.append(message.log_time * 1e-9)
        return frame(times, rows, lambda name: "µs" if name.endswith(".us") else None)

    @cached_property
    def sensors(self) -> pd.DataFrame:
        """Sensor values of each cycle, bit for bit; large data is its number of bytes. Empty without `--images all`."""
        return self._table("sensors", "bica.Sensors", large_apart=True)

    @cached_property
    def command(self) -> pd.DataFrame:
        """Command of each cycle, bit for bit."""
        return self._table("command", "bica.Command")

    @cached_property
    def outputs(self) -> pd.DataFrame:
        """Outputs, `Component.name` and parts of it, in every tenth cycle; missing while the component is latent."""
        values, rows, times = _Outputs(self.header), [], []
        record_of = decoder(self.file.schema("bica.InformationRecord"))
        for _, _, message in self.file.messages("information"):
            rows.append(values.row(record_of(message.data)))
            times.append(message.log_time * 1e-9)
        return frame(times, rows, values.unit)

    def images(self, frame: str | None = None) -> Iterator[Image]:
        """Return images and other large data, one after the other; of one coordinate `frame` if given."""
        decode = decoder(self.file.schema("bica.BlobRecord"))
        for _, _, message in self.file.messages("blobs"):
            record = decode(message.data)
            if frame is None or record["frame"] == frame:
                yield image_of(record, message.log_time * 1e-9)

    def topic(self, name: str) -> pd.DataFrame:
        """Return a standard topic in JSON or Protocol Buffers, such as `/log`, as a table."""
        from bica.recording.standard import decoded

        rows: list[dict[str, Any]] = []
        times = []
        if name not in self.file.topics:
            raise RecordingError(f"there is no topic `{name}`\n  help: there are {', '.join(sorted(self.file.topics))}")
        for schema, channel, message in self.file.messages(name):
            row: dict[str, Any] = {}
            flattened("", decoded(schema, channel, message), row)
            rows.append(row)
            times.append(message.log_time * 1e-9)
        return frame(times, rows, lambda column: None)

    def replay(self, program: Program | str | os.PathLike[str], *arguments: str) -> dict[str, Any]:
        """Run the program's code again on the recording; see `player replay --json` in docs/json.md."""
        program = program if isinstance(program, Program) else Program(program)
        result: dict[str, Any] = program.call(["replay", os.fspath(self.file.path), *arguments])
        return result

    def _table(self, topic: str, schema: str, large_apart: bool = False) -> pd.DataFrame:
        rows: list[dict[str, Any]] = []
        times = []
        decode = decoder(self.file.schema(schema), large_apart) if topic in self.file.topics else None
        for _, _, message in self.file.messages(topic) if decode else ():
            row: dict[str, Any] = {}
            flattened("", decode(message.data) if decode else None, row)
            rows.append(row)
            times.append(message.log_time * 1e-9)
        return frame(times, rows, lambda name: None)


class _Outputs:
    """Names, units and schemas of the outputs of a tree."""

    def __init__(self, header: dict[str, Any]) -> None:
        components = header["tree"]["components"]
        outputs = [[(f"{one['name']}.{output['name']}", output) for output in one["info"]] for one in components]
        self._units = {name: output.get("unit") for component in outputs for name, output in component}
        self._known: list[list[tuple[str, Any]]] = [
            [(name, self._decoder(output.get("schema"), "monitor" in header)) for name, output in component]
            for component in outputs
        ]

    @staticmethod
    def _decoder(schema: dict[str, Any] | None, of_monitor: bool) -> Any:
        import json

        if of_monitor:
            # A monitor has received the values as text.
            text = decoder({"name": "String", "ty": "String"})
            return lambda data: json.loads(text(data))
        return schema and decoder(schema)

    def row(self, record: dict[str, Any]) -> dict[str, Any]:
        """Return the values of a record; a value that was too large to be recorded is missing."""
        row: dict[str, Any] = {}
        for value in record["values"]:
            name, decode = self._known[value["component"]][value["index"]]
            if decode is not None and value["value"]:
                flattened(name, decode(value["value"]), row)
        return row

    def unit(self, column: str) -> str | None:
        """Return the unit of a column."""
        name = ".".join(column.split(".")[:2]).split("[")[0]
        return self._units.get(name)
