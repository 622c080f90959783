//! How deep a text is nested. Parsers recurse; a text that is nested without bound would overflow their stack.

use ra_ap_parser::LexedStr;
use ra_ap_syntax::{Edition, SyntaxKind, T};

/// The deepest nesting of brackets, prefix operators and types that is read. Code that people write stays below 50.
const DEEPEST: usize = 128;
/// The most operators between two separators that are read: each makes the tree one level deeper.
const LONGEST: usize = 2000;
/// Tokens at which a parser recurses wherever they stand.
const RECURSIVE: &str = "< = else return break move async unsafe const dyn impl for fn let if match while mut in";

/// What makes a parser recurse since the last separator within a bracket, the bracket included.
#[derive(Default)]
struct Level {
    recursive: usize,
    operators: usize,
}

/// Whether a parser may recurse too deeply.
pub(super) fn is_too_deep(text: &str) -> bool {
    let lexed = LexedStr::new(Edition::Edition2024, text);
    let tokens = (0..lexed.len()).map(|index| (lexed.kind(index), lexed.text(index)));
    let tokens: Vec<(SyntaxKind, &str)> = tokens.filter(|(kind, _)| !kind.is_trivia()).collect();
    let mut levels = vec![Level::default()];
    for (index, (kind, text)) in tokens.iter().copied().enumerate() {
        let outermost = levels.len() == 1;
        let ends = match kind {
            T!['('] | T!['['] | T!['{'] => {
                levels.push(Level { recursive: 1, operators: 1 });
                false
            }
            T![')'] | T![']'] | T!['}'] if !outermost => {
                levels.pop();
                // `else` continues the chain of the `if` before it.
                kind == T!['}'] && tokens.get(index + 1).is_none_or(|(next, _)| *next != T![else])
            }
            kind => matches!(kind, T![;] | T![,]),
        };
        let base = usize::from(levels.len() > 1);
        if let Some(top) = levels.last_mut() {
            if ends {
                *top = Level { recursive: base, operators: base };
            } else {
                let before = index.checked_sub(1).map(|before| tokens[before].0);
                top.recursive += usize::from(deepens(kind, text, before));
                top.operators += usize::from(is_operator(kind));
            }
        }
        let sum = |of: fn(&Level) -> usize| levels.iter().map(of).sum::<usize>();
        if sum(|level| level.recursive) > DEEPEST || sum(|level| level.operators) > LONGEST {
            return true;
        }
    }
    false
}

fn is_operator(kind: SyntaxKind) -> bool {
    let is_bracket = matches!(kind, T!['('] | T!['['] | T!['{'] | T![')'] | T![']'] | T!['}']);
    !is_bracket && (kind.is_punct() || kind.is_keyword(Edition::Edition2024))
}

/// Whether a parser may recurse at the token.
fn deepens(kind: SyntaxKind, text: &str, before: Option<SyntaxKind>) -> bool {
    let ends_value = |before: SyntaxKind| {
        matches!(before, SyntaxKind::IDENT | T![self] | T![')'] | T![']'] | T!['}'] | T![>]) || before.is_literal()
    };
    RECURSIVE.split(' ').any(|word| word == text)
        || matches!(kind, T![!] | T![&] | T![*] | T![-] | T![|] | T![#] | T![.]) && !before.is_some_and(ends_value)
}

#[cfg(test)]
mod tests {
    use super::is_too_deep;

    #[test]
    fn only_towers_are_too_deep() {
        let long = "fn f() { g(1, -2, &&x); if a { b() } else if c { d() } }\n".repeat(1000);
        assert!(!is_too_deep(&long));
        for tower in ["(", "!", "&", "A<", "if a {} else ", "|x| ", "a = ", "-"] {
            assert!(!is_too_deep(&tower.repeat(20)), "{tower}");
            assert!(is_too_deep(&tower.repeat(10_000)), "{tower}");
        }
        assert!(is_too_deep(&"a + ".repeat(10_000)) && is_too_deep(&"a.b".repeat(10_000)));
    }

    #[test]
    fn unmatched_closing_brackets_do_not_panic() {
        assert!(!is_too_deep(")}]};,)(};"));
    }
}
