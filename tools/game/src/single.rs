//! One game, told as it goes.

use std::path::Path;

use serde::Serialize;

use super::album::Album;
use super::game_loop::{Rules, play};
use super::story::{Change, Story};
use super::summary::{GameResult, Record};
use super::summary_text;
use crate::film::Film;
use bica_console::Console;
use bica_console::{Failure, Outcome};

/// A game for machines.
#[derive(Serialize)]
struct Told<'a> {
    schema: &'static str,
    #[serde(flatten)]
    record: &'a Record,
    story: &'a [Change],
}

/// Plays it, sums it up.
pub fn run(rules: &Rules, console: Console, pictures: Option<&Path>, film: Option<&Path>) -> Result<Outcome, Failure> {
    let album = pictures.map(Album::new).transpose()?;
    let filming = film.map(Film::new).transpose()?;
    let story = Story::new(console);
    story.begin()?;
    let mut observer = (story, (album, filming));
    let record = play(rules, &mut observer)?;
    let (story, (album, filming)) = observer;
    summary_text::tell(console, &record)?;
    if let Some((album, folder)) = album.zip(pictures) {
        console.print("")?;
        console.print_row("pictures", &format!("{} in {}", album.count, folder.display()))?;
    }
    if let Some((filming, path)) = filming.zip(film) {
        let count = filming.end()?;
        console.print("")?;
        console.print_row("film", &format!("{count} pictures in {}", path.display()))?;
    }
    console.print_json(&Told { schema: "bica-player/game/1", record: &record, story: &story.changes })?;
    Ok(match record.result {
        GameResult::Goal => Outcome::Success,
        GameResult::NoGoal => Outcome::Unsuccessful,
        GameResult::Interrupted => Outcome::Interrupted,
    })
}
