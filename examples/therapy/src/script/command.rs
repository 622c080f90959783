//! The commands of a line.

use bica_motion::robot::Light;

use super::words::Line;
use super::{Clip, Problem};
use crate::session::{Lamp, Movement, Signal, Step, Tasks, Until};

/// A line of a script.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Command {
    Title(String),
    Language(String),
    /// A step as it is.
    Step(Step),
    /// A clip of sound, with the place of its file or text.
    Speak(Clip, (usize, usize)),
    Play(Clip, (usize, usize)),
    Place(String, (usize, usize)),
    GoTo(String, (usize, usize)),
    Repeat(u16),
    /// A branch of the exercise before it: 0 done, 1 not done, 2 nobody there.
    When(usize),
    End,
}

/// Reads what follows the first word of a line.
pub(super) type Read = fn(&mut Line<'_>) -> Result<Command, Problem>;

/// First words of a line.
pub(super) const VERBS: [(&str, Read); 18] = [
    ("title", |line| Ok(Command::Title(line.text("the title")?.0.to_owned()))),
    ("language", |line| Ok(Command::Language(line.choice("a language", &LANGUAGES)?.to_owned()))),
    ("say", say),
    ("music", |line| line.text("the file").map(|(file, at)| Command::Play(Clip::File(file.into()), at))),
    ("movement", |line| {
        let movement = line.choice("a movement", &Movement::NAMES)?;
        let tempo = if line.has("tempo") { line.number("a tempo in percent", 20.0..=100.0)? } else { 100.0 };
        Ok(Command::Step(Step::Move { movement, tempo: tempo / 100.0 }))
    }),
    ("exercise", exercise),
    ("volume", |line| Ok(Command::Step(Step::Volume(line.number("a volume in percent", 0.0..=100.0)? / 100.0)))),
    ("light", |line| {
        let lamp = line.choice("a light", &LAMPS)?;
        Ok(Command::Step(Step::Light(lamp, line.choice("a colour", &COLOURS)?)))
    }),
    ("walk", |line| {
        let [forward, left] = line.choice("a direction", &DIRECTIONS)?;
        let distance = line.measure("a distance in metres", 0.02..=0.5, "m")?;
        Ok(Command::Step(Step::Walk([forward * distance, left * distance, 0.0])))
    }),
    ("turn", |line| {
        let sign = line.choice("a side", &[("left", 1.0_f32), ("right", -1.0)])?;
        let angle = line.number("an angle in degrees", 5.0..=90.0)?;
        Ok(Command::Step(Step::Walk([0.0, 0.0, sign * angle.to_radians()])))
    }),
    ("wait", wait),
    ("stop", |line| Ok(Command::Step(Step::Stop(line.choice("a task", &TASKS)?)))),
    ("stiffness", |line| {
        Ok(Command::Step(Step::Stiffness(line.choice("a stiffness", &[("on", true), ("off", false)])?)))
    }),
    ("place", |line| line.name("the name of the place").map(|(name, at)| Command::Place(name.to_owned(), at))),
    ("go", |line| {
        line.expect(&["to"])?;
        line.name("the name of a place").map(|(name, at)| Command::GoTo(name.to_owned(), at))
    }),
    ("repeat", |line| {
        let times = line.count("a number of times", 2..=1000)?;
        line.expect(&["times"])?;
        Ok(Command::Repeat(times))
    }),
    ("when", |line| Ok(Command::When(line.choice("a result of the exercise", &BRANCHES)?))),
    ("end", |_| Ok(Command::End)),
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

const TASKS: [(&str, Tasks); 5] = [
    ("movement", Tasks { movement: true, ..Tasks::NONE }),
    ("speech", Tasks { speech: true, ..Tasks::NONE }),
    ("music", Tasks { music: true, ..Tasks::NONE }),
    ("walk", Tasks { walk: true, ..Tasks::NONE }),
    ("all", Tasks::ALL),
];

const BUTTONS: [(&str, Signal); 3] = [("chest", Signal::Chest), ("left", Signal::Left), ("right", Signal::Right)];

const TOUCHES: [(&str, Signal); 3] =
    [("head", Signal::Head), ("left_hand", Signal::LeftHand), ("right_hand", Signal::RightHand)];

const BRANCHES: [(&str, usize); 3] = [("done", 0), ("not_done", 1), ("nobody", 2)];

/// Most time of a wait or of an exercise, s.
const LONGEST: f32 = 3600.0;

/// Parses a line; `None` if it is empty.
pub(super) fn parse(number: usize, line: &str) -> Result<Option<Command>, Problem> {
    let mut line = Line::new(number, line)?;
    if line.is_done() {
        return Ok(None);
    }
    let command = line.choice("a command", &VERBS)?(&mut line)?;
    line.end()?;
    Ok(Some(command))
}

fn say(line: &mut Line<'_>) -> Result<Command, Problem> {
    if line.has("file") {
        let (file, at) = line.text("the file")?;
        return Ok(Command::Speak(Clip::File(file.into()), at));
    }
    let (text, at) = line.text("the text")?;
    let language = line.has("in").then(|| line.choice("a language", &LANGUAGES)).transpose()?;
    Ok(Command::Speak(Clip::Text { text: text.to_owned(), language: language.unwrap_or_default().to_owned() }, at))
}

fn exercise(line: &mut Line<'_>) -> Result<Command, Problem> {
    let movement = line.choice("a movement", &Movement::NAMES)?;
    line.expect(&["reps"])?;
    let repetitions = line.count("a number of repetitions", 1..=100)?;
    let hold = if line.has("hold") { line.measure("a time in seconds", 0.5..=60.0, "s")? } else { 0.0 };
    let limit = at_most(line)?;
    Ok(Command::Step(Step::Exercise { movement, repetitions, hold, limit, then: [0; 3] }))
}

fn wait(line: &mut Line<'_>) -> Result<Command, Problem> {
    let until = if line.has("press") {
        Until::Signal(line.choice("a button", &BUTTONS)?)
    } else if line.has("touch") {
        Until::Signal(line.choice("a place to touch", &TOUCHES)?)
    } else if line.next_is_number() {
        let seconds = line.measure("a time in seconds", 0.1..=LONGEST, "s")?;
        return Ok(Command::Step(Step::Wait(Until::Time, seconds)));
    } else {
        let allowed = ["a time in seconds", "press", "touch", "movement", "speech", "music", "walk", "all"];
        Until::Ends(line.choice("what is waited for", &TASKS).map_err(|problem| problem.with_allowed(&allowed))?)
    };
    Ok(Command::Step(Step::Wait(until, at_most(line)?)))
}

/// Reads the time limit, which each wait must have.
fn at_most(line: &mut Line<'_>) -> Result<f32, Problem> {
    line.expect(&["at", "most"])?;
    line.measure("a time in seconds", 0.1..=LONGEST, "s")
}
