//! Lines of text that describe a robot and its world.

use bica_link::{Component, Modulation, Param};

use crate::console::{Console, Failure, Style};

pub(super) fn describe_component(console: Console, component: &Component) -> Result<(), Failure> {
    let hz = component.hz.map_or_else(|| "every cycle".to_owned(), |hz| format!("{hz} Hz"));
    let heading = console.styled(Style::Strong, &component.name);
    console.print(&format!("\n{heading}  {hz}  {}", console.styled(Style::Faint, first_line(&component.doc))))?;
    for param in &component.params {
        let value = param.value.map(|value| param.kind.text(value).to_string()).unwrap_or_default();
        let text =
            format!("{} = {value} {} ({})", param.name, param.unit.as_deref().unwrap_or_default(), param.range());
        console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&param.doc))))?;
    }
    for output in &component.outputs {
        let unit = output.unit.as_deref().map(|unit| format!(", {unit}")).unwrap_or_default();
        let text = format!("{}: {}{unit}", output.name, output.type_name);
        console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&output.doc))))?;
    }
    component.modulations.iter().try_for_each(|modulation| describe_call(console, modulation))
}

pub(super) fn describe_actions(console: Console, actions: &[Modulation]) -> Result<(), Failure> {
    if !actions.is_empty() {
        console.print(&format!("\n{}", console.styled(Style::Strong, "world")))?;
    }
    actions.iter().try_for_each(|action| describe_call(console, action))
}

/// Prints a modulation or an action.
fn describe_call(console: Console, call: &Modulation) -> Result<(), Failure> {
    let argument = |argument: &Param| {
        let unit = argument.unit.as_deref().map(|unit| format!(" {unit}")).unwrap_or_default();
        format!("{}{unit} ({})", argument.name, argument.range())
    };
    let arguments: Vec<_> = call.arguments.iter().map(argument).collect();
    let stops = if call.stops { ", stops the robot" } else { "" };
    let text = format!("{}({}){stops}", call.name, arguments.join(", "));
    console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&call.doc))))
}

fn first_line(doc: &str) -> &str {
    doc.lines().next().unwrap_or_default()
}
