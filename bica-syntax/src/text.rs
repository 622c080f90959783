//! Names, types and doc comments as text.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::{Attribute, Expr, ExprLit, Lit, Meta};

/// The tokens as one writes them: `Eye<320, 240>`.
pub fn written(tokens: &impl ToTokens) -> String {
    let mut text = tokens.to_token_stream().to_string();
    for (spaced, tight) in [
        (" :: ", "::"),
        (":: ", "::"),
        (" < ", "<"),
        ("< ", "<"),
        (" >", ">"),
        (" ,", ","),
        ("& ", "&"),
        ("* ", "*"),
        (" ;", ";"),
    ] {
        text = text.replace(spaced, tight);
    }
    text
}

/// The name without the `r#` of a raw identifier.
#[must_use]
pub fn name(ident: &Ident) -> String {
    ident.unraw().to_string()
}

/// The doc comment, lines trimmed and joined by line breaks.
#[must_use]
pub fn doc(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(line), .. }) => Some(line.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    });
    lines.collect::<Vec<_>>().join("\n").trim().to_owned()
}

/// The name nearest to `wrong`, if at most a third of its letters differ.
pub fn nearest<'a>(wrong: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    names
        .map(|name| (distance(&wrong.to_lowercase(), &name.to_lowercase()), name))
        .filter(|(distance, name)| *distance <= (name.chars().count().max(wrong.chars().count()) / 3).max(1))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

/// Number of letters that must be changed, added, left out, or swapped with their neighbour (optimal string alignment).
#[must_use]
pub fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 { i + j } else { fewest(&rows, &a, &b, i, j) };
        }
    }
    rows[a.len()][b.len()]
}

fn fewest(rows: &[Vec<usize>], a: &[char], b: &[char], i: usize, j: usize) -> usize {
    let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
    let fewest = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
    let swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
    if swapped { fewest.min(rows[i - 2][j - 2] + 1) } else { fewest }
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;

    #[test]
    fn types_are_written_as_one_writes_them() {
        assert_eq!(written(&quote!(Eye<320, 240>)), "Eye<320, 240>");
        assert_eq!(written(&quote!(a::b::C)), "a::b::C");
        assert_eq!(written(&quote!(Map<Grid<4>, f32>)), "Map<Grid<4>, f32>");
        assert_eq!(written(&quote!(&mut Head)), "&mut Head");
        assert_eq!(written(&quote!([f32; 4])), "[f32; 4]");
    }

    #[test]
    fn the_nearest_name_is_the_one_that_was_meant() {
        let names = || ["look_for_ball", "approach_ball", "kick"].into_iter();
        assert_eq!(nearest("aproach_ball", names()), Some("approach_ball"));
        assert_eq!(nearest("kik", names()), Some("kick"));
        assert_eq!(nearest("kikc", names()), Some("kick"));
        assert_eq!(nearest("zzzzzzzz", names()), None);
        assert_eq!(nearest("rate", ["hz", "budget_us"].into_iter()), None);
    }

    #[test]
    fn the_distance_is_the_number_of_changes() {
        for (a, b, changes) in
            [("", "abc", 3), ("abc", "abc", 0), ("kitten", "sitting", 3), ("flaw", "lawn", 2), ("setp", "step", 1)]
        {
            assert_eq!((distance(a, b), distance(b, a)), (changes, changes));
        }
    }
}
