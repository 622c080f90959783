//! A function of a random component: its links, and the text of its arguments.

use super::random::Random;

/// How a function takes a child.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Read,
    Write,
}

/// Argument that is a link.
#[derive(Clone, Copy)]
pub(super) struct Link {
    pub(super) child: usize,
    pub(super) kind: Kind,
    /// Whether the child is named by its role.
    pub(super) by_role: bool,
}

/// Links of a function, each child once.
#[derive(Clone, Default)]
pub(super) struct Function(pub(super) Vec<Link>);

impl Function {
    /// Takes some of the children; of a condition only to read them.
    pub(super) fn random(children: &[usize], percent: usize, reads: bool, random: &mut Random) -> Self {
        let mut function = Self::default();
        for &child in children {
            if random.chance(percent) {
                function.add(child, reads, random);
            }
        }
        function
    }

    /// Takes a child, unless it does so already.
    pub(super) fn add(&mut self, child: usize, reads: bool, random: &mut Random) {
        if self.0.iter().all(|link| link.child != child) {
            let kind = if reads || random.chance(50) { Kind::Read } else { Kind::Write };
            self.0.push(Link { child, kind, by_role: random.chance(30) });
        }
    }

    pub(super) fn names(&self, child: usize) -> bool {
        self.0.iter().any(|link| link.child == child && !link.by_role)
    }

    /// The arguments after `self`, each with a comma before it.
    pub(super) fn arguments(&self) -> String {
        let argument = |link: &Link| {
            let (child, mutable) = (link.child, if link.kind == Kind::Write { "mut " } else { "" });
            let kind = if link.by_role { format!("impl R{child}") } else { format!("C{child}") };
            format!(", c{child}: &{mutable}{kind}")
        };
        self.0.iter().map(argument).collect()
    }

    /// The values that it reads, and after them what it writes, as two arrays.
    pub(super) fn reads_and_writes(&self) -> String {
        let written = self.of(Kind::Write, |link| {
            let child = link.child;
            if link.by_role { format!("c{child}.moved()") } else { format!("&mut c{child}.unit") }
        });
        format!("{}, [{written}]", self.reads())
    }

    /// The values that it reads, as an array.
    pub(super) fn reads(&self) -> String {
        let read = self.of(Kind::Read, |link| {
            let (child, unit) = (link.child, if link.by_role { "seen()" } else { "unit" });
            format!("c{child}.{unit}.read()")
        });
        format!("[{read}]")
    }

    fn of(&self, kind: Kind, text: impl Fn(&Link) -> String) -> String {
        let some: Vec<_> = self.0.iter().filter(|link| link.kind == kind).map(text).collect();
        some.join(", ")
    }
}
