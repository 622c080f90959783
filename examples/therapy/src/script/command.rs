//! Commands of the session language.

use bica_motion::robot::Light;

use super::build::Builder;
use super::words::Line;
use super::{Clip, Problem};
use crate::session::{Lamp, Movement, Signal, Step, Task, Until};

/// Function that reads the rest of a line after its first word and adds it to the script.
pub(super) type Read = fn(&mut Builder, &mut Line<'_>) -> Result<(), Problem>;

/// Commands by the first word of a line.
pub(super) const VERBS: [(&str, Read); 18] = [
    ("title", |script, line| line.text("the title").map(|(title, _)| title.clone_into(&mut script.script.title))),
    ("language", |script, line| {
        line.choice("a language", &LANGUAGES).map(|code| code.clone_into(&mut script.language))
    }),
    ("say", say),
    ("music", |script, line| {
        let (file, at) = line.text("the file")?;
        script.sound(Step::Play, Clip::File(file.into()), at)
    }),
    ("movement", |script, line| {
        let movement = line.choice("a movement", &Movement::NAMES)?;
        let tempo = if line.has("tempo") { line.number("a tempo in percent", 20.0..=100.0)? } else { 100.0 };
        script.push(Step::Move(movement, tempo / 100.0))
    }),
    ("exercise", exercise),
    ("volume", |script, line| script.push(Step::Volume(line.number("a volume in percent", 0.0..=100.0)? / 100.0))),
    ("light", |script, line| {
        let lamp = line.choice("a light", &LAMPS)?;
        script.push(Step::Light(lamp, line.choice("a colour", &COLOURS)?))
    }),
    ("walk", |script, line| {
        let [forward, left] = line.choice("a direction", &DIRECTIONS)?;
        let distance = line.measure("a distance in metres", 0.02..=0.5, "m")?;
        script.push(Step::Walk([forward * distance, left * distance, 0.0]))
    }),
    ("turn", |script, line| {
        let sign = line.choice("a side", &[("left", 1.0_f32), ("right", -1.0)])?;
        let angle = line.number("an angle in degrees", 5.0..=90.0)?;
        script.push(Step::Walk([0.0, 0.0, sign * angle.to_radians()]))
    }),
    ("wait", wait),
    ("stop", |script, line| script.push(Step::Stop(line.choice("a task", &TASKS)?))),
    ("stiffness", |script, line| {
        script.push(Step::Stiffness(line.choice("a stiffness", &[("on", true), ("off", false)])?))
    }),
    ("place", |script, line| {
        let (name, at) = line.name("the name of the place")?;
        script.place(name, at)
    }),
    ("go", |script, line| {
        line.expect(&["to"])?;
        let (name, at) = line.name("the name of a place")?;
        script.go_to(name, at)
    }),
    ("repeat", |script, line| {
        let times = line.count("a number of times", 2..=1000);
        // It begins in any case, so that its `end` is no further mistake.
        script.repeat(times.as_ref().map_or(2, |times| *times))?;
        times?;
        line.expect(&["times"])
    }),
    ("when", |script, line| {
        let branch = line.choice("a result of the exercise", &BRANCHES);
        script.when(branch.as_ref().ok().copied())?;
        branch.map(drop)
    }),
    ("end", |script, _| script.end()),
];

/// Languages that `espeak-ng` speaks, by their codes in ISO 639-1.
const LANGUAGES: [(&str, &str); 8] =
    [("de", "de"), ("en", "en"), ("es", "es"), ("fr", "fr"), ("it", "it"), ("nl", "nl"), ("pl", "pl"), ("pt", "pt")];

const LAMPS: [(&str, Lamp); 3] = [("eyes", Lamp::Eyes), ("ears", Lamp::Ears), ("chest", Lamp::Chest)];

const COLOURS: [(&str, Light); 8] = [
    ("off", Light(0.0, 0.0, 0.0)),
    ("white", Light(1.0, 1.0, 1.0)),
    ("red", Light(1.0, 0.0, 0.0)),
    ("green", Light(0.0, 1.0, 0.0)),
    ("blue", Light(0.0, 0.0, 1.0)),
    ("yellow", Light(1.0, 1.0, 0.0)),
    ("orange", Light(1.0, 0.5, 0.0)),
    ("purple", Light(0.5, 0.0, 1.0)),
];

/// Directions of a walk: forward and left.
const DIRECTIONS: [(&str, [f32; 2]); 4] =
    [("forward", [1.0, 0.0]), ("backward", [-1.0, 0.0]), ("left", [0.0, 1.0]), ("right", [0.0, -1.0])];

const TASKS: [(&str, Task); 5] = [
    ("movement", Task::Movement),
    ("speech", Task::Speech),
    ("music", Task::Music),
    ("walk", Task::Walk),
    ("all", Task::All),
];

const BUTTONS: [(&str, Signal); 3] = [("chest", Signal::Chest), ("left", Signal::Left), ("right", Signal::Right)];

const TOUCHES: [(&str, Signal); 3] =
    [("head", Signal::Head), ("left_hand", Signal::LeftHand), ("right_hand", Signal::RightHand)];

const BRANCHES: [(&str, usize); 3] = [("done", 0), ("not_done", 1), ("nobody", 2)];

/// Longest wait or exercise, s.
const LONGEST: f32 = 3600.0;

/// Translates a line, which may be empty.
pub(super) fn read(script: &mut Builder, number: usize, line: &str) -> Result<(), Problem> {
    let mut line = Line::new(number, line)?;
    if line.is_done() {
        return Ok(());
    }
    line.choice("a command", &VERBS)?(script, &mut line)?;
    line.end()
}

fn say(script: &mut Builder, line: &mut Line<'_>) -> Result<(), Problem> {
    if line.has("file") {
        let (file, at) = line.text("the file")?;
        return script.sound(Step::Speak, Clip::File(file.into()), at);
    }
    let (text, at) = line.text("the text")?;
    let own = line.has("in").then(|| line.choice("a language", &LANGUAGES)).transpose()?;
    let language = own.unwrap_or(&script.language).to_owned();
    script.sound(Step::Speak, Clip::Text { text: text.to_owned(), language }, at)
}

fn exercise(script: &mut Builder, line: &mut Line<'_>) -> Result<(), Problem> {
    let movement = line.choice("a movement that can be judged", Movement::JUDGED)?;
    line.expect(&["reps"])?;
    let repetitions = line.count("a number of repetitions", 1..=100)?;
    let hold = if line.has("hold") { line.measure("a time in seconds", 0.5..=60.0, "s")? } else { 0.0 };
    let limit = at_most(line)?;
    script.push(Step::Exercise { movement, repetitions, hold, limit, then: [0; 3] })
}

fn wait(script: &mut Builder, line: &mut Line<'_>) -> Result<(), Problem> {
    let until = if line.has("press") {
        Until::Signal(line.choice("a button", &BUTTONS)?)
    } else if line.has("touch") {
        Until::Signal(line.choice("a place to touch", &TOUCHES)?)
    } else if line.next_is_number() {
        return script.push(Step::Wait(Until::Time, line.measure("a time in seconds", 0.1..=LONGEST, "s")?));
    } else {
        let allowed = ["a time in seconds", "press", "touch", "movement", "speech", "music", "walk", "all"];
        Until::Ends(line.choice("", &TASKS).map_err(|_| line.wrong("what is waited for", &allowed))?)
    };
    script.push(Step::Wait(until, at_most(line)?))
}

/// Reads the time limit, which each wait must have.
fn at_most(line: &mut Line<'_>) -> Result<f32, Problem> {
    line.expect(&["at", "most"]).map_err(|_| line.wrong("a time limit", &["at most 20 s"]))?;
    line.measure("a time in seconds", 0.1..=LONGEST, "s")
}
