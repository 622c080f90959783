//! A role as an argument: `&impl Role`.

use syn::{Type, TypeImplTrait, TypeParamBound};

use crate::report::Report;
use crate::types::plain;
use crate::{text, wording};

/// The trait of a type that is written `impl Role`.
#[must_use]
pub fn role_of(kind: &Type) -> Option<&syn::Path> {
    let Type::ImplTrait(role) = plain(kind) else { return None };
    match role.bounds.first() {
        Some(TypeParamBound::Trait(bound)) => Some(&bound.path),
        _ => None,
    }
}

/// Reports what is not the name of one trait alone; returns whether it is that.
pub(super) fn is_one_trait(role: &TypeImplTrait, report: &mut Report) -> bool {
    let bounds: Vec<_> = role.bounds.iter().collect();
    let is_one = match bounds[..] {
        [TypeParamBound::Trait(bound)] => {
            let has_arguments = bound.path.segments.iter().any(|part| !part.arguments.is_none());
            !has_arguments && text::written(bound) == text::written(&bound.path)
        }
        _ => false,
    };
    if !is_one {
        report.add(role, wording::ROLE_FORM);
    }
    is_one
}
