"""Study files."""

from pathlib import Path

import pytest
from conftest import StudyFile

from bica.program import Program
from bica.search.study import StudyError, read_study


def test_ranges_are_those_of_the_descriptions(study_file: StudyFile) -> None:
    study = read_study(study_file())
    speed, gain = study.parameters["Walk.speed"], study.parameters["Walk.gain"]
    assert (speed.minimum, speed.maximum, gain.minimum, gain.maximum) == (0.0, 1.0, 0.1, 4.5)
    assert study.defaults == {"Walk.speed": 0.8, "Walk.gain": 4.0}


def test_a_program_beside_the_study_is_found(study_file: StudyFile, robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(robot.path.parent)
    path = study_file((str(robot.path), "./robot"), path=robot.path.parent)
    assert read_study(Path(path.name)).program.path == robot.path


def test_options_of_the_world_reach_each_game(study_file: StudyFile) -> None:
    options = 'options = ["image=freeze", "from=8"]\narguments = ["--slow", "0"]'
    study = read_study(study_file(("arguments = []", options)))
    words = ("--option", "image=freeze", "--option", "from=8", "--slow", "0")
    assert {task.arguments for task in study.tasks(study.defaults, study.search_seeds)} == {words}


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("first = 900", "first = 103", "share seed 103"),
        ("Walk.gain", "Walk.gian", "no parameter `Walk.gian`"),
        ("max = 4.5", "max = 9.0", "within 0.1 to 5"),
        ("max = 4.5", "max = nan", "`parameters.Walk.gain.max` is wrong: Input should be a finite number"),
        ("max = 4.5", "most = 4.5", "`parameters.Walk.gain.most` is wrong: Extra.*\n  help: docs/search.md"),
        ('"tpe"', '"best"', "`sampler.kind` is wrong: Input should be 'tpe', 'cma-es'"),
        ("block = 2", 'block = "2"', "`seeds.block` is wrong: Input should be a valid integer"),
        ("mean(cost)", "cost.real", "not allowed"),
        ("first = 900, ", "", "`seeds.final.first` is wrong: Field required"),
        ('kind = "tpe"', 'kind = "cma-es"\n[parameters."Walk.careful"]\n[x]', "cma-es needs numbers"),
    ],
)
def test_a_wrong_entry_is_named(study_file: StudyFile, old: str, new: str, message: str) -> None:
    if "careful" in new:
        old, new = '"Walk.gain" = { max = 4.5 }', '"Walk.careful" = {}\n[sampler]\nkind = "cma-es"'
        path = study_file((old, new), ('[sampler]\nkind = "tpe"\ncandidates = 6\n', ""))
    else:
        path = study_file((old, new))
    with pytest.raises(StudyError, match=message):
        read_study(path)


def test_texts_of_other_editors_are_read_or_named(study_file: StudyFile) -> None:
    path = study_file()
    text = path.read_text()
    path.write_bytes(text.encode("utf-8-sig"))
    assert read_study(path).parameters
    for odd in [text.encode("utf-16"), f"# größe\n{text}".encode("latin-1"), text.replace('"', "“").encode()]:
        path.write_bytes(odd)
        with pytest.raises(StudyError, match=r"(?s)cannot read.*UTF-8, with straight quotes"):
            read_study(path)
