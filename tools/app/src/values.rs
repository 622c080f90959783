//! Parsers of values that several commands take.

use bica_link::Address;

use crate::console::Failure;

/// Parses a duration of 0.01 to 86400 s.
///
/// # Errors
/// If the text is not such a number.
pub fn seconds(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|time: &f64| (0.01..=86_400.0).contains(time));
    fits.ok_or_else(|| "give a time from 0.01 to 86400 seconds".to_owned())
}

/// Parses a time in a recording, s since its first cycle.
pub(crate) fn time(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|time: &f64| time.is_finite() && *time >= 0.0);
    fits.ok_or_else(|| "give a time in seconds since the first cycle, 0 or more".to_owned())
}

/// Parses the address of a link.
pub(crate) fn address(text: &str) -> Result<Address, String> {
    text.parse().map_err(|error: bica_link::Error| error.help())
}

/// Returns the end of a span that begins at `from`, s; infinity without an end.
///
/// # Errors
/// If it is before the begin.
pub(crate) fn end_of_span(from: f64, until: Option<f64>) -> Result<f64, Failure> {
    let until = until.unwrap_or(f64::INFINITY);
    if until < from {
        return Err(Failure::new("--until is before --from", "give a later time with --until"));
    }
    Ok(until)
}
