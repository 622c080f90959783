//! Detections of a folder, as a table and as JSON.

use std::path::Path;

use crate::statistics::percentile;
use bica_app::{Console, Failure, Style};
use bica_drawing::polar::Polar;
use glam::Vec2;
use serde::Serialize;

use super::{DetectionObserver, Detections, Goal, PoseTrust};
use crate::camera_poses::Pose;

/// Detections of a folder; prints each image as it comes.
#[derive(Debug, Serialize)]
pub struct Report {
    schema: &'static str,
    folder: String,
    #[serde(skip)]
    console: Console,
    #[serde(skip)]
    has_poses: bool,
    frames: Vec<Detections>,
    skipped: Vec<Skipped>,
    summary: Summary,
}

#[derive(Debug, Serialize)]
struct Skipped {
    file: String,
    why: String,
}

#[derive(Debug, Default, Serialize)]
struct Summary {
    seen: usize,
    skipped: usize,
    balls: usize,
    /// Balls with a position on the ground.
    balls_placed: usize,
    goals_complete: usize,
    goals_partial: usize,
    field_ends: usize,
    poses_untrusted: usize,
    /// Images without a pose.
    poses_missing: Vec<String>,
}

impl Report {
    /// A report without images.
    #[must_use]
    pub fn new(console: Console, folder: &Path, has_poses: bool) -> Self {
        Self {
            schema: "bica-player/watch/1",
            folder: folder.display().to_string(),
            console,
            has_poses,
            frames: Vec::new(),
            skipped: Vec::new(),
            summary: Summary::default(),
        }
    }

    /// Prints the header of the columns.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn begin(&self) -> Result<(), Failure> {
        let header = columns("image", "ball: x, y, radius px", "ball on the ground", "field boundary", "goals");
        self.console.print(&self.console.styled(Style::Faint, &header))
    }

    /// Prints the summary.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn end(&mut self) -> Result<(), Failure> {
        let console = self.console;
        self.summary = Summary::new(&self.frames, self.skipped.len());
        let sum = &self.summary;
        console.print("")?;
        console.print_row("images", &format!("{} read, {} skipped", sum.seen, sum.skipped))?;
        console.print_row(
            "balls",
            &format!("{} in {} images, {} with a position on the ground", sum.balls, sum.seen, sum.balls_placed),
        )?;
        console.print_row("goals", &format!("{} complete, {} partial", sum.goals_complete, sum.goals_partial))?;
        console.print_row("field", &format!("boundary in {} images", sum.field_ends))?;
        console.print_row("poses", &self.poses())?;
        console.print_row("time", &times(&self.frames))?;
        for Skipped { file, why } in &self.skipped {
            console.print_row("skipped", &format!("{file}: {why}"))?;
        }
        console.print_json(self)
    }

    fn poses(&self) -> String {
        let Summary { seen, poses_untrusted, poses_missing, .. } = &self.summary;
        if !self.has_poses {
            return "none, so no positions on the ground (see --poses)".to_owned();
        }
        let trusted = seen - poses_untrusted - poses_missing.len();
        let names = if poses_missing.is_empty() { String::new() } else { format!(" ({})", poses_missing.join(" ")) };
        format!("{trusted} trusted, {poses_untrusted} not trusted, {} missing{names}", poses_missing.len())
    }
}

impl DetectionObserver for Report {
    fn detected(&mut self, detections: Detections, _pose: Option<&Pose>) -> Result<(), Failure> {
        self.console.print(&table_row(&detections))?;
        self.frames.push(detections);
        Ok(())
    }

    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure> {
        let words = self.console.styled(Style::Bad, &format!("skipped, {why}"));
        self.console.print(&format!("{file:<12} {words}"))?;
        self.skipped.push(Skipped { file: file.to_owned(), why });
        Ok(())
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
}

/// Returns an image as a row of the table.
#[must_use]
pub fn table_row(detections: &Detections) -> String {
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
