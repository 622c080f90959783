//! The commands of a line.

use bica_motion::robot::Light;

use super::words::Line;
use super::{Clip, Problem};
use crate::session::{Button, Lamp, Movement, Signal, Step, Task, Tasks, Until};

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

/// First words of a line.
#[derive(Clone, Copy)]
enum Verb {
    Title,
    Language,
    Say,
    Music,
    Movement,
    Exercise,
    Volume,
    Light,
    Walk,
    Turn,
    Wait,
    Stop,
    Stiffness,
    Place,
    Go,
    Repeat,
    When,
    End,
}

const VERBS: [(&str, Verb); 18] = [
    ("title", Verb::Title),
    ("language", Verb::Language),
    ("say", Verb::Say),
    ("music", Verb::Music),
    ("movement", Verb::Movement),
    ("exercise", Verb::Exercise),
    ("volume", Verb::Volume),
    ("light", Verb::Light),
    ("walk", Verb::Walk),
    ("turn", Verb::Turn),
    ("wait", Verb::Wait),
    ("stop", Verb::Stop),
    ("stiffness", Verb::Stiffness),
    ("place", Verb::Place),
    ("go", Verb::Go),
    ("repeat", Verb::Repeat),
    ("when", Verb::When),
    ("end", Verb::End),
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
    ("movement", Tasks::of(Task::Movement)),
    ("speech", Tasks::of(Task::Speech)),
    ("music", Tasks::of(Task::Music)),
    ("walk", Tasks::of(Task::Walk)),
    ("all", Tasks::ALL),
];

const BUTTONS: [(&str, Signal); 3] = [
    ("chest", Signal::Press(Button::Chest)),
    ("left", Signal::Press(Button::Left)),
    ("right", Signal::Press(Button::Right)),
];

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
    let command = command(&mut line)?;
    line.end()?;
    Ok(Some(command))
}

fn command(line: &mut Line<'_>) -> Result<Command, Problem> {
    Ok(match line.choice("a command", &VERBS)? {
        Verb::Title => Command::Title(line.text("the title")?.0.to_owned()),
        Verb::Language => Command::Language(line.choice("a language", &LANGUAGES)?.to_owned()),
        Verb::Say => say(line)?,
        Verb::Music => line.text("the file").map(|(file, at)| Command::Play(Clip::File(file.into()), at))?,
        Verb::Movement => {
            let movement = line.choice("a movement", &Movement::NAMES)?;
            let tempo = if line.has("tempo") { line.number("a tempo in percent", 20.0..=100.0)? } else { 100.0 };
            Command::Step(Step::Move { movement, tempo: tempo / 100.0 })
        }
        Verb::Exercise => exercise(line)?,
        Verb::Volume => Command::Step(Step::Volume(line.number("a volume in percent", 0.0..=100.0)? / 100.0)),
        Verb::Light => {
            let lamp = line.choice("a light", &LAMPS)?;
            Command::Step(Step::Light(lamp, line.choice("a colour", &COLOURS)?))
        }
        Verb::Walk => {
            let [forward, left] = line.choice("a direction", &DIRECTIONS)?;
            let distance = line.number("a distance in metres", 0.02..=0.5)?;
            line.expect(&["m"])?;
            Command::Step(Step::Walk([forward * distance, left * distance, 0.0]))
        }
        Verb::Turn => {
            let sign = line.choice("a side", &[("left", 1.0_f32), ("right", -1.0)])?;
            let angle = line.number("an angle in degrees", 5.0..=90.0)?;
            Command::Step(Step::Walk([0.0, 0.0, sign * angle.to_radians()]))
        }
        Verb::Wait => wait(line)?,
        Verb::Stop => Command::Step(Step::Stop(line.choice("a task", &TASKS)?)),
        Verb::Stiffness => Command::Step(Step::Stiffness(line.choice("a stiffness", &[("on", true), ("off", false)])?)),
        Verb::Place => line.name("the name of the place").map(|(name, at)| Command::Place(name.to_owned(), at))?,
        Verb::Go => {
            line.expect(&["to"])?;
            line.name("the name of a place").map(|(name, at)| Command::GoTo(name.to_owned(), at))?
        }
        Verb::Repeat => {
            let times = line.count("a number of times", 2..=1000)?;
            line.expect(&["times"])?;
            Command::Repeat(times)
        }
        Verb::When => Command::When(line.choice("a result of the exercise", &BRANCHES)?),
        Verb::End => Command::End,
    })
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
    let mut hold = 0.0;
    if line.has("hold") {
        hold = line.number("a time in seconds", 0.5..=60.0)?;
        line.expect(&["s"])?;
    }
    let limit = at_most(line)?;
    Ok(Command::Step(Step::Exercise { movement, repetitions, hold, limit, then: [0; 3] }))
}

fn wait(line: &mut Line<'_>) -> Result<Command, Problem> {
    let until = if line.has("press") {
        Until::Signal(line.choice("a button", &BUTTONS)?)
    } else if line.has("touch") {
        Until::Signal(line.choice("a place to touch", &TOUCHES)?)
    } else if line.next_is_number() {
        let seconds = line.number("a time in seconds", 0.1..=LONGEST)?;
        line.expect(&["s"])?;
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
    let seconds = line.number("a time in seconds", 0.1..=LONGEST)?;
    line.expect(&["s"])?;
    Ok(seconds)
}
