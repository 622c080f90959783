"""Recordings of the forward and of another robot."""

import os
import zlib
from pathlib import Path

import numpy as np
import pytest

import bica
from bica import Program
from bica.recording import Recording, RecordingError
from bica.recording.frames import flattened, frame, types
from bica.recording.postcard import DecodeError, decoder

DOCS = Path(__file__).parents[2] / "docs"


@pytest.fixture(scope="module")
def played(player: Program, tmp_path_factory: pytest.TempPathFactory) -> tuple[Recording, dict[str, object]]:
    path = tmp_path_factory.mktemp("recording") / "run.mcap"
    words = ["--size", "160x120", "--seconds", "6", "--record", str(path)]
    result = bica.play(3, set={"FaceBall.gain": 0.6}, program=player, arguments=words)
    return Recording(path), result


def test_the_game_can_be_played_again(player: Program, played: tuple[Recording, dict[str, object]]) -> None:
    recording, result = played
    assert (recording.seed, recording.world, recording.settings) == (3, "built-in", {"FaceBall.gain": 0.6})
    again = bica.play(3, recording.world, recording.settings, program=player, arguments=["--size", "160x120", "--seconds", "6"])
    assert again["fingerprint"] == result["fingerprint"]
    assert recording.replay(player)["equal"] is True


def test_images_and_sensor_values_are_exact(played: tuple[Recording, dict[str, object]]) -> None:
    recording, _ = played
    digests = dict(zip(recording.cycles["cycle"], recording.cycles["blobs"], strict=True))
    images = list(recording.images())
    assert len(images) == 180 and len(list(recording.images("nowhere"))) == 0
    assert all(zlib.crc32(image.data.tobytes()) == digests[image.cycle] for image in images)
    assert images[0].data.shape == (120, 160, 2) and images[0].rgb.shape == (120, 160, 3)
    assert recording.sensors["angles.HeadYaw"].notna().all() and len(recording.sensors) == len(recording.command) == 600


def test_tables_have_times_units_and_names(played: tuple[Recording, dict[str, object]]) -> None:
    recording, _ = played
    assert recording.outputs.index.name == "time_s" and recording.outputs.attrs["units"]["SearchBall.walked"] == "m"
    assert recording.states["Player"].iloc[0] == "look_for_ball" and recording.states["Walk"].iloc[0] == "active"
    assert recording.states["Kicker"].isna().all()
    assert recording.costs["Walk.runs"].sum() > 400 and recording.costs.attrs["units"]["Walk.us"] == "µs"
    gain = recording.parameters.loc["FaceBall.gain"]
    assert (gain["value"], gain["default"], gain["max"]) == (0.6, 0.7, 1.0)


def test_a_recording_without_images_has_events(player: Program, tmp_path: Path) -> None:
    words = ["--size", "160x120", "--images", "none", "--record", str(tmp_path / "run.mcap")]
    bica.play(7, program=player, arguments=words)
    recording = Recording(tmp_path / "run.mcap")
    assert list(recording.events["kind"])[-1] == "goal" and recording.seed == 7
    assert recording.sensors.empty and not list(recording.images())
    assert recording.log.empty or set(recording.log["level"]) <= {"debug", "information", "warning", "error"}


def test_topics_of_ros_are_read(player: Program, played: tuple[Recording, dict[str, object]], tmp_path: Path) -> None:
    pytest.importorskip("mcap_ros2")
    recording, _ = played
    standard = [topic for topic in recording.file.topics if not topic.startswith("/bica/")]
    for topic in standard:
        assert len(recording.topic(topic).columns) > 0
    with pytest.raises(RecordingError, match="there is no topic `/nothing`"):
        recording.topic("/nothing")


