//! Slowest parts of a build, from the report that `cargo --timings` writes.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use serde_json::Value;

const REPORT: &str = "target/cargo-timings/cargo-timing.html";

/// Lists the slowest compilations of the last build in a folder, one per line.
///
/// # Errors
/// If there is no report, or its format is unknown.
pub(super) fn table(folder: &Path, lines: usize) -> Result<String, String> {
    let text = fs::read_to_string(folder.join(REPORT)).map_err(|error| format!("cannot read {REPORT}: {error}"))?;
    slowest(&text, lines)
}

fn slowest(report: &str, lines: usize) -> Result<String, String> {
    let unknown = || format!("{REPORT} has an unknown format");
    let (_, data) = report.split_once("const UNIT_DATA = ").ok_or_else(unknown)?;
    let (data, _) = data.split_once(";\n").ok_or_else(unknown)?;
    let units: Vec<Value> = serde_json::from_str(data).map_err(|_| unknown())?;
    let mut rows: Vec<(f64, String)> = units.iter().map(row).collect::<Option<_>>().ok_or_else(unknown)?;
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut table = String::new();
    for (seconds, name) in rows.iter().take(lines) {
        let _ = writeln!(table, "{seconds:>8.1} s  {name}");
    }
    Ok(table)
}

fn row(unit: &Value) -> Option<(f64, String)> {
    let (name, target) = (unit["name"].as_str()?, unit["target"].as_str().unwrap_or_default());
    Some((unit["duration"].as_f64()?, format!("{name}{target}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slowest_compilations_come_first() {
        let report = "<script>const UNIT_DATA = [
            {\"name\": \"libm\", \"target\": \"\", \"duration\": 1.5},
            {\"name\": \"player\", \"target\": \" player \\\"bin\\\"\", \"duration\": 62.9},
            {\"name\": \"glam\", \"target\": \"\", \"duration\": 2.0}];\n</script>";
        let expected = "    62.9 s  player player \"bin\"\n     2.0 s  glam\n";
        assert_eq!(slowest(report, 2).as_deref(), Ok(expected));
    }

    #[test]
    fn a_report_of_an_unknown_format_is_an_error() {
        assert!(slowest("", 3).is_err());
        assert!(slowest("const UNIT_DATA = [{\"name\": \"libm\"}];\n", 3).is_err());
    }
}
