//! Layers of values, tune files, and their errors.

use std::fs;

use bica::prelude::*;
use bica_test_data::process::Folder;
use bica_tuning::{Layers, render, write};
use bica_wire::model::Invalid;

/// The foot that kicks.
#[derive(Clone, Copy, ParamEnum)]
enum Foot {
    Left,
    Right,
}

/// How to kick.
#[derive(Params)]
#[params(check = Self::is_ordered)]
struct Kicking {
    /// Least distance of the ball.
    #[param(default = 0.1, range = 0.0..=1.0, unit = "m")]
    near: f32,
    /// Largest distance of the ball.
    #[param(default = 0.2, range = 0.0..=1.0, unit = "m", step = 0.01)]
    far: f32,
    /// Runs before the kick.
    #[param(default = 3, range = 0..=9)]
    runs: u32,
    /// Shift to the left.
    #[param(default = 0, range = -9..=9, unit = "mm")]
    shift: i32,
    /// Whether the robot kicks at all.
    #[param(default = true)]
    enabled: bool,
    /// The foot.
    #[param(default = Foot::Left)]
    foot: Foot,
}

impl Kicking {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.near < self.far { Ok(()) } else { Err("`near` must be less than `far`") }
    }
}

struct Kicker;

#[component]
impl Kicker {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, tuned: &Tuned<Kicking>) {
        let _ = (tuned.near, tuned.far, tuned.runs, tuned.shift, tuned.enabled, tuned.foot);
    }
}

activation_tree! { struct Robot { root: Kicker, cycle_hz: 100, tunable, components: [Kicker] } }

/// What is grasped.
#[derive(Params)]
struct Greifen {
    /// Height of the hand.
    #[param(default = 0.1, range = 0.0..=1.0, unit = "m")]
    höhe: f32,
}

struct Größe<const N: usize>;

#[component]
impl<const N: usize> Größe<N> {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, tuned: &Tuned<Greifen>) {
        let _ = tuned.höhe;
    }
}

activation_tree! { struct Hand { root: Größe<3>, cycle_hz: 100, tunable, components: [Größe<3>] } }

#[test]
fn names_with_any_letters_are_read_again() {
    let mut layers = Layers::new(&Hand::GRAPH);
    layers.assign("Größe<3>.höhe=0.0004", "a test").expect("it is assigned");
    let text = render(&layers);
    let mut again = Layers::new(&Hand::GRAPH);
    again.read_text("hand.toml", &text).expect("it is a tune file");
    assert_eq!(render(&again), text);
    assert!(text.contains("[\"Größe<3>\"]\n") && text.contains("\"höhe\" = 0.0004 "), "{text}");
}

static GRAPH: bica::Graph = Robot::GRAPH;

fn layers(text: &str) -> Layers {
    let mut layers = Layers::new(&GRAPH);
    layers.read_text("tune/nao.toml", text).unwrap_or_else(|invalid| panic!("{invalid:?}"));
    layers
}

fn value(layers: &Layers, name: &str) -> (String, Option<String>) {
    let found = layers.all().find(|value| value.param.name == name).expect("a parameter");
    (found.text(), found.source.map(str::to_owned))
}

#[track_caller]
fn assert_fails(result: Result<(), Invalid>, what: &str, help: &str) {
    let Err(Invalid { what: found, help: found_help, .. }) = result else { panic!("no error, wanted `{what}`") };
    assert_eq!((found.as_str(), found_help.as_str()), (what, help));
}

#[test]
fn later_layer_wins_and_each_value_has_its_source() {
    let mut layers = layers("[Kicker]\nfar = 0.5\nruns = 4\n");
    layers.read_text("tune/one.toml", "\n\n[Kicker]\n\nruns = 5\nfoot = \"Right\"\n").expect("valid");
    layers.assign("Kicker.shift = -7", "--set").expect("valid");
    assert_eq!(value(&layers, "near"), ("0.1".to_owned(), None));
    assert_eq!(value(&layers, "far"), ("0.5".to_owned(), Some("tune/nao.toml line 2".to_owned())));
    assert_eq!(value(&layers, "runs"), ("5".to_owned(), Some("tune/one.toml line 5".to_owned())));
    assert_eq!(value(&layers, "foot"), ("Right".to_owned(), Some("tune/one.toml line 6".to_owned())));
    assert_eq!(value(&layers, "shift"), ("-7".to_owned(), Some("--set".to_owned())));
    let mut robot = Robot::new();
    layers.apply(&mut robot).expect("accepted");
    let tuned = robot.params::<Kicker>();
    assert_eq!((tuned.near, tuned.far, tuned.runs, tuned.shift), (0.1, 0.5, 5, -7));
    assert!(matches!(tuned.foot, Foot::Right));
}

