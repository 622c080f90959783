//! Instruction counts of the benchmarks.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::process::{output, run};

/// Environment variable that compiles the artificial slowdown into the benchmarks.
const SLOW: (&str, &str) = ("BICA_SLOW", "1");

/// Runs the benchmarks under valgrind, optionally with the artificial slowdown, and returns the instructions of each by
/// name.
///
/// # Errors
/// If a benchmark does not build or run, or the output has an unknown format.
pub(crate) fn count(runner: &str, slow: bool) -> Result<BTreeMap<String, u64>, String> {
    let bench = ["bench", "--package", "bica-benches", "--bench", "instructions"];
    let variables = [("GUNGRAUN_RUNNER", runner), SLOW];
    let variables = if slow { &variables[..] } else { &variables[..1] };
    // The first build takes minutes, so its progress is shown.
    run("cargo", &[&bench[..], &["--no-run"]].concat(), variables)?;
    let options = ["--quiet", "--", "--output-format=json", "--parallel=auto"];
    let out = output("cargo", &[&bench[..], &options].concat(), variables)?;
    out.lines().map(read).collect()
}

/// Parses the name and the count of a benchmark.
fn read(line: &str) -> Result<(String, u64), String> {
    let unknown = |error| format!("output of gungraun-runner has an unknown format, {error}: {line:.100}");
    let json: Value = serde_json::from_str(line).map_err(|error| unknown(error.to_string()))?;
    let word = |name: &str| json[name].as_str().map(str::to_owned).ok_or_else(|| unknown(format!("no `{name}`")));
    let count = json.pointer("/profiles/0/data/total/metrics/Ir/values/new").and_then(Value::as_u64);
    let name = format!("{}.{}", word("function_name")?, word("id")?);
    Ok((name, count.ok_or_else(|| unknown("no count of instructions".to_owned()))?))
}

/// Returns the compiler version and the target processor, on which the counts depend.
///
/// # Errors
/// If the compiler cannot be run.
pub(crate) fn compiler() -> Result<String, String> {
    let out = output("rustc", &["--version"], &[])?;
    let version = out.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    Ok(format!("{version} for {}", std::env::consts::ARCH))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_runner_is_a_name_and_a_count() {
        let line = r#"{"function_name": "component", "id": "walk", "profiles":
            [{"data": {"total": {"metrics": {"Ir": {"values": {"new": 7314}}}}}}]}"#;
        assert_eq!(read(line), Ok(("component.walk".to_owned(), 7314)));
        assert!(read("{}").is_err_and(|error| error.contains("no `function_name`")));
    }
}
