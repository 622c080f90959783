//! Links as signatures write them.
//!
//! Two signatures can name one component by two paths. A macro reads only the paths, so it cannot recognise that; the
//! indices in a tree are equal.

use crate::graph::{Link, LinkKind, Roles};
use crate::text::Text;

/// One link as an argument writes it.
#[derive(Clone, Copy)]
pub struct WrittenLink {
    /// Index of the component in the tree.
    pub to: usize,
    /// The argument.
    pub kind: WrittenKind,
    /// Index of the state whose functions have the argument; `None` without states.
    pub state: Option<usize>,
    /// Index of the role that the argument names instead of a component.
    pub role: Option<usize>,
}

/// The argument that writes a link.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum WrittenKind {
    /// `&C`
    Read,
    /// `&mut C`
    Write,
    /// `&mut Rate<C>`
    Rate,
}

impl WrittenKind {
    /// Of links to one component the one with the lowest rank counts: what is written is visited after, also if it is
    /// read, and a rate adds nothing to another link.
    const fn rank(self) -> u8 {
        match self {
            Self::Write => 0,
            Self::Read => 1,
            Self::Rate => 2,
        }
    }
}

/// Whether the link at `index` of the component `own` is one of the graph, and not another path to the same child, nor
/// the rate of the component itself.
#[must_use]
pub const fn counts(links: &[WrittenLink], index: usize, own: usize) -> bool {
    let link = links[index];
    if link.to == own && matches!(link.kind, WrittenKind::Rate) {
        return false;
    }
    let mut at = 0;
    while at < links.len() {
        let other = links[at];
        let first = other.kind.rank() < link.kind.rank() || (other.kind.rank() == link.kind.rank() && at < index);
        if first && other.to == link.to && is_same_state(other.state, link.state) {
            return false;
        }
        at += 1;
    }
    true
}

const fn is_same_state(a: Option<usize>, b: Option<usize>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a == b,
        (None, None) => true,
        _ => false,
    }
}

/// The links of a node: at most `N`, each component once for each state.
pub struct DistinctLinks<const N: usize> {
    links: [Link; N],
    len: usize,
}

impl<const N: usize> DistinctLinks<N> {
    /// The links of the component `own` that count, in the order in which they are written.
    #[must_use]
    pub const fn of(written: &[WrittenLink], own: usize) -> Self {
        let none = Link { to: 0, kind: LinkKind::Requirement, state: None, roles: Roles::NONE };
        let mut distinct = Self { links: [none; N], len: 0 };
        let mut index = 0;
        while index < written.len() {
            if counts(written, index, own) {
                distinct.links[distinct.len] = link(written, index);
                distinct.len += 1;
            }
            index += 1;
        }
        distinct
    }

    /// The links.
    #[must_use]
    pub const fn as_slice(&self) -> &[Link] {
        self.links.split_at(self.len).0
    }
}

const fn link(all: &[WrittenLink], index: usize) -> Link {
    let written = all[index];
    let kind = match written.kind {
        WrittenKind::Read => LinkKind::Requirement,
        WrittenKind::Write | WrittenKind::Rate => LinkKind::Modulation,
    };
    Link { to: written.to, kind, state: written.state, roles: roles(all, written) }
}

/// The roles of all links to one component in one state.
const fn roles(all: &[WrittenLink], link: WrittenLink) -> Roles {
    let (mut roles, mut at) = (Roles::NONE, 0);
    while at < all.len() {
        if let Some(role) = all[at].role
            && all[at].to == link.to
            && is_same_state(all[at].state, link.state)
        {
            roles = roles.with(role);
        }
        at += 1;
    }
    roles
}

/// What an argument borrows, in one tree.
#[derive(Clone, Copy)]
pub struct Target {
    /// Index of the component.
    pub to: usize,
    /// The argument.
    pub kind: WrittenKind,
    /// Whether the argument names a role.
    pub by_role: bool,
    /// The component or role as in the argument.
    pub name: &'static str,
}

/// Stops the compiler if an earlier argument of the signature borrows what the one at `index` borrows. Both may read, if one of them
/// names a role.
///
/// # Panics
/// If it does.
#[track_caller]
pub const fn assert_single_link(targets: &[Target], index: usize) {
    let (target, mut at) = (targets[index], 0);
    while at < index {
        let earlier = targets[at];
        let is_one = earlier.to == target.to && is_rate(earlier) == is_rate(target);
        let by_role = earlier.by_role || target.by_role;
        if is_one && !(by_role && is_read(earlier) && is_read(target)) {
            let mut text = Text::<512>::new();
            if by_role {
                text.push("`");
                text.push(earlier.name);
                text.push("` and `");
                text.push(target.name);
                text.push("` are one component in this tree, and one signature cannot write it and use it twice: keep one argument, ");
                text.push("or give them two components in `roles`");
            } else {
                text.push("two links to one component in one signature: an earlier argument is `");
                text.push(target.name);
                text.push("` by another path; keep one, `&mut` can also read");
            }
            panic!("{}", text.as_str());
        }
        at += 1;
    }
}

const fn is_rate(target: Target) -> bool {
    matches!(target.kind, WrittenKind::Rate)
}

const fn is_read(target: Target) -> bool {
    matches!(target.kind, WrittenKind::Read)
}
