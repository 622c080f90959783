//! Arguments in the code after a mistake: written so that the compiler does not report it again.

use syn::{FnArg, GenericArgument, PathArguments, Signature, Type, parse_quote};

use crate::types::is_unsized;

/// Completes a `Rate`, `Age`, `Outcome`, `Tuned` or `Found` without a type, and replaces one without a size or several, which are reported,
/// so that the compiler does not report it again.
pub(crate) fn complete_rates(signature: &mut Signature) {
    for input in &mut signature.inputs {
        let FnArg::Typed(input) = input else { continue };
        borrow(&mut input.ty);
        let kind = match &mut *input.ty {
            Type::Reference(reference) => &mut *reference.elem,
            kind => kind,
        };
        let Type::Path(path) = kind else { continue };
        let Some(last) = path.path.segments.last_mut() else { continue };
        if let PathArguments::AngleBracketed(list) = &mut last.arguments {
            // Only the rate of a component can be set.
            let is_component = |one: &GenericArgument| matches!(one, GenericArgument::Type(Type::Path(_)));
            if last.ident == "Rate" {
                list.args.iter_mut().filter(|one| !is_component(one)).for_each(|one| *one = parse_quote!(Self));
            }
            list.args.iter_mut().filter(|one| is_unsized(one)).for_each(|one| *one = parse_quote!(()));
            if last.ident == "Found" {
                list.args = list.args.iter().take(1).cloned().collect();
            }
        }
        if ["Rate", "Age", "Outcome", "Tuned", "Found", "Work"].iter().any(|name| last.ident == name)
            && last.arguments.is_none()
        {
            last.arguments = PathArguments::AngleBracketed(parse_quote!(<Self>));
        }
    }
}

/// Borrows mutably a rate, and a role that is taken by value: its methods are then no second mistake.
fn borrow(kind: &mut Type) {
    let is_rate = |one: &Type| match one {
        Type::Path(path) => path.path.segments.last().is_some_and(|last| last.ident == "Rate"),
        _ => false,
    };
    match kind {
        Type::Reference(reference) if is_rate(&reference.elem) => {
            reference.mutability = Some(syn::token::Mut::default());
        }
        other if is_rate(other) || matches!(other, Type::ImplTrait(_)) => *other = parse_quote!(&mut #other),
        _ => {}
    }
}