#[test]
fn whole_number_is_a_valid_f32() {
    assert_eq!(value(&layers("[Kicker]\nfar = 1\n"), "far").0, "1.0");
    let read = |text: &str| Layers::new(&GRAPH).read_text("t", text);
    let runs = "write a whole number from 0 to 9";
    assert_fails(read("[Kicker]\nruns = 1.0"), "`t` line 2: `1.0` is not a value of `runs`: expected u32", runs);
    assert_fails(read("[Kicker]\nruns = \"1\""), "`t` line 2: `\"1\"` is not a value of `runs`: expected u32", runs);
    assert_fails(read("[Kicker]\nruns = true"), "`t` line 2: `true` is not a value of `runs`: expected u32", runs);
    let far = "write a number from 0.0 to 1.0 m";
    assert_fails(read("[Kicker]\nfar = \"0.5\""), "`t` line 2: `\"0.5\"` is not a value of `far`: expected f32", far);
    assert_fails(read("[Kicker]\nfar = [0.5]"), "`t` line 2: `[0.5]` is not a value of `far`: expected f32", far);
    assert_fails(
        read("[Kicker]\nenabled = 1"),
        "`t` line 2: `1` is not a value of `enabled`: expected bool",
        "write true or false",
    );
    let foot = |text: &str| format!("`t` line 2: `{text}` is not a value of `foot`: there is no such variant");
    assert_fails(read("[Kicker]\nfoot = \"left\""), &foot("left"), "write one of Left, Right");
    assert_fails(read("[Kicker]\nfoot = 0"), &foot("0"), "write one of Left, Right");
}

#[test]
fn wrong_names_and_values_are_located() {
    let read = |text: &str| Layers::new(&GRAPH).read_text("tune/nao.toml", text);
    assert_fails(
        read("# a comment\n[Kiker]\nfar = 1.0"),
        "`tune/nao.toml` line 2: there is no component `Kiker`",
        "did you mean `Kicker`?",
    );
    assert_fails(
        read("[Kicker]\nrun = 1"),
        "`tune/nao.toml` line 2: `Kicker` has no parameter `run`",
        "did you mean `runs`?",
    );
    assert_fails(
        read("[Kicker]\nxyz = 1"),
        "`tune/nao.toml` line 2: `Kicker` has no parameter `xyz`",
        "it has `near`, `far`, `runs`, `shift`, `enabled`, `foot`",
    );
    assert_fails(
        read("[Kicker]\nnear = 0.1\nfar = 1.5"),
        "`tune/nao.toml` line 3: `1.5` is not a value of `far`: 1.5 is outside 0..=1",
        "write a number from 0.0 to 1.0 m",
    );
    assert_fails(
        read("[Kicker]\nfar = nan"),
        "`tune/nao.toml` line 2: `nan` is not a value of `far`: the value is not finite",
        "write a number from 0.0 to 1.0 m",
    );
    assert_fails(
        read("Kicker = 3"),
        "`tune/nao.toml` line 1: `Kicker` is a component, not a value",
        "write a section `[Kicker]` with `name = value` lines",
    );
    let Err(Invalid { what, .. }) = read("[Kicker]\nfar = 0.1\nfar = 0.2") else { panic!("set twice") };
    assert!(what.starts_with("`tune/nao.toml` line 3: "), "{what}");
}

#[test]
fn a_wrong_assignment_is_an_error() {
    let mut twice = layers("[Kicker]\nfar = 0.5\n");
    twice.assign("Kicker.far=0.30", "--set").expect("the first one");
    assert_fails(
        twice.assign("Kicker.far=0.4", "--set"),
        "--set sets one parameter twice: `Kicker.far=0.3` and `Kicker.far=0.4`",
        "leave one of them out",
    );
    let set = |text: &str| Layers::new(&GRAPH).assign(text, "--set");
    let help = "write it as `Component.name=value`, as `Drive.speed=0.9`";
    assert_fails(set("Kicker.far"), "`Kicker.far` is not an assignment", help);
    assert_fails(set("far=0.1"), "`far=0.1` is not an assignment", help);
    assert_fails(set("Kicker.fra=0.1"), "`Kicker` has no parameter `fra`", "did you mean `far`?");
    assert_fails(
        set("Kicker.far=2"),
        "`Kicker.far`: `2` is not a value of `far`: 2 is outside 0..=1",
        "write a number from 0.0 to 1.0 m",
    );
}

