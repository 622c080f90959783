//! Processes of the program.

use std::process::{Command, Stdio};

use serde_json::Value;

pub(crate) use bica_test_data::process::{Folder, Ran, Served};

/// Returns the program with arguments, not yet started.
pub(crate) fn player(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_player"));
    command.args(args).stdin(Stdio::null());
    command
}

/// Runs the program to its end.
pub(crate) fn run(args: &[&str]) -> Ran {
    Ran::of(player(args))
}

/// Runs the program. It must end with exit code 2 and print these words on stderr.
pub(crate) fn refused(args: &[&str], words: &[&str]) -> Ran {
    let ran = run(args);
    ran.refused(words);
    ran
}

/// Removes all values that depend on the computer.
pub(crate) fn without_wall(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.retain(|name, _| !name.starts_with("wall"));
            fields.values_mut().for_each(without_wall);
        }
        Value::Array(values) => values.iter_mut().for_each(without_wall),
        _ => {}
    }
}
