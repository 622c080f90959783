//! Symbolic expressions: atoms, separated by spaces, and lists in parentheses.

use super::error::Error;

/// Maximum depth of nested lists. The scene of a monitor has a depth of about 30.
const DEEPEST: usize = 64;

/// An atom or a list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expression<'a> {
    Atom(&'a str),
    List(Vec<Self>),
}

impl<'a> Expression<'a> {
    /// Parses all expressions of a message.
    ///
    /// # Errors
    /// If a parenthesis has no partner, or lists are nested too deeply.
    pub(crate) fn parse(message: &'a str) -> Result<Vec<Self>, Error> {
        let mut open = vec![Vec::new()];
        let mut rest = message;
        while let Some(first) = rest.chars().next() {
            let length = match first {
                '(' if open.len() > DEEPEST => return Err(Error::Message("its lists are too deep within each other")),
                '(' => {
                    open.push(Vec::new());
                    1
                }
                ')' => {
                    let list = open.pop().unwrap_or_default();
                    let Some(outer) = open.last_mut() else { return Err(Error::Message("a `)` has no `(`")) };
                    outer.push(Self::List(list));
                    1
                }
                _ if first.is_whitespace() => first.len_utf8(),
                _ => {
                    let end = rest.find([' ', '(', ')']).unwrap_or(rest.len());
                    let atom = Self::Atom(&rest[..end]);
                    open.last_mut().ok_or(Error::Message("a `)` has no `(`"))?.push(atom);
                    end
                }
            };
            rest = &rest[length..];
        }
        let all = open.pop().unwrap_or_default();
        if open.is_empty() { Ok(all) } else { Err(Error::Message("a `(` has no `)`")) }
    }

    /// Returns the atom at the head of a list and the rest; `None` for an atom, and for a list without such a head.
    pub(crate) fn call(&self) -> Option<(&'a str, &[Self])> {
        match self {
            Self::List(list) => match list.split_first() {
                Some((&Self::Atom(name), rest)) => Some((name, rest)),
                _ => None,
            },
            Self::Atom(_) => None,
        }
    }

    /// Returns the text of an atom.
    pub(crate) const fn atom(&self) -> Option<&'a str> {
        if let Self::Atom(text) = self { Some(text) } else { None }
    }

    /// Returns the number in an atom, if it is finite.
    pub(crate) fn number(&self) -> Option<f32> {
        self.atom()?.parse().ok().filter(|number: &f32| number.is_finite())
    }
}

/// Returns the arguments of the first list with this head.
pub(crate) fn find<'a, 'b>(expressions: &'b [Expression<'a>], name: &str) -> Option<&'b [Expression<'a>]> {
    expressions.iter().filter_map(Expression::call).find_map(|(head, rest)| (head == name).then_some(rest))
}

/// Returns the first `N` finite numbers; `None` if there are fewer.
pub(crate) fn numbers<const N: usize>(expressions: &[Expression<'_>]) -> Option<[f32; N]> {
    let numbers: Vec<f32> = expressions.iter().map_while(Expression::number).take(N).collect();
    numbers.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_and_atoms_are_read() {
        let read = Expression::parse("(time (now 7.13))(See )x (P(id -2))").expect("well-formed");
        assert_eq!(read.len(), 4);
        assert_eq!(find(&read, "time").and_then(|time| numbers(find(time, "now")?)), Some([7.13]));
        assert_eq!(find(&read, "See"), Some(&[][..]));
        assert_eq!(find(&read, "P").and_then(|player| numbers(find(player, "id")?)), Some([-2.0]));
        assert_eq!((read[2].atom(), read[2].number()), (Some("x"), None));
    }

    #[test]
    fn malformed_messages_are_refused() {
        let deep = "(".repeat(100_000);
        for message in ["(", ")", "(a))(", &deep] {
            assert!(matches!(Expression::parse(message), Err(Error::Message(_))), "{}", &message[..1]);
        }
    }

    #[test]
    fn numbers_that_are_missing_or_not_finite_are_none() {
        let read = Expression::parse("(a 1 nan)(b 1)").expect("well-formed");
        for name in ["a", "b"] {
            assert_eq!(find(&read, name).and_then(numbers::<2>), None, "{name}");
        }
    }
}
