//! Detections of a folder, as a table and as JSON.

use crate::polar::Polar;
use crate::statistics::percentile;
use bica_app::{Console, Failure, Outcome, Style};
use glam::Vec2;
use serde::Serialize;

use super::{ColourTable, DetectionOptions, Detections, Folder, Goal, PoseTrust};

/// Detections of a folder, for JSON.
#[derive(Debug, Serialize)]
struct Report {
    schema: &'static str,
    folder: String,
    frames: Vec<Detections>,
    skipped: Vec<Skipped>,
    summary: Summary,
}

#[derive(Debug, Serialize)]
struct Skipped {
    file: String,
    why: String,
}

#[derive(Debug, Serialize)]
struct Summary {
    seen: usize,
    skipped: usize,
    balls: usize,
    /// Number of balls with a position on the ground.
    balls_placed: usize,
    goals_complete: usize,
    goals_partial: usize,
    field_ends: usize,
    poses_untrusted: usize,
    /// Names of the images without a pose.
    poses_missing: Vec<String>,
}

/// Runs the detectors on every image of a folder; prints each image and a summary.
///
/// # Errors
/// If a file of the options cannot be read, or the output cannot be written.
pub fn watch(options: &DetectionOptions) -> Result<Outcome, Failure> {
    let console = Console::new(options.json);
    let mut folder = Folder::open(options, ColourTable::load(&options.profile)?)?;
    let has_poses = folder.has_poses();
    let header = columns("image", "ball: x, y, radius px", "ball on the ground", "field boundary", "goals");
    console.print(&console.styled(Style::Faint, &header))?;
    let (mut frames, mut skipped) = (Vec::new(), Vec::new());
    let outcome = folder.detect(|file, seen, _| match seen {
        Ok(detections) => {
            let row = table_row(&detections);
            frames.push(detections);
            console.print(&row)
        }
        Err(why) => {
            let row = skipped_row(console, file, &why);
            skipped.push(Skipped { file: file.to_owned(), why });
            console.print(&row)
        }
    })?;
    let summary = Summary::new(&frames, skipped.len());
    let folder = options.folder.display().to_string();
    let report = Report { schema: "bica-player/watch/1", folder, frames, skipped, summary };
    report.print(console, has_poses)?;
    Ok(outcome)
}

impl Report {
    fn print(&self, console: Console, has_poses: bool) -> Result<(), Failure> {
        let sum = &self.summary;
        let balls = format!("{} in {} images, {} with a position on the ground", sum.balls, sum.seen, sum.balls_placed);
        let rows = [
            ("images", format!("{} read, {} skipped", sum.seen, sum.skipped)),
            ("balls", balls),
            ("goals", format!("{} complete, {} partial", sum.goals_complete, sum.goals_partial)),
            ("field", format!("boundary in {} images", sum.field_ends)),
            ("poses", sum.poses(has_poses)),
            ("time", times(&self.frames)),
        ];
        console.print("")?;
        rows.iter().try_for_each(|(name, text)| console.print_row(name, text))?;
        for Skipped { file, why } in &self.skipped {
            console.print_row("skipped", &format!("{file}: {why}"))?;
        }
        console.print_json(self)
    }
}

impl Summary {
    fn new(frames: &[Detections], skipped: usize) -> Self {
        let count = |matches: &dyn Fn(&Detections) -> bool| frames.iter().filter(|frame| matches(frame)).count();
        let goals = |complete| frames.iter().flat_map(|frame| &frame.goals).filter(|g| g.complete == complete).count();
        let missing = frames.iter().filter(|frame| frame.pose == PoseTrust::Missing);
        Self {
            seen: frames.len(),
            skipped,
            balls: count(&|frame| frame.ball.is_some()),
            balls_placed: count(&|frame| frame.ball.as_ref().is_some_and(|ball| ball.ground.is_some())),
            goals_complete: goals(true),
            goals_partial: goals(false),
            field_ends: count(&|frame| !frame.field_boundary.is_empty()),
            poses_untrusted: count(&|frame| frame.pose == PoseTrust::Untrusted),
            poses_missing: missing.map(|frame| frame.file.clone()).collect(),
        }
    }

    fn poses(&self, has_poses: bool) -> String {
        let Self { seen, poses_untrusted, poses_missing, .. } = self;
        if !has_poses {
            return "none, so no positions on the ground (see --poses)".to_owned();
        }
        let trusted = seen - poses_untrusted - poses_missing.len();
        let names = if poses_missing.is_empty() { String::new() } else { format!(" ({})", poses_missing.join(" ")) };
        format!("{trusted} trusted, {poses_untrusted} not trusted, {} missing{names}", poses_missing.len())
    }
}

/// Returns the table row of a file that was skipped.
pub(super) fn skipped_row(console: Console, file: &str, why: &str) -> String {
    format!("{file:<12} {}", console.styled(Style::Bad, &format!("skipped, {why}")))
}

/// Returns the table row of an image.
pub(super) fn table_row(detections: &Detections) -> String {
    let dash = || "-".to_owned();
    let ball = detections.ball.as_ref();
    let pixels = ball.map_or_else(dash, |ball| format!("{:.1}, {:.1}, {:.1}", ball.x, ball.y, ball.radius));
    let place = ball.and_then(|ball| ball.ground).map(|at| Polar::new(Vec2::from(at), true).to_string());
    let top = detections.field_boundary.iter().map(|corner| corner[1]).reduce(f32::min);
    let end = top.map_or_else(dash, |row| format!("row {row:.0}"));
    let goals: Vec<String> = detections.goals.iter().map(goal).collect();
    let goals = if goals.is_empty() { dash() } else { goals.join("; ") };
    columns(&detections.file, &pixels, place.as_deref().unwrap_or("-").trim(), &end, &goals)
}

fn goal(goal: &Goal) -> String {
    let Goal { colour, x0, y0, x1, y1, complete, ground } = goal;
    let part = if *complete { "" } else { " (part)" };
    let place = ground.map(|at| Polar::new(Vec2::from(at), true).to_string());
    format!("{colour} {x0:.0}:{y0:.0}:{x1:.0}:{y1:.0}{part} {}", place.as_deref().unwrap_or("").trim())
}

fn columns(file: &str, pixels: &str, place: &str, end: &str, goals: &str) -> String {
    format!("{file:<12} {pixels:<22} {place:<20} {end:<13} {goals}")
}

fn times(frames: &[Detections]) -> String {
    let mut times: Vec<f64> = frames.iter().map(|frame| frame.wall_ms).collect();
    times.sort_by(f64::total_cmp);
    let at = |part| percentile(&times, part).unwrap_or(0.0);
    format!("p50 {:.3}  p99 {:.3}  max {:.3} ms per image", at(0.5), at(0.99), at(1.0))
}
