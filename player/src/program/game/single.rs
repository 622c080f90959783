//! One game, told as it goes.

use std::path::Path;

use serde::Serialize;

use super::album::Album;
use super::game_loop::{Rules, play};
use super::record::{Outcome, Record};
use super::story::{Change, Story};
use super::summary;
use crate::program::ending::{Ending, Failure};
use crate::program::film::Film;
use crate::program::voice::Voice;

/// A game for machines.
#[derive(Serialize)]
struct Told<'a> {
    schema: &'static str,
    #[serde(flatten)]
    record: &'a Record,
    story: &'a [Change],
}

/// Plays it, sums it up.
pub(crate) fn run(
    rules: &Rules,
    voice: Voice,
    pictures: Option<&Path>,
    film: Option<&Path>,
) -> Result<Ending, Failure> {
    let album = pictures.map(Album::new).transpose()?;
    let filming = film.map(Film::new).transpose()?;
    let story = Story::new(voice);
    story.begin()?;
    let mut audience = (story, (album, filming));
    let record = play(rules, &mut audience)?;
    let (story, (album, filming)) = audience;
    summary::tell(voice, &record)?;
    if let Some((album, folder)) = album.zip(pictures) {
        voice.say("")?;
        summary::row(voice, "pictures", &format!("{} in {}", album.count, folder.display()))?;
    }
    if let Some((filming, path)) = filming.zip(film) {
        let count = filming.end()?;
        voice.say("")?;
        summary::row(voice, "film", &format!("{count} pictures in {}", path.display()))?;
    }
    voice.result(&Told { schema: "bica-player/game/1", record: &record, story: &story.changes })?;
    Ok(match record.result {
        Outcome::Goal => Ending::Reached,
        Outcome::NoGoal => Ending::Missed,
        Outcome::Interrupted => Ending::Interrupted,
    })
}
