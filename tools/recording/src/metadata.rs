//! Header and ending as metadata records.

use std::collections::BTreeMap;
use std::io;

use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::header::{Ending, Header};
use crate::layout::Layout;

/// Name of the metadata record with the header.
pub(crate) const HEADER_NAME: &str = "bica";
/// Name of the metadata record with the ending.
pub(crate) const ENDING_NAME: &str = "bica.ending";
/// Key of the JSON text in a metadata record.
const KEY: &str = "json";
/// Key of the CRC-32 of this text, hexadecimal.
const CRC_KEY: &str = "crc32";

/// Returns the fields of the metadata record of a header. The writer is generic; this function is not, so that the code for the
/// JSON of a header is compiled once.
pub(crate) fn of_header(header: &Header) -> Result<BTreeMap<String, String>, Error> {
    to_metadata(header)
}

/// Returns the fields of the metadata record of an ending.
pub(crate) fn of_ending(ending: &Ending) -> Result<BTreeMap<String, String>, Error> {
    to_metadata(ending)
}

/// Returns the fields of a metadata record.
fn to_metadata(value: &impl Serialize) -> Result<BTreeMap<String, String>, Error> {
    let text = serde_json::to_string(value).map_err(io::Error::from)?;
    let crc = checksum(&text);
    Ok(BTreeMap::from([(KEY.to_owned(), text), (CRC_KEY.to_owned(), crc)]))
}

/// Returns the checksum of the text of a metadata record: its field `crc32`.
#[must_use]
pub fn checksum(text: &str) -> String {
    format!("{:08x}", crc32fast::hash(text.as_bytes()))
}

/// Returns the value of a metadata record at a position. A checksum is checked if there is one.
fn from_metadata<T: for<'a> Deserialize<'a>>(fields: &BTreeMap<String, String>, at: u64) -> Result<T, Error> {
    let text = fields.get(KEY).ok_or_else(|| Error::damaged(at, "the metadata have no field `json`"))?;
    if fields.get(CRC_KEY).is_some_and(|crc| *crc != checksum(text)) {
        return Err(Error::damaged(at, "the checksum of the metadata is wrong"));
    }
    serde_json::from_str(text).map_err(|error| Error::damaged(at, format!("the metadata cannot be read: {error}")))
}

/// Checks that metadata have a checksum.
fn check_metadata(fields: &BTreeMap<String, String>, at: u64) -> Result<(), Error> {
    let has_checksum = fields.contains_key(CRC_KEY);
    has_checksum.then_some(()).ok_or_else(|| Error::damaged(at, "the metadata have no checksum"))
}

/// Returns the ending of a metadata record.
pub(crate) fn ending_of(fields: &BTreeMap<String, String>, at: u64) -> Result<Ending, Error> {
    check_metadata(fields, at)?;
    from_metadata(fields, at)
}

/// Returns the header of a metadata record of a file with a layout, in the present format.
pub(crate) fn header_of(fields: &BTreeMap<String, String>, at: u64, layout: Layout) -> Result<Header, Error> {
    #[derive(Deserialize)]
    struct Format {
        format: u32,
        monitor: Option<IgnoredAny>,
    }
    let Format { format, monitor } = from_metadata(fields, at)?;
    let of_layout = |layout: Layout| layout.format(monitor.is_some());
    if format != of_layout(layout) {
        return Err(match format {
            former if former == of_layout(Layout::Former) => Error::Former(former),
            present if present == of_layout(Layout::Present) => Error::Present,
            other => Error::Format(other),
        });
    }
    check_metadata(fields, at)?;
    let header = Header { format: of_layout(Layout::Present), ..from_metadata(fields, at)? };
    let rates = header.tree.components.iter().filter_map(|one| one.hz).chain([header.tree.cycle_hz]);
    if header.tick_hz == 0 || rates.into_iter().any(|hz| !(hz > 0.0 && hz.is_finite())) {
        return Err(Error::damaged(at, "a rate of the header is not a finite number above 0"));
    }
    Ok(header)
}
