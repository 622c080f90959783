//! Check of a program's names before a command starts.

use bica::graph::Graph;
use bica_recording::NameTable;
use clap::Command;

use crate::console::Failure;

/// Checks that no two worlds, no two commands, and no output and parameter of one component share a name.
///
/// # Errors
/// If two share a name; the text gives the name and both sources.
pub(crate) fn check(graph: &Graph, worlds: &[&str], command: &Command) -> Result<(), Failure> {
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
    let mut table = NameTable::new("name in expressions");
    for node in graph.nodes {
        let named = |kind, own| (format!("{}.{own}", node.name), format!("the {kind} `{}.{own}`", node.name));
        let params = node.params.iter().flat_map(|group| group.params).map(|param| named("parameter", param.name));
        let outputs = node.outputs.iter().map(|output| named("output", output.name));
        params.chain(outputs).try_for_each(|(name, source)| table.add(name, source))?;
    }
    Ok(())
}

#[cfg(test)]
#[expect(clippy::unused_self, reason = "getters have a receiver")]
mod tests {
    use bica::prelude::*;

    use super::*;

    /// How a lamp shines.
    #[derive(Params)]
    struct Bulb {
        /// Brightness of a unit of current.
        #[param(default = 1.0, range = 0.0..=2.0)]
        gain: f32,
    }

    struct Lamp;

    /// Has an output whose name is that of a parameter.
    #[component]
    impl Lamp {
        const fn new() -> Self {
            Self
        }

        fn step(&mut self, bulb: &Tuned<Bulb>) {
            let _ = bulb.gain;
        }

        /// Brightness.
        #[output]
        fn gain(&self) -> f32 {
            1.0
        }
    }

    activation_tree! { struct Lit { root: Lamp, cycle_hz: 50, components: [Lamp] } }

    const EMPTY: Graph = Graph { nodes: &[], ..Lit::GRAPH };

    fn refused(graph: &Graph, worlds: &[&str], commands: &[&'static str]) -> Option<String> {
        let command = commands.iter().fold(Command::new("lamp"), |all, name| all.subcommand(Command::new(*name)));
        match check(graph, worlds, &command) {
            Err(Failure::Error { what, .. }) => Some(what),
            _ => None,
        }
    }

    #[test]
    fn a_name_of_two_things_is_refused_with_both() {
        assert_eq!(refused(&EMPTY, &["room", "house"], &["run", "play"]), None);
        for (text, parts) in [
            (refused(&EMPTY, &["room", "house", "room"], &[]), ["world 1", "world 3", "`room`"]),
            (refused(&EMPTY, &[], &["run", "play", "run"]), ["command 1", "command 3", "`run`"]),
            (refused(&Lit::GRAPH, &[], &[]), ["the parameter `Lamp.gain`", "the output `Lamp.gain`", "expressions"]),
        ] {
            let text = text.unwrap_or_default();
            assert!(parts.iter().all(|part| text.contains(part)), "{text}");
        }
    }
}