def test_wrong_files_are_errors_with_a_remedy(played: tuple[Recording, dict[str, object]], tmp_path: Path) -> None:
    recording, _ = played
    whole = recording.file.path.read_bytes()
    for name, content in {"cut": whole[: len(whole) // 2], "text": b"no recording", "empty": b""}.items():
        path = tmp_path / f"{name}.mcap"
        path.write_bytes(content)
        with pytest.raises(RecordingError, match=r"no MCAP file: [^\n]+\n.*record recover"):
            Recording(path)
    flipped = bytearray(whole)
    flipped[len(whole) // 2] ^= 255
    (tmp_path / "flipped.mcap").write_bytes(flipped)
    with pytest.raises((RecordingError, DecodeError)):
        list(Recording(tmp_path / "flipped.mcap").images())


def test_another_robot_is_recorded_too(tmp_path: Path) -> None:
    path = os.environ.get("BICA_WALL_FOLLOWER")
    if path is None:
        pytest.skip("BICA_WALL_FOLLOWER names no program; `cargo build --example wall_follower -p bica-app` builds it")
    program = Program(path)
    assert bica.params(program=program)
    words = ["--seconds", "5"]
    table = bica.series([1, 2], program=program, arguments=words)
    assert list(table["simulated_s"]) == [5.0, 5.0] and table["fingerprint"].nunique() == 2
    result = bica.play(1, program=program, arguments=[*words, "--record", str(tmp_path / "run.mcap")])
    recording = Recording(tmp_path / "run.mcap")
    assert len(recording.cycles) == len(recording.sensors) == len(recording.command) == result["cycles"]
    assert recording.states.index[-1] == pytest.approx(5.0)
    assert set(recording.states.dtypes.astype(str)) == {"string"}


def test_types_are_those_of_the_schema() -> None:
    def field(name: str, ty: object) -> dict[str, object]:
        return {"name": name, "ty": {"name": "", "ty": ty}}

    pose = {
        "Option": {
            "name": "",
            "ty": {"Struct": [field("ns", "U64"), field("ok", "Bool"), field("pair", {"Tuple": [{"ty": "F32"}]})]},
        }
    }
    kinds = {"Enum": [{"name": "A", "ty": "UnitVariant"}, {"name": "B", "ty": {"NewtypeVariant": {"ty": "I64"}}}]}
    known = dict(types("", {"Struct": [field("pose", pose), field("kind", kinds)]}))
    assert list(known) == ["pose.ns", "pose.ok", "pose.pair[0]", "kind", "kind.B"]
    values: list[dict[str, object]] = [
        {"pose": None, "kind": "A"},
        {"pose": {"ns": 2**64 - 1, "ok": True, "pair": (0.5,)}, "kind": {"B": -(2**63)}},
    ]
    for rows in ([], values[:1], values):
        table = frame(((0.0, dict(flattened("", row))) for row in rows), known)
        assert list(table.dtypes.astype(str)) == ["UInt64", "boolean", "float64", "string", "Int64"]
    assert (table["pose.ns"].iloc[1], table["kind.B"].iloc[1], (~table["pose.ok"]).sum()) == (2**64 - 1, -(2**63), 0)
    unknown = frame([(0.0, {"on": None, "count": 1}), (0.1, {"on": False, "count": 2**63})])
    assert list(unknown.dtypes.astype(str)) == ["boolean", "UInt64"]


def test_the_encoding_of_each_type() -> None:
    def field(name: str, ty: object) -> dict[str, object]:
        return {"name": name, "ty": {"name": "", "ty": ty}}

    unit = {"name": "A", "ty": "UnitVariant"}
    schema = {
        "name": "T",
        "ty": {
            "Struct": [
                field("small", "I8"),
                field("wide", "U32"),
                field("signed", "I64"),
                field("maybe", {"Option": {"name": "", "ty": "F64"}}),
                field("texts", {"Seq": {"name": "", "ty": "String"}}),
                field("kind", {"Enum": [unit, {"name": "B", "ty": {"NewtypeVariant": {"ty": "Bool"}}}]}),
            ]
        },
    }
    message = bytes([0xFE, 0xAC, 0x02, 0x03, 0x01, *np.float64(1.5).tobytes(), 2, 1, 97, 0, 1, 1])
    expected = {"small": -2, "wide": 300, "signed": -2, "maybe": 1.5, "texts": ["a", ""], "kind": {"B": True}}
    assert decoder(schema)(message) == expected
    for wrong in (message[:-1], message + b"\0", b""):
        with pytest.raises(DecodeError):
            decoder(schema)(wrong)


def test_the_notebook_of_the_docs_runs(player: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    monkeypatch.setenv("BICA_PROGRAM", str(player.path))
    notebook = nbformat.read(DOCS / "game.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    assert "95 % interval" in notebook.cells[-2].outputs[0]["text"]
