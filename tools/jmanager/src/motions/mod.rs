//! Humanoids in the motion editor: conversion of rows in sources to postures, geometry of a posture, and trials of a motion in a
//! simulated body.

mod body;
mod form;
#[cfg(feature = "mujoco")]
mod kick;
mod play;
mod robot;
mod session;

use std::collections::BTreeMap;

use bica_monitor::program::{Asked, Extension, Reply};
use bica_monitor::protocol::Failed;
use bica_motion::joints::Joint;
#[cfg(not(feature = "mujoco"))]
use bica_motion::kick::KickKind;
use bica_motion::model::KickFrame;
use bica_motion::model::simulation::HUMANOIDS;
use serde::Deserialize;
use serde_json::{Value, json};

use body::Body;
use form::{Form, Start, kick_kind};
#[cfg(feature = "mujoco")]
use kick::tried;
use play::{Key, Play};
use session::Plan;

/// Largest number of key postures of a request.
const MAX_KEYS: usize = 500;
/// Largest duration of a motion that is tried, s.
const MAX_SECONDS: f32 = 120.0;
/// Largest number of runs of a trial.
const MAX_RUNS: u32 = 100;

/// Number of parts of the motion to a pose of a kick on the robot of the session.
const KICK_PARTS: usize = 6;

/// Requests of the panel.
#[derive(Debug, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Message {
    /// All forms.
    Forms {},
    /// Returns the body of the robot with these joints: a [`Body`], or nothing.
    Body { joints: Vec<String> },
    /// Returns each key posture in space, and the violations of motor limits in the motion to it: list of
    /// `{"shape", "handles", "anchor", "limits"}`; `anchor` is the pose of the frame of the handles.
    Shapes { form: String, keys: Vec<Row> },
    /// Returns the actions that play a motion on the robot of the session: a [`Plan`].
    Plan { form: String, keys: Vec<Row>, start: Start },
    /// Plays a motion in a simulated body: `{"runs": list, "joints": names}`; a kick: `{"verdict": {"good", "title", "text"}}`.
    Try {
        form: String,
        /// Key of the motion in its source.
        motion: String,
        keys: Vec<Row>,
        start: Start,
        mujoco: bool,
        runs: u32,
    },
}

/// A row of a motion.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    /// Duration of the motion to its posture, s.
    seconds: f32,
    /// Numbers by the names of their cells.
    cells: BTreeMap<String, f32>,
}

/// The extension.
pub(super) struct Motions {
    forms: Vec<Form>,
}

impl Motions {
    pub(super) fn new() -> Self {
        Self { forms: Form::all() }
    }

    fn form(&self, name: &str) -> Result<&Form, Failed> {
        let none = || Failed::new(format!("there is no form `{}`", name.escape_debug()), "reload the page");
        self.forms.iter().find(|form| form.name() == name).ok_or_else(none)
    }

    fn shapes(&self, form: &str, keys: &[Row]) -> Result<Value, Failed> {
        let form = self.form(form)?;
        let mut from = form.robot.stand;
        let shapes = keys.iter().map(|key| {
            let to = form.posture_of(&key.cells);
            let peak = if form.linear { 1.0 } else { 1.5 };
            let limits = robot::limits(form.robot, &from, &to, peak / key.seconds);
            from = to;
            let shape = robot::shape(form.robot, &to);
            let anchor = if form.kicks { shape.right_sole } else { shape.torso };
            json!({ "shape": shape, "handles": form.handles(&to), "anchor": anchor, "limits": limits })
        });
        Ok(shapes.collect())
    }
}

impl Form {
    fn play(&self, keys: &[Row], start: Start) -> Play {
        let key = |key: &Row| Key {
            seconds: key.seconds,
            posture: self.posture_of(&key.cells),
            stiffness: key.cells.get("stiffness").copied().unwrap_or(1.0).clamp(0.0, 1.0),
        };
        let (linear, stretches) = (self.linear, self.stretches);
        Play { keys: keys.iter().map(key).collect(), linear, stretches, start, mujoco: false, runs: 1 }
    }