#[test]
fn values_that_break_a_rule_are_refused() {
    let mut layers = layers("[Kicker]\nnear = 0.15\n");
    layers.apply(&mut Robot::new()).expect("still ordered");
    layers.assign("Kicker.far=0.12", "--set").expect("in range");
    let mut robot = Robot::new();
    assert_fails(
        layers.apply(&mut robot),
        "`Kicker`: `near` must be less than `far`",
        "values that are not defaults: near=0.15 (tune/nao.toml line 2), far=0.12 (--set)",
    );
    assert_eq!((robot.params::<Kicker>().near, robot.params::<Kicker>().far), (0.1, 0.2), "nothing has changed");
}

const FILE: &str = "\
# Parameters that differ from the defaults of the source.

[Kicker]
# Largest distance of the ball.
far = 0.3 # default 0.2, 0.0 to 1.0 m
# The foot.
foot = \"Right\" # default Left, one of Left, Right
# Shift to the left.
shift = -7 # default 0, -9 to 9 mm
";

#[test]
fn tune_file_has_only_differences_and_round_trips() {
    let written = layers("[Kicker]\nshift = -7\nnear = 0.1\nfoot = \"Right\"\nfar = 0.3\n");
    assert_eq!(render(&written), FILE);
    assert_eq!(layers(FILE).settings().len(), 3);
    assert_eq!(render(&layers(FILE)), FILE);
}

#[test]
fn comments_stay_when_a_tune_file_is_rewritten() {
    let old = "\
# Hall 3, March.

# Measured by hand.
[Kicker]
# Wet grass.
runs = 5
# Largest distance of the ball.
# From ten kicks.
far = 0.25 # was \"0.2\"
foot = \"Right\" # default Left, one of Left, Right
# The end.
";
    let folder = Folder::new("comments");
    let path = folder.0.join("nao.toml");
    fs::write(&path, old).expect("room");
    write(&layers("[Kicker]\nfar = 0.3\nfoot = \"Right\"\nshift = -7\n"), &path, true).expect("written");
    let written = fs::read_to_string(&path).expect("a file");
    let kept = FILE
        .replace("source.\n\n", "source.\n# Hall 3, March.\n\n# Measured by hand.\n")
        .replace("# Largest", "# From ten kicks.\n# was \"0.2\"\n# Largest");
    assert_eq!(written, kept + "\n# Wet grass.\n# The end.\n");
    write(&layers(&written), &path, true).expect("written");
    assert_eq!(fs::read_to_string(&path).expect("a file"), written);
}

#[test]
fn existing_file_is_replaced_on_request_only() {
    let folder = Folder::new("write");
    let path = folder.0.join("nao.toml");
    write(&layers(FILE), &path, false).expect("written");
    assert_eq!(fs::read_to_string(&path).expect("a file"), FILE);
    let exists = format!("`{}` exists", path.display());
    assert_fails(write(&layers("[Kicker]\nfar = 0.4"), &path, false), &exists, "--force replaces it");
    assert_eq!(fs::read_to_string(&path).expect("a file"), FILE);
    write(&Layers::new(&GRAPH), &path, true).expect("replaced");
    assert_eq!(fs::read_to_string(&path).expect("a file"), FILE.lines().next().expect("a line").to_owned() + "\n");
    let mut read = Layers::new(&GRAPH);
    read.read(&path).expect("an empty tune file is valid");
    assert_eq!(fs::read_dir(&folder.0).expect("a folder").count(), 1);
}

#[test]
fn a_file_that_cannot_be_read_or_written_is_named() {
    let folder = Folder::new("missing");
    let path = folder.0.join("no/nao.toml");
    for (result, action) in
        [(Layers::new(&GRAPH).read(&path), "read"), (write(&Layers::new(&GRAPH), &path, false), "write")]
    {
        let Err(Invalid { what, .. }) = result else { panic!("there is no such folder") };
        assert!(what.starts_with(&format!("cannot {action} `{}`: ", path.display())), "{what}");
    }
}
