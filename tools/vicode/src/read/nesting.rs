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