    /// Plans a motion. The foot of a kick moves on a straight line, but its joints do not, so each motion to a pose is divided.
    fn plan(&self, keys: &[Row], start: Start) -> Plan {
        if !self.kicks {
            return Plan::new(&self.play(keys, start), 1);
        }
        let mut from = self.rest();
        let mut divided = Vec::new();
        for Row { seconds, cells } in keys {
            for part in 1..=KICK_PARTS {
                let share = part as f32 / KICK_PARTS as f32;
                let share = share * share * (3.0 - 2.0 * share);
                let between = |(cell, from): (&String, &f32)| {
                    let to = cells.get(cell).unwrap_or(from);
                    (cell.clone(), from + share * (to - from))
                };
                divided.push(Row { seconds: seconds / KICK_PARTS as f32, cells: from.iter().map(between).collect() });
            }
            from.extend(cells.clone());
        }
        Plan::new(&Play { linear: true, ..self.play(&divided, start) }, KICK_PARTS)
    }
}

impl Extension for Motions {
    fn name(&self) -> &'static str {
        "motions"
    }

    fn module(&self) -> &'static str {
        include_str!("../../panels/motions.js")
    }

    fn only_reads(&self, message: &Value) -> bool {
        message["type"] != "try"
    }

    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed> {
        let message =
            serde_json::from_value(message).map_err(|error| Failed::new(error.to_string(), "reload the page"))?;
        match message {
            Message::Forms {} => Ok(Reply::Done(json!(self.forms))),
            Message::Body { joints } => Ok(Reply::Done(json!(body_with(&joints)))),
            Message::Shapes { form, keys } => {
                check(&keys)?;
                self.shapes(&form, &keys).map(Reply::Done)
            }
            Message::Plan { form, keys, start } => {
                check(&keys)?;
                Ok(Reply::Done(json!(self.form(&form)?.plan(&keys, start))))
            }
            Message::Try { form, motion, keys, start, mujoco, runs } => {
                check(&keys)?;
                if !(1..=MAX_RUNS).contains(&runs) {
                    return Err(Failed::new(format!("{runs} runs"), format!("choose 1 to {MAX_RUNS}")));
                }
                let form = self.form(&form)?;
                if form.kicks {
                    let what = format!("`{}` is none of the kicks FRONT, DIAGONAL, LATERAL", motion.escape_debug());
                    let kind = kick_kind(&motion).ok_or_else(|| Failed::new(what, "try one of these"))?;
                    let frame = |key: &Row| KickFrame { duration: key.seconds, pose: form.kick_pose(&key.cells) };
                    let frames = keys.iter().map(frame).collect();
                    return asked.later(Box::new(move || Ok(json!({ "verdict": tried(kind, frames, runs)? }))));
                }
                let play = Play { mujoco, runs, ..form.play(&keys, start) };
                let robot = form.robot;
                asked.later(Box::new(move || {
                    Ok(json!({ "runs": play::play(robot, &play)?, "joints": Joint::ALL.map(|joint| format!("{joint:?}")) }))
                }))
            }
        }
    }
}

fn body_with(joints: &[String]) -> Option<Body> {
    HUMANOIDS.iter().copied().map(Body::of).find(|body| body.joints == joints)
}

fn check(keys: &[Row]) -> Result<(), Failed> {
    let help = "divide the motion, or make it shorter";
    if keys.is_empty() || keys.len() > MAX_KEYS {
        return Err(Failed::new(format!("{} key postures: at least 1, at most {MAX_KEYS}", keys.len()), help));
    }
    let is_right = |key: &Row| key.seconds > 0.0 && key.cells.values().all(|value| value.is_finite());
    if !keys.iter().all(is_right) {
        return Err(Failed::new("a duration is not positive, or a number is not finite", "correct it first"));
    }
    let seconds: f32 = keys.iter().map(|key| key.seconds).sum();
    let long = || Failed::new(format!("{seconds:.0} s: at most {MAX_SECONDS:.0} s are possible"), help);
    if seconds > MAX_SECONDS { Err(long()) } else { Ok(()) }
}

#[cfg(not(feature = "mujoco"))]
fn tried(_: KickKind, _: Vec<KickFrame>, _: u32) -> Result<Value, Failed> {
    Err(play::without_mujoco().into())
}
