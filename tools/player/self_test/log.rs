//! Decoding of the robot's log with the format strings in the image.

use std::error::Error;
use std::fs;
use std::path::Path;

use defmt_decoder::{DecodeError, Table};

/// Returns the lines of a log.
pub(crate) fn decode(image: &Path, log: &Path) -> Result<Vec<String>, Box<dyn Error>> {
    let table = Table::parse(&fs::read(image)?)?.ok_or("the image contains no format strings of a log")?;
    let mut decoder = table.new_stream_decoder();
    decoder.received(&fs::read(log)?);
    let mut lines = Vec::new();
    loop {
        match decoder.decode() {
            Ok(frame) => lines.push(frame.display(false).to_string()),
            Err(DecodeError::UnexpectedEof) => return Ok(lines),
            Err(DecodeError::Malformed) => return Err("the log was not written by this image".into()),
        }
    }
}
