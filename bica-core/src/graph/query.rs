//! What a component asks about others without activating them.

/// A question of a component about another one: an argument `&Age<C>` or `&Outcome<C>`. It is no link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize))]
pub struct Query {
    /// Index of the other component in [`Graph::nodes`](super::Graph::nodes).
    pub of: usize,
    /// What is asked.
    pub kind: QueryKind,
}

/// What a component asks about another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "wire",
    derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema),
    serde(rename_all = "snake_case")
)]
pub enum QueryKind {
    /// The time since it ran last: `&Age<C>`.
    Age,
    /// The result with which it ended: `&Outcome<C>` of a transition.
    Outcome,
}

impl QueryKind {
    /// The word in drawings: `"age"` or `"outcome"`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Age => "age",
            Self::Outcome => "outcome",
        }
    }
}

/// The queries of a component, in the order of the text. With the feature `terse` there are none, and they take no memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Queries {
    #[cfg(not(feature = "terse"))]
    listed: &'static [Query],
}

impl Queries {
    /// Creates a list, in which a query may stand several times.
    #[must_use]
    #[cfg_attr(feature = "terse", expect(unused_variables, reason = "nobody reads it"))]
    pub const fn new(listed: &'static [Query]) -> Self {
        Self {
            #[cfg(not(feature = "terse"))]
            listed,
        }
    }

    /// Returns each query once.
    pub fn distinct(self) -> impl Iterator<Item = Query> {
        #[cfg(not(feature = "terse"))]
        let listed = self.listed;
        #[cfg(feature = "terse")]
        let listed: &[Query] = &[];
        listed.iter().enumerate().filter(|(index, query)| !listed[..*index].contains(query)).map(|(_, query)| *query)
    }
}
