//! Limit of nesting. Parsers recurse: a text with unbounded nesting would overflow their stack.

use super::lexed::{Kind, Token};

/// Deepest nesting of brackets, prefix operators and types that is read. Real code stays below 50.
const DEEPEST: usize = 128;
/// Number of operators between two separators that count as one nesting: each makes the syntax tree one level deeper.
const OPERATORS: usize = 16;
/// Tokens at which a parser always recurses.
const RECURSIVE: &str = "< = else return break move async unsafe const dyn impl for fn let if match while mut in";

/// Returns whether a parser may recurse too deeply.
pub(super) fn is_too_deep(tokens: &[Token<'_>]) -> bool {
    let tokens: Vec<&Token<'_>> = tokens.iter().filter(|token| !token.is_trivia()).collect();
    // Weight of the tokens since the last separator within each open bracket, including the bracket.
    let mut levels = vec![0];
    let mut sum = 0;
    for (index, token) in tokens.iter().enumerate() {
        let is_next = |text: &str| tokens.get(index + 1).is_some_and(|next| next.text == text);
        match token.text {
            "(" | "[" | "{" => levels.push(0),
            ")" | "]" | "}" if levels.len() > 1 => sum -= levels.pop().unwrap_or(0),
            _ => {}
        }
        let base = if levels.len() > 1 { OPERATORS } else { 0 };
        // `else` continues the chain of the `if` before it.
        let ends = matches!(token.text, ";" | ",") || token.text == "}" && !is_next("else");
        let before = index.checked_sub(1).map(|before| tokens[before]);
        if let Some(top) = levels.last_mut() {
            let old = *top;
            *top = if ends || old == 0 { base } else { old } + if ends { 0 } else { weight(token, before) };
            sum = sum + *top - old;
        }
        if sum > DEEPEST * OPERATORS {
            return true;
        }
    }
    false
}

fn is_recursive(token: &Token<'_>) -> bool {
    RECURSIVE.split(' ').any(|word| word == token.text)
}

/// Returns the weight of a token: by how much deeper a parser may recurse after it.
fn weight(token: &Token<'_>, before: Option<&Token<'_>>) -> usize {
    let ends_value = |before: &Token<'_>| match before.kind {
        Kind::Mark => matches!(before.text, ")" | "]" | "}" | ">"),
        _ => !is_recursive(before),
    };
    let is_prefix = "!&*-|#.".contains(token.text) && !before.is_some_and(ends_value);
    let is_operator = token.kind == Kind::Mark && !"()[]{}".contains(token.text);
    if is_recursive(token) || is_prefix { OPERATORS } else { usize::from(is_operator) }
}

#[cfg(test)]
mod tests {
    use super::super::lexed::lexed;

    fn is_too_deep(text: &str) -> bool {
        super::is_too_deep(&lexed(text))
    }

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
    fn deepest_text_is_read_in_the_stack_of_a_thread() {
        for tower in [
            "(",
            "!",
            "&",
            "A<",
            "if a {} else ",
            "|x| ",
            "a = ",
            "-",
            "[",
            "{",
            "m!(",
            "a + ",
            "a.b()",
            "impl A { fn f() {",
        ] {
            let counts: Vec<usize> = (0..3000).collect();
            let end = counts.partition_point(|count| !is_too_deep(&format!("fn f() {{ {}", tower.repeat(*count))));
            let deepest = format!("fn f() {{ {}", tower.repeat(end - 1));
            for text in [deepest.clone(), format!("{deepest} x"), deepest.replace("fn f() {", "type A = ")] {
                assert!(!crate::read(&text).problems.is_empty(), "{text}");
            }
        }
    }

    #[test]
    fn unmatched_closing_brackets_do_not_panic() {
        assert!(!is_too_deep(")}]};,)(};"));
    }
}
