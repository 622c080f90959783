//! Overruling the tree from outside.

/// Who decides whether a component is active.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// The tree: it is active while an activator needs it.
    #[default]
    Tree,
    /// It is active, needed or not. One that the tree does not reach is visited after the root, activators first.
    Active,
    /// It is latent, needed or not. A visit ends there: its children are not visited through it, and who reads it reads
    /// what it last said.
    Latent,
}
