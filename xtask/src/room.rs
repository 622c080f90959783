//! Room on the disk for what CI builds.

use std::fs;

use crate::install::folder;
use crate::process::output;

/// Room that all steps take in an empty build directory and for temporary files, GB: 11.0 were measured with `df`.
const NEEDED: f64 = 12.0;
/// Room that the steps take if the build directory has everything, GB.
const AT_LEAST: f64 = 3.0;
/// Blocks of `df -k` and `du -k` in a GB.
const BLOCKS: f64 = 1e9 / 1024.0;

/// Checks that the disk has room for all steps: a full disk fails tests that have no mistake.
///
/// # Errors
/// If there is too little, or it cannot be read.
pub(crate) fn check() -> Result<(), String> {
    let folder = folder("");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let path = folder.display().to_string();
    // A folder whose files come and go meanwhile counts as empty.
    let present = output("du", &["-sk", &path], &[]).and_then(|table| gigabytes(&table, 0)).unwrap_or_default();
    let free = gigabytes(&output("df", &["-Pk", &path], &[])?, 3)?;
    let needed = (NEEDED - present).max(AT_LEAST);
    let found = format!("{free:.1} GB are free on the disk of {path}, CI needs {needed:.1} GB");
    if free < needed {
        return Err(format!("{found}: delete other files there, or set CARGO_TARGET_DIR to a folder on another disk"));
    }
    eprintln!("xtask: {found}");
    Ok(())
}

/// Returns a number of blocks in the last line of a table.
fn gigabytes(table: &str, column: usize) -> Result<f64, String> {
    let field = table.lines().last().and_then(|line| line.split_whitespace().nth(column));
    let blocks: Option<f64> = field.and_then(|field| field.parse().ok());
    blocks.map(|blocks| blocks / BLOCKS).ok_or_else(|| format!("no number in column {column} of:\n{table}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_read_from_the_last_line() {
        let table =
            "Filesystem 1024-blocks Used Available Capacity Mounted on\n/dev/vda 264000000 63000000 33000000 66% /\n";
        assert_eq!(gigabytes(table, 3).map(f64::round), Ok(34.0));
        assert!(gigabytes("", 0).is_err() && gigabytes("a b", 1).is_err());
    }
}
