//! The commas of lists.

use syn::Token;
use syn::parse::ParseStream;

use crate::wording;

/// Reads the comma behind an entry, unless the list ends.
pub(crate) fn comma(input: ParseStream) -> syn::Result<()> {
    if input.is_empty() {
        return Ok(());
    }
    let problem = if input.peek(Token![;]) { wording::NO_SEMICOLON } else { wording::COMMA };
    input.parse::<Token![,]>().map(|_| ()).map_err(|found| syn::Error::new(found.span(), problem))
}
