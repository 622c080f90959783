//! Functions that were meant to be the step and are not.

use syn::{FnArg, ReturnType, Signature, Type};

use super::block::Function;
use super::model::Component;
use crate::report::Report;
use crate::types::plain;
use crate::{text, wording};

/// Words of their own, spelt much like `step`.
const WORDS: [&str; 5] = ["stop", "steps", "steep", "stem", "stew"];

/// Reports functions that look like a misspelt step, if the component has none.
pub(crate) fn check(component: &Component, report: &mut Report) {
    if component.step.is_some() || !component.states.is_empty() || component.incomplete {
        return;
    }
    let called = |function: &Function| component.functions().any(|one| one.name == function.signature.ident);
    for function in component.block.functions().filter(|function| !called(function)) {
        let name = text::name(&function.signature.ident);
        if is_near(&name) && is_like_a_step(&function.signature) {
            report.add(&function.signature.ident, wording::not_called_step(&name));
        }
    }
}

fn is_near(name: &str) -> bool {
    let lower = name.to_lowercase();
    let bare = lower.trim_matches('_');
    name != "step" && !WORDS.contains(&bare) && text::distance(bare, "step") <= 1
}

/// Whether a signature could be that of a step.
fn is_like_a_step(signature: &Signature) -> bool {
    let is_link = |argument: &FnArg| match argument {
        FnArg::Receiver(_) => true,
        FnArg::Typed(typed) => match plain(&typed.ty) {
            Type::Reference(reference) => matches!(plain(&reference.elem), Type::Path(_)),
            _ => false,
        },
    };
    let takes_itself = matches!(signature.inputs.first(), Some(FnArg::Receiver(_)));
    takes_itself && signature.inputs.iter().all(is_link) && matches!(signature.output, ReturnType::Default)
}
