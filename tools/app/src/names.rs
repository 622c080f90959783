//! Names of a program, checked before a command starts.

use bica_recording::NameTable;
use clap::Command;

use crate::console::Failure;

/// Checks that no two worlds or commands have one name.
///
/// # Errors
/// If two have: the text names both.
pub(crate) fn check(worlds: &[&str], command: &Command) -> Result<(), Failure> {
    let mut table = NameTable::new("value of `--world`");
    for (place, world) in worlds.iter().enumerate() {
        table.add(*world, format!("world {}", place + 1))?;
    }
    let mut table = NameTable::new("word on the command line");
    for (place, command) in command.get_subcommands().enumerate() {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        let source = format!("command {} (“{about}”)", place + 1);
        command.get_name_and_visible_aliases().into_iter().try_for_each(|name| table.add(name, &source))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(worlds: &[&str], commands: &[&'static str]) -> Option<String> {
        let command = commands.iter().fold(Command::new("lamp"), |all, name| all.subcommand(Command::new(*name)));
        match check(worlds, &command) {
            Err(Failure::Error { what, .. }) => Some(what),
            _ => None,
        }
    }

    #[test]
    fn a_name_of_two_things_is_refused_with_both() {
        assert_eq!(refused(&["room", "house"], &["run", "play"]), None);
        for (text, parts) in [
            (refused(&["room", "house", "room"], &[]), ["world 1", "world 3", "`room`"]),
            (refused(&[], &["run", "play", "run"]), ["command 1", "command 3", "`run`"]),
        ] {
            let text = text.unwrap_or_default();
            assert!(parts.iter().all(|part| text.contains(part)), "{text}");
        }
    }
}
