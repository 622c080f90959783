//! Types as written.

use syn::Type;

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
