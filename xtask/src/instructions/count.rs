//! Counting.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::process::{output, run};

/// Asks the benchmarks to be slow, when they are compiled.
const SLOW: (&str, &str) = ("BICA_SLOW", "1");

/// Runs the benchmarks under valgrind, as they are or made slower on purpose: instructions by name.
///
/// # Errors
/// What does not build or run, or what cannot be understood of what comes out.
pub(crate) fn count(runner: &str, slow: bool) -> Result<BTreeMap<String, u64>, String> {
    let bench = ["bench", "--package", "bica-benches", "--bench", "instructions"];
    let variables = [("GUNGRAUN_RUNNER", runner), SLOW];
    let variables = if slow { &variables[..] } else { &variables[..1] };
    // The first build takes minutes and shows how far it is.
    run("cargo", &[&bench[..], &["--no-run"]].concat(), variables)?;
    let asked = ["--quiet", "--", "--output-format=json", "--parallel=auto"];
    let out = output("cargo", &[&bench[..], &asked].concat(), variables)?;
    out.lines().map(read).collect()
}

/// One benchmark's name and count.
fn read(line: &str) -> Result<(String, u64), String> {
    let told = |error| format!("gungraun-runner told something else than was expected, {error}: {line:.100}");
    let json: Value = serde_json::from_str(line).map_err(|error| told(error.to_string()))?;
    let word = |name: &str| json[name].as_str().map(str::to_owned).ok_or_else(|| told(format!("no `{name}`")));
    let count = json.pointer("/profiles/0/data/total/metrics/Ir/values/new").and_then(Value::as_u64);
    let name = format!("{}.{}", word("function_name")?, word("id")?);
    Ok((name, count.ok_or_else(|| told("no count of instructions".to_owned()))?))
}

/// The compiler and the processor that it compiles for, on which the counts depend.
///
/// # Errors
/// If there is none.
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
