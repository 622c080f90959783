//! How deep a text is nested. Parsers recurse; a text that is nested without bound would overflow their stack.

use ra_ap_parser::LexedStr;
use ra_ap_syntax::{Edition, SyntaxKind, T};

/// The deepest nesting of brackets, prefix operators and types that is read. Code that people write stays below 50.
const DEEPEST: usize = 128;
/// The most operators between two separators that are read: each makes the tree one level deeper.
const LONGEST: usize = 2000;

/// A bracket that is open.
#[derive(Default)]
struct Level {
    /// Tokens since the last separator that make a parser recurse.
    recursive: usize,
    /// All operators since the last separator.
    operators: usize,
}

/// Whether a parser may recurse too deeply.
pub(super) fn is_too_deep(text: &str) -> bool {
    let lexed = LexedStr::new(Edition::Edition2024, text);
    let kinds: Vec<SyntaxKind> =
        (0..lexed.len()).map(|index| lexed.kind(index)).filter(|kind| !kind.is_trivia()).collect();
    let mut levels = vec![Level::default()];
    let (mut recursive, mut operators) = (0, 0);
    for (index, kind) in kinds.iter().copied().enumerate() {
        let before = index.checked_sub(1).map(|before| kinds[before]);
        match kind {
            T!['('] | T!['['] | T!['{'] => levels.push(Level { recursive: 1, operators: 1 }),
            T![')'] | T![']'] | T!['}'] if levels.len() > 1 => {
                let closed = levels.pop().unwrap_or_default();
                recursive -= closed.recursive - 1;
                operators -= closed.operators - 1;
                recursive -= 1;
                operators -= 1;
                // `else` continues the chain of the `if` before it.
                if kind == T!['}'] && kinds.get(index + 1) != Some(&T![else]) {
                    clear(&mut levels, &mut recursive, &mut operators);
                }
                continue;
            }
            T![;] | T![,] => {
                clear(&mut levels, &mut recursive, &mut operators);
                continue;
            }
            _ => {
                let Some(top) = levels.last_mut() else { continue };
                if deepens(kind, before) {
                    top.recursive += 1;
                    recursive += 1;
                }
                if kind.is_punct() || kind.is_keyword(Edition::Edition2024) {
                    top.operators += 1;
                    operators += 1;
                }
            }
        }
        if matches!(kind, T!['('] | T!['['] | T!['{']) {
            recursive += 1;
            operators += 1;
        }
        if recursive > DEEPEST || operators > LONGEST {
            return true;
        }
    }
    false
}

/// Forgets the expression that a separator ends.
fn clear(levels: &mut [Level], recursive: &mut usize, operators: &mut usize) {
    let base = usize::from(levels.len() > 1);
    if let Some(top) = levels.last_mut() {
        *recursive -= top.recursive - base;
        *operators -= top.operators - base;
        *top = Level { recursive: base, operators: base };
    }
}

/// Whether a parser may recurse at the token.
fn deepens(kind: SyntaxKind, before: Option<SyntaxKind>) -> bool {
    let prefix = before.is_none_or(|before| {
        !matches!(before, SyntaxKind::IDENT | T![self] | T![')'] | T![']'] | T!['}'] | T![>]) && !before.is_literal()
    });
    match kind {
        T![!] | T![&] | T![*] | T![-] | T![|] | T![#] | T![.] => prefix,
        T![<]
        | T![=]
        | T![else]
        | T![return]
        | T![break]
        | T![move]
        | T![async]
        | T![unsafe]
        | T![const]
        | T![dyn]
        | T![impl]
        | T![for]
        | T![fn]
        | T![let]
        | T![if]
        | T![match]
        | T![while]
        | T![mut]
        | T![in] => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::is_too_deep;

    #[test]
    fn code_that_people_write_is_read_and_a_tower_is_not() {
        let long = "fn f() { g(1, -2, &&x); if a { b() } else if c { d() } }\n".repeat(1000);
        assert!(!is_too_deep(&long));
        for tower in ["(", "!", "&", "A<", "if a {} else ", "|x| ", "a = ", "-"] {
            assert!(!is_too_deep(&tower.repeat(20)), "{tower}");
            assert!(is_too_deep(&tower.repeat(10_000)), "{tower}");
        }
        assert!(is_too_deep(&"a + ".repeat(10_000)) && is_too_deep(&"a.b".repeat(10_000)));
    }

    #[test]
    fn closing_brackets_without_opening_ones_are_no_panic() {
        assert!(!is_too_deep(")}]};,)(};"));
    }
}
