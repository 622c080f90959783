//! Types as written.

use syn::{GenericArgument, Lifetime, PathArguments, Type};

/// The type without parentheses and without the invisible brackets that a `macro_rules` macro puts around it.
pub(crate) fn plain(mut kind: &Type) -> &Type {
    loop {
        kind = match kind {
            Type::Group(group) => &group.elem,
            Type::Paren(paren) => &paren.elem,
            other => return other,
        }
    }
}

/// The argument of a generic type that has no size, if there is one.
pub(crate) fn unsized_argument(kind: &Type) -> Option<&GenericArgument> {
    let Type::Path(path) = plain(kind) else { return None };
    let PathArguments::AngleBracketed(list) = &path.path.segments.last()?.arguments else { return None };
    list.args.iter().find(|argument| is_unsized(argument))
}

/// Whether the argument of a generic type is written as a type without a size.
pub(crate) fn is_unsized(argument: &GenericArgument) -> bool {
    let GenericArgument::Type(of) = argument else { return false };
    match plain(of) {
        Type::Slice(_) | Type::TraitObject(_) => true,
        Type::Path(path) => path.path.segments.last().is_some_and(|last| last.ident == "str"),
        _ => false,
    }
}

/// The lifetimes in the angle brackets of a type.
pub(crate) fn lifetimes(own: &Type) -> impl Iterator<Item = &Lifetime> {
    let last = if let Type::Path(path) = own { path.path.segments.last() } else { None };
    let arguments = last.and_then(|last| match &last.arguments {
        PathArguments::AngleBracketed(list) => Some(&list.args),
        _ => None,
    });
    arguments.into_iter().flatten().filter_map(|argument| match argument {
        GenericArgument::Lifetime(lifetime) => Some(lifetime),
        _ => None,
    })
}
