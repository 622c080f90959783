//! One game, with its story.

use std::path::Path;

use bica_app::{Console, Failure, InForce, Outcome};
use bica_recording::processor;
use serde::Serialize;

use crate::game::link::ServeOptions;
use crate::game::observer::GameObserver;
use crate::game::play::play_recorded;
use crate::game::recording::{RecordOptions, RecordingSummary};
use crate::game::rules::Rules;
use crate::game::story::{Story, TreeChange};
use crate::game::summary::{GameResult, GameSummary};
use crate::game::summary_text;
use crate::game::{Album, Film};

/// Report of a game, for JSON.
#[derive(Serialize)]
struct GameReport<'a> {
    schema: &'static str,
    #[serde(flatten)]
    summary: &'a GameSummary,
    #[serde(skip_serializing_if = "Option::is_none")]
    recording: Option<&'a RecordingSummary>,
    story: &'a [TreeChange],
    layers: &'a [InForce],
    wall_processor: String,
}

/// Plays a game; prints its story and its summary. On request writes pictures, a film and a recording, and serves monitors.
pub(crate) fn play_one(
    rules: &Rules,
    console: Console,
    pictures: Option<&Path>,
    film: Option<&Path>,
    record: Option<RecordOptions<'_>>,
    serve: Option<ServeOptions<'_>>,
    layers: &[InForce],
) -> Result<Outcome, Failure> {
    let mut album = pictures.map(Album::new).transpose()?;
    let mut recorder = film.map(Film::new).transpose()?;
    let mut story = Story::new(console);
    let mut observers: Vec<&mut dyn GameObserver> = vec![&mut story];
    observers.extend(album.as_mut().map(|album| album as _));
    observers.extend(recorder.as_mut().map(|recorder| recorder as _));
    let (summary, recording) = play_recorded(rules, &mut observers[..], record, serve)?;
    summary_text::print(console, &summary)?;
    if let Some((album, folder)) = album.zip(pictures) {
        console.print("")?;
        console.print_row("pictures", &format!("{} in {}", album.count(), folder.display()))?;
    }
    if let Some((recorder, path)) = recorder.zip(film) {
        let count = recorder.finish()?;
        console.print("")?;
        console.print_row("film", &format!("{count} pictures in {}", path.display()))?;
    }
    if let Some(recording) = &recording {
        console.print("")?;
        console.print_row("recording", &recording.text)?;
    }
    let recording = recording.as_ref();
    let (schema, wall_processor) = ("bica-player/game/1", processor());
    let report = GameReport { schema, summary: &summary, recording, story: &story.changes, layers, wall_processor };
    console.print_json(&report)?;
    Ok(match summary.result {
        GameResult::Goal => Outcome::Success,
        GameResult::NoGoal => Outcome::Unsuccessful,
        GameResult::Interrupted => Outcome::Interrupted,
    })
}
