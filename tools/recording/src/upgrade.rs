//! Files of the former format.

use std::io::{Read, Write};

use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::layout::Layout;
use crate::repair::{Copied, Copy};

/// Writes a recording of the former format in the present one, with the same cycles and new topics. Data after damage are
/// omitted.
///
/// # Errors
/// If the source cannot be read, has another format than the former one or no intact cycle, or the target cannot be written.
pub fn upgrade(source: impl Read, target: impl Write) -> Result<Copied, Error> {
    let mut contents = Contents::of(source, Layout::Former)?;
    let mut copy = Copy::new(target, contents.header.clone(), None)?;
    loop {
        match contents.next() {
            Ok(Part::End) => break,
            Ok(Part::Chunk) => copy.chunk()?,
            Ok(Part::Message(channel, message)) => copy.message(channel, message, |_| true)?,
            Err(Error::Io(error)) => return Err(error.into()),
            Err(error) => {
                copy.damage(&error);
                break;
            }
        }
    }
    if copy.copied.cycles == 0 {
        return Err(Error::NoCycle(copy.copied.damage.join("; ")));
    }
    copy.ending = contents.ending;
    copy.finish()
}
